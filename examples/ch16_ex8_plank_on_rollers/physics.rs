//! A plank on two rollers: swing, growth and cycle in closed form, and a scene of two contacts
//! that move, hold and slip.

// ANCHOR: physics
use super::Parameters;
use kit::prelude::*;
use rotation_dynamics::math::{acosh, asinh};
use rotation_dynamics::planar::contact::{Contact, ContactMotion, Mechanism, MechanismState};

/// Radius of the rollers over their distance; it matters to a plank that has tipped.
pub const RADIUS: f64 = 0.15;

/// A plank, per unit of its mass, 2.4 times as long as the rollers are apart. Their tops move
/// towards each other (`sense` 1) or apart (-1).
#[derive(Debug, Clone)]
pub struct Plank {
    pub p: Parameters,
    pub sense: f64,
}

// ANCHOR: scene
/// The coordinates are `[x, y, tilt]`: how far the middle of the plank is to the right of the
/// middle between the rollers, how far above its place when flat, and its angle, counterclockwise.
impl Mechanism<3, 2> for Plank {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let (long, thick) = (2.4 * self.p.distance, self.p.thickness);
        let turning = (long * long + thick * thick) / 12.0;
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, turning]]
    }

    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -self.p.gravity, 0.0]
    }

    fn contacts(&self, plank: &MechanismState<3>) -> [Contact<3>; 2] {
        let ([x, y, tilt], [vx, vy, omega]) = (plank.q, plank.v);
        let ((s, c), half) = (sincos(tilt), 0.5 * self.p.thickness);
        // From the axle up to the middle of the plank.
        let axle = half + RADIUS * self.p.distance;
        let roller = |name, at: f64, speed: f64| {
            let gap = y * c - (x - at) * s - axle * (1.0 - c);
            let along = (x - at) * c + (y + axle) * s;
            let bias = -2.0 * omega * (c * vx + s * vy) - omega * omega * (gap + axle);
            Contact::new(name, gap, [-s, c, -along], bias)
                .tangent([c, s, half], omega * (c * vy - s * vx))
                .frictions(self.p.kinetic, self.p.holding)
                .moving(speed)
        };
        let (at, speed) = (0.5 * self.p.distance, self.sense * self.p.runs());
        [roller("left", -at, speed), roller("right", at, -speed)]
    }
    // ANCHOR_END: scene

    fn end(&self, plank: &MechanismState<3>) -> Option<(&'static str, f64)> {
        let [x, _, tilt] = plank.q;
        // Tops together: a cycle that has no room ends where a roller loses the plank.
        let [off, tipped] = [lift(&self.p, 1.0) - x.abs(), 0.25 - tilt.abs()];
        Some(if self.sense > 0.0 { ("comes off", off) } else { ("tipped", tipped) })
    }

    fn scale(&self, _: &MechanismState<3>) -> MechanismState<3> {
        let (a, speed) = (self.p.distance, rate(&self.p, 0.0) * self.p.distance);
        let (q, v) = ([a, a, 1.0], [speed, speed, speed / a]);
        MechanismState { q, v }
    }
}

pub type Ride = ContactMotion<Plank, 3, 2>;

/// Angular frequency of the oscillation (sense 1), or rate of growth (-1).
pub fn rate(p: &Parameters, sense: f64) -> f64 {
    (2.0 * p.kinetic * p.gravity / (p.distance - sense * p.kinetic * p.thickness)).sqrt()
}

/// Where the plank loses a roller while it slips on both.
pub fn lift(p: &Parameters, sense: f64) -> f64 {
    0.5 * (p.distance - sense * p.kinetic * p.thickness)
}

/// How far beyond the middle a roller still holds the plank that it carries away from itself, m.
pub fn held(p: &Parameters) -> f64 {
    0.5 * p.distance * (p.holding - p.kinetic) / (p.holding + p.kinetic)
}

/// Amplitude, m, and period, s, of the cycle of stick and slip.
pub fn cycle(p: &Parameters) -> (f64, f64) {
    let (rate, held) = (rate(p, 1.0), held(p));
    let widest = p.runs() / rate;
    let round = 4.0 * held / p.runs() + 4.0 / rate * atan2(widest, held);
    (hypot(held, widest), round)
}

/// When and where the plank, released at rest, is first as fast as a roller; and when it loses
/// the other one, if they move apart. Infinite where that does not happen.
pub fn caught(p: &Parameters, sense: f64) -> [f64; 3] {
    let (rate, x, edge, never) = (rate(p, sense), p.offset.abs(), lift(p, -1.0), f64::INFINITY);
    let widest = p.runs() / rate;
    if sense > 0.0 {
        let at = ((x - widest) * (x + widest)).max(0.0).sqrt();
        let when = atan2(widest, at) / rate;
        return [if widest < (1.0 - 1e-6) * x { when } else { never }, at, never];
    }
    let (at, when) = (hypot(x, widest), asinh(widest / x) / rate);
    if at >= edge {
        return [never, at, acosh(edge / x) / rate];
    }
    [when, at, when + (0.5 * p.distance - at).max(0.0) / p.runs()]
}
// ANCHOR_END: physics
