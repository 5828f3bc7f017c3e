//! Many samples of one motion at once.

use super::{Course, Form, HeavyTop};
use crate::body::Kinematics;
use crate::error::Result;
use crate::exact::batch::{Branchless, Sampled};
use crate::exact::check_times;

impl HeavyTop {
    /// Attitudes and body rates at many times: the bits of [`HeavyTop::kinematics`], in
    /// vector registers where the processor has them. Nothing is allocated.
    ///
    /// ```
    /// # use rotation_dynamics::body::Kinematics;
    /// # use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
    /// let top = ReducedTop::new(2.0, 1.2, 0.2)?;
    /// let motion = HeavyTop::from_energy(top, 0.55, Start::ThetaMin, 0.0, 0.0)?;
    /// let times: Vec<f64> = (0..1000).map(|k| 0.01 * f64::from(k)).collect();
    /// let mut samples = vec![Kinematics::REST; times.len()];
    /// motion.kinematics_at(&times, &mut samples)?;
    /// assert_eq!(samples[999], motion.kinematics(times[999]));
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    ///
    /// # Errors
    /// `Lengths` if there are not as many samples as times; for a time as
    /// [`HeavyTop::try_attitude`]. No sample is touched then.
    pub fn kinematics_at(&self, times: &[f64], samples: &mut [Kinematics]) -> Result<()> {
        check_times("samples", samples.len(), times, self.latest)?;
        match self.form() {
            Some(Form::Trigonometric(sampler)) => sampler.fill(times, samples),
            Some(Form::Hyperbolic(late)) => late.fill(times, samples),
            None => {
                for (t, sample) in times.iter().zip(samples) {
                    *sample = self.kinematics(*t);
                }
            }
        }
        Ok(())
    }

    /// The form that is sampled without a branch, if the axis moves.
    fn form(&self) -> Option<&Form> {
        match &self.course {
            Course::Fixed { .. } => None,
            Course::Moving { form, .. } => Some(form),
        }
    }
}

impl Form {
    /// The greatest |t| at which the phases are known.
    pub(super) fn latest(&self) -> f64 {
        match self {
            Self::Trigonometric(sampler) => sampler.until(),
            Self::Hyperbolic(late) => late.latest(),
        }
    }
}
