//! Section 16.1: rolling on an incline.

use crate::answers::{answer, confirmed, refused, value};
use kit::prelude::*;
use pages::ch16_1_incline::*;
use rotation_dynamics::planar::contact::{Mode, misdeclared, motion_within};
use std::f64::consts::{PI, TAU};
use support::{Errors, assert_error, assert_largest};

fn cylinder() -> Roller {
    Roller::new(&Parameters::default())
}

/// Where a piece of a rolling cylinder of radius 1 is, at (r, a) in the body, after the way x.
fn piece(x: f64, r: f64, a: f64) -> (f64, f64) {
    (x + r * cos(a - x), 1.0 + r * sin(a - x))
}

/// The constraint: a piece at the rim comes down to the slope, rests there for an instant, and is
/// back after a way of 2 pi R.
#[test]
fn eq_16_1_roll_constraint() {
    let (mut errors, mut damaged) = (Errors::of("velocity of contact"), Errors::of("slipping"));
    for x in times(0.0, 6.0, 30) {
        let (h, a) = (1e-5, x - 0.5 * PI);
        let speed = |slip: f64| {
            let [(ax, ay), (bx, by)] = [-h, h].map(|h| piece(x + h, 1.0, a - slip * h));
            hypot(bx - ax, by - ay) / (2.0 * h)
        };
        errors.push(speed(0.0));
        damaged.push(speed(0.1));
    }
    assert_largest!(errors, 31, @"2.22e-11");
    damaged.exceed(0.09, 31);
    let (from, to) = (piece(0.0, 1.0, -0.5 * PI), piece(TAU, 1.0, -0.5 * PI));
    assert_eq!(to.0 - from.0, TAU);
}

/// The kinetic energy from the pieces of a cylinder that rolls: (1 + k) m x'^2/2.
#[test]
fn eq_16_1_ex1_kinetic_energy() {
    let (mut errors, mut damaged) = (Errors::of("T over (m x'^2/2)"), Errors::of("no rotation"));
    for x in [0.0, 0.7, 2.0, 5.0] {
        let (n, h, mut sum) = (60, 1e-5, 0.0);
        for ring in times(0.5 / 60.0, 59.5 / 60.0, n - 1) {
            // Rings of equal mass, twelve pieces each.
            for a in times(0.0, TAU * 11.0 / 12.0, 11) {
                let [(ax, ay), (bx, by)] = [-h, h].map(|h| piece(x + h, ring.sqrt(), a));
                let square = ((bx - ax) * (bx - ax) + (by - ay) * (by - ay)) / (4.0 * h * h);
                sum += square / f64::from(12 * n);
            }
        }
        errors.push(sum - 1.5);
        damaged.push(sum - 1.0);
    }
    assert_largest!(errors, 4, @"1.27e-10");
    damaged.exceed(0.4, 4);
}

/// E29: the height gained is x sin theta, so that -m g x sin theta stands in the Lagrangian; with
/// the printed cosine the equation of motion would have it too, and miss the simulated one.
#[test]
fn e29_the_height_has_the_sine() {
    let (mut errors, mut damaged) = (Errors::of("acceleration"), Errors::of("with the cosine"));
    let mut energies = Errors::of("energy along the simulation");
    for slope in [0.05, 0.3, 1.2] {
        let body = Roller { slope, mu: 2.0, ..cylinder() };
        let run = body.run(Goal::Top, 2.0, 100.0, 1e-12).unwrap();
        let turns = run.event("turns").unwrap();
        // Lagrange's equation for m (1 + k) x'^2/2 - m g x f(theta), with the derivative of the
        // potential by x taken as a difference.
        let lagrange = |height: fn(f64) -> f64| {
            let potential = |x: f64| body.gravity * x * height(slope);
            -(potential(1.0) - potential(-1.0)) / (2.0 * 1.5)
        };
        errors.push(lagrange(sin) * turns.t / 2.0 + 1.0);
        damaged.push(lagrange(cos) * turns.t / 2.0 + 1.0);
        // The height of the middle in space gives back what the motion has lost.
        let height = turns.before.q[0] * sin(slope);
        energies.push(body.gravity * height / (0.75 * 4.0) - 1.0);
    }
    assert_largest!(errors, 3, @"1.11e-16");
    assert_largest!(energies, 3, @"4.44e-16");
    damaged.exceed(0.5, 3);
}

/// The acceleration -(2/3) g sin theta, up and down: second differences of the simulation.
#[test]
fn eq_16_1_ex1_acceleration() {
    let (body, h) = (cylinder(), 1e-3);
    let run = body.run(Goal::Never, 2.0, 1.2, 1e-13).unwrap();
    let (mut errors, mut damaged) = (Errors::of("x'' over g"), Errors::of("without rotation"));
    for t in times(0.1, 1.1, 20) {
        let x = |t: f64| run.at(t).unwrap().q[0];
        let second = (x(t + h) - 2.0 * x(t) + x(t - h)) / (h * h);
        errors.push(second / 9.80665 + 2.0 / 3.0 * sin(body.slope));
        damaged.push(second / 9.80665 + sin(body.slope));
        assert_eq!(run.modes(t).unwrap(), [Mode::Stick]);
    }
    assert_largest!(errors, 21, @"1.51e-11");
    damaged.exceed(0.1, 21);
    assert_error!(value(&EXAMPLE, "acceleration") + 3.268_883_333_333_33, 3.11e-15);
    assert_error!(value(&EXAMPLE, "friction_up") - 3.268_883_333_333_33, 4e-15);
    assert_error!(value(&EXAMPLE, "mu_min") - 0.192_450_089_729_875, 2.5e-16);
    assert!(misdeclared(&body, &body.rolling(1.3)) < 1e-9);
}

/// Friction is the multiplier of the constraint: m x'' = -m g sin + F, I phi'' = -R F, and
/// x'' = R phi'' are three equations for three unknowns.
#[test]
fn friction_is_the_multiplier_of_the_constraint() {
    let mut errors = Errors::of("friction over the weight");
    for (slope, shape) in [(0.1, 0.4), (0.5, 0.5), (1.3, 1.0)] {
        let body = Roller { slope, shape, mu: 4.0, ..cylinder() };
        let run = body.run(Goal::Never, 1.0, 0.05, 1e-12).unwrap();
        // x'' = R phi'' = -F/(m k) in the first.
        let multiplier = sin(slope) / (1.0 + 1.0 / shape);
        errors.push(run.forces(0.03).unwrap()[0].tangential / body.gravity - multiplier);
    }
    assert_largest!(errors, 3, @"1.11e-16");
}

/// The loss is greatest where the body comes back without spin: on either side of it there is less.
#[test]
fn the_greatest_loss_is_all_of_the_rotation() {
    for shape in [0.4, 0.5, 1.0] {
        let body = Roller { shape, ..cylinder() };
        let kept = |part: f64| Roller { mu: part * body.worst(), ..body }.run_back(1e-12).unwrap()[1];
        let [less, worst, more] = [0.97, 1.0, 1.03].map(kept);
        assert!(worst < less && worst < more, "{shape}: {less} {worst} {more}");
    }
}

/// Rolling resistance on the way down: it is against the other way of rolling, and half of the
/// symmetry is gone.
#[test]
fn rolling_down_it_is_resisted_the_other_way() {
    let roller = cylinder();
    let far = Resisted { roller, resistance: 0.02 };
    let rolls = motion_within(far, 1e-12, roller.rolling(2.0), 2.0).unwrap();
    let back = rolls.event("rolling reverses").unwrap();
    let [rise, fall] = [1.0, -1.0].map(|way| roller.gravity * (sin(roller.slope) + way * 0.02 * cos(roller.slope)) / 1.5);
    assert_error!(back.t, 2.0 / rise, 0.0 eps);
    assert_error!(rolls.at(2.0).unwrap().v[0], fall * (back.t - 2.0), 1.8 eps);
}

/// After all its bounces a ball that was dropped rolls as fast as one that has rolled since then.
#[test]
fn a_dropped_ball_is_as_fast_as_one_that_rolled() {
    let (mut limits, mut speeds) = (Errors::of("end of its bounces"), Errors::of("speed in the end"));
    let (mut early, mut slid) = (Errors::of("without its first fall"), Errors::of("without its rotation"));
    for angle in [0.01, 0.2, 0.5, 1.2, 1.5] {
        let p = Parameters { angle, ..Parameters::default() };
        let ball = Bouncer::new(&p);
        let (run, limit) = (ball.run(1e-12).unwrap(), ball.rests());
        let rests = run.event("body rests").unwrap();
        // The times between the first bounces, and the geometric series from there.
        let [first, second] = [0, 1].map(|n| run.events()[n].t);
        let series = (second - first) / (1.0 - bouncer::RESTITUTION);
        limits.push(rests.t / (first + series) - 1.0);
        early.push(rests.t / series - 1.0);
        let rolled = Roller { mu: 2.0 * tan(angle), shape: 0.4, ..Roller::new(&p) };
        let [to, speed] = [2.0 * limit, run.at(2.0 * limit).unwrap().v[0]];
        let beside = rolled.run(Goal::Never, 0.0, to, 1e-12).unwrap().at(to).unwrap().v[0];
        speeds.push(speed / beside - 1.0);
        slid.push(speed / (-p.gravity * sin(angle) * to) - 1.0);
        assert_eq!(run.modes(to).unwrap(), [Mode::Stick]);
        for t in times(0.0, 0.9 * limit, 30) {
            let high = run.at(t).unwrap().q[1] / p.radius - 1.0;
            assert!((high - ball.height(t)).abs() < 1e-9);
        }
    }
    assert_largest!(limits, 5, @"7.81e-12");
    early.exceed(0.1, 5);
    assert_largest!(speeds, 5, @"8.88e-16");
    slid.exceed(0.2, 5);
}

#[test]
fn other_bodies_and_slopes_are_confirmed() {
    let bodies = ["", "--shape 0.4 --mass 10", "--shape 1", "--radius 1 --speed 0.001"];
    let slopes = ["--friction 0", "--friction 0.05", "--angle 1.5", "--angle 0.002 --gravity 1.62"];
    let runs = bodies.iter().flat_map(|body| slopes.iter().map(move |slope| format!("{body} {slope}")));
    confirmed(&EXAMPLE, runs, 16);
    confirmed(&EXAMPLE, [
        "--angle=1e-9", "--angle=1e-6", "--angle=1.5707963", "--shape=1e-6", "--speed=1e6",
        "--gravity=1e-6", "--friction=1e6", "--friction=0",
    ], 8);
    // A number that friction divides is not told where there is none.
    let told = answer(&EXAMPLE, "--friction=0").stdout;
    assert!(!told.contains("mu_min/mu") && told.contains("mu/mu_min"), "{told}");
}

#[test]
fn what_is_no_incline_is_refused() {
    refused(&EXAMPLE, [
        ("--angle 1.6", "angle = 1.6 is not allowed"),
        ("--angle=0", "level nothing brings it back"),
        ("--speed=-2", "started downward it never turns"),
        ("--friction=0 --with rolling", "less does not let it roll"),
        ("--shape 1.2", "shape = 1.2 is not allowed"),
        ("--friction=-0.1", "friction = -0.1 is not allowed"),
        ("--speed nan", "not a finite number"),
    ]);
}
