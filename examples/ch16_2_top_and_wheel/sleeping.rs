//! The sleeping top: upright, spinning, and stable only above a critical spin.

use super::*;
use core::f64::consts::LN_10;
use rotation_dynamics::exact::heavy_top::{ReducedTop, Start};
use rotation_dynamics::integrators::after;
use rotation_dynamics::math::tanh;

// ANCHOR: kicked
/// The body upright with `ratio` times the critical spin, kicked sideways at `kick` rad/s.
pub fn kicked(body: &Body, ratio: f64, kick: f64) -> Result<HeavyTop> {
    let upright = Body { theta: 0.0, spin: ratio * body.critical_spin(), nutation: kick, ..*body };
    Ok(upright.motion("")?.exact)
}
// ANCHOR_END: kicked

/// The tilt an upright top reaches from a kick too small to matter: 2 acos(spin/critical).
pub fn reach(ratio: f64) -> f64 {
    if ratio < 1.0 { 2.0 * acos(ratio) } else { 0.0 }
}

/// The growth of a small tilt between 1.2 and 1.6 s, where it is sinh(rate t), by a run in
/// vectors.
fn growth_in_vectors(ratio: f64) -> Result<f64> {
    let (i1, weight_moment) = (TOP.moment(), TOP.weight_moment());
    let spin = ratio * TOP.critical_spin();
    let start = [i1 * 1e-6, 0.0, TOP.i3 * spin, 0.0, 0.0, 1.0];
    let tilt = |t: f64| -> Result<f64> {
        let [_, _, _, x, y, _] = after(t, &Newton { i1, weight_moment }, &start, 1e-14)?;
        Ok(hypot(x, y))
    };
    Ok(log(tilt(1.6)? / tilt(1.2)?) / 0.4)
}

pub fn claims(report: &mut Report) -> Result<()> {
    let (critical, ratio, above) = (TOP.critical_spin(), 0.9, 1.2);
    let stiffness = TOP.weight_moment() / TOP.moment();
    let rate = (stiffness * (1.0 - ratio * ratio)).sqrt();
    let frequency = (stiffness * (above * above - 1.0)).sqrt();
    let period = |ratio, kick| Ok::<_, kit::Error>(kicked(&TOP, ratio, kick)?.nutation_period());
    // A smaller kick delays the fall, and the return likewise.
    let later = 0.5 * (period(ratio, 1e-6)? - period(ratio, 1e-5)?);
    // The exact separatrix in the notes' numbers: b = 1, E~ = 0, c > a/4.
    let unstable = ReducedTop::new(1.0, 1.0, 0.5)?;
    let falls = HeavyTop::from_energy(unstable, 0.0, Start::ThetaMax, 0.0, 0.0)?;
    // The spin at which a kick of 1e-6 rad/s begins to tilt the top by more than 1e-3 rad.
    let tilts = |ratio| Ok::<_, kit::Error>(kicked(&TOP, ratio, 1e-6)?.theta_max() > 1e-3);
    let [_, stands] = try_bisect([0.5, 2.0], 0.0, tilts)?;
    claims! { report,
        /// least spin at which the top sleeps
        critical_spin:
            critical, "rad/s", "bisection: tilts after a kick or not" => stands * critical, within 1e-5 * critical,
        in "The sleeping top":
            critical * (TOP.i1 / TOP.moment()).sqrt() => "I1 must be taken about the tip";
        /// tilt reached at 0.9 of the critical spin
        reach: reach(ratio), "rad", "closed form, kick of 1e-4 rad/s" => kicked(&TOP, ratio, 1e-4)?.theta_max(), within 1e-6,
        in "The sleeping top":
            acos(ratio) => "the cosine is that of half the angle";
        /// growth of a small tilt at 0.9 of the critical spin
        growth: rate, "1/s", "DOP853 on dL/dt = torque" => growth_in_vectors(ratio)?, within 1e-4,
        in "The sleeping top";
        /// how much later it falls after a kick ten times smaller
        delay: later, "s", "ln(10)/growth" => LN_10 / rate, within 1e-6, in "The sleeping top";
        /// time from upright to upright at 1.2 of the critical spin
        wobble: period(above, 1e-5)?, "s", "small oscillation about the vertical" => PI / frequency, within 1e-6;
        /// cos(theta) at t' = 2, b = 1, E~ = 0, a = 1, c = 1/2
        separatrix_height:
            falls.cos_theta(2.0), "-", "tanh^2(t'/2)" => tanh(1.0) * tanh(1.0), within 1e-14;
    }
}
