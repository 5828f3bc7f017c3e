//! Rolling: each formula of the page by a route of its own, the slips of the notes, and far
//! from the notes' numbers. That simulations confirm the claims is part of the report.

use crate::answers::{computed, confirmed, errors_of, ledger, refused, value};
use core::f64::consts::{FRAC_PI_2, PI, TAU};
use kit::prelude::*;
use pages::ch15_2_rolling::*;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::integrators::after;
use support::{assert_error, assert_largest, beside_twins};

/// Cycle wheels from a caster to a wheel at the end of a long shaft.
fn wheels() -> [Parameters; 4] {
    let wheel = |(radius, shaft)| Parameters { radius, shaft, ..Parameters::default() };
    [(0.3, 0.5), (0.3, 0.01), (0.02, 1.0), (1.0, 1.0)].map(wheel)
}

#[test]
fn the_instances_of_the_notes_come_out() {
    assert_largest!(errors_of(&EXAMPLE, [
        ("wheel_speed", 7.0), ("cycloid", 2.8), ("coin_part", PI), ("coin_circuit", 12.566_370_614_359_172),
        ("spin", -3.333_333_333_333_333_3), ("net_rate", 3.887_301_263_230_201_4),
        ("across", 1.438_276_615_812_609), ("along", 2.632_747_685_671_118),
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
    // A hoop that rolls on, one that comes to rest before it has turned, and a large one.
    let hoops = ["0.35 --wheel-rate=20", "0.001 --wheel-rate=0.1", "10 --wheel-rate=0.6"];
    let hoops = hoops.map(|wheel| format!("--with resistance=0.005 --wheel-radius={wheel}"));
    let runs = wheels.into_iter().chain(coins).chain(cycles).chain(cylinders);
    confirmed(&EXAMPLE, runs.chain(steps).chain(hoops), 20);
}

#[test]
fn what_does_not_roll_is_refused() {
    refused(&EXAMPLE, [
        ("--wheel-rate=0", "at rest nothing rolls"),
        ("--shaft=900 --radius=0.01", "shaft/radius = 90"),
        ("--with slip=0", "slip = 0 is not allowed"),
        ("--with slip=2.1", "at most 2"),
    ]);
}

/// V = omega R without calculus: polygons tip along, a side for a turn of 2 pi over their
/// number, and what is missing shrinks as its square, pi^2/6 sides^2. The twin: V = 2 omega R.
#[test]
fn eq_15_2_wheel_speed() {
    let cases = [100_u32, 200, 400, 800].map(|sides| {
        let (speed, unit) = (tipping(sides).0[sides as usize].0 / TAU, f64::from(sides * sides));
        [(1.0 - speed) * unit / (PI * PI / 6.0) - 1.0, 2.0 - speed]
    });
    assert_largest!(beside_twins(cases, 0.9, 4), 4, @"4.93e-5");
}

/// The point that touches moves at (Omega_orbit - Omega_spin) R: from the places of that point
/// of a coin that is carried round and turned at the same time. The twin: the sum.
#[test]
fn eq_15_2_coin_contact_velocity() {
    let cases = [(1.0, 1.0), (1.0, 0.0), (0.5, 2.0), (-1.0, 1.5)].map(|(orbit, spin)| {
        let place = |t: f64| 2.0 * sin(orbit * t) + sin(PI + (orbit + spin) * t);
        let v = (place(1e-4) - place(-1e-4)) / 2e-4;
        [v - (orbit - spin), v - (2.0 * orbit + spin)]
    });
    assert_largest!(beside_twins(cases, 0.9, 4), 4, @"2.56e-8");
}

/// As much as it slips it turns less: carried round it turns once, and at twice that not at all. The
/// twin: it turns more.
#[test]
fn a_coin_that_slips_turns_less() {
    let slips = ["0.1", "0.25", "1", "1.5", "2"];
    confirmed(&EXAMPLE, slips.map(|slip| format!("--with slip={slip}")), 5);
    let cases = [("0.5", 1.5), ("1", 1.0), ("2", 0.0)].map(|(slip, turns)| {
        let turned = computed(&EXAMPLE, &format!("--with slip={slip}"), "slid_circuit");
        [turned - turns * TAU, turned - (4.0 - turns) * TAU]
    });
    assert_largest!(beside_twins(cases, 6.0, 3), 3, @"0");
}

/// theta_net = 2 theta_orbit for polygons: tipped about a common corner until the next sides
/// lie on each other, the moving one turns by what the two corners leave open. The twin: theta_orbit.
#[test]
fn eq_15_2_coin_net_turn() {
    let cases = [3.0, 4.0, 6.0, 12.0, 100.0].map(|sides| {
        let corner = |k: f64| sincos((k + 0.5) * TAU / sides);
        let (edge, (y, x), (py, px)) = (cos(0.5 * TAU / sides), corner(1.0), corner(0.0));
        // From the corner that stays, to the next corner of either: the moving one is the fixed one's
        // image in their common side.
        let direction = |mirrored: f64| atan2(y - py, mirrored * (x - edge) - mirrored * (px - edge));
        let step = (direction(1.0) - direction(-1.0)).rem_euclid(TAU);
        [step * sides - 2.0 * TAU, step * sides - TAU]
    });
    assert_largest!(beside_twins(cases, 1.0, 5), 5, @"2.17e-13");
}

/// Omega Z + Omega_S rho, for a wheel that slips or not: from where it is before and after. The
/// twin: the difference.
#[test]
fn eq_15_5_14_angular_velocities_add() {
    let cases = wheels().into_iter().flat_map(|p| {
        [-3.0, -0.5, 0.0, 2.0].map(|spin| {
            let found = measured(|t| cycle_turned(&p, spin, t), 1.0 / hypot(p.rate, spin)).unwrap();
            [p.rate, -p.rate].map(|rate| (found - SpaceVector::new(spin, 0.0, rate)).norm())
        })
    });
    assert_largest!(beside_twins(cases, 3.9, 16), 16, @"5.50e-13");
}

/// Omega_S = -Omega a/R: the spin with which the lowest point stands still, by its places. Slid along
/// without spin, it rubs at the speed of the hub. The twin: the other sense.
#[test]
fn eq_15_5_15_spin_of_the_cycle_wheel() {
    let cases = wheels().map(|p| {
        let found = spin_without_slip(&p).unwrap();
        [spin(&p), -spin(&p)].map(|spin| (found - spin) / found)
    });
    let mut errors = beside_twins(cases, 1.9, 4);
    for p in wheels() {
        errors.push(slip(&p, 0.0, 0.0).unwrap() - p.rate * p.shaft);
    }
    assert_largest!(errors, 8, @"3.19e-12");
}

/// (15.5.16) carries the attitude to where the two turns put it. The twin: the other sense.
#[test]
fn eq_15_5_16_carries_the_wheel_round() {
    let cases = wheels().map(|p| {
        let turned = cycle_turned(&p, spin(&p), 1.3).unwrap();
        [1.0, -1.0].map(|sign| {
            let law = carried(|t| cycle_rate(&p, along_shaft(&p, t) * sign));
            let q = after(1.3, &law, &upright().unwrap().quaternion(), 1e-14).unwrap();
            Attitude::from_quaternion(q).unwrap().angle_to(&turned)
        })
    });
    assert_largest!(beside_twins(cases, 0.05, 4), 4, @"4.75e-14");
}

/// (Omega sin theta, Omega cos theta) on the cylinder's axes, from where it is. The twin: exchanged.
#[test]
fn eq_15_5_18_components_on_the_cylinder() {
    let cases = [0.1, 0.5, 1.5, 3.0].map(|tilt| {
        let p = Parameters { tilt, ..Parameters::default() };
        let (found, (s, c)) = (on_cylinder(&p).unwrap(), sincos(tilt));
        [(s, c), (c, s)].map(|(y, z)| (found - BodyVector::new(0.0, y, z) * p.cylinder_rate).norm())
    });
    assert_largest!(beside_twins(cases, 1.0, 4), 4, @"8.90e-16");
}

/// From above the shaft's direction turns at Omega; from outside a spoke turns at Omega_S. As
/// printed the two are exchanged.
#[test]
fn e08_the_view_from_above_shows_the_precession() {
    let (p, [x, y, z]) = (Parameters::default(), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    // How fast a direction that is fixed in the wheel turns in a picture with these axes.
    let seen = |fixed: [f64; 3], [right, up]: [[f64; 3]; 2]| {
        let angle = |t: f64| {
            let start = upright().unwrap().to_body(fixed.into());
            let line = cycle_turned(&p, spin(&p), t).unwrap().to_space(start);
            atan2(line.dot(&up.into()), line.dot(&right.into()))
        };
        (angle(1e-6) - angle(-1e-6)) / 2e-6
    };
    let (above, side) = (seen(x, [x, y]), seen(z, [y, z]));
    assert!((above - 2.0).abs() < 1e-9 && (side + 10.0 / 3.0).abs() < 1e-9);
    assert!((above + 10.0 / 3.0).abs() > 1.0 && (side - 2.0).abs() > 1.0);
}

/// The rate of zeta with the axis z along -rho, and along rho. The twin: the other sign, which is
/// printed for the first. The wheel that turns so slips at 2 Omega a.
#[test]
fn e09_the_sign_of_zeta() {
    let p = Parameters::default();
    let cases = [(-FRAC_PI_2, -spin(&p)), (FRAC_PI_2, spin(&p))].map(|(phi, wanted)| {
        let start = Attitude::from_euler(EulerAngles { phi, theta: FRAC_PI_2, zeta: 0.0 }).unwrap();
        let back = upright().unwrap().inverse() * start;
        let zeta = |t: f64| (cycle_turned(&p, spin(&p), t).unwrap() * back).euler_angles().zeta;
        let rate = (zeta(1e-3) - zeta(-1e-3)) / 2e-3;
        [rate - wanted, rate + wanted]
    });
    assert_largest!(beside_twins(cases, 6.0, 2), 2, @"1.87e-14");
    assert_error!(slip(&p, -spin(&p), 0.0).unwrap() - 2.0 * p.rate * p.shaft, 1.0e-13);
}

/// What has carried the wheel round, its spin left out, is a turn about Z and not about X.
#[test]
fn e10_the_line_turns_about_z() {
    let p = Parameters::default();
    let (carried, phi) = (cycle_turned(&p, 0.0, 0.4).unwrap(), 0.4 * p.rate);
    let turn = (carried * upright().unwrap().inverse()).rotation_vector();
    assert_error!((turn - SpaceVector::new(0.0, 0.0, phi)).norm(), 2.1175e-16);
    assert!((turn - SpaceVector::new(phi, 0.0, 0.0)).norm() > 1.0);
}

/// The card: a flat is a chord, a larger coin turns the other by as much more as its rim is
/// longer, and beside the middle of the tyre the ground is swept at Omega times the distance. The
/// twins: the first order, a smaller coin, the inner edge.
#[test]
fn the_card_says_what_the_bodies_do() {
    let card = ledger(&EXAMPLE, "");
    assert_eq!(card.len(), 4);
    card.iter().for_each(|[predicted, measured]| assert_eq!(predicted, measured));
    let flats = [8_u32, 22, 100].map(|sides| {
        let (b, tipped) = (PI / f64::from(sides), tipping(sides).0[sides as usize].0 / TAU);
        [tipped - sin(b) / b, (tipped - 1.0 + (1.0 - cos(b)) / 3.0) / b.powi(4)]
    });
    assert_largest!(beside_twins(flats, 5e-3, 3), 3, @"1.11e-16");
    let coins = [1e-6, 4e-4, 0.1, 2.0].map(|edge| {
        let more = coin_rolled(1.0 + edge, TAU, 1e-13).unwrap().end_time() - 2.0 * TAU;
        [more - TAU * edge, (more + TAU * edge) / edge]
    });
    assert_largest!(beside_twins(coins, 12.0, 4), 4, @"4.77e-15");
    let edges = wheels().map(|p| {
        let off = |outside| slip(&p, spin(&p), outside).unwrap() - 0.01 * p.rate;
        [off(0.01), off(-0.01) / p.rate]
    });
    assert_largest!(beside_twins(edges, 0.019, 4), 4, @"1.35e-13");
}
