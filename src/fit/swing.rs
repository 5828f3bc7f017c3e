//! A pendulum's length, amplitude and damping from the rate about its hinge.
//!
//! A phone that is taped to a rod, or swings on a hinge, records
//!
//! ```text
//! theta'' = -W^2 sin(theta) - gamma theta' - beta |theta'| theta',   W^2 = g/length,
//! ```
//!
//! with theta from the hanging position. Fitted is the exact equation, for swings of any size below the
//! upright position: without damping by the closed form ([`crate::exact::pendulum`]), else by
//! [`Dop853`](crate::integrators::Dop853).
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

use super::{Estimate, Flight, NORMAL, OPEN, least_squares, spread};
use crate::error::{Error, Result, positive};
use crate::exact::carlson::rf;
use crate::frame::DesignVector;
use crate::math::{asin, exp, log, sin};
use course::{Numbers, STEP};
use nalgebra::{DMatrix, DVector, Matrix3, SymmetricEigen, Vector3};

/// Below this part of the rates residuals count as none: averages and the integrator leave as much.
const FLOOR: f64 = 1e-5;

/// A damping is needed if chance would improve the fit as much once in a thousand swings: chi squared of
/// one number.
const BY_CHANCE: f64 = 10.83;

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

/// A damping that a swing may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Damping {
    /// gamma theta': air in slow motion, a greased hinge.
    Linear,
    /// beta |theta'| theta': air in fast motion.
    Quadratic,
}

/// Whether a damping is needed, and by how much the fit is better with it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SwingDecision {
    /// Which.
    pub damping: Damping,
    /// n ln(S/S'), with the sums S and S' of squares without and with it, as of [`Swing::fit`].
    pub improvement: f64,
    /// What chance reaches once in a thousand swings.
    pub threshold: f64,
    /// Whether the fit has it.
    pub needed: bool,
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
    /// Those of [`Flight::new`]; `OutOfRange` if the mean of the rates exceeds their standard deviation: then
    /// it does not go to and fro.
    pub fn new(times: Vec<f64>, rates: Vec<f64>) -> Result<Self> {
        let along = rates.iter().map(|rate| DesignVector::new(*rate, 0.0, 0.0)).collect();
        let Flight { times, begin, .. } = Flight::new(times, along)?;
        let swing = Self { times, begin, rates, hinge: None };
        let (mean, deviation) = swing.mean();
        if mean.abs() > deviation {
            let allowed = format!(
                "at most {deviation:.3} rad/s, the deviation from it: a swing goes to and fro, and this \
                 goes one way, over the top, or for less than a whole swing"
            );
            return Err(Error::out_of_range("mean rate", mean, allowed));
        }
        Ok(swing)
    }

    /// A swing from all three rates (rad/s), on the sensor's axes: the one about the direction in which they
    /// change most, the first eigenvector of their covariance.
    ///
    /// # Errors
    /// As of [`Swing::new`].
    pub fn of_sensor(times: Vec<f64>, rates: Vec<DesignVector>) -> Result<Self> {
        let flight = Flight::new(times, rates)?;
        let count = flight.rates.len() as f64;
        let vectors = || flight.rates.iter().map(|rate| Vector3::from(*rate));
        let mean = vectors().sum::<Vector3<f64>>() / count;
        let covariance: Matrix3<f64> =
            vectors().map(|rate| (rate - mean) * (rate - mean).transpose() / count).sum();
        let principal = SymmetricEigen::new(covariance);
        let first = principal.eigenvalues.imax();
        let axis = principal.eigenvectors.column(first);
        let axis = axis * axis[axis.iamax()].signum();
        let along = principal.eigenvalues[first];
        let wobble = ((covariance.trace() - along).max(0.0) / along).sqrt();
        let about = vectors().map(|rate| rate.dot(&axis)).collect();
        let hinge = Some(Hinge { axis: DesignVector::new(axis.x, axis.y, axis.z), wobble });
        Ok(Self { hinge, ..Self::new(flight.times().collect(), about)? })
    }

    /// The hinge, if three rates were given.
    pub fn hinge(&self) -> Option<Hinge> {
        self.hinge
    }

    /// The times as they were given (s).
    pub fn times(&self) -> impl Iterator<Item = f64> {
        self.times.iter().map(|t| t + self.begin)
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
    /// [`Flight::fit`], and intervals allow for the others in the same way. Samples are averaged down
    /// to 31 in a small swing, which no swing outruns; the fit allows for the average. A negative
    /// quadratic damping beside a linear one is a sign of dry friction, which the equation lacks.
    ///
    /// # Errors
    /// `OutOfRange` with what was found and what is allowed: for rates of which no pendulum explains three
    /// quarters of the variance, for one that goes over the top, for fewer than six samples in a small
    /// swing, and if the length is open by more than a factor of two.
    pub fn fit(&self) -> Result<SwingFit> {
        let (mean, deviation) = self.mean();
        let window = self.first_swings(mean, deviation);
        let starts = [mean, 0.0]
            .map(|offset| course::start(&self.times[..window], &self.rates[..window], offset));
        let best = starts.into_iter().flatten().min_by(|a, b| a.1.total_cmp(&b.1));
        let none = || Error::out_of_range("deviation of the rates", deviation, "that of a swing");
        let (mut numbers, _) = best.ok_or_else(none)?;
        let averaged = self.averaged(STEP * exp(-0.5 * numbers[0]));
        // Linear damping serves for any, while ever more swings are fitted.
        let mut part = averaged.iter().take_while(|a| a.time <= self.times[window - 1]).count();
        part = part.max(8);
        while part < averaged.len() {
            let fitted = Candidate::new([true, false], numbers, &averaged[..part]);
            numbers = fitted.map_or(numbers, |fitted| fitted.numbers);
            part *= 3;
        }
        let linear = Candidate::new([true, false], numbers, &averaged)?;
        // What loses as much energy: beta |rate|^3 for gamma rate^2.
        let power = |n| self.rates.iter().map(|rate| (rate - mean).abs().powi(n)).sum::<f64>();
        numbers = linear.numbers;
        numbers[5] = numbers[4] * power(2) / power(3);
        let quadratic = Candidate::new([false, true], numbers, &averaged);
        let better = quadratic.iter().find(|of| of.squares < linear.squares).unwrap_or(&linear);
        let both = Candidate::new([true; 2], better.numbers, &averaged);
        let free = Candidate::new([false; 2], linear.numbers, &averaged);
        let candidates = [free, Ok(linear), quadratic, both].into_iter().flatten().collect();
        let square = |a: &Averaged| f64::powi(a.weight * (a.rate - mean), 2);
        SwingFit::chosen(candidates, averaged.iter().map(square).sum(), self)
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

/// A pendulum with or without each damping, fitted.
#[derive(Debug, Clone)]
struct Candidate {
    damped: [bool; 2],
    numbers: Numbers,
    residuals: Vec<f64>,
    squares: f64,
    /// Of the numbers, with zeros for a damping that it lacks; for independent residuals of variance 1.
    covariance: Option<DMatrix<f64>>,
}

impl Candidate {
    /// The best near these numbers.
    fn new(damped: [bool; 2], mut numbers: Numbers, averaged: &[Averaged]) -> Result<Self> {
        let open: Vec<usize> = (0..6).filter(|i| *i < 4 || damped[i - 4]).collect();
        let all = |values: &[f64]| {
            let mut numbers = [0.0; 6];
            open.iter().zip(values).for_each(|(i, value)| numbers[*i] = *value);
            numbers
        };
        let fastest = averaged.iter().fold(0.0, |most: f64, a| most.max(a.rate.abs()));
        let frequency = exp(0.5 * numbers[0]);
        let scales = [1.0, 1.0, fastest, fastest, frequency, frequency / fastest];
        let [start, scales] = [&numbers, &scales].map(|x| open.iter().map(|i| x[*i]).collect());
        let (start, scales): (Vec<f64>, Vec<f64>) = (start, scales);
        let mut residuals = |values: &[f64]| {
            let numbers = all(values);
            // Beyond a factor of e the start has missed the frequency, and a step takes too long.
            if !((values[0] - start[0]).abs() <= 2.0) {
                let allowed = format!("within 2 of {}", start[0]);
                return Err(Error::out_of_range("ln W^2", values[0], allowed));
            }
            let states = course::states(&numbers, averaged.iter().map(|a| a.time))?;
            let one = |(a, state): (&Averaged, [f64; 2])| {
                let bent = 0.5 * a.variance * course::second_derivative(&numbers, state);
                a.weight * (state[1] + bent + numbers[3] - a.rate)
            };
            Ok(averaged.iter().zip(states).map(one).collect())
        };
        let fitted = least_squares::fit(&start, &scales, &mut residuals)?;
        numbers = all(&fitted.numbers);
        let scaled = DMatrix::from_diagonal(&DVector::from_vec(scales));
        let jacobian = fitted.jacobian * &scaled;
        let inverse = jacobian.tr_mul(&jacobian).cholesky().map(|factors| factors.inverse());
        let covariance = inverse.map(|inverse| {
            let own = &scaled * inverse * &scaled;
            let mut covariance = DMatrix::zeros(6, 6);
            for (i, row) in open.iter().enumerate() {
                for (j, column) in open.iter().enumerate() {
                    covariance[(*row, *column)] = own[(i, j)];
                }
            }
            covariance
        });
        let (residuals, squares) = (fitted.residuals, fitted.squares);
        Ok(Self { damped, numbers, residuals, squares, covariance })
    }

    fn dampings(&self) -> usize {
        self.damped.iter().filter(|damped| **damped).count()
    }
}

/// The pendulum that fits a swing. Times are those of the recording (s).
#[derive(Debug, Clone)]
pub struct SwingFit {
    swing: Swing,
    best: Candidate,
    /// All, with the weight of each.
    candidates: Vec<(Candidate, f64)>,
    decisions: [SwingDecision; 2],
    /// Angle and rate at each sample.
    states: Vec<[f64; 2]>,
}

impl SwingFit {
    /// The best of those that were found; `whole`: the squares that a rate without change leaves.
    fn chosen(mut candidates: Vec<Candidate>, whole: f64, swing: &Swing) -> Result<Self> {
        let samples = swing.times.len() as f64;
        let richest = &candidates[candidates.len() - 1].residuals;
        let count = richest.len();
        // Of one axis, as the first of three.
        let alone: Vec<f64> = richest.iter().flat_map(|r| [*r, 0.0, 0.0]).collect();
        let inflation = spread::inflation(&alone);
        let floor = samples * f64::powi(FLOOR * swing.mean().1, 2);
        for candidate in &mut candidates {
            let degrees = (count - 4 - candidate.dampings()) as f64;
            let variance = (candidate.squares + floor) / degrees * inflation;
            candidate.covariance = candidate.covariance.take().map(|c| c * variance);
        }
        let misfit = |of: &Candidate| count as f64 / inflation * log(of.squares + floor);
        let price = |of: &Candidate| misfit(of) + BY_CHANCE * of.dampings() as f64;
        let best = candidates.iter().min_by(|a, b| price(a).total_cmp(&price(b)));
        let best = best.unwrap_or(&candidates[0]);
        let decisions = [(Damping::Linear, 0), (Damping::Quadratic, 1)].map(|(damping, i)| {
            let needed = best.damped[i];
            let mut twin = best.damped;
            twin[i] = !needed;
            let twin = candidates.iter().find(|other| other.damped == twin);
            let change = twin.map(|twin| (misfit(twin) - misfit(best)).abs());
            let improvement = change.unwrap_or(if needed { f64::MAX } else { 0.0 });
            SwingDecision { damping, improvement, threshold: BY_CHANCE, needed }
        });
        let akaike = |of: &Candidate| misfit(of) + 4.0 * of.dampings() as f64;
        let least = candidates.iter().map(akaike).fold(f64::INFINITY, f64::min);
        let weighed = |of: &Candidate| (of.clone(), exp(0.5 * (least - akaike(of))));
        let fit = Self {
            states: course::states(&best.numbers, swing.times.iter().copied())?,
            best: best.clone(),
            candidates: candidates.iter().map(weighed).collect(),
            decisions,
            swing: swing.clone(),
        };
        let unexplained = fit.best.squares / whole;
        fit.checked(unexplained, swing.times[swing.times.len() - 1] / (samples - 1.0))
    }

    /// Refuses what is no swing, or an open one.
    fn checked(self, unexplained: f64, step: f64) -> Result<Self> {
        if !(unexplained <= 0.25) {
            let allowed = "at most 0.25: these rates are no pendulum's";
            return Err(Error::out_of_range(
                "unexplained part of the variance",
                unexplained,
                allowed,
            ));
        }
        let energy = energy(&self.best.numbers);
        if energy >= 1.0 {
            let allowed = "below 1: fitted are swings to and fro, and this goes over the top";
            return Err(Error::out_of_range("energy over that of upright", energy, allowed));
        }
        let unit = exp(-0.5 * self.best.numbers[0]);
        if step > unit {
            let allowed = format!("at most {unit:.2e} s, six in a small swing");
            return Err(Error::out_of_range("mean time between samples", step, allowed));
        }
        let square = self.estimate(|numbers| numbers[0]);
        let factor = exp(0.5 * (square.to - square.from));
        if factor <= OPEN && self.best.covariance.is_some() {
            return Ok(self);
        }
        let allowed = "at most 2: the recording is too short or too noisy to tell the length";
        Err(Error::out_of_range("factor by which the length is open", factor, allowed))
    }

    /// An estimate of a function of the numbers: the interval has the variance of the best, or that of all
    /// with their weights, whichever is larger.
    fn estimate(&self, of: impl Fn(&Numbers) -> f64) -> Estimate {
        let own = |candidate: &Candidate| {
            let Some(covariance) = &candidate.covariance else { return 0.0 };
            let slope = |i: usize| {
                // A hundredth of the deviation: small, and far above round-off.
                let step = 0.01 * covariance[(i, i)].sqrt();
                let aside = |step: f64| {
                    let mut numbers = candidate.numbers;
                    numbers[i] += step;
                    of(&numbers)
                };
                if step > 0.0 { (aside(step) - aside(-step)) / (2.0 * step) } else { 0.0 }
            };
            let slopes = DVector::from_fn(6, |i, _| slope(i));
            slopes.dot(&(covariance * &slopes))
        };
        let value = of(&self.best.numbers);
        let (mut whole, mut sum) = (0.0, 0.0);
        // A weight below a thousandth changes no digit that is told.
        for (candidate, weight) in self.candidates.iter().filter(|(_, weight)| *weight > 1e-3) {
            whole += weight;
            sum += weight * (own(candidate) + f64::powi(of(&candidate.numbers) - value, 2));
        }
        let half = NORMAL * own(&self.best).max(sum / whole).sqrt();
        Estimate { value, from: value - half, to: value + half }
    }

    /// An estimate of a positive function, by that of its logarithm.
    fn positive(&self, of: impl Fn(&Numbers) -> f64) -> Estimate {
        let Estimate { value, from, to } = self.estimate(|numbers| log(of(numbers)));
        Estimate { value: exp(value), from: exp(from), to: exp(to) }
    }

    /// The length g/W^2 (m) of the simple pendulum that swings alike, where gravity is `gravity` (m/s^2).
    ///
    /// # Errors
    /// `OutOfRange` unless gravity is positive and finite.
    pub fn length(&self, gravity: f64) -> Result<Estimate> {
        positive("gravity", gravity)?;
        Ok(self.positive(|numbers| gravity * exp(-numbers[0])))
    }

    /// The amplitude (rad) of the swing with which the recording begins: 2 asin k, k^2 the energy at the
    /// start over that of the upright position.
    pub fn amplitude(&self) -> Estimate {
        self.estimate(|numbers| 2.0 * asin(energy(numbers).min(1.0).sqrt()))
    }

    /// The period (s) at that amplitude without damping: 4 K(k)/W.
    pub fn period(&self) -> Estimate {
        let quarter =
            |numbers: &Numbers| rf(0.0, 1.0 - energy(numbers), 1.0).unwrap_or(f64::INFINITY);
        self.positive(|numbers| 4.0 * quarter(numbers) * exp(-0.5 * numbers[0]))
    }

    /// The period 2 pi/W of the smallest swings (s).
    pub fn small_period(&self) -> Estimate {
        self.positive(|numbers| core::f64::consts::TAU * exp(-0.5 * numbers[0]))
    }

    /// The sensor's offset (rad/s).
    pub fn offset(&self) -> Estimate {
        self.estimate(|numbers| numbers[3])
    }

    /// The linear damping gamma (1/s), if it is needed.
    pub fn linear(&self) -> Option<Estimate> {
        self.best.damped[0].then(|| self.estimate(|numbers| numbers[4]))
    }

    /// The quadratic damping beta (1/rad), if it is needed.
    pub fn quadratic(&self) -> Option<Estimate> {
        self.best.damped[1].then(|| self.estimate(|numbers| numbers[5]))
    }

    /// Of each damping, whether it is needed.
    pub fn decisions(&self) -> &[SwingDecision] {
        &self.decisions
    }

    /// What the sensor shows at this time by the fit, its offset included (rad/s).
    ///
    /// # Errors
    /// `OutsideRun` outside the recording.
    pub fn rate(&self, t: f64) -> Result<f64> {
        Ok(self.state(t)?[1] + self.best.numbers[3])
    }

    /// The angle from the hanging position at this time by the fit (rad).
    ///
    /// # Errors
    /// As of [`SwingFit::rate`].
    pub fn angle(&self, t: f64) -> Result<f64> {
        Ok(self.state(t)?[0])
    }

    /// Angle and rate, from those at the sample before.
    fn state(&self, t: f64) -> Result<[f64; 2]> {
        let Swing { times, begin, .. } = &self.swing;
        let (since, end) = (t - begin, begin + times[times.len() - 1]);
        let before = times.partition_point(|sample| *sample <= since);
        if before == 0 || !(t <= end) {
            crate::error::finite("t", t)?;
            return Err(Error::OutsideRun { t, start: *begin, end });
        }
        let (from, state) = (times[before - 1], self.states[before - 1]);
        Ok(course::advanced(&self.best.numbers, state, since - from))
    }

    /// The fit less the recorded rate, sample by sample (rad/s).
    pub fn residuals(&self) -> impl Iterator<Item = f64> {
        let pairs = self.states.iter().zip(&self.swing.rates);
        pairs.map(|([_, shown], rate)| shown + self.best.numbers[3] - rate)
    }

    /// The root of the mean square of the residuals (rad/s).
    pub fn misfit(&self) -> f64 {
        let squares: f64 = self.residuals().map(|r| r * r).sum();
        (squares / self.states.len() as f64).sqrt()
    }
}

/// k^2 at the start: the energy over that of the upright position.
fn energy(&[log_square, angle, rate, ..]: &Numbers) -> f64 {
    let (half, swing) = (sin(0.5 * angle), 0.5 * rate * exp(-0.5 * log_square));
    half * half + swing * swing
}
