// What promises.sh does with promises.json, and what tests/documents checks of it.

import { existsSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

/** Each promise, and by program of tests the filters that GoogleTest takes. */
export const promises = JSON.parse(readFileSync(new URL("promises.json", import.meta.url), "utf8"));

/** The programs of tests that promises name. */
export const programs = [...new Set(promises.flatMap(({ tests }) => Object.keys(tests)))];

const kTitles = { system: "", mesa: "lavapipe: ", swiftshader: "SwiftShader: ", card: "" }; // in the order of columns

/** Whether a filter with * takes a test, by its whole name. */
export function takes(filter, name) {
    const parts = filter.split("*").map((part) => part.replace(/[^\w]/g, "\\$&"));
    return new RegExp(`^${parts.join(".*")}$`).test(name);
}

/** "passed", "left out" or "failed" of each test that a program ran, by its name. Empty where the program did not run. */
function results(file) {
    const ran = new Map();
    if (!existsSync(file)) {
        return ran;
    }
    for (const suite of JSON.parse(readFileSync(file, "utf8")).testsuites) {
        for (const test of suite.testsuite) {
            const passed = test.result === "SKIPPED" ? "left out" : "passed";
            ran.set(`${suite.name}.${test.name}`, test.failures ? "failed" : passed);
        }
    }
    return ran;
}

/** A row "promise,driver,version,sub-pixel bits,passed,left out,failed" of each promise of which every filter took a test. */
function rowsOf(driver, folder) {
    const ran = new Map(programs.map((program) => [program, [...results(`${folder}.${program}.json`)]]));
    return promises.flatMap(({ promise, tests }) => {
        const filters = Object.entries(tests).flatMap(([program, all]) => all.map((filter) => ({ program, filter })));
        const taken = filters.map(({ program, filter }) => ran.get(program).filter(([name]) => takes(filter, name))
            .map(([name, result]) => [`${program} ${name}`, result]));
        const each = [...new Map(taken.flat()).values()]; // a test counts once, though two filters take it
        const count = (wanted) => each.filter((result) => result === wanted).length;
        return taken.some((some) => some.length === 0) ? []
            : [[`"${promise}"`, driver, count("passed"), count("left out"), count("failed")].join(",")];
    });
}

/** Rows of a CSV as objects. The promise alone stands in quotes. */
export function readRows(file) {
    const lines = existsSync(file) ? readFileSync(file, "utf8").trim().split("\n").slice(1) : [];
    return lines.map((line) => {
        const [, promise, rest] = /^"([^"]*)",(.*)$/.exec(line);
        const [driver, version, bits, passed, leftOut, failed] = rest.split(",");
        return { line, promise, driver, version, bits, passed: Number(passed), leftOut: Number(leftOut), failed: Number(failed) };
    });
}

function writeRows(driver, folder, file) {
    const name = driver.split(",")[0];
    const others = readRows(file).filter((row) => row.driver !== name).map((row) => row.line);
    const lines = [...others, ...rowsOf(driver, folder)];
    writeFileSync(file, ["promise,driver,version,sub-pixel bits,passed,left out,failed", ...lines, ""].join("\n"));
}

function cell(row) {
    if (row === undefined) {
        return "not run";
    }
    const { passed, leftOut, failed } = row;
    return [`${passed}`, ...(leftOut > 0 ? [`${leftOut} left out`] : []), ...(failed > 0 ? [`${failed} failed`] : [])].join(", ");
}

function writeTable(file, page) {
    const rows = readRows(file);
    const drivers = Object.keys(kTitles).flatMap((driver) => rows.find((row) => row.driver === driver) ?? []);
    const lines = promises.map(({ promise }) => [promise, ...drivers.map(({ driver }) =>
        cell(rows.find((row) => row.promise === promise && row.driver === driver)))]);
    const head = ["promise", ...drivers.map(({ driver, version, bits }) => `${kTitles[driver]}${version}, ${bits} sub-pixel bits`)];
    const texts = [head, head.map(() => "---"), ...lines].map((line) => `| ${line.join(" | ")} |`);
    const parts = /(<!-- promises.sh writes this table -->\n)[^]*?(<!-- end -->)/;
    writeFileSync(page, readFileSync(page, "utf8").replace(parts, `$1\n${texts.join("\n")}\n\n$2`));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
    const [what, ...rest] = process.argv.slice(2);
    const filterOf = (program) => promises.flatMap(({ tests }) => tests[program] ?? []).join(":");
    const tasks = {
        programs: () => console.log(programs.join("\n")),
        filter: (program) => console.log(filterOf(program)),
        rows: writeRows,
        table: writeTable,
    };
    tasks[what](...rest);
}
