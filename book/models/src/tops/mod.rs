//! Tops on a rounded tip that slides, creeps, rolls, and falls.
//!
//! A symmetric body ends in a ball of the radius r, whose centre lies on the axis, a distance l
//! below the centre of mass. It spins on a level floor (or on one that slopes a little). Six
//! coordinates and their momenta are carried; the floor pushes with a normal force N, rubs by a
//! [law](TipFriction) of your choice, and lets go where N would have to pull. An effect that is not
//! asked for is not there: friction, [resistances](ResistingMoment) of the contact and
//! [effects](rotation_dynamics::effects) on the body are types, and absent ones compile to nothing.
//!
//! | item | what it is |
//! |---|---|
//! | [`Shape`] | mass, moments, lever, tip and rim of the body |
//! | [`Top`] | the shape, the floor's friction, resistances, effects, and marks to be passed |
//! | [`Smooth`], [`Dry`], [`Patch`], [`NoSlip`] | the laws of friction |
//! | [`Drilling`], [`RollingResistance`] | resistances |
//! | [`Throw`] | how it starts |
//! | [`TopMotion`] | the motion, with its events |
//! | [`Configuration`], [`Forces`] | what can be asked of a moment |
//!
//! The friction of the tip acts at the contact, whose arm from the centre of mass is
//! -(l e3 + r Z). So it leaves Jellett's integral alone, L . (l e3 + r Z), whatever its size
//! and whether the tip slides, creeps or rolls; drilling, rolling resistance and air do not.
//!
//! Not for: tips that jump (a run ends where the floor lets go); bodies without symmetry; the
//! fixed tip ([`rotation_dynamics::exact::heavy_top`]).
//!
//! Sources: J. H. Jellett, *A Treatise on the Theory of Friction* (1872); E. J. Routh,
//! *Advanced Rigid Dynamics*; the laws of friction at their types.

mod configuration;
mod friction;
mod motion;
mod top_motion;

pub use configuration::{Configuration, Forces, Powers};
pub use friction::{
    Drilling, Dry, Grip, NoSlip, Patch, ResistingMoment, RollingResistance, Smooth, TipFriction,
};
pub use motion::{ContactMode, Phase};
pub use top_motion::{Throw, TopMotion};

use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::Effect;
use rotation_dynamics::error::{Error, Result, finite, not_negative, positive};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::sincos;

/// A symmetric body that ends in a ball: SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shape {
    mass: f64,
    across: f64,
    axial: f64,
    lever: f64,
    tip: f64,
    rim: Option<[f64; 2]>,
}

impl Shape {
    /// A top with this mass (kg), and these moments of inertia across and along its axis about
    /// its centre of mass (kg m^2). It has this `lever` (m) from the centre of the ball up to the
    /// centre of mass (negative in a tippe top), and this radius of the `tip` (m).
    ///
    /// # Errors
    /// A mass or moment that is not positive, moments that break the triangle inequality, a
    /// tip radius below zero, an upright centre of mass that is not above the floor; numbers
    /// that are not finite.
    pub fn new(mass: f64, across: f64, axial: f64, lever: f64, tip: f64) -> Result<Self> {
        positive("mass", mass)?;
        PrincipalMoments::symmetric(across, axial)?;
        finite("lever", lever)?;
        not_negative("tip radius", tip)?;
        positive("lever + tip radius", lever + tip)?;
        Ok(Self { mass, across, axial, lever, tip, rim: None })
    }

    /// With a rim of this radius (m), so far (m) above the centre of mass: where it touches
    /// the floor, the top has fallen and the run ends.
    ///
    /// # Errors
    /// A radius that is not positive, a height that is not finite, a rim below the tip.
    pub fn with_rim(self, radius: f64, height: f64) -> Result<Self> {
        positive("rim radius", radius)?;
        finite("height of the rim", height)?;
        positive("height of the rim above the floor", self.lever + self.tip + height)?;
        Ok(Self { rim: Some([radius, height]), ..self })
    }

    /// Mass (kg).
    pub const fn mass(&self) -> f64 {
        self.mass
    }

    /// Moments of inertia about the centre of mass, across and along the axis (kg m^2).
    pub const fn moments(&self) -> [f64; 2] {
        [self.across, self.axial]
    }

    /// From the centre of the ball to the centre of mass (m).
    pub const fn lever(&self) -> f64 {
        self.lever
    }

    /// Radius of the tip (m).
    pub const fn tip(&self) -> f64 {
        self.tip
    }

    /// The height (m) of the rim's lowest point; of a body without a rim infinite.
    pub fn clearance(&self, axis: SpaceVector) -> f64 {
        let Some([radius, height]) = self.rim else {
            return f64::INFINITY;
        };
        let level = rotation_dynamics::math::hypot(axis.x(), axis.y());
        self.tip + (self.lever + height) * axis.z() - radius * level
    }
}

/// A top on a floor: its shape, the friction `F` of the floor, resistances `R` of the contact
/// and effects `E` on the body.
///
/// ```
/// use rotation_dynamics::effects::DiscDrag;
/// use models::tops::{ContactMode, Dry, Shape, Throw, Top};
/// # fn main() -> rotation_dynamics::Result<()> {
/// // 100 g, its centre of mass 4 cm above the centre of a ball of 5 mm.
/// let shape = Shape::new(0.1, 4e-5, 4e-5, 0.04, 0.005)?.with_rim(0.03, 0.0)?;
/// let air = DiscDrag::new(0.03, DiscDrag::AIR_DENSITY, DiscDrag::AIR_VISCOSITY, 150.0)?;
/// let top = Top::new(shape, 9.80665)?.on(Dry::new(0.05)?).in_effect(air)?;
/// let throw = Throw::spinning(0.3, 150.0).precessing(6.8);
/// let thrown = top.simulate(&throw, 3.0, 1e-10)?;
/// // It slides, rises, and grips.
/// let grips = thrown.event("grips")?;
/// assert!(grips.t > 0.7 && grips.t < 0.8);
/// assert_eq!(thrown.phase(2.9)?.contact, ContactMode::Rolling);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone)]
pub struct Top<F = Smooth, R = (), E = ()> {
    shape: Shape,
    body: RigidBody,
    gravity: SpaceVector,
    friction: F,
    resistance: R,
    effects: E,
    marks: Vec<Mark>,
}

/// The event that is waited for on the way.
#[derive(Debug, Clone, Copy)]
struct Mark {
    name: &'static str,
    margin: fn(&Configuration, f64) -> f64,
    value: f64,
}

impl Top {
    /// A top on a smooth level floor, under gravity of this size (m/s^2).
    ///
    /// # Errors
    /// A gravity that is not positive and finite.
    pub fn new(shape: Shape, gravity: f64) -> Result<Self> {
        positive("gravity", gravity)?;
        let body = RigidBody::new(PrincipalMoments::symmetric(shape.across, shape.axial)?);
        Ok(Self {
            shape,
            body,
            gravity: SpaceVector::new(0.0, 0.0, -gravity),
            friction: Smooth,
            resistance: (),
            effects: (),
            marks: Vec::new(),
        })
    }
}

impl<F: TipFriction, R: ResistingMoment, E: Effect> Top<F, R, E> {
    /// The same shape under the same gravity, with what rubs, resists and acts changed.
    fn changed<G, S, H>(self, change: impl FnOnce(F, R, E) -> (G, S, H)) -> Top<G, S, H> {
        let (friction, resistance, effects) = change(self.friction, self.resistance, self.effects);
        Top {
            shape: self.shape,
            body: self.body,
            gravity: self.gravity,
            friction,
            resistance,
            effects,
            marks: self.marks,
        }
    }

    /// The same on a floor that rubs so.
    pub fn on<G: TipFriction>(self, friction: G) -> Top<G, R, E> {
        self.changed(|_, resistance, effects| (friction, resistance, effects))
    }

    /// The same with one more resistance of the contact.
    pub fn resisted_by<S: ResistingMoment>(self, resistance: S) -> Top<F, (R, S), E> {
        self.changed(|friction, before, effects| (friction, (before, resistance), effects))
    }

    /// The same with one more effect on the body: a torque about its centre of mass.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for an effect that depends on the time, has break points or a
    /// potential of its own: none of them is looked at here.
    pub fn in_effect<G: Effect>(self, effect: G) -> Result<Top<F, R, (E, G)>> {
        let refused =
            G::PROPERTIES.on_time || G::PROPERTIES.slips || G::PROPERTIES.conserved.energy;
        let breaks = effect.break_points().len();
        if (refused && !G::PROPERTIES.torque_free) || breaks > 0 {
            return Err(Error::out_of_range(
                "effect's break points",
                breaks as f64,
                "an effect on a top is a torque that takes energy, without break \
                          points, and does not depend on the time",
            ));
        }
        Ok(self.changed(|friction, resistance, before| (friction, resistance, (before, effect))))
    }

    /// The same on a floor that falls off by this angle (rad) towards X. Z stays the normal of
    /// the floor.
    ///
    /// # Errors
    /// An angle that is not finite or not below 1 in size.
    pub fn sloping(self, angle: f64) -> Result<Self> {
        finite("slope", angle)?;
        if angle.abs() >= 1.0 {
            return Err(Error::out_of_range("slope", angle, "its size must be less than 1 rad"));
        }
        let (size, (s, c)) = (self.gravity.norm(), sincos(angle));
        let gravity = SpaceVector::new(size * s, 0.0, -size * c);
        Ok(Self { gravity, ..self })
    }

    /// The same, waiting for one more event: that `margin(stance, value)` falls through zero.
    /// Marks are waited for one after the other, in the order in which they are given.
    #[must_use]
    pub fn passing(
        mut self,
        name: &'static str,
        value: f64,
        margin: fn(&Configuration, f64) -> f64,
    ) -> Self {
        self.marks.push(Mark { name, margin, value });
        self
    }

    /// Its shape.
    pub const fn shape(&self) -> &Shape {
        &self.shape
    }

    /// Gravity on the axes of the floor (m/s^2).
    pub const fn gravity(&self) -> SpaceVector {
        self.gravity
    }
}
