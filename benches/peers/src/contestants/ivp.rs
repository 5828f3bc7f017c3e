//! ivp: DOP853 as a translation of Hairer's, on slices.

use super::{MOST_STEPS, reason};
use crate::form::Form;
use ivp::dense::StepInterpolant;
use ivp::ivp::FirstOrderSystem;
use ivp::methods::{DOP853, Tolerance};
use ivp::solout::{ControlFlag, SolOut};
use ivp::status::Status;

struct Rates<F>(F);

/// A slice as the array it is.
fn array<const N: usize>(y: &[f64]) -> [f64; N] {
    core::array::from_fn(|i| y[i])
}

struct System<const N: usize, F>(Rates<F>);

impl<const N: usize, F: Form<N>> FirstOrderSystem for System<N, F> {
    fn derivative(&self, t: f64, y: &[f64], rates: &mut [f64]) {
        rates.copy_from_slice(&self.0.0.rates(t, &array(y)));
    }
}

/// Conserved the last state; with times, samples each step where it is asked for.
struct Watch<'a, const N: usize, F> {
    form: F,
    last: [f64; N],
    times: &'a [f64],
    out: &'a mut [[f64; 4]],
    done: usize,
}

impl<const N: usize, F: Form<N>> SolOut for Watch<'_, N, F> {
    fn solout(
        &mut self,
        _before: f64,
        t: &mut f64,
        y: &mut [f64],
        interpolant: Option<&StepInterpolant<'_>>,
    ) -> ControlFlag {
        self.last = array(y);
        while let Some(&time) = self.times.get(self.done).filter(|time| **time <= *t) {
            let mut state = self.last;
            if let Some(interpolant) = interpolant {
                interpolant.interpolate(time, &mut state);
            }
            self.out[self.done] = self.form.quaternion(time, &state);
            self.done += 1;
        }
        ControlFlag::Continue
    }
}

fn watched<'a, const N: usize, F: Form<N>>(
    form: F,
    end: f64,
    tolerance: f64,
    times: &'a [f64],
    out: &'a mut [[f64; 4]],
) -> Result<Watch<'a, N, F>, String> {
    let method = DOP853 {
        max_steps: MOST_STEPS,
        stiff_test: usize::MAX,
        dense_output: !times.is_empty(),
        ..DOP853::default()
    };
    let mut watch = Watch { form, last: form.start(), times, out, done: 0 };
    let result = method
        .solve(
            &System(Rates(form)),
            0.0,
            &form.start(),
            end,
            Tolerance::Scalar(0.0),
            Tolerance::Scalar(tolerance),
            Some(&mut watch),
        )
        .map_err(reason)?;
    match result.status {
        Status::Success => Ok(watch),
        status => Err(reason(status)),
    }
}

/// The state at `end`.
///
/// # Errors
/// The solver's own.
pub fn dop853<const N: usize, F: Form<N>>(
    form: F,
    end: f64,
    tolerance: f64,
) -> Result<[f64; N], String> {
    watched(form, end, tolerance, &[], &mut []).map(|watch| watch.last)
}

/// The quaternions at `times`, in order, into `out`.
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
    let done = watched(form, end, tolerance, times, out)?.done;
    match done == times.len() {
        true => Ok(()),
        false => Err(format!("{done} of {} samples", times.len())),
    }
}
