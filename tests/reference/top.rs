//! The heavy top in closed form.

use super::case::{Case, Outcome};
use rotation_dynamics::attitude::EulerAngles;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start, SymmetricTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::DoubleDouble;

pub const BOUND: f64 = 8.0;

pub fn dimensionless(case: &Case) -> Outcome {
    compare(case, &from_parameters(case, 1.0))
}

pub fn dimensional(case: &Case) -> Outcome {
    compare(case, &from_body(case))
}

/// The motion of a `top_nd` case with c multiplied by `damage`.
pub fn from_parameters(case: &Case, damage: f64) -> HeavyTop {
    let input = |name| case.input(name);
    let motion = ReducedTop::formal(input("a"), input("b"), input("c") * damage).and_then(|top| {
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
    });
    motion.unwrap_or_else(|error| panic!("{}: {error}", case.id))
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
        let scalars = [
            ("cos_theta", motion.cos_theta(t)),
            ("theta", angles.theta),
            ("dtheta", motion.theta_rate(t)),
            ("phi", angles.phi),
            ("zeta", angles.zeta),
        ];
        for (field, got) in scalars {
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
            let largest = want.iter().fold(0.0, |m: f64, w| m.max(w.abs().to_f64()));
            let scale = largest + sample.condition(field);
            for (i, want) in want.into_iter().enumerate() {
                outcome.compare(&format!("{field}[{i}] at {t}"), got[i], want, scale);
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
            outcome.compare(name, got, want, want.abs().to_f64());
        }
    }
    if case.flag("passes_pole") != motion.passes_pole() {
        outcome.compare("passes_pole", f64::NAN, DoubleDouble::ZERO, 1.0);
    }
}
