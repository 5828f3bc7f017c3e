//! Balls and discs that slip, then roll.

use super::G;
use rotation_dynamics::planar::contact::{
    Contact, Mechanism, MechanismState, Mode, Surface, motion_within,
};
use support::{EPS, Errors, assert_largest};

/// A ball or disc: mass, inertia over m R^2, radius, friction.
pub struct Round {
    pub mass: f64,
    pub shape: f64,
    pub radius: f64,
    pub mu: f64,
}

impl Mechanism<3, 1> for Round {
    fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
        let inertia = self.shape * self.mass * self.radius * self.radius;
        [[self.mass, 0.0, 0.0], [0.0, self.mass, 0.0], [0.0, 0.0, inertia]]
    }
    fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
        [0.0, -self.mass * G, 0.0]
    }
    fn contacts(&self, body: &MechanismState<3>) -> [Contact<3>; 1] {
        [Contact::rim("floor", body, self.radius, Surface::FLOOR).friction(self.mu)]
    }
}

/// Errors of the moment when it rolls, of the speed after, and of the forces before, if the
/// friction is off by the part `damage`.
fn rolls(damage: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "from slipping to rolling");
    for mass in [1e-12, 1e-3, 1.0, 1e12] {
        for (shape, v, omega) in
            [(0.4, 0.0, -70.0), (0.5, 3.0, 0.0), (1.0, -2.0, 10.0), (0.4, 1.0, 50.0)]
        {
            let round = Round { mass, shape, radius: 0.1, mu: 0.2 * (1.0 + damage) };
            let slip: f64 = v + 0.1 * omega;
            let stop = slip.abs() / (0.2 * G * (1.0 + 1.0 / shape));
            let rolls_at = v - f64::copysign(0.2 * G * stop, slip);
            let start = MechanismState { q: [0.0, 0.1, 0.0], v: [v, 0.0, omega] };
            let motion = motion_within(&round, 1e-12, start, 3.0 * stop + 0.5).unwrap();
            assert_eq!(motion.events().len(), 1, "{:?}", motion.events());
            let sticks = motion.event("floor sticks").unwrap();
            errors.add(sticks.t, stop, stop);
            let end = motion.at(motion.end_time()).unwrap();
            errors.add(end.v[0], rolls_at, slip.abs());
            errors.add(end.v[0], -0.1 * end.v[2], slip.abs());
            assert_eq!(motion.modes(motion.end_time()).unwrap(), [Mode::Stick]);
            let [force] = motion.forces(0.5 * stop).unwrap();
            errors.add(force.normal, mass * G, mass * G);
            let friction = 0.2 * mass * G;
            errors.add(force.tangential, -f64::copysign(friction, slip), friction);
        }
    }
    errors
}

/// Slip u = v + R omega falls at mu g (1 + 1/shape): then it rolls, and goes on rolling.
#[test]
fn what_slips_rolls_in_the_end() {
    assert_largest!(rolls(0.0), 80, @"1.99");
    let wrong = rolls(1e-12);
    assert!(wrong.largest() > 1e3);
}
