//! The condition: what the motion makes of inputs that are a little changed.

use super::choice::Candidate;
use super::method::{Fine, Method, Runs, Steps};
use super::problem::{Apart, Feeler};
use super::stepping::{Run, SWEEPS, Stepping, is_final, stops};
use super::verdict::Gap;
use crate::accuracy::larger;
use crate::error::{Error, Result};
use crate::math::{EPS, sort_by_number};

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

/// A condition as it was felt.
#[derive(Clone, Copy)]
pub(super) struct Felt {
    pub condition: Apart,
    /// The part of the span on which the candidates were compared.
    pub part: f64,
    /// Nothing is gained by a finer motion.
    pub finely: bool,
    /// By two changed motions in the steps of a run, or by a pair: enough only if the floor is far
    /// away.
    pub roughly: bool,
}

/// The first run of the span, on which the condition was felt, and to what its sweeps are solved.
pub(super) struct Begun {
    pub run: Run,
    pub precision: f64,
    /// The condition as bounded by its distances from a coarser one, if it is.
    pub bounded: Option<(Felt, [Gap; 3])>,
}

/// The change with which it is felt roughly: ten times what the sweeps leave, between these.
const ROUGH_CHANGE: [f64; 2] = [1e-8, 1e-5];
/// The same of an adaptive method.
const ROUGH_CHANGE_ADAPTIVE: f64 = 1e-4;

/// The error (rad) that a run on which the condition is felt roughly may make.
const ROUGH: f64 = 0.03;
/// The same of an adaptive method, which answers a small change with a jump of a part of it.
const ROUGH_ADAPTIVE: f64 = 3e-3;

/// How far the end, and what is passed on the way, may move when the condition is felt
/// roughly (rad).
pub(super) const MOVED: f64 = 0.03;

/// A motion whose condition is no more than so many times that of one which is only late passes
/// no saddle.
const TAME: f64 = 6.0;

/// A floor that is so many times above the tolerance comes down to it by no more care: two rows of
/// the design say at most sqrt(10) times what the ten inputs do.
const HOPELESS: f64 = 10.0;

/// A floor further below the tolerance than by this factor need not be known well.
const FAR_BELOW: f64 = 100.0;

impl Stepping<'_> {
    /// The condition of a motion that is only late.
    pub(super) fn late(&self) -> f64 {
        self.problem.fastest() * self.problem.span().abs()
    }

    /// The condition as two runs in the same steps as one of the span tell it, with all inputs
    /// changed and moved on the way: enough where the floor is far below the tolerance. `None`
    /// where it is not, or no such run comes to its end.
    pub(super) fn roughly(
        &mut self,
        method: Method,
        begun: &Begun,
        part: f64,
    ) -> Result<Option<Felt>> {
        let run = &begun.run;
        // The smaller the change, the less likely is a motion that goes far and is back by chance.
        let by = if method.is_adaptive() {
            ROUGH_CHANGE_ADAPTIVE
        } else {
            let [least, most] = ROUGH_CHANGE;
            (10.0 * begun.precision).clamp(least, most)
        };
        let loosely = if method.sweeps() { 0.1 * by } else { 0.0 };
        let times = self.times.clone();
        let again = |leg: &Vec<_>| {
            leg.iter()
                .map(|steps: &Steps| steps.again(method))
                .collect()
        };
        let fewest: Vec<Vec<Steps>> = run.steps.iter().map(again).collect();
        // Coarser by as much as the changed problem may seem to turn faster.
        let level = if method.is_adaptive() {
            run.level
        } else {
            run.level - 0.1
        };
        let before = self.work;
        let mut moved = Vec::new();
        let telling = self.problem.telling_row()?;
        for row in telling..telling + ROWS {
            let changed = self.problem.changed(row, by)?;
            let mut run = Run::default();
            let gone = self.go_on(
                &changed,
                method,
                &mut run,
                &times,
                level,
                &fewest,
                loosely,
                Some((row, by)),
            );
            match gone {
                Err(error) if is_final(&error) => return Err(error),
                Err(_) => break,
                Ok(()) => moved.push(run),
            }
        }
        self.probes += self.work.since(&before);
        if moved.len() < ROWS {
            return Ok(None);
        }
        for (t, state) in &run.passed {
            self.problem.checked.at(*t, state)?;
        }
        // Nor may they part on the way and meet again.
        let farthest = (moved.iter())
            .flat_map(|moved| run.passed.iter().zip(&moved.passed))
            .map(|(a, b)| self.problem.apart(&a.1, &b.1)[0])
            .fold(0.0, larger);
        let places = moved.into_iter().map(|moved| moved.places).collect();
        let (condition, moved) = self.problem.slopes(by, (run.places.clone(), places));
        let farthest = larger(farthest, moved);
        let floor = method.floor(self.problem) * EPS * (1.0 + condition[0]);
        let tame = condition[0] <= TAME * (1.0 + self.late());
        if farthest <= MOVED && tame {
            self.possible(condition[0])?;
        }
        let enough = farthest <= MOVED && FAR_BELOW * floor <= self.tolerance && tame;
        let felt = Felt {
            condition,
            part,
            finely: false,
            roughly: true,
        };
        Ok(enough.then_some(felt))
    }

    /// Refuses at once where the lowest floor of all methods is far above the tolerance: with more care
    /// a condition that was felt by few changes falls by no more than what these may add up to.
    fn possible(&self, condition: f64) -> Result<()> {
        let methods = Method::candidates(self.problem);
        let lowest =
            (methods.iter().map(|method| method.floor(self.problem))).fold(f64::INFINITY, f64::min);
        let floor = lowest * EPS * (1.0 + condition);
        if floor > HOPELESS * self.tolerance {
            return Err(self.beyond(floor, condition));
        }
        Ok(())
    }

    /// The first run of the span by a candidate, on which the condition may be felt roughly.
    pub(super) fn begin(
        &mut self,
        candidate: &Candidate,
        wanted: f64,
        part: f64,
    ) -> Result<Option<Begun>> {
        let exact = self.problem.exact_motion();
        if exact.is_some_and(|motion| motion.is_near_separatrix()) {
            return Ok(None);
        }
        let (method, level) = (candidate.method, candidate.level(wanted));
        let rough = if method.is_adaptive() {
            ROUGH_ADAPTIVE
        } else {
            ROUGH
        };
        let coarse = (level - Method::BEHIND).max(candidate.level(rough * part));
        let coarsest = method.coarsest_resolved(self.problem);
        if coarsest > method.finest() - 2.0 {
            return Ok(None);
        }
        let coarse = coarse.clamp(coarsest, method.finest() - 2.0);
        let precision = if method.sweeps() {
            // The condition, as that of a motion that is only late.
            let kept = self.swept(method, level) * (1.0 + 2.0 * self.late());
            (SWEEPS * self.tolerance / kept).min(0.1 * ROUGH_CHANGE[1])
        } else {
            0.0
        };
        match self.first(method, coarse, precision) {
            Err(error) if is_final(&error) => Err(error),
            Err(_) => Ok(None),
            Ok(run) => Ok(Some(Begun {
                run,
                precision,
                bounded: None,
            })),
        }
    }

    /// The condition, felt on a motion that is good enough for it.
    pub(super) fn feel(
        &mut self,
        candidates: &[Candidate],
        part: f64,
        lowest: f64,
    ) -> Result<Felt> {
        // Adaptive methods feel it finely at once.
        let mut felt = Felt {
            condition: self.condition(candidates, FELT * part, ROWS, LEGS)?,
            part,
            finely: candidates.iter().all(|c| c.method.is_adaptive()),
            roughly: false,
        };
        let mut error = FELT;
        // The motion that was felt is off by its own error, as much as the condition makes
        // of that: on another side of a saddle, say.
        while !felt.finely && (1.0 + felt.condition[0]) * error * part > ELSEWHERE {
            error = (error * FINER).max(FELT_FINELY);
            felt.finely = error == FELT_FINELY;
            felt.condition = self.condition(candidates, error * part, ROWS, LEGS)?;
        }
        // On another side of a saddle it may be far too large.
        let off = (1.0 + felt.condition[0]) * error * part;
        if felt.condition[0].is_finite() && (felt.finely || off <= MOVED) {
            self.possible(felt.condition[0])?;
        }
        if NEAR * lowest * EPS * (1.0 + felt.condition[0]) > self.tolerance {
            let error = error.min(FELT_WELL);
            felt.condition = self.condition(candidates, error * part, MORE_ROWS, MORE_LEGS)?;
        }
        Ok(felt)
    }

    /// The same where runs have shown that the motion is not the one that was felt.
    pub(super) fn feel_finely(&mut self, candidates: &[Candidate], part: f64) -> Result<Felt> {
        Ok(Felt {
            condition: self.condition(candidates, FELT_FINELY * part, MORE_ROWS, MORE_LEGS)?,
            part,
            finely: true,
            roughly: false,
        })
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
        let everywhere = self.everywhere;
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
                    let passed = method.run(changed, [t, t_end], state, None, fine, &mut all);
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
        self.probes += all.work;
        self.cost += method.cost(problem, &all.work);
        condition
    }
}
