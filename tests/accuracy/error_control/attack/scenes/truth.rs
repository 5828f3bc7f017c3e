//! The truth by [`models::truth`], which shares nothing with the library's methods, with gravity
//! and what resists.

use models::truth::{ORDER, Series, Truth, Unknowns, step};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::math::DoubleDouble as Dd;

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
    /// The coefficients of the angular accelerations of a body with this moment about e3, in a
    /// unit of time that is a power of two.
    fn accelerations(self, i3: f64, unit: f64) -> impl FnMut(usize, &Unknowns) -> [Dd; 3] {
        // |omega_3|^(1 + p) with the sign of omega_3.
        let mut powered = [Dd::ZERO; ORDER + 1];
        move |n, y| {
            let along = match self.law {
                Law::Dry(torque) if n == 0 => {
                    (Dd::from(-torque * y[6][0].hi().signum()) / i3).scaled(unit).scaled(unit)
                }
                Law::Power(factor, power) => {
                    powered[n] = power_of(&y[6], &powered, Dd::from(power) + 1.0, n);
                    let units = (Dd::from(unit).ln() * (Dd::ONE - power)).exp();
                    powered[n] * units * -factor / i3
                }
                _ => Dd::ZERO,
            };
            let [p, q, r] = [0, 1, 2].map(|i| y[4 + i][n] * (-self.rates[i] * unit));
            [p, q, r + along]
        }
    }
}

/// A body with gravity of the largest torque `moment` along its axis.
fn began(body: &RigidBody, moment: f64, start: &State) -> Truth {
    let rates = body.angular_velocity(start).to_array();
    let truth = Truth::new(body.moments().to_array(), [moment, 1.0], start.attitude, rates);
    truth.with_momentum(start.angular_momentum)
}

/// The attitude at the time `t` of a body with gravity of the largest torque `moment`
/// along its axis.
pub fn attitude(body: &RigidBody, moment: f64, start: &State, t: f64) -> Attitude {
    began(body, moment, start).after(Dd::from(t)).attitude().expect("a rotation")
}

/// The same of a body that something resists; dry friction not backwards through its stop.
pub fn resisted(
    body: &RigidBody,
    moment: f64,
    resisting: &Resisting,
    start: &State,
    t: f64,
) -> Attitude {
    let mut truth = began(body, moment, start);
    let (i3, unit) = (body.moments().i3(), truth.unit());
    let spin = truth.rates()[2] / unit * i3;
    let stop = match resisting.law {
        Law::Dry(torque) if t * torque > 0.0 => t.min(spin.abs() / torque),
        _ => t,
    };
    let rolling = Resisting { law: Law::None, ..*resisting };
    for (span, resisting) in [(stop, *resisting), (t - stop, rolling)] {
        truth = truth.accelerated(Dd::from(span), &mut resisting.accelerations(i3, unit));
    }
    truth.attitude().expect("a rotation")
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
    let mut truth = began(body, 0.0, start);
    let ([i1, i2, _], unit) = (body.moments().to_array(), truth.unit());
    let mut left = Dd::from(t / unit);
    let mut side = torque.side(start.attitude.axis().z());
    while left > 0.0 {
        let [value, slope] = torque.sides[side];
        let affine = [value - slope * torque.at, slope].map(|m| m * unit * unit);
        let series = truth.series(&mut |n, y| {
            // The n-th coefficient of (m + m' g_3) g.
            let [g1, g2] = [7, 8].map(|i| {
                let both = (0..=n).fold(Dd::ZERO, |sum, k| sum + y[9][k] * y[i][n - k]);
                y[i][n] * affine[0] + both * affine[1]
            });
            [g2 / i1, g1 / -i2, Dd::ZERO]
        });
        let height = |t: f64| series[9].iter().rev().fold(Dd::ZERO, |sum, c| sum * t + *c);
        let beyond = |t: f64| torque.side(height(t).hi()) != side;
        let whole = step(&series, left);
        let look = |k: usize| whole.hi() * k as f64 / LOOKS as f64;
        let taken = match (1..=LOOKS).find(|k| beyond(look(*k))) {
            None => whole,
            Some(k) => {
                let (mut low, mut high) = (look(k - 1), look(k));
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    *(if beyond(middle) { &mut high } else { &mut low }) = middle;
                }
                side = 1 - side;
                Dd::from(high)
            }
        };
        truth = truth.at(&series, taken);
        left -= taken;
    }
    truth.attitude().expect("a rotation")
}

/// The n-th coefficient of |w|^e with the sign of w, from those before it: w y' = e w' y.
fn power_of(w: &Series, y: &Series, e: Dd, n: usize) -> Dd {
    if n == 0 {
        return (w[0].abs().ln() * e).exp() * w[0].hi().signum();
    }
    let sum = (1..=n)
        .fold(Dd::from(0.0), |sum, k| sum + (e * k as f64 - (n - k) as f64) * w[k] * y[n - k]);
    sum / (w[0] * n as f64)
}
