//! The heavy top in closed form.

use super::case::{Case, Outcome, Result, Trouble};
use rotation_dynamics::attitude::EulerAngles;
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Regime, Start, SymmetricTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::{DoubleDouble, atan2};

/// Measured: 2.48 over the repository's cases (theta' in `rand-energy-0`), without
/// sens_path in those of `heavy_top_hard.json`.
pub const BOUND: f64 = 2.5;

pub fn dimensionless(case: &Case) -> Result<Outcome> {
    Ok(compare(case, &from_parameters(case, 1.0)?))
}

pub fn dimensional(case: &Case) -> Result<Outcome> {
    Ok(compare(case, &from_body(case)?))
}

/// The motion of a `top_nd` case with c multiplied by `damage`.
pub fn from_parameters(case: &Case, damage: f64) -> Result<HeavyTop> {
    let input = |name| case.input(name);
    let top = ReducedTop::formal(input("a")?, input("b")?, input("c")? * damage)?;
    let phi0 = case.optional("phi0").unwrap_or(0.0);
    let zeta0 = case.optional("zeta0").unwrap_or(0.0);
    let Some(energy) = case.optional("Etilde") else {
        let (theta0, rate) = (input("theta0")?, input("dtheta0")?);
        return Ok(HeavyTop::from_angles(top, theta0, rate, phi0, zeta0)?);
    };
    let start = match case.word("start") {
        Some("theta_min") => Start::ThetaMin,
        Some("theta_max") => Start::ThetaMax,
        other => return Err(Trouble::Lacks(format!("no start, but {other:?}"))),
    };
    Ok(HeavyTop::from_energy(top, energy, start, phi0, zeta0)?)
}

/// A pendulum is a top without spin that swings in a plane: theta from the hanging
/// position with the centre of mass below the pivot.
pub fn pendulum(case: &Case) -> Result<Outcome> {
    let mut outcome = Outcome::new();
    let input = |name| case.input(name);
    let (theta0, omega0) = (input("theta0")?, input("omega0")?);
    let side = if theta0 < 0.0 { -1.0 } else { 1.0 };
    let (moment, lever) = (input("I")?, -input("d")?);
    let body = SymmetricTop::from_mass(moment, moment, input("m")?, input("g")?, lever)?;
    let attitude = EulerAngles { phi: 0.0, theta: theta0.abs(), zeta: 0.0 };
    let omega = BodyVector::new(side * omega0, 0.0, 0.0);
    let motion = HeavyTop::from_body(body, attitude, omega)?;
    for sample in case.samples() {
        let t = sample.t();
        if let Some(want) = sample.value("theta") {
            // The attitude knows theta without its whole turns.
            let [w, x, ..] = motion.attitude(t).quaternion();
            let angle = side * 2.0 * atan2(x, w);
            let turns = ((want - angle) / DoubleDouble::TWO_PI).round();
            let got = (DoubleDouble::TWO_PI * turns + angle).to_f64();
            outcome.compare_field(&sample, "theta", &[got]);
        }
        let omega = side * motion.angular_velocity(t).x();
        outcome.compare_field(&sample, "omega", &[omega]);
    }
    if let Some(want) = case.derived("T") {
        // A swing passes the bottom twice; a turn passes it once.
        let swings = case.derived_word("type") == Some("osc");
        let period = motion.nutation_period() * if swings { 2.0 } else { 1.0 };
        outcome.compare("T", period, want, want.to_f64());
    }
    Ok(outcome)
}

fn from_body(case: &Case) -> Result<HeavyTop> {
    let input = |name| case.input(name);
    let [phi, theta, zeta] = case.input_vector("euler0")?;
    let (i1, i3, lever) = (input("I1")?, input("I3")?, input("l")?);
    let body = SymmetricTop::from_mass(i1, i3, input("m")?, input("g")?, lever)?;
    let omega = BodyVector::from_array(case.input_vector("omega0")?);
    let attitude = EulerAngles { phi, theta, zeta };
    Ok(HeavyTop::from_body(body, attitude, omega)?)
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
            outcome.compare_field(&sample, field, &[got]);
        }
        let Kinematics { attitude, angular_velocity: omega } = motion.kinematics(t);
        let momentum = motion.angular_momentum(t).to_array();
        outcome.compare_field(&sample, "R", &attitude.matrix().concat());
        outcome.compare_field(&sample, "omega", &omega.to_array());
        outcome.compare_field(&sample, "L_space", &momentum);
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
