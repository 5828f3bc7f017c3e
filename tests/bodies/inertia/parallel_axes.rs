//! Mass properties: point masses, parts, the parallel-axis theorem.

use super::{case, error, expected};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::error::Error;
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{InertiaTensor, MassProperties, solids};
use rotation_dynamics::math::EPS;
use serde_json::Value;
use support::{Errors, assert_error, assert_largest};

#[test]
fn the_plate_about_its_corner() {
    let case = case("plate_corner");
    let (mass, a) =
        (case["inputs"]["M"].as_f64().expect("M"), case["inputs"]["a"].as_f64().expect("a"));
    let plate = solids::plate(mass, a, a).expect("a plate");
    let corner = plate.about(DesignVector::new(-0.5 * a, -0.5 * a, 0.0)).expect("finite");
    let m = corner.matrix();
    let scale = expected(&case, "Izz")[0];
    assert_error!(error(&[m[0][0]], &expected(&case, "Ixx"), scale), 0.0);
    assert_error!(error(&[m[0][1]], &expected(&case, "Ixy"), scale), 0.4 eps);
    assert_error!(error(&[m[2][2]], &expected(&case, "Izz"), scale), 0.0);
    let moments = corner.principal_axes().moments();
    assert_error!(error(&moments, &expected(&case, "principal"), scale), 0.0);
}

fn reference_points(case: &Value) -> Vec<(f64, DesignVector)> {
    let points = case["inputs"]["points"].as_array().expect("points");
    let number = |v: &Value| v.as_f64().expect("a number");
    let point =
        |p: &Value| (number(&p[0]), DesignVector::new(number(&p[1]), number(&p[2]), number(&p[3])));
    points.iter().map(point).collect()
}

#[test]
fn point_masses_of_the_reference_file() {
    let case = case("inertia_points");
    let points = reference_points(&case);
    let body = MassProperties::of_points(&points).expect("a body");
    let moments = body.about_centre_of_mass().principal_axes().moments();
    assert_eq!(vec![body.mass()], expected(&case, "mass"));
    let centre = body.centre_of_mass().to_array();
    assert_error!(error(&centre, &expected(&case, "cm"), 1.0), 0.0);
    let tensor = body.about_centre_of_mass().matrix();
    let scale = moments[2];
    assert_error!(error(tensor.as_flattened(), &expected(&case, "I_cm"), scale), 0.7 eps);
    assert_error!(error(&moments, &expected(&case, "principal"), scale), 2.7 eps);
    // The sum over points about the origin, directly: I_ij = sum m (r^2 delta_ij - r_i r_j).
    let mut about_origin = [[0.0; 3]; 3];
    for (m, r) in &points {
        let c = r.to_array();
        for i in 0..3 {
            for j in 0..3 {
                about_origin[i][j] += m * (if i == j { r.dot(r) } else { 0.0 } - c[i] * c[j]);
            }
        }
    }
    let by_theorem = body.about(DesignVector::zero()).expect("finite").matrix();
    let (sum, theorem) = (about_origin.as_flattened(), by_theorem.as_flattened());
    assert_error!(error(sum, theorem, scale), 0.34 eps);
}

#[test]
fn the_parallel_axis_theorem_holds_only_from_the_centre_of_mass() {
    let case = case("inertia_points");
    let body = MassProperties::of_points(&reference_points(&case)).expect("a body");
    let (p, q) = (DesignVector::new(0.3, -1.0, 0.2), DesignVector::new(-2.0, 0.4, 0.9));
    let about_p = body.about(p).expect("finite");
    // From p back to the centre of mass, and on to q: the same as from the centre directly.
    let back = MassProperties::from_tensor_about(p, body.mass(), body.centre_of_mass(), about_p);
    let about_q = back.expect("a body").about(q).expect("finite").matrix();
    let direct = body.about(q).expect("finite").matrix();
    let (stepwise, at_once) = (about_q.as_flattened(), direct.as_flattened());
    assert_error!(error(stepwise, at_once, direct[1][1]), 0.2 eps);
    // Damaged (a slip of the notes' wording): M a^2 added to the moment about an
    // axis that misses the centre of mass.
    let axis = DesignVector::new(0.0, 0.0, 1.0);
    let step = q - p;
    let square = step.x() * step.x() + step.y() * step.y();
    let wrong = about_p.moment_about(axis).expect("an axis") + body.mass() * square;
    let right = body.about(q).expect("finite").moment_about(axis).expect("an axis");
    assert!((wrong - right).abs() > 0.1 * right);
    // What no body can be: a small tensor about a point far from the centre.
    let small = InertiaTensor::diagonal([1.0, 1.0, 1.0]).expect("a body");
    let far = DesignVector::new(10.0, 0.0, 0.0);
    let refused = MassProperties::from_tensor_about(far, 1.0, DesignVector::zero(), small);
    assert!(matches!(refused, Err(Error::NotABody { excess, .. }) if excess == 199.0));
}

#[test]
fn parts_make_a_whole() {
    // A rod cut in two is the rod; a disc with a rod through it is the wheel's sum.
    let whole = solids::rod(2.0, 3.0).expect("a rod");
    let half = solids::rod(1.0, 1.5).expect("a rod");
    let up = half.displaced(DesignVector::new(0.0, 0.0, 0.75)).expect("finite");
    let down = half.displaced(DesignVector::new(0.0, 0.0, -0.75)).expect("finite");
    let joined = MassProperties::of_parts(&[up, down]).expect("a body");
    assert_eq!(joined, whole);
    let disc = solids::disc(4.0, 0.5).expect("a disc");
    let wheel = MassProperties::of_parts(&[disc, whole]).expect("a body");
    let moments = wheel.about_centre_of_mass().principal_axes().moments();
    assert_eq!(moments, [0.5, 1.75, 1.75]);
    assert!(MassProperties::of_parts(&[]).is_err());
}

/// A part mounted askew, against its points turned one by one.
#[test]
fn a_part_is_turned_as_its_points_are() {
    let points = [
        (1.5, DesignVector::new(0.4, -0.2, 1.1)),
        (0.3, DesignVector::new(-1.0, 0.5, 0.2)),
        (2.0, DesignVector::new(0.1, 0.9, -0.7)),
        (0.7, DesignVector::new(0.0, -0.8, -0.3)),
    ];
    let part = MassProperties::of_points(&points).expect("masses");
    let [mut elements, mut centre, mut damaged] =
        ["elements", "centre", "turned back"].map(|what| Errors::in_units_of(EPS, what));
    for n in 1..=200 {
        let turn = |n: f64| {
            let (phi, theta, zeta) = (0.7 * n, 0.3 * n, 1.9 * n);
            Attitude::from_euler(EulerAngles { phi, theta, zeta }).expect("finite")
        };
        let rotation = turn(f64::from(n));
        let there = |r: DesignVector| rotation.to_space(r.to_array().into()).to_array();
        let moved = points.map(|(m, r)| (m, there(r).into()));
        let want = MassProperties::of_points(&moved).expect("masses");
        let got = part.turned(&rotation).expect("finite");
        let back = part.turned(&rotation.inverse()).expect("finite");
        let largest = want.about_centre_of_mass().principal_axes().moments()[2];
        let rows = want.about_centre_of_mass().matrix();
        let pairs = |of: &MassProperties| {
            let of = of.about_centre_of_mass().matrix();
            error(of.as_flattened(), rows.as_flattened(), largest)
        };
        elements.push(pairs(&got));
        damaged.push(pairs(&back));
        let off = got.centre_of_mass() - want.centre_of_mass();
        centre.add(off.norm(), 0.0, want.centre_of_mass().norm());
    }
    assert_largest!(elements, 200, @"8.18");
    assert_largest!(centre, 200, @"9.36");
    damaged.exceed(1e10, 200);
}
