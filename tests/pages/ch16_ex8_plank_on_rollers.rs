//! Exercise 16.8, the plank on rollers. That simulations confirm the formulas is part of the
//! report: a claim or a limit that differs from its oracle is an error.

use crate::answers::{computed, confirmed, errors_of, refused, value};
use core::f64::consts::TAU;
use pages::ch16_ex8_plank_on_rollers::*;
use rotation_dynamics::integrators::{Dop853, second_order};
use rotation_dynamics::planar::contact::{MechanismState, misdeclared};
use support::{EPS, Errors, assert_largest};

#[test]
fn the_instances_of_the_notes_come_out() {
    let instances = [
        ("period", 2.590_263_258_624_38),
        ("growth", 2.425_693_715_208_08),
        ("widest", 0.123_675_960_455_817),
    ];
    assert_largest!(errors_of(&EXAMPLE, instances), 3, @"33.4");
    // The others have parameters of their own.
    let mut shown = Errors::in_units_of(EPS, "the other instances, relative");
    let cycle = "--distance=1.2 --kinetic=0.2 --holding=0.35 --speed=0.25";
    shown.add(computed(&EXAMPLE, cycle, "carried"), 0.163_636_363_636_364, 1.0);
    shown.add(computed(&EXAMPLE, cycle, "cycle"), 4.170_363_984_318_52, 1.0);
    let thick = "--thickness=0.05";
    shown.add(TAU / computed(&EXAMPLE, thick, "period"), 2.444_093_678_366_16, 1.0);
    assert_largest!(shown, 3, @"40");
    let thin = TAU / value(&EXAMPLE, "period");
    assert!((thin - 2.444_093_678_366_16).abs() > 0.01);
}

/// The cases `rollers-*` of the reference, which knows when a roller catches the plank and when
/// it tips.
#[test]
fn the_reference_cases_are_met() {
    let mut errors = Errors::of("times of the reference, s");
    let slow = "--speed=0.3 --holding=0.3 --offset=0.3";
    let out = "--holding=0.35 --speed=0.8 --offset=0.01";
    errors.add(computed(&EXAMPLE, slow, "stick"), 0.175_177_030_501_247_4, 1.0);
    errors.add(computed(&EXAMPLE, out, "stick_out"), 1.727_046_577_034_775_5, 1.0);
    errors.add(computed(&EXAMPLE, out, "tip"), 1.939_603_911_730_871_6, 1.0);
    assert_largest!(errors, 3, @"2.22e-16");
    // The damaged twin: a roller that is faster by a thousandth.
    let off = computed(&EXAMPLE, &slow.replace("speed=0.3 ", "speed=0.3003 "), "stick");
    assert!((off - 0.175_177_030_501_247_4).abs() > 1e-4, "{off}");
}

#[test]
fn formulas_and_simulations_agree() {
    let alone = [
        "--distance=0.03", "--distance=40", "--kinetic=0.02", "--kinetic=1.5 --holding=4",
        "--holding=0.3", "--holding=5", "--speed=0.02", "--speed=4", "--offset=1e-5",
        "--offset=0.49", "--thickness=0.4", "--thickness=3.2 --offset=0.01", "--gravity=1.62",
        "--sense=out", "--tolerance=1e-6", "--speed=0.9 --holding=2 --offset=0.45",
        "--holding=0.30003 --offset=0.45",
    ];
    let fits = |run: &str| match run.contains("distance=0.03") {
        true => format!("{run} --offset=0.01"),
        false => run.to_owned(),
    };
    confirmed(&EXAMPLE, alone.map(fits), 17);
    confirmed(&EXAMPLE, [
        "--offset=-0.3", "--offset=-0.3 --sense=out", "--offset=0", "--offset=-1e-9",
        "--speed=-0.3", "--speed=0.001", "--speed=1e4", "--kinetic=1e-4",
        "--kinetic=20 --holding=30", "--holding=1e6", "--distance=1e4", "--gravity=1e-3",
        "--thickness=3.333 --offset=1e-5",
    ], 13);
}

/// On the other side the plank moves as in a mirror, and rollers that turn the other way are
/// those of the other picture.
#[test]
fn the_other_side_is_a_mirror() {
    for key in ["period", "stick", "tip", "carried", "amplitude", "cycle"] {
        let there = computed(&EXAMPLE, "", key);
        assert_eq!(computed(&EXAMPLE, "--offset=-0.3", key), there, "{key}");
        assert_eq!(computed(&EXAMPLE, "--speed=-0.3", key), there, "{key}");
    }
    let [right, left] = ["", "--offset=-0.3"].map(|flags| computed(&EXAMPLE, flags, "right"));
    assert!((right + left - 1.0).abs() < 1e-15 && right > 0.7, "{right} {left}");
}

#[test]
fn what_is_no_plank_on_rollers_is_refused() {
    refused(&EXAMPLE, [
        ("--distance=-1", "distance = -1 is not allowed"),
        ("--kinetic=0", "kinetic = 0 is not allowed"),
        ("--holding=0.2", "what rests holds no less than what slips"),
        ("--speed=0", "at 0 the rollers rest"),
        ("--offset=0.5", "offset = 0.5 is not allowed"),
        ("--offset=-0.6", "at an end it lifts off a roller"),
        ("--gravity=-1", "gravity = -1 is not allowed"),
        ("--thickness=4", "jams the plank"),
    ]);
}

/// What the scene says about its contacts is true: tilted, thick, and in motion.
#[test]
fn the_contacts_are_declared_truly() {
    let p = Parameters { thickness: 0.2, ..Parameters::default() };
    let state = MechanismState { q: [0.2, 0.03, -0.15], v: [0.7, -0.3, 0.9] };
    let found = misdeclared(&plank(&p, 1.0).unwrap(), &state);
    assert!(found < 1e-9, "{found}");
}

fn from(offset: f64) -> Parameters {
    Parameters { offset, ..Parameters::default() }
}

/// Swings within the largest circle never stick; all wider ones have the same cycle.
#[test]
fn only_wide_swings_end_in_the_cycle() {
    let p = Parameters::default();
    let (widest, (amplitude, period)) = (p.speed / rate(&p, 1.0), cycle(&p));
    for part in [0.01, 0.5, 0.999] {
        let ride = released(&from(part * widest), 1.0, 10.0 * period).unwrap();
        assert!(ride.events().is_empty());
    }
    let (mut errors, mut damaged) = (Errors::of("period and amplitude"), Errors::of("oscillation"));
    for offset in [1.001 * widest, 0.15, amplitude, 0.3, 0.45] {
        let ride = released(&from(offset), 1.0, 6.0 * period).unwrap();
        let slips = ride.events().iter().filter(|event| event.name == "right slips");
        let slips: Vec<f64> = slips.map(|event| event.t).collect();
        let last = slips.len() - 1;
        let round = slips[last] - slips[last - 1];
        errors.push_at(round - period, offset);
        damaged.push(round - TAU / rate(&p, 1.0));
    }
    assert_largest!(errors, 5, @"2.31e-14");
    damaged.exceed(0.3, 5);
}

/// The period by the smooth law is too long by less, the sharper it is, and costs more.
#[test]
fn a_smooth_law_is_late_and_dear() {
    let cell = |width, column| crate::answers::cell(&EXAMPLE, "", ["table smooth", width, column]);
    let late = ["1e-1", "1e-2", "1e-3"].map(|width| cell(width, "too long, as a part of the period"));
    let work = ["1e-1", "1e-2", "1e-3"].map(|width| cell(width, "evaluations in a period"));
    assert!(late.windows(2).all(|pair| pair[0] / pair[1] < 5.0 && pair[0] / pair[1] > 3.0), "{late:?}");
    assert!(work[2] / work[1] > 5.0 && work[2] > 5e4, "{work:?}");
    // The contact solver: the whole ride, twice around.
    let p = Parameters::default();
    let ride = released(&p, 1.0, 2.5 * cycle(&p).1).unwrap();
    assert!(ride.work().derivatives < 2000, "{:?}", ride.work());
}

/// Friction mu times the sign of the slip, in steps of a millisecond.
#[test]
fn a_law_of_signs_chatters_and_has_no_cycle() {
    let p = Parameters::default();
    let (mut x, mut v, h) = (p.offset, 0.0, 1e-3);
    let (mut held, mut turns, mut widest, mut last) = (0, 0, 0.0_f64, 0.0);
    for step in 0..20_000 {
        let (left, right) = (0.5 - x / p.distance, 0.5 + x / p.distance);
        let slip = -p.speed - v;
        let friction = (p.speed - v).signum() * left + slip.signum() * right;
        v += h * p.kinetic * p.gravity * friction;
        x += h * v;
        // While it should be held: from the catch to the middle.
        let t = h * f64::from(step);
        if t > caught(&p, 1.0).0 && x > 0.0 && t < 1.2 {
            held += 1;
            turns += i32::from(slip * last < 0.0);
        }
        if t > 5.0 {
            widest = widest.max(x.abs());
        }
        last = slip;
    }
    // Nearer to the middle the left roller all but balances the right one, and it takes longer.
    assert!(held > 800 && turns > 300, "{turns} of {held}");
    let circle = p.speed / rate(&p, 1.0);
    assert!((widest / circle - 1.0).abs() < 0.05 && widest < 0.8 * cycle(&p).0, "{widest}");
}

/// Friction that falls by a part of itself with each unit of slip: growth as predicted.
#[test]
fn falling_friction_makes_the_swing_grow() {
    let p = Parameters::default();
    let (mut errors, mut damaged) = (Errors::of("growth, relative"), Errors::of("none"));
    for fall in [0.01, 0.1] {
        let mu = move |slip: f64| p.kinetic * slip.signum() * (1.0 - fall * slip.abs());
        let (a, g, speed) = (p.distance, p.gravity, p.speed);
        let ode = second_order(move |_, x, v| {
            g * (mu(speed - v) * (0.5 - x / a) + mu(-speed - v) * (0.5 + x / a))
        });
        let zero = |n| Dop853::new(1e-13).unwrap().zero(&ode, [1e-3, 0.0], n, 100.0, |y| y[1]).unwrap().0;
        // The start is a turning point; after two more it is on the same side again.
        let (from, to) = (zero(2), zero(4));
        let growth = (to.state[0] / from.state[0]).ln() / (to.t - from.t);
        let predicted = 0.5 * g * fall * p.kinetic;
        errors.push_at(growth / predicted - 1.0, fall);
        damaged.push(growth / (2.0 * predicted) - 1.0);
    }
    assert_largest!(errors, 2, @"3.99e-12");
    damaged.exceed(0.4, 2);
}
