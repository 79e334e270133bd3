import { number, signedPercent } from "../logic/format.js";
import { bars, noiseFloor } from "../logic/timing.js";
import { h, slot, svg, table, wideOnly } from "./elements.js";
import { difference, figure } from "./figures.js";

export function fillTiming(document) {
    const rows = bars(document);
    const noise = noiseFloor(document);
    const scale = scaleOf(rows);
    slot("timing", "figure").append(
        h("p", { class: "kicker" }, h("span", { class: "key ours" }), " measured, its line the 95\u202f% interval \u2002",
            h("span", { class: "key theirs" }), " thesis \u2002", h("span", { class: "key noise" }), " noise floor"),
        table(`Figure 6.4: overhead over standard, from ${number(scale.low, 2)} to ${number(scale.high, 2)} percent. Standard over itself is the noise floor, ${rangeOf(noise)}; ${document.options.frames} frames a mode on ${document.device.name}.`,
            ["Mode", "", "measured", wideOnly("95\u202f% interval"), "thesis", wideOnly("frame, ms")],
            rows.map((row) => [
                row.name, strip(row, noise, scale), difference(row.overhead),
                wideOnly(row.low === null ? "-" : h("span", {}, difference(row.low), " to ", difference(row.high))),
                row.thesis === null ? "" : difference(row.thesis), wideOnly(figure(row.medianUs / 1000))])),
        h("p", { class: "quiet" }, "The thesis measured on a Quadro 4000 under Windows 7, and gives neither field nor lens: here 400\u00b3 units, 60 degrees, near 0.1, far 100,000. Times are of one frame from the camera to the device being done."));
}

/** What is known of an overhead: its interval, else itself. */
function rangeOf({ overhead, low, high }) {
    return low === null ? signedPercent(overhead) : `${signedPercent(low)} to ${signedPercent(high)}`;
}

function scaleOf(rows) {
    const values = rows.flatMap((row) => [row.low ?? 0, row.high ?? 0, row.thesis ?? 0, row.overhead]);
    const [low, high] = [Math.min(...values, 0), Math.max(...values, 1)];
    const margin = 0.03 * (high - low);
    return { low: low - margin, high: high + margin };
}

/** Figure 6.4 as the thesis has it, in bars: the mode\u2019s, and the thesis\u2019 below it. */
function strip(row, noise, { low, high }) {
    const x = (value) => `${((100 * (value - low)) / (high - low)).toFixed(2)}%`;
    const width = (a, b) => `${((100 * (b - a)) / (high - low)).toFixed(2)}%`;
    const bar = (kind, value, y) => svg("rect", { class: kind, x: x(Math.min(value, 0)), y, width: width(Math.min(value, 0), Math.max(value, 0)), height: "38%" });
    const clamp = (value) => Math.min(high, Math.max(low, value));
    const marks = [
        noise.low === null ? null : svg("rect", { class: "noise", x: x(clamp(noise.low)), y: 0, width: width(clamp(noise.low), clamp(noise.high)), height: "100%" }),
        bar("ours", row.overhead, row.thesis === null ? "31%" : "10%"),
        row.thesis === null ? null : bar("theirs", row.thesis, "52%"),
        row.low === null ? null : svg("line", { class: "interval", x1: x(row.low), x2: x(row.high), y1: row.thesis === null ? "50%" : "29%", y2: row.thesis === null ? "50%" : "29%" }),
        svg("line", { class: "zero", x1: x(0), x2: x(0), y1: 0, y2: "100%" }),
    ].filter(Boolean);
    const thesis = row.thesis === null ? "" : `, thesis ${signedPercent(row.thesis)}`;
    return svg("svg", { class: "strip", role: "img", "aria-label": `${rangeOf(row)}${thesis}` }, marks);
}
