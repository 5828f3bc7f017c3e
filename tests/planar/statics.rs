//! Contacts at rest: forces that are not determined, strings, joints, given forces.

use super::G;
use models::by_closures::Bodies;
use rotation_dynamics::Error;
use rotation_dynamics::math::{atan, cos, sin, sincos};
use rotation_dynamics::planar::contact::{
    Contact, Mechanism, MechanismState, Mode, Surface, motion_within,
};
use support::{EPS, Errors, assert_error, assert_largest};

/// A box, 2 by 1 m and 5 kg, on two feet on a slope, by axes along the slope and off it.
struct Box {
    slope: f64,
    mu: f64,
}

impl Mechanism<3, 2> for Box {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[5.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0, 0.0, 25.0 / 12.0]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [5.0 * G * sin(self.slope), -5.0 * G * cos(self.slope), 0.0]
    }
    fn contacts(&self, body: &MechanismState<3>) -> [Contact<3>; 2] {
        let (s, c) = sincos(body.q[2]);
        let foot = |name, x: f64| {
            let arm = [x * c + 0.5 * s, x * s - 0.5 * c];
            Contact::corner(name, body, arm, Surface::FLOOR).friction(self.mu)
        };
        [foot("upper", -1.0), foot("lower", 1.0)]
    }
}

/// What a box on two feet does whose friction is off by the part `damage`: errors in parts
/// of its weight, of g, and m/s.
struct Stands {
    pushes: Errors,
    friction: Errors,
    /// Of the upper foot, in the middle of what both feet allow.
    share: Errors,
    speed: Errors,
    slides: Errors,
}

fn stands(damage: f64) -> Stands {
    let mut found = Stands {
        pushes: Errors::in_units_of(EPS, "both pushes"),
        friction: Errors::in_units_of(EPS, "both frictions"),
        share: Errors::in_units_of(EPS, "friction of the upper foot"),
        speed: Errors::of("speed of a box that holds"),
        slides: Errors::in_units_of(EPS, "speed of a box that slides"),
    };
    for mu in [0.1, 0.5, 1.0] {
        for part in [0.0, 0.5, 0.999, 1.001] {
            let slope = part * atan(mu);
            let body = Box { slope, mu: mu * (1.0 + damage) };
            let start = MechanismState::rest([0.0, 0.5, 0.0]);
            let motion = motion_within(&body, 1e-12, start, 1.0).unwrap();
            let [upper, lower] = motion.forces(1.0).unwrap();
            let end = motion.at(1.0).unwrap();
            let weight = 5.0 * G;
            let pushes = upper.normal + lower.normal;
            found.pushes.add(pushes, weight * cos(slope), weight);
            assert!(motion.events().is_empty());
            let along = upper.tangential + lower.tangential;
            if part < 1.0 {
                found.friction.add(along, -weight * sin(slope), weight);
                for foot in [upper, lower] {
                    assert!(foot.tangential.abs() <= body.mu * foot.normal);
                }
                let [high, low] = [upper, lower].map(|foot| body.mu * foot.normal);
                let middle = 0.5 * ((-high).max(along - low) + high.min(along + low));
                found.share.add(upper.tangential, middle, weight);
                for v in end.v {
                    found.speed.push(v);
                }
            } else {
                found.friction.add(along, -mu * weight * cos(slope), weight);
                let a = G * (sin(slope) - mu * cos(slope));
                found.slides.add(end.v[0], a, G);
            }
        }
    }
    found
}

/// It stays up to the tangent of the slope though the shares of the feet are not determined,
/// slides beyond, and tips where the slope is steeper than 2.
#[test]
fn a_box_on_two_feet() {
    let found = stands(0.0);
    assert_largest!(found.pushes, 12, @"1.31");
    assert_largest!(found.friction, 12, @"1.31");
    assert_largest!(found.share, 9, @"0.653");
    assert_largest!(found.speed, 27, @"1.09e-15");
    assert_largest!(found.slides, 3, @"1.21");
    // The damaged twin slides with another friction.
    let damaged = stands(1e-9);
    assert!(damaged.friction.largest() > 1e4);
    assert!(damaged.share.largest() < 1e3);
    damaged.slides.exceed(1e4, 3);
    // What does not depend on it, does not.
    assert_largest!(damaged.pushes, 12, @"1.31");
    assert_largest!(damaged.speed, 27, @"1.09e-15");
    let modes = |slope: f64| {
        let steep = Box { slope, mu: 3.0 };
        let motion =
            motion_within(&steep, 1e-9, MechanismState::rest([0.0, 0.5, 0.0]), 0.3).unwrap();
        motion.modes(0.1).unwrap()
    };
    assert_eq!(modes(atan(2.1)), [Mode::Open, Mode::Stick]);
    assert_eq!(modes(atan(1.9)), [Mode::Stick, Mode::Stick]);
}

/// A pile: `heavy` on `light` on the floor.
fn pile_of(light: f64, heavy: f64) -> impl Mechanism<2, 2> {
    Bodies([light, heavy], [-light * G, -heavy * G], |pile| {
        let [low, high] = pile.q;
        [
            Contact::new("floor", low, [1.0, 0.0], 0.0),
            Contact::new("between", high - low, [-1.0, 1.0], 0.0),
        ]
    })
}

/// Errors of the forces in a pile, of the largest of them, if the upper mass is off by the
/// part `damage`; and its speed after 10 s, in parts of 10 s g.
fn pile(damage: f64) -> (Errors, Errors) {
    let mut forces = Errors::in_units_of(EPS, "forces in a pile");
    let mut speeds = Errors::in_units_of(EPS, "speed of a pile at rest");
    for exponent in -12..=12 {
        let heavy = rotation_dynamics::math::pow(10.0, f64::from(exponent));
        let pile = pile_of(1.0, heavy * (1.0 + damage));
        let motion = motion_within(&pile, 1e-12, MechanismState::rest([0.0; 2]), 10.0).unwrap();
        let [floor, between] = motion.forces(10.0).unwrap();
        let weight = (1.0 + heavy) * G;
        forces.add(floor.normal, weight, weight);
        // To round-off of the largest force, as linear equations give it.
        forces.add(between.normal, heavy * G, weight);
        // Accelerations of 0 are 0 to round-off of g.
        for v in motion.at(10.0).unwrap().v {
            speeds.push_at(v / (10.0 * G), exponent);
        }
    }
    (forces, speeds)
}

#[test]
fn a_pile_rests_at_any_ratio_of_masses() {
    let (forces, speeds) = pile(0.0);
    assert_largest!(forces, 50, @"3.34");
    assert_largest!(speeds, 50, @"7.25e-17");
    let (forces, speeds) = pile(1e-12);
    assert!(forces.largest() > 1e3 && speeds.largest() <= 10.0);
}

/// A disc that unwinds from a string (exercise 16.4): height below the hand, and angle.
fn unwinding(glued: bool) -> impl Mechanism<2, 1> {
    Bodies([3.0, 0.5 * 3.0 * 0.04], [3.0 * G, 0.0], move |disc| {
        let [fallen, angle] = disc.q;
        let string = if glued { Contact::joint } else { Contact::new };
        [string("string", 0.2 * angle - fallen, [-1.0, 0.2], 0.0)]
    })
}

/// Taut it falls with 2g/3; spun up it falls freely until the string is taut again; a joint
/// would hold it back.
#[test]
fn a_disc_unwinds_from_its_string() {
    let disc = unwinding(false);
    let motion = motion_within(&disc, 1e-12, MechanismState::rest([0.0; 2]), 0.5).unwrap();
    let end = motion.at(0.5).unwrap();
    assert_error!(end.v[0], G / 3.0, 1.2 eps);
    assert_error!(end.v[1], 16.3444166666667, 17.6 eps);
    assert_error!(motion.forces(0.2).unwrap()[0].normal, G, 0.0 eps);
    // Spinning too fast the string is slack: free fall until g t = 2 R omega, then a jerk.
    let spun = MechanismState { q: [0.0; 2], v: [0.0, 10.0] };
    let motion = motion_within(&disc, 1e-12, spun, 0.5).unwrap();
    let jerk = motion.event("string touches").unwrap();
    assert_error!(jerk.t, 4.0 / G, 1.2 eps);
    assert_error!(jerk.after.v[0], 10.0 / 3.0, 0.0 eps);
    // The damaged twin of a string: it pushes, and has no free fall.
    let error = motion_within(unwinding(true), 1e-9, spun, 0.5).unwrap_err();
    assert!(matches!(error, Error::CannotHold { name: "string", rate: Some(_), .. }), "{error}");
}

/// Two discs pressed together by this force (exercise 15.1): inertias 0.03 and 0.05 kg m^2; and a
/// torque on the first one (N m).
fn discs(force: f64, torque: f64) -> impl Mechanism<2, 1> {
    // A torque of 0.5 N m by 10 N: a mean radius of 0.1 m, mu = 1/2.
    Bodies([0.03, 0.05], [torque, 0.0], move |_| {
        [Contact::pressed("faces", force).tangent([0.1, -0.1], 0.0).friction(0.5)]
    })
}

#[test]
fn pressed_discs_end_at_one_rate() {
    let run = |damage: f64| {
        let start = MechanismState { q: [0.0; 2], v: [40.0, -10.0] };
        let discs = discs(10.0 * (1.0 + damage), 0.0);
        let motion = motion_within(discs, 1e-12, start, 3.0).unwrap();
        assert_eq!(motion.events().len(), 1);
        let sticks = motion.event("faces sticks").unwrap().t;
        let [force] = motion.forces(1.0).unwrap();
        (sticks, motion.at(3.0).unwrap().v, force.tangential)
    };
    let (sticks, rates, friction) = run(0.0);
    assert_error!(sticks, 1.875, 0.0 eps);
    assert_error!(rates[0], 8.75, 1.8 eps);
    assert_error!(rates[1], 8.75, 1.8 eps);
    assert_error!(friction, -5.0, 0.0 eps);
    // The damaged twin is pressed harder: it ends at the same rate, but sooner.
    let (sooner, same, harder) = run(1e-12);
    assert!((sooner / 1.875 - 1.0).abs() > 1e3 * EPS && (harder / 5.0 + 1.0).abs() > 1e3 * EPS);
    assert!((same[0] / 8.75 - 1.0).abs() <= 10.0 * EPS);
}

/// Together they are turned by up to 0.8 N m, of which friction hands on 5/8.
#[test]
fn pressed_discs_hold_up_to_their_friction() {
    for (torque, holds) in [(0.799, true), (-0.799, true), (0.801, false), (-0.801, false)] {
        let discs = discs(10.0, torque);
        let motion = motion_within(discs, 1e-12, MechanismState::rest([0.0; 2]), 1.0).unwrap();
        assert_eq!(motion.modes(1.0).unwrap() == [Mode::Stick], holds, "{torque}");
        assert!(motion.events().is_empty());
        let [first, second] = motion.at(1.0).unwrap().v;
        assert_eq!((first - second).abs() < 1e-12, holds, "{first} {second}");
    }
}
