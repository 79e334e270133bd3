import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { assertNoFindings, assertNoSidewaysScroll, close, contrast, open, openAll, screenshot, shareBrowser } from "./browser.mjs";

let still; // a page with all its details open, for tests that only read: a page takes longer to draw than most tests to read it
const shared = shareBrowser(async () => {
    still = await openReport();
    await openAll(still);
});

const openReport = (options) => open(shared.browser, join(shared.report, "index.html"), options);

test("every plot draws, every picture and video loads, nothing goes wrong", async () => {
    const page = still;
    const plots = await page.$$eval(".plot-area canvas", (canvases) => canvases.map((canvas) => {
        const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        const colours = new Map();
        for (let i = 0; i < data.length; i += 4) {
            if (data[i + 3] > 200) {
                const key = (data[i] << 16) | (data[i + 1] << 8) | data[i + 2];
                colours.set(key, (colours.get(key) ?? 0) + 1);
            }
        }
        return [...colours.values()].filter((count) => count > 100).length; // axes, grid and lines have a colour each
    }));
    assert.ok(plots.length >= 5, `${plots.length} plots`);
    plots.forEach((colours, i) => assert.ok(colours >= 4, `plot ${i} has ${colours} colours`));

    await page.waitForFunction(() => [...document.images].every((image) => image.complete));
    const pictures = await page.$$eval("img", (images) => images.map((image) => [image.src, image.naturalWidth, image.alt]));
    assert.ok(pictures.length >= 4);
    pictures.forEach(([src, width, alt]) => assert.ok(width > 0 && alt.length > 20, `${src}: ${width} wide, "${alt}"`));

    await page.waitForFunction(() => [...document.querySelectorAll("video")].every((video) => video.readyState >= 1));
    const videos = await page.$$eval("video", (list) => list.map((video) => [video.videoWidth, video.duration]));
    assert.equal(videos.length, 6);
    videos.forEach(([width, seconds]) => assert.ok(width === 320 && Math.abs(seconds - 19) < 0.5, `${width}, ${seconds} s`));
    await screenshot(page, "report-light");
    assert.deepEqual(page.faults, []);
});

test("plots read out and zoom by mouse and by keyboard", async () => {
    const page = await openReport();
    const area = page.locator("#precision .plot-area");
    const readout = page.locator("#precision .readout");
    assert.equal(await area.getAttribute("role"), "application"); // else a screen reader keeps the arrow keys
    const range = () => area.getAttribute("data-range-x");
    await area.scrollIntoViewIfNeeded();
    const all = await range();

    const box = await area.boundingBox();
    await page.mouse.move(box.x + box.width * 0.5, box.y + box.height * 0.5);
    assert.match(await readout.textContent(), /view distance: \S/);
    assert.match(await page.locator("#precision .legend output").first().textContent(), /\d/);

    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.7, box.y + box.height * 0.52, { steps: 4 });
    await page.mouse.up();
    const zoomed = await range();
    assert.notEqual(zoomed, all);
    await page.locator("#precision button[aria-label='Show all']").click();
    assert.equal(await range(), all);

    await area.focus();
    await page.keyboard.press("Home");
    const first = await readout.textContent();
    await page.keyboard.press("ArrowRight");
    assert.notEqual(await readout.textContent(), first);
    await page.keyboard.press("+");
    const [low, high] = (await range()).split(" ").map(Number);
    const [allLow, allHigh] = all.split(" ").map(Number);
    assert.ok(Math.log10(high / low) < 0.7 * Math.log10(allHigh / allLow), `${low} to ${high}`);
    await page.keyboard.press("End"); // out of view: the range follows
    assert.ok(Number((await range()).split(" ")[1]) > high);
    await page.keyboard.press("0");
    assert.equal(await range(), all);
    for (let i = 0; i < 10; ++i) { // all is as far out as it goes
        await page.keyboard.press("-");
    }
    assert.equal(await range(), all);

    const legend = page.locator("#precision .legend button").first();
    await legend.focus();
    await page.keyboard.press("Enter");
    assert.equal(await legend.getAttribute("aria-pressed"), "false");
    await close(page);
});

test("it opens with the runway's number under two techniques, and a table of all in every scene", async () => {
    const page = still;
    assert.equal(await page.locator("main > section").first().getAttribute("id"), "opening");
    assert.deepEqual(await page.$$eval("#opening .wipe-name", (names) => names.map((name) => name.textContent)), ["Standard", "Anchored"]);
    assert.equal(await page.locator("#opening .earth").count(), 1);
    assert.equal(await page.locator("#opening [data-slot=sentences] p").count(), 3);
    assert.equal(await page.locator("#opening tbody tr").count(), 6);
    assert.equal(await page.locator("#opening thead th").count(), 5);
    assert.deepEqual(await page.$$eval("video", (list) => list.map((video) => video.poster.endsWith(".png"))), Array(6).fill(true));
    assert.deepEqual(page.faults, []);
});

test("a phone reads values by touch and scrolls down only", async () => {
    const page = await openReport({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
    await openAll(page);
    await assertNoSidewaysScroll(page);
    const area = page.locator("#precision .plot-area");
    await area.scrollIntoViewIfNeeded();
    // As a browser without a window moves its mouse out of the plot behind a tap, which ends what is read out.
    const read = page.evaluate(() => new Promise((resolve) => {
        const readout = document.querySelector("#precision .readout");
        new MutationObserver(() => resolve(readout.textContent)).observe(readout, { childList: true, characterData: true, subtree: true });
    }));
    await area.tap();
    assert.match(await read, /view distance: \S/);
    const small = await page.$$eval("button, select, summary, .contents a", (elements) => elements
        .filter((e) => e.offsetParent && e.getBoundingClientRect().height < 32).map((e) => e.textContent));
    assert.deepEqual(small, [], "too small for a finger");
    await screenshot(page, "report-phone");
    await close(page);
});

test("dark is dark, light is light, both can be read, and axe finds nothing in the dark", async () => {
    const paper = {};
    for (const colorScheme of ["light", "dark"]) {
        const page = await openReport({ colorScheme });
        paper[colorScheme] = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number)[0]);
        for (const selector of ["body", ".lead", "a", "figcaption", ".badge", ".verdict .badge.yes", "caption"]) {
            assert.ok(await contrast(page, selector) >= 4.5, `${selector} in ${colorScheme}: ${await contrast(page, selector)}`);
        }
        if (colorScheme === "dark") {
            await openAll(page);
            await screenshot(page, "report-dark");
            await assertNoFindings(page);
        }
        await close(page);
    }
    assert.ok(paper.light > 200 && paper.dark < 60, JSON.stringify(paper));
});

test("axe finds nothing in the light", async () => {
    await assertNoFindings(still);
});

test("the thesis' own numbers stand in its figure", async () => {
    const page = still;
    const names = await page.$$eval("#precision .legend button", (buttons) => buttons.map((button) => button.firstChild.nextSibling.textContent));
    assert.deepEqual(names.filter((name) => name.endsWith(", thesis")), ["Standard, thesis", "CDR, thesis", "Logarithmic, thesis", "LogCDR, thesis"]);
    assert.deepEqual(page.faults, []);
});

test("plots change their colours with the scheme", async () => {
    const page = await openReport({ colorScheme: "light" });
    const pixels = () => page.$eval("#precision canvas", (canvas) => canvas.toDataURL());
    const light = await pixels();
    await page.emulateMedia({ colorScheme: "dark" });
    // The plot draws when the browser gets round to it.
    await page.waitForFunction((before) => document.querySelector("#precision canvas").toDataURL() !== before, light);
    await close(page);
});

test("the keyboard reaches the results first, and sees where it is", async () => {
    const page = await openReport();
    await page.keyboard.press("Tab");
    const skip = page.locator(".skip");
    assert.ok(await skip.evaluate((element) => element === document.activeElement && element.getBoundingClientRect().x >= 0));
    await page.keyboard.press("Tab");
    const outline = await page.evaluate(() => getComputedStyle(document.activeElement).outlineWidth);
    assert.ok(parseFloat(outline) >= 2, outline);
    await close(page);
});

test("headings, landmarks and tables are what they look like", async () => {
    const page = still;
    const found = await page.evaluate(() => ({
        h1: document.querySelectorAll("h1").length,
        mains: document.querySelectorAll("main").length,
        unnamed: [...document.querySelectorAll("section")].filter((s) => !s.getAttribute("aria-labelledby")).length,
        captionless: [...document.querySelectorAll("table")].filter((t) => !t.caption?.textContent).length,
        deadLinks: [...document.querySelectorAll("a[href^='#']")].filter((a) => !document.querySelector(a.getAttribute("href"))).length,
        empty: [...document.querySelectorAll("[data-slot]")].filter((slot) => !slot.childElementCount).map((slot) => slot.dataset.slot),
        undefinedText: /undefined|NaN|\[object/.test(document.getElementById("main").innerText),
    }));
    assert.deepEqual(found, { h1: 1, mains: 1, unnamed: 0, captionless: 0, deadLinks: 0, empty: [], undefinedText: false });
    assert.deepEqual(page.faults, []);
});

test("each section names its command, device and commit, and links its JSON", async () => {
    const page = still;
    const manifest = JSON.parse(readFileSync(join(shared.report, "report.json")));
    const sources = await page.$$eval(".source pre code", (codes) => codes.map((code) => code.textContent));
    assert.equal(manifest.results.length, 34);
    for (const row of manifest.results) {
        assert.equal(row.failure, null);
        assert.ok(sources.includes(row.command), row.command);
        const json = JSON.parse(readFileSync(join(shared.report, row.json)));
        assert.equal(json.commit, manifest.commit);
        assert.ok(json.results.length > 0);
        assert.ok(await page.locator(`a[href="${row.json}"]`).count() === 1);
    }
    assert.deepEqual(manifest.files.filter((file) => !existsSync(join(shared.report, file))), []);
    assert.match(readFileSync(join(shared.report, "LICENSES.txt"), "utf8"), /uplot 1\.6\.32[^]*Leon Sorokin[^]*WITHOUT WARRANTY OF ANY KIND/);
    assert.deepEqual(page.faults, []);
});

test("shadows and certificates have a table each over all of their scenes", async () => {
    const page = still;
    const cells = (section) => page.$$eval(`#${section} tbody tr`, (rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)));
    const shadows = await cells("shadows");
    assert.deepEqual(shadows.map(([method, scene]) => [method, scene]),
        ["alley", "afc", "mixed", "orbit"].flatMap((scene) => [["Plain", scene], ["Anchored", scene]]));
    assert.deepEqual(await page.$$eval("#shadows .wipe-name", (names) => names.map((name) => name.textContent)), ["Plain", "Anchored"]);
    const certificates = await cells("certificates");
    assert.deepEqual(certificates.map(([technique, scene]) => [technique, scene]),
        ["afc", "mixed", "orbit"].flatMap((scene) => ["Standard", "Reversed", "Anchored"].map((technique) => [technique, scene])));
    assert.ok(certificates.every((row) => row[7] === "0"), "wrong after");
    assert.ok(certificates.every(([technique, , certified]) => technique !== "Anchored" || parseFloat(certified) >= 99.9), "certified");
    const files = await page.$$eval("#certificates tbody a", (links) => links.map((link) => link.getAttribute("href")));
    assert.equal(new Set(files).size, 9);
    files.forEach((file) => assert.equal(JSON.parse(readFileSync(join(shared.report, file))).rule, "the float64 ray through a pixel's centre decides"));
    assert.deepEqual(page.faults, []);
});

test("faces at one place have a row for each method, and eyes a picture and a row each", async () => {
    const page = still;
    const cells = (section) => page.$$eval(`#${section} tbody tr`, (rows) => rows.map((row) => [...row.cells].map((cell) => cell.textContent)));
    const coplanar = await cells("coplanar");
    assert.deepEqual(coplanar.map((row) => row[1]), ["None", "Polygon offset", "Layers"]);
    assert.match(coplanar[1][2], /^\S+, \S+$/);
    assert.ok(Number(coplanar[0][3].replaceAll(",", "")) > 0 && coplanar[2][3] === "0", "wrong");
    assert.match(await page.locator("#coplanar img").getAttribute("src"), /^coplanar\/anchored_none\.png$/);
    const stereo = await cells("stereo");
    assert.deepEqual(stereo.map((row) => row[0]), ["One eye", "Parallel eyes", "Toed-in eyes"]);
    assert.ok(stereo.every((row) => row[8] === "0"), "wrong");
    assert.deepEqual(await page.$$eval("#stereo img", (images) => images.map((image) => image.getAttribute("src"))),
        ["stereo-parallel-picture.png", "stereo-toed-in-picture.png"]);
    assert.deepEqual(page.faults, []);
});

test("lengths follow the unit chosen, and stay in it", async () => {
    const page = await openReport();
    const choice = page.locator("#reading select");
    const distance = page.locator("#probe tbody tr").last().locator("data.length").first();
    await openAll(page);
    const inUnits = await distance.textContent();
    assert.match(await page.locator("#advise .advice li").first().textContent(), /resolves \S+\u00a0µm at 1,000\u00a0km, and 10\u00a0mm/);
    assert.match(await page.locator("#inspect .advice li").last().textContent(), / by \S+\u00a0mm at \S+\u00a0km: /);
    assert.equal(await page.locator("#advise tbody tr", { hasText: "Standard" }).first().locator("td").nth(2).textContent(), "none");
    await choice.selectOption("km");
    assert.match(await distance.textContent(), /\u00a0km$/);
    assert.match(await page.locator("#advise .advice li").first().textContent(), /resolves \S+\u00a0km at 1,000\u00a0km/);
    await page.reload();
    assert.equal(await choice.inputValue(), "km");
    await choice.selectOption("none");
    await openAll(page);
    assert.equal(await distance.textContent(), inUnits);
    await close(page);
});

test("what is copied has all its digits", async () => {
    const page = await openReport();
    const { results } = JSON.parse(readFileSync(join(shared.report, "data", "orbit.json")));
    const wanted = results.find((row) => row.technique === "standard" && row.wrong_fraction > 0).wrong_fraction;
    const copied = await page.evaluate(() => new Promise((resolve) => {
        const kept = [];
        const read = () => kept.push(getSelection().toString());
        document.addEventListener("copy", read); // after the page's own
        getSelection().selectAllChildren(document.querySelector("#orbit tbody"));
        const before = getSelection().toString();
        document.execCommand("copy");
        setTimeout(() => resolve({ full: kept[0], before, after: getSelection().toString(), left: document.querySelectorAll("body > .visually-hidden").length }), 50);
    }));
    assert.ok(copied.full.includes(String(100 * wanted)), copied.full);
    assert.ok(!copied.before.includes(String(100 * wanted)));
    assert.equal(copied.after, copied.before); // the selection is as it was
    assert.equal(copied.left, 0);
    await close(page);
});
