//! Exercise 16.1, Atwood's machine. That Newton's law for each body confirms the formulas is part
//! of the report: a claim that differs from its oracle is an error.

use crate::answers::{confirmed, errors_of, number, refused, value};
use kit::But;
use pages::ch16_ex1_atwood::machine::{Forces, Grip, Machine};
use pages::ch16_ex1_atwood::*;
use rotation_dynamics::math::log;
use support::{Errors, assert_largest};

fn usual() -> Machine {
    machine(&Parameters::default()).unwrap()
}

/// The reference case `st-atwood`, rounded from 25 digits.
#[test]
fn the_reference_case_is_met() {
    assert_largest!(errors_of(&EXAMPLE, [("a", 1.400_95), ("t1", 25.217_1), ("t2", 22.415_2)]), 3, @"0");
    assert_eq!(number(&EXAMPLE, "--inertia=0.08 --radius=0.2 --m1=3 --m2=2", "a"), 1.40095);
}

#[test]
fn other_machines_are_confirmed() {
    let runs = [
        "--friction=0", "--friction=0.02", "--inertia=1e-6", "--inertia=5", "--m1=300 --spin=5",
        "--m2=0.001", "--spin=300 --rope=5", "--tolerance=1e-3", "--rope=1e-9 --height=1000",
        "--height=0.001 --gravity=1000 --tolerance=1e-15",
    ];
    confirmed(&EXAMPLE, runs, 10);
    // The masses exchanged, and equal ones.
    let plain = runs.iter().filter(|run| !run.contains("--m"));
    let turned = |run: &&str| ["--m1=2 --m2=3", "--m1=2"].map(|masses| format!("{run} {masses}"));
    confirmed(&EXAMPLE, plain.flat_map(turned), 16);
    let spins = ["0", "-40", "-5 --friction=1", "-300 --m1=2 --m2=3", "-9 --m1=2"];
    confirmed(&EXAMPLE, spins.map(|spin| format!("--spin={spin}")), 5);
    let ends = ["--inertia=0", "--rope=0", "--m2=2.9999999", "--m2=1e-8", "--friction=10"];
    confirmed(&EXAMPLE, ends, 5);
}

/// With the masses exchanged and the pulley spinning the other way all is mirrored.
#[test]
fn exchanged_masses_mirror_the_motion() {
    for more in ["", "--friction=0.01"] {
        let [one, other] = ["--m1=3 --m2=2 --spin=40", "--m1=2 --m2=3 --spin=-40"]
            .map(|flags| format!("{flags} {more}"));
        let pair = |left: &str, right: &str| {
            [number(&EXAMPLE, &one, left), number(&EXAMPLE, &other, right)]
        };
        for key in ["a", "alpha", "naive_a"] {
            let [there, here] = pair(key, key);
            assert!(there > 0.1 && here == -there, "{key}: {there} {here}");
        }
        for (left, right) in [("t1", "t2"), ("t2", "t1"), ("time", "time"), ("mu_least", "mu_least")] {
            let [there, here] = pair(left, right);
            assert_eq!(there, here, "{left}");
        }
    }
}

#[test]
fn what_is_no_machine_is_refused() {
    refused(&EXAMPLE, [
        ("--radius=-0.1", "radius = -0.1 is not allowed"),
        ("--friction=-0.2", "friction = -0.2 is not allowed"),
        ("--m2=0", "m2 = 0 is not allowed"),
        ("--m1=1e-12", "lighter mass/heavier mass = 5e-13 is not allowed"),
        ("--inertia=-1", "inertia = -1 is not allowed"),
        ("--radius=1e-9", "a heavier pulley hardly turns"),
        ("--m2=3 --with air", "the acceleration of a rope that slips or rests, with air = 0"),
    ]);
}

/// "Moment of inertia I", and no radius: with the same I the simulated machine moves otherwise for
/// each radius. The sum m1 + m2 + I of kilograms and kg m^2 fits at R = 1 m alone.
#[test]
fn e36_the_radius_of_the_pulley_is_missing() {
    let (mut errors, mut printed) = (Errors::of("with I/R^2"), Errors::of("with I, no radius"));
    for radius in [0.05, 0.1, 0.2, 0.5] {
        let m = machine(&Parameters { radius, ..Parameters::default() }).unwrap();
        let run = m.run(0.0, 1e-13, 10.0).unwrap();
        let arrives = run.transition("arrives").unwrap();
        let found = 2.0 * m.height / (arrives.t * arrives.t);
        errors.push(found - Forces::new(&m).acceleration);
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
    let m = usual();
    let run = m.run(0.0, 1e-13, 10.0).unwrap();
    for k in 1..=20 {
        let [way, speed, _, rim] = run.at(run.end_time() * f64::from(k) / 20.0).unwrap().1;
        let ([m1, m2], fallen) = (m.masses, (m.masses[0] - m.masses[1]) * m.gravity * way);
        let moving = 0.5 * (m1 + m2) * speed * speed;
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
    let firm = Forces::held(&usual()).acceleration;
    let least = value(&EXAMPLE, "mu_least");
    let mut ran = 0;
    for part in [0.0, 0.3, 0.9, 0.999, 1.001, 2.0, 10.0] {
        let p = Parameters::default().but(|p| p.friction = part * least);
        let run = machine(&p).unwrap().run(0.0, 1e-13, 10.0).unwrap();
        let (grip, [_, speed, _, rim]) = run.at(1.0).unwrap();
        assert_eq!(grip == Grip::Ahead, part < 1.0);
        assert!(if part < 1.0 { speed > firm && rim < firm } else { (speed - rim).abs() < 1e-14 });
        ran += 1;
    }
    assert_eq!(ran, 7);
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
    let [first, second] = m.forces(Grip::Behind, 0.0).tensions;
    let rubbed = (second - first) * (around - way);
    let lost = energy(0.0, 4.0) + m.gravity * way - energy(speed, rim);
    let mut errors = Errors::of("rubbed, J");
    errors.push(rubbed - lost);
    errors.push(log(second / first).abs() - 0.2 * core::f64::consts::PI);
    errors.push(speed - rim);
    assert_largest!(errors, 3, @"3.55e-15");
    assert_eq!(catch.to, Some(Grip::Holds));
    assert!(lost > 5.0);
}

/// With a heavy rope the energy of all, with the weight that goes over, decides the speed.
#[test]
fn a_heavy_rope_falls_faster_and_faster() {
    let (mut errors, mut damaged) = (Errors::of("speed, squared"), Errors::of("rope without mass"));
    for rope in [0.01, 0.1, 1.0, 10.0] {
        let m = Machine { rope, grip: FIRM, ..usual() };
        let run = m.run(0.0, 1e-13, 10.0).unwrap();
        let [way, speed, ..] = run.transition("arrives").unwrap().before;
        let fallen = m.gravity * way * (1.0 + rope * way);
        errors.push(0.5 * (7.0 + 2.0 * rope) * speed * speed / fallen - 1.0);
        damaged.push(3.5 * speed * speed / (m.gravity * way) - 1.0);
    }
    assert_largest!(errors, 4, @"4.00e-15");
    damaged.exceed(0.006, 4);
}
