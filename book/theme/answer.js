// What an address says: a page's parameters, and the numbers by which the box judges the answers to a
// problem sheet. `node book/theme/answer.test.js` drives it.
"use strict";

const Answer = (() => {
    // As examples/problem_sheet/address.rs makes it.

    /** A number of 64 bits that depends on each character of `text`, hexadecimal: FNV-1a. */
    function sum(text) {
        let sum = 0xcbf29ce484222325n;
        for (const byte of new TextEncoder().encode(text)) {
            sum = BigInt.asUintN(64, (sum ^ BigInt(byte)) * 0x100000001b3n);
        }
        return sum.toString(16).padStart(16, "0");
    }

    const DAMAGED = "This address does not hold together: it was shortened or changed on its way, or " +
        "the sheet was made for another edition of this page";
    const DECIMAL = /^-?(\d+\.?\d*|\.\d+)(e-?\d+)?$/;

    /**
     * What the query of an address says: `{ error }`, or `{ given, t, sheet }`. `given` are the
     * parameters that it sets, by the names of their flags, as typed (an effect without a value is
     * left out); `t` is the time of the moving picture, `sheet` what a problem sheet brings.
     */
    function parts(query) {
        const given = new Map();
        for (const part of query.replace(/^\?/, "").split("&")) {
            const at = part.indexOf("=");
            const name = at < 0 ? part : part.slice(0, at);
            // The search marks its words so.
            if (name === "" || name === "highlight" || name === "search") continue;
            if (given.has(name)) return { error: `${name} stands twice in this address` };
            try {
                given.set(name, at < 0 ? "" : decodeURIComponent(part.slice(at + 1)));
            } catch {
                return { error: DAMAGED };
            }
        }
        const [t, sheet] = ["t", "sheet"].map((name) => given.get(name));
        given.delete("t");
        given.delete("sheet");
        if (t !== undefined && !DECIMAL.test(t)) return { error: "The time in this address is not a number" };
        return { given, t, sheet };
    }

    /**
     * What the query of an address asks the box to judge for: null if it asks for nothing,
     * `{ error }`, or `{ values, checks }`, the parameters that it sets and the checks for them.
     * Parameters without a sheet bring no checks: `{ values, error }`.
     * `own` holds the names and values of the page's parameters, `checks` the page's own checks,
     * `flags` the names of all that it has.
     */
    function addressed(query, stem, own, checks, flags = []) {
        const { error, given, sheet } = parts(query);
        if (error !== undefined) return { error };
        if (given.size === 0 && sheet === undefined) return null;
        const known = new Set([...own.map(([name]) => name), ...flags]);
        for (const [name, value] of given) {
            if (!known.has(name)) {
                return { error: `This page has no parameter ${name}; it has ${[...known].join(", ")}` };
            }
            if (sheet !== undefined && !DECIMAL.test(value)) return { error: `The ${name} in this address is not a number` };
        }
        if (sheet === undefined) {
            return { values: given, error: "This address sets parameters, but this box cannot compute: only the address " +
                "of a problem sheet, as it was made, brings what answers are judged by" };
        }
        const [code, told, ...more] = sheet.split(".");
        const all = own.map(([name, value]) => `${name}=${given.get(name) ?? value}`);
        if (more.length > 0 || told !== sum(`${stem}?${all.join("&")}&sheet=${code}`)) return { error: DAMAGED };
        let text = "";
        try {
            text = atob(code.replace(/-/g, "+").replace(/_/g, "/"));
        } catch {
            return { error: DAMAGED };
        }
        const sets = text.split(";").map((set) => set.split(","));
        const fit = sets.length === checks.length && sets.every(([key, ...numbers], n) =>
            key === checks[n].key && numbers.length === 3 + checks[n].slips.length &&
            numbers.every((number) => DECIMAL.test(number)));
        if (!fit) return { error: DAMAGED };
        return {
            values: given,
            checks: sets.map(([, ...texts], n) => {
                const [value, bound, within, ...slips] = texts.map(Number);
                const known = checks[n].slips.map(({ hint }, s) => ({ value: slips[s], hint }));
                const digits = Math.ceil(-Math.log10(within) - 1e-9) + 1;
                return { ...checks[n], value, bound, within, digits, slips: known };
            }),
        };
    }

    return { parts, addressed };
})();

if (typeof module !== "undefined") module.exports = Answer;
