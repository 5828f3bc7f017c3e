//! The page `how_error_control`: the level, what two runs say of the error of the finer, the
//! condition by a plan of twelve rows, the example and the place of the constants.

use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Integrator, Rk4};
use rotation_dynamics::math::{EPS, pow};
use rotation_dynamics::scene::Scene;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use support::assert_error;

/// Plackett and Burman's twelve rows: eleven that turn, and one of minus signs.
fn sign(row: usize, column: usize) -> f64 {
    const FIRST: [f64; 11] = [1.0, 1.0, -1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, 1.0, -1.0];
    if row == 11 { -1.0 } else { FIRST[(column + 11 - row) % 11] }
}

#[test]
fn twelve_rows_add_up_the_squares() {
    // The mean over all rows, and over all pairs of neighbours, of |sum of signs times vectors|^2.
    let vector = |column: usize| -> [f64; 3] {
        core::array::from_fn(|i| pow(1.7, ((3 * column + 5 * i) % 7) as f64) - 2.0)
    };
    let square = |row: usize, damage: f64| -> f64 {
        (0..3)
            .map(|i| {
                let sum: f64 = (0..10)
                    .map(|c| (if c == 4 { damage } else { 1.0 }) * sign(row, c) * vector(c)[i])
                    .sum();
                sum * sum
            })
            .sum()
    };
    let want: f64 = (0..10).flat_map(|c| vector(c).map(|x| x * x)).sum();
    let mean = |damage| (0..12).map(|row| square(row, damage)).sum::<f64>() / 12.0;
    assert_error!(mean(1.0), want, 1.3 eps);
    assert!((mean(0.9) / want - 1.0).abs() > 1e-3);
    let pairs: f64 =
        (0..12).map(|row| 0.5 * (square(row, 1.0) + square((row + 1) % 12, 1.0))).sum();
    assert_error!(pairs / 12.0, want, 2.5 eps);
}

fn start() -> (RigidBody, State) {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 2.0, 2.5).expect("a body"));
    let rates = BodyVector::new(0.8, 0.4, 0.6);
    let state = body.state(Attitude::IDENTITY, rates).expect("a state");
    (body, state)
}

#[test]
fn condition_is_the_root_of_the_sum_over_inputs() {
    // One input after the other, up and down, instead of rows of all.
    let (body, state) = start();
    let (t, by) = (20.0, 1e-6);
    let end = |moments: [f64; 3], attitude: Attitude, momentum: SpaceVector, t: f64| {
        let [i1, i2, i3] = moments;
        let moments = PrincipalMoments::new(i1, i2, i3).expect("a body");
        let body = RigidBody::new(moments);
        let state = State::new(attitude, momentum).expect("a state");
        let motion = FreeBody::new(moments, attitude, body.angular_velocity(&state));
        motion.expect("a motion").attitude(t)
    };
    let (attitude, momentum) = (state.attitude, state.angular_momentum);
    let moments = body.moments().to_array();
    let unit = |i: usize| core::array::from_fn::<f64, 3, _>(|k| f64::from(u8::from(k == i)));
    let mut squares = Vec::new();
    let mut add = |end: &dyn Fn(f64) -> Attitude| {
        let slope = end(by).angle_to(&end(-by)) / (2.0 * by);
        squares.push(slope * slope);
    };
    for i in 0..3 {
        let axis = BodyVector::from_array(unit(i));
        add(&|by| {
            let turned = attitude.turned_in_body(axis * by).expect("finite");
            end(moments, turned, momentum, t)
        });
        let push = SpaceVector::from_array(unit(i)) * momentum.norm();
        add(&|by| end(moments, attitude, momentum + push * by, t));
        add(&|by| {
            let mut moments = moments;
            moments[i] *= 1.0 + by;
            end(moments, attitude, momentum, t)
        });
    }
    add(&|by| end(moments, attitude, momentum, t * (1.0 + by)));
    let plainly = squares.iter().sum::<f64>().sqrt();
    let solved = Scene::new(body).solve(&state, t, 1e-9).expect("solved");
    let off = (solved.condition / plainly - 1.0).abs();
    assert_error!(off, 2.3e-8);
    // Without the time it is another.
    let without = (plainly * plainly - squares[9]).sqrt();
    assert!((solved.condition / without - 1.0).abs() > 1e-3);
}

/// The end of a free body by so many steps of order 4, and how far it is off.
fn by_rk4(steps: f64) -> (Attitude, f64) {
    let (body, state) = start();
    let scene = Scene::new(body);
    let exact = scene.exact(&state).expect("free").attitude(12.0);
    let (end, _) = Rk4::new(steps.round() as u64)
        .and_then(|method| method.advance(&scene, 0.0, &state, 12.0))
        .expect("smooth");
    (end.attitude, end.attitude.angle_to(&exact))
}

#[test]
fn a_level_is_a_factor_of_forty() {
    // 40^(1/4) times as many steps; with 40^(1/5) times as many it is less.
    let ratio = |order: f64| by_rk4(200.0).1 / by_rk4(200.0 * pow(40.0, 1.0 / order)).1;
    assert_error!((ratio(4.0) / 40.0 - 1.0).abs(), 1.5e-2);
    assert!(ratio(5.0) < 30.0);
}

#[test]
fn distance_of_two_runs_bounds_the_error() {
    // By x/(1 - x), which for a level is a thirty-ninth; the damaged twin: by the distance itself.
    let (coarse, _) = by_rk4(200.0);
    let (fine, error) = by_rk4(200.0 * pow(40.0, 0.25));
    let (x, apart) = (1.0 / 40.0, coarse.angle_to(&fine));
    assert_error!((error / (apart * x / (1.0 - x)) - 1.0).abs(), 1.5e-2);
    assert!(error < 0.03 * apart);
}

#[test]
fn the_example_adds_up() {
    // The heavy body of three moments in the example `accuracy`, for forty seconds to 1e-6.
    let (tolerance, t) = (1e-6, 40.0);
    let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8).expect("a body"));
    let angles = EulerAngles { phi: 0.3, theta: 0.7, zeta: -0.4 };
    let attitude = Attitude::from_euler(angles).expect("an attitude");
    let rates = BodyVector::new(0.3, 0.1, 2.0);
    let state = body.state(attitude, rates).expect("a state");
    let gravity = GravityAtLever::new(1.0, 0.4).expect("gravity");
    let scene = Scene::new(body).with(gravity);
    let solved = scene.solve(&state, t, tolerance).expect("solved");
    // The condition gives back the distance of the two runs.
    let fastest = (2.0 * (body.kinetic_energy(&state) + 2.0 * 0.4) / 0.8).sqrt();
    let turned = fastest * t;
    let change = 0.05 * tolerance / (1.0 + turned);
    let late = body.angular_velocity(&solved.state).norm() * t;
    let distance = change * (solved.condition * solved.condition - late * late).sqrt();
    let floor = 8.0 * EPS * (1.0 + solved.condition);
    let estimate = 2.0 * distance + floor;
    assert!((solved.estimate / estimate - 1.0).abs() < 1e-12);
    assert!(solved.estimate <= tolerance);
    // The damaged twin: no doubling.
    assert!(estimate - distance < 0.9 * solved.estimate);
    // A level apart, and nothing else was run.
    let second = solved.run.steps as f64;
    let first = (solved.work.steps - solved.run.steps) as f64;
    assert!((1.0..1.1).contains(&(second / first / pow(40.0, 1.0 / 16.0))));
    assert_eq!(solved.probes.torques(), 0);
}

/// No file of the error control but this one holds a tuned constant. (What the search for crossings takes
/// stands beside it.)
#[test]
fn tuned_constants_stand_in_one_file() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/accuracy/error_control");
    let mut counts = BTreeMap::new();
    for entry in fs::read_dir(root).expect("the sources") {
        let path = entry.expect("a source").path();
        let code = fs::read_to_string(&path).expect("a source");
        let is_tuned = |line: &&str| {
            let line = line.trim_start().trim_start_matches("pub(super) ");
            line.starts_with("const ") && line.contains(": f64 = ")
        };
        let name = path.file_name().and_then(|name| name.to_str()).expect("a name").to_owned();
        counts.insert(name, code.lines().filter(is_tuned).count());
    }
    counts.retain(|_, count| *count > 0);
    assert!(counts.remove("constants.rs").is_some_and(|count| count > 20));
    assert_eq!(counts.into_keys().collect::<Vec<_>>(), ["crossings.rs"]);
}
