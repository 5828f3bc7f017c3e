//! Attitudes from the world: each against a second route, and what is refused.

use super::any_attitude;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use rotation_dynamics::attitude::{Arcs, Attitude, EulerAngles, Sequence, unwrapped};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::{self, DoubleDouble, EPS};
use std::f64::consts::{PI, TAU};
use support::{Errors, Random};

type Seen = (BodyVector, SpaceVector, f64);

/// The orthogonal factor of a matrix: the mean of X and the transposed inverse, again and again.
fn polar(matrix: Matrix3<f64>) -> Attitude {
    let mut x = matrix;
    for _ in 0..60 {
        let next = (x + x.try_inverse().expect("regular").transpose()) * 0.5;
        let change = (next - x).norm();
        x = next;
        // It converges quadratically.
        if change < 1e-9 {
            break;
        }
    }
    Rotation3::from_matrix_unchecked(x)
        .try_into()
        .expect("a rotation")
}

fn rows(matrix: &Matrix3<f64>) -> [[f64; 3]; 3] {
    matrix.transpose().into()
}

fn turned_by(random: &mut Random, attitude: &Attitude, size: f64) -> Attitude {
    let by = BodyVector::from(random.vector()) * size;
    attitude.turned_in_body(by).expect("finite")
}

#[test]
fn the_nearest_rotation_is_the_polar_factor() {
    let mut random = Random(81);
    let mut errors = Errors::in_units_of(EPS, "nearest");
    let mut distances = Errors::in_units_of(EPS, "distance, by singular values");
    let mut damaged = Errors::in_units_of(EPS, "Gram and Schmidt");
    for _ in 0..3000 {
        let rotation = Rotation3::from(any_attitude(&mut random)).into_inner();
        let noise = Matrix3::from_fn(|_, _| random.between(-0.15, 0.15));
        let m = rotation + noise;
        let (nearest, distance) = Attitude::nearest(rows(&m)).expect("a rotation is near");
        errors.push(nearest.angle_to(&polar(m)));
        let off = m.singular_values().add_scalar(-1.0).norm();
        distances.push(distance - off);
        let (z, y) = (m.column(2).into_owned(), m.column(1).into_owned());
        let wrong = Attitude::try_from(Rotation3::face_towards(&z, &y)).expect("a rotation");
        damaged.push(nearest.angle_to(&wrong));
    }
    errors.attain(5.8..=5.9, 3000);
    distances.attain(15.4..=15.6, 3000);
    damaged.exceed(1e9, 3000);
    // A matrix of f32, and matrices of any size.
    let mut single = Errors::of("of f32");
    for _ in 0..1000 {
        let attitude = any_attitude(&mut random);
        let m = attitude
            .matrix()
            .map(|row| row.map(|c| f64::from(c as f32)));
        assert!(Attitude::from_matrix(m).is_err());
        let (nearest, distance) = Attitude::nearest(m).expect("near");
        single.push(distance);
        single.push(nearest.angle_to(&attitude));
        for size in [1e-300, 1e300] {
            let (scaled, _) = Attitude::nearest(m.map(|row| row.map(|c| c * size))).expect("near");
            assert!(scaled.angle_to(&nearest) < 20.0 * EPS);
        }
    }
    single.attain(5.8e-8..=5.9e-8, 2000);
}

/// The step of Newton's method from an attitude to where the sum of w s.Rb is stationary (rad),
/// times the lead over the next best.
fn newton(attitude: Attitude, seen: &[Seen]) -> f64 {
    let (mut slope, mut curvature) = (Vector3::zeros(), Matrix3::zeros());
    for (body, space, weight) in seen {
        let s = Vector3::from(*space).normalize();
        let there = Vector3::from(attitude.to_space(*body)).normalize();
        slope += *weight * there.cross(&s);
        let product = s * there.transpose();
        curvature +=
            *weight * (Matrix3::identity() * s.dot(&there) - (product + product.transpose()) * 0.5);
    }
    let lead = 4.0 * curvature.symmetric_eigenvalues().min() / curvature.trace();
    lead * (curvature.try_inverse().expect("regular") * slope).norm()
}

fn loss(attitude: &Attitude, seen: &[Seen]) -> f64 {
    let off = |(b, s, w): &Seen| {
        let off = attitude.to_space(*b / b.norm()) - *s / s.norm();
        w * off.dot(&off)
    };
    seen.iter().map(off).sum()
}

#[test]
fn directions_give_the_attitude_that_misses_them_least() {
    let mut random = Random(82);
    let mut errors = Errors::in_units_of(EPS, "Newton's step");
    let mut damaged = Errors::in_units_of(EPS, "the first two alone");
    let mut tried = 0;
    for case in 0..2000 {
        let attitude = any_attitude(&mut random);
        let noise = random.size(1e-6, 0.3);
        let seen: Vec<Seen> = (0..3 + case % 4)
            .map(|_| {
                let body = BodyVector::from(random.vector());
                let off = SpaceVector::from(random.vector()) * (noise * body.norm());
                (body, attitude.to_space(body) + off, random.size(0.1, 10.0))
            })
            .collect();
        let (found, missed) = Attitude::from_directions(&seen).expect("directions");
        let total: f64 = seen.iter().map(|(_, _, w)| w).sum();
        // |s - Rb| is 2 sin of half the angle.
        let chord = (loss(&found, &seen) / total).sqrt();
        assert!(chord <= missed + 1e-12 && missed < 1.1 * chord + 1e-12);
        errors.push(newton(found, &seen));
        for _ in 0..20 {
            let near = turned_by(&mut random, &found, 0.1);
            let other = if tried % 2 == 0 {
                near
            } else {
                any_attitude(&mut random)
            };
            assert!(loss(&other, &seen) > loss(&found, &seen));
            tried += 1;
        }
        let pair = |i: usize| (seen[i].0, seen[i].1);
        let (two, _) = Attitude::from_two_directions(pair(0), pair(1)).expect("directions");
        damaged.push(newton(two, &seen));
    }
    assert_eq!(tried, 40_000);
    errors.attain(9.1..=9.2, 2000);
    damaged.exceed(1e6, 2000);
}

#[test]
fn two_directions_to_a_microradian_from_one_line() {
    let mut random = Random(83);
    let [mut triad, mut first, mut many] = ["two directions", "the first of them", "as many"]
        .map(|name| Errors::in_units_of(EPS, name));
    let mut damaged = Errors::in_units_of(EPS, "exchanged");
    for case in 0..3000 {
        let attitude = any_attitude(&mut random);
        let one = BodyVector::from(random.vector());
        let angle = random.size(1e-5, 1.5);
        let beside = one.cross(&BodyVector::from(random.vector()));
        let two = one * math::cos(angle) + beside * (one.norm() / beside.norm() * math::sin(angle));
        let (two, size) = (
            if case % 2 == 0 { two } else { -two },
            random.size(1e-150, 1e150),
        );
        let (a, b) = (attitude.to_space(one), attitude.to_space(two) * size);
        let (found, missed) = Attitude::from_two_directions((one, a), (two, b)).expect("two");
        triad.push(found.angle_to(&attitude) * math::sin(angle));
        triad.push(missed);
        first.push((found.to_space(one) - a).norm() / a.norm());
        let (found, _) = Attitude::from_directions(&[(one, a, 1.0), (two, b, 1.0)]).expect("two");
        many.push(found.angle_to(&attitude) * angle * angle / 2.0);
        let wrong = Attitude::from_two_directions((one, b), (two, a))
            .expect("two")
            .0;
        damaged.push(wrong.angle_to(&attitude));
    }
    triad.attain(5.9..=6.0, 6000);
    first.attain(9.3..=9.4, 3000);
    many.attain(4.4..=4.5, 3000);
    damaged.exceed(1e9, 3000);
}

#[test]
fn the_mean_is_that_of_the_matrices_and_of_the_turns() {
    let mut random = Random(84);
    let [mut errors, mut close, mut damaged] =
        ["of matrices", "of turns", "of quaternions"].map(|name| Errors::in_units_of(EPS, name));
    for _ in 0..2000 {
        let middle = any_attitude(&mut random);
        let around = |random: &mut Random, size| -> Vec<(Attitude, f64)> {
            (0..6)
                .map(|_| (turned_by(random, &middle, size), random.size(0.1, 10.0)))
                .collect()
        };
        let wide = around(&mut random, 0.8);
        let mean = Attitude::mean(&wide).expect("a mean");
        let sum = |sum, (a, w): &(Attitude, f64)| sum + Rotation3::from(*a).into_inner() * *w;
        errors.push(mean.angle_to(&polar(wide.iter().fold(Matrix3::zeros(), sum))));
        // Karcher's: the turns to it add up to nothing. Both differ by the cube of the spread.
        let narrow = around(&mut random, 1e-6);
        let mean = Attitude::mean(&narrow).expect("a mean");
        let total: f64 = narrow.iter().map(|(_, w)| w).sum();
        let turns = narrow
            .iter()
            .map(|(a, w)| (mean.inverse() * *a).rotation_vector() * *w);
        close.push((turns.sum::<SpaceVector>() / total).norm());
        // The signs of quaternions are free.
        let minus = wide[0].0.quaternion().map(|c| -c);
        let wrong = wide
            .iter()
            .skip(1)
            .map(|(a, w)| a.quaternion().map(|c| c * w));
        let start = minus.map(|c| c * wide[0].1);
        let wrong = wrong.fold(start, |sum, q| std::array::from_fn(|i| sum[i] + q[i]));
        let mut list = wide.clone();
        list[0].0 = Attitude::from_quaternion(minus).expect("a unit");
        assert_eq!(Attitude::mean(&list), Attitude::mean(&wide));
        damaged.push(
            Attitude::from_quaternion(wrong)
                .expect("not zero")
                .angle_to(&mean),
        );
    }
    errors.attain(6.5..=6.6, 2000);
    close.attain(5.4..=5.5, 2000);
    damaged.exceed(1e9, 2000);
}

/// (sin (1-p)h a + sin ph b)/sin h to 100 bits, h half the angle.
fn slerp(a: Attitude, b: Attitude, part: f64) -> Attitude {
    let (p, mut q) = (a.quaternion(), b.quaternion());
    if p.iter().zip(q).map(|(x, y)| x * y).sum::<f64>() < 0.0 {
        q = q.map(|c| -c);
    }
    let length = |sign: f64| {
        let squares = (0..4).map(|i| DoubleDouble::sum(p[i], sign * q[i]).square());
        squares
            .fold(DoubleDouble::ZERO, |sum, square| sum + square)
            .sqrt()
    };
    let half = length(-1.0).atan2(length(1.0)).scaled(2.0);
    if half == 0.0 {
        return a;
    }
    let rest = (half - half * part).sin();
    let (of_p, of_q) = (rest / half.sin(), (half * part).sin() / half.sin());
    let mixed = std::array::from_fn(|i| (of_p * p[i] + of_q * q[i]).to_f64());
    Attitude::from_quaternion(mixed).expect("not zero")
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
    errors.attain(6.6..=6.7, 9000);
    assert!(damaged.largest() > 1e5);
}

#[test]
fn other_parameters_and_back() {
    let mut random = Random(86);
    let [mut from, mut into, mut locked, mut matrices] =
        ["from Rodrigues", "into", "locked", "Rotation3"]
            .map(|name| Errors::in_units_of(EPS, name));
    for case in 0..3000 {
        let sigma = random.vector::<3>();
        let length = SpaceVector::from(sigma).norm();
        let attitude = Attitude::from_modified_rodrigues(sigma).expect("finite");
        let square = sigma.map(|c| DoubleDouble::from(c).square());
        let w = (1.0 - (square[0] + square[1] + square[2])).to_f64();
        let [x, y, z] = sigma.map(|c| 2.0 * c);
        let direct = Attitude::from_quaternion([w, x, y, z]).expect("not zero");
        from.push(attitude.angle_to(&direct));
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
        let angles = [
            random.between(-PI, PI),
            lock + 1e-12 * random.unit(),
            random.between(-PI, PI),
        ];
        let near = Attitude::from_sequence(sequence, angles).expect("finite");
        let at = near.angles_locked(sequence, 1e-9).expect("allowed");
        assert!(at[2] == 0.0 && near.angles(sequence)[2] != 0.0 && at[0].abs() <= PI + EPS);
        let there = Attitude::from_sequence(sequence, at).expect("finite");
        // By what the second angle was moved, and no more.
        let moved = (near.angles(sequence)[1] - at[1]).abs();
        locked.push(there.angle_to(&near) - moved);
        assert_eq!(
            near.angles_locked(sequence, 0.0).expect("allowed"),
            near.angles(sequence)
        );
        let theirs = Rotation3::from(near);
        matrices.push(
            Attitude::try_from(theirs)
                .expect("a rotation")
                .angle_to(&near),
        );
        let v = BodyVector::from(random.vector());
        let turned = SpaceVector::from(theirs * Vector3::from(v));
        matrices.push((turned - near.to_space(v)).norm() / v.norm());
    }
    from.attain(3.0..=3.1, 3000);
    into.attain(3.7..=3.8, 3000);
    locked.attain(4.0..=4.1, 3000);
    matrices.attain(5.7..=5.8, 6000);
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
    sums[0]
        .iter()
        .for_each(|sum| moments.add(*sum, 0.125, 0.125));
    sums[1]
        .iter()
        .for_each(|sum| damaged.add(*sum, 0.125, 0.125));
    moments.attain(9.6e-3..=9.7e-3, 4);
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
    counted
        .iter()
        .zip(&true_ones)
        .for_each(|(c, t)| errors.add(*c, *t, t.abs().max(PI)));
    errors.attain(0.0..=0.0, 3000);
    let faster: Vec<f64> = read.iter().step_by(3).copied().collect();
    assert!((unwrapped(&faster).expect("finite")[999] - counted[2997]).abs() > TAU);
    // A steady top, read from its attitude.
    let top = |i: u32| EulerAngles {
        phi: 0.3 * f64::from(i),
        theta: 1.0,
        zeta: -2.9 * f64::from(i),
    };
    let seen = (0..500).map(|i| Attitude::from_euler(top(i)).expect("finite").euler_angles());
    let counted = EulerAngles::unwrapped(&seen.collect::<Vec<_>>()).expect("finite");
    assert!((counted[499].phi - top(499).phi).abs() < 1e-13);
    assert!((counted[499].zeta - top(499).zeta).abs() < 1e-12);
    assert_eq!(unwrapped(&[]), Ok(vec![]));
}

#[test]
fn what_the_world_cannot_tell_is_refused_with_the_numbers() {
    let (nan, one) = (f64::NAN, Attitude::IDENTITY);
    let nearest = |diagonal| Attitude::nearest(rows(&Matrix3::from_diagonal(&diagonal))).err();
    let d = Vector3::new;
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(BodyVector::from);
    let s = SpaceVector::new;
    let (right, up) = (s(1.0, 0.0, 0.0), s(0.0, 0.0, 2.0));
    let (ahead, zero) = (s(0.0, 1.0, 0.0), SpaceVector::zero());
    let about_x = |angle| Attitude::about_space_axis(right, angle).expect("finite");
    let half = about_x(PI);
    let two = |a, b| Attitude::from_two_directions((z, a), (x, b)).err();
    let many = |list: &[Seen]| Attitude::from_directions(list).err();
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
    let parts = "
        element of the matrix = NaN
        smallest singular value of the matrix = 0
        smallest singular value of the matrix = -0.5
        smallest singular value of the matrix = 0
        lead over the next best = 
        distance of the matrix = inf
        angle of the two vectors in space = 3.14159
        length of the vector in space = 0
        component of a direction = NaN
        angle of the two vectors on the body = 0
        largest weight = 0
        vectors on the body off one line = 0
        weights[0]: weight = -1
        in space off one line = 0
        directions[2]: length
        lead over the next best = 
        largest weight = 0
        weights[0]: weight = NaN
        the mean is not the only one
        angle between the two attitudes = 3.14159
        part = NaN
        number of attitudes = 0
        times[1]: value = 0
        attitudes[1]: t = NaN
        attitudes[1]: angle between
        sigma_2 = NaN
        random number = 1.5
        angles[1]: angle = NaN
        angles[0]: angle = 1e308
        within = 2 is not allowed";
    let parts = parts.lines().skip(1).map(str::trim);
    let mut refused = 0;
    for (error, part) in errors.into_iter().zip(parts) {
        let text = error.expect(part).to_string();
        assert!(text.contains(part) && text.len() < 250, "{part}: {text}");
        refused += 1;
    }
    assert_eq!(refused, 30);
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
