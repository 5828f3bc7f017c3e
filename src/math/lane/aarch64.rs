//! The vector registers of 64-bit ARM: NEON, which every such processor has.
//!
//! It fuses a product with a sum where it is asked to; here it is never asked.

use super::{Add, Both, Div, HALF, LEADING, Lane, Mul, Neg, Number, ONE, Pair, Phased, SIGN, Sub};
use core::arch::aarch64::*;

/// Two numbers in a register: a pair of single ones.
#[derive(Clone, Copy)]
pub struct Two(float64x2_t);

// SAFETY of every block below: NEON is part of the target. Loads and stores stay within the lists
// they are given.
impl Two {
    #[inline(always)]
    fn bits(self) -> uint64x2_t {
        unsafe { vreinterpretq_u64_f64(self.0) }
    }
    #[inline(always)]
    fn from_bits(bits: uint64x2_t) -> Self {
        Self(unsafe { vreinterpretq_f64_u64(bits) })
    }
    #[inline(always)]
    fn whole(bits: u64) -> uint64x2_t {
        unsafe { vdupq_n_u64(bits) }
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident $intrinsic:ident),*) => {$(
        impl $trait for Two {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    )*};
    (f64: $($trait:ident $method:ident),*) => {$(
        impl $trait<f64> for Two {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                self.$method(Self::same(other))
            }
        }
    )*};
}

operators!(Add add vaddq_f64, Sub sub vsubq_f64, Mul mul vmulq_f64, Div div vdivq_f64);
operators!(f64: Add add, Sub sub, Mul mul);

impl Neg for Two {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(unsafe { vnegq_f64(self.0) })
    }
}

impl Number for Two {
    #[inline(always)]
    fn same(value: f64) -> Self {
        Self(unsafe { vdupq_n_f64(value) })
    }
    #[inline(always)]
    fn leading(self) -> Self {
        Self::from_bits(unsafe {
            let rounded = vaddq_u64(self.bits(), Self::whole(HALF));
            vandq_u64(rounded, Self::whole(LEADING))
        })
    }
    #[inline(always)]
    fn negative_if_odd(self, whole: Self) -> Self {
        Self::from_bits(unsafe { veorq_u64(self.bits(), vshlq_n_u64::<63>(whole.bits())) })
    }
    #[inline(always)]
    fn negative_if_half(self, whole: Self) -> Self {
        Self::from_bits(unsafe {
            let sign = vandq_u64(vshlq_n_u64::<62>(whole.bits()), Self::whole(SIGN));
            veorq_u64(self.bits(), sign)
        })
    }
    #[inline(always)]
    fn or_if_odd(self, odd: Self, whole: Self) -> Self {
        Self(unsafe {
            let mask = vtstq_u64(whole.bits(), Self::whole(1));
            vbslq_f64(mask, odd.0, self.0)
        })
    }
    #[inline(always)]
    fn two_to(whole: Self) -> Self {
        Self::from_bits(unsafe { vaddq_u64(vshlq_n_u64::<52>(whole.bits()), Self::whole(ONE)) })
    }
}

impl Lane for Two {
    const WIDTH: usize = 2;
    #[inline(always)]
    fn of(value: f64) -> Self {
        Self::same(value)
    }
    #[inline(always)]
    fn load(values: &[f64]) -> Self {
        assert!(values.len() >= 2);
        Self(unsafe { vld1q_f64(values.as_ptr()) })
    }
    #[inline(always)]
    fn store(self, values: &mut [f64]) {
        assert!(values.len() >= 2);
        unsafe { vst1q_f64(values.as_mut_ptr(), self.0) }
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(unsafe { vsqrtq_f64(self.0) })
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(unsafe { vabsq_f64(self.0) })
    }
    #[inline(always)]
    fn within(self, bound: f64) -> Self {
        let (least, most) = (Self::same(-bound), Self::same(bound));
        Self(unsafe { vminq_f64(vmaxq_f64(self.0, least.0), most.0) })
    }
    #[inline(always)]
    fn sum(self) -> f64 {
        let (first, second) = self.parts();
        first + second
    }
}

impl Phased for Two {
    type Pair = Both<Self>;
}

impl Pair<f64> for Two {
    #[inline(always)]
    fn new(first: f64, second: f64) -> Self {
        Self(unsafe { vcombine_f64(vdup_n_f64(first), vdup_n_f64(second)) })
    }
    #[inline(always)]
    fn both(values: &[f64; 2]) -> Self {
        Self::load(values)
    }
    #[inline(always)]
    fn parts(self) -> (f64, f64) {
        unsafe { (vgetq_lane_f64::<0>(self.0), vgetq_lane_f64::<1>(self.0)) }
    }
    #[inline(always)]
    fn swapped(self) -> Self {
        Self(unsafe { vextq_f64::<1>(self.0, self.0) })
    }
}
