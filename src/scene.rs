//! A scene: a body and what acts on it.
//!
//! The effects are part of the type: `Scene<()>` is a free body, and
//! `Scene<((), GravityAtLever)>` a heavy top; or they are chosen at run time,
//! `Scene<EffectList>`. A scene knows which quantities
//! its motion keeps. How it moves is told by [`Scene::solve`] (in [`crate::accuracy`]), by
//! [`crate::exact`] and by [`crate::integrators`].

use crate::body::{RigidBody, State};
use crate::effects::erased::AnyEffect;
use crate::effects::{Conserved, Effect, EffectList};
use crate::frame::{BodyVector, SpaceVector};
use crate::math::larger;

/// The angle (rad) over which a potential is differentiated along a slip.
const SLIPPED: f64 = 1e-5;

/// A body and the effects that act on it.
///
/// ```
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::GravityAtLever;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::scene::{Invariant, Scene};
/// # fn main() -> rotation_dynamics::Result<()> {
/// let body = RigidBody::new(PrincipalMoments::symmetric(5.45e-3, 9.0e-4)?);
/// let gyroscope = Scene::new(body).with(GravityAtLever::new(4.9, 0.1)?);
/// let kept: Vec<Invariant> = gyroscope.invariants().collect();
/// assert_eq!(
///     kept,
///     [Invariant::Energy, Invariant::MomentumZ, Invariant::AxialMomentum]
/// );
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scene<E: ?Sized> {
    body: RigidBody,
    effects: E,
}

/// A quantity that a motion may keep.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Invariant {
    /// Kinetic plus potential energy (J).
    Energy,
    /// Angular momentum about the fixed axis X (kg m^2/s).
    MomentumX,
    /// Angular momentum about the fixed axis Y (kg m^2/s).
    MomentumY,
    /// Angular momentum about the vertical, the notes' L_Z (kg m^2/s).
    MomentumZ,
    /// Angular momentum about the body's axis e3, the notes' L_z (kg m^2/s).
    AxialMomentum,
}

impl Invariant {
    /// Its name, and its unit.
    pub(crate) const fn name_and_unit(self) -> (&'static str, &'static str) {
        match self {
            Self::Energy => ("energy", "J"),
            Self::MomentumX => ("angular momentum about X", "kg m^2/s"),
            Self::MomentumY => ("angular momentum about Y", "kg m^2/s"),
            Self::MomentumZ => ("angular momentum about Z", "kg m^2/s"),
            Self::AxialMomentum => ("angular momentum about the body's axis", "kg m^2/s"),
        }
    }
}

impl Scene<()> {
    /// A body on which nothing acts.
    pub const fn new(body: RigidBody) -> Self {
        Self { body, effects: () }
    }

    /// The body under effects that were chosen at run time: all effects of the scene are in the list.
    pub fn with_list(self, effects: EffectList) -> Scene<EffectList> {
        Scene { body: self.body, effects }
    }
}

impl<E: Effect> Scene<E> {
    /// The same scene with one more effect.
    ///
    /// A body has one weight, at one place. A program with a second gravity does not build
    /// (`cargo check` does not see it):
    ///
    /// ```compile_fail,E0080
    /// # use rotation_dynamics::{body::RigidBody, effects::GravityAtLever};
    /// # use rotation_dynamics::{inertia::PrincipalMoments, scene::Scene};
    /// # fn main() -> rotation_dynamics::Result<()> {
    /// # let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
    /// let gravity = GravityAtLever::new(4.9, 0.1)?;
    /// let scene = Scene::new(body).with(gravity).with(gravity);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// A closure or a list is no effect, and the compiler says of what it becomes one:
    ///
    /// ```compile_fail,E0277
    /// # use rotation_dynamics::{body::RigidBody, frame::SpaceVector};
    /// # use rotation_dynamics::{inertia::PrincipalMoments, scene::Scene};
    /// # let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
    /// let scene = Scene::new(body).with(|_t, _body, _state| SpaceVector::zero());
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    pub fn with<F: Effect>(self, effect: F) -> Scene<(E, F)> {
        const {
            assert!(
                !(E::PROPERTIES.weight && F::PROPERTIES.weight),
                "gravity would act twice in this scene: one weight at one place is allowed"
            );
        }
        Scene { body: self.body, effects: (self.effects, effect) }
    }
}

impl<E: AnyEffect + ?Sized> Scene<E> {
    /// The body.
    #[inline]
    pub const fn body(&self) -> &RigidBody {
        &self.body
    }

    /// The effects.
    #[inline]
    pub const fn effects(&self) -> &E {
        &self.effects
    }

    /// The torque on the body, on the fixed axes (N m).
    #[inline]
    pub fn torque(&self, t: f64, state: &State) -> SpaceVector {
        self.effects.torque(t, &self.body, state)
    }

    /// The angular velocity of the body's axes, on those axes (rad/s): I^-1 R^T L, and the part
    /// that effects that slip add to it ([`Effect::slip`]).
    #[inline(always)]
    pub fn angular_velocity(&self, t: f64, state: &State) -> BodyVector {
        let omega = self.body.angular_velocity(state);
        if !self.effects.properties().slips {
            return omega;
        }
        let slip = self.effects.slip(t, &self.body, state);
        omega + state.attitude.to_body(slip)
    }

    /// Kinetic plus potential energy at the time `t` (J).
    #[inline]
    pub fn energy_at(&self, t: f64, state: &State) -> f64 {
        self.body.kinetic_energy(state) + self.effects.potential_energy(t, &self.body, state)
    }

    /// The rate at which the effects change that energy (W).
    ///
    /// For a body that slips through a potential, or whose torque changes a potential that depends
    /// on L, that part is differenced, to 1e-10 of it.
    pub fn power(&self, t: f64, state: &State) -> f64 {
        let power = self.effects.power(t, &self.body, state);
        if !self.effects.properties().slips {
            return power;
        }
        let slip = self.effects.slip(t, &self.body, state);
        let torque = self.effects.torque(t, &self.body, state);
        let rate = larger(slip.norm(), torque.norm() / state.angular_momentum.norm());
        if rate == 0.0 || !rate.is_finite() {
            return power;
        }
        let dt = SLIPPED / rate;
        let potential = |by: f64| {
            let turned = state.attitude.turned_in_space(slip * by);
            turned.map_or(f64::NAN, |attitude| {
                let state =
                    State { attitude, angular_momentum: state.angular_momentum + torque * by };
                self.effects.potential_energy(t, &self.body, &state)
            })
        };
        power + (potential(dt) - potential(-dt)) / (2.0 * dt)
    }

    /// Kinetic plus potential energy (J), of potentials that do not depend on the time; of
    /// others, that at t = 0.
    #[inline]
    pub fn energy(&self, state: &State) -> f64 {
        self.energy_at(0.0, state)
    }

    /// The quantities that every motion of this scene keeps.
    pub fn invariants(&self) -> impl Iterator<Item = Invariant> + use<E> {
        let Conserved { energy, momentum: [x, y, z], axial_momentum } =
            self.effects.properties().conserved;
        // Without symmetry the body's own motion changes L_z.
        let axial = axial_momentum && self.body.moments().is_symmetric();
        [
            (energy, Invariant::Energy),
            (x, Invariant::MomentumX),
            (y, Invariant::MomentumY),
            (z, Invariant::MomentumZ),
            (axial, Invariant::AxialMomentum),
        ]
        .into_iter()
        .filter_map(|(kept, invariant)| kept.then_some(invariant))
    }

    /// The value of a quantity in a state, kept or not.
    pub fn value(&self, quantity: Invariant, state: &State) -> f64 {
        match quantity {
            Invariant::Energy => self.energy(state),
            Invariant::MomentumX => state.angular_momentum.x(),
            Invariant::MomentumY => state.angular_momentum.y(),
            Invariant::MomentumZ => state.angular_momentum.z(),
            Invariant::AxialMomentum => self.body.angular_momentum(state).z(),
        }
    }
}
