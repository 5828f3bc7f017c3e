//! What is measured, as inline snapshots: `cargo insta` writes them into the tests.

use insta::_macro_support::{InlineValue, assert_snapshot};
use std::panic::Location;
use std::path::Path;
use std::thread;

/// Asserts that a text is the one that is locked where this is called. It does what insta's macro
/// does, which would be compiled again at each of its uses.
#[track_caller]
pub(crate) fn locked(measured: &str, locked: &str, what: &str) {
    let (place, thread) = (Location::caller(), thread::current());
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2);
    let test = thread.name().unwrap_or("a test");
    let value = (InlineValue(locked), measured).into();
    let (file, line) = (place.file(), place.line());
    let root = root.expect("two levels up");
    assert_snapshot(value, root, test, module_path!(), file, line, what)
        .expect("a snapshot that differs can be written");
}

/// A number to three digits, or to fewer if it is exactly that.
pub fn three_digits(x: f64) -> String {
    let (shortest, rounded) = (format!("{x:e}"), format!("{x:.2e}"));
    let exact = shortest.len() < rounded.len();
    let power = rounded.split_once('e').and_then(|(_, power)| power.parse().ok());
    match power {
        Some(-2..=2) if exact => format!("{x}"),
        Some(power @ -2..=2) => format!("{x:.0$}", (2_i32 - power) as usize),
        _ if exact => shortest,
        _ => rounded,
    }
}
