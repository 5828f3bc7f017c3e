//! The motion of a pendulum that is slowed, and numbers from which its fit begins.

use crate::error::Result;
use crate::exact::pendulum::{Pendulum, Suspension};
use crate::integrators::{Dop853, Solution, second_order};
use crate::math::{atan2, exp, log, sin, sincos};
use nalgebra::{Matrix4, Vector4};

/// ln W^2, angle and rate at the start, the sensor's offset, gamma, beta (s, rad).
pub(super) type Numbers = [f64; 6];

/// Error of a step of the integrator. Differences of runs with numbers 1e-7 apart, from which the fit
/// has its slopes, must not see it.
const TOLERANCE: f64 = 1e-11;

/// The motion from the first sample on.
#[derive(Debug, Clone)]
pub(super) struct Course {
    numbers: Numbers,
    frequency: f64,
    motion: Motion,
}

#[derive(Debug, Clone)]
enum Motion {
    Free(Box<Pendulum>),
    /// In units of time of 1/W.
    Slowed(Solution<2>),
}

/// The pendulum without damping.
pub(super) fn free(&[log_square, angle, rate, ..]: &Numbers) -> Result<Pendulum> {
    let unit = Suspension { moment: 1.0, mass: 1.0, gravity: exp(log_square), lever: 1.0 };
    Pendulum::new(unit, angle, rate)
}

impl Course {
    /// As far as to `end` (s).
    pub(super) fn new(numbers: Numbers, end: f64) -> Result<Self> {
        let [log_square, angle, rate, _, linear, quadratic] = numbers;
        let frequency = exp(0.5 * log_square);
        let motion = if [linear, quadratic] == [0.0; 2] {
            Motion::Free(Box::new(free(&numbers)?))
        } else {
            let linear = linear / frequency;
            let slowed = second_order(move |_, x, v| -sin(x) - (linear + quadratic * v.abs()) * v);
            let phase = frequency * end;
            // About three steps a radian are taken; numbers that need many more fit nothing.
            let method = Dop853::new(TOLERANCE)?.with_step_limit(1000 + (100.0 * phase) as u64)?;
            Motion::Slowed(method.solve(&slowed, 0.0, &[angle, rate / frequency], phase, &[])?)
        };
        Ok(Self { numbers, frequency, motion })
    }

    /// Angle and rate (rad, rad/s).
    pub(super) fn state(&self, t: f64) -> Result<[f64; 2]> {
        match &self.motion {
            Motion::Free(pendulum) => pendulum.at(t).map(|state| [state.theta, state.omega]),
            Motion::Slowed(run) => {
                let phase = (self.frequency * t).min(run.end_time());
                run.at(phase).map(|[angle, rate]| [angle, self.frequency * rate])
            }
        }
    }

    /// What the sensor shows, as the mean over times about `t` that have this variance (s^2): half of it
    /// times the second derivative of the rate is added.
    pub(super) fn shown(&self, t: f64, variance: f64) -> Result<f64> {
        let [angle, rate] = self.state(t)?;
        let [_, _, _, offset, linear, quadratic] = self.numbers;
        if variance == 0.0 {
            return Ok(rate + offset);
        }
        let square = self.frequency * self.frequency;
        let (sin, cos) = sincos(angle);
        let change = -square * sin - (linear + quadratic * rate.abs()) * rate;
        let second = -square * cos * rate - (linear + 2.0 * quadratic * rate.abs()) * change;
        Ok(rate + offset + 0.5 * variance * second)
    }
}

/// Numbers of a pendulum with linear damping, and the sum of squares that they leave, by linear algebra;
/// `None` if these rates, less the `offset`, do not determine them.
///
/// With psi(t), the integral of the rate, theta = theta(0) + psi, and the equation integrated once is
/// theta' = theta'(0) - a int sin(psi) - b int cos(psi) - gamma psi with a = W^2 cos(theta(0)) and
/// b = W^2 sin(theta(0)): linear in theta'(0), a, b and gamma. No rate is differentiated.
pub(super) fn start(times: &[f64], rates: &[f64], offset: f64) -> Option<(Numbers, f64)> {
    let (mut turned, mut sines, mut cosines) = (0.0, 0.0, 0.0);
    let (mut matrix, mut right, mut squares) = (Matrix4::zeros(), Vector4::zeros(), 0.0);
    for k in 0..times.len() {
        let rate = rates[k] - offset;
        if k > 0 {
            let half = 0.5 * (times[k] - times[k - 1]);
            let before = sincos(turned);
            turned += half * (rate + rates[k - 1] - offset);
            let now = sincos(turned);
            sines += half * (before.0 + now.0);
            cosines += half * (before.1 + now.1);
        }
        let row = Vector4::new(1.0, -sines, -cosines, -turned);
        matrix += row * row.transpose();
        right += row * rate;
        squares += rate * rate;
    }
    let solved = matrix.cholesky()?.solve(&right);
    let [rate, a, b, linear] = solved.into();
    let numbers = [0.5 * log(a * a + b * b), atan2(b, a), rate, offset, linear, 0.0];
    numbers.iter().all(|x: &f64| x.is_finite()).then(|| (numbers, squares - solved.dot(&right)))
}
