//! The set-up of the transverse rate's theta series.

use super::ripples::Ripple;
use super::series::Factor;
use super::waves::{Wave, Zero};
use crate::exact::nome::{Angle, Nome};
use crate::exact::theta::{self, Across};
use crate::math::DoubleDouble as Dd;

/// theta_2(z - i y) e^{i sense z}, up to a real factor: the first as polynomials in
/// k = 2 cos 2z, times cos z its real part and times sin z its imaginary one.
#[derive(Debug, Clone)]
pub(super) struct RateWave {
    pub(super) sense: f64,
    pub(super) factor: Factor,
}

/// The same after Jacobi's imaginary transformation: theta_3(d + iw | q') around the lower turning
/// point, times 1 and q' 2 sinh 2w real and imaginary part, and theta_2(d + iw | q') around the
/// upper one, times cosh w and sinh w, with d = y'_b - y'_a. The turn by +-z is dropped with the
/// phases of the others.
#[derive(Debug, Clone)]
pub(super) struct RateRipple(pub [Factor; 2]);

impl RateRipple {
    /// From the angles of the Cayley-Klein parameters' zeros, with their signs; `size` is the
    /// value at w = 0.
    pub(super) fn new(
        nome: &Nome,
        [(sign_a, a), (sign_b, b)]: [(f64, Angle); 2],
        size: Dd,
    ) -> Self {
        let sin = b.sin * a.cos * sign_b - b.cos * a.sin * sign_a;
        let cos = b.cos * a.cos + b.sin * a.sin * (sign_a * sign_b);
        // theta_3(d) = theta_4(d - pi/2).
        let angle = Angle { z: b.z * sign_b - a.z * sign_a - Dd::FRAC_PI_2, sin: -cos, cos: sin };
        let ripple = Ripple::new(1.0, angle, nome);
        let scale = size / ripple.at_zero;
        let upper = ripple.h(scale * nome.q.sqrt().scaled(4.0));
        Self([ripple.h1(scale), Factor { re: upper.im, im: upper.re.map(|c| -c) }])
    }
}

impl RateWave {
    /// From the zeros of the Cayley-Klein parameters; `size` is the value at z = 0.
    pub(super) fn new(nome: &Nome, a: &Zero, b: &Zero, size: Dd) -> Self {
        let (sense, zero) = zero(a, b);
        let wave = Wave::new(&zero.across(), nome);
        let terms = wave.times(size / wave.at_zero);
        Self { sense, factor: terms.h1(zero.sign) }
    }
}

/// The sense and the zero: y = y_b - y_a - `sense` pi K'/2K, as theta_4 times the rate's
/// series must have the quasi-periods of conj(alpha) beta.
///
/// The sense is the sense of y_b - y_a, so |y| <= pi K'/2K. The quotients may be 0/0 where q = 0;
/// then q beside them drops them.
fn zero(a: &Zero, b: &Zero) -> (f64, Zero) {
    let [(decay_a, rest_a), (decay_b, rest_b)] = [a, b].map(|zero| {
        let Across { decay, rest, .. } = zero.across();
        (decay, rest)
    });
    let quotient = |part: Dd, whole: Dd| {
        if whole == 0.0 { Dd::ZERO } else { part / whole }
    };
    let (sense, sign, decay, rest);
    if a.sign == b.sign {
        let beyond = decay_b <= decay_a;
        sense = if beyond { b.sign } else { -b.sign };
        sign = -sense;
        if beyond {
            (decay, rest) = (rest_b * decay_a, quotient(decay_b, decay_a));
        } else {
            (decay, rest) = (rest_a * decay_b, quotient(decay_a, decay_b));
        }
    } else {
        sense = b.sign;
        if decay_b <= rest_a {
            sign = sense;
            (decay, rest) = (quotient(decay_b, rest_a), rest_a * rest_b);
        } else {
            sign = -sense;
            (decay, rest) = (quotient(rest_a, decay_b), decay_a * decay_b);
        }
    }
    let fall = 1.0 - decay;
    let place = theta::Zero::Across(Across { decay, fall, rest });
    (sense, Zero { sign, place })
}
