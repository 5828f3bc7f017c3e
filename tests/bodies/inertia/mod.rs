//! Moments of inertia and the body: against 80-digit values (tests/data/inertia.txt,
//! written by inertia.py), the reference file, and what must hold for any body.
//!
//! eps = 2^-53.

mod body;
mod designed;
mod parallel_axes;
mod principal_axes;
mod solids;
mod thrown;

use rotation_dynamics::error::Error;
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{
    InertiaTensor, MassProperties, PrincipalMoments, solids as solid,
};
use serde_json::Value;
use support::Errors;

/// A static case of the reference file.
fn case(problem: &str) -> Value {
    let file: Value =
        serde_json::from_str(include_str!("../../data/reference.json")).expect("json");
    let cases = file["cases"].as_array().expect("cases");
    let found = cases.iter().find(|case| case["problem"] == problem);
    found.expect("the case").clone()
}

fn expected(case: &Value, name: &str) -> Vec<f64> {
    let parse = |v: &Value| -> f64 { v.as_str().expect("text").parse().expect("a number") };
    match &case["expect"][name] {
        Value::Array(list) => list.iter().map(parse).collect(),
        one => vec![parse(one)],
    }
}

/// The largest |a - b|/scale.
fn error(a: &[f64], b: &[f64], scale: f64) -> f64 {
    assert!(a.len() == b.len() && !a.is_empty());
    let mut errors = Errors::of("components");
    a.iter().zip(b).for_each(|(a, b)| errors.add(*a, *b, scale));
    errors.largest()
}

#[test]
fn impossible_bodies_are_refused_with_the_numbers() {
    let message = |r: rotation_dynamics::Result<PrincipalMoments>| r.unwrap_err().to_string();
    assert_eq!(
        message(PrincipalMoments::symmetric(1.0, 2.5)),
        "the moments of inertia (1, 1, 2.5) belong to no body: none may exceed the sum of the \
         other two, and the largest does by 0.5 (rounding explains 8.88e-15)"
    );
    assert_eq!(
        message(PrincipalMoments::new(-1.0, 1.0, 1.0)),
        "I1 = -1 is not allowed: it must be greater than 0"
    );
    let mut count = 0;
    for bad in [0.0, -0.0, -1e-300, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..3 {
            let mut m = [1.0; 3];
            m[place] = bad;
            assert!(PrincipalMoments::new(m[0], m[1], m[2]).is_err(), "{m:?}");
            count += 1;
        }
        let solids = [
            solid::rod(bad, 1.0),
            solid::rod(1.0, bad),
            solid::hoop(1.0, bad),
            solid::disc(1.0, bad),
            solid::cylinder(1.0, bad, 1.0),
            solid::cylinder(1.0, 1.0, bad),
            solid::sphere(1.0, bad),
            solid::spherical_shell(bad, 1.0),
            solid::plate(1.0, 1.0, bad),
            solid::cuboid(1.0, 1.0, bad, 1.0),
            solid::cone(1.0, 1.0, bad),
            solid::hollow_cylinder(1.0, bad, 1.0, 1.0),
        ];
        for solid in solids {
            assert!(solid.is_err());
            count += 1;
        }
    }
    assert_eq!(count, 90);
    // Equality is a lamina and passes, in decimals too; a trace more does not.
    assert!(PrincipalMoments::new(0.1, 0.7, 0.8).is_ok());
    assert!(PrincipalMoments::new(1.0, 1.0, 1e-12).is_ok());
    assert!(PrincipalMoments::symmetric(1.0, 2.0).is_ok());
    assert!(PrincipalMoments::symmetric(1e308, 1.5e308).is_ok());
    assert!(PrincipalMoments::symmetric(1.0, 2.0 + 8e-15).is_err());
    assert!(solid::hollow_cylinder(1.0, 2.0, 1.0, 1.0).is_err());
    assert!(solid::sphere(1.0, 1e200).is_err());

    let skew = [[1.0, 0.1, 0.0], [0.2, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let error = InertiaTensor::new(skew).unwrap_err();
    assert!(
        matches!(
            error,
            Error::OutOfRange {
                name: "difference of elements across the diagonal",
                value: 0.1,
                ..
            }
        ),
        "{error}"
    );
    assert!(matches!(
        InertiaTensor::diagonal([1.0, 1.0, 2.1]),
        Err(Error::NotABody { excess, .. }) if excess > 0.0
    ));
    // Positive on the diagonal is not enough: the principal moments are 0.5, 0.5, 2.
    let bent = InertiaTensor::new([[1.0, 0.5, 0.5], [0.5, 1.0, 0.5], [0.5, 0.5, 1.0]]);
    assert!(matches!(bent, Err(Error::NotABody { excess, .. }) if excess > 0.0), "{bent:?}");
    let negative = InertiaTensor::new([[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert!(matches!(negative, Err(Error::NotABody { excess, .. }) if excess > 0.0));
    let rod = solid::rod(1.0, 1.0).expect("a rod").about_centre_of_mass();
    assert!(rod.principal_axes().principal_moments().is_err(), "a thin rod does not spin");
    assert!(rod.moment_about(DesignVector::zero()).is_err());
    assert!(MassProperties::of_points(&[]).is_err());
    assert!(MassProperties::of_points(&[(1.0, DesignVector::new(f64::NAN, 0.0, 0.0))]).is_err());
}
