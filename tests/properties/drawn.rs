//! What is drawn: all that is legal, with its edges.

use core::ops::Range;
use proptest::prelude::*;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{exp, sincos};

/// 10^x, x even in the range.
pub fn decades(range: Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|x| exp(x * core::f64::consts::LN_10))
}

/// A small number, exactly 0 one time in four.
fn small() -> impl Strategy<Value = f64> {
    let size = decades(-17.0..-6.0);
    prop_oneof![1 => Just(0.0), 3 => (size, any::<bool>()).prop_map(|(x, up)| if up { x } else { -x })]
}

/// Any attitude; one in four at or beside a pole, one in eight half a turn, or none.
pub fn attitude() -> impl Strategy<Value = Attitude> {
    let even = prop::array::uniform4(-1.0..1.0).prop_filter_map("has a length", |q| {
        let square: f64 = q.iter().map(|x| x * x).sum();
        (square > 1e-3).then(|| Attitude::from_quaternion(q).unwrap())
    });
    let pole = (-3.2..3.2, small(), small(), any::<bool>()).prop_map(|(turn, x, y, down)| {
        let (s, c) = sincos(turn);
        let q = if down { [x, c, s, y] } else { [c, x, y, s] };
        Attitude::from_quaternion(q).unwrap()
    });
    let half = (0..4_usize, small()).prop_map(|(axis, off)| {
        let mut q = [off; 4];
        q[axis] = 1.0;
        Attitude::from_quaternion(q).unwrap()
    });
    prop_oneof![5 => even, 2 => pole, 1 => half]
}

/// Any direction; one in four along an axis, or beside it.
pub fn direction() -> impl Strategy<Value = [f64; 3]> {
    attitude().prop_map(|attitude| attitude.axis().to_array())
}

/// Masses in three planes through the centre make any body there is: needles, discs, near
/// spheres, symmetric ones and three different moments, of 1e-40 to 1e38 kg m^2.
pub fn moments() -> impl Strategy<Value = PrincipalMoments> {
    let part = || prop_oneof![6 => 0.1..1.0, 1 => decades(-9.0..0.0), 1 => Just(1.0)];
    let near = small().prop_map(|x| 1.0 + x);
    let shapes = prop_oneof![
        6 => (part(), part(), part()),
        2 => (part(), near, Just(1.0)),
        1 => (Just(0.0), part(), part()),
    ];
    (shapes, decades(-40.0..38.0), 0..6_usize).prop_filter_map(
        "is a body",
        |((a, b, c), scale, order)| {
            let of = [(b + c) * scale, (c + a) * scale, (a + b) * scale];
            let [i, j, k] =
                [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]][order];
            PrincipalMoments::new(of[i], of[j], of[k]).ok()
        },
    )
}

/// Angular velocities of 1e-200 to 1e8 rad/s.
pub fn rates() -> impl Strategy<Value = BodyVector> {
    let size = prop_oneof![6 => decades(-2.0..3.0), 1 => decades(-200.0..8.0)];
    (direction(), size)
        .prop_map(|(direction, size)| BodyVector::from_array(direction.map(|x| x * size)))
}

/// A span in radians of the fastest rate: up to a million, and back.
pub fn radians() -> impl Strategy<Value = f64> {
    (decades(-3.0..6.0), any::<bool>()).prop_map(|(x, back)| if back { -x } else { x })
}
