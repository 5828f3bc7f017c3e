//! Races against other Rust crates, to the same measured error.
//!
//! | module | what it holds |
//! |---|---|
//! | [`problem`] | the motions, and their attitudes at the end to 20 digits |
//! | [`form`] | the equations as bare numbers, in each choice of variables |
//! | [`open`], [`open_form`] | motions without a closed form, and their equations |
//! | [`contestants`] | one file per crate, and one for this library |
//! | [`contest`], [`open_contest`] | who carries what |
//! | [`search`] | the cheapest setting that reaches an error |
//! | [`race`] | all of them, timed in turn |
//! | [`record`], [`open_record`] | what is written down |
//! | [`dense`] | the attitude 256 times a period |
//!
//! Not for: locking anything. Times are measured and shown, never asserted.

pub mod contest;
pub mod contestants;
pub mod dense;
pub mod form;
pub mod open;
pub mod open_contest;
pub mod open_form;
pub mod open_record;
pub mod problem;
pub mod race;
pub mod record;
pub mod search;
