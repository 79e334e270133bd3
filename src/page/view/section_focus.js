import { number } from "../logic/format.js";
import { modesOrWorst } from "../logic/pictures.js";
import { h, slot, table } from "./elements.js";
import { figure, interval } from "./figures.js";
import { makeWipe } from "./wipe.js";

const titles = { single: "Sharp, one target", layers: "Sharp, layers", focus: "By cascade", "focus-blend": "By cascade, fading", cameras: "Many cameras" };
const titleOf = (row) => titles[row.mode] ?? row.mode;

export function fillFocus(document, folder) {
    const shown = document.results.filter((row) => row.picture && row.mode !== "single");
    if (shown.length > 0) {
        slot("focus", "wipe").append(makeWipe(document, folder, shown, {
            title: titleOf, note: (row) => `mean FLIP ${number(row.flip)} to the cameras`,
            start: modesOrWorst(shown, ["focus", "focus-blend"], (row) => row.flip), alt: altOf }));
    }
    slot("focus", "table").append(makeTable(document));
}

function altOf(item) {
    return `The scene through a lens, ${item.title}: ${item.note}.`;
}

function makeTable(document) {
    return table("Execute over drawing the same cascades sharp, the median of the ratios frame by frame; FLIP and RMSE compare with the mean of the cameras.",
        ["Lens", "megapixels", "execute, ms", "times faster", "95 % interval", "FLIP", "RMSE"],
        document.results.map((row) => [
            h("span", {}, titleOf(row)), figure(row.pixels / 1e6), figure(row.execute_ms), figure(row.execute_speedup),
            interval(row.ci95), figure(row.flip), figure(row.rmse)]));
}
