//! Exercise 15.2. That simulation, particles and formulas agree is part of the report: a claim that
//! differs from its oracle is an error.

use crate::answers::measured;
use pages::ch15_ex2_gears::physics::*;
use pages::ch15_ex2_gears::*;
use rotation_dynamics::math::exp;
use support::{Errors, assert_largest};

/// The centre of B is at rest, so B has one angular momentum about all points of the plane; carried
/// by an arm it has not.
#[test]
fn a_gear_on_an_axis_at_rest_has_its_own_angular_momentum_about_every_point() {
    let p = Parameters::default();
    let (mut errors, mut damaged) = (Errors::of("L of B over I2 Omega2"), Errors::of("carried"));
    let own = p.inertia_b * rate_b(&p, 0.0);
    for about in [[0.0, 0.0], [0.5, 0.0], [-5.0, 2.0], [0.1, -0.7], [40.0, 3.0]] {
        errors.push(particles(&p, [0.0, rate_b(&p, 0.0)], about) / own - 1.0);
        let carried = particles(&p, [5.0, rate_b(&p, 5.0)], about);
        damaged.push(carried / (p.inertia_b * rate_b(&p, 5.0)) - 1.0);
    }
    assert_largest!(errors, 5, @"4.32e-11");
    damaged.exceed(1.0, 5);
}

/// Torques from outside account for the change of L: of the motor and of the bearing of B. Without
/// the bearing they do not, and the kept angular momentum would speed up A.
#[test]
fn motor_and_bearing_change_the_angular_momentum() {
    let p = Parameters::default();
    let (mut errors, mut damaged) = (Errors::of("change of L less the impulses"), Errors::of("without the bearing"));
    for driven in [true, false] {
        let run = spun_up(&p, driven, 1e-12).expect("a motion");
        let [a, b] = run.at(run.end_time()).expect("its end").v;
        let change = p.inertia_a * (a - p.rate) + p.inertia_b * b;
        let push = p.friction * run.event("rims sticks").expect("it sticks").t;
        let motor = if driven { motor(&run).expect("a torque") } else { 0.0 };
        errors.push(change - motor + push * (p.radius_a + p.radius_b));
        damaged.push(change - motor);
    }
    assert_largest!(errors, 2, @"2.22e-16");
    damaged.exceed(0.4, 2);
    let kept = p.inertia_a * p.rate / (p.inertia_a - p.inertia_b * ratio(&p));
    assert!(kept > 1.9 * p.rate, "{kept}");
}

/// What the card measures, by other routes: the rims hold where a rate that falls as an exponential
/// meets one that grows steadily, and formulas for the rest.
#[test]
fn what_the_card_measures() {
    let [motor, radius, bearing, which] = measured(&EXAMPLE);
    let p = Parameters::default();
    let (b, own) = (rate_b(&p, 0.0).abs(), p.friction * p.radius_a / (0.03 * p.rate) / p.inertia_a);
    let part = |t: f64| 1.0 - 0.03 * (1.0 - exp(-own * t));
    let behind = |t: f64| b * part(t) > p.friction * p.radius_b / p.inertia_b * t;
    let [low, _] = kit::bisect([0.0, time(&p)], 0.0, behind);
    let (whole, rubs) = (momentum(&p, 0.0), 1.5e-3 * (9.80665 * p.mass_b + p.friction) * 0.005);
    let mut errors = Errors::of("measured over another route, less one");
    errors.push(motor[1] / (whole * (1.0 - part(low))) - 1.0);
    errors.push(radius[1] / (p.inertia_b * (b - p.rate * p.radius_a / (p.radius_b + 1e-4))) - 1.0);
    let left = p.friction * p.radius_b - rubs;
    errors.push(bearing[1] / (time(&p) * rubs / left) - 1.0);
    errors.push(which[1] / (p.rate - undriven(&p)) - 1.0);
    assert_largest!(errors, 4, @"9.37e-13");
    // B forgotten, the radius of A, the lever of A.
    let mut damaged = Errors::of("other laws");
    damaged.push(motor[1] / (0.03 * p.inertia_a * p.rate) - 1.0);
    damaged.push(radius[1] / (p.inertia_b * b * 1e-4 / p.radius_a) - 1.0);
    damaged.push(bearing[1] / (time(&p) * rubs / (p.friction * p.radius_a)) - 1.0);
    damaged.exceed(0.1, 3);
}
