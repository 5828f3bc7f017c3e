//! Rates that are tiny beside the fastest, down to the smallest double.

use rotation_dynamics::Error;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::exact::free_body::{FreeBody, Kind};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{EPS, ldexp, log, pow};
use support::{Errors, assert_largest};

const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

fn free([i1, i2, i3]: [f64; 3], omega: [f64; 3]) -> Result<FreeBody, Error> {
    let moments = PrincipalMoments::new(i1, i2, i3)?;
    FreeBody::new(moments, Attitude::IDENTITY, BodyVector::from_array(omega))
}

/// From 1e-75 to 1e-90, where a constructor once did not return, and on to the smallest.
fn small_rates() -> Vec<f64> {
    let mut sizes: Vec<f64> = (75..=90)
        .flat_map(|n| [1.0, 1.7, 4.0, 7.9].map(|k| k * pow(10.0, -f64::from(n))))
        .collect();
    sizes.extend([1e-10, 1e-30, 1e-50, 1e-120, 1e-150, 1e-154, 1e-160, 1e-162]);
    sizes.extend([1e-200, 1e-290, 1e-307, 1e-310, 1e-320, 5e-324]);
    sizes
}

/// Whatever rates are small, about whatever axes: the body starts where it is put, and L
/// and the length of the quaternion stay.
#[test]
fn rates_of_any_size_make_a_motion() {
    let mut starts = Errors::in_units_of(EPS, "start");
    let mut drifts = Errors::in_units_of(EPS, "drift of L");
    let mut lengths = Errors::in_units_of(EPS, "length of the quaternion");
    let mut late = Errors::in_units_of(EPS, "drift of L, rates late by 1e-9");
    for order in ORDERS {
        let moments = order.map(|i| [1.0, 2.0, 2.5][i]);
        for (axis, size) in
            (0..3).flat_map(|axis| small_rates().into_iter().map(move |s| (axis, s)))
        {
            for [p, q] in [[1.0, 1.0], [1.0, 0.0], [0.0, 1.0], [1e-3, -1.0], [1.0, 1e-160]] {
                let mut omega = [size * p; 3];
                omega[axis] = 1.0;
                omega[(axis + 1) % 3] = size * q;
                let motion = free(moments, omega).expect("a motion");
                let want = BodyVector::from_array(omega);
                starts.push((motion.angular_velocity(0.0) - want).norm());
                for t in [0.0, 7.3, -500.0, 1e5] {
                    let Kinematics { attitude, angular_velocity: rates } = motion.kinematics(t);
                    let momentum = motion.angular_momentum();
                    let now = attitude.to_space(motion.body_momentum(rates));
                    drifts.push((now - momentum).norm() / momentum.norm());
                    let square: f64 = attitude.quaternion().iter().map(|c| c * c).sum();
                    lengths.push(square - 1.0);
                }
            }
        }
        // Some that tumble: rates read late do not fit.
        let tumbling = free(moments, [1.0, 0.5, 0.7]).expect("a motion");
        let (momentum, attitude) = (tumbling.angular_momentum(), tumbling.attitude(7.3));
        let rates = tumbling.angular_velocity(7.3 + 1e-9);
        let now = attitude.to_space(tumbling.body_momentum(rates));
        late.push((now - momentum).norm() / momentum.norm());
    }
    let ran = 6 * 3 * (64 + 14) * 5;
    assert_largest!(starts, ran, @"1.47");
    assert_largest!(drifts, 4 * ran, @"19");
    assert_largest!(lengths, 4 * ran, @"10");
    late.exceed(1e5, 6);
}

/// What is small beside a steady rotation scales: it is 1e-30 times as large as at 1e-30.
#[test]
fn small_wobbles_scale() {
    let mut errors = Errors::in_units_of(EPS, "wobble over its size");
    let mut damaged = Errors::in_units_of(EPS, "wobble over a size that is off by 1e-13");
    let mut ran = 0;
    for order in ORDERS {
        let moments = order.map(|i| [1.0, 2.0, 2.5][i]);
        // About the smallest and the largest moment.
        for steady in [0, 2] {
            let axis = order.iter().position(|i| *i == steady).expect("an axis");
            let wobble = |size: f64, t: f64| {
                let mut omega = [0.7 * size; 3];
                omega[axis] = 1.0;
                omega[(axis + 1) % 3] = -size;
                let rates = free(moments, omega).expect("a motion").angular_velocity(t);
                let rates = rates.to_array();
                [rates[(axis + 1) % 3], rates[(axis + 2) % 3]]
            };
            let unit = ldexp(1.0, -100);
            for exponent in [-200, -266, -280, -500, -530, -700, -960] {
                let size = ldexp(1.0, exponent);
                for t in [0.0, 3.3, 71.0] {
                    for (got, want) in wobble(size, t).into_iter().zip(wobble(unit, t)) {
                        errors.push_at(got / size - want / unit, (exponent, t));
                        damaged.push(got / size * (1.0 + 1e-13) - want / unit);
                    }
                    ran += 2;
                }
            }
        }
    }
    assert_eq!(ran, 6 * 2 * 7 * 3 * 2);
    assert_largest!(errors, ran, @"0");
    damaged.exceed(1.0, ran);
}

/// A push of the middle axis, however small, ends in a flip: a quarter of the period later
/// that rate is zero, and the period grows as the logarithm of the push.
#[test]
fn the_smallest_push_flips_the_body() {
    let root = 3.0_f64.sqrt();
    let reference = free([1.0, 2.0, 3.0], [1e-10, 1.0, 0.0]).expect("a motion");
    let mut periods = Errors::in_units_of(EPS, "period");
    let mut flips = Errors::in_units_of(EPS, "middle rate a quarter later");
    let mut late = Errors::in_units_of(EPS, "the same, 1e-11 of the period late");
    for push in small_rates().into_iter().filter(|push| *push < 1e-20) {
        let motion = free([1.0, 2.0, 3.0], [push, 1.0, 0.0]).expect("a motion");
        assert_eq!(motion.kind(), Kind::Asymmetric);
        let period = motion.rate_period();
        // Growth rate 1/sqrt(3), four passages a period.
        let grown = 4.0 * root * (log(1e-10) - log(push));
        periods.push_at((period - reference.rate_period() - grown) / period, push);
        let rate = |t: f64| motion.angular_velocity(t).y() / period;
        flips.push_at(rate(0.25 * period), push);
        late.push(rate(0.25 * period * (1.0 + 1e-11)));
    }
    assert_largest!(periods, 77, @"1.77");
    assert_largest!(flips, 77, @"0.115");
    late.exceed(1e3, 77);
}

/// The inputs by which this was found.
#[test]
fn a_free_body_from_the_edge_of_the_doubles() {
    let returned = free([1.0, 2.0, 2.5], [4e-81, 4e-81, 1.0]).expect("a motion");
    assert_eq!(returned.kind(), Kind::Asymmetric);
    // The rate about the middle axis of (2, 1, 1.5) is the third.
    let pushed = free([2.0, 1.0, 1.5], [0.0, 1e-200, 1.0]).expect("a motion");
    for t in [0.0, 1.0, 1e3, -1e5, 1e15] {
        let Kinematics { attitude, angular_velocity: rates } = pushed.kinematics(t);
        assert!(attitude.quaternion().iter().all(|c| c.is_finite()) && rates.is_finite());
    }
    let refused = |moments, omega| free(moments, omega).expect_err("too far from one").to_string();
    let messages = [
        (refused([1.0, 2.0, 2.5], [1e-240, 1e-241, 0.0]), "1e-240"),
        (refused([1.0, 1.0, 1.5], [1e240, 1e240, 0.0]), "1e240"),
        (refused([1e-130, 1.0, 1.0 + 2.0 * EPS], [1.0, 1.0, 1.0]), "I_min/I_max = 9.99"),
        (refused([1e300; 3], [1e10, 0.0, 0.0]), "I omega^2 = inf"),
    ];
    for (message, part) in &messages {
        assert!(message.contains(part), "{message}");
    }
    assert_eq!(messages.len(), 4);
    assert!(free([1.0, 2.0, 2.5], [0.0; 3]).is_ok());
}
