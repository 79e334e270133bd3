// Figures 6.1 to 6.3 from the JSON of `cdr pictures`.

/** Scenes in the order of the document, each with its results by technique. */
export function scenes(document) {
    const names = [...new Set(document.results.map((result) => result.scene))];
    return names.map((name) => ({ name, results: document.results.filter((result) => result.scene === name) }));
}

/** One result, or nothing. */
export function find(document, scene, technique) {
    return document.results.find((result) => result.scene === scene && result.technique === technique);
}
