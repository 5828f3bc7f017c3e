//! Section 16.2 (1): a cylinder made to precess.

use crate::answers::{computed, confirmed, ledger, refused, value};
use kit::prelude::*;
use pages::ch16_2_precessing_cylinder::*;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::Torque;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, Ode};
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_error, assert_largest};

fn default() -> (Parameters, Cylinder) {
    let p = Parameters::default();
    let body = Cylinder::new(&p).unwrap();
    (p, body)
}

/// Velocities of the grains, from where they are a little before and after.
fn velocities(p: &Parameters, [theta, nod, turn]: [f64; 3]) -> Vec<[SpaceVector; 2]> {
    let h = 1e-5;
    let held = |t: f64| EulerAngles { phi: 0.3 + turn * t, theta: theta + nod * t, zeta: 0.0 };
    let [before, now, after] = [-h, 0.0, h].map(|t| Attitude::from_euler(held(t)).unwrap());
    let grain = |r: BodyVector| {
        [now.to_space(r), (after.to_space(r) - before.to_space(r)) * (0.5 / h)]
    };
    grains(p).map(grain).collect()
}

fn kinetic(p: &Parameters, motion: [f64; 3]) -> f64 {
    velocities(p, motion).iter().map(|[_, v]| 0.5 * p.mass / 48.0 * v.dot(v)).sum()
}

/// The Lagrangian, with theta free: the kinetic energy of the grains.
#[test]
fn eq_16_2_1_lagrangian() {
    let (p, Cylinder { i1, i3, .. }) = default();
    let (mut errors, mut damaged) = (Errors::of("energy"), Errors::of("I1 for I3"));
    for motion in [[0.5, 0.0, 10.0], [1.2, 3.0, 4.0], [2.5, -7.0, 1.0], [0.1, 1.0, -5.0]] {
        let ([theta, nod, turn], sum) = (motion, kinetic(&p, motion));
        let (s, c) = sincos(theta);
        let energy = |i3: f64| 0.5 * (i1 * nod * nod + (i3 * c * c + i1 * s * s) * turn * turn);
        errors.push(energy(i3) / sum - 1.0);
        damaged.push(energy(i1) / sum - 1.0);
    }
    assert_largest!(errors, 4, @"3.33e-9");
    assert!(damaged.largest() > 0.1);
}

/// L_Z from r x p of the grains, and as the derivative of their energy by phi'.
#[test]
fn eq_16_2_1_vertical_momentum() {
    let (p, body) = default();
    let (mut errors, mut damaged) = (Errors::of("L_Z"), Errors::of("I1 phi'"));
    for theta in [0.1, 0.5, 1.0, 1.5, 2.8] {
        let formula = Cylinder { tilt: theta, ..body }.vertical_momentum();
        let pairs = velocities(&p, [theta, 2.0, 10.0]);
        let sum: f64 = pairs.iter().map(|[r, v]| p.mass / 48.0 * r.cross(v).z()).sum();
        let slope = (kinetic(&p, [theta, 2.0, 11.0]) - kinetic(&p, [theta, 2.0, 9.0])) / 2.0;
        errors.push(sum / formula - 1.0);
        errors.push(slope / formula - 1.0);
        damaged.push(body.i1 * 10.0 / formula - 1.0);
    }
    assert_largest!(errors, 10, @"9.20e-9");
    assert!(damaged.largest() > 0.1);
    assert_error!(value(&EXAMPLE, "vertical_momentum") - 0.056_604_216_471_565_4, 1.39e-17);
}

/// The theta equation: the multiplier is minus the derivative of the grains' energy by theta.
#[test]
fn eq_16_2_1_multiplier() {
    let (p, body) = default();
    let (mut errors, mut damaged) = (Errors::of("lambda"), Errors::of("the sign turned"));
    for tilt in [0.1, 0.5, 1.0, 1.5] {
        let at = |theta| kinetic(&p, [theta, 0.0, 10.0]);
        let slope = (at(tilt + 1e-4) - at(tilt - 1e-4)) / 2e-4;
        let lambda = Cylinder { tilt, ..body }.torque();
        errors.push((lambda + slope) / body.i1);
        damaged.push((slope - lambda) / body.i1);
    }
    assert_largest!(errors, 4, @"3.49e-7");
    assert!(damaged.largest() > 10.0);
    assert_error!(value(&EXAMPLE, "torque") + 0.578_511_302_055_429, 1.11e-16);
    // If phi' = L_Z/I is put into the Lagrangian before the derivative is taken, the sign turns.
    let put_in = |theta| 0.5 * body.vertical_momentum() * body.vertical_momentum() / body.about_vertical(theta);
    let slope = (put_in(0.5 + 1e-5) - put_in(0.5 - 1e-5)) / 2e-5;
    assert_error!(slope / body.torque() - 1.0, 8.48e-11);
}

/// E30: the rate stands squared. The forces on the grains are four times as large at twice the
/// rate; the printed form is right at 1 rad/s only. In the library's scene the one torque holds
/// the tilt, and the other does not.
#[test]
fn e30_the_rate_is_squared() {
    let (p, body) = default();
    let (mut errors, mut printed) = (Errors::of("lambda"), Errors::of("without the square"));
    for rate in [0.5, 2.0, 10.0, 40.0] {
        let needed = by_grains(&Parameters { rate, ..p.clone() }).unwrap()[1];
        let lambda = Cylinder { rate, ..body }.torque();
        errors.push(lambda / needed - 1.0);
        printed.push(lambda / rate / needed - 1.0);
    }
    assert_largest!(errors, 4, @"2.22e-16");
    printed.exceed(0.4, 4);
    let rigid = RigidBody::new(PrincipalMoments::symmetric(body.i1, body.i3).unwrap());
    let (s, c) = sincos(p.tilt);
    let omega = BodyVector::new(0.0, 10.0 * s, 10.0 * c);
    let start = rigid.state(body.held(0.0).unwrap(), omega).unwrap();
    let astray = |torque: f64| {
        // zeta stays, so that the level line x is an axis of the body.
        let clamp = Torque::on_body("clamp", move |_, _, _| BodyVector::new(torque, 0.0, 0.0)).smooth();
        let end = Scene::new(rigid).with(clamp).solve(&start, 1.0, 1e-9).unwrap().state;
        end.attitude.angle_to(&body.held(10.0).unwrap())
    };
    assert_error!(astray(body.torque()), 2.83e-14);
    assert!(astray(body.torque() / 10.0) > 1.0);
}

/// However it is let go, the tilt starts with the same acceleration: a long cylinder away from
/// the vertical, a flat one towards it, a balanced one not at all.
#[test]
fn all_three_start_alike() {
    let mut errors = Errors::of("theta'' over I1 theta'' = -lambda, less one");
    for height in [0.3, 0.087, 0.02, 0.0] {
        let body = Cylinder::new(&Parameters { height, ..Parameters::default() }).unwrap();
        for what in [LetGo::Motor, LetGo::Clamp, LetGo::All] {
            let [_, _, pull, _] = body.let_go(what).derivative(0.0, &body.start());
            errors.push(-pull * body.i1 / body.torque() - 1.0);
            assert_eq!(pull > 0.0, height > 0.0866, "{height}");
        }
    }
    assert_largest!(errors, 12, @"1.69e-14");
}

/// Along the three swings: L_Z is kept where nothing drives, the energy of the motor's swing is
/// not, and the free one is the library's free body.
#[test]
fn what_is_kept() {
    let (_, body) = default();
    let run = |what| Dop853::new(1e-15).unwrap().solve(&body.let_go(what), 0.0, &body.start(), 2.0, &[]).unwrap();
    let [motor, clamp, all] = [LetGo::Motor, LetGo::Clamp, LetGo::All].map(run);
    let free = body.freed().unwrap();
    let [mut fork, mut tilts, mut driven] = ["L_Z in the fork", "free tilt", "L_Z, motor"].map(Errors::of);
    for t in times(0.05, 2.0, 39) {
        let momentum = |[theta, _, _, turn]: [f64; 4]| body.about_vertical(theta) * turn;
        fork.push(momentum(clamp.at(t).unwrap()) / body.vertical_momentum() - 1.0);
        driven.push(momentum(motor.at(t).unwrap()) / body.vertical_momentum() - 1.0);
        tilts.push(all.at(t).unwrap()[0] - free.attitude(t).euler_angles().theta);
    }
    assert_largest!(fork, 40, @"1.55e-15");
    assert_largest!(tilts, 40, @"6.66e-16");
    assert!(driven.largest() > 0.5);
}

#[test]
fn other_cylinders_are_confirmed() {
    let bodies = ["", "--height 0", "--height 0.02", "--height 0.0868", "--radius 0.001 --height 2"];
    let motions = ["--tilt 0.01", "--tilt 1.5 --rate 0.1", "--tilt 1.57", "--rate 1000 --mass 0.1"];
    let runs = bodies.iter().flat_map(|body| motions.iter().map(move |motion| format!("{body} {motion}")));
    confirmed(&EXAMPLE, runs, 20);
    confirmed(&EXAMPLE, ["--rate=-10", "--rate=-10 --height=0.02", "--rate=1e-6", "--rate=1e7"], 4);
    // Turned the other way L is reversed, and the torque is the same.
    let pair = |key| ["", "--rate=-10"].map(|flags| computed(&EXAMPLE, flags, key));
    let ([there, here], [torque, same]) = (pair("vertical_momentum"), pair("torque"));
    assert!(there == -here && torque == same && pair("free_time")[0] == pair("free_time")[1]);
}

#[test]
fn what_needs_no_torque_is_refused() {
    refused(&EXAMPLE, [
        ("--height 0.08660254", "like a ball it needs no torque"),
        ("--tilt 1.6", "tilt = 1.6 is not allowed"),
        ("--tilt 0.001 --tolerance 1e-6", "so near to upright or level the swing goes over"),
        ("--tilt=0", "upright and level it needs no torque"),
        ("--rate=0", "at rest the cylinder needs no torque"),
        ("--radius=-1", "radius = -1 is not allowed"),
        ("--rate inf", "not a finite number"),
    ]);
}

/// The card of effects: where the torque of a spring, by bisection, is that of the tilt to which it
/// yields; the damaged twin does not yield. At other rates each line changes as its number does.
#[test]
fn a_clamp_that_yields_holds_what_it_must_there() {
    let (mut errors, mut damaged) = (Errors::of("torque over the rigid one, beyond"), Errors::of("rigid"));
    for (tilt, yields) in [(0.5, 1e-3), (1.2, 0.01), (0.785, 0.02), (0.3, -0.05)] {
        let pull = |x: f64| sin(2.0 * (tilt + yields * x)) / sin(2.0 * tilt);
        let [low, _] = bisect([0.0, 4.0], 0.0, |x| pull(x) > x);
        // A swing is not quite even about it: by the square of the angle.
        errors.push((yielding(tilt, yields).unwrap().0 - low) / (yields * yields));
        damaged.push(low - 1.0);
    }
    assert_largest!(errors, 4, @"0.670");
    damaged.exceed(7e-4, 4);
    let card = ledger(&EXAMPLE, "");
    assert_eq!(card.len(), 3);
    // What weighs counts as 1/rate^2, what turns as 1/rate; what yields as rate^2.
    let slow = ledger(&EXAMPLE, "--rate=5");
    let grow = [0, 1, 2].map(|i| slow[i][1] / card[i][1]);
    assert!(grow.iter().zip([4.0, 0.25, 2.0]).all(|(a, b): (&f64, f64)| (a / b - 1.0).abs() < 0.05), "{grow:?}");
    // A clamp as weak as the cylinder's pull on it cannot be weighed so.
    assert_eq!(ledger(&EXAMPLE, "--rate=200").len(), 2);
}
