//! The pages that no example stands behind say only what is so: the errata name the tests
//! that prove them, the notation names what the library calls things.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The errata of the notes, E01 to E44.
const ERRATA: usize = 44;

/// What is wrong with the list of errata: a number twice or missing, a proof that is no test of
/// that number, a page that does not exist.
pub fn wrong_with_errata(text: &str) -> Vec<String> {
    let items: Vec<&str> = text
        .lines()
        .filter(|line| line.starts_with("- **E"))
        .collect();
    let mut faults = Vec::new();
    let mut seen = BTreeSet::new();
    for item in &items {
        let id = &item[4..7];
        if !seen.insert(id) {
            faults.push(format!("{id} stands twice"));
        }
        let kinds = [
            "error.",
            "statement.",
            "wording.",
            "remark.",
            "lost in print.",
        ];
        if !kinds
            .iter()
            .any(|kind| item[9..].starts_with(&format!(", {kind}")))
        {
            faults.push(format!("{id} does not say what it is"));
        }
        let proof = format!("::{}_", id.to_lowercase());
        if !item.contains(".md)") {
            faults.push(format!("{id} leads to no page"));
        } else if !item.contains(&proof) {
            faults.push(format!("{id} is proved by no test of its number"));
        }
    }
    let all = (1..=ERRATA).map(|n| format!("E{n:02}"));
    faults.extend(
        all.filter(|id| !seen.contains(id.as_str()))
            .map(|id| format!("{id} is missing")),
    );
    faults
}

/// The names in backticks in the column of the code.
fn identifiers(text: &str) -> BTreeSet<&str> {
    let rows = text.lines().filter(|line| line.starts_with("| "));
    let cells = rows.filter_map(|row| row.split(" | ").nth(4));
    cells
        .flat_map(|cell| cell.split('`').skip(1).step_by(2))
        .collect()
}

fn has_word(text: &str, word: &str) -> bool {
    let part = |c: char| c.is_alphanumeric() || c == '_';
    text.match_indices(word).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let after = text[at + word.len()..].chars().next();
        !before.is_some_and(part) && !after.is_some_and(part)
    })
}

fn sources(directory: &Path, text: &mut String) {
    for entry in fs::read_dir(directory).expect("readable") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            sources(&path, text);
        } else {
            *text += &fs::read_to_string(&path).expect("readable");
        }
    }
}

pub fn check_errata(root: &Path) {
    let text = fs::read_to_string(root.join("book/src/errata.md")).expect("the errata");
    let faults = wrong_with_errata(&text);
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    // The damaged twins.
    for (from, to, fault) in [
        ("- **E07**", "- **E06**", "E06 stands twice"),
        (
            "- **E07**, error.",
            "- **E07**.",
            "E07 does not say what it is",
        ),
        ("::e24_", "::e25_", "E24 is proved by no test of its number"),
        ("- **E44**", "- E44", "E44 is missing"),
    ] {
        assert!(text.contains(from), "{from}");
        let faults = wrong_with_errata(&text.replacen(from, to, 1));
        assert!(faults.iter().any(|f| f == fault), "{fault}: {faults:?}");
    }
}

pub fn check_notation(root: &Path) {
    let text = fs::read_to_string(root.join("book/src/notation.md")).expect("the notation");
    let mut library = String::new();
    sources(&root.join("src"), &mut library);
    let names = identifiers(&text);
    let unknown: Vec<_> = names
        .iter()
        .filter(|name| !has_word(&library, name))
        .collect();
    assert!(unknown.is_empty(), "the library has no {unknown:?}");
    assert!(names.len() > 20, "{names:?}");
    // The damaged twin.
    assert!(!has_word(&library, "angular_velocities_of_all"));
    assert!(!has_word("angular_velocity", "velocity") && has_word("a.velocity()", "velocity"));
}
