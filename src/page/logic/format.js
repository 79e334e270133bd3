// Numbers as people read them, by the rules of src/cdr/base/quantity_text.h: the cases in tests/base/quantities.json hold
// for both. Commas group thousands, a no-break space joins a unit, a true minus sign leads.

const kSpace = "\u00a0";
const kMinus = "\u2212";
const kLargestExponent = 7; // from here on, and below the other, a power of ten is written
const kSmallestExponent = -4;

/** So many significant digits, but all whole ones, and no zeros at the end. "none" for null and NaN. */
export function number(value, digits = 4) {
    if (value === null || value === undefined || Number.isNaN(value)) {
        return "none";
    }
    const sign = value < 0 ? kMinus : "";
    if (!Number.isFinite(value)) {
        return `${sign}infinite`;
    }
    if (value === 0) {
        return "0";
    }
    const { kept, exponent } = readable(Math.abs(value), digits);
    if (exponent < kSmallestExponent || exponent >= kLargestExponent) {
        const [mantissa] = Math.abs(value).toExponential(kept - 1).split("e");
        return `${sign}${trimZeros(mantissa)}\u00b710${superscript(exponent)}`;
    }
    const [whole, fraction] = trimZeros(Math.abs(value).toFixed(Math.max(0, kept - 1 - exponent))).split(".");
    return sign + whole.replace(/\B(?=(\d{3})+$)/g, ",") + (fraction ? `.${fraction}` : "");
}

/** How many digits are shown, and the power of ten of the first of them once rounded. */
function readable(size, digits) {
    const exponentOf = (kept) => Number(size.toExponential(kept - 1).split("e")[1]);
    const whole = exponentOf(kExactDigits);
    const kept = Math.max(1, digits, whole < kLargestExponent ? whole + 1 : 0);
    return { kept, exponent: exponentOf(kept) };
}

const kExactDigits = 41;
const kSignedDigits = 3; // what is measured over something else is never known better
const kUnits = [[1e-6, "\u00b5m", "um"], [1e-3, "mm", "mm"], [1, "m", "m"], [1e3, "km", "km"], [1e9, `million${kSpace}km`]];

/** What a length may be written in, in the order of a choice. */
export const lengthUnits = ["none", "auto", ...kUnits.map(([, , name]) => name).filter(Boolean)];

/** A length in a unit of `lengthUnits`; one is a metre by convention. "auto" is the largest unit that it fills. */
export function lengthIn(metres, unit, digits = 4) {
    if (unit === "none" || metres === null || !Number.isFinite(metres)) {
        return number(metres, digits);
    }
    const fills = ([size]) => readable(Math.abs(metres) / size, digits).exponent >= 0;
    const [size, name] = unit !== "auto" ? kUnits.find((each) => each[2] === unit)
        : metres === 0 ? kUnits[2] : (kUnits.filter(fills).pop() ?? kUnits[0]);
    return `${number(metres / size, digits)}${kSpace}${name}`;
}

/** A share of 1 as percent. */
export function percent(share, digits = 4) {
    return Number.isFinite(share) ? `${number(100 * share, digits)}${kSpace}%` : "none";
}

/** A difference already in percent, its sign always there. */
export function signedPercent(value) {
    return Number.isFinite(value) ? `${value > 0 ? "+" : ""}${number(value, kSignedDigits)}${kSpace}%` : "none";
}

/** Seconds as people say them. */
export function duration(seconds) {
    if (seconds < 0.1) {
        return `under 0.1${kSpace}s`;
    }
    if (seconds < 60) {
        return `${number(seconds, 2)}${kSpace}s`;
    }
    const minutes = Math.floor(Math.round(seconds) / 60);
    return minutes < 60
        ? `${minutes}${kSpace}min ${Math.round(seconds) % 60}${kSpace}s`
        : `${Math.floor(minutes / 60)}${kSpace}h ${minutes % 60}${kSpace}min`;
}

/** "a, b and c". */
export function list(items) {
    return items.length < 2 ? items.join("") : `${items.slice(0, -1).join(", ")} and ${items.at(-1)}`;
}

/** 10 to a whole power, for axes: plain from 0.001 to 1000. */
export function powerOfTen(value) {
    const exponent = Math.round(Math.log10(value));
    return exponent >= -3 && exponent <= 3 ? String(Number(value.toPrecision(1))) : `10${superscript(exponent)}`;
}

function superscript(exponent) {
    return String(exponent).replace(/[-\d]/g, (c) => (c === "-" ? "\u207b" : "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[c]));
}

function trimZeros(text) {
    return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}
