//! A Kepler orbit that is given: where an attracting body is at a time.

use crate::error::{Error, Result, finite, positive};
use crate::frame::SpaceVector;
use crate::math::{asinh, cbrt, fmod, latest, sin, sincos, sinh};
use core::f64::consts::{PI, TAU};

/// A Kepler orbit of any eccentricity: a circle, an ellipse, a parabola or a hyperbola.
///
/// ```text
/// r = q (1 + e)/(1 + e cos(f)),   r^2 f' = sqrt(G M q (1 + e)),
/// ```
///
/// with the pericentre distance q, the eccentricity e and the true anomaly f, which is 0 at
/// the passage of the pericentre. The plane is given by node, inclination and argument of
/// pericentre against the fixed axes X, Y, Z; node and argument may turn evenly, as the
/// Moon's do.
///
/// One equation serves all eccentricities. With alpha = 1 - e, time in sqrt(q^3/(G M)) from
/// the passage, and Goodyear's functions U_n(s) = s^n c_n(alpha s^2) of Stumpff's c_n,
///
/// ```text
/// tau = s + e U_3,   r/q = 1 + e U_2,   x/q = 1 - U_2,   y/q = sqrt(1 + e) U_1.
/// ```
///
/// The right side of the first grows and is convex, so that Newton's method, begun above
/// the root, comes down to it from any time and for any eccentricity.
///
/// ```
/// use rotation_dynamics::effects::KeplerOrbit;
/// # fn main() -> rotation_dynamics::Result<()> {
/// // The Sun about the Earth, closest at t = 0, in the direction X.
/// let (axis, year) = (1.495_978_707e11, 365.259_636 * 86_400.0);
/// let sun = KeplerOrbit::elliptic(axis, year, 0.016_708_6)?;
/// assert!((sun.place(0.0).x() / axis - 0.983_291_4).abs() < 1e-12);
/// assert!((sun.place(0.5 * year).norm() / axis - 1.016_708_6).abs() < 1e-12);
/// // A comet on a parabola: 90 degrees from its perihelion it is twice as far.
/// let comet = KeplerOrbit::about(1.327_124_400_18e20, 1.5e11, 1.0)?;
/// let quarter = 8.0_f64.sqrt() * 4.0 / 3.0 / 2.0 * (1.5e11_f64.powi(3) / 1.327_124_400_18e20).sqrt();
/// assert!((comet.place(quarter).norm() / 3e11 - 1.0).abs() < 1e-14);
/// # Ok(())
/// # }
/// ```
///
/// Source: R. H. Battin, *An Introduction to the Mathematics and Methods of Astrodynamics*
/// (1987), 4.5 and 4.6: the universal functions; W. H. Goodyear, Astron. J. 70, 189 (1965).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KeplerOrbit {
    eccentricity: f64,
    pericentre: f64,
    /// sqrt(G M/q^3), 1/s.
    rate: f64,
    /// s; infinite for an orbit that does not close.
    period: f64,
    /// When the pericentre is passed, s.
    passage: f64,
    node: f64,
    inclination: f64,
    argument: f64,
    /// Rates of node and argument, 1/s.
    turning: [f64; 2],
    /// The greatest |t| and |t - passage| at which the place is known, s.
    latest: [f64; 2],
    /// Unit vectors to the pericentre at t = 0, and along the motion there.
    axes: [SpaceVector; 2],
}

/// A place on an orbit.
pub(super) struct Place {
    /// Towards it: a unit vector.
    pub(super) direction: SpaceVector,
    /// How far it is, m.
    pub(super) distance: f64,
    /// Its velocity, with the turning of the orbit included, m/s.
    pub(super) velocity: SpaceVector,
}

impl KeplerOrbit {
    /// The closed orbit with this semi-major axis (m), period (s; from pericentre to
    /// pericentre) and eccentricity, from 0 to less than 1. It lies in the plane of X and Y,
    /// with the pericentre, passed at t = 0, along X.
    ///
    /// # Errors
    /// An axis or a period that is not positive and finite, an eccentricity outside its
    /// range, or rates that doubles do not hold.
    pub fn elliptic(semi_major_axis: f64, period: f64, eccentricity: f64) -> Result<Self> {
        positive("semi-major axis", semi_major_axis)?;
        positive("period", period)?;
        eccentric(eccentricity)?;
        if eccentricity >= 1.0 {
            return Err(Error::out_of_range(
                "eccentricity",
                eccentricity,
                "less than 1: other orbits have no period",
            ));
        }
        let alpha = 1.0 - eccentricity;
        let rate = TAU / period / (alpha * alpha.sqrt());
        Self::new(semi_major_axis * alpha, rate, period, eccentricity)
    }

    /// The orbit with this G M (m^3/s^2, of both bodies together), pericentre distance (m)
    /// and eccentricity, at least 0. It lies as [`elliptic`](Self::elliptic) says.
    ///
    /// # Errors
    /// As [`elliptic`](Self::elliptic), for any eccentricity that is not negative.
    pub fn about(gravitational_parameter: f64, pericentre: f64, eccentricity: f64) -> Result<Self> {
        positive("gravitational parameter", gravitational_parameter)?;
        positive("pericentre distance", pericentre)?;
        eccentric(eccentricity)?;
        let rate = (gravitational_parameter / pericentre).sqrt() / pericentre;
        let alpha = 1.0 - eccentricity;
        let period = if alpha > 0.0 { TAU / (rate * alpha * alpha.sqrt()) } else { f64::INFINITY };
        Self::new(pericentre, rate, period, eccentricity)
    }

    fn new(pericentre: f64, rate: f64, period: f64, eccentricity: f64) -> Result<Self> {
        positive("pericentre distance", pericentre)?;
        positive("rate at the pericentre", rate)?;
        finite("rate at the pericentre squared", rate * rate * (1.0 + eccentricity))?;
        if period != f64::INFINITY {
            positive("period", period)?;
        }
        let (x, y) = (SpaceVector::new(1.0, 0.0, 0.0), SpaceVector::new(0.0, 1.0, 0.0));
        Ok(Self {
            eccentricity,
            pericentre,
            rate,
            period,
            passage: 0.0,
            node: 0.0,
            inclination: 0.0,
            argument: 0.0,
            turning: [0.0; 2],
            latest: [f64::MAX; 2],
            axes: [x, y],
        }
        .known())
    }

    /// The same orbit with this node, inclination and argument of pericentre (rad), at t = 0:
    /// turned about Z by the argument, about X by the inclination, about Z by the node.
    ///
    /// From a satellite, with the elements of *its* orbit, one sees the attracting body on the
    /// other side: add pi to the argument.
    ///
    /// # Errors
    /// An angle that is not finite.
    pub fn oriented(self, node: f64, inclination: f64, argument: f64) -> Result<Self> {
        finite("node", node)?;
        finite("inclination", inclination)?;
        finite("argument of pericentre", argument)?;
        let axes = axes(node, inclination, argument);
        Ok(Self { node, inclination, argument, axes, ..self })
    }

    /// The same orbit with its pericentre passed at this time (s).
    ///
    /// # Errors
    /// A time that is not finite.
    pub fn passing_at(self, passage: f64) -> Result<Self> {
        finite("time of the passage", passage)?;
        Ok(Self { passage, ..self })
    }

    /// The same orbit with a node and an argument of pericentre that turn at these rates
    /// (rad/s; the Moon's node goes backward).
    ///
    /// # Errors
    /// A rate that is not finite.
    pub fn turning(self, node: f64, argument: f64) -> Result<Self> {
        finite("rate of the node", node)?;
        finite("rate of the argument of pericentre", argument)?;
        let turning = [node, argument];
        Ok(Self { turning, ..self }.known())
    }

    /// With the times up to which its phases are known ([how late](crate::exact#how-late)): for its
    /// turning, and on an orbit that closes for the passages, if it is not the first.
    fn known(self) -> Self {
        let [node, argument] = self.turning.map(f64::abs);
        let passages = latest(self.fastest()).max(0.5 * self.period);
        Self { latest: [latest(node + argument), passages.min(f64::MAX)], ..self }
    }

    fn is_known(&self, t: f64) -> bool {
        t.abs() <= self.latest[0] && (t - self.passage).abs() <= self.latest[1]
    }

    /// The eccentricity e.
    pub const fn eccentricity(&self) -> f64 {
        self.eccentricity
    }

    /// The pericentre distance q (m).
    pub const fn pericentre(&self) -> f64 {
        self.pericentre
    }

    /// The time (s) from pericentre to pericentre; infinite for an orbit that does not close.
    pub const fn period(&self) -> f64 {
        self.period
    }

    /// Where the body is at the time `t` (s), on the fixed axes (m). NaN, as its velocity, where
    /// the time is not finite or [so late](crate::exact#how-late) that the phase of an orbit that
    /// closes, or of its turning, is lost.
    ///
    /// Accuracy, as measured against 32 digits for eccentricities from 0 to 10, among them
    /// 1 - 1e-15 and 1 + 1e-15, and times to 1e6 q^3/2/(G M)^1/2. The place is off by at most
    /// 8 eps (distance + speed times time).
    pub fn place(&self, t: f64) -> SpaceVector {
        let place = self.at(t);
        place.direction * place.distance
    }

    /// Its velocity (m/s), with a turning orbit included.
    pub fn velocity(&self, t: f64) -> SpaceVector {
        self.at(t).velocity
    }

    /// The normal of the plane at the time `t` (s): a unit vector, or NaN where its turning is lost.
    pub fn normal(&self, t: f64) -> SpaceVector {
        if t.is_nan() || t.abs() > self.latest[0] {
            return NOWHERE;
        }
        let (s, c) = sincos(self.node + self.turning[0] * t);
        let (si, ci) = sincos(self.inclination);
        SpaceVector::new(si * s, -si * c, ci)
    }

    /// The mean of 1/r^3 over a period (1/m^3), 1/(a^3 (1 - e^2)^3/2); 0 for an orbit that does
    /// not close.
    pub fn mean_inverse_cube(&self) -> f64 {
        let ratio = ((1.0 - self.eccentricity) / (1.0 + self.eccentricity)).max(0.0);
        let q = self.pericentre;
        ratio * ratio.sqrt() / (q * q * q)
    }

    /// Rate of the node (rad/s).
    pub(super) const fn node_rate(&self) -> f64 {
        self.turning[0]
    }

    /// The angular velocity at the pericentre (rad/s), with the turning.
    pub(super) fn fastest(&self) -> f64 {
        let [node, argument] = self.turning.map(f64::abs);
        self.rate * (1.0 + self.eccentricity).sqrt() + node + argument
    }

    /// Place, distance and velocity together.
    pub(super) fn at(&self, t: f64) -> Place {
        if !self.is_known(t) {
            return Place { direction: NOWHERE, distance: f64::NAN, velocity: NOWHERE };
        }
        let (e, alpha) = (self.eccentricity, 1.0 - self.eccentricity);
        let mut since = t - self.passage;
        if self.period != f64::INFINITY {
            // fmod is exact: no digit of the time is lost.
            since = fmod(since, self.period);
            if since.abs() > 0.5 * self.period {
                since -= self.period.copysign(since);
            }
        }
        let [u1, u2] = universal(alpha, e, self.rate * since);
        let (r, across) = (1.0 + e * u2, (1.0 + e).sqrt());
        let (x, y) = (1.0 - u2, across * u1);
        let (vx, vy) = (-u1 / r, across * (1.0 - alpha * u2) / r);
        let [node, argument] = self.turning;
        let still = node == 0.0 && argument == 0.0;
        let [p, q] = if still {
            self.axes
        } else {
            axes(self.node + node * t, self.inclination, self.argument + argument * t)
        };
        let direction = (p * x + q * y) / r;
        let distance = self.pericentre * r;
        let mut velocity = (p * vx + q * vy) * (self.pericentre * self.rate);
        if !still {
            let turning = SpaceVector::new(0.0, 0.0, node) + p.cross(&q) * argument;
            velocity += turning.cross(&direction) * distance;
        }
        Place { direction, distance, velocity }
    }
}

/// Where nothing is known.
const NOWHERE: SpaceVector = SpaceVector::new(f64::NAN, f64::NAN, f64::NAN);

fn eccentric(eccentricity: f64) -> Result<()> {
    finite("eccentricity", eccentricity)?;
    if eccentricity < 0.0 {
        return Err(Error::out_of_range("eccentricity", eccentricity, "0 for a circle, or more"));
    }
    Ok(())
}

/// Unit vectors to the pericentre and along the motion there.
fn axes(node: f64, inclination: f64, argument: f64) -> [SpaceVector; 2] {
    let [(sn, cn), (si, ci), (sa, ca)] = [node, inclination, argument].map(sincos);
    let level = SpaceVector::new(cn, sn, 0.0);
    let raised = SpaceVector::new(-sn * ci, cn * ci, si);
    [level * ca + raised * sa, raised * ca - level * sa]
}

/// U_1 and U_2 at this time from the pericentre, in units of sqrt(q^3/(G M)): Kepler's
/// equation tau = s + e U_3(s), solved for s.
fn universal(alpha: f64, e: f64, tau: f64) -> [f64; 2] {
    let time = tau.abs();
    // Above the root: U_3 is not negative; with x = sqrt(|alpha|) s it is at least s^3/pi^2 on
    // the half of an ellipse and s^3/6 on a hyperbola, where from x = 2 on sinh(x) - x is more
    // than 0.448 sinh(x).
    let root = alpha.abs().sqrt();
    // (On a circle at its start 0/0 is passed over: the time is a number.)
    let mut s = if alpha > 0.0 {
        time.min(cbrt(PI * PI * (time / e))).min(PI / root)
    } else {
        let far = asinh(time * root * root * root / (e - 0.552)).max(2.0);
        time.min(cbrt(6.0 * (time / e))).min(far / root)
    };
    // Rounding may have put it below.
    s *= 1.0 + 1e-9;
    let mut u = functions(alpha, s);
    for _ in 0..64 {
        let [_, u2, u3] = u;
        let next = s - ((s - time) + e * u3) / (1.0 + e * u2);
        if next.partial_cmp(&s) != Some(core::cmp::Ordering::Less) {
            break;
        }
        s = next;
        u = functions(alpha, s);
    }
    [u[0] * 1.0_f64.copysign(tau), u[1]]
}

/// U_1, U_2 and U_3, without cancellation: from the series where alpha s^2 is small.
fn functions(alpha: f64, s: f64) -> [f64; 3] {
    let y = alpha * s * s;
    if y.abs() < 4.0 {
        let (mut c2, mut c3) = (1.0, 1.0);
        for k in (1..=12).rev() {
            let n = f64::from(2 * k);
            c2 = 1.0 - y / ((n + 1.0) * (n + 2.0)) * c2;
            c3 = 1.0 - y / ((n + 2.0) * (n + 3.0)) * c3;
        }
        let (c2, c3) = (0.5 * c2, c3 / 6.0);
        return [s * (1.0 - y * c3), s * s * c2, s * s * s * c3];
    }
    let (size, root) = (alpha.abs(), alpha.abs().sqrt());
    let x = root * s;
    let (whole, half) = if alpha > 0.0 { (sin(x), sin(0.5 * x)) } else { (sinh(x), sinh(0.5 * x)) };
    let rest = if alpha > 0.0 { x - whole } else { whole - x };
    [whole / root, 2.0 * half * half / size, rest / (size * root)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The velocity is the derivative of the place, of an orbit that turns as well.
    #[test]
    fn the_velocity_is_that_of_the_place() {
        let orbit = KeplerOrbit::about(1.0, 1.0, 0.3).and_then(|orbit| orbit.turning(0.02, 0.03));
        let (orbit, h) = (orbit.expect("an orbit"), 1e-3);
        for t in [0.0, 2.0, -7.0] {
            let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| orbit.place(t + k * h));
            let moved = ((c - b) * 8.0 - (d - a)) / (12.0 * h);
            assert!((moved - orbit.velocity(t)).norm() < 1e-10, "{t}");
        }
    }
}
