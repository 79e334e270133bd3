import assert from "node:assert/strict";
import { test } from "node:test";
import { binomialP, chiSquared, chiSquaredP, median } from "../../../src/page/logic/statistics.js";

const near = (actual, expected, tolerance) =>
    assert.ok(Math.abs(actual - expected) <= tolerance, `${actual} is not ${expected} within ${tolerance}`);

test("chi-squared is Table 6.9's", () => {
    near(chiSquared(2, 10), 5.333, 5e-4);
    near(chiSquared(1, 11), 8.333, 5e-4);
    assert.equal(chiSquared(0, 12), 12);
    assert.equal(chiSquared(6, 6), 0);
});

test("the p of chi-squared is the tables' one, on both branches of erfc", () => {
    near(chiSquaredP(3.841458820694124), 0.05, 1e-12);
    near(chiSquaredP(6.634896601021213), 0.01, 1e-12);
    near(chiSquaredP(10.827566170662733), 0.001, 1e-13);
    near(chiSquaredP(0.45493642311957283), 0.5, 1e-12);
    assert.equal(chiSquaredP(0), 1);
    // Either side of where the branches meet, x = 2^2 * 2.
    near(chiSquaredP(8 - 1e-9) / chiSquaredP(8 + 1e-9), 1, 1e-8);
});

test("the exact p counts both tails", () => {
    near(binomialP(2, 10), 0.03857421875, 1e-15); // 2 (1 + 12 + 66) / 4096
    near(binomialP(1, 11), 0.00634765625, 1e-15);
    near(binomialP(0, 12), 0.00048828125, 1e-15);
    near(binomialP(12, 0), 0.00048828125, 1e-15);
    assert.equal(binomialP(6, 6), 1);
    assert.equal(binomialP(1, 0), 1);
});

test("the exact p of many answers does not underflow", () => {
    assert.equal(binomialP(600, 600), 1);
    assert.equal(binomialP(1_000_000, 1_000_000), 1);
    near(binomialP(5000, 5200) / chiSquaredP(199 ** 2 / 10_200), 1, 1e-3); // with Yates' correction
    assert.ok(binomialP(0, 1000) > 0 && binomialP(0, 2000) === 0);
});

test("without answers there is no p", () => {
    assert.ok(Number.isNaN(binomialP(0, 0)));
    assert.ok(Number.isNaN(chiSquared(0, 0)));
});

test("a median is the middle one, or the mean of the two there", () => {
    assert.equal(median([10, 9, 2]), 9);
    assert.equal(median([4, 1, 10, 2]), 3);
    assert.ok(Number.isNaN(median([])));
});
