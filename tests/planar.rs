//! Scenes in phases: impacts, stops, contacts that let go, and what is refused.

#[path = "planar/block.rs"]
mod block;
#[path = "planar/corner.rs"]
mod corner;
#[path = "planar/dial.rs"]
mod dial;
#[path = "planar/impacts.rs"]
mod impacts;
#[path = "planar/ladder.rs"]
mod ladder;
#[path = "planar/rollers.rs"]
mod rollers;
#[path = "planar/rolling.rs"]
mod rolling;
#[path = "planar/statics.rs"]
mod statics;

use rotation_dynamics::Error;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::EPS;
use rotation_dynamics::planar::{Bilateral, Condition, Next, Phased, simulate, simulate_within};

/// Acceleration of gravity, m/s^2.
const G: f64 = 9.80665;

/// The relative difference of two numbers; NaN if one is.
fn relative(got: f64, want: f64) -> f64 {
    ((got - want) / want).abs()
}

/// A ball above a floor that returns `restitution` of its speed; g = 10 m/s^2.
struct Ball {
    restitution: f64,
}

impl Phased<2> for Ball {
    type Phase = ();
    fn derivative(&self, _: (), [_, speed]: &[f64; 2]) -> [f64; 2] {
        [*speed, -10.0]
    }
    fn conditions(&self, _: ()) -> Vec<Condition<'_, (), 2>> {
        let rebound = Next::jump((), |[_, v]: &[f64; 2]| [0.0, -self.restitution * v]);
        vec![Condition::gap("height", |y| y[0], rebound)]
    }
}

fn method() -> Dop853 {
    Dop853::new(1e-12).unwrap()
}

/// A ball from 5 m meets the floor at 1 s and then after 2 e^n s each.
#[test]
fn a_ball_bounces_on_time() {
    let ball = Ball { restitution: 0.5 };
    let run = simulate(&ball, &method(), (), [5.0, 0.0], 2.9).unwrap();
    let times = [1.0, 2.0, 2.5, 2.75, 2.875];
    assert_eq!(run.transitions().len(), times.len());
    let mut worst = 0.0_f64;
    for (bounce, want) in run.transitions().iter().zip(times) {
        worst = worst.max((bounce.t / want - 1.0).abs());
    }
    // Parabolas are integrated exactly; measured: 10 eps, in the fifth bounce.
    assert!(worst <= 10.0 * EPS, "{} eps", worst / EPS);
    assert_eq!(run.end_time(), 2.9);
    // Between: the top of the second arc, at a quarter of the height.
    assert!((run.at(1.5).unwrap().1[0] - 1.25).abs() <= 1e-14);
    // The damaged twin: another floor.
    let damaged = Ball {
        restitution: 0.5 + 1e-6,
    };
    let run = simulate(&damaged, &method(), (), [5.0, 0.0], 2.9).unwrap();
    assert!((run.transitions()[1].t - 2.0).abs() > 1e-6);
}

/// Infinitely many bounces in a finite time end in an error, not in a loop.
#[test]
fn bounces_without_end_are_refused() {
    let ball = Ball { restitution: 0.5 };
    let error = simulate(&ball, &method(), (), [5.0, 0.0], 4.0).unwrap_err();
    assert!(
        matches!(error, Error::TooManyPhases { limit: 1000, .. }),
        "{error}"
    );
}

#[test]
fn a_phase_must_be_entered_in_its_own_conditions() {
    let ball = Ball { restitution: 0.5 };
    let error = simulate(&ball, &method(), (), [-1.0, 0.0], 1.0).unwrap_err();
    let broken = Error::ConditionBroken {
        name: "height",
        value: -1.0,
        t: 0.0,
    };
    assert_eq!(error, broken);
    assert!(simulate(&ball, &method(), (), [f64::NAN, 0.0], 1.0).is_err());
    assert!(simulate(&ball, &method(), (), [1.0, 0.0], f64::INFINITY).is_err());
}

#[test]
fn what_did_not_happen_is_said() {
    let ball = Ball { restitution: 0.5 };
    let run = simulate(&ball, &method(), (), [5.0, 0.0], 0.5).unwrap();
    assert!(matches!(
        run.transition("height"),
        Err(Error::NotReached { until: 0.5, .. })
    ));
    assert!(matches!(run.at(0.6), Err(Error::OutsideRun { .. })));
    assert!(matches!(run.at(-0.1), Err(Error::OutsideRun { .. })));
    assert!(run.at(f64::NAN).is_err());
}

/// A ball on a smooth dome of radius 1, g = 1, by its angle from the top.
struct Dome;

impl Phased<2> for Dome {
    type Phase = ();
    fn derivative(&self, _: (), [angle, rate]: &[f64; 2]) -> [f64; 2] {
        [*rate, rotation_dynamics::math::sin(*angle)]
    }
    fn conditions(&self, _: ()) -> Vec<Condition<'_, (), 2>> {
        let push = |y: &[f64; 2]| rotation_dynamics::math::cos(y[0]) - y[1] * y[1];
        let floor = |y: &[f64; 2]| core::f64::consts::FRAC_PI_2 - y[0];
        vec![
            Condition::contact("leaves", push, Next::End),
            Condition::gap("floor", floor, Next::End),
        ]
    }
}

/// The classic that the ladder's middle repeats: off the dome at two thirds of the height.
#[test]
fn a_ball_leaves_the_dome_at_two_thirds() {
    let cos = rotation_dynamics::math::cos;
    let mut worst = 0.0_f64;
    for angle in [0.05, 0.25, 0.8, 1.3] {
        let run = simulate(&Dome, &Dop853::new(1e-14).unwrap(), (), [angle, 0.0], 100.0).unwrap();
        let leaves = run.transition("leaves").unwrap();
        worst = worst.max((cos(leaves.before[0]) / cos(angle) - 2.0 / 3.0).abs());
        // Kept on the dome it reaches the floor instead.
        let kept = simulate(&Bilateral(Dome), &method(), (), [angle, 0.0], 100.0).unwrap();
        assert_eq!(kept.transitions()[0].name, "floor");
    }
    // Measured: 4.5e-16.
    assert!(worst <= 4.5e-16, "{worst:e}");
}

/// The dial delivers what it is asked for, and refuses what doubles cannot hold.
#[test]
fn the_dial_delivers() {
    let ball = Ball { restitution: 0.5 };
    for tolerance in [1e-2, 1e-6, 1e-10, 1e-13] {
        let done = simulate_within(&ball, tolerance, (), [5.0, 0.0], 2.9).unwrap();
        assert!(done.estimate <= 0.5 * tolerance);
        let last = done.run.transitions()[4].t;
        assert!((last / 2.875 - 1.0).abs() <= tolerance);
    }
    for tolerance in [0.0, -1.0, 1e-15, 0.2, f64::NAN, f64::INFINITY] {
        assert!(simulate_within(&ball, tolerance, (), [5.0, 0.0], 2.9).is_err());
    }
    // A start 1e-12 from the top of the dome: its growth of errors leaves no 1e-13.
    let error = simulate_within(&Dome, 1e-13, (), [1e-12, 0.0], 100.0);
    assert!(
        matches!(error, Err(Error::NotDelivered { .. })),
        "{error:?}"
    );
}
