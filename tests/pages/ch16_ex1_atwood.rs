//! Exercise 16.1, Atwood's machine. That Newton's law for each body confirms the formulas is part
//! of the report: a claim that differs from its oracle is an error.

use crate::answers::value;
use kit::But;
use pages::ch16_ex1_atwood::physics::{Grip, Machine};
use pages::ch16_ex1_atwood::*;
use rotation_dynamics::math::log;
use support::{Errors, assert_largest};

fn usual() -> Machine {
    machine(&Parameters::default()).unwrap()
}

/// "Moment of inertia I", and no radius: with the same I the simulated machine moves otherwise for
/// each radius. The sum m1 + m2 + I of kilograms and kg m^2 fits at R = 1 m alone.
#[test]
fn e36_the_radius_of_the_pulley_is_missing() {
    let (mut errors, mut printed) = (Errors::of("with I/R^2"), Errors::of("with I, no radius"));
    for radius in [0.05, 0.1, 0.2, 0.5] {
        let m = machine(&Parameters { radius, ..Parameters::default() }).unwrap();
        let t = m.run(0.0, 1e-13, 10.0).unwrap().transition("arrives").unwrap().t;
        let found = 2.0 * m.height / (t * t);
        errors.push(found - m.closed_form().1[0]);
        printed.push(found - m.gravity / (5.0 + 0.02));
    }
    assert_largest!(errors, 4, @"2.89e-15");
    printed.exceed(0.02, 4);
}

/// Lagrange's way: the work of gravity is the energy of the masses and of the pulley, at every
/// time of the simulation; without the pulley it is not.
#[test]
fn the_energy_balance_holds() {
    let (mut errors, mut damaged) = (Errors::of("energy, J"), Errors::of("without the pulley"));
    let (m, [m1, m2]) = (usual(), usual().masses);
    let run = m.run(0.0, 1e-13, 10.0).unwrap();
    for k in 1..=20 {
        let [way, speed, _, rim] = run.at(run.end_time() * f64::from(k) / 20.0).unwrap().1;
        let (moving, fallen) = (0.5 * (m1 + m2) * speed * speed, (m1 - m2) * m.gravity * way);
        errors.push(moving + 0.5 * m.pulley * rim * rim - fallen);
        damaged.push(moving / fallen - 1.0);
    }
    assert_largest!(errors, 20, @"2.31e-14");
    damaged.exceed(0.28, 20);
}

/// Below the least friction the masses are faster than the rim and faster than with a rope that
/// holds; above it they are one.
#[test]
fn a_rope_that_slips_lets_the_masses_run() {
    let (firm, least) = (usual().closed_form().1[0], value(&EXAMPLE, "mu_least"));
    for part in [0.0, 0.3, 0.9, 0.999, 1.001, 2.0, 10.0] {
        let p = Parameters::default().but(|p| p.friction = part * least);
        let run = machine(&p).unwrap().run(0.0, 1e-13, 10.0).unwrap();
        let (grip, [_, speed, _, rim]) = run.at(1.0).unwrap();
        assert_eq!(grip == Grip::Ahead, part < 1.0);
        assert!(if part < 1.0 { speed > firm && rim < firm } else { (speed - rim).abs() < 1e-14 });
    }
}

/// A pulley that spins takes the rope along until they run as one; what the rubbing takes is the
/// force of the rope times its slip.
#[test]
fn a_spinning_pulley_is_caught() {
    let m = usual();
    let run = m.run(4.0, 1e-13, 10.0).unwrap();
    let catch = run.transition("catches").unwrap();
    let [way, speed, around, rim] = catch.after;
    let energy = |v: f64, w: f64| 2.5 * v * v + 0.5 * m.pulley * w * w;
    let [.., first, second] = m.forces(Grip::Behind, 0.0);
    let lost = energy(0.0, 4.0) + m.gravity * way - energy(speed, rim);
    let mut errors = Errors::of("rubbed, J");
    errors.push((second - first) * (around - way) - lost);
    errors.push(log(second / first).abs() - 0.2 * core::f64::consts::PI);
    errors.push(speed - rim);
    assert_largest!(errors, 3, @"3.55e-15");
    assert!(catch.to == Some(Grip::Holds) && lost > 5.0);
}

/// With a heavy rope the energy of all, with the weight that goes over, decides the speed.
#[test]
fn a_heavy_rope_falls_faster_and_faster() {
    let (mut errors, mut damaged) = (Errors::of("speed, squared"), Errors::of("rope without mass"));
    for rope in [0.01, 0.1, 1.0, 10.0] {
        let m = Machine { rope, grip: FIRM, ..usual() };
        let [way, speed, ..] = m.run(0.0, 1e-13, 10.0).unwrap().transition("arrives").unwrap().before;
        let fallen = m.gravity * way * (1.0 + rope * way);
        errors.push(0.5 * (7.0 + 2.0 * rope) * speed * speed / fallen - 1.0);
        damaged.push(3.5 * speed * speed / (m.gravity * way) - 1.0);
    }
    assert_largest!(errors, 4, @"4.00e-15");
    damaged.exceed(0.006, 4);
}
