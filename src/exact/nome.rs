//! The nome of an elliptic function and, by it, arguments from values, in double-double arithmetic,
//! as the set-ups of the closed forms need them.
//!
//! An integral of the first kind by duplication takes up to eight rounds of three square
//! roots each. Here `f64` finds the argument, and one Newton step on the theta functions, whose
//! series has three or four terms that count, doubles its digits.
//!
//! Not for: single values ([`super::legendre`] has F, rounded once), m above 4/5 (give
//! the complement: its nome is the small one).
//!
//! Derived in `book/src/how_double_double.md`.
//!
//! Sources: DLMF 20.2, 22.2; the nome from the modulus, OEIS A002103.

use crate::math::lane::{Phased, Two};
use crate::math::{DoubleDouble as Dd, Exact, exp, expm1, ilogb, ldexp};

/// A parameter m <= 4/5, its nome q < 0.1 and its quarter period.
#[derive(Debug, Clone)]
pub(crate) struct Nome {
    /// m and 1 - m.
    pub(crate) m: Dd,
    pub(crate) m1: Dd,
    /// sqrt(1 - m), and its square root.
    pub(crate) k1: Dd,
    pub(crate) root_k1: Dd,
    /// K.
    pub(crate) quarter: Dd,
    /// q, q^2, q^4, q^6 and q^9.
    pub(crate) q: Dd,
    q2: Dd,
    pub(crate) q4: Dd,
    q6: Dd,
    pub(crate) q9: Dd,
    /// q^16 and q^20.
    pub(crate) q16: f64,
    q20: f64,
    /// 2K/pi.
    per_angle: Dd,
}

/// An argument u, 0 <= u <= K, as z = pi u/2K.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Angle {
    pub(crate) z: Dd,
    pub(crate) sin: Dd,
    pub(crate) cos: Dd,
}

impl Angle {
    /// That of K - u.
    pub(crate) fn complement(self) -> Self {
        Self { z: Dd::FRAC_PI_2 - self.z, sin: self.cos, cos: self.sin }
    }
}

/// An argument i u off the real axis, by y = pi u/2K.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Depth<L = f64> {
    /// e^{-2y}, and its difference to 1.
    pub(crate) decay: Dd<L>,
    pub(crate) fall: Dd<L>,
}

/// A depth near the one with sc^2 = `num`/`den`.
struct Near<L = f64> {
    num: Dd<L>,
    den: Dd<L>,
    depth: Depth<L>,
}

impl Depth {
    /// y.
    pub(crate) fn y(&self) -> Dd {
        -if self.fall < 0.25 { (-self.fall).ln_1p() } else { self.decay.ln() }.scaled(0.5)
    }
}

impl Nome {
    /// The nome of `m`, at most 4/5 and exactly 1 - `m1`.
    pub(crate) fn new(m: Dd, m1: Dd) -> Self {
        let k1 = m1.sqrt();
        let root_k1 = k1.sqrt();
        let below = (root_k1 + 1.0).square();
        let spread = below.recip();
        // (1 - sqrt k')/(2 (1 + sqrt k')), without the difference.
        let lambda = m / (below * (k1 + 1.0).scaled(2.0));
        let q = lambda * series(lambda.square().square());
        let q2 = q.square();
        let q4 = q2.square();
        let (q6, q8) = (q4 * q2, q4.square());
        let (q9, q16) = (q8 * q, q8.hi() * q8.hi());
        // theta_3(q) (1 + sqrt k') = 2 theta_3(q^4).
        let outer = q4.scaled(2.0) + 1.0 + 2.0 * q16;
        let per_angle = (outer.square() * spread).scaled(4.0);
        Self {
            m,
            m1,
            k1,
            root_k1,
            quarter: Dd::FRAC_PI_2 * per_angle,
            q,
            q2,
            q4,
            q6,
            q9,
            q16,
            q20: q16 * q4.hi(),
            per_angle,
        }
    }

    /// K', the quarter period of 1 - m; infinite for m = 0.
    pub(crate) fn conjugate(&self) -> Dd {
        if self.q == 0.0 {
            Dd::from(f64::INFINITY)
        } else {
            -(self.per_angle * self.q.ln()).scaled(0.5)
        }
    }

    /// The argument u for this z or y.
    pub(crate) fn argument(&self, angle: Dd) -> Dd {
        angle * self.per_angle
    }

    /// The argument with sc^2(u | m) = `num`/`den`, best for u <= K/2.
    pub(crate) fn angle(&self, num: Dd, den: Dd) -> Angle {
        if num == 0.0 {
            return Angle { z: Dd::ZERO, sin: Dd::ZERO, cos: Dd::ONE };
        }
        let (num, den) = common_scale(num, den);
        if num.hi() < LINEAR * den.hi() {
            let z = small_root(num, den) / self.per_angle;
            let (sin, cos) = (z, Dd::ONE);
            return Angle { z, sin, cos };
        }
        let u = first_kind(num.hi(), den.hi(), self.m1.hi());
        let z = (u / self.per_angle.hi()).min(core::f64::consts::FRAC_PI_2);
        let (sin, cos) = Dd::from(z).sin_cos();
        let x = sin.square();
        let (n, d) = (self.odd(x), self.even(x));
        // sc^2 = tan^2 z (n/d)^2/k'.
        let (want, have) = (num * self.k1 * (cos * d).square(), den * (sin * n).square());
        let step = self.step((want, have), (num, den), self.m1.hi());
        Angle { z: Dd::sum(z, step), sin: sin + cos * step, cos: cos - sin * step }
    }

    /// The argument with sc^2(u | 1 - m) = `num`/`den`, best for u <= K'/2.
    pub(crate) fn depth(&self, num: Dd, den: Dd) -> Depth {
        match self.near(num, den) {
            Ok(near) => self.stepped(&near),
            Err(limit) => limit,
        }
    }

    /// Two of them, side by side where both have to be computed.
    pub(crate) fn depths(&self, [first, second]: [(Dd, Dd); 2]) -> [Depth; 2] {
        let (first, second) = match (self.near(first.0, first.1), self.near(second.0, second.1)) {
            (Ok(first), Ok(second)) => (first, second),
            (first, second) => {
                return [first, second]
                    .map(|one| one.map_or_else(|limit| limit, |near| self.stepped(&near)));
            }
        };
        let Depth { decay, fall } = self.stepped(&Near::<Two> {
            num: Dd::both([first.num, second.num]),
            den: Dd::both([first.den, second.den]),
            depth: Depth {
                decay: Dd::both([first.depth.decay, second.depth.decay]),
                fall: Dd::both([first.depth.fall, second.depth.fall]),
            },
        });
        let (decays, falls) = (decay.parts(), fall.parts());
        [0, 1].map(|i| Depth { decay: decays[i], fall: falls[i] })
    }

    /// The depth to the digits of `f64`, or a limit in which it is known.
    fn near(&self, num: Dd, den: Dd) -> Result<Near, Depth> {
        if num == 0.0 {
            return Err(Depth { decay: Dd::ONE, fall: Dd::ZERO });
        }
        if den == 0.0 {
            return Err(Depth { decay: Dd::ZERO, fall: Dd::ONE });
        }
        let (num, den) = common_scale(num, den);
        if num.hi() < LINEAR * den.hi() {
            let y = small_root(num, den) / self.per_angle;
            return Err(Depth { decay: Dd::ONE, fall: y.scaled(2.0) });
        }
        let u = first_kind(num.hi(), den.hi(), self.m.hi());
        // The smaller of the two starts as a double, and the other is exactly what it lacks of 1.
        let twice = 2.0 * u / self.per_angle.hi();
        let (decay, fall) = if twice < core::f64::consts::LN_2 {
            let fall = -expm1(-twice);
            (Dd::sum(1.0, -fall), Dd::from(fall))
        } else {
            let decay = exp(-twice);
            (Dd::from(decay), Dd::sum(1.0, -decay))
        };
        let depth = Depth { decay, fall };
        Ok(Near { num, den, depth })
    }

    /// With the digits doubled by a step of Newton's.
    fn stepped<L: Exact + Phased>(&self, near: &Near<L>) -> Depth<L> {
        let Near { num, den, depth } = *near;
        let Depth { decay, fall } = depth;
        let per_angle = Dd::same(self.per_angle);
        // sinh^2 y = (1 - e^{-2y})^2/4e^{-2y}; the common 4e^{-2y} stays on the left.
        let below = decay.scaled(4.0);
        let sides = if self.q.hi() < VANISHING {
            // Up to y = pi K'/4K the series are 1, whatever powers sinh^2 y has.
            (num * below, den * per_angle * fall.square())
        } else {
            let sinh2 = fall.square() / below;
            let theta2 = Dd::same(self.theta2());
            (
                num * below * (self.theta4(sinh2) * theta2).square(),
                den * per_angle * (fall * self.odd(-sinh2)).square(),
            )
        };
        let step = self.step(sides, (num, den), self.m.hi());
        // Of e^{-2y} what the step takes, to its second power: far from the axis it is large.
        let change = decay.times(step * 2.0 * (-step + 1.0));
        Depth { decay: decay - change, fall: fall + change }
    }

    /// Newton's step in z or y for sc^2 = num/den, where `want`/`have` should be 1; m is
    /// `m1` less than 1.
    fn step<L: Exact>(
        &self,
        (want, have): (Dd<L>, Dd<L>),
        (num, den): (Dd<L>, Dd<L>),
        m1: f64,
    ) -> L {
        let (num, den) = (num.hi(), den.hi());
        // d ln sc^2/du = 2 dn/(sn cn).
        let slope = (((den + num * m1) / den) * ((den + num) / num)).sqrt() * 2.0;
        // So near to each other that the difference is exact.
        let off = ((want.hi() - have.hi()) + (want.lo() - have.lo())) / have.hi();
        // ln(1 + off)
        off * (off * -0.5 + 1.0) / (slope * self.per_angle.hi())
    }

    /// theta_1(z)/2q^(1/4) sin z by x = sin^2 z: a rate depends on the depths that it gives, and
    /// is known after 10^12 periods only if the term with q^12 is a pair.
    fn odd<L: Exact>(&self, x: Dd<L>) -> Dd<L> {
        let h = x.hi();
        let ninth = h * (h * (h * (h * 256.0 - 576.0) + 432.0) - 120.0) + 9.0;
        // Of a depth q^30 is worth q^27.
        let eleventh = h * (h * (h * (-(h * 1024.0) + 2816.0) - 2816.0) + 1232.0) - 220.0;
        let q10 = self.q4.hi() * self.q6.hi();
        let tail = (ninth - (h * eleventh + 11.0) * q10) * self.q20;
        let (q2, q6) = (Dd::same(self.q2), Dd::same(self.q6));
        let third = 3.0 - x.scaled(4.0);
        let fifth = (x.scaled(16.0) - 20.0) * x + 5.0;
        let seventh = (third - 1.0) * fifth - third;
        Dd::same(Dd::ONE)
            .corrected(-(q2 * third))
            .corrected(q6 * fifth)
            .corrected((q6.square() * -seventh).plus(tail))
    }

    /// theta_2(z)/2q^(1/4) cos z by x = sin^2 z.
    fn even(&self, x: Dd) -> Dd {
        let (h, q6) = (x.hi(), self.q6.hi());
        let tail = self.q20 * (1.0 + h * (h * (240.0 + h * (h * 256.0 - 448.0)) - 40.0))
            + q6 * q6 * (1.0 + h * (h * (80.0 - h * 64.0) - 24.0));
        let fifth = (x.scaled(16.0) - 12.0) * x + 1.0;
        Dd::ONE.corrected(self.q2 * (1.0 - x.scaled(4.0))).corrected(self.q6 * fifth + tail)
    }

    /// theta_4(iy) by sinh^2 y.
    fn theta4<L: Exact>(&self, sinh2: Dd<L>) -> Dd<L> {
        let [q, q4, q9] = [self.q, self.q4, self.q9].map(Dd::same);
        let c1 = sinh2.scaled(2.0) + 1.0;
        let c2 = c1.square().scaled(2.0) - 1.0;
        let c3 = c1 * (c2.scaled(2.0) - 1.0);
        let h = c2.hi();
        let c4 = h * 2.0 * h - 1.0;
        let c5 = c1.hi() * (c4 * 2.0 - h * 2.0 + 1.0);
        let tail = (c4 - c5 * self.q9.hi()) * self.q16;
        let terms = [-(q * c1), q4 * c2, (q9 * -c3).plus(tail)];
        terms.into_iter().fold(Dd::same(Dd::ONE), |sum, term| sum.corrected(term.scaled(2.0)))
    }

    /// theta_3(0).
    pub(crate) fn theta3(&self) -> Dd {
        [self.q, self.q4, self.q9 + self.q16]
            .into_iter()
            .fold(Dd::ONE, |sum, term| sum.corrected(term.scaled(2.0)))
    }

    /// theta_2(0)/2q^(1/4).
    pub(crate) fn theta2(&self) -> Dd {
        [self.q2, self.q6, self.q6.square() + self.q20].into_iter().fold(Dd::ONE, Dd::corrected)
    }
}

/// A nome whose square root is beyond double-double.
const VANISHING: f64 = 1e-66;

/// A quotient sc^2 that is u^2 to 106 bits, and whose products would leave the range.
const LINEAR: f64 = 1e-220;

/// sqrt(num/den) of a quotient below [`LINEAR`], whose square root is in range.
fn small_root(num: Dd, den: Dd) -> Dd {
    const UP: f64 = 1.606_938_044_258_990_3e60; // 2^200
    (num.scaled(UP).scaled(UP) / den).sqrt().scaled(1.0 / UP)
}

/// Both times a power of two that brings the larger near 1: products stay in range.
fn common_scale(num: Dd, den: Dd) -> (Dd, Dd) {
    let largest = num.hi().max(den.hi());
    if largest.is_normal() {
        let scale = ldexp(1.0, -ilogb(largest));
        (num.scaled(scale), den.scaled(scale))
    } else if largest > 0.0 && largest.is_finite() {
        // In two steps: the inverse of the smallest number is none.
        let exponent = ilogb(largest);
        let (first, rest) = (-(exponent / 2), exponent / 2 - exponent);
        let scaled = |x: Dd| x.scaled(ldexp(1.0, first)).scaled(ldexp(1.0, rest));
        (scaled(num), scaled(den))
    } else {
        (num, den)
    }
}

/// F with sc^2 = num/den and complementary parameter m1, in plain `f64`: within a few eps.
fn first_kind(num: f64, den: f64, m1: f64) -> f64 {
    let (mut x, mut y, mut z) = (den, den + m1 * num, den + num);
    let mut mean = (x + y + z) / 3.0;
    // The deviations fall by 4 a round; the series to their fifth power leaves 4e-17.
    while (mean - x).max(z - mean) > 2.5e-3 * mean {
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let shift = rx * (ry + rz) + ry * rz;
        x = (x + shift) * 0.25;
        y = (y + shift) * 0.25;
        z = (z + shift) * 0.25;
        mean = (mean + shift) * 0.25;
    }
    let (dx, dy) = ((mean - x) / mean, (mean - y) / mean);
    let dz = -(dx + dy);
    let (e2, e3) = (dx * dy - dz * dz, dx * dy * dz);
    let series = e3 / 14.0 + e2 * (e2 / 24.0 - 0.1 - e3 * (3.0 / 44.0));
    (num / mean).sqrt() * (1.0 + series)
}

/// q = lambda sum a_n lambda^(4n), lambda = (1 - sqrt k')/(2 (1 + sqrt k')).
const SERIES: [f64; 12] = [
    1.0,
    2.0,
    15.0,
    150.0,
    1707.0,
    20_910.0,
    268_616.0,
    3_567_400.0,
    48_555_069.0,
    673_458_874.0,
    9_481_557_398.0,
    135_119_529_972.0,
];

/// The sum, by x = lambda^4 < 1e-4: two terms at a time, since one after the other would wait.
fn series(x: Dd) -> Dd {
    let small = SERIES[6..].iter().rev().fold(0.0, |sum, c| sum * x.hi() + c);
    let two = |n: usize, next: Dd| Dd::from(SERIES[n]).corrected(x * next);
    let [first, second] = [0, 2].map(|n| two(n, Dd::from(SERIES[n + 1])));
    let third = two(4, Dd::sum(SERIES[5], x.hi() * small));
    let square = x.square();
    first.corrected(square * second.corrected(square * third))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::extended::carlson_rf;
    use support::{Errors, assert_largest};

    /// Relative differences are counted in units of 2^-106.
    const UNIT: f64 = 1.232_595_164_407_831e-32;

    /// K as a function of the complementary parameter m1 = 1 - m, pi/2 over the
    /// arithmetic-geometric mean of 1 and sqrt(m1); infinite at m1 = 0.
    fn complete_first_kind(m1: Dd) -> Dd {
        if m1 <= 0.0 {
            return Dd::from(f64::INFINITY);
        }
        let (mut a, mut b) = (Dd::ONE, m1.sqrt());
        // The difference squares in each step; below 2^-54 of a, one more mean is exact.
        while (a - b).abs().to_f64() > 1e-17 * a.to_f64() {
            (a, b) = ((a + b).scaled(0.5), (a * b).sqrt());
        }
        Dd::FRAC_PI_2 / (a + b).scaled(0.5)
    }

    fn off(got: Dd, want: Dd) -> f64 {
        ((got - want) / want).hi()
    }

    fn parameters() -> impl Iterator<Item = (Dd, Dd)> {
        [1e-120, 1e-30, 1e-9, 1e-3, 0.06, 0.3, 0.5, 0.65, 0.8]
            .into_iter()
            .map(|m| (Dd::from(m), 1.0 - Dd::from(m)))
    }

    /// The differences of K and K' over all parameters; `damage` is relative, of m.
    fn of_quarter_periods(damage: f64) -> Errors {
        let mut errors = Errors::in_units_of(UNIT, "quarter periods");
        for (m, m1) in parameters() {
            let nome = Nome::new(m * Dd::sum(1.0, damage), m1);
            errors.push(off(nome.conjugate(), complete_first_kind(m)));
            errors.push(off(nome.quarter, complete_first_kind(m1)));
        }
        errors
    }

    #[test]
    fn quarter_periods_agree_with_the_mean() {
        assert_largest!(of_quarter_periods(0.0), 2 * 9, @"2.33");
        assert!(of_quarter_periods(1e-28).largest() > 1e3);
    }

    /// The differences of angles, and of depths, with their functions over parameters up to `most`;
    /// `damage` is relative, of sc^2.
    fn of_arguments(most: f64, damage: f64) -> [Errors; 2] {
        let [mut angles, mut depths] =
            ["angles", "depths"].map(|what| Errors::in_units_of(UNIT, what));
        for (m, m1) in parameters().filter(|(m, _)| *m <= most) {
            let nome = Nome::new(m, m1);
            for part in [1e-200, 1e-40, 1e-8, 0.01, 0.3, 0.7, 1.0] {
                // sc^2 at K/2 is 1/k'.
                let (num, den) = (Dd::from(part), m1.sqrt());
                let want = num.sqrt() * carlson_rf(den, den + m1 * num, den + num);
                let angle = nome.angle(num * Dd::sum(1.0, damage), den);
                let (sin, cos) = angle.z.sin_cos();
                angles.push(off(nome.argument(angle.z), want));
                angles.push(off(angle.sin, sin));
                angles.push(off(angle.cos, cos));
                let (num, den) = (Dd::from(part), m.sqrt());
                let want = num.sqrt() * carlson_rf(den, den + m * num, den + num);
                let depth = nome.depth(num * Dd::sum(1.0, damage), den);
                let fall = -(depth.y().scaled(-2.0)).exp_m1();
                let decay = (depth.y().scaled(-2.0)).exp();
                depths.push(off(nome.argument(depth.y()), want));
                depths.push(off(depth.fall, fall));
                depths.push(off(depth.decay, decay) / (1.0 + depth.y().hi()));
            }
        }
        [angles, depths]
    }

    #[test]
    fn arguments_agree_with_duplication() {
        let [angles, depths] = of_arguments(0.5, 0.0);
        assert_largest!(angles, 3 * 49, @"6.74");
        assert_largest!(depths, 3 * 49, @"9.23");
        let [angles, depths] = of_arguments(0.8, 0.0);
        // The term of theta_2 with q^12, formed in `f64`, weighs 1e-12 there: 4.9e-28. An angle
        // is a time from a turning point, and does not grow.
        assert_largest!(angles, 3 * 63, @"3.99e4");
        assert_largest!(depths, 3 * 63, @"174");
        for damaged in of_arguments(0.5, 1e-27) {
            assert!(damaged.largest() > 1e4);
        }
    }
}
