//! A torque known as a function of time.

use super::{Effect, Feature, Properties, part_per_radian, rising};
use crate::body::{RigidBody, State};
use crate::error::{Error, Result, finite, positive};
use crate::frame::{BodyVector, SpaceVector};
use crate::math::exp;

/// How strong a torque is in the course of time: a factor, without unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile(Shape);

#[derive(Debug, Clone, PartialEq)]
enum Shape {
    Steps(Vec<f64>, Vec<f64>),
    Lines(Vec<f64>, Vec<f64>),
    Pulse { centre: f64, width: f64 },
}

impl Profile {
    /// Constant pieces: each value holds from its time (s, rising) to the next, the last one
    /// for ever; before the first it is 0.
    ///
    /// # Errors
    /// No piece, times that do not rise, anything not finite.
    pub fn steps(pieces: &[(f64, f64)]) -> Result<Self> {
        let (times, values) = table(pieces)?;
        Ok(Self(Shape::Steps(times, values)))
    }

    /// Straight lines from each value at its time (s, rising) to the next; before the first
    /// and after the last it is 0.
    ///
    /// # Errors
    /// As [`steps`](Self::steps).
    pub fn lines(points: &[(f64, f64)]) -> Result<Self> {
        let (times, values) = table(points)?;
        Ok(Self(Shape::Lines(times, values)))
    }

    /// A Gaussian pulse exp(-(t - centre)^2/(2 width^2)), of height 1; times in s.
    ///
    /// # Errors
    /// A centre that is not finite, a width that is not positive and finite.
    pub fn pulse(centre: f64, width: f64) -> Result<Self> {
        finite("centre of the pulse", centre)?;
        positive("width of the pulse", width)?;
        Ok(Self(Shape::Pulse { centre, width }))
    }

    /// The factor at the time `t` (s); where it jumps, that which follows. NaN at a time that is
    /// not finite.
    pub fn at(&self, t: f64) -> f64 {
        if !t.is_finite() {
            return f64::NAN;
        }
        match &self.0 {
            Shape::Steps(times, values) => match times.partition_point(|begin| *begin <= t) {
                0 => 0.0,
                next => values[next - 1],
            },
            Shape::Lines(times, values) => {
                let next = times.partition_point(|point| *point <= t);
                if next == 0 || next == times.len() {
                    return 0.0;
                }
                let part = (t - times[next - 1]) / (times[next] - times[next - 1]);
                values[next - 1] + part * (values[next] - values[next - 1])
            }
            Shape::Pulse { centre, width } => {
                let x = (t - centre) / width;
                exp(-0.5 * x * x)
            }
        }
    }

    /// The largest size of the factor.
    fn largest(&self) -> f64 {
        match &self.0 {
            Shape::Steps(_, values) | Shape::Lines(_, values) => {
                values.iter().fold(0.0, |a: f64, b| a.max(b.abs()))
            }
            Shape::Pulse { .. } => 1.0,
        }
    }
}

/// Times and values of a table, if they are in order.
fn table(rows: &[(f64, f64)]) -> Result<(Vec<f64>, Vec<f64>)> {
    if rows.is_empty() {
        return Err(Error::Lengths {
            name: "pieces of a profile",
            found: 0,
            expected: 1,
        });
    }
    let (times, values): (Vec<f64>, Vec<f64>) = rows.iter().copied().unzip();
    for value in &values {
        finite("value of a profile", *value)?;
    }
    Ok((rising("time of a profile", &times)?, values))
}

/// A torque that is known as a function of time, on the fixed axes or on the body's.
///
/// It is a constant vector times a [`Profile`]: pieces with jumps or kinks at times that
/// are named as break points, so that solutions meet them exactly, or a Gaussian pulse,
/// whose width is named so that no solution steps over it. A thruster, a motor, a kick.
/// A function of your own is for [`Torque`](super::Torque).
///
/// Valid where what acts takes no notice of the motion. Number: [`number`](Self::number).
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::{PrescribedTorque, Profile};
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// // A motor about the axis: 3 s on, then off.
/// let on_off = Profile::steps(&[(1.0, 1.0), (4.0, 0.0)])?;
/// let motor = PrescribedTorque::on_body(BodyVector::new(0.0, 0.0, 0.2), on_off)?;
/// let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5)?);
/// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 0.0))?;
/// let end = Scene::new(body).with(motor).solve(&start, 10.0, 1e-9)?.state;
/// assert!((body.angular_velocity(&end).z() - 0.2 * 3.0 / 0.5).abs() < 1e-9);
/// # Ok(())
/// # }
/// ```
///
/// Source: dL/dt = torque, notes 15.4.
#[derive(Debug, Clone, PartialEq)]
pub struct PrescribedTorque {
    torque: Axes,
    profile: Profile,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Axes {
    Space(SpaceVector),
    Body(BodyVector),
}

impl PrescribedTorque {
    /// This torque on the fixed axes (N m), times the profile.
    ///
    /// # Errors
    /// A component that is not finite, or a product with the profile beyond `f64`.
    pub fn on_space(torque: SpaceVector, profile: Profile) -> Result<Self> {
        Self::new(Axes::Space(torque), profile)
    }

    /// This torque on the body's axes (N m), times the profile.
    ///
    /// # Errors
    /// As [`on_space`](Self::on_space).
    pub fn on_body(torque: BodyVector, profile: Profile) -> Result<Self> {
        Self::new(Axes::Body(torque), profile)
    }

    fn new(torque: Axes, profile: Profile) -> Result<Self> {
        let made = Self { torque, profile };
        let components = match torque {
            Axes::Space(torque) => torque.to_array(),
            Axes::Body(torque) => torque.to_array(),
        };
        for (name, m) in ["torque, x", "torque, y", "torque, z"]
            .into_iter()
            .zip(components)
        {
            finite(name, m)?;
        }
        finite("largest torque", made.largest())?;
        Ok(made)
    }

    /// The largest torque of all times (N m).
    fn largest(&self) -> f64 {
        let length = match self.torque {
            Axes::Space(torque) => torque.norm(),
            Axes::Body(torque) => torque.norm(),
        };
        length * self.profile.largest()
    }

    /// |torque|/(|L| |omega|) at its largest: the part of the momentum that it changes while
    /// the body turns by one radian.
    pub fn number(&self, body: &RigidBody, state: &State) -> f64 {
        part_per_radian(self.largest(), body, state)
    }
}

impl Effect for PrescribedTorque {
    const PROPERTIES: Properties = Properties {
        on_rates: false,
        smooth: true,
        ..Properties::ANYTHING
    };

    fn name(&self) -> &'static str {
        "prescribed torque"
    }

    #[inline]
    fn torque(&self, t: f64, _body: &RigidBody, state: &State) -> SpaceVector {
        let part = self.profile.at(t);
        match self.torque {
            Axes::Space(torque) => torque * part,
            Axes::Body(torque) => state.attitude.to_space(torque * part),
        }
    }

    fn torque_scale(&self, _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        self.largest()
    }

    fn break_points(&self) -> Vec<f64> {
        match &self.profile.0 {
            Shape::Steps(times, _) | Shape::Lines(times, _) => times.clone(),
            Shape::Pulse { .. } => Vec::new(),
        }
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(match self.profile.0 {
            Shape::Pulse { width, .. } => Feature {
                time: width,
                ..Feature::WIDE
            },
            Shape::Steps(..) | Shape::Lines(..) => Feature::WIDE,
        })
    }
}
