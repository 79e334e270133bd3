// Where code comes from: every package has its licence, and the bill of materials holds every package.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";
import { join } from "node:path";
import { read, root } from "./documents.mjs";

const run = (program, ...words) => execFileSync(join(root, program), words, { cwd: root, encoding: "utf8" });
const wanted = run("tools/setup.sh", "--list").trim().split("\n");
const pinned = Object.entries(JSON.parse(read("src/page/package-lock.json")).packages)
    .filter(([path]) => path).map(([path, { version }]) => [path.replace("node_modules/", ""), version]);

test("third_party/LICENCES.md names each package of setup.sh and of npm, and no other", () => {
    const listed = [...read("third_party/LICENCES.md").matchAll(/^\| `([^`]+)` \| [A-Z]?[a-z]?[^|]{2,} \|/gm)]
        .map((match) => match[1]).filter((name) => !name.includes("/"));
    const npm = pinned.map(([name]) => name).filter((name) => !name.startsWith("@esbuild/"));
    assert.deepEqual(listed.sort(), [...wanted, ...npm, "three-globe", "mikktspace", "wabt"].sort());
});

test("the bill of materials is SPDX and holds every package with its version, licence and hash", () => {
    const bill = JSON.parse(run("tools/sbom.mjs"));
    assert.equal(bill.spdxVersion, "SPDX-2.3");
    const byName = new Map(bill.packages.map((entry) => [entry.name, entry]));
    assert.equal(byName.size, bill.packages.length, "a name stands twice");
    assert.equal(new Set(bill.packages.map(({ SPDXID }) => SPDXID)).size, bill.packages.length, "an id stands twice");
    for (const [name, version] of pinned) {
        assert.equal(byName.get(name)?.versionInfo, version, name);
        assert.match(byName.get(name).checksums[0].checksumValue, /^[0-9a-f]{128}$/, name);
    }
    for (const name of ["vk_mem_alloc.h", "earth-blue-marble.jpg", "earth-topology.png", "mikktspace", "wabt"]) {
        assert.match(byName.get(name).checksums[0].checksumValue, /^[0-9a-f]{64}$/, name);
    }
    for (const entry of bill.packages) {
        assert.match(entry.SPDXID, /^SPDXRef-[A-Za-z0-9.-]+$/);
        assert.ok(entry.versionInfo && entry.licenseDeclared !== "NOASSERTION", entry.name);
    }
    assert.ok(byName.has("libvulkan-dev"), "what the distribution installs");
    assert.equal(bill.relationships.length, bill.packages.length);
});

test("setup.sh says what it would do, and refuses other words", () => {
    assert.match(run("tools/setup.sh", "--dry-run"), /nothing was changed\n$/);
    assert.throws(() => execFileSync(join(root, "tools/setup.sh"), ["--dryrun"], { stdio: "pipe" }), /usage: tools\/setup.sh/);
});
