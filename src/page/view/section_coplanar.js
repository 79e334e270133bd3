import { worstResult } from "../logic/coplanar.js";
import { number } from "../logic/format.js";
import { techniqueTitle } from "../logic/thesis.js";
import { h, slot, table, techniqueLabel } from "./elements.js";
import { figure, share } from "./figures.js";

const titles = { none: "None", "polygon offset": "Polygon offset", layers: "Layers" };
const methodOf = (row) => titles[row.method] ?? row.method;

/** @param {string} folder of the heat maps. */
export function fillCoplanar(document, folder) {
    slot("coplanar", "table").append(makeTable(document));
    const worst = worstResult(document);
    slot("coplanar", "picture").append(worst ? makePicture(worst, folder) : h("p", {}, "No pixel is wrong, so there is no heat map."));
}

function makeTable(document) {
    return table(`Pixels off edges over ${number(2 * document.options.views, 7)} views.`,
        ["Technique", "method", "slope, constant", "wrong", "wrong share", "views with any", "through a wall", "by rounded vertices alone", "flips", "of these by rounded vertices"],
        document.results.map((row) => [
            techniqueLabel(row.technique), methodOf(row),
            row.slope_factor === null ? "" : h("span", {}, figure(row.slope_factor), ", ", figure(row.constant_factor)),
            figure(row.wrong), share(row.wrong_share), figure(row.wrong_views), figure(row.through), figure(row.coverage), figure(row.flips), figure(row.coverage_flips)]));
}

function makePicture(row, folder) {
    return h("figure", {},
        h("img", { class: "picture", src: `${folder}/${row.picture}`,
            alt: `A view under ${techniqueTitle(row.technique)}, method ${methodOf(row)}: red pixels show the wrong face, orange ones are wrong on an edge.` }),
        h("figcaption", {}, `The view with the most wrong pixels: ${techniqueTitle(row.technique)}, method ${methodOf(row)}. Red shows the wrong face.`));
}
