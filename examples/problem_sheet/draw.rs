//! Numbers for a student: drawn, computed, and used only if all of the page's checks hold.

use super::exercise::{Exercise, asked};
use kit::{Claim, Report};
use oorandom::Rand32;

/// So many sets are drawn before one gives up.
const TRIES: u32 = 200;

/// An exercise with the numbers of a student.
pub struct Drawn<'e> {
    pub exercise: &'e Exercise,
    /// The flags that were drawn, and their values as they are typed.
    pub flags: Vec<(String, String)>,
    pub report: Report,
}

impl Drawn<'_> {
    /// The flags as they are typed.
    pub fn typed(&self) -> String {
        let typed = self.flags.iter().map(|(flag, value)| format!("--{flag} {value}"));
        typed.collect::<Vec<_>>().join(" ")
    }
}

/// A number of 64 bits that depends on each byte of `text`: FNV-1a.
pub fn hash(text: &str) -> u64 {
    let mix = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    text.bytes().fold(0xcbf2_9ce4_8422_2325, mix)
}

/// Draws until a set can be used. It depends on the seed, the student and the exercise only, so
/// that a sheet with one more problem, or for one more student, leaves the other numbers.
///
/// # Errors
/// If that takes too long: the last set, and what was wrong with it.
pub fn draw<'e>(exercise: &'e Exercise, seed: u64, student: &str) -> Result<Drawn<'e>, String> {
    let place = format!("{seed}/{student}/{}", exercise.page.stem());
    let mut random = Rand32::new(hash(&place));
    let grids = exercise.page.drawn();
    let mut last = String::new();
    for _ in 0..TRIES {
        let mut typed = |grid: &kit::Grid| grid.typed(random.rand_range(0..grid.count()));
        let one = |(flag, grid): &(String, _)| (flag.clone(), typed(grid));
        let flags: Vec<(String, String)> = grids.iter().map(one).collect();
        match computed(exercise, &flags) {
            Ok(report) => return Ok(Drawn { exercise, flags, report }),
            Err(why) => last = format!("{flags:?}: {why}"),
        }
    }
    let number = &exercise.number;
    Err(format!("{number}: of {TRIES} sets of numbers none can be used; the last, {last}"))
}

/// The flags as numbers.
pub fn numbers(flags: &[(String, String)]) -> Result<Vec<(&str, f64)>, String> {
    let read = flags.iter().map(|(flag, value)| Some((&**flag, value.parse().ok()?)));
    read.collect::<Option<_>>().ok_or_else(|| "a value is no number".into())
}

/// The report for these flags, if it is one that a reader can work with.
pub fn computed(exercise: &Exercise, flags: &[(String, String)]) -> Result<Report, String> {
    let report = exercise.page.report_with(&numbers(flags)?).map_err(|e| e.to_string())?;
    report.output().map_err(|e| e.to_string())?;
    alike(&report, exercise.usual())?;
    Ok(report)
}

/// Whether the box of the page can judge these answers: it asks for the same quantities and knows
/// the same slips. And whether they tell something: none is zero, or what a slip would give,
/// unless that is so on the page.
fn alike(report: &Report, usual: &Report) -> Result<(), String> {
    let (here, there) = (asked(report), asked(usual));
    let keys = |claims: &[&Claim]| claims.iter().map(|c| c.key.clone()).collect::<Vec<_>>();
    if keys(&here) != keys(&there) {
        return Err("the page asks for something else".into());
    }
    let slipping = |claim: &Claim| {
        let within = claim.judged_within * claim.value.abs();
        let near = |slip: &kit::Slip| (slip.value - claim.value).abs() <= within;
        claim.slips.iter().map(near).collect::<Vec<_>>()
    };
    for (here, there) in here.into_iter().zip(there) {
        let hints = |claim: &Claim| claim.slips.iter().map(|s| s.hint.clone()).collect::<Vec<_>>();
        if hints(here) != hints(there) || here.unit != there.unit {
            return Err(format!("the page knows other slips for {}", here.key));
        }
        let new = slipping(here).iter().zip(slipping(there)).any(|(here, there)| *here && !there);
        if new || (here.value == 0.0 && there.value != 0.0) {
            return Err(format!("{} comes out right by mistake, or is zero", here.key));
        }
    }
    Ok(())
}
