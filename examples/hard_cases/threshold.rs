//! The sleeping top at the spin at which it falls asleep, and the last digit either side.

use super::forms::Form;
use super::motions::{By, Motion};
use super::naive::{by_arc_cosine, on_euler_angles};
use super::table::{Family, Naive, Row};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles};

pub const FAMILY: Family = Family {
    key: "threshold",
    title: "The sleeping top at its threshold",
    cure: "the gaps between the roots are formed without subtraction, in pairs of doubles; the tilt is an arc tangent",
    methods: &By::names(By::TOP),
    forms: &Form::NAMES,
    rows,
};

/// I3 omega_3 = 2 sqrt(I1 m g l) at 4 rad/s.
const CRITICAL: f64 = 4.0;
const END: f64 = 15.0;

pub fn top(theta: f64, rates: [f64; 3]) -> Result<Motion> {
    let attitude = Attitude::from_euler(EulerAngles {
        phi: 0.3,
        theta,
        zeta: 0.2,
    })?;
    Ok(Motion::top([1.0, 0.5], 1.0, attitude, rates, END))
}

fn rows() -> kit::Result<Vec<Row>> {
    let above = CRITICAL * (1.0 + f64::EPSILON);
    let below = CRITICAL * (1.0 - f64::EPSILON);
    let mut rows = Vec::new();
    for (words, spin) in [
        (
            [
                "1e-6 rad off, at the threshold",
                "two roots of the cubic meet",
            ],
            CRITICAL,
        ),
        (
            [
                "1e-6 rad off, an eps above",
                "their gap is lost to cancellation",
            ],
            above,
        ),
        (
            [
                "1e-6 rad off, an eps below",
                "and its sign decides whether the top sleeps",
            ],
            below,
        ),
    ] {
        let motion = top(1e-6, [0.0, 0.0, spin])?;
        let naive = Naive {
            method: "tilt by the arc cosine",
            error: motion.off(by_arc_cosine(motion.truth()?)),
        };
        rows.push(motion.row(words, &By::TOP, naive)?);
    }
    let angles = |motion: &Motion| Naive {
        method: "RK4 on Euler angles, 20 000 steps",
        error: motion.off(on_euler_angles(motion, 20_000)),
    };
    for (words, spin) in [
        (
            [
                "upright, kicked at the threshold",
                "the kick is all there is",
            ],
            CRITICAL,
        ),
        (["upright, kicked an eps below", "the same"], below),
    ] {
        let motion = top(0.0, [1e-6, 0.0, spin])?;
        rows.push(motion.row(words, &By::TOP, angles(&motion))?);
    }
    for (words, spin) in [
        (
            [
                "exactly upright, at the threshold",
                "a kick by rounding would grow with t",
            ],
            CRITICAL,
        ),
        (
            ["exactly upright, an eps below", "and here exponentially"],
            below,
        ),
    ] {
        let motion = top(0.0, [0.0, 0.0, spin])?;
        let turned = 2.0 + spin * END;
        rows.push(motion.row_of_condition(words, &By::TOP, angles(&motion), [turned; 2])?);
    }
    Ok(rows)
}
