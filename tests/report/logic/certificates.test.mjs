import assert from "node:assert/strict";
import { test } from "node:test";
import { certifiedRow } from "../../../src/page/logic/certificates.js";

const frame = (certifyMs, executeMs, extra) => ({
    technique: "standard", cull_ms: 1, split_ms: 5, occluders_ms: 2, shadows_ms: 6, bin_ms: 3, translucent_ms: 7, record_ms: 4,
    execute_ms: executeMs,
    wrong: 0, edge_wrong: 0, certified: 70, proven: 20, cast: 30, wrong_before: 8, repaired: 10, refused: 0, certify_ms: certifyMs, ...extra });
const document = (results) => ({ options: { scene: "afc", width: 10, height: 10 }, results });

test("a certificate's shares are of all pixels of all frames, and its times medians", () => {
    assert.deepEqual(certifiedRow(document([frame(50, 100), frame(2, 10, { certified: 90, cast: 10, repaired: 0 }), frame(4, 20)])), {
        scene: "afc", technique: "standard", certified: 230 / 300, proven: 60 / 300, cast: 70 / 300, repaired: 20 / 300,
        wrongBefore: 24, wrongAfter: 0, refused: 0, frameMs: 48, certifyMs: 4 });
});

test("what is wrong after repair counts on edges too", () => {
    assert.equal(certifiedRow(document([frame(1, 1, { wrong: 2, edge_wrong: 3 }), frame(1, 1)])).wrongAfter, 5);
});

test("where a frame was refused, what rays would have found is not known", () => {
    const row = certifiedRow(document([frame(1, 1), frame(1, 1, { refused: 2, cast: null, wrong_before: null, repaired: null })]));
    assert.deepEqual([row.cast, row.wrongBefore, row.repaired, row.refused], [null, null, null, 2]);
});
