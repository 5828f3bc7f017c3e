// node pace.mjs STEM ROUNDS: the least processor time, in seconds, that the report of a page takes in
// its module, of so many, once the engine has compiled what it will.
import { readFileSync } from 'node:fs';
import { runInThisContext } from 'node:vm';

const root = new URL('../../', import.meta.url);
const read = (path) => readFileSync(new URL(path, root));
const [stem, rounds] = process.argv.slice(2);
const index = JSON.parse(read('book/modules/index.json'));
const call = runInThisContext(`${read('book/theme/module.js')};caller`)();
const { page, module } = index.pages[stem];
const gz = read(`book/modules/${module}`);
const report = async () => {
  const began = process.cpuUsage();
  const { error } = await call({ call: 'report', page });
  if (error) throw new Error(error);
  const { user, system } = process.cpuUsage(began);
  return (user + system) / 1e6;
};
await call({ gz });
await report();
await report();
let least = Infinity;
for (let n = 0; n < rounds; n++) least = Math.min(least, await report());
console.log(least);
