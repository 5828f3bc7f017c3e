//! What a gyroscope shows of a body in free flight, as a function of a few numbers.

use super::least_squares::{self, Fitted};
use crate::attitude::Attitude;
use crate::body::Kinematics;
use crate::error::{Error, Result};
use crate::exact::free_body::FreeBody;
use crate::frame::BodyVector;
use crate::inertia::PrincipalMoments;
use crate::math::exp;

/// What may be added to a free body whose principal axes are the sensor's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Correction {
    /// The principal axes are turned against the sensor's: a rotation vector (rad).
    Axes,
    /// The sensor shows this much at rest (rad/s on each of its axes).
    Offset,
    /// The sensor's filter of first order, y + tau dy/dt = omega: tau^2 (s^2). That it also delays what
    /// it shows cannot be told from the rates: time is that of the sensor.
    Filter,
    /// A drag in proportion to the angular momentum, dL/dt = -gamma L: gamma (1/s).
    Drag,
}

impl Correction {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Axes, Self::Offset, Self::Filter, Self::Drag];

    /// How many numbers it adds.
    pub(super) const fn numbers(self) -> usize {
        match self {
            Self::Axes | Self::Offset => 3,
            Self::Filter | Self::Drag => 1,
        }
    }
}

/// By how much the principal axes may be turned (rad): at 45 degrees it is open which is which.
const MOST_TURNED: f64 = 0.7;

/// Two logarithms of ratios of moments, three rates at the start.
pub(super) const BASE: usize = 5;

/// Nodes and weights of the integral of e^-x f(x) from 0 to infinity, exact for polynomials of
/// degree 7: M. Abramowitz, I. A. Stegun, *Handbook of Mathematical Functions*, table 25.9.
const FILTER: [(f64, f64); 4] = [
    (0.322547689619392, 0.603154104341634),
    (1.745761101158347, 0.357418692437800),
    (4.536620296921128, 0.0388879085150054),
    (9.395070912301133, 0.000539294705561327),
];

/// Samples of a flight, or means of neighbours.
#[derive(Debug, Clone, Default)]
pub(super) struct Samples {
    /// In s after the first sample.
    pub(super) times: Vec<f64>,
    /// Standard deviations of the times whose mean is taken (s).
    pub(super) spreads: Vec<f64>,
    pub(super) rates: Vec<[f64; 3]>,
    /// Roots of the numbers of samples, relative to the largest.
    pub(super) weights: Vec<f64>,
}

/// A free body seen by a sensor, with some corrections.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Model {
    /// Those that act in the body's motion come first, those of the sensor's axes last.
    corrections: Vec<Correction>,
}

/// The numbers of a model, by name.
pub(super) struct Named {
    pub(super) moments: [f64; 3],
    pub(super) start: BodyVector,
    pub(super) turn: Attitude,
    pub(super) offset: [f64; 3],
    pub(super) filter: f64,
    pub(super) drag: f64,
}

impl Model {
    pub(super) fn new(corrections: &[Correction]) -> Self {
        let mut corrections = corrections.to_vec();
        corrections.sort_unstable_by_key(|c| (c.numbers(), *c));
        corrections.dedup();
        Self { corrections }
    }

    /// All combinations of these corrections, the simpler ones first.
    pub(super) fn combinations(allowed: &[Correction]) -> Vec<Self> {
        let all = Self::new(allowed).corrections;
        let chosen = |bits: u32| (0..all.len()).filter(move |k| bits >> k & 1 == 1);
        let of = |bits: u32| Self { corrections: chosen(bits).map(|k| all[k]).collect() };
        let mut combinations: Vec<Self> = (0..1_u32 << all.len()).map(of).collect();
        combinations.sort_by_key(Self::numbers);
        combinations
    }

    pub(super) fn is_part_of(&self, other: &Self) -> bool {
        self.corrections.iter().all(|correction| other.has(*correction))
    }

    pub(super) fn with(&self, correction: Correction) -> Self {
        Self::new(&[self.corrections.as_slice(), &[correction]].concat())
    }

    pub(super) fn has(&self, correction: Correction) -> bool {
        self.corrections.contains(&correction)
    }

    pub(super) fn numbers(&self) -> usize {
        BASE + self.corrections.iter().map(|c| c.numbers()).sum::<usize>()
    }

    /// Where the numbers of a correction begin.
    pub(super) fn place(&self, correction: Correction) -> Option<usize> {
        let at = self.corrections.iter().position(|c| *c == correction)?;
        Some(BASE + self.corrections[..at].iter().map(|c| c.numbers()).sum::<usize>())
    }

    /// The numbers of this model that say what those of another say; 0 for what it lacks.
    pub(super) fn carried(&self, from: &Self, numbers: &[f64]) -> Vec<f64> {
        let mut carried = vec![0.0; self.numbers()];
        carried[..BASE].copy_from_slice(&numbers[..BASE]);
        for &correction in &self.corrections {
            if let (Some(to), Some(at)) = (self.place(correction), from.place(correction)) {
                let n = correction.numbers();
                carried[to..to + n].copy_from_slice(&numbers[at..at + n]);
            }
        }
        carried
    }

    pub(super) fn named(&self, numbers: &[f64]) -> Result<Named> {
        let three =
            |c| self.place(c).map_or([0.0; 3], |k| [numbers[k], numbers[k + 1], numbers[k + 2]]);
        let one = |c| self.place(c).map_or(0.0, |k| numbers[k]);
        Ok(Named {
            moments: [exp(numbers[0]), exp(numbers[1]), 1.0],
            start: BodyVector::new(numbers[2], numbers[3], numbers[4]),
            turn: Attitude::from_rotation_vector(three(Correction::Axes).into())?,
            offset: three(Correction::Offset),
            filter: one(Correction::Filter),
            drag: one(Correction::Drag),
        })
    }

    /// The size against which a change of each number counts: `fastest` is the fastest rate (rad/s).
    pub(super) fn scales(&self, fastest: f64) -> Vec<f64> {
        let mut scales = vec![1.0, 1.0, fastest, fastest, fastest];
        for correction in &self.corrections {
            scales.extend(match correction {
                Correction::Axes => vec![1.0; 3],
                Correction::Offset => vec![fastest; 3],
                Correction::Filter => vec![1.0 / (fastest * fastest)],
                Correction::Drag => vec![fastest],
            });
        }
        scales
    }

    /// How many of the numbers the rates on the body's own axes depend on.
    fn inner(&self) -> usize {
        BASE + self.corrections.iter().filter(|c| c.numbers() == 1).count()
    }

    /// The rates on the principal axes, as the filter shows them, at these times (s) after the start.
    ///
    /// With drag, L keeps its direction and L(t) = L(0) e^(-gamma t), so that the body goes the way of
    /// the free one, more and more slowly: omega(t) = e^(-gamma t) omega_free((1 - e^(-gamma t))/gamma).
    /// The filter shows the integral of e^-x omega(t - tau x) over x from 0 to infinity; less the delay
    /// tau that is omega + tau^2/2 d2 omega/dt2 + ..., so that tau^2 is the number to be fitted. One
    /// below 0, which noise may ask for, mirrors the change. The mean over times of a standard
    /// deviation s is that at t - s and t + s: exact for cubics.
    fn body_rates(
        &self,
        numbers: &[f64],
        times: &[f64],
        spreads: &[f64],
    ) -> Result<Vec<BodyVector>> {
        let named = self.named(numbers)?;
        let moments = PrincipalMoments::of_any(named.moments)?;
        let body = FreeBody::new(moments, Attitude::IDENTITY, named.start)?;
        let filter = named.filter.abs().sqrt();
        let nodes = match (filter > 0.0, named.filter < 0.0) {
            (false, _) => vec![(0.0, 1.0)],
            (true, mirrored) => {
                let sign = if mirrored { -1.0 } else { 1.0 };
                let shown = FILTER.map(|(x, weight)| (filter * (1.0 - x), sign * weight));
                let own = mirrored.then_some((0.0, 2.0));
                shown.into_iter().chain(own).collect()
            }
        };
        let sides: &[f64] = if spreads.iter().any(|s| *s > 0.0) { &[-1.0, 1.0] } else { &[0.0] };
        let each = nodes.len() * sides.len();
        let mut clock = Vec::with_capacity(times.len() * each);
        let mut slowed = Vec::with_capacity(times.len() * each);
        for (t, spread) in times.iter().zip(spreads) {
            for side in sides {
                for (later, weight) in &nodes {
                    let (own, slow) = slowed_clock(t + side * spread + later, named.drag);
                    clock.push(own);
                    slowed.push(weight * slow / sides.len() as f64);
                }
            }
        }
        let mut samples = vec![Kinematics::REST; clock.len()];
        body.kinematics_at(&clock, &mut samples)?;
        let shown = samples.chunks(each).zip(slowed.chunks(each)).map(|(samples, slowed)| {
            let seen = samples.iter().zip(slowed);
            seen.fold(BodyVector::zero(), |sum, (s, w)| sum + s.angular_velocity * *w)
        });
        Ok(shown.collect())
    }

    /// These rates as the sensor shows them.
    fn on_sensor(&self, numbers: &[f64], body: &[BodyVector]) -> Result<Vec<[f64; 3]>> {
        let named = self.named(numbers)?;
        let turned = named.turn.rotation_vector().norm();
        if turned > MOST_TURNED {
            let allowed = "at most 0.7 rad: farther on, an axis has another's number";
            return Err(Error::out_of_range("turn of the principal axes", turned, allowed));
        }
        let shown = |rate: &BodyVector| {
            let sensor = named.turn.to_space(*rate).to_array();
            [0, 1, 2].map(|i| sensor[i] + named.offset[i])
        };
        Ok(body.iter().map(shown).collect())
    }

    /// What the sensor shows at these times (s) after the start.
    pub(super) fn rates(&self, numbers: &[f64], times: &[f64]) -> Result<Vec<[f64; 3]>> {
        self.on_sensor(numbers, &self.body_rates(numbers, times, &vec![0.0; times.len()])?)
    }

    /// The sum of the squares of what is left of these samples.
    pub(super) fn squares(&self, numbers: &[f64], samples: &Samples) -> f64 {
        let left = self.residuals(numbers, samples, samples.times.len(), &mut None);
        left.map_or(f64::INFINITY, |left| left.iter().map(|r| r * r).sum())
    }

    /// Whether tau^2 is not below 0. If it is, the fit is best without a filter.
    pub(super) fn filters(&self, numbers: &[f64]) -> bool {
        self.place(Correction::Filter).is_none_or(|at| numbers[at] >= 0.0)
    }

    /// The best numbers near these, for the first `count` samples; not all of the way if tau^2 is below 0
    /// or the sum of squares above `hopeless`.
    pub(super) fn refined(
        &self,
        numbers: &[f64],
        samples: &Samples,
        count: usize,
        hopeless: f64,
    ) -> Result<Fitted> {
        let fastest = samples.rates.iter().flatten().fold(0.0_f64, |most, w| most.max(w.abs()));
        let given_up = |now: &Fitted| now.squares > hopeless || !self.filters(&now.numbers);
        let mut last = None;
        least_squares::descend(numbers, &self.scales(fastest), &given_up, &mut |numbers| {
            self.residuals(numbers, samples, count, &mut last)
        })
    }

    /// Rates on the body's axes are computed anew only if numbers change on which they depend.
    pub(super) fn residuals(
        &self,
        numbers: &[f64],
        samples: &Samples,
        count: usize,
        last: &mut Option<(Vec<f64>, Vec<BodyVector>)>,
    ) -> Result<Vec<f64>> {
        let inner = &numbers[..self.inner()];
        if last.as_ref().is_none_or(|(of, _)| of != inner) {
            let body =
                self.body_rates(numbers, &samples.times[..count], &samples.spreads[..count])?;
            *last = Some((inner.to_vec(), body));
        }
        let body = last.as_ref().map_or(&[][..], |(_, body)| body);
        let shown = self.on_sensor(numbers, body)?;
        let triples = shown.iter().zip(&samples.rates).zip(&samples.weights);
        Ok(triples.flat_map(|((a, b), w)| [0, 1, 2].map(|i| w * (a[i] - b[i]))).collect())
    }
}

/// The time of the free body that is where the one with drag is at `t`, and how much slower that is.
pub(super) fn slowed_clock(t: f64, drag: f64) -> (f64, f64) {
    let x = drag * t;
    if x == 0.0 {
        return (t, 1.0);
    }
    (-t * crate::math::expm1(-x) / x, exp(-x))
}
