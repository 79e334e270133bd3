// Times flight_helmet with all five textures against an older program that draws it with base colour alone. Both programs take
// turns. The file at hand has base colours only, so the other textures are made here: noise about a mean, of the same size.
// Usage: node tests/results/helmet.mjs OLD_PROGRAM [ROUNDS] [PROGRAM]
// Times are `record_ms` and `execute_ms` of `cdr render` together, the median of a run's frames without its first ones.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import zlib from "node:zlib";

const [old, rounds = "9", program = "build/release/bin/cdr"] = process.argv.slice(2);
if (old === undefined || !(Number(rounds) >= 1)) {
    console.error("usage: node tests/results/helmet.mjs OLD_PROGRAM [ROUNDS] [PROGRAM]");
    process.exit(2);
}
const kSide = 1024; // texels, as the base colours have
const kFrames = 24;
const kWarmUp = 4;

const helmet = path.join(process.env.CDR_ASSETS_DIR ?? "../shared/assets", "flight_helmet", "flight_helmet.gltf");
const folder = fs.mkdtempSync(path.join(os.tmpdir(), "helmet-"));
process.on("exit", () => fs.rmSync(folder, { recursive: true }));

function chunk(name, data) {
    const named = Buffer.concat([Buffer.from(name, "latin1"), data]);
    const whole = Buffer.alloc(named.length + 8);
    whole.writeUInt32BE(data.length, 0);
    named.copy(whole, 4);
    whole.writeUInt32BE(crc32(named), named.length + 4);
    return whole;
}

function crc32(bytes) {
    let crc = ~0;
    for (const byte of bytes) {
        crc ^= byte;
        for (let bit = 0; bit < 8; ++bit) {
            crc = (crc >>> 1) ^ (0xedb88320 & -(crc & 1));
        }
    }
    return ~crc >>> 0;
}

function noisePicture(mean, seed) {
    const rows = Buffer.alloc(kSide * (1 + 3 * kSide)); // each row begins with its filter, which is none
    for (let y = 0, i = 0; y < kSide; ++y) {
        for (let x = 0; x < kSide; ++x, ++i) {
            const noise = Math.imul(i + seed, 2654435761) >>> 0;
            for (let c = 0; c < 3; ++c) {
                const off = ((noise >>> (8 * c + 3)) % 32) - 16;
                rows[y * (1 + 3 * kSide) + 1 + 3 * x + c] = Math.min(Math.max(mean[c] + off, 0), 255);
            }
        }
    }
    const header = Buffer.alloc(13);
    header.writeUInt32BE(kSide, 0);
    header.writeUInt32BE(kSide, 4);
    header.set([8, 2, 0, 0, 0], 8); // 8 bits, RGB
    return Buffer.concat([
        Buffer.from("89504e470d0a1a0a", "hex"),
        chunk("IHDR", header),
        chunk("IDAT", zlib.deflateSync(rows, { level: 1 })),
        chunk("IEND", Buffer.alloc(0)),
    ]);
}

/// The helmet with five textures for each material, beside copies of its other files. @return the file
function makeWhole() {
    const model = JSON.parse(fs.readFileSync(helmet, "utf8"));
    for (const name of fs.readdirSync(path.dirname(helmet))) {
        fs.copyFileSync(path.join(path.dirname(helmet), name), path.join(folder, name));
    }
    const add = (kind, mean) => {
        const name = `${kind}${model.images.length}.png`;
        fs.writeFileSync(path.join(folder, name), noisePicture(mean, model.images.length));
        model.textures.push({ source: model.images.length });
        model.images.push({ uri: name });
        return { index: model.textures.length - 1 };
    };
    for (const material of model.materials) {
        material.pbrMetallicRoughness.metallicRoughnessTexture = add("shine", [255, 150, 90]);
        material.normalTexture = add("normal", [128, 128, 239]);
        material.occlusionTexture = add("occlusion", [200, 200, 200]);
        material.emissiveTexture = add("emission", [20, 20, 30]);
        material.emissiveFactor = [1, 1, 1];
    }
    const file = path.join(folder, "whole.gltf");
    fs.writeFileSync(file, JSON.stringify(model));
    return file;
}

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

function time(which, file, ...options) {
    const json = path.join(folder, "run.json");
    execFileSync(which, ["render", file, "--technique", "anchored", "--frames", String(kFrames), "--json", json, ...options], {
        stdio: ["ignore", "ignore", "inherit"],
    });
    const frames = JSON.parse(fs.readFileSync(json, "utf8")).results.slice(kWarmUp);
    return median(frames.map((frame) => frame.record_ms + frame.execute_ms));
}

const whole = makeWhole();
const cases = {
    "base colour alone, this program": () => time(program, helmet, "--light", "lamps"),
    "five textures, lamps": () => time(program, whole, "--light", "lamps"),
    "five textures, sky": () => time(program, whole, "--light", "sky"),
};
const ratios = Object.fromEntries(Object.keys(cases).map((name) => [name, []]));
const olds = [];
for (let round = 0; round < Number(rounds); ++round) {
    const before = time(old, helmet);
    olds.push(before);
    for (const [name, run] of Object.entries(cases)) {
        ratios[name].push(run() / before);
    }
}
console.log(`older program: ${median(olds).toFixed(1)} ms a frame, median of ${rounds} rounds`);
for (const [name, values] of Object.entries(ratios)) {
    const [low, high] = [Math.min(...values), Math.max(...values)].map((value) => value.toFixed(2));
    console.log(`${name}: ${median(values).toFixed(2)} times that (${low} to ${high})`);
}
