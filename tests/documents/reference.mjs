// The installed headers as Doxygen reads them: which they are, and the public functions that they declare.

import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { files, read, root } from "./documents.mjs";

/** The rooms that are installed, in the order in which the package names them. */
const rooms = [...read("tools/cmake/CdrPackage.cmake").matchAll(/set\(CDR_(?:DEPTH|SCENE|RENDER)_ROOMS ([^)]+)\)/g)]
    .flatMap(([, names]) => names.split(/\s+/));

/** Paths of the headers that are installed: what a room lists, or all of its folder. */
export const headers = rooms.flatMap((room) => {
    const folder = `src/cdr/${room}`;
    const listed = read(`${folder}/CMakeLists.txt`).match(/cdr_room\([^)]*?HEADERS\s+([^)]*?)\s*(?:\bPUBLIC\b|\bPRIVATE\b|\))/);
    return listed ? listed[1].split(/\s+/).map((name) => `${folder}/${name}`)
        : files(folder).filter((path) => path.endsWith(".h"));
});

/** Runs Doxygen over them with the reference's settings. What it warns of ends it with an error that says so. */
export function runDoxygen() {
    const output = mkdtempSync(join(tmpdir(), "cdr-reference-"));
    try {
        const settings = ["@INCLUDE = tools/reference.doxyfile", `INPUT = ${headers.join(" ")}`,
            `STRIP_FROM_PATH = "${root}"`, `OUTPUT_DIRECTORY = "${output}"`, "GENERATE_HTML = NO", "GENERATE_XML = YES",
            "XML_PROGRAMLISTING = NO"];
        execFileSync("doxygen", ["-"], { cwd: root, input: settings.join("\n"), encoding: "utf8", stdio: "pipe" });
        const xml = join(output, "xml");
        return readdirSync(xml).filter((name) => /^(class|struct|union|namespace|.*_8h)/.test(name))
            .map((name) => parse(readFileSync(join(xml, name), "utf8")));
    } finally {
        rmSync(output, { recursive: true });
    }
}

/** Words of a comment that say the unit or the space of a number. */
const kUnits = new RegExp(`\\b(${["units?", "metres?", "pixels?", "texels?", "radians?", "degrees?", "seconds?", "milliseconds?",
    "microseconds?", "nanoseconds?", "shares?", "ratio", "view distances?", "(view|world|object) space", "depth buffer"].join("|")})\\b`, "i");
/** A name that says it: nearView, zNdc, radiansOf. */
const kNamesUnits = /(View|Ndc|Seconds|Ms|Ns)$|^(metres|radians|degrees|seconds|viewDistance|view|share)(Of|At)?$/;

/** Whether names of numbers, or the comment on them, say the unit or the space. */
export const saysUnits = (names, comment) => names.every((name) => kNamesUnits.test(name)) || kUnits.test(comment);

export const hasDoxygen = process.env.PATH.split(":").some((folder) => existsSync(join(folder, "doxygen")));

const kEntities = { lt: "<", gt: ">", amp: "&", quot: '"', apos: "'" };

/** A tree of { name, attributes, children }, where a child may be a text. */
function parse(xml) {
    const tree = { name: "", attributes: {}, children: [] };
    const open = [tree];
    for (const [, tag, text] of xml.matchAll(/<([^?!][^>]*)>|([^<]+)/g)) {
        if (text !== undefined) {
            open.at(-1).children.push(text.replace(/&(\w+);/g, (whole, entity) => kEntities[entity] ?? whole));
        } else if (tag.startsWith("/")) {
            open.pop();
        } else {
            const attributes = Object.fromEntries([...tag.matchAll(/([\w:]+)="([^"]*)"/g)].map(([, key, value]) => [key, value]));
            const element = { name: tag.match(/^[\w:]+/)[0], attributes, children: [] };
            open.at(-1).children.push(element);
            if (!tag.endsWith("/")) {
                open.push(element);
            }
        }
    }
    return tree;
}

export const childrenOf = (element, name) => element.children.filter((child) => child.name === name);
export const childOf = (element, name) => childrenOf(element, name)[0];

/** All elements of a name below one. */
export function allOf(element, name) {
    return element.children.filter((child) => typeof child !== "string")
        .flatMap((child) => [...(child.name === name ? [child] : []), ...allOf(child, name)]);
}

export function textOf(element) {
    if (!element) {
        return "";
    }
    return element.children.map((child) => (typeof child === "string" ? child : textOf(child))).join("");
}
