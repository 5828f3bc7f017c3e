//! Errors of a state against the exact one.

use crate::body::State;
use crate::effects::erased::AnyEffect;
use crate::math::larger;
use crate::scene::{Invariant, Scene};

/// How far a state is from the exact state at the same time.
///
/// | field | is | relative to |
/// |---|---|---|
/// | `attitude` | the angle of the rotation between the two attitudes (rad) | |
/// | `rates` | the length of omega - omega*, on the body axes | the scale of omega |
/// | `momentum` | the length of L - L*, on the fixed axes | the scale of L |
/// | `energy` | the size of E - E* | kinetic energy plus the size of the torques |
/// | `invariants` | the largest error of what the scene keeps | as above |
///
/// The scale of L is its exact length, or the momentum that the torques build up in the body's own
/// time, sqrt(I_max torque), if that is more. The scale of omega is |omega*| or sqrt(torque/I_max).
/// So a pendulum at its turning point, at rest for an instant, has finite relative errors. Where
/// even the scale is 0 an error is 0 or infinite.
///
/// Attitude, rates and invariants are different questions. A method can keep the energy
/// to 15 digits and have the attitude wrong in the third.
///
/// ```
/// use rotation_dynamics::accuracy::Errors;
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::exact::free_body::FreeBody;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::integrators::{Integrator, Rk4};
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// let moments = PrincipalMoments::new(1.0, 2.0, 2.5)?;
/// let rates = BodyVector::new(0.8, 0.4, 0.3375);
/// let scene = Scene::new(RigidBody::new(moments));
/// let start = scene.body().state(Attitude::IDENTITY, rates)?;
/// let exact = FreeBody::new(moments, Attitude::IDENTITY, rates)?.state(10.0);
///
/// let (reached, _) = Rk4::new(100)?.advance(&scene, 0.0, &start, 10.0)?;
/// let errors = Errors::between(&scene, &reached, &exact);
/// assert!((1e-7..1e-5).contains(&errors.attitude));
/// assert!(errors.momentum < 1e-15); // no torque, and L is a variable
/// # Ok(())
/// # }
/// ```
///
/// Accuracy: two exact states of the same motion differ by no more than 5 eps in the attitude, 11
/// eps in rates and momentum and 18 eps in the energy (measured in `tests/accuracy/measures.rs`).
/// An error smaller than that is round-off of the states.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Errors {
    /// The angle between the attitudes (rad).
    pub attitude: f64,
    /// The error of the angular velocity on the body axes, relative.
    pub rates: f64,
    /// The error of the angular momentum on the fixed axes, relative.
    pub momentum: f64,
    /// The error of the energy, relative.
    pub energy: f64,
    /// The largest error of an invariant of the scene, relative.
    pub invariants: f64,
}

/// One of the five measures in [`Errors`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// [`Errors::attitude`].
    Attitude,
    /// [`Errors::rates`].
    Rates,
    /// [`Errors::momentum`].
    Momentum,
    /// [`Errors::energy`].
    Energy,
    /// [`Errors::invariants`].
    Invariants,
}

impl Measure {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::Attitude, Self::Rates, Self::Momentum, Self::Energy, Self::Invariants];
}

impl Errors {
    /// The errors of `reached` where the motion of this scene is at `exact`.
    ///
    /// A component that is NaN makes the errors it enters NaN.
    pub fn between<E: AnyEffect>(scene: &Scene<E>, reached: &State, exact: &State) -> Self {
        let body = scene.body();
        let [i1, i2, i3] = body.moments().to_array();
        let largest = i1.max(i2).max(i3);
        let torque = scene.effects().torque_scale(0.0, scene.body(), exact);
        let momentum_scale = (exact.angular_momentum.norm()).max((largest * torque).sqrt());
        let momentum = reached.angular_momentum - exact.angular_momentum;
        let omega = body.angular_velocity(exact);
        let rates = (body.angular_velocity(reached) - omega).norm();
        // U is known up to a constant; its size is that of the torques.
        let energy_scale = body.kinetic_energy(exact) + torque;
        let energy = (scene.energy(reached) - scene.energy(exact)).abs();
        let energy = relative(energy, energy_scale);
        let invariants = scene.invariants().map(|invariant| match invariant {
            Invariant::Energy => energy,
            momentum => {
                let value = |state| scene.value(momentum, state);
                relative((value(reached) - value(exact)).abs(), momentum_scale)
            }
        });
        Self {
            attitude: reached.attitude.angle_to(&exact.attitude),
            rates: relative(rates, omega.norm().max((torque / largest).sqrt())),
            momentum: relative(momentum.norm(), momentum_scale),
            energy,
            invariants: invariants.fold(0.0, larger),
        }
    }

    /// The error in one measure.
    pub const fn get(&self, measure: Measure) -> f64 {
        match measure {
            Measure::Attitude => self.attitude,
            Measure::Rates => self.rates,
            Measure::Momentum => self.momentum,
            Measure::Energy => self.energy,
            Measure::Invariants => self.invariants,
        }
    }

    /// The larger of two errors, measure by measure: the worst of a run.
    #[must_use]
    pub fn or_worse(&self, other: &Self) -> Self {
        Self {
            attitude: larger(self.attitude, other.attitude),
            rates: larger(self.rates, other.rates),
            momentum: larger(self.momentum, other.momentum),
            energy: larger(self.energy, other.energy),
            invariants: larger(self.invariants, other.invariants),
        }
    }

    /// Whether every error is a finite number.
    pub fn is_finite(&self) -> bool {
        Measure::ALL.iter().all(|m| self.get(*m).is_finite())
    }
}

/// Nothing is no error, even of nothing.
fn relative(difference: f64, scale: f64) -> f64 {
    if difference == 0.0 { 0.0 } else { difference / scale }
}

/// The largest size of some errors, 0 of none; not a number if one of them is not.
///
/// ```
/// use rotation_dynamics::accuracy::largest;
/// assert_eq!(largest([1e-3, -2e-3]), 2e-3);
/// assert!(largest([1.0, f64::NAN, 2.0]).is_nan());
/// ```
pub fn largest(errors: impl IntoIterator<Item = f64>) -> f64 {
    errors.into_iter().fold(0.0, |most, e| larger(most, e.abs()))
}
