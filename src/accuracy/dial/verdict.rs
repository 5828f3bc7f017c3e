//! What runs of a method, one finer than the other, say of the error of the last.

use super::method::LEVEL;
use crate::accuracy::larger;
use crate::math::{exp, log};

/// Attitudes further apart than this (rad) say nothing about an error yet.
pub(super) const APART: f64 = 0.5;

/// The part of the order that is trusted at least where the distance is as expected.
const TWO: f64 = 0.3;

/// Two runs nearer than this part of the error that is expected of the first are near by chance.
const CHANCE: f64 = 1.0 / 32.0;

/// Where a torque may have kinks, or jumps, at which no step ends, a run errs at each by what it
/// happens to be off, to either side, and runs may agree by chance on one error. Of three runs the
/// second distance then counts as no less than the first fallen by this part of the order,
pub(super) const OVER_KINKS: f64 = 0.5;
/// and what they say of an error so many times;
pub(super) const KINKED: f64 = 3.0;
/// of more runs the last distance as no less than the two before it fallen as of a smooth torque.
const SMOOTHLY: f64 = 0.7;

/// Two runs, one after the other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Gap {
    /// The angle (rad) between their ends.
    pub(super) apart: f64,
    /// By how many levels the second is finer.
    pub(super) step: f64,
}

/// What the last runs say together.
pub(super) struct Verdict {
    /// An upper estimate of the error of the last.
    pub(super) estimate: f64,
    /// The distance of the last two.
    apart: f64,
    /// By how much the last was finer than the one before.
    step: f64,
    /// By how much (in ln) the error falls with a level, as observed; never more than
    /// the order says.
    decay: f64,
    /// The part of the decay that is trusted.
    trust: f64,
}

impl Verdict {
    /// Of at least two runs, each finer than the one before, by what lies between them.
    ///
    /// An error that falls by a factor x from one run to the next is left with
    /// x/(1 - x) of the distance between the two. The factor is taken from the last
    /// three runs, but never better than a part of the order would have it
    /// ([`Method::trust`](super::method::Method::trust)); twice that is the estimate.
    /// Without a fall by half, or with two runs only, nothing is trusted but the
    /// distances themselves: nine times the largest, which is right for x <= 0.9.
    /// Where an error of the first run is `expected`, two runs are trusted like three, if they
    /// are apart as that says; nearer than a part of that they count as apart by that part.
    pub(super) fn of(trust: f64, gaps: &[Gap], expected: Option<f64>) -> Self {
        Self::counting(trust, gaps, expected, 0.0)
    }

    /// The same with a last distance that counts as no less than that.
    fn counting(trust: f64, gaps: &[Gap], expected: Option<f64>, least: f64) -> Self {
        let Some(&Gap { apart, step }) = gaps.last() else {
            return Self {
                estimate: f64::INFINITY,
                apart: f64::INFINITY,
                step: 1.0,
                decay: LEVEL,
                trust,
            };
        };
        let mut verdict = Self {
            estimate: 9.0 * apart,
            apart,
            step,
            decay: LEVEL,
            trust,
        };
        let mut sound = apart <= APART;
        if let ([_], Some(expected)) = (gaps, expected) {
            let left = exp(-trust.max(TWO) * LEVEL * step);
            // Runs that are nearer than that by more are near by chance.
            let apart = apart.max(CHANCE * expected);
            verdict.estimate = 9.0 * apart;
            if left <= 0.5 {
                verdict.estimate = verdict.estimate.min(2.0 * apart * left / (1.0 - left));
            }
        }
        if let [.., before, _] = gaps {
            let earlier = before.apart;
            sound &= !earlier.is_nan();
            let counted = apart.max(least);
            verdict.estimate = 9.0 * counted.max(earlier);
            let decay = log(earlier / apart) / before.step;
            verdict.decay = decay.clamp(0.25 * LEVEL, LEVEL);
            let left = exp(-decay.min(trust * LEVEL) * step);
            if left <= 0.5 && earlier < APART {
                verdict.estimate = verdict.estimate.min(2.0 * counted * left / (1.0 - left));
            }
        }
        // Nor does a distance that is NaN.
        if !sound {
            verdict.estimate = f64::INFINITY;
        }
        verdict
    }

    /// The same where steps may pass over kinks of the torque.
    pub(super) fn over_kinks(trust: f64, gaps: &[Gap], expected: Option<f64>) -> Self {
        let (fall, times) = if gaps.len() < 3 {
            (OVER_KINKS, KINKED)
        } else {
            (SMOOTHLY, 1.0)
        };
        let (mut least, mut levels) = (0.0, 0.0);
        for gap in gaps.iter().rev().skip(1).take(2) {
            levels += gap.step;
            least = larger(least, gap.apart * exp(-fall * LEVEL * levels));
        }
        let mut verdict = Self::counting(trust, gaps, expected, least);
        verdict.estimate *= times;
        verdict
    }

    /// What the distance of two runs is multiplied with if they are as expected.
    pub(super) fn factor(trust: f64, step: f64) -> f64 {
        let left = exp(-trust.max(TWO) * LEVEL * step);
        if left <= 0.5 {
            2.0 * left / (1.0 - left)
        } else {
            9.0
        }
    }

    /// The refinement with which the trusted part of the order is worth more than the distance.
    fn least(&self) -> f64 {
        (1.01 * core::f64::consts::LN_2 / (self.trust * LEVEL)).max(0.5)
    }

    /// How much finer the next run should be to be verified within `budget`.
    pub(super) fn ahead(&self, budget: f64) -> f64 {
        // The next distance if the next step is like this one, and what it must leave.
        let next = self.apart * exp(-self.decay * self.step);
        let left = 0.35 * budget / next;
        let trusted = self.trust * self.decay;
        (log((1.0 + left) / left) / trusted).clamp(self.least(), 2.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::sin;
    use support::{Errors, assert_error};

    /// Runs one level apart whose error falls by `x` from each to the next, from `first`.
    fn falling(first: f64, x: f64, runs: i32) -> (Vec<Gap>, f64) {
        let error = |n: i32| first * x.powi(n);
        let gap = |n: i32| Gap {
            apart: error(n) - error(n + 1),
            step: 1.0,
        };
        ((0..runs - 1).map(gap).collect(), error(runs - 1))
    }

    /// However slowly the error falls, up to x = 0.9, and however few the runs: the
    /// estimate covers it, and hardly more where the worst is all that is known.
    #[test]
    fn the_estimate_covers_what_is_left() {
        let mut covered = Errors::of("error over estimate");
        let mut ran = 0;
        for x in [0.01, 0.1, 0.3, 0.5, 0.7, 0.9] {
            for runs in 2..=5 {
                for trust in [0.12, 0.33, 0.5] {
                    let (gaps, error) = falling(1e-3, x, runs);
                    let estimate = Verdict::of(trust, &gaps, None).estimate;
                    assert!(
                        error <= estimate * (1.0 + 1e-12),
                        "{x} {runs}: {estimate:e}"
                    );
                    covered.push_at(error / estimate, (x, runs, trust));
                    ran += 1;
                }
            }
        }
        // Two runs at x = 0.9: nine times their distance is all of what is left.
        covered.attain(1.0..=1.0 + 1e-12, ran);
        assert_eq!(ran, 6 * 4 * 3);
    }

    /// What three runs say of an error that falls as the order has it, of which a part is trusted.
    #[test]
    fn an_error_that_falls_as_the_order_says_is_overestimated() {
        let over = |damage: f64| {
            let mut over = Errors::of("estimate over error");
            for (trust, levels) in [(0.5, 1.0), (0.33, 1.0), (0.12, 2.0)] {
                let (mut gaps, error) = falling(1e-3, exp(-LEVEL * levels), 3);
                gaps.iter_mut().for_each(|gap| gap.step = levels);
                let left = exp(-damage * trust * LEVEL * levels);
                let want = 2.0 * (exp(LEVEL * levels) - 1.0) * left / (1.0 - left);
                over.add(Verdict::of(trust, &gaps, None).estimate / error, want, want);
            }
            over
        };
        over(1.0).attain(2.0e-16..=2.1e-16, 3);
        over(0.9).exceed(0.05, 3);
    }

    /// Two runs say the least, and three that fall as the order has it say more.
    #[test]
    fn two_runs_are_trusted_least() {
        let (gaps, _) = falling(1e-3, 0.1, 3);
        assert_error!(
            Verdict::of(0.5, &gaps[..1], None).estimate,
            9.0 * gaps[0].apart,
            0.0
        );
        let three = Verdict::of(0.5, &gaps, None).estimate;
        assert!(three < 0.5 * 9.0 * gaps[1].apart, "{three:e}");
        // A fall that has not begun: the larger distance counts.
        let rising = [gaps[1], gaps[0]];
        assert_error!(
            Verdict::of(0.5, &rising, None).estimate,
            9.0 * gaps[0].apart,
            0.0
        );
    }

    /// Two runs as far apart as is expected are trusted; nearer ones count as a part of that,
    /// and without an expectation nothing but the distance does.
    #[test]
    fn two_runs_are_trusted_where_they_are_as_expected() {
        let (gaps, error) = falling(1e-3, exp(-LEVEL), 2);
        let estimate = |gaps: &[Gap], expected| Verdict::of(0.5, gaps, expected).estimate;
        let trusted = estimate(&gaps, Some(1e-3));
        let left = exp(-0.5 * LEVEL);
        assert_error!(trusted, 2.0 * gaps[0].apart * left / (1.0 - left), 0.0);
        assert!(error < 0.1 * trusted && trusted < 0.1 * estimate(&gaps, None));
        // The twin: they agree by chance, a thousand times too well.
        let chance = [Gap {
            apart: 1e-3 * gaps[0].apart,
            ..gaps[0]
        }];
        let mistrusted = estimate(&chance, Some(1e-3));
        let counted = CHANCE * 1e-3;
        assert_error!(mistrusted, 2.0 * counted * left / (1.0 - left), 0.0);
        assert!(mistrusted > 9.0 * chance[0].apart);
        assert!(estimate(&chance, Some(1e-4)) > estimate(&chance, Some(1e-5)));
        // Less of an order than that is not believed.
        let slow = Verdict::of(0.12, &gaps, Some(1e-3)).estimate;
        let least = Verdict::of(TWO, &gaps, Some(1e-3)).estimate;
        assert_error!(slow, least, 0.0);
    }

    /// Three runs whose last two agree by chance, and four: the error is that of the first at the
    /// level of the last. The damaged twin believes them.
    #[test]
    fn over_kinks_runs_that_agree_are_not_believed() {
        let (mut covered, mut damaged) = (Errors::of("error over estimate"), Errors::of("twin"));
        for runs in [3, 4] {
            let (mut gaps, error) = falling(1e-3, exp(-SMOOTHLY * LEVEL), runs);
            let last = gaps.len() - 1;
            gaps[last].apart *= 1e-3;
            covered.push_at(
                error / Verdict::over_kinks(0.33, &gaps, None).estimate,
                runs,
            );
            damaged.push_at(error / Verdict::of(0.33, &gaps, None).estimate, runs);
        }
        covered.attain(0.097..=0.098, 2);
        damaged.exceed(1.0, 2);
        // What falls as it should counts three times of three runs, and of four as it is.
        let (gaps, _) = falling(1e-3, exp(-SMOOTHLY * LEVEL), 4);
        let counted = |gaps: &[Gap]| Verdict::over_kinks(0.33, gaps, None).estimate;
        let plain = |gaps: &[Gap]| Verdict::of(0.33, gaps, None).estimate;
        let times = KINKED * exp((SMOOTHLY - OVER_KINKS) * LEVEL);
        let as_said = counted(&gaps[..2]) / plain(&gaps[..2]) / times;
        assert!((as_said - 1.0).abs() < 1e-14, "{as_said}");
        assert_eq!(counted(&gaps), plain(&gaps));
    }

    /// Errors in one direction that are thrown at random, of a size that falls with the level by this
    /// part of the order: how many answers are above a request, of those that are granted.
    fn above(fall: f64, verdict: impl Fn(&[Gap]) -> Verdict) -> f64 {
        const REQUESTS: u32 = 200_000;
        const ASKED: f64 = 1e-6;
        let mut seed = 1_u64;
        let mut part = || {
            seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = seed;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            (0.5 + ((z ^ (z >> 31)) >> 11) as f64) / 9_007_199_254_740_992.0
        };
        let (mut granted, mut wrong) = (0.0, 0.0);
        for _ in 0..REQUESTS {
            // The first is a tenth of what is asked, to a thousand times that.
            let (first, step) = (ASKED * exp(log(10.0) * (4.0 * part() - 1.0)), 0.7);
            let mut thrown = |n: i32| {
                let normal = (-2.0 * log(part())).sqrt() * sin(core::f64::consts::TAU * part());
                first * exp(-fall * LEVEL * step * f64::from(n)) * normal
            };
            let mut error = thrown(0);
            let mut gaps = Vec::new();
            for n in 1..9 {
                let finer = thrown(n);
                let apart = (finer - error).abs();
                gaps.push(Gap { apart, step });
                error = finer;
                if n > 1 && verdict(&gaps).estimate <= ASKED {
                    granted += 1.0;
                    wrong += if error.abs() > ASKED { 1.0 } else { 0.0 };
                    break;
                }
            }
        }
        wrong / granted
    }

    /// What is above a request by chance, with kinks in mind and without.
    #[test]
    fn chance_is_rarely_believed_over_kinks() {
        let counted = |fall| above(fall, |gaps| Verdict::over_kinks(0.33, gaps, None));
        let plain = |fall| above(fall, |gaps| Verdict::of(0.33, gaps, None));
        // Measured: 6e-5 and 1.7e-3, against 1.3e-2 and 3.5e-2.
        let [smooth, half] = [SMOOTHLY, 0.5].map(counted);
        assert!((3e-5..=1.5e-4).contains(&smooth), "{smooth:e}");
        assert!((1e-3..=2e-3).contains(&half), "{half:e}");
        let [smooth, half] = [SMOOTHLY, 0.5].map(plain);
        assert!((0.011..=0.015).contains(&smooth), "{smooth:e}");
        assert!((0.03..=0.04).contains(&half), "{half:e}");
    }

    /// A run as fine as is asked, by an error that falls as trusted, leaves seven tenths of
    /// the budget.
    #[test]
    fn the_next_run_is_as_fine_as_the_budget_asks() {
        let left = |damage: f64| {
            let mut left = Errors::of("estimate over budget, less seven tenths");
            for x in [0.05, 0.1, 0.2] {
                for trust in [0.33, 0.5] {
                    let (gaps, _) = falling(1e-3, x, 3);
                    let verdict = Verdict::of(trust, &gaps, None);
                    // Two thirds of the way between the least and the most it may ask for.
                    let decay = -trust * log(x);
                    let budget = 2.0 * x * gaps[1].apart / (exp(1.5 * decay) - 1.0) / 0.7;
                    let levels = verdict.ahead(damage * budget);
                    let fall = exp(-decay * levels);
                    let estimate = 2.0 * x * gaps[1].apart * fall / (1.0 - fall);
                    left.push_at(estimate / budget - 0.7, (x, trust));
                }
            }
            left
        };
        left(1.0).attain(2.2e-16..=2.3e-16, 6);
        left(0.9).exceed(0.05, 6);
    }

    #[test]
    fn what_says_nothing_is_no_estimate() {
        let gap = |apart: f64| Gap { apart, step: 1.0 };
        let mut ran = 0;
        for gaps in [
            &[][..],
            &[gap(f64::NAN)],
            &[gap(f64::NAN), gap(1e-9)],
            &[gap(1e-9), gap(f64::NAN)],
            &[gap(0.6)],
            &[gap(1e-9), gap(0.6)],
        ] {
            assert_eq!(
                Verdict::of(0.5, gaps, None).estimate,
                f64::INFINITY,
                "{gaps:?}"
            );
            ran += 1;
        }
        assert_eq!(ran, 6);
    }
}
