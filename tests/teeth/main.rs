//! Tests with teeth: damaged code must fail the bounds that the good code meets.
//!
//! Where the damage is one number, the twin stands beside its bound; here are the
//! damages that need code: a term left out, a sign turned round, a wrong moment.

mod errors;
mod integrators;
#[path = "../integrators/top.rs"]
mod top;
