//! The set-up of the theta series: zeros, nome, coefficients, in double-double
//! arithmetic.
//!
//! The Fourier terms of `super::series` are summed as polynomials: sin(2n+1)z/sin z,
//! cos(2n+1)z/cos z and cos 2nz are polynomials in k = 2 cos 2z.

use super::series::{Factor, Series};
use crate::math::DoubleDouble as Dd;

/// The zero i eta of one Cayley-Klein parameter, off the real axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Zero {
    /// The sense in which the phase runs past it: +1 or -1.
    pub sign: f64,
    /// eta >= 0; infinite for a steady motion.
    pub eta: Dd,
    /// K' - eta, without cancellation; infinite if K' is.
    pub rest: Dd,
}

/// Periods and nome.
#[derive(Debug, Clone, Copy)]
pub(super) struct Periods {
    /// K.
    pub quarter: Dd,
    /// K'.
    pub quarter_prime: Dd,
    /// m > 1/2.
    pub hyperbolic: bool,
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

/// Terms kept in the set-up: the next would weigh q^36 < 1e-48.
const TERMS: usize = 6;

/// The powers of the nome up to the last term's.
type Powers = [Dd; (TERMS - 1) * (TERMS - 1) + 1];

impl Series {
    /// `a` and `b` are the zeros; at the upper turning point |a| is `size_a`, at the lower
    /// one |b| is `size_b`; `root_m1` is (1-m)^(1/4).
    pub fn matched(
        periods: &Periods,
        a: &Zero,
        b: &Zero,
        size_a: Dd,
        size_b: Dd,
        root_m1: Dd,
    ) -> Matched {
        if periods.hyperbolic {
            Self::hyperbolic(periods, a, b, size_a, size_b)
        } else {
            Self::trigonometric(periods, a, b, size_a, size_b * root_m1)
        }
    }

    fn trigonometric(periods: &Periods, a: &Zero, b: &Zero, size_a: Dd, size_b: Dd) -> Matched {
        let nome = nome(periods.quarter_prime, periods.quarter);
        let powers: Powers = powers(nome);
        let waves = [a, b].map(|zero| Wave::new(zero, &powers, periods.quarter));
        let [scale_a, scale_b] = [size_a / waves[0].at_zero(), size_b / waves[1].at_zero()];
        let series = Self {
            hyperbolic: false,
            nome: nome.to_f64(),
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

    fn hyperbolic(periods: &Periods, a: &Zero, b: &Zero, size_a: Dd, size_b: Dd) -> Matched {
        let nome = nome(periods.quarter, periods.quarter_prime);
        let powers: Powers = powers(nome);
        let waves = [a, b].map(|zero| Ripple::new(zero, &powers, periods.quarter_prime));
        // theta_3(0) and theta_2(0)/(2 q'^(1/4)) at nome q'.
        let (mut theta3, mut theta2) = (Dd::ONE, Dd::ONE);
        for n in 1..TERMS {
            theta3 += powers[n * n].scaled(2.0);
            if n * (n + 1) < powers.len() {
                theta2 += powers[n * (n + 1)];
            }
        }
        let scale_a = size_a * theta3 / waves[0].at_zero();
        let scale_b = size_b * theta2 / waves[1].at_zero();
        let scale_upper = scale_b * nome.sqrt().scaled(4.0);
        let series = Self {
            hyperbolic: true,
            nome: nome.to_f64(),
            sides: [
                [waves[0].h(scale_a), waves[1].h1(scale_b)],
                [waves[1].h(-scale_upper), waves[0].h1(scale_a)],
            ],
        };
        Matched {
            series,
            slope_a: waves[0].slope(),
            slope_b: waves[1].slope(),
        }
    }
}

/// exp(-pi K'/K), zero if K' is infinite.
fn nome(quarter_prime: Dd, quarter: Dd) -> Dd {
    if quarter.is_finite() && quarter_prime.is_finite() {
        (-(Dd::PI * quarter_prime / quarter)).exp()
    } else {
        Dd::ZERO
    }
}

/// 1, x, x^2, ...
fn powers<const N: usize>(x: Dd) -> [Dd; N] {
    let mut powers = [Dd::ONE; N];
    for n in 1..N {
        powers[n] = powers[n - 1] * x;
    }
    powers
}

/// The series of H and H1 in q, divided by q^(1/4) e^y, y = pi eta/2K:
/// weights q^(n^2) (q e^{2y})^n of cosh and sinh((2n+1) y), times 2 e^{-(2n+1)y}.
struct Wave {
    sign: f64,
    cosh: [Dd; TERMS],
    sinh: [Dd; TERMS],
}

impl Wave {
    fn new(zero: &Zero, nome: &Powers, quarter: Dd) -> Self {
        let rest = if zero.rest.is_finite() {
            // q e^{2y} from K' - eta: no q -> 0 times e^y -> infinity.
            (-(Dd::PI * zero.rest / quarter)).exp()
        } else {
            Dd::ZERO
        };
        let rest: [Dd; TERMS] = powers(rest);
        // e^{-(2n+1) 2y} - 1 from n = 0 on: the terms of x + y + x y agree in sign.
        let mut fall = if zero.eta.is_finite() {
            (-(Dd::PI * zero.eta / quarter)).exp_m1()
        } else {
            -Dd::ONE
        };
        let two = fall.scaled(2.0) + fall.square();
        let (mut cosh, mut sinh) = ([Dd::ZERO; TERMS], [Dd::ZERO; TERMS]);
        for n in 0..TERMS {
            let weight = nome[n * n] * rest[n];
            cosh[n] = weight * (fall + 2.0);
            sinh[n] = -weight * fall;
            fall = fall + two + fall * two;
        }
        Self {
            sign: zero.sign,
            cosh,
            sinh,
        }
    }

    /// H1(-i eta).
    fn at_zero(&self) -> Dd {
        self.cosh.iter().fold(Dd::ZERO, |sum, c| sum + *c)
    }

    /// d arg H1(x - i eta)/dz at x = 0.
    fn slope(&self) -> Dd {
        let sum = self
            .sinh
            .iter()
            .enumerate()
            .fold(Dd::ZERO, |sum, (n, s)| sum + *s * (2 * n + 1) as f64);
        sum / self.at_zero() * self.sign
    }

    /// H(x - i eta) = sum (-1)^n [sin(2n+1)z cosh(2n+1)y - i cos(2n+1)z sinh(2n+1)y].
    fn h(&self, scale: Dd) -> Factor {
        let alternating = |n: usize| if n.is_multiple_of(2) { scale } else { -scale };
        let re = core::array::from_fn(|n| self.cosh[n] * alternating(n));
        let im = core::array::from_fn(|n| self.sinh[n] * alternating(n) * -self.sign);
        Factor {
            re: odd_polynomial(re).map(Dd::to_f64),
            im: even_polynomial(im).map(Dd::to_f64),
        }
    }

    /// H1(x - i eta) = sum [cos(2n+1)z cosh(2n+1)y + i sin(2n+1)z sinh(2n+1)y].
    fn h1(&self, scale: Dd) -> Factor {
        let re = core::array::from_fn(|n| self.cosh[n] * scale);
        let im = core::array::from_fn(|n| self.sinh[n] * scale * self.sign);
        Factor {
            re: even_polynomial(re).map(Dd::to_f64),
            im: odd_polynomial(im).map(Dd::to_f64),
        }
    }
}

/// The same after Jacobi's imaginary transformation: H as theta_1(y' + iw | q') divided
/// by 2 q'^(1/4) i, H1 as theta_4(y' + iw | q'), y' = pi eta/2K'.
struct Ripple<'a> {
    sign: f64,
    nome: &'a Powers,
    /// sin and cos of j y', j = 0, 1, ...
    harmonics: [(Dd, Dd); 2 * TERMS],
}

impl<'a> Ripple<'a> {
    fn new(zero: &Zero, nome: &'a Powers, quarter_prime: Dd) -> Self {
        let (sin, cos) = (Dd::FRAC_PI_2 * zero.eta / quarter_prime).sin_cos();
        let mut harmonics = [(Dd::ZERO, Dd::ONE); 2 * TERMS];
        for j in 1..harmonics.len() {
            let (s, c) = harmonics[j - 1];
            harmonics[j] = (s * cos + c * sin, c * cos - s * sin);
        }
        Self {
            sign: zero.sign,
            nome,
            harmonics,
        }
    }

    /// (-1)^n times a power of q'.
    fn weight(&self, exponent: usize, n: usize) -> Dd {
        let weight = self.nome[exponent];
        if n.is_multiple_of(2) { weight } else { -weight }
    }

    /// theta_4(y').
    fn at_zero(&self) -> Dd {
        (1..TERMS).fold(Dd::ONE, |sum, n| {
            sum + self.weight(n * n, n).scaled(2.0) * self.harmonics[2 * n].1
        })
    }

    /// d arg theta_4(y' + iw)/dw at w = 0.
    fn slope(&self) -> Dd {
        let sum = (1..TERMS).fold(Dd::ZERO, |sum, n| {
            sum - self.weight(n * n, n) * self.harmonics[2 * n].0 * (4 * n) as f64
        });
        sum / self.at_zero() * self.sign
    }

    /// sum (-1)^n q'^(n(n+1)) [cos(2n+1)y' sinh(2n+1)w - i sin(2n+1)y' cosh(2n+1)w],
    /// in powers of q' 2 cosh 2w.
    fn h(&self, scale: Dd) -> Factor {
        let term = |n: usize, j: usize, wave: Dd| {
            // q'^(n(n+1) - j) belongs to the power j <= n of the variable.
            self.weight(n * (n + 1) - j, n) * wave * scale
        };
        let by_power = |polynomial: fn([Dd; 4]) -> [Dd; 4], wave: &dyn Fn(usize) -> Dd| {
            core::array::from_fn(|j| {
                let terms =
                    core::array::from_fn(|n| if n < j { Dd::ZERO } else { term(n, j, wave(n)) });
                polynomial(terms)[j].to_f64()
            })
        };
        Factor {
            re: by_power(odd_polynomial, &|n| self.harmonics[2 * n + 1].1),
            im: by_power(even_polynomial, &|n| {
                self.harmonics[2 * n + 1].0 * -self.sign
            }),
        }
    }

    /// 1 + 2 sum (-1)^n q'^(n^2) [cos 2ny' cosh 2nw - i sin 2ny' sinh 2nw].
    fn h1(&self, scale: Dd) -> Factor {
        let re = |n: usize, j: usize| self.weight(n * n - j, n) * self.harmonics[2 * n].1;
        let im =
            |n: usize, j: usize| -self.weight(n * n - j, n) * self.harmonics[2 * n].0 * self.sign;
        // 2 cosh 4w = k^2 - 2, 2 cosh 6w = k^3 - 3k; sinh 4w = k sinh 2w,
        // sinh 6w = (k^2 - 1) sinh 2w.
        let re = [
            Dd::ONE - re(2, 0).scaled(2.0),
            re(1, 1) - re(3, 1) * 3.0,
            re(2, 2),
            re(3, 3),
        ];
        let im = [im(1, 1) - im(3, 1), im(2, 2), im(3, 3), Dd::ZERO];
        Factor {
            re: re.map(|c| (c * scale).to_f64()),
            im: im.map(|c| (c * scale).to_f64()),
        }
    }
}

/// sum c_n sin((2n+1)z)/sin z in powers of k = 2 cos 2z.
fn odd_polynomial(c: [Dd; 4]) -> [Dd; 4] {
    [
        c[0] + c[1] - c[2] - c[3],
        c[1] + c[2] - c[3].scaled(2.0),
        c[2] + c[3],
        c[3],
    ]
}

/// sum c_n cos((2n+1)z)/cos z in powers of k = 2 cos 2z.
fn even_polynomial(c: [Dd; 4]) -> [Dd; 4] {
    [
        c[0] - c[1] - c[2] + c[3],
        c[1] - c[2] - c[3].scaled(2.0),
        c[2] - c[3],
        c[3],
    ]
}
