//! A law that saturates, and one with a dead band.

use super::{Effect, Feature, Law, Part, Properties, Torque};
use crate::body::{RigidBody, State};
use crate::error::{Result, positive};
use crate::frame::{BodyVector, SpaceVector};
use crate::math::{EPS, smaller};

/// A torque whose components u on the body's axes are cut at a limit, or from it on.
///
/// ```text
/// saturated:  -limit below -limit,   u between,   limit above limit
/// dead band:  u + band below -band,  0 between,   u - band above band
/// ```
///
/// Made by [`Torque::saturated`] and [`Torque::dead_band`]: a motor that gives no more than its
/// largest torque, a controller that leaves small errors alone, a joint with play. The kinks are
/// located as events, each component by itself, and runs are cut there. Declare the law
/// [`smooth`](Torque::smooth) if it is: otherwise three runs at least are made, as over every
/// torque of which nothing is declared.
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::Torque;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// // A brake of 0.3 N m at most.
/// let brake = Torque::on_body("brake", |_t, body, state| body.angular_velocity(state) * -0.4)
///     .smooth()
///     .saturated(0.3)?;
/// let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
/// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 2.0))?;
/// let end = Scene::new(body).with(brake).solve(&start, 5.0, 1e-9)?.state;
/// // Down to 0.75 rad/s in proportion to the time, from there on exponentially.
/// let until = (2.0 - 0.75) * 0.5 / 0.3;
/// let left = 0.75 * rotation_dynamics::math::exp(-0.4 / 0.5 * (5.0 - until));
/// assert!((body.angular_velocity(&end).z() - left).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
///
/// Not for: a law that is sampled, which saturates inside the law.
///
/// Source: the characteristics of J.-J. E. Slotine, W. Li, *Applied Nonlinear Control* (1991), 5.2.
#[derive(Debug, Clone)]
pub struct Limited<'f, const SMOOTH: bool = false> {
    law: Torque<'f, SMOOTH>,
    limit: f64,
    saturates: bool,
}

impl<'f, const SMOOTH: bool> Torque<'f, SMOOTH> {
    /// This law with no component on the body's axes beyond `limit` (N m), to either side.
    ///
    /// # Errors
    /// A limit that is not positive and finite.
    pub fn saturated(self, limit: f64) -> Result<Limited<'f, SMOOTH>> {
        Ok(Limited { law: self, limit: positive("limit of a torque", limit)?, saturates: true })
    }

    /// The excess of each component of this law, on the body's axes, over `band` (N m), to either
    /// side.
    ///
    /// # Errors
    /// A band that is not positive and finite.
    pub fn dead_band(self, band: f64) -> Result<Limited<'f, SMOOTH>> {
        Ok(Limited { law: self, limit: positive("dead band of a torque", band)?, saturates: false })
    }
}

/// A torque that stays at its limit is on either side of it by its rounding: it leaves a side where it
/// is this part beyond.
const ROUNDING: f64 = 4.0 * EPS;

impl<const SMOOTH: bool> Limited<'_, SMOOTH> {
    /// The components of the law on the body's axes.
    fn wanted(&self, t: f64, body: &RigidBody, state: &State) -> [f64; 3] {
        let torque = self.law.torque(t, body, state);
        state.attitude.to_body(torque).to_array()
    }

    /// How far a component is from leaving its side.
    fn room(&self, side: f64, wanted: f64) -> f64 {
        if side == 0.0 {
            self.limit * (1.0 + ROUNDING) - wanted.abs()
        } else {
            side * wanted - self.limit * (1.0 - ROUNDING)
        }
    }
}

impl<const SMOOTH: bool> Effect for Limited<'_, SMOOTH> {
    const PROPERTIES: Properties = Torque::<SMOOTH>::PROPERTIES;

    fn name(&self) -> &'static str {
        self.law.name()
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.torque_held(self.held(None, t, body, state), t, body, state)
    }

    fn break_points(&self) -> Vec<f64> {
        self.law.break_points()
    }

    fn narrowest(&self) -> Option<Feature> {
        self.law.narrowest()
    }

    fn parts(&self) -> Vec<Part<'_>> {
        vec![Part::of(self)]
    }
}

/// It holds on which side each component is: -1, 0 between the limits, 1.
impl<const SMOOTH: bool> Law for Limited<'_, SMOOTH> {
    fn held(&self, _: Option<[f64; 3]>, t: f64, body: &RigidBody, state: &State) -> [f64; 3] {
        self.wanted(t, body, state)
            .map(|wanted| if wanted.abs() <= self.limit { 0.0 } else { wanted.signum() })
    }

    fn torque_held(&self, held: [f64; 3], t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        let mut torque = self.wanted(t, body, state);
        for (wanted, side) in torque.iter_mut().zip(held) {
            let at_limit = side * self.limit;
            *wanted = match (self.saturates, side == 0.0) {
                (true, true) => *wanted,
                (true, false) => at_limit,
                (false, true) => 0.0,
                (false, false) => *wanted - at_limit,
            };
        }
        state.attitude.to_space(BodyVector::from_array(torque))
    }

    fn margin(&self, held: [f64; 3], t: f64, body: &RigidBody, state: &State) -> f64 {
        let wanted = self.wanted(t, body, state);
        let [a, b, c] = [0, 1, 2].map(|n| self.room(held[n], wanted[n]));
        smaller(smaller(a, b), c)
    }

    fn beyond(&self, held: [f64; 3], t: f64, body: &RigidBody, state: &State) -> [f64; 3] {
        let wanted = self.wanted(t, body, state);
        let room = [0, 1, 2].map(|n| self.room(held[n], wanted[n]));
        let least = smaller(smaller(room[0], room[1]), room[2]);
        core::array::from_fn(|n| match held[n] {
            side if room[n] > least.max(0.0) => side,
            0.0 => wanted[n].signum(),
            _ => 0.0,
        })
    }
}
