// node book/live/modules.mjs [PART …]: makes the modules of the pages, one for each part of the book,
// and their index, in book/modules: all, or those that are named. It takes cargo with the target
// wasm32-wasip1, Binaryen's `wasm-opt` and `zopfli`.
//
// node book/live/modules.mjs --out DIRECTORY: only the modules whose sources are not those of the
// committed ones, by cargo alone; the others are copied. If there are none, the directory is removed.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { runInThisContext } from 'node:vm';
import { gzipSync } from 'node:zlib';

/** Which pages a module has: those whose stem matches, and no part before it. The library's page fits throws, too. */
const PARTS = { exercises: /^ch\d+_ex/, chapter_15: /^ch15/, chapter_16: /^ch16/, further: /^(further|library)/, effects: /./ };
/** In which the library is compiled for speed: a throw is fitted in a third of the time, for 11 % more bytes. */
const FAST = ['further'];
const TARGET = 'wasm32-wasip1';
const COMMITTED = 'book/modules';
/** What every module is compiled of, besides its examples. */
const SHARED = ['Cargo.toml', 'Cargo.lock', 'src', 'tests/every_example', 'book/kit', 'book/live', 'book/models'];

const root = fileURLToPath(new URL('../../', import.meta.url));
process.chdir(root);
const partOf = (stem) => Object.keys(PARTS).find((part) => PARTS[part].test(stem));
const examples = readdirSync('examples').sort();
const files = (path) => (statSync(path).isDirectory() ? readdirSync(path).sort().flatMap((name) => files(join(path, name))) : [path]);

/** A number that changes with what the module of a part is made of. */
function sources(part) {
  const own = examples.filter((name) => partOf(name) === part).flatMap((name) => files(join('examples', name)));
  // An example may stand on a file of another.
  const paths = own.flatMap((file) => [...readFileSync(file, 'utf8').matchAll(/#\[path = "([^"]+)"\]/g)]);
  const others = paths.map(([, path]) => join('examples', path)).filter(existsSync);
  const hash = createHash('sha256');
  for (const file of [...SHARED.flatMap(files), ...own, ...others]) hash.update(file).update('\0').update(readFileSync(file));
  return hash.digest('hex').slice(0, 16);
}

function call(program, words, more) {
  const { status, error } = spawnSync(program, words, { stdio: 'inherit', ...more });
  if (status !== 0) throw new Error(`${program}: ${error?.message ?? `ended with ${status}`}`);
}

/** The module of a part, compressed. */
function made(part, small) {
  const target = process.env.CARGO_TARGET_DIR ?? 'target';
  const crates = join(process.env.CARGO_HOME ?? join(homedir(), '.cargo'), 'registry/src');
  const env = {
    ...process.env,
    PAGES: examples.filter((name) => name.endsWith('.rs') && partOf(name) === part).map((name) => name.slice(0, -3)).join(','),
    // The same bytes wherever it is compiled; lanes of two doubles, the same bits as one by one.
    CARGO_ENCODED_RUSTFLAGS: [`--remap-path-prefix=${root.slice(0, -1)}=.`, `--remap-path-prefix=${crates}=crates`, '-Ctarget-feature=+simd128'].join('\x1f'),
  };
  const fast = FAST.includes(part) ? ['--config', 'profile.page.package.rotation-dynamics.opt-level=2'] : [];
  call(process.env.CARGO ?? 'cargo', [...fast, 'build', '--quiet', '--locked', '--profile', 'page', '--package', 'live', '--target', TARGET], { env });
  const [compiled, file] = [join(target, TARGET, 'page/live.wasm'), join(target, `${part}.wasm`)];
  if (!small) return gzipSync(readFileSync(compiled));
  call('wasm-opt', ['-Oz', '--enable-simd', '--enable-bulk-memory', '--enable-sign-ext', '--enable-nontrapping-float-to-int', compiled, '-o', file]);
  call('zopfli', ['--i5', file]);
  return readFileSync(`${file}.gz`);
}

/** What a module says of its pages: `{STEM: {module, page, declared}}`, with what their pictures show, and the inks. */
async function told(gz, module) {
  const ask = runInThisContext(`${readFileSync('book/theme/module.js')};caller`)();
  const { error } = await ask({ gz });
  if (error) throw new Error(error);
  const text = async (call, page) => (await ask({ call, page })).text;
  const pages = {};
  for (let page = 0, stem; (stem = await text('stem', page)) !== undefined; page += 1) {
    pages[stem] = { module, page, declared: { ...JSON.parse(await text('declared', page)), ...JSON.parse(await text('seen', page)) } };
  }
  return { pages, palette: JSON.parse(await text('palette')) };
}

const index = (directory) => {
  const file = `${directory}/index.json`;
  return existsSync(file) ? JSON.parse(readFileSync(file)) : { pages: {}, sources: {} };
};
const words = process.argv.slice(2);
const apart = words[0] === '--out';
const out = apart ? words[1] : COMMITTED;
const unknown = apart ? [] : words.filter((word) => !(word in PARTS));
if (unknown.length > 0) throw new Error(`no such part: ${unknown.join(' ')}; there are ${Object.keys(PARTS).join(' ')}`);

const [committed, before] = [index(COMMITTED), index(out)];
const now = Object.fromEntries(Object.keys(PARTS).map((part) => [part, sources(part)]));
const stale = (part, { sources }) => sources[part] !== now[part];
if (apart && !Object.keys(PARTS).some((part) => stale(part, committed))) {
  rmSync(out, { recursive: true, force: true });
  process.exit(0);
}
mkdirSync(out, { recursive: true });
const after = { pages: {}, sources: {} };
for (const part of Object.keys(PARTS)) {
  const file = `${part}.wasm.gz`;
  const copied = apart && !stale(part, committed);
  if (copied) copyFileSync(`${COMMITTED}/${file}`, `${out}/${file}`);
  if (copied || (apart ? !stale(part, before) : words.length > 0 && !words.includes(part))) {
    const { pages, sources, palette } = copied ? committed : before;
    for (const [stem, page] of Object.entries(pages)) if (page.module === file) after.pages[stem] = page;
    [after.sources[part], after.palette] = [sources[part], palette];
    continue;
  }
  const gz = made(part, !apart);
  writeFileSync(`${out}/${file}`, gz);
  const { pages, palette } = await told(gz, file);
  Object.assign(after.pages, pages);
  [after.sources[part], after.palette] = [now[part], palette];
  console.log(`${file}: ${gz.length} bytes, ${Object.keys(pages).length} pages`);
}
writeFileSync(`${out}/index.json`, `${JSON.stringify(after, null, 1)}\n`);
