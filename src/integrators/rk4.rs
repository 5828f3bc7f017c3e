//! The classical Runge-Kutta method of order 4.

use super::explicit::{Tableau, no_steps};
use super::{Integrator, Ode, Work};
use crate::error::Result;

/// The classical Runge-Kutta method: order 4, four derivatives a step, fixed step.
///
/// Halving the step divides the error by 16. It keeps no invariant exactly: use
/// it where a few digits will do, or as the yardstick others are held to.
///
/// Accuracy, as measured on the notes' top (16.2, fig. 3) over 20 time units: 1.4e-6
/// with 400 steps, 8.5e-8 with 800, and round-off (1.7e-14, since sums are
/// compensated) with 40000.
///
/// Source: W. Kutta, Z. Math. Phys. 46, 435 (1901); E. Hairer, S. P. Nørsett,
/// G. Wanner, *Solving Ordinary Differential Equations I*, II.1, table 1.2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rk4 {
    steps: u64,
}

impl Rk4 {
    /// The coefficients.
    pub const TABLEAU: Tableau<4> = Tableau {
        c: [0.0, 0.5, 0.5, 1.0],
        a: [&[], &[(0, 0.5)], &[(1, 0.5)], &[(2, 1.0)]],
        b: &[(0, 1.0 / 6.0), (1, 1.0 / 3.0), (2, 1.0 / 3.0), (3, 1.0 / 6.0)],
    };

    /// The method with this many equal steps over the whole run.
    ///
    /// Errors: no steps.
    pub fn new(steps: u64) -> Result<Self> {
        if steps == 0 {
            return Err(no_steps());
        }
        Ok(Self { steps })
    }
}

impl<const N: usize, O: Ode<N> + ?Sized> Integrator<O, [f64; N]> for Rk4 {
    fn advance(&self, ode: &O, t: f64, start: &[f64; N], t_end: f64) -> Result<([f64; N], Work)> {
        Self::TABLEAU.advance(ode, t, start, t_end, self.steps)
    }
}
