//! Which pieces of a recording are free flight.
//!
//! In flight no torque acts: d(J w)/dt + w x J w = 0 on the phone's axes. Over 20 ms that is
//! J (w' - w) + integral of w x J w dt = 0, linear in the six elements of the tensor J. The tensor that makes
//! the sum of squares of the left side least, in units of the sum of squares of J w times 20 ms, is an
//! eigenvector of two matrices of six by six, which are sums over the samples. The eigenvalue is the mean
//! square of |torque|/|L|: about the noise in flight, above 1/s in a hand.
//!
//! So the 120 ms of least torque begin a piece, which grows by 20 ms as long as one tensor explains
//! it. Its ends are then found sample by sample, and cut: 20 ms at the beginning, where a hand lets go by
//! and by, 10 ms at the end.
//!
//! Where accelerations are recorded, those of a flight are dw/dt x r + w x (w x r), with r the place of the
//! accelerometer from the centre of mass: zero but for the turning. A piece for which no r explains them
//! is carried by a hand or a table. The recorded |a| itself may be large: at 20 rad/s and 3 cm it is
//! 12 m/s^2.

use super::columns::GRAVITY;
use super::read::GAP;
use super::{FEWEST, Recording, middle, refused};
use crate::error::Result;
use core::ops::Range;
use rotation_dynamics::nalgebra::{Matrix3, Matrix6, SymmetricEigen, Vector3, Vector6};

/// What turns more slowly is no throw that would tell moments (rad/s).
const SLOWEST: f64 = 3.0;

/// The time over which torque is measured (s): a catch takes as long.
const LAG: f64 = 0.02;

/// The lags with which a flight begins to be found: eighteen independent equations for five ratios.
const SEED: usize = 6;

/// The shortest flight (s): with 30 ms cut from 0.18 s, in which a phone falls 16 cm.
const SHORTEST: f64 = 0.15;

/// The longest (s): a throw 11 m high. What turns on a table may turn longer.
const LONGEST: f64 = 3.0;

/// The most torque of a flight, |torque|/|L| (1/s). A hand that takes a second to give or take L
/// has as much; noise of 0.1 rad/s at 10 rad/s has 0.7.
const MOST: f64 = 1.0;

/// A flight ends where torque is this many times its mean, twice in a row: by chance that happens once
/// in ten million samples.
const ENDS: f64 = 3.5;

/// The most that accelerations may be off in flight (m/s^2), as a root of the mean square. A phone
/// that is carried is off by one g.
const MOST_OFF: f64 = 0.3 * GRAVITY;

/// A piece in free flight.
#[derive(Debug, Clone, PartialEq)]
pub struct Flight {
    /// Which samples.
    pub samples: Range<usize>,
    /// The root of the mean square of |torque|/|L| over 20 ms (1/s): what is left by noise.
    pub torque: f64,
}

/// Sums over samples from which the tensor follows.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    torque: Matrix6<f64>,
    momentum: Matrix6<f64>,
    count: f64,
}

impl Sums {
    fn with(&self, other: &Self) -> Self {
        Self {
            torque: self.torque + other.torque,
            momentum: self.momentum + other.momentum,
            count: self.count + other.count,
        }
    }

    /// The tensor of least torque.
    fn tensor(&self) -> Option<Vector6<f64>> {
        // Directions that no rate has are given a millionth, so that none is without momentum.
        let floor = 1e-6 * self.momentum.trace();
        let scale = (self.momentum + Matrix6::identity() * floor).cholesky()?.l();
        let half = scale.solve_lower_triangular(&self.torque)?;
        let whole = scale.solve_lower_triangular(&half.transpose())?;
        let eigen = SymmetricEigen::new(0.5 * (whole + whole.transpose()));
        let least = eigen.eigenvectors.column(eigen.eigenvalues.imin()).into_owned();
        scale.transpose().solve_upper_triangular(&least)
    }

    /// The root of the mean square of |torque|/|L| with this tensor.
    fn size(&self, tensor: &Vector6<f64>) -> f64 {
        let of = |matrix: &Matrix6<f64>| tensor.dot(&(matrix * tensor)).max(0.0);
        (of(&self.torque) / of(&self.momentum)).sqrt()
    }

    /// The part of that which noise of this standard deviation makes: 2 noise^2 |J|^2/|L dt|^2 in the mean
    /// square, with the sum |J|^2 of the squares of all nine elements.
    fn by_noise(&self, tensor: &Vector6<f64>, noise: f64) -> f64 {
        let [xx, yy, zz, xy, yz, zx] = (*tensor).into();
        let squares = xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + yz * yz + zx * zx);
        noise * (2.0 * self.count * squares / tensor.dot(&(self.momentum * tensor))).sqrt()
    }

    /// Whether there is torque beyond what noise makes, or noise hides it. (A tensor with hardly a moment about
    /// the axis of the rates turns all torque into noise.)
    fn is_forced(&self, tensor: &Vector6<f64>, noise: f64) -> bool {
        let (size, by_noise) = (self.size(tensor), self.by_noise(tensor, noise));
        size * size > MOST * MOST + by_noise * by_noise || by_noise > MOST
    }
}

/// Samples that turn fast, without a gap.
struct Fast<'a> {
    times: &'a [f64],
    rates: &'a [[f64; 3]],
    first: usize,
    /// Steps in a lag.
    lag: usize,
    /// Of a rate, its standard deviation (rad/s).
    noise: f64,
}

impl Fast<'_> {
    /// The equation of torque from sample k over a lag: for each element of the tensor, dL and L dt.
    fn equation(&self, k: usize) -> Sums {
        let rates = &self.rates[k..=k + self.lag];
        let w = rates.iter().map(|w| Vector3::from(*w));
        let change = Vector3::from(rates[self.lag]) - Vector3::from(rates[0]);
        let mean = w.sum::<Vector3<f64>>() / rates.len() as f64;
        let duration = self.times[k + self.lag] - self.times[k];
        let mut turned = [Vector3::zeros(); 6];
        for n in k..k + self.lag {
            let half = 0.5 * (self.times[n + 1] - self.times[n]);
            for w in [self.rates[n], self.rates[n + 1]].map(Vector3::from) {
                for (sum, own) in turned.iter_mut().zip(momenta(w)) {
                    *sum += half * w.cross(&own);
                }
            }
        }
        let (of_change, of_mean) = (momenta(change), momenta(mean));
        let mut sums = Sums { count: 1.0, ..Sums::default() };
        let sides = [0, 1, 2, 3, 4, 5].map(|e| of_change[e] + turned[e]);
        for i in 0..6 {
            for j in 0..6 {
                sums.torque[(i, j)] = sides[i].dot(&sides[j]);
                sums.momentum[(i, j)] = duration * duration * of_mean[i].dot(&of_mean[j]);
            }
        }
        sums
    }

    fn equations(&self) -> usize {
        self.times.len().saturating_sub(self.lag)
    }

    fn sums(&self, equations: Range<usize>) -> Sums {
        equations.fold(Sums::default(), |sums, k| sums.with(&self.equation(k)))
    }

    /// The torque of these sums with their own tensor, or of noise if that has more; none if a hand is in it.
    fn unforced(&self, sums: &Sums) -> Option<(f64, Vector6<f64>)> {
        let tensor = sums.tensor().filter(|tensor| !sums.is_forced(tensor, self.noise))?;
        Some((sums.size(&tensor).max(sums.by_noise(&tensor, self.noise)), tensor))
    }

    /// The flights in these samples.
    fn flights(&self, felt: Option<&[[f64; 3]]>, found: &mut Vec<Flight>) {
        let count = self.equations() / self.lag;
        let block = |n: usize| n * self.lag..(n + 1) * self.lag;
        let blocks: Vec<Sums> = (0..count).map(|n| self.sums(block(n))).collect();
        let seed = |n: usize| {
            let sums = blocks[n..n + SEED].iter().fold(Sums::default(), |sums, own| sums.with(own));
            Some((self.unforced(&sums)?.0, n, sums))
        };
        let mut seeds: Vec<_> =
            (0..(count + 1).saturating_sub(SEED)).step_by(2).filter_map(seed).collect();
        seeds.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut taken = vec![false; count];
        for (mut torque, seed, mut sums) in seeds {
            let mut piece = seed..seed + SEED;
            if taken[piece.clone()].contains(&true) {
                continue;
            }
            // One block more at either end, as long as one tensor explains it all as well as before.
            loop {
                let earlier = piece.start.checked_sub(1).map(|n| (n, n..piece.end));
                let ways = [Some((piece.end, piece.start..piece.end + 1)), earlier];
                let fitting = |(n, wider): (usize, Range<usize>)| {
                    let own = blocks.get(n).filter(|_| !taken[n])?;
                    let all = sums.with(own);
                    let (more, tensor) = self.unforced(&all)?;
                    let fits = more <= 2.0 * torque && own.size(&tensor) <= ENDS * torque;
                    fits.then_some((more, wider, all))
                };
                let Some(wider) = ways.into_iter().flatten().find_map(fitting) else { break };
                (torque, piece, sums) = wider;
            }
            taken[piece.clone()].fill(true);
            let flight = self.ends(block(piece.start).start..block(piece.end).start, felt);
            let Some(Flight { samples, torque }) = flight else { continue };
            let end = samples.end.div_ceil(self.lag).min(count);
            taken[(samples.start / self.lag).min(end)..end].fill(true);
            let samples = self.first + samples.start..self.first + samples.end;
            let apart = |other: &Flight| {
                other.samples.end <= samples.start || samples.end <= other.samples.start
            };
            if found.iter().all(apart) {
                found.push(Flight { samples, torque });
            }
        }
    }

    /// The flight to which these equations belong, with its ends.
    fn ends(&self, mut equations: Range<usize>, felt: Option<&[[f64; 3]]>) -> Option<Flight> {
        let (mut torque, mut forced) = (0.0, true);
        // The tensor of all of it tells the ends, and the ends the tensor.
        for _ in 0..3 {
            let sums = self.sums(equations.clone());
            let tensor = sums.tensor()?;
            torque = sums.size(&tensor);
            forced = sums.is_forced(&tensor, self.noise);
            let limit = ENDS * torque;
            let ended = |k: usize| self.equation(k).size(&tensor) > limit;
            let middle = (equations.start + equations.end) / 2;
            let all = self.equations();
            let end = (middle..all).find(|k| ended(*k) && (k + 1 == all || ended(k + 1)));
            let start = (0..middle).rev().find(|k| ended(*k) && (*k == 0 || ended(k - 1)));
            let next = start.map_or(0, |k| k + 1)..end.unwrap_or(all);
            if next == equations || next.len() < SEED {
                break;
            }
            equations = next;
        }
        // An equation ends a lag after it begins.
        let cut = self.lag.div_ceil(2);
        let mut samples = equations.start + self.lag..equations.end + self.lag - cut;
        if let Some(felt) = felt {
            samples = self.carried_by_none(samples, felt)?;
        }
        let duration = self.times[samples.end.checked_sub(1)?] - self.times[samples.start];
        let thrown = samples.len() >= FEWEST && (SHORTEST..=LONGEST).contains(&duration);
        (thrown && !forced).then_some(Flight { samples, torque })
    }

    /// The samples whose accelerations come from turning alone, around the middle of these.
    fn carried_by_none(&self, samples: Range<usize>, felt: &[[f64; 3]]) -> Option<Range<usize>> {
        let own = |k: usize| -> Matrix3<f64> {
            let (a, b) = (k.saturating_sub(1), (k + 1).min(self.times.len() - 1));
            let change = Vector3::from(self.rates[b]) - Vector3::from(self.rates[a]);
            let w = Vector3::from(self.rates[k]).cross_matrix();
            (change / (self.times[b] - self.times[a])).cross_matrix() + w * w
        };
        let recorded = |k: usize| Vector3::from(felt[self.first + k]);
        let mut squares = Matrix3::identity() * 1e-9;
        let mut products = Vector3::zeros();
        for k in samples.clone() {
            squares += own(k).transpose() * own(k);
            products += own(k).transpose() * recorded(k);
        }
        let place = squares.cholesky()?.solve(&products);
        let off = |k: usize| (recorded(k) - own(k) * place).norm();
        let square = samples.clone().map(|k| off(k) * off(k)).sum::<f64>() / samples.len() as f64;
        let middle = (samples.start + samples.end) / 2;
        let carried = |k: &usize| off(*k) > MOST_OFF.max(ENDS * square.sqrt().min(MOST_OFF));
        let end = (middle..samples.end).find(carried).unwrap_or(samples.end);
        let start = (samples.start..middle).rev().find(carried).map_or(samples.start, |k| k + 1);
        (square.sqrt() <= MOST_OFF).then_some(start..end)
    }
}

/// The angular momenta of these rates with tensors that have one element alone: xx, yy, zz, xy, yz, zx.
fn momenta(w: Vector3<f64>) -> [Vector3<f64>; 6] {
    let [x, y, z] = [w.x, w.y, w.z];
    [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z], [y, x, 0.0], [0.0, z, y], [z, 0.0, x]]
        .map(Vector3::from)
}

pub(super) fn find(recording: &Recording) -> Result<Vec<Flight>> {
    let (times, rates) = (recording.times(), recording.rates());
    let speed = |w: &[f64; 3]| Vector3::from(*w).norm();
    // Where noise hides what torque does in 20 ms, twice the time may show it.
    let found = [LAG, 2.0 * LAG].into_iter().map(|lag| flights(recording, lag));
    if let Some(found) = found.into_iter().find(|found| !found.is_empty()) {
        return Ok(found);
    }
    let fastest = (0..times.len()).max_by(|a, b| speed(&rates[*a]).total_cmp(&speed(&rates[*b])));
    let fastest = fastest.unwrap_or(0);
    Err(refused(format!(
        "no free flight was found: looked for {SHORTEST} s to {LONGEST} s, faster than {SLOWEST} rad/s, in which \
         the angular momentum changes by less than {MOST} of itself a second; the fastest rate is \
         {:.3} rad/s, at {:.3} s. A piece can be set by hand, from one time to another",
        speed(&rates[fastest]),
        times[fastest]
    )))
}

/// The flights by the torque over this time (s).
fn flights(recording: &Recording, lag: f64) -> Vec<Flight> {
    let (times, rates) = (recording.times(), recording.rates());
    let step = recording.step();
    let lag = ((lag / step).round() as usize).max(1);
    let speed = |w: &[f64; 3]| Vector3::from(*w).norm();
    let felt = recording.accelerations().filter(|felt| {
        // Accelerations without gravity are computed from the rates, and tell no more than these.
        let slow = felt.iter().zip(rates).filter(|(_, w)| speed(w) < 0.5);
        middle(slow.map(|(a, _)| speed(a)).collect()) > 0.5 * GRAVITY
    });
    // The fourth difference of noise has 70 times its variance, that of motion is smaller. Half of a normal
    // distribution lies within 0.6745 deviations.
    let fourth = |w: &[[f64; 3]], k: usize| {
        (w[4][k] - 4.0 * (w[3][k] + w[1][k]) + 6.0 * w[2][k] + w[0][k]).abs()
    };
    let differences = rates.windows(5).flat_map(|w| [0, 1, 2].map(|k| fourth(w, k))).collect();
    let raw = middle(differences) / (0.6745 * 70.0_f64.sqrt());
    // Means of samples within 5 ms of each have less noise, and still tell when a hand lets go.
    let around = (0.25 * LAG / step) as usize;
    let mean = |k: usize| {
        let near = k.saturating_sub(around)..(k + around + 1).min(rates.len());
        let sum = rates[near.clone()].iter().map(|w| Vector3::from(*w)).sum::<Vector3<f64>>();
        (sum / near.len() as f64).into()
    };
    let rates: Vec<[f64; 3]> = (0..rates.len()).map(mean).collect();
    let noise = raw / ((2 * around + 1) as f64).sqrt();
    // Straight lines bridge a gap as long as that of an equation.
    let longest = (GAP * step).max(LAG);
    let mut found = Vec::new();
    let mut first = 0;
    while first < times.len() {
        let joined = |k: &usize| {
            speed(&rates[*k]) >= SLOWEST && (*k == first || times[*k] - times[k - 1] <= longest)
        };
        let end = (first..times.len()).find(|k| !joined(k)).unwrap_or(times.len());
        let run = first..end;
        let fast = Fast { times: &times[run.clone()], rates: &rates[run], first, lag, noise };
        fast.flights(felt, &mut found);
        first = end.max(first + 1);
    }
    found.sort_by_key(|flight| flight.samples.start);
    found
}
