//! The dial of scenes in phases: what it compares, and how often it tries.

use super::Dome;
use rotation_dynamics::Result;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::exp;
use rotation_dynamics::planar::{Condition, Next, Phased, simulate, simulate_within};

/// It goes on until two runs agree within half the tolerance, and no sooner.
#[test]
fn two_runs_agree_within_half_the_tolerance() {
    let (mut ran, mut tried_again) = (0, 0);
    for angle in [1e-3, 1e-2, 0.1, 0.3] {
        for tolerance in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9] {
            let done = simulate_within(&Dome, tolerance, (), [angle, 0.0], 100.0).unwrap();
            assert!(
                done.estimate <= 0.5 * tolerance,
                "{angle:e}, {tolerance:e}: {:e}",
                done.estimate
            );
            tried_again += u32::from(done.step_error < 0.9 * tolerance / 32.0);
            ran += 1;
        }
    }
    assert_eq!(ran, 32);
    assert!(tried_again >= 3, "{tried_again}");
}

/// A clock, and a coordinate that grows as e^(8 t), forgotten at t = 1; the phase after
/// depends on how large it was.
struct Forgetful {
    threshold: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Growth {
    Grows,
    WasSmall,
    WasLarge,
}

impl Phased<2> for Forgetful {
    type Phase = Growth;
    fn derivative(&self, phase: Growth, [_, x]: &[f64; 2]) -> [f64; 2] {
        [1.0, if phase == Growth::Grows { 8.0 * x } else { 0.0 }]
    }
    fn conditions(&self, phase: Growth) -> Vec<Condition<'_, Growth, 2>> {
        if phase != Growth::Grows {
            return Vec::new();
        }
        let forget = |_, [clock, x]: &[f64; 2]| -> Result<_> {
            let after = if *x < self.threshold {
                Growth::WasSmall
            } else {
                Growth::WasLarge
            };
            Ok((after, [*clock, 0.0]))
        };
        vec![Condition::gap(
            "forgets",
            |y| 1.0 - y[0],
            Next::decide(forget),
        )]
    }
}

/// Times and ends agree whatever the steps; only the state at the event tells the runs apart.
#[test]
fn states_at_events_are_compared() {
    let scene = Forgetful {
        threshold: f64::INFINITY,
    };
    let mut ran = 0;
    for tolerance in [1e-3, 1e-6, 1e-9] {
        let done = simulate_within(&scene, tolerance, Growth::Grows, [0.0, 1.0], 2.0).unwrap();
        let before = done.run.transition("forgets").unwrap().before[1];
        let error = (before / exp(8.0) - 1.0).abs();
        assert!(
            error <= done.estimate && done.estimate <= 0.5 * tolerance,
            "{error:e}"
        );
        assert!(done.estimate > 1e-15, "{:e}", done.estimate);
        assert_eq!(done.run.end_state(), Some(&[2.0, 0.0]));
        ran += 1;
    }
    assert_eq!(ran, 3);
}

/// Runs that go through different phases do not agree, however close their states are.
#[test]
fn phases_are_compared() {
    let tolerance = 1e-3;
    let at_event = |step_error: f64| {
        let scene = Forgetful {
            threshold: f64::INFINITY,
        };
        let method = Dop853::new(step_error).unwrap();
        let run = simulate(&scene, &method, Growth::Grows, [0.0, 1.0], 2.0).unwrap();
        run.transition("forgets").unwrap().before[1]
    };
    let (first, second) = (at_event(tolerance), at_event(tolerance / 32.0));
    assert!((first / second - 1.0).abs() < 0.5 * tolerance);
    // The first two runs pass on either side; the third is needed.
    let scene = Forgetful {
        threshold: 0.5 * (first + second),
    };
    let done = simulate_within(&scene, tolerance, Growth::Grows, [0.0, 1.0], 2.0).unwrap();
    assert_eq!(done.step_error, tolerance / 32.0 / 32.0);
    // Without a threshold in between two runs are enough.
    let scene = Forgetful { threshold: 0.0 };
    let done = simulate_within(&scene, tolerance, Growth::Grows, [0.0, 1.0], 2.0).unwrap();
    assert_eq!(done.step_error, tolerance / 32.0);
}
