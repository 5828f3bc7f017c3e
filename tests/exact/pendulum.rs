//! The physical pendulum: every regime against invariants, limits and stepping.

use core::f64::consts::PI;
use rotation_dynamics::Error;
use rotation_dynamics::exact::pendulum::{Pendulum, PendulumKind, PendulumState, Suspension};
use rotation_dynamics::exact::{Modulus, legendre};
use rotation_dynamics::math::{DoubleDouble, EPS, pow, sin};
use support::{Errors, assert_error, assert_largest};

/// W = 1.
const UNIT: Suspension = Suspension { moment: 1.0, mass: 1.0, gravity: 1.0, lever: 1.0 };

fn unit(theta0: f64, omega0: f64) -> Pendulum {
    Pendulum::new(UNIT, theta0, omega0).unwrap()
}

#[test]
fn what_is_no_pendulum_is_refused() {
    let mut ran = 0;
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e-70, 1e70] {
        for which in 0..4 {
            let mut numbers = [1.0; 4];
            numbers[which] = bad;
            let [moment, mass, gravity, lever] = numbers;
            let suspension = Suspension { moment, mass, gravity, lever };
            let error = Pendulum::new(suspension, 1.0, 0.0).unwrap_err();
            assert!(matches!(error, Error::NotFinite { .. } | Error::OutOfRange { .. }), "{error}");
            ran += 1;
        }
    }
    for (theta0, omega0) in [(f64::NAN, 0.0), (1e16, 0.0), (0.0, f64::INFINITY), (0.0, 1e61)] {
        assert!(Pendulum::new(UNIT, theta0, omega0).is_err());
        ran += 1;
    }
    for t in [f64::NAN, f64::INFINITY, 5e15] {
        assert!(unit(1.0, 0.0).at(t).is_err());
        ran += 1;
    }
    assert_eq!(ran, 31);
    let message = Pendulum::new(UNIT, 1e16, 0.0).unwrap_err().to_string();
    assert_eq!(message, "theta0 = 1e16 is not allowed: its size must not exceed 1e15 rad");
}

/// Starts in every regime.
fn starts() -> Vec<(f64, f64)> {
    let mut starts =
        vec![(0.0, 0.0), (0.0, 2.0), (0.0, -2.0), (PI, 0.0), (-PI, 1e-9), (PI, -1e-17)];
    for theta0 in [1e-300, 1e-19, 1e-8, 0.3, 1.0, PI / 2.0, 2.0, 3.1, 3.2, 100.0, -1e6] {
        for omega0 in [0.0, 1e-250, -1e-12, 0.5, -1.3, 2.0, 2.5, -40.0, 1e8] {
            starts.push((theta0, omega0));
        }
    }
    for below in [1e-3, 1e-9, 1e-16] {
        starts.push((PI - below, 0.0));
        starts.push((0.0, 2.0 * (1.0 - below)));
        starts.push((0.0, -2.0 * (1.0 + below)));
    }
    starts
}

/// At t = 0 stands the start; the energy stays, for a million periods.
#[test]
fn start_and_energy_are_kept() {
    let mut at_start = Errors::of("start, in eps of itself");
    let mut energy = Errors::of("energy, in its last places");
    for (theta0, omega0) in starts() {
        let pendulum = unit(theta0, omega0);
        let PendulumState { theta, omega } = pendulum.at(0.0).unwrap();
        at_start.add(theta, theta0, (EPS * theta0.abs()).max(5e-324));
        at_start.add(omega, omega0, (EPS * omega0.abs()).max(5e-324));
        let k2 = pendulum.energy_ratio();
        let period = pendulum.period().min(100.0);
        for n in [1e-6, 0.11, 0.25, 0.4999, 3.77, 1234.5, 1e6] {
            let state = pendulum.at(n * period).unwrap();
            let (half, rate) = (sin(0.5 * state.theta), 0.5 * state.omega);
            // The last place of a large theta counts in full.
            let unit = EPS * (k2 + 0.5 * sin(state.theta).abs() * state.theta.abs());
            energy.add(half * half + rate * rate, k2, unit.max(5e-324));
        }
    }
    assert_largest!(at_start, 2 * 114, @"3.2");
    assert_largest!(energy, 7 * 114, @"4.24");
}

/// T = 4 K/W by another route, and what the plain 1 - sin^2(theta0/2) does to it.
#[test]
fn the_period_near_pi_needs_the_complement() {
    let mut errors = Errors::in_units_of(EPS, "period");
    let mut plain = Errors::in_units_of(EPS, "period by 1 - sin^2");
    for digits in 1..=15 {
        let theta0 = PI - pow(10.0, -f64::from(digits));
        let period = unit(theta0, 0.0).period();
        let (s, c) = DoubleDouble::from(0.5 * theta0).sin_cos();
        let modulus = Modulus::from_m1(c.square().to_f64()).unwrap();
        let other = 4.0 * legendre::k(modulus).unwrap();
        errors.add(period, other, other);
        let m = s.to_f64() * s.to_f64();
        let damaged = 4.0 * Modulus::from_m(m).and_then(legendre::k).unwrap_or(f64::INFINITY);
        plain.add(damaged, other, other);
    }
    assert_largest!(errors, 15, @"0");
    // Infinity from 1e-9 on.
    assert_eq!(plain.largest(), f64::INFINITY);
}

/// Swings too small for the eye and not for doubles: T = 2 pi/W (1 + k^2/4 + 9 k^4/64 +
/// ...), which the plain 2 pi/W (the damaged twin) misses down to k^2 = 1e-14; and a
/// quarter of it later the pendulum hangs straight down.
#[test]
fn small_swings_are_not_harmonic() {
    let mut periods = Errors::in_units_of(EPS, "period");
    let mut harmonic = Errors::in_units_of(EPS, "2 pi/W");
    let mut quarters = Errors::in_units_of(EPS, "angle after a quarter");
    for digits in 5..=14 {
        let theta0 = 2.0 * pow(10.0, -0.5 * f64::from(digits));
        let swing = unit(theta0, 0.0);
        let k2 = DoubleDouble::from(0.5 * theta0).sin_cos().0.square();
        let series = k2 * (9.0 / 64.0) + k2.square() * (25.0 / 256.0) + 0.25;
        let want = (DoubleDouble::TWO_PI * (k2 * series + 1.0)).to_f64();
        periods.add(swing.period(), want, want);
        harmonic.add(2.0 * PI, want, want);
        let hanging = swing.at(0.25 * want).unwrap().theta;
        quarters.add(hanging, 0.0, theta0);
    }
    assert_largest!(periods, 10, @"0");
    harmonic.exceed(20.0, 10);
    // The rounding of a quarter of the period, at most 1.
    assert_largest!(quarters, 10, @"0.844");
}

/// A library that is trusted gives 4.9e-48 here; the pendulum is back at the top.
#[test]
fn a_period_next_to_the_top() {
    let pendulum = unit(3.1415926535897922, 0.0);
    let state = pendulum.at(145.5390468968808).unwrap();
    assert_error!(state.theta - 3.141_592_653_589_792, 0.0);
}

#[test]
fn the_separatrix_is_met_exactly_or_not_at_all() {
    // omega0^2 I = 4 m g d in factors that no single rounding would keep.
    let cube = Suspension { moment: 0.6, mass: 0.6, gravity: 0.37, lever: 0.37 };
    let kind = |omega0: f64| Pendulum::new(cube, 0.0, omega0).unwrap().kind();
    assert_eq!(kind(0.74), PendulumKind::Separatrix);
    assert_eq!(kind(-0.74), PendulumKind::Separatrix);
    assert_eq!(kind(0.74 * (1.0 - EPS)), PendulumKind::Oscillation);
    assert_eq!(kind(0.74 * (1.0 + 2.0 * EPS)), PendulumKind::Rotation);

    let up = unit(0.0, 2.0);
    assert_eq!(up.period(), f64::INFINITY);
    let late = up.at(1e6).unwrap();
    assert_eq!((late.theta, late.omega), (PI, 0.0));
}

#[test]
fn rest_is_rest_and_upright_is_not() {
    let hanging = unit(0.0, 0.0);
    assert_eq!(hanging.kind(), PendulumKind::Rest);
    let state = hanging.at(1e9).unwrap();
    assert_eq!((state.theta, state.omega), (0.0, 0.0));
    // pi as a double is 1.2e-16 short of upright: half a period later it is on the
    // other side.
    let upright = unit(PI, 0.0);
    assert_eq!(upright.kind(), PendulumKind::Oscillation);
    let other_side = upright.at(0.5 * upright.period()).unwrap();
    assert_error!(other_side.theta + PI, 0.0);
}

/// A swing of 1e-300 keeps all its digits, and one of 2e-18 does not see the change of
/// form.
#[test]
fn small_swings_scale() {
    let reference = unit(1e-12, 0.7e-12);
    let mut errors = Errors::in_units_of(EPS, "small swings");
    for size in [1e-306, 1e-300, 1e-160, 1e-140, 1e-19, 1e-18, 1e-17, 1e-15] {
        let pendulum = unit(size, 0.7 * size);
        for t in [1e-9, 0.3, 2.0, 31.0] {
            let (got, want) = (pendulum.at(t).unwrap(), reference.at(t).unwrap());
            let scale = size / 1e-12;
            errors.add(got.theta, want.theta * scale, size * (1.0 + t));
            errors.add(got.omega, want.omega * scale, size * (1.0 + t));
        }
    }
    assert_largest!(errors, 2 * 32, @"1.78");
}

/// Whole turns are counted.
#[test]
fn turns_are_kept() {
    let wheel = unit(0.0, 2.5);
    let turn = wheel.at(1000.0 * wheel.period()).unwrap().theta;
    // One unit in the last place; the period's own rounding is 2.2e-12.
    assert_error!(turn - 2000.0 * PI, 1e-12);
    let wound = unit(20.0 * PI + 0.3, 0.0).at(5.0).unwrap().theta;
    let plain = unit(0.3, 0.0).at(5.0).unwrap().theta;
    assert_error!(wound - plain - 20.0 * PI, 0.0);
}
