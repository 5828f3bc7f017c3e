//! A ladder under a wall that overhangs: it falls, or it is wedged, and where dry friction
//! allows both the solver says so.

use super::G;
use super::ladder::mechanism::{LENGTH, Ladder};
use core::f64::consts::{FRAC_PI_2, PI};
use kit::bisect;
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::{cos, sincos, tan};
use rotation_dynamics::planar::contact::{Mode, motion};
use rotation_dynamics::{Error, Result};
use support::{Errors, assert_largest};

/// What its contacts do at first, from rest at this angle.
fn begins(overhang: f64, mu: f64, angle: f64) -> Result<[Mode; 2]> {
    let ladder = Ladder { gravity: G, overhang, mu };
    motion(&ladder, &Dop853::new(1e-9)?, ladder.at_rest(angle), 1e-3)?.modes(0.0)
}

/// The least friction with which the ladder can be wedged. The wall's force points as far up
/// as its cone allows, tan a = (mu - tan b)/(1 + mu tan b); its torque about the foot carries
/// half of the weight, and the foot's force is then mu times as far from its normal as it may be:
///
/// ```text
/// mu (2 cot theta + tan a) = 1.
/// ```
fn least(overhang: f64, angle: f64, damage: f64) -> f64 {
    let slope = tan(overhang) * (1.0 + damage);
    let excess = |mu: f64| mu * (2.0 / tan(angle) + (mu - slope) / (1.0 + mu * slope)) - 1.0;
    bisected(|mu| excess(mu) > 0.0)
}

/// Where it becomes true, between 0.3 and 30.
fn bisected(holds: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.3, 30.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if holds(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    0.5 * (low + high)
}

const ANGLES: [(f64, f64); 5] = [(0.35, 1.4), (0.35, 1.3), (0.7, 1.0), (0.7, 1.4), (1.0, 0.7)];

/// From the friction on with which statics allow it to be wedged there are two motions; with
/// less the top lets go at once, however little is missing.
#[test]
fn two_motions_begin_where_statics_say() {
    let mut errors = Errors::of("least friction that wedges");
    let mut damaged = Errors::of("the same under a wall that overhangs a little more");
    for (overhang, angle) in ANGLES {
        let begins = |mu| begins(overhang, mu, angle);
        let refused = bisected(
            |mu| matches!(begins(mu), Err(Error::ContactsUndetermined { motions, .. }) if motions.len() == 2),
        );
        let by_hand = least(overhang, angle, 0.0);
        errors.add(refused, by_hand, by_hand);
        errors.push((begins(by_hand * (1.0 - 1e-9)) != Ok([Mode::Open, Mode::Stick])).into());
        let other = least(overhang, angle, 1e-9);
        damaged.add(refused, other, other);
    }
    assert_largest!(errors, 2 * ANGLES.len(), @"4.56e-12");
    damaged.exceed(1e-11, ANGLES.len());
}

/// Both motions are solutions. Wedged: forces that balance, within both cones, written down by
/// hand. Falling: the foot holds with less than it may, and the top moves away from the wall.
#[test]
fn both_motions_obey_all_laws() {
    for (overhang, angle) in ANGLES {
        let mu = 1.1 * least(overhang, angle, 0.0);
        let error = begins(overhang, mu, angle).unwrap_err();
        let Error::ContactsUndetermined { motions, .. } = &error else { panic!("{error}") };
        assert_eq!(motions[..], ["wall sticks, foot sticks", "wall opens, foot sticks"]);
        let (s, c) = sincos(angle);
        // Wedged, in weights: the wall's force along the edge of its cone that points up.
        let slope = tan(overhang);
        let up = (mu - slope) / (1.0 + mu * slope);
        let across = 0.5 * s / (c + s * up);
        let (wall, foot) = ([across, across * up], [-across, 1.0 - across * up]);
        let torque = -s * wall[1] - c * wall[0] + 0.5 * s;
        assert!(torque.abs() < 1e-15, "{torque:e}");
        let (sin, cos) = sincos(overhang);
        let (normal, along) = (wall[0] * cos - wall[1] * sin, wall[0] * sin + wall[1] * cos);
        assert!(normal > 0.0 && along <= mu * normal * (1.0 + 1e-14));
        assert!(foot[1] > 0.0 && foot[0].abs() < mu * foot[1]);
        // Falling about the foot from rest: theta'' = 3 g sin(theta)/2L.
        let pull = 0.75 * s;
        let (right, below) = (-pull * c, 1.0 - pull * s);
        assert!(right.abs() < mu * below);
        // The top goes at right angles to the ladder, down and away from the wall.
        let away = -(c * cos - s * sin);
        assert!(away > 0.0 && overhang + angle > core::f64::consts::FRAC_PI_2);
    }
}

/// Errors of the time and of the rate of the landing of a ladder that is not wedged, against a rod
/// that swings about its foot and is longer by the part `damage`. By the energy
/// L theta'^2 = 3 g cos(theta_0).
fn swings(damage: f64) -> Errors {
    let mut errors = Errors::of("landing of a ladder under an overhang");
    let overhang = 0.35;
    for angle in [1.4, 1.45, 1.5] {
        let (length, mu) = (LENGTH * (1.0 + damage), 0.99 * least(overhang, angle, 0.0));
        let rod = Suspension {
            moment: length * length / 3.0,
            mass: 1.0,
            gravity: G,
            lever: 0.5 * length,
        };
        // Counted from the hanging position.
        let falls = Pendulum::new(rod, PI - angle, 0.0).unwrap();
        let is_above = |t: f64| falls.at(t).unwrap().theta > FRAC_PI_2;
        let [_, lands] = bisect([0.0, 1.0], 0.0, is_above);
        let rate = (3.0 * G * cos(angle) / length).sqrt();
        let ladder = Ladder { gravity: G, overhang, mu };
        let (method, start) = (Dop853::new(1e-15).unwrap(), ladder.at_rest(angle));
        let found = motion(&ladder, &method, start, 1.0).unwrap();
        let end = found.event("lands").unwrap();
        errors.add(end.t, lands, lands);
        errors.add(end.before.v[2], rate, rate);
    }
    errors
}

/// With too little friction to be wedged it falls, and its foot holds.
#[test]
fn with_less_friction_it_swings_about_its_foot() {
    assert_largest!(swings(0.0), 6, @"2.87e-15");
    assert!(swings(1e-9).largest() > 1e-10);
}

/// Steeper than at right angles to the wall the top is pressed to it: one motion, any friction.
#[test]
fn a_steep_ladder_has_one_motion() {
    for mu in [0.1, 1.0, 3.0, 8.0] {
        for angle in [0.3, 0.8, 1.2] {
            let begins = begins(0.35, mu, angle);
            assert!(begins.is_ok(), "{mu} {angle}: {begins:?}");
        }
    }
}
