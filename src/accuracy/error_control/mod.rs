//! Global error control: ask for an error at the end, get it or be told why not, see the price.
//!
//! | part | what it holds |
//! |---|---|
//! | [`Limits`] | the time of the start, break points, longest step, budget, a way to cancel |
//! | [`ExactMotion`] | a closed form, picked by what acts |
//! | [`SolvedMotion`] | the same promise all along the way: states at any times |
//! | [`Crossing`] | where a function of the state goes through zero on the way |
//! | `given` | what is asked, checked, and handed on to code that is compiled once for all effects |
//! | `problem` | every input a little changed: the condition |
//! | `method` | the methods, each with one knob, and the model of its first step |
//! | `refine` | a run, a finer run, a run with changed inputs, until they are near enough |
//! | `laws` | runs over what goes on in pieces: samples, and switches located as events |
//! | `slender` | bodies with one small moment, in variables of their own |
//! | `sliding` | why steps collapse |
//!
//! How it works, and how good it is: `book/src/how_error_control.md`.
//!
//! Not for: scenes with contacts, which have an error control of their own
//! ([`simulate_within`](crate::planar::simulate_within)).

mod along;
mod crossings;
mod exact_motion;
mod given;
mod laws;
mod limits;
mod method;
mod problem;
mod refine;
mod slender;
mod sliding;
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
    /// the floor far below the tolerance it is measured by a single change of all inputs, with the
    /// error of the coarser run in it. So it is mostly too large, and at most 1.9 times too small,
    /// as measured (`a_stepped_condition_covers_that_of_the_closed_form` in
    /// `tests/accuracy/error_control`). The moments of a slender body count as exact: a relative
    /// change of two that are nearly equal turns it about its thin axis by I_max/I_min times as
    /// much.
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
    /// *The contract.* It holds for torques that are smooth, or smooth between declared break
    /// points, samples and located switches ([`Law`](crate::effects::Law)), and without features
    /// narrower than a declared width or the looks below. The attitude at the end is within the
    /// error asked for, or the call is refused with the reason and, if runs bear one out, the error
    /// that can be had. For a torque of which nothing is declared the answer carries an *estimate*:
    /// of 36 100 over kinks, cusps and jumps one was above its request, by a sixth
    /// (`benches/record/attack.txt`). If it depends on the time, a search looks for jumps and kinks
    /// down to a 4096th of the span, on the body as it starts, and runs are cut at those that it
    /// finds. [`Solved::looked_every`] says how far the looks were apart and
    /// [`Solved::longest_step`] how long the steps were; narrower features are not looked for. No
    /// step is longer than half of what [`Effect::narrowest`] names.
    ///
    /// Where the scene has a closed form, that is taken. Every other scene is stepped: mostly a run
    /// with all its inputs a little changed, and a finer one, whose distance bounds the error and
    /// the condition at once. Where that does not suffice the condition is measured by runs of
    /// their own. Finer runs follow until twice the distance of the last two, with the errors of
    /// rounding and of the solution of implicit steps, is within the tolerance. Nothing stepped is
    /// returned unverified.
    ///
    /// | what acts | method |
    /// |---|---|
    /// | nothing (when stepped), or what is smooth and sees the axis only | Gauss-Legendre 16; of a symmetric body without its spin |
    /// | what resists in a known way ([`Effect::resistance`]) beside that, unless steps would have to follow it | splittings of order 4 (above 1e-5) and 6 with the resistance in their kick ([`Resisted`](crate::integrators::Resisted)) |
    /// | what is smooth between its break points | DOP853, below 1e-8 Gauss-Legendre 16 |
    /// | what is [sampled](crate::effects::SampledControl), [limited](crate::effects::Limited) or [switched](crate::effects::Switched) | DOP853 from sample to sample and from switch to switch |
    /// | whatever acts on a slender body, unless that is symmetric and its axis alone is seen | DOP853 with the momentum on the body's axes |
    /// | whatever else | DOP853, by three runs at least |
    ///
    /// Where a method does not converge the next is tried: DOP853 after the others, Gauss-Legendre after
    /// DOP853 if all is smooth.
    ///
    /// A body is slender if its moments are more than 16 times apart and its energy allows a rate five
    /// times the fastest that occurs, as a coarse trial run of the whole span shows. Of 60 random bodies
    /// with moments 33 to 1e6 times apart none was above its request. The run that is returned cost at
    /// most 2.8 times the cheapest that is as good in either kind of variables. All runs together cost
    /// at most 3.8 times the cheapest two, one forty times coarser, that show as good an error, and 6.2
    /// times the cheapest one (`tests/traps/thin_bodies.rs`).
    ///
    /// A known resistance counts as smooth where it is smooth along the motion. The drag on a disc
    /// has a kink where the body does not spin about e3, and never brings the spin of a symmetric
    /// body there. On a body with three different moments, whose spin about e3 passes through 0,
    /// only a linear resistance is known. The run that is returned takes a small part of what it
    /// would if nothing were said of the resistance (`what_resists_weakly_is_cheap` in
    /// `tests/accuracy/error_control`). A torque that is smooth and says so
    /// ([`Torque::smooth`](crate::effects::Torque::smooth)) is solved by less work.
    ///
    /// The *condition* is the change of the attitude at the end (rad) per relative change of the
    /// inputs. It is the root of the sum of squares over three turns of the start (per rad), three
    /// pushes (per |L|), the strength of the torque, three moments of inertia, and the time.
    /// Doubles hold inputs to eps; no method can promise less than a few eps (1 + condition).
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
    /// Accuracy, as measured on 600 random scenes at eleven tolerances (`tests/accuracy/error_control`):
    /// bodies with and without gravity, needles, separatrices, poles, upright and
    /// hanging tops, a torque that damps and drives. The median of delivered over requested, when
    /// everything is stepped, is 1e-4 to 3e-4 from 1e-3 to 1e-8, 9e-4 at 1e-11, 4e-3 at 1e-12 and
    /// 1.4e-2 at 1e-13; the largest was 0.68. Refused are 0.2 % at 1e-3, 1.3 % at
    /// 1e-9, 13 % at 1e-12 and 47 % at 1e-13.
    ///
    /// Price: two runs cost 1.4 to 2 times the one that is returned. All runs are compared with the
    /// cheapest run that would have sufficed, found afterwards. They cost 2.4 to 3.2 times as much
    /// under a weight or without a torque, and 3.5 to 6.7 times elsewhere (medians by kind of
    /// scene; `benches/record/price.txt`). Where a motion passes near a separatrix, or the floor
    /// comes near to what is asked, the condition is measured with more care, and that costs more.
    ///
    /// # Errors
    /// A tolerance outside its range, anything not finite, an energy at the start beyond `f64`; a
    /// span below 2.3e-308 s (but 0) where it is stepped; [`Error::Contradiction`](crate::Error::Contradiction) if an
    /// effect says of itself what its torque does not bear out, at the start or along the
    /// way, or if its torque is seen to remember (memory that shows late may go unnoticed);
    /// [`Error::NotDelivered`](crate::Error::NotDelivered) if the inputs, as doubles, do not
    /// determine the end so closely, or no method converges to it;
    /// [`Error::LimitReached`](crate::Error::LimitReached) if it takes more torques than
    /// [`Limits::budget`]; [`Error::Sliding`](crate::Error::Sliding) where the torque jumps with the
    /// state and drives the motion back from both sides; [`Error::Unseen`](crate::Error::Unseen) where runs do not agree, over
    /// a torque that depends on the time and may have features shorter than was looked for;
    /// [`Error::StepUnderflow`](crate::Error::StepUnderflow) where the motion itself is singular.
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
