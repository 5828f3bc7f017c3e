// What every page owes its reader before a finger touches it.
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { opened } from "./opened.mjs";

const axe = await readFile(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/**
 * The sum of layout shifts; the bytes that came over the wire, and those of the module apart, which
 * is brought where a moving picture comes into view; and what must be done before the page can be used, ms
 * of processor time of its thread, so that a busy machine changes nothing.
 */
export const BOUNDS = { shift: 0.05, weight: 350_000, modules: 900_000, work: 1000 };

/** What is at fault on a page, check by check, and what was measured. */
export async function still(browser, address, how) {
    let metrics;
    const before = async (page) => {
        metrics = await page.context().newCDPSession(page);
        await metrics.send("Performance.enable", { timeDomain: "threadTicks" });
    };
    return opened(browser, address, { ...how, before }, async (page, faults) => {
        const told = (await metrics.send("Performance.getMetrics")).metrics;
        const measured = await page.evaluate(() => {
            const [load] = performance.getEntriesByType("navigation");
            const files = performance.getEntriesByType("resource");
            const bytes = (wanted) => files.filter(({ name }) => wanted === /\/modules\//.test(name))
                .reduce((sum, file) => sum + file.transferSize, 0);
            return {
                shift: window.moved,
                weight: load.transferSize + bytes(false),
                modules: bytes(true),
                ready: load.domContentLoadedEventEnd,
            };
        });
        measured.work = 1000 * told.find(({ name }) => name === "TaskDuration").value;
        for (const [name, bound] of Object.entries(BOUNDS)) {
            faults[name] = measured[name] <= bound ? [] : [`${measured[name]}, at most ${bound}`];
        }
        faults.axe = await violations(page);
        return { faults, measured };
    });
}

/** What axe finds, the folds open, in the page or in what of it `parts` selects. */
export async function violations(page, parts = "html") {
    await page.evaluate(() => { for (const fold of document.querySelectorAll("details")) fold.open = true; });
    await page.evaluate(axe);
    const { violations } = await page.evaluate((parts) =>
        axe.run([...document.querySelectorAll(parts)], { resultTypes: ["violations"] }), parts);
    return violations.flatMap(({ id, nodes }) => nodes.map((node) =>
        `${id} at ${node.target}: ${node.failureSummary.replace(/\s+/g, " ")}`));
}

const before = (mark, added) => (html) => html.replace(mark, () => added + mark);
/** For each check a damage to a page that it must see. */
export const DAMAGES = {
    console: before("</body>", "<script>undefined.field</script>"),
    failed: before("</body>", '<img src="missing.png" alt="">'),
    away: before("</body>", '<img src="http://elsewhere.example/dot.png" alt="">'),
    shift: before("</body>", `<script>document.fonts.ready.then(() => setTimeout(() => {
        const late = document.createElement("p");
        late.style.height = "40vh"; document.querySelector("main").prepend(late); }, 60))</script>`),
    weight: (html) => before("</body>", `<!-- ${Array.from({ length: 60_000 }, (_, n) =>
        Math.sin(n).toString(36).slice(4))} -->`)(html),
    modules: before("</body>", "<script>for (let n = 0; n < 200; n++) fetch(`modules/run.js?${n}`)</script>"),
    work: before("</body>", "<script>{ let sum = 0; for (let n = 0; n < 2e8; n++) sum += Math.sin(n); }</script>"),
    axe: before("</main>", '<p style="color: #bbb; background: #fff">Hard to read.</p>'),
};
