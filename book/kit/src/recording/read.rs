//! From the bytes of a file to numbers.

use super::columns::{self, EXPECTED, Layout};
use super::series::{Series, Wrong, brief, number};
use super::{FEWEST, Recording, middle};
use crate::error::{Error, Result};
use crate::number::short;
use core::ops::RangeInclusive;
use csv::{Reader, ReaderBuilder, StringRecord};
use rotation_dynamics::error::plain;
use std::borrow::Cow;

/// The sensors of phones end at 2000, few at 4000 degrees per second (70 rad/s): larger numbers are in another
/// unit.
const FASTEST: f64 = 100.0;

/// Samples a second of phones, with room; else times are in another unit.
const FREQUENCIES: RangeInclusive<f64> = 1.0..=20_000.0;

/// A step is a gap where it is longer than this many usual ones: two samples are missing, not one.
pub(super) const GAP: f64 = 2.5;

/// How many lines of other text may stand above the header.
const PREAMBLE: usize = 100;

/// What begins a file that is no table, and what to do.
const OTHERS: [(&[u8], &str); 10] = [
    (b"\x89PNG", "a picture (PNG), not a table of numbers"),
    (b"\xFF\xD8\xFF", "a picture (JPEG), not a table of numbers"),
    (b"GIF8", "a picture (GIF), not a table of numbers"),
    (b"%PDF", "a PDF document, not a table of numbers"),
    (
        b"PK",
        "an archive (zip) or a workbook (xlsx): unpack it and choose the table of the gyroscope, or export as CSV",
    ),
    (b"\xD0\xCF\x11\xE0", "a workbook (xls): export as CSV"),
    (b"\x1F\x8B", "an archive (gzip): unpack it"),
    (b"{", "JSON: export as CSV"),
    (b"[", "JSON: export as CSV"),
    (b"<", "XML or HTML: export as CSV"),
];

pub(super) fn recording(name: &str, bytes: &[u8]) -> Result<Recording> {
    let text = text(bytes)?;
    let (delimiter, text) = delimited(&text);
    let reader = ReaderBuilder::new()
        .delimiter(delimiter)
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .from_reader(text.as_bytes());
    let record = StringRecord::new();
    let mut lines = Lines { text: &text, delimiter, reader, record, line: 1, passed: 0 };
    let (header, layout, at_numbers) = header(name, &mut lines)?;
    let mut table = Table {
        rates: Series::new(&layout.rates),
        accelerations: layout.acceleration.as_ref().map(Series::new),
        header,
        origin: None,
        left_out: 0,
    };
    let mut more = at_numbers || lines.next();
    while more {
        if let Err((column, reason)) = table.take(&lines.record, lines.line) {
            return Err(match lines.record.iter().any(|cell| number(cell).is_some()) {
                true => at(Some(lines.line), Some(table.name(column)), reason),
                false => {
                    let text = lines.record.iter().collect::<Vec<_>>().join(",");
                    at(Some(lines.line), None, format!("{:?} are no numbers", brief(&text)))
                }
            });
        }
        more = lines.next();
    }
    table.finished(&layout)
}

/// The names of the columns, what they are, and whether the current line has numbers already.
fn header(name: &str, lines: &mut Lines) -> Result<(Vec<String>, Layout, bool)> {
    let mut last: Option<(usize, String)> = None;
    for _ in 0..PREAMBLE {
        if !lines.next() {
            break;
        }
        let cells = lines.record.len();
        if lines.record.iter().filter(|cell| number(cell).is_some()).count() >= 2 {
            // Some programs write the names into a comment.
            let comments = lines.text.lines().take_while(|line| line.starts_with('#'));
            let comment = comments.last().unwrap_or("").split(char::from(lines.delimiter));
            let names = names(comment);
            return match (last, columns::layout(&names, name)) {
                (Some((line, missing)), _) => Err(at(Some(line), None, missing)),
                (None, Ok(layout)) => Ok((names, layout, true)),
                (None, Err(_)) if cells == 4 => Ok((Vec::new(), columns::bare(), true)),
                (None, Err(_)) => {
                    let reason = format!("there are {cells} columns and no header; {EXPECTED}");
                    Err(at(Some(lines.line), None, reason))
                }
            };
        }
        let cells = names(lines.record.iter());
        match columns::layout(&cells, name) {
            Ok(layout) => {
                let more = lines.next();
                let units = names(lines.record.iter()).into_iter();
                if !more || !units.clone().any(|unit| columns::is_unit(&unit)) {
                    return Ok((cells, layout, more));
                }
                // Units in a line of their own.
                let bare = |unit: &str| unit.trim_matches(['(', ')', '[', ']']).to_string();
                let both = cells.iter().zip(units.chain(core::iter::repeat(String::new())));
                let cells: Vec<_> =
                    both.map(|(name, unit)| format!("{name} ({})", bare(&unit))).collect();
                let layout = columns::layout(&cells, name);
                return match layout {
                    Ok(layout) => Ok((cells, layout, false)),
                    Err(missing) => Err(at(Some(lines.line), None, missing)),
                };
            }
            Err(missing) => last = Some((lines.line, missing)),
        }
    }
    Err(at(None, None, format!("the file has no table of numbers; {EXPECTED}")))
}

/// The names in a header, without the mark of a comment before them.
fn names<'a>(cells: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut names: Vec<String> = cells.map(|cell| cell.trim().to_string()).collect();
    if let Some(first) = names.first_mut() {
        let bare = first.trim_start_matches(['#', '%']).trim().to_string();
        match bare.is_empty() && !first.is_empty() {
            true => drop(names.remove(0)),
            false => *first = bare,
        }
    }
    names
}

/// The lines of a table.
struct Lines<'a> {
    text: &'a str,
    delimiter: u8,
    reader: Reader<&'a [u8]>,
    record: StringRecord,
    /// Which line `record` is, from 1. (What the reader says is off where lines are passed over.)
    line: usize,
    /// The bytes before its end.
    passed: usize,
}

impl Lines<'_> {
    /// Whether there is another one.
    fn next(&mut self) -> bool {
        let more = self.reader.read_record(&mut self.record).unwrap_or(false);
        let end = (self.reader.position().byte() as usize).min(self.text.len());
        let passed = end.saturating_sub(1).max(self.passed);
        self.line += self.text[self.passed..passed].matches('\n').count();
        self.passed = passed;
        more
    }
}

fn at(line: Option<usize>, column: Option<String>, reason: String) -> Error {
    Error::Recording { line, column, reason }
}

/// The bytes as text.
fn text(bytes: &[u8]) -> Result<Cow<'_, str>> {
    let start = bytes.trim_ascii_start();
    if let Some((_, what)) = OTHERS.iter().find(|(begin, _)| start.starts_with(begin)) {
        return Err(at(None, None, format!("the file is {what}")));
    }
    let pairs = |order: fn([u8; 2]) -> u16| {
        let units = bytes[2..].chunks_exact(2).map(move |pair| order([pair[0], pair[1]]));
        Cow::Owned(char::decode_utf16(units).map(|c| c.unwrap_or('\u{FFFD}')).collect())
    };
    let text = match bytes {
        [0xFF, 0xFE, ..] => pairs(u16::from_le_bytes),
        [0xFE, 0xFF, ..] => pairs(u16::from_be_bytes),
        _ => match core::str::from_utf8(bytes) {
            Ok(text) => Cow::Borrowed(text.strip_prefix('\u{FEFF}').unwrap_or(text)),
            Err(_) => Cow::Owned(bytes.iter().map(|byte| char::from(*byte)).collect()),
        },
    };
    let text = match text.contains('\u{2212}') {
        true => Cow::Owned(text.replace('\u{2212}', "-")),
        false => text,
    };
    match text.trim().is_empty() {
        true => Err(at(None, None, format!("the file is empty; {EXPECTED}"))),
        false if text.contains('\0') => {
            Err(at(None, None, "the file is not text: export the recording as CSV".into()))
        }
        false => Ok(text),
    }
}

/// What is between the columns, by the first line that has four; spaces are made tabs.
fn delimited(text: &str) -> (u8, Cow<'_, str>) {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    for line in lines.take(PREAMBLE) {
        let most = [b'\t', b';'].into_iter().find(|d| line.bytes().filter(|b| b == d).count() >= 3);
        if let Some(delimiter) = most {
            return (delimiter, text.into());
        }
        let words = line.split_whitespace();
        if words.clone().count() >= 3 && words.clone().all(|word| number(word).is_some()) {
            let joined = |line: &str| {
                let line = line.replace(" (", "(").replace(" [", "[");
                line.split_whitespace().collect::<Vec<_>>().join("\t")
            };
            return (b'\t', text.lines().map(joined).collect::<Vec<_>>().join("\n").into());
        }
        if line.bytes().filter(|byte| *byte == b',').count() >= 3 {
            break;
        }
    }
    (b',', text.into())
}

/// The table as it is read.
struct Table {
    rates: Series,
    accelerations: Option<Series>,
    header: Vec<String>,
    origin: Option<i64>,
    left_out: usize,
}

impl Table {
    fn take(&mut self, record: &StringRecord, line: usize) -> core::result::Result<(), Wrong> {
        let [cells, names] = [record.len(), self.header.len()];
        if names >= 4 && cells + 1 >= 2 * names {
            let reason = format!(
                "there are {cells} cells under {names} names: if commas are both decimal and between \
                 columns, export with decimal points or with semicolons"
            );
            return Err((names, reason));
        }
        if self.rates.take(record, line, &mut self.origin)? {
            let unit = self.rates.sensor.unit.unwrap_or(1.0);
            let values = self.rates.values.last().copied().unwrap_or_default();
            for (n, value) in self.rates.sensor.axes.into_iter().zip(values) {
                let rate = value * unit;
                if rate.abs() > FASTEST {
                    let why = match unit {
                        1.0 => {
                            ": these are probably degrees per second, which the header must say, as in \
                             \"Gyroscope x (deg/s)\""
                        }
                        _ => "",
                    };
                    let [value, rate] = [value, rate].map(plain);
                    let reason = format!(
                        "{value} would be {rate} rad/s; no phone shows more than {FASTEST}{why}"
                    );
                    return Err((n, reason));
                }
            }
        } else if record.iter().any(|cell| !cell.trim().is_empty()) {
            self.left_out += 1;
        }
        if let Some(accelerations) = &mut self.accelerations {
            accelerations.take(record, line, &mut self.origin)?;
        }
        Ok(())
    }

    /// A column, for a message.
    fn name(&self, column: usize) -> String {
        match self.header.get(column) {
            Some(name) => format!("{} ({})", column + 1, brief(name)),
            None => (column + 1).to_string(),
        }
    }

    fn finished(mut self, layout: &Layout) -> Result<Recording> {
        let lines = self.rates.times.len();
        let settled = self.rates.settle();
        self.accelerations.as_mut().and_then(Series::settle);
        let Self { rates: series, left_out, .. } = &self;
        let count = series.times.len();
        let different = series.times.chunk_by(|a, b| a == b).count();
        if different < FEWEST {
            let fewest = format!("expected {FEWEST} or more");
            return Err(match lines < FEWEST {
                true => at(None, None, format!("lines with rates: {lines}; {fewest}")),
                false => {
                    let reason = format!(
                        "different times in {lines} lines: {different}; {fewest}: are they written with all digits?"
                    );
                    at(None, Some(self.name(series.sensor.time)), reason)
                }
            });
        }
        for (k, n) in series.sensor.axes.into_iter().enumerate() {
            let first = series.values[0][k];
            if series.values.iter().all(|value| value[k] == first) {
                let reason =
                    format!("it shows {first} in every line; expected a rate that changes");
                return Err(at(None, Some(self.name(n)), reason));
            }
        }
        let mut notes = vec![format!("Read as {}.", layout.app)];
        let (unit, origin) = series.clock(self.origin.unwrap_or(0), &mut notes);
        let times: Vec<f64> = series.times.iter().map(|t| unit * (t - origin)).collect();
        let duration = times[count - 1] - times[0];
        let frequency = (count - 1) as f64 / duration;
        notes.push(format!("{count} samples in {duration:.3} s, {frequency:.1} a second."));
        if !FREQUENCIES.contains(&frequency) {
            let reason = format!(
                "{} samples a second: are the times in {}?",
                short(frequency, 2),
                if unit < 1.0 { "s" } else { "ms" }
            );
            return Err(at(None, Some(self.name(series.sensor.time)), reason));
        }
        match series.sensor.unit {
            Some(1.0) => {}
            Some(unit) => {
                notes.push(format!("The rates were converted from {}.", columns::said(unit)))
            }
            None => notes.push("The rates have no unit: they were taken as rad/s.".into()),
        }
        if layout.uncalibrated {
            notes.push(
                "Of calibrated and uncalibrated rates the calibrated ones were taken.".into(),
            );
        }
        if let Some((repeated, done)) = settled {
            notes.push(format!("Lines with the time of the line before: {repeated}; {done}."));
        }
        if *left_out > 0 {
            notes.push(format!("Lines without rates, left out: {left_out}."));
        }
        let step = middle(times.windows(2).map(|pair| pair[1] - pair[0]).collect());
        let mut gaps = times.windows(2).filter(|pair| pair[1] - pair[0] > GAP * step).peekable();
        if let Some(first) = gaps.peek().copied() {
            notes.push(format!(
                "Steps longer than {GAP} usual ones: {}; the first is from {:.4} s to {:.4} s.",
                gaps.count(),
                first[0],
                first[1]
            ));
        }
        let accelerations = self.accelerations.as_ref().and_then(|series| {
            let first = series.values.first().filter(|_| series.values.len() >= FEWEST)?;
            if series.values.iter().all(|value| value == first) {
                notes.push("The accelerations never change: they were left out.".into());
                return None;
            }
            notes.push("Accelerations were read as well.".into());
            if series.times != self.rates.times {
                notes.push("They have times of their own: they were interpolated.".into());
            }
            let (own, _) = series.clock(0, &mut Vec::new());
            let value = |t: &f64| series.at(t * unit / own);
            let unit = series.sensor.unit.unwrap_or(1.0);
            Some(self.rates.times.iter().map(|t| value(t).map(|a| unit * a)).collect())
        });
        let unit = series.sensor.unit.unwrap_or(1.0);
        let rates = series.values.iter().map(|rate| rate.map(|w| unit * w)).collect();
        let lines = self.rates.lines;
        let mut recording = Recording { times, rates, accelerations, notes, lines };
        if let Some(limit) = recording.at_its_limit() {
            recording.notes.push(format!("F{}.", &limit[1..]));
        }
        Ok(recording)
    }
}
