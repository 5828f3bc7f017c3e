//! Linear equations, also where they do not determine everything.

/// The most unknowns.
pub(super) const SIZE: usize = 16;
/// A pivot below this, after scaling, is round-off: 2^-46.
const NO_PIVOT: f64 = 1.5e-14;
/// A remainder below this part of what was subtracted is round-off.
const REMAINDER: f64 = 1e-10;

/// `n` equations for `n` unknowns.
pub(super) struct Equations {
    pub rows: [[f64; SIZE]; SIZE],
    pub right: [f64; SIZE],
    n: usize,
}

/// A solution, and the direction in which there are others if there is one.
pub(super) struct Root {
    pub x: [f64; SIZE],
    pub freedom: Option<[f64; SIZE]>,
}

impl Equations {
    pub(super) const fn new(n: usize) -> Self {
        Self { rows: [[0.0; SIZE]; SIZE], right: [0.0; SIZE], n }
    }

    /// The solution by Gauss-Jordan elimination with complete pivoting after scaling, which
    /// begins with these `units` of the unknowns; unknowns that are not determined are 0. `None`
    /// if the equations contradict each other.
    pub(super) fn solve(mut self, units: &[f64; SIZE]) -> Option<Root> {
        let n = self.n;
        let scale = self.scale(units);
        let mut columns: [usize; SIZE] = core::array::from_fn(|j| j);
        // What each right side is made of: the measure of its round-off.
        let mut made_of = self.right.map(f64::abs);
        let mut rank = 0;
        while rank < n {
            let (row, place, pivot) = self.largest(rank, &columns);
            if pivot <= NO_PIVOT {
                break;
            }
            self.rows.swap(rank, row);
            self.right.swap(rank, row);
            made_of.swap(rank, row);
            columns.swap(rank, place);
            let (pivot_row, right, made) = (self.rows[rank], self.right[rank], made_of[rank]);
            let column = columns[rank];
            for i in (0..n).filter(|&i| i != rank) {
                let factor = self.rows[i][column] / pivot_row[column];
                if factor != 0.0 {
                    for (a, b) in self.rows[i][..n].iter_mut().zip(&pivot_row) {
                        *a -= factor * b;
                    }
                    self.rows[i][column] = 0.0;
                    self.right[i] -= factor * right;
                    made_of[i] += factor.abs() * made;
                }
            }
            rank += 1;
        }
        // Written so that NaN is a contradiction.
        if !(rank..n).all(|i| self.right[i].abs() <= REMAINDER * made_of[i]) {
            return None;
        }
        let (mut x, mut freedom) = ([0.0; SIZE], [0.0; SIZE]);
        for k in 0..rank {
            let column = columns[k];
            let pivot = self.rows[k][column];
            x[column] = scale[column] * (self.right[k] / pivot);
            if rank + 1 == n {
                freedom[column] = -scale[column] * (self.rows[k][columns[rank]] / pivot);
            }
        }
        if rank + 1 == n {
            freedom[columns[rank]] = scale[columns[rank]];
        }
        Some(Root { x, freedom: (rank + 1 == n).then_some(freedom) })
    }

    /// Puts the unknowns in `units`, then brings the largest coefficient of each row, then of each
    /// column, between 1 and 2; returns the scales of the unknowns.
    fn scale(&mut self, units: &[f64; SIZE]) -> [f64; SIZE] {
        let n = self.n;
        for row in &mut self.rows[..n] {
            row.iter_mut().zip(units).for_each(|(a, unit)| *a *= unit);
        }
        for (row, right) in self.rows[..n].iter_mut().zip(&mut self.right) {
            let factor = reciprocal(row.iter().fold(0.0, |m: f64, a| m.max(a.abs())));
            row.iter_mut().for_each(|a| *a *= factor);
            *right *= factor;
        }
        let mut largest = [0.0_f64; SIZE];
        for row in &self.rows[..n] {
            for (largest, a) in largest.iter_mut().zip(row) {
                *largest = largest.max(a.abs());
            }
        }
        let factors = largest.map(reciprocal);
        for row in &mut self.rows[..n] {
            row.iter_mut().zip(&factors).for_each(|(a, factor)| *a *= factor);
        }
        core::array::from_fn(|j| units[j] * factors[j])
    }

    /// Row, place among the columns, and size of the largest coefficient left.
    fn largest(&self, from: usize, columns: &[usize; SIZE]) -> (usize, usize, f64) {
        let mut found = (from, from, 0.0);
        for i in from..self.n {
            for (place, &j) in columns[..self.n].iter().enumerate().skip(from) {
                let size = self.rows[i][j].abs();
                if size > found.2 {
                    found = (i, place, size);
                }
            }
        }
        found
    }
}

/// The power of 2^32 nearest to `size`, within doubles: 1 for what is of ordinary size, from
/// 2^-16 to 2^16, and for what is 0, subnormal or infinite.
pub(super) fn unit(size: f64) -> f64 {
    let exponent = (size.to_bits() >> 52) as i64;
    if exponent == 0 || exponent >= 2047 {
        return 1.0;
    }
    let steps = (exponent - 1023 + 16).div_euclid(32).clamp(-31, 31);
    f64::from_bits(((1023 + 32 * steps) as u64) << 52)
}

/// The power of 2 that brings `size` between 1 and 2: scaling by it rounds nothing. 1 for
/// what is 0, subnormal or infinite.
const fn reciprocal(size: f64) -> f64 {
    let exponent = size.to_bits() >> 52;
    if exponent == 0 || exponent >= 2046 {
        return 1.0;
    }
    f64::from_bits((2046 - exponent) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Equations of whole numbers in rows and columns of any size have the solution that they
    /// were made from.
    #[test]
    fn scaled_equations_have_their_solution() {
        let (rows, x) = ([[2.0, 1.0, 0.0], [1.0, 3.0, 1.0], [0.0, 1.0, 4.0]], [1.0, -2.0, 3.0]);
        for sizes in [[1.0; 3], [1e-7, 3.0, 5e9], [7e3, 1e-12, 0.3]] {
            let mut equations = Equations::new(3);
            for i in 0..3 {
                for j in 0..3 {
                    equations.rows[i][j] = sizes[i] * rows[i][j] / sizes[j];
                    equations.right[i] += sizes[i] * rows[i][j] * x[j];
                }
            }
            let root = equations.solve(&[1.0; SIZE]).expect("one solution");
            assert!(root.freedom.is_none());
            for j in 0..3 {
                assert!((root.x[j] / sizes[j] - x[j]).abs() < 1e-14, "{:?}", root.x);
            }
        }
    }
}
