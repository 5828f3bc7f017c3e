// Drives answer.js with the cases that also drive src/report/answer.rs, and with the rules
// that the builder writes into the pages. `node book/theme/answer.test.js`
"use strict";
const { readFileSync } = require("node:fs");
const { join } = require("node:path");
const Answer = require("./answer.js");

const root = join(__dirname, "../..");
const cases = JSON.parse(readFileSync(join(root, "tests/data/answers.json"), "utf8"));
const rules = JSON.parse(readFileSync(join(root, "tests/data/answer_rules.json"), "utf8"));
let wrong = 0;
let ran = 0;
const expect = (what, found, said) => {
    ran += 1;
    if (found === said) return;
    wrong += 1;
    console.error(`${what}: expected '${said}', found '${found}'`);
};
for (const [key, text, said] of cases.judged) {
    const answer = Answer.read(text);
    const found = answer.error ?? Answer.judge(answer, cases.checks[key], rules)[1];
    expect(`${key} = '${text}'`, found, said);
}
for (const [text, said] of cases.refused) expect(`'${text}'`, Answer.read(text).error, said);
console.log(`${ran} answers, ${wrong} judged otherwise than stated`);
process.exit(wrong === 0 && ran > 60 ? 0 : 1);
