import assert from "node:assert/strict";
import { test } from "node:test";
import { answered, freshSeed, nextTrial, reopen, restore, restoreOthers, startSitting, store } from "../../../src/page/logic/sitting.js";
import { maxBytes, toCsv } from "../../../src/page/logic/trials.js";

const answerAll = (sitting) => {
    while (nextTrial(sitting)) {
        sitting = answered(sitting, { side: sitting.answers.length % 2 ? "left" : "right", seconds: 1, plays: 1 });
    }
    return sitting;
};

test("six answers end a sitting, numbered from 1", () => {
    const done = answerAll(startSitting(" Ada ", "s"));
    assert.equal(done.participant, "Ada");
    assert.deepEqual(done.answers.map((answer) => answer.trial), [1, 2, 3, 4, 5, 6]);
    assert.equal(nextTrial(done), null);
});

test("an answer names the technique that stood on the chosen side", () => {
    const sitting = startSitting("p", "s");
    const trial = nextTrial(sitting);
    assert.equal(answered(sitting, { side: "left", seconds: 0, plays: 1 }).answers[0].chosen, trial.left);
    assert.equal(answered(sitting, { side: "right", seconds: 0, plays: 1 }).answers[0].chosen, trial.right);
});

test("a reload goes on where it was", () => {
    let sitting = startSitting('A, "B"', "seed 1");
    sitting = answered(sitting, { side: "left", seconds: 2.5, plays: 3 });
    assert.deepEqual(restore(store(sitting)), sitting);
    assert.deepEqual(reopen(store(sitting), null, "seed 1").sitting, sitting);
    assert.equal(nextTrial(restore(store(sitting))).number, 2);
});

test("a page that asks for an empty seed goes on after a reload", () => {
    const sitting = startSitting("p", "");
    assert.deepEqual(reopen(store(sitting), null, "").sitting, sitting);
});

test("a name that looks like a formula reads from the file as it was written", () => {
    const done = answerAll(startSitting("=-1+cmd()", "@seed"));
    assert.equal(done.participant, "1+cmd()");
    assert.deepEqual(reopen(store(done), null, "@seed").sitting, done);
});

test("names of several lines or cut off at a space read as they are kept", () => {
    for (const name of ["a\nb", "a\r\n\nb", `${"x".repeat(59)} y`]) {
        const sitting = answered(startSitting(name, name), { side: "left", seconds: 1, plays: 1 });
        assert.deepEqual(restore(store(sitting)), sitting);
    }
});

test("what another page or another seed left is not taken", () => {
    const kept = store(answerAll(startSitting("p", "a")));
    assert.equal(reopen(kept, null, "b").sitting, null);
    for (const text of [null, "", "{}", "[1]", "null", '{"participant":1,"seed":2,"csv":3}', kept.replace('"seed":"a"', '"seed":"c"')]) {
        assert.equal(restore(text), null);
    }
});

test("answers of an earlier sitting outlive one of another seed", () => {
    const first = answerAll(startSitting("Ada", "a"));
    const second = answered(startSitting("Bea", "b"), { side: "left", seconds: 1, plays: 1 });
    assert.deepEqual(reopen(store(first), null), { sitting: first, others: [] });
    assert.deepEqual(reopen(store(first), null, "b"), { sitting: null, others: first.answers });
    const kept = toCsv(first.answers);
    assert.deepEqual(reopen(store(second), kept, "b"), { sitting: second, others: first.answers });
    assert.deepEqual(reopen(store(second), kept, "c"), { sitting: null, others: [...first.answers, ...second.answers] });
    assert.deepEqual(reopen(store(first), kept, "c"), { sitting: null, others: first.answers }); // once
    assert.deepEqual([null, ""].map(restoreOthers), [[], []]);
    assert.equal(restoreOthers("no answers"), null);
    assert.deepEqual(reopen(null, "no answers"), { sitting: null, others: [] });
});

test("answers that were kept are read however many they are", () => {
    const { answers } = answerAll(startSitting("Ada", "a"));
    const many = [...Array(20_000).keys()].map((i) => ({ ...answers[i % 6], participant: `person number ${i}` }));
    const text = toCsv(many);
    assert.ok(text.length > maxBytes);
    assert.deepEqual(restoreOthers(text), many);
});

test("a name cannot be endless, an empty one is anonymous", () => {
    assert.equal(startSitting("x".repeat(999), 1).participant.length, 60);
    assert.equal(startSitting("  ", 1).participant, "anonymous");
    assert.match(freshSeed(new Uint8Array([0, 31, 255, 7, 9, 200, 100, 3])), /^[a-z2-9]{8}$/);
});
