//! From an angular velocity to the attitude, in steps: by the Euler angles, whose rates grow
//! without limit at the pole, and by the quaternion, which knows no pole.

use super::*;
use kit::{ClosedForm, Table, rounded_up, short};
use rotation_dynamics::integrators::{Dop853, Integrator, Work};

/// The attitude after the time `end`, by the angles.
pub fn by_angles(
    omega: SpaceVector,
    start: &Attitude,
    end: f64,
    step: f64,
) -> rotation_dynamics::Result<(Attitude, Work)> {
    let EulerAngles { phi, theta, zeta } = start.euler_angles();
    let method = Dop853::new(step)?;
    let ([phi, theta, zeta], work) =
        method.advance(&angles_of(omega), 0.0, &[phi, theta, zeta], end)?;
    Ok((Attitude::from_euler(EulerAngles { phi, theta, zeta })?, work))
}

/// The same by the quaternion.
pub fn by_quaternion(
    omega: SpaceVector,
    start: &Attitude,
    end: f64,
    step: f64,
) -> rotation_dynamics::Result<(Attitude, Work)> {
    let method = Dop853::new(step)?;
    let (end, work) = method.advance(&quaternion_of(omega), 0.0, &start.quaternion(), end)?;
    Ok((Attitude::from_quaternion(end)?, work))
}

/// A body that turns about X at 1 rad/s, its axis 1 rad before the plane of X and Z, which it
/// will pass at this tilt.
pub fn passing(tilt: f64) -> Result<(SpaceVector, Attitude)> {
    let lean = Attitude::from_rotation_vector(SpaceVector::new(0.0, tilt, 0.0))?;
    let x = SpaceVector::new(1.0, 0.0, 0.0);
    Ok((x, lean.turned_in_space(-x)?))
}

/// An attitude from which the axle of a body with this angular velocity stays half a radian clear
/// of both poles, in the vertical plane of that vector and beyond it.
pub fn clear_of_poles(omega: SpaceVector) -> rotation_dynamics::Result<Attitude> {
    let [x, y, z] = omega.to_array();
    // From the nearer pole to the vector, and from there to the axle, which goes round it.
    let tilt = atan2(hypot(x, y), z.abs());
    let beyond = if tilt < 0.6 { 0.7 } else { -0.5 };
    let theta = 2.0 * tilt + beyond;
    Attitude::from_euler(EulerAngles {
        phi: atan2(y, x) + FRAC_PI_2,
        theta: if z < 0.0 { PI - theta } else { theta },
        zeta: 0.0,
    })
}

/// How long that body is followed, s: past the pole, and not as far as it was before.
const PAST: f64 = 1.7;

/// What it costs to pass a pole, and the accuracy strip.
pub fn add(p: &Parameters, report: &mut Report) -> Result<()> {
    let columns = [
        "least tilt / rad",
        "angles: steps",
        "angles: error / rad",
        "quaternion: steps",
        "quaternion: error / rad",
    ];
    let mut table = Table::new("poles", columns)?;
    for tilt in [0.1, 0.01, 1e-3, 1e-4] {
        let (omega, start) = passing(tilt)?;
        let exact = start.turned_in_space(omega * PAST)?;
        let ways = [by_angles, by_quaternion];
        let mut cells = vec![short(tilt, 1)];
        for way in ways {
            let (reached, work) = way(omega, &start, PAST, p.tolerance)?;
            cells.extend([
                (work.steps + work.rejected).to_string(),
                rounded_up(reached.angle_to(&exact)),
            ]);
        }
        table.push(cells)?;
    }
    report.add(table)?;
    let omega = body(p)[0];
    let start = clear_of_poles(omega)?;
    // A third of a turn, so that no error comes back to where it started.
    let end = 2.0 * PI / 3.0 / omega.norm().max(1e-3);
    let exact = start.turned_in_space(omega * end)?;
    let asked = [p.tolerance, 1e-4, 1e-8, 1e-12, 1e-15];
    let error = move |(reached, _): &(Attitude, Work)| Ok(reached.angle_to(&exact));
    let angles = move |step| by_angles(omega, &start, end, step);
    report.controlled(
        "DOP853 on the angles, error of a step",
        asked,
        angles,
        |run| run.1,
        error,
    )?;
    let quaternion = move |step| by_quaternion(omega, &start, end, step);
    report.controlled(
        "DOP853 on the quaternion, error of a step",
        asked,
        quaternion,
        |run| run.1,
        error,
    )?;
    report
        .set_closed_form(ClosedForm::new(move |part| start.turned_in_space(omega * (part * end))));
    Ok(())
}
