//! A bead swung over the top: on a rod, which pulls and pushes, and on a string, which only pulls.

use super::G;
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, Modal, Mode, motion_within,
};
use support::{Errors, assert_error, assert_largest};

/// A bead of 2 kg at 1 m from the origin.
pub struct Bead {
    pub string: bool,
}

impl Mechanism<2, 1> for Bead {
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[2.0, 0.0], [0.0, 2.0]]
    }
    fn force(&self, _: &MechanismState<2>) -> [f64; 2] {
        [0.0, -2.0 * G]
    }
    fn contacts(&self, bead: &MechanismState<2>) -> [Contact<2>; 1] {
        let ([x, y], [vx, vy]) = (bead.q, bead.v);
        let (beyond, rate) = (0.5 * (x * x + y * y - 1.0), vx * vx + vy * vy);
        let contact = match self.string {
            true => Contact::new("string", -beyond, [-x, -y], -rate),
            false => Contact::joint("rod", beyond, [x, y], rate),
        };
        // A string has no friction, and neither has a joint.
        match self.string {
            true => [contact],
            false => [contact.tangent([-y, x], 0.0).friction(0.5)],
        }
    }
}

/// Sent round from the bottom with v^2 = `part` g: 4 g is what reaches the top on a rod, 5 g
/// on a string.
fn swung(bead: &Bead, part: f64) -> ContactMotion<&Bead, 2, 1> {
    let start = MechanismState { q: [0.0, -1.0], v: [(part * G).sqrt(), 0.0] };
    motion_within(bead, 1e-9, start, 2.0).unwrap()
}

/// Errors of the force against m (3 g y + 2 g - v0^2), outward, and of v^2 against energy.
fn errors(bead: &Bead, part: f64) -> Errors {
    let motion = swung(bead, 4.5);
    assert_eq!(motion.modes(2.0).unwrap(), [Mode::Smooth]);
    assert!(motion.events().is_empty());
    let mut errors = Errors::of("a bead on a rod");
    for i in 0..=40 {
        let t = 0.05 * f64::from(i);
        let MechanismState { q, v } = motion.at(t).unwrap();
        let [force] = motion.forces(t).unwrap();
        let want = 2.0 * G * (3.0 * q[1] + 2.0 - part);
        errors.add(force.normal, want, 2.0 * G);
        let square = G * (part - 2.0 * (1.0 + q[1]));
        errors.add(v[0] * v[0] + v[1] * v[1], square, G);
        assert_eq!(force.tangential, 0.0);
    }
    errors
}

#[test]
fn a_rod_pulls_and_pushes() {
    let rod = Bead { string: false };
    assert_largest!(errors(&rod, 4.5), 82, @"1.11e-11");
    errors(&rod, 4.5 + 1e-9).exceed(1e-10, 82);
    let forces: Vec<f64> =
        (0..=40).map(|i| swung(&rod, 4.5).forces(0.05 * f64::from(i)).unwrap()[0].normal).collect();
    assert!(forces.iter().any(|f| *f > 0.0) && forces.iter().any(|f| *f < 0.0));
    let (gap, slip) = swung(&rod, 4.5).drift().unwrap();
    assert_error!(gap, 1.2e-13);
    assert_eq!(slip, 0.0);
    let scene: Modal<_, 2, 1> = Modal(&rod);
    assert_eq!(format!("{scene:?}"), "Modal<2, 1>");
}

/// The string goes slack where 3 y = v0^2/g - 2, unless v0^2 is 5 g.
#[test]
fn a_string_goes_slack() {
    let string = Bead { string: true };
    let mut errors = Errors::of("height where a string goes slack");
    for part in [2.5, 4.0, 4.5, 4.99] {
        let motion = swung(&string, part);
        let slack = motion.event("string lets go").unwrap();
        errors.push(slack.before.q[1] - (part - 2.0) / 3.0);
    }
    assert_largest!(errors, 4, @"4.76e-13");
    assert!(swung(&string, 5.01).events().is_empty());
    // The damaged twin: on a rod it would go on.
    assert!(swung(&Bead { string: false }, 4.5).events().is_empty());
}
