//! What a page makes of a reader's own recording.

use super::example::Run;
use super::json::quoted;
use super::number::{exactly, short, without_minus_nought};
use super::parameters::check;
use super::{Figure, MovingPicture, Report, Table, Trajectory};
use crate::error::{Error, Result};
use core::fmt::Write;

/// What a page does with recordings: a part of its [`Example`](super::Example), if it has one.
pub struct Recordings<P> {
    /// Whether a recording holds several pieces that are numbered, of which `--throw` names one.
    pub throws: bool,
    /// A made-up recording, as an app exports it.
    pub made: fn() -> String,
    /// What there is to say of a file with this name and these bytes.
    pub recorded: fn(&P, &str, &[u8], &Asked) -> Result<Recorded>,
}

/// What a reader asks of a recording.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Asked {
    /// Where the piece begins (s), as the file counts time.
    pub from: Option<f64>,
    /// Where it ends (s).
    pub to: Option<f64>,
    /// Which of the pieces that were found, from 1.
    pub throw: Option<usize>,
    /// The names of the flags that were typed: what they set is the reader's, not the page's.
    pub given: Vec<String>,
}

/// What a recording says.
pub struct Recorded {
    /// Title, description, tables.
    pub report: Report,
    /// The numbers, for programs; the report has them as a table.
    pub found: Vec<Found>,
    /// The corrections that were tried, for programs; the report has them as a table.
    pub decided: Vec<Decided>,
    /// The drawings.
    pub figures: Vec<Figure>,
    /// What was measured and what was fitted, for `--csv`.
    pub trajectory: Trajectory,
    /// The drawings that move or can be turned, with their names.
    pub pictures: Vec<(&'static str, MovingPicture)>,
    /// What to see in the drawings, by their names.
    pub captions: Vec<(&'static str, &'static str)>,
}

/// A quantity that a recording tells, or does not.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    key: &'static str,
    meaning: String,
    unit: &'static str,
    told: Told,
}

#[derive(Debug, Clone, PartialEq)]
enum Told {
    /// A value and its interval of 95 per cent.
    Estimate([f64; 3]),
    /// A value, and the digits of it that are worth printing.
    Number(f64, u32),
    Word(String),
    /// Why there is none.
    Open(String),
}

impl Found {
    /// A value, and from where to where its interval of 95 per cent goes.
    pub fn estimate(
        key: &'static str,
        meaning: impl Into<String>,
        unit: &'static str,
        estimate: [f64; 3],
    ) -> Self {
        Self { key, meaning: meaning.into(), unit, told: Told::Estimate(estimate) }
    }

    /// A value of which so many digits are printed.
    pub fn number(
        key: &'static str,
        meaning: impl Into<String>,
        unit: &'static str,
        value: f64,
        digits: u32,
    ) -> Self {
        Self { key, meaning: meaning.into(), unit, told: Told::Number(value, digits) }
    }

    /// A word.
    pub fn word(key: &'static str, meaning: impl Into<String>, word: impl Into<String>) -> Self {
        Self { key, meaning: meaning.into(), unit: "-", told: Told::Word(word.into()) }
    }

    /// What the recording does not determine, and why.
    pub fn open(key: &'static str, meaning: impl Into<String>, why: impl Into<String>) -> Self {
        Self { key, meaning: meaning.into(), unit: "-", told: Told::Open(why.into()) }
    }

    /// The table `found`.
    ///
    /// # Errors
    /// [`Error::Text`] for a text that does not fit in a table.
    pub fn table(found: &[Self]) -> Result<Table> {
        let columns = ["quantity", "value", "95 % from", "to", "unit", "what it is"];
        Table::of("found", columns, found, |one| {
            let dash = || "-".to_owned();
            let (value, from, to) = match &one.told {
                Told::Estimate([value, from, to]) => {
                    let digits = places(0.5 * (to - from));
                    let printed = |x: &f64| without_minus_nought(&format!("{x:.digits$}"));
                    (printed(value), printed(from), printed(to))
                }
                Told::Number(value, _) if value.fract() == 0.0 => (exactly(*value), dash(), dash()),
                Told::Number(value, digits) => (short(*value, *digits), dash(), dash()),
                Told::Word(word) => (word.clone(), dash(), dash()),
                Told::Open(_) => ("not determined".into(), dash(), dash()),
            };
            let meaning = match &one.told {
                Told::Open(why) => format!("{}: {why}", one.meaning),
                _ => one.meaning.clone(),
            };
            Ok([one.key.to_owned(), value, from, to, one.unit.to_owned(), meaning])
        })
    }

    fn json(&self) -> String {
        let value = match &self.told {
            Told::Estimate([value, from, to]) => {
                format!("{value:?}, \"from\": {from:?}, \"to\": {to:?}")
            }
            Told::Number(value, _) => format!("{value:?}"),
            Told::Word(word) => quoted(word),
            Told::Open(why) => format!("null, \"why\": {}", quoted(why)),
        };
        let (key, meaning, unit) = (quoted(self.key), quoted(&self.meaning), quoted(self.unit));
        format!("{{\"key\": {key}, \"meaning\": {meaning}, \"unit\": {unit}, \"value\": {value}}}")
    }
}

/// A correction that was tried, and whether the recording calls for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Decided {
    /// What is corrected.
    pub name: &'static str,
    /// Whether it is called for.
    pub needed: bool,
    /// By how much the fit is better with it.
    pub improvement: f64,
    /// By how much it must be.
    pub threshold: f64,
    /// What it comes to, each with its interval of 95 per cent; nothing if it is not called for.
    pub values: Vec<[f64; 3]>,
    /// Their unit, and on which axes they are.
    pub unit: &'static str,
}

impl Decided {
    /// The table `corrections`.
    ///
    /// # Errors
    /// [`Error::Text`] for a text that does not fit in a table.
    pub fn table(decided: &[Self]) -> Result<Table> {
        let columns = ["correction", "here", "improvement", "threshold", "what it comes to"];
        Table::of("corrections", columns, decided, |one| {
            let values: Vec<String> = one.values.iter().copied().map(with_interval).collect();
            let told = match values.is_empty() {
                true => "-".into(),
                false => format!("{}, {}", values.join("; "), one.unit),
            };
            let here = if one.needed { "called for" } else { "not called for" };
            let [gain, least] = [one.improvement, one.threshold].map(|x| short(x, 3));
            Ok([one.name.to_owned(), here.into(), gain, least, told])
        })
    }

    fn json(&self) -> String {
        let values = self.values.iter().map(|[value, from, to]| {
            format!("{{\"value\": {value:?}, \"from\": {from:?}, \"to\": {to:?}}}")
        });
        let values: Vec<String> = values.collect();
        let Self { needed, improvement, threshold, .. } = self;
        format!(
            "{{\"correction\": {}, \"needed\": {needed}, \"improvement\": {improvement:?}, \"threshold\": \
             {threshold:?}, \"values\": [{}], \"unit\": {}}}",
            quoted(self.name),
            values.join(", "),
            quoted(self.unit)
        )
    }
}

/// So many decimals that two digits of this half of an interval are seen.
fn places(half: f64) -> usize {
    let digits = format!("{half:e}");
    let power: i32 = digits.split_once('e').and_then(|(_, p)| p.parse().ok()).unwrap_or(0);
    (1 - power).clamp(0, 15) as usize
}

/// A value with half its interval of 95 per cent: `0.0123 ± 0.0021`.
///
/// ```
/// assert_eq!(kit::with_interval([0.012_34, 0.010_2, 0.014_4]), "0.0123 ± 0.0021");
/// ```
pub fn with_interval([value, from, to]: [f64; 3]) -> String {
    let (half, digits) = (0.5 * (to - from), places(0.5 * (to - from)));
    let printed = format!("{value:.digits$} ± {half:.digits$}");
    without_minus_nought(&printed)
}

impl Recorded {
    /// The figures, the stills of what moves among them.
    ///
    /// # Errors
    /// Those of the drawings.
    pub fn all_figures(&self) -> Result<Vec<Figure>> {
        let mut all = self.figures.clone();
        for (name, picture) in &self.pictures {
            let stills = picture.stills()?.into_iter();
            let named = |(n, still)| Figure { name: format!("{name}_{}", n + 1), ..still };
            all.extend(stills.enumerate().map(named));
        }
        Ok(all)
    }

    /// What to see in the drawing of this name.
    pub fn caption(&self, name: &str) -> &'static str {
        self.captions.iter().find(|(of, _)| *of == name).map_or("", |(_, caption)| caption)
    }

    /// `{"stem", "title", "description", "found": [{"key", "meaning", "unit", "value", "from", "to", "why"}],
    /// "corrections": [{"correction", "needed", "improvement", "threshold", "values": [{"value", "from", "to"}],
    /// "unit"}], "tables": [{"heading", "columns", "rows"}]}`; numbers read back to the same bits; `value` is
    /// `null` with a `why` for what the recording does not determine.
    ///
    /// # Errors
    /// As [`Report::sections`].
    pub fn json(&self, stem: &str) -> Result<String> {
        let list = |items: &[String]| {
            let items: Vec<String> = items.iter().map(|item| quoted(item)).collect();
            format!("[{}]", items.join(", "))
        };
        let mut tables = String::new();
        for table in self.report.sections()? {
            let rows: Vec<String> = table.rows().iter().map(|row| list(row)).collect();
            let comma = if tables.is_empty() { "" } else { "," };
            // Writing to a string cannot fail.
            let _ = write!(
                tables,
                "{comma}\n    {{\"heading\": {}, \"columns\": {}, \"rows\": [{}]}}",
                quoted(table.heading().trim_start_matches("table ")),
                list(table.columns()),
                rows.join(", ")
            );
        }
        let found: Vec<String> = self.found.iter().map(|f| format!("\n    {}", f.json())).collect();
        let decided: Vec<String> =
            self.decided.iter().map(|d| format!("\n    {}", d.json())).collect();
        Ok(format!(
            "{{\n  \"stem\": {},\n  \"title\": {},\n  \"description\": {},\n  \"found\": [{}\n  ],\n  \
             \"corrections\": [{}\n  ],\n  \"tables\": [{tables}\n  ]\n}}\n",
            quoted(stem),
            quoted(self.report.title()),
            quoted(self.report.description()),
            found.join(","),
            decided.join(","),
        ))
    }
}

/// What the page makes of this file with its parameters as they are set.
pub(super) fn recorded(run: &dyn Run, name: &str, bytes: &[u8], asked: &Asked) -> Result<Recorded> {
    check(run.parameters())?;
    run.recorded(name, bytes, asked).unwrap_or_else(|| {
        let allowed = "this example reads no recordings";
        Err(Error::Text { text: name.into(), allowed })
    })
}
