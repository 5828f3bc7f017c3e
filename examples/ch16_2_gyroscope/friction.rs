//! What friction in the bearing of the line of nodes makes of the motion in the end.

use super::Equations;
use kit::{Report, Result, claim};
use rotation_dynamics::exact::heavy_top::ReducedTop;
use rotation_dynamics::integrators::{Dop853, Event, Solution};
use rotation_dynamics::math::{acos, cos, log, sin};

/// Torque of that bearing over dtheta/dt'.
pub const FRICTION: f64 = 0.15;

/// The cusped motion with friction in the bearing of the line of nodes.
pub fn damped(end: f64) -> rotation_dynamics::Result<Solution<4>> {
    let (a, b, c, friction) = (2.0, 0.6, 0.2, FRICTION);
    let start = [acos(b), 0.0, 0.0, 0.0]; // released at rest
    let lowest = Event::falling("lowest", |_t, y: &[f64; 4]| y[1]);
    let equations = Equations { a, b, c, friction };
    Dop853::new(1e-13)?.solve(&equations, 0.0, &start, end, &[lowest])
}

/// The tilt at which it starts, and that of the bottom of its valley.
pub fn tilts() -> Result<(f64, f64)> {
    Ok((acos(0.6), ReducedTop::new(2.0, 0.6, 0.2)?.minimum().0))
}

pub fn add(report: &mut Report) -> Result<()> {
    const GROUP: &str = "With friction";
    const RUN: &str = "DOP853 with friction";
    let (start, bottom) = tilts()?;
    let solution = damped(400.0)?;
    let last = solution.end_state()[0];
    let (a, b, c): (f64, f64, f64) = (2.0, 0.6, 0.2);
    let slow = 2.0 * c / (a.sqrt() + (a - 4.0 * c * cos(bottom)).sqrt());
    let rate = a.sqrt() * (b - cos(last)) / (sin(last) * sin(last));
    report.add(vec![
        claim("damped_theta", "tilt at which friction leaves the axis", bottom, "rad")
            .within(1e-9)
            .against(RUN, last)
            .answer(GROUP),
        claim("damped_sag", "how much lower that is than the start", bottom - start, "rad")
            .within(1e-9)
            .against(RUN, last - start),
        claim("damped_precession", "dphi/dt' in the end", slow, "-")
            .within(1e-9)
            .against(RUN, rate)
            .answer(GROUP),
    ])?;
    // Depths of the nods below the final tilt, at the located lowest points.
    let depths: Vec<(f64, f64)> = solution
        .events()
        .iter()
        .map(|e| (e.t, e.state[0] - bottom))
        .filter(|(t, _)| (20.0..120.0).contains(t))
        .collect();
    let (first, final_) = (depths[0], depths[depths.len() - 1]);
    let decay = log(first.1 / final_.1) / (final_.0 - first.0);
    report.add(
        claim("damped_decay", "rate at which the nods die, per t'", decay, "-")
            .within(1e-4)
            .against("half the friction over I1", 0.5 * FRICTION),
    )
}
