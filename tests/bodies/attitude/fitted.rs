//! Attitudes that fit a matrix, directions or other attitudes, each against a second route.

use super::{any_attitude, turned_by, unit};
use nalgebra::{Matrix3, Rotation3, Vector3};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::{self, EPS};
use support::{Errors, Random, assert_largest};

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
    Rotation3::from_matrix_unchecked(x).try_into().expect("a rotation")
}

fn rows(matrix: &Matrix3<f64>) -> [[f64; 3]; 3] {
    matrix.transpose().into()
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
    assert_largest!(errors, 3000, @"5.80");
    assert_largest!(distances, 3000, @"15.5");
    damaged.exceed(1e9, 3000);
    // A matrix of f32, and matrices of any size.
    let mut single = Errors::of("of f32");
    for _ in 0..1000 {
        let attitude = any_attitude(&mut random);
        let m = attitude.matrix().map(|row| row.map(|c| f64::from(c as f32)));
        assert!(Attitude::from_matrix(m).is_err());
        let (nearest, distance) = Attitude::nearest(m).expect("near");
        single.push(distance);
        single.push(nearest.angle_to(&attitude));
        for size in [1e-300, 1e300] {
            let (scaled, _) = Attitude::nearest(m.map(|row| row.map(|c| c * size))).expect("near");
            assert!(scaled.angle_to(&nearest) < 20.0 * EPS);
        }
    }
    assert_largest!(single, 2000, @"5.90e-8");
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
        for _ in 0..10 {
            let near = turned_by(&mut random, &found, 0.1);
            for other in [near, any_attitude(&mut random)] {
                assert!(loss(&other, &seen) > loss(&found, &seen));
                tried += 1;
            }
        }
        let pair = |i: usize| (seen[i].0, seen[i].1);
        let (two, _) = Attitude::from_two_directions(pair(0), pair(1)).expect("directions");
        damaged.push(newton(two, &seen));
    }
    assert_eq!(tried, 40_000);
    assert_largest!(errors, 2000, @"8.29");
    damaged.exceed(1e6, 2000);
}

#[test]
fn two_directions_to_a_microradian_from_one_line() {
    let mut random = Random(83);
    let [mut triad, mut first, mut many] = ["two directions", "the first of them", "as many"]
        .map(|name| Errors::in_units_of(EPS, name));
    let mut damaged = Errors::in_units_of(EPS, "exchanged");
    let mut singular = Errors::in_units_of(EPS, "by nalgebra's singular values");
    for case in 0..3000 {
        let attitude = any_attitude(&mut random);
        let one = BodyVector::from(random.vector());
        let angle = random.size(1e-5, 1.5);
        let beside = one.cross(&BodyVector::from(random.vector()));
        let two = one * math::cos(angle) + beside * (one.norm() / beside.norm() * math::sin(angle));
        let two = if case % 2 == 0 { two } else { -two };
        let size = random.size(1e-150, 1e150);
        let (a, b) = (attitude.to_space(one), attitude.to_space(two) * size);
        let (found, missed) = Attitude::from_two_directions((one, a), (two, b)).expect("two");
        triad.push(found.angle_to(&attitude) * math::sin(angle));
        triad.push(missed);
        first.push((found.to_space(one) - a).norm() / a.norm());
        let (found, _) = Attitude::from_directions(&[(one, a, 1.0), (two, b, 1.0)]).expect("two");
        many.push(found.angle_to(&attitude) * angle * angle / 2.0);
        let (u, v) = (Vector3::from(one).normalize(), Vector3::from(two).normalize());
        let (p, q) = (Vector3::from(a).normalize(), Vector3::from(b).normalize());
        let svd = (p * u.transpose() + q * v.transpose()).svd(true, true);
        let (left, right) = (svd.u.expect("asked for"), svd.v_t.expect("asked for"));
        let sign = Vector3::new(1.0, 1.0, (left * right).determinant().signum());
        let by_svd = polar(left * Matrix3::from_diagonal(&sign) * right);
        singular.push(by_svd.angle_to(&attitude) * angle * angle / 2.0);
        let (wrong, _) = Attitude::from_two_directions((one, b), (two, a)).expect("two");
        damaged.push(wrong.angle_to(&attitude));
    }
    assert_largest!(triad, 6000, @"5.95");
    assert_largest!(first, 3000, @"9.36");
    assert!(singular.largest() > 1e8);
    assert_largest!(many, 3000, @"4.44");
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
            (0..6).map(|_| (turned_by(random, &middle, size), random.size(0.1, 10.0))).collect()
        };
        let wide = around(&mut random, 0.8);
        let mean = Attitude::mean(&wide).expect("a mean");
        let sum = |sum, (a, w): &(Attitude, f64)| sum + Rotation3::from(*a).into_inner() * *w;
        errors.push(mean.angle_to(&polar(wide.iter().fold(Matrix3::zeros(), sum))));
        // Karcher's: the turns to it add up to nothing. Both differ by the cube of the spread.
        let narrow = around(&mut random, 1e-6);
        let mean = Attitude::mean(&narrow).expect("a mean");
        let total: f64 = narrow.iter().map(|(_, w)| w).sum();
        let turns = narrow.iter().map(|(a, w)| (mean.inverse() * *a).rotation_vector() * *w);
        close.push((turns.sum::<SpaceVector>() / total).norm());
        // The signs of quaternions are free, but not for the mean of the four numbers.
        let mean = Attitude::mean(&wide);
        let mut list = wide;
        list[0].0 = unit(list[0].0.quaternion().map(|c| -c));
        assert_eq!(Attitude::mean(&list), mean);
        let sum = |i: usize| list.iter().map(|(a, w)| w * a.quaternion()[i]).sum();
        damaged.push(unit(std::array::from_fn(sum)).angle_to(&mean.expect("a mean")));
    }
    assert_largest!(errors, 2000, @"6.51");
    assert_largest!(close, 2000, @"5.41");
    damaged.exceed(1e9, 2000);
}
