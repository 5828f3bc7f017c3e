//! The same body, released alike but without spin: it falls.

use super::{Motion, Pose};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::EulerAngles;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::sin;

/// A fall in closed form, up to where it ends.
pub(super) struct Falling {
    exact: HeavyTop,
    end: f64,
}

impl Falling {
    /// The fall of the body of `motion` from the same place with the same push, until it no longer
    /// `falls`; `None` without weight.
    ///
    /// # Errors
    /// None for sound motions.
    pub(super) fn of(motion: &Motion, falls: impl Fn(&Pose) -> bool) -> Result<Option<Self>> {
        let c = motion.top.c();
        if c == 0.0 {
            return Ok(None);
        }
        let body = match motion.exact.body() {
            Some(body) => body,
            // In units of t': I1 = 1.
            None => SymmetricTop::formal(1.0, motion.top.a(), c.abs(), c.signum())?,
        };
        let EulerAngles { theta, phi, .. } = motion.exact.angles(0.0);
        let sideways = motion.exact.phi_rate(0.0) * sin(theta);
        let rates = BodyVector::new(motion.exact.theta_rate(0.0), sideways, 0.0);
        let exact = HeavyTop::from_body(body, EulerAngles { theta, phi, zeta: 0.0 }, rates)?;
        let mut fall = Self { exact, end: 0.0 };
        // It is drawn up to the first of these times at which it has come to its end.
        let step = motion.shown() / 400.0;
        let ends = (0..400).map(|k| step * f64::from(k)).take_while(|&t| falls(&fall.pose(t)));
        fall.end = ends.last().unwrap_or(0.0);
        Ok(Some(fall))
    }

    fn pose(&self, t: f64) -> Pose {
        let EulerAngles { theta, phi, zeta } = self.exact.angles(t);
        Pose { theta, phi, zeta }
    }

    /// Where it is at `t`, if it still falls.
    pub(super) fn at(&self, t: f64) -> Option<Pose> {
        (t <= self.end).then(|| self.pose(t))
    }
}
