// The repository's files and Markdown pages, as the tests beside this file read them.

import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

export const root = join(dirname(fileURLToPath(import.meta.url)), "../..");

const kNotOurs = new Set([".git", ".cache", "build", "out", "node_modules"]);

/** Paths of all files that the repository holds, relative to its root. */
export function files(folder = "") {
    return readdirSync(join(root, folder), { withFileTypes: true }).flatMap((entry) => {
        const path = folder ? `${folder}/${entry.name}` : entry.name;
        if (entry.isDirectory()) {
            return kNotOurs.has(entry.name) ? [] : files(path);
        }
        return [path];
    });
}

export function pages() {
    return files().filter((path) => path.endsWith(".md"));
}

export function read(path) {
    return readFileSync(join(root, path), "utf8");
}

/** Fenced code blocks in order: their language and their lines. */
export function blocks(text) {
    return [...text.matchAll(/^```(\w*)\n([\s\S]*?)^```$/gm)].map(([, language, body]) => ({ language, body }));
}

/** The text without fenced code blocks. */
export function prose(text) {
    return text.replace(/^```\w*\n[\s\S]*?^```$/gm, "");
}
