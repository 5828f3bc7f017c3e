// node compare.mjs [MODULES]: holds what the modules tell against what is locked, byte for byte: each
// report, each figure, and each command that a reader is given. What moves must open and be drawn.
//
// Two pages at a time. A damaged module must be seen. Without MODULES it is the committed ones that
// are compared, and of them the pages whose module, or what is locked of them, are not those of
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

// Kilobytes that a module may weigh, and all of them (3861 as measured: 3110 for four before recordings were
// read, the rest for these and for what a fifth module has in common with the others); how many there may be.
const MOST = { module: 900, all: 3900, files: 8 };

const gz = (stem) => read(`${modules}/${index.pages[stem].module}`);

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
    `${modules}/${index.pages[stem].module}`,
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

// What a page tells other than what is locked: the names of what differs.
async function told(stem) {
  const began = performance.now();
  const differ = [];
  let compared = 0;
  const hold = (name, found, expected) => {
    compared += 1;
    if (found !== expected) differ.push(name);
  };
  const [call, { page }] = [caller(), index.pages[stem]];
  await call({ gz: gz(stem) });
  const ask = async (name, text) => (await call({ call: name, page, text })).text ?? '{}';
  hold(stem, (await ask('report')).trimEnd(), locked(`${stem}.snap`).trimEnd());
  const { figures = [] } = JSON.parse(await ask('figures', ''));
  const kept = readdirSync(new URL(`tests/snapshots/${stem}`, root)).filter((name) => name.endsWith('.snap.svg'));
  hold(`${stem}, its figures`, figures.map(({ name }) => `${name}.snap.svg`).sort().join(), kept.sort().join());
  for (const { name, svg } of figures) {
    hold(`${stem}__${name}`, svg, read(`tests/snapshots/${stem}/${name}.snap.svg`).toString());
  }
  for (const [code, expected, of, ...given] of commands()) {
    if (of !== stem) continue;
    const { stdout, stderr, code: ended, files } = JSON.parse(await ask('run', given.join('\0')));
    const written = files.map((file) => file.text).join('');
    hold([stem, ...given].join(' '), `${ended} ${digest(stdout + stderr + written)}`, `${code} ${expected}`);
  }
  if (index.pages[stem].declared.moves) {
    const { span = [], stills = [], error } = JSON.parse(await ask('open', ''));
    hold(`${stem}, opened`, error, undefined);
    for (const t of [...span, ...stills]) {
      for (const turn of [0, 0.5]) {
        const { bytes } = await call({ call: 'frame', numbers: [t, turn, 0] });
        hold(`${stem} at ${t}`, bytes?.byteLength > 0, true);
      }
    }
  }
  return { stem, differ, compared, seconds: (performance.now() - began) / 1000 };
}

// A module with a letter of a page's text changed, well compressed again, tells another; one that
// is cut off does not run.
async function damaged() {
  const stem = Object.keys(index.pages).find((stem) => index.pages[stem].declared.moves);
  const { page, declared: { about } } = index.pages[stem];
  const changed = gunzipSync(gz(stem));
  changed[changed.indexOf(Buffer.from(about.slice(0, 12)))] ^= 1;
  const call = caller();
  const { text } = await call({ gz: gzipSync(changed), call: 'declared', page });
  const { error } = await call({ gz: gz(stem).subarray(0, -9), call: 'declared', page });
  return JSON.parse(text).about !== about && error !== undefined;
}

// What weighs more than it may, in kilobytes.
function heavy() {
  const files = readdirSync(new URL(modules, root)).filter((name) => name.endsWith('.gz'));
  const weights = files.map((name) => [name, statSync(new URL(`${modules}/${name}`, root)).size / 1000]);
  const all = weights.reduce((sum, [, weight]) => sum + weight, 0);
  return [...weights.map((weight) => [...weight, MOST.module]), ['all modules', all, MOST.all], ['files', files.length, MOST.files]]
    .filter(([, weight, most]) => !(weight <= most));
}

if (!isMainThread) {
  parentPort.on('message', async (stem) => parentPort.postMessage(await told(stem)));
} else {
  const waiting = pages();
  const [of, count] = [waiting.length, Object.keys(index.pages).length];
  const total = { compared: 0, differ: [], stems: [] };
  const hand = (worker) => (waiting.length > 0 ? worker.postMessage(waiting.shift()) : worker.terminate());
  const done = Array.from({ length: 2 }, () => new Promise((ended, failed) => {
    const worker = new Worker(new URL(import.meta.url), { workerData: modules });
    worker.on('message', ({ stem, differ, compared, seconds }) => {
      total.compared += compared;
      total.differ.push(...differ);
      if (differ.length > 0) total.stems.push(stem);
      if (seconds > 3) console.log(`${stem}: ${seconds.toFixed(1)} s`);
      hand(worker);
    });
    worker.on('error', failed);
    worker.on('exit', ended);
    hand(worker);
  }));
  await Promise.all(done);
  const [seen, much] = [await damaged(), heavy()];
  const { user, system } = process.cpuUsage();
  for (const [name, weight, most] of much) console.log(`${name}: ${weight.toFixed(0)}, at most ${most}`);
  console.log(`modules: ${of} of ${count} pages have changed since they were compared; ${total.compared} answers compared, ${total.differ.length} differ ${total.differ.join(', ')}; ` +
    `a damaged module is ${seen ? '' : 'not '}seen; ${((user + system) / 1e6).toFixed(0)} s of processor`);
  if (total.differ.length > 0) {
    const parts = new Set(total.stems.map((stem) => index.pages[stem].module.replace('.wasm.gz', '')));
    console.log(`make the modules anew: node book/live/modules.mjs ${[...parts].join(' ')}`);
  }
  const sound = total.differ.length === 0 && seen && much.length === 0;
  if (sound && whole && !process.argv[2]) {
    const states = Object.keys(index.pages).map((stem) => [stem, state(stem)]);
    writeFileSync(record, `${JSON.stringify(Object.fromEntries(states), null, 1)}\n`);
  }
  process.exit(sound && (of === 0 || total.compared > 0) ? 0 : 1);
}
