import assert from "node:assert/strict";
import { test } from "node:test";
import { duration, fixed, list, number, percent, powerOfTen, signedPercent, withUnits } from "../../../src/page/logic/format.js";

const plain = (text) => text.replaceAll("\u202f", " ");

test("numbers keep their digits, from tiny to huge", () => {
    assert.equal(plain(number(3643125.454, 10)), "3,643,125.454");
    assert.equal(number(4.096, 4), "4.096");
    assert.equal(number(0.00012345), "0.000123");
    assert.equal(number(0.0000043, 2), "4.3·10⁻⁶");
    assert.equal(number(1e8), "1·10⁸");
    assert.equal(number(-1234.5, 2), "\u22121,235");
    assert.equal(number(0), "0");
    assert.equal(number(0.999999), "1");
    for (const absent of [null, undefined, NaN, Infinity]) {
        assert.equal(number(absent), "none");
    }
});

test("lengths in sentences of the program get units, and counts do not", () => {
    assert.equal(withUnits("anchored with d24 in 2 cascades is enough: it resolves 7.1234567e-06 at 1e+06, and 0.01 is asked for."),
        "anchored with d24 in 2 cascades is enough: it resolves 7.123\u00b710\u207b\u2076 units at 1,000,000 units, and 0.01 units is asked for.");
    assert.equal(withUnits("Cost: float64 offset per object, 1 more depth clear."), "Cost: float64 offset per object, 1 more depth clear.");
});

test("a rounded zero has no sign", () => {
    assert.equal(fixed(-0.001, 1), "0.0");
    assert.equal(plain(signedPercent(-0.001)), "+0.0 %");
    assert.equal(plain(signedPercent(-1.26)), "\u22121.3 %");
    assert.equal(plain(signedPercent(7.1)), "+7.1 %");
});

test("shares, durations, lists and ticks", () => {
    assert.equal(plain(percent(0.2664)), "26.6 %");
    assert.equal(plain(percent(1e-6, 1)), "0.0001 %");
    assert.equal(plain(duration(4.24)), "4.2 s");
    assert.equal(plain(duration(0.0009)), "under 0.1 s");
    assert.equal(plain(duration(119.7)), "2 min 0 s");
    assert.equal(plain(duration(3 * 3600 + 125)), "3 h 2 min");
    assert.equal(list(["a"]), "a");
    assert.equal(list(["a", "b", "c"]), "a, b and c");
    assert.equal(powerOfTen(1e-3), "0.001");
    assert.equal(powerOfTen(1000), "1000");
    assert.equal(powerOfTen(1e-7), "10⁻⁷");
});
