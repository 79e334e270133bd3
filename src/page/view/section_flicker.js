import { movedBoundaries, observerWins, pairRows, techniques } from "../logic/flicker.js";
import { list, number, percent } from "../logic/format.js";
import { table62, techniqueTitle, thesisTechniques } from "../logic/thesis.js";
import { h, slot, table, techniqueLabel, wideOnly } from "./elements.js";
import { figure, share } from "./figures.js";


export function fillFlicker(document, folder) {
    slot("flicker", "table").append(measures("Counted over all frames. FLIP is a published measure of how different two pictures look, 0 for equal; here against the same render with every pixel\u2019s object right.", techniques(document)));
    slot("flicker", "people").append(...people(document));
    slot("flicker", "boundary").append(...boundary(document));
    slot("flicker", "videos").append(...videos(document, folder));
}

/** The same with one tiny object beside the camera. */
export function fillNearObject(document) {
    slot("flicker", "near").append(
        h("h3", {}, "With something near the camera"),
        h("p", {}, nearSentence(document)),
        measures("The same field with a tiny object beside the camera.", techniques(document)));
}

function nearSentence(document) {
    const fitted = techniques(document).find((row) => row.technique === "standard-fitted");
    return "Many engines fit near and far to what is visible. One tiny object beside the camera takes that back" +
        (fitted ? `, and standard with a fitted range is wrong in ${percent(fitted.wrong_fraction)}` : "") +
        ": this is the case that tells techniques apart in practice.";
}

function measures(caption, rows) {
    return table(caption,
        ["Technique", "wrong", wideOnly("wrong pixels"), "flips per 1,000", "mean FLIP", wideOnly("cascades")],
        rows.map((row) => [
            techniqueLabel(row.technique), share(row.wrong_fraction), wideOnly(figure(row.wrong)),
            figure(row.flips_per_thousand), figure(row.mean_flip), wideOnly(row.cascades)]));
}

function boundary(document) {
    const cdr = techniques(document).find((row) => row.technique === "cdr");
    const moved = movedBoundaries(document);
    if (!cdr || moved.length === 0) {
        return [];
    }
    const found = moved.map((row) => `${percent(row.wrong_fraction)} with it ${row.technique === "cdr-before" ? "before" : "behind"}`);
    return [
        h("h3", {}, "Why CDR gains so little here"),
        h("p", {}, `The field stands a million units away, and 0.001 \u00b7 1000\u00b3 is a million exactly: CDR\u2019s boundary cuts the field in two. The far half starts a new cascade and is nearly right, the near half ends one and is nearly as bad as standard: ${percent(cdr.wrong_fraction)} wrong. With the boundary moved off the field, ${list(found)}.`),
    ];
}

function people(document) {
    const wins = observerWins(document);
    const rows = pairRows(document);
    return [
        h("h3", {}, "An ideal observer, and twelve people"),
        h("p", {}, "The observer takes, of each pair, the side with fewer flips. \u03c7\u00b2 is computed anew from the thesis\u2019 counts; twelve answers are few for its approximation, so the exact two-sided binomial p stands beside it."),
        table("Tables 6.3 to 6.9: what twelve people said flickers less, and what an observer takes who only counts flips.",
            ["Pair", "people", "observer takes", "agree", "\u03c7\u00b2 thesis", "\u03c7\u00b2 here", "p of \u03c7\u00b2", "exact p"],
            rows.map((row) => [
                `${techniqueTitle(row.left)} : ${techniqueTitle(row.right)}`, row.chosen.join(" : "), observed(row),
                row.couldJudge ? h("span", { class: row.agree ? "mark-good" : "mark-bad" }, row.agree ? "yes" : "no") : "",
                figure(row.chiSquared), figure(row.recomputed), figure(row.chiSquaredP), figure(row.exactP)])),
        table("Table 6.2: how often each was chosen. People: of 36 times shown to twelve. Observer: of 3 pairs.",
            ["", ...thesisTechniques.map(techniqueTitle)],
            [["People", ...thesisTechniques.map((name) => table62[name])], ["Observer", ...thesisTechniques.map((name) => wins[name] ?? 0)]]),
    ];
}

/** Blank where there is nothing to judge by. */
function observed(row) {
    const tie = row.couldJudge ? "neither" : "";
    return row.observer ? techniqueTitle(row.observer) : tie;
}

function videos(document, folder) {
    const heading = h("h3", {}, "See it yourself");
    if (!folder) {
        return [heading, h("p", { class: "notice" },
            "No videos: ffmpeg was not installed where this report was made. With it (Debian, Ubuntu: the package ffmpeg), ",
            h("code", {}, "cdr flicker --videos videos"), " in this folder makes them.")];
    }
    const { width, height, frames } = document.options;
    return [
        heading,
        h("p", {}, `The six videos of Table 6.1, ${frames} frames in 19 seconds each. Or take part: the experiment page shows them in random order on random sides, and counts.`),
        h("p", {}, h("a", { class: "button", href: "compare.html" }, "Take part in the experiment")),
        h("div", { class: "videos" }, pairRows(document).map((row) => h("figure", {},
            h("video", {
                src: `${folder}/${row.left}_${row.right}.mp4`, width: 2 * width, height, controls: true, muted: true, playsinline: true,
                loop: true, preload: "metadata", poster: `${folder}/${row.left}_${row.right}.png`, "aria-label": `${techniqueTitle(row.left)} on the left, ${techniqueTitle(row.right)} on the right`,
            }),
            h("figcaption", {}, `${techniqueTitle(row.left)}, left: ${number(row.flips[0])} flips. ${techniqueTitle(row.right)}, right: ${number(row.flips[1])} flips.`)))),
    ];
}
