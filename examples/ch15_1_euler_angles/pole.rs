//! A body that is turned steadily about a level axis, past the place where its own axis is
//! vertical: harmless for the body, not for its Euler angles.

use super::*;

/// The attitude at the time `t`, without any differential equation: the tilt is `e` at the closest,
/// at t = 0, and the body turns about X at 1 rad/s, from 1 rad before to 1 rad after it.
pub fn passing(e: f64, t: f64) -> Result<Attitude> {
    let leaning = Attitude::from_rotation_vector(SpaceVector::new(0.0, e, 0.0))?;
    Ok(leaning.turned_in_space(SpaceVector::new(t, 0.0, 0.0))?)
}

/// Its angles: (phi, theta, zeta).
pub fn passing_angles(e: f64, t: f64) -> [f64; 3] {
    let ((se, ce), (st, ct)) = (sincos(e), sincos(t));
    let phi = atan2(se, st * ce);
    [phi, atan2(hypot(se, st * ce), ct * ce), atan2(-ct * se, st)]
}

/// A way to the end of the passage at this tilt, with this error of a step.
type Way = fn(f64, f64) -> Result<(Attitude, Work)>;

fn by_angles(e: f64, step: f64) -> Result<(Attitude, Work)> {
    let start = passing_angles(e, -1.0);
    let (end, work) = Dop853::new(step)?.advance(&rates_of_angles(), -1.0, &start, 1.0)?;
    let [phi, theta, zeta] = end;
    Ok((Attitude::from_euler(EulerAngles { phi, theta, zeta })?, work))
}

fn by_quaternion(e: f64, step: f64) -> Result<(Attitude, Work)> {
    let start = passing(e, -1.0)?.quaternion();
    let (end, work) = Dop853::new(step)?.advance(&rates_of_quaternion(), -1.0, &start, 1.0)?;
    Ok((Attitude::from_quaternion(end)?, work))
}

/// How far phi advances and how fast; and what either set of variables pays, near and far.
pub fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (e, h, fastest) = (p.closest, 1e-3 * p.closest, |e| cos(e) / sin(e));
    let (phi, rate) = (|t| passing_angles(e, t)[0], fastest(e));
    // Integrated as an angle: an attitude would not tell one way round the pole from the other.
    let (method, start) = (Dop853::new(1e-14)?, passing_angles(e, -1.0));
    let ([simulated, ..], _) = method.advance(&rates_of_angles(), -1.0, &start, 1.0)?;
    let difference = |h: f64| (phi(-h) - phi(h)) / (2.0 * h);
    // The error of a difference is even in h.
    let slope = (4.0 * difference(0.5 * h) - difference(h)) / 3.0;
    claims! { report,
        /// advance of phi past theta = 0
        passage_phi: phi(1.0) - phi(-1.0), "rad", "the rates of phi, theta, zeta integrated" => simulated - phi(-1.0),
        within 1e-10 / e.min(1.0);
        /// fastest rate of phi, backwards, over the rate of the body
        passage_rate: rate, "-", "difference of phi" => slope, within 1e-9 * rate;
    }?;
    let columns = ["closest", "rate of phi", "by angles", "error", "by quaternion", "error of it"];
    report.add(Table::of("passages", columns, [0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-6], |e: f64| {
        let rate = supported_digits(fastest(e), 1e-4 * fastest(e));
        let mut cells = vec![format!("{e:e}"), rate];
        for way in [by_angles, by_quaternion] {
            let (end, work) = way(e, p.tolerance)?;
            let error = end.angle_to(&passing(e, 1.0)?);
            cells.extend([work.derivatives.to_string(), below(error, 1e-17)]);
        }
        Ok(cells)
    })?)
}

/// What the same method pays with either set of variables.
pub fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (e, exact) = (p.closest, passing(p.closest, 1.0)?);
    let ways: [(&str, Way); 2] = [
        ("DOP853, quaternion, error of a step", by_quaternion),
        ("DOP853, angles, error of a step", by_angles),
    ];
    for (method, way) in ways {
        let (asked, run) = ([p.tolerance, 1e-3, 1e-6, 1e-9, 1e-12], move |step| way(e, step));
        let error = move |(end, _): &(Attitude, Work)| Ok(end.angle_to(&exact));
        report.controlled(method, asked, run, |run| run.1, error)?;
    }
    report.in_closed_form(move |part| passing(e, 2.0 * part - 1.0));
    Ok(())
}
