// Figures 6.1 to 6.3 from the JSON of `cdr pictures`.

/** Scenes in the order of the document, each with its results by technique. */
export function scenes(document) {
    const names = [...new Set(document.results.map((result) => result.scene))];
    return names.map((name) => ({ name, results: document.results.filter((result) => result.scene === name) }));
}

/**
 * Places of the rows with the largest and smallest error (default: wrong pixels); of equal rows the first and the last.
 * Rows whose error is null do not count, unless all are such.
 */
export function worstAndBest(rows, errorOf = (row) => row.wrong_fraction) {
    const errors = rows.map(errorOf);
    const known = errors.filter((error) => error !== null);
    return known.length > 0
        ? [errors.indexOf(Math.max(...known)), errors.lastIndexOf(Math.min(...known))]
        : [0, errors.length - 1];
}

/** Places of the rows of two modes that a section is about; worstAndBest() where one of them is missing. */
export function modesOrWorst(rows, modes, errorOf) {
    const places = modes.map((mode) => rows.findIndex((row) => row.mode === mode));
    return places.includes(-1) ? worstAndBest(rows, errorOf) : places;
}

/** One result, or nothing. */
export function find(document, scene, technique) {
    return document.results.find((result) => result.scene === scene && result.technique === technique);
}
