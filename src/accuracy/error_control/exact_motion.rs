//! Closed forms, picked by what acts.

use super::constants::NEAR_SEPARATRIX;
use crate::body::{RigidBody, State};
use crate::effects::{GravityAtLever, IntegrableCase};
use crate::error::Result;
use crate::exact::free_body::FreeBody;
use crate::exact::heavy_top::{HeavyTop, SymmetricTop};
use crate::math::order_of_three;

/// A motion known at any time without stepping: its name, and the state at a time (s).
pub struct ExactMotion {
    name: &'static str,
    near_separatrix: bool,
    at: Box<dyn Fn(f64) -> Result<State>>,
}

impl ExactMotion {
    /// The motion with this name and this state at a time.
    pub fn new(name: &'static str, at: impl Fn(f64) -> Result<State> + 'static) -> Self {
        Self { name, near_separatrix: false, at: Box::new(at) }
    }

    /// The motion of this body from `start` at t = 0 under what is `known`, if it has a
    /// closed form. `strength` multiplies the torque: it is 1, or so near to 1 that the
    /// change tells the condition of the motion.
    pub fn of(
        known: IntegrableCase,
        strength: f64,
        body: &RigidBody,
        start: &State,
    ) -> Option<Self> {
        match known {
            IntegrableCase::None => None,
            IntegrableCase::Free => free(body, start),
            IntegrableCase::HeavyTop(gravity) if gravity.moment() == 0.0 => free(body, start),
            IntegrableCase::HeavyTop(gravity) => heavy_top(&gravity, strength, body, start),
        }
    }

    /// True within 1e-6 of a separatrix, in the parameter of the elliptic functions: there a
    /// small change of the start may carry the motion past its own steepness.
    pub(super) const fn is_near_separatrix(&self) -> bool {
        self.near_separatrix
    }

    /// The name.
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// The state at the time `t` (s).
    ///
    /// Errors: as for the closed form.
    pub fn at(&self, t: f64) -> Result<State> {
        (self.at)(t)
    }
}

fn free(body: &RigidBody, start: &State) -> Option<ExactMotion> {
    let rates = body.angular_velocity(start);
    let motion = FreeBody::new(body.moments(), start.attitude, rates).ok()?;
    let momentum = start.angular_momentum;
    // 2 E I_mid - L^2, as sum of I_i (I_mid - I_i) omega_i^2, beside L^2.
    let [moments, omega] = [body.moments().to_array(), rates.to_array()];
    let momenta = [0, 1, 2].map(|i| moments[i] * omega[i]);
    let square: f64 = momenta.iter().map(|l| l * l).sum();
    let middle = moments[order_of_three(moments)[1]];
    let off: f64 = (moments.iter().zip(omega)).map(|(i, w)| i * (middle - i) * w * w).sum();
    Some(ExactMotion {
        name: "closed form of the free body",
        near_separatrix: off.abs() < NEAR_SEPARATRIX * square,
        at: Box::new(move |t| State::new(motion.try_attitude(t)?, momentum)),
    })
}

fn heavy_top(
    gravity: &GravityAtLever,
    strength: f64,
    body: &RigidBody,
    start: &State,
) -> Option<ExactMotion> {
    let moments = body.moments();
    if !moments.is_symmetric() {
        return None;
    }
    let (weight, lever) = (strength * gravity.weight(), gravity.lever());
    let top = SymmetricTop::formal(moments.i1(), moments.i3(), weight, lever).ok()?;
    let rates = body.angular_velocity(start);
    let motion = HeavyTop::from_body(top, start.attitude.euler_angles(), rates).ok()?;
    let body = *body;
    Some(ExactMotion {
        name: "closed form of the heavy top",
        near_separatrix: motion.complementary_parameter() < NEAR_SEPARATRIX,
        at: Box::new(move |t| {
            let now = motion.try_kinematics(t)?;
            body.state(now.attitude, now.angular_velocity)
        }),
    })
}
