import assert from "node:assert/strict";
import { test } from "node:test";
import { around, holds, panned } from "../../../src/page/logic/ranges.js";

const close = (actual, expected) => actual.forEach((value, i) =>
    assert.ok(Math.abs(value / expected[i] - 1) < 1e-12, `${actual} is not ${expected}`));

test("zooming keeps the point under the cursor, on either kind of axis", () => {
    close(around([1, 101], 0.5, 51, false), [26, 76]);
    close(around([1, 101], 0.5, null, false), [26, 76]);
    close(around([1, 1e4], 0.5, 100, true), [10, 1e3]);
    close(around([1, 1e4], 0.5, 1, true), [1, 100]);
    close(around(around([0.01, 1e8], 0.3, 7, true), 1 / 0.3, 7, true), [0.01, 1e8]);
});

test("panning keeps the width", () => {
    close(panned([1, 3], 10, false), [9, 11]);
    close(panned([1, 100], 1e6, true), [1e5, 1e7]);
});

test("a range holds what an axis can show", () => {
    assert.ok(holds([1, 100], [1, null, 100], false));
    assert.ok(!holds([1, 100], [0, 5], false));
    assert.ok(holds([1, 100], [0, 5], true));
    assert.ok(!holds([1, 100], [5, 101], true));
    assert.ok(holds([1, 100], [], true));
});
