//! The only door to elementary functions, and double-double arithmetic.
//!
//! Platforms disagree in the last bit of `sin`, `exp` and their kin; the `libm`
//! crate does not. Every elementary function of this library goes through this
//! module, so a snapshot holds on every machine. (`sqrt`, `abs`, `floor` and the
//! four operations are exact by IEEE 754 and are used as methods of `f64`.)

pub(crate) mod bracket;
pub mod double_double;
mod hyperbolic;
mod hypot;
#[allow(unsafe_code, reason = "registers are loaded, stored and reached by their features")]
pub mod lane;
mod order;
mod product;
mod turns;
mod versine;

pub use double_double::DoubleDouble;
pub(crate) use hyperbolic::{STEEPEST, sinh_cosh_of};
pub use hypot::hypot;
pub use lane::Lane;
pub use libm::{
    acos, acosh, asin, asinh, atan, atan2, atanh, cbrt, cos, cosh, exp, exp2, expm1, fmod, ilogb,
    ldexp, log, log1p, log2, log10, pow, sin, sincos, sinh, tan, tanh,
};
pub(crate) use order::order_of_three;
pub use order::{order_of, sort_by_number};
pub(crate) use product::Exact;
pub(crate) use turns::{Clock, MOST_TURNS, Reduced, Time, latest, sincos_of, unsigned_sincos_of};
pub use turns::{round_even, sincos_turns};
pub(crate) use versine::sinc_versine;

/// The unit round-off of `f64`, 2^-53: half the distance from 1 to the next number.
pub const EPS: f64 = 1.110_223_024_625_156_5e-16;

/// Unlike `f64::max` it keeps a NaN, on either side.
pub(crate) const fn larger(a: f64, b: f64) -> f64 {
    if a > b || a.is_nan() { a } else { b }
}

const _: () = assert!(larger(f64::NAN, 1.0).is_nan() && larger(1.0, f64::NAN).is_nan());

/// Unlike `f64::min` it keeps a NaN, on either side.
pub(crate) const fn smaller(a: f64, b: f64) -> f64 {
    -larger(-a, -b)
}
