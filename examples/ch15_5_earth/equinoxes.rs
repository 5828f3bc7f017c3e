//! The precession of the equinoxes: the torque of Sun and Moon on the bulge.

use super::*;
use rotation_dynamics::accuracy::Limits;
use rotation_dynamics::body::State;
use rotation_dynamics::effects::GravityGradient;

/// One second of arc, rad.
pub const ARCSEC: f64 = PI / 648_000.0;
/// A Julian year, d, in which rates of precession are given.
pub const YEAR: f64 = 365.25;
/// The sidereal day of the Earth, s.
const SIDEREAL_DAY: f64 = 86_164.090_5;
/// The tilt of the equator to the Earth's orbit at J2000, 84381.448 arcsec (IAU 1976).
pub const OBLIQUITY: f64 = 84_381.448 * ARCSEC;

/// A body on a circle in the plane of the Earth's orbit.
pub struct Attractor {
    /// its sidereal period, d
    pub period: f64,
    /// its mass over that of itself and the Earth together
    pub mass: f64,
}

pub const SUN: Attractor = Attractor { period: 365.256_363, mass: 1.0 };
pub const MOON: Attractor = Attractor { period: 27.321_661, mass: 0.012_150_5 };

impl Attractor {
    /// sqrt(G m/r^3) of what attracts: the mean motion if it has all of the mass, 1/s.
    pub fn mean_motion(&self) -> f64 {
        TAU / (self.period * DAY) * self.mass.sqrt()
    }

    /// The rate at which the equinox goes round for this flattening, rad/s, the Earth turning once
    /// in a sidereal day of 86164.0905 s.
    pub fn rate(&self, flattening: f64) -> f64 {
        let (n, h) = (self.mean_motion(), flattening / (1.0 + flattening));
        -1.5 * n * n / (TAU / SIDEREAL_DAY) * h * cos(OBLIQUITY)
    }

    /// The same from the torque 3 n^2 r x I r, averaged over a circle of directions r.
    fn averaged(&self, p: &Parameters) -> f64 {
        let (s, c) = sincos(OBLIQUITY);
        let axis = SpaceVector::new(0.0, -s, c);
        let mut torque = SpaceVector::zero();
        for k in 0..12 {
            let (y, x) = sincos(TAU * f64::from(k) / 12.0);
            let r = SpaceVector::new(x, y, 0.0);
            // I r = A r + (C - A)(e r) e; r x r is nothing.
            torque += r.cross(&axis) * ((p.c - p.a) * axis.dot(&r) / 12.0);
        }
        // The torque turns L = C Omega e about Z.
        let n = self.mean_motion();
        3.0 * n * n * torque.x() / (p.c * spin(p) * s)
    }
}

// ANCHOR: sun
/// The Earth for a year under the Sun's torque: by how much its axis has gone round at these
/// times (s), rad, and how far its tilt has changed.
pub fn year(p: &Parameters, times: &[f64], tolerance: f64) -> Result<Vec<[f64; 2]>> {
    let body = RigidBody::new(PrincipalMoments::symmetric(p.a, p.c)?);
    let normal = SpaceVector::new(0.0, 0.0, 1.0);
    let equinox = SpaceVector::new(1.0, 0.0, 0.0);
    let sun = GravityGradient::on_orbit(SUN.mean_motion(), normal, equinox)?;
    let tilted = Attitude::about_space_axis(equinox, OBLIQUITY)?;
    let start = body.state(tilted, BodyVector::new(0.0, 0.0, spin(p)))?;
    let scene = Scene::new(body).with(sun);
    let states = scene.solve_at(&start, times, tolerance, &Limits::default())?;
    let moved = |state: &State| {
        let l = state.angular_momentum;
        let flat = hypot(l.x(), l.y());
        [atan2(l.x(), -l.y()), atan2(flat, l.z()) - OBLIQUITY]
    };
    Ok(states.iter().map(moved).collect())
}
// ANCHOR_END: sun

/// The precession that goes with the Sun's place on its circle besides the mean one of this rate: what
/// the torque, which is greatest at the solstices, has over its mean, rad.
pub fn ripple(rate: f64, t: f64) -> f64 {
    let n = SUN.mean_motion();
    -rate / (2.0 * n) * sin(2.0 * n * t)
}

pub fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let f = flattening(p)?;
    // The formula has the sidereal day of the Earth; another day scales it.
    let other = p.day / SIDEREAL_DAY;
    let yearly = |rate: f64| rate * YEAR * DAY / ARCSEC;
    let [sun, moon] = [SUN, MOON].map(|body| yearly(body.rate(f) * other));
    let [by_sun, by_moon] = [SUN, MOON].map(|body| yearly(body.averaged(p)));
    let round = |rate: f64| TAU / ARCSEC / rate.abs();
    claims! { report,
        /// precession of the equinoxes by the Sun, a year
        sun: sun, "arcsec", "torque averaged over the orbit" => by_sun, within 1e-11, in "The precession of the equinoxes":
            2.0 * sun => "the mean of a square of a cosine is one half";
        /// by the Moon
        moon: moon, "arcsec", "torque averaged over the orbit" => by_moon, within 1e-11, in "The precession of the equinoxes":
            moon / MOON.mass => "the Moon has an 81st of the Earth's mass";
        /// one round of the equinoxes
        great_year: round(sun + moon), "a", "torque averaged over the orbit" => round(by_sun + by_moon), within 1e-8,
        in "The precession of the equinoxes":
            round(sun) => "the Moon does two thirds of it";
    }
}
