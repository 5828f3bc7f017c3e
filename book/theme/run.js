// "Run it here": a command of the page shows what the terminal would, with the arguments that the
// reader types; the page's figures are drawn anew for them. And the bench of methods.
// live.js brings this script when it is first asked for.
"use strict";

(() => {
    const make = (name, attributes = {}, ...children) => {
        const element = document.createElement(name);
        for (const [key, value] of Object.entries(attributes)) {
            if (typeof value === "boolean") element.toggleAttribute(key, value);
            else element.setAttribute(key, value);
        }
        element.append(...children);
        return element;
    };
    const tr = (cells, kind) => make("tr", {}, ...cells.map((text) => make(kind, kind === "th" ? { scope: "col" } : {}, text)));
    const table = (head, rows) => make("table", {}, make("thead", {}, tr(head, "th")), make("tbody", {}, ...rows));
    /** Lets check.js show where the box has more than is to be seen. */
    const scrolls = (box) => requestAnimationFrame(() => box.dispatchEvent(new Event("scrolls", { bubbles: true })));
    const button = (text, attributes = {}) => make("button", { type: "button", ...attributes }, text);
    /** A printed number in at most six digits. */
    const short = (number) => (number.length > 9 ? String(Number(Number(number).toPrecision(6))) : number).replaceAll("-", "\u2212");
    /** Words as a shell parts them, without its other powers. */
    const parted = (line) => [...line.matchAll(/(?:[^\s"']+|"[^"]*"|'[^']*')+/g)]
        .map(([word]) => word.replace(/"([^"]*)"|'([^']*)'/g, "$1$2"));

    // ---- The figures of the page, drawn for other arguments. The locked ones stay, for paper.
    const SVG = "http://www.w3.org/2000/svg";
    const panels = (stem) => document.querySelectorAll(`.panel[data-figure^="${stem}:"]`);
    /** The `svg` as part of the page. */
    function placed(svg) {
        const drawn = new DOMParser().parseFromString(svg.slice(svg.indexOf("<svg")), "image/svg+xml").documentElement;
        if (drawn.namespaceURI !== SVG) throw new Error("a figure that is no SVG");
        drawn.classList.add("again");
        return document.importNode(drawn, true);
    }
    /** The locked figures alone. */
    function restore(stem) {
        for (const panel of panels(stem)) {
            panel.querySelector(".again")?.remove();
            panel.closest("figure").querySelector(".redrawn")?.remove();
        }
    }
    /** Puts the drawn figures over the locked ones; says how many, and for what. */
    function redraw(stem, figures, words) {
        restore(stem);
        const named = new Map(figures.map((figure) => [`${stem}:${figure.name}`, figure.svg]));
        const known = [...panels(stem)].filter((panel) => named.has(panel.dataset.figure));
        for (const panel of known) {
            panel.prepend(placed(named.get(panel.dataset.figure)));
            const figure = panel.closest("figure");
            if (figure.querySelector(".redrawn")) continue;
            const back = button("Back to the page’s own");
            back.addEventListener("click", () => restore(stem));
            figure.prepend(make("p", { class: "redrawn" }, "Drawn for ", make("code", {}, words), ". ", back));
        }
        return known.length;
    }

    /**
     * What `answer` comes to, while `status` counts the seconds or tells how much of the page's
     * module has come; then it says what `done` says, or how it failed, for which the answer is null.
     */
    async function counted(stem, status, answer, doing, done) {
        const begun = performance.now();
        const seconds = () => `${((performance.now() - begun) / 1000).toFixed(1)} s`;
        const clock = setInterval(() => { status.textContent = Live.arriving(stem) || doing + seconds(); }, 100);
        status.setAttribute("aria-live", "off");
        let ended = "";
        try {
            const told = await answer;
            ended = done(told, seconds());
            return told;
        } catch (error) {
            ended = error.message === "stopped" ? `stopped after ${seconds()}` : error.message;
            return null;
        } finally {
            clearInterval(clock);
            status.setAttribute("aria-live", "polite");
            status.textContent = ended;
        }
    }

    // ---- A run.
    const file = (name, text) => {
        const kind = name.endsWith(".svg") ? "image/svg+xml" : name.endsWith(".json") ? "application/json" : "text/plain";
        const href = URL.createObjectURL(new Blob([text], { type: `${kind};charset=utf-8` }));
        return make("a", { href, download: name.split("/").pop() }, name.split("/").pop());
    };

    let terminals = 0;
    class Terminal {
        constructor(opener) {
            terminals += 1;
            const { stem, arguments: typed, predict } = opener.dataset;
            this.stem = stem;
            const id = (name) => `run${terminals}-${name}`;
            this.line = make("input", { id: id("line"), value: typed, spellcheck: "false", autocomplete: "off", autocapitalize: "off" });
            this.go = make("button", { type: "submit" }, "Run");
            this.stop = button("Stop", { hidden: true });
            this.elapsed = make("span", { class: "elapsed", role: "status" });
            this.guess = make("textarea", { id: id("guess"), rows: "2" });
            this.asks = make("div", { class: "guess", hidden: predict === undefined },
                make("label", { for: id("guess") }, "What do you expect, and why?"), this.guess,
                make("p", {}, "Write it down; then run. Your words stay here, beside what comes out."));
            this.compared = make("div", { class: "scroll", hidden: true });
            this.output = make("code", { class: "stdout" });
            this.error = make("code", { class: "stderr" });
            this.told = make("details", { class: "told", open: true, hidden: true }, make("summary", {}, "What it prints"),
                make("pre", {}, this.output, this.error));
            this.drawn = make("p", { class: "drawn", hidden: true });
            this.more = make("p", { class: "more", hidden: true });
            const form = make("form", {}, this.asks,
                make("label", { for: id("line") }, make("code", {}, `cargo run --example ${stem} `, make("span", { class: "flag" }, "--"))),
                make("span", { class: "line" }, this.line, this.go, this.stop), this.elapsed);
            this.root = make("div", { class: "terminal", role: "group", "data-stem": stem, "aria-label": `cargo run --example ${stem}, here` }, form, this.compared, this.told, this.drawn, this.more);
            form.addEventListener("submit", (event) => { event.preventDefault(); this.submit(); });
            this.stop.addEventListener("click", () => this.machine.end());
            this.guess.addEventListener("input", () => this.label());
            this.root.addEventListener("keydown", (event) => event.stopPropagation());
            this.label();
        }

        get machine() {
            return Live.machine(this.stem, "told");
        }

        /** What draws figures: a worker of its own, for which nothing waits. */
        get drawer() {
            return Live.machine(this.stem, "figures");
        }

        /** Takes the page's parameters as arguments. */
        adopt() {
            this.line.value = Live.commanded(this.stem).join(" ");
            this.seen = false;
        }

        label() {
            const asked = !this.asks.hidden && !this.seen && this.guess.value.trim() === "";
            this.go.textContent = asked ? "Run without a guess" : "Run";
        }

        /** Asks the machine, with the time that it takes shown and a way to stop it. */
        async working(words) {
            [this.go.disabled, this.stop.hidden] = [true, false];
            for (const control of this.more.querySelectorAll("button")) control.disabled = true;
            const told = await counted(this.stem, this.elapsed, this.machine.ask("run", words.join("\0")), "", (_, seconds) => `done in ${seconds}`);
            [this.go.disabled, this.stop.hidden] = [false, true];
            for (const control of this.more.querySelectorAll("button")) control.disabled = false;
            return told;
        }

        async submit() {
            [this.more.hidden, this.drawn.hidden] = [true, true];
            if (this.drawer.busy) this.drawer.end(); // figures of an earlier run
            const words = parted(this.line.value);
            const told = await this.working(words);
            if (told === null) return;
            this.seen = true;
            this.guess.readOnly = this.guess.value.trim() !== "";
            this.label();
            [this.output.textContent, this.error.textContent] = [told.stdout, told.stderr];
            this.compare(told.stdout);
            this.told.hidden = false;
            for (const box of [this.compared, this.told.querySelector("pre")]) scrolls(box);
            this.offer(words, told);
        }

        /** What the page asks for and is another number now, before and after, in six digits. */
        compare(stdout) {
            const form = document.querySelector(`form.answer[data-stem="${this.stem}"]`);
            const checks = form ? JSON.parse(form.querySelector("script").textContent).checks : [];
            const [, claims = ""] = stdout.match(/\nclaims\n([^]*?)\n(\n|$)/) ?? [];
            const now = new Map(claims.split("\n").map((line) => line.split(/ +/)));
            const rows = checks.filter(({ key, printed }) => now.has(key) && now.get(key) !== printed).map(({ key, printed }) =>
                [form.querySelector(`option[value="${key}"]`).textContent, ...[printed, now.get(key)].map(short)]);
            this.compared.hidden = rows.length === 0;
            this.compared.replaceChildren(table(["asked for", "on the page", "now"], rows.map((row) => tr(row, "td"))));
        }

        /** Draws the page's figures for what was run. */
        async draw(words) {
            if (words.length === 0) return restore(this.stem);
            if (panels(this.stem).length === 0) return;
            const [status, stop] = [make("span", { role: "status" }), button("Stop")];
            this.drawn.replaceChildren(status, " ", stop);
            this.drawn.hidden = false;
            stop.addEventListener("click", () => this.drawer.end());
            const told = await counted(this.stem, status, this.drawer.ask("figures", words.join("\0")), "The page’s figures are drawn for this: ", ({ figures }) => {
                const count = redraw(this.stem, figures, words.join(" "));
                return count === 0 ? "None of the page’s figures shows this."
                    : `${count === 1 ? "One figure" : `${count} figures`} of this page ${count === 1 ? "is" : "are"} drawn for this.`;
            });
            if (!this.drawn.contains(stop)) return; // a later run draws
            if (told !== null) return stop.remove();
            const again = button("Draw the page’s figures for this");
            again.addEventListener("click", () => this.draw(words));
            stop.replaceWith(again);
        }

        /** What else there is of these parameters: the files, the figures. */
        offer(words, told) {
            this.more.replaceChildren(...told.files.flatMap(({ name, text }) => [file(name, text), " "]));
            // A refusal has no more to give.
            if (told.code === 0 && !words.some((word) => ["--check", "--json", "--csv", "--svg", "--help", "-h"].includes(word.split("=")[0]))) {
                const again = (text, flags) => {
                    const ask = button(text);
                    ask.addEventListener("click", async () => {
                        const more = await this.working([...words, ...flags]);
                        if (more === null) return;
                        const files = flags[0] === "--json" ? [{ name: `${this.stem}.json`, text: more.stdout }] : more.files;
                        ask.replaceWith(...files.flatMap(({ name, text }) => [file(name, text), " "]));
                    });
                    return ask;
                };
                this.draw(words);
                this.more.append("Download: ", again("motion as CSV", ["--csv", `${this.stem}.csv`]), " ",
                    again("figures as SVG", ["--svg", "."]), " ", again("claims as JSON", ["--json"]));
            }
            this.more.hidden = this.more.childNodes.length === 0;
        }
    }

    for (const opener of document.querySelectorAll("button.run")) {
        if (!Live.has(opener.dataset.stem)) continue;
        opener.setAttribute("aria-expanded", "false");
        const [named, words] = [opener.getAttribute("aria-label"), opener.innerHTML];
        let terminal = null;
        opener.addEventListener("click", () => {
            if (terminal === null) {
                terminal = new Terminal(opener);
                const block = opener.closest(".runs, li, p, td");
                if (block.matches("li, td")) block.append(terminal.root);
                else block.after(terminal.root);
            } else terminal.root.hidden = !terminal.root.hidden;
            const open = !terminal.root.hidden;
            opener.setAttribute("aria-expanded", String(open));
            opener.innerHTML = open ? "Close" : words;
            if (named !== null) opener.setAttribute("aria-label", open ? `Close: ${named}` : named);
            if (!open) return;
            if (opener.dataset.state !== undefined) terminal.adopt();
            (terminal.asks.hidden ? terminal.line : terminal.guess).focus({ preventScroll: true });
            if (terminal.asks.hidden && !terminal.seen) terminal.submit();
        });
    }

    // ---- The bench: a method at the reader's own step, against the exact motion, or `solve`.
    const UNKNOWN = "With these parameters there is no motion to compare with; the effects that a run lists tell what has changed";
    class Bench {
        constructor(root) {
            [this.root, this.stem] = [root, root.dataset.stem];
            root.querySelector("button").addEventListener("click", () => this.open());
            root.addEventListener("keydown", (event) => event.stopPropagation());
        }

        get machine() {
            return Live.machine(this.stem, "told");
        }

        /** The lines that set the page's parameters. */
        lines() {
            return [...Live.state].map(([name, value]) => `${name}=${value}`);
        }

        async open() {
            const opener = this.root.querySelector("button");
            opener.disabled = true;
            this.status = make("p", { class: "status", role: "status" }, "Bringing the methods …");
            this.root.append(this.status);
            try {
                if (this.parts === undefined) this.build();
                await this.offer(this.lines().join("\n"));
                opener.remove();
                this.root.prepend(...this.parts);
                this.run();
                // An effect that is switched shows in error and cost.
                Live.listen(() => {
                    clearTimeout(this.later);
                    this.later = setTimeout(() => this.run(), 600);
                });
            } catch (error) {
                this.status.textContent = `${error.message}.`;
                opener.disabled = false;
            }
        }

        /** Offers the methods for these settings; one that was chosen stays so if it can. */
        async offer(settings) {
            if (settings === this.settings) return;
            const { methods, span } = await this.machine.ask("lab", settings);
            if (span === undefined) throw new Error(UNKNOWN);
            const chosen = this.method.value;
            this.method.replaceChildren(make("option", { value: "" }, "solve, stepping"),
                ...methods.map(({ name, setting }) => make("option", { value: name, "data-setting": setting }, name)));
            this.method.value = methods.some(({ name }) => name === chosen) ? chosen : "";
            if (this.method.value !== chosen || this.settings === undefined) this.method.dispatchEvent(new Event("change"));
            this.head.textContent = `The motion of this page to t = ${Number(span.toPrecision(6))}, by any method:`;
            this.settings = settings;
        }

        build() {
            this.method = make("select");
            this.head = make("p", { class: "head" });
            this.slider = make("input", { type: "range", min: "0", max: "300", value: "150" });
            this.field = make("input", { inputmode: "decimal", size: "9", autocomplete: "off" });
            this.name = make("span");
            this.label = make("label", {}, this.name, this.field);
            const runs = make("div", { class: "scroll" }, table(["method", "setting", "attitude off by", "energy", "momentum", "work"], []));
            this.rows = runs.querySelector("tbody");
            this.go = make("button", { type: "submit" }, "Run");
            const acting = this.effects();
            const form = make("form", {}, ...(acting.length > 0 ? [make("div", { class: "acting", role: "group", "aria-label": "What acts" }, ...acting)] : []),
                make("label", {}, "Method ", this.method), this.label,
                make("label", { class: "wide" }, make("span", { class: "quiet" }, "coarse to fine"), this.slider), this.go);
            this.parts = [this.head, form, runs];
            const range = () => this.kind() === "steps" ? [10, 1e5] : [1e-2, 1e-13];
            const typed = () => {
                const [from, to] = range();
                const value = from * (to / from) ** (this.slider.value / 300);
                this.field.value = this.kind() === "steps" ? String(Math.round(value)) : value.toExponential(0);
            };
            const chosen = () => {
                this.name.textContent = { steps: "Steps ", tolerance: "Tolerance ", solve: "Error asked for / rad " }[this.kind()];
                typed();
            };
            this.method.addEventListener("change", chosen);
            this.slider.addEventListener("input", typed);
            form.addEventListener("submit", (event) => { event.preventDefault(); this.run(); });
        }

        /** The switches of the page's effects once more: the picture and the bench follow both. */
        effects() {
            const boxes = document.querySelectorAll(`.player[data-stem="${this.stem}"] .knob.effect [type=checkbox]`);
            return [...boxes].map((own) => {
                const box = make("input", { type: "checkbox", checked: own.checked });
                box.addEventListener("change", () => own.click());
                Live.listen(() => { box.checked = own.checked; });
                return make("label", {}, box, ` ${own.parentElement.textContent.trim()}`);
            });
        }

        kind() {
            return this.method.selectedOptions[0].dataset.setting ?? "solve";
        }

        async run() {
            this.go.disabled = true;
            const lines = this.lines();
            try {
                await this.offer(lines.join("\n"));
                const setting = this.field.value.trim();
                const asked = this.kind() === "solve" ? [`solve=${setting}`] : [`method=${this.method.value}`, `setting=${setting}`];
                const told = await this.machine.ask("lab", [...lines, ...asked].join("\n"));
                const raised = (digits) => [...digits].map((c) => c === "-" ? "\u207b" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]).join("");
                const number = (x) => x === null ? "not finite" : x === 0 ? "0"
                    : x.toExponential(1).replace(/e\+?(-?\d+)/, (_, power) => `\u202f\u00d7\u202f10${raised(power)}`);
                const what = { steps: `${setting} steps`, tolerance: `tolerance ${setting}`, solve: `${setting} rad asked for` }[this.kind()];
                const against = told.against ? [`against solve at ${told.against.toExponential()}`] : [];
                const whole = [what, ...lines.map((line) => line.endsWith("=") ? `no ${line.slice(0, -1)}` : line), ...against].join("; ");
                const name = this.kind() === "solve" ? `solve: ${told.method}` : told.method;
                const cells = [name, whole, `${number(told.attitude)} rad`, number(told.energy), number(told.momentum), told.work];
                this.rows.prepend(tr(cells, "td"));
                scrolls(this.parts.at(-1));
                this.status.textContent = `${name}, ${whole}: off by ${number(told.attitude)} rad for ${told.work}`;
            } catch (error) {
                this.status.textContent = `${error.message}.`;
            }
            this.go.disabled = false;
        }
    }
    for (const root of document.querySelectorAll(".bench")) {
        if (Live.has(root.dataset.stem)) new Bench(root);
    }
})();
