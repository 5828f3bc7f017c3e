//! Section 15.1: where a rigid body is, and the three angles that say how it is turned.

#[path = "ch15_1_euler_angles/figures.rs"]
mod figures;
#[path = "ch15_1_euler_angles/pole.rs"]
mod pole;
#[path = "ch15_1_euler_angles/rigid.rs"]
mod rigid;

use core::f64::consts::{FRAC_PI_2, PI};
use kit::prelude::*;
use kit::{below, supported_digits};
use rotation_dynamics::attitude::{Attitude, EulerAngles, Sequence, YawPitchRoll};
use rotation_dynamics::integrators::{Dop853, Integrator, Ode, Work, ode, size_or};
use rotation_dynamics::math::EPS;

pub use pole::{passing, passing_angles};
pub use rigid::{pushed, stretched};

parameters! {
    /// A displacement of a rigid body: the instance of all pages of Section 15.1.
    pub struct Parameters {
        /// first turn, about Z
        phi: number(0.3, "rad", between(-PI, PI).because("less than half a turn each way: further angles give the same attitude").usually(-3.1, 3.1)).open("first turn, about Z: phi", "clockwise", "counterclockwise");
        /// second turn, about the new x
        theta: number(0.7, "rad", from_to(0.0, PI).because("a negative tilt is that tilt with phi and zeta half a turn further").usually(0.0, 3.1)).open("second turn, about the new x: theta", "upright", "upside down");
        /// third turn, about the newest z
        zeta: number(-0.4, "rad", between(-PI, PI).because("less than half a turn each way: further angles give the same attitude").usually(-3.1, 3.1)).open("third turn, about the newest z: zeta", "clockwise", "counterclockwise");
        /// displacement of the reference point along X
        shift_x: number(1.0, "m", from_to(-1e4, 1e4).usually(-3.0, 3.0));
        /// along Y
        shift_y: number(2.0, "m", from_to(-1e4, 1e4).usually(-3.0, 3.0));
        /// along Z
        shift_z: number(3.0, "m", from_to(-1e4, 1e4).usually(-3.0, 3.0));
        /// by how much the book is turned, each time
        book: number(FRAC_PI_2, "rad", from_to(1e-6, PI).because("the shorter way round; at 0 the book does not turn").usually(0.01, PI));
        /// least tilt of a body that is turned past theta = 0
        closest: number(1e-3, "rad", from_to(1e-6, 0.5).because("it must pass by the pole, and near it").usually(0.01, 0.5));
        /// error of a step where that turning is simulated
        tolerance: number(1e-12, "-", from_to(1e-14, 1e-3));
    }
}

/// Two points of the body, on its own axes, m.
pub const POINTS: [[f64; 3]; 2] = [[0.1, 0.2, 0.3], [-0.4, 0.5, 0.0]];

pub type Matrix = [[f64; 3]; 3];

// ANCHOR: matrix
/// R = Rz(phi) Rx(theta) Rz(zeta), by rows. Its columns are the axes x', y', z.
pub fn matrix([phi, theta, zeta]: [f64; 3]) -> Matrix {
    let ((sp, cp), (st, ct), (sz, cz)) = (sincos(phi), sincos(theta), sincos(zeta));
    [
        [cp * cz - sp * ct * sz, -cp * sz - sp * ct * cz, sp * st],
        [sp * cz + cp * ct * sz, -sp * sz + cp * ct * cz, -cp * st],
        [st * sz, st * cz, ct],
    ]
}

/// The angles of that matrix: phi and zeta from -pi to pi, theta from 0 to pi.
pub fn angles(r: &Matrix) -> [f64; 3] {
    let across = hypot(r[0][2], r[1][2]);
    if across == 0.0 {
        // z is vertical: one angle carries the sum or the difference of two.
        return [atan2(r[1][0], r[0][0]), atan2(0.0, r[2][2]), 0.0];
    }
    let phi = atan2(r[0][2], -r[1][2]);
    [phi, atan2(across, r[2][2]), atan2(r[2][0], r[2][1])]
}
// ANCHOR_END: matrix

// ANCHOR: screw
/// Any displacement: a turn by `angle` about the line through `point` along the
/// unit vector `axis`, and an `advance` along it.
#[derive(Debug, Clone, Copy)]
pub struct Screw {
    pub axis: SpaceVector,
    pub angle: f64,
    pub advance: f64,
    pub point: SpaceVector,
}

impl Screw {
    /// That of the displacement p -> R p + shift.
    pub fn of([phi, theta, zeta]: [f64; 3], shift: SpaceVector) -> Result<Self> {
        let (s, c) = sincos(0.5 * theta);
        let ((sum, cos_sum), (diff, cos_diff)) =
            (sincos(0.5 * (phi + zeta)), sincos(0.5 * (phi - zeta)));
        // A turn by more than pi one way is one by less the other way.
        let sign = 1.0_f64.copysign(cos_sum);
        let half = SpaceVector::new(s * cos_diff, s * diff, c * sum) * sign;
        let angle = 2.0 * atan2(half.norm(), c * cos_sum.abs());
        let angle = from_to(1e-4, PI - 1e-12)
            .because("at 0 there is no axis, at half a turn either sense of it")
            .check("angle of the whole rotation", angle)?;
        let axis = half / half.norm();
        let advance = axis.dot(&shift);
        let across = shift - axis * advance;
        let half_cot = 0.5 * cos(0.5 * angle) / sin(0.5 * angle);
        let point = across * 0.5 + axis.cross(&across) * half_cot;
        Ok(Self { axis, angle, advance, point })
    }

    /// Where this part of the screw motion, 0 to 1, takes a point.
    pub fn moved(&self, point: SpaceVector, part: f64) -> SpaceVector {
        let turned = turned(point - self.point, self.axis, part * self.angle);
        self.point + turned + self.axis * (part * self.advance)
    }
}
// ANCHOR_END: screw

// ANCHOR: rates
/// The rates of (phi, theta, zeta) while the body turns about X with 1 rad/s.
pub fn rates_of_angles() -> impl Ode<3> + Copy {
    ode(|_, [phi, theta, _]: &[f64; 3]| {
        let ((sp, cp), (st, ct)) = (sincos(*phi), sincos(*theta));
        [-sp * ct / st, cp, sp / st]
    })
    .scaled(size_or([1.0; 3]))
}

/// The same turning, of the quaternion (w, x, y, z).
pub fn rates_of_quaternion() -> impl Ode<4> + Copy {
    ode(|_, [w, x, y, z]: &[f64; 4]| [-0.5 * x, 0.5 * w, -0.5 * z, 0.5 * y])
        .scaled(size_or([1.0; 4]))
}
// ANCHOR_END: rates

/// `v` turned by `angle` about the unit vector `axis`.
pub fn turned(v: SpaceVector, axis: SpaceVector, angle: f64) -> SpaceVector {
    let (s, c) = sincos(angle);
    let half = sin(0.5 * angle);
    v * c + axis.cross(&v) * s + axis * (2.0 * half * half * axis.dot(&v))
}

/// The four triads of the notes' figure, (a) to (d): each is the one before it, turned about
/// one of its own axes.
pub fn frames([phi, theta, zeta]: [f64; 3]) -> [[SpaceVector; 3]; 4] {
    let fixed = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(SpaceVector::from_array);
    let turn = |triad: [_; 3], about: usize, angle| triad.map(|v| turned(v, triad[about], angle));
    let first = turn(fixed, 2, phi);
    let second = turn(first, 0, theta);
    [fixed, first, second, turn(second, 2, zeta)]
}

/// R v.
pub fn times_vector(r: &Matrix, v: [f64; 3]) -> SpaceVector {
    SpaceVector::from_array(r.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2]))
}

/// The angle between the two attitudes of a book turned by `a` about two axes at right
/// angles, in either order.
pub fn apart(a: f64) -> f64 {
    let (sin_half, cos_half) = sincos(0.5 * a);
    let square = sin_half * sin_half;
    let half_cos = 1.0 - 2.0 * square * square;
    // cos a/2 keeps its digits near half a turn, where 1 - square has none.
    let half_sin = 2.0 * square * (cos_half * cos_half * (1.0 + square)).sqrt();
    2.0 * atan2(half_sin, half_cos.abs())
}

/// The book after a turn about the level Y and one about the vertical Z, in this order or
/// the other.
pub fn book(a: f64, level_first: bool) -> Result<Attitude> {
    let [level, upright] = [[0.0, a, 0.0], [0.0, 0.0, a]].map(SpaceVector::from_array);
    let [first, then] = if level_first { [level, upright] } else { [upright, level] };
    Ok(Attitude::from_rotation_vector(first)?.turned_in_space(then)?)
}

/// The same attitude without a matrix: the three turns as quaternions.
fn attitude([phi, theta, zeta]: [f64; 3]) -> Result<Attitude> {
    let (x, z) = (BodyVector::new(1.0, 0.0, 0.0), BodyVector::new(0.0, 0.0, 1.0));
    let first = Attitude::about_body_axis(z, phi)?;
    let second = Attitude::about_body_axis(x, theta)?;
    Ok(first * second * Attitude::about_body_axis(z, zeta)?)
}

impl Parameters {
    pub fn angles(&self) -> [f64; 3] {
        [self.phi, self.theta, self.zeta]
    }

    pub fn shift(&self) -> SpaceVector {
        SpaceVector::new(self.shift_x, self.shift_y, self.shift_z)
    }
}

/// The three turns: formulas against triads that are turned one after the other.
fn turns(p: &Parameters, report: &mut Report) -> Result<()> {
    let ((sp, cp), r, bound) = (sincos(p.phi), matrix(p.angles()), 1e-14);
    let [_, first, second, body] = frames(p.angles());
    claims! { report,
        /// x axis after the first turn, along X
        node_x: cp, "-", "a triad turned" => first[0].x(), within bound, in "The three turns": sp => "that is its part along Y";
        /// the same along Y
        node_y: sp, "-", "a triad turned" => first[0].y(), within bound;
        /// z axis after the second turn, along X
        z_x: r[0][2], "-", "a triad turned" => second[2].x(), within bound, in "The three turns":
            -r[0][2] => "turned by theta about x, z moves towards -Y'",
            sin(p.theta) * cp => "phi is the azimuth of the line of nodes, not of z";
        /// the same along Y
        z_y: r[1][2], "-", "a triad turned" => second[2].y(), within bound, in "The three turns":
            -r[1][2] => "turned by theta about x, z moves towards -Y'";
        /// the same along Z
        z_z: r[2][2], "-", "a triad turned" => second[2].z(), within bound;
    }?;
    for (i, along) in ["X", "Y", "Z"].into_iter().enumerate() {
        for (j, axis) in ["x'", "y'", "z"].into_iter().enumerate() {
            let key = format!("r{}{}", i + 1, j + 1);
            let meaning = format!("{axis} axis of the body along {along}");
            let element = claim(key, meaning, r[i][j], "-").against("a triad turned", body[j][i]);
            report.add(element.within(bound))?;
        }
    }
    let (back, library) = (angles(&r), attitude(p.angles())?.euler_angles());
    // A tilt that an arc cosine spoils: of 1 - cos(tilt) whole units of round-off are kept.
    let tilt = 1e-7;
    let kept = (2.0 * sin(0.5 * tilt) * sin(0.5 * tilt) / EPS).round() * EPS;
    claims! { report,
        /// phi, from the matrix
        phi_back: back[0], "rad", "from the quaternion" => library.phi, within bound, in "The angles from the matrix":
            atan2(r[1][2], r[0][2]) => "that is the azimuth of z; phi is that of the line of nodes",
            -back[0] => "look at the sign of the middle element of the last column";
        /// theta, from the matrix
        theta_back: back[1], "rad", "from the quaternion" => library.theta, within bound, in "The angles from the matrix";
        /// zeta, from the matrix
        zeta_back: back[2], "rad", "from the quaternion" => library.zeta, within bound, in "The angles from the matrix":
            atan2(r[2][1], r[2][0]) => "sine before cosine";
        /// a tilt of 1e-7 rad by the arc cosine
        acos_tilt: acos(cos(tilt)), "rad", "the cosine rounded by hand" => (2.0 * kept).sqrt(), within 1e-14 * tilt;
        /// the least tilt but zero that an arc cosine gives
        acos_least: acos(1.0 - EPS), "rad", "sqrt(2 x 2^-53)" => (2.0 * EPS).sqrt(), within 1e-15 * EPS.sqrt();
    }
}

/// The displacement as a whole: distances, rotation, screw; and the book.
fn displacement(p: &Parameters, report: &mut Report) -> Result<()> {
    let (r, shift) = (matrix(p.angles()), p.shift());
    let [a, b] = POINTS.map(|point| times_vector(&r, point) + shift);
    let [c, d] = POINTS.map(SpaceVector::from_array);
    let screw = Screw::of(p.angles(), shift)?;
    let vector = attitude(p.angles())?.rotation_vector();
    let (found, size) = (vector / vector.norm(), 1.0 + shift.norm());
    let bound = 1e-14 / sin(0.5 * screw.angle);
    let on_axis = times_vector(&r, screw.point.to_array()) + shift - screw.point;
    let signed = on_axis.norm().copysign(on_axis.dot(&screw.axis));
    let between = book(p.book, true)?.angle_to(&book(p.book, false)?);
    claims! { report,
        /// distance of two points after the displacement
        distance: (a - b).norm(), "m", "before it" => (c - d).norm(), within 1e-14 * size;
        /// angle of the whole rotation
        angle: screw.angle, "rad", "quaternions multiplied" => vector.norm(), within bound, in "The displacement as a whole":
            p.phi + p.theta + p.zeta => "angles about different axes do not add up",
            0.5 * screw.angle => "that is half of it";
        /// its axis, along X
        axis_x: screw.axis.x(), "-", "quaternions multiplied" => found.x(), within bound;
        /// its axis, along Y
        axis_y: screw.axis.y(), "-", "quaternions multiplied" => found.y(), within bound;
        /// its axis, along Z
        axis_z: screw.axis.z(), "-", "quaternions multiplied" => found.z(), within bound;
        /// advance along the screw axis
        advance: screw.advance, "m", "a point of that axis moved" => signed, within bound * bound * 1e14 * size,
        in "The displacement as a whole": shift.norm() => "only the part along the axis is the same for all points";
        /// the two ends of the book apart
        book_apart: apart(p.book), "rad", "quaternions multiplied" => between, within 4e-15, in "The book":
            p.book => "follow a corner of the book",
            0.0 => "try it with a book";
    }
}

/// The same attitude in the words of others.
fn conventions(p: &Parameters, report: &mut Report) -> Result<()> {
    let (r, attitude, bound) = (matrix(p.angles()), attitude(p.angles())?, 1e-14);
    let YawPitchRoll { yaw, pitch, roll } = attitude.yaw_pitch_roll();
    let ([azimuth, ..], level) = (attitude.angles(Sequence::Zyz), hypot(r[0][0], r[1][0]));
    claims! { report,
        /// azimuth of the z axis
        azimuth: atan2(r[1][2], r[0][2]), "rad", "first angle of z-y'-z''" => azimuth, within bound,
        // An axis that is upright has no azimuth.
        if p.theta > 0.0, in "Other conventions":
            p.phi => "that is the azimuth of the line of nodes",
            p.phi + FRAC_PI_2 => "z leans away from Y', not towards it";
        /// yaw of the same attitude, z-y'-x''
        yaw: atan2(r[1][0], r[0][0]), "rad", "from the quaternion" => yaw, within bound, in "Other conventions";
        /// pitch
        pitch: atan2(-r[2][0], level), "rad", "from the quaternion" => pitch, within bound, in "Other conventions":
            atan2(r[2][0], level) => "a turn about y takes x towards -z";
        /// roll
        roll: atan2(r[2][1], r[2][2]), "rad", "from the quaternion" => roll, within bound, in "Other conventions";
    }?;
    let columns = ["sequence", "first", "second", "third", "locks at", "turned back"];
    report.add(Table::of("conventions", columns, Sequence::ALL, |sequence| {
        let [i, j, k] = sequence.axes().map(|axis| ["x", "y", "z"][axis]);
        let angles = attitude.angles(sequence);
        let again = Attitude::from_sequence(sequence, angles)?.angle_to(&attitude);
        let [a, b, c] = angles.map(|angle| format!("{angle:.9}"));
        let lock = if sequence.is_proper() { "0, pi" } else { "-pi/2, pi/2" };
        Ok([format!("{i} {j}' {k}''"), a, b, c, lock.into(), below(again, 1e-17)])
    })?)
}

/// One turn only, half a turn, turns that are small.
fn limits(_: &Parameters, report: &mut Report) -> Result<()> {
    let screw = |angles| Screw::of(angles, SpaceVector::new(1.0, 2.0, 3.0));
    let flat = screw([0.3, PI - 2e-4, -0.4])?.axis;
    let phi = |theta| -> Result<f64> {
        let attitude = Attitude::from_euler(EulerAngles { phi: 0.3, theta, zeta: 0.4 })?;
        Ok(attitude.euler_angles().phi)
    };
    limits! { report,
        /// only the second turn is left
        "phi = zeta = 0: whole angle over theta": screw([0.0, 0.7, 0.0])?.angle / 0.7 => 1.0, within 1e-15;
        /// two turns about one line add up
        "theta = 0: whole angle over phi + zeta": screw([0.3, 0.0, 0.4])?.angle / 0.7 => 1.0, within 1e-15;
        /// then the axis lies in the plane of X and Y
        "theta near pi: axis along Z": flat.z() => 0.0, within 1e-5;
        /// a half turn about the line halfway between X and x'
        "theta near pi: azimuth of the axis": atan2(flat.y(), flat.x()) => 0.35, within 1e-8;
        /// small turns add up like vectors: 3 and 4 give 5
        "turns of 3e-4 and 4e-4 about Z and x": screw([3e-4, 4e-4, 0.0])?.angle / 1e-4 => 5.0, within 1e-6;
        /// the order of small turns matters only to second order
        "book turned by x: apart over x^2": apart(1e-4) / 1e-8 => 1.0, within 1e-8;
        /// half turns about axes at right angles may change places
        "book turned by pi: apart": apart(PI) => 0.0, within 1e-15;
        /// at theta = 0 the library gives the sum to phi
        "library at theta = 0: phi": phi(0.0)? => 0.7, within 1e-15;
        /// and just off it the two are there again
        "library at theta = 1e-300: phi": phi(1e-300)? => 0.3, within 1e-15;
    }
}

example! {
    ch15_1_euler_angles: "Section 15.1: a rigid body displaced and turned, by three angles and back";
    "Euler angles", "A rigid body displaced and turned; the angles by which it is turned, and back.",
    [turns, displacement, conventions, pole::claims, limits, rigid::effects, pole::accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
