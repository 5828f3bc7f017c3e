//! Where the axis is vertical, and where two of three angles turn about one line.

use super::forms::Form;
use super::motions::{By, Motion};
use super::naive::{on_euler_angles, on_yaw_pitch_roll};
use super::table::{Family, Naive, Row};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles, YawPitchRoll};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::tan;

pub const FAMILY: Family = Family {
    key: "poles",
    title: "Pole passages and gimbal lock",
    cure: "a quaternion has no pole; the closed form divides nothing by the sine of the tilt",
    methods: &By::names(By::TOP),
    forms: &Form::NAMES,
    rows,
};

/// Moments across and along (kg m^2), and the torque of gravity (N m): asleep from 4 rad/s.
const TOP: [f64; 2] = [1.0, 0.5];
const PULL: f64 = 1.0;
const SPIN: f64 = 2.0;
const END: f64 = 20.0;
pub const STEPS: u32 = 20_000;

pub fn top(attitude: Attitude, rates: [f64; 3]) -> Motion {
    Motion::top(TOP, PULL, attitude, rates, END)
}

pub fn tilted(theta: f64) -> Result<Attitude> {
    Attitude::from_euler(EulerAngles {
        phi: 0.3,
        theta,
        zeta: 0.0,
    })
}

/// The rate across the node for which L_Z = L_z (the axis then meets the upper pole), or
/// L_Z = -L_z (the lower).
fn across(theta: f64, upper: bool) -> f64 {
    let spin = TOP[1] * SPIN / TOP[0];
    let half = tan(0.5 * theta);
    if upper { spin * half } else { -spin / half }
}

fn on_angles(motion: &Motion) -> Naive {
    Naive {
        method: "RK4 on Euler angles, 20 000 steps",
        error: motion.off(on_euler_angles(motion, STEPS)),
    }
}

/// Nose on the vertical: the pitch is pi/2, and yaw and roll are about one line.
pub fn locked() -> Result<Motion> {
    let locked = Attitude::from_yaw_pitch_roll(YawPitchRoll {
        yaw: 0.3,
        pitch: core::f64::consts::FRAC_PI_2,
        roll: 0.1,
    })?;
    Ok(top(locked, [0.4, 0.3, SPIN]))
}

fn rows() -> kit::Result<Vec<Row>> {
    let upright = Attitude::about_space_axis(SpaceVector::new(0.0, 0.0, 1.0), 0.7)?;
    let down = Attitude::from_quaternion([0.0, 1.0, 0.0, 0.0])?;
    let cases = [
        (
            [
                "exactly up, kicked",
                "precession and spin are one turn: no rate of either is defined",
            ],
            top(upright, [0.1, 0.0, SPIN]),
        ),
        (
            ["exactly down, kicked", "the same below; pi is no double"],
            top(down, [0.1, 0.2, SPIN]),
        ),
        (
            [
                "1e-8 rad off the top",
                "the angles turn a hundred million times faster than the body",
            ],
            top(tilted(1e-8)?, [0.1, 0.0, SPIN]),
        ),
        (
            ["1e-8 rad off the bottom", "the same below"],
            top(
                Attitude::from_quaternion([0.5e-8, 1.0, 0.0, 0.0])?,
                [0.1, 0.2, SPIN],
            ),
        ),
        (
            [
                "through the top in flight, b = 1",
                "the axis meets the pole and the angles jump by pi",
            ],
            top(tilted(1.0)?, [-1.5, across(1.0, true), SPIN]),
        ),
        (
            ["through the bottom in flight, b = -1", "the same below"],
            top(tilted(1.0)?, [0.5, across(1.0, false), SPIN]),
        ),
    ];
    let mut rows = Vec::new();
    for (words, motion) in cases {
        rows.push(motion.row(words, &By::TOP, on_angles(&motion))?);
    }

    let motion = locked()?;
    let naive = Naive {
        method: "RK4 on yaw, pitch, roll, 20 000 steps",
        error: motion.off(on_yaw_pitch_roll(&motion, STEPS)),
    };
    let words = ["pitch of pi/2", "gimbal lock: yaw and roll are one turn"];
    rows.push(motion.row(words, &By::TOP, naive)?);

    // What turns the vertical axis alone changes nothing of it: the condition is the spin's.
    let motion = top(upright, [0.0, 0.0, SPIN]);
    let words = [
        "exactly up below the critical spin",
        "any rounding is a kick, and grows as exp(0.87 t)",
    ];
    let turned = 2.0 + SPIN * END;
    rows.push(motion.row_of_condition(words, &By::TOP, on_angles(&motion), [turned; 2])?);
    Ok(rows)
}
