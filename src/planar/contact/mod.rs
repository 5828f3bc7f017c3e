//! Several contacts with dry friction: which of them push, stick, slip or let go.
//!
//! A [`Mechanism`] says its mass matrix, its forces and its [`Contact`]s: the gap of each, its
//! friction, its restitution. At each time a contact is in one [`Mode`]. The solver finds
//! the modes by trying all of them. The motion that a set of modes gives must agree with its
//! claims: normal forces push, friction holds within its cone or opposes the slip, open gaps do not
//! close. Where a mode stops agreeing is an event, located by real steps like every event of
//! [`planar`](super). The drift of a step off the contacts that act is put back at its end, by
//! least action on the masses.
//!
//! | item | what it is |
//! |---|---|
//! | [`Mechanism`], [`MechanismState`] | masses, forces, contacts; coordinates and velocities |
//! | [`Contact`], [`Friction`], [`Surface`] | one contact at one instant |
//! | [`Mode`], [`Sense`] | open, smooth, stick, slip |
//! | [`motion`], [`motion_within`], [`ContactMotion`] | the motion, its events, the forces at any time |
//! | [`motion_so_far`] | the motion up to where it is refused |
//! | [`Contact::rolling`] | rolling resistance, which rides on a contact |
//! | [`QuadraticDrag`], [`LinearDrag`] and of spin, [`Load`], [`With`] | what a mechanism may feel in addition |
//! | [`Coordinates`], [`Solvable`] | how many coordinates a mechanism may have |
//! | [`misdeclared`] | whether the rows of the contacts are those of their gaps |
//! | [`Modal`], [`entry`] | the same as a [`Phased`](super::Phased) scene, with the phase it starts in |
//!
//! Laws: a normal force N >= 0 where the gap is shut, none where it is open (Signorini);
//! |T| <= mu N, with T against the slip where there is one (Coulomb); at an impact the same
//! laws between impulses, and normal velocities reversed times the restitution (Newton).
//! A solution need not exist and need not be the only one (Painlevé): either is an error that
//! carries the state.
//!
//! Not for: many contacts ([`MOST_CONTACTS`]), and bodies that deform. Where forces are not determined
//! (a box on three feet) the motion still is, and one of the possible sets of forces is given.
//!
//! The equations, and when they have no answer or two: `book/src/how_contacts.md`.
//!
//! Source: F. Pfeiffer, C. Glocker, *Multibody Dynamics with Unilateral Contacts* (1996), 5 and 8.

mod declare;
mod declared;
mod drag;
mod linear;
mod modal;
mod motion;
mod resolve;
mod response;

pub use declare::{Contact, Friction, MechanismState, Mode, Row, Sense, Surface};
pub use declared::misdeclared;
pub use drag::{LinearDrag, LinearSpinDrag, Load, QuadraticDrag, QuadraticSpinDrag, With};
pub use modal::{Modal, entry};
pub use motion::{
    ContactEvent, ContactMotion, Coordinates, Solvable, kept_within, motion, motion_so_far,
    motion_within,
};
pub use response::Force;

/// The most contacts that one mechanism may have: all sets of their modes are tried.
pub const MOST_CONTACTS: usize = 4;

/// The mode of each contact.
pub type Modes<const C: usize> = [Mode; C];

/// Bodies with `N` coordinates and `C` contacts.
///
/// ```
/// use rotation_dynamics::planar::contact::{Contact, Mechanism, MechanismState, Surface, motion_within};
///
/// /// A ball of radius 0.1 m that is set down spinning: m = 1, I = (2/5) m R^2, mu = 0.2.
/// struct Ball;
/// impl Mechanism<3, 1> for Ball {
///     fn mass(&self, _: &[f64; 3]) -> [[f64; 3]; 3] {
///         [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.004]]
///     }
///     fn force(&self, _: &MechanismState<3>) -> [f64; 3] {
///         [0.0, -9.81, 0.0]
///     }
///     fn contacts(&self, ball: &MechanismState<3>) -> [Contact<3>; 1] {
///         [Contact::rim("floor", ball, 0.1, Surface::FLOOR).friction(0.2)]
///     }
/// }
/// # fn main() -> rotation_dynamics::Result<()> {
/// let start = MechanismState { q: [0.0, 0.1, 0.0], v: [0.0, 0.0, -70.0] };
/// let motion = motion_within(&Ball, 1e-12, start, 2.0)?;
/// // It slips until (2/7) R Omega / (mu g), then rolls at (2/7) R Omega.
/// let rolls = motion.event("floor sticks")?;
/// assert!((rolls.t - 2.0 / (0.2 * 9.81)).abs() < 1e-12);
/// assert!((motion.at(2.0)?.v[0] - 2.0).abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
pub trait Mechanism<const N: usize, const C: usize> {
    /// The mass matrix M(q), symmetric and positive definite: another matrix is refused at the
    /// start and wherever the modes change.
    fn mass(&self, q: &[f64; N]) -> [[f64; N]; N];

    /// The generalized forces f in M(q) q'' = f + contacts, with the velocity terms of the
    /// left side brought over.
    fn force(&self, state: &MechanismState<N>) -> [f64; N];

    /// The contacts in this state, always in the same order.
    fn contacts(&self, state: &MechanismState<N>) -> [Contact<N>; C];

    /// The end of the scene: a name, and a margin that is positive until then.
    fn end(&self, _state: &MechanismState<N>) -> Option<(&'static str, f64)> {
        None
    }

    /// The same mechanism with one more force, such as a [`QuadraticDrag`].
    fn with<F: Load<N>>(self, load: F) -> With<Self, F>
    where
        Self: Sized,
    {
        With::new(self, load)
    }

    /// The size against which errors count, as [`super::Phased::scale`]: coordinates first.
    ///
    /// A gap or a speed smaller than 1e-12 of what this makes of it is none. The default written
    /// here takes 1 for the least size of each. A mechanism whose lengths or speeds are far from 1
    /// in its units says its own sizes. With these defaults, gaps of 1e-13 all count as shut and
    /// speeds of 1e-13 as 0, and no error tells; a length of 1e5 cannot be held to 1e-12 of 1. The
    /// equations want lengths from 1e-6 to 1e6 in any case; of masses only ratios count.
    fn scale(&self, state: &MechanismState<N>) -> MechanismState<N> {
        let size = |c: f64| c.abs().max(1.0);
        MechanismState { q: state.q.map(size), v: state.v.map(size) }
    }

    /// After how many changes of its modes a run is refused. A bounce is one: a fall from 1 m with
    /// the restitution 0.99 makes 1,400 of them before the others are summed.
    fn phase_limit(&self) -> usize {
        1000
    }
}

impl<M: Mechanism<N, C> + ?Sized, const N: usize, const C: usize> Mechanism<N, C> for &M {
    fn mass(&self, q: &[f64; N]) -> [[f64; N]; N] {
        (**self).mass(q)
    }
    fn force(&self, state: &MechanismState<N>) -> [f64; N] {
        (**self).force(state)
    }
    fn contacts(&self, state: &MechanismState<N>) -> [Contact<N>; C] {
        (**self).contacts(state)
    }
    fn end(&self, state: &MechanismState<N>) -> Option<(&'static str, f64)> {
        (**self).end(state)
    }
    fn scale(&self, state: &MechanismState<N>) -> MechanismState<N> {
        (**self).scale(state)
    }
    fn phase_limit(&self) -> usize {
        (**self).phase_limit()
    }
}
