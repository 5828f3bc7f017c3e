//! What the notes leave out, as torques on the rotor in slow steady precession at 60 degrees.

use super::rotor::Rotor;
use super::*;
use rotation_dynamics::effects::{CoulombBearing, DiscDrag, Torque};

/// Adds the card of effects, and what a run with each of the three torques gives.
pub fn effects(report: &mut Report) -> Result<()> {
    let rotor = Rotor::new(&Parameters::default());
    let (weight, momentum) = (rotor.weight_moment(), rotor.axial_momentum());
    // The root of I1 cos(theta) phi'^2 - L_z phi' + m g l = 0 that needs the weight.
    let steady_rate = |theta: f64, momentum: f64| {
        let discriminant = momentum * momentum - 4.0 * rotor.i1 * weight * cos(theta);
        2.0 * weight / (momentum + discriminant.sqrt())
    };
    // L_Z of that precession.
    let steady_vertical = |theta: f64| {
        let (s, u) = sincos(theta);
        momentum * u + rotor.i1 * s * s * steady_rate(theta, momentum)
    };
    let (theta, spin, steady) = (rotor.theta, rotor.spin, rotor.steady()?);
    let (rate, turn, s) = (steady_rate(theta, momentum), steady.turn, sin(theta));
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

    let [of_air, of_bearing] = torques.map(|torque| torque * turn / momentum);
    let (left_out, of) = (steady.left_out()?, "rad a turn, of the axis");
    report.add(vec![
        left_out.line("air on the rotor", "torque x turn / L_z", of_air, &air, of)?,
        left_out.line("bearings of the axle", "torque x turn / L_z", of_bearing, &bearing, of)?,
        left_out.line(
            "friction of the vertical pivot",
            "torque / m g l",
            drag / weight,
            &pivot,
            of,
        )?,
    ])?;
    effect_card! { report,
        "inertia of the fork": "I_fork / I1 sin^2 theta" = heavier, costs by_fork, "s a nod, if it nods";
        "rotation of the Earth": "Omega_E / (dphi/dt)" = earth / rate, costs earth * turn, "rad a turn, at most";
        "stretch of the spinning disc": "rho omega^2 R^2 / E" = stretch, costs swells * TAU, "rad a turn, in φ";
        "weight": "m g l I1 / L_z^2" = rotor.ratio(), costs TAU, "rad a turn, in φ", included;
    }?;

    // Slow torques carry the axis along the steady precessions. Estimates to first order
    // in the torque; the bound is what the second order may do.
    const FIRST: &str = "first order in the torque";
    let d = 1e-4;
    let [weaker, stronger] = [1.0 - d, 1.0 + d].map(|part| steady_rate(theta, momentum * part));
    let faster = (weaker - stronger) / (2.0 * d * momentum);
    let [by_air, by_bearing] = torques.map(|torque| 0.5 * faster * torque * turn * turn);
    let [higher, lower] = [theta - d, theta + d].map(steady_vertical);
    let by_pivot = drag * turn / ((higher - lower) / (2.0 * d));
    claims! { report,
        /// lead of phi after one turn, by the air on the rotor
        air_lead: steady.changed_by(air)?[1], "rad", FIRST => by_air, within 0.01 * by_air, judged 0.05;
        /// lead of phi after one turn, by the bearings of the axle
        bearing_lead: steady.changed_by(bearing)?[1], "rad", FIRST => by_bearing, within 0.01 * by_bearing, judged 0.05;
        /// sag of the axis in one turn, by friction in the vertical pivot
        pivot_sag: steady.changed_by(pivot)?[0], "rad", FIRST => by_pivot, within 0.01 * by_pivot, judged 0.05;
    }
}
