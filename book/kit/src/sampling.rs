//! Sampling a motion, for figures and tables.

use crate::error::Result;

/// `count + 1` equally spaced times from `from` to `to`, both exactly included.
///
/// ```
/// use kit::times;
/// assert_eq!(times(0.0, 0.3, 3).last(), Some(0.3));
/// assert_eq!(times(1.0, 2.0, 4).count(), 5);
/// ```
pub fn times(from: f64, to: f64, count: u32) -> impl Iterator<Item = f64> + Clone {
    (0..=count).map(move |i| {
        if i == count { to } else { from + (to - from) * f64::from(i) / f64::from(count) }
    })
}

/// What `sample` gives at each of these times, or its first error.
///
/// ```
/// use kit::{sampled, times};
/// let squares = sampled(times(0.0, 2.0, 2), |t| Ok((t, t * t)))?;
/// assert_eq!(squares, [(0.0, 0.0), (1.0, 1.0), (2.0, 4.0)]);
/// # Ok::<(), kit::Error>(())
/// ```
///
/// # Errors
/// Those of `sample`.
pub fn sampled<T>(
    times: impl IntoIterator<Item = f64>,
    mut sample: impl FnMut(f64) -> Result<T>,
) -> Result<Vec<T>> {
    // Pages sample hundreds of functions, and a loop is a fifth of the code of `collect`.
    let mut samples = Vec::new();
    for t in times {
        samples.push(sample(t)?);
    }
    Ok(samples)
}
