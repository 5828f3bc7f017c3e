//! The piece of a recording that swings, without the rest, the lift and the hold before it and the stop after.

use super::course::{self, Numbers, STEP};
use super::{Candidate, Flight, Swing, principal};
use crate::error::{Error, Result};
use crate::frame::DesignVector;
use crate::math::{exp, sort_by_number};
use core::fmt;
use core::ops::Range;

/// Where the equation is seen to hold, as many steps of [`STEP`]/W are left out beside what does not swing. Held
/// at 170 degrees and let go, a pendulum is off its own past by `LEFT` of its speed within 0.23/W; a slow stop
/// in noise was seen 0.83/W too late, the latest of 500.
const INSIDE: f64 = 5.0;
/// The equation holds where means over [`STEP`]/W are off it by less than five of their standard deviations, or
/// by this part of the speed with which the swing passes the hanging position: two of a hundred are the wobble of
/// a hinge and what a swing ahead is not known by.
const LEFT: f64 = 0.02;
/// Of the squares of what swings, a pendulum leaves no more than this part: at 50 samples a second, with noise of
/// a sixth of the fastest rate, and a length of 1.3 m, it is a 65th.
const UNEXPLAINED: f64 = 0.05;
/// So many rows of half-swings, those of the largest rates, are tried: each takes a fit.
const TRIED: usize = 8;

/// A piece of a recording that swings, by [`Swing::find`].
#[derive(Debug, Clone, PartialEq)]
pub struct Swinging {
    /// Its samples.
    pub samples: Range<usize>,
    /// The times of the first and the last of them (s).
    pub between: [f64; 2],
    /// How many swings to and fro.
    pub swings: f64,
}

impl fmt::Display for Swinging {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [from, to] = self.between;
        write!(f, "from {from:.2} s to {to:.2} s: {:.1} swings to and fro", self.swings)
    }
}

/// A half-swing: samples between which the rate keeps its sign.
struct Half {
    /// The sample of its largest rate, and that rate, with its sign.
    peak: usize,
    rate: f64,
    /// Its middle (s), by the rates as weights, and their sum.
    middle: f64,
    weight: f64,
}

impl Swing {
    /// The piece of a recording that swings through the largest angle in all, from times (s) and the rates
    /// (rad/s) on the sensor's axes.
    ///
    /// Looked for are three half-swings or more, about an axis of the sensor or the principal axis, each 0.7 to
    /// 1.1 times as long and 0.5 to 1.1 times as fast as the one before. The pendulum that fits them is followed
    /// to both sides as far as the rates obey its equation, and fitted anew. Where that ends before the
    /// recording does, 1/W or more, a sixth of a small swing, is left out: it does not reach into a hold or stop.
    ///
    /// # Errors
    /// `Incompatible` if there is no such piece; those of [`Flight::new`] for times and rates that belong to none.
    pub fn find(times: &[f64], rates: &[DesignVector]) -> Result<Swinging> {
        let finite = rates.iter().all(|rate| rate.norm().is_finite());
        let rising =
            times.windows(2).all(|pair| (pair[1] - pair[0]).is_finite() && pair[0] < pair[1]);
        if times.len() != rates.len() || times.len() < 3 || !finite || !rising {
            Flight::new(times.to_vec(), rates.to_vec())?;
        }
        let (about, _) = principal(rates);
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(DesignVector::from);
        let mut rows = Vec::new();
        for axis in [about, x, y, z] {
            let along: Vec<f64> = rates.iter().map(|rate| rate.dot(&axis)).collect();
            rows.extend(in_row(times, &along));
        }
        sort_by_number(&mut rows, |(rates, _)| -rates);
        for core in rows.iter().take(TRIED).flat_map(|(_, tries)| tries) {
            if let Some(found) = grown(times, rates, core.clone()) {
                return Ok(found);
            }
        }
        // What is no recording at all is told first.
        Flight::new(times.to_vec(), rates.to_vec())?;
        let seen = rows.first().map_or("no three half-swings in a row".into(), |(_, tries)| {
            let [from, to] = [tries[0].start, tries[0].end - 1].map(|k| times[k]);
            format!("half-swings from {from:.2} s to {to:.2} s, but not those of a pendulum")
        });
        Err(Error::no_swing(format!(
            "nothing in this recording swings to and fro like a pendulum: there are {seen}. A swing that was \
             not found can be pointed out with --from and --to, in seconds"
        )))
    }
}

/// Rows of half-swings of which each follows from the one before: the sum of their rates, and pieces with which
/// a fit may begin, the best one first.
fn in_row(times: &[f64], rates: &[f64]) -> Vec<(f64, Vec<Range<usize>>)> {
    let quantile = |mut of: Vec<f64>, part: f64| {
        sort_by_number(&mut of, |one| *one);
        of[(part * (of.len() - 1) as f64) as usize]
    };
    let zero = quantile(rates.to_vec(), 0.5);
    // The median of |second differences| of noise, over its deviation, is 0.6745 sqrt(6).
    let bends = rates.windows(3).map(|w| (w[0] - 2.0 * w[1] + w[2]).abs()).collect();
    let noise = quantile(bends, 0.5) / 1.652;
    // Below a tenth of the swings that are sought, rates need not be followed here.
    let large = quantile(rates.iter().map(|rate| (rate - zero).abs()).collect(), 0.9);
    let least = (6.0 * noise).max(0.1 * large);
    let mut halves: Vec<Half> = Vec::new();
    for (k, rate) in rates.iter().map(|rate| rate - zero).enumerate() {
        if rate.abs() <= least {
            continue;
        }
        if halves.last().is_none_or(|half| half.rate * rate < 0.0) {
            halves.push(Half { peak: k, rate, middle: 0.0, weight: 0.0 });
        }
        let Some(half) = halves.last_mut() else { continue };
        if rate.abs() > half.rate.abs() {
            (half.peak, half.rate) = (k, rate);
        }
        half.weight += rate.abs();
        half.middle += (times[k] - half.middle) * rate.abs() / half.weight;
    }
    let follows = |k: &usize| {
        let [a, b, c] = [&halves[k - 2], &halves[k - 1], &halves[*k]];
        let slower = (c.rate - b.rate) / (a.rate - b.rate);
        let slack = 6.0 * noise / (a.rate - b.rate).abs();
        let later = (c.middle - b.middle) / (b.middle - a.middle);
        (0.5 - slack..=1.1 + slack).contains(&slower) && (0.7..=1.1).contains(&later)
    };
    // Half as fast as at most, for the last time before that: swinging for sure.
    let risen = |half: &Half| {
        let slow = |k: &usize| (rates[*k] - zero) / half.rate < 0.5;
        (0..half.peak).rev().find(slow).map_or(0, |k| k + 1)
    };
    let piece = |first: usize, last: usize| risen(&halves[first])..risen(&halves[last]);
    let (mut rows, mut first) = (Vec::new(), 0);
    while first + 2 < halves.len() {
        let last = (first + 2..halves.len()).take_while(follows).last();
        if let Some(last) = last {
            // At the ends may be the hand's lift and stop.
            let aside = (last + 1 - first) / 4;
            let inner = (first + aside, last - aside);
            let tries = [inner, (first, last), (first + 1, last), (first, last - 1)];
            let long = tries.into_iter().filter(|(first, last)| last - first >= 2);
            let swept = halves[first..=last].iter().map(|half| half.weight).sum();
            rows.push((swept, long.map(|(first, last)| piece(first, last)).collect()));
        }
        first = last.map_or(first, |last| last - 2) + 1;
    }
    rows
}

/// What swings around a piece that does, if it does.
fn grown(times: &[f64], rates: &[DesignVector], mut samples: Range<usize>) -> Option<Swinging> {
    loop {
        let here = times[samples.clone()].to_vec();
        let swing = Swing::of_sensor(here, rates[samples.clone()].to_vec()).ok()?;
        let (averaged, numbers) = swing.started().ok()?;
        let mut fits = [[true, true], [true, false]].into_iter();
        let fit = fits.find_map(|damped| Candidate::new(damped, numbers, &averaged).ok())?;
        let begin = [fit.numbers[1], fit.numbers[2]];
        if fit.squares > UNEXPLAINED * swing.whole(&averaged)
            || course::energy(&fit.numbers, begin) >= 1.0
        {
            return None;
        }
        let axis = swing.hinge()?.axis;
        let noise = 5.0 * (fit.squares / fit.residuals.len() as f64).sqrt();
        let [first, last, end] = [samples.start, samples.end - 1, times.len() - 1];
        let sample = |k: usize| (times[k], rates[k].dot(&axis));
        let before = (0..first).rev().map(sample).map(|(t, rate)| (times[first] - t, rate));
        let back = followed(&fit.numbers, -1.0, begin, noise, before);
        let states = course::states(&fit.numbers, swing.times.iter().copied()).ok()?;
        let after = (last + 1..=end).map(sample).map(|(t, rate)| (t - times[last], rate));
        let ahead = followed(&fit.numbers, 1.0, states[last - first], noise, after);
        let inside = INSIDE * STEP * exp(-0.5 * fit.numbers[0]);
        // Little more than that is no gain: the fit would creep along what no longer swings.
        let start = match back {
            Some(back) if back < 1.5 * inside => first,
            Some(back) => times.partition_point(|t| *t < times[first] - back + inside),
            None => 0,
        };
        let stop = match ahead {
            Some(ahead) if ahead < 1.5 * inside => last + 1,
            Some(ahead) => times.partition_point(|t| *t <= times[last] + ahead - inside),
            None => end + 1,
        };
        if (start..stop) == samples {
            let turns = states.windows(2).filter(|pair| pair[0][1] * pair[1][1] < 0.0);
            let (between, swings) = ([times[first], times[last]], 0.5 * turns.count() as f64);
            return Some(Swinging { samples, between, swings });
        }
        samples = start..stop;
    }
}

/// For how long (s) a pendulum goes on from this state, or went on before where `sense` is -1, by samples of
/// which the times count from there; `None` if it does to the last.
fn followed(
    numbers: &Numbers,
    sense: f64,
    [angle, rate]: [f64; 2],
    noise: f64,
    samples: impl Iterator<Item = (f64, f64)>,
) -> Option<f64> {
    // Back in time, dampings drive.
    let [log_square, _, _, offset, linear, quadratic] = *numbers;
    let numbers = [log_square, 0.0, 0.0, offset, sense * linear, sense * quadratic];
    let frequency = exp(0.5 * log_square);
    let (mut state, mut now) = ([angle, sense * rate], 0.0);
    // The last deviations of one sign: their sum, their number, and where they began.
    let (mut reached, mut before, mut sum, mut number) = (0.0, 0.0, 0.0, 0.0);
    let mut samples = samples.peekable();
    while let Some((from, _)) = samples.peek().copied() {
        let (mut time, mut rate, mut count, mut end) = (0.0, 0.0, 0.0_f64, from);
        while let Some((t, w)) = samples.next_if(|(t, _)| *t < from + STEP / frequency) {
            (time, rate, count, end) = (time + t, rate + w, count + 1.0, t);
        }
        time /= count;
        state = course::advanced(&numbers, state, time - now);
        now = time;
        let off = sense * state[1] + offset - rate / count;
        if off * sum <= 0.0 {
            (before, sum, number) = (reached, 0.0, 0.0);
        }
        (sum, number) = (sum + count * off, number + count);
        let speed = 2.0 * frequency * course::energy(&numbers, state).sqrt();
        let holds = |(sum, number): (f64, f64)| {
            (sum / number).abs() <= (LEFT * speed).max(noise / number.sqrt())
        };
        if ![(count * off, count), (sum, number)].into_iter().all(holds) {
            return Some(before);
        }
        reached = end;
    }
    None
}
