//! numeris: Verner's pair of orders 9 and 8, without the stages of its interpolant
//! where only the end counts.

use super::{MOST_STEPS, reason};
use crate::form::Form;
use numeris::Vector;
use numeris::ode::{AdaptiveSettings, RKAdaptive, RKV98, RKV98NoInterp, Solution};

fn settings(tolerance: f64) -> AdaptiveSettings<f64> {
    AdaptiveSettings {
        abs_tol: tolerance,
        rel_tol: 0.0,
        min_step: 0.0,
        max_steps: MOST_STEPS,
        ..AdaptiveSettings::default()
    }
}

fn array<const N: usize>(y: &Vector<f64, N>) -> [f64; N] {
    core::array::from_fn(|i| y[i])
}

/// The state at `end`.
///
/// # Errors
/// The solver's own.
pub fn rkv98<const N: usize, F: Form<N>>(
    form: F,
    end: f64,
    tolerance: f64,
) -> Result<[f64; N], String> {
    let start = Vector::from_array(form.start());
    let rates = |t, y: &Vector<f64, N>| Vector::from_array(form.rates(t, &array(y)));
    RKV98NoInterp::integrate(0.0, end, &start, rates, &settings(tolerance))
        .map(|solution| array(&solution.y))
        .map_err(reason)
}

/// The quaternions at `times`, in order, into `out`.
///
/// # Errors
/// The solver's own.
pub fn rkv98_dense<const N: usize, F: Form<N>>(
    form: F,
    times: &[f64],
    out: &mut [[f64; 4]],
    tolerance: f64,
) -> Result<(), String> {
    let end = *times.last().ok_or("no times")?;
    let start = Vector::from_array(form.start());
    let rates = |t, y: &Vector<f64, N>| Vector::from_array(form.rates(t, &array(y)));
    let settings = AdaptiveSettings { dense_output: true, ..settings(tolerance) };
    let solution: Solution<f64, N, 1> =
        RKV98::integrate(0.0, end, &start, rates, &settings).map_err(reason)?;
    let states = RKV98::interpolate_batch(times, &solution).map_err(reason)?;
    for ((state, &t), out) in states.iter().zip(times).zip(out) {
        *out = form.quaternion(t, &array(state));
    }
    Ok(())
}
