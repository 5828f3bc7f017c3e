//! Where node is absent: what `compare.mjs` compares in node, compared in wasmtime.
//!
//! ```text
//! cargo run --release --locked --manifest-path tests/same_bits/runtime/Cargo.toml [-- MODULES]
//! ```
//!
//! Joins the packs of every page as a page does and holds what they tell against what is locked,
//! byte for byte: each report, each figure, and each command that a reader is given. What moves
//! is held against what the longest list draws. Two pages at a time. A damaged pack must be seen.
//!
//! On 2026-11-23, on a busy machine: 1293 answers, none differs, in 323 s of processor (three of
//! the pages: 10.1 s, in node 4.5 s).

mod answers;
mod locked;
mod module;
mod page;

use answers::{Held, moved, told};
use locked::Locked;
use page::{Declared, Modules, inflated};
use std::path::Path;
use std::process::ExitCode;
use std::sync::Mutex;
use std::{env, fs, thread};
use wasmtime::{Error, Result};

/// Whether a changed letter of a page's text is told, and a pack that is cut off does not join.
fn damage_is_seen(modules: &Modules, stem: &str) -> Result<bool> {
    let entry = &modules.pages[stem];
    let about = &entry.declared.about;
    let list = modules.lists(stem).pop();
    let list = list.ok_or_else(|| Error::msg("a page without a list"))?;
    let told = |packs: &[Vec<u8>]| -> Result<String> {
        let declared = modules.joined(packs)?.call("declared", entry.number)?;
        Ok(serde_json::from_slice::<Declared>(&declared)?.about)
    };
    let mut packs = modules.packs(list)?;
    let whole = told(&packs)?;
    for pack in &mut packs {
        let found = pack
            .windows(about.len())
            .position(|text| text == about.as_bytes());
        if let Some(at) = found {
            pack[at] ^= 1;
        }
    }
    let gz = fs::read(modules.directory.join(&list[0]))?;
    let cut = &gz[..gz.len() - 9];
    Ok(whole == *about
        && told(&packs)? != *about
        && inflated(&gz[..]).is_ok()
        && inflated(cut).is_err())
}

/// Whether the list for what moves breaks a report off, and the next one tells it.
fn short_is_helped(modules: &Modules, stem: &str, locked: &Locked) -> Result<bool> {
    let mut page = modules.page(stem, &modules.lists(stem)[..2])?;
    let report = String::from_utf8(page.ask("report", "")?)?;
    Ok(page.broke_off == ["report"] && report.trim_end() == locked.reports[stem].trim_end())
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
    let helped = short_is_helped(&modules, stem, &locked)?;
    let not = |so| if so { "" } else { "not " };
    println!(
        "modules: {} answers compared ({} of {} that are locked, {} of what moves), {} differ {}; \
         {} calls needed a longer list; a damaged pack is {}seen, one that is short is {}helped",
        tells.compared + moves.compared,
        tells.compared,
        locked.count(),
        moves.compared,
        differ.len(),
        differ.join(", "),
        tells.broke_off,
        not(seen),
        not(helped)
    );
    let all = tells.compared == locked.count() && moves.compared > 0;
    Ok(all && differ.is_empty() && seen && helped)
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
