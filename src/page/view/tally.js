import { fixed, probability } from "../logic/format.js";
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

/** Counts per pair with both tests, the thesis' twelve people beside them. */
export function makeTally(answers) {
    const rows = tally(answers).map((row) => [
        `${techniqueTitles[row.pair.left]} : ${techniqueTitles[row.pair.right]}`,
        row.counts.join(" : "),
        Number.isFinite(row.chiSquared) ? fixed(row.chiSquared, 3) : "",
        Number.isFinite(row.exactP) ? probability(row.exactP) : "",
        row.pair.chosen.join(" : "),
        fixed(row.pair.chiSquared, 3),
        probability(binomialP(...row.pair.chosen)),
    ]);
    return table("How often each of a pair was said to flicker less, here and in 2013.",
        ["Pair", "here", "\u03c7\u00b2", "exact p", "2013", "\u03c7\u00b2", "exact p"], rows);
}
