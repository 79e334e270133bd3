import { statuses } from "../logic/verdicts.js";
import { h } from "./elements.js";

const badge = (status) => h("span", { class: `badge ${status}` }, statuses[status]);

/** The list at the top, each linked to its section. */
export function fillVerdicts(list, verdicts) {
    list.append(...verdicts.map((verdict) => h("li", {}, badge(verdict.status),
        h("div", {}, h("h3", {}, h("a", { href: `#${verdict.section}` }, verdict.what)), h("p", {}, verdict.sentence)))));
}

/** The verdicts of a section, under its heading. */
export function repeatInSections(verdicts) {
    for (const verdict of verdicts.toReversed?.() ?? [...verdicts].reverse()) {
        document.querySelector(`#${verdict.section} h2`)?.after(
            h("div", { class: "verdict" }, badge(verdict.status), " ", h("strong", {}, verdict.what), h("p", {}, verdict.sentence)));
    }
}
