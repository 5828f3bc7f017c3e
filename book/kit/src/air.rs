//! What pages share on which a constant force drives a body through air.

use super::Report;
use crate::error::Result;
use rotation_dynamics::integrators::{Dop853, after, ode, second_order, size_or};
use rotation_dynamics::planar::contact::QuadraticDrag;

/// Adds the claims on a body in air, with this drag coefficient and frontal area (m^2), that starts
/// from rest with this acceleration (m/s^2), has this inertia (kg, turning included) and goes this
/// way (m): how long that takes and how fast it is then, in closed form and by steps.
///
/// # Errors
/// Those of the steps; [`crate::Error::Contradicted`] if they find something else.
pub fn driven_in_air(
    report: &mut Report,
    [coefficient, area]: [f64; 2],
    [acceleration, inertia, way]: [f64; 3],
) -> Result<()> {
    let drag = QuadraticDrag::in_air(1.204, coefficient, area)?;
    let ([time, speed], slowing) =
        (drag.driven(acceleration, inertia, way), drag.coefficient() / inertia);
    let law = second_order(|_, _, v| acceleration - slowing * v * v);
    let (there, _) = Dop853::new(1e-13)?.zero(&law, [0.0; 2], 1, 2.0 * time, |y| y[0] - way)?;
    crate::claims! { report,
        /// in air: time of the way
        blown_time: time, "s", "located event" => there.t, within 1e-10 * time;
        /// in air: speed at its end
        blown_speed: speed, "m/s", "located event" => there.state[1], within 1e-10 * speed;
    }
}

/// The part of the square of the speed at the end that air takes, by steps, if its drag at the
/// speed without it would be this part of the driving force.
///
/// # Errors
/// Those of the steps.
pub fn taken_by_air(part: f64) -> rotation_dynamics::Result<f64> {
    // The square of the speed on the way, over that without air.
    let law = ode(|_, &[square]: &[f64; 1]| [1.0 - part * square]).scaled(size_or([1.0; 1]));
    Ok(part * after(1.0, &law, &[0.0], 1e-12)?[0])
}
