// The modules of the examples, run beside the page, and what the page's address sets.
//
// A module holds the examples of a part of the book. A worker (module.js) compiles it when it is
// first asked; a call is a message, its answer a promise. Pages that are opened as files may not
// fetch: there modules come as scripts, as the source of the worker always does.
"use strict";

const Live = (() => {
    const told = document.getElementById("live");
    const able = told !== null && document.documentElement.classList.contains("live");
    const { pages = {}, inks = [] } = able ? JSON.parse(told.textContent) : {};

    // ---- Files.
    const arrived = new Map(); // of a script: its name and what it brought
    const packed = (name, content) => arrived.set(name, content);
    const files = new Map();
    const script = (name) => new Promise((done, failed) => {
        const element = document.createElement("script");
        element.src = `modules/${name}.js`;
        element.onload = () => done(arrived.get(name));
        element.onerror = () => failed(new Error(`modules/${name}.js did not arrive`));
        document.head.append(element);
    });
    const reached = new Map(); // of a module on its way: the share that has come
    async function fetched(name, size) {
        if (location.protocol === "file:") return Uint8Array.from(atob(await script(name)), (c) => c.charCodeAt(0));
        reached.set(name, 0);
        const answer = await fetch(`modules/${name}`).catch(() => null);
        if (!answer?.ok) throw new Error(`modules/${name} did not arrive`);
        const [bytes, parts] = [new Uint8Array(size), answer.body.getReader()];
        for (let at = 0; ;) {
            const { done, value } = await parts.read();
            if (done && at === size) return bytes;
            if (done || at + value.length > size) throw new Error(`modules/${name} is not as long as it was`);
            bytes.set(value, at);
            at += value.length;
            reached.set(name, at / size);
        }
    }
    /** What `bring(name)` gives, asked for once unless it fails. */
    const once = (name, bring) => {
        if (!files.has(name)) files.set(name, bring(name).catch((error) => { files.delete(name); reached.delete(name); throw error; }));
        return files.get(name);
    };

    /** The module of a page. */
    const brought = (stem) => once(pages[stem].module, (name) => fetched(name, pages[stem].size));
    /** Whether the reader saves data or pays for it. */
    function metered() {
        const { saveData, type } = navigator.connection ?? {};
        return saveData === true || type === "cellular";
    }
    /** Brings it before it is asked for. */
    function ahead(stem) {
        if (location.protocol === "file:" || metered()) return;
        brought(stem).catch(() => {}); // What fails is told when it is asked for.
    }
    /** How much of the module has come, in words, while it is on its way; then nothing. */
    function arriving(stem) {
        const { module: name, size } = pages[stem];
        const share = reached.get(name) ?? 1;
        return share < 1 ? `loading, ${Math.floor(100 * share)} % of ${Math.round(size / 1000)} kB` : "";
    }

    // ---- Machines: a worker with the module of a page.
    class Machine {
        constructor(stem) {
            [this.stem, this.page] = [stem, pages[stem].page];
            [this.worker, this.started, this.waiting, this.asked, this.calls] = [null, null, new Map(), 0, 0];
        }

        /** Brings the module, and the worker that compiles it, before it is asked. */
        prepare() {
            this.started ??= this.start();
            return this.started;
        }

        async start() {
            // What it needs is on its way while the worker starts.
            const needed = Promise.all([once("module", script), brought(this.stem)]);
            const address = URL.createObjectURL(new Blob(["onmessage = ({ data }) => (0, eval)(data)"], { type: "text/javascript" }));
            const worker = new Worker(address);
            URL.revokeObjectURL(address);
            worker.onmessage = ({ data: { id, error, ...answer } }) => {
                const [done, failed] = this.waiting.get(id) ?? [];
                this.waiting.delete(id);
                if (error === undefined) done?.(answer);
                else failed?.(new Error(error));
            };
            worker.onerror = (event) => this.end(new Error(event.message || "the module cannot run here"));
            try {
                const [source, gz] = await needed;
                worker.postMessage(source);
                worker.postMessage({ gz });
            } catch (error) {
                worker.terminate();
                throw error;
            }
            return worker;
        }

        async send(message) {
            const started = this.prepare();
            try {
                const worker = await started;
                if (this.started !== started) {
                    worker.terminate();
                    throw new Error("stopped");
                }
                this.worker = worker;
            } catch (error) {
                if (this.started === started) this.started = null;
                throw error;
            }
            this.asked += 1;
            return new Promise((done, failed) => {
                this.waiting.set(this.asked, [done, failed]);
                this.worker.postMessage({ ...message, id: this.asked });
            });
        }

        /** The answer to a call: `{ text }` or `{ bytes }`. */
        async call(call, more = {}) {
            // A frame is of the page that is open.
            const message = { call, ...(call === "frame" ? {} : { page: this.page }), ...more };
            this.calls += 1;
            try {
                return await this.send(message);
            } finally {
                this.calls -= 1;
            }
        }

        /** Whether somebody waits for an answer. */
        get busy() {
            return this.calls > 0;
        }

        /** What a call says in JSON. */
        async ask(call, text = "") {
            const answer = JSON.parse((await this.call(call, { text })).text);
            if (answer.error) throw new Error(answer.error);
            return answer;
        }

        /** Ends what it does; whoever waits is told. The next call starts it anew. */
        end(error = new Error("stopped")) {
            this.worker?.terminate();
            const waiting = [...this.waiting.values()];
            this.waiting.clear();
            [this.worker, this.started] = [null, null];
            for (const [, failed] of waiting) failed(error);
        }
    }

    const machines = new Map();
    /** The machine of a page for a use, the same for all that ask: none waits for another's answer. */
    function machine(stem, use) {
        const key = `${stem} ${use}`;
        if (!machines.has(key)) machines.set(key, new Machine(stem));
        return machines.get(key);
    }

    // ---- The page's parameters that are not as declared: typed values by name; "" is an effect
    // left out. The address holds them, and the time of the picture as `t`.
    const state = new Map();
    const heard = [];
    /** The names of a page's parameters. */
    const flags = (stem) => pages[stem]?.flags ?? [];
    /** Sets the parameters of the page and tells everyone but `from`. */
    function change(values, from) {
        state.clear();
        for (const [name, value] of values) state.set(name, value);
        for (const listener of heard) if (listener !== from) listener(state);
    }
    const listen = (listener) => heard.push(listener);

    /** Writes the parameters and the time `t` (null: none) into the address. */
    function remember(t) {
        const kept = location.search.replace(/^\?/, "").split("&").filter((part) => /^(highlight|search)=/.test(part));
        const set = [...state].map(([name, value]) => `${name}=${encodeURIComponent(value)}`);
        const query = [...set, ...(t === null ? [] : [`t=${t}`]), ...kept].join("&");
        try {
            history.replaceState(history.state, "", (query === "" ? location.pathname : `?${query}`) + location.hash);
        } catch {
            // A page opened as a file keeps its address in some browsers.
        }
    }

    /** The arguments of a page's command line that set what is set. */
    function commanded(stem) {
        return [...state].flatMap(([name, value]) => {
            if (!pages[stem].effects.includes(name)) return [`--${name}`, value];
            return value === "" ? ["--without", name] : ["--with", `${name}=${value}`];
        });
    }

    // ---- What runs commands and methods is brought when it is first asked for.
    let runs = false;
    const bring = async (event) => {
        const opener = event.target.closest("button.run, .bench > button");
        if (runs || opener === null) return;
        try {
            await once("run", script);
            if (!runs) [runs] = [true, document.removeEventListener("click", bring)];
            opener.click();
        } catch (error) {
            opener.disabled = true;
            opener.title = error.message;
        }
    };
    if (able) document.addEventListener("click", bring);
    // What reads recordings, where there is a field for them: by the time that it is seen.
    const fields = able ? document.querySelectorAll(".recording") : [];
    const field = fields.length > 0 && new IntersectionObserver((entries) => {
        if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
        field.disconnect();
        once("recording", script).catch(() => {}); // A file that is chosen stays chosen.
    }, { rootMargin: "400px" });
    for (const one of fields) field.observe(one);

    // ---- A touch begins when a finger or a key comes down; the click that follows a tenth of a
    // second later finds under way what it needs.
    const begin = ({ target, type, key }) => {
        if (type === "keydown" && !/^(Enter| |Arrow.*)$/.test(key)) return;
        const control = target.closest?.("button, select, [type=range], [type=checkbox]");
        const part = control?.closest("button.run, .terminal, .bench, .player");
        const stem = part?.dataset.stem;
        if (!(stem in pages)) return;
        const needed = [
            ...(control.matches("button.run, .bench > button") ? [once("run", script)] : []),
            ...(control.dataset.predict === undefined ? [machine(stem, part.matches(".player") ? "motion" : "told").prepare()] : []),
        ];
        // What fails is told when it is asked for.
        for (const one of needed) one.catch(() => {});
    };
    if (able) for (const type of ["pointerdown", "keydown"]) document.addEventListener(type, begin, { capture: true, passive: true });

    return { able, inks, packed, has: (stem) => able && stem in pages, machine, metered, ahead, arriving, flags, state, change, listen, remember, commanded };
})();

if (typeof module !== "undefined") module.exports = Live;
