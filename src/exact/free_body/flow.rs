//! The exact free rotation over a step, from a new momentum each time.
//!
//! For splittings, where a kick changes the momentum between any two flows: a set-up
//! is not worth its price there. No case is special: sphere, needle, disc, an axis and
//! the separatrix go through the same lines. Not for long times: see [`super::FreeBody`].
//!
//! With a_n = |L|/I_n, n = l/|L| at the start, nu = sum a_n n_n^2 and t_n = nu - a_n,
//! let e_n be the three functions of h = dt/2 with e_i' = -e_j e_k and e_n ~ 1/h:
//! e_n^2 = P(h) - eps_n with Weierstrass's P and eps_i - eps_j = (a_i - a_j) t_k. Then
//! the direction of l at half the step is, by the addition theorem,
//!
//!   m_i = (n_i e_j e_k + (a_k - a_j) n_j n_k e_i) / (e_i^2 - (a_i - a_k)(a_j - a_i) n_i^2),
//!
//! and the rotation over the whole step is the quaternion along
//!
//!   (cos eta, m_n (e_1 e_2 e_3 sin eta - t_n e_n^2 cos eta) / (e_n (e_n^2 + t_j t_k))),
//!   eta = nu h - t_1 t_2 t_3 int_0^h dh / (e_n^2 + t_j t_k).
//!
//! Both denominators are the same for each n. This is the discrete rotation of Moser
//! and Veselov with the moments 1/(x/I_n + y); the functions x and y of the step,
//! which Hairer and Vilmart give as series, are here in closed form.
//!
//! Sources: A. I. Bobenko, B. Lorbeer, Yu. B. Suris, J. Math. Phys. 39, 6668 (1998);
//! E. Hairer, G. Vilmart, J. Phys. A 39, 13225 (2006); for P: Abramowitz, Stegun, 18.
//! The closed form of both functions and their doubling are ours, checked against
//! Taylor series of 25 digits.

use super::FreeBody;
use crate::attitude::Attitude;
use crate::exact::batch::LOST;
use crate::frame::BodyVector;
use crate::inertia::PrincipalMoments;
use crate::math::{DoubleDouble, MOST_TURNS, larger, sinc_versine};
use core::f64::consts::TAU;

/// The longest (a_max - a_min) dt for the series, which then end below eps. The
/// functions of the step are doubled up to twice.
const PIECE: f64 = 0.6;

/// Beyond this many the closed form with its set-up is worth it: it adds up no errors.
const PIECES: f64 = 40.0;

/// The free rotation of a body, over short steps.
///
/// ```
/// use rotation_dynamics::attitude::Attitude;
/// use rotation_dynamics::exact::free_body::{FreeBody, FreeFlow};
/// use rotation_dynamics::{frame::BodyVector, inertia::PrincipalMoments};
/// let moments = PrincipalMoments::new(1.0, 2.0, 2.5)?;
/// let rates = BodyVector::new(0.8, 0.4, 0.3);
/// let motion = FreeBody::new(moments, Attitude::IDENTITY, rates)?;
/// let turn = FreeFlow::new(moments).turn(motion.body_momentum(rates), 0.3);
/// assert!(turn.angle_to(&motion.attitude(0.3)) < 1e-15);
/// # Ok::<(), rotation_dynamics::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeFlow {
    moments: PrincipalMoments,
    /// 1/I and what its rounding leaves out: rounded alone it would turn the body
    /// by eps too much per radian, always to the same side.
    inverse: [[f64; 2]; 3],
    /// The largest 1/I less the smallest.
    spread: f64,
}

impl FreeFlow {
    /// The free rotation of a body with these moments.
    pub fn new(moments: PrincipalMoments) -> Self {
        let inverse = moments.to_array().map(|i| {
            let inverse = DoubleDouble::from(1.0) / DoubleDouble::from(i);
            [inverse.hi(), inverse.lo()]
        });
        let [a, b, c] = inverse.map(|[inverse, _]| inverse);
        let spread = a.max(b).max(c) - a.min(b).min(c);
        Self { moments, inverse, spread }
    }

    /// The rotation during the time `dt` (s), on the body's axes before it:
    /// the attitude Q becomes `Q * turn`, and the momentum l on the body's axes
    /// `turn.to_body(l)`. `dt` may be negative; a momentum below 1e-154 turns nothing. NaN if that
    /// time is not finite or [so long](crate::exact#how-late) that the phase is lost.
    ///
    /// Accuracy: up to a turn of a few rad the quaternion is off by at most 8.8 eps of
    /// its distance from 1 (78 cases of `tests/exact/free_flow.rs`, needles, discs, spheres,
    /// axes and the separatrix among them); longer, by 9 eps a radian at most.
    ///
    /// Cost: as 1.3 derivatives of a [`Scene`](crate::scene::Scene) up to 0.6 rad of (1/I_min -
    /// 1/I_max) |L| dt, of 2 up to 2.4 rad.
    pub fn turn(&self, momentum: BodyVector, dt: f64) -> Attitude {
        let fastest = self.inverse.iter().fold(0.0, |most, [rate, _]| larger(most, *rate));
        let turned = (fastest * momentum.norm() * dt).abs();
        if turned.is_nan() || turned > MOST_TURNS * TAU {
            return Attitude::from_unit(LOST.0);
        }
        let [w, x, y, z] = self.increment(momentum.to_array(), dt);
        Attitude::from_unit([1.0 + w, x, y, z])
    }

    /// The quaternion of [`FreeFlow::turn`] less 1: as small as the step, and so its
    /// rounding.
    pub(crate) fn increment(&self, l: [f64; 3], dt: f64) -> [f64; 4] {
        let square = l[0] * l[0] + l[1] * l[1] + l[2] * l[2];
        let turn = self.spread * dt;
        let pieces = turn * turn * square * (1.0 / (PIECE * PIECE));
        if pieces > PIECES * PIECES {
            return self.long(l, dt);
        }
        if pieces > 16.0 {
            return self.several(l, square, dt, (0.25 * pieces.sqrt()).ceil());
        }
        let doublings = u32::from(pieces > 1.0) + u32::from(pieces > 4.0);
        // Also what is not a number: it shows.
        self.piece(&l, square, dt, doublings)
    }

    /// The increment over several pieces.
    #[inline(never)]
    fn several(&self, mut l: [f64; 3], square: f64, dt: f64, pieces: f64) -> [f64; 4] {
        let (mut sum, mut done) = ([0.0; 4], 0.0);
        while done < pieces {
            let more = self.piece(&l, square, dt / pieces, 2);
            // (1 + s)(1 + m) - 1 = s + (m + s m).
            let both = product(sum, more);
            sum = [0, 1, 2, 3].map(|i| sum[i] + (more[i] + both[i]));
            let [w, x, y, z] = more;
            l = Attitude::from_unit([1.0 + w, x, y, z])
                .to_body(crate::frame::SpaceVector::from_array(l))
                .to_array();
            done += 1.0;
        }
        sum
    }

    /// By the closed form with its set-up.
    #[cold]
    fn long(&self, l: [f64; 3], dt: f64) -> [f64; 4] {
        let moments = self.moments.to_array();
        let rates = BodyVector::from_array([0, 1, 2].map(|i| l[i] / moments[i]));
        // Refused only if a rate is not finite; then nothing is right any more.
        FreeBody::new(self.moments, Attitude::IDENTITY, rates).map_or([f64::NAN; 4], |motion| {
            let [w, x, y, z] = motion.attitude(dt).quaternion();
            [w - 1.0, x, y, z]
        })
    }

    /// The increment over a piece; `square` is the square of the length of `l`. The functions of
    /// the step are those for a shorter one, doubled.
    #[inline]
    fn piece(&self, &[l1, l2, l3]: &[f64; 3], square: f64, dt: f64, doublings: u32) -> [f64; 4] {
        if square == 0.0 {
            return [0.0; 4];
        }
        let h = if doublings == 0 { 0.5 * dt } else { 0.5 * dt / f64::from(1_u32 << doublings) };
        let per_length = 1.0 / square.sqrt();
        let (squares1, squares2, squares3) = (l1 * l1, l2 * l2, l3 * l3);
        let [a1, a2, a3] = self.inverse.map(|[a, rest]| h * a + h * rest);
        let mut d = [a1 - a2, a2 - a3, a3 - a1];
        let [d12, d23, d31] = d;
        // Differences first: nu - a_n would cancel for a body that is nearly a sphere.
        let t1 = d31 * squares3 - d12 * squares2;
        let t2 = d12 * squares1 - d23 * squares3;
        let t3 = d23 * squares2 - d31 * squares1;
        let (e12, e23, e31) = (d12 * t3, d23 * t1, d31 * t2);
        let eps1 = (e12 - e31) * THIRD;
        let eps2 = (e23 - e12) * THIRD;
        let eps3 = (e31 - e23) * THIRD;
        let poles = weierstrass(eps1, eps2, eps3);
        let sum =
            (poles[8] + (poles[7] + poles[6])) + ((poles[5] + poles[4]) + (poles[3] + poles[2]));
        // h^2 e_n^2 - 1.
        let mut s = [eps1, eps2, eps3].map(|eps| sum - eps);
        let mut e = s.map(|s| (1.0 + s).sqrt());
        // From here on t and nu are angles.
        let mut t = [t1 * per_length, t2 * per_length, t3 * per_length];
        let mut nu = (a1 * squares1 + a2 * squares2 + a3 * squares3) * per_length;
        let mut rest = small(t[0] * t[1] * t[2] * third_kind(&poles, t[1] * t[2] - eps1));
        if doublings > 0 {
            // h e_n - 1: the differences are what matters, and small.
            let mut less = [0, 1, 2].map(|i| s[i] / (1.0 + e[i]));
            let mut gaps = [e12, e23, e31];
            for _ in 0..doublings {
                rest = doubled_rest(rest, s, less, t);
                less = doubled(s, less, gaps);
                s = less.map(|e| e * (2.0 + e));
                t = t.map(|t| 2.0 * t);
                d = d.map(|d| 2.0 * d);
                gaps = gaps.map(|gap| 4.0 * gap);
                nu *= 2.0;
            }
            e = less.map(|e| 1.0 + e);
        }
        let (sin, cos) = turned_back(nu, rest);
        let s = s.map(|s| 1.0 + s);
        let ([s1, s2, s3], [e1, e2, e3], [t1, t2, t3], [d12, d23, d31]) = (s, e, t, d);
        let (e23, e31, e12) = (e2 * e3, e3 * e1, e1 * e2);
        let all = e1 * e23;
        // One division for the two common denominators and the three e.
        let first = s1 - d31 * d12 * squares1;
        let second = s1 + t2 * t3;
        let per = per_length / (first * second * all);
        let all = all * sin;
        let x = per * (l1 * e23 - d23 * l2 * l3 * e1) * e23 * (all - t1 * s1 * cos);
        let y = per * (l2 * e31 - d31 * l3 * l1 * e2) * e31 * (all - t2 * s2 * cos);
        let z = per * (l3 * e12 - d12 * l1 * l2 * e3) * e12 * (all - t3 * s3 * cos);
        let beside = x * x + y * y + z * z;
        let norm = (cos * cos + beside).sqrt();
        if cos > 0.0 {
            // cos/norm - 1 without cancellation.
            let both = 1.0 / (norm * (norm + cos));
            let scale = (norm + cos) * both;
            [-beside * both, x * scale, y * scale, z * scale]
        } else {
            let scale = 1.0 / norm;
            [cos * scale - 1.0, x * scale, y * scale, z * scale]
        }
    }
}

/// h e_n - 1 for twice the h: e_i(2h) = (e_i^4 - (eps_i - eps_j)(eps_i - eps_k)) / 2 e_1 e_2 e_3.
fn doubled([s1, s2, s3]: [f64; 3], e: [f64; 3], [e12, e23, e31]: [f64; 3]) -> [f64; 3] {
    let less = less_one(e);
    let per = 1.0 / (1.0 + less);
    [
        (s1 * (2.0 + s1) + e12 * e31 - less) * per,
        (s2 * (2.0 + s2) + e23 * e12 - less) * per,
        (s3 * (2.0 + s3) + e31 * e23 - less) * per,
    ]
}

/// h^3 e_1 e_2 e_3 - 1.
fn less_one([e1, e2, e3]: [f64; 3]) -> f64 {
    (e1 + e2 + e3) + (e1 * e2 + e2 * e3 + e3 * e1 + e1 * e2 * e3)
}

/// (sin, cos) of nu h - eta for twice the h, up to a common factor: with C = t_1 t_2 t_3,
/// tan(2 eta - eta') = 2 C / (P'' (e_n^2 + t_j t_k) / 4 e_1 e_2 e_3 - 2 e_1 e_2 e_3).
fn doubled_rest(
    (sin, cos): (f64, f64),
    s: [f64; 3],
    e: [f64; 3],
    [t1, t2, t3]: [f64; 3],
) -> (f64, f64) {
    let all = 1.0 + less_one(e);
    let [s1, s2, s3] = s.map(|s| 1.0 + s);
    let more = 2.0 * t1 * t2 * t3;
    let one = (s1 * s2 + s2 * s3 + s3 * s1) * (s1 + t2 * t3) / all - 2.0 * all;
    let (sin, cos) = (2.0 * sin * cos, cos * cos - sin * sin);
    (sin * one + cos * more, cos * one - sin * more)
}

const THIRD: f64 = 1.0 / 3.0;

/// h^2 P(h) = 1 + c_2 + c_3 + ..., from the three roots times h^2, whose sum is 0.
/// The first two places are for the 1 and the missing h^2.
#[inline]
fn weierstrass(e1: f64, e2: f64, e3: f64) -> [f64; 9] {
    let c2 = (e1 * e1 + e2 * e2 + e3 * e3) * (1.0 / 10.0);
    let c3 = e1 * e2 * e3 * (1.0 / 7.0);
    let (c22, c33) = (c2 * c2, c3 * c3);
    [
        1.0,
        0.0,
        c2,
        c3,
        c22 * (1.0 / 3.0),
        c2 * c3 * (3.0 / 11.0),
        (2.0 * c22 * c2 + 3.0 * c33) * (1.0 / 39.0),
        c22 * c3 * (2.0 / 33.0),
        c2 * (11.0 * c22 * c2 + 36.0 * c33) * (5.0 / 7293.0),
    ]
}

/// (sin, cos) of a small angle.
#[inline]
fn small(rest: f64) -> (f64, f64) {
    // |rest| < 0.01: what is dropped is below eps^2.
    let square = rest * rest;
    (
        rest - rest * square * (1.0 / 6.0 - square * (1.0 / 120.0)),
        1.0 - square * (0.5 - square * (1.0 / 24.0)),
    )
}

/// (sin, cos) of nu less the angle that comes later.
#[inline]
fn turned_back(nu: f64, (s, c): (f64, f64)) -> (f64, f64) {
    let (sinc, versine) = sinc_versine(nu * nu);
    let (sin, cos) = (nu * sinc, 1.0 - nu * nu * versine);
    (sin * c - cos * s, cos * c + sin * s)
}

/// int_0^1 du u^2 / (1 + k u^2 + c_2 u^4 + c_3 u^6 + ...), by Gauss's rule of nine
/// nodes, of which four are needed: exact to u^17.
#[inline]
fn third_kind(c: &[f64; 9], k: f64) -> f64 {
    let mut sum = 0.0;
    for (powers, weight) in POWERS.iter().zip(&WEIGHTS) {
        let low = (c[2] * powers[2] + c[3] * powers[3]) + (c[4] * powers[4] + c[5] * powers[5]);
        let high = c[6] * powers[6] + c[7] * powers[7];
        sum += weight / (1.0 + (k * powers[1] + (low + high)));
    }
    sum
}

/// The squares of the positive nodes.
const SQUARES: [f64; 4] = [
    0.105_140_282_589_089_78,
    0.376_224_514_453_174_9,
    0.698_948_012_417_800_8,
    0.937_334_249_363_463_9,
];

/// The weights times the squares.
const WEIGHTS: [f64; 4] = [
    0.032_840_259_945_862_094,
    0.098_048_132_715_498_17,
    0.126_263_672_864_602_08,
    0.076_181_267_807_371,
];

/// The powers of the squares.
const POWERS: [[f64; 8]; 4] = {
    let mut powers = [[1.0; 8]; 4];
    let mut i = 0;
    while i < 4 {
        let mut n = 1;
        while n < 8 {
            powers[i][n] = powers[i][n - 1] * SQUARES[i];
            n += 1;
        }
        i += 1;
    }
    powers
};

/// The quaternion product, with the terms subtracted from the first part summed first: the last bit
/// of long steps is better so.
fn product([a, b, c, d]: [f64; 4], [w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [
        a * w - (b * x + c * y + d * z),
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}
