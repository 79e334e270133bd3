import { fixed, probability } from "../logic/format.js";
import { binomialP } from "../logic/statistics.js";
import { techniqueTitles } from "../logic/thesis.js";
import { tally } from "../logic/trials.js";
import { table } from "./elements.js";

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
