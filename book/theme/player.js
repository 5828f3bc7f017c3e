// Moving pictures: what the stills of a figure become when they are touched.
"use strict";

/** The controls of a page's parameters, made by the builder from their one declaration. */
class Knobs {
    constructor(root, changed) {
        this.all = new Map();
        for (const element of root.querySelectorAll(".knob")) {
            const part = (selector) => element.querySelector(selector);
            const knob = {
                element, preset: element.dataset.default, value: part(".value"), usual: part(".value").value,
                slider: part(".slide input"), box: part("[type=checkbox]"), back: part(".back"), told: part(".told"),
            };
            this.all.set(element.dataset.name, knob);
            const moved = () => { this.mark(knob); this.touched = element.dataset.name; changed(); };
            knob.value.addEventListener("input", () => {
                if (knob.box) knob.box.checked = true;
                this.slide(knob);
                moved();
            });
            knob.slider?.addEventListener("input", () => {
                knob.value.value = this.slid(knob.slider);
                if (knob.box) knob.box.checked = true;
                moved();
            });
            knob.box?.addEventListener("change", () => { this.slide(knob); moved(); });
            knob.back.addEventListener("click", () => {
                this.set(element.dataset.name, knob.preset);
                knob.value.focus();
                this.touched = element.dataset.name;
                changed();
            });
        }
    }

    /** What a slider says, as it is typed. */
    slid(slider) {
        const { from, to } = slider.dataset;
        if (from === undefined) return slider.value;
        return String(Number((from * (to / from) ** (slider.value / slider.max)).toPrecision(3)));
    }

    /** Brings the slider to what is typed; to its low end while an effect is left out. */
    slide({ slider, value, box }) {
        const number = Number(value.value);
        if (!slider || value.value === "" || !Number.isFinite(number)) return;
        const { min, max, dataset: { from, to } } = slider;
        slider.value = box?.checked === false ? min
            : from === undefined ? number : max * Math.log(Math.max(number, from) / from) / Math.log(to / from);
    }

    /** The typed value of a knob; "" is an effect left out. */
    typed(knob) {
        return knob.box && !knob.box.checked ? "" : knob.value.value.trim();
    }

    mark(knob) {
        const changed = this.typed(knob) !== knob.preset;
        knob.back.disabled = !changed;
        knob.element.classList.toggle("changed", changed);
        knob.element.classList.toggle("out", knob.box !== null && !knob.box.checked);
    }

    set(name, typed) {
        const knob = this.all.get(name);
        if (knob.box) knob.box.checked = typed !== "";
        knob.value.value = knob.box && typed === "" ? knob.usual : typed;
        this.slide(knob);
        this.mark(knob);
    }

    /** Sets what `values` has, and the rest as declared. */
    adopt(values) {
        for (const [name, knob] of this.all) this.set(name, values.get(name) ?? knob.preset);
    }

    /** The values that are not as declared. */
    changed() {
        const typed = [...this.all].map(([name, knob]) => [name, this.typed(knob), knob.preset]);
        return new Map(typed.filter(([, value, preset]) => value !== preset).map(([name, value]) => [name, value]));
    }

    /**
     * Says what is wrong beside the control that the message names, or else the one last touched;
     * "" says that nothing is. True if there is one.
     */
    refuse(message) {
        const [, field = ""] = message.match(/^"?([A-Za-z0-9_-]+) ?=/) ?? [];
        const meant = this.all.has(field.replaceAll("_", "-")) ? field.replaceAll("_", "-") : this.touched;
        let named = false;
        for (const [name, knob] of this.all) {
            const mine = message !== "" && name === meant;
            named ||= mine;
            if (mine) [knob.refused, knob.told.textContent] = [this.typed(knob), `${message.replace(/^"[^"]*" is not allowed: /, "")}.`];
            // What was refused before stays so until it is changed.
            const still = mine || (message !== "" && knob.refused === this.typed(knob));
            if (!still) [knob.refused, knob.told.textContent] = [undefined, ""];
            knob.element.classList.toggle("refused", still);
            if (still) knob.value.setAttribute("aria-invalid", "true");
            else knob.value.removeAttribute("aria-invalid");
        }
        return named;
    }
}

(() => {
    const STEPS = 100; // single steps in the whole span
    const SECONDS = [4, 15]; // a span plays in its own time, but within these
    const HOLD = 1; // s, at the end, before it begins anew
    const SEEN = 0.5; // of a picture, before it plays by itself
    const DRAGGED = 6; // px, before a finger that comes down is taken for one that turns it
    const BLEED = 10; // px around the drawing: letters may be wider than those that were measured
    const quiet = matchMedia("(prefers-reduced-motion: reduce)");

    class Player {
        constructor(root, asked) {
            this.root = root;
            this.figure = root.closest("figure");
            // Of the stills the last one stands on the page: it opens there.
            this.panel = this.figure.querySelector(".panel:last-child");
            this.still = this.panel.querySelector("svg");
            const part = (selector) => root.querySelector(selector);
            [this.play, this.time, this.now, this.speed] = [".play", ".time", ".now", ".speed select"].map(part);
            [this.refusal, this.fold] = [part(".refusal"), part(".fold")];
            this.knobs = new Knobs(root, () => this.changed());
            // `t` is where it is, `shown` what is painted, `sound` the settings of the last good picture.
            Object.assign(this, { machine: null, picture: null, drawing: null, t: null, camera: [0, 0], shown: "",
                sound: "", playing: false, visible: false, busy: false, opening: false, stale: false, last: 0, held: 0 });
            const given = [...asked.given ?? []].filter(([name]) => Live.flags(root.dataset.stem).includes(name));
            this.begun = asked.t !== undefined;
            if (this.begun) this.t = Number(asked.t);
            this.wished = given.length > 0 || this.begun;
            // One that is not the solution of an exercise plays when it is seen, unless motion is not wanted.
            this.eager = !this.begun && !root.closest("details") && !quiet.matches && !Live.metered();
            this.listen();
            if (root.classList.contains("turns")) this.turnable();
            this.heard = (state) => { this.knobs.adopt(state); if (this.machine) this.open(); };
            Live.listen(this.heard);
            if (given.length > 0) Live.change(given, null);
        }

        listen() {
            const { root, time, speed, play } = this;
            play.addEventListener("click", () => this.toggle());
            for (const step of root.querySelectorAll(".step")) {
                step.addEventListener("click", () => this.step(Number(step.dataset.by)));
            }
            time.addEventListener("input", () => this.seek(time.value / time.max));
            speed.addEventListener("change", () => this.touch());
            root.querySelector(".whole").addEventListener("click", () => {
                this.camera = [0, 0];
                this.pause();
                this.t = this.picture?.span[0] ?? null;
                Live.change([], null);
                this.touch();
                this.remember();
            });
            // While the fold is open the picture stays in view above it, and is smaller.
            this.fold?.addEventListener("toggle", () => this.inPlace(() => this.figure.classList.toggle("pinned", this.fold.open)));
            // The arrow keys turn pages, but not from here.
            root.addEventListener("keydown", (event) => event.stopPropagation());
            new IntersectionObserver((entries) => {
                const { isIntersecting, intersectionRatio } = entries.at(-1);
                this.visible = isIntersecting;
                if (isIntersecting) Live.ahead(this.root.dataset.stem);
                if (isIntersecting && this.wished && !this.eager) this.touch();
                if (this.eager && intersectionRatio >= SEEN) {
                    this.eager = false;
                    if (!this.playing) this.toggle();
                }
                this.wake();
            }, { threshold: [0, SEEN] }).observe(this.panel);
            document.addEventListener("visibilitychange", () => this.wake());
            new MutationObserver(() => { this.theme = undefined; this.repaint(); }).observe(document.documentElement, { attributeFilter: ["class"] });
        }

        /** The first touch: what paints lies over the still, its module is brought. */
        touch() {
            this.eager = false;
            if (this.machine) return;
            this.machine = Live.machine(this.root.dataset.stem, "motion");
            this.canvas ??= document.createElement("canvas");
            this.canvas.setAttribute("role", "img");
            this.canvas.setAttribute("aria-label", this.still.getAttribute("aria-label"));
            this.figure.classList.add("moving");
            this.panel.append(this.canvas);
            this.fit();
            this.resized ??= new ResizeObserver(() => this.fit());
            for (const part of [this.panel, this.figure]) this.resized.observe(part);
            this.now.textContent = "…";
            const told = setInterval(() => {
                const words = Live.arriving(this.root.dataset.stem);
                if (words === "") clearInterval(told);
                else this.now.textContent = words;
            }, 500);
            this.open();
            // What painting needs is looked up while the worker computes.
            this.canvas.getContext("2d");
            this.theme = Paint.theme(this.canvas, Live.inks);
        }

        /** What is touched stays where it is while `change` changes the picture's size. */
        inPlace(change) {
            const before = this.root.getBoundingClientRect().top;
            change();
            this.pin();
            scrollBy({ top: this.root.getBoundingClientRect().top - before, behavior: "instant" });
        }

        /** While it is pinned: where the bar stays, and before which end of the figure it leaves. */
        pin() {
            const part = (selector) => this.figure.querySelector(selector);
            const after = this.figure.getBoundingClientRect().bottom - this.root.getBoundingClientRect().bottom;
            this.figure.style.setProperty("--pinned", `${part(".panels").offsetHeight}px`);
            this.figure.style.setProperty("--below", `${after + part(".bar").offsetHeight}px`);
        }

        /** Nothing came of the first touch. */
        leave() {
            this.resized.disconnect();
            this.figure.classList.remove("moving");
            this.canvas.remove();
            [this.machine, this.playing, this.now.textContent] = [null, false, ""];
            this.label();
        }

        /** The canvas covers the still with a margin, in which the painter centres the picture as the browser does the still. */
        fit() {
            const { canvas, panel } = this;
            const [, , width, height] = this.still.getAttribute("viewBox").split(" ").map(Number);
            const bleed = BLEED * Math.min(panel.clientWidth / width, panel.clientHeight / height);
            [canvas.style.left, canvas.style.top] = [`${-bleed}px`, `${-bleed}px`];
            const size = [panel.clientWidth, panel.clientHeight].map((px) => px + 2 * bleed);
            [canvas.style.width, canvas.style.height] = size.map((px) => `${px}px`);
            const pixels = size.map((px) => Math.round(px * devicePixelRatio));
            this.pin();
            if (canvas.width === pixels[0] && canvas.height === pixels[1]) return;
            [canvas.width, canvas.height] = pixels;
            this.repaint();
        }

        repaint() {
            if (!this.drawing) return;
            this.theme ??= Paint.theme(this.canvas, Live.inks);
            Paint.draw(this.canvas, this.drawing, this.theme, BLEED);
        }

        /** Prepares the picture for what is set now; the last good one stays if that is refused. */
        async open() {
            if (this.opening) { this.stale = true; return; }
            this.opening = true;
            do {
                this.stale = false;
                const lines = [...Live.state].map(([name, value]) => `${name}=${value}`).join("\n");
                try {
                    this.opened(await this.machine.ask("open", lines));
                    this.sound = lines;
                    this.say("");
                } catch (error) {
                    this.say(error.message);
                    if (this.picture) await this.machine.ask("open", this.sound).catch(() => {});
                    else this.leave();
                }
            } while (this.stale && this.machine);
            this.opening = false;
            this.shown = "";
            this.remember();
            if (this.picture && this.visible) this.draw();
            this.wake();
        }

        opened(picture) {
            const [from, to] = picture.span;
            const before = this.picture?.span;
            // The same part of the motion, should its span have changed.
            if (before && this.t !== null && (before[0] !== from || before[1] !== to)) this.t = from + (this.t - before[0]) / (before[1] - before[0]) * (to - from);
            if (this.t === null) this.t = this.playing ? from : picture.stills.at(-1);
            this.picture = picture;
            this.t = Math.min(Math.max(this.t, from), to);
            this.decimals = Math.min(Math.max(Math.ceil(-Math.log10((to - from) / 400)), 0), 12);
        }

        say(message) {
            const named = this.knobs.refuse(message);
            this.refusal.textContent = message === "" || named ? "" : `${message}.`;
        }

        changed() {
            // An address may set what has no control here.
            const others = [...Live.state].filter(([name]) => !this.knobs.all.has(name));
            Live.change([...others, ...this.knobs.changed()], this.heard);
            this.touch();
            this.open();
            // What changes a still starts it, so that the change is seen from the beginning.
            if (this.begun !== true && !quiet.matches) this.toggle();
            this.remember();
        }

        remember() {
            clearTimeout(this.later);
            const still = !this.playing && this.picture && this.t !== this.picture.span[0];
            const t = still ? this.t.toFixed(this.decimals) : null;
            this.later = setTimeout(() => Live.remember(t), 300);
        }

        // ---- Time.
        toggle() {
            if (this.playing) return this.pause();
            this.playing = true;
            this.touch();
            const [from, to] = this.picture?.span ?? [];
            if (this.t >= to || this.begun !== true) this.t = from ?? null;
            this.begun = true;
            [this.last, this.held] = [0, 0];
            this.label();
            this.wake();
        }

        pause() {
            this.playing = false;
            this.label();
            this.remember();
            this.wake();
        }

        label() {
            this.play.setAttribute("aria-pressed", String(this.playing));
            this.play.querySelector("span").textContent = this.playing ? "Pause" : "Play";
            // What changes by itself is not read out.
            this.now.setAttribute("aria-live", this.playing ? "off" : "polite");
        }

        step(by) {
            this.touch();
            if (this.playing) this.pause();
            if (!this.picture) return;
            const [from, to] = this.picture.span;
            this.t = Math.min(Math.max(this.t + by * (to - from) / STEPS, from), to);
            this.begun = true;
            this.remember();
            this.wake();
        }

        seek(part) {
            this.touch();
            if (this.playing) this.pause();
            if (!this.picture) return;
            const [from, to] = this.picture.span;
            this.t = from + part * (to - from);
            this.begun = true;
            this.remember();
            this.wake();
        }

        advance(seconds) {
            const [from, to] = this.picture.span;
            const whole = Math.min(Math.max(to - from, SECONDS[0]), SECONDS[1]);
            this.held = this.t >= to ? this.held + seconds : 0;
            if (this.held > HOLD) [this.t, this.held] = [from, 0];
            else this.t = Math.min(to, this.t + seconds * this.speed.value * (to - from) / whole);
        }

        // ---- Frames: one at a time, the newest wish next, none while nobody looks.
        wake() {
            if (this.ticking || !this.picture || !this.visible || document.hidden) return;
            this.ticking = true;
            this.last = 0;
            requestAnimationFrame((now) => this.tick(now));
        }

        tick(now) {
            this.ticking = false;
            if (!this.visible || document.hidden) return;
            // Where motion is not wanted, play shows a step every half second.
            const least = quiet.matches ? 0.5 : 0;
            const passed = this.last === 0 ? 0 : Math.min((now - this.last) / 1000, 0.5 + least);
            if (this.playing && passed >= least) this.advance(passed);
            if (passed >= least || this.last === 0) this.last = now;
            this.draw();
            if (this.playing || this.busy) {
                this.ticking = true;
                requestAnimationFrame((next) => this.tick(next));
            }
        }

        async draw() {
            const wish = [this.t, ...this.camera];
            // What stands still is told in words, too.
            const told = !this.playing;
            const key = `${wish} ${told}`;
            if (this.busy || this.opening || key === this.shown) return;
            this.busy = true;
            try {
                const { bytes, alt } = await this.machine.call("frame", { numbers: wish, told });
                this.drawing = Paint.decoded(bytes);
                this.repaint();
                this.figure.classList.add("painted");
                if (told) this.canvas.setAttribute("aria-label", alt);
                this.tell(wish[0]);
            } catch (error) {
                this.pause();
                this.say(error.message);
            }
            this.shown = key;
            this.busy = false;
            this.wake();
        }

        tell(t) {
            const [from, to] = this.picture.span;
            const [name, unit = ""] = (this.picture.time ?? "t").split(" / ");
            const number = t.toFixed(this.decimals).replace("-", "\u2212");
            const text = `${number}${unit && ` ${unit}`}`;
            this.now.textContent = `${name} = ${text}`;
            this.time.value = this.time.max * (t - from) / (to - from);
            this.time.setAttribute("aria-valuetext", text);
        }

        // ---- The camera: dragged, or turned by the arrow keys.
        turnable() {
            const { panel } = this;
            panel.tabIndex = 0;
            panel.setAttribute("role", "group");
            panel.setAttribute("aria-label", "The picture; the arrow keys turn it, Home turns it back");
            const turn = (about, up) => {
                this.touch();
                this.camera = [this.camera[0] + about, Math.min(Math.max(this.camera[1] + up, -1.5), 1.5)];
                this.wake();
            };
            const keys = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
            panel.addEventListener("keydown", (event) => {
                if (event.key === " ") this.toggle();
                else if (event.key === "Home") turn(-this.camera[0], -this.camera[1]);
                else if (keys[event.key]) turn(...keys[event.key]);
                else return;
                event.preventDefault();
                event.stopPropagation();
            });
            let from = null;
            panel.addEventListener("pointerdown", (event) => {
                if (event.button !== 0) return;
                from = [event.clientX, event.clientY];
                panel.setPointerCapture(event.pointerId);
            });
            panel.addEventListener("pointermove", (event) => {
                if (!panel.hasPointerCapture(event.pointerId)) return;
                const to = [event.clientX, event.clientY];
                if (!this.machine && Math.abs(to[0] - from[0]) < DRAGGED) return;
                turn((from[0] - to[0]) / 120, (to[1] - from[1]) / 120);
                from = to;
            });
            panel.addEventListener("dblclick", () => turn(-this.camera[0], -this.camera[1]));
        }
    }

    if (!Live.able) return;
    const asked = Answer.parts(location.search);
    for (const root of document.querySelectorAll(".player")) {
        if (Live.has(root.dataset.stem)) new Player(root, asked);
    }
})();
