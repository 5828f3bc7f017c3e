//! A system behind a pointer: the method is compiled once for all systems of a size.

use crate::integrators::Ode;

/// An [`Ode`] of any type, a pointer among them.
pub(super) struct ByRef<'o, O: ?Sized>(pub &'o O);

impl<const N: usize, O: Ode<N> + ?Sized> Ode<N> for ByRef<'_, O> {
    fn derivative(&self, t: f64, y: &[f64; N]) -> [f64; N] {
        self.0.derivative(t, y)
    }
    fn scale(&self, y: &[f64; N]) -> [f64; N] {
        self.0.scale(y)
    }
    fn drift(&self, t: f64, y: &[f64; N], within: f64) -> Option<[f64; N]> {
        self.0.drift(t, y, within)
    }
}
