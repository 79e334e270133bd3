// Section 6.1 from the JSON of `cdr flicker`: what was counted, and whom an ideal observer agrees with.

import { pairs } from "./thesis.js";
import { binomialP, chiSquared, chiSquaredP } from "./statistics.js";

/** The techniques' results over the afc scene, without those that move cdr's boundary. */
export function techniques(document) {
    return document.results.filter((row) => !isMovedBoundary(row));
}

/** cdr with its boundary moved off the field, if it was measured. */
export function movedBoundaries(document) {
    return document.results.filter(isMovedBoundary);
}

/** The thesis' six pairs: people's choice, the observer's, and the statistics of Table 6.9. */
export function pairRows(document) {
    const rows = new Map(techniques(document).map((row) => [row.technique, row]));
    return pairs.map((pair) => {
        const sides = [rows.get(pair.left), rows.get(pair.right)];
        const flips = sides.map((row) => row?.flips ?? null);
        const couldJudge = sides.every((row) => row && row.compared !== 0); // of no pixels nothing can be said
        const people = pair.chosen[0] > pair.chosen[1] ? pair.left : pair.right;
        const x = chiSquared(...pair.chosen);
        let observer = null; // a tie, or nothing to judge by
        if (couldJudge && flips[0] !== flips[1]) {
            observer = flips[0] < flips[1] ? pair.left : pair.right;
        }
        return {
            ...pair,
            flips,
            couldJudge,
            people,
            observer,
            agree: observer === people,
            recomputed: x,
            chiSquaredP: chiSquaredP(x),
            exactP: binomialP(...pair.chosen),
        };
    });
}

/** How often an ideal observer would choose each technique over the pairs where it has a choice: Table 6.2. */
export function observerWins(document) {
    const wins = {};
    for (const row of pairRows(document)) {
        wins[row.left] ??= 0;
        wins[row.right] ??= 0;
        if (row.observer) {
            wins[row.observer] += 1;
        }
    }
    return wins;
}

function isMovedBoundary(row) {
    return row.technique.startsWith("cdr-");
}
