//! The rates of a flight, checked and made few.

use super::model::Samples;
use crate::error::{Error, Result};
use crate::frame::DesignVector;
use core::f64::consts::TAU;

/// The fewest samples of a flight: as many as all corrections leave numbers open, three rates for each.
const FEWEST: usize = 13;

/// Means are taken over a 16th of a turn at most. A rate that swings as fast as the body turns then loses
/// (TAU/16)^2/12 = 1.3 per cent of what its samples tell; the error of the two places that stand for the
/// mean is (TAU/16)^4/4320 = 5e-6 of the rate.
const MEANS_A_TURN: f64 = 16.0;

/// But no means are taken of so few samples: it would save no time that is felt.
const FEW: usize = 256;

/// The rates of one flight, as a sensor that is fixed to the body recorded them.
#[derive(Debug, Clone, PartialEq)]
pub struct Flight {
    /// In s after the first.
    pub(super) times: Vec<f64>,
    pub(super) begin: f64,
    pub(super) rates: Vec<[f64; 3]>,
}

impl Flight {
    /// A flight: `times` (s), ascending, from any beginning and with gaps or without, and the rates (rad/s)
    /// on the sensor's axes, which are right-handed.
    ///
    /// # Errors
    /// `Lengths` if there are not as many rates as times, or fewer than 13; `AtIndex` for a time or
    /// rate that is not finite, for a time that is not later than the one before, and for the first of four
    /// or more samples in which a sensor is at the end of its range; `OutOfRange` if nothing turns.
    ///
    /// At the end of its range a sensor shows the same largest rate several times, while the rates before
    /// and after change too fast for the round top of a smooth curve. Such samples may be left out.
    pub fn new(times: Vec<f64>, rates: Vec<DesignVector>) -> Result<Self> {
        if rates.len() != times.len() {
            let (found, expected) = (rates.len(), times.len());
            return Err(Error::Lengths { name: "rates", found, expected });
        }
        if times.len() < FEWEST {
            return Err(Error::Lengths { name: "samples", found: times.len(), expected: FEWEST });
        }
        let at = |name, index, reason| Error::AtIndex { name, index, reason: Box::new(reason) };
        for (index, (t, rate)) in times.iter().zip(&rates).enumerate() {
            if !t.is_finite() {
                return Err(at("times", index, Error::NotFinite { name: "time", value: *t }));
            }
            if let Some(value) = rate.to_array().into_iter().find(|w| !w.is_finite()) {
                return Err(at("rates", index, Error::NotFinite { name: "rate", value }));
            }
            if index > 0 && *t <= times[index - 1] {
                let allowed = format!("later than {} s", times[index - 1]);
                return Err(at("times", index, Error::out_of_range("time", *t, allowed)));
            }
        }
        for axis in 0..3 {
            let along: Vec<f64> = rates.iter().map(|rate| rate[axis]).collect();
            if let Some((index, count)) = saturated(&along) {
                let allowed = format!(
                    "within the sensor's range: {count} samples in a row show this largest rate; leave them out, or throw more slowly"
                );
                return Err(at("rates", index, Error::out_of_range("rate", along[index], allowed)));
            }
        }
        let begin = times[0];
        let times = times.iter().map(|t| t - begin).collect();
        let rates: Vec<[f64; 3]> = rates.iter().map(|rate| rate.to_array()).collect();
        let flight = Self { times, begin, rates };
        if flight.fastest() == 0.0 {
            let allowed = "above 0: what does not turn shows no moments";
            return Err(Error::out_of_range("fastest rate", 0.0, allowed));
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

    /// How many samples there are in a turn at the fastest rate, 2 pi/(|omega| dt), with the mean step dt.
    pub fn samples_a_turn(&self) -> f64 {
        let step = self.times[self.times.len() - 1] / (self.times.len() - 1) as f64;
        TAU / (self.fastest() * step)
    }

    /// The greatest |omega| (rad/s).
    pub(super) fn fastest(&self) -> f64 {
        let squares = self.rates.iter().map(|rate| rate.iter().map(|w| w * w).sum::<f64>());
        squares.fold(0.0, f64::max).sqrt()
    }

    /// All samples, or means over pieces of a 16th of a turn, of those of a long recording.
    pub(super) fn samples(&self) -> Samples {
        let count = self.times.len();
        let end = self.times[count - 1];
        let pieces = ((MEANS_A_TURN * end * self.fastest() / TAU).ceil() as usize).max(FEW);
        let piece = |t: f64| if pieces < count { (t / end * pieces as f64) as usize } else { 0 };
        let mut samples = Samples::default();
        let mut from = 0;
        for k in 1..=count {
            if k < count && pieces < count && piece(self.times[k]) == piece(self.times[from]) {
                continue;
            }
            let number = (k - from) as f64;
            let mean = |value: &dyn Fn(usize) -> f64| (from..k).map(value).sum::<f64>() / number;
            let time = mean(&|k| self.times[k]);
            samples.times.push(time);
            samples.spreads.push(mean(&|k| (self.times[k] - time) * (self.times[k] - time)).sqrt());
            samples.rates.push([0, 1, 2].map(|i| mean(&|k| self.rates[k][i])));
            samples.weights.push(number.sqrt());
            from = k;
        }
        let largest = samples.weights.iter().copied().fold(0.0, f64::max);
        samples.weights.iter_mut().for_each(|weight| *weight /= largest);
        samples
    }
}

/// The first and the number of four or more samples in a row that show the largest rate of all (three happen
/// by chance: at 0.003 rad/s of noise in digits of 0.001 rad/s once in 1300 flights), if no
/// other rate is shown as often in a row, and the rates beside them fall too steeply. A parabola that stays
/// within one step q of the digits for m samples has fallen by q (1 + 4/m)^2 two samples later; a fall
/// of more than three times that is none.
fn saturated(rates: &[f64]) -> Option<(usize, usize)> {
    let largest = rates.iter().fold(0.0_f64, |most, w| most.max(w.abs()));
    let steps = rates.windows(2).map(|pair| (pair[1] - pair[0]).abs()).filter(|step| *step > 0.0);
    let digit = steps.fold(f64::INFINITY, f64::min);
    let (mut found, mut longest, mut from) = (None, 3, 0);
    for k in 1..=rates.len() {
        if k < rates.len() && rates[k] == rates[from] {
            continue;
        }
        let count = k - from;
        if rates[from].abs() < largest {
            longest = longest.max(count);
        } else if count > found.map_or(3, |(_, most)| most) {
            let edges = [from.checked_sub(2), Some(k + 1).filter(|after| *after < rates.len())];
            let falls = edges.into_iter().flatten().map(|edge| (rates[from] - rates[edge]).abs());
            let wider = 1.0 + 4.0 / count as f64;
            let round = 3.0 * digit * wider * wider;
            if falls.clone().count() > 0 && falls.into_iter().all(|fall| fall > round) {
                found = Some((from, count));
            }
        }
        from = k;
    }
    found.filter(|(_, count)| *count > longest)
}
