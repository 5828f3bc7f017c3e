//! Torque-free motion with two equal moments: two steady rotations.

use super::norm3;
use crate::attitude::Attitude;
use crate::frame::BodyVector;
use crate::math::DoubleDouble as Dd;

/// Two equal moments: R(t) = exp(t L/I1) R0 exp(t Omega_S e), notes 15.5 (9), (10).
#[derive(Debug, Clone)]
pub(super) struct Symmetric {
    axis: usize,
    omega: [f64; 3],
    /// L/I1 on the body axes at t = 0.
    precession: [Dd; 3],
    /// Omega_S = (1 - I3/I1) w3, at which the body turns about its axis.
    spin: Dd,
    /// The rate at which the transverse rate turns in the body, -Omega_S.
    pub(super) body_rate: Dd,
}

impl Symmetric {
    pub(super) fn new(moments: [f64; 3], omega: [f64; 3], axis: usize) -> Self {
        let transverse = moments[(axis + 1) % 3];
        let spin = Dd::sum(transverse, -moments[axis]) * omega[axis] / transverse;
        let precession = [0, 1, 2].map(|i| Dd::product(moments[i], omega[i]) / transverse);
        Self {
            axis,
            omega,
            precession,
            spin,
            body_rate: -spin,
        }
    }

    /// Omega_P = L/I1 (rad/s), notes 15.5 (9).
    pub(super) fn precession_rate(&self) -> f64 {
        norm3(self.precession).to_f64()
    }

    pub(super) fn attitude_at(&self, t: f64, start: Attitude) -> Attitude {
        // exp(t L/I1) acts in space; moved to the right of R0 it acts on body components.
        let rate = norm3(self.precession);
        let (sin, cos) = (rate * t).scaled(0.5).sin_cos();
        let [x, y, z] = self.precession.map(|c| (sin * (c / rate)).to_f64());
        let about_momentum = Attitude::from_unit([cos.to_f64(), x, y, z]);
        let (sin, cos) = (self.spin * t).scaled(0.5).sin_cos();
        let mut spin = [cos.to_f64(), 0.0, 0.0, 0.0];
        spin[1 + self.axis] = sin.to_f64();
        start * about_momentum * Attitude::from_unit(spin)
    }

    pub(super) fn angular_velocity_at(&self, t: f64) -> BodyVector {
        let (sin, cos) = (self.spin * t).sin_cos();
        let (sin, cos) = (sin.to_f64(), cos.to_f64());
        let (i, j) = ((self.axis + 1) % 3, (self.axis + 2) % 3);
        let mut omega = self.omega;
        omega[i] = self.omega[i] * cos + self.omega[j] * sin;
        omega[j] = -self.omega[i] * sin + self.omega[j] * cos;
        BodyVector::from_array(omega)
    }
}
