//! Double-double arithmetic: 106 significant bits from pairs of doubles.
//!
//! A number is the unevaluated sum `hi + lo` with `|lo| <= ulp(hi)/2`. Set-ups of closed forms use
//! it where a difference of nearly equal numbers decides (gaps between roots, the complement of a
//! modulus) and where a phase is multiplied by a long time. The samples themselves are plain `f64`,
//! but for how far a phase has come.
//!
//! Not for: full IEEE semantics. Intermediate products must stay above about 1e-290: of
//! smaller ones the error is no double.
//!
//! Why each step is exact, and how the set-ups use it: `book/src/how_double_double.md`.
//!
//! Sources: T. J. Dekker, Numer. Math. 18, 224 (1971); M. Joldes, J.-M. Muller,
//! V. Popescu, ACM TOMS 44, 15res (2017), whose error bounds hold for `+` and `*`;
//! Y. Hida, X. Li, D. Bailey, ARITH-15 (2001).

use super::lane::{Lane, Pair, Two};
use super::product::Exact;
use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// An unevaluated sum `hi + lo` of two doubles, 106 bits; or several side by side.
///
/// Largest relative errors measured in `tests/exact/double_double.rs`, in units of
/// 2^-106: `+ * /` and `sqrt` 1.0, `exp` 0.7, `exp_m1` and `ln_1p` 2, `ln` 7,
/// `sinh` 3, `atan2` 0.7; `sin` and `cos` 0.3 of the value plus one.
///
/// ```
/// use rotation_dynamics::math::DoubleDouble;
/// let third = DoubleDouble::from(1.0) / 3.0;
/// let rest = third * 3.0 - 1.0;
/// assert!(rest.abs().to_f64() <= 1e-32);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DoubleDouble<L = f64> {
    hi: L,
    lo: L,
}

/// `a + b` exactly, as rounded sum and error; any order of magnitudes (Knuth).
#[inline(always)]
pub fn two_sum<L: Copy + Add<Output = L> + Sub<Output = L>>(a: L, b: L) -> (L, L) {
    let sum = a + b;
    let b_part = sum - a;
    let a_part = sum - b_part;
    (sum, (a - a_part) + (b - b_part))
}

/// `a + b` exactly when `|a| >= |b|` (Dekker).
#[inline(always)]
pub(crate) fn quick_two_sum<L: Lane>(a: L, b: L) -> (L, L) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// `a * b` exactly, as rounded product and error (Veltkamp's splitting, Dekker).
#[inline(always)]
pub fn two_product<L: Lane>(a: L, b: L) -> (L, L) {
    let product = a * b;
    (product, error_by_halves(a, b, product))
}

/// The error of `product` for two numbers, where no half leaves the range.
#[inline(always)]
pub(super) fn error_by_halves<L: Lane>(a: L, b: L, product: L) -> L {
    let (a_hi, a_lo) = split(a);
    let (b_hi, b_lo) = split(b);
    ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo
}

/// The same as [`two_product`] by the fastest way that the processor has.
#[inline(always)]
fn exact_product<L: Exact>(a: L, b: L) -> (L, L) {
    let product = a * b;
    (product, a.product_error(b, product))
}

/// Two halves of 26 bits each, whose products are exact.
#[inline(always)]
fn split<L: Lane>(a: L) -> (L, L) {
    const SPLITTER: f64 = 134_217_729.0; // 2^27 + 1
    let scaled = a * SPLITTER;
    let hi = scaled - (scaled - a);
    (hi, a - hi)
}

/// A pair and a pair: the sum of two double-doubles.
#[inline(always)]
pub(crate) fn pair_sum<L: Lane>(a: (L, L), b: (L, L)) -> (L, L) {
    let (sum, error) = two_sum(a.0, b.0);
    let (low, low_error) = two_sum(a.1, b.1);
    let (sum, error) = quick_two_sum(sum, error + low);
    quick_two_sum(sum, error + low_error)
}

/// A pair and a number: their sum.
#[inline(always)]
pub(crate) fn pair_plus<L: Lane>(a: (L, L), b: L) -> (L, L) {
    let (sum, error) = two_sum(a.0, b);
    quick_two_sum(sum, error + a.1)
}

/// A pair times a number.
#[inline(always)]
fn pair_times<L: Exact>(a: (L, L), b: L) -> (L, L) {
    let (product, error) = exact_product(a.0, b);
    quick_two_sum(product, error + a.1 * b)
}

impl<L: Copy> DoubleDouble<L> {
    /// The leading part: the nearest double.
    #[inline]
    pub const fn hi(self) -> L {
        self.hi
    }

    /// The trailing part.
    #[inline]
    pub const fn lo(self) -> L {
        self.lo
    }
}

impl<L: Exact> DoubleDouble<L> {
    /// The square.
    #[inline]
    pub fn square(self) -> Self {
        let (hi, lo) = exact_product(self.hi, self.hi);
        let (hi, lo) = quick_two_sum(hi, lo + self.hi * 2.0 * self.lo);
        Self { hi, lo }
    }

    /// The product with a power of two, exactly.
    #[inline]
    pub fn scaled(self, power_of_two: f64) -> Self {
        Self { hi: self.hi * power_of_two, lo: self.lo * power_of_two }
    }

    /// The same pair in every lane.
    #[inline]
    pub(crate) fn same(value: DoubleDouble) -> Self {
        Self { hi: L::of(value.hi), lo: L::of(value.lo) }
    }

    /// The sum with a pair that is no larger: less than half the work of `+`, and within a few
    /// units of 2^-106 of it while no more than half of this one is taken away (Dekker).
    #[inline]
    pub(crate) fn corrected(self, by: Self) -> Self {
        let (sum, error) = quick_two_sum(self.hi, by.hi);
        let (hi, lo) = quick_two_sum(sum, error + (self.lo + by.lo));
        Self { hi, lo }
    }

    /// The sum with a number, or with one in each lane.
    #[inline]
    pub(crate) fn plus(self, other: L) -> Self {
        let (hi, lo) = pair_plus((self.hi, self.lo), other);
        Self { hi, lo }
    }

    /// The product with a number, or with one in each lane.
    #[inline]
    pub(crate) fn times(self, other: L) -> Self {
        let (hi, lo) = pair_times((self.hi, self.lo), other);
        Self { hi, lo }
    }
}

impl DoubleDouble<Two> {
    /// Two side by side.
    #[inline]
    pub(crate) fn both([first, second]: [DoubleDouble; 2]) -> Self {
        Self { hi: Two::new(first.hi, second.hi), lo: Two::new(first.lo, second.lo) }
    }

    /// Either of them.
    #[inline]
    pub(crate) fn parts(self) -> [DoubleDouble; 2] {
        let ((first, second), (first_low, second_low)) = (self.hi.parts(), self.lo.parts());
        [DoubleDouble::from_parts(first, first_low), DoubleDouble::from_parts(second, second_low)]
    }
}

impl From<f64> for DoubleDouble {
    #[inline]
    fn from(value: f64) -> Self {
        Self { hi: value, lo: 0.0 }
    }
}

impl DoubleDouble {
    /// 0.
    pub const ZERO: Self = Self::from_parts(0.0, 0.0);
    /// 1.
    pub const ONE: Self = Self::from_parts(1.0, 0.0);
    /// pi to 106 bits.
    pub const PI: Self = Self::from_parts(core::f64::consts::PI, 1.224_646_799_147_353_2e-16);
    /// 2 pi.
    pub const TWO_PI: Self = Self::from_parts(core::f64::consts::TAU, 2.449_293_598_294_706_4e-16);
    /// pi/2.
    pub const FRAC_PI_2: Self =
        Self::from_parts(core::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17);
    pub(crate) const LN_2: Self =
        Self::from_parts(core::f64::consts::LN_2, 2.319_046_813_846_299_6e-17);

    /// A constant from its two parts; `|lo| <= ulp(hi)/2` is the caller's promise.
    #[inline]
    pub const fn from_parts(hi: f64, lo: f64) -> Self {
        Self { hi, lo }
    }

    /// The sum of two doubles, exactly.
    #[inline]
    pub fn sum(a: f64, b: f64) -> Self {
        let (hi, lo) = two_sum(a, b);
        Self { hi, lo }
    }

    /// The product of two doubles, exactly.
    #[inline]
    pub fn product(a: f64, b: f64) -> Self {
        let (hi, lo) = exact_product(a, b);
        Self { hi, lo }
    }

    /// The nearest double.
    #[inline]
    pub const fn to_f64(self) -> f64 {
        self.hi
    }

    /// True if the value is finite.
    #[inline]
    pub fn is_finite(self) -> bool {
        self.hi.is_finite() && self.lo.is_finite()
    }

    /// Absolute value.
    #[inline]
    pub fn abs(self) -> Self {
        if self.hi < 0.0 || (self.hi == 0.0 && self.lo < 0.0) { -self } else { self }
    }

    /// The larger of two values.
    #[inline]
    pub fn max(self, other: Self) -> Self {
        if self < other { other } else { self }
    }

    /// The smaller of two values.
    #[inline]
    pub fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    /// One over the value.
    #[inline]
    pub fn recip(self) -> Self {
        Self::ONE / self
    }

    /// The square root; NaN below zero, as for `f64`.
    pub fn sqrt(self) -> Self {
        if self.hi <= 0.0 || !self.hi.is_finite() {
            return Self::from(self.hi.sqrt());
        }
        // One Newton step; what the root's square leaves of `self` is a double but for
        // its own rounding, since the leading parts agree.
        let root = self.hi.sqrt();
        let (square, error) = exact_product(root, root);
        let rest = ((self.hi - square) - error) + self.lo;
        let (hi, lo) = quick_two_sum(root, rest / (2.0 * root));
        Self { hi, lo }
    }

    /// The nearest whole number (as a double; ties away from zero).
    pub fn round(self) -> f64 {
        let n = self.hi.round();
        // `hi` may sit exactly on a tie, or be whole already with `lo` deciding.
        let rest = self - n;
        if rest > 0.5 {
            n + 1.0
        } else if rest < -0.5 {
            n - 1.0
        } else {
            n
        }
    }

    /// `exp(x) - 1`, without cancellation for small `x`.
    pub fn exp_m1(self) -> Self {
        if self.hi.abs() > 0.35 {
            return self.exp() - 1.0;
        }
        // Taylor series at x/16, two terms at a time, then four doublings e -> 2e + e^2, which
        // keep the relative error of the small quantity.
        let x = self.scaled(1.0 / 16.0);
        let two = |n: usize, next: Self| INVERSE_FACTORIAL[n].corrected(x * next);
        let last = INVERSE_FACTORIAL[7] + x.hi * tail(x.hi, &EXP_TAIL);
        let [first, second] = [2, 4].map(|n| two(n, INVERSE_FACTORIAL[n + 1]));
        let square = x.square();
        let sum = first.corrected(square * second.corrected(square * two(6, last)));
        let mut e = x.corrected(square * sum);
        for _ in 0..4 {
            e = e.scaled(2.0).corrected(e.square());
        }
        e
    }

    /// The exponential function; overflows and underflows as for `f64`.
    pub fn exp(self) -> Self {
        if self.hi > 709.0 || self.hi < -745.0 || self.hi.is_nan() {
            return Self::from(super::exp(self.hi));
        }
        let n = (self.hi / core::f64::consts::LN_2).round();
        let rest = self - Self::product(n, LN_2_PARTS[0]);
        let rest = rest - Self::product(n, LN_2_PARTS[1]) - n * LN_2_PARTS[2];
        let e = rest.exp_m1() + 1.0;
        // Two factors: 2^n alone may be out of range while the result is not.
        let half = (n * 0.5).trunc();
        e.scaled(super::ldexp(1.0, half as i32)).scaled(super::ldexp(1.0, (n - half) as i32))
    }

    /// The natural logarithm; relative accuracy everywhere but next to 1, where
    /// [`Self::ln_1p`] has it.
    pub fn ln(self) -> Self {
        if self.hi <= 0.0 || !self.hi.is_finite() {
            return Self::from(super::log(self.hi));
        }
        // The power of two leaves exactly, the rest takes one Newton step on exp,
        // which squares the error of the f64 logarithm.
        let exponent = super::ilogb(self.hi);
        let mantissa = self
            .scaled(super::ldexp(1.0, -(exponent / 2)))
            .scaled(super::ldexp(1.0, exponent / 2 - exponent));
        let guess = super::log(mantissa.hi);
        let refined = Self::from(guess) + (mantissa * Self::from(-guess).exp() - 1.0);
        refined + Self::LN_2 * f64::from(exponent)
    }

    /// `ln(1 + x)`, without cancellation for small `x`.
    pub fn ln_1p(self) -> Self {
        if self.hi.abs() > 0.25 {
            return (self + 1.0).ln();
        }
        // Newton on exp_m1: y - (e^y - 1 - x)/e^y keeps relative accuracy near 0.
        let guess = Self::from(super::log1p(self.hi));
        let grown = guess.exp_m1();
        guess - (grown - self) / (grown + 1.0)
    }

    /// Sine and cosine. Arguments are reduced with pi/2 to 159 bits, so the
    /// absolute error stays at 1e-32 up to |x| = 1e15.
    pub fn sin_cos(self) -> (Self, Self) {
        if !self.is_finite() {
            return (Self::from(f64::NAN), Self::from(f64::NAN));
        }
        let quarters = (self * Self::TWO_OVER_PI).round();
        // k * pi/2 in three parts; the first product is exact as a pair.
        let rest = self - Self::product(quarters, PI_2_PARTS[0]);
        let rest = rest - Self::product(quarters, PI_2_PARTS[1]) - quarters * PI_2_PARTS[2];
        let (sin, cos) = rest.sin_cos_reduced();
        match quarters.rem_euclid(4.0) as u8 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }

    /// Sine.
    pub fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// Cosine.
    pub fn cos(self) -> Self {
        self.sin_cos().1
    }

    const TWO_OVER_PI: Self =
        Self::from_parts(core::f64::consts::FRAC_2_PI, -3.935735335036497e-17);

    /// An angle in radians, in turns.
    #[inline]
    pub(crate) fn turns(self) -> Self {
        (self * Self::TWO_OVER_PI).scaled(0.25)
    }

    /// Taylor series for |x| <= pi/4, side by side, and of each the terms by twos: one after the
    /// other would wait. Those that weigh less than 2^-53 of the sum are formed in plain f64.
    fn sin_cos_reduced(self) -> (Self, Self) {
        let minus_square = -self.square();
        let x = DoubleDouble::<Two>::same(minus_square);
        let small = SIN_COS_TAIL
            .iter()
            .rev()
            .fold(Two::of(0.0), |sum, &[s, c]| sum * x.hi + Two::new(s, c));
        let [first, second, third] = [3, 7, 11].map(|n| inverses(n).corrected(x * inverses(n + 2)));
        let last = inverses(15).corrected(x.times(small));
        let square = x.square();
        let leading = first.corrected(square * second);
        let trailing = third.corrected(square * last);
        let [sin, cos] = leading.corrected(square.square() * trailing).parts();
        let sin = self.corrected(self * (minus_square * sin));
        let half = minus_square.scaled(0.5);
        let cos = Self::ONE.corrected(half.corrected(minus_square.square() * cos));
        (sin, cos)
    }

    /// The angle of the point (`x`, `self`), in (-pi, pi]; signs of zeros as in `f64::atan2`.
    pub fn atan2(self, x: Self) -> Self {
        let guess = super::atan2(self.hi, x.hi);
        if (self.hi == 0.0 && x.hi >= 0.0) || !self.is_finite() || !x.is_finite() {
            return Self::from(guess);
        }
        // Turn the point back by the guess; what is left is a tiny angle. Scaling
        // by a power of two keeps the products in range.
        let scale = super::ldexp(1.0, -super::ilogb(self.hi.abs().max(x.hi.abs())));
        let (y, x) = (self.scaled(scale), x.scaled(scale));
        let (sin, cos) = Self::from(guess).sin_cos();
        let across = y * cos - x * sin;
        let along = x * cos + y * sin;
        Self::from(guess) + across / along
    }

    /// The arc tangent.
    pub fn atan(self) -> Self {
        self.atan2(Self::ONE)
    }

    /// Hyperbolic sine and cosine, the sine with relative accuracy near 0.
    pub fn sinh_cosh(self) -> (Self, Self) {
        let grown = self.exp_m1();
        let exp = grown + 1.0;
        // sinh = (e - 1)(e + 1)/(2e): no cancellation in e - 1/e.
        let sinh = grown * (exp + 1.0) / exp.scaled(2.0);
        let cosh = (exp + exp.recip()).scaled(0.5);
        (sinh, cosh)
    }
}

/// Horner's rule in plain f64, lowest coefficient first.
#[inline]
fn tail(x: f64, coefficients: &[f64]) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// ln 2 in three parts.
const LN_2_PARTS: [f64; 3] =
    [core::f64::consts::LN_2, 2.319_046_813_846_299_6e-17, 5.707_708_438_416_212e-34];

/// pi/2 in three parts.
const PI_2_PARTS: [f64; 3] =
    [core::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17, -1.497_384_904_859_169_8e-33];

/// 1/n! to 106 bits, n = 0..=16.
const INVERSE_FACTORIAL: [DoubleDouble; 17] = [
    DoubleDouble::from_parts(1.0, 0.0),
    DoubleDouble::from_parts(1.0, 0.0),
    DoubleDouble::from_parts(0.5, 0.0),
    DoubleDouble::from_parts(0.16666666666666666, 9.25185853854297e-18),
    DoubleDouble::from_parts(0.041666666666666664, 2.3129646346357427e-18),
    DoubleDouble::from_parts(0.008333333333333333, 1.1564823173178714e-19),
    DoubleDouble::from_parts(0.001388888888888889, -5.300543954373577e-20),
    DoubleDouble::from_parts(0.0001984126984126984, 1.7209558293420705e-22),
    DoubleDouble::from_parts(2.48015873015873e-05, 2.1511947866775882e-23),
    DoubleDouble::from_parts(2.7557319223985893e-06, -1.858393274046472e-22),
    DoubleDouble::from_parts(2.755731922398589e-07, 2.3767714622250297e-23),
    DoubleDouble::from_parts(2.505210838544172e-08, -1.448814070935912e-24),
    DoubleDouble::from_parts(2.08767569878681e-09, -1.20734505911326e-25),
    DoubleDouble::from_parts(1.6059043836821613e-10, 1.2585294588752098e-26),
    DoubleDouble::from_parts(1.1470745597729725e-11, 2.0655512752830745e-28),
    DoubleDouble::from_parts(7.647163731819816e-13, 7.03872877733453e-30),
    DoubleDouble::from_parts(4.779477332387385e-14, 4.399205485834081e-31),
];

/// 1/n! for n = 8, 9, ...: the terms of exp_m1 below 2^-53 of the sum.
const EXP_TAIL: [f64; 6] = [
    1.0 / 40320.0,
    1.0 / 362_880.0,
    1.0 / 3_628_800.0,
    1.0 / 39_916_800.0,
    1.0 / 479_001_600.0,
    1.0 / 6_227_020_800.0,
];
/// 1/n! for n = 17, 19, ... and for n = 18, 20, ...
const SIN_COS_TAIL: [[f64; 2]; 7] = [
    [2.8114572543455206e-15, 1.5619206968586225e-16],
    [8.22063524662433e-18, 4.110317623312165e-19],
    [1.9572941063391263e-20, 8.896791392450574e-22],
    [3.868170170630684e-23, 1.6117375710961184e-24],
    [6.446950284384474e-26, 2.4795962632247976e-27],
    [9.183689863795546e-29, 3.279889237069838e-30],
    [1.1309962886447716e-31, 3.7699876288159054e-33],
];

/// 1/n! and 1/(n + 1)!.
#[inline]
fn inverses(n: usize) -> DoubleDouble<Two> {
    DoubleDouble::both([INVERSE_FACTORIAL[n], INVERSE_FACTORIAL[n + 1]])
}

impl<L: Exact> Add for DoubleDouble<L> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let (hi, lo) = pair_sum((self.hi, self.lo), (other.hi, other.lo));
        Self { hi, lo }
    }
}

impl<L: Exact> Add<f64> for DoubleDouble<L> {
    type Output = Self;
    #[inline]
    fn add(self, other: f64) -> Self {
        self.plus(L::of(other))
    }
}

impl<L: Exact> Mul for DoubleDouble<L> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        let (product, error) = exact_product(self.hi, other.hi);
        let (hi, lo) = quick_two_sum(product, error + (self.hi * other.lo + self.lo * other.hi));
        Self { hi, lo }
    }
}

impl<L: Exact> Mul<f64> for DoubleDouble<L> {
    type Output = Self;
    #[inline]
    fn mul(self, other: f64) -> Self {
        self.times(L::of(other))
    }
}

impl<L: Exact> Div for DoubleDouble<L> {
    type Output = Self;
    /// One Newton step: the remainder of `self` after the leading quotient is a double but for its
    /// own rounding, since the leading parts agree.
    #[inline]
    fn div(self, other: Self) -> Self {
        let quotient = self.hi / other.hi;
        let (product, error) = exact_product(quotient, other.hi);
        let rest = ((self.hi - product) - error) + (self.lo - quotient * other.lo);
        let (hi, lo) = quick_two_sum(quotient, rest / other.hi);
        Self { hi, lo }
    }
}

impl Div<f64> for DoubleDouble {
    type Output = Self;
    #[inline]
    fn div(self, other: f64) -> Self {
        self / Self::from(other)
    }
}

impl<L: Exact> Neg for DoubleDouble<L> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl<L: Exact> Sub for DoubleDouble<L> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<L: Exact> Sub<f64> for DoubleDouble<L> {
    type Output = Self;
    #[inline]
    fn sub(self, other: f64) -> Self {
        self + -other
    }
}

impl<L: Exact> Add<DoubleDouble<L>> for f64 {
    type Output = DoubleDouble<L>;
    #[inline]
    fn add(self, other: DoubleDouble<L>) -> DoubleDouble<L> {
        other + self
    }
}

impl<L: Exact> Sub<DoubleDouble<L>> for f64 {
    type Output = DoubleDouble<L>;
    #[inline]
    fn sub(self, other: DoubleDouble<L>) -> DoubleDouble<L> {
        -other + self
    }
}

impl<L: Exact> Mul<DoubleDouble<L>> for f64 {
    type Output = DoubleDouble<L>;
    #[inline]
    fn mul(self, other: DoubleDouble<L>) -> DoubleDouble<L> {
        other * self
    }
}

impl Div<DoubleDouble> for f64 {
    type Output = DoubleDouble;
    #[inline]
    fn div(self, other: DoubleDouble) -> DoubleDouble {
        DoubleDouble::from(self) / other
    }
}

impl AddAssign for DoubleDouble {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for DoubleDouble {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl PartialOrd for DoubleDouble {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        match self.hi.partial_cmp(&other.hi) {
            Some(Ordering::Equal) => self.lo.partial_cmp(&other.lo),
            order => order,
        }
    }
}

impl PartialEq<f64> for DoubleDouble {
    #[inline]
    fn eq(&self, other: &f64) -> bool {
        self.hi == *other && self.lo == 0.0
    }
}

impl PartialOrd<f64> for DoubleDouble {
    #[inline]
    fn partial_cmp(&self, other: &f64) -> Option<Ordering> {
        self.partial_cmp(&Self::from(*other))
    }
}

#[cfg(test)]
mod tests {
    use super::DoubleDouble as Dd;
    use support::{Errors, assert_largest};

    /// How far corrected pairs are from the sums, in units of 2^-106 of these, over corrections
    /// of either sign up to `most` times the pair.
    fn of_corrections(most: f64) -> Errors {
        let mut errors = Errors::in_units_of(1.232_595_164_407_831e-32, "corrected pairs");
        for n in 1..=20_000 {
            let one = Dd::from(f64::from(n)).sqrt();
            let part = (Dd::from(f64::from(n % 100 + 1)) / 100.0).sqrt();
            let by = one * part * if n % 2 == 0 { most } else { -most };
            let sum = one + by;
            errors.push(((one.corrected(by) - sum) / sum).hi());
        }
        errors
    }

    #[test]
    fn a_correction_is_as_good_as_a_sum() {
        assert_largest!(of_corrections(0.5), 20_000, @"1.96");
        // Larger than what it corrects.
        assert!(of_corrections(3e3).largest() > 1e3);
    }
}
