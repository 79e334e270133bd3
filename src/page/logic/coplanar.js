// Faces at one place from the JSON of `cdr coplanar`.

/** The result whose heat map the page shows: that with the most wrong pixels, or nothing where none is wrong. */
export function worstResult({ results }) {
    return results.filter((row) => row.picture).reduce((worst, row) => (row.wrong > (worst?.wrong ?? 0) ? row : worst), null);
}
