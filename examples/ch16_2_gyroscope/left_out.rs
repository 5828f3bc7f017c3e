//! What the notes leave out, as torques on the rotor in slow steady precession at 60 degrees.

use super::rotor::ROTOR;
use rotation_dynamics::Result;
use rotation_dynamics::effects::DiscDrag;
use rotation_dynamics::integrators::{Dop853, Integrator, Ode};
use rotation_dynamics::math::{sin, sincos};
use rotation_dynamics::report::{Report, claim};

use core::f64::consts::TAU;

#[derive(Debug, Clone, Copy, Default)]
struct LeftOut {
    /// Against the spin, N m: the air, the bearings of the axle.
    spin_torque: f64,
    /// Against the precession, N m: the vertical pivot.
    pivot_torque: f64,
}

/// theta, theta', phi, L_z, L_Z with those torques.
impl Ode<5> for LeftOut {
    fn derivative(&self, _t: f64, &[theta, nutation, _, spin, vertical]: &[f64; 5]) -> [f64; 5] {
        let (i1, (s, u)) = (ROTOR.i1, sincos(theta));
        let precession = (vertical - spin * u) / (i1 * s * s);
        let torque = ROTOR.weight_moment() * s - precession * s * (spin - i1 * precession * u);
        [
            nutation,
            torque / i1,
            precession,
            -self.spin_torque,
            -self.spin_torque * u - self.pivot_torque,
        ]
    }
}

/// L_Z of the slow steady precession (kg m^2/s).
fn steady_vertical(theta: f64, momentum: f64) -> f64 {
    let (s, u) = sincos(theta);
    momentum * u + ROTOR.i1 * s * s * ROTOR.steady_rate(theta, momentum)
}

/// Tilt and azimuth after one turn of the precession, with these torques.
fn after_one_turn(torques: LeftOut) -> Result<[f64; 2]> {
    let (theta, momentum) = (ROTOR.theta, ROTOR.axial_momentum());
    let start = [theta, 0.0, 0.0, momentum, steady_vertical(theta, momentum)];
    let turn = TAU / ROTOR.steady_rate(theta, momentum);
    let (end, _) = Dop853::new(1e-12)?.advance(&torques, 0.0, &start, turn)?;
    Ok([end[0], end[2]])
}

/// Adds the card of effects, the first three with the error measured.
pub fn add(report: &mut Report) -> Result<()> {
    let (rotor, weight, momentum) = (ROTOR, ROTOR.weight_moment(), ROTOR.axial_momentum());
    let (theta, spin) = (rotor.theta, rotor.spin);
    let (rate, s) = (rotor.steady_rate(theta, momentum), sin(theta));
    let turn = TAU / rate;
    // Disc of radius 6 cm in air.
    let radius = 0.06;
    let air = DiscDrag::new(radius, DiscDrag::AIR_DENSITY, DiscDrag::AIR_VISCOSITY, spin)?;
    let air_torque = -air.axial_torque(spin);
    // Ball bearing: coefficient 0.0015 at a radius of 2 mm.
    let bearing_torque = 0.0015 * rotor.mass * rotor.gravity * 2e-3;
    let (pivot_torque, fork, earth) = (1e-4, 2e-4, 7.292115e-5);
    // Steel, 7850 kg/m^3 and 200 GPa.
    let stretch = 7850.0 * spin * spin * radius * radius / 2e11;

    // Slow torques carry the axis along the steady precessions. Estimates to first order
    // in the torque; the bound is what the second order may do.
    let [plain_tilt, plain_azimuth] = after_one_turn(LeftOut::default())?;
    let mut observed = |key: &str, meaning: &str, value: f64, estimate: f64| -> Result<f64> {
        let claim = claim(key, meaning, value, "rad").within(0.01 * estimate.abs());
        report.add(
            claim
                .against("first order in the torque", estimate)
                .judged_within(0.05),
        )?;
        Ok(value)
    };
    let slows = |spin_torque| LeftOut {
        spin_torque,
        ..LeftOut::default()
    };
    let drags = |pivot_torque| LeftOut {
        pivot_torque,
        ..LeftOut::default()
    };
    let d = 1e-4;
    let faster = (rotor.steady_rate(theta, momentum * (1.0 - d))
        - rotor.steady_rate(theta, momentum * (1.0 + d)))
        / (2.0 * d * momentum);
    let fading = |torque: f64| 0.5 * faster * torque * turn * turn;
    let by_air = observed(
        "air_lead",
        "lead of phi after one turn, by the air on the rotor",
        after_one_turn(slows(air_torque))?[1] - plain_azimuth,
        fading(air_torque),
    )?;
    let by_bearing = observed(
        "bearing_lead",
        "lead of phi after one turn, by the bearings of the axle",
        after_one_turn(slows(bearing_torque))?[1] - plain_azimuth,
        fading(bearing_torque),
    )?;
    let lower =
        (steady_vertical(theta - d, momentum) - steady_vertical(theta + d, momentum)) / (2.0 * d);
    let by_pivot = observed(
        "pivot_sag",
        "sag of the axis in one turn, by friction in the vertical pivot",
        after_one_turn(drags(pivot_torque))?[0] - plain_tilt,
        pivot_torque * turn / lower,
    )?;
    let heavier = fork / (rotor.i1 * s * s);
    let by_fork = rotor.motion()?.exact.nutation_period() * 0.5 * heavier;

    rotation_dynamics::effect_card! { report,
        "air on the rotor":
            "torque x turn / L_z" = air_torque * turn / momentum, costs by_air, "rad a turn, in φ";
        "bearings of the axle":
            "torque x turn / L_z" = bearing_torque * turn / momentum, costs by_bearing, "rad a turn, in φ";
        "friction of the vertical pivot":
            "torque / m g l" = pivot_torque / weight, costs by_pivot, "rad a turn, in θ";
        "inertia of the fork":
            "I_fork / I1 sin^2 theta" = heavier, costs by_fork, "s a nod, if it nods";
        "rotation of the Earth":
            "Omega_E / (dphi/dt)" = earth / rate, costs earth * turn, "rad a turn, at most";
        "stretch of the spinning disc":
            "rho omega^2 R^2 / E" = stretch, costs stretch * TAU, "rad a turn, in φ";
        "weight": "m g l I1 / L_z^2" = rotor.ratio(), costs TAU, "rad a turn, in φ", included;
    }
}
