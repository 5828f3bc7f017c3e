//! A run: by one method, at one level, over the pieces of the way.

use super::constants::{FEW, LEVEL, OF_A_STEP};
use super::laws;
use super::method::Method;
use super::problem::Problem;
use crate::accuracy::{Resolution, Stepper};
use crate::body::State;
use crate::error::{Error, Result};
use crate::integrators::{Dop853, Work};
use crate::math::exp;

/// The steps of a run over a piece of its way: between two places looked at, and two jumps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Steps {
    /// As many as it made.
    pub made: u64,
    /// So many it was to make at least.
    pub fewest: u64,
    /// A piece that is crossed in few steps is refined by their number alone, whatever a
    /// step's error: so many does its refinement ask for.
    asked: f64,
    /// The same from each sample of a law to the next.
    sampled: f64,
}

impl Steps {
    /// Nothing is asked for.
    pub(super) const ONE: Self = Self { made: 0, fewest: 1, asked: 1.0, sampled: 1.0 };

    /// So many steps at least from each sample to the next: runs that crossed all of them in one
    /// would agree.
    pub(super) fn of_a_sample(self) -> u64 {
        self.sampled.ceil() as u64
    }

    /// The steps of another run in the same steps; an adaptive method takes its own.
    pub(super) fn again(self, method: Method) -> Self {
        Self { fewest: if method.is_adaptive() { self.fewest } else { self.made }, ..self }
    }

    /// The steps of a run that is finer by so many levels, on every piece. Runs that took the same
    /// steps over one of them would agree on it, and say nothing of its error.
    pub(super) fn finer(self, method: Method, levels: f64) -> Self {
        let asked = self.asked.max((FEW as f64).min(self.made as f64)) * method.more_steps(levels);
        let fewest = if method.is_adaptive() { asked.ceil() as u64 } else { 1 };
        Self {
            made: 0,
            fewest: fewest.max(self.made + 1),
            asked,
            sampled: self.sampled * method.more_steps(levels),
        }
    }
}

/// How fine a run is to be.
#[derive(Debug, Clone, Copy)]
pub(super) struct Fine<'f> {
    pub level: f64,
    /// To which the stages of Gauss-Legendre are solved.
    pub precision: f64,
    /// On each piece so many steps at least; one on those beyond the last.
    pub fewest: &'f [Steps],
    /// So many torques at most.
    pub budget: u64,
}

/// Where a run goes on from.
#[derive(Debug, Clone)]
pub(super) struct Stop {
    pub state: State,
    /// The values that the laws held until here; nothing at the start.
    pub held: Vec<[f64; 3]>,
}

impl Stop {
    pub(super) const fn at(state: State) -> Self {
        Self { state, held: Vec::new() }
    }
}

/// A run over the pieces of its way.
pub(super) struct Run {
    /// The level of the steps it took: the least of all pieces.
    pub level: f64,
    /// That of its stages.
    pub precision: f64,
    /// No step was longer (s).
    pub longest_step: f64,
    pub work: Work,
    /// The steps on each piece,
    pub steps: Vec<Steps>,
    /// and the time and the state at its end.
    pub passed: Vec<(f64, Stop)>,
}

impl Run {
    /// Its end.
    pub(super) fn end(mut self) -> Stop {
        self.passed.pop().expect("a run has a piece").1
    }
}

impl Method {
    /// The run from `start` at `t` to `t_end`, cut where the torque jumps. Its work is added to `spent`,
    /// also if it comes to no end.
    pub(super) fn run(
        self,
        problem: &Problem,
        [t, t_end]: [f64; 2],
        start: &Stop,
        fine: Fine,
        spent: &mut Work,
    ) -> Result<Run> {
        let begun = *spent;
        let mut run = Run {
            level: f64::INFINITY,
            precision: fine.precision,
            longest_step: 0.0,
            work: Work::default(),
            steps: Vec::new(),
            passed: Vec::new(),
        };
        for (n, piece) in problem.pieces([t, t_end]).windows(2).enumerate() {
            let before = *spent;
            let budget = fine.budget.saturating_sub(before.since(&begun).torques());
            let fewest = fine.fewest.get(n).copied().unwrap_or(Steps::ONE);
            let from = run.passed.last().map_or(start, |(_, stop)| stop);
            let span = [piece[0], piece[1]];
            let fine = Fine { budget, ..fine };
            let (stop, longest) = self.run_piece(problem, span, from, fine, fewest, spent)?;
            let made = spent.since(&before).steps;
            // Steps are whole: the level is that of the steps taken.
            run.level = run.level.min(if self.is_adaptive() {
                fine.level
            } else {
                self.level_of(problem, span[1] - span[0], made as f64)
            });
            run.longest_step = run.longest_step.max(longest);
            run.steps.push(Steps { made, ..fewest });
            run.passed.push((span[1], stop));
        }
        run.work = spent.since(&begun);
        Ok(run)
    }

    /// The end of a piece, and the longest step there may have been (s).
    fn run_piece(
        self,
        problem: &Problem,
        [t, t_end]: [f64; 2],
        start: &Stop,
        fine: Fine,
        steps: Steps,
        spent: &mut Work,
    ) -> Result<(Stop, f64)> {
        let span = (t_end - t).abs();
        let over = Error::LimitReached { what: "torques", t, t_end, limit: fine.budget };
        let mut fewest = span / problem.longest_step;
        if self.is_adaptive() {
            // Finer runs take shorter steps also where none may be longer: runs that took
            // the same steps would agree, and say nothing.
            fewest *= self.more_steps(fine.level - self.coarsest);
        }
        let mut least = steps.fewest.max(fewest.ceil() as u64);
        let affordable = fine.budget as f64 / self.torques();
        let stepper = if self.is_adaptive() {
            let method = Dop853::new(OF_A_STEP * exp(-LEVEL * fine.level))?
                .with_longest_step(span / least as f64)?
                .with_step_limit(affordable.max(1.0) as u64)?;
            Stepper::Dop853(method)
        } else {
            let of_level = self.steps(problem, t_end - t, fine.level);
            if of_level.is_nan() || of_level.max(least as f64) > affordable {
                return Err(over);
            }
            least = least.max(of_level.ceil() as u64);
            Stepper::new(self.named, Resolution::Stages(least, fine.precision))?
        };
        let end = match stepper {
            Stepper::Dop853(dop853) if problem.has_laws() => {
                laws::carried(problem, dop853, [t, t_end], start, steps.of_a_sample(), spent)
            }
            _ => (problem.carried(&stepper, self.variables, [t, t_end], &start.state, spent))
                .map(Stop::at),
        };
        // A piece has its own time, from 0.
        let stop = end.map_err(|error| match later(error, t) {
            Error::LimitReached { .. } => over,
            error => error,
        })?;
        Ok((stop, span / least as f64))
    }
}

/// An error with a time that counts from `t`, at its own time.
pub(super) fn later(mut error: Error, t: f64) -> Error {
    if let Error::StepUnderflow { t: since, .. } | Error::FunctionOutOfRange { t: since, .. } =
        &mut error
    {
        *since += t;
    }
    error
}
