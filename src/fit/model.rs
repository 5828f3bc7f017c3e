//! What a gyroscope shows of a body in free flight, as a function of a few numbers.

use super::least_squares::{self, Fitted};
use crate::attitude::Attitude;
use crate::body::Kinematics;
use crate::error::Result;
use crate::exact::free_body::FreeBody;
use crate::frame::{BodyVector, SpaceVector};
use crate::inertia::PrincipalMoments;
use crate::math::{exp, sort_by_number};
use nalgebra::{DVector, Matrix3, SymmetricEigen, Vector3};

/// What may be added to a free body whose principal axes are the sensor's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Correction {
    /// The principal axes are turned against the sensor's: a rotation vector (rad), on the principal axes. It
    /// is open where two moments are equal.
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

/// Two elements of the tensor's logarithm, three rates at the start.
const BASE: usize = 5;

/// Nodes and weights of the integral of e^-x f(x) from 0 to infinity, exact for polynomials of
/// degree 7: M. Abramowitz, I. A. Stegun, *Handbook of Mathematical Functions*, table 25.9.
const FILTER: [(f64, f64); 4] = [
    (0.322547689619392, 0.603154104341634),
    (1.745761101158347, 0.357418692437800),
    (4.536620296921128, 0.0388879085150054),
    (9.395070912301133, 0.000539294705561327),
];

/// After so many, where a fit began is forgotten.
const FEW_STEPS: usize = 12;
/// A part of a flight, from which the next begins, is fitted to this part of a standard deviation.
const ROUGH: f64 = 0.5;

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
///
/// Its numbers are elements of H, the logarithm of the tensor of inertia on the sensor's axes: H_xx and H_yy,
/// with H_zz = 0, and the rates at the start on the sensor's axes. [`Correction::Axes`] adds H_xy, H_yz and H_zx.
/// So nothing is singular where two moments are equal, unlike angles of the principal axes.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Model {
    /// The offset, which changes no motion, comes last.
    corrections: Vec<Correction>,
}

/// The numbers of a model, by name.
#[derive(Debug, Clone)]
pub(super) struct Named {
    /// Logarithms of the moments about the principal axes nearest to x, y and z.
    pub(super) logs: [f64; 3],
    /// Unit vectors along these axes on the sensor's.
    pub(super) axes: [[f64; 3]; 3],
    /// From the principal axes to the sensor's.
    pub(super) turn: Attitude,
    /// The rates at the start on the principal axes.
    pub(super) start: BodyVector,
    pub(super) offset: [f64; 3],
    pub(super) filter: f64,
    pub(super) drag: f64,
}

impl Model {
    pub(super) fn new(corrections: &[Correction]) -> Self {
        let mut all = Correction::ALL;
        sort_by_number(&mut all, |one| one.numbers() as f64);
        Self { corrections: all.into_iter().filter(|one| corrections.contains(one)).collect() }
    }

    /// All combinations of these corrections, the simpler ones first.
    pub(super) fn combinations(allowed: &[Correction]) -> Vec<Self> {
        let all = Self::new(allowed).corrections;
        let chosen = |bits: u32| (0..all.len()).filter(move |k| bits >> k & 1 == 1);
        let of = |bits: u32| Self { corrections: chosen(bits).map(|k| all[k]).collect() };
        let mut combinations: Vec<Self> = (0..1_u32 << all.len()).map(of).collect();
        sort_by_number(&mut combinations, |one| one.numbers() as f64);
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
        let [xy, yz, zx] = three(Correction::Axes);
        let tensor = Matrix3::new(numbers[0], xy, zx, xy, numbers[1], yz, zx, yz, 0.0);
        let (logs, axes) = nearest_axes(&tensor);
        let turn = Attitude::from_matrix([0, 1, 2].map(|row| axes.map(|axis| axis[row])))?;
        let start = turn.to_body(SpaceVector::new(numbers[2], numbers[3], numbers[4]));
        Ok(Named {
            logs,
            axes,
            turn,
            start,
            offset: three(Correction::Offset),
            filter: one(Correction::Filter),
            drag: one(Correction::Drag),
        })
    }

    /// By how much axes[i]^T H axes[j] changes with each number: for i = j that is the logarithm of a moment.
    pub(super) fn slopes(&self, axes: &[[f64; 3]; 3], [i, j]: [usize; 2]) -> DVector<f64> {
        let (a, b) = (axes[i], axes[j]);
        let mut slopes = DVector::zeros(self.numbers());
        (slopes[0], slopes[1]) = (a[0] * b[0], a[1] * b[1]);
        if let Some(at) = self.place(Correction::Axes) {
            for (n, (p, q)) in [(0, 1), (1, 2), (2, 0)].into_iter().enumerate() {
                slopes[at + n] = a[p] * b[q] + a[q] * b[p];
            }
        }
        slopes
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

    /// The rates on the sensor's axes, as its filter shows them, without its offset, at these times (s) after
    /// the start.
    ///
    /// With drag, L keeps its direction and L(t) = L(0) e^(-gamma t), so that the body goes the way of
    /// the free one, more and more slowly: omega(t) = e^(-gamma t) omega_free((1 - e^(-gamma t))/gamma).
    /// The filter shows the integral of e^-x omega(t - tau x) over x from 0 to infinity; less the delay
    /// tau that is omega + tau^2/2 d2 omega/dt2 + ..., so that tau^2 is the number to be fitted. One
    /// below 0, which noise may ask for, mirrors the change. The mean over times of a standard
    /// deviation s is that at t - s and t + s: exact for cubics.
    fn rates_of_body(
        &self,
        numbers: &[f64],
        times: &[f64],
        spreads: &[f64],
    ) -> Result<Vec<[f64; 3]>> {
        let named = self.named(numbers)?;
        let moments = PrincipalMoments::of_any(named.logs.map(exp))?;
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
        Ok(shown.map(|rate| named.turn.to_space(rate).to_array()).collect())
    }

    fn offset(&self, numbers: &[f64]) -> [f64; 3] {
        self.place(Correction::Offset).map_or([0.0; 3], |k| [0, 1, 2].map(|i| numbers[k + i]))
    }

    /// What the sensor shows at these times (s) after the start.
    pub(super) fn rates(&self, numbers: &[f64], times: &[f64]) -> Result<Vec<[f64; 3]>> {
        let offset = self.offset(numbers);
        let rates = self.rates_of_body(numbers, times, &vec![0.0; times.len()])?;
        Ok(rates.into_iter().map(|rate| [0, 1, 2].map(|i| rate[i] + offset[i])).collect())
    }

    /// Whether neither tau^2 nor gamma is below 0, which no filter and no drag has. If one is, the fit is
    /// best without it.
    pub(super) fn is_physical(&self, numbers: &[f64]) -> bool {
        let is = |correction| self.place(correction).is_none_or(|at| numbers[at] >= 0.0);
        is(Correction::Filter) && is(Correction::Drag)
    }

    /// The best numbers near these, for the first `count` samples; not all of the way if tau^2 or gamma is
    /// below 0, or the sum of squares above `hopeless`.
    pub(super) fn refined(
        &self,
        numbers: &[f64],
        samples: &Samples,
        count: usize,
        hopeless: f64,
    ) -> Result<Fitted> {
        let fastest = samples.rates.iter().flatten().fold(0.0_f64, |most, w| most.max(w.abs()));
        let given_up = |now: &Fitted, steps: usize| match count < samples.times.len() {
            true => now.off < ROUGH || steps >= FEW_STEPS,
            false => {
                steps >= FEW_STEPS && (now.squares > hopeless || !self.is_physical(&now.numbers))
            }
        };
        let mut last = None;
        least_squares::descend(numbers, &self.scales(fastest), &given_up, &mut |numbers| {
            self.residuals(numbers, samples, count, &mut last)
        })
    }

    /// Rates of the body are computed anew only if numbers change on which they depend.
    pub(super) fn residuals(
        &self,
        numbers: &[f64],
        samples: &Samples,
        count: usize,
        last: &mut Option<(Vec<f64>, Vec<[f64; 3]>)>,
    ) -> Result<Vec<f64>> {
        let inner = &numbers[..self.place(Correction::Offset).unwrap_or(numbers.len())];
        if last.as_ref().is_none_or(|(of, _)| of != inner) {
            let (times, spreads) = (&samples.times[..count], &samples.spreads[..count]);
            *last = Some((inner.to_vec(), self.rates_of_body(numbers, times, spreads)?));
        }
        let rates = last.as_ref().map_or(&[][..], |(_, rates)| rates);
        let offset = self.offset(numbers);
        let triples = rates.iter().zip(&samples.rates).zip(&samples.weights);
        let left = |((a, b), w): ((&[f64; 3], &[f64; 3]), &f64)| {
            [0, 1, 2].map(|i| w * (a[i] + offset[i] - b[i]))
        };
        Ok(triples.flat_map(left).collect())
    }
}

/// Eigenvalues and eigenvectors of a symmetric matrix: to each axis x, y, z the one that is nearest, with the
/// direction that is nearest, a right-handed triad.
fn nearest_axes(matrix: &Matrix3<f64>) -> ([f64; 3], [[f64; 3]; 3]) {
    let diagonal = [matrix.m11, matrix.m22, matrix.m33];
    if *matrix == Matrix3::from_diagonal(&diagonal.into()) {
        return (diagonal, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    }
    let eigen = SymmetricEigen::new(*matrix);
    let axes: [[f64; 3]; 3] = eigen.eigenvectors.into();
    let near =
        |order: &[usize; 3]| (0..3).map(|i| axes[order[i]][i] * axes[order[i]][i]).sum::<f64>();
    let orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
    let order = orders.into_iter().max_by(|a, b| near(a).total_cmp(&near(b))).unwrap_or([0, 1, 2]);
    let along = |i: usize| axes[order[i]].map(|x| x * axes[order[i]][i].signum());
    let mut axes = [0, 1, 2].map(along);
    let [a, b, c] = axes.map(Vector3::from);
    if a.cross(&b).dot(&c) < 0.0 {
        // The direction that is nearly across its axis is the one that may be the other.
        let turned = (0..3).min_by(|i, j| axes[*i][*i].total_cmp(&axes[*j][*j])).unwrap_or(2);
        axes[turned] = axes[turned].map(|x| -x);
    }
    (order.map(|k| eigen.eigenvalues[k]), axes)
}

/// The time of the free body that is where the one with drag is at `t`, and how much slower that is.
pub(super) fn slowed_clock(t: f64, drag: f64) -> (f64, f64) {
    let x = drag * t;
    if x == 0.0 {
        return (t, 1.0);
    }
    (-t * crate::math::expm1(-x) / x, exp(-x))
}
