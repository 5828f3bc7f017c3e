//! Lines of the accuracy strip for a run whose error can be asked for.

use super::computation::Computation;
use super::sections::Price;
use crate::error::{Error, Result};
use crate::integrators::Work;

/// For each error of `requested` a line of the strip: what `run` delivers for it, as
/// `error` judges the result, and its work; all of them can be timed.
///
/// ```
/// use rotation_dynamics::integrators::Work;
/// use rotation_dynamics::report::prices;
/// // Newton's root of 2, until two steps agree.
/// let root = |tolerance: f64| {
///     let (mut x, mut work) = (1.0_f64, Work::default());
///     while (x - 2.0 / x).abs() > tolerance {
///         x = 0.5 * (x + 2.0 / x);
///         work.steps += 1;
///     }
///     Ok((x, work))
/// };
/// let lines = prices("Newton", &[1e-3, 1e-9], root, |x| Ok((x - 2.0_f64.sqrt()).abs()))?;
/// assert_eq!(lines[1].work, "4 steps");
/// assert!(lines[1].delivered < 1e-12);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
///
/// # Errors
/// Those of `run` and `error`. An error that `run` refuses to deliver
/// ([`Error::NotDelivered`]) is a line that says so, with what it could.
pub fn prices<T>(
    method: &str,
    requested: &[f64],
    run: impl Fn(f64) -> Result<(T, Work)> + Copy + Send + Sync + 'static,
    error: impl Fn(&T) -> Result<f64> + Copy + Send + Sync + 'static,
) -> Result<Vec<Price>> {
    let line = |&asked: &f64| {
        let (delivered, work, again) = match run(asked) {
            Ok((result, work)) => {
                let again = Computation::new(move || run(asked), move |(result, _)| error(result));
                (error(&result)?, work.to_string(), Some(again))
            }
            Err(Error::NotDelivered { reached, .. }) => (reached, "refused".into(), None),
            Err(other) => return Err(other),
        };
        Ok(Price {
            method: method.into(),
            requested: Some(asked),
            delivered,
            work,
            again,
        })
    };
    requested.iter().map(line).collect()
}
