import { number, percent } from "../logic/format.js";
import { binomialP } from "../logic/statistics.js";
import { techniqueTitles } from "../logic/thesis.js";
import { agreement, tally } from "../logic/trials.js";
import { h, table } from "./elements.js";

/** One person's answers beside the counter's and those of 2013. */
export function makeAgreement(comparedAnswers) {
    const title = (name) => (name === null ? "neither" : techniqueTitles[name]);
    const counts = comparedAnswers.some((answer) => answer.observer !== null);
    return [
        h("p", {}, h("strong", {}, agreement(comparedAnswers)), counts ? " The counter takes the side with fewer flips, pixel by pixel." : ""),
        table("What flickers less: what you said, and what others did.",
            ["Pair", "you", ...(counts ? ["counter"] : []), "2013"],
            comparedAnswers.map((answer) => [`${title(answer.left)} : ${title(answer.right)}`, title(answer.chosen),
                ...(counts ? [title(answer.observer)] : []), title(answer.people)])),
    ];
}

/**
 * Each pair again, now with names, and with what is wrong in red.
 * @param {object[]} pictures of the 2AFC scene, one for each technique; none: nothing is shown.
 */
export function makePairs(comparedAnswers, pictures, folder) {
    const of = (technique) => pictures.find((picture) => picture.technique === technique);
    const shown = comparedAnswers.filter((answer) => of(answer.left) && of(answer.right));
    return shown.length === 0 ? [] : [
        h("h3", {}, "The six pairs again, with their names"),
        h("p", {}, "One picture of each video. Red is what shows the wrong object, off edges; orange the same on edges. What flickers is red that moves."),
        h("ol", { class: "pairs" }, shown.map((answer) => h("li", {},
            h("p", {}, h("strong", {}, `${techniqueTitles[answer.left]} : ${techniqueTitles[answer.right]}.`),
                ` You chose ${techniqueTitles[answer.chosen]}.`),
            h("div", { class: "pair" }, [answer.left, answer.right].map((technique) => heatMap(of(technique), folder)))))),
    ];
}

function heatMap(picture, folder) {
    const note = `${techniqueTitles[picture.technique]}: ${percent(picture.wrong_fraction)} wrong`;
    return h("figure", {},
        h("img", { src: `${folder}/${picture.heat_map}`, alt: `The cubes under ${techniqueTitles[picture.technique]}, wrong pixels red: ${percent(picture.wrong_fraction)} off edges.`, loading: "lazy" }),
        h("figcaption", {}, note));
}

/** Counts per pair with both tests, the thesis' twelve people beside them. */
export function makeTally(answers) {
    const rows = tally(answers).map((row) => [
        `${techniqueTitles[row.pair.left]} : ${techniqueTitles[row.pair.right]}`,
        row.counts.join(" : "),
        Number.isFinite(row.chiSquared) ? number(row.chiSquared) : "",
        Number.isFinite(row.exactP) ? number(row.exactP) : "",
        row.pair.chosen.join(" : "),
        number(row.pair.chiSquared),
        number(binomialP(...row.pair.chosen)),
    ]);
    return table("How often each of a pair was said to flicker less, here and in 2013.",
        ["Pair", "here", "\u03c7\u00b2", "exact p", "2013", "\u03c7\u00b2", "exact p"], rows);
}
