//! Closed forms, picked by what acts.

use crate::body::{RigidBody, State};
use crate::effects::{GravityAtLever, Known};
use crate::error::Result;
use crate::exact::free_body::FreeBody;
use crate::exact::heavy_top::{HeavyTop, SymmetricTop};

/// A motion known at any time without stepping: its name, and the state at a time (s).
pub struct ExactMotion {
    name: &'static str,
    at: Box<dyn Fn(f64) -> Result<State>>,
}

impl ExactMotion {
    /// The motion with this name and this state at a time.
    pub fn new(name: &'static str, at: impl Fn(f64) -> Result<State> + 'static) -> Self {
        Self {
            name,
            at: Box::new(at),
        }
    }

    /// The motion of this body from `start` at t = 0 under what is `known`, if it has a
    /// closed form. `strength` multiplies the torque: it is 1, or so near to 1 that the
    /// change tells the condition of the motion.
    pub fn of(known: Known, strength: f64, body: &RigidBody, start: &State) -> Option<Self> {
        match known {
            Known::No => None,
            Known::Free => free(body, start),
            Known::HeavyTop(gravity) if gravity.moment() == 0.0 => free(body, start),
            Known::HeavyTop(gravity) => heavy_top(&gravity, strength, body, start),
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

fn free(body: &RigidBody, start: &State) -> Option<ExactMotion> {
    let rates = body.angular_velocity(start);
    let motion = FreeBody::new(body.moments(), start.attitude, rates).ok()?;
    let momentum = start.angular_momentum;
    Some(ExactMotion {
        name: "closed form of the free body",
        at: Box::new(move |t| State::new(motion.attitude(t), momentum)),
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
        at: Box::new(move |t| {
            let now = motion.kinematics(t);
            body.state(now.attitude, now.angular_velocity)
        }),
    })
}
