//! Equations of motion written out by hand, for just one scene each: what an absent effect is
//! compared with, bit by bit (`absent.rs`) and instruction by instruction
//! (`benches/src/bin/instructions.rs`).

use rotation_dynamics::Result;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::integrators::{Ode, Separable};
use rotation_dynamics::math::DoubleDouble;

/// Attitude and momentum of a body with these moments (kg m^2), as somebody writes them who
/// knows of no effects; if `HEAVY`, with its weight times lever (N m).
#[derive(Clone, Copy)]
pub struct ByHand<const HEAVY: bool> {
    moments: [f64; 3],
    moment: f64,
}

impl ByHand<false> {
    pub const fn free(moments: [f64; 3]) -> Self {
        let moment = 0.0;
        Self { moments, moment }
    }
}

impl ByHand<true> {
    pub const fn heavy(moments: [f64; 3], moment: f64) -> Self {
        Self { moments, moment }
    }
}

/// R^T v of the quaternion (w, x, y, z).
fn on_body([w, x, y, z]: [f64; 4], [a, b, c]: [f64; 3]) -> [f64; 3] {
    let (p, q, r) = (2.0 * (z * b - y * c), 2.0 * (x * c - z * a), 2.0 * (y * a - x * b));
    [a + (w * p + (z * q - y * r)), b + (w * q + (x * r - z * p)), c + (w * r + (y * p - x * q))]
}

fn length([w, x, y, z]: [f64; 4]) -> f64 {
    (w * w + x * x + y * y + z * z).sqrt()
}

impl<const HEAVY: bool> Ode<7> for ByHand<HEAVY> {
    fn derivative(&self, _t: f64, &[w, x, y, z, lx, ly, lz]: &[f64; 7]) -> [f64; 7] {
        let n = length([w, x, y, z]);
        let (uw, ux, uy, uz) = (w / n, x / n, y / n, z / n);
        let [l1, l2, l3] = on_body([uw, ux, uy, uz], [lx, ly, lz]);
        let [i1, i2, i3] = self.moments;
        let (p, q, r) = (l1 / i1, l2 / i2, l3 / i3);
        let (mut tx, mut ty, moment) = (0.0, 0.0, self.moment);
        if HEAVY {
            tx = 2.0 * (uy * uz - uw * ux) * -moment;
            ty = 2.0 * (ux * uz + uw * uy) * moment;
        }
        [
            0.5 * (-x * p - y * q - z * r),
            0.5 * (w * p + y * r - z * q),
            0.5 * (w * q + z * p - x * r),
            0.5 * (w * r + x * q - y * p),
            tx,
            ty,
            0.0,
        ]
    }

    fn scale(&self, &[w, x, y, z, lx, ly, lz]: &[f64; 7]) -> [f64; 7] {
        let q = length([w, x, y, z]);
        let built_up = if HEAVY { (self.moments[2] * self.moment).sqrt() } else { 0.0 };
        let l = SpaceVector::new(lx, ly, lz).norm().max(built_up);
        [q, q, q, q, l, l, l]
    }
}

/// Euler's equations of the same body, for Gauss-Legendre.
pub struct EulersEquations<const HEAVY: bool>(pub ByHand<HEAVY>);

impl<const HEAVY: bool> Ode<7> for EulersEquations<HEAVY> {
    fn derivative(&self, _t: f64, &[w, x, y, z, l1, l2, l3]: &[f64; 7]) -> [f64; 7] {
        let rate = |i: f64, l: f64| {
            let inverse = DoubleDouble::from(i).recip();
            l * inverse.hi() + l * inverse.lo()
        };
        let [i1, i2, i3] = self.0.moments;
        let (p, q, r) = (rate(i1, l1), rate(i2, l2), rate(i3, l3));
        let (mut m1, mut m2) = (l2 * r - l3 * q, l3 * p - l1 * r);
        if HEAVY {
            let moment = self.0.moment;
            let tx = (y * z - w * x) * 2.0 * -moment;
            let ty = (x * z + w * y) * 2.0 * moment;
            let (ww, xx, yy, zz) = (w * w, x * x, y * y, z * z);
            m1 += tx * ((ww + xx) - (yy + zz)) + (ty * (x * y + w * z)) * 2.0;
            m2 += ty * ((ww + yy) - (xx + zz)) + (tx * (x * y - w * z)) * 2.0;
        }
        let m3 = l1 * q - l2 * p;
        let (p, q, r) = (p * 0.5, q * 0.5, r * 0.5);
        [
            -(x * p + y * q + z * r),
            w * p + y * r - z * q,
            w * q + z * p - x * r,
            w * r + x * q - y * p,
            m1,
            m2,
            m3,
        ]
    }

    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        self.0.scale(y)
    }
}

/// A symmetric body, split by hand without its spin: a turn about L, and a push.
pub struct TurnAndPush<const HEAVY: bool> {
    across: f64,
    moment: f64,
}

impl TurnAndPush<false> {
    pub const fn free(across: f64) -> Self {
        let moment = 0.0;
        Self { across, moment }
    }
}

impl TurnAndPush<true> {
    pub const fn heavy(across: f64, moment: f64) -> Self {
        Self { across, moment }
    }
}

/// A sum with what its rounding has left out.
fn plus<const N: usize>((value, carry): &mut ([f64; N], [f64; N]), increment: [f64; N]) {
    for i in 0..N {
        let (a, b) = (value[i], increment[i] + carry[i]);
        let sum = a + b;
        let b_part = sum - a;
        let a_part = sum - b_part;
        (value[i], carry[i]) = (sum, (a - a_part) + (b - b_part));
    }
}

/// sin x / x and (1 - cos x)/x^2 of a small angle, from its square: nine terms each.
fn series(x: f64) -> [f64; 2] {
    let sum = |first: f64| {
        let (mut c, mut factorial) = ([0.0; 9], 1.0);
        for (k, term) in c.iter_mut().enumerate() {
            let n = 2.0 * k as f64 + first;
            factorial *= if n == 1.0 { 1.0 } else { (n - 1.0) * n };
            *term = if k % 2 == 0 { 1.0 } else { -1.0 } / factorial;
        }
        let (x2, x4) = (x * x, x * x * (x * x));
        let high = (c[5] + c[6] * x) + x2 * (c[7] + c[8] * x);
        let low = (c[1] + c[2] * x) + x2 * (c[3] + c[4] * x);
        c[0] + x * (low + x4 * high)
    };
    [sum(1.0), sum(2.0)]
}

type Pair<const N: usize> = ([f64; N], [f64; N]);

impl<const HEAVY: bool> Separable for TurnAndPush<HEAVY> {
    type State = [f64; 7];
    type Point = (Pair<4>, Pair<3>);

    fn enter(&self, &[w, x, y, z, lx, ly, lz]: &[f64; 7]) -> Result<Self::Point> {
        Ok((([w, x, y, z], [0.0; 4]), ([lx, ly, lz], [0.0; 3])))
    }

    fn leave(&self, ((q, _), (l, _)): &Self::Point, _: f64) -> Result<[f64; 7]> {
        Ok([q[0], q[1], q[2], q[3], l[0], l[1], l[2]])
    }

    fn flow(&self, (quaternion, (l, _)): &mut Self::Point, dt: f64) {
        let [w, x, y, z] = quaternion.0;
        let [a, b, c] = l.map(|l| 0.5 * (dt / self.across) * l);
        let square = a * a + b * b + c * c;
        let [rate, versine] = series(square);
        let less = -square * versine;
        let (a, b, c) = (rate * a, rate * b, rate * c);
        let more = [
            less * w - (a * x + b * y + c * z),
            less * x + (a * w + b * z - c * y),
            less * y + (b * w + c * x - a * z),
            less * z + (c * w + a * y - b * x),
        ];
        plus(quaternion, more);
    }

    fn kick(&self, ((q, _), momentum): &mut Self::Point, dt: f64) {
        if HEAVY {
            let ([w, x, y, z], moment) = (*q, self.moment);
            let (tx, ty) = (2.0 * (y * z - w * x) * -moment, 2.0 * (x * z + w * y) * moment);
            plus(momentum, [dt * tx, dt * ty, 0.0]);
        }
    }

    fn settle(&self, (quaternion, _): &mut Self::Point) {
        let q = quaternion.0;
        let excess = q.iter().map(|c| c * c).sum::<f64>() - 1.0;
        plus(quaternion, q.map(|c| -0.5 * excess * c));
    }
}
