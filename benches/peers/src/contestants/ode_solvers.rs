//! ode_solvers: the pairs of Dormand and Prince, of orders 5 and 8, on nalgebra's vectors.

use super::{MOST_STEPS, reason};
use crate::form::Form;
use ode_solvers::dop_shared::IntegrationError;
use ode_solvers::{Dop853, Dopri5, OutputType, SVector, System};

struct Rates<F>(F);

impl<const N: usize, F: Form<N>> System<f64, SVector<f64, N>> for Rates<F> {
    fn system(&self, t: f64, y: &SVector<f64, N>, dy: &mut SVector<f64, N>) {
        dy.data.0[0] = self.0.rates(t, &y.data.0[0]);
    }
}

const NO_STIFFNESS_TEST: u32 = u32::MAX;

macro_rules! solver {
    ($Method:ident, $form:expr, $end:expr, $dt:expr, $tolerance:expr, $output:expr, $beta:expr, $least:expr, $most:expr) => {
        $Method::from_param(
            Rates($form),
            0.0,
            $end,
            $dt,
            SVector::from($form.start()),
            0.0,
            $tolerance,
            0.9,
            $beta,
            $least,
            $most,
            $end,
            0.0,
            MOST_STEPS as u32,
            NO_STIFFNESS_TEST,
            $output,
        )
    };
}

fn last<const N: usize>(states: &[SVector<f64, N>]) -> Result<[f64; N], String> {
    let last = states.last().ok_or("no state")?;
    Ok(last.data.0[0])
}

fn why(error: IntegrationError) -> String {
    reason(error)
}

/// The state at `end`, by order 8.
///
/// # Errors
/// The solver's own.
pub fn dop853<const N: usize, F: Form<N>>(
    form: F,
    end: f64,
    tolerance: f64,
) -> Result<[f64; N], String> {
    let sparse = OutputType::Sparse;
    let mut solver = solver!(Dop853, form, end, end, tolerance, sparse, 0.0, 0.333, 6.0);
    solver.integrate().map_err(why)?;
    last(solver.y_out())
}

/// The state at `end`, by order 5.
///
/// # Errors
/// The solver's own.
pub fn dopri5<const N: usize, F: Form<N>>(
    form: F,
    end: f64,
    tolerance: f64,
) -> Result<[f64; N], String> {
    let sparse = OutputType::Sparse;
    let mut solver = solver!(Dopri5, form, end, end, tolerance, sparse, 0.04, 0.2, 10.0);
    solver.integrate().map_err(why)?;
    last(solver.y_out())
}

/// The quaternions at `times`, evenly spaced from 0, into `out`.
///
/// # Errors
/// The solver's own.
pub fn dop853_dense<const N: usize, F: Form<N>>(
    form: F,
    times: &[f64],
    out: &mut [[f64; 4]],
    tolerance: f64,
) -> Result<(), String> {
    let (&[_, dt, ..], Some(&end)) = (times, times.last()) else {
        return Err("fewer than two times".into());
    };
    let dense = OutputType::Dense;
    let mut solver = solver!(Dop853, form, end, dt, tolerance, dense, 0.0, 0.333, 6.0);
    solver.integrate().map_err(why)?;
    if solver.y_out().len() < times.len() {
        return Err(format!("{} of {} samples", solver.y_out().len(), times.len()));
    }
    for ((state, &t), out) in solver.y_out().iter().zip(times).zip(out) {
        *out = form.quaternion(t, &state.data.0[0]);
    }
    Ok(())
}
