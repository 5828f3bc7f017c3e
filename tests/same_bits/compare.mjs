// node compare.mjs [MODULES]: joins the packs of every page as a page does and holds what they
// tell against what is locked, byte for byte: each report, each figure, and each command that a
// reader is given. What moves is held against what the full packs draw.
//
// Two pages at a time. A damaged pack must be seen. Without MODULES it is the committed packs that
// are compared, and of them the pages whose packs, or what is locked of them, are not those of
// `compared.json`: what was compared once is the same again. PAGES=all compares every page, and
// writes that file if none differs.
import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { runInThisContext } from 'node:vm';
import { gunzipSync, gzipSync } from 'node:zlib';
import { Worker, isMainThread, parentPort, workerData } from 'node:worker_threads';

const root = new URL('../../', import.meta.url);
const read = (path) => readFileSync(new URL(path, root));
const modules = workerData ?? process.argv[2] ?? 'book/modules';
const record = new URL('compared.json', import.meta.url);
const whole = process.env.PAGES === 'all';
const index = JSON.parse(read(`${modules}/index.json`));
const caller = runInThisContext(`${read('book/theme/module.js')};caller`);

// Kilobytes that a list may weigh, as measured, and all packs together. The first touch of a page
// asks for what moves or for what tells.
const MOST = { motion: 288, told: 321, full: 701, rest: 829, all: 3000 };

// What tells on pages that need more, as measured: what they print runs most of the library.
const HEAVIER = {
  hard_cases: 594, accuracy: 478, effects: 428, ch16_2_top_and_wheel: 400, ch16_2_gyroscope: 371, library: 362,
  accuracy_races: 343,
};

const packs = (stem, list) => index.pages[stem][list].map((name) => read(`${modules}/${name}`));

// A locked text follows a head between two lines of dashes.
function locked(file) {
  const text = read(`tests/snapshots/${file}`).toString();
  return text.slice(text.indexOf('\n---\n', 4) + 5);
}

// The commands that readers are given: how each ended, the digest of what it told, its words.
function commands() {
  const files = readdirSync(new URL('tests/snapshots/commands', root)).map((name) => locked(`commands/${name}`));
  const lines = files.join('\n').split('\n').filter((line) => /^\d+ [0-9a-f]{16} /.test(line));
  return lines.map((line) => line.trim().split(/\s+/));
}

// All that the comparison of a page rests on.
function state(stem) {
  const hash = createHash('sha256');
  const figures = readdirSync(new URL(`tests/snapshots/${stem}`, root));
  const files = [
    'tests/same_bits/compare.mjs', 'book/theme/module.js', `tests/snapshots/${stem}.snap`,
    ...figures.sort().map((name) => `tests/snapshots/${stem}/${name}`),
    ...index.pages[stem].rest.map((name) => `${modules}/${name}`),
  ];
  for (const file of files) hash.update(file).update(read(file));
  hash.update(JSON.stringify([index.pages[stem], commands().filter(([, , of]) => of === stem)]));
  return hash.digest('hex');
}

// The pages that are to be compared.
function pages() {
  const all = Object.keys(index.pages);
  if (whole || process.argv[2]) return all;
  const known = JSON.parse(readFileSync(record));
  return all.filter((stem) => known[stem] !== state(stem));
}

// FNV-1a of 64 bits, as `tests/pages/commands.rs` has it, in two halves.
function digest(text) {
  let [high, low] = [0xcbf29ce4, 0x84222325];
  for (const byte of Buffer.from(text)) {
    low = (low ^ byte) >>> 0;
    const product = low * 0x1b3;
    high = (Math.imul(high, 0x1b3) + Math.floor(product / 0x100000000) + (low << 8)) >>> 0;
    low = product >>> 0;
  }
  return [high, low].map((half) => half.toString(16).padStart(8, '0')).join('');
}

// A page's module: a call answers, by the next longer list where a function is missing.
function page(stem, lists) {
  const call = caller();
  const { page } = index.pages[stem];
  let left = [...lists];
  let send = packs(stem, left.shift());
  const ask = async (message) => {
    const answer = await call({ ...message, page, packs: send });
    send = undefined;
    if (!answer.trapped || left.length === 0) return answer;
    ask.longer.push(message.call);
    send = packs(stem, left.shift());
    return ask(message);
  };
  ask.longer = []; // the calls that needed a longer list
  return ask;
}

// What a page tells other than what is locked: the names of what differs.
async function told(stem) {
  const began = performance.now();
  const differ = [];
  let compared = 0;
  const hold = (name, found, expected) => {
    compared += 1;
    if (found !== expected) differ.push(name);
  };
  const [words, all] = [page(stem, ['told', 'full', 'rest']), page(stem, ['full', 'rest'])];
  const ask = async (call, text, list = all) => (await list({ call, text })).text ?? '{}';
  hold(stem, (await ask('report')).trimEnd(), locked(`${stem}.snap`).trimEnd());
  for (const { name, svg } of JSON.parse(await ask('figures', '')).figures ?? []) {
    hold(`${stem}__${name}`, svg, read(`tests/snapshots/${stem}/${name}.snap.svg`).toString());
  }
  for (const [code, expected, of, ...given] of commands()) {
    if (of !== stem) continue;
    const draws = given.includes('--svg') || given.includes('--csv');
    const { stdout, stderr, code: ended, files } = JSON.parse(await ask('run', given.join('\0'), draws ? all : words));
    const written = files.map((file) => file.text).join('');
    hold([stem, ...given].join(' '), `${ended} ${digest(stdout + stderr + written)}`, `${code} ${expected}`);
  }
  if (index.pages[stem].declared.moves) {
    const lists = [page(stem, ['motion']), page(stem, ['rest'])];
    const both = (message) => Promise.all(lists.map((ask) => ask(message)));
    const [open, whole] = await both({ call: 'open', text: '' });
    hold(`${stem}, opened`, open.text, whole.text);
    const { span = [], stills = [] } = JSON.parse(whole.text);
    for (const t of [...span, ...stills]) {
      for (const turn of [0, 0.5]) {
        const frames = await both({ call: 'frame', numbers: [t, turn, 0] });
        const [found, expected] = frames.map(({ bytes, error }) => (bytes ? Buffer.from(bytes).toString('base64') : error));
        hold(`${stem} at ${t}`, found, expected);
      }
    }
  }
  return { stem, differ, compared, longer: [...words.longer, ...all.longer], seconds: (performance.now() - began) / 1000 };
}

// The packs with a letter of a page's text changed, well compressed again: the report is then
// another. A pack that is cut off does not join at all.
async function damaged() {
  const stem = Object.keys(index.pages).find((stem) => index.pages[stem].declared.moves);
  const letter = Buffer.from(index.pages[stem].declared.about.slice(0, 12));
  const call = caller();
  const changed = packs(stem, 'full').map((gz) => {
    const pack = gunzipSync(gz);
    const at = pack.indexOf(letter);
    if (at >= 0) pack[at] ^= 1;
    return gzipSync(pack);
  });
  const { text } = await call({ packs: changed, call: 'declared', page: index.pages[stem].page });
  const cut = packs(stem, 'full');
  cut[0] = cut[0].subarray(0, cut[0].length - 9);
  const { error } = await call({ packs: cut, call: 'declared', page: index.pages[stem].page });
  return JSON.parse(text).about !== index.pages[stem].declared.about && error !== undefined;
}

// What the packs for what moves lack breaks a report off; the longer list tells it.
async function longer() {
  const stem = Object.keys(index.pages).find((stem) => index.pages[stem].declared.moves);
  const ask = page(stem, ['motion', 'full']);
  const { text } = await ask({ call: 'report' });
  return ask.longer.join() === 'report' && text.trimEnd() === locked(`${stem}.snap`).trimEnd();
}

// Lists that weigh more than they may, in kilobytes.
function heavy() {
  const weight = (name) => statSync(new URL(`${modules}/${name}`, root)).size / 1000;
  const sum = (names) => names.reduce((sum, name) => sum + weight(name), 0);
  const files = readdirSync(new URL(modules, root)).filter((name) => name.endsWith('.gz'));
  const lists = Object.entries(index.pages).flatMap(([stem, page]) => ['motion', 'told', 'full', 'rest'].map((list) => {
    const most = list === 'told' ? HEAVIER[stem] ?? MOST.told : MOST[list];
    return [`${stem}, ${list}`, sum(page[list]), most];
  }));
  return [...lists, ['all packs', sum(files), MOST.all]].filter(([, weight, most]) => !(weight <= most));
}

if (!isMainThread) {
  parentPort.on('message', async (stem) => parentPort.postMessage(await told(stem)));
} else {
  const waiting = pages();
  const [of, count] = [waiting.length, Object.keys(index.pages).length];
  const total = { compared: 0, differ: [], longer: 0 };
  const hand = (worker) => (waiting.length > 0 ? worker.postMessage(waiting.shift()) : worker.terminate());
  const done = Array.from({ length: 2 }, () => new Promise((ended, failed) => {
    const worker = new Worker(new URL(import.meta.url), { workerData: modules });
    worker.on('message', ({ stem, differ, compared, longer, seconds }) => {
      total.compared += compared;
      total.differ.push(...differ);
      total.longer += longer.length;
      if (seconds > 3 || longer.length > 0) console.log(`${stem}: ${seconds.toFixed(1)} s; needs more for ${longer.length} calls`);
      hand(worker);
    });
    worker.on('error', failed);
    worker.on('exit', ended);
    hand(worker);
  }));
  await Promise.all(done);
  const [seen, on] = [await damaged(), await longer()];
  const much = heavy();
  const { user, system } = process.cpuUsage();
  for (const [name, weight, most] of much) console.log(`${name}: ${weight.toFixed(0)} kB of ${most}`);
  console.log(`modules: ${of} of ${count} pages have changed since they were compared; ${total.compared} answers compared, ${total.differ.length} differ ${total.differ.join(', ')}; ` +
    `${total.longer} calls needed what is rarely called; a damaged pack is ${seen ? '' : 'not '}seen, one that is short is ${on ? '' : 'not '}helped; ${((user + system) / 1e6).toFixed(0)} s of processor`);
  if (total.differ.length > 0) console.log('numbers have changed: make the packs anew with `cargo modules`');
  const sound = total.differ.length === 0 && seen && on && much.length === 0;
  if (sound && whole && !process.argv[2]) {
    const states = Object.keys(index.pages).map((stem) => [stem, state(stem)]);
    writeFileSync(record, `${JSON.stringify(Object.fromEntries(states), null, 1)}\n`);
  }
  process.exit(sound && (of === 0 || total.compared > 0) ? 0 : 1);
}
