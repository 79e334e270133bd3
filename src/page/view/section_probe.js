import { formats, judgedRatio, series } from "../logic/probe.js";
import { techniqueTitle } from "../logic/thesis.js";
import { h, slot, table, techniqueLabel } from "./elements.js";
import { figure, length, separation } from "./figures.js";
import { makePlot } from "./plot.js";

export function fillProbe(document) {
    for (const format of formats(document).reverse()) {
        const plot = makeFigure(document, format);
        const first = slot("probe", "plot").childElementCount === 0;
        slot("probe", "plot").append(first ? plot : h("details", { class: "source" },
            h("summary", {}, `The same in ${format.toUpperCase()}`), h("div", {}, plot)));
    }
    const missing = (document.missing_formats ?? []).map((format) => format.toUpperCase());
    if (missing.length > 0) {
        slot("probe", "table").append(h("p", {}, `Left out, since this device cannot draw to it: ${missing.join(", ")}.`));
    }
    slot("probe", "table").append(h("details", { class: "source" }, h("summary", {}, "Every measurement as a table"),
        h("div", {}, makeTable(document))));
}

function makeFigure(document, format) {
    const { x, measured, predicted } = series(document, format);
    const titled = (list, suffix, extra) => list.map((s) => ({ ...s, ...extra, title: `${techniqueTitle(s.name)}${suffix}` }));
    return makePlot({
        title: `Smallest resolved separation over view distance, ${format.toUpperCase()}`,
        caption: "Points are measured, thin dashes predicted. No point: not even the widest rung, one unit, was clean. Below 1,000 units the ladder shrinks with the distance.",
        x, xLabel: "view distance", yLabel: "separation", logX: true, logY: true,
        series: [...titled(measured, "", { points: true, dash: [] }), ...titled(predicted, ", predicted", { dash: [4, 5] })]
            .filter((s) => s.values.some((value) => value > 0)),
    });
}

function makeTable(document) {
    return table("Smallest resolved separation, measured and predicted.",
        ["Technique", "format", "distance", "measured", "predicted", "ratio", "at worst"],
        document.results.map((row) => [
            techniqueLabel(row.technique), row.format.toUpperCase(), length(row.distance),
            separation(row, row.resolved, row.pairs_seen, row.resolves_all), length(row.predicted),
            row.resolved === null || row.predicted === null ? "" : figure(judgedRatio(row), 2),
            row.guaranteed === undefined ? "" : length(row.guaranteed)]));
}
