//! A spinning cylinder in a corner: forces and times in closed form, and a scene of two contacts
//! that push and rub.

// ANCHOR: physics
use kit::prelude::*;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::log1p;
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, Surface, motion,
};

/// A cylinder between a floor and a wall on its left, per unit of its mass; lengths in units
/// of its radius R, times in units of sqrt(R/g).
#[derive(Debug, Clone, Copy)]
pub struct Cylinder {
    pub mu: [f64; 2], // coefficients of friction of floor and wall, at rest
    pub fading: f64,  // they fall as 1/(1 + fading s) with the slip speed s
    pub lean: f64,    // how far the wall leans back, rad
}

// ANCHOR: scene
/// The coordinates are `[x, y, turned]`: how far the axis is to the right of where it is set
/// down, how high it is, and the angle, counterclockwise.
impl Mechanism<3, 2> for Cylinder {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.5]]
    }

    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -1.0, 0.0]
    }

    fn contacts(&self, cylinder: &MechanismState<3>) -> [Contact<3>; 2] {
        let ((s, c), [vx, vy, spin]) = (sincos(self.lean), cylinder.v);
        let (normal, offset) = ([c, s], s - 1.0);
        let mu = |i: usize, slip: f64| self.mu[i] / (1.0 + self.fading * slip.abs());
        let touching = |name, surface| Contact::rim(name, cylinder, 1.0, surface);
        [
            touching("floor", Surface::FLOOR).friction(mu(0, vx + spin)),
            touching("wall", Surface { normal, offset }).friction(mu(1, s * vx - c * vy + spin)),
        ]
    }
}
// ANCHOR_END: scene

pub type Ride = ContactMotion<Cylinder, 3, 2>;

impl Cylinder {
    /// With friction that does not ask for the speed.
    pub fn new(mu: [f64; 2], lean: f64) -> Self {
        Self { mu, fading: 0.0, lean }
    }

    /// Floor and wall alike, and the wall upright.
    pub fn alike(mu: f64) -> Self {
        Self::new([mu, mu], 0.0)
    }

    /// Forces of floor and wall over the weight, while both slip counterclockwise.
    pub fn pressed(&self) -> [f64; 2] {
        let ((s, c), [floor, wall]) = (sincos(self.lean), self.mu);
        // What the wall pushes to the right, and upward, for each unit of its force.
        let (across, up) = (c - wall * s, s + wall * c);
        let carried = across / (across + floor * up);
        [carried, floor * carried / across]
    }

    /// The angular deceleration then, in g/R.
    pub fn braking(&self) -> f64 {
        let [floor, wall] = self.pressed();
        2.0 * (self.mu[0] * floor + self.mu[1] * wall)
    }
}

/// The time to the stop from the spin `w` if friction fades, in sqrt(R/g): alike surfaces.
pub fn faded(mu: f64, fading: f64, w: f64) -> f64 {
    let more = match fading > 0.0 {
        true => 2.0 * mu / fading * log1p(fading * w / (1.0 + mu)),
        false => 2.0 * mu * w / (1.0 + mu),
    };
    0.5 * (w / mu * (1.0 + 0.5 * fading * w) + (more - w))
}

/// The motion from rest with this spin, set down in the corner, until then.
pub fn set_down(cylinder: Cylinder, spin: f64, end: f64, step: f64) -> Result<Ride> {
    let (q, v) = ([0.0, 1.0, 0.0], [0.0, 0.0, spin]);
    let start = MechanismState { q, v };
    Ok(motion(cylinder, &Dop853::new(step)?, start, end)?)
}

/// When a cylinder with this spin stops that should stop `about` then.
pub fn stopped(cylinder: Cylinder, spin: f64, about: f64, step: f64) -> Result<f64> {
    Ok(set_down(cylinder, spin, 2.0 * about, step)?.event("floor sticks")?.t)
}
// ANCHOR_END: physics

// ANCHOR: wrong
/// Wrong: velocity of the axis and spin after each of equal steps, as many programs have it:
/// friction is mu N, against the sign of the slip, whatever the slip.
pub fn by_sign(mu: f64, spin: f64, away: bool, end: f64, steps: u32) -> Vec<[f64; 2]> {
    let (mut v, mut spin, h) = (0.0, spin, end / f64::from(steps));
    let held = Cylinder::alike(mu).pressed();
    let [floor, wall] = if away { [1.0, 0.0] } else { held };
    let step = |_| {
        let sign = f64::signum(v + spin);
        spin -= 2.0 * mu * (floor + wall) * sign * h;
        v += (wall - mu * floor * sign) * h * f64::from(u8::from(away));
        [v, spin]
    };
    (0..steps).map(step).collect()
}
// ANCHOR_END: wrong
