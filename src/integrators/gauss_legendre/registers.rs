//! Eight numbers in the registers that a processor has.
//!
//! Each kind does the same operations in the same order, none contracted, so the
//! bits are the same. Which kind there is is asked at run time, by [`super::sweeps`].

use crate::math::Lane;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// The registers that a run may use; it takes the best of them that there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Registers {
    /// What every processor of its kind has.
    Common,
    /// Up to those of AVX2: four numbers each.
    Avx2,
    /// Up to those of AVX-512: eight numbers.
    Avx512,
}

/// A [`Lane`] of eight numbers.
pub trait Octet: Lane {
    /// The absolute values.
    fn abs(self) -> Self;
    /// The sum of the eight, first the number of each half's lane, then of each quarter's.
    fn sum(self) -> f64;
}

/// The sum of four: all kinds of registers end with these additions.
#[inline(always)]
fn sum_of_four([a, b, c, d]: [f64; 4]) -> f64 {
    (a + c) + (b + d)
}

/// In memory; the compiler finds the registers.
#[derive(Clone, Copy)]
pub struct Common([f64; 8]);

macro_rules! lane_by_lane {
    ($trait:ident, $method:ident) => {
        impl $trait for Common {
            type Output = Self;
            #[inline(always)]
            fn $method(mut self, other: Self) -> Self {
                for i in 0..8 {
                    self.0[i] = self.0[i].$method(other.0[i]);
                }
                self
            }
        }
    };
}
lane_by_lane!(Add, add);
lane_by_lane!(Sub, sub);
lane_by_lane!(Mul, mul);
lane_by_lane!(Div, div);

impl Neg for Common {
    type Output = Self;
    #[inline(always)]
    fn neg(mut self) -> Self {
        for i in 0..8 {
            self.0[i] = -self.0[i];
        }
        self
    }
}

/// A register and a number.
macro_rules! with_number {
    ($name:ident: $($trait:ident $method:ident),*) => {
        $(impl $trait<f64> for $name {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                self.$method(Self::of(other))
            }
        })*
    };
}
with_number!(Common: Add add, Sub sub, Mul mul);

impl Lane for Common {
    const WIDTH: usize = 8;
    #[inline(always)]
    fn of(value: f64) -> Self {
        Self([value; 8])
    }
    #[inline(always)]
    fn load(values: &[f64; 8]) -> Self {
        Self(*values)
    }
    #[inline(always)]
    fn store(self, values: &mut [f64; 8]) {
        *values = self.0;
    }
    #[inline(always)]
    fn sqrt(mut self) -> Self {
        for i in 0..8 {
            self.0[i] = self.0[i].sqrt();
        }
        self
    }
}

impl Octet for Common {
    #[inline(always)]
    fn abs(mut self) -> Self {
        for i in 0..8 {
            self.0[i] = self.0[i].abs();
        }
        self
    }
    #[inline(always)]
    fn sum(self) -> f64 {
        let [a, b, c, d, e, f, g, h] = self.0;
        sum_of_four([a + e, b + f, c + g, d + h])
    }
}

#[cfg(target_arch = "x86_64")]
pub use x86::{Avx2, Avx512};

// SAFETY of every block: `super::sweeps` makes values of the two types only where it
// has found their instructions. Loads and stores stay within the eight numbers.
#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{Add, Div, Lane, Mul, Neg, Octet, Sub, sum_of_four};
    use core::arch::x86_64::*;

    /// One register of AVX-512. Only for a processor that has them.
    #[derive(Clone, Copy)]
    pub struct Avx512(__m512d);

    /// Two registers of AVX2. Only for a processor that has them.
    #[derive(Clone, Copy)]
    pub struct Avx2(__m256d, __m256d);

    macro_rules! operators {
        ($($trait:ident $method:ident $eight:ident $four:ident),*) => {
            $(impl $trait for Avx512 {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    Self(unsafe { $eight(self.0, other.0) })
                }
            }
            impl $trait for Avx2 {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    Self(
                        unsafe { $four(self.0, other.0) },
                        unsafe { $four(self.1, other.1) },
                    )
                }
            })*
        };
    }
    operators!(
        Add add _mm512_add_pd _mm256_add_pd,
        Sub sub _mm512_sub_pd _mm256_sub_pd,
        Mul mul _mm512_mul_pd _mm256_mul_pd,
        Div div _mm512_div_pd _mm256_div_pd
    );
    with_number!(Avx512: Add add, Sub sub, Mul mul);
    with_number!(Avx2: Add add, Sub sub, Mul mul);

    impl Neg for Avx512 {
        type Output = Self;
        #[inline(always)]
        fn neg(self) -> Self {
            // Exclusive or of doubles is not in the foundation of AVX-512, that of integers is.
            Self(unsafe {
                let signs = _mm512_castpd_si512(_mm512_set1_pd(-0.0));
                _mm512_castsi512_pd(_mm512_xor_si512(_mm512_castpd_si512(self.0), signs))
            })
        }
    }

    impl Neg for Avx2 {
        type Output = Self;
        #[inline(always)]
        fn neg(self) -> Self {
            unsafe {
                let signs = _mm256_set1_pd(-0.0);
                Self(_mm256_xor_pd(self.0, signs), _mm256_xor_pd(self.1, signs))
            }
        }
    }

    impl Lane for Avx512 {
        const WIDTH: usize = 8;
        #[inline(always)]
        fn of(value: f64) -> Self {
            Self(unsafe { _mm512_set1_pd(value) })
        }
        #[inline(always)]
        fn load(values: &[f64; 8]) -> Self {
            Self(unsafe { _mm512_loadu_pd(values.as_ptr()) })
        }
        #[inline(always)]
        fn store(self, values: &mut [f64; 8]) {
            unsafe { _mm512_storeu_pd(values.as_mut_ptr(), self.0) }
        }
        #[inline(always)]
        fn sqrt(self) -> Self {
            Self(unsafe { _mm512_sqrt_pd(self.0) })
        }
    }

    impl Lane for Avx2 {
        const WIDTH: usize = 8;
        #[inline(always)]
        fn of(value: f64) -> Self {
            let four = unsafe { _mm256_set1_pd(value) };
            Self(four, four)
        }
        #[inline(always)]
        fn load(values: &[f64; 8]) -> Self {
            let at = values.as_ptr();
            unsafe { Self(_mm256_loadu_pd(at), _mm256_loadu_pd(at.add(4))) }
        }
        #[inline(always)]
        fn store(self, values: &mut [f64; 8]) {
            let at = values.as_mut_ptr();
            unsafe {
                _mm256_storeu_pd(at, self.0);
                _mm256_storeu_pd(at.add(4), self.1);
            }
        }
        #[inline(always)]
        fn sqrt(self) -> Self {
            Self(unsafe { _mm256_sqrt_pd(self.0) }, unsafe {
                _mm256_sqrt_pd(self.1)
            })
        }
    }

    impl Octet for Avx512 {
        #[inline(always)]
        fn abs(self) -> Self {
            Self(unsafe { _mm512_abs_pd(self.0) })
        }
        #[inline(always)]
        fn sum(self) -> f64 {
            let halves = unsafe {
                Avx2(
                    _mm512_castpd512_pd256(self.0),
                    _mm512_extractf64x4_pd::<1>(self.0),
                )
            };
            halves.sum()
        }
    }

    impl Octet for Avx2 {
        #[inline(always)]
        fn abs(self) -> Self {
            unsafe {
                let signs = _mm256_set1_pd(-0.0);
                Self(
                    _mm256_andnot_pd(signs, self.0),
                    _mm256_andnot_pd(signs, self.1),
                )
            }
        }
        #[inline(always)]
        fn sum(self) -> f64 {
            let mut four = [0.0; 4];
            unsafe { _mm256_storeu_pd(four.as_mut_ptr(), _mm256_add_pd(self.0, self.1)) };
            sum_of_four(four)
        }
    }
}
