//! The truth where doubles are not enough: Taylor series of order 36 in pairs of doubles.
//!
//! Euler's equations on the body's axes, with or without a weight on the third, and the
//! quaternion that they turn. Every term is a product of two unknowns, so a coefficient of the
//! series is a sum of products of those before it; no angle, no elliptic function and no method of
//! the library has a part in it. Of 32 digits a run of a hundred radians leaves about 28.

use super::*;
use rotation_dynamics::math::DoubleDouble as Dd;

const ORDER: usize = 36;
/// The last coefficients of a series leave at most this of the sum.
const LEFT: f64 = 1e-32;

/// The coefficients of a series in the time.
type Series = [Dd; ORDER + 1];
type Quaternion = [Dd; 4];

/// A moving body, in units of time in which it turns by about a radian.
#[derive(Clone, Copy)]
pub struct Truth {
    moments: [f64; 3],
    /// Weight times lever, in these units.
    pull: Dd,
    /// How many of these units a second has: a power of two.
    per_second: f64,
    /// Quaternion, rates, and the vertical on the body's axes.
    now: [Dd; 10],
}

impl Truth {
    /// The start of a motion. A motion that is `given` by its angular momentum in space has the
    /// rates I^-1 R^T L, to all digits.
    pub fn new(motion: &Motion, from: Attitude, given: Option<SpaceVector>) -> Self {
        let [weight, lever] = motion.gravity.unwrap_or([0.0; 2]);
        let [i1, i2, i3] = motion.moments;
        let pulled = (weight * lever.abs() / i1.min(i2).min(i3)).sqrt();
        let fastest = motion.rates.iter().fold(pulled, |m, w| m.max(w.abs()));
        let per_second = power_of_two(fastest);
        let unit = 1.0 / per_second;

        let q = from.quaternion().map(Dd::from);
        let length = q.iter().fold(Dd::ZERO, |sum, c| sum + c.square()).sqrt();
        let quaternion = q.map(|c| c / length);
        let [p, q, r] = given.map_or(motion.rates.map(|w| Dd::from(w / per_second)), |momentum| {
            let [x, y, z] = momentum.to_array().map(Dd::from);
            let turned = product(conjugate(quaternion), [Dd::ZERO, x, y, z]);
            let [_, x, y, z] = product(turned, quaternion);
            [x / i1, y / i2, z / i3].map(|rate| rate.scaled(unit))
        });
        let [w, x, y, z] = quaternion;
        let [g1, g2] = [(x * z - w * y) * 2.0, (y * z + w * x) * 2.0];
        let g3 = w.square() + z.square() - x.square() - y.square();
        Self {
            moments: motion.moments,
            pull: Dd::product(weight, lever).scaled(unit).scaled(unit),
            per_second,
            now: [w, x, y, z, p, q, r, g1, g2, g3],
        }
    }

    /// The same after `t` (s).
    pub fn after(mut self, t: Dd) -> Self {
        let mut left = t.scaled(self.per_second);
        while left != 0.0 {
            let series = self.series();
            // The longest step that the last coefficients allow.
            let reach = [ORDER - 1, ORDER].map(|n| {
                let largest = series.iter().fold(1e-300, |m: f64, s| m.max(s[n].hi().abs()));
                pow(LEFT / largest, 1.0 / n as f64)
            });
            let step = match reach[0].min(reach[1]) {
                step if left.abs() <= step => left,
                step => Dd::from(step.copysign(left.to_f64())),
            };
            self.now = series.map(|s| s.iter().rev().fold(Dd::ZERO, |sum, c| sum * step + *c));
            left -= step;
        }
        self
    }

    /// The attitude at a late time of a free body whose rates have about this period (s): the
    /// rotation of one period, taken to a power.
    pub fn late(self, period: f64, t: f64) -> Solved<Attitude> {
        let once = self.after(Dd::from(period));
        // The period to all digits, by a step of Newton's method along the path.
        let series = self.series();
        let (mut along, mut square) = (Dd::ZERO, Dd::ZERO);
        for i in [4, 5, 6] {
            let slope = series[i][1];
            along += (once.now[i] - self.now[i]) * slope;
            square += slope.square();
        }
        let period = Dd::from(period) - (along / square).scaled(1.0 / self.per_second);
        let once = self.after(period);
        let mut turn = product(once.quaternion(), conjugate(self.quaternion()));
        let count = (Dd::from(t) / period).round();
        let mut end = self.after(Dd::from(t) - period * count).quaternion();
        let mut left = count as u64;
        while left > 0 {
            if left % 2 == 1 {
                end = product(turn, end);
            }
            (turn, left) = (product(turn, turn), left / 2);
        }
        Attitude::from_quaternion(end.map(Dd::to_f64))
    }

    /// The series from here: each slope is a sum of factors times products of two.
    fn series(&self) -> [Series; 10] {
        let ([i1, i2, i3], half, one) = (self.moments, Dd::from(0.5), Dd::from(1.0));
        let euler = |a: f64, b: f64, over: f64| Dd::sum(a, -b) / over;
        let [w, x, y, z, p, q, r, g1, g2, g3] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9];
        #[rustfmt::skip]
        let terms = [
            (w, -half, x, p), (w, -half, y, q), (w, -half, z, r), (x, half, w, p), (x, half, y, r), (x, -half, z, q),
            (y, half, w, q), (y, half, z, p), (y, -half, x, r), (z, half, w, r), (z, half, x, q), (z, -half, y, p),
            (p, euler(i2, i3, i1), q, r), (q, euler(i3, i1, i2), r, p), (r, euler(i1, i2, i3), p, q),
            (g1, one, g2, r), (g1, -one, g3, q), (g2, one, g3, p), (g2, -one, g1, r), (g3, one, g1, q), (g3, -one, g2, p),
        ];
        let mut all = self.now.map(|first| {
            let mut series = [Dd::ZERO; ORDER + 1];
            series[0] = first;
            series
        });
        for n in 0..ORDER {
            // Side by side: a sum waits for its own last term, and not for the others.
            let mut sums = [Dd::ZERO; 21];
            for k in 0..=n {
                for (sum, (_, _, a, b)) in sums.iter_mut().zip(&terms) {
                    *sum += all[*a][k] * all[*b][n - k];
                }
            }
            let mut slopes = [Dd::ZERO; 10];
            for (sum, (of, factor, ..)) in sums.into_iter().zip(terms) {
                slopes[of] += sum * factor;
            }
            slopes[p] += all[g2][n] * (self.pull / i1);
            slopes[q] += all[g1][n] * (self.pull / -i2);
            for (series, slope) in all.iter_mut().zip(slopes) {
                series[n + 1] = slope / (n + 1) as f64;
            }
        }
        all
    }

    fn quaternion(&self) -> Quaternion {
        let [w, x, y, z, ..] = self.now;
        [w, x, y, z]
    }

    /// The attitude, rounded once.
    pub fn attitude(&self) -> Solved<Attitude> {
        Attitude::from_quaternion(self.quaternion().map(Dd::to_f64))
    }

    /// The rates on the body's axes, in the units of the truth.
    pub fn rates(&self) -> [f64; 3] {
        [4, 5, 6].map(|i| self.now[i].to_f64())
    }
}

/// The power of two just below a number, the least normal one at least; 1 for 0.
fn power_of_two(x: f64) -> f64 {
    if x == 0.0 {
        return 1.0;
    }
    f64::from_bits(x.to_bits() & (0x7ff << 52)).max(f64::MIN_POSITIVE)
}

fn conjugate([w, x, y, z]: Quaternion) -> Quaternion {
    [w, -x, -y, -z]
}

fn product([w, x, y, z]: Quaternion, [a, b, c, d]: Quaternion) -> Quaternion {
    [
        w * a - x * b - y * c - z * d,
        w * b + x * a + y * d - z * c,
        w * c + y * a + z * b - x * d,
        w * d + z * a + x * c - y * b,
    ]
}
