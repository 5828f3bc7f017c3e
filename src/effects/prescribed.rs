//! A torque known as a function of time.

use super::{Effect, Feature, Properties, rising};
use crate::body::{RigidBody, State};
use crate::error::{Error, Result, all_finite, finite, plain, positive};
use crate::frame::{BodyVector, SpaceVector};
use crate::math::exp;

/// How strong a torque is in the course of time: a factor, without unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile(Shape);

#[derive(Debug, Clone, PartialEq)]
enum Shape {
    Steps(Vec<f64>, Vec<f64>),
    Lines(Vec<f64>, Vec<f64>),
    /// With the second derivatives.
    Cubic(Vec<f64>, Vec<f64>, Vec<f64>),
    Pulse {
        centre: f64,
        width: f64,
    },
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
    /// As [`steps`](Self::steps); a difference of two neighbours beyond `f64`.
    pub fn lines(points: &[(f64, f64)]) -> Result<Self> {
        let (times, values) = table(points)?;
        for (of, all) in [("times of a profile", &times), ("values of a profile", &values)] {
            for (n, two) in all.windows(2).enumerate() {
                finite("difference from the next", two[1] - two[0])
                    .map_err(|reason| Error::at_index(of, n, reason))?;
            }
        }
        Ok(Self(Shape::Lines(times, values)))
    }

    /// A natural cubic spline through each value at its time (s, rising); before the first and after
    /// the last it is 0. For values of something smooth, where straight lines would be too rough: it
    /// may pass beyond the values beside a step.
    ///
    /// Between two points a time h apart, with the part b of it gone and a = 1 - b left,
    ///
    /// ```text
    /// y = a y_0 + b y_1 + ((a^3 - a) m_0 + (b^3 - b) m_1) h^2/6,
    /// h_0 m_0 + 2 (h_0 + h_1) m_1 + h_1 m_2 = 6 ((y_2 - y_1)/h_1 - (y_1 - y_0)/h_0)
    /// ```
    ///
    /// for each three points in a row, with m = 0 at both ends.
    ///
    /// Source: C. de Boor, *A Practical Guide to Splines* (1978), ch. IV.
    ///
    /// ```
    /// use rotation_dynamics::effects::Profile;
    /// let bow = Profile::cubic(&[(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)])?;
    /// assert!((bow.at(0.5) - 11.0 / 16.0).abs() < 1e-15);
    /// # Ok::<(), rotation_dynamics::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`steps`](Self::steps); values so large or times so near that the curve is beyond `f64`.
    pub fn cubic(points: &[(f64, f64)]) -> Result<Self> {
        let (times, values) = table(points)?;
        let bends = second_derivatives(&times, &values);
        if !bends.iter().all(|bend| bend.is_finite()) {
            return Err(too_steep(&times, &values));
        }
        Ok(Self(Shape::Cubic(times, values, bends)))
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
            Shape::Cubic(times, values, bends) => {
                let next = times.partition_point(|point| *point <= t);
                if next == 0 || next == times.len() {
                    return 0.0;
                }
                let h = times[next] - times[next - 1];
                let (b, a) = ((t - times[next - 1]) / h, (times[next] - t) / h);
                let bent = (a * a * a - a) * bends[next - 1] + (b * b * b - b) * bends[next];
                a * values[next - 1] + b * values[next] + bent * (h * h / 6.0)
            }
            Shape::Pulse { centre, width } => {
                let x = (t - centre) / width;
                exp(-0.5 * x * x)
            }
        }
    }

    /// The largest size of the factor, or a bound on it.
    fn largest(&self) -> f64 {
        let most = |values: &[f64]| values.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        match &self.0 {
            Shape::Steps(_, values) | Shape::Lines(_, values) => most(values),
            Shape::Cubic(times, values, bends) => {
                // No cubic is further from its chord: (a - a^3) + (b - b^3) is at most 3/4.
                let bent = |n: usize| {
                    let h = times[n + 1] - times[n];
                    h * h / 8.0 * most(&bends[n..n + 2])
                };
                most(values) + (0..times.len() - 1).map(bent).fold(0.0, f64::max)
            }
            Shape::Pulse { .. } => 1.0,
        }
    }
}

/// The second derivatives of the natural cubic spline at its points, by elimination downwards.
fn second_derivatives(times: &[f64], values: &[f64]) -> Vec<f64> {
    let n = times.len();
    let (mut factor, mut bend) = (vec![0.0; n], vec![0.0; n]);
    for i in 1..n.saturating_sub(1) {
        let (before, after) = (times[i] - times[i - 1], times[i + 1] - times[i]);
        let slope = (values[i + 1] - values[i]) / after - (values[i] - values[i - 1]) / before;
        let pivot = 2.0 * (before + after) - before * factor[i - 1];
        factor[i] = after / pivot;
        bend[i] = (6.0 * slope - before * bend[i - 1]) / pivot;
    }
    for i in (1..n.saturating_sub(1)).rev() {
        bend[i] -= factor[i] * bend[i + 1];
    }
    bend
}

/// The points of a table between which a cubic would bend most, which doubles do not hold.
fn too_steep(times: &[f64], values: &[f64]) -> Error {
    let bend = |n: &usize| {
        let dt = times[n + 1] - times[*n];
        (values[n + 1] / dt - values[*n] / dt).abs() / dt
    };
    let most = |a: &usize, b: &usize| bend(a).total_cmp(&bend(b));
    let n = (0..times.len() - 1).max_by(most).unwrap_or(0);
    let allowed = format!(
        "the curve from the value {} to {} in that time is beyond doubles; take points further apart",
        plain(values[n]),
        plain(values[n + 1])
    );
    let reason = Error::out_of_range("time to the next", times[n + 1] - times[n], allowed);
    Error::at_index("times of a profile", n, reason)
}

/// Times and values of a table, if they are in order.
fn table(rows: &[(f64, f64)]) -> Result<(Vec<f64>, Vec<f64>)> {
    if rows.is_empty() {
        return Err(Error::Lengths { name: "pieces of a profile", found: 0, expected: 1 });
    }
    let (times, values): (Vec<f64>, Vec<f64>) = rows.iter().copied().unzip();
    all_finite("values of a profile", &values)?;
    Ok((rising("times of a profile", &times)?, values))
}

/// A torque that is known as a function of time, on the fixed axes or on the body's.
///
/// It is a constant vector times a [`Profile`]. The profile has pieces with jumps or kinks at times
/// that are named as break points, so that solutions meet them exactly. Or it is a spline through a
/// table, or a pulse, whose width is named so that no solution steps over it. A thruster, a motor,
/// a kick. A function of your own is for [`Torque`](super::Torque).
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
        for (name, m) in ["torque, x", "torque, y", "torque, z"].into_iter().zip(components) {
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
}

impl Effect for PrescribedTorque {
    const PROPERTIES: Properties =
        Properties { on_rates: false, smooth: true, ..Properties::ANYTHING };

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
            Shape::Steps(times, _) | Shape::Lines(times, _) | Shape::Cubic(times, ..) => {
                times.clone()
            }
            Shape::Pulse { .. } => Vec::new(),
        }
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(match self.profile.0 {
            Shape::Pulse { width, .. } => Feature { time: width, ..Feature::WIDE },
            Shape::Steps(..) | Shape::Lines(..) | Shape::Cubic(..) => Feature::WIDE,
        })
    }
}
