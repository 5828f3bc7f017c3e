//! diffsol: its one explicit method, of order 5 by Tsitouras, on nalgebra's vectors.

use super::{MOST_STEPS, reason};
use crate::form::Form;
use diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason};

/// The state at `end`.
///
/// # Errors
/// The solver's own.
pub fn tsit45<const N: usize, F: Form<N>>(
    form: F,
    end: f64,
    tolerance: f64,
) -> Result<[f64; N], String> {
    let array = |y: &[f64]| -> [f64; N] { core::array::from_fn(|i| y[i]) };
    let start = form.start();
    let problem = OdeBuilder::<NalgebraMat<f64>>::new()
        .rtol(0.0)
        .atol([tolerance])
        .h0(1e-3)
        .rhs(|y: &[f64], _p: &[f64], t, rates: &mut [f64]| {
            rates.copy_from_slice(&form.rates(t, &array(y)));
        })
        .init(|_p: &[f64], _t, y: &mut [f64]| y.copy_from_slice(&start), N)
        .build()
        .map_err(reason)?;
    let mut solver = problem.tsit45().map_err(reason)?;
    solver.set_stop_time(end).map_err(reason)?;
    for _ in 0..MOST_STEPS {
        if let OdeSolverStopReason::TstopReached = solver.step().map_err(reason)? {
            return Ok(array(solver.state().y.batch_as_slice(0)));
        }
    }
    Err("too many steps".into())
}
