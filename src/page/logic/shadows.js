// Shadows from the JSON of `cdr shadows`, a document for each scene.

import { median } from "./statistics.js";

/**
 * A row for each scene and method, over its frames and lights. `flips` and `flipsPerThousand` are null after one frame, and
 * `wrongFraction` where no pixel counts.
 */
export function shadowRows(documents) {
    return documents.flatMap(({ options, results }) => [...new Set(results.map((row) => row.method))].map((method) =>
        ({ scene: options.scene, method, ...summed(results.filter((row) => row.method === method)) })));
}

function summed(rows) {
    const sum = (field) => rows.reduce((all, row) => all + (row[field] ?? 0), 0);
    const compared = sum("flips_compared");
    const frames = rows.filter((row) => row.light === rows[0].light); // maps and times are the frame's, whatever the light
    const hasFlips = rows.some((row) => Number.isFinite(row.flips));
    return {
        pixels: sum("pixels"),
        wrong: sum("wrong"),
        wrongFraction: sum("pixels") > 0 ? sum("wrong") / sum("pixels") : null,
        edgeWrong: sum("edge_wrong"),
        flips: hasFlips ? sum("flips") : null,
        flipsPerThousand: hasFlips && compared > 0 ? 1000 * sum("flips") / compared : null,
        maps: median(frames.map((row) => row.maps)),
        executeMs: median(frames.map((row) => row.execute_ms)),
    };
}

/** Of each method the last frame, where its pictures are, under the light that has the most wrong shadows with any. */
export function lastPictures(results) {
    const last = Math.max(...results.map((row) => row.frame));
    const shown = results.filter((row) => row.picture && row.frame === last);
    const worst = shown.reduce((most, row) => (row.wrong > (most?.wrong ?? -1) ? row : most), null);
    return shown.filter((row) => row.light === worst.light);
}
