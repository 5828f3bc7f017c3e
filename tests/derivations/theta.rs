//! Theta functions by their series, of complex arguments, and the periods by the mean.

use nalgebra::Complex;
use rotation_dynamics::math::{cosh, exp, log, sincos, sinh};

pub type C = Complex<f64>;

/// |z|.
pub fn size(z: C) -> f64 {
    z.norm_sqr().sqrt()
}

/// e^{i x}.
pub fn turn(x: f64) -> C {
    let (sin, cos) = sincos(x);
    C::new(cos, sin)
}

fn sine(z: C) -> C {
    let (sin, cos) = sincos(z.re);
    C::new(sin * cosh(z.im), cos * sinh(z.im))
}

fn cosine(z: C) -> C {
    let (sin, cos) = sincos(z.re);
    C::new(cos * cosh(z.im), -sin * sinh(z.im))
}

/// theta_n(z | q), DLMF 20.2: n = 1 to 4, to the terms that doubles hold.
pub fn theta(n: usize, z: C, q: f64) -> C {
    let mut sum = if n < 3 { C::new(0.0, 0.0) } else { C::new(0.5, 0.0) };
    for k in 0..14 {
        let order = f64::from(k);
        let sign = if k % 2 == 1 && (n == 1 || n == 4) { -1.0 } else { 1.0 };
        let power = |exponent: f64| exp(exponent * log(q));
        let half = order + 0.5;
        sum += match n {
            1 => sine(z * (2.0 * half)) * (sign * power(half * half)),
            2 => cosine(z * (2.0 * half)) * (sign * power(half * half)),
            _ if k == 0 => C::new(0.0, 0.0),
            _ => cosine(z * (2.0 * order)) * (sign * power(order * order)),
        };
    }
    sum * 2.0
}

/// The periods of a parameter, and its nome.
#[derive(Clone, Copy)]
pub struct Periods {
    /// K and K'.
    pub quarter: f64,
    pub conjugate: f64,
}

/// K of a complementary parameter, by the arithmetic-geometric mean.
fn quarter(m1: f64) -> f64 {
    let (mut a, mut b) = (1.0_f64, m1.sqrt());
    for _ in 0..9 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    core::f64::consts::FRAC_PI_2 / a
}

impl Periods {
    pub fn new(m: f64, m1: f64) -> Self {
        Self { quarter: quarter(m1), conjugate: quarter(m) }
    }

    /// q = exp(-pi K'/K).
    pub fn nome(&self) -> f64 {
        exp(-core::f64::consts::PI * self.conjugate / self.quarter)
    }

    /// q' = exp(-pi K/K').
    pub fn other_nome(&self) -> f64 {
        exp(-core::f64::consts::PI * self.quarter / self.conjugate)
    }

    /// z = pi u/2K.
    pub fn angle(&self, u: f64) -> f64 {
        core::f64::consts::FRAC_PI_2 * u / self.quarter
    }

    /// sn(u | m) of a complex argument (DLMF 22.2.4).
    pub fn sn(&self, u: C) -> C {
        let q = self.nome();
        let (z, nil) = (u * self.angle(1.0), C::new(0.0, 0.0));
        theta(3, nil, q) * theta(1, z, q) / (theta(2, nil, q) * theta(4, z, q))
    }
}
