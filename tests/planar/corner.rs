//! The spinning cylinder in a corner (exercise 16.3): two contacts that rub.

use super::G;
use core::f64::consts::TAU;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, Mode, Surface, motion,
};
use support::{EPS, Errors, assert_error, assert_largest};

/// A cylinder of 3 kg and radius 0.1 m between a floor and a wall on its left.
struct Cylinder {
    mu: f64,
}

const R: f64 = 0.1;

impl Mechanism<3, 2> for Cylinder {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.5 * R * R]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -3.0 * G, 0.0]
    }
    fn contacts(&self, cylinder: &MechanismState<3>) -> [Contact<3>; 2] {
        [
            Contact::rim("floor", cylinder, R, Surface::FLOOR).friction(self.mu),
            Contact::rim("wall", cylinder, R, Surface::WALL).friction(self.mu),
        ]
    }
}

fn spun(cylinder: &Cylinder, spin: f64, t_end: f64) -> ContactMotion<&Cylinder, 3, 2> {
    let start = MechanismState { q: [R, R, 0.0], v: [0.0, 0.0, spin] };
    motion(cylinder, &Dop853::new(1e-14).unwrap(), start, t_end).unwrap()
}

/// Errors of forces, stop and angle, and what is left of speed and displacement, for the
/// sense that presses it to the wall.
struct Pressed {
    relative: Errors,
    /// Of the velocities, against 1 + spin.
    speed: Errors,
    /// Of the place, m.
    place: Errors,
}

impl Pressed {
    fn new() -> Self {
        Self {
            relative: Errors::in_units_of(EPS, "forces, stop, angle"),
            speed: Errors::of("speed at rest"),
            place: Errors::of("displacement"),
        }
    }

    /// A cylinder with the friction `mu` against formulas for the friction `declared`.
    fn add(&mut self, mu: f64, spin: f64, declared: f64) {
        let cylinder = Cylinder { mu };
        let stop = spin * R * (1.0 + declared * declared) / (2.0 * declared * (1.0 + declared) * G);
        let floor = 3.0 * G / (1.0 + declared * declared);
        let motion = spun(&cylinder, spin, 2.0 * stop);
        let names: Vec<_> = motion.events().iter().map(|e| e.name.as_str()).collect();
        assert_eq!(names, ["floor sticks", "wall sticks"]);
        let [down, across] = motion.forces(0.5 * stop).unwrap();
        let end = motion.at(2.0 * stop).unwrap();
        // At rest for good, where it was put.
        assert_eq!(motion.modes(2.0 * stop).unwrap(), [Mode::Stick; 2]);
        for v in end.v {
            self.speed.push(v / (1.0 + spin));
        }
        self.place.push(end.q[0] - R);
        self.place.push(end.q[1] - R);
        for (got, want) in [
            (motion.events()[0].t, stop),
            (motion.events()[1].t, stop),
            (down.normal, floor),
            (across.normal, declared * floor),
            (down.tangential, -declared * floor),
            (across.tangential, -declared * declared * floor),
            (end.q[2] / TAU, 0.5 * spin * stop / TAU),
        ] {
            self.relative.add(got, want, want.abs());
        }
    }
}

/// Counterclockwise: both contacts slip, and stop at the same time.
#[test]
fn a_cylinder_spins_down_in_its_corner() {
    let (mut found, mut damaged) = (Pressed::new(), Pressed::new());
    for mu in [0.01, 0.25, 0.9, 3.0] {
        for spin in [1e-6, 1.0, 60.0, 1e4] {
            found.add(mu, spin, mu);
            damaged.add(mu, spin, mu * (1.0 + 1e-9));
        }
    }
    assert_largest!(found.relative, 112, @"56.6");
    assert_largest!(found.speed, 48, @"1.87e-15");
    assert_largest!(found.place, 32, @"0");
    damaged.relative.exceed(57.0, 112);
    let (speed, place) = (damaged.speed.largest(), damaged.place.largest());
    assert!(speed <= found.speed.largest() && place <= found.place.largest());
    // The instance of the exercise, by an independent computation.
    let stop = spun(&Cylinder { mu: 0.25 }, 60.0, 3.0).events()[0].t;
    assert_error!(stop, 1.04011053723749, 26.9 eps);
}

/// Clockwise: it leaves the wall, slips, and rolls from R Omega / (3 mu g) on.
#[test]
fn the_other_sense_rolls_away() {
    let cylinder = Cylinder { mu: 0.25 };
    let motion = spun(&cylinder, -60.0, 2.0);
    let names: Vec<_> = motion.events().iter().map(|e| e.name.as_str()).collect();
    assert_eq!(names, ["floor sticks"]);
    let rolls = motion.events()[0].t;
    assert_error!(rolls, 0.815772970382343, 3.7 eps);
    let end = motion.at(2.0).unwrap();
    assert_error!(end.v[0], 2.0, 0.0 eps);
    assert_eq!(motion.modes(2.0).unwrap(), [Mode::Stick, Mode::Open]);
    // The damaged twin: another friction.
    let damaged = Cylinder { mu: 0.25 * (1.0 + 1e-9) };
    let later = spun(&damaged, -60.0, 2.0).events()[0].t;
    assert!((later / rolls - 1.0).abs() > 1e-10);
}
