//! Sums of many small increments without the growth of round-off.

use crate::math::double_double::two_sum;

/// A state and what its rounding has left out so far.
///
/// Each increment is added with the rounding errors of those before it (Kahan,
/// Commun. ACM 8, 40 (1965); with Knuth's two-sum, so that an increment may be
/// larger than the state). After n steps the sum is off by about n eps |h f|
/// instead of n eps |y|: long runs with small steps keep their digits.
#[derive(Debug, Clone, Copy)]
pub(super) struct Compensated<const N: usize> {
    pub(super) value: [f64; N],
    pub(super) carry: [f64; N],
}

impl<const N: usize> Compensated<N> {
    pub(super) fn new(value: [f64; N]) -> Self {
        Self { value, carry: [0.0; N] }
    }

    /// This state plus an increment.
    #[inline(always)]
    pub(super) fn plus(&self, increment: &[f64; N]) -> Self {
        let mut sum = *self;
        let parts = sum.value.iter_mut().zip(&mut sum.carry).zip(increment);
        for ((value, carry), more) in parts {
            (*value, *carry) = two_sum(*value, more + *carry);
        }
        sum
    }

    /// Adds an increment and its own, much smaller rest to component `i`: nothing is
    /// rounded away but in the carry.
    #[inline(always)]
    pub(super) fn add(&mut self, i: usize, more: f64, rest: f64) {
        let (sum, lost) = two_sum(more, self.carry[i]);
        let (value, carry) = two_sum(self.value[i], sum);
        self.value[i] = value;
        self.carry[i] = carry + (lost + rest);
    }
}
