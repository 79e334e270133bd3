// Every relative link and picture of every page leads somewhere. Every commit that a page names is in the history. Every folder
// has its line in ARCHITECTURE.md or on the page of its room.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import { dirname, join, normalize } from "node:path";
import { test } from "node:test";
import { files, pages, prose, read, root } from "./documents.mjs";

/** Where links lead: the part after a word's closing bracket, without a title. */
function targets(text) {
    return [...prose(text).matchAll(/\]\(([^()\s]+)(?: "[^"]*")?\)/g)].map((match) => match[1])
        .filter((target) => !/^(https?|mailto):/.test(target));
}

/** The names of a page's headings as links address them: GitHub's rule. */
function anchors(text) {
    return [...prose(text).matchAll(/^#+ (.*)$/gm)].map(([, heading]) =>
        heading.replace(/\[([^\]]*)\]\([^)]*\)/g, "$1").toLowerCase().replace(/[^\p{L}\p{N}_ -]/gu, "").trim().replaceAll(" ", "-"));
}

for (const page of pages()) {
    test(`the links of ${page} lead somewhere`, () => {
        for (const target of targets(read(page))) {
            const [path, anchor] = target.split("#");
            const file = path ? normalize(join(dirname(page), path)) : page;
            assert.ok(existsSync(join(root, file)), `${target}: there is no ${file}`);
            if (anchor) {
                assert.ok(anchors(read(file)).includes(anchor), `${target}: ${file} has no such heading`);
            }
        }
    });
}

test("every commit that a page names is in the history", (context) => {
    const git = (...words) => spawnSync("git", words, { cwd: root, encoding: "utf8", maxBuffer: 1 << 28 }).stdout?.trim();
    if (!existsSync(join(root, ".git")) || git("rev-parse", "--is-shallow-repository") !== "false") {
        context.skip("no git, or not the whole history");
        return;
    }
    const history = new Set(git("rev-list", "HEAD").split("\n").map((commit) => commit.slice(0, 7)));
    for (const page of pages()) {
        const named = [...read(page).matchAll(/\b[0-9a-f]{7,40}\b/g)].map(([word]) => word);
        for (const commit of named.filter((word) => /\d/.test(word) && /[a-f]/.test(word))) {
            assert.ok(history.has(commit.slice(0, 7)), `${page}: ${commit} is no commit of the history`);
        }
    }
});

const sources = /^(src|shaders|tests|tools|third_party)(\/|$)/;

/** The folders of a page's tables, whose rows begin with them: by their whole path, or as "here" and "below/" it. */
function listedOn(page) {
    const firstColumns = [...read(page).matchAll(/^\| ((?:here|\[?`)[^|]*) \|/gm)].map((match) => match[1]);
    return firstColumns.flatMap((column) => column === "here" ? [dirname(page)]
        : [...column.matchAll(/`([^`]+)`/g)].map(([, name]) => name.endsWith("/") ? join(dirname(page), name.slice(0, -1)) : name))
        .filter((name) => sources.test(name));
}

test("every folder of source has its line in ARCHITECTURE.md or on its room's page, and only those", () => {
    const folders = new Set(files().map(dirname).filter((folder) => sources.test(folder)));
    const tested = (folder) => ["src/", "src/cdr/"].some((above) => folders.has(folder.replace(/^tests\//, above)));
    const rooms = ["cdr/scene", "cdr/render", "cdr/measure", "experiments", "report", "viewer"].map((room) => `src/${room}`);
    const pages = ["ARCHITECTURE.md", ...[...rooms, "shaders", "tests"].map((folder) => `${folder}/README.md`)];
    const listed = pages.flatMap(listedOn);
    const isByRule = (folder) => folder.startsWith("tests/") && tested(folder);
    assert.deepEqual([...new Set(listed)].sort(), [...folders].filter((folder) => !isByRule(folder)).sort());
    assert.equal(listed.length, new Set(listed).size, "a folder has two lines");
});
