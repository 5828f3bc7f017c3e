//! `cargo modules`: compiles every page into one module for WebAssembly and cuts it into packs, so
//! that a page loads no more than it needs; writes them and their list to `book/modules`.
//!
//! ```text
//! crate `live` ── linked, its relocations kept ── slim ── traced in node ── cut ── compressed
//! ```

mod build;
mod cut;
mod linked;
mod pack;
mod slim;

use cut::Need;
use linked::Linked;
use serde_json::{Map, Value, json};
use slim::{Node, Slim};
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

/// Files that a list has at most.
const MOST_FILES: usize = 8;
/// What asking for one more file is worth, in bytes before they are compressed.
const A_FILE: usize = 4000;
/// The lists of a page, each within the next: what moves; what tells; whatever may be called.
const LISTS: [&str; 3] = ["motion", "full", "rest"];

type Outcome<T> = Result<T, Box<dyn Error>>;

/// The functions that ran, as the trace tells them.
fn functions(traced: &Value) -> BTreeSet<Node> {
    let numbers = traced
        .as_array()
        .into_iter()
        .flatten()
        .filter_map(Value::as_u64);
    numbers.map(|n| Node::Function(n as usize)).collect()
}

/// What each list of each page must hold, page by page.
fn needs(module: &Slim, traced: &[Value]) -> Outcome<Vec<Need>> {
    let entries = cut::entries(module, traced.len())?;
    let mut needs = Vec::new();
    for (page, traced) in traced.iter().enumerate() {
        let rest = cut::reached(module, &entries, page);
        let motion = cut::with_data(module, functions(&traced["motion"]), &rest);
        let told = functions(&traced["full"]).union(&motion).copied().collect();
        needs.extend([motion, cut::with_data(module, told, &rest), rest]);
    }
    Ok(needs)
}

/// The names of the packs: a page's own have its stem, others count from the most shared down.
fn named(groups: &mut [cut::Group], stems: &[&str]) -> Vec<String> {
    groups.sort_by_key(|group| {
        (
            std::cmp::Reverse(group.lists.len()),
            group.nodes.first().copied(),
        )
    });
    let mut shared = 0;
    let name = |group: &cut::Group| {
        let pages: BTreeSet<usize> = group.lists.iter().map(|list| list / LISTS.len()).collect();
        match (pages.len(), group.lists.first()) {
            (1, Some(list)) => format!(
                "{}_{}.gz",
                stems[list / LISTS.len()],
                LISTS[list % LISTS.len()]
            ),
            _ => {
                shared += 1;
                format!("shared_{shared:02}.gz")
            }
        }
    };
    groups.iter().map(name).collect()
}

/// The packs by name, and the list of what each page loads.
fn packs(module: &Slim, traced: &Value) -> Outcome<(BTreeMap<String, Vec<u8>>, Value)> {
    let pages = traced["pages"]
        .as_array()
        .ok_or("the trace tells of no pages")?;
    let stems: Vec<&str> = pages
        .iter()
        .filter_map(|page| page["declared"]["stem"].as_str())
        .collect();
    let needs = needs(module, pages)?;
    let mut groups = cut::groups(module, &needs, MOST_FILES, A_FILE);
    let names = named(&mut groups, &stems);
    let mut packs = BTreeMap::new();
    for (group, name) in groups.iter().zip(&names) {
        let everyones = group.lists.len() == needs.len();
        packs.insert(name.clone(), pack::pack(module, &group.nodes, everyones));
    }
    let files = |list: usize| -> Vec<&String> {
        let loaded = groups
            .iter()
            .zip(&names)
            .filter(|(group, _)| group.lists.contains(&list));
        loaded.map(|(_, name)| name).collect()
    };
    let mut listed = Map::new();
    for (n, (stem, page)) in stems.iter().zip(pages).enumerate() {
        let mut entry = json!({ "page": n, "declared": page["declared"] });
        for (which, list) in LISTS.iter().enumerate() {
            entry[list] = json!(files(n * LISTS.len() + which));
        }
        listed.insert((*stem).into(), entry);
    }
    Ok((
        packs,
        json!({ "pages": listed, "palette": traced["palette"] }),
    ))
}

/// Writes what differs and removes what is no more; tells of each.
fn write(packs: &BTreeMap<String, Vec<u8>>, index: &Value, to: &Path) -> Outcome<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(to)? {
        let path = entry?.path();
        let name = path
            .file_name()
            .and_then(|name| name.to_str())
            .unwrap_or_default();
        if name.ends_with(".gz") && !packs.contains_key(name) {
            fs::remove_file(&path)?;
            println!("gone     {name}");
        }
    }
    let (mut same, mut total) = (0, 0);
    for (name, bytes) in packs {
        let file = to.join(name);
        let before = fs::read(&file).unwrap_or_default();
        if pack::is(&before, bytes) {
            same += 1;
            total += before.len();
            continue;
        }
        let after = pack::compressed(bytes)?;
        println!(
            "{} {:7} -> {:7} bytes  {name}",
            if before.is_empty() {
                "new     "
            } else {
                "changed "
            },
            before.len(),
            after.len()
        );
        total += after.len();
        fs::write(&file, after)?;
    }
    fs::write(to.join("index.json"), format!("{index:#}\n"))?;
    println!("{} packs, {total} bytes; {same} as they were", packs.len());
    Ok(())
}

/// What the longest lists weigh.
fn tell(index: &Value, to: &Path) -> Outcome<()> {
    for list in LISTS {
        let mut weights = Vec::new();
        for (stem, page) in index["pages"].as_object().into_iter().flatten() {
            let names: Vec<&str> = page[list]
                .as_array()
                .into_iter()
                .flatten()
                .filter_map(Value::as_str)
                .collect();
            let mut weight = 0;
            for name in &names {
                weight += fs::metadata(to.join(name))?.len();
            }
            weights.push((weight, names.len(), stem.clone()));
        }
        weights.sort();
        if let (Some(least), Some(most)) = (weights.first(), weights.last()) {
            let median = &weights[weights.len() / 2];
            println!(
                "{list}: {} to {} bytes ({}), median {}; at most {} files",
                least.0,
                most.0,
                most.2,
                median.0,
                weights.iter().map(|weight| weight.1).max().unwrap_or(0)
            );
        }
    }
    Ok(())
}

fn run() -> Outcome<()> {
    let root = build::root()?;
    let mut arguments = env::args_os().skip(1);
    let (mut to, mut linked) = (root.join("book/modules"), None);
    while let Some(argument) = arguments.next() {
        let mut value = || {
            arguments
                .next()
                .map(PathBuf::from)
                .ok_or("a path is missing")
        };
        match argument.to_str() {
            Some("--out") => to = value()?,
            Some("--module") => linked = Some(value()?),
            _ => {
                return Err("usage: cargo modules [--out DIRECTORY] [--module LINKED.wasm]".into());
            }
        }
    }
    let linked = match linked {
        Some(module) => module,
        None => build::linked(&root)?,
    };
    let module = Slim::new(&Linked::read(&fs::read(linked)?)?);
    let traced = build::traced(&root, &pack::whole(&module))?;
    let (packs, index) = packs(&module, &traced)?;
    write(&packs, &index, &to)?;
    tell(&index, &to)
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
