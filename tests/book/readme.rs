//! The readme of the library says what the records say, and what is packed is whole.

use super::{read, root};
use std::fs;

/// The cells of a row.
fn cells(line: &str) -> Vec<&str> {
    line.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).collect()
}

/// The rows of a table of a record, its head first.
fn table<'r>(record: &'r str, name: &str) -> Vec<Vec<&'r str>> {
    let after = record.split(&format!("table {name}\n")).nth(1).expect("a table of this name");
    after.lines().take_while(|line| !line.is_empty()).map(cells).collect()
}

/// The time of a method to 1e-9 rad; `None` where it does not get there.
fn time<'r>(row: &[&'r str], head: &[&str]) -> Option<&'r str> {
    let column = head.iter().position(|cell| *cell == "1e-9").expect("a column for 1e-9");
    row[column].parse::<f64>().is_ok().then_some(row[column])
}

/// The row of the readme for a motion, as the record has it.
fn row(motion: &str, record: &str, name: &str) -> String {
    let crates: Vec<&str> = table(record, "conditions").iter().map(|row| row[0]).collect();
    let races = table(record, name);
    let of = |method: &str| {
        races.iter().find(|row| row[0] == method).and_then(|row| time(row, &races[0]))
    };
    let theirs = races
        .iter()
        .filter(|row| row[0].split_once(' ').is_some_and(|(by, _)| crates.contains(&by)));
    let fastest = theirs
        .filter_map(|row| time(row, &races[0]))
        .min_by(|a, b| a.parse::<f64>().ok().partial_cmp(&b.parse().ok()).expect("numbers"));
    let [closed, gauss] = ["closed form", "Gauss-Legendre 16"].map(of);
    let [closed, gauss, fastest] = [closed, gauss, fastest].map(|time| time.unwrap_or("–"));
    format!("| {motion} | {closed} | {gauss} | {fastest} |")
}

/// What the readme should say and does not.
fn missing(readme: &str) -> Vec<String> {
    let record = |name: &str| read(&root().join(format!("benches/record/{name}.txt")));
    let (closed, open) = (record("peers"), record("peers_open"));
    let mut wanted = vec![
        row("free body", &closed, "free_body"),
        row("heavy top", &closed, "heavy_top"),
        row("satellite", &open, "satellite"),
    ];
    let batch = record("batch");
    let errors = table(&batch, "samples").into_iter().skip(1).map(|row| row[1].parse::<f64>());
    let largest = errors.map(|k| k.expect("a number")).fold(0.0, f64::max);
    wanted.push(format!("within {largest} eps"));
    let needs = read(&root().join("Cargo.toml"));
    let rust = needs.split("rust-version = \"").nth(1).and_then(|rest| rest.split('"').next());
    wanted.push(format!("Rust {} or later", rust.expect("a version")));
    wanted.retain(|line| !readme.contains(line));
    wanted
}

#[test]
fn the_readme_of_the_library_says_what_the_records_say() {
    let readme = read(&root().join("src/README.md"));
    assert_eq!(missing(&readme), [""; 0]);
    // Damaged: each number changed.
    for (from, to) in [
        ("0.0015", "0.0014"),
        ("| 22 |", "| 21 |"),
        ("0.98", "0.97"),
        ("0.9 eps", "0.8 eps"),
        ("1.92", "1.91"),
    ] {
        assert!(readme.contains(from), "{from}");
        assert_eq!(missing(&readme.replace(from, to)).len(), 1, "{from}");
    }
}

#[test]
fn the_licences_in_the_package_are_those_of_the_project() {
    for name in ["LICENSE-MIT", "LICENSE-APACHE"] {
        let packed = fs::read(root().join("src").join(name)).expect("packed");
        assert_eq!(packed, fs::read(root().join(name)).expect("there"), "{name}");
    }
}
