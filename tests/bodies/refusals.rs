//! Bad input from the API: each constructor's error names the offending numbers.
//!
//! The heavy top, the ladder, the pendulum and the plank have their own, beside
//! their other tests; so has the command line.

use rotation_dynamics::Error;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::jacobi::am;
use rotation_dynamics::exact::{Modulus, carlson, legendre};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::{PrincipalMoments, solids};
use rotation_dynamics::integrators::splitting::Scheme;
use rotation_dynamics::integrators::{Dop853, GaussLegendre, Integrator, Rk4, Splitting};
use rotation_dynamics::scene::Scene;

const NAN: f64 = f64::NAN;
const INF: f64 = f64::INFINITY;

/// What a constructor said, and the words that must stand in it.
type Refusal = (Option<Error>, &'static [&'static str]);

fn refusals() -> Vec<Refusal> {
    let moments = |a, b, c| PrincipalMoments::new(a, b, c).err();
    let turned = |phi, theta, zeta| Attitude::from_euler(EulerAngles { phi, theta, zeta }).err();
    let about = |x, angle| Attitude::about_body_axis(BodyVector::new(x, 0.0, 0.0), angle).err();
    let state = |l| State::new(Attitude::IDENTITY, SpaceVector::new(0.0, l, 0.0)).err();
    vec![
        (moments(-1.0, 1.0, 1.0), &["-1", "greater than 0"]),
        (moments(0.0, 1.0, 1.0), &["0", "greater than 0"]),
        (moments(1.0, INF, 1.0), &["inf"]),
        (moments(1.0, 1.0, NAN), &["NaN"]),
        (moments(1.0, 1.0, 2.5), &["2.5"]),
        (solids::disc(-2.0, 0.1).err(), &["-2"]),
        (solids::disc(2.0, 0.0).err(), &["0"]),
        (Attitude::from_quaternion([0.0; 4]).err(), &["0"]),
        (Attitude::from_quaternion([1.0, NAN, 0.0, 0.0]).err(), &["NaN"]),
        (Attitude::from_matrix([[1.0, 0.0, 0.0]; 3]).err(), &["1"]),
        (turned(NAN, 0.1, 0.2), &["phi", "NaN"]),
        (turned(0.1, INF, 0.2), &["theta", "inf"]),
        (about(0.0, 1.0), &["0"]),
        (about(1.0, NAN), &["NaN"]),
        (state(NAN), &["NaN"]),
        (GravityAtLever::new(NAN, 0.1).err(), &["NaN"]),
        (GravityAtLever::new(1.0, INF).err(), &["inf"]),
        (GravityAtLever::new(-1.0, 0.1).err(), &["-1"]),
        (Rk4::new(0).err(), &["steps", "at least 1"]),
        (Splitting::new(Scheme::STRANG, 0).err(), &["steps", "at least 1"]),
        (GaussLegendre::new(0).err(), &["steps", "at least 1"]),
        (GaussLegendre::with_precision(9, 0.5).err(), &["0.5", "0.1"]),
        (Dop853::new(0.0).err(), &["tolerance", "0"]),
        (Dop853::new(NAN).err(), &["tolerance", "NaN"]),
        (Dop853::new(1e-9).and_then(|d| d.with_step_limit(0)).err(), &["0"]),
        (Modulus::from_m(1.5).err(), &["m", "1.5"]),
        (Modulus::from_m1(-0.1).err(), &["-0.1"]),
        (Modulus::from_k(NAN).err(), &["NaN"]),
        (carlson::rf(-1.0, 1.0, 2.0).err(), &["-1"]),
        (carlson::rj(1.0, 1.0, 2.0, 0.0).err(), &["p", "0"]),
        (Modulus::from_m(0.5).and_then(|m| legendre::f(INF, m)).err(), &["phi", "inf"]),
        (Modulus::from_m(0.5).and_then(|m| am(NAN, m)).err(), &["NaN"]),
    ]
}

#[test]
fn every_refusal_names_its_numbers() {
    let refusals = refusals();
    assert_eq!(refusals.len(), 32);
    for (k, (error, words)) in refusals.iter().enumerate() {
        let message =
            error.as_ref().unwrap_or_else(|| panic!("number {k} was accepted")).to_string();
        for word in *words {
            assert!(message.contains(word), "number {k}: {message:?} lacks {word:?}");
        }
    }
}

#[test]
fn a_run_that_cannot_be_made_is_refused() -> rotation_dynamics::Result<()> {
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 1.5)?);
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.1, 0.0, 1.0))?;
    let scene = Scene::new(body).with(GravityAtLever::new(1.0, 0.2)?);
    for t_end in [NAN, INF] {
        let runs = [
            Rk4::new(10)?.advance(&scene, 0.0, &start, t_end).err(),
            Dop853::new(1e-9)?.advance(&scene, 0.0, &start, t_end).err(),
            Splitting::new(Scheme::SRKN6, 10)?.advance(&scene, 0.0, &start, t_end).err(),
        ];
        for error in runs {
            let message = error.expect("no end of time").to_string();
            assert!(message.contains(&t_end.to_string()), "{message}");
        }
    }
    assert!(body.state(Attitude::IDENTITY, BodyVector::new(NAN, 0.0, 1.0)).is_err());
    Ok(())
}
