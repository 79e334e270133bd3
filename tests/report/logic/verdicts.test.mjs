import assert from "node:assert/strict";
import { test } from "node:test";
import { table41 } from "../../../src/page/logic/thesis.js";
import { checkPercentages, tableRows } from "../../../src/page/logic/precision.js";
import { listingSeparation } from "../../../src/page/logic/listing_a2.js";
import { judgedRatio, listingReliability, reliability } from "../../../src/page/logic/probe.js";
import { bars, noiseFloor, rankAgreement } from "../../../src/page/logic/timing.js";
import { observerWins, pairRows } from "../../../src/page/logic/flicker.js";
import { statuses, verdicts } from "../../../src/page/logic/verdicts.js";

const precision = (factor = 1) => ({
    results: Object.entries(table41).flatMap(([separation, row]) => Object.entries(row).map(([technique, depth]) =>
        ({ technique, format: "d24", separation: Number(separation), depth: depth * factor }))),
});
const flicker = (shares, flips) => ({
    options: { frames: 9 },
    results: Object.keys(shares).map((technique) =>
        ({ scene: "afc", technique, pixels: 1000, wrong_fraction: shares[technique], flips: flips[technique], flips_per_thousand: flips[technique] })),
});
const timing = (overheads, spread, frames = 300) => ({
    options: { frames }, device: { name: "a device" }, noise_floor_pct: 0, noise_floor_ci95: [-1, 1],
    results: [{ name: "standard", ci95: [0, 0] }, ...Object.entries(overheads).map(([name, [overhead, thesis]]) =>
        ({ name, overhead_pct: overhead, ci95: [overhead - spread, overhead + spread], thesis_pct: thesis }))],
});
const pictures = (standard, log, cdr) => ({
    results: [["standard", 0.3, standard], ["log", log, log], ["cdr", cdr, cdr]].map(([technique, share, overlap]) =>
        ({ scene: "cubes", technique, wrong_fraction: share, overlap_wrong_fraction: overlap })),
});
const verdictOf = (id, sections) => verdicts(sections).find((verdict) => verdict.id === id);

test("without any results every verdict still has words", () => {
    for (const verdict of verdicts({})) {
        assert.ok(verdict.status in statuses);
        assert.ok(verdict.sentence.length > 20 && !/undefined|NaN|null/.test(verdict.sentence), verdict.sentence);
    }
    assert.equal(verdictOf("figure-6-4", {}).status, "missing");
    assert.equal(verdictOf("table-6-9", {}).status, "yes"); // the thesis' counts are enough
});

test("Table 4.1 holds to a tenth of a percent and no further", () => {
    assert.equal(verdictOf("table-4-1", { precision: precision() }).status, "yes");
    assert.equal(verdictOf("table-4-1", { precision: precision(1.0009) }).status, "yes");
    assert.equal(verdictOf("table-4-1", { precision: precision(1.0011) }).status, "no");
    const one = precision();
    one.results[0].depth *= 2;
    const verdict = verdictOf("table-4-1", { precision: one });
    assert.equal(verdict.status, "partly");
    assert.match(verdict.sentence, /^1 of 16.*100/);
    one.results[1].depth = null; // never reached
    assert.match(verdictOf("table-4-1", { precision: one }).sentence, /^2 of 16/);
    assert.equal(tableRows(one).length, 4);
});

test("of the thesis' percentages chapter 4's follow from its table, two of the conclusion's do not", () => {
    assert.deepEqual(checkPercentages().map((claim) => claim.agrees), [true, true, true, false, true, false]);
    const { sentence } = verdictOf("percentages", { precision: precision() });
    assert.match(sentence, /99,565.*98,000.*2,801,701.*2,975,000/);
});

test("the pictures need both: standard wrong, the others right", () => {
    const status = (...shares) => verdictOf("figures-6", { pictures: pictures(...shares) }).status;
    assert.equal(status(0.76, 0, 0.0002), "yes");
    assert.equal(status(0.76, 0, 0.02), "partly");
    assert.equal(status(0.2, 0, 0), "partly");
    assert.equal(status(0.2, 0.2, 0.2), "no");
    assert.equal(verdictOf("figures-6", { pictures: { results: [] } }).status, "missing");
});

test("an observer that counts flips is compared with people, and a disagreement is explained", () => {
    const shares = { standard: 0.26, cdr: 0.12, log: 0.03, logcdr: 0.01 };
    const agreeing = flicker(shares, { standard: 90, cdr: 60, log: 40, logcdr: 8 });
    // People cannot be reproduced by counting: the most that a verdict may say is that both agree.
    assert.equal(verdictOf("table-6-2", { flicker: agreeing }).status, "consistent");
    assert.equal(verdictOf("order", { flicker: agreeing }).status, "yes");
    assert.deepEqual(observerWins(agreeing), { standard: 0, cdr: 1, log: 2, logcdr: 3 });

    const steady = flicker(shares, { standard: 5, cdr: 60, log: 40, logcdr: 8 });
    const verdict = verdictOf("table-6-2", { flicker: steady });
    assert.equal(verdict.status, "partly");
    assert.match(verdict.sentence, /in 3 of 6 pairs/);
    assert.match(verdict.sentence, /Of Standard and CDR people chose CDR, though Standard flips less: it has more wrong pixels \(26.*against 12.*but they stay put/);

    const still = flicker(shares, { standard: 0, cdr: 0, log: 0, logcdr: 0 });
    assert.equal(verdictOf("table-6-2", { flicker: still }).status, "open");
    assert.ok(pairRows(still).every((row) => row.observer === null && !row.agree));
});

test("ties rank no technique, and what cannot be compared does not flip equally often", () => {
    const shares = { standard: 0.3, cdr: 0.2, log: 0.1, logcdr: 0.05 };
    const ties = flicker(shares, { standard: 5, cdr: 5, log: 5, logcdr: 0 });
    const sentence = verdictOf("table-6-2", { flicker: ties }).sentence;
    assert.match(sentence, /Standard and CDR flip equally often/);
    assert.doesNotMatch(sentence, /ranks the techniques/);
    ties.results[0].compared = 0;
    const unjudged = verdictOf("table-6-2", { flicker: ties }).sentence;
    assert.match(unjudged, /Standard and CDR cannot be compared/);
    assert.doesNotMatch(unjudged, /Standard and CDR flip/);
});

test("shares of no pixels are no verdict", () => {
    const names = ["standard", "cdr", "log", "logcdr"];
    const nothing = Object.fromEntries(names.map((name) => [name, null]));
    const still = flicker(nothing, Object.fromEntries(names.map((name) => [name, 0])));
    still.results.forEach((row) => { row.compared = 0; });
    assert.ok(pairRows(still).every((row) => !row.couldJudge && row.observer === null));
    const sections = { flicker: still, pictures: pictures(null, null, null) };
    for (const id of ["table-6-2", "order", "figures-6"]) {
        assert.equal(verdictOf(id, sections).status, "open", id);
        assert.match(verdictOf(id, sections).sentence, /[Nn]o pixels? off edges/, id);
    }
});

test("the order of quality is judged step by step", () => {
    const flips = { standard: 4, cdr: 3, log: 2, logcdr: 1 };
    const verdict = verdictOf("order", { flicker: flicker({ standard: 0.2, cdr: 0.3, log: 0.1, logcdr: 0.05 }, flips) });
    assert.equal(verdict.status, "partly");
    assert.match(verdict.sentence, /2 of 3 steps/);
});

test("timing is undecided while its intervals are wide or its frames few", () => {
    const figures = { "cdr-2": [3.4, 3.4], log: [4.4, 4.4], "logcdr-5": [10.4, 10.4] };
    assert.equal(verdictOf("figure-6-4", { timing: timing(figures, 1) }).status, "yes");
    assert.equal(verdictOf("figure-6-4", { timing: timing(figures, 6) }).status, "open");
    assert.equal(verdictOf("figure-6-4", { timing: timing(figures, 1, 5) }).status, "open");
    const other = { "cdr-2": [-5, 3.4], log: [-7, 4.4], "logcdr-5": [-9, 10.4] };
    assert.equal(verdictOf("figure-6-4", { timing: timing(other, 1) }).status, "no");
    const shifted = { "cdr-2": [13, 3.4], log: [14, 4.4], "logcdr-5": [15, 10.4] };
    assert.equal(verdictOf("figure-6-4", { timing: timing(shifted, 1) }).status, "partly");
});

test("timing without intervals is undecided, and says so", () => {
    const few = timing({ "cdr-2": [5, 3.4], log: [7, 4.4] }, 1, 5);
    few.noise_floor_ci95 = null;
    few.results.forEach((row) => { row.ci95 = null; });
    assert.deepEqual(noiseFloor(few), { overhead: 0, low: null, high: null });
    assert.deepEqual(bars(few).map(({ low, high, agrees }) => [low, high, agrees]), Array(2).fill([null, null, null]));
    const verdict = verdictOf("figure-6-4", { timing: few });
    assert.equal(verdict.status, "open");
    assert.match(verdict.sentence, /^5 frames are too few for an interval: .*1, and standard over itself gives 0\u00a0%\.$/);
    assert.ok(!/null|NaN|undefined|none/.test(verdict.sentence), verdict.sentence);
    few.options.frames = 1;
    assert.match(verdictOf("figure-6-4", { timing: few }).sentence, /^1 frame is too few/);
});

test("Kendall's tau-b counts ties as its definition says", () => {
    const rows = (pairs) => pairs.map(([overhead, thesis]) => ({ overhead, thesis }));
    assert.equal(rankAgreement(rows([[1, 1], [2, 2], [3, 3]])), 1);
    assert.equal(rankAgreement(rows([[3, 1], [2, 2], [1, 3]])), -1);
    // Concordant 4, discordant 1, one tie in thesis: 3 / sqrt(5 * 6).
    assert.ok(Math.abs(rankAgreement(rows([[1, 1], [2, 2], [3, 2], [2.5, 3]])) - 3 / Math.sqrt(30)) < 1e-12);
    assert.ok(Number.isNaN(rankAgreement(rows([[1, 1]]))));
});

test("the ladder's ends do not count as errors of the forecast", () => {
    const row = (resolved, predicted) => ({ resolved, predicted, smallest: 1e-6, largest: 1 });
    assert.equal(judgedRatio(row(0.2, 0.1)), 2);
    assert.equal(judgedRatio(row(null, 60)), 1); // none of the rungs, as forecast
    assert.equal(judgedRatio(row(null, null)), 1);
    assert.equal(judgedRatio(row(null, 0.1)), 10); // none, though forecast
    assert.equal(judgedRatio(row(1e-6, 1e-9)), 1); // the finest rung, as forecast
    assert.equal(judgedRatio(row(0.01, null)), 0.01);
    // A case that resolves nothing is not counted; where the forecast says otherwise, it is counted apart.
    const counts = reliability({ results: [row(0.1, 0.1), row(0.5, 0.1), row(0.01, 0.1), row(null, 0.01), row(null, 60)] });
    assert.deepEqual(counts, { all: 3, within: 1, coarser: 1, finer: 1, worstRatio: 5, missed: 1, beyondBound: null });
    // Nor is one of which no pixel tells.
    const unseen = { ...row(null, 0.01), pairs_seen: 0, guaranteed: 0.01 };
    assert.deepEqual(reliability({ results: [unseen] }), { all: 0, within: 0, coarser: 0, finer: 0, worstRatio: 1, missed: 0, beyondBound: null });
    const bounded = (resolved, guaranteed) => ({ ...row(resolved, 0.1), guaranteed });
    const list = [bounded(0.1, 0.2), bounded(0.3, 0.2), bounded(null, 0.2), bounded(null, null), bounded(0.3, null), bounded(null, 5)];
    assert.equal(reliability({ results: list }).beyondBound, 2);
});

test("Listing A.2 recomputes Table 4.1", () => {
    for (const [separation, row] of Object.entries(table41)) {
        for (const [technique, distance] of Object.entries(row)) {
            const formula = listingSeparation(technique, distance, { near: 0.001, far: 1e8 });
            assert.ok(Math.abs(formula / Number(separation) - 1) < 1e-3, `${technique} at ${distance}: ${formula}`);
        }
    }
    assert.equal(listingSeparation("anchored", 1, { near: 0.001, far: 1e8 }), null);
});

test("chapter 7 is judged by the thesis' own formulas, over what was resolved", () => {
    const row = (technique, format, resolved) =>
        ({ technique, format, distance: 1000, resolved, predicted: 0.001, smallest: 1e-6, largest: 1 });
    const formula = listingSeparation("log", 1000, { near: 0.001, far: 2000 });
    const document = { results: [
        row("log", "d24", 3 * formula), row("logcdr", "d24", 1e-6), row("standard", "d24", null),
        row("log", "d32f", 3 * formula), row("anchored", "d24", 0.5)] };
    const { all, coarser, worstRatio } = listingReliability(document);
    assert.deepEqual([all, coarser], [2, 1]);
    assert.ok(Math.abs(worstRatio - 3) < 1e-12);
    const probed = (...resolved) => ({ probe: { results: resolved.map((factor) => row("log", "d24", factor * formula)) } });
    assert.equal(verdictOf("chapter-7", probed(3, 2)).status, "yes");
    assert.equal(verdictOf("chapter-7", probed(3, 1, 1)).status, "partly");
    assert.equal(verdictOf("chapter-7", probed(1, 1)).status, "no");
    assert.equal(verdictOf("chapter-7", { probe: { results: [row("log", "d16", 1)] } }).status, "open");
    assert.match(verdictOf("chapter-7", probed(3)).sentence, /^Of 1 resolved D24 case 1 is coarser .*Listing A.2.*factor of 3.*forecast.*of the 1 resolved cases/);
});
