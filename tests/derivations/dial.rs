//! The page `how_dial`: the level, what two runs say of the error of the finer, and the condition
//! by a plan of twelve rows.

use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Integrator, Rk4};
use rotation_dynamics::math::{exp, log, pow};
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_error};

/// Plackett and Burman's twelve rows: eleven that turn, and one of minus signs.
fn sign(row: usize, column: usize) -> f64 {
    const FIRST: [f64; 11] = [1.0, 1.0, -1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, 1.0, -1.0];
    if row == 11 {
        -1.0
    } else {
        FIRST[(column + 11 - row) % 11]
    }
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
    let pairs: f64 = (0..12)
        .map(|row| 0.5 * (square(row, 1.0) + square((row + 1) % 12, 1.0)))
        .sum();
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

#[test]
fn a_level_is_a_factor_of_forty() {
    let (body, state) = start();
    let scene = Scene::new(body);
    let motion = scene.exact(&state).expect("free");
    let t = 12.0;
    let error = |steps: u64| {
        let (end, _) = Rk4::new(steps)
            .and_then(|method| method.advance(&scene, 0.0, &state, t))
            .expect("smooth");
        end.attitude.angle_to(&motion.attitude(t))
    };
    // 40^(1/4) times as many steps; with 40^(1/5) times as many it is less.
    let coarse = 200.0;
    let ratio = |order: f64| error(200) / error((coarse * pow(40.0, 1.0 / order)).round() as u64);
    assert_error!((ratio(4.0) / 40.0 - 1.0).abs(), 1.5e-2);
    assert!(ratio(5.0) < 30.0);
}

/// The estimate over the error of runs whose errors fall as the order says, the last finer by so
/// many levels, where only a part of the order is trusted.
fn caution(trust: f64, levels: f64) -> f64 {
    let (apart, left) = (pow(40.0, levels) - 1.0, pow(40.0, -trust * levels));
    2.0 * apart * left / (1.0 - left)
}

#[test]
fn distance_of_two_runs_bounds_the_error() {
    // e = d x/(1-x) for an error that falls by x; and what the next run must be finer by.
    let mut errors = Errors::of("error from the distance");
    let mut damaged = Errors::of("error as the distance");
    let mut ahead = Errors::of("budget left by the next run");
    for x in [0.01, 0.1, 0.3, 0.4] {
        let (before, now) = (3e-5, 3e-5 * x);
        let apart = before - now;
        errors.push_at(apart * x / (1.0 - x) / now - 1.0, x);
        damaged.push_at(apart / now - 1.0, x);
        for budget in [1e-7, 1e-9] {
            let trust = 0.5;
            let next = apart * x;
            let left = 0.35 * budget / next;
            let decay = -log(x);
            let levels = log((1.0 + left) / left) / (trust * decay);
            let fall = exp(-trust * decay * levels);
            ahead.push_at(2.0 * next * fall / (1.0 - fall) / budget - 0.7, x);
        }
    }
    errors.attain(2.2e-16..=2.3e-16, 4);
    damaged.exceed(0.4, 4);
    ahead.attain(8.8e-16..=8.9e-16, 8);
}

#[test]
fn what_is_trusted_less_is_estimated_larger() {
    // Splittings, DOP853, Gauss-Legendre, which must go two levels to be believed at all.
    assert_error!(caution(0.5, 1.0) / 15.0 - 1.0, 2.3e-2);
    assert_error!(caution(0.33, 1.0) / 33.0 - 1.0, 1e-2);
    assert_error!(caution(0.12, 2.0) / 2200.0 - 1.0, 2.1e-2);
    assert!(pow(40.0, -0.12) > 0.5 && pow(40.0, -0.24) < 0.5);
}
