//! Where a fit begins: moments from the rates themselves, by linear algebra.
//!
//! On the sensor's axes a free body has d(J w)/dt + w x J w = 0. Integrated from the start this is
//! J (w(t) - w(0)) + S(t) = 0, where S is the integral of w x J w: linear in the tensor J, whose trace is set
//! to 1. So J is a problem of linear least squares, and no rate is differentiated. An offset and a drag
//! add terms A s(t) + c t, with the integral s of w, a small matrix A and a small vector c. What the rates
//! leave open is drawn to usual sizes (ridge regression: A. E. Hoerl, R. W. Kennard, *Technometrics* 12, 55
//! (1970)). In a long flight the integrals begin anew after each `window` of time, before errors add up.

use super::model::{Correction, Model, Samples};
use crate::math::log;
use nalgebra::{DMatrix, DVector, Matrix3, SymmetricEigen, Vector3};

/// The least moment, in units of the largest, with which a fit begins: noise may show none.
const LEAST: f64 = 0.02;

/// Usual sizes of what is added to a third of the unit tensor, of A and c: a brick of 4:2:1 that is turned by
/// 20 degrees; offsets and drags of a tenth (rad/s, 1/s).
const USUAL: [f64; 3] = [0.2, 0.05, 0.02];

/// The numbers of `model` from which a fit of this flight begins, with axes that are `turned` or not, and with the
/// terms of an offset and a drag if it is `resisted`; `None` if they are not determined.
pub(super) fn numbers(
    samples: &Samples,
    window: f64,
    model: &Model,
    [turned, resisted]: [bool; 2],
) -> Option<Vec<f64>> {
    let principal = SymmetricEigen::new(tensor(samples, window, turned, resisted)?);
    let least = LEAST * principal.eigenvalues.max();
    let logs = principal.eigenvalues.map(|moment| log(moment.max(least)));
    let axes = principal.eigenvectors;
    let tensor = axes * Matrix3::from_diagonal(&logs) * axes.transpose();
    let mut numbers = vec![0.0; model.numbers()];
    numbers[0] = tensor.m11 - tensor.m33;
    numbers[1] = tensor.m22 - tensor.m33;
    numbers[2..5].copy_from_slice(&samples.rates[0]);
    if let Some(at) = model.place(Correction::Axes) {
        numbers[at..at + 3].copy_from_slice(&[tensor.m12, tensor.m23, tensor.m31]);
    }
    Some(numbers)
}

/// The tensor of trace 1 that makes the left side least: diagonal if it is not `turned`, with the terms of
/// offset and drag if it is `resisted`.
fn tensor(samples: &Samples, window: f64, turned: bool, resisted: bool) -> Option<Matrix3<f64>> {
    let third = 1.0 / 3.0;
    let off =
        |i, j| Matrix3::from_fn(|a, b| f64::from(u8::from((a, b) == (i, j) || (a, b) == (j, i))));
    let diagonal = |x, y, z| Matrix3::from_diagonal(&Vector3::new(x, y, z));
    let mut parts = vec![diagonal(third, third, third)];
    parts.extend([diagonal(1.0, -1.0, 0.0), diagonal(-0.5, -0.5, 1.0)]);
    if turned {
        parts.extend([off(0, 1), off(1, 2), off(2, 0)]);
    }
    let mut usual = vec![USUAL[0]; parts.len() - 1];
    if resisted {
        usual.extend([USUAL[1]; 9].into_iter().chain([USUAL[2]; 3]));
    }
    let mut products = DMatrix::<f64>::zeros(usual.len() + 1, usual.len() + 1);
    let rate = |k: usize| Vector3::from(samples.rates[k]);
    let (mut from, mut torques, mut turns) =
        (0, vec![Vector3::zeros(); parts.len()], Vector3::zeros());
    for k in 1..samples.times.len() {
        if samples.times[k - 1] - samples.times[from] > window {
            from = k - 1;
            torques.fill(Vector3::zeros());
            turns = Vector3::zeros();
        }
        let half = 0.5 * (samples.times[k] - samples.times[k - 1]);
        let (before, now) = (rate(k - 1), rate(k));
        let mut sides = DMatrix::zeros(3, usual.len() + 1);
        for (n, (part, torque)) in parts.iter().zip(&mut torques).enumerate() {
            *torque += half * (before.cross(&(part * before)) + now.cross(&(part * now)));
            sides.set_column(n, &(part * (now - rate(from)) + *torque));
        }
        turns += half * (before + now);
        if resisted {
            let lengths = [turns.x, turns.y, turns.z, samples.times[k] - samples.times[from]];
            for (n, length) in lengths.into_iter().enumerate() {
                for row in 0..3 {
                    sides[(row, parts.len() + 3 * n + row)] = length;
                }
            }
        }
        products += sides.tr_mul(&sides);
    }
    let count = usual.len();
    let known: DVector<f64> = products.view((1, 0), (count, 1)).column(0).into();
    let equations = (3 * (samples.times.len() - 1)) as f64;
    let mut found = DVector::zeros(count);
    let mut left = products[(0, 0)];
    // The noise is what is left; it is less each time, and a few times are enough for a start.
    for _ in 0..6 {
        let mut normal = products.view((1, 1), (count, count)).into_owned();
        for (i, usual) in usual.iter().enumerate() {
            normal[(i, i)] += (left / equations).max(f64::MIN_POSITIVE) / (usual * usual);
        }
        found = -normal.cholesky()?.solve(&known);
        let full = found.clone().insert_row(0, 1.0);
        left = full.dot(&(&products * &full)).max(0.0);
    }
    let added = parts[1..].iter().zip(&found).map(|(part, x)| part * *x);
    Some(parts[0] + added.sum::<Matrix3<f64>>())
}
