//! Many samples of one motion at once.
//!
//! The lanes run the scalar sample's own code, which has no branch where the series is
//! trigonometric. The hyperbolic one needs `exp` and goes one by one.

use crate::attitude::Attitude;
use crate::body::Kinematics;
use crate::frame::BodyVector;
use crate::math::lane::{Phased, Sampler, for_each_sample};

/// A motion whose samples have no branch.
pub(super) trait Branchless {
    /// The greatest |t|.
    fn until(&self) -> f64;
    /// The unit quaternion and the body rates at time `t`.
    fn all<L: Phased>(&self, t: L) -> ([L; 4], [L; 3]);
    /// Both beyond that time.
    fn far(&self, t: f64) -> ([f64; 4], [f64; 3]);

    /// Attitude and rates at any time.
    #[inline]
    fn kinematics(&self, t: f64) -> Kinematics {
        let (quaternion, rates) = if t.abs() <= self.until() {
            self.all(t)
        } else {
            self.far(t)
        };
        Kinematics::new(
            Attitude::from_unit(quaternion),
            BodyVector::from_array(rates),
        )
    }

    /// This, if it reaches as far as all these times.
    fn reaching(&self, times: &[f64]) -> Option<&Self> {
        let until = self.until();
        let beyond = times.iter().filter(|t| t.abs() > until).count();
        (beyond == 0).then_some(self)
    }

    /// The states at these times, none beyond the motion's reach; both lists are equally long.
    fn fill(&self, times: &[f64], states: &mut [Kinematics])
    where
        Self: Sized,
    {
        let mut states = states.iter_mut();
        for_each_sample(&Batch(self), times, |[w, x, y, z, p, q, r]| {
            if let Some(state) = states.next() {
                let attitude = Attitude::from_unit([w, x, y, z]);
                *state = Kinematics::new(attitude, BodyVector::new(p, q, r));
            }
        });
    }
}

struct Batch<'a, M>(&'a M);

impl<M: Branchless> Sampler<7> for Batch<'_, M> {
    #[inline(always)]
    fn sample<L: Phased>(&self, t: L) -> [L; 7] {
        let ([w, x, y, z], [p, q, r]) = self.0.all(t);
        [w, x, y, z, p, q, r]
    }
}
