// Where code comes from: every package has its licence, and the bill of materials holds every package.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, parse } from "node:path";
import { test } from "node:test";
import { files, read, root } from "./documents.mjs";

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

test("third_party/LICENCES.md names each model of models_sheet.sh that is not in tests/assets", () => {
    const [lists] = read("tests/results/models_sheet.sh").match(/^models=\(\)\n[\s\S]*?(?=^draw )/m);
    const own = files("tests/assets").map((path) => parse(path).name);
    const models = [...lists.matchAll(/[/{,](\w+)(?:\.gl(?:b|tf))?(?=[,}\s)])/g)].map((match) => match[1])
        .filter((name) => !own.includes(name));
    assert.ok(models.includes("cesium_man") && models.includes("TextureTransformTest"), "both lists are read");
    for (const name of models) {
        assert.ok(read("third_party/LICENCES.md").includes(`\`${name}\``), `${name} has no line`);
    }
});

const noGit = existsSync(join(root, ".git")) ? false : "no git";

test("the bill of materials is SPDX and holds every package with its version, licence and hash", { skip: noGit }, () => {
    const bill = JSON.parse(run("tools/sbom.mjs"));
    assert.equal(bill.spdxVersion, "SPDX-2.3");
    const byName = new Map(bill.packages.map((entry) => [entry.name, entry]));
    assert.equal(byName.size, bill.packages.length, "a name stands twice");
    assert.equal(new Set(bill.packages.map(({ SPDXID }) => SPDXID)).size, bill.packages.length, "an id stands twice");
    for (const [name, version] of pinned) {
        assert.equal(byName.get(name)?.versionInfo, version, name);
        assert.match(byName.get(name).checksums[0].checksumValue, /^[0-9a-f]{128}$/, name);
    }
    const allocator = ["vk_mem_alloc.h"].filter(() => existsSync(join(root, ".cache/vma")));
    assert.equal(byName.has("vk_mem_alloc.h"), allocator.length === 1);
    for (const name of [...allocator, "earth-blue-marble.jpg", "earth-topology.png", "mikktspace", "wabt"]) {
        assert.match(byName.get(name).checksums[0].checksumValue, /^[0-9a-f]{64}$/, name);
    }
    for (const entry of bill.packages) {
        assert.match(entry.SPDXID, /^SPDXRef-[A-Za-z0-9.-]+$/);
        assert.ok(entry.versionInfo && entry.licenseDeclared !== "NOASSERTION", entry.name);
    }
    assert.ok(byName.has("libvulkan-dev"), "what the distribution installs");
    assert.equal(bill.relationships.length, bill.packages.length);
});

test("the bill of materials leaves out a package that was removed and not purged", { skip: noGit }, () => {
    const folder = mkdtempSync(join(tmpdir(), "cdr-sbom-"));
    try {
        writeFileSync(join(folder, "dpkg-query"), `#!/bin/sh
case "$2" in *Status-Status*) printf 'config-files ' ;; esac
echo 1.0
`, { mode: 0o755 });
        const options = { cwd: root, encoding: "utf8", env: { ...process.env, PATH: `${folder}:${process.env.PATH}` } };
        const bill = JSON.parse(execFileSync(join(root, "tools/sbom.mjs"), options));
        assert.ok(!bill.packages.some(({ name }) => wanted.includes(name)));
    } finally {
        rmSync(folder, { recursive: true });
    }
});

test("setup.sh says what it would do, and refuses other words", () => {
    assert.match(run("tools/setup.sh", "--dry-run"), /nothing was changed\n$/);
    assert.throws(() => execFileSync(join(root, "tools/setup.sh"), ["--dryrun"], { stdio: "pipe" }), /usage: tools\/setup.sh/);
});

test("setup.sh stops where npm fails, and for the demo goes on and says what is missing", (context) => {
    if (/ by apt,/.test(run("tools/setup.sh", "--dry-run"))) {
        context.skip("packages are missing, which setup.sh would install");
        return;
    }
    const folder = mkdtempSync(join(tmpdir(), "cdr-setup-"));
    try {
        for (const part of ["tools", "third_party", "src/page/package-lock.json", ".cache/vma"]) {
            if (existsSync(join(root, part))) {
                cpSync(join(root, part), join(folder, part), { recursive: true });
            }
        }
        mkdirSync(join(folder, "bin"));
        writeFileSync(join(folder, "bin/npm"), "#!/bin/sh\nexit 1\n", { mode: 0o755 });
        const options = { encoding: "utf8", env: { ...process.env, PATH: `${folder}/bin:${process.env.PATH}` } };
        assert.equal(spawnSync(join(folder, "tools/setup.sh"), options).status, 1);
        const demo = spawnSync(join(folder, "tools/setup.sh"), ["--demo"], options);
        assert.equal(demo.status, 0, demo.stderr);
        assert.equal(demo.stderr.match(/^tools\/setup.sh: npm failed; without what it delivers, /gm).length, 3);
        assert.ok(!existsSync(join(folder, "src/page/node_modules")));
    } finally {
        rmSync(folder, { recursive: true });
    }
});
