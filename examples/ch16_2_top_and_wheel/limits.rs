//! Limits in which the answer is known without solving anything.

use super::{Body, WHEEL};
use kit::{Report, Result};

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
    let level = Body { precession: WHEEL.level_rate(), ..WHEEL };
    let heavier = Body { i1: 10.0 * WHEEL.i1, ..level };
    let at_once = |body: Body| -> Result<f64> { Ok(body.motion("")?.exact.phi_rate(0.3)) };
    let fast = Body { spin: 1e4, ..WHEEL };
    // Hardly any spin: it swings like a pendulum about the lowest point.
    let hanging = Body { length: -WHEEL.length, theta: 0.01, spin: 1e-6, ..WHEEL };
    let swing = hanging.motion("")?.exact.nutation_period();
    let small = 0.5 * TAU * (hanging.moment() / -hanging.weight_moment()).sqrt();
    let [_, beyond] = WHEEL.steady()?.after(())?;
    kit::limits! { report,
        /// at 90 degrees the quadratic loses its first term
        "wheel level, started at m g l/L_z: its rate in rad/s":
            at_once(level)? => WHEEL.level_rate(), within 1e-12;
        /// I1 does not enter at 90 degrees
        "the same with ten times the I1: its rate in rad/s":
            at_once(heavier)? => WHEEL.level_rate(), within 1e-12;
        /// the mean torque turns L, and L is the spin
        "wheel released level at 10000 rad/s: rate over m g l/L_z":
            rate(fast)? / fast.level_rate() => 1.0, within 1e-6;
        /// a pendulum of small swings
        "hanging wheel without spin: time from side to side in s": swing => small, within 1e-4;
        /// steady precession takes this time for a turn
        "wheel that nothing brakes: rad beyond one turn after 2 pi/rate":
            beyond => 0.0, within 1e-9;
    }
}
