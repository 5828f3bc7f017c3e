//! What the lines of an accuracy strip cost in time.
//!
//! Times are measured, not locked, so they are no part of an example's output: they
//! stand in a record of their own, written by `cargo run --release -p benches --bin
//! strips`. A time is shown only beside the very computation that was timed; if
//! anything in the line has changed since, its place stays empty.

use crate::measured;
use crate::project::Project;
use crate::table;
use crate::text::escape;
use rotation_dynamics::report::{Parsed, Table, parse};

/// The record, relative to the project's root.
const RECORD: &str = "benches/record/strips.txt";

/// What a line of the strip and one of the record must share.
const SAME: [&str; 4] = ["method", "requested", "delivered", "work"];

/// The section in which an example states its strip.
pub const SECTION: &str = "accuracy";

/// A strip with its times.
pub struct Timed {
    /// The strip; a line without a time has `-`.
    pub table: Table,
    /// The lines that take the least time of several that deliver the same error.
    least: Vec<usize>,
    /// What the times are, if there are any.
    note: Option<String>,
}

impl Timed {
    /// The strip as HTML, and the line under it.
    pub fn html(&self) -> String {
        let time = self.table.columns().len() - 1;
        let html = table::html_with(&self.table, |row, column| {
            column == time && self.least.contains(&row)
        });
        let note = self.note.as_ref();
        let note = note.map(|note| format!("<p class=\"measured\">{}</p>", escape(note)));
        html + &note.unwrap_or_default()
    }
}

/// The cells of `row` under `names`, if there are such columns.
fn cells<'t>(table: &'t Table, row: &'t [String], names: &[&str]) -> Option<Vec<&'t str>> {
    let cell = |name: &&str| {
        let at = table.columns().iter().position(|column| column == name)?;
        Some(row[at].as_str())
    };
    names.iter().map(cell).collect()
}

/// The strip of an example, whose table is `strip`, with the times of the record.
///
/// # Errors
/// A record that is there and cannot be read.
pub fn of(project: &Project, stem: &str, strip: &Table) -> Result<Timed, String> {
    let record = match project.path(RECORD).is_file() {
        false => None,
        true => Some(parse(&project.read(RECORD)?).map_err(|e| format!("{RECORD}: {e}"))?),
    };
    let measured = record
        .as_ref()
        .and_then(|r| r.table(&format!("table {stem}")));
    let time = |row: &[String]| -> Option<String> {
        let (record, key) = (measured?, cells(strip, row, &SAME)?);
        let line = record
            .rows()
            .iter()
            .find(|line| cells(record, line, &SAME).is_some_and(|same| same == key))?;
        Some(cells(record, line, &["time"])?[0].to_owned())
    };
    let times: Vec<Option<String>> = strip.rows().iter().map(|row| time(row)).collect();

    // The last column of a strip is the place for its times.
    let (_, kept) = strip
        .columns()
        .split_last()
        .ok_or("a strip without columns")?;
    let columns = kept.iter().map(String::as_str).chain(["time"]);
    let mut timed = Table::new(SECTION, columns).map_err(|e| e.to_string())?;
    for (row, time) in strip.rows().iter().zip(&times) {
        let time = time.as_deref().unwrap_or("-");
        let cells = row[..kept.len()].iter().map(String::as_str).chain([time]);
        timed.push(cells).map_err(|e| e.to_string())?;
    }
    let least = least(&timed);
    let note = record
        .filter(|_| times.iter().any(Option::is_some))
        .map(|record| note(&record, stem, !least.is_empty()));
    Ok(Timed {
        table: timed,
        least,
        note,
    })
}

/// The lines with the least time among several that deliver the same error, if the time of
/// each of these is known.
fn least(strip: &Table) -> Vec<usize> {
    let number = |cell: &str| cell.parse::<f64>().ok();
    // Line, requested, time.
    let delivering: Vec<(usize, f64, Option<f64>)> = (0..)
        .zip(strip.rows())
        .filter_map(|(n, row)| {
            let cells = cells(strip, row, &["requested", "delivered", "time"])?;
            let [requested, delivered, time] = [cells[0], cells[1], cells[2]].map(number);
            (delivered? <= requested?).then_some((n, requested?, time))
        })
        .collect();
    let is_least = |&&(line, requested, time): &&(usize, f64, Option<f64>)| {
        let mut rivals = delivering
            .iter()
            .filter(|rival| rival.0 != line && rival.1 == requested)
            .peekable();
        let beats = |rival: Option<f64>| time.zip(rival).is_some_and(|(own, rival)| own <= rival);
        rivals.peek().is_some() && rivals.all(|rival| beats(rival.2))
    };
    let least = delivering.iter().filter(is_least);
    least.map(|line| line.0).collect()
}

fn note(record: &Parsed, stem: &str, marked: bool) -> String {
    let find = |table: &str, key: &str| -> Option<String> {
        let rows = record.table(table)?.rows();
        let row = rows.iter().find(|row| row[0] == key)?;
        row.get(1).cloned()
    };
    let mut note = String::from("Time: in units of one sample of the closed form");
    if let Some(unit) = find("table units", stem) {
        note += &format!(" ({unit}\u{202f}ns)");
    }
    note += ", medians measured";
    if let Some(conditions) = measured::conditions(record) {
        note += &format!(" {conditions}");
    }
    note += "; not locked.";
    if marked {
        note += " Bold: the least time for that error.";
    }
    note
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_is_found_among_those_that_deliver() {
        let columns = ["method", "requested", "delivered", "work", "time"];
        let rows = [
            ["fast and wrong", "1e-9", "1e-3", "1 step", "1"],
            ["slow", "1e-9", "1e-9", "9 steps", "90"],
            ["fast", "1e-9", "5e-10", "2 steps", "20"],
            ["half timed", "1e-3", "5e-4", "2 steps", "-"],
            ["half timed", "1e-3", "5e-4", "1 step", "3"],
            ["alone", "1e-6", "5e-7", "1 step", "10"],
            ["no dial", "-", "5e-7", "1 step", "5"],
        ];
        let mut table = Table::new(SECTION, columns).expect("sound");
        for row in rows {
            table.push(row).expect("sound");
        }
        assert_eq!(least(&table), [2]);
    }
}
