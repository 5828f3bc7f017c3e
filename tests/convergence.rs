//! The integrators are of the order they claim, by algebra and by slope.
//!
//! Algebra: every order condition of the Runge-Kutta tableaux, one per rooted
//! tree. Slope: error against step on problems with a closed form, fitted over a
//! range that lies above round-off; two-sided. Each check has a damaged twin, a
//! coefficient off by 1e-6, that must fail it.

#[path = "convergence/closed_form.rs"]
mod closed_form;
#[path = "convergence/dop853.rs"]
mod dop853;
#[path = "convergence/events.rs"]
mod events;
#[path = "convergence/kepler.rs"]
mod kepler;
#[path = "convergence/rk4.rs"]
mod rk4;
#[path = "convergence/slope.rs"]
mod slope;
#[path = "convergence/splitting.rs"]
mod splitting;
#[path = "convergence/top.rs"]
mod top;
#[path = "convergence/trees.rs"]
mod trees;
#[path = "convergence/words.rs"]
mod words;
