//! Tops at the bottom of their potential, on cusps, very fast and very slow.

use super::forms::Form;
use super::motions::{By, Motion};
use super::naive::{tilt_by_energy, turning_point};
use super::table::{Family, Naive, Row};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::math::{cos, sin};

pub const FAMILY: Family = Family {
    key: "tops",
    title: "Steady, cusped, fast and slow tops",
    cure: "turning points and their distance come from the start itself, not from the energy",
    methods: &By::names(By::TOP),
    forms: &Form::NAMES,
    rows,
};

/// The body of the notes' parameters a, b, c at the tilt `theta` with the rate `along`:
/// I1 = 1, I3 = a, m g l = c, omega_3 = 1/sqrt(a).
fn top([a, b, c]: [f64; 3], theta: f64, along: f64, end: f64) -> Result<Motion> {
    let attitude = Attitude::from_euler(EulerAngles {
        phi: 0.3,
        theta,
        zeta: 0.0,
    })?;
    let across = a.sqrt() * (b - cos(theta)) / sin(theta);
    Ok(Motion::top(
        [1.0, a],
        c,
        attitude,
        [along, across, 1.0 / a.sqrt()],
        end,
    ))
}

/// Released at rest at the tilt `theta`.
pub fn released([a, c]: [f64; 2], theta: f64, end: f64) -> Result<Motion> {
    let attitude = Attitude::from_euler(EulerAngles {
        phi: 0.3,
        theta,
        zeta: 0.0,
    })?;
    Ok(Motion::top(
        [1.0, a],
        c,
        attitude,
        [0.0, 0.0, 1.0 / a.sqrt()],
        end,
    ))
}

fn rows() -> kit::Result<Vec<Row>> {
    let [a, b, c] = [1.5, 1.2, 0.2];
    let (steady, lowest) = ReducedTop::new(a, b, c)?.minimum();
    let third = core::f64::consts::FRAC_PI_3;
    let mut rows = Vec::new();
    for (words, motion) in [
        (
            [
                "E~ within 5e-13 of U_min",
                "the turning points are a millionth apart, a double root but for that",
            ],
            top([a, b, c], steady, 1e-6, 40.0)?,
        ),
        (
            [
                "exactly on a cusp, b = 1/2",
                "it starts at rest, where the root is zero",
            ],
            released([1.5, 0.25], third, 40.0)?,
        ),
        (
            ["very fast, c = 1e-8", "it nods by 1e-8 rad"],
            released([1.5, 1e-8], 1.0, 60.0)?,
        ),
        (
            [
                "very slow, c = 1e6",
                "it falls like a pendulum and passes the bottom close by",
            ],
            released([1.5, 1e6], 1.0, 0.03)?,
        ),
    ] {
        let tilt = motion.truth()?.euler_angles().theta;
        let naive = Naive {
            method: "theta' = sqrt(2 (E - U)), stepped",
            error: (tilt_by_energy(&motion, 10_000) - tilt).abs(),
        };
        rows.push(motion.row(words, &By::TOP, naive)?);
    }
    for (words, [a, b, c], energy) in [
        (
            [
                "E~ two roundings above U_min",
                "all but a double root: half of the digits are lost",
            ],
            [a, b, c],
            lowest + 2.0 * f64::EPSILON * lowest.abs(),
        ),
        (
            [
                "near the pole: b = 0.999, E~ = 0.05",
                "the root is all but 1, and what it lacks of 1 is asked for",
            ],
            [1.9, 0.999, 0.45],
            0.05,
        ),
    ] {
        let reduced = ReducedTop::new(a, b, c)?;
        let exact = HeavyTop::from_energy(reduced, energy, Start::ThetaMin, 0.0, 0.0)?;
        let theta = exact.theta_min();
        let motion = top([a, b, c], theta, 0.0, 40.0)?;
        let naive = Naive {
            method: "turning point by the trigonometric formula of the cubic",
            error: (turning_point([a, b, c], energy) - theta).abs(),
        };
        rows.push(motion.row(words, &By::TOP, naive)?);
    }
    Ok(rows)
}
