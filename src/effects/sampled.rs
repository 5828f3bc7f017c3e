//! A command that is sampled and held.

use super::{Effect, Feature, Law, Part, Properties, Torque};
use crate::body::{RigidBody, State};
use crate::error::{Result, finite, positive};
use crate::frame::{BodyVector, SpaceVector};
use crate::math::EPS;

/// A torque whose law is called at equal distances of time, and held on the body's axes in between:
/// a digital controller with wheels or thrusters that are fixed to the body.
///
/// ```text
/// torque(t) = R(t) u(t_k)   for t_k <= t < t_(k + 1),   t_k = first + k dt,   k = ..., -1, 0, 1, ...
/// ```
///
/// Made by [`Torque::sampled`]. [`Scene::solve`](crate::scene::Scene::solve) calls the law once a sample
/// in each of its runs, and once at the start: a run that starts between two samples holds what the
/// law says there until the next sample. Between samples the torque is smooth whatever the law
/// does: it may saturate, round or look things up. Where a sample falls beside a step of a law that
/// rounds, two runs may round apart, and finer ones follow. A law that remembers more than its
/// command, an integral or a filter, is an effect and a [`Law`] of its own. There is no way back in
/// time.
///
/// As an [`Effect`] it is the law as if it were called just there; an integrator that is used by itself
/// sees that.
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::Torque;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// // A wheel that brakes the rotation, ten times a second.
/// let brake = Torque::on_body("brake", |_t, body, state| body.angular_velocity(state) * -0.4)
///     .sampled(0.1)?;
/// let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
/// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 2.0))?;
/// let end = Scene::new(body).with(brake).solve(&start, 5.0, 1e-9)?.state;
/// // Every sample takes the part 0.4 dt/I of the rate.
/// let left = 2.0 * (1.0_f64 - 0.4 * 0.1 / 0.5).powi(50);
/// assert!((body.angular_velocity(&end).z() - left).abs() < 1e-9);
/// // A wheel gives no more than 0.3 N m, so the law limits the torque; at these rates it does so in
/// // every sample.
/// let weak = Torque::on_body("weak brake", |_t, body, state| {
///     let rate = body.angular_velocity(state).z();
///     BodyVector::new(0.0, 0.0, (-0.4 * rate).clamp(-0.3, 0.3))
/// });
/// let end = Scene::new(body).with(weak.sampled(0.1)?).solve(&start, 1.0, 1e-9)?.state;
/// assert!((body.angular_velocity(&end).z() - (2.0 - 0.3 / 0.5)).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
///
/// Source: the zero-order hold of K. J. Åström, B. Wittenmark, *Computer-Controlled Systems*, 3rd ed.
/// (1997), 2.3.
#[derive(Debug, Clone)]
pub struct SampledControl<'f> {
    law: Torque<'f>,
    dt: f64,
    first: f64,
}

impl<'f, const SMOOTH: bool> Torque<'f, SMOOTH> {
    /// This law, called every `dt` (s), at the time 0 among others, and held in between.
    ///
    /// # Errors
    /// A `dt` that is not positive and finite.
    pub fn sampled(self, dt: f64) -> Result<SampledControl<'f>> {
        Ok(SampledControl {
            law: self.undeclared(),
            dt: positive("time between samples", dt)?,
            first: 0.0,
        })
    }
}

impl SampledControl<'_> {
    /// The same with a sample at the time `first` (s).
    ///
    /// # Errors
    /// A time that is not finite.
    pub fn with_sample_at(self, first: f64) -> Result<Self> {
        finite("time of a sample", first)?;
        Ok(Self { first, ..self })
    }

    /// The sample of this number.
    fn sample(&self, k: f64) -> f64 {
        self.first + k * self.dt
    }

    /// The number of the sample at this time, but for rounding.
    fn number(&self, t: f64) -> Option<f64> {
        let k = ((t - self.first) / self.dt).round();
        let near = 4.0 * EPS * (t.abs() + self.first.abs());
        ((self.sample(k) - t).abs() <= near).then_some(k)
    }
}

impl Effect for SampledControl<'_> {
    const PROPERTIES: Properties =
        Properties { on_rates: false, on_time: false, smooth: true, ..Properties::ANYTHING };

    fn name(&self) -> &'static str {
        self.law.name()
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.law.torque(t, body, state)
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(Feature::WIDE)
    }

    fn parts(&self) -> Vec<Part<'_>> {
        vec![Part::of(self)]
    }
}

/// The held values are the components of the torque on the body's axes.
impl Law for SampledControl<'_> {
    fn held(&self, before: Option<[f64; 3]>, t: f64, body: &RigidBody, state: &State) -> [f64; 3] {
        let before = before.filter(|_| self.number(t).is_none());
        before.unwrap_or_else(|| {
            let torque = self.law.torque(t, body, state);
            state.attitude.to_body(torque).to_array()
        })
    }

    fn torque_held(&self, held: [f64; 3], _: f64, _: &RigidBody, state: &State) -> SpaceVector {
        state.attitude.to_space(BodyVector::from_array(held))
    }

    fn next_sample(&self, t: f64) -> f64 {
        let here = ((t - self.first) / self.dt).floor();
        self.sample(self.number(t).unwrap_or(here) + 1.0)
    }
}
