import assert from "node:assert/strict";
import { test } from "node:test";
import { lastPictures, shadowRows } from "../../../src/page/logic/shadows.js";

const row = (method, frame, light, extra) => ({ method, frame, light, pixels: 100, wrong: 2, edge_wrong: 1, maps: 4, execute_ms: 10, ...extra });
const twoFrames = [
    row("plain", 0, 0, { picture: "p0" }), row("plain", 0, 1, { picture: "p0_1" }),
    row("plain", 1, 0, { picture: "p1", flips: 3, flips_compared: 50, execute_ms: 20 }),
    row("plain", 1, 1, { picture: "p1_1", flips: 0, flips_compared: 50, execute_ms: 20 }),
    row("anchored", 0, 0, { wrong: 0, picture: "a0" }), row("anchored", 1, 0, { wrong: 0, picture: "a1", flips: 0, flips_compared: 40 })];

test("shadows are summed over frames and lights, and a frame's time counts once", () => {
    const [plain, anchored] = shadowRows([{ options: { scene: "alley" }, results: twoFrames }]);
    assert.deepEqual(plain, {
        scene: "alley", method: "plain", pixels: 400, wrong: 8, wrongFraction: 0.02, edgeWrong: 4,
        flips: 3, flipsPerThousand: 30, maps: 4, executeMs: 15 });
    assert.deepEqual([anchored.method, anchored.wrongFraction, anchored.flips, anchored.flipsPerThousand], ["anchored", 0, 0, 0]);
});

test("one frame has no flips, and no pixels no share", () => {
    const [plain] = shadowRows([{ options: { scene: "afc" }, results: [row("plain", 0, 0, { pixels: 0, wrong: 0 })] }]);
    assert.deepEqual([plain.flips, plain.flipsPerThousand, plain.wrongFraction], [null, null, null]);
});

test("pictures are of the last frame under the light that has the most wrong shadows", () => {
    assert.deepEqual(lastPictures(twoFrames).map(({ picture }) => picture), ["p1", "a1"]);
    const second = [row("plain", 1, 0, { picture: "p" }), row("plain", 1, 1, { picture: "p_1", wrong: 9 }),
        row("anchored", 1, 0, { picture: "a" }), row("anchored", 1, 1, { picture: "a_1" })];
    assert.deepEqual(lastPictures(second).map(({ picture }) => picture), ["p_1", "a_1"]);
    assert.deepEqual(lastPictures([row("plain", 0, 0)]), []);
});
