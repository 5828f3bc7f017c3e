//! The README's tables of races, made of their records, `benches/record/peers.txt` and, of
//! motions without a closed form, `benches/record/peers_open.txt`.
//!
//! The races are run by a crate of their own, `benches/peers`, which compiles the other
//! crates; that the README shows the record is checked here, where nothing else is needed.

use kit::Parsed;
use std::path::PathBuf;

/// The record of the races, relative to the project's root.
pub const RECORD: &str = "benches/record/peers.txt";

/// The record of the races of motions without a closed form.
pub const OPEN_RECORD: &str = "benches/record/peers_open.txt";

/// A path in the project.
pub fn path(relative: &str) -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/..")).join(relative)
}

/// The errors whose lines the README shows.
const SHOWN: [&str; 2] = ["1e-6", "1e-9"];

/// What the conditions of a record name beside the peers and their versions.
const NO_PEERS: [&str; 4] = ["processor", "compiler", "date", "rounds"];

fn rows<'r>(record: &'r Parsed, heading: &str) -> Result<&'r [Vec<String>], String> {
    let table = record.table(heading).ok_or(format!("no {heading}"))?;
    Ok(table.rows())
}

/// The README's tables, from the records.
///
/// # Errors
/// A record without the tables that it takes.
pub fn tables(closed: &Parsed, open: &Parsed) -> Result<String, String> {
    let head = [
        "problem",
        "error",
        "fastest peer",
        "ms",
        "our stepping",
        "ms",
        "times faster",
    ];
    let exact = ["closed form, ms", "times faster"];
    let first = of_record(closed, &[&head[..], &exact].concat())?;
    let second = of_record(open, &head)?;
    Ok(format!(
        "{first}\nMotions without a closed form:\n\n{second}"
    ))
}

/// The ratios of a record under this head, what was missed, and on what it was measured.
fn of_record(record: &Parsed, head: &[&str]) -> Result<String, String> {
    let mut text = format!("| {} |\n|{}\n", head.join(" | "), "---|".repeat(head.len()));
    let dash = |cell: &String| match cell.as_str() {
        "-" => "–".to_owned(),
        cell => cell.to_owned(),
    };
    for row in rows(record, "table ratios")? {
        if SHOWN.contains(&row[1].as_str()) {
            let title = row[0].replace('_', " ");
            let cells: Vec<String> = row[1..head.len()].iter().map(dash).collect();
            text += &format!("| {title} | {} |\n", cells.join(" | "));
        }
    }
    let missed: Vec<String> = rows(record, "table targets")?
        .iter()
        .filter(|row| row[3] == "missed")
        .map(|row| format!("- {}: {} where {} was wanted\n", row[0], row[2], row[1]))
        .collect();
    text += &match missed.is_empty() {
        true => "\nOf what we set out to reach, all was reached.\n".into(),
        false => format!(
            "\nWhat we set out to reach and did not, judged before rounding:\n\n{}",
            missed.concat()
        ),
    };
    let conditions = rows(record, "table conditions")?;
    let value = |name: &str| {
        let row = conditions.iter().find(|row| row[0] == name);
        row.map_or("?", |row| row[1].as_str())
    };
    let peers: Vec<String> = (conditions.iter())
        .filter(|row| !NO_PEERS.contains(&row[0].as_str()))
        .map(|row| row.join(" "))
        .collect();
    text += &format!(
        "\nMedians on {}, {}, {}; {}.\n",
        value("processor"),
        value("compiler"),
        value("date"),
        peers.join(", ")
    );
    Ok(text)
}

/// The lines between which the tables stand.
pub const MARKS: [&str; 2] = ["<!-- races: from the record -->", "<!-- /races -->"];

/// `text` with what stands between the [`MARKS`] replaced.
///
/// # Errors
/// A text without the marks.
pub fn with_tables(text: &str, tables: &str) -> Result<String, String> {
    let [open, close] = MARKS;
    let (before, rest) = text.split_once(open).ok_or(format!("no {open}"))?;
    let (_, after) = rest.split_once(close).ok_or(format!("no {close}"))?;
    Ok(format!("{before}{open}\n\n{tables}\n{close}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use kit::parse;
    use std::fs;

    #[test]
    fn the_readme_shows_the_record() {
        let text = fs::read_to_string(path("README.md")).expect("there is a README");
        let [closed, open] = [RECORD, OPEN_RECORD].map(|file| {
            let record = fs::read_to_string(path(file)).expect("there is a record");
            parse(&record).expect("a record is a report")
        });
        let tables = tables(&closed, &open).expect("their tables");
        assert!(tables.lines().count() > 10);
        assert!(
            with_tables(&text, &tables) == Ok(text.clone()),
            "the README shows another record than {RECORD}"
        );
        // The damaged twin: a digit changed by hand.
        let damaged = text.replacen("| 1e-9 |", "| 1e-8 |", 1);
        assert!(damaged != text && with_tables(&damaged, &tables) != Ok(damaged.clone()));
    }
}
