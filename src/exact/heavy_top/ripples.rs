//! The set-up of the theta series near the homoclinic motion, where they run in the
//! complementary nome.

use super::series::Factor;
use crate::exact::nome::{Angle, Nome};
use crate::exact::theta::{ODD_COSINES, ODD_SINES, alternating, horner};
use crate::math::DoubleDouble as Dd;

/// The same after Jacobi's imaginary transformation: H as theta_1(y' + iw | q') divided
/// by 2 q'^(1/4) i, H1 as theta_4(y' + iw | q'), y' = pi eta/2K'.
pub(super) struct Ripple {
    sign: f64,
    y: Angle,
    /// theta_4(y'), and d arg theta_4(y' + iw)/dw at w = 0.
    pub(super) at_zero: Dd,
    pub(super) slope: Dd,
    /// sin and cos of y', 3y', 5y', 7y': each with the relative accuracy of the first.
    odd: [(f64, f64); 4],
    /// sin and cos of 2y', 4y', 6y'.
    even: [(f64, f64); 3],
    /// 1, q', q'^2, ...
    nome: [f64; 13],
    /// cos 4y' q'^4.
    second: Dd,
}

impl Ripple {
    pub(super) fn new(sign: f64, y: Angle, nome: &Nome) -> Self {
        let (sin2, cos2) = ((y.sin * y.cos).scaled(2.0), 1.0 - y.sin.square().scaled(2.0));
        let (sin4, cos4) = ((sin2 * cos2).scaled(2.0), cos2.square().scaled(2.0) - 1.0);
        let (s2, c2, s4, c4) = (sin2.hi(), cos2.hi(), sin4.hi(), cos4.hi());
        let (s6, c6) = (s2 * (1.0 + 2.0 * c4), c2 * (2.0 * c4 - 1.0));
        let (s8, c8) = (2.0 * s4 * c4, 2.0 * c4 * c4 - 1.0);
        let q9 = nome.q9.hi();
        let second = nome.q4 * cos4;
        let at_zero = Dd::ONE.corrected((nome.q * cos2).scaled(-2.0)).corrected(second.scaled(2.0))
            - 2.0 * (q9 * c6 - nome.q16 * c8);
        let slopes = (nome.q * sin2).corrected((nome.q4 * sin4).scaled(-2.0))
            + (3.0 * q9 * s6 - 4.0 * nome.q16 * s8);
        let (s, c) = (y.sin.hi(), y.cos.hi());
        let x = s * s;
        let odd = |n: usize| (s * horner(&ODD_SINES[n], x), c * horner(&ODD_COSINES[n], x));
        let mut powers = [1.0; 13];
        for n in 1..powers.len() {
            powers[n] = powers[n - 1] * nome.q.hi();
        }
        Self {
            sign,
            y,
            at_zero,
            slope: slopes.scaled(4.0) / at_zero * sign,
            odd: core::array::from_fn(odd),
            even: [(s2, c2), (s4, c4), (s6, c6)],
            nome: powers,
            second,
        }
    }

    /// sum (-1)^n q'^(n(n+1)) [cos(2n+1)y' sinh(2n+1)w - i sin(2n+1)y' cosh(2n+1)w],
    /// in powers of q' 2 cosh 2w.
    pub(super) fn h(&self, scale: Dd) -> Factor {
        let factor = scale.hi();
        // q'^(n(n+1) - j) belongs to the power j <= n of the variable.
        let weight = |n: usize, j: usize| alternating(n) * self.nome[n * (n + 1) - j];
        let re = |n: usize, j: usize| weight(n, j) * self.odd[n].1 * factor;
        let im = |n: usize, j: usize| weight(n, j) * (-self.sign * self.odd[n].0) * factor;
        let constant = |first: Dd, rest: f64| (first * scale + rest).to_f64();
        Factor {
            re: [
                constant(self.y.cos, re(1, 0) - re(2, 0) - re(3, 0)),
                re(1, 1) + re(2, 1) - 2.0 * re(3, 1),
                re(2, 2) + re(3, 2),
                re(3, 3),
            ],
            im: [
                constant(self.y.sin * -self.sign, im(3, 0) - im(1, 0) - im(2, 0)),
                im(1, 1) - im(2, 1) - 2.0 * im(3, 1),
                im(2, 2) - im(3, 2),
                im(3, 3),
            ],
        }
    }

    /// 1 + 2 sum (-1)^n q'^(n^2) [cos 2ny' cosh 2nw - i sin 2ny' sinh 2nw].
    pub(super) fn h1(&self, scale: Dd) -> Factor {
        let factor = scale.hi();
        let weight = |n: usize, j: usize| alternating(n) * self.nome[n * n - j] * factor;
        let re = |n: usize, j: usize| weight(n, j) * self.even[n - 1].1;
        let im = |n: usize, j: usize| -weight(n, j) * self.even[n - 1].0 * self.sign;
        // 2 cosh 4w = k^2 - 2, 2 cosh 6w = k^3 - 3k; sinh 4w = k sinh 2w,
        // sinh 6w = (k^2 - 1) sinh 2w.
        Factor {
            re: [
                ((1.0 - self.second.scaled(2.0)) * scale).to_f64(),
                re(1, 1) - 3.0 * re(3, 1),
                re(2, 2),
                re(3, 3),
            ],
            im: [im(1, 1) - im(3, 1), im(2, 2), im(3, 3), 0.0],
        }
    }
}
