// Drives answer.js with an address that examples/problem_sheet makes.
// `node book/theme/answer.test.js`
"use strict";
const { readFileSync } = require("node:fs");
const { join } = require("node:path");
const Answer = require("./answer.js");

const root = join(__dirname, "../..");
const data = (name) => JSON.parse(readFileSync(join(root, "tests/data", name), "utf8"));
let wrong = 0;
let ran = 0;
const expect = (what, found, said) => {
    ran += 1;
    if (found === said) return;
    wrong += 1;
    console.error(`${what}: expected '${said}', found '${found}'`);
};

// ---- The address of a sheet. `cargo test` asserts that the sheet maker makes this address.
const sheet = data("sheet_address.json");
const query = sheet.address.slice(sheet.address.indexOf("?"), sheet.address.indexOf("#"));
const ask = (query, { stem, own, checks } = sheet) => Answer.addressed(query, stem, own, checks);
const whole = ask(query);
expect("the address of a sheet", whole.error, undefined);
expect("its parameters", JSON.stringify([...whole.values]), JSON.stringify(sheet.values));
for (const [key, , said] of sheet.judged) {
    const { value, bound, within } = whole.checks.find((check) => check.key === key);
    expect(`${key} on the sheet, ${said}`, [value, bound, within].every(Number.isFinite), true);
}
for (const plain of ["", "?", "?highlight=ladder", "?search=wall&highlight=a"]) {
    expect(`'${plain}' asks for nothing`, ask(plain), null);
}
expect("a time", ask(`${query}&t=1.5`).error, undefined);
expect("a time alone", ask("?t=1.5"), null);
expect("a marked word", ask(`${query}&highlight=wall`).error, undefined);
const [first, ...others] = query.slice(1).split("&");
expect("another order", ask(`?${[...others, first].join("&")}`).error, undefined);
// Every character lost, doubled or changed must be noticed: a wrong verdict is worse than none.
for (let at = 1; at < query.length; at += 1) {
    const [before, after] = [query.slice(0, at), query.slice(at + 1)];
    const other = query[at] === "7" ? "8" : "7";
    for (const damaged of [before, before + after, before + query[at] + query.slice(at), before + other + after]) {
        const found = ask(damaged);
        // An empty part says nothing.
        if (damaged === "?" || damaged.replace("&&", "&") === query) continue;
        expect(`damaged at ${at}: ${damaged.slice(0, 40)}…`, typeof found?.error, "string");
    }
}
const refused = (what, query, words, page) => {
    const { error } = ask(query, page) ?? {};
    expect(`${what}: ${error}`, error?.includes(words), true);
};
const [name, value] = sheet.values[0];
refused("another number", query.replace(`${name}=${value}`, `${name}=${value}1`), "does not hold together");
refused("a word", query.replace(`${name}=${value}`, `${name}=long`), "is not a number");
refused("a parameter left out", query.replace(`${name}=${value}&`, ""), "does not hold together");
refused("a parameter twice", `${query}&${name}=${value}`, "stands twice");
refused("an unknown parameter", `${query}&colour=3`, "no parameter colour; it has");
refused("parameters alone", `?${name}=${value}`, "cannot compute");
refused("a time in words", `${query}&t=noon`, "is not a number");
refused("a damaged sign", `${query}&t=%E0`, "does not hold together");
// What a page that computes makes of parameters alone, and of those that are not set without it.
const alone = ask(`?${name}=1e-3`);
expect("parameters alone are told", JSON.stringify([...alone.values]), JSON.stringify([[name, "1e-3"]]));
refused("an effect", "?friction=0.1", "no parameter friction");
const { stem, own, checks } = sheet;
const withEffect = Answer.addressed("?friction=", stem, own, checks, ["friction"]);
expect("an effect left out", JSON.stringify([...withEffect.values]), JSON.stringify([["friction", ""]]));
refused("another page", query, "does not hold together", { ...sheet, stem: "another" });
const moved = sheet.own.map(([known, value]) => [known, sheet.values.some(([own]) => own === known) ? value : "1.62"]);
refused("other defaults", query, "does not hold together", { ...sheet, own: moved });
refused("fewer checks", query, "does not hold together", { ...sheet, checks: sheet.checks.slice(1) });
const [{ slips, ...check }, ...rest] = sheet.checks;
refused("other slips", query, "does not hold together", { ...sheet, checks: [{ ...check, slips: slips.slice(1) }, ...rest] });

console.log(`${ran} cases, ${wrong} are otherwise than stated`);
process.exit(wrong === 0 && ran > 1000 ? 0 : 1);
