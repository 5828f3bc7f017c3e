//! A run through phases as a [`Motion`].

use super::Run;
use crate::error::{Error, Result, finite};
use crate::motion::{Kept, Motion};

/// Where a run is at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment<P, const N: usize> {
    /// The phase; at a change of phase, the one before it.
    pub phase: P,
    /// The coordinates and their rates.
    pub state: [f64; N],
}

/// ```
/// # use rotation_dynamics::integrators::{Dop853, size_or};
/// # use rotation_dynamics::planar::{Condition, Next, Phased, simulate};
/// # struct Ball;
/// # impl Phased<2> for Ball {
/// #     type Phase = ();
/// #     fn derivative(&self, _: (), [_, speed]: &[f64; 2]) -> [f64; 2] { [*speed, -10.0] }
/// #     fn conditions(&self, _: ()) -> Vec<Condition<'_, (), 2>> {
/// #         let rebound = Next::jump((), |[_, speed]: &[f64; 2]| [0.0, -0.5 * speed]);
/// #         vec![Condition::gap("height", |y| y[0], rebound)]
/// #     }
/// #     fn scale(&self, y: &[f64; 2]) -> [f64; 2] { size_or([1.0; 2])(y) }
/// # }
/// use rotation_dynamics::motion::Motion;
/// let run = simulate(&Ball, &Dop853::new(1e-12)?, (), [5.0, 0.0], 1.5)?;
/// let heights = run.try_states(&[0.0, 0.5, 1.25])?;
/// assert!((heights[1].state[0] - 3.75).abs() < 1e-12);
/// let late = run.try_states(&[0.0, 2.0]).unwrap_err().to_string();
/// assert_eq!(late, "times[1]: t = 2 is outside the run, which goes from 0 to 1.5");
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
///
/// A run knows its states, and neither what its scene keeps nor from what it was made.
impl<P: Copy, const N: usize> Motion for Run<P, N> {
    type State = Moment<P, N>;

    fn name(&self) -> &'static str {
        "planar run"
    }

    fn try_state(&self, t: f64) -> Result<Moment<P, N>> {
        let (phase, state) = self.at(finite("t", t)?)?;
        Ok(Moment { phase, state })
    }

    fn kept(&self) -> Vec<Kept> {
        Vec::new()
    }

    fn condition(&self, _t: f64) -> Result<f64> {
        Err(Error::ConditionUnknown { name: Motion::name(self) })
    }
}
