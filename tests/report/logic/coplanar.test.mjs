import assert from "node:assert/strict";
import { test } from "node:test";
import { coplanarRows, worstResult } from "../../../src/page/logic/coplanar.js";

const row = (method, wrong, extra) => ({
    technique: "anchored", method, slope_factor: null, constant_factor: null, pixels: 100, wrong, wrong_share: wrong / 100,
    coverage: 1, wrong_views: wrong > 0 ? 2 : 0, through: 0, flips: 3, coverage_flips: 1, ...extra });
const results = [
    row("none", 20, { picture: "none.png" }), row("polygon offset", 4, { picture: "offset.png", slope_factor: 0, constant_factor: 16 }), row("layers", 0)];

test("a method's row says what it was set to, and only polygon offset has a setting", () => {
    const rows = coplanarRows({ results });
    assert.deepEqual(rows.map((each) => each.setting), [null, { slope: 0, constant: 16 }, null]);
    assert.deepEqual(rows[0], {
        technique: "anchored", method: "none", setting: null, wrong: 20, wrongShare: 0.2, views: 2, through: 0, coverage: 1, flips: 3,
        coverageFlips: 1 });
});

test("the picture is that of the most wrong pixels, and there is none where all is right", () => {
    assert.equal(worstResult({ results: [...results].reverse() }).picture, "none.png");
    assert.equal(worstResult({ results: [results[2]] }), null);
});
