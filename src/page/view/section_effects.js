import { number, percent } from "../logic/format.js";
import { modesOrWorst } from "../logic/pictures.js";
import { techniqueTitle } from "../logic/thesis.js";
import { h, slot, table } from "./elements.js";
import { figure, interval, share } from "./figures.js";
import { makeWipe } from "./wipe.js";

const titles = { plain: "Plain", edges: "Smooth edges", occlusion: "Ambient occlusion", "occlusion-layers": "Occlusion per cascade", fog: "Fog" };
const titleOf = (row) => titles[row.mode] ?? row.mode;

export function fillEffects(document, folder) {
    if (document.results.every((row) => row.picture)) {
        slot("effects", "wipe").append(makeWipe(document, folder, document.results, {
            title: titleOf, note: (row) => `${number(row.execute_ratio)} times the time of a plain frame`,
            start: modesOrWorst(document.results, ["occlusion", "occlusion-layers"], (row) => row.execute_ratio), alt: altOf }));
    }
    slot("effects", "table").append(makeTable(document),
        h("p", {}, `Worked out on each cascade alone, occlusion leaves ${percent(document.lost_per_layer)} of the pixels too bright.`));
}

function altOf(item) {
    return `The scene with ${item.title}: ${item.note}.`;
}

function makeTable(document) {
    return table("Execute over a plain frame, the median of the ratios frame by frame; pixels that differ from anchored\u2019s, under the preset where most do.",
        ["Effect", "execute, ms", "over plain", "95 % interval", "differing", "under"],
        document.results.map((row) => [
            h("span", {}, titleOf(row)), figure(row.execute_ms), figure(row.execute_ratio), interval(row.ci95),
            share(row.differing), techniqueTitle(row.least_alike)]));
}
