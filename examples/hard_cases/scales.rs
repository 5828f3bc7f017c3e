//! The same motion from a molecule to the Earth.

use super::forms::Form;
use super::motions::{By, Motion};
use super::naive::{asleep, guarded};
use super::table::{Family, Naive, Row};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles};

pub const FAMILY: Family = Family {
    key: "scales",
    title: "From a molecule to the Earth",
    cure: "every error is measured against the size of what it is an error of",
    methods: &By::names(By::FREE),
    forms: &Form::NAMES,
    rows,
};

/// Moments 1, 1.3, 1.7 and rates 0.3, 0.2, 1 in these units, for 30 units of time.
pub fn scaled(moment: f64, rate: f64) -> Result<Motion> {
    let attitude = Attitude::from_euler(EulerAngles {
        phi: 0.3,
        theta: 0.8,
        zeta: 0.2,
    })?;
    let moments = [1.0, 1.3, 1.7].map(|i| i * moment);
    let rates = [0.3, 0.2, 1.0].map(|w| w * rate);
    Ok(Motion::free(moments, attitude, rates, 30.0 / rate))
}

fn rows() -> Result<Vec<Row>> {
    let mut rows = Vec::new();
    for (words, moment, rate) in [
        (
            [
                "molecule: 1e-46 kg m^2, 1e12 rad/s",
                "its moments are less than any number that looks like zero",
            ],
            1e-46,
            1e12,
        ),
        (["dust: 1e-40 kg m^2, 1e6 rad/s", "the same"], 1e-40, 1e6),
    ] {
        let motion = scaled(moment, rate)?;
        let naive = Naive {
            method: "1e-30 added, so that nothing is divided by zero",
            error: motion.off(guarded(&motion)),
        };
        rows.push(motion.row(words, &By::FREE, naive)?);
    }
    for (words, moment, rate) in [
        (
            [
                "asteroid: 1e20 kg m^2, 1e-6 rad/s",
                "its rates look like rest",
            ],
            1e20,
            1e-6,
        ),
        (
            [
                "Earth: 1e38 kg m^2, 7.3e-5 rad/s",
                "the same, and its energy is 5e29 J",
            ],
            1e38,
            7.3e-5,
        ),
    ] {
        let motion = scaled(moment, rate)?;
        let naive = Naive {
            method: "at rest below 1e-4 rad/s",
            error: motion.off(asleep(&motion, 1e-4)),
        };
        rows.push(motion.row(words, &By::FREE, naive)?);
    }
    Ok(rows)
}
