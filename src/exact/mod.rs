//! Closed forms: motions that are known at any time without stepping.
//!
//! | module | what it holds |
//! |---|---|
//! | [`Modulus`], [`Characteristic`] | the parameters of elliptic integrals, with their complements |
//! | [`carlson`] | the symmetric integrals R_F, R_C, R_D, R_J |
//! | [`legendre`] | F, E, D, Pi and the complete K, E, D, Pi |
//! | [`jacobi`] | sn, cn, dn and the amplitude |
//! | [`free_body`] | torque-free rotation of any body (Euler-Poinsot) |
//! | [`heavy_top`] | the heavy symmetric top about a fixed point (Lagrange) |
//! | [`ladder`] | the sliding ladder of exercise 16.6 |
//! | [`pendulum`] | the physical pendulum: swings, separatrix, rotations |
//! | [`plank`] | a plank falling over on a smooth floor |
//!
//! Not for: motions that must be stepped; see [`crate::integrators`].

pub mod carlson;
mod extended;
pub mod free_body;
pub mod heavy_top;
pub mod jacobi;
pub mod ladder;
pub mod legendre;
mod modulus;
mod nome;
pub mod pendulum;
mod phase;
pub mod plank;

pub use modulus::{Characteristic, Modulus};
