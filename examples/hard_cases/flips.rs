//! Ten thousand flips about the intermediate axis.

use super::forms::Form;
use super::motions::{By, Motion};
use super::naive::on_quaternion;
use super::table::{Family, Naive, Row};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::BodyVector;

pub const FAMILY: Family = Family {
    key: "flips",
    title: "Ten thousand flips",
    cure: "the period is known to thirty digits, and whole periods are dropped before anything is rounded",
    methods: &By::names(By::CLOSED),
    forms: &Form::NAMES,
    rows,
};

/// Two flips a period, and a quarter of a period more.
pub const PERIODS: f64 = 5000.25;

pub fn flips(moments: [f64; 3], rates: [f64; 3]) -> Result<Motion> {
    let attitude = Attitude::from_euler(EulerAngles {
        phi: 0.3,
        theta: 0.8,
        zeta: 0.2,
    })?;
    let motion = Motion::free(moments, attitude, rates, 0.0);
    let exact = FreeBody::new(motion.body()?, attitude, BodyVector::from_array(rates))?;
    Ok(Motion {
        end: PERIODS * exact.rate_period(),
        ..motion
    })
}

fn rows() -> kit::Result<Vec<Row>> {
    let mut rows = Vec::new();
    for (words, moments, rates) in [
        (
            [
                "a thousandth off the middle axis",
                "a small error of the energy makes each flip late",
            ],
            [1.0, 2.0, 2.5],
            [0.0, 1.0, 1e-3],
        ),
        (
            [
                "the same, the axes in another order",
                "an odd order of the axes is no rotation",
            ],
            [2.0, 1.0, 2.5],
            [1.0, 0.0, 1e-3],
        ),
        (
            [
                "a ten-thousandth off, the other way",
                "the closer, the later",
            ],
            [1.0, 2.0, 2.5],
            [1e-4, -1.0, 0.0],
        ),
    ] {
        let motion = flips(moments, rates)?;
        let naive = Naive {
            method: "RK4 on quaternion and rates, 100 steps a flip",
            error: motion.off(on_quaternion(&motion, 1_000_050)),
        };
        rows.push(motion.row(words, &By::CLOSED, naive)?);
    }
    Ok(rows)
}
