//! Exercise 16.6, the ladder.

use rotation_dynamics::Error;
use rotation_dynamics::exact::ladder::{Ladder, Phase};
use rotation_dynamics::math::EPS;

const G: f64 = 9.80665;

#[test]
fn what_is_no_ladder_is_refused() {
    let flat = core::f64::consts::FRAC_PI_2;
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
        assert!(
            matches!(error, Error::NotFinite { .. } | Error::OutOfRange { .. }),
            "{error}"
        );
    }
    let message = Ladder::new(3.0, G, 1.6).unwrap_err().to_string();
    assert!(
        message.starts_with("theta0 = 1.6 is not allowed"),
        "{message}"
    );
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
    let angles = [
        1e-12,
        1e-3,
        0.25,
        1.0,
        1.55,
        core::f64::consts::FRAC_PI_2 - 1e-9,
    ];
    let (mut ran, mut worst) = (0, 0.0_f64);
    for theta0 in angles {
        let ladder = Ladder::new(3.0, G, theta0).unwrap();
        let (release, t) = (ladder.release(), ladder.release_time());
        for (t, phase) in [
            (t * (1.0 - 4.0 * EPS), Phase::OnWall),
            (t * (1.0 + 4.0 * EPS), Phase::OffWall),
        ] {
            let state = ladder.at(t).unwrap();
            assert_eq!(state.phase, phase);
            let unit = EPS * (1.0 + release.omega * t);
            worst = worst
                .max((state.theta - release.theta).abs() / unit)
                .max((state.omega - release.omega).abs() / (release.omega * unit))
                .max((state.vx_cm - release.vx_cm).abs() / (release.vx_cm * unit))
                .max((state.floor_force - release.floor_force).abs() / unit);
        }
        ran += 1;
    }
    assert_eq!(ran, angles.len());
    // Measured: 3.55 (the four units themselves).
    assert!(worst <= 3.6, "{worst}");
}
