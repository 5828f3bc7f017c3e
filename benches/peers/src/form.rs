//! The equations of motion as bare numbers, for those who know no rigid body.
//!
//! Each form is written as one would for speed: no branch, no square root, nothing
//! computed twice, constants divided once. Every peer gets each form that applies,
//! and the record shows the fastest.

use crate::problem::{Begin, Motion, Problem};
use rotation_dynamics::integrators::Ode;
use rotation_dynamics::math::sincos;
use rotation_dynamics::{Error, Result};

/// A system of `N` equations whose solution tells the attitude.
pub trait Form<const N: usize>: Copy + Send + Sync + 'static {
    /// The variables.
    const NAME: &'static str;

    /// y' at t and y.
    fn rates(&self, t: f64, y: &[f64; N]) -> [f64; N];

    /// y at the start.
    fn start(&self) -> [f64; N];

    /// The quaternion w, x, y, z at time t, of any length.
    fn quaternion(&self, t: f64, y: &[f64; N]) -> [f64; 4];
}

/// A form as this library's own methods take it.
#[derive(Debug, Clone, Copy)]
pub struct Own<F>(pub F);

impl<const N: usize, F: Form<N>> Ode<N> for Own<F> {
    #[inline(always)]
    fn derivative(&self, t: f64, y: &[f64; N]) -> [f64; N] {
        self.0.rates(t, y)
    }

    /// All variables are of order one, or angles.
    fn scale(&self, _y: &[f64; N]) -> [f64; N] {
        [1.0; N]
    }
}

/// q (0, omega) / 2.
#[inline(always)]
fn turned([w, x, y, z]: [f64; 4], [p, q, r]: [f64; 3]) -> [f64; 4] {
    let (p, q, r) = (0.5 * p, 0.5 * q, 0.5 * r);
    [-(x * p + y * q + z * r), w * p + y * r - z * q, w * q + z * p - x * r, w * r + x * q - y * p]
}

/// Quaternion and momentum on the body axes, of a free body.
#[derive(Debug, Clone, Copy)]
pub struct FreeMomentum {
    inverse: [f64; 3],
    start: [f64; 7],
}

impl FreeMomentum {
    /// The form of a problem.
    ///
    /// # Errors
    /// None for the problems of this crate.
    pub fn new(problem: &Problem) -> Result<Self> {
        let (body, start) = problem.start()?;
        let [w, x, y, z] = start.attitude.quaternion();
        let [l1, l2, l3] = body.angular_momentum(&start).to_array();
        Ok(Self { inverse: problem.moments().map(|i| 1.0 / i), start: [w, x, y, z, l1, l2, l3] })
    }
}

impl Form<7> for FreeMomentum {
    const NAME: &'static str = "q, l";

    #[inline(always)]
    fn rates(&self, _t: f64, &[w, x, y, z, l1, l2, l3]: &[f64; 7]) -> [f64; 7] {
        let [a, b, c] = self.inverse;
        let (p, q, r) = (a * l1, b * l2, c * l3);
        let [dw, dx, dy, dz] = turned([w, x, y, z], [p, q, r]);
        [dw, dx, dy, dz, l2 * r - l3 * q, l3 * p - l1 * r, l1 * q - l2 * p]
    }

    fn start(&self) -> [f64; 7] {
        self.start
    }

    fn quaternion(&self, _t: f64, &[w, x, y, z, ..]: &[f64; 7]) -> [f64; 4] {
        [w, x, y, z]
    }
}

/// The quaternion alone, of a free body: L is fixed in space.
#[derive(Debug, Clone, Copy)]
pub struct FreeQuaternion {
    inverse: [f64; 3],
    momentum: [f64; 3],
    start: [f64; 4],
}

impl FreeQuaternion {
    /// The form of a problem.
    ///
    /// # Errors
    /// None for the problems of this crate.
    pub fn new(problem: &Problem) -> Result<Self> {
        let (_, start) = problem.start()?;
        Ok(Self {
            inverse: problem.moments().map(|i| 1.0 / i),
            momentum: start.angular_momentum.to_array(),
            start: start.attitude.quaternion(),
        })
    }
}

impl Form<4> for FreeQuaternion {
    const NAME: &'static str = "q";

    /// As for a quaternion of length one, which an exact solution keeps.
    #[inline(always)]
    fn rates(&self, _t: f64, &[w, x, y, z]: &[f64; 4]) -> [f64; 4] {
        let [lx, ly, lz] = self.momentum;
        // L on the body axes: v + 2 u x (u x v - w v) with u = (x, y, z).
        let (cx, cy, cz) =
            (y * lz - z * ly - w * lx, z * lx - x * lz - w * ly, x * ly - y * lx - w * lz);
        let body = [
            lx + 2.0 * (y * cz - z * cy),
            ly + 2.0 * (z * cx - x * cz),
            lz + 2.0 * (x * cy - y * cx),
        ];
        let [a, b, c] = self.inverse;
        turned([w, x, y, z], [a * body[0], b * body[1], c * body[2]])
    }

    fn start(&self) -> [f64; 4] {
        self.start
    }

    fn quaternion(&self, _t: f64, y: &[f64; 4]) -> [f64; 4] {
        *y
    }
}

/// Quaternion and momentum on the body axes, of a top.
#[derive(Debug, Clone, Copy)]
pub struct TopMomentum {
    inverse: [f64; 3],
    weight: f64,
    start: [f64; 7],
}

impl TopMomentum {
    /// The form of a problem.
    ///
    /// # Errors
    /// A free body.
    pub fn new(problem: &Problem) -> Result<Self> {
        let (_, start) = FreeMomentum::new(problem).map(|form| (form.inverse, form.start))?;
        let (weight, _) = top(problem)?;
        Ok(Self { inverse: problem.moments().map(|i| 1.0 / i), weight, start })
    }
}

impl Form<7> for TopMomentum {
    const NAME: &'static str = "q, l";

    #[inline(always)]
    fn rates(&self, _t: f64, &[w, x, y, z, l1, l2, l3]: &[f64; 7]) -> [f64; 7] {
        let [a, b, c] = self.inverse;
        let (p, q, r) = (a * l1, b * l2, c * l3);
        let [dw, dx, dy, dz] = turned([w, x, y, z], [p, q, r]);
        // The torque is m g l times the vertical x e3, on the body axes.
        let k = 2.0 * self.weight;
        [
            dw,
            dx,
            dy,
            dz,
            l2 * r - l3 * q + k * (y * z + w * x),
            l3 * p - l1 * r - k * (x * z - w * y),
            l1 * q - l2 * p,
        ]
    }

    fn start(&self) -> [f64; 7] {
        self.start
    }

    fn quaternion(&self, _t: f64, &[w, x, y, z, ..]: &[f64; 7]) -> [f64; 4] {
        [w, x, y, z]
    }
}

/// A top without its spin: S' = (0, L/I1) S / 2, and the momentum in space, whose
/// vertical component is constant. The spin is put back at the end.
#[derive(Debug, Clone, Copy)]
pub struct TopWithoutSpin {
    inverse: f64,
    vertical: f64,
    weight: f64,
    spin: f64,
    start: [f64; 6],
}

impl TopWithoutSpin {
    /// The form of a problem.
    ///
    /// # Errors
    /// A free body.
    pub fn new(problem: &Problem) -> Result<Self> {
        let (body, start) = problem.start()?;
        let (weight, _) = top(problem)?;
        let [w, x, y, z] = start.attitude.quaternion();
        let [lx, ly, lz] = start.angular_momentum.to_array();
        let [i1, _, i3] = problem.moments();
        Ok(Self {
            inverse: 1.0 / i1,
            vertical: lz,
            weight,
            spin: body.angular_velocity(&start).z() * ((i1 - i3) / i1),
            start: [w, x, y, z, lx, ly],
        })
    }
}

impl Form<6> for TopWithoutSpin {
    const NAME: &'static str = "S, L";

    #[inline(always)]
    fn rates(&self, _t: f64, &[w, x, y, z, lx, ly]: &[f64; 6]) -> [f64; 6] {
        let half = 0.5 * self.inverse;
        let (p, q, r) = (half * lx, half * ly, half * self.vertical);
        let k = 2.0 * self.weight;
        [
            -(p * x + q * y + r * z),
            p * w + q * z - r * y,
            q * w + r * x - p * z,
            r * w + p * y - q * x,
            -k * (y * z - w * x),
            k * (x * z + w * y),
        ]
    }

    fn start(&self) -> [f64; 6] {
        self.start
    }

    fn quaternion(&self, t: f64, &[w, x, y, z, ..]: &[f64; 6]) -> [f64; 4] {
        let (s, c) = sincos(0.5 * self.spin * t);
        [w * c - z * s, x * c + y * s, y * c - x * s, z * c + w * s]
    }
}

/// The notes' angles: theta, theta', phi, zeta.
#[derive(Debug, Clone, Copy)]
pub struct TopAngles {
    a: f64,
    b: f64,
    c: f64,
    root: f64,
    spin: f64,
    start: [f64; 4],
}

impl TopAngles {
    /// The form of a problem.
    ///
    /// # Errors
    /// A free body.
    pub fn new(problem: &Problem) -> Result<Self> {
        let (c, [a, b]) = top(problem)?;
        let theta = match problem.motion {
            Motion::Top { from: Begin::Rest(theta), .. } => theta,
            _ => problem.exact()?.attitude(0.0).euler_angles().theta,
        };
        Ok(Self { a, b, c, root: a.sqrt(), spin: 1.0 / a.sqrt(), start: [theta, 0.0, 0.0, 0.0] })
    }
}

impl Form<4> for TopAngles {
    const NAME: &'static str = "theta, phi, zeta";

    #[inline(always)]
    fn rates(&self, _t: f64, &[theta, rate, ..]: &[f64; 4]) -> [f64; 4] {
        let (s, c) = sincos(theta);
        let part = (self.b - c) / (s * s);
        let precession = self.root * part;
        [
            rate,
            self.c * s - self.a * part * ((1.0 - self.b * c) / s),
            precession,
            self.spin - precession * c,
        ]
    }

    fn start(&self) -> [f64; 4] {
        self.start
    }

    fn quaternion(&self, _t: f64, &[theta, _, phi, zeta]: &[f64; 4]) -> [f64; 4] {
        let (s, c) = sincos(0.5 * theta);
        let (sum, cosum) = sincos(0.5 * (phi + zeta));
        let (difference, codifference) = sincos(0.5 * (phi - zeta));
        [c * cosum, s * codifference, s * difference, c * sum]
    }
}

/// c, and a and b, of a top.
fn top(problem: &Problem) -> Result<(f64, [f64; 2])> {
    match problem.motion {
        Motion::Top { a, b, c, .. } => Ok((c, [a, b])),
        Motion::Free { .. } | Motion::Open { .. } => {
            Err(Error::out_of_range("m g l", 0.0, "a top has some"))
        }
    }
}
