import assert from "node:assert/strict";
import { test } from "node:test";
import { stereoPictures, stereoRows } from "../../../src/page/logic/stereo.js";

const document = (stereo, aov, row) => ({
    options: { aov, ...(stereo === "none" ? {} : { eye_distance: 0.3, converge: 9 }) },
    results: [{ stereo, views: stereo === "none" ? 1 : 2, cascades: 2, visible: 30, draws: 50, duplication: 1.5, ...row }] });
const counted = { wrong: 0, edge_wrong: 7 };

test("rows are of the documents that count wrong pixels, and draws of a view are a share of all", () => {
    const rows = stereoRows([document("none", "wrong", counted), document("parallel", "wrong", counted), document("parallel", "color")]);
    assert.deepEqual(rows.map((row) => [row.stereo, row.eyeDistance, row.converge, row.draws, row.drawsPerView]),
        [["none", null, null, 50, 50], ["parallel", 0.3, 9, 50, 25]]);
    assert.deepEqual([rows[1].cascades, rows[1].visible, rows[1].duplication, rows[1].wrong, rows[1].edgeWrong], [2, 30, 1.5, 0, 7]);
});

test("pictures are of the documents whose output is one", () => {
    assert.deepEqual(stereoPictures([
        { document: document("toed-in", "wrong", counted), folder: "" }, { document: document("toed-in", "color"), folder: "eyes.png" }]),
        [{ stereo: "toed-in", picture: "eyes.png" }]);
});
