//! Moments of inertia from the rates that a gyroscope recorded in free flight.
//!
//! The rates of a free body are known in closed form ([`FreeBody`]), so a fit needs no stepping. Only
//! ratios of moments can be known: a body with all moments doubled turns the same way. A sensor with
//! one axis mirrored cannot be told either: its rates are those of another body.
//!
//! The rates are those on the sensor's axes x, y, z, which are right-handed. The principal axes 0, 1, 2 are those
//! nearest to x, y and z; without [`Correction::Axes`] they are these. So moments are not in the order of
//! their size: [`Fit::middle_axis`] says which is the middle one.
//!
//! What a flight determines is told, and the rest is `None`. A steady spin tells no ratio: any body can spin so
//! about a principal axis. A small wobble about the axis of the largest moment of a flat body tells
//! (I1 + I2)/I3, and hardly I1/I2. Two equal moments are told to be equal, and none is then the middle one; if
//! the axes may be turned it is open which of the two is which, and the intervals hold both.
//!
//! Samples are not independent: the correlation of the residuals says how many are, and of each number the
//! variance is the larger of two, that of the curvature and that of residuals that are drawn again in
//! blocks. Long recordings are fitted from means over a 16th of a turn at most.
//!
//! Accuracy: 300 flights of a phone were made, of 0.5 to 1.2 s at 100 samples a second, with noise, digits and
//! irregular times, and each [`Correction`] in every second of them. A flight told a ratio in 76 to 98
//! of 100 cases, and the stated interval of 95 per cent held the true one in 96 to 98 of 100; with two equal
//! moments and turned axes in 95 to 98 (`tests/fit`).
//!
//! ```
//! use rotation_dynamics::attitude::Attitude;
//! use rotation_dynamics::exact::free_body::FreeBody;
//! use rotation_dynamics::fit::Flight;
//! use rotation_dynamics::frame::{BodyVector, DesignVector};
//! use rotation_dynamics::inertia::PrincipalMoments;
//! # fn main() -> rotation_dynamics::Result<()> {
//! // A flight of 0.8 s, at 200 samples a second that are rounded to thousandths of rad/s.
//! let moments = PrincipalMoments::new(1.0, 4.0, 4.8)?;
//! let body = FreeBody::new(moments, Attitude::IDENTITY, BodyVector::new(0.4, 9.0, 0.5))?;
//! let times: Vec<f64> = (0..160).map(|k| 0.005 * f64::from(k)).collect();
//! let shown = |w: f64| (1000.0 * w).round() / 1000.0;
//! let rates = times.iter().map(|t| DesignVector::from(body.angular_velocity(*t).to_array().map(shown)));
//! let fit = Flight::new(times.clone(), rates.collect())?.fit(&[])?;
//! let ratio = fit.ratio(0, 2).expect("it is determined");
//! assert!((ratio.value - 1.0 / 4.8).abs() < 1e-3 && ratio.holds(1.0 / 4.8));
//! assert_eq!(fit.middle_axis(), Some(1));
//! # Ok(())
//! # }
//! ```
//!
//! Source: M. S. Wheatland and others, *Am. J. Phys.* 89, 342 (2021), for the experiment with a phone.

mod choice;
mod flight;
mod least_squares;
mod model;
mod spread;
mod start;
mod swing;

use crate::attitude::Attitude;
use crate::error::Result;
use crate::exact::free_body::FreeBody;
use crate::frame::{BodyVector, DesignVector};
use crate::math::{exp, log};
pub use choice::Decision;
use choice::Other;
use core::f64::consts::PI;
pub use flight::Flight;
use least_squares::Fitted;
pub use model::Correction;
use model::{Model, Named, slowed_clock};
use nalgebra::{DMatrix, DVector};
pub use swing::{Damping, Hinge, Swing, SwingDecision, SwingFit, Swinging};

/// Half an interval of 95 per cent, in standard deviations that are known.
const NORMAL: f64 = 1.96;

/// Two moments of a body with turned axes are equal within noise up to so many standard deviations: their
/// difference is a length in a plane, that of the two elements of the tensor which make it, and 95 in 100
/// lengths of noise alone are shorter.
const CIRCLE: f64 = 2.45;

/// A ratio of moments is not determined if its interval spans more than this factor up or down: of wider ones,
/// from the curvature, 5 in 20 were false for a phone that wobbles little.
const OPEN: f64 = 1.5;

/// A number with its interval of 95 per cent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The best.
    pub value: f64,
    /// Where the interval begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
}

impl Estimate {
    /// Whether `value` lies in the interval.
    pub fn holds(&self, value: f64) -> bool {
        (self.from..=self.to).contains(&value)
    }
}

/// How a number that a free body keeps went by the recorded rates, relative to its mean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Course {
    /// Its change from the beginning to the end, by the straight line that fits best.
    pub change: f64,
    /// The root of the mean square of what is beside that line.
    pub scatter: f64,
}

/// The free body that fits a flight.
#[derive(Debug, Clone)]
pub struct Fit {
    flight: Flight,
    model: Model,
    fitted: Fitted,
    covariance: DMatrix<f64>,
    /// Half an interval of 95 per cent, in standard deviations.
    confidence: f64,
    decisions: Vec<Decision>,
    /// Other combinations of corrections; none if the rates do not vary beyond noise.
    others: Vec<Other>,
    named: Named,
    motion: FreeBody,
    shown: Vec<[f64; 3]>,
}

impl Fit {
    /// The ratio I_i/I_j of the moments about the principal axes `i` and `j` (0, 1, 2).
    ///
    /// The interval holds both orders of two moments that are equal within noise on axes that may be turned.
    ///
    /// `None` if the flight does not determine it: if its interval would reach beyond 3/2 or 2/3 of
    /// the value, or if the rates vary no more than noise does about a steady spin.
    ///
    /// # Panics
    /// For an axis above 2.
    pub fn ratio(&self, i: usize, j: usize) -> Option<Estimate> {
        assert!(i < 3 && j < 3, "axes {i}, {j}: there are 0, 1 and 2");
        let whole: f64 = self.others.iter().map(|other| other.weight).sum();
        if whole == 0.0 {
            return None;
        }
        let ends = |(i, j): (usize, usize)| {
            let (value, half) = self.log_ratio(i, j);
            [value - half, value + half]
        };
        let value = self.log_ratio(i, j).0;
        let pairs = self.equal(i).flat_map(|i| self.equal(j).map(move |j| (i, j)));
        let apart = pairs.filter(|(a, b)| a != b || i == j).map(ends);
        let [from, to] = apart.fold([value; 2], |all, of| [all[0].min(of[0]), all[1].max(of[1])]);
        let told = (value - from).max(to - value) <= log(OPEN);
        told.then(|| Estimate { value: exp(value), from: exp(from), to: exp(to) })
    }

    /// The logarithm of the ratio of two moments, and half its interval.
    fn log_ratio(&self, i: usize, j: usize) -> (f64, f64) {
        let value = self.named.logs[i] - self.named.logs[j];
        let (mut whole, mut sum) = (0.0, 0.0);
        for Other { weight, logs, covariance, .. } in &self.others {
            let apart = logs[i] - logs[j] - value;
            let own = covariance[i][i] + covariance[j][j] - 2.0 * covariance[i][j];
            whole += weight;
            sum += weight * (own + apart * apart);
        }
        let own = self.variance(&(self.slopes([i, i]) - self.slopes([j, j])));
        (value, self.confidence * (sum / whole).max(own).sqrt())
    }

    /// This axis, and those whose moment may be the same: which of them is which is open then.
    fn equal(&self, i: usize) -> impl Iterator<Item = usize> {
        (0..3).filter(move |j| {
            let (value, half) = self.log_ratio(i, *j);
            let turned = self.model.has(Correction::Axes);
            i == *j || (turned && value.abs() < CIRCLE / NORMAL * half)
        })
    }

    fn slopes(&self, axes: [usize; 2]) -> DVector<f64> {
        self.model.slopes(&self.named.axes, axes)
    }

    /// The variance of a sum of the numbers with these weights.
    fn variance(&self, weights: &DVector<f64>) -> f64 {
        weights.dot(&(&self.covariance * weights)).max(0.0)
    }

    /// The values of a correction that is needed, with their intervals; none if it is not.
    pub fn correction(&self, correction: Correction) -> Vec<Estimate> {
        let Some(at) = self.model.place(correction) else { return Vec::new() };
        let turn = self.named.turn.rotation_vector().to_array();
        let estimate = |n: usize| {
            let (value, variance) = if correction == Correction::Axes {
                // An element of H beside the diagonal, over the difference of the diagonal's.
                let [i, j] = [(n + 1) % 3, (n + 2) % 3];
                let apart = self.named.logs[i] - self.named.logs[j];
                (turn[n], (self.variance(&self.slopes([i, j])) / (apart * apart)).min(PI * PI))
            } else {
                (self.fitted.numbers[at + n], self.covariance[(at + n, at + n)])
            };
            let half = self.confidence * variance.sqrt();
            Estimate { value, from: value - half, to: value + half }
        };
        (0..correction.numbers()).map(estimate).collect()
    }

    /// What was tried, and whether it was needed, in the order of [`Correction`].
    pub fn decisions(&self) -> &[Decision] {
        &self.decisions
    }

    /// The moments, with I3 = 1; `None` if [`Self::ratio`] does not tell I1/I3 and I2/I3. Those that a
    /// flat body's noisy rates fit best may exceed the sum of the other two by a little.
    pub fn moments(&self) -> Option<[f64; 3]> {
        let [x, y, z] = self.named.logs;
        self.ratio(0, 2).and(self.ratio(1, 2)).and(Some([exp(x - z), exp(y - z), 1.0]))
    }

    /// The principal axis (0, 1, 2) with the middle moment; `None` if there are no [`Self::moments`], or if
    /// the interval of a ratio of this moment to another holds 1.
    pub fn middle_axis(&self) -> Option<usize> {
        let [first, middle, last] = crate::math::order_of_three(self.moments()?);
        let told = [first, last]
            .iter()
            .all(|other| self.ratio(middle, *other).is_some_and(|ratio| !ratio.holds(1.0)));
        told.then_some(middle)
    }

    /// 2 E I_mid/L^2: 1 on the separatrix; below 1 the momentum circles the axis of the largest moment, above
    /// 1 that of the least. `None` if there is no [`Self::middle_axis`]. With a drag the interval is wider by the
    /// part of L that is lost: how it is divided among the axes, which would change this number, is not fitted.
    pub fn separatrix(&self) -> Option<Estimate> {
        let middle = self.middle_axis()?;
        let (whole, mean) = self.others.iter().fold((0.0, 0.0), |(whole, mean), other| {
            (whole + other.weight, mean + other.weight * other.separatrices[middle].0)
        });
        let mean: f64 = mean / whole;
        let spread = |other: &Other| {
            let (value, variance) = other.separatrices[middle];
            other.weight * (variance + (value - mean) * (value - mean))
        };
        let variance = self.others.iter().map(spread).sum::<f64>() / whole;
        let drag = self.model.place(Correction::Drag).map_or(0.0, |at| self.fitted.numbers[at]);
        let lost = drag.abs() * self.flight.times[self.flight.times.len() - 1];
        let half = self.confidence * variance.sqrt() + lost;
        let [value, from, to] = [mean, mean - half, mean + half].map(exp);
        Some(Estimate { value, from, to })
    }

    /// The free body, at t = 0 at the first sample: it turns its principal axes into the sensor's axes at
    /// the first sample. A drag slows its clock besides: [`Self::attitude`] allows for that.
    pub const fn motion(&self) -> &FreeBody {
        &self.motion
    }

    /// The rates at the first sample, on the principal axes (rad/s).
    pub fn start(&self) -> BodyVector {
        self.motion.angular_velocity(0.0)
    }

    /// What the sensor shows by the fit at a time `t` of the recording (s) (rad/s).
    ///
    /// # Errors
    /// Those of [`FreeBody::kinematics_at`].
    pub fn rates(&self, t: f64) -> Result<DesignVector> {
        let shown = self.model.rates(&self.fitted.numbers, &[t - self.flight.begin])?;
        Ok(DesignVector::from(shown[0]))
    }

    /// How the sensor is turned at a time `t` of the recording (s): from its axes to those that it had at the
    /// first sample.
    ///
    /// # Errors
    /// Those of [`FreeBody::try_attitude`].
    pub fn attitude(&self, t: f64) -> Result<Attitude> {
        let drag = self.model.place(Correction::Drag).map_or(0.0, |at| self.fitted.numbers[at]);
        let (own, _) = slowed_clock(t - self.flight.begin, drag);
        Ok(self.motion.try_attitude(own)? * self.motion.attitude(0.0).inverse())
    }

    /// The fit less the recorded rates, sample by sample (rad/s).
    pub fn residuals(&self) -> impl Iterator<Item = DesignVector> {
        let pairs = self.shown.iter().zip(&self.flight.rates);
        pairs.map(|(shown, seen)| DesignVector::from([0, 1, 2].map(|i| shown[i] - seen[i])))
    }

    /// The root of the mean square of the residuals (rad/s).
    pub fn misfit(&self) -> f64 {
        let squares: f64 = self.residuals().map(|r| r.dot(&r)).sum();
        (squares / (3 * self.shown.len()) as f64).sqrt()
    }

    /// The recorded rates on the principal axes, without the offset (rad/s).
    fn recorded(&self) -> Vec<[f64; 3]> {
        let own = |seen: &[f64; 3]| {
            let seen = [0, 1, 2].map(|i| seen[i] - self.named.offset[i]);
            self.named.turn.to_body(seen.into()).to_array()
        };
        self.flight.rates.iter().map(own).collect()
    }

    /// How the kinetic energy and |L| went by the recorded rates with the [`Self::moments`]; `None`
    /// without them. A drag gamma changes them by -2 gamma and -gamma a second.
    pub fn kept(&self) -> Option<[Course; 2]> {
        let moments = self.moments()?;
        let rates = self.recorded();
        let [energies, momenta] =
            [0, 1].map(|n| rates.iter().map(|w| kept(&moments, w)[n]).collect::<Vec<_>>());
        Some([course(&self.flight.times, &energies), course(&self.flight.times, &momenta)])
    }

    /// The period (s) of the rates, in which the body flips twice, as counted: twice the mean time between
    /// changes of the sign of the recorded rate about the [`Self::middle_axis`]. `None` without that axis or
    /// with fewer than two changes. By the closed form it is [`FreeBody::rate_period`] of the
    /// [`Self::motion`].
    pub fn counted_period(&self) -> Option<f64> {
        let middle = self.middle_axis()?;
        let rates = self.recorded();
        // Noise changes signs as well: what counts lies three deviations beside 0.
        let clear = 3.0 * self.misfit();
        let mut crossings = Vec::new();
        let mut before: Option<(f64, f64)> = None;
        for (t, w) in self.flight.times.iter().zip(rates).map(|(t, w)| (*t, w[middle])) {
            if w.abs() <= clear {
                continue;
            }
            if let Some((from, rate)) = before.filter(|(_, rate)| rate * w < 0.0) {
                crossings.push(from + (t - from) * rate / (rate - w));
            }
            before = Some((t, w));
        }
        let (first, last) = (crossings.first()?, crossings.last()?);
        (crossings.len() > 1).then(|| 2.0 * (last - first) / (crossings.len() - 1) as f64)
    }
}

/// The kinetic energy and |L|.
fn kept(moments: &[f64; 3], rates: &[f64; 3]) -> [f64; 2] {
    let momentum = [0, 1, 2].map(|i| moments[i] * rates[i]);
    let energy = (0..3).map(|i| 0.5 * momentum[i] * rates[i]).sum();
    [energy, momentum.iter().map(|l| l * l).sum::<f64>().sqrt()]
}

/// The straight line through these values over the times.
fn course(times: &[f64], values: &[f64]) -> Course {
    let count = values.len() as f64;
    let mean = |values: &mut dyn Iterator<Item = f64>| values.sum::<f64>() / count;
    let (middle, level) = (mean(&mut times.iter().copied()), mean(&mut values.iter().copied()));
    let pairs = || times.iter().zip(values).map(|(t, value)| (t - middle, value - level));
    let slope = mean(&mut pairs().map(|(t, v)| t * v)) / mean(&mut pairs().map(|(t, _)| t * t));
    let beside = mean(&mut pairs().map(|(t, v)| (v - slope * t) * (v - slope * t)));
    let whole = times[times.len() - 1] - times[0];
    Course { change: slope * whole / level, scatter: beside.sqrt() / level }
}
