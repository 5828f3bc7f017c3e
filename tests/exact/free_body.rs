//! The free body in closed form: invariants, consistency of attitude and rates,
//! limits, and what a damaged input does.

use rotation_dynamics::Result;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::exact::free_body::{FreeBody, Kind};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{EPS, log};
use support::{Errors, assert_error, assert_largest};

fn motion(moments: [f64; 3], omega: [f64; 3]) -> FreeBody {
    let [i1, i2, i3] = moments;
    let start = Attitude::from_rotation_vector(SpaceVector::new(0.3, -1.1, 0.7)).expect("finite");
    FreeBody::new(
        PrincipalMoments::new(i1, i2, i3).expect("a real body"),
        start,
        BodyVector::from_array(omega),
    )
    .expect("finite rates")
}

const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// Every regime, in every order of the axes where that matters.
fn cases() -> Vec<FreeBody> {
    let mut cases = Vec::new();
    for order in ORDERS {
        for (moments, omega) in [
            ([1.0, 2.0, 8.0 / 3.0], [0.8, 0.4, 0.3375]),
            ([1.0, 2.0, 8.0 / 3.0], [-0.2, 0.4, -0.9]),
            ([1.0, 2.0, 2.5], [1e-9, 1.3, 2e-9]),
            ([1.0, 2.0, 3.0], [3.0_f64.sqrt(), -0.3, 1.0]),
            ([1.0, 1.0 + 1e-13, 1.7], [0.3, 0.2, 1.0]),
            ([1e-6, 1.0, 1.0 + 1e-7], [30.0, 0.2, 0.5]),
            ([1.0, 1.0, 1.9], [1.0, 0.5, -0.2]),
            ([1.0, 2.0, 2.5], [0.0, -1.5, 0.0]),
            ([2.0, 2.0, 2.0], [1.0, 0.5, 0.2]),
        ] {
            let moved = |v: [f64; 3]| order.map(|i: usize| v[i]);
            cases.push(motion(moved(moments), moved(omega)));
        }
    }
    cases
}

/// The changes of L and of the energy, relative to L and to |L||omega|, over the sampled times.
fn drift(case: &FreeBody, late: f64, drifts: &mut Errors) {
    let (momentum, energy) = (case.angular_momentum(), case.kinetic_energy());
    for k in -40..=40 {
        let t = f64::from(k) * 37.3;
        let (attitude, omega) = (case.attitude(t), case.angular_velocity(t + late));
        let rebuilt = attitude.to_space(case.body_momentum(omega));
        drifts.add((rebuilt - momentum).norm(), 0.0, momentum.norm());
        let turned = attitude.to_body(momentum).dot(&omega) / 2.0;
        // A needle's energy hangs on the direction of L to its last bit: |L||omega| is
        // the scale on which its rounding is felt.
        drifts.add(turned, energy, momentum.norm() * omega.norm());
    }
}

#[test]
fn momentum_and_energy_stay() {
    let cases = cases();
    let mut drifts = Errors::in_units_of(EPS, "drift of L and energy");
    cases.iter().for_each(|case| drift(case, 0.0, &mut drifts));
    assert_largest!(drifts, 54 * 81 * 2, @"14.9");
    // Rates read 1e-12 s late no longer fit the attitude, but where rotation is steady.
    let moving = cases.iter().filter(|c| c.kind() != Kind::Steady);
    let late = |case: &&FreeBody| {
        let mut drifts = Errors::in_units_of(EPS, "drift of L and energy, late");
        drift(case, 1e-12, &mut drifts);
        drifts.largest() > 18.0
    };
    let seen = moving.clone().filter(late).count();
    println!("seen late: {seen} of {}", moving.count());
    assert_eq!(seen, 42);
}

/// Five-point derivative of the attitude against the rates.
fn kinematic_error(case: &FreeBody, damage: f64) -> f64 {
    let t = 1.7;
    let Kinematics { attitude: here, angular_velocity: omega } = case.kinematics(t);
    let h = 1e-3 / omega.norm();
    let turned = |k: f64| here.inverse().then_in_body(&case.attitude(t + k * h));
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(turned);
    let rate = (a - d + (c - b) * 8.0) / (12.0 * h);
    (rate - omega * (1.0 + damage)).norm() / omega.norm()
}

trait Relative {
    /// The rotation from `self`'s inverse to `other`, as a vector on the body axes.
    fn then_in_body(&self, other: &Attitude) -> BodyVector;
}

impl Relative for Attitude {
    fn then_in_body(&self, other: &Attitude) -> BodyVector {
        BodyVector::from_array((*self * *other).rotation_vector().to_array())
    }
}

#[test]
fn the_attitude_turns_with_the_angular_velocity() {
    let mut errors = Errors::of("rotation of the attitude");
    let mut damaged = Errors::of("rotation at a rate that is off by 1e-10");
    for case in cases() {
        errors.push(kinematic_error(&case, 0.0));
        damaged.push(kinematic_error(&case, 1e-10));
    }
    // The truncation of the five points.
    assert_largest!(errors, 54, @"4.29e-12");
    damaged.exceed(8e-12, 54);
}

#[test]
fn the_start_is_the_start() {
    let start = Attitude::from_rotation_vector(SpaceVector::new(0.3, -1.1, 0.7)).expect("finite");
    let off = |t: f64| {
        let mut errors = Errors::in_units_of(EPS, "attitude at the start");
        for case in cases() {
            errors.push(case.attitude(t).angle_to(&start));
        }
        errors
    };
    assert_largest!(off(0.0), 54, @"3.61");
    // A start 1e-14 s late is seen.
    off(1e-14).exceed(3.7, 54);
}

/// On the separatrix the body flips once; beside it, it comes back.
#[test]
fn the_separatrix_is_a_single_flip() {
    // I_hi (I_hi - I_mid) w_hi^2 = 12 = I_lo (I_mid - I_lo) w_lo^2: exactly on it.
    let exact = motion([3.0, 4.0, 6.0], [2.0, 0.5, 1.0]);
    assert_eq!(exact.kind(), Kind::Separatrix);
    assert_eq!(exact.rate_period(), f64::INFINITY);
    let late = exact.angular_velocity(80.0);
    assert!(late.x().abs() < 1e-15 && late.z().abs() < 1e-15, "{late:?}");
    let limit = exact.angular_momentum().norm() / 4.0;
    assert_error!(late.y().abs(), limit, 0.0 eps);
    let beside = motion([3.0, 4.0, 6.0], [2.0, 0.5, 1.0 + 1e-9]);
    assert_eq!(beside.kind(), Kind::Asymmetric);
    let back = (1..=80).any(|t| beside.angular_velocity(f64::from(t)).y() * late.y() < 0.0);
    assert!(back && beside.rate_period() < 80.0, "{}", beside.rate_period());
}

/// All of the separatrix: every sign and order, up to the last digits either side, and from
/// no rate about the middle axis to 1e-200 beside it. On the half of it where the rate that
/// goes as sech is negative, the start once was no number: half of an infinite period was
/// turned back.
#[test]
fn every_part_of_the_separatrix_is_a_motion() {
    let mut start = Errors::in_units_of(EPS, "rates at the start, in parts of the largest");
    let mut turned = Errors::of("rotation of the attitude");
    let mut damaged = Errors::of("rotation at a rate that is off by 1e-10");
    let (mut exactly, mut all) = (0, 0);
    for order in ORDERS {
        for signs in 0..8 {
            for (middle, small) in
                [(1.0, 0.25), (0.0, 1.0), (0.3, 0.7), (1.0, 1e-8), (1.0, 1e-100), (1.0, 1e-200)]
            {
                for part in [1.0 - 2.0 * EPS, 1.0, 1.0 + 2.0 * EPS] {
                    let rates = [2.0 * small, middle, small * part];
                    let rates: [f64; 3] = core::array::from_fn(|i| {
                        if signs >> i & 1 == 0 { rates[i] } else { -rates[i] }
                    });
                    let moved = |v: [f64; 3]| order.map(|i: usize| v[i]);
                    let case = motion(moved([3.0, 4.0, 6.0]), moved(rates));
                    let begun = case.angular_velocity(0.0) - BodyVector::from_array(moved(rates));
                    start.push(begun.norm() / BodyVector::from_array(rates).norm());
                    turned.push(kinematic_error(&case, 0.0));
                    damaged.push(kinematic_error(&case, 1e-10));
                    exactly += usize::from(case.kind() == Kind::Separatrix);
                    all += 1;
                }
            }
        }
    }
    // The middle third; an eps either side is another motion, 1e-200 or not.
    assert_eq!((exactly, all), (6 * 8 * 6, 6 * 8 * 6 * 3));
    assert_largest!(start, all, @"2.14");
    assert_largest!(turned, all, @"5.55e-13");
    damaged.exceed(8e-12, all);
}

/// Next to the middle axis the period grows as the logarithm of the distance.
#[test]
fn the_period_of_the_flip_grows_as_a_logarithm() {
    let period = |d: f64| motion([1.0, 2.0, 3.0], [d, 1.0, 0.0]).rate_period();
    // Growth rate sqrt((I2-I1)(I3-I2)/(I1 I3)) = 1/sqrt(3); four passages a period.
    let slope = (period(1e-10) - period(1e-7)) / log(1e3);
    let want = 4.0 * 3.0_f64.sqrt();
    assert_error!(slope, want, 6.2e-15);
}

#[test]
fn a_rate_that_is_not_a_number_is_refused() -> Result<()> {
    let moments = PrincipalMoments::new(1.0, 2.0, 2.5)?;
    let refused = FreeBody::new(moments, Attitude::IDENTITY, BodyVector::new(0.1, f64::NAN, 0.0));
    let message = refused.expect_err("NaN").to_string();
    assert!(message.contains("angular_velocity"), "{message}");
    Ok(())
}
