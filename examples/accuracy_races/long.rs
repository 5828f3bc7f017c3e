//! Closed form or steps: the free body for longer and longer.

use super::block::{EARTH, gradient, rounded, steel};
use super::*;
use rotation_dynamics::accuracy::{Measure, Problem, Resolution, Variables};
use rotation_dynamics::effects::Effect;
use rotation_dynamics::integrators::{Dop853, Integrator, Method, Work};
use rotation_dynamics::math::{EPS, exp2};

/// The free body for so many periods of its rates and a third of one: at the whole number a
/// symmetric method's error of the energy vanishes by luck. And its rate.
fn free(periods: f64) -> rotation_dynamics::Result<(Problem<()>, f64)> {
    steel(periods + 1.0 / 3.0)
}

/// Evaluations with which DOP853 and Gauss-Legendre deliver 1e-9 rad; NaN if they do not.
fn least(periods: f64) -> Result<[f64; 2]> {
    let (problem, _) = free(periods)?;
    let least = |method, settings: Vec<f64>| -> Result<f64> {
        let sweep = problem.sweep(method, Variables::best(method, &problem.scene), settings);
        let curve = sweep.curve(Measure::Attitude, Work::torques)?;
        Ok(curve.least_work(1e-9).map_or(f64::NAN, |point| point.work))
    };
    // From coarse to fine, around the setting that delivers.
    let tolerances = (9..=14).map(|k| pow(10.0, -f64::from(k))).collect();
    let steps = (9..=16).map(|k| (0.5 * f64::from(k) * periods).floor()).collect();
    Ok([least(Method::Dop853, tolerances)?, least(Method::GaussLegendre16, steps)?])
}

/// Adds the evaluations for an error of 1e-9 rad, and what ten times the periods cost.
pub fn work(_: &Parameters, report: &mut Report) -> Result<()> {
    let work = sampled([10.0, 100.0, 1000.0], |periods| Ok((periods, least(periods)?)))?;
    let columns = ["periods", "DOP853", "Gauss-Legendre 16", "closed form"];
    report.add(Table::of("long", columns, &work, |(periods, least)| {
        let [dop, gauss] = least.map(|work| match work.is_nan() {
            true => "-".to_owned(),
            false => format!("{work:.0}"),
        });
        Ok([format!("{periods} 1/3"), dop, gauss, "one sample".into()])
    })?)?;
    let [dop, gauss] = [0, 1].map(|method| work[1].1[method] / work[0].1[method]);
    claims! { report,
        /// DOP853: work for a hundred periods over that for ten
        long_dop853: dop, "-", "error t^2 h^8 held: 10^(5/4)" => pow(10.0, 1.25), within 1.0,
            judged 0.1, if dop.is_finite(), in "closed form or steps";
        /// Gauss-Legendre: work for a hundred periods over that for ten
        long_gauss: gauss, "-", "as many times the periods: shorter steps are nearly free" => 10.0,
            within 1.0, judged 0.1, if gauss.is_finite(), in "closed form or steps";
    }
}

/// A thousand periods by Gauss-Legendre in 16 steps a period.
pub fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    let (far, _) = free(1000.0)?;
    let (end, _) = far.run_as_usual(Method::GaussLegendre16, Resolution::Steps(16_005))?;
    limits! { report,
        /// two routes to one motion
        "1000 1/3 periods of the free body, Gauss-Legendre: off the closed form, in rad":
            far.error(&end) => 0.0, within 2e-11;
    }
}

/// What the model leaves out of a thousand periods of the block, and what no method can better.
pub fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (block, rate) = free(1000.0)?;
    let (gradient, number) = gradient(rate)?;
    let candidates = (block.scene).neglected_effects(&block.start, block.end, 1e-3)?;
    let predicted = candidates.predict(&gradient, number)?.predicted;
    let (seen, work) = astray(&block, gradient)?;
    effect_card! { report, asked p.tolerance;
        "rotation of the Earth, laboratory axes":
            "Omega_E / omega" = EARTH / rate, costs EARTH / rate * rate * block.end, "rad";
        "gravity gradient of the Earth":
            "3 g (I3 - I1) / (R_E I2 omega^2)" = number, costs predicted, "rad, to first order",
            measured seen, within 1e-6, at_work work;
        "rounding of the numbers": "2^-53" = EPS, costs EPS * rate * block.end, "rad",
            measured rounded(&block, exp2(-24.0))?, included;
    }?;
    report.strip(&free(100.0)?.0, &[p.tolerance])
}

/// How far the block gets from the closed form with this torque: the largest angle at a hundred
/// times, stepped from one to the next; and the work.
fn astray(block: &Problem<()>, torque: impl Effect + Clone) -> Result<(f64, Work)> {
    let (scene, method) = (block.scene.with(torque), Dop853::new(1e-12)?);
    let free = block.scene.exact(&block.start)?;
    let (mut state, mut work, mut most) = (block.start, Work::default(), 0.0_f64);
    for k in 0..100 {
        let [from, to] = [k, k + 1].map(|k| block.end * f64::from(k) / 100.0);
        let (there, cost) = method.advance(&scene, from, &state, to)?;
        (state, work) = (there, work + cost);
        most = most.max(free.attitude(to).angle_to(&state.attitude));
    }
    Ok((most, work))
}
