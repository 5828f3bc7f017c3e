//! Scenes in phases: impacts, stops, contacts that let go, and what is refused.

#[path = "planar/block.rs"]
mod block;
#[path = "planar/corner.rs"]
mod corner;
#[path = "planar/declared.rs"]
mod declared;
#[path = "planar/drift.rs"]
mod drift;
#[path = "planar/error_control.rs"]
mod error_control;
#[path = "planar/impacts.rs"]
mod impacts;
#[path = "planar/ladder.rs"]
mod ladder;
#[path = "planar/lift.rs"]
mod lift;
#[path = "planar/overhang.rs"]
mod overhang;
#[path = "planar/resistance.rs"]
mod resistance;
#[path = "planar/rest.rs"]
mod rest;
#[path = "planar/rod.rs"]
mod rod;
#[path = "planar/rollers.rs"]
mod rollers;
#[path = "planar/rolling.rs"]
mod rolling;
#[path = "planar/statics.rs"]
mod statics;
#[path = "planar/ties.rs"]
mod ties;
#[path = "planar/units.rs"]
mod units;

use rotation_dynamics::Error;
use rotation_dynamics::integrators::{Dop853, size_or};
use rotation_dynamics::planar::{
    Bilateral, Condition, Next, Phased, simulate, simulate_so_far, simulate_within,
};
use support::{EPS, Errors, assert_error, assert_largest};

/// Acceleration of gravity, m/s^2.
const G: f64 = 9.80665;

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

    fn scale(&self, y: &[f64; 2]) -> [f64; 2] {
        size_or([1.0; 2])(y)
    }
}

fn method() -> Dop853 {
    Dop853::new(1e-12).unwrap()
}

/// Errors of the times of five bounces, if the ball comes back with `restitution`, against
/// those for one half.
fn bounces(restitution: f64) -> Errors {
    let ball = Ball { restitution };
    let run = simulate(&ball, &method(), (), [5.0, 0.0], 2.9).unwrap();
    assert_eq!(run.end_time(), 2.9);
    let mut errors = Errors::in_units_of(EPS, "times of bounces");
    for (bounce, want) in run.transitions().iter().zip([1.0, 2.0, 2.5, 2.75, 2.875]) {
        errors.add(bounce.t, want, want);
    }
    errors
}

/// A ball from 5 m meets the floor at 1 s and then after 2 e^n s each.
#[test]
fn a_ball_bounces_on_time() {
    // Parabolas are integrated exactly; the largest is that of the fifth bounce.
    assert_largest!(bounces(0.5), 5, @"9.74");
    let run = simulate(&Ball { restitution: 0.5 }, &method(), (), [5.0, 0.0], 2.9).unwrap();
    assert_eq!(run.transitions().len(), 5);
    // Between: the top of the second arc, at a quarter of the height.
    assert_error!(run.at(1.5).unwrap().1[0], 1.25, 4.8 eps);
    // The damaged twin: another floor.
    assert!(bounces(0.5 + 1e-12).largest() > 1e3);
}

/// Infinitely many bounces in a finite time end in an error, not in a loop; the run up to there is not
/// lost.
#[test]
fn bounces_without_end_are_refused() {
    let ball = Ball { restitution: 0.5 };
    let (run, refused) = simulate_so_far(&ball, &method(), (), [5.0, 0.0], 4.0);
    assert!(
        matches!(refused, Some(Error::LimitReached { what: "changes of phase", limit: 1000, .. })),
        "{refused:?}"
    );
    let error = simulate(&ball, &method(), (), [5.0, 0.0], 4.0).unwrap_err();
    assert_eq!(Some(error), refused);
    assert_eq!(run.transitions().len(), 1000);
    assert_error!(run.end_time(), 3.0, 2.8e-13);
    assert_eq!(run.transitions()[9].t, run.pieces()[9].solution.end_time());
}

#[test]
fn a_phase_must_be_entered_in_its_own_conditions() {
    let ball = Ball { restitution: 0.5 };
    let error = simulate(&ball, &method(), (), [-1.0, 0.0], 1.0).unwrap_err();
    let broken = Error::CannotHold { name: "height", t: 0.0, value: -1.0, rate: None };
    assert_eq!(error, broken);
    assert!(simulate(&ball, &method(), (), [f64::NAN, 0.0], 1.0).is_err());
    assert!(simulate(&ball, &method(), (), [1.0, 0.0], f64::INFINITY).is_err());
    let back = simulate(&ball, &method(), (), [1.0, 0.0], -0.25).unwrap_err();
    assert!(matches!(back, Error::OutOfRange { name: "t_end", value: -0.25, .. }), "{back}");
}

#[test]
fn what_did_not_happen_is_said() {
    let ball = Ball { restitution: 0.5 };
    let run = simulate(&ball, &method(), (), [5.0, 0.0], 0.5).unwrap();
    assert!(matches!(run.transition("height"), Err(Error::NotReached { until: 0.5, .. })));
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

    fn scale(&self, y: &[f64; 2]) -> [f64; 2] {
        size_or([1.0; 2])(y)
    }
}

/// The classic that the ladder's middle repeats: off the dome at two thirds of the height.
#[test]
fn a_ball_leaves_the_dome_at_two_thirds() {
    let cos = rotation_dynamics::math::cos;
    let mut errors = Errors::in_units_of(EPS, "height where it leaves");
    let (mut early, mut late) =
        (Errors::in_units_of(EPS, "a step early"), Errors::in_units_of(EPS, "a step late"));
    let mut pulls = Errors::of("the push of a dome that never lets go");
    for angle in [0.05, 0.25, 0.8, 1.3] {
        let height = |y: &[f64; 2]| cos(y[0]) / cos(angle);
        let method = Dop853::new(1e-14).unwrap();
        let run = simulate(&Dome, &method, (), [angle, 0.0], 100.0).unwrap();
        let leaves = run.transition("leaves").unwrap();
        errors.push(height(&leaves.before) - 2.0 / 3.0);
        // Kept on the dome it reaches the floor instead.
        let kept = simulate(&Bilateral(Dome), &method, (), [angle, 0.0], 100.0).unwrap();
        assert_eq!(kept.transitions()[0].name, "floor");
        assert_eq!(kept.transitions().len(), 1);
        let [end, rate] = kept.transitions()[0].before;
        pulls.push((cos(end) - rate * rate).min(0.0));
        // The damaged twins: the event is one of the steps beside it.
        let steps = kept.pieces()[0].solution.step_times();
        let (before, after): (Vec<_>, Vec<_>) = steps.partition(|t| *t < leaves.t);
        for (errors, t) in [(&mut early, before.last()), (&mut late, after.first())] {
            errors.push(height(&kept.at(*t.unwrap()).unwrap().1) - 2.0 / 3.0);
        }
    }
    assert_largest!(errors, 4, @"3");
    early.exceed(1e6, 4);
    late.exceed(1e6, 4);
    // At the floor: the centripetal force of the speed from there, 2 cos(angle).
    pulls.exceed(0.5, 4);
}

/// `solve` delivers what it is asked for, and refuses what doubles cannot hold.
#[test]
fn the_dial_delivers() {
    let ball = Ball { restitution: 0.5 };
    let mut estimates = Errors::of("estimates, in parts of the tolerance");
    let mut errors = Errors::of("time of the fifth bounce, in parts of the tolerance");
    for tolerance in [1e-2, 1e-6, 1e-10, 1e-13] {
        let done = simulate_within(&ball, tolerance, (), [5.0, 0.0], 2.9).unwrap();
        estimates.push(done.estimate / tolerance);
        errors.push((done.run.transitions()[4].t / 2.875 - 1.0) / tolerance);
    }
    assert_largest!(estimates, 4, @"0.193");
    assert_largest!(errors, 4, @"1.11e-5");
    let none = simulate_within(&ball, 1e-10, (), [5.0, 0.0], 0.0).unwrap();
    assert_eq!((none.estimate, none.run.end_time()), (0.0, 0.0));
    assert_eq!(none.run.at(0.0).unwrap().1, [5.0, 0.0]);
    for tolerance in [0.0, -1.0, 1e-15, 0.2, f64::NAN, f64::INFINITY] {
        assert!(simulate_within(&ball, tolerance, (), [5.0, 0.0], 2.9).is_err());
    }
    // A start 1e-12 from the top of the dome: its growth of errors leaves no 1e-13.
    let error = simulate_within(&Dome, 1e-13, (), [1e-12, 0.0], 100.0);
    assert!(matches!(error, Err(Error::NotDelivered { condition: None, .. })), "{error:?}");
}
