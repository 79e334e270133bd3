import { number, percent } from "../logic/format.js";
import { runwayRows } from "../logic/opening.js";
import { worstAndBest } from "../logic/pictures.js";
import { techniqueTitle } from "../logic/thesis.js";
import { slot, table, techniqueLabel } from "./elements.js";
import { share } from "./figures.js";
import { makeWipe } from "./wipe.js";


export function fillOrbit(document, folder) {
    const last = runwayRows(document);
    if (last.length > 0) {
        slot("orbit", "wipe").append(makeWipe({
            scene: "The runway from orbit", width: document.options.width, height: document.options.height,
            items: last.map((row) => itemOf(row, folder)), start: worstAndBest(last), alt: altOf }));
    }
    slot("orbit", "table").append(makeTable(document));
}

export function itemOf(row, folder) {
    return {
        technique: row.technique,
        title: techniqueTitle(row.technique),
        note: `${percent(row.wrong_fraction)} wrong off edges through ${number(row.fov_degrees, 2)}\u00b0`,
        picture: `${folder}/${row.picture}`,
        heatMap: `${folder}/${row.heat_map}`,
    };
}

export function altOf(item, kind) {
    return kind === "picture" ? `The runway\u2019s numbers under ${item.title}: ${item.note}.` : `The same, wrong pixels red, under ${item.title}: ${item.note}.`;
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
