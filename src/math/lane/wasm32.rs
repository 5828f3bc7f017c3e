//! The vector registers of WebAssembly.

use super::{Add, Both, Div, HALF, LEADING, Lane, Mul, Neg, Number, ONE, Pair, Phased, Sub};
use core::arch::wasm32::*;

/// Two numbers in a register: a pair of single ones.
#[derive(Clone, Copy)]
pub struct Two(v128);

impl Two {
    #[inline(always)]
    fn whole(bits: u64) -> v128 {
        u64x2_splat(bits)
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident $intrinsic:ident),*) => {$(
        impl $trait for Two {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($intrinsic(self.0, other.0))
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

operators!(Add add f64x2_add, Sub sub f64x2_sub, Mul mul f64x2_mul, Div div f64x2_div);
operators!(f64: Add add, Sub sub, Mul mul);

impl Neg for Two {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(f64x2_neg(self.0))
    }
}

impl Number for Two {
    #[inline(always)]
    fn same(value: f64) -> Self {
        Self(f64x2_splat(value))
    }
    #[inline(always)]
    fn leading(self) -> Self {
        let rounded = i64x2_add(self.0, Self::whole(HALF));
        Self(v128_and(rounded, Self::whole(LEADING)))
    }
    #[inline(always)]
    fn negative_if_odd(self, whole: Self) -> Self {
        Self(v128_xor(self.0, i64x2_shl(whole.0, 63)))
    }
    #[inline(always)]
    fn negative_if_half(self, whole: Self) -> Self {
        let sign = v128_and(i64x2_shl(whole.0, 62), Self::whole(super::SIGN));
        Self(v128_xor(self.0, sign))
    }
    #[inline(always)]
    fn or_if_odd(self, odd: Self, whole: Self) -> Self {
        let mask = i64x2_neg(v128_and(whole.0, Self::whole(1)));
        Self(v128_bitselect(odd.0, self.0, mask))
    }
    #[inline(always)]
    fn two_to(whole: Self) -> Self {
        Self(i64x2_add(i64x2_shl(whole.0, 52), Self::whole(ONE)))
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
        Self(f64x2(values[0], values[1]))
    }
    #[inline(always)]
    fn store(self, values: &mut [f64]) {
        (values[0], values[1]) = self.parts();
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(f64x2_sqrt(self.0))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(f64x2_abs(self.0))
    }
    #[inline(always)]
    fn within(self, bound: f64) -> Self {
        let least = f64x2_max(self.0, f64x2_splat(-bound));
        Self(f64x2_min(least, f64x2_splat(bound)))
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
        Self(f64x2(first, second))
    }
    #[inline(always)]
    fn both(values: &[f64; 2]) -> Self {
        Self(f64x2(values[0], values[1]))
    }
    #[inline(always)]
    fn parts(self) -> (f64, f64) {
        (f64x2_extract_lane::<0>(self.0), f64x2_extract_lane::<1>(self.0))
    }
    #[inline(always)]
    fn swapped(self) -> Self {
        Self(i64x2_shuffle::<1, 0>(self.0, self.0))
    }
}
