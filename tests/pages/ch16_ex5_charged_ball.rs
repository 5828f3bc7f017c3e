//! Exercise 16.5, the charged ball. The simulation knows masses, pull and one contact with dry
//! friction; that it confirms the formulas is part of the report.

use crate::answers::{cell, measured, value};
use kit::prelude::*;
use pages::ch16_ex5_charged_ball::physics::*;
use pages::ch16_ex5_charged_ball::*;
use rotation_dynamics::planar::contact::{MechanismState, Mode, misdeclared};
use support::{Errors, assert_largest};

fn ball() -> Ball {
    Ball::new(&Parameters::default()).unwrap()
}

/// Energy: what the field has done is in the going and in the turning; without the turning it
/// is not. And the acceleration is that of a slope with tan(theta) = qE/mg, seen along it.
#[test]
fn the_work_of_the_field_is_shared() {
    let (ball, mut errors, mut damaged) = (ball(), Errors::of("energy, relative"), Errors::of("without the turning"));
    let run = ball.run(ball.start(0.0, 0.0), 9.0, 1e-13).unwrap();
    for t in times(0.02, 0.46, 20) {
        let [x, v, rim] = state(&run, t);
        errors.push((v * v + 0.4 * rim * rim) / (2.0 * ball.pull * x) - 1.0);
        damaged.push(v * v / (2.0 * ball.pull * x) - 1.0);
        assert_eq!(run.modes(t).unwrap(), [Mode::Stick]);
    }
    assert_largest!(errors, 21, @"1.55e-15");
    damaged.exceed(0.28, 21);
    assert!(misdeclared(&ball, &ball.start(0.3, 1.3)) < 1e-9);
}

/// Way, velocity of the middle and of the rim.
fn state(run: &Roll, t: f64) -> [f64; 3] {
    let MechanismState { q, v } = run.at(t).unwrap();
    [q[0], v[0], -0.01 * v[2]]
}

/// About a point of the slab neither N - mg nor friction has a moment: the angular momentum
/// m R v + I omega grows by q E R t, whether the ball rolls or slips, and from any start.
#[test]
fn the_moment_about_the_slab_decides() {
    let (mut errors, mut damaged) = (Errors::of("angular momentum, relative"), Errors::of("a hoop's"));
    for (mu, shot) in [(0.3, 0.0), (0.05, 0.0), (0.0, 0.2), (0.3, -0.3), (0.05, 0.3)] {
        let ball = Ball { mu, length: 10.0, ..ball() };
        let [_, v, rim] = state(&ball.run(ball.start(0.0, shot), 0.4, 1e-13).unwrap(), 0.4);
        let moment = |k: f64| (v + k * rim - shot) / (0.4 * ball.pull) - 1.0;
        errors.push(moment(0.4));
        if mu > 0.0 {
            damaged.push(moment(1.0));
        }
    }
    assert_largest!(errors, 5, @"2.22e-16");
    damaged.exceed(0.05, 4);
}

/// What rubbing takes, by simulation, is greatest for mu/mu_min = 7/2 - sqrt(35)/2, the root of
/// 1 - 2 s + 2 s^2/7, and there 6 - sqrt(35), a twelfth.
#[test]
fn the_greatest_loss_is_a_twelfth() {
    let root = 35.0_f64.sqrt();
    let lost = |s: f64| {
        let ball = Ball { mu: s * 0.5 * (7.0 - root) * ball().holding() / ball().press, ..ball() };
        let [x, v, rim] = state(&ball.run(ball.start(0.0, 0.0), 0.3, 1e-12).unwrap(), 0.3);
        1.0 - (v * v + 0.4 * rim * rim) / (2.0 * ball.pull * x)
    };
    assert!(lost(0.99) < lost(1.0) && lost(1.01) < lost(1.0));
    let [error, damaged] = [1.0, 0.5].map(|s| (lost(s) - (6.0 - root)).abs());
    assert!(error < 1e-16 && damaged > 0.01, "{error:e} {damaged}");
}

/// A simulated ball that slips is faster than the formula of rolling by what the card says, and
/// without any friction the card is still one of numbers.
#[test]
fn a_ball_that_slips_is_faster_than_one_that_rolls() {
    let [rolls, _] = ball().accelerations();
    for (mu, missed) in [(0.04, 0.15), (0.0, 0.29)] {
        let (_, [ran, ..]) = Ball { mu, ..ball() }.rolled(9.0, 1e-12).unwrap();
        let part = 1.0 - rolls * 2.0 * ball().length / (ran * ran);
        let told = cell(&EXAMPLE, &format!("--friction={mu}"), ["effects", "slipping", "error if left out"]);
        assert!((part - missed).abs() < 0.005 && told == missed, "{part} {told}");
    }
}

/// A charged spot on a slab that is not rough enough for it: it slips where the formula says.
#[test]
fn a_spotted_ball_slips_where_friction_ends() {
    let (mut errors, mut damaged) = (Errors::of("angle of the first slip"), Errors::of("spot half as far"));
    for part in [0.3, 0.6, 0.9] {
        let (k, spot) = (0.4, 0.5);
        let mu = (k + part * spot) / (1.0 + k) * ball().pull / ball().press;
        let there = Ball { mu, spot: spot * 0.01, ..ball() };
        let run = there.run(there.start(0.0, 0.0), 0.2, 1e-10).unwrap();
        let turned = -run.event("ball slips").unwrap().before.q[2];
        errors.push(sin(turned) - part);
        damaged.push(sin(turned) - 0.5 * part);
    }
    assert_largest!(errors, 3, @"2.22e-16");
    damaged.exceed(0.1, 3);
}

/// Rolling resistance and air take what the card says. An image charge presses, and nothing else:
/// the ball goes as fast, and holds with less friction.
#[test]
fn what_is_left_out_costs_what_the_card_says() {
    let mut errors = Errors::of("loss of work over prediction, less one");
    measured::<2>(&EXAMPLE).into_iter().for_each(|[cost, found]| errors.push(found / cost - 1.0));
    assert_largest!(errors, 2, @"4.22e-3");
    let pressed = Ball { press: 1.1 * ball().press, ..ball() };
    let [plain, other] = [ball(), pressed].map(|ball| ball.rolled(9.0, 1e-12).unwrap().1[0]);
    let [force] = pressed.run(pressed.start(0.0, 0.0), 0.01, 1e-12).unwrap().forces(0.005).unwrap();
    let needed = -force.tangential / force.normal * 1.1 / value(&EXAMPLE, "mu_min");
    assert!((other / plain - 1.0).abs() < 1e-12 && (needed - 1.0).abs() < 1e-9, "{needed}");
}
