//! The effect of friction on a fast gyroscope, by theory: how its nods die and its axis sags.

use super::{Bearings, Gimbals};
use rotation_dynamics::error::Result;
use rotation_dynamics::integrators::{Ode, ode};
use rotation_dynamics::math::sincos;

/// Decay and sag at one tilt and spin, without simulating anything.
///
/// Accuracy, as measured against simulations (`tests/exact/gimbals.rs`): the decay within 0.4 %
/// where the pivot alone damps (its sag changes the nods, too). The shortening is within 2e-4 at
/// 3000 rad/s, the sag over half a minute within 0.1 %.
///
/// With x = theta - theta_s and y = phi' - phi_s', small beside a steady precession, and the
/// coefficients c of the bearings,
///
/// P x'' = -k x - g y - c_theta x',  N y' = g x' - c_phi y
///
/// (g and k of [`Gimbals::nodding`]). The cubic of this system has a pair of roots
/// -decay +- i frequency: viscous friction of *either* bearing damps, nearly
/// decay = (c_theta/P + c_phi/N)/2.
///
/// Dry friction tau of the tilt bearing shifts the place of balance by tau/(P omega^2), to the
/// other side after each turning point. Each half nod is shorter than the last by 2 tau/(P omega^2)
/// on either side, and the last ends anywhere within tau/(P omega^2).
///
/// Friction about the vertical takes L_Z; the axis pays by sinking:
///
/// theta' = (-M_phi + M_zeta cos theta - (N phi' sin theta/g) L_z')/(g + N k/g),
///
/// nearly (tau_phi - tau_axle cos theta)/(L_z sin theta). Friction of the axle *raises* the axis, and
/// the air does neither: its L_z cos theta is what it takes of L_Z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Decay {
    /// The steady precession, rad/s.
    pub precession: f64,
    /// Angular frequency of the nods, with viscous friction, rad/s.
    pub frequency: f64,
    /// Rate at which viscous friction takes the nods, 1/s.
    pub decay: f64,
    /// By how much the dry tilt bearing shortens the swing to one side in half a nod, rad.
    pub shortening: f64,
    /// Rate at which the axis sinks, rad/s.
    pub sag: f64,
}

impl Decay {
    /// For these gimbals and bearings, at the tilt `theta` (rad) and L_z = `axial` (kg m^2/s).
    ///
    /// # Errors
    /// Those of [`Gimbals::steady_rate`].
    pub fn of(gimbals: &Gimbals, bearings: &Bearings, theta: f64, axial: f64) -> Result<Self> {
        let precession = gimbals.steady_rate(theta, axial, 0.0)?;
        let [g, k] = gimbals.stiffness(theta, axial, precession);
        let (p, n) = (gimbals.tilting(), gimbals.turning(theta));
        let [tilt, azimuth] = [bearings.tilt.viscous(), bearings.azimuth.viscous()];
        // lambda^3 + a lambda^2 + b lambda + c, by its small real root and the others' pair.
        let a = tilt / p + azimuth / n;
        let b = (k * n + g * g + tilt * azimuth) / (p * n);
        let c = k * azimuth / (p * n);
        let mut root = -c / b;
        for _ in 0..8 {
            let value = c + root * (b + root * (a + root));
            root -= value / (b + root * (2.0 * a + 3.0 * root));
        }
        let decay = 0.5 * (a + root);
        let square = b + root * (a + root) - decay * decay;
        let own = gimbals.nodding(theta, axial, precession);
        let [sag, ..] = drift(gimbals, bearings, theta, axial)?;
        Ok(Self {
            precession,
            frequency: square.sqrt(),
            decay,
            shortening: 2.0 * bearings.tilt.dry() / (p * own * own),
            sag,
        })
    }

    /// The slow motion alone, nods left out: tilt, azimuth and L_z.
    ///
    /// Where no steady precession is left the derivative is NaN, and a solver says so.
    pub fn slow(gimbals: Gimbals, bearings: Bearings) -> impl Ode<3> {
        ode(move |_t, &[theta, _, axial]: &[f64; 3]| {
            drift(&gimbals, &bearings, theta, axial).unwrap_or([f64::NAN; 3])
        })
        .scaled(|&[_, phi, axial]| [1.0, phi.abs().max(1.0), axial.abs().max(1e-300)])
    }
}

/// theta', phi' and L_z' of the slow motion.
fn drift(gimbals: &Gimbals, bearings: &Bearings, theta: f64, axial: f64) -> Result<[f64; 3]> {
    let (s, c) = sincos(theta);
    let i3 = gimbals.rotor().i3();
    let sinking = |held: f64| -> Result<[f64; 3]> {
        let rate = gimbals.steady_rate(theta, axial, held)?;
        let [g, k] = gimbals.stiffness(theta, axial, rate);
        let n = gimbals.turning(theta);
        let spin = axial / i3 - rate * c;
        let friction = |b: &super::Bearing, rate: f64| {
            let sense = if rate == 0.0 { 0.0 } else { rate.signum() };
            -b.viscous() * rate - b.dry() * sense
        };
        let (about, axle) = (friction(&bearings.azimuth, rate), friction(&bearings.axle, spin));
        let air = bearings.air.map_or(0.0, |air| air.axial_torque(axial / i3));
        let slowing = axle + air;
        let sinks = (axle * c - about - n * rate * s / g * slowing) / (g + n * k / g);
        Ok([sinks, rate, slowing])
    };
    // The dry tilt bearing holds a part of the weight while the axis sinks.
    let free = sinking(0.0)?;
    let dry = bearings.tilt.dry();
    if dry == 0.0 || free[0] == 0.0 {
        return Ok(free);
    }
    sinking(dry * free[0].signum())
}
