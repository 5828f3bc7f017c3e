//! Which values a parameter may take.

use crate::error::{Error, Result};
use core::fmt;
use rotation_dynamics::error::plain;

/// An interval of real numbers; infinite ends are never included.
///
/// Its text says what is allowed, for error messages and `--help`.
///
/// ```
/// use kit::interval::{above, from_to};
/// assert!(above(0.0).contains(1e-300) && !above(0.0).contains(0.0));
/// assert!(!from_to(0.0, 1.0).contains(f64::NAN));
/// assert_eq!(from_to(0.0, 1.0).to_string(), "it must be from 0 to 1");
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    low: f64,
    high: f64,
    closed: [bool; 2],
    usual: Option<[f64; 2]>,
    nonzero: bool,
    reason: Option<&'static str>,
}

const fn interval(low: f64, high: f64, closed: [bool; 2]) -> Interval {
    Interval { low, high, closed, usual: None, nonzero: false, reason: None }
}

/// Any finite number.
pub const fn any() -> Interval {
    interval(f64::NEG_INFINITY, f64::INFINITY, [false; 2])
}

/// Greater than `low`.
pub const fn above(low: f64) -> Interval {
    interval(low, f64::INFINITY, [false; 2])
}

/// `low` or greater.
pub const fn at_least(low: f64) -> Interval {
    interval(low, f64::INFINITY, [true, false])
}

/// Greater than `low` and less than `high`.
pub const fn between(low: f64, high: f64) -> Interval {
    interval(low, high, [false; 2])
}

/// From `low` to `high`, both included.
pub const fn from_to(low: f64, high: f64) -> Interval {
    interval(low, high, [true; 2])
}

/// Greater than `low`, at most `high`.
pub const fn above_to(low: f64, high: f64) -> Interval {
    interval(low, high, [false, true])
}

impl Interval {
    /// Sets the part in which a reader will want to move a slider.
    #[must_use]
    pub const fn usually(mut self, low: f64, high: f64) -> Self {
        self.usual = Some([low, high]);
        self
    }

    /// The part in which a reader will want to move, if it is narrower than the interval.
    pub(crate) fn usual(&self) -> Option<[f64; 2]> {
        self.usual
    }

    /// Excludes zero, where nothing moves: the reason is to be given.
    ///
    /// ```
    /// use kit::interval::any;
    /// let rate = any().but_zero("at rest nothing rolls");
    /// assert!(rate.contains(-2.0) && !rate.contains(-0.0));
    /// assert_eq!(rate.to_string(), "it must be finite, and not 0 (at rest nothing rolls)");
    /// ```
    #[must_use]
    pub const fn but_zero(mut self, reason: &'static str) -> Self {
        self.nonzero = true;
        self.because(reason)
    }

    /// Says why it ends where it does: the physics, or the limit of the method.
    ///
    /// ```
    /// use kit::interval::between;
    /// let ellipse = between(-1.0, 1.0).because("an orbit that closes");
    /// assert_eq!(ellipse.to_string(), "it must lie between -1 and 1 (an orbit that closes)");
    /// ```
    #[must_use]
    pub const fn because(mut self, reason: &'static str) -> Self {
        self.reason = Some(reason);
        self
    }

    /// Why it ends where it does, if that is said.
    pub fn reason(&self) -> Option<&'static str> {
        self.reason
    }

    /// `value` itself, if the interval contains it; `name` says in the error what it is.
    ///
    /// The error has six digits of a computed value, or all if these six would be allowed.
    /// ```
    /// use kit::interval::from_to;
    /// let said = |value: f64| from_to(0.0, 1.0).check("m/M", value).map_err(|e| e.to_string());
    /// assert_eq!(said(3.1 / 3.0), Err("m/M = 1.03333 is not allowed: it must be from 0 to 1".into()));
    /// assert!(said(1.0 + f64::EPSILON).is_err_and(|e| e.starts_with("m/M = 1.0000000000000002 is")));
    /// ```
    ///
    /// # Errors
    /// [`Error::Parameter`] if it does not.
    pub fn check(&self, name: &'static str, value: f64) -> Result<f64> {
        let allowed = *self;
        let error = Error::Parameter { name, value, allowed };
        self.contains(value).then_some(value).ok_or(error)
    }

    /// True if `value` is finite and lies in the interval.
    pub fn contains(&self, value: f64) -> bool {
        let [low, high] = self.closed;
        let above = value > self.low || (low && value == self.low);
        let below = value < self.high || (high && value == self.high);
        above && below && value.is_finite() && !(self.nonzero && value == 0.0)
    }
}

impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let finite = [self.low, self.high].map(f64::is_finite);
        let [low, high] = [self.low, self.high].map(plain);
        match (finite[0], finite[1], self.closed) {
            (false, false, _) => write!(f, "it must be finite"),
            (true, false, [false, _]) => write!(f, "it must be greater than {low}"),
            (true, false, [true, _]) => write!(f, "it must be at least {low}"),
            (false, true, [_, false]) => write!(f, "it must be less than {high}"),
            (false, true, [_, true]) => write!(f, "it must be at most {high}"),
            (true, true, [true, true]) => write!(f, "it must be from {low} to {high}"),
            (true, true, [false, true]) => {
                write!(f, "it must be greater than {low} and at most {high}")
            }
            (true, true, [true, false]) => {
                write!(f, "it must be at least {low} and less than {high}")
            }
            (true, true, [false, false]) => write!(f, "it must lie between {low} and {high}"),
        }?;
        if self.nonzero {
            write!(f, ", and not 0")?;
        }
        self.reason.map_or(Ok(()), |reason| write!(f, " ({reason})"))
    }
}
