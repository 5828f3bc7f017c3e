//! A torque from a closure.

use super::{Effect, Feature, Properties};
use crate::body::{RigidBody, State};
use crate::error::{Error, Result, all_finite, positive};
use crate::frame::{BodyVector, SpaceVector};
use core::fmt;
use std::sync::Arc;

/// The torque on the fixed axes (N m).
type OnSpace<'f> = dyn Fn(f64, &RigidBody, &State) -> SpaceVector + Send + Sync + 'f;

/// The torque that a closure gives of time (s), body and state.
///
/// The closure is a function of time, body and state: it may not remember, and it is `Send + Sync`.
/// One that is called at a rate and held in between is made of it by [`sampled`](Self::sampled).
/// Nothing else is claimed of it but what is added: [`smooth`](Self::smooth),
/// [`with_break_points`](Self::with_break_points), [`with_narrowest`](Self::with_narrowest). A law that is
/// called at a rate is [`sampled`](Self::sampled), one with a largest torque
/// [`saturated`](Self::saturated), one that leaves small errors alone has a [`dead_band`](Self::dead_band).
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::Torque;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// // A thruster across the axis, for three seconds of ten.
/// let thruster = Torque::on_body("thruster", |t, _body, _state| {
///     let push = if (4.0..7.0).contains(&t) { 0.02 } else { 0.0 };
///     BodyVector::new(push, 0.0, 0.0)
/// })
/// .smooth()
/// .with_break_points(&[4.0, 7.0])?;
/// let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
/// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 0.5))?;
/// let end = Scene::new(body).with(thruster).solve(&start, 10.0, 1e-9)?;
/// assert!(end.estimate <= 1e-9);
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
pub struct Torque<'f, const SMOOTH: bool = false> {
    name: &'static str,
    /// Behind a pointer, so that whatever steps it is compiled once for all closures.
    on_space: Arc<OnSpace<'f>>,
    break_points: Vec<f64>,
    narrowest: Option<Feature>,
}

impl<'f> Torque<'f> {
    /// A torque on the fixed axes.
    pub fn on_space(
        name: &'static str,
        torque: impl Fn(f64, &RigidBody, &State) -> SpaceVector + Send + Sync + 'f,
    ) -> Self {
        Self { name, on_space: Arc::new(torque), break_points: Vec::new(), narrowest: None }
    }

    /// A torque on the body's axes.
    pub fn on_body(
        name: &'static str,
        torque: impl Fn(f64, &RigidBody, &State) -> BodyVector + Send + Sync + 'f,
    ) -> Self {
        Self::on_space(name, move |t, body, state| state.attitude.to_space(torque(t, body, state)))
    }

    /// The same, known to be an analytic function of time and state between its break
    /// points ([`with_break_points`](Self::with_break_points)): it has no other jump and no kink.
    ///
    /// A jump that contradicts this is looked for and refused. A kink is not looked for: it may
    /// cost steps, accuracy or the answer. Name it as a break point, or leave `smooth` out.
    pub fn smooth(self) -> Torque<'f, true> {
        Torque {
            name: self.name,
            on_space: self.on_space,
            break_points: self.break_points,
            narrowest: self.narrowest,
        }
    }
}

impl<'f, const SMOOTH: bool> Torque<'f, SMOOTH> {
    /// The same of which nothing is declared.
    pub(super) fn undeclared(self) -> Torque<'f> {
        Torque {
            name: self.name,
            on_space: self.on_space,
            break_points: Vec::new(),
            narrowest: None,
        }
    }
}

impl<const SMOOTH: bool> Torque<'_, SMOOTH> {
    /// The same with jumps or kinks at these times (s, rising).
    ///
    /// Errors: a time that is not finite, or not after the one before it.
    pub fn with_break_points(mut self, times: &[f64]) -> Result<Self> {
        self.break_points = rising("break point", times)?;
        Ok(self)
    }

    /// The same with features no narrower than this.
    ///
    /// Errors: a width that is not positive.
    pub fn with_narrowest(mut self, feature: Feature) -> Result<Self> {
        for (name, width) in [("narrowest time", feature.time), ("narrowest angle", feature.angle)]
        {
            if width != f64::INFINITY {
                positive(name, width)?;
            }
        }
        self.narrowest = Some(feature);
        Ok(self)
    }
}

/// The times, if they are finite and each comes after the one before.
pub(crate) fn rising(name: &'static str, times: &[f64]) -> Result<Vec<f64>> {
    all_finite(name, times)?;
    match times.windows(2).position(|pair| pair[0] >= pair[1]) {
        None => Ok(times.to_vec()),
        Some(index) => Err(Error::not_rising(name, index + 1, times[index], times[index + 1])),
    }
}

impl<const SMOOTH: bool> Effect for Torque<'_, SMOOTH> {
    const PROPERTIES: Properties = Properties { smooth: SMOOTH, ..Properties::ANYTHING };

    fn name(&self) -> &'static str {
        self.name
    }

    #[inline]
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        (self.on_space)(t, body, state)
    }

    fn break_points(&self) -> Vec<f64> {
        self.break_points.clone()
    }

    fn narrowest(&self) -> Option<Feature> {
        self.narrowest
    }
}

impl<const SMOOTH: bool> fmt::Debug for Torque<'_, SMOOTH> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (f.debug_struct("Torque").field("name", &self.name))
            .field("break_points", &self.break_points)
            .field("narrowest", &self.narrowest)
            .finish_non_exhaustive()
    }
}
