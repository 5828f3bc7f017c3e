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
//! | [`pendulum`] | the physical pendulum: swings, separatrix, rotations |
//!
//! Not for: motions that must be stepped; see [`crate::integrators`].
//!
//! # How late
//!
//! A time is taken as the double that it is. No digit of a phase is lost up to 2^46 turns (near a
//! separatrix: half-periods). At 2^48 = 2.8e14 of them an attitude is off by 5.1e-14 rad at
//! most, as measured (`tests/traps/no_time.rs`). There the last bit of the time is a 32nd to a 16th
//! of a turn. Beyond, and as long before the start, the phase is lost.
//!
//! Plain values are NaN then, as for a time that is not finite. Functions that begin with `try_`,
//! lists and conditions refuse such a time ([`Error::PhaseLost`]). A body at rest is known at any
//! time.

mod batch;
pub mod carlson;
#[cfg(test)]
mod extended;
pub mod free_body;
pub mod heavy_top;
pub mod jacobi;
pub mod legendre;
mod modulus;
mod nome;
pub mod pendulum;
mod phase;
mod scene;
mod theta;

pub use modulus::{Characteristic, Modulus};

use crate::error::{Error, Result, known};

/// Refuses `found` places for `expected` states.
fn check_length(name: &'static str, found: usize, expected: usize) -> Result<()> {
    if found == expected {
        return Ok(());
    }
    Err(Error::Lengths { name, found, expected })
}

/// Refuses `found` places for samples at `times` if they are not as many, or a time at which the
/// phase is not known: it is up to `latest`.
fn check_times(name: &'static str, found: usize, times: &[f64], latest: f64) -> Result<()> {
    check_length(name, found, times.len())?;
    // Counting goes in vector registers; looking for the first does not.
    if times.iter().filter(|t| t.abs() <= latest).count() == found {
        return Ok(());
    }
    times.iter().try_for_each(|t| known(*t, latest).map(|_| ()))
}
