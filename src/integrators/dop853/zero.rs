//! Zeros of a function along a motion, and frequencies measured by them.

use super::system::{ByRef, System};
use super::{Dop853, Event, Integrator, LocatedEvent, Ode, Work};
use crate::error::{Error, Result};
use core::f64::consts::PI;

impl Dop853 {
    /// The `count`-th time after the start at which `f` goes through zero, either way, and
    /// the work; `f` may be zero at the start.
    ///
    /// ```
    /// use rotation_dynamics::integrators::{Dop853, Ode, size_or};
    /// struct Spring;
    /// impl Ode<2> for Spring {
    ///     fn derivative(&self, _: f64, [x, v]: &[f64; 2]) -> [f64; 2] { [*v, -x] }
    ///     fn scale(&self, y: &[f64; 2]) -> [f64; 2] { size_or([1.0; 2])(y) }
    /// }
    /// let (back, _) = Dop853::new(1e-14)?.zero(&Spring, [1.0, 0.0], 2, 100.0, |y| y[1])?;
    /// assert!((back.t - core::f64::consts::TAU).abs() < 1e-13);
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NotReached`] if it has not happened until `until`; the errors of [`Dop853::solve`].
    pub fn zero<const N: usize>(
        &self,
        ode: &impl Ode<N>,
        start: [f64; N],
        count: u32,
        until: f64,
        f: impl Fn(&[f64; N]) -> f64,
    ) -> Result<(LocatedEvent<N>, Work)> {
        self.zero_of(&ByRef(ode), start, count, until, &f)
    }

    fn zero_of<const N: usize>(
        &self,
        ode: &dyn System<N>,
        start: [f64; N],
        count: u32,
        until: f64,
        f: &dyn Fn(&[f64; N]) -> f64,
    ) -> Result<(LocatedEvent<N>, Work)> {
        let (name, mut work) = ("zero", Work::default());
        let event = [Event::crossing(name, |_, y: &[f64; N]| f(y)).terminal()];
        let (mut t, mut state, mut last) = (0.0, start, None);
        for _ in 0..count {
            let run = self.solve_system(ode, t, &state, until, &event)?;
            work += run.work();
            let met = run.stopped_by().ok_or(Error::NotReached { name, until })?;
            (t, state) = (met.t, met.state);
            last = Some(met.clone());
        }
        Ok((last.ok_or(Error::NotReached { name, until })?, work))
    }
}

/// Where a motion that starts so at t = 0 is at the time `t_end`, by DOP853 with this error of
/// a step.
///
/// ```
/// use rotation_dynamics::integrators::{after, second_order};
/// let [x, _] = after(1.5, &second_order(|_, x, _| -x), &[1.0, 0.0], 1e-14)?;
/// assert!((x - rotation_dynamics::math::cos(1.5)).abs() < 1e-14);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
///
/// # Errors
/// Those of [`Dop853::new`] and [`Dop853::advance`](Integrator::advance).
pub fn after<const N: usize>(
    t_end: f64,
    ode: &impl Ode<N>,
    start: &[f64; N],
    tolerance: f64,
) -> Result<[f64; N]> {
    Ok(Dop853::new(tolerance)?.advance(ode, 0.0, start, t_end)?.0)
}

/// The angular frequency of the smallest oscillations, measured: two zeros of `f` make a
/// period, and the periods of two sizes are extrapolated to size 0.
///
/// `start(size)` is the start of an oscillation of this size, 1e-3 and 2e-3, whose period is even
/// in it, as after a kick at the place of rest. `until` is a time by which both are over.
///
/// Accuracy, on pendulums: 1e-10, the error that the fourth power of the size and the location of
/// the zeros leave.
///
/// # Errors
/// Those of [`Dop853::zero`].
pub fn small_frequency<const N: usize>(
    ode: &impl Ode<N>,
    start: impl Fn(f64) -> [f64; N],
    until: f64,
    f: impl Fn(&[f64; N]) -> f64,
) -> Result<f64> {
    let method = Dop853::new(Dop853::SMALLEST_TOLERANCE)?;
    let period = |size| Ok(method.zero(ode, start(size), 2, until, &f)?.0.t);
    Ok(6.0 * PI / (4.0 * period(1e-3)? - period(2e-3)?))
}
