// A reader's own recording: chosen or dropped, read by the page's module, shown as tables, figures and
// what moves. Nothing of it leaves the page. live.js brings this script to pages that have the field.
"use strict";

(() => {
    const make = (name, attributes = {}, ...children) => {
        const element = document.createElement(name);
        for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
        element.append(...children);
        return element;
    };
    const quiet = matchMedia("(prefers-reduced-motion: reduce)");
    const SECONDS = [6, 30]; // what is shown plays in its own time, but within these
    const HOLD = 1; // s, before it begins anew

    /** What was found in three columns, which fit a phone. */
    const narrow = (table) => table.heading !== "found" ? table : {
        heading: "found", columns: ["what it is", "value", "interval of 95 %"],
        rows: table.rows.map(([key, value, from, to, unit, what]) =>
            [`${key}: ${what}`, unit === "-" ? value : `${value} ${unit}`, from === "-" ? "" : `${from} to ${to}`]),
    };

    /** A drawing that plays and is turned: its canvas, and the bar below. */
    class Picture {
        constructor(machine, number, { caption, span, time, stills, turns }) {
            [this.machine, this.number, this.span] = [machine, number, span];
            Object.assign(this, { t: stills.at(-1), camera: [0, 0], playing: false, ticking: false, shown: "", last: 0, held: 0 });
            this.canvas = make("canvas", { role: "img", "aria-label": caption, ...turns ? { tabindex: "0", class: "turns" } : {} });
            this.play = make("button", { type: "button", class: "play", "aria-pressed": "false" }, "Play");
            this.time = make("input", { type: "range", class: "time", min: "0", max: "1000", value: "0", "aria-label": `Time: ${caption.split(/[:.]/)[0]}` });
            this.now = make("output", { class: "now" });
            this.name = time.split(" / ");
            this.root = make("figure", {}, this.canvas, make("div", { class: "bar" }, this.play, this.time, this.now),
                make("figcaption", {}, caption, turns ? " Drag it, or use the arrow keys, to turn it." : ""));
            this.play.addEventListener("click", () => this.set(!this.playing));
            this.time.addEventListener("input", () => {
                this.set(false);
                this.t = span[0] + this.time.value / this.time.max * (span[1] - span[0]);
                this.wake();
            });
            if (turns) this.turnable(this.canvas);
            new ResizeObserver(() => this.paint()).observe(this.root);
            new MutationObserver(() => { this.theme = undefined; this.paint(); }).observe(document.documentElement, { attributeFilter: ["class"] });
        }

        set(playing) {
            if (playing && this.t >= this.span[1]) this.t = this.span[0];
            [this.playing, this.last] = [playing, 0];
            this.play.textContent = playing ? "Pause" : "Play";
            this.play.setAttribute("aria-pressed", String(playing));
            this.wake();
        }

        turn(about, up) {
            this.camera = [this.camera[0] + about, Math.min(Math.max(this.camera[1] + up, -1.5), 1.5)];
            this.wake();
        }

        turnable(canvas) {
            const keys = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
            canvas.addEventListener("keydown", (event) => {
                const by = event.key === "Home" ? this.camera.map((angle) => -angle) : keys[event.key];
                if (by === undefined) return;
                this.turn(...by);
                event.preventDefault();
            });
            canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
            canvas.addEventListener("pointermove", (event) => {
                if (canvas.hasPointerCapture(event.pointerId)) this.turn(-event.movementX / 120, event.movementY / 120);
            });
        }

        paint() {
            if (!this.drawing || !this.root.isConnected) return;
            const pixels = [this.canvas.clientWidth, this.canvas.clientHeight].map((px) => Math.round(px * devicePixelRatio));
            if (this.canvas.width !== pixels[0] || this.canvas.height !== pixels[1]) [this.canvas.width, this.canvas.height] = pixels;
            this.theme ??= Paint.theme(this.canvas, Live.inks);
            Paint.draw(this.canvas, this.drawing, this.theme);
        }

        wake() {
            if (this.ticking) return;
            this.ticking = true;
            requestAnimationFrame((now) => this.tick(now));
        }

        async tick(now) {
            if (!this.root.isConnected) return;
            const [from, to] = this.span;
            const whole = Math.min(Math.max(to - from, SECONDS[0]), SECONDS[1]);
            const passed = this.last === 0 ? 0 : Math.min((now - this.last) / 1000, 0.5);
            this.last = now;
            if (this.playing) {
                this.held = this.t >= to ? this.held + passed : 0;
                if (this.held > HOLD) [this.t, this.held] = [from, 0];
                else this.t = Math.min(to, this.t + passed * (to - from) / whole);
            }
            const wish = [this.number, this.t, ...this.camera];
            const key = `${wish} ${this.playing}`;
            const { top, bottom } = this.root.getBoundingClientRect();
            if (key !== this.shown && (this.shown === "" || (bottom > 0 && top < innerHeight))) await this.draw(wish).catch(() => { this.playing = false; }); // another file is read
            [this.shown, this.ticking] = [key, false];
            if (this.playing || key !== `${[this.number, this.t, ...this.camera]} ${this.playing}`) this.wake();
        }

        async draw(wish) {
            const [[from, to], t] = [this.span, wish[1]];
            const { bytes, alt } = await this.machine.call("shown", { numbers: wish, told: !this.playing });
            this.drawing = Paint.decoded(bytes);
            this.canvas.style.aspectRatio = this.drawing.size.join(" / ");
            if (alt) this.canvas.setAttribute("aria-label", alt);
            this.paint();
            this.now.textContent = `${this.name[0]} = ${t.toFixed(2)} ${this.name[1] ?? ""}`;
            this.time.value = this.time.max * (t - from) / (to - from);
        }
    }

    /** The field of a page. */
    class Field {
        constructor(root) {
            [this.root, this.stem] = [root, root.dataset.stem];
            const part = (selector) => root.querySelector(selector);
            [this.file, this.refusal, this.status, this.result] = ["[type=file]", ".refusal", ".status", ".result"].map(part);
            this.file.addEventListener("change", () => this.chosen(this.file.files[0]));
            part(".made").addEventListener("click", () => this.madeUp());
            part(".made").disabled = false; // a press before would be lost
            for (const entry of root.querySelectorAll("[data-flag]")) entry.addEventListener("change", () => this.changed(entry));
            // The arrow keys turn pages, but not from here.
            root.addEventListener("keydown", (event) => event.stopPropagation());
            for (const kind of ["dragenter", "dragover", "dragleave", "drop"]) {
                root.addEventListener(kind, (event) => {
                    event.preventDefault();
                    root.classList.toggle("over", kind === "dragenter" || kind === "dragover");
                });
            }
            root.addEventListener("drop", (event) => this.chosen(event.dataTransfer.files[0]));
        }

        /** A piece is a throw, or from one time to another. */
        changed({ dataset: { flag } }) {
            const others = { throw: "[data-flag=from], [data-flag=to]", from: "[data-flag=throw]", to: "[data-flag=throw]" }[flag];
            if (others) for (const other of this.root.querySelectorAll(others)) other.value = "";
            if (this.given) this.read(...this.given);
        }

        get machine() {
            return Live.machine(this.stem, "recording");
        }

        async chosen(file) {
            if (!file) return;
            // Another file has other throws.
            for (const flag of ["throw", "from", "to"]) for (const entry of this.root.querySelectorAll(`[data-flag=${flag}]`)) entry.value = "";
            await this.read(file.name, new Uint8Array(await file.arrayBuffer()));
        }

        async madeUp() {
            const made = await this.working(() => this.machine.call("made"));
            if (made) await this.read("made-up.csv", new TextEncoder().encode(made.text), made.text);
        }

        /** What `answer()` comes to, while it is told how long it takes; null if it fails, which is told. */
        async working(answer) {
            const begun = performance.now();
            const clock = setInterval(() => {
                this.status.textContent = Live.arriving(this.stem) || `reading, ${((performance.now() - begun) / 1000).toFixed(1)} s`;
            }, 200);
            try {
                return await answer();
            } catch (error) {
                if (error.message !== "stopped") this.refusal.textContent = error.message.replace(/^error: |For more information[^]*$/g, "").trim();
                return null;
            } finally {
                clearInterval(clock);
                this.status.textContent = "";
            }
        }

        async read(name, bytes, made) {
            this.given = [name, bytes, made];
            if (this.machine.busy) this.machine.end();
            [this.refusal.textContent, this.root.ariaBusy] = ["", "true"];
            const flags = [...this.root.querySelectorAll("[data-flag]")].filter(({ value }) => value.trim() !== "")
                .flatMap(({ dataset, value }) => [`--${dataset.flag}`, value.trim()]);
            const head = new TextEncoder().encode([`--recording=${name}`, ...flags].join("\0"));
            const text = new Uint8Array(head.length + bytes.length);
            text.set(head);
            text.set(bytes, head.length);
            const told = await this.working(async () => {
                const answer = JSON.parse((await this.machine.call("recorded", { text, numbers: [head.length] })).text);
                if (answer.error) throw new Error(answer.error);
                return answer;
            });
            if (this.given[1] !== bytes) return; // another was chosen meanwhile
            this.root.ariaBusy = null;
            this.result.replaceChildren(...told ? this.shown(name, told, made) : []);
            if (told) this.status.textContent = `${name}: ${told.told.description}`;
        }

        /** What fits another of the throws. */
        choose(number) {
            const button = make("button", { type: "button", "aria-label": `Fit throw ${number}` }, number);
            button.addEventListener("click", () => {
                const entry = this.root.querySelector("[data-flag=throw]");
                entry.value = number;
                this.changed(entry);
            });
            return button;
        }

        shown(name, { told, text, figures, pictures }, made) {
            const tables = told.tables.map(narrow).map(({ heading, columns, rows }) => make("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": heading },
                make("table", {}, make("caption", {}, heading),
                    make("thead", {}, make("tr", {}, ...columns.map((words) => make("th", { scope: "col" }, words)))),
                    make("tbody", {}, ...rows.map((row) => make("tr", {}, ...row.map((words, n) => make("td", {}, heading === "throws" && n === 0 ? this.choose(words) : words.replaceAll(/(^|[ ;])-(?=\d)/g, "$1\u2212")))))))));
            const drawn = figures.map(({ svg, caption }) => {
                const parsed = new DOMParser().parseFromString(svg.slice(svg.indexOf("<svg")), "image/svg+xml").documentElement;
                return make("figure", {}, document.importNode(parsed, true), make("figcaption", {}, caption));
            });
            const moving = pictures.map((picture, number) => new Picture(this.machine, number, picture));
            moving.forEach((picture, number) => picture.set(number === 0 && !quiet.matches));
            const file = (name, kind, text) => make("a", { href: URL.createObjectURL(new Blob([text], { type: `${kind};charset=utf-8` })), download: name }, name);
            const stem = name.replace(/\.[^.]*$/, "");
            const files = [file(`${stem}-fitted.json`, "application/json", `${JSON.stringify(told, null, 1)}\n`), " ",
                file(`${stem}-fitted.txt`, "text/plain", text), ...made ? [" ", file(name, "text/csv", made)] : []];
            return [make("div", { class: "drawn" }, moving[0]?.root ?? "", ...drawn, ...moving.slice(1).map(({ root }) => root)), ...tables,
                make("p", { class: "more" }, "Download: ", ...files)];
        }
    }

    for (const root of document.querySelectorAll(".recording")) if (Live.has(root.dataset.stem)) new Field(root);
})();
