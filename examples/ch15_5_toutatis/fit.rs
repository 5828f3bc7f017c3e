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
    /// The columns of scatter R^-1: the covariance is their product with themselves.
    pub spread: [Unknowns; 8],
}

impl Fit {
    /// The standard deviation of a quantity with these slopes, to first order.
    fn deviation_of(&self, slope: impl Fn(usize) -> f64) -> f64 {
        let along = |column: &Unknowns| (0..8).map(|i| slope(i) * column[i]).sum::<f64>();
        let squares = self.spread.iter().map(|column| along(column) * along(column));
        squares.sum::<f64>().sqrt()
    }

    /// That of one unknown.
    pub fn deviation(&self, unknown: usize) -> f64 {
        self.deviation_of(|i| f64::from(i == unknown))
    }

    /// Those of the two periods, s.
    pub fn deviations_of_periods(&self) -> Result<[f64; 2]> {
        let slopes = slopes(&self.at, |at| Ok(start(at)?.periods()?.to_vec()))?;
        Ok([0, 1].map(|which| self.deviation_of(|i| slopes[i][which])))
    }

    /// Each unknown beside the published one, with two opinions on its error.
    pub fn table(&self) -> Result<Table> {
        let columns =
            ["quantity", "published", "fitted", "by the curvature", "by leaving a day out"];
        let (guess, loose) = (unknowns()?, jackknife(&observed()?.0, self.at)?);
        let rows = "turn about X, deg;turn about Y, deg;turn about Z, deg;rate about x, deg/d;\
            rate about y, deg/d;rate about the long axis, deg/d;moment about x;moment about y";
        Table::of("fit", columns, rows.split(';').enumerate(), |(i, name)| {
            let unit = if name.contains("deg") { 1.0_f64.to_degrees() } else { 1.0 };
            let cells = [guess[i], self.at[i], self.deviation(i), loose[i]];
            let cells = cells.map(|value| format!("{:.2}", value * unit));
            Ok([[name.to_string()].as_slice(), &cells].concat())
        })
    }
}

/// The derivatives of a vector by each of the unknowns.
fn slopes(at: &Unknowns, f: impl Fn(&Unknowns) -> Result<Vec<f64>>) -> Result<Vec<Vec<f64>>> {
    const H: f64 = 1e-5;
    let slope = |i: usize| {
        let shifted = |h: f64| f(&at.but(|at| at[i] += h));
        let (right, left) = (shifted(H)?, shifted(-H)?);
        Ok(right.iter().zip(left).map(|(r, l)| (r - l) / (2.0 * H)).collect())
    };
    (0..8).map(slope).collect()
}

// ANCHOR: gauss
/// Gauss and Newton: linearise, solve by orthogonal columns, step, until nothing moves.
pub fn least_squares(
    start: Unknowns,
    residuals: impl Fn(&Unknowns) -> Result<Vec<f64>>,
) -> Result<Fit> {
    let mut at = start;
    for _ in 0..60 {
        let (mut columns, rest) = (slopes(&at, &residuals)?, residuals(&at)?);
        let (squares, count) = (dot(&rest, &rest), rest.len());
        columns.push(rest);
        let r = orthogonal(columns);
        let step = solved_upwards(&r, r.map(|row| row[8]));
        for (unknown, step) in at.iter_mut().zip(step) {
            *unknown -= step;
        }
        if largest(step) < 1e-9 {
            let scatter = (squares / (count - 8) as f64).sqrt();
            let unit = |j: usize| core::array::from_fn(|i| scatter * f64::from(i == j));
            let spread = core::array::from_fn(|j| solved_upwards(&r, unit(j)));
            return Ok(Fit { at, scatter, spread });
        }
    }
    Err(kit::Error::Text {
        text: "the fit".into(),
        allowed: "steps of a fit must become small in sixty",
    })
}
// ANCHOR_END: gauss

/// The triangle R of eight columns, made orthogonal one after the other (Gram and Schmidt), and
/// beside it the components of the ninth along them.
fn orthogonal(mut columns: Vec<Vec<f64>>) -> [[f64; 9]; 8] {
    let mut r = [[0.0; 9]; 8];
    for (i, row) in r.iter_mut().enumerate() {
        let (done, others) = columns.split_at_mut(i + 1);
        let unit = &mut done[i];
        row[i] = dot(unit, unit).sqrt();
        unit.iter_mut().for_each(|x| *x /= row[i]);
        for (along, other) in row[i + 1..].iter_mut().zip(others) {
            *along = dot(unit, other);
            other.iter_mut().zip(&*unit).for_each(|(x, u)| *x -= *along * u);
        }
    }
    r
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// R^-1 of a vector.
fn solved_upwards(r: &[[f64; 9]; 8], mut vector: Unknowns) -> Unknowns {
    for i in (0..8).rev() {
        let known: f64 = (i + 1..8).map(|j| r[i][j] * vector[j]).sum();
        vector[i] = (vector[i] - known) / r[i][i];
    }
    vector
}

/// The middle of the measured days of December, s after the epoch.
const MIDDLE: f64 = 30.0 * DAY;

/// The published state in that middle, whatever the parameters are: the fit begins there.
fn middle() -> Result<Start> {
    Start::of(numbers(&Parameters::default()))?.at(MIDDLE)
}

/// Its unknowns.
pub fn unknowns() -> Result<Unknowns> {
    let Start { moments: [a, b, _], angular_velocity, .. } = middle()?;
    let [x, y, z] = (angular_velocity * DAY).to_array();
    Ok([0.0, 0.0, 0.0, x, y, z, a, b])
}

/// The free motion closest to December.
pub fn best() -> Result<Fit> {
    fitted(&observed()?.0, unknowns()?, in_closed_form)
}

/// The start in the middle that they stand for; small turns are counted from [`middle`].
pub fn start([a, b, c, x, y, z, moment_x, moment_y]: &Unknowns) -> Result<Start> {
    let middle = middle()?;
    Ok(Start {
        moments: [*moment_x, *moment_y, 1.0],
        attitude: middle.attitude.turned_in_space(SpaceVector::new(*a, *b, *c))?,
        angular_velocity: BodyVector::new(*x, *y, *z) / DAY,
        ..middle
    })
}

/// The scatter of each unknown when one day after the other is left out (the jackknife).
pub fn jackknife(days: &[Observed], guess: Unknowns) -> Result<Unknowns> {
    let n = days.len() as f64;
    let without = |out: usize| {
        let left = [&days[..out], &days[out + 1..]].concat();
        Ok(fitted(&left, guess, in_closed_form)?.at)
    };
    let all = (0..days.len()).map(without).collect::<Result<Vec<Unknowns>>>()?;
    Ok(core::array::from_fn(|i| {
        let mean = all.iter().map(|at| at[i]).sum::<f64>() / n;
        let squares: f64 = all.iter().map(|at| (at[i] - mean) * (at[i] - mean)).sum();
        ((n - 1.0) / n * squares).sqrt()
    }))
}
