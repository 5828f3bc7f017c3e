//! Many samples of one motion at once.

use super::hyperbolic::Late;
use super::sample::Sampler;
use super::{Course, Form, HeavyTop};
use crate::attitude::Attitude;
use crate::body::Kinematics;
use crate::error::Result;
use crate::exact::batch::{self, Branchless, Sampled};
use crate::exact::check_times;
use crate::math::lane::{self, Phased};

impl HeavyTop {
    /// The attitudes at many times: the bits of [`HeavyTop::attitude`], in vector
    /// registers where the processor has them. Nothing is allocated.
    ///
    /// # Errors
    /// `Lengths` if there are not as many attitudes as times; for a time as
    /// [`HeavyTop::try_attitude`]. No attitude is touched then.
    pub fn attitudes(&self, times: &[f64], attitudes: &mut [Attitude]) -> Result<()> {
        check_times("attitudes", attitudes.len(), times, self.latest)?;
        match self.form() {
            Some(Form::Trigonometric(sampler)) => filled(&**sampler, times, attitudes),
            Some(Form::Hyperbolic(late)) => filled(&**late, times, attitudes),
            None => {
                for (t, attitude) in times.iter().zip(attitudes) {
                    *attitude = self.attitude(*t);
                }
            }
        }
        Ok(())
    }

    /// Attitudes and body rates at many times: the bits of [`HeavyTop::kinematics`], as
    /// [`HeavyTop::attitudes`] does it.
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
    /// As [`HeavyTop::attitudes`].
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

/// A form of the motion that has the attitude alone.
trait Turning: Sampled {
    fn quaternion_at<L: Phased>(&self, t: L) -> [L; 4];
}

impl Turning for Sampler {
    #[inline(always)]
    fn quaternion_at<L: Phased>(&self, t: L) -> [L; 4] {
        self.quaternion(t)
    }
}

impl Turning for Late {
    #[inline(always)]
    fn quaternion_at<L: Phased>(&self, t: L) -> [L; 4] {
        self.quaternion(t)
    }
}

struct Attitudes<'a, M>(&'a M);

impl<M: Turning> lane::Sampler<4> for Attitudes<'_, M> {
    #[inline(always)]
    fn sample<L: Phased>(&self, t: L, _: usize) -> [L; 4] {
        self.0.quaternion_at(t)
    }
}

fn filled(motion: &impl Turning, times: &[f64], attitudes: &mut [Attitude]) {
    let far = |t| motion.kinematics(t).attitude;
    let until = motion.until();
    batch::fill(
        &Attitudes(motion),
        until,
        times,
        attitudes,
        Attitude::from_unit,
        far,
    );
}
