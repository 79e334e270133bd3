import { number, percent } from "../logic/format.js";
import { worstAndBest } from "../logic/pictures.js";
import { h, slot, table } from "./elements.js";
import { figure, share } from "./figures.js";
import { makeWipe } from "./wipe.js";

const titles = { weighted: "Weighted", sorted: "Sorted" };
const titleOf = (row) => `${titles[row.method] ?? row.method}, ${row.cascades} ${row.cascades === 1 ? "cascade" : "cascades"}`;

export function fillTranslucency(document, folder) {
    if (document.results.every((row) => row.picture)) {
        slot("translucency", "wipe").append(makeWipe({
            scene: "Sheets of glass", width: document.options.width, height: document.options.height,
            items: document.results.map((row) => itemOf(row, folder)),
            start: worstAndBest(document.results, (row) => row.mean_error), alt: altOf }));
    }
    slot("translucency", "table").append(makeTable(document));
}

function itemOf(row, folder) {
    return {
        technique: `${row.method}-${row.cascades}`,
        title: titleOf(row),
        note: `mean error ${number(row.mean_error)} of 255 steps, ${percent(row.within_one_step)} of pixels within one`,
        picture: `${folder}/${row.picture}`,
        heatMap: `${folder}/${row.error_picture}`,
    };
}

function altOf(item, kind) {
    return kind === "picture" ? `Sheets of coloured glass, ${item.title}: ${item.note}.` : `What differs from the truth, eight times as bright, ${item.title}: ${item.note}.`;
}

function makeTable(document) {
    return table("Against the float64 sorted truth, in 8-bit steps of the worst channel, off silhouettes.",
        ["Method", "largest error", "mean error", "within one step", "miscounted", "MiB", "execute, ms"],
        document.results.map((row) => [
            h("span", {}, titleOf(row)), figure(row.max_error), figure(row.mean_error), share(row.within_one_step),
            figure(row.miscounted), figure(row.bytes / 2 ** 20), row.execute_ms === null ? "-" : figure(row.execute_ms)]));
}
