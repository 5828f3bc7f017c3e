//! The claims of an effect beside its torque.

use super::GravityAtLever;
use crate::math::smaller;

/// Which quantities of a motion an effect leaves alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Conserved {
    /// Kinetic plus potential energy.
    pub energy: bool,
    /// L_X, L_Y and L_Z: the effect has no torque about that fixed axis.
    pub momentum: [bool; 3],
    /// L_z, if the body is symmetric: the effect has no torque about its axis.
    pub axial_momentum: bool,
}

impl Conserved {
    /// Leaves everything alone.
    pub const ALL: Self = Self { energy: true, momentum: [true; 3], axial_momentum: true };

    /// Leaves nothing alone.
    pub const NONE: Self = Self { energy: false, momentum: [false; 3], axial_momentum: false };

    /// The quantities that both leave alone.
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

/// The variables of a torque, how smooth it is, and the quantities it leaves alone.
///
/// Each field is a claim, weakest in [`Properties::ANYTHING`]: write
/// `Properties { smooth: true, ..Properties::ANYTHING }` and claim what is so. A claim opens faster
/// methods; [`check`](super::check) holds it against the torque.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Properties {
    /// There is never a torque.
    pub torque_free: bool,
    /// The torque sees nothing of the body and its motion but the direction of the axis
    /// e3, not the time either, and has no component along it. Then splittings apply, and
    /// a symmetric body's spin can be taken out.
    pub axis_only: bool,
    /// The torque may depend on how the body turns.
    pub on_rates: bool,
    /// The torque may depend on the time.
    pub on_time: bool,
    /// Between its [`break_points`](super::Effect::break_points) the torque is an analytic
    /// function of time and state. Then methods of high order with equal steps apply;
    /// otherwise DOP853 alone is trusted, which shortens its steps where something jumps.
    /// Of this claim only jumps are looked for, not kinks.
    pub smooth: bool,
    /// The effect turns the body beyond I^-1 L, by its [`slip`](super::Effect::slip). Without
    /// this the slip is not asked for; an effect that has one and does not say so is refused.
    pub slips: bool,
    /// The effect is the weight of the body. A scene has one: a second does not build
    /// ([`Scene::with`](crate::scene::Scene::with)), and a list with two is refused.
    pub weight: bool,
    /// The quantities that the effect leaves alone.
    pub conserved: Conserved,
}

impl Properties {
    /// No torque at all.
    pub const NOTHING: Self = Self {
        torque_free: true,
        axis_only: true,
        on_rates: false,
        on_time: false,
        smooth: true,
        slips: false,
        weight: false,
        conserved: Conserved::ALL,
    };

    /// No claim: true of every effect that is a torque and nothing else.
    pub const ANYTHING: Self = Self {
        torque_free: false,
        axis_only: false,
        on_rates: true,
        on_time: true,
        smooth: false,
        slips: false,
        weight: false,
        conserved: Conserved::NONE,
    };

    /// The claims that hold for both together.
    pub const fn and(self, other: Self) -> Self {
        Self {
            torque_free: self.torque_free && other.torque_free,
            axis_only: self.axis_only && other.axis_only,
            on_rates: self.on_rates || other.on_rates,
            on_time: self.on_time || other.on_time,
            smooth: self.smooth && other.smooth,
            slips: self.slips || other.slips,
            weight: self.weight || other.weight,
            conserved: self.conserved.and(other.conserved),
        }
    }
}

/// How narrow the narrowest feature of a torque is: a pulse in time, or a bump on the way
/// of the attitude. Infinite where there is none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Feature {
    /// In time (s).
    pub time: f64,
    /// In the angle by which the body is turned (rad).
    pub angle: f64,
}

impl Feature {
    /// Nothing that a turn of the body or the span of a solution would step over.
    pub const WIDE: Self = Self { time: f64::INFINITY, angle: f64::INFINITY };

    /// The narrower of both; NaN if either is, which a solution refuses.
    pub const fn and(self, other: Self) -> Self {
        Self { time: smaller(self.time, other.time), angle: smaller(self.angle, other.angle) }
    }
}

/// The motions that have a closed form, by the effect that acts alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum IntegrableCase {
    /// None of them.
    None,
    /// No torque: any body.
    Free,
    /// The weight at a point of the axis: symmetric bodies.
    HeavyTop(GravityAtLever),
}

impl IntegrableCase {
    /// For two effects together: a closed form if one of them does nothing.
    pub const fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Free, other) | (other, Self::Free) => other,
            _ => Self::None,
        }
    }
}
