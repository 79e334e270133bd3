import assert from "node:assert/strict";
import { test } from "node:test";
import { formatRow, parseRows } from "../../../src/page/logic/csv.js";
import { randomFrom, shuffled } from "../../../src/page/logic/random.js";
import { pairRows } from "../../../src/page/logic/flicker.js";
import { pairs, table62, thesisTechniques } from "../../../src/page/logic/thesis.js";
import { agreement, columns, compared, fromCsv, makeAnswer, makeTrials, tally, toCsv, withoutRepeats } from "../../../src/page/logic/trials.js";

const pairName = (pair) => `${pair.left}-${pair.right}`;
const answersOf = (seed, participant, side = "left") =>
    makeTrials(seed).map((trial, number) =>
        makeAnswer({ participant, seed, number: number + 1, trial, side, seconds: 1.23, plays: 1 }));

test("a seed repeats the trials, another gives others", () => {
    assert.deepEqual(makeTrials("a"), makeTrials("a"));
    const orders = new Set([...Array(40).keys()].map((seed) => makeTrials(seed).map((t) => pairName(t.pair)).join()));
    assert.ok(orders.size > 30, `${orders.size} orders of 40 seeds`);
});

test("every pair is shown once, on either side about as often", () => {
    let mirrored = 0;
    for (let seed = 0; seed < 500; ++seed) {
        const trials = makeTrials(seed);
        assert.equal(new Set(trials.map((trial) => pairName(trial.pair))).size, 6);
        mirrored += trials.filter((trial) => trial.mirrored).length;
        for (const trial of trials) {
            assert.deepEqual(trial.mirrored ? [trial.right, trial.left] : [trial.left, trial.right],
                             [trial.pair.left, trial.pair.right]);
        }
    }
    assert.ok(Math.abs(mirrored / 3000 - 0.5) < 0.04, `${mirrored} of 3000 mirrored`);
});

test("every position holds every pair equally often", () => {
    const counts = new Map();
    for (let seed = 0; seed < 1200; ++seed) {
        makeTrials(`seed ${seed}`).forEach((trial, place) => {
            const key = `${place} ${pairName(trial.pair)}`;
            counts.set(key, (counts.get(key) ?? 0) + 1);
        });
    }
    assert.equal(counts.size, 36);
    // 200 each expected; 5 standard deviations of the binomial are 65.
    for (const [key, count] of counts) {
        assert.ok(Math.abs(count - 200) < 65, `${key}: ${count}`);
    }
});

test("random numbers are uniform enough and shuffling keeps all", () => {
    const random = randomFrom(1);
    const numbers = Array.from({ length: 4000 }, random);
    assert.ok(numbers.every((x) => x >= 0 && x < 1));
    assert.ok(Math.abs(numbers.reduce((a, b) => a + b) / 4000 - 0.5) < 0.03);
    assert.deepEqual(shuffled([1, 2, 3], random).sort(), [1, 2, 3]);
});

test("answers survive CSV", () => {
    const answers = answersOf(7, 'O"Neil, the 2nd', "right");
    assert.deepEqual(fromCsv(toCsv(answers)), answers);
    assert.deepEqual(fromCsv("\ufeff" + toCsv(answers).replaceAll("\r\n", "\n")), answers);
});

test("CSV keeps empty and quoted fields, and defuses formulas", () => {
    assert.deepEqual(parseRows('a,,"b ""c"", d"\r\n,\n'), [["a", "", 'b "c", d'], ["", ""]]);
    assert.equal(formatRow(["=SUM(A1)", -1.5, "a\nb"]), "'=SUM(A1),-1.5,a b");
});

test("a file that is no file of answers is refused in one line", () => {
    const good = toCsv(answersOf(7, "p"));
    for (const bad of ["", "a,b\n1,2\n", good.replace("cdr", "chrome"), good.replace(/,left,/, ",up,"),
                       good.replace(/,1\r\n/, ",\r\n"), good.replace(/,1\r\n/, ",1,9\r\n")]) {
        assert.throws(() => fromCsv(bad), (error) => !error.message.includes("\n") && error.message.length > 10);
    }
    const lines = good.split("\r\n");
    const swapped = lines[1].split(",");
    swapped[columns.indexOf("chosen")] = swapped[columns.indexOf("right")]; // says left, chose right
    assert.throws(() => fromCsv([lines[0], swapped.join(",")].join("\n")), /line 2/);
});

test("the thesis' own answers give its own statistics", () => {
    const answers = [];
    for (const pair of pairs) {
        pair.chosen.forEach((times, index) => {
            for (let i = 0; i < times; ++i) {
                const side = ["left", "right"][index];
                answers.push(makeAnswer({ participant: `${side}${i}`, seed: 0, number: 1, trial: pair, side, seconds: 0, plays: 1 }));
            }
        });
    }
    for (const row of tally(answers)) {
        assert.deepEqual(row.counts, row.pair.chosen);
        assert.ok(Math.abs(row.chiSquared - row.pair.chiSquared) < 5e-4);
    }
    for (const name of thesisTechniques) {
        assert.equal(answers.filter((answer) => answer.chosen === name).length, table62[name]);
    }
});

test("mirrored answers count for the technique, not for the side", () => {
    const all = [...Array(20).keys()].flatMap((seed) => answersOf(seed, "p", "left"));
    for (const row of tally(all)) {
        assert.equal(row.counts[0] + row.counts[1], 20);
        assert.ok(row.counts[0] > 0 && row.counts[1] > 0);
    }
});

test("the same file twice counts once, another participant counts", () => {
    const mine = answersOf(7, "p");
    assert.equal(withoutRepeats([...mine, ...mine]).length, 6);
    assert.equal(withoutRepeats([...mine, ...answersOf(7, "q")]).length, 12);
});

test("a person's answers are compared with the counter's and those of 2013", () => {
    const flips = { standard: 90, cdr: 60, log: 40, logcdr: 40 };
    const rows = pairRows({ results: Object.entries(flips).map(([technique, count]) => ({ technique, flips: count })) });
    const answers = makeTrials("x").map((trial, i) =>
        makeAnswer({ participant: "p", seed: "x", number: i + 1, trial, side: trial.left === trial.pair.left ? "right" : "left", seconds: 1, plays: 1 }));
    // Always the better technique: as all of 2013 did, and as the counter where it has a choice.
    assert.equal(agreement(compared(answers, rows)), "You agreed with the counter in 5 of 5, and with the majority of 2013 in 6 of 6.");
    const first = answers[0];
    const other = first.side === "left" ? "right" : "left";
    const turned = [{ ...first, side: other, chosen: first[other] }, ...answers.slice(1)];
    assert.match(agreement(compared(turned, rows)), /in 5 of 6\.$/);
    assert.equal(agreement(compared(answers, pairRows({ results: [] }))), "You agreed with the majority of 2013 in 6 of 6.");
});
