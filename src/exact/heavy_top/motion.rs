//! The motion in time: which half-period, which phases.
//!
//! A time is counted from a turning point in half-periods K/p in double-double
//! arithmetic, so that a late time loses only what its own last bit means. The
//! phases are written as (rate) t - (number of half-periods) (step), both reduced to
//! turns in the same way: near t = 0 they are near their initial values however fast
//! the body spins.

use super::rates::{RateRipple, RateWave};
use super::roots::{Conserved, Origin, Roots};
use super::series::{Pair, Series};
use super::waves::Zero;
use crate::exact::theta::{self, Periods};
use crate::math::{self, DoubleDouble as Dd};
use nalgebra::Complex;

/// A motion between two turning points.
#[derive(Debug, Clone)]
pub(super) struct Motion {
    pub(super) roots: Roots,
    pub(super) m: Dd,
    pub(super) m1: Dd,
    /// Time from a turning point to the next; infinite for the homoclinic motion.
    pub(super) half_period: Dd,
    pub(super) homoclinic: bool,
    per_half_period: f64,
    /// Time from the turning point number `first` to the start.
    pub(super) offset: Dd,
    pub(super) first: i64,
    pub(super) series: Series,
    pub(super) rates: Rates,
    /// z or w per time.
    pub(super) rate: Dd,
    pub(super) channels: [Channel; 2],
}

/// The transverse rate's series.
#[derive(Debug, Clone)]
pub(super) enum Rates {
    Trigonometric(RateWave),
    Hyperbolic(RateRipple),
}

/// The phase of one Cayley-Klein parameter, without the body's own spin.
#[derive(Debug, Clone, Copy)]
pub(super) struct Channel {
    /// Phase rate (rad per time).
    pub(super) rate: Dd,
    /// Lag per half-period (rad).
    pub(super) step: Dd,
    /// The sense of its turn at each passage: +1 or -1.
    pub(super) sign: f64,
    /// It reaches zero: the axis passes the pole.
    pub(super) reached: bool,
    /// Argument of the series at the start, and the half turns beyond it.
    pub(super) initial: f64,
    pub(super) initial_half_turns: f64,
}

/// A place on the time axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// Half-periods since the turning point `first`, the nearest one at the start.
    pub(super) count: f64,
    /// Full periods, counted so that -1, 0 and 1 alternate in sign.
    pub(super) period: i64,
    /// Near the turning point v2.
    pub(super) upper: bool,
    /// z or w from the nearest turning point.
    pub(super) x: f64,
}

impl Motion {
    /// The motion through `origin` with these roots, neither at rest nor upright.
    pub(super) fn new(conserved: &Conserved, origin: &Origin, roots: Roots) -> Box<Self> {
        let span = roots.span();
        let p = span.sqrt().scaled(0.5);
        let [m, m1] = roots.parameters(span);
        let periods = Periods::new(m, m1, 0.8);
        let quarter = periods.quarter;
        let homoclinic = !quarter.is_finite();
        let [a, b] = zeros(conserved, &roots, span, &periods);
        let sizes = [roots.y2.sqrt(), roots.x1.sqrt()];
        let matched = Series::matched(&periods.nome, &a, &b, sizes);
        let step = [&a, &b].map(|zero| match zero.place {
            theta::Zero::Along(angle) => angle.z * zero.sign,
            theta::Zero::Across(_) => Dd::ZERO,
        });
        let rate = Dd::FRAC_PI_2 * p / periods.nome.quarter;
        // The phase rates are matched where they do not cancel: that of a at the upper
        // turning point, (A+B)/2(1+v2), that of b at the lower one, (A-B)/2(1-v1).
        let turning = [conserved.sum / roots.y2, conserved.difference / roots.x1];
        let reached = [conserved.sum == 0.0, conserved.difference == 0.0 && roots.x2 == 0.0];
        let channels = [0, 1].map(|i| Channel {
            rate: turning[i].scaled(0.5) - rate * matched.slopes[i],
            step: step[i],
            sign: [a.sign, b.sign][i],
            reached: reached[i],
            initial: 0.0,
            initial_half_turns: 0.0,
        });
        // From the nearer one: rounding may choose the other by 4.3e-17 of a half-period, half of
        // what moves the quotient from 1/2, so the count at the start is 0.
        let (first, offset) = time_from_turning_point(origin, &roots, &periods, p);
        let half_period = if homoclinic { quarter } else { quarter / p };
        // The transverse rate at the lower turning point, +-(A - B v1)/sin(theta), times the
        // size that both series together have there.
        let far = roots.outer + roots.gravity.scaled(2.0);
        let spin = conserved.spin * roots.y1.sqrt() * a.sign;
        let turning = (spin - (far * roots.y2).sqrt()) / sizes[1];
        let nome = &periods.nome;
        let rates = match [a.place, b.place] {
            [theta::Zero::Along(of_a), theta::Zero::Along(of_b)] => {
                let size = Dd::from(2.0).sqrt() * nome.theta2();
                let zeros = [(a.sign, of_a), (b.sign, of_b)];
                Rates::Hyperbolic(RateRipple::new(nome, zeros, turning * size))
            }
            _ => {
                let size = nome.k1.scaled(2.0).sqrt();
                Rates::Trigonometric(RateWave::new(nome, &a, &b, turning * size))
            }
        };
        let mut motion = Box::new(Self {
            roots,
            m,
            m1,
            half_period,
            homoclinic,
            per_half_period: 1.0 / half_period.hi(),
            offset,
            first,
            series: matched.series,
            rates,
            rate,
            channels,
        });
        motion.set_start();
        motion
    }

    fn set_start(&mut self) {
        let place = self.place(0.0);
        let pair = self.series.at(place.upper, place.x);
        let arguments = self.arguments(&place, &pair);
        let half_turns = self.half_turns(&place);
        for (i, value) in [pair.a, pair.b].into_iter().enumerate() {
            // A start at the pole has no argument: the one towards the motion is 0.
            let gone = value.re == 0.0 && value.im == 0.0;
            if !gone {
                self.channels[i].initial = arguments[i];
                self.channels[i].initial_half_turns = half_turns[i];
            }
        }
    }

    /// Where the time `t` falls, if the phases are known there.
    #[inline]
    pub(super) fn place(&self, t: f64) -> Place {
        let since = self.offset + t;
        let (count, rest) = if self.homoclinic {
            (0.0, since.hi())
        } else {
            let count = nearest(since.hi() * self.per_half_period);
            let rest = since - self.half_period * count;
            // So late the quotient itself may be one off.
            let more = nearest(rest.hi() * self.per_half_period);
            (count + more, (rest - self.half_period * more).hi())
        };
        let index = (count as i64).saturating_add(self.first);
        Place { count, period: index >> 1, upper: index & 1 == 1, x: rest * self.rate.hi() }
    }

    /// Both series there.
    #[inline]
    pub(super) fn pair(&self, place: &Place) -> Pair {
        self.series.at(place.upper, place.x)
    }

    /// Both series and their derivatives by z or w.
    #[inline]
    pub(super) fn pair_with_slopes(&self, place: &Place) -> (Pair, Pair) {
        self.series.with_slopes(place.upper, place.x)
    }

    /// The arguments of both series without their whole turns: continuous in time
    /// once [`Self::turns`] is added.
    pub(super) fn arguments(&self, place: &Place, pair: &Pair) -> [f64; 2] {
        let argument = |value: Complex<f64>, channel: &Channel| {
            if channel.reached {
                // A signed real factor: a half turn at each passage.
                if value.re < 0.0 { -core::f64::consts::PI } else { 0.0 }
            } else {
                math::atan2(value.im, value.re)
            }
        };
        let [a, b] = &self.channels;
        [
            argument(pair.a, a),
            // Near the upper turning point b is -H: its argument and half a turn.
            argument(if place.upper { -pair.b } else { pair.b }, b),
        ]
    }

    /// Half turns of the arguments at a place, beyond [`Self::arguments`].
    pub(super) fn half_turns(&self, place: &Place) -> [f64; 2] {
        let [a, b] = &self.channels;
        [place.period as f64 * a.sign, (place.period + i64::from(place.upper)) as f64 * b.sign]
    }
}

/// The whole number nearest to `x`, a tie to the even one. Without a call: adding
/// 1.5 * 2^52 leaves no room for a fraction.
#[inline]
pub(super) fn nearest(x: f64) -> f64 {
    const SHIFT: f64 = 6_755_399_441_055_744.0;
    if x.abs() < 2_251_799_813_685_248.0 { (x + SHIFT) - SHIFT } else { x.round() }
}

/// The zeros of both parameters: sc^2(eta_a|m1) = (1+v1)/(v2-v1) and
/// sc^2(eta_b|m1) = (1-v2)(v3-v1)/((v2-v1)(v3-1)); from the other side, K' - eta, they are
/// 1/(m sc^2(eta|m1)), in which the gap v2 - v1 cancels.
fn zeros(conserved: &Conserved, roots: &Roots, span: Dd, periods: &Periods) -> [Zero; 2] {
    let kappa = roots.gravity / span;
    let near = roots.outer / span;
    let Roots { x2, y1, gap, .. } = *roots;
    let sign = |value: Dd| if value < 0.0 { -1.0 } else { 1.0 };
    let [of_a, of_b] =
        periods.zeros([[(y1, gap), (Dd::ONE, kappa * y1)], [(x2, gap * near), (near, kappa * x2)]]);
    [
        Zero { sign: sign(conserved.sum), place: of_a },
        Zero { sign: sign(conserved.difference), place: of_b },
    ]
}

/// The number of a turning point (even: v1, odd: v2) and the time since.
fn time_from_turning_point(origin: &Origin, roots: &Roots, periods: &Periods, p: Dd) -> (i64, Dd) {
    let (below, above) = roots.start;
    let state = match origin {
        Origin::Lower => return (0, Dd::ZERO),
        Origin::Upper => return (1, Dd::ZERO),
        Origin::State(state) => state,
    };
    if below == 0.0 {
        return (0, Dd::ZERO);
    }
    if above == 0.0 {
        // At v = 1 the motion leaves the pole: the zero before the lower turning point.
        let leaving = state.to_one == 0.0;
        return (if leaving { -1 } else { 1 }, Dd::ZERO);
    }
    let rising = if state.rate < 0.0 { -1.0 } else { 1.0 };
    match periods.nearer_end(below, above) {
        (false, since) => (0, since / p * rising),
        (true, until) => (1, -(until / p) * rising),
    }
}

#[cfg(test)]
mod tests {
    use crate::attitude::Attitude;
    use crate::exact::heavy_top::{Course, HeavyTop, ReducedTop};

    fn made([a, b, c]: [f64; 3], theta: f64, rate: f64) -> HeavyTop {
        ReducedTop::new(a, b, c)
            .and_then(|top| HeavyTop::from_angles(top, theta, rate, 0.3, -0.4))
            .expect("a motion")
    }

    /// Far from the homoclinic motion and beside it.
    const TOPS: [[f64; 3]; 2] = [[2.0, 1.2, 0.2], [2.0, 1.0001, 1.3]];

    /// Angles are made of the count of half-periods, attitudes of clocks: over many half-periods
    /// both are one.
    #[test]
    fn angles_count_half_periods_as_clocks_do() {
        for (top, theta, rate) in
            [(TOPS[0], 0.7, 0.1), (TOPS[0], 0.3, -0.2), (TOPS[1], 0.02, 0.0), (TOPS[1], 0.9, 0.4)]
        {
            let motion = made(top, theta, rate);
            for k in -40..=40 {
                let t = 0.77 * f64::from(k);
                let angles = Attitude::from_euler(motion.angles(t)).expect("finite");
                let off = angles.angle_to(&motion.attitude(t));
                assert!(off < 1e-13, "{off:e} at {t}");
            }
        }
    }

    /// A start half-way between two turning points may be counted from either: it is the start,
    /// and no neighbour is elsewhere later.
    #[test]
    fn a_start_half_way_is_the_start() {
        let mut starts = 0;
        for (top, k) in TOPS.into_iter().flat_map(|top| (1..=20).map(move |k| (top, k))) {
            let rate = 0.02 * f64::from(k);
            let first = |theta: f64| match made(top, theta, rate).course {
                Course::Moving { motion, .. } => {
                    assert_eq!(motion.place(0.0).count, 0.0);
                    motion.first
                }
                Course::Fixed { .. } => unreachable!("it moves"),
            };
            let (mut low, mut high) = (0.35_f64, 1.2_f64);
            if first(low) == first(high) {
                continue;
            }
            while high.to_bits() - low.to_bits() > 1 {
                let middle = f64::from_bits(low.to_bits() + (high.to_bits() - low.to_bits()) / 2);
                if first(middle) == first(low) {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            let later = made(top, low, rate).attitude(10.0);
            for bits in low.to_bits() - 9..high.to_bits() + 9 {
                let theta = f64::from_bits(bits);
                first(theta);
                let motion = made(top, theta, rate);
                let start = motion.angles(0.0);
                assert!((start.theta - theta).abs() < 1e-15);
                assert_eq!((start.phi, start.zeta), (0.3, -0.4));
                assert!(motion.attitude(10.0).angle_to(&later) < 1e-12);
                starts += 1;
            }
        }
        assert_eq!(starts, 380);
    }
}
