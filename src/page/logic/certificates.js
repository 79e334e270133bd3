// Certified frames from the JSON of `cdr render --certify --aov wrong`, a document for each scene and technique.

import { median } from "./statistics.js";

/** What came out of all frames of a document. Counts are sums, times medians. */
export function certifiedRow({ options, results }) {
    // Null where a frame was refused: no rays were cast for it.
    const sum = (field) => results.some((row) => row[field] === null) ? null : results.reduce((all, row) => all + row[field], 0);
    const pixels = options.width * options.height * results.length;
    const share = (field) => sum(field) === null ? null : sum(field) / pixels;
    return {
        scene: options.scene,
        technique: results[0].technique,
        certified: share("certified"),
        proven: share("proven"),
        cast: share("cast"),
        repaired: share("repaired"),
        wrongBefore: sum("wrong_before"),
        wrongAfter: sum("wrong") + sum("edge_wrong"), // counted after repair, by a ray through every pixel
        refused: sum("refused"),
        frameMs: median(results.map(frameMs)),
        certifyMs: median(results.map((row) => row.certify_ms)),
    };
}

/** Everything that draws a frame, one thing after the other. */
function frameMs(row) {
    return ["cull_ms", "split_ms", "occluders_ms", "shadows_ms", "bin_ms", "translucent_ms", "record_ms", "execute_ms"]
        .reduce((all, field) => all + row[field], 0);
}
