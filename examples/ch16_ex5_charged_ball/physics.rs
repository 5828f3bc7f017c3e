//! A charged ball on a slab: rolling and slipping in closed form, and a scene of one contact with
//! dry friction.

// ANCHOR: physics
use core::f64::consts::PI;
use kit::prelude::*;
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, Surface, motion_within,
};

/// The ball, per unit mass: `[x, y, angle]`, along the slab, upward, and counterclockwise.
#[derive(Debug, Clone, Copy)]
pub struct Ball {
    pub pull: f64,  // qE/m, m/s^2
    pub press: f64, // normal force over the mass, m/s^2: g, or more with an image charge
    pub radius: f64,
    pub shape: f64, // I/(m R^2)
    pub mu: f64,
    pub spot: f64, // from the middle to the charge, m; at the angle 0 it lies on the right
    pub resisting: [f64; 2], // arm of the normal force ahead of the middle, m; drag/(m v^2), 1/m
    pub length: f64, // where the slab ends, m
}

// ANCHOR: scene
impl Mechanism<3, 1> for Ball {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let turning = self.shape * self.radius * self.radius;
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, turning]]
    }

    fn force(&self, ball: &MechanismState<3>) -> [f64; 3] {
        let ([arm, drag], [vx, ..]) = (self.resisting, ball.v);
        // The field pulls at the charge; its lever is the height of the charge above the middle.
        let moment = -self.pull * self.spot * sin(ball.q[2]);
        let slowed = self.pull - drag * vx * vx.abs();
        [slowed, -self.press, moment + self.side() * arm * self.press]
    }

    fn contacts(&self, ball: &MechanismState<3>) -> [Contact<3>; 1] {
        [Contact::rim("ball", ball, self.radius, Surface::FLOOR).friction(self.mu)]
    }
    // ANCHOR_END: scene

    fn end(&self, ball: &MechanismState<3>) -> Option<(&'static str, f64)> {
        Some(("arrives", self.length - self.side() * ball.q[0]))
    }

    fn scale(&self, _: &MechanismState<3>) -> MechanismState<3> {
        let (r, v) = (self.radius, (2.0 * self.pull.abs() * self.length).sqrt());
        let (q, v) = ([self.length, r, self.length / r], [v, v, v / r]);
        MechanismState { q, v }
    }
}

pub type Roll = ContactMotion<Ball, 3, 1>;

impl Ball {
    /// Where the field pulls: 1 to the right, -1 to the left.
    pub fn side(&self) -> f64 {
        self.pull.signum()
    }

    /// At the start, at rest, with its charge ahead.
    pub fn ahead(&self) -> MechanismState<3> {
        self.start(if self.pull > 0.0 { 0.0 } else { PI }, 0.0)
    }

    /// At the start, turned by this angle, with this velocity and no spin.
    pub fn start(&self, angle: f64, velocity: f64) -> MechanismState<3> {
        let (q, v) = ([0.0, self.radius, angle], [velocity, 0.0, 0.0]);
        MechanismState { q, v }
    }

    /// The motion from there, at most until `end`.
    pub fn run(self, start: MechanismState<3>, end: f64, tolerance: f64) -> Result<Roll> {
        Ok(motion_within(self, tolerance, start, end)?)
    }

    /// The same from rest, to the end of the slab: when it arrives, and with which velocities.
    pub fn rolled(self, end: f64, tolerance: f64) -> Result<(f64, [f64; 3])> {
        let run = self.run(self.start(0.0, 0.0), end, tolerance)?;
        let arrives = run.event("arrives")?;
        Ok((arrives.t, arrives.before.v))
    }

    // ANCHOR: law
    /// Friction that rolling needs, against the field, over the mass.
    pub fn holding(&self) -> f64 {
        self.shape / (1.0 + self.shape) * self.pull
    }

    /// Friction that there is: what rolling needs, or the most the slab can give.
    pub fn friction(&self) -> f64 {
        let most = self.mu * self.press;
        self.holding().clamp(-most, most)
    }

    /// x'' and R phi'', from rest.
    pub fn accelerations(&self) -> [f64; 2] {
        [self.pull - self.friction(), self.friction() / self.shape]
    }
    // ANCHOR_END: law

    /// The part of the work of the field that is lost to rubbing.
    pub fn lost(&self) -> f64 {
        let [a, rim] = self.accelerations();
        1.0 - (a * a + self.shape * rim * rim) / (self.pull * a)
    }

    /// When a ball that is put down sliding begins to roll, and its velocity then.
    pub fn caught(&self, shot: f64) -> [f64; 2] {
        let rub = -self.mu * self.press.copysign(shot);
        let time = -shot / (self.pull + rub * (1.0 + 1.0 / self.shape));
        [time, shot + (self.pull + rub) * time]
    }
}
// ANCHOR_END: physics
