// Chapter 7 calls the formulas of chapter 4 "not reliable in practice": measured beside predicted, from `cdr probe`.

import { listingSeparation } from "./listing_a2.js";

const kRungs = 256; // pairs of the ladder, in equal ratios
const kNear = 0.001; // of the probe's camera, whose far plane is twice the distance

/** Series over distance of one depth format: what was measured, and what was predicted, per technique. */
export function series(document, format) {
    const rows = document.results.filter((row) => row.format === format);
    const x = [...new Set(rows.map((row) => row.distance))].sort((a, b) => a - b);
    const techniques = [...new Set(rows.map((row) => row.technique))];
    const valuesOf = (technique, field) => x.map((distance) =>
        rows.find((row) => row.technique === technique && row.distance === distance)?.[field] ?? null);
    return {
        x,
        measured: techniques.map((name) => ({ name, values: valuesOf(name, "resolved") })),
        predicted: techniques.map((name) => ({ name, values: valuesOf(name, "predicted") })),
    };
}

/** Depth formats in the order of the document. */
export function formats(document) {
    return [...new Set(document.results.map((row) => row.format))];
}

/**
 * How well the thesis' own formulas (Listing A.2) hold. Counts the D24 cases that need a coarser separation than the formula
 * says, by more than a step of the ladder. Cases that no separation resolves do not count.
 */
export function listingReliability(document) {
    const cases = document.results.filter((row) => row.format === "d24" && row.resolved !== null)
        .map((row) => ({ row, formula: listingSeparation(row.technique, row.distance, { near: kNear, far: 2 * row.distance }) }))
        .filter(({ formula }) => formula !== null);
    const coarser = cases.filter(({ row, formula }) => row.resolved > formula * rungOf(row));
    return {
        all: cases.length,
        coarser: coarser.length,
        worstRatio: Math.max(0, ...coarser.map(({ row, formula }) => row.resolved / formula)),
    };
}

/**
 * How well our forecast holds where a separation is resolved. A value at the ladder's smallest rung says only "this or
 * finer", so it is judged by whether the forecast lies there too. Counted apart: where none is resolved although the
 * forecast says so by more than a factor of two.
 */
export function reliability(document) {
    const told = document.results.filter(isTold);
    const ratios = told.filter((row) => row.resolved !== null).map(judgedRatio);
    const coarser = ratios.filter((ratio) => ratio > 2).length;
    const finer = ratios.filter((ratio) => ratio < 0.5).length;
    return {
        all: ratios.length,
        within: ratios.length - coarser - finer,
        coarser,
        finer,
        worstRatio: Math.max(1, ...ratios),
        missed: told.filter((row) => row.resolved === null && judgedRatio(row) > 2).length,
        beyondBound: beyondBound(document),
    };
}

/** Whether a pixel tells what is resolved. */
function isTold(row) {
    return row.pairs_seen !== 0;
}

/** How many are coarser than even the bound, every rounding at its worst, by more than the ladder tells apart. */
function beyondBound(document) {
    const known = document.results.filter((row) => "guaranteed" in row && isTold(row));
    const isBeyond = (row) => {
        const rung = rungOf(row);
        const bound = row.guaranteed ?? Infinity;
        return bound < row.largest / rung && (row.resolved ?? Infinity) > bound * rung;
    };
    return known.length === 0 ? null : known.filter(isBeyond).length;
}

/** Measured over predicted, 1 where the ladder's ends hide the difference. */
export function judgedRatio(row) {
    const predicted = row.predicted ?? Infinity;
    if (row.resolved === null) {
        return predicted > row.largest / 2 ? 1 : row.largest / predicted;
    }
    if (predicted === Infinity) {
        return row.resolved / row.largest; // the widest rung is as coarse as could be seen
    }
    if (row.resolved <= row.smallest * 1.0001 && predicted <= row.smallest) {
        return 1;
    }
    return row.resolved / predicted;
}

/** The ratio of a rung of the ladder to the one before. */
function rungOf(row) {
    return (row.largest / row.smallest) ** (1 / (kRungs - 1));
}
