// From the finger to the first painted frame, and to the second.
import { chromiumAt, opened } from "./opened.mjs";
import { served } from "./served.mjs";
const book = await served(process.env.BOOK);
const browser = await chromiumAt("/usr/bin/chromium");
const pages = process.argv.slice(2);
const rounds = 7;
for (const stem of pages) {
    const all = [];
    for (let r = 0; r < rounds; r += 1) {
        const before = (page) => page.addInitScript(() => {
            window.marks = []; let t0 = null;
            addEventListener("pointerdown", (e) => { t0 = performance.now(); }, { capture: true });
            addEventListener("click", (e) => { if (t0 !== null) window.clicked = performance.now() - t0; }, { capture: true });
            for (const name of ["clearRect", "fillRect"]) {
                const own = CanvasRenderingContext2D.prototype[name];
                CanvasRenderingContext2D.prototype[name] = function (...a) {
                    if (t0 !== null) { const t = performance.now() - t0; if (!marks.length || t - marks.at(-1) > 3) marks.push(t); }
                    return own.apply(this, a);
                };
            }
        });
        const marks = await opened(browser, `${book.origin}/${stem}.html`, { width: 1280, before }, async (page) => {
            await page.evaluate(() => { for (const fold of document.querySelectorAll("details")) fold.open = true; }); await page.waitForTimeout(800);
            const play = page.locator(".player .play").first();
            await play.scrollIntoViewIfNeeded(); await page.waitForTimeout(300);
            await play.hover();
            await page.mouse.down(); await page.mouse.up();
            await page.waitForFunction(() => marks.length >= 3, null, { timeout: 8000 }).catch(() => {});
            return page.evaluate(() => ({ marks: marks.slice(0, 3), clicked }));
        });
        all.push(marks);
    }
    const med = (k) => { const s = all.map(k).sort((a, b) => a - b); return `${s[0]?.toFixed(0)}/${s[rounds >> 1]?.toFixed(0)}/${s.at(-1)?.toFixed(0)}`; };
    console.log(stem, "first frame min/med/max", med((m) => m.marks[0]), "second", med((m) => m.marks[1]), "click", med((m) => m.clicked));
}
await browser.close(); book.close();
process.exit(0);
