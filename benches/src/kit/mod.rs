//! The accuracy kit: what this library answers to a row of a kit's input file.
//!
//! A file `<family>.in` has one row of numbers per case; which function answers
//! it is told by the family's name. One module per part of the kit.

pub mod attitude;
pub mod elliptic;
pub mod pendulum;

/// The answer to one row, or why there is none.
pub type Answer = Result<Vec<f64>, String>;

/// The function that answers the rows of a family, if this library has one.
pub fn answerer(family: &str) -> Option<fn(&[&str]) -> Answer> {
    attitude::answerer(family)
        .or_else(|| elliptic::answerer(family))
        .or_else(|| pendulum::answerer(family))
}

/// The columns of a row as numbers.
pub fn numbers(columns: &[&str]) -> Result<Vec<f64>, String> {
    columns.iter().map(|c| c.parse().map_err(|e| format!("{c}: {e}"))).collect()
}
