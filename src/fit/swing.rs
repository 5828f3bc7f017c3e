//! A pendulum's length, amplitude and damping from the rate about its hinge.
//!
//! A phone that is taped to a rod, or swings on a hinge, records
//!
//! ```text
//! theta'' = -W^2 sin(theta) - gamma theta' - beta |theta'| theta',   W^2 = g/length,
//! ```
//!
//! with theta from the hanging position, in swings of any size below the upright position. The motion is
//! made by its series in time: it agrees with the closed form ([`crate::exact::pendulum`]) to 1e-11, and with
//! [`Dop853`](crate::integrators::Dop853) to 1e-10 where it is damped.
//!
//! Accuracy: 500 swings were made, of 5 to 9 s at 50 to 120 uneven samples a second, with noise, rounding, an
//! offset, and each damping in every second of them. The intervals of 95 per cent held the true length
//! in 96 of 100, the amplitude in 97, the offset in 95. Each damping was found in all of the 477 where it
//! takes a quarter of the amplitude or more, and once in the 523 without. Of 750 recordings of a rod that is
//! lifted, held, let go from 5 to 170 degrees and stopped within 0.2 s, [`Swing::find`] took a piece inside the
//! swing, of 82 to 99 of its 100 parts; the length was held in 96 of 100 (`tests/fit/swing.rs`). A
//! recording of 20 s at 400 samples a second takes 0.05 s to fit, and about as long to search.
//!
//! ```
//! use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
//! use rotation_dynamics::fit::Swing;
//! # fn main() -> rotation_dynamics::Result<()> {
//! // A rod of 0.6 m on its end swings as a point on a thread of 0.4 m. Recorded: 6 s in hundredths of rad/s.
//! let rod = Suspension { moment: 0.12, mass: 1.0, gravity: 9.81, lever: 0.3 };
//! let pendulum = Pendulum::new(rod, 1.2, 0.0)?;
//! let times: Vec<f64> = (0..600).map(|k| 0.01 * f64::from(k)).collect();
//! let rates = times.iter().map(|t| Ok((100.0 * pendulum.at(*t)?.omega).round() / 100.0));
//! let fit = Swing::new(times.clone(), rates.collect::<rotation_dynamics::Result<_>>()?)?.fit()?;
//! let length = fit.length(9.81)?;
//! assert!((length.value - 0.4).abs() < 1e-4 && length.holds(0.4));
//! assert!(fit.amplitude().holds(1.2) && fit.linear().is_none() && fit.quadratic().is_none());
//! # Ok(())
//! # }
//! ```

mod course;
mod found;
mod piece;

use super::Flight;
use crate::error::{Error, Result};
use crate::frame::DesignVector;
use crate::math::exp;
use course::{Numbers, STEP};
use found::Candidate;
pub use found::{Damping, SwingDecision, SwingFit};
use nalgebra::{Matrix3, SymmetricEigen, Vector3};
pub use piece::Swinging;

/// The rate about a hinge, as a gyroscope recorded it.
#[derive(Debug, Clone, PartialEq)]
pub struct Swing {
    /// In s after the first.
    times: Vec<f64>,
    begin: f64,
    rates: Vec<f64>,
    hinge: Option<Hinge>,
}

/// The hinge on the axes of the sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hinge {
    /// Its direction, of length 1; its largest component is positive.
    pub axis: DesignVector,
    /// The rate across it divided by that about it, each as the root of the mean square of its change:
    /// noise, and how much the hinge wobbles.
    pub wobble: f64,
}

/// What helps where a recording is more than a swing.
const WITHOUT: &str = "Fitted are swings to and fro. What rests, is lifted, held, stopped or goes over the top \
                       is to be left out: --from and --to, in seconds, name the piece that swings";

fn not_nearly() -> Error {
    let found = "no pendulum that swings to and fro shows these rates, not even nearly";
    Error::no_swing(format!("{found}. {WITHOUT}"))
}

/// The direction in which these vectors change most, and the change across it over that along it.
fn principal(rates: &[DesignVector]) -> (DesignVector, f64) {
    let count = rates.len() as f64;
    let vectors = || rates.iter().map(|rate| Vector3::from(*rate));
    let mean = vectors().sum::<Vector3<f64>>() / count;
    let covariance: Matrix3<f64> =
        vectors().map(|rate| (rate - mean) * (rate - mean).transpose() / count).sum();
    let principal = SymmetricEigen::new(covariance);
    let first = principal.eigenvalues.imax();
    let axis = principal.eigenvectors.column(first);
    let axis = axis * axis[axis.iamax()].signum();
    let along = principal.eigenvalues[first];
    let wobble = ((covariance.trace() - along).max(0.0) / along).sqrt();
    (DesignVector::new(axis.x, axis.y, axis.z), wobble)
}

/// Means of samples that follow each other.
struct Averaged {
    time: f64,
    variance: f64,
    rate: f64,
    /// The root of the number of samples.
    weight: f64,
}

impl Swing {
    /// A swing: `times` (s), ascending, and the rate about the hinge (rad/s) at each.
    ///
    /// # Errors
    /// Those of [`Flight::new`]; `Incompatible` if the mean of the rates exceeds their standard deviation: then
    /// it does not go to and fro.
    pub fn new(times: Vec<f64>, rates: Vec<f64>) -> Result<Self> {
        let along = rates.iter().map(|rate| DesignVector::new(*rate, 0.0, 0.0)).collect();
        let Flight { times, begin, .. } = Flight::new(times, along)?;
        let swing = Self { times, begin, rates, hinge: None };
        let (mean, deviation) = swing.mean();
        if mean.abs() > deviation {
            return Err(Error::no_swing(format!(
                "this does not go to and fro: the rate is {mean:.3} rad/s on the average, and leaves that by \
                 {deviation:.3} rad/s only. It goes one way, or over the top, or is less than a whole swing. \
                 {WITHOUT}"
            )));
        }
        Ok(swing)
    }

    /// A swing from all three rates (rad/s), on the sensor's axes: the one about the direction in which they
    /// change most, the first eigenvector of their covariance.
    ///
    /// # Errors
    /// As of [`Swing::new`].
    pub fn of_sensor(times: Vec<f64>, rates: Vec<DesignVector>) -> Result<Self> {
        Flight::new(times.clone(), rates.clone())?;
        let (axis, wobble) = principal(&rates);
        let about = rates.iter().map(|rate| rate.dot(&axis)).collect();
        Ok(Self { hinge: Some(Hinge { axis, wobble }), ..Self::new(times, about)? })
    }

    /// The hinge, if three rates were given.
    pub fn hinge(&self) -> Option<Hinge> {
        self.hinge
    }

    /// The rates about the hinge (rad/s).
    pub fn rates(&self) -> &[f64] {
        &self.rates
    }

    /// Mean and standard deviation of the rates.
    fn mean(&self) -> (f64, f64) {
        let count = self.rates.len() as f64;
        let mean = self.rates.iter().sum::<f64>() / count;
        let squares: f64 = self.rates.iter().map(|rate| (rate - mean) * (rate - mean)).sum();
        (mean, (squares / count).sqrt())
    }

    /// The pendulum that shows these rates best, with the dampings that they need.
    ///
    /// W^2, angle and rate at the start and the sensor's offset are fitted by least squares, alone, with
    /// each damping, and with both. Chosen is the one with the least n ln S + sum of the thresholds, as of
    /// [`Flight::fit`]; intervals allow for the others, each with the weight e^(-x/2) if that sum is x larger.
    /// Where both dampings explain the rates as well, the better one is named. One below 0 is a sign of what the equation lacks: a push,
    /// or dry friction.
    ///
    /// Samples are averaged over 0.2/W, 31 in a small swing. What changes fastest is the rate near the
    /// upright position, as sech(W t). To the mean of its values over h, the fit has its second derivative
    /// and leaves out the fourth, 5 (W h)^4/1920 = 4e-6 of it.
    ///
    /// # Errors
    /// `Incompatible`, with what was found: for rates of which no pendulum explains three quarters of the variance,
    /// for one that goes over the top, for fewer than six samples in a small swing, and if the length is open
    /// by more than a factor of two.
    pub fn fit(&self) -> Result<SwingFit> {
        let (averaged, mut numbers) = self.started()?;
        let linear = Candidate::new([true, false], numbers, &averaged);
        numbers = linear.as_ref().map_or(numbers, |linear| linear.numbers);
        // What loses as much energy: beta |rate|^3 for gamma rate^2.
        let (mean, _) = self.mean();
        let power = |n| self.rates.iter().map(|rate| (rate - mean).abs().powi(n)).sum::<f64>();
        numbers[5] = numbers[4] * power(2) / power(3);
        let free = Candidate::new([false; 2], numbers, &averaged);
        let quadratic = Candidate::new([false, true], numbers, &averaged);
        let found = linear.iter().chain(&quadratic).min_by(|a, b| a.squares.total_cmp(&b.squares));
        let both = Candidate::new([true; 2], found.map_or(numbers, |of| of.numbers), &averaged);
        let candidates: Vec<Candidate> =
            [free, linear, quadratic, both].into_iter().flatten().collect();
        if candidates.is_empty() {
            return Err(not_nearly());
        }
        SwingFit::chosen(candidates, self.whole(&averaged), self)
    }

    /// The squares that a rate without change leaves.
    fn whole(&self, averaged: &[Averaged]) -> f64 {
        let (mean, _) = self.mean();
        averaged.iter().map(|a| f64::powi(a.weight * (a.rate - mean), 2)).sum()
    }

    /// What is fitted, and numbers with which to begin.
    fn started(&self) -> Result<(Vec<Averaged>, Numbers)> {
        let (mean, deviation) = self.mean();
        let window = self.first_swings(mean, deviation);
        // The mean of less than many whole swings is no offset: taken is the one that explains most.
        let mut best: Option<(Numbers, f64)> = None;
        for spacing in [0.05, 0.005] {
            let middle = best.map_or(0.0, |(numbers, _)| numbers[3]);
            let starts = (-20..=20).map(|k| {
                let offset = middle + spacing * deviation * f64::from(k);
                course::start(&self.times[..window], &self.rates[..window], offset)
            });
            best = starts.flatten().min_by(|a, b| a.1.total_cmp(&b.1));
        }
        let (mut numbers, _) = best.ok_or_else(not_nearly)?;
        let unit = exp(-0.5 * numbers[0]);
        let step = self.times[self.times.len() - 1] / (self.times.len() - 1) as f64;
        if step > unit {
            return Err(Error::no_swing(format!(
                "nothing swings here, or too fast for a sample every {step:.2e} s: six are needed in a small \
                 swing, one every {unit:.2e} s for the pendulum that is nearest to these rates. {WITHOUT}"
            )));
        }
        let averaged = self.averaged(STEP * unit);
        // Linear damping serves for any, while ever more swings are fitted.
        let mut part = averaged.iter().take_while(|a| a.time <= self.times[window - 1]).count();
        part = part.max(8);
        while part < averaged.len() {
            let fitted = Candidate::new([true, false], numbers, &averaged[..part]);
            numbers = fitted.map_or(numbers, |fitted| fitted.numbers);
            part *= 3;
        }
        Ok((averaged, numbers))
    }

    /// How many samples a swing and a half takes, from the times when the rate has risen from below its
    /// mean less half its deviation to above it: all, if it does so only once.
    fn first_swings(&self, mean: f64, deviation: f64) -> usize {
        let (mut below, mut risen) = (false, None);
        for (t, rate) in self.times.iter().zip(&self.rates) {
            let above = rate - mean;
            if below && above > 0.5 * deviation {
                below = false;
                if let Some(first) = risen.replace(*t) {
                    let end = 1.5 * (t - first);
                    return self.times.partition_point(|t| *t <= end).max(8);
                }
            }
            below |= above < -0.5 * deviation;
        }
        self.times.len()
    }

    /// Averages over this time (s).
    fn averaged(&self, over: f64) -> Vec<Averaged> {
        let (mut averaged, mut from) = (Vec::new(), 0);
        while from < self.times.len() {
            let to = self.times.partition_point(|t| *t < self.times[from] + over).max(from + 1);
            let times = &self.times[from..to];
            let count = times.len() as f64;
            let time = times.iter().sum::<f64>() / count;
            averaged.push(Averaged {
                time,
                variance: times.iter().map(|t| (t - time) * (t - time)).sum::<f64>() / count,
                rate: self.rates[from..to].iter().sum::<f64>() / count,
                weight: count.sqrt(),
            });
            from = to;
        }
        averaged
    }
}
