//! Many samples of one motion at once.
//!
//! The lanes run the scalar sample's own code, which has no branch where the series
//! is trigonometric. The hyperbolic one needs `exp` and stays scalar.

use super::asymmetric::Asymmetric;
use super::series::{Series, Trigonometric};
use crate::attitude::Attitude;
use crate::frame::BodyVector;
use crate::math::DoubleDouble;
use crate::math::lane::{Lane, Sampler, for_each_sample};

/// A motion whose samples have no branch.
pub(super) struct Batch<'a> {
    motion: &'a Asymmetric,
    series: &'a Trigonometric,
    half: DoubleDouble,
    per_half: f64,
}

impl<'a> Batch<'a> {
    /// None where the sample has to branch.
    pub(super) fn new(motion: &'a Asymmetric) -> Option<Self> {
        match (&motion.series, motion.half_period) {
            (Series::Trigonometric(series), Some((half, per_half))) => Some(Self {
                motion,
                series,
                half,
                per_half,
            }),
            _ => None,
        }
    }

    /// The states at these times; both lists are equally long.
    pub(super) fn fill(&self, times: &[f64], states: &mut [(Attitude, BodyVector)]) {
        let mut states = states.iter_mut();
        for_each_sample(self, times, |[w, x, y, z, p, q, r]| {
            if let Some(state) = states.next() {
                *state = (Attitude::from_unit([w, x, y, z]), BodyVector::new(p, q, r));
            }
        });
    }
}

impl Sampler<7> for Batch<'_> {
    #[inline(always)]
    fn sample<L: Lane>(&self, t: L) -> [L; 7] {
        let sum = |fraction, _| self.series.sum(fraction);
        let sample = self
            .motion
            .periodic_sample(self.half, self.per_half, t, sum);
        let [w, x, y, z] = self.motion.quaternion(&sample);
        let [p, q, r] = self.motion.rates(&sample);
        [w, x, y, z, p, q, r]
    }
}
