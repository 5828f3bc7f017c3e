//! The cheapest setting at which a contestant reaches an error.

use crate::contest::{Ladder, Setting};
use crate::problem::Problem;
use benches::timing::now;
use core::cell::Cell;

/// A run that takes longer than this ends a search (s).
pub const PATIENCE: f64 = 0.3;

/// An error above this tells nothing of the setting: a run far too coarse may well take
/// longer than a finer one (rad).
const LOST: f64 = 0.1;

/// So many coarse runs that take long are waited for.
const LONG_RUNS: u32 = 3;

/// Runs shorter than this are repeated before they are compared (s).
const SHORT: f64 = 0.02;

/// A setting that reaches the error that was asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Found {
    /// The setting.
    pub setting: Setting,
    /// The error that it delivers (rad).
    pub error: f64,
    /// What one run took (s).
    pub seconds: f64,
}

/// What a search gave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// The cheapest setting for each target.
    pub found: [Option<Found>; 4],
    /// The least error seen (rad).
    pub least: f64,
    /// Whether it was the time that ended the search.
    pub impatient: bool,
}

/// Two precisions a decade below a target, the loosest first.
fn precision(rung: i32, target: f64) -> f64 {
    let digits = if rung % 2 == 0 { "3.2" } else { "1" };
    let exponent = target.log10().round() as i32 - 1 - rung / 2;
    format!("{digits}e{exponent}").parse().unwrap_or(0.0)
}

/// Ten tolerances a decade, the loosest first; each is a decimal number of few digits.
fn tolerance(rung: usize) -> Setting {
    const STEPS: [&str; 10] = ["8", "6.3", "5", "4", "3.2", "2.5", "2", "1.6", "1.25", "1"];
    let text = format!("{}e-{}", STEPS[rung % 10], rung / 10 + 2);
    Setting::Tolerance(text.parse().unwrap_or(1.0))
}

/// Twenty numbers of steps a decade, from half a step a period.
fn steps(rung: usize, problem: &Problem) -> u64 {
    let periods = problem.end / problem.period;
    (0.5 * periods * 10_f64.powf(rung as f64 / 20.0)).ceil() as u64
}

/// A ladder as a function of its rung, with its length and its stride at first.
struct Rungs<'a> {
    setting: &'a dyn Fn(usize) -> Setting,
    count: usize,
    stride: usize,
}

/// Runs at a setting and gives the error.
pub type Measure<'a> = &'a dyn Fn(Setting) -> Result<f64, String>;

struct Search<'a> {
    measure: Measure<'a>,
    targets: [f64; 4],
    least: Cell<f64>,
    impatient: Cell<bool>,
    long_runs: Cell<u32>,
}

impl Search<'_> {
    fn run(&self, setting: Setting) -> Option<Found> {
        let timed = || {
            let start = now();
            let error = (self.measure)(setting);
            (error, now() - start)
        };
        let (error, mut seconds) = timed();
        let found = error.as_ref().is_ok_and(|error| *error < LOST);
        if seconds > PATIENCE {
            self.long_runs.set(self.long_runs.get() + 1);
            self.impatient.set(found || self.long_runs.get() > LONG_RUNS);
        }
        let error = error.ok()?;
        if seconds < SHORT {
            seconds = seconds.min(timed().1).min(timed().1);
        }
        self.least.set(self.least.get().min(error));
        Some(Found { setting, error, seconds })
    }

    /// Climbs from the cheapest rung by strides until every target is reached or a run
    /// takes too long, then halves the stride in which each is reached first.
    fn climb(&self, rungs: &Rungs) -> [Option<Found>; 4] {
        let mut seen: Vec<Option<Found>> = vec![None; rungs.count];
        let mut reached = [None; 4];
        for rung in (0..rungs.count).step_by(rungs.stride) {
            seen[rung] = self.run((rungs.setting)(rung));
            if let Some(found) = seen[rung] {
                for (reached, target) in reached.iter_mut().zip(self.targets) {
                    if reached.is_none() && found.error <= target {
                        *reached = Some(rung);
                    }
                }
            }
            if reached[3].is_some() || self.impatient.get() {
                break;
            }
        }
        let mut best = [None; 4];
        for ((best, reached), target) in best.iter_mut().zip(reached).zip(self.targets) {
            let Some(mut high) = reached else { continue };
            let mut low = high.saturating_sub(rungs.stride);
            while high - low > 1 {
                let middle = low.midpoint(high);
                if seen[middle].is_none() {
                    seen[middle] = self.run((rungs.setting)(middle));
                }
                match seen[middle] {
                    Some(found) if found.error <= target => high = middle,
                    _ => low = middle,
                }
            }
            *best = seen[high];
        }
        best
    }

    /// Solves the stages no better than the target needs, with a few more steps if that
    /// pays, or fewer: rungs are an eighth apart, those of tolerances much less in time.
    fn cheaper_stages(&self, best: &mut Option<Found>, target: f64) {
        let Some(Setting::Stages(fewest, _)) = best.map(|found| found.setting) else {
            return;
        };
        for rung in 0..8 {
            let precision = precision(rung, target);
            for more in [0.95, 1.0, 1.06, 1.12, 1.26] {
                let steps = (fewest as f64 * more).ceil() as u64;
                let found = self.run(Setting::Stages(steps, precision));
                if let Some(found) = found.filter(|found| found.error <= target) {
                    if best.is_none_or(|best| found.seconds < best.seconds) {
                        *best = Some(found);
                    }
                    break;
                }
            }
        }
    }
}

/// The cheapest settings on `ladder` at which `measure` gives each target, the largest
/// target first.
pub fn search(ladder: Ladder, problem: &Problem, targets: [f64; 4], measure: Measure) -> Outcome {
    let search = Search {
        measure,
        targets,
        least: Cell::new(f64::INFINITY),
        impatient: Cell::new(false),
        long_runs: Cell::new(0),
    };
    let found = match ladder {
        Ladder::Exact => {
            let found = search.run(Setting::Exact);
            targets.map(|target| found.filter(|found| found.error <= target))
        }
        Ladder::Tolerances => search.climb(&Rungs { setting: &tolerance, count: 160, stride: 10 }),
        Ladder::Steps => search.climb(&Rungs {
            setting: &|rung| Setting::Steps(steps(rung, problem)),
            count: 80,
            stride: 6,
        }),
        Ladder::Stages => {
            let mut found = search.climb(&Rungs {
                setting: &|rung| Setting::Stages(steps(rung, problem), 0.0),
                count: 60,
                stride: 4,
            });
            for (found, target) in found.iter_mut().zip(targets) {
                search.cheaper_stages(found, target);
            }
            found
        }
    };
    Outcome { found, least: search.least.get(), impatient: search.impatient.get() }
}
