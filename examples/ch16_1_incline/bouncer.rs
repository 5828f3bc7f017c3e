//! A ball that is dropped onto the slope, bounces, and rolls.

use super::*;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::planar::contact::motion;

/// The part of its speed towards the slope that it returns.
pub const RESTITUTION: f64 = 0.6;
/// How far above the slope it is let go, in radii.
pub const HEIGHT: f64 = 5.0;

/// A ball with friction enough, and a restitution.
#[derive(Debug, Clone, Copy)]
pub struct Bouncer(Roller);

impl Mechanism<3, 1> for Bouncer {
    fn mass(&self, q: &[f64; 3]) -> [[f64; 3]; 3] {
        self.0.mass(q)
    }
    fn force(&self, ball: &MechanismState<3>) -> [f64; 3] {
        self.0.force(ball)
    }
    fn contacts(&self, ball: &MechanismState<3>) -> [Contact<3>; 1] {
        self.0.contacts(ball).map(|rim| rim.restitution(RESTITUTION))
    }
    fn scale(&self, _: &MechanismState<3>) -> MechanismState<3> {
        let Roller { gravity, slope, radius, .. } = self.0;
        let (t, down) = (2.0 * self.rests(), (gravity * radius).sqrt());
        let along = down + gravity * sin(slope) * t;
        MechanismState {
            q: [along * t, radius, along * t / radius],
            v: [along, down, along / radius],
        }
    }
}

impl Bouncer {
    pub fn new(p: &Parameters) -> Self {
        Self(gripping(p, 0.4))
    }

    fn fall(&self) -> f64 {
        (2.0 * HEIGHT * self.0.radius / (self.0.gravity * cos(self.0.slope))).sqrt()
    }

    /// When its bounces are over.
    pub fn rests(&self) -> f64 {
        self.fall() * (1.0 + RESTITUTION) / (1.0 - RESTITUTION)
    }

    /// How high it is above the slope, in radii.
    pub fn height(&self, t: f64) -> f64 {
        // From the top of an arc, in units of the fall; and how long that falls.
        let (mut t, mut half) = (t / self.fall(), 1.0);
        while t > half && half > 1e-9 {
            (t, half) = (t - half * (1.0 + RESTITUTION), half * RESTITUTION);
        }
        HEIGHT * (half * half - t * t).max(0.0)
    }

    /// Let go at rest above the slope, for twice the time until it rests.
    pub fn run(self, tolerance: f64) -> Result<ContactMotion<Self, 3, 1>> {
        let start = MechanismState::rest([0.0, (1.0 + HEIGHT) * self.0.radius, 0.0]);
        Ok(motion(self, &Dop853::new(tolerance)?, start, 2.0 * self.rests())?)
    }
}
