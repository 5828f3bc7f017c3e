//! Error against time, drawn from a record of measurements when the book is built.
//!
//! Times are not locked, so no test compares this drawing; its numbers are those of the
//! table it is made from. Written `{{figure measured:RECORD-TABLE}}`.

use crate::measured;
use crate::project::Project;
use kit::Table;
use kit::draw::{Axis, Method, Panel};

/// The stem under which these drawings go.
pub const STEM: &str = "measured";

/// A line of the drawing: the method, and its times with their errors.
type Line = (String, Vec<(f64, f64)>);

/// The drawing of `RECORD-TABLE`, as SVG.
///
/// # Errors
/// A name without a table, a record or a table that is not there, or a table that has
/// neither the columns of a strip nor errors for columns.
pub fn svg(project: &Project, name: &str) -> Result<String, String> {
    let (record, table) =
        name.split_once('-').ok_or(format!("{STEM}:{name} must be written {STEM}:RECORD-TABLE"))?;
    let (found, _) = measured::of(project, record, table)?;
    drawn(&name.replace('-', "_"), &found)
}

fn drawn(name: &str, table: &Table) -> Result<String, String> {
    let column = |name: &str| table.columns().iter().position(|c| c == name);
    let (lines, unit, races) = match (column("delivered"), column("time")) {
        (Some(error), Some(time)) => {
            let lines = of_strip(table, error, time);
            (lines, "samples of the closed form", false)
        }
        _ => (of_races(table), "ms", true),
    };
    let lines: Vec<Line> = lines.into_iter().filter(|(_, p)| p.len() > 1).collect();
    if lines.is_empty() {
        return Err(format!("{name} has no errors with their times to draw"));
    }
    let alt = format!(
        "Error of the attitude against the time it takes, in {unit}, on logarithmic axes, for {} methods",
        lines.len()
    );
    let mut panel = Panel::new(name, &alt)
        .size(340, 340)
        .x(Axis::log(&format!("time / {unit}")))
        .y(Axis::log("error of the attitude / rad"));
    for (method, points) in lines {
        // Another crate's method is not ours, whatever its name.
        let look = match races && is_peer(&method) {
            true => Method::Other,
            false => Method::named(&method),
        };
        let label = if look == Method::Other { method.as_str() } else { look.label() };
        panel = panel.curve(look.curve(points).with_dots().label(label));
    }
    panel.figure().map(|f| f.svg()).map_err(|e| e.to_string())
}

/// A strip: one line for each method and error. What `solve` chose changes from line to
/// line, so all its lines are one.
fn of_strip(table: &Table, error: usize, time: usize) -> Vec<Line> {
    let mut lines: Vec<Line> = Vec::new();
    for row in table.rows() {
        let (Ok(error), Ok(time)) = (row[error].parse(), row[time].parse()) else {
            continue;
        };
        let name = row[0].strip_prefix("least: ").unwrap_or(&row[0]);
        let method = name.split(':').next().unwrap_or("").to_owned();
        match lines.iter_mut().find(|(name, _)| *name == method) {
            Some((_, points)) => points.push((time, error)),
            None => lines.push((method, vec![(time, error)])),
        }
    }
    lines
}

/// Whether a row of races is another crate's: its name begins with that of the crate.
fn is_peer(name: &str) -> bool {
    name.starts_with(char::is_lowercase) && name != "closed form"
}

/// Races: a row for each method, a column for each error.
fn of_races(table: &Table) -> Vec<Line> {
    let errors: Vec<Option<f64>> = table.columns().iter().map(|c| c.parse().ok()).collect();
    let points = |row: &Vec<String>| -> Vec<(f64, f64)> {
        let cells = row.iter().zip(&errors);
        cells.filter_map(|(cell, error)| Some((cell.parse().ok()?, (*error)?))).collect()
    };
    let rows = table.rows().iter();
    rows.map(|row| (row[0].clone(), points(row))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(columns: &[&str], rows: &[&[&str]]) -> Table {
        let mut table = Table::new("a", columns.iter().copied()).expect("columns");
        for row in rows {
            table.push(row.iter().copied()).expect("a row");
        }
        table
    }

    #[test]
    fn both_kinds_of_tables_are_drawn() {
        let strip = table(
            &["method", "requested", "delivered", "work", "time"],
            &[
                &["solve: RK4", "1e-3", "2e-4", "9 steps", "300"],
                &["RK4", "1e-3", "9e-4", "4 steps", "200"],
                &["solve: DOP853", "1e-6", "2e-7", "9 steps", "900"],
                &["RK4", "1e-6", "9e-7", "4 steps", "2000"],
            ],
        );
        assert_eq!(
            of_strip(&strip, 2, 4),
            [
                ("solve".into(), vec![(300.0, 2e-4), (900.0, 2e-7)]),
                ("RK4".into(), vec![(200.0, 9e-4), (2000.0, 9e-7)]),
            ]
        );
        let races = table(
            &["method", "1e-3", "1e-6", "at best"],
            &[
                &["DOP853", "2.5", "7", "-"],
                &["ivp DOP853", "4", "9", "-"],
                &["theirs", "-", "9", "1e-9"],
            ],
        );
        assert_eq!(
            of_races(&races),
            [
                ("DOP853".into(), vec![(2.5, 1e-3), (7.0, 1e-6)]),
                ("ivp DOP853".into(), vec![(4.0, 1e-3), (9.0, 1e-6)]),
                ("theirs".into(), vec![(9.0, 1e-6)]),
            ]
        );
        let svg = drawn("a_b", &races).expect("a drawing");
        assert!(svg.contains(">ivp DOP853<") && svg.contains(">DOP853<"));
        let svg = drawn("a_b", &strip).expect("a drawing");
        assert!(svg.contains("RK4") && svg.contains("solve"));
        // The damaged twin: a table without times is no drawing.
        let words = table(&["method", "work"], &[&["RK4", "4 steps"]]);
        assert!(drawn("a_b", &words).is_err());
    }
}
