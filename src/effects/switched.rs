//! A torque that switches with the state.

use super::{Effect, Feature, Law, Part, Properties, Torque};
use crate::body::{RigidBody, State};
use crate::frame::SpaceVector;
use core::fmt;
use std::sync::Arc;

/// Of time (s), body and state.
type Signal<'f> = dyn Fn(f64, &RigidBody, &State) -> f64 + Send + Sync + 'f;

/// One torque where a signal is below zero, another where it is not. Examples are a relay, a
/// thruster that fires beyond an angle, a brake that lets go at a rate, dry friction that only
/// changes its side.
///
/// ```text
/// torque = below(t, body, state) if signal(t, body, state) < 0, else above(t, body, state)
/// ```
///
/// The times at which the signal changes its sign are located as events, to their rounding, and runs
/// are cut there. Each torque is a law of its own on either side of zero; declare both
/// [`smooth`](Torque::smooth) if they are. If both drive the signal back to zero, the motion slides
/// along it, no law says by which torque, and [`Error::Sliding`](crate::Error::Sliding) names it.
///
/// A thruster with a dead zone is two of these, one for each side; if its signal also contains the
/// rate, so that it brakes, the motion often slides unless there is hysteresis. Hysteresis is a
/// [`Law`] of one's own, or the law is [sampled](Torque::sampled).
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::{RigidBody, State};
/// use rotation_dynamics::effects::{Switched, Torque};
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// // A motor that is switched off at 2 rad/s.
/// let off = Torque::on_body("off", |_, _, _| BodyVector::new(0.0, 0.0, 0.0)).smooth();
/// let on = Torque::on_body("on", |t, _, _| BodyVector::new(0.0, 0.0, 0.1 * t)).smooth();
/// let slow = |_t: f64, body: &RigidBody, state: &State| 2.0 - body.angular_velocity(state).z();
/// let motor = Switched::new("motor", slow, off, on);
/// let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
/// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 1.0))?;
/// let end = Scene::new(body).with(motor).solve(&start, 9.0, 1e-9)?.state;
/// assert!((body.angular_velocity(&end).z() - 2.0).abs() < 1e-12);
///
/// // Three levels are two of these: thrusters that push back where the body is turned by more than
/// // 0.2 rad to either side (the quaternion's z is beyond 0.1), and rest in between. There the body
/// // drifts; it comes back as fast as it came.
/// let push = |size| Torque::on_body("push", move |_, _, _| BodyVector::new(0.0, 0.0, size)).smooth();
/// let aside = |state: &State| state.attitude.quaternion()[3];
/// let over = move |_t: f64, _: &RigidBody, state: &State| 0.1 - aside(state);
/// let under = move |_t: f64, _: &RigidBody, state: &State| 0.1 + aside(state);
/// let thrusters = Scene::new(body)
///     .with(Switched::new("back", over, push(-1.0), push(0.0)))
///     .with(Switched::new("forth", under, push(1.0), push(0.0)));
/// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 0.3))?;
/// let end = thrusters.solve(&start, 1.5, 1e-9)?.state;
/// assert!((body.angular_velocity(&end).z() + 0.3).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
///
/// Not for: torques that jump at known times, which are named as break points
/// ([`Torque::with_break_points`]).
#[derive(Clone)]
pub struct Switched<'f, const SMOOTH: bool = false> {
    name: &'static str,
    signal: Arc<Signal<'f>>,
    below: Torque<'f, SMOOTH>,
    above: Torque<'f, SMOOTH>,
}

impl<'f, const SMOOTH: bool> Switched<'f, SMOOTH> {
    /// The torque `below` where the signal is below zero, else `above`. A signal that jumps
    /// over zero, as a heading from pi to -pi, switches there too.
    pub fn new(
        name: &'static str,
        signal: impl Fn(f64, &RigidBody, &State) -> f64 + Send + Sync + 'f,
        below: Torque<'f, SMOOTH>,
        above: Torque<'f, SMOOTH>,
    ) -> Self {
        Self { name, signal: Arc::new(signal), below, above }
    }
}

impl<const SMOOTH: bool> Effect for Switched<'_, SMOOTH> {
    const PROPERTIES: Properties = Torque::<SMOOTH>::PROPERTIES;

    fn name(&self) -> &'static str {
        self.name
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.torque_held(self.held(None, t, body, state), t, body, state)
    }

    fn break_points(&self) -> Vec<f64> {
        [self.below.break_points(), self.above.break_points()].concat()
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(self.below.narrowest()?.and(self.above.narrowest()?))
    }

    fn parts(&self) -> Vec<Part<'_>> {
        vec![Part::of(self)]
    }
}

/// The held value is the sign of the signal.
impl<const SMOOTH: bool> Law for Switched<'_, SMOOTH> {
    fn held(&self, _: Option<[f64; 3]>, t: f64, body: &RigidBody, state: &State) -> [f64; 3] {
        // Of -0 as of 0.
        [((self.signal)(t, body, state) + 0.0).signum(), 0.0, 0.0]
    }

    fn torque_held(&self, held: [f64; 3], t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        let side = if held[0] < 0.0 { &self.below } else { &self.above };
        side.torque(t, body, state)
    }

    fn margin(&self, [side, ..]: [f64; 3], t: f64, body: &RigidBody, state: &State) -> f64 {
        side * (self.signal)(t, body, state)
    }

    fn beyond(&self, held: [f64; 3], _: f64, _: &RigidBody, _: &State) -> [f64; 3] {
        held.map(|side| -side)
    }
}

impl<const SMOOTH: bool> fmt::Debug for Switched<'_, SMOOTH> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (f.debug_struct("Switched").field("name", &self.name))
            .field("below", &self.below)
            .field("above", &self.above)
            .finish_non_exhaustive()
    }
}
