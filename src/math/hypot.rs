//! The length of a plane vector.

use super::double_double::two_product;

/// sqrt(x^2 + y^2) without overflow or underflow on the way.
///
/// The bits are the same as from `libm::hypot`, whose square root is computed in software where a
/// compiler may not ask for the processor's, as in WebAssembly: there this takes half the time.
///
/// Source: musl's `hypot`, by Szabolcs Nagy.
///
/// ```
/// use rotation_dynamics::math::hypot;
/// assert_eq!(hypot(3.0, -4.0), 5.0);
/// assert_eq!(hypot(f64::NAN, f64::INFINITY), f64::INFINITY);
/// ```
pub fn hypot(x: f64, y: f64) -> f64 {
    let exponent = |value: f64| (value.to_bits() >> 52) as i32 - 1023;
    let (x, y) = (x.abs(), y.abs());
    // As whole numbers, for which NaN is the largest.
    let (large, small) = match x.to_bits() < y.to_bits() {
        true => (y, x),
        false => (x, y),
    };
    if exponent(small) == 1024 {
        return small;
    }
    if exponent(large) == 1024 || small == 0.0 || exponent(large) - exponent(small) > 64 {
        return large + small;
    }
    let root = |large: f64, small: f64| {
        let (large, large_rest) = two_product(large, large);
        let (small, small_rest) = two_product(small, small);
        f64::sqrt(small_rest + large_rest + small + large)
    };
    // Squares must not overflow, nor their errors underflow.
    if exponent(large) > 510 {
        HUGE * root(large * TINY, small * TINY)
    } else if exponent(small) < -450 {
        TINY * root(large * HUGE, small * HUGE)
    } else {
        root(large, small)
    }
}

/// 2^700
const HUGE: f64 = f64::from_bits((1023 + 700) << 52);
/// 2^-700
const TINY: f64 = f64::from_bits((1023 - 700) << 52);

#[cfg(test)]
mod tests {
    use super::hypot;

    #[test]
    fn the_bits_are_those_of_libm() {
        // Signs, exponents and digits at random, the same ones each time (xorshift).
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        let mut number = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            state
        };
        let edges = [0.0, -0.0, 1.0, f64::MIN_POSITIVE, 5e-324, f64::MAX, f64::INFINITY, f64::NAN];
        let mut cases: Vec<[f64; 2]> = edges.iter().flat_map(|x| edges.map(|y| [*x, y])).collect();
        for _ in 0..200_000 {
            let (x, y) = (number(), number());
            let near = (x & !(0x7f << 52)) | (y & (0x7f << 52));
            cases.extend([[x, y], [x, near], [near, x]].map(|pair| pair.map(f64::from_bits)));
        }
        for [x, y] in cases {
            let (found, expected) = (hypot(x, y), libm::hypot(x, y));
            let same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
            assert!(same, "hypot({x:e}, {y:e}) = {found:e}, and not {expected:e}");
        }
    }
}
