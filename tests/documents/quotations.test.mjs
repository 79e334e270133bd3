// Code in a page is code that the build compiles. A source file marks what a page quotes with `// quoted in
// PAGE: begin` and `// quoted in PAGE: end`, or in CMake by `#`.

import assert from "node:assert/strict";
import { test } from "node:test";
import { blocks, files, pages, read } from "./documents.mjs";

const kMark = /^[ \t]*(?:\/\/|#) quoted in (\S+): begin\n([\s\S]*?)^[ \t]*(?:\/\/|#) quoted in \1: end$/gm;

function dedented(code) {
    const lines = code.trimEnd().split("\n");
    const indent = Math.min(...lines.filter((line) => line.trim()).map((line) => line.search(/\S/)));
    return `${lines.map((line) => line.slice(indent)).join("\n")}\n`;
}

const sources = files().filter((path) => /(\.(cpp|h|vert|frag|comp|glsl|hlsl)|CMakeLists\.txt)$/.test(path));
const quotations = sources.flatMap((source) =>
    [...read(source).matchAll(kMark)].map(([, page, code]) => ({ source, page, code: dedented(code) })));

test("there are quotations", () => assert.ok(quotations.length >= 3));

for (const { source, page, code } of quotations) {
    test(`${page} quotes ${source} as it is`, () => {
        assert.ok(blocks(read(page)).some((block) => block.body === code), `${page} lacks this block:\n${code}`);
    });
}

test("pages show no other C++ and GLSL than what is quoted", () => {
    const quoted = new Set(quotations.map(({ page, code }) => `${page}\n${code}`));
    for (const page of pages()) {
        for (const { language, body } of blocks(read(page))) {
            assert.ok(!["cpp", "c", "glsl", "hlsl", "cmake"].includes(language) || quoted.has(`${page}\n${body}`), `${page} shows code that nothing compiles:\n${body}`);
        }
    }
});
