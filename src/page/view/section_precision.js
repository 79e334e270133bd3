import { checkPercentages, curvesAndThesis, formatRows, tableRows } from "../logic/precision.js";
import { number, percent } from "../logic/format.js";
import { techniqueTitle, techniqueTitles, thesisTechniques } from "../logic/thesis.js";
import { h, slot, table, techniqueLabel } from "./elements.js";
import { length } from "./figures.js";
import { makePlot } from "./plot.js";

export function fillPrecision(document) {
    slot("precision", "table").append(makeTable(document));
    slot("precision", "plot").append(makeFigure(document));
    slot("precision", "percentages").append(...makePercentages());
    slot("precision", "formats").append(makeFormats(document));
}

function makeTable(document) {
    const rows = tableRows(document).flatMap((row) => [
        [h("span", {}, length(row.separation), ", thesis"), ...row.cells.map((cell) => length(cell.thesis, 7))],
        [h("span", {}, length(row.separation), ", here"), ...row.cells.map((cell) => length(cell.ours, 7))],
        [h("span", { class: "quiet" }, "difference"), ...row.cells.map((cell) =>
            h("span", { class: "quiet" }, cell.differencePct === null ? "" : percent(cell.differencePct / 100, 2)))],
    ]);
    return table("Table 4.1: view distance at which the smallest resolvable separation first reaches the value on the left.",
        ["Separation", ...thesisTechniques.map((name) => techniqueTitles[name])], rows);
}

function makeFigure(document) {
    const { x, series, thesis } = curvesAndThesis(document);
    const titled = (list, suffix) => list.map((s) => ({ ...s, title: `${techniqueTitle(s.name)}${suffix}` }));
    return makePlot({
        title: "Figure 4.1: smallest resolvable separation over view distance",
        caption: "Both axes are logarithmic, lower is finer. Points are the thesis\u2019 own numbers, its Table 4.1; lines are recomputed. The four techniques of the thesis by its own formulas at 24 bits; Reversed in a 32-bit float and Anchored in cascades fitted to 32 units of content by the exact step of the buffer.",
        x, xLabel: "view distance", yLabel: "separation", logX: true, logY: true,
        series: [
            ...titled(series, "").map((s) => ({ ...s, values: s.values.map((v) => (v === undefined || v > 0 ? v : null)) })),
            ...titled(thesis, ", thesis").map((s) => ({ ...s, points: true, dash: [], isDots: true })),
        ],
    });
}

function makePercentages() {
    const rows = checkPercentages().map((claim) => [
        `${techniqueTitles[claim.of]} over ${techniqueTitles[claim.over]}`, claim.where,
        `${number(claim.percent)}\u202f%`, `${number(claim.fromTable)}\u202f%`,
        h("span", { class: claim.agrees ? "mark-good" : "mark-bad" }, claim.agrees ? "agrees" : "does not"),
    ]);
    return [
        h("h3", {}, "How much further?"),
        h("p", {}, "The thesis gives the gain at a separation of one unit twice, and not the same way. Its Table 4.1 decides."),
        table("Percent further than the other technique at a separation of one unit.",
            ["", "where", "thesis says", "its table gives", ""], rows),
    ];
}

function makeFormats(document) {
    const rows = formatRows(document).map((row) => [
        techniqueLabel(row.technique, `${techniqueTitle(row.technique)} ${row.format.toUpperCase()}`),
        ...row.cells.map((cell) => (cell.depth === null ? quiet("everywhere finer") : length(cell.depth))),
    ]);
    const separations = formatRows(document)[0].cells.map((cell) => length(cell.separation));
    return h("details", { class: "source" }, h("summary", {}, "Every technique and depth format"),
        h("div", {}, table("View distance at which the buffer\u2019s exact step, vertex rounding left out, first reaches a separation.",
            ["", ...separations], rows)));
}

function quiet(text) {
    return h("span", { class: "quiet" }, text);
}
