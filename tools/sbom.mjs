#!/usr/bin/env node
// Writes what cdr is made of as an SPDX 2.3 document (JSON). That is distribution packages as installed here, npm
// packages as package-lock.json pins them, and files that are pinned by hash. The same commit and packages give the
// same bytes.
// Usage: tools/sbom.mjs >cdr.spdx.json
import { execFileSync } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const read = (name) => readFileSync(join(root, name), "utf8");
const run = (program, ...words) => execFileSync(program, words, { cwd: root, encoding: "utf8" }).trim();

/** SPDX's name of the licence by the package's name, as third_party/LICENCES.md lists it. */
const licences = new Map([...read("third_party/LICENCES.md").matchAll(/^\| `([^`]+)` \| ([^|]+) \|/gm)]
    .map(([, name, licence]) => [name, licence.trim()]));

/** Each distribution package that is installed, and its version. */
function distributionPackages() {
    const { ID: system } = Object.fromEntries(readFileSync("/etc/os-release", "utf8").trim().split("\n")
        .map((line) => line.split("=")));
    const found = [];
    for (const name of run("tools/setup.sh", "--list").split("\n")) {
        let state = "";
        try {
            const format = "${db:Status-Status} ${Version}\n"; // what was removed keeps its version
            state = execFileSync("dpkg-query", ["--showformat", format, "--show", name], { encoding: "utf8", stdio: "pipe" });
        } catch {
            // never installed
        }
        const version = state.match(/^installed (\S+)$/m)?.[1];
        if (!version) {
            continue; // optional, or brought by another package
        }
        found.push({ name, version, purl: `pkg:deb/${system}/${encodeURIComponent(name)}@${version}` });
    }
    return found;
}

/** What package-lock.json pins, with the hash of each. */
function npmPackages() {
    return Object.entries(JSON.parse(read("src/page/package-lock.json")).packages).filter(([path]) => path)
        .map(([path, { version, license, integrity }]) => {
            const name = path.replace(/^.*node_modules\//, "");
            const [algorithm, hash] = integrity.split(/-(.*)/s);
            return {
                name, version, licence: licences.get(name) ?? license,
                purl: `pkg:npm/${name.replace("@", "%40")}@${version}`,
                checksum: [algorithm.toUpperCase(), Buffer.from(hash, "base64").toString("hex")],
            };
        });
}

/** The files that scripts pin by SHA-256. */
function pinnedFiles() {
    const [, version] = read("third_party/orbit_data.sh").match(/^package=three-globe@(\S+)/m);
    const pictures = [...read("third_party/orbit_data.sh").matchAll(/^([0-9a-f]{64}) {2}(\S+)$/gm)]
        .map(([, hash, name]) => ({ name, version, licence: "LicenseRef-NASA", checksum: ["SHA256", hash] }));
    const mikktspace = read("third_party/mikktspace.sh");
    const archives = [...mikktspace.matchAll(/^([0-9a-f]{64}) {2}(\w+)-(\S+)\.tgz$/gm)].map(([, hash, name, version]) =>
        ({ name, version, purl: `pkg:npm/${name}@${version}`, checksum: ["SHA256", hash] }));
    const vma = read("third_party/vma.sh");
    if (!existsSync(join(root, ".cache/vma"))) { // the distribution has a package of it
        return [...pictures, ...archives];
    }
    return [...pictures, ...archives, {
        name: "vk_mem_alloc.h", version: vma.match(/^version='([^*'-]+)/m)[1], licence: "MIT",
        checksum: ["SHA256", vma.match(/^header_sha256=([0-9a-f]{64})$/m)[1]],
    }];
}

function spdxPackage({ name, version, licence, purl, checksum }) {
    const known = licence ?? licences.get(name) ?? "NOASSERTION";
    return {
        name,
        SPDXID: `SPDXRef-${name.replace(/[^A-Za-z0-9.]/g, "-").replace(/^-/, "")}`,
        versionInfo: version,
        downloadLocation: "NOASSERTION",
        filesAnalyzed: false,
        licenseConcluded: known,
        licenseDeclared: known,
        copyrightText: "NOASSERTION",
        ...checksum && { checksums: [{ algorithm: checksum[0], checksumValue: checksum[1] }] },
        ...purl && { externalRefs: [{ referenceCategory: "PACKAGE-MANAGER", referenceType: "purl", referenceLocator: purl }] },
    };
}

const [, version] = read("CMakeLists.txt").match(/^project\(cdr VERSION (\S+)/m);
const commit = run("git", "rev-parse", "HEAD");
const own = spdxPackage({ name: "cdr", version, licence: "MIT" });
const packages = [...distributionPackages(), ...npmPackages(), ...pinnedFiles()].map(spdxPackage);
process.stdout.write(JSON.stringify({
    spdxVersion: "SPDX-2.3",
    dataLicense: "CC0-1.0",
    SPDXID: "SPDXRef-DOCUMENT",
    name: `cdr-${version}`,
    documentNamespace: `https://spdx.org/spdxdocs/cdr-${version}-${commit}`,
    creationInfo: {
        created: new Date(1000 * run("git", "show", "--no-patch", "--format=%ct", "HEAD")).toISOString().replace(/\.\d+Z$/, "Z"),
        creators: ["Tool: tools/sbom.mjs"],
    },
    packages: [own, ...packages],
    hasExtractedLicensingInfos: [{ licenseId: "LicenseRef-NASA", extractedText: "NASA's pictures are free of copyright." }],
    relationships: [
        { spdxElementId: "SPDXRef-DOCUMENT", relationshipType: "DESCRIBES", relatedSpdxElement: own.SPDXID },
        ...packages.map(({ SPDXID }) => ({ spdxElementId: own.SPDXID, relationshipType: "DEPENDS_ON", relatedSpdxElement: SPDXID })),
    ],
}, null, 1) + "\n");
