//! Torque-free motion with three different moments: the set-up in double-double
//! arithmetic and the sample in plain f64.

use super::norm3;
use super::periods::Periods;
use super::series::{Parts, Series};
use crate::attitude::Attitude;
use crate::math::DoubleDouble as Dd;
use crate::math::double_double::{pair_plus, pair_sum, pair_times};
use crate::math::{Lane, round_even, sincos_turns};

/// Three different moments, on ordered axes: the third keeps the sign of its rate
/// for ever (it goes as dn), and J1, J2, J3 are monotonic.
#[derive(Debug, Clone)]
pub(super) struct Asymmetric {
    /// L/J on the ordered axes, with the sign; and where each body axis stands in that order.
    rate: [f64; 3],
    place: [usize; 3],
    /// +1 if J3 < J1, else -1: the sense in which the theta functions turn.
    sense: f64,
    pub(super) series: Series,
    /// Time from the turning point of the first component to t = 0.
    start: Dd,
    /// 2K in time and its reciprocal; None on the separatrix.
    pub(super) half_period: Option<(Dd, f64)>,
    /// What the azimuth of the third axis gains in a period of the rates (rad).
    pub(super) precession: f64,
    /// Turns gained in `half_period` beyond whole ones, and turns per second inside it.
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
pub(super) struct Sample<L> {
    alpha: [L; 2],
    beta: [L; 2],
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
        let periods = Periods::new(m, m1);
        let quarter = periods.quarter;
        let tau = periods.first_kind(sn, cn);
        // sc^2(eta|m1) = J1 (J3-J2)/(J3 (J2-J1)), a constant of the body, and that of K' - eta,
        // which is 1/(m sc^2(eta|m1)).
        let sizes = |num: Dd, den: Dd| (num.abs(), den.abs());
        let eta = periods.zero(sizes(j1 * j32, j3 * j21), sizes(b * j3, a * j1));

        // |beta|/|alpha| at tau = 0, and the phase rate of alpha there.
        let ratio = j1 * amplitude1 / (momentum + j3 * amplitude3);
        let rate = (amplitude3 + a / (j31 * (momentum + j3 * amplitude3))).scaled(0.5);
        let (series, argument_rate, winding) = Series::new(&periods, &eta, p, ratio);
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
            rate: [0, 1, 2].map(|r| sign[r] * (momentum / j[r]).to_f64()),
            place: invert(order),
            sense,
            series,
            start: tau / p,
            half_period: half_period.map(|half| (half, half.recip().to_f64())),
            precession,
            advance,
            local_rate: (local / Dd::TWO_PI).to_f64(),
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
    #[inline(always)]
    pub(super) fn sample(&self, t: f64) -> Sample<f64> {
        match (&self.series, self.half_period) {
            (Series::Trigonometric(series), Some((half, per_half))) => {
                self.periodic_sample(half, per_half, t, |fraction, _| series.sum(fraction))
            }
            (Series::Hyperbolic(series), Some((half, per_half))) => {
                self.periodic_sample(half, per_half, t, |_, rest| series.sum(rest))
            }
            (Series::Hyperbolic(series), None) => {
                let rest = (self.start + t).to_f64();
                self.turned(series.sum(rest), self.local_rate * rest, 1.0)
            }
            (Series::Trigonometric(_), None) => unreachable!("the separatrix is hyperbolic"),
        }
    }

    /// The sample where there is a period. `sum` is given the time from the turning
    /// point, as a fraction of 2K and in seconds. No branch.
    #[inline(always)]
    pub(super) fn periodic_sample<L: Lane>(
        &self,
        half: Dd,
        per_half: f64,
        t: L,
        sum: impl Fn(L, L) -> Parts<L>,
    ) -> Sample<L> {
        let since = pair_plus(self.start.lanes(), t);
        let n = round_even(since.0 * per_half);
        let (whole, whole_low) = pair_times(half.lanes(), n);
        let (rest, _) = pair_sum(since, (-whole, -whole_low));
        let turns = pair_times(self.advance.lanes(), n);
        let (turns, _) = pair_plus(turns, -round_even(turns.0));
        // theta_1 changes sign over 2K: -1 for odd n.
        let odd = n - round_even(n * 0.5 - 0.25) * 2.0;
        let parity = L::of(1.0) - odd * 2.0;
        let parts = sum(rest * per_half, rest);
        self.turned(parts, rest * self.local_rate + turns, parity)
    }

    /// alpha and beta, normalised, turned by the phase (in turns).
    #[inline(always)]
    fn turned<L: Lane>(&self, ([ar, ai], [br, bi]): Parts<L>, phase: L, parity: L) -> Sample<L> {
        // The constant phase of beta puts l1 > 0 at tau = 0.
        let flip = parity * -self.sense;
        let (ai, br, bi) = (ai * self.sense, br * flip, bi * flip * self.sense);
        let scale = L::of(1.0) / (ar * ar + ai * ai + (br * br + bi * bi)).sqrt();
        let (sin, cos) = sincos_turns(phase);
        let (sin, cos) = (sin * scale, cos * scale);
        Sample {
            alpha: [ar * cos - ai * sin, ar * sin + ai * cos],
            beta: [br * cos - bi * sin, br * sin + bi * cos],
        }
    }

    #[inline(always)]
    pub(super) fn quaternion<L: Lane>(&self, sample: &Sample<L>) -> [L; 4] {
        let (outer, inner) = (self.outer.map(L::of), self.inner.map(L::of));
        product(product(outer, sample.quaternion()), inner)
    }

    /// The body rates on the body's own axes.
    #[inline(always)]
    pub(super) fn rates<L: Lane>(&self, sample: &Sample<L>) -> [L; 3] {
        // 2 alpha conj(beta) = l2 + i l1.
        let ([ar, ai], [br, bi]) = (sample.alpha, sample.beta);
        let l2 = (ar * br + ai * bi) * 2.0;
        let l1 = (ai * br - ar * bi) * 2.0;
        let l3 = (l1 * self.m_over_l1 * l1 + self.m1).sqrt() * self.c;
        let ordered = [l1 * self.rate[0], l2 * self.rate[1], l3 * self.rate[2]];
        [0, 1, 2].map(|i| ordered[self.place[i]])
    }
}

impl<L: Lane> Sample<L> {
    #[inline(always)]
    pub(super) fn quaternion(&self) -> [L; 4] {
        [self.alpha[0], self.beta[0], self.beta[1], self.alpha[1]]
    }
}

/// The quaternion product; the factors are unit to a few eps, and so is the result.
#[inline(always)]
fn product<L: Lane>(p: [L; 4], q: [L; 4]) -> [L; 4] {
    let ([pw, px, py, pz], [qw, qx, qy, qz]) = (p, q);
    [
        pw * qw - px * qx - py * qy - pz * qz,
        pw * qx + px * qw + py * qz - pz * qy,
        pw * qy - px * qz + py * qw + pz * qx,
        pw * qz + px * qy - py * qx + pz * qw,
    ]
}

/// Where each index stands in a permutation.
fn invert(order: [usize; 3]) -> [usize; 3] {
    let mut place = [0; 3];
    for (r, i) in order.into_iter().enumerate() {
        place[i] = r;
    }
    place
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
