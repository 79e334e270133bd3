// How a section was measured, and how to measure it again.

import { duration } from "../logic/format.js";
import { h, slot } from "./elements.js";

export function fillSource(row, document, report) {
    const device = document?.device?.name ? `${document.device.name}, ${document.device.driver}` : "no device: arithmetic alone";
    sourceOf(row.section).append(h("details", { class: "source" },
        h("summary", {}, `Repeat ${row.section}: measured in ${duration(row.seconds)}`),
        h("div", {},
            h("pre", {}, h("code", {}, row.command)),
            h("p", {}, `On ${device}; ${describeRepeats(document)}cdr ${report.version}, commit ${report.commit}. `,
                row.json ? h("a", { href: row.json }, `The results as JSON`) : "There is no JSON."))));
}

/** A section that failed says why instead of showing half of itself. */
export function fillFailure(row) {
    sourceOf(row.section).before(h("p", { class: "notice", role: "note" }, row.json
        ? `Something went wrong here: ${row.failure}.`
        : `This experiment failed, so there is nothing to show: ${row.failure}.`));
}

/** Where a section says how it was measured: at its end. */
function sourceOf(section) {
    const part = partOf(section);
    return slot(part, "source") ?? document.getElementById(part).appendChild(h("div", { "data-slot": "source" }));
}

/** The part of the page that a section fills: "flicker" for "flicker-near", too. */
export function partOf(section) {
    return section.split("-")[0];
}

function describeRepeats(document) {
    const { frames, repeats } = document?.options ?? {};
    if (frames) {
        return `${frames} ${frames === 1 ? "frame" : "frames"}; `;
    }
    return repeats ? `${repeats} repeats; ` : "";
}
