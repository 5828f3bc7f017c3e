//! The dial: ask for an error at the end, get it or be told why not, see the price.
//!
//! | part | what it holds |
//! |---|---|
//! | [`Limits`] | the time of the start, break points, longest step, budget, a way to cancel |
//! | [`ExactMotion`] | a closed form, picked by what acts |
//! | [`SolvedMotion`] | the promise kept all along the way: states at any times |
//! | `given` | what is asked, checked, and handed on to code that is compiled once for all effects |
//! | `problem` | every input a little changed: the condition |
//! | `method` | the methods, each with one knob |
//! | `two_runs` | two runs that mostly suffice, by what methods did on many motions |
//! | `choice` | what each method does on the first turns |
//! | `probes` | the condition felt on runs of the motion |
//! | `stepping` | refine, verify |
//! | `sliding` | why steps collapse |
//!
//! What is verified, and why what is delivered is better: `book/src/how_dial.md`.
//!
//! Not for: scenes with contacts, which have a dial of their own
//! ([`simulate_within`](crate::planar::simulate_within)).

mod along;
mod choice;
mod exact_motion;
mod given;
mod limits;
mod method;
mod probes;
mod problem;
mod regularized;
mod slender;
mod sliding;
mod stepping;
#[cfg(test)]
mod tests;
mod two_runs;
mod verdict;

pub use along::SolvedMotion;
pub use exact_motion::ExactMotion;
pub use limits::Limits;

use crate::body::State;
use crate::effects::AnyEffect;
#[cfg(doc)]
use crate::effects::Effect;
use crate::error::Result;
use crate::integrators::Work;
use crate::scene::Scene;
use given::{Given, Places};
use problem::Problem;
use stepping::Delivered;

/// A state whose error was asked for, and what it cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solved {
    /// The state at the end.
    pub state: State,
    /// The method that was chosen.
    pub method: &'static str,
    /// What the run cost that this state is from.
    pub run: Work,
    /// What all runs together cost: those that chose, those that verified, those that
    /// felt the condition, and those that came to no end.
    pub work: Work,
    /// What of that went into the choice of the method.
    pub choice: Work,
    /// What of that went into the condition alone: nothing where two runs suffice, or a third that
    /// follows them at once.
    pub probes: Work,
    /// What all runs cost over what the one cost that is returned, by the time that their
    /// torques take.
    pub price: f64,
    /// An upper estimate of the angle (rad) between this attitude and the true one.
    pub estimate: f64,
    /// The same of the angular momentum, as a part of its scale
    /// ([`Errors`](crate::accuracy::Errors)).
    pub momentum_estimate: f64,
    /// The same of the angular velocity.
    pub rates_estimate: f64,
    /// The angle (rad) by which the end changes per relative change of the inputs. Where two runs
    /// suffice, or a third that follows them at once, it is felt by one change of all inputs, with
    /// the error of the coarser run in it, and mostly too large, with three runs up to some thousand
    /// times; at most 2.3 times too small, as measured
    /// (`a_stepped_condition_covers_that_of_the_closed_form` in `tests/accuracy/dial`). The moments of
    /// a slender body count as exact: a relative change of two that are nearly equal turns it about
    /// its thin axis by I_max/I_min times as much.
    pub condition: f64,
    /// No step was longer (s; 0 for a closed form). A feature of the torque that is
    /// narrower, and that nothing names, may have been stepped over by every run.
    pub longest_step: f64,
    /// A torque that depends on the time and names no width was looked at once in this time (s):
    /// what is shorter, and named by no break point, may be unseen. `None` where nothing was looked
    /// for.
    pub looked_every: Option<f64>,
}

impl<E: AnyEffect> Scene<E> {
    /// The state at `t_end` (s; may be negative) that follows from `start` at t = 0,
    /// with an attitude that is off by `tolerance` (rad, above 0, at most pi) or less.
    ///
    /// Where the scene has a closed form, that is taken. Every other scene is stepped. Mostly two runs of the span suffice, by the method
    /// that is expected to be cheapest: the coarser has all its inputs a little changed, so that
    /// the distance of the two bounds the error of the finer and the condition at once. Both
    /// show on the first turn of the motion whether they are fine enough, and go on from there.
    /// Where that does not suffice, finer runs go on from these, with the condition as they bound it
    /// or felt on them; or methods are tried on the first turn, and the one predicted cheapest
    /// for the error asked for carries the whole span, coarser and finer, until the runs differ as
    /// their order says they must and what that leaves is within the tolerance. Where that does not
    /// either, all of them do in turn, by three runs or more and with the condition felt in many legs,
    /// before anything is refused as not delivered. Nothing is returned unverified.
    ///
    /// | what acts | methods that are tried |
    /// |---|---|
    /// | nothing (when stepped) | Gauss-Legendre 16, DOP853 |
    /// | what sees the axis only | splittings, Gauss-Legendre 16 and DOP853; of a symmetric body without its spin |
    /// | the same beside what resists in a known way ([`Effect::resistance`]) | splittings with the resistance in their kick ([`Resisted`](crate::integrators::Resisted)), Gauss-Legendre 16, DOP853 |
    /// | whatever is smooth between its break points | Gauss-Legendre 16, DOP853 |
    /// | anything that acts on a slender body, unless that is symmetric and its axis alone is seen | DOP853 with the momentum on the body's axes |
    /// | whatever else | DOP853 |
    ///
    /// A body is slender if its moments are more than 16 times apart and its energy allows a rate five
    /// times the fastest that occurs, as a coarse trial run of the whole span shows. Two more in the
    /// steps of another coarse run show its condition. What these put out of reach is refused at once.
    /// Of 60 random bodies with moments 33 to 1e6 times apart none was above its request. The run that
    /// is returned cost at most 2.9 times, all runs together 7.3 times the cheapest that is as good in
    /// either kind of variables (`tests/traps/thin_bodies.rs`).
    ///
    /// Over a torque that is not known to be smooth runs may agree by chance, for each errs at a kink
    /// by what its steps happen to be off: what three runs say counts three times there, and a
    /// distance no less than those before it fallen as they should. A torque that is smooth and says so
    /// ([`Torque::smooth`](crate::effects::Torque::smooth)) is solved by less work.
    ///
    /// What resists in a known way counts as smooth where it is smooth along the motion: the drag
    /// on a disc has a kink where the body does not spin about e3, and never brings the spin of a
    /// symmetric body there. On a body with three different moments, whose spin about e3 passes
    /// through 0, only a linear resistance is known. The run that is returned takes a small part of
    /// what it would if nothing were said of the resistance (`what_resists_weakly_is_cheap` in
    /// `tests/accuracy/dial`).
    ///
    /// The *condition* is the change of the attitude at the end (rad) per relative
    /// change of the inputs: the root of the sum of squares over three turns of the
    /// start (per rad), three pushes (per |L|), the strength of the torque, three
    /// moments of inertia, and the time. Doubles hold inputs to eps; no method can
    /// promise less than a few eps (1 + condition).
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
    /// Accuracy, as measured on 600 random scenes at eleven tolerances (`tests/accuracy/dial`):
    /// bodies with and without gravity, needles, separatrices, poles, upright and
    /// hanging tops, a torque that damps and drives. The median of delivered over requested, when
    /// everything is stepped, is 4e-4 to 8e-4 from 1e-3 to 1e-9, 9e-4 at 1e-10, 1.2e-3 at 1e-11,
    /// 3e-3 at 1e-12 and 1.4e-2 at 1e-13; the largest was 0.64. Refused are 0.2 % at 1e-3, 1.3 % at
    /// 1e-9, 13 % at 1e-12 and 47 % at 1e-13.
    ///
    /// Price: where two runs suffice, all runs together cost 1.4 to 2 times the one that is
    /// returned. That is 1.7 to 2.7 times the cheapest run that is as good, as hindsight knows it.
    /// Over the cheapest that would have sufficed it is 2.4 to 3.3 times under a weight or without a
    /// torque, and 3.8 to 6.1 times elsewhere (medians by kind of scene;
    /// `benches/record/price.txt`): the most where the torque has kinks, of which
    /// nothing says where, or depends on the time. Where a motion passes near a separatrix, or the
    /// floor comes near to what is asked, the condition is felt with more care, and that is dearer.
    ///
    /// *What the verdict rests on.* A finer run is finer on every piece between two jumps and
    /// two places looked at. Two runs that suffice part nowhere on the way, and their steps resolve
    /// the fastest rotation. The same holds of the first two where a third follows at once, since
    /// the torque may jump or is narrow, or since they are a little too far apart. Otherwise the
    /// condition is felt by two more runs in the steps of the first, or where that is not enough on
    /// a motion whose own error, times that condition, is small; runs that differ ten times more
    /// than their errors on the first turns and the condition predict are not believed (unless the
    /// torque depends on the time and may have come later), and it is felt again on the finest
    /// motion there is.
    ///
    /// *What is promised of features of the torque.* Its jumps at times that are named
    /// ([`Effect::break_points`], [`Limits::break_points`]) are met exactly, and no step is
    /// longer than half of what [`Effect::narrowest`] names. Of an effect that depends on
    /// the time and names no width, the torque on the body as it starts is looked at at 4097
    /// times: a jump between two of them, of an effect that does not claim to be smooth, is
    /// found to the last bit and met as if it were named, and so is a kink, to what rounding
    /// leaves of it; a pulse that lasts longer than the
    /// time between two of them is seen, and taken in steps of twice the time in which it comes, or
    /// of eight times that where the torque goes to and fro all along. A narrower one, a jump or a
    /// kink that the torque has only on a body that moves otherwise, or a bump in space
    /// that is narrower than a step may be missed by all runs alike; so may the weaker of two kinks
    /// within some looks, and one whose sides are opposite, as of a signed root. (Of kinks that were so
    /// hidden no answer of 195 was above its request.)
    /// [`Solved::longest_step`] says how long the steps were, [`Solved::looked_every`] how far the
    /// looks were apart.
    ///
    /// # Errors
    /// A tolerance outside its range, anything not finite, an energy at the start beyond `f64`; a
    /// span below 2.3e-308 s (but 0) where it is stepped; [`Error::Contradiction`](crate::Error::Contradiction) if an
    /// effect says of itself what its torque does not bear out, at the start or along the
    /// way; [`Error::BeyondCondition`](crate::Error::BeyondCondition) if the inputs, as doubles, do not determine the end
    /// so closely; [`Error::NotDelivered`](crate::Error::NotDelivered) if no method converges to it;
    /// [`Error::OverBudget`](crate::Error::OverBudget) if it takes more torques than
    /// [`Limits::budget`]; [`Error::Sliding`](crate::Error::Sliding) where steps collapse at a jump of
    /// the torque with the state; [`Error::Unseen`](crate::Error::Unseen) where runs do not agree, over
    /// a torque that depends on the time and may have features shorter than was looked for;
    /// [`Error::StepUnderflow`](crate::Error::StepUnderflow) where the motion itself is singular;
    /// [`Error::NotAFunction`](crate::Error::NotAFunction) if the torque is seen
    /// to remember: memory that shows late may go unnoticed.
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
        let given = self.given(start, t_end, tolerance, limits)?;
        Ok(given.answer(Places::End, false)?.solved)
    }

    /// As [`Scene::solve`], but by stepping, whether there is a closed form or not: so a
    /// closed form can judge what the dial delivers.
    ///
    /// # Errors
    /// As [`Scene::solve`].
    pub fn solve_by_stepping(&self, start: &State, t_end: f64, tolerance: f64) -> Result<Solved> {
        let limits = Limits::default();
        let given = self.given(start, t_end, tolerance, &limits)?;
        Ok(given.answer(Places::End, true)?.solved)
    }

    fn given<'s>(
        &'s self,
        start: &State,
        t_end: f64,
        tolerance: f64,
        limits: &Limits<'s>,
    ) -> Result<Given<'s>> {
        Given::new(self.effects(), self.body(), start, t_end, tolerance, limits)
    }
}

impl Solved {
    fn of(delivered: &Delivered, problem: &Problem, looked_every: Option<f64>) -> Self {
        let [estimate, momentum_estimate, rates_estimate] = delivered.estimate;
        Self {
            state: (delivered.passed.last()).map_or(problem.start, |(_, state)| *state),
            method: delivered.method.name(),
            run: delivered.run,
            work: delivered.work,
            choice: delivered.choice,
            probes: delivered.probes,
            price: delivered.price,
            estimate,
            momentum_estimate,
            rates_estimate,
            condition: delivered.condition[0],
            longest_step: delivered.longest_step,
            looked_every,
        }
    }
}
