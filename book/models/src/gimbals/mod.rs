//! A heavy rotor in gimbals that have inertia, and friction in their bearings.
//!
//! The rotor spins in a *ring* (or yoke), the ring tilts in a *fork*, and the fork turns about
//! the vertical. A mass that turns with phi alone is no torque on the rotor, so it is no
//! [`effect`](rotation_dynamics::effects): it changes the equations. They keep their two momenta and their
//! energy, but the cubic of the heavy top becomes a polynomial of the seventh degree, and the
//! closed form a quadrature.
//!
//! | item | what it is |
//! |---|---|
//! | [`Gimbals`], [`Pose`] | the moments of inertia, and a state |
//! | [`NutationCycle`] | one nod without friction: turning points, period, advances, by quadrature |
//! | [`Bearing`], [`Bearings`] | viscous and dry friction of the three bearings, and the air |
//! | [`GimbalMotion`] | a motion with friction, every stop and reversal of a bearing located |
//! | [`Decay`] | what friction does by theory: decay of the nods, sag of the axis |
//!
//! Coordinates are the notes' Euler angles. The tilt theta belongs to the mechanism and not only to
//! the axis: it may pass 0 and become negative, for with a fork there is no pole.
//!
//! Not for: rotors that are not symmetric, gimbals that bend, and play in the bearings. A top
//! without gimbals is known in closed form, [`rotation_dynamics::exact::heavy_top`].
//!
//! Sources: K. Magnus, *Kreisel: Theorie und Anwendungen* (1971), on the gyroscope in gimbals;
//! R. N. Arnold, L. Maunder, *Gyrodynamics and its Engineering Applications* (1961).

mod bearings;
mod decay;
mod motion;
mod nutation;

pub use bearings::{Bearing, Bearings, Hold, Holds};
pub use decay::Decay;
pub use motion::{Change, GimbalMotion};
pub use nutation::NutationCycle;

use rotation_dynamics::error::{Error, Result, finite, not_negative};
use rotation_dynamics::exact::heavy_top::SymmetricTop;
use rotation_dynamics::inertia::InertiaTensor;
use rotation_dynamics::integrators::Ode;
use rotation_dynamics::math::{cos, sincos};

/// A heavy symmetric rotor in a ring, in a fork.
///
/// With the moments A, B, C of the ring about the line of nodes, across it and the axle, and
/// along the axle, and J of the fork about the vertical, the Lagrangian is
///
/// L = (1/2) P theta'^2 + (1/2) N(theta) phi'^2 + (1/2) I3 (zeta' + phi' cos theta)^2 - W cos theta,
///
/// P = I1 + A,  N = (I1 + B) sin^2 theta + C cos^2 theta + J,  W = m g l.
///
/// Kept are L_z = I3 (zeta' + phi' cos theta), L_Z = N phi' + L_z cos theta and the energy. In
/// N the fork and C do not vanish with sin theta: the body is no longer a symmetric top.
///
/// ```
/// use rotation_dynamics::exact::heavy_top::SymmetricTop;
/// use models::gimbals::{Gimbals, NutationCycle};
/// # fn main() -> rotation_dynamics::Result<()> {
/// let rotor = SymmetricTop::new(5.45e-3, 9.0e-4, 4.9, 0.1)?;
/// let bare = Gimbals::new(rotor, [0.0; 3], 0.0)?;
/// let held = Gimbals::new(rotor, [1.5e-4, 1.5e-4, 2e-5], 2e-4)?;
/// let [free, slow] = [bare, held].map(|g| NutationCycle::of(&g, &g.released(1.0, 314.0)));
/// // Gimbals make the nods slower and deeper, and leave the precession what it is.
/// let (free, slow) = (free?, slow?);
/// assert!(slow.period > 1.03 * free.period && slow.theta_max > free.theta_max);
/// assert!((slow.precession / slow.period) / (free.precession / free.period) - 1.0 < 1e-2);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gimbals {
    rotor: SymmetricTop,
    ring: [f64; 3],
    fork: f64,
}

/// Where a gyroscope in gimbals is and how it moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Tilt of the axis from the vertical, rad.
    pub theta: f64,
    /// Its rate, rad/s.
    pub theta_rate: f64,
    /// Azimuth of the line of nodes, rad.
    pub phi: f64,
    /// Its rate, rad/s.
    pub phi_rate: f64,
    /// Angle of the rotor in the ring, rad.
    pub zeta: f64,
    /// L_z = I3 (zeta' + phi' cos theta), kg m^2/s.
    pub axial_momentum: f64,
}

impl Pose {
    const fn of(&[theta, theta_rate, phi, phi_rate, zeta, axial_momentum]: &[f64; 6]) -> Self {
        Self { theta, theta_rate, phi, phi_rate, zeta, axial_momentum }
    }

    /// The six numbers, in the order of the fields: the state of the [`Ode`] that
    /// [`Gimbals`] is.
    pub const fn to_array(self) -> [f64; 6] {
        [self.theta, self.theta_rate, self.phi, self.phi_rate, self.zeta, self.axial_momentum]
    }

    /// The pose of these six numbers, the inverse of [`to_array`](Self::to_array).
    pub const fn from_array(numbers: [f64; 6]) -> Self {
        Self::of(&numbers)
    }

    fn check(&self) -> Result<()> {
        let names = ["theta", "theta'", "phi", "phi'", "zeta", "L_z"];
        let mut all = names.into_iter().zip(self.to_array());
        all.try_for_each(|(name, x)| finite(name, x).map(|_| ()))
    }
}

impl Gimbals {
    /// Gimbals that carry this `rotor`, whose moments are about the pivot. The `ring` has
    /// moments about the line of nodes, across it and the axle, and along the axle, and the `fork`
    /// has this moment about the vertical (kg m^2). Ring and fork balance about their own bearings:
    /// only the weight of the rotor counts.
    ///
    /// # Errors
    /// A moment that is negative or not finite; [`Error::NotABody`] for moments
    /// that no ring has (a rod and nothing are allowed).
    pub fn new(rotor: SymmetricTop, ring: [f64; 3], fork: f64) -> Result<Self> {
        for (name, moment) in [
            "moment of the ring about the line of nodes",
            "moment of the ring across the axle",
            "moment of the ring along the axle",
        ]
        .into_iter()
        .zip(ring)
        {
            not_negative(name, moment)?;
        }
        InertiaTensor::diagonal(ring)?;
        not_negative("moment of the fork", fork)?;
        Ok(Self { rotor, ring, fork })
    }

    /// The rotor.
    pub const fn rotor(&self) -> &SymmetricTop {
        &self.rotor
    }

    /// m g l, N m.
    pub fn weight_moment(&self) -> f64 {
        self.rotor.weight() * self.rotor.lever()
    }

    /// P = I1 + A: the inertia of a nod, kg m^2.
    pub fn tilting(&self) -> f64 {
        self.rotor.i1() + self.ring[0]
    }

    /// N(theta): the inertia about the vertical beside the spin, kg m^2.
    pub fn turning(&self, theta: f64) -> f64 {
        let (s, c) = sincos(theta);
        (self.rotor.i1() + self.ring[1]) * s * s + self.ring[2] * c * c + self.fork
    }

    /// D = I1 + B - C: N = N(0) + D sin^2 theta.
    fn excess(&self) -> f64 {
        self.rotor.i1() + self.ring[1] - self.ring[2]
    }

    /// dN/dtheta.
    fn turning_slope(&self, (s, c): (f64, f64)) -> f64 {
        2.0 * self.excess() * s * c
    }

    /// The axis released at rest at the tilt `theta` (rad), the rotor spinning at `spin`
    /// (rad/s).
    pub fn released(&self, theta: f64, spin: f64) -> Pose {
        Pose {
            theta,
            theta_rate: 0.0,
            phi: 0.0,
            phi_rate: 0.0,
            zeta: 0.0,
            axial_momentum: self.rotor.i3() * spin,
        }
    }

    /// L_Z = N phi' + L_z cos theta, kg m^2/s: kept without friction.
    pub fn vertical_momentum(&self, at: &Pose) -> f64 {
        self.turning(at.theta) * at.phi_rate + at.axial_momentum * cos(at.theta)
    }

    /// Energy less the energy of the rotor's own spin, L_z^2/(2 I3), J: the energy of nod,
    /// precession and weight. Kept without friction.
    pub fn axis_energy(&self, at: &Pose) -> f64 {
        0.5 * (self.tilting() * at.theta_rate * at.theta_rate
            + self.turning(at.theta) * at.phi_rate * at.phi_rate)
            + self.weight_moment() * cos(at.theta)
    }

    /// L_z^2/(2 I3), J: the energy of the spin.
    pub fn spin_energy(&self, at: &Pose) -> f64 {
        0.5 * at.axial_momentum * at.axial_momentum / self.rotor.i3()
    }

    /// The effective potential V = (L_Z - L_z cos theta)^2/(2 N) + W cos theta, J, in which
    /// the tilt moves like a ball of inertia P.
    pub fn effective_potential(&self, theta: f64, [vertical, axial]: [f64; 2]) -> f64 {
        let c = cos(theta);
        let walk = vertical - axial * c;
        0.5 * walk * walk / self.turning(theta) + self.weight_moment() * c
    }

    /// The slow steady precession at `theta` (rad) with L_z = `axial` (kg m^2/s), rad/s, if a
    /// torque `held` (N m) about the line of nodes takes over a part of the weight's. It is the
    /// root of D sin theta cos theta W'^2 - L_z sin theta W' + (W sin theta - held) = 0 that needs
    /// the weight. Fork and A are not in it.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the rotor is too slow to be held there.
    pub fn steady_rate(&self, theta: f64, axial: f64, held: f64) -> Result<f64> {
        let (s, c) = sincos(theta);
        let torque = self.weight_moment() * s - held;
        let (b, four) = (axial * s, 4.0 * self.excess() * s * c * torque);
        let square = b * b;
        if !(square >= four && square > 0.0) {
            return Err(Error::out_of_range(
                "L_z^2/(4 D m g l cos(theta))",
                square / four,
                "1 or more: slower, the weight lets the axis fall",
            ));
        }
        Ok(2.0 * torque / (b + b.signum() * (square - four).sqrt()))
    }

    /// The angular frequency of small nods about a steady precession at `theta` (rad) with
    /// L_z = `axial` (kg m^2/s) and the rate `precession` (rad/s), rad/s:
    ///
    /// P omega^2 = V'' = g^2/N + k,  g = L_z sin theta - phi' N',
    /// k = L_z phi' cos theta - (1/2) phi'^2 N'' - W cos theta.
    ///
    /// A fast rotor's is L_z sin theta/sqrt(P N). Imaginary frequencies come out as NaN.
    /// Accuracy, as measured on swings of 1e-4 rad: 1.1e-12.
    pub fn nodding(&self, theta: f64, axial: f64, precession: f64) -> f64 {
        let [g, k] = self.stiffness(theta, axial, precession);
        ((g * g / self.turning(theta) + k) / self.tilting()).sqrt()
    }

    /// g and k of [`nodding`](Self::nodding).
    fn stiffness(&self, theta: f64, axial: f64, precession: f64) -> [f64; 2] {
        let (s, c) = sincos(theta);
        let bend = 2.0 * self.excess() * (c * c - s * s);
        [
            axial * s - precession * self.turning_slope((s, c)),
            axial * precession * c
                - 0.5 * precession * precession * bend
                - self.weight_moment() * c,
        ]
    }

    /// Generalised forces of inertia and weight: the values of P theta'' and N phi'' without
    /// friction.
    fn driven(&self, at: &Pose) -> [f64; 2] {
        let (s, c) = sincos(at.theta);
        let (slope, spin) = (self.turning_slope((s, c)), at.axial_momentum * s);
        [
            self.weight_moment() * s + at.phi_rate * (0.5 * at.phi_rate * slope - spin),
            at.theta_rate * (spin - slope * at.phi_rate),
        ]
    }

    /// zeta' = L_z/I3 - phi' cos theta: the rate of the rotor in the ring, rad/s.
    pub fn spin_in_ring(&self, at: &Pose) -> f64 {
        at.axial_momentum / self.rotor.i3() - at.phi_rate * cos(at.theta)
    }

    /// The sizes against which errors count, of the six numbers of a pose.
    fn sizes(&self, y: &[f64; 6]) -> [f64; 6] {
        let axial = y[5].abs().max(1e-300);
        let rate = axial / (self.tilting() * self.turning(1.0).max(self.turning(y[0]))).sqrt();
        [1.0, rate, y[2].abs().max(1.0), rate, y[4].abs().max(1.0), axial]
    }
}

/// Without friction; the state is a [`Pose`] as six numbers.
///
/// P theta'' = W sin theta - L_z phi' sin theta + (1/2) phi'^2 N',
/// N phi'' = L_z theta' sin theta - theta' phi' N',  L_z' = 0.
impl Ode<6> for Gimbals {
    fn derivative(&self, _t: f64, y: &[f64; 6]) -> [f64; 6] {
        let at = Pose::of(y);
        let [tilt, azimuth] = self.driven(&at);
        [
            at.theta_rate,
            tilt / self.tilting(),
            at.phi_rate,
            azimuth / self.turning(at.theta),
            self.spin_in_ring(&at),
            0.0,
        ]
    }

    fn scale(&self, y: &[f64; 6]) -> [f64; 6] {
        self.sizes(y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With the axis level the precession is m g l/L_z, whatever ring and fork weigh.
    #[test]
    fn a_level_axis_precesses_by_the_weight_moment() {
        let rotor = SymmetricTop::new(5.45e-3, 9.0e-4, 4.9, 0.1).expect("a rotor");
        for fork in [0.0, 2e-4] {
            let gimbals = Gimbals::new(rotor, [1.5e-4, 1.5e-4, 2e-5], fork).expect("gimbals");
            let level = core::f64::consts::FRAC_PI_2;
            let rate = gimbals.steady_rate(level, 0.3, 0.0).expect("a precession");
            assert!((rate / (4.9 * 0.1 / 0.3) - 1.0).abs() < 1e-14, "{rate}");
        }
    }
}
