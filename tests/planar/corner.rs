//! The spinning cylinder in a corner (exercise 16.3): two contacts that rub.

use super::{G, relative};
use core::f64::consts::TAU;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::math::EPS;
use rotation_dynamics::planar::contact::{
    Contact, Mechanism, Mode, Motion, State, Surface, motion,
};

/// A cylinder of 3 kg and radius 0.1 m between a floor and a wall on its left.
struct Cylinder {
    mu: f64,
}

const R: f64 = 0.1;

impl Mechanism<3, 6, 2> for Cylinder {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        [[3.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.5 * R * R]]
    }
    fn force(&self, _: &State<3>) -> [f64; 3] {
        [0.0, -3.0 * G, 0.0]
    }
    fn contacts(&self, cylinder: &State<3>) -> [Contact<3>; 2] {
        [
            Contact::rim("floor", cylinder, R, Surface::FLOOR).friction(self.mu),
            Contact::rim("wall", cylinder, R, Surface::WALL).friction(self.mu),
        ]
    }
}

fn spun(cylinder: &Cylinder, spin: f64, t_end: f64) -> Motion<&Cylinder, 3, 6, 2> {
    let start = State {
        q: [R, R, 0.0],
        v: [0.0, 0.0, spin],
    };
    motion(cylinder, &Dop853::new(1e-14).unwrap(), start, t_end).unwrap()
}

/// Largest relative error of forces, stop and angle for the sense that presses it to the wall.
fn pressed(mu: f64, spin: f64, declared: f64) -> f64 {
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
    assert!(
        end.v.iter().all(|v| v.abs() <= 4e-15 * (1.0 + spin)),
        "{end:?}"
    );
    assert!(
        (end.q[0] - R).abs() + (end.q[1] - R).abs() <= 1e-15,
        "{end:?}"
    );
    let found = [
        relative(motion.events()[0].t, stop),
        relative(motion.events()[1].t, stop),
        relative(down.normal, floor),
        relative(across.normal, declared * floor),
        relative(down.tangential, -declared * floor),
        relative(across.tangential, -declared * declared * floor),
        relative(end.q[2] / TAU, 0.5 * spin * stop / TAU),
    ];
    found.into_iter().fold(0.0, f64::max)
}

/// Counterclockwise: both contacts slip, and stop at the same time.
#[test]
fn a_cylinder_spins_down_in_its_corner() {
    let (mut ran, mut worst) = (0, 0.0);
    for mu in [0.01, 0.25, 0.9, 3.0] {
        for spin in [1e-6, 1.0, 60.0, 1e4] {
            let error = pressed(mu, spin, mu);
            assert!(error.is_finite());
            worst = f64::max(worst, error);
            ran += 1;
        }
    }
    assert_eq!(ran, 16);
    assert!(worst <= 57.0 * EPS, "{} eps", worst / EPS);
    // The instance of the exercise, by an independent computation.
    assert!(pressed(0.25, 60.0, 0.25 * (1.0 + 1e-9)) > 1e-10);
    let stop = spun(&Cylinder { mu: 0.25 }, 60.0, 3.0).events()[0].t;
    assert!(relative(stop, 1.04011053723749) <= 1e-14, "{stop}");
}

/// Clockwise: it leaves the wall, slips, and rolls from R Omega / (3 mu g) on.
#[test]
fn the_other_sense_rolls_away() {
    let cylinder = Cylinder { mu: 0.25 };
    let motion = spun(&cylinder, -60.0, 2.0);
    let names: Vec<_> = motion.events().iter().map(|e| e.name.as_str()).collect();
    assert_eq!(names, ["floor sticks"]);
    let rolls = motion.events()[0].t;
    assert!(relative(rolls, 0.815772970382343) <= 1e-14, "{rolls}");
    let end = motion.at(2.0).unwrap();
    assert!(relative(end.v[0], 2.0) <= 4.0 * EPS, "{end:?}");
    assert_eq!(motion.modes(2.0).unwrap(), [Mode::Stick, Mode::Open]);
}
