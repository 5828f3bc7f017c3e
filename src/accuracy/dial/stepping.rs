//! The dial of what must be stepped: choose, refine, verify.

use super::method::{LEVEL, Method};
use super::problem::{Feeler, Problem};
use super::verdict::{APART, Gap, Verdict};
use super::{Solvable, Solved};
use crate::body::State;
use crate::error::{Error, Result};
use crate::integrators::Work;
use crate::math::{EPS, log};

/// The angle (rad) turned at the slowest candidate's rate on which the candidates are compared.
const STRETCH: f64 = core::f64::consts::TAU;

/// Rows of the design for the condition: so few estimate what all twelve give.
const ROWS: usize = 2;

/// Legs, at most, before each of which the state is moved.
const LEGS: usize = 64;

/// And so many of both where the floor comes near to the tolerance.
const MORE_ROWS: usize = 5;
const MORE_LEGS: usize = 512;

/// Nearer than by this factor.
const NEAR: f64 = 1e3;

/// The error at which the condition is felt: nothing is gained by a finer run.
const FELT: f64 = 1e-3;

/// And where the floor comes near: a coarse run may pass a saddle at another distance.
const FELT_WELL: f64 = 1e-6;

/// The part of the error asked for that the sweeps of Gauss-Legendre may leave.
const SWEEPS: f64 = 0.1;

/// An error that is reached, and no more than so many times the floor, is round-off.
const ROUND_OFF: f64 = 16.0;

/// What was returned by a run, and at which level.
struct Run {
    level: f64,
    state: State,
    work: Work,
}

/// A method, and what it did on the first stretch.
#[derive(Debug, Clone, Copy)]
struct Candidate {
    method: Method,
    /// At this level it made this error (rad) at this cost.
    level: f64,
    error: f64,
    cost: f64,
}

impl Candidate {
    /// The level at which it makes this error on the stretch.
    fn level(&self, error: f64) -> f64 {
        self.level + log(self.error / error) / LEVEL
    }

    /// What that costs.
    fn cost(&self, error: f64) -> f64 {
        self.cost * self.method.dearer(self.level(error) - self.level)
    }
}

/// A run that delivered, or the least error that was reached.
enum Outcome {
    Delivered { run: Run, estimate: f64 },
    Reached(f64),
}

pub(super) struct Stepping<'p, 'e, E> {
    problem: &'p Problem<'e, E>,
    tolerance: f64,
    work: Work,
}

impl<'p, 'e, E: Solvable> Stepping<'p, 'e, E> {
    pub fn new(problem: &'p Problem<'e, E>, tolerance: f64) -> Self {
        Self {
            problem,
            tolerance,
            work: Work::default(),
        }
    }

    /// Solves by the cheapest candidate that can be verified.
    pub fn solve(mut self) -> Result<Solved> {
        let (mut candidates, part) = self.candidates();
        if candidates.is_empty() {
            // No level worked: say why the first did not.
            let method = Method::candidates(self.problem)[0];
            self.run(method, self.problem.t_end, 0.0, 1, 0.0)?;
        }
        // Errors grow with the time at least.
        let wanted = AIM * self.tolerance * part;
        candidates.sort_by(|a, b| a.cost(wanted).total_cmp(&b.cost(wanted)));
        let lowest = (candidates.iter())
            .map(|candidate| candidate.method.floor())
            .fold(f64::INFINITY, f64::min);
        let mut condition = self.condition(&candidates, FELT * part, ROWS, LEGS)?;
        if NEAR * lowest * EPS * (1.0 + condition) > self.tolerance {
            condition = self.condition(&candidates, FELT_WELL * part, MORE_ROWS, MORE_LEGS)?;
        }
        let floor = lowest * EPS * (1.0 + condition);
        if floor.is_nan() || floor >= self.tolerance {
            return Err(self.beyond(floor, condition));
        }
        let mut reached = f64::INFINITY;
        let mut last = None;
        for candidate in candidates {
            match self.deliver(candidate.method, candidate.level(wanted), condition) {
                Ok(Outcome::Delivered { run, estimate }) => {
                    return Ok(Solved {
                        state: run.state,
                        method: candidate.method.name(),
                        run: run.work,
                        work: self.work,
                        estimate,
                        condition,
                    });
                }
                Ok(Outcome::Reached(error)) => reached = reached.min(error),
                Err(error) => last = Some(error),
            }
        }
        match last {
            // Near the floor, what runs differ by is round-off.
            _ if reached < ROUND_OFF * floor => Err(self.beyond(reached, condition)),
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

    /// One run; its work is counted.
    fn run(
        &mut self,
        method: Method,
        t_end: f64,
        level: f64,
        fewest: u64,
        precision: f64,
    ) -> Result<Run> {
        let (state, work) = {
            let problem = self.problem;
            method.run(
                problem,
                [0.0, t_end],
                &problem.start,
                level,
                fewest,
                precision,
            )?
        };
        self.work += work;
        // Steps are whole: the level is that of the steps taken.
        let level = if method.is_adaptive() {
            level
        } else {
            method.level_of(self.problem, t_end, work.steps as f64)
        };
        Ok(Run { level, state, work })
    }

    /// The first run of the whole span, at this level or at the first finer one that
    /// comes to its end.
    fn first(&mut self, method: Method, level: f64, precision: f64) -> Result<Run> {
        let mut level = level;
        loop {
            match self.run(method, self.problem.t_end, level, 1, precision) {
                Ok(run) => return Ok(run),
                Err(error @ Error::TooManySteps { .. }) => return Err(error),
                Err(error) if level + 1.0 > method.finest() => return Err(error),
                Err(_) => level += 1.0,
            }
        }
    }

    /// The candidates: each runs twice on the first stretch of the motion, and the
    /// distance of its two ends is its error constant. Also the part of the span that
    /// the stretch is.
    fn candidates(&mut self) -> (Vec<Candidate>, f64) {
        let methods = Method::candidates(self.problem);
        let slowest = (methods.iter())
            .map(|method| method.rate(self.problem))
            .fold(f64::INFINITY, f64::min);
        let whole = self.problem.t_end;
        let part = (STRETCH / (slowest * whole.abs())).min(1.0);
        let tried = methods
            .into_iter()
            .filter_map(|method| self.tried(method, part * whole, part))
            .collect();
        (tried, part)
    }

    /// What the method does on the stretch.
    fn tried(&mut self, method: Method, stretch: f64, part: f64) -> Option<Candidate> {
        let precision = (SWEEPS * self.tolerance * part).min(1e-6);
        let mut level = method.coarsest().max(0.0);
        while level + 1.0 <= method.finest() {
            if let Ok(coarse) = self.run(method, stretch, level, 1, precision)
                && let Ok(fine) = self.next(method, stretch, &coarse, 1.0, precision)
            {
                let error = distance(&coarse, &fine);
                // Not so for a NaN.
                if error < APART {
                    return Some(Candidate {
                        method,
                        level: coarse.level,
                        error: error.max(EPS),
                        cost: method.cost(self.problem, &coarse.work),
                    });
                }
            }
            level += 2.0;
        }
        None
    }

    /// Refines until the runs agree as they must, or as they can. At `level` the method
    /// is predicted to deliver.
    fn deliver(&mut self, method: Method, level: f64, condition: f64) -> Result<Outcome> {
        let highest = method.finest();
        let floor = method.floor() * EPS * (1.0 + condition);
        if floor.is_nan() || floor >= self.tolerance {
            return Ok(Outcome::Reached(floor));
        }
        // What the sweeps leave of a step grows like any error: it must stay far below.
        let mut precision = if method.sweeps() {
            (SWEEPS * (self.tolerance - floor) / (1.0 + condition)).min(1e-6)
        } else {
            0.0
        };
        let left = |precision: f64| floor + precision * (1.0 + condition);
        let mut budget = self.tolerance - left(precision);
        let coarse = (level - 2.0).clamp(method.coarsest(), highest - 2.0);
        let mut runs = vec![self.first(method, coarse, precision)?];
        let mut ahead = (level - 1.0 - runs[0].level).clamp(0.5, 2.0);
        let mut gaps = Vec::new();
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
            let next = self.next(method, self.problem.t_end, last, ahead, precision)?;
            gaps.push(Gap {
                apart: distance(last, &next),
                step: next.level - last.level,
            });
            runs.push(next);
            let verdict = Verdict::of(method.trust(), &gaps);
            if verdict.estimate <= budget {
                let run = runs.swap_remove(runs.len() - 1);
                let estimate = verdict.estimate + left(precision);
                return Ok(Outcome::Delivered { run, estimate });
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

    /// A run finer by so many levels, and by one step at least.
    fn next(
        &mut self,
        method: Method,
        t_end: f64,
        last: &Run,
        ahead: f64,
        precision: f64,
    ) -> Result<Run> {
        let fewest = last.work.steps + 1;
        self.run(method, t_end, last.level + ahead, fewest, precision)
    }

    /// The condition, felt by the method that is cheapest where it is felt.
    fn condition(
        &mut self,
        candidates: &[Candidate],
        felt: f64,
        rows: usize,
        most_legs: usize,
    ) -> Result<f64> {
        let problem = self.problem;
        let cheapest = candidates
            .iter()
            .filter(|candidate| !candidate.method.is_adaptive())
            .min_by(|a, b| a.cost(felt).total_cmp(&b.cost(felt)))
            .or(candidates.first());
        let Some(candidate) = cheapest else {
            return Err(Error::NotDelivered {
                requested: self.tolerance,
                reached: f64::INFINITY,
            });
        };
        let method = candidate.method;
        let mut level = if method.is_adaptive() {
            // It answers a small change with a small jump, of its error.
            5.0
        } else {
            candidate.level(felt).max(method.coarsest())
        };
        // Every two radians at most: what passes a saddle must be moved on its way there.
        let legs = 0.5 * method.turned(problem, problem.t_end);
        let legs = legs.clamp(1.0, most_legs as f64) as usize;
        let mut work = Work::default();
        let condition = problem.condition(&Feeler::STEPPED, |by| {
            // What the sweeps leave must not be mistaken for a change.
            let precision = 1e-3 * by;
            let mut run = |row, by, level| {
                problem.in_legs(row, by, legs, |problem, t, state, t_end| {
                    let (state, spent) =
                        method.run(problem, [t, t_end], state, level, 1, precision)?;
                    work += spent;
                    Ok(state)
                })
            };
            let end = loop {
                match run(0, 0.0, level) {
                    Err(_) if level + 1.0 <= method.finest() => level += 1.0,
                    end => break end?,
                }
            };
            let changed = (0..rows).map(|row| run(row, by, level));
            Ok((end, changed.collect::<Result<_>>()?))
        });
        self.work += work;
        condition
    }
}

/// The error aimed at, as a part of the tolerance: what the last run is predicted to
/// deliver. Half of what can be verified, and that is a part of 1/sqrt(40).
const AIM: f64 = 0.02;

fn distance(a: &Run, b: &Run) -> f64 {
    a.state.attitude.angle_to(&b.state.attitude)
}
