//! What the tests of a page ask of it: is it confirmed, is it refused, what does it say?

#![allow(dead_code, reason = "a page asks some of it, and one page alone can be tested")]

use kit::cli::Outcome;
use kit::{Page, Report, Table};
use std::collections::HashMap;
use std::hash::Hash;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock, Mutex, OnceLock};
use support::{EPS, Errors};

/// The project's root.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The page of this stem, unless `PAGES` leaves it out.
pub fn page(stem: &str) -> Option<&'static dyn Page> {
    pages::ALL.iter().find(|page| page.stem() == stem).copied()
}

/// The number in this variable of the environment.
pub fn asked(variable: &str) -> Option<u64> {
    let text = std::env::var(variable).ok()?;
    Some(text.parse().expect("a number"))
}

/// So many cases as often as `PROPERTY_CASES` says. Where it says nothing, a part of them: the gate
/// sets it.
pub fn thinned(cases: u64, part: u64) -> u64 {
    asked("PROPERTY_CASES").map_or(cases / part, |times| cases * times)
}

/// What has been computed, by its question: pages print the same for the same flags, so a
/// question that many tests ask is computed once for all of them.
struct Once<K, V>(LazyLock<Mutex<HashMap<K, Arc<OnceLock<V>>>>>);

impl<K: Eq + Hash, V> Once<K, V> {
    const fn new() -> Self {
        Self(LazyLock::new(Mutex::default))
    }

    /// Others may ask other questions meanwhile.
    fn ask(&self, question: K, compute: impl FnOnce() -> V) -> Arc<OnceLock<V>> {
        let found = Arc::clone(self.0.lock().expect("no test panics here").entry(question).or_default());
        found.get_or_init(compute);
        found
    }
}

/// What the page answers to these flags. Without any it prints its report: that it does is seen
/// where `commands` runs the pages.
pub fn answer(page: &dyn Page, flags: &str) -> Outcome {
    static ANSWERS: Once<(&str, String), Outcome> = Once::new();
    let words: Vec<&str> = flags.split_whitespace().collect();
    if words.is_empty() {
        let stdout = with_report(page, |report| report.output()).expect("the default output is sound");
        return Outcome { stdout, stderr: String::new(), code: 0 };
    }
    let told = ANSWERS.ask((page.stem(), words.join(" ")), || page.answer(flags));
    told.get().expect("it is computed").clone()
}

/// What the page reports with its defaults, which are sound.
pub fn with_report<T>(page: &dyn Page, look: impl FnOnce(&Report) -> T) -> T {
    with_report_for(page, "", look)
}

/// What the page reports with these flags, which it takes: nothing is printed, and so no line of
/// the accuracy strip is computed unless it is looked at.
#[track_caller]
pub fn with_report_for<T>(page: &dyn Page, flags: &str, look: impl FnOnce(&Report) -> T) -> T {
    static REPORTS: Once<(&str, String), Result<Report, Outcome>> = Once::new();
    let told = REPORTS.ask((page.stem(), flags.to_owned()), || page.report_for(flags));
    match told.get().expect("it is computed") {
        Ok(report) => look(report),
        Err(refused) => panic!("{flags}: {}", refused.stderr),
    }
}

/// This section of the report for these flags.
#[track_caller]
fn section(page: &dyn Page, flags: &str, heading: &str) -> Table {
    let found = with_report_for(page, flags, |report| report.section(heading)).expect("it can be printed");
    found.unwrap_or_else(|| panic!("{flags}: no section {heading}"))
}

/// Asserts that the page reports for these command lines, flags parted by spaces: a report holds
/// a claim only if its oracle agrees, so every number of these runs is confirmed. There are `count`;
/// of every four the first is run, and all for a page alone or where `PROPERTY_CASES` is set, as in the gate.
#[track_caller]
pub fn confirmed<S: AsRef<str>>(page: &dyn Page, runs: impl IntoIterator<Item = S>, count: usize) {
    let part = if asked("PROPERTY_CASES").is_some() || !pages::WHOLE { 1 } else { 4 };
    let mut listed = 0;
    for flags in runs {
        (listed % part == 0).then(|| section(page, flags.as_ref(), "claims"));
        listed += 1;
    }
    assert!(listed == count && listed > 0, "{listed} runs, not {count}");
}

/// Asserts that the page refuses each of these command lines, prints nothing, and says why in
/// a message that contains these words.
#[track_caller]
pub fn refused<const N: usize>(page: &dyn Page, runs: [(&str, &str); N]) {
    const { assert!(N > 0, "nothing is refused") };
    for (flags, words) in runs {
        let told = answer(page, flags);
        assert_eq!((told.code, told.stdout.as_str()), (2, ""), "{flags}");
        assert!(told.stderr.contains(words), "{flags}: {}", told.stderr);
    }
}

/// The value of a claim, to its last bit, with the defaults.
#[track_caller]
pub fn value(page: &dyn Page, key: &str) -> f64 {
    computed(page, "", key)
}

/// How far claims are, with the defaults, from values that are known otherwise: each over its
/// value, in units of round-off.
#[track_caller]
pub fn errors_of<const N: usize>(page: &dyn Page, known: [(&str, f64); N]) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "claims, relative");
    for (key, wanted) in known {
        errors.add(value(page, key), wanted, wanted.abs());
    }
    errors
}

/// The number that stands first in a cell of what the page prints: in this section, in the row
/// that begins so, in this column.
#[track_caller]
pub fn cell(page: &dyn Page, flags: &str, [heading, row, column]: [&str; 3]) -> f64 {
    let table = section(page, flags, heading);
    let found = table.columns().iter().position(|name| name == column);
    let column = found.unwrap_or_else(|| panic!("{heading} has no column {column}"));
    let found = table.rows().iter().find(|cells| cells[0] == row);
    let cells = found.unwrap_or_else(|| panic!("{heading} has no row {row}"));
    let number = cells[column].split(' ').next().expect("a cell is not empty");
    number.parse().expect("it begins with a number")
}

/// A column of what the page prints with its defaults, as far as it holds numbers.
#[track_caller]
pub fn column(page: &dyn Page, heading: &str, name: &str) -> Vec<f64> {
    let table = section(page, "", heading);
    let found = table.columns().iter().position(|column| column == name);
    let column = found.unwrap_or_else(|| panic!("{heading} has no column {name}"));
    table.rows().iter().filter_map(|row| row[column].parse().ok()).collect()
}

/// The lines of the card of effects that a simulation measures, with the defaults: the
/// predicted error of leaving out the effect, and the measured one. There are `N` of them.
#[track_caller]
pub fn measured<const N: usize>(page: &dyn Page) -> [[f64; 2]; N] {
    let lines: Vec<[f64; 2]> = with_report(page, |report| {
        let lines = report.effects().iter();
        lines.filter_map(|line| Some([line.error, line.measured?])).collect()
    });
    lines.try_into().unwrap_or_else(|lines: Vec<_>| panic!("{} lines are measured, not {N}", lines.len()))
}

/// The number that this run prints under `key`.
#[track_caller]
pub fn number(page: &dyn Page, flags: &str, key: &str) -> f64 {
    cell(page, flags, ["claims", key, "value"])
}

/// The value of a claim for these flags, to its last bit.
#[track_caller]
pub fn computed(page: &dyn Page, flags: &str, key: &str) -> f64 {
    let value = with_report_for(page, flags, |report| Some(report.claim(key)?.value));
    value.unwrap_or_else(|| panic!("no claim {key} with {flags}"))
}

/// The value of a claim, to its last bit, in what a page printed for a machine.
pub fn claimed(json: &str, key: &str) -> Option<f64> {
    let claim = json.split(format!("\"key\": \"{key}\", ").as_str()).nth(1)?;
    let value = claim.split("\"value\": ").nth(1)?;
    value.split(',').next()?.parse().ok()
}

/// The lines of the card of effects that this run measures: predicted and measured, to the
/// digits that are printed.
#[track_caller]
pub fn ledger(page: &dyn Page, flags: &str) -> Vec<[f64; 2]> {
    let card = section(page, flags, "effects");
    let at = |name| card.columns().iter().position(|column| column == name).expect("it measures");
    let columns = [at("error if left out"), at("measured")];
    let lines = card.rows().iter().filter(|row| row[columns[1]] != "-");
    let number = |cell: &str| cell.split(' ').next().and_then(|first| first.parse().ok());
    lines.map(|row| columns.map(|i| number(&row[i]).expect("a number"))).collect()
}
