//! Many samples at once have the bits of one at a time; a time must be a number.

use super::motions::all;
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::exact::heavy_top::HeavyTop;
use rotation_dynamics::math::EPS;
use rotation_dynamics::{Error, Result};
use support::{Errors, assert_largest};

/// Near, late, on and next to the turning points; `late` scales the late ones.
fn times(motion: &HeavyTop, count: u32, late: f64) -> Vec<f64> {
    let half = motion.nutation_period().min(1e3) / 2.0;
    (0..count)
        .map(|k| {
            let x = f64::from(k) - f64::from(count / 2);
            match k % 4 {
                0 => 0.0123 * x,
                1 => 0.5 * half * x,
                2 => late * x / 3.0,
                _ => (half + 1e-12) * x,
            }
        })
        .collect()
}

fn bits(states: &[Kinematics]) -> Vec<[u64; 7]> {
    let of = |state: &Kinematics| {
        let [w, x, y, z] = state.attitude.quaternion();
        let [p, q, r] = state.angular_velocity.to_array();
        [w, x, y, z, p, q, r].map(f64::to_bits)
    };
    states.iter().map(of).collect()
}

/// The states.
fn filled(motion: &HeavyTop, times: &[f64]) -> Result<Vec<[u64; 7]>> {
    let mut states = vec![Kinematics::REST; times.len()];
    motion.kinematics_at(times, &mut states)?;
    Ok(bits(&states))
}

fn one_by_one(motion: &HeavyTop, times: &[f64]) -> Vec<[u64; 7]> {
    let states: Vec<_> = times.iter().map(|t| motion.kinematics(*t)).collect();
    assert!(times.iter().zip(&states).all(|(t, s)| s.attitude == motion.attitude(*t)));
    bits(&states)
}

#[test]
fn every_regime_has_the_scalar_bits() -> Result<()> {
    let (mut compared, mut in_lanes) = (0, 0);
    for (i, motion) in all().iter().enumerate() {
        // The last goes to the end of what is known. 2003 is no multiple of 4 or 8.
        let refusal = motion.try_kinematics(f64::MAX).err();
        // One at rest is known for ever.
        let last = refusal.map_or(1e15, |error| crate::latest(Some(error)));
        for late in [1.0, 1e6, 2.99 / 1001.0 * last] {
            let times = times(motion, 2003, late);
            let scalar = one_by_one(motion, &times);
            assert_eq!(filled(motion, &times)?, scalar, "motion {i}, {late}");
            compared += times.len();
        }
        let m = motion.parameter();
        if m > 0.0 && m <= 0.8 {
            in_lanes += 1;
        }
    }
    assert_eq!((compared, in_lanes), (26 * 3 * 2003, 17));
    Ok(())
}

#[test]
fn any_length_will_do_and_two_lengths_will_not() -> Result<()> {
    let motion = &all()[0];
    let times = times(motion, 40, 1.0);
    let whole = filled(motion, &times)?;
    for length in 0..=times.len() {
        assert_eq!(filled(motion, &times[..length])?, whole[..length].to_vec());
    }
    let mut states = vec![motion.kinematics(0.5); 7];
    let before = bits(&states);
    let error = motion.kinematics_at(&times, &mut states);
    let expected = Error::Lengths { name: "samples", found: 7, expected: 40 };
    assert_eq!((error, bits(&states)), (Err(expected), before));
    Ok(())
}

/// As long as the phase is known there is an attitude, and none beyond.
#[test]
fn any_time_has_a_unit_quaternion_or_none() {
    let (mut known, mut lost) = (0, 0);
    let mut norms = Errors::in_units_of(EPS, "square of the quaternion");
    for (i, motion) in all().iter().enumerate() {
        for exponent in 10..=308 {
            for t in [1.7, -1.3].map(|t| t * 10.0_f64.powi(exponent)) {
                let now = motion.kinematics(t);
                if motion.try_kinematics(t) != Ok(now) {
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
                assert!(omega.is_finite(), "motion {i} at {t}: {omega:?}");
            }
        }
    }
    assert_eq!(known + lost, 26 * 299 * 2);
    assert_largest!(norms, known, @"6");
}

#[test]
fn a_time_that_is_no_number_is_refused() {
    let mut refused = 0;
    for motion in all() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let told = |error: Option<Error>| {
                matches!(error, Some(Error::NotFinite { name: "t", value })
                    if value.to_bits() == bad.to_bits())
            };
            assert!(told(motion.try_kinematics(bad).err()));
            assert!(told(motion.try_attitude(bad).err()));
            let before = vec![motion.kinematics(0.5); 9];
            let mut states = before.clone();
            let times = [0.0, 1.0, 2.0, 3.0, 4.0, bad, 6.0, 7.0, 8.0];
            assert!(told(motion.kinematics_at(&times, &mut states).err()));
            assert_eq!(bits(&states), bits(&before));
            refused += 1;
        }
        assert_eq!(motion.try_kinematics(2.5), Ok(motion.kinematics(2.5)));
        assert_eq!(motion.try_attitude(2.5), Ok(motion.attitude(2.5)));
    }
    assert_eq!(refused, 78);
}

/// Teeth: one time moved by an ulp must show.
#[test]
fn damaged_a_time_off_by_one_ulp_shows() -> Result<()> {
    let motion = &all()[0];
    let times = times(motion, 2003, 1e6);
    let mut damaged = times.clone();
    damaged[1998] = damaged[1998].next_up();
    let (good, bad) = (filled(motion, &times)?, filled(motion, &damaged)?);
    assert_eq!(good.iter().zip(&bad).filter(|(a, b)| a != b).count(), 1);
    Ok(())
}
