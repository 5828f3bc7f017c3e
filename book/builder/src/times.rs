//! What the lines of an accuracy strip cost in time, and what that comes to in two lines.
//!
//! Times are measured, not locked, so they are no part of an example's output: they stand in
//! a record for each stem, `benches/record/strips/STEM.txt`, written by `cargo bench -p benches
//! --bench strips`. A time is shown only beside the very computation that was timed; if anything
//! in the line has changed since, its place holds a dash.

use crate::measured;
use crate::project::Project;
use crate::table;
use crate::text::{escape, number_html};
use kit::{Parsed, Table, short};
use std::cmp::Ordering;

/// What a line of the strip and one of the record must share.
const SAME: [&str; 4] = ["method", "requested", "delivered", "work"];

/// The section in which an example states its strip.
pub const SECTION: &str = "accuracy";

/// The work of a line whose error was found, but not promised.
const REFUSED: &str = "refused";

/// The page that says what to choose.
const CHOICE: &str = "accuracy";

/// A strip with its times, sorted by the error asked for and then by time.
pub struct Timed {
    /// The strip; a line without a time has `-`.
    pub table: Table,
    /// The lines that take the least time of several that deliver the same error.
    least: Vec<usize>,
    /// What the times are, if there are any.
    note: Option<String>,
}

/// A line of the strip as numbers.
#[derive(Debug, Clone)]
struct Line {
    method: String,
    requested: f64,
    delivered: f64,
    work: String,
    time: Option<f64>,
}

impl Line {
    /// A line that delivers what it was asked for.
    fn delivers(&self) -> bool {
        self.delivered <= self.requested && self.work != REFUSED
    }

    /// A line of `solve`, which is asked for an error and finds method and step itself.
    fn is_controlled(&self) -> bool {
        self.method.starts_with("solve")
    }

    /// Method, work and time in words.
    fn words(&self) -> String {
        let method = self.method.trim_start_matches("least: ");
        // Where what is asked for is no error of the result, it stands beside its value.
        let method = match method.strip_suffix(", error of a step") {
            Some(method) => {
                let value = number_html(&format!("{:e}", self.requested)).unwrap_or_default();
                format!("{} with {value} as the error of a step", escape(method))
            }
            None => escape(method),
        };
        let time = match self.time {
            Some(time) => format!(
                "the time of {} samples of the closed form",
                number_html(&short(time, 2)).unwrap_or_default()
            ),
            None => "not timed".into(),
        };
        format!("{method}: {}, {time}", escape(&self.work))
    }
}

impl Timed {
    /// The strip as HTML: two lines, and the whole of it in a fold.
    pub fn html(&self, project: &Project, stem: &str) -> String {
        let time = self.table.columns().len() - 1;
        let table = table::html_with(&self.table, |row, column| {
            column == time && self.least.contains(&row)
        });
        let note = self.note.as_ref();
        let note = note.map(|note| format!("<p class=\"measured\">{}</p>", escape(note)));
        let more = match stem != CHOICE && project.path(&format!("book/src/{CHOICE}.md")).is_file()
        {
            true => format!(" <a href=\"{CHOICE}.html\">What to choose</a>."),
            false => String::new(),
        };
        format!(
            "{}<details class=\"strip\"><summary>All methods and errors</summary>\
             <div class=\"scroll\">{table}</div>{}</details>",
            summary(&lines(&self.table), &more),
            note.unwrap_or_default()
        )
    }
}

/// The lines of the strip that state an error asked for.
fn lines(strip: &Table) -> Vec<Line> {
    let line = |row: &Vec<String>| {
        let cells = cells(strip, row, &SAME)?;
        let time = cells_number(strip, row, "time");
        Some(Line {
            method: cells[0].into(),
            requested: cells[1].parse().ok()?,
            delivered: cells[2].parse().ok()?,
            work: cells[3].into(),
            time,
        })
    };
    strip.rows().iter().filter_map(line).collect()
}

fn cells_number(table: &Table, row: &[String], name: &str) -> Option<f64> {
    cells(table, row, &[name])?[0].parse().ok()
}

/// The two lines: the cheapest method set by hand that delivered the error at which most compete, and
/// what `solve` takes more. Without rivals: what `solve` takes, and what digits cost.
fn summary(lines: &[Line], more: &str) -> String {
    let delivering: Vec<&Line> = lines.iter().filter(|line| line.delivers()).collect();
    let rivals = |error: f64| {
        let same = delivering.iter().filter(move |line| line.requested == error);
        same.copied().filter(|line| !line.is_controlled())
    };
    // The greatest number of rivals; of equals, the last, which is the smallest error.
    let contested = delivering.iter().max_by_key(|line| rivals(line.requested).count());
    let Some(error) = contested.map(|line| line.requested) else {
        return String::new();
    };
    let power = |error: f64| match error {
        // Not 0 times a power of ten.
        0.0 => "0".to_owned(),
        _ => number_html(&format!("{error:e}")).unwrap_or_default(),
    };
    let paragraph = |head: &str, text: String| format!("<p><strong>{head}</strong> {text}</p>");
    let timed = rivals(error).filter(|line| line.time.is_some());
    let all = rivals(error).all(|line| line.time.is_some());
    let cheapest = timed.min_by(|a, b| by_time(a, b)).or(rivals(error).next());
    let requests = delivering.iter().copied().filter(|line| line.is_controlled());
    if let Some(cheapest) = cheapest {
        let solved = requests.clone().find(|line| line.requested == error);
        let sure = match solved {
            Some(solved) => {
                let ratio = solved.time.zip(cheapest.time).map(|(all, least)| all / least);
                let ratio = match ratio {
                    Some(ratio) => format!("{} times as long", short(ratio, 2)),
                    None => "a time that has not been measured".into(),
                };
                format!(
                    "<code>solve</code>, which knows no answer to compare with, takes {ratio} and \
                     delivers {}.{more}",
                    power(solved.delivered)
                )
            }
            None => format!(
                "It is not known here, because <code>solve</code> was not used: each line was run \
                 at its own setting, and its error was found afterwards, against a known \
                 result.{more}"
            ),
        };
        if rivals(error).all(|line| line.time.is_none()) {
            let all: Vec<String> = rivals(error).map(Line::words).collect();
            let head = format!("What delivered {}:", power(error));
            return paragraph(&head, all.join("; ") + ".")
                + &paragraph("The price of being sure:", sure);
        }
        return paragraph(
            &format!(
                "The cheapest method set by hand that delivered {}{}:",
                power(error),
                if all { "" } else { ", of those that are timed" }
            ),
            cheapest.words() + ".",
        ) + &paragraph("The price of being sure:", sure);
    }
    let first = requests.clone().max_by(|a, b| a.requested.total_cmp(&b.requested));
    let last = requests.clone().min_by(|a, b| a.requested.total_cmp(&b.requested));
    let (Some(first), Some(last)) = (first, last) else {
        return String::new();
    };
    let ratio = last.time.zip(first.time).map(|(last, first)| last / first);
    let price = match ratio {
        Some(ratio) => {
            format!("takes {} times as long as {}", short(ratio, 2), power(first.requested))
        }
        None => "has not been timed".into(),
    };
    paragraph(&format!("For an error of {}:", power(first.requested)), first.words() + ".")
        + &paragraph(
            "The price of digits:",
            format!("an error of {} {price}.{more}", power(last.requested)),
        )
}

/// The lesser time first; what was not timed last.
fn by_time(a: &Line, b: &Line) -> Ordering {
    let time = |line: &Line| line.time.unwrap_or(f64::INFINITY);
    time(a).total_cmp(&time(b))
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
    let file = format!("{}/strips/{stem}.txt", measured::RECORDS);
    let record = match project.path(&file).is_file() {
        false => None,
        true => Some(measured::record(project, &format!("strips/{stem}"))?),
    };
    let measured = record.as_ref().and_then(|r| r.table("table strip"));
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
    let (_, kept) = strip.columns().split_last().ok_or("a strip without columns")?;
    let columns = kept.iter().map(String::as_str).chain(["time"]);
    let mut timed = Table::new(SECTION, columns).map_err(|e| e.to_string())?;
    let mut sorted: Vec<(&Vec<String>, &str)> =
        strip.rows().iter().zip(times.iter().map(|time| time.as_deref().unwrap_or("-"))).collect();
    let key = |(row, time): &(&Vec<String>, &str)| {
        let requested = cells_number(strip, row, "requested").unwrap_or(0.0);
        (-requested, time.parse().unwrap_or(f64::INFINITY))
    };
    sorted.sort_by(|a, b| {
        let (a, b): ((f64, f64), (f64, f64)) = (key(a), key(b));
        a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    for (row, time) in sorted {
        let cells = row[..kept.len()].iter().map(String::as_str).chain([time]);
        timed.push(cells).map_err(|e| e.to_string())?;
    }
    let least = least(&timed);
    let note = record
        .filter(|_| times.iter().any(Option::is_some))
        .map(|record| note(&record, !least.is_empty()));
    Ok(Timed { table: timed, least, note })
}

/// The lines with the least time among several that deliver the same error, if the time of
/// each of these is known.
fn least(strip: &Table) -> Vec<usize> {
    let number = |cell: &str| cell.parse::<f64>().ok();
    // Line, requested, time.
    let delivering: Vec<(usize, f64, Option<f64>)> = (0..)
        .zip(strip.rows())
        .filter_map(|(n, row)| {
            let cells = cells(strip, row, &["requested", "delivered", "time", "work"])?;
            let [requested, delivered, time] = [cells[0], cells[1], cells[2]].map(number);
            let delivers = delivered? <= requested? && cells[3] != REFUSED;
            delivers.then_some((n, requested?, time))
        })
        .collect();
    let is_least = |&&(line, requested, time): &&(usize, f64, Option<f64>)| {
        let mut rivals =
            delivering.iter().filter(|rival| rival.0 != line && rival.1 == requested).peekable();
        let beats = |rival: Option<f64>| time.zip(rival).is_some_and(|(own, rival)| own <= rival);
        rivals.peek().is_some() && rivals.all(|rival| beats(rival.2))
    };
    let least = delivering.iter().filter(is_least);
    least.map(|line| line.0).collect()
}

fn note(record: &Parsed, marked: bool) -> String {
    let unit = record.table("table unit").and_then(|table| table.rows().first());
    let mut note = String::from("Time: in units of one sample of the closed form");
    if let Some(unit) = unit.and_then(|row| row.get(1)) {
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
    fn no_error_is_no_power_of_ten() {
        let columns = ["method", "requested", "delivered", "work", "time"];
        let mut table = Table::new(SECTION, columns).expect("sound");
        for (method, delivered) in [("solve: exact", "0"), ("RK4", "5e-10")] {
            let row = [method, "1e-9", delivered, "9 steps", "-"];
            table.push(row).expect("sound");
        }
        let words = summary(&lines(&table), "");
        assert!(words.contains("and delivers 0."), "{words}");
    }

    #[test]
    fn the_least_is_found_among_those_that_deliver() {
        let columns = ["method", "requested", "delivered", "work", "time"];
        let rows = [
            ["fast and wrong", "1e-9", "1e-3", "1 step", "1"],
            ["slow", "1e-9", "1e-9", "9 steps", "90"],
            ["fast", "1e-9", "5e-10", "2 steps", "20"],
            ["near, not promised", "1e-9", "1e-10", "refused", "-"],
            ["half timed", "1e-3", "5e-4", "2 steps", "-"],
            ["half timed", "1e-3", "5e-4", "1 step", "3"],
            ["alone", "1e-6", "5e-7", "1 step", "10"],
            ["no request", "-", "5e-7", "1 step", "5"],
        ];
        let mut table = Table::new(SECTION, columns).expect("sound");
        for row in rows {
            table.push(row).expect("sound");
        }
        assert_eq!(least(&table), [2]);
        // In words: what delivers and is timed is the cheapest, and `solve` is compared with it.
        let asked = ["DOP853, error of a step", "1e-9", "5e-10", "3 steps", "2"];
        let line = |row: [&str; 5]| {
            let mut table = Table::new(SECTION, columns).expect("sound");
            table.push(row).expect("sound");
            lines(&table)[0].words()
        };
        assert!(
            line(asked).starts_with("DOP853 with 10<sup>−9</sup> as the error of a step: 3 steps")
        );
        table.push(["solve: slow", "1e-9", "1e-12", "90 steps", "50"]).expect("sound");
        let words = summary(&lines(&table), "");
        for part in ["fast: 2 steps, the time of 20 samples", "takes 2.5 times as long"] {
            assert!(words.contains(part), "{words}");
        }
        let alone: Vec<Line> = lines(&table).into_iter().filter(Line::is_controlled).collect();
        assert!(summary(&alone, "").contains("For an error of 10<sup>\u{2212}9</sup>"));
        assert_eq!(summary(&[], ""), "");
    }
}
