//! Contacts at rest: forces that are not determined, strings, joints, given forces.

use super::{G, relative};
use rotation_dynamics::Error;
use rotation_dynamics::math::{EPS, atan, cos, sin, sincos};
use rotation_dynamics::planar::contact::{Contact, Mechanism, Mode, State, Surface, motion_within};

/// A box, 2 by 1 m and 5 kg, on two feet on a slope, by axes along the slope and off it.
struct Box {
    slope: f64,
    mu: f64,
}

impl Mechanism<3, 6, 2> for Box {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[5.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0, 0.0, 25.0 / 12.0]]
    }
    fn force(&self, _: &State<3>) -> [f64; 3] {
        [5.0 * G * sin(self.slope), -5.0 * G * cos(self.slope), 0.0]
    }
    fn contacts(&self, body: &State<3>) -> [Contact<3>; 2] {
        let (s, c) = sincos(body.q[2]);
        let foot = |name, x: f64| {
            let arm = [x * c + 0.5 * s, x * s - 0.5 * c];
            Contact::corner(name, body, arm, Surface::FLOOR).friction(self.mu)
        };
        [foot("upper", -1.0), foot("lower", 1.0)]
    }
}

/// It stays up to the tangent of the slope though the shares of the feet are not determined,
/// slides beyond, and tips where the slope is steeper than 2.
#[test]
fn a_box_on_two_feet() {
    let mut ran = 0;
    for mu in [0.1, 0.5, 1.0] {
        for part in [0.0, 0.5, 0.999, 1.001] {
            let slope = part * atan(mu);
            let body = Box { slope, mu };
            let start = State::rest([0.0, 0.5, 0.0]);
            let motion = motion_within(&body, 1e-12, start, 1.0).unwrap();
            let [upper, lower] = motion.forces(1.0).unwrap();
            let end = motion.at(1.0).unwrap();
            assert!(relative(upper.normal + lower.normal, 5.0 * G * cos(slope)) <= 16.0 * EPS);
            assert!(motion.events().is_empty());
            if part < 1.0 {
                assert_eq!(motion.modes(1.0).unwrap(), [Mode::Stick; 2]);
                let along = upper.tangential + lower.tangential + 5.0 * G * sin(slope);
                assert!(along.abs() <= 1e-13, "{along:e}");
                for foot in [upper, lower] {
                    assert!(foot.tangential.abs() <= mu * foot.normal);
                }
                assert!(end.v.iter().all(|v| v.abs() <= 1e-14), "{end:?}");
            } else {
                let a = G * (sin(slope) - mu * cos(slope));
                assert!((end.v[0] - a).abs() <= 1e-13, "{}", end.v[0] - a);
            }
            ran += 1;
        }
    }
    assert_eq!(ran, 12);
    let steep = Box {
        slope: atan(2.1),
        mu: 3.0,
    };
    let motion = motion_within(&steep, 1e-9, State::rest([0.0, 0.5, 0.0]), 0.3).unwrap();
    assert_eq!(motion.modes(0.1).unwrap(), [Mode::Open, Mode::Stick]);
}

/// A pile: `heavy` on `light` on the floor.
struct Pile {
    light: f64,
    heavy: f64,
}

impl Mechanism<2, 4, 2> for Pile {
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[self.light, 0.0], [0.0, self.heavy]]
    }
    fn force(&self, _: &State<2>) -> [f64; 2] {
        [-self.light * G, -self.heavy * G]
    }
    fn contacts(&self, pile: &State<2>) -> [Contact<2>; 2] {
        let [low, high] = pile.q;
        [
            Contact::new("floor", low, [1.0, 0.0], 0.0),
            Contact::new("between", high - low, [-1.0, 1.0], 0.0),
        ]
    }
}

#[test]
fn a_pile_rests_at_any_ratio_of_masses() {
    let (mut ran, mut worst, mut drift) = (0, 0.0, 0.0);
    for exponent in -12..=12 {
        let pile = Pile {
            light: 1.0,
            heavy: rotation_dynamics::math::pow(10.0, f64::from(exponent)),
        };
        let motion = motion_within(&pile, 1e-12, State::rest([0.0; 2]), 10.0).unwrap();
        let [floor, between] = motion.forces(10.0).unwrap();
        worst = f64::max(worst, relative(floor.normal, (pile.light + pile.heavy) * G));
        // To round-off of the largest force, as linear equations give it.
        worst = worst.max((between.normal - pile.heavy * G).abs() / floor.normal);
        // Accelerations of 0 are 0 to round-off of g.
        let end = motion.at(10.0).unwrap();
        drift = end.v.iter().fold(drift, |most, v| f64::max(most, v.abs()));
        ran += 1;
    }
    assert_eq!(ran, 25);
    // Measured: 3.34 eps of the largest force, and 2 eps g a second.
    assert!(worst <= 3.4 * EPS, "{} eps", worst / EPS);
    let drift = drift / (10.0 * G);
    assert!(drift <= 2.0 * EPS, "{} eps", drift / EPS);
}

/// A disc that unwinds from a string (exercise 16.4): height below the hand, and angle.
struct Unwinding {
    glued: bool,
}

impl Mechanism<2, 4, 1> for Unwinding {
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[3.0, 0.0], [0.0, 0.5 * 3.0 * 0.04]]
    }
    fn force(&self, _: &State<2>) -> [f64; 2] {
        [3.0 * G, 0.0]
    }
    fn contacts(&self, disc: &State<2>) -> [Contact<2>; 1] {
        let [fallen, angle] = disc.q;
        let slack = 0.2 * angle - fallen;
        let string = if self.glued {
            Contact::joint
        } else {
            Contact::new
        };
        [string("string", slack, [-1.0, 0.2], 0.0)]
    }
}

/// Taut it falls with 2g/3; spun up it falls freely until the string is taut again; a joint
/// would hold it back.
#[test]
fn a_disc_unwinds_from_its_string() {
    let disc = Unwinding { glued: false };
    let motion = motion_within(&disc, 1e-12, State::rest([0.0; 2]), 0.5).unwrap();
    let end = motion.at(0.5).unwrap();
    assert!(relative(end.v[0], G / 3.0) <= 4.0 * EPS);
    assert!(relative(end.v[1], 16.3444166666667) <= 1e-14);
    assert!(relative(motion.forces(0.2).unwrap()[0].normal, G) <= 4.0 * EPS);
    // Spinning too fast the string is slack: free fall until g t = 2 R omega, then a jerk.
    let spun = State {
        q: [0.0; 2],
        v: [0.0, 10.0],
    };
    let motion = motion_within(&disc, 1e-12, spun, 0.5).unwrap();
    let jerk = motion.event("string touches").unwrap();
    assert!(relative(jerk.t, 4.0 / G) <= 4.0 * EPS, "{}", jerk.t);
    assert!(
        relative(jerk.after.v[0], 10.0 / 3.0) <= 8.0 * EPS,
        "{jerk:?}"
    );
    let error = motion_within(&Unwinding { glued: true }, 1e-9, spun, 0.5).unwrap_err();
    assert!(
        matches!(
            error,
            Error::CannotHold {
                contact: "string",
                ..
            }
        ),
        "{error}"
    );
}

/// Two discs pressed together (exercise 15.1): inertias 0.03 and 0.05 kg m^2.
struct Discs;

impl Mechanism<2, 4, 1> for Discs {
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[0.03, 0.0], [0.0, 0.05]]
    }
    fn force(&self, _: &State<2>) -> [f64; 2] {
        [0.0; 2]
    }
    fn contacts(&self, _: &State<2>) -> [Contact<2>; 1] {
        // A torque of 0.5 N m: 10 N, a mean radius of 0.1 m, mu = 1/2.
        let faces = Contact::pressed("faces", 10.0);
        [faces.tangent([0.1, -0.1], 0.0).friction(0.5)]
    }
}

#[test]
fn pressed_discs_end_at_one_rate() {
    let start = State {
        q: [0.0; 2],
        v: [40.0, -10.0],
    };
    let motion = motion_within(&Discs, 1e-12, start, 3.0).unwrap();
    let sticks = motion.event("faces sticks").unwrap();
    assert!(relative(sticks.t, 1.875) <= 4.0 * EPS, "{}", sticks.t);
    let end = motion.at(3.0).unwrap();
    assert!(
        end.v.iter().all(|&v| relative(v, 8.75) <= 4.0 * EPS),
        "{end:?}"
    );
    assert!(relative(motion.forces(1.0).unwrap()[0].tangential, -5.0) <= EPS);
    assert_eq!(motion.events().len(), 1);
}
