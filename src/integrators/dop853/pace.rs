//! Steps in another time than the motion's, for motions that are now slow, now fast.

use super::event::Watch;
use super::system::ByRef;
use super::{Dop853, Event, Ode, Work};
use crate::error::{Error, Result, finite, positive};
use core::ops::ControlFlow;

/// A system with the time as its last component, in the time s of dt = pace(y) ds.
struct Paced<'a, O: ?Sized, P> {
    ode: &'a O,
    pace: P,
}

impl<const N: usize, O: Ode<N> + ?Sized, P: Fn(&[f64; N]) -> f64> Ode<N> for Paced<'_, O, P> {
    fn derivative(&self, _s: f64, y: &[f64; N]) -> [f64; N] {
        let pace = (self.pace)(y);
        // A time that stands still or runs back is refused as a derivative that is no number.
        let pace = if pace > 0.0 { pace } else { f64::NAN };
        self.ode.derivative(y[N - 1], y).map(|rate| pace * rate)
    }
    fn scale(&self, y: &[f64; N]) -> [f64; N] {
        self.ode.scale(y)
    }
    fn drift(&self, _s: f64, y: &[f64; N], within: f64) -> Option<[f64; N]> {
        self.ode.drift(y[N - 1], y, within)
    }
}

impl Dop853 {
    /// The state at `t_end` of a system whose last component is the time, by steps in the time s
    /// of dt = `pace`(y) ds, and the work.
    ///
    /// `ode` gives the rates by t, with 1 for the last component; `pace` is greater than 0. In
    /// units of a pace that follows the distance from a singular point (an angle from the pole, a
    /// planet from its sun) the motion is slow beside that point too. So the steps stay alike, and
    /// none has to be found too long first. `t_end` may lie before the start.
    ///
    /// Accuracy: the time is stepped to like all else, and the last step ends at `t_end` as at an
    /// [event](Event). Measured on a top that passes the pole in 1e-4 rad, twenty times, with
    /// sin(theta) for its pace (`tests/integrators/convergence/pace.rs`):
    ///
    /// | tolerance | error | derivatives | error, steps in t | derivatives |
    /// |---|---|---|---|---|
    /// | 1e-8 | 3.2e-6 | 12461 | 9.3e-7 | 24199 |
    /// | 1e-10 | 3.7e-8 | 19873 | 1.4e-8 | 38892 |
    /// | 1e-12 | 7.3e-10 | 32331 | 1.2e-10 | 59554 |
    /// | 1e-14 | 2.8e-10 | 57482 | 2.7e-11 | 90290 |
    ///
    /// Source: K. F. Sundman, Acta Math. 36, 105 (1912).
    ///
    /// ```
    /// use rotation_dynamics::integrators::{Dop853, size_or, ode};
    /// // A fall to a centre that attracts with 1/r^2, from rest at r = 1 to r = 1e-4: r, r', t.
    /// let fall = ode(|_, [r, v, _]: &[f64; 3]| [*v, -1.0 / (r * r), 1.0]);
    /// let fall = fall.scaled(size_or([1.0; 3]));
    /// let method = Dop853::new(1e-14)?;
    /// let t_end = 1.110_720_263_120_927_6;
    /// let ([r, ..], _) = method.advance_at_pace(&fall, &[1.0, 0.0, 0.0], t_end, |[r, ..]| *r)?;
    /// assert!((r - 1e-4).abs() < 1e-12);
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    ///
    /// # Errors
    /// A time that is not finite; a pace that is not greater than 0, where that is met on the way
    /// as a derivative that is not finite; [`Error::NotReached`] where the time stops before
    /// `t_end`; the errors of [`Dop853::solve`], which tell s for t.
    pub fn advance_at_pace<const N: usize>(
        &self,
        ode: &(impl Ode<N> + ?Sized),
        start: &[f64; N],
        t_end: f64,
        pace: impl Fn(&[f64; N]) -> f64,
    ) -> Result<([f64; N], Work)> {
        const { assert!(N > 0, "the last component is the time") };
        let left = finite("end time", t_end)? - start[N - 1];
        let mut work = Work::default();
        if left == 0.0 {
            return Ok((*start, work));
        }
        // Longer than any step is: the run ends at `t_end`, unless time comes to a stand.
        let far = 1e12 * left / positive("pace", pace(start))?;
        let paced = &ByRef(&Paced { ode, pace });
        let ends =
            [Event::rising("end time", |_, y: &[f64; N]| (y[N - 1] - t_end) * left.signum())
                .terminal()
                .nearest()];
        let mut reached = false;
        let (end, _) =
            self.drive(paced, 0.0, start, far, &mut work, &mut |trial, last, work| {
                if (trial.end.value[N - 1] - t_end) * left < 0.0 {
                    return Ok(ControlFlow::Continue(()));
                }
                reached = true;
                let segment = trial.segment(paced, last, work)?;
                let mut watch = Watch::new(&ends, trial.t, &trial.start.value)?;
                let (_, stopped) = watch.crossings(paced, trial, &segment, work)?;
                let shortened = stopped.as_ref().unwrap_or(trial);
                Ok(ControlFlow::Break(shortened.end.value))
            })?;
        if reached {
            Ok((end, work))
        } else {
            let name = "end time";
            Err(Error::NotReached { name, until: end[N - 1] })
        }
    }
}
