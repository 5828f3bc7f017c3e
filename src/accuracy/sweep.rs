//! Work against error: a method, run coarser and finer.

use super::measures::{Errors, Measure};
use crate::error::{Error, Result, finite, positive};
use crate::integrators::Work;
use crate::math::{log10, pow, sort_by_number};

/// One run of a method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Run {
    /// The setting: a number of steps, a tolerance.
    pub setting: f64,
    /// Its cost.
    pub work: Work,
    /// The error that it delivered.
    pub errors: Errors,
}

/// A method run over a range of settings, on one problem.
///
/// ```
/// use rotation_dynamics::accuracy::{Errors, Measure, Sweep};
/// use rotation_dynamics::integrators::{Integrator, Rk4, Work};
/// use rotation_dynamics::math::{exp2, pow};
/// # use rotation_dynamics::{attitude::Attitude, body::RigidBody, exact::free_body::FreeBody};
/// # use rotation_dynamics::{frame::BodyVector, inertia::PrincipalMoments, scene::Scene};
/// # fn main() -> rotation_dynamics::Result<()> {
/// # let moments = PrincipalMoments::new(1.0, 2.0, 2.5)?;
/// # let rates = BodyVector::new(0.8, 0.4, 0.3375);
/// # let scene = Scene::new(RigidBody::new(moments));
/// # let start = scene.body().state(Attitude::IDENTITY, rates)?;
/// # let exact = FreeBody::new(moments, Attitude::IDENTITY, rates)?.state(10.0);
/// // A free body for ten seconds: `scene`, `start` and the `exact` end.
/// let steps = (0..24).map(|k| 16.0 * exp2(0.5 * f64::from(k)));
/// let sweep = Sweep::over(steps, |steps| {
///     let (end, work) = Rk4::new(steps as u64)?.advance(&scene, 0.0, &start, 10.0)?;
///     Ok((Errors::between(&scene, &end, &exact), work))
/// });
/// let curve = sweep.curve(Measure::Attitude, Work::torques)?;
/// let price = curve.price_of_a_digit(1e-11, 1e-4).expect("enough runs");
/// assert!((price.order - 4.0).abs() < 0.03);
/// assert!((price.factor - pow(10.0, 0.25)).abs() < 0.01);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    runs: Vec<Run>,
    refused: Vec<(f64, Error)>,
}

impl Sweep {
    /// Runs a method with each setting, in the order given.
    ///
    /// A run that is refused, or whose errors are not finite, is kept apart with the
    /// reason ([`Sweep::refused`]): steps too long to converge are a finding too.
    pub fn over(
        settings: impl IntoIterator<Item = f64>,
        run: impl Fn(f64) -> Result<(Errors, Work)>,
    ) -> Self {
        let mut sweep = Self { runs: Vec::new(), refused: Vec::new() };
        for setting in settings {
            let outcome = run(setting).and_then(|(errors, work)| {
                for measure in Measure::ALL {
                    finite("error of a run", errors.get(measure))?;
                }
                Ok((errors, work))
            });
            match outcome {
                Ok((errors, work)) => sweep.runs.push(Run { setting, work, errors }),
                Err(error) => sweep.refused.push((setting, error)),
            }
        }
        sweep
    }

    /// The runs that came to an end.
    pub fn runs(&self) -> &[Run] {
        &self.runs
    }

    /// The settings with which there was no run, and why.
    pub fn refused(&self) -> &[(f64, Error)] {
        &self.refused
    }

    /// The runs in one measure of error and one count of work.
    ///
    /// Errors: as [`WorkPrecision::new`].
    pub fn curve(&self, measure: Measure, count: impl Fn(&Work) -> u64) -> Result<WorkPrecision> {
        WorkPrecision::new(
            self.runs
                .iter()
                .map(|run| Point { work: count(&run.work) as f64, error: run.errors.get(measure) }),
        )
    }
}

/// The cost of one run, and its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// The work, in any count.
    pub work: f64,
    /// The error, in any measure.
    pub error: f64,
}

/// The runs of a method on one problem, in one measure, from the cheapest to the dearest.
///
/// *Luck.* An error that changes its sign on the way down is tiny in one run and not
/// in the next. So a level counts as reached only where the next more expensive run is below
/// it too (of the dearest run nothing more can be asked).
#[derive(Debug, Clone, PartialEq)]
pub struct WorkPrecision {
    points: Vec<Point>,
}

/// The price of one more digit, and the price that the order of the method lets one expect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DigitPrice {
    /// Measured: the factor in work for a tenth of the error.
    pub factor: f64,
    /// The order that belongs to it: error proportional to work^-order.
    pub order: f64,
    /// The largest distance of a run from the fitted line, in digits.
    pub scatter: f64,
    /// How many runs were fitted.
    pub runs: usize,
    /// The fitted line's work at the error 1, which no run need have.
    pub at_one: f64,
}

impl DigitPrice {
    /// The work at which the fitted line reaches this error.
    ///
    /// Errors: an error that is not positive and finite.
    pub fn work_for(&self, error: f64) -> Result<f64> {
        Ok(self.at_one * pow(positive("error", error)?, -1.0 / self.order))
    }

    /// The price by the order alone: 10^(1/order).
    ///
    /// Errors: order 0.
    pub fn predicted(order: u32) -> Result<f64> {
        Ok(pow(10.0, 1.0 / positive("order", f64::from(order))?))
    }
}

impl WorkPrecision {
    /// These runs, in any order.
    ///
    /// Errors: work that is not positive and finite, an error that is negative or not
    /// finite.
    pub fn new(points: impl IntoIterator<Item = Point>) -> Result<Self> {
        let mut points: Vec<Point> = points.into_iter().collect();
        for point in &points {
            positive("work", point.work)?;
            if finite("error", point.error)? < 0.0 {
                return Err(Error::out_of_range("error", point.error, "0 or more"));
            }
        }
        sort_by_number(&mut points, |point| point.work);
        Ok(Self { points })
    }

    /// The runs, from the cheapest to the dearest.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// For each run, its error or the error of the next more expensive run, whichever is larger.
    fn dependable(&self) -> impl Iterator<Item = Point> + '_ {
        self.points.iter().enumerate().map(|(i, point)| Point {
            work: point.work,
            error: match self.points.get(i + 1) {
                Some(next) => point.error.max(next.error),
                None => point.error,
            },
        })
    }

    /// The cheapest run whose error is at most `requested`, not by luck alone.
    pub fn least_work(&self, requested: f64) -> Option<Point> {
        let at = self.dependable().position(|p| p.error <= requested)?;
        self.points.get(at).copied()
    }

    /// The smallest error that the method reaches, not by luck alone, and the least
    /// work that reaches it: below it more work does not help.
    ///
    /// A method whose dearest run is still gaining has not shown its floor: then this
    /// is the end of the runs.
    pub fn floor(&self) -> Option<Point> {
        // The dearest run has no neighbour to confirm it.
        let confirmed = self.points.len().saturating_sub(1);
        (self.dependable().take(confirmed)).min_by(|a, b| a.error.total_cmp(&b.error))
    }

    /// The price of one more digit: by least squares on the logarithms of the errors between `low`
    /// and `high`, both ends included.
    ///
    /// `None` with fewer than four runs there, or where work buys nothing.
    pub fn price_of_a_digit(&self, low: f64, high: f64) -> Option<DigitPrice> {
        let logs: Vec<(f64, f64)> = (self.points.iter())
            .filter(|p| p.error > 0.0 && (low..=high).contains(&p.error))
            .map(|p| (log10(p.work), log10(p.error)))
            .collect();
        if logs.len() < 4 {
            return None;
        }
        let n = logs.len() as f64;
        let mean = |of: fn(&(f64, f64)) -> f64| logs.iter().map(of).sum::<f64>() / n;
        let (mx, my) = (mean(|p| p.0), mean(|p| p.1));
        let across: f64 = logs.iter().map(|(x, y)| (x - mx) * (y - my)).sum();
        let along: f64 = logs.iter().map(|(x, _)| (x - mx) * (x - mx)).sum();
        let order = -across / along;
        if !(order.is_finite() && order > 0.0) {
            return None;
        }
        let off = |(x, y): &(f64, f64)| (y - my + order * (x - mx)).abs();
        Some(DigitPrice {
            factor: pow(10.0, 1.0 / order),
            order,
            scatter: logs.iter().map(off).fold(0.0, f64::max),
            runs: logs.len(),
            at_one: pow(10.0, mx + my / order),
        })
    }
}

/// The Pareto front of several methods: the runs than which none is both cheaper and
/// better, from the cheapest on, each with the index of its method.
pub fn front(curves: &[WorkPrecision]) -> Vec<(usize, Point)> {
    let mut all: Vec<(usize, Point)> = (curves.iter().enumerate())
        .flat_map(|(method, curve)| curve.points.iter().map(move |p| (method, *p)))
        .collect();
    sort_by_number(&mut all, |(_, point)| point.error);
    sort_by_number(&mut all, |(_, point)| point.work);
    let mut best = f64::INFINITY;
    all.retain(|(_, point)| {
        let better = point.error < best;
        best = best.min(point.error);
        better
    });
    all
}
