//! One text for one number and for several at once.
//!
//! A sample of a closed form without a branch is written over [`Lane`]. With `f64`
//! it is the scalar code; with a vector register each lane does the same operations
//! in the same order, none contracted, so the bits are the same. Which registers there
//! are is asked at run time on x86-64; 64-bit ARM always has NEON, WebAssembly what it is
//! compiled for.
//!
//! NEON against the plain arrays, which the compiler turns into its instructions as well, in
//! instructions (counted under an emulator, optimised, the same bits): of a sample of a closed
//! form in a batch 0.71 for the free body and 0.78 for the heavy top, one by one 0.89 and 1.00;
//! of an evaluation in Gauss-Legendre 0.69 without the spin, 0.82 for the free body by
//! quadrature, 0.83 with the gradient of gravity, 0.99 on the body's axes, but 1.07 for a scene
//! with gravity and 1.10 for a free one, where more of what is kept goes through memory.
//!
//! What a sample does twice alike, as for alpha and beta, it does on a [`Phased::Pair`]:
//! two registers, or for one number both halves of one.
//!
//! Not for: elementary functions of `libm`, or anything with a branch.

#[cfg(all(target_arch = "x86_64", registers))]
use asked::widest;
use core::ops::{Add, Div, Mul, Neg, Sub};

#[cfg(target_arch = "aarch64")]
mod aarch64;
#[cfg(all(target_arch = "x86_64", registers))]
mod asked;
#[cfg(test)]
mod tests;
#[cfg(target_feature = "simd128")]
mod wasm32;
#[cfg(target_arch = "x86_64")]
mod x86;

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
    /// The first `WIDTH` numbers of a list; panics if it has fewer.
    fn load(values: &[f64]) -> Self;
    /// Writes the first `WIDTH` numbers of a list; panics if it has fewer.
    fn store(self, values: &mut [f64]);
    /// The square root, correctly rounded.
    fn sqrt(self) -> Self;
    /// The absolute value.
    fn abs(self) -> Self;
    /// The sum of the lanes: the halves are added, then the halves of that, to the last two.
    fn sum(self) -> f64;
}

/// A lane that can be asked for a phase, and that goes in pairs.
pub trait Phased: Lane + Number {
    /// Two of these.
    type Pair: Pair<Self>;
}

/// What has the arithmetic of a number, in every lane, and its bits.
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
{
    /// The same number in every lane.
    fn same(value: f64) -> Self;
    /// The nearest number of 26 bits; what is left has 26 as well. |this| < 2^1023.
    fn leading(self) -> Self;
    /// The negative where the last bit of `whole` is set.
    fn negative_if_odd(self, whole: Self) -> Self;
    /// The negative where the last bit but one of `whole` is set.
    fn negative_if_half(self, whole: Self) -> Self;
    /// `odd` where the last bit of `whole` is set, this elsewhere.
    fn or_if_odd(self, odd: Self, whole: Self) -> Self;
}

/// Two lanes that go through the same arithmetic.
pub trait Pair<L>: Number {
    fn new(first: L, second: L) -> Self;
    /// Two numbers, the same in every lane.
    fn both(values: &[f64; 2]) -> Self;
    fn parts(self) -> (L, L);
    /// The two exchanged.
    fn swapped(self) -> Self;
}

/// Two cubics by their coefficients, side by side.
pub(crate) type Cubics = [[f64; 2]; 4];

/// The coefficients of two cubics, the lowest first, put side by side.
pub(crate) fn cubics(first: &[f64; 4], second: &[f64; 4]) -> Cubics {
    core::array::from_fn(|n| [first[n], second[n]])
}

/// Horner's rule for two cubics at once.
#[inline(always)]
pub(crate) fn horner<L: Phased>(p: &Cubics, x: L) -> L::Pair {
    let [p0, p1, p2, p3] = p;
    let x = L::Pair::new(x, x);
    let sum = L::Pair::both(p2) + x * L::Pair::both(p3);
    L::Pair::both(p0) + x * (L::Pair::both(p1) + x * sum)
}

/// The most numbers a [`Lane`] holds.
pub const WIDEST: usize = 8;

const SIGN: u64 = 1 << 63;
/// All but the last 27 bits, and half of the last that is kept.
const LEADING: u64 = !0 << 27;
const HALF: u64 = 1 << 26;

impl Number for f64 {
    #[inline(always)]
    fn same(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn leading(self) -> Self {
        f64::from_bits((self.to_bits() + HALF) & LEADING)
    }
    #[inline(always)]
    fn negative_if_odd(self, whole: Self) -> Self {
        f64::from_bits(self.to_bits() ^ (whole.to_bits() << 63))
    }
    #[inline(always)]
    fn negative_if_half(self, whole: Self) -> Self {
        f64::from_bits(self.to_bits() ^ ((whole.to_bits() << 62) & SIGN))
    }
    #[inline(always)]
    fn or_if_odd(self, odd: Self, whole: Self) -> Self {
        let mask = (whole.to_bits() & 1).wrapping_neg();
        f64::from_bits((self.to_bits() & !mask) | (odd.to_bits() & mask))
    }
}

impl Lane for f64 {
    const WIDTH: usize = 1;
    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn load(values: &[f64]) -> Self {
        values[0]
    }
    #[inline(always)]
    fn store(self, values: &mut [f64]) {
        values[0] = self;
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline(always)]
    fn sum(self) -> f64 {
        self
    }
}

impl Phased for f64 {
    type Pair = Two;
}

/// Two of a kind, one after the other.
#[derive(Debug, Clone, Copy)]
pub struct Both<L>(L, L);

/// Eight numbers in registers of AVX-512, and in those of AVX2: only where they are.
#[cfg(target_arch = "x86_64")]
pub(crate) use x86::{Eight, Four, FourTwice};
/// Two numbers in what every processor of its kind has.
#[cfg(target_arch = "x86_64")]
pub(crate) type Two = x86::Two;
#[cfg(target_arch = "aarch64")]
pub(crate) type Two = aarch64::Two;
#[cfg(target_feature = "simd128")]
pub(crate) type Two = wasm32::Two;
#[cfg(not(any(
    target_arch = "x86_64",
    target_arch = "aarch64",
    target_feature = "simd128"
)))]
pub(crate) type Two = Both<f64>;

/// Eight numbers in what every processor of its kind has.
pub(crate) type CommonEight = Both<Both<Two>>;

impl<L: Copy> Both<L> {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(L, L) -> L) -> Self {
        Self(f(self.0, other.0), f(self.1, other.1))
    }
}

macro_rules! both {
    ($($trait:ident $method:ident),*) => {$(
        impl<L: Lane> $trait for Both<L> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, L::$method)
            }
        }
    )*};
    (f64: $($trait:ident $method:ident),*) => {$(
        impl<L: Lane> $trait<f64> for Both<L> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: f64) -> Self {
                Self(self.0.$method(other), self.1.$method(other))
            }
        }
    )*};
}

both!(Add add, Sub sub, Mul mul, Div div);
both!(f64: Add add, Sub sub, Mul mul);

impl<L: Lane> Neg for Both<L> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl<L: Lane> Lane for Both<L> {
    const WIDTH: usize = 2 * L::WIDTH;
    #[inline(always)]
    fn of(value: f64) -> Self {
        Self(L::of(value), L::of(value))
    }
    #[inline(always)]
    fn load(values: &[f64]) -> Self {
        Self(L::load(values), L::load(&values[L::WIDTH..]))
    }
    #[inline(always)]
    fn store(self, values: &mut [f64]) {
        self.0.store(values);
        self.1.store(&mut values[L::WIDTH..]);
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt(), self.1.sqrt())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs(), self.1.abs())
    }
    #[inline(always)]
    fn sum(self) -> f64 {
        (self.0 + self.1).sum()
    }
}

impl<L: Phased> Phased for Both<L> {
    type Pair = Both<Self>;
}

impl<L: Phased> Number for Both<L> {
    #[inline(always)]
    fn same(value: f64) -> Self {
        Self(L::of(value), L::of(value))
    }
    #[inline(always)]
    fn leading(self) -> Self {
        Self(self.0.leading(), self.1.leading())
    }
    #[inline(always)]
    fn negative_if_odd(self, whole: Self) -> Self {
        self.zip(whole, L::negative_if_odd)
    }
    #[inline(always)]
    fn negative_if_half(self, whole: Self) -> Self {
        self.zip(whole, L::negative_if_half)
    }
    #[inline(always)]
    fn or_if_odd(self, odd: Self, whole: Self) -> Self {
        Self(
            self.0.or_if_odd(odd.0, whole.0),
            self.1.or_if_odd(odd.1, whole.1),
        )
    }
}

impl<L: Phased> Pair<L> for Both<L> {
    #[inline(always)]
    fn new(first: L, second: L) -> Self {
        Self(first, second)
    }
    #[inline(always)]
    fn both(values: &[f64; 2]) -> Self {
        Self(L::of(values[0]), L::of(values[1]))
    }
    #[inline(always)]
    fn parts(self) -> (L, L) {
        (self.0, self.1)
    }
    #[inline(always)]
    fn swapped(self) -> Self {
        Self(self.1, self.0)
    }
}

/// A sample that takes a time to `N` numbers without a branch.
pub(crate) trait Sampler<const N: usize> {
    fn sample<L: Phased>(&self, t: L) -> [L; N];
}

/// How many doubles a register may hold at most.
#[cfg(all(target_arch = "x86_64", not(registers)))]
const fn widest() -> usize {
    8
}

/// True if the processor has registers of eight doubles and this run may use them.
#[cfg(target_arch = "x86_64")]
pub(crate) fn has_avx512() -> bool {
    widest() >= 8 && std::is_x86_feature_detected!("avx512f")
}

/// True if the processor has registers of four doubles and this run may use them.
#[cfg(target_arch = "x86_64")]
pub(crate) fn has_avx2() -> bool {
    widest() >= 4 && std::is_x86_feature_detected!("avx2")
}

/// Hands the sample at each time to `put`, with the widest registers the processor has.
pub(crate) fn for_each_sample<const N: usize>(
    sampler: &impl Sampler<N>,
    times: &[f64],
    put: impl FnMut([f64; N]),
) {
    #[cfg(target_arch = "x86_64")]
    {
        if has_avx512() {
            // SAFETY: the processor has the feature, as just detected.
            return unsafe { x86::avx512(sampler, times, put) };
        }
        if has_avx2() {
            // SAFETY: the processor has the feature, as just detected.
            return unsafe { x86::avx2(sampler, times, put) };
        }
    }
    // Elsewhere two at once have not been measured to be worth it.
    if cfg!(target_arch = "aarch64") {
        run::<Two, N>(sampler, times, put);
    } else {
        run::<f64, N>(sampler, times, put);
    }
}

#[inline(always)]
fn run<L: Phased, const N: usize>(
    sampler: &impl Sampler<N>,
    times: &[f64],
    mut put: impl FnMut([f64; N]),
) {
    let mut left = times;
    while let Some(first) = left.first() {
        let count = left.len().min(L::WIDTH);
        let t = if count == L::WIDTH {
            L::load(left)
        } else {
            // Filled up; what the idle lanes give is dropped.
            let mut t = [*first; WIDEST];
            t[..count].copy_from_slice(left);
            L::load(&t)
        };
        let sample = sampler.sample(t);
        if count == L::WIDTH {
            hand_over(&sample, L::WIDTH, &mut put);
        } else {
            hand_over(&sample, count, &mut put);
        }
        left = &left[count..];
    }
}

/// The first `count` lanes, one after the other.
#[inline(always)]
fn hand_over<L: Lane, const N: usize>(
    sample: &[L; N],
    count: usize,
    put: &mut impl FnMut([f64; N]),
) {
    let mut rows = [[0.0; WIDEST]; N];
    for (row, value) in rows.iter_mut().zip(sample) {
        value.store(row);
    }
    for lane in 0..count {
        let mut values = [0.0; N];
        for (value, row) in values.iter_mut().zip(&rows) {
            *value = row[lane];
        }
        put(values);
    }
}

/// Writes a row of numbers by registers of `L`, one of two and one number, as compiled loops over
/// a row read it: a load that takes from two stores waits for both. True if all are finite.
#[inline(always)]
pub(crate) fn write_finite<L: Lane, const N: usize>(values: &[f64; N], row: &mut [f64; N]) -> bool {
    let (mut wide, mut two, mut one) = (L::of(0.0), Two::of(0.0), 0.0);
    let mut i = 0;
    while i + L::WIDTH <= N {
        let x = L::load(&values[i..]);
        x.store(&mut row[i..]);
        wide = wide + x * 0.0;
        i += L::WIDTH;
    }
    if i + 2 <= N {
        let x = Two::load(&values[i..]);
        x.store(&mut row[i..]);
        two = x * 0.0;
        i += 2;
    }
    if i < N {
        row[i] = values[i];
        one = values[i] * 0.0;
    }
    // 0 of all that is finite, no number of anything else.
    wide.sum() + two.sum() + one == 0.0
}
