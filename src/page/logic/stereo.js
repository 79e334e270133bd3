// Two eyes from the JSON of `cdr render --stereo`, a document for each way in which eyes look and each output.

/** A row for each document that counts wrong pixels, in the plan's order; counts are those of all views together. */
export function stereoRows(documents) {
    return documents.filter(({ options }) => options.aov === "wrong").map(({ options, results: [row] }) => ({
        stereo: row.stereo,
        eyeDistance: options.eye_distance ?? null,
        converge: options.converge ?? null,
        cascades: row.cascades,
        visible: row.visible,
        draws: row.draws,
        drawsPerView: row.draws / row.views,
        duplication: row.duplication,
        wrong: row.wrong,
        edgeWrong: row.edge_wrong,
    }));
}

/** Documents whose output is a picture, with the file that the plan gave it. */
export function stereoPictures(results) {
    return results.filter(({ document, folder }) => document.options.aov === "color" && folder)
        .map(({ document, folder }) => ({ stereo: document.results[0].stereo, picture: folder }));
}
