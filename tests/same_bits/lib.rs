//! What every example prints and draws, from a module that has no platform around it.
//!
//! `.ci/same_bits` builds this for `wasm32-unknown-unknown` and compares, byte for byte, what
//! it tells with what the tests locked. Plain exports: a text is left in memory, its length is
//! returned, [`text`] says where it lies.

use std::sync::Mutex;

static TEXT: Mutex<Vec<u8>> = Mutex::new(Vec::new());

fn leave(text: String) -> usize {
    let mut left = TEXT
        .lock()
        .unwrap_or_else(std::sync::PoisonError::into_inner);
    *left = text.into_bytes();
    left.len()
}

/// Where the text lies that was left last.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    let left = TEXT
        .lock()
        .unwrap_or_else(std::sync::PoisonError::into_inner);
    left.as_ptr()
}

/// How many examples there are.
#[unsafe(no_mangle)]
pub extern "C" fn examples() -> usize {
    every_example::ALL.len()
}

/// Leaves the stem of the n-th example.
#[unsafe(no_mangle)]
pub extern "C" fn stem(n: usize) -> usize {
    leave(every_example::ALL[n].stem().into())
}

/// Leaves what the n-th example prints, or the error.
#[unsafe(no_mangle)]
pub extern "C" fn report(n: usize) -> usize {
    let text = every_example::ALL[n]
        .report()
        .and_then(|report| report.text());
    leave(text.unwrap_or_else(|error| format!("error: {error}")))
}

/// Leaves what the n-th example draws: for each figure its name, a line feed, its SVG, a NUL.
#[unsafe(no_mangle)]
pub extern "C" fn figures(n: usize) -> usize {
    let figures = every_example::ALL[n].figures().unwrap_or_default();
    let each = figures
        .into_iter()
        .map(|figure| format!("{}\n{}\0", figure.name, figure.svg));
    leave(each.collect())
}
