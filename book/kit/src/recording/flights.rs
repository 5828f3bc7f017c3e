//! Which pieces of a recording are free flight.
//!
//! In flight no torque acts: d(J w)/dt + w x J w = 0 on the phone's axes. Over 20 ms that is
//! J (w' - w) + integral of w x J w dt = 0, linear in the six elements of the tensor J. The tensor that makes
//! the sum of squares of the left side least, in units of the sum of squares of J w times 20 ms, is an
//! eigenvector of two matrices of six by six ([`super::torque`]), which are sums over the samples. The eigenvalue is the mean
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
use super::torque::{Equation, MOST, Sums, Tensor, speed};
use super::{FEWEST, Recording, middle, refused};
use crate::error::Result;
use crate::number::short;
use core::f64::consts::SQRT_2;
use core::ops::Range;
use rotation_dynamics::nalgebra::{Matrix3, Vector3};

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

/// A flight ends where torque is this many times its mean, twice in a row: by chance that happens once
/// in ten million samples.
const ENDS: f64 = 3.5;

/// What straight lines between samples may leave as torque in a fast flip (1/s): of 1,278 made-up flights
/// fast flips ended two too soon at 0.1, none at 0.2.
const STRAIGHT: f64 = 0.2;

/// A piece goes on beyond so short a time (s) without equations that hold: a gap, stamps of time that are wrong, a flip
/// too fast for straight lines. No hand catches and throws in it.
const BRIDGE: f64 = 0.15;

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

/// Samples that turn fast.
struct Fast<'a> {
    times: &'a [f64],
    rates: &'a [[f64; 3]],
    /// To each sample, the integrals of x, y, z and of xx, yy, zz, xy, yz, zx, by straight lines.
    integrals: Vec<[f64; 9]>,
    first: usize,
    /// Steps in a lag.
    lag: usize,
    /// Of a rate, its standard deviation (rad/s).
    noise: f64,
}

impl<'a> Fast<'a> {
    fn new(times: &'a [f64], rates: &'a [[f64; 3]], first: usize, lag: usize, noise: f64) -> Self {
        let all = |[x, y, z]: [f64; 3]| [x, y, z, x * x, y * y, z * z, x * y, y * z, z * x];
        let mut integrals = vec![[0.0; 9]];
        for n in 1..times.len() {
            let half = 0.5 * (times[n] - times[n - 1]);
            let [mut sum, a, b] = [integrals[n - 1], all(rates[n - 1]), all(rates[n])];
            for k in 0..9 {
                sum[k] += half * (a[k] + b[k]);
            }
            integrals.push(sum);
        }
        Self { times, rates, integrals, first, lag, noise }
    }

    /// That from sample k.
    fn equation(&self, k: usize) -> Equation {
        let (from, to) = (&self.integrals[k], &self.integrals[k + self.lag]);
        let over = |n: usize| to[n] - from[n];
        let (xx, yy, zz) = (over(3), over(4), over(5));
        let (xy, yz, zx) = (over(6), over(7), over(8));
        let (a, b) = (&self.rates[k], &self.rates[k + self.lag]);
        let (dx, dy, dz) = (b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        // d(J w) + w x (J w) for each element.
        let torque = [
            [dx, zx, -xy],
            [-yz, dy, xy],
            [yz, -zx, dz],
            [dy - zx, dx + yz, xx - yy],
            [yy - zz, dz - xy, dy + zx],
            [dz + xy, zz - xx, dx - yz],
        ];
        let (x, y, z) = (over(0), over(1), over(2));
        let momentum =
            [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z], [y, x, 0.0], [0.0, z, y], [z, 0.0, x]];
        Equation { torque, momentum }
    }

    fn equations(&self) -> usize {
        self.times.len().saturating_sub(self.lag)
    }

    fn sums(&self, equations: impl Iterator<Item = usize>) -> Sums {
        let mut sums = Sums::default();
        equations.for_each(|k| sums.add(&self.equation(k)));
        for i in 0..6 {
            for j in i + 1..6 {
                sums.torque[i][j] = sums.torque[j][i];
                sums.momentum[i][j] = sums.momentum[j][i];
            }
        }
        sums
    }

    /// The torque of these sums with their own tensor, or of noise if that has more; none if it is more than this, or
    /// if a hand is in it.
    fn unforced(&self, sums: &Sums, most: f64) -> Option<(f64, Tensor)> {
        if sums.exceeds(most.min(SQRT_2 * MOST)) {
            return None;
        }
        let tensor = sums.tensor().filter(|tensor| !sums.is_forced(tensor, self.noise))?;
        let torque = sums.size(&tensor).max(sums.by_noise(&tensor, self.noise));
        (torque <= most).then_some((torque, tensor))
    }

    /// The flights in these samples.
    fn flights(&self, felt: Option<&[[f64; 3]]>, found: &mut Vec<Flight>) {
        let count = self.equations() / self.lag;
        let block = |n: usize| n * self.lag..(n + 1) * self.lag;
        let blocks: Vec<Sums> = (0..count).map(|n| self.sums(block(n))).collect();
        let seed =
            |n: usize| Some((self.unforced(&Sums::of(&blocks[n..n + SEED]), f64::INFINITY)?.0, n));
        let mut seeds: Vec<_> =
            (0..(count + 1).saturating_sub(SEED)).step_by(2).filter_map(seed).collect();
        seeds.sort_by(|a, b| a.0.total_cmp(&b.0));
        let longest = (LONGEST / self.step()) as usize;
        let mut taken = vec![false; count];
        for (mut torque, seed) in seeds {
            let mut piece = seed..seed + SEED;
            if taken[piece.clone()].contains(&true) {
                continue;
            }
            let mut sums = Sums::of(&blocks[piece.clone()]);
            // One block more at either end, as long as one tensor explains it all as well as before; no longer than
            // any flight.
            let (mut forward, mut stuck) = (true, 0);
            while stuck < 2 && piece.len() * self.lag <= longest {
                let n = if forward { Some(piece.end) } else { piece.start.checked_sub(1) };
                let wider = n.and_then(|n| {
                    let own = blocks.get(n).filter(|_| !taken[n])?;
                    let mut all = sums;
                    all.join(own);
                    let (more, tensor) = self.unforced(&all, 2.0 * torque)?;
                    (own.size(&tensor) <= ENDS * torque).then_some((n, more, all))
                });
                match wider {
                    Some((n, more, all)) => {
                        (torque, sums, stuck) = (more, all, 0);
                        piece = piece.start.min(n)..piece.end.max(n + 1);
                    }
                    None => (forward, stuck) = (!forward, stuck + 1),
                }
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
        let (mut sums, mut torque) = (self.sums(equations.clone()), 0.0);
        // The tensor of all of it tells the ends, and the ends the tensor.
        for _ in 0..3 {
            let tensor = sums.tensor()?;
            torque = sums.size(&tensor);
            if sums.is_forced(&tensor, self.noise) {
                return None;
            }
            let limit = (ENDS * torque).max(STRAIGHT);
            let middle = (equations.start + equations.end) / 2;
            let reach = (LONGEST / self.step()) as usize;
            let before: Vec<usize> = (middle.saturating_sub(reach)..middle).rev().collect();
            let after: Vec<usize> = (middle..self.equations().min(middle + reach)).collect();
            let [before, after] = [before, after].map(|way| {
                let sizes =
                    way.iter().map(|k| self.equation(*k).sizes(&tensor)).collect::<Vec<_>>();
                let free = |[left, l]: &[f64; 2]| *left <= limit * l;
                let count = self.belong(&sizes, free);
                way[..count].iter().copied().zip(sizes.iter().map(free)).collect::<Vec<_>>()
            });
            let next = middle - before.len()..middle + after.len();
            if next.len() > reach {
                return None;
            }
            if next == equations || next.len() < SEED {
                break;
            }
            equations = next;
            let free = before.into_iter().rev().chain(after).filter(|(_, free)| *free);
            sums = self.sums(free.map(|(k, _)| k));
        }
        // An equation ends a lag after it begins.
        let cut = self.lag.div_ceil(2);
        let mut samples = equations.start + self.lag..equations.end + self.lag - cut;
        if let Some(felt) = felt {
            samples = self.carried_by_none(samples, felt)?;
        }
        let duration = self.times[samples.end.checked_sub(1)?] - self.times[samples.start];
        let thrown = samples.len() >= FEWEST && (SHORTEST..=LONGEST).contains(&duration);
        thrown.then_some(Flight { samples, torque })
    }

    /// How many of these equations belong to the flight in which they begin: until two in a row do not hold, unless
    /// soon after four fifths of as many hold as half a seed has, and |L| is the same there.
    fn belong(&self, sizes: &[[f64; 2]], free: impl Fn(&[f64; 2]) -> bool) -> usize {
        let (half, bridge) = (SEED / 2 * self.lag, (BRIDGE / self.step()) as usize + self.lag);
        let momentum =
            |part: &[[f64; 2]]| part.iter().map(|[_, l]| l).sum::<f64>() / part.len() as f64;
        let mut n = 0;
        while n < sizes.len() {
            if free(&sizes[n]) || sizes.get(n + 1).is_some_and(&free) {
                n += 1;
                continue;
            }
            let goes_on = |m: &usize| {
                let beyond = sizes.get(*m..m + half);
                let beyond = beyond
                    .filter(|part| 5 * part.iter().filter(|own| free(own)).count() >= 4 * half)
                    .map(momentum);
                let own = momentum(&sizes[n.saturating_sub(half)..n]);
                let apart = (m - n + half) as f64 * self.step();
                beyond.is_some_and(|beyond| (beyond - own).abs() <= MOST * apart * own)
            };
            match (n + 2..=n + bridge).find(goes_on) {
                Some(m) => n = m + half,
                None => break,
            }
        }
        n
    }

    /// The mean step of time (s).
    fn step(&self) -> f64 {
        let last = self.times.len() - 1;
        (self.times[last] - self.times[0]) / last as f64
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

pub(super) fn find(recording: &Recording) -> Result<Vec<Flight>> {
    let (times, rates) = (recording.times(), recording.rates());
    // Where noise hides what torque does in 20 ms, twice the time may show it.
    let found = [LAG, 2.0 * LAG].into_iter().map(|lag| flights(recording, lag));
    if let Some(found) = found.into_iter().find(|found| !found.is_empty()) {
        return Ok(found);
    }
    let fastest = (0..times.len()).max_by(|a, b| speed(&rates[*a]).total_cmp(&speed(&rates[*b])));
    let fastest = fastest.unwrap_or(0);
    if let Some(limit) = recording.at_its_limit() {
        return Err(refused(format!("no free flight was found: {limit}")));
    }
    let step = recording.step();
    let coarse = match FEWEST as f64 * step > SHORTEST {
        false => String::new(),
        true => format!(
            ". A fit needs {FEWEST} samples: {} a second are too few for a flight of less than {:.1} s",
            short(1.0 / step, 3),
            FEWEST as f64 * step + 1.5 * LAG
        ),
    };
    Err(refused(format!(
        "no free flight was found, {SHORTEST} s to {LONGEST} s in which the phone turns freely and faster than \
         {SLOWEST} rad/s; the fastest rate is {} rad/s, at {} s{coarse}. A piece is set by hand with --from and --to, on the page with the fields \"from\" and \"to\"",
        short(speed(&rates[fastest]), 4),
        short(times[fastest], 5)
    )))
}

/// The flights by the torque over this time (s).
fn flights(recording: &Recording, lag: f64) -> Vec<Flight> {
    let (times, rates) = (recording.times(), recording.rates());
    let step = recording.step();
    let lag = ((lag / step).round() as usize).max(1);
    let felt = recording.accelerations().filter(|felt| {
        // Accelerations without gravity are computed from the rates, and tell no more than these.
        let slow = felt.iter().zip(rates).filter(|(_, w)| speed(w) < 0.5);
        middle(slow.map(|(a, _)| speed(a)).collect()) > 0.5 * GRAVITY
    });
    // The fourth difference of noise has 70 times its variance, that of motion is smaller. Half of a normal
    // distribution lies within 0.6745 deviations. Ten thousand tell it within a hundredth.
    let fourth = |w: &[[f64; 3]], k: usize| {
        (w[4][k] - 4.0 * (w[3][k] + w[1][k]) + 6.0 * w[2][k] + w[0][k]).abs()
    };
    let some = rates.windows(5).step_by(1 + rates.len() / 10_000);
    let differences = some.flat_map(|w| [0, 1, 2].map(|k| fourth(w, k))).collect();
    let raw = middle(differences) / (0.6745 * 70.0_f64.sqrt());
    // Means of samples within 5 ms of each have less noise, and still tell when a hand lets go.
    let around = (0.25 * LAG / step) as usize;
    let mean = |k: usize| {
        let near = &rates[k.saturating_sub(around)..(k + around + 1).min(rates.len())];
        let mut sum = [0.0; 3];
        for w in near {
            for i in 0..3 {
                sum[i] += w[i];
            }
        }
        sum.map(|sum| sum / near.len() as f64)
    };
    let rates: Vec<[f64; 3]> = (0..rates.len()).map(mean).collect();
    let noise = raw / ((2 * around + 1) as f64).sqrt();
    let longest = (GAP * step).max(BRIDGE);
    let mut found = Vec::new();
    let mut first = 0;
    while first < times.len() {
        let joined = |k: &usize| {
            speed(&rates[*k]) >= SLOWEST && (*k == first || times[*k] - times[k - 1] <= longest)
        };
        let end = (first..times.len()).find(|k| !joined(k)).unwrap_or(times.len());
        let run = first..end;
        if run.len() >= FEWEST {
            Fast::new(&times[run.clone()], &rates[run], first, lag, noise)
                .flights(felt, &mut found);
        }
        first = end.max(first + 1);
    }
    // Rates at the end of a range are wrong.
    let limited = recording.limited();
    let apart = |a: &Range<usize>, b: &Range<usize>| a.end <= b.start || b.end <= a.start;
    found.retain(|flight| limited.iter().all(|(_, samples)| apart(samples, &flight.samples)));
    found.sort_by_key(|flight| flight.samples.start);
    found
}
