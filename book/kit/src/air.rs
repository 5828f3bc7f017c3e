//! What pages share on which a constant force drives a body through air.

use super::Report;
use crate::error::Result;
use rotation_dynamics::integrators::{Dop853, second_order};
use rotation_dynamics::planar::contact::QuadraticDrag;

/// Adds the claims on a body in air that starts from rest with this acceleration (m/s^2), has
/// this inertia (kg, turning included) and goes this way (m): how long that takes and how fast it
/// is then, in closed form and by steps.
///
/// # Errors
/// Those of the steps; [`crate::Error::Contradicted`] if they find something else.
pub fn driven_in_air(
    report: &mut Report,
    drag: QuadraticDrag,
    [acceleration, inertia, way]: [f64; 3],
) -> Result<()> {
    let ([time, speed], slowing) = (
        drag.driven(acceleration, inertia, way),
        drag.coefficient() / inertia,
    );
    let law = second_order(|_, _, v| acceleration - slowing * v * v);
    let (there, _) = Dop853::new(1e-13)?.zero(&law, [0.0; 2], 1, 2.0 * time, |y| y[0] - way)?;
    crate::claims! { report,
        /// in air: time of the way
        blown_time: time, "s", "located event" => there.t, within 1e-10 * time;
        /// in air: speed at its end
        blown_speed: speed, "m/s", "located event" => there.state[1], within 1e-10 * speed;
    }
}
