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
    let items: Vec<&str> = text.lines().filter(|line| line.starts_with("- **E")).collect();
    let mut faults = Vec::new();
    let mut seen = BTreeSet::new();
    for item in &items {
        let id = &item[4..7];
        if !seen.insert(id) {
            faults.push(format!("{id} stands twice"));
        }
        let kinds = ["error.", "statement.", "wording.", "remark.", "lost in print."];
        if !kinds.iter().any(|kind| item[9..].starts_with(&format!(", {kind}"))) {
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
    faults
        .extend(all.filter(|id| !seen.contains(id.as_str())).map(|id| format!("{id} is missing")));
    faults
}

/// The names in backticks in the column of the code.
fn identifiers(text: &str) -> BTreeSet<&str> {
    let rows = text.lines().filter(|line| line.starts_with("| "));
    let cells = rows.filter_map(|row| row.rsplit(" | ").nth(1));
    cells.flat_map(|cell| cell.split('`').skip(1).step_by(2)).collect()
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
        ("- **E07**, error.", "- **E07**.", "E07 does not say what it is"),
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
    let unknown: Vec<_> = names.iter().filter(|name| !has_word(&library, name)).collect();
    assert!(unknown.is_empty(), "the library has no {unknown:?}");
    assert!(names.len() > 20, "{names:?}");
    // The damaged twin.
    assert!(!has_word(&library, "angular_velocities_of_all"));
    assert!(!has_word("angular_velocity", "velocity") && has_word("a.velocity()", "velocity"));
}

/// What is wrong with what an exercise says of itself, in the page and in the Rust of its example.
pub fn wrong_with_exercise(page: &str, program: &str) -> Option<&'static str> {
    let said: Vec<&str> = page.lines().filter(|line| line.starts_with("{{exercise ")).collect();
    let &[said] = said.as_slice() else {
        return Some("write once: {{exercise LEVEL | SOLVED | EVENTS | TEACHES}}");
    };
    let none = said.split('|').nth(2).is_some_and(|events| events.trim() == "none");
    // An event is located by name, or as an event of an integrator or of a contact.
    let located = ["Event::", ".event(", ".events()", "located event"];
    match (none, located.iter().any(|word| program.contains(word))) {
        (true, true) => Some("its program locates an event, which the page does not name"),
        (false, false) => Some("its program locates none of the events that the page names"),
        _ => None,
    }
}

/// Holds every exercise to its line, and the table to all of them.
pub fn check_exercises(root: &Path) {
    let read = |path: &Path| fs::read_to_string(path).expect("the file can be read");
    let table = read(&root.join("book/src/exercises.md"));
    let (mut seen, mut with_events) = (0, 0);
    for entry in fs::read_dir(root.join("book/src")).expect("pages").flatten() {
        let name = entry.file_name().into_string().expect("a name");
        let Some(stem) = name.strip_suffix(".md") else {
            continue;
        };
        let group =
            ["ch15_ex", "ch16_ex", "further_"].into_iter().find(|group| stem.starts_with(group));
        let Some(group) = group else { continue };
        let directory = fs::read_dir(root.join("examples").join(stem)).into_iter().flatten();
        let mut program = read(&root.join(format!("examples/{stem}.rs")));
        program.extend(directory.flatten().map(|file| read(&file.path())));
        let page = read(&entry.path());
        assert_eq!(wrong_with_exercise(&page, &program), None, "{name}");
        // The line has its twins: no line, two lines, events where there are none, none where there are.
        let line = page.lines().find(|line| line.starts_with("{{exercise ")).expect("it is there");
        let events = line.split('|').nth(2).expect("a field").trim();
        with_events += usize::from(events != "none");
        let other = if events == "none" { "it lands" } else { "none" };
        for damaged in [
            page.replace(line, ""),
            page.replace(line, &format!("{line}\n{line}")),
            page.replace(line, &line.replace(&format!("| {events} |"), &format!("| {other} |"))),
        ] {
            assert!(wrong_with_exercise(&damaged, &program).is_some(), "{name}");
        }
        assert!(
            table.contains(&format!("\n{{{{exercises {group}}}}}\n")),
            "{group} is in no table"
        );
        seen += 1;
    }
    assert!(seen >= 13 && with_events >= 10, "{seen} exercises, {with_events} with events");
}
