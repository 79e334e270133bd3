import { number, percent } from "../logic/format.js";
import { worstAndBest } from "../logic/pictures.js";
import { h, slot, table } from "./elements.js";
import { figure, share } from "./figures.js";
import { makeWipe } from "./wipe.js";

const titles = { weighted: "Weighted", sorted: "Sorted" };
const titleOf = (row) => `${titles[row.method] ?? row.method}, ${row.cascades} ${row.cascades === 1 ? "cascade" : "cascades"}`;

export function fillTranslucency(document, folder) {
    if (document.results.every((row) => row.picture)) {
        slot("translucency", "wipe").append(makeWipe(document, folder, document.results, {
            scene: "Sheets of glass", title: titleOf, note: noteOf, heatMap: "error_picture",
            start: worstAndBest(document.results, (row) => row.mean_error), alt: altOf }));
    }
    slot("translucency", "table").append(makeTable(document));
}

function noteOf(row) {
    return `mean error ${number(row.mean_error)} of 255 steps, ${percent(row.within_one_step)} of pixels within one`;
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
