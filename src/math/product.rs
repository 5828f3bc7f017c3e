//! The error of a rounded product, which is a number.
//!
//! A fused multiplication gives it at once. Where the processor has none, halves of 26 bits do
//! (Veltkamp's splitting, Dekker), and outside the range in which they are exact `libm`'s `fma`,
//! in software: the same bits everywhere. Of x86-64 only the processor knows, so it is asked when
//! the program runs, once; a branch that is always taken alike costs less than splitting.
//!
//! Not for: registers wider than two numbers ([`super::double_double::two_product`] has all).

use super::double_double::error_by_halves;
use super::lane::{Both, Lane};

/// Numbers whose products leave their error.
pub trait Exact: Lane {
    /// `self other - product` for `product`, which is `self * other`.
    fn product_error(self, other: Self, product: Self) -> Self;
}

impl<L: Exact> Exact for Both<L> {
    #[inline(always)]
    fn product_error(self, other: Self, product: Self) -> Self {
        self.zip3(other, product, L::product_error)
    }
}

/// The error by halves, or where they are not exact by software.
#[cfg_attr(
    any(target_arch = "aarch64", target_feature = "fma"),
    allow(dead_code, reason = "the test compares")
)]
#[inline(always)]
fn halves(a: f64, b: f64, product: f64) -> f64 {
    const LEAST: f64 = 1e-290;
    let error = error_by_halves(a, b, product);
    // Smaller ones lose their last bits, and an infinity is a half that is too large.
    if product.abs() >= LEAST && error.is_finite() { error } else { in_software(a, b, product) }
}

#[cold]
#[inline(never)]
fn in_software(a: f64, b: f64, product: f64) -> f64 {
    libm::fma(a, b, -product)
}

/// Where every processor has the instruction, or none that is known of.
#[cfg(any(not(target_arch = "x86_64"), target_feature = "fma"))]
mod known {
    use super::Exact;

    impl Exact for f64 {
        #[inline(always)]
        fn product_error(self, other: Self, product: Self) -> Self {
            if cfg!(any(target_arch = "aarch64", target_feature = "fma")) {
                self.mul_add(other, -product)
            } else {
                super::halves(self, other, product)
            }
        }
    }

    #[cfg(any(target_arch = "x86_64", target_arch = "aarch64", target_feature = "simd128"))]
    impl Exact for super::super::lane::Two {
        #[inline(always)]
        fn product_error(self, other: Self, product: Self) -> Self {
            use super::super::lane::Pair;
            let ((a, c), (b, d), (p, q)) = (self.parts(), other.parts(), product.parts());
            Self::new(a.product_error(b, p), c.product_error(d, q))
        }
    }
}

/// Where the processor has to be asked.
#[cfg(all(target_arch = "x86_64", not(target_feature = "fma")))]
#[allow(unsafe_code, reason = "it calls what the processor was just asked for")]
mod asked {
    use super::super::lane::{Pair, Two, fused, has_fma};
    use super::{Exact, halves};
    use core::sync::atomic::{AtomicU8, Ordering::Relaxed};

    const UNASKED: u8 = 0;
    const HALVES: u8 = 1;
    const FUSED: u8 = 2;
    /// The ways that the processor has.
    static WAY: AtomicU8 = AtomicU8::new(UNASKED);

    impl Exact for f64 {
        #[inline(always)]
        fn product_error(self, other: Self, product: Self) -> Self {
            if WAY.load(Relaxed) == FUSED {
                // SAFETY: the processor has the instruction.
                unsafe { fused(self, other, product) }
            } else {
                otherwise(self, other, product)
            }
        }
    }

    impl Exact for Two {
        #[inline(always)]
        fn product_error(self, other: Self, product: Self) -> Self {
            if WAY.load(Relaxed) == FUSED {
                // SAFETY: the processor has the instruction.
                unsafe { self.fused(other, product) }
            } else {
                both_otherwise(self, other, product)
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn otherwise(a: f64, b: f64, product: f64) -> f64 {
        if WAY.load(Relaxed) == UNASKED {
            WAY.store(if has_fma() { FUSED } else { HALVES }, Relaxed);
        }
        halves(a, b, product)
    }

    #[cold]
    #[inline(never)]
    fn both_otherwise(a: Two, b: Two, product: Two) -> Two {
        let ((a, c), (b, d), (p, q)) = (a.parts(), b.parts(), product.parts());
        Two::new(otherwise(a, b, p), otherwise(c, d, q))
    }
}

#[cfg(test)]
mod tests {
    use super::super::lane::{Pair, Two};
    use super::*;

    /// Signs, exponents and digits at random, the same ones each time (xorshift); every other
    /// product is near 1.
    fn factors() -> impl Iterator<Item = (f64, f64)> {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        let mut bits = move || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            state
        };
        (0..40_000).map(move |n| {
            let (a, b) = (bits(), bits());
            let exponent = (0x7fe_u64 << 52).saturating_sub(a & (0x7ff << 52));
            let reflected = (b & !(0x7ff << 52)) | exponent;
            let b = if n % 2 == 0 { b } else { reflected };
            (f64::from_bits(a), f64::from_bits(b))
        })
    }

    /// How many errors of products do not have the bits of the processor's own, one number or
    /// two at a time, by this way without a fused multiplication.
    fn differing(way: impl Fn(f64, f64, f64) -> f64) -> usize {
        let same = |x: f64, y: f64| x.to_bits() == y.to_bits() || (x.is_nan() && y.is_nan());
        let differs = |(a, b): &(f64, f64)| {
            let product = a * b;
            let [left, right, products] =
                [(*a, 1.5), (*b, 0.1), (product, 1.5 * 0.1)].map(|(x, y)| Two::new(x, y));
            let want = way(*a, *b, product);
            let (one, two) = (a.product_error(*b, product), left.product_error(right, products));
            !(same(one, want) && same(two.parts().0, want))
        };
        factors().filter(differs).count()
    }

    #[test]
    fn both_ways_have_the_same_bits() {
        assert_eq!(differing(halves), 0);
        // Halves alone, outside their range; a factor that has lost its last bit.
        assert!(differing(error_by_halves) > 1000);
        let lost = |a: f64, b, product| halves(f64::from_bits(a.to_bits() & !1), b, product);
        assert!(differing(lost) > 10_000);
    }
}
