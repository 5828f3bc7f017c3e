//! Section 15.1, Euler angles. That two routes agree on every number is part of the report.

use crate::answers::{confirmed, ledger, number, refused, value};
use pages::ch15_1_euler_angles::*;
use rotation_dynamics::Error;
use rotation_dynamics::attitude::{Attitude, EulerAngles, EulerRates, Sequence};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::integrators::Ode;
use rotation_dynamics::math::{EPS, acos, cos, log, sin};
use std::f64::consts::{FRAC_PI_2, PI};
use support::{Errors, assert_largest};

/// Angles all over their range, none at a pole.
fn many() -> Vec<[f64; 3]> {
    let turns = [-3.0, -1.7, -0.4, 0.3, 1.1, 2.9];
    let tilts = [1e-9, 1e-3, 0.7, 1.6, 2.5, 3.13];
    let both = turns.into_iter().flat_map(|phi| turns.map(|zeta| (phi, zeta)));
    both.flat_map(|(phi, zeta)| tilts.map(|theta| [phi, theta, zeta])).collect()
}

fn vector(v: [f64; 3]) -> SpaceVector {
    SpaceVector::from_array(v)
}

#[test]
fn two_routes_agree_all_over_the_range() {
    let runs = many().into_iter().step_by(7).filter(|[_, theta, _]| (1e-3..3.0).contains(theta));
    let runs: Vec<String> =
        runs.map(|[a, b, c]| format!("--phi={a} --theta={b} --zeta={c} --shift-x=-3.5 --closest=0.01")).collect();
    confirmed(&EXAMPLE, runs, 20);
    // Upright, the axis has no azimuth; the other numbers stand.
    confirmed(&EXAMPLE, ["--theta=0", "--theta=0 --phi=-3 --zeta=1"], 2);
    // Near half a turn of the book.
    confirmed(&EXAMPLE, ["--book=3.1415926535866516", "--book=3.14159265", "--book=3.1415"], 3);
}

/// The inventory's instance, rounded from 25 digits.
#[test]
fn the_instance_of_the_notes() {
    let known = [
        ("distance", 0.6557438524302),
        ("angle", 0.706815553116308),
        ("axis_x", 0.930689546177353),
        ("axis_z", -0.135652924444237),
        ("advance", 1.2031871812357),
        ("z_y", -0.615444663558273),
        ("r12", 0.163841523821266),
        ("azimuth", -1.2707963267949),
    ];
    let mut errors = Errors::of("the instance");
    for (key, known) in known {
        errors.push(value(&EXAMPLE, key) - known);
    }
    assert_largest!(errors, 8, @"3.33e-15");
}

#[test]
fn what_cannot_be_is_refused() {
    refused(&EXAMPLE, [
        ("--theta=-0.1", "theta = -0.1 is not allowed"),
        ("--phi=4", "phi = 4 is not allowed"),
        ("--theta=0 --zeta=-0.3", "angle of the whole rotation"),
        ("--closest=0", "closest = 0 is not allowed"),
        ("--book=7", "book = 7 is not allowed"),
        ("--tolerance=NaN", "tolerance"),
    ]);
}

/// A map that keeps distances: the same matrix for any three points and any reference point.
/// The matrix is found from four displaced points alone.
#[test]
fn the_rotation_does_not_depend_on_the_point() {
    let (mut same, mut damaged) = (Errors::of("matrix from points"), Errors::of("stretched by 1e-3"));
    for angles in many() {
        let (r, shift) = (matrix(angles), vector([1.0, 2.0, 3.0]));
        for stretch in [1.0, 1.001] {
            // Twice as far out, a stretched body no longer moves by one matrix.
            let moved = |v: [f64; 3]| times_vector(&r, v) * if v[0].abs() > 0.3 { stretch } else { 1.0 } + shift;
            let [p, q] = POINTS;
            let from = |c: [f64; 3], i: usize| {
                let mut along = c;
                along[i] += 1.0;
                moved(along) - moved(c)
            };
            let worst = (0..3).map(|i| (from(p, i) - from(q, i)).norm()).fold(0.0, f64::max);
            if stretch == 1.0 { same.push(worst) } else { damaged.push(worst) }
        }
    }
    assert_largest!(same, 216, @"1.02e-15");
    damaged.exceed(5e-4, 216);
}

/// Whatever point is taken as reference, the displacement has the same part along the axis;
/// the points of the screw axis have no other.
#[test]
fn every_displacement_is_a_screw() {
    let (mut errors, mut damaged) = (Errors::of("screw"), Errors::of("axis through the origin"));
    for angles in many().into_iter().filter(|a| (1e-2..3.0).contains(&a[1])) {
        let (r, shift) = (matrix(angles), vector([1.0, -2.0, 0.5]));
        let screw = Screw::of(angles, shift).expect("it turns");
        for point in POINTS {
            let whole = times_vector(&r, point) + shift;
            let off = |screw: &Screw| (screw.moved(vector(point), 1.0) - whole).norm() * sin(0.5 * screw.angle);
            errors.push(off(&screw));
            damaged.push(off(&Screw { point: SpaceVector::zero(), ..screw }));
        }
    }
    assert_largest!(errors, 216, @"8.74e-16");
    damaged.exceed(0.01, 216);
}

/// Turns about axes that are carried along are turns about fixed axes in the opposite order.
#[test]
fn the_order_of_the_matrices() {
    let (mut errors, mut damaged) = (Errors::of("fixed axes, reversed"), Errors::of("not reversed"));
    let [x, _, z] = frames([0.0; 3])[0];
    for [phi, theta, zeta] in many() {
        let body = frames([phi, theta, zeta])[3];
        let fixed = |turns: [(SpaceVector, f64); 3]| {
            let last = |v| turns.iter().fold(v, |v, (axis, angle)| turned(v, *axis, *angle));
            [0, 1, 2].map(|i| (last(frames([0.0; 3])[0][i]) - body[i]).norm()).into_iter().fold(0.0, f64::max)
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
    let of = |phi, theta, zeta| Attitude::from_euler(EulerAngles { phi, theta, zeta }).expect("finite");
    assert!(of(0.3, 0.0, 0.4).angle_to(&of(0.5, 0.0, 0.2)) < 1e-16);
    assert!(of(0.3, 0.1, 0.4).angle_to(&of(0.5, 0.1, 0.2)) > 0.01);
    assert!(of(0.3, PI, 0.4).angle_to(&of(0.5, PI, 0.6)) < 1e-15);
    let back = of(0.3, 0.0, 0.4).euler_angles();
    assert_eq!((back.phi, back.theta, back.zeta), (0.7, 0.0, 0.0));
    let back = of(0.3, 1e-300, 0.4).euler_angles();
    assert_eq!((back.phi, back.theta, back.zeta), (0.3, 1e-300, 0.4));
    // The rates of the angles do not exist there, and the library says so.
    let locked = EulerAngles { phi: 0.3, theta: 0.0, zeta: 0.4 };
    assert!(matches!(locked.rates(BodyVector::new(1.0, 0.0, 0.0)), Err(Error::GimbalLock { .. })));
}

/// The rates on the page turn the body about X, and about nothing else.
#[test]
fn the_rates_of_the_angles() {
    let (mut errors, mut damaged) = (Errors::of("angular velocity"), Errors::of("without cos(theta)"));
    for [phi, theta, zeta] in many().into_iter().filter(|a| (1e-3..3.0).contains(&a[1])) {
        let at = EulerAngles { phi, theta, zeta };
        let attitude = Attitude::from_euler(at).expect("finite");
        let off = |[phi, theta, zeta]: [f64; 3]| {
            let rates = EulerRates { phi, theta, zeta };
            (attitude.to_space(at.angular_velocity(rates)) - vector([1.0, 0.0, 0.0])).norm()
        };
        let [a, b, c] = rates_of_angles().derivative(0.0, &[phi, theta, zeta]);
        errors.push(off([a, b, c]) * sin(theta));
        damaged.push(off([a / cos(theta), b, c]) * sin(theta));
    }
    assert_largest!(errors, 144, @"4.81e-16");
    damaged.exceed(1e-10, 144);
}

/// The closed form of the passage is a steady turning about X.
#[test]
fn the_passage_is_a_steady_turning() {
    let mut errors = Errors::of("attitude");
    for (e, t) in [(1e-6, -1.0), (1e-3, 1e-3), (0.5, 0.3), (0.01, 1.0)] {
        let [phi, theta, zeta] = Passage(e).angles(t);
        let by_angles = Attitude::from_euler(EulerAngles { phi, theta, zeta }).expect("finite");
        errors.push(by_angles.angle_to(&Passage(e).attitude(t).expect("finite")));
    }
    assert_largest!(errors, 4, @"3.48e-16");
}

/// Two turns of a book: the formula for any angle; by half turns the order does not matter.
#[test]
fn the_order_of_two_turns() {
    let mut errors = Errors::of("apart");
    for a in [1e-6, 0.01, 1.0, FRAC_PI_2, 2.0, 2.5, 3.1] {
        let [one, other] = [true, false].map(|order| book(a, order).expect("finite"));
        errors.push(apart(a) - one.angle_to(&other));
    }
    assert_largest!(errors, 7, @"4.44e-16");
    assert!(number(&EXAMPLE, "--book=3.141592653589793", "book_apart") < 1e-15);
    assert!((value(&EXAMPLE, "book_apart") - 2.0 * PI / 3.0).abs() < 1e-15);
}

/// E01: two angles locate the axis, but the azimuth of z is phi - pi/2; phi is that of x.
#[test]
fn e01_the_azimuth_of_the_axis() {
    let (mut right, mut printed) = (Errors::of("phi - pi/2"), Errors::of("phi"));
    for [phi, theta, zeta] in many() {
        let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta }).expect("finite");
        let [azimuth, ..] = attitude.angles(Sequence::Zyz);
        let off = |angle: f64| 2.0 * sin(0.5 * (azimuth - angle)).abs();
        right.push(off(phi - FRAC_PI_2));
        printed.push(off(phi));
    }
    assert_largest!(right, 216, @"4.44e-16");
    printed.exceed(1.4, 216);
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
        let exact = if k < 0.05 { 1.0 / 3.0 + 2.0 * strain / 15.0 + 17.0 * strain * strain / 315.0 } else { (sin(k) / cos(k) / k - 1.0) / strain };
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
