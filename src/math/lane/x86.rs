//! The vector registers of x86-64.

use super::{Add, Both, Div, HALF, LEADING, Lane, Mul, Neg, Number, ONE, Pair, Phased, Sub, Work};
#[cfg(not(target_feature = "fma"))]
use core::arch::asm;
use core::arch::x86_64::*;

/// Only for a processor that has AVX-512F.
#[target_feature(enable = "avx512f")]
pub(super) fn avx512(work: impl Work) {
    work.run::<Eight>();
}

/// Only for a processor that has AVX2.
#[target_feature(enable = "avx2")]
pub(super) fn avx2(work: impl Work) {
    work.run::<Four>();
}

// SAFETY of every block below: `Two` needs SSE2, which every x86-64 has. Values of `Four` and
// `Eight` exist only inside functions that run where the instructions exist: `avx2` and `avx512`
// here, and those of the same kind in `integrators::gauss_legendre`. Loads and stores stay within
// the lists they are given.
macro_rules! register {
    ($name:ident($register:ty), $width:literal, $set:ident, $load:ident, $store:ident,
     $add:ident, $sub:ident, $mul:ident, $div:ident, $sqrt:ident, $min:ident, $max:ident,
     $integer:ident, $from_integer:ident, $whole:ident, $plus:ident, $and:ident, $xor:ident, $shift:ident,
     $or_if_odd:expr, $halves:expr) => {
        impl Number for $name {
            #[inline(always)]
            fn same(value: f64) -> Self {
                Self(unsafe { $set(value) })
            }
            #[inline(always)]
            fn leading(self) -> Self {
                Self(unsafe {
                    let rounded = $plus($integer(self.0), $whole(HALF as i64));
                    $from_integer($and(rounded, $whole(LEADING as i64)))
                })
            }
            #[inline(always)]
            fn negative_if_odd(self, whole: Self) -> Self {
                Self(unsafe {
                    $from_integer($xor($integer(self.0), $shift::<63>($integer(whole.0))))
                })
            }
            #[inline(always)]
            fn negative_if_half(self, whole: Self) -> Self {
                Self(unsafe {
                    let sign = $and($shift::<62>($integer(whole.0)), $whole(i64::MIN));
                    $from_integer($xor($integer(self.0), sign))
                })
            }
            #[inline(always)]
            fn or_if_odd(self, odd: Self, whole: Self) -> Self {
                Self(unsafe { $or_if_odd(self.0, odd.0, $integer(whole.0)) })
            }
            #[inline(always)]
            fn two_to(whole: Self) -> Self {
                Self(unsafe {
                    let exponent = $shift::<52>($integer(whole.0));
                    $from_integer($plus(exponent, $whole(ONE as i64)))
                })
            }
        }

        impl Lane for $name {
            const WIDTH: usize = $width;
            #[inline(always)]
            fn of(value: f64) -> Self {
                Self::same(value)
            }
            #[inline(always)]
            fn load(values: &[f64]) -> Self {
                assert!(values.len() >= $width);
                Self(unsafe { $load(values.as_ptr()) })
            }
            #[inline(always)]
            fn store(self, values: &mut [f64]) {
                assert!(values.len() >= $width);
                unsafe { $store(values.as_mut_ptr(), self.0) }
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(unsafe { $sqrt(self.0) })
            }
            #[inline(always)]
            fn abs(self) -> Self {
                Self(unsafe { $from_integer($and($integer(self.0), $whole(!i64::MIN))) })
            }
            #[inline(always)]
            fn within(self, bound: f64) -> Self {
                // Of a number and none, these instructions give the second.
                Self(unsafe { $min($set(bound), $max($set(-bound), self.0)) })
            }
            #[inline(always)]
            fn sum(self) -> f64 {
                let (low, high) = $halves(self.0);
                (low + high).sum()
            }
        }

        impl Phased for $name {
            type Pair = Both<Self>;
        }

        impl Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self(unsafe { $from_integer($xor($integer(self.0), $whole(i64::MIN))) })
            }
        }

        register!(@operator $name, Div div $div);
        register!(@operator $name, Add add $add, Sub sub $sub, Mul mul $mul);
        register!(@number $name, Add add, Sub sub, Mul mul);
    };
    (@operator $name:ident, $($trait:ident $method:ident $intrinsic:ident),*) => {$(
        impl $trait for $name {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    )*};
    (@number $name:ident, $($trait:ident $method:ident),*) => {$(
        impl $trait<f64> for $name {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                self.$method(Self::same(other))
            }
        }
    )*};
}

/// Eight numbers in a register of AVX-512.
#[derive(Clone, Copy)]
pub(crate) struct Eight(__m512d);

register!(
    Eight(__m512d),
    8,
    _mm512_set1_pd,
    _mm512_loadu_pd,
    _mm512_storeu_pd,
    _mm512_add_pd,
    _mm512_sub_pd,
    _mm512_mul_pd,
    _mm512_div_pd,
    _mm512_sqrt_pd,
    _mm512_min_pd,
    _mm512_max_pd,
    _mm512_castpd_si512,
    _mm512_castsi512_pd,
    _mm512_set1_epi64,
    _mm512_add_epi64,
    _mm512_and_si512,
    _mm512_xor_si512,
    _mm512_slli_epi64,
    |even, odd, whole| {
        let mask = _mm512_test_epi64_mask(whole, _mm512_set1_epi64(1));
        _mm512_mask_blend_pd(mask, even, odd)
    },
    |all| unsafe {
        let high = _mm512_extractf64x4_pd::<1>(all);
        (Four(_mm512_castpd512_pd256(all)), Four(high))
    }
);

/// Four numbers in a register of AVX.
#[derive(Clone, Copy)]
pub(crate) struct Four(__m256d);

register!(
    Four(__m256d),
    4,
    _mm256_set1_pd,
    _mm256_loadu_pd,
    _mm256_storeu_pd,
    _mm256_add_pd,
    _mm256_sub_pd,
    _mm256_mul_pd,
    _mm256_div_pd,
    _mm256_sqrt_pd,
    _mm256_min_pd,
    _mm256_max_pd,
    _mm256_castpd_si256,
    _mm256_castsi256_pd,
    _mm256_set1_epi64x,
    _mm256_add_epi64,
    _mm256_and_si256,
    _mm256_xor_si256,
    _mm256_slli_epi64,
    |even, odd, whole| {
        // The blend looks at the sign alone.
        let sign = _mm256_castsi256_pd(_mm256_slli_epi64::<63>(whole));
        _mm256_blendv_pd(even, odd, sign)
    },
    |all| unsafe {
        let high = _mm256_extractf128_pd::<1>(all);
        (Two(_mm256_castpd256_pd128(all)), Two(high))
    }
);

/// Eight numbers in two registers of AVX.
pub(crate) type FourTwice = Both<Four>;

/// Two numbers in a register of SSE2: a pair of single ones.
#[derive(Clone, Copy)]
pub struct Two(__m128d);

register!(
    Two(__m128d),
    2,
    _mm_set1_pd,
    _mm_loadu_pd,
    _mm_storeu_pd,
    _mm_add_pd,
    _mm_sub_pd,
    _mm_mul_pd,
    _mm_div_pd,
    _mm_sqrt_pd,
    _mm_min_pd,
    _mm_max_pd,
    _mm_castpd_si128,
    _mm_castsi128_pd,
    _mm_set1_epi64x,
    _mm_add_epi64,
    _mm_and_si128,
    _mm_xor_si128,
    _mm_slli_epi64,
    |even, odd, whole| {
        let bit = _mm_and_si128(whole, _mm_set1_epi64x(1));
        let mask = _mm_castsi128_pd(_mm_sub_epi64(_mm_setzero_si128(), bit));
        _mm_or_pd(_mm_andnot_pd(mask, even), _mm_and_pd(mask, odd))
    },
    |all| Two(all).parts()
);

impl Pair<f64> for Two {
    #[inline(always)]
    fn new(first: f64, second: f64) -> Self {
        Self(unsafe { _mm_set_pd(second, first) })
    }
    #[inline(always)]
    fn both(values: &[f64; 2]) -> Self {
        Self(unsafe { _mm_loadu_pd(values.as_ptr()) })
    }
    #[inline(always)]
    fn parts(self) -> (f64, f64) {
        unsafe {
            let second = _mm_unpackhi_pd(self.0, self.0);
            (_mm_cvtsd_f64(self.0), _mm_cvtsd_f64(second))
        }
    }
    #[inline(always)]
    fn swapped(self) -> Self {
        Self(unsafe { _mm_shuffle_pd::<1>(self.0, self.0) })
    }
}

// Not by `mul_add`, which is an instruction only inside functions that are compiled for such
// processors alone, and cannot be inlined into others.
#[cfg(not(target_feature = "fma"))]
macro_rules! fused {
    ($instruction:literal, $a:expr, $b:expr, $product:expr) => {{
        let mut error = $a;
        asm!(
            concat!($instruction, " {error}, {b}, {product}"),
            error = inout(xmm_reg) error,
            b = in(xmm_reg) $b,
            product = in(xmm_reg) $product,
            options(pure, nomem, nostack, preserves_flags),
        );
        error
    }};
}

/// `a b - product`, rounded once.
///
/// # Safety
/// Only for a processor that has FMA.
#[cfg(not(target_feature = "fma"))]
#[inline(always)]
pub(crate) unsafe fn fused(a: f64, b: f64, product: f64) -> f64 {
    // SAFETY: the instruction touches nothing but these registers.
    unsafe { fused!("vfmsub213sd", a, b, product) }
}

#[cfg(not(target_feature = "fma"))]
impl Two {
    /// `self b - product`, rounded once.
    ///
    /// # Safety
    /// Only for a processor that has FMA.
    #[inline(always)]
    pub(crate) unsafe fn fused(self, b: Self, product: Self) -> Self {
        // SAFETY: the instruction touches nothing but these registers.
        Self(unsafe { fused!("vfmsub213pd", self.0, b.0, product.0) })
    }
}
