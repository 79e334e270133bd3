// The experiment on people: which pair is shown when, on which side, and what the answers add up to.

import { formatRow, parseRows } from "./csv.js";
import { randomFrom, shuffled } from "./random.js";
import { binomialP, chiSquared, chiSquaredP } from "./statistics.js";
import { pairs } from "./thesis.js";

/** Columns of an answer, in order. */
export const columns = ["participant", "seed", "trial", "left", "right", "side", "chosen", "seconds", "plays"];

/** Largest file of answers that a person may add, bytes. What the page kept may be larger. */
export const maxBytes = 1_000_000;

/**
 * The six pairs in random order, each on random sides; the same for the same seed.
 * @returns {{pair: object, mirrored: boolean, left: string, right: string}[]} `mirrored`: sides swapped.
 */
export function makeTrials(seed) {
    const random = randomFrom(seed);
    return shuffled(pairs, random).map((pair) => {
        const mirrored = random() < 0.5;
        return {
            pair,
            mirrored,
            left: mirrored ? pair.right : pair.left,
            right: mirrored ? pair.left : pair.right,
        };
    });
}

/** The answer to a trial: `side` is "left" or "right". */
export function makeAnswer({ participant, seed, number, trial, side, seconds, plays }) {
    return {
        participant,
        seed: String(seed),
        trial: number,
        left: trial.left,
        right: trial.right,
        side,
        chosen: trial[side],
        seconds: Math.round(seconds * 10) / 10,
        plays,
    };
}

/** A file of answers. */
export function toCsv(answers) {
    const rows = answers.map((answer) => columns.map((column) => answer[column]));
    return [columns, ...rows].map(formatRow).join("\r\n") + "\r\n";
}

/**
 * Reads a file of answers. Anyone may have written it.
 * @throws {Error} one line saying what is wrong with it.
 */
export function fromCsv(text) {
    const [header, ...rows] = parseRows(text);
    if (!header || header.join() !== columns.join()) {
        throw new Error(`not answers of this experiment: its first line must be ${columns.join(",")}`);
    }
    return rows.map((row, index) => {
        const answer = Object.fromEntries(columns.map((column, i) => [column, row[i]]));
        requireSound(answer, row.length, index + 2);
        return { ...answer, trial: Number(answer.trial), seconds: Number(answer.seconds), plays: Number(answer.plays) };
    });
}

/** Answers without those that are there already: the same participant, seed and pair twice counts once. */
export function withoutRepeats(answers) {
    const seen = new Set();
    return answers.filter((answer) => {
        const key = JSON.stringify([answer.participant, answer.seed, [answer.left, answer.right].sort()]);
        return !seen.has(key) && seen.add(key);
    });
}

/** Per pair of the thesis: both counts, chi-squared, its p, and the exact p. */
export function tally(answers) {
    return pairs.map((pair) => {
        const shown = answers.filter((answer) => samePair(answer, pair));
        const counts = [pair.left, pair.right].map((name) => shown.filter((answer) => answer.chosen === name).length);
        const x = chiSquared(...counts);
        return { pair, counts, chiSquared: x, chiSquaredP: chiSquaredP(x), exactP: binomialP(...counts) };
    });
}

/**
 * A person's answers beside what others chose of the same pairs.
 * @param {object[]} rows of pairRows(): `observer` counts flips, null where it has no choice; `people` are those of 2013.
 */
export function compared(answers, rows) {
    return answers.map((answer) => {
        const { observer, people } = rows.find((row) => samePair(answer, row));
        return { ...answer, observer, people };
    });
}

/** How often a person chose as the observer that counts flips, and as most people in 2013. */
export function agreement(comparedAnswers) {
    const counted = comparedAnswers.filter((answer) => answer.observer !== null);
    const withCounter = counted.filter((answer) => answer.chosen === answer.observer).length;
    const withPeople = comparedAnswers.filter((answer) => answer.chosen === answer.people).length;
    const majority = `with the majority of 2013 in ${withPeople} of ${comparedAnswers.length}`;
    return counted.length === 0 ? `You agreed ${majority}.`
        : `You agreed with the counter in ${withCounter} of ${counted.length}, and ${majority}.`;
}

function samePair(answer, pair) {
    return (
        (answer.left === pair.left && answer.right === pair.right) ||
        (answer.left === pair.right && answer.right === pair.left)
    );
}

function requireSound(answer, fields, line) {
    const sound =
        fields === columns.length &&
        pairs.some((pair) => samePair(answer, pair)) &&
        (answer.side === "left" || answer.side === "right") &&
        answer.chosen === answer[answer.side] &&
        [answer.trial, answer.seconds, answer.plays].every((text) => text !== "" && Number.isFinite(Number(text)));
    if (!sound) {
        throw new Error(`line ${line} is not an answer of this experiment`);
    }
}
