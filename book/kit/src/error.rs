//! What can go wrong on a page: what only pages raise, and what the library refuses.

use crate::interval::Interval;
use core::fmt;
use rotation_dynamics::error::plain;
pub(crate) use rotation_dynamics::error::{finite, positive};

/// What can go wrong on a page, with the numbers that went wrong.
#[non_exhaustive]
#[derive(Debug, Clone, PartialEq)]
pub enum Error {
    /// What the library refuses, in its words.
    Library(rotation_dynamics::Error),
    /// A parameter of an example is outside what is allowed.
    Parameter { name: &'static str, value: f64, allowed: Interval },
    /// A number and the independent route that should confirm it differ too much.
    Contradicted { key: String, value: f64, oracle: String, oracle_value: f64, bound: f64 },
    /// A name or a piece of text does not fit where it is to be printed.
    Text { text: String, allowed: &'static str },
    /// There is no claim with this key.
    UnknownKey { key: String, known: String },
    /// A file cannot be written.
    File { path: String, reason: String },
    /// A recording cannot be read or used; in which line (from 1) and column, if it is one place.
    Recording { line: Option<usize>, column: Option<String>, reason: String },
    /// A file cannot be read.
    Unread { path: String, reason: String },
}

/// `Result` with this crate's [`Error`].
pub type Result<T> = core::result::Result<T, Error>;

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Library(error) => error.fmt(f),
            Self::Parameter { name, value, allowed } => {
                // Of what was computed six digits say enough, unless the value they say is allowed.
                let text = plain(*value);
                let short = format!("{value:.5e}").parse().unwrap_or(*value);
                let text = match text.len() > 12 && !allowed.contains(short) {
                    true => plain(short),
                    false => text,
                };
                write!(f, "{name} = {text} is not allowed: {allowed}")
            }
            Self::Contradicted { key, value, oracle, oracle_value, bound } => write!(
                f,
                "{key} = {value:?} is contradicted: {oracle} gives {oracle_value:?}, \
                 and they may differ by {bound:?}"
            ),
            Self::Text { text, allowed } => write!(f, "{text:?} is not allowed: {allowed}"),
            Self::UnknownKey { key, known } => {
                write!(f, "there is no {key}; there are: {known}")
            }
            Self::File { path, reason } => write!(f, "{path} cannot be written: {reason}"),
            Self::Recording { line, column, reason } => {
                match (line, column) {
                    (Some(line), Some(column)) => write!(f, "line {line}, column {column}: ")?,
                    (Some(line), None) => write!(f, "line {line}: ")?,
                    (None, Some(column)) => write!(f, "column {column}: ")?,
                    (None, None) => {}
                }
                f.write_str(reason)
            }
            Self::Unread { path, reason } => write!(f, "{path} cannot be read: {reason}"),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Library(error) => error.source(),
            _ => None,
        }
    }
}

impl From<rotation_dynamics::Error> for Error {
    fn from(error: rotation_dynamics::Error) -> Self {
        Self::Library(error)
    }
}
