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

mod batch;
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
mod scene;
mod theta;

pub use modulus::{Characteristic, Modulus};

use crate::error::{Error, Result, finite};

/// Refuses `found` places for `expected` states at time `t`, or a time that is not finite.
fn check_time(found: usize, expected: usize, t: f64) -> Result<()> {
    if found != expected {
        return Err(Error::Lengths {
            name: "states",
            found,
            expected,
        });
    }
    finite("t", t).map(|_| ())
}

/// Refuses `found` places for samples at `times` if they are not as many, or a time that is
/// not finite.
fn check_times(name: &'static str, found: usize, times: &[f64]) -> Result<()> {
    if found != times.len() {
        return Err(Error::Lengths {
            name,
            found,
            expected: times.len(),
        });
    }
    // Counting goes in vector registers; looking for the first does not.
    if times.iter().filter(|t| t.is_finite()).count() == found {
        return Ok(());
    }
    match times.iter().find(|t| !t.is_finite()) {
        Some(&value) => Err(Error::NotFinite { name: "t", value }),
        None => Ok(()),
    }
}
