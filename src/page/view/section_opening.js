import { cleanTechniques, openingSentences, runwayRows, sceneColumns, sceneRows } from "../logic/opening.js";
import { techniqueTitles } from "../logic/thesis.js";
import { h, slot, table, techniqueLabel } from "./elements.js";
import { share } from "./figures.js";
import { runway } from "./section_orbit.js";
import { makeWipe } from "./wipe.js";

/** @param {string} folder of the pictures of orbit. */
export function fillOpening(sections, folder) {
    const { orbit } = sections;
    const two = ["standard", "anchored"].map((name) => runwayRows(orbit).find((row) => row.technique === name));
    if (two.every(Boolean)) {
        const { width, height } = orbit.options;
        slot("opening", "wipe").append(
            orbit.window_picture ? h("img", {
                class: "earth", src: `${folder}/${orbit.window_picture}`, width, height,
                alt: "The Earth 420 km below, seen past the frame of a space station\u2019s window.",
            }) : "",
            makeWipe(orbit, folder, two, { ...runway, scene: "The runway\u2019s number" }));
    } else {
        document.getElementById("opening-title").textContent = "In short";
    }
    slot("opening", "sentences").append(...openingSentences(orbit).map((text) => h("p", {}, text)));
    const rows = sceneRows(sections);
    if (rows.length > 0) {
        slot("opening", "table").append(makeTable(sections, rows));
    }
}

function makeTable(sections, rows) {
    return table(`Wrong pixels off edges, against a float64 ray cast. ${cleanTechniques(rows, techniqueTitles)}`,
        ["Technique", ...sceneColumns(sections).map((column) => column.title)],
        rows.map((row) => [techniqueLabel(row.technique),
            ...row.shares.map((value) => (value === null ? "" : share(value)))]));
}
