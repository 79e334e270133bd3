import { number } from "../logic/format.js";
import { worstAndBest } from "../logic/pictures.js";
import { h, slot, table } from "./elements.js";
import { figure, interval, share } from "./figures.js";
import { makeWipe } from "./wipe.js";

export const titles = { none: "In full", object: "By object", cascade: "By cascade", cluster: "By cluster", "none-again": "In full, again" };
const titleOf = (row) => titles[row.mode] ?? row.mode;

export function fillDetail(document, folder) {
    const shown = document.results.filter((row) => row.mode !== "none-again");
    if (shown.every((row) => row.picture)) {
        slot("detail", "wipe").append(makeWipe(document, folder, shown, {
            title: titleOf, note: noteOf, heatMap: "cracks_picture", start: worstAndBest(shown, (row) => row.cracks), alt: altOf }));
    }
    slot("detail", "table").append(makeTable(document));
}

function noteOf(row) {
    return `${number(row.triangles, 4)} triangles a frame, ${number(row.cracks, 7)} cracks in all frames`;
}

function altOf(item, kind) {
    return kind === "picture" ? `The scene drawn ${item.title}: ${item.note}.` : `The scene drawn ${item.title}, a red square about each crack: ${item.note}.`;
}

function makeTable(document) {
    return table("Execute over drawing in full, the median of the ratios frame by frame; FLIP and the rest compare with the same frames in full.",
        ["Detail", "triangles", "execute, ms", "times faster", "95 % interval", "FLIP", "other object shown", "cracks"],
        document.results.map((row) => [
            h("span", {}, titleOf(row)), figure(row.triangles), figure(row.execute_ms), figure(row.execute_speedup),
            interval(row.ci95), figure(row.flip), share(row.other_ids / row.pixels), figure(row.cracks)]));
}
