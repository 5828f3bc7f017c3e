//! Effects: what acts on a body, one file per effect.
//!
//! An [`Effect`] knows the torque it exerts, its potential energy if it has
//! one, and which quantities it leaves alone. Effects are composed in the type:
//! `()` is no effect, and a pair of effects is an effect. What a scene does not
//! name is not stored, not called and not asked about.
//!
//! | effect | torque |
//! |---|---|
//! | [`GravityAtLever`] | the weight of a body held at a point of its axis |
//!
//! Not for: contacts, which switch on and off ([`crate::planar`]).

mod gravity;

pub use gravity::GravityAtLever;

use crate::body::{RigidBody, State};
use crate::frame::SpaceVector;
use crate::math::Lane;
use crate::math::lane::WIDEST;

/// Which quantities of a motion an effect leaves alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Keeps {
    /// Kinetic plus potential energy.
    pub energy: bool,
    /// L_X, L_Y and L_Z: the effect has no torque about that fixed axis.
    pub momentum: [bool; 3],
    /// L_z, if the body is symmetric: the effect has no torque about its axis.
    pub axial_momentum: bool,
}

impl Keeps {
    /// Leaves everything alone.
    pub const ALL: Self = Self {
        energy: true,
        momentum: [true; 3],
        axial_momentum: true,
    };

    /// What both leave alone.
    pub const fn and(self, other: Self) -> Self {
        let [ax, ay, az] = self.momentum;
        let [bx, by, bz] = other.momentum;
        Self {
            energy: self.energy && other.energy,
            momentum: [ax && bx, ay && by, az && bz],
            axial_momentum: self.axial_momentum && other.axial_momentum,
        }
    }
}

/// Something that acts on a body.
pub trait Effect {
    /// The quantities this effect leaves alone, whatever the state.
    const KEEPS: Keeps;

    /// The torque about the body's reference point, on the fixed axes (N m).
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector;

    /// The potential energy (J); 0 for an effect that has none.
    fn potential_energy(&self, state: &State) -> f64;

    /// A bound on the length of the torque (N m), or an estimate of its usual
    /// size: the scale against which errors of the momentum count.
    fn torque_scale(&self) -> f64;
}

/// An effect that sees nothing of the body but the direction of its axis e3,
/// and has no torque about that axis.
///
/// Splittings apply; on a symmetric body it leaves the spin to itself.
pub trait AxisEffect: Effect {
    /// The torque on a body whose axis has this direction, on the fixed axes
    /// (N m). It is perpendicular to the axis.
    fn axis_torque(&self, axis: SpaceVector) -> SpaceVector;

    /// The same for several directions side by side, with the same bits.
    ///
    /// This form takes one after the other. An effect that writes its own, over
    /// [`Lane`] and marked `#[inline(always)]`, lets [`GaussLegendre`] fill its
    /// registers.
    ///
    /// [`GaussLegendre`]: crate::integrators::GaussLegendre
    #[inline(always)]
    fn axis_torques<L: Lane>(&self, axis: [L; 3]) -> [L; 3] {
        let (mut from, mut to) = ([[0.0; WIDEST]; 3], [[0.0; WIDEST]; 3]);
        for i in 0..3 {
            axis[i].store(&mut from[i]);
        }
        for lane in 0..L::WIDTH {
            let axis = SpaceVector::new(from[0][lane], from[1][lane], from[2][lane]);
            let torque = self.axis_torque(axis).to_array();
            for i in 0..3 {
                to[i][lane] = torque[i];
            }
        }
        [L::load(&to[0]), L::load(&to[1]), L::load(&to[2])]
    }
}

/// No effect.
impl Effect for () {
    const KEEPS: Keeps = Keeps::ALL;

    #[inline]
    fn torque(&self, _t: f64, _body: &RigidBody, _state: &State) -> SpaceVector {
        SpaceVector::zero()
    }

    #[inline]
    fn potential_energy(&self, _state: &State) -> f64 {
        0.0
    }

    #[inline]
    fn torque_scale(&self) -> f64 {
        0.0
    }
}

impl AxisEffect for () {
    #[inline]
    fn axis_torque(&self, _axis: SpaceVector) -> SpaceVector {
        SpaceVector::zero()
    }

    #[inline(always)]
    fn axis_torques<L: Lane>(&self, _axis: [L; 3]) -> [L; 3] {
        [L::of(0.0); 3]
    }
}

/// Two effects together.
impl<A: Effect, B: Effect> Effect for (A, B) {
    const KEEPS: Keeps = A::KEEPS.and(B::KEEPS);

    #[inline]
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state) + self.1.torque(t, body, state)
    }

    #[inline]
    fn potential_energy(&self, state: &State) -> f64 {
        self.0.potential_energy(state) + self.1.potential_energy(state)
    }

    #[inline]
    fn torque_scale(&self) -> f64 {
        self.0.torque_scale() + self.1.torque_scale()
    }
}

impl<A: AxisEffect, B: AxisEffect> AxisEffect for (A, B) {
    #[inline]
    fn axis_torque(&self, axis: SpaceVector) -> SpaceVector {
        self.0.axis_torque(axis) + self.1.axis_torque(axis)
    }

    #[inline(always)]
    fn axis_torques<L: Lane>(&self, axis: [L; 3]) -> [L; 3] {
        let [a, b, c] = self.0.axis_torques(axis);
        let [d, e, f] = self.1.axis_torques(axis);
        [a + d, b + e, c + f]
    }
}
