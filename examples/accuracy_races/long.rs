//! Closed form or steps: the free body for longer and longer.

use kit::{Report, Result, Table, claim};
use rotation_dynamics::accuracy::{Measure, Problem, Variables};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityGradient};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::FreeRotation;
use rotation_dynamics::integrators::{Dop853, GaussLegendre, Integrator, Method, Work};
use rotation_dynamics::math::{EPS, exp2, pow};
use rotation_dynamics::scene::Scene;

/// The free body of the chapter, for so many periods of its rates and a third of one: at
/// the whole number a symmetric method's error of the energy vanishes by luck.
fn free(periods: f64) -> Result<Problem<()>> {
    let attitude = Attitude::from_euler(EulerAngles { phi: 0.3, theta: 0.7, zeta: -0.4 })?;
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0)?;
    let rates = BodyVector::new(0.8, 0.4, 0.9 / (8.0 / 3.0));
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(attitude, rates)?;
    let exact = FreeBody::new(moments, attitude, rates)?;
    let end = (periods + 1.0 / 3.0) * exact.rate_period();
    let answer = State::new(exact.attitude(end), start.angular_momentum)?;
    let problem = Problem::new(scene, start, end, answer);
    Ok(problem.in_closed_form(move |t| exact.attitude(t)))
}

/// Adds the table, the limits, the strip and the card.
pub fn add(report: &mut Report, tolerance: f64) -> Result<()> {
    add_table(report)?;
    kit::limits! { report,
        /// two routes to one motion
        "1000 1/3 periods of the free body, Gauss-Legendre: off the closed form, in rad":
            across()? => 0.0, within 2e-11;
    }?;
    effects(report, tolerance)?;
    report.strip(&free(100.0)?, &[tolerance])
}

/// A block of steel that turns at nearly a radian a second for a thousand periods in a laboratory: what the model
/// leaves out, and what no method can better.
fn effects(report: &mut Report, tolerance: f64) -> Result<()> {
    let block = free(1000.0)?;
    let time = block.end;
    let rate = (block.scene.body().angular_velocity(&block.start)).norm();
    let (gravity, radius): (f64, f64) = (9.81, 6.371e6);
    let earth = 7.292e-5 / rate;
    let number = 3.0 * gravity / radius * (8.0 / 3.0 - 1.0) / 2.0 / (rate * rate);
    let down = SpaceVector::new(0.0, 0.0, -1.0);
    let gradient = GravityGradient::fixed((gravity / radius).sqrt(), down)?;
    let candidates = (block.scene).neglected_effects(&block.start, block.end, 1e-3)?;
    let predicted = candidates.predict(&gradient, number)?.predicted;
    let (seen, work) = astray(&block, gradient)?;
    // The start, rounded: two motions whose momenta are a part of 2^-24 apart.
    let (body, apart) = (block.scene.body(), exp2(-24.0));
    let end = |part: f64| -> Result<Attitude> {
        let start = State::new(block.start.attitude, block.start.angular_momentum * part)?;
        let rates = body.angular_velocity(&start);
        Ok(FreeBody::new(body.moments(), start.attitude, rates)?.attitude(block.end))
    };
    let rounded = end(1.0)?.angle_to(&end(1.0 + apart)?) * EPS / apart;
    kit::effect_card! { report, asked tolerance;
        "rotation of the Earth, laboratory axes":
            "Omega_E / omega" = earth, costs earth * rate * time, "rad";
        "gravity gradient of the Earth":
            "3 g (I3 - I1) / (R_E I2 omega^2)" = number, costs predicted, "rad, to first order",
            measured seen, within 1e-6, at_work work;
        "rounding of the numbers": "2^-53" = EPS, costs EPS * rate * time, "rad",
            measured rounded, included;
    }
}

/// How far the block gets from the closed form with this torque: the largest angle at a hundred
/// times, stepped from one to the next; and the work.
fn astray(block: &Problem<()>, torque: impl Effect + Clone) -> Result<(f64, Work)> {
    let (scene, method) = (block.scene.with(torque), Dop853::new(1e-12)?);
    let omega = block.scene.body().angular_velocity(&block.start);
    let free = FreeBody::new(block.scene.body().moments(), block.start.attitude, omega)?;
    let (mut state, mut work, mut most) = (block.start, Work::default(), 0.0_f64);
    for k in 0..100 {
        let [from, to] = [k, k + 1].map(|k| block.end * f64::from(k) / 100.0);
        let (there, cost) = method.advance(&scene, from, &state, to)?;
        (state, work) = (there, work + cost);
        most = most.max(free.attitude(to).angle_to(&state.attitude));
    }
    Ok((most, work))
}

/// Adds the evaluations for an error of 1e-9 rad, and what ten times the periods cost.
fn add_table(report: &mut Report) -> Result<()> {
    let columns = ["periods", "DOP853", "Gauss-Legendre 16", "closed form"];
    let mut table = Table::new("long", columns)?;
    let mut work = Vec::new();
    for periods in [10.0, 100.0, 1000.0] {
        // From coarse to fine, around the setting that delivers.
        let tolerances = (9..=14).map(|k| pow(10.0, -f64::from(k)));
        let steps = (9..=16).map(|k| (0.5 * f64::from(k) * periods).floor());
        let problem = free(periods)?;
        let least = [
            least(&problem, Method::Dop853, tolerances.collect())?,
            least(&problem, Method::GaussLegendre16, steps.collect())?,
        ];
        let [dop, gauss] = least.map(|work| work.map_or("-".into(), |w| format!("{w:.0}")));
        table.push([format!("{periods} 1/3"), dop, gauss, "one sample".into()])?;
        work.push(least);
    }
    report.add(table)?;
    let [dop, gauss] = [0, 1].map(|method| Some(work[1][method]? / work[0][method]?));
    let meaning = |name| format!("{name}: work for a hundred periods over that for ten");
    if let Some(ratio) = dop {
        report.add(
            claim("long_dop853", meaning("DOP853"), ratio, "-")
                .within(1.0)
                .against("error t^2 h^8 held: 10^(5/4)", pow(10.0, 1.25))
                .judged_within(0.1)
                .answer("closed form or steps"),
        )?;
    }
    if let Some(ratio) = gauss {
        report.add(
            claim("long_gauss", meaning("Gauss-Legendre"), ratio, "-")
                .within(1.0)
                .against("as many times the periods: shorter steps are nearly free", 10.0)
                .judged_within(0.1)
                .answer("closed form or steps"),
        )?;
    }
    Ok(())
}

fn least(problem: &Problem<()>, method: Method, settings: Vec<f64>) -> Result<Option<f64>> {
    let variables = Variables::best(method, &problem.scene);
    let sweep = problem.sweep(method, variables, settings);
    let curve = sweep.curve(Measure::Attitude, Work::torques)?;
    Ok(curve.least_work(1e-9).map(|point| point.work))
}

/// A thousand periods by Gauss-Legendre in 16 steps a period, off the closed form.
fn across() -> Result<f64> {
    let problem = free(1000.0)?;
    let gauss = GaussLegendre::new(16_005)?;
    let rotation = FreeRotation::new(&problem.scene);
    let (far, _) = gauss.advance(&rotation, 0.0, &problem.start, problem.end)?;
    Ok(problem.error(&far))
}
