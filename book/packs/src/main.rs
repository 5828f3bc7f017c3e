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

use cut::{List, Need};
use linked::Linked;
use serde_json::{Map, Value, json};
use slim::{Node, Slim};
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

/// The lists of a page and their weights: what moves; what tells in words; what draws besides;
/// whatever may be called.
const LISTS: [(&str, usize); 4] = [("motion", 4), ("told", 6), ("full", 1), ("rest", 1)];

type Outcome<T> = Result<T, Box<dyn Error>>;

/// The functions that ran, as the trace tells them.
fn functions(traced: &Value) -> Need {
    let numbers = traced.as_array().into_iter().flatten().filter_map(Value::as_u64);
    numbers.map(|n| Node::Function(n as usize)).collect()
}

/// What the lists of each page must hold, page by page.
fn lists(module: &Slim, traced: &[Value]) -> Outcome<Vec<List>> {
    let entries = cut::entries(module, traced.len())?;
    let mut lists = Vec::new();
    for (page, traced) in traced.iter().enumerate() {
        let rest = cut::reached(module, &entries, page);
        let [moves, tells, draws] = ["motion", "told", "full"].map(|list| functions(&traced[list]));
        let draws = draws.union(&tells).copied().collect();
        let needs = [
            cut::with_data(module, moves, &rest),
            cut::with_data(module, tells, &rest),
            cut::with_data(module, draws, &rest),
            rest,
        ];
        lists.extend(LISTS.iter().zip(needs).map(|((_, weight), need)| List {
            page,
            weight: *weight,
            need,
        }));
    }
    Ok(lists)
}

/// The names of the packs: a page's own have its stem, others count from the most shared down.
fn named(groups: &mut [cut::Group], stems: &[&str]) -> Vec<String> {
    groups
        .sort_by_key(|group| (std::cmp::Reverse(group.lists.len()), group.nodes.first().copied()));
    let mut shared = 0;
    let name = |group: &cut::Group| {
        let pages: BTreeSet<usize> = group.lists.iter().map(|list| list / LISTS.len()).collect();
        match (pages.len(), group.lists.first()) {
            (1, Some(list)) => {
                let lists = group.lists.iter().map(|list| LISTS[list % LISTS.len()].0);
                let lists = lists.collect::<Vec<_>>().join("_");
                format!("{}_{lists}.gz", stems[list / LISTS.len()])
            }
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
    let pages = traced["pages"].as_array().ok_or("the trace tells of no pages")?;
    let stems: Vec<&str> =
        pages.iter().filter_map(|page| page["declared"]["stem"].as_str()).collect();
    let lists = lists(module, pages)?;
    let mut groups = cut::groups(module, &lists);
    let names = named(&mut groups, &stems);
    let mut packs = BTreeMap::new();
    for (group, name) in groups.iter().zip(&names) {
        let everyones = group.lists.len() == lists.len();
        packs.insert(name.clone(), pack::pack(module, &group.nodes, everyones));
    }
    let files = |list: usize| -> Vec<&String> {
        let loaded = groups.iter().zip(&names);
        let loaded = loaded.filter(|(group, _)| group.lists.contains(&list));
        loaded.map(|(_, name)| name).collect()
    };
    let mut listed = Map::new();
    for (n, (stem, page)) in stems.iter().zip(pages).enumerate() {
        let mut entry = json!({ "page": n, "declared": page["declared"] });
        for (which, (list, _)) in LISTS.iter().enumerate() {
            entry[list] = json!(files(n * LISTS.len() + which));
        }
        listed.insert((*stem).into(), entry);
    }
    Ok((packs, json!({ "pages": listed, "palette": traced["palette"] })))
}

/// Writes what differs and removes what is no more; tells of each.
fn write(packs: &BTreeMap<String, Vec<u8>>, index: &Value, to: &Path) -> Outcome<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(to)? {
        let path = entry?.path();
        let name = path.file_name().and_then(|name| name.to_str());
        let name = name.unwrap_or_default();
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
        println!("{:7} -> {:7} bytes  {name}", before.len(), after.len());
        total += after.len();
        fs::write(&file, after)?;
    }
    fs::write(to.join("index.json"), format!("{index:#}\n"))?;
    println!("{} packs, {total} bytes; {same} as they were", packs.len());
    Ok(())
}

/// What the longest lists weigh.
fn tell(index: &Value, to: &Path) -> Outcome<()> {
    for (list, _) in LISTS {
        let mut weights = Vec::new();
        for (stem, page) in index["pages"].as_object().into_iter().flatten() {
            let names: Vec<&str> =
                page[list].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
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

/// The sources of which the packs in a directory were made.
fn made_of(modules: &Path) -> Option<String> {
    let index = fs::read(modules.join("index.json")).ok()?;
    let index: Value = serde_json::from_slice(&index).ok()?;
    Some(index["sources"].as_str()?.to_owned())
}

const USAGE: &str = "usage: cargo modules [--out DIRECTORY] [--module LINKED.wasm]
  --out     where the packs go; book/modules if it is not given
  --module  a module that is linked already";

fn run() -> Outcome<()> {
    let root = build::root()?;
    let committed = root.join("book/modules");
    let mut arguments = env::args_os().skip(1);
    let (mut to, mut linked) = (committed.clone(), None);
    while let Some(argument) = arguments.next() {
        let mut value = || arguments.next().map(PathBuf::from).ok_or(USAGE);
        match argument.to_str() {
            Some("--out") => to = value()?,
            Some("--module") => linked = Some(value()?),
            _ => return Err(USAGE.into()),
        }
    }
    // Elsewhere packs are made only if neither they nor the committed ones are of these sources.
    let sources = build::sources(&root)?;
    if to != committed {
        let current = |modules: &Path| made_of(modules).as_ref() == Some(&sources);
        if current(&committed) {
            return match to.join("index.json") {
                old if old.is_file() => Ok(fs::remove_file(old)?),
                _ => Ok(()),
            };
        }
        if current(&to) {
            return Ok(());
        }
    }
    let linked = linked.map_or_else(|| build::linked(&root), Ok)?;
    let module = Slim::new(&Linked::read(&fs::read(linked)?)?)?;
    let traced = build::traced(&root, &pack::whole(&module))?;
    let (packs, mut index) = packs(&module, &traced)?;
    index["sources"] = sources.into();
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
