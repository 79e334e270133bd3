// Numbers in elements that know all their digits: what is selected is copied with these, and lengths follow the unit chosen.

import { lengthIn, lengthUnits, number, percent, signedPercent } from "../logic/format.js";
import { h } from "./elements.js";

const kKept = "cdr-length-unit"; // in the browser's storage
const kTitles = { none: "scene units", auto: "the unit that fits", um: "\u00b5m" };

/** A number of four significant digits. */
export function figure(value, digits) {
    return exactly(number(value, digits), value);
}

/** Both ends of an interval; a dash where there is none. */
export function interval(ends) {
    if (ends === null) {
        return "-";
    }
    const [low, high] = ends;
    return h("span", {}, figure(low), " to ", figure(high));
}

/** A difference already in percent, its sign always there. */
export function difference(value) {
    return exactly(signedPercent(value), Number.isFinite(value) ? `${value}\u00a0%` : value);
}

/** A share of 1 as percent. */
export function share(value, digits) {
    return exactly(percent(value, digits), Number.isFinite(value) ? `${100 * value}\u00a0%` : value);
}

/** A length in scene units, written in the unit chosen, and until then in `unit`. */
export function length(value, digits = 4, unit = "none") {
    const element = exactly("none", value);
    if (Number.isFinite(value)) {
        element.classList.add("length");
        element.dataset.digits = digits;
        element.dataset.unit = unit;
        write(element, chosenUnit());
    }
    return element;
}

/** The smallest resolved separation of a row. None was resolved, or none of the pairs could be seen, or all are. */
export function separation(row, resolved, pairsSeen, all) {
    if (resolved === null) {
        return pairsSeen === 0 ? "no pixel tells" : h("span", {}, "over ", length(row.largest));
    }
    return all ? h("span", {}, length(resolved), " or less") : length(resolved);
}

/** A sentence of the program in parts: texts, and numbers where a length stands. Words ask for units. */
export function sentence(parts) {
    return parts.map((part) => (typeof part === "string" ? part : length(part, 4, "auto")));
}

function exactly(text, full) {
    return h("data", { value: Number.isFinite(full) || typeof full === "string" ? full : text }, text);
}

function write(element, unit) {
    element.textContent = lengthIn(Number(element.value), unit ?? element.dataset.unit, Number(element.dataset.digits));
}

function chosenUnit() {
    try {
        const kept = localStorage.getItem(kKept);
        return lengthUnits.includes(kept) ? kept : null;
    } catch { // storage is switched off
        return null;
    }
}

/** The choice of the unit of all lengths of the page, and of those to come. */
export function unitChoice() {
    const unit = chosenUnit() ?? "none";
    const select = h("select", {}, lengthUnits.map((name) => h("option", { value: name, selected: name === unit }, kTitles[name] ?? name)));
    select.addEventListener("change", () => {
        try {
            localStorage.setItem(kKept, select.value);
        } catch { /* then it holds until the page is closed */ }
        document.querySelectorAll("data.length").forEach((element) => write(element, select.value));
    });
    return h("label", {}, "Lengths in", select);
}

/** Whatever is copied from now on has all its digits. */
export function copyInFull() {
    document.addEventListener("copy", (event) => {
        const selection = getSelection();
        if (selection.rangeCount !== 1 || selection.isCollapsed) {
            return; // several, as of cells in Firefox, are the browser's to copy
        }
        const range = selection.getRangeAt(0);
        const around = range.commonAncestorContainer;
        const inside = (around.nodeType === Node.ELEMENT_NODE ? around : around.parentElement).closest("data");
        if (inside) {
            event.clipboardData.setData("text/plain", inside.value);
            event.preventDefault();
        } else {
            copyStandIn(selection, range);
        }
    });
}

/** The browser knows how tables become text, so it copies a copy of what is selected. */
function copyStandIn(selection, range) {
    const standIn = h("div", { class: "visually-hidden", "aria-hidden": "true" });
    standIn.append(range.cloneContents());
    standIn.querySelectorAll("data").forEach((element) => { element.textContent = element.value; });
    document.body.append(standIn);
    selection.selectAllChildren(standIn);
    setTimeout(() => {
        standIn.remove();
        selection.removeAllRanges();
        selection.addRange(range);
    });
}
