//! Which corrections the rates of a flight need.

use super::flight::Flight;
use super::least_squares::{self, Fitted};
use super::model::{Correction, Model, Named, Samples};
use super::{Fit, NORMAL, kept, spread, start};
use crate::error::{Error, Result};
use crate::exact::free_body::FreeBody;
use crate::inertia::PrincipalMoments;
use crate::math::{exp, log, sincos};
use core::f64::consts::{PI, TAU};
use nalgebra::{DMatrix, DVector};

/// A correction is needed if chance would improve the fit as much once in a thousand flights.
/// Distribution of chi squared for 1, 2 and 3 numbers.
const BY_CHANCE: [f64; 3] = [10.83, 13.82, 16.27];

/// What a number costs in the weights of the combinations. Akaike's 2 made the intervals hold the truth
/// in 99 of 100 flights, 4 in 98, 6 in 88 of those that need all corrections; with 5 it is 96 to 98.
const PER_NUMBER: f64 = 5.0;

/// A combination is left out if n ln S + sum of the thresholds cannot be less than that of another by so
/// much. Its weight beside the other is below e^-20.
const HOPELESS: f64 = 60.0;

/// A combination may be chosen if its next step is no longer, in standard deviations: in a flat valley it takes
/// long to come nearer, and no interval would change by a thousandth.
const NEAR: f64 = 0.05;

/// Pieces of a flight that are fitted first, and the pieces of an integral of the start (turns).
const PIECE: f64 = 1.0;

fn threshold(correction: Correction) -> f64 {
    BY_CHANCE[correction.numbers() - 1]
}

/// What the corrections of a model have to bring.
fn price(model: &Model) -> f64 {
    Correction::ALL.into_iter().filter(|c| model.has(*c)).map(threshold).sum()
}

/// The number of independent residuals, less that of the numbers that were fitted to them.
fn free(fitted: &Fitted) -> f64 {
    (fitted.residuals.len() - fitted.numbers.len()) as f64 / spread::inflation(&fitted.residuals)
}

/// Whether a correction is needed, and by how much the fit is better with it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decision {
    /// Which.
    pub correction: Correction,
    /// n ln(S/S'), with the sums S and S' of squares without and with it, as of [`Flight::fit`]; rough where it is
    /// many times the threshold, and 0 for a tau^2 or a gamma that is best below 0 and for a steady spin.
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
    /// Logarithms of the moments.
    pub(super) logs: [f64; 3],
    /// Their covariance.
    pub(super) covariance: [[f64; 3]; 3],
    /// ln(2 E I/L^2) with each of the moments, and its variance.
    pub(super) separatrices: [(f64, f64); 3],
}

/// A combination of corrections, fitted.
#[derive(Clone)]
struct Candidate {
    model: Model,
    fitted: Fitted,
}

impl Candidate {
    /// Whether it may be chosen: at its minimum, with no filter and no drag below 0, which is best without.
    fn stands(&self) -> bool {
        self.fitted.off <= NEAR && self.is_physical()
    }

    fn is_physical(&self) -> bool {
        self.model.is_physical(&self.fitted.numbers)
    }
}

impl Flight {
    /// The free body that shows these rates best, with those of the corrections that the rates need.
    ///
    /// Two ratios of moments and three rates at the start are fitted by least squares, with the combinations of
    /// the corrections that are `allowed`, but for those that a richer one shows to be hopeless. Chosen is the one with the least n ln S + sum of
    /// the thresholds: a correction is needed if it lowers n ln S by more than chance does once in a
    /// thousand flights: by 10.83 for one number, 16.27 for three. S is the sum of squares, n the number of
    /// independent samples less that of all numbers, from the correlation of the residuals.
    ///
    /// The interval of a ratio allows for the other combinations, each with a weight as of Akaike's: K. P.
    /// Burnham, D. R. Anderson, *Model Selection and Multimodel Inference*, 4.3.
    ///
    /// # Errors
    /// `OutOfRange` if no least sum of squares is found, or for a combination only that fits far worse than
    /// another.
    pub fn fit(&self, allowed: &[Correction]) -> Result<Fit> {
        let samples = self.samples();
        let drags: &[&[Correction]] =
            if allowed.contains(&Correction::Drag) { &[&[], &[Correction::Drag]] } else { &[&[]] };
        let steady = drags.iter().map(|drag| self.steady(&samples, drag));
        let steady = steady.collect::<Result<Vec<Candidate>>>()?;
        let wobbles = |of: &Candidate| wobble(&samples.times, &of.fitted.residuals);
        let combinations = if steady.iter().all(|of| wobbles(of) > by_noise(samples.times.len())) {
            Model::combinations(allowed)
        } else {
            Vec::new()
        };
        let mut candidates: Vec<Candidate> = Vec::new();
        let mut bound = f64::INFINITY;
        let mut independent = samples.times.len() as f64;
        for model in combinations.into_iter().rev() {
            let richer = candidates.iter().filter(|other| model.is_part_of(&other.model));
            let richer = richer.max_by(|a, b| a.fitted.squares.total_cmp(&b.fitted.squares));
            // No sum of squares is less than that of a richer combination.
            let most = exp((bound + HOPELESS - price(&model)) / independent);
            let bounds =
                |richer: &Candidate| richer.fitted.off <= NEAR && richer.fitted.squares > most;
            if richer.is_some_and(bounds) {
                continue;
            }
            let carried = richer.map(|other| model.carried(&other.model, &other.fitted.numbers));
            let trusted = richer.is_some_and(|richer| richer.fitted.off <= NEAR);
            let Ok(fitted) = self.fitted(&samples, &model, carried, trusted, most) else {
                continue;
            };
            candidates.push(Candidate { model, fitted });
            let fitted = candidates.iter().map(|of| &of.fitted);
            if let Some(best) = fitted.min_by(|a, b| a.squares.total_cmp(&b.squares)) {
                independent = free(best);
            }
            let costs = candidates.iter().filter(|of| of.fitted.settled());
            let costs =
                costs.map(|of| independent * self.log_squares(&of.fitted) + price(&of.model));
            bound = costs.fold(f64::INFINITY, f64::min);
        }
        // A richer combination fits no worse: from the numbers of a simpler one, if those are better.
        for k in (0..candidates.len()).rev() {
            let model = candidates[k].model.clone();
            let simpler = candidates[k..].iter().filter(|other| other.model.is_part_of(&model));
            let Some(least) = simpler.min_by(|a, b| a.fitted.squares.total_cmp(&b.fitted.squares))
            else {
                continue;
            };
            if least.fitted.squares < candidates[k].fitted.squares {
                let carried = model.carried(&least.model, &least.fitted.numbers);
                let all = samples.times.len();
                candidates[k].fitted = model.refined(&carried, &samples, all, f64::INFINITY)?;
            }
        }
        candidates.reverse();
        self.chosen(&candidates, &steady, &Model::new(allowed), independent)
    }

    /// ln S; digits beyond the twelfth are those of arithmetic.
    fn log_squares(&self, fitted: &Fitted) -> f64 {
        let rounding = 1e-12 * self.fastest();
        log(fitted.squares.max(rounding * rounding * fitted.residuals.len() as f64))
    }

    /// The best numbers of a model: from those of a richer one, or from linear algebra and pieces of the
    /// flight that grow, whichever begins better.
    fn fitted(
        &self,
        samples: &Samples,
        model: &Model,
        carried: Option<Vec<f64>>,
        trusted: bool,
        hopeless: f64,
    ) -> Result<Fitted> {
        let turns = model.has(Correction::Axes);
        let resists = model.has(Correction::Offset) || model.has(Correction::Drag);
        let mut ways = vec![[turns, resists], [turns, false], [false, resists], [false, false]];
        ways.dedup();
        let own = ways.into_iter().filter_map(|way| self.begun(samples, model, way));
        let mut best: Option<Fitted> = None;
        for numbers in carried.into_iter().chain(own) {
            let count = samples.times.len();
            let Ok(fitted) = model.refined(&numbers, samples, count, hopeless) else { continue };
            // Two starts that lead to the same place, or one from numbers that are good for more.
            let same = |best: &Fitted| (fitted.squares / best.squares - 1.0).abs() < 1e-6;
            let agreed = fitted.settled() && best.as_ref().is_some_and(same);
            let done = agreed || trusted && (fitted.settled() || fitted.squares > hopeless);
            if best.as_ref().is_none_or(|best| fitted.squares < best.squares) {
                best = Some(fitted);
            }
            if done {
                break;
            }
        }
        best.ok_or_else(|| {
            let allowed = "that of a body in free flight: its moments are not to be found";
            Error::out_of_range("fastest rate", self.fastest(), allowed)
        })
    }

    /// Numbers from linear algebra, made better on pieces of the flight that grow: without filter and drag, which
    /// change little in so short a time.
    fn begun(&self, samples: &Samples, model: &Model, way: [bool; 2]) -> Option<Vec<f64>> {
        let piece = PIECE * TAU / self.fastest();
        let still =
            |correction: &Correction| matches!(correction, Correction::Axes | Correction::Offset);
        let simple: Vec<_> =
            Correction::ALL.into_iter().filter(still).filter(|c| model.has(*c)).collect();
        let simple = Model::new(&simple);
        let mut numbers = start::numbers(samples, piece, &simple, way)?;
        let mut part = samples.times.partition_point(|t| *t < piece).max(2 * model.numbers());
        while part < samples.times.len() {
            if let Ok(fitted) = simple.refined(&numbers, samples, part, f64::INFINITY) {
                numbers = fitted.numbers;
            }
            part = part * 4 / 3 + 1;
        }
        Some(model.carried(&simple, &numbers))
    }

    /// The best of the combinations, which are in the order of what they leave open.
    fn chosen(
        &self,
        candidates: &[Candidate],
        steady: &[Candidate],
        allowed: &Model,
        independent: f64,
    ) -> Result<Fit> {
        let misfit = |of: &Candidate| independent * self.log_squares(&of.fitted);
        let cost = |of: &Candidate| misfit(of) + price(&of.model);
        let samples = steady[0].fitted.residuals.len() / 3;
        let least = |of: &[Candidate]| {
            let standing = of.iter().filter(|of| of.stands());
            standing.min_by(|a, b| cost(a).total_cmp(&cost(b))).cloned()
        };
        let spin = least(steady);
        let varied = |best: &Candidate| {
            let gain = spin.as_ref().map(|spin| cost(spin) - cost(best));
            gain.is_none_or(|gain| gain > by_noise(samples))
        };
        let tumble = least(candidates).filter(varied);
        let candidates = if tumble.is_some() { candidates } else { steady };
        let varied = tumble.is_some();
        // What fits far better, and has no minimum, makes the rest no answer.
        let best = tumble.or(spin);
        let bar =
            best.as_ref().map_or(f64::INFINITY, |best| cost(best) - HOPELESS - by_noise(samples));
        let stuck =
            candidates.iter().filter(|of| of.is_physical() && !of.stands() && cost(of) < bar);
        let stuck = stuck.map(|of| of.fitted.off).fold(f64::INFINITY, f64::min);
        let Some(best) = best.filter(|_| stuck == f64::INFINITY) else {
            let allowed = "at most 0.05 standard deviations: the rates leave too much open; take more of the flight, or allow fewer corrections";
            return Err(Error::out_of_range("distance of the fit from the best", stuck, allowed));
        };
        let best = &best;
        let decide = |correction: Correction| {
            let needed = best.model.has(correction);
            let beside = |of: &&Candidate| {
                let (more, less) = if needed { (best, *of) } else { (*of, best) };
                !less.model.has(correction) && more.model == less.model.with(correction)
            };
            let change = |of: &Candidate| {
                if of.is_physical() { (misfit(of) - misfit(best)).abs() } else { 0.0 }
            };
            let without = candidates.iter().filter(|of| needed && !of.model.has(correction));
            let without = without.map(|of| misfit(of) - misfit(best)).reduce(f64::min);
            // What was left out is worse by so much at least.
            let without = without.unwrap_or(HOPELESS);
            let nearest = candidates.iter().find(beside).map(change);
            let improvement = nearest.unwrap_or(if needed { without.max(0.0) } else { 0.0 });
            Decision { correction, improvement, threshold: threshold(correction), needed }
        };
        let akaike = |of: &Candidate| misfit(of) + PER_NUMBER * of.model.numbers() as f64;
        let least =
            candidates.iter().filter(|of| of.stands()).map(akaike).fold(f64::INFINITY, f64::min);
        let weight = |of: &Candidate| {
            let near = of.fitted.off < 1.0 && of.is_physical();
            if near { exp(0.5 * (least - akaike(of))) } else { 0.0 }
        };
        let other = |other: &Candidate| {
            let covariance = spread::covariance(&other.fitted);
            let Named { logs, axes, .. } = other.model.named(&other.fitted.numbers)?;
            let separatrices = self.separatrices(other, &covariance)?;
            let slopes = [0, 1, 2].map(|k| other.model.slopes(&axes, [k, k]));
            let covariance = |i: usize, j: usize| slopes[i].dot(&(&covariance * &slopes[j]));
            let covariance = [0, 1, 2].map(|i| [0, 1, 2].map(|j| covariance(i, j)));
            Ok(Other { weight: weight(other), logs, covariance, separatrices })
        };
        // A weight below a thousandth changes no digit that is told.
        let weighty = candidates.iter().filter(|other| varied && weight(other) > 1e-3);
        let named = best.model.named(&best.fitted.numbers)?;
        let moments = PrincipalMoments::of_any(named.logs.map(exp))?;
        Ok(Fit {
            covariance: spread::covariance(&best.fitted),
            // Student's t of so many degrees of freedom, to first order in their inverse.
            confidence: NORMAL * (1.0 + (1.0 + NORMAL * NORMAL) / (4.0 * independent)),
            decisions: Correction::ALL
                .into_iter()
                .filter(|c| allowed.has(*c))
                .map(decide)
                .collect(),
            others: weighty.map(other).collect::<Result<_>>()?,
            motion: FreeBody::new(moments, named.turn, named.start)?,
            named,
            shown: best.model.rates(&best.fitted.numbers, &self.times)?,
            model: best.model.clone(),
            fitted: best.fitted.clone(),
            flight: self.clone(),
        })
    }

    /// ln(2 E I/L^2) with each of the moments, and its variance.
    fn separatrices(&self, of: &Candidate, covariance: &DMatrix<f64>) -> Result<[(f64, f64); 3]> {
        let values = |numbers: &[f64]| {
            let named = of.model.named(numbers)?;
            let moments = named.logs.map(exp);
            let [energy, momentum] = kept(&moments, &named.start.to_array());
            Ok(moments.map(|moment| log(2.0 * energy * moment / (momentum * momentum))))
        };
        let numbers = &of.fitted.numbers;
        let scales = of.model.scales(self.fastest());
        let mut slopes = [0; 3].map(|_| DVector::zeros(numbers.len()));
        for (i, scale) in scales.iter().enumerate() {
            let aside = |step: f64| {
                let mut aside = numbers.clone();
                aside[i] += step * scale;
                values(&aside)
            };
            let (above, below) = (aside(1e-5)?, aside(-1e-5)?);
            for (n, slopes) in slopes.iter_mut().enumerate() {
                slopes[i] = (above[n] - below[n]) / (2e-5 * scale);
            }
        }
        let best = values(numbers)?;
        Ok([0, 1, 2].map(|n| (best[n], slopes[n].dot(&(covariance * &slopes[n])))))
    }

    /// A spin about a line that is fixed in the body, as a cube has it: no ratio is fitted.
    fn steady(&self, samples: &Samples, corrections: &[Correction]) -> Result<Candidate> {
        let model = Model::new(corrections);
        let count = samples.times.len();
        let whole = |numbers: &[f64]| [&[0.0, 0.0], numbers].concat();
        let mut start = vec![0.0; model.numbers() - 2];
        for (i, number) in start.iter_mut().take(3).enumerate() {
            *number = samples.rates.iter().map(|rate| rate[i]).sum::<f64>() / count as f64;
        }
        let scales = model.scales(self.fastest());
        let mut fitted =
            least_squares::descend(&start, &scales[2..], &|_, _| false, &mut |numbers| {
                model.residuals(&whole(numbers), samples, count, &mut None)
            })?;
        fitted.numbers = whole(&fitted.numbers);
        fitted.jacobian = fitted.jacobian.insert_columns(0, 2, 0.0);
        Ok(Candidate { model, fitted })
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

/// By how much n ln S falls at most if a sine and a cosine of one frequency are taken from these residuals of a
/// steady spin, on all axes: a tumble, whose wobble is that to first order, can hardly be better.
fn wobble(times: &[f64], residuals: &[f64]) -> f64 {
    let (count, end) = (times.len(), times[times.len() - 1]);
    let squares: f64 = residuals.iter().map(|r| r * r).sum();
    let explained = |k: usize| {
        // From a quarter of an oscillation in the flight to one in two samples.
        let waves: Vec<_> = times.iter().map(|t| sincos(0.5 * PI * k as f64 * t / end)).collect();
        let sum = |part: &dyn Fn(usize) -> f64| (0..count).map(part).sum::<f64>();
        let ss = sum(&|n| waves[n].0 * waves[n].0);
        let sc = sum(&|n| waves[n].0 * waves[n].1);
        let cc = sum(&|n| waves[n].1 * waves[n].1);
        let of_axis = |axis: usize| {
            let a = sum(&|n| residuals[3 * n + axis] * waves[n].0);
            let b = sum(&|n| residuals[3 * n + axis] * waves[n].1);
            (a * a * cc - 2.0 * a * b * sc + b * b * ss) / (ss * cc - sc * sc)
        };
        (0..3).map(of_axis).sum::<f64>()
    };
    let most = (1..2 * count).map(explained).fold(0.0, f64::max);
    -(residuals.len() as f64) * log((1.0 - most / squares).max(f64::MIN_POSITIVE))
}
