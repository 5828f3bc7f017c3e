//! The truth where doubles are not enough: Taylor series of order 36 in pairs of doubles.
//!
//! Euler's equations on the body's axes, with or without a weight on the third, and the
//! quaternion that they turn. Every term is a product of two unknowns, so a coefficient of the
//! series is a sum of products of those before it; no angle, no elliptic function and no method of
//! the library has a part in it. Of 32 digits a run of a hundred radians leaves about 28.

use rotation_dynamics::Result;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{DoubleDouble as Dd, pow};

/// The order of the series.
pub const ORDER: usize = 36;
/// The last coefficients of a series leave at most this of the sum.
const LEFT: f64 = 1e-32;

/// The coefficients of a series in the time.
pub type Series = [Dd; ORDER + 1];
/// Those of the quaternion (0 to 3), of the rates (4 to 6), and of the vertical on the body's
/// axes (7 to 9).
pub type Unknowns = [Series; 10];
/// What acts besides a weight: the n-th coefficients of the angular accelerations that it gives,
/// from those of the unknowns up to n.
pub type Acceleration<'a> = &'a mut dyn FnMut(usize, &Unknowns) -> [Dd; 3];
type Quaternion = [Dd; 4];

/// A moving body, in units of time in which it turns by about a radian.
#[derive(Debug, Clone, Copy)]
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
    /// At the start: moments (kg m^2), weight (N) and lever (m), attitude, rates (rad/s).
    pub fn new(moments: [f64; 3], gravity: [f64; 2], from: Attitude, rates: [f64; 3]) -> Self {
        let ([weight, lever], [i1, i2, i3]) = (gravity, moments);
        let pulled = ((weight * lever).abs() / i1.min(i2).min(i3)).sqrt();
        let fastest = rates.iter().fold(pulled, |m, w| m.max(w.abs()));
        let per_second = power_of_two(fastest);
        let unit = 1.0 / per_second;
        let q = from.quaternion().map(Dd::from);
        let length = q.iter().fold(Dd::ZERO, |sum, c| sum + c.square()).sqrt();
        let [w, x, y, z] = q.map(|c| c / length);
        let [p, q, r] = rates.map(|w| Dd::from(w / per_second));
        let [g1, g2] = [(x * z - w * y) * 2.0, (y * z + w * x) * 2.0];
        let g3 = w.square() + z.square() - x.square() - y.square();
        Self {
            moments,
            pull: Dd::product(weight, lever).scaled(unit).scaled(unit),
            per_second,
            now: [w, x, y, z, p, q, r, g1, g2, g3],
        }
    }

    /// The same given by its angular momentum in space: it has the rates I^-1 R^T L, to all digits.
    #[must_use]
    pub fn with_momentum(mut self, momentum: SpaceVector) -> Self {
        let [x, y, z] = momentum.to_array().map(Dd::from);
        let turned = product(conjugate(self.quaternion()), [Dd::ZERO, x, y, z]);
        let [_, x, y, z] = product(turned, self.quaternion());
        for (i, component) in [x, y, z].into_iter().enumerate() {
            self.now[4 + i] = (component / self.moments[i]).scaled(self.unit());
        }
        self
    }

    /// The unit of time (s), a power of two.
    pub const fn unit(&self) -> f64 {
        1.0 / self.per_second
    }

    /// The same after `t` (s).
    #[must_use]
    pub fn after(self, t: Dd) -> Self {
        self.accelerated(t, &mut |_, _| [Dd::ZERO; 3])
    }

    /// The same after `t` (s), if this acts too.
    #[must_use]
    pub fn accelerated(mut self, t: Dd, also: Acceleration<'_>) -> Self {
        let mut left = t.scaled(self.per_second);
        while left != 0.0 {
            let series = self.series(also);
            let step = step(&series, left);
            self = self.at(&series, step);
            left -= step;
        }
        self
    }

    /// The same a time later, in its units, by the series from here.
    #[must_use]
    pub fn at(&self, series: &Unknowns, t: Dd) -> Self {
        let now = series.map(|s| s.iter().rev().fold(Dd::ZERO, |sum, c| sum * t + *c));
        Self { now, ..*self }
    }

    /// The attitude at a late time of a free body whose rates have about this period (s): the
    /// rotation of one period, taken to a power.
    ///
    /// # Errors
    /// Those of [`Attitude::from_quaternion`].
    pub fn late(self, period: f64, t: Dd) -> Result<Attitude> {
        let once = self.after(Dd::from(period));
        // The period to all digits, by a step of Newton's method along the path.
        let series = self.series(&mut |_, _| [Dd::ZERO; 3]);
        let (mut along, mut square) = (Dd::ZERO, Dd::ZERO);
        for i in [4, 5, 6] {
            let slope = series[i][1];
            along += (once.now[i] - self.now[i]) * slope;
            square += slope.square();
        }
        let period = Dd::from(period) - (along / square).scaled(self.unit());
        let once = self.after(period);
        let mut turn = product(once.quaternion(), conjugate(self.quaternion()));
        let count = (t / period).round();
        let mut end = self.after(t - period * count).quaternion();
        let mut left = count as u64;
        while left > 0 {
            if left % 2 == 1 {
                end = product(turn, end);
            }
            (turn, left) = (product(turn, turn), left / 2);
        }
        Attitude::from_quaternion(end.map(Dd::to_f64))
    }

    /// The series from here: each slope is a sum of factors times products of two, and of what
    /// acts besides.
    pub fn series(&self, also: Acceleration<'_>) -> Unknowns {
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
            for (i, acceleration) in also(n, &all).into_iter().enumerate() {
                slopes[p + i] += acceleration;
            }
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
    ///
    /// # Errors
    /// Those of [`Attitude::from_quaternion`].
    pub fn attitude(&self) -> Result<Attitude> {
        Attitude::from_quaternion(self.quaternion().map(Dd::to_f64))
    }

    /// The rates on the body's axes, in the units of the truth.
    pub fn rates(&self) -> [f64; 3] {
        [4, 5, 6].map(|i| self.now[i].to_f64())
    }
}

/// The longest step that the last coefficients allow, or what is left.
pub fn step(series: &Unknowns, left: Dd) -> Dd {
    let reach = [ORDER - 1, ORDER].map(|n| {
        let largest = series.iter().fold(1e-300, |m: f64, s| m.max(s[n].hi().abs()));
        pow(LEFT / largest, 1.0 / n as f64)
    });
    match reach[0].min(reach[1]) {
        step if left.abs() <= step => left,
        step => Dd::from(step.copysign(left.to_f64())),
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
