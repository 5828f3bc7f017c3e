//! Limits in which the answer is known without solving anything, and what
//! friction makes of the motion in the end.

use super::Equations;
use rotation_dynamics::Result;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::integrators::{Dop853, Event, Solution};
use rotation_dynamics::math::{acos, log, sincos};
use rotation_dynamics::report::{Claim, Limit, Oracle, Report};

use core::f64::consts::{PI, TAU};

/// Torque of the bearing of the line of nodes over dtheta/dt', in the damped run.
pub const FRICTION: f64 = 0.15;

pub fn add(report: &mut Report) -> Result<()> {
    add_slips(report)?;
    add_damped(report)?;
    add_fast(report)?;
    let mut add = |limit: &str, because: &str, must: f64, gives: f64, within: f64| -> Result<()> {
        report.add_limit(Limit::new(limit, because, must, gives, within)?);
        Ok(())
    };

    let free = HeavyTop::from_energy(
        ReducedTop::new(2.0, 1.2, 0.0)?,
        0.55,
        Start::ThetaMin,
        0.0,
        0.0,
    )?;
    add(
        "no weight: time of one nod",
        "the axis circles L at L/I1",
        TAU / (2.0_f64 + 2.0 * 0.55).sqrt(),
        free.nutation_period(),
        1e-14,
    )?;

    let top = ReducedTop::new(2.0, 1.2, 0.2)?;
    let (theta, bottom) = top.minimum();
    let small = HeavyTop::from_energy(top, bottom + 1e-9, Start::ThetaMin, 0.0, 0.0)?;
    add(
        "E~ just above U_min: time of one nod",
        "a small swing in a parabola of curvature U''",
        TAU / curvature(&top, theta).sqrt(),
        small.nutation_period(),
        1e-8,
    )?;

    let cusps = HeavyTop::from_energy(
        ReducedTop::new(2.0, 0.6, 0.2)?,
        -0.08,
        Start::ThetaMin,
        0.0,
        0.0,
    )?;
    add(
        "cusps of a thin disc, a = 2: advance of zeta in one nod",
        "sin^2(theta) sin^2(zeta) = (b - cos(theta))/c",
        PI,
        cusps.spin_per_period(),
        1e-14,
    )?;

    let standing = HeavyTop::from_energy(
        ReducedTop::new(1.25, 0.6, 0.3)?,
        0.1,
        Start::ThetaMin,
        0.0,
        0.0,
    )?;
    // U_eff is counted from theta = 0, so upside down the energy shifts by 2 c.
    let hanging = HeavyTop::from_energy(
        ReducedTop::new(1.25, -0.6, -0.3)?,
        0.1 + 0.6,
        Start::ThetaMax,
        0.0,
        0.0,
    )?;
    add(
        "everything upside down: advance of phi in one nod",
        "theta to pi - theta, b to -b, c to -c turns phi round",
        -standing.precession_per_period(),
        hanging.precession_per_period(),
        1e-13,
    )?;

    let (ratio, fast) = (1e-6, released(1e-6)?);
    add(
        "fast rotor, c/a = 1e-6: precession over c/sqrt(a)",
        "the mean torque turns L, and L is the spin",
        1.0,
        fast.precession_per_period() / fast.nutation_period() / (ratio * FAST_SHAPE.sqrt()),
        1e-5,
    )
}

/// Numbers that show what the notes' misprints would do.
fn add_slips(report: &mut Report) -> Result<()> {
    let loops = &super::of_the_notes()?[2];
    // zeta' + cos(theta) as printed, against zeta' + phi' cos(theta) = 1/sqrt(a), over one nod.
    let printed = |theta: f64| {
        let (s, u) = sincos(theta);
        let precession = loops.top.a().sqrt() * (loops.top.b() - u) / (s * s);
        1.0 / loops.top.a().sqrt() - precession * u + u
    };
    let mut range = (f64::INFINITY, f64::NEG_INFINITY);
    for k in 0..=2000 {
        let t = loops.exact.nutation_period() * f64::from(k) / 2000.0;
        let value = printed(loops.exact.angles(t).theta);
        range = (range.0.min(value), range.1.max(value));
    }
    let ends = (printed(loops.exact.theta_min()) - printed(loops.exact.theta_max())).abs();
    let size = loops.top.a().sqrt();
    report.add_claim(Claim::new(
        "erratum_e31_swing",
        "swing of the printed zeta' + cos(theta) over L_z/I3",
        (range.1 - range.0) * size,
        "-",
        1e-3,
        Oracle::new("its values at the turning points", ends * size),
    )?)?;
    let b: f64 = 1.2;
    report.add_claim(Claim::new(
        "erratum_e32_percent",
        "error of the weight in (4) with L_Z for L_z",
        100.0 * (b * b - 1.0),
        "%",
        0.5,
        Oracle::new("printed c over correct c", 100.0 * (1.44 - 1.0)),
    )?)
}

/// d^2 U_eff / d theta^2.
fn curvature(top: &ReducedTop, theta: f64) -> f64 {
    let (a, b, c) = (top.a(), top.b(), top.c());
    let (s, u) = sincos(theta);
    let (p, q) = (b - u, 1.0 - b * u);
    a * (s * q + b * s * p) / (s * s * s) - 3.0 * a * p * q * u / (s * s * s * s) - c * u
}

// ANCHOR: damped
/// The cusped motion with friction in the bearing of the line of nodes.
pub fn damped(end: f64) -> Result<Solution<4>> {
    let equations = Equations {
        a: 2.0,
        b: 0.6,
        c: 0.2,
        friction: FRICTION,
    };
    let start = [acos(equations.b), 0.0, 0.0, 0.0]; // released at rest
    let lowest = Event::falling("lowest", |_t, y: &[f64; 4]| y[1]);
    Dop853::new(1e-13)?.solve(&equations, 0.0, &start, end, &[lowest])
}
// ANCHOR_END: damped

fn add_damped(report: &mut Report) -> Result<()> {
    let top = ReducedTop::new(2.0, 0.6, 0.2)?;
    let (bottom, _) = top.minimum();
    let solution = damped(400.0)?;
    let last = solution.end_state();
    report.add_claim(Claim::new(
        "damped_theta",
        "tilt at which friction leaves the axis",
        bottom,
        "rad",
        1e-9,
        Oracle::new("DOP853 with friction", last[0]),
    )?)?;
    report.add_claim(Claim::new(
        "damped_sag",
        "how much lower that is than the start",
        bottom - acos(0.6),
        "rad",
        1e-9,
        Oracle::new("DOP853 with friction", last[0] - acos(0.6)),
    )?)?;
    let (s, u) = sincos(bottom);
    let rate = 2.0 * 0.2 / (2.0_f64.sqrt() + (2.0 - 4.0 * 0.2 * u).sqrt());
    report.add_claim(Claim::new(
        "damped_precession",
        "dphi/dt' in the end",
        rate,
        "-",
        1e-9,
        Oracle::new(
            "DOP853 with friction",
            2.0_f64.sqrt() * (0.6 - sincos(last[0]).1) / (s * s),
        ),
    )?)?;
    // Depths of the nods below the final tilt, at the located lowest points.
    let depths: Vec<(f64, f64)> = solution
        .events()
        .iter()
        .map(|e| (e.t, e.state[0] - bottom))
        .filter(|(t, _)| (20.0..120.0).contains(t))
        .collect();
    let (first, final_) = (depths[0], depths[depths.len() - 1]);
    let decay = log(first.1 / final_.1) / (final_.0 - first.0);
    report.add_claim(Claim::new(
        "damped_decay",
        "rate at which the nods die, per t'",
        decay,
        "-",
        1e-4,
        Oracle::new("half the friction over I1", 0.5 * FRICTION),
    )?)
}

/// Shape and tilt of the fast rotor of the limits: those of the reference gyroscope.
pub const FAST_SHAPE: f64 = 9e-4 / 5.45e-3;

/// A rotor released at rest at 60 degrees, with c/a = `ratio`.
pub fn released(ratio: f64) -> Result<HeavyTop> {
    let theta = PI / 3.0;
    let top = ReducedTop::new(FAST_SHAPE, sincos(theta).1, ratio * FAST_SHAPE)?;
    HeavyTop::from_angles(top, theta, 0.0, 0.0, 0.0)
}

/// Precession, frequency of the nods and dip over their leading orders, minus 1.
pub fn beyond_leading_order(ratio: f64) -> Result<[f64; 3]> {
    let (exact, a) = (released(ratio)?, FAST_SHAPE);
    let period = exact.nutation_period();
    Ok([
        exact.precession_per_period() / period / (ratio * a.sqrt()) - 1.0,
        TAU / period / a.sqrt() - 1.0,
        (exact.theta_max() - exact.theta_min()) / (2.0 * ratio * sincos(PI / 3.0).0) - 1.0,
    ])
}

/// The leading-order formulas miss by an error proportional to c/a.
fn add_fast(report: &mut Report) -> Result<()> {
    let ratios = [1e-5, 2e-5, 5e-5, 1e-4];
    let mut rows = Vec::new();
    for ratio in ratios {
        rows.push(beyond_leading_order(ratio)?);
    }
    let names = [
        (
            "fast_precession_order",
            "order in c/a of the error of m g l/L_z",
        ),
        (
            "fast_frequency_order",
            "order in c/a of the error of L_z/I1",
        ),
        (
            "fast_dip_order",
            "order in c/a of the error of 2 (c/a) sin(theta)",
        ),
    ];
    for (column, (key, meaning)) in names.into_iter().enumerate() {
        let points: Vec<(f64, f64)> = ratios
            .iter()
            .zip(&rows)
            .map(|(&x, row)| (log(x), log(row[column].abs())))
            .collect();
        report.add_claim(Claim::new(
            key,
            meaning,
            slope(&points),
            "-",
            1e-3,
            Oracle::new("expansion in c/a", 1.0),
        )?)?;
    }
    Ok(())
}

/// Slope of the straight line of least squares through the points.
fn slope(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    let (mx, my) = points
        .iter()
        .fold((0.0, 0.0), |(x, y), p| (x + p.0 / n, y + p.1 / n));
    let (mut xy, mut xx) = (0.0, 0.0);
    for (x, y) in points {
        xy += (x - mx) * (y - my);
        xx += (x - mx) * (x - mx);
    }
    xy / xx
}
