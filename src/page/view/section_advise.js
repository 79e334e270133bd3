import { number, withUnits } from "../logic/format.js";
import { techniqueTitles } from "../logic/thesis.js";
import { h, slot, table, techniqueLabel } from "./elements.js";

export function fillAdvise(document) {
    slot("advise", "advice").append(
        h("ol", { class: "advice" }, document.advice.map((line) => h("li", {}, withUnits(line)))),
        h("details", { class: "source" }, h("summary", {}, "Every technique and format"), h("div", {},
            table(`What resolves ${number(document.options.separation)} units at ${number(document.options.at, 8)}.`,
                ["Technique", "format", "cascades", "resolves", "enough"],
                document.results.map((row) => [
                    techniqueLabel(row.technique, techniqueTitles[row.technique] ?? row.technique), row.format.toUpperCase(),
                    row.cascades, number(row.predicted), row.suffices ? "yes" : "no"])))));
}
