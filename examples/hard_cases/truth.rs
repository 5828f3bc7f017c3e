//! The truth where doubles are not enough: Taylor series of order 36 in pairs of doubles.
//!
//! Euler's equations on the body's axes, with or without a weight on the third, and the
//! quaternion that they turn. Every product is quadratic, so a coefficient of the series is a
//! sum of products of those before it; no angle, no elliptic function and no method of the
//! library has a part in it. Of 32 digits a run of a hundred radians leaves about 28.

use super::*;
use rotation_dynamics::math::DoubleDouble as Dd;

const ORDER: usize = 36;

/// What the last coefficients of a series may leave of the sum.
const LEFT: f64 = 1e-32;

/// The coefficients of a series in the time.
type Series = [Dd; ORDER + 1];

/// Where the rates stand in a place.
const RATES: [usize; 3] = [4, 5, 6];

/// A body, with a weight on its third axis or none, in units of time in which it turns by
/// about a radian.
pub struct Truth {
    moments: [f64; 3],
    /// Weight times lever, in these units.
    pull: Dd,
    /// How many of these units a second has: a power of two.
    per_second: f64,
}

/// Quaternion, rates and vertical on the body's axes.
#[derive(Clone, Copy)]
pub struct Place([Dd; 10]);

impl Truth {
    /// For a motion of these moments (kg m^2), weight (N) and lever (m) that begins with these
    /// rates (rad/s).
    pub fn new(moments: [f64; 3], [weight, lever]: [f64; 2], rates: [f64; 3]) -> Self {
        let least = moments.iter().copied().fold(f64::INFINITY, f64::min);
        let pulled = (weight * lever.abs() / least).sqrt();
        let per_second = power_of_two(rates.iter().fold(pulled, |m, w| m.max(w.abs())));
        let pull = Dd::product(weight, lever).scaled(1.0 / per_second);
        let pull = pull.scaled(1.0 / per_second);
        Self { moments, pull, per_second }
    }

    /// A start.
    pub fn place(&self, attitude: Attitude, rates: [f64; 3]) -> Place {
        let rates = rates.map(|r| Dd::from(r / self.per_second));
        Self::placed(attitude, |_| rates)
    }

    fn placed(attitude: Attitude, rates: impl Fn([Dd; 4]) -> [Dd; 3]) -> Place {
        let q = attitude.quaternion().map(Dd::from);
        let length = q.iter().fold(Dd::ZERO, |sum, c| sum + c.square()).sqrt();
        let [w, x, y, z] = q.map(|c| c / length);
        let ([p, q, r], g1) = (rates([w, x, y, z]), (x * z - w * y) * 2.0);
        let g3 = w.square() + z.square() - x.square() - y.square();
        Place([w, x, y, z, p, q, r, g1, (y * z + w * x) * 2.0, g3])
    }

    /// A start given by its angular momentum in space: I^-1 R^T L to all digits.
    pub fn place_of(&self, state: &State) -> Place {
        let [lx, ly, lz] = state.angular_momentum.to_array().map(Dd::from);
        let [i1, i2, i3] = self.moments;
        Self::placed(state.attitude, |q| {
            let [_, x, y, z] = product(product(conjugate(q), [Dd::ZERO, lx, ly, lz]), q);
            [x / i1, y / i2, z / i3].map(|rate| rate.scaled(1.0 / self.per_second))
        })
    }

    /// Where it is after `t` (s).
    pub fn after(&self, place: &Place, t: Dd) -> Place {
        let mut left = t.scaled(self.per_second);
        let mut now = *place;
        while left != 0.0 {
            let series = self.series(&now);
            let step = match reach(&series) {
                step if left.abs() <= step => left,
                step => Dd::from(step.copysign(left.to_f64())),
            };
            now = sum(&series, step);
            left -= step;
        }
        now
    }

    /// The attitude at a late time of a free body whose rates have about this period (s): the
    /// rotation of one period, taken to a power.
    pub fn late(&self, start: &Place, period: f64, t: f64) -> Solved<Attitude> {
        let once = self.after(start, Dd::from(period));
        // The period to all digits, by a step of Newton's method along the path.
        let series = self.series(start);
        let (mut along, mut square) = (Dd::ZERO, Dd::ZERO);
        for i in RATES {
            let slope = series[i][1];
            along += (once.0[i] - start.0[i]) * slope;
            square += slope.square();
        }
        let period = Dd::from(period) - (along / square).scaled(1.0 / self.per_second);
        let once = self.after(start, period);
        let turn = product(once.quaternion(), conjugate(start.quaternion()));
        let count = (Dd::from(t) / period).round();
        let rest = self.after(start, Dd::from(t) - period * count);
        rounded(product(to_the_power(turn, count), rest.quaternion()))
    }

    fn series(&self, place: &Place) -> [Series; 10] {
        let [i1, i2, i3] = self.moments;
        let ratios = [(i2, i3, i1), (i3, i1, i2), (i1, i2, i3)];
        let ratios = ratios.map(|(a, b, over)| Dd::sum(a, -b) / over);
        let pulls = [self.pull / i1, self.pull / -i2];
        let mut y = [[Dd::ZERO; ORDER + 1]; 10];
        for (series, part) in y.iter_mut().zip(place.0) {
            series[0] = part;
        }
        for n in 0..ORDER {
            let [w, x, yy, z, p, q, r, g1, g2, g3] = &y;
            #[rustfmt::skip]
            let factors = [
                [x, p], [yy, q], [z, r], [w, p], [yy, r], [z, q], [w, q], [z, p], [x, r], [w, r], [x, q],
                [yy, p], [q, r], [r, p], [p, q], [g2, r], [g3, q], [g3, p], [g1, r], [g1, q], [g2, p],
            ];
            // Side by side: a sum waits for its own last term, and not for the others.
            let mut sums = [Dd::ZERO; 21];
            for k in 0..=n {
                for (sum, [a, b]) in sums.iter_mut().zip(factors) {
                    *sum += a[k] * b[n - k];
                }
            }
            let [xp, yq, zr, wp, yr, zq, wq, zp, xr, wr, xq, yp, rest @ ..] = sums;
            let [qr, rp, pq, g2r, g3q, g3p, g1r, g1q, g2p] = rest;
            let slopes = [
                (xp + yq + zr).scaled(-0.5),
                (wp + yr - zq).scaled(0.5),
                (wq + zp - xr).scaled(0.5),
                (wr + xq - yp).scaled(0.5),
                qr * ratios[0] + g2[n] * pulls[0],
                rp * ratios[1] + g1[n] * pulls[1],
                pq * ratios[2],
                g2r - g3q,
                g3p - g1r,
                g1q - g2p,
            ];
            for (series, slope) in y.iter_mut().zip(slopes) {
                series[n + 1] = slope / (n + 1) as f64;
            }
        }
        y
    }
}

impl Place {
    fn quaternion(&self) -> [Dd; 4] {
        let [w, x, y, z, ..] = self.0;
        [w, x, y, z]
    }

    pub fn attitude(&self) -> Solved<Attitude> {
        rounded(self.quaternion())
    }

    /// The rates on the body's axes, in the units of the truth.
    pub fn rates(&self) -> [f64; 3] {
        RATES.map(|i| self.0[i].to_f64())
    }
}

/// The attitude, rounded once.
fn rounded(quaternion: [Dd; 4]) -> Solved<Attitude> {
    Attitude::from_quaternion(quaternion.map(Dd::to_f64))
}

/// The power of two just below a number, the least normal one at least; 1 for 0.
fn power_of_two(x: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    if x == 0.0 {
        return 1.0;
    }
    f64::from_bits(x.to_bits() & EXPONENT).max(f64::MIN_POSITIVE)
}

/// The longest step that the last coefficients allow.
fn reach(series: &[Series; 10]) -> f64 {
    let last = |n: usize| {
        let largest = series.iter().fold(0.0, |m: f64, s| m.max(s[n].hi().abs()));
        pow(LEFT / largest.max(1e-300), 1.0 / n as f64)
    };
    last(ORDER).min(last(ORDER - 1))
}

fn sum(series: &[Series; 10], h: Dd) -> Place {
    let at = |s: &Series| s.iter().rev().fold(Dd::ZERO, |sum, c| sum * h + *c);
    Place(series.each_ref().map(at))
}

fn conjugate([w, x, y, z]: [Dd; 4]) -> [Dd; 4] {
    [w, -x, -y, -z]
}

fn product([w, x, y, z]: [Dd; 4], [a, b, c, d]: [Dd; 4]) -> [Dd; 4] {
    [
        w * a - x * b - y * c - z * d,
        w * b + x * a + y * d - z * c,
        w * c + y * a + z * b - x * d,
        w * d + z * a + x * c - y * b,
    ]
}

/// A rotation repeated: its angle multiplied, in turns of which the whole ones are dropped.
fn to_the_power(turn: [Dd; 4], count: f64) -> [Dd; 4] {
    let [w, x, y, z] = turn;
    let size = (x.square() + y.square() + z.square()).sqrt();
    if size == 0.0 {
        return turn;
    }
    let half_turns = size.atan2(w) / Dd::TWO_PI * count;
    let half_turns = half_turns - half_turns.round();
    let (sin, cos) = (half_turns * Dd::TWO_PI).sin_cos();
    let factor = sin / size;
    [cos, x * factor, y * factor, z * factor]
}
