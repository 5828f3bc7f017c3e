//! The integrators are of the order they claim, by algebra and by slope.
//!
//! Algebra: every order condition of the Runge-Kutta tableaux, one per rooted
//! tree. Slope: error against step on problems with a closed form, fitted over a
//! range that lies above round-off; two-sided. Each check has a damaged twin, a
//! coefficient off by 1e-6, that must fail it.

mod closed_form;
mod dop853;
mod events;
mod kepler;
mod pace;
mod rk4;
mod splitting;
mod trees;
mod words;
