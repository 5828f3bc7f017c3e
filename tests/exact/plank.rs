//! The falling plank: its limits, its energy, and Simpson's rule in theta.

use core::f64::consts::FRAC_PI_2;
use models::plank::{Plank, PlankState};
use rotation_dynamics::Error;
use rotation_dynamics::math::{EPS, cos, log, sin};
use support::{Errors, assert_error, assert_largest};

const G: f64 = 9.80665;

fn plank(theta0: f64, omega0: f64) -> Plank {
    Plank::new(1.0, G, theta0, omega0).unwrap()
}

/// Released at rest and pushed, from a hair off the vertical to a hair off the floor.
fn starts() -> Vec<Plank> {
    let growth = (6.0 * G).sqrt();
    let mut all = Vec::new();
    for theta0 in [0.0, 1e-250, 1e-30, 1e-12, 1e-5, 0.01, 0.3, 1.0, 1.5, 1.5706, FRAC_PI_2 - 1e-12]
    {
        for omega0 in [0.0, 1e-200, 1e-8, (growth * theta0).min(4.1), 0.5, 4.0] {
            if theta0 > 0.0 || omega0 > 0.0 {
                all.push(plank(theta0, omega0));
            }
        }
    }
    all.push(plank(1.57, 150.0));
    all
}

#[test]
fn what_does_not_fall_is_refused() {
    let refused = [
        (0.0, G, 0.1, 0.0),
        (-1.0, G, 0.1, 0.0),
        (f64::NAN, G, 0.1, 0.0),
        (1e200, G, 0.1, 0.0),
        (1.0, 0.0, 0.1, 0.0),
        (1.0, f64::INFINITY, 0.1, 0.0),
        (1.0, G, -0.1, 0.0),
        (1.0, G, FRAC_PI_2, 0.0),
        (1.0, G, f64::NAN, 0.0),
        (1.0, G, 0.1, -1.0),
        (1.0, G, 0.1, f64::NAN),
        (1.0, G, 0.1, f64::INFINITY),
        (1.0, G, 0.0, 0.0),
        (1.0, G, 1e-300, 0.0),
    ];
    for (length, gravity, theta0, omega0) in refused {
        let error = Plank::new(length, gravity, theta0, omega0).unwrap_err();
        assert!(matches!(error, Error::NotFinite { .. } | Error::OutOfRange { .. }), "{error}");
    }
    let message = Plank::new(1.0, G, 0.0, 5.0).unwrap_err().to_string();
    assert_eq!(
        message,
        "omega0 = 5 is not allowed: at this angle at most \
         4.428690551393267 rad/s; faster, the floor would have to pull to keep the foot down"
    );
    let falling = plank(0.01, 0.0);
    for t in [-1e-9, 0.9, f64::NAN] {
        assert!(falling.at(t).is_err(), "t = {t}");
    }
}

/// Energy and the sign of the floor's force hold on the way; the ends are the given
/// start and theta = pi/2 with a quarter of the weight.
#[test]
fn energy_and_ends() {
    let mut energy = Errors::in_units_of(EPS, "energy");
    let mut ends = Errors::of("ends, in their last places");
    for plank in starts() {
        let total = |s: &PlankState| {
            // Kinetic energy less the fallen height's, over m g l; the height from
            // 2 sin^2(theta/2), which does not cancel.
            let (half, sine) = (sin(0.5 * s.theta), sin(s.theta));
            let kinetic = s.omega * s.omega / (24.0 * G) * (1.0 + 3.0 * sine * sine);
            (kinetic - half * half, kinetic + half * half)
        };
        let start = plank.start();
        let before = total(&start).0;
        let end = plank.landing_time();
        for part in [1e-9, 0.01, 0.3, 0.5, 0.9, 0.99, 1.0 - 1e-9, 1.0] {
            let state = plank.at(part * end).unwrap();
            let (now, size) = total(&state);
            energy.add(now, before, size);
            assert!(state.floor_force >= 0.0, "{state:?}");
        }
        let begin = plank.at(0.0).unwrap();
        for (a, b) in [(begin.theta, start.theta), (begin.omega, start.omega)] {
            ends.add(a, b, (EPS * b.abs()).max(5e-324));
        }
        let landing = plank.landing();
        let near = plank.at(end * (1.0 - 2.0 * EPS)).unwrap();
        ends.add(near.theta, landing.theta, EPS * (1.0 + landing.omega * end));
        assert_eq!(landing.floor_force, 0.25);
    }
    assert_largest!(energy, 8 * 65, @"5.39");
    assert_largest!(ends, 3 * 65, @"3.73");
}

/// The time between two angles by Simpson's rule in theta, straight from the energy;
/// with 2 instead of 3 in the kinetic energy (the damaged twin) it misses.
#[test]
fn the_time_agrees_with_plain_quadrature() {
    let plank = plank(0.2, 0.7);
    let (from, to) = (plank.at(0.1).unwrap(), plank.at(0.4).unwrap());
    let time = |weight: f64| {
        let e = {
            let half = sin(0.1);
            half * half - 0.49 * (1.0 + weight * sin(0.2) * sin(0.2)) / (24.0 * G)
        };
        let pace = |theta: f64| {
            let (half, sine) = (sin(0.5 * theta), sin(theta));
            ((1.0 + weight * sine * sine) / (24.0 * G * (half * half - e))).sqrt()
        };
        let n = 2000;
        let step = (to.theta - from.theta) / f64::from(n);
        (0..n)
            .map(|i| {
                let a = from.theta + step * f64::from(i);
                (pace(a) + 4.0 * pace(a + 0.5 * step) + pace(a + step)) * step / 6.0
            })
            .sum::<f64>()
    };
    // The rounding of 4000 terms; and 0.022.
    assert_error!(time(3.0) - 0.3, 8.3e-15);
    assert_error!(time(2.0) - 0.3, 0.028);
}

/// While it is upright, theta = theta0 cosh(lambda t); each factor 10 in theta0 costs
/// ln(10)/lambda.
#[test]
fn the_first_fall_is_exponential() {
    let hair = plank(1e-30, 0.0);
    let growth = hair.growth_rate();
    let t = 20.0 / growth;
    let want = 1e-30 * rotation_dynamics::math::cosh(20.0);
    let got = hair.at(t).unwrap().theta;
    // Where 20 eps are the condition.
    assert_error!(got, want, 0.0 eps);
    let longer = plank(1e-31, 0.0).landing_time() - hair.landing_time();
    // Four times what rounding the two times explains at most.
    assert_error!(longer - log(10.0) / growth, 1.0e-15);
    assert_error!(cos(hair.landing().theta), 0.55 eps);
}
