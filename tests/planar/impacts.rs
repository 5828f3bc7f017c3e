//! Impacts: one contact or several at once, with restitution and friction.

use super::G;
use rotation_dynamics::Error;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::sincos;
use rotation_dynamics::planar::contact::{
    Contact, Mechanism, MechanismState, Surface, motion_so_far, motion_within,
};
use support::{EPS, Errors, assert_error, assert_largest};

/// A ball of radius 0.1 m and inertia (2/5) m R^2 between floor and wall.
struct Ball {
    restitution: f64,
    mu: f64,
}

impl Mechanism<3, 2> for Ball {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.004]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -G, 0.0]
    }
    fn contacts(&self, ball: &MechanismState<3>) -> [Contact<3>; 2] {
        [("floor", Surface::FLOOR), ("wall", Surface::WALL)].map(|(name, surface)| {
            Contact::rim(name, ball, 0.1, surface).friction(self.mu).restitution(self.restitution)
        })
    }
}

/// Errors of times and velocities of bounces, if the friction is off by the part `rougher`
/// and the restitution by `livelier`.
fn bounces(rougher: f64, livelier: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "bounces");
    for restitution in [0.0, 0.5, 1.0] {
        for mu in [0.0, 0.05, 0.1, 0.9] {
            for (v, spin) in [(1.0, 0.0), (0.0, 30.0), (1.0, -30.0)] {
                let ball =
                    Ball { restitution: restitution * (1.0 + livelier), mu: mu * (1.0 + rougher) };
                let fall = 0.5;
                let start = MechanismState {
                    q: [5.0, 0.1 + 0.5 * G * fall * fall, 0.0],
                    v: [v, 0.0, spin],
                };
                let motion = motion_within(&ball, 1e-12, start, 0.6).unwrap();
                let hit = &motion.events()[0];
                errors.add(hit.t, fall, fall);
                // The impulses per unit mass: (1 + e) v_y, and at most mu times it, or 2/7 of the slip.
                let slip: f64 = v + 0.1 * spin;
                let most = mu * (1.0 + restitution) * G * fall;
                let change = -f64::copysign(most.min(2.0 / 7.0 * slip.abs()), slip);
                let want = [v + change, restitution * G * fall, spin + change * 0.1 / 0.004];
                for (got, want) in hit.after.v.into_iter().zip(want) {
                    errors.add(got, want, 1.0 + want.abs());
                }
                let name = if restitution > 0.0 { "floor bounces" } else { "floor touches" };
                assert_eq!(hit.name, name);
            }
        }
    }
    errors
}

/// Dropped with spin and speed on a rough floor: friction turns spin into speed until the
/// rim grips, or until the impulse is over.
#[test]
fn a_spinning_ball_bounces_off_sideways() {
    assert_largest!(bounces(0.0, 0.0), 144, @"1.71");
    assert!(bounces(1e-12, 0.0).largest() > 1e2);
    assert!(bounces(0.0, -1e-12).largest() > 1e3);
}

/// Into the corner: floor and wall are hit at the same time.
#[test]
fn two_contacts_are_hit_at_once() {
    let hit = |restitution| {
        let ball = Ball { restitution, mu: 0.0 };
        let start =
            MechanismState { q: [1.1, 0.1 + 1.0 + 0.5 * G * 0.25, 0.0], v: [-2.0, -2.0, 3.0] };
        let motion = motion_within(&ball, 1e-12, start, 0.55).unwrap();
        motion.events()[0].clone()
    };
    let up = 0.5 * (2.0 + 0.5 * G);
    let both = hit(0.5);
    assert_error!(both.t, 0.5, 0.0 eps);
    assert_error!(both.after.v[0], 1.0, 0.0 eps);
    assert_error!(both.after.v[1], up, 0.0 eps);
    assert_eq!(both.after.v[2], 3.0);
    // The damaged twin: they return too much, each.
    let damaged = hit(0.5 * (1.0 + 1e-12)).after.v;
    assert!((damaged[0] - 1.0).abs() > 1e3 * EPS && (damaged[1] / up - 1.0).abs() > 1e3 * EPS);
}

/// A run may not end among bounces that doubles do not resolve, nor go on through more bounces than
/// it is allowed: it is refused, and what went before is there.
#[test]
fn ends_among_bounces_are_refused() {
    let drop = MechanismState::rest([5.0, 0.1 + 0.5 * G, 0.0]);
    let ball = |restitution| Ball { restitution, mu: 0.3 };
    let method = Dop853::new(1e-12).unwrap();
    let until = |restitution, t_end| motion_so_far(ball(restitution), &method, drop, t_end);
    let (bounces, refused) = until(0.5, 2.999);
    assert_eq!((bounces.events().len(), refused), (11, None));
    // 1 + 2 (1/2 + 1/4 + ...) seconds.
    let (bounces, refused) = until(0.5, 3.0 - 1e-9);
    let Some(Error::BouncesUnresolved { contact, height, t, until: last }) = refused else {
        panic!("{refused:?}")
    };
    assert_eq!(contact, "floor");
    assert!((3.0 - 1e-6..3.0 - 1e-9).contains(&t), "{t}");
    assert!((last - 3.0).abs() < 1e-10, "{last}");
    assert!((0.25e-12..1e-12).contains(&height), "{height:e}");
    assert_eq!(bounces.end_time(), 3.0 - 1e-9);
    assert_eq!(bounces.events().last().unwrap().name, "floor touches");
    assert_eq!(until(0.5, 3.0 + 1e-9).1, None);
    // One that keeps its speed, too low to be seen, never comes to rest.
    let low = MechanismState { q: [5.0, 0.1, 0.0], v: [0.0, 1e-6, 0.0] };
    let (_, refused) = motion_so_far(ball(1.0), &method, low, 1.0);
    assert!(
        matches!(refused, Some(Error::BouncesUnresolved { until, .. }) if until.is_infinite()),
        "{refused:?}"
    );
    let (bounces, refused) = until(0.99, 200.0);
    assert!(
        matches!(refused, Some(Error::LimitReached { what: "changes of phase", limit: 1000, .. })),
        "{refused:?}"
    );
    assert_eq!(bounces.events().len(), 1000);
    let last = bounces.events()[999].t;
    let want = 1.0 + 2.0 * 0.99 * (1.0 - 0.99_f64.powi(999)) / 0.01;
    assert!((last - want).abs() < 1e-9, "{last} {want}");
    assert_eq!(bounces.end_time(), last);
}

/// Masses in a row, each with a smooth contact to the next: `masses[0]` comes from the left.
struct Row {
    masses: [f64; 3],
    restitution: f64,
}

impl Mechanism<3, 2> for Row {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let [a, b, c] = self.masses;
        [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0; 3]
    }
    fn contacts(&self, row: &MechanismState<3>) -> [Contact<3>; 2] {
        let [x, y, z] = row.q;
        [
            Contact::new("first", y - x, [-1.0, 1.0, 0.0], 0.0).restitution(self.restitution),
            Contact::new("second", z - y, [0.0, -1.0, 1.0], 0.0).restitution(self.restitution),
        ]
    }
}

/// The velocities of three masses after a plastic impact, against those for `ratio`, if the
/// middle one is off by the part `damage`.
fn together(damage: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "common velocity");
    for ratio in [1e-12, 1e-6, 1.0, 1e6, 1e12] {
        let row = Row { masses: [1.0, ratio * (1.0 + damage), 2.0], restitution: 0.0 };
        let start = MechanismState { q: [-1.0, 0.0, 0.0], v: [1.0, 0.0, 0.0] };
        let motion = motion_within(&row, 1e-12, start, 2.0).unwrap();
        let common = 1.0 / (3.0 + ratio);
        for v in motion.at(2.0).unwrap().v {
            errors.add(v, common, common);
        }
        assert_eq!(motion.events().len(), 1, "{:?}", motion.events());
    }
    errors
}

/// Plastic: all three go on together, whatever their masses. Elastic, one after the other:
/// equal masses hand the motion on.
#[test]
fn a_row_is_hit_through() {
    assert_largest!(together(0.0), 15, @"3.00");
    assert!(together(1e-12).largest() > 1e3);
    let end = |restitution| {
        let row = Row { masses: [1.0; 3], restitution };
        let start = MechanismState { q: [-1.0, 0.0, 0.5], v: [1.0, 0.0, 0.0] };
        let motion = motion_within(&row, 1e-12, start, 3.0).unwrap();
        motion.at(3.0).unwrap()
    };
    assert_error!(end(1.0).q[2], 2.0, 0.0 eps);
    assert_eq!(end(1.0).v, [0.0, 0.0, 1.0]);
    assert!((end(1.0 - 1e-12).q[2] - 2.0).abs() > 1e3 * EPS);
}

/// A rod of length 2 m and mass 1 kg whose tip, right below its centre, meets a rough floor.
pub struct Rod {
    pub mu: f64,
    pub restitution: f64,
}

impl Mechanism<3, 1> for Rod {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0 / 3.0]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -G, 0.0]
    }
    fn contacts(&self, rod: &MechanismState<3>) -> [Contact<3>; 1] {
        let (s, c) = sincos(rod.q[2]);
        let tip = Contact::corner("tip", rod, [c, s], Surface::FLOOR);
        [tip.friction(self.mu).restitution(self.restitution)]
    }
}

/// The state of the rod at an angle below the horizontal, its tip on the floor.
fn on_tip(angle: f64, v: [f64; 3]) -> MechanismState<3> {
    let (s, _) = sincos(angle);
    MechanismState { q: [0.0, s, -angle], v }
}

/// Painlevé: a rod pushed with its tip ahead on a rough floor; at mu = 2 and 45 degrees
/// neither slipping nor lifting off agrees with itself, and when it turns fast both do.
#[test]
fn the_rod_of_painleve_is_refused() {
    let half = core::f64::consts::FRAC_PI_4;
    let rod = |mu| Rod { mu, restitution: 0.0 };
    let (s, c) = sincos(half);
    // The tip slips forward at 1 m/s and stays on the floor: v_y + omega c = 0.
    let start = |omega: f64| on_tip(half, [1.0 - omega * s, -omega * c, omega]);
    let go = |mu, omega| motion_within(&rod(mu), 1e-9, start(omega), 0.1).map(|_| ());
    // Below mu = 5/3 there is one motion.
    assert_eq!(go(1.6, 0.0), Ok(()));
    let error = go(2.0, 0.0).unwrap_err();
    assert!(
        matches!(&error, Error::ContactsUndetermined { tried: 2, motions, .. } if motions.is_empty()),
        "{error}"
    );
    assert!(error.to_string().contains("Painlev\u{e9}"), "{error}");
    let error = go(2.0, 5.0).unwrap_err();
    let Error::ContactsUndetermined { motions, .. } = &error else { panic!("{error}") };
    assert_eq!(motions[..], ["tip slips forward", "tip opens"]);
}

/// Newton's restitution with friction that turns the slip round can gain energy (Kane):
/// such an impact is refused.
#[test]
fn an_impact_that_gains_energy_is_refused() {
    let rod = Rod { mu: 0.0, restitution: 1.0 };
    let mut start = on_tip(0.9, [-0.86, -1.0, 0.0]);
    start.q[1] += 0.1;
    let hit =
        |mu, restitution| motion_within(&Rod { mu, restitution }, 1e-9, start, 0.15).map(|_| ());
    assert_eq!(hit(rod.mu, rod.restitution), Ok(()));
    let error = hit(1.0, 1.0).unwrap_err();
    let Error::ImpactGainsEnergy { before, after, .. } = error else { panic!("{error}") };
    assert!(after > before, "{error}");
    // Plastic, the same impact is one.
    assert_eq!(hit(1.0, 0.0), Ok(()));
}
