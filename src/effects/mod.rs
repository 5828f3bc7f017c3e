//! Effects on the rotation of a body, one file per effect.
//!
//! An [`Effect`] says its torque once, from time, body and state. Its other claims (its
//! [`Properties`], its potential, the times at which it jumps) open faster roads, and all of it is
//! held against that torque by [`check`]. Effects are composed in the type: `()` is no effect, and
//! a pair of effects is an effect. An effect that a scene does not name is not stored, not called
//! and not asked about. An effect that a flag may leave out is an `Option`; effects that a file or
//! a form chooses go into an [`EffectList`].
//!
//! | effect | torque |
//! |---|---|
//! | [`GravityAtLever`] | the weight of a body held at a point of its axis |
//! | [`InternalDissipation`] | none: the axes drift at constant L, and energy is lost |
//! | [`ElasticYielding`] | none: the tensor of inertia follows the angular velocity |
//! | [`GravityGradient`] | an attracting body's on a satellite, near side against far side |
//! | [`OrbitingBody`] | the same of Sun, Moon or a planet, on a [`KeplerOrbit`], or its mean |
//! | [`Gravity`] | the weight of a body held at any point |
//! | [`ViscousFriction`] | friction in proportion to the rates |
//! | [`CoulombBearing`] | dry friction about the axis, until the spin stops |
//! | [`DiscDrag`] | the drag of still air on a disc that spins, laminar or turbulent |
//! | [`PrescribedTorque`] | a torque known as a function of time: a table, held, linear or cubic, or a pulse |
//! | [`Torque`] | what a closure says, on the fixed axes or on the body's |
//!
//! | for what engineers have in hand | take |
//! |---|---|
//! | a table of times | [`PrescribedTorque`] with [`Profile::steps`], [`Profile::lines`] or [`Profile::cubic`] |
//! | a law called at a rate, and held in between: a digital controller | [`Torque::sampled`] |
//! | a law with a largest torque, or that leaves small errors alone | [`Torque::saturated`], [`Torque::dead_band`] |
//! | one law or another, by the sign of a signal: a relay, a thruster, a brake | [`Switched`] |
//!
//! The last three rows are effects that go on in pieces, by a [`Law`]. Only
//! [`Scene::solve`](crate::scene::Scene::solve) and its kin hold what is held, and locate switches.
//! An integrator that is used by itself sees the torque as if it were sampled or switched just
//! there.
//!
//! Not for: contacts, which switch on and off ([`crate::planar`]).

mod check;
mod closure;
mod coulomb;
mod disc_drag;
mod elastic_yielding;
pub mod erased;
mod gravity;
mod gravity_anywhere;
mod gravity_gradient;
mod internal_dissipation;
mod kepler_orbit;
mod law;
mod limited;
mod list;
mod optional;
mod orbiting_body;
mod pair;
mod prescribed;
mod properties;
mod resistance;
mod sampled;
mod switched;
mod viscous;

pub use check::check;
pub(crate) use check::{Checked, NEAR, UNNAMED, is_same, piece};
pub use closure::Torque;
pub(crate) use closure::rising;
pub use coulomb::CoulombBearing;
pub use disc_drag::{DiscDrag, FlowRegime};
pub use elastic_yielding::ElasticYielding;
pub use gravity::GravityAtLever;
pub use gravity_anywhere::Gravity;
pub use gravity_gradient::GravityGradient;
pub use internal_dissipation::InternalDissipation;
pub use kepler_orbit::KeplerOrbit;
pub(crate) use law::{Held, Holding};
pub use law::{Law, Part};
pub use limited::Limited;
pub use list::{BoxedEffect, EffectList};
pub use orbiting_body::OrbitingBody;
pub use prescribed::{PrescribedTorque, Profile};
pub use properties::{Conserved, Feature, IntegrableCase, Properties};
pub use resistance::Resistance;
pub use sampled::SampledControl;
pub use switched::Switched;
pub use viscous::ViscousFriction;

use crate::attitude::Attitude;
use crate::body::{RigidBody, State};
use crate::error::Result;
use crate::frame::SpaceVector;
use crate::math::Lane;
use crate::math::lane::WIDEST;

/// Something that acts on a body.
///
/// An effect of your own needs its properties, its name and its torque. [`Properties::ANYTHING`]
/// claims nothing and is always true of an effect that has no potential. Every claim beyond it is
/// checked ([`check`]), at the start of a solution and along the way, and one that the torque
/// contradicts is refused.
///
/// ```
/// use rotation_dynamics::body::{RigidBody, State};
/// use rotation_dynamics::effects::{Effect, Properties};
/// use rotation_dynamics::frame::SpaceVector;
///
/// /// A brake that takes a part of the momentum every second.
/// struct Brake {
///     rate: f64,
/// }
///
/// impl Effect for Brake {
///     const PROPERTIES: Properties = Properties { on_time: false, smooth: true, ..Properties::ANYTHING };
///
///     fn name(&self) -> &'static str {
///         "brake"
///     }
///
///     fn torque(&self, _t: f64, _body: &RigidBody, state: &State) -> SpaceVector {
///         state.angular_momentum * -self.rate
///     }
/// }
/// # use rotation_dynamics::{attitude::Attitude, frame::BodyVector, inertia::PrincipalMoments};
/// # use rotation_dynamics::scene::Scene;
/// # fn main() -> rotation_dynamics::Result<()> {
/// let body = RigidBody::new(PrincipalMoments::new(1.0, 1.5, 0.8)?);
/// let start = body.state(Attitude::IDENTITY, BodyVector::new(0.3, 0.1, 2.0))?;
/// let braked = Scene::new(body).with(Brake { rate: 0.1 }).solve(&start, 10.0, 1e-8)?;
/// let left = braked.state.angular_momentum.norm() / start.angular_momentum.norm();
/// assert!((left - rotation_dynamics::math::exp(-1.0)).abs() < 1e-8);
/// # Ok(())
/// # }
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not an effect",
    label = "this acts on no body",
    note = "a list of effects is all that acts: `Scene::new(body).with_list(EffectList::new(list)?)`",
    note = "a closure becomes one by its name: `Torque::on_space(\"push\", |t, body, state| ..)`, or \
            `Torque::on_body` for a torque on the body's axes",
    note = "a type of your own is one by `impl Effect for ..`, with its properties, name and torque"
)]
pub trait Effect {
    /// The variables of the torque, and the quantities it leaves alone, whatever the state: true of
    /// every value of the type.
    const PROPERTIES: Properties;

    /// The name of the effect.
    fn name(&self) -> &'static str;

    /// The torque about the body's reference point, on the fixed axes (N m).
    ///
    /// A torque known on the body's axes is turned by
    /// [`Attitude::to_space`].
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector;

    /// The torque on bodies whose axes have these directions, side by side, with the same bits. It
    /// is asked for only of effects that see nothing but the axis ([`Properties::axis_only`]), and
    /// of those with a [`resistance`](Self::resistance), which leave it out here.
    ///
    /// This form asks for [`torque`](Self::torque) one after the other. An effect that
    /// writes its own, over [`Lane`] and marked `#[inline(always)]`, lets
    /// [`GaussLegendre`](crate::integrators::GaussLegendre) fill its registers, and takes
    /// its `torque` from it.
    #[inline(always)]
    fn torques_on_axis<L: Lane>(&self, body: &RigidBody, axis: [L; 3]) -> [L; 3] {
        one_by_one(self, body, axis)
    }

    /// The part of the torque that depends on the momentum, if at a fixed attitude it has a closed
    /// form, from the time `t` (s) to the next of the [`break_points`](Self::break_points). It must
    /// be the same at all times between two of them. All that is left of the torque is then what
    /// [`torques_on_axis`](Self::torques_on_axis) gives: nothing, or an effect that sees the axis
    /// only and is smooth. `None` makes no claim.
    fn resistance(&self, _t: f64, _body: &RigidBody) -> Option<Resistance> {
        let properties = Self::PROPERTIES;
        (properties.axis_only && properties.smooth).then_some(Resistance::NONE)
    }

    /// The angular velocity, on the fixed axes (rad/s), that the body's axes have beyond
    /// I^-1 L: of a body that is not quite rigid. Asked for only of effects whose properties
    /// says that they slip ([`Properties::slips`]).
    #[inline(always)]
    fn slip(&self, _t: f64, _body: &RigidBody, _state: &State) -> SpaceVector {
        SpaceVector::zero()
    }

    /// The potential energy U (J); 0 for an effect that has none. One that has a potential either
    /// claims that it [keeps the energy](Conserved::energy) or gives its own [`power`](Self::power).
    fn potential_energy(&self, _t: f64, _body: &RigidBody, _state: &State) -> f64 {
        0.0
    }

    /// The rate at which the effect changes kinetic plus potential energy (W): 0 for one
    /// that keeps the energy, torque . omega for one without a potential (and omega . (L x
    /// slip) for one that slips). An effect whose potential depends on the time gives its own.
    /// Where the body slips, too, through a potential, [`Scene::power`](crate::scene::Scene::power)
    /// adds what that makes.
    fn power(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        if Self::PROPERTIES.conserved.energy {
            return 0.0;
        }
        let omega = state.attitude.to_space(body.angular_velocity(state));
        let torque = self.torque(t, body, state);
        if Self::PROPERTIES.slips {
            let slip = self.slip(t, body, state);
            return (torque + state.angular_momentum.cross(&slip)).dot(&omega);
        }
        torque.dot(&omega)
    }

    /// A bound on the length of the torque (N m), or an estimate of its usual size: the
    /// scale against which errors of the momentum count. If not given, its length at the time
    /// `t` (s) and in this state, and then it claims nothing.
    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.torque(t, body, state).norm()
    }

    /// The dimensionless number by which it is judged whether a scene needs it: its
    /// [scale](Self::torque_scale) over |L| |omega|, the part of the momentum that it changes while the
    /// body turns by one radian; infinite at rest.
    fn number(&self, body: &RigidBody, state: &State) -> f64 {
        match self.torque_scale(0.0, body, state) {
            0.0 => 0.0,
            torque => {
                torque / (state.angular_momentum.norm() * body.angular_velocity(state).norm())
            }
        }
    }

    /// The size that its rounding is a part of (N m): the length of the torque; of several
    /// effects the sum of theirs, which may cancel.
    fn torque_size(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.torque(t, body, state).norm()
    }

    /// The times (s) at which the torque jumps or has a kink: solutions are cut there, and
    /// between them the effect is as smooth as its properties say.
    fn break_points(&self) -> Vec<f64> {
        Vec::new()
    }

    /// The narrowest feature of the torque that a solution must not step over, if that is
    /// known.
    fn narrowest(&self) -> Option<Feature> {
        None
    }

    /// The motion under this effect alone, if it is one of those with a closed form.
    fn integrable_case(&self) -> IntegrableCase {
        IntegrableCase::None
    }

    /// Whether the effect holds in a scene with this body and a start at the time `t` (s), in which
    /// the effects named in `about_axis` have a torque about the body's axis. An effect that takes
    /// something for granted says here that it is not so.
    ///
    /// # Errors
    /// The claim that is not so, with the numbers.
    fn holds_from(
        &self,
        _t: f64,
        _body: &RigidBody,
        _start: &State,
        _about_axis: &[&'static str],
    ) -> Result<()> {
        Ok(())
    }

    /// The names of those that may have a torque about the body's axis.
    fn about_axis(&self) -> Vec<&'static str> {
        if Self::PROPERTIES.conserved.axial_momentum { Vec::new() } else { vec![self.name()] }
    }

    /// The effects that this one is made of, and which of them go on in pieces by a [`Law`]: itself,
    /// without a law.
    fn parts(&self) -> Vec<Part<'_>>
    where
        Self: Sized,
    {
        vec![Part::without_law(self)]
    }

    /// The names of the effects that this one is made of.
    fn names(&self) -> Vec<&'static str> {
        vec![self.name()]
    }
}

/// [`Effect::torque`] for several axes, one after the other.
#[inline(always)]
pub(crate) fn one_by_one<E: Effect + ?Sized, L: Lane>(
    effect: &E,
    body: &RigidBody,
    axis: [L; 3],
) -> [L; 3] {
    each(axis, |axis| {
        let state = State { attitude: with_axis(axis), angular_momentum: SpaceVector::zero() };
        effect.torque(0.0, body, &state).to_array()
    })
}

/// A torque for several axes, one after the other.
#[inline(always)]
pub(crate) fn each<L: Lane>(axis: [L; 3], torque: impl Fn([f64; 3]) -> [f64; 3]) -> [L; 3] {
    let (mut from, mut to) = ([[0.0; WIDEST]; 3], [[0.0; WIDEST]; 3]);
    for i in 0..3 {
        axis[i].store(&mut from[i]);
    }
    for lane in 0..L::WIDTH {
        let torque = torque([from[0][lane], from[1][lane], from[2][lane]]);
        for i in 0..3 {
            to[i][lane] = torque[i];
        }
    }
    [L::load(&to[0]), L::load(&to[1]), L::load(&to[2])]
}

/// An attitude whose axis e3 has this direction.
fn with_axis([x, y, z]: [f64; 3]) -> Attitude {
    // The shortest turn from Z, or for a direction below the equator from -Z.
    let length = (x * x + y * y + z * z).sqrt();
    let (x, y, z) = (x / length, y / length, z / length);
    let q = if z >= 0.0 {
        let w = (0.5 * (1.0 + z)).sqrt();
        [w, -0.5 * y / w, 0.5 * x / w, 0.0]
    } else {
        let s = (0.5 * (1.0 - z)).sqrt();
        [0.5 * x / s, 0.0, s, 0.5 * y / s]
    };
    Attitude::from_unit(q)
}
