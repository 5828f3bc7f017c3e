//! Exercise 15.8, a string pulled in. That the simulated string confirms the formulas is part of
//! the report: a claim that differs from its oracle is an error.

use kit::simpson;
use pages::ch15_ex8_string::physics::*;
use pages::ch15_ex8_string::*;
use rotation_dynamics::integrators::{after, place_and_velocity};
use rotation_dynamics::math::{hypot, sincos};
use support::{Errors, assert_largest};

/// Forty times up to the edge of the hole: the simulation runs along the spiral, the string
/// pulls, and the angular momentum stays.
#[test]
fn the_spiral_and_the_tension() {
    let (mut path, mut force) = (Errors::of("place over r"), Errors::of("force, relative"));
    let (mut momentum, mut damaged) = (Errors::of("angular momentum"), Errors::of("speed kept"));
    let a = Answer { pull: 0.1 };
    let run = Pulled::new(0.1, 0.05, 1e-14, 9.5).unwrap();
    for k in 1..=40 {
        let t = 9.4 / 40.0 * f64::from(k);
        let (state, r, (s, c)) = (run.at(t).unwrap(), a.radius(t), sincos(a.angle(t)));
        path.push(hypot(state.q[0] - r * c, state.q[1] - r * s) / r);
        let tension = run.tension(t).unwrap();
        assert!(tension > 1.0);
        force.add(tension, a.force(t), a.force(t));
        momentum.push(radius(&state) * across(&state) - 1.0);
        damaged.push(r - 1.0);
    }
    assert_largest!(path, 40, @"4.99e-12");
    assert_largest!(force, 40, @"8.33e-14");
    assert_largest!(momentum, 40, @"5.20e-14");
    damaged.exceed(0.02, 40);
}

/// The work of the simulated tension along the way of the hand, by Simpson's rule.
#[test]
fn the_work_is_the_energy_gained() {
    let (mut errors, mut damaged) = (Errors::of("work less gain"), Errors::of("first force all the way"));
    for pull in [0.03, 1.0 / 15.0, 0.3, 2.0] {
        let end = 0.5 / pull;
        let run = Pulled::new(pull, 0.1, 1e-14, end).unwrap();
        let work = simpson([0.0, end], 400, |t| run.tension(t)).unwrap() * pull;
        // After the jerk the particle has the energy of both velocities.
        let gain = energy(&run.at(end).unwrap()) - 0.5 * (1.0 + pull * pull);
        errors.push(work - gain);
        damaged.push(pull * end - gain);
    }
    assert_largest!(errors, 4, @"5.13e-11");
    damaged.exceed(0.9, 4);
}

/// On a post the force is at right angles to the velocity: the speed stays, the angular momentum
/// goes with the free length, whose square falls evenly; the string lets the particle go nowhere
/// but where its free part is.
#[test]
fn a_post_keeps_the_speed_and_not_the_angular_momentum() {
    let (mut errors, mut damaged) = (Errors::of("post"), Errors::of("angular momentum"));
    for post in [0.01, 0.1, 0.3] {
        for part in [0.2, 0.5, 0.8] {
            let t = 0.5 * part / post;
            let end = after(t, &on_post(post), &[1.0, -post, 0.0, 0.0, 1.0, 0.0], 1e-14).unwrap();
            let [place, velocity] = place_and_velocity(&end);
            let momentum = place.x() * velocity.y() - place.y() * velocity.x();
            let free = string_on_post(post, place);
            errors.push(velocity.norm() - 1.0);
            errors.push(momentum - free.norm());
            errors.push(free.dot(&free) - (1.0 - part));
            damaged.push(momentum - 1.0);
        }
    }
    assert_largest!(errors, 27, @"1.18e-13");
    damaged.exceed(0.1, 9);
}
