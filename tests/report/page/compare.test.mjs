import assert from "node:assert/strict";
import { copyFileSync, mkdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { techniqueTitles } from "../../../src/page/logic/thesis.js";
import { answered, nextTrial, startSitting, store } from "../../../src/page/logic/sitting.js";
import { makeTrials, toCsv, makeAnswer, fromCsv, maxBytes } from "../../../src/page/logic/trials.js";
import { assertNoFindings, assertNoSidewaysScroll, close, folder, open, screenshot, shareBrowser } from "./browser.mjs";

const shared = shareBrowser();

/** Opens the page as somebody new would: nothing kept. Videos play as fast as browsers can. */
async function openCompare(query = "", options = {}) {
    const page = await open(shared.browser, `${join(shared.report, "compare.html")}${query}`, { acceptDownloads: true, ...options });
    await page.evaluate(() => {
        const video = document.getElementById("video");
        video.defaultPlaybackRate = 16;
        video.playbackRate = 16;
    });
    return page;
}

const left = (page) => page.locator("#left");
const play = (page) => page.locator("#play");

async function start(page, name) {
    await page.fill("#participant", name);
    await page.click("#start button");
    await page.locator("#trial").waitFor();
}

/** Plays the video to its end. */
async function watch(page, how) {
    await how();
    await page.waitForFunction(() => !document.getElementById("left").disabled, null, { timeout: 600_000 });
}

/** All answers of one person, as a page kept them. */
function wholeSitting(name, seed) {
    let sitting = startSitting(name, seed);
    while (nextTrial(sitting)) {
        sitting = answered(sitting, { side: "left", seconds: 1, plays: 1 });
    }
    return sitting;
}

async function savedBy(page, button) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(button)]);
    return readFileSync(await download.path(), "utf8");
}

test("by mouse, from start to file", async () => {
    const page = await openCompare("?seed=mouse");
    await screenshot(page, "compare-welcome");
    await start(page, "Ada");
    const trials = makeTrials("mouse");
    for (const [i, trial] of trials.entries()) {
        assert.equal(await page.locator("#trial-title").textContent(), `Video ${i + 1} of 6`);
        assert.equal(await page.locator("#progress").evaluate((p) => p.value), i);
        const shown = await page.locator("#video").evaluate((video) => [video.src.split("/").pop(), getComputedStyle(video).transform]);
        assert.equal(shown[0], `${trial.pair.left}_${trial.pair.right}.mp4`);
        assert.equal(shown[1] !== "none", trial.mirrored, "mirrored swaps the sides");
        assert.ok(await left(page).isDisabled(), "no answer before the video");
        await watch(page, () => play(page).click());
        if (i === 1) {
            await screenshot(page, "compare-trial");
        }
        await (i % 2 ? page.locator("#right") : left(page)).click();
    }
    assert.ok(await page.locator("#done").isVisible());
    assert.match(await page.locator("#agreement strong").textContent(), /^You agreed (with the counter in \d of \d, and )?with the majority of 2013 in \d of 6\.$/);
    const maps = page.locator("#pairs img");
    assert.equal(await maps.count(), 12, "two heat maps a pair");
    const chosen = trials.map((trial, i) => techniqueTitles[i % 2 ? trial.right : trial.left]);
    assert.deepEqual(await page.$$eval("#pairs li > p", (list) => list.map((p) => p.textContent.match(/You chose (.*)\.$/)[1])), chosen);
    for (const [i, trial] of trials.entries()) {
        await maps.nth(2 * i).scrollIntoViewIfNeeded();
        await maps.nth(2 * i).evaluate((image) => image.decode());
        assert.match(await maps.nth(2 * i).getAttribute("src"), new RegExp(`/afc_${trial.left}_wrong\\.png$`));
        assert.match(await maps.nth(2 * i + 1).getAttribute("src"), new RegExp(`/afc_${trial.right}_wrong\\.png$`));
    }
    await assertNoFindings(page);
    await screenshot(page, "compare-done");
    const answers = fromCsv(await savedBy(page, "#save"));
    assert.deepEqual(answers.map((a) => [a.participant, a.seed, a.trial, a.chosen]),
        trials.map((trial, i) => ["Ada", "mouse", i + 1, i % 2 ? trial.right : trial.left]));
    await close(page);
});

test("by keyboard alone, and the arrows wait for the end of the video", async () => {
    const page = await openCompare("?seed=keys");
    await page.locator("#participant").focus();
    await page.keyboard.type("Bea");
    await page.keyboard.press("Enter");
    for (let i = 0; i < 6; ++i) {
        await page.keyboard.press("ArrowLeft"); // too early
        assert.equal(await page.locator("#trial-title").textContent(), `Video ${i + 1} of 6`);
        await watch(page, () => page.keyboard.press("Space"));
        await page.keyboard.press("ArrowRight");
    }
    assert.equal(await page.evaluate(() => document.activeElement.id), "done-title");
    const answers = fromCsv(await savedBy(page, "#save"));
    assert.deepEqual(answers.map((a) => a.side), Array(6).fill("right"));
    assert.ok(answers.every((a) => a.plays === 1));
    await close(page);
});

test("a video that the browser stops goes on where it was, and arrow keys in the results answer nothing", async () => {
    const page = await openCompare("?seed=pause");
    await start(page, "Flo");
    await page.evaluate(() => {
        const video = document.getElementById("video");
        video.loop = true; // as a browser's menu does
        video.playbackRate = 0.1;
        document.getElementById("play").click();
    });
    await page.waitForFunction(() => {
        const video = document.getElementById("video");
        const moves = video.currentTime > 0;
        return moves && (video.pause(), true);
    });
    await page.waitForFunction(() => !document.getElementById("play").disabled, null, { timeout: 10_000 });
    assert.match(await page.locator("#hint").textContent(), /^The video has stopped/);
    const [stopped, resumed] = await page.evaluate(() => {
        const video = document.getElementById("video");
        const at = video.currentTime;
        video.playbackRate = 16;
        document.getElementById("play").click();
        return [at, video.currentTime];
    });
    assert.ok(stopped > 0 && resumed >= stopped, `${stopped}, then ${resumed}`);
    await page.waitForFunction(() => !document.getElementById("left").disabled, null, { timeout: 30_000 });
    await page.locator("#results summary").click();
    for (const place of ["#results summary", "#tally .scroll"]) {
        await page.locator(place).focus();
        await page.keyboard.press("ArrowLeft");
        assert.equal(await page.locator("#trial-title").textContent(), "Video 1 of 6", place);
    }
    await page.locator("#play").focus();
    await page.keyboard.press("ArrowLeft");
    assert.equal(await page.locator("#trial-title").textContent(), "Video 2 of 6");
    await close(page);
});

test("answers survive a reload, and another lot starts anew", async () => {
    const page = await openCompare("?seed=reload");
    await start(page, "Cy");
    await watch(page, () => play(page).click());
    await left(page).click();
    await page.reload();
    assert.equal(await page.locator("#trial-title").textContent(), "Video 2 of 6");
    assert.ok(await left(page).isDisabled());
    await page.locator("#results summary").click();
    assert.match(await page.locator("#counted").textContent(), /^1 answer of 1 person/);
    await page.goto(page.url().replace("seed=reload", "seed=other"));
    assert.ok(await page.locator("#welcome").isVisible());
    assert.equal(await page.locator("#seed").textContent(), "other");
    await close(page);
});

test("answers that nobody saved survive that somebody else starts", async () => {
    const page = await openCompare();
    const ada = wholeSitting("Ada", "ada");
    await page.evaluate((text) => localStorage.setItem("cdr-compare", text), store(ada));
    await page.reload();
    const expectAda = async () => {
        await page.reload();
        await page.locator("#results summary").click();
        assert.match(await page.locator("#counted").textContent(), /^6 answers of 1 person/);
        assert.deepEqual(fromCsv(await savedBy(page, "#save-all")), ada.answers);
    };
    await page.click("#again");
    await start(page, "Bea");
    await expectAda();
    await page.goto(`${page.url()}?seed=ada2`); // another lot starts anew
    await start(page, "Cy");
    await expectAda();
    await close(page);
});

test("answers that another tab keeps meanwhile survive", async () => {
    const page = await openCompare("?seed=tab");
    const keepInAnotherTab = (sitting) => page.evaluate((text) => localStorage.setItem("cdr-compare", text), store(sitting));
    const ada = wholeSitting("Ada", "ada");
    const bea = wholeSitting("Bea", "bea");
    await keepInAnotherTab(ada);
    await start(page, "Cy");
    await keepInAnotherTab(bea);
    await watch(page, () => play(page).click());
    await left(page).click();
    await page.reload();
    assert.equal(await page.locator("#trial-title").textContent(), "Video 2 of 6");
    await page.locator("#results summary").click();
    assert.match(await page.locator("#counted").textContent(), /^13 answers of 3 people/);
    await close(page);
});

test("a sitting is not written over while its answers cannot be kept", async () => {
    const page = await openCompare("?seed=full");
    const kept = store(wholeSitting("Ada", "ada"));
    await page.evaluate((text) => {
        localStorage.setItem("cdr-compare", text);
        const setItem = Storage.prototype.setItem;
        Storage.prototype.setItem = function (key, value) {
            if (key === "cdr-compare-others") {
                throw new Error("full");
            }
            setItem.call(this, key, value);
        };
    }, kept);
    await start(page, "Bea");
    assert.equal(await page.evaluate(() => localStorage.getItem("cdr-compare")), kept);
    await close(page);
});

test("kept answers that the page cannot read are set aside", async () => {
    const page = await openCompare("?seed=strange");
    for (const key of ["cdr-compare-others", "cdr-compare"]) {
        await page.evaluate((name) => localStorage.setItem(name, "strange"), key);
        await page.reload();
        await start(page, "Bea");
        const entries = await page.evaluate(() => Object.entries(localStorage));
        assert.deepEqual(entries.filter(([name]) => name.startsWith(`${key}-unread-`)).map(([, text]) => text), ["strange"]);
        assert.match(new Map(entries).get("cdr-compare"), /"participant":"Bea"/);
        await page.evaluate(() => localStorage.clear());
    }
    await close(page);
});

test("files of others are counted once, with both tests; strange and large files are named", async () => {
    const page = await openCompare("?seed=load");
    await page.locator("#results summary").click();
    const files = [...Array(12).keys()].map((person) => {
        const trials = makeTrials(person);
        const answers = trials.map((trial, i) => {
            const wanted = trial.pair.chosen[0] > person ? trial.pair.left : trial.pair.right; // as in 2013
            const side = trial.left === wanted ? "left" : "right";
            return makeAnswer({ participant: `p${person}`, seed: person, number: i + 1, trial, side, seconds: 1, plays: 1 });
        });
        return { name: `p${person}.csv`, mimeType: "text/csv", buffer: Buffer.from(toCsv(answers)) };
    });
    const strange = { name: "strange.csv", mimeType: "text/csv", buffer: Buffer.from("<img src=x onerror=alert(1)>\n1,2") };
    const large = { name: "large.csv", mimeType: "text/csv", buffer: Buffer.alloc(maxBytes + 1, "\n") };
    await page.setInputFiles("#load", [...files, strange, large, files[0]]);
    await page.waitForFunction(() => document.getElementById("counted").textContent.startsWith("72 answers of 12 people"));
    assert.match(await page.locator("#refused").textContent(), 
        /^strange\.csv: not answers of this experiment.*; large\.csv: over the limit.*; 6 answers left out: their name, lot and pair are here already$/);
    const rows = await page.$$eval("#tally tbody tr", (list) => list.map((row) => [...row.cells].map((cell) => cell.textContent)));
    assert.deepEqual(rows[0].slice(1), ["2 : 10", "5.333", "0.03857", "2 : 10", "5.333", "0.03857"]);
    assert.deepEqual(rows[5].slice(1, 4), ["1 : 11", "8.333", "0.006348"]);
    assert.deepEqual(rows[1].slice(1, 4), ["0 : 12", "12", "0.0004883"]);
    assert.equal(fromCsv(await savedBy(page, "#save-all")).length, 72);
    await screenshot(page, "compare-results");
    await close(page);
});

test("without videos it says what makes them", async () => {
    const alone = join(folder, "alone");
    mkdirSync(alone);
    copyFileSync(join(shared.report, "compare.html"), join(alone, "compare.html"));
    const page = await open(shared.browser, join(alone, "compare.html"));
    await page.click("#start button");
    await page.locator("#missing").waitFor();
    assert.match(await page.locator("#missing").textContent(), /cdr report --quick -o/);
    assert.ok(await play(page).isDisabled() && await left(page).isDisabled());
    page.faults = page.faults.filter((fault) => !/\.mp4|ERR_FILE_NOT_FOUND/.test(fault)); // the missing video itself
    await close(page);
});

test("a browser that lends no storage still runs it", async () => {
    const page = await open(shared.browser, join(shared.report, "compare.html"));
    await page.context().addInitScript(() => Object.defineProperty(window, "localStorage", { get() { throw new Error("denied"); } }));
    await page.reload();
    await start(page, "Di");
    assert.equal(await page.locator("#trial-title").textContent(), "Video 1 of 6");
    await close(page);
});

test("on a phone, by touch, in the dark", async () => {
    const page = await openCompare("?seed=phone", { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true, colorScheme: "dark" });
    await assertNoSidewaysScroll(page);
    await page.fill("#participant", "Eve");
    await page.locator("#start button").tap();
    await watch(page, () => play(page).tap());
    await assertNoSidewaysScroll(page);
    await screenshot(page, "compare-phone-dark");
    await page.locator("#right").tap();
    assert.equal(await page.locator("#trial-title").textContent(), "Video 2 of 6");
    await page.locator("#results summary").tap();
    await assertNoSidewaysScroll(page);
    await close(page);
});
