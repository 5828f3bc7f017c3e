//! From an angular velocity to the attitude, in steps: by the Euler angles, whose rates grow
//! without limit at the pole, and by the quaternion, which knows no pole.

use super::*;
use kit::{rounded_up, short};
use rotation_dynamics::integrators::{Dop853, Integrator, Work};

/// The constant angular velocity of a body, and its attitude at the start.
pub type Steady = (SpaceVector, Attitude);

/// A way to its attitude after a time, with this error of a step.
type Way = fn(Steady, f64, f64) -> Result<(Attitude, Work)>;

pub fn by_angles((omega, start): Steady, end: f64, step: f64) -> Result<(Attitude, Work)> {
    let EulerAngles { phi, theta, zeta } = start.euler_angles();
    let run = Dop853::new(step)?.advance(&angles_of(omega), 0.0, &[phi, theta, zeta], end)?;
    let ([phi, theta, zeta], work) = run;
    Ok((Attitude::from_euler(EulerAngles { phi, theta, zeta })?, work))
}

pub fn by_quaternion((omega, start): Steady, end: f64, step: f64) -> Result<(Attitude, Work)> {
    let run = Dop853::new(step)?.advance(&quaternion_of(omega), 0.0, &start.quaternion(), end)?;
    Ok((Attitude::from_quaternion(run.0)?, run.1))
}

/// A body that turns about X at 1 rad/s, its axis 1 rad before the plane of X and Z, which it
/// will pass at this tilt.
pub fn passing(tilt: f64) -> Result<Steady> {
    let lean = Attitude::from_rotation_vector(SpaceVector::new(0.0, tilt, 0.0))?;
    Ok((X, lean.turned_in_space(-X)?))
}

/// An attitude from which the axle of a body with this angular velocity stays half a radian clear
/// of both poles, in the vertical plane of that vector and beyond it.
pub fn clear_of_poles(omega: SpaceVector) -> Result<Attitude> {
    let [x, y, z] = omega.to_array();
    // From the nearer pole to the vector, and from there to the axle, which goes round it.
    let tilt = atan2(hypot(x, y), z.abs());
    let theta = 2.0 * tilt + if tilt < 0.6 { 0.7 } else { -0.5 };
    let theta = if z < 0.0 { PI - theta } else { theta };
    let phi = atan2(y, x) + FRAC_PI_2;
    Ok(Attitude::from_euler(EulerAngles { phi, theta, zeta: 0.0 })?)
}

/// What it costs to pass a pole.
pub fn poles(p: &Parameters, report: &mut Report) -> Result<()> {
    // Past the pole, and not as far as it was before, s.
    let past = 1.7;
    let columns = ["least tilt / rad", "angles: steps", "angles: error / rad"];
    let columns = columns.into_iter().chain(["quaternion: steps", "quaternion: error / rad"]);
    report.add(Table::of("poles", columns, [0.1, 0.01, 1e-3, 1e-4], |tilt| {
        let (omega, start) = passing(tilt)?;
        let exact = start.turned_in_space(omega * past)?;
        let mut cells = vec![short(tilt, 1)];
        for way in [by_angles, by_quaternion] {
            let (reached, work) = way((omega, start), past, p.tolerance)?;
            let error = rounded_up(reached.angle_to(&exact));
            cells.extend([(work.steps + work.rejected).to_string(), error]);
        }
        Ok(cells)
    })?)
}

/// The accuracy strip: both ways, clear of the poles.
pub fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let [omega, _] = body(p);
    let start = clear_of_poles(omega)?;
    // A third of a turn, so that no error comes back to where it started.
    let end = 2.0 * PI / 3.0 / omega.norm().max(1e-3);
    let exact = start.turned_in_space(omega * end)?;
    let ways: [(&str, Way); 2] = [
        ("DOP853 on the angles, error of a step", by_angles),
        ("DOP853 on the quaternion, error of a step", by_quaternion),
    ];
    for (method, way) in ways {
        let run = move |step| way((omega, start), end, step);
        let error = move |(reached, _): &(Attitude, Work)| Ok(reached.angle_to(&exact));
        let asked = [p.tolerance, 1e-4, 1e-8, 1e-12, 1e-15];
        report.controlled(method, asked, run, |run| run.1, error)?;
    }
    report.in_closed_form(move |part| start.turned_in_space(omega * (part * end)));
    Ok(())
}
