//! The pendulum that fits a swing, and how well its numbers are known.

use super::course::{self, Numbers};
use super::{Averaged, Swing, WITHOUT};
use crate::error::{Error, Result, positive};
use crate::exact::carlson::rf;
use crate::fit::{Estimate, NORMAL, OPEN, least_squares, spread};
use crate::math::{asin, exp, log};
use nalgebra::{DMatrix, DVector};

/// Below this part of the rates residuals count as none: averages leave 4e-6 of them ([`Swing::fit`]).
const FLOOR: f64 = 1e-5;

/// A damping is needed if chance would improve the fit as much once in a thousand swings: chi squared of
/// one number.
const BY_CHANCE: f64 = 10.83;

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
    /// n ln(S/S'), with the sums S and S' of squares without and with it, as of [`Swing::fit`]. Where no
    /// pendulum without it fits best, S is that of a constant rate: at most as much is gained.
    pub improvement: f64,
    /// What chance reaches once in a thousand swings.
    pub threshold: f64,
    /// Whether the fit has it.
    pub needed: bool,
}

/// A pendulum with or without each damping, fitted.
#[derive(Debug, Clone)]
pub(super) struct Candidate {
    damped: [bool; 2],
    pub(super) numbers: Numbers,
    pub(super) residuals: Vec<f64>,
    pub(super) squares: f64,
    /// With zeros for a damping that it lacks.
    covariance: Option<DMatrix<f64>>,
}

impl Candidate {
    /// The best near these numbers; its covariance is that of independent residuals of variance 1.
    pub(super) fn new(damped: [bool; 2], start: Numbers, averaged: &[Averaged]) -> Result<Self> {
        // A number that changes nothing would be a column of zeros, with which no factors are found.
        let open: Vec<usize> = (0..6).filter(|i| *i < 4 || damped[i - 4]).collect();
        let all = |values: &[f64]| {
            let mut numbers = [0.0; 6];
            open.iter().zip(values).for_each(|(i, value)| numbers[*i] = *value);
            numbers
        };
        let mut residuals = |values: &[f64]| {
            let numbers = all(values);
            if (numbers[0] - start[0]).abs() > 2.0 {
                let allowed = format!("within 2 of {}, a factor of e in the frequency", start[0]);
                return Err(Error::out_of_range("ln W^2", numbers[0], allowed));
            }
            let states = course::states(&numbers, averaged.iter().map(|a| a.time))?;
            let one = |(a, state): (&Averaged, [f64; 2])| {
                let bent = 0.5 * a.variance * course::second_derivative(&numbers, state);
                a.weight * (state[1] + bent + numbers[3] - a.rate)
            };
            Ok(averaged.iter().zip(states).map(one).collect())
        };
        let fastest = averaged.iter().fold(0.0, |most: f64, a| most.max(a.rate.abs()));
        let frequency = exp(0.5 * start[0]);
        // Near the upright position, the time of a swing goes as ln(1 - k^2).
        let gap = (1.0 - energy(&start)).abs().clamp(1e-3, 1.0);
        let scales = [gap, gap, gap * fastest, fastest, frequency, frequency / fastest];
        let those = |of: &Numbers| open.iter().map(|i| of[*i]).collect::<Vec<_>>();
        let fitted = least_squares::fit(&those(&start), &those(&scales), &mut residuals)?;
        let scaled = DMatrix::from_diagonal(&DVector::from_vec(those(&scales)));
        let jacobian = fitted.jacobian * &scaled;
        let inverse = jacobian.tr_mul(&jacobian).cholesky().map(|factors| factors.inverse());
        let covariance = inverse.map(|inverse| {
            let own = &scaled * inverse * &scaled;
            let at = |i: usize| open.iter().position(|open| *open == i);
            DMatrix::from_fn(6, 6, |i, j| at(i).zip(at(j)).map_or(0.0, |place| own[place]))
        });
        let (numbers, residuals) = (all(&fitted.numbers), fitted.residuals);
        Ok(Self { damped, numbers, residuals, squares: fitted.squares, covariance })
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
    pub(super) fn chosen(
        mut candidates: Vec<Candidate>,
        whole: f64,
        swing: &Swing,
    ) -> Result<Self> {
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
            let without = count as f64 / inflation * log(whole + floor);
            let twin = twin.map_or(if needed { without } else { misfit(best) }, misfit);
            let improvement = (twin - misfit(best)).abs();
            SwingDecision { damping, improvement, threshold: BY_CHANCE, needed }
        });
        let weighed = |of: &Candidate| (of.clone(), exp(0.5 * (price(best) - price(of))));
        let fit = Self {
            states: course::states(&best.numbers, swing.times.iter().copied())?,
            best: best.clone(),
            candidates: candidates.iter().map(weighed).collect(),
            decisions,
            swing: swing.clone(),
        };
        let unexplained = fit.best.squares / whole;
        fit.checked(unexplained)
    }

    /// Refuses what is no swing, or an open one.
    fn checked(self, unexplained: f64) -> Result<Self> {
        if unexplained.is_nan() || unexplained > 0.25 {
            let left = 100.0 * unexplained;
            return Err(Error::no_swing(format!(
                "the pendulum that fits these rates best leaves {left:.0} of 100 parts of their variance, and \
                 25 are allowed. {WITHOUT}"
            )));
        }
        let energy = energy(&self.best.numbers);
        if energy >= 1.0 {
            return Err(Error::no_swing(format!(
                "the pendulum that fits these rates best would go over the top, with {energy:.5} times the \
                 energy of the upright position. {WITHOUT}"
            )));
        }
        let square = self.estimate(|numbers| numbers[0]);
        let factor = exp(0.5 * (square.to - square.from));
        if factor <= OPEN && self.best.covariance.is_some() {
            return Ok(self);
        }
        Err(Error::no_swing(format!(
            "this is too short or too noisy to tell the length: it is open by a factor of {factor:.3}"
        )))
    }

    /// An estimate of a function of the numbers: the interval has the variance of the best, or that of all
    /// with their weights, whichever is larger.
    fn estimate(&self, of: impl Fn(&Numbers) -> f64) -> Estimate {
        self.among(|_| true, of)
    }

    /// The same by some of the candidates, the best among them.
    fn among(&self, those: impl Fn(&Candidate) -> bool, of: impl Fn(&Numbers) -> f64) -> Estimate {
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
        let weighty = self.candidates.iter().filter(|(_, weight)| *weight > 1e-3);
        for (candidate, weight) in weighty.filter(|(candidate, _)| those(candidate)) {
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

    /// The linear damping gamma (1/s), if it is needed. Its interval is that of the pendulums that have it:
    /// where one with quadratic damping alone explains the rates nearly as well, that some damping is needed is
    /// sure, and which is not.
    pub fn linear(&self) -> Option<Estimate> {
        self.damping(0)
    }

    /// The quadratic damping beta (1/rad), if it is needed; its interval as that of the linear one.
    pub fn quadratic(&self) -> Option<Estimate> {
        self.damping(1)
    }

    fn damping(&self, i: usize) -> Option<Estimate> {
        self.best.damped[i].then(|| self.among(|of| of.damped[i], |numbers| numbers[4 + i]))
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
        // Not t against the end: the last time, less the first, plus the first, may round to before it.
        let (since, last) = (t - begin, times[times.len() - 1]);
        let before = times.partition_point(|sample| *sample <= since);
        if before == 0 || since > last {
            crate::error::finite("t", t)?;
            return Err(Error::OutsideRun { t, start: *begin, end: begin + last });
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

/// k^2 at the start.
fn energy(numbers: &Numbers) -> f64 {
    course::energy(numbers, [numbers[1], numbers[2]])
}
