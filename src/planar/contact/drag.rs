//! Forces that a mechanism may have in addition: the drag of what it moves through.
//!
//! A force is part of the type ([`With`]): a mechanism without drag has no place for it and
//! does not ask.

use super::declare::dot;
use super::{Contact, Mechanism, MechanismState};
use crate::error::{Result, positive};
use crate::math::{asinh, expm1, hypot};

/// A generalized force that depends on the state: drag, a wind, a spring.
pub trait Load<const N: usize> {
    /// Its components (N, and N m along an angle).
    fn force(&self, state: &MechanismState<N>) -> [f64; N];

    /// Its power (W): below 0 what it takes away.
    fn power(&self, state: &MechanismState<N>) -> f64 {
        dot(&self.force(state), &state.v)
    }
}

/// A mechanism with one more [`Load`]; made by [`Mechanism::with`].
///
/// ```
/// use rotation_dynamics::planar::contact::{Contact, Mechanism, QuadraticDrag, MechanismState, motion_within};
/// use rotation_dynamics::math::{exp, log};
///
/// /// A stone of 1 kg that falls.
/// struct Stone;
/// impl Mechanism<3, 0> for Stone {
///     fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
///         [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.1]]
///     }
///     fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
///         [0.0, -10.0, 0.0]
///     }
///     fn contacts(&self, _: &MechanismState<3>) -> [Contact<3>; 0] {
///         []
///     }
/// }
/// # fn main() -> rotation_dynamics::Result<()> {
/// // c = 0.1 kg/m: it ends at 10 m/s, as tanh(t/1 s).
/// let falls = Stone.with(QuadraticDrag::new(0.1)?);
/// let speed = motion_within(&falls, 1e-12, MechanismState::rest([0.0; 3]), 1.0)?.at(1.0)?.v[1];
/// let tanh = (exp(2.0) - 1.0) / (exp(2.0) + 1.0);
/// assert!((speed + 10.0 * tanh).abs() < 1e-11);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy)]
pub struct With<M, F> {
    mechanism: M,
    load: F,
}

impl<M, F> With<M, F> {
    pub(super) const fn new(mechanism: M, load: F) -> Self {
        Self { mechanism, load }
    }

    /// The mechanism without it.
    pub const fn mechanism(&self) -> &M {
        &self.mechanism
    }

    /// The load.
    pub const fn load(&self) -> &F {
        &self.load
    }
}

impl<M, F, const N: usize, const C: usize> Mechanism<N, C> for With<M, F>
where
    M: Mechanism<N, C>,
    F: Load<N>,
{
    fn mass(&self, q: &[f64; N]) -> [[f64; N]; N] {
        self.mechanism.mass(q)
    }
    fn force(&self, state: &MechanismState<N>) -> [f64; N] {
        let (own, more) = (self.mechanism.force(state), self.load.force(state));
        core::array::from_fn(|j| own[j] + more[j])
    }
    fn contacts(&self, state: &MechanismState<N>) -> [Contact<N>; C] {
        self.mechanism.contacts(state)
    }
    fn end(&self, state: &MechanismState<N>) -> Option<(&'static str, f64)> {
        self.mechanism.end(state)
    }
    fn scale(&self, state: &MechanismState<N>) -> MechanismState<N> {
        self.mechanism.scale(state)
    }
    fn phase_limit(&self) -> usize {
        self.mechanism.phase_limit()
    }
}

/// Drags of a body with the coordinates `[x, y, angle]`.
macro_rules! drags {
    ($( $(#[$doc:meta])+ $drag:ident, $unit:literal, |$coefficient:ident, $v:ident| $force:expr; )+) => { $(
        $(#[$doc])+
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $drag {
            coefficient: f64,
        }

        impl $drag {
            #[doc = concat!("The drag with this coefficient (", $unit, ", positive).")]
            ///
            /// # Errors
            /// A coefficient that is not positive and finite.
            pub fn new(coefficient: f64) -> Result<Self> {
                positive("coefficient of drag", coefficient)?;
                Ok(Self { coefficient })
            }

            #[doc = concat!("The coefficient (", $unit, ").")]
            pub const fn coefficient(&self) -> f64 {
                self.coefficient
            }
        }

        impl Load<3> for $drag {
            #[inline]
            fn force(&self, state: &MechanismState<3>) -> [f64; 3] {
                let ($coefficient, $v) = (self.coefficient, state.v);
                $force
            }
        }
    )+ };
}

drags! {
    /// Drag on the centre in proportion to the speed, F = -c v: of what creeps through a liquid.
    ///
    /// Range of validity: Reynolds numbers below 1; a ball of radius r has c = 6 pi eta r.
    /// The number that it is judged by: c v over the driving force.
    ///
    /// Source: G. G. Stokes, *Trans. Camb. Phil. Soc.* 9 (1851).
    LinearDrag, "kg/s", |c, v| [-c * v[0], -c * v[1], 0.0];

    /// Drag on the centre with the square of the speed, F = -c |v| v, c = rho C_d A/2: of what
    /// moves through air ([`in_air`](QuadraticDrag::in_air)).
    ///
    /// Range of validity: Reynolds numbers from 1e3 to 1e5, where C_d is 0.4 to 0.5 for a ball and
    /// 1.0 to 1.2 for a cylinder across the flow. The number that it is judged by: Pi_D =
    /// rho C_d A v^2/2 over the driving force ([`number`](QuadraticDrag::number)).
    ///
    /// Source: H. Schlichting, K. Gersten, *Boundary-Layer Theory*, 1.
    QuadraticDrag, "kg/m", |c, v| {
        let speed = hypot(v[0], v[1]);
        [-c * speed * v[0], -c * speed * v[1], 0.0]
    };

    /// Drag on the rotation in proportion to its rate, M = -c omega: oil in a bearing, and a
    /// disc so slow that the air about it is all boundary layer.
    ///
    /// The number that it is judged by: c omega over the driving torque.
    LinearSpinDrag, "N m s", |c, v| [0.0, 0.0, -c * v[2]];

    /// Drag on the rotation with the square of its rate, M = -c |omega| omega: a paddle, or a
    /// disc in turbulent air but for its exponent of 1.8.
    ///
    /// The number that it is judged by: c omega^2 over the driving torque.
    QuadraticSpinDrag, "N m s^2", |c, v| [0.0, 0.0, -c * v[2].abs() * v[2]];
}

impl QuadraticDrag {
    /// The drag of a body with this coefficient C_d and frontal area (m^2) in a medium of this
    /// density (kg/m^3).
    ///
    /// # Errors
    /// Any of the three that is not positive and finite.
    pub fn in_air(density: f64, coefficient: f64, area: f64) -> Result<Self> {
        positive("density", density)?;
        positive("C_d", coefficient)?;
        positive("frontal area", area)?;
        Self::new(0.5 * density * coefficient * area)
    }

    /// Time (s) and speed (m/s) at the end of this way (m), from rest, for a body that would get
    /// faster by `acceleration` (m/s^2) without the drag and has this inertia (kg) along the way.
    /// With `d` = c/inertia, `cosh(t sqrt(a d)) = exp(d s)` and `v^2 = (1 - exp(-2 d s)) a/d`.
    ///
    /// ```
    /// use rotation_dynamics::planar::contact::QuadraticDrag;
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// // Far down it falls as fast as it can, sqrt(a/d).
    /// let [_, speed] = QuadraticDrag::new(0.1)?.driven(10.0, 1.0, 200.0);
    /// assert!((speed - 10.0).abs() < 1e-14);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// Accuracy: 2.4 eps (`tests/planar/resistance.rs`).
    pub fn driven(&self, acceleration: f64, inertia: f64, way: f64) -> [f64; 2] {
        let slowing = self.coefficient / inertia;
        // Both stay exact where there is next to no drag.
        let (grown, left) = (expm1(2.0 * slowing * way), -expm1(-2.0 * slowing * way));
        let time = asinh(grown.sqrt()) / (slowing * acceleration).sqrt();
        [time, (acceleration / slowing * left).sqrt()]
    }

    /// Pi_D: the drag at this speed (m/s) over the driving force (N).
    pub fn number(&self, speed: f64, driving_force: f64) -> f64 {
        self.coefficient * speed * speed / driving_force
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On a piece of the way the time that goes by is the way over the speed.
    #[test]
    fn the_time_is_that_of_the_speed() {
        let drag = QuadraticDrag::new(0.3).expect("a drag");
        let (way, h) = (1.7, 1e-3);
        let time = |k: f64| drag.driven(9.8, 2.0, way + k * h)[0];
        let slowness = (8.0 * (time(1.0) - time(-1.0)) - (time(2.0) - time(-2.0))) / (12.0 * h);
        let [_, speed] = drag.driven(9.8, 2.0, way);
        assert!((slowness * speed - 1.0).abs() < 1e-10, "{speed}");
    }
}
