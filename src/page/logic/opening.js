// What the page opens with: the runway's number under two techniques, and every technique in every scene.

import { techniques } from "./flicker.js";
import { list, number, percent } from "./format.js";
import { find } from "./pictures.js";

const kTechniques = ["standard", "cdr", "log", "logcdr", "reversed", "anchored"];

/** The last frame of the zoom, where its pictures are, by technique. */
export function runwayRows(orbit) {
    return (orbit?.results ?? []).filter((row) => row.picture);
}

/** Columns of the table: a scene, and a technique's share of wrong pixels in it, null where it was not measured. */
export function sceneColumns({ pictures, flicker, "flicker-near": near, orbit }) {
    const shareIn = (rows) => (name) => rows.find((row) => row.technique === name)?.wrong_fraction ?? null;
    const last = Math.max(...(orbit?.results ?? []).map((row) => row.frame));
    return [
        pictures && { title: "cubes at 12,000 units", share: (name) => find(pictures, "cubes", name)?.wrong_fraction ?? null },
        flicker && { title: "cubes at 1,000,000 units", share: shareIn(techniques(flicker)) },
        near && { title: "the same, with something near the camera", share: shareIn(techniques(near)) },
        orbit && { title: "the runway\u2019s number from 420 km", share: shareIn(orbit.results.filter((row) => row.frame === last)) },
    ].filter(Boolean);
}

/** A row for each technique: its name and its share of wrong pixels in each scene. */
export function sceneRows(sections) {
    const columns = sceneColumns(sections);
    return kTechniques.map((technique) => ({ technique, shares: columns.map((column) => column.share(technique)) }))
        .filter((row) => row.shares.some((share) => share !== null));
}

/** What the two pictures of the runway show, in three sentences. */
export function openingSentences(orbit) {
    const [standard, anchored] = ["standard", "anchored"].map((name) => runwayRows(orbit).find((row) => row.technique === name));
    if (!standard || !anchored) {
        return [];
    }
    return [
        `Both sides show the same runway from 420\u00a0km above, through a lens of ${number(standard.fov_degrees, 2)}\u00a0degrees: paint 5\u00a0mm over a slab that lies 2\u00a0cm over the soil.`,
        `Standard depth stores one number for all three, so the wrong one shows in ${percent(standard.wrong_fraction)} of the pixels: that is z-fighting.`,
        `Anchored depth measures from a plane near the runway instead of from the camera, and is wrong in ${anchored.wrong_fraction === 0 ? "no pixel" : percent(anchored.wrong_fraction)}.`,
    ];
}

/** The techniques that are never wrong in any of the scenes. */
export function cleanTechniques(rows, titles) {
    const clean = rows.filter((row) => row.shares.every((share) => share === 0)).map((row) => titles[row.technique]);
    return clean.length > 0 ? `${list(clean)} ${clean.length === 1 ? "has" : "have"} no wrong pixel in any of them.` : "";
}
