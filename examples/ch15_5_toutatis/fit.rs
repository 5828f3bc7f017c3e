//! Least squares: the free motion that comes closest to the attitudes of December 1992.

use super::*;

/// Three small turns of the attitude (rad), three rates (rad a day), two moments over the third.
pub type Unknowns = [f64; 8];

/// The best unknowns, how well they are determined, and what remains.
#[derive(Debug, Clone)]
pub struct Fit {
    pub at: Unknowns,
    /// The scatter of one component of the attitude, rad.
    pub scatter: f64,
    pub covariance: [[f64; 8]; 8],
}

impl Fit {
    /// The standard deviation of one unknown.
    pub fn deviation(&self, i: usize) -> f64 {
        self.covariance[i][i].sqrt()
    }

    /// The standard deviation of a function of the unknowns, to first order.
    pub fn deviation_of(&self, f: impl Fn(&Unknowns) -> Result<f64>) -> Result<f64> {
        let mut slope = [0.0; 8];
        for (i, slope) in slope.iter_mut().enumerate() {
            *slope = difference(&self.at, i, |at| Ok(vec![f(at)?]))?[0];
        }
        let sum: f64 =
            (0..64).map(|k| slope[k / 8] * self.covariance[k / 8][k % 8] * slope[k % 8]).sum();
        Ok(sum.sqrt())
    }
}

/// The derivative of a vector by unknown `i`.
fn difference(
    at: &Unknowns,
    i: usize,
    f: impl Fn(&Unknowns) -> Result<Vec<f64>>,
) -> Result<Vec<f64>> {
    const H: f64 = 1e-5;
    let shifted = |h: f64| {
        let mut there = *at;
        there[i] += h;
        f(&there)
    };
    let (right, left) = (shifted(H)?, shifted(-H)?);
    Ok(right.iter().zip(left).map(|(r, l)| (r - l) / (2.0 * H)).collect())
}

// ANCHOR: gauss
/// Gauss and Newton: linearise, solve by orthogonal columns, step, until nothing moves.
pub fn least_squares(
    start: Unknowns,
    residuals: impl Fn(&Unknowns) -> Result<Vec<f64>>,
) -> Result<Fit> {
    let mut at = start;
    for _ in 0..60 {
        let mut rest = residuals(&at)?;
        let mut columns = Vec::new();
        for i in 0..8 {
            columns.push(difference(&at, i, &residuals)?);
        }
        let (squares, count) = (dot(&rest, &rest), rest.len());
        let (r, step) = solved(&mut columns, &mut rest);
        for (unknown, step) in at.iter_mut().zip(step) {
            *unknown -= step;
        }
        if largest(step) < 1e-9 {
            let scatter = (squares / (count - 8) as f64).sqrt();
            return Ok(Fit { at, scatter, covariance: covariance(&r, scatter) });
        }
    }
    Err(kit::Error::Text {
        text: "the fit".into(),
        allowed: "steps of a fit must become small in sixty",
    })
}
// ANCHOR_END: gauss

/// The triangle R of the columns (Gram and Schmidt, one at a time) and R^-1 Q^T rest.
fn solved(columns: &mut [Vec<f64>], rest: &mut [f64]) -> ([[f64; 8]; 8], Unknowns) {
    let (mut r, mut step) = ([[0.0; 8]; 8], [0.0; 8]);
    for i in 0..8 {
        let (done, others) = columns.split_at_mut(i + 1);
        let column = &mut done[i];
        r[i][i] = dot(column, column).sqrt();
        column.iter_mut().for_each(|x| *x /= r[i][i]);
        for (j, other) in others.iter_mut().enumerate() {
            r[i][i + 1 + j] = taken_off(column, other);
        }
        step[i] = taken_off(column, rest);
    }
    solved_upwards(&r, &mut step);
    (r, step)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The component of `from` along the unit vector, which is taken off.
fn taken_off(unit: &[f64], from: &mut [f64]) -> f64 {
    let along = dot(unit, from);
    from.iter_mut().zip(unit).for_each(|(x, u)| *x -= along * u);
    along
}

/// scatter^2 (R^T R)^-1.
fn covariance(r: &[[f64; 8]; 8], scatter: f64) -> [[f64; 8]; 8] {
    let columns: [Unknowns; 8] = core::array::from_fn(|j| {
        let mut column = [0.0; 8];
        column[j] = 1.0;
        solved_upwards(r, &mut column);
        column
    });
    let entry = |i: usize, j: usize| columns.iter().map(|c| c[i] * c[j]).sum::<f64>();
    core::array::from_fn(|i| core::array::from_fn(|j| scatter * scatter * entry(i, j)))
}

/// R^-1 of a vector, in its place.
fn solved_upwards(r: &[[f64; 8]; 8], vector: &mut Unknowns) {
    for i in (0..8).rev() {
        let known: f64 = (i + 1..8).map(|j| r[i][j] * vector[j]).sum();
        vector[i] = (vector[i] - known) / r[i][i];
    }
}

/// The middle of the measured days of December, s after the epoch.
pub const MIDDLE: f64 = 30.0 * DAY;

/// The unknowns of a start at the epoch.
pub fn unknowns(start: &Start) -> Result<Unknowns> {
    let [x, y, z] = (start.motion()?.angular_velocity(MIDDLE) * DAY).to_array();
    let [a, b, _] = start.moments;
    Ok([0.0, 0.0, 0.0, x, y, z, a, b])
}

/// The start in the middle that they stand for; small turns are counted from `reference`.
pub fn start(at: &Unknowns, reference: &Attitude) -> Result<Start> {
    let [a, b, c, x, y, z, moment_x, moment_y] = *at;
    let attitude = reference.turned_in_space(SpaceVector::new(a, b, c))?;
    let angular_velocity = BodyVector::new(x, y, z) / DAY;
    Ok(Start { moments: [moment_x, moment_y, 1.0], attitude, angular_velocity })
}

/// The scatter of each unknown when one day after the other is left out (the jackknife).
pub fn jackknife(days: &[Observed], from: &Start, guess: Unknowns) -> Result<Unknowns> {
    let n = days.len() as f64;
    let mut all = Vec::new();
    for out in 0..days.len() {
        let mut left = days.to_vec();
        left.remove(out);
        all.push(fitted(&left, from, guess, in_closed_form)?.at);
    }
    Ok(core::array::from_fn(|i| {
        let mean = all.iter().map(|at| at[i]).sum::<f64>() / n;
        let squares: f64 = all.iter().map(|at| (at[i] - mean) * (at[i] - mean)).sum();
        ((n - 1.0) / n * squares).sqrt()
    }))
}
