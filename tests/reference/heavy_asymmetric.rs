//! Splittings and general methods on heavy bodies with three different moments, for
//! which there is no closed form.

use super::case::{self, Case, Outcome};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::error::Result;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::BodyAxes;
use rotation_dynamics::integrators::{Dop853, GaussLegendre, Integrator, Scheme, Splitting};
use rotation_dynamics::scene::Scene;
use std::path::{Path, PathBuf};

type Heavy = Scene<((), GravityAtLever)>;

struct Method {
    name: &'static str,
    /// Just above the largest factor K measured.
    bound: f64,
    /// The angle (rad) that the fastest rotation makes in a step.
    angle: f64,
    run: fn(&Heavy, &State, f64, u64) -> Result<State>,
}

const METHODS: &[Method] = &[
    Method {
        name: "SRKN 14a",
        bound: 6.8,
        angle: 0.16,
        run: |scene, start, t, steps| {
            let method = Splitting::new(Scheme::SRKN14, steps)?;
            Ok(method.advance(scene, 0.0, start, t)?.0)
        },
    },
    Method {
        name: "DOP853",
        bound: 73.0,
        angle: 0.1,
        run: |scene, start, t, _| Ok(Dop853::new(1e-15)?.advance(scene, 0.0, start, t)?.0),
    },
    Method {
        name: "Gauss-Legendre",
        bound: 4.4,
        angle: 0.5,
        run: |scene, start, t, steps| {
            Ok(GaussLegendre::new(steps)?.advance(scene, 0.0, start, t)?.0)
        },
    },
    Method {
        name: "Gauss-Legendre, body",
        bound: 2.1,
        angle: 0.5,
        run: |scene, start, t, steps| {
            let method = GaussLegendre::new(steps)?;
            Ok(method.advance(&BodyAxes::new(scene), 0.0, start, t)?.0)
        },
    },
];

fn own_file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/heavy_asymmetric.json")
}

/// The case, run to times multiplied by `damage`, for the test of the test.
fn judge(case: &Case, method: &Method, damage: f64) -> Result<Outcome> {
    let mut outcome = Outcome::new();
    let [i1, i2, i3] = case.input_vector("I");
    let [phi, theta, zeta] = case.input_vector("euler0");
    let gravity = GravityAtLever::new(case.input("weight"), case.input("lever"))?;
    let scene = Scene::new(RigidBody::new(PrincipalMoments::new(i1, i2, i3)?)).with(gravity);
    let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
    let rates = BodyVector::from_array(case.input_vector("omega0"));
    let start = scene.body().state(attitude, rates)?;
    let least = i1.min(i2).min(i3);
    let fastest =
        start.angular_momentum.norm() / least + 2.0 * (gravity.moment().abs() / least).sqrt();
    for sample in case.samples() {
        let t = sample.t() * damage;
        let steps = (fastest * t.abs() / method.angle).ceil().max(1.0);
        let end = (method.run)(&scene, &start, t, steps as u64)?;
        let fields: [(&str, Vec<f64>); 3] = [
            ("R", end.attitude.matrix().concat()),
            (
                "omega",
                scene.body().angular_velocity(&end).to_array().to_vec(),
            ),
            ("L_space", end.angular_momentum.to_array().to_vec()),
        ];
        for (field, got) in fields {
            let want = sample.values(field);
            outcome.compare_field(&sample, field, t, &got, &want);
        }
    }
    Ok(outcome)
}

#[test]
fn heavy_asymmetric_bodies_within_their_condition() {
    let (files, own) = case::files();
    let files = if own { vec![own_file()] } else { files };
    let mut failures = Vec::new();
    let mut ran = 0;
    for case in files.iter().flat_map(|file| case::read(file)) {
        if case.kind != "heavy_asymmetric" {
            continue;
        }
        for method in METHODS {
            let outcome = judge(&case, method, 1.0)
                .unwrap_or_else(|error| panic!("{} by {}: {error}", case.id, method.name));
            println!(
                "{:<28} {:<16} K = {:>6.2} of {} ({}, {} values)",
                case.id, method.name, outcome.factor, method.bound, outcome.worst, outcome.compared
            );
            if outcome.compared == 0 || !matches!(outcome.factor, k if k <= method.bound) {
                failures.push(format!("{} by {}: {outcome:?}", case.id, method.name));
            }
            ran += 1;
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    if own {
        assert_eq!(ran, 49 * METHODS.len());
    }
}

/// A run too long by 1e-11 is seen.
#[test]
fn a_damaged_time_is_seen() {
    let mut ran = 0;
    for case in case::read(&own_file()) {
        let outcome = judge(&case, &METHODS[0], 1.0 + 1e-11).expect("a case that runs");
        // Measured: at least 6394 (spin-3, where errors on the way count more).
        assert!(outcome.factor > 6000.0, "{}: {outcome:?}", case.id);
        ran += 1;
    }
    assert_eq!(ran, 49);
}
