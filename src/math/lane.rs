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
//! Work that a sample does twice alike, as for alpha and beta, it does on a [`Phased::Pair`]: two
//! registers, or for one number both halves of one.
//!
//! Not for: elementary functions of `libm`, or anything with a branch (what samples need of them
//! is in `turns` and `hyperbolic`).

use core::ops::{Add, Div, Mul, Neg, Sub};
#[cfg(all(target_arch = "x86_64", registers))]
use registers::widest;

#[cfg(target_arch = "aarch64")]
mod aarch64;
#[cfg(all(target_arch = "x86_64", registers))]
mod registers;
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
    /// The nearest number within `bound` of zero.
    fn within(self, bound: f64) -> Self;
    /// The sum of the lanes: the halves are added, then the halves of that, to the last two.
    fn sum(self) -> f64;
}

/// A lane that can be asked for a phase, and that goes in pairs.
pub trait Phased: Lane + Number {
    /// Two of these.
    type Pair: Pair<Self>;
}

/// A type with the arithmetic of a number, in every lane, and its bits.
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
    /// The nearest number of 26 bits; the remainder has 26 as well. |this| < 2^1023.
    fn leading(self) -> Self;
    /// The negative where the last bit of `whole` is set.
    fn negative_if_odd(self, whole: Self) -> Self;
    /// The negative where the last bit but one of `whole` is set.
    fn negative_if_half(self, whole: Self) -> Self;
    /// `odd` where the last bit of `whole` is set, this elsewhere.
    fn or_if_odd(self, odd: Self, whole: Self) -> Self;
    /// 2^n for the whole number n in the last bits of `whole`, |n| <= 1022.
    fn two_to(whole: Self) -> Self;
}

/// Two lanes that go through the same arithmetic.
pub trait Pair<L>: Number {
    /// The two, in this order.
    fn new(first: L, second: L) -> Self;
    /// Two numbers, the same in every lane.
    fn both(values: &[f64; 2]) -> Self;
    /// The first and the second.
    fn parts(self) -> (L, L);
    /// The two exchanged.
    fn swapped(self) -> Self;
}

/// The content of a lane: one number for all of it, or one for each of [`WIDEST`] motions.
pub(crate) trait Constant: Copy {
    /// For a lane that starts with the motion number `first`.
    fn lane<L: Lane>(&self, first: usize) -> L;
    /// Two side by side.
    fn pair<L: Phased>(two: &[Self; 2], first: usize) -> L::Pair;
}

impl Constant for f64 {
    #[inline(always)]
    fn lane<L: Lane>(&self, _: usize) -> L {
        L::of(*self)
    }
    #[inline(always)]
    fn pair<L: Phased>(two: &[Self; 2], _: usize) -> L::Pair {
        L::Pair::both(two)
    }
}

/// A number of each of several motions.
pub(crate) type Row = [f64; WIDEST];

impl Constant for Row {
    #[inline(always)]
    fn lane<L: Lane>(&self, first: usize) -> L {
        L::load(&self[first..])
    }
    #[inline(always)]
    fn pair<L: Phased>([one, other]: &[Self; 2], first: usize) -> L::Pair {
        L::Pair::new(one.lane(first), other.lane(first))
    }
}

/// The data of several motions, number by number.
pub(crate) trait Gathered: Copy {
    type Rows;
    fn gathered(each: [Self; WIDEST]) -> Self::Rows;
}

impl Gathered for f64 {
    type Rows = Row;
    fn gathered(each: [Self; WIDEST]) -> Row {
        each
    }
}

impl<T: Gathered, const N: usize> Gathered for [T; N] {
    type Rows = [T::Rows; N];
    fn gathered(each: [Self; WIDEST]) -> Self::Rows {
        core::array::from_fn(|n| T::gathered(each.map(|one| one[n])))
    }
}

/// Two cubics by their coefficients, side by side.
pub(crate) type Cubics<V = f64> = [[V; 2]; 4];

/// The coefficients of two cubics, the lowest first, put side by side.
pub(crate) fn cubics(first: &[f64; 4], second: &[f64; 4]) -> Cubics {
    core::array::from_fn(|n| [first[n], second[n]])
}

/// Horner's rule for two cubics at once, for lanes that start with the motion number `first`.
#[inline(always)]
pub(crate) fn horner<L: Phased, V: Constant>(p: &Cubics<V>, x: L, first: usize) -> L::Pair {
    let [p0, p1, p2, p3] = p;
    let sum = [
        V::pair::<L>(p0, first),
        V::pair::<L>(p1, first),
        V::pair::<L>(p2, first),
        V::pair::<L>(p3, first),
    ];
    cubic::<L>(sum, x)
}

/// The same of two pairs of cubics, of the second where the last bit of `whole` is set.
#[inline(always)]
pub(crate) fn either<L: Phased, V: Constant>(
    [[e0, e1, e2, e3], [o0, o1, o2, o3]]: &[Cubics<V>; 2],
    whole: L,
    x: L,
    first: usize,
) -> L::Pair {
    let whole = L::Pair::new(whole, whole);
    let chosen = [
        chosen::<L, V>(e0, o0, whole, first),
        chosen::<L, V>(e1, o1, whole, first),
        chosen::<L, V>(e2, o2, whole, first),
        chosen::<L, V>(e3, o3, whole, first),
    ];
    cubic::<L>(chosen, x)
}

#[inline(always)]
fn chosen<L: Phased, V: Constant>(
    even: &[V; 2],
    odd: &[V; 2],
    whole: L::Pair,
    first: usize,
) -> L::Pair {
    V::pair::<L>(even, first).or_if_odd(V::pair::<L>(odd, first), whole)
}

#[inline(always)]
fn cubic<L: Phased>([p0, p1, p2, p3]: [L::Pair; 4], x: L) -> L::Pair {
    let x = L::Pair::new(x, x);
    p0 + x * (p1 + x * (p2 + x * p3))
}

/// The most numbers a [`Lane`] holds.
pub const WIDEST: usize = 8;

const SIGN: u64 = 1 << 63;
/// All but the last 27 bits, and half of the last that is kept.
const LEADING: u64 = !0 << 27;
const HALF: u64 = 1 << 26;
/// The bits of 1: an exponent of zero.
const ONE: u64 = 1023 << 52;

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
    #[inline(always)]
    fn two_to(whole: Self) -> Self {
        f64::from_bits((whole.to_bits() << 52).wrapping_add(ONE))
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
    fn within(self, bound: f64) -> Self {
        self.clamp(-bound, bound)
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

#[cfg(all(target_arch = "x86_64", not(target_feature = "fma")))]
pub(crate) use x86::fused;
/// Eight numbers in registers of AVX-512, and in registers of AVX2: only where they are.
#[cfg(target_arch = "x86_64")]
pub(crate) use x86::{Eight, FourTwice};
/// Two numbers in what every processor of its kind has.
#[cfg(target_arch = "x86_64")]
pub(crate) type Two = x86::Two;
#[cfg(target_arch = "aarch64")]
pub(crate) type Two = aarch64::Two;
#[cfg(target_feature = "simd128")]
pub(crate) type Two = wasm32::Two;
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64", target_feature = "simd128")))]
pub(crate) type Two = Both<f64>;

/// Eight numbers in what every processor of its kind has.
pub(crate) type CommonEight = Both<Both<Two>>;

impl<L: Copy> Both<L> {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(L, L) -> L) -> Self {
        Self(f(self.0, other.0), f(self.1, other.1))
    }
    #[inline(always)]
    pub(crate) fn zip3(self, b: Self, c: Self, f: impl Fn(L, L, L) -> L) -> Self {
        Self(f(self.0, b.0, c.0), f(self.1, b.1, c.1))
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
    fn within(self, bound: f64) -> Self {
        Self(self.0.within(bound), self.1.within(bound))
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
        Self(self.0.or_if_odd(odd.0, whole.0), self.1.or_if_odd(odd.1, whole.1))
    }
    #[inline(always)]
    fn two_to(whole: Self) -> Self {
        Self(L::two_to(whole.0), L::two_to(whole.1))
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

/// A sample without a branch: `N` numbers of a motion at a time.
pub(crate) trait Sampler<const N: usize> {
    /// In lanes that start with the motion number `first`.
    fn sample<L: Phased>(&self, t: L, first: usize) -> [L; N];
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

/// True if the processor multiplies and adds with one rounding and this run may use it.
#[cfg(all(target_arch = "x86_64", not(target_feature = "fma")))]
pub(crate) fn has_fma() -> bool {
    widest() >= 4 && std::is_x86_feature_detected!("fma")
}

/// Something to be done in registers.
trait Work {
    fn run<L: Phased>(self);
}

/// Does it in the widest registers that the processor has.
fn in_the_widest(work: impl Work) {
    #[cfg(target_arch = "x86_64")]
    {
        if has_avx512() {
            // SAFETY: the processor has the feature, as just detected.
            return unsafe { x86::avx512(work) };
        }
        if has_avx2() {
            // SAFETY: the processor has the feature, as just detected.
            return unsafe { x86::avx2(work) };
        }
    }
    // Elsewhere two at once have not been measured to be worth it.
    if cfg!(target_arch = "aarch64") {
        work.run::<Two>();
    } else {
        work.run::<f64>();
    }
}

/// Hands the sample of one motion at each time to `put`.
pub(crate) fn for_each_time<const N: usize>(
    sampler: &impl Sampler<N>,
    times: &[f64],
    put: impl FnMut([f64; N]),
) {
    in_the_widest(EachTime::<_, _, N> { sampler, times, put });
}

/// Hands the samples of all motions at one time to `put`; each sampler holds [`WIDEST`].
pub(crate) fn for_each_motion<'a, const N: usize, S: Sampler<N> + 'a>(
    blocks: impl Iterator<Item = &'a S>,
    t: f64,
    put: impl FnMut([f64; N]),
) {
    in_the_widest(EachMotion::<_, _, N> { blocks, t, put });
}

struct EachTime<'a, S, P, const N: usize> {
    sampler: &'a S,
    times: &'a [f64],
    put: P,
}

impl<S: Sampler<N>, P: FnMut([f64; N]), const N: usize> Work for EachTime<'_, S, P, N> {
    #[inline(always)]
    fn run<L: Phased>(mut self) {
        let mut left = self.times;
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
            let sample = self.sampler.sample(t, 0);
            if count == L::WIDTH {
                hand_over(&sample, L::WIDTH, &mut self.put);
            } else {
                hand_over(&sample, count, &mut self.put);
            }
            left = &left[count..];
        }
    }
}

struct EachMotion<B, P, const N: usize> {
    blocks: B,
    t: f64,
    put: P,
}

impl<'a, S, B, P, const N: usize> Work for EachMotion<B, P, N>
where
    S: Sampler<N> + 'a,
    B: Iterator<Item = &'a S>,
    P: FnMut([f64; N]),
{
    #[inline(always)]
    fn run<L: Phased>(mut self) {
        for block in self.blocks {
            for first in (0..WIDEST).step_by(L::WIDTH) {
                let sample = block.sample(L::of(self.t), first);
                hand_over(&sample, L::WIDTH, &mut self.put);
            }
        }
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

/// Writes a row of numbers two by two, as compiled loops over a row read it: a load that takes from
/// two stores waits for both. True if all are finite.
#[inline(always)]
pub(crate) fn write_finite<const N: usize>(values: &[f64; N], row: &mut [f64; N]) -> bool {
    let (mut pairs, mut one) = (Two::of(0.0), 0.0);
    for i in (0..N - N % 2).step_by(2) {
        let x = Two::load(&values[i..]);
        x.store(&mut row[i..]);
        pairs = pairs + x * 0.0;
    }
    if N % 2 == 1 {
        row[N - 1] = values[N - 1];
        one = values[N - 1] * 0.0;
    }
    // 0 of all that is finite, no number of anything else.
    pairs.sum() + one == 0.0
}
