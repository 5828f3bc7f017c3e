//! Attitude against values of 700 digits, rounded once.

use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::{self, EPS};
use support::{Errors, assert_error, assert_largest, relative};

/// The rows of a kind, as numbers.
fn rows(kind: &str) -> Vec<Vec<f64>> {
    include_str!("../../data/attitude.txt")
        .lines()
        .filter_map(|line| line.strip_prefix(kind)?.strip_prefix(' '))
        .map(|line| line.split(' ').map(|c| c.parse().expect("a number")).collect())
        .collect()
}

fn four(row: &[f64]) -> [f64; 4] {
    row[..4].try_into().expect("four numbers")
}

fn attitude(row: &[f64]) -> Attitude {
    Attitude::from_quaternion(four(row)).expect("a quaternion")
}

fn euler(row: &[f64]) -> EulerAngles {
    let &[phi, theta, zeta] = row else { panic!("three angles, not {row:?}") };
    EulerAngles { phi, theta, zeta }
}

/// How many rows of `kind` are not answered with the correctly rounded reference.
fn rows_missed(kind: &str, inputs: usize, answer: impl Fn(&[f64]) -> Vec<f64>) -> (usize, usize) {
    let rows = rows(kind);
    let missed = rows.iter().filter(|row| answer(&row[..inputs]) != row[inputs..]).count();
    (missed, rows.len())
}

/// The errors of `kind` in eps, where a reference is a pair of doubles and
/// `weigh` says relative to what each component is judged.
fn errors(
    kind: &str,
    inputs: usize,
    answer: impl Fn(&[f64]) -> Vec<f64>,
    weigh: impl Fn(f64) -> f64,
) -> Errors {
    let mut errors = Errors::in_units_of(EPS, kind);
    for row in rows(kind) {
        let got = answer(&row[..inputs]);
        let (leading, rest) = row[inputs..].split_at(got.len());
        for i in 0..got.len() {
            let off = (got[i] - leading[i]) - rest[i];
            errors.push_at(relative(off, 0.0, weigh(leading[i])), &row);
        }
    }
    errors
}

fn angles_of(row: &[f64]) -> Vec<f64> {
    let a = attitude(row).euler_angles();
    vec![a.phi, a.theta, a.zeta]
}

#[test]
fn euler_angles_are_correctly_rounded() {
    assert_eq!(rows_missed("angles", 4, angles_of), (0, 320));
    // Damaged: one component off by an ulp, or the textbook's sum of two arguments.
    let (missed, _) = rows_missed("angles", 4, |row| {
        angles_of(&[row[0], row[1], row[2], row[3] * (1.0 + 2.0 * EPS)])
    });
    assert!(missed >= 170, "{missed}"); // measured 171 of 320
    let (missed, _) = rows_missed("angles", 4, |row| {
        let (h, g) = (math::atan2(row[3], row[0]), math::atan2(row[2], row[1]));
        let theta = 2.0 * math::atan2(math::hypot(row[1], row[2]), math::hypot(row[0], row[3]));
        vec![h + g, theta, h - g]
    });
    assert!(missed >= 211, "{missed}"); // measured 212
}

#[test]
fn euler_angles_where_other_libraries_fail() {
    assert_eq!(rows_missed("failed_elsewhere", 4, angles_of), (0, 4));
    let rows = rows("failed_elsewhere");
    assert_error!(rows[1][5], 1.77e-3); // others gave 0
    assert_error!(rows[3][5], 1.35e-13); // others gave NaN in phi
}

#[test]
fn rotation_vectors_are_correctly_rounded() {
    let answer = |row: &[f64]| attitude(row).rotation_vector().to_array().to_vec();
    assert_eq!(rows_missed("vector", 4, answer), (0, 203));
    // Damaged: half of the angle from the cosine alone.
    let (missed, _) = rows_missed("vector", 4, |row| {
        let factor = 2.0 * math::acos(row[0]) / math::hypot(math::hypot(row[1], row[2]), row[3]);
        row[1..4].iter().map(|c| factor * c).collect()
    });
    assert!(missed >= 175, "{missed}"); // measured 176 of 203
}

#[test]
fn normalisation_is_correctly_rounded_from_1e_minus_300_to_1e300() {
    let answer = |row: &[f64]| attitude(row).quaternion().to_vec();
    assert_eq!(rows_missed("unit", 4, answer), (0, 100));
    let (missed, _) = rows_missed("unit", 4, |row| {
        let norm = row.iter().map(|c| c * c).sum::<f64>().sqrt();
        row.iter().map(|c| c / norm).collect()
    });
    assert!(missed >= 77, "{missed}"); // measured 78 of 100: overflow and underflow
}

#[test]
fn from_euler_keeps_every_component() {
    let answer = |row: &[f64]| {
        let attitude = Attitude::from_euler(euler(row)).expect("finite angles");
        attitude.quaternion().to_vec()
    };
    // Relative error of each component; sin and cos near their zeros count with
    // the condition of their own argument.
    assert_largest!(errors("from_angles", 3, answer, |c| c.abs().max(1e-4)), 4 * 160, @"1.89");
    // Damaged: phi + zeta rounded before it is halved.
    let damaged = errors(
        "from_angles",
        3,
        |row| {
            let (s, c) = math::sincos(row[1] / 2.0);
            let (sum, difference) = ((row[0] + row[2]) / 2.0, (row[0] - row[2]) / 2.0);
            vec![
                c * math::cos(sum),
                s * math::cos(difference),
                s * math::sin(difference),
                c * math::sin(sum),
            ]
        },
        |c| c.abs().max(1e-4),
    );
    assert_largest!(damaged, 4 * 160, @"9.11e14");
}

#[test]
fn from_rotation_vector_keeps_every_component() {
    let answer = |row: &[f64]| {
        let vector = SpaceVector::new(row[0], row[1], row[2]);
        let attitude = Attitude::from_rotation_vector(vector).expect("finite");
        attitude.quaternion().to_vec()
    };
    // A component of 1e-300 has its own relative accuracy too.
    assert_largest!(errors("from_vector", 3, answer, f64::abs), 4 * 180, @"2.35");
    // Damaged: the length rounded to a double.
    let damaged = errors(
        "from_vector",
        3,
        |row| {
            let length = SpaceVector::new(row[0], row[1], row[2]).norm();
            let (s, c) = math::sincos(length / 2.0);
            vec![c, s * row[0] / length, s * row[1] / length, s * row[2] / length]
        },
        f64::abs,
    );
    // The body is turned at random.
    assert_largest!(damaged, 4 * 180, @"9.01e15");
}

#[test]
fn the_angle_between_attitudes_is_correctly_rounded() {
    let answer = |row: &[f64]| vec![attitude(&row[..4]).angle_to(&attitude(&row[4..8]))];
    assert_eq!(rows_missed("between", 8, answer), (0, 140));
    // Damaged: from the rounded product of the two quaternions.
    let (missed, _) = rows_missed("between", 8, |row| {
        let between = attitude(&row[..4]).inverse() * attitude(&row[4..8]);
        vec![between.rotation_vector().norm()]
    });
    assert!(missed >= 109, "{missed}"); // measured 110 of 140
}

#[test]
fn matrices_to_and_fro() {
    let answer = |row: &[f64]| attitude(row).matrix().as_flattened().to_vec();
    assert_largest!(errors("matrix", 4, answer, |_| 1.0), 9 * 150, @"2");
    let transposed = |row: &[f64]| attitude(row).inverse().matrix().as_flattened().to_vec();
    assert!(errors("matrix", 4, transposed, |_| 1.0).largest() > 1e15);

    let mut back_again = Errors::in_units_of(EPS, "from_matrix");
    for row in rows("matrix") {
        let rounded: [[f64; 3]; 3] = [0, 3, 6].map(|i| [row[4 + i], row[5 + i], row[6 + i]]);
        let back = Attitude::from_matrix(rounded).expect("a rotation");
        back_again.push(back.angle_to(&attitude(&row)));
    }
    assert_largest!(back_again, 150, @"1.67");
}

#[test]
fn the_static_case_of_the_reference_file() {
    let file: serde_json::Value =
        serde_json::from_str(include_str!("../../data/reference.json")).expect("json");
    let case = file["cases"]
        .as_array()
        .expect("cases")
        .iter()
        .find(|case| case["problem"] == "euler")
        .expect("the case of Euler angles");
    let input = |name: &str| case["inputs"][name].as_f64().expect("a number");
    let expected = |name: &str| -> Vec<f64> {
        let list = case["expect"][name].as_array().expect("a list");
        let numbers = list.iter().map(|v| v.as_str().expect("text").parse());
        numbers.collect::<Result<_, _>>().expect("numbers")
    };
    let largest = |a: &[f64], b: &[f64]| -> f64 {
        assert!(a.len() == b.len() && !a.is_empty());
        let mut errors = Errors::of("static case");
        a.iter().zip(b).for_each(|(x, y)| errors.push(x - y));
        errors.largest()
    };
    let angles = EulerAngles { phi: input("phi"), theta: input("theta"), zeta: input("zeta") };
    let attitude = Attitude::from_euler(angles).expect("finite angles");
    let matrix = attitude.matrix();
    assert_error!(largest(matrix.as_flattened(), &expected("R")), 1.0 eps);
    assert_error!(largest(&attitude.quaternion(), &expected("quat_wxyz")), 0.0);

    // The vectors agree with the matrix, column by column and row by row.
    let column = |i: usize| [matrix[0][i], matrix[1][i], matrix[2][i]];
    assert_error!(largest(&attitude.axis().to_array(), &column(2)), 0.0);
    assert_error!(largest(&attitude.vertical().to_array(), &matrix[2]), 0.0);
    let mut vectors = Errors::in_units_of(EPS, "columns and rows");
    for (i, e) in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].into_iter().enumerate() {
        let in_space = attitude.to_space(BodyVector::from_array(e));
        vectors.push(largest(&in_space.to_array(), &column(i)));
        let in_body = attitude.to_body(SpaceVector::from_array(e));
        vectors.push(largest(&in_body.to_array(), &matrix[i]));
    }
    assert_largest!(vectors, 6, @"1");
    // Damaged: phi and zeta taken for each other.
    let swapped = EulerAngles { phi: angles.zeta, theta: angles.theta, zeta: angles.phi };
    let wrong = Attitude::from_euler(swapped).expect("finite angles").matrix();
    assert!(largest(wrong.as_flattened(), &expected("R")) > 0.1);
}
