//! What the page's tries come to, so that a reader without Rust can compare.

use super::{Body, TOP, WHEEL};
use kit::{Report, Result};
use models::heavy_top::Nod;
use rotation_dynamics::exact::heavy_top::HeavyTop;

const ROOT: &str = "bisection of E~ - U_eff";
const SUM: &str = "quadrature over one nod";

pub fn add(report: &mut Report) -> Result<()> {
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
    kit::claims! { report,
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
