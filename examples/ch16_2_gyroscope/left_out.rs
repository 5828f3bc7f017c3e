//! What the notes leave out, as torques on the rotor in slow steady precession at 60 degrees.

use super::rotor::ROTOR;
use kit::{CardLine, Report, Result, claim, effect};
use rotation_dynamics::effects::{CoulombBearing, DiscDrag, Torque};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{sin, sincos};

use core::f64::consts::TAU;

/// L_Z of the slow steady precession (kg m^2/s).
fn steady_vertical(theta: f64, momentum: f64) -> f64 {
    let (s, u) = sincos(theta);
    momentum * u + ROTOR.i1 * s * s * ROTOR.steady_rate(theta, momentum)
}

/// What the error of a torque that is left out is.
const TURN: &str = "rad a turn, of the axis";

/// Adds the card of effects, and what a run with each of the three torques gives.
pub fn add(report: &mut Report) -> Result<()> {
    let (rotor, weight, momentum) = (ROTOR, ROTOR.weight_moment(), ROTOR.axial_momentum());
    let (theta, spin, steady) = (rotor.theta, rotor.spin, rotor.steady()?);
    let (rate, turn, s) = (rotor.steady_rate(theta, momentum), steady.turn, sin(theta));
    // Disc of radius 6 cm in air.
    let radius = 0.06;
    let air = DiscDrag::new(radius, DiscDrag::AIR_DENSITY, DiscDrag::AIR_VISCOSITY, spin)?;
    // Ball bearing: coefficient 0.0015 at a radius of 2 mm.
    let torques = [-air.axial_torque(spin), 0.0015 * rotor.mass * rotor.gravity * 2e-3];
    let bearing = CoulombBearing::new(torques[1], steady.scene.body(), &steady.start, 0.0)?;
    let (drag, fork, earth): (f64, f64, f64) = (1e-4, 2e-4, 7.292115e-5);
    // It acts on the fork; the fork cannot turn the rotor about its own axle.
    let pivot = Torque::on_space("friction of the vertical pivot", |_, _, state| {
        let axis = state.attitude.axis();
        let across = SpaceVector::new(0.0, 0.0, 1.0) - axis * axis.z();
        across * (-drag / across.dot(&across))
    });
    // Steel, 7850 kg/m^3, 200 GPa, Poisson's ratio 0.3. A disc of it that spins has a moment
    // larger by (1 - nu)(7 + nu)/12 of the number.
    let stretch = 7850.0 * spin * spin * radius * radius / 2e11;
    let swells = 0.7 * 7.3 / 12.0 * stretch;
    let heavier = fork / (rotor.i1 * s * s);
    let by_fork = rotor.motion()?.exact.nutation_period() * 0.5 * heavier;

    let (left_out, fading) = (steady.left_out()?, "torque x turn / L_z");
    let [of_air, of_bearing] = torques.map(|torque| torque * turn / momentum);
    report.add(vec![
        left_out.line("air on the rotor", fading, of_air, &air, TURN)?,
        left_out.line("bearings of the axle", fading, of_bearing, &bearing, TURN)?,
        left_out.line(
            "friction of the vertical pivot",
            "torque / m g l",
            drag / weight,
            &pivot,
            TURN,
        )?,
        effect("inertia of the fork")
            .number("I_fork / I1 sin^2 theta", heavier)
            .costs(by_fork, "s a nod, if it nods"),
        effect("rotation of the Earth")
            .number("Omega_E / (dphi/dt)", earth / rate)
            .costs(earth * turn, "rad a turn, at most"),
        effect("stretch of the spinning disc")
            .number("rho omega^2 R^2 / E", stretch)
            .costs(swells * TAU, "rad a turn, in φ"),
        effect("weight")
            .number("m g l I1 / L_z^2", rotor.ratio())
            .costs(TAU, "rad a turn, in φ")
            .included(),
    ])?;

    // Slow torques carry the axis along the steady precessions. Estimates to first order
    // in the torque; the bound is what the second order may do.
    let d = 1e-4;
    let faster = (rotor.steady_rate(theta, momentum * (1.0 - d))
        - rotor.steady_rate(theta, momentum * (1.0 + d)))
        / (2.0 * d * momentum);
    let [by_air, by_bearing] = torques.map(|torque| 0.5 * faster * torque * turn * turn);
    let lower =
        (steady_vertical(theta - d, momentum) - steady_vertical(theta + d, momentum)) / (2.0 * d);
    let by_pivot = drag * turn / lower;
    let observed = |key: &str, meaning: &str, value: f64, estimate: f64| {
        let claim = claim(key, meaning, value, "rad").within(0.01 * estimate.abs());
        claim.against("first order in the torque", estimate).judged_within(0.05)
    };
    report.add(vec![
        observed(
            "air_lead",
            "lead of phi after one turn, by the air on the rotor",
            steady.changed_by(air)?[1],
            by_air,
        ),
        observed(
            "bearing_lead",
            "lead of phi after one turn, by the bearings of the axle",
            steady.changed_by(bearing)?[1],
            by_bearing,
        ),
        observed(
            "pivot_sag",
            "sag of the axis in one turn, by friction in the vertical pivot",
            steady.changed_by(pivot)?[0],
            by_pivot,
        ),
    ])
}
