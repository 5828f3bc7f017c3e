//! A blow, simulated: what it has given to bat and hands, and how its forces run.

use super::physics::*;
use kit::prelude::*;
use rotation_dynamics::planar::contact::{ContactMotion, MechanismState, motion_within};

/// What happens, from before the impact until the two have parted.
pub struct Blow {
    strike: Strike,
    pub before: MechanismState<5>,
    pub after: MechanismState<5>,
    pub touch: f64, // when they touch first
    pub motion: ContactMotion<Strike, 5, 3>,
}

impl Blow {
    pub fn new(strike: Strike, tolerance: f64) -> Result<Self> {
        let (p, [arm, hit]) = (&strike.p, arms(&strike.p));
        // Rigid bodies have parted at once, and may meet again later.
        let parted = if strike.stiffness.is_none() { 0.1 } else { 1.5 };
        let (touch, end) = (0.5 * p.contact, (0.5 + parted) * p.contact);
        let q = [arm, 0.0, 0.0, hit, -touch * p.speed];
        let v = [0.0, 0.0, 0.0, 0.0, p.speed];
        let motion = motion_within(strike.clone(), tolerance, MechanismState { q, v }, end)?;
        let (before, after) = match strike.stiffness {
            None => motion.event("ball bounces").map(|at| (at.before, at.after))?,
            Some(_) => (motion.at(touch)?, motion.at(end)?),
        };
        Ok(Self { strike, before, after, touch, motion })
    }

    /// Momentum that the ball has lost, N s.
    pub fn impulse(&self) -> f64 {
        self.strike.p.ball * (self.before.v[4] - self.after.v[4])
    }

    /// Momentum of the bat that does not come from the ball, N s.
    pub fn hands(&self) -> f64 {
        self.strike.p.mass * self.after.v[1] - self.impulse()
    }

    pub fn reaction(&self) -> f64 {
        self.hands() / self.impulse()
    }

    /// Velocity of the place of the hands just after.
    pub fn end_velocity(&self) -> f64 {
        self.after.v[1] - arms(&self.strike.p)[0] * self.after.v[2]
    }

    /// By which angle the bat turns while a soft ball touches it, rad.
    pub fn turned(&self) -> Result<f64> {
        Ok(self.motion.at(self.touch + self.strike.p.contact)?.q[2])
    }

    /// How much of the impulse of a soft ball is left in a vibration of this angular frequency
    /// that it sets going: the length of the integral of force times e^(i omega t), over that
    /// of the force.
    pub fn left_swinging(&self, frequency: f64) -> Result<f64> {
        let all = times(self.touch, self.motion.end_time(), 600);
        let pushed = sampled(all, |t| {
            let (s, c) = sincos(frequency * t);
            let force = self.strike.push(&self.motion.at(t)?);
            Ok([force, force * c, force * s])
        })?;
        let [sum, c, s] = [0, 1, 2].map(|k| pushed.iter().map(|now| now[k]).sum::<f64>());
        Ok(hypot(c, s) / sum)
    }

    /// Forces of the ball and of the hands on the bat, along y at the start, N.
    pub fn forces(&self, t: f64) -> Result<[f64; 2]> {
        let hands = self.motion.forces(t)?[2].normal;
        Ok([self.strike.push(&self.motion.at(t)?), hands])
    }

    /// The largest of each.
    pub fn largest_forces(&self) -> Result<[f64; 2]> {
        let all = times(self.touch, self.motion.end_time(), 600);
        let all = sampled(all, |t| self.forces(t))?;
        let larger = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
        Ok([0, 1].map(|k| all.iter().map(|now| now[k]).fold(0.0, larger)))
    }
}
