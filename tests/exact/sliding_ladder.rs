//! The ladder that slides down a wall and leaves it: what is refused, both phases where they meet,
//! Newton's laws, and what the wall and the floor do.

use core::f64::consts::FRAC_PI_2;
use models::ladder::{Ladder, Phase};
use rotation_dynamics::Error;
use rotation_dynamics::math::{EPS, cos, sin};
use support::{Errors, assert_largest};

const G: f64 = 9.80665;
/// Times at which the closed form is differentiated.
const NEWTON: usize = 156;

#[test]
fn what_is_no_ladder_is_refused() {
    let flat = FRAC_PI_2;
    let refused = [
        (3.0, G, 0.0),
        (3.0, G, -0.25),
        (3.0, G, flat),
        (3.0, G, 15.0),
        (3.0, G, f64::NAN),
        (3.0, G, f64::INFINITY),
        (3.0, G, 1e-200),
        (0.0, G, 0.25),
        (-3.0, G, 0.25),
        (f64::INFINITY, G, 0.25),
        (3.0, 0.0, 0.25),
        (3.0, f64::NAN, 0.25),
    ];
    for (length, gravity, theta0) in refused {
        let error = Ladder::new(length, gravity, theta0).unwrap_err();
        assert!(matches!(error, Error::NotFinite { .. } | Error::OutOfRange { .. }), "{error}");
    }
    let message = Ladder::new(3.0, G, 1.6).unwrap_err().to_string();
    assert!(message.starts_with("theta0 = 1.6 is not allowed"), "{message}");
    assert!(message.contains("pi/2 = 1.5708 (flat)"), "{message}");
}

#[test]
fn a_time_outside_the_motion_is_refused() {
    let ladder = Ladder::new(3.0, G, 0.25).unwrap();
    for t in [-1e-9, 1.2, f64::NAN, f64::INFINITY] {
        assert!(ladder.at(t).is_err(), "t = {t}");
    }
    let message = ladder.at(2.0).unwrap_err().to_string();
    assert!(message.contains("from 0 to 1.178352234699266"), "{message}");
    assert_eq!(ladder.at(ladder.landing_time()), Ok(ladder.landing()));
}

/// Both phases meet at the release, from either side, for every angle: four units of
/// round-off in `t` move no field by more than its rate allows.
#[test]
fn the_phases_join() {
    let flat = FRAC_PI_2 - 1e-9;
    let mut errors = Errors::of("fields at the release, in eps (1 + omega t)");
    for theta0 in [1e-12, 1e-3, 0.25, 1.0, 1.55, flat] {
        let ladder = Ladder::new(3.0, G, theta0).unwrap();
        let (release, t) = (ladder.release(), ladder.release_time());
        for (t, phase) in
            [(t * (1.0 - 4.0 * EPS), Phase::OnWall), (t * (1.0 + 4.0 * EPS), Phase::OffWall)]
        {
            let state = ladder.at(t).unwrap();
            assert_eq!(state.phase, phase);
            let unit = EPS * (1.0 + release.omega * t);
            errors.add(state.theta, release.theta, unit);
            errors.add(state.omega, release.omega, release.omega * unit);
            errors.add(state.vx_cm, release.vx_cm, release.vx_cm * unit);
            errors.add(state.floor_force, release.floor_force, unit);
        }
    }
    // The four units and the rounding of t.
    assert_largest!(errors, 6 * 2 * 4, @"4.56");
}

/// Newton's laws along the closed form: second differences of the motion against the
/// forces that the closed form states.
#[test]
fn the_closed_form_obeys_newton() {
    let mut errors = Errors::of("Newton's laws over the weight");
    let mut damaged = Errors::of("a damaged twin");
    for theta0 in [0.1, 0.25, 0.7, 1.2] {
        let ladder = Ladder::new(3.0, G, theta0).unwrap();
        let (release, end) = (ladder.release_time(), ladder.landing_time());
        let h = 1e-3 * (end - release);
        for i in 1..40 {
            let t = end * f64::from(i) / 40.0;
            if (t - release).abs() < 3.0 * h || t < 3.0 * h || t > end - 3.0 * h {
                continue;
            }
            // Fourth-order central differences.
            let second = |f: &dyn Fn(f64) -> f64| {
                let sides = 16.0 * (f(t + h) + f(t - h)) - (f(t + 2.0 * h) + f(t - 2.0 * h));
                (sides - 30.0 * f(t)) / (12.0 * h * h)
            };
            let at = |t: f64| ladder.at(t).unwrap();
            let s = at(t);
            let across = second(&|t| at(t).x_cm) / G - s.wall_force;
            let up = second(&|t| at(t).y_cm) / G + 1.0 - s.floor_force;
            // (l/6g) theta'' = N_floor sin - N_wall cos
            let turning = 3.0 / (6.0 * G) * second(&|t| at(t).theta);
            let moment = s.floor_force * sin(s.theta) - s.wall_force * cos(s.theta);
            let turn = turning - moment;
            damaged.push(turning * (1.0 + 1e-7) - moment);
            for error in [across, up, turn] {
                errors.push(error);
            }
        }
    }
    // The error of the differences (h^4, and round-off over h^2).
    assert_largest!(errors, 3 * NEWTON, @"4.70e-9");
    // The damaged twin: a moment of inertia off by 1e-7.
    let damaged = damaged.largest();
    assert!(damaged > 2e-8, "{damaged:e}");
}

/// After the release: the top moves away and never comes back, the floor carries
/// between nothing and a quarter of the weight, and a quarter at both ends.
#[test]
fn the_top_never_comes_back_and_the_floor_always_carries() {
    let (mut least, mut ran) = (f64::INFINITY, 0);
    for i in 1..150 {
        let ladder = Ladder::new(1.0, G, 0.0104 * f64::from(i)).unwrap();
        let (from, to) = (ladder.release_time(), ladder.landing_time());
        let mut last = 0.0;
        for j in 1..=50 {
            let s = ladder.at(from + (to - from) * f64::from(j) / 50.0).unwrap();
            assert!(s.x_top > last, "{s:?}");
            assert!(s.floor_force <= 0.25 + EPS);
            last = s.x_top;
            least = least.min(s.floor_force);
            ran += 1;
        }
        assert_eq!(ladder.release().floor_force, 0.25);
        assert!((ladder.landing().floor_force - 0.25).abs() <= EPS);
    }
    assert_eq!(ran, 149 * 50);
    // Measured: 0.18918, from the most upright start.
    assert!((0.1891..0.1892).contains(&least), "{least}");
}
