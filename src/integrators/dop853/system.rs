//! A system behind a pointer: the loop over its stages is compiled for each system, all else
//! once for all of a size.

use super::coefficients::{A, C, STAGES};
use super::trial::Trial;
use crate::error::Result;
use crate::integrators::explicit::combination;
use crate::integrators::ode::not_finite;
use crate::integrators::{Ode, Work};
use crate::math::lane::write_finite;

/// The questions of a step to a system, whatever its type.
pub(super) trait System<const N: usize>: Ode<N> {
    /// The slopes of a step by `h` after the first. Eleven derivatives.
    fn stages(&self, step: &mut Trial<N>, h: f64, work: &mut Work) -> Result<()>;
}

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

impl<const N: usize, O: Ode<N> + ?Sized> System<N> for ByRef<'_, O> {
    fn stages(&self, step: &mut Trial<N>, h: f64, work: &mut Work) -> Result<()> {
        let start = step.start.value;
        let mut newest = step.k[0];
        for i in 1..STAGES {
            let at = step.t + C[i] * h;
            // As `stage` has it; but the newest slope, for which all waits, comes last and
            // from a register.
            let [earlier @ .., (_, weight)] = A[i] else {
                unreachable!("every stage but the first has weights");
            };
            // The sum is no part of y, which the system sees: it stays in registers, term by term.
            let sum = combination(earlier, &step.k);
            let mut y = start;
            for n in 0..N {
                y[n] = start[n] + h * (sum[n] + weight * newest[n]);
            }
            work.derivatives += 1;
            newest = self.0.derivative(at, &y);
            if !write_finite(&newest, &mut step.k[i]) {
                return Err(not_finite(at, &y, &step.k[i]));
            }
        }
        Ok(())
    }
}
