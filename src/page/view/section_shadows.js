import { number, percent } from "../logic/format.js";
import { worstAndBest } from "../logic/pictures.js";
import { lastPictures, shadowRows } from "../logic/shadows.js";
import { h, slot, table } from "./elements.js";
import { figure, share } from "./figures.js";
import { makeWipe } from "./wipe.js";

const titles = { plain: "Plain", anchored: "Anchored" };
const titleOf = (row) => titles[row.method] ?? row.method;

/** @param {{document: object, folder: string}[]} results a scene each. */
export function fillShadows(results) {
    for (const { document, folder } of results) {
        const shown = lastPictures(document.results);
        if (shown.length > 0) {
            slot("shadows", "wipe").append(makeWipe(document, folder, shown, {
                scene: `Shadows in ${document.options.scene}`, title: titleOf, note: noteOf, heatMap: "wrong_picture",
                start: worstAndBest(shown), alt: altOf }));
        }
    }
    if (results.length > 0) {
        slot("shadows", "table").append(makeTable(shadowRows(results.map(({ document }) => document))));
    }
}

function noteOf(row) {
    return `${percent(row.wrong_fraction)} wrong off edges, ${number(row.maps, 7)} maps`;
}

function altOf(item, kind) {
    return kind === "picture" ? `The scene with shadows of its light, ${item.title}: ${item.note}.` : `The same, missing shadows red and false ones blue, ${item.title}: ${item.note}.`;
}

function makeTable(rows) {
    return table("Over all frames and lights, drawn with anchored depth: what float64 rays say otherwise. Maps and times are a frame\u2019s, medians.",
        ["Shadows", "scene", "pixels", "wrong", "wrong share", "wrong at edges", "flips", "flips per thousand", "maps", "execute, ms"],
        rows.map((row) => [
            h("span", {}, titleOf(row)), row.scene, figure(row.pixels), figure(row.wrong), share(row.wrongFraction), figure(row.edgeWrong),
            row.flips === null ? "" : figure(row.flips), row.flipsPerThousand === null ? "" : figure(row.flipsPerThousand),
            figure(row.maps), figure(row.executeMs)]));
}
