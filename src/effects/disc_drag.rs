//! The drag of still air on a disc that spins.

use super::{Effect, Feature, Properties, Resistance};
use crate::body::{RigidBody, State};
use crate::error::{Result, finite, positive};
use crate::frame::SpaceVector;
use crate::math::{Lane, pow};

/// How the air flows along the disc.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlowRegime {
    /// C_m = 3.87 Re^-1/2.
    Laminar,
    /// C_m = 0.146 Re^-1/5.
    Turbulent,
}

/// The drag of still air (or another fluid) on both faces of a disc that spins about e3.
///
/// The torque is (1/2) rho omega^2 R^5 C_m against omega = omega_3, with Re = omega R^2/nu and
///
/// - C_m = 3.87 Re^-1/2 where the flow is laminar, from Re of about 30 (below, it creeps, and
///   C_m is 64/(3 Re)) to 3e5: the torque goes with omega^1.5;
/// - C_m = 0.146 Re^-1/5 where it is turbulent, above 3e5: with omega^1.8.
///
/// Which of both holds is settled once, by the spin for which the effect is made; then the
/// law has no jump (at Re = 3e5 the turbulent one is 1.7 times the other). A motion
/// that leaves its range is for the user to notice, by [`reynolds`](Self::reynolds). Rim and shaft are
/// left out (a disc of thickness h: a part of 2 h/R), and so is the axis's own motion.
///
/// Neither power of omega is analytic at omega = 0, so the effect does not call itself smooth, and
/// solutions are stepped by DOP853 alone. A symmetric body is an exception: the drag never brings
/// its spin to 0. Number: [`number`](Self::number).
///
/// ```
/// use rotation_dynamics::effects::{DiscDrag, FlowRegime};
/// # fn main() -> rotation_dynamics::Result<()> {
/// // A rotor of 6 cm at 3000 rpm.
/// let spin = 314.16;
/// let drag = DiscDrag::new(0.06, DiscDrag::AIR_DENSITY, DiscDrag::AIR_VISCOSITY, spin)?;
/// assert_eq!(drag.regime(), FlowRegime::Laminar);
/// assert!((drag.reynolds(spin) - 7.49e4).abs() < 50.0);
/// assert!((drag.axial_torque(spin) + 6.53e-4).abs() < 1e-6);
/// # Ok(())
/// # }
/// ```
///
/// Source: T. von Kármán, ZAMM 1, 233 (1921); W. G. Cochran, Proc. Camb. Phil. Soc. 30, 365
/// (1934); H. Schlichting, *Boundary-Layer Theory*, on the rotating disc.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DiscDrag {
    radius: f64,
    viscosity: f64,
    regime: FlowRegime,
    /// The torque at 1 rad/s (N m).
    factor: f64,
}

impl DiscDrag {
    /// The density of air at 20 degrees and 1 atm, kg/m^3.
    pub const AIR_DENSITY: f64 = 1.204;

    /// The kinematic viscosity of air at 20 degrees and 1 atm, m^2/s.
    pub const AIR_VISCOSITY: f64 = 1.51e-5;

    /// The Reynolds number at which the flow becomes turbulent.
    const TRANSITION: f64 = 3e5;

    /// The drag on a disc of this radius (m) in a fluid of this density (kg/m^3) and
    /// kinematic viscosity (m^2/s), in the regime of this spin (rad/s).
    ///
    /// # Errors
    /// A radius, density or viscosity that is not positive and finite, a spin that is not
    /// finite, or products of them beyond `f64`.
    pub fn new(radius: f64, density: f64, viscosity: f64, spin: f64) -> Result<Self> {
        positive("radius", radius)?;
        positive("density", density)?;
        positive("kinematic viscosity", viscosity)?;
        finite("spin", spin)?;
        // Re at 1 rad/s.
        let unit = positive("Reynolds number at 1 rad/s", radius * radius / viscosity)?;
        let regime = regime(finite("Reynolds number", unit * spin.abs())?);
        let friction = match regime {
            FlowRegime::Laminar => 3.87 / unit.sqrt(),
            FlowRegime::Turbulent => 0.146 * pow(unit, -0.2),
        };
        let factor = 0.5 * density * pow(radius, 5.0) * friction;
        Ok(Self { radius, viscosity, regime, factor: finite("torque at 1 rad/s", factor)? })
    }

    /// The regime whose law this is.
    pub const fn regime(&self) -> FlowRegime {
        self.regime
    }

    /// The Reynolds number |omega| R^2/nu of this spin (rad/s).
    pub fn reynolds(&self, spin: f64) -> f64 {
        spin.abs() * self.radius * self.radius / self.viscosity
    }

    /// The torque about e3 (N m) at this spin (rad/s), against it.
    pub fn axial_torque(&self, spin: f64) -> f64 {
        let size = spin.abs();
        let power = match self.regime {
            FlowRegime::Laminar => size.sqrt(),
            FlowRegime::Turbulent => pow(size, 0.8),
        };
        -self.factor * power * spin
    }
}

impl DiscDrag {
    /// The power of |omega| that the torque has beside omega.
    const fn power(&self) -> f64 {
        match self.regime {
            FlowRegime::Laminar => 0.5,
            FlowRegime::Turbulent => 0.8,
        }
    }
}

fn regime(reynolds: f64) -> FlowRegime {
    if reynolds < DiscDrag::TRANSITION { FlowRegime::Laminar } else { FlowRegime::Turbulent }
}

impl Effect for DiscDrag {
    const PROPERTIES: Properties = Properties { on_time: false, ..Properties::ANYTHING };

    fn name(&self) -> &'static str {
        "disc drag"
    }

    #[inline]
    fn torque(&self, _t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        let spin = body.angular_velocity(state).z();
        state.attitude.axis() * self.axial_torque(spin)
    }

    #[inline(always)]
    fn torques_on_axis<L: Lane>(&self, _body: &RigidBody, _axis: [L; 3]) -> [L; 3] {
        [L::of(0.0); 3]
    }

    fn resistance(&self, _t: f64, body: &RigidBody) -> Option<Resistance> {
        Some(Resistance::power(self.factor, self.power(), body))
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(Feature::WIDE)
    }
}
