//! `solve`'s promise all along the way.

use super::constants::FEW;
use super::given::{Given, Places};
use super::method::Method;
use super::refine::stops;
use super::run::{Fine, Steps, Stop};
use super::{ExactMotion, Limits, Solved};
use crate::body::{RigidBody, State};
use crate::effects::erased::AnyEffect;
use crate::error::{Error, Result, finite};
use crate::integrators::Work;
use crate::math::{order_of, sort_by_number};
use crate::motion::{Kept, Motion};
use crate::scene::Scene;

/// A motion whose states are known to a tolerance at every time of its span.
///
/// Runs are compared, and the condition is measured, at up to 128 places. A state between two of
/// them is found by stepping on from the one before, with the method and the resolution of the run
/// that was verified. So it is as good as its neighbours, and it is the same whatever other times
/// are asked for. Many times ([`Motion::try_states`]) cost some steps for each, and the steps of
/// the run once; one alone costs the steps from the place before it. [`Limits::budget`] counts them
/// with what was solved, and [`Limits::cancel`] ends them.
pub struct SolvedMotion<'s> {
    given: Given<'s>,
    solved: Solved,
    form: Form,
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
        /// The start, and the ends of the pieces of the run, with their times.
        passed: Vec<(f64, Stop)>,
        /// The steps asked for on each piece, and made.
        steps: Vec<Steps>,
    },
}

/// How far the states of a stepped motion have been found.
#[derive(Clone)]
pub(super) struct Found {
    /// The part of a piece, by the numbers of both, and the state from which it starts.
    piece: usize,
    part: u64,
    stop: Stop,
    /// A part is so many steps.
    steps: u64,
    /// Its work.
    pub work: Work,
}

impl<E: AnyEffect> Scene<E> {
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
    pub fn solve_along<'s>(
        &'s self,
        start: &State,
        t_end: f64,
        tolerance: f64,
        limits: &Limits<'s>,
    ) -> Result<SolvedMotion<'s>> {
        along(self, start, t_end, tolerance, limits)
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
        at(self, start, times, tolerance, limits)
    }
}

/// [`Scene::solve_along`].
fn along<'s>(
    scene: &'s Scene<dyn AnyEffect + 's>,
    start: &State,
    t_end: f64,
    tolerance: f64,
    limits: &Limits<'s>,
) -> Result<SolvedMotion<'s>> {
    let given = Given::new(scene, start, t_end, tolerance, limits)?;
    let answer = given.answer(Places::Along, false)?;
    let kept = scene.invariants().map(|invariant| {
        let (name, unit) = invariant.name_and_unit();
        Kept::new(name, unit, scene.value(invariant, start))
    });
    Ok(SolvedMotion { given, solved: answer.solved, form: answer.form, kept: kept.collect() })
}

/// [`Scene::solve_at`].
pub(in crate::accuracy) fn at(
    scene: &Scene<dyn AnyEffect + '_>,
    start: &State,
    times: &[f64],
    tolerance: f64,
    limits: &Limits,
) -> Result<Vec<State>> {
    let Some(&t_end) = times.last() else {
        return Err(Error::Lengths { name: "times", found: 0, expected: 1 });
    };
    in_order(limits.t_start, times)?;
    along(scene, start, t_end, tolerance, limits)?.try_states(times)
}

/// Times that lead away from the start, each no nearer than the one before.
fn in_order(t_start: f64, times: &[f64]) -> Result<()> {
    let mut before = finite("start time", t_start)?;
    let direction = times[times.len() - 1] - t_start;
    for (index, &t) in times.iter().enumerate() {
        finite("time", t)?;
        if (t - before) * direction < 0.0 {
            return Err(Error::not_rising("times", index, before, t));
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
        self.inside(t)?;
        self.state(t, &mut self.found(FEW))
    }

    fn try_states(&self, times: &[f64]) -> Result<Vec<State>> {
        let at = |index: usize, reason: Error| Error::AtIndex {
            name: "times",
            index,
            reason: Box::new(reason),
        };
        for (index, t) in times.iter().enumerate() {
            self.inside(*t).map_err(|reason| at(index, reason))?;
        }
        let [from, to] = self.span();
        let mut order = order_of(times);
        if to < from {
            order.reverse();
        }
        let mut found = self.found(FEW);
        let mut states = Vec::with_capacity(times.len());
        for index in order {
            match self.state(times[index], &mut found) {
                Ok(state) => states.push((index, state)),
                Err(error) if stops(&error) => return Err(error),
                Err(error) => return Err(at(index, error)),
            }
        }
        sort_by_number(&mut states, |(index, _)| *index as f64);
        Ok(states.into_iter().map(|(_, state)| state).collect())
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
    /// The solution: the state at the end, the method, estimates for the whole of the way, work.
    pub const fn solved(&self) -> &Solved {
        &self.solved
    }

    /// The times of the start and of the end (s).
    pub const fn span(&self) -> [f64; 2] {
        self.given.span()
    }

    fn inside(&self, t: f64) -> Result<()> {
        finite("time", t)?;
        let [from, to] = self.span();
        let (first, last) = (from.min(to), from.max(to));
        if !(first..=last).contains(&t) {
            return Err(Error::OutsideRun { t, start: first, end: last });
        }
        Ok(())
    }

    pub(super) const fn body(&self) -> &RigidBody {
        self.given.body()
    }

    /// The longest step that was asked for.
    pub(super) const fn longest_step(&self) -> f64 {
        self.given.limits.longest_step
    }

    /// The possible errors of the states, as [`Self::moved`] moves them: three turns (rad), three
    /// pushes.
    pub(super) fn errors(&self) -> [f64; 6] {
        let Solved { estimate: turn, momentum_estimate: push, .. } = self.solved;
        [turn, turn, turn, push, push, push]
    }

    /// A state with one of its six inputs moved.
    pub(super) fn moved(&self, state: &State, input: usize, by: f64) -> Result<State> {
        let inputs = core::array::from_fn(|i| f64::from(u8::from(i == input)));
        self.given.problem().moved(state, inputs, by)
    }

    /// Nothing yet, to be found in parts of so many steps.
    pub(super) fn found(&self, steps: u64) -> Found {
        Found {
            piece: usize::MAX,
            part: 0,
            stop: Stop::at(self.given.start),
            steps,
            work: Work::default(),
        }
    }

    /// The state at a time, from where those before it were found.
    pub(super) fn state(&self, t: f64, here: &mut Found) -> Result<State> {
        let [from, to] = self.span();
        let (method, level, precision, passed, steps) = match &self.form {
            Form::Still(state) => return Ok(*state),
            Form::Exact(motion) => return motion.at(t - from),
            Form::Stepped { method, level, precision, passed, steps } => {
                (*method, *level, *precision, passed, steps)
            }
        };
        let is_after = |other: f64| if to < from { other < t } else { other > t };
        let piece = passed.partition_point(|(at, _)| !is_after(*at)) - 1;
        let (begun, stop) = &passed[piece];
        let begun = *begun;
        if begun == t {
            return Ok(stop.state);
        }
        let end = passed[piece + 1].0;
        let parts = steps[piece].made.div_ceil(here.steps).max(1);
        let at = |part: u64| begun + part as f64 / parts as f64 * (end - begun);
        if here.piece != piece {
            (here.piece, here.part) = (piece, 0);
            here.stop = stop.clone();
        }
        let problem = self.given.problem();
        let mut fewest = steps[piece];
        fewest.fewest = fewest.fewest.div_ceil(parts);
        let limits = &self.given.limits;
        let go_on = |from: f64, to: f64, here: &mut Found| -> Result<Stop> {
            let spent = self.solved.work.torques() + here.work.torques();
            let over = Error::LimitReached {
                what: "torques",
                t: self.span()[0],
                t_end: self.span()[1],
                limit: limits.budget,
            };
            let budget = limits.left(spent)?;
            if budget == 0 {
                return Err(over);
            }
            let fine = Fine { level, fewest: &[fewest], precision, budget };
            match method.run(&problem, [from, to], &here.stop, fine, &mut here.work) {
                Err(Error::LimitReached { .. }) => Err(over),
                run => Ok(run?.end()),
            }
        };
        while here.part + 1 < parts && !is_after(at(here.part + 1)) {
            here.stop = go_on(at(here.part), at(here.part + 1), here)?;
            here.part += 1;
        }
        let from = at(here.part);
        if from == t {
            return Ok(here.stop.state);
        }
        Ok(go_on(from, t, here)?.state)
    }
}
