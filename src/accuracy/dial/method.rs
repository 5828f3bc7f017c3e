//! The methods the dial chooses from, each with one knob.
//!
//! The knob is the *level*: one level up, the error is 40 times smaller. A method of
//! order p then takes 40^(1/p) times as many steps, an adaptive one is given a 40 times
//! smaller error of a step. So methods of any order are refined alike and compared at
//! the same error.

use super::choice::Candidate;
use super::problem::{Acting, Problem};
use super::slender;
use crate::accuracy::{Carrier, Fineness, Variables};
use crate::body::State;
use crate::error::{Error, Result};
use crate::integrators::{Dop853, Method as Named, Work};
use crate::math::{exp, log};

/// ln 40: a level is a factor of 40 in the error.
pub(super) const LEVEL: f64 = 3.688_879_454_113_936;

/// By so much may the error of another splitting be smaller than that of the first, at a level.
const BETTER: f64 = 1e-3;

/// The fastest rotation turns by no more in a step (rad) of which two runs are believed.
const RESOLVED: f64 = 4.0;

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
    /// A splitting: without the spin, if the body is symmetric.
    Split(Named),
    /// The same with what resists the rotation in its kick.
    Resisted(Named),
    /// DOP853 on attitude and momentum.
    Adaptive,
    /// DOP853 without the spin.
    SpinFreeAdaptive,
}

use Method::{
    Adaptive, BodyGauss, FreeGauss, Gauss, Resisted, SpinFreeAdaptive, SpinFreeGauss, Split,
};

impl Method {
    /// Those that can step this problem.
    pub fn candidates(problem: &Problem) -> Vec<Self> {
        let splittings = |of: fn(Named) -> Self| {
            let mut all = vec![of(Named::Srkn6), of(Named::Srkn14)];
            if problem.is_fast() {
                all.extend([of(Named::Aba104), of(Named::Aba1064)]);
            }
            all
        };
        let symmetric = problem.body.moments().is_symmetric();
        if problem.slender.is_some() {
            return vec![Adaptive];
        }
        let (mut all, others): (_, &[Self]) = match problem.acting {
            Acting::Nothing => (Vec::new(), &[FreeGauss, Adaptive]),
            Acting::Weight(_) | Acting::OnAxis(_) if symmetric => {
                (splittings(Split), &[SpinFreeGauss, SpinFreeAdaptive])
            }
            Acting::Weight(_) | Acting::OnAxis(_) => (splittings(Split), &[BodyGauss, Adaptive]),
            Acting::Smooth(_) | Acting::Anything(_) => {
                let resisted = problem.is_resisted().then(|| splittings(Resisted));
                let smooth = matches!(problem.acting, Acting::Smooth(_));
                let others: &[Self] = if smooth {
                    &[Adaptive, Gauss]
                } else {
                    &[Adaptive]
                };
                (resisted.unwrap_or_default(), others)
            }
        };
        all.extend(others);
        all
    }

    /// The name that is printed.
    pub const fn name(self) -> &'static str {
        match self {
            SpinFreeGauss => "Gauss-Legendre 16, spin-free",
            SpinFreeAdaptive => "DOP853, spin-free",
            Resisted(Named::Srkn6) => "SRKN 6b, resisted",
            Resisted(Named::Srkn14) => "SRKN 14a, resisted",
            Resisted(Named::Aba104) => "ABA(10,4), resisted",
            Resisted(_) => "ABA(10,6,4), resisted",
            _ => self.method().name(),
        }
    }

    /// The method, whatever it carries.
    const fn method(self) -> Named {
        match self {
            FreeGauss | Gauss | SpinFreeGauss | BodyGauss => Named::GaussLegendre16,
            Split(method) | Resisted(method) => method,
            Adaptive | SpinFreeAdaptive => Named::Dop853,
        }
    }

    /// What it carries.
    const fn variables(self) -> Variables {
        match self {
            FreeGauss | BodyGauss => Variables::Body,
            SpinFreeGauss | SpinFreeAdaptive => Variables::SpinFree,
            Gauss | Split(_) | Resisted(_) | Adaptive => Variables::Space,
        }
    }

    /// The order p.
    const fn order(self) -> f64 {
        self.method().order() as f64
    }

    /// The part of its order that is trusted without having been seen. The error of
    /// order 16 falls less smoothly, and trusting it less costs next to nothing.
    pub const fn trust(self) -> f64 {
        match self {
            FreeGauss | Gauss | SpinFreeGauss | BodyGauss => 0.12,
            Adaptive | SpinFreeAdaptive => 0.33,
            Split(_) | Resisted(_) => 0.5,
        }
    }

    /// By how many levels the first run of the span is coarser than the one that is to deliver,
    /// where two may do.
    pub const BEHIND: f64 = 1.0;

    /// The smallest error that it reaches, in units of eps (1 + condition). The rates of a slender
    /// body are blurred besides.
    pub fn floor(self, problem: &Problem) -> f64 {
        let stepped = match self {
            Gauss | Adaptive | SpinFreeAdaptive => 24.0,
            FreeGauss | SpinFreeGauss | BodyGauss | Split(_) | Resisted(_) => 8.0,
        };
        stepped
            + problem
                .slender
                .map_or(0.0, |slender| slender.held + slender.brought)
    }

    /// True if its steps are solved by sweeps, which leave something.
    pub const fn sweeps(self) -> bool {
        matches!(self, FreeGauss | Gauss | SpinFreeGauss | BodyGauss)
    }

    /// True if it chooses its steps itself, and so answers a small change of the start
    /// with a small jump.
    pub const fn is_adaptive(self) -> bool {
        matches!(self, Adaptive | SpinFreeAdaptive)
    }

    /// The coarsest level that is tried: beyond it Gauss-Legendre's sweeps do not
    /// converge, and the others are no longer in their order.
    pub const fn coarsest(self) -> f64 {
        match self {
            FreeGauss | Gauss | SpinFreeGauss | BodyGauss => -2.0,
            _ => -0.5,
        }
    }

    /// The coarsest level of which two runs are believed. A splitting takes its steps by the rate
    /// of the axis; of a body with three moments it follows the spin as well, and steps of about a
    /// turn of that would all err alike.
    pub fn coarsest_resolved(self, problem: &Problem) -> f64 {
        if self.is_adaptive() || self.sweeps() || problem.body.moments().is_symmetric() {
            return self.coarsest();
        }
        let angle = self.angle() * problem.fastest() / self.rate(problem);
        (log(angle / RESOLVED) * self.order() / LEVEL).max(self.coarsest())
    }

    /// The level beyond which there is nothing but round-off, whatever the scene.
    pub const fn finest(self) -> f64 {
        match self {
            Adaptive | SpinFreeAdaptive => 7.4,
            _ => 12.0,
        }
    }

    /// The angle (rad) that the fastest rotation makes in a step at level 0.
    pub const fn angle(self) -> f64 {
        match self {
            FreeGauss | Gauss | BodyGauss => 1.6,
            SpinFreeGauss => 2.5,
            _ => 4.0,
        }
    }

    /// What a run costs, in units of one derivative of DOP853: measured, as times of one
    /// run of 50 turns after the other, optimised and with AVX-512 (that of the body's own
    /// axes is an estimate, and what resists makes a kick dearer by as much as it takes more
    /// instructions: 600 instead of 283 of a symmetric body, 1145 instead of 780 of another).
    /// What it is on another machine decides which method is chosen where two are near, and
    /// no more.
    pub fn cost(self, problem: &Problem, work: &Work) -> f64 {
        let weight = match self {
            FreeGauss => 0.09,
            Gauss => 0.84,
            SpinFreeGauss => 0.07,
            BodyGauss => 0.12,
            // A kick with its flow.
            Split(_) if problem.body.moments().is_symmetric() => 0.57,
            Split(_) => 1.50,
            Resisted(_) if problem.body.moments().is_symmetric() => 1.2,
            Resisted(_) => 2.2,
            Adaptive => 1.0,
            SpinFreeAdaptive => 0.62,
        };
        weight * work.torques() as f64
    }

    /// By what factor the cost grows when the level is raised by so much.
    pub fn dearer(self, levels: f64) -> f64 {
        exp(levels * LEVEL / self.order())
    }

    /// What is to divide an error on a part of the span, beside the part itself, for that at its
    /// end: those that keep no invariant lose more of the momentum as time goes on, and with it
    /// of the attitude with the square of the time.
    pub fn grown(self, part: f64) -> f64 {
        if self.is_adaptive() { part } else { 1.0 }
    }

    /// The least that a run with this error over a stretch may cost, and what a trial there
    /// would, beside a method that has been tried. The first splitting tells what others may
    /// do: of 450 trials on random motions their errors at the same level were below a thousandth
    /// of its in 7 %, where a method that would have been cheaper may stay untried.
    pub fn prospect(
        self,
        problem: &Problem,
        stretch: f64,
        error: f64,
        tried: &Candidate,
    ) -> [f64; 2] {
        let turned = self.turned(problem, stretch);
        let (level, torques, trials) = match self {
            FreeGauss | Gauss | SpinFreeGauss | BodyGauss => {
                // The sweeps that so many digits take.
                let digits = -log(error) / core::f64::consts::LN_10;
                (self.coarsest(), 5.6 * digits.max(4.0), 2.5 * 1.5)
            }
            Split(named) | Resisted(named) => {
                let kicks = named.scheme().map_or(7, |scheme| scheme.kicks()) as f64;
                let level = match tried.method {
                    Split(_) | Resisted(_) => tried.level(error / BETTER),
                    _ => self.coarsest(),
                };
                (level, kicks, 2.5)
            }
            Adaptive | SpinFreeAdaptive => (log(3e-7 / error) / LEVEL, 24.0, 2.5),
        };
        let weighed = |level: f64| {
            let steps = (turned / self.angle() * self.dearer(level.max(self.coarsest()))).max(1.0);
            let kicks = (steps * torques) as u64;
            self.cost(
                problem,
                &Work {
                    kicks,
                    ..Work::default()
                },
            )
        };
        let coarse = if self.sweeps() { self.coarsest() } else { 0.0 };
        [weighed(level), trials * weighed(coarse)]
    }

    /// A bound on the rates (rad/s) that this method has to follow.
    pub fn rate(self, problem: &Problem) -> f64 {
        let moments = problem.body.moments();
        match self {
            SpinFreeGauss | SpinFreeAdaptive | Split(_) | Resisted(_) => {
                // The axis turns with L/I1; falling sets free up to 2 m g l.
                let i1 = moments.i1();
                let turning = problem.start.angular_momentum.norm() / i1;
                let rate = turning + 2.0 * (problem.torque / i1).sqrt();
                match self {
                    // Nor are steps in their order that take most of the momentum at once.
                    Resisted(_) => rate.max(self.angle() * problem.damping),
                    _ => rate,
                }
            }
            FreeGauss | Gauss | BodyGauss | Adaptive => problem.fastest(),
        }
    }

    /// The angle (rad) turned until `t_end`, on which the number of steps rests; 1 at
    /// least, so that a finer level takes more steps of whatever seems at rest.
    pub fn turned(self, problem: &Problem, t_end: f64) -> f64 {
        (self.rate(problem) * t_end.abs()).max(1.0)
    }

    /// The steps of this level until `t_end` (not for adaptive methods).
    pub fn steps(self, problem: &Problem, t_end: f64, level: f64) -> f64 {
        self.turned(problem, t_end) / self.angle() * self.dearer(level)
    }

    /// The level at which this many steps are taken (not for adaptive methods).
    pub fn level_of(self, problem: &Problem, t_end: f64, steps: f64) -> f64 {
        let base = self.turned(problem, t_end) / self.angle();
        log(steps / base) * self.order() / LEVEL
    }

    /// Torques that a step takes, at most.
    pub const fn torques(self) -> f64 {
        match self {
            FreeGauss | Gauss | SpinFreeGauss | BodyGauss => 8.0 * 12.0,
            Split(_) | Resisted(_) => 14.0,
            Adaptive | SpinFreeAdaptive => 12.0,
        }
    }

    /// The state at `t_end` that follows from `start` at `t`, cut where the torque jumps;
    /// with how fine the run was: see [`Fine`]. What every piece took is added to `runs`.
    pub fn run(
        self,
        problem: &Problem,
        [t, t_end]: [f64; 2],
        start: &State,
        on_body: Option<[f64; 7]>,
        fine: Fine,
        runs: &mut Runs,
    ) -> Result<Passed> {
        let times = problem.pieces([t, t_end]);
        let mut passed = Passed {
            state: *start,
            on_body,
            work: Work::default(),
            level: f64::INFINITY,
            longest_step: 0.0,
        };
        for (n, piece) in times.windows(2).enumerate() {
            let now = Fine {
                budget: fine.budget.saturating_sub(passed.work.torques()),
                ..fine
            };
            let span = [piece[0], piece[1]];
            let fewest = fine.fewest.get(n).copied().unwrap_or(Steps::ONE);
            let more = self.run_piece(problem, span, &passed, now, fewest, &mut runs.work)?;
            runs.pieces.push(Steps {
                made: more.work.steps,
                ..fewest
            });
            runs.passed.push((piece[1], more.state));
            (passed.state, passed.on_body) = (more.state, more.on_body);
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
        start: &Passed,
        fine: Fine,
        steps: Steps,
        spent: &mut Work,
    ) -> Result<Passed> {
        let span = (t_end - t).abs();
        let fastest = if self.is_adaptive() {
            problem.regularized([t, t_end]).fastest()
        } else {
            1.0
        };
        let over = Error::OverBudget {
            t,
            t_end,
            budget: fine.budget,
        };
        let mut fewest = fastest * span / problem.longest_step;
        if self.is_adaptive() {
            // Finer runs take shorter steps also where none may be longer: runs that took
            // the same steps would agree, and say nothing.
            fewest *= self.dearer(fine.level - self.coarsest());
        }
        let fewest = steps.fewest.max(fewest.ceil() as u64);
        let affordable = fine.budget as f64 / self.torques();
        let carrier = if self.is_adaptive() {
            let tolerance = (1e-3 * exp(-LEVEL * fine.level))
                .clamp(Dop853::SMALLEST_TOLERANCE, Dop853::LARGEST_TOLERANCE);
            let method = Dop853::new(tolerance)?
                .with_longest_step(span / fewest as f64)?
                .with_step_limit(affordable.max(1.0) as u64)?;
            Carrier::Dop853(method)
        } else {
            let steps = self.steps(problem, t_end - t, fine.level);
            if steps.is_nan() || steps.max(fewest as f64) > affordable {
                return Err(over);
            }
            let steps = (steps.ceil() as u64).max(fewest);
            Carrier::new(self.method(), Fineness::Stages(steps, fine.precision))?
        };
        let mut work = Work::default();
        let run = match (problem.slender, carrier) {
            (Some(_), Carrier::Dop853(dop853)) if self == Adaptive => {
                let (start, on_body) = (&start.state, start.on_body);
                slender::carried(problem, &dop853, [t, t_end], start, on_body, &mut work)
                    .map(|(state, on_body)| (state, Some(on_body)))
            }
            _ => (problem.carried(
                &carrier,
                self.variables(),
                [t, t_end],
                &start.state,
                &mut work,
            ))
            .map(|state| (state, None)),
        };
        *spent += work;
        // A piece has its own time, from 0.
        let (state, on_body) = run.map_err(|error| match error {
            Error::TooManySteps { .. } => over,
            Error::StepUnderflow {
                t: since,
                step,
                state,
            } => Error::StepUnderflow {
                t: t + since,
                step,
                state,
            },
            Error::DerivativeNotFinite {
                t: since,
                state,
                derivative,
            } => Error::DerivativeNotFinite {
                t: t + since,
                state,
                derivative,
            },
            error => error,
        })?;
        // Steps are whole: the level is that of the steps taken.
        let (level, longest_step) = if self.is_adaptive() {
            (fine.level, (fastest * span / fewest as f64).min(span))
        } else {
            let steps = work.steps as f64;
            (self.level_of(problem, t_end - t, steps), span / steps)
        };
        Ok(Passed {
            state,
            on_body,
            work,
            level,
            longest_step,
        })
    }
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
}

/// More steps than these are refined by the error allowed for each.
const FEW: f64 = 8.0;

impl Steps {
    /// Nothing is asked for.
    pub const ONE: Self = Self {
        made: 0,
        fewest: 1,
        asked: 1.0,
    };

    /// Of another run in the same steps; those of an adaptive method are its own.
    pub fn again(self, method: Method) -> Self {
        Self {
            fewest: if method.is_adaptive() {
                self.fewest
            } else {
                self.made
            },
            ..self
        }
    }

    /// Of a run that is finer by so many levels, on every piece: runs that took the same
    /// steps over one of them would agree on it, and say nothing of its error.
    pub fn finer(self, method: Method, levels: f64) -> Self {
        let asked = self.asked.max(FEW.min(self.made as f64)) * method.dearer(levels);
        let fewest = if method.is_adaptive() {
            asked.ceil() as u64
        } else {
            1
        };
        Self {
            made: 0,
            fewest: fewest.max(self.made + 1),
            asked,
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

/// What runs took on one piece after the other, and the work of all, also of those that came
/// to no end.
#[derive(Debug, Default)]
pub(super) struct Runs {
    pub pieces: Vec<Steps>,
    /// The ends of the pieces.
    pub passed: Vec<(f64, State)>,
    pub work: Work,
}

/// Where a run has come, what it cost, and the level of the steps it took.
#[derive(Debug, Clone, Copy)]
pub(super) struct Passed {
    pub state: State,
    /// The same as a slender body is stepped: a [`State`] would blur its rates.
    pub on_body: Option<[f64; 7]>,
    pub work: Work,
    pub level: f64,
    /// No step was longer (s).
    pub longest_step: f64,
}
