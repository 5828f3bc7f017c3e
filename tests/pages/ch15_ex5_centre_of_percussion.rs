//! Exercise 15.5. The simulation knows contacts and a hinge and no formula for the place; that it
//! confirms them is part of the report.

use crate::answers::{cell, measured, with_report};
use pages::ch15_ex5_centre_of_percussion::physics::*;
use pages::ch15_ex5_centre_of_percussion::*;
use rotation_dynamics::integrators::{after, ode, size_or};
use rotation_dynamics::math::{hypot, pow};
use std::f64::consts::PI;
use support::{EPS, Errors, assert_largest};

/// Hands that hold push with as much as the place needs that moves, if nobody holds it: the
/// two answers differ by one factor, and vanish at one place.
#[test]
fn a_free_bat_turns_about_the_hands_if_it_is_struck_at_the_centre() {
    let mut errors = Errors::in_units_of(EPS, "velocity of the handle, free, over that of the ball");
    let mut damaged = Errors::of("struck a tenth farther in");
    for hands in [0.0, 0.1, 0.2] {
        let p = Parameters { hands, ..Parameters::default() };
        let part = (hands + centre(&p)) / p.length;
        let away = |part: f64| rigid(&at(&p, part), false).expect("an impact").away / p.speed;
        errors.push(away(part));
        damaged.push(away(part - 0.1));
        let held = Parameters { hit: 0.3, ..p.clone() };
        let ratio = reaction(&held) / free_hands(&held);
        errors.push(ratio * inertia(&held, arms(&held)[0]) / inertia(&held, 0.0) + 1.0);
    }
    assert_largest!(errors, 6, @"0.533");
    damaged.exceed(0.01, 3);
}

/// The shorter the blow of a soft ball, the nearer the answer for rigid bodies: the difference
/// goes as the square of the angle by which the bat turns meanwhile.
#[test]
fn a_short_blow_is_an_impulse() {
    let (p, mut errors) = (Parameters::default(), Errors::of("difference of J_h/J over the time squared"));
    let mut damaged = Errors::of("the same, over the time");
    let off = |contact: f64| {
        let strike = Strike::soft(&Parameters { contact, ..p.clone() });
        Blow::new(strike, 1e-10).expect("a blow").reaction - reaction(&p)
    };
    let [short, long] = [1e-3, 2e-3].map(off);
    errors.push(long / short - 4.0);
    damaged.push(long / short - 2.0);
    assert_largest!(errors, 1, @"6.43e-4");
    damaged.exceed(1.0, 1);
    assert!((cell(&EXAMPLE, "", ["table soft", "0.01", "J_h/J"]) - 0.2189).abs() < 1e-4);
    // The push is even about its middle, so the bat turns at half of its last rate on the whole.
    let turned = cell(&EXAMPLE, "", ["table soft", "0.001", "turned meanwhile / rad"]);
    let last = cell(&EXAMPLE, "", ["effects", "the contact lasts", "value"]);
    assert!((turned / last - 0.5).abs() < 0.01, "{turned} {last}");
}

/// The bending mode is that of a rod with two free ends.
#[test]
fn the_bending_leaves_both_ends_free() {
    let (mut errors, mut damaged) = (Errors::of("curvature and shear over beta^2, beta^3"), Errors::of("at the middle"));
    let [w, _, curvature, shear] = shot(1e-14).expect("a rod").1;
    errors.push(curvature / (BETA * BETA * w));
    errors.push(shear / (BETA * BETA * BETA * w));
    let bent = |x: f64, h: f64| (shape(x + h) - 2.0 * shape(x) + shape(x - h)) / (h * h * BETA * BETA);
    damaged.push(bent(0.5, 1e-3));
    assert_largest!(errors, 2, @"4.09e-15");
    damaged.exceed(1.0, 1);
}

/// What the card measures, by other routes: a vibration pushed by a ball on a wall, the formula
/// for a heavier tip, and the turning to second order.
#[test]
fn what_the_card_measures() {
    let [bending, tip, contact] = measured(&EXAMPLE);
    let p = Parameters::default();
    let numbers = with_report(&EXAMPLE, |report| report.effects().iter().map(|line| line.value).collect::<Vec<_>>());
    let (x, angle) = (numbers[0], numbers[2]);
    let deepest = 1.0 / 2.943_275_f64;
    // Depth of the ball and its rate, place of the vibration and its rate.
    let law = ode(move |_, &[d, v, a, w]: &[f64; 4]| {
        let force = 1.25 / pow(deepest, 2.5) * pow(d.max(0.0), 1.5);
        [v, -force, w, 0.5 * force - PI * PI * x * x * a]
    })
    .scaled(size_or([1.0; 4]));
    let [_, _, a, w] = after(1.5, &law, &[0.0, 1.0, 0.0, 0.0], 1e-10).unwrap();
    let mut errors = Errors::of("measured over another route, less one");
    errors.push(bending[1] / (shape(0.0) * shape(p.hit / p.length) * hypot(w, PI * x * a)).abs() - 1.0);
    errors.push(tip[1] / tip[0] - 1.0);
    errors.push(contact[1] / contact[0] - 1.0);
    assert_largest!(errors, 3, @"5.38e-5");
    // A push in no time, a uniform bat that is longer, half the square of the angle and no more.
    let mut damaged = Errors::of("other laws");
    damaged.push(bending[1] / (shape(0.0) * shape(p.hit / p.length)) - 1.0);
    damaged.push(tip[1] / (0.05 * p.length) - 1.0);
    damaged.push(contact[1] / (-0.5 * angle * angle * (1.0 + reaction(&p))) - 1.0);
    damaged.exceed(0.03, 3);
}
