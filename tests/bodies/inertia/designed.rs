//! A body on the axes of its drawing: the principal axes found, kept and undone.

use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::DesignedBody;
use rotation_dynamics::frame::{BodyVector, DesignVector};
use rotation_dynamics::inertia::{InertiaTensor, MassProperties, solids};
use rotation_dynamics::math::EPS;
use support::{Errors, assert_error, assert_largest};

type Matrix = [[f64; 3]; 3];

/// A tensor, and its moments, ascending, as pairs of doubles.
fn references() -> Vec<(InertiaTensor, [[f64; 2]; 3])> {
    include_str!("../../data/inertia.txt")
        .lines()
        .skip(1)
        .map(|line| {
            let n: Vec<f64> =
                line.split(' ').skip(1).map(|c| c.parse().expect("a number")).collect();
            let matrix = [[n[0], n[3], n[4]], [n[3], n[1], n[5]], [n[4], n[5], n[2]]];
            let tensor = InertiaTensor::new(matrix).expect("a body's tensor");
            (tensor, [6, 7, 8].map(|i| [n[i], n[i + 3]]))
        })
        .collect()
}

/// R diag(moments) R^T.
fn turned(moments: [f64; 3], rotation: &Attitude) -> Matrix {
    let r = rotation.matrix();
    let element = |i: usize, j: usize| (0..3).map(|k| r[i][k] * moments[k] * r[j][k]).sum();
    // The upper half for both.
    [0, 1, 2].map(|i: usize| [0, 1, 2].map(|j: usize| element(i.min(j), i.max(j))))
}

pub(super) fn askew(n: usize) -> Attitude {
    let n = n as f64;
    let angles = EulerAngles { phi: 0.37 * n, theta: 0.19 * n, zeta: 0.83 * n };
    Attitude::from_euler(angles).expect("finite")
}

/// The rotation principal axes -> drawing.
fn principal(body: &DesignedBody) -> Attitude {
    let [a, b, c] = body.principal_axes().map(DesignVector::to_array);
    Attitude::from_matrix([0, 1, 2].map(|i| [a[i], b[i], c[i]])).expect("right-handed")
}

#[test]
fn moments_and_axes_of_tensors_with_80_digits() {
    let [mut moments, mut residual, mut damaged] =
        ["moments", "R I R^T", "turned the other way"].map(|what| Errors::in_units_of(EPS, what));
    let (mut farthest, mut raw) = (0.0_f64, 0.0_f64);
    for (tensor, exact) in references() {
        let body = DesignedBody::new(&tensor).expect("a body");
        let largest = exact[2][0];
        let mut got = body.rigid_body().moments().to_array();
        let rotation = principal(&body);
        let wrong = turned(got, &rotation.inverse());
        let back = turned(got, &rotation);
        let mut off = Errors::of("elements");
        for (n, want) in tensor.matrix().as_flattened().iter().enumerate() {
            residual.add(back.as_flattened()[n], *want, largest);
            off.add(wrong.as_flattened()[n], *want, largest);
        }
        damaged.push(off.largest());
        got.sort_by(f64::total_cmp);
        for (got, [leading, rest]) in got.into_iter().zip(exact) {
            moments.push(((got - leading) - rest) / largest);
        }
        farthest = farthest.max(rotation.angle_to(&Attitude::IDENTITY));
        let found = tensor.principal_axes().attitude().expect("a rotation");
        raw = raw.max(found.angle_to(&Attitude::IDENTITY));
    }
    // Half of what makes two of them one.
    assert_largest!(moments, 3 * 160, @"15.8");
    assert_largest!(residual, 9 * 160, @"12.0");
    assert!(damaged.largest() > 1e14);
    // No two right-handed triads are further apart than 62.8 degrees, names and signs
    // of the axes being free.
    assert_error!(farthest, 1.052);
    assert!(farthest <= 1.0961 && raw > 3.0, "{raw}");
}

#[test]
fn what_goes_in_on_the_drawing_comes_out_on_the_drawing() {
    let [mut there, mut momentum, mut rates, mut energy] =
        ["attitude", "momentum", "rates", "energy"].map(|what| Errors::in_units_of(EPS, what));
    let [mut damaged, mut turned_axes] =
        ["rates", "attitudes"].map(|of| Errors::of(format!("principal {of} read on the drawing")));
    for (n, (tensor, [[smallest, _], _, [largest, _]])) in references().into_iter().enumerate() {
        let body = DesignedBody::new(&tensor).expect("a body");
        let given = askew(n);
        let omega = DesignVector::new(0.3, -0.7, 1.1);
        let state = body.state(given, omega).expect("finite");
        let principal = state.principal();
        there.push(state.attitude().angle_to(&given));
        let scale = largest * omega.norm();
        let want = tensor.angular_momentum(omega);
        momentum.add((state.angular_momentum() - want).norm(), 0.0, scale);
        let in_space = given.to_space(want.to_array().into());
        momentum.add((principal.angular_momentum - in_space).norm(), 0.0, scale);
        let back = state.angular_velocity() - omega;
        rates.add(back.norm(), 0.0, omega.norm() * largest / smallest);
        let kinetic = body.rigid_body().kinetic_energy(&principal);
        energy.add(kinetic, tensor.kinetic_energy(omega), scale * omega.norm());
        let point = DesignVector::new(0.2, 0.1, -0.4);
        let seen = state.to_space(point);
        there.push((seen - given.to_space(point.to_array().into())).norm());
        there.push((state.from_space(seen) - point).norm());
        let unread = body.rigid_body().angular_velocity(&principal).to_array();
        damaged.push((DesignVector::from(unread) - omega).norm());
        // The attitude of the principal axes is another one, and comes back to the same state.
        turned_axes.push(principal.attitude.angle_to(&given));
        assert_eq!(body.from_principal(principal), state);
    }
    assert_largest!(there, 3 * 160, @"4.39");
    assert_largest!(momentum, 2 * 160, @"15.4");
    assert_largest!(rates, 160, @"7.96");
    assert_largest!(energy, 160, @"8.94");
    assert!(damaged.largest() > 1.0 && turned_axes.largest() > 1.0);
}

#[test]
fn axes_that_are_free_are_those_of_the_drawing() {
    // A diagonal tensor is kept to the bit, whatever its order.
    for moments in [[3.0, 2.0, 4.0], [2.0, 2.0, 1.0], [4.0, 1e-20, 4.0], [1.0; 3]] {
        let tensor = InertiaTensor::diagonal(moments).expect("a body");
        let body = DesignedBody::new(&tensor).expect("a body");
        assert_eq!(body.rigid_body().moments().to_array(), moments);
        let omega = DesignVector::new(0.1, 0.2, 0.3);
        assert_eq!(body.to_principal(omega).to_array(), omega.to_array());
    }
    let mut axes = Errors::in_units_of(EPS, "axis of a symmetric body");
    let mut turns = Errors::in_units_of(EPS, "shortest turn");
    for n in 1..=200 {
        let rotation = askew(n);
        let axis = rotation.axis().to_array();
        let k = (0..3).fold(0, |k, i| if axis[i].abs() > axis[k].abs() { i } else { k });
        for along in [0.5, 1.5] {
            let tensor = InertiaTensor::new(turned([1.0, 1.0, along], &rotation));
            let body = DesignedBody::new(&tensor.expect("a body")).expect("a body");
            let moments = body.rigid_body().moments().to_array();
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            assert_eq!(moments[i], moments[j], "{n}");
            let found = body.principal_axes()[k];
            assert!(found[k] > 0.0);
            let parallel = found.cross(&DesignVector::from(axis)).norm();
            axes.push(parallel);
            // It turns by the angle from the drawing's axis and no further.
            let turn = principal(&body).angle_to(&Attitude::IDENTITY);
            let mut e = [0.0; 3];
            e[k] = 1.0;
            let e = DesignVector::from(e);
            let leaning = rotation_dynamics::math::atan2(found.cross(&e).norm(), found.dot(&e));
            turns.push(turn - leaning);
        }
        let sphere = InertiaTensor::new(turned([1.0; 3], &rotation)).expect("a body");
        let sphere = DesignedBody::new(&sphere).expect("a body");
        assert_eq!(principal(&sphere), Attitude::IDENTITY);
        let [a, b, c] = sphere.rigid_body().moments().to_array();
        assert!(a == b && b == c);
    }
    assert_largest!(axes, 400, @"5.93");
    assert_largest!(turns, 400, @"2");
}

#[test]
fn bodies_that_cannot_turn_so_are_refused() {
    let rod = solids::rod(1.0, 1.0).expect("a rod");
    let error = DesignedBody::new(&rod.about_centre_of_mass()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "the moments of inertia (0.08333333333333333, 0.08333333333333333, 0) are those of a rod: \
         it has no moment about its own axis; a body that turns freely needs each greater than 0"
    );
    // Askew, rounding makes something of nothing.
    let mut refused = 0;
    for n in 1..=100 {
        let line = askew(n).to_space(BodyVector::new(1.0, 0.0, 0.0)).to_array();
        let points = [-1.0, 0.3, 0.9].map(|s| (1.5, DesignVector::from(line) * s));
        let rod = MassProperties::of_points(&points).expect("masses");
        let error = DesignedBody::new(&rod.about_centre_of_mass()).unwrap_err();
        let said = error.to_string();
        assert!(
            said.contains("are those of a rod")
                && said.contains("or none above what rounding hides"),
            "{said}"
        );
        refused += 1;
    }
    assert_eq!(refused, 100);
    // A needle that is known to have a moment is a body.
    let needle = InertiaTensor::new(turned([1.0, 1.0, 1e-13], &askew(5))).expect("a body");
    assert!(DesignedBody::new(&needle).is_ok());
    let message = |matrix: Matrix| InertiaTensor::new(matrix).unwrap_err().to_string();
    let said = message(turned([1.0, 2.0, 3.5], &askew(2)));
    assert!(said.contains("belong to no body"), "{said}");
    let said = message(turned([-0.5, 2.0, 2.0], &askew(2)));
    assert!(
        said.contains("belong to no body") && said.contains("(-0.") && said.contains(" by 0.5 "),
        "{said}"
    );
    let said = message([[1.0, 0.1, 0.0], [0.2, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert!(said.contains("must be symmetric") && said.contains("0.1"), "{said}");
    let said = message([[f64::NAN, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    assert!(said.contains("NaN"), "{said}");
    let cuboid = solids::cuboid(1.0, 0.1, 0.2, 0.3).expect("a cuboid");
    let body = DesignedBody::new(&cuboid.about_centre_of_mass()).expect("a body");
    let spin = DesignVector::new(f64::INFINITY, 0.0, 0.0);
    assert!(body.state(Attitude::IDENTITY, spin).is_err());
}
