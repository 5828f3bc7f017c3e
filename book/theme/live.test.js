// Drives live.js without a browser: which module a machine is given and when, how its answers come
// back, what a stop does, and how parameters become arguments. `node book/theme/live.test.js`
"use strict";
const assert = require("node:assert");

// ---- A page, a server of modules in two pieces, a worker that answers as it is told.
const pages = { rod: { module: "a.gz", page: 3, size: 5, flags: ["length", "friction", "gravity"], effects: ["friction", "gravity"] }, disc: { module: "d.gz", page: 0, size: 5 } };
const asked = [];
const workers = [];
let missing = "";
let more = []; // pieces that were not announced
let late; // what an answer waits for
globalThis.document = {
    getElementById: () => ({ textContent: JSON.stringify({ pages, inks: ["fig-ink"] }) }),
    documentElement: { classList: { contains: () => true } },
    addEventListener: () => {},
    querySelectorAll: () => [],
    createElement: () => ({}),
    head: { append: (script) => { asked.push(script.src); Live.packed("module", "source"); script.onload(); } },
};
globalThis.location = { protocol: "http:", search: "?angle=1&highlight=wall", pathname: "/rod.html", hash: "#x" };
globalThis.history = { state: null, replaceState: (_, __, address) => { location.address = address; } };
globalThis.fetch = async (address) => {
    asked.push(address);
    const pieces = [Uint8Array.of(1, 2), Uint8Array.of(3, 4, 5), ...more];
    await late;
    return { ok: address !== missing, body: { getReader: () => ({ read: async () => ({ done: pieces.length === 0, value: pieces.shift() }) }) } };
};
globalThis.URL.createObjectURL = () => "blob:";
globalThis.URL.revokeObjectURL = () => {};
globalThis.Worker = class {
    constructor() { workers.push(this); this.got = []; }
    postMessage(message) {
        this.got.push(message);
        if (message.call === "run" && message.text === "endless") return;
        const answer = message.call !== "open" ? { text: "{}" }
            : message.text === "bad" ? { text: '{"error": "refused"}' }
            : message.text === "broken" ? { error: "unreachable" }
            : { text: '{"span": [0, 1]}' };
        setTimeout(() => this.onmessage({ data: { id: message.id, ...answer } }));
    }
    terminate() { this.ended = true; }
};
const Live = require("./live.js");
globalThis.Live = Live;

(async () => {
    assert.ok(Live.able && Live.has("rod") && !Live.has("table"));
    assert.deepStrictEqual([Live.flags("rod"), Live.flags("table")], [["length", "friction", "gravity"], []]);
    assert.deepStrictEqual(asked, [], "nothing is brought before it is asked for");
    const machine = Live.machine("rod", "motion");
    assert.strictEqual(Live.machine("rod", "motion"), machine);
    const [first, second] = await Promise.all([machine.ask("open", "angle=1"), machine.ask("open", "")]);
    assert.deepStrictEqual([first, second], [{ span: [0, 1] }, { span: [0, 1] }]);
    assert.deepStrictEqual(asked.sort(), ["modules/a.gz", "modules/module.js"]);
    const [{ got }] = workers;
    assert.deepStrictEqual(got.map(({ call, page, text, gz }) => [call, page, text, gz && [...gz]]),
        [[undefined, undefined, undefined, undefined], [undefined, undefined, undefined, [1, 2, 3, 4, 5]], ["open", 3, "angle=1", undefined], ["open", 3, "", undefined]],
        "the source and the module go once, before the first call");
    await machine.call("frame", { numbers: [0, 0, 0] });
    assert.strictEqual(got[4].page, undefined, "a frame is of the page that is open");
    await assert.rejects(machine.ask("open", "bad"), /^Error: refused$/);

    await assert.rejects(machine.ask("open", "broken"), /^Error: unreachable$/);
    await machine.ask("open", "");

    // A stop: whoever waits is told, and the next call has a worker of its own.
    const told = Live.machine("rod", "told");
    await told.ask("run", "short");
    const endless = told.ask("run", "endless");
    setTimeout(() => told.end(), 20);
    await assert.rejects(endless, /^Error: stopped$/);
    assert.ok(workers[1].ended);
    await told.ask("run", "short");
    assert.strictEqual(workers[2].got[1].gz.length, 5);
    assert.strictEqual(asked.filter((address) => address === "modules/a.gz").length, 1, "a module is fetched once");

    // What is prepared at a touch is what the click then asks; a machine apart has a worker of its own.
    const apart = Live.machine("rod", "figures");
    const count = workers.length;
    await apart.prepare();
    assert.deepStrictEqual([workers.length, workers.at(-1).got.length, apart.busy], [count + 1, 2, false]);
    const drawn = apart.ask("figures");
    assert.ok(apart.busy && !told.busy);
    await drawn;
    assert.deepStrictEqual([workers.length, workers.at(-1).got.length, apart.busy], [count + 1, 3, false]);

    // One that is not there, or not as long as it was, is an error in words, and is asked for again.
    const other = Live.machine("disc", "motion");
    missing = "modules/d.gz";
    await assert.rejects(other.ask("open"), /modules\/d.gz did not arrive/);
    [missing, more] = ["", [Uint8Array.of(6)]];
    await assert.rejects(other.ask("open"), /modules\/d.gz is not as long as it was/);
    more = [];

    // How much has come is told while it is on its way. A reader who saves data gets none ahead.
    Object.defineProperty(globalThis, "navigator", { value: { connection: { saveData: true } }, configurable: true });
    const before = asked.length;
    Live.ahead("disc");
    assert.strictEqual(asked.length, before);
    navigator.connection.saveData = false;
    let arrive;
    late = new Promise((done) => { arrive = done; });
    Live.ahead("disc");
    assert.deepStrictEqual([asked.length, Live.arriving("disc"), Live.arriving("rod")], [before + 1, "loading, 0 % of 0 kB", ""]);
    arrive();
    await other.ask("open");
    assert.deepStrictEqual([asked.length, Live.arriving("disc")], [before + 1, ""]);

    // Parameters as arguments, and in the address: what the search marked stays there.
    const values = new Map([["length", "-1e-3"], ["friction", "0.1"], ["gravity", ""]]);
    const heard = [];
    Live.listen((state) => heard.push([...state]));
    Live.change(values, null);
    assert.deepStrictEqual(heard, [[...values]]);
    assert.deepStrictEqual(Live.commanded("rod"), ["--length", "-1e-3", "--with", "friction=0.1", "--without", "gravity"]);
    Live.remember("0.50");
    assert.strictEqual(location.address, "?length=-1e-3&friction=0.1&gravity=&t=0.50&highlight=wall#x");
    location.search = "";
    Live.change(new Map(), null);
    Live.remember(null);
    assert.strictEqual(location.address, "/rod.html#x");
    console.log(`${asked.length} files are brought, ${workers.length} workers answer as they should`);
})();
