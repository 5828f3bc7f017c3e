// node --test book.test.mjs: the built book in the directory BOOK, in the browsers CHROMIUM
// and, if there is one, FIREFOX.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { cpus } from "node:os";
import { after, describe, test } from "node:test";
import { DESK, PHONE, chromiumAt } from "./opened.mjs";
import { served } from "./served.mjs";
import { BOUNDS, TWINS, still } from "./still.mjs";

const { BOOK, CHROMIUM, PAGES } = process.env;
const browser = await chromiumAt(CHROMIUM);
const book = await served(BOOK);
after(async () => { book.close(); await browser.close(); });

const none = Object.fromEntries(["console", "failed", "away", "shift", "weight", "work", "axe"].map((name) => [name, []]));
/** The pages of the book; `print` holds all of them again, and is opened only to be printed. */
const pages = readdirSync(BOOK).filter((file) => file.endsWith(".html") &&
    readFileSync(`${BOOK}/${file}`, "utf8").includes('<main id="main"') && !["print.html"].includes(file) &&
    (!PAGES || PAGES.split(",").includes(file.replace(".html", ""))));
/** Each page at both widths, and in both themes; which goes with which alternates. */
const VIEWS = [[[PHONE, "light"], [DESK, "coal"]], [[PHONE, "coal"], [DESK, "light"]]];

describe("every page as it is loaded", { concurrency: cpus().length + 1 }, () => {
    const all = [];
    pages.forEach((file, n) => {
        for (const [width, theme] of VIEWS[n % 2]) {
            test(`${file}, ${width} px, ${theme}`, async () => {
                const { faults, measured } = await still(browser, `${book.origin}/${file}`, { width, theme });
                all.push({ file, ...measured });
                assert.deepEqual(faults, none);
            });
        }
    });
    after(() => {
        for (const name of [...Object.keys(BOUNDS), "ready"]) {
            const [most] = all.sort((a, b) => b[name] - a[name]);
            console.log(`${name}: at most ${+most[name].toPrecision(3)} (${most.file}), half of them ` +
                `${+all[all.length >> 1][name].toPrecision(3)}; allowed ${BOUNDS[name] ?? "any"}`);
        }
    });
});

describe("what is damaged is seen", { concurrency: cpus().length + 1 }, () => {
    for (const [check, damage] of Object.entries(TWINS)) {
        test(check, async () => {
            const twin = await served(BOOK, (path, body) =>
                path === "/library.html" ? damage(body.toString()) : body);
            const { faults } = await still(browser, `${twin.origin}/library.html`, { width: PHONE, theme: "light" });
            twin.close();
            assert.notDeepEqual(faults[check], [], `${check} sees nothing`);
        });
    }
});
