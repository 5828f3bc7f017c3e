// node --test book.test.mjs: the built book in the directory BOOK, in the browsers CHROMIUM
// and, if there is one, FIREFOX; PAGES names some stems, else it is every page.
import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, symlinkSync } from "node:fs";
import { cpus, tmpdir } from "node:os";
import { join } from "node:path";
import { after, describe, test } from "node:test";
import * as live from "./live.mjs";
import { DESK, PHONE, chromiumAt, firefoxAt, opened } from "./opened.mjs";
import { served } from "./served.mjs";
import * as still from "./still.mjs";
import * as uses from "./uses.mjs";
import * as ways from "./ways.mjs";

const { BOOK, CHROMIUM, FIREFOX, PAGES } = process.env;
const chromium = await chromiumAt(CHROMIUM);
const book = await served(BOOK);
after(async () => { book.close(); await chromium.close(); });

/** The pages of the book; print.html holds all of them again. */
const pages = readdirSync(BOOK).filter((file) => file.endsWith(".html") && file !== "print.html" &&
    (!PAGES || PAGES.split(",").includes(file.replace(".html", "")))).map((file) => ({
    file, html: readFileSync(join(BOOK, file), "utf8"),
})).filter(({ html }) => html.includes('<main id="main"'));
/** Each page at both widths, and in both themes; which goes with which alternates. */
const VIEWS = [[[PHONE, "light"], [DESK, "coal"]], [[DESK, "light"], [PHONE, "coal"]]];
const together = { concurrency: cpus().length + 1, timeout: 1_800_000 };
/** A copy of the book with what `change` makes of its files, for as long as `use` takes. */
async function damaged(change, use) {
    const twin = await served(BOOK, change);
    try {
        return await use(twin.origin);
    } finally {
        twin.close();
    }
}

describe("every page as it is loaded", together, () => {
    const all = [];
    pages.forEach(({ file }, n) => {
        for (const [width, theme] of VIEWS[n % 2]) {
            test(`${file}, ${width} px, ${theme}`, async () => {
                const { faults, measured } = await still.still(chromium, `${book.origin}/${file}`, { width, theme });
                all.push({ file, ...measured });
                for (const [check, found] of Object.entries(faults)) assert.deepEqual(found, [], check);
            });
        }
    });
    after(() => {
        for (const name of all.length > 0 ? [...Object.keys(still.BOUNDS), "ready"] : []) {
            const [most] = all.sort((a, b) => b[name] - a[name]);
            console.log(`${name}: at most ${+most[name].toPrecision(3)} (${most.file}), half of them below ` +
                `${+all[all.length >> 1][name].toPrecision(3)}; allowed ${still.BOUNDS[name] ?? "any"}`);
        }
    });
});

const SAMPLE = "ch16_ex2_conical_pendulum.html";
describe("a page that is damaged is seen", together, () => {
    for (const [check, damage] of Object.entries(still.DAMAGES)) {
        test(check, () => damaged((path, body) => path === "/library.html" ? damage(body.toString()) : body, async (origin) => {
            const { faults } = await still.still(chromium, `${origin}/library.html`, { width: PHONE });
            assert.notDeepEqual(faults[check], []);
        }));
    }
});

const skip = existsSync(join(BOOK, "modules")) ? false : "the book has no modules";
const commands = new Set();
/** Everything that lives in a page, but for the commands that ran on another. Nothing plays by itself. */
const lives = (browser, address, how) => opened(browser, address, { ...how, reducedMotion: "reduce" }, async (page, faults) => {
    await live.tap(page);
    const found = [];
    for (let n = 0; n < await page.locator(".player").count(); n += 1) {
        for (const check of ["opens", "tells", "moves", "slides"]) found.push(...await live[check](page, n));
    }
    found.push(...await live.runs(page, commands));
    if (browser === chromium) found.push(...await still.violations(page, ".player, .terminal, canvas"));
    return [...found, ...faults.console, ...faults.failed, ...faults.away];
});

describe("every page as it is touched", { ...together, skip }, () => {
    pages.filter(({ html }) => /class="(player|run)"/.test(html)).forEach(({ file }, n) => {
        const [width, theme] = VIEWS[n % 2][0];
        test(`${file}, ${width} px, ${theme}`, async () => {
            assert.deepEqual(await lives(chromium, `${book.origin}/${file}`, { width, theme }), []);
        });
    });
});

describe("a part that does not live is seen", { ...together, skip }, () => {
    for (const [check, damage] of Object.entries(live.DAMAGES)) {
        test(check, () => damaged(damage, (origin) => opened(chromium, `${origin}/${SAMPLE}`, {}, async (page) => {
            await live.tap(page);
            const found = check === "runs" ? [] : await live.opens(page, 0);
            if (check !== "opens") found.push(...await live[check](page, check === "runs" ? new Set() : 0));
            assert.notDeepEqual(found, []);
        })));
    }
});

/** Where a way is tried: what is opened, and what is served in place of the book's files. */
const scene = (way) => ({
    file: way === "reduced" ? "index.html" : SAMPLE,
    change: (path, body) => way === "missing" && path.endsWith(".gz") ? null : body,
});
describe("the other ways to read", { ...together, skip }, () => {
    for (const [way, read] of Object.entries(ways.WAYS)) {
        const { file, change } = scene(way);
        for (const width of [PHONE, DESK]) {
            test(`${way}, ${width} px`, () => damaged(change, async (origin) => {
                const address = way === "file" ? `file://${BOOK}` : origin;
                assert.deepEqual(await read(chromium, `${address}/${file}`, { width }), []);
            }));
        }
        if (way === "file") continue;
        test(`${way}: what is damaged is seen`, () =>
            damaged((path, body) => change(path, ways.DAMAGES[way](path, body)), async (origin) => {
                assert.notDeepEqual(await read(chromium, `${origin}/${file}`, { width: PHONE }), []);
            }));
    }
    test("file: what is damaged is seen", async () => {
        const copy = mkdtempSync(join(tmpdir(), "book-"));
        for (const entry of readdirSync(BOOK)) if (entry !== "modules") symlinkSync(join(BOOK, entry), join(copy, entry));
        assert.notDeepEqual(await ways.WAYS.file(chromium, `file://${copy}/${SAMPLE}`, { width: PHONE }), []);
        rmSync(copy, { recursive: true });
    });
});

describe("what a reader does with a page", { ...together, skip }, () => {
    for (const [use, tried] of Object.entries(uses.USES)) {
        const file = `${uses.PAGES[use]}.html`;
        test(use, async () => assert.deepEqual(await tried(chromium, `${book.origin}/${file}`, { width: DESK }), []));
        test(`${use}: what is damaged is seen`, () => damaged(uses.DAMAGES[use], async (origin) => {
            assert.notDeepEqual(await tried(chromium, `${origin}/${file}`, { width: DESK }), []);
        }));
    }
});

describe("in Firefox", { skip: skip || (FIREFOX ? false : "Firefox is not here") }, () => {
    test("the sample lives", async () => {
        const firefox = await firefoxAt(FIREFOX);
        try {
            commands.clear();
            assert.deepEqual(await lives(firefox, `${book.origin}/${SAMPLE}`, { width: DESK }), []);
        } finally {
            await firefox.close();
        }
    });
});
