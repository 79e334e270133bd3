// The cases that C++ is held to as well: one way of writing numbers in the viewer, the command line and the page.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { lengthIn, lengthUnits, number } from "../../../src/page/logic/format.js";

const { cases } = JSON.parse(readFileSync(new URL("../../base/quantities.json", import.meta.url), "utf8"));
const special = { nan: NaN, infinity: Infinity, "-infinity": -Infinity };

test("numbers and lengths are written as in the other programs", () => {
    assert.ok(cases.length > 40);
    for (const { value, unit, digits, typeset } of cases) {
        const size = typeof value === "string" ? special[value] : value;
        assert.equal(unit ? lengthIn(size, unit, digits) : number(size, digits), typeset, JSON.stringify({ value, unit, digits }));
    }
    assert.deepEqual(new Set(cases.map((each) => each.unit ?? "none")), new Set(lengthUnits));
});
