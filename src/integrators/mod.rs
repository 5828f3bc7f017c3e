//! Integrators: one method per file, coefficients as data.
//!
//! A method is a value that carries a state from one time to another ([`Integrator::advance`]) and
//! reports what that cost ([`Work`]). The kind, invariants and origin of each are listed in
//! [`Method`]; the type says what it can carry:
//!
//! | method | carries | step |
//! |---|---|---|
//! | [`Rk4`] | any [`Ode`] | fixed |
//! | [`GaussLegendre`] | any [`StageOde`], eight stages side by side | fixed |
//! | [`Dop853`] | any [`Ode`]; dense output and events by [`Dop853::solve`] | adaptive |
//! | [`MuntheKaas4`] | any scene; turns the attitude instead of adding to it | fixed |
//! | [`Splitting`] | any body under effects that see only its axis, also with what resists its rotation ([`Resisted`]), and any [`Separable`] | fixed |
//!
//! [`Projected`] keeps energy and momenta in long runs of any of them. A scene is an [`Ode`] and, where it applies, [`Separable`]; every method
//! carries its [`State`](crate::body::State)s. [`SpinFree`] takes the spin of a
//! symmetric body out, for the general methods too. The [`foils`] are there to fail.
//!
//! Not for: closed forms (see [`crate::exact`]), and systems with jumps, which
//! [`crate::planar`] cuts into smooth pieces at located events.

mod body_fixed;
mod compensated;
pub mod dop853;
mod explicit;
pub mod foils;
pub mod gauss_legendre;
mod method;
mod munthe_kaas;
mod ode;
mod projected;
mod rk4;
pub mod scene;
mod spin_free;
pub mod splitting;
mod work;

pub(crate) use body_fixed::BodyFixed;
pub use dop853::{Direction, Dop853, Event, LocatedEvent, Solution, after, small_frequency};
pub use explicit::Tableau;
pub use gauss_legendre::{GaussLegendre, StageOde};
pub use method::{About, Method};
pub use munthe_kaas::MuntheKaas4;
pub use ode::{ByClosure, Ode, newton, ode, place_and_velocity, second_order, size_or};
pub use projected::{FirstIntegrals, Projected};
pub use rk4::Rk4;
pub use spin_free::SpinFree;
pub use splitting::{Resisted, Scheme, Separable, Splitting};
pub use work::Work;

use crate::error::Result;

/// A method that carries states `Y` of the problem `P` through time.
///
/// ```
/// use rotation_dynamics::integrators::{Dop853, Integrator, Ode, Rk4, size_or};
///
/// /// A pendulum of unit frequency: angle and rate.
/// struct Pendulum;
/// impl Ode<2> for Pendulum {
///     fn derivative(&self, _t: f64, [angle, rate]: &[f64; 2]) -> [f64; 2] {
///         [*rate, -rotation_dynamics::math::sin(*angle)]
///     }
///     fn scale(&self, y: &[f64; 2]) -> [f64; 2] {
///         size_or([1.0; 2])(y)
///     }
/// }
///
/// # fn main() -> rotation_dynamics::Result<()> {
/// let start = [1.0, 0.0];
/// let (coarse, work) = Rk4::new(100)?.advance(&Pendulum, 0.0, &start, 5.0)?;
/// let (fine, _) = Dop853::new(1e-13)?.advance(&Pendulum, 0.0, &start, 5.0)?;
/// assert!((coarse[0] - fine[0]).abs() < 1e-6);
/// assert_eq!(work.derivatives, 400);
/// # Ok(())
/// # }
/// ```
pub trait Integrator<P: ?Sized, Y> {
    /// The state at `t_end` that follows from `start` at `t`, and the work done.
    ///
    /// `t_end` may lie before `t`. With `t_end == t` the start is returned and
    /// no work is done.
    ///
    /// Errors: a time or a state that is not finite; a refusal of the method itself.
    fn advance(&self, problem: &P, t: f64, start: &Y, t_end: f64) -> Result<(Y, Work)>;

    /// The same, with its work added to `work`. If a run comes to no end, [`Dop853`],
    /// [`GaussLegendre`] and [`Splitting`] add the work done until then; others, which make all
    /// their steps, nothing.
    ///
    /// Errors: as [`advance`](Self::advance).
    fn advance_counting(
        &self,
        problem: &P,
        t: f64,
        start: &Y,
        t_end: f64,
        work: &mut Work,
    ) -> Result<Y> {
        let (end, done) = self.advance(problem, t, start, t_end)?;
        *work += done;
        Ok(end)
    }
}

/// [`Integrator::advance`] by [`Integrator::advance_counting`].
macro_rules! advance_by_counting {
    ($problem:ty, $state:ty) => {
        fn advance(
            &self,
            problem: &$problem,
            t: f64,
            start: &$state,
            t_end: f64,
        ) -> crate::error::Result<($state, crate::integrators::Work)> {
            let mut work = crate::integrators::Work::default();
            let end = self.advance_counting(problem, t, start, t_end, &mut work)?;
            Ok((end, work))
        }
    };
}
use advance_by_counting;
