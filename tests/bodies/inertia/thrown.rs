//! A body of parts, thrown: its motion on the axes of its drawing, by two routes.

use super::designed::askew;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::DesignedBody;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{MassProperties, solids};
use rotation_dynamics::integrators::{Dop853, Integrator, Ode, size_or};
use support::{Errors, assert_largest};

type Matrix = [[f64; 3]; 3];

/// Euler's equations with the whole tensor, I w' = (I w) x w, and q' = q w/2, on the axes
/// of the drawing.
struct OnTheDrawing {
    tensor: Matrix,
    inverse: Matrix,
}

impl OnTheDrawing {
    fn new(tensor: Matrix) -> Self {
        let [[a, d, e], [_, b, f], [_, _, c]] = tensor;
        let minors = [
            [b * c - f * f, e * f - d * c, d * f - e * b],
            [e * f - d * c, a * c - e * e, d * e - a * f],
            [d * f - e * b, d * e - a * f, a * b - d * d],
        ];
        let determinant = a * minors[0][0] + d * minors[0][1] + e * minors[0][2];
        let inverse = minors.map(|row| row.map(|m| m / determinant));
        Self { tensor, inverse }
    }
}

fn times(m: &Matrix, v: [f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

impl Ode<7> for OnTheDrawing {
    fn derivative(&self, _t: f64, &[a, b, c, w, x, y, z]: &[f64; 7]) -> [f64; 7] {
        let [p, q, r] = times(&self.tensor, [a, b, c]);
        let torque = [q * c - r * b, r * a - p * c, p * b - q * a];
        let [da, db, dc] = times(&self.inverse, torque);
        [
            da,
            db,
            dc,
            -0.5 * (x * a + y * b + z * c),
            0.5 * (w * a + y * c - z * b),
            0.5 * (w * b + z * a - x * c),
            0.5 * (w * c + x * b - y * a),
        ]
    }

    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        size_or([1.0; 7])(y)
    }
}

/// An angle of two cuboids, of a steel of 5000 kg/m^3.
fn angle_iron() -> MassProperties {
    let part = |mass, edges: [f64; 3], at: [f64; 3]| {
        let [a, b, c] = edges;
        solids::cuboid(mass, a, b, c)?.displaced(at.into())
    };
    let parts = [
        part(0.6, [0.30, 0.02, 0.02], [0.15, 0.01, 0.01]).expect("a leg"),
        part(0.36, [0.02, 0.18, 0.02], [0.01, 0.11, 0.01]).expect("a leg"),
        // And a weight screwed on, which takes the last symmetry away.
        MassProperties::of_points(&[
            (0.1, DesignVector::new(0.3, 0.01, 0.05)),
            (0.05, DesignVector::new(0.01, 0.2, -0.04)),
            (0.05, DesignVector::new(0.0, 0.0, 0.0)),
        ])
        .expect("weights"),
    ];
    MassProperties::of_parts(&parts).expect("a body")
}

#[test]
fn thrown_it_moves_as_the_whole_tensor_says() {
    let parts = angle_iron();
    let corner = DesignVector::zero();
    let omega = [12.0, 1.0, -2.0];
    let start = askew(3);
    let dop = Dop853::new(1e-14).expect("a tolerance");
    let [mut attitude, mut rates] = ["attitude", "rates"].map(Errors::of);
    let mut damaged = Errors::of("products of inertia without their minus sign");
    // Thrown, about its centre of mass; and turning about its corner without weight.
    for tensor in [parts.about_centre_of_mass(), parts.about(corner).expect("finite")] {
        let body = DesignedBody::new(&tensor).expect("a body");
        let state = body.state(start, omega.into()).expect("finite").principal();
        let rigid = body.rigid_body();
        let motion = FreeBody::new(rigid.moments(), state.attitude, rigid.angular_velocity(&state))
            .expect("a motion");
        let system = OnTheDrawing::new(tensor.matrix());
        let mut flipped = tensor.matrix();
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            flipped[i][j] = -flipped[i][j];
            flipped[j][i] = -flipped[j][i];
        }
        let wrong = OnTheDrawing::new(flipped);
        let [w, x, y, z] = start.quaternion();
        let first = [omega[0], omega[1], omega[2], w, x, y, z];
        for t in [0.1, 0.5, 2.0] {
            let then = rigid.state(motion.attitude(t), motion.angular_velocity(t));
            let then = body.from_principal(then.expect("finite"));
            let compare = |system: &OnTheDrawing| {
                let (end, _) = dop.advance(system, 0.0, &first, t).expect("a run");
                let turned = Attitude::from_quaternion([end[3], end[4], end[5], end[6]]);
                let turned = turned.expect("a quaternion");
                let w = DesignVector::new(end[0], end[1], end[2]);
                let off = (then.angular_velocity() - w).norm() / 12.2;
                (then.attitude().angle_to(&turned), off)
            };
            let (turned, off) = compare(&system);
            attitude.push(turned);
            rates.push(off);
            damaged.push(compare(&wrong).0);
        }
    }
    assert_largest!(attitude, 6, @"1.12e-14");
    assert_largest!(rates, 6, @"4.06e-15");
    damaged.exceed(0.1, 6);
}
