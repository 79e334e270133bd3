// What asks something of the operating system lies in the files that the library's page names.

import assert from "node:assert/strict";
import { test } from "node:test";
import { files, read } from "./documents.mjs";

const kPage = "src/cdr/README.md";
const kAsks = new RegExp([
    String.raw`#include <(unistd|fcntl|sched|spawn|poll|dlfcn|pthread|termios|sys/\w+)\.h>`, String.raw`"/(proc|sys)/`,
    String.raw`\bsigaction\(`, String.raw`\bSIG[A-Z]{3,4}\b`, String.raw`\b_WIN32\b`, String.raw`\b__linux__\b`, String.raw`\b__GLIBC__\b`,
    String.raw`\bsetenv\(`].join("|"));

test("what needs Linux is where the library's page says", () => {
    const section = read(kPage).split("\n## ").find((part) => part.startsWith("What needs Linux"));
    const rows = [...section.matchAll(/^\| (`[^|]+) \|/gm)].map((match) => match[1]);
    const named = rows.flatMap((row) => [...row.matchAll(/`([^`]+)`/g)].map((match) => `src/${match[1]}`));
    const asking = files("src").filter((path) => /\.(cpp|h)$/.test(path) && !path.startsWith("src/examples/"))
        .filter((path) => kAsks.test(read(path).replaceAll(/\/\/.*$/gm, "")));
    assert.deepEqual(named.sort(), asking.sort());
});
