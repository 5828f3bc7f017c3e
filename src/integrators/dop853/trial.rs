//! One step of DOP853 from a given state: stages, end, error estimate.

use super::coefficients::{A, ALL_STAGES, C, DENSE, ERROR_5, ORDER_3, STAGES};
use super::segment::Segment;
use crate::error::{Error, Result};
use crate::integrators::compensated::Compensated;
use crate::integrators::explicit::{increment, mean_increment, stage};
use crate::integrators::ode::finite_derivative;
use crate::integrators::{Ode, Work};

/// A step that has been tried.
#[derive(Debug, Clone, Copy)]
pub(super) struct Trial<const N: usize> {
    pub t: f64,
    pub t_end: f64,
    pub start: Compensated<N>,
    pub end: Compensated<N>,
    k: [[f64; N]; STAGES],
    /// What was added to the end to put it back, where it had drifted.
    back: Option<[f64; N]>,
    /// The drift that is left where it is, in parts of what drifts.
    within: f64,
}

impl<const N: usize> Trial<N> {
    /// The step from `start` at the first time, where the derivative is `first`, to the other;
    /// a drift beyond `within` is put back. Eleven derivatives.
    pub fn new(
        ode: &(impl Ode<N> + ?Sized),
        [t, t_end]: [f64; 2],
        start: Compensated<N>,
        first: [f64; N],
        within: f64,
        work: &mut Work,
    ) -> Result<Self> {
        let h = t_end - t;
        let mut k = [[0.0; N]; STAGES];
        k[0] = first;
        for i in 1..STAGES {
            let at = t + C[i] * h;
            let y = stage(&start.value, h, A[i], &k);
            work.derivatives += 1;
            k[i] = finite_derivative(at, &y, ode.derivative(at, &y))?;
        }
        let stepped = start.plus(&mean_increment(h, A[STAGES], &k));
        let drift = ode.drift(t_end, &stepped.value, within);
        let back = drift.map(|drift| drift.map(|d| -d));
        Ok(Self {
            t,
            t_end,
            start,
            end: back.map_or(stepped, |back| stepped.plus(&back)),
            k,
            back,
            within,
        })
    }

    /// The step from the same start to an earlier end: where an event is.
    pub fn shortened(
        &self,
        ode: &(impl Ode<N> + ?Sized),
        t_end: f64,
        work: &mut Work,
    ) -> Result<Self> {
        Self::new(
            ode,
            [self.t, t_end],
            self.start,
            self.k[0],
            self.within,
            work,
        )
    }

    /// The derivative at the end of the step.
    pub fn last(&self, ode: &(impl Ode<N> + ?Sized), work: &mut Work) -> Result<[f64; N]> {
        work.derivatives += 1;
        let y = &self.end.value;
        finite_derivative(self.t_end, y, ode.derivative(self.t_end, y))
    }

    /// The estimated error of the step in units of the tolerance; at most 1 is good.
    ///
    /// The estimate of order 5, steadied by that of order 3:
    /// e5^2 / sqrt(e5^2 + e3^2 / 100), in the mean over the components.
    pub fn error(&self, ode: &(impl Ode<N> + ?Sized), tolerance: f64) -> Result<f64> {
        let h = self.t_end - self.t;
        let e5 = increment(h, ERROR_5, &self.k);
        let b = mean_increment(h, A[STAGES], &self.k);
        let b3 = mean_increment(h, ORDER_3, &self.k);
        let size = sizes(ode, &self.start.value)?;
        let size_end = sizes(ode, &self.end.value)?;
        let (mut sum_5, mut sum_3) = (0.0, 0.0);
        for i in 0..N {
            let allowed = tolerance * size[i].max(size_end[i]);
            let (r5, r3) = (e5[i] / allowed, (b[i] - b3[i]) / allowed);
            sum_5 += r5 * r5;
            sum_3 += r3 * r3;
        }
        if sum_5 == 0.0 {
            return Ok(0.0);
        }
        Ok(sum_5 / ((sum_5 + 0.01 * sum_3) * N as f64).sqrt())
    }

    /// The interpolant over this step. Three derivatives and the one at the end,
    /// which the next step uses again.
    pub fn segment(
        &self,
        ode: &(impl Ode<N> + ?Sized),
        last: [f64; N],
        work: &mut Work,
    ) -> Result<Segment<N>> {
        let h = self.t_end - self.t;
        let mut k = [[0.0; N]; ALL_STAGES];
        k[..STAGES].copy_from_slice(&self.k);
        k[STAGES] = last;
        for i in STAGES + 1..ALL_STAGES {
            let at = self.t + C[i] * h;
            let y = stage(&self.start.value, h, A[i], &k);
            work.derivatives += 1;
            k[i] = finite_derivative(at, &y, ode.derivative(at, &y))?;
        }
        // The increment itself, not end - start: the difference has lost digits.
        let mut difference = mean_increment(h, A[STAGES], &k);
        for (d, back) in difference.iter_mut().zip(self.back.iter().flatten()) {
            *d += back;
        }
        let mut bend = [0.0; N];
        let mut twist = [0.0; N];
        for i in 0..N {
            bend[i] = h * k[0][i] - difference[i];
            twist[i] = 2.0 * difference[i] - h * (k[0][i] + last[i]);
        }
        let [c3, c4, c5, c6] = DENSE.map(|weights| increment(h, weights, &k));
        Ok(Segment {
            t: self.t,
            t_end: self.t_end,
            start: self.start.value,
            end: self.end.value,
            coefficients: [difference, bend, twist, c3, c4, c5, c6],
        })
    }
}

/// The scale of every component, each greater than 0.
pub(super) fn sizes<const N: usize>(
    ode: &(impl Ode<N> + ?Sized),
    y: &[f64; N],
) -> Result<[f64; N]> {
    let sizes = ode.scale(y);
    match sizes.iter().find(|s| s.is_nan() || **s <= 0.0) {
        None => Ok(sizes),
        Some(&value) => Err(Error::OutOfRange {
            name: "scale of a component",
            value,
            allowed: "it must be greater than 0",
        }),
    }
}
