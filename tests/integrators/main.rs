//! The integrators: their order, their price, what they keep, and how the methods that
//! everyone writes first fail.

mod absent;
mod convergence;
mod foils;
mod gauss_legendre;
mod invariants;
mod long;
mod munthe_kaas;
mod resisted;
mod slope;
mod top;
