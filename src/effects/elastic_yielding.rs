//! A body whose figure follows its axis of rotation, in part.

use super::{Conserved, Effect, Feature, Properties};
use crate::attitude::Attitude;
use crate::body::{RigidBody, State};
use crate::error::{Error, Result, finite, not_negative, positive};
use crate::frame::{BodyVector, SpaceVector};
use crate::inertia::PrincipalMoments;

/// Newton's steps for omega^2, at most: two or three do, more where a soft body turns fast.
const STEPS: usize = 128;

/// Elastic yielding to the centrifugal force: the tensor of inertia follows the angular
/// velocity,
///
/// ```text
/// I(omega) = I + b (omega omega^T - Omega^2 e3 e3^T - (omega^2 - Omega^2)/3),
/// b = k2 R^5/(3 G),
/// ```
///
/// on the body's axes. I are the moments of the body; it has them while it turns about e3 at
/// its mean rate Omega. A fluid body has k2 = k_s, by which all of its equatorial bulge
/// follows: b Omega^2 = I3 - (I1 + I2)/2. The [`number`](Self::number) is k2/k_s.
///
/// Multiplied by omega, the part that follows gives a part along omega: L = (I' + s) omega with the
/// same s = 2 b omega^2/3 on all three axes. Here I' = I - b Omega^2 (e3 e3^T - 1/3), the moments
/// without rotation. So at each moment the body turns as the rigid body with the moments I' + s
/// ([`moments`](Self::moments)) would, found from L by Newton's method, to rounding and for any b.
/// A symmetric body keeps them for ever: it moves as this rigid body, and its free period is
///
/// ```text
/// (I1 + b Omega^2)/((1 - k2/k_s)(I3 - I1)) turns
/// ```
///
/// for small wobbles at the mean rate, longer by the factor 1/(1 - k2/k_s) nearly.
///
/// There is no torque; the slip is omega - I^-1 L. The energy, kept, belongs to the motion and to
/// the strain: its part beyond L^2/2I is the effect's potential,
///
/// ```text
/// U = omega . I(omega) omega/2 + b omega^4/6 - L . I^-1 L/2   (but for a constant).
/// ```
///
/// Range of validity: a body that is nearly round, whose own oscillations are fast against
/// the rotation (it yields at once), without loss (add
/// [`InternalDissipation`](super::InternalDissipation)).
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::body::RigidBody;
/// use rotation_dynamics::effects::ElasticYielding;
/// use rotation_dynamics::frame::BodyVector;
/// use rotation_dynamics::inertia::PrincipalMoments;
/// use rotation_dynamics::scene::{Invariant, Scene};
/// # fn main() -> rotation_dynamics::Result<()> {
/// // A body that wobbles once in 3 turns; when half of its bulge follows, once in 7.
/// let body = RigidBody::new(PrincipalMoments::symmetric(3.0, 4.0)?);
/// let rate = core::f64::consts::TAU;
/// let yielding = ElasticYielding::following(0.5, &body, rate)?;
/// let wobble = BodyVector::new(1e-3, 0.0, rate);
/// let start = yielding.state(&body, Attitude::IDENTITY, wobble)?;
/// let scene = Scene::new(body).with(yielding);
/// let end = scene.solve(&start, 7.0, 1e-9)?.state;
/// let back = scene.angular_velocity(7.0, &end) - wobble;
/// assert!(back.norm() < 1e-8);
/// // It keeps everything that a free body keeps.
/// assert_eq!(scene.invariants().filter(|kept| *kept == Invariant::Energy).count(), 1);
/// # Ok(())
/// # }
/// ```
///
/// Accuracy: against the rigid body with its moments, and against the tensor computed anew
/// for each omega, see `tests/accuracy/elastic_yielding.rs`.
///
/// Source: A. E. H. Love, Proc. R. Soc. A 82, 73 (1909); W. H. Munk, G. J. F. MacDonald,
/// *The Rotation of the Earth* (1960). The form with s, and the energy, follow from the
/// Lagrangian omega . I' omega/2 + b omega^4/6.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElasticYielding {
    compliance: f64,
    rate: f64,
}

impl ElasticYielding {
    /// The yielding with this b (kg m^2 s^2, not negative), of a body that has its moments
    /// while it turns about e3 at this mean rate (rad/s, positive).
    ///
    /// # Errors
    /// A number outside its range, or not finite.
    pub fn new(compliance: f64, rate: f64) -> Result<Self> {
        not_negative("compliance", compliance)?;
        positive("mean rate", rate)?;
        finite("compliance times rate squared", compliance * rate * rate)?;
        Ok(Self { compliance, rate })
    }

    /// The yielding with this Love number k2 (not negative) of a body with this mean radius
    /// (m), by b = k2 R^5/(3 G), G = 6.6743e-11 m^3/(kg s^2); the mean rate in rad/s.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn from_love_number(k2: f64, radius: f64, rate: f64) -> Result<Self> {
        not_negative("Love number", k2)?;
        positive("radius", radius)?;
        let square = radius * radius;
        Self::new(k2 * (square * square * radius / (3.0 * 6.674_3e-11)), rate)
    }

    /// The yielding by which this part k2/k_s of the bulge follows the axis, of a body that
    /// turns about e3 at this mean rate (rad/s, positive).
    ///
    /// # Errors
    /// As [`new`](Self::new); of a body without a bulge, or a thin one, a part other than 0.
    pub fn following(part: f64, body: &RigidBody, rate: f64) -> Result<Self> {
        finite("part that follows", part)?;
        positive("mean rate", rate)?;
        let following = part * bulge(body);
        if following < 0.0 || (following == 0.0 && part != 0.0) {
            return Err(Error::out_of_range(
                "part of the bulge that follows times the bulge",
                following,
                "a part above 0 of a body with I3 above (I1 + I2)/2, or 0",
            ));
        }
        Self::new(following / (rate * rate), rate)
    }

    /// The mean rate Omega (rad/s).
    pub const fn rate(&self) -> f64 {
        self.rate
    }
    /// The angular momentum (kg m^2/s) with which this body turns so (rad/s), both on its
    /// axes.
    pub fn momentum(&self, body: &RigidBody, angular_velocity: BodyVector) -> BodyVector {
        let square = angular_velocity.dot(&angular_velocity);
        let change = self.change(square);
        let [i1, i2, i3] = body.moments().to_array();
        let [w1, w2, w3] = angular_velocity.to_array();
        BodyVector::new((i1 + change[0]) * w1, (i2 + change[1]) * w2, (i3 + change[2]) * w3)
    }

    /// The state of this body with an attitude and an angular velocity on its own axes (rad/s): the
    /// state of its axes, as [`Scene::angular_velocity`] gives it.
    ///
    /// # Errors
    /// Components that are not finite, or a momentum beyond `f64`.
    ///
    /// [`Scene::angular_velocity`]: crate::scene::Scene::angular_velocity
    pub fn state(
        &self,
        body: &RigidBody,
        attitude: Attitude,
        angular_velocity: BodyVector,
    ) -> Result<State> {
        let names = ["omega_1", "omega_2", "omega_3"];
        for (name, value) in names.into_iter().zip(angular_velocity.to_array()) {
            finite(name, value)?;
        }
        let momentum = self.momentum(body, angular_velocity);
        State::new(attitude, attitude.to_space(momentum))
    }

    /// The moments (kg m^2) of the rigid body that turns as this one does in this state; of
    /// a symmetric body they stay the same along the motion.
    ///
    /// # Errors
    /// Moments that belong to no body: the body turns so slowly that a bulge which is not there
    /// would be taken away.
    pub fn moments(&self, body: &RigidBody, state: &State) -> Result<PrincipalMoments> {
        let (_, change) = self.turning(body, body.angular_momentum(state));
        let [i1, i2, i3] = body.moments().to_array();
        PrincipalMoments::new(i1 + change[0], i2 + change[1], i3 + change[2])
    }

    /// I' + s - I for this omega^2.
    fn change(&self, square: f64) -> [f64; 3] {
        let mean = self.rate * self.rate;
        let across = self.compliance * ((2.0 * square + mean) / 3.0);
        let along = self.compliance * (2.0 * (square - mean) / 3.0);
        [across, across, along]
    }

    /// omega^2 and I' + s - I of the body with this momentum, all on its axes.
    #[inline]
    fn turning(&self, body: &RigidBody, momentum: BodyVector) -> (f64, [f64; 3]) {
        let (i, l) = (body.moments().to_array(), momentum.to_array());
        // The square x of omega obeys x = sum (l_i/(I'_i + 2 b x/3))^2. The left side less
        // the right rises and bends down: after one step Newton's method comes from below.
        let mut square = self.rate * self.rate;
        for step in 0..STEPS {
            let change = self.change(square);
            let (mut sum, mut slope) = (0.0, 0.0);
            for k in 0..3 {
                let moment = i[k] + change[k];
                let rate = l[k] / moment;
                sum += rate * rate;
                slope += rate * rate / moment;
            }
            let next = square - (square - sum) / (1.0 + 4.0 / 3.0 * self.compliance * slope);
            if step == 0 || next > square {
                square = next;
            } else {
                break;
            }
        }
        (square, self.change(square))
    }
}

/// I3 - (I1 + I2)/2, from the differences.
fn bulge(body: &RigidBody) -> f64 {
    let [i1, i2, i3] = body.moments().to_array();
    0.5 * ((i3 - i1) + (i3 - i2))
}

impl Effect for ElasticYielding {
    const PROPERTIES: Properties = Properties {
        on_time: false,
        smooth: true,
        slips: true,
        conserved: Conserved::ALL,
        ..Properties::ANYTHING
    };

    fn name(&self) -> &'static str {
        "elastic yielding"
    }

    #[inline]
    fn torque(&self, _t: f64, _body: &RigidBody, _state: &State) -> SpaceVector {
        SpaceVector::zero()
    }

    #[inline]
    fn slip(&self, _t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        let momentum = body.angular_momentum(state);
        let (_, change) = self.turning(body, momentum);
        let (i, l) = (body.moments().to_array(), momentum.to_array());
        // l/(I + change) - l/I, which is small, without a difference.
        let [x, y, z] = core::array::from_fn(|k| -l[k] * (change[k] / (i[k] * (i[k] + change[k]))));
        state.attitude.to_space(BodyVector::new(x, y, z))
    }

    fn potential_energy(&self, _t: f64, body: &RigidBody, state: &State) -> f64 {
        let momentum = body.angular_momentum(state);
        let (square, change) = self.turning(body, momentum);
        let (i, l) = (body.moments().to_array(), momentum.to_array());
        let slipped: f64 =
            (0..3).map(|k| 0.5 * l[k] * l[k] * (change[k] / (i[k] * (i[k] + change[k])))).sum();
        self.compliance * square * square / 6.0 - slipped
    }

    #[inline]
    /// The number by which the yielding is judged, k2/k_s: the part of the bulge that
    /// follows the axis, b Omega^2/|I3 - (I1 + I2)/2|.
    fn number(&self, body: &RigidBody, _state: &State) -> f64 {
        let following = self.compliance * self.rate * self.rate;
        if following == 0.0 {
            return 0.0;
        }
        following / bulge(body).abs()
    }

    fn torque_scale(&self, _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        0.0
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(Feature::WIDE)
    }

    /// The body without its rotation must be a body.
    fn holds_from(
        &self,
        _t: f64,
        body: &RigidBody,
        _start: &State,
        _about_axis: &[&'static str],
    ) -> Result<()> {
        let [i1, i2, i3] = body.moments().to_array();
        let [across, _, along] = self.change(0.0);
        PrincipalMoments::new(i1 + across, i2 + across, i3 + along).map(|_| ())
    }
}
