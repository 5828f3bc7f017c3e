// The ways to read a page that are not the usual one: with the keyboard alone, on paper, where
// motion is not wanted, as a file, without scripts, and where a module is missing.
import { comes, moves, opens, paints, pixels, prints, tap } from "./live.mjs";
import { opened } from "./opened.mjs";
import { changed, instead } from "./served.mjs";

const TABS = 400;

/** Presses Tab until what has the focus matches; says on the way whose focus cannot be seen. */
export async function tabTo(page, selector, faults) {
    for (let n = 0; n < TABS; n += 1) {
        await page.keyboard.press("Tab");
        const [there, seen, what] = await page.evaluate((selector) => {
            const at = document.activeElement;
            const { outlineStyle, boxShadow } = getComputedStyle(at);
            return [at.matches(selector), outlineStyle !== "none" || boxShadow !== "none" || at === document.body,
                at.outerHTML.slice(0, 120)];
        }, selector);
        if (!seen) faults.push(`the focus cannot be seen on ${what}`);
        if (there) return true;
    }
    faults.push(`Tab does not come to ${selector}`);
    return false;
}

/** Tab to play, Space, the arrows, a command: no mouse. */
const keyboard = (browser, address, how) => opened(browser, address, how, async (page) => {
    const faults = [];
    const pressed = () => page.evaluate(() => document.activeElement.getAttribute("aria-pressed"));
    await page.evaluate(() => { window.drawn = new Map(); });
    await tap(page);
    if (!await tabTo(page, ".player .play", faults)) return faults;
    if (await pressed() === "false") await page.keyboard.press("Space");
    if (await pressed() !== "true") faults.push("Space does not play");
    // Out of sight, and in a page behind others, nothing is painted.
    await page.bringToFront();
    await page.evaluate(() => document.querySelector("figure.moving .panel:last-child")?.scrollIntoView({ block: "nearest" }));
    if (!await paints(page, 0)) {
        const box = await page.locator("figure .panel").first().boundingBox();
        const now = await page.locator(".player .now").first().innerText();
        return [...faults, `nothing is painted: the time is '${now}', the picture ${box?.height} high from ${box?.y}`];
    }
    await page.keyboard.press("Space");
    if (await pressed() !== "false") faults.push("Space does not pause");
    if (!await tabTo(page, ".player .time", faults)) return faults;
    await page.waitForTimeout(300);
    const now = () => page.evaluate(() => document.querySelector(".player .now").textContent);
    const before = await now();
    for (let n = 0; n < 9; n += 1) await page.keyboard.press("ArrowRight");
    const leaves = (before) => document.querySelector(".player .now").textContent !== before;
    if (!await comes(page, leaves, before, 15_000)) faults.push(`the arrows leave the time at ${before}`);
    if (await page.locator("button.run").count() === 0) return faults;
    if (!await tabTo(page, "button.run", faults)) return faults;
    const { stem, arguments: words, predict } = await page.evaluate(() => ({ ...document.activeElement.dataset }));
    await page.keyboard.press("Enter");
    await page.locator(".terminal").waitFor();
    if (predict !== undefined) {
        await page.keyboard.type("It goes faster.");
        await page.keyboard.press("Tab");
        await page.keyboard.press("Enter");
    }
    faults.push(...await prints(page.locator(".terminal"), `${stem} ${words}`.trim(), false));
    return faults;
});

/** What is to be seen of figures and of what moves them. */
const seen = (page) => page.evaluate(() => {
    const visible = (element) => element.checkVisibility({ visibilityProperty: true, opacityProperty: true }) &&
        element.getBoundingClientRect().width > 0;
    const count = (selector) => [...document.querySelectorAll(selector)].filter(visible).length;
    return { stills: count("figure .panel svg"), live: count(".player, .runs, button.run, .terminal, .bench, canvas") };
});
const stills = (page) => page.evaluate(() => {
    for (const fold of document.querySelectorAll("details")) fold.open = true;
    return document.querySelectorAll("figure .panel svg").length;
});
const locked = (shown, all) => shown.stills === all && shown.live === 0 ? []
    : [`${shown.stills} of ${all} locked figures and ${shown.live} live parts are to be seen`];

/** What moves, and what was run, gives way to the locked figures. */
const print = (browser, address, how) => opened(browser, address, how, async (page) => {
    const all = await stills(page);
    await tap(page);
    const faults = await opens(page, 0);
    await page.emulateMedia({ media: "print" });
    faults.push(...locked(await seen(page), all));
    const paper = await page.pdf({ format: "A4" });
    if (paper.length < 10_000) faults.push(`the paper has ${paper.length} bytes`);
    return faults;
});

/** Nothing moves by itself; play goes in steps. */
const reduced = (browser, address, how) => opened(browser, address, { ...how, reducedMotion: "reduce" }, async (page) => {
    await tap(page);
    await page.evaluate(() => document.querySelector(".player .bar").scrollIntoView({ block: "center", behavior: "instant" }));
    await page.waitForTimeout(1500);
    const before = await page.evaluate(pixels, 0);
    await page.waitForTimeout(1500);
    const faults = await page.evaluate(pixels, 0) === before ? [] : ["the picture moves by itself"];
    faults.push(...await moves(page, 0));
    return faults;
});

/** A page that is opened as a file is as live. */
const file = (browser, address, how) => opened(browser, address, how, async (page, { console, failed, away }) => {
    await tap(page);
    const faults = [...await opens(page, 0), ...await moves(page, 0)];
    // Fonts that are asked for early come twice: a file has no origin.
    const told = [...console, ...failed].filter((line) => !/fonts?\/|net::ERR_FAILED$/.test(line));
    return [...faults, ...told, ...away];
});

/** Without scripts the page shows its locked figures, and no control that does nothing. */
const unscripted = (browser, address, how) => opened(browser, address, { ...how, javaScriptEnabled: false }, async (page) => {
    const all = await stills(page);
    return locked(await seen(page), all);
});

/** Where a module does not arrive the locked figure stays, and the page says so. */
const missing = (browser, address, how) => opened(browser, address, how, async (page, { console }) => {
    await stills(page);
    const all = await page.locator("figure:not(:has(> .player)) .panel svg, .panel:last-child svg").count();
    const player = page.locator(".player").first();
    await player.locator(".play").click();
    const said = page.locator(".player .refusal:not(:empty)").first().waitFor();
    const faults = await said.then(() => [], () => ["nothing is said"]);
    const shown = await seen(page);
    if (shown.stills !== all) faults.push(`${shown.stills} of ${all} locked figures are to be seen`);
    return [...faults, ...console.filter((line) => !line.startsWith("Failed to load resource"))];
});

export const WAYS = { keyboard, print, reduced, file, unscripted, missing };

/** For each way a damage that it must see. */
export const DAMAGES = {
    keyboard: changed(/html$/, (html) => html.replaceAll('class="play"', 'class="play" tabindex="-1"')),
    print: instead("live.css", "@media print", "@media speech"),
    reduced: instead("player.js", "(prefers-reduced-motion: reduce)", "speech"),
    unscripted: changed(/html$/, (html) => html.replace(/<html([^>]*) class="/, '<html$1 class="live ')),
    missing: instead("live.css", "@media print", "figure:has(.player) .panel svg { visibility: hidden } @media print"),
};
