// Numbers as people read them. Commas group thousands, a narrow no-break space joins a unit; a true minus sign leads.

const kThin = "\u202f"; // narrow no-break space
const kMinus = "\u2212";

/** Significant digits, thousands grouped; powers of ten outside 1e-4 .. 1e7. "none" for null, NaN and infinity. */
export function number(value, digits = 3) {
    if (value === null || value === undefined || !Number.isFinite(value)) {
        return "none";
    }
    if (value === 0) {
        return "0";
    }
    const sign = value < 0 ? kMinus : "";
    const size = Math.abs(value);
    if (size < 0.999e-4 || size >= 1e7) {
        const [mantissa, exponent] = size.toExponential(digits - 1).split("e");
        return `${sign}${trimZeros(mantissa)}\u00b710${superscript(Number(exponent))}`;
    }
    const decimals = Math.min(12, Math.max(0, digits - 1 - Math.floor(Math.log10(size))));
    return sign + trimZeros(fixed(size, decimals));
}

/** A fixed number of decimals, thousands grouped. */
export function fixed(value, decimals) {
    if (!Number.isFinite(value)) {
        return "none";
    }
    const [whole, fraction] = Math.abs(value).toFixed(decimals).split(".");
    const grouped = whole.replace(/\B(?=(\d{3})+$)/g, ",");
    const text = fraction ? `${grouped}.${fraction}` : grouped;
    return value < 0 && /[1-9]/.test(text) ? kMinus + text : text;
}

/** A share of 1 as percent. */
export function percent(share, digits = 3) {
    return Number.isFinite(share) ? `${number(100 * share, digits)}${kThin}%` : "none";
}

/** A sentence of the program whose lengths, its only numbers with a point or an exponent, become numbers with units. */
export function withUnits(sentence) {
    return sentence.replace(/\d+\.\d+(e[+-]\d+)?|\d+e[+-]\d+/g, (text) => `${number(Number(text), 4)} units`);
}

/** A difference already in percent, its sign always there. */
export function signedPercent(value, decimals = 1) {
    if (!Number.isFinite(value)) {
        return "none";
    }
    const text = fixed(value, decimals);
    return `${text.startsWith(kMinus) ? "" : "+"}${text}${kThin}%`;
}

/** A probability. */
export function probability(p) {
    return Number.isFinite(p) ? number(p, 3) : "none";
}

/** Seconds as people say them. */
export function duration(seconds) {
    if (seconds < 0.1) {
        return `under 0.1${kThin}s`;
    }
    if (seconds < 60) {
        return `${number(seconds, 2)}${kThin}s`;
    }
    const minutes = Math.floor(Math.round(seconds) / 60);
    return minutes < 60
        ? `${minutes}${kThin}min ${Math.round(seconds) % 60}${kThin}s`
        : `${Math.floor(minutes / 60)}${kThin}h ${minutes % 60}${kThin}min`;
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
