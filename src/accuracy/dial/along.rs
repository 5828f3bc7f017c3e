//! The dial's promise all along the way.

use super::method::{Fine, Method};
use super::problem::Problem;
use super::stepping::Stepping;
use super::{ExactMotion, Limits, Solved, by_closed_form, nothing_to_do};
use crate::body::State;
use crate::effects::{Checked, Effect};
use crate::error::{Error, Result, finite};
use crate::scene::Scene;
use core::cell::Cell;

/// Places at which runs are compared, at most.
const PLACES: usize = 128;

/// And one for every so many radians that the body turns.
const APART: f64 = 3.0;

/// A motion whose states are known to a tolerance at every time of its span.
///
/// Runs are compared, and the condition is felt, at up to 128 places. A state between two of them is found
/// by stepping on from the one before with the method and the fineness of the run that was
/// verified, so it is as good as its neighbours; it costs a few steps.
pub struct SolvedMotion<'s, E> {
    scene: &'s Scene<E>,
    solved: Solved,
    form: Form,
    start: State,
    t_start: f64,
    t_end: f64,
    breaks: Vec<f64>,
    torque: f64,
    longest_step: f64,
}

enum Form {
    Exact(ExactMotion),
    Stepped {
        method: Method,
        level: f64,
        precision: f64,
        /// The states at equal distances, the start among them.
        places: Vec<State>,
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
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
    /// let scene = Scene::new(body).with(GravityAtLever::new(1.0, 0.4)?);
    /// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0))?;
    /// let motion = scene.solve_along(&start, 20.0, 1e-9, &Limits::default())?;
    /// let there = motion.state(7.3)?;
    /// let alone = scene.solve(&start, 7.3, 1e-12)?;
    /// assert!(there.attitude.angle_to(&alone.state.attitude) <= 1e-9);
    /// assert!(motion.state(20.1).is_err());
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
    ) -> Result<SolvedMotion<'_, E>> {
        self.posed(start, t_end, tolerance, limits, |problem| {
            let turned = problem.fastest() * problem.span().abs() / APART;
            let places = turned.clamp(1.0, PLACES as f64) as usize;
            let (solved, form) = if problem.span() == 0.0 {
                let places = vec![*start];
                let form = Form::Stepped {
                    method: Method::Adaptive,
                    level: 0.0,
                    precision: 0.0,
                    places,
                };
                (nothing_to_do(problem)?, form)
            } else if let Some(motion) = problem.exact_motion() {
                let solved = by_closed_form(problem, &motion, tolerance, places)?;
                (solved, Form::Exact(motion))
            } else {
                let mut delivered = Stepping::new(problem, tolerance, limits, places).solve()?;
                let mut places = vec![*start];
                places.append(&mut delivered.places);
                let form = Form::Stepped {
                    method: delivered.method,
                    level: delivered.level,
                    precision: delivered.precision,
                    places,
                };
                let mut solved = Solved::of(&delivered, problem);
                if let Form::Stepped { places, .. } = &form {
                    solved.state = places[places.len() - 1];
                }
                (solved, form)
            };
            Ok(SolvedMotion {
                scene: self,
                solved,
                form,
                start: *start,
                t_start: limits.t_start,
                t_end,
                breaks: problem.breaks.to_vec(),
                torque: problem.torque,
                longest_step: problem.longest_step,
            })
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
        times.iter().map(|t| motion.state(*t)).collect()
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

impl<E: Effect> SolvedMotion<'_, E> {
    /// What was solved: the state at the end, the method, estimates for the whole of the
    /// way, work.
    pub const fn solved(&self) -> &Solved {
        &self.solved
    }

    /// The time of the start and that of the end (s).
    pub const fn span(&self) -> [f64; 2] {
        [self.t_start, self.t_end]
    }

    /// The state at the time `t` (s).
    ///
    /// # Errors
    /// A time that is not finite, or outside the span.
    pub fn state(&self, t: f64) -> Result<State> {
        finite("time", t)?;
        let (first, last) = (self.t_start.min(self.t_end), self.t_start.max(self.t_end));
        if !(first..=last).contains(&t) {
            return Err(Error::OutsideRun {
                t,
                start: first,
                end: last,
            });
        }
        match &self.form {
            Form::Exact(motion) => motion.at(t - self.t_start),
            Form::Stepped {
                method,
                level,
                precision,
                places,
            } => self.stepped_on(*method, *level, *precision, places, t),
        }
    }

    fn stepped_on(
        &self,
        method: Method,
        level: f64,
        precision: f64,
        places: &[State],
        t: f64,
    ) -> Result<State> {
        let legs = places.len() - 1;
        if legs == 0 {
            return Ok(places[0]);
        }
        let (effects, body) = (self.scene.effects(), self.scene.body());
        let checked = Checked::unlooked(effects, body, self.span(), &self.start);
        let asked = Cell::new(0);
        let problem = Problem {
            body: *body,
            effects,
            strength: 1.0,
            torque: self.torque,
            start: self.start,
            t_start: self.t_start,
            t_end: self.t_end,
            breaks: &self.breaks,
            longest_step: self.longest_step,
            checked: &checked,
            asked: &asked,
        };
        let part = (t - self.t_start) / (self.t_end - self.t_start);
        let mut leg = ((part * legs as f64) as usize).min(legs);
        let mut from = problem.at_leg(leg, legs);
        // Rounding may have put it a leg too far.
        if (t - from) * (self.t_end - self.t_start) < 0.0 && leg > 0 {
            leg -= 1;
            from = problem.at_leg(leg, legs);
        }
        if t == from {
            return Ok(places[leg]);
        }
        let fine = Fine {
            level,
            fewest: 1,
            precision,
            budget: u64::MAX,
        };
        Ok(method.run(&problem, [from, t], &places[leg], fine)?.state)
    }
}
