//! Any method, with what the motion keeps brought back now and then.
//!
//! Rounding moves the invariants of a stepped motion in a random walk, and the phase with the
//! integral of that walk. Errors grow as t^(1/2) and t^(3/2) (Brouwer's law), and truncation may
//! add a steady drift. Energy and momenta are known, so the state can be moved back onto them, by
//! the shortest way: then invariants stay within round-off for ever, and the phase is off by no
//! more than t.
//!
//! Not for: scenes that keep nothing; and it does not make a coarse method accurate, only
//! its long runs.
//!
//! Sources: D. Brouwer, Astron. J. 46, 149 (1937); E. Hairer, C. Lubich, G. Wanner,
//! *Geometric Numerical Integration*, IV.4 and VIII.5.

use super::explicit::no_steps;
use super::gauss_legendre::FreeRotation;
use super::ode::check_span;
use super::scene::components;
use super::{Integrator, SpinFree, Work};
use crate::attitude::Attitude;
use crate::body::State;
use crate::effects::Effect;
use crate::error::Result;
use crate::frame::SpaceVector;
use crate::scene::{Invariant, Scene};

/// A problem that knows the first integrals of its motions.
pub trait FirstIntegrals {
    /// The state nearest to `state` in which everything that the motion keeps has the
    /// values it has in `start`.
    ///
    /// Errors: a state that is not finite.
    fn restored(&self, state: &State, start: &State) -> Result<State>;
}

/// A run of `blocks` runs of another method, each followed by a projection onto the
/// energy and the momenta of the start.
///
/// A block should be long enough that the projection, which costs about as much as ten
/// torques, does not count, and short enough that little has gone wrong in it: some
/// hundred steps.
///
/// Accuracy, as measured with Gauss-Legendre 16 on eight heavy tops (`tests/accuracy/drift.rs`):
/// after 5600 nods energy and momenta are off by 8 eps instead of 18, and stay there. Longer
/// runs are in `benches/record/drift.txt`.
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::integrators::{Integrator, Projected, Rk4};
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// let scene = Scene::new(RigidBody::new(PrincipalMoments::new(1.0, 2.0, 2.5)?));
/// let start = scene.body().state(Attitude::IDENTITY, BodyVector::new(0.8, 0.4, 0.3375))?;
/// let (plain, _) = Rk4::new(3000)?.advance(&scene, 0.0, &start, 600.0)?;
/// let (kept, _) = Projected::new(Rk4::new(30)?, 100)?.advance(&scene, 0.0, &start, 600.0)?;
/// let off = |state| (scene.energy(state) / scene.energy(&start) - 1.0).abs();
/// // Measured: 3.0e-5 and 5.2e-14, the square of what a block loses.
/// assert!(off(&plain) > 2e-5 && off(&kept) < 1e-13);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Projected<M> {
    method: M,
    blocks: u64,
}

impl<M> Projected<M> {
    /// The run as so many equal blocks, each by `method`.
    ///
    /// Errors: no blocks.
    pub fn new(method: M, blocks: u64) -> Result<Self> {
        if blocks == 0 {
            return Err(no_steps());
        }
        Ok(Self { method, blocks })
    }
}

impl<P: FirstIntegrals, M: Integrator<P, State>> Integrator<P, State> for Projected<M> {
    fn advance(&self, problem: &P, t: f64, start: &State, t_end: f64) -> Result<(State, Work)> {
        check_span(t, &components(start), t_end)?;
        let mut work = Work::default();
        if t == t_end {
            return Ok((*start, work));
        }
        let mut state = *start;
        for block in 0..self.blocks {
            let [from, to] =
                [block, block + 1].map(|k| super::explicit::node(t, t_end, k, self.blocks));
            let (end, more) = self.method.advance(problem, from, &state, to)?;
            state = problem.restored(&end, start)?;
            work += more;
        }
        Ok((state, work))
    }
}

/// The conserved quantities, the momenta before the energy.
const ORDER: [Invariant; 5] = [
    Invariant::MomentumX,
    Invariant::MomentumY,
    Invariant::MomentumZ,
    Invariant::AxialMomentum,
    Invariant::Energy,
];

/// A gradient that differs from those before it by less than this part of itself adds
/// nothing but noise: in steady precession the energy follows from the momenta.
const DEPENDENT: f64 = 0.03;

/// A change of a state: a rotation (on the fixed axes, rad), and the change of L in units of |L|.
type Change = [SpaceVector; 2];

fn dot(a: &Change, b: &Change) -> f64 {
    a[0].dot(&b[0]) + a[1].dot(&b[1])
}

impl<E: Effect> FirstIntegrals for Scene<E> {
    /// One Newton step, by the shortest change of attitude and momentum.
    fn restored(&self, state: &State, start: &State) -> Result<State> {
        let size = state.angular_momentum.norm();
        if size == 0.0 {
            return Ok(*state);
        }
        let mut directions = [[SpaceVector::zero(); 2]; ORDER.len()];
        let mut found = 0;
        let mut change = [SpaceVector::zero(); 2];
        for quantity in ORDER {
            if !self.invariants().any(|kept| kept == quantity) {
                continue;
            }
            let [rotation, momentum] = self.gradient(quantity, state);
            let mut gradient = [rotation, momentum * size];
            let full = dot(&gradient, &gradient).sqrt();
            let mut missing = self.value(quantity, start) - self.value(quantity, state);
            missing -= dot(&gradient, &change);
            for direction in &directions[..found] {
                let along = dot(&gradient, direction);
                for (part, more) in gradient.iter_mut().zip(direction) {
                    *part -= *more * along;
                }
            }
            let own = dot(&gradient, &gradient).sqrt();
            if own > DEPENDENT * full {
                let direction = gradient.map(|part| part / own);
                for (part, more) in change.iter_mut().zip(direction) {
                    *part += more * (missing / own);
                }
                directions[found] = direction;
                found += 1;
            }
        }
        let turned = Attitude::from_rotation_vector(change[0])? * state.attitude;
        State::new(turned, state.angular_momentum + change[1] * size)
    }
}

impl<E: Effect> Scene<E> {
    /// The derivatives of a quantity by a rotation of the body and by L.
    fn gradient(&self, quantity: Invariant, state: &State) -> Change {
        let unit = |x, y, z| [SpaceVector::zero(), SpaceVector::new(x, y, z)];
        let momentum = state.angular_momentum;
        match quantity {
            Invariant::MomentumX => unit(1.0, 0.0, 0.0),
            Invariant::MomentumY => unit(0.0, 1.0, 0.0),
            Invariant::MomentumZ => unit(0.0, 0.0, 1.0),
            Invariant::AxialMomentum => {
                let axis = state.attitude.axis();
                [axis.cross(&momentum), axis]
            }
            Invariant::Energy => {
                let omega = state.attitude.to_space(self.body().angular_velocity(state));
                // Energy is kept, so the torque does not depend on the time.
                [omega.cross(&momentum) - self.torque(0.0, state), omega]
            }
        }
    }
}

impl<E: Effect> FirstIntegrals for SpinFree<'_, E> {
    fn restored(&self, state: &State, start: &State) -> Result<State> {
        self.scene().restored(state, start)
    }
}

impl FirstIntegrals for FreeRotation {
    fn restored(&self, state: &State, start: &State) -> Result<State> {
        Scene::new(*self.body()).restored(state, start)
    }
}
