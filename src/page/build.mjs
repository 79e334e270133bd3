// Bundles the page into files that work without a server, and writes them as a C++ header. Browsers load no module
// scripts from file://, so each page gets one classic script and its style, both inside it.
// Usage: node build.mjs HEADER | node build.mjs --folder FOLDER

import { build } from "esbuild";
import { readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const pages = ["index", "compare"];

async function bundle(entry) {
    const result = await build({
        entryPoints: [join(here, entry)],
        bundle: true,
        minify: true,
        write: false,
        format: "iife",
        target: ["chrome100", "firefox100", "safari15"],
        legalComments: "inline",
        charset: "utf8",
        logLevel: "warning",
    });
    return result.outputFiles[0].text.trimEnd();
}

/** One page with its style and script inside. Nothing in either may end the element that holds it. */
async function page(name) {
    const html = await readFile(join(here, `${name}.html`), "utf8");
    const style = (await bundle(`${name}.css`)).replaceAll("</style", "<\\/style");
    const script = (await bundle(`${name}.js`)).replaceAll("</script", "<\\/script");
    return html
        .replace("/* style */", () => style)
        .replace("/* script */", () => script);
}

async function licences() {
    const uplot = join(here, "node_modules/uplot");
    const { name, version } = JSON.parse(await readFile(join(uplot, "package.json"), "utf8"));
    const text = await readFile(join(uplot, "LICENSE"), "utf8");
    const own = await readFile(join(here, "../../LICENSE"), "utf8");
    return `This page is a part of cdr:\n\n${own}\nIt holds ${name} ${version}:\n\n${text}`;
}

function header(files) {
    const arrays = files.map(([, text], index) =>
        `inline constexpr unsigned char kBytes${index}[] = {${[...Buffer.from(text)].join(",")}};`);
    const rows = files.map(([name], index) => `    {"${name}", kBytes${index}},`);
    return `#pragma once
#include <array>
#include <span>
namespace cdr::page {
struct File {
    const char* name;
    std::span<const unsigned char> bytes;
};
${arrays.join("\n")}
inline constexpr std::array<File, ${files.length}> kFiles{{
${rows.join("\n")}
}};
} // namespace cdr::page
`;
}

const files = [];
for (const name of pages) {
    files.push([`${name}.html`, await page(name)]);
}
files.push(["LICENSES.txt", await licences()]);

const [first, folder] = process.argv.slice(2);
if (first === "--folder") {
    for (const [name, text] of files) {
        await writeFile(join(folder, name), text);
    }
} else {
    await writeFile(first, header(files));
}
