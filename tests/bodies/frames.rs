//! Vectors as others use them: arrays, columns, indices, sums, print.

use nalgebra::Vector3;
use rotation_dynamics::frame::{BodyVector, DesignVector, SpaceVector};

#[test]
fn vectors_convert_both_ways() {
    let given = [1.5, -2.0, 1e-300];
    let vector = BodyVector::from(given);
    assert_eq!(<[f64; 3]>::from(vector), given);
    assert_eq!(Vector3::from(vector), Vector3::from(given));
    assert_eq!(BodyVector::from(Vector3::from(given)), vector);
    assert_eq!([vector[0], vector[1], vector[2]], given);
    assert_eq!(vector.to_array(), given);
}

#[test]
#[should_panic(expected = "index out of bounds: the len is 3 but the index is 3")]
fn a_fourth_component_is_no_component() {
    let vector = SpaceVector::zero();
    let _ = vector[vector.to_array().len()];
}

#[test]
fn sums_start_at_zero() {
    let steps = [DesignVector::new(1.0, 0.0, 0.5), DesignVector::new(0.5, -1.0, 0.5)];
    let sum = DesignVector::new(1.5, -1.0, 1.0);
    assert_eq!(steps.iter().sum::<DesignVector>(), sum);
    assert_eq!(steps.into_iter().sum::<DesignVector>(), sum);
    let none: [DesignVector; 0] = [];
    assert_eq!(none.iter().sum::<DesignVector>(), DesignVector::zero());
}

#[test]
fn print_obeys_precision_width_and_exponent() {
    let vector = SpaceVector::new(1.0, -2.25, 1234.5);
    assert_eq!(format!("{vector}"), "(1, -2.25, 1234.5)");
    assert_eq!(format!("{vector:.3}"), "(1.000, -2.250, 1234.500)");
    assert_eq!(format!("{vector:+.1}"), "(+1.0, -2.2, +1234.5)");
    assert_eq!(format!("{vector:9.2}"), "(     1.00,     -2.25,   1234.50)");
    assert_eq!(format!("{vector:e}"), "(1e0, -2.25e0, 1.2345e3)");
    assert_eq!(format!("{vector:.1e}"), "(1.0e0, -2.2e0, 1.2e3)");
}
