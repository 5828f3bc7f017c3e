//! Section 15.1, Euler angles. That two routes agree on every number is part of the report.

use crate::answers::{confirmed, ledger, number, refused, value};
use kit::prelude::*;
use pages::ch15_1_euler_angles::*;
use rotation_dynamics::Error;
use rotation_dynamics::attitude::{Attitude, EulerAngles, EulerRates, Sequence};
use rotation_dynamics::integrators::Ode;
use rotation_dynamics::math::EPS;
use std::f64::consts::{FRAC_PI_2, PI};
use support::{Errors, assert_largest, beside_twins};

/// Angles all over their range, none at a pole.
fn many() -> Vec<[f64; 3]> {
    let turns = [-3.0, -1.7, -0.4, 0.3, 1.1, 2.9];
    let tilts = [1e-9, 1e-3, 0.7, 1.6, 2.5, 3.13];
    let both = turns.into_iter().flat_map(|phi| turns.map(|zeta| (phi, zeta)));
    both.flat_map(|(phi, zeta)| tilts.map(|theta| [phi, theta, zeta])).collect()
}

fn attitude(phi: f64, theta: f64, zeta: f64) -> Attitude {
    Attitude::from_euler(EulerAngles { phi, theta, zeta }).unwrap()
}

#[test]
fn two_routes_agree_all_over_the_range() {
    let runs = many().into_iter().step_by(7).filter(|[_, theta, _]| (1e-3..3.0).contains(theta));
    let flags = |[a, b, c]: [f64; 3]| format!("--phi={a} --theta={b} --zeta={c} --shift-x=-3.5 --closest=0.01");
    confirmed(&EXAMPLE, runs.map(flags), 20);
    // Upright, the axis has no azimuth; the other numbers stand. And near half a turn of the book.
    confirmed(&EXAMPLE, [
        "--theta=0", "--theta=0 --phi=-3 --zeta=1",
        "--book=3.1415926535866516", "--book=3.14159265", "--book=3.1415",
    ], 5);
}

/// The inventory's instance, rounded from 25 digits.
#[test]
fn the_instance_of_the_notes() {
    let mut errors = Errors::of("the instance");
    for (key, known) in [
        ("distance", 0.6557438524302), ("angle", 0.706815553116308), ("axis_x", 0.930689546177353),
        ("axis_z", -0.135652924444237), ("advance", 1.2031871812357), ("z_y", -0.615444663558273),
        ("r12", 0.163841523821266), ("azimuth", -1.2707963267949),
    ] {
        errors.push(value(&EXAMPLE, key) - known);
    }
    assert_largest!(errors, 8, @"3.33e-15");
}

#[test]
fn a_displacement_without_an_axis_is_refused() {
    refused(&EXAMPLE, [("--theta=0 --zeta=-0.3", "angle of the whole rotation")]);
}

/// A map that keeps distances: the same matrix for any three points and any reference point.
/// The matrix is found from four displaced points alone. The twin is stretched by 1e-3.
#[test]
fn the_rotation_does_not_depend_on_the_point() {
    let (shift, [p, q]) = (SpaceVector::new(1.0, 2.0, 3.0), POINTS);
    let cases = many().into_iter().map(|angles| {
        [1.0, 1.001].map(|stretch| {
            // Twice as far out, a stretched body no longer moves by one matrix.
            let far = |v: [f64; 3]| if v[0].abs() > 0.3 { stretch } else { 1.0 };
            let moved = |v| times_vector(&matrix(angles), v) * far(v) + shift;
            let from = |c: [f64; 3], i: usize| moved(c.but(|c| c[i] += 1.0)) - moved(c);
            (0..3).map(|i| (from(p, i) - from(q, i)).norm()).fold(0.0, f64::max)
        })
    });
    assert_largest!(beside_twins(cases, 5e-4, 216), 216, @"1.02e-15");
}

/// Whatever point is taken as reference, the displacement has the same part along the axis;
/// the points of the screw axis have no other. The twin: an axis through the origin.
#[test]
fn every_displacement_is_a_screw() {
    let turned = many().into_iter().filter(|[_, theta, _]| (1e-2..3.0).contains(theta));
    let cases = turned.flat_map(|angles| {
        let (r, shift) = (matrix(angles), SpaceVector::new(1.0, -2.0, 0.5));
        let screw = Screw::of(angles, shift).unwrap();
        POINTS.map(|point| {
            let whole = times_vector(&r, point) + shift;
            let off = |screw: Screw| (screw.moved(point.into(), 1.0) - whole).norm() * sin(0.5 * screw.angle);
            [off(screw), off(Screw { point: SpaceVector::zero(), ..screw })]
        })
    });
    assert_largest!(beside_twins(cases, 0.01, 216), 216, @"8.74e-16");
}

/// Turns about axes that are carried along are turns about fixed axes in the opposite order.
#[test]
fn the_order_of_the_matrices() {
    let (mut errors, mut damaged) = (Errors::of("fixed axes, reversed"), Errors::of("not reversed"));
    let space = frames([0.0; 3])[0];
    let [x, _, z] = space;
    for [phi, theta, zeta] in many() {
        let body = frames([phi, theta, zeta])[3];
        let fixed = |turns: [(SpaceVector, f64); 3]| {
            let last = |v| turns.iter().fold(v, |v, (axis, angle)| turned(v, *axis, *angle));
            (0..3).map(|i| (last(space[i]) - body[i]).norm()).fold(0.0, f64::max)
        };
        errors.push(fixed([(z, zeta), (x, theta), (z, phi)]));
        if theta > 0.1 && theta < 3.0 && (phi - zeta).abs() > 0.1 {
            damaged.push(fixed([(z, phi), (x, theta), (z, zeta)]));
        }
    }
    assert_largest!(errors, 216, @"1.02e-15");
    damaged.exceed(0.05, 90);
}

/// There and back, from 1e-9 rad off the pole; the arc cosine loses the tilt.
#[test]
fn the_angles_come_back() {
    let (mut errors, mut damaged) = (Errors::in_units_of(EPS, "angles"), Errors::of("arc cosine"));
    for given in many() {
        let r = matrix(given);
        for (found, given) in angles(&r).into_iter().zip(given) {
            errors.add(found, given, given.abs());
        }
        if given[1] < 1e-8 {
            damaged.push(acos(r[2][2]) / given[1] - 1.0);
        }
    }
    assert_largest!(errors, 648, @"1.86");
    damaged.exceed(0.99, 36);
}

/// At theta = 0 different angles are one attitude; the library keeps the sum, and 1e-300 rad
/// beside it all three.
#[test]
fn the_lock_and_beside_it() {
    assert!(attitude(0.3, 0.0, 0.4).angle_to(&attitude(0.5, 0.0, 0.2)) < 1e-16);
    assert!(attitude(0.3, 0.1, 0.4).angle_to(&attitude(0.5, 0.1, 0.2)) > 0.01);
    assert!(attitude(0.3, PI, 0.4).angle_to(&attitude(0.5, PI, 0.6)) < 1e-15);
    for (theta, kept) in [(0.0, (0.7, 0.0, 0.0)), (1e-300, (0.3, 1e-300, 0.4))] {
        let back = attitude(0.3, theta, 0.4).euler_angles();
        assert_eq!((back.phi, back.theta, back.zeta), kept);
    }
    // The rates of the angles do not exist there, and the library says so.
    let locked = EulerAngles { phi: 0.3, theta: 0.0, zeta: 0.4 };
    assert!(matches!(locked.rates(BodyVector::new(1.0, 0.0, 0.0)), Err(Error::GimbalLock { .. })));
}

/// The rates on the page turn the body about X, and about nothing else. The twin: without cos(theta).
#[test]
fn the_rates_of_the_angles() {
    let tilted = many().into_iter().filter(|[_, theta, _]| (1e-3..3.0).contains(theta));
    let cases = tilted.map(|[phi, theta, zeta]| {
        let (at, attitude) = (EulerAngles { phi, theta, zeta }, attitude(phi, theta, zeta));
        let [a, b, c] = rates_of_angles().derivative(0.0, &[phi, theta, zeta]);
        [a, a / cos(theta)].map(|phi| {
            let found = at.angular_velocity(EulerRates { phi, theta: b, zeta: c });
            (attitude.to_space(found) - SpaceVector::new(1.0, 0.0, 0.0)).norm() * sin(theta)
        })
    });
    assert_largest!(beside_twins(cases, 1e-10, 144), 144, @"4.81e-16");
}

/// The closed form of the passage, which the figure draws, is a steady turning about X all the way.
#[test]
fn the_passage_is_a_steady_turning() {
    let mut errors = Errors::of("attitude");
    for (e, t) in [(1e-6, -1.0), (1e-3, 1e-3), (0.5, 0.3), (0.01, 1.0)] {
        let [phi, theta, zeta] = passing_angles(e, t);
        errors.push(attitude(phi, theta, zeta).angle_to(&passing(e, t).unwrap()));
    }
    assert!(errors.largest() < 1e-15);
}

/// Two turns of a book: the formula for any angle; by half turns the order does not matter.
#[test]
fn the_order_of_two_turns() {
    let mut errors = Errors::of("apart");
    for a in [1e-6, 0.01, 1.0, FRAC_PI_2, 2.0, 2.5, 3.1] {
        let [one, other] = [true, false].map(|order| book(a, order).unwrap());
        errors.push(apart(a) - one.angle_to(&other));
    }
    assert_largest!(errors, 7, @"4.44e-16");
    assert!(number(&EXAMPLE, "--book=3.141592653589793", "book_apart") < 1e-15);
    assert!((value(&EXAMPLE, "book_apart") - 2.0 * PI / 3.0).abs() < 1e-15);
}

/// E01: two angles locate the axis, but the azimuth of z is phi - pi/2; phi, as printed, is that of x.
#[test]
fn e01_the_azimuth_of_the_axis() {
    let cases = many().into_iter().map(|[phi, theta, zeta]| {
        let [azimuth, ..] = attitude(phi, theta, zeta).angles(Sequence::Zyz);
        [phi - FRAC_PI_2, phi].map(|angle| 2.0 * sin(0.5 * (azimuth - angle)))
    });
    assert_largest!(beside_twins(cases, 1.4, 216), 216, @"4.44e-16");
}

/// The card: a hung rod by u = s - s^2/2, a spun one by its exact form, tan(k)/k - 1 with k^2 the
/// strain; the first order of it is the damaged twin.
#[test]
fn rods_stretch_as_much_as_they_must() {
    assert_eq!(ledger(&EXAMPLE, "").len(), 3);
    let (mut errors, mut damaged) = (Errors::of("stretch"), Errors::of("first order"));
    for strain in [1e-7, 1e-4, 0.04, 1.0] {
        let (hung, spun) = (stretched(strain, |_| 1.0).unwrap().0, stretched(strain, |x| x).unwrap().0);
        let k = strain.sqrt();
        errors.push(hung - 0.5);
        // Its series where the difference would cancel.
        let series = 1.0 / 3.0 + 2.0 * strain / 15.0 + 17.0 * strain * strain / 315.0;
        let exact = if k < 0.05 { series } else { (sin(k) / cos(k) / k - 1.0) / strain };
        errors.push(spun - exact);
        damaged.push((spun - 1.0 / 3.0) / strain);
    }
    assert_largest!(errors, 8, @"2.19e-14");
    damaged.exceed(0.1, 4);
}

/// A push goes through in the time 1, in which the pushed end has come by 1. A chain of masses
/// smears its front out over the third root of their number, so that it comes with the power 2/3.
#[test]
fn a_push_goes_through_at_the_speed_of_sound() {
    let lost = [pushed::<32>(), pushed::<64>(), pushed::<128>()].map(|run| 1.0 - run.unwrap().0);
    let (mut errors, mut slopes) = (Errors::of("shortening"), Errors::of("slope"));
    for pair in lost.windows(2) {
        errors.push(pair[1]);
        slopes.push(log(pair[0] / pair[1]) / log(2.0));
    }
    assert_largest!(errors, 2, @"0.0230");
    assert_largest!(slopes, 2, @"0.696");
    slopes.exceed(0.65, 2);
}
