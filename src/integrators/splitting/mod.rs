//! Splittings: exact flow and exact kick in turn.
//!
//! A problem that splits into two parts, each solvable exactly, is carried by steps of one and the
//! other. For a body in a potential the parts are free rotation (of any body, exact:
//! [`FreeFlow`](crate::exact::free_body::FreeFlow)) and the kick of the torque. Each part keeps the
//! geometry (unit quaternion, L_Z, for a symmetric body L_z, symplecticity, reversibility), so
//! every composition does; the coefficients only choose the order. A resistance to the rotation
//! joins the kick, exact too ([`Resisted`]).

mod body;
mod resisted;
mod scheme;

pub use body::BodyPoint;
pub use resisted::{Resisted, ResistedPoint};
pub use scheme::{Outer, Scheme};

use super::explicit::no_steps;
use super::{Integrator, Work, advance_by_counting};
use crate::error::{Result, finite};

/// A problem made of two parts that can each be solved exactly.
pub trait Separable {
    /// The state as a user gives and reads it.
    type State: Clone;
    /// The state as flow and kick carry it.
    type Point;

    /// The point of a state.
    ///
    /// Errors: a state to which the splitting does not apply.
    fn enter(&self, state: &Self::State) -> Result<Self::Point>;

    /// The state of a point, `elapsed` after it was entered.
    ///
    /// Errors: a point that is no longer finite.
    fn leave(&self, point: &Self::Point, elapsed: f64) -> Result<Self::State>;

    /// The first part for the time `dt`: motion without the kick.
    fn flow(&self, point: &mut Self::Point, dt: f64);

    /// The second part for the time `dt`: the kick without motion.
    fn kick(&self, point: &mut Self::Point, dt: f64);

    /// The error that round-off has made in the geometry is undone, once a step.
    fn settle(&self, point: &mut Self::Point);
}

/// A symmetric splitting with fixed step, of order 2, 4, 6 or 8.
///
/// Which scheme: at a given order the one with the smallest error for the same
/// number of kicks, measured on the notes' top (a = 2, b = 1.2, c = 0.2,
/// E~ = 0.55, t' = 20). Largest error of an entry of R with about 480 kicks:
///
/// | order | chosen | | others | |
/// |---|---|---|---|---|
/// | 2 | Strang, flow outside | 8.3e-5 | Strang, kick outside | 2.1e-4 |
/// | 4 | SRKN 6b | 1.8e-8 | Chin 4A with gradient, S6, Suzuki, Forest-Ruth | 6.3e-8, 4.5e-7, 1.5e-6, 3.5e-6 |
/// | 6 | SRKN 14a | 2.0e-9 | SRKN 11b, S10, Kahan-Li, Yoshida A | 4.0e-9, 1.3e-8, 2.1e-7, 9.7e-7 |
/// | 8 | Kahan-Li 17b | 6.8e-9 | Kahan-Li 17a, Suzuki-Umeno 15 | 7.3e-9, 9.9e-9 |
/// | (10, 6, 4) | ABA | 8.2e-9 | (8, 6, 4) | 6.7e-9 |
/// | (10, 4) | ABA | 2.1e-7 | (8, 4) | 1.4e-6 |
/// | (8, 2) | ABA | 4.0e-5 | | |
///
/// Which scheme for which motion: the cheapest one measured that reaches the error of the attitude
/// at the end, and its kicks. Its time is given as a fraction of the times of DOP853 and of
/// Gauss-Legendre 16 (with AVX-512) at the same error, in one run on one machine. Where a fraction
/// exceeds 1, do not split.
///
/// | motion | 1e-6 | 1e-9 | 1e-11 |
/// |---|---|---|---|
/// | notes' top, t' = 2000 | SRKN 14a, 37856: 0.39, 0.89 | Kahan-Li, 115804: 0.49, 2.4 | Kahan-Li, 202538: not reached, 4.0 |
/// | fast top c = 1e-4 from rest, one turn | ABA(10,4), 130606: 0.07, 0.06 | SRKN 14a, 399532: 0.06, 0.18 | |
/// | asymmetric, torque as large as the rotation | SRKN 14a, 252: 0.51, 0.20 | ABA(10,6,4), 872: 0.79, 0.65 | SRKN 14a, 1764: 0.92, 1.0 |
/// | asymmetric, torque 1e-2 | ABA(10,4), 49: 0.26, 0.11 | SRKN 14a, 182: 0.40, 0.34 | ABA(10,6,4), 376: 0.51, 0.64 |
/// | asymmetric, torque 1e-3 | ABA(10,4), 63: 0.20, 0.08 | ABA(10,6,4), 192: 0.27, 0.21 | ABA(10,6,4), 288: 0.21, 0.27 |
/// | asymmetric, spin 40 rad/s | ABA(10,4), 91: 0.24, 0.10 | ABA(10,6,4), 288: 0.30, 0.25 | ABA(10,6,4), 504: 0.26, 0.38 |
///
/// The asymmetric bodies are the cases random-0, weak-2, weak-4 and spin-2 of
/// `tests/data/heavy_asymmetric.json`; ABA(8,2) needs the fewest kicks at 1e-6 in some
/// of them (spin-2: 72 against 91). Errors at equal price are locked in
/// `tests/integrators/convergence/splitting.rs`.
///
/// Accuracy: on the reference cases of the tops at 0.08 rad a step, SRKN 14a is off by K <= 2 in
/// units of eps (|value| + condition), as a closed form would be (7.8 on the spherical pendulum,
/// where I1/I3 = 50). On 49 heavy bodies with three different moments at 0.16 rad a step it is off
/// by K <= 6.8. Over a million kicks L_Z is kept exactly, of a symmetric body L_z to 10 eps, and
/// the length of the quaternion to 3 eps; the energy swings without drift. A run there and back
/// ends within 2.6e-15 of its start.
///
/// Sources: with each [`Scheme`]; the splitting of the top: exact free rotation
/// and gravity kick, as in E. Hairer, C. Lubich, G. Wanner, *Geometric Numerical
/// Integration*, VII.5.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Splitting {
    scheme: Scheme,
    steps: u64,
}

impl Splitting {
    /// The splitting by this scheme with this many equal steps over the run.
    ///
    /// Errors: no steps.
    pub fn new(scheme: Scheme, steps: u64) -> Result<Self> {
        if steps == 0 {
            return Err(no_steps());
        }
        Ok(Self { scheme, steps })
    }

    /// The scheme.
    pub const fn scheme(&self) -> &Scheme {
        &self.scheme
    }
}

impl<P: Separable> Integrator<P, P::State> for Splitting {
    advance_by_counting!(P, P::State);

    fn advance_counting(
        &self,
        problem: &P,
        t: f64,
        start: &P::State,
        t_end: f64,
        work: &mut Work,
    ) -> Result<P::State> {
        finite("start time", t)?;
        finite("end time", t_end)?;
        let span = finite("end time - start time", t_end - t)?;
        if span == 0.0 {
            return Ok(start.clone());
        }
        let h = span / self.steps as f64;
        let mut point = problem.enter(start)?;
        let outer = |part: f64, point: &mut P::Point| match self.scheme.outer {
            Outer::Flow => problem.flow(point, part * h),
            Outer::Kick => problem.kick(point, part * h),
        };
        let inner = |part: f64, point: &mut P::Point| match self.scheme.outer {
            Outer::Flow => problem.kick(point, part * h),
            Outer::Kick => problem.flow(point, part * h),
        };
        let [first, between @ .., last] = self.scheme.outer_parts else {
            return Err(no_steps());
        };
        outer(*first, &mut point);
        for step in 1..=self.steps {
            // The outer operation that ends this step begins the next as well.
            let end = if step == self.steps { *last } else { first + last };
            let after = between.iter().chain(core::iter::once(&end));
            for (inside, outside) in self.scheme.inner_parts.iter().zip(after) {
                inner(*inside, &mut point);
                outer(*outside, &mut point);
            }
            problem.settle(&mut point);
        }
        let (outers, inners) = (
            1 + self.steps * (self.scheme.outer_parts.len() as u64 - 1),
            self.steps * self.scheme.inner_parts.len() as u64,
        );
        let (flows, kicks) = match self.scheme.outer {
            Outer::Flow => (outers, inners),
            Outer::Kick => (inners, outers),
        };
        *work += Work { steps: self.steps, flows, kicks, ..Work::default() };
        problem.leave(&point, span)
    }
}
