//! The set-up of the theta series: zeros, nome, coefficients, in double-double
//! arithmetic.
//!
//! The Fourier terms of `super::series` are summed as polynomials: sin(2n+1)z/sin z,
//! cos(2n+1)z/cos z and cos 2nz are polynomials in k = 2 cos 2z.

use super::ripples::Ripple;
use super::series::{Factor, Series};
use crate::exact::nome::Nome;
use crate::exact::theta::{self, Across};
use crate::math::DoubleDouble as Dd;

/// The zero i eta of one Cayley-Klein parameter, off the real axis, 0 <= eta <= K'.
#[derive(Debug, Clone, Copy)]
pub(super) struct Zero {
    /// The sense in which the phase runs past it: +1 or -1.
    pub sign: f64,
    pub place: theta::Zero,
}

/// What the set-up learns besides the series: the phase rates d arg/dz that the two
/// series have where they are matched.
pub(super) struct Matched {
    pub series: Series,
    /// d arg a/dz at the upper turning point.
    pub slope_a: Dd,
    /// d arg b/dz at the lower turning point.
    pub slope_b: Dd,
}

impl Series {
    /// `a` and `b` are the zeros; at the upper turning point |a| is `size_a`, at the lower
    /// one |b| is `size_b`.
    pub fn matched(nome: &Nome, a: &Zero, b: &Zero, size_a: Dd, size_b: Dd) -> Matched {
        match [a.place, b.place] {
            [theta::Zero::Along(angle_a), theta::Zero::Along(angle_b)] => {
                let waves = [(a.sign, angle_a), (b.sign, angle_b)]
                    .map(|(sign, angle)| Ripple::new(sign, angle, nome));
                Self::hyperbolic(nome, &waves, size_a, size_b)
            }
            _ => {
                let waves = [a, b].map(|zero| Wave::new(zero, nome));
                Self::trigonometric(nome, &waves, size_a, size_b * nome.root_k1)
            }
        }
    }

    fn trigonometric(nome: &Nome, waves: &[Wave; 2], size_a: Dd, size_b: Dd) -> Matched {
        let [scale_a, scale_b] = [size_a / waves[0].at_zero, size_b / waves[1].at_zero];
        let series = Self {
            hyperbolic: false,
            nome: nome.q.to_f64(),
            sides: [
                [waves[0].h(scale_a), waves[1].h1(scale_b)],
                [waves[1].h(-scale_b), waves[0].h1(scale_a)],
            ],
        };
        Matched {
            series,
            slope_a: waves[0].slope(),
            slope_b: waves[1].slope(),
        }
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
        Matched {
            series,
            slope_a: waves[0].slope,
            slope_b: waves[1].slope,
        }
    }
}

/// Terms that are formed in double-double; the others weigh less than q^16 < 1e-16.
const LEADING: usize = 4;

/// The series of H and H1 in q, divided by q^(1/4) e^y, y = pi eta/2K:
/// weights q^(n^2) (q e^{2y})^n of cosh and sinh((2n+1) y), times 2 e^{-(2n+1)y}.
pub(super) struct Wave {
    sign: f64,
    cosh: [Dd; LEADING],
    sinh: [Dd; LEADING],
    /// H1(-i eta).
    pub at_zero: Dd,
    /// Two terms more of the sum of (2n+1) sinh.
    more_slope: f64,
}

impl Wave {
    pub fn new(zero: &Zero, nome: &Nome) -> Self {
        let Across { decay, fall, rest } = match zero.place {
            theta::Zero::Across(across) => across,
            theta::Zero::Along(_) => Across {
                decay: Dd::ZERO,
                fall: Dd::ONE,
                rest: Dd::ZERO,
            },
        };
        // 1 - E^{2n+1} = (1 - E)(1 + E + ... + E^{2n}), E = e^{-2y}.
        let (square, rest2) = (decay.square(), rest.square());
        let pair = decay + square;
        let third = pair + 1.0;
        let fifth = third + square * pair;
        let seventh = fifth + square.square() * pair;
        let falls = [fall, fall * third, fall * fifth, fall * seventh];
        let weights = [
            Dd::ONE,
            nome.q * rest,
            nome.q4 * rest2,
            nome.q9 * (rest2 * rest),
        ];
        let cosh @ [a, b, c, d] = core::array::from_fn(|n| weights[n] * (2.0 - falls[n]));
        let sinh = core::array::from_fn(|n| weights[n] * falls[n]);
        let (e, two) = (decay.hi(), square.hi());
        let ninth = two * two * two * two * e;
        let fourth = nome.q16 * rest2.hi() * rest2.hi();
        let fifth = fourth * nome.q9.hi() * rest.hi();
        Self {
            sign: zero.sign,
            cosh,
            sinh,
            at_zero: a + b + (c + (d + (fourth * (1.0 + ninth) + fifth * (1.0 + ninth * two)))),
            more_slope: 9.0 * fourth * (1.0 - ninth) + 11.0 * fifth * (1.0 - ninth * two),
        }
    }

    /// d arg H1(x - i eta)/dz at x = 0.
    fn slope(&self) -> Dd {
        let [a, b, c, d] = self.sinh;
        let sum = a + b * 3.0 + (c * 5.0 + (d * 7.0 + self.more_slope));
        sum / self.at_zero * self.sign
    }

    /// H(x - i eta) = sum (-1)^n [sin(2n+1)z cosh(2n+1)y - i cos(2n+1)z sinh(2n+1)y].
    fn h(&self, scale: Dd) -> Factor {
        let (re, im) = self.scaled(scale, scale * -self.sign, -1.0);
        Factor {
            re: with_leading(re, odd_polynomial),
            im: with_leading(im, even_polynomial),
        }
    }

    /// H1(x - i eta) = sum [cos(2n+1)z cosh(2n+1)y + i sin(2n+1)z sinh(2n+1)y].
    pub fn h1(&self, scale: Dd) -> Factor {
        let (re, im) = self.scaled(scale, scale * self.sign, 1.0);
        Factor {
            re: with_leading(re, even_polynomial),
            im: with_leading(im, odd_polynomial),
        }
    }

    /// The leading terms of cosh and sinh times these and the powers of `alternate`: the
    /// first in double-double.
    fn scaled(&self, cosh: Dd, sinh: Dd, alternate: f64) -> (Leading, Leading) {
        let terms = |[first, b, c, d]: [Dd; LEADING], scale: Dd| {
            let factor = scale.hi();
            let rest = [b.hi() * alternate, c.hi(), d.hi() * alternate];
            (first * scale, rest.map(|term| term * factor))
        };
        (terms(self.cosh, cosh), terms(self.sinh, sinh))
    }
}

/// The first of four coefficients, and the others, which are small beside it.
type Leading = (Dd, [f64; 3]);

/// The polynomial of four terms, its constant rounded once.
fn with_leading((first, [b, c, d]): Leading, polynomial: fn([f64; 4]) -> [f64; 4]) -> [f64; 4] {
    let mut polynomial = polynomial([0.0, b, c, d]);
    polynomial[0] = (first + polynomial[0]).to_f64();
    polynomial
}

/// sum c_n sin((2n+1)z)/sin z in powers of k = 2 cos 2z.
fn odd_polynomial(c: [f64; 4]) -> [f64; 4] {
    [
        c[0] + c[1] - c[2] - c[3],
        c[1] + c[2] - (c[3] + c[3]),
        c[2] + c[3],
        c[3],
    ]
}

/// sum c_n cos((2n+1)z)/cos z in powers of k = 2 cos 2z.
fn even_polynomial(c: [f64; 4]) -> [f64; 4] {
    [
        c[0] - c[1] - c[2] + c[3],
        c[1] - c[2] - (c[3] + c[3]),
        c[2] - c[3],
        c[3],
    ]
}
