//! The one error type of the library.
//!
//! Every variant carries the numbers that offend and says what is allowed, so
//! that a message can be acted on without reading code.

use core::fmt;

/// What can go wrong, with the numbers that went wrong.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub enum Error {
    /// An input is NaN or infinite.
    NotFinite { name: &'static str, value: f64 },
    /// An input lies outside the range in which it means something.
    OutOfRange {
        name: &'static str,
        value: f64,
        allowed: &'static str,
    },
}

/// `Result` with this crate's [`Error`].
pub type Result<T> = core::result::Result<T, Error>;

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { name, value } => {
                write!(f, "{name} = {value} is not a finite number")
            }
            Self::OutOfRange {
                name,
                value,
                allowed,
            } => write!(f, "{name} = {value} is not allowed: {allowed}"),
        }
    }
}

impl std::error::Error for Error {}

/// Returns `value` if it is finite.
pub(crate) fn finite(name: &'static str, value: f64) -> Result<f64> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Error::NotFinite { name, value })
    }
}

/// Returns `value` if it is finite and greater than zero.
pub(crate) fn positive(name: &'static str, value: f64) -> Result<f64> {
    finite(name, value)?;
    if value > 0.0 {
        Ok(value)
    } else {
        Err(Error::OutOfRange {
            name,
            value,
            allowed: "it must be greater than 0",
        })
    }
}
