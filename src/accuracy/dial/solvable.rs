//! What the dial must know of an effect: what it sees, and its closed form.

use crate::body::{RigidBody, State};
use crate::effects::{AxisEffect, Effect, GravityAtLever};
use crate::error::Result;
use crate::exact::free_body::FreeBody;
use crate::exact::heavy_top::{HeavyTop, SymmetricTop};
use crate::math::Lane;

/// A motion known at any time without stepping: its name, and the state at a time (s).
pub struct ExactMotion {
    name: &'static str,
    at: Box<dyn Fn(f64) -> Result<State>>,
}

impl ExactMotion {
    /// The motion with this name and this state at a time.
    ///
    /// The dial takes it to be within 8 eps (1 + condition) of the truth.
    pub fn new(name: &'static str, at: impl Fn(f64) -> Result<State> + 'static) -> Self {
        Self {
            name,
            at: Box::new(at),
        }
    }

    /// The name.
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// The state at the time `t` (s).
    ///
    /// Errors: those of the closed form.
    pub fn at(&self, t: f64) -> Result<State> {
        (self.at)(t)
    }
}

/// An effect that the dial ([`Scene::solve`](crate::scene::Scene::solve)) can work with.
///
/// An effect of your own needs no more than `impl Solvable for Mine {}`: it is stepped.
/// What is said here beyond that opens faster roads, and costs nothing where it does
/// not apply: all of it is settled when the scene's type is.
pub trait Solvable: Effect {
    /// True if there is never a torque.
    const TORQUE_FREE: bool = false;

    /// True if the effect sees nothing but the direction of the body's axis e3, and has
    /// no torque about it, as an [`AxisEffect`]. Then [`Self::torque_on_axis`] must be
    /// given, and splittings apply.
    const AXIS_ONLY: bool = false;

    /// True if the torque is an analytic function of time and state: no jump, no kink.
    /// Then methods of high order with equal steps apply. Otherwise DOP853 alone is
    /// trusted, which shortens its steps where something jumps.
    const ANALYTIC: bool = false;

    /// [`AxisEffect::axis_torques`], if [`Self::AXIS_ONLY`]; never asked for otherwise.
    #[inline(always)]
    fn torque_on_axis<L: Lane>(&self, _axis: [L; 3]) -> [L; 3] {
        [L::of(0.0); 3]
    }

    /// The closed form of this body's motion if nothing else acts, if there is one.
    ///
    /// `strength` multiplies the torque: it is 1, or so near to 1 that the change tells
    /// the condition of the motion.
    fn exact_motion(
        &self,
        _strength: f64,
        _body: &RigidBody,
        _start: &State,
    ) -> Option<ExactMotion> {
        None
    }
}

/// No effect: a free body.
impl Solvable for () {
    const TORQUE_FREE: bool = true;
    const AXIS_ONLY: bool = true;
    const ANALYTIC: bool = true;

    fn exact_motion(&self, _strength: f64, body: &RigidBody, start: &State) -> Option<ExactMotion> {
        let rates = body.angular_velocity(start);
        let motion = FreeBody::new(body.moments(), start.attitude, rates).ok()?;
        let start = *start;
        Some(ExactMotion::new("closed form of the free body", move |t| {
            State::new(motion.attitude(t), start.angular_momentum)
        }))
    }
}

/// Two effects have a closed form if one of them does nothing.
impl<A: Solvable, B: Solvable> Solvable for (A, B) {
    const TORQUE_FREE: bool = A::TORQUE_FREE && B::TORQUE_FREE;
    const AXIS_ONLY: bool = A::AXIS_ONLY && B::AXIS_ONLY;
    const ANALYTIC: bool = A::ANALYTIC && B::ANALYTIC;

    #[inline(always)]
    fn torque_on_axis<L: Lane>(&self, axis: [L; 3]) -> [L; 3] {
        let [a, b, c] = self.0.torque_on_axis(axis);
        let [d, e, f] = self.1.torque_on_axis(axis);
        [a + d, b + e, c + f]
    }

    fn exact_motion(&self, strength: f64, body: &RigidBody, start: &State) -> Option<ExactMotion> {
        if A::TORQUE_FREE {
            self.1.exact_motion(strength, body, start)
        } else if B::TORQUE_FREE {
            self.0.exact_motion(strength, body, start)
        } else {
            None
        }
    }
}

/// Alone on a symmetric body: the heavy top.
impl Solvable for GravityAtLever {
    const AXIS_ONLY: bool = true;
    const ANALYTIC: bool = true;

    #[inline(always)]
    fn torque_on_axis<L: Lane>(&self, axis: [L; 3]) -> [L; 3] {
        self.axis_torques(axis)
    }

    fn exact_motion(&self, strength: f64, body: &RigidBody, start: &State) -> Option<ExactMotion> {
        if self.moment() == 0.0 {
            return ().exact_motion(strength, body, start);
        }
        let moments = body.moments();
        if !moments.is_symmetric() {
            return None;
        }
        let (weight, lever) = (strength * self.weight(), self.lever());
        let top = SymmetricTop::formal(moments.i1(), moments.i3(), weight, lever).ok()?;
        let rates = body.angular_velocity(start);
        let motion = HeavyTop::from_body(top, start.attitude.euler_angles(), rates).ok()?;
        let body = *body;
        Some(ExactMotion::new("closed form of the heavy top", move |t| {
            let now = motion.kinematics(t);
            body.state(now.attitude, now.angular_velocity)
        }))
    }
}
