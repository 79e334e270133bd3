// The list of promises names tests that there are, and so does the page of faults. The table holds each promise.

import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { programs, promises, readRows, takes } from "../results/promises.mjs";
import { files, read, root } from "./documents.mjs";

const kPage = "tests/results/trust.md";
const kRows = "tests/results/promises.csv";

/** Whole names of the tests below a folder. Of tests with parameters, one for each word in quotes that
 *  may name a row. */
function testsIn(folder) {
    return files(folder).filter((path) => path.endsWith(".cpp")).flatMap((path) => {
        const text = read(path);
        const prefixes = [...text.matchAll(/INSTANTIATE_TEST_SUITE_P\(\s*(\w+),\s*(\w+)/g)];
        const rows = ["0", ...[...text.matchAll(/"([A-Z]\w*)"/g)].map((match) => match[1])];
        return [...text.matchAll(/\bTEST(_F|_P)?\(\s*(\w+),\s*(\w+)\)/g)].flatMap(([, kind, suite, name]) =>
            kind !== "_P" ? [`${suite}.${name}`] : prefixes.filter((match) => match[2] === suite)
                .flatMap((match) => rows.map((row) => `${match[1]}/${suite}.${name}/${row}`)));
    });
}

for (const program of programs) {
    const names = testsIn(`tests/${program}`);
    test(`each filter of promises that test_${program} keeps takes a test`, () => {
        for (const filter of promises.flatMap(({ tests }) => tests[program] ?? [])) {
            assert.ok(names.some((name) => takes(filter, name)), `${filter} takes no test of tests/${program}`);
        }
    });
}

test("each promise was tested on two drivers at least, and stands in the table", () => {
    const rows = readRows(join(root, kRows));
    for (const { promise } of promises) {
        assert.ok(rows.filter((row) => row.promise === promise && row.passed > 0).length >= 2, promise);
        assert.ok(read(kPage).includes(`| ${promise} |`), `${promise} is not on ${kPage}`);
    }
    for (const { promise, driver, passed, leftOut, failed } of rows) {
        assert.ok(promises.some((each) => each.promise === promise), `${promise} is no promise any more`);
        assert.ok(passed + leftOut > 0 && failed === 0, `${promise}, on ${driver}: ${passed} passed, ${failed} failed`);
    }
});

test("the tests of faults that were mended are there", () => {
    const names = testsIn("tests");
    const rows = [...read(kPage).matchAll(/^\|[^|]*\|[^|]*\| (`[^|]*) \|$/gm)].map((match) => match[1]);
    const named = rows.flatMap((row) => [...row.matchAll(/`(\w+(?:\.\w+)?)`/g)].map((match) => match[1]));
    assert.ok(named.length >= 25);
    for (const each of named) {
        const filter = each.includes(".") ? [each, `*/${each}/*`] : [`${each}.*`, `*/${each}.*`];
        assert.ok(names.some((name) => filter.some((one) => takes(one, name))), `${each} is no test`);
    }
});
