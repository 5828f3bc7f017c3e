//! Limits in which the answer is known without solving anything, numbers that show what the
//! notes' misprints would do, and one for the page's last section.

use super::*;

pub fn limits(report: &mut Report) -> Result<()> {
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
    let [beyond, ..] = fast::beyond_the_formulas(fast::SHAPE, PI / 3.0, 1e-6)?;
    limits! { report,
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
        "fast rotor, c/a = 1e-6: precession over c/sqrt(a)": 1.0 + beyond => 1.0, within 1e-5;
    }
}

/// d^2 U_eff / d theta^2.
fn curvature(top: &ReducedTop, theta: f64) -> f64 {
    let (a, b, c) = (top.a(), top.b(), top.c());
    let (s, u) = sincos(theta);
    let (p, q) = (b - u, 1.0 - b * u);
    a * (s * q + b * s * p) / (s * s * s) - 3.0 * a * p * q * u / (s * s * s * s) - c * u
}

pub fn claims(loops: &Motion, report: &mut Report) -> Result<()> {
    let (root, exact) = (loops.top.a().sqrt(), &loops.exact);
    // zeta' + cos(theta) as printed, against zeta' + phi' cos(theta) = 1/sqrt(a), over one nod.
    let printed = |theta: f64| {
        let u = cos(theta);
        1.0 / root - loops.top.phi_rate(theta) * u + u
    };
    let nod = times(0.0, exact.nutation_period(), 2000);
    let (least, most) = nod
        .map(|t| printed(exact.angles(t).theta))
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (x.min(least), x.max(most)));
    let ends = (printed(exact.theta_min()) - printed(exact.theta_max())).abs();
    // The weight's term of (4) with c, and with c as printed, smaller by (L_Z/L_z)^2 = b^2.
    let (b, c) = (1.2, 0.2);
    let torque = |c| Ok::<_, kit::Error>(ReducedTop::new(2.0, b, c)?.torque(1.0));
    let (none, correct, misprinted) = (torque(0.0)?, torque(c)?, torque(c / (b * b))?);
    let ratio = (correct - none) / (misprinted - none);
    // A hair below the cusps.
    let (top, energy) = (ReducedTop::new(2.0, 0.6, 0.2)?, -0.0801);
    let hair =
        Motion::with_energy("hair", top, energy, Start::ThetaMin)?.exact.precession_per_period();
    let nod = Nod::by_quadrature(&top, energy);
    claims! { report,
        /// advance of phi in one nod at E~ = -0.0801
        hair_precession: hair, "rad", "quadrature over one nod" => nod.precession, within 1e-12;
        /// swing of the printed zeta' + cos(theta) over L_z/I3
        erratum_e31_swing: (most - least) * root, "-", "its values at the turning points" => ends * root, within 1e-3;
        /// error of the weight in (4) with L_Z for L_z
        erratum_e32_percent: 100.0 * (b * b - 1.0), "%", "torques of (4) with either c" => 100.0 * (ratio - 1.0), within 0.5;
    }
}
