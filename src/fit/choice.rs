//! Which corrections the rates of a flight need.

use super::flight::Flight;
use super::least_squares::Fitted;
use super::model::{Correction, Model, Samples};
use super::{Fit, NORMAL, spread, start};
use crate::error::{Error, Result};
use crate::exact::free_body::FreeBody;
use crate::inertia::PrincipalMoments;
use crate::math::{exp, log};
use core::f64::consts::TAU;
use nalgebra::Matrix2;

/// A correction is needed if chance would improve the fit as much once in a thousand flights.
/// Distribution of chi squared for 1, 2 and 3 numbers.
const BY_CHANCE: [f64; 3] = [10.83, 13.82, 16.27];

/// What a number costs in the weights of the combinations. Akaike's 2 made the intervals hold the truth
/// in 99 of 100 flights, 6 in 88 of those that need all corrections; with 4 it is 94 to 98 (`tests/fit`).
const PER_NUMBER: f64 = 4.0;

/// Pieces of a flight that are fitted first, and the pieces of an integral of the start (turns).
const PIECE: f64 = 2.0;

fn threshold(correction: Correction) -> f64 {
    BY_CHANCE[correction.numbers() - 1]
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

/// What another combination of corrections says of the ratios.
#[derive(Debug, Clone)]
pub(super) struct Other {
    pub(super) weight: f64,
    /// ln(I1/I3) and ln(I2/I3).
    pub(super) log_ratios: [f64; 2],
    /// Their covariance.
    pub(super) covariance: [[f64; 2]; 2],
}

/// A combination of corrections, fitted.
struct Candidate {
    model: Model,
    fitted: Fitted,
}

impl Flight {
    /// The free body that shows these rates best, with those of the corrections that the rates need.
    ///
    /// Two ratios of moments and three rates at the start are fitted by least squares, with every
    /// combination of the corrections that are `allowed`. Chosen is the one with the least n ln S + sum of
    /// the thresholds: a correction is needed if it lowers n ln S by more than chance does once in a
    /// thousand flights: by 10.83 for one number, 16.27 for three. S is the sum of squares, n the number of
    /// independent samples less that of all numbers, from the correlation of the residuals.
    ///
    /// The interval of a ratio allows for the other combinations, each with a weight as of Akaike's: K. P.
    /// Burnham, D. R. Anderson, *Model Selection and Multimodel Inference*, 4.3.
    ///
    /// # Errors
    /// Those of [`FreeBody::new`], or `OutOfRange` of a fit without a minimum, if that is so for every
    /// combination.
    pub fn fit(&self, allowed: &[Correction]) -> Result<Fit> {
        let samples = self.samples();
        let mut candidates: Vec<Candidate> = Vec::new();
        let mut refused = None;
        for model in Model::combinations(allowed) {
            // From what the best simpler one found, too.
            let simpler = candidates.iter().filter(|other| other.model.is_part_of(&model));
            let simpler = simpler.min_by(|a, b| a.fitted.squares.total_cmp(&b.fitted.squares));
            let carried = simpler.map(|other| model.carried(&other.model, &other.fitted.numbers));
            match self.fitted(&samples, &model, carried) {
                Ok(fitted) => candidates.push(Candidate { model, fitted }),
                Err(error) => refused = Some(error),
            }
        }
        // A filter whose tau^2 is best below 0 is best without.
        candidates.retain(|of| {
            of.model.place(Correction::Filter).is_none_or(|at| of.fitted.numbers[at] >= 0.0)
        });
        match (candidates.is_empty(), refused) {
            (true, Some(refused)) => Err(refused),
            _ => self.chosen(&samples, &candidates),
        }
    }

    /// The best numbers of a model: from those of a simpler one, or from linear algebra and pieces of the
    /// flight that grow, whichever begins better.
    fn fitted(&self, samples: &Samples, model: &Model, carried: Option<Vec<f64>>) -> Result<Fitted> {
        let count = samples.times.len();
        let piece = PIECE * TAU / self.fastest();
        let resists = model.has(Correction::Offset) || model.has(Correction::Drag);
        let turns = model.has(Correction::Axes);
        let mut starts: Vec<Vec<f64>> = carried.into_iter().collect();
        for resisted in [false, true].into_iter().take(1 + usize::from(resists)) {
            let Some(mut numbers) = start::numbers(samples, piece, model, turns, resisted) else {
                continue;
            };
            let mut part = samples.times.partition_point(|t| *t < piece).max(2 * model.numbers());
            while part < count {
                if let Ok(fitted) = model.refined(&numbers, samples, part) {
                    numbers = fitted.numbers;
                }
                part *= 2;
            }
            starts.push(numbers);
        }
        starts.sort_by_cached_key(|numbers| model.squares(numbers, samples).to_bits());
        let mut refused = Error::out_of_range(
            "fastest rate",
            self.fastest(),
            "that of a body in free flight: its moments are not to be found",
        );
        for numbers in starts {
            match model.refined(&numbers, samples, count) {
                Ok(fitted) => return Ok(fitted),
                Err(error) => refused = error,
            }
        }
        Err(refused)
    }

    /// The best of all combinations, which are in the order of what they leave open.
    fn chosen(&self, samples: &Samples, candidates: &[Candidate]) -> Result<Fit> {
        let richest = &candidates[candidates.len() - 1];
        let residuals = &richest.fitted.residuals;
        let freedom = (residuals.len() - richest.model.numbers()) as f64;
        let independent = freedom / spread::inflation(residuals);
        // Digits beyond the twelfth are those of arithmetic.
        let least = 1e-24 * self.fastest() * self.fastest() * residuals.len() as f64;
        let lack = |squares: f64| independent * log(squares.max(least));
        let misfit = |of: &Candidate| lack(of.fitted.squares);
        let corrections = |of: &Candidate| {
            Correction::ALL.into_iter().filter(|c| of.model.has(*c)).collect::<Vec<_>>()
        };
        let price =
            |of: &Candidate| misfit(of) + corrections(of).into_iter().map(threshold).sum::<f64>();
        let best = candidates.iter().min_by(|a, b| price(a).total_cmp(&price(b)));
        let best = best.unwrap_or(richest);
        let decide = |correction: Correction| {
            let needed = best.model.has(correction);
            let beside = |of: &&Candidate| {
                let (more, less) = if needed { (best, *of) } else { (*of, best) };
                !less.model.has(correction) && more.model == less.model.with(correction)
            };
            let change = candidates.iter().find(beside).map(|of| (misfit(of) - misfit(best)).abs());
            let improvement = change.unwrap_or(if needed { f64::MAX } else { 0.0 });
            Decision { correction, improvement, threshold: threshold(correction), needed }
        };
        let akaike = |of: &Candidate| misfit(of) + PER_NUMBER * of.model.numbers() as f64;
        let least = candidates.iter().map(akaike).fold(f64::INFINITY, f64::min);
        let weight = |of: &Candidate| exp(0.5 * (least - akaike(of)));
        let other = |other: &Candidate| {
            let covariance = spread::covariance(&other.fitted);
            Other {
                weight: weight(other),
                log_ratios: [other.fitted.numbers[0], other.fitted.numbers[1]],
                covariance: [0, 1].map(|i| [0, 1].map(|j| covariance[(i, j)])),
            }
        };
        let steady = self.steady(samples, &best.model, &best.fitted.numbers);
        let varied = lack(steady) - misfit(best) > by_noise(samples.times.len());
        // A weight below a thousandth changes no digit that is told.
        let weighty = candidates.iter().filter(|other| varied && weight(other) > 1e-3);
        let named = best.model.named(&best.fitted.numbers)?;
        let moments = PrincipalMoments::of_any(named.moments)?;
        Ok(Fit {
            covariance: spread::covariance(&best.fitted),
            // Student's t of so many degrees of freedom, to first order in their inverse.
            confidence: NORMAL * (1.0 + (1.0 + NORMAL * NORMAL) / (4.0 * independent)),
            decisions: corrections(richest).into_iter().map(decide).collect(),
            others: weighty.map(other).collect(),
            moments: named.moments,
            motion: FreeBody::new(moments, named.turn, named.start)?,
            shown: best.model.rates(&best.fitted.numbers, &self.times)?,
            model: best.model.clone(),
            fitted: best.fitted.clone(),
            flight: self.clone(),
        })
    }

    /// The least sum of squares of a spin about a line that is fixed in the body, with the drag and the
    /// offset of a fit: a e^(-gamma t) + b on each axis, b = 0 without an offset.
    fn steady(&self, samples: &Samples, model: &Model, numbers: &[f64]) -> f64 {
        let drag = model.place(Correction::Drag).map_or(0.0, |at| numbers[at]);
        // Without drag, an offset shows as nothing but another rate.
        let offset = model.has(Correction::Offset) && drag != 0.0;
        let terms = |k: usize| {
            let weight = samples.weights[k];
            [weight * exp(-drag * samples.times[k]), if offset { weight } else { 0.0 }]
        };
        let pairs = (0..samples.times.len()).map(terms);
        let mut normal = Matrix2::zeros();
        for [a, b] in pairs.clone() {
            normal += Matrix2::new(a * a, a * b, a * b, b * b);
        }
        if !offset {
            normal[(1, 1)] = 1.0;
        }
        let Some(inverse) = normal.try_inverse() else { return f64::INFINITY };
        let left = |axis: usize| {
            let seen = (0..samples.times.len()).map(|k| samples.weights[k] * samples.rates[k][axis]);
            let (mut first, mut second) = (0.0, 0.0);
            for ([a, b], w) in pairs.clone().zip(seen.clone()) {
                first += a * w;
                second += b * w;
            }
            let x = inverse[(0, 0)] * first + inverse[(0, 1)] * second;
            let y = inverse[(1, 0)] * first + inverse[(1, 1)] * second;
            let left = pairs.clone().zip(seen).map(|([a, b], w)| w - a * x - b * y);
            left.map(|left| left * left).sum::<f64>()
        };
        (0..3).map(left).sum()
    }
}

/// By how much n ln S falls once in a thousand flights if a fit takes noise beside a steady spin for a wobble:
/// a sine and a cosine on each of two axes, chi squared of four, with the best of as many frequencies as
/// there are samples. 1000 M e^(-x/2) (1 + x/2) = 1.
fn by_noise(samples: usize) -> f64 {
    let mut x = 20.0;
    for _ in 0..20 {
        x = 2.0 * log(1e3 * samples as f64 * (1.0 + 0.5 * x));
    }
    x
}
