//! Tables of what was measured: `benches/record/NAME.txt`.
//!
//! A record is written by a command that it names, on a machine that it names. It is
//! measured, not locked, so a page shows it as what it is: with a line under it that
//! says on what, with what and when.

use crate::project::Project;
use crate::table;
use crate::text::escape;
use kit::{Parsed, Table, parse};

/// Where the records are, relative to the project's root.
pub const RECORDS: &str = "benches/record";

/// The record `name`.
///
/// # Errors
/// That there is none, and which there are; or why it cannot be read.
pub fn record(project: &Project, name: &str) -> Result<Parsed, String> {
    let file = format!("{RECORDS}/{name}.txt");
    if !project.path(&file).is_file() {
        let known = project.names(RECORDS, ".txt").join(", ");
        return Err(format!("there is no {file}; recorded are: {known}"));
    }
    parse(&project.read(&file)?).map_err(|e| format!("{file}: {e}"))
}

/// The record and the table in it that a page means by `NAME:SECTION`. The strips have a
/// record for each stem, so `strips:STEM` is the table `strip` of `strips/STEM`.
fn named<'n>(name: &str, section: &'n str) -> (String, &'n str) {
    match name {
        "strips" => (format!("strips/{section}"), "strip"),
        name => (name.to_owned(), section),
    }
}

/// A table of a record, and the line under it.
///
/// # Errors
/// What is missing, and what there is instead.
pub fn of(project: &Project, name: &str, section: &str) -> Result<(Table, String), String> {
    let (name, section) = named(name, section);
    let record = record(project, &name)?;
    let Some(found) = record.table(&format!("table {section}")) else {
        let headings = record.tables.iter().map(Table::heading);
        let known: Vec<&str> = headings.map(|h| h.trim_start_matches("table ")).collect();
        return Err(format!(
            "{RECORDS}/{name}.txt has no table '{section}'; it has: {}",
            known.join(", ")
        ));
    };
    let note = match conditions(&record) {
        Some(conditions) if record.description.contains("counted") => {
            format!("Counted {conditions}; not locked.")
        }
        Some(conditions) if record.description.contains("the least of") => {
            format!("Least times measured {conditions}; not locked.")
        }
        Some(conditions) => format!("Medians measured {conditions}; not locked."),
        None if record.description.contains("deterministic") => {
            "Computed, not timed: the same on every machine.".to_owned()
        }
        None => Err(format!(
            "{RECORDS}/{name}.txt does not say on what it was measured: it needs a table \
             'conditions' with processor and compiler, or to be deterministic"
        ))?,
    };
    Ok((found.clone(), note))
}

/// A table of a record as HTML.
///
/// # Errors
/// As [`of`].
pub fn html(project: &Project, name: &str, section: &str) -> Result<String, String> {
    let (found, note) = of(project, name, section)?;
    Ok(format!(
        "<div class=\"scroll\">{}</div><p class=\"measured\">{}</p>",
        table::html(&found),
        escape(&note)
    ))
}

/// On what, with what and, if it says so, when a record was made: `on Abacus 2, rustc 1.92.0`.
pub fn conditions(record: &Parsed) -> Option<String> {
    let conditions = record.table("table conditions")?;
    let value = |name: &str| {
        let row = conditions.rows().iter().find(|row| row[0] == name)?;
        Some(row.get(1)?.as_str())
    };
    let date = value("date").map(|date| format!(", {date}"));
    Some(format!("on {}, {}{}", value("processor")?, value("compiler")?, date.unwrap_or_default()))
}
