//! A heavy symmetric top on its pages: a motion, its numbers by three routes, its figures.
//!
//! Not for: the closed form itself ([`rotation_dynamics::exact::heavy_top`]).

mod claims;
mod falling;
mod moving;
mod pictures;
mod routes;
pub mod stand;
mod steady;
mod stepped;
mod strip;

pub use moving::Pose;
pub use pictures::{direction, extents};
pub use routes::{Equations, Newton, Nod};
pub use steady::Steady;
pub use stepped::{Added, Stepped};
pub use strip::Gravity;

use kit::{Trajectory, decimals, times};
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Regime, Start};
use rotation_dynamics::math::sin;
use rotation_dynamics::{Error, Result};

/// A motion of a top whose axis spins, with its closed form.
///
/// ```
/// use rotation_dynamics::exact::heavy_top::{ReducedTop, Start};
/// use kit::Report;
/// use models::heavy_top::{Equations, Motion};
/// let top = ReducedTop::new(2.0, 0.6, 0.2)?;
/// let cusps = Motion::with_energy("cusps", top, -0.08, Start::ThetaMin)?;
/// let mut report = Report::new("A top", cusps.description())?;
/// report.add(cusps.claims(&Equations(top))?)?;
/// assert_eq!(report.claim("cusps_spin").map(|c| c.printed()), Some("3.141592653590".into()));
/// # Ok::<(), kit::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct Motion {
    /// Prefix of its keys and figures; empty for a motion asked for by flags.
    pub name: &'static str,
    /// Heading of its numbers in the answer box; empty if none is offered.
    pub group: &'static str,
    /// The closed form, in its own unit of time: t' or seconds.
    pub exact: HeavyTop,
    /// The notes' a, b, c.
    pub top: ReducedTop,
    /// The notes' E~.
    pub energy: f64,
    /// The unit of t' in the motion's own unit of time; below 0 with L_z.
    pub unit: f64,
    /// How far it is followed, in its own unit of time: 20 t', or 1 s.
    pub end: f64,
}

impl Motion {
    /// The motion `exact`, called `name`.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] without spin: then there is no t'.
    pub fn new(name: &'static str, exact: HeavyTop) -> Result<Self> {
        let (Some(top), Some(energy), Some(unit)) =
            (exact.reduced(), exact.energy_reduced(), exact.time_unit())
        else {
            return Err(Error::out_of_range(
                "L_z",
                exact.momenta().1,
                "the axis must spin: the notes' unit of time is sqrt(I1 I3)/L_z",
            ));
        };
        let end = if exact.body().is_some() { 1.0 } else { 20.0 };
        Ok(Self { name, group: "", exact, top, energy, unit, end })
    }

    /// The motion of this energy that starts at a turning point.
    ///
    /// # Errors
    /// As [`HeavyTop::from_energy`].
    pub fn with_energy(
        name: &'static str,
        top: ReducedTop,
        energy: f64,
        start: Start,
    ) -> Result<Self> {
        Self::new(name, HeavyTop::from_energy(top, energy, start, 0.0, 0.0)?)
    }

    /// The motion that starts at the tilt `theta` (rad), at rest in theta.
    ///
    /// # Errors
    /// As [`HeavyTop::from_angles`].
    pub fn at_rest_in_theta(name: &'static str, top: ReducedTop, theta: f64) -> Result<Self> {
        Self::new(name, HeavyTop::from_angles(top, theta, 0.0, 0.0, 0.0)?)
    }

    /// Offers its turning points, period and advance in the answer box, under this heading.
    #[must_use]
    pub fn answers(mut self, group: &'static str) -> Self {
        self.group = group;
        self
    }

    /// Whether its time is in seconds, not in t'.
    pub(crate) fn in_seconds(&self) -> bool {
        self.exact.body().is_some()
    }

    /// The regime in a word, and the numbers that fix the motion.
    pub fn description(&self) -> String {
        let numbers = [self.top.a(), self.top.b(), self.top.c(), self.energy];
        let [a, b, c, energy] = numbers.map(|number| decimals(number, 6));
        format!(
            "a symmetric rotor about a fixed point: {}; a = {a}, b = {b}, c = {c}, E~ = {energy}",
            self.regime()
        )
    }

    /// The regime in words.
    pub(crate) fn regime(&self) -> &'static str {
        match self.exact.regime() {
            Regime::Steady => "steady precession",
            Regime::Waves => "precession with waves",
            Regime::Cusps => "precession with cusps",
            Regime::Loops => "precession with loops",
            Regime::Sleeping => "sleeping upright",
            Regime::Homoclinic => "leaving the vertical and returning to it in infinite time",
            Regime::Planar => "a swing in a plane",
            _ => "through the vertical",
        }
    }

    /// Whether phi and zeta are of use: far enough from both poles for equations (5)
    /// and (6), which divide by sin^2(theta).
    pub(crate) fn clear_of_poles(&self) -> bool {
        let regular = matches!(
            self.exact.regime(),
            Regime::Steady | Regime::Waves | Regime::Cusps | Regime::Loops
        );
        regular && sin(self.exact.theta_min()).min(sin(self.exact.theta_max())) > 0.02
    }

    /// theta, dtheta/dt', phi and zeta at the start.
    pub fn start(&self) -> [f64; 4] {
        let angles = self.exact.angles(0.0);
        let nutation = self.exact.theta_rate(0.0) * self.unit;
        [angles.theta, nutation, angles.phi, angles.zeta]
    }

    /// The end in t'.
    pub(crate) fn end_reduced(&self) -> f64 {
        self.end / self.unit
    }

    /// `what` with the motion it belongs to: for keys and names of figures.
    fn key(&self, what: &str) -> String {
        if self.name.is_empty() { what.into() } else { format!("{}_{what}", self.name) }
    }
}

/// The motions in closed form: 200 samples over the run of each.
///
/// # Errors
/// None for sound motions.
pub fn trajectory(motions: &[Motion]) -> kit::Result<Trajectory> {
    let seconds = motions.iter().any(Motion::in_seconds);
    let mut table = Trajectory::new([
        "motion",
        if seconds { "t [s]" } else { "t'" },
        "theta [rad]",
        "phi [rad]",
        "zeta [rad]",
        "axis X",
        "axis Y",
        "axis Z",
    ])?;
    for (number, motion) in (1_u32..).zip(motions) {
        for t in times(0.0, motion.end, 200) {
            let angles = motion.exact.angles(t);
            let [x, y, z] = motion.exact.axis(t).to_array();
            table.push([f64::from(number), t, angles.theta, angles.phi, angles.zeta, x, y, z])?;
        }
    }
    Ok(table)
}
