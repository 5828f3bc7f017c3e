//! The sleeping top: upright, spinning, and stable only above a critical spin.

use super::{Body, TOP, critical_spin};
use rotation_dynamics::Result;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop};
use rotation_dynamics::integrators::{Dop853, Integrator};
use rotation_dynamics::math::{acos, hypot, log};
use rotation_dynamics::report::heavy_top::Newton;
use rotation_dynamics::report::{Claim, Oracle, Report};

use core::f64::consts::{LN_10, PI};

/// The body upright with `ratio` times the critical spin, kicked sideways at `kick` rad/s.
pub fn kicked(body: &Body, ratio: f64, kick: f64) -> Result<HeavyTop> {
    let spin = ratio * critical_spin(body);
    let upright = Body {
        theta: 0.0,
        spin,
        nutation: kick,
        ..*body
    };
    Ok(upright.motion("")?.exact)
}

/// The tilt an upright top reaches from a kick too small to matter: 2 acos(spin/critical).
pub fn reach(ratio: f64) -> f64 {
    if ratio < 1.0 { 2.0 * acos(ratio) } else { 0.0 }
}

/// The growth rate of a small tilt below the critical spin, 1/s.
fn growth_rate(body: &Body, ratio: f64) -> f64 {
    let stiffness = body.weight_moment() / body.moment();
    (stiffness * (1.0 - ratio * ratio)).sqrt()
}

/// The spin at which a kick of 1e-6 rad/s begins to tilt the top by more than 1e-3 rad.
fn critical_by_bisection(body: &Body) -> Result<f64> {
    let (mut falls, mut stands) = (0.5, 2.0);
    for _ in 0..60 {
        let middle = 0.5 * (falls + stands);
        if kicked(body, middle, 1e-6)?.theta_max() > 1e-3 {
            falls = middle;
        } else {
            stands = middle;
        }
    }
    Ok(stands * critical_spin(body))
}

/// Adds the claims about the sleeping top.
pub fn add(report: &mut Report) -> Result<()> {
    let critical = critical_spin(&TOP);
    report.add_claim(
        Claim::new(
            "critical_spin",
            "least spin at which the top sleeps",
            critical,
            "rad/s",
            1e-5 * critical,
            Oracle::new(
                "bisection: tilts after a kick or not",
                critical_by_bisection(&TOP)?,
            ),
        )?
        .slip(
            critical * (TOP.i1 / TOP.moment()).sqrt(),
            "I1 must be taken about the tip",
        ),
    )?;
    let ratio = 0.9;
    let fallen = kicked(&TOP, ratio, 1e-4)?;
    report.add_claim(Claim::new(
        "reach",
        "tilt reached at 0.9 of the critical spin",
        reach(ratio),
        "rad",
        1e-6,
        Oracle::new("closed form, kick of 1e-4 rad/s", fallen.theta_max()),
    )?)?;

    // Small tilts grow as sinh(rate t): measured between 1.2 and 1.6 s on the vectors.
    let vectors = Newton {
        i1: TOP.moment(),
        weight_moment: TOP.weight_moment(),
    };
    let start = [
        TOP.moment() * 1e-6,
        0.0,
        TOP.i3 * ratio * critical,
        0.0,
        0.0,
        1.0,
    ];
    let tilt = |t: f64| -> Result<f64> {
        let (end, _) = Dop853::new(1e-14)?.advance(&vectors, 0.0, &start, t)?;
        Ok(hypot(end[3], end[4]))
    };
    let rate = growth_rate(&TOP, ratio);
    let measured = log(tilt(1.6)? / tilt(1.2)?) / 0.4;
    report.add_claim(Claim::new(
        "growth",
        "growth of a small tilt at 0.9 of the critical spin",
        rate,
        "1/s",
        1e-4,
        Oracle::new("DOP853 on dL/dt = torque", measured),
    )?)?;
    // A kick ten times smaller delays the fall by ln(10)/rate, and the return likewise.
    let later =
        kicked(&TOP, ratio, 1e-6)?.nutation_period() - kicked(&TOP, ratio, 1e-5)?.nutation_period();
    report.add_claim(Claim::new(
        "delay",
        "how much later it falls after a kick ten times smaller",
        0.5 * later,
        "s",
        1e-6,
        Oracle::new("ln(10)/growth", LN_10 / rate),
    )?)?;

    // Above the critical spin a small kick makes a small, steady wobble.
    let above = 1.2;
    let wobble = kicked(&TOP, above, 1e-5)?.nutation_period();
    let frequency = (TOP.weight_moment() / TOP.moment() * (above * above - 1.0)).sqrt();
    report.add_claim(Claim::new(
        "wobble",
        "time from upright to upright at 1.2 of the critical spin",
        wobble,
        "s",
        1e-6,
        Oracle::new("small oscillation about the vertical", PI / frequency),
    )?)?;

    // The exact separatrix in the notes' numbers: b = 1, E~ = 0, c > a/4.
    let top = ReducedTop::new(1.0, 1.0, 0.5)?;
    let falls = HeavyTop::from_energy(
        top,
        0.0,
        rotation_dynamics::exact::heavy_top::Start::ThetaMax,
        0.0,
        0.0,
    )?;
    report.add_claim(Claim::new(
        "separatrix_height",
        "cos(theta) at t' = 2, b = 1, E~ = 0, a = 1, c = 1/2",
        falls.cos_theta(2.0),
        "-",
        1e-14,
        Oracle::new("tanh^2(t'/2)", {
            let h = rotation_dynamics::math::tanh(1.0);
            h * h
        }),
    )?)
}
