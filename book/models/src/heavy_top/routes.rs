//! Ways to the same numbers that know nothing of elliptic functions: the notes'
//! equations and Newton's law, to be integrated, and a quadrature.

use core::f64::consts::{PI, TAU};
use rotation_dynamics::exact::heavy_top::ReducedTop;
use rotation_dynamics::integrators::{Ode, size_or};
use rotation_dynamics::math::{EPS, cos, sin};

/// Equations (4) to (6) of the notes, 16.2: theta, dtheta/dt', phi, zeta.
#[derive(Debug, Clone, Copy)]
pub struct Equations(pub ReducedTop);

impl Ode<4> for Equations {
    fn derivative(&self, _t: f64, &[theta, nutation, _, _]: &[f64; 4]) -> [f64; 4] {
        let Self(top) = self;
        let precession = top.phi_rate(theta);
        let spin = 1.0 / top.a().sqrt() - precession * cos(theta);
        [nutation, top.torque(theta), precession, spin]
    }

    fn scale(&self, y: &[f64; 4]) -> [f64; 4] {
        size_or([1.0; 4])(y)
    }
}

/// Newton's and Euler's law in space, without angles and so without poles:
/// dL/dt = torque, de/dt = L x e / I1. The state is L on X, Y, Z, then the axis e.
#[derive(Debug, Clone, Copy)]
pub struct Newton {
    /// Moment of inertia across the axis, about the fixed point.
    pub i1: f64,
    /// m g l.
    pub weight_moment: f64,
}

impl Ode<6> for Newton {
    fn derivative(&self, _t: f64, &[lx, ly, lz, ex, ey, ez]: &[f64; 6]) -> [f64; 6] {
        let (i1, w) = (self.i1, self.weight_moment);
        [
            -w * ey,
            w * ex,
            0.0,
            (ly * ez - lz * ey) / i1,
            (lz * ex - lx * ez) / i1,
            (lx * ey - ly * ex) / i1,
        ]
    }

    fn scale(&self, y: &[f64; 6]) -> [f64; 6] {
        size_or([1.0; 6])(y)
    }
}

/// Where the tilt turns back, and what happens in one nod, in t'.
#[derive(Debug, Clone, Copy)]
pub struct Nod {
    /// The turning points (rad).
    pub theta_min: f64,
    /// The lower one.
    pub theta_max: f64,
    /// Duration in t'.
    pub period: f64,
    /// Advance of phi (rad).
    pub precession: f64,
    /// Advance of zeta (rad).
    pub spin: f64,
    /// How much the last refinement changed the largest of these three,
    pub(crate) refinement: f64,
    /// by how much they magnify a relative error of the inputs,
    pub(crate) condition: f64,
    /// and an error of the turning points.
    pub(crate) leverage: f64,
}

impl Nod {
    /// By bisection for the turning points and the trapezoidal rule for the rest.
    ///
    /// With u = cos theta = m - h cos psi the integrals run over a full turn of
    /// psi and their integrands are smooth and periodic: the trapezoidal rule
    /// then converges faster than any power of the number of points.
    pub fn by_quadrature(top: &ReducedTop, energy: f64) -> Self {
        let excess = |theta: f64| energy - top.effective_potential(theta);
        let theta_min = crossing(excess, top.minimum().0, 0.0);
        let theta_max = greatest_tilt(top, energy);
        let (u_max, u_min) = (cos(theta_min), cos(theta_max));
        let (a, b, c) = (top.a(), top.b(), top.c());
        // (du/dt')^2 = (u - u_min)(u_max - u) left(u): the turning points drop out.
        let left = |u: f64| 2.0 * energy + 2.0 * c + a - 2.0 * c * (u_min + u_max + u);
        let sums = |points: u32| -> [f64; 3] {
            // Each sum with what its additions have lost so far (Kahan).
            let (mut sums, mut lost) = ([0.0; 3], [0.0; 3]);
            let step = TAU / f64::from(points);
            for k in 0..points {
                let half = 0.5 * (u_max - u_min);
                let u = 0.5 * (u_max + u_min) - half * cos(step * (f64::from(k) + 0.5));
                let dt = step / left(u).sqrt();
                let rate = a.sqrt() * (b - u) / ((1.0 - u) * (1.0 + u));
                let terms = [dt, rate * dt, (1.0 / a.sqrt() - rate * u) * dt];
                for k in 0..3 {
                    let term = terms[k] - lost[k];
                    let sum = sums[k] + term;
                    lost[k] = (sum - sums[k]) - term;
                    sums[k] = sum;
                }
            }
            sums
        };
        let (mut points, mut last, mut refinement) = (16, sums(16), f64::INFINITY);
        while points < 1 << 14 {
            points *= 2;
            let next = sums(points);
            let changes = (0..3).map(|i| (next[i] - last[i]).abs());
            let change = changes.fold(0.0, f64::max);
            last = next;
            let stalled = change >= refinement && change < 1e-12;
            refinement = change;
            if stalled || change <= 8.0 * EPS {
                break;
            }
        }
        // left(u) loses digits where it is a small difference, and 1 - u^2 near the poles.
        let terms = 2.0 * energy.abs() + 8.0 * c.abs() + a;
        let least = left(u_min).min(left(u_max)).abs();
        let closest = sin(theta_min).min(sin(theta_max));
        Self {
            theta_min,
            theta_max,
            period: last[0],
            precession: last[1],
            spin: last[2],
            refinement,
            condition: last[0] * terms / least + 1.0 / (closest * closest),
            leverage: 1.0 + 2.0 * c.abs() * last[0] / least,
        }
    }
}

/// The turning point farther from the vertical, by bisection.
pub(super) fn greatest_tilt(top: &ReducedTop, energy: f64) -> f64 {
    let excess = |theta: f64| energy - top.effective_potential(theta);
    crossing(excess, top.minimum().0, PI)
}

/// The place between `inside`, where `f >= 0`, and `outside`, where `f` is
/// negative, at which it changes sign: bisection down to neighbouring numbers.
fn crossing(f: impl Fn(f64) -> f64, mut inside: f64, mut outside: f64) -> f64 {
    loop {
        let middle = 0.5 * (inside + outside);
        if middle == inside || middle == outside {
            return middle;
        }
        if f(middle) >= 0.0 {
            inside = middle;
        } else {
            outside = middle;
        }
    }
}
