// One person's run through the experiment, as plain data that survives a reload.

import { fromCsv, makeAnswer, makeTrials, toCsv } from "./trials.js";

/** @returns {{participant: string, seed: string, answers: object[]}} */
export function startSession(participant, seed) {
    return { participant: plainText(participant) || "anonymous", seed: plainText(seed) || "0", answers: [] };
}

/** A short text that a spreadsheet takes for no formula, so that it reads from CSV as it was written. */
export function plainText(text) {
    return String(text).replace(/^[\s=+@-]+|\s+$/g, "").slice(0, 60);
}

/** The trial that comes next, with its number from 1, or null when all are answered. */
export function nextTrial(session) {
    const trials = makeTrials(session.seed);
    const index = session.answers.length;
    return index < trials.length ? { ...trials[index], number: index + 1, of: trials.length } : null;
}

/** The session with one more answer. */
export function answered(session, { side, seconds, plays }) {
    const trial = nextTrial(session);
    const { participant, seed } = session;
    const answer = makeAnswer({ participant, seed, number: trial.number, trial, side, seconds, plays });
    return { ...session, answers: [...session.answers, answer] };
}

/** As text, to be kept. */
export function store(session) {
    return JSON.stringify({ participant: session.participant, seed: session.seed, csv: toCsv(session.answers) });
}

/** What was kept, or null when it is nothing this page wrote or belongs to another seed than the one asked for. */
export function restore(text, seed = null) {
    try {
        const { participant, seed: kept, csv } = JSON.parse(text);
        if (seed !== null && kept !== plainText(seed)) {
            return null;
        }
        const session = { ...startSession(participant, kept), answers: fromCsv(csv) };
        const trials = makeTrials(kept);
        const fits = session.answers.length <= trials.length && session.answers.every((answer, i) =>
            answer.left === trials[i].left && answer.right === trials[i].right);
        return fits ? session : null;
    } catch {
        return null;
    }
}

/** A seed of eight letters and digits from 40 random bits. */
export function freshSeed(bytes) {
    return [...bytes.slice(0, 8)].map((byte) => "abcdefghjkmnpqrstuvwxyz23456789"[byte % 31]).join("");
}
