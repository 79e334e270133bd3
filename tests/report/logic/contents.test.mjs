import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { partOf } from "../../../src/page/view/source.js";

const read = (path) => readFileSync(new URL(`../../../${path}`, import.meta.url), "utf8");
const all = (text, pattern) => [...text.matchAll(pattern)].map((match) => match[1]);

test("the page has a section and a link for whatever a report runs, and no others", () => {
    const html = read("src/page/index.html");
    const planned = new Set(all(read("src/report/plan_table.cpp"), /\bname = "([a-z-]+)/g).map(partOf));
    assert.ok(planned.size > 10, `${planned.size} parts`);
    const expected = [...planned, "opening", "verdicts", "environment"].sort();
    assert.deepEqual(all(html, /<section id="([^"]*)"/g).sort(), expected);
    assert.deepEqual(all(html.match(/<nav class="contents".*<\/nav>/s)[0], /<a href="#([^"]*)"/g).sort(), expected);
});
