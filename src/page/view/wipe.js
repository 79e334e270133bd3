// Two pictures over each other and a bar between them: a range input, so mouse, touch and keyboard all move it.

import { h } from "./elements.js";

let count = 0; // names of radio groups are page-wide

/**
 * An item for each row, its picture in the folder and of the size that the document's options have.
 * @param {{title: (row: object) => string, note: (row: object) => string, alt: (item: object, kind: string) => string,
 *          heatMap?: string, scene?: string, start?: number[]}} about
 * `heatMap` is the name of the rows' member with a second picture.
 * `start` are the places of the two items shown first; of two items there is nothing to choose.
 */
export function makeWipe({ options }, folder, rows, { title, note, alt, heatMap, scene = options.scene, start = [0, rows.length - 1] }) {
    const { width, height } = options;
    const items = rows.map((row) => ({
        title: title(row), note: note(row), picture: `${folder}/${row.picture}`, heatMap: heatMap && `${folder}/${row[heatMap]}` }));
    const left = picker("Left", items, start[0]);
    const right = picker("Right", items, start[1]);
    const kinds = radios(`wipe-kind-${++count}`, [["picture", "Picture"], ["heatMap", "Heat map"]]);
    const lower = h("img", { class: "lower", width, height });
    const upper = h("img", { class: "upper", width, height });
    const names = [h("span", { class: "wipe-name of-left" }), h("span", { class: "wipe-name of-right" })];
    const caption = h("figcaption");
    const range = h("input", { type: "range", min: 0, max: 100, step: 1, value: 50 });
    const box = h("div", { class: "wipe-box" }, lower, upper, h("div", { class: "wipe-bar" }), names, range);

    const show = () => {
        const [a, b] = [items[left.select.value], items[right.select.value]];
        const kind = kinds.value();
        upper.src = a[kind];
        lower.src = b[kind];
        upper.alt = alt(a, kind);
        lower.alt = alt(b, kind);
        names[0].textContent = a.title;
        names[1].textContent = b.title;
        range.setAttribute("aria-label", `${scene}: how much of ${a.title} covers ${b.title}`);
        caption.textContent = `${a.title}: ${a.note}. ${b.title}: ${b.note}.`;
    };
    const move = () => {
        box.style.setProperty("--at", `${range.value}%`);
        range.setAttribute("aria-valuetext", `${range.value} percent`);
    };
    range.addEventListener("input", move);
    for (const control of [left.select, right.select, kinds.element]) {
        control.addEventListener("change", show);
    }
    show();
    move();
    return h("figure", { class: "wipe" }, h("div", { class: "choices" }, items.length > 2 ? [left.label, right.label] : null, heatMap ? kinds.element : null), box, caption);
}

function picker(label, items, chosen) {
    const select = h("select", {}, items.map((item, i) => h("option", { value: i, selected: i === chosen }, item.title)));
    return { select, label: h("label", {}, label, select) };
}

function radios(name, options) {
    const inputs = options.map(([value], i) => h("input", { type: "radio", name, value, checked: i === 0 }));
    const element = h("fieldset", {}, h("legend", { class: "visually-hidden" }, "What is shown"),
        options.map(([, title], i) => h("label", {}, inputs[i], title)));
    return { element, value: () => inputs.find((input) => input.checked).value };
}
