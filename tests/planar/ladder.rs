//! The ladder of exercise 16.6 with the contact solver, against the closed form and against
//! forces eliminated by hand.

#[path = "mechanism.rs"]
pub mod mechanism;

use super::G;
use super::drift::adrift;
use mechanism::{LENGTH, Ladder};
use models::ladder::Ladder as Exact;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::{cos, sin, sincos, tan};
use rotation_dynamics::planar::Run;
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, Surface, kept_within, misdeclared,
    motion_within,
};
use support::{EPS, Errors, assert_error, assert_largest, relative};

fn rubs(mu: f64) -> Ladder {
    Ladder { gravity: G, overhang: 0.0, mu }
}

fn slide(ladder: Ladder, angle: f64) -> ContactMotion<Ladder, 3, 2> {
    motion_within(ladder, 1e-12, ladder.at_rest(angle), 100.0).unwrap()
}

/// Errors of a smooth ladder, at both events and between, against the closed form for a
/// ladder that is longer by the part `damage`.
fn smooth(damage: f64) -> Errors {
    let mut errors = Errors::of("smooth ladder");
    for angle in [1e-8, 1e-6, 1e-3, 0.1, 0.25, 0.7, 1.2, 1.5] {
        let exact = Exact::new(LENGTH * (1.0 + damage), G, angle).unwrap();
        let motion = slide(rubs(0.0), angle);
        let names: Vec<_> = motion.events().iter().map(|e| e.name.as_str()).collect();
        assert_eq!(names, ["wall lets go", "lands"]);
        let (release, landing) = (exact.release_time(), exact.landing_time());
        errors.add(motion.events()[0].t, release, release);
        errors.add(motion.end_time(), landing, landing);
        let rate = (1.5 * G / LENGTH).sqrt();
        let end = landing.min(motion.end_time());
        for i in 0..=40 {
            let t = end * (f64::from(i) / 40.0);
            let (got, want) = (motion.at(t).unwrap(), exact.at(t).unwrap());
            let [wall, floor] = motion.forces(t).unwrap();
            for (got, want, size) in [
                (got.q[2], want.theta, want.theta),
                (got.v[2], want.omega, rate * want.theta),
                (got.q[0], want.x_cm, want.x_cm),
                (got.v[0], want.vx_cm, rate * want.x_cm),
                (wall.normal / G, want.wall_force, 1.0),
                (floor.normal / G, want.floor_force, 1.0),
            ] {
                errors.add(got, want, size);
            }
        }
    }
    errors
}

/// Smooth: the closed form, at both events and between, from every angle.
#[test]
fn the_smooth_ladder_is_the_exact_one() {
    assert_largest!(smooth(0.0), 8 * (41 * 6 + 2), @"8.02e-14");
    assert!(smooth(1e-12).largest() > 1e-12);
}

/// When the wall lets go the gap begins with the third power of the time, and its sign is round-off for
/// a while: no ladder meets the wall again for that.
#[test]
fn no_ladder_meets_the_wall_again() {
    let mut ran = 0;
    for n in 1..=500 {
        let angle = 0.003 * f64::from(n);
        let motion = slide(rubs(0.0), angle);
        let names: Vec<_> = motion.events().iter().map(|e| e.name.as_str()).collect();
        assert_eq!(names, ["wall lets go", "lands"], "{angle}");
        ran += 1;
    }
    assert_eq!(ran, 500);
}

/// Errors of the rubbing ladder against an elimination by hand, if its friction is off by
/// the part `damage`.
fn rubbing(damage: f64) -> Errors {
    let mut errors = Errors::of("rubbing ladder");
    for (part, ratio, release, floor) in [
        (0.1, 0.6590317, 0.9151741, 1.2145145),
        (0.3, 0.6426844, 1.0106738, 1.3037824),
        (0.6, 0.6150703, 1.2330002, 1.5156875),
        (0.9, 0.5829537, 1.8197871, 2.0905185),
    ] {
        let ladder = rubs(part * tan(0.125) * (1.0 + damage));
        let motion = slide(ladder, 0.25);
        let lets_go = motion.event("wall lets go").unwrap();
        errors.push_at(cos(lets_go.before.q[2]) / cos(0.25) - ratio, part);
        errors.push_at(lets_go.t - release, part);
        errors.push_at(motion.event("lands").unwrap().t - floor, part);
    }
    errors
}

/// Rubbing: the numbers of an elimination by hand, to their seven decimals.
#[test]
fn the_rubbing_ladder_is_that_by_hand() {
    assert_largest!(rubbing(0.0), 12, @"5.00e-8");
    assert!(rubbing(1e-5).largest() > 1e-6);
}

/// The usual mistake is the damaged twin of the ladder: later, and with a wall that pulls.
#[test]
fn a_kept_wall_pulls() {
    let ladder = rubs(0.0);
    let exact = Exact::new(LENGTH, G, 0.25).unwrap();
    let kept = kept_within(&ladder, 1e-9, ladder.at_rest(0.25), 100.0).unwrap();
    assert_eq!(kept.events().len(), 1);
    let flat = kept.event("lands").unwrap();
    assert_error!(flat.t, exact.held_landing_time(), 1.7e-13);
    assert_error!(flat.force[0].normal / G, -1.5 * cos(0.25), 4.6e-12);
    // The bound of the ladder that is let go.
    let landing = exact.landing_time();
    assert!(relative(flat.t, landing, landing) > 1e-3);
}

/// What is declared of the contacts agrees with differences; a wrong sign is seen.
#[test]
fn rows_are_those_of_the_gaps() {
    let state = MechanismState { q: [0.7, 1.1, 0.6], v: [0.5, -1.3, 0.9] };
    let ladder = rubs(0.1);
    assert_error!(misdeclared(&ladder, &state), 1.7e-13);
    /// The damaged twin: an angle counted the other way round.
    struct Reversed;
    impl Mechanism<3, 2> for Reversed {
        fn mass(&self, q: &[f64; 3]) -> [[f64; 3]; 3] {
            rubs(0.1).mass(q)
        }
        fn force(&self, state: &MechanismState<3>) -> [f64; 3] {
            rubs(0.1).force(state)
        }
        fn contacts(&self, state: &MechanismState<3>) -> [Contact<3>; 2] {
            let (s, c) = sincos(-state.q[2]);
            let (s, c) = (0.5 * LENGTH * s, 0.5 * LENGTH * c);
            [
                Contact::corner("wall", state, [-s, c], Surface::WALL),
                Contact::corner("foot", state, [s, -c], Surface::FLOOR),
            ]
        }
    }
    assert!(misdeclared(&Reversed, &state) > 0.1);
}

/// With much friction a run drifts off its contacts more; it is put back, lets go of the wall,
/// and goes on.
#[test]
fn rough_ladders_let_go_too() {
    let mut cone = Errors::in_units_of(EPS, "friction of the foot");
    let mut drift = Errors::of("drift off the contacts, m");
    let mut unbound = Errors::of("gap where the wall lets go, of a run that is not put back, m");
    for angle in [0.25, 0.6, 1.0] {
        for part in [0.8, 0.9, 0.95, 0.99] {
            let ladder = rubs(part * tan(0.5 * angle));
            let start = ladder.at_rest(angle);
            let motion = motion_within(&ladder, 1e-9, start, 100.0).unwrap();
            let names: Vec<_> = motion.events().iter().map(|e| e.name.as_str()).collect();
            assert_eq!(names, ["wall lets go", "lands"]);
            let later = 0.5 * (motion.events()[0].t + motion.end_time());
            let [wall, foot] = motion.forces(later).unwrap();
            assert_eq!(wall.normal, 0.0);
            assert!(foot.normal > 0.0);
            cone.add(foot.tangential, -ladder.mu * foot.normal, foot.normal);
            let (gap, slip) = motion.drift().unwrap();
            drift.push_at(gap, (angle, part));
            assert_eq!(slip, 0.0);
            let lost: Run<_, 6> = adrift(&ladder, &Dop853::new(1e-9).unwrap(), start, 100.0);
            let [x, _, theta, ..] = lost.transitions()[0].before;
            unbound.push_at(x - 0.5 * LENGTH * sin(theta), (angle, part));
        }
    }
    assert_largest!(cone, 12, @"1.62");
    assert_largest!(drift, 12, @"8.84e-12");
    // The damaged twin.
    unbound.exceed(1e-13, 12);
}
