// Commands that a page prints are commands that the programs take. Those of the README run, and print what it shows.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { blocks, pages, prose, read, root } from "./documents.mjs";

const programs = { cdr: process.env.CDR_PROGRAM, "cdr-viewer": process.env.CDR_VIEWER_PROGRAM };
assert.ok(programs.cdr, "CDR_PROGRAM must name the built cdr; CTest sets it");
const kLine = /^(?:\$ )?(?:build\/release\/bin\/)?(cdr|cdr-viewer)((?: .*)?)$/;

/** Commands in a page's code blocks, fenced or indented: the line, its program and its arguments. */
function blockCommands(text) {
    const indented = [...prose(text).matchAll(/^ {4}(\S.*)$/gm)].map((match) => match[1]);
    const fenced = blocks(text).flatMap(({ language, body }) =>
        body.split("\n").filter((line) => !["console", "text"].includes(language) || line.startsWith("$ ")));
    return [...fenced, ...indented].flatMap(parse);
}

/** Commands in the middle of a sentence. */
function inlineCommands(text) {
    return [...prose(text).matchAll(/`([^`\n]+)`/g)].flatMap((match) => parse(match[1]));
}

function parse(line) {
    const match = kLine.exec(line.replace(/\s+#.*$/, "").trimEnd());
    return match ? [{ line, program: match[1], arguments: match[2].trim().split(/\s+/).filter(Boolean) }] : [];
}

const helpTexts = new Map();
function help(program, ...subcommand) {
    const key = [program, ...subcommand].join(" ");
    if (!helpTexts.has(key)) {
        helpTexts.set(key, execFileSync(programs[program], [...subcommand, "--help"], { encoding: "utf8" }));
    }
    return helpTexts.get(key);
}

const isCommand = (word) => new RegExp(`^  ${word.replace(/[^\w-]/g, "\\$&")} `, "m").test(help("cdr"));

for (const page of pages()) {
    const printed = [...blockCommands(read(page)), ...inlineCommands(read(page))].filter(({ program }) => programs[program]);
    if (printed.length === 0) {
        continue;
    }
    test(`the programs take the options that ${page} prints`, () => {
        for (const { line, program, arguments: words } of printed) {
            const subcommand = program === "cdr" ? words.filter((word) => isCommand(word)).slice(0, 1) : [];
            const isPattern = words.some((word) => /^[A-Z]+$/.test(word)); // cdr COMMAND --help
            assert.ok(program !== "cdr" || subcommand.length === 1 || isPattern || words.every((word) => word.startsWith("-")), `${line}: no such command`);
            const known = help(program) + help(program, ...subcommand);
            for (const option of words.filter((word) => /^--?[a-z]/.test(word)).map((word) => word.split("=")[0])) {
                assert.ok(new RegExp(`(^|[\\s,])${option}([\\s,=]|$)`, "m").test(known), `${line}: ${option} is no option`);
            }
        }
    });
}

const folder = mkdtempSync(join(tmpdir(), "cdr-documents-"));
after(() => rmSync(folder, { recursive: true }));
symlinkSync(join(root, "tests"), join(folder, "tests"));

function runInFolder({ line, arguments: words }) {
    try {
        return execFileSync(programs.cdr, words, { cwd: folder, encoding: "utf8" });
    } catch (error) {
        return assert.fail(`${line}: ${error.stderr || error}`);
    }
}

// The tests of the viewer run its command.
const printedByReadme = blockCommands(read("README.md")).filter(({ program }) => program === "cdr");
const isReport = (command) => command.arguments[0] === "report";

test("the README's commands run as they are printed", () => {
    const run = printedByReadme.filter((command) => !isReport(command));
    assert.ok(run.length >= 2);
    run.forEach((command) => runInFolder(command));
});

const minutes = process.env.CDR_ALL_CASES ? false : "it takes minutes: tools/check.sh runs it";
test("the README's report runs as it is printed", { skip: minutes }, () => {
    const [report] = printedByReadme.filter(isReport);
    runInFolder(report);
    assert.ok(existsSync(join(folder, report.arguments.at(-1), "index.html")));
});

test("the README shows what its commands print", () => {
    const shown = blocks(read("README.md")).filter((block) => block.language === "console");
    assert.ok(shown.length >= 1);
    for (const { body } of shown) {
        const [first, ...expected] = body.split("\n");
        assert.equal(runInFolder(parse(first)[0]), expected.join("\n"));
    }
});
