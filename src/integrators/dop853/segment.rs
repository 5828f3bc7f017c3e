//! The interpolant over one step.

/// One step as a polynomial of degree 7 in the time.
#[derive(Debug, Clone, Copy)]
pub(super) struct Segment<const N: usize> {
    pub(super) t: f64,
    pub(super) t_end: f64,
    pub(super) start: [f64; N],
    pub(super) end: [f64; N],
    /// d, b, w, c3 ... c6 of y = start + s (d + r (b + s (w + r (c3 + s (c4 +
    /// r (c5 + s c6)))))), where s is the fraction of the step and r = 1 - s.
    pub(super) coefficients: [[f64; N]; 7],
}

impl<const N: usize> Segment<N> {
    /// The state at `t`.
    ///
    /// Counted from the nearer end, so that the ends come out bit for bit and
    /// the polynomial adds only what lies between.
    pub(super) fn at(&self, t: f64) -> [f64; N] {
        let h = self.t_end - self.t;
        let (s, r) = ((t - self.t) / h, (self.t_end - t) / h);
        let [d, b, w, c3, c4, c5, c6] = &self.coefficients;
        let mut y = [0.0; N];
        for i in 0..N {
            let inner = b[i] + s * (w[i] + r * (c3[i] + s * (c4[i] + r * (c5[i] + s * c6[i]))));
            y[i] = if s <= 0.5 {
                self.start[i] + s * (d[i] + r * inner)
            } else {
                self.end[i] + r * (s * inner - d[i])
            };
        }
        y
    }
}
