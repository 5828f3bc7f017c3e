// Paints a display list (book/kit/src/draw/encoded.rs) on a canvas, so that it looks as the
// locked SVG does (book/kit/src/draw/svg.rs): the same lines, dashes, halos, letters, colours.
// `node book/theme/paint.test.js`
"use strict";

const Paint = (() => {
    const UNITS = 100; // of a place in a px
    const DASHES = [[], [6, 4], [0.1, 4]]; // solid, dashed, dotted
    const ANCHORS = [0, 0.5, 1]; // how much of a text lies before its place
    const HALO = 4; // px, half of it outside of the letters

    /** The drawing in `bytes`: `{ size, shapes, texts }`; the places stay where they lie. */
    function decoded(bytes) {
        const buffer = bytes.buffer ?? bytes;
        const [ints, reals] = [new Int32Array(buffer), new Float32Array(buffer)];
        const utf8 = new TextDecoder();
        let at = 0;
        const skip = (words) => {
            const from = at;
            at += words;
            if (words < 0 || at > ints.length) throw new RangeError(`a drawing of ${ints.length} words ends too early`);
            return from;
        };
        const int = () => ints[skip(1)];
        const real = () => reals[skip(1)];
        const places = () => {
            const from = skip(2 * int());
            return ints.subarray(from, at);
        };
        const list = (count, read) => {
            const all = [];
            for (let n = 0; n < count; n += 1) all.push(read());
            return all;
        };
        const shape = () => {
            const kind = int();
            if (kind === 0) return { kind, ink: int(), closed: int(), dash: int(), width: real(), opacity: real(), places: places() };
            if (kind === 1) return { kind, ink: int(), opacity: real(), places: places() };
            if (kind === 2) return { kind, ink: int(), light: int(), places: places() };
            if (kind === 3) return { kind, ink: int(), ring: int(), radius: real(), places: ints.subarray(skip(2), at) };
            throw new RangeError(`a drawing has no shape of kind ${kind}`);
        };
        const run = () => {
            const [slanted, size, drop, length] = [int(), real(), real(), int()];
            const letters = new Uint8Array(buffer, 4 * skip(Math.ceil(length / 4)), length);
            return { slanted, size, drop, text: utf8.decode(letters) };
        };
        const text = () => {
            const [x, y, anchor, ink, halo] = [int(), int(), int(), int(), int()];
            return { x, y, anchor, ink, halo, runs: list(int(), run) };
        };
        const [width, height, shapes, texts] = [int(), int(), int(), int()];
        const drawing = { size: [width, height], shapes: list(shapes, shape), texts: list(texts, text) };
        if (at !== ints.length) throw new RangeError(`a drawing has ${ints.length - at} words left over`);
        return drawing;
    }

    /** `percent` of the colour `lit` (#RRGGBB) with the rest `shade`. */
    function mixed(lit, shade, percent) {
        const channels = (colour) => [1, 3, 5].map((from) => parseInt(colour.slice(from, from + 2), 16));
        const dark = channels(shade);
        const each = channels(lit).map((bright, n) => (bright * percent + dark[n] * (100 - percent)) / 100);
        return `rgb(${each.map((channel) => channel.toFixed(2)).join(" ")})`;
    }

    /** The colours and faces of the theme that `element` stands in; `names` are those of the inks. */
    function theme(element, names) {
        const style = getComputedStyle(element);
        const colour = (variable) => style.getPropertyValue(`--${variable}`).trim();
        const inks = names.map((name) => ({
            line: colour(name), text: colour(`${name}-text`), lit: colour(`${name}-lit`), shade: colour(`${name}-shade`),
        }));
        const faces = new Map();
        return {
            paper: colour("fig-paper"),
            words: colour("fig-words"),
            variables: colour("fig-math"),
            line: (ink) => inks[ink].line,
            text: (ink) => inks[ink].text,
            face: (ink, light) => {
                const key = 128 * ink + light;
                if (!faces.has(key)) faces.set(key, mixed(inks[ink].lit, inks[ink].shade, light));
                return faces.get(key);
            },
        };
    }

    function outlined(context, places, closed) {
        context.beginPath();
        for (let n = 0; n < places.length; n += 2) context.lineTo(places[n] / UNITS, places[n + 1] / UNITS);
        if (closed) context.closePath();
    }

    const shapes = [
        function line(context, shape, theme) {
            outlined(context, shape.places, shape.closed);
            context.strokeStyle = theme.line(shape.ink);
            context.lineWidth = shape.width;
            context.globalAlpha = shape.opacity;
            context.setLineDash(DASHES[shape.dash]);
            context.lineCap = shape.dash === 2 ? "round" : "butt";
            context.stroke();
            context.setLineDash([]);
            context.lineCap = "butt";
            context.globalAlpha = 1;
        },
        function area(context, shape, theme) {
            outlined(context, shape.places, true);
            context.fillStyle = theme.line(shape.ink);
            context.globalAlpha = shape.opacity;
            context.fill();
            context.globalAlpha = 1;
        },
        function face(context, shape, theme) {
            outlined(context, shape.places, true);
            context.fillStyle = context.strokeStyle = theme.face(shape.ink, shape.light);
            context.lineWidth = 1;
            context.fill();
            context.stroke();
        },
        function dot(context, shape, theme) {
            const [x, y] = shape.places;
            context.beginPath();
            context.arc(x / UNITS, y / UNITS, shape.radius, 0, 2 * Math.PI);
            context.fillStyle = shape.ring ? theme.paper : theme.line(shape.ink);
            context.fill();
            if (!shape.ring) return;
            context.strokeStyle = theme.line(shape.ink);
            context.lineWidth = 1.5;
            context.stroke();
        },
    ];

    /** What there is to write: each run with its font and its place. */
    function set(context, text, theme) {
        const runs = text.runs.map((run) => {
            const font = `${run.slanted ? "italic " : ""}${run.size.toFixed(1)}px ${run.slanted ? theme.variables : theme.words}`;
            context.font = font;
            return { font, text: run.text, drop: run.drop, width: context.measureText(run.text).width };
        });
        const whole = runs.reduce((sum, run) => sum + run.width, 0);
        let x = text.x / UNITS - ANCHORS[text.anchor] * whole;
        for (const run of runs) {
            [run.x, run.y] = [x, text.y / UNITS + run.drop];
            x += run.width;
        }
        return { ...text, runs };
    }

    /** Paints the `drawing` on the `canvas`, with a margin of so many of its px, as large as fits. */
    function draw(canvas, drawing, theme, margin = 0) {
        const context = canvas.getContext("2d");
        const [width, height] = drawing.size.map((px) => px + 2 * margin);
        const scale = Math.min(canvas.width / width, canvas.height / height);
        const corner = [(canvas.width - scale * width) / 2, (canvas.height - scale * height) / 2].map((px) => px + scale * margin);
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.clearRect(0, 0, canvas.width, canvas.height);
        context.setTransform(scale, 0, 0, scale, ...corner);
        context.fillStyle = theme.paper;
        context.fillRect(0, 0, ...drawing.size);
        context.lineJoin = "round";
        context.textRendering = "geometricPrecision";
        for (const shape of drawing.shapes) shapes[shape.kind](context, shape, theme);
        const texts = drawing.texts.map((text) => set(context, text, theme));
        // All halos first: one that came later would eat its neighbour's letters.
        context.fillStyle = context.strokeStyle = theme.paper;
        context.lineWidth = HALO;
        for (const { runs } of texts.filter((text) => text.halo)) {
            for (const run of runs) {
                context.font = run.font;
                context.fillText(run.text, run.x, run.y);
                context.strokeText(run.text, run.x, run.y);
            }
        }
        for (const { ink, runs } of texts) {
            context.fillStyle = theme.text(ink);
            for (const run of runs) {
                context.font = run.font;
                context.fillText(run.text, run.x, run.y);
            }
        }
    }

    return { decoded, mixed, theme, draw };
})();

if (typeof module !== "undefined") module.exports = Paint;
