// Every public function of the installed headers says which threads may call it and what it throws. It also says the unit or
// space of its numbers, and how long what it refers to lives. Itself, its class or its file says so; for free functions and
// plain structs the namespace may say the threads. CONTRIBUTING.md has the words for it.

import assert from "node:assert/strict";
import { test } from "node:test";
import { allOf, childOf, childrenOf, hasDoxygen, headers, runDoxygen, saysUnits, textOf } from "./reference.mjs";

const skip = hasDoxygen ? false : "no doxygen; tools/setup.sh installs it";

const isNumber = (type) => /\b(double|float)\b/.test(type);
const refers = (type) => /[&*]$|\b(span|string_view)\b|\b(vk::|Vk)(?!Format|Result)[A-Z]/.test(type);
const textIn = (element, name) => textOf(childOf(element, name)).trim();

/** What a comment says: its words, and which of the four. */
function statements(element) {
    const comments = ["briefdescription", "detaileddescription"].flatMap((name) => childrenOf(element, name));
    const titles = comments.flatMap((comment) => allOf(comment, "simplesect")).map((part) => textIn(part, "title"));
    const lists = comments.flatMap((comment) => allOf(comment, "parameterlist"));
    return {
        text: comments.map(textOf).join(" "),
        threads: titles.includes("Threads:"),
        errors: titles.includes("Errors:") || lists.some(({ attributes }) => attributes.kind === "exception"),
        units: titles.includes("Units:"),
        lifetime: titles.includes("Lifetime:"),
    };
}

/** The functions that a program may call, each with the statements that count for it. */
function publicFunctions(compounds) {
    const byName = new Map(compounds.map((compound) => [textIn(compound, "compoundname"), compound]));
    const files = new Map(compounds.filter(({ attributes }) => attributes.kind === "file")
        .map((file) => [childOf(file, "location").attributes.file, statements(file)]));
    assert.deepEqual(headers.filter((path) => !files.has(path)), [], "headers that Doxygen did not read");
    return compounds.filter(({ attributes }) => attributes.kind !== "file").flatMap((compound) => {
        const scope = textIn(compound, "compoundname");
        const scopes = scope.split("::").map((_, last, words) => byName.get(words.slice(0, last + 1).join("::"))).filter(Boolean);
        const namespaces = scopes.filter(({ attributes }) => attributes.kind === "namespace").map(statements);
        const classes = scopes.filter(({ attributes }) => attributes.kind !== "namespace");
        // What hides its state says itself how threads may use it.
        const hidesState = classes.some(({ attributes }) => attributes.kind === "class");
        return allOf(compound, "memberdef")
            .filter(({ attributes }) => attributes.kind === "function" && attributes.prot === "public")
            .filter((member) => !/=\s*(delete|default)$/.test(textIn(member, "argsstring")))
            .map((member) => {
                const { file, line } = childOf(member, "location").attributes;
                const around = [...classes.map(statements), files.get(file)];
                around.push({ threads: !hidesState && namespaces.some(({ threads }) => threads) });
                return { member, around, name: textIn(member, "name"), where: `${file}:${line} ${scope}::${textIn(member, "name")}` };
            });
    });
}

/** Which of the four a function had to say and nothing says. */
function unsaid({ member, around, name }) {
    const own = statements(member);
    const says = (kind) => own[kind] || around.some((comment) => comment[kind]);
    const type = textIn(member, "type");
    const numbers = childrenOf(member, "param").filter((param) => isNumber(textIn(param, "type")))
        .map((param) => textIn(param, "declname"));
    const asked = {
        threads: true,
        errors: !/\bnoexcept\b/.test(textIn(member, "argsstring")) && !name.startsWith("~"),
        units: !saysUnits([...numbers, ...(isNumber(type) ? [name] : [])], own.text),
        lifetime: refers(type) && name !== "operator=",
    };
    return Object.keys(asked).filter((kind) => asked[kind] && !says(kind));
}

test("every public function says threads, errors, units and lifetime, and Doxygen warns of nothing", { skip }, () => {
    const functions = publicFunctions(runDoxygen().flatMap((tree) => allOf(tree, "compounddef")));
    assert.ok(functions.length > 300, `only ${functions.length} functions were found`);
    const findings = functions.flatMap((found) => unsaid(found).map((kind) => `${found.where}: says nothing of ${kind}`));
    assert.equal(findings.length, 0, findings.sort().join("\n"));
});
