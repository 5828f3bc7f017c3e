// node trace.mjs MODULE.js PACK: which functions run when a page moves, and when it tells.
//
// Answers with JSON: `{palette, pages: [{stem, declared, motion, full}]}`, the last two lists
// of numbers of functions. A list needs not be complete: a function that it lacks traps, and the
// page then loads the rest.
import { readFileSync } from 'node:fs';
import { runInThisContext } from 'node:vm';
import { commands, settings } from './asked.mjs';

const [script, pack] = process.argv.slice(2);
const exported = '({ assembled, address, reader })';
const { assembled, address, reader } = runInThisContext(`${readFileSync(script, 'utf8')};${exported}`);

// Each function first notes, in a byte beyond the memory that the module starts with, that it
// ran.
let functions = 0;
const packed = readFileSync(pack);
const beyond = (() => {
  const head = reader(reader(packed).counted());
  head.counted();
  const memory = reader(head.counted()); // how many memories, limits, pages of 64 KiB
  memory.take(2);
  return memory.number() * 0x10000;
})();
function noted(body, n) {
  functions = Math.max(functions, n + 1);
  const code = reader(body);
  code.list(() => code.number() + code.take(1).length); // the locals
  const rest = code.rest();
  const note = [0x41, ...address(beyond + n), 0x41, 1, 0x3a, 0, 0]; // i32.const, i32.const 1, i32.store8
  return Uint8Array.from([...body.subarray(0, body.length - rest.length), ...note, ...rest]);
}
const module = new WebAssembly.Module(assembled([packed], noted));

// A new instance that runs what it is given, and the functions that ran.
function ran(run) {
  const wasm = new WebAssembly.Instance(module).exports;
  wasm.memory.grow(Math.ceil(functions / 0x10000));
  const told = (call, text, ...numbers) => {
    const bytes = Buffer.from(text ?? '');
    if (text !== undefined) Buffer.from(wasm.memory.buffer, wasm.input(bytes.length), bytes.length).set(bytes);
    const length = wasm[call](...numbers);
    return Buffer.from(wasm.memory.buffer, wasm.output(), length).toString('utf8');
  };
  const result = run(told);
  const marks = new Uint8Array(wasm.memory.buffer, beyond, functions);
  return { result, functions: [...marks.keys()].filter((n) => marks[n]) };
}

const { result } = ran((told) => ({
  palette: JSON.parse(told('palette')),
  pages: Array.from({ length: new WebAssembly.Instance(module).exports.pages() }, (_, n) => JSON.parse(told('declared', undefined, n))),
}));
const pages = result.pages.map((declared, n) => {
  const motion = ran((told) => {
    for (const lines of declared.moves ? settings(declared) : []) {
      const opened = JSON.parse(told('open', lines, n));
      if (opened.error) continue;
      const [a, b] = opened.span;
      for (const t of [a, ...opened.stills, 0.3 * a + 0.7 * b, b]) told('frame', undefined, t, 0, 0);
      told('frame', undefined, b, 0.1, 0.2);
      told('frame', undefined, 2 * b - a, 0, 0);
      told('failure');
    }
  });
  const full = ran((told) => {
    for (const line of commands(declared)) {
      told('run', line.join('\0'), n);
    }
    told('figures', '', n);
    told('report', undefined, n);
  });
  process.stderr.write(`${declared.stem}: ${motion.functions.length} functions move, ${full.functions.length} tell\n`);
  return { declared, motion: motion.functions, full: full.functions };
});
process.stdout.write(JSON.stringify({ palette: result.palette, pages }));
