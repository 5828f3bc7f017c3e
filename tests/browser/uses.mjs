// What a reader does with a page beyond looking at it, each tried on a page that has it: a touch
// brings what moves, other numbers redraw the figures and are judged, an address is shared, files
// are taken along, a method is tried, the picture is turned.
import { readFileSync, readdirSync } from "node:fs";
import { LOCKED, comes, differ, paints, pixels, settled, tap, text } from "./live.mjs";
import { PHONE, opened } from "./opened.mjs";
import { changed, instead } from "./served.mjs";
import { BOUNDS, violations } from "./still.mjs";
import { tabTo } from "./ways.mjs";

/** Opens all folds. */
const unfolded = (page) => page.evaluate(() => { for (const fold of document.querySelectorAll("details")) fold.open = true; });

/** The first terminal of the page, which has run without arguments and then with `words`. */
async function run(page, words) {
    await unfolded(page);
    await page.locator("button.run:not([data-predict])").first().click();
    const terminal = page.locator(".terminal").first();
    await terminal.locator(".told").waitFor();
    if (words === "") return terminal;
    await terminal.locator(".line input").fill(words);
    await terminal.locator("button[type=submit]").click();
    return terminal;
}

/** For a reader who saves data. */
const saving = (page) => page.addInitScript(() =>
    Object.defineProperty(navigator, "connection", { value: Object.assign(new EventTarget(), { saveData: true }) }));
const bringing = (page) => {
    const brought = [];
    page.on("request", (request) => { if (request.url().includes("/modules/")) brought.push(request.url()); });
    return brought;
};
/**
 * A look at the picture brings the module alone. For a reader who saves data it brings nothing, nor do
 * the keys that lead past; a finger that comes down brings it.
 */
const touch = async (browser, address, how) => [
    ...await opened(browser, address, how, async (page) => {
        const brought = bringing(page);
        await unfolded(page);
        await page.locator("figure:has(.player) .panel:last-child").first().scrollIntoViewIfNeeded();
        for (let n = 0; n < 100 && brought.length < 1; n += 1) await page.waitForTimeout(100);
        return brought.length === 1 && brought[0].endsWith(".gz") ? [] : [`a look brings ${brought}`];
    }),
    ...await touched(browser, address, { ...how, before: saving }),
];
const touched = (browser, address, how) => opened(browser, address, how, async (page) => {
    const brought = bringing(page);
    const play = page.locator(".player .play").first();
    const faults = [];
    await unfolded(page);
    await play.hover();
    await play.focus();
    await page.keyboard.press("Tab");
    await page.waitForTimeout(300);
    if (brought.length > 0) faults.push(`a look brings ${brought}`);
    await play.hover();
    await page.mouse.down();
    for (let n = 0; n < 100 && brought.length < 2; n += 1) await page.waitForTimeout(100);
    if (brought.length < 2) faults.push(`while the finger is down ${brought.length} files come`);
    await page.mouse.up();
    await tap(page);
    if (!await paints(page, 0)) faults.push("nothing moves");
    return faults;
});

/** The page's figures follow a run, nothing jumps, paper has the locked ones, and there is a way back. */
const redraws = (browser, address, how) => opened(browser, address, how, async (page) => {
    const faults = [];
    const terminal = await run(page, "--rate 4");
    const asked = await terminal.locator(".scroll table tbody tr").first().innerText().then((row) => row.split("\t"), () => []);
    if (!(asked.length === 3 && asked[1].startsWith("1.0583") && asked[2].startsWith("0.69"))) faults.push(`what is asked for: ${asked}`);
    await page.evaluate(() => { window.moved = 0; });
    const drawing = terminal.locator(".drawn", { hasText: "drawn for this." }).waitFor({ timeout: 20_000 });
    if (!await drawing.then(() => true, () => false)) return ["no figure is drawn"];
    await page.waitForTimeout(700);
    const seen = () => page.evaluate(() => {
        const visible = (selector) => [...document.querySelectorAll(selector)].filter((svg) => svg.checkVisibility()).length;
        return { again: visible(".panel svg.again"), locked: visible(".panel svg:not(.again)"), notes: visible(".redrawn"), moved: window.moved };
    });
    const drawn = await seen();
    if (drawn.again < 4 || drawn.notes === 0) faults.push(`${drawn.again} figures are drawn, ${drawn.notes} say for what`);
    if (drawn.moved > BOUNDS.shift) faults.push(`the page shifts by ${drawn.moved}`);
    await page.emulateMedia({ media: "print" });
    const paper = await seen();
    if (paper.again + paper.notes > 0 || paper.locked < drawn.again) faults.push(`on paper there are ${paper.again} of them`);
    await page.emulateMedia({ media: "screen" });
    await page.locator(".redrawn button").last().click();
    const back = await seen();
    if (back.again + back.notes > 0) faults.push(`${back.again} stay when the way back is taken`);
    return faults;
});

/** The box judges for the reader's numbers: g/(l w^2) is the cosine of the angle asked for. */
const answers = (browser, address, how) => opened(browser, address, how, async (page) => {
    const faults = [];
    const form = page.locator("form.answer");
    const angle = (rate) => Math.acos(9.80665 / (0.8 * rate ** 2)).toFixed(5);
    const holds = async (answer, kind, when) => {
        await form.locator("[name=key]").selectOption("theta");
        await form.locator("[name=value]").fill(answer);
        await form.locator("[name=value]").press("Enter");
        const judged = page.waitForFunction(() => document.querySelector("form.answer output").className !== "");
        const found = await judged.then(() => form.locator("output").getAttribute("class"), () => "silent");
        if (found !== kind) faults.push(`${answer} is ${found} ${when}`);
    };
    await unfolded(page);
    await holds(angle(5), "right", "for the page");
    await holds("acos(9.80665/(0.8*5^2))", "right", "for the page");
    await page.locator(".knob[data-name=rate] .value").fill("4");
    await holds(angle(4), "right", "for the reader");
    await holds(angle(5), "wrong", "for the reader");
    return faults;
});

/** What the page is set to: its controls, its time, what it draws. */
const set = async (page) => {
    await unfolded(page);
    await page.locator(".player .bar").first().evaluate((bar) => bar.scrollIntoView({ block: "center", behavior: "instant" }));
    await page.waitForFunction(() => /\d/.test(document.querySelector(".player .now").textContent));
    await page.waitForTimeout(700);
    return page.evaluate(() => {
        const told = (selector) => document.querySelector(`.player ${selector}`);
        return {
            typed: told(".knob[data-name=rate] .value").value, slider: told(".knob[data-name=rate] .slide input").value,
            now: told(".now").textContent, asked: document.querySelector("form.answer .asked").textContent,
            label: document.querySelector(".moving canvas").getAttribute("aria-label"), address: location.search,
        };
    });
};
/** An address sets the page; what is changed then stands in the address, which another may open. */
const shares = (browser, address, how) => opened(browser, `${address}?rate=4.2&t=0.50`, how, async (page) => {
    const faults = [];
    const first = await set(page);
    if (first.typed !== "4.2" || Number(first.slider) !== 4.2) faults.push(`the rate is ${first.typed}, its slider ${first.slider}`);
    if (!/ 0\.50/.test(first.now)) faults.push(`the time is ${first.now}`);
    if (!first.asked.includes("rate = 4.2")) faults.push(`the box asks: ${first.asked}`);
    await page.locator(".knob[data-name=rate] .slide input").focus();
    for (let n = 0; n < 5; n += 1) await page.keyboard.press("ArrowRight");
    await page.locator(".player .step").last().click();
    const mine = await set(page);
    if (mine.typed === first.typed || mine.address === first.address) faults.push(`the address stays ${mine.address}`);
    const theirs = await opened(browser, page.url(), how, set);
    for (const [what, is] of Object.entries(mine)) if (theirs[what] !== is) faults.push(`${what}: ${is} is shared as ${theirs[what]}`);
    return faults;
});

/** The files that a terminal offers for the page's own numbers are what is locked. */
const downloads = (browser, address, how) => opened(browser, address, how, async (page) => {
    const faults = [];
    const stem = new URL(address).pathname.slice(1).replace(".html", "");
    const terminal = await run(page, "");
    for (const words of ["CSV", "SVG", "JSON"]) {
        await terminal.locator(".more button", { hasText: words }).click();
        await terminal.locator(".more button", { hasText: words }).waitFor({ state: "detached" });
    }
    const files = await terminal.evaluate((terminal) => Promise.all([...terminal.querySelectorAll("a[download]")].map(async (file) =>
        ({ name: file.download, text: await fetch(file.href).then((answer) => answer.text()) }))));
    const of = (ending) => files.filter(({ name }) => name.endsWith(ending));
    const drawings = readdirSync(new URL(`${stem}/`, LOCKED)).filter((name) => name.endsWith(".svg"));
    const locked = drawings.map((name) => readFileSync(new URL(`${stem}/${name}`, LOCKED), "utf8").trim());
    const strange = of(".svg").filter(({ text }) => !locked.includes(text.trim()));
    if (of(".svg").length < 4 || strange.length > 0) faults.push(`of ${of(".svg").length} figures these are not locked: ${strange.map(({ name }) => name)}`);
    const { claims } = JSON.parse(of(".json")[0]?.text ?? '{"claims": []}');
    const rows = text(stem).split("\n").map((line) => line.split(/\s+/).slice(0, 2).join(" "));
    const other = claims.filter(({ key, printed }) => !rows.includes(`${key} ${printed}`));
    if (claims.length < 4 || other.length > 0) faults.push(`of ${claims.length} claims these are not locked: ${other.map(({ key }) => key)}`);
    const [head, ...samples] = (of(".csv")[0]?.text ?? "").trim().split("\n");
    if (!head.startsWith("t [") || samples.length < 100 || samples.some((row) => row.split(",").length !== head.split(",").length ||
        !row.split(",").every((cell) => Number.isFinite(Number(cell))))) faults.push(`a motion of ${samples.length} samples: ${head}`);
    return faults;
});

/** The number in a cell of the bench. */
const number = (cell) => Number(cell.replace(" rad", "").replace(/\s×\s10/, "e")
    .replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹⁻]/g, (c) => c === "⁻" ? "-" : String("⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c))));
/** The newest row of the bench once there are `count`; empty cells if it does not come to it. */
async function row(page, count) {
    const come = page.waitForFunction((count) => document.querySelectorAll(".bench tbody tr").length === count, count,
        { timeout: count === 1 ? 60_000 : 20_000 });
    if (!await come.then(() => true, () => false)) return Array(6).fill("");
    return page.locator(".bench tbody tr").first().locator("td").allInnerTexts();
}
/** A method and a step give a row; half the step, the error of an order's power of two less. */
const benches = (browser, address, how) => opened(browser, address, how, async (page) => {
    await unfolded(page);
    await page.locator(".bench > button").click();
    const faults = [];
    const [solved, , off] = await row(page, 1);
    if (!solved.startsWith("solve") || !(number(off) < 1e-6)) faults.push(`solve: ${solved}, off by ${off}`);
    await page.locator(".bench select").selectOption("RK4");
    const errors = [];
    for (const steps of ["400", "800"]) {
        await page.locator(".bench label", { hasText: "Steps" }).locator("input").fill(steps);
        await page.locator(".bench form button").click();
        const [method, setting, error] = await row(page, 2 + errors.length);
        if (method !== "RK4" || !setting.startsWith(`${steps} steps`)) faults.push(`${steps} steps: ${method}, ${setting}`);
        errors.push(number(error));
    }
    const order = Math.log2(errors[0] / errors[1]);
    if (!(Math.abs(order - 4) < 0.5)) faults.push(`off by ${errors}: of order ${order}`);
    return faults;
});

/** An effect that is switched in the bench shows in the page's controls, in error and cost, and in motion. */
const acts = (browser, address, how) => opened(browser, address, how, async (page) => {
    await tap(page);
    await page.locator(".bench > button").click();
    const faults = [];
    const [, , , , , before] = await row(page, 1);
    await page.locator(".bench .acting label").nth(1).click();
    const [, setting, error, , , work] = await row(page, 2);
    if (!/; friction=0\.02; against solve at 1e-1\d$/.test(setting)) faults.push(`it says: ${setting}`);
    if (!(number(error) < 1e-6) || work === before) faults.push(`off by ${error} for ${work}, before for ${before}`);
    if (!await page.locator(".player .knob[data-name=friction] [type=checkbox]").isChecked()) faults.push("the page's own control does not follow");
    if (faults.length > 0) return faults;
    await page.locator(".player .bar").first().evaluate((bar) => bar.scrollIntoView({ block: "center", behavior: "instant" }));
    if (!await paints(page, 0)) faults.push("nothing moves");
    return faults;
});

/** A hand on the still opens it and turns it, and so do the arrow keys; Home turns it back. */
const turns = (browser, address, how) => opened(browser, address, { ...how, reducedMotion: "reduce" }, async (page) => {
    const faults = [];
    await tap(page);
    const panel = page.locator("figure:has(> .player) .panel:last-child").first();
    await panel.scrollIntoViewIfNeeded();
    const box = await panel.boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 80, box.y + box.height / 2 - 30, { steps: 4 });
    await page.mouse.up();
    if (!await comes(page, (n) => drawn.has(document.querySelectorAll(".player")[n].closest("figure").querySelector("canvas")), 0, 20_000)) return ["a hand on the still opens nothing"];
    const turned = await settled(page, 0);
    // The keys come to it by Tab, from the control before.
    await page.evaluate(() => document.querySelector("main a[href]").focus());
    if (!await tabTo(page, "figure.moving .panel", faults)) return faults;
    await page.keyboard.press("Home");
    if (!await differ(page, 0, turned)) faults.push("a hand does not turn it");
    const back = await settled(page, 0);
    await page.keyboard.press("ArrowLeft");
    if (!await differ(page, 0, back)) faults.push("the arrows do not turn it");
    const away = await settled(page, 0);
    await page.keyboard.press("Home");
    await differ(page, 0, away);
    if (await settled(page, 0) !== back) faults.push("Home does not turn it back");
    return faults;
});

/** Of the stills one is to be seen, as wide as the column, and on a phone it fits the window with its play button. */
const fits = (browser, address, how) => opened(browser, address, { ...how, width: PHONE, reducedMotion: "reduce" }, async (page) => {
    const [count, high, wide] = await page.evaluate(() => {
        const figure = document.querySelector("figure:has(> .player)");
        const seen = [...figure.querySelectorAll(".panel svg")].filter((svg) => svg.checkVisibility());
        return [seen.length, figure.querySelector(".play").getBoundingClientRect().bottom - seen[0].getBoundingClientRect().top, seen[0].getBoundingClientRect().width / figure.clientWidth];
    });
    return [...count === 1 ? [] : [`${count} stills`], ...high < 640 ? [] : [`picture and play button are ${high} px high`], ...wide > 0.99 ? [] : [`the picture has ${wide} of the column`]];
});

/** A picture plays when it is seen, but not where motion is not wanted or data is paid for; paused it stays so. */
const plays = async (browser, address, how) => {
    const pressed = async (more) => opened(browser, address, { ...how, ...more }, async (page) => {
        await tap(page);
        const panel = page.locator("figure:has(> .player) .panel:last-child").first();
        await panel.evaluate((panel) => panel.scrollIntoView({ block: "center", behavior: "instant" }));
        const button = page.locator(".player .play").first();
        await comes(page, () => document.querySelector(".player .play").getAttribute("aria-pressed") === "true", null, 2000);
        const playing = await button.getAttribute("aria-pressed") === "true";
        if (!playing) return "still";
        if (!await paints(page, 0) || !await differ(page, 0, await page.evaluate(pixels, 0))) return "played, and stands still";
        await button.click();
        await page.evaluate(() => scrollTo({ top: document.body.scrollHeight, behavior: "instant" }));
        await page.waitForTimeout(300);
        await panel.evaluate((panel) => panel.scrollIntoView({ block: "center", behavior: "instant" }));
        await page.waitForTimeout(300);
        return await button.getAttribute("aria-pressed") === "true" ? "playing again" : "played";
    });
    const found = [await pressed({}), await pressed({ reducedMotion: "reduce" }), await pressed({ before: saving })];
    return `${found}` === "played,still,still" ? [] : [`the picture is ${found}`];
};

/** What is refused says so below its field, wrapped, and nowhere else; the picture stays. */
const refuses = (browser, address, how) => opened(browser, address, { ...how, width: PHONE, reducedMotion: "reduce" }, async (page) => {
    await tap(page);
    await page.locator(".player .step").first().click();
    await paints(page, 0);
    const [before, faults] = [await settled(page, 0), []];
    const knob = page.locator(".player > .knobs .knob").first();
    for (const typed of ["abc", "", "1e308"]) {
        await knob.locator(".value").fill(typed);
        await comes(page, () => document.querySelector(".knob .told:not(:empty)"), null, 10_000);
        const { said, others, over } = await knob.evaluate((knob) => {
            const told = knob.querySelector(".told");
            const all = [...document.querySelectorAll(".player .told, .player .refusal")];
            return { said: told.textContent, others: all.filter((line) => line !== told).map((line) => line.textContent).join(""),
                over: document.documentElement.scrollWidth - innerWidth };
        });
        if (said === "" || others !== "" || over > 0) faults.push(`'${typed}' is told as '${said}', '${others}', ${over} px too wide`);
        if (await settled(page, 0) !== before) faults.push(`'${typed}' changes the picture`);
    }
    await knob.locator(".back").click();
    if (!await comes(page, () => !document.querySelector(".knob .told:not(:empty)"), null, 10_000)) faults.push("it is said for ever");
    return faults;
});

/** While the controls are open the picture is pinned above them, and nowhere covers the play button. */
const pins = (browser, address, how) => opened(browser, address, how, async (page) => {
    await tap(page);
    await page.locator(".player .step").first().click();
    await paints(page, 0);
    const heights = await page.evaluate(async () => {
        const figure = document.querySelector("figure.moving"), [play, panels] = [".play", ".panels"].map((part) => figure.querySelector(part));
        const top = figure.getBoundingClientRect().top + scrollY, found = [];
        for (let part = 0; part < 1; part += 0.05) {
            scrollTo({ top: top + part * figure.offsetHeight, behavior: "instant" });
            await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
            found.push([play, panels].map((element) => element.getBoundingClientRect()).map(({ top, bottom }) => ({ top, bottom })));
        }
        return found;
    });
    const faults = heights.filter(([play, panels]) => play.top < panels.bottom - 1).map(([play, panels]) =>
        `the play button is at ${play.top}, the picture down to ${panels.bottom}`);
    if (heights.filter(([, panels]) => panels.top > 0).length < 5) faults.push("the picture does not stay");
    return faults;
});

/** The made-up recording and a file that is dropped are read and drawn, play and turn; what is none is refused below the field. */
const records = (browser, address, how) => opened(browser, address, { ...how, width: PHONE, reducedMotion: "reduce" }, async (page, { away }) => {
    const [faults, field] = [[], page.locator(".recording")];
    await unfolded(page);
    await field.scrollIntoViewIfNeeded();
    await comes(page, () => [...document.scripts].some(({ src }) => src.endsWith("recording.js")), null, 10_000);
    await page.waitForTimeout(500);
    await field.locator(".made").click();
    const told = () => field.locator(".result table").first().waitFor({ timeout: 30_000 }).then(() => true, () => false);
    if (!await told()) return [`the made-up recording is not read: ${await field.innerText()}`];
    const made = await field.locator("a[download=\"made-up.csv\"]").evaluate(async ({ href }) => (await fetch(href)).text());
    const canvas = field.locator("canvas").first();
    await comes(page, () => document.querySelector(".recording canvas").hasAttribute("aria-label"), null, 10_000);
    const shot = () => canvas.evaluate((canvas) => canvas.toDataURL());
    const before = await shot();
    await canvas.focus();
    await page.keyboard.press("ArrowLeft");
    await page.waitForTimeout(500);
    const turned = await shot();
    await field.locator(".play").first().click();
    await page.waitForTimeout(800);
    if (turned === before || await shot() === turned) faults.push("the throw does not turn or play");
    // The first throw alone, without the accelerometer, as another app would name it; then a picture.
    const throwAlone = made.split("\n").slice(0, 500).map((line) => line.split(",").slice(0, 4).join(",")).join("\n");
    for (const [name, content, refused] of [["mine.csv", throwAlone, false], ["holiday.png", "\x89PNG\r\n\x1a\n\0", true]]) {
        const data = await page.evaluateHandle(([name, content]) => {
            const carried = new DataTransfer();
            carried.items.add(new File([Uint8Array.from(content, (c) => c.charCodeAt(0))], name));
            return carried;
        }, [name, content]);
        for (const kind of ["dragenter", "dragover", "drop"]) await field.dispatchEvent(kind, { dataTransfer: data });
        await comes(page, (refused) => (document.querySelector(".recording .refusal").textContent !== "") === refused && (document.querySelector(".recording .result > *") === null) === refused, refused, 10_000);
        const [said, tables] = [await field.locator(".refusal").innerText(), await field.locator(".result table").count()];
        if ((said !== "") !== refused || (tables === 0) !== refused) faults.push(`${name} is told as '${said}', with ${tables} tables`);
    }
    const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    return [...faults, ...away, ...over > 0 ? [`${over} px too wide`] : [], ...await violations(page, ".recording")];
});

/** For each use the page that it is tried on. */
export const PAGES = {
    touch: "ch16_ex2_conical_pendulum", redraws: "ch16_ex2_conical_pendulum", answers: "ch16_ex2_conical_pendulum",
    shares: "ch16_ex2_conical_pendulum", downloads: "ch16_ex2_conical_pendulum",
    benches: "ch15_5_torque_free", acts: "ch16_2_gyroscope", turns: "ch15_5_torque_free",
    pins: "ch16_ex3_corner", fits: "ch16_2_gyroscope", plays: "ch16_2_gyroscope", refuses: "ch16_2_gyroscope",
    records: "further_1_phone",
};
export const USES = { touch, redraws, answers, shares, downloads, benches, acts, turns, pins, fits, plays, refuses, records };

const runs = (from, to) => changed(/\/modules\/run\.js$/, (script) => {
    if (!script.includes(from)) throw new Error(`run.js does not hold ${from}`);
    return script.replaceAll(from, to);
});
/** For each use a damage that it must see. */
export const DAMAGES = {
    touch: instead("live.js", '"pointerdown"', '"pointercancel"'),
    redraws: runs("this.draw(words);", ""),
    answers: instead("check.js", "follows && Live.state.size > 0", "false"),
    shares: instead("player.js", "Live.remember(t)", "Live.remember(null)"),
    downloads: runs("new Blob([text]", 'new Blob([text.replaceAll("1", "7")]'),
    benches: runs("setting=${setting}", "setting=500"),
    acts: runs("own.click()", "own.focus()"),
    turns: instead("player.js", "panel.setPointerCapture(event.pointerId);", ""),
    pins: instead("player.js", '"--pinned"', '"--loose"'),
    fits: instead("live.css", ".panel:not(:last-child)", ".panel:not(*)"),
    plays: instead("player.js", "intersectionRatio >= SEEN", "intersectionRatio > 2"),
    refuses: instead("player.js", "if (mine) [knob.refused", "if (false) [knob.refused"),
    records: changed(/\/modules\/recording\.js$/, (script) => script.replace("event.dataTransfer.files[0]", "undefined")),
};
