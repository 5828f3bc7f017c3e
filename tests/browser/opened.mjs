// A page as a reader opens it, and what went wrong on the way.
import { chromium, firefox } from "playwright-core";

/** Headless Chromium, which can reach no name and no machine but this one. */
export const chromiumAt = (executablePath) => chromium.launch({
    executablePath,
    args: ["--no-sandbox", "--disable-quic", "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"],
});
/** Firefox as the system's packages bring it. */
export const firefoxAt = (executablePath) => firefox.launch({ executablePath, channel: "moz-firefox" });

/** ms, for a machine that does much else. */
export const PATIENCE = 120_000;
export const DESK = 1280;
export const PHONE = 390;

/** Runs in the page before its own scripts: sums what moves by itself. */
const watch = (theme) => {
    window.moved = 0;
    if (!location.host) return; // an empty page before the first keeps nothing
    localStorage.setItem("mdbook-theme", theme);
    if (!PerformanceObserver.supportedEntryTypes.includes("layout-shift")) return;
    // What follows a touch within half a second is the reader's doing; a machine that does much
    // else may hand the touch over later than that, so the half second begins where it arrives.
    let touched = -Infinity;
    addEventListener("click", () => { touched = performance.now(); }, { capture: true });
    new PerformanceObserver((list) => {
        for (const shift of list.getEntries()) {
            if (!shift.hadRecentInput && shift.startTime > touched + 500) window.moved += shift.value;
        }
    }).observe({ type: "layout-shift", buffered: true });
};

/**
 * Waits until the letters are there, what was asked for has come or failed, and what followed has
 * been drawn: by events, since a machine that does much else may need any time for them.
 */
async function settled(page) {
    await Promise.all([
        page.evaluate(() => document.fonts.ready.then(() => new Promise((done) => setTimeout(done, 300)))),
        page.waitForLoadState("networkidle"),
    ]);
    const drawn = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done))));
    await page.evaluate(drawn);
}

/**
 * Opens `address` and hands `use(page, faults)` the page as it is once its letters are there and what
 * follows them;
 * `faults` names what happened that must not: `{ console, failed, away }`. `before(page)` comes
 * before the address is gone to; what else stands in `how` is Playwright's.
 */
export async function opened(browser, address, { width = DESK, theme = "light", before = () => {}, ...more }, use) {
    const context = await browser.newContext({ viewport: { width, height: width === PHONE ? 844 : 800 }, ...more });
    try {
        if (more.javaScriptEnabled !== false) await context.addInitScript(watch, theme);
        context.setDefaultTimeout(PATIENCE);
        const page = await context.newPage();
        const faults = { console: [], failed: [], away: [] };
        page.on("console", (line) => {
            if (["error", "warning"].includes(line.type())) faults.console.push(line.text());
        });
        page.on("pageerror", (error) => faults.console.push(String(error)));
        page.on("request", (request) => {
            const { protocol, origin } = new URL(request.url());
            const ours = ["data:", "blob:"].includes(protocol) || address.startsWith(origin === "null" ? protocol : origin);
            if (!ours) faults.away.push(request.url());
        });
        page.on("requestfailed", (request) => faults.failed.push(`${request.url()}: ${request.failure()?.errorText}`));
        page.on("response", (answer) => {
            if (answer.status() >= 400) faults.failed.push(`${answer.url()}: ${answer.status()}`);
        });
        await before(page);
        await page.goto(address, { waitUntil: "load" });
        if (more.javaScriptEnabled === false) await page.waitForTimeout(500);
        else await settled(page);
        return await use(page, faults);
    } finally {
        await context.close();
    }
}
