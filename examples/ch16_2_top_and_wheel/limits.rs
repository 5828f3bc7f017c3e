//! Limits in which the answer is known without solving anything, and what the page's tries come
//! to, so that a reader without Rust can compare.

use super::*;

impl Body {
    /// The steady precession when the axis is horizontal, rad/s.
    pub fn level_rate(&self) -> f64 {
        self.weight_moment() / (self.i3 * self.spin)
    }
}

pub fn limits(report: &mut Report) -> Result<()> {
    let exact = |body: Body| Ok::<_, kit::Error>(body.motion("")?.exact);
    let level = Body { precession: WHEEL.level_rate(), ..WHEEL };
    let heavier = Body { i1: 10.0 * WHEEL.i1, ..level };
    let fast = Body { spin: 1e4, ..WHEEL };
    let walk = exact(fast)?;
    let rate = walk.precession_per_period() / walk.nutation_period();
    // Hardly any spin: it swings like a pendulum about the lowest point.
    let hanging = Body { length: -WHEEL.length, theta: 0.01, spin: 1e-6, ..WHEEL };
    let small = 0.5 * TAU * (hanging.moment() / -hanging.weight_moment()).sqrt();
    let [_, beyond] = WHEEL.steady()?.after(())?;
    limits! { report,
        /// at 90 degrees the quadratic loses its first term
        "wheel level, started at m g l/L_z: its rate in rad/s":
            exact(level)?.phi_rate(0.3) => WHEEL.level_rate(), within 1e-12;
        /// I1 does not enter at 90 degrees
        "the same with ten times the I1: its rate in rad/s":
            exact(heavier)?.phi_rate(0.3) => WHEEL.level_rate(), within 1e-12;
        /// the mean torque turns L, and L is the spin
        "wheel released level at 10000 rad/s: rate over m g l/L_z":
            rate / fast.level_rate() => 1.0, within 1e-6;
        /// a pendulum of small swings
        "hanging wheel without spin: time from side to side in s":
            exact(hanging)?.nutation_period() => small, within 1e-4;
        /// steady precession takes this time for a turn
        "wheel that nothing brakes: rad beyond one turn after 2 pi/rate":
            beyond => 0.0, within 1e-9;
    }
}

pub fn tries(report: &mut Report) -> Result<()> {
    const ROOT: &str = "bisection of E~ - U_eff";
    const SUM: &str = "quadrature over one nod";
    let solved = |body: Body| -> Result<_> {
        let motion = body.motion("")?;
        let nod = Nod::by_quadrature(&motion.top, motion.energy);
        Ok((motion.exact, nod, motion.unit))
    };
    let (below, by_root, _) = solved(Body { theta: 1e-6, spin: 139.0, ..TOP })?;
    let (pushed, pushed_by_root, _) = solved(Body { precession: 0.6754, ..WHEEL })?;
    let (long, long_nod, unit) = solved(Body { length: 2.0 * WHEEL.length, ..WHEEL })?;
    let (fast, fast_nod, _) = solved(Body { spin: 2.0 * TOP.spin, ..TOP })?;
    let depth = |motion: &HeavyTop| motion.theta_max() - motion.theta_min();
    let other = |nod: &Nod| nod.theta_max - nod.theta_min;
    let rate = long.precession_per_period() / long.nutation_period();
    let by_sum = long_nod.precession / (long_nod.period * unit);
    claims! { report,
        /// top at 139 rad/s, 1e-6 rad from upright: greatest tilt
        try_below: below.theta_max(), "rad", ROOT => by_root.theta_max, within 1e-9;
        /// wheel pushed at 0.6754 rad/s: depth of its nods
        try_push: depth(&pushed), "rad", ROOT => other(&pushed_by_root), within 5e-8;
        /// wheel on twice the lever: depth of its nods
        try_lever_dip: depth(&long), "rad", ROOT => other(&long_nod), within 1e-11;
        /// wheel on twice the lever: mean rate of precession
        try_lever_rate: rate, "rad/s", SUM => by_sum, within 1e-10;
        /// top at twice the spin: depth of its nods
        try_fast_dip: depth(&fast), "rad", ROOT => other(&fast_nod), within 1e-11;
    }
}
