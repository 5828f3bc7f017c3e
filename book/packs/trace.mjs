// node trace.mjs PACK: which functions of the whole module run when a page moves, when it tells
// and when it draws.
//
// Answers with JSON: `{palette, pages: [{declared, motion, told, full}]}`, the last three lists of
// the numbers of functions. They need not be complete: where a function is missing, the module
// traps, and the page loads a longer list.
import { readFileSync, readdirSync } from 'node:fs';
import { runInThisContext } from 'node:vm';

const root = new URL('../../', import.meta.url);
const script = readFileSync(new URL('book/theme/module.js', root), 'utf8');
const { assembled, address, reader } = runInThisContext(`${script};({ assembled, address, reader })`);
const pack = readFileSync(process.argv[2]);

// Where the memory that the module starts with ends, and how many functions there are.
function sizes() {
  const head = reader(reader(pack).counted());
  head.counted();
  const memory = reader(head.counted());
  memory.take(2); // one memory; whether it has a limit
  head.counted();
  head.number();
  head.list(() => [head.counted(), head.number()]);
  const functions = head.list(() => [head.number(), head.number()]).reduce((sum, [count]) => sum + count, 0);
  return { end: memory.number() * 0x10000, functions };
}
const { end, functions } = sizes();

// A function that first notes in a byte of its own, beyond that memory, that it runs.
function noted(body, n) {
  const code = reader(body);
  code.list(() => code.number() + code.take(1).length); // the locals
  const rest = code.rest();
  const note = [0x41, ...address(end + n), 0x41, 1, 0x3a, 0, 0]; // i32.const, i32.const 1, i32.store8
  return Uint8Array.from([...body.subarray(0, body.length - rest.length), ...note, ...rest]);
}
const module = new WebAssembly.Module(assembled([pack], noted));

// What a new instance tells that is asked so (given how many pages there are, too), and the
// functions that ran.
function traced(asked) {
  const wasm = new WebAssembly.Instance(module).exports;
  wasm.memory.grow(Math.ceil(functions / 0x10000));
  const told = asked((call, text, ...numbers) => {
    if (text !== undefined) {
      const bytes = Buffer.from(text);
      const at = wasm.input(bytes.length);
      new Uint8Array(wasm.memory.buffer, at, bytes.length).set(bytes);
    }
    const length = wasm[call](...numbers);
    return Buffer.from(wasm.memory.buffer, wasm.output(), length).toString('utf8');
  }, wasm.pages());
  const marks = new Uint8Array(wasm.memory.buffer, end, functions);
  return { told, ran: [...marks.keys()].filter((n) => marks[n] === 1) };
}

// The values of a parameter other than its default: its words, or the ends of its usual range.
function values({ words, from, to, default: own }) {
  return words.length > 0 ? words.filter((word) => word !== own) : [from, to].filter((end) => end !== null);
}

// The lines of `open`: as declared, then one parameter after another.
function settings({ flags }) {
  const lines = ['', 'no such parameter=1'];
  for (const flag of flags) {
    for (const value of values(flag)) lines.push(`${flag.name}=${value}`);
    if (flag.kind === 'effect') lines.push(`${flag.name}=`, `${flag.name}=${flag.usual}`);
    else lines.push(`${flag.name}=x`);
  }
  return lines;
}

// The command lines of `run` that readers are given, those that draw or the others.
const locked = new URL('tests/snapshots/commands/', root);
const given = readdirSync(locked).map((name) => readFileSync(new URL(name, locked), 'utf8')).join('\n')
  .split('\n').map((line) => line.trim().split(/\s+/).slice(2));
const draws = (words) => words.includes('--svg') || words.includes('--csv');
const givenFor = (stem, drawn) => given.filter(([of, ...words]) => of === stem && draws(words) === drawn).map((words) => words.slice(1));

// The others: what every example knows; then, one by one, effects and words, and what is refused.
function others({ flags }) {
  const lines = [['--help'], ['--csv', 'motion.csv'], ['--check', 'x=1'], ['--check', 'x'], ['--nothing', '1']];
  for (const { name, kind, words } of flags) {
    if (kind === 'effect') lines.push(['--with', name], ['--without', name], ['--with', `${name}=-1e9`]);
    else lines.push(...words.map((word) => [`--${name}`, word]), [`--${name}`, 'x'], [`--${name}`, '-1e9']);
  }
  return lines;
}

// Answers to all of a page's questions, right and wrong in every way.
function answers(claims) {
  const ways = [({ printed }) => printed, ({ value, unit }) => `${value} ${unit === '-' ? '' : unit}`,
    ({ value }) => 2 * Math.PI * value, ({ value }) => 1.001 * value, () => '2/3 pi + sqrt 2', () => '1,5'];
  return claims.flatMap((claim, n) => ['--check', `${claim.key}=${ways[n % ways.length](claim)}`]);
}

const { told: each } = traced((ask, count) => ({
  palette: JSON.parse(ask('palette')),
  declared: Array.from({ length: count }, (_, n) => JSON.parse(ask('declared', undefined, n))),
}));
const pages = each.declared.map((declared, n) => {
  const motion = traced((ask) => {
    for (const lines of declared.moves ? settings(declared) : []) {
      const { span, stills } = JSON.parse(ask('open', lines, n));
      if (span === undefined) continue;
      const [a, b] = span;
      for (const t of [a, ...stills, 0.3 * a + 0.7 * b, b, 2 * b - a]) ask('frame', undefined, t, 0, 0);
      ask('frame', undefined, b, 0.1, 0.2);
      ask('failure');
      ask('alt');
    }
  });
  const run = (ask, lines) => lines.map((words) => JSON.parse(ask('run', words.join('\0'), n)));
  const told = traced((ask) => {
    const [{ stdout }] = run(ask, [['--json'], [], ...givenFor(declared.stem, false)]);
    run(ask, [answers(JSON.parse(stdout).claims)]);
    const { methods } = JSON.parse(ask('lab', '', n));
    for (const { name, setting } of methods) ask('lab', `method=${name}\nsetting=${setting === 'tolerance' ? 1e-6 : 100}`, n);
    if (methods.length > 0) ask('lab', 'solve=1e-6', n);
  });
  const full = traced((ask) => {
    ask('declared', undefined, n);
    ask('report', undefined, n);
    ask('figures', '', n);
    run(ask, [...others(declared), ...givenFor(declared.stem, true)]);
  });
  process.stderr.write(`${declared.stem}: ${motion.ran.length} functions move, ${told.ran.length} tell, ${full.ran.length} draw\n`);
  return { declared, motion: motion.ran, told: told.ran, full: full.ran };
});
process.stdout.write(JSON.stringify({ palette: each.palette, pages }));
