//! The pendulum: theta functions, set up in double-double arithmetic.

use super::case::{Case, Outcome, Result};
use rotation_dynamics::exact::pendulum::{Pendulum, PendulumKind, Suspension};
use rotation_dynamics::math::DoubleDouble;

/// Measured against `sens`, which asks for more than `sens_norm`: 1.86 over the
/// repository's cases, 2.04 over 279 others.
pub const BOUND: f64 = 1.9;

pub fn closed_form(case: &Case) -> Result<Outcome> {
    closed_form_with_gravity(case, 1.0)
}

/// The same with the gravity multiplied by `damage`, for the test of the test.
pub fn closed_form_with_gravity(case: &Case, damage: f64) -> Result<Outcome> {
    let mut outcome = Outcome::new();
    let suspension = Suspension {
        moment: case.input("I")?,
        mass: case.input("m")?,
        gravity: case.input("g")? * damage,
        lever: case.input("d")?,
    };
    let pendulum = Pendulum::new(suspension, case.input("theta0")?, case.input("omega0")?)?;

    let kind = match pendulum.kind() {
        PendulumKind::Rest => "rest",
        PendulumKind::Oscillation => "osc",
        PendulumKind::Separatrix => "sep",
        PendulumKind::Rotation => "rot",
    };
    if case.derived_word("type").is_some_and(|want| want != kind) {
        outcome.compare("type", f64::NAN, DoubleDouble::ZERO, 1.0);
    }
    let derived = [
        ("T", pendulum.period()),
        ("T_small", 2.0 * core::f64::consts::PI / pendulum.small_swing_frequency()),
        ("W", pendulum.small_swing_frequency()),
        ("k2", pendulum.energy_ratio()),
    ];
    for (name, got) in derived {
        if let Some(want) = case.derived(name) {
            // No condition is given: the value itself is the scale.
            outcome.compare(name, got, want, want.abs().to_f64());
        }
    }
    for sample in case.samples() {
        let state = pendulum.at(sample.t())?;
        outcome.compare_sharply(&sample, "theta", state.theta);
        outcome.compare_sharply(&sample, "omega", state.omega);
    }
    Ok(outcome)
}
