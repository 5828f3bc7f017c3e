//! Finds the examples in their directory: a new example is a new file.
//!
//! `PAGES=STEM,STEM` in the environment leaves out all others: for one who writes a page.

use std::path::{Path, PathBuf};
use std::{env, fs};

/// The stems of the Rust files in `directory`, sorted.
fn stems(directory: &Path) -> Vec<String> {
    println!("cargo::rerun-if-changed={}", directory.display());
    let files = fs::read_dir(directory).expect("the directory can be read");
    let paths = files.map(|file| file.expect("an entry").path());
    let rust = paths.filter(|path| path.extension().is_some_and(|e| e == "rs"));
    let mut stems: Vec<String> =
        rust.filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned())).collect();
    stems.sort();
    stems
}

fn main() {
    let here = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("set by cargo"));
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("set by cargo"));
    println!("cargo::rerun-if-env-changed=PAGES");
    println!("cargo::rustc-check-cfg=cfg(only_checked)");
    let only = env::var("PAGES").unwrap_or_default();
    let wanted = |stem: &String| only.is_empty() || only.split(',').any(|page| page == stem);
    let examples = here.join("../../examples");
    let (pages, others): (Vec<_>, Vec<_>) = stems(&examples).into_iter().partition(wanted);
    let module = |stem: &String| {
        let file = examples.join(format!("{stem}.rs"));
        format!("#[path = {file:?}]\npub mod {stem};\n")
    };
    let modules: String = pages.iter().map(module).collect();
    let list: String = pages.iter().map(|stem| format!("&{stem}::EXAMPLE, ")).collect();
    let library = format!(
        "{modules}\n/// Every example, in the order of the stems.\npub const ALL: &[&dyn Page] = &[{list}];\n\
         /// What moves of each, in the same order.\npub const MOVING: &[&dyn Moves] = &[{list}];\n\
         /// Whether none was left out.\npub const WHOLE: bool = {};\n",
        others.is_empty()
    );
    fs::write(out.join("examples.rs"), library).expect("the output can be written");
}
