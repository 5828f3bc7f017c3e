//! Many tops at one time.

use super::hyperbolic::Late;
use super::sample::Sampler;
use super::{Course, Form, HeavyTop};
use crate::body::Kinematics;
use crate::error::{Result, known};
use crate::exact::batch::{Blocks, stated};
use crate::exact::check_length;
use crate::math::lane::Row;

/// Tops that are asked for their states at one time after the other: side by side in vector
/// registers, each form of the motion with its own. An axis that stays goes by itself.
///
/// For 512 tops one by one, a state takes 2.8 times as long as together with AVX-512 and 3.6 times
/// as long as with AVX2. For m > 0.8 it is 3.6 and 3.2 times (`benches`, binary `batch`). Tops that
/// a cache does not hold, some 350 or 660 bytes each, take the time in which memory brings them.
///
/// ```
/// # use rotation_dynamics::body::Kinematics;
/// # use rotation_dynamics::exact::heavy_top::{HeavyTop, HeavyTops, ReducedTop, Start};
/// let top = ReducedTop::new(2.0, 1.2, 0.2)?;
/// let tops = (0..1000)
///     .map(|k| 0.5 + 1e-4 * f64::from(k))
///     .map(|energy| HeavyTop::from_energy(top, energy, Start::ThetaMin, 0.0, 0.0))
///     .collect::<Result<Vec<_>, _>>()?;
/// let together = HeavyTops::new(&tops);
/// let mut states = vec![Kinematics::REST; tops.len()];
/// together.kinematics(12.0, &mut states)?;
/// assert_eq!(states[999], tops[999].kinematics(12.0));
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct HeavyTops<'a> {
    tops: &'a [HeavyTop],
    nodding: Blocks<Sampler<Row>>,
    late: Blocks<Late<Row>>,
    /// The numbers of those whose axis stays.
    fixed: Vec<usize>,
    /// The greatest |t| at which the phases of all are known.
    latest: f64,
}

impl<'a> HeavyTops<'a> {
    /// Copies what samples need of the motions, side by side.
    pub fn new(tops: &'a [HeavyTop]) -> Self {
        let (mut nodding, mut late, mut fixed) = (Vec::new(), Vec::new(), Vec::new());
        for (number, top) in tops.iter().enumerate() {
            match &top.course {
                Course::Fixed { .. } => fixed.push(number),
                Course::Moving { form, .. } => match form {
                    Form::Trigonometric(sampler) => nodding.push((number, **sampler)),
                    Form::Hyperbolic(motion) => late.push((number, **motion)),
                },
            }
        }
        Self {
            tops,
            nodding: Blocks::new(&nodding),
            late: Blocks::new(&late),
            fixed,
            latest: tops.iter().fold(f64::MAX, |t, top| t.min(top.latest)),
        }
    }

    /// The tops.
    pub const fn tops(&self) -> &'a [HeavyTop] {
        self.tops
    }

    /// Attitude and body rates of each top at time `t`, in their order: the bits of
    /// [`HeavyTop::kinematics`]. Nothing is allocated.
    ///
    /// # Errors
    /// `Lengths` if there are not as many states as tops; for a time as
    /// [`HeavyTop::try_kinematics`] of the top that is known for the shortest time. No state is
    /// touched then.
    pub fn kinematics(&self, t: f64, states: &mut [Kinematics]) -> Result<()> {
        check_length("states", states.len(), self.tops.len())?;
        known(t, self.latest)?;
        let near = |_, sample| stated(sample);
        let far = |number: usize| self.tops[number].kinematics(t);
        self.nodding.fill(t, states, near, far);
        self.late.fill(t, states, near, far);
        for &number in &self.fixed {
            states[number] = far(number);
        }
        Ok(())
    }
}
