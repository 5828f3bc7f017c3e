//! Limits in which the answer is known without solving anything.

use super::slowing::lead;
use super::{Body, WHEEL};
use rotation_dynamics::Result;
use rotation_dynamics::report::{Report, limit};

use core::f64::consts::TAU;

impl Body {
    /// The steady precession when the axis is horizontal, rad/s.
    pub fn level_rate(&self) -> f64 {
        self.weight_moment() / (self.i3 * self.spin)
    }
}

pub fn add(report: &mut Report) -> Result<()> {
    let rate = |body: Body| -> Result<f64> {
        let motion = body.motion("")?.exact;
        Ok(motion.precession_per_period() / motion.nutation_period())
    };
    let level = Body {
        precession: WHEEL.level_rate(),
        ..WHEEL
    };
    let heavier = Body {
        i1: 10.0 * WHEEL.i1,
        ..level
    };
    let at_once = |body: Body| -> Result<f64> { Ok(body.motion("")?.exact.phi_rate(0.3)) };
    let fast = Body { spin: 1e4, ..WHEEL };
    // Hardly any spin: it swings like a pendulum about the lowest point.
    let hanging = Body {
        length: -WHEEL.length,
        theta: 0.01,
        spin: 1e-6,
        ..WHEEL
    };
    let swing = hanging.motion("")?.exact.nutation_period();
    let small = 0.5 * TAU * (hanging.moment() / -hanging.weight_moment()).sqrt();
    let unbraked = lead(&WHEEL, 0.0)?;
    report.add(vec![
        limit(
            "wheel level, started at m g l/L_z: its rate in rad/s",
            WHEEL.level_rate(),
            at_once(level)?,
        )
        .within(1e-12)
        .because("at 90 degrees the quadratic loses its first term"),
        limit(
            "the same with ten times the I1: its rate in rad/s",
            WHEEL.level_rate(),
            at_once(heavier)?,
        )
        .within(1e-12)
        .because("I1 does not enter at 90 degrees"),
        limit(
            "wheel released level at 10000 rad/s: rate over m g l/L_z",
            1.0,
            rate(fast)? / fast.level_rate(),
        )
        .within(1e-6)
        .because("the mean torque turns L, and L is the spin"),
        limit(
            "hanging wheel without spin: time from side to side in s",
            small,
            swing,
        )
        .within(1e-4)
        .because("a pendulum of small swings"),
        limit(
            "wheel that nothing brakes: rad beyond one turn after 2 pi/rate",
            0.0,
            unbraked.in_vectors,
        )
        .within(1e-9)
        .because("steady precession takes this time for a turn"),
    ])
}
