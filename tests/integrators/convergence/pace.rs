//! A top in the notes' angles, past the pole, by steps in a time of its own.

use core::f64::consts::PI;
use rotation_dynamics::Error;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop};
use rotation_dynamics::integrators::{Dop853, Integrator, Ode, Work, ode, size_or};
use rotation_dynamics::math::{exp, sin, sincos};
use support::{EPS, assert_error, attained};

const A: f64 = 2.0;
const C: f64 = 0.2;
/// It starts from rest in theta, 1e-4 rad from the pole.
const NEAREST: f64 = 1e-4;
const B: f64 = 1.000_074_156_984_747_3;
const PERIOD: f64 = 3.756_716_247_224_329_4;
/// Twenty nutations and a third.
const END: f64 = PERIOD * 61.0 / 3.0;

/// theta, theta', phi, zeta and the time, of rate `clock`.
fn angles(clock: f64) -> impl Ode<5> {
    ode(move |_, &[theta, rate, ..]: &[f64; 5]| {
        let (s, c) = sincos(theta);
        let part = (B - c) / (s * s);
        let precession = A.sqrt() * part;
        [
            rate,
            C * s - A * part * ((1.0 - B * c) / s),
            precession,
            1.0 / A.sqrt() - precession * c,
            clock,
        ]
    })
    .scaled(|_| [1.0; 5])
}

const START: [f64; 5] = [NEAREST, 0.0, 0.0, 0.0, 0.0];

fn pace(y: &[f64; 5]) -> f64 {
    sin(y[0]).abs()
}

/// The angle (rad) from the closed form at `t`.
fn error(&[theta, _, phi, zeta, _]: &[f64; 5], t: f64) -> f64 {
    let top = ReducedTop::new(A, B, C).expect("a top");
    let exact = HeavyTop::from_angles(top, NEAREST, 0.0, 0.0, 0.0).expect("a motion");
    let angles = EulerAngles { phi, theta, zeta };
    let attitude = Attitude::from_euler(angles).expect("angles");
    attitude.angle_to(&exact.attitude(t))
}

fn paced(tolerance: f64, clock: f64, t_end: f64) -> ([f64; 5], Work) {
    let method = Dop853::new(tolerance).expect("valid");
    let run = method.advance_at_pace(&angles(clock), &START, t_end, pace);
    run.expect("regular in this time")
}

#[test]
fn a_top_past_the_pole() {
    for (tolerance, paced_error, paced_work, error_in_t, work_in_t) in [
        (1e-8, "3.2e-6", 12461, "9.3e-7", 24199),
        (1e-10, "3.7e-8", 19873, "1.4e-8", 38892),
        (1e-12, "7.3e-10", 32331, "1.2e-10", 59554),
        (1e-14, "2.8e-10", 57482, "2.7e-11", 90290),
    ] {
        let (end, work) = paced(tolerance, 1.0, END);
        attained(error(&end, END), paced_error, "at its pace");
        assert_eq!(work.derivatives, paced_work);
        // The run ends where it was told to.
        assert!((end[4] - END).abs() <= 2.0 * EPS * END);
        let method = Dop853::new(tolerance).expect("valid");
        let (end, work) = method.advance(&angles(1.0), 0.0, &START, END).expect("long");
        attained(error(&end, END), error_in_t, "by steps in t");
        assert_eq!(work.derivatives, work_in_t);
    }
    // A clock that gains 1e-9 is seen.
    let (end, _) = paced(1e-14, 1.0 + 1e-9, END);
    assert_error!(error(&end, END), 1.0e-7);
}

#[test]
fn there_and_back() {
    let (there, _) = paced(1e-13, 1.0, 0.7 * PERIOD);
    let method = Dop853::new(1e-13).expect("valid");
    let back = method.advance_at_pace(&angles(1.0), &there, 0.0, pace);
    assert_error!(error(&back.expect("regular").0, 0.0), 6.7e-15);
    let none = method.advance_at_pace(&angles(1.0), &START, 0.0, pace);
    assert_eq!(none, Ok((START, Work::default())));
}

#[test]
fn refusals() {
    let method = Dop853::new(1e-9).expect("valid");
    // Upwards at the speed 1, and the time.
    let line = ode(|_, _: &[f64; 2]| [1.0, 1.0]).scaled(size_or([1.0; 2]));
    let at_pace = |t_end: f64, pace: fn(&[f64; 2]) -> f64| {
        method.advance_at_pace(&line, &[0.0; 2], t_end, pace)
    };
    let refused = |t_end, pace| at_pace(t_end, pace).expect_err("refused");
    assert!(at_pace(PI, |_| 1.0).is_ok());
    let endless = refused(f64::INFINITY, |_| 1.0);
    assert!(matches!(endless, Error::NotFinite { name: "end time", .. }));
    assert!(matches!(refused(PI, |_| 0.0), Error::OutOfRange { name: "pace", .. }));
    assert!(matches!(refused(PI, |_| f64::NAN), Error::NotFinite { name: "pace", .. }));
    // One that runs back above x = 1, and one under which time comes to a stand.
    let back = refused(PI, |[x, _]| if *x < 1.0 { 1.0 } else { -1.0 });
    assert!(matches!(back, Error::FunctionOutOfRange { what, .. } if what == "derivative"));
    let stand = refused(PI, |[x, _]| exp(-40.0 * x));
    assert!(matches!(stand, Error::NotReached { name: "end time", until } if until < 1.0));
}
