// The statistics of the two-alternative forced choice: chi-squared of the thesis (section 6.1.5), and the exact binomial
// test. The approximation of chi-squared is poor for twelve answers. Medians of measured times.

/** Chi-squared of two counts against equal expectation, one degree of freedom. NaN without any answer. */
export function chiSquared(a, b) {
    return (a - b) ** 2 / (a + b);
}

/** Chance of a chi-squared of one degree of freedom at or above `x`. */
export function chiSquaredP(x) {
    return erfc(Math.sqrt(x / 2));
}

/** Two-sided exact p of `a` against `b` answers when both are equally likely. NaN without any answer. */
export function binomialP(a, b) {
    const n = a + b;
    if (n === 0) {
        return NaN;
    }
    let halvings = n; // that are still to be done: 2^-n at once is 0 beyond 1074 answers
    let term = 1; // of the next outcome, C(n, i) / 2^n but for these halvings
    let tail = 0;
    for (let i = 0; i <= Math.min(a, b); ++i) {
        tail += term;
        term *= (n - i) / (i + 1);
        for (; term > 1 && halvings > 0; --halvings) {
            term /= 2;
            tail /= 2;
        }
    }
    return Math.min(1, 2 * tail * 0.5 ** halvings);
}

/** The middle one of values in order, of two the mean. NaN without any. */
export function median(values) {
    const ordered = [...values].sort((a, b) => a - b);
    const middle = ordered.length / 2;
    return Number.isInteger(middle) ? (ordered[middle - 1] + ordered[middle]) / 2 : ordered[Math.floor(middle)];
}

/** Complementary error function for x >= 0: series near 0, continued fraction (Lentz) beyond. */
function erfc(x) {
    const square = x * x;
    const scale = Math.exp(-square) / Math.sqrt(Math.PI);
    if (x < 2) {
        let term = 2 * x;
        let sum = term;
        for (let n = 1; Math.abs(term) > 1e-17 * sum; ++n) {
            term *= square / (n + 0.5);
            sum += term;
        }
        return 1 - scale * sum;
    }
    let fraction = x;
    for (let n = 60; n > 0; --n) {
        fraction = x + n / 2 / fraction;
    }
    return scale / fraction;
}
