//! Limits in which the answer is known without solving anything, and numbers that show
//! what the notes' misprints would do.

use super::fast::{self, SHAPE};
use kit::{Report, Result, claim, sampled, times};
use models::heavy_top::Motion;
use rotation_dynamics::Error;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::math::sincos;

use core::f64::consts::{PI, TAU};

pub fn add(report: &mut Report, loops: &Motion) -> Result<()> {
    add_slips(report, loops)?;
    let from = |a, b, c, energy, start| {
        HeavyTop::from_energy(ReducedTop::new(a, b, c)?, energy, start, 0.0, 0.0)
    };
    let steep = ReducedTop::new(2.0, 1.2, 0.2)?;
    let (theta, bottom) = steep.minimum();
    let free = from(2.0, 1.2, 0.0, 0.55, Start::ThetaMin)?;
    let small = from(2.0, 1.2, 0.2, bottom + 1e-9, Start::ThetaMin)?;
    let cusps = from(2.0, 0.6, 0.2, -0.08, Start::ThetaMin)?;
    let standing = from(1.25, 0.6, 0.3, 0.1, Start::ThetaMin)?;
    // U_eff is counted from theta = 0, so upside down the energy shifts by 2 c.
    let hanging = from(1.25, -0.6, -0.3, 0.1 + 0.6, Start::ThetaMax)?;
    let (ratio, fast) = (1e-6, fast::released(PI / 3.0, 1e-6)?);
    let walk = fast.precession_per_period() / fast.nutation_period();
    kit::limits! { report,
        /// the axis circles L at L/I1
        "no weight: time of one nod":
            free.nutation_period() => TAU / (2.0_f64 + 2.0 * 0.55).sqrt(), within 1e-14;
        /// a small swing in a parabola of curvature U''
        "E~ just above U_min: time of one nod":
            small.nutation_period() => TAU / curvature(&steep, theta).sqrt(), within 1e-8;
        /// sin^2(theta) sin^2(zeta) = (b - cos(theta))/c
        "cusps of a thin disc, a = 2: advance of zeta in one nod":
            cusps.spin_per_period() => PI, within 1e-14;
        /// theta to pi - theta, b to -b, c to -c turns phi round
        "everything upside down: advance of phi in one nod":
            hanging.precession_per_period() => -standing.precession_per_period(), within 1e-13;
        /// the mean torque turns L, and L is the spin
        "fast rotor, c/a = 1e-6: precession over c/sqrt(a)":
            walk / (ratio * SHAPE.sqrt()) => 1.0, within 1e-5;
    }
}

fn add_slips(report: &mut Report, loops: &Motion) -> Result<()> {
    let a = loops.top.a();
    // zeta' + cos(theta) as printed, against zeta' + phi' cos(theta) = 1/sqrt(a), over one nod.
    let printed = |theta: f64| {
        let u = sincos(theta).1;
        1.0 / a.sqrt() - loops.top.phi_rate(theta) * u + u
    };
    let exact = &loops.exact;
    let nod = times(0.0, exact.nutation_period(), 2000);
    let values = sampled(nod, |t| Ok(printed(exact.angles(t).theta)))?;
    let (least, most) =
        values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), x| (x.min(l), x.max(m)));
    let ends = (printed(exact.theta_min()) - printed(exact.theta_max())).abs();
    report.add(
        claim(
            "erratum_e31_swing",
            "swing of the printed zeta' + cos(theta) over L_z/I3",
            (most - least) * a.sqrt(),
            "-",
        )
        .within(1e-3)
        .against("its values at the turning points", ends * a.sqrt()),
    )?;
    // The weight's term of (4) with c, and with c as printed, smaller by (L_Z/L_z)^2 = b^2.
    let (b, c, theta) = (1.2, 0.2, 1.0);
    let torque = |c| Ok::<_, Error>(ReducedTop::new(2.0, b, c)?.torque(theta));
    let (none, correct, misprinted) = (torque(0.0)?, torque(c)?, torque(c / (b * b))?);
    let ratio = (correct - none) / (misprinted - none);
    report.add(
        claim(
            "erratum_e32_percent",
            "error of the weight in (4) with L_Z for L_z",
            100.0 * (b * b - 1.0),
            "%",
        )
        .within(0.5)
        .against("torques of (4) with either c", 100.0 * (ratio - 1.0)),
    )
}

/// d^2 U_eff / d theta^2.
fn curvature(top: &ReducedTop, theta: f64) -> f64 {
    let (a, b, c) = (top.a(), top.b(), top.c());
    let (s, u) = sincos(theta);
    let (p, q) = (b - u, 1.0 - b * u);
    a * (s * q + b * s * p) / (s * s * s) - 3.0 * a * p * q * u / (s * s * s * s) - c * u
}
