// node compare.mjs MODULE.wasm SNAPSHOTS: holds every text and figure of the module against
// what is locked, byte for byte.
import { readFileSync } from 'node:fs';

const [module, locked] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(readFileSync(module), {});
const wasm = instance.exports;

function told(length) {
  const at = wasm.output();
  return Buffer.from(wasm.memory.buffer, at, length).toString('utf8');
}

// A locked text follows a head between two lines of dashes.
function text(stem) {
  const file = readFileSync(`${locked}/${stem}.snap`, 'utf8');
  return file.slice(file.indexOf('\n---\n', 4) + 5);
}

const differ = [];
let figures = 0;
const count = wasm.examples();
for (let n = 0; n < count; n++) {
  const stem = told(wasm.stem(n));
  const began = Date.now();
  if (told(wasm.report(n)).trimEnd() !== text(stem).trimEnd()) differ.push(stem);
  for (const { name, svg: drawn } of JSON.parse(told(wasm.figures(n))).figures) {
    const svg = readFileSync(`${locked}/figures/${stem}__${name}.snap.svg`, 'utf8');
    if (drawn !== svg) differ.push(`${stem}__${name}`);
    figures += 1;
  }
  process.stderr.write(`${stem}: ${Date.now() - began} ms\n`);
}
console.log(`wasm: ${count} texts and ${figures} figures compared, ${differ.length} differ ${differ.join(' ')}`);
process.exit(count > 0 && figures > count && differ.length === 0 ? 0 : 1);
