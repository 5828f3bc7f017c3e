//! Which effects a scene needs: the error of leaving one out.
//!
//! The error of leaving a small effect out is the linear response of the motion to it. With
//! y = (q, L) the motion without the effect and f its rates, the difference d obeys
//!
//! ```text
//! d' = (df/dy) d + g(t, y),   d(0) = 0,
//! ```
//!
//! where g is what the effect alone adds to the rates: its torque, and its slip. One run of
//! 14 components, to few digits, tells it for every time of the span, whatever the
//! effect's strength: no small difference of two motions is taken.
//!
//! Source: E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential
//! Equations I*, 2nd ed., I.14 (the variational equation).

mod variation;

use crate::accuracy::error_control;
use crate::accuracy::{Limits, larger, tolerance_of_attitude};
use crate::attitude::Attitude;
use crate::body::State;
use crate::effects::erased::AnyEffect;
use crate::effects::{Effect, check};
use crate::error::{Error, Result};
use crate::integrators::scene::components;
use crate::integrators::{Dop853, Work};
use crate::math::{atan2, sort_by_number};
use crate::scene::Scene;
use core::sync::atomic::Ordering;
use variation::{AnyScene, Variation, leaned, turned};

/// The error of a step, as a part of the motion and of the response.
const PRECISION: f64 = 1e-6;

/// Times of every step at which the response is looked at. A step is 1.9 rad of the fastest turn, as
/// measured on gyroscopes of 250 to 1000 rad/s. So a look is within 0.24 rad of any peak: it is low by
/// 3 % at most where the response follows that turn, and by far less where it follows the nods.
const LOOKS: u32 = 4;

/// A response that turns the body by more than this (rad) is no longer linear: its square
/// counts.
const LINEAR: f64 = 0.1;

/// Times at which two motions are compared.
const COMPARED: u32 = 200;

/// Torques that a derivative of motion and response takes.
const TORQUES: u64 = 4;

/// Derivatives of a step of DOP853.
const STAGES: u64 = 12;

/// The prediction of a small effect is right within this factor.
pub const MARGIN: f64 = 2.0;

/// The error of leaving an effect out of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PredictedError {
    /// The name of the effect.
    pub name: &'static str,
    /// Its dimensionless number, as given.
    pub number: f64,
    /// The predicted error of leaving it out: the largest angle (rad) between the attitudes
    /// with and without it, at any time of the span; to first order in the effect.
    pub predicted: f64,
    /// When it is so large (s).
    pub time: f64,
    /// True if that is small enough to be believed within a factor 2. If not, the effect is
    /// large, and how large only the full simulation says.
    pub linear: bool,
    /// True if the effect must be in: twice the predicted error exceeds the tolerance, or the
    /// prediction is beyond the linear.
    pub called_for: bool,
    /// The cost of the prediction.
    pub work: Work,
}

/// The error of leaving an effect out, from two motions, each solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measured {
    /// The largest angle (rad) between the attitudes with and without it, at 200 times of the
    /// span and when it is predicted to be largest; of the axes alone after [`NeglectedEffects::of_axis`].
    pub error: f64,
    /// By how much it and a prediction may differ by their own errors (rad).
    pub within: f64,
    /// The cost of the motion without the effect and with it, at the tolerance of the list.
    pub work: [Work; 2],
}

/// Candidates for a scene, weighed one by one.
#[derive(Debug, Clone)]
pub struct NeglectedEffects<'s, E> {
    scene: &'s Scene<E>,
    asked: Asked<'s>,
}

/// The question put to the scene, and the answers so far.
#[derive(Debug, Clone)]
struct Asked<'s> {
    start: State,
    t_end: f64,
    tolerance: f64,
    /// The angle (rad) by which a response counts,
    angle: fn(&[f64; 14]) -> f64,
    /// and that between two attitudes.
    apart: fn(&Attitude, &Attitude) -> f64,
    limits: Limits<'s>,
    rows: Vec<PredictedError>,
}

impl<E: Effect> Scene<E> {
    /// Which effects the motion from `start` at t = 0 to `t_end` (s; may be negative) needs, if its
    /// attitude is wanted to `tolerance` (rad, above 0, at most pi).
    /// [`Scene::neglected_effects_with`] starts at another time and within limits.
    ///
    /// The scene is the one that leaves the candidates out.
    ///
    /// ```
    /// # use rotation_dynamics::{attitude::Attitude, body::RigidBody, frame::BodyVector};
    /// # use rotation_dynamics::{effects::{Effect, GravityGradient, Torque}, frame::SpaceVector};
    /// # use rotation_dynamics::{inertia::PrincipalMoments, scene::Scene};
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// // A satellite that tumbles once in two minutes, for a quarter of an hour, to 1e-3.
    /// let body = RigidBody::new(PrincipalMoments::new(20.0, 90.0, 100.0)?);
    /// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.05, 0.01, 0.02))?;
    /// let (normal, down) = (SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(1.0, 0.0, 0.0));
    /// let gradient = GravityGradient::on_orbit(1.1e-3, normal, down)?;
    /// let sunlight = Torque::on_space("sunlight", |_, _, _| SpaceVector::new(0.0, 1e-9, 0.0));
    /// let scene = Scene::new(body);
    /// let weighed = scene
    ///     .neglected_effects(&start, 900.0, 1e-3)?
    ///     .candidate(&gradient, gradient.number(&body, &start))?
    ///     .candidate(&sunlight, 1e-9 * 120.0 / start.angular_momentum.norm())?;
    /// let [gradient, sunlight] = weighed.rows() else { unreachable!() };
    /// assert!(gradient.called_for && !sunlight.called_for);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// Accuracy: predicted and simulated errors differ by 0.4 % at most, for 21 effects of
    /// up to 0.03 rad (`tests/accuracy/neglected.rs`). An effect that is 0 all along the
    /// motion without it has no linear response, and none is predicted, though that motion
    /// may be unstable with it.
    ///
    /// # Errors
    /// A tolerance outside its range, an end or a start that is not finite, or a fault that
    /// [`check`] finds in the scene's own effects.
    pub fn neglected_effects(
        &self,
        start: &State,
        t_end: f64,
        tolerance: f64,
    ) -> Result<NeglectedEffects<'_, E>> {
        self.neglected_effects_with(start, t_end, tolerance, &Limits::default())
    }

    /// As [`Scene::neglected_effects`], from another time than 0, with break points, a longest step,
    /// a budget for all candidates of the list, or a way to cancel.
    ///
    /// # Errors
    /// As [`Scene::neglected_effects`]; limits that contradict the span; with a candidate,
    /// [`Error::LimitReached`] and [`Error::Cancelled`].
    pub fn neglected_effects_with<'s>(
        &'s self,
        start: &State,
        t_end: f64,
        tolerance: f64,
        limits: &Limits<'s>,
    ) -> Result<NeglectedEffects<'s, E>> {
        tolerance_of_attitude(tolerance)?;
        limits.checked(t_end)?;
        let start = State::new(start.attitude, start.angular_momentum)?;
        check(self.effects(), self.body(), [limits.t_start, t_end], &start)?;
        let asked = Asked {
            start,
            t_end,
            tolerance,
            angle: turned,
            apart: Attitude::angle_to,
            limits: *limits,
            rows: Vec::new(),
        };
        Ok(NeglectedEffects { scene: self, asked })
    }
}

impl<E: Effect> NeglectedEffects<'_, E> {
    /// The same for the direction of the axis e3 alone: how far the body has spun about it
    /// is not asked. For a symmetric body, whose motion does not depend on that.
    ///
    /// ```
    /// # use rotation_dynamics::{attitude::Attitude, body::RigidBody, frame::BodyVector};
    /// # use rotation_dynamics::{effects::{CoulombBearing, Effect}, inertia::PrincipalMoments};
    /// # use rotation_dynamics::scene::Scene;
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// // A bearing that brakes a free spin leaves its axis where it is.
    /// let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
    /// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 4.0))?;
    /// let bearing = CoulombBearing::new(1e-4, &body, &start, 0.0)?;
    /// let scene = Scene::new(body);
    /// let candidates = scene.neglected_effects(&start, 10.0, 1e-3)?;
    /// let number = bearing.number(&body, &start);
    /// assert!((candidates.predict(&bearing, number)?.predicted - 1e-2).abs() < 1e-5);
    /// assert!(candidates.of_axis().predict(&bearing, number)?.predicted < 1e-9);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn of_axis(mut self) -> Self {
        self.asked.angle = leaned;
        self.asked.apart = |a, b| {
            let (a, b) = (a.axis(), b.axis());
            atan2(a.cross(&b).norm(), a.dot(&b))
        };
        self
    }

    /// The tolerance (rad).
    pub const fn tolerance(&self) -> f64 {
        self.asked.tolerance
    }

    /// The same with this effect weighed, whose dimensionless number is `number`.
    ///
    /// # Errors
    /// As [`NeglectedEffects::predict`].
    pub fn candidate<C: Effect>(mut self, effect: &C, number: f64) -> Result<Self> {
        self.asked.rows.push(self.predict(effect, number)?);
        Ok(self)
    }

    /// The error of leaving out this effect, whose dimensionless number is `number`.
    ///
    /// # Errors
    /// A number that is NaN; a fault that [`check`] finds in the effect; a refusal of the stepping.
    pub fn predict<C: Effect>(&self, effect: &C, number: f64) -> Result<PredictedError> {
        if number.is_nan() {
            return Err(Error::NotFinite { name: "dimensionless number", value: number });
        }
        let asked = &self.asked;
        let span = [asked.limits.t_start, asked.t_end];
        check(effect, self.scene.body(), span, &asked.start)?;
        let ([predicted, time], work) = asked.response(self.scene.into(), effect)?;
        let linear = predicted <= LINEAR;
        Ok(PredictedError {
            name: effect.name(),
            number,
            predicted,
            time,
            linear,
            called_for: !linear || MARGIN * predicted > asked.tolerance,
            work,
        })
    }

    /// The error of leaving out this effect, measured. The motion is solved with it and without it,
    /// to a thousandth of the difference that is predicted or as close as doubles allow (but no
    /// closer than 1e-11 rad, and at first no coarser than 1e-6). It is solved once more each to
    /// the tolerance, to find that cost.
    ///
    /// ```
    /// # use rotation_dynamics::{attitude::Attitude, body::RigidBody, frame::BodyVector};
    /// # use rotation_dynamics::{effects::ViscousFriction, inertia::PrincipalMoments};
    /// # use rotation_dynamics::scene::Scene;
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
    /// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 4.0))?;
    /// let scene = Scene::new(body);
    /// let bearing = ViscousFriction::about_axis(1e-5)?;
    /// let candidates = scene.neglected_effects(&start, 10.0, 1e-3)?;
    /// let measured = candidates.measure(&bearing)?;
    /// // The spin falls behind by c omega t^2/(2 I3).
    /// assert!((measured.error / 4e-3 - 1.0).abs() < 1e-3);
    /// // Without it there is a closed form.
    /// let [without, with] = measured.work.map(|work| work.torques());
    /// assert!(without == 0 && with > 0);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`NeglectedEffects::predict`] and [`Scene::solve_along`].
    pub fn measure<C: Effect + Clone>(&self, effect: &C) -> Result<Measured>
    where
        E: Clone,
    {
        let predicted = self.predict(effect, 0.0)?;
        let with = self.scene.clone().with(effect.clone());
        self.asked.measured(self.scene, &with, &predicted)
    }

    /// The effects weighed so far, in order.
    pub fn rows(&self) -> &[PredictedError] {
        &self.asked.rows
    }
}

impl Asked<'_> {
    /// [`NeglectedEffects::measure`], by the scene without an effect and with it.
    fn measured(
        &self,
        without: &Scene<dyn AnyEffect + '_>,
        with: &Scene<dyn AnyEffect + '_>,
        &PredictedError { predicted, time, .. }: &PredictedError,
    ) -> Result<Measured> {
        let Asked { start, t_end, tolerance, limits, apart, .. } = self;
        let (from, span) = (limits.t_start, t_end - limits.t_start);
        let times = (1..=COMPARED).map(|n| from + span * (f64::from(n) / f64::from(COMPARED)));
        let mut times: Vec<f64> = times.collect();
        let before = times.partition_point(|t| (t - from).abs() < (time - from).abs());
        times.insert(before, time);
        let motions = |fine: f64| -> Result<[Vec<State>; 2]> {
            let motion = |scene| error_control::at(scene, start, &times, fine, limits);
            Ok([motion(without)?, motion(with)?])
        };
        let mut fine = (1e-3 * predicted).clamp(1e-11, 1e-6);
        let [a, b] = loop {
            match motions(fine) {
                // As close as doubles allow.
                Err(Error::NotDelivered { condition: Some(_), .. }) if fine < 1e-6 => fine *= 10.0,
                motions => break motions?,
            }
        };
        let largest = |angle: fn(&Attitude, &Attitude) -> f64| {
            let apart = (a.iter().zip(&b)).map(|(a, b)| angle(&a.attitude, &b.attitude));
            apart.fold(0.0, larger)
        };
        let cost = |scene| error_control::solve(scene, start, *t_end, *tolerance, limits, false);
        let cost = [cost(without)?, cost(with)?];
        Ok(Measured {
            error: largest(*apart),
            // The prediction is a part of the response of the whole attitude.
            within: 2.0 * fine + PRECISION * largest(Attitude::angle_to),
            work: cost.map(|solved| solved.work),
        })
    }

    /// The largest angle (rad) of the linear response, its time (s), and its cost.
    fn response(&self, scene: AnyScene<'_>, effect: &dyn AnyEffect) -> Result<([f64; 2], Work)> {
        let mut y = [0.0; 14];
        y[..7].copy_from_slice(&components(&self.start));
        let (mut largest, mut work) = ([0.0, self.limits.t_start], Work::default());
        let span = self.t_end - self.limits.t_start;
        for [from, to] in self.pieces(scene.effects, effect) {
            let steps = self.left(&work)? / (TORQUES * STAGES);
            let variation = Variation {
                scene,
                effect,
                least: 1e-4 * self.tolerance,
                slowest: 1.0 / span.abs(),
                t_start: self.limits.t_start,
                piece: [from.min(to).next_up(), from.max(to).next_down()],
            };
            let mut method = Dop853::new(PRECISION)?.with_step_limit(steps.max(1))?;
            let width = effect.narrowest().map_or(f64::INFINITY, |w| w.time);
            let longest = self.limits.longest_step.min(0.5 * width);
            if longest.is_finite() {
                method = method.with_longest_step(longest)?;
            }
            let solution = method.solve(&variation, from, &y, to, &[]);
            let solution = match solution {
                Err(Error::LimitReached { .. }) => return Err(self.over_budget()),
                solution => solution?,
            };
            let mut begun = from;
            for end in solution.step_times() {
                for look in 1..=LOOKS {
                    let t = match look {
                        LOOKS => end,
                        look => begun + (end - begun) * (f64::from(look) / f64::from(LOOKS)),
                    };
                    let angle = (self.angle)(&solution.at(t)?);
                    if angle > largest[0] || angle.is_nan() {
                        largest = [angle, t];
                    }
                }
                begun = end;
            }
            y = *solution.end_state();
            work += solution.work();
        }
        Ok((largest, work))
    }

    /// Torques that are left of the budget after all candidates and this work, if the
    /// prediction may go on.
    fn left(&self, more: &Work) -> Result<u64> {
        let weighed: u64 = self.rows.iter().map(|row| row.work.derivatives).sum();
        let torques = TORQUES * (weighed + more.derivatives);
        if (self.limits.cancel).is_some_and(|cancel| cancel.load(Ordering::Relaxed)) {
            return Err(Error::Cancelled { torques });
        }
        match self.limits.budget.checked_sub(torques) {
            None | Some(0) => Err(self.over_budget()),
            Some(left) => Ok(left),
        }
    }

    const fn over_budget(&self) -> Error {
        Error::LimitReached {
            what: "torques",
            t: self.limits.t_start,
            t_end: self.t_end,
            limit: self.limits.budget,
        }
    }

    /// The span, cut where a torque jumps.
    fn pieces(&self, own: &dyn AnyEffect, effect: &dyn AnyEffect) -> Vec<[f64; 2]> {
        let limits = &self.limits;
        let mut times = limits.breaks(own, self.t_end);
        times.extend(limits.breaks(effect, self.t_end));
        times.extend([limits.t_start, self.t_end]);
        sort_by_number(&mut times, |t| *t);
        times.dedup();
        if self.t_end < limits.t_start {
            times.reverse();
        }
        times.windows(2).map(|pair| [pair[0], pair[1]]).collect()
    }
}
