import assert from "node:assert/strict";
import { test } from "node:test";
import { cleanTechniques, openingSentences, sceneColumns, sceneRows } from "../../../src/page/logic/opening.js";
import { modesOrWorst, worstAndBest } from "../../../src/page/logic/pictures.js";
import { choices, nameOf, series } from "../../../src/page/logic/scaling.js";

const row = (technique, share, extra) => ({ technique, wrong_fraction: share, ...extra });
const orbit = { results: [
    row("standard", 0.1, { frame: 0, fov_degrees: 60 }), row("anchored", 0.2, { frame: 0, fov_degrees: 60 }),
    row("standard", 0.7664, { frame: 239, fov_degrees: 0.002, picture: "a.png" }),
    row("anchored", 0, { frame: 239, fov_degrees: 0.002, picture: "b.png" })] };

test("the page opens with what the last frame of the zoom counted", () => {
    const [scene, standard, anchored] = openingSentences(orbit);
    assert.match(scene, /0\.002\u00a0degrees/);
    assert.match(standard, /76\.6/);
    assert.match(anchored, /wrong in no pixel\.$/);
    assert.deepEqual(openingSentences(undefined), []);
    assert.deepEqual(openingSentences({ results: orbit.results.slice(0, 3) }), []);
});

test("the table has a row for each technique and a column for each scene that was measured", () => {
    const sections = { orbit, flicker: { results: [row("standard", 0.27), row("cdr-before", 0.1), row("reversed", 0)] } };
    assert.equal(sceneColumns(sections).length, 2);
    const rows = sceneRows(sections);
    assert.deepEqual(rows, [
        { technique: "standard", shares: [0.27, 0.7664] },
        { technique: "reversed", shares: [0, null] },
        { technique: "anchored", shares: [null, 0] }]);
    const titles = { reversed: "Reversed", anchored: "Anchored" };
    assert.equal(cleanTechniques(rows, titles), ""); // neither was measured everywhere
    assert.match(cleanTechniques([{ technique: "anchored", shares: [0, 0] }], titles), /^Anchored has no wrong pixel/);
    assert.deepEqual(sceneRows({}), []);
});

test("a wipe starts at the most and the fewest wrong pixels", () => {
    const places = (...shares) => worstAndBest(shares.map((share) => row("x", share)));
    assert.deepEqual(places(0.3, 0.9, 0, 0), [1, 3]);
    assert.deepEqual(places(null, 0.3, 0.2), [1, 2]); // a share of nothing is not the best
    assert.deepEqual(places(null, null), [0, 1]);
});

test("a sweep of another submission is a series of its own", () => {
    const point = (submission, speedup) => ({ targets: "single", submission, cascades: 1, cubes: 10, threads: 2, speedup });
    const document = { results: [point("secondaries", 1.31), point("primaries", 2.09)] };
    const { series: lines } = series(document, 1, 10, "speedup");
    assert.deepEqual(lines, [{ name: "single", values: [1.31] }, { name: "single, primaries", values: [2.09] }]);
    assert.deepEqual(choices(document), { cascades: [1], cubes: [10] });
    assert.equal(nameOf({ targets: "pool:2" }), "pool:2");
});

test("a wipe starts at the pair that tells most", () => {
    const rows = [{ mode: "plain", error: 3 }, { mode: "a", error: 9 }, { mode: "b", error: 1 }, { mode: "c", error: 1 }];
    assert.deepEqual(worstAndBest(rows, (row) => row.error), [1, 3]);
    assert.deepEqual(modesOrWorst(rows, ["plain", "b"], (row) => row.error), [0, 2]);
    assert.deepEqual(modesOrWorst(rows, ["plain", "gone"], (row) => row.error), [1, 3]);
});
