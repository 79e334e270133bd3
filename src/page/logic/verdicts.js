// For each table and figure of the thesis: does it reproduce, and if not, why. Every sentence is computed from the
// results, so another device gets other sentences.

import { observerWins, pairRows, techniques } from "./flicker.js";
import { duration, list, number, percent, signedPercent } from "./format.js";
import { find } from "./pictures.js";
import { checkPercentages, tableRows, worstCell } from "./precision.js";
import { listingReliability, reliability } from "./probe.js";
import { table62, techniqueTitle, techniqueTitles, thesisTechniques } from "./thesis.js";
import { noiseFloor, rankAgreement, thesisBars } from "./timing.js";

/** What a verdict can be, and how it reads. What people answered cannot be repeated here, only agreed with. */
export const statuses = {
    yes: "reproduces",
    consistent: "consistent",
    partly: "in part",
    no: "does not",
    open: "undecided",
    missing: "not measured",
};

const kTooWide = 10; // percentage points of an interval that tells nothing
const kTooFew = 10; // frames from which no interval can be drawn

const titles = (names) => list(names.map(techniqueTitle));

/**
 * All verdicts in the thesis' order.
 * @param {object} sections documents by name; null for what failed.
 * @returns {{id: string, what: string, section: string, status: string, sentence: string}[]}
 */
export function verdicts(sections) {
    return [
        judge("table-4-1", "Table 4.1 and Figure 4.1", "precision", sections.precision, judgeTable41),
        judge("percentages", "\u201c\u2026 percent further\u201d, chapters 4 and 8", "precision", sections.precision, judgePercentages),
        judge("figures-6", "Figures 6.1 to 6.3", "pictures", sections.pictures, judgePictures),
        judge("order", "Order of quality, section 6.1", "flicker", sections.flicker, judgeOrder),
        judge("table-6-2", "Tables 6.2 to 6.8", "flicker", sections.flicker, judgePeople),
        judge("table-6-9", "Table 6.9", "flicker", sections.flicker ?? { results: [] }, judgeChiSquared),
        judge("figure-6-4", "Figure 6.4", "timing", sections.timing, judgeTiming),
        judge("chapter-7", "\u201cNot reliable in practice\u201d, chapter 7", "probe", sections.probe, judgeProbe),
    ];
}

function judge(id, what, section, document, rule) {
    const missing = { status: "missing", sentence: "This report holds no results of it; the section says why." };
    return { id, what, section, ...(document ? rule(document) : missing) };
}

function judgeTable41(document) {
    const cells = tableRows(document).flatMap((row) => row.cells);
    const off = cells.filter((cell) => cell.differencePct === null || Math.abs(cell.differencePct) > 0.1);
    const worst = worstCell(document);
    if (!worst) {
        return { status: "missing", sentence: "Only near 0.001 and far 10\u2078 have values in the thesis." };
    }
    const most = `the largest difference is ${number(Math.abs(worst.differencePct), 2)}\u202f%, ${techniqueTitles[worst.technique]} at ${number(worst.thesis)}`;
    return off.length === 0
        ? { status: "yes", sentence: `All ${cells.length} distances agree within 0.1\u202f%: ${most}.` }
        : { status: off.length < cells.length / 2 ? "partly" : "no",
            sentence: `${off.length} of ${cells.length} distances differ by more than 0.1\u202f%: ${most}.` };
}

function judgePercentages() {
    const claims = checkPercentages();
    const wrong = claims.filter((claim) => !claim.agrees);
    const corrections = wrong.map((claim) =>
        `${techniqueTitles[claim.of]} over ${techniqueTitles[claim.over]} is ${number(claim.fromTable)}\u202f%, not the ${number(claim.percent)}\u202f% of the ${claim.where}`);
    const kept = claims.length - wrong.length;
    return {
        status: wrong.length === 0 ? "yes" : "partly",
        sentence: `${kept} of the ${claims.length} percentages follow from the thesis\u2019 own Table 4.1` +
            (wrong.length ? `; by that table, ${list(corrections)}.` : "."),
    };
}

function judgePictures(document) {
    const [standard, log, cdr] = ["standard", "log", "cdr"].map((name) => find(document, "cubes", name));
    if (!standard || !log || !cdr) {
        return { status: "missing", sentence: "The scene cubes was not drawn with all three techniques." };
    }
    if ([standard.overlap_wrong_fraction, log.wrong_fraction, cdr.wrong_fraction].includes(null)) {
        return { status: "open", sentence: "The pictures of cubes are too small: they have no pixels off edges to judge by." };
    }
    const bad = standard.overlap_wrong_fraction;
    const good = [log, cdr].every((row) => row.wrong_fraction < 0.001);
    const rest = `Logarithmic is wrong in ${percent(log.wrong_fraction)} and CDR in ${percent(cdr.wrong_fraction)} of all pixels off edges`;
    const first = `Standard shows the wrong cube in ${percent(bad)} of the pixels where cubes overlap`;
    if (bad > 0.5 && good) {
        return {
            status: "yes",
            sentence: `${first} (\u201cabout every fragment\u201d is a little strong: an exhausted buffer still hits by luck); ${rest}.`,
        };
    }
    return { status: bad > 0.5 || good ? "partly" : "no", sentence: `${first}; ${rest}.` };
}

function judgeOrder(document) {
    const rows = thesisTechniques.map((name) => techniques(document).find((row) => row.technique === name));
    if (rows.some((row) => !row)) {
        return { status: "missing", sentence: "Not all four techniques were measured." };
    }
    if (rows.some((row) => row.wrong_fraction === null)) {
        return { status: "open", sentence: "The frames are too small: they have no pixels off edges to judge by." };
    }
    const share = (row) => `${techniqueTitles[row.technique]} ${percent(row.wrong_fraction)}`;
    const kept = rows.slice(1).filter((row, i) => row.wrong_fraction < rows[i].wrong_fraction).length;
    const sentence = `Wrong pixels off edges: ${list(rows.map(share))}`;
    if (kept === 3) {
        return { status: "yes", sentence: `${sentence}: each better than the one before, as the thesis found.` };
    }
    return { status: kept > 0 ? "partly" : "no", sentence: `${sentence}: ${kept} of 3 steps go the thesis\u2019 way.` };
}

function judgePeople(document) {
    const rows = pairRows(document);
    const agreeing = rows.filter((row) => row.agree).length;
    const apart = rows.filter((row) => !row.agree);
    if (rows.every((row) => row.flips.includes(null))) {
        return { status: "missing", sentence: "Not all four techniques were measured." };
    }
    if (rows.every((row) => !row.couldJudge)) {
        return { status: "open", sentence: "No pixel off edges shows the same object in two frames that follow each other, so none can flip." };
    }
    if (rows.every((row) => row.observer === null)) {
        return { status: "open", sentence: `In ${document.options.frames} frames every pair flips equally often: too few to choose.` };
    }
    const wins = observerWins(document);
    const order = Object.keys(table62).sort((a, b) => table62[a] - table62[b]);
    const sameOrder = order.every((name, i) => i === 0 || wins[order[i - 1]] < wins[name]); // a tie ranks nothing
    let sentence = `The thesis asked twelve people; here nobody was asked. An observer who only counts flips chooses as most people did in ${agreeing} of ${rows.length} pairs`;
    sentence += sameOrder ? " and ranks the techniques as they did." : ".";
    for (const row of apart) {
        sentence += ` ${explainDisagreement(row, document)}`;
    }
    return { status: agreeing === rows.length ? "consistent" : agreeing > 0 ? "partly" : "no", sentence };
}

/** Why counting flips and looking may choose differently: wrong pixels that stay put do not flicker. */
function explainDisagreement(row, document) {
    const name = `${techniqueTitles[row.left]} and ${techniqueTitles[row.right]}`;
    if (!row.couldJudge) {
        return `${name} cannot be compared: no pixel off edges could flip.`;
    }
    if (!row.observer) {
        return `${name} flip equally often.`;
    }
    const wrong = (technique) => techniques(document).find((r) => r.technique === technique)?.wrong_fraction ?? 0;
    const other = row.observer === row.left ? row.right : row.left;
    const more = wrong(row.observer) > wrong(other);
    return `Of ${name} people chose ${techniqueTitles[row.people]}, though ${techniqueTitles[row.observer]} flips less` +
        (more ? `: it has more wrong pixels (${percent(wrong(row.observer))} against ${percent(wrong(other))}), but they stay put.` : ".");
}

function judgeChiSquared(document) {
    const rows = pairRows(document);
    const off = rows.filter((row) => Math.abs(row.recomputed - row.chiSquared) > 0.0005);
    const weakest = rows.reduce((a, b) => (b.exactP > a.exactP ? b : a));
    const insignificant = rows.filter((row) => row.exactP >= 0.05);
    const exact = insignificant.length === 0
        ? `the exact binomial test, right for twelve answers, also finds all six significant; the weakest is ${techniqueTitles[weakest.left]} against ${techniqueTitles[weakest.right]}, p = ${number(weakest.exactP)} where the approximation says ${number(weakest.chiSquaredP)}`
        : `by the exact binomial test ${titles(insignificant.flatMap((row) => [row.left, row.right]))} do not differ significantly`;
    return off.length === 0
        ? { status: "yes", sentence: `All six \u03c7\u00b2 follow from the counts; ${exact}.` }
        : { status: "no", sentence: `${off.length} of six \u03c7\u00b2 do not follow from the counts; ${exact}.` };
}

function judgeTiming(document) {
    const bars = thesisBars(document);
    const noise = noiseFloor(document);
    if (bars.length === 0) {
        return { status: "missing", sentence: "None of the thesis\u2019 modes was timed." };
    }
    const tau = rankAgreement(bars);
    const order = `the rank order agrees with Kendall\u2019s \u03c4\u00a0=\u00a0${number(tau, 2)}, and standard over itself gives ${signedPercent(noise.overhead)}`;
    if ([noise, ...bars].some((bar) => bar.low === null)) {
        const frames = document.options.frames;
        return { status: "open", sentence: `${frames} ${frames === 1 ? "frame is" : "frames are"} too few for an interval: ${order}.` };
    }
    const inside = bars.filter((bar) => bar.agrees);
    const widest = Math.max(...bars.map((bar) => bar.high - bar.low));
    const facts = `${inside.length} of ${bars.length} of the thesis\u2019 overheads lie in our 95\u202f% intervals, ${order} (${signedPercent(noise.low)} to ${signedPercent(noise.high)})`;
    if (widest > kTooWide || document.options.frames < kTooFew) {
        return {
            status: "open",
            sentence: `${document.options.frames} frames are too few to tell: intervals are up to ${number(widest, 2)} points wide. ${facts}.`,
        };
    }
    const where = `A Quadro 4000 and ${document.device.name || "this device"} share neither rasteriser nor driver, so only sign and order can be expected to carry over`;
    if (inside.length === bars.length) {
        return { status: "yes", sentence: `${facts}.` };
    }
    return { status: inside.length > 0 || tau > 0.5 ? "partly" : "no", sentence: `${facts}. ${where}.` };
}

function judgeProbe(document) {
    const formulas = listingReliability(document);
    if (formulas.all === 0) {
        return { status: "open", sentence: "No D24 case of the thesis\u2019 techniques was resolved, so its formulas cannot be judged." };
    }
    const found = `Of ${formulas.all} resolved D24 ${formulas.all === 1 ? "case" : "cases"} ${formulas.coarser} ${areOf(formulas.coarser)} coarser than the thesis\u2019 formulas (Listing A.2) say`;
    const sentence = formulas.coarser === 0 ? `${found}. ${forecastSentence(document)}` :
        `${found}, the worst by a factor of ${number(formulas.worstRatio, 2)}: depth fights before the formula says so, as the thesis saw. ${forecastSentence(document)}`;
    const status = formulas.coarser > formulas.all / 2 ? "yes" : formulas.coarser > 0 ? "partly" : "no";
    return { status, sentence };
}

/** What helps: a formula that knows the vertex. */
function forecastSentence(document) {
    const { within, coarser, finer, all, worstRatio, missed, beyondBound } = reliability(document);
    return `Our forecast adds float32\u2019s rounding of the vertex to the buffer\u2019s step: of the ${all} resolved cases in all formats ${within} lie within a factor of two of it, ${coarser} ${areOf(coarser)} coarser, ${finer} finer` +
        (coarser ? `, the worst by a factor of ${number(worstRatio, 2)}` : "") +
        (missed ? `; ${missed} more ${areOf(missed)} forecast to resolve and ${missed === 1 ? "does" : "do"} not` : "") +
        (beyondBound === null ? "." : `; ${beyondBound === 0 ? "none is" : `${beyondBound} ${areOf(beyondBound)}`} coarser than the bound that takes every rounding at its worst.`);
}

const areOf = (count) => (count === 1 ? "is" : "are");

/** The whole report in a sentence. */
export function summary(list, seconds) {
    const count = (status) => list.filter((verdict) => verdict.status === status).length;
    const judged = list.length - count("missing");
    const consistent = count("consistent");
    return `${count("yes")} of ${judged} results of the thesis reproduce, ${count("partly")} in part` +
        (consistent ? `; what people answered is consistent with what was counted` : "") + `; measured in ${duration(seconds)}.`;
}
