//! Arcs between attitudes, parameters of others, attitudes at random, angles beyond a turn; and
//! what none of these can tell.

use super::{any_attitude, turned_by, unit};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use rotation_dynamics::attitude::{Arcs, Attitude, EulerAngles, Sequence, unwrapped};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::{self, DoubleDouble, EPS};
use std::f64::consts::{PI, TAU};
use support::{Errors, Random, assert_largest};

/// (sin (1-p)h a + sin ph b)/sin h to 100 bits, h half the angle.
fn slerp(a: Attitude, b: Attitude, part: f64) -> Attitude {
    let (p, mut q) = (a.quaternion(), b.quaternion());
    if p.iter().zip(q).map(|(x, y)| x * y).sum::<f64>() < 0.0 {
        q = q.map(|c| -c);
    }
    let length = |sign: f64| {
        let squares = (0..4).map(|i| DoubleDouble::sum(p[i], sign * q[i]).square());
        squares.fold(DoubleDouble::ZERO, |sum, square| sum + square).sqrt()
    };
    let half = length(-1.0).atan2(length(1.0)).scaled(2.0);
    if half == 0.0 {
        return a;
    }
    let rest = (half - half * part).sin();
    let (of_p, of_q) = (rest / half.sin(), (half * part).sin() / half.sin());
    let mixed = std::array::from_fn(|i| (of_p * p[i] + of_q * q[i]).to_f64());
    unit(mixed)
}

#[test]
fn arcs_are_the_shortest_and_uniform() {
    let mut random = Random(85);
    let mut errors = Errors::in_units_of(EPS, "toward");
    let mut damaged = Errors::in_units_of(EPS, "nalgebra's, of neighbours");
    for case in 0..3000 {
        let a = any_attitude(&mut random);
        let size = random.size(1e-16, 0.1);
        let b = match case % 2 {
            0 => any_attitude(&mut random),
            _ => turned_by(&mut random, &a, size),
        };
        let part = random.unit();
        let between = a.toward(&b, part).expect("an arc");
        errors.push(between.angle_to(&slerp(a, b, part)));
        errors.push(a.toward(&b, 1.0).expect("an arc").angle_to(&b));
        let arcs = Arcs::through(&[(-1e308, a), (1e308, b)]).expect("arcs");
        assert_eq!((arcs.at(-1e308), arcs.at(1e308)), (Ok(a), Ok(b)));
        let there = arcs.at(1e308 * (2.0 * part - 1.0)).expect("in time");
        errors.push(there.angle_to(&between));
        let near = turned_by(&mut random, &a, 1e-8);
        if let Some(theirs) = UnitQuaternion::from(a).try_slerp(&near.into(), 0.5, 0.0) {
            let ours = a.toward(&near, 0.5).expect("an arc");
            damaged.push(Attitude::try_from(theirs).expect("finite").angle_to(&ours));
        }
    }
    assert_largest!(errors, 9000, @"6.66");
    assert!(damaged.largest() > 1e5);
}

#[test]
fn other_parameters_and_back() {
    let mut random = Random(86);
    let [mut from, mut into, mut locked, mut matrices, mut damaged] =
        ["from Rodrigues", "into", "locked", "Rotation3", "tan(angle/2)"]
            .map(|name| Errors::in_units_of(EPS, name));
    for case in 0..3000 {
        let sigma = random.vector::<3>();
        let length = SpaceVector::from(sigma).norm();
        let attitude = Attitude::from_modified_rodrigues(sigma).expect("finite");
        let square = sigma.map(|c| DoubleDouble::from(c).square());
        let w = (1.0 - (square[0] + square[1] + square[2])).to_f64();
        let [x, y, z] = sigma.map(|c| 2.0 * c);
        let direct = unit([w, x, y, z]);
        from.push(attitude.angle_to(&direct));
        // The parameters of Rodrigues himself are tan(angle/2).
        let [a, b, c] = sigma;
        damaged.push(attitude.angle_to(&unit([1.0, a, b, c])));
        let shadow = Attitude::from_modified_rodrigues(sigma.map(|c| -c / length / length));
        assert!(shadow.expect("finite").angle_to(&attitude) < 12.0 * EPS);
        let back = SpaceVector::from(attitude.modified_rodrigues());
        assert!(back.norm() <= 1.0 + EPS);
        let vector = attitude.rotation_vector();
        let quarter = math::tan(vector.norm() / 4.0) / vector.norm();
        into.push((back - vector * quarter).norm() / back.norm());
        // A rounding off the lock.
        let sequence = Sequence::ALL[case % 12];
        let start = if sequence.is_proper() { 0.0 } else { -PI / 2.0 };
        let lock = start + PI * (case / 12 % 2) as f64;
        let angles =
            [random.between(-PI, PI), lock + 1e-12 * random.unit(), random.between(-PI, PI)];
        let near = Attitude::from_sequence(sequence, angles).expect("finite");
        let at = near.angles_locked(sequence, 1e-9).expect("allowed");
        assert!(at[2] == 0.0 && near.angles(sequence)[2] != 0.0 && at[0].abs() <= PI + EPS);
        let there = Attitude::from_sequence(sequence, at).expect("finite");
        // By what the second angle was moved, and no more.
        let moved = (near.angles(sequence)[1] - at[1]).abs();
        locked.push(there.angle_to(&near) - moved);
        assert_eq!(near.angles_locked(sequence, 0.0).expect("allowed"), near.angles(sequence));
        let theirs = Rotation3::from(near);
        matrices.push(Attitude::try_from(theirs).expect("a rotation").angle_to(&near));
        let v = BodyVector::from(random.vector());
        let turned = SpaceVector::from(theirs * Vector3::from(v));
        matrices.push((turned - near.to_space(v)).norm() / v.norm());
    }
    damaged.exceed(1e9, 3000);
    assert_largest!(from, 3000, @"3.09");
    assert_largest!(into, 3000, @"3.70");
    assert_largest!(locked, 3000, @"4.02");
    assert_largest!(matrices, 6000, @"5.77");
    assert_eq!(format!("{:.1}", Attitude::IDENTITY), "(1.0, 0.0, 0.0, 0.0)");
}

#[test]
fn random_attitudes_have_the_moments_of_uniform_ones() {
    let mut random = Random(87);
    let [mut moments, mut damaged] = ["Shoemake's", "of a cube"].map(Errors::of);
    let n = 100_000;
    let mut sums = [[0.0; 4]; 2];
    for _ in 0..n {
        let uniform =
            Attitude::from_uniform(random.vector().map(|c: f64| c.abs())).expect("in 0..1");
        for (sums, attitude) in sums.iter_mut().zip([uniform, any_attitude(&mut random)]) {
            for (sum, c) in sums.iter_mut().zip(attitude.quaternion()) {
                *sum += c * c * c * c / f64::from(n);
            }
        }
    }
    // The mean of c^4 on the sphere in four dimensions is 1/8.
    sums[0].iter().for_each(|sum| moments.add(*sum, 0.125, 0.125));
    sums[1].iter().for_each(|sum| damaged.add(*sum, 0.125, 0.125));
    assert_largest!(moments, 4, @"9.67e-3");
    damaged.exceed(0.02, 4);
}

#[test]
fn angles_go_on_beyond_a_turn() {
    let mut random = Random(88);
    let mut errors = Errors::in_units_of(EPS, "unwrapped");
    let (mut angle, mut true_ones, mut read) = (0.5, Vec::new(), Vec::new());
    for _ in 0..3000 {
        true_ones.push(angle);
        let turns = (angle / TAU).round();
        read.push((DoubleDouble::TWO_PI * -turns + angle).to_f64());
        angle += random.between(-2.0, 3.1);
    }
    let counted = unwrapped(&read).expect("finite");
    assert!(counted[2999] > 1000.0);
    counted.iter().zip(&true_ones).for_each(|(c, t)| errors.add(*c, *t, t.abs().max(PI)));
    assert_largest!(errors, 3000, @"0");
    let faster: Vec<f64> = read.iter().step_by(3).copied().collect();
    assert!((unwrapped(&faster).expect("finite")[999] - counted[2997]).abs() > TAU);
    // A steady top, read from its attitude.
    let top =
        |i: u32| EulerAngles { phi: 0.3 * f64::from(i), theta: 1.0, zeta: -2.9 * f64::from(i) };
    let seen = (0..500).map(|i| Attitude::from_euler(top(i)).expect("finite").euler_angles());
    let counted = EulerAngles::unwrapped(&seen.collect::<Vec<_>>()).expect("finite");
    assert!((counted[499].phi - top(499).phi).abs() < 1e-13);
    assert!((counted[499].zeta - top(499).zeta).abs() < 1e-12);
    assert_eq!(unwrapped(&[]), Ok(vec![]));
}

#[test]
fn what_the_world_cannot_tell_is_refused_with_the_numbers() {
    let (nan, one) = (f64::NAN, Attitude::IDENTITY);
    let nearest = |diagonal| Attitude::nearest(Matrix3::from_diagonal(&diagonal).into()).err();
    let d = Vector3::new;
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(BodyVector::from);
    let s = SpaceVector::new;
    let (right, up) = (s(1.0, 0.0, 0.0), s(0.0, 0.0, 2.0));
    let (ahead, zero) = (s(0.0, 1.0, 0.0), SpaceVector::zero());
    let about_x = |angle| Attitude::about_space_axis(right, angle).expect("finite");
    let half = about_x(PI);
    let two = |a, b| Attitude::from_two_directions((z, a), (x, b)).err();
    let many = |list: &[(BodyVector, SpaceVector, f64)]| Attitude::from_directions(list).err();
    let mirrored = [(x, right, 1.0), (y, ahead, 1.0), (z, -up, 1.0)];
    let arcs = |list: &[(f64, Attitude)]| Arcs::through(list).err();
    let errors = [
        nearest(d(1.0, 1.0, nan)),
        nearest(d(0.0, 0.0, 0.0)),
        nearest(d(2.0, 1.0, -0.5)),
        nearest(d(1.0, 1.0, 1e-16)),
        nearest(d(1.0, 1e-13, 1e-13)),
        nearest(d(1.7e308, 1.7e308, 1.7e308)),
        two(up, -up),
        two(up, zero),
        two(up, s(0.0, 0.0, nan)),
        Attitude::from_two_directions((z, right), (z, up)).err(),
        many(&[]),
        many(&[(z, ahead, 1.0)]),
        many(&[(z, ahead, -1.0)]),
        many(&[(z, ahead, 1.0), (x, -ahead, 1.0)]),
        many(&[mirrored[0], mirrored[1], (z, zero, 1.0)]),
        many(&mirrored),
        Attitude::mean(&[]).err(),
        Attitude::mean(&[(one, 0.0)]).err(),
        Attitude::mean(&[(one, nan)]).err(),
        Attitude::mean(&[(one, 2.0), (half, 2.0)]).err(),
        one.toward(&half, 0.5).err(),
        one.toward(&one, nan).err(),
        arcs(&[]),
        arcs(&[(0.0, one), (0.0, one)]),
        arcs(&[(0.0, one), (nan, one)]),
        arcs(&[(0.0, one), (1.0, half)]),
        Attitude::from_modified_rodrigues([0.0, nan, 0.0]).err(),
        Attitude::from_uniform([0.0, 1.5, 0.0]).err(),
        unwrapped(&[0.0, nan]).err(),
        unwrapped(&[1e308, -1e308]).err(),
        one.angles_locked(Sequence::Zyx, 2.0).err(),
    ];
    let parts = "element of the matrix = NaN | smallest singular value of the matrix = 0 | \
        smallest singular value of the matrix = -0.5 | \
        smallest singular value of the matrix = 0 | lead over the next best = | \
        distance of the matrix = inf | angle of the two vectors in space = 3.14159 | \
        length of the vector in space = 0 | component of a direction = NaN | \
        angle of the two vectors on the body = 0 | number of weights = 0 | \
        directions off one line = 0 | weights[0]: weight = -1 | \
        off one line = 0 | directions[2]: length | lead over the next best = | \
        number of weights = 0 | largest weight = 0 | weights[0]: weight = NaN | the mean is not the only one | \
        angle between the two attitudes = 3.14159 | part = NaN | number of attitudes = 0 | \
        times[1]: value = 0 | attitudes[1]: t = NaN | attitudes[1]: angle between | \
        sigma_2 = NaN | random number = 1.5 | angles[1]: angle = NaN | \
        angles[0]: angle = 1e308 | within = 2 is not allowed";
    let mut refused = 0;
    for (error, part) in errors.into_iter().zip(parts.split(" | ")) {
        let text = error.expect(part).to_string();
        assert!(text.contains(part) && text.len() < 250, "{part}: {text}");
        refused += 1;
    }
    assert_eq!(refused, 31);
    let arcs = Arcs::through(&[(1.0, one), (2.0, about_x(1.0))]).expect("arcs");
    for t in [nan, f64::INFINITY, 0.999, 2.001] {
        assert!(arcs.at(t).is_err(), "{t}");
    }
    // Huge and tiny parameters are parameters.
    for size in [1e300, 1e-300] {
        let attitude = Attitude::from_modified_rodrigues([0.0, size, 0.0]).expect("finite");
        assert!((attitude.modified_rodrigues()[1].abs() - size.min(1.0 / size)).abs() <= 1e-315);
    }
}
