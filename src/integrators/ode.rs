//! A system of first-order differential equations.

use crate::error::{Error, FINITE, Result, finite};
use crate::frame::SpaceVector;
use crate::math::hypot;

/// A system y' = f(t, y) of `N` first-order equations.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a system of first-order equations",
    note = "an `ode(..)` or `newton(..)` becomes one by the sizes against which errors count: \
            `.scaled(size_or([1.0; {N}]))`, or any other size of each component"
)]
pub trait Ode<const N: usize> {
    /// f(t, y).
    fn derivative(&self, t: f64, y: &[f64; N]) -> [f64; N];

    /// The size against which an error in each component counts: an adaptive
    /// method asked for the tolerance 1e-9 holds the error of `y[i]` near
    /// 1e-9 of `scale(y)[i]` in each step. Each must be positive.
    ///
    /// [`size_or`] is the usual one. A scale far above a component costs its digits: an
    /// oscillation of amplitude 1e-6 that counts against 1 keeps six digits fewer.
    fn scale(&self, y: &[f64; N]) -> [f64; N];

    /// How far `y`, the end of a step, is off a quantity that the solution keeps (a shut contact, a
    /// norm) and a method does not. None if it is off by no more than the part `within`
    /// of its size, or if nothing is kept.
    ///
    /// [`Dop853`](super::Dop853) takes it away at the end of a step, with a tenth of the error
    /// of a step for `within`: small as it is, it would grow for as long as nothing happens.
    fn drift(&self, _t: f64, _y: &[f64; N], _within: f64) -> Option<[f64; N]> {
        None
    }
}

impl<const N: usize, O: Ode<N> + ?Sized> Ode<N> for &O {
    fn derivative(&self, t: f64, y: &[f64; N]) -> [f64; N] {
        (**self).derivative(t, y)
    }
    fn scale(&self, y: &[f64; N]) -> [f64; N] {
        (**self).scale(y)
    }
    fn drift(&self, t: f64, y: &[f64; N], within: f64) -> Option<[f64; N]> {
        (**self).drift(t, y, within)
    }
}

/// The usual [`scale`](Ode::scale): the size |y_i| of each component, but no less than `least`.
///
/// ```
/// use rotation_dynamics::integrators::size_or;
/// assert_eq!(size_or([1e-6, 1.0])(&[-3.0, 0.2]), [3.0, 1.0]);
/// ```
#[inline]
pub fn size_or<const N: usize>(least: [f64; N]) -> impl Fn(&[f64; N]) -> [f64; N] + Copy {
    move |y| core::array::from_fn(|i| y[i].abs().max(least[i]))
}

/// The system y' = f(t, y) by a closure, with its scale, none before it is
/// [`scaled`](ByClosure::scaled); see [`ode`].
#[derive(Debug, Clone, Copy)]
pub struct ByClosure<F, S = ()> {
    derivative: F,
    scale: S,
}

/// The system y' = f(t, y), once [`scaled`](ByClosure::scaled) gives the sizes against which errors
/// count.
///
/// ```
/// use rotation_dynamics::integrators::{Dop853, Integrator, size_or, ode};
/// let spring = |rate: f64| ode(move |_, [x, v]: &[f64; 2]| [*v, -rate * rate * x]);
/// let spring = spring(2.0).scaled(size_or([1.0; 2]));
/// let (end, _) = Dop853::new(1e-13)?.advance(&spring, 0.0, &[1.0, 0.0], 1.0)?;
/// assert!((end[0] - rotation_dynamics::math::cos(2.0)).abs() < 1e-13);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
///
/// Without these sizes it does not compile:
///
/// ```compile_fail,E0277
/// use rotation_dynamics::integrators::{Dop853, Integrator, ode};
/// let spring = ode(|_, [x, v]: &[f64; 2]| [*v, -x]);
/// Dop853::new(1e-13)?.advance(&spring, 0.0, &[1e-6, 0.0], 1.0)?;
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub const fn ode<const N: usize, F: Fn(f64, &[f64; N]) -> [f64; N]>(derivative: F) -> ByClosure<F> {
    ByClosure { derivative, scale: () }
}

impl<F> ByClosure<F> {
    /// With this [`scale`](Ode::scale), the size against which an error counts.
    pub fn scaled<const N: usize, S>(self, scale: S) -> ByClosure<F, S>
    where
        F: Fn(f64, &[f64; N]) -> [f64; N],
        S: Fn(&[f64; N]) -> [f64; N],
    {
        let derivative = self.derivative;
        ByClosure { derivative, scale }
    }
}

/// A point of mechanics with one coordinate, `[x, x']`: x'' = `acceleration(t, x, x')`.
///
/// An error counts against x and x' together, so both should be of one size: take a unit
/// of time in which the motion is neither slow nor fast.
///
/// ```
/// use rotation_dynamics::integrators::{Dop853, Integrator, second_order};
/// let damped = |rate: f64| second_order(move |_t, x, v| -x - 2.0 * rate * v);
/// let (end, _) = Dop853::new(1e-13)?.advance(&damped(1.0), 0.0, &[1.0, -1.0], 1.0)?;
/// assert!((end[0] - rotation_dynamics::math::exp(-1.0)).abs() < 1e-13);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub fn second_order(acceleration: impl Fn(f64, f64, f64) -> f64) -> impl Ode<2> {
    ode(move |t, &[x, v]: &[f64; 2]| [v, acceleration(t, x, v)])
        .scaled(|&[x, v]| [hypot(x, v).max(1e-30); 2])
}

/// A particle in space, `[x, y, z, x', y', z']`, by Newton's law: its acceleration at the
/// time t, of its place and its velocity. As an [`ode`], it is to be scaled.
///
/// ```
/// use rotation_dynamics::integrators::{Dop853, Integrator, size_or, newton, place_and_velocity};
/// // About a centre that attracts with 1/r^2, on a circle.
/// let attracted = newton(|_t, [r, _v]| r * -r.norm().powi(-3)).scaled(size_or([1.0; 6]));
/// let turn = core::f64::consts::TAU;
/// let start = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
/// let (end, _) = Dop853::new(1e-13)?.advance(&attracted, 0.0, &start, turn)?;
/// let [place, velocity] = place_and_velocity(&end);
/// assert!((place.x() - 1.0).abs() < 1e-12 && (velocity.y() - 1.0).abs() < 1e-12);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub fn newton(
    acceleration: impl Fn(f64, [SpaceVector; 2]) -> SpaceVector,
) -> ByClosure<impl Fn(f64, &[f64; 6]) -> [f64; 6]> {
    ode(move |t, state| {
        let [place, velocity] = place_and_velocity(state);
        let [ax, ay, az] = acceleration(t, [place, velocity]).to_array();
        let [vx, vy, vz] = velocity.to_array();
        [vx, vy, vz, ax, ay, az]
    })
}

/// Place and velocity of a particle, from a state of [`newton`].
pub fn place_and_velocity(&[x, y, z, vx, vy, vz]: &[f64; 6]) -> [SpaceVector; 2] {
    [[x, y, z], [vx, vy, vz]].map(SpaceVector::from_array)
}

impl<const N: usize, F, S> Ode<N> for ByClosure<F, S>
where
    F: Fn(f64, &[f64; N]) -> [f64; N],
    S: Fn(&[f64; N]) -> [f64; N],
{
    fn derivative(&self, t: f64, y: &[f64; N]) -> [f64; N] {
        (self.derivative)(t, y)
    }
    fn scale(&self, y: &[f64; N]) -> [f64; N] {
        (self.scale)(y)
    }
}

/// Checks what every method is given: finite times, finite state.
pub(super) fn check_span<const N: usize>(t: f64, y: &[f64; N], t_end: f64) -> Result<()> {
    finite("start time", t)?;
    finite("end time", t_end)?;
    finite("end time - start time", t_end - t)?;
    y.iter().try_for_each(|c| finite("state", *c).map(|_| ()))
}

/// Returns `derivative` if all its components are finite.
pub(super) fn finite_derivative<const N: usize>(
    t: f64,
    y: &[f64; N],
    derivative: [f64; N],
) -> Result<[f64; N]> {
    if derivative.iter().all(|d| d.is_finite()) {
        Ok(derivative)
    } else {
        Err(not_finite(t, y, &derivative))
    }
}

/// The error of a derivative that is not finite.
#[cold]
#[inline(never)]
pub(super) fn not_finite(t: f64, y: &[f64], derivative: &[f64]) -> Error {
    Error::of_function("derivative", t, ("y", y.to_vec()), derivative, FINITE)
}
