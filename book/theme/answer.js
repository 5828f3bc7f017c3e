// How a reader's answer is read and judged: book/kit/src/answer.rs, line for line. The cases
// of tests/data/answers.json drive both; `node book/theme/answer.test.js` drives this one.
"use strict";

const Answer = (() => {
    const LONGEST = 80;
    const NONE = "that is not a number";

    /** The text with one spelling of everything. */
    function spelled(text) {
        let plain = "";
        let raised = false;
        for (const c of text.trim()) {
            const digit = "⁰¹²³⁴⁵⁶⁷⁸⁹".indexOf(c);
            const upper = digit >= 0 ? String(digit) : c === "⁻" ? "-" : null;
            if (upper !== null) plain += (raised ? "" : "^") + upper;
            else if (c === "\u2212" || c === "\u2013") plain += "-";
            else if ("·×⋅".includes(c)) plain += "*";
            else if (c === "π") plain += "pi";
            else if (c === "√") plain += "sqrt";
            else if ("°º˚".includes(c)) plain += " deg";
            else plain += /\s/.test(c) ? " " : c;
            raised = upper !== null;
        }
        const mayPartThousands = /(^|\D)[1-9]\d{0,2},\d{3}(?!\d)/.test(plain);
        const oneComma = plain.split(",").length === 2 && !plain.includes(".") && !mayPartThousands;
        return oneComma ? plain.replace(",", ".") : plain;
    }

    const NUMBER = /^(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?/;

    class Reader {
        constructor(text) { this.rest = text; }

        take(word) {
            const rest = this.rest.trimStart();
            if (!rest.startsWith(word)) return false;
            this.rest = rest.slice(word.length);
            return true;
        }

        /** What `read` gives, or everything as it was. */
        attempt(read) {
            const before = this.rest;
            const value = read();
            if (value === null) this.rest = before;
            return value;
        }

        sum() {
            let value = this.product();
            if (value === null) return null;
            for (;;) {
                const more = this.attempt(() => this.take("+") ? this.product() : null);
                if (more !== null) { value += more; continue; }
                const less = this.attempt(() => this.take("-") ? this.product() : null);
                if (less === null) return value;
                value -= less;
            }
        }

        product() {
            let value = this.factor();
            if (value === null) return null;
            for (;;) {
                let by = this.attempt(() => this.times() ? this.factor() : null);
                if (by !== null) { value *= by; continue; }
                by = this.attempt(() => this.take("/") ? this.factor() : null);
                if (by !== null) { value /= by; continue; }
                by = this.attempt(() => /^\s*(pi|sqrt|\()/.test(this.rest) ? this.factor() : null);
                if (by === null) return value;
                value *= by;
            }
        }

        /** A sign of multiplication; the letter x is one before a digit. */
        times() {
            if (this.take("*")) return true;
            const before = this.rest;
            if (this.take("x") && NUMBER.test(this.rest.trimStart())) return true;
            this.rest = before;
            return false;
        }

        factor() {
            if (this.take("-")) {
                const value = this.factor();
                return value === null ? null : -value;
            }
            if (this.take("+")) return this.factor();
            const base = this.atom();
            if (base === null) return null;
            const power = this.attempt(() => this.take("^") ? this.integer() : null);
            if (power === null) return base;
            return base === 10 ? Number(`1e${power}`) : base ** power;
        }

        integer() {
            const [integer] = this.rest.trimStart().match(/^[-+]?\d+/) ?? [null];
            if (integer === null) return null;
            this.take(integer);
            return Number(integer);
        }

        atom() {
            this.rest = this.rest.trimStart();
            const [number] = this.rest.match(NUMBER) ?? [null];
            if (number !== null) {
                this.take(number);
                return Number(number);
            }
            if (this.take("sqrt")) {
                const value = this.atom();
                return value === null ? null : Math.sqrt(value);
            }
            if (this.take("(")) {
                const inside = this.sum();
                return inside !== null && this.take(")") ? inside : null;
            }
            if (!/^pi(?![A-Za-z])/.test(this.rest)) return null;
            this.take("pi");
            return Math.PI;
        }
    }

    /** Significant digits, and the worth of the last, of a decimal number or one times 10^n. */
    function typed(number) {
        const tight = number.replace(/ /g, "").replace(/x/g, "*").replace("*10^", "e");
        const parts = tight.match(/^[-+]*(\d+\.?\d*|\.\d+)(?:e([-+]?\d+))?$/i);
        if (parts === null) return null;
        const [, mantissa, exponent = "0"] = parts;
        const decimals = (mantissa.split(".")[1] ?? "").length;
        const digits = mantissa.replace(".", "").replace(/^0+/, "").length;
        return { digits, worth: Number(`1e${Number(exponent) - decimals}`) };
    }

    const NAMES = {
        degree: "deg", degrees: "deg", radian: "rad", radians: "rad", sec: "s", second: "s",
        seconds: "s", metre: "m", metres: "m", meter: "m", meters: "m",
    };

    /** The powers of the base units in `unit`, radians left out; null if it is no unit. */
    function powers(unit) {
        const found = new Map();
        let rest = unit === "-" ? "" : unit.trim();
        let inverse = false;
        while (rest !== "") {
            if (" */".includes(rest[0])) {
                inverse = rest[0] === "/" || (inverse && rest[0] === " ");
                rest = rest.slice(1);
                continue;
            }
            if (rest[0] === "1") {
                rest = rest.slice(1);
                inverse = false;
                continue;
            }
            const part = rest.match(/^([A-Za-z]+)(\^?-?\d+|\^|-)?/);
            if (part === null || part[2] === "^" || part[2] === "-") return null;
            const name = NAMES[part[1]] ?? part[1];
            const power = Number((part[2] ?? "1").replace("^", ""));
            if (name !== "rad") found.set(name, (found.get(name) ?? 0) + (inverse ? -power : power));
            inverse = false;
            rest = rest.slice(part[0].length);
        }
        for (const [name, power] of found) if (power === 0) found.delete(name);
        return found;
    }

    const same = (a, b) => a.size === b.size && [...a].every(([name, power]) => b.get(name) === power);

    /** An answer, or `{ error }`. */
    function read(text) {
        if ([...text].length > LONGEST) return { error: NONE };
        const plain = spelled(text);
        if (plain.includes(",")) {
            return { error: "decimals come after a point, thousands are not parted" };
        }
        const reader = new Reader(plain);
        const value = reader.sum();
        const unit = reader.rest.trim();
        // Of a programmer, who does not mean zero times ten.
        const hexadecimal = /^[-+ ]*0x/.test(plain);
        if (value === null || hexadecimal || unit === "-" || powers(unit) === null) return { error: NONE };
        if (!Number.isFinite(value)) return { error: "that is not a finite number" };
        return { value, unit, typed: typed(plain.slice(0, plain.length - reader.rest.length)) };
    }

    /**
     * How far from `value` its rounding to so many significant digits may lie: half of what the
     * last of them is worth. A rounding of doubles is allowed for.
     */
    function halfOfLast(value, digits) {
        const last = Math.floor(Math.log10(Math.abs(value))) + 1 - digits;
        return 0.5 * Number(`1e${last}`) * (1 + 1e-9);
    }

    /** What became of an answer: its class, and what to say. The words come with the page. */
    function judge(answer, check, rules) {
        const { value: v, unit } = check;
        const x = answer.value;
        if (answer.unit !== "") {
            const [asked, given] = [powers(unit), powers(answer.unit)];
            if (!same(asked, given)) {
                const degrees = given.get("deg") === 1 && given.delete("deg");
                return degrees && same(asked, given) && rules.angles.includes(unit)
                    ? ["slip", rules.degrees]
                    : ["unit", unit === "-" ? `it has no unit, not ${answer.unit}`
                        : `the unit is ${unit}, not ${answer.unit}`];
            }
        }
        const within = (target) => Math.abs(x - target) <=
            Math.max(check.within * (target === 0 ? 1 : Math.abs(target)), check.bound);
        const asked = Math.ceil(-Math.log10(check.within) - 1e-9) + 1;
        const right = v === 0 ? within(v)
            : Math.abs(x - v) <= Math.max(halfOfLast(v, asked), check.bound);
        if (right) return ["right", "right"];
        const slip = check.slips.find((s) => within(s.value));
        if (slip) return ["slip", slip.hint];
        if (v === 0) return ["wrong", "not this"];
        const given = answer.typed?.digits ?? 0;
        if (given >= 1 && Math.abs(x - v) <= 0.5 * answer.typed.worth) {
            return given < asked
                ? ["nearly", `right as far as it goes: ${given} digit${given === 1 ? "" : "s"}; give ${asked}`]
                : ["nearly", `right to ${given} digits; give ${given + 1}`];
        }
        const n = Math.floor(-Math.log10(2 * Math.abs(x - v))) + Math.floor(Math.log10(Math.abs(v))) + 1;
        if (n >= 2) return ["nearly", `right to ${n} digits; give ${Math.max(asked, n + 1)}`];
        const usual = rules.usual.find((u) => within(u.factor * v) &&
            (u.units.length === 0 || u.units.includes(unit)));
        if (usual) return ["slip", usual.hint];
        return within(1 / v) ? ["slip", rules.reciprocal] : ["wrong", "not this"];
    }

    // ---- The address of a problem sheet: examples/problem_sheet/address.rs.

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
     * `unset` the names of parameters that are not set unless they are given.
     */
    function addressed(query, stem, own, checks, unset = []) {
        const { error, given, sheet } = parts(query);
        if (error !== undefined) return { error };
        if (given.size === 0 && sheet === undefined) return null;
        const known = [...own.map(([name]) => name), ...unset];
        for (const [name, value] of given) {
            if (!known.includes(name)) {
                return { error: `This page has no parameter ${name}; it has ${known.join(", ")}` };
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

    return { read, judge, parts, addressed };
})();

if (typeof module !== "undefined") module.exports = Answer;
