//! The same motion from a molecule to the Earth.

use super::forms::Form;
use super::motions::{By, Motion};
use super::naive::{asleep, guarded, rates_by_landau};
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

/// A top of moments 1 and 0.5 in these units, its centre of mass so far from its tip (m), and a
/// weight that pulls with 1 of what they make: for 10 units of time.
pub fn scaled_top(moment: f64, rate: f64, lever: f64) -> Result<Motion> {
    let attitude = Attitude::from_euler(EulerAngles {
        phi: 0.3,
        theta: 0.8,
        zeta: 0.2,
    })?;
    let pull = moment * rate * rate;
    Ok(Motion {
        gravity: Some([pull / lever, lever]),
        ..Motion::top(
            [moment, 0.5 * moment],
            pull,
            attitude,
            [0.3, 0.2, 2.0].map(|w| w * rate),
            10.0 / rate,
        )
    })
}

/// Of a body whose L^2 is no double: Landau's k^2 is made of it.
fn by_squares(motion: &Motion) -> Result<Naive> {
    let off = rates_by_landau(motion)
        .into_iter()
        .zip(motion.true_rates()?);
    Ok(Naive {
        method: "k^2 from L^2 and 2 E",
        error: off.map(|(naive, truth)| (naive - truth).abs()).sum(),
    })
}

fn rows() -> kit::Result<Vec<Row>> {
    let mut rows = Vec::new();
    heavy(&mut rows)?;
    extreme(&mut rows)?;
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

/// Tops: gravity and lengths to match.
fn heavy(rows: &mut Vec<Row>) -> kit::Result<()> {
    let guard = "1e-30 added, so that nothing is divided by zero";
    let sleep = "at rest below 1e-4 rad/s";
    for (words, [moment, rate, lever]) in [
        (
            [
                "top: 1e-40 kg m^2, 1e6 rad/s, 1e-14 m",
                "a torque of 1e-28 N m looks like none",
            ],
            [1e-40, 1e6, 1e-14],
        ),
        (
            [
                "top: 1e38 kg m^2, 4e-5 rad/s, 1e6 m",
                "its rates look like rest, its torque is 1e29 N m",
            ],
            [1e38, 4e-5, 1e6],
        ),
    ] {
        let motion = scaled_top(moment, rate, lever)?;
        let (method, naive) = match moment < 1.0 {
            true => (guard, guarded(&motion)),
            false => (sleep, asleep(&motion, 1e-4)),
        };
        let error = motion.off(naive);
        rows.push(motion.row(words, &By::FREE, Naive { method, error })?);
    }
    Ok(())
}

/// Units in which a square is no double.
fn extreme(rows: &mut Vec<Row>) -> kit::Result<()> {
    for (words, moment) in [
        (
            [
                "1e-170 kg m^2, 1 rad/s",
                "the square of its momentum is zero",
            ],
            1e-170,
        ),
        (
            [
                "1e160 kg m^2, 1 rad/s",
                "the square of its momentum is infinite",
            ],
            1e160,
        ),
    ] {
        let motion = scaled(moment, 1.0)?;
        rows.push(motion.row(words, &By::FREE, by_squares(&motion)?)?);
    }
    Ok(())
}
