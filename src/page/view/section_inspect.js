import { h, slot, table, techniqueLabel } from "./elements.js";
import { figure, length, sentence, share } from "./figures.js";

const kPairs = 12; // the JSON has all

/** @param {string} picture the heat map's file. */
export function fillInspect(document, picture) {
    slot("inspect", "advice").append(h("ol", { class: "advice" }, document.advice_parts.map((parts) => h("li", {}, sentence(parts)))));
    slot("inspect", "pairs").append(makePairs(document));
    slot("inspect", "table").append(makeTable(document));
    const { technique, format } = document.options;
    slot("inspect", "picture").append(h("img", {
        class: "picture", src: picture, alt: `The worst view under ${technique} with ${format}: red is wrong, orange wrong on an edge, magenta coplanar.`,
    }));
}

function makePairs({ pairs, pairs_found: found }) {
    return table(`Objects in front of each other, nearest for their distance first: ${Math.min(kPairs, pairs.length)} of ${found} pairs.`,
        ["In front", "behind it", "pixels", "gap", "at", "finding"],
        pairs.slice(0, kPairs).map((pair) => [
            h("span", {}, pair.front), pair.back, figure(pair.pixels), length(pair.gap), length(pair.at), pair.finding]));
}

function makeTable({ results, options }) {
    return table(`Share of wrong pixels off edges over ${options.views} views, coplanar ones left out.`,
        ["Technique", "format", "cascades", "undecided", "predicted wrong", "measured wrong"],
        results.map((row) => [
            techniqueLabel(row.technique), row.format.toUpperCase(), row.cascades,
            share(row.undecided_fraction), share(row.predicted_fraction), share(row.wrong_fraction)]));
}
