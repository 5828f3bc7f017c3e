//! Exercise 16.6, the ladder.

use crate::answers::{answer, column};
use core::f64::consts::FRAC_PI_2;
use kit::{But, parse, times};
use pages::ch16_ex6_ladder::{EXAMPLE, Ladder as Scene, Parameters, Slide};
use models::ladder::Ladder;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::{cos, exp, sin, tan};
use rotation_dynamics::planar::contact::{Mode, kept_within, motion, motion_within};
use support::{Errors, assert_largest};

const G: f64 = 9.80665;

const ANGLES: [f64; 7] = [1e-6, 1e-3, 0.1, 0.25, 0.7, 1.2, 1.5];

fn uniform() -> Scene {
    Scene::smooth(&Parameters::default())
}

/// The damaged twin: a moment of inertia off by 1e-9.
fn damaged() -> Scene {
    uniform().but(|ladder| ladder.inertia += 1e-9)
}

fn exact(theta0: f64) -> Ladder {
    Ladder::new(3.0, G, theta0).unwrap()
}

fn simulated(scene: Scene, tolerance: f64, theta0: f64) -> Slide {
    let method = Dop853::new(tolerance).unwrap();
    motion(scene, &method, scene.at_rest(theta0), 100.0).unwrap()
}

/// Relative errors of the simulation against the closed form, at the two events and at 41
/// times of the motion, over the size of each coordinate, forces over the weight.
fn disagreement(errors: &mut Errors, ladder: &Ladder, run: &Slide) {
    let rate = (1.5 * G / 3.0_f64).sqrt();
    let lets_go = run.event("wall lets go").unwrap();
    errors.add(lets_go.t, ladder.release_time(), ladder.release_time());
    errors.add(run.end_time(), ladder.landing_time(), ladder.landing_time());
    let end = ladder.landing_time().min(run.end_time());
    for t in times(0.0, end, 40) {
        let (state, s) = (run.at(t).unwrap(), ladder.at(t).unwrap());
        let [wall, floor] = run.forces(t).unwrap();
        errors.add(state.q[2], s.theta, s.theta);
        errors.add(state.v[2], s.omega, rate * s.theta);
        errors.add(state.q[0], s.x_cm, s.x_cm);
        errors.add(state.v[0], s.vx_cm, rate * s.x_cm);
        errors.add(wall.normal / G, s.wall_force, 1.0);
        errors.add(floor.normal / G, s.floor_force, 1.0);
    }
}

const COMPARED: usize = 2 + 41 * 6;

#[test]
fn the_simulation_agrees_with_the_closed_form() {
    let mut errors = Errors::of("the motion, relative");
    for theta0 in ANGLES {
        disagreement(&mut errors, &exact(theta0), &simulated(uniform(), 1e-14, theta0));
    }
    // At 1e-6 rad, where it takes longest.
    assert_largest!(errors, ANGLES.len() * COMPARED, @"2.52e-14");
    let mut twin = Errors::of("a damaged twin");
    disagreement(&mut twin, &exact(0.25), &simulated(damaged(), 1e-14, 0.25));
    assert!(twin.largest() > 1e-10);
}

/// The moment of the release is located to the accuracy of the run, not to that of
/// the interpolant: its error falls with the tolerance down to round-off.
#[test]
fn the_release_is_located() {
    let ladder = exact(0.25);
    let error = |scene: Scene, tolerance: f64| {
        let run = simulated(scene, tolerance, 0.25);
        let release = run.event("wall lets go").unwrap();
        (release.t / ladder.release_time() - 1.0).abs()
    };
    let mut errors = Errors::of("time of the release, in tolerances");
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14] {
        errors.push_at(error(uniform(), tolerance) / tolerance, tolerance);
    }
    assert_largest!(errors, 6, @"0.0245");
    assert!(error(damaged(), 1e-12) > 1e-10);
}

/// What a solver does that keeps the wall: the wall pulls, the ladder lands early and
/// too fast, and no tolerance helps.
#[test]
fn a_kept_wall_pulls() {
    let mut errors = Errors::of("pull, time and excess of rate, relative");
    for theta0 in ANGLES {
        let ladder = exact(theta0);
        let start = uniform().at_rest(theta0);
        let kept = kept_within(uniform(), 1e-9, start, 100.0).unwrap();
        assert_eq!(kept.events().len(), 1);
        let flat = kept.event("lands").unwrap();
        errors.add(flat.force[0].normal / G, -1.5 * cos(theta0), cos(theta0));
        errors.add(flat.t, ladder.held_landing_time(), flat.t);
        // omega is too large by 1/sqrt(1 - cos^2 theta0/9): 6 % from upright, 0 from flat.
        let excess = flat.before.v[2] / ladder.landing().omega;
        let square = cos(theta0) * cos(theta0);
        errors.add(excess * (1.0 - square / 9.0).sqrt(), 1.0, 1.0);
        assert!(flat.t < ladder.landing_time());
    }
    assert_largest!(errors, 3 * ANGLES.len(), @"6.95e-12");
}

/// Two thirds, wherever the mass sits, as long as the centre is in the middle.
#[test]
fn two_thirds_do_not_depend_on_the_mass() {
    let ratios = column(&EXAMPLE, "table mass", "height ratio");
    assert_eq!(ratios.len(), 3);
    for ratio in ratios {
        assert!((ratio - 2.0 / 3.0).abs() <= 1e-7, "{ratio}");
    }
    let times = column(&EXAMPLE, "table mass", "t_release");
    assert!(times.windows(2).all(|t| t[1] > t[0] + 0.05), "{times:?}");
}

/// With friction everything is later and lower, and at mu = tan(theta0/2) the ladder
/// stays: the wall's and the floor's limits balance exactly there.
#[test]
fn friction_holds_the_ladder_at_the_tangent_of_half_the_angle() {
    let releases = column(&EXAMPLE, "table friction", "t_release/s");
    let ratios = column(&EXAMPLE, "table friction", "height ratio");
    assert_eq!((releases.len(), ratios.len()), (5, 5));
    assert!(releases.windows(2).all(|t| t[1] > t[0]));
    assert!(ratios.windows(2).all(|r| r[1] < r[0]));
    // Without friction it is the smooth ladder.
    assert!((releases[0] - exact(0.25).release_time()).abs() <= 1e-7);
    // A little above it stays for good, a little below it goes.
    let rough = |part: f64| uniform().but(|ladder| ladder.mu = part * tan(0.125));
    let start = uniform().at_rest(0.25);
    let held = motion_within(rough(1.001), 1e-9, start, 100.0).unwrap();
    assert_eq!(held.modes(100.0), Ok([Mode::Stick; 2]));
    assert!(held.events().is_empty());
    let goes = motion_within(rough(0.999), 1e-9, start, 1e3).unwrap();
    assert!(goes.event("lands").is_ok());
}

/// Rubbing at both ends, the ladder obeys forces that were eliminated by hand: the angular
/// acceleration while both ends slide.
#[test]
fn friction_agrees_with_an_elimination_by_hand() {
    let mu = 0.9 * tan(0.125);
    let rough = uniform().but(|ladder| ladder.mu = mu);
    let run = motion_within(rough, 1e-12, rough.at_rest(0.25), 10.0).unwrap();
    let release = run.event("wall lets go").unwrap().t;
    let mut errors = Errors::of("forces over the weight");
    for i in 0..=50 {
        let t = release * f64::from(i) / 50.0;
        let (state, forces) = (run.at(t).unwrap(), run.forces(t).unwrap());
        let (theta, omega) = (state.q[2], state.v[2]);
        let (s, c, half) = (sin(theta), cos(theta), 1.5);
        // x'' = push + across alpha = W - mu F, y'' + g = lift - down alpha = F + mu W.
        let (push, across) = (-half * s * omega * omega, half * c);
        let (lift, down) = (G - half * c * omega * omega, half * s);
        let wall = |push: f64, lift: f64| (push + mu * lift) / (1.0 + mu * mu);
        let floor = |push: f64, lift: f64| (lift - mu * push) / (1.0 + mu * mu);
        // (l/6) alpha = (s - mu c) F - (c + mu s) W.
        let turn = |w: f64, f: f64| (s - mu * c) * f - (c + mu * s) * w;
        let rest = turn(wall(push, lift), floor(push, lift));
        let slope = turn(wall(across, -down), floor(across, -down));
        let alpha = rest / (0.5 - slope);
        let by_hand = [
            wall(push + across * alpha, lift - down * alpha),
            floor(push + across * alpha, lift - down * alpha),
        ];
        for (force, by_hand) in forces.iter().zip(by_hand) {
            errors.add(force.normal, by_hand, G);
            errors.add(force.tangential, -mu * by_hand, G);
        }
    }
    assert_largest!(errors, 51 * 4, @"3.62e-16");
}

/// Nor does the length matter: round-off of the opening gap once made these meet the wall again.
#[test]
fn every_length_has_a_report() {
    let lengths = [1.11, 4.37, 4.44, 5.03].map(|length| format!("--length {length}"));
    let angles = [0.015, 0.543].map(|angle| format!("--angle {angle}"));
    for flag in lengths.iter().chain(&angles) {
        let told = answer(&EXAMPLE, flag);
        assert_eq!((told.code, told.stderr.as_str()), (0, ""), "{flag}");
    }
}

/// From a picoradian off the wall to a nanoradian above the floor there is a report, and what its
/// card says of friction is what a simulation measures, wherever one can tell.
#[test]
fn every_angle_has_a_card() {
    let mut predicted = Errors::of("cost of friction, as predicted, over the measured one");
    let mut linear = Errors::of("the same nearly flat, without the square of the friction");
    let mut unmeasured = Vec::new();
    let ten_to = |power: f64| exp(core::f64::consts::LN_10 * power);
    let upright = (0..20).map(|i| ten_to(-12.0 + 0.6 * f64::from(i)));
    let flat = (0..20).map(|i| FRAC_PI_2 - ten_to(-9.0 + 0.48 * f64::from(i)));
    for angle in upright.chain(flat).chain([1e-139, 1.56, 1.569, 1.5706, 1.5702]) {
        let told = answer(&EXAMPLE, &format!("--angle {angle:e}"));
        assert_eq!(told.code, 0, "{angle:e}: {}", told.stderr);
        let card = parse(&told.stdout).unwrap();
        let friction = &card.table("effects").expect("the card").rows()[0];
        let [cost, measured] = [3, 4].map(|i| friction[i].split(' ').next().unwrap().parse());
        let cost: f64 = cost.unwrap();
        let Ok(measured): Result<f64, _> = measured else {
            unmeasured.push(angle);
            continue;
        };
        predicted.push_at(cost / measured - 1.0, angle);
        if angle > 1.55 {
            let square = tan(0.5 * angle) * tan(0.5 * angle) / 400.0;
            linear.push_at((cost - square) / measured - 1.0, angle);
        }
    }
    // Both are printed to two digits.
    assert_largest!(predicted, 38, @"0.0800");
    // The damaged twin, which the card refuses where it is off by more than a half.
    linear.exceed(0.5, 20);
    assert!(unmeasured.iter().all(|angle| *angle < 1e-9), "{unmeasured:?}");
}
