//! Next to the motion that needs for ever: the middle axis, and the top that just gets up.

use super::forms::Form;
use super::motions::{By, Motion};
use super::naive::rates_by_landau;
use super::table::{Family, Naive, Row};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::log;

pub const FAMILY: Family = Family {
    key: "separatrix",
    title: "At the separatrix",
    cure: "1 - k^2 is formed from the small rates themselves, never as a difference from 1",
    methods: &By::names(By::FREE),
    forms: &Form::NAMES,
    rows,
};

/// Moments for which a separatrix goes through round numbers: omega_1 = 2 omega_3.
const MOMENTS: [f64; 3] = [3.0, 4.0, 6.0];

fn start() -> Result<Attitude> {
    Attitude::from_euler(EulerAngles {
        phi: 0.3,
        theta: 0.8,
        zeta: 0.2,
    })
}

fn free(rates: [f64; 3], end: f64) -> Result<Motion> {
    Ok(Motion::free(MOMENTS, start()?, rates, end))
}

/// The angle between the angular momentum on the body's axes by Landau's formulas and the true
/// one.
fn by_landau(motion: &Motion) -> Result<Naive> {
    let momentum = |rates: [f64; 3]| {
        let [a, b, c]: [f64; 3] = core::array::from_fn(|i| MOMENTS[i] * rates[i]);
        BodyVector::new(a, b, c)
    };
    let (naive, truth) = (
        momentum(rates_by_landau(motion)),
        momentum(motion.true_rates()?),
    );
    let error = rotation_dynamics::math::atan2(naive.cross(&truth).norm(), naive.dot(&truth));
    Ok(Naive {
        method: "Jacobi's functions with 1 - k^2 by subtraction",
        error,
    })
}

fn rows() -> Result<Vec<Row>> {
    let mut rows = Vec::new();
    // From the middle axis, the third rate off: 1 - k^2 = 4.5 of its square.
    for (words, complement) in [
        (
            [
                "1 - k^2 = 1e-8, one flip",
                "the flip is late by the logarithm of 1 - k^2",
            ],
            1e-8,
        ),
        (
            [
                "1 - k^2 = 1e-12, one flip",
                "of which a difference from 1 keeps four digits",
            ],
            1e-12,
        ),
        (["1 - k^2 = 1e-16, one flip", "and here none"], 1e-16),
    ] {
        let off: f64 = (complement / 4.5_f64).sqrt();
        // The flip comes when the small rate, growing as exp(t/3), is of order one.
        let flip = 3.0 * log(2.0 / off);
        let motion = free([0.0, 1.0, off], flip + 6.0)?;
        rows.push(motion.row(words, &By::FREE, by_landau(&motion)?)?);
    }
    let motion = free([0.0, 1.0, 0.0], 20.0)?;
    let words = [
        "exactly about the middle axis",
        "any rounding is a kick, and grows as exp(t/3)",
    ];
    rows.push(motion.row(words, &By::FREE, by_landau(&motion)?)?);
    Ok(rows)
}
