//! The heavy symmetric top in closed form: its regimes, its limits, its laws, and what
//! it refuses. Values are compared with 25-digit references in `tests/reference`;
//! here every check comes from the physics.

mod batch;
mod laws;
mod limits;
mod motions;
mod refusals;
mod regimes;
