//! Moments of inertia from the rates that a gyroscope recorded in free flight.
//!
//! The rates of a free body are known in closed form ([`FreeBody`]), so a fit needs no stepping. Only
//! ratios of moments can be known: a body with all moments doubled turns the same way. A sensor with
//! one axis mirrored cannot be told either: its rates are those of another body.
//!
//! Accuracy: 500 flights of a phone were made, of 0.5 to 1.2 s at 100 samples a second, with noise, and each
//! [`Correction`] in every second of them. A flight told a ratio in 82 to 98 of 100 cases, and the stated
//! interval of 95 per cent held the true one in 94 to 95 of 100 (`tests/fit.rs`). A fit with all
//! corrections takes about half a second, without any 3 ms.
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
//! assert_eq!(fit.middle_axis(), 1);
//! # Ok(())
//! # }
//! ```
//!
//! Source: M. S. Wheatland and others, *Am. J. Phys.* 89, 342 (2021), for the experiment with a phone.

mod least_squares;
mod model;
mod spread;
mod start;

use crate::error::{Error, Result};
use crate::exact::free_body::FreeBody;
use crate::frame::{BodyVector, DesignVector};
use crate::inertia::PrincipalMoments;
use crate::math::{exp, log};
use least_squares::Fitted;
pub use model::Correction;
use model::Model;
use nalgebra::{DMatrix, DVector};

/// The fewest samples of a flight: as many as all corrections leave numbers open, three rates for each.
const FEWEST: usize = 13;

/// A correction is needed if chance would improve the fit as much once in a thousand flights.
/// Distribution of chi squared for 1, 2 and 3 numbers.
const BY_CHANCE: [f64; 3] = [10.83, 13.82, 16.27];

/// What a number costs in the weights of the combinations. Akaike's 2 made the intervals hold the truth
/// in 99 of 100 flights, 6 in 88 of those that need all corrections; with 4 it is 94 to 98 (`tests/fit`).
const PER_NUMBER: f64 = 4.0;

fn threshold(correction: Correction) -> f64 {
    BY_CHANCE[correction.numbers() - 1]
}

/// Half an interval of 95 per cent, in standard deviations.
const CONFIDENCE: f64 = 1.96;

/// A ratio of moments is not determined if its interval spans more than this factor up or down: a phone
/// then looks like a cube.
const OPEN: f64 = 2.0;

/// The rates of one flight, as a sensor that is fixed to the body recorded them.
#[derive(Debug, Clone, PartialEq)]
pub struct Flight {
    /// In s after the first.
    times: Vec<f64>,
    begin: f64,
    rates: Vec<[f64; 3]>,
}

impl Flight {
    /// A flight: `times` (s), ascending, and the rates (rad/s) on the sensor's axes.
    ///
    /// # Errors
    /// `Lengths` if there are not as many rates as times, or fewer than 13; `AtIndex` for a time or
    /// rate that is not finite and a time that is not later than the one before; `OutOfRange` if
    /// nothing turns.
    pub fn new(times: Vec<f64>, rates: Vec<DesignVector>) -> Result<Self> {
        if rates.len() != times.len() {
            return Err(Error::Lengths {
                name: "rates",
                found: rates.len(),
                expected: times.len(),
            });
        }
        if times.len() < FEWEST {
            return Err(Error::Lengths { name: "samples", found: times.len(), expected: FEWEST });
        }
        let at = |name, index, value| Error::AtIndex {
            name,
            index,
            reason: Box::new(Error::NotFinite { name, value }),
        };
        for (index, (t, rate)) in times.iter().zip(&rates).enumerate() {
            if !t.is_finite() {
                return Err(at("times", index, *t));
            }
            if let Some(value) = rate.to_array().into_iter().find(|w| !w.is_finite()) {
                return Err(at("rates", index, value));
            }
            if index > 0 && *t <= times[index - 1] {
                let reason =
                    Error::out_of_range("time", *t, format!("later than {} s", times[index - 1]));
                return Err(Error::AtIndex { name: "times", index, reason: Box::new(reason) });
            }
        }
        let begin = times[0];
        let times = times.iter().map(|t| t - begin).collect();
        let rates: Vec<[f64; 3]> = rates.iter().map(|rate| rate.to_array()).collect();
        let flight = Self { times, begin, rates };
        if flight.fastest() == 0.0 {
            return Err(Error::out_of_range(
                "fastest rate",
                0.0,
                "above 0: what does not turn shows no moments",
            ));
        }
        Ok(flight)
    }

    /// The times as they were given (s).
    pub fn times(&self) -> impl Iterator<Item = f64> {
        self.times.iter().map(|t| t + self.begin)
    }

    /// The rates as they were given (rad/s).
    pub fn rates(&self) -> impl Iterator<Item = DesignVector> {
        self.rates.iter().map(|rate| DesignVector::from(*rate))
    }

    fn fastest(&self) -> f64 {
        self.rates.iter().flatten().fold(0.0, |most, w| most.max(w.abs()))
    }

    /// The free body that shows these rates best, with those of the corrections that the rates need.
    ///
    /// Two ratios of moments and three rates at the start are fitted by least squares, with every
    /// combination of the corrections that are `allowed`. Chosen is the one with the least n ln S + sum of
    /// the thresholds: a correction is needed if it lowers n ln S by more than chance does once in a
    /// thousand flights. S is the sum of squares, n the number of independent samples, from the
    /// correlation of the residuals.
    ///
    /// The interval of a ratio allows for the other combinations, each with a weight as of Akaike's: K. P.
    /// Burnham, D. R. Anderson, *Model Selection and Multimodel Inference*, 4.3.
    ///
    /// # Errors
    /// Those of [`FreeBody::new`], if every combination is refused.
    pub fn fit(&self, allowed: &[Correction]) -> Result<Fit> {
        let mut candidates: Vec<Candidate> = Vec::new();
        let mut refused = None;
        for model in Model::combinations(allowed) {
            // From what the best simpler one found, too.
            let simpler = candidates.iter().filter(|other| other.model.is_part_of(&model));
            let simpler = simpler.min_by(|a, b| a.fitted.squares.total_cmp(&b.fitted.squares));
            let carried = simpler.map(|other| model.carried(&other.model, &other.fitted.numbers));
            match self.fitted(&model, carried) {
                Ok(fitted) => candidates.push(Candidate { model, fitted }),
                Err(error) => refused = Some(error),
            }
        }
        match (candidates.is_empty(), refused) {
            (true, Some(refused)) => Err(refused),
            _ => Fit::chosen(&candidates, self),
        }
    }

    /// The best numbers of a model: from these, or from linear algebra with and without what the model
    /// may have, whichever fits best.
    fn fitted(&self, model: &Model, carried: Option<Vec<f64>>) -> Result<Fitted> {
        let resists = model.has(Correction::Offset) || model.has(Correction::Drag);
        let turns = model.has(Correction::Axes);
        let ways = [(false, false), (turns, resists), (turns, false), (false, resists)];
        let ways = ways.into_iter().enumerate().filter(|(n, way)| !ways[..*n].contains(way));
        let starts = ways
            .filter_map(|(_, (turned, resisted))| start::numbers(self, model, turned, resisted));
        let found = starts.map(|numbers| self.lengthened(model, numbers));
        let carried = carried.map(|numbers| self.refined(model, &numbers, self.times.len()));
        let squares =
            |fitted: &Result<Fitted>| fitted.as_ref().map_or(f64::INFINITY, |f| f.squares);
        let best = found.chain(carried).min_by(|a, b| squares(a).total_cmp(&squares(b)));
        best.unwrap_or_else(|| {
            Err(Error::out_of_range(
                "fastest rate",
                self.fastest(),
                "that of a body in free flight",
            ))
        })
    }

    /// The best numbers for an eighth of the flight, from there for a quarter, and so on.
    fn lengthened(&self, model: &Model, mut numbers: Vec<f64>) -> Result<Fitted> {
        let count = self.times.len();
        for part in [count / 8, count / 4, count / 2] {
            if 3 * part >= 4 * model.numbers() {
                numbers = self.refined(model, &numbers, part)?.numbers;
            }
        }
        self.refined(model, &numbers, count)
    }

    /// The best numbers near these, for the first samples.
    fn refined(&self, model: &Model, numbers: &[f64], samples: usize) -> Result<Fitted> {
        let mut residuals = |numbers: &[f64]| {
            let shown = model.rates(numbers, &self.times[..samples])?;
            let pairs = shown.iter().zip(&self.rates);
            Ok(pairs.flat_map(|(shown, seen)| [0, 1, 2].map(|i| shown[i] - seen[i])).collect())
        };
        least_squares::fit(numbers, &model.scales(self.fastest()), &mut residuals)
    }
}

/// Whether a correction is needed, and by how much the fit is better with it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decision {
    /// Which.
    pub correction: Correction,
    /// n ln(S/S'), with the sums S and S' of squares without and with it, as of [`Flight::fit`].
    pub improvement: f64,
    /// What chance reaches once in a thousand flights.
    pub threshold: f64,
    /// Whether the fit has it.
    pub needed: bool,
}

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

/// A combination of corrections, fitted.
struct Candidate {
    model: Model,
    fitted: Fitted,
}

/// What another combination of corrections says of the ratios.
#[derive(Debug, Clone)]
struct Other {
    weight: f64,
    /// ln(I1/I3) and ln(I2/I3).
    log_ratios: [f64; 2],
    /// Their covariance.
    covariance: [[f64; 2]; 2],
}

/// The free body that fits a flight.
#[derive(Debug, Clone)]
pub struct Fit {
    model: Model,
    fitted: Fitted,
    covariance: Option<DMatrix<f64>>,
    decisions: Vec<Decision>,
    others: Vec<Other>,
    moments: [f64; 3],
    motion: FreeBody,
    begin: f64,
}

impl Fit {
    /// The best of all combinations, which are in the order of what they leave open.
    fn chosen(candidates: &[Candidate], flight: &Flight) -> Result<Self> {
        let richest = &candidates[candidates.len() - 1];
        let residuals = &richest.fitted.residuals;
        let independent = residuals.len() as f64 / spread::inflation(residuals);
        let misfit = |of: &Candidate| independent * log(of.fitted.squares.max(f64::MIN_POSITIVE));
        let price = |of: &Candidate| {
            let corrections = of.model.corrections();
            misfit(of) + corrections.iter().map(|c| threshold(*c)).sum::<f64>()
        };
        let best = candidates.iter().min_by(|a, b| price(a).total_cmp(&price(b)));
        let best = best.unwrap_or(richest);
        let decide = |correction: Correction| {
            let needed = best.model.has(correction);
            let other =
                if needed { best.model.without(correction) } else { best.model.with(correction) };
            let other = candidates.iter().find(|candidate| candidate.model == other)?;
            let worse = misfit(other) - misfit(best);
            let improvement = if needed { worse } else { (-worse).max(0.0) };
            Some(Decision { correction, improvement, threshold: threshold(correction), needed })
        };
        let akaike = |of: &Candidate| misfit(of) + PER_NUMBER * of.model.numbers() as f64;
        let least = candidates.iter().map(akaike).fold(f64::INFINITY, f64::min);
        // A weight below a thousandth changes no digit that is told.
        let weight = |of: &Candidate| exp(0.5 * (least - akaike(of)));
        let others = candidates.iter().filter(|other| weight(other) > 1e-3).filter_map(|other| {
            let covariance = spread::covariance(&other.fitted)?;
            Some(Other {
                weight: weight(other),
                log_ratios: [other.fitted.numbers[0], other.fitted.numbers[1]],
                covariance: [0, 1].map(|i| [0, 1].map(|j| covariance[(i, j)])),
            })
        });
        let named = best.model.named(&best.fitted.numbers)?;
        let moments = PrincipalMoments::of_any(named.moments)?;
        Ok(Self {
            covariance: spread::covariance(&best.fitted),
            decisions: richest.model.corrections().into_iter().filter_map(decide).collect(),
            others: others.collect(),
            moments: named.moments,
            motion: FreeBody::new(moments, named.turn, named.start)?,
            begin: flight.begin,
            model: best.model.clone(),
            fitted: best.fitted.clone(),
        })
    }

    /// The estimate of f = a . numbers, and its standard deviation.
    fn linear(&self, weights: &[(usize, f64)]) -> Option<(f64, f64)> {
        let covariance = self.covariance.as_ref()?;
        let mut vector = DVector::zeros(self.fitted.numbers.len());
        for (i, weight) in weights {
            vector[*i] += *weight;
        }
        let value = vector.iter().zip(&self.fitted.numbers).map(|(a, x)| a * x).sum();
        let variance = vector.dot(&(covariance * &vector));
        variance.is_finite().then(|| (value, variance.max(0.0).sqrt()))
    }

    /// The ratio I_i/I_j of the moments about the principal axes `i` and `j` (0, 1, 2); `None` if the
    /// flight does not determine it: its interval would reach beyond twice or half the value.
    ///
    /// # Panics
    /// For an axis above 2.
    pub fn ratio(&self, i: usize, j: usize) -> Option<Estimate> {
        assert!(i < 3 && j < 3, "axes {i}, {j}: there are 0, 1 and 2");
        // I3 is 1, and its logarithm 0.
        let weight = |axis: usize| f64::from(u8::from(i == axis)) - f64::from(u8::from(j == axis));
        let weights = [weight(0), weight(1)];
        let (value, deviation) = self.linear(&[(0, weights[0]), (1, weights[1])])?;
        let (mut whole, mut sum) = (0.0, 0.0);
        for other in &self.others {
            let dot = |v: &[f64; 2]| weights[0] * v[0] + weights[1] * v[1];
            let apart = dot(&other.log_ratios) - value;
            let own = dot(&other.covariance.each_ref().map(dot));
            whole += other.weight;
            sum += other.weight * (own + apart * apart);
        }
        let half = CONFIDENCE * (sum / whole).max(deviation * deviation).sqrt();
        let [value, from, to] = [value, value - half, value + half].map(exp);
        (half <= log(OPEN)).then_some(Estimate { value, from, to })
    }

    /// The values of a correction that is needed, with their intervals; none if it is not.
    pub fn correction(&self, correction: Correction) -> Vec<Estimate> {
        let Some(at) = self.model.place(correction) else { return Vec::new() };
        let estimate = |i: usize| {
            let (value, deviation) = self.linear(&[(i, 1.0)])?;
            let half = CONFIDENCE * deviation;
            Some(Estimate { value, from: value - half, to: value + half })
        };
        (at..at + correction.numbers()).filter_map(estimate).collect()
    }

    /// What was tried, and whether it was needed, in the order of [`Correction`].
    pub fn decisions(&self) -> &[Decision] {
        &self.decisions
    }

    /// The moments, with I3 = 1. Those that a flat body's noisy rates fit best may exceed the sum of the
    /// other two by a little.
    pub fn moments(&self) -> [f64; 3] {
        self.moments
    }

    /// The principal axis (0, 1, 2) with the middle moment.
    pub fn middle_axis(&self) -> usize {
        crate::math::order_of_three(self.moments)[1]
    }

    /// 2 E I_mid/L^2: 1 on the separatrix; below 1 the momentum circles the axis of the largest moment, above
    /// 1 that of the least.
    pub fn separatrix(&self) -> f64 {
        let momentum = self.motion.angular_momentum();
        let middle = self.moments[self.middle_axis()];
        2.0 * self.motion.kinetic_energy() * middle / momentum.dot(&momentum)
    }

    /// The free body, at t = 0 at the first sample: its attitude there is that of its principal axes on
    /// the sensor's.
    pub const fn motion(&self) -> &FreeBody {
        &self.motion
    }

    /// The rates at the start, on the principal axes (rad/s).
    pub fn start(&self) -> BodyVector {
        self.motion.angular_velocity(0.0)
    }

    /// What the sensor shows at this time by the fit (rad/s).
    ///
    /// # Errors
    /// Those of [`FreeBody::kinematics_at`].
    pub fn rates(&self, t: f64) -> Result<DesignVector> {
        let shown = self.model.rates(&self.fitted.numbers, &[t - self.begin])?;
        Ok(DesignVector::from(shown[0]))
    }

    /// The fit less the recorded rates, sample by sample (rad/s).
    pub fn residuals(&self) -> impl Iterator<Item = DesignVector> {
        self.fitted.residuals.chunks(3).map(|r| DesignVector::new(r[0], r[1], r[2]))
    }

    /// The root of the mean square of the residuals (rad/s).
    pub fn misfit(&self) -> f64 {
        (self.fitted.squares / self.fitted.residuals.len() as f64).sqrt()
    }

    /// How often the rates of the whole flight were computed for the last fit.
    pub fn evaluations(&self) -> usize {
        self.fitted.evaluations
    }
}
