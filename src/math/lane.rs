//! One text for one number and for several at once.
//!
//! A sample of a closed form without a branch is written over [`Lane`]. With `f64`
//! it is the scalar code; with a vector register each lane does the same operations
//! in the same order, none contracted, so the bits are the same. Which registers there
//! are is asked at run time.
//!
//! Not for: elementary functions of `libm`, or anything with a branch.

use core::ops::{Add, Div, Mul, Neg, Sub};

/// A number, or several that go through the same arithmetic side by side.
pub trait Lane:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
{
    /// How many numbers: at most [`WIDEST`].
    const WIDTH: usize;
    /// The same number in every lane.
    fn of(value: f64) -> Self;
    /// The first `WIDTH` numbers.
    fn load(values: &[f64; WIDEST]) -> Self;
    /// Writes the first `WIDTH` numbers.
    fn store(self, values: &mut [f64; WIDEST]);
    /// The square root, correctly rounded.
    fn sqrt(self) -> Self;
}

/// The most numbers a [`Lane`] holds.
pub const WIDEST: usize = 8;

impl Lane for f64 {
    const WIDTH: usize = 1;
    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn load(values: &[f64; WIDEST]) -> Self {
        values[0]
    }
    #[inline(always)]
    fn store(self, values: &mut [f64; WIDEST]) {
        values[0] = self;
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
}

/// A sample that takes a time to `N` numbers without a branch.
pub(crate) trait Sampler<const N: usize> {
    fn sample<L: Lane>(&self, t: L) -> [L; N];
}

/// Hands the sample at each time to `put`, with the widest registers the processor has.
pub(crate) fn for_each_sample<const N: usize>(
    sampler: &impl Sampler<N>,
    times: &[f64],
    put: impl FnMut([f64; N]),
) {
    #[cfg(target_arch = "x86_64")]
    {
        if std::is_x86_feature_detected!("avx512f") {
            // SAFETY: the processor has the feature, as just detected.
            return unsafe { x86::avx512(sampler, times, put) };
        }
        if std::is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has the feature, as just detected.
            return unsafe { x86::avx2(sampler, times, put) };
        }
    }
    run::<f64, N>(sampler, times, put);
}

#[inline(always)]
fn run<L: Lane, const N: usize>(
    sampler: &impl Sampler<N>,
    times: &[f64],
    mut put: impl FnMut([f64; N]),
) {
    for chunk in times.chunks(L::WIDTH) {
        // A short last chunk is filled up; what the idle lanes give is dropped.
        let mut t = [chunk[0]; WIDEST];
        t[..chunk.len()].copy_from_slice(chunk);
        let mut rows = [[0.0; WIDEST]; N];
        for (row, value) in rows.iter_mut().zip(sampler.sample(L::load(&t))) {
            value.store(row);
        }
        (0..chunk.len()).for_each(|lane| put(core::array::from_fn(|i| rows[i][lane])));
    }
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{Add, Div, Lane, Mul, Neg, Sampler, Sub, WIDEST, run};
    use core::arch::x86_64::*;

    /// Only for a processor that has AVX-512F.
    #[target_feature(enable = "avx512f")]
    pub(super) fn avx512<const N: usize>(
        sampler: &impl Sampler<N>,
        times: &[f64],
        put: impl FnMut([f64; N]),
    ) {
        run::<Eight, N>(sampler, times, put);
    }

    /// Only for a processor that has AVX2.
    #[target_feature(enable = "avx2")]
    pub(super) fn avx2<const N: usize>(
        sampler: &impl Sampler<N>,
        times: &[f64],
        put: impl FnMut([f64; N]),
    ) {
        run::<Four, N>(sampler, times, put);
    }

    // SAFETY of every block below: the two types are private to this module, and
    // values of them exist only inside `avx512` and `avx2`, which run where the
    // instructions exist. Loads and stores stay within `WIDEST` numbers.
    macro_rules! lanes {
        ($name:ident, $register:ty, $width:literal, $set:ident, $load:ident, $store:ident,
         $add:ident, $sub:ident, $mul:ident, $div:ident, $sqrt:ident) => {
            #[derive(Clone, Copy)]
            struct $name($register);

            impl Lane for $name {
                const WIDTH: usize = $width;
                #[inline(always)]
                fn of(value: f64) -> Self {
                    Self(unsafe { $set(value) })
                }
                #[inline(always)]
                fn load(values: &[f64; WIDEST]) -> Self {
                    Self(unsafe { $load(values.as_ptr()) })
                }
                #[inline(always)]
                fn store(self, values: &mut [f64; WIDEST]) {
                    unsafe { $store(values.as_mut_ptr(), self.0) }
                }
                #[inline(always)]
                fn sqrt(self) -> Self {
                    Self(unsafe { $sqrt(self.0) })
                }
            }

            lanes!(@operator $name, Add, add, $add);
            lanes!(@operator $name, Sub, sub, $sub);
            lanes!(@operator $name, Mul, mul, $mul);

            impl Div for $name {
                type Output = Self;
                #[inline(always)]
                fn div(self, other: Self) -> Self {
                    Self(unsafe { $div(self.0, other.0) })
                }
            }

            impl Neg for $name {
                type Output = Self;
                #[inline(always)]
                fn neg(self) -> Self {
                    // From -0, so that the sign of a zero turns as well.
                    Self::of(-0.0) - self
                }
            }
        };
        (@operator $name:ident, $trait:ident, $method:ident, $intrinsic:ident) => {
            impl $trait for $name {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    Self(unsafe { $intrinsic(self.0, other.0) })
                }
            }

            impl $trait<f64> for $name {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: f64) -> Self {
                    self.$method(Self::of(other))
                }
            }
        };
    }

    lanes!(
        Eight,
        __m512d,
        8,
        _mm512_set1_pd,
        _mm512_loadu_pd,
        _mm512_storeu_pd,
        _mm512_add_pd,
        _mm512_sub_pd,
        _mm512_mul_pd,
        _mm512_div_pd,
        _mm512_sqrt_pd
    );
    lanes!(
        Four,
        __m256d,
        4,
        _mm256_set1_pd,
        _mm256_loadu_pd,
        _mm256_storeu_pd,
        _mm256_add_pd,
        _mm256_sub_pd,
        _mm256_mul_pd,
        _mm256_div_pd,
        _mm256_sqrt_pd
    );

    #[cfg(test)]
    mod tests {
        use super::*;
        use crate::math::sincos_turns;

        struct Probe;
        impl Sampler<3> for Probe {
            fn sample<L: Lane>(&self, t: L) -> [L; 3] {
                let (sin, cos) = sincos_turns(t);
                [sin, -cos, (t * t + 1.0).sqrt() / (t - 0.3)]
            }
        }

        /// Every width this processor has gives the scalar bits, whatever the length.
        #[test]
        fn every_width_gives_the_scalar_bits() {
            let mut compared = 0;
            for length in 0..300 {
                let times: Vec<f64> = (0..length).map(|k| f64::from(k) * 0.37 - 20.0).collect();
                let expected: Vec<_> = times
                    .iter()
                    .map(|t| Probe.sample(*t).map(f64::to_bits))
                    .collect();
                let mut check = |found: Vec<[u64; 3]>| {
                    assert_eq!(found, expected);
                    compared += found.len();
                };
                let mut found = Vec::new();
                run::<f64, 3>(&Probe, &times, |s| found.push(s.map(f64::to_bits)));
                check(found);
                if std::is_x86_feature_detected!("avx2") {
                    let mut found = Vec::new();
                    // SAFETY: just detected.
                    unsafe { avx2(&Probe, &times, |s| found.push(s.map(f64::to_bits))) };
                    check(found);
                }
                if std::is_x86_feature_detected!("avx512f") {
                    let mut found = Vec::new();
                    // SAFETY: just detected.
                    unsafe { avx512(&Probe, &times, |s| found.push(s.map(f64::to_bits))) };
                    check(found);
                }
            }
            assert!(compared >= 44_850, "only {compared} samples compared");
        }
    }
}
