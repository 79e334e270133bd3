// What the program makes: its results again, and reports in other environments.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { binomialP, chiSquared, chiSquaredP } from "../../../src/page/logic/statistics.js";
import { pairs, table41 } from "../../../src/page/logic/thesis.js";
import { assertNoFindings, close, folder, makeReport, open, openAll, program, screenshot, shareBrowser } from "./browser.mjs";

const shared = shareBrowser();

test("the printed commands give the same results again", () => {
    const again = join(folder, "again");
    mkdirSync(join(again, "data"), { recursive: true });
    const manifest = JSON.parse(readFileSync(join(shared.report, "report.json")));
    for (const name of ["precision", "pictures", "probe", "advise"]) {
        const row = manifest.results.find((result) => result.section === name);
        execFileSync(program, row.command.split(" ").slice(1), { cwd: again, stdio: "pipe" });
        const [first, second] = [shared.report, again].map((root) => JSON.parse(readFileSync(join(root, row.json))));
        assert.deepEqual(second.results, first.results, row.command);
    }
    assert.deepEqual(readdirSync(join(again, "pictures")), readdirSync(join(shared.report, "pictures")));
});

test("the program and the page quote the same thesis", () => {
    const read = (name) => JSON.parse(readFileSync(join(shared.report, "data", `${name}.json`))).results;
    const cells = read("precision").filter((cell) => cell.thesis !== undefined);
    assert.equal(cells.length, 16);
    cells.forEach((cell) => assert.equal(table41[cell.separation][cell.technique], cell.thesis));
    const { pairs: counted } = JSON.parse(readFileSync(join(shared.report, "data", "flicker.json")));
    assert.deepEqual(counted.map((pair) => [pair.left, pair.right, pair.humans_left, pair.humans_right]),
        pairs.map((pair) => [pair.left, pair.right, ...pair.chosen]));
    counted.forEach((pair, i) => {
        assert.ok(Math.abs(pair.chi_squared_p / chiSquaredP(chiSquared(...pairs[i].chosen)) - 1) < 1e-9);
        assert.ok(Math.abs(pair.binomial_p / binomialP(...pairs[i].chosen) - 1) < 1e-9);
    });
});

test("a report of some sections shows no others", async () => {
    const part = makeReport("part", ["precision", "certificates-mixed-anchored"], process.env);
    const page = await open(shared.browser, join(part, "index.html"));
    await openAll(page);
    assert.deepEqual(await page.$$eval("main > section", (list) => list.map((section) => section.id)),
        ["opening", "verdicts", "precision", "certificates", "environment"]);
    assert.deepEqual(await page.$$eval(".contents a", (list) => list.map((a) => a.getAttribute("href"))),
        ["#opening", "#verdicts", "#precision", "#certificates", "#environment"]);
    assert.deepEqual(await page.$$eval("#verdict-list a", (list) => list.map((a) => a.getAttribute("href"))), ["#precision", "#precision"]);
    assert.equal(await page.locator("#certificates tbody tr").count(), 1);
    assert.match(await page.locator("#environment pre").textContent(), / --sections precision,certificates-mixed-anchored /);
    await assertNoFindings(page);
    await screenshot(page, "report-part");
    await close(page);
    const withoutVerdicts = makeReport("unjudged", ["flicker-near", "advise"], process.env); // the verdicts are on flicker
    const unjudged = await open(shared.browser, join(withoutVerdicts, "index.html"));
    assert.deepEqual(await unjudged.$$eval("main > section", (list) => list.map((section) => section.id)),
        ["opening", "flicker", "advise", "environment"]);
    await close(unjudged);
});

test("without ffmpeg the page says so in place of the videos", async () => {
    const bare = makeReport("bare", ["flicker"], { ...process.env, PATH: join(folder, "nowhere") });
    const page = await open(shared.browser, join(bare, "index.html"));
    assert.equal(await page.locator("video").count(), 0);
    assert.match(await page.locator("#flicker .notice").textContent(), /ffmpeg was not installed/);
    await close(page);
});

test("an experiment that fails leaves the others their page, and says why", async () => {
    const tools = join(folder, "tools");
    mkdirSync(tools);
    writeFileSync(join(tools, "ffmpeg"), "#!/bin/sh\necho 'no such encoder' >&2\nexit 1\n", { mode: 0o755 });
    assert.throws(() => makeReport("failing", ["flicker", "pictures"], { ...process.env, PATH: tools }), (error) => {
        assert.equal(error.status, 1);
        assert.match(error.stderr.toString(), /^cdr: flicker: .*the rest of the report is written\n$/);
        return true;
    });
    const page = await open(shared.browser, join(folder, "failing", "index.html"));
    assert.match(await page.locator("#flicker .notice").textContent(), /^This experiment failed.*ffmpeg/);
    assert.match(await page.locator("#flicker").textContent(), /With something near the camera/); // the other half is there
    assert.equal(await page.locator("#verdict-list .badge.missing").count(), 2);
    assert.ok(await page.locator("#pictures .wipe").count() === 2);
    await close(page);
});

test("results cannot become markup", async () => {
    const page = await open(shared.browser, join(shared.report, "index.html"));
    await page.route("**/data.js", async (route) => {
        const data = readFileSync(join(shared.report, "data.js"), "utf8").replace("window.cdrReport = ", "").replace(/;\s*$/, "");
        const parsed = JSON.parse(data);
        parsed.report.device.name = "<img src=x onerror=alert(1)></script><script>window.owned = 1</script>";
        parsed.report.results[0].failure = "<b id=owned>bold</b>";
        await route.fulfill({ contentType: "text/javascript", body: `window.cdrReport = ${JSON.stringify(parsed)};` });
    });
    await page.reload();
    assert.equal(await page.evaluate(() => window.owned ?? document.querySelectorAll("#owned, img[src=x]").length), 0);
    assert.match(await page.locator("#precision .notice").textContent(), /<b id=owned>/);
    await close(page);
});
