// How recording scales with threads, from the JSON of `cdr scaling`.

/** The targets, and how draws are submitted where that is not by secondaries. */
export function nameOf({ targets, submission }) {
    return submission === undefined || submission === "secondaries" ? targets : `${targets}, ${submission}`;
}

/** The sweeps over threads: one per targets, submission, cascades and number of cubes. */
export function sweeps(document) {
    const byKey = new Map();
    for (const row of document.results) {
        const key = `${nameOf(row)} ${row.cascades} ${row.cubes}`;
        if (!byKey.has(key)) {
            byKey.set(key, { name: nameOf(row), cascades: row.cascades, cubes: row.cubes, points: [] });
        }
        byKey.get(key).points.push(row);
    }
    return [...byKey.values()];
}

/** Numbers of cascades, and of cubes, that were measured. */
export function choices(document) {
    const unique = (field) => [...new Set(document.results.map((row) => row[field]))].sort((a, b) => a - b);
    return { cascades: unique("cascades"), cubes: unique("cubes") };
}

/** One field over threads, a series per targets and submission. */
export function series(document, cascades, cubes, field) {
    const chosen = sweeps(document).filter((sweep) => sweep.cascades === cascades && sweep.cubes === cubes);
    const x = [...new Set(chosen.flatMap((sweep) => sweep.points.map((point) => point.threads)))].sort((a, b) => a - b);
    return {
        x,
        series: chosen.map((sweep) => ({
            name: sweep.name,
            values: x.map((threads) => sweep.points.find((point) => point.threads === threads)?.[field] ?? null),
        })),
    };
}

/** The best recording speed-up with no more threads than CPUs, and whether every image was the same. */
export function summary(document) {
    const cpus = document.host.cpus;
    const fair = document.results.filter((row) => row.threads <= cpus);
    const best = fair.reduce((a, b) => (!a || b.speedup > a.speedup ? b : a), null);
    return {
        cpus,
        best,
        points: document.results.length,
        differing: document.results.filter((row) => !row.same_image).length,
        fastest: Math.min(...document.results.map((row) => row.record_ns_per_draw)),
    };
}
