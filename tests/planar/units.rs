//! Units of mass and length, masses and forces that no motion follows from, and runs of no time
//! or of negative time.

use super::G;
use rotation_dynamics::Error;
use rotation_dynamics::math::sincos;
use rotation_dynamics::planar::contact::{
    Contact, Mechanism, MechanismState, Surface, motion_within,
};
use support::{EPS, Errors, assert_error, assert_largest};

/// A rod of mass `mass` and length `length` that falls on a smooth floor at an angle.
struct Rod {
    mass: [f64; 3],
    length: f64,
    gravity: f64,
}

impl Rod {
    fn in_units(mass: f64, length: f64) -> Self {
        Self { mass: [mass, mass, mass * length * length / 12.0], length, gravity: G * length }
    }

    fn start(&self) -> MechanismState<3> {
        MechanismState { q: [0.0, 1.5 * self.length, 0.4], v: [0.3 * self.length, 0.0, 0.0] }
    }
}

impl Mechanism<3, 2> for Rod {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let [x, y, turning] = self.mass;
        [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, turning]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -self.mass[1] * self.gravity, 0.0]
    }
    fn contacts(&self, rod: &MechanismState<3>) -> [Contact<3>; 2] {
        let ((s, c), half) = (sincos(rod.q[2]), 0.5 * self.length);
        let corner = |name, side| {
            Contact::corner(name, rod, [side * half * c, side * half * s], Surface::FLOOR)
        };
        [corner("left", -1.0), corner("right", 1.0)]
    }
    fn scale(&self, _: &MechanismState<3>) -> MechanismState<3> {
        let q = [self.length, self.length, 1.0];
        MechanismState { q, v: q }
    }
}

/// Times and velocities of the three impacts of a rod in other units of mass and length against
/// those in kilogrammes and metres, for a rod that turns harder by the part `damage`.
fn units(damage: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "impacts of a rod in other units");
    let one = Rod::in_units(1.0, 1.0);
    let one = motion_within(&one, 1e-10, one.start(), 3.0).unwrap();
    for (mass, length) in [
        (1e-100, 1.0),
        (1e-30, 1.0),
        (1e-8, 1.0),
        (1e30, 1.0),
        (1e100, 1.0),
        (1.0, 1e-8),
        (1.0, 1e-6),
        (1.0, 1e6),
        (1e-30, 1e-6),
        (1e30, 1e6),
    ] {
        let mut rod = Rod::in_units(mass, length);
        rod.mass[2] *= 1.0 + damage;
        let other = motion_within(&rod, 1e-10, rod.start(), 3.0).unwrap();
        assert_eq!(other.events().len(), 3);
        for (other, one) in other.events().iter().zip(one.events()) {
            assert_eq!(other.name, one.name);
            errors.add(other.t, one.t, one.t);
            let v = other.after.v;
            for (v, want) in [v[0] / length, v[1] / length, v[2]].into_iter().zip(one.after.v) {
                errors.add(v, want, 1.0 + want.abs());
            }
        }
    }
    errors
}

/// The laws know no unit: a rod of 1e-30 kg falls as one of 1 kg does, one of 1e6 m as one of 1 m.
#[test]
fn a_rod_falls_alike_in_all_units() {
    assert_largest!(units(0.0), 120, @"205");
    assert!(units(1e-9).largest() > 1e5);
}

/// Masses that are not positive and forces that are no numbers are refused for what they are,
/// with their numbers.
#[test]
fn what_has_no_motion_is_refused() {
    let refused = |rod: &Rod| motion_within(rod, 1e-10, rod.start(), 1.0).unwrap_err();
    let one = || Rod::in_units(1.0, 1.0);
    for mass in [
        [0.0; 3],
        [-1.0; 3],
        [-1.0, 1.0, 1.0],
        [1.0, 1.0, 0.0],
        [1.0, f64::NAN, 1.0],
        [1.0, 1.0, f64::INFINITY],
    ] {
        let error = refused(&Rod { mass, ..one() });
        let Error::FunctionOutOfRange { value: told, .. } = &error else { panic!("{error}") };
        let [x, y, turning] = mass.map(f64::to_bits);
        let told: Vec<_> = told.iter().map(|m| m.to_bits()).collect();
        assert_eq!(told, [x, 0, 0, 0, y, 0, 0, 0, turning]);
        assert!(error.to_string().ends_with("symmetric and positive definite"));
    }
    for gravity in [f64::NAN, f64::INFINITY] {
        let error = refused(&Rod { gravity, ..one() });
        assert!(
            matches!(&error, Error::FunctionOutOfRange { t: 0.0, value: force, .. } if !force[1].is_finite()),
            "{error}"
        );
    }
    // What is good is not refused.
    assert!(motion_within(&one(), 1e-10, one().start(), 1.0).is_ok());
}

/// A bead on a plane with this mass matrix.
struct Coupled([[f64; 2]; 2]);

impl Mechanism<2, 0> for Coupled {
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        self.0
    }
    fn force(&self, _: &MechanismState<2>) -> [f64; 2] {
        [1.0, 0.0]
    }
    fn contacts(&self, _: &MechanismState<2>) -> [Contact<2>; 0] {
        []
    }
}

/// Of masses that are coupled the whole matrix counts, not its diagonal: symmetric, positive
/// however near to singular, in any units.
#[test]
fn coupled_masses_are_looked_at_as_a_whole() {
    let taken = |mass| {
        let start = MechanismState::rest([0.0; 2]);
        motion_within(&Coupled(mass), 1e-10, start, 1.0).is_ok()
    };
    for unit in [1e-60, 1.0, 1e60] {
        // Of the second coordinate, in units of the first.
        for small in [1e-30, 1.0] {
            let with = |upper: f64, lower: f64| {
                let coupling = unit * small;
                [[unit, upper * coupling], [lower * coupling, coupling * small]]
            };
            assert!(taken(with(0.0, 0.0)) && taken(with(0.999_999, 0.999_999)));
            assert!(taken(with(-0.5, -0.5 * (1.0 + EPS))));
            for (upper, lower) in [(1.0, 1.0), (1.1, 1.1), (-2.0, -2.0), (0.5, 0.4), (0.5, 0.0)] {
                assert!(!taken(with(upper, lower)), "{upper}, {lower}");
            }
        }
    }
}

/// A run of no time ends where it begins; contacts are not run backward, and what has none is.
#[test]
fn no_time_and_negative_time() {
    let rod = Rod::in_units(1.0, 1.0);
    let none = motion_within(&rod, 1e-10, rod.start(), 0.0).unwrap();
    assert_eq!((none.end_time(), none.estimate()), (0.0, Some(0.0)));
    assert_eq!(none.at(0.0).unwrap(), rod.start());
    assert!(none.events().is_empty());
    let error = motion_within(&rod, 1e-10, rod.start(), -1.0).unwrap_err();
    assert!(matches!(error, Error::OutOfRange { name: "t_end", value: -1.0, .. }), "{error}");
    assert!(error.to_string().contains("cannot be run backward"), "{error}");
    // x = t^2/2.
    let free = Coupled([[1.0, 0.0], [0.0, 1.0]]);
    let back = motion_within(&free, 1e-10, MechanismState::rest([0.0; 2]), -1.0).unwrap();
    assert_eq!(back.end_time(), -1.0);
    let end = back.at(-1.0).unwrap();
    assert_error!(end.q[0], 0.5, 8.0 eps);
    assert_error!(end.v[0], -1.0, 0.0 eps);
}
