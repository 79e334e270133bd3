import { number } from "../logic/format.js";
import { choices, nameOf, series, summary } from "../logic/scaling.js";
import { h, slot, table } from "./elements.js";
import { figure } from "./figures.js";
import { makePlot } from "./plot.js";

export function fillScaling(document) {
    const { cascades, cubes } = choices(document);
    const most = cubes.at(-1);
    const where = slot("scaling", "plot");
    where.append(h("p", {}, sentence(document)));
    where.append(
        plotOf(document, cascades[0], most, "record_ns_per_draw", "Recording, nanoseconds per draw", "record, ns per draw"),
        plotOf(document, cascades.at(-1), most, "speedup", "Recording, times as fast as one thread", "speed-up", true));
    slot("scaling", "table").append(h("details", { class: "source" }, h("summary", {}, "Every point as a table"), h("div", {}, makeTable(document))));
}

function cascadesText(count) {
    return `${count} ${count === 1 ? "cascade" : "cascades"}`;
}

function sentence(document) {
    const { cpus, best, points, differing, fastest } = summary(document);
    const images = differing === 0
        ? `All ${points} points drew the very image of one thread.`
        : `${differing} of ${points} points drew another image than one thread: a fault.`;
    const speed = best && best.threads > 1
        ? `With no more threads than this machine\u2019s ${cpus} processors, recording was at best ${number(best.speedup)} times as fast as on one, on ${best.threads} threads (${nameOf(best)}, ${cascadesText(best.cascades)}, ${number(best.draws, 6)} draws).`
        : `On this machine\u2019s ${cpus} processors no number of threads recorded faster than one.`;
    return `${speed} The least a draw took to record was ${number(fastest, 3)} ns. ${images}`;
}

function plotOf(document, cascades, cubes, field, title, yLabel, ideal = false) {
    const { x, series: lines } = series(document, cascades, cubes, field);
    const drawn = lines.map((line) => ({ ...line, title: line.name, points: true, dash: line.name.includes(",") ? [2, 3] : [] }));
    if (ideal) {
        drawn.push({ name: "ideal", title: "ideal", values: x, dash: [4, 5] });
    }
    return makePlot({
        title: `${title}, ${cascadesText(cascades)}, ${number(cubes, 7)} cubes`,
        caption: "One line per way in which cascades reach the final picture, and in which draws are submitted. Medians over the repeats. Past the number of processors threads only wait for each other.",
        x, xLabel: "threads", yLabel, logX: false, wholeX: true, logY: false, series: drawn,
    });
}

function makeTable(document) {
    return table("Medians in milliseconds; record and execute stay apart.",
        ["Targets", "cascades", "threads", "draws", "record", "ns per draw", "speed-up", "efficiency", "execute", "frame"],
        document.results.map((r) => [nameOf(r), r.cascades, r.threads, figure(r.draws), figure(r.record_ms), figure(r.record_ns_per_draw),
            figure(r.speedup), figure(r.efficiency), figure(r.execute_ms), figure(r.frame_ms)]));
}
