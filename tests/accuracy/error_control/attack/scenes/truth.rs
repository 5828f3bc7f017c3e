//! The truth where doubles are not enough: Euler's equations with gravity and what resists, by
//! Taylor series of order 36 in double-double arithmetic, which share nothing with the
//! library's methods.

use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::math::{DoubleDouble as Dd, exp, pow};

const ORDER: usize = 36;

/// The angle (rad) that the fastest rotation makes in a step: the series of order 36
/// leaves 1e-28 of it.
const ANGLE: f64 = 0.25;

/// The coefficients of a series in the time.
type Series = [Dd; ORDER + 1];

const NONE: Series = [Dd::from_parts(0.0, 0.0); ORDER + 1];

/// The n-th coefficient of a product.
fn product(a: &Series, b: &Series, n: usize) -> Dd {
    (0..=n).fold(Dd::from(0.0), |sum, k| sum + a[k] * b[n - k])
}

fn sum(series: &Series, h: f64) -> Dd {
    series.iter().rev().fold(Dd::from(0.0), |sum, c| sum * h + *c)
}

/// What resists: l_i' = -k_i l_i on the body's axes, and a law of l_3 besides.
#[derive(Debug, Clone, Copy)]
pub struct Resisting {
    pub rates: [f64; 3],
    pub law: Law,
}

/// A torque along e3.
#[derive(Debug, Clone, Copy)]
pub enum Law {
    None,
    /// Dry friction of this size, until l_3 is 0.
    Dry(f64),
    /// This torque at 1 rad/s, and this power of the spin beside the spin itself.
    Power(f64, f64),
}

impl Resisting {
    pub const NOTHING: Self = Self { rates: [0.0; 3], law: Law::None };
}

/// The attitude at the time `t` of a body with gravity of the largest torque `moment`
/// along its axis.
pub fn attitude(body: &RigidBody, moment: f64, start: &State, t: f64) -> Attitude {
    resisted(body, moment, &Resisting::NOTHING, start, t)
}

/// Quaternion, momentum and vertical on the body's axes, and twice the energy of the rotation.
fn began(body: &RigidBody, start: &State) -> (Vec<Dd>, f64) {
    let inertia = body.moments().to_array();
    let [w, x, y, z] = start.attitude.quaternion().map(Dd::from);
    let square = w * w + x * x + y * y + z * z;
    // R^T L and R^T Z of a quaternion whose length is 1 but for rounding.
    let back = |[a, b, c]: [Dd; 3]| {
        [
            a * (w * w + x * x - y * y - z * z) + (b * (x * y + w * z) + c * (x * z - w * y)) * 2.0,
            b * (w * w + y * y - x * x - z * z) + (c * (y * z + w * x) + a * (x * y - w * z)) * 2.0,
            c * (w * w + z * z - x * x - y * y) + (a * (x * z + w * y) + b * (y * z - w * x)) * 2.0,
        ]
        .map(|c| c / square)
    };
    let momentum = back(start.angular_momentum.to_array().map(Dd::from));
    let vertical = back([0.0, 0.0, 1.0].map(Dd::from));
    let energy: f64 = momentum.iter().zip(inertia).map(|(l, i)| l.hi() * l.hi() / i).sum();
    let now = [[w, x, y, z].to_vec(), momentum.to_vec(), vertical.to_vec()].concat();
    (now, energy)
}

/// The same of a body that something resists; dry friction not backwards through its stop.
pub fn resisted(
    body: &RigidBody,
    moment: f64,
    resisting: &Resisting,
    start: &State,
    t: f64,
) -> Attitude {
    let (mut now, energy) = began(body, start);
    let inertia = body.moments().to_array();
    let least = inertia.iter().copied().fold(f64::INFINITY, f64::min);
    let spin = now[6].hi();
    let damping = match resisting.law {
        Law::Power(factor, power) => factor * pow((spin / inertia[2]).abs(), power) / inertia[2],
        _ => 0.0,
    };
    // Backwards it has been faster.
    let damping = resisting.rates.into_iter().fold(damping, f64::max);
    let grown = exp((-damping * t).max(0.0));
    let rate = grown * ((energy + 4.0 * moment.abs()) / least).sqrt() + grown * damping;
    let stop = match resisting.law {
        Law::Dry(torque) if t * torque > 0.0 => t.min(spin.abs() / torque),
        _ => t,
    };
    let rolling = Resisting { law: Law::None, ..*resisting };
    for (span, resisting) in [(stop, resisting), (t - stop, &rolling)] {
        let steps = (rate * span.abs() / ANGLE).ceil();
        for _ in 0..steps as u64 {
            let series = series(&now, inertia, [moment, 0.0], resisting);
            now = ended(&series, span / steps);
        }
    }
    Attitude::from_quaternion([0, 1, 2, 3].map(|i| now[i].to_f64())).expect("a rotation")
}

/// A torque like gravity's, whose size depends on the cosine g of the axis with the vertical in
/// another way on the two sides of one value.
#[derive(Debug, Clone, Copy)]
pub struct Switched {
    pub at: f64,
    /// The torque as g comes to `at`, and its slope there, from below and from above.
    pub sides: [[f64; 2]; 2],
}

impl Switched {
    fn side(&self, g: f64) -> usize {
        usize::from(g > self.at)
    }

    /// The torque over the sine of the tilt.
    pub fn moment(&self, g: f64) -> f64 {
        let [value, slope] = self.sides[self.side(g)];
        value + slope * (g - self.at)
    }
}

/// The attitude at the time `t` under a torque that is switched; steps end where it is.
pub fn switched(body: &RigidBody, torque: &Switched, start: &State, t: f64) -> Attitude {
    const LOOKS: usize = 32;
    let (mut now, energy) = began(body, start);
    let inertia = body.moments().to_array();
    let least = inertia.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = (torque.sides.iter())
        .fold(0.0_f64, |most, [value, slope]| most.max(value.abs() + 2.0 * slope.abs()));
    let whole = ANGLE / ((energy + 4.0 * largest) / least).sqrt();
    let (mut left, mut side) = (t, torque.side(now[9].hi()));
    while left > 0.0 {
        let h = whole.min(left);
        let [value, slope] = torque.sides[side];
        let affine = [value - slope * torque.at, slope];
        let series = series(&now, inertia, affine, &Resisting::NOTHING);
        let beyond = |h: f64| torque.side(sum(&series[9], h).hi()) != side;
        let look = |k: usize| h * k as f64 / LOOKS as f64;
        let taken = match (1..=LOOKS).find(|k| beyond(look(*k))) {
            None => h,
            Some(k) => {
                let (mut low, mut high) = (look(k - 1), look(k));
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    *(if beyond(middle) { &mut high } else { &mut low }) = middle;
                }
                side = 1 - side;
                high
            }
        };
        now = ended(&series, taken);
        left -= taken;
    }
    Attitude::from_quaternion([0, 1, 2, 3].map(|i| now[i].to_f64())).expect("a rotation")
}

/// What a step later follows from its series.
fn ended(series: &[Series; 10], h: f64) -> Vec<Dd> {
    series.iter().map(|series| sum(series, h)).collect()
}

/// The series of quaternion, momentum and vertical on the body's axes, under a torque of the size
/// m + n g_3.
fn series(
    now: &[Dd],
    inertia: [f64; 3],
    [moment, slope]: [f64; 2],
    resisting: &Resisting,
) -> [Series; 10] {
    let sign = now[6].hi().signum();
    let mut y = [NONE; 10];
    for (series, value) in y.iter_mut().zip(now) {
        series[0] = *value;
    }
    let mut omega = [NONE; 3];
    // |l_3|^(1 + p) with the sign of l_3.
    let mut powered = NONE;
    for n in 0..ORDER {
        for i in 0..3 {
            omega[i][n] = y[4 + i][n] / inertia[i];
        }
        let along = match resisting.law {
            Law::None => Dd::from(0.0),
            Law::Dry(torque) if n == 0 => Dd::from(-torque * sign),
            Law::Dry(_) => Dd::from(0.0),
            Law::Power(factor, power) => {
                let exponent = Dd::from(power) + 1.0;
                powered[n] = power_of(&y[6], &powered, exponent, n);
                powered[n] * (Dd::from(inertia[2]).ln() * exponent).exp().recip() * -factor
            }
        };
        let [ka, kb, kc] = resisting.rates;
        let [p, q, r] = &omega;
        let [w, x, yy, z, l1, l2, l3, g1, g2, g3] = &y;
        let of = |a: &Series, b: &Series| product(a, b, n);
        // m g, and where the size depends on it n g_3 g.
        let weight = |g: &Series| {
            let steady = g[n] * moment;
            if slope == 0.0 { steady } else { steady + of(g3, g) * slope }
        };
        let slopes = [
            (of(x, p) + of(yy, q) + of(z, r)) * -0.5,
            (of(w, p) + of(yy, r) - of(z, q)) * 0.5,
            (of(w, q) + of(z, p) - of(x, r)) * 0.5,
            (of(w, r) + of(x, q) - of(yy, p)) * 0.5,
            of(l2, r) - of(l3, q) + weight(g2) - l1[n] * ka,
            of(l3, p) - of(l1, r) - weight(g1) - l2[n] * kb,
            of(l1, q) - of(l2, p) - l3[n] * kc + along,
            of(g2, r) - of(g3, q),
            of(g3, p) - of(g1, r),
            of(g1, q) - of(g2, p),
        ];
        for (series, slope) in y.iter_mut().zip(slopes) {
            series[n + 1] = slope / (n + 1) as f64;
        }
    }
    y
}

/// The n-th coefficient of |l|^e with the sign of l, from those before it: l y' = e l' y.
fn power_of(l: &Series, y: &Series, e: Dd, n: usize) -> Dd {
    if n == 0 {
        return (l[0].abs().ln() * e).exp() * l[0].hi().signum();
    }
    let sum = (1..=n)
        .fold(Dd::from(0.0), |sum, k| sum + (e * k as f64 - (n - k) as f64) * l[k] * y[n - k]);
    sum / (l[0] * n as f64)
}
