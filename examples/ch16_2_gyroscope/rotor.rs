//! A gyroscope one can hold: a 0.5 kg disc of 6 cm radius at 3000 turns a minute,
//! 10 cm from its pivot. In SI units, and with the effects the notes leave out.

use rotation_dynamics::attitude::EulerAngles;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::integrators::{Dop853, Integrator, Ode};
use rotation_dynamics::math::{cos, pow, sin, sincos};
use rotation_dynamics::report::heavy_top::{Motion, Nod};
use rotation_dynamics::report::{Claim, EffectEntry, Oracle, Report, Table, supported_digits};
use rotation_dynamics::{Error, Result};

use core::f64::consts::{PI, TAU};

// ANCHOR: body
/// I1 and I3 (kg m^2), mass (kg), gravity (m/s^2), length (m), tilt (rad),
/// spin, precession and nutation at the start (rad/s).
const ROTOR: [f64; 9] = [
    5.45e-3,
    9e-4,
    0.5,
    9.80665,
    0.1,
    PI / 3.0,
    100.0 * PI,
    0.0,
    0.0,
];

/// The motion of this rotor, each `None` standing for the rotor's own value.
pub fn motion(given: &[Option<f64>; 9]) -> Result<Motion> {
    let [
        i1,
        i3,
        mass,
        gravity,
        length,
        theta,
        spin,
        precession,
        nutation,
    ] = core::array::from_fn(|k| given[k].unwrap_or(ROTOR[k]));
    if mass <= 0.0 {
        return Err(Error::OutOfRange {
            name: "mass",
            value: mass,
            allowed: "it must be greater than 0",
        });
    }
    let body = SymmetricTop::from_mass(i1, i3, mass, gravity, length)?;
    let start = EulerAngles {
        phi: 0.0,
        theta,
        zeta: 0.0,
    };
    let omega = BodyVector::new(nutation, precession * sin(theta), spin);
    Motion::new("", HeavyTop::from_body(body, start, omega)?)
}
// ANCHOR_END: body

/// What the notes leave out, as torques on the rotor in steady precession.
#[derive(Debug, Clone, Copy, Default)]
struct LeftOut {
    /// Against the spin, N m: the air, the bearings of the axle.
    spin_torque: f64,
    /// Against the precession, N m: the vertical pivot.
    pivot_torque: f64,
    /// Moment of inertia of what turns with the precession only, kg m^2: the fork.
    fork: f64,
}

/// theta, theta', phi, L_z, L_Z with those torques.
struct WithEffects(LeftOut);

impl WithEffects {
    fn precession(&self, s: f64, u: f64, spin: f64, vertical: f64) -> f64 {
        (vertical - spin * u) / (ROTOR[0] * s * s + self.0.fork)
    }
}

impl Ode<5> for WithEffects {
    fn derivative(&self, _t: f64, &[theta, nutation, _, spin, vertical]: &[f64; 5]) -> [f64; 5] {
        let [i1, _, mass, gravity, length, ..] = ROTOR;
        let (s, u) = sincos(theta);
        let precession = self.precession(s, u, spin, vertical);
        let force = mass * gravity * length * s - precession * s * (spin - i1 * precession * u);
        [
            nutation,
            force / i1,
            precession,
            -self.0.spin_torque,
            -self.0.spin_torque * u - self.0.pivot_torque,
        ]
    }
}

/// The slow steady precession at tilt `theta` with the axial momentum `spin` (rad/s).
fn steady_rate(theta: f64, spin: f64) -> f64 {
    let [i1, _, mass, gravity, length, ..] = ROTOR;
    let weight = mass * gravity * length;
    2.0 * weight / (spin + (spin * spin - 4.0 * i1 * weight * cos(theta)).sqrt())
}

/// L_Z of that precession (kg m^2/s).
fn steady_vertical(theta: f64, spin: f64) -> f64 {
    let (s, u) = sincos(theta);
    spin * u + ROTOR[0] * s * s * steady_rate(theta, spin)
}

/// Tilt and azimuth after one turn of the precession, with `left_out` taken in.
fn after_one_turn(left_out: LeftOut) -> Result<[f64; 2]> {
    let [i1, i3, _, _, _, theta, spin, ..] = ROTOR;
    let (s, u) = sincos(theta);
    let spin = i3 * spin;
    let rate = steady_rate(theta, spin);
    // The same steady precession, begun with the fork already turning.
    let vertical = spin * u + (i1 * s * s + left_out.fork) * rate;
    let start = [theta, 0.0, 0.0, spin, vertical];
    let (end, _) = Dop853::new(1e-12)?.advance(&WithEffects(left_out), 0.0, &start, TAU / rate)?;
    Ok([end[0], end[2]])
}

/// Adds the rotor's own claims, the table of leading orders, and the card of effects.
pub fn add(report: &mut Report) -> Result<()> {
    let rotor = motion(&[None; 9])?;
    let [i1, i3, mass, gravity, length, theta, spin, ..] = ROTOR;
    let (weight, momentum, s) = (mass * gravity * length, i3 * spin, sin(theta));
    let (exact, ratio) = (&rotor.exact, weight * i1 / (momentum * momentum));
    let nod = Nod::by_quadrature(&rotor.top, rotor.energy);
    let period = nod.period * rotor.unit;
    let mut table = Table::new(
        "rotor",
        ["quantity", "unit", "exact", "fast rotor", "formula"],
    )?;
    let mut add = |key: &str,
                   meaning: &str,
                   formula: &str,
                   unit: &str,
                   [value, other, leading]: [f64; 3],
                   slip: (f64, &str)| {
        let oracle = Oracle::new("quadrature over one nod", other);
        let claim = Claim::new(key, meaning, value, unit, 1e-12, oracle)?;
        table.push([
            meaning.to_string(),
            unit.into(),
            supported_digits(value, 1e-5 * value),
            supported_digits(leading, 1e-5 * value),
            formula.into(),
        ])?;
        report.add_claim(claim.slip(slip.0, slip.1))
    };
    add(
        "rotor_rate",
        "mean rate of precession",
        "m g l/L_z",
        "rad/s",
        [
            exact.precession_per_period() / exact.nutation_period(),
            nod.precession / period,
            weight / momentum,
        ],
        (
            weight * s / momentum,
            "the torque has a factor sin(theta), and so has the momentum it turns",
        ),
    )?;
    add(
        "rotor_period",
        "time of one nod",
        "2 pi I1/L_z",
        "s",
        [exact.nutation_period(), period, TAU * i1 / momentum],
        (TAU * i3 / momentum, "that is a turn of the spin"),
    )?;
    add(
        "rotor_dip",
        "depth of the dip",
        "2 (m g l I1/L_z^2) sin(theta)",
        "rad",
        [
            exact.theta_max() - exact.theta_min(),
            nod.theta_max - nod.theta_min,
            2.0 * ratio * s,
        ],
        (ratio * s, "that is the middle of the nod, half of the dip"),
    )?;
    report.add_table(table)?;
    add_effects(report, ratio)
}

fn add_effects(report: &mut Report, ratio: f64) -> Result<()> {
    let [i1, i3, mass, gravity, length, theta, spin, ..] = ROTOR;
    let (weight, momentum) = (mass * gravity * length, i3 * spin);
    let rate = steady_rate(theta, momentum);
    let turn = TAU / rate;
    let s = sin(theta);
    // Disc of radius 6 cm in air, both faces, laminar: C_m = 3.87 / sqrt(Re).
    let (air, viscosity, radius) = (1.204, 1.51e-5, 0.06);
    let reynolds = spin * radius * radius / viscosity;
    let air_torque = 0.5 * air * spin * spin * pow(radius, 5.0) * 3.87 / reynolds.sqrt();
    // Ball bearing: coefficient 0.0015 at a radius of 2 mm.
    let bearing_torque = 0.0015 * mass * gravity * 2e-3;
    let pivot_torque = 1e-4;
    let fork = 2e-4;

    // Slow torques carry the axis along the steady precessions. Estimates to first order
    // in the torque; the bound is what the second order may do.
    let mut observed =
        |key: &str, meaning: &str, left_out: LeftOut, which: usize, estimate: f64| -> Result<f64> {
            let plain = after_one_turn(LeftOut::default())?[which];
            let value = after_one_turn(left_out)?[which] - plain;
            let oracle = Oracle::new("first order in the torque", estimate);
            let claim = Claim::new(key, meaning, value, "rad", 0.01 * estimate.abs(), oracle)?;
            report.add_claim(claim.judged_within(0.05))?;
            Ok(value)
        };
    let d = 1e-4;
    let faster = (steady_rate(theta, momentum * (1.0 - d))
        - steady_rate(theta, momentum * (1.0 + d)))
        / (2.0 * d * momentum);
    let fading = |torque: f64| 0.5 * faster * torque * turn * turn;
    let by_air = observed(
        "air_lead",
        "lead of phi after one turn, by the air on the rotor",
        LeftOut {
            spin_torque: air_torque,
            ..LeftOut::default()
        },
        1,
        fading(air_torque),
    )?;
    let by_bearing = observed(
        "bearing_lead",
        "lead of phi after one turn, by the bearings of the axle",
        LeftOut {
            spin_torque: bearing_torque,
            ..LeftOut::default()
        },
        1,
        fading(bearing_torque),
    )?;
    let lower =
        (steady_vertical(theta - d, momentum) - steady_vertical(theta + d, momentum)) / (2.0 * d);
    let by_pivot = observed(
        "pivot_sag",
        "sag of the axis in one turn, by friction in the vertical pivot",
        LeftOut {
            pivot_torque,
            ..LeftOut::default()
        },
        0,
        pivot_torque * turn / lower,
    )?;
    let by_fork = motion(&[None; 9])?.exact.nutation_period() * 0.5 * fork / (i1 * s * s);

    let mut add = |effect: &str, number: &str, value: f64, error: f64, unit: &str| {
        report.add_effect(EffectEntry {
            effect: effect.into(),
            number: number.into(),
            value,
            error,
            unit: unit.into(),
            included: false,
        });
    };
    add(
        "air on the rotor",
        "torque x turn / L_z",
        air_torque * turn / momentum,
        by_air,
        "rad a turn, in φ",
    );
    add(
        "bearings of the axle",
        "torque x turn / L_z",
        bearing_torque * turn / momentum,
        by_bearing,
        "rad a turn, in φ",
    );
    add(
        "friction of the vertical pivot",
        "torque / m g l",
        pivot_torque / weight,
        by_pivot,
        "rad a turn, in θ",
    );
    add(
        "inertia of the fork",
        "I_fork / I1 sin^2 theta",
        fork / (i1 * s * s),
        by_fork,
        "s, in the time of a nod",
    );
    let earth = 7.292115e-5;
    add(
        "rotation of the Earth",
        "Omega_E / (dphi/dt)",
        earth / rate,
        earth * turn,
        "rad a turn, at most",
    );
    // Steel, 7850 kg/m^3 and 200 GPa.
    let stretch = 7850.0 * spin * spin * radius * radius / 2e11;
    add(
        "stretch of the spinning disc",
        "rho omega^2 R^2 / E",
        stretch,
        stretch * TAU,
        "rad a turn, in φ",
    );
    report.add_effect(EffectEntry {
        effect: "weight".into(),
        number: "m g l I1 / L_z^2".into(),
        value: ratio,
        error: TAU,
        unit: "rad a turn, in φ".into(),
        included: true,
    });
    Ok(())
}
