import { h, slot, table, techniqueLabel } from "./elements.js";
import { length, sentence } from "./figures.js";

export function fillAdvise(document) {
    slot("advise", "advice").append(
        h("ol", { class: "advice" }, document.advice_parts.map((parts) => h("li", {}, sentence(parts)))),
        h("details", { class: "source" }, h("summary", {}, "Every technique and format"), h("div", {},
            table(["What resolves ", length(document.options.separation), " at ", length(document.options.at), "."],
                ["Technique", "format", "cascades", "resolves", "enough"],
                document.results.map((row) => [
                    techniqueLabel(row.technique), row.format.toUpperCase(),
                    row.cascades, length(row.predicted), row.suffices ? "yes" : "no"])))));
}
