//! Principal moments and axes.

use super::error;
use rotation_dynamics::frame::{BodyVector, DesignVector};
use rotation_dynamics::inertia::{InertiaTensor, solids};
use rotation_dynamics::math::EPS;
use support::{Errors, assert_error, assert_largest};

fn tensor_of([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> InertiaTensor {
    InertiaTensor::new([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).expect("a body's tensor")
}

#[test]
fn principal_moments_against_80_digits() {
    let [mut moment, mut damaged, mut residual, mut hand, mut turned] =
        ["moments", "moments off by 1e-15", "I e - I e", "triad", "attitude"]
            .map(|what| Errors::in_units_of(EPS, what));
    for line in include_str!("../../data/inertia.txt").lines().skip(1) {
        let numbers: Vec<f64> =
            line.split(' ').skip(1).map(|c| c.parse().expect("a number")).collect();
        let six: [f64; 6] = numbers[..6].try_into().expect("six elements");
        let tensor = tensor_of(six);
        let principal = tensor.principal_axes();
        let got = principal.moments();
        for i in 0..3 {
            let off = (got[i] - numbers[6 + i]) - numbers[9 + i];
            moment.add(off, 0.0, numbers[8]);
            damaged.add(off + 1e-15 * got[i], 0.0, numbers[8]);
        }
        let axes = principal.axes();
        for i in 0..3 {
            let along = tensor.angular_momentum(axes[i]) - axes[i] * got[i];
            residual.add(along.norm(), 0.0, got[2]);
            // A right-handed orthonormal triad.
            let third = axes[i].cross(&axes[(i + 1) % 3]) - axes[(i + 2) % 3];
            hand.push(third.norm());
        }
        let attitude = principal.attitude().expect("a rotation");
        let first = attitude.to_space(BodyVector::new(1.0, 0.0, 0.0)).to_array();
        turned.push(error(&first, &axes[0].to_array(), 1.0));
    }
    assert_largest!(moment, 3 * 160, @"2.37");
    assert!(damaged.largest() > 11.0);
    assert_largest!(residual, 3 * 160, @"3.28");
    assert_largest!(hand, 3 * 160, @"6.73");
    assert_largest!(turned, 160, @"5.5");
}

#[test]
fn a_diagonal_tensor_keeps_its_axes() {
    let mut count = 0;
    for moments in [[3.0, 2.0, 4.0], [2.0, 2.0, 1.0], [1.0, 1.0, 1.0], [4.0, 3.0, 2.0]] {
        let principal = InertiaTensor::diagonal(moments).expect("a body").principal_axes();
        let mut ascending = moments;
        ascending.sort_by(f64::total_cmp);
        assert_eq!(principal.moments(), ascending);
        let [a, b, c] = principal.axes();
        assert_eq!(a.cross(&b), c);
        for axis in [a, b, c] {
            assert_eq!(axis.to_array().map(f64::abs).iter().sum::<f64>(), 1.0);
        }
        count += 1;
    }
    assert_eq!(count, 4);
    // The notes' square about its corner: the diagonal and the two across it.
    let plate = solids::plate(12.0, 1.0, 1.0).expect("a plate");
    let corner = plate.about(DesignVector::new(-0.5, -0.5, 0.0)).expect("finite");
    let axes = corner.principal_axes().axes();
    let half = 0.5_f64.sqrt();
    let along = axes[0].dot(&DesignVector::new(half, half, 0.0)).abs();
    let across = axes[1].dot(&DesignVector::new(-half, half, 0.0)).abs();
    assert_error!(along, 1.0, 0.0 eps);
    assert_error!(across, 1.0, 0.0 eps);
}
