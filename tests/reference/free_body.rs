//! The free body: theta functions, set up in double-double arithmetic.

use super::case::{Case, Outcome, Result};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::exact::free_body::{FreeBody, Kind};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;

/// Measured: 4.5 (the attitude near the middle axis), median 0.3.
pub const BOUND: f64 = 4.5;

pub fn closed_form(case: &Case) -> Result<Outcome> {
    closed_form_with_rate(case, 1.0)
}

/// The same with the third rate multiplied by `damage`, for the test of the test.
pub fn closed_form_with_rate(case: &Case, damage: f64) -> Result<Outcome> {
    let mut outcome = Outcome::new();
    let [i1, i2, i3] = case.input_vector("I")?;
    let mut omega = case.input_vector("omega0")?;
    omega[2] *= damage;
    let [phi, theta, zeta] = case.input_vector("euler0")?;
    let moments = PrincipalMoments::new(i1, i2, i3)?;
    let start = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
    let body = FreeBody::new(moments, start, BodyVector::from_array(omega))?;

    // No condition is given for the derived values: their own size is the scale.
    let derived = [("E", body.kinetic_energy()), ("L", body.angular_momentum().norm())];
    let asymmetric = [("T_omega", body.rate_period()), ("dpsi", body.precession_per_period())];
    let asymmetric = asymmetric.iter().filter(|_| body.kind() == Kind::Asymmetric);
    for (name, got) in derived.iter().chain(asymmetric) {
        if let Some(want) = case.derived(name) {
            outcome.compare(name, *got, want, want.abs().to_f64());
        }
    }
    for sample in case.samples() {
        let Kinematics { attitude, angular_velocity: omega } = body.kinematics(sample.t());
        outcome.compare_field(&sample, "omega", &omega.to_array());
        outcome.compare_field(&sample, "R", &attitude.matrix().concat());
    }
    Ok(outcome)
}
