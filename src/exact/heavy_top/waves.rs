//! The set-up of the theta series: zeros, nome, coefficients, in double-double
//! arithmetic.
//!
//! The Fourier terms of `super::series` are summed as polynomials: sin(2n+1)z/sin z,
//! cos(2n+1)z/cos z and cos 2nz are polynomials in k = 2 cos 2z.

use super::ripples::Ripple;
use super::series::{Factor, Series};
use crate::exact::nome::Nome;
use crate::exact::theta::{self, Across};
use crate::math::lane::{Pair, Two};
use crate::math::{DoubleDouble as Dd, Exact};

/// The zero i eta of one Cayley-Klein parameter, off the real axis, 0 <= eta <= K'.
#[derive(Debug, Clone, Copy)]
pub(super) struct Zero {
    /// The sense in which the phase runs past it: +1 or -1.
    pub(super) sign: f64,
    pub(super) place: theta::Zero,
}

/// The by-products of the set-up besides the series: the phase rates d arg/dz that the two series
/// have where they are matched.
pub(super) struct Matched {
    pub(super) series: Series,
    /// d arg a/dz at the upper turning point, d arg b/dz at the lower one.
    pub(super) slopes: [Dd; 2],
}

impl Series {
    /// `a` and `b` are the zeros; at the upper turning point |a| is the first size, at the lower
    /// one |b| is the second.
    pub(super) fn matched(nome: &Nome, a: &Zero, b: &Zero, sizes: [Dd; 2]) -> Matched {
        let [size_a, size_b] = sizes;
        match [a.place, b.place] {
            [theta::Zero::Along(angle_a), theta::Zero::Along(angle_b)] => {
                let waves = [(a.sign, angle_a), (b.sign, angle_b)]
                    .map(|(sign, angle)| Ripple::new(sign, angle, nome));
                Self::hyperbolic(nome, &waves, size_a, size_b)
            }
            _ => {
                let waves = Wave::<Two>::new(&Across::both([a.across(), b.across()]), nome);
                let signs = [a.sign, b.sign];
                Self::trigonometric(nome, &waves, signs, [size_a, size_b * nome.root_k1])
            }
        }
    }

    fn trigonometric(nome: &Nome, waves: &Wave<Two>, signs: [f64; 2], sizes: [Dd; 2]) -> Matched {
        let [a, b] = waves.times(Dd::both(sizes) / waves.at_zero).parts();
        let [slope_a, slope_b] = waves.slope().parts();
        let [sign_a, sign_b] = signs;
        let series = Self {
            hyperbolic: false,
            nome: nome.q.to_f64(),
            sides: [[a.h(sign_a, 1.0), b.h1(sign_b)], [b.h(sign_b, -1.0), a.h1(sign_a)]],
        };
        Matched { series, slopes: [slope_a.scaled(sign_a), slope_b.scaled(sign_b)] }
    }

    fn hyperbolic(nome: &Nome, waves: &[Ripple; 2], size_a: Dd, size_b: Dd) -> Matched {
        let scale_a = size_a * nome.theta3() / waves[0].at_zero;
        let scale_b = size_b * nome.theta2() / waves[1].at_zero;
        let scale_upper = scale_b * nome.q.sqrt().scaled(4.0);
        let series = Self {
            hyperbolic: true,
            nome: nome.q.to_f64(),
            sides: [
                [waves[0].h(scale_a), waves[1].h1(scale_b)],
                [waves[1].h(-scale_upper), waves[0].h1(scale_a)],
            ],
        };
        Matched { series, slopes: [waves[0].slope, waves[1].slope] }
    }
}

impl Zero {
    /// Its terms in the series in q.
    pub(super) fn across(&self) -> Across {
        match self.place {
            theta::Zero::Across(across) => across,
            theta::Zero::Along(_) => Across { decay: Dd::ZERO, fall: Dd::ONE, rest: Dd::ZERO },
        }
    }
}

impl Across<Two> {
    /// Two side by side.
    fn both([first, second]: [Across; 2]) -> Self {
        Self {
            decay: Dd::both([first.decay, second.decay]),
            fall: Dd::both([first.fall, second.fall]),
            rest: Dd::both([first.rest, second.rest]),
        }
    }
}

/// Terms that are formed in double-double; the others weigh less than q^16 < 1e-16.
const LEADING: usize = 4;

/// The series of H and H1 in q, divided by q^(1/4) e^y, y = pi eta/2K:
/// weights q^(n^2) (q e^{2y})^n of cosh and sinh((2n+1) y), times 2 e^{-(2n+1)y}.
pub(super) struct Wave<L = f64> {
    cosh: [Dd<L>; LEADING],
    sinh: [Dd<L>; LEADING],
    /// H1(-i eta).
    pub(super) at_zero: Dd<L>,
    /// Two terms more of the sum of (2n+1) sinh.
    more_slope: L,
}

impl<L: Exact> Wave<L> {
    #[inline]
    pub(super) fn new(zero: &Across<L>, nome: &Nome) -> Self {
        let Across { decay, fall, rest } = *zero;
        // 1 - E^{2n+1} = (1 - E)(1 + E + ... + E^{2n}), E = e^{-2y}.
        let (square, rest2) = (decay.square(), rest.square());
        let pair = decay.corrected(square);
        let third = (decay + 1.0).corrected(square);
        let fifth = third.corrected(square * pair);
        let seventh = fifth.corrected(square.square() * pair);
        let falls = [fall * third, fall * fifth, fall * seventh];
        let [q, q4, q9] = [nome.q, nome.q4, nome.q9].map(Dd::same);
        let weights = [q * rest, q4 * rest2, q9 * (rest2 * rest)];
        let [b, c, d] = core::array::from_fn(|n| weights[n] * (2.0 - falls[n]));
        let cosh = [2.0 - fall, b, c, d];
        let [b, c, d] = core::array::from_fn(|n| weights[n] * falls[n]);
        let sinh = [fall, b, c, d];
        let (e, two) = (decay.hi(), square.hi());
        let ninth = two * two * two * two * e;
        let fourth = rest2.hi() * nome.q16 * rest2.hi();
        let fifth = fourth * nome.q9.hi() * rest.hi();
        let [a, b, c, d] = cosh;
        let tail = fourth * (ninth + 1.0) + fifth * (ninth * two + 1.0);
        Self {
            cosh,
            sinh,
            at_zero: a.corrected(b).corrected(c.corrected(d.plus(tail))),
            more_slope: fourth * 9.0 * (-ninth + 1.0) + fifth * 11.0 * (-(ninth * two) + 1.0),
        }
    }

    /// d arg H1(x - i eta)/dz at x = 0, for a phase that runs past eta in the sense +1.
    #[inline]
    fn slope(&self) -> Dd<L> {
        let [a, b, c, d] = self.sinh;
        let small = (c * 5.0).corrected((d * 7.0).plus(self.more_slope));
        a.corrected(b * 3.0).corrected(small) / self.at_zero
    }

    /// The terms times `scale`, the first of each as a pair.
    #[inline]
    pub(super) fn times(&self, scale: Dd<L>) -> Terms<L> {
        let factor = scale.hi();
        let terms = |[first, b, c, d]: [Dd<L>; LEADING]| Leading {
            first: first * scale,
            rest: [b, c, d].map(|term| term.hi() * factor),
        };
        Terms { cosh: terms(self.cosh), sinh: terms(self.sinh) }
    }
}

/// The first of four coefficients, and the others, which are small beside it.
#[derive(Clone, Copy)]
struct Leading<L = f64> {
    first: Dd<L>,
    rest: [L; 3],
}

/// The series of H and H1 times a number.
pub(super) struct Terms<L = f64> {
    cosh: Leading<L>,
    sinh: Leading<L>,
}

impl Terms<Two> {
    /// One after the other.
    #[inline]
    fn parts(self) -> [Terms; 2] {
        let ([cosh, other_cosh], [sinh, other_sinh]) = (self.cosh.parts(), self.sinh.parts());
        [Terms { cosh, sinh }, Terms { cosh: other_cosh, sinh: other_sinh }]
    }
}

/// For a phase that runs past eta in the sense `sign`.
impl Terms {
    /// `side` H(x - i eta),
    /// H = sum (-1)^n [sin(2n+1)z cosh(2n+1)y - i cos(2n+1)z sinh(2n+1)y].
    #[inline]
    fn h(&self, sign: f64, side: f64) -> Factor {
        Factor {
            re: self.cosh.polynomial(side, -1.0, odd_polynomial),
            im: self.sinh.polynomial(-side * sign, -1.0, even_polynomial),
        }
    }

    /// H1(x - i eta) = sum [cos(2n+1)z cosh(2n+1)y + i sin(2n+1)z sinh(2n+1)y].
    #[inline]
    pub(super) fn h1(&self, sign: f64) -> Factor {
        Factor {
            re: self.cosh.polynomial(1.0, 1.0, even_polynomial),
            im: self.sinh.polynomial(sign, 1.0, odd_polynomial),
        }
    }
}

impl Leading {
    /// The polynomial of the four terms, with this sign and times the powers of `alternate`, its
    /// constant rounded once.
    #[inline]
    fn polynomial(
        &self,
        sign: f64,
        alternate: f64,
        polynomial: impl Fn([f64; 4]) -> [f64; 4],
    ) -> [f64; 4] {
        let [b, c, d] = self.rest;
        let odd = alternate * sign;
        let mut polynomial = polynomial([0.0, b * odd, c * sign, d * odd]);
        polynomial[0] = (self.first.scaled(sign) + polynomial[0]).to_f64();
        polynomial
    }
}

impl Leading<Two> {
    #[inline]
    fn parts(self) -> [Leading; 2] {
        let first = self.first.parts();
        let rest = self.rest.map(Pair::parts);
        [
            Leading { first: first[0], rest: rest.map(|(one, _)| one) },
            Leading { first: first[1], rest: rest.map(|(_, other)| other) },
        ]
    }
}

/// sum c_n sin((2n+1)z)/sin z in powers of k = 2 cos 2z.
#[inline]
fn odd_polynomial(c: [f64; 4]) -> [f64; 4] {
    [c[0] + c[1] - c[2] - c[3], c[1] + c[2] - (c[3] + c[3]), c[2] + c[3], c[3]]
}

/// sum c_n cos((2n+1)z)/cos z in powers of k = 2 cos 2z.
#[inline]
fn even_polynomial(c: [f64; 4]) -> [f64; 4] {
    [c[0] - c[1] - c[2] + c[3], c[1] - c[2] - (c[3] + c[3]), c[2] - c[3], c[3]]
}
