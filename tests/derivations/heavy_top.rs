//! The page `how_heavy_top`: its equations, with the turning points by bisection, the periods by
//! the mean, the zeros by Legendre's integral and the theta functions by their series.

use super::theta::{C, Periods, size, theta, turn};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::exact::{Characteristic, Modulus, legendre};
use rotation_dynamics::math::{atan, cosh, exp, log, sincos, sinh};
use support::{Errors, assert_largest};

/// a, b, c and E~ of what is tried: waves and loops, m from 0.04 to 0.95, L_Z and L_z of equal
/// and of opposite sign.
const TOPS: [[f64; 4]; 6] = [
    [2.0, 1.2, 0.2, 0.55],
    [2.0, 0.6, 0.2, 0.11],
    [1.0, 0.9, 0.9, 0.05],
    [1.0, 1.02, 0.5, 0.003],
    [0.3, -1.4, 2.0, 0.7],
    [0.165, -0.3, 0.006, 0.15],
];

/// The names of the page; gravity pulls towards v = -1.
struct Plain {
    top: ReducedTop,
    energy: f64,
    spin: f64,
    sum: f64,
    difference: f64,
    gravity: f64,
    excess: f64,
    free_spin: f64,
    v: [f64; 3],
    p: f64,
    periods: Periods,
    modulus: Modulus,
}

/// The root of `f` in the bracket.
fn bisected(f: impl Fn(f64) -> f64, [mut below, mut above]: [f64; 2]) -> f64 {
    let rising = f(above) > f(below);
    for _ in 0..200 {
        let middle = 0.5 * (below + above);
        if (f(middle) > 0.0) == rising {
            above = middle;
        } else {
            below = middle;
        }
    }
    0.5 * (below + above)
}

impl Plain {
    fn new([a, b, c, energy]: [f64; 4]) -> Self {
        let spin = a.sqrt();
        let (sum, difference) = (spin * (b + 1.0), spin * (b - 1.0));
        let (gravity, excess) = (2.0 * c, 2.0 * energy);
        let cubic = |v: f64| {
            let across = difference + spin * (1.0 - v);
            (1.0 - v * v) * (excess + gravity * (1.0 - v)) - across * across
        };
        let inside = (-999..1000)
            .map(|k| 1e-3 * f64::from(k))
            .max_by(|x, y| cubic(*x).total_cmp(&cubic(*y)))
            .expect("places");
        assert!(cubic(inside) > 0.0, "a motion");
        let v = [
            bisected(cubic, [-1.0, inside]),
            bisected(cubic, [inside, 1.0]),
            bisected(cubic, [1.0, 1e6]),
        ];
        let m = (v[1] - v[0]) / (v[2] - v[0]);
        let m1 = (v[2] - v[1]) / (v[2] - v[0]);
        Self {
            top: ReducedTop::new(a, b, c).expect("a top"),
            energy,
            spin,
            sum,
            difference,
            gravity,
            excess,
            free_spin: 1.0 / spin - spin,
            v,
            p: 0.5 * (gravity * (v[2] - v[0])).sqrt(),
            periods: Periods::new(m, m1),
            modulus: Modulus::from_m1(m1).expect("between 0 and 1"),
        }
    }

    fn gap(&self) -> f64 {
        self.v[1] - self.v[0]
    }

    /// (sn/cn)^2(eta | m1) of the zeros of alpha and of beta.
    fn squares(&self) -> [f64; 2] {
        let [v1, v2, v3] = self.v;
        [(1.0 + v1) / self.gap(), (1.0 - v2) * (v3 - v1) / (self.gap() * (v3 - 1.0))]
    }

    fn zeros(&self) -> [f64; 2] {
        self.squares().map(|square| {
            legendre::f(atan(square.sqrt()), self.modulus.complement()).expect("finite")
        })
    }

    fn senses(&self) -> [f64; 2] {
        [self.sum.signum(), self.difference.signum()]
    }

    /// H1(-i eta), and d arg H1(x - i eta)/dz at x = 0.
    fn at_zero(&self, eta: f64) -> [f64; 2] {
        let (q, y) = (self.periods.nome(), self.periods.angle(eta));
        let [mut even, mut odd] = [0.0; 2];
        for n in 0..14 {
            let half = f64::from(n) + 0.5;
            let weight = 2.0 * exp(half * half * log(q));
            even += weight * cosh(2.0 * half * y);
            odd += 2.0 * half * weight * sinh(2.0 * half * y);
        }
        [even, odd / even]
    }

    /// The rates of the phases of alpha and beta, without the free spin.
    fn rates(&self) -> [f64; 2] {
        let [v1, v2, _] = self.v;
        let [eta_a, eta_b] = self.zeros();
        let [sense_a, sense_b] = self.senses();
        let rate = self.p * self.periods.angle(1.0);
        [
            0.5 * self.sum / (1.0 + v2) - rate * sense_a * self.at_zero(eta_a)[1],
            0.5 * self.difference / (1.0 - v1) - rate * sense_b * self.at_zero(eta_b)[1],
        ]
    }

    /// alpha and beta at a time after the lower turning point, up to constant phases.
    fn cayley_klein(&self, t: f64) -> [C; 2] {
        let [v1, v2, _] = self.v;
        let (q, z) = (self.periods.nome(), self.periods.angle(self.p * t));
        let y = self.zeros().map(|eta| self.periods.angle(eta));
        let [sense_a, sense_b] = self.senses();
        let [size_a, size_b] = self.zeros().map(|eta| self.at_zero(eta)[0]);
        let [rate_a, rate_b] = self.rates();
        let (nil, below) = (C::new(0.0, 0.0), theta(4, C::new(z, 0.0), q));
        let a = theta(1, C::new(z, -sense_a * y[0]), q) / below
            * ((0.5 * (1.0 + v2)).sqrt() * theta(3, nil, q).re / size_a);
        let b = theta(2, C::new(z, -sense_b * y[1]), q) / below
            * ((0.5 * (1.0 - v1)).sqrt() * theta(4, nil, q).re / size_b);
        [
            a * turn((rate_a + 0.5 * self.free_spin) * t),
            b * turn((rate_b - 0.5 * self.free_spin) * t),
        ]
    }

    /// omega_1 + i omega_2 at a time after the lower turning point, up to the phase of
    /// conj(alpha) beta at the start.
    fn transverse(&self, t: f64, sense: f64, shift: f64) -> C {
        let [v1, v2, v3] = self.v;
        let [y_a, y_b] = self.zeros().map(|eta| self.periods.angle(eta));
        let [sense_a, sense_b] = self.senses();
        let (q, z) = (self.periods.nome(), self.periods.angle(self.p * t));
        let width = self.periods.angle(self.periods.conjugate);
        let y = sense_b * y_b - sense_a * y_a - sense * width + shift;
        let [rate_a, rate_b] = self.rates();
        let far = self.gravity * (v3 + 1.0);
        let start = (self.spin * (1.0 + v1).sqrt() * sense_a - (far * (1.0 + v2)).sqrt())
            / (1.0 - v1).sqrt();
        let wave = |z: f64| theta(2, C::new(z, -y), q) / theta(4, C::new(z, 0.0), q);
        wave(z) / wave(0.0) * turn(sense * z + (rate_b - rate_a - self.free_spin) * t) * start
    }

    fn motion(&self) -> HeavyTop {
        HeavyTop::from_energy(self.top, self.energy, Start::ThetaMax, 0.0, 0.0).expect("a motion")
    }
}

#[test]
fn roots_are_held_by_their_products() {
    // The cubic of beta (v3 - 1), and the products of the other roots.
    let residuals = |damage: f64| {
        let mut errors = Errors::of("the cubic of the outer root, and both products");
        for top in TOPS {
            let plain = Plain::new(top);
            let [_, _, v3] = plain.v;
            let (g, d, e) = (plain.gravity, plain.difference, plain.excess);
            let outer = g * (v3 - 1.0);
            let c1 = 2.0 * (e - d * plain.spin);
            let c2 = 2.0 * g - damage * e - plain.spin * plain.spin;
            let rest = (outer + c2) * outer * outer - c1 * g * outer - d * d * g * g;
            let scale = outer * outer * (outer + c2.abs()) + (c1 * g * outer).abs();
            errors.push_at(rest / scale, top);
            // 1 - v and 1 + v at the turning points of the library.
            let motion = plain.motion();
            let halves = [motion.theta_min(), motion.theta_max()].map(|theta| sincos(0.5 * theta));
            let [[x2, y2], [x1, y1]] = halves.map(|(s, c)| [2.0 * s * s, 2.0 * c * c]);
            let products =
                [(x1 * x2 * outer, d * d), (y1 * y2 * (outer + 2.0 * g), plain.sum * plain.sum)];
            for (product, want) in products {
                errors.push_at(product / want - damage, top);
            }
        }
        errors
    };
    assert_largest!(residuals(1.0), 6 * 3, @"2.02e-14");
    residuals(1.01).exceed(1e-6, 6 * 3);
}

#[test]
fn a_state_gives_its_turning_points() {
    // below and above, from F and F' at a state on the way.
    let errors = |damage: f64| {
        let mut errors = Errors::of("distances to the turning points");
        for top in TOPS {
            let plain = Plain::new(top);
            let [v1, v2, v3] = plain.v;
            let motion = plain.motion();
            for part in [0.2, 0.5, 0.9, 1.3] {
                let t = part * 0.5 * motion.nutation_period();
                let v = motion.cos_theta(t);
                let sine = (1.0 - v * v).sqrt();
                let [x, y] = [motion.theta_rate(t), motion.phi_rate(t) * sine];
                let slope = -2.0 * v * (x * x + y * y) - plain.gravity * sine * sine
                    + damage * 2.0 * plain.spin * y * sine;
                let far = plain.gravity * (v3 - v);
                let product = -(x * sine) * (x * sine) / far;
                let half = 0.5 * (slope - plain.gravity * product) / far;
                let root = (half * half - product).sqrt();
                errors.push_at(root + half - (v2 - v), (top, part));
                errors.push_at(root - half - (v - v1), (top, part));
            }
        }
        errors
    };
    assert_largest!(errors(1.0), 6 * 4 * 2, @"2.44e-15");
    errors(1.01).exceed(1e-6, 6 * 4 * 2);
}

#[test]
fn zeros_are_where_the_axis_is_vertical() {
    // v1 + gap sn^2 is -1 at i eta_a and 1 at K + i eta_b.
    let errors = |damage: f64| {
        let mut errors = Errors::of("v at the zeros, and sc^2 from the other side");
        for top in TOPS {
            let plain = Plain::new(top);
            let [eta_a, eta_b] = plain.zeros();
            let at = |u: C| {
                let sn = plain.periods.sn(u);
                sn * sn * plain.gap() + plain.v[0]
            };
            let below = at(C::new(0.0, eta_a * damage));
            let above = at(C::new(plain.periods.quarter, eta_b * damage));
            errors.push_at(size(below + 1.0), top);
            errors.push_at(size(above - 1.0), top);
            // K' - eta: the gap has gone.
            let [v1, v2, v3] = plain.v;
            let kappa = 1.0 / (v3 - v1);
            let others = [1.0 / (kappa * (1.0 + v1)), (v3 - 1.0) * kappa / (kappa * (1.0 - v2))];
            for (eta, square) in [eta_a, eta_b].into_iter().zip(others) {
                let rest = legendre::f(atan(square.sqrt()), plain.modulus.complement());
                let rest = rest.expect("finite");
                errors.push_at(eta * damage + rest - plain.periods.conjugate, top);
            }
        }
        errors
    };
    assert_largest!(errors(1.0), 6 * 4, @"1.34e-15");
    errors(1.001).exceed(1e-6, 6 * 4);
}

#[test]
fn quotients_are_the_attitude() {
    let errors = |damage: f64| {
        let mut turned = Errors::of("attitude by the quotients, in rad");
        let mut lengths = Errors::of("their squares, which add up to 1");
        for top in TOPS {
            let plain = Plain::new(top);
            let motion = plain.motion();
            let [alpha, beta] = plain.cayley_klein(0.0);
            let start = [alpha, beta].map(|value| value.conj() / size(value));
            for k in 1..20 {
                let t = 0.17 * f64::from(k) * motion.nutation_period();
                let [alpha, beta] = plain.cayley_klein(t);
                let wrong = turn(damage * t) * (1.0 + damage);
                let [alpha, beta] = [alpha * start[0], beta * start[1] * wrong];
                let quotients = Attitude::from_quaternion([alpha.re, beta.re, beta.im, alpha.im]);
                let angle = quotients.expect("finite").angle_to(&motion.attitude(t));
                turned.push_at(angle, (top, k));
                lengths.push_at(alpha.norm_sqr() + beta.norm_sqr() - 1.0, (top, k));
            }
        }
        (turned, lengths)
    };
    let (turned, lengths) = errors(0.0);
    assert_largest!(turned, 6 * 19, @"2.65e-14");
    assert_largest!(lengths, 6 * 19, @"8.88e-16");
    let (turned, lengths) = errors(1e-4);
    turned.exceed(1e-6, 6 * 19);
    lengths.exceed(1e-6, 6 * 19);
}

#[test]
fn transverse_rate_is_a_quotient() {
    let errors = |shift: f64| {
        let mut errors = Errors::of("transverse rate by its quotient");
        for top in TOPS {
            let plain = Plain::new(top);
            let motion = plain.motion();
            // The phase of conj(alpha) beta without the series, at the start.
            let [sense_a, _] = plain.senses();
            let start = turn(-core::f64::consts::FRAC_PI_2 * sense_a);
            for k in 1..20 {
                let t = 0.17 * f64::from(k) * motion.nutation_period();
                let omega = motion.angular_velocity(t);
                let want = C::new(omega.x(), omega.y());
                let got = [-1.0, 1.0].map(|sense| plain.transverse(t, sense, shift) * start);
                let off = size(got[0] - want) + size(got[1] - want);
                errors.push_at(off, (top, k));
            }
        }
        errors
    };
    assert_largest!(errors(0.0), 6 * 19, @"2.88e-14");
    errors(1e-3).exceed(1e-6, 6 * 19);
}

#[test]
fn advance_is_that_of_the_third_kind() {
    // The azimuth in a period: by the phase rates, and by Legendre's integrals.
    let errors = |damage: f64| {
        let mut errors = Errors::of("advance of phi in a period, in rad");
        for top in TOPS {
            let plain = Plain::new(top);
            let [v1, _, _] = plain.v;
            let n = [plain.gap() / (1.0 - v1), -plain.gap() / (1.0 + v1)];
            let [above, below] = n.map(|n| {
                let n = Characteristic::from_n(n).expect("finite");
                legendre::complete_pi(n, plain.modulus).expect("below 1")
            });
            let plainly =
                (plain.difference / (1.0 - v1) * above + plain.sum / (1.0 + v1) * below) / plain.p;
            let motion = plain.motion();
            let [rate_a, rate_b] = plain.rates();
            let [sense_a, sense_b] = plain.senses();
            let half_turns = core::f64::consts::PI * damage * (sense_a + sense_b);
            let by_rates = (rate_a + rate_b) * motion.nutation_period() + half_turns;
            errors.push_at(by_rates - plainly, top);
            errors.push_at(motion.precession_per_period() - damage * plainly, top);
        }
        errors
    };
    assert_largest!(errors(1.0), 6 * 2, @"3.91e-14");
    assert!(errors(1.01).largest() > 1e-2);
}

#[test]
fn the_other_nome_gives_the_same_quotients() {
    // H and H1 by theta_1 and theta_4 of y' + i w and q', within half a period, and the phase
    // that a half-period loses.
    let errors = |damage: f64| {
        let mut errors = Errors::of("ratios of both series");
        for top in TOPS {
            let plain = Plain::new(top);
            let Periods { quarter, conjugate } = plain.periods;
            let (q, other) = (plain.periods.nome(), plain.periods.other_nome());
            for eta in plain.zeros() {
                let (y, lost) = (plain.periods.angle(eta), 0.5 * eta / conjugate);
                let lost = core::f64::consts::PI * lost * damage;
                let along = C::new(lost, 0.0);
                for k in 1..=4 {
                    let x = 0.25 * f64::from(k) * quarter;
                    let w = core::f64::consts::FRAC_PI_2 * x / conjugate;
                    let z = plain.periods.angle(x);
                    let forms = [
                        theta(2, C::new(z, -y), q) / theta(2, C::new(0.0, -y), q),
                        theta(4, along + C::new(0.0, w), other) / theta(4, along, other),
                    ];
                    // e^{-z z' ...}, real, is common; of the phase 2 z y'/pi is left out.
                    let phase = turn(z / core::f64::consts::FRAC_PI_2 * lost);
                    let ratio = forms[0] * phase.conj() / forms[1];
                    errors.push_at(ratio.im / size(ratio), (top, k));
                    let h = theta(1, C::new(z, -y), q);
                    let h1 = theta(2, C::new(z, -y), q);
                    let (one, four) = (
                        theta(1, along + C::new(0.0, w), other),
                        theta(4, along + C::new(0.0, w), other),
                    );
                    let quotient = (h / h1) / (one / four);
                    errors.push_at(size(quotient + C::new(0.0, 1.0)), (top, k));
                }
            }
        }
        errors
    };
    assert_largest!(errors(1.0), 6 * 2 * 4 * 2, @"2.55e-15");
    assert!(errors(1.01).largest() > 1e-3);
}

#[test]
fn the_transverse_rate_in_the_other_nome() {
    // theta_3 of y'_b - y'_a + i w around the lower turning point and theta_2 around the upper
    // one are what theta_2(z - i y) e^{+-iz} is there, once the phases of alpha and beta have
    // taken what is linear in the time: whichever sign, and with one factor for both.
    let errors = |damage: f64| {
        let mut errors = Errors::of("ratios of the rate's series");
        for top in TOPS {
            let plain = Plain::new(top);
            let Periods { quarter, conjugate } = plain.periods;
            let (q, other) = (plain.periods.nome(), plain.periods.other_nome());
            let ([sense_a, sense_b], [eta_a, eta_b]) = (plain.senses(), plain.zeros());
            let eta = sense_b * eta_b - sense_a * eta_a;
            let along = core::f64::consts::FRAC_PI_2 * eta / conjugate * damage;
            for sense in [1.0, -1.0] {
                let y = plain.periods.angle(eta - sense * conjugate);
                let ratios = |x: f64| {
                    let z = plain.periods.angle(x);
                    let place = C::new(along, core::f64::consts::FRAC_PI_2 * x / conjugate);
                    let phase = turn(sense * z - z / core::f64::consts::FRAC_PI_2 * along);
                    let lower = theta(2, C::new(z, -y), q) * phase;
                    let upper = theta(1, C::new(z, -y), q) * phase * C::new(0.0, -sense);
                    [lower / theta(3, place, other), upper / theta(2, place, other)]
                };
                let [unit, _] = ratios(0.0);
                for k in 0..=4 {
                    let [lower, upper] = ratios(0.25 * f64::from(k) * quarter);
                    errors.push_at((lower / unit).im / size(lower / unit), (top, k));
                    errors.push_at(size(upper / lower - C::new(1.0, 0.0)), (top, k));
                }
            }
        }
        errors
    };
    assert_largest!(errors(1.0), 6 * 2 * 5 * 2, @"1.35e-15");
    assert!(errors(1.01).largest() > 1e-3);
}

#[test]
fn four_terms_are_enough() {
    // The nomes where the series change, and the weights of the terms beside the first.
    let periods = Periods::new(0.8, 0.2);
    let (q, other) = (periods.nome(), periods.other_nome());
    assert!(q < 0.1 && q > 0.099 && other < 1.0 / 70.0, "{q} {other}");
    let mut over = Errors::of("weight over q^(n^2), at most 1");
    for part in [0.1, 0.5, 1.0] {
        // y up to that of K'.
        let y = part * periods.angle(periods.conjugate);
        for n in 1..=5 {
            let order = f64::from(n);
            let weight = exp(order * (order + 1.0) * log(q)) * cosh((2.0 * order + 1.0) * y);
            over.push_at(weight / cosh(y) / exp(order * order * log(q)), (part, n));
        }
    }
    assert_largest!(over, 15, @"0.911");
    let fifth = exp(16.0 * log(q));
    assert!(fifth < 1e-16 && exp(9.0 * log(q)) > 1e-10);
}
