// Figures 6.1 to 6.3 from the JSON of `cdr pictures`.

/** Scenes in the order of the document, each with its results by technique. */
export function scenes(document) {
    const names = [...new Set(document.results.map((result) => result.scene))];
    return names.map((name) => ({ name, results: document.results.filter((result) => result.scene === name) }));
}

/** Places of the rows with the most and the fewest wrong pixels; of equals the first and the last. */
export function worstAndBest(rows) {
    const shares = rows.map((row) => row.wrong_fraction);
    return [shares.indexOf(Math.max(...shares)), shares.lastIndexOf(Math.min(...shares))];
}

/** One result, or nothing. */
export function find(document, scene, technique) {
    return document.results.find((result) => result.scene === scene && result.technique === technique);
}
