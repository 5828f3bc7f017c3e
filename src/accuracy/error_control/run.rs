//! A run: by one method, at one level, over the pieces of the way.

use super::constants::{FEW, LEVEL, OF_A_STEP};
use super::laws;
use super::method::Method;
use super::problem::Problem;
use super::slender;
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
        let asked = self.asked.max(FEW.min(self.made as f64)) * method.more_steps(levels);
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
    /// On each piece so many steps at least; one on those beyond the last.
    pub fewest: &'f [Steps],
    /// To which the stages of Gauss-Legendre are solved; 0 for round-off.
    pub precision: f64,
    /// So many torques at most.
    pub budget: u64,
}

/// The work of runs on one piece after the other, and the work of all, also of those that came to
/// no end.
#[derive(Debug, Default)]
pub(super) struct Runs {
    pub pieces: Vec<Steps>,
    /// The ends of the pieces.
    pub passed: Vec<(f64, Stop)>,
    pub work: Work,
}

/// Where a run goes on from.
#[derive(Debug, Clone)]
pub(super) struct Stop {
    pub state: State,
    /// The same as a slender body is stepped: a [`State`] would blur its rates.
    pub on_body: Option<[f64; 7]>,
    /// The values that the laws held until here; nothing at the start.
    pub held: Vec<[f64; 3]>,
}

impl Stop {
    pub(super) const fn at(state: State) -> Self {
        Self { state, on_body: None, held: Vec::new() }
    }
}

/// Where a run has come, its cost, and the level of the steps it took.
#[derive(Debug, Clone)]
pub(super) struct Passed {
    pub stop: Stop,
    pub work: Work,
    pub level: f64,
    /// No step was longer (s).
    pub longest_step: f64,
}

impl Method {
    /// The state at `t_end` that follows from `start` at `t`, cut where the torque jumps; with how
    /// fine the run was: see [`Fine`]. The work of every piece is added to `runs`.
    pub(super) fn run(
        self,
        problem: &Problem,
        [t, t_end]: [f64; 2],
        start: Stop,
        fine: Fine,
        runs: &mut Runs,
    ) -> Result<Passed> {
        let times = problem.pieces([t, t_end]);
        let mut passed =
            Passed { stop: start, work: Work::default(), level: f64::INFINITY, longest_step: 0.0 };
        for (n, piece) in times.windows(2).enumerate() {
            let now = Fine { budget: fine.budget.saturating_sub(passed.work.torques()), ..fine };
            let span = [piece[0], piece[1]];
            let fewest = fine.fewest.get(n).copied().unwrap_or(Steps::ONE);
            let start = &passed.stop;
            let more = self.run_piece(problem, span, start, now, fewest, &mut runs.work)?;
            runs.pieces.push(Steps { made: more.work.steps, ..fewest });
            runs.passed.push((piece[1], more.stop.clone()));
            passed.stop = more.stop;
            passed.work += more.work;
            passed.level = passed.level.min(more.level);
            passed.longest_step = passed.longest_step.max(more.longest_step);
        }
        Ok(passed)
    }

    fn run_piece(
        self,
        problem: &Problem,
        [t, t_end]: [f64; 2],
        start: &Stop,
        fine: Fine,
        steps: Steps,
        spent: &mut Work,
    ) -> Result<Passed> {
        let span = (t_end - t).abs();
        let over = Error::LimitReached { what: "torques", t, t_end, limit: fine.budget };
        let mut fewest = span / problem.longest_step;
        if self.is_adaptive() {
            // Finer runs take shorter steps also where none may be longer: runs that took
            // the same steps would agree, and say nothing.
            fewest *= self.more_steps(fine.level - self.coarsest);
        }
        let fewest = steps.fewest.max(fewest.ceil() as u64);
        let affordable = fine.budget as f64 / self.torques();
        let stepper = if self.is_adaptive() {
            let method = Dop853::new(OF_A_STEP * exp(-LEVEL * fine.level))?
                .with_longest_step(span / fewest as f64)?
                .with_step_limit(affordable.max(1.0) as u64)?;
            Stepper::Dop853(method)
        } else {
            let steps = self.steps(problem, t_end - t, fine.level);
            if steps.is_nan() || steps.max(fewest as f64) > affordable {
                return Err(over);
            }
            let steps = (steps.ceil() as u64).max(fewest);
            Stepper::new(self.named, Resolution::Stages(steps, fine.precision))?
        };
        let mut work = Work::default();
        let run = match (problem.slender, stepper) {
            (_, Stepper::Dop853(dop853)) if problem.has_laws() => {
                let least = steps.of_a_sample();
                laws::carried(problem, dop853, [t, t_end], start, least, &mut work)
            }
            (Some(_), Stepper::Dop853(dop853)) if self.is_adaptive() => {
                let (start, on_body) = (&start.state, start.on_body);
                slender::carried(problem, &dop853, [t, t_end], start, on_body, &mut work)
                    .map(|(state, on_body)| Stop { on_body: Some(on_body), ..Stop::at(state) })
            }
            _ => (problem.carried(&stepper, self.variables, [t, t_end], &start.state, &mut work))
                .map(Stop::at),
        };
        *spent += work;
        // A piece has its own time, from 0.
        let stop = run.map_err(|error| match later(error, t) {
            Error::LimitReached { .. } => over,
            error => error,
        })?;
        // Steps are whole: the level is that of the steps taken.
        let (level, longest_step) = if self.is_adaptive() {
            (fine.level, span / fewest as f64)
        } else {
            let steps = work.steps as f64;
            (self.level_of(problem, t_end - t, steps), span / steps)
        };
        Ok(Passed { stop, work, level, longest_step })
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
