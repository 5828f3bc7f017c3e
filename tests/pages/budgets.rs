//! How long the sources of a page may be: its example and its test together, in lines. What is
//! wanted stands beside what is allowed; an allowance only ever falls.

use crate::answers::root;
use std::collections::BTreeMap;
use std::path::Path;
use std::{fmt::Write, fs};

/// A kind of page: what its name has in it, the most lines of one page that are allowed, and those
/// that are wanted. A page is of the first kind that fits.
const KINDS: [(&str, usize, usize); 5] = [
    ("effects_", 1200, 800),
    ("further_", 1140, 800),
    ("_ex", 735, 600),
    ("ch1", 1459, 900),
    // The tables of the whole: accuracy, the hard cases, the library.
    ("", 2020, 1800),
];

/// The mean of the exercises, all examples, and all tests of pages: allowed, and wanted.
const MEAN: [usize; 2] = [613, 450];
const EXAMPLES: [usize; 2] = [38_294, 33_000];
const TESTS: [usize; 2] = [10_919, 8_000];

/// The lines of every Rust source below a path, by the stem of the page that it belongs to.
fn lines(path: &Path, stem: Option<&str>, found: &mut BTreeMap<String, usize>) {
    for entry in fs::read_dir(path).expect("readable") {
        let path = entry.expect("an entry").path();
        let name = path.file_stem().and_then(|name| name.to_str()).expect("a name");
        let stem = stem.unwrap_or(name);
        if path.is_dir() {
            lines(&path, Some(stem), found);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            let text = fs::read_to_string(&path).expect("a text");
            *found.entry(stem.to_owned()).or_default() += text.lines().count();
        }
    }
}

#[test]
fn pages_keep_their_budgets() {
    let (mut examples, mut tests) = (BTreeMap::new(), BTreeMap::new());
    lines(&root().join("examples"), None, &mut examples);
    lines(&root().join("tests/pages"), None, &mut tests);
    let page = |(stem, lines): (&String, &usize)| {
        let both = lines + tests.get(stem).copied().unwrap_or(0);
        let kind = KINDS.into_iter().find(|(part, ..)| stem.contains(part));
        (stem.clone(), both, kind.expect("the last fits all"))
    };
    let pages: Vec<_> = examples.iter().map(page).collect();
    let mut table = String::new();
    let mut row = |name: &str, lines: usize, [allowed, wanted]: [usize; 2]| {
        let mark = if lines > allowed { "  TOO LONG" } else { "" };
        let _ = writeln!(table, "{name:32}{lines:8}{allowed:8}{wanted:8}{mark}");
    };
    for (stem, lines, (_, allowed, wanted)) in &pages {
        row(stem, *lines, [*allowed, *wanted]);
    }
    let exercises: Vec<_> = pages.iter().filter(|(_, _, (part, ..))| *part == "_ex").collect();
    let sum: usize = exercises.iter().map(|(_, lines, _)| lines).sum();
    row("an exercise, in the mean", sum / exercises.len(), MEAN);
    row("examples", examples.values().sum(), EXAMPLES);
    row("tests of pages", tests.values().sum(), TESTS);
    println!("{:32}{:>8}{:>8}{:>8}\n{table}", "page", "lines", "allowed", "wanted");
    assert!(pages.len() > 45 && exercises.len() == 17, "{} pages", pages.len());
    assert!(!table.contains("TOO LONG"), "{table}");
}

/// The physics of each exercise, and of the navigator, between the anchors that its page shows, and that the limit is felt.
#[test]
fn the_physics_of_an_exercise_is_read_in_one_sitting() {
    let mut lengths = Vec::new();
    for page in fs::read_dir(root().join("examples")).expect("readable") {
        let physics = page.expect("an entry").path().join("physics.rs");
        let Ok(text) = fs::read_to_string(&physics) else { continue };
        let (_, rest) = text.split_once("ANCHOR: physics").expect("it begins");
        let (shown, _) = rest.split_once("// ANCHOR_END: physics").expect("it ends");
        assert!(shown.lines().count() <= 121, "{}: {}", physics.display(), shown.lines().count() - 1);
        lengths.push(shown.lines().count());
    }
    assert!(lengths.len() == 18 && lengths.iter().any(|lines| *lines > 115), "{lengths:?}");
}
