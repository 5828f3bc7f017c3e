//! A heavy top in the angles of the notes, which meet the pole.

use super::*;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop};
use rotation_dynamics::integrators::{Ode, size_or};

/// Equations (4) to (6) of the notes, 16.2: theta, its rate, phi and zeta. The state has
/// no pole, the angles do.
pub struct Angles {
    top: ReducedTop,
    body: RigidBody,
    start: [f64; 4],
}

impl Ode<4> for Angles {
    fn derivative(&self, _t: f64, &[theta, rate, _, _]: &[f64; 4]) -> [f64; 4] {
        let (a, b, c) = (self.top.a(), self.top.b(), self.top.c());
        let (s, u) = sincos(theta);
        let precession = a.sqrt() * (b - u) / (s * s);
        let torque = c * s - a * (b - u) * (1.0 - b * u) / (s * s * s);
        [rate, torque, precession, 1.0 / a.sqrt() - precession * u]
    }

    fn scale(&self, y: &[f64; 4]) -> [f64; 4] {
        size_or([1.0; 4])(y)
    }
}

impl Angles {
    pub fn new(top: ReducedTop, exact: &HeavyTop, body: RigidBody) -> Self {
        let EulerAngles { phi, theta, zeta } = exact.angles(0.0);
        let start = [theta, exact.theta_rate(0.0), phi, zeta];
        Self { top, body, start }
    }

    /// The end by DOP853 with this tolerance.
    pub fn run(&self, tolerance: f64, t_end: f64) -> Result<(State, Work)> {
        let (end, work) = Dop853::new(tolerance)?.advance(self, 0.0, &self.start, t_end)?;
        Ok((self.state(&end)?, work))
    }

    /// The state that these angles stand for.
    fn state(&self, &[theta, rate, phi, zeta]: &[f64; 4]) -> Result<State> {
        let angles = EulerAngles { phi, theta, zeta };
        let (a, b) = (self.top.a(), self.top.b());
        let (s, u) = sincos(theta);
        let across = a.sqrt() * (b - u) / s;
        let (sin, cos) = sincos(zeta);
        let rates =
            BodyVector::new(rate * cos + across * sin, across * cos - rate * sin, 1.0 / a.sqrt());
        self.body.state(Attitude::from_euler(angles)?, rates)
    }
}
