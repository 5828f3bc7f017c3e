//! The dial of what must be stepped: choose, refine, verify.

use super::choice::{Candidate, Candidates};
use super::limits::Limits;
use super::method::{Fine, Method, Runs, Steps};
use super::probes::{Begun, Felt};
use super::problem::{Apart, Problem};
use super::verdict::{Gap, Verdict};
use crate::accuracy::larger;
use crate::body::State;
use crate::error::{Error, Result};
use crate::integrators::Work;
use crate::math::{EPS, sort_by_number};
use core::sync::atomic::Ordering;

/// Runs whose predicted errors (rad) are larger than this may agree by chance.
const LINEAR: f64 = 0.5;

/// Runs that are so many times further apart than their errors on the stretch and the
/// condition of the motion predict are no runs of that motion.
const UNLIKE: f64 = 10.0;

/// Runs further apart than this (rad) are none on which a condition may be felt.
const ELSEWHERE: f64 = 0.2;

/// The part of the error asked for that the sweeps of Gauss-Legendre may leave.
pub(super) const SWEEPS: f64 = 0.1;

/// What the sweeps leave of n steps is the condition times this times sqrt(n) times what
/// they leave of one. Measured on free bodies over up to 2e4 steps: 0.22.
const SWEPT: f64 = 0.25;

/// What rounding adds to the attitude in a step of DOP853, in units of eps. Measured on
/// runs of up to a million steps: 0.15.
const ROUNDED: f64 = 0.5;

/// An error that is reached, and no more than so many times the floor, is round-off.
const ROUND_OFF: f64 = 16.0;

/// Where a run was at the places looked at, at which level, and what it cost.
pub(super) struct Run {
    pub level: f64,
    pub places: Vec<State>,
    /// What it took on the pieces of the way to each place.
    pub steps: Vec<Vec<Steps>>,
    pub work: Work,
    longest_step: f64,
    /// Where it was between two pieces, and at the end.
    pub passed: Vec<(f64, State)>,
}

/// What a run delivers.
pub(super) struct Delivered {
    pub method: Method,
    pub level: f64,
    pub precision: f64,
    pub places: Vec<State>,
    pub steps: Vec<Vec<Steps>>,
    pub run: Work,
    pub work: Work,
    pub choice: Work,
    pub probes: Work,
    /// Upper estimates of the three errors, at the place where each is largest.
    pub estimate: Apart,
    pub condition: Apart,
    pub longest_step: f64,
}

/// A run that delivered, or the least error that was reached; or runs that differ more than
/// the condition lets them.
enum Outcome {
    Delivered(Box<Delivered>),
    Reached(f64),
    Unlike,
}

pub(super) struct Stepping<'p> {
    pub problem: &'p Problem<'p>,
    pub tolerance: f64,
    limits: &'p Limits<'p>,
    /// Where the motion is looked at, from the start to the end.
    pub times: Vec<f64>,
    pub work: Work,
    /// What of that went into the choice of the method, and into the condition.
    choice: Work,
    pub probes: Work,
}

impl<'p> Stepping<'p> {
    /// With the motion looked at in so many places, of equal distances; the end is the last.
    pub fn new(
        problem: &'p Problem<'p>,
        tolerance: f64,
        limits: &'p Limits<'p>,
        places: usize,
    ) -> Self {
        Self {
            problem,
            tolerance,
            limits,
            times: (0..=places).map(|n| problem.at_leg(n, places)).collect(),
            work: Work::default(),
            choice: Work::default(),
            probes: Work::default(),
        }
    }

    /// Solves by the cheapest candidate that can be verified.
    pub fn solve(mut self) -> Result<Delivered> {
        let Candidates {
            all: mut candidates,
            mut untried,
            part,
            wanted,
            lowest,
        } = self.candidates()?;
        self.choice = self.work;
        sort_by_number(&mut candidates, |candidate| candidate.cost(wanted));
        let (mut felt, mut begun) = match self.begin(&candidates[0], wanted, part, lowest)? {
            Some((felt, begun)) => (felt, Some(begun)),
            None => (self.feel(&candidates, part, lowest)?, None),
        };
        let (mut reached, mut last) = (f64::INFINITY, None);
        let mut now = 0;
        loop {
            if now == candidates.len() {
                // None of those that were tried delivers.
                let Some(method) = untried.pop() else { break };
                match self.tried(method, part) {
                    Ok(candidate) => candidates.push(candidate),
                    Err(error) if is_final(&error) => return Err(error),
                    Err(error) => last = Some(error),
                }
                continue;
            }
            let candidate = &candidates[now];
            let floor = lowest * EPS * (1.0 + felt.condition[0]);
            if floor.is_nan() || floor >= self.tolerance {
                return Err(self.beyond(floor, felt.condition[0]));
            }
            match self.deliver(candidate, wanted, &felt, begun.take()) {
                Ok(Outcome::Delivered(delivered)) => {
                    return Ok(Delivered {
                        work: self.work,
                        probes: self.probes,
                        ..*delivered
                    });
                }
                Ok(Outcome::Unlike) => {
                    felt = self.feel_finely(&candidates, part)?;
                    continue;
                }
                Ok(Outcome::Reached(error)) => {
                    reached = reached.min(error);
                    // They come to no end where they should.
                    if !felt.finely {
                        felt = self.feel_finely(&candidates, part)?;
                    }
                }
                Err(error) if is_final(&error) => return Err(error),
                Err(error) => last = Some(error),
            }
            now += 1;
        }
        let floor = lowest * EPS * (1.0 + felt.condition[0]);
        if floor.is_nan() || floor >= self.tolerance {
            return Err(self.beyond(floor, felt.condition[0]));
        }
        match last {
            // Near the floor, what runs differ by is round-off.
            _ if reached < ROUND_OFF * floor => Err(self.beyond(reached, felt.condition[0])),
            Some(error) if reached == f64::INFINITY => Err(error),
            _ => Err(Error::NotDelivered {
                requested: self.tolerance,
                reached,
            }),
        }
    }

    fn beyond(&self, attainable: f64, condition: f64) -> Error {
        Error::BeyondCondition {
            requested: self.tolerance,
            attainable,
            condition,
        }
    }

    /// What is left of the budget after all runs so far and this work, if the solution may go
    /// on.
    pub fn left(&self, more: &Work) -> Result<u64> {
        let torques = self.work.torques() + more.torques();
        if (self.limits.cancel).is_some_and(|cancel| cancel.load(Ordering::Relaxed)) {
            return Err(Error::Cancelled { torques });
        }
        Ok(self.limits.budget.saturating_sub(torques))
    }

    /// One run through these times, with so many steps on each leg at least; its work is
    /// counted.
    pub fn run(
        &mut self,
        method: Method,
        times: &[f64],
        level: f64,
        fewest: &[Vec<Steps>],
        precision: f64,
    ) -> Result<Run> {
        self.run_of(self.problem, method, times, level, fewest, precision)
    }

    /// The same of a problem that is a little changed.
    pub fn run_of(
        &mut self,
        problem: &Problem,
        method: Method,
        times: &[f64],
        level: f64,
        fewest: &[Vec<Steps>],
        precision: f64,
    ) -> Result<Run> {
        let legs = times.len() - 1;
        let mut run = Run {
            level: f64::INFINITY,
            places: Vec::with_capacity(legs),
            steps: Vec::with_capacity(legs),
            work: Work::default(),
            longest_step: 0.0,
            passed: Vec::new(),
        };
        let mut state = problem.start;
        for (n, leg) in times.windows(2).enumerate() {
            let fine = Fine {
                level,
                fewest: fewest.get(n).map_or(&[], Vec::as_slice),
                precision,
                budget: self.left(&Work::default())?,
            };
            let mut runs = Runs::default();
            let passed = method.run(problem, [leg[0], leg[1]], &state, fine, &mut runs);
            self.work += runs.work;
            let passed = passed.map_err(|error| self.over_budget(error))?;
            run.steps.push(runs.pieces);
            run.passed.append(&mut runs.passed);
            run.work += passed.work;
            run.level = run.level.min(passed.level);
            run.longest_step = run.longest_step.max(passed.longest_step);
            state = passed.state;
            run.places.push(state);
        }
        Ok(run)
    }

    /// A budget that is used up is told as it was given, for the whole span.
    pub fn over_budget(&self, error: Error) -> Error {
        match error {
            Error::OverBudget { .. } => Error::OverBudget {
                t: self.problem.t_start,
                t_end: self.problem.t_end,
                budget: self.limits.budget,
            },
            error => error,
        }
    }

    /// The first run of the whole span, at this level or at the first finer one that
    /// comes to its end.
    pub fn first(&mut self, method: Method, level: f64, precision: f64) -> Result<Run> {
        let mut level = level;
        loop {
            match self.run(method, &self.times.clone(), level, &[], precision) {
                Ok(run) => return Ok(run),
                Err(error) if stops(&error) => return Err(error),
                Err(error) if level + 1.0 > method.finest() => return Err(error),
                Err(_) => level += 1.0,
            }
        }
    }

    /// How far two runs are apart, each measure at the place where it is largest.
    pub fn distance(&self, a: &Run, b: &Run) -> Apart {
        let mut most = [0.0; 3];
        for (a, b) in a.places.iter().zip(&b.places) {
            for (most, apart) in most.iter_mut().zip(self.problem.apart(a, b)) {
                *most = larger(*most, apart);
            }
        }
        most
    }

    /// Refines until the runs agree as they must, or as they can. The error `wanted` on the
    /// stretch is predicted to deliver.
    fn deliver(
        &mut self,
        candidate: &Candidate,
        wanted: f64,
        felt: &Felt,
        begun: Option<Begun>,
    ) -> Result<Outcome> {
        let (method, level) = (candidate.method, candidate.level(wanted));
        let highest = method.finest();
        let conditions = felt.condition;
        let condition = conditions[0];
        let floors = conditions.map(|condition| method.floor() * EPS * (1.0 + condition));
        let floor = floors[0];
        if floor.is_nan() || floor >= self.tolerance {
            return Ok(Outcome::Reached(floor));
        }
        // What the sweeps leave of a step grows like any error, and those of many steps add
        // up as what is thrown at random does: it must stay far below.
        let swept = self.swept(method, level);
        let mut precision = if method.sweeps() {
            (SWEEPS * (self.tolerance - floor) / (swept * (1.0 + condition))).min(1e-6)
        } else {
            0.0
        };
        let left = |precision: f64| floor + precision * swept * (1.0 + condition);
        let mut budget = self.tolerance - left(precision);
        let linear = candidate.level(LINEAR / (1.0 + condition));
        let coarse = (level - method.behind()).max(linear);
        let coarse = coarse.clamp(method.coarsest(), highest - 2.0);
        let first = match begun {
            Some(begun) if begun.run.level >= linear && begun.precision <= 2.0 * precision => {
                precision = begun.precision;
                budget = self.tolerance - left(precision);
                begun.run
            }
            _ => self.first(method, coarse, precision)?,
        };
        let mut runs = vec![first];
        // Two runs may do, of what is smooth and does not wait for its time.
        let expected =
            (!self.problem.is_abrupt()).then(|| candidate.error(runs[0].level) / felt.part);
        let two = if expected.is_some() { 0.0 } else { 1.0 };
        let mut ahead = (level - two - runs[0].level).clamp(0.5, 2.0);
        let mut gaps = [const { Vec::new() }; 3];
        let (mut best, mut stuck) = (f64::INFINITY, 0);
        loop {
            let last = &runs[runs.len() - 1];
            if stuck > 1 && precision > 0.0 {
                // It may be the sweeps that differ.
                (precision, stuck) = (0.0, 0);
                budget = self.tolerance - left(precision);
            } else if last.level + 0.1 >= highest || stuck > 2 {
                return Ok(Outcome::Reached(best + floor));
            }
            ahead = ahead.min(highest - last.level);
            let next = self.next(method, &self.times.clone(), last, ahead, precision)?;
            let step = next.level - last.level;
            let apart = self.distance(last, &next);
            let stretches = candidate.error(last.level) / felt.part;
            let predicted = left(precision) + stretches * (1.0 + condition);
            // A torque that depends on the time may not have been there on the stretch.
            let told = !felt.finely && !self.problem.acting.on_time();
            let elsewhere = felt.roughly && apart[0] > ELSEWHERE;
            if elsewhere || told && apart[0] > UNLIKE * predicted {
                return Ok(Outcome::Unlike);
            }
            for (gaps, apart) in gaps.iter_mut().zip(apart) {
                gaps.push(Gap { apart, step });
            }
            runs.push(next);
            let mut verdict = Verdict::of(method.trust(), &gaps[0], expected);
            let steps = runs[runs.len() - 1].work.steps as f64;
            if method.is_adaptive() {
                verdict.estimate += ROUNDED * EPS * steps;
            }
            if verdict.estimate <= budget {
                let run = runs.swap_remove(runs.len() - 1);
                let [_, momentum, rates] = [0, 1, 2].map(|n| {
                    Verdict::of(method.trust(), &gaps[n], expected).estimate
                        + floors[n]
                        + precision * swept * (1.0 + conditions[n])
                });
                return Ok(Outcome::Delivered(Box::new(Delivered {
                    method,
                    level: run.level,
                    precision,
                    places: run.places,
                    steps: run.steps,
                    run: run.work,
                    work: self.work,
                    choice: self.choice,
                    probes: self.probes,
                    estimate: [verdict.estimate + left(precision), momentum, rates],
                    condition: conditions,
                    longest_step: run.longest_step,
                })));
            }
            stuck = if verdict.estimate < 0.5 * best {
                0
            } else {
                stuck + 1
            };
            best = best.min(verdict.estimate);
            ahead = verdict.ahead(budget);
        }
    }

    /// What the sweeps of a run of this level leave, in units of what they leave of a step.
    pub fn swept(&self, method: Method, level: f64) -> f64 {
        1.0 + SWEPT
            * method
                .steps(self.problem, self.problem.span(), level)
                .sqrt()
    }

    /// A run finer by so many levels, and by one step at least on every piece.
    pub fn next(
        &mut self,
        method: Method,
        times: &[f64],
        last: &Run,
        ahead: f64,
        precision: f64,
    ) -> Result<Run> {
        let finer = |leg: &Vec<Steps>| leg.iter().map(|steps| steps.finer(method, ahead)).collect();
        let fewest: Vec<Vec<Steps>> = last.steps.iter().map(finer).collect();
        self.run(method, times, last.level + ahead, &fewest, precision)
    }
}

/// True of errors that no other method would mend.
pub(super) const fn is_final(error: &Error) -> bool {
    matches!(error, Error::Cancelled { .. } | Error::Contradiction { .. })
}

/// True of errors that no finer run would mend.
pub(super) const fn stops(error: &Error) -> bool {
    is_final(error) || matches!(error, Error::OverBudget { .. })
}
