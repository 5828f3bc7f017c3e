//! Bodies that lose momentum to what resists them, weakly or not.
//!
//! The parts are the free rotation, exact as without resistance, and the change of L at a fixed
//! attitude: resistance and kick together, exact as well
//! ([`Resistance`](crate::effects::Resistance)). However strong the resistance is, it costs no
//! steps of its own; a spin that dry friction stops is stopped at 0 and not beyond.

use super::Separable;
use super::body::{BodyPoint, Free};
use crate::attitude::Attitude;
use crate::body::State;
use crate::effects::{Effect, Resistance};
use crate::error::{Error, Result, finite};
use crate::frame::{BodyVector, SpaceVector};
use crate::integrators::spin_free::spun;
use crate::scene::Scene;

/// A scene whose effects see the axis only or resist the rotation, as a problem for
/// [`Splitting`](super::Splitting).
///
/// The spin of a symmetric body is taken out as in [`SpinFree`](crate::integrators::SpinFree). L_z
/// goes its own way, L_z' = -k L_z or its law, and the angle of the spin is the integral of that in
/// closed form.
///
/// Which scheme: all keep their order but SRKN 14a, whose order 6 rests on kicks that depend on the
/// attitude only. It falls to 4 where the resistance is strong (measured 4.0 with a rate of 3/s on
/// a body that turns by 2 rad/s), and is the cheapest all the same where it is weak. Where dry
/// friction stops the spin on the way, take one without negative parts, Strang or ABA(8,2), or cut
/// the run at the stop. [`Scene::solve`] cuts there by itself.
///
/// Cost: for the gyroscope of the example below, off by 9.4e-7 rad after ten seconds, SRKN 14a
/// takes 2800 kicks, DOP853 nearly 14 times as many derivatives.
///
/// ```
/// use rotation_dynamics::attitude::{Attitude, EulerAngles};
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::{GravityAtLever, ViscousFriction};
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::integrators::{Dop853, Integrator, Resisted, Scheme, Splitting};
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// // A top whose bearings are not quite free, for ten seconds.
/// let body = RigidBody::new(PrincipalMoments::symmetric(5.45e-3, 9.0e-4)?);
/// let friction = ViscousFriction::new(1e-5, 2e-6)?;
/// let scene = Scene::new(body).with(GravityAtLever::new(4.9, 0.1)?).with(friction);
/// let tilted = Attitude::from_euler(EulerAngles { phi: 0.0, theta: 1.0, zeta: 0.0 })?;
/// let start = body.state(tilted, BodyVector::new(0.0, 0.0, 314.0))?;
/// let split = Splitting::new(Scheme::SRKN14, 200)?;
/// let (end, work) = split.advance(&Resisted::new(&scene, 0.0)?, 0.0, &start, 10.0)?;
/// let (other, more) = Dop853::new(1e-12)?.advance(&scene, 0.0, &start, 10.0)?;
/// assert!(end.attitude.angle_to(&other.attitude) < 1e-6);
/// assert!(14 * work.torques() < more.torques());
/// # Ok(())
/// # }
/// ```
///
/// Source: splittings with a dissipative part, as E. Hairer, C. Lubich, G. Wanner, *Geometric
/// Numerical Integration*, II.5, compose any two flows.
#[derive(Debug, Clone, Copy)]
pub struct Resisted<'s, E> {
    scene: &'s Scene<E>,
    resistance: Resistance,
}

impl<'s, E: Effect> Resisted<'s, E> {
    /// The scene from the time `t` (s) to its next break point.
    ///
    /// # Errors
    /// Effects without a closed form at a fixed attitude; resistance across the axis of a
    /// symmetric body that is not the same in all directions.
    pub fn new(scene: &'s Scene<E>, t: f64) -> Result<Self> {
        finite("time", t)?;
        let body = scene.body();
        let known = (scene.effects().resistance(t, body))
            .filter(|r| r.is_round() || !body.moments().is_symmetric());
        let resistance =
            known.ok_or_else(|| Error::sees_more(scene.effects().names().join(", ")))?;
        Ok(Self { scene, resistance })
    }

    /// What resists.
    pub const fn resistance(&self) -> &Resistance {
        &self.resistance
    }
}

/// The point of a body, and of a symmetric one L_z at the start.
#[derive(Debug, Clone, Copy)]
pub struct ResistedPoint {
    point: BodyPoint,
    axial: f64,
}

impl<E: Effect> Separable for Resisted<'_, E> {
    type State = State;
    type Point = ResistedPoint;

    fn enter(&self, state: &State) -> Result<ResistedPoint> {
        let body = self.scene.body();
        Ok(ResistedPoint {
            point: BodyPoint::new(body, state),
            axial: body.angular_momentum(state).z(),
        })
    }

    fn leave(&self, ResistedPoint { point, axial }: &ResistedPoint, elapsed: f64) -> Result<State> {
        let spin = match point.free {
            Free::Symmetric { .. } => {
                let (i1, i3) = {
                    let moments = self.scene.body().moments();
                    (moments.i1(), moments.i3())
                };
                self.resistance.axial_integral(*axial, elapsed) / i3 * ((i1 - i3) / i1)
            }
            Free::Asymmetric(_) => 0.0,
        };
        spun(point.quaternion.value, spin, point.momentum.value)
    }

    fn flow(&self, point: &mut ResistedPoint, dt: f64) {
        point.point.turn_freely(self.scene.body(), dt);
    }

    /// The momentum changes as it does at a fixed attitude; nothing moves.
    fn kick(&self, point: &mut ResistedPoint, dt: f64) {
        let BodyPoint { quaternion, momentum, .. } = &mut point.point;
        let attitude = Attitude::from_unit(quaternion.value);
        let axis = attitude.axis().to_array();
        let torque = (self.scene.effects()).torques_on_axis(self.scene.body(), axis);
        let on_body = |v: [f64; 3]| attitude.to_body(SpaceVector::from_array(v)).to_array();
        let [a, b, _] = on_body(torque);
        let gained = (self.resistance).gained(on_body(momentum.value), [a, b, 0.0], dt);
        let gained = attitude.to_space(BodyVector::from_array(gained));
        *momentum = momentum.plus(&gained.to_array());
    }

    fn settle(&self, point: &mut ResistedPoint) {
        point.point.settle();
    }
}
