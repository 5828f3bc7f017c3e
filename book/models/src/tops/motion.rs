//! The equations of motion, phase by phase.

use super::configuration::{Coordinates, axis};
use super::{Configuration, Forces, ResistingMoment, TipFriction, Top};
use rotation_dynamics::effects::Effect;
use rotation_dynamics::error::Result;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::hypot;
use rotation_dynamics::planar::{Condition, Next, Phased};

/// The mode of the tip.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactMode {
    /// It slides (or creeps) over the floor.
    Sliding,
    /// It rolls, and may pivot.
    Rolling,
}

/// Which equations hold, and how many marks have been passed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Phase {
    /// The mode of the tip.
    pub contact: ContactMode,
    /// Marks passed.
    pub passed: usize,
}

/// A top to be simulated with this error of a step.
pub(super) struct Scene<'t, F, R, E> {
    pub(super) top: &'t Top<F, R, E>,
    pub(super) step: f64,
}

/// Part of sqrt(g l) with which a tip begins to slip: at zero its direction would not be known.
const ONSET: f64 = 1e-8;

impl<F: TipFriction, R: ResistingMoment, E: Effect> Scene<'_, F, R, E> {
    /// A speed of the size of the top's own, sqrt(g (|l| + r)).
    pub(super) fn speed(&self) -> f64 {
        let shape = self.top.shape();
        (self.top.gravity().norm() * (shape.lever().abs() + shape.tip())).sqrt()
    }

    /// Slower than this the tip is said to have stopped: a step may miss zero by so much.
    fn stopped(&self) -> f64 {
        10.0 * self.step * self.speed()
    }

    fn seen(&self, phase: Phase, y: &Coordinates) -> (Configuration, Forces) {
        let at = self.top.configuration(phase, y);
        (at, self.top.forces(phase, &at, y))
    }

    /// The coordinates with height and momentum as the contact has them.
    pub(super) fn settled(&self, at: &Configuration, y: &Coordinates) -> Coordinates {
        let mut settled = *y;
        settled[10] = at.centre.z();
        for (place, v) in settled[11..].iter_mut().zip(at.velocity.to_array()) {
            *place = self.top.shape().mass() * v;
        }
        settled
    }

    /// A tip that does not move over the floor: it rolls if friction can hold it, and slides
    /// off otherwise.
    pub(super) fn stuck(&self, passed: usize, y: &Coordinates) -> (Phase, Coordinates) {
        let phase = Phase { contact: ContactMode::Rolling, passed };
        let (at, forces) = self.seen(phase, y);
        let force = hypot(forces.friction.x(), forces.friction.y());
        let settled = self.settled(&at, y);
        if force < self.top.friction.holds() * forces.normal {
            return (phase, settled);
        }
        (Phase { contact: ContactMode::Sliding, passed }, self.let_go(&forces, settled))
    }

    /// Off in the direction in which friction could not hold it any more.
    fn let_go(&self, forces: &Forces, mut y: Coordinates) -> Coordinates {
        let force = hypot(forces.friction.x(), forces.friction.y());
        let kick = ONSET.max(100.0 * self.step) * self.speed() * self.top.shape().mass();
        y[11] -= kick * forces.friction.x() / force;
        y[12] -= kick * forces.friction.y() / force;
        y
    }

    fn slides(&self, passed: usize, y: &Coordinates) -> (Phase, Coordinates) {
        let (at, forces) = self.seen(Phase { contact: ContactMode::Rolling, passed }, y);
        let phase = Phase { contact: ContactMode::Sliding, passed };
        (phase, self.let_go(&forces, self.settled(&at, y)))
    }
}

impl<F: TipFriction, R: ResistingMoment, E: Effect> Phased<14> for Scene<'_, F, R, E> {
    type Phase = Phase;

    #[inline]
    fn derivative(&self, phase: Phase, y: &Coordinates) -> Coordinates {
        let (at, forces) = self.seen(phase, y);
        let force = forces.friction + SpaceVector::new(0.0, 0.0, forces.normal);
        let moved = force + self.top.gravity() * self.top.shape().mass();
        let torque = at.arm.cross(&force) + forces.couple + forces.torque;
        let spin = at.spin();
        let [w, x, y, z] = [y[0], y[1], y[2], y[3]];
        // The frame turns with the axis, but does not spin.
        let [a, b, c] = (at.angular_velocity - at.axis * spin).to_array();
        let [vx, vy, vz] = at.velocity.to_array();
        [
            -0.5 * (a * x + b * y + c * z),
            0.5 * (a * w + b * z - c * y),
            0.5 * (b * w + c * x - a * z),
            0.5 * (c * w + a * y - b * x),
            spin,
            torque.x(),
            torque.y(),
            torque.z(),
            vx,
            vy,
            vz,
            moved.x(),
            moved.y(),
            moved.z(),
        ]
    }

    fn conditions(&self, phase: Phase) -> Vec<Condition<'_, Phase, 14>> {
        let mut conditions =
            vec![Condition::contact("lifts off", move |y| self.seen(phase, y).1.normal, Next::End)];
        if self.top.shape().rim.is_some() {
            let clearance = |y: &Coordinates| self.top.shape().clearance(axis(y));
            conditions.push(Condition::gap("falls", clearance, Next::End));
        }
        let passed = phase.passed;
        if F::STICKS && F::SLIDES {
            match phase.contact {
                ContactMode::Sliding => conditions.push(Condition::gap(
                    "grips",
                    move |y| {
                        let slip = self.top.configuration(phase, y).slip;
                        hypot(slip.x(), slip.y()) - self.stopped()
                    },
                    Next::decide(move |_, y| Ok(self.stuck(passed, y))),
                )),
                ContactMode::Rolling => conditions.push(Condition::gap(
                    "slips",
                    move |y| {
                        let forces = self.seen(phase, y).1;
                        let force = hypot(forces.friction.x(), forces.friction.y());
                        self.top.friction.holds() * forces.normal - force
                    },
                    Next::decide(move |_, y| Ok(self.slides(passed, y))),
                )),
            }
        }
        if let Some(mark) = self.top.marks.get(passed) {
            let next = Phase { passed: passed + 1, ..phase };
            let margin =
                move |y: &Coordinates| (mark.margin)(&self.top.configuration(phase, y), mark.value);
            conditions.push(Condition::gap(mark.name, margin, Next::Enter(next)));
        }
        conditions
    }

    fn scale(&self, y: &Coordinates) -> Coordinates {
        let shape = self.top.shape();
        let momentum = hypot(hypot(y[5], y[6]), y[7]);
        let least = shape.moments()[0] * self.speed() / (shape.lever().abs() + shape.tip());
        let turning = momentum.max(least);
        let size = shape.lever().abs() + shape.tip();
        let moving = shape.mass() * self.speed();
        [
            1.0,
            1.0,
            1.0,
            1.0,
            y[4].abs().max(1.0),
            turning,
            turning,
            turning,
            y[8].abs().max(size),
            y[9].abs().max(size),
            size,
            moving,
            moving,
            moving,
        ]
    }
}

/// Checks that a start is one: all its numbers are finite.
pub(super) fn checked(y: Coordinates) -> Result<Coordinates> {
    for c in y {
        rotation_dynamics::error::finite("start of a top", c)?;
    }
    Ok(y)
}
