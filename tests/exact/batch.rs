//! Many samples at once have the bits of one at a time, in every regime.

use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::exact::free_body::{FreeBody, Kind};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::EPS;
use rotation_dynamics::{Error, Result};
use support::{Errors, assert_largest};

type States = Vec<Kinematics>;

fn motion([i1, i2, i3]: [f64; 3], omega: [f64; 3]) -> Result<FreeBody> {
    let start = Attitude::from_rotation_vector(SpaceVector::new(0.3, -1.1, 0.7))?;
    let moments = PrincipalMoments::new(i1, i2, i3)?;
    FreeBody::new(moments, start, BodyVector::from_array(omega))
}

/// Generic, about either axis, near-symmetric, needle, disc, m near 1, separatrix,
/// symmetric, steady, sphere.
fn cases() -> Result<Vec<FreeBody>> {
    [
        ([1.0, 2.0, 8.0 / 3.0], [0.8, 0.4, 0.3375]),
        ([1.0, 2.0, 8.0 / 3.0], [-0.2, 0.4, -0.9]),
        ([8.0 / 3.0, 1.0, 2.0], [0.9, -0.7, -0.1]),
        ([1.0, 1.0 + 1e-13, 1.7], [0.3, 0.2, 1.0]),
        ([1e-6, 1.0, 1.0 + 1e-7], [30.0, 0.2, 0.5]),
        ([1.0, 1.1, 2.1 - 1e-9], [0.3, 0.2, 1.0]),
        ([1.0, 2.0, 2.5], [1e-9, 1.3, 2e-9]),
        ([1.0, 2.0, 3.0], [3.0_f64.sqrt(), -0.3, 1.0]),
        ([1.0, 2.5, 3.0], [0.75, -0.5, 0.75]),
        ([1.0, 1.0, 1.9], [1.0, 0.5, -0.2]),
        ([1.0, 2.0, 2.5], [0.0, -1.5, 0.0]),
        ([2.0, 2.0, 2.0], [1.0, 0.5, 0.2]),
    ]
    .into_iter()
    .map(|(moments, omega)| motion(moments, omega))
    .collect()
}

/// Small, late, on and next to the turning points; both signs, and zero.
fn times(case: &FreeBody, count: u32) -> Vec<f64> {
    let period = case.rate_period().min(1e3);
    (0..count)
        .map(|k| {
            let x = f64::from(k) - f64::from(count / 2);
            match k % 4 {
                0 => 0.0123 * x,
                1 => 0.25 * period * x,
                2 => 1e7 * x / 3.0,
                _ => (0.25 * period + 1e-12) * x,
            }
        })
        .collect()
}

fn bits(states: &States) -> Vec<[u64; 7]> {
    let of = |state: &Kinematics| {
        let [w, x, y, z] = state.attitude.quaternion();
        let [p, q, r] = state.angular_velocity.to_array();
        [w, x, y, z, p, q, r].map(f64::to_bits)
    };
    states.iter().map(of).collect()
}

fn filled(case: &FreeBody, times: &[f64]) -> Result<States> {
    let mut states = vec![Kinematics::REST; times.len()];
    case.kinematics_at(times, &mut states)?;
    Ok(states)
}

#[test]
fn free_body_has_the_scalar_bits_in_every_regime() -> Result<()> {
    let (mut compared, mut kinds) = (0, Vec::new());
    for case in cases()? {
        // 4003 is no multiple of 4 or 8.
        let times = times(&case, 4003);
        let one_by_one: States = times.iter().map(|t| case.kinematics(*t)).collect();
        assert_eq!(bits(&filled(&case, &times)?), bits(&one_by_one), "{case:?}");
        compared += times.len();
        if !kinds.contains(&case.kind()) {
            kinds.push(case.kind());
        }
    }
    assert_eq!((compared, kinds.len()), (12 * 4003, 4), "{kinds:?}");
    Ok(())
}

#[test]
fn any_length_will_do() -> Result<()> {
    let case = &cases()?[0];
    assert_eq!(case.kind(), Kind::Asymmetric);
    let times = times(case, 40);
    let whole = bits(&filled(case, &times)?);
    for length in 0..=times.len() {
        assert_eq!(bits(&filled(case, &times[..length])?), whole[..length].to_vec());
    }
    Ok(())
}

#[test]
fn lists_of_different_length_are_refused_untouched() -> Result<()> {
    let mut refused = 0;
    for case in cases()? {
        let before = vec![case.kinematics(0.5); 7];
        for length in [0, 6, 8] {
            let mut states = before.clone();
            let error = case.kinematics_at(&vec![1.0; length], &mut states);
            let expected = Error::Lengths { name: "samples", found: 7, expected: length };
            assert_eq!(error, Err(expected));
            assert_eq!(bits(&states), bits(&before));
            refused += 1;
        }
    }
    assert_eq!(refused, 36);
    Ok(())
}

/// As long as the phase is known there is an attitude, and none beyond.
#[test]
fn any_time_has_a_unit_quaternion_or_none() -> Result<()> {
    let (mut known, mut lost) = (0, 0);
    let mut norms = Errors::in_units_of(EPS, "square of the quaternion");
    for (i, case) in cases()?.iter().enumerate() {
        for exponent in 10..=290 {
            for t in [1.7, -1.3].map(|t| t * 10.0_f64.powi(exponent)) {
                let now = case.kinematics(t);
                if case.try_kinematics(t) != Ok(now) {
                    let [w, x, y, z] = now.attitude.quaternion();
                    let [p, q, r] = now.angular_velocity.to_array();
                    assert!([w, x, y, z, p, q, r].iter().all(|c| c.is_nan()), "{t}");
                    lost += 1;
                    continue;
                }
                known += 1;
                let Kinematics { attitude, angular_velocity: omega } = now;
                let norm: f64 = attitude.quaternion().iter().map(|q| q * q).sum();
                norms.push_at(norm - 1.0, (i, t));
                assert!(omega.is_finite(), "case {i} at {t}: {omega:?}");
            }
        }
    }
    assert_eq!(known + lost, 12 * 281 * 2);
    assert_largest!(norms, known, @"8");
    Ok(())
}

#[test]
fn a_time_that_is_no_number_is_refused() -> Result<()> {
    let mut refused = 0;
    for case in cases()? {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let told = |error: Option<Error>| {
                matches!(error, Some(Error::NotFinite { name: "t", value })
                    if value.to_bits() == bad.to_bits())
            };
            assert!(told(case.try_kinematics(bad).err()));
            let before = vec![case.kinematics(0.5); 9];
            let mut states = before.clone();
            let times = [0.0, 1.0, 2.0, 3.0, 4.0, bad, 6.0, 7.0, 8.0];
            assert!(told(case.kinematics_at(&times, &mut states).err()));
            assert_eq!(bits(&states), bits(&before));
            refused += 1;
        }
        assert_eq!(case.try_kinematics(2.5), Ok(case.kinematics(2.5)));
    }
    assert_eq!(refused, 36);
    Ok(())
}

/// Teeth: one time moved by an ulp, in one lane, must show.
#[test]
fn damaged_a_time_off_by_one_ulp_shows() -> Result<()> {
    let case = &cases()?[0];
    let times = times(case, 4003);
    let mut damaged = times.clone();
    damaged[4001] = damaged[4001].next_up();
    let (good, bad) = (bits(&filled(case, &times)?), bits(&filled(case, &damaged)?));
    let differ = good.iter().zip(&bad).filter(|(a, b)| a != b).count();
    assert_eq!(differ, 1);
    Ok(())
}
