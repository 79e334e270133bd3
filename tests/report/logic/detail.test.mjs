import assert from "node:assert/strict";
import { test } from "node:test";
import { titles } from "../../../src/page/view/section_detail.js";

test("every way to choose levels of detail has a title", () => {
    for (const mode of ["none", "object", "cascade", "cluster", "none-again"]) {
        assert.match(titles[mode] ?? "", /^(In full|By)/, mode);
    }
});
