//! Many samples of one motion at once.

use super::sample::Sampler;
use super::{Course, HeavyTop};
use crate::attitude::Attitude;
use crate::body::Kinematics;
use crate::error::Result;
use crate::exact::batch::Branchless;
use crate::exact::check_times;
use crate::math::lane::{self, Phased, for_each_sample};

impl HeavyTop {
    /// The attitudes at many times: the bits of [`HeavyTop::attitude`], in vector
    /// registers where the processor has them and m <= 0.8; elsewhere one by one.
    /// Nothing is allocated.
    ///
    /// # Errors
    /// `Lengths` if there are not as many attitudes as times; `NotFinite` for a time
    /// that is not finite. No attitude is touched then.
    pub fn attitudes(&self, times: &[f64], attitudes: &mut [Attitude]) -> Result<()> {
        check_times("attitudes", attitudes.len(), times)?;
        if let Some(sampler) = self.in_lanes(times) {
            let mut attitudes = attitudes.iter_mut();
            for_each_sample(&Attitudes(sampler), times, |quaternion| {
                if let Some(attitude) = attitudes.next() {
                    *attitude = Attitude::from_unit(quaternion);
                }
            });
        } else {
            for (t, attitude) in times.iter().zip(attitudes) {
                *attitude = self.attitude(*t);
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
        check_times("samples", samples.len(), times)?;
        if let Some(sampler) = self.in_lanes(times) {
            sampler.fill(times, samples);
        } else {
            for (t, sample) in times.iter().zip(samples) {
                *sample = self.kinematics(*t);
            }
        }
        Ok(())
    }

    /// The sampler, if it is good for all these times.
    fn in_lanes(&self, times: &[f64]) -> Option<&Sampler> {
        let Course::Moving { sampler, .. } = &self.course else {
            return None;
        };
        sampler.as_deref()?.reaching(times)
    }
}

struct Attitudes<'a>(&'a Sampler);

impl lane::Sampler<4> for Attitudes<'_> {
    #[inline(always)]
    fn sample<L: Phased>(&self, t: L) -> [L; 4] {
        self.0.quaternion(t)
    }
}
