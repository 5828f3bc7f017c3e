// The answer box judges a number by the rules of `Claim::verdict` (src/report/claim.rs),
// in the same order. Folded parts open for printing.
"use strict";

(() => {
    const within = (answer, target, check) =>
        Math.abs(answer - target) <=
        Math.max(check.within * (target === 0 ? 1 : Math.abs(target)), check.bound);

    /** What became of an answer: its class and what to say. */
    function verdict(answer, check, usual, reciprocal) {
        const v = check.value;
        if (within(answer, v, check)) return ["right", "Right."];
        const slip = check.slips.find((s) => within(answer, s.value, check));
        if (slip) return ["wrong", `Not yet: ${slip.hint}.`];
        if (v !== 0) {
            const places = Math.floor(-Math.log10(2 * Math.abs(answer - v)));
            const n = places + Math.floor(Math.log10(Math.abs(v))) + 1;
            if (n >= 2) return ["wrong", `Right to ${n} digits. More digits are asked for.`];
            const factor = usual.find((u) => within(answer, u.factor * v, check));
            if (factor) return ["wrong", `Not yet: ${factor.hint}.`];
            if (within(answer, 1 / v, check)) return ["wrong", `Not yet: ${reciprocal}.`];
        }
        return ["wrong", "Not this. Check the units and the starting values."];
    }

    /** A typed number, with a comma or a true minus sign allowed. */
    function number(text) {
        const plain = text.trim().replace(/\u2212/g, "-").replace(",", ".");
        return /^[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
    }

    for (const form of document.querySelectorAll("form.answer")) {
        const data = JSON.parse(form.querySelector("script").textContent);
        const output = form.querySelector("output");
        form.addEventListener("submit", (event) => {
            event.preventDefault();
            const answer = number(form.elements.value.value);
            const check = data.checks.find((c) => c.key === form.elements.key.value);
            const [kind, text] = Number.isFinite(answer)
                ? verdict(answer, check, data.usual, data.reciprocal)
                : ["wrong", "That is not a number."];
            output.className = kind;
            output.textContent = text;
        });
        // The arrow keys turn pages, but not while one types.
        form.addEventListener("keydown", (event) => event.stopPropagation());
        form.elements.key.addEventListener("change", () => { output.textContent = ""; });
    }

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
})();
