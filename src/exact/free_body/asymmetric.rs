//! Torque-free motion with three different moments: the set-up in double-double
//! arithmetic and the sample in plain f64.

use super::norm3;
use super::series::Series;
use crate::attitude::Attitude;
use crate::exact::extended::{carlson_rf, complete_first_kind, first_kind};
use crate::frame::BodyVector;
use crate::math::DoubleDouble as Dd;
use crate::math::sincos;

/// Three different moments.
#[derive(Debug, Clone)]
pub(super) struct Asymmetric {
    /// Ordered axes: component r is `sign[r]` times body component `order[r]`; the
    /// third keeps its sign for ever (it goes as dn), and J1, J2, J3 are monotonic.
    order: [usize; 3],
    sign: [f64; 3],
    /// L/J on the ordered axes.
    rate: [f64; 3],
    /// +1 if J3 < J1, else -1: the sense in which the theta functions turn.
    sense: f64,
    series: Series,
    /// Time from the turning point of the first component to t = 0.
    start: Dd,
    /// 2K in time, None on the separatrix; and its reciprocal.
    pub(super) half_period: Option<Dd>,
    per_half_period: f64,
    /// What the azimuth of the third axis gains in a period of the rates (rad).
    pub(super) precession: f64,
    /// Turns (of 2 pi) gained in `half_period` beyond whole ones, and the local rate
    /// (rad/s) inside it.
    advance: Dd,
    local_rate: f64,
    /// l3 = c dn, dn^2 = m1 + m (l1/l1max)^2: the small l3 next to the separatrix
    /// keeps its relative accuracy, which |alpha|^2 - |beta|^2 would lose.
    c: f64,
    m1: f64,
    m_over_l1: f64,
    /// From the frame along L to space, and from the body to the ordered axes.
    outer: [f64; 4],
    inner: [f64; 4],
}

/// Cayley-Klein parameters in the frame along L.
pub(super) struct Sample {
    alpha: [f64; 2],
    beta: [f64; 2],
}

impl Asymmetric {
    pub(super) fn new(moments: [f64; 3], omega: [f64; 3], attitude: Attitude) -> Self {
        let mut order = [0, 1, 2];
        order.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
        let [lo, mid, hi] = order;
        let difference = |i: usize, j: usize| Dd::sum(moments[i], -moments[j]);
        let weighted = |i: usize, gap: Dd| Dd::product(omega[i], omega[i]) * moments[i] * gap;
        // L^2 - 2 E I_mid without its middle term, which would only cancel.
        let side = weighted(hi, difference(hi, mid)) - weighted(lo, difference(mid, lo));
        if side < 0.0 {
            order = [hi, mid, lo];
        }
        let [one, two, three] = order;
        // A proper rotation with the third ordered rate positive.
        let parity = if side < 0.0 { -1.0 } else { 1.0 } * permutation_sign([lo, mid, hi]);
        let third = if omega[three] < 0.0 { -1.0 } else { 1.0 };
        let sign = [1.0, parity * third, third];

        let j = order.map(|i| moments[i]);
        let (j1, j2, j3) = (Dd::from(j[0]), Dd::from(j[1]), Dd::from(j[2]));
        let (j31, j32, j21) = (
            difference(three, one),
            difference(three, two),
            difference(two, one),
        );
        let a = weighted(one, j31) + weighted(two, j32);
        let b = weighted(two, j21) + weighted(three, j31);
        let momentum = norm3([0, 1, 2].map(|i| Dd::product(moments[i], omega[i])));
        let amplitude1 = (a / (j1 * j31)).sqrt();
        let amplitude2 = (a / (j2 * j32)).sqrt();
        let amplitude3 = (b / (j3 * j31)).sqrt();
        let p = (j32 * b / (j1 * j2 * j3)).sqrt();
        let m = j21 * a / (j32 * b);
        let m1 = (j31 * side / (j32 * b)).abs();
        let sense = if j[2] < j[0] { 1.0 } else { -1.0 };

        // Amplitude at t = 0: tan = sn/cn, with sn = -sense w2/A2 and cn = w1/A1.
        let sn = amplitude1 * (sign[1] * omega[two] * -sense);
        let cn = amplitude2 * omega[one];
        let quarter = complete_first_kind(m1);
        let tau = first_kind(sn, cn, m1, quarter);

        let eta = {
            // sc^2(eta|m1) = J1 (J3-J2)/(J3 (J2-J1)), a constant of the body.
            let t2 = j1 * j32 / (j3 * j21);
            t2.sqrt() * carlson_rf(Dd::ONE, m * t2 + 1.0, t2 + 1.0)
        };
        // |beta|/|alpha| at tau = 0, and the phase rate of alpha there.
        let ratio = j1 * amplitude1 / (momentum + j3 * amplitude3);
        let rate = (amplitude3 + a / (j31 * (momentum + j3 * amplitude3))).scaled(0.5);
        let conjugate = complete_first_kind(m);
        let (series, argument_rate, winding) = Series::new(quarter, conjugate, eta, p, ratio);
        let local = rate - argument_rate * sense;
        let half_period = (m1 > 0.0).then(|| quarter.scaled(2.0) / p);
        // phi = arg alpha + arg beta; arg theta_1 falls by pi over each half period.
        let gained = half_period.map(|half| local * half + winding * sense);
        let precession = gained.map_or(f64::INFINITY, |gained| {
            (gained.scaled(4.0) - Dd::TWO_PI * sense).to_f64()
        });
        let advance = gained.map_or(Dd::ZERO, |gained| {
            let turns = gained / Dd::TWO_PI;
            turns - turns.round()
        });

        let first_max = (j1 * amplitude1 / momentum).to_f64();
        let mut motion = Self {
            order,
            sign,
            rate: [0, 1, 2].map(|r| (momentum / j[r]).to_f64()),
            sense,
            series,
            start: tau / p,
            half_period,
            precession,
            per_half_period: half_period.map_or(0.0, |half| half.recip().to_f64()),
            advance,
            local_rate: local.to_f64(),
            c: (j3 * amplitude3 / momentum).to_f64(),
            m1: m1.to_f64(),
            m_over_l1: if first_max == 0.0 {
                0.0
            } else {
                (m / (j1 * amplitude1 / momentum).square()).to_f64()
            },
            outer: Attitude::IDENTITY.quaternion(),
            inner: signed_permutation(order, sign),
        };
        let begin = Attitude::from_unit(motion.sample(0.0).quaternion())
            * Attitude::from_unit(motion.inner);
        motion.outer = (attitude * begin.inverse()).quaternion();
        motion
    }

    /// The closed form: reduce the time, sum two short series, turn by the phase.
    pub(super) fn sample(&self, t: f64) -> Sample {
        let since = self.start + t;
        let (rest, turns, odd) = match self.half_period {
            Some(half) => {
                let n = (since.to_f64() * self.per_half_period).round();
                let turns = self.advance * n;
                let turns = (turns - turns.to_f64().round()).to_f64();
                ((since - half * n).to_f64(), turns, n % 2.0 != 0.0)
            }
            None => (since.to_f64(), 0.0, false),
        };
        let (mut alpha, mut beta) = self.series.sum(rest);
        alpha[1] *= self.sense;
        // The constant phase of beta puts l1 > 0 at tau = 0; theta_1 changes sign over 2K.
        let flip = if (self.sense > 0.0) != odd { -1.0 } else { 1.0 };
        beta = [flip * beta[0], flip * self.sense * beta[1]];
        let size =
            (alpha[0] * alpha[0] + alpha[1] * alpha[1] + beta[0] * beta[0] + beta[1] * beta[1])
                .sqrt();
        let (sin, cos) = sincos(self.local_rate * rest + core::f64::consts::TAU * turns);
        let turn = |v: [f64; 2]| {
            [
                (v[0] * cos - v[1] * sin) / size,
                (v[0] * sin + v[1] * cos) / size,
            ]
        };
        Sample {
            alpha: turn(alpha),
            beta: turn(beta),
        }
    }

    pub(super) fn attitude(&self, sample: &Sample) -> Attitude {
        Attitude::from_unit(product(
            product(self.outer, sample.quaternion()),
            self.inner,
        ))
    }

    pub(super) fn angular_velocity(&self, sample: &Sample) -> BodyVector {
        // 2 alpha conj(beta) = l2 + i l1.
        let ([ar, ai], [br, bi]) = (sample.alpha, sample.beta);
        let l2 = 2.0 * (ar * br + ai * bi);
        let l1 = 2.0 * (ai * br - ar * bi);
        let l3 = self.c * (self.m1 + self.m_over_l1 * l1 * l1).sqrt();
        let ordered = [l1, l2, l3];
        let mut omega = [0.0; 3];
        for r in 0..3 {
            omega[self.order[r]] = self.sign[r] * self.rate[r] * ordered[r];
        }
        BodyVector::from_array(omega)
    }
}

impl Sample {
    pub(super) fn quaternion(&self) -> [f64; 4] {
        [self.alpha[0], self.beta[0], self.beta[1], self.alpha[1]]
    }
}

/// The quaternion product; the factors are unit to a few eps, and so is the result.
#[inline]
fn product(p: [f64; 4], q: [f64; 4]) -> [f64; 4] {
    let ([pw, px, py, pz], [qw, qx, qy, qz]) = (p, q);
    [
        pw * qw - px * qx - py * qy - pz * qz,
        pw * qx + px * qw + py * qz - pz * qy,
        pw * qy - px * qz + py * qw + pz * qx,
        pw * qz + px * qy - py * qx + pz * qw,
    ]
}

/// +1 for an even permutation of (0, 1, 2), -1 for an odd one.
fn permutation_sign([a, b, c]: [usize; 3]) -> f64 {
    if (a < b) ^ (b < c) ^ (a < c) {
        1.0
    } else {
        -1.0
    }
}

/// The rotation whose matrix has `sign[r]` in row `r`, column `order[r]`.
fn signed_permutation(order: [usize; 3], sign: [f64; 3]) -> [f64; 4] {
    let mut matrix = [[0.0; 3]; 3];
    for r in 0..3 {
        matrix[r][order[r]] = sign[r];
    }
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = matrix;
    // 4 q_i q_j for each i; the largest diagonal entry fixes the sign and divides.
    let products = [
        [1.0 + xx + yy + zz, zy - yz, xz - zx, yx - xy],
        [zy - yz, 1.0 + xx - yy - zz, xy + yx, xz + zx],
        [xz - zx, xy + yx, 1.0 - xx + yy - zz, yz + zy],
        [yx - xy, xz + zx, yz + zy, 1.0 - xx - yy + zz],
    ];
    let largest = (0..4).fold(0, |best, i| {
        if products[i][i] > products[best][best] {
            i
        } else {
            best
        }
    });
    let scale = 2.0 * products[largest][largest].sqrt();
    products[largest].map(|q| q / scale)
}
