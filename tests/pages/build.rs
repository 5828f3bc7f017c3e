//! Finds the tests of the pages in their directory: a new page's test is a new file.
//!
//! `PAGES=STEM,STEM` in the environment leaves out those of all other pages.

use std::path::PathBuf;
use std::{env, fs};

fn main() {
    let here = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").expect("set by cargo"));
    let out = PathBuf::from(env::var_os("OUT_DIR").expect("set by cargo"));
    println!("cargo::rerun-if-env-changed=PAGES");
    println!("cargo::rustc-check-cfg=cfg(only_checked)");
    println!("cargo::rerun-if-changed={}", here.display());
    let only = env::var("PAGES").unwrap_or_default();
    // A test that is named for no example belongs to all pages.
    let of_a_page = |stem: &str| here.join(format!("../../examples/{stem}.rs")).exists();
    let wanted = |stem: &String| {
        only.is_empty() || only.split(',').any(|page| page == stem) || !of_a_page(stem)
    };
    let files = fs::read_dir(&here).expect("the directory can be read");
    let paths = files.map(|file| file.expect("an entry").path());
    let rust = paths.filter(|path| path.extension().is_some_and(|e| e == "rs"));
    let mut stems: Vec<String> = rust
        .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
        .filter(|stem| !["build", "tests"].contains(&stem.as_str()))
        .filter(wanted)
        .collect();
    stems.sort();
    let module = |stem: &String| {
        let file = here.join(format!("{stem}.rs"));
        format!("#[path = {file:?}]\nmod {stem};\n")
    };
    let modules: String = stems.iter().map(module).collect();
    fs::write(out.join("tests.rs"), modules).expect("the output can be written");
}
