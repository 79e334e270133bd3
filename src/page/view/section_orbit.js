import { number, percent } from "../logic/format.js";
import { runwayRows } from "../logic/opening.js";
import { worstAndBest } from "../logic/pictures.js";
import { techniqueTitle } from "../logic/thesis.js";
import { slot, table, techniqueLabel } from "./elements.js";
import { share } from "./figures.js";
import { makeWipe } from "./wipe.js";

/** What a wipe shows of the runway. */
export const runway = {
    title: (row) => techniqueTitle(row.technique),
    note: (row) => `${percent(row.wrong_fraction)} wrong off edges through ${number(row.fov_degrees, 2)}\u00b0`,
    heatMap: "heat_map",
    alt: (item, kind) => (kind === "picture" ? `The runway\u2019s numbers under ${item.title}: ${item.note}.` : `The same, wrong pixels red, under ${item.title}: ${item.note}.`),
};

export function fillOrbit(document, folder) {
    const last = runwayRows(document);
    if (last.length > 0) {
        slot("orbit", "wipe").append(makeWipe(document, folder, last, { ...runway, scene: "The runway from orbit", start: worstAndBest(last) }));
    }
    slot("orbit", "table").append(makeTable(document));
}

/** A row for each lens, a column for each technique. */
function makeTable(document) {
    const techniques = [...new Set(document.results.map((row) => row.technique))];
    const frames = [...new Set(document.results.map((row) => row.frame))];
    const find = (frame, technique) => document.results.find((row) => row.frame === frame && row.technique === technique);
    return table("Share of wrong pixels off edges along the zoom.",
        ["Lens", ...techniques.map((technique) => techniqueLabel(technique))],
        frames.map((frame) => [`${number(find(frame, techniques[0]).fov_degrees, 3)}\u00b0`,
            ...techniques.map((technique) => share(find(frame, technique).wrong_fraction))]));
}
