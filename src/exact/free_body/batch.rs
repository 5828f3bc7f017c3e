//! Many samples of one motion at once.
//!
//! The lanes run the scalar sample's own code, which has no branch but where the series
//! is hyperbolic. That one needs `exp` and stays scalar.

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
}

/// The states at these times, none beyond the motion's reach; both lists are equally long.
pub(super) fn fill(motion: &impl Branchless, times: &[f64], states: &mut [Kinematics]) {
    let mut states = states.iter_mut();
    for_each_sample(&Batch(motion), times, |[w, x, y, z, p, q, r]| {
        if let Some(state) = states.next() {
            *state = Kinematics::new(Attitude::from_unit([w, x, y, z]), BodyVector::new(p, q, r));
        }
    });
}

struct Batch<'a, M>(&'a M);

impl<M: Branchless> Sampler<7> for Batch<'_, M> {
    #[inline(always)]
    fn sample<L: Phased>(&self, t: L) -> [L; 7] {
        let ([w, x, y, z], [p, q, r]) = self.0.all(t);
        [w, x, y, z, p, q, r]
    }
}
