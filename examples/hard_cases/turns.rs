//! Half turns, antipodal quaternions, and rates from none to very many.

use super::forms::Form;
use super::motions::{By, Motion};
use super::naive::{by_trace, on_quaternion, rates_by_landau};
use super::table::{Family, Naive, Row};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{hypot, sincos};

pub const FAMILY: Family = Family {
    key: "turns",
    title: "Half turns, and rates of every size",
    cure: "components are brought to one by a power of two before they are squared; the largest component divides",
    methods: &By::names(By::FREE),
    forms: &Form::NAMES,
    rows,
};

const MOMENTS: [f64; 3] = [1.0, 1.3, 1.7];

fn half_turn() -> Result<Attitude> {
    Attitude::about_space_axis(SpaceVector::new(1.0, -2.0, 3.0), core::f64::consts::PI)
}

/// An azimuth of 1e32 rad, and what it is beyond whole turns: 1e32 is a whole number, and this
/// its remainder by 2 pi to 80 digits, rounded.
pub const AZIMUTH: [f64; 2] = [1e32, 0.625_167_975_329_289_9];

fn turned(phi: f64) -> Result<Attitude> {
    Attitude::from_euler(EulerAngles {
        phi,
        theta: 0.8,
        zeta: 0.2,
    })
}

/// Axis by division by |omega|, as it is squared and summed; then the angle |omega| t.
fn by_axis(motion: &Motion) -> Option<Attitude> {
    let [p, q, r] = motion.rates;
    let size = (p * p + q * q + r * r).sqrt();
    let (sin, cos) = sincos(0.5 * size * motion.end);
    let turn = Attitude::from_quaternion([cos, sin * p / size, sin * q / size, sin * r / size]);
    Some(motion.attitude * turn.ok()?)
}

/// RK4 in steps of a hundredth of the time in which the rates change by their own size.
fn by_first_step(motion: &Motion) -> Option<Attitude> {
    let size = |[a, b, c]: [f64; 3]| (a * a + b * b + c * c).sqrt();
    let ([i1, i2, i3], [p, q, r]) = (motion.moments, motion.rates);
    let slope = [
        (i2 - i3) / i1 * q * r,
        (i3 - i1) / i2 * r * p,
        (i1 - i2) / i3 * p * q,
    ];
    let step = 0.01 * size(motion.rates) / size(slope);
    // No step, no end.
    (step > 0.0).then(|| on_quaternion(motion, (motion.end / step).ceil() as u32))?
}

fn rows() -> kit::Result<Vec<Row>> {
    let mut rows = Vec::new();
    let rates = [0.3, 0.2, 1.0];

    let half = half_turn()?;
    let motion = Motion::free(MOMENTS, half, rates, 10.0);
    let naive = Naive {
        method: "quaternion from the trace of the matrix",
        error: by_trace(half).map_or(f64::NAN, |naive| naive.angle_to(&half)),
    };
    let words = [
        "started after half a turn",
        "the scalar part is zero, and is divided by",
    ];
    rows.push(motion.row(words, &By::FREE, naive)?);

    let [w, x, y, z] = half.quaternion();
    let other = Attitude::from_quaternion([-w, -x, -y, -z])?;
    let motion = Motion::free(MOMENTS, other, rates, 10.0);
    let [a, b, c, d] = motion.truth()?.quaternion();
    let [e, f, g, h] = Motion {
        attitude: half,
        ..motion
    }
    .truth()?
    .quaternion();
    let naive = Naive {
        method: "attitudes compared by their quaternions' difference",
        error: 2.0 * hypot(hypot(a - e, b - f), hypot(c - g, d - h)),
    };
    let words = [
        "started from the antipodal quaternion",
        "q and -q are one attitude",
    ];
    rows.push(motion.row(words, &By::FREE, naive)?);

    let [azimuth, rest] = AZIMUTH;
    let motion = Motion::free(MOMENTS, turned(azimuth)?, rates, 10.0);
    let same = Motion {
        attitude: turned(rest)?,
        ..motion
    };
    let by_turns =
        turned(azimuth - core::f64::consts::TAU * (azimuth / core::f64::consts::TAU).floor())?;
    let naive = Naive {
        method: "whole turns of 2 pi subtracted in doubles",
        error: by_turns.angle_to(&same.attitude),
    };
    let words = [
        "an azimuth of 1e32 rad",
        "of its turns doubles know sixteen digits, and thirty-one count",
    ];
    rows.push(motion.row_of_truth(words, &By::FREE, naive, motion.conditions()?, same.truth()?)?);

    let small = [3e-200, 2e-200, 1e-199];
    for (words, rates, end) in [
        (
            ["at rest", "the axis of no rotation is 0/0"],
            [0.0; 3],
            10.0,
        ),
        (
            [
                "rates of 1e-199 rad/s for 1e200 s",
                "their squares are zero in doubles",
            ],
            small,
            1e200,
        ),
        (
            [
                "rates of 1e8 rad/s for 1e-7 s",
                "a step of any fixed size is too long",
            ],
            [3e7, 2e7, 1e8],
            1e-7,
        ),
        (
            [
                "rates of 1e150 rad/s for 1e-149 s",
                "the square of an angular acceleration is infinite",
            ],
            [3e149, 2e149, 1e150],
            1e-149,
        ),
    ] {
        let motion = Motion::free(MOMENTS, half, rates, end);
        let (method, reached) = match rates[2] {
            1e150 => (
                "RK4, steps of 0.01 |omega|/|omega'|",
                by_first_step(&motion),
            ),
            1e8 => (
                "one step of 1e-6 s at most, axis by omega/|omega|",
                by_axis(&motion),
            ),
            _ => ("axis by omega/|omega|", by_axis(&motion)),
        };
        let error = motion.off(reached);
        rows.push(motion.row(words, &By::FREE, Naive { method, error })?);
    }

    // Beside a rate of 1 rad/s one that is all but nothing, and below that of any motion.
    let beside = Motion::free([1.0, 1.5, 2.0], half, [1e-200, 1.0, 0.0], 30.0);
    let words = [
        "1e-200 rad/s beside 1 rad/s",
        "its square is no double, and 1 - k^2 is made of it",
    ];
    let off = rates_by_landau(&beside)
        .into_iter()
        .zip(beside.true_rates()?);
    let naive = Naive {
        method: "Jacobi's functions with 1 - k^2 by subtraction",
        error: off.map(|(naive, truth)| naive - truth).sum::<f64>().abs(),
    };
    rows.push(beside.row(words, &By::FREE, naive)?);
    for (words, rate) in [
        (
            [
                "1e200 rad/s for 1e-200 s",
                "its square is infinite, and so is its energy",
            ],
            1e200,
        ),
        (
            [
                "1e-300 rad/s for 1e300 s",
                "its square is zero, and its momentum's",
            ],
            1e-300,
        ),
        (
            [
                "the least double, 5e-324 rad/s",
                "nothing smaller to round to",
            ],
            5e-324,
        ),
    ] {
        let end = 1.0 / f64::max(rate, 1e-300);
        let motion = Motion::free(MOMENTS, half, [0.0, 0.0, rate], end);
        let naive = Naive {
            method: "axis by omega/|omega|",
            error: motion.off(by_axis(&motion)),
        };
        rows.push(motion.row_of_condition(words, &By::FREE, naive, [3.0; 2])?);
    }
    Ok(rows)
}
