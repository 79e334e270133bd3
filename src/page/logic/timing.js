// Figure 6.4 from the JSON of `cdr timing`.

/**
 * Every mode with its overhead, its interval and the thesis' value; without the baseline. Where frames are too few for an
 * interval, its ends are null, and whether the thesis agrees.
 */
export function bars(document) {
    return document.results.slice(1).map((row) => {
        const thesis = row.thesis_pct ?? null;
        const { low, high } = endsOf(row.ci95);
        return {
            name: row.name,
            targets: row.targets,
            cascades: row.cascades,
            medianUs: row.median_us,
            overhead: row.overhead_pct,
            low,
            high,
            thesis,
            agrees: thesis === null || low === null ? null : thesis >= low && thesis <= high,
        };
    });
}

/** The interval of standard over itself: differences inside it are nothing. Its ends are null as those of bars(). */
export function noiseFloor(document) {
    return { overhead: document.noise_floor_pct, ...endsOf(document.noise_floor_ci95) };
}

function endsOf(interval) {
    const [low, high] = interval ?? [null, null];
    return { low, high };
}

/** Kendall's tau-b of thesis and measured overheads: 1 the same order, -1 the opposite. NaN below two pairs. */
export function rankAgreement(rows) {
    const known = rows.filter((row) => row.thesis !== null);
    let sum = 0;
    let tiesA = 0;
    let tiesB = 0;
    let all = 0;
    known.forEach((a, i) => {
        for (const b of known.slice(i + 1)) {
            const thesis = Math.sign(a.thesis - b.thesis);
            const ours = Math.sign(a.overhead - b.overhead);
            sum += thesis * ours;
            tiesA += thesis === 0;
            tiesB += ours === 0;
            ++all;
        }
    });
    return all === 0 ? NaN : sum / Math.sqrt((all - tiesA) * (all - tiesB));
}

/** The thesis' modes that were measured. */
export function thesisBars(document) {
    return bars(document).filter((bar) => bar.thesis !== null);
}
