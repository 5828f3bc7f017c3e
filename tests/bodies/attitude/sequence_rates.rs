//! Rates of the angles of a sequence, and the angular velocity they make.

use rotation_dynamics::attitude::{
    Attitude, EulerAngles, EulerRates, Sequence, YawPitchRoll, YawPitchRollRates,
};
use rotation_dynamics::error::Error;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::{self, DoubleDouble, EPS};
use std::f64::consts::{FRAC_PI_2, PI};
use support::{Errors, Random, assert_largest};

/// A vector turned by `-angle` about a coordinate axis, to 100 bits.
fn turned_back(v: [DoubleDouble; 3], axis: usize, angle: f64) -> [DoubleDouble; 3] {
    let (sin, cos) = DoubleDouble::from(angle).sin_cos();
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut out = v;
    out[j] = cos * v[j] + sin * v[k];
    out[k] = cos * v[k] - sin * v[j];
    out
}

/// Each turn's axis, carried back by the turns after it, times its rate.
fn sum_of_turns(sequence: Sequence, angles: [f64; 3], rates: [f64; 3]) -> [DoubleDouble; 3] {
    let axes = sequence.axes();
    let mut sum = [DoubleDouble::ZERO; 3];
    for turn in 0..3 {
        let mut axis = [DoubleDouble::ZERO; 3];
        axis[axes[turn]] = rates[turn].into();
        for later in turn + 1..3 {
            axis = turned_back(axis, axes[later], angles[later]);
        }
        sum = [0, 1, 2].map(|i| sum[i] + axis[i]);
    }
    sum
}

#[test]
fn angular_velocity_is_the_sum_of_the_turns() {
    let mut random = Random(51);
    let [mut errors, mut back, mut damaged] =
        ["angular velocity", "rates", "no first turn"].map(|what| Errors::in_units_of(EPS, what));
    for sequence in Sequence::ALL {
        let lock = if sequence.is_proper() { 0.0 } else { FRAC_PI_2 };
        for n in 0..1000 {
            let near = math::pow(10.0, random.between(-20.0, 0.0));
            let second = if n % 2 == 0 { random.between(-PI, PI) } else { lock + near };
            let angles = [random.between(-PI, PI), second, random.between(-PI, PI)];
            let rates = random.vector();
            let size = rates.iter().map(|r| r.abs()).sum();
            let exact = sum_of_turns(sequence, angles, rates);
            let got = sequence.angular_velocity(angles, rates);
            for (exact, got) in exact.into_iter().zip(got.to_array()) {
                errors.add((exact - got).to_f64(), 0.0, size);
            }
            let [_, b, c] = rates;
            let short = sequence.angular_velocity(angles, [0.0, b, c]);
            damaged.push((short - got).norm());
            match sequence.rates(angles, got) {
                Ok(found) => {
                    let (sin, cos) = math::sincos(second);
                    let condition = if sequence.is_proper() { sin } else { cos };
                    for (found, rate) in found.into_iter().zip(rates) {
                        back.push((found - rate) * condition);
                    }
                }
                Err(error) => {
                    assert!(matches!(error, Error::GimbalLock { .. }) && second == FRAC_PI_2);
                    (0..3).for_each(|_| back.push(0.0));
                }
            }
        }
    }
    assert_largest!(errors, 3 * 12_000, @"1.38");
    assert_largest!(back, 3 * 12_000, @"3.40");
    damaged.exceed(1e10, 12_000);
}

/// Against the turning of the attitude itself.
#[test]
fn angular_velocity_is_how_the_attitude_turns() {
    let (angles, rates) = ([0.4, 1.1, -0.7], [0.8, -0.5, 1.9]);
    let mut count = 0;
    for sequence in Sequence::ALL {
        let at = |t: f64| {
            let now = [0, 1, 2].map(|i| angles[i] + rates[i] * t);
            Attitude::from_sequence(sequence, now).expect("finite")
        };
        let error = |h: f64, velocity: BodyVector| {
            let turned = (at(-h).inverse() * at(h)).rotation_vector();
            (BodyVector::from(turned.to_array()) / (2.0 * h) - velocity).norm()
        };
        let velocity = sequence.angular_velocity(angles, rates);
        let order = math::log2(error(0.02, velocity) / error(0.01, velocity));
        assert!((1.999..2.001).contains(&order), "{sequence:?}: {order}");
        // Damaged: taken on the fixed axes.
        let wrong = at(0.0).to_space(velocity).to_array().into();
        let order = math::log2(error(0.02, wrong) / error(0.01, wrong));
        assert!(order.abs() < 0.1, "{order}");
        count += 1;
    }
    assert_eq!(count, 12);
}

#[test]
fn named_angles_are_of_the_twelve() {
    let mut random = Random(52);
    let mut errors = Errors::in_units_of(EPS, "notes' and general form");
    for _ in 0..1000 {
        let [phi, theta, zeta] = random.vector();
        let [a, b, c] = random.vector();
        let notes = EulerAngles { phi, theta, zeta };
        let rates = EulerRates { phi: a, theta: b, zeta: c };
        let general = Sequence::Zxz.angular_velocity([phi, theta, zeta], [a, b, c]);
        errors.push((notes.angular_velocity(rates) - general).norm());
        // And the formulas in the documentation of yaw, pitch and roll.
        let named = YawPitchRoll { yaw: phi, pitch: theta, roll: zeta };
        let velocity = named.angular_velocity(YawPitchRollRates { yaw: a, pitch: b, roll: c });
        let (sin_p, cos_p) = math::sincos(theta);
        let (sin_r, cos_r) = math::sincos(zeta);
        let written = BodyVector::new(
            c - a * sin_p,
            b * cos_r + a * cos_p * sin_r,
            a * cos_p * cos_r - b * sin_r,
        );
        errors.push((velocity - written).norm());
        let back = named.rates(velocity).expect("no lock");
        let written = (velocity.y() * sin_r + velocity.z() * cos_r) / cos_p;
        errors.push(back.yaw - written);
        errors.push(back.roll - (velocity.x() + back.yaw * sin_p));
    }
    // One formula, written thrice.
    assert_largest!(errors, 4 * 1000, @"0");
}

#[test]
fn at_a_lock_the_rates_are_refused() {
    let mut count = 0;
    for sequence in Sequence::ALL {
        let locks = if sequence.is_proper() {
            [0.0, -0.0, PI, -PI, 2.0 * PI]
        } else {
            [1.0, -1.0, 3.0, -3.0, 5.0].map(|n| n * FRAC_PI_2)
        };
        for second in locks {
            let error = sequence.rates([0.1, second, 0.2], BodyVector::new(1.0, 0.0, 0.0));
            let error = error.unwrap_err();
            assert!(
                matches!(error, Error::GimbalLock { angle, .. } if angle == second),
                "{sequence:?}: {error}"
            );
            count += 1;
        }
        let near = if sequence.is_proper() { 1e-300 } else { FRAC_PI_2 - 1e-15 };
        let velocity = BodyVector::new(1e-3, 1e-3, 1e-3);
        assert!(sequence.rates([0.0, near, 0.0], velocity).is_ok());
        for bad in [f64::NAN, f64::INFINITY] {
            assert!(sequence.rates([bad, 1.0, 0.0], velocity).is_err());
            assert!(sequence.rates([0.0, bad, 0.0], velocity).is_err());
            assert!(sequence.rates([0.0, 1.0, bad], velocity).is_err());
            let fast = BodyVector::new(0.0, bad, 0.0);
            assert!(sequence.rates([0.0, 1.0, 0.0], fast).is_err());
            assert!(Attitude::from_sequence(sequence, [0.0, 0.0, bad]).is_err());
            count += 5;
        }
    }
    assert_eq!(count, 12 * 15);
    let up = YawPitchRoll { yaw: 0.1, pitch: FRAC_PI_2, roll: 0.0 };
    let error = up.rates(BodyVector::new(1.0, 0.0, 0.0)).unwrap_err();
    assert_eq!(
        error.to_string(),
        "second angle = 1.5707963267948966 of z-y'-x'': the first and the third turn are \
         about the same line and their rates are not defined; it must not be an odd \
         multiple of pi/2"
    );
}
