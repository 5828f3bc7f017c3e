//! How well the numbers of a fit are known.
//!
//! Samples of a sensor are not independent: its filter and what the model leaves out make each
//! residual like the one before. So two covariances are formed, and of each number the larger variance
//! counts: that of the curvature, with as many samples as the correlation of the residuals leaves, and
//! that of fits to residuals that were drawn again in blocks.

use super::least_squares::{FLAT, Fitted};
use nalgebra::{DMatrix, DVector};

/// How many times residuals are drawn again: the standard deviation of a number is then known within
/// 1/sqrt(2 x 400), 3.5 per cent.
const DRAWS: usize = 400;

/// By how much the residuals of this many axes hang together: the number of samples over that of
/// independent ones, 1 + 2 sum of the autocorrelation as far as it stays positive.
///
/// Source: C. J. Geyer, *Statist. Sci.* 7, 473 (1992), the initial positive sequence.
pub(super) fn inflation(residuals: &[f64]) -> f64 {
    let samples = residuals.len() / 3;
    let at = |lag: usize| -> f64 {
        (0..samples - lag)
            .flat_map(|k| (0..3).map(move |i| residuals[3 * k + i] * residuals[3 * (k + lag) + i]))
            .sum()
    };
    let whole = at(0);
    if whole == 0.0 {
        return 1.0;
    }
    let mut sum = 1.0;
    let mut lag = 1;
    while lag + 1 < samples / 4 {
        let pair = (at(lag) + at(lag + 1)) / whole;
        if pair <= 0.0 {
            break;
        }
        sum += 2.0 * pair;
        lag += 2;
    }
    sum
}

/// The covariance of the numbers; what the residuals leave open has a variance beyond all sizes.
pub(super) fn covariance(fitted: &Fitted) -> DMatrix<f64> {
    let (count, numbers) = fitted.jacobian.shape();
    // In units in which each column has the length 1, so that numbers of all sizes are treated alike.
    let length = |norm: f64| if norm > 0.0 { norm } else { 1.0 };
    let lengths: Vec<f64> = fitted.jacobian.column_iter().map(|c| length(c.norm())).collect();
    let mut columns = fitted.jacobian.clone();
    for (mut column, length) in columns.column_iter_mut().zip(&lengths) {
        column /= *length;
    }
    let factors = columns.clone().qr().r().svd(false, true);
    let values = factors.singular_values.map(|value| value.max(FLAT));
    let mut directions = factors.v_t.unwrap_or_default();
    for (mut row, value) in directions.row_iter_mut().zip(&values) {
        row /= *value;
    }
    let inverse = directions.tr_mul(&directions);
    let inflation = inflation(&fitted.residuals);
    let variance = fitted.squares / (count - numbers) as f64 * inflation;
    let mut covariance = &inverse * variance;
    let drawn = drawn(fitted, &columns, &inverse, inflation);
    for i in 0..numbers {
        // The correlations of the curvature, the larger of the two variances.
        let least = covariance[(i, i)].max(f64::MIN_POSITIVE);
        let factor = (drawn[i] / least).max(1.0).sqrt();
        covariance.row_mut(i).scale_mut(factor);
        covariance.column_mut(i).scale_mut(factor);
    }
    for (i, length) in lengths.iter().enumerate() {
        covariance.row_mut(i).unscale_mut(*length);
        covariance.column_mut(i).unscale_mut(*length);
    }
    covariance
}

/// Variances of the numbers of fits to residuals drawn again, in blocks as long as four times their
/// memory; one step of Gauss and Newton's finds each.
fn drawn(
    fitted: &Fitted,
    columns: &DMatrix<f64>,
    inverse: &DMatrix<f64>,
    inflation: f64,
) -> Vec<f64> {
    let samples = fitted.residuals.len() / 3;
    let block = ((4.0 * inflation) as usize).clamp(1, (samples / 8).max(1));
    let degrees = fitted.residuals.len() - columns.ncols();
    // Residuals of a fit are smaller than the noise.
    let wider = fitted.residuals.len() as f64 / degrees as f64;
    let mut random = Random(0x5eed);
    let mut sums = vec![0.0; columns.ncols()];
    let mut again = DVector::zeros(fitted.residuals.len());
    for _ in 0..DRAWS {
        let mut k = 0;
        while k < samples {
            let from = random.below(samples - block + 1);
            for j in from..from + block.min(samples - k) {
                for i in 0..3 {
                    again[3 * k + i] = fitted.residuals[3 * j + i];
                }
                k += 1;
            }
        }
        let step = inverse * columns.tr_mul(&again);
        for (sum, x) in sums.iter_mut().zip(step.iter()) {
            *sum += x * x * wider / DRAWS as f64;
        }
    }
    sums
}

/// SplitMix64: G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014. The same fit draws the same numbers.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % end as u64) as usize
    }
}
