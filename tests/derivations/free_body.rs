//! The page `how_free_body`: its equations, with the periods by the mean, the zero by Legendre's
//! integral and the theta functions by their series.

use super::theta::{C, Periods, size, theta, turn};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::{Characteristic, Modulus, legendre};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{DoubleDouble as Dd, EPS, atan, cosh, exp, hypot, log, sinh};
use support::{Errors, assert_largest};

/// Moments in the order J1, J2, J3, and the first and the last rate where the second is zero:
/// m from 0.03 to 0.998, the third moment the largest and the smallest.
const BODIES: [[f64; 5]; 6] = [
    [1.0, 2.0, 8.0 / 3.0, 0.4, 0.9],
    [1.0, 1.1, 1.9, 1.0, 0.5],
    [1.0, 2.0, 2.5, 1.0, 0.8951],
    [3.0, 2.0, 1.2, 0.3, 1.0],
    [2.5, 2.0, 1.0, 0.7, 1.0],
    [1.9, 1.89, 0.1, 0.2, 0.3],
];

/// The names of the page.
struct Plain {
    j: [f64; 3],
    rates: [f64; 2],
    momentum: f64,
    energy: f64,
    a: f64,
    b: f64,
    side: f64,
    p: f64,
    m: f64,
    periods: Periods,
    sense: f64,
    motion: FreeBody,
}

impl Plain {
    fn new([j1, j2, j3, w1, w3]: [f64; 5]) -> Self {
        let (j31, j32, j21) = (j3 - j1, j3 - j2, j2 - j1);
        let a = j1 * j31 * w1 * w1;
        let b = j3 * j31 * w3 * w3;
        let side = j3 * j32 * w3 * w3 - j1 * j21 * w1 * w1;
        let (m, m1) = (j21 * a / (j32 * b), j31 * side / (j32 * b));
        assert!(m1 > 0.0, "the third axis keeps its sign");
        let moments = PrincipalMoments::new(j1, j2, j3).expect("a body");
        let start = BodyVector::new(w1, 0.0, w3);
        Self {
            j: [j1, j2, j3],
            rates: [w1, w3],
            momentum: hypot(j1 * w1, j3 * w3),
            energy: 0.5 * (j1 * w1 * w1 + j3 * w3 * w3),
            a,
            b,
            side,
            p: (j32 * b / (j1 * j2 * j3)).sqrt(),
            m,
            periods: Periods::new(m, m1),
            sense: if j3 < j1 { 1.0 } else { -1.0 },
            motion: FreeBody::new(moments, Attitude::IDENTITY, start).expect("a motion"),
        }
    }

    fn zero(&self) -> f64 {
        let [j1, j2, j3] = self.j;
        let square = j1 * (j3 - j2) / (j3 * (j2 - j1));
        let complement = Modulus::from_m(1.0 - self.m).expect("below 1");
        legendre::f(atan(square.sqrt()), complement).expect("finite")
    }

    /// The rate at which alpha and beta turn, beside their series.
    fn local(&self) -> f64 {
        let [w1, w3] = self.rates;
        let [j1, _, j3] = self.j;
        let at_start = 0.5 * (w3 + j1 * w1 * w1 / (self.momentum + j3 * w3));
        let (q, y) = (self.periods.nome(), self.periods.angle(self.zero()));
        let [mut even, mut odd] = [1.0, 0.0];
        for n in 1..14 {
            let order = f64::from(n);
            let sign = if n % 2 == 0 { 2.0 } else { -2.0 };
            let weight = sign * exp(2.0 * order * order * log(q));
            even += weight * cosh(2.0 * order * y);
            odd -= 2.0 * order * weight * sinh(2.0 * order * y);
        }
        at_start - self.sense * self.p * self.periods.angle(1.0) * odd / even
    }

    fn cayley_klein(&self, t: f64, shift: f64) -> [C; 2] {
        let [_, w3] = self.rates;
        let c = self.j[2] * w3 / self.momentum;
        let q = self.periods.nome();
        let z = self.periods.angle(self.p * t);
        let y = self.sense * self.periods.angle(self.zero());
        let below = |z: f64| theta(4, C::new(z, 0.0), q).re;
        let wave = |n: usize, z: f64, y: f64| theta(n, C::new(z, y), q * q);
        let common = turn(self.local() * t) * (below(0.0) / below(z)).sqrt();
        [
            wave(4, z, y + shift) / wave(4, 0.0, y) * common * (0.5 * (1.0 + c)).sqrt(),
            wave(1, z, y + shift) / wave(1, 0.0, y)
                * common
                * C::new(0.0, -(0.5 * (1.0 - c)).sqrt()),
        ]
    }
}

#[test]
fn forms_without_the_middle_rate_are_those_with_it() {
    // 2 E J3 - L^2, L^2 - 2 E J1, L^2 - 2 E J2, and the complement of m.
    let errors = |damage: f64| {
        let mut errors = Errors::of("squares without differences");
        for body in BODIES {
            let plain = Plain::new(body);
            let ([j1, j2, j3], square) = (plain.j, plain.momentum * plain.momentum);
            let twice = 2.0 * damage * plain.energy;
            errors.push_at((twice * j3 - square - plain.a) / square, body);
            errors.push_at((square - twice * j1 - plain.b) / square, body);
            errors.push_at((square - twice * j2 - plain.side) / square, body);
            let complement = (j3 - j1) * plain.side / ((j3 - j2) * plain.b);
            errors.push_at(damage - plain.m - complement, body);
        }
        errors
    };
    assert_largest!(errors(1.0), 6 * 4, @"3.50e-16");
    errors(1.001).exceed(1e-6, 6 * 4);
}

#[test]
fn rates_are_elliptic_functions() {
    let errors = |damage: f64| {
        let mut errors = Errors::of("w1 = A1 cn, w2 = -sense A2 sn, w3 = A3 dn");
        for body in BODIES {
            let plain = Plain::new(body);
            let [j1, j2, j3] = plain.j;
            let (j31, j32) = (j3 - j1, j3 - j2);
            let amplitudes = [
                (plain.a / (j1 * j31)).sqrt(),
                -plain.sense * (plain.a / (j2 * j32)).sqrt(),
                (plain.b / (j3 * j31)).sqrt(),
            ];
            for k in 1..20 {
                let t = 0.21 * f64::from(k) * plain.periods.quarter / plain.p;
                let sn = plain.periods.sn(C::new(damage * plain.p * t, 0.0)).re;
                let dn = (1.0 - plain.m * sn * sn).sqrt();
                let omega = plain.motion.angular_velocity(t).to_array();
                let cn = omega[0] / amplitudes[0];
                let off = [
                    cn * cn + sn * sn - 1.0,
                    omega[1] - amplitudes[1] * sn,
                    omega[2] - amplitudes[2] * dn,
                ];
                errors.push_at(off.iter().fold(0.0, |sum, off| sum + off.abs()), (body, k));
            }
        }
        errors
    };
    assert_largest!(errors(1.0), 6 * 19, @"6.71e-15");
    errors(1.001).exceed(1e-6, 6 * 19);
    // The frequency with the opposite sign, as in the preprint of Celledoni et al.
    errors(-1.0).exceed(1e-3, 6 * 19);
}

#[test]
fn zero_is_a_constant_of_the_body() {
    // c dn(i eta) = 1, and the distance from the other end.
    let errors = |damage: f64| {
        let mut errors = Errors::of("l3 at the zero, and K'");
        for body in BODIES {
            let plain = Plain::new(body);
            let c = plain.j[2] * plain.rates[1] / plain.momentum;
            let eta = plain.zero() * damage;
            let sn = plain.periods.sn(C::new(0.0, eta));
            let square = (C::new(1.0, 0.0) - sn * sn * plain.m) * (c * c);
            errors.push_at(size(square - 1.0), body);
            let other = plain.j[2] * plain.b / (plain.j[0] * plain.a);
            let complement = Modulus::from_m(1.0 - plain.m).expect("below 1");
            let rest = legendre::f(atan(other.sqrt()), complement).expect("finite");
            errors.push_at(eta + rest - plain.periods.conjugate, body);
        }
        errors
    };
    assert_largest!(errors(1.0), 6 * 2, @"2.75e-14");
    errors(1.001).exceed(1e-6, 6 * 2);
}

#[test]
fn series_of_the_doubled_period_are_the_attitude() {
    let errors = |shift: f64| {
        let mut turned = Errors::of("attitude by the series, in rad");
        let mut lengths = Errors::of("their squares, which add up to 1");
        for body in BODIES {
            let plain = Plain::new(body);
            let quaternion = |t: f64, shift: f64| {
                let [alpha, beta] = plain.cayley_klein(t, shift);
                let found = [alpha.re, beta.re, beta.im, alpha.im];
                (found, Attitude::from_quaternion(found).expect("finite"))
            };
            let (_, start) = quaternion(0.0, 0.0);
            for k in 1..20 {
                let t = 0.21 * f64::from(k) * plain.periods.quarter / plain.p;
                let (found, now) = quaternion(t, shift);
                let since = start.inverse() * now;
                turned.push_at(since.angle_to(&plain.motion.attitude(t)), (body, k));
                let square: f64 = found.iter().map(|c| c * c).sum();
                lengths.push_at(square - 1.0, (body, k));
            }
        }
        (turned, lengths)
    };
    let (turned, lengths) = errors(0.0);
    assert_largest!(turned, 6 * 19, @"3.57e-15");
    assert_largest!(lengths, 6 * 19, @"6.66e-16");
    let (turned, lengths) = errors(1e-3);
    turned.exceed(1e-6, 6 * 19);
    assert!(lengths.largest() > 1e-4);
}

#[test]
fn advance_is_that_of_the_third_kind() {
    let errors = |damage: f64| {
        let mut errors = Errors::of("advance in a period of the rates, in rad");
        for body in BODIES {
            let plain = Plain::new(body);
            let [j1, j2, j3] = plain.j;
            let n = -damage * j3 * (j2 - j1) / (j1 * (j3 - j2));
            let n = Characteristic::from_n(n).expect("finite");
            let modulus = Modulus::from_m(plain.m).expect("below 1");
            let third = legendre::complete_pi(n, modulus).expect("finite");
            let plainly = 4.0 * plain.momentum / plain.p
                * (plain.periods.quarter / j3 + (1.0 / j1 - 1.0 / j3) * third);
            let half = 2.0 * plain.periods.quarter / plain.p;
            let by_rates = 4.0 * plain.local() * half - core::f64::consts::TAU * plain.sense;
            errors.push_at(by_rates - plainly, body);
            errors.push_at(plain.motion.precession_per_period() - plainly, body);
        }
        errors
    };
    assert_largest!(errors(1.0), 6 * 2, @"2.13e-14");
    errors(1.01).exceed(1e-6, 6 * 2);
}

#[test]
fn the_other_nome_gives_the_same_series() {
    // theta_4 and theta_1 of nome q^2 by theta_2 and theta_1 of the root of q'.
    let errors = |damage: f64| {
        let mut errors = Errors::of("ratios of both series");
        for body in BODIES {
            let plain = Plain::new(body);
            let Periods { quarter, conjugate } = plain.periods;
            let (q, other) = (plain.periods.nome(), plain.periods.other_nome().sqrt());
            let eta = plain.zero();
            let angle = core::f64::consts::FRAC_PI_2 * eta / conjugate * damage;
            for k in 1..=4 {
                let x = 0.25 * f64::from(k) * quarter;
                let (z, y) = (plain.periods.angle(x), plain.periods.angle(eta));
                let w = 0.5 * core::f64::consts::FRAC_PI_2 * x / conjugate;
                let (own, far) = (C::new(z, y), C::new(-0.5 * angle, w));
                let (four, two) = (theta(4, own, q * q), theta(2, far, other));
                let (one, first) = (theta(1, own, q * q), theta(1, far, other));
                let quotient = (one / four) / (first / two);
                errors.push_at(size(quotient + C::new(0.0, 1.0)), (body, k));
                let phase = turn(z * angle / core::f64::consts::PI);
                let ratio = four * phase / two;
                errors.push_at(ratio.im / size(ratio), (body, k));
            }
        }
        errors
    };
    assert_largest!(errors(1.0), 6 * 4 * 2, @"6.69e-16");
    assert!(errors(1.01).largest() > 1e-3);
}

#[test]
fn the_slow_rate_is_a_root_of_a_sum() {
    // l3 from 1 - m and l1, and as the difference of what alpha and beta are squared, beside the
    // separatrix: relative, against L and E.
    let mut root = Errors::in_units_of(EPS, "l3 as the root of a sum");
    let mut difference = Errors::in_units_of(EPS, "l3 as a difference of squares");
    for narrow in [1e-3, 1e-5, 1e-7] {
        // Moments 1, 2, 3: side = 3 w3^2 - w1^2, with b = 6 w3^2 and m1 = side/(3 w3^2).
        let w3 = (1.0 + narrow) / 3.0_f64.sqrt();
        let plain = Plain::new([1.0, 2.0, 3.0, 1.0, w3]);
        let side = Dd::product(w3, w3) * 3.0 - 1.0;
        let m1 = 2.0 * side.to_f64() / plain.b;
        let quarter = 0.5 * 0.5 * plain.motion.rate_period();
        for part in [0.9, 0.99, 1.0] {
            let omega = plain.motion.angular_velocity(part * quarter);
            let l = plain.motion.body_momentum(omega) / plain.momentum;
            let c = 3.0 * w3 / plain.momentum;
            let largest = 1.0 / plain.momentum;
            let cn = l.x() / largest;
            let by_root = c * (m1 + plain.m * cn * cn).sqrt();
            // |alpha|^2 and |beta|^2, each a double.
            let (alpha, beta) = (0.5 * (1.0 + l.z()), 0.5 * (1.0 - l.z()));
            root.push_at(by_root / l.z() - 1.0, (narrow, part));
            difference.push_at((alpha - beta) / l.z() - 1.0, (narrow, part));
        }
    }
    assert_largest!(root, 9, @"4");
    assert!(difference.largest() > 1e2);
}
