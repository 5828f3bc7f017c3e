//! The equations of the motions without a closed form, as bare numbers.
//!
//! Written once over [`Lane`]: the peers and our own explicit methods evaluate them for one
//! number, Gauss-Legendre for eight side by side. The rates are carried as h = omega/2, with
//! which q' = q (0, h) and h' cost the fewest products; constants are divided once.

use crate::form::Form;
use crate::open::{LYING, Under, no_closed_form};
use crate::problem::{Motion, Problem};
use rotation_dynamics::integrators::{StageOde, size_or};
use rotation_dynamics::math::lane::WIDEST;
use rotation_dynamics::math::{Lane, exp, sincos};
use rotation_dynamics::{Error, Result};

/// q (0, h).
#[inline(always)]
fn turned<L: Lane>([w, x, y, z]: [L; 4], [p, q, r]: [L; 3]) -> [L; 4] {
    [-(x * p + y * q + z * r), w * p + y * r - z * q, w * q + z * p - x * r, w * r + x * q - y * p]
}

/// cos and sin of rate t, one after the other.
#[inline(always)]
fn wave<L: Lane>(rate: f64, t: L) -> [L; 2] {
    let (mut times, mut c, mut s) = ([0.0; WIDEST], [0.0; WIDEST], [0.0; WIDEST]);
    t.store(&mut times);
    for lane in 0..L::WIDTH {
        (s[lane], c[lane]) = sincos(rate * times[lane]);
    }
    [L::load(&c), L::load(&s)]
}

/// The numbers of a body that all forms share.
#[derive(Debug, Clone, Copy)]
pub struct Body {
    moments: [f64; 3],
    /// 2 (I2 - I3)/I1 and so on: h1' = k1 h2 h3.
    euler: [f64; 3],
    /// q and h at the start.
    start: [f64; 7],
}

impl Body {
    fn new(moments: [f64; 3], rates: [f64; 3]) -> Self {
        let [i1, i2, i3] = moments;
        let [w, x, y, z] = LYING;
        let [p, q, r] = rates.map(|rate| 0.5 * rate);
        Self {
            moments,
            euler: [2.0 * (i2 - i3) / i1, 2.0 * (i3 - i1) / i2, 2.0 * (i1 - i2) / i3],
            start: [w, x, y, z, p, q, r],
        }
    }

    /// The body of a problem and what acts on it.
    fn of(problem: &Problem) -> Result<(Self, Under)> {
        match problem.motion {
            Motion::Open { moments, rates, under } => Ok((Self::new(moments, rates), under)),
            _ => Err(no_closed_form()),
        }
    }

    /// q' and h' of the free body.
    #[inline(always)]
    fn free<L: Lane>(&self, q: [L; 4], [p, r, s]: [L; 3]) -> ([L; 4], [L; 3]) {
        let [a, b, c] = self.euler;
        (turned(q, [p, r, s]), [r * s * a, s * p * b, p * r * c])
    }
}

fn other() -> Error {
    no_closed_form()
}

/// As a form: its rates are those of one lane.
macro_rules! form {
    ($Form:ty, $count:literal, $name:literal, $quaternion:expr) => {
        impl Form<$count> for $Form {
            const NAME: &'static str = $name;

            #[inline(always)]
            fn rates(&self, t: f64, y: &[f64; $count]) -> [f64; $count] {
                self.derivatives(t, y)
            }

            fn start(&self) -> [f64; $count] {
                self.start
            }

            fn quaternion(&self, t: f64, y: &[f64; $count]) -> [f64; 4] {
                let quaternion: fn(&Self, f64, &[f64; $count]) -> [f64; 4] = $quaternion;
                quaternion(self, t, y)
            }
        }
    };
}

/// Quaternion and rates of a body under its weight, and with friction about its axis.
#[derive(Debug, Clone, Copy)]
pub struct Heavy {
    body: Body,
    /// m g l/I1 and m g l/I2.
    weight: [f64; 2],
    friction: f64,
    start: [f64; 7],
}

impl Heavy {
    /// The form of a problem.
    ///
    /// # Errors
    /// A body that is not heavy.
    pub fn new(problem: &Problem) -> Result<Self> {
        let (body, under) = Body::of(problem)?;
        let (weight, friction) = match under {
            Under::Weight(weight) => (weight, 0.0),
            Under::WeightAndFriction(weight, friction) => (weight, friction),
            _ => return Err(other()),
        };
        let [i1, i2, i3] = body.moments;
        Ok(Self {
            body,
            weight: [weight / i1, weight / i2],
            friction: friction / i3,
            start: body.start,
        })
    }

    #[inline(always)]
    fn undamped<L: Lane>(&self, &[w, x, y, z, p, q, r]: &[L; 7]) -> [L; 7] {
        let ([dw, dx, dy, dz], [dp, dq, dr]) = self.body.free([w, x, y, z], [p, q, r]);
        let [a, b] = self.weight;
        // m g l times the vertical x e3, on the body axes.
        let (dp, dq) = (dp + (y * z + w * x) * a, dq - (x * z - w * y) * b);
        [dw, dx, dy, dz, dp, dq, dr]
    }
}

impl StageOde<7> for Heavy {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, _t: L, y: &[L; 7]) -> [L; 7] {
        self.undamped(y)
    }

    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        size_or([1.0; 7])(y)
    }
}

form!(Heavy, 7, "q, h", |_, _, &[w, x, y, z, ..]| [w, x, y, z]);

/// [`Heavy`] with its friction.
#[derive(Debug, Clone, Copy)]
pub struct Damped {
    heavy: Heavy,
    start: [f64; 7],
}

impl Damped {
    /// The form of a problem.
    ///
    /// # Errors
    /// A body that is not heavy.
    pub fn new(problem: &Problem) -> Result<Self> {
        let heavy = Heavy::new(problem)?;
        let start = heavy.start;
        Ok(Self { heavy, start })
    }
}

impl StageOde<7> for Damped {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, _t: L, y: &[L; 7]) -> [L; 7] {
        let [w, x, y1, z, p, q, r] = self.heavy.undamped(y);
        [w, x, y1, z, p, q, r - y[6] * self.heavy.friction]
    }

    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        size_or([1.0; 7])(y)
    }
}

form!(Damped, 7, "q, h", |_, _, &[w, x, y, z, ..]| [w, x, y, z]);

/// The quaternion and the momentum in space of a heavy body: L_Z is constant.
#[derive(Debug, Clone, Copy)]
pub struct HeavyInSpace {
    half: [f64; 3],
    weight: f64,
    vertical: f64,
    start: [f64; 6],
}

impl HeavyInSpace {
    /// The form of a problem.
    ///
    /// # Errors
    /// A body under anything but its weight.
    pub fn new(problem: &Problem) -> Result<Self> {
        let (body, under) = Body::of(problem)?;
        let Under::Weight(weight) = under else {
            return Err(other());
        };
        let (_, start) = problem.start()?;
        let [w, x, y, z] = LYING;
        let [lx, ly, vertical] = start.angular_momentum.to_array();
        Ok(Self {
            half: body.moments.map(|i| 0.5 / i),
            weight: 2.0 * weight,
            vertical,
            start: [w, x, y, z, lx, ly],
        })
    }
}

impl StageOde<6> for HeavyInSpace {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, _t: L, &[w, x, y, z, lx, ly]: &[L; 6]) -> [L; 6] {
        let lz = L::of(self.vertical);
        // L on the body axes: v + 2 u x (u x v - w v) with u = (x, y, z).
        let (cx, cy, cz) =
            (y * lz - z * ly - w * lx, z * lx - x * lz - w * ly, x * ly - y * lx - w * lz);
        let [a, b, c] = self.half;
        let h = [
            (lx + (y * cz - z * cy) * 2.0) * a,
            (ly + (z * cx - x * cz) * 2.0) * b,
            (lz + (x * cy - y * cx) * 2.0) * c,
        ];
        let [dw, dx, dy, dz] = turned([w, x, y, z], h);
        let k = self.weight;
        [dw, dx, dy, dz, (w * x - y * z) * k, (x * z + w * y) * k]
    }

    fn scale(&self, y: &[f64; 6]) -> [f64; 6] {
        size_or([1.0; 6])(y)
    }
}

form!(HeavyInSpace, 6, "q, L", |_, _, &[w, x, y, z, ..]| [w, x, y, z]);

/// A top with a bearing, without its spin: S' = S (0, m), and m = L/(2 I1) on axes that turn
/// with L/I1, on which it changes by the torque alone. The spin, the integral of what decays
/// exponentially, is put back at the end.
#[derive(Debug, Clone, Copy)]
pub struct DampedWithoutSpin {
    weight: f64,
    friction: f64,
    /// The rate of the spin at the start.
    spin: f64,
    start: [f64; 7],
}

impl DampedWithoutSpin {
    /// The form of a problem.
    ///
    /// # Errors
    /// A body that is no damped top.
    pub fn new(problem: &Problem) -> Result<Self> {
        let (body, under) = Body::of(problem)?;
        let Under::WeightAndFriction(weight, friction) = under else {
            return Err(other());
        };
        let [i1, _, i3] = body.moments;
        let [w, x, y, z, p, q, r] = body.start;
        Ok(Self {
            weight: weight / i1,
            friction: friction / i3,
            spin: 2.0 * r * ((i1 - i3) / i1),
            start: [w, x, y, z, p, q, r * (i3 / i1)],
        })
    }
}

impl StageOde<7> for DampedWithoutSpin {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, _t: L, &[w, x, y, z, p, q, r]: &[L; 7]) -> [L; 7] {
        let [dw, dx, dy, dz] = turned([w, x, y, z], [p, q, r]);
        let k = self.weight;
        [dw, dx, dy, dz, (y * z + w * x) * k, (w * y - x * z) * k, -(r * self.friction)]
    }

    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        size_or([1.0; 7])(y)
    }
}

form!(DampedWithoutSpin, 7, "S, m", |form, t, &[w, x, y, z, ..]| {
    let k = form.friction;
    let spin = form.spin * (1.0 - exp(-k * t)) / k;
    let (s, c) = sincos(0.5 * spin);
    [w * c - z * s, x * c + y * s, y * c - x * s, z * c + w * s]
});

/// Quaternion and rates of a satellite; the direction to the attracting body is that of the time.
#[derive(Debug, Clone, Copy)]
pub struct Satellite {
    body: Body,
    mean_motion: f64,
    /// (3/2) n0^2 (I3 - I2)/I1 and so on.
    gradient: [f64; 3],
    start: [f64; 7],
}

impl Satellite {
    /// The form of a problem.
    ///
    /// # Errors
    /// A body that is no satellite.
    pub fn new(problem: &Problem) -> Result<Self> {
        let (body, under) = Body::of(problem)?;
        let Under::Gradient(mean_motion) = under else {
            return Err(other());
        };
        Ok(Self {
            body,
            mean_motion,
            gradient: body.euler.map(|k| -0.75 * mean_motion * mean_motion * k),
            start: body.start,
        })
    }

    /// h' of the satellite with this direction on its axes.
    #[inline(always)]
    fn pulled<L: Lane>(&self, [dp, dq, dr]: [L; 3], [a, b, c]: [L; 3]) -> [L; 3] {
        let [ka, kb, kc] = self.gradient;
        [dp + b * c * ka, dq + c * a * kb, dr + a * b * kc]
    }
}

impl StageOde<7> for Satellite {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, t: L, &[w, x, y, z, p, q, r]: &[L; 7]) -> [L; 7] {
        let (turn, free) = self.body.free([w, x, y, z], [p, q, r]);
        let [c, s] = wave(self.mean_motion, t);
        let (ww, xx, yy, zz) = (w * w, x * x, y * y, z * z);
        // X cos + Y sin on the body axes: the sign of a direction does not count.
        let toward = [
            c * ((ww + xx) - (yy + zz)) + s * (x * y + w * z) * 2.0,
            c * (x * y - w * z) * 2.0 + s * ((ww + yy) - (xx + zz)),
            (c * (x * z + w * y) + s * (y * z - w * x)) * 2.0,
        ];
        let [dp, dq, dr] = self.pulled(free, toward);
        [turn[0], turn[1], turn[2], turn[3], dp, dq, dr]
    }

    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        size_or([1.0; 7])(y)
    }
}

form!(Satellite, 7, "q, h", |_, _, &[w, x, y, z, ..]| [w, x, y, z]);

/// A satellite seen from its orbit: p turns the body's axes to those that go round with it, on
/// which the attracting body stands still.
#[derive(Debug, Clone, Copy)]
pub struct SatelliteOnOrbit {
    inner: Satellite,
    start: [f64; 7],
}

impl SatelliteOnOrbit {
    /// The form of a problem.
    ///
    /// # Errors
    /// A body that is no satellite.
    pub fn new(problem: &Problem) -> Result<Self> {
        let inner = Satellite::new(problem)?;
        let start = inner.start;
        Ok(Self { inner, start })
    }
}

impl StageOde<7> for SatelliteOnOrbit {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, _t: L, &[w, x, y, z, p, q, r]: &[L; 7]) -> [L; 7] {
        let ([dw, dx, dy, dz], free) = self.inner.body.free([w, x, y, z], [p, q, r]);
        // Less (0, 0, 0, n0/2) p.
        let n = 0.5 * self.inner.mean_motion;
        let toward =
            [(w * w + x * x) - (y * y + z * z), (x * y - w * z) * 2.0, (x * z + w * y) * 2.0];
        let [dp, dq, dr] = self.inner.pulled(free, toward);
        [dw + z * n, dx + y * n, dy - x * n, dz - w * n, dp, dq, dr]
    }

    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        size_or([1.0; 7])(y)
    }
}

form!(SatelliteOnOrbit, 7, "p, h", |form, t, &[w, x, y, z, ..]| {
    let (s, c) = sincos(0.5 * form.inner.mean_motion * t);
    [c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w]
});

/// Quaternion and rates of a driven body.
#[derive(Debug, Clone, Copy)]
pub struct Driven {
    body: Body,
    drive: [f64; 3],
    rate: f64,
    start: [f64; 7],
}

impl Driven {
    /// The form of a problem.
    ///
    /// # Errors
    /// A body that is not driven.
    pub fn new(problem: &Problem) -> Result<Self> {
        let (body, under) = Body::of(problem)?;
        let Under::Drive(torque, rate) = under else {
            return Err(other());
        };
        Ok(Self {
            body,
            drive: core::array::from_fn(|i| 0.5 * torque[i] / body.moments[i]),
            rate,
            start: body.start,
        })
    }

    /// q' and h' with this cosine.
    #[inline(always)]
    fn pushed<L: Lane>(&self, cosine: L, q: [L; 4], h: [L; 3]) -> [L; 7] {
        let ([dw, dx, dy, dz], [dp, dq, dr]) = self.body.free(q, h);
        let [a, b, c] = self.drive;
        [dw, dx, dy, dz, dp + cosine * a, dq + cosine * b, dr + cosine * c]
    }
}

impl StageOde<7> for Driven {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, t: L, &[w, x, y, z, p, q, r]: &[L; 7]) -> [L; 7] {
        let [c, _] = wave(self.rate, t);
        self.pushed(c, [w, x, y, z], [p, q, r])
    }

    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        size_or([1.0; 7])(y)
    }
}

form!(Driven, 7, "q, h", |_, _, &[w, x, y, z, ..]| [w, x, y, z]);

/// The same with cosine and sine of the drive as variables of their own, which spares an
/// elementary function in each evaluation.
#[derive(Debug, Clone, Copy)]
pub struct DrivenByOscillator {
    inner: Driven,
    start: [f64; 9],
}

impl DrivenByOscillator {
    /// The form of a problem.
    ///
    /// # Errors
    /// A body that is not driven.
    pub fn new(problem: &Problem) -> Result<Self> {
        let inner = Driven::new(problem)?;
        let [w, x, y, z, p, q, r] = inner.start;
        Ok(Self { inner, start: [w, x, y, z, p, q, r, 1.0, 0.0] })
    }
}

impl StageOde<9> for DrivenByOscillator {
    #[inline(always)]
    fn derivatives<L: Lane>(&self, _t: L, &[w, x, y, z, p, q, r, c, s]: &[L; 9]) -> [L; 9] {
        let [dw, dx, dy, dz, dp, dq, dr] = self.inner.pushed(c, [w, x, y, z], [p, q, r]);
        let rate = self.inner.rate;
        [dw, dx, dy, dz, dp, dq, dr, -(s * rate), c * rate]
    }

    fn scale(&self, y: &[f64; 9]) -> [f64; 9] {
        size_or([1.0; 9])(y)
    }
}

form!(DrivenByOscillator, 9, "q, h, cos, sin", |_, _, &[w, x, y, z, ..]| [w, x, y, z]);
