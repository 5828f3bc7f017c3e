//! Exercise 16.3, the cylinder in the corner. That simulations confirm the formulas is part of
//! the report: a claim or a limit that differs from its oracle is an error.

use crate::answers::cell;
use pages::ch16_ex3_corner::physics::*;
use pages::ch16_ex3_corner::*;
use rotation_dynamics::Error;
use rotation_dynamics::integrators::{Dop853, Integrator, Rk4, ode, size_or};
use rotation_dynamics::planar::contact::{Mode, MechanismState, misdeclared, motion};
use support::{Errors, assert_largest};

/// The spin of the page in units of sqrt(g/R).
const SPIN: f64 = 6.06;

/// Forces and times for surfaces of all kinds: both routes stand in the table of the page.
#[test]
fn other_surfaces_brake_as_predicted() {
    let (mut errors, mut damaged) = (Errors::of("braking, relative"), Errors::of("alike, upright"));
    for mu in [[0.1, 0.7], [0.9, 0.0], [2.0, 0.4], [0.3, 3.0]] {
        for lean in [-0.6, -0.2, 0.0, 0.2] {
            let cylinder = Cylinder::new(mu, lean);
            let stop = SPIN / cylinder.braking();
            let ride = set_down(cylinder, SPIN, 2.0 * stop, 1e-13).unwrap();
            errors.push_at(ride.event("floor sticks").unwrap().t / stop - 1.0, (mu, lean));
            damaged.push(Cylinder::alike(mu[0]).braking() / cylinder.braking() - 1.0);
            // It stays where it is, and the wall holds nothing any more.
            let end = ride.at(2.0 * stop).unwrap();
            assert!(end.q[0].abs() < 1e-12 && (end.q[1] - 1.0).abs() < 1e-12, "{end:?}");
        }
    }
    assert_largest!(errors, 16, @"4.44e-16");
    damaged.exceed(0.02, 16);
    // What the scene says about its contacts is true, also if friction fades.
    let scene = Cylinder { mu: [0.2, 0.4], fading: 0.3, lean: 0.25 };
    assert!(misdeclared(&scene, &MechanismState { q: [0.2, 1.3, -0.4], v: [0.7, -0.3, 0.9] }) < 1e-9);
    // Where the wall leans by more than arctan(1/mu) it climbs.
    let climbs = Cylinder::new([0.9, 1.5], 0.7);
    assert!(set_down(climbs, SPIN, 0.5, 1e-13).unwrap().at(0.5).unwrap().q[1] > 1.01);
    // A rough floor jams it under a wall that overhangs far: no forces balance.
    let jams = Cylinder::new([2.0, 0.4], -1.2);
    assert!(jams.pressed()[0] < 0.0 && set_down(jams, SPIN, 1.0, 1e-13).is_err());
}

/// On a floor without friction nothing presses it to the wall, and it spins on.
#[test]
fn a_smooth_floor_lets_it_spin() {
    let ride = set_down(Cylinder::new([0.0, 0.7], 0.0), SPIN, 1e4, 1e-13).unwrap();
    assert!(ride.events().is_empty());
    assert_eq!(ride.at(1e4).unwrap().v[2], SPIN);
}

/// Dropped from a height h, it is braked by the impact as by the forces in sqrt(2 h/g).
#[test]
fn a_drop_brakes_as_much_as_its_fall_takes() {
    let (mut errors, mut damaged) = (Errors::of("time to the stop"), Errors::of("set down"));
    for (mu, h) in [(0.25, 0.01), (0.25, 0.5), (0.8, 0.1), (0.97, 0.02)] {
        let cylinder = Cylinder::alike(mu);
        let (stop, fall) = (SPIN / cylinder.braking(), f64::sqrt(2.0 * h));
        let start = MechanismState { q: [0.0, 1.0 + h, 0.0], v: [0.0, 0.0, SPIN] };
        let ride = motion(cylinder, &Dop853::new(1e-14).unwrap(), start, 2.0 * stop + fall).unwrap();
        let after = ride.event("floor sticks").unwrap().t - fall;
        errors.push_at(after - (stop - fall), (mu, h));
        damaged.push(after - stop);
        assert_eq!(ride.modes(2.0 * stop).unwrap(), [Mode::Stick; 2]);
    }
    assert_largest!(errors, 4, @"4.44e-16");
    damaged.exceed(0.1, 4);
    // Where the coefficient exceeds one, it may as well jam in the impact.
    let start = MechanismState { q: [0.0, 1.02, 0.0], v: [0.0, 0.0, SPIN] };
    let jams = motion(Cylinder::alike(1.03), &Dop853::new(1e-14).unwrap(), start, 1.0);
    assert!(matches!(jams, Err(Error::ContactsUndetermined { ref motions, .. }) if motions.len() == 2), "{jams:?}");
}

/// By the sign of the slip in Euler steps it never stops: what is left is half of what a step
/// takes, or more. In steps of Runge and Kutta it goes on turning, one way.
#[test]
fn a_law_of_signs_never_stops() {
    for steps in ["100", "1000", "10000"] {
        let told = |column| cell(&EXAMPLE, "", ["table signs", steps, column]);
        let unit = told("spin left / Omega") * steps.parse::<f64>().unwrap();
        assert!((0.5..=1.0).contains(&unit), "{unit}");
        assert!(told("steps that change its sign") > 0.99);
    }
    let brake = ode(|_, [spin]: &[f64; 1]| [-spin.signum()]).scaled(size_or([1.0; 1]));
    let creeps = |end| Rk4::new(100 * end as u64).unwrap().advance(&brake, 0.0, &[1.0037], end).unwrap().0[0];
    let (soon, late) = (creeps(2.0), creeps(200.0));
    assert!(soon.abs() > 1e-4 && (late - soon).abs() < 1e-12, "{soon} {late}");
    // The adaptive method cannot get past the stop, not in fifty times the work that is enough below.
    let patient = Dop853::new(1e-9).unwrap().with_step_limit(50_000).unwrap();
    let gives_up = patient.solve(&brake, 0.0, &[1.0037], 2.0, &[]);
    assert!(gives_up.is_err(), "{gives_up:?}");
    // The contact solver stops, and needs a few hundred evaluations.
    let ride = set_down(Cylinder::alike(0.25), SPIN, 30.0, 1e-13).unwrap();
    assert!(ride.at(30.0).unwrap().v[2].abs() < 1e-12 && ride.work().derivatives < 1000);
}

/// Rolling needs no friction; the law of signs reports all of it, to and fro.
#[test]
fn friction_of_signs_flickers_where_there_is_none() {
    let (mu, end) = (0.25, 2.0 * SPIN / 0.75);
    let ride = set_down(Cylinder::alike(mu), -SPIN, end, 1e-13).unwrap();
    assert_eq!(ride.forces(end).unwrap()[0].tangential, 0.0);
    let all = by_sign(mu, -SPIN, true, end, 1000);
    let force = |pair: &[[f64; 2]]| (pair[1][0] - pair[0][0]) / (end / 1000.0);
    let rolling: Vec<f64> = all.windows(2).skip(510).map(force).collect();
    assert!(rolling.len() == 489 && rolling.iter().all(|f| (f.abs() - mu).abs() < 1e-9));
    let turns = rolling.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
    assert!(turns > 300, "{turns}");
}
