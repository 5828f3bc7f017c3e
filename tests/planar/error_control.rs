//! `solve` of scenes in phases: what it compares, and how often it tries.

use super::Dome;
use rotation_dynamics::Result;
use rotation_dynamics::integrators::{Dop853, size_or};
use rotation_dynamics::math::exp;
use rotation_dynamics::planar::{Condition, Next, Phased, Run, simulate, simulate_within};
use support::{EPS, Errors, assert_error, assert_largest};

/// The runs of a scene with this error of a step, and with one 32 times smaller.
fn two_runs<S: Phased<2>>(
    scene: &S,
    phase: S::Phase,
    start: [f64; 2],
    t_end: f64,
    step_error: f64,
) -> [Run<S::Phase, 2>; 2] {
    [step_error, step_error / 32.0].map(|step_error| {
        let method = Dop853::new(step_error).unwrap();
        simulate(scene, &method, phase, start, t_end).unwrap()
    })
}

/// How far two runs off the dome are apart, written down anew: the time of the end, and
/// the state there.
fn apart([a, b]: &[Run<(), 2>; 2]) -> f64 {
    let (x, y) = (&a.transitions()[0], &b.transitions()[0]);
    let time = (x.t - y.t).abs() / y.t;
    (0..2).fold(time, |most, i| {
        let size = y.before[i].abs().max(1.0);
        most.max((x.before[i] - y.before[i]).abs() / size)
    })
}

/// It goes on until two runs agree within half the tolerance, and no sooner.
#[test]
fn two_runs_agree_within_half_the_tolerance() {
    let mut estimates = Errors::of("estimates, in parts of the tolerance");
    let mut again = Errors::in_units_of(EPS, "the estimate, computed anew");
    let mut sooner = Errors::of("the comparison before, in parts of the tolerance");
    let mut looser = Errors::of("what one of 16 times the tolerance would have taken");
    for angle in [1e-3, 1e-2, 0.1, 0.3] {
        for tolerance in [1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9] {
            let done = simulate_within(&Dome, tolerance, (), [angle, 0.0], 100.0).unwrap();
            let runs = |step_error| two_runs(&Dome, (), [angle, 0.0], 100.0, step_error);
            estimates.push(done.estimate / tolerance);
            let anew = apart(&runs(32.0 * done.step_error));
            again.push((anew - done.estimate) / done.estimate.max(f64::MIN_POSITIVE));
            if done.step_error < 0.9 * tolerance / 32.0 {
                let first = apart(&runs(1024.0 * done.step_error)) / tolerance;
                sooner.push(first);
                if first <= 0.5 * 16.0 {
                    looser.push(first);
                }
            }
        }
    }
    assert_largest!(estimates, 32, @"0.364");
    assert_largest!(again, 32, @"0");
    // The damaged twins: whoever stops sooner does not deliver.
    sooner.exceed(0.5, 3);
    looser.exceed(0.5, 3);
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
            let after = if *x < self.threshold { Growth::WasSmall } else { Growth::WasLarge };
            Ok((after, [*clock, 0.0]))
        };
        vec![Condition::gap("forgets", |y| 1.0 - y[0], Next::decide(forget))]
    }

    fn scale(&self, y: &[f64; 2]) -> [f64; 2] {
        size_or([1.0; 2])(y)
    }
}

/// Times and ends agree whatever the steps; only the state at the event tells the runs apart.
#[test]
fn states_at_events_are_compared() {
    let scene = Forgetful { threshold: f64::INFINITY };
    let mut errors = Errors::of("state at the event, in parts of the estimate");
    let mut estimates = Errors::of("estimates, in parts of the tolerance");
    let mut blind = Errors::of("one that sees ends and times alone");
    for tolerance in [1e-3, 1e-6, 1e-9] {
        let done = simulate_within(&scene, tolerance, Growth::Grows, [0.0, 1.0], 2.0).unwrap();
        let before = done.run.transition("forgets").unwrap().before[1];
        errors.push((before / exp(8.0) - 1.0) / done.estimate);
        estimates.push(done.estimate / tolerance);
        assert_eq!(done.run.end_state(), Some(&[2.0, 0.0]));
        // The damaged twin takes the first two runs for the same: ends and times are.
        let [a, b] = two_runs(&scene, Growth::Grows, [0.0, 1.0], 2.0, tolerance);
        let (x, y) = (&a.transitions()[0], &b.transitions()[0]);
        assert_eq!((a.end_state(), x.after), (b.end_state(), y.after));
        assert!((x.t - y.t).abs() <= 2.0 * EPS);
        blind.push((x.before[1] - y.before[1]) / y.before[1]);
    }
    assert_largest!(errors, 3, @"0.0811");
    assert_largest!(estimates, 3, @"0.257");
    blind.exceed(1e-15, 3);
}

/// Runs that go through different phases do not agree, however close their states are.
#[test]
fn phases_are_compared() {
    let tolerance = 1e-3;
    let scene = Forgetful { threshold: f64::INFINITY };
    let runs = two_runs(&scene, Growth::Grows, [0.0, 1.0], 2.0, tolerance);
    let [first, second] = runs.map(|run| run.transitions()[0].before[1]);
    // Their states would pass.
    assert_error!(first, second, 4.1e-5);
    // The first two runs pass on either side; the third is needed.
    let scene = Forgetful { threshold: 0.5 * (first + second) };
    let done = simulate_within(&scene, tolerance, Growth::Grows, [0.0, 1.0], 2.0).unwrap();
    assert_eq!(done.step_error, tolerance / 32.0 / 32.0);
    // Without a threshold in between two runs are enough.
    let scene = Forgetful { threshold: 0.0 };
    let done = simulate_within(&scene, tolerance, Growth::Grows, [0.0, 1.0], 2.0).unwrap();
    assert_eq!(done.step_error, tolerance / 32.0);
}

/// A clock, and a coordinate that grows as e^(8 t). At t = 1 two conditions fail nearly at once:
/// which is first depends on how large the coordinate is. Each puts the clock to 4 and leaves of
/// the coordinate what is said, which decays as e^(-40 t).
struct Tied {
    threshold: f64,
    leaves: [f64; 2],
}

impl Phased<2> for Tied {
    type Phase = ();
    fn derivative(&self, (): (), [clock, x]: &[f64; 2]) -> [f64; 2] {
        [1.0, if *clock < 2.0 { 8.0 * x } else { -40.0 * x }]
    }
    fn conditions(&self, (): ()) -> Vec<Condition<'_, (), 2>> {
        let left = |[clock, _]: &[f64; 2]| (clock - 2.0).abs() - 1.0;
        let [one, other] = self.leaves.map(|x| Next::jump((), move |_: &[f64; 2]| [4.0, x]));
        vec![
            Condition::gap("one", left, one),
            Condition::gap("other", move |y| left(y) + 1e-7 * (self.threshold - y[1]), other),
        ]
    }

    fn scale(&self, y: &[f64; 2]) -> [f64; 2] {
        size_or([1.0; 2])(y)
    }
}

/// Of two conditions that fail together one run meets the one first, the next run the other:
/// they agree if the same follows.
#[test]
fn what_follows_is_compared_and_not_which_came_first() {
    let tolerance = 1e-3;
    let runs = |scene: &Tied| two_runs(scene, (), [0.0, 1.0], 2.0, tolerance);
    let before = |run: Run<(), 2>| run.transitions()[0].before[1];
    let [first, second] = runs(&Tied { threshold: 1e4, leaves: [0.0; 2] }).map(before);
    let tied = |leaves| Tied { threshold: 0.5 * (first + second), leaves };
    let names = runs(&tied([0.0; 2])).map(|run| run.transitions()[0].name);
    assert_ne!(names[0], names[1]);
    let step_error = |leaves| {
        let done = simulate_within(&tied(leaves), tolerance, (), [0.0, 1.0], 2.0);
        done.unwrap().step_error
    };
    assert_eq!(step_error([0.0; 2]), tolerance / 32.0);
    // The damaged twin: something else follows, which is forgotten by the end.
    assert_eq!(step_error([0.0, 1.0]), tolerance / 32.0 / 32.0);
}
