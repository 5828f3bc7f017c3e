//! A surface that rises: what rests on it, what is thrown by it, and what a run says of itself.

use super::G;
use rotation_dynamics::Error;
use rotation_dynamics::integrators::Dop853;
use rotation_dynamics::planar::contact::{
    Contact, ContactMotion, Mechanism, MechanismState, Mode, motion, motion_within,
};
use support::{EPS, Errors, assert_largest};

/// A body of 2 kg over a plate that rises, with the clock as a coordinate.
struct Lift {
    speed: f64,
    acceleration: f64,
    restitution: f64,
}

impl Mechanism<2, 1> for Lift {
    fn mass(&self, _: &[f64; 2]) -> [[f64; 2]; 2] {
        [[2.0, 0.0], [0.0, 1.0]]
    }
    fn force(&self, _: &MechanismState<2>) -> [f64; 2] {
        [-2.0 * G, 0.0]
    }
    fn contacts(&self, body: &MechanismState<2>) -> [Contact<2>; 1] {
        let [height, t] = body.q;
        let plate = (self.speed + 0.5 * self.acceleration * t) * t;
        let rate = self.speed + self.acceleration * t;
        [Contact::new("plate", height - plate, [1.0, 0.0], 0.0)
            .rising(rate, self.acceleration)
            .restitution(self.restitution)]
    }
}

fn carried(lift: &Lift, height: f64, v: f64, t_end: f64) -> ContactMotion<&Lift, 2, 1> {
    let start = MechanismState { q: [height, 0.0], v: [v, 1.0] };
    motion_within(lift, 1e-12, start, t_end).unwrap()
}

/// Force and height of what rests on a plate, if it is faster by the part `damage`.
fn rests(damage: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "a body on a plate that rises");
    for (speed, acceleration) in [(0.0, 3.0), (2.0, 3.0), (-1.0, -4.0), (3.0, 0.0)] {
        let lift = Lift {
            speed: speed * (1.0 + damage),
            acceleration: acceleration * (1.0 + damage),
            restitution: 0.0,
        };
        let motion = carried(&lift, 0.0, lift.speed, 1.5);
        assert_eq!(motion.modes(1.5).unwrap(), [Mode::Smooth]);
        assert!(motion.events().is_empty());
        let [force] = motion.forces(1.0).unwrap();
        let end = motion.at(1.5).unwrap();
        errors.add(force.normal, 2.0 * (G + acceleration), 2.0 * G);
        errors.add(end.q[0], 1.5 * speed + 1.125 * acceleration, G);
        errors.add(end.v[0], speed + 1.5 * acceleration, G);
    }
    errors
}

#[test]
fn a_plate_carries() {
    assert_largest!(rests(0.0), 12, @"2.45");
    assert!(rests(1e-12).largest() > 1e3);
}

/// The plate that falls faster than g is left at once.
#[test]
fn a_plate_that_drops_is_left() {
    let lift = Lift { speed: 0.0, acceleration: -1.5 * G, restitution: 0.0 };
    let motion = carried(&lift, 0.0, 0.0, 1.0);
    assert_eq!(motion.modes(0.5).unwrap(), [Mode::Open]);
}

/// Time and speed after an impact on a plate that rises steadily, if it returns more by the
/// part `damage`.
fn thrown(damage: f64) -> Errors {
    let mut errors = Errors::in_units_of(EPS, "impacts on a plate that rises");
    for (speed, restitution) in [(0.0, 1.0), (1.0, 1.0), (1.0, 0.25), (-2.0, 0.5)] {
        let lift = Lift { speed, acceleration: 0.0, restitution: restitution * (1.0 - damage) };
        // From rest relative to the plate it meets it after one second.
        let motion = carried(&lift, 0.5 * G, speed, 1.01);
        let [hit] = motion.events() else {
            panic!("{:?}", motion.events());
        };
        assert_eq!(hit.name, "plate bounces");
        errors.add(hit.t, 1.0, 1.0);
        errors.add(hit.before.v[0], speed - G, G);
        errors.add(hit.after.v[0], speed + restitution * G, G);
        errors.add(hit.after.v[1], 1.0, 1.0);
    }
    errors
}

#[test]
fn a_plate_throws() {
    assert_largest!(thrown(0.0), 16, @"2");
    assert!(thrown(1e-12).largest() > 1e3);
}

/// A run says where it ends, what it cost and, where that was asked for, how good it is.
#[test]
fn a_run_says_what_it_is() {
    let lift = Lift { speed: 1.0, acceleration: 0.0, restitution: 0.5 };
    let motion_at = |step_error: f64| {
        let start = MechanismState { q: [0.5 * G, 0.0], v: [1.0, 1.0] };
        motion(&lift, &Dop853::new(step_error).unwrap(), start, 1.5).unwrap()
    };
    let asked = carried(&lift, 0.5 * G, 1.0, 1.5);
    let estimate = asked.estimate().unwrap();
    assert!(estimate > 0.0 && estimate <= 0.5e-12, "{estimate:e}");
    let (coarse, fine) = (motion_at(1e-12), motion_at(1e-12 / 32.0));
    assert_eq!(fine.estimate(), None);
    assert_eq!(asked.end_time(), 1.5);
    assert_eq!(asked.at(1.2).unwrap(), fine.at(1.2).unwrap());
    assert_ne!(asked.at(1.2).unwrap(), asked.at(1.3).unwrap());
    // Two runs, and nothing else.
    let mut both = coarse.work();
    both += fine.work();
    assert_eq!(asked.work(), both);
    assert_ne!(fine.work(), both);
    assert!(matches!(asked.event("plate sticks"), Err(Error::NotReached { until: 1.5, .. })));
    for t in [-1e-9, 1.5 + 1e-9, f64::NAN] {
        assert!(matches!(asked.at(t), Err(Error::OutsideRun { .. })));
        assert!(asked.forces(t).is_err() && asked.modes(t).is_err());
    }
    let told = format!("{asked:?}");
    assert!(told.contains("end_time: 1.5") && told.contains("plate bounces"), "{told}");
}
