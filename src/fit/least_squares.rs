//! Nonlinear least squares by Levenberg's and Marquardt's method.
//!
//! Source: D. W. Marquardt, *J. Soc. Indust. Appl. Math.* 11, 431 (1963): the normal matrix with its
//! diagonal enlarged, so that a step lies between Gauss and Newton's and that of steepest descent.

use crate::error::Result;
use nalgebra::{DMatrix, DVector};

/// The numbers that fit best, and how the residuals depend on them.
#[derive(Debug, Clone)]
pub(super) struct Fitted {
    pub(super) numbers: Vec<f64>,
    pub(super) residuals: Vec<f64>,
    /// Derivatives of the residuals: a row for each of them, a column for each number.
    pub(super) jacobian: DMatrix<f64>,
    pub(super) squares: f64,
    /// How often the residuals were computed.
    pub(super) evaluations: usize,
}

/// A step in a number, relative to its scale, for a difference quotient: about the square root of
/// round-off, at which the errors of rounding and of the curvature are alike.
const STEP: f64 = 1e-7;
/// The sum of squares is at its least when a step changes it by less than this part. A fit without noise creeps along a
/// valley: with 1e-9 it stopped at ratios 1 per cent off.
const SETTLED: f64 = 1e-12;
const MOST_STEPS: usize = 60;

fn squares(residuals: &[f64]) -> f64 {
    residuals.iter().map(|r| r * r).sum()
}

/// Fits from these numbers. A step to where `residuals` refuses is shortened.
pub(super) fn fit(
    start: &[f64],
    scales: &[f64],
    residuals: &mut dyn FnMut(&[f64]) -> Result<Vec<f64>>,
) -> Result<Fitted> {
    let mut numbers = start.to_vec();
    let mut now = residuals(&numbers)?;
    let mut evaluations = 1;
    let mut sum = squares(&now);
    let mut damping = 1e-3;
    let mut jacobian = DMatrix::zeros(now.len(), numbers.len());
    for _ in 0..MOST_STEPS {
        slopes(&numbers, scales, &now, residuals, &mut jacobian)?;
        evaluations += numbers.len();
        let gradient = jacobian.tr_mul(&DVector::from_column_slice(&now));
        let normal = jacobian.tr_mul(&jacobian);
        let mut gained = None;
        while gained.is_none() && damping < 1e12 {
            let mut damped = normal.clone();
            for i in 0..numbers.len() {
                // What the residuals do not depend on stays where it is.
                damped[(i, i)] += damping * normal[(i, i)] + f64::MIN_POSITIVE;
            }
            let step = damped.cholesky().map(|factors| factors.solve(&gradient));
            let tried = step.map(|step| {
                numbers.iter().zip(step.iter()).map(|(x, d)| x - d).collect::<Vec<_>>()
            });
            evaluations += 1;
            let there = tried.and_then(|tried| residuals(&tried).ok().map(|r| (tried, r)));
            match there {
                Some((tried, there)) if squares(&there) < sum => {
                    let new = squares(&there);
                    gained = Some(1.0 - new / sum);
                    (numbers, now, sum) = (tried, there, new);
                    damping = (0.1 * damping).max(1e-12);
                }
                _ => damping *= 10.0,
            }
        }
        if gained.is_none_or(|gained| gained < SETTLED) {
            break;
        }
        damping = damping.min(1e3);
    }
    slopes(&numbers, scales, &now, residuals, &mut jacobian)?;
    evaluations += numbers.len();
    Ok(Fitted { numbers, residuals: now, jacobian, squares: sum, evaluations })
}

/// Derivatives by differences, to the side where the residuals can be had.
fn slopes(
    numbers: &[f64],
    scales: &[f64],
    now: &[f64],
    residuals: &mut dyn FnMut(&[f64]) -> Result<Vec<f64>>,
    jacobian: &mut DMatrix<f64>,
) -> Result<()> {
    for (i, scale) in scales.iter().enumerate() {
        let mut aside = |step: f64| {
            let mut aside = numbers.to_vec();
            aside[i] += step;
            let step = aside[i] - numbers[i];
            residuals(&aside).map(|there| (there, step))
        };
        let (there, step) = aside(STEP * scale).or_else(|_| aside(-STEP * scale))?;
        for (slope, (there, now)) in jacobian.column_mut(i).iter_mut().zip(there.iter().zip(now)) {
            *slope = (there - now) / step;
        }
    }
    Ok(())
}
