//! The interface of every motion, whether it is known in closed form or was solved.
//!
//! A motion has a name, a state at a time, states at many times, numbers that it keeps, and a
//! *condition*: by how much the state changes when the inputs change a little. Code that
//! takes `impl Motion<State = State>` works with any rotation of a body.
//!
//! The names beside the trait's are the same everywhere: `state`, `attitude`,
//! `angular_velocity` and `kinematics` are plain values and cost the least: NaN where nothing is
//! known. `try_state` and its kin refuse such a time, which is not finite or
//! [so late](crate::exact#how-late) that the phase is lost.
//!
//! Not for: how a motion is found ([`crate::exact`], [`crate::scene`]).

use crate::error::{Error, Result};
use crate::math::larger;

/// A number that a motion keeps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Kept {
    /// Its kind, in the field's own words.
    pub name: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// Its value.
    pub value: f64,
}

impl Kept {
    /// The number of this name, unit and value.
    pub const fn new(name: &'static str, unit: &'static str, value: f64) -> Self {
        Self { name, unit, value }
    }
}

/// A motion: a state at every time of its span.
///
/// ```
/// use rotation_dynamics::{attitude::Attitude, exact::free_body::FreeBody, motion::Motion};
/// use rotation_dynamics::{frame::BodyVector, inertia::PrincipalMoments};
/// let moments = PrincipalMoments::new(1.0, 2.0, 2.5)?;
/// let motion = FreeBody::new(moments, Attitude::IDENTITY, BodyVector::new(0.8, 0.4, 0.3))?;
/// let states = motion.try_states(&[0.0, 1.0, 2.0])?;
/// assert_eq!(states[2], motion.state(2.0));
/// // Doubles hold the inputs to 1e-16: after 1000 s the attitude is good to a few 1e-13.
/// assert!(motion.condition(1000.0)? < 5000.0);
/// let refused = motion.try_states(&[0.0, f64::NAN]).unwrap_err().to_string();
/// assert_eq!(refused, "times[1]: t = NaN is not a finite number");
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
pub trait Motion {
    /// Where it is at one time.
    type State;

    /// Its name.
    fn name(&self) -> &'static str;

    /// The state at time `t` (s, or the motion's own unit).
    ///
    /// # Errors
    /// A time that is not finite, outside the motion, or so late that its phase is lost.
    fn try_state(&self, t: f64) -> Result<Self::State>;

    /// The states at many times, in any order.
    ///
    /// # Errors
    /// [`Error::AtIndex`]: the first time that is refused, by its place and with the reason.
    fn try_states(&self, times: &[f64]) -> Result<Vec<Self::State>> {
        let at = |(index, t): (usize, &f64)| {
            self.try_state(*t).map_err(|reason| Error::AtIndex {
                name: "times",
                index,
                reason: Box::new(reason),
            })
        };
        times.iter().enumerate().map(at).collect()
    }

    /// Its conserved quantities. Empty if that is not known.
    fn kept(&self) -> Vec<Kept>;

    /// The change of the state at time `t` (rad) per relative change of the inputs.
    ///
    /// The root of the sum of squares over the inputs, each changed in both directions by so little
    /// that the answer is linear. The change is 1e-6 at first, and less while the state moves by
    /// more than a milliradian. Near a separatrix that may be 1e-20 or 1e-200, and it can be done:
    /// the closed forms keep rates of that size beside rates of order one. Where a double has no
    /// smaller change (about 1e-15 of an input that is not small), the result is a lower bound
    /// above 1e12: no digit is known then.
    ///
    /// # Errors
    /// Those of [`Self::try_state`]; [`Error::ConditionUnknown`] if the inputs are not known.
    fn condition(&self, t: f64) -> Result<f64>;
}

/// The largest movement of a state that counts as linear in the change of an input (rad).
const LINEAR: f64 = 1e-3;

/// The condition of one input. `moved`: the movement of the state (rad) when that input is
/// changed by this part; nothing if no double is that near to it.
pub(crate) fn condition_by_difference(moved: impl Fn(f64) -> Result<Option<f64>>) -> Result<f64> {
    let mut by = 1e-6;
    let mut known = 0.0_f64;
    let mut refused = None;
    while by > 1e-300 {
        // At the end of a range there may be one side only.
        let most = match (moved(by), moved(-by)) {
            (Ok(Some(a)), Ok(Some(b))) => larger(a, b),
            (Ok(Some(a)), _) | (_, Ok(Some(a))) => a,
            // A needle has no neighbours but near ones.
            (Err(error), Err(_)) => {
                refused = Some(error);
                by *= 1e-3;
                continue;
            }
            _ => break,
        };
        refused = None;
        known = larger(known, most / by);
        if most <= LINEAR {
            return Ok(most / by);
        }
        by *= 1e-3;
    }
    refused.map_or(Ok(known), Err)
}

/// `square` and the squares of the conditions of these inputs, each changed by a part of itself.
/// `moved`: the movement of the state (rad) for other inputs. With it a closed form gives its
/// [`Motion::condition`].
///
/// # Errors
/// Those of `moved`, if it refuses every change of an input.
pub fn condition_of_each<const N: usize>(
    square: f64,
    inputs: [f64; N],
    moved: impl Fn([f64; N]) -> Result<f64>,
) -> Result<f64> {
    (0..N).try_fold(square, |square, i| {
        let felt = condition_by_difference(|by| {
            let Some(input) = changed(inputs[i], by) else {
                return Ok(None);
            };
            let mut inputs = inputs;
            inputs[i] = input;
            moved(inputs).map(Some)
        })?;
        Ok(square + felt * felt)
    })
}

/// `x` with a part `by` of it added, if doubles have it to a tenth of the change.
pub(crate) fn changed(x: f64, by: f64) -> Option<f64> {
    pushed(x, by * x)
}

/// `x` with `change` added, if doubles have it to a tenth of the change.
pub(crate) fn pushed(x: f64, change: f64) -> Option<f64> {
    let y = x + change;
    ((y - x - change).abs() <= 0.1 * change.abs()).then_some(y)
}
