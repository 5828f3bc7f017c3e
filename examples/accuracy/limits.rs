//! Limits in which the error of a method is known, and what the errors of physics are.

use rotation_dynamics::Result;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::FreeRotation;
use rotation_dynamics::integrators::{GaussLegendre, Integrator, Rk4, Scheme, Splitting};
use rotation_dynamics::math::{EPS, pow};
use rotation_dynamics::report::{EffectEntry, Limit, Report};
use rotation_dynamics::scene::Scene;

use core::f64::consts::TAU;

/// Adds the limits and the card of effects.
pub fn add(report: &mut Report) -> Result<()> {
    let steady = steady_error()?;
    let mut add = |limit: &str, because: &str, must, gives, within| -> Result<()> {
        report.add_limit(Limit::new(limit, because, must, gives, within)?);
        Ok(())
    };
    add(
        "steady spin, RK4: error over (angle turned) (angle a step)^4",
        "the step's phase lacks (angle/2)^5/120, and an attitude turns twice the phase",
        1.0 / 1920.0,
        steady,
        1e-6,
    )?;
    add(
        "no torque, symmetric body, one step of Strang for 100 s: error in rad",
        "the flow between kicks is exact",
        0.0,
        free_splitting()?,
        1e-13,
    )?;
    let (across, back) = there_and_back()?;
    add(
        "1000 periods of the free body, Gauss-Legendre: off the closed form, in rad",
        "two routes to one motion",
        0.0,
        across,
        1e-11,
    )?;
    add(
        "10 of them, there and back: off the start, in rad",
        "a symmetric method run backwards undoes its own error",
        0.0,
        back,
        1e-12,
    )?;
    add_effects(report);
    Ok(())
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
    let exact = FreeBody::new(moments, rates, Attitude::IDENTITY)?.attitude_at(100.0);
    Ok(exact.angle_to(&end.attitude))
}

/// The free body in 12 steps a period: 1000 periods, off the closed form; ten and back,
/// off the start.
fn there_and_back() -> Result<(f64, f64)> {
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0)?;
    let rates = BodyVector::new(0.8, 0.4, 0.3375);
    let exact = FreeBody::new(moments, rates, Attitude::IDENTITY)?;
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(Attitude::IDENTITY, rates)?;
    let period = exact.rate_period();
    let rotation = FreeRotation::new(&scene);
    let long = GaussLegendre::new(12_000)?;
    let (far, _) = long.advance(&rotation, 0.0, &start, 1000.0 * period)?;
    let short = GaussLegendre::new(120)?;
    let (there, _) = short.advance(&rotation, 0.0, &start, 10.0 * period)?;
    let (back, _) = short.advance(&rotation, 10.0 * period, &there, 0.0)?;
    Ok((
        exact.attitude_at(1000.0 * period).angle_to(&far.attitude),
        start.attitude.angle_to(&back.attitude),
    ))
}

/// What a real free body does that the model does not: a block of steel of a decimetre,
/// turning at about 0.6 rad/s for ten periods in a laboratory.
fn add_effects(report: &mut Report) {
    let (rate, size, time): (f64, f64, f64) = (0.6, 0.1, 147.0);
    let turned = rate * time;
    let (gravity, radius) = (9.81, 6.371e6);
    let mut add = |effect: &str, number: &str, value: f64, error: f64, included: bool| {
        report.add_effect(EffectEntry {
            effect: effect.into(),
            number: number.into(),
            value,
            error,
            unit: "rad".into(),
            included,
        });
    };
    let earth = 7.292e-5 / rate;
    add(
        "rotation of the Earth, laboratory axes",
        "Omega_E / omega",
        earth,
        earth * turned,
        false,
    );
    let gradient = 3.0 * gravity / radius * (8.0 / 3.0 - 1.0) / 2.0 / (rate * rate);
    add(
        "gravity gradient of the Earth",
        "3 g (I3 - I1) / (R_E I2 omega^2)",
        gradient,
        gradient * turned,
        false,
    );
    let stretch = 7850.0 * rate * rate * size * size / 2e11;
    add(
        "stretch of the steel",
        "rho omega^2 d^2 / E",
        stretch,
        stretch * turned,
        false,
    );
    add("rounding of the numbers", "2^-53", EPS, EPS * turned, true);
}
