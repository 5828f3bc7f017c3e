//! A round body whose rolling meets a resistance, by the contact solver.

use rotation_dynamics::Result;
use rotation_dynamics::integrators::Work;
use rotation_dynamics::planar::contact::{
    Contact, Mechanism, MechanismState, Surface, motion_within,
};

/// A round body on level ground, per unit mass.
struct Roller {
    /// Its moment of inertia over M R^2: 1 of a hoop, 1/2 of a disc.
    shape: f64,
    radius: f64,
    speed: f64,
    gravity: f64,
    resistance: f64,
}

impl Mechanism<3, 2> for Roller {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let turning = self.shape * self.radius * self.radius;
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, turning]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -self.gravity, 0.0]
    }
    fn contacts(&self, body: &MechanismState<3>) -> [Contact<3>; 2] {
        let ground = Contact::rim("ground", body, self.radius, Surface::FLOOR).friction(1.0);
        [ground, Contact::rolling("rim", 0, self.radius, self.resistance)]
    }
    fn scale(&self, _: &MechanismState<3>) -> MechanismState<3> {
        let (v, r) = (self.speed, self.radius);
        MechanismState { q: [r, r, 1.0], v: [v, v, v / r] }
    }
}

/// The speed that a round body of this shape, radius and speed has lost after the time `t` if
/// its rolling meets the part `resistance` of its weight; and the work.
pub fn lost(
    shape: f64,
    [radius, speed]: [f64; 2],
    resistance: f64,
    gravity: f64,
    t: f64,
) -> Result<(f64, Work)> {
    let body = Roller { shape, radius, speed, gravity, resistance };
    let start = MechanismState { q: [0.0, radius, 0.0], v: [speed, 0.0, -speed / radius] };
    let run = motion_within(body, 1e-10, start, t)?;
    Ok((speed - run.at(t)?.v[0], run.work()))
}
