//! Attitude and rates at a time, without a branch, near the homoclinic motion, where the
//! series is hyperbolic.
//!
//! It runs from the nearest turning point by w, and either has its own:
//!
//!   lower: alpha ~ theta_1(y'_a + iw) e^{i psi_a}, beta ~ theta_4(y'_b + iw) e^{i psi_b},
//!          omega_1 + i omega_2 ~ theta_3(y'_b - y'_a + iw) conj(e^{i psi_a}) e^{i psi_b},
//!   upper: the same with theta_4, theta_1 and theta_2,
//!
//! all in q' and over the same theta_2(iw) or theta_3(iw). The phases lag by a step at each
//! passage half-way between turning points: they are what clocks of the time show less what
//! clocks of their number do.

use super::Turns;
use super::motion::Motion;
use super::rates::RateRipple;
use super::sample::Axis;
use crate::attitude::Attitude;
use crate::exact::batch::{Branchless, LOST, Sampled};
use crate::math::lane::{
    Constant, Cubics, Gathered, Number, Pair, Phased, Row, WIDEST, cubics, either,
};
use crate::math::{Clock, DoubleDouble as Dd, Reduced, STEEPEST, Time, exp, sinh_cosh_of};

/// A motion near the homoclinic one, or on it, ready to be sampled.
#[derive(Debug, Clone, Copy)]
pub(super) struct Late<V = f64> {
    /// The time in half-periods from an even one, where alpha has the series of type H.
    halves: Clock<V>,
    /// w in a half-period.
    width: V,
    /// The phases of alpha and beta in quarter turns, by the time, and their lag, by the number of
    /// half-periods.
    phases: Clock<[V; 2]>,
    lags: Clock<[V; 2]>,
    /// 2 q' and 4 q': k = 2 q' cosh 2w = 2 q' + 4 q' sinh^2 w.
    nome: [V; 2],
    /// Polynomials in k for alpha and beta, in even half-periods and in odd ones: times sinh w
    /// and 1, or 1 and sinh w, the real parts, times cosh w and sinh w cosh w, or the other
    /// way round, the imaginary ones.
    re: [Cubics<V>; 2],
    im: [Cubics<V>; 2],
    /// Real and imaginary part of the transverse rate, around the lower turning point times 1
    /// and sinh w cosh w, around the upper one times cosh w and sinh w.
    rate: [Cubics<V>; 2],
    /// 1 if even half-periods are around the upper turning point, where gravity is turned.
    flipped: V,
    spin: V,
    /// False for the homoclinic motion, which has one turning point.
    periodic: bool,
    /// The greatest |t|.
    until: f64,
}

/// So many units of w count as a half-period where there is none.
const ENDLESS: f64 = 1_152_921_504_606_846_976.0; // 2^60

/// The factors of the series at a place.
struct Place<L: Phased> {
    sinh: L,
    cosh: L,
    /// 1, or all three times something.
    one: L,
    whole: L,
    phases: Reduced<L::Pair>,
}

impl Late {
    /// For a motion whose gravity is turned if `flip` < 0, with the phases of alpha and
    /// beta in `turns` and omega_3 = `spin`.
    pub(super) fn new(
        motion: &Motion,
        RateRipple([around_lower, around_upper]): &RateRipple,
        turns: &[Turns; 2],
        flip: f64,
        spin: f64,
    ) -> Self {
        let periodic = !motion.homoclinic;
        let (per, width) = if periodic {
            (motion.half_period.recip(), (motion.rate * motion.half_period).to_f64())
        } else {
            (motion.rate.scaled(1.0 / ENDLESS), ENDLESS)
        };
        let flipped = f64::from(u8::from(flip < 0.0));
        let begin = motion.first as f64 + flipped;
        let halves = Clock::new(per, motion.offset * per + begin);
        let phases = turns.map(|turn| {
            let start = turn.start + turn.lag * begin;
            let start = start - start.round();
            Clock::new(turn.rate.scaled(4.0), start.scaled(4.0))
        });
        let lags = turns.map(|turn| {
            let lag = turn.lag - turn.lag.round();
            Clock::new(lag.scaled(4.0), Dd::ZERO)
        });
        let mut until =
            phases.iter().fold(0.25 * halves.until(), |until, phase| until.min(phase.until()));
        if !periodic {
            let steep = STEEPEST / motion.rate.to_f64() - motion.offset.abs().to_f64();
            until = until.min(steep);
        }
        // In v. Gravity turned, alpha and beta are exchanged and the transverse rate becomes
        // minus its conjugate; the upper turning point stands first, half a turn further.
        let [lower, upper] = &motion.series.sides;
        let (even, odd, sign) =
            if flipped == 0.0 { (lower, upper, 1.0) } else { (upper, lower, -1.0) };
        let times = |p: &[f64; 4], factor: f64| p.map(|c| factor * c);
        // q' 2 sinh 2w = 4 q' sinh w cosh w.
        let nome = motion.series.nome;
        let four = 4.0 * nome;
        Self {
            halves,
            width,
            phases: phases[0].beside(&phases[1]),
            lags: lags[0].beside(&lags[1]),
            nome: [2.0 * nome, four],
            re: [
                cubics(&times(&even[0].re, sign), &times(&even[1].re, sign)),
                cubics(&odd[1].re, &odd[0].re),
            ],
            im: [
                cubics(&times(&even[0].im, sign), &times(&even[1].im, sign * four)),
                cubics(&times(&odd[1].im, four), &odd[0].im),
            ],
            rate: [
                cubics(&times(&around_lower.re, sign), &times(&around_lower.im, four)),
                cubics(&times(&around_upper.re, sign), &around_upper.im),
            ],
            flipped,
            spin,
            periodic,
            until,
        }
    }

    /// The greatest |t| at which the phases are known.
    pub(super) fn latest(&self) -> f64 {
        if self.periodic {
            return self.until;
        }
        self.phases.one(0).until().min(self.phases.one(1).until())
    }

    pub(super) fn attitude(&self, t: f64) -> Attitude {
        Attitude::from_unit(if t.abs() <= self.until { self.quaternion(t) } else { self.far(t).0 })
    }

    /// The unit quaternion at time `t`.
    #[inline(always)]
    pub(super) fn quaternion<L: Phased>(&self, t: L) -> [L; 4] {
        self.axis(&self.place(t, 0), 0).0.quaternion()
    }
}

impl<V: Constant> Late<V> {
    /// The place at time `t`, for |w| up to [`STEEPEST`].
    #[inline(always)]
    fn place<L: Phased>(&self, t: L, first: usize) -> Place<L> {
        let (w, whole, phases) = self.time(t, first);
        let (sinh, cosh) = sinh_cosh_of(w);
        Place { sinh, cosh, one: L::of(1.0), whole, phases }
    }

    /// w at time `t`, the parity of the half periods until then, and the phases.
    #[inline(always)]
    fn time<L: Phased>(&self, t: L, first: usize) -> (L, L, Reduced<L::Pair>) {
        let time = Time::new(t);
        let half = self.halves.at(&time, first);
        let lag = self.lags.both_at(&Time::new(half.count()), first);
        let phases = self.phases.both_at(&time, first).less(&lag);
        (half.rest * self.width.lane::<L>(first), half.whole, phases)
    }

    /// The axis, sinh w cosh w, and k.
    #[inline(always)]
    fn axis<L: Phased>(&self, place: &Place<L>, first: usize) -> (Axis<L>, L, L) {
        let Place { sinh, cosh, one, whole, phases } = *place;
        let [twice, four] = &self.nome;
        let k = twice.lane::<L>(first) + sinh * four.lane::<L>(first) * sinh;
        let both = sinh * cosh;
        let (re, im) = (L::Pair::new(sinh, one), L::Pair::new(cosh, both));
        let odd = L::Pair::new(whole, whole);
        let re = re.or_if_odd(re.swapped(), odd) * either(&self.re, whole, k, first);
        let im = im.or_if_odd(im.swapped(), odd) * either(&self.im, whole, k, first);
        (Axis::new(re, im, phases, whole), both, k)
    }

    #[inline(always)]
    fn all_of<L: Phased>(&self, place: &Place<L>, first: usize) -> ([L; 4], [L; 3]) {
        let (axis, both, k) = self.axis(place, first);
        let upper = place.whole + self.flipped.lane::<L>(first);
        let rate = either(&self.rate, upper, k, first);
        let factor = L::Pair::new(place.one, both)
            .or_if_odd(L::Pair::new(place.cosh, place.sinh), L::Pair::new(upper, upper));
        let (re, im) = (factor * rate).parts();
        let [p, q] = axis.transverse(re, im);
        (axis.quaternion(), [p, q, self.spin.lane(first)])
    }
}

impl<V: Constant> Branchless<V> for Late<V> {
    fn until(&self) -> f64 {
        self.until
    }

    #[inline(always)]
    fn all<L: Phased>(&self, t: L, first: usize) -> ([L; 4], [L; 3]) {
        self.all_of(&self.place(t, first), first)
    }
}

impl Sampled for Late {
    #[cold]
    fn far(&self, t: f64) -> ([f64; 4], [f64; 3]) {
        // Only the homoclinic motion is known where it is too steep for lanes.
        if self.periodic || t.is_nan() || t.abs() > self.latest() {
            return LOST;
        }
        let mut place = self.place(t, 0);
        let w = self.time(t, 0).0;
        if w.abs() > STEEPEST {
            // All three times e^-|w|.
            [place.sinh, place.cosh, place.one] = [0.5_f64.copysign(w), 0.5, exp(-w.abs())];
        }
        self.all_of::<f64>(&place, 0)
    }
}

impl Gathered for Late {
    type Rows = Late<Row>;
    fn gathered(each: [Self; WIDEST]) -> Late<Row> {
        Late {
            halves: Gathered::gathered(each.map(|of| of.halves)),
            width: each.map(|of| of.width),
            phases: Gathered::gathered(each.map(|of| of.phases)),
            lags: Gathered::gathered(each.map(|of| of.lags)),
            nome: Gathered::gathered(each.map(|of| of.nome)),
            re: Gathered::gathered(each.map(|of| of.re)),
            im: Gathered::gathered(each.map(|of| of.im)),
            rate: Gathered::gathered(each.map(|of| of.rate)),
            flipped: each.map(|of| of.flipped),
            spin: each.map(|of| of.spin),
            periodic: each.iter().all(|of| of.periodic),
            until: each.iter().fold(f64::INFINITY, |until, of| until.min(of.until)),
        }
    }
}
