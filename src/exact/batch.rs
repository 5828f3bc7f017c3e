//! Many samples at once: of one motion at many times, of many motions at one time.
//!
//! The lanes run the scalar sample's own code, which has no branch. Beyond a motion's reach
//! samples go one by one.

use crate::attitude::Attitude;
use crate::body::Kinematics;
use crate::frame::BodyVector;
use crate::math::lane::{
    Constant, Gathered, Phased, Row, Sampler, WIDEST, for_each_motion, for_each_time,
};
use core::slice::IterMut;

/// A motion whose samples have no branch, or [`WIDEST`] of its kind side by side.
pub(super) trait Branchless<V: Constant = f64> {
    /// The greatest |t|.
    fn until(&self) -> f64;
    /// The unit quaternion and the body rates at time `t`, in lanes that start with the motion
    /// number `first`.
    fn all<L: Phased>(&self, t: L, first: usize) -> ([L; 4], [L; 3]);
}

/// Quaternion and rates where nothing is known.
pub(super) const LOST: ([f64; 4], [f64; 3]) = ([f64::NAN; 4], [f64::NAN; 3]);

/// One motion, at any time.
pub(super) trait Sampled: Branchless + Sized {
    /// Quaternion and rates beyond [`Branchless::until`]: as a rule the phase is lost there.
    #[cold]
    fn far(&self, _t: f64) -> ([f64; 4], [f64; 3]) {
        LOST
    }

    /// Attitude and rates at any time.
    #[inline]
    fn kinematics(&self, t: f64) -> Kinematics {
        let (quaternion, rates) =
            if t.abs() <= self.until() { self.all(t, 0) } else { self.far(t) };
        Kinematics::new(Attitude::from_unit(quaternion), BodyVector::from_array(rates))
    }

    /// The states at these times; both lists are equally long.
    fn fill(&self, times: &[f64], states: &mut [Kinematics]) {
        let mut left = states.iter_mut();
        let is_near = |t: &f64| t.abs() <= self.until();
        let in_lanes = |run: &[f64], left: &mut IterMut<Kinematics>| {
            for_each_time(&All(self), run, |numbers| {
                if let Some(state) = left.next() {
                    *state = stated(numbers);
                }
            });
        };
        // Counting goes in vector registers; looking for the runs does not.
        if times.iter().filter(|t| is_near(t)).count() == times.len() {
            return in_lanes(times, &mut left);
        }
        for run in times.chunk_by(|one, next| is_near(one) == is_near(next)) {
            if is_near(&run[0]) {
                in_lanes(run, &mut left);
            } else {
                for (t, state) in run.iter().zip(&mut left) {
                    *state = self.kinematics(*t);
                }
            }
        }
    }
}

/// The state of these numbers.
#[inline(always)]
pub(super) fn stated([w, x, y, z, p, q, r]: [f64; 7]) -> Kinematics {
    Kinematics::new(Attitude::from_unit([w, x, y, z]), BodyVector::new(p, q, r))
}

struct All<'a, M>(&'a M);

impl<M: Branchless> Sampler<7> for All<'_, M> {
    #[inline(always)]
    fn sample<L: Phased>(&self, t: L, first: usize) -> [L; 7] {
        let ([w, x, y, z], [p, q, r]) = self.0.all(t, first);
        [w, x, y, z, p, q, r]
    }
}

/// Motions of one kind, in blocks.
#[derive(Debug, Clone)]
pub(super) struct Blocks<B> {
    blocks: Vec<Block<B>>,
}

/// [`WIDEST`] motions side by side; the last is repeated where there are fewer.
#[derive(Debug, Clone)]
struct Block<B> {
    motions: B,
    /// Their numbers.
    numbers: [usize; WIDEST],
}

impl<B: Branchless<Row>> Sampler<7> for Block<B> {
    #[inline(always)]
    fn sample<L: Phased>(&self, t: L, first: usize) -> [L; 7] {
        let ([w, x, y, z], [p, q, r]) = self.motions.all(t, first);
        [w, x, y, z, p, q, r]
    }
}

impl<B: Branchless<Row>> Blocks<B> {
    /// Of motions with their numbers.
    pub(super) fn new<M: Gathered<Rows = B>>(motions: &[(usize, M)]) -> Self {
        let block = |motions: &[(usize, M)]| {
            let each: [_; WIDEST] = core::array::from_fn(|k| motions[k.min(motions.len() - 1)]);
            Block {
                motions: M::gathered(each.map(|(_, motion)| motion)),
                numbers: each.map(|(number, _)| number),
            }
        };
        Self { blocks: motions.chunks(WIDEST).map(block).collect() }
    }

    /// Puts the state of each motion at time `t` where its number says: `near` reads it from the
    /// results of the lanes, `far` is asked for the states of a block that does not reach as far.
    pub(super) fn fill(
        &self,
        t: f64,
        states: &mut [Kinematics],
        near: impl Fn(usize, [f64; 7]) -> Kinematics,
        far: impl Fn(usize) -> Kinematics,
    ) {
        let is_near = |block: &&Block<B>| t.abs() <= block.motions.until();
        let reaching = || self.blocks.iter().filter(is_near);
        let mut numbers = reaching().flat_map(|block| block.numbers);
        for_each_motion(reaching(), t, |sample| {
            if let Some(number) = numbers.next() {
                states[number] = near(number, sample);
            }
        });
        for block in self.blocks.iter().filter(|block| !is_near(block)) {
            for number in block.numbers {
                states[number] = far(number);
            }
        }
    }
}
