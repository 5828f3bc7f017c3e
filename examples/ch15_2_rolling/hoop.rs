//! A hoop whose rolling meets a resistance, by the contact solver.

use rotation_dynamics::Result;
use rotation_dynamics::planar::contact::{Contact, Mechanism, State, Surface, motion_within};

/// A hoop on level ground, per unit mass.
struct Hoop {
    radius: f64,
    speed: f64,
    gravity: f64,
    resistance: f64,
}

impl Mechanism<3, 6, 2> for Hoop {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let turning = self.radius * self.radius;
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, turning]]
    }
    fn force(&self, _: &State<3>) -> [f64; 3] {
        [0.0, -self.gravity, 0.0]
    }
    fn contacts(&self, hoop: &State<3>) -> [Contact<3>; 2] {
        let ground = Contact::rim("ground", hoop, self.radius, Surface::FLOOR).friction(1.0);
        [
            ground,
            Contact::rolling("hoop", 0, self.radius, self.resistance),
        ]
    }
    fn scale(&self, _: &State<3>) -> State<3> {
        let (v, r) = (self.speed, self.radius);
        State {
            q: [r, r, 1.0],
            v: [v, v, v / r],
        }
    }
}

/// The speed that a hoop of this radius and speed has lost after the time `t` if its rolling
/// meets the part `resistance` of its weight.
pub fn lost(radius: f64, speed: f64, resistance: f64, gravity: f64, t: f64) -> Result<f64> {
    let hoop = Hoop {
        radius,
        speed,
        gravity,
        resistance,
    };
    let start = State {
        q: [0.0, radius, 0.0],
        v: [speed, 0.0, -speed / radius],
    };
    Ok(speed - motion_within(hoop, 1e-10, start, t)?.at(t)?.v[0])
}
