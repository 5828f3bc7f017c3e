//! Small tools of the pages: a copy with a change, bisection, a condition.

use core::convert::Infallible;
use rotation_dynamics::{Error, Result};

/// The same, but for a change: of parameters, of a body, of a machine.
pub trait But: Clone {
    /// A copy with this change.
    ///
    /// ```
    /// use kit::But;
    /// #[derive(Clone)]
    /// struct Pendulum { length: f64, mass: f64, friction: f64 }
    /// let plain = Pendulum { length: 1.0, mass: 0.2, friction: 0.0 };
    /// let short = plain.but(|p| p.length = 0.5);
    /// let rough = plain.but(|p| (p.mass, p.friction) = (0.3, 0.1));
    /// assert_eq!((short.mass, rough.length), (0.2, 1.0));
    /// ```
    #[must_use]
    fn but(&self, change: impl FnOnce(&mut Self)) -> Self {
        let mut changed = self.clone();
        change(&mut changed);
        changed
    }
}

impl<T: Clone> But for T {}

/// The last place between `low` and `high` that is below what is looked for, and the first one
/// that is not: found by halving until they are `within` this of each other, or neighbours.
///
/// ```
/// use kit::bisect;
/// let [low, high] = bisect([1.0, 2.0], 0.0, |x| x * x < 2.0);
/// assert!(low * low < 2.0 && high * high >= 2.0 && high - low < 3e-16);
/// let [low, high] = bisect([1.0, 2.0], 0.1, |x| x * x < 2.0);
/// assert_eq!([low, high], [1.375, 1.4375]);
/// ```
pub fn bisect(ends: [f64; 2], within: f64, mut below: impl FnMut(f64) -> bool) -> [f64; 2] {
    let Ok(found) = try_bisect(ends, within, |x| Ok::<_, Infallible>(below(x)));
    found
}

/// [`bisect`], where it may be impossible to say whether a place is below.
///
/// # Errors
/// Those of `below`.
pub fn try_bisect<E>(
    [mut low, mut high]: [f64; 2],
    within: f64,
    mut below: impl FnMut(f64) -> core::result::Result<bool, E>,
) -> core::result::Result<[f64; 2], E> {
    loop {
        let middle = 0.5 * (low + high);
        if (high - low).abs() <= within || middle == low || middle == high {
            return Ok([low, high]);
        }
        if below(middle)? {
            low = middle;
        } else {
            high = middle;
        }
    }
}

/// The integral of a function over this span by Simpson's rule, with so many pieces, an even number.
///
/// ```
/// use kit::simpson;
/// let cube = simpson([0.0, 2.0], 2, |x: f64| Ok::<_, kit::Error>(x * x * x))?;
/// assert_eq!(cube, 4.0);
/// # Ok::<(), kit::Error>(())
/// ```
///
/// # Errors
/// The first of `f`.
pub fn simpson<E>(
    [from, to]: [f64; 2],
    pieces: u32,
    f: impl Fn(f64) -> core::result::Result<f64, E>,
) -> core::result::Result<f64, E> {
    let h = (to - from) / f64::from(pieces);
    let mut sum = 0.0;
    for i in 0..=pieces {
        let inside = 2.0 + 2.0 * f64::from(i % 2);
        let weight = if i == 0 || i == pieces { 1.0 } else { inside };
        sum += weight * f(from + h * f64::from(i))?;
    }
    Ok(sum * h / 3.0)
}

/// What `run` finds, if it is `sound` to run it: beyond its limits nothing is measured.
///
/// ```
/// use kit::when;
/// let root = |x: f64| x.to_string().parse::<u32>();
/// assert_eq!(when(true, || root(4.0)), Ok(Some(4)));
/// assert_eq!(when(false, || root(-4.0)), Ok(None));
/// assert!(when(true, || root(-4.0)).is_err());
/// ```
///
/// # Errors
/// Those of `run`.
pub fn when<T, E>(
    sound: bool,
    run: impl FnOnce() -> core::result::Result<T, E>,
) -> core::result::Result<Option<T>, E> {
    sound.then(run).transpose()
}

/// Nothing if it `holds`; else that `name` may not have this `value`, and what is allowed.
///
/// ```
/// use kit::require;
/// let said = require(1.0 > 2.0, "angle", 2.0, "flat it lies").unwrap_err().to_string();
/// assert_eq!(said, "angle = 2 is not allowed: flat it lies");
/// assert!(require(1.0 < 2.0, "angle", 1.0, "flat it lies").is_ok());
/// ```
///
/// # Errors
/// [`Error::OutOfRange`].
pub fn require(holds: bool, name: &'static str, value: f64, allowed: &'static str) -> Result<()> {
    let refused = || Error::out_of_range(name, value, allowed);
    holds.then_some(()).ok_or_else(refused)
}

/// The solution of linear equations, by elimination with the largest pivot of each column;
/// infinite or NaN where there is none. For a few of them, such as Newton's law for each body.
///
/// ```
/// use kit::solved;
/// assert_eq!(solved([[0.0, 2.0], [1.0, 1.0]], [4.0, 5.0]), [3.0, 2.0]);
/// assert!(!solved([[1.0, 1.0], [1.0, 1.0]], [1.0, 2.0])[0].is_finite());
/// ```
pub fn solved<const N: usize>(mut rows: [[f64; N]; N], mut right: [f64; N]) -> [f64; N] {
    for k in 0..N {
        let larger = |&i: &usize, &j: &usize| rows[i][k].abs().total_cmp(&rows[j][k].abs());
        let best = (k..N).max_by(larger).unwrap_or(k);
        rows.swap(k, best);
        right.swap(k, best);
        for i in (0..N).filter(|&i| i != k) {
            let (part, row) = (rows[i][k] / rows[k][k], rows[k]);
            rows[i].iter_mut().zip(row).for_each(|(a, b)| *a -= part * b);
            right[i] -= part * right[k];
        }
    }
    core::array::from_fn(|k| right[k] / rows[k][k])
}
