//! Every example, compiled once for all who need it: the tests of the pages and the
//! measurement of their times.
//!
//! An example is a file in `examples/` with a constant `EXAMPLE`; nothing else lists it.

#![allow(
    dead_code,
    clippy::duplicate_mod,
    reason = "each example has its own main, and one may stand on another"
)]

use kit::{Moves, Page};

include!(concat!(env!("OUT_DIR"), "/examples.rs"));

/// The example with this stem.
pub fn page(stem: &str) -> Option<&'static dyn Page> {
    ALL.iter().copied().find(|page| page.stem() == stem)
}
