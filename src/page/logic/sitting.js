// A sitting: one person's run through the experiment, as plain data that survives a reload.

import { fromCsv, makeAnswer, makeTrials, toCsv, withoutRepeats } from "./trials.js";

/** @returns {{participant: string, seed: string, answers: object[]}} */
export function startSitting(participant, seed) {
    return { participant: plainText(participant) || "anonymous", seed: plainText(seed) || "0", answers: [] };
}

/** A short text that a spreadsheet takes for no formula, so that it reads from CSV as it was written. */
export function plainText(text) {
    const line = String(text).replace(/[\r\n]+/g, " ").replace(/^[\s=+@-]+/, "");
    return [...line].slice(0, 60).join("").trimEnd(); // no letter is cut in two
}

/** The trial that comes next, with its number from 1, or null when all are answered. */
export function nextTrial(sitting) {
    const trials = makeTrials(sitting.seed);
    const index = sitting.answers.length;
    return index < trials.length ? { ...trials[index], number: index + 1, of: trials.length } : null;
}

/** The sitting with one more answer. */
export function answered(sitting, { side, seconds, plays }) {
    const trial = nextTrial(sitting);
    const { participant, seed } = sitting;
    const answer = makeAnswer({ participant, seed, number: trial.number, trial, side, seconds, plays });
    return { ...sitting, answers: [...sitting.answers, answer] };
}

/** As text, to be kept. */
export function store(sitting) {
    return JSON.stringify({ participant: sitting.participant, seed: sitting.seed, csv: toCsv(sitting.answers) });
}

/** What was kept, or null when it is nothing this page wrote. */
export function restore(text) {
    try {
        const { participant, seed, csv } = JSON.parse(text);
        const sitting = { ...startSitting(participant, seed), answers: fromCsv(csv) };
        const trials = makeTrials(seed);
        const fits = sitting.answers.length <= trials.length && sitting.answers.every((answer, i) =>
            answer.left === trials[i].left && answer.right === trials[i].right);
        return fits ? sitting : null;
    } catch {
        return null;
    }
}

/** Answers of earlier sittings as they were kept with toCsv(); null when the text is no such thing, which must not be lost. */
export function restoreOthers(text) {
    try {
        return text ? fromCsv(text) : [];
    } catch {
        return null;
    }
}

/**
 * What was kept, for a page that asks for a seed.
 * @returns {{sitting: ?object, others: object[]}} the sitting to go on with, or null; and answers of earlier ones, in which a
 * kept sitting of another seed counts.
 */
export function reopen(kept, keptOthers, seed = null) {
    const last = restore(kept);
    const goesOn = last && (seed === null || last.seed === startSitting("", seed).seed);
    const earlier = last && !goesOn ? last.answers : [];
    return { sitting: goesOn ? last : null, others: withoutRepeats([...(restoreOthers(keptOthers) ?? []), ...earlier]) };
}

/** A seed of eight letters and digits from 40 random bits. */
export function freshSeed(bytes) {
    return [...bytes.slice(0, 8)].map((byte) => "abcdefghjkmnpqrstuvwxyz23456789"[byte % 31]).join("");
}
