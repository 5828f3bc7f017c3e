//! The tensor for which the least torque is left in some equations.
//!
//! In plain loops: the page kit is compiled without optimisation where examples are run, and there the search of
//! 300,000 samples took 27 s with the solvers of nalgebra, where this takes 3 s.

/// The most torque of a flight, |torque|/|L| (1/s). A hand that takes a second to give or take L
/// has as much; noise of 0.1 rad/s at 10 rad/s has 0.7.
pub(super) const MOST: f64 = 1.0;

pub(super) fn speed([x, y, z]: &[f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

pub(super) type Square = [[f64; 6]; 6];

/// xx, yy, zz, xy, yz, zx.
pub(super) type Tensor = [f64; 6];

fn add(to: &mut Square, factor: f64, other: &Square) {
    for i in 0..6 {
        for j in 0..6 {
            to[i][j] += factor * other[i][j];
        }
    }
}

fn dot(a: &Tensor, b: &Tensor) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] + a[4] * b[4] + a[5] * b[5]
}

fn product(m: &Square, v: &Tensor) -> Tensor {
    [0, 1, 2, 3, 4, 5].map(|i| dot(&m[i], v))
}

/// L D L^T, of a matrix that is positive definite: L below the diagonal, D on it.
fn factors(mut m: Square) -> Option<Square> {
    for k in 0..6 {
        let pivot = m[k][k];
        if pivot <= 0.0 {
            return None;
        }
        let column = m.map(|row| row[k]);
        for (i, row) in m.iter_mut().enumerate().skip(k + 1) {
            row[k] /= pivot;
            for j in k + 1..i + 1 {
                row[j] -= row[k] * column[j];
            }
        }
    }
    Some(m)
}

fn solved(factors: &Square, mut v: Tensor) -> Tensor {
    for i in 0..6 {
        for j in 0..i {
            v[i] -= factors[i][j] * v[j];
        }
    }
    for i in (0..6).rev() {
        v[i] /= factors[i][i];
        for j in i + 1..6 {
            v[i] -= factors[j][i] * v[j];
        }
    }
    v
}

/// Sums over equations from which the tensor follows.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Sums {
    pub(super) torque: Square,
    pub(super) momentum: Square,
    pub(super) count: f64,
}

impl Sums {
    /// Below the diagonal and on it.
    pub(super) fn add(&mut self, equation: &Equation) {
        let sums = [(&mut self.torque, &equation.torque), (&mut self.momentum, &equation.momentum)];
        for (sum, of) in sums {
            for i in 0..6 {
                let [x, y, z] = of[i];
                for j in 0..i + 1 {
                    sum[i][j] += x * of[j][0] + y * of[j][1] + z * of[j][2];
                }
            }
        }
        self.count += 1.0;
    }

    pub(super) fn of(parts: &[Self]) -> Self {
        let mut sums = Self::default();
        parts.iter().for_each(|part| sums.join(part));
        sums
    }

    pub(super) fn join(&mut self, other: &Self) {
        add(&mut self.torque, 1.0, &other.torque);
        add(&mut self.momentum, 1.0, &other.momentum);
        self.count += other.count;
    }

    /// Whether every tensor leaves more |torque|/|L| than this: torque - most^2 momentum is positive definite.
    pub(super) fn exceeds(&self, most: f64) -> bool {
        let mut left = self.torque;
        add(&mut left, -most * most, &self.momentum);
        factors(left).is_some()
    }

    /// The tensor of least torque, by inverse iteration.
    pub(super) fn tensor(&self) -> Option<Tensor> {
        let mut momentum = self.momentum;
        let trace: f64 = (0..6).map(|i| momentum[i][i]).sum();
        // Directions that no rate has are given a millionth, so that none is without momentum.
        momentum.iter_mut().enumerate().for_each(|(i, row)| row[i] += 1e-6 * trace);
        // Less torque than 0.01/s is none.
        let mut torque = self.torque;
        add(&mut torque, 1e-4, &momentum);
        let factors = factors(torque)?;
        let mut tensor = [1.0, 1.1, 1.2, 0.1, 0.2, 0.3];
        let mut last = 0.0;
        for _ in 0..50 {
            let momenta = product(&momentum, &tensor);
            let size = dot(&tensor, &momenta).sqrt();
            let right = momenta.map(|l| l / size);
            tensor = solved(&factors, right);
            // One over the least torque.
            let own = dot(&tensor, &right);
            if own - last <= 1e-6 * own {
                break;
            }
            last = own;
        }
        Some(tensor)
    }

    /// The sum of the squares of torque or momentum with this tensor.
    fn square(of: &Square, tensor: &Tensor) -> f64 {
        dot(tensor, &product(of, tensor)).max(0.0)
    }

    /// The root of the mean square of |torque|/|L| with this tensor.
    pub(super) fn size(&self, tensor: &Tensor) -> f64 {
        (Self::square(&self.torque, tensor) / Self::square(&self.momentum, tensor)).sqrt()
    }

    /// The part of that which noise of this standard deviation makes: 2 noise^2 |J|^2/|L dt|^2 in the mean
    /// square, with the sum |J|^2 of the squares of all nine elements.
    pub(super) fn by_noise(&self, tensor: &Tensor, noise: f64) -> f64 {
        let [xx, yy, zz, xy, yz, zx] = *tensor;
        let squares = xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + yz * yz + zx * zx);
        noise * (2.0 * self.count * squares / Self::square(&self.momentum, tensor)).sqrt()
    }

    /// Whether there is torque beyond what noise makes, or noise hides it. (A tensor with hardly a moment about
    /// the axis of the rates turns all torque into noise.)
    pub(super) fn is_forced(&self, tensor: &Tensor, noise: f64) -> bool {
        let (size, by_noise) = (self.size(tensor), self.by_noise(tensor, noise));
        size * size > MOST * MOST + by_noise * by_noise || by_noise > MOST
    }
}

/// The equation of torque over a lag: for each element of the tensor, what is left of it and L dt.
pub(super) struct Equation {
    pub(super) torque: [[f64; 3]; 6],
    pub(super) momentum: [[f64; 3]; 6],
}

impl Equation {
    /// The lengths of torque and momentum with this tensor.
    pub(super) fn sizes(&self, tensor: &Tensor) -> [f64; 2] {
        let along = |of: &[[f64; 3]; 6], k: usize| {
            dot(tensor, &[of[0][k], of[1][k], of[2][k], of[3][k], of[4][k], of[5][k]])
        };
        let size = |of: &[[f64; 3]; 6]| speed(&[along(of, 0), along(of, 1), along(of, 2)]);
        [size(&self.torque), size(&self.momentum)]
    }
}
