//! What the page's tries come to, so that a reader without Rust can compare.

use super::{Body, TOP, WHEEL};
use rotation_dynamics::Result;
use rotation_dynamics::report::heavy_top::Nod;
use rotation_dynamics::report::{Report, claim};

const ROOT: &str = "bisection of E~ - U_eff";
const SUM: &str = "quadrature over one nod";

pub fn add(report: &mut Report) -> Result<()> {
    let solved = |body: Body| -> Result<_> {
        let motion = body.motion("")?;
        let nod = Nod::by_quadrature(&motion.top, motion.energy);
        Ok((motion.exact, nod, motion.unit))
    };
    let (below, by_root, _) = solved(Body {
        theta: 1e-6,
        spin: 139.0,
        ..TOP
    })?;
    let (pushed, pushed_by_root, _) = solved(Body {
        precession: 0.6754,
        ..WHEEL
    })?;
    let (long, long_nod, unit) = solved(Body {
        length: 2.0 * WHEEL.length,
        ..WHEEL
    })?;
    let (fast, fast_nod, _) = solved(Body {
        spin: 2.0 * TOP.spin,
        ..TOP
    })?;
    report.add(vec![
        claim(
            "try_below",
            "top at 139 rad/s, 1e-6 rad from upright: greatest tilt",
            below.theta_max(),
            "rad",
        )
        .within(1e-9)
        .against(ROOT, by_root.theta_max),
        claim(
            "try_push",
            "wheel pushed at 0.6754 rad/s: depth of its nods",
            pushed.theta_max() - pushed.theta_min(),
            "rad",
        )
        .within(5e-8)
        .against(ROOT, pushed_by_root.theta_max - pushed_by_root.theta_min),
        claim(
            "try_lever_dip",
            "wheel on twice the lever: depth of its nods",
            long.theta_max() - long.theta_min(),
            "rad",
        )
        .within(1e-11)
        .against(ROOT, long_nod.theta_max - long_nod.theta_min),
        claim(
            "try_lever_rate",
            "wheel on twice the lever: mean rate of precession",
            long.precession_per_period() / long.nutation_period(),
            "rad/s",
        )
        .within(1e-10)
        .against(SUM, long_nod.precession / (long_nod.period * unit)),
        claim(
            "try_fast_dip",
            "top at twice the spin: depth of its nods",
            fast.theta_max() - fast.theta_min(),
            "rad",
        )
        .within(1e-11)
        .against(ROOT, fast_nod.theta_max - fast_nod.theta_min),
    ])
}
