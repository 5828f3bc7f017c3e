// Drives paint.js with a display list put together by hand: what is read from it, what is drawn
// and in which order, and that a damaged one is refused. `node book/theme/paint.test.js`
"use strict";
const assert = require("node:assert");
const Paint = require("./paint.js");

const real = (x) => new Int32Array(new Float32Array([x]).buffer)[0];
const letters = (text) => {
    const bytes = new TextEncoder().encode(text);
    const filled = new Uint8Array(4 * Math.ceil(bytes.length / 4));
    filled.set(bytes);
    return [bytes.length, ...new Int32Array(filled.buffer)];
};
const run = (slanted, size, drop, text) => [slanted, real(size), real(drop), ...letters(text)];
const words = [
    340, 260, 5, 2,
    0, 1, 0, 0, real(1.75), real(1), 2, 0, 0, 10000, 5000, // a line
    0, 1, 1, 2, real(1), real(0.5), 2, 0, 0, 100, 100, // closed, dotted, faint
    1, 0, real(0.25), 3, 0, 0, 100, 0, 100, 100, // an area
    2, 1, 40, 3, 0, 0, 100, 0, 100, 100, // a face
    3, 0, 1, real(3.5), 1000, -2000, // a ring
    1000, 2000, 1, 0, 1, 2, ...run(1, 15.12, 0, "\u03b8"), ...run(0, 11.06, 3.5, "max"), // a text with a halo
    1000, 4000, 2, 1, 0, 1, ...run(0, 14, 0, "t / s"),
];
const bytes = (list) => new Uint8Array(Int32Array.from(list).buffer);
const drawing = Paint.decoded(bytes(words));
assert.deepStrictEqual(drawing.size, [340, 260]);
assert.deepStrictEqual(drawing.shapes.map((shape) => shape.kind), [0, 0, 1, 2, 3]);
assert.deepStrictEqual([...drawing.shapes[0].places], [0, 0, 10000, 5000]);
assert.strictEqual(drawing.shapes[0].width, 1.75);
assert.strictEqual(drawing.shapes[4].radius, 3.5);
assert.deepStrictEqual(drawing.texts[0].runs.map((run) => run.text), ["\u03b8", "max"]);

// The damaged twins: too short anywhere, too long, a shape of no kind, a count below zero.
let refused = 0;
for (let length = 0; length < words.length; length += 1) {
    assert.throws(() => Paint.decoded(bytes(words.slice(0, length))), RangeError, `${length} words`);
    refused += 1;
}
assert.throws(() => Paint.decoded(bytes([...words, 0])), /1 words left over/);
assert.throws(() => Paint.decoded(bytes([340, 260, 1, 0, 7])), /no shape of kind 7/);
assert.throws(() => Paint.decoded(bytes([340, 260, 1, 0, 2, 1, 40, -3])), RangeError);

// As `color-mix(in srgb, lit 40%, shade)` has it.
assert.strictEqual(Paint.mixed("#FF0010", "#000A20", 40), "rgb(102.00 6.00 25.60)");

// A context that writes down what it is told.
const told = [];
const context = new Proxy({ measureText: (text) => ({ width: 10 * text.length }), font: "" }, {
    get: (known, name) => name in known ? known[name] : (...values) => told.push([name, ...values]),
    set: (known, name, value) => { known[name] = value; told.push([name, value]); return true; },
});
const theme = {
    paper: "paper", words: "sans", variables: "serif",
    line: (ink) => `line${ink}`, text: (ink) => `text${ink}`, face: (ink, light) => `face${ink}-${light}`,
};
Paint.draw({ width: 700, height: 540, getContext: () => context }, drawing, theme, 5);
const calls = told.map(([name, ...values]) => `${name}(${values.join()})`);
const at = (call, from = 0) => {
    const found = calls.indexOf(call, from);
    assert.ok(found >= 0, `${call} is not drawn\n${calls.join("\n")}`);
    return found;
};
at("setTransform(2,0,0,2,10,10)"); // 5 px of margin, 2 pixels each
at("fillRect(0,0,340,260)");
at("lineTo(100,50)");
at("setLineDash(0.1,4)");
at("globalAlpha(0.5)");
at("fillStyle(face1-40)");
at("arc(10,-20,3.5,0,6.283185307179586)");
// The text is centred: 10 px of theta and 30 of max; the second run hangs lower, in its own size.
const halo = at("strokeText(\u03b8,-10,20)");
const upright = at("fillText(max,0,23.5)", halo);
at("font(italic 15.1px serif)");
at("font(11.1px sans)");
const second = at("fillText(t / s,-40,40)");
assert.ok(halo < upright && halo < second, "all halos lie below all letters");
assert.strictEqual(calls.filter((call) => call.startsWith("strokeText(")).length, 2, "one text has a halo");
console.log(`a list of ${words.length} words is read and drawn, ${refused} shorter ones are refused`);
