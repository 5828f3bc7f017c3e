//! A system of first-order differential equations.

use crate::error::{Error, Result, finite};

/// A system y' = f(t, y) of `N` first-order equations.
pub trait Ode<const N: usize> {
    /// f(t, y).
    fn derivative(&self, t: f64, y: &[f64; N]) -> [f64; N];

    /// The size against which an error in each component counts: an adaptive
    /// method asked for the tolerance 1e-9 holds the error of `y[i]` near
    /// 1e-9 of `scale(y)[i]` in each step.
    ///
    /// The default, the larger of |y_i| and 1, suits components of order 1.
    /// Give your own where units or sizes differ. Each must be positive.
    fn scale(&self, y: &[f64; N]) -> [f64; N] {
        y.map(|c| c.abs().max(1.0))
    }
}

impl<const N: usize, O: Ode<N> + ?Sized> Ode<N> for &O {
    fn derivative(&self, t: f64, y: &[f64; N]) -> [f64; N] {
        (**self).derivative(t, y)
    }
    fn scale(&self, y: &[f64; N]) -> [f64; N] {
        (**self).scale(y)
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
        Err(Error::DerivativeNotFinite {
            t,
            state: y.to_vec(),
            derivative: derivative.to_vec(),
        })
    }
}
