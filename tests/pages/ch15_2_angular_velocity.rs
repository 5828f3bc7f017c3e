//! Angular velocity: equations (1) to (6) and the theorem, by where points and bodies are a
//! little earlier and later; what the notes leave open or misstate.

use crate::told::{confirmed, refused, value};
use pages::ch15_2_angular_velocity::*;
use rotation_dynamics::attitude::{Attitude, EulerAngles, EulerRates};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::sin;
use support::{EPS, Errors};

/// Angular velocities, with three points of a body each.
fn bodies() -> impl Iterator<Item = (SpaceVector, [SpaceVector; 3])> {
    let v = |seed: u32| {
        SpaceVector::from([1, 2, 3].map(|k| sin(f64::from(7 * seed * seed + 31 * k * seed + 5 * k))))
    };
    (0..8).map(move |i| (v(i) * 2.0, [v(i + 11), v(i + 3), v(i + 29)]))
}

/// The velocity of the point `r` of a body that turns about the origin and drifts, from where
/// it is a little earlier and later.
fn watched(omega: SpaceVector, r: SpaceVector) -> SpaceVector {
    let drift = SpaceVector::new(0.3, -0.2, 0.9);
    derivative(1e-3, |t| Ok(turned(omega, r, t)? + drift * t)).unwrap()
}

#[test]
fn line_15_2_every_line_of_the_body_turns_alike() {
    let (mut errors, mut damaged) = (Errors::of("rates of lines"), Errors::of("of their feet"));
    for (omega, [r, s, _]) in bodies() {
        let turn = UP * omega.x();
        let place = |r: SpaceVector, t| turned(turn, r - UP * r.z(), t).unwrap();
        let line = |t| place(r, t) - place(s, t);
        let angle = |t| angle_between(line(0.0), line(t));
        errors.push(angle(0.1) / 0.1 - omega.x());
        // The damaged twin: seen from the axis, the line from where it was to a point is no
        // line of the body.
        let ray = |t| place(r, t) - place(s, 0.0);
        damaged.push(angle_between(ray(0.0), ray(0.1)) / 0.1 - omega.x());
    }
    errors.attain(5.1e-15..=5.2e-15, 8);
    damaged.exceed(1e-3, 8);
}

#[test]
fn eq_15_2_1_velocity_of_a_point() {
    let (mut errors, mut damaged) = (Errors::of("Omega x r"), Errors::of("r x Omega"));
    for (omega, points) in bodies() {
        for r in points {
            let v = derivative(1e-3, |t| turned(omega, r, t)).unwrap();
            errors.push((velocity(omega, r) - v).norm());
            damaged.push((velocity(r, omega) - v).norm());
        }
    }
    errors.attain(7.4e-13..=7.5e-13, 24);
    damaged.exceed(0.1, 24);
}

/// Velocities of A and of O', neither at rest: only the difference is known to turn.
#[test]
fn eq_15_2_2_by_way_of_another_point() {
    let (mut errors, mut damaged) = (Errors::of("(2)"), Errors::of("r for r'"));
    for (omega, [a, o, _]) in bodies() {
        let (of_a, of_o) = (watched(omega, a), watched(omega, o));
        errors.push((of_o + velocity(omega, a - o) - of_a).norm());
        damaged.push((of_o + velocity(omega, a) - of_a).norm());
    }
    errors.attain(1.0e-12..=1.5e-12, 8);
    damaged.exceed(0.1, 8);
}

/// The angular velocity about O', from two points about it, makes (3) right for a third.
#[test]
fn eq_15_2_3_about_another_point() {
    let (mut errors, mut damaged) = (Errors::of("(3)"), Errors::of("half of it"));
    for (omega, [o, r, s]) in bodies() {
        let about = |r| watched(omega, r) - watched(omega, o);
        let own = from_two_points(about(r), about(s), s - o);
        let a = SpaceVector::new(0.4, 1.3, -0.6);
        errors.push((velocity(own, a - o) - about(a)).norm());
        damaged.push((velocity(own * 0.5, a - o) - about(a)).norm());
    }
    errors.attain(1.0e-12..=1.5e-12, 8);
    damaged.exceed(0.1, 8);
}

/// Measured about each of three points of the same body, it is the same vector.
#[test]
fn theorem_15_2_one_angular_velocity() {
    let (mut errors, mut damaged) = (Errors::of("Omega"), Errors::of("of a body that swells"));
    for (omega, points) in bodies() {
        for k in 0..3 {
            let [o, r, s] = [0, 1, 2].map(|i| points[(i + k) % 3]);
            let about = |r| watched(omega, r) - watched(omega, o);
            errors.push((from_two_points(about(r), about(s), s - o) - omega).norm());
            // The damaged twin: a body that is not rigid has no such vector.
            let swells = |r: SpaceVector| about(r) + (r - o) * 0.3;
            damaged.push((from_two_points(swells(r), swells(s), s - o) - omega).norm());
        }
    }
    errors.attain(2.6e-12..=2.7e-12, 24);
    damaged.exceed(1e-2, 24);
}

/// One point A does not tell two angular velocities apart that differ along r'; a second, in
/// another direction, does. In the plane of a disc one is enough.
#[test]
fn e02_one_point_is_not_enough() {
    let (mut one, mut two, mut flat) = (Errors::of("A"), Errors::of("B"), Errors::of("disc"));
    for (omega, [o, a, b]) in bodies() {
        let other = omega + (a - o) * 0.7;
        let apart = |r: SpaceVector| velocity(other - omega, r).norm();
        one.push(apart(a - o));
        two.push(apart(b - o));
        flat.push(velocity(UP * 0.7, A - O_PRIME).norm() / (A - O_PRIME).norm() - 0.7);
    }
    one.attain(5.0e-16..=5.1e-16, 8);
    two.exceed(0.05, 8);
    flat.attain(0.0..=0.0, 8);
}

/// Gyroscopes in many poses, with their rates.
fn gyroscopes() -> impl Iterator<Item = Gyroscope> {
    bodies().enumerate().map(|(i, (turn, [pose, ..]))| {
        let [phi, _, zeta] = (pose * 3.0).to_array();
        let theta = 0.3 + 0.33 * i as f64;
        let [p, n, s] = turn.to_array();
        let rates = EulerRates {
            phi: p,
            theta: n,
            zeta: 3.0 * s,
        };
        Gyroscope {
            angles: EulerAngles { phi, theta, zeta },
            rates,
        }
    })
}

/// The attitude a little later, with or without the spin.
fn later(g: &Gyroscope, t: f64, spin: f64) -> Attitude {
    let (a, r) = (g.angles, g.rates);
    let (phi, theta) = (a.phi + r.phi * t, a.theta + r.theta * t);
    let zeta = spin * (a.zeta + r.zeta * t);
    Attitude::from_euler(EulerAngles { phi, theta, zeta }).unwrap()
}

/// The angular velocity from the attitudes before and after.
fn filmed(g: &Gyroscope, spin: f64) -> SpaceVector {
    let now = later(g, 0.0, spin).inverse();
    derivative(1e-3, |t| Ok(now.then(&later(g, t, spin)).rotation_vector())).unwrap()
}

#[test]
fn eq_15_2_4_components_add_as_vectors() {
    let (mut errors, mut damaged) = (Errors::of("sum"), Errors::of("sum of the sizes"));
    for g in gyroscopes() {
        let ([x, y, z], [a, b, c]) = (g.triad(), g.nodal());
        errors.push((x * a + y * b + z * c - filmed(&g, 1.0)).norm());
        damaged.push(a.abs() + b.abs() + c.abs() - filmed(&g, 1.0).norm());
    }
    errors.attain(1.5e-12..=1.6e-12, 8);
    damaged.exceed(1e-2, 8);
}

#[test]
fn eq_15_2_5_three_rates() {
    let (mut errors, mut damaged) = (Errors::of("(5)"), Errors::of("phi' along z"));
    for g in gyroscopes() {
        errors.push((g.angular_velocity() - filmed(&g, 1.0)).norm());
        let [x, _, z] = g.triad();
        let wrong = z * (g.rates.phi + g.rates.zeta) + x * g.rates.theta;
        damaged.push((wrong - filmed(&g, 1.0)).norm());
    }
    errors.attain(1.5e-12..=1.6e-12, 8);
    damaged.exceed(0.05, 8);
}

/// On the line of nodes, on y, on the axis, where the body itself has them.
#[test]
fn eq_15_2_6_on_the_nodal_axes() {
    let (mut errors, mut damaged) = (Errors::of("(6)"), Errors::of("sine for cosine"));
    let (mut body, mut space) = (Errors::of("on the body"), Errors::of("not turned back"));
    for g in gyroscopes() {
        let (omega, triad) = (filmed(&g, 1.0), later(&g, 0.0, 0.0));
        let seen = triad.to_body(omega).to_array();
        let off = |a: [f64; 3], b: [f64; 3]| (SpaceVector::from(a) - SpaceVector::from(b)).norm();
        errors.push(off(g.nodal(), seen));
        let [x, y, z] = g.nodal();
        let along = z - g.rates.zeta;
        damaged.push(off([x, along, g.rates.zeta + y], seen));
        body.push(off(
            g.on_body(),
            later(&g, 0.0, 1.0).to_body(omega).to_array(),
        ));
        space.push(off(
            g.nodal(),
            later(&g, 0.0, 1.0).to_body(omega).to_array(),
        ));
        // And back.
        let [p, n, s] = rates(seen, g.angles.theta);
        errors.push(off([p, n, s], [g.rates.phi, g.rates.theta, g.rates.zeta]));
    }
    errors.attain(1.6e-12..=1.7e-12, 16);
    damaged.exceed(1e-2, 8);
    body.attain(1.5e-12..=1.6e-12, 8);
    space.exceed(1e-3, 8);
}

/// The axes x, y, z move as phi' Z + theta' x says. With phi' Z alone, as printed, the axis
/// would keep its tilt for ever.
#[test]
fn e03_the_triad_turns_about_two_axes() {
    let (mut errors, mut printed) = (Errors::of("of the triad"), Errors::of("printed"));
    for g in gyroscopes() {
        for k in 0..3 {
            let axis = |t| {
                let unit = SpaceVector::from([0, 1, 2].map(|i| f64::from(u8::from(i == k))));
                Ok(later(&g, t, 0.0).to_space(unit.to_array().into()))
            };
            let (now, moves) = (axis(0.0).unwrap(), derivative(1e-3, axis).unwrap());
            errors.push((velocity(g.of_triad(), now) - moves).norm());
            // x stays level, and so does not tell the two apart.
            if k > 0 {
                printed.push((velocity(UP * g.rates.phi, now) - moves).norm());
            }
        }
    }
    errors.attain(1.0e-12..=1.5e-12, 24);
    printed.exceed(0.05, 16);
}

/// Seen from a frame that turns, a body turns with Omega less that of the frame; the printed
/// statement, that it turns the same, holds for no frame that turns.
#[test]
fn e05_a_turning_frame_sees_the_difference() {
    let (mut errors, mut printed) = (Errors::of("seen"), Errors::of("printed"));
    for (omega, [r, ..]) in bodies() {
        let frame = 0.3 + r.x().abs();
        let seen = seen_from(frame, omega).unwrap();
        errors.push((omega - UP * frame - seen).norm());
        printed.push((omega - seen).norm());
    }
    errors.attain(2.7e-15..=2.8e-15, 8);
    printed.exceed(0.2, 8);
    // A frame that turns with the body sees it at rest.
    assert_eq!(seen_from(1.5, UP * 1.5).unwrap().norm(), 0.0);
}

/// Turns about X and Z differ by their order as the formula says; halved, the difference is a
/// quarter, so that of the rates nothing is left.
#[test]
fn turns_do_not_add_and_rates_do() {
    let (mut errors, mut halved) = (Errors::of("gap"), Errors::of("of half the turn, times 4"));
    for k in 1..=19 {
        let x = 0.1 * f64::from(k);
        errors.add(gap(x), measured_gap(x).unwrap(), 1.0);
        let small = x * 1e-3;
        halved.push(4.0 * measured_gap(0.5 * small).unwrap() / measured_gap(small).unwrap() - 1.0);
    }
    errors.attain(4.4e-16..=4.5e-16, 19);
    halved.attain(2.2e-7..=2.3e-7, 19);
    // The damaged twin: for turns that one sees, a half has not a quarter.
    assert!((4.0 * gap(1.0) / gap(2.0) - 1.0).abs() > 0.1);
}

#[test]
fn every_instance_is_confirmed() {
    let poses = [(0.001, 30.0), (0.5, -3000.0), (2.9, 0.0), (3.14, 5.0)];
    let gyroscopes = poses.map(|(theta, spin)| format!("--theta={theta} --spin={spin} --phi=40"));
    let frames = [0.0, -5000.0, 2e-3].map(|w| format!("--frame={w} --omega-z={w} --disc={w}"));
    let still = "--omega-x=0 --omega-y=0 --omega-z=0 --precession=0 --nutation=0 --spin=0";
    let lines = [
        "--line-before=-1.5 --line-after=1.5",
        "--interval=1000000",
        still,
    ];
    let all = gyroscopes
        .into_iter()
        .chain(frames)
        .chain(lines.map(String::from));
    confirmed(&EXAMPLE, all, 10);
    // The instances of the inventory, rounded from 25 digits.
    let known = [
        ("size", 31.130150605228),
        ("space_y", -23.968_877_986_492_6),
        ("space_z", 18.209_069_176_044_2),
        ("omega_y", 1.682_941_969_615_79),
        ("v_x", -0.49),
    ];
    let mut errors = Errors::of("instances");
    for (key, wanted) in known {
        errors.add(value(&EXAMPLE, key), wanted, wanted.abs());
    }
    errors.attain(1.8e-15..=1.9e-15, 5);
}

/// Past a pole the angles take ever more steps, the quaternion does not know of it; both arrive.
#[test]
fn angles_pay_for_a_pole_and_quaternions_do_not() {
    let steps = |tilt: f64| {
        let (omega, start) = passing(tilt).unwrap();
        [by_angles, by_quaternion].map(|way| way(omega, &start, 1.7, 1e-12).unwrap().1.steps)
    };
    let ([far, few], [near, same]) = (steps(0.5), steps(1e-5));
    assert_eq!((few, same), (8, 8));
    assert!(near > 5 * far, "{near} {far}");
    // Through the pole itself, to the last bit, there is no rate of the angles at all.
    let pole = EulerAngles {
        phi: 0.0,
        theta: 0.0,
        zeta: 0.0,
    };
    assert!(pole.rates([1.0, 0.0, 0.0].into()).is_err());
}

#[test]
fn what_has_no_rates_is_refused() {
    let runs = [
        ("--theta=0", "theta = 0 is not allowed"),
        ("--theta=3.2", "theta = 3.2 is not allowed"),
        ("--interval=0", "interval = 0 is not allowed"),
        ("--spin=nan", "NaN is not a finite number"),
        (
            "--tolerance=1e-17",
            "tolerance = 1e-17 is not allowed",
        ),
    ];
    refused(&EXAMPLE, runs);
}
