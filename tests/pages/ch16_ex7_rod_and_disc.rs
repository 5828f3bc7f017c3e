//! Exercise 16.7, the pendulum of rod and disc. That simulations confirm the formulas is part of
//! the report: a claim or a limit that differs from its oracle is an error.

use crate::answers::computed;
use kit::simpson;
use pages::ch16_ex7_rod_and_disc::physics::*;
use pages::ch16_ex7_rod_and_disc::*;
use rotation_dynamics::integrators::{Integrator, Rk4};
use rotation_dynamics::math::{cos, sin};
use std::f64::consts::PI;
use support::{Errors, assert_largest};

/// Nothing turns a disc on a smooth axle, and how it turns does not matter to the rod: the
/// swing is the same to the last bit. A little grease is felt.
#[test]
fn a_free_disc_keeps_its_spin() {
    let swing = |drag: f64, spin: f64| {
        let (scene, start) = (two_angles(0.3, drag), [1.0, 0.0, 0.3, spin]);
        Rk4::new(2000).unwrap().advance(&scene, 0.0, &start, 20.0).unwrap().0
    };
    let (still, spinning) = (swing(0.0, 0.0), swing(0.0, 50.0));
    assert_eq!((still[2], spinning[3]), (0.3, 50.0));
    assert_eq!(still[..2], spinning[..2]);
    assert!((swing(1e-2, 50.0)[0] - still[0]).abs() > 1e-3);
}

/// What the pendulum loses is what the axle takes, friction times slip squared; the angular
/// momentum of rod and disc together changes by the torque of gravity alone.
#[test]
fn energy_and_angular_momentum_balance() {
    let (mut errors, mut damaged) = (Errors::of("balances"), Errors::of("slip forgotten"));
    for (share, drag) in [(0.017, 1.0), (0.3, 0.2), (1.0, 5.0)] {
        let run = swung(share, drag, 2.0, 15.0, 1e-15).unwrap();
        let y = |t| run.at(t).unwrap();
        let energy = |[a, u, _, w]: [f64; 4]| 0.5 * (u * u + share * w * w) - cos(a);
        let momentum = |[_, u, _, w]: [f64; 4]| u + share * w;
        let over = |f: &dyn Fn([f64; 4]) -> f64| {
            simpson([0.0, 15.0], 6000, |t| Ok::<_, kit::Error>(f(y(t)))).unwrap()
        };
        let lost = energy(y(0.0)) - energy(y(15.0));
        errors.push(lost - share * drag * over(&|[_, u, _, w]| (u - w) * (u - w)));
        errors.push(momentum(y(15.0)) - momentum(y(0.0)) + over(&|[a, ..]| sin(a)));
        damaged.push(lost - share * drag * over(&|[_, u, _, _]| u * u));
    }
    assert_largest!(errors, 6, @"5.38e-11");
    damaged.exceed(0.01, 3);
}

/// The two conditions on the part that goes along, and where the decay is fastest, against the
/// roots of the cubic equation: what its polynomial leaves at the three of them.
#[test]
fn the_cubic_equation_has_these_roots() {
    let (mut errors, mut damaged) = (Errors::of("polynomial"), Errors::of("no back-action"));
    let cubic = |share: f64, drag: f64, re: f64, im: f64| {
        let square = (re * re - im * im, 2.0 * re * im);
        let cube = (square.0 * re - square.1 * im, square.0 * im + square.1 * re);
        let part = |cube: f64, square: f64, x: f64| cube + (1.0 + share) * drag * square + x;
        let size = f64::hypot(re, im);
        let terms = size.powi(3) + (1.0 + share) * drag * size * size + size + drag;
        f64::hypot(part(cube.0, square.0, re) + drag, part(cube.1, square.1, im)) / terms
    };
    for share in [1e-3, 0.017, 0.5, 2.0] {
        for drag in [1e-2, 0.3, 1.0, worst(share), 4.0, 100.0] {
            let b = Between::new(share, drag);
            errors.push(cubic(share, drag, -b.decay, b.frequency));
            errors.push(cubic(share, drag, -drag * (1.0 + share * b.part), 0.0));
            damaged.push(cubic(share, drag, -drag, 0.0) + cubic(share, drag, 0.0, 1.0));
        }
        let most = Between::new(share, worst(share));
        errors.push(most.decay - 0.25 * share / (1.0 + share).sqrt());
        errors.push(most.part - 1.0 / (2.0 + share));
    }
    assert_largest!(errors, 56, @"1.67e-16");
    damaged.exceed(1e-6, 24);
}

/// A disc freed at its centre makes the swing faster, one freed at its rim slower, for every
/// pendulum of these.
#[test]
fn freed_at_the_rim_it_is_slower() {
    for [radius, disc] in [[0.01, 0.01], [0.2, 1.1], [0.5, 50.0], [1.0, 0.01], [1.0, 50.0]] {
        let at = |key| computed(&EXAMPLE, &format!("--radius={radius} --disc={disc}"), key);
        assert!(at("rim_free") > at("rim_fixed") && at("period_free") < at("period_fixed"));
    }
}

/// Friction instead of a joint: with a hundred steps of Runge and Kutta's method a swing, the
/// angles grow without bound where the table says so.
#[test]
fn a_joint_of_friction_breaks_the_simple_solver() {
    let share = 0.022 / 1.3;
    let sound = [0, 1, 2, 3, 4].map(|power| {
        let scene = two_angles(share, 10.0_f64.powi(power) * worst(share));
        let end = Rk4::new(1000).unwrap().advance(&scene, 0.0, &[1.0, 0.0, 1.0, 0.0], 20.0 * PI);
        end.is_ok_and(|(y, _)| y[1].abs() < 1.0 && y[3].abs() < 1.0)
    });
    assert_eq!(sound, [true, true, false, false, false]);
}
