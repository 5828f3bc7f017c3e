//! Limits in which the error of a method is known, and what the errors of physics are.

use super::*;
use block::{EARTH, gradient, rounded, steel};
use core::f64::consts::TAU;
use rotation_dynamics::integrators::Rk4;
use rotation_dynamics::integrators::gauss_legendre::FreeRotation;

/// A body without torque whose axes start along the fixed ones.
fn free([i1, i2, i3]: [f64; 3], rates: [f64; 3]) -> Result<(Scene<()>, State)> {
    let body = RigidBody::new(PrincipalMoments::new(i1, i2, i3)?);
    let start = body.state(Attitude::IDENTITY, BodyVector::from_array(rates))?;
    Ok((Scene::new(body), start))
}

/// RK4 on a body that spins steadily, 100 steps a turn for ten turns.
fn steady_error() -> Result<f64> {
    let (scene, start) = free([1.0; 3], [0.0, 0.0, 1.0])?;
    let (turned, steps) = (10.0 * TAU, 1000.0);
    let (end, _) = Rk4::new(1000)?.advance(&scene, 0.0, &start, turned)?;
    Ok(start.attitude.angle_to(&end.attitude) / turned / pow(turned / steps, 4.0))
}

fn free_splitting() -> Result<f64> {
    let (scene, start) = free([1.0, 1.0, 1.5], [0.3, 0.2, 0.7])?;
    let (end, _) = Splitting::new(Scheme::STRANG, 1)?.advance(&scene, 0.0, &start, 100.0)?;
    Ok(scene.exact(&start)?.attitude(100.0).angle_to(&end.attitude))
}

/// The free body by Gauss-Legendre in 12 steps a period, ten periods and back.
fn back() -> Result<f64> {
    let (scene, start) = free([1.0, 2.0, 8.0 / 3.0], [0.8, 0.4, 0.3375])?;
    let end = 10.0 * scene.exact(&start)?.rate_period();
    let (rotation, gauss) = (FreeRotation::new(&scene), GaussLegendre::new(120)?);
    let (there, _) = gauss.advance(&rotation, 0.0, &start, end)?;
    let (back, _) = gauss.advance(&rotation, end, &there, 0.0)?;
    Ok(start.attitude.angle_to(&back.attitude))
}

/// Adds the limits.
pub fn limits(_: &Parameters, report: &mut Report) -> kit::Result<()> {
    limits! { report,
        /// the step's phase lacks (angle/2)^5/120, and an attitude turns twice the phase
        "steady spin, RK4: error over (angle turned) (angle a step)^4":
            steady_error()? => 1.0 / 1920.0, within 1e-6;
        /// the flow between kicks is exact
        "no torque, symmetric body, one step of Strang for 100 s: error in rad":
            free_splitting()? => 0.0, within 1e-13;
        /// a symmetric method run backwards undoes its own error
        "10 periods there and back, Gauss-Legendre: off the start, in rad":
            back()? => 0.0, within 1e-12;
    }
}

/// What ten periods of a real free body have that the model does not: the block of steel. Beside
/// it the one error that no method is rid of.
pub fn effects(_: &Parameters, report: &mut Report) -> kit::Result<()> {
    let ((block, rate), size) = (steel(10.0)?, 0.1);
    let (earth, turned) = (EARTH / rate, rate * block.end);
    let stretch = 7850.0 * rate * rate * size * size / 2e11;
    let (pull, number) = gradient(rate)?;
    let candidates = (block.scene).neglected_effects(&block.start, block.end, 1e-3)?;
    let name = "gravity gradient of the Earth";
    let formula = "3 g (I3 - I1) / (R_E I2 omega^2)";
    let gradient = candidates.line(name, formula, number, &pull, "rad")?;
    effect_card! { report,
        "rotation of the Earth, laboratory axes":
            "Omega_E / omega" = earth, costs earth * turned, "rad";
    }?;
    report.add(gradient)?;
    effect_card! { report,
        "stretch of the steel": "rho omega^2 d^2 / E" = stretch, costs stretch * turned, "rad";
        "rounding of the numbers": "2^-53" = EPS, costs EPS * turned, "rad",
            measured rounded(&block, exp2(-20.0))?, included;
    }
}
