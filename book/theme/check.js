// What a page does beside being read: it has answers judged by the page's module, opens
// its folds for printing and for links, and tells of boxes that scroll.
"use strict";

(() => {
    // ---- The answer box.
    const sentence = (words) => words[0].toUpperCase() + words.slice(1) + ".";

    /** A line in the box, below its head. */
    const tell = (form, kind, ...words) => {
        const line = document.createElement("p");
        line.className = kind;
        line.append(...words);
        form.querySelector(".head").after(line);
    };
    /** Shows in the box what it assumes: the page's numbers, but for `values`. */
    const show = (form, values) => {
        for (const item of form.querySelectorAll(".assumed [data-name]")) {
            const value = values.get(item.dataset.name);
            const span = item.querySelector("span");
            item.dataset.shown ??= span.innerHTML;
            if (value === undefined) span.innerHTML = item.dataset.shown;
            else span.textContent = value === "" ? "left out" : value.replace("-", "\u2212");
            item.classList.toggle("given", value !== undefined);
        }
        const own = [...form.querySelectorAll(".assumed [data-name]")].map((item) => item.dataset.name);
        const more = [...values].filter(([name]) => !own.includes(name));
        form.querySelector(".assumed .more")?.remove();
        if (more.length === 0) return;
        const item = document.createElement("li");
        item.className = "more given";
        item.textContent = more.map(([name, value]) => `${name}: ${value}`).join(", ");
        form.querySelector(".assumed ul").append(item);
    };
    /** A way back to the numbers of the page. */
    const plain = () => {
        const link = document.createElement("a");
        link.href = location.pathname + "#check-your-answer";
        link.textContent = "Judge for the numbers of the page";
        return link;
    };
    /** The checks for what the address asks for, or the page's; null if it makes no sense. */
    const forSheet = (form, ours) => {
        const shown = [...form.querySelectorAll(".assumed [data-name]")];
        const own = shown.map((item) => [item.dataset.name, item.dataset.value]);
        const asked = Answer.addressed(location.search, form.dataset.stem, own, ours, Live.flags(form.dataset.stem));
        if (asked === null) return ours;
        if (asked.error && asked.values && Live.has(form.dataset.stem)) {
            Live.change(asked.values, null);
            return ours;
        }
        if (asked.error) {
            for (const control of form.elements) control.disabled = true;
            tell(form, "refused", `${asked.error}. Nothing is judged here. `, plain(), ".");
            return null;
        }
        show(form, asked.values);
        form.querySelector(".assumed").open = true;
        tell(form, "sheet", "This box judges for the numbers of your sheet, listed below. What the page " +
            "around it computes is for its own numbers. ", plain(), ".");
        form.dataset.sheet = "";
        return asked.checks;
    };
    /** The verdict on an answer for other parameters than the page's: that of the program itself. */
    const computed = async (form, key, answer) => {
        const words = [...Live.commanded(form.dataset.stem), "--check", `${key}=${answer}`];
        const { stdout, stderr, code } = await Live.machine(form.dataset.stem, "told").ask("run", words.join("\0"));
        const kind = code === 0 ? "right" : stdout.startsWith("nearly") ? "nearly" : "wrong";
        return [kind, sentence((stdout || stderr.replace(/^error: /, "")).trim())];
    };
    /** The verdict on an answer by the numbers of `check`. */
    const judged = async (stem, { value, unit, bound, within, slips }, answer) => {
        const lines = [answer, value, unit, bound, within, ...slips.flatMap((slip) => [slip.value, slip.hint])];
        const { kind, words } = await Live.machine(stem, "told").ask("judged", lines.join("\n"));
        return [kind === "right" || kind === "nearly" ? kind : "wrong",
            kind === "slip" ? `Not yet: ${words}.`
            : kind === "wrong" ? "Not this. Check the units and the starting values."
            : sentence(words)];
    };
    for (const form of document.querySelectorAll("form.answer")) {
        const { checks: ours } = JSON.parse(form.querySelector("script").textContent);
        const checks = forSheet(form, ours);
        if (checks === null) continue;
        if (!Live.has(form.dataset.stem)) {
            for (const control of form.elements) control.disabled = true;
            tell(form, "refused", "This box needs WebAssembly, which this browser does not run. The command line does the same.");
            continue;
        }
        const { key, value } = form.elements;
        const output = form.querySelector("output");
        const asked = form.querySelector(".asked");
        const check = () => checks.find((c) => c.key === key.value);
        const say = (kind, words) => {
            output.className = kind;
            output.textContent = words;
        };
        const follows = form.dataset.sheet === undefined;
        if (follows) {
            Live.listen((state) => { show(form, state); told(); });
            show(form, Live.state);
        }
        form.addEventListener("submit", async (event) => {
            event.preventDefault();
            const others = follows && Live.state.size > 0;
            say("", others ? "Computing for these parameters …" : "");
            const loading = setInterval(() => {
                const words = Live.arriving(form.dataset.stem);
                if (words !== "") say("", sentence(words));
            }, 500);
            try {
                say(...await (others ? computed(form, key.value, value.value) : judged(form.dataset.stem, check(), value.value)));
            } catch (error) {
                say("wrong", sentence(error.message));
            }
            clearInterval(loading);
        });
        // What judges is on its way while the reader types.
        form.addEventListener("focusin", () => Live.machine(form.dataset.stem, "told").prepare().catch(() => {}), { once: true });
        // The arrow keys turn pages, but not while one types.
        form.addEventListener("keydown", (event) => event.stopPropagation());
        const told = () => {
            output.textContent = "";
            const others = follows ? [...Live.state].map(([name, value]) => value === "" ? `no ${name}` : `${name} = ${value}`) : [];
            asked.textContent = `Give ${check().digits} digits${others.length > 0 ? ` for ${others.join(", ")}` : ""}.`;
        };
        key.addEventListener("change", told);
        told();
    }

    // ---- Folds open for printing, and for what a link points to.
    const opened = [];
    addEventListener("beforeprint", () => {
        for (const part of document.querySelectorAll("details:not([open])")) {
            part.open = true;
            opened.push(part);
        }
    });
    addEventListener("afterprint", () => {
        while (opened.length > 0) opened.pop().open = false;
    });
    const reveal = () => {
        const target = location.hash && document.getElementById(decodeURIComponent(location.hash.slice(1)));
        if (!target) return;
        for (let fold = target.closest("details"); fold; fold = fold.parentElement.closest("details")) {
            fold.open = true;
        }
        target.scrollIntoView();
    };
    addEventListener("hashchange", reveal);
    reveal();

    // ---- Escape closes a proof; mdBook keeps the key from the browser.
    addEventListener("keydown", (event) => {
        if (event.key === "Escape") document.querySelector(".proof:popover-open")?.hidePopover();
    }, { capture: true });

    // ---- A box that scrolls can be reached by the keyboard, and shows that there is more.
    const measure = (box) => {
        const wide = box.scrollWidth > box.clientWidth + 1;
        const scrolls = wide || box.scrollHeight > box.clientHeight + 1;
        box.classList.toggle("more", wide && box.scrollLeft + box.clientWidth < box.scrollWidth - 1);
        box.classList.toggle("moved", box.scrollLeft > 0);
        if (scrolls === box.hasAttribute("tabindex")) return;
        const label = box.matches("pre") ? "output" : box.matches("code") ? "program text" : box.matches(".formula") ? "formula" : box.matches(".panels") ? "pictures" : "table";
        const told = { tabindex: "0", role: "group", "aria-label": `${label}, scrolls` };
        for (const [name, value] of Object.entries(told)) {
            if (scrolls) box.setAttribute(name, value);
            else box.removeAttribute(name);
        }
    };
    const resized = new ResizeObserver((entries) => entries.forEach((entry) => measure(entry.target)));
    const boxes = document.querySelectorAll(".scroll, .panels, .table-wrapper, .formula, pre > code");
    const watch = (box) => {
        resized.observe(box);
        box.addEventListener("scroll", () => measure(box), { passive: true });
    };
    boxes.forEach(watch);
    // Of one that comes later, and of what comes into it, its maker tells.
    document.addEventListener("scrolls", ({ target }) => {
        if (!target.classList.contains("watched")) watch(target);
        target.classList.add("watched");
        measure(target);
    });
    // The book's letters, once they are there, fill a box that keeps its size.
    document.fonts.ready.then(() => boxes.forEach(measure));

    // ---- The sidebar: a button works the check box that mdBook's label works.
    const toggle = document.getElementById("mdbook-sidebar-toggle");
    const anchor = document.getElementById("mdbook-sidebar-toggle-anchor");
    toggle?.addEventListener("click", () => {
        anchor.checked = !anchor.checked;
        anchor.dispatchEvent(new Event("change"));
    });
    // The hidden check box must not stop the tab key, nor the handle be read out.
    anchor?.setAttribute("tabindex", "-1");

    // ---- The search knows formulas by the names of their letters.
    const greek = {
        α: "alpha", β: "beta", γ: "gamma", δ: "delta", ε: "epsilon", ζ: "zeta", θ: "theta", κ: "kappa",
        λ: "lambda", μ: "mu", ν: "nu", ρ: "rho", σ: "sigma", τ: "tau", φ: "phi", ω: "omega", Ω: "Omega",
    };
    const bar = document.getElementById("mdbook-searchbar");
    bar?.addEventListener("input", () => {
        const spelled = bar.value.replace(/[α-ωΩ]/g, (letter) => greek[letter] ?? letter);
        if (spelled !== bar.value) bar.value = spelled;
    }, { capture: true });
})();
