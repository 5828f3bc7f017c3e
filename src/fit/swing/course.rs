//! The motion of a pendulum that is slowed, and numbers from which its fit begins.

use crate::error::{Error, Result};
use crate::math::{atan2, exp, log, sin, sincos};
use nalgebra::{Matrix4, Vector4};

/// ln W^2, angle and rate at the start, the sensor's offset, gamma, beta (s, rad).
pub(super) type Numbers = [f64; 6];

/// The longest step, in units of 1/W, and the order of the series in time by which it is made. The nearest
/// pole of sech(W t), the steepest swing, is pi/2 away: the first term left out is (0.4/pi)^11 = 1.4e-10.
pub(super) const STEP: f64 = 0.2;
const ORDER: usize = 10;

/// The state (rad, rad/s) the time `dt` (s) later.
pub(super) fn advanced(numbers: &Numbers, [mut angle, rate]: [f64; 2], dt: f64) -> [f64; 2] {
    let [log_square, _, _, _, linear, quadratic] = *numbers;
    let frequency = exp(0.5 * log_square);
    let (mut rate, mut left) = (rate / frequency, dt * frequency);
    while left > 0.0 {
        let (sin, cos) = sincos(angle);
        // The quadratic damping turns at rest; beyond, another series goes on.
        let sense = if rate == 0.0 { -sin.signum() } else { rate.signum() };
        let rates = series([rate, sin, cos], linear / frequency, sense * quadratic);
        let [mut slopes, mut angles] = [[0.0; ORDER + 1]; 2];
        for k in 0..ORDER {
            slopes[k] = (k + 1) as f64 * rates[k + 1];
            angles[k] = rates[k] / (k + 1) as f64;
        }
        let mut step = left.min(STEP);
        let end = at(&rates, step);
        let turns = quadratic != 0.0 && end * sense < 0.0;
        if turns {
            let whole = step;
            step *= rate / (rate - end);
            for _ in 0..4 {
                step = (step - at(&rates, step) / at(&slopes, step)).clamp(0.0, whole);
            }
        }
        angle += step * at(&angles, step);
        rate = if turns { 0.0 } else { end };
        left -= step;
    }
    [angle, rate * frequency]
}

/// The coefficients of the rate v, from v' = -s - gamma v - beta v^2, s' = c v and c' = -s v with
/// s = sin(theta), c = cos(theta), in units of time of 1/W.
fn series([rate, sin, cos]: [f64; 3], linear: f64, quadratic: f64) -> [f64; ORDER + 1] {
    let [mut v, mut s, mut c] = [[0.0; ORDER + 1]; 3];
    (v[0], s[0], c[0]) = (rate, sin, cos);
    for k in 0..ORDER {
        let (mut vv, mut sv, mut cv) = (0.0, 0.0, 0.0);
        for i in 0..=k {
            let other = v[k - i];
            vv += v[i] * other;
            sv += s[i] * other;
            cv += c[i] * other;
        }
        let part = 1.0 / (k + 1) as f64;
        v[k + 1] = -part * (s[k] + linear * v[k] + quadratic * vv);
        s[k + 1] = part * cv;
        c[k + 1] = -part * sv;
    }
    v
}

/// A polynomial with these coefficients.
fn at(series: &[f64; ORDER + 1], t: f64) -> f64 {
    let mut sum = 0.0;
    for k in (0..ORDER + 1).rev() {
        sum = sum * t + series[k];
    }
    sum
}

/// Angle and rate (rad, rad/s) at these times (s), which ascend from the start.
///
/// # Errors
/// `OutOfRange` for numbers with which the rate grows beyond all sizes.
pub(super) fn states(numbers: &Numbers, times: impl Iterator<Item = f64>) -> Result<Vec<[f64; 2]>> {
    let (mut now, mut state) = (0.0, [numbers[1], numbers[2]]);
    let step = |t: f64| {
        state = advanced(numbers, state, t - now);
        now = t;
        let allowed = "a finite one";
        let [angle, rate] = state;
        let finite = angle.is_finite() && rate.is_finite();
        if finite { Ok(state) } else { Err(Error::out_of_range("rate", rate, allowed)) }
    };
    times.map(step).collect()
}

/// The energy of this state over that of the upright position: k^2.
pub(super) fn energy(numbers: &Numbers, [angle, rate]: [f64; 2]) -> f64 {
    let (half, swing) = (sin(0.5 * angle), 0.5 * rate * exp(-0.5 * numbers[0]));
    half * half + swing * swing
}

/// The second derivative of the rate (rad/s^3).
pub(super) fn second_derivative(numbers: &Numbers, [angle, rate]: [f64; 2]) -> f64 {
    let [log_square, _, _, _, linear, quadratic] = *numbers;
    let (square, (sin, cos)) = (exp(log_square), sincos(angle));
    let change = -square * sin - (linear + quadratic * rate.abs()) * rate;
    -square * cos * rate - (linear + 2.0 * quadratic * rate.abs()) * change
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
