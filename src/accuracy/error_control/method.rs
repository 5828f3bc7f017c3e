//! The methods that step a motion, each with one setting.
//!
//! The setting is the *level*: one level up, the error is 40 times smaller. A method of
//! order p then takes 40^(1/p) times as many steps, an adaptive one is given a 40 times
//! smaller error of a step. So methods of any order are refined alike.

use super::laws;
use super::problem::{Acting, Problem};
use super::slender;
use crate::accuracy::{Resolution, Stepper, Variables};
use crate::body::State;
use crate::error::{Error, Result};
use crate::integrators::{Dop853, Method as Named, Work};
use crate::math::{exp, log};

/// ln 40: a level is a factor of 40 in the error.
pub(super) const LEVEL: f64 = 3.688_879_454_113_936;

/// A method, and the variables it steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Method {
    /// Gauss-Legendre 16 on a body without torque, on its own axes.
    FreeGauss,
    /// Gauss-Legendre 16 on attitude and momentum.
    Gauss,
    /// Gauss-Legendre 16 without the spin.
    SpinFreeGauss,
    /// Gauss-Legendre 16 on the axes of a body under effects that see e3 only.
    BodyGauss,
    /// The splitting of order 4 with what resists the rotation in its kick.
    Resisted6,
    /// The same of order 6.
    Resisted14,
    /// DOP853 on attitude and momentum.
    Adaptive,
}

use Method::{Adaptive, BodyGauss, FreeGauss, Gauss, Resisted6, Resisted14, SpinFreeGauss};

/// The expected performance of a method: measured on random motions of every kind, as the medians
/// of their errors on the first turn.
struct Model {
    /// The error of a turn at level 0, as a power of 40,
    first: f64,
    /// and how that grows with the power of the torque over the kinetic energy.
    with_torque: f64,
    /// By how many levels the error falls with each.
    falls: f64,
    /// The time of a torque, in units of the torque of DOP853.
    cost: f64,
}

impl Method {
    /// Those that are tried for this error, the first that converges to it delivers.
    pub(super) fn candidates(problem: &Problem, tolerance: f64) -> &'static [Self] {
        let symmetric = problem.body.moments().is_symmetric();
        // Where it is strong the steps would follow what resists, and not the rotation.
        let is_thick = Resisted14.angle() * problem.damping > problem.fastest();
        let resisted = !is_thick && problem.is_resisted();
        match problem.acting {
            _ if problem.slender.is_some() || problem.has_laws() => &[Adaptive],
            Acting::Nothing => &[FreeGauss, Adaptive],
            Acting::Weight(_) | Acting::OnAxis(_) if symmetric => &[SpinFreeGauss, Adaptive],
            Acting::Weight(_) | Acting::OnAxis(_) => &[BodyGauss, Adaptive],
            // Measured on bodies in oil and in air: order 4 costs less above this error, order 6 below.
            _ if resisted && tolerance > 1e-5 => &[Resisted6, Adaptive],
            _ if resisted => &[Resisted14, Adaptive],
            // The same of DOP853 and order 16 on satellites, motors and magnets.
            Acting::Smooth(_) if tolerance < 1e-8 => &[Gauss, Adaptive],
            Acting::Smooth(_) => &[Adaptive, Gauss],
            Acting::Anything(_) => &[Adaptive],
        }
    }

    /// The name that is printed.
    pub(super) const fn name(self) -> &'static str {
        match self {
            SpinFreeGauss => "Gauss-Legendre 16, spin-free",
            Resisted6 => "SRKN 6b, resisted",
            Resisted14 => "SRKN 14a, resisted",
            _ => self.method().name(),
        }
    }

    /// The method, whatever it carries.
    const fn method(self) -> Named {
        match self {
            FreeGauss | Gauss | SpinFreeGauss | BodyGauss => Named::GaussLegendre16,
            Resisted6 => Named::Srkn6,
            Resisted14 => Named::Srkn14,
            Adaptive => Named::Dop853,
        }
    }

    /// The variables that it carries.
    const fn variables(self) -> Variables {
        match self {
            FreeGauss | BodyGauss => Variables::Body,
            SpinFreeGauss => Variables::SpinFree,
            Gauss | Resisted6 | Resisted14 | Adaptive => Variables::Space,
        }
    }

    /// The order p.
    const fn order(self) -> f64 {
        self.method().order() as f64
    }

    const fn model(self) -> Model {
        let [first, with_torque, falls, cost] = match self {
            FreeGauss => [-8.5, 0.0, 1.0, 0.09],
            Gauss => [-8.5, 0.0, 1.0, 0.84],
            SpinFreeGauss => [-8.5, 0.0, 1.0, 0.07],
            BodyGauss => [-8.5, 0.0, 1.0, 0.12],
            Resisted6 => [-2.6, 0.95, 1.0, 1.2],
            Resisted14 => [-3.7, 0.85, 1.0, 1.2],
            Adaptive => [-3.2, 0.0, 0.7, 1.0],
        };
        Model { first, with_torque, falls, cost }
    }

    /// By how many levels the error falls with each.
    pub(super) const fn falls(self) -> f64 {
        self.model().falls
    }

    /// The level at which this error (rad) is expected at the end. Errors of a turn add up, and
    /// errors of the energy, which DOP853 does not keep, do so once more.
    pub(super) fn level_for(self, problem: &Problem, error: f64) -> f64 {
        let model = self.model();
        let energy = problem.body.kinetic_energy(&problem.start);
        let weight = if energy > 0.0 { problem.torque / energy } else { 1e3 };
        let torque = log(weight.clamp(1e-6, 1e3)) / LEVEL;
        let turns = self.turned(problem, problem.span()) / core::f64::consts::TAU;
        let turns = turns.max(1.0);
        let grown = if self.is_adaptive() { turns * turns } else { turns };
        let levels = model.first + model.with_torque * torque - log(error / grown) / LEVEL;
        (levels / model.falls).clamp(self.coarsest(), self.finest() - 1.0)
    }

    /// The smallest error that it reaches, in units of eps (1 + condition): the largest of 600 random
    /// motions. The rates of a slender body are blurred besides.
    pub(super) fn floor(self, problem: &Problem) -> f64 {
        let stepped = match self {
            Gauss | Adaptive => 24.0,
            FreeGauss | SpinFreeGauss | BodyGauss | Resisted6 | Resisted14 => 8.0,
        };
        stepped + problem.slender.map_or(0.0, |slender| slender.held + slender.brought)
    }

    /// True if its steps are solved by sweeps, which leave something.
    pub(super) const fn sweeps(self) -> bool {
        matches!(self, FreeGauss | Gauss | SpinFreeGauss | BodyGauss)
    }

    /// True if it chooses its steps itself, and so answers a small change of the start
    /// with a small jump.
    pub(super) const fn is_adaptive(self) -> bool {
        matches!(self, Adaptive)
    }

    /// True if the rounding of its steps adds up in the attitude.
    pub(super) const fn adds_rounding(self) -> bool {
        matches!(self, Gauss | Adaptive)
    }

    /// The coarsest level that is tried: beyond it Gauss-Legendre's sweeps do not
    /// converge, and the others are no longer in their order.
    pub(super) const fn coarsest(self) -> f64 {
        if self.sweeps() { -2.0 } else { -0.5 }
    }

    /// The level beyond which there is nothing but round-off, whatever the scene.
    pub(super) const fn finest(self) -> f64 {
        if self.is_adaptive() { 7.4 } else { 12.0 }
    }

    /// The angle (rad) that the fastest rotation makes in a step at level 0.
    const fn angle(self) -> f64 {
        match self {
            FreeGauss | Gauss | BodyGauss => 1.6,
            SpinFreeGauss => 2.5,
            Resisted6 | Resisted14 | Adaptive => 4.0,
        }
    }

    /// The cost of a run, in units of one derivative of DOP853: measured, as times of one run of 50
    /// turns after the other, optimised and with AVX-512. It enters the price that is told, and no
    /// choice.
    pub(super) fn cost(self, work: &Work) -> f64 {
        self.model().cost * work.torques() as f64
    }

    /// By what factor the steps grow when the level is raised by so much.
    fn more_steps(self, levels: f64) -> f64 {
        exp(levels * LEVEL / self.order())
    }

    /// A bound on the rates (rad/s) that this method has to follow.
    fn rate(self, problem: &Problem) -> f64 {
        let moments = problem.body.moments();
        // Without the spin the axis turns with L/I1; falling sets free up to 2 m g l.
        let of_axis = || {
            let turning = problem.start.angular_momentum.norm() / moments.i1();
            turning + 2.0 * (problem.torque / moments.i1()).sqrt()
        };
        match self {
            SpinFreeGauss => of_axis(),
            Resisted6 | Resisted14 => {
                let rate = if moments.is_symmetric() { of_axis() } else { problem.fastest() };
                // Nor are steps in their order that take most of the momentum at once.
                rate.max(self.angle() * problem.damping)
            }
            FreeGauss | Gauss | BodyGauss | Adaptive => problem.fastest(),
        }
    }

    /// The angle (rad) turned until `t_end`, on which the number of steps rests; 1 at
    /// least, so that a finer level takes more steps of whatever seems at rest.
    pub(super) fn turned(self, problem: &Problem, t_end: f64) -> f64 {
        (self.rate(problem) * t_end.abs()).max(1.0)
    }

    /// The steps of this level until `t_end` (not for adaptive methods).
    pub(super) fn steps(self, problem: &Problem, t_end: f64, level: f64) -> f64 {
        self.turned(problem, t_end) / self.angle() * self.more_steps(level)
    }

    /// The level at which this many steps are taken (not for adaptive methods).
    fn level_of(self, problem: &Problem, t_end: f64, steps: f64) -> f64 {
        let base = self.turned(problem, t_end) / self.angle();
        log(steps / base) * self.order() / LEVEL
    }

    /// Torques that a step takes, at most.
    pub(super) const fn torques(self) -> f64 {
        match self {
            FreeGauss | Gauss | SpinFreeGauss | BodyGauss => 8.0 * 12.0,
            Resisted6 | Resisted14 => 14.0,
            Adaptive => 12.0,
        }
    }

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
            fewest *= self.more_steps(fine.level - self.coarsest());
        }
        let fewest = steps.fewest.max(fewest.ceil() as u64);
        let affordable = fine.budget as f64 / self.torques();
        let stepper = if self.is_adaptive() {
            let tolerance = (1e-3 * exp(-LEVEL * fine.level))
                .clamp(Dop853::SMALLEST_TOLERANCE, Dop853::LARGEST_TOLERANCE);
            let method = Dop853::new(tolerance)?
                .with_longest_step(span / fewest as f64)?
                .with_step_limit(affordable.max(1.0) as u64)?;
            Stepper::Dop853(method)
        } else {
            let steps = self.steps(problem, t_end - t, fine.level);
            if steps.is_nan() || steps.max(fewest as f64) > affordable {
                return Err(over);
            }
            let steps = (steps.ceil() as u64).max(fewest);
            Stepper::new(self.method(), Resolution::Stages(steps, fine.precision))?
        };
        let mut work = Work::default();
        let run = match (problem.slender, stepper) {
            (_, Stepper::Dop853(dop853)) if problem.has_laws() => {
                let least = steps.of_a_sample();
                laws::carried(problem, dop853, [t, t_end], start, least, &mut work)
            }
            (Some(_), Stepper::Dop853(dop853)) if self == Adaptive => {
                let (start, on_body) = (&start.state, start.on_body);
                slender::carried(problem, &dop853, [t, t_end], start, on_body, &mut work)
                    .map(|(state, on_body)| Stop { on_body: Some(on_body), ..Stop::at(state) })
            }
            _ => (problem.carried(&stepper, self.variables(), [t, t_end], &start.state, &mut work))
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

/// More steps than these are refined by the error allowed for each.
const FEW: f64 = 8.0;

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
