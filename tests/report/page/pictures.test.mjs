import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { close, open, shareBrowser } from "./browser.mjs";

const shared = shareBrowser();

const kOfAllTechniques = ["pictures", "orbit"]; // sections
const openReport = () => open(shared.browser, join(shared.report, "index.html"));

test("every picture of every technique loads when it is chosen, and its heat map", async () => {
    const page = await openReport();
    const sections = new Set();
    for (const wipe of await page.$$(".wipe")) {
        const select = await wipe.$("select");
        if (!select) {
            continue; // two pictures, which show at once
        }
        const section = await wipe.evaluate((figure) => figure.closest("section").id);
        sections.add(section);
        const techniques = await select.$$eval("option", (options) => options.map((o) => o.textContent));
        if (kOfAllTechniques.includes(section)) {
            assert.deepEqual(techniques, ["Standard", "CDR", "Logarithmic", "LogCDR", "Reversed", "Anchored"]);
        }
        assert.ok(techniques.length > 1);
        const kinds = await wipe.$$("input[type=radio]"); // none where there are no heat maps
        for (const kind of kinds.length > 0 ? kinds : [null]) {
            await kind?.check();
            for (let i = 0; i < techniques.length; ++i) {
                await (await wipe.$("select")).selectOption(String(i));
                const upper = await wipe.$("img.upper");
                await upper.evaluate((image) => image.decode());
                assert.match(await upper.getAttribute("alt"), new RegExp(techniques[i]));
            }
        }
    }
    kOfAllTechniques.forEach((section) => assert.ok(sections.has(section), `${section} has nothing to choose`));
    await close(page);
});

test("the bar between two pictures moves by mouse and by keyboard", async () => {
    const page = await openReport();
    const box = page.locator(".wipe-box").first();
    const at = () => box.evaluate((element) => element.querySelector(".wipe-bar").getBoundingClientRect().x - element.getBoundingClientRect().x);
    await box.scrollIntoViewIfNeeded();
    const { x, y, width, height } = await box.boundingBox();
    await page.mouse.move(x + width * 0.5, y + height * 0.5);
    await page.mouse.down();
    await page.mouse.move(x + width * 0.8, y + height * 0.5, { steps: 5 });
    await page.mouse.up();
    assert.ok(Math.abs(await at() / width - 0.8) < 0.05, `${await at()} of ${width}`);
    const before = await at();
    await page.keyboard.press("ArrowLeft"); // the mouse left the focus on it
    assert.ok(await at() < before);
    await page.keyboard.press("Home");
    assert.ok(Math.abs(await at()) < 3);
    const clipped = await box.locator(".upper").evaluate((image) => getComputedStyle(image).clipPath);
    assert.match(clipped, /100%/);
    await close(page);
});
