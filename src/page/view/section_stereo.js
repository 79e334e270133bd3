import { stereoPictures, stereoRows } from "../logic/stereo.js";
import { h, slot, table } from "./elements.js";
import { figure, length } from "./figures.js";

const titles = { none: "One eye", parallel: "Parallel eyes", "toed-in": "Toed-in eyes" };
const titleOf = ({ stereo }) => titles[stereo] ?? stereo;

/** @param {{document: object, folder: string}[]} results a way in which eyes look, and an output each. */
export function fillStereo(results) {
    if (results.length === 0) {
        return; // the page has no such section then, or says why it failed
    }
    slot("stereo", "pictures").append(...stereoPictures(results).map(makePicture));
    const rows = stereoRows(results.map(({ document }) => document));
    if (rows.length > 0) {
        slot("stereo", "table").append(makeTable(rows));
    }
}

function makePicture(shown) {
    return h("figure", {},
        h("img", { class: "picture", src: shown.picture, alt: `The scene from both eyes beside each other, ${titleOf(shown)}: the left eye's picture is at the left.` }),
        h("figcaption", {}, `${titleOf(shown)}: the left eye\u2019s picture is at the left.`));
}

function makeTable(rows) {
    return table("Of one frame. Objects and draws are those of all views together. Wrong pixels are counted in each view against its own truth.",
        ["Eyes", "apart", "coincide at", "cascades", "visible objects", "draws", "draws of a view", "cascades of an object", "wrong", "wrong at edges"],
        rows.map((row) => [
            h("span", {}, titleOf(row)), row.eyeDistance === null ? "" : length(row.eyeDistance), row.converge === null ? "" : length(row.converge),
            figure(row.cascades), figure(row.visible), figure(row.draws), figure(row.drawsPerView), figure(row.duplication),
            figure(row.wrong), figure(row.edgeWrong)]));
}
