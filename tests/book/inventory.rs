//! Everything in the notes that can be computed has a page, a check on it, and, where the
//! notes have a figure, a figure.

use kit::parse;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// A line of `inventory.txt`.
#[derive(Debug, PartialEq)]
struct Row<'a> {
    id: &'a str,
    stem: &'a str,
    check: Option<&'a str>,
    figure: Option<&'a str>,
}

fn rows(text: &str) -> Vec<Row<'_>> {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    let row = |line| {
        let cells: Vec<&str> = str::split(line, " | ").collect();
        let [id, stem, check, figure] = cells[..] else {
            panic!("{line} is no row");
        };
        let some = |cell: &'static str| move |text: &&str| *text != cell;
        Row {
            id,
            stem,
            check: Some(check).filter(some("-")),
            figure: Some(figure).filter(some("-")),
        }
    };
    lines.map(row).collect()
}

/// The file of tests that a page means by this name, as the builder finds it.
fn test_file(root: &Path, file: &str) -> Option<PathBuf> {
    let groups = ["", "pages/", "equations/", "accuracy/", "bodies/", "exact/"];
    let ends = [".rs", "/main.rs", "/mod.rs"];
    let mut candidates = groups
        .iter()
        .flat_map(|group| ends.map(|end| root.join(format!("tests/{group}{file}{end}"))));
    candidates.find(|path| path.is_file())
}

/// What is missing of this row, with the text of its page.
fn missing(root: &Path, row: &Row, page: &str) -> Result<(), String> {
    let Row { id, stem, .. } = row;
    let is_figure = id.starts_with("fig");
    match row.check {
        None if is_figure => {}
        None => return Err(format!("{id} has no check")),
        Some(check) => match check.split_once("::") {
            Some((file, name)) => {
                let text = test_file(root, file).and_then(|path| fs::read_to_string(path).ok());
                let text = text.ok_or(format!("{id}: there is no test file {file}"))?;
                if !text.contains(&format!("fn {name}(")) {
                    return Err(format!("{id}: {file} has no test {name}"));
                }
                if !page.contains(&format!("{{{{test {check}}}}}")) {
                    return Err(format!("{id}: {stem} does not show the test {check}"));
                }
            }
            None => {
                let claim = check.split_once(':').filter(|(of, _)| of == stem);
                let (_, key) = claim.ok_or(format!("{id}: {check} is no claim of {stem}"))?;
                let output = root.join(format!("tests/snapshots/{stem}.snap"));
                let output = fs::read_to_string(output).map_err(|e| format!("{id}: {e}"))?;
                let parsed = parse(&output).map_err(|e| format!("{id}: {e}"))?;
                let claims = parsed.table("claims").ok_or(format!("{id}: no claims"))?;
                if !claims.rows().iter().any(|cells| cells[0] == key) {
                    return Err(format!("{id}: {stem} claims no {key}"));
                }
            }
        },
    }
    match row.figure {
        None if is_figure => Err(format!("{id} has no figure")),
        None => Ok(()),
        Some(name) => {
            let (stem, name) = name.split_once('/').unwrap_or((stem, name));
            let file = format!("tests/snapshots/{stem}/{name}.snap.svg");
            let shown = page.contains(stem) && root.join(file).is_file();
            shown.then_some(()).ok_or(format!("{id}: no figure {name}"))
        }
    }
}

pub fn check(root: &Path) {
    let text = fs::read_to_string(root.join("tests/book/inventory.txt")).expect("the inventory");
    let rows = rows(&text);
    let ids: BTreeSet<&str> = rows.iter().map(|row| row.id).collect();
    assert_eq!((rows.len(), ids.len()), (173, 173), "each id stands once");
    let mut faults = Vec::new();
    for row in &rows {
        match fs::read_to_string(root.join(format!("book/src/{}.md", row.stem))) {
            Ok(page) => faults.extend(missing(root, row, &page).err()),
            Err(_) => faults.push(format!("{} has no page {}", row.id, row.stem)),
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));

    // The damaged twins: what is missing is found.
    let stem = "ch16_2_gyroscope";
    let page = fs::read_to_string(root.join(format!("book/src/{stem}.md"))).expect("the page");
    let said = |check, figure, id| {
        let row = Row { id, stem, check, figure };
        missing(root, &row, &page).expect_err("a fault")
    };
    let bare = said(None, None, "16.2.eq2");
    assert_eq!(bare, "16.2.eq2 has no check");
    assert_eq!(said(None, None, "fig16.2a"), "fig16.2a has no figure");
    for (check, words) in [
        ("equations::eq_16_2_2", "has no test"),
        ("equation::eq_16_2_2_precession_rate", "no test file"),
        ("equations/motions::eq_16_2_sleeping_top_threshold", "does not show"),
        ("ch16_2_gyroscope:steady", "claims no steady"),
        ("ch16_ex6_ladder:t_floor", "no claim of ch16_2_gyroscope"),
    ] {
        let fault = said(Some(check), None, "16.2.eq2");
        assert!(fault.contains(words), "{fault}");
    }
    let fault = said(None, Some("valley"), "fig16.2a");
    assert!(fault.contains("no figure valley"), "{fault}");
}
