// Faces at one place from the JSON of `cdr coplanar`.

/** A row for each technique and method. The setting is that of polygon offset, null for other methods. */
export function coplanarRows({ results }) {
    return results.map((row) => ({
        technique: row.technique,
        method: row.method,
        setting: row.slope_factor === null ? null : { slope: row.slope_factor, constant: row.constant_factor },
        wrong: row.wrong,
        wrongShare: row.wrong_share,
        views: row.wrong_views,
        through: row.through,
        coverage: row.coverage,
        flips: row.flips,
        coverageFlips: row.coverage_flips,
    }));
}

/** The result whose heat map the page shows: that with the most wrong pixels, or nothing where none is wrong. */
export function worstResult({ results }) {
    return results.filter((row) => row.picture).reduce((worst, row) => (row.wrong > (worst?.wrong ?? 0) ? row : worst), null);
}
