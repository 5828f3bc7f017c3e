//! Limits in which the error of a method is known, and what the errors of physics are.

use super::motions::{free_problem, generic_rates};
use kit::{CardLine, Report, Result};
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityGradient;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::FreeRotation;
use rotation_dynamics::integrators::{GaussLegendre, Integrator, Rk4, Scheme, Splitting};
use rotation_dynamics::math::{EPS, exp2, pow};
use rotation_dynamics::scene::Scene;

use core::f64::consts::TAU;

/// Adds the limits and the card of effects.
pub fn add(report: &mut Report) -> Result<()> {
    kit::limits! { report,
        /// the step's phase lacks (angle/2)^5/120, and an attitude turns twice the phase
        "steady spin, RK4: error over (angle turned) (angle a step)^4":
            steady_error()? => 1.0 / 1920.0, within 1e-6;
        /// the flow between kicks is exact
        "no torque, symmetric body, one step of Strang for 100 s: error in rad":
            free_splitting()? => 0.0, within 1e-13;
        /// a symmetric method run backwards undoes its own error
        "10 periods there and back, Gauss-Legendre: off the start, in rad":
            back()? => 0.0, within 1e-12;
    }?;
    effects(report)
}

/// RK4 on a body that spins steadily, 100 steps a turn for ten turns.
fn steady_error() -> Result<f64> {
    let scene = Scene::new(RigidBody::new(PrincipalMoments::new(1.0, 1.0, 1.0)?));
    let start = scene
        .body()
        .state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 1.0))?;
    let (turns, steps) = (10.0, 1000.0);
    let (end, _) = Rk4::new(1000)?.advance(&scene, 0.0, &start, turns * TAU)?;
    let exact = Attitude::IDENTITY;
    Ok(exact.angle_to(&end.attitude) / (turns * TAU) / pow(turns * TAU / steps, 4.0))
}

fn free_splitting() -> Result<f64> {
    let moments = PrincipalMoments::symmetric(1.0, 1.5)?;
    let rates = BodyVector::new(0.3, 0.2, 0.7);
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(Attitude::IDENTITY, rates)?;
    let (end, _) = Splitting::new(Scheme::STRANG, 1)?.advance(&scene, 0.0, &start, 100.0)?;
    let exact = FreeBody::new(moments, Attitude::IDENTITY, rates)?.attitude(100.0);
    Ok(exact.angle_to(&end.attitude))
}

/// The free body by Gauss-Legendre in 12 steps a period, ten periods and back.
fn back() -> Result<f64> {
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0)?;
    let rates = BodyVector::new(0.8, 0.4, 0.3375);
    let end = 10.0 * FreeBody::new(moments, Attitude::IDENTITY, rates)?.rate_period();
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(Attitude::IDENTITY, rates)?;
    let rotation = FreeRotation::new(&scene);
    let gauss = GaussLegendre::new(120)?;
    let (there, _) = gauss.advance(&rotation, 0.0, &start, end)?;
    let (back, _) = gauss.advance(&rotation, end, &there, 0.0)?;
    Ok(start.attitude.angle_to(&back.attitude))
}

/// What a real free body does that the model does not: a block of steel of a decimetre,
/// turning at nearly a radian a second for ten periods in a laboratory. Beside it the one error that no
/// method is rid of.
fn effects(report: &mut Report) -> Result<()> {
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0)?;
    let rates = generic_rates(moments);
    let block = free_problem(moments, rates, 10.0)?;
    let (rate, size) = (rates.norm(), 0.1);
    let turned = rate * block.end;
    let (gravity, radius): (f64, f64) = (9.81, 6.371e6);
    let earth = 7.292e-5 / rate;
    let stretch = 7850.0 * rate * rate * size * size / 2e11;
    let number = 3.0 * gravity / radius * (8.0 / 3.0 - 1.0) / 2.0 / (rate * rate);
    let down = SpaceVector::new(0.0, 0.0, -1.0);
    let gradient = GravityGradient::fixed((gravity / radius).sqrt(), down)?;
    let candidates = (block.scene).neglected_effects(&block.start, block.end, 1e-3)?;
    let formula = "3 g (I3 - I1) / (R_E I2 omega^2)";
    let pulled = candidates.line(
        "gravity gradient of the Earth",
        formula,
        number,
        &gradient,
        "rad",
    )?;
    kit::effect_card! { report,
        "rotation of the Earth, laboratory axes":
            "Omega_E / omega" = earth, costs earth * turned, "rad";
    }?;
    report.add(pulled)?;
    kit::effect_card! { report,
        "stretch of the steel": "rho omega^2 d^2 / E" = stretch, costs stretch * turned, "rad";
        "rounding of the numbers": "2^-53" = EPS, costs EPS * turned, "rad",
            measured rounded(&block)?, included;
    }
}

/// What the start, rounded, makes of the end: two motions in closed form, their momenta apart by
/// a part of 2^-20, and the angle between their ends in proportion.
pub fn rounded(block: &Problem<()>) -> Result<f64> {
    let (body, apart) = (block.scene.body(), exp2(-20.0));
    let end = |part: f64| -> Result<Attitude> {
        let start = State::new(block.start.attitude, block.start.angular_momentum * part)?;
        let rates = body.angular_velocity(&start);
        Ok(FreeBody::new(body.moments(), start.attitude, rates)?.attitude(block.end))
    };
    Ok(end(1.0)?.angle_to(&end(1.0 + apart)?) * EPS / apart)
}
