//! Nonlinear least squares by Levenberg's and Marquardt's method.
//!
//! The Jacobian is factored, never squared: a valley whose sides are 1e5 times as steep as its floor has a
//! normal matrix of condition 1e10. In units in which each column has the length 1, the factors are
//! J = Q U S V^T, and a step with the damping d is V S/(S^2 + d) (Q U)^T r.
//!
//! Sources: D. W. Marquardt, *J. Soc. Indust. Appl. Math.* 11, 431 (1963); H. B. Nielsen, *Damping parameter
//! in Marquardt's method*, IMM-REP-1999-05 (1999), for the damping; M. K. Transtrum, J. P. Sethna,
//! arXiv:1201.5885 (2012), for the bent steps.

use crate::error::{Error, Result};
use nalgebra::{DMatrix, DVector};

/// The numbers that fit best, and how the residuals depend on them.
#[derive(Debug, Clone)]
pub(super) struct Fitted {
    pub(super) numbers: Vec<f64>,
    pub(super) residuals: Vec<f64>,
    /// Derivatives of the residuals: a row for each of them, a column for each number.
    pub(super) jacobian: DMatrix<f64>,
    pub(super) squares: f64,
    /// The length of Gauss and Newton's next step, in standard deviations.
    pub(super) off: f64,
}

/// A step in a number, relative to its scale, for a central difference: about the cube root of round-off, at
/// which the errors of rounding and of the third derivative are alike, some 1e-10 of a slope.
const STEP: f64 = 1e-5;
/// Beside a separatrix that is far too wide. A step is a tenth of itself, twice at most, if the second difference
/// is more than this part of the first: its square is about the error of a slope.
const BENT: f64 = 1e-3;
/// But beside a separatrix residuals are bent within far less: by a step they shall change by this part of a
/// standard deviation,
const WHILE_STRAIGHT: f64 = 0.03;
/// unless the step, relative to its scale, were so small that the slope is rounding.
const LEAST_STEP: f64 = 1e-9;
/// Directions in which the residuals change so little, relative to the steepest, are left alone: their slopes
/// are errors of the differences.
pub(super) const FLAT: f64 = 1e-9;
/// The minimum is reached when Gauss and Newton's step is this part of a standard deviation.
const SETTLED: f64 = 1e-3;
/// What a change of one scale makes, times this, is the rounding of residuals that vanish, with a margin.
const ROUNDING: f64 = 1e-10;
/// Fits that find a minimum mostly take 5 to 15.
const MOST_STEPS: usize = 40;

fn squares(residuals: &[f64]) -> f64 {
    residuals.iter().map(|r| r * r).sum()
}

impl Fitted {
    /// Whether the sum of squares is the least near these numbers.
    pub(super) fn settled(&self) -> bool {
        self.off <= SETTLED
    }
}

/// Fits from these numbers. `scales` are the sizes at which changes of the numbers count. A step to where
/// `residuals` refuses is shortened. Derivatives are taken from the last number to the first.
///
/// # Errors
/// Those of `residuals` at the start; `Lengths` if there are no more of them than numbers; `OutOfRange`
/// if the minimum is not reached, because it lies where `residuals` refuses, or nowhere.
pub(super) fn fit(
    start: &[f64],
    scales: &[f64],
    residuals: &mut dyn FnMut(&[f64]) -> Result<Vec<f64>>,
) -> Result<Fitted> {
    let fitted = descend(start, scales, &|_, _| false, residuals)?;
    if fitted.settled() {
        return Ok(fitted);
    }
    let allowed = "0.001 standard deviations: no least sum of squares was found";
    Err(Error::out_of_range("distance of a fit from the best", fitted.off, allowed))
}

/// The same, with what is reached if it is no minimum, or where it is `given_up` after so many steps.
///
/// # Errors
/// Those of `residuals` at the start; `Lengths` as above.
pub(super) fn descend(
    start: &[f64],
    scales: &[f64],
    given_up: &dyn Fn(&Fitted, usize) -> bool,
    residuals: &mut dyn FnMut(&[f64]) -> Result<Vec<f64>>,
) -> Result<Fitted> {
    let first = residuals(start)?;
    if first.len() <= start.len() {
        let expected = start.len() + 1;
        return Err(Error::Lengths { name: "residuals", found: first.len(), expected });
    }
    let mut numbers = DVector::from_column_slice(start);
    let mut now = Fitted {
        numbers: start.to_vec(),
        squares: squares(&first),
        residuals: first,
        jacobian: DMatrix::zeros(0, 0),
        off: f64::INFINITY,
    };
    let (mut damping, mut harder) = (1e-3, 2.0);
    let mut sides: Vec<f64> = scales.iter().map(|scale| STEP * scale).collect();
    for steps in 0..MOST_STEPS {
        now.jacobian = slopes(&numbers, scales, &mut sides, &now.residuals, residuals)?;
        if now.jacobian.iter().any(|slope| !slope.is_finite()) {
            break;
        }
        let linear = Linear::new(&now.jacobian, scales, &now.residuals);
        now.off = linear.off;
        if now.settled() || given_up(&now, steps) {
            break;
        }
        let reached = loop {
            let (step, promised) = linear.step(damping);
            let small = step.iter().zip(scales).all(|(step, scale)| step.abs() < 1e-14 * scale);
            if small || !promised.is_finite() {
                break None;
            }
            // Along the step the residuals are bent: the second derivative, by a difference over a tenth.
            let near: DVector<f64> = &numbers - 0.1 * &step;
            let bend = residuals(near.as_slice()).ok().map(|near| {
                let along = &now.jacobian * &step;
                let bent = near.iter().zip(&now.residuals).zip(along.iter());
                let bent = bent.map(|((near, now), slope)| 200.0 * (near - now + 0.1 * slope));
                linear.bent(damping, &now.jacobian, &DVector::from_iterator(along.len(), bent))
            });
            let gentle = |bend: &DVector<f64>| linear.length(bend) < 0.75 * linear.length(&step);
            let bend = bend.filter(gentle).unwrap_or_else(|| DVector::zeros(step.len()));
            let tried: DVector<f64> = &numbers - step - 0.5 * bend;
            let there = residuals(tried.as_slice()).ok();
            let gain = there.as_ref().map_or(-1.0, |r| (now.squares - squares(r)) / promised);
            if let Some(there) = there.filter(|_| gain > 0.0) {
                let trust = 2.0 * gain - 1.0;
                damping = (damping * (1.0 - trust * trust * trust).max(0.1)).max(1e-14);
                harder = 2.0;
                break Some((tried, there));
            }
            damping *= harder;
            harder *= 2.0;
        };
        let Some((tried, there)) = reached else { break };
        numbers = tried;
        now.numbers = numbers.as_slice().to_vec();
        (now.squares, now.residuals) = (squares(&there), there);
    }
    Ok(now)
}

/// The residuals as they depend on small changes of the numbers.
struct Linear {
    lengths: Vec<f64>,
    /// Singular values, and their directions as rows.
    values: DVector<f64>,
    directions: DMatrix<f64>,
    /// The residuals along the columns' own directions.
    along: DVector<f64>,
    /// The length of Gauss and Newton's step, in standard deviations.
    off: f64,
}

impl Linear {
    fn new(slopes: &DMatrix<f64>, scales: &[f64], residuals: &[f64]) -> Self {
        let (count, numbers) = slopes.shape();
        let lengths: Vec<f64> = slopes.column_iter().map(|column| column.norm()).collect();
        let mut columns = slopes.clone().insert_column(numbers, 0.0);
        for (mut column, length) in columns.column_iter_mut().zip(&lengths) {
            column.unscale_mut(length.max(f64::MIN_POSITIVE));
        }
        columns.set_column(numbers, &DVector::from_column_slice(residuals));
        // The last column of the triangle is Q^T r, and its last number what no change takes away.
        let triangle = columns.qr().r();
        let within = triangle.column(numbers).rows(0, numbers).into_owned();
        let beside = triangle[(numbers, numbers)];
        let factors = triangle.view((0, 0), (numbers, numbers)).into_owned().svd(true, true);
        let (left, directions) = (factors.u.unwrap_or_default(), factors.v_t.unwrap_or_default());
        let mut values = factors.singular_values;
        let flat = FLAT * values.max();
        values.iter_mut().filter(|value| **value < flat).for_each(|value| *value = 0.0);
        let mut along = left.tr_mul(&within);
        along.iter_mut().zip(&values).filter(|(_, s)| **s == 0.0).for_each(|(c, _)| *c = 0.0);
        let wholes = lengths.iter().zip(scales).map(|(length, scale)| length * scale);
        let rounding = ROUNDING * wholes.fold(0.0, f64::max) / (count as f64).sqrt();
        let deviation = beside.abs() / ((count - numbers) as f64).sqrt();
        let off = along.norm() / deviation.max(rounding).max(f64::MIN_POSITIVE);
        Self { lengths, values, directions, along, off }
    }

    /// The numbers that these lengths along the directions are.
    fn numbers(&self, lengths: &DVector<f64>) -> DVector<f64> {
        let mut numbers = self.directions.tr_mul(lengths);
        for (number, length) in numbers.iter_mut().zip(&self.lengths) {
            *number /= length.max(f64::MIN_POSITIVE);
        }
        numbers
    }

    /// What to take from the numbers, and by how much the sum of squares then falls.
    fn step(&self, damping: f64) -> (DVector<f64>, f64) {
        let step = self.along.zip_map(&self.values, |c, s| c * s / (s * s + damping));
        let left = self.along.zip_map(&self.values, |c, s| c * damping / (s * s + damping));
        (self.numbers(&step), self.along.norm_squared() - left.norm_squared())
    }

    /// What to take from the numbers for these residuals.
    fn bent(&self, damping: f64, slopes: &DMatrix<f64>, bent: &DVector<f64>) -> DVector<f64> {
        let mut pull = slopes.tr_mul(bent);
        for (pull, length) in pull.iter_mut().zip(&self.lengths) {
            *pull /= length.max(f64::MIN_POSITIVE);
        }
        let along = &self.directions * pull;
        let part = |c: f64, s: f64| if s == 0.0 { 0.0 } else { c / (s * s + damping) };
        self.numbers(&along.zip_map(&self.values, part))
    }

    fn length(&self, numbers: &DVector<f64>) -> f64 {
        let parts = numbers.iter().zip(&self.lengths).map(|(x, length)| x * length);
        parts.map(|part| part * part).sum::<f64>().sqrt()
    }
}

/// Derivatives by central differences of these steps; to one side where the other is refused.
fn slopes(
    numbers: &DVector<f64>,
    scales: &[f64],
    sides: &mut [f64],
    now: &[f64],
    residuals: &mut dyn FnMut(&[f64]) -> Result<Vec<f64>>,
) -> Result<DMatrix<f64>> {
    let mut slopes = DMatrix::zeros(now.len(), numbers.len());
    let degrees = now.len() - numbers.len();
    let change_wanted = WHILE_STRAIGHT * (squares(now) / degrees as f64).sqrt();
    for i in (0..numbers.len()).rev() {
        let least = LEAST_STEP * scales[i];
        let mut aside = |step: f64| {
            let mut aside = numbers.clone();
            aside[i] += step;
            residuals(aside.as_slice()).map(|there| (aside[i], there))
        };
        loop {
            let here = || (numbers[i], now.to_vec());
            let (below, above) = (aside(-sides[i]), aside(sides[i]));
            let ((from, below), (to, above)) = match (below, above) {
                (Err(error), Err(_)) => return Err(error),
                (below, above) => {
                    (below.unwrap_or_else(|_| here()), above.unwrap_or_else(|_| here()))
                }
            };
            let (mut first, mut second) = (0.0, 0.0);
            for ((slope, now), (below, above)) in
                slopes.column_mut(i).iter_mut().zip(now).zip(below.iter().zip(&above))
            {
                let change = above - below;
                *slope = change / (to - from);
                first += change * change;
                second += (above - 2.0 * now + below) * (above - 2.0 * now + below);
            }
            let straight = second <= BENT * BENT * first && first.sqrt() <= 3.0 * change_wanted;
            if straight || sides[i] <= least {
                break;
            }
            sides[i] = (sides[i] * (change_wanted / first.sqrt()).min(0.1)).max(least);
        }
    }
    Ok(slopes)
}
