//! Rolling: each formula of the page by a route of its own, the slips of the notes, and far
//! from the notes' numbers. That simulations confirm the claims is part of the report.

use crate::answers::{computed, confirmed, errors_of, ledger, refused, value};
use core::f64::consts::{FRAC_PI_2, PI, TAU};
use pages::ch15_2_rolling::*;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::integrators::{Dop853, Integrator};
use rotation_dynamics::math::{atan2, cos, hypot, sincos};
use support::{Errors, assert_error, assert_largest};

/// Cycle wheels from a caster to a wheel at the end of a long shaft.
fn wheels() -> [Parameters; 4] {
    [(0.3, 0.5), (0.3, 0.01), (0.02, 1.0), (1.0, 1.0)].map(|(radius, shaft)| Parameters {
        radius,
        shaft,
        ..Parameters::default()
    })
}

fn at(x: f64, y: f64, z: f64) -> SpaceVector {
    SpaceVector::new(x, y, z)
}

#[test]
fn the_instances_of_the_notes_come_out() {
    assert_largest!(errors_of(&EXAMPLE, [
        ("wheel_speed", 7.0),
        ("cycloid", 2.8),
        ("coin_part", PI),
        ("coin_circuit", 12.566_370_614_359_172),
        ("spin", -3.333_333_333_333_333_3),
        ("net_rate", 3.887_301_263_230_201_4),
        ("across", 1.438_276_615_812_609),
        ("along", 2.632_747_685_671_118),
    ]), 8, @"2.06");
    assert_eq!(value(&EXAMPLE, "cycle_contact"), 0.0);
}

#[test]
fn confirmed_far_from_the_notes() {
    let wheels = ["0.001", "0.3", "10"].map(|r| format!("--wheel-radius={r} --wheel-rate=0.1"));
    let coins = ["0.01", "3", "100"].map(|o| format!("--orbit={o} --coin-radius=0.5"));
    let cycles = [(1.0, 0.01), (0.1, 5.0), (2.0, 200.0), (0.01, 0.02), (0.001, 0.9)];
    let cycles = cycles.map(|(r, a)| format!("--radius={r} --shaft={a} --rate=31"));
    let cylinders = ["0.001", "1.57", "3.1"].map(|t| format!("--tilt={t} --cylinder-rate=900"));
    let steps = ["1e-15", "1e-9", "1e-6"].map(|e| format!("--tolerance={e}"));
    let runs = wheels.into_iter().chain(coins).chain(cycles);
    confirmed(&EXAMPLE, runs.chain(cylinders).chain(steps), 17);
}

#[test]
fn what_does_not_roll_is_refused() {
    refused(&EXAMPLE, [
        ("--radius=0", "radius = 0 is not allowed"),
        ("--wheel-rate=0", "at rest nothing rolls"),
        ("--tilt=4", "tilt = 4 is not allowed"),
        ("--orbit=nan", "not a finite number"),
        ("--shaft=900 --radius=0.01", "shaft/radius = 90"),
        ("--tolerance=1", "tolerance = 1 is not allowed"),
    ]);
}

/// V = omega R without calculus: polygons tip along, a side for a turn of 2 pi over their
/// number, and what is missing shrinks as its square.
#[test]
fn eq_15_2_wheel_speed() {
    let mut errors = Errors::of("speed over omega R, less 1, in units of pi^2/6 sides^2");
    let mut damaged = Errors::of("the same for V = 2 omega R");
    for sides in [100, 200, 400, 800] {
        let (places, _) = tipping(sides);
        let (speed, unit) = (places[sides as usize].x() / TAU, f64::from(sides * sides));
        errors.push((1.0 - speed) * unit / (PI * PI / 6.0) - 1.0);
        damaged.push(2.0 - speed);
    }
    assert_largest!(errors, 4, @"4.93e-5");
    damaged.exceed(0.9, 4);
}

/// The point that touches moves at (Omega_orbit - Omega_spin) R: from the places of that point
/// of a coin that is carried round and turned at the same time.
#[test]
fn eq_15_2_coin_contact_velocity() {
    let (mut errors, mut damaged) = (Errors::of("velocity of the contact"), Errors::of("sum"));
    for (orbit, spin) in [(1.0, 1.0), (1.0, 0.0), (0.5, 2.0), (-1.0, 1.5)] {
        let place = |t: f64| {
            let ((s, c), (rs, rc)) = (sincos(orbit * t), sincos(PI + (orbit + spin) * t));
            (2.0 * c + rc, 2.0 * s + rs)
        };
        let h = 1e-4;
        let v = (place(h).1 - place(-h).1) / (2.0 * h);
        errors.push(v - (orbit - spin));
        damaged.push(v - (2.0 * orbit + spin));
    }
    assert_largest!(errors, 4, @"2.56e-8");
    damaged.exceed(0.9, 4);
}

/// As much as it slips it turns less: carried round it turns once, and at twice that not at all.
#[test]
fn a_coin_that_slips_turns_less() {
    let slips = ["0.1", "0.25", "1", "1.5", "2"];
    confirmed(&EXAMPLE, slips.map(|slip| format!("--with slip={slip}")), 5);
    let turned = |slip: &str| computed(&EXAMPLE, &format!("--with slip={slip}"), "slid_circuit");
    let (mut errors, mut damaged) = (Errors::of("turned in the circuit"), Errors::of("more, not less"));
    for (slip, turns) in [("0.5", 1.5), ("1", 1.0), ("2", 0.0)] {
        errors.push(turned(slip) - turns * TAU);
        damaged.push(turned(slip) - (4.0 - turns) * TAU);
    }
    assert_largest!(errors, 3, @"0");
    damaged.exceed(6.0, 3);
    let runs = [("--with slip=0", "slip = 0 is not allowed"), ("--with slip=2.1", "at most 2")];
    refused(&EXAMPLE, runs);
}

/// theta_net = 2 theta_orbit for polygons: tipped about a common corner until the next sides
/// lie on each other, the moving one turns by what the two corners leave open.
#[test]
fn eq_15_2_coin_net_turn() {
    let mut errors = Errors::of("turn of a polygon on its like, less 4 pi");
    let mut damaged = Errors::of("the same, less 2 pi");
    for sides in [3, 4, 6, 12, 100] {
        let corner = |k: i32, mirrored: f64| {
            let (s, c) = sincos((f64::from(k) + 0.5) * TAU / f64::from(sides));
            let edge = cos(0.5 * TAU / f64::from(sides));
            // The moving one is the fixed one's image in their common side.
            (edge + mirrored * (c - edge), s)
        };
        // From the corner that stays, to the next corner of either.
        let direction = |mirrored| {
            let ((x, y), (px, py)) = (corner(1, mirrored), corner(0, mirrored));
            atan2(y - py, x - px)
        };
        let step = (direction(1.0) - direction(-1.0)).rem_euclid(TAU);
        errors.push(step * f64::from(sides) - 2.0 * TAU);
        damaged.push(step * f64::from(sides) - TAU);
    }
    assert_largest!(errors, 5, @"2.17e-13");
    damaged.exceed(1.0, 5);
}

/// Omega Z + Omega_S rho, for a wheel that slips or not: from where it is before and after.
#[test]
fn eq_15_5_14_angular_velocities_add() {
    let (mut errors, mut damaged) = (Errors::of("sum"), Errors::of("difference"));
    for p in wheels() {
        for spin in [-3.0, -0.5, 0.0, 2.0] {
            let found = measured(|t| cycle_turned(&p, spin, t), 1.0 / hypot(p.rate, spin));
            let found = found.expect("an angular velocity");
            errors.push((found - at(spin, 0.0, p.rate)).norm());
            damaged.push((found - at(spin, 0.0, -p.rate)).norm());
        }
    }
    assert_largest!(errors, 16, @"5.50e-13");
    damaged.exceed(3.9, 16);
}

/// Omega_S = -Omega a/R: the spin with which the lowest point stands still, by its places.
#[test]
fn eq_15_5_15_spin_of_the_cycle_wheel() {
    let (mut errors, mut damaged) = (Errors::of("spin"), Errors::of("radius over shaft"));
    for p in wheels() {
        let found = spin_without_slip(&p).expect("a spin");
        errors.add(found, -p.rate * p.shaft / p.radius, found.abs());
        damaged.add(found, p.rate * p.shaft / p.radius, found.abs());
        // Slid along without spin, it rubs at the speed of the hub.
        errors.add(slip(&p, 0.0).expect("a speed"), p.rate * p.shaft, 1.0);
    }
    assert_largest!(errors, 8, @"3.19e-12");
    damaged.exceed(1.9, 4);
}

/// (15.5.16) carries the attitude to where the two turns put it.
#[test]
fn eq_15_5_16_carries_the_wheel_round() {
    let (mut errors, mut damaged) = (Errors::of("attitude"), Errors::of("other sense"));
    for p in wheels() {
        let turned = cycle_turned(&p, -p.rate * p.shaft / p.radius, 1.3).expect("an attitude");
        let carried = |sign: f64| {
            let rho = |t: f64| at(cos(p.rate * t), sincos(p.rate * t).0, 0.0);
            let law = carried(|t| cycle_rate(&p, rho(t) * sign));
            let start = upright().expect("upright").quaternion();
            let run = Dop853::new(1e-14).expect("a method");
            let (q, _) = run.advance(&law, 0.0, &start, 1.3).expect("a run");
            Attitude::from_quaternion(q).expect("an attitude").angle_to(&turned)
        };
        errors.push(carried(1.0));
        damaged.push(carried(-1.0));
    }
    assert_largest!(errors, 4, @"4.75e-14");
    damaged.exceed(0.05, 4);
}

/// (Omega sin theta, Omega cos theta) on the cylinder's axes, from where it is.
#[test]
fn eq_15_5_18_components_on_the_cylinder() {
    let (mut errors, mut damaged) = (Errors::of("components"), Errors::of("exchanged"));
    for tilt in [0.1, 0.5, 1.5, 3.0] {
        let p = Parameters { tilt, ..Parameters::default() };
        let found = measured(|t| cylinder(&p, t), 1.0 / p.cylinder_rate).expect("a rate");
        let found = cylinder(&p, 0.0).expect("an attitude").to_body(found);
        let (s, c) = sincos(tilt);
        errors.push((found - BodyVector::new(0.0, s, c) * p.cylinder_rate).norm());
        damaged.push((found - BodyVector::new(0.0, c, s) * p.cylinder_rate).norm());
    }
    assert_largest!(errors, 4, @"8.90e-16");
    damaged.exceed(1.0, 4);
}

/// How fast a direction that is fixed in the cycle wheel turns in a picture with these axes.
fn seen(p: &Parameters, fixed: SpaceVector, [right, up]: [SpaceVector; 2]) -> f64 {
    let spin = -p.rate * p.shaft / p.radius;
    let angle = |t: f64| {
        let now = cycle_turned(p, spin, t).expect("an attitude");
        let start = upright().expect("upright");
        let line = now.to_space(start.to_body(fixed));
        atan2(line.dot(&up), line.dot(&right))
    };
    (angle(1e-6) - angle(-1e-6)) / 2e-6
}

#[test]
fn e08_the_view_from_above_shows_the_precession() {
    let p = Parameters::default();
    let (x, y, z) = (at(1.0, 0.0, 0.0), at(0.0, 1.0, 0.0), at(0.0, 0.0, 1.0));
    let (above, side) = (seen(&p, x, [x, y]), seen(&p, z, [y, z]));
    // From above the shaft's direction turns at Omega; from outside a spoke turns at Omega_S.
    assert!((above - 2.0).abs() < 1e-9 && (side + 10.0 / 3.0).abs() < 1e-9);
    // As printed the two are exchanged.
    assert!((above + 10.0 / 3.0).abs() > 1.0 && (side - 2.0).abs() > 1.0);
}

#[test]
fn e09_the_sign_of_zeta() {
    let p = Parameters::default();
    let spin = -p.rate * p.shaft / p.radius;
    // The rate of zeta with the axis z along -rho, and along rho.
    let rate = |other_way: bool| {
        let (phi, theta) = (if other_way { FRAC_PI_2 } else { -FRAC_PI_2 }, FRAC_PI_2);
        let start = Attitude::from_euler(EulerAngles { phi, theta, zeta: 0.0 }).expect("upright");
        let back = upright().expect("upright").inverse() * start;
        let zeta = |t: f64| {
            let now = cycle_turned(&p, spin, t).expect("an attitude") * back;
            now.euler_angles().zeta
        };
        (zeta(1e-3) - zeta(-1e-3)) / 2e-3
    };
    let mut errors = Errors::of("zeta' with z = -rho, and with z = rho");
    errors.push(rate(false) + spin);
    errors.push(rate(true) - spin);
    assert_largest!(errors, 2, @"1.87e-14");
    // Printed: zeta' = Omega_S together with z = -rho.
    assert!((rate(false) - spin).abs() > 6.0);
    // The wheel that turns so slips at 2 Omega a.
    assert_error!(slip(&p, -spin).expect("a speed") - 2.0 * p.rate * p.shaft, 1.0e-13);
}

#[test]
fn e10_the_line_turns_about_z() {
    // What has carried the wheel round, its spin left out, is a turn about Z and not about X.
    let p = Parameters::default();
    let carried = cycle_turned(&p, 0.0, 0.4).expect("an attitude");
    let turn = (carried * upright().expect("upright").inverse()).rotation_vector();
    let phi = 0.4 * p.rate;
    assert_error!((turn - at(0.0, 0.0, phi)).norm(), 2.1175e-16);
    assert!((turn - at(phi, 0.0, 0.0)).norm() > 1.0);
}

/// The card: rolling resistance takes C g/2 of a hoop's speed a second, until there is none.
#[test]
fn a_hoop_is_slowed_down_by_its_rolling() {
    let (mut errors, mut damaged) = (Errors::of("speed lost"), Errors::of("a sliding block"));
    for (radius, speed, t) in [(0.35, 7.0, 0.3), (0.01, 0.1, 2.0), (10.0, 100.0, 600.0)] {
        let found = hoop::lost(1.0, [radius, speed], 0.005, 9.80665, t).unwrap().0;
        let said = 0.5 * 0.005 * 9.80665 * t;
        errors.add(found, said, said);
        damaged.add(found, 2.0 * said, said);
    }
    assert_largest!(errors, 3, @"4.06e-14");
    damaged.exceed(0.9, 3);
    assert_error!(hoop::lost(1.0, [0.35, 3.5e-4], 0.005, 9.80665, 6000.0).unwrap().0 - 3.5e-4, 0.0);
}

/// The card: a flat is a chord, a larger coin turns the other by as much more as its rim is
/// longer, and beside the middle of the tyre the ground is swept at Omega times the distance.
#[test]
fn the_card_says_what_the_bodies_do() {
    let card = ledger(&EXAMPLE, "");
    assert_eq!(card.len(), 4);
    card.iter().for_each(|[predicted, measured]| assert_eq!(predicted, measured));
    let (mut flats, mut first) = (Errors::of("flats"), Errors::of("first order"));
    for sides in [8, 22, 100] {
        let (b, tipped) = (PI / f64::from(sides), tipping(sides).0[sides as usize].x() / TAU);
        flats.push(tipped - sincos(b).0 / b);
        first.push((tipped - 1.0 + (1.0 - cos(b)) / 3.0) / b.powi(4));
    }
    assert_largest!(flats, 3, @"1.11e-16");
    first.exceed(5e-3, 3);
    let (mut coins, mut opposite) = (Errors::of("larger coins"), Errors::of("smaller"));
    for edge in [1e-6, 4e-4, 0.1, 2.0] {
        let more = coin_rolled(1.0 + edge, TAU, 1e-13).unwrap()[0] - 2.0 * TAU;
        coins.push(more - TAU * edge);
        opposite.push((more + TAU * edge) / edge);
    }
    assert_largest!(coins, 4, @"4.77e-15");
    opposite.exceed(12.0, 4);
    let (mut beside, mut inside) = (Errors::of("outer edge"), Errors::of("inner edge"));
    for p in wheels() {
        let at_edge = |out| slip_beside(&p, -p.rate * p.shaft / p.radius, out).unwrap();
        beside.push(at_edge(0.01) - 0.01 * p.rate);
        inside.push((at_edge(-0.01) - 0.01 * p.rate) / p.rate);
    }
    assert_largest!(beside, 4, @"1.35e-13");
    inside.exceed(0.019, 4);
}
