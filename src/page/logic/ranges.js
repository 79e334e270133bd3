// Ranges of an axis, linear or logarithmic.

const identity = (x) => x;
const scaleOf = (log) => (log ? [Math.log10, (x) => 10 ** x] : [identity, identity]);

/** A range `factor` times as wide that keeps `center` where it is on the screen; the middle when that is null. */
export function around([low, high], factor, center, log) {
    const [to, from] = scaleOf(log);
    const [a, b] = [to(low), to(high)];
    const c = center === null ? (a + b) / 2 : to(center);
    return [from(c - (c - a) * factor), from(c + (b - c) * factor)];
}

/** The range moved, no wider, so that `value` is in its middle. */
export function panned([low, high], value, log) {
    const [to, from] = scaleOf(log);
    const half = (to(high) - to(low)) / 2;
    return [from(to(value) - half), from(to(value) + half)];
}

/** Whether a range holds all values that the axis can show. */
export function holds([low, high], values, log) {
    return values.every((value) => !Number.isFinite(value) || (log && value <= 0) || (value >= low && value <= high));
}
