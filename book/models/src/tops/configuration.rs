//! The quantities of a moment: velocities, forces, energies.

use super::{ContactMode, Phase, ResistingMoment, TipFriction, Top};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::State;
use rotation_dynamics::effects::Effect;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::{atan2, hypot, sincos};

/// A top at a moment, on the axes of the floor: Z is its normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Configuration {
    /// The axis e3.
    pub axis: SpaceVector,
    /// Angular velocity (rad/s).
    pub angular_velocity: SpaceVector,
    /// Angular momentum about the centre of mass (kg m^2/s).
    pub angular_momentum: SpaceVector,
    /// The centre of mass (m).
    pub centre: SpaceVector,
    /// Its velocity (m/s).
    pub velocity: SpaceVector,
    /// From the centre of mass to the contact (m).
    pub arm: SpaceVector,
    /// The velocity of the tip's material at the contact (m/s): level, zero if it rolls.
    pub slip: SpaceVector,
}

impl Configuration {
    /// The angle between the axis and the normal of the floor (rad).
    pub fn tilt(&self) -> f64 {
        atan2(hypot(self.axis.x(), self.axis.y()), self.axis.z())
    }

    /// The spin: angular velocity along the axis (rad/s).
    pub fn spin(&self) -> f64 {
        self.angular_velocity.dot(&self.axis)
    }

    /// The angular velocity (rad/s) at which the axis goes round the normal of the floor; not
    /// a number where the axis is upright.
    pub fn precession(&self) -> f64 {
        let turned = self.angular_velocity.cross(&self.axis);
        let (x, y) = (self.axis.x(), self.axis.y());
        (x * turned.y() - y * turned.x()) / (x * x + y * y)
    }

    /// The point of contact (m).
    pub fn contact(&self) -> SpaceVector {
        self.centre + self.arm
    }
}

/// The forces of the floor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Forces {
    /// The normal force (N).
    pub normal: f64,
    /// The friction, level (N).
    pub friction: SpaceVector,
    /// Torque of the contact beside the torque of the forces: pivoting and resistances (N m).
    pub couple: SpaceVector,
    /// Torque of the effects on the body (N m).
    pub torque: SpaceVector,
}

/// The power (W) of each, negative where it takes energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Powers {
    /// The power of the friction of slip.
    pub sliding: f64,
    /// Of pivoting and resistances.
    pub couple: f64,
    /// The power of the effects on the body.
    pub effects: f64,
}

/// The coordinates: quaternion of a frame that follows the axis without spin, the angle of the
/// spin in it, angular momentum, centre of mass, momentum.
pub(super) type Coordinates = [f64; 14];

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

/// e3 of a quaternion that is unit but for the error of the steps.
#[inline]
pub(super) fn axis(&[w, x, y, z, ..]: &Coordinates) -> SpaceVector {
    let square = (w * w + z * z) + (x * x + y * y);
    let axis = SpaceVector::new(
        2.0 * (x * z + w * y),
        2.0 * (y * z - w * x),
        (w * w + z * z) - (x * x + y * y),
    );
    axis / square
}

impl<F: TipFriction, R: ResistingMoment, E: Effect> Top<F, R, E> {
    /// The body's attitude: of the coordinates of a run.
    pub fn attitude(&self, coordinates: &Coordinates) -> Attitude {
        let [w, x, y, z, spin, ..] = *coordinates;
        // Coordinates of a run are finite, and their quaternion is not zero.
        let (s, c) = sincos(0.5 * spin);
        let turned = [w * c - z * s, x * c + y * s, y * c - x * s, z * c + w * s];
        Attitude::from_quaternion(turned).unwrap_or(Attitude::IDENTITY)
    }

    /// The moment with these coordinates, in this phase.
    #[inline]
    pub fn configuration(&self, phase: Phase, coordinates: &Coordinates) -> Configuration {
        let [_, _, _, _, _, l1, l2, l3, x, y, _, p1, p2, _] = *coordinates;
        let shape = &self.shape;
        let axis = axis(coordinates);
        let angular_momentum = SpaceVector::new(l1, l2, l3);
        let along = angular_momentum.dot(&axis);
        let angular_velocity = angular_momentum / shape.across
            + axis * (along * (1.0 / shape.axial - 1.0 / shape.across));
        let arm = axis * -shape.lever - UP * shape.tip;
        let turning = angular_velocity.cross(&arm);
        // The tip stays on the floor: its contact has no velocity upward.
        let velocity = match phase.contact {
            ContactMode::Rolling => turning * -1.0,
            ContactMode::Sliding => {
                SpaceVector::new(p1 / shape.mass, p2 / shape.mass, -turning.z())
            }
        };
        let slip = velocity + turning;
        Configuration {
            axis,
            angular_velocity,
            angular_momentum,
            centre: SpaceVector::new(x, y, shape.tip + shape.lever * axis.z()),
            velocity,
            arm,
            slip: SpaceVector::new(slip.x(), slip.y(), 0.0),
        }
    }

    /// I^-1 of a vector.
    #[inline]
    fn turned_by(&self, axis: SpaceVector, torque: SpaceVector) -> SpaceVector {
        let Self { shape, .. } = self;
        let along = torque.dot(&axis) * (1.0 / shape.axial - 1.0 / shape.across);
        torque / shape.across + axis * along
    }

    /// The acceleration that a force at the contact and a torque give the contact.
    #[inline]
    fn response(&self, at: &Configuration, force: SpaceVector, torque: SpaceVector) -> SpaceVector {
        let spun = self.turned_by(at.axis, at.arm.cross(&force) + torque);
        force / self.shape.mass + spun.cross(&at.arm)
    }

    /// The forces of the floor on a top in this stance.
    #[inline]
    pub fn forces(&self, phase: Phase, at: &Configuration, coordinates: &Coordinates) -> Forces {
        let torque = if E::PROPERTIES.torque_free {
            SpaceVector::zero()
        } else {
            let state = State {
                attitude: self.attitude(coordinates),
                angular_momentum: at.angular_momentum,
            };
            self.effects.torque(0.0, &self.body, &state)
        };
        let omega = at.angular_velocity;
        let resistance = self.resistance.torque(omega);
        // What the contact would do without the floor.
        let gyroscopic = omega.cross(&at.angular_momentum);
        let turned = self.turned_by(at.axis, torque - gyroscopic).cross(&at.arm);
        let swung = omega.cross(&omega.cross(&at.axis)) * -self.shape.lever;
        let free = self.gravity + turned + swung;
        match phase.contact {
            ContactMode::Sliding => {
                let grip = self.friction.sliding(at.slip, omega.z());
                let (force, couple) = (UP + grip.force, resistance + UP * grip.torque);
                let normal = -free.z() / self.response(at, force, couple).z();
                Forces { normal, friction: grip.force * normal, couple: couple * normal, torque }
            }
            ContactMode::Rolling => {
                let x = self.response(at, SpaceVector::new(1.0, 0.0, 0.0), SpaceVector::zero());
                let y = self.response(at, SpaceVector::new(0.0, 1.0, 0.0), SpaceVector::zero());
                let z = self.response(at, UP, resistance);
                let whole = x.dot(&y.cross(&z));
                let part = |a: SpaceVector, b: SpaceVector| -free.dot(&a.cross(&b)) / whole;
                let normal = part(x, y);
                Forces {
                    normal,
                    friction: SpaceVector::new(part(y, z), part(z, x), 0.0),
                    couple: resistance * normal,
                    torque,
                }
            }
        }
    }

    /// Kinetic and potential energy (J), the latter from the origin of the floor.
    pub fn energy(&self, at: &Configuration) -> f64 {
        let turning = 0.5 * at.angular_velocity.dot(&at.angular_momentum);
        let moving = 0.5 * self.shape.mass * at.velocity.dot(&at.velocity);
        turning + moving - self.shape.mass * self.gravity.dot(&at.centre)
    }

    /// Jellett's integral L . (l e3 + r Z), N m s m: kept by every force at the contact.
    pub fn jellett(&self, at: &Configuration) -> f64 {
        -at.angular_momentum.dot(&at.arm)
    }

    /// The power of friction, of the couples and of the effects; together they change the
    /// energy.
    pub fn powers(&self, at: &Configuration, forces: &Forces) -> Powers {
        Powers {
            sliding: forces.friction.dot(&at.slip),
            couple: forces.couple.dot(&at.angular_velocity),
            effects: forces.torque.dot(&at.angular_velocity),
        }
    }

    /// Attitude on the axes of the floor, of a top that leans by `tilt` towards X.
    pub(super) fn leaning(tilt: f64) -> [f64; 4] {
        let (s, c) = sincos(0.5 * tilt);
        [c, 0.0, s, 0.0]
    }

    /// L of an angular velocity, for this axis.
    pub(super) fn momentum(&self, axis: SpaceVector, omega: SpaceVector) -> SpaceVector {
        let along = omega.dot(&axis) * (self.shape.axial - self.shape.across);
        omega * self.shape.across + axis * along
    }

    /// A point of the body, given from its centre of mass, on the axes of the floor (m).
    pub fn point(
        &self,
        coordinates: &Coordinates,
        at: &Configuration,
        from_centre: BodyVector,
    ) -> SpaceVector {
        at.centre + self.attitude(coordinates).to_space(from_centre)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tops::{Shape, Top};

    /// A tip that rolls does not slip; one that slides slips by v + omega x arm.
    #[test]
    fn what_rolls_does_not_slip() {
        let shape = Shape::new(0.1, 1e-4, 5e-5, 0.02, 0.005).expect("a shape");
        let top = Top::new(shape, 9.81).expect("a top");
        let y = [0.8, 0.36, 0.48, 0.0, 0.0, 2e-3, -1e-3, 5e-3, 0.1, 0.2, 0.02, 0.03, -0.01, 0.0];
        let at = |contact| top.configuration(Phase { contact, passed: 0 }, &y);
        assert_eq!(at(ContactMode::Rolling).slip, SpaceVector::zero());
        let sliding = at(ContactMode::Sliding);
        let want = sliding.velocity + sliding.angular_velocity.cross(&sliding.arm);
        assert_eq!(sliding.slip, SpaceVector::new(want.x(), want.y(), 0.0));
        assert!(want.z() == 0.0 && want.norm() > 0.1);
    }
}
