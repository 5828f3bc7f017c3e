//! Global error control: ask for an error at the end, get it or be told why not, see the price.
//!
//! | part | what it holds |
//! |---|---|
//! | [`Limits`] | the time of the start, break points, longest step, budget, a way to cancel |
//! | [`ExactMotion`] | a closed form, picked by what acts |
//! | [`SolvedMotion`] | the same promise all along the way: states at any times |
//! | [`Crossing`] | where a function of the state goes through zero on the way |
//! | `given` | what is asked, checked, and handed on to code that is compiled once for all effects |
//! | `refine` | the loop: a run, a finer run, until they are near enough |
//! | `constants` | all that is tuned, and why |
//! | `condition` | by how much the motion moves per change of the inputs |
//! | `changed` | a problem with every input a little changed |
//! | `problem` | what is stepped, and how |
//! | `method` | the methods, each with one setting, and what it does on a turn |
//! | `run` | a run over the pieces of the way |
//! | `laws` | runs over what goes on in pieces: samples, and switches located as events |
//!
//! A tolerance goes from [`Scene::solve`] through `given` to `refine`, where it is last compared.
//!
//! How it works, and how good it is: `book/src/how_error_control.md`.
//!
//! Not for: scenes with contacts, which have an error control of their own
//! ([`simulate_within`](crate::planar::simulate_within)).

mod along;
mod changed;
mod condition;
mod constants;
mod crossings;
mod exact_motion;
mod given;
mod laws;
mod limits;
mod method;
mod problem;
mod refine;
mod run;
#[cfg(test)]
mod tests;

pub use along::SolvedMotion;
pub(super) use along::at;
pub use crossings::Crossing;
pub use exact_motion::ExactMotion;
pub use limits::Limits;

use crate::body::State;
#[cfg(doc)]
use crate::effects::Effect;
use crate::effects::erased::AnyEffect;
use crate::error::Result;
use crate::integrators::Work;
use crate::scene::Scene;
use given::{Given, Places};
use problem::Problem;
use refine::Delivered;

/// A state with an error as requested, and its cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solved {
    /// The state at the end.
    pub state: State,
    /// The method of the run returned, or the closed form.
    pub method: &'static str,
    /// The cost of the run that this state is from.
    pub run: Work,
    /// The cost of all runs together: those that verified, those that measured the condition, and
    /// those that came to no end.
    pub work: Work,
    /// The part of that cost for the condition alone: nothing where the first two runs show it.
    pub probes: Work,
    /// The torques of all runs divided by those of the returned one.
    pub price: f64,
    /// An upper estimate of the angle (rad) between this attitude and the true one.
    pub estimate: f64,
    /// The same of the angular momentum, as a part of its scale
    /// ([`Errors`](crate::accuracy::Errors)).
    pub momentum_estimate: f64,
    /// The same of the angular velocity.
    pub rates_estimate: f64,
    /// The angle (rad) by which the end changes per relative change of the inputs. Where it leaves
    /// the floor far below the tolerance a single change of all inputs tells it; that of the first run has
    /// the error of that run in it, and tells too much. It is at most 1.9 times too small,
    /// as measured (`a_stepped_condition_covers_that_of_the_closed_form` in
    /// `tests/accuracy/error_control`).
    pub condition: f64,
    /// No step was longer (s; 0 for a closed form). A feature of the torque that is
    /// narrower, and that nothing names, may have been stepped over by every run.
    pub longest_step: f64,
    /// A torque that depends on the time and names no width was looked at once in this time (s). A
    /// shorter feature that no break point names may be unseen. `None` where nothing was looked
    /// for.
    pub looked_every: Option<f64>,
}

impl<E: AnyEffect> Scene<E> {
    /// The state at `t_end` (s; may be negative) that follows from `start` at t = 0,
    /// with an attitude that is off by `tolerance` (rad, above 0, at most pi) or less.
    ///
    /// *The contract.*
    /// 1. For torques that are smooth, or smooth between declared break points, samples and located
    ///    switches ([`Law`](crate::effects::Law)), without features narrower than a declared width
    ///    ([`Effect::narrowest`]) or the looks of sentence 4, the attitude at the end is within the error
    ///    asked for, or the call is refused with a reason.
    /// 2. For a torque of which nothing is declared the answer carries an *estimate*: of 36 100 over
    ///    kinks, cusps and jumps one was above its request, by a sixth (`benches/record/attack.txt`).
    /// 3. If such a torque depends on the time, a search looks for jumps and kinks in time down to a
    ///    4096th of the span, on the body as it starts, and runs are cut at those that it finds.
    /// 4. [`Solved::looked_every`] says how far the looks were apart and [`Solved::longest_step`] how
    ///    long the steps were; narrower features are not looked for.
    /// 5. A refusal for want of accuracy names the least error that runs bear out, if there is one.
    ///
    /// A closed form is taken where the scene has one. Every other scene is stepped by two runs or
    /// more, and nothing stepped is returned unverified. Which method is taken, how runs verify each
    /// other and what that costs: `book/src/how_error_control.md`. A torque that is smooth and says so
    /// ([`Torque::smooth`](crate::effects::Torque::smooth)) is solved by less work.
    ///
    /// ```
    /// use rotation_dynamics::attitude::Attitude;
    /// use rotation_dynamics::body::RigidBody;
    /// use rotation_dynamics::effects::GravityAtLever;
    /// use rotation_dynamics::frame::BodyVector;
    /// use rotation_dynamics::inertia::PrincipalMoments;
    /// use rotation_dynamics::scene::Scene;
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// // Three different moments: no closed form.
    /// let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
    /// let scene = Scene::new(body).with(GravityAtLever::new(1.0, 0.4)?);
    /// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0))?;
    /// let solved = scene.solve(&start, 20.0, 1e-9)?;
    /// assert!(solved.estimate <= 1e-9);
    /// let better = scene.solve(&start, 20.0, 1e-11)?;
    /// assert!(better.state.attitude.angle_to(&solved.state.attitude) <= 1e-9);
    /// assert!(scene.solve(&start, 20.0, 1e-15).is_err());
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// Accuracy, as measured on 600 random scenes at eleven tolerances (`tests/accuracy/error_control`),
    /// all stepped: the median of delivered over requested is 7e-6 at 1e-3, 3e-5 at 1e-9 and 1.5e-2
    /// at 1e-13; the largest was 0.64. Refused are 0.2 % at 1e-3, 1.3 % at 1e-9, 14 % at 1e-12 and 48 %
    /// at 1e-13.
    ///
    /// # Errors
    /// A tolerance outside its range, anything not finite, an energy at the start beyond `f64`; a
    /// span below 2.3e-308 s (but 0) where it is stepped; [`Error::Contradiction`](crate::Error::Contradiction) if an
    /// effect says of itself what its torque does not bear out, at the start or along the
    /// way, or if its torque is seen to remember (memory that shows late may go unnoticed);
    /// [`Error::NotDelivered`](crate::Error::NotDelivered) if the inputs, as doubles, do not
    /// determine the end so closely, or no method converges to it;
    /// [`Error::LimitReached`](crate::Error::LimitReached) if it takes more torques than
    /// [`Limits::budget`]; [`Error::Sliding`](crate::Error::Sliding) where a declared switch drives the
    /// motion back from both sides; [`Error::Undeclared`](crate::Error::Undeclared) where runs
    /// take too much over a torque that is not called smooth;
    /// [`Error::StepUnderflow`](crate::Error::StepUnderflow) where DOP853 meets a motion that is singular, or
    /// a jump.
    pub fn solve(&self, start: &State, t_end: f64, tolerance: f64) -> Result<Solved> {
        self.solve_with(start, t_end, tolerance, &Limits::default())
    }

    /// As [`Scene::solve`], from another time than 0, with break points, a longest step, a
    /// budget or a way to cancel.
    ///
    /// # Errors
    /// As [`Scene::solve`]; limits that contradict the span; [`Error::Cancelled`](crate::Error::Cancelled).
    pub fn solve_with(
        &self,
        start: &State,
        t_end: f64,
        tolerance: f64,
        limits: &Limits,
    ) -> Result<Solved> {
        solve(self, start, t_end, tolerance, limits, false)
    }

    /// As [`Scene::solve`], but by stepping, whether there is a closed form or not: so a
    /// closed form can judge what `solve` delivers.
    ///
    /// # Errors
    /// As [`Scene::solve`].
    pub fn solve_by_stepping(&self, start: &State, t_end: f64, tolerance: f64) -> Result<Solved> {
        solve(self, start, t_end, tolerance, &Limits::default(), true)
    }
}

/// [`Scene::solve_with`], or [`Scene::solve_by_stepping`] with limits.
pub(super) fn solve(
    scene: &Scene<dyn AnyEffect + '_>,
    start: &State,
    t_end: f64,
    tolerance: f64,
    limits: &Limits,
    by_stepping: bool,
) -> Result<Solved> {
    let given = Given::new(scene, start, t_end, tolerance, limits)?;
    Ok(given.answer(Places::End, by_stepping)?.solved)
}

impl Solved {
    fn of(delivered: &Delivered, problem: &Problem, looked_every: Option<f64>) -> Self {
        let [estimate, momentum_estimate, rates_estimate] = delivered.estimate;
        Self {
            state: (delivered.run.passed.last()).map_or(problem.start, |(_, stop)| stop.state),
            method: delivered.method.name,
            run: delivered.run.work,
            work: delivered.work,
            probes: delivered.probes,
            price: delivered.work.torques() as f64 / delivered.run.work.torques() as f64,
            estimate,
            momentum_estimate,
            rates_estimate,
            condition: delivered.condition[0],
            longest_step: delivered.run.longest_step,
            looked_every,
        }
    }
}
