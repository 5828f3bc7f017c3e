//! The dial of what must be stepped: choose, refine, verify.

use super::limits::Limits;
use super::method::{Fine, LEVEL, Method, Runs, Steps};
use super::problem::{Apart, Feeler, Problem};
use super::verdict::{APART, Gap, Verdict};
use crate::accuracy::larger;
use crate::body::State;
use crate::error::{Error, Result};
use crate::integrators::Work;
use crate::math::{EPS, exp, log, sort_by_number};
use core::sync::atomic::Ordering;

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

/// A condition felt on a motion that is itself off by more than this (rad) is that of
/// another motion: it is felt again where the error is smaller by so much, down to the last.
const ELSEWHERE: f64 = 1.5;
const FINER: f64 = 1e-3;
const FELT_FINELY: f64 = 1e-12;

/// Runs whose predicted errors (rad) are larger than this may agree by chance.
const LINEAR: f64 = 0.5;

/// Runs that are so many times further apart than their errors on the stretch and the
/// condition of the motion predict are no runs of that motion.
const UNLIKE: f64 = 10.0;

/// The part of the error asked for that the sweeps of Gauss-Legendre may leave.
const SWEEPS: f64 = 0.1;

/// What the sweeps leave of n steps is the condition times this times sqrt(n) times what
/// they leave of one. Measured on free bodies over up to 2e4 steps: 0.22.
const SWEPT: f64 = 0.25;

/// What rounding adds to the attitude in a step of DOP853, in units of eps. Measured on
/// runs of up to a million steps: 0.15.
const ROUNDED: f64 = 0.5;

/// An error that is reached, and no more than so many times the floor, is round-off.
const ROUND_OFF: f64 = 16.0;

/// Where a run was at the places looked at, at which level, and what it cost.
struct Run {
    level: f64,
    places: Vec<State>,
    /// What it took on the pieces of the way to each place.
    steps: Vec<Vec<Steps>>,
    work: Work,
    longest_step: f64,
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
    /// Upper estimates of the three errors, at the place where each is largest.
    pub estimate: Apart,
    pub condition: Apart,
    pub longest_step: f64,
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

    /// The error that it makes on the stretch at this level.
    fn error(&self, level: f64) -> f64 {
        self.error * exp(LEVEL * (self.level - level))
    }

    /// What that costs.
    fn cost(&self, error: f64) -> f64 {
        self.cost * self.method.dearer(self.level(error) - self.level)
    }
}

/// A condition as it was felt.
struct Felt {
    condition: Apart,
    /// The part of the span on which the candidates were compared.
    part: f64,
    /// Nothing is gained by a finer motion.
    finely: bool,
}

/// A run that delivered, or the least error that was reached; or runs that differ more than
/// the condition lets them.
enum Outcome {
    Delivered(Box<Delivered>),
    Reached(f64),
    Unlike,
}

pub(super) struct Stepping<'p> {
    problem: &'p Problem<'p>,
    tolerance: f64,
    limits: &'p Limits<'p>,
    /// Where the motion is looked at, from the start to the end.
    times: Vec<f64>,
    work: Work,
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
        }
    }

    /// Solves by the cheapest candidate that can be verified.
    pub fn solve(mut self) -> Result<Delivered> {
        let (mut candidates, part) = self.candidates()?;
        // Errors grow with the time at least.
        let wanted = AIM * self.tolerance * part;
        sort_by_number(&mut candidates, |candidate| candidate.cost(wanted));
        let lowest = (candidates.iter())
            .map(|candidate| candidate.method.floor())
            .fold(f64::INFINITY, f64::min);
        let mut felt = self.feel(&candidates, part)?;
        let (mut reached, mut last) = (f64::INFINITY, None);
        let mut untried = candidates.iter();
        let mut next = untried.next();
        while let Some(candidate) = next {
            let floor = lowest * EPS * (1.0 + felt.condition[0]);
            if floor.is_nan() || floor >= self.tolerance {
                return Err(self.beyond(floor, felt.condition[0]));
            }
            match self.deliver(candidate, wanted, &felt) {
                Ok(Outcome::Delivered(delivered)) => {
                    return Ok(Delivered {
                        work: self.work,
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
            next = untried.next();
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

    /// The condition, felt on a motion that is good enough for it.
    fn feel(&mut self, candidates: &[Candidate], part: f64) -> Result<Felt> {
        // Adaptive methods feel it finely at once.
        let mut felt = Felt {
            condition: self.condition(candidates, FELT * part, ROWS, LEGS)?,
            part,
            finely: candidates.iter().all(|c| c.method.is_adaptive()),
        };
        let mut error = FELT;
        // The motion that was felt is off by its own error, as much as the condition makes
        // of that: on another side of a saddle, say.
        while !felt.finely && (1.0 + felt.condition[0]) * error * part > ELSEWHERE {
            error = (error * FINER).max(FELT_FINELY);
            felt.finely = error == FELT_FINELY;
            felt.condition = self.condition(candidates, error * part, ROWS, LEGS)?;
        }
        let lowest = candidates
            .iter()
            .map(|c| c.method.floor())
            .fold(f64::INFINITY, f64::min);
        if NEAR * lowest * EPS * (1.0 + felt.condition[0]) > self.tolerance {
            let error = error.min(FELT_WELL);
            felt.condition = self.condition(candidates, error * part, MORE_ROWS, MORE_LEGS)?;
        }
        Ok(felt)
    }

    /// The same where runs have shown that the motion is not the one that was felt.
    fn feel_finely(&mut self, candidates: &[Candidate], part: f64) -> Result<Felt> {
        Ok(Felt {
            condition: self.condition(candidates, FELT_FINELY * part, MORE_ROWS, MORE_LEGS)?,
            part,
            finely: true,
        })
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
    fn left(&self, more: &Work) -> Result<u64> {
        let torques = self.work.torques() + more.torques();
        if (self.limits.cancel).is_some_and(|cancel| cancel.load(Ordering::Relaxed)) {
            return Err(Error::Cancelled { torques });
        }
        Ok(self.limits.budget.saturating_sub(torques))
    }

    /// One run through these times, with so many steps on each leg at least; its work is
    /// counted.
    fn run(
        &mut self,
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
        };
        let mut state = self.problem.start;
        for (n, leg) in times.windows(2).enumerate() {
            let fine = Fine {
                level,
                fewest: fewest.get(n).map_or(&[], Vec::as_slice),
                precision,
                budget: self.left(&Work::default())?,
            };
            let mut runs = Runs::default();
            let passed = method.run(self.problem, [leg[0], leg[1]], &state, fine, &mut runs);
            self.work += runs.work;
            let passed = passed.map_err(|error| self.over_budget(error))?;
            run.steps.push(runs.pieces);
            run.work += passed.work;
            run.level = run.level.min(passed.level);
            run.longest_step = run.longest_step.max(passed.longest_step);
            state = passed.state;
            run.places.push(state);
        }
        Ok(run)
    }

    /// A budget that is used up is told as it was given, for the whole span.
    fn over_budget(&self, error: Error) -> Error {
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
    fn first(&mut self, method: Method, level: f64, precision: f64) -> Result<Run> {
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

    /// The candidates: each runs twice on the first stretch of the motion, and the
    /// distance of its two ends is its error constant. Also the part of the span that
    /// the stretch is.
    ///
    /// # Errors
    /// Why the last of them failed, if all did.
    fn candidates(&mut self) -> Result<(Vec<Candidate>, f64)> {
        let methods = Method::candidates(self.problem);
        let slowest = (methods.iter())
            .map(|method| method.rate(self.problem))
            .fold(f64::INFINITY, f64::min);
        let whole = self.problem.span();
        let part = (STRETCH / (slowest * whole.abs())).min(1.0);
        let (mut all, mut why) = (Vec::new(), None);
        for method in methods {
            match self.tried(method, part * whole, part) {
                Ok(candidate) => all.push(candidate),
                Err(error) if is_final(&error) => return Err(error),
                Err(error) => why = Some(error),
            }
        }
        match why {
            Some(error) if all.is_empty() => Err(error),
            _ => Ok((all, part)),
        }
    }

    /// What the method does on the stretch.
    fn tried(&mut self, method: Method, stretch: f64, part: f64) -> Result<Candidate> {
        let precision = (SWEEPS * self.tolerance * part).min(1e-6);
        let t = self.problem.t_start;
        let times = [t, t + stretch];
        let mut level = method.coarsest().max(0.0);
        let mut why = Error::NotDelivered {
            requested: self.tolerance,
            reached: f64::INFINITY,
        };
        while level + 1.0 <= method.finest() {
            let two = self
                .run(method, &times, level, &[], precision)
                .and_then(|coarse| {
                    let fine = self.next(method, &times, &coarse, 1.0, precision)?;
                    Ok((coarse, fine))
                });
            match two {
                Ok((coarse, fine)) => {
                    let error = self.distance(&coarse, &fine)[0];
                    // Not so for a NaN.
                    if error < APART {
                        return Ok(Candidate {
                            method,
                            level: coarse.level,
                            error: error.max(EPS),
                            cost: method.cost(self.problem, &coarse.work),
                        });
                    }
                }
                Err(error) if stops(&error) => return Err(error),
                Err(error) => why = error,
            }
            level += 2.0;
        }
        Err(why)
    }

    /// How far two runs are apart, each measure at the place where it is largest.
    fn distance(&self, a: &Run, b: &Run) -> Apart {
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
    fn deliver(&mut self, candidate: &Candidate, wanted: f64, felt: &Felt) -> Result<Outcome> {
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
        let steps = method.steps(self.problem, self.problem.span(), level);
        let swept = 1.0 + SWEPT * steps.sqrt();
        let mut precision = if method.sweeps() {
            (SWEEPS * (self.tolerance - floor) / (swept * (1.0 + condition))).min(1e-6)
        } else {
            0.0
        };
        let left = |precision: f64| floor + precision * swept * (1.0 + condition);
        let mut budget = self.tolerance - left(precision);
        let linear = candidate.level(LINEAR / (1.0 + condition));
        let coarse = (level - 2.0).max(linear);
        let coarse = coarse.clamp(method.coarsest(), highest - 2.0);
        let mut runs = vec![self.first(method, coarse, precision)?];
        let mut ahead = (level - 1.0 - runs[0].level).clamp(0.5, 2.0);
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
            if told && apart[0] > UNLIKE * predicted {
                return Ok(Outcome::Unlike);
            }
            for (gaps, apart) in gaps.iter_mut().zip(apart) {
                gaps.push(Gap { apart, step });
            }
            runs.push(next);
            let mut verdict = Verdict::of(method.trust(), &gaps[0]);
            let steps = runs[runs.len() - 1].work.steps as f64;
            if method.is_adaptive() {
                verdict.estimate += ROUNDED * EPS * steps;
            }
            if verdict.estimate <= budget {
                let run = runs.swap_remove(runs.len() - 1);
                let [_, momentum, rates] = [0, 1, 2].map(|n| {
                    Verdict::of(method.trust(), &gaps[n]).estimate
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

    /// A run finer by so many levels, and by one step at least on every piece.
    fn next(
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

    /// The condition, felt by the method that is cheapest where it is felt, or if that
    /// fails by another.
    fn condition(
        &mut self,
        candidates: &[Candidate],
        felt: f64,
        rows: usize,
        most_legs: usize,
    ) -> Result<Apart> {
        let mut order = candidates.to_vec();
        sort_by_number(&mut order, |candidate| candidate.cost(felt));
        // Adaptive methods last.
        sort_by_number(&mut order, |candidate| {
            f64::from(candidate.method.is_adaptive())
        });
        let mut why = Error::NotDelivered {
            requested: self.tolerance,
            reached: f64::INFINITY,
        };
        for candidate in order {
            match self.felt(&candidate, felt, rows, most_legs) {
                Err(error) if is_final(&error) => return Err(error),
                Err(error) => why = error,
                found => return found,
            }
        }
        Err(why)
    }

    fn felt(
        &mut self,
        candidate: &Candidate,
        felt: f64,
        rows: usize,
        most_legs: usize,
    ) -> Result<Apart> {
        let problem = self.problem;
        let method = candidate.method;
        let mut level = if method.is_adaptive() {
            // It answers a small change with a small jump, of its error.
            5.0
        } else {
            candidate.level(felt).max(method.coarsest())
        };
        // Every two radians at most: what passes a saddle must be moved on its way there.
        let legs = 0.5 * method.turned(problem, problem.span());
        let legs = legs.clamp(1.0, most_legs as f64) as usize;
        // Where the motion is looked at all along, the condition is the largest of all.
        let everywhere = self.times.len() > 2;
        let mut all = Runs::default();
        let this = &*self;
        let condition = problem.condition(&Feeler::STEPPED, |by| {
            // What the sweeps leave must not be mistaken for a change.
            let precision = 1e-3 * by;
            let mut run = |row, by, level| {
                let mut places = Vec::new();
                let end = problem.in_legs(row, by, legs, |changed, t, state, t_end| {
                    if by == 0.0 {
                        problem.checked.at(t, state)?;
                    }
                    let fine = Fine {
                        level,
                        fewest: &[],
                        precision,
                        budget: this.left(&all.work)?,
                    };
                    let passed = method.run(changed, [t, t_end], state, fine, &mut all);
                    let passed = passed.map_err(|error| this.over_budget(error))?;
                    if everywhere {
                        places.push(passed.state);
                    }
                    Ok(passed.state)
                })?;
                if !everywhere {
                    places.push(end);
                }
                Ok(places)
            };
            let places = loop {
                match run(0, 0.0, level) {
                    Err(error) if !stops(&error) && level + 1.0 <= method.finest() => {
                        level += 1.0;
                    }
                    places => break places?,
                }
            };
            let changed = (0..rows).map(|row| run(row, by, level));
            Ok((places, changed.collect::<Result<_>>()?))
        });
        self.work += all.work;
        condition
    }
}

/// True of errors that no other method would mend.
const fn is_final(error: &Error) -> bool {
    matches!(error, Error::Cancelled { .. } | Error::Contradiction { .. })
}

/// True of errors that no finer run would mend.
const fn stops(error: &Error) -> bool {
    is_final(error) || matches!(error, Error::OverBudget { .. })
}

/// The error aimed at, as a part of the tolerance: what the last run is predicted to
/// deliver. Half of what can be verified, and that is a part of 1/sqrt(40).
const AIM: f64 = 0.02;
