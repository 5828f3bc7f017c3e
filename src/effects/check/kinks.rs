//! Where the torque on the body as it starts has a kink in time.

use super::{Checked, ROUNDING};
use crate::frame::SpaceVector;

/// So many halvings of the time between two looks show the feature that bends the torque, after
/// some that come before. A kink is then bent less by 2^8, a root by 2^4, a power 3/2 by 2^12, a
/// smooth torque by 2^16, and a jump, or rounding, by no factor.
const HALVINGS: usize = 8;
const BEFORE: usize = 2;

/// A bend that falls by so much, at the least and at the most, is a kink or a cusp. (In the middle
/// of a piece it is bent twice as much as at its quarter.)
const LEAST: f64 = 4.0;
const MOST: f64 = 16_384.0;

/// Where halving ends because doubles hold no times between, rounding of the times bends the last
/// pieces, of so many. A bend by no more than so many times that does not count.
const LAST: usize = 8;
const ROUNDED: f64 = 16.0;

/// The first half of the halvings, and the second, by which it is bent less, are to each other within
/// this: else it is smooth down to rounding.
const ALIKE: f64 = 3.0;

/// Nearer to another or a known time than this part of the time between two looks a kink is that.
pub(crate) const NEAR: f64 = 1e-3;

/// A piece of time that is halved, with the torque at both ends and in the middle.
#[derive(Clone, Copy)]
struct Piece {
    times: [f64; 3],
    torques: [SpaceVector; 3],
}

impl Piece {
    /// How far the middle is off the chord: the second difference.
    fn bend(&self) -> f64 {
        let [low, middle, high] = self.torques;
        (low - middle * 2.0 + high).norm()
    }

    /// Its first half; none where doubles hold no time between.
    fn first_half(&self, torque: impl Fn(f64) -> SpaceVector) -> Option<Self> {
        let ([a, m, _], [low, middle, _]) = (self.times, self.torques);
        let before = 0.5 * (a + m);
        (before != a && before != m)
            .then(|| Self { times: [a, before, m], torques: [low, torque(before), middle] })
    }

    /// Of its two halves, and the one in its middle, that which is bent most; none where doubles
    /// hold no times between.
    fn most_bent(&self, torque: impl Fn(f64) -> SpaceVector) -> Option<Self> {
        let backwards = |piece: &Self| {
            let ([a, m, b], [low, middle, high]) = (piece.times, piece.torques);
            Self { times: [b, m, a], torques: [high, middle, low] }
        };
        let before = self.first_half(&torque)?;
        let after = backwards(&backwards(self).first_half(&torque)?);
        let between = Self {
            times: [before.times[1], self.times[1], after.times[1]],
            torques: [before.torques[1], self.torques[1], after.torques[1]],
        };
        [before, between, after]
            .into_iter()
            .max_by(|one, other| one.bend().total_cmp(&other.bend()))
    }

    /// The bend that is left when the time is halved until rounding alone bends it. If each time it
    /// was bent less by about the same, and by less than a smooth torque is, there is a kink, at
    /// this time.
    fn kink(mut self, rounding: f64, halved: impl Fn(&Self) -> Option<Self>) -> Option<f64> {
        let mut bends = Vec::new();
        let rounded = loop {
            let Some(half) = halved(&self) else {
                let last = bends.iter().rev().take(LAST);
                break ROUNDED * last.copied().fold(0.0, f64::max);
            };
            if half.bend() <= rounding {
                break rounding;
            }
            bends.push(half.bend());
            self = half;
        };
        let less = |bends: &[f64]| [0, HALVINGS / 2].map(|n| bends[n] / bends[n + HALVINGS / 2]);
        let kinked = |[before, after]: &[f64; 2]| {
            let alike = *before < ALIKE * after && *after < ALIKE * before;
            alike && (LEAST..=MOST).contains(&(before * after))
        };
        let windows = bends.get(BEFORE..)?.windows(HALVINGS + 1);
        let above = windows.take_while(|bends| bends[HALVINGS] > rounded);
        above.map(less).filter(kinked).last()?;
        Some(self.times[1])
    }
}

impl Checked<'_> {
    /// The times at which the torque that was [looked at](Self::looked) has a kink; of a known one, that.
    pub(crate) fn kinks(&self, seen: &[SpaceVector], known: &[f64]) -> Vec<f64> {
        let looks = seen.len() - 1;
        let size = seen.iter().map(SpaceVector::norm).fold(0.0, f64::max);
        let rounding = ROUNDING * size;
        let piece = |looked: [usize; 3]| Piece {
            times: looked.map(|n| self.look(n, looks)),
            torques: looked.map(|n| seen[n]),
        };
        let bend = |n: usize| {
            if (1..looks).contains(&n) { piece([n - 1, n, n + 1]).bend() } else { 0.0 }
        };
        // A kink is bent with what is around it, or against it.
        let extreme = |n: &usize| {
            let [before, here, after] = [n - 1, *n, n + 1].map(bend);
            here > before && here >= after || here < before && here <= after
        };
        let torque = |t: f64| self.torque_at_start(t);
        let inside = (1..looks).filter(extreme).filter_map(|n| {
            piece([n - 1, n, n + 1]).kink(rounding, |piece| piece.most_bent(torque))
        });
        let near = NEAR * ((self.span[1] - self.span[0]) / looks as f64).abs();
        let mut found: Vec<f64> = Vec::new();
        for at in inside {
            let is_near = |t: &&f64| (**t - at).abs() <= near;
            if !found.iter().any(|t| is_near(&t)) {
                found.push(known.iter().find(is_near).copied().unwrap_or(at));
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attitude::Attitude;
    use crate::body::{RigidBody, State};
    use crate::effects::Torque;
    use crate::frame::BodyVector;
    use crate::inertia::PrincipalMoments;
    use crate::math::{exp, pow, sin};
    use support::{Errors, assert_table};

    const SPAN: f64 = 10.0;

    /// The kinks of a torque of this size, on the way from 0 to the end of the span.
    fn kinks(size: impl Fn(f64) -> f64 + Send + Sync) -> Vec<f64> {
        on([0.0, SPAN], &[], size)
    }

    fn on(span: [f64; 2], known: &[f64], size: impl Fn(f64) -> f64 + Send + Sync) -> Vec<f64> {
        let moments = PrincipalMoments::new(1.0, 2.0, 2.5).expect("moments of a body");
        let body = RigidBody::new(moments);
        let start = body.state(Attitude::IDENTITY, BodyVector::new(0.1, 0.2, 0.3));
        let torque = Torque::on_body("torque", |t: f64, _: &RigidBody, _: &State| {
            BodyVector::new(0.3, -0.5, 0.8) * size(t)
        });
        let start = start.expect("a state");
        let checked = Checked::unlooked(&torque, &body, span, &start);
        checked.kinks(&checked.looked(4096), known)
    }

    /// At times inside the span, alone and in the middle of a wave: one is found, where it is.
    #[test]
    fn kinks_are_found_where_they_are() {
        // The blunter, the less of it is left where rounding begins.
        let off = [0.4, 0.5, 1.0, 1.5].map(|power| {
            let mut off = Errors::of(format!("time of a kink of power {power}"));
            for n in 1..40 {
                let t1 = SPAN * f64::from(n) / 40.0;
                for wave in [0.0, 1.0] {
                    let found = kinks(|t| pow((t - t1).abs(), power) + wave * sin(3.0 * t));
                    let [kink] = found[..] else { panic!("{power} {t1} {wave}: {found:?}") };
                    off.push_at(kink - t1, (power, t1));
                }
            }
            off
        });
        assert_table!(&off, @"
        time of a kink of power 0.4: 0 of 78
        time of a kink of power 0.5: 0 of 78
        time of a kink of power 1: 2.84e-14 of 78
        time of a kink of power 1.5: 1.86e-9 of 78
        ");
    }

    /// A weak one that bends against a strong one is found as well as one that bends with it.
    #[test]
    fn kinks_that_bend_against_others_are_found() {
        let mut found = 0;
        for n in 0..40 {
            let weak = 0.5 + 9.0 * (f64::from(n) * 0.618_033_988_749_894_9).fract();
            for size in [0.07, -0.07] {
                let both = kinks(|t| pow((t - 4.2).abs(), 1.5) + size * pow((t - weak).abs(), 1.5));
                let at = |t1: f64| both.iter().any(|kink| (kink - t1).abs() < 1e-6);
                found += u32::from(at(4.2)) + u32::from(at(weak));
            }
        }
        // One is 0.05 beside the strong one, against it, and is not.
        assert_eq!(found, 40 * 2 * 2 - 1);
    }

    /// So many of sixty whose sides are opposite are found: in the middle of a piece they do not bend it.
    #[test]
    fn odd_kinks_are_found_less_often() {
        let found = [0.5, 1.5].map(|power| {
            (0..60)
                .filter(|n| {
                    let t1 = 0.5 + 9.0 * (f64::from(*n) * 0.618_033_988_749_894_9).fract();
                    !kinks(|t| pow((t - t1).abs(), power).copysign(t - t1)).is_empty()
                })
                .count()
        });
        assert_eq!(found, [54, 19]);
    }

    /// A known time is the time of the kink beside it.
    #[test]
    fn a_known_time_is_taken_as_it_is() {
        let t1 = 3.7;
        let found = |known: &[f64]| on([0.0, SPAN], known, |t| pow((t - t1).abs(), 1.5));
        assert_eq!(found(&[t1]), [t1]);
        assert_ne!(found(&[]), [t1]);
    }

    /// A smooth torque has none, however its argument is rounded; nor has a jump.
    #[test]
    fn what_is_smooth_or_jumps_has_no_kinks() {
        let mut ran = 0;
        for n in 1..=60 {
            let rate = f64::from(n);
            let smooth = [
                kinks(|t| sin(rate * t)),
                kinks(|t| sin(rate * t) + sin(100.0 * rate * t)),
                kinks(|t| exp(-rate * (t - 3.0) * (t - 3.0))),
                kinks(|t| (rate * t).floor()),
            ];
            assert!(smooth.iter().all(Vec::is_empty), "{rate}: {smooth:?}");
            ran += 1;
        }
        assert_eq!(ran, 60);
    }
}
