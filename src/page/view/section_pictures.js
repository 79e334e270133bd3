import { scenes, worstAndBest } from "../logic/pictures.js";
import { number, percent } from "../logic/format.js";
import { techniqueTitle } from "../logic/thesis.js";
import { h, slot, table, techniqueLabel } from "./elements.js";
import { figure, share } from "./figures.js";
import { makeWipe } from "./wipe.js";

const about = {
    cubes: { title: "Cubes at 12,000 units", text: "Figures 6.1 to 6.3: near plane 0.01, far plane 100,000." },
    afc: { title: "Cubes at 1,000,000 units", text: "The scene of the experiment on people: near plane 0.001, far plane 2,000,000." },
};

export function fillPictures(document, folder) {
    for (const scene of scenes(document)) {
        const { title, text } = about[scene.name] ?? { title: scene.name, text: "" };
        const lens = `The thesis names no lens; here it is ${number(scene.results[0].fov_degrees, 4)}\u00b0 high.`;
        slot("pictures", "wipes").append(h("h3", {}, title), h("p", {}, `${text} ${scene.name === "cubes" ? lens : ""}`),
            makeWipe(document, folder, scene.results, {
                scene: title, title: (row) => techniqueTitle(row.technique), note: noteOf, heatMap: "heat_map",
                start: worstAndBest(scene.results), alt: (item, kind) => altOf(title, item, kind) }));
    }
    slot("pictures", "table").append(makeTable(document));
}

function noteOf(row) {
    return `${percent(row.wrong_fraction)} wrong off edges, ${percent(row.overlap_wrong_fraction)} where cubes overlap`;
}

function altOf(scene, item, kind) {
    return kind === "picture"
        ? `${scene} under ${item.title}: ${item.note}.`
        : `Heat map of ${scene} under ${item.title}, wrong pixels red: ${item.note}.`;
}

function makeTable(document) {
    return table("Wrong pixels, summed over the frames. Inner: the true object is shared by all eight neighbours.",
        ["Technique", "scene", "frames", "inner pixels", "wrong", "wrong share", "where objects overlap"],
        document.results.map((r) => [
            techniqueLabel(r.technique), r.scene, r.frames, figure(r.pixels), figure(r.wrong),
            share(r.wrong_fraction), share(r.overlap_wrong_fraction)]));
}
