//! The twelve sequences: against 700 digits (tests/data/sequences.txt, written by
//! sequences.py), against turns made one by one, and at the lock.

use super::any_attitude;
use rotation_dynamics::attitude::{Attitude, Sequence, YawPitchRoll};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::{self, DoubleDouble, EPS};
use std::f64::consts::{FRAC_PI_2, PI};
use support::{Errors, Random, assert_error, assert_largest};

fn named(axes: &str) -> Sequence {
    let found = Sequence::ALL.into_iter().find(|sequence| {
        let letters = sequence.axes().map(|axis| ["x", "y", "z"][axis]);
        letters.join(" ") == axes
    });
    found.expect("one of the twelve")
}

/// A sequence, a quaternion and its angles.
fn rows() -> Vec<(Sequence, [f64; 4], [f64; 3])> {
    include_str!("../../data/sequences.txt")
        .lines()
        .skip(1)
        .map(|line| {
            let numbers: Vec<f64> =
                line[6..].split(' ').map(|c| c.parse().expect("a number")).collect();
            let quaternion = numbers[..4].try_into().expect("four");
            (named(&line[..5]), quaternion, numbers[4..].try_into().expect("three"))
        })
        .collect()
}

/// How many rows are not answered with the correctly rounded angles.
fn missed(answer: impl Fn(Sequence, [f64; 4]) -> [f64; 3]) -> (usize, usize) {
    let rows = rows();
    let missed =
        rows.iter().filter(|(sequence, q, angles)| answer(*sequence, *q) != *angles).count();
    (missed, rows.len())
}

fn angles_of(sequence: Sequence, q: [f64; 4]) -> [f64; 3] {
    let attitude = Attitude::from_quaternion(q).expect("a quaternion");
    assert_eq!(attitude.quaternion(), q);
    attitude.angles(sequence)
}

#[test]
fn angles_are_correctly_rounded() {
    assert_eq!(missed(angles_of), (0, 720));
    // Damaged: a component off by an ulp; the textbook's arc functions of the matrix.
    let (off, _) = missed(|sequence, [w, x, y, z]| {
        let q = [w, x, y, z * (1.0 + 2.0 * EPS)];
        Attitude::from_quaternion(q).expect("a quaternion").angles(sequence)
    });
    assert!(off >= 512, "{off}"); // measured 513 of 720
    let (off, _) = missed(|sequence, q| {
        let [i, j, k] = sequence.axes();
        let m = Attitude::from_quaternion(q).expect("one").matrix();
        let hand = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
        if i == k {
            let l = 3 - i - j;
            let first = math::atan2(m[j][i], -hand * m[l][i]);
            let third = math::atan2(m[i][j], hand * m[i][l]);
            return [first, math::acos(m[i][i]), third];
        }
        let first = math::atan2(-hand * m[j][k], m[k][k]);
        let third = math::atan2(-hand * m[i][j], m[i][i]);
        [first, math::asin(hand * m[i][k]), third]
    });
    assert!(off >= 586, "{off}"); // measured 587
}

fn product(p: [DoubleDouble; 4], q: [DoubleDouble; 4]) -> [DoubleDouble; 4] {
    let [a, b, c, d] = p;
    let [w, x, y, z] = q;
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

/// The angle between an attitude and three turns composed to 100 bits, in rad.
fn off(attitude: Attitude, sequence: Sequence, angles: [f64; 3]) -> f64 {
    let mut exact = [1.0, 0.0, 0.0, 0.0].map(DoubleDouble::from);
    for (axis, angle) in sequence.axes().into_iter().zip(angles) {
        let (sin, cos) = DoubleDouble::from(angle).scaled(0.5).sin_cos();
        let mut turn = [cos, 0.0.into(), 0.0.into(), 0.0.into()];
        turn[1 + axis] = sin;
        exact = product(exact, turn);
    }
    let [w, x, y, z] = attitude.quaternion().map(DoubleDouble::from);
    let [_, x, y, z] = product([w, -x, -y, -z], exact).map(DoubleDouble::to_f64);
    2.0 * SpaceVector::new(x, y, z).norm()
}

/// Angles for a sequence: generic, next to its lock, and of many turns.
fn some_angles(random: &mut Random, sequence: Sequence, kind: usize) -> [f64; 3] {
    let lock = match (sequence.is_proper(), random.unit() < 0.5) {
        (true, false) => 0.0,
        (true, true) => PI,
        (false, up) => FRAC_PI_2.copysign(if up { 1.0 } else { -1.0 }),
    };
    let size = [1.0, 1.0, 1e3, 1.0][kind];
    let second = match kind {
        1 => lock + math::pow(10.0, random.between(-20.0, -1.0)),
        3 => lock,
        _ => size * random.between(-PI, PI),
    };
    [size * random.between(-PI, PI), second, size * random.between(-PI, PI)]
}

#[test]
fn attitudes_of_three_turns_and_back() {
    let mut random = Random(31);
    let [mut into, mut out, mut length] =
        ["from_sequence", "angles", "length"].map(|what| Errors::in_units_of(EPS, what));
    let mut damaged = Errors::in_units_of(EPS, "the last two turns exchanged");
    for sequence in Sequence::ALL {
        for kind in 0..4 {
            for _ in 0..500 {
                let given = some_angles(&mut random, sequence, kind);
                let attitude = Attitude::from_sequence(sequence, given).expect("finite");
                into.push_at(off(attitude, sequence, given), (sequence, given));
                let angles = attitude.angles(sequence);
                out.push_at(off(attitude, sequence, angles), (sequence, angles));
                let [a, b, c] = angles;
                let middle = if sequence.is_proper() {
                    (0.0..=PI).contains(&b)
                } else {
                    b.abs() <= FRAC_PI_2
                };
                assert!(middle && a.abs() <= PI && c.abs() <= PI, "{angles:?}");
                let square = attitude.quaternion().map(DoubleDouble::from);
                let [w, x, y, z] = square.map(DoubleDouble::square);
                length.push((w + x + y + z - 1.0).to_f64() / 2.0);
            }
        }
        let attitude = Attitude::from_sequence(sequence, [0.3, 0.7, -0.4]).expect("finite");
        damaged.push(off(attitude, sequence, [0.3, -0.4, 0.7]));
    }
    assert_largest!(into, 24_000, @"4.37");
    assert_largest!(out, 24_000, @"4.11");
    assert_largest!(length, 24_000, @"1.48");
    damaged.exceed(1e15, 12);
}

/// Turns about axes carried along, and about fixed axes in the opposite order.
#[test]
fn intrinsic_and_extrinsic_turns() {
    let mut random = Random(32);
    let mut errors = Errors::in_units_of(EPS, "turn by turn");
    let mut damaged = Errors::of("extrinsic in the intrinsic order");
    let axis = |axis: usize| {
        let mut e = [0.0; 3];
        e[axis] = 1.0;
        e
    };
    for sequence in Sequence::ALL {
        for _ in 0..100 {
            let angles = some_angles(&mut random, sequence, 0);
            let direct = Attitude::from_sequence(sequence, angles).expect("finite");
            let turns = sequence.axes().map(axis).into_iter().zip(angles);
            let [mut carried, mut fixed, mut wrong] = [Attitude::IDENTITY; 3];
            for (axis, angle) in turns.clone() {
                let turn = BodyVector::from(axis) * angle;
                carried = carried.turned_in_body(turn).expect("finite");
                let turn = SpaceVector::from(axis) * angle;
                wrong = wrong.turned_in_space(turn).expect("finite");
            }
            for (axis, angle) in turns.rev() {
                let turn = SpaceVector::from(axis) * angle;
                fixed = fixed.turned_in_space(turn).expect("finite");
            }
            errors.push(direct.angle_to(&carried));
            errors.push(direct.angle_to(&fixed));
            damaged.push(direct.angle_to(&wrong));
        }
    }
    assert_largest!(errors, 2 * 1200, @"4.39");
    assert!(damaged.largest() > 3.0);
}

/// nalgebra's own yaw, pitch and roll.
#[test]
fn yaw_pitch_and_roll_are_those_of_others() {
    let mut random = Random(33);
    let mut errors = Errors::in_units_of(EPS, "against nalgebra");
    for _ in 0..2000 {
        let [yaw, pitch, roll] = some_angles(&mut random, Sequence::Zyx, 0);
        let pitch = pitch / 2.1;
        let ours = Attitude::from_yaw_pitch_roll(YawPitchRoll { yaw, pitch, roll });
        let ours = ours.expect("finite");
        let theirs = nalgebra::UnitQuaternion::from_euler_angles(roll, pitch, yaw);
        errors.push(ours.angle_to(&theirs.try_into().expect("finite")));
        let (their_roll, their_pitch, their_yaw) = theirs.euler_angles();
        let angles = ours.yaw_pitch_roll();
        let condition = math::cos(pitch);
        errors.push((angles.yaw - their_yaw) * condition);
        errors.push((angles.pitch - their_pitch) * condition);
        errors.push((angles.roll - their_roll) * condition);
    }
    assert_largest!(errors, 4 * 2000, @"4.78");
    // A quarter turn to the left, the nose up by 30 degrees where z points down.
    let angles = YawPitchRoll { yaw: -FRAC_PI_2, pitch: PI / 6.0, roll: 0.0 };
    let attitude = Attitude::from_yaw_pitch_roll(angles).expect("finite");
    let nose = attitude.to_space(BodyVector::new(1.0, 0.0, 0.0));
    assert_error!(nose.y(), -0.75_f64.sqrt(), 1.2 eps);
    assert_error!(nose.z(), -0.5, 0.0 eps);
    // Damaged: roll and yaw taken for each other.
    let swapped = YawPitchRoll { yaw: angles.roll, roll: angles.yaw, ..angles };
    let wrong = Attitude::from_yaw_pitch_roll(swapped).expect("finite");
    assert!(wrong.angle_to(&attitude) > 1.0);
}

#[test]
fn at_a_lock_the_third_angle_is_zero() {
    let mut count = 0;
    let mut errors = Errors::in_units_of(EPS, "what the first carries");
    for sequence in Sequence::ALL {
        for second in [FRAC_PI_2, -FRAC_PI_2, 1.5 * PI] {
            if sequence.is_proper() {
                continue;
            }
            let attitude = Attitude::from_sequence(sequence, [0.5, second, 0.125]).expect("finite");
            let [first, middle, third] = attitude.angles(sequence);
            let [i, j, _] = sequence.axes();
            let hand = if (i + 1) % 3 == j { 1.0 } else { -1.0 };
            let sign = math::sin(second);
            assert_eq!((middle, third), (sign * FRAC_PI_2, 0.0), "{sequence:?}");
            // Down at 3 pi/2 the turns count from the other side.
            let carried = 0.5 + sign * hand * 0.125;
            errors.add(first, carried, carried);
            count += 1;
        }
    }
    assert_eq!(count, 18);
    assert_largest!(errors, 18, @"0");
    // At the lock of the proper ones, and for the notes' angles the same bits.
    let mut random = Random(34);
    for _ in 0..1000 {
        let attitude = any_attitude(&mut random);
        let notes = attitude.euler_angles();
        assert_eq!(attitude.angles(Sequence::Zxz), [notes.phi, notes.theta, notes.zeta]);
        count += 1;
    }
    for sequence in Sequence::ALL.into_iter().filter(|s| s.is_proper()) {
        let attitude = Attitude::from_sequence(sequence, [0.5, 0.0, 0.25]).expect("finite");
        assert_eq!(attitude.angles(sequence), [0.75, 0.0, 0.0]);
        count += 1;
    }
    assert_eq!(count, 1024);
}
