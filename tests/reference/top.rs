//! The heavy top in closed form.

use super::case::{Case, Outcome};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::EulerAngles;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Regime, Start, SymmetricTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::{DoubleDouble, atan2};

/// Measured: 2.48 over the repository's cases (theta' in `rand-energy-0`), without
/// sens_path in those of `heavy_top_hard.json`.
pub const BOUND: f64 = 2.6;

pub fn dimensionless(case: &Case) -> Outcome {
    let motion = from_parameters(case, 1.0).unwrap_or_else(|error| panic!("{}: {error}", case.id));
    compare(case, &motion)
}

pub fn dimensional(case: &Case) -> Outcome {
    compare(case, &from_body(case))
}

/// The motion of a `top_nd` case with c multiplied by `damage`.
pub fn from_parameters(case: &Case, damage: f64) -> Result<HeavyTop> {
    let input = |name| case.input(name);
    ReducedTop::formal(input("a"), input("b"), input("c") * damage).and_then(|top| {
        let (phi0, zeta0) = (
            case.optional("phi0").unwrap_or(0.0),
            case.optional("zeta0").unwrap_or(0.0),
        );
        match case.optional("Etilde") {
            Some(energy) => {
                let start = match case.word("start") {
                    Some("theta_min") => Start::ThetaMin,
                    Some("theta_max") => Start::ThetaMax,
                    other => panic!("{}: unknown start {other:?}", case.id),
                };
                HeavyTop::from_energy(top, energy, start, phi0, zeta0)
            }
            None => HeavyTop::from_angles(top, input("theta0"), input("dtheta0"), phi0, zeta0),
        }
    })
}

/// A pendulum is a top without spin that swings in a plane: theta from the hanging
/// position with the centre of mass below the pivot.
pub fn pendulum(case: &Case) -> Outcome {
    let mut outcome = Outcome::new();
    let input = |name| case.input(name);
    let (theta0, omega0) = (input("theta0"), input("omega0"));
    let side = if theta0 < 0.0 { -1.0 } else { 1.0 };
    let motion =
        SymmetricTop::from_mass(input("I"), input("I"), input("m"), input("g"), -input("d"))
            .and_then(|body| {
                let attitude = EulerAngles {
                    phi: 0.0,
                    theta: theta0.abs(),
                    zeta: 0.0,
                };
                let omega = BodyVector::new(side * omega0, 0.0, 0.0);
                HeavyTop::from_body(body, attitude, omega)
            })
            .unwrap_or_else(|error| panic!("{}: {error}", case.id));
    for sample in case.samples() {
        let t = sample.t();
        let compare = |outcome: &mut Outcome, field: &str, got: f64, want: DoubleDouble| {
            let scale = want.abs().to_f64() + sample.condition(field);
            outcome.compare(&format!("{field} at {t}"), got, want, scale);
        };
        if let Some(want) = sample.value("theta") {
            // The attitude knows theta without its whole turns.
            let [w, x, ..] = motion.attitude(t).quaternion();
            let angle = side * 2.0 * atan2(x, w);
            let turns = ((want - angle) / DoubleDouble::TWO_PI).round();
            let got = (DoubleDouble::TWO_PI * turns + angle).to_f64();
            compare(&mut outcome, "theta", got, want);
        }
        if let Some(want) = sample.value("omega") {
            let got = side * motion.angular_velocity(t).x();
            compare(&mut outcome, "omega", got, want);
        }
    }
    if let Some(want) = case.derived("T") {
        // A swing passes the bottom twice; a turn passes it once.
        let swings = case.derived_word("type") == Some("osc");
        let period = motion.nutation_period() * if swings { 2.0 } else { 1.0 };
        outcome.compare("T", period, want, want.to_f64());
    }
    outcome
}

fn from_body(case: &Case) -> HeavyTop {
    let input = |name| case.input(name);
    let [phi, theta, zeta] = case.input_vector("euler0");
    SymmetricTop::from_mass(input("I1"), input("I3"), input("m"), input("g"), input("l"))
        .and_then(|body| {
            let attitude = EulerAngles { phi, theta, zeta };
            HeavyTop::from_body(
                body,
                attitude,
                BodyVector::from_array(case.input_vector("omega0")),
            )
        })
        .unwrap_or_else(|error| panic!("{}: {error}", case.id))
}

pub fn compare(case: &Case, motion: &HeavyTop) -> Outcome {
    let mut outcome = Outcome::new();
    for sample in case.samples() {
        let t = sample.t();
        let angles = motion.angles(t);
        // On the vertical only phi + zeta means something.
        let upright = motion.regime() == Regime::Sleeping && angles.theta == 0.0;
        let scalars = [
            ("cos_theta", motion.cos_theta(t)),
            ("theta", angles.theta),
            ("dtheta", motion.theta_rate(t)),
            ("phi", angles.phi),
            ("zeta", angles.zeta),
        ];
        for (field, got) in scalars {
            if upright && matches!(field, "phi" | "zeta") {
                continue;
            }
            if let Some(want) = sample.value(field) {
                let scale = want.abs().to_f64() + sample.condition(field);
                outcome.compare(&format!("{field} at {t}"), got, want, scale);
            }
        }
        let matrix = motion.attitude(t).matrix();
        let vectors = [
            ("R", matrix.concat()),
            ("omega", motion.angular_velocity(t).to_array().to_vec()),
            ("L_space", motion.angular_momentum(t).to_array().to_vec()),
        ];
        for (field, got) in vectors {
            let want = sample.values(field);
            if !want.is_empty() {
                outcome.compare_field(&sample, field, t, &got, &want);
            }
        }
    }
    derived(case, motion, &mut outcome);
    outcome
}

/// The derived values have no condition of their own: the value is the scale, with the
/// factor a value's own arithmetic needs.
fn derived(case: &Case, motion: &HeavyTop, outcome: &mut Outcome) {
    let (vertical, axial) = motion.momenta();
    let reduced = motion.reduced();
    let mut values = vec![
        ("theta_min", Some(motion.theta_min())),
        ("theta_max", Some(motion.theta_max())),
        ("m", Some(motion.parameter())),
        ("T_nut", Some(motion.nutation_period())),
        ("Etilde", motion.energy_reduced()),
        ("E", Some(motion.energy())),
        ("L_Z", Some(vertical)),
        ("L_z", Some(axial)),
        ("a", reduced.map(|top| top.a())),
        ("b", reduced.map(|top| top.b())),
        ("c", reduced.map(|top| top.c())),
        ("t_unit", motion.time_unit()),
    ];
    if !motion.passes_pole() {
        values.push(("dphi_nut", Some(motion.precession_per_period())));
    }
    if let Some(top) = reduced {
        let (theta, energy) = top.minimum();
        values.push(("theta_Umin", Some(theta)));
        values.push(("Umin", Some(energy)));
        values.push(("E_cusp", top.cusp_energy()));
    }
    for (name, got) in values {
        if let Some(want) = case.derived(name) {
            let got = got.unwrap_or(f64::NAN);
            let mut scale = want.abs().to_f64();
            if name == "dphi_nut" {
                // The advance of an almost free top is what is left of two half turns.
                scale += 1e-15;
            }
            outcome.compare(name, got, want, scale);
        }
    }
}
