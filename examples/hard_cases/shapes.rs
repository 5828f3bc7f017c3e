//! Bodies whose moments are equal, nearly equal, or as unequal as can be.

use super::forms::Form;
use super::motions::{By, Motion};
use super::naive::{by_momentum, jittered};
use super::table::{Family, Naive, Row};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles};

pub const FAMILY: Family = Family {
    key: "shapes",
    title: "Nearly symmetric bodies, needle, disc and sphere",
    cure: "the direct differences of moments stand in every formula, and equal ones have a formula of their own",
    methods: &By::names(By::FREE),
    forms: &Form::NAMES,
    rows,
};

const END: f64 = 30.0;
const RATES: [f64; 3] = [0.8, 0.4, 0.9];

pub fn free(moments: [f64; 3]) -> Result<Motion> {
    let attitude = Attitude::from_euler(EulerAngles {
        phi: 0.3,
        theta: 0.8,
        zeta: 0.2,
    })?;
    Ok(Motion::free(moments, attitude, RATES, END))
}

fn rows() -> kit::Result<Vec<Row>> {
    let mut rows = Vec::new();
    for (words, moments) in [
        (
            ["I2/I1 - 1 = 0", "formulas for three moments are 0/0"],
            [1.0, 1.0, 1.7],
        ),
        (
            [
                "I2/I1 - 1 = 1e-15",
                "all that tells them apart is four last bits",
            ],
            [1.0, 1.0 + 1e-15, 1.7],
        ),
        (
            ["I2/I1 - 1 = 1e-10", "neither symmetric nor far from it"],
            [1.0, 1.0 + 1e-10, 1.7],
        ),
        (
            [
                "all but a sphere",
                "every difference of moments is a billionth",
            ],
            [1.0, 1.0 + 1e-9, 1.0 - 1e-9],
        ),
        (
            ["sphere", "nothing tells one axis from another"],
            [2.0, 2.0, 2.0],
        ),
    ] {
        let motion = free(moments)?;
        rows.push(motion.row(words, &By::FREE, jitter(&motion))?);
    }
    // A disc: the larger moment is the sum of the others, or a rounding more.
    let [a, b, c] = [0.7, 0.1, 0.8];
    let motion = free([a, b, c])?;
    let naive = Naive {
        method: "triangle inequality to the last bit",
        error: motion.off((c <= a + b).then(|| motion.truth()).transpose()?),
    };
    let words = [
        "disc, I3 = I1 + I2 and a rounding",
        "0.7 + 0.1 is less than 0.8 in doubles",
    ];
    rows.push(motion.row(words, &By::FREE, naive)?);
    // A disc in round numbers, and needles: the spin about the thin axis is not in L.
    let motion = free([1.0, 2.0, 3.0])?;
    let words = [
        "disc, I3 = I1 + I2 exactly",
        "one of the differences of moments is the third moment",
    ];
    rows.push(motion.row(words, &By::FREE, jitter(&motion))?);
    for (words, moments) in [
        (
            [
                "needle, I3/I1 = 1e-9",
                "a rounding of L across the needle is a spin about it",
            ],
            [1.0, 1.0, 1e-9],
        ),
        (
            ["needle of three moments", "I1 - I2 is half of I3"],
            [1.0, 1.0 + 5e-10, 1e-9],
        ),
    ] {
        let motion = Motion {
            end: 5.0,
            ..free(moments)?
        };
        let naive = Naive {
            method: "RK4 on the quaternion, rates from L, 5000 steps",
            error: motion.off(by_momentum(&motion, 5000)),
        };
        rows.push(motion.row(words, &By::FREE, naive)?);
    }
    Ok(rows)
}

fn jitter(motion: &Motion) -> Naive {
    Naive {
        method: "a moment changed by 1e-9, so that nothing is 0/0",
        error: motion.off(jittered(motion)),
    }
}
