//! The dial's promise all along the way.

use super::given::{Onward, Places};
use super::method::{Fine, Method, Steps};
use super::{ExactMotion, Limits, Solved};
use crate::body::State;
use crate::effects::Effect;
use crate::error::{Error, Result, finite};
use crate::motion::{Kept, Motion};
use crate::scene::Scene;

/// Runs are compared at so many places at most, one for every so many radians that the
/// body turns.
const ALONG: Places = Places::Along {
    most: 128,
    apart: 3.0,
};

/// A motion whose states are known to a tolerance at every time of its span.
///
/// Runs are compared, and the condition is felt, at up to 128 places. A state between two
/// of them is found by stepping on from the one before with the method and the fineness of
/// the run that was verified (before a singular time in the finest steps), so it is as good as its
/// neighbours; it costs a few steps.
pub struct SolvedMotion<'s> {
    solved: Solved,
    form: Form,
    onward: Onward<'s>,
    breaks: Vec<f64>,
    singular: Vec<f64>,
    kept: Vec<Kept>,
}

pub(super) enum Form {
    /// Start and end are one.
    Still(State),
    Exact(ExactMotion),
    Stepped {
        method: Method,
        level: f64,
        precision: f64,
        /// The states at equal distances, the start among them.
        places: Vec<State>,
        /// What was asked for on the pieces of the way to each of the others.
        steps: Vec<Vec<Steps>>,
    },
}

impl<E: Effect> Scene<E> {
    /// The motion from `start` to `t_end` (s) with an attitude that is off by `tolerance`
    /// (rad) or less at every time between.
    ///
    /// ```
    /// # use rotation_dynamics::{accuracy::Limits, attitude::Attitude, body::RigidBody};
    /// # use rotation_dynamics::{effects::GravityAtLever, frame::BodyVector};
    /// # use rotation_dynamics::{inertia::PrincipalMoments, scene::Scene};
    /// use rotation_dynamics::motion::Motion;
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
    /// let scene = Scene::new(body).with(GravityAtLever::new(1.0, 0.4)?);
    /// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0))?;
    /// let motion = scene.solve_along(&start, 20.0, 1e-9, &Limits::default())?;
    /// let there = motion.try_state(7.3)?;
    /// let alone = scene.solve(&start, 7.3, 1e-12)?;
    /// assert!(there.attitude.angle_to(&alone.state.attitude) <= 1e-9);
    /// assert!(motion.try_state(20.1).is_err());
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`Scene::solve_with`].
    pub fn solve_along(
        &self,
        start: &State,
        t_end: f64,
        tolerance: f64,
        limits: &Limits,
    ) -> Result<SolvedMotion<'_>> {
        let given = self.given(start, t_end, tolerance, limits)?;
        let answer = given.answer(ALONG, false)?;
        Ok(SolvedMotion {
            solved: answer.solved,
            form: answer.form,
            onward: Onward {
                effects: self.effects(),
                body: *self.body(),
                torque: given.torque,
                longest_step: given.longest_step,
                slender: given.slender,
                span: [limits.t_start, t_end],
            },
            breaks: given.breaks,
            singular: given.singular,
            kept: (self.invariants())
                .map(|invariant| {
                    let (name, unit) = invariant.name_and_unit();
                    Kept::new(name, unit, self.value(invariant, start))
                })
                .collect(),
        })
    }

    /// The states at these times (s), each with an attitude that is off by `tolerance`
    /// (rad) or less; they rise, or fall, from the time of the start.
    ///
    /// # Errors
    /// As [`Scene::solve_with`]; no times, or times out of order.
    pub fn solve_at(
        &self,
        start: &State,
        times: &[f64],
        tolerance: f64,
        limits: &Limits,
    ) -> Result<Vec<State>> {
        let Some(&t_end) = times.last() else {
            return Err(Error::Lengths {
                name: "times",
                found: 0,
                expected: 1,
            });
        };
        in_order(limits.t_start, times)?;
        let motion = self.solve_along(start, t_end, tolerance, limits)?;
        motion.try_states(times)
    }
}

/// Times that lead away from the start, each no nearer than the one before.
fn in_order(t_start: f64, times: &[f64]) -> Result<()> {
    let mut before = finite("start time", t_start)?;
    let direction = times[times.len() - 1] - t_start;
    for (index, &t) in times.iter().enumerate() {
        finite("time", t)?;
        if (t - before) * direction < 0.0 {
            return Err(Error::NotRising {
                name: "time",
                index,
                before,
                value: t,
            });
        }
        before = t;
    }
    Ok(())
}

impl Motion for SolvedMotion<'_> {
    type State = State;

    fn name(&self) -> &'static str {
        self.solved.method
    }

    fn try_state(&self, t: f64) -> Result<State> {
        self.found(t)
    }

    fn kept(&self) -> Vec<Kept> {
        self.kept.clone()
    }

    /// The largest of the whole way.
    fn condition(&self, t: f64) -> Result<f64> {
        self.inside(t)?;
        Ok(self.solved.condition)
    }
}

impl SolvedMotion<'_> {
    /// What was solved: the state at the end, the method, estimates for the whole of the
    /// way, work.
    pub const fn solved(&self) -> &Solved {
        &self.solved
    }

    /// The time of the start and that of the end (s).
    pub const fn span(&self) -> [f64; 2] {
        self.onward.span
    }

    fn inside(&self, t: f64) -> Result<()> {
        finite("time", t)?;
        let [from, to] = self.span();
        let (first, last) = (from.min(to), from.max(to));
        if !(first..=last).contains(&t) {
            return Err(Error::OutsideRun {
                t,
                start: first,
                end: last,
            });
        }
        Ok(())
    }

    fn found(&self, t: f64) -> Result<State> {
        self.inside(t)?;
        let [from, _] = self.span();
        match &self.form {
            Form::Still(state) => Ok(*state),
            Form::Exact(motion) => motion.at(t - from),
            Form::Stepped {
                method,
                level,
                precision,
                places,
                steps,
            } => {
                let legs = places.len() - 1;
                let (leg, before) = self.before(legs, t);
                let place = &places[leg];
                if t == before {
                    return Ok(*place);
                }
                // The run went on in a time that knew of what is ahead.
                let next = self.place(leg + 1, legs);
                let level = if method.is_adaptive() && self.is_before_a_singular_time(t, next) {
                    method.finest()
                } else {
                    *level
                };
                let fine = Fine {
                    level,
                    fewest: &steps[leg],
                    precision: *precision,
                    budget: u64::MAX,
                };
                self.onward.state(
                    [&self.breaks, &self.singular],
                    *method,
                    fine,
                    [before, t],
                    place,
                )
            }
        }
    }

    /// The place after so many legs of all.
    fn place(&self, leg: usize, legs: usize) -> f64 {
        let [from, to] = self.span();
        if leg == legs {
            to
        } else {
            from + leg as f64 / legs as f64 * (to - from)
        }
    }

    /// True if the piece of the run in which `t` is, before this place, ends where the torque is
    /// singular.
    fn is_before_a_singular_time(&self, t: f64, place: f64) -> bool {
        let [from, to] = self.span();
        let between =
            |time: &f64| (time - t) * (to - from) > 0.0 && (place - time) * (to - from) > 0.0;
        let end = self.breaks.iter().find(|time| between(time));
        self.singular.contains(end.unwrap_or(&place))
    }

    /// The last place that is not after `t`, by its number, and its time.
    fn before(&self, legs: usize, t: f64) -> (usize, f64) {
        let [from, to] = self.span();
        let part = (t - from) / (to - from);
        let mut leg = ((part * legs as f64) as usize).min(legs);
        // Rounding may have put it a leg too far.
        if (t - self.place(leg, legs)) * (to - from) < 0.0 && leg > 0 {
            leg -= 1;
        }
        (leg, self.place(leg, legs))
    }
}
