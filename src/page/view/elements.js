// Building elements. Text is always set as text, so no result can become markup.

import { techniqueTitle } from "../logic/thesis.js";

/** An element; properties that start with "on" listen, "class" and "data-..." and "aria-..." are attributes. */
export function h(tag, properties = {}, ...children) {
    return fill(document.createElement(tag), properties, children);
}

/** The same in the SVG namespace. */
export function svg(tag, properties = {}, ...children) {
    return fill(document.createElementNS("http://www.w3.org/2000/svg", tag), properties, children);
}

function fill(element, properties, children) {
    for (const [name, value] of Object.entries(properties)) {
        if (name.startsWith("on")) {
            element.addEventListener(name.slice(2), value);
        } else if (value !== null && value !== undefined && value !== false) {
            element.setAttribute(name, value === true ? "" : String(value));
        }
    }
    element.append(...children.flat().filter((child) => child !== null && child !== undefined));
    return element;
}

/**
 * A table in a region of its own that scrolls where a phone is narrower, reachable by keyboard.
 * @param {string|(string|Node)[]} caption
 * @param {(string|Node|object)[]|null} header none where the rows' own names say it all.
 */
export function table(caption, header, rows) {
    const cell = (tag, content, properties = {}) =>
        content?.properties ? h(tag, { ...properties, ...content.properties }, content.content) : h(tag, properties, content ?? "");
    return h("div", { class: "scroll", role: "region", "aria-label": h("p", {}, caption).textContent, tabindex: 0 },
        h("table", {},
            h("caption", {}, caption),
            header && h("thead", {}, h("tr", {}, header.map((content) => (content === "" ? h("td") : cell("th", content, { scope: "col" }))))),
            h("tbody", {}, rows.map((row) => h("tr", {}, row.map((content, i) =>
                i === 0 ? cell("th", content, { scope: "row" }) : cell("td", content)))))));
}

/** A cell that a narrow screen leaves out. */
export function wideOnly(content) {
    return { content, properties: { class: "hide-narrow" } };
}

/** A technique's name with its colour, by which plots know it too. */
export function techniqueLabel(name, title = techniqueTitle(name)) {
    return h("span", { class: "technique" }, h("span", { class: "swatch", style: `--colour: var(--${colourOf(name)})`, "aria-hidden": "true" }), title);
}

/** The custom property that holds a technique's or targets' colour. */
export function colourOf(name) {
    const known = ["standard", "cdr", "log", "logcdr", "reversed", "anchored"];
    const targets = { single: "log", accumulate: "cdr", pool: "anchored", layers: "reversed", "one-pass": "standard" };
    return known.includes(name) ? name : (targets[name.split(/[:,]/)[0]] ?? "extra");
}

/** The place in the page's HTML that a section fills. */
export function slot(section, name) {
    return document.querySelector(`#${section} [data-slot="${name}"]`);
}
