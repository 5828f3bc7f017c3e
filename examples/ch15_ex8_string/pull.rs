//! A motion of the particle on its string. Mass, first radius and first speed are 1.

use super::physics::*;
use kit::{sampled, times};
use rotation_dynamics::Result;
use rotation_dynamics::integrators::{Dop853, Work};
use rotation_dynamics::math::{atan2, sincos};
use rotation_dynamics::planar::contact::{ContactMotion, MechanismState, motion};

/// How long the particle circles before the hand pulls.
pub const BEFORE: f64 = 0.5;

/// A motion; the hand pulls from the time 0 on.
pub struct Pulled {
    motion: ContactMotion<Pull, 3, 2>,
    before: f64,
}

impl Pulled {
    /// The circle, and the pull at this speed, up to the time `end` or the edge of the hole.
    pub fn new(speed: f64, hole: f64, step: f64, end: f64) -> Result<Self> {
        let (s, c) = sincos(BEFORE);
        let (q, v) = ([c, -s, -BEFORE], [s, c, 1.0]);
        let pull = Pull { knot: 1.0, hand: 1.0, speed, hole };
        Self::of(pull, MechanismState { q, v }, step, BEFORE, end)
    }

    /// The motion from this state on when the string is held, for a while.
    pub fn held(start: MechanismState<3>, step: f64, end: f64) -> Result<Self> {
        // The hand is out of reach, the hole too.
        let pull = Pull { knot: radius(&start), hand: 2.0, speed: 0.0, hole: 0.0 };
        Self::of(pull, start, step, 0.0, end)
    }

    /// A motion from this state on, which is so long before the time 0.
    fn of(pull: Pull, start: MechanismState<3>, step: f64, before: f64, end: f64) -> Result<Self> {
        let motion = motion(pull, &Dop853::new(step)?, start, before + end)?;
        Ok(Self { motion, before })
    }

    /// The state just before and just after the event of this name, and when it was.
    pub fn event(&self, name: &'static str) -> Result<([MechanismState<3>; 2], f64)> {
        let event = self.motion.event(name)?;
        Ok(([event.before, event.after], event.t - self.before))
    }

    /// That of the motion, from the first to the last.
    fn clock(&self, t: f64) -> f64 {
        (t + self.before).clamp(0.0, self.motion.end_time())
    }

    /// The state at this time.
    pub fn at(&self, t: f64) -> Result<MechanismState<3>> {
        self.motion.at(self.clock(t))
    }

    /// The tension at this time.
    pub fn tension(&self, t: f64) -> Result<f64> {
        let forces = self.motion.forces(self.clock(t))?;
        Ok(forces.iter().map(|force| force.normal).sum())
    }

    /// When it ends.
    pub fn end(&self) -> f64 {
        self.motion.end_time() - self.before
    }

    /// The angle from the time 0 to `t`, in small steps.
    pub fn angle(&self, t: f64) -> kit::Result<f64> {
        let last = self.at(t)?;
        let count = 1 + (2.0 * t * across(&last) / radius(&last)) as u32;
        let places = sampled(times(0.0, t, count), |t| Ok(self.at(t)?.q))?;
        let turn = |[[x, y, _], [u, v, _]]: [[f64; 3]; 2]| atan2(x * v - y * u, x * u + y * v);
        Ok(places.windows(2).map(|pair| turn([pair[0], pair[1]])).sum())
    }

    /// What it cost.
    pub fn work(&self) -> Work {
        self.motion.work()
    }
}
