//! Between attitudes: the shortest arc between two, and arcs through several at given times.

use super::{Attitude, at};
use crate::error::{Error, Result, finite};
use crate::frame::BodyVector;

impl Attitude {
    /// The attitude a `part` of the way to another, on the shortest arc: 0 is this one, 1 the
    /// other. The turn is about one axis and uniform; parts below 0 and above 1 go on with it.
    ///
    /// a exp(part log(a^-1 b)): spherical linear interpolation.
    ///
    /// Errors: a part that is not finite; [`Error::OutOfRange`] with the angle where the two are
    /// half a turn apart within 2e-12 rad, which leaves two arcs open.
    /// Accuracy: 6.7 eps for parts in 0..=1, measured in `tests/bodies/attitude`, for
    /// neighbours at 1e-16 rad as for others.
    /// Cost: as [`Attitude::rotation_vector`]. Source: K. Shoemake, SIGGRAPH 85, 245 (1985).
    ///
    /// ```
    /// use rotation_dynamics::attitude::Attitude;
    /// use rotation_dynamics::frame::SpaceVector;
    /// let turned = Attitude::about_space_axis(SpaceVector::new(1.0, 0.0, 0.0), 1.2)?;
    /// let third = Attitude::IDENTITY.toward(&turned, 1.0 / 3.0)?;
    /// assert!((third.rotation_vector().x() - 0.4).abs() < 1e-15);
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    #[doc(alias = "slerp")]
    pub fn toward(&self, other: &Self, part: f64) -> Result<Self> {
        finite("part", part)?;
        self.turned_in_body(self.arc_to(other)? * part)
    }

    /// The shortest turn to another attitude, on the body's axes (rad).
    fn arc_to(&self, other: &Self) -> Result<BodyVector> {
        let step = self.inverse() * *other;
        if step.quaternion()[0].abs() <= 1e-12 {
            return Err(Error::out_of_range(
                "angle between the two attitudes",
                self.angle_to(other),
                "at half a turn two arcs are equally short; name an attitude on the way",
            ));
        }
        Ok(step.rotation_vector().to_array().into())
    }
}

/// Attitudes at given times, and the shortest arcs between neighbours.
///
/// From one time to the next the turn is uniform; at a given time the angular velocity jumps. For
/// attitudes that were recorded or drawn up; [`Scene::solve_at`](crate::scene::Scene::solve_at)
/// knows the motion of a scene between two times.
///
/// ```
/// use rotation_dynamics::attitude::{Arcs, Attitude};
/// use rotation_dynamics::frame::SpaceVector;
/// let about_z = |angle| Attitude::about_space_axis(SpaceVector::new(0.0, 0.0, 1.0), angle);
/// let arcs = Arcs::through(&[(0.0, about_z(0.0)?), (1.0, about_z(2.0)?), (5.0, about_z(4.0)?)])?;
/// assert!(arcs.at(3.0)?.angle_to(&about_z(3.0)?) < 1e-15);
/// assert!(arcs.at(5.5).is_err());
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Arcs {
    /// Time (s), attitude, and the turn to the next.
    knots: Vec<(f64, Attitude, BodyVector)>,
}

impl Arcs {
    /// Arcs through these attitudes, each with its time (s).
    ///
    /// Errors: no attitude; a time that is not finite or not after the one before it, or
    /// neighbours that are half a turn apart, with the index.
    pub fn through(given: &[(f64, Attitude)]) -> Result<Self> {
        let mut knots: Vec<(f64, Attitude, BodyVector)> = Vec::with_capacity(given.len());
        for (index, (t, attitude)) in given.iter().enumerate() {
            finite("t", *t).map_err(at("attitudes", index))?;
            if let Some((before, from, turn)) = knots.last_mut() {
                if *t <= *before {
                    return Err(Error::not_rising("times", index, *before, *t));
                }
                *turn = from.arc_to(attitude).map_err(at("attitudes", index))?;
            }
            knots.push((*t, *attitude, BodyVector::zero()));
        }
        if knots.is_empty() {
            let allowed = "there must be at least one";
            return Err(Error::out_of_range("number of attitudes", 0.0, allowed));
        }
        Ok(Self { knots })
    }

    /// The attitude at a time (s); at a given time the given one, to the last bit.
    ///
    /// Errors: a time that is not finite; [`Error::OutsideRun`] before the first and after the
    /// last. Accuracy: as [`Attitude::toward`].
    pub fn at(&self, t: f64) -> Result<Attitude> {
        finite("t", t)?;
        let next = self.knots.partition_point(|(time, ..)| *time <= t);
        let (start, end) = (self.knots[0].0, self.knots[self.knots.len() - 1].0);
        if next == 0 || t > end {
            return Err(Error::OutsideRun { t, start, end });
        }
        let (before, attitude, turn) = self.knots[next - 1];
        if t == before {
            return Ok(attitude);
        }
        let after = self.knots[next].0;
        // Halves first: the distance of two huge times must not overflow.
        let part = (0.5 * t - 0.5 * before) / (0.5 * after - 0.5 * before);
        attitude.turned_in_body(turn * part)
    }
}
