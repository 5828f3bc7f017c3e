//! One step of DOP853 from a given state: stages, end, error estimate.

use super::coefficients::{A, ALL_STAGES, C, DENSE, ERROR_5, ORDER_3, STAGES};
use super::segment::Segment;
use super::system::System;
use crate::error::{Error, Result};
use crate::integrators::Work;
use crate::integrators::compensated::Compensated;
use crate::integrators::explicit::{increment, mean_increment, stage};
use crate::integrators::ode::finite_derivative;
use crate::math::lane::write_finite;

/// A step, tried again and again in one place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Trial<const N: usize> {
    pub(super) t: f64,
    pub(super) t_end: f64,
    pub(super) start: Compensated<N>,
    pub(super) end: Compensated<N>,
    pub(super) k: [[f64; N]; STAGES],
    /// The increment of the start.
    made: [f64; N],
    /// The correction of the end, where it had drifted.
    back: Option<[f64; N]>,
    /// The drift that is left where it is, in parts of what drifts.
    within: f64,
}

impl<const N: usize> Trial<N> {
    /// No step yet from `start` at `t`, where the derivative is `first`; a drift beyond `within`
    /// will be put back.
    pub(super) fn new(t: f64, start: [f64; N], first: [f64; N], within: f64) -> Self {
        let start = Compensated::new(start);
        let mut k = [[0.0; N]; STAGES];
        k[0] = first;
        Self { t, t_end: t, start, end: start, k, made: [0.0; N], back: None, within }
    }

    /// The step to `t_end`. Eleven derivatives.
    pub(super) fn step_to(
        &mut self,
        ode: &dyn System<N>,
        t_end: f64,
        work: &mut Work,
    ) -> Result<()> {
        ode.stages(self, t_end - self.t, work)?;
        self.end_at(t_end);
        let drift = ode.drift(t_end, &self.end.value, self.within);
        self.back = drift.map(|drift| drift.map(|d| -d));
        if let Some(back) = &self.back {
            self.end = self.end.plus(back);
        }
        Ok(())
    }

    /// The end of the step, from its stages.
    fn end_at(&mut self, t_end: f64) {
        self.made = mean_increment(t_end - self.t, A[STAGES], &self.k);
        self.end = self.start.plus(&self.made);
        self.t_end = t_end;
    }

    /// Goes on from the end of the step, where the derivative is `first`.
    pub(super) fn go_on(&mut self, first: [f64; N]) {
        self.t = self.t_end;
        self.start = self.end;
        write_finite(&first, &mut self.k[0]);
    }

    /// The step from the same start to an earlier end: where an event is.
    pub(super) fn shortened(
        &self,
        ode: &dyn System<N>,
        t_end: f64,
        work: &mut Work,
    ) -> Result<Self> {
        let mut shorter = *self;
        shorter.step_to(ode, t_end, work)?;
        Ok(shorter)
    }

    /// The derivative at the end of the step.
    pub(super) fn last(&self, ode: &dyn System<N>, work: &mut Work) -> Result<[f64; N]> {
        work.derivatives += 1;
        let y = &self.end.value;
        finite_derivative(self.t_end, y, ode.derivative(self.t_end, y))
    }

    /// The estimated error of the step in units of the tolerance; at most 1 is good.
    ///
    /// The estimate of order 5, steadied by that of order 3:
    /// e5^2 / sqrt(e5^2 + e3^2 / 100), in the mean over the components.
    pub(super) fn error(&self, ode: &dyn System<N>, tolerance: f64) -> Result<f64> {
        let size = sizes(ode, &self.start.value)?;
        let size_end = sizes(ode, &self.end.value)?;
        Ok(self.error_by(&size, &size_end, tolerance))
    }

    fn error_by(&self, size: &[f64; N], size_end: &[f64; N], tolerance: f64) -> f64 {
        let h = self.t_end - self.t;
        let e5 = increment(h, ERROR_5, &self.k);
        let b3 = mean_increment(h, ORDER_3, &self.k);
        let (mut sum_5, mut sum_3, mut largest) = (0.0, 0.0, 0.0_f64);
        for i in 0..N {
            let allowed = tolerance * size[i].max(size_end[i]);
            largest = largest.max(allowed);
            let (r5, r3) = (e5[i] / allowed, (self.made[i] - b3[i]) / allowed);
            sum_5 += r5 * r5;
            sum_3 += r3 * r3;
        }
        // Stages that ran away: a quotient by what is infinite would be 0.
        if !(sum_5 + sum_3 + largest).is_finite() {
            return f64::INFINITY;
        }
        if sum_5 == 0.0 {
            return 0.0;
        }
        sum_5 / ((sum_5 + 0.01 * sum_3) * N as f64).sqrt()
    }

    /// The interpolant over this step. Three derivatives and the one at the end,
    /// which the next step uses again.
    pub(super) fn segment(
        &self,
        ode: &dyn System<N>,
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
        let mut difference = self.made;
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
pub(super) fn sizes<const N: usize>(ode: &dyn System<N>, y: &[f64; N]) -> Result<[f64; N]> {
    let sizes = ode.scale(y);
    match sizes.iter().find(|s| s.is_nan() || **s <= 0.0) {
        None => Ok(sizes),
        Some(&value) => {
            Err(Error::out_of_range("scale of a component", value, "it must be greater than 0"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::system::ByRef;
    use super::*;
    use crate::integrators::{ode, size_or};
    use crate::math::pow;

    /// A step of y' = -y that is far too long has an error, however far its stages run away.
    #[test]
    fn no_step_that_is_too_long_is_good() -> Result<()> {
        let decay = ode(|_, [y]: &[f64; 1]| [-y]).scaled(size_or([1.0]));
        let decay = ByRef(&decay);
        let (mut tried, mut beyond) = (0, 0);
        for n in 100..=6000 {
            let mut trial = Trial::new(0.0, [1.0], [-1.0], 1.0);
            let step = pow(10.0, f64::from(n) / 100.0);
            if trial.step_to(&decay, step, &mut Work::default()).is_err() {
                // Beyond doubles.
                beyond += 1;
                continue;
            }
            for tolerance in [1e-4, 1e-8, 1e-12] {
                let error = trial.error(&decay, tolerance)?;
                assert!(error > 1.0, "{n}: {error}");
                tried += 1;
            }
        }
        assert_eq!(tried + 3 * beyond, 5901 * 3);
        assert!(tried > 5000 && beyond > 1000, "{tried} {beyond}");
        Ok(())
    }
}
