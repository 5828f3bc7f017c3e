//! A body that is turned steadily about a level axis, past the place where its own axis is
//! vertical: harmless for the body, not for its Euler angles.

use super::*;
use kit::{ClosedForm, supported_digits};
use rotation_dynamics::integrators::{Dop853, Integrator, Work};

/// The tilt at the closest, and the turning from 1 rad before to 1 rad after it, about X.
#[derive(Debug, Clone, Copy)]
pub struct Passage(pub f64);

impl Passage {
    /// The attitude, without any differential equation.
    pub fn attitude(&self, t: f64) -> rotation_dynamics::Result<Attitude> {
        let leaning = Attitude::about_space_axis(SpaceVector::new(0.0, 1.0, 0.0), self.0)?;
        leaning.turned_in_space(SpaceVector::new(t, 0.0, 0.0))
    }

    /// Its angles: (phi, theta, zeta).
    pub fn angles(&self, t: f64) -> [f64; 3] {
        let ((se, ce), (st, ct)) = (sincos(self.0), sincos(t));
        let phi = atan2(se, st * ce);
        [phi, atan2(hypot(se, st * ce), ct * ce), atan2(-ct * se, st)]
    }

    /// The end by Euler angles, as an attitude.
    pub fn by_angles(
        &self,
        tolerance: f64,
    ) -> rotation_dynamics::Result<(Attitude, [f64; 3], Work)> {
        let method = Dop853::new(tolerance)?;
        let (end, work) = method.advance(&rates_of_angles(), -1.0, &self.angles(-1.0), 1.0)?;
        let [phi, theta, zeta] = end;
        Ok((Attitude::from_euler(EulerAngles { phi, theta, zeta })?, end, work))
    }

    /// The end by quaternions.
    pub fn by_quaternion(&self, tolerance: f64) -> rotation_dynamics::Result<(Attitude, Work)> {
        let (method, start) = (Dop853::new(tolerance)?, self.attitude(-1.0)?.quaternion());
        let (end, work) = method.advance(&rates_of_quaternion(), -1.0, &start, 1.0)?;
        Ok((Attitude::from_quaternion(end)?, work))
    }
}

pub fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (passage, e) = (Passage(p.closest), p.closest);
    let (exact, simulated) = (passage.angles(1.0), passage.by_angles(1e-14)?.1);
    let advance = exact[0] - passage.angles(-1.0)[0];
    let (rate, h) = (cos(e) / sin(e), 1e-3 * e);
    let difference = |h: f64| (passage.angles(-h)[0] - passage.angles(h)[0]) / (2.0 * h);
    // The error of a difference is even in h.
    let slope = (4.0 * difference(0.5 * h) - difference(h)) / 3.0;
    let from = passage.angles(-1.0)[0];
    kit::claims! { report,
        /// advance of phi past theta = 0
        passage_phi: advance, "rad", "the rates of phi, theta, zeta integrated" => simulated[0] - from, within 1e-10 / e.min(1.0);
        /// fastest rate of phi, backwards, over the rate of the body
        passage_rate: rate, "-", "difference of phi" => slope, within 1e-9 * rate;
    }?;
    let columns = ["closest", "rate of phi", "by angles", "error", "by quaternion", "error of it"];
    let mut table = Table::new("passages", columns)?;
    for e in [0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-6] {
        let (passage, exact) = (Passage(e), Passage(e).attitude(1.0)?);
        let (angles, _, work) = passage.by_angles(p.tolerance)?;
        let (quaternion, other) = passage.by_quaternion(p.tolerance)?;
        table.push([
            format!("{e:e}"),
            supported_digits(cos(e) / sin(e), 1e-4 * cos(e) / sin(e)),
            work.derivatives.to_string(),
            below(angles.angle_to(&exact), 1e-17),
            other.derivatives.to_string(),
            below(quaternion.angle_to(&exact), 1e-17),
        ])?;
    }
    report.add(table)
}

/// What the same method pays with either set of variables.
pub fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (passage, exact) = (Passage(p.closest), Passage(p.closest).attitude(1.0)?);
    let asked = [p.tolerance, 1e-3, 1e-6, 1e-9, 1e-12];
    let by_quaternion = move |tolerance| passage.by_quaternion(tolerance);
    report.controlled(
        "DOP853, quaternion, error of a step",
        asked,
        by_quaternion,
        |run| run.1,
        move |run| Ok(run.0.angle_to(&exact)),
    )?;
    let by_angles = move |tolerance| passage.by_angles(tolerance);
    report.controlled(
        "DOP853, angles, error of a step",
        asked,
        by_angles,
        |run| run.2,
        move |run| Ok(run.0.angle_to(&exact)),
    )?;
    report.set_closed_form(ClosedForm::new(move |part| passage.attitude(2.0 * part - 1.0)));
    Ok(())
}
