//! The mass of particles and their resistance to turning.

use super::{InertiaTensor, MassProperties};
use crate::frame::DesignVector;

/// Two particles are a dumb-bell: m1 m2/(m1 + m2) d^2 about what is across, 0 along.
#[test]
fn two_particles_are_a_dumb_bell() {
    let (m1, m2, d) = (0.7, 1.9, 0.6);
    let (near, far) = (DesignVector::new(1.0, -2.0, 0.5), DesignVector::new(1.0, -2.0, 0.5 + d));
    let both = MassProperties::of_points(&[(m1, near), (m2, far)]).expect("a body");
    let matrix = both.about_centre_of_mass().matrix();
    let across = m1 * m2 / (m1 + m2) * d * d;
    for i in 0..3 {
        for j in 0..3 {
            let want = if i == j && i < 2 { across } else { 0.0 };
            assert!((matrix[i][j] - want).abs() < 1e-15, "{matrix:?}");
        }
    }
    assert_eq!(both.mass(), m1 + m2);
}

/// The plate nearest to moments of no body lies along (1, 1, -1).
#[test]
fn the_nearest_plate_is_taken() {
    let matrix = [[1.0, 0.0, 0.0], [0.0, 1.2, 0.0], [0.0, 0.0, 2.5]];
    let moved = InertiaTensor::computed(matrix, 0.5).expect("within rounding");
    let want = [1.1, 1.3, 2.4];
    for (i, want) in want.into_iter().enumerate() {
        assert!((moved.matrix()[i][i] - want).abs() < 1e-14, "{moved:?}");
    }
}
