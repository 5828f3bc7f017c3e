//! A free body with a turn about its middle axis, nearly: when it turns over, in closed form
//! and by Euler's equations in steps.

use core::f64::consts::PI;
use rotation_dynamics::Result;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::exact::carlson::rf;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, LocatedEvent, Ode, after, ode, size_or};
use rotation_dynamics::math::{atan2, cos, hypot, log, sin, sincos};

/// Moments I1 < I2 < I3 and rates at the release, that about axis 2 not zero.
#[derive(Debug, Clone, Copy)]
pub struct Throw {
    pub moments: [f64; 3],
    pub rates: [f64; 3],
}

// ANCHOR: closed
/// What of the rates about axes 1 and 3 the rate about axis 2 can become, squared.
pub fn exchange([i1, i2, i3]: [f64; 3]) -> [f64; 2] {
    let into_1 = i2 * (i3 - i2) / (i1 * (i3 - i1));
    let into_3 = i2 * (i2 - i1) / (i3 * (i3 - i1));
    [into_1, into_3]
}

/// The rate at which an error grows, over the rate about axis 2.
pub fn growth([i1, i2, i3]: [f64; 3]) -> f64 {
    ((i2 - i1) * (i3 - i2) / (i1 * i3)).sqrt()
}

impl Throw {
    /// Time from the release until axis 2 is first across L.
    pub fn until_flip(&self) -> Result<f64> {
        let [stray_1, turn, stray_3] = self.rates;
        let way = self.way(self.rates)?;
        // If both strays have one sign, the body comes nearer to the axis at first; turned
        // backward, if they have not.
        Ok(if stray_1 * stray_3 * turn.signum() > 0.0 { self.between_flips()? - way } else { way })
    }

    /// Time between two such moments: twice that from where it is nearest to the axis.
    pub fn between_flips(&self) -> Result<f64> {
        let ([into_1, into_3], [p, q, r]) = (exchange(self.moments), self.rates);
        let lean = (into_1 / into_3).sqrt();
        let gap = (p - lean * r) * (p + lean * r);
        let nearest = if gap > 0.0 {
            [gap.sqrt(), hypot(q, r / into_3.sqrt()), 0.0]
        } else {
            [0.0, hypot(q, p / into_1.sqrt()), (-gap).sqrt() / lean]
        };
        Ok(2.0 * self.way(nearest)?)
    }

    /// Time in which the rate about axis 2 falls from what it is here to zero.
    fn way(&self, [p, q, r]: [f64; 3]) -> Result<f64> {
        let ([i1, i2, i3], [into_1, into_3]) = (self.moments, exchange(self.moments));
        let (most_1, most_3) = (p * p + into_1 * q * q, r * r + into_3 * q * q);
        let integral = rf(1.0, p * p / most_1, r * r / most_3)?;
        Ok(i2 / (i3 - i1) * q.abs() / (most_1 * most_3).sqrt() * integral)
    }
}
// ANCHOR_END: closed

// ANCHOR: euler
/// Euler's equations of a free body.
pub fn euler([i1, i2, i3]: [f64; 3]) -> impl Ode<3> {
    ode(move |_, &[p, q, r]: &[f64; 3]| {
        [(i2 - i3) / i1 * q * r, (i3 - i1) / i2 * r * p, (i1 - i2) / i3 * p * q]
    })
    .scaled(|rates| [length(*rates).max(f64::MIN_POSITIVE); 3])
}
// ANCHOR_END: euler

/// The same in air: each piece of a face with these edges is pressed by `press` w^2 for its area
/// against the velocity w with which it moves across itself.
pub fn in_air(moments: [f64; 3], [length, width]: [f64; 2], press: f64) -> impl Ode<3> {
    const PIECES: u32 = 20;
    let at = |k: u32| (f64::from(k) + 0.5) / f64::from(PIECES) - 0.5;
    let area = length * width / f64::from(PIECES * PIECES);
    ode(move |t, rates: &[f64; 3]| {
        let [mut p, mut q, r] = euler(moments).derivative(t, rates);
        for k in 0..PIECES * PIECES {
            let (x, y) = (length * at(k / PIECES), width * at(k % PIECES));
            let across = rates[0] * y - rates[1] * x;
            let force = -press * area * across * across.abs();
            p += y * force / moments[0];
            q -= x * force / moments[1];
        }
        [p, q, r]
    })
    .scaled(size_or([1.0; 3]))
}

/// By how much air delays the flip (s), to first order in the parts of the rates about axes 1 and
/// 2 that it takes in a second: an error grows more slowly as the turning slows down and as it is
/// braked itself, but is a larger part of what turns.
pub fn delay([stray, whole]: [f64; 2], first: f64, pace: f64) -> f64 {
    0.5 * whole * first * first - (whole - 0.5 * stray) * first / pace
}

fn length([x, y, z]: [f64; 3]) -> f64 {
    hypot(hypot(x, y), z)
}

impl Throw {
    /// With the axis of rotation `tilt` from axis 2, towards axis 1 or (`toward` = pi/2) 3.
    pub fn new(moments: [f64; 3], rate: f64, tilt: f64, toward: f64) -> Self {
        let ((s, c), (up, along)) = (sincos(tilt), sincos(toward));
        Self { moments, rates: [s * along, c, s * up].map(|part| rate * part) }
    }

    /// How far the strays are from those of which the body never turns over, over the rate.
    pub fn off(&self) -> f64 {
        let [into_1, into_3] = exchange(self.moments);
        let [p, q, r] = self.rates;
        ((p - (into_1 / into_3).sqrt() * r * q.signum()) / q).abs()
    }

    /// How often it turns over until the time t.
    pub fn flips(&self, t: f64) -> Result<f64> {
        let first = self.until_flip()?;
        Ok(if t < first { 0.0 } else { 1.0 + ((t - first) / self.between_flips()?).floor() })
    }

    /// Flip number `count`, by Euler's equations with this error of a step.
    pub fn flip(&self, count: u32, step: f64) -> Result<LocatedEvent<3>> {
        let until = 1e3 / (growth(self.moments) * self.rates[1].abs());
        Ok(Dop853::new(step)?.zero(&euler(self.moments), self.rates, count, until, |y| y[1])?.0)
    }

    /// The energy of these rates.
    pub fn energy(&self, rates: [f64; 3]) -> f64 {
        let parts = [0, 1, 2].map(|i| 0.5 * self.moments[i] * rates[i] * rates[i]);
        parts.iter().sum()
    }

    /// Axis `axis` against L, as a cosine, for these rates.
    pub fn along(&self, axis: usize, rates: [f64; 3]) -> f64 {
        let momentum = [0, 1, 2].map(|i| self.moments[i] * rates[i]);
        momentum[axis] / length(momentum)
    }

    pub fn body(&self) -> Result<RigidBody> {
        let [i1, i2, i3] = self.moments;
        Ok(RigidBody::new(PrincipalMoments::new(i1, i2, i3)?))
    }

    /// As it leaves the hand: axis 1 away from it, 2 to its right, the screen up.
    pub fn start(&self) -> Result<State> {
        self.body()?.state(screen_up()?, BodyVector::from_array(self.rates))
    }

    /// The library's closed form, of rates and attitude.
    pub fn free(&self) -> Result<FreeBody> {
        FreeBody::new(self.body()?.moments(), screen_up()?, BodyVector::from_array(self.rates))
    }

    /// The attitude at the time t, in steps of Euler's equations and of the quaternion: the rates
    /// of a narrow body are known better than its angular momentum tells them.
    pub fn stepped(&self, t: f64, step: f64) -> Result<Attitude> {
        let (moments, size) = (self.moments, length(self.rates));
        let law = ode(move |t, &[p, q, r, w, x, y, z]: &[f64; 7]| {
            let [pp, qq, rr] = euler(moments).derivative(t, &[p, q, r]);
            let still = -(x * p + y * q + z * r);
            let turned = [w * p + y * r - z * q, w * q + z * p - x * r, w * r + x * q - y * p];
            let [x, y, z] = turned.map(|rate| 0.5 * rate);
            [pp, qq, rr, 0.5 * still, x, y, z]
        })
        .scaled(move |_| [size, size, size, 1.0, 1.0, 1.0, 1.0]);
        let ([p, q, r], [w, x, y, z]) = (self.rates, screen_up()?.quaternion());
        let [.., w, x, y, z] = after(t, &law, &[p, q, r, w, x, y, z], step)?;
        Attitude::from_quaternion([w, x, y, z])
    }
}

/// The attitude with axis 1 along X, 2 along -Y and 3 down.
fn screen_up() -> Result<Attitude> {
    Attitude::about_space_axis(SpaceVector::new(1.0, 0.0, 0.0), PI)
}

/// Where the screen looks: against axis 3.
pub fn screen(attitude: &Attitude) -> SpaceVector {
    attitude.to_space(BodyVector::new(0.0, 0.0, -1.0))
}

/// [`growth`], from a small error that grows as a hyperbolic cosine.
pub fn measured_growth(moments: [f64; 3]) -> Result<f64> {
    let time = 2.0 / growth(moments);
    let grown = 1e7 * after(time, &euler(moments), &[1e-7, 1.0, 0.0], 1e-15)?[0];
    Ok(log(grown + ((grown - 1.0) * (grown + 1.0)).sqrt()) / time)
}

/// Thrown about axis `axis` (0 or 2) with the axis of rotation `tilt` off towards axis 2: the
/// largest angle between the axis and L, in closed form and with the rates at its two ends.
pub fn sway(moments: [f64; 3], axis: usize, tilt: f64) -> (f64, Throw) {
    let (other, middle, into) = (2 - axis, sin(tilt), exchange(moments));
    let mut rates = [0.0, middle, 0.0];
    rates[axis] = cos(tilt);
    // What the middle rate becomes about the other axis, and about this one.
    let [gain, own] = [into[other / 2], into[axis / 2]];
    let first = atan2(moments[1] * middle, moments[axis] * rates[axis]);
    let across = gain.sqrt() * middle;
    let along = hypot(rates[axis], own.sqrt() * middle);
    let second = atan2(moments[other] * across, moments[axis] * along);
    (first.max(second), Throw { moments, rates })
}
