//! The Cayley-Klein parameters between two turning points, as theta functions.
//!
//! With tau = p t from the lower turning point and z = pi tau/2K,
//!
//!   sqrt((1+v)/2) e^{i..} ~ H(tau - i eta_a)/Theta(tau) e^{i nu_a t},
//!   sqrt((1-v)/2) e^{i..} ~ H1(tau - i eta_b)/Theta(tau) e^{i nu_b t}
//!
//! (Jacobi's H, H1, Theta = theta_1, theta_2, theta_4 of z and nome q). Theta is common and real:
//! it drops out on normalising. Around the upper turning point, tau = K + x, H becomes H1(x) and H1
//! becomes -H(x). So |x| <= K/2 is enough and the zeros, where the axis passes near a pole, keep
//! relative accuracy.
//!
//! For m <= 0.8 the series runs in q, for m > 0.8, after Jacobi's imaginary
//! transformation, in q' = exp(-pi K/K') with hyperbolic functions of w = pi x/2K';
//! q' = 0 is the homoclinic motion. Either nome is below 0.1: four terms do.
//! Attitude and rates have forms of their own (`super::sample`, `super::hyperbolic`).
//!
//! Sources: DLMF 20.2, 20.7(viii); F. Klein, A. Sommerfeld, *Theorie des Kreisels*,
//! VI.

use crate::exact::theta::horner;
use crate::math;
use nalgebra::Complex;

/// Both parameters at a point, up to a common real factor, with derivatives by z or w.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair {
    pub(super) a: Complex<f64>,
    pub(super) b: Complex<f64>,
}

/// One factor as the series of its real and imaginary part, polynomials in k = 2 cos 2z
/// or in q' 2 cosh 2w.
#[derive(Debug, Clone, Copy)]
pub(super) struct Factor {
    pub(super) re: [f64; 4],
    pub(super) im: [f64; 4],
}

/// The series around both turning points.
#[derive(Debug, Clone)]
pub(super) struct Series {
    pub(super) hyperbolic: bool,
    /// q', or q.
    pub(super) nome: f64,
    /// [lower, upper] turning point: the factor of type H and the one of type H1.
    pub(super) sides: [[Factor; 2]; 2],
}

impl Series {
    /// Both parameters at the distance `x` (z or w) from a turning point.
    #[inline]
    pub(super) fn at(&self, upper: bool, x: f64) -> Pair {
        let [h, h1] = &self.sides[usize::from(upper)];
        let (k, odd, even, re1, im1) = if self.hyperbolic {
            let (odd, even, e, sum, difference) = self.hyperbolic_functions(x);
            (sum, odd, even, e, e * difference)
        } else {
            let (sin, cos) = math::sincos(x);
            (2.0 - 4.0 * sin * sin, sin, cos, cos, sin)
        };
        let first = Complex::new(odd * horner(&h.re, k), even * horner(&h.im, k));
        let second = Complex::new(re1 * horner(&h1.re, k), im1 * horner(&h1.im, k));
        if upper { Pair { a: second, b: first } } else { Pair { a: first, b: second } }
    }

    /// The same with the derivatives by `x`.
    #[inline]
    pub(super) fn with_slopes(&self, upper: bool, x: f64) -> (Pair, Pair) {
        let [h, h1] = &self.sides[usize::from(upper)];
        // Factors and k with their derivatives; the common e^-|w| counts as constant.
        let (k, dk, odd, even, d_even, re1, d_re1, im1, d_im1);
        if self.hyperbolic {
            let (sinh, cosh, e, sum, difference) = self.hyperbolic_functions(x);
            (k, dk) = (sum, 2.0 * difference);
            (odd, even, d_even) = (sinh, cosh, sinh);
            (re1, d_re1) = (e, 0.0);
            (im1, d_im1) = (e * difference, e * 2.0 * sum);
        } else {
            let (sin, cos) = math::sincos(x);
            (k, dk) = (2.0 - 4.0 * sin * sin, -8.0 * sin * cos);
            (odd, even, d_even) = (sin, cos, -sin);
            (re1, d_re1) = (cos, -sin);
            (im1, d_im1) = (sin, cos);
        }
        let part = |f: f64, df: f64, p: &[f64; 4]| {
            let value = horner(p, k);
            let slope = p[1] + k * (2.0 * p[2] + k * 3.0 * p[3]);
            (f * value, df * value + f * slope * dk)
        };
        let (first_re, d_first_re) = part(odd, even, &h.re);
        let (first_im, d_first_im) = part(even, d_even, &h.im);
        let (second_re, d_second_re) = part(re1, d_re1, &h1.re);
        let (second_im, d_second_im) = part(im1, d_im1, &h1.im);
        let first = Complex::new(first_re, first_im);
        let second = Complex::new(second_re, second_im);
        let d_first = Complex::new(d_first_re, d_first_im);
        let d_second = Complex::new(d_second_re, d_second_im);
        if upper {
            (Pair { a: second, b: first }, Pair { a: d_second, b: d_first })
        } else {
            (Pair { a: first, b: second }, Pair { a: d_first, b: d_second })
        }
    }

    /// e^-|w| times sinh w and cosh w; e^-|w|; q' times 2 cosh 2w and 2 sinh 2w.
    #[inline]
    fn hyperbolic_functions(&self, w: f64) -> (f64, f64, f64, f64, f64) {
        let decay = math::expm1(-2.0 * w.abs());
        let e = math::exp(-w.abs());
        let odd = (-0.5 * decay).copysign(w);
        let even = 0.5 * (2.0 + decay);
        let (mut sum, mut difference) = (0.0, 0.0);
        if self.nome > 0.0 {
            // |w| stays below the middle of the turning points: q' e^{2|w|} <= sqrt(q').
            let squared = e * e;
            let grown = self.nome / squared;
            sum = grown + self.nome * squared;
            difference = (-decay * (grown + self.nome)).copysign(w);
        }
        (odd, even, e, sum, difference)
    }
}
