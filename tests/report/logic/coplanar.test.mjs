import assert from "node:assert/strict";
import { test } from "node:test";
import { worstResult } from "../../../src/page/logic/coplanar.js";

test("the picture is that of the most wrong pixels, and there is none where all is right", () => {
    const none = { wrong: 20, picture: "none.png" };
    const offset = { wrong: 4, picture: "offset.png" };
    const layers = { wrong: 0 };
    assert.equal(worstResult({ results: [layers, offset, none] }).picture, "none.png");
    assert.equal(worstResult({ results: [layers] }), null);
});
