// Plots with both axes logarithmic or linear: uPlot draws them; this adds read-out, zoom and series by mouse, touch and
// keyboard alike.

import uPlot from "uplot";
import { number, powerOfTen } from "../logic/format.js";
import { around, holds, panned } from "../logic/ranges.js";
import { colourOf, h, svg } from "./elements.js";

const kHeight = 380;
const kLabelRoom = 38; // pixels for the label of a power of ten
const kStep = 1.6; // zoom factor of one press
const dashes = { standard: [], cdr: [9, 4], log: [], logcdr: [9, 4], reversed: [3, 3], anchored: [14, 4, 3, 4] };

/**
 * A plot with its tools, legend and read-out.
 * @param {{title: string, caption: string, x: number[], xLabel: string, yLabel: string, logX: boolean, logY: boolean,
 *          wholeX: boolean | undefined,
 *          series: {name: string, title: string, values: (number|null)[], dash?: number[], points?: boolean, isDots?: boolean}[]}} options
 */
export function makePlot(options) {
    const readout = h("p", { class: "readout", role: "status" }, kHint);
    const legend = h("ul", { class: "legend" });
    const area = h("div", {
        class: "plot-area", tabindex: 0, role: "application", // readers leave the arrow keys to it
        "aria-label": `${options.title}. Left and right arrows read values out, plus and minus zoom, zero shows all.`,
    });
    const plot = new Plot(options, area, readout, legend);
    const tool = (label, text, action) => h("button", { type: "button", "aria-label": label, title: label, onclick: action }, text);
    return h("figure", { class: "plot" },
        h("div", { class: "plot-tools" },
            h("p", { class: "plot-title" }, options.title),
            tool("Zoom in", "+", () => plot.zoom(1 / kStep)),
            tool("Zoom out", "\u2212", () => plot.zoom(kStep)),
            tool("Show all", "All", () => plot.showAll())),
        area, readout, legend,
        h("figcaption", {}, options.caption));
}

const kHint = "Point at the plot, or focus it and press an arrow key, to read values; drag to zoom.";

class Plot {
    constructor(options, area, readout, legend) {
        Object.assign(this, { options, area, readout, legend });
        this.hidden = new Set();
        this.listen();
        new ResizeObserver(() => this.resize()).observe(area);
        matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    }

    /** Draws anew, in the colours of now; kept are the ranges and the hidden series. */
    draw() {
        const kept = this.uplot ? this.ranges() : null;
        this.uplot?.destroy();
        const data = [this.options.x, ...this.options.series.map((series) => series.values)];
        this.uplot = new uPlot(this.settings(), data, this.area);
        this.drawLegend();
        if (kept) {
            this.setRanges(kept);
        }
    }

    resize() {
        const width = Math.floor(this.area.clientWidth);
        if (width > 0 && !this.uplot) {
            this.draw();
        } else if (width > 0 && width !== this.uplot.width) {
            this.uplot.setSize({ width, height: kHeight });
        }
    }

    settings() {
        const { options } = this;
        const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
        const font = `12px ${getComputedStyle(document.documentElement).getPropertyValue("--sans")}`;
        const axis = (label, log) => ({
            label, font, labelFont: font, labelSize: 22, stroke: colour("soft"),
            grid: { stroke: colour("grid"), width: 1, ...(log ? { filter: decades } : {}) },
            ticks: { stroke: colour("grid"), width: 1, size: 5, ...(log ? { filter: decades } : {}) },
            ...(log ? { filter: decades } : {}),
            values: (_, splits) => splits.map((value) => (value === null ? "" : log ? logLabel(value) : number(value, 3))),
        });
        return {
            width: Math.floor(this.area.clientWidth), height: kHeight,
            legend: { show: false },
            cursor: { drag: { x: true, y: true, uni: 30 }, focus: { prox: 24 }, points: { size: 8 } },
            scales: {
                x: { time: false, distr: options.logX ? 3 : 1, range: (u, low, high) => (options.logX ? [low, high] : [low - 0.04 * (high - low), high + 0.04 * (high - low)]) },
                y: { distr: options.logY ? 3 : 1, ...(options.logY ? {} : { range: (u, low, high) => [0, high * 1.05] }) },
            },
            axes: [{ ...axis(options.xLabel, options.logX), ...(options.wholeX ? { incrs: [1, 2, 5, 10, 20, 50] } : {}) }, { ...axis(options.yLabel, options.logY), size: 62 }],
            series: [{}, ...options.series.map((series) => ({
                label: series.title, scale: "y", stroke: colour(colourOf(series.name)), width: 2, spanGaps: false,
                dash: series.dash ?? dashes[series.name] ?? [],
                points: { show: series.points ?? false, size: 7, fill: colour("card") },
                show: !this.hidden.has(series.title),
            }))],
            hooks: {
                setCursor: [(u) => this.read(u.cursor.idx)],
                setScale: [(u, key) => { this.area.dataset[`range${key.toUpperCase()}`] = `${u.scales[key].min} ${u.scales[key].max}`; }],
            },
        };
    }

    drawLegend() {
        this.outputs = this.options.series.map(() => h("output", {}));
        this.legend.replaceChildren(...this.options.series.map((series, i) => h("li", {},
            h("button", {
                type: "button", "aria-pressed": String(!this.hidden.has(series.title)),
                onclick: (event) => this.toggle(i, event.currentTarget),
            }, swatch(series), series.title, this.outputs[i]))));
    }

    toggle(index, button) {
        const { title } = this.options.series[index];
        const hide = !this.hidden.has(title);
        hide ? this.hidden.add(title) : this.hidden.delete(title);
        button.setAttribute("aria-pressed", String(!hide));
        this.uplot.setSeries(index + 1, { show: !hide });
    }

    read(index) {
        this.index = index ?? this.index;
        const known = index !== null && index !== undefined;
        this.readout.textContent = known ? `${this.options.xLabel}: ${number(this.options.x[index], 4)}` : kHint;
        this.outputs?.forEach((output, i) => {
            output.textContent = known ? number(this.options.series[i].values[index], 3) : "";
        });
    }

    /** Puts the cursor on a point, as the mouse would. */
    moveTo(index) {
        const last = this.options.x.length - 1;
        const at = Math.max(0, Math.min(last, index));
        const { min, max } = this.uplot.scales.x;
        if (this.options.x[at] < min || this.options.x[at] > max) {
            this.setRanges({ ...this.ranges(), x: panned([min, max], this.options.x[at], this.options.logX) });
        }
        this.uplot.setCursor({ left: this.uplot.valToPos(this.options.x[at], "x"), top: this.uplot.over.clientHeight / 2 });
        this.index = at;
        this.read(at);
    }

    ranges() {
        const { x, y } = this.uplot.scales;
        return { x: [x.min, x.max], y: [y.min, y.max] };
    }

    setRanges({ x, y }) {
        this.uplot.batch(() => {
            this.uplot.setScale("x", { min: x[0], max: x[1] });
            this.uplot.setScale("y", { min: y[0], max: y[1] });
        });
    }

    /** By a factor about the cursor, or about the middle. An axis that shows all of its values gets no wider. */
    zoom(factor) {
        const { logX, logY, series } = this.options;
        const { left, top } = this.uplot.cursor;
        const values = series.filter(({ title }) => !this.hidden.has(title)).flatMap((shown) => shown.values);
        const hasAll = { x: (range) => holds(range, this.options.x, logX), y: (range) => holds(range, values, logY) };
        const now = this.ranges();
        const along = (key, position, log) => (factor > 1 && hasAll[key](now[key]) ? now[key]
            : around(now[key], factor, position >= 0 ? this.uplot.posToVal(position, key) : null, log));
        const ranges = { x: along("x", left, logX), y: along("y", top, logY) };
        factor > 1 && hasAll.x(ranges.x) && hasAll.y(ranges.y) ? this.showAll() : this.setRanges(ranges);
    }

    showAll() {
        this.uplot.setData(this.uplot.data, true);
    }

    listen() {
        const keys = {
            ArrowLeft: () => this.moveTo((this.index ?? this.options.x.length) - 1),
            ArrowRight: () => this.moveTo((this.index ?? -1) + 1),
            Home: () => this.moveTo(0),
            End: () => this.moveTo(this.options.x.length - 1),
            "+": () => this.zoom(1 / kStep),
            "=": () => this.zoom(1 / kStep),
            "-": () => this.zoom(kStep),
            0: () => this.showAll(),
            Escape: () => this.showAll(),
        };
        this.area.addEventListener("keydown", (event) => {
            if (keys[event.key] && !event.ctrlKey && !event.metaKey && !event.altKey) {
                event.preventDefault();
                keys[event.key]();
            }
        });
        this.area.addEventListener("dblclick", () => this.showAll());
        this.listenToTouch();
    }

    /** A finger reads values out; two zoom. */
    listenToTouch() {
        let spread = 0;
        const distance = (touches) => Math.hypot(touches[0].clientX - touches[1].clientX, touches[0].clientY - touches[1].clientY);
        this.area.addEventListener("touchstart", (event) => {
            spread = event.touches.length === 2 ? distance(event.touches) : 0;
            this.readTouch(event.touches[0]);
        }, { passive: true });
        this.area.addEventListener("touchmove", (event) => {
            if (event.touches.length === 2 && spread > 0) {
                event.preventDefault();
                const now = distance(event.touches);
                this.zoom(spread / now);
                spread = now;
            } else {
                this.readTouch(event.touches[0]);
            }
        }, { passive: false });
    }

    readTouch(touch) {
        const box = this.uplot.over.getBoundingClientRect();
        this.uplot.setCursor({ left: touch.clientX - box.left, top: touch.clientY - box.top });
    }
}

/** A power of ten, or between two a plain number (only far zoomed in). */
function logLabel(value) {
    const exponent = Math.log10(value);
    return Math.abs(exponent - Math.round(exponent)) < 1e-6 ? powerOfTen(value) : number(value, 3);
}

/** Of a logarithmic axis' splits only whole powers of ten, and of these as few as do not crowd. */
function decades(plot, splits, axis) {
    const { min, max } = plot.scales[plot.axes[axis].scale];
    const room = (axis === 0 ? plot.bbox.width : plot.bbox.height) / devicePixelRatio;
    const every = Math.ceil(Math.log10(max / min) / Math.min(11, room / kLabelRoom));
    const keep = (value) => Number.isInteger(Math.round(1e6 * Math.log10(value)) / 1e6 / every);
    return Math.log10(max / min) < 1 ? splits : splits.map((value) => (keep(value) ? value : null));
}

function swatch(series) {
    const dash = (series.dash ?? dashes[series.name] ?? []).join(" ");
    if (series.isDots) {
        return svg("svg", { viewBox: "0 0 24 10", "aria-hidden": "true" },
            svg("circle", { cx: 12, cy: 5, r: 3.5, fill: "none", stroke: `var(--${colourOf(series.name)})`, "stroke-width": 2 }));
    }
    return svg("svg", { viewBox: "0 0 24 10", "aria-hidden": "true" },
        svg("line", { x1: 0, y1: 5, x2: 24, y2: 5, stroke: `var(--${colourOf(series.name)})`, "stroke-width": 3, "stroke-dasharray": dash }));
}
