//! A system behind a pointer: the loop over its stages is compiled for each system, all else
//! once for all of a size.

use super::coefficients::{A, C, STAGES};
use super::trial::Trial;
use crate::error::Result;
use crate::integrators::explicit::combination;
use crate::integrators::ode::not_finite;
use crate::integrators::{Ode, Work};
use crate::math::lane::write_finite;

/// A system that gives the slopes of a step. Behind a pointer, derivative by derivative, a step of a
/// small system takes up to 70 % longer.
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
        let mut newest = step.k[0];
        for i in 1..STAGES {
            let (at, y) = step.stage(i, h, &newest);
            work.derivatives += 1;
            newest = self.0.derivative(at, &y);
            step.keep(i, at, &y, &newest)?;
        }
        Ok(())
    }
}

// In a module of the pages size counts, and these are compiled once; elsewhere they are part of
// the loop.
impl<const N: usize> Trial<N> {
    /// The time and the state of stage `i` of a step by `h`, where the newest slope is `newest`.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    fn stage(&self, i: usize, h: f64, newest: &[f64; N]) -> (f64, [f64; N]) {
        // As `explicit::stage` has it; but the newest slope, for which all waits, comes last and
        // from a register.
        let [earlier @ .., (_, weight)] = A[i] else {
            unreachable!("every stage but the first has weights");
        };
        // The sum is no part of y, which the system sees: it stays in registers, term by term.
        let sum = combination(earlier, &self.k);
        let start = self.start.value;
        let mut y = start;
        for n in 0..N {
            y[n] = start[n] + h * (sum[n] + weight * newest[n]);
        }
        (self.t + C[i] * h, y)
    }

    /// Puts the slope of stage `i` where it belongs.
    #[cfg_attr(target_arch = "wasm32", inline(never))]
    #[cfg_attr(not(target_arch = "wasm32"), inline(always))]
    fn keep(&mut self, i: usize, at: f64, y: &[f64; N], slope: &[f64; N]) -> Result<()> {
        if write_finite(slope, &mut self.k[i]) {
            return Ok(());
        }
        Err(not_finite(at, y, &self.k[i]))
    }
}
