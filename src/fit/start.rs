//! Where a fit begins: moments from the rates themselves, by linear algebra.
//!
//! On the sensor's axes a free body has d(J w)/dt + w x J w = 0. Integrated from the start this is
//! J (w(t) - w(0)) + S(t) = 0, where S is the integral of w x J w: linear in the six elements of the tensor
//! J. So the elements, up to a factor, are the vector that makes the sum of the squares of the left
//! side least: the eigenvector of a matrix of six by six, or of three by three if J is diagonal. No
//! rate is differentiated. In a long flight the integral begins anew after each `window` of time, before the
//! errors of an offset or of wide steps add up.

use super::model::{Correction, Model, Samples};
use crate::attitude::Attitude;
use crate::math::log;
use nalgebra::{DMatrix, Matrix3, SymmetricEigen};

/// The elements of a symmetric tensor: their rows and columns.
const ELEMENTS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)];

/// The least moment, in units of the largest, with which a fit begins: noise may show none.
const LEAST: f64 = 0.02;

/// The numbers of `model` from which a fit of this flight begins, with the axes turned or not, and with
/// or without terms of an offset and a drag; `None` if they are not determined.
pub(super) fn numbers(
    samples: &Samples,
    window: f64,
    model: &Model,
    turned: bool,
    resisted: bool,
) -> Option<Vec<f64>> {
    let elements = least(samples, window, if turned { 6 } else { 3 }, resisted)?;
    let mut tensor = Matrix3::zeros();
    for (value, (i, j)) in elements.iter().zip(ELEMENTS) {
        tensor[(i, j)] = *value;
        tensor[(j, i)] = *value;
    }
    let principal = SymmetricEigen::new(tensor);
    let mut moments: [f64; 3] = principal.eigenvalues.into();
    let mut axes: [[f64; 3]; 3] = principal.eigenvectors.into();
    // Each principal axis gets the number of the sensor's axis that it is nearest to.
    for i in 0..2 {
        let nearer = |a: &usize, b: &usize| axes[*a][i].abs().total_cmp(&axes[*b][i].abs());
        let nearest = (i..3).max_by(nearer).unwrap_or(i);
        moments.swap(i, nearest);
        axes.swap(i, nearest);
    }
    for (i, axis) in axes.iter_mut().enumerate() {
        let sign = axis[i].signum();
        *axis = axis.map(|x| sign * x);
    }
    let largest = moments.into_iter().fold(0.0, f64::max);
    let moments = moments.map(|moment| moment.max(LEAST * largest));
    let mut numbers = vec![0.0; model.numbers()];
    numbers[0] = log(moments[0] / moments[2]);
    numbers[1] = log(moments[1] / moments[2]);
    let first = samples.rates[0];
    for (number, axis) in numbers[2..].iter_mut().zip(&axes) {
        *number = (0..3).map(|k| axis[k] * first[k]).sum();
    }
    if let Some(at) = model.place(Correction::Axes).filter(|_| turned) {
        let turn = Attitude::from_matrix([0, 1, 2].map(|row| axes.map(|axis| axis[row]))).ok()?;
        numbers[at..at + 3].copy_from_slice(&turn.rotation_vector().to_array());
    }
    Some(numbers)
}

/// The elements, of length 1, that make the left side least; of positive trace. With `resisted` the left
/// side has terms A s + c t besides, with any matrix A and vector c, and s the integral of w: so an offset
/// and a drag enter, which are then left aside.
fn least(samples: &Samples, window: f64, count: usize, resisted: bool) -> Option<Vec<f64>> {
    let all = count + if resisted { 12 } else { 0 };
    let mut products = vec![[0.0; 3]; count];
    let mut turned = [0.0; 3];
    let mut matrix = DMatrix::<f64>::zeros(all, all);
    let (mut first, mut from) = (samples.rates[0], 0.0);
    for k in 1..samples.times.len() {
        if samples.times[k - 1] - from > window {
            (first, from) = (samples.rates[k - 1], samples.times[k - 1]);
            (products, turned) = (vec![[0.0; 3]; count], [0.0; 3]);
        }
        let (before, now) = (samples.rates[k - 1], samples.rates[k]);
        let half = 0.5 * (samples.times[k] - samples.times[k - 1]);
        let change = [0, 1, 2].map(|i| now[i] - first[i]);
        let mut sides: Vec<[f64; 3]> = Vec::with_capacity(all);
        for (element, sum) in ELEMENTS.iter().zip(&mut products) {
            let [a, b] = [before, now].map(|w| cross(w, momentum(w, *element)));
            let own = momentum(change, *element);
            for i in 0..3 {
                sum[i] += half * (a[i] + b[i]);
            }
            sides.push([0, 1, 2].map(|i| own[i] + sum[i]));
        }
        for i in 0..3 {
            turned[i] += half * (before[i] + now[i]);
        }
        if resisted {
            for length in turned.into_iter().chain([samples.times[k] - from]) {
                sides.extend(
                    (0..3).map(|row| [0, 1, 2].map(|i| if i == row { length } else { 0.0 })),
                );
            }
        }
        for (i, a) in sides.iter().enumerate() {
            for (j, b) in sides.iter().enumerate() {
                matrix[(i, j)] += (0..3).map(|n| a[n] * b[n]).sum::<f64>();
            }
        }
    }
    let mut own = matrix.view((0, 0), (count, count)).into_owned();
    if resisted {
        // The others take what values make the rest least.
        let across = matrix.view((count, 0), (12, count)).into_owned();
        let others = matrix.view((count, count), (12, 12)).into_owned().cholesky()?;
        own -= across.tr_mul(&others.solve(&across));
    }
    let eigen = SymmetricEigen::new(own);
    let vector = eigen.eigenvectors.column(eigen.eigenvalues.imin());
    let sign = (0..3).map(|i| vector[i]).sum::<f64>().signum();
    Some(vector.iter().map(|x| sign * x).collect())
}

/// The angular momentum of these rates with a tensor that has this element alone.
fn momentum(w: [f64; 3], (i, j): (usize, usize)) -> [f64; 3] {
    let mut momentum = [0.0; 3];
    momentum[i] += w[j];
    if i != j {
        momentum[j] += w[i];
    }
    momentum
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
