//! The dial on the cases with 25 digits: free bodies and tops by their closed forms and
//! by stepping, heavy asymmetric bodies by stepping.

use super::case::{self, Case};
use super::honesty::TOLERANCES;
use rotation_dynamics::accuracy::{Solvable, Solved};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::EPS;
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};
use std::path::Path;

/// What a file's cases came to.
#[derive(Debug, Default)]
struct Tally {
    delivered: usize,
    refused: usize,
    /// The largest delivered error in units of the request.
    worst: f64,
    /// The largest error of a closed form in units of eps (1 + condition).
    factor: f64,
    /// The reported condition over that of the reference, least and most.
    condition: [f64; 2],
    failures: Vec<String>,
}

fn start_of(case: &Case, moments: PrincipalMoments) -> Result<(RigidBody, State)> {
    let [phi, theta, zeta] = case.input_vector("euler0");
    let body = RigidBody::new(moments);
    let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
    let rates = BodyVector::from_array(case.input_vector("omega0"));
    let start = body.state(attitude, rates)?;
    Ok((body, start))
}

fn moments(case: &Case) -> [f64; 3] {
    match case.optional("I1") {
        Some(i1) => [i1, i1, case.input("I3")],
        None => case.input_vector("I"),
    }
}

/// The solver of a case; `stepped`: without its closed form.
type Solve = Box<dyn Fn(f64, f64) -> Result<Solved>>;

fn solver<E: Solvable + 'static>(scene: Scene<E>, start: State, stepped: bool) -> Solve {
    Box::new(move |t_end, tolerance| {
        if stepped {
            scene.solve_by_stepping(&start, t_end, tolerance)
        } else {
            scene.solve(&start, t_end, tolerance)
        }
    })
}

fn of(case: &Case, stepped: bool) -> Result<Solve> {
    match case.kind.as_str() {
        "free_body" => {
            let [i1, i2, i3] = case.input_vector("I");
            let (body, start) = start_of(case, PrincipalMoments::new(i1, i2, i3)?)?;
            Ok(solver(Scene::new(body), start, stepped))
        }
        "top_si" => {
            let moments = PrincipalMoments::symmetric(case.input("I1"), case.input("I3"))?;
            let (body, start) = start_of(case, moments)?;
            let gravity = GravityAtLever::new(case.input("m") * case.input("g"), case.input("l"))?;
            Ok(solver(Scene::new(body).with(gravity), start, stepped))
        }
        _ => {
            let [i1, i2, i3] = case.input_vector("I");
            let (body, start) = start_of(case, PrincipalMoments::new(i1, i2, i3)?)?;
            let gravity = GravityAtLever::new(case.input("weight"), case.input("lever"))?;
            Ok(solver(Scene::new(body).with(gravity), start, stepped))
        }
    }
}

/// The cases of these kinds, at every sample up to `reach` and every tolerance.
fn tally(file: &str, kinds: &[&str], stepped: bool, reach: f64) -> Tally {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    let mut tally = Tally {
        condition: [f64::INFINITY, 0.0],
        ..Tally::default()
    };
    for case in case::read(&data.join(file)) {
        if !kinds.contains(&case.kind.as_str()) {
            continue;
        }
        let Ok(solve) = of(&case, stepped) else {
            continue;
        };
        for sample in case.samples() {
            let t = sample.t();
            if t.abs() > reach {
                continue;
            }
            let entries: Vec<f64> = sample.all("R").iter().map(|r| r.to_f64()).collect();
            let matrix = [0, 3, 6].map(|i| [entries[i], entries[i + 1], entries[i + 2]]);
            let exact = Attitude::from_matrix(matrix).expect("a rotation");
            for tolerance in TOLERANCES {
                judge(
                    &case,
                    &mut tally,
                    solve(t, tolerance),
                    (t, tolerance),
                    exact,
                    sample.condition("R"),
                );
            }
        }
    }
    tally
}

fn judge(
    case: &Case,
    tally: &mut Tally,
    answer: Result<Solved>,
    (t, tolerance): (f64, f64),
    exact: Attitude,
    condition: f64,
) {
    let id = &case.id;
    match answer {
        Ok(solved) => {
            tally.delivered += 1;
            let error = exact.angle_to(&solved.state.attitude);
            tally.worst = tally.worst.max(error / tolerance);
            if error.is_nan() || error > tolerance {
                let failure = format!(
                    "{id} at {t}: {tolerance:e} asked, {error:e} delivered, {solved:?}, {condition:e}"
                );
                tally.failures.push(failure);
            }
            if solved.run.samples > 0 {
                tally.factor = tally.factor.max(error / EPS / (1.0 + solved.condition));
            }
            if condition > 0.0 {
                let ratio = solved.condition / condition;
                tally.condition = [tally.condition[0].min(ratio), tally.condition[1].max(ratio)];
            }
        }
        Err(Error::BeyondCondition { attainable, .. }) => {
            tally.refused += 1;
            // What the reference's own condition lets a careful method reach.
            // A state holds L to eps |L|, and so a rate to eps |L|/I at best.
            let [i1, i2, i3] = moments(case);
            let thin = i1.max(i2).max(i3) / i1.min(i2).min(i3);
            if attainable <= tolerance || 200.0 * EPS * (1.0 + condition) * thin < tolerance {
                tally.failures.push(format!(
                    "{id} at {t}: {tolerance:e} refused for {attainable:e}, {condition:e}"
                ));
            }
        }
        Err(error) => tally
            .failures
            .push(format!("{id} at {t}, {tolerance:e}: {error}")),
    }
}

fn passed(tally: &Tally) {
    println!("{tally:?}");
    assert!(tally.failures.is_empty(), "{}", tally.failures.join("\n"));
    assert!(tally.worst <= 1.0);
}

#[test]
fn closed_forms_deliver_on_the_free_bodies() {
    passed(&tally("reference.json", &["free_body"], false, 1e300));
    passed(&tally("free_body_hard.json", &["free_body"], false, 1e300));
}

#[test]
fn closed_forms_deliver_on_the_tops() {
    passed(&tally("reference.json", &["top_si"], false, 1e300));
    passed(&tally("heavy_top_hard.json", &["top_si"], false, 1e300));
}

#[test]
fn stepping_delivers_on_free_bodies_and_tops() {
    passed(&tally(
        "reference.json",
        &["free_body", "top_si"],
        true,
        300.0,
    ));
}

#[test]
fn stepping_delivers_on_heavy_asymmetric_bodies() {
    passed(&tally(
        "heavy_asymmetric.json",
        &["heavy_asymmetric"],
        false,
        1e300,
    ));
}
