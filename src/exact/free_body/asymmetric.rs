//! Torque-free motion with three different moments: the set-up, in double-double
//! arithmetic.

use super::hyperbolic::Late;
use super::sample::{Rates, Sampler};
use super::series::Series;
use super::{near_one, norm3};
use crate::attitude::Attitude;
use crate::attitude::product::product;
use crate::body::Kinematics;
use crate::exact::batch::{Branchless, Sampled};
use crate::exact::theta::Periods;
use crate::math::{DoubleDouble as Dd, ilogb, order_of_three};

/// Three different moments, on ordered axes: the third keeps the sign of its rate
/// for ever (it goes as dn), and J1, J2, J3 are monotonic.
#[derive(Debug, Clone)]
pub(super) struct Asymmetric {
    /// 2K in time; None on the separatrix.
    pub(super) half_period: Option<Dd>,
    /// The gain of the azimuth of the third axis in a period of the rates (rad).
    pub(super) precession: f64,
    pub(super) form: Form,
}

/// In which form the theta functions converge fast.
#[derive(Debug, Clone)]
pub(super) enum Form {
    Trigonometric(Sampler),
    Hyperbolic(Late),
}

impl Asymmetric {
    pub(super) fn new(moments: [f64; 3], omega: [f64; 3], attitude: Attitude) -> Self {
        // Only ratios of the moments count, and the rates set the unit of time: with both
        // brought near one by powers of two, no square leaves the range of doubles.
        let (moments, _) = near_one(moments);
        let mut order = order_of_three(moments);
        let [lo, mid, hi] = order;
        let difference = |i: usize, j: usize| Dd::sum(moments[i], -moments[j]);
        let weighted = |rate: f64, i: usize, gap: Dd| Dd::product(rate, rate) * moments[i] * gap;
        // L^2 - 2 E I_mid without its middle term, which would only cancel. Near the middle
        // axis these two rates are small, and have a unit of their own.
        let saddle = Small::new(omega, [lo, hi]);
        let side = weighted(saddle.rates[1], hi, difference(hi, mid))
            - weighted(saddle.rates[0], lo, difference(mid, lo));
        if side < 0.0 {
            order = [hi, mid, lo];
        }
        let [one, two, three] = order;
        // So have those across the third axis, near that one.
        let across = Small::new(omega, [one, two]);
        let (omega, unit) = near_one(omega);
        // A proper rotation with the third ordered rate positive.
        let parity = if side < 0.0 { -1.0 } else { 1.0 } * permutation_sign([lo, mid, hi]);
        let third = if omega[three] < 0.0 { -1.0 } else { 1.0 };
        // On the separatrix the first keeps its sign too: it goes as sech there.
        let about_one = saddle.rates[usize::from(one == hi)];
        let turned = side == 0.0 && about_one < 0.0;
        let first = if turned { -1.0 } else { 1.0 };
        let sign = [first, first * parity * third, third];

        let j = order.map(|i| moments[i]);
        let (j1, j2, j3) = (Dd::from(j[0]), Dd::from(j[1]), Dd::from(j[2]));
        let (j31, j32, j21) =
            (difference(three, one), difference(three, two), difference(two, one));
        // In units of the square of `across.unit`; below in those of `unit`.
        let a = weighted(across.rates[0], one, j31) + weighted(across.rates[1], two, j32);
        let b = weighted(omega[two], two, j21) + weighted(omega[three], three, j31);
        let momentum = norm3([0, 1, 2].map(|i| Dd::product(moments[i], omega[i])));
        let amplitude1 = (a / (j1 * j31)).sqrt();
        let amplitude2 = (a / (j2 * j32)).sqrt();
        let amplitude3 = (b / (j3 * j31)).sqrt();
        let p = (j32 * b / (j1 * j2 * j3)).sqrt().scaled(unit);
        let m = j21 * a / (j32 * b);
        let m1 = (j31 * side / (j32 * b)).abs();
        let sense = if j[2] < j[0] { 1.0 } else { -1.0 };

        // Amplitude at t = 0: tan = sn/cn, with sn = -sense w2/A2 and cn = w1/A1.
        let sn = amplitude1 * (sign[1] * across.rates[1] * -sense);
        let per_unit = across.unit / unit;
        let shrunk = |x: Dd| x.scaled(per_unit);
        let (periods, tau) = if saddle.is_tiny(unit) {
            // The rate about `one` is in the unit of `m1`.
            let cn = amplitude2 * (first * about_one);
            Periods::beside_the_saddle(m1, saddle.ln_per(unit), sn, cn)
        } else {
            let m1 = saddle.squared(m1, unit);
            let cn = amplitude2 * (first * across.rates[0]);
            let periods = Periods::new(shrunk(shrunk(m)), m1, 0.5);
            let tau = periods.first_kind(sn, cn);
            (periods, tau)
        };
        let first_max = j1 * amplitude1 / momentum;
        let m_over_l1 = (m / first_max.square()).to_f64();
        let (a, amplitude1) = (shrunk(shrunk(a)), shrunk(amplitude1));
        let m1_size = saddle.squared(m1, unit);
        let quarter = periods.quarter;
        // sc^2(eta|m1) = J1 (J3-J2)/(J3 (J2-J1)), a constant of the body, and that of K' - eta,
        // which is 1/(m sc^2(eta|m1)).
        let sizes = |num: Dd, den: Dd| (num.abs(), den.abs());
        let eta = periods.zero(sizes(j1 * j32, j3 * j21), sizes(b * j3, a * j1));

        // |beta|/|alpha| at tau = 0, and the phase rate of alpha there.
        let ratio = j1 * amplitude1 / (momentum + j3 * amplitude3);
        let rate = (amplitude3 + a / (j31 * (momentum + j3 * amplitude3))).scaled(0.5 * unit);
        let (series, argument_rate, winding) = Series::new(&periods, &eta, p, ratio);
        let local = rate - argument_rate * sense;
        let half_period = (m1 > 0.0).then(|| quarter.scaled(2.0) / p);
        // phi = arg alpha + arg beta; arg theta_1 falls by pi over each half period.
        let gained = half_period.map(|half| local * half + winding * sense);
        let precession = gained
            .map_or(f64::INFINITY, |gained| (gained.scaled(4.0) - Dd::TWO_PI * sense).to_f64());
        let rates = Rates {
            rate: [0, 1, 2].map(|r| sign[r] * unit * (momentum / j[r]).to_f64()),
            place: invert(order),
            c: (j3 * amplitude3 / momentum).to_f64(),
            m1: m1_size.to_f64(),
            m_over_l1,
        };
        let start = tau / p;
        let mut form = match series {
            Series::Trigonometric(series) => {
                let sampler = Sampler::new(&series, sense, start, quarter / p, local, rates);
                Form::Trigonometric(sampler)
            }
            Series::Hyperbolic(series) => {
                let phase = (local, winding);
                let late = Late::new(&series, sense, start, half_period, phase, rates);
                Form::Hyperbolic(late)
            }
        };
        // The ordered axes stand in the body as `inner` says, L in space as it did at t = 0.
        let inner = signed_permutation(order, sign);
        let begin = form.kinematics(0.0).attitude * Attitude::from_unit(inner);
        let outer = (attitude * begin.inverse()).quaternion();
        form = match form {
            Form::Trigonometric(sampler) => Form::Trigonometric(
                sampler.seen(|quaternion| product(product(outer, quaternion), inner)),
            ),
            Form::Hyperbolic(late) => Form::Hyperbolic(late.seen(outer, inner)),
        };
        Self { half_period, precession, form }
    }

    /// The greatest |t| at which the phases are known.
    pub(super) fn latest(&self) -> f64 {
        match &self.form {
            Form::Trigonometric(sampler) => sampler.until(),
            Form::Hyperbolic(late) => late.until(),
        }
    }

    pub(super) fn attitude(&self, t: f64) -> Attitude {
        match &self.form {
            Form::Trigonometric(sampler) => sampler.attitude(t),
            Form::Hyperbolic(late) => late.attitude(t),
        }
    }

    pub(super) fn kinematics(&self, t: f64) -> Kinematics {
        self.form.kinematics(t)
    }

    /// The states at these times; both lists are equally long.
    pub(super) fn fill(&self, times: &[f64], states: &mut [Kinematics]) {
        match &self.form {
            Form::Trigonometric(sampler) => sampler.fill(times, states),
            Form::Hyperbolic(late) => late.fill(times, states),
        }
    }
}

impl Form {
    #[inline]
    fn kinematics(&self, t: f64) -> Kinematics {
        match self {
            Self::Trigonometric(sampler) => sampler.kinematics(t),
            Self::Hyperbolic(late) => late.kinematics(t),
        }
    }
}

/// Two rates in a unit of their own, a power of two: their squares keep their digits.
struct Small {
    rates: [f64; 2],
    unit: f64,
}

impl Small {
    fn new(omega: [f64; 3], [i, j]: [usize; 2]) -> Self {
        let ([first, second, _], unit) = near_one([omega[i], omega[j], 0.0]);
        Self { rates: [first, second], unit }
    }

    /// True if 1 - m, as the square of such a rate, is near the end of the range of doubles.
    fn is_tiny(&self, unit: f64) -> bool {
        const TINY: f64 = 4.909_093_465_297_727e-91; // 2^-300
        self.unit < TINY * unit
    }

    /// A square in this unit, in the other unit.
    fn squared(&self, square: Dd, unit: f64) -> Dd {
        let ratio = self.unit / unit;
        square.scaled(ratio).scaled(ratio)
    }

    /// ln(this unit/the other).
    fn ln_per(&self, unit: f64) -> Dd {
        Dd::LN_2 * f64::from(ilogb(self.unit) - ilogb(unit))
    }
}

/// The place of each index in a permutation.
fn invert(order: [usize; 3]) -> [usize; 3] {
    let mut place = [0; 3];
    for (r, i) in order.into_iter().enumerate() {
        place[i] = r;
    }
    place
}

/// +1 for an even permutation of (0, 1, 2), -1 for an odd one.
fn permutation_sign([a, b, c]: [usize; 3]) -> f64 {
    if (a < b) ^ (b < c) ^ (a < c) { 1.0 } else { -1.0 }
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
    let largest =
        (0..4).fold(0, |best, i| if products[i][i] > products[best][best] { i } else { best });
    let scale = 2.0 * products[largest][largest].sqrt();
    products[largest].map(|q| q / scale)
}
