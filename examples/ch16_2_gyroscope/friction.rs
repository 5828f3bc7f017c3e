//! What friction in the bearing of the line of nodes makes of the motion in the end.

use super::*;
use rotation_dynamics::integrators::{Dop853, Event, Solution};

/// Torque of that bearing over dtheta/dt'.
pub const FRICTION: f64 = 0.15;

/// The cusped motion with friction in the bearing of the line of nodes, released at rest.
pub fn damped(end: f64) -> Result<Solution<4>> {
    let [a, b, c, _] = CUSPS;
    let lowest = Event::falling("lowest", |_t, y: &[f64; 4]| y[1]);
    let law = equations(ReducedTop::new(a, b, c)?, FRICTION);
    Ok(Dop853::new(1e-13)?.solve(&law, 0.0, &[acos(b), 0.0, 0.0, 0.0], end, &[lowest])?)
}

/// The tilt at which it starts, and that of the bottom of its valley.
pub fn tilts() -> Result<(f64, f64)> {
    let [a, b, c, _] = CUSPS;
    Ok((acos(b), ReducedTop::new(a, b, c)?.minimum().0))
}

pub fn claims(report: &mut Report) -> Result<()> {
    const RUN: &str = "DOP853 with friction";
    let [a, b, c, _] = CUSPS;
    let ((start, bottom), solution) = (tilts()?, damped(400.0)?);
    let last = solution.end_state()[0];
    let slow = 2.0 * c / (a.sqrt() + (a - 4.0 * c * cos(bottom)).sqrt());
    let rate = a.sqrt() * (b - cos(last)) / (sin(last) * sin(last));
    // The nods below the final tilt, at the located lowest points.
    let nods = solution.events().iter().map(|lowest| (lowest.t, lowest.state[0] - bottom));
    let nods: Vec<_> = nods.filter(|(t, _)| (20.0..120.0).contains(t)).collect();
    let ((from, deep), (to, shallow)) = (nods[0], nods[nods.len() - 1]);
    let decay = log(deep / shallow) / (to - from);
    claims! { report,
        /// tilt at which friction leaves the axis
        damped_theta: bottom, "rad", RUN => last, within 1e-9, in "With friction";
        /// how much lower that is than the start
        damped_sag: bottom - start, "rad", RUN => last - start, within 1e-9;
        /// dphi/dt' in the end
        damped_precession: slow, "-", RUN => rate, within 1e-9, in "With friction";
        /// rate at which the nods die, per t'
        damped_decay: decay, "-", "half the friction over I1" => 0.5 * FRICTION, within 1e-4;
    }
}
