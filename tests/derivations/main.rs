//! The formulas of the pages "How it is computed", each evaluated as it is written there and
//! held against the library.
//!
//! What the library forms in double-double arithmetic, in a form that loses no digit, stands here
//! in plain doubles and the plain form, for motions in which that does no harm. A formula with
//! one thing changed is its damaged twin, and must miss.

mod contacts;
mod double_double;
mod error_control;
mod events;
mod free_body;
mod gauss_legendre;
mod heavy_top;
mod theta;
