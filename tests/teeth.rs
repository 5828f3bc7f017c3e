//! Tests with teeth: damaged code must fail the bounds that the good code meets.
//!
//! Where the damage is one number, the twin stands beside its bound; here are the
//! damages that need code: a term left out, a sign turned round, a wrong moment.

#[path = "teeth/errors.rs"]
mod errors;
#[path = "teeth/integrators.rs"]
mod integrators;
#[path = "convergence/top.rs"]
mod top;
