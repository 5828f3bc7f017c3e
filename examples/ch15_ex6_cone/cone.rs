//! A solid cone as a few particles, its places, and how it is drawn: for the two exercises on
//! cones. The vertex is the origin of the body's axes, and e3 points from it to the base.

use super::Parameters;
use kit::prelude::*;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::integrators::{Dop853, Work, second_order};
use rotation_dynamics::math::expm1;

/// The vertical.
pub const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

/// What the particles of a cone that moves about its vertex add up to.
#[derive(Debug, Clone, Copy)]
pub struct Sums {
    pub angular_momentum: SpaceVector, // of r x m v, about the vertex
    pub kinetic_energy: f64,           // of m v^2/2
    pub force: SpaceVector,            // of m a: what the motion needs
    pub moment: SpaceVector,           // of r x m a, about the vertex
}

impl Parameters {
    /// 24 particles whose sums of masses times squares and products of coordinates are the
    /// integrals over the cone: Gauss's nodes along the axis and outward, four directions.
    pub fn particles(&self) -> Vec<(f64, BodyVector)> {
        let (outer, half) = (0.15_f64.sqrt(), 1.0 / 12.0_f64.sqrt());
        let mut all = Vec::new();
        for (height, weight) in [(0.5 - outer, 5.0), (0.5, 8.0), (0.5 + outer, 5.0)] {
            for out in [0.5 - half, 0.5 + half] {
                for quarter in 0..4 {
                    let (s, c) = sincos(FRAC_PI_2 * (f64::from(quarter) + 0.3));
                    let mass = self.mass * weight / 18.0 * 0.75 * height * height * out;
                    let axial = self.height * height;
                    let radial = axial * out * tan(self.half_angle);
                    all.push((mass, BodyVector::new(radial * c, radial * s, axial)));
                }
            }
        }
        all
    }

    /// The sums at the time 0 of a motion about the vertex, from the places of the particles at
    /// seven times `h` apart: no formula for a moment of inertia, for L or for T.
    pub fn sums(&self, at: impl Fn(f64) -> Result<Attitude>, h: f64) -> Result<Sums> {
        const FIRST: [f64; 7] = [-1.0, 9.0, -45.0, 0.0, 45.0, -9.0, 1.0]; // over 60 h
        const SECOND: [f64; 7] = [2.0, -27.0, 270.0, -490.0, 270.0, -27.0, 2.0]; // over 180 h^2
        let attitudes = sampled((-3..=3).map(f64::from), |k| at(k * h))?;
        let zero = SpaceVector::zero();
        let mut sum =
            Sums { angular_momentum: zero, kinetic_energy: 0.0, force: zero, moment: zero };
        for (mass, place) in self.particles() {
            let weighted = |weights: [f64; 7]| -> SpaceVector {
                attitudes.iter().zip(weights).map(|(at, weight)| at.to_space(place) * weight).sum()
            };
            let (r, v) = (attitudes[3].to_space(place), weighted(FIRST) / (60.0 * h));
            let a = weighted(SECOND) / (180.0 * h * h);
            sum.angular_momentum += r.cross(&v) * mass;
            sum.kinetic_energy += 0.5 * mass * v.dot(&v);
            sum.force += a * mass;
            sum.moment += r.cross(&a) * mass;
        }
        Ok(sum)
    }

    /// The moment about the vertical with which air of this density (kg/m^3) brakes the cone,
    /// over the square of the rate, kg m^2: that of a hundred strips across the axis, which
    /// points `rise` above the level, each with the drag coefficient 1 and its own speed.
    pub fn air(&self, rise: f64, density: f64) -> f64 {
        let thick = 0.01 * self.height;
        let strip = |k: i32| {
            let along = thick * (f64::from(k) + 0.5);
            let out = along * cos(rise);
            // Half of the density, and a width of twice the radius there.
            density * thick * along * tan(self.half_angle) * out * out * out
        };
        (0..100).map(strip).sum()
    }
}

/// The part of its energy, inertia/2 times the square of the rate, that a cone loses in a circuit
/// if nothing drives it and `brake`, a moment of the rate, holds it back; and the work of the run.
/// Nothing if the part `predicted` is so large that it may stop before.
pub fn left_to_itself(
    predicted: f64,
    [inertia, rate]: [f64; 2],
    brake: impl Fn(f64) -> f64,
) -> Result<Option<(f64, Work)>> {
    when(predicted <= 0.9, || {
        // In the time in which it would turn by a radian.
        let law = second_order(|_, _, v| -brake(rate * v) / (inertia * rate * rate));
        let (back, work) = Dop853::new(1e-13)?.zero(&law, [0.0, 1.0], 1, 1e3, |y| y[0] - TAU)?;
        Ok((1.0 - back.state[1] * back.state[1], work))
    })
}

/// What `--with air` adds to the claims of a cone whose axis points `rise` above the level and which
/// has this inertia about the vertical: the rate that is left after a circuit, if nothing drives it.
pub fn blown(p: &Parameters, report: &mut Report, rise: f64, inertia: f64) -> Result<()> {
    let Some(density) = p.air else { return Ok(()) };
    let (strips, rate) = (p.air(rise, density), p.rate);
    let lost = -expm1(-2.0 * TAU * strips / inertia);
    allowed! {
        "part of the energy that the air takes in a circuit": lost, between(0.0, 0.9), "it would stop within a circuit";
    }?;
    let ran = left_to_itself(lost, [inertia, rate], |rate| strips * rate * rate)?;
    claims! { report,
        /// in air: rate after a circuit
        blown_rate: rate * exp(-TAU * strips / inertia), "rad/s", "simulated" => rate * (1.0 - ran.map_or(1.0, |run| run.0)).sqrt(), within 1e-10 * rate;
    }
}

/// The attitude with the axis `rise` above the level, above the direction `azimuth`, and turned
/// about itself by `zeta` since.
pub fn placed(rise: f64, azimuth: f64, zeta: f64) -> Result<Attitude> {
    let (phi, theta) = (azimuth + FRAC_PI_2, FRAC_PI_2 - rise);
    Ok(Attitude::from_euler(EulerAngles { phi, theta, zeta })?)
}

/// The level direction at this azimuth.
pub fn level(azimuth: f64) -> SpaceVector {
    let (s, c) = sincos(azimuth);
    SpaceVector::new(c, s, 0.0)
}

/// The rate of spin about the axis with which the point `contact` of the body (on the fixed
/// axes, with the azimuth 0) is at rest while the axis goes round at `rate`: the velocity of
/// that point, from where it is before and after, is linear in the spin.
pub fn spin_at_rest(rise: f64, contact: SpaceVector, rate: f64) -> Result<f64> {
    let sliding = |spin: f64| -> Result<f64> {
        let point = placed(rise, 0.0, 0.0)?.to_body(contact);
        let h = 1e-3 / (rate + spin);
        let at = |t: f64| placed(rise, rate * t, spin * t).map(|at| at.to_space(point).y());
        Ok((8.0 * (at(h)? - at(-h)?) - (at(2.0 * h)? - at(-2.0 * h)?)) / (12.0 * h))
    };
    let (still, turned) = (sliding(0.0)?, sliding(rate)?);
    Ok(rate * still / (still - turned))
}

/// Adds the cone of this half angle and the height 1, with its vertex here, and a stripe from the
/// vertex to the rim and on to the middle of the base.
pub fn drawn(view: View, half_angle: f64, vertex: SpaceVector, attitude: &Attitude) -> View {
    let (axis, radius) = (attitude.axis(), tan(half_angle));
    let place = |x: f64, z: f64| vertex + attitude.to_space(BodyVector::new(x, 0.0, z));
    let (rim, base) = (1.02 * radius, 1.005);
    let stripe = [(0.0, 0.0), (rim, 1.0), (rim, base), (0.0, base)].map(|(x, z)| place(x, z));
    view.solid(Solid::cone(vertex + axis, vertex, radius), Ink::Body).line(stripe, Ink::Ink)
}

/// The directions through which a level direction turns between two azimuths, times `radius`.
pub fn sweep(from: f64, to: f64, radius: f64) -> impl Iterator<Item = SpaceVector> + Clone {
    times(from, to, 48).map(move |azimuth| level(azimuth) * radius)
}
