//! differential-equations: DOP853 and Verner's pair of orders 9 and 8, on arrays.

use super::{MOST_STEPS, reason};
use crate::form::Form;
use differential_equations::control::ControlFlag;
use differential_equations::interpolate::Interpolation;
use differential_equations::methods::ExplicitRungeKutta;
use differential_equations::ode::{ODE, OrdinaryNumericalMethod, solve_ode};
use differential_equations::solout::Solout;
use differential_equations::solution::Solution;

struct Rates<F>(F);

impl<const N: usize, F: Form<N>> ODE<f64, [f64; N]> for Rates<F> {
    fn diff(&self, t: f64, y: &[f64; N], rates: &mut [f64; N]) {
        *rates = self.0.rates(t, y);
    }
}

/// Conserved the last state alone.
struct Last<const N: usize>([f64; N]);

impl<const N: usize> Solout<f64, [f64; N]> for Last<N> {
    fn solout<I>(
        &mut self,
        _t: f64,
        _t_before: f64,
        y: &[f64; N],
        _y_before: &[f64; N],
        _interpolant: &mut I,
        _solution: &mut Solution<f64, [f64; N]>,
    ) -> ControlFlag<f64, [f64; N]>
    where
        I: Interpolation<f64, [f64; N]> + ?Sized,
    {
        self.0 = *y;
        ControlFlag::Continue
    }
}

/// Samples each step where it is asked for.
struct Samples<'a, F> {
    form: F,
    times: &'a [f64],
    out: &'a mut [[f64; 4]],
    done: usize,
}

impl<const N: usize, F: Form<N>> Solout<f64, [f64; N]> for Samples<'_, F> {
    fn solout<I>(
        &mut self,
        t: f64,
        _t_before: f64,
        y: &[f64; N],
        _y_before: &[f64; N],
        interpolant: &mut I,
        _solution: &mut Solution<f64, [f64; N]>,
    ) -> ControlFlag<f64, [f64; N]>
    where
        I: Interpolation<f64, [f64; N]> + ?Sized,
    {
        // Its last step ends within round-off of the end; its first has no length.
        let reached = t * (1.0 + 4.0 * f64::EPSILON);
        while let Some(&time) = self.times.get(self.done).filter(|time| **time <= reached) {
            let state = match time < t {
                true => interpolant.interpolate(time),
                false => Ok(*y),
            };
            match state {
                Ok(state) => self.out[self.done] = self.form.quaternion(time, &state),
                Err(_) => return ControlFlag::Continue,
            }
            self.done += 1;
        }
        ControlFlag::Continue
    }
}

fn at_end<const N: usize, F: Form<N>>(
    mut method: impl OrdinaryNumericalMethod<f64, [f64; N]> + Interpolation<f64, [f64; N]>,
    form: F,
    end: f64,
) -> Result<[f64; N], String> {
    let start = form.start();
    let mut last = Last(start);
    solve_ode(&mut method, &Rates(form), 0.0, end, &start, &mut last).map_err(reason)?;
    Ok(last.0)
}

/// The state at `end`, by DOP853.
///
/// # Errors
/// The solver's own.
pub fn dop853<const N: usize, F: Form<N>>(
    form: F,
    end: f64,
    tolerance: f64,
) -> Result<[f64; N], String> {
    let method = ExplicitRungeKutta::dop853().rtol(0.0).atol(tolerance).max_steps(MOST_STEPS);
    at_end(method, form, end)
}

/// The state at `end`, by Verner's pair of orders 9 and 8.
///
/// # Errors
/// The solver's own.
pub fn rkv98<const N: usize, F: Form<N>>(
    form: F,
    end: f64,
    tolerance: f64,
) -> Result<[f64; N], String> {
    let method = ExplicitRungeKutta::rkv988e().rtol(0.0).atol(tolerance).max_steps(MOST_STEPS);
    at_end(method, form, end)
}

/// The quaternions at `times`, in order, into `out`, by DOP853.
///
/// # Errors
/// The solver's own, or a sample that was not given.
pub fn dop853_dense<const N: usize, F: Form<N>>(
    form: F,
    times: &[f64],
    out: &mut [[f64; 4]],
    tolerance: f64,
) -> Result<(), String> {
    let end = *times.last().ok_or("no times")?;
    let mut method = ExplicitRungeKutta::dop853().rtol(0.0).atol(tolerance).max_steps(MOST_STEPS);
    let start = form.start();
    let mut samples = Samples { form, times, out, done: 0 };
    solve_ode(&mut method, &Rates(form), 0.0, end, &start, &mut samples).map_err(reason)?;
    match samples.done == times.len() {
        true => Ok(()),
        false => Err(format!("{} of {} samples", samples.done, times.len())),
    }
}
