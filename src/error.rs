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
    /// A number and the independent route that should confirm it differ too much.
    Contradicted {
        key: String,
        value: f64,
        oracle: String,
        oracle_value: f64,
        bound: f64,
    },
    /// A name or a piece of text does not fit where it is to be printed.
    Text { text: String, allowed: &'static str },
    /// There is no claim with this key.
    UnknownKey { key: String, known: String },
    /// A file cannot be written.
    File { path: String, reason: String },
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
            Self::Contradicted {
                key,
                value,
                oracle,
                oracle_value,
                bound,
            } => write!(
                f,
                "{key} = {value:?} is contradicted: {oracle} gives {oracle_value:?}, \
                 and they may differ by {bound:?}"
            ),
            Self::Text { text, allowed } => write!(f, "{text:?} is not allowed: {allowed}"),
            Self::UnknownKey { key, known } => {
                write!(f, "there is no {key}; there are: {known}")
            }
            Self::File { path, reason } => write!(f, "{path} cannot be written: {reason}"),
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
