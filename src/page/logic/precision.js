// Table 4.1 and Figure 4.1 from the JSON of `cdr precision`.

import { percentages, table41, thesisTechniques } from "./thesis.js";

/** Rows of Table 4.1: per separation and technique the thesis' distance, ours, and the difference in percent. */
export function tableRows(document) {
    const cells = document.results.filter((cell) => thesisTechniques.includes(cell.technique));
    const separations = [...new Set(cells.map((cell) => cell.separation))];
    return separations.map((separation) => ({
        separation,
        cells: thesisTechniques.map((technique) => {
            const cell = cells.find((c) => c.technique === technique && c.separation === separation);
            const thesis = table41[separation]?.[technique] ?? null;
            const ours = cell?.depth ?? null;
            return { technique, thesis, ours, heldLast: cell?.held_last ?? null, differencePct: difference(ours, thesis) };
        }),
    }));
}

/** The cell that differs most, of those that both have. */
export function worstCell(document) {
    const cells = tableRows(document).flatMap((row) => row.cells).filter((cell) => cell.differencePct !== null);
    return cells.reduce((worst, cell) => (!worst || Math.abs(cell.differencePct) > Math.abs(worst.differencePct) ? cell : worst), null);
}

/**
 * The thesis' percentages against its own Table 4.1: what the table gives, and whether the two agree.
 * @param {number} tolerance relative.
 */
export function checkPercentages(tolerance = 0.001) {
    return percentages.map((claim) => {
        const fromTable = 100 * (table41[1][claim.of] / table41[1][claim.over] - 1);
        return { ...claim, fromTable, agrees: Math.abs(claim.percent / fromTable - 1) <= tolerance };
    });
}

/** Figure 4.1's curves: distances, and separations per technique. */
export function curves(document) {
    const { techniques, points } = document.curve;
    return {
        x: points.map((point) => point[0]),
        series: techniques.map((name, index) => ({ name, values: points.map((point) => point[index + 1]) })),
    };
}

/**
 * The same with the points of the thesis' Table 4.1 beside them. A value is undefined where a curve has no point of its own,
 * which leaves no gap in it. It is null between the thesis' points, which no line joins.
 */
export function curvesAndThesis(document) {
    const { x, series } = curves(document);
    const cells = Object.entries(table41).flatMap(([separation, depths]) =>
        thesisTechniques.map((name) => ({ name, depth: depths[name], separation: Number(separation) })));
    const all = [...new Set([...x, ...cells.map((cell) => cell.depth)])].sort((a, b) => a - b);
    const places = new Map(x.map((depth, i) => [depth, i]));
    return {
        x: all,
        series: series.map((one) => ({ ...one, values: all.map((depth) => one.values[places.get(depth)]) })),
        thesis: thesisTechniques.map((name) => ({
            name, values: all.map((depth) => cells.find((cell) => cell.name === name && cell.depth === depth)?.separation ?? null) })),
    };
}

/** Every technique and format: at which distance the buffer alone still resolves each separation. */
export function formatRows(document) {
    const keys = [...new Set(document.by_format.map((cell) => `${cell.technique} ${cell.format}`))];
    return keys.map((key) => {
        const cells = document.by_format.filter((cell) => `${cell.technique} ${cell.format}` === key);
        return { technique: cells[0].technique, format: cells[0].format, cells };
    });
}

function difference(ours, thesis) {
    return ours === null || thesis === null ? null : 100 * (ours / thesis - 1);
}
