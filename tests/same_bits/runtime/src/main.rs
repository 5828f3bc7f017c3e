//! Where node is absent: what `compare.mjs` compares in node, compared in wasmtime.
//!
//! ```text
//! cargo run --release --locked --manifest-path tests/same_bits/runtime/Cargo.toml [-- MODULES]
//! ```
//!
//! Holds what every page tells against what is locked, byte for byte: each report, each figure, and
//! each command that a reader is given. What moves must open and be drawn. Two pages at a time. A
//! damaged module must be seen.

mod answers;
mod locked;
mod page;

use answers::{Held, moved, told};
use locked::Locked;
use page::{Declared, Entry, Modules, inflated};
use std::path::Path;
use std::process::ExitCode;
use std::sync::Mutex;
use std::{env, fs, thread};
use wasmtime::{Error, Result};

/// Whether a changed letter of a page's text is told, and a module that is cut off is refused.
fn damage_is_seen(modules: &Modules, stem: &str) -> Result<bool> {
    let Entry { declared: Declared { about, .. }, module, number } = &modules.pages[stem];
    let told = |wasm: &[u8]| -> Result<String> {
        let declared = modules.of(wasm, *number)?.ask("declared", "")?;
        Ok(serde_json::from_slice::<Declared>(&declared)?.about)
    };
    let gz = fs::read(modules.directory.join(module))?;
    let mut wasm = inflated(&gz[..])?;
    let whole = told(&wasm)?;
    let found = wasm.windows(about.len()).position(|text| text == about.as_bytes());
    let at = found.ok_or_else(|| Error::msg("a page whose text is not in its module"))?;
    wasm[at] ^= 1;
    Ok(whole == *about && told(&wasm)? != *about && inflated(&gz[..gz.len() - 9]).is_err())
}

/// All pages, two at a time: what is locked, and what moves.
fn held(modules: &Modules, locked: &Locked) -> [Held; 2] {
    let waiting = Mutex::new(modules.pages.iter());
    let next = || waiting.lock().expect("no page panics").next();
    let totals = Mutex::new([Held::default(), Held::default()]);
    thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some((stem, entry)) = next() {
                    let tells = told(modules, stem, locked);
                    let moves = entry.declared.moves.then(|| moved(modules, stem));
                    let mut totals = totals.lock().expect("no page panics");
                    totals[0].add(stem, tells);
                    totals[1].add(stem, moves.unwrap_or_else(|| Ok(Held::default())));
                }
            });
        }
    });
    totals.into_inner().expect("no page panics")
}

fn run() -> Result<bool> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    let modules = env::args_os().nth(1).unwrap_or("book/modules".into());
    let modules = Modules::read(&root.join(modules))?;
    let locked = Locked::read(&root.join("tests/snapshots"))?;
    let mut pages = modules.pages.iter();
    let moving = pages.find(|(_, entry)| entry.declared.moves);
    let (stem, _) = moving.ok_or_else(|| Error::msg("no page moves"))?;

    let [tells, moves] = held(&modules, &locked);
    let differ = [tells.differ, moves.differ].concat();
    let seen = damage_is_seen(&modules, stem)?;
    println!(
        "modules: {} answers compared ({} of {} that are locked, {} of what moves), {} differ {}; \
         a damaged module is {}seen",
        tells.compared + moves.compared,
        tells.compared,
        locked.count(),
        moves.compared,
        differ.len(),
        differ.join(", "),
        if seen { "" } else { "not " }
    );
    let all = tells.compared == locked.count() && moves.compared > 0;
    Ok(all && differ.is_empty() && seen)
}

fn main() -> ExitCode {
    match run() {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("{error:?}");
            ExitCode::FAILURE
        }
    }
}
