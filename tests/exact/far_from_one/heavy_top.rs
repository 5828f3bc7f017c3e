//! Tops released upside down, angles of many turns, times of many periods.

use core::f64::consts::PI;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::Kinematics;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Regime, Start, SymmetricTop};
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::EPS;
use support::{Errors, assert_largest};

/// The pendulum that a top without spin is, from hanging.
fn as_pendulum(top: SymmetricTop) -> Pendulum {
    let suspension =
        Suspension { moment: top.i1(), mass: top.weight(), gravity: 1.0, lever: top.lever().abs() };
    Pendulum::new(suspension, PI, 0.0).expect("a pendulum")
}

/// Gravity that pulls towards theta = 0, and a release at rest at theta = pi: 1.2e-16 short of
/// upright. It falls, as the pendulum does.
#[test]
fn a_top_released_upside_down_is_a_pendulum() {
    let mut periods = Errors::in_units_of(EPS, "period");
    let mut tilts = Errors::in_units_of(EPS, "theta");
    let mut damaged = Errors::in_units_of(EPS, "theta of a pendulum 1e-12 of a period late");
    let mut states = 0;
    for i1 in [0.1, 0.3, 1.0, 2.7] {
        for ratio in [0.1, 0.5, 1.0, 5.0 / 3.0, 1.9] {
            for weight in [0.1, 0.981, 3.3, 9.81, 46.246_407_949_939_46, 500.0] {
                for lever in [-1e-3, -0.01, -0.043_441_341_550_221_39, -0.1, -0.33, -1.0, -3.0] {
                    let top = SymmetricTop::new(i1, i1 * ratio, weight, lever).expect("a top");
                    let pendulum = as_pendulum(top);
                    let period = pendulum.period();
                    for [phi, zeta] in [
                        [0.0, 0.0],
                        [0.597, -7.354],
                        [2.0, 1.0],
                        [-3.0, 0.1],
                        [100.0, -55.0],
                        [0.3, 0.3],
                    ] {
                        let start = EulerAngles { phi, theta: PI, zeta };
                        let motion =
                            HeavyTop::from_body(top, start, BodyVector::zero()).expect("a motion");
                        assert_eq!(motion.regime(), Regime::Planar);
                        periods.add(motion.nutation_period(), 0.5 * period, period);
                        for t in [0.0, 0.2, 0.25, 0.3, 0.5] {
                            let t = t * period;
                            let want = pendulum.at(t).expect("a time");
                            // How far the last bit of the time moves it.
                            let size = PI + want.omega.abs() * t;
                            tilts.add(motion.angles(t).theta, want.theta.abs(), size);
                        }
                        let late = pendulum.at(0.25 * period * (1.0 + 1e-12)).expect("a time");
                        let theta = motion.angles(0.25 * period).theta;
                        damaged.add(theta, late.theta.abs(), PI + late.omega.abs() * 0.25 * period);
                        assert!(motion.try_kinematics(1e300).is_err());
                        for t in [1000.0, 1e6, -1e4] {
                            let Kinematics { attitude, angular_velocity: rates } =
                                motion.kinematics(t);
                            assert!(rates.is_finite(), "{top:?} {t}");
                            assert!(attitude.quaternion().iter().all(|c| c.is_finite()));
                            states += 1;
                        }
                    }
                }
            }
        }
    }
    let tops = 4 * 5 * 6 * 7 * 6;
    assert_eq!((tops, states), (5040, 3 * 5040));
    assert_largest!(periods, tops, @"0");
    assert_largest!(tilts, 5 * tops, @"1.25");
    damaged.exceed(1e3, tops);
}

/// An angle whose last bit is more than 1/8 rad says nothing.
#[test]
fn angles_of_too_many_turns_are_refused() {
    let reduced = ReducedTop::new(2.0, 1.2, 0.2).expect("a top");
    let body = SymmetricTop::new(1.0, 0.4, 2.0, 1.0).expect("a top");
    let mut ran = 0;
    for angle in [1.01e15, -1e32, 1e179] {
        for [phi, zeta] in [[angle, 0.1], [0.1, angle]] {
            let start = EulerAngles { phi, theta: 1.0, zeta };
            for motion in [
                HeavyTop::from_energy(reduced, 0.55, Start::ThetaMin, phi, zeta),
                HeavyTop::from_angles(reduced, 0.7, 0.1, phi, zeta),
                HeavyTop::from_body(body, start, BodyVector::new(0.1, 0.2, 3.0)),
            ] {
                let message = motion.expect_err("too many turns").to_string();
                assert!(message.contains("must not exceed 1e15 rad"), "{message}");
                ran += 1;
            }
        }
    }
    assert_eq!(ran, 18);
    // Up to there the attitude is that of the angles.
    let mut errors = Errors::in_units_of(EPS, "attitude at the start");
    let mut damaged = Errors::in_units_of(EPS, "attitude an eighth of a radian on");
    for phi in [1e3, 1e10, 1e14, 9.9e14, -9.9e14] {
        let angles = EulerAngles { phi, theta: 1.0, zeta: 0.3 };
        let motion = HeavyTop::from_body(body, angles, BodyVector::new(0.1, 0.2, 3.0));
        let start = motion.expect("a motion").attitude(0.0);
        errors.push(start.angle_to(&Attitude::from_euler(angles).expect("finite")));
        let next = EulerAngles { phi: phi + 0.125, ..angles };
        damaged.push(start.angle_to(&Attitude::from_euler(next).expect("finite")));
    }
    assert_largest!(errors, 5, @"2.15");
    damaged.exceed(1e14, 5);
}

/// phi and zeta after so many half-periods that the last is nothing beside them: their mean rates.
/// Later than their last bit is known nothing is.
#[test]
fn late_angles_grow_with_their_mean_rates() {
    let motion = ReducedTop::new(2.0, 1.2, 0.2)
        .and_then(|top| HeavyTop::from_energy(top, 0.55, Start::ThetaMin, 0.3, -0.4))
        .expect("a motion");
    let period = motion.nutation_period();
    let mut errors = Errors::in_units_of(1.0, "phi and zeta less theirs, rad");
    let mut damaged = Errors::in_units_of(1.0, "the same, the rate off by 1e-12");
    let last = crate::latest(motion.try_angles(1e300).err());
    for t in [1e14, 2e14, -5e14, last, -last] {
        let angles = motion.try_angles(t).expect("finite");
        for (angle, advance) in
            [(angles.phi, motion.precession_per_period()), (angles.zeta, motion.spin_per_period())]
        {
            let mean = t * (advance / period);
            errors.add(angle, mean, 1.0);
            damaged.add(angle * (1.0 + 1e-12), mean, 1.0);
        }
    }
    assert_largest!(errors, 10, @"0.562");
    damaged.exceed(10.0, 10);
    for t in [1.001 * last, 9e15, 1e17, 1e25, 1e149, 1e151, 1e300, -1e300] {
        assert!(motion.angles(t).phi.is_nan());
        assert_eq!(crate::latest(motion.try_angles(t).err()), last);
    }
    let start = EulerAngles { phi: 0.0, theta: 0.8, zeta: 0.0 };
    let fast = SymmetricTop::new(1.0, 0.4, 2.0, 1.0)
        .and_then(|body| HeavyTop::from_body(body, start, BodyVector::new(0.0, 0.0, 9.0)))
        .expect("a motion");
    assert!(crate::latest(fast.try_angles(1.7e308).err()) < last);
    assert!(motion.try_angles(f64::NAN).is_err());
}

/// How many states of motions in other units of time do not have the bits that they have in
/// seconds; gravity is larger by the part `damage` there.
fn moved_by_the_unit(damage: f64) -> [usize; 2] {
    let starts = [
        (0.9, 1.1, [0.5, -0.8, 3.1]),
        (-0.9, 0.02, [2.0, 1.0, 0.1]),
        (0.9, 2.9, [1e-3, -2.0, -7.0]),
        (-0.9, PI, [0.3, 0.1, 11.0]),
        (0.9, 0.0, [1e-4, 0.0, 1.0]),
    ];
    let motion = |(lever, theta, rates): (f64, f64, [f64; 3]), unit: f64, weight: f64| {
        let top = SymmetricTop::new(1.3, 0.7, weight * unit, lever * unit).expect("a top");
        let (phi, zeta) = (0.3, -0.4);
        let start = EulerAngles { phi, theta, zeta };
        let rates = BodyVector::from_array(rates.map(|rate| rate * unit));
        HeavyTop::from_body(top, start, rates).expect("a motion")
    };
    let (mut moved, mut states) = (0, 0);
    for start in starts {
        let own = motion(start, 1.0, 2.0);
        for power in [-400, -200, -100, 100, 170, 200, 480] {
            let unit = 2.0_f64.powi(power);
            let other = motion(start, unit, 2.0 * (1.0 + damage));
            for t in [0.0, 1.3, 77.7, -1e6] {
                let (want, got) = (own.kinematics(t), other.kinematics(t / unit));
                let rates = want.angular_velocity.to_array().map(|rate| rate * unit);
                let same = got.attitude.quaternion() == want.attitude.quaternion()
                    && got.angular_velocity.to_array() == rates;
                moved += usize::from(!same);
                states += 1;
            }
        }
    }
    [moved, states]
}

/// Rates down to 4e-125 and up to 3e145 rad/s: their sixth powers are far beyond doubles.
#[test]
fn no_bit_depends_on_the_unit_of_time() {
    assert_eq!(moved_by_the_unit(0.0), [0, 140]);
    let [moved, _] = moved_by_the_unit(1e-14);
    assert!(moved > 90, "{moved}");
}

/// How far a fast top, one near its separatrix and a sleeping one are after 60 units of time from
/// where they are after 60 s, for units up to 2e152 s; what is asked is later by the part `damage`.
fn moved_by_late_units(damage: f64) -> Errors {
    let starts = [(1.0, [0.0, 0.0, 314.0]), (0.02, [30.0, 0.1, 0.0]), (0.0, [0.0, 0.0, 31.0])];
    let motion = |(theta, rates): (f64, [f64; 3]), unit: f64| {
        let top = SymmetricTop::new(5.45e-3, 9e-4, 4.9 / unit, 0.1 / unit).expect("a top");
        let (phi, zeta) = (0.3, -0.4);
        let start = EulerAngles { phi, theta, zeta };
        let rates = BodyVector::from_array(rates.map(|rate| rate / unit));
        HeavyTop::from_body(top, start, rates).expect("a motion")
    };
    let mut errors = Errors::in_units_of(EPS, "angles, rates and attitude");
    for start in starts {
        let own = motion(start, 1.0);
        for power in [400, 480, 489, 491, 494, 498, 502, 506] {
            let unit = 2.0_f64.powi(power);
            let other = motion(start, unit);
            let t = 60.0 * unit * (1.0 + damage);
            let (want, got) = (own.angles(60.0), other.try_angles(t).expect("angles"));
            for (got, want) in [
                (got.theta, want.theta),
                (got.phi, want.phi),
                (got.zeta, want.zeta),
                (other.cos_theta(t), own.cos_theta(60.0)),
            ] {
                errors.add(got, want, 1.0 + want.abs());
            }
            let now = other.try_kinematics(t).expect("a time");
            let attitude = other.try_attitude(t).expect("a time");
            errors.push(own.attitude(60.0).angle_to(&attitude));
            assert_eq!(now.attitude, attitude);
            let mut batch = [Kinematics::REST];
            other.kinematics_at(&[t], &mut batch).expect("a time");
            assert_eq!(batch, [now]);
            let (want, rates) = (own.kinematics(60.0).angular_velocity, now.angular_velocity);
            let [rate, phi_rate] = [want.norm(), own.phi_rate(60.0)];
            let off = (rates * unit - want).norm();
            errors.add(off, 0.0, rate);
            errors.add(other.theta_rate(t) * unit, own.theta_rate(60.0), rate);
            errors.add(other.phi_rate(t) * unit, phi_rate, rate + phi_rate.abs());
            errors.add(other.zeta_rate(t) * unit, own.zeta_rate(60.0), rate + phi_rate.abs());
        }
    }
    errors
}

/// A top that turns slowly is known at times beyond 1e150 s as one that turns fast is at early
/// ones: radians count, not seconds.
#[test]
fn slow_tops_are_known_at_times_beyond_1e150() {
    assert_largest!(moved_by_late_units(0.0), 216, @"0");
    // 1.7e11.
    let damaged = moved_by_late_units(1e-9).largest();
    assert!(damaged > 1e9, "{damaged:e}");
    // A sleeping one that turns so slowly that no pair holds its time.
    let motion = |unit: f64| {
        let top = SymmetricTop::new(5.45e-3, 9e-4, 0.0, 0.1).expect("a top");
        let rates = BodyVector::new(0.0, 0.0, 31.0 / unit);
        HeavyTop::new(top, Attitude::IDENTITY, rates).expect("a motion")
    };
    let unit = 2.0_f64.powi(1000);
    let want = motion(1.0).attitude(60.0);
    assert_eq!(motion(unit).attitude(60.0 * unit), want);
    let later = motion(unit).attitude(60.0 * unit * (1.0 + 1e-9));
    assert!(later.angle_to(&want) > 1e-7);
}
