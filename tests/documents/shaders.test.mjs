// Every function of the shaders that engines include says what it and its parameters mean. @units says the unit or space of
// its numbers, and @range which of them it takes. The comment that its file begins with may say these.

import assert from "node:assert/strict";
import { test } from "node:test";
import { files, read } from "./documents.mjs";
import { saysUnits } from "./reference.mjs";

const shaders = files("shaders/public");
const kFunction = /^(\w+) (\w+)\(([^)]*)\)\s*\{/gm;
/** A name that is a call, or no type that returns. */
const kNoType = /^(else|return|if|for|while|switch)$/;

/** The lines of a comment that ends where `at` begins, without their slashes; a blank line ends it. */
function commentBefore(text, at) {
    const lines = text.slice(0, at).split("\n").slice(0, -1);
    const first = lines.findLastIndex((line) => !line.startsWith("//")) + 1;
    return statements(lines.slice(first).join("\n"));
}

function statements(comment) {
    const text = comment.replaceAll(/^\/\/ ?/gm, "");
    const tagged = [...text.matchAll(/^@(\w+)/gm)].map(([, tag]) => tag);
    return { meaning: text.split(/^@/m)[0].trim(), text, tagged };
}

/** The functions of a file, each with what it lacks. */
function functionsOf(text) {
    const ofFile = statements(text.match(/^(\/\/.*\n)+/)?.[0] ?? "");
    return [...text.matchAll(kFunction)].filter(([, type]) => !kNoType.test(type)).map(({ index, 1: type, 2: name, 3: params }) => {
        const own = commentBefore(text, index);
        const numbers = [...params.matchAll(/\b(?:float|vec[234])\s+(\w+)/g)].map(([, param]) => param);
        const named = [...params.matchAll(/\b(?:float|u?int|bool|[iu]?vec[234])\s+(\w+)/g)].map(([, param]) => param);
        const said = (param) => new RegExp(`\\b${param}\\b`).test(`${own.text}\n${ofFile.text}`);
        const asked = {
            parameters: !named.every(said),
            meaning: own.meaning.split(/\s+/).length < 4,
            units: !saysUnits([...numbers, ...(/^(float|vec)/.test(type) ? [name] : [])], own.text) &&
                ![...own.tagged, ...ofFile.tagged].includes("units"),
            range: ![...own.tagged, ...ofFile.tagged].includes("range"),
        };
        return { name, unsaid: Object.keys(asked).filter((kind) => asked[kind]) };
    });
}

test("every function that engines include says its meaning, units and range", () => {
    const found = shaders.flatMap((path) => functionsOf(read(path)).map((each) => ({ ...each, path })));
    assert.ok(found.length > 35, `only ${found.length} functions were found`);
    const findings = found.flatMap(({ path, name, unsaid }) => unsaid.map((kind) => `${path}: ${name} says nothing of its ${kind}`));
    assert.equal(findings.length, 0, findings.join("\n"));
});

test("HLSL has the functions of GLSL and none of its own", () => {
    for (const path of shaders.filter((each) => each.endsWith(".hlsl"))) {
        assert.deepEqual(functionsOf(read(path)).map(({ name }) => name), [], path);
        assert.match(read(path), new RegExp(`#include "${path.match(/\w+(?=\.hlsl$)/)[0]}\\.glsl"`));
    }
});

test("what is not said is found", () => {
    const unsaid = (text) => functionsOf(text)[0].unsaid;
    assert.deepEqual(unsaid("float cdrA(float a) { return a; }\n"), ["parameters", "meaning", "units", "range"]);
    assert.deepEqual(unsaid("// @range Any.\n\n// Twice what a is given.\nfloat cdrA(float a) { return a; }\n"), ["units"]);
    assert.deepEqual(unsaid("// The half of a, in pixels.\n// @range Above 0.\nfloat cdrA(float a) { return a; }\n"), []);
    assert.deepEqual(unsaid("// Half the width of a pixel.\n\n// @units Pixels.\nbool cdrA(float a) {\n"), ["meaning", "range"]);
});
