// What lives in a page, used as a reader uses it: each function gives what is at fault.
import { readFileSync, readdirSync } from "node:fs";
import { PATIENCE } from "./opened.mjs";
import { instead } from "./served.mjs";
import { BOUNDS } from "./still.mjs";

export const LOCKED = new URL("../snapshots/", import.meta.url);

/** Waits in the page until `told(argument)` is true; false if it does not come to it. */
export const comes = (page, told, argument, timeout = PATIENCE) =>
    page.waitForFunction(told, argument, { timeout, polling: 50 }).then(() => true, () => false);

/** Opens the folds, and keeps what each canvas shows: the list of its shapes and texts. */
export const tap = (page) => page.evaluate(() => {
    for (const fold of document.querySelectorAll("details")) fold.open = true;
    window.drawn ??= new Map();
    const { draw } = Paint;
    Paint.draw = (canvas, drawing, ...more) => {
        drawn.set(canvas, drawing);
        draw(canvas, drawing, ...more);
    };
});

/** What the n-th player's canvas shows, as a text; null before it has painted. */
export const pixels = (n) => {
    const canvas = document.querySelectorAll(".player")[n].closest("figure").querySelector("canvas");
    return canvas && window.drawn.has(canvas) ? canvas.toDataURL() : null;
};
/** True once the n-th picture is painted, false where it is refused. */
export async function paints(page, n) {
    await comes(page, (n) => {
        const player = document.querySelectorAll(".player")[n];
        const canvas = player.closest("figure").querySelector("canvas");
        return window.drawn.has(canvas) || player.querySelector(".refusal").textContent !== "";
    }, n);
    return await page.evaluate(pixels, n) !== null;
}
/** Whether the canvas shows something else than `then`, which it comes to if it is given time. */
const differs = ({ n, then, pixels }) => ![null, then].includes(eval(pixels)(n));
export const differ = (page, n, then, patience = 15_000) => comes(page, differs, { n, then, pixels: `(${pixels})` }, patience);
/** The picture once nothing is under way. */
export async function settled(page, n) {
    let last;
    for (;;) {
        await page.waitForTimeout(150);
        const now = await page.evaluate(pixels, n);
        if (now === last) return now;
        last = now;
    }
}

/** Opens the n-th moving picture and holds what it says to the locked still. */
export async function opens(page, n) {
    const player = page.locator(".player").nth(n);
    await player.locator(".bar").evaluate((bar) => bar.scrollIntoView({ block: "center", behavior: "instant" }));
    const before = await player.boundingBox();
    // The first touch opens it, at its last still. It is the mouse's own: a driver that clicks a part
    // may scroll to it first, and Firefox's does so each time where the bar is pinned.
    await page.evaluate(() => { window.moved = 0; });
    const step = await player.locator(".step").first().boundingBox();
    await page.mouse.click(step.x + step.width / 2, step.y + step.height / 2);
    if (!await paints(page, n)) return [`picture ${n} does not open: ${await player.locator(".refusal").innerText()}`];
    const after = await player.boundingBox();
    const faults = Math.abs(after.y - before.y) < 2 ? [] : [`the controls jump by ${after.y - before.y} px`];
    const moved = await page.evaluate(() => window.moved);
    if (moved > BOUNDS.shift) faults.push(`the page shifts by ${moved} while picture ${n} opens`);
    const [shown, locked] = await page.evaluate((n) => {
        const figure = document.querySelectorAll(".player")[n].closest("figure");
        const still = [...figure.querySelectorAll(".panel svg")].at(-1);
        const place = (x, y, text) => `${Number(x).toFixed(2)} ${Number(y).toFixed(2)} ${text}`;
        const locked = [...still.querySelectorAll("text")].map((text) =>
            place(text.getAttribute("x"), text.getAttribute("y"), text.textContent));
        const { texts } = drawn.get(figure.querySelector("canvas"));
        return [texts.map(({ x, y, runs }) => place(x / 100, y / 100, runs.map((run) => run.text).join(""))), locked]
            .map((all) => [...new Set(all)].sort().join("\n"));
    }, n);
    if (shown !== locked) faults.push(`it says\n${shown}\nthe locked still\n${locked}`);
    return faults;
}

/** What is to be seen where it opens is said as of the locked still; a step on it is said anew. */
export async function tells(page, n) {
    const player = page.locator(".player").nth(n);
    const said = () => page.evaluate((n) => {
        const figure = document.querySelectorAll(".player")[n].closest("figure");
        return [figure.querySelector("canvas"), [...figure.querySelectorAll(".panel svg")].at(-1)].map((seen) => seen.getAttribute("aria-label"));
    }, n);
    const [shown, locked] = await said();
    if (shown !== locked) return [`it is told as ${shown}, the locked still as ${locked}`];
    const middle = player.locator(".time");
    await middle.evaluate((time) => {
        time.value = time.max / 3;
        time.dispatchEvent(new Event("input", { bubbles: true }));
    });
    await settled(page, n);
    const [then] = await said();
    return then !== shown ? [] : [`another time is told as ${then}`];
}

/** Play moves the picture, pause holds it. */
export async function moves(page, n) {
    const player = page.locator(".player").nth(n);
    const play = player.locator(".play");
    if (await play.getAttribute("aria-pressed") === "false") await play.click();
    if (!await paints(page, n)) return [`picture ${n} does not open: ${await player.locator(".refusal").innerText()}`];
    const then = await page.evaluate(pixels, n);
    const faults = await differ(page, n, then) ? [] : [`picture ${n} stands still`];
    await play.click();
    const held = await settled(page, n);
    await page.waitForTimeout(300);
    if (await page.evaluate(pixels, n) !== held) faults.push(`picture ${n} does not pause`);
    return faults;
}

/**
 * The open controls: each begins at what the picture has, changes it, by the arrow keys of its slider or
 * as another word of its list, and is put back.
 */
export async function slides(page, n) {
    const player = page.locator(".player").nth(n);
    // Half of the way the motion shows what set it off.
    await player.locator(".time").evaluate((time) => {
        time.value = time.max / 2;
        time.dispatchEvent(new Event("input", { bubbles: true }));
    });
    const before = await settled(page, n);
    const [knobs, faults] = [player.locator("> .knobs .knob"), []];
    const count = await knobs.count();
    if (count === 0 || count > 3) faults.push(`${count} controls are open`);
    for (let k = 0; k < count; k += 1) {
        const knob = knobs.nth(k);
        const [name, value, slider, box] = [await knob.getAttribute("data-name"), knob.locator(".value"), knob.locator(".slide input"), knob.locator("[type=checkbox]")];
        const typed = await value.inputValue();
        let moves = [() => box.click()];
        if (await box.count() === 0 && await slider.count() === 0) {
            moves = [async () => value.selectOption({ index: await value.evaluate((list) => list.selectedIndex === 0 ? 1 : 0) })];
        } else if (await box.count() === 0) {
            // What is typed again is what is shown.
            await value.fill(typed);
            if (await settled(page, n) !== before) faults.push(`${name} = ${typed} is not on show`);
            const steps = await slider.evaluate(({ min, max, step, value, dataset: { from, to } }, typed) =>
                ((from === undefined ? typed : max * Math.log(typed / from) / Math.log(to / from)) - value) / (step || 1), Number(typed));
            if (Math.abs(steps) > 0.51) faults.push(`the slider of ${name} is ${steps} steps from ${typed}`);
            await slider.focus();
            moves = ["Home", "End"].map((key) => () => page.keyboard.press(key));
        }
        let changed = false;
        for (const move of moves) {
            await move();
            if (await value.inputValue() === typed && moves.length > 1) continue;
            changed = await differ(page, n, before, 10_000);
            if (changed) break;
        }
        if (!changed) faults.push(`${name} changes nothing`);
        await knob.locator(".back").click();
        const back = ({ n, then, pixels }) => eval(pixels)(n) === then;
        if (!await comes(page, back, { n, then: before, pixels: `(${pixels})` }, 15_000)) faults.push(`${name} is not put back`);
    }
    return faults;
}

/** FNV-1a, of the bytes of a text: what tests/pages/commands.rs locks. */
function digest(text) {
    let hash = 0xcbf29ce484222325n;
    for (const byte of Buffer.from(text)) hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
    return hash.toString(16).padStart(16, "0");
}
/** The locked text of a page, which begins with its default output, after a head between two lines of dashes. */
export function text(stem) {
    const file = readFileSync(new URL(`${stem}.snap`, LOCKED), "utf8");
    return file.slice(file.indexOf("\n---\n", 4) + 5);
}
/** Of each command that a page gives, the digest of all that it says and writes. */
const ENDED = (() => {
    const all = new URL("commands/", LOCKED);
    const lines = readdirSync(all).flatMap((name) => readFileSync(new URL(name, all), "utf8").split("\n"));
    const told = lines.map((line) => line.match(/^\d+ ([0-9a-f]{16}) (.*)$/)).filter(Boolean);
    return new Map(told.map(([, digest, command]) => [command, digest]));
})();


/** Every Run button prints what is locked for its command; `ran` takes the commands. */
export async function runs(page, ran = new Set()) {
    const faults = [];
    const buttons = page.locator("button.run");
    for (let n = 0; n < await buttons.count(); n += 1) {
        const button = buttons.nth(n);
        const { stem, arguments: words, predict } = await button.evaluate(({ dataset }) => ({ ...dataset }));
        const command = `${stem} ${words}`.trim();
        if (ran.has(command)) continue;
        ran.add(command);
        await button.click();
        const terminal = page.locator(".terminal:not([data-tried])");
        await terminal.waitFor({ timeout: PATIENCE });
        const id = `tried-${ran.size}`;
        await terminal.evaluate((terminal, id) => { terminal.dataset.tried = id; }, id);
        faults.push(...await prints(page.locator(`[data-tried=${id}]`), command, predict !== undefined));
    }
    return faults;
}

/** What a terminal that has just opened prints is what is locked for its command. */
export async function prints(terminal, command, predict) {
    const [stem] = command.split(" ");
    const faults = [];
    if (predict) {
        await terminal.locator(".guess textarea").fill("It goes faster.");
        await terminal.locator("button[type=submit]").click();
    }
    const done = await terminal.locator(".told").waitFor({ state: "visible", timeout: PATIENCE }).then(() => true, () => false);
    if (!done) return [`${command}: ${await terminal.innerText()}`];
    const told = await terminal.evaluate(async (terminal) => {
        const said = (part) => terminal.querySelector(part).textContent;
        const files = [...terminal.querySelectorAll("a[download]")];
        const written = await Promise.all(files.map((file) => fetch(file.href).then((answer) => answer.text())));
        return { out: said(".stdout"), all: said(".stdout") + said(".stderr") + written.join("") };
    });
    if (command === stem && !text(stem).startsWith(told.out.trimEnd())) faults.push(`${command}: not the locked text`);
    const locked = ENDED.get(command);
    if (locked === undefined && command !== stem) faults.push(`${command}: not among the locked commands`);
    if (locked !== undefined && locked !== digest(told.all)) faults.push(`${command}: not what is locked`);
    return faults;
}

/** For each of these a damage that it must see, on a page whose picture holds digits. */
export const DAMAGES = {
    opens: instead("paint.js", "utf8.decode(letters)", 'utf8.decode(letters).replace(/\\d/, "7")'),
    tells: instead("player.js", '"aria-label", alt', '"aria-label", ""'),
    moves: instead("player.js", "advance(seconds) {", "advance(seconds) { return;"),
    slides: instead("player.js", 'async open() {', "async open() { if (this.picture) return;"),
    runs: (path, body) => path === "/modules/run.js" ? body.toString().replace("told.stdout", 'told.stdout.replace(/\\d/, "0")') : body,
};
