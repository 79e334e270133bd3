// A headless browser that watches for what a page opened from a file must never do, and the report to open in it.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, mkdirSync, readFileSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before } from "node:test";
import { pathToFileURL } from "node:url";

// The packages live with the page, which is not above this file.
const requireOfPage = createRequire(new URL("../../../src/page/package.json", import.meta.url));
const { chromium } = requireOfPage("playwright-core");
const axeSource = readFileSync(requireOfPage.resolve("axe-core/axe.min.js"), "utf8");

export const program = process.env.CDR_PROGRAM;
export const folder = mkdtempSync(join(tmpdir(), "cdr_report_"));
const screenshots = process.env.CDR_ALL_CASES && process.env.CDR_SCREENSHOTS;

/**
 * For all tests of a file: a `browser`, and a `report` that is a copy of the one that the test Report.Made wrote.
 * @param {() => Promise<void>} prepare what else is done before the first test.
 */
export function shareBrowser(prepare = async () => {}) {
    const shared = { browser: null, report: join(folder, "report") };
    before(async () => {
        cpSync(process.env.CDR_REPORT, shared.report, { recursive: true });
        shared.browser = await chromium.launch({ executablePath: process.env.CDR_CHROMIUM, args: ["--no-sandbox"] }); // root in containers
        await prepare();
    });
    after(async () => {
        await shared.browser?.close();
        rmSync(folder, { recursive: true });
    });
    return shared;
}

/** The smallest report of some sections, made by the program under test in another environment. */
export function makeReport(name, sections, environment) {
    execFileSync(program, ["report", "--smallest", "--sections", sections.join(","), "-o", join(folder, name)], { env: environment, stdio: "pipe" });
    return join(folder, name);
}

/**
 * Opens a page of a folder. `page.faults` lists errors, and requests that leave the folder or fail.
 * @param {object} options of the browser's context, such as viewport and colorScheme.
 */
export async function open(browser, path, options = {}) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
    const page = await context.newPage();
    page.setDefaultTimeout(600_000); // a slow machine is no reason to fail
    page.faults = [];
    page.on("console", (message) => ["error", "warning"].includes(message.type()) && page.faults.push(message.text()));
    page.on("pageerror", (error) => page.faults.push(error.message));
    // A browser stops loading a video when it has seen enough of it.
    page.on("requestfailed", (request) => request.resourceType() === "media" && request.failure()?.errorText === "net::ERR_ABORTED" ||
        page.faults.push(`${request.url()} failed: ${request.failure()?.errorText}`));
    page.on("request", (request) => {
        if (!/^(file|data|blob):/.test(request.url())) {
            page.faults.push(`a request to ${request.url()}`);
        }
    });
    const [file, query] = path.split("?");
    await page.goto(pathToFileURL(file).href + (query ? `?${query}` : ""), { waitUntil: "load" });
    return page;
}

/** Opens all details of a report, and waits until their plots are drawn. */
export async function openAll(page) {
    await page.evaluate(() => document.querySelectorAll("details").forEach((d) => { d.open = true; }));
    await page.waitForFunction(() => [...document.querySelectorAll(".plot-area")].every((area) => area.querySelector("canvas")));
}

/** Closes a page that did nothing wrong. */
export async function close(page) {
    const { faults } = page;
    await page.context().close();
    assert.deepEqual(faults, []);
}

/** For people to look at, with CDR_ALL_CASES: a picture of a whole page takes as long as a test. */
export async function screenshot(page, name) {
    if (screenshots) {
        mkdirSync(screenshots, { recursive: true });
        await page.screenshot({ path: join(screenshots, `${name}.png`), fullPage: true });
    }
}

/** axe-core, which looks at the page as a screen reader does, finds nothing. */
export async function assertNoFindings(page) {
    await page.evaluate(axeSource); // not as a script element, which the page's policy would refuse from elsewhere
    const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
    assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map((node) => node.html.slice(0, 120)).join(" | ")}`), []);
}

/** Nothing sticks out to the side. */
export async function assertNoSidewaysScroll(page) {
    // Not window.innerWidth: where content is wider, a phone's view grows with it.
    const view = page.viewportSize().width;
    const content = await page.evaluate(() => Math.max(document.documentElement.scrollWidth, window.innerWidth));
    assert.ok(content <= view, `${content} pixels of content in a view of ${view}`);
}

/** WCAG contrast of an element's text against the page's background. */
export function contrast(page, selector) {
    return page.evaluate((sel) => {
        const channels = (css) => css.match(/[\d.]+/g).slice(0, 3).map((c) => c / 255);
        const light = (rgb) => {
            const [r, g, b] = rgb.map((c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
            return 0.2126 * r + 0.7152 * g + 0.0722 * b;
        };
        const text = light(channels(getComputedStyle(document.querySelector(sel)).color));
        const paper = light(channels(getComputedStyle(document.body).backgroundColor));
        return (Math.max(text, paper) + 0.05) / (Math.min(text, paper) + 0.05);
    }, selector);
}
