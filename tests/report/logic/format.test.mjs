import assert from "node:assert/strict";
import { test } from "node:test";
import { duration, list, percent, powerOfTen, signedPercent } from "../../../src/page/logic/format.js";

const plain = (text) => text.replaceAll("\u00a0", " ");

test("differences have a sign and three digits", () => {
    assert.equal(plain(signedPercent(0)), "0 %");
    assert.equal(plain(signedPercent(-1.2649)), "\u22121.26 %");
    assert.equal(plain(signedPercent(7.1)), "+7.1 %");
    assert.equal(plain(signedPercent(539.21)), "+539 %");
    assert.equal(signedPercent(NaN), "none");
});

test("shares, durations, lists and ticks", () => {
    assert.equal(plain(percent(0.2664)), "26.64 %");
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
