//! A rigid body and its state.
//!
//! The body axes are principal axes through the centre of mass or through a
//! fixed point; the moments refer to the same point. The state is attitude and
//! angular momentum, not angular velocity: without torque the momentum is
//! constant in space, so it is the variable that costs no accuracy. A body whose axes are
//! not its principal ones is a [`DesignedBody`].
//!
//! Not for: torques on the body ([`crate::effects`]) or how it moves ([`crate::exact`],
//! [`crate::integrators`]).

mod designed;

pub use designed::{DesignState, DesignedBody};

use crate::attitude::Attitude;
use crate::error::{Result, finite};
use crate::frame::{BodyVector, SpaceVector};
use crate::inertia::PrincipalMoments;

/// A rigid body: its principal moments, on its own axes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidBody {
    moments: PrincipalMoments,
}

/// Where a body is in its motion: how it is turned, and its angular momentum on
/// the fixed axes (kg m^2/s).
///
/// The fields are open for those who integrate; [`State::new`] checks them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// The rotation principal axes -> space. (Of a [`DesignedBody`] the axes of its drawing are
    /// turned as [`DesignState::attitude`] says.)
    pub attitude: Attitude,
    /// Angular momentum about the body's reference point, on the fixed axes.
    pub angular_momentum: SpaceVector,
}

/// How a body is turned and how fast it turns, on its own axes (rad/s).
///
/// The quantities that a closed form knows at first hand, and a batch delivers. It needs no moments
/// of inertia, where a [`State`] does. It keeps the small rates of a body that turns fast about
/// another axis: a momentum on the fixed axes has no digits for a part below 1e-16 of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kinematics {
    /// The rotation body -> space.
    pub attitude: Attitude,
    /// Angular velocity on the body's axes.
    pub angular_velocity: BodyVector,
}

impl Kinematics {
    /// With this attitude and angular velocity (rad/s).
    #[inline]
    pub const fn new(attitude: Attitude, angular_velocity: BodyVector) -> Self {
        Self { attitude, angular_velocity }
    }

    /// Without rotation, turned as space is: a list is filled with it before a batch.
    pub const REST: Self = Self::new(Attitude::IDENTITY, BodyVector::zero());

    /// True if no component is NaN or infinite.
    #[inline]
    pub fn is_finite(&self) -> bool {
        self.attitude.quaternion().iter().all(|c| c.is_finite())
            && self.angular_velocity.is_finite()
    }
}

impl State {
    /// The state with this attitude and angular momentum (kg m^2/s).
    ///
    /// Errors: a component that is not finite.
    pub fn new(attitude: Attitude, angular_momentum: SpaceVector) -> Result<Self> {
        for (name, value) in ["L_X", "L_Y", "L_Z"].into_iter().zip(angular_momentum.to_array()) {
            finite(name, value)?;
        }
        Ok(Self { attitude, angular_momentum })
    }
}

impl RigidBody {
    /// The body with these principal moments (kg m^2).
    #[inline]
    pub const fn new(moments: PrincipalMoments) -> Self {
        Self { moments }
    }

    /// The principal moments.
    #[inline]
    pub const fn moments(&self) -> PrincipalMoments {
        self.moments
    }

    /// The state of this body with an attitude and an angular velocity on its
    /// own axes (rad/s): L = R I omega.
    ///
    /// Errors: components that are not finite, or a momentum beyond `f64`.
    /// Source: notes 15.4.
    pub fn state(&self, attitude: Attitude, angular_velocity: BodyVector) -> Result<State> {
        let [i1, i2, i3] = self.moments.to_array();
        let [w1, w2, w3] = angular_velocity.to_array();
        for (name, value) in [("omega_1", w1), ("omega_2", w2), ("omega_3", w3)] {
            finite(name, value)?;
        }
        State::new(attitude, attitude.to_space(BodyVector::new(i1 * w1, i2 * w2, i3 * w3)))
    }

    /// Attitude and angular velocity of this state. A rate below 1e-16 of
    /// |L|/I_i is rounding: see [`Kinematics`].
    #[inline]
    pub fn kinematics(&self, state: &State) -> Kinematics {
        Kinematics::new(state.attitude, self.angular_velocity(state))
    }

    /// Angular momentum on the body's axes, R^T L (kg m^2/s).
    #[inline]
    pub fn angular_momentum(&self, state: &State) -> BodyVector {
        state.attitude.to_body(state.angular_momentum)
    }

    /// Angular velocity on the body's axes, I^-1 R^T L (rad/s).
    ///
    /// Accuracy: component i within 6 eps |L|/I_i (the turning of L). Source: notes 15.4.
    #[inline]
    pub fn angular_velocity(&self, state: &State) -> BodyVector {
        let [l1, l2, l3] = self.angular_momentum(state).to_array();
        let [i1, i2, i3] = self.moments.to_array();
        BodyVector::new(l1 / i1, l2 / i2, l3 / i3)
    }

    /// Rotational kinetic energy, sum of L_i^2/(2 I_i) (J): a sum of positive
    /// terms. Source: notes 15.3.
    #[inline]
    pub fn kinetic_energy(&self, state: &State) -> f64 {
        let momentum = self.angular_momentum(state);
        0.5 * momentum.dot(&self.angular_velocity(state))
    }
}
