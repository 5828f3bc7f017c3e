//! Ways to the same numbers that know nothing of elliptic functions: the notes'
//! equations integrated, Newton's law in vectors, and a quadrature.

use super::Equations;
use rotation_dynamics::Result;
use rotation_dynamics::exact::heavy_top::ReducedTop;
use rotation_dynamics::integrators::{Dop853, Integrator, Ode};
use rotation_dynamics::math::{EPS, cos, sin};

impl Equations {
    /// The equations of this top, without friction.
    pub fn of(top: &ReducedTop) -> Self {
        Self {
            a: top.a(),
            b: top.b(),
            c: top.c(),
            friction: 0.0,
        }
    }

    /// The state at `end` that follows from `start`, and how far a run with a
    /// tolerance 100 times coarser ends from it.
    pub fn carried(&self, start: &[f64; 4], end: f64) -> Result<([f64; 4], f64)> {
        let (fine, _) = Dop853::new(1e-14)?.advance(self, 0.0, start, end)?;
        let (coarse, _) = Dop853::new(1e-12)?.advance(self, 0.0, start, end)?;
        let apart = (0..4)
            .map(|i| (fine[i] - coarse[i]).abs())
            .fold(0.0, f64::max);
        Ok((fine, apart))
    }
}

/// Newton's and Euler's law in space, without angles and so without poles:
/// dL/dt = torque, de/dt = L x e / I1. The state is L on X, Y, Z, then the axis e.
pub struct Vectors {
    pub i1: f64,
    /// m g l.
    pub weight_moment: f64,
}

impl Ode<6> for Vectors {
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
}

/// Where the tilt turns back, and what happens in one nod.
#[derive(Debug, Clone, Copy)]
pub struct Nod {
    pub theta_min: f64,
    pub theta_max: f64,
    /// Duration in t', advance of phi, advance of zeta.
    pub period: f64,
    pub precession: f64,
    pub spin: f64,
    /// How much the last refinement changed the largest of the three.
    pub refinement: f64,
    /// By how much the three magnify a relative error of the inputs,
    pub condition: f64,
    /// and an error of the turning points.
    pub leverage: f64,
}

impl Nod {
    /// By bisection for the turning points and the trapezoidal rule for the rest.
    ///
    /// With u = cos theta = m - h cos psi the integrals run over a full turn of
    /// psi and their integrands are smooth and periodic: the trapezoidal rule
    /// then converges faster than any power of the number of points.
    pub fn by_quadrature(top: &ReducedTop, energy: f64) -> Result<Self> {
        let (bottom, _) = top.minimum();
        let excess = |theta: f64| energy - top.effective_potential(theta);
        let theta_min = crossing(excess, bottom, 0.0);
        let theta_max = greatest_tilt(top, energy);
        let (u_max, u_min) = (cos(theta_min), cos(theta_max));
        let (a, b, c) = (top.a(), top.b(), top.c());
        let sums = |points: u32| -> [f64; 3] {
            // Each sum with what its additions have lost so far (Kahan).
            let (mut sums, mut lost) = ([0.0; 3], [0.0; 3]);
            let step = core::f64::consts::TAU / f64::from(points);
            for k in 0..points {
                // (du/dt')^2 = (u - u_min)(u_max - u) w(u): the turning points drop out.
                let half = 0.5 * (u_max - u_min);
                let u = 0.5 * (u_max + u_min) - half * cos(step * (f64::from(k) + 0.5));
                let w = 2.0 * energy + 2.0 * c + a - 2.0 * c * (u_min + u_max + u);
                let dt = step / w.sqrt();
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
        let mut points = 16;
        let mut last = sums(points);
        let mut refinement = f64::INFINITY;
        while points < 1 << 14 {
            points *= 2;
            let next = sums(points);
            let change = (0..3)
                .map(|i| (next[i] - last[i]).abs())
                .fold(0.0, f64::max);
            last = next;
            let stalled = change >= refinement && change < 1e-12;
            refinement = change;
            if stalled || change <= 8.0 * EPS {
                break;
            }
        }
        // w loses digits where it is a small difference, and 1 - u^2 near the poles.
        let left = |u: f64| 2.0 * energy + 2.0 * c + a - 2.0 * c * (u_min + u_max + u);
        let terms = 2.0 * energy.abs() + 8.0 * c.abs() + a;
        let least = left(u_min).min(left(u_max)).abs();
        let closest = sin(theta_min).min(sin(theta_max));
        let condition = last[0] * terms / least + 1.0 / (closest * closest);
        Ok(Self {
            theta_min,
            theta_max,
            period: last[0],
            precession: last[1],
            spin: last[2],
            refinement,
            condition,
            leverage: 1.0 + 2.0 * c.abs() * last[0] / least,
        })
    }
}

/// The turning point farther from the vertical, by bisection.
pub fn greatest_tilt(top: &ReducedTop, energy: f64) -> f64 {
    let excess = |theta: f64| energy - top.effective_potential(theta);
    crossing(excess, top.minimum().0, core::f64::consts::PI)
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
