//! Angular velocity, notes, Chapter 15, Section 2: one vector for the whole body, its parts
//! along Z, x and z, and what a turning frame sees of it.

#[path = "ch15_2_angular_velocity/figures.rs"]
mod figures;
#[path = "ch15_2_angular_velocity/left_out.rs"]
mod left_out;
#[path = "ch15_2_angular_velocity/limits.rs"]
mod limits;
#[path = "ch15_2_angular_velocity/matrices.rs"]
pub mod matrices;
#[path = "ch15_2_angular_velocity/steps.rs"]
mod steps;

use core::f64::consts::{FRAC_PI_2, PI};
use kit::{Report, Result};
pub use left_out::{filmed, missed, swollen};
use matrices::{about_x, about_z, columns, in_space, length, on_own_axes, product};
use rotation_dynamics::attitude::{Attitude, EulerAngles, EulerRates};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::integrators::{Ode, ode, size_or};
use rotation_dynamics::math::{asin, atan2, cos, hypot, sin, sincos};
pub use steps::{by_angles, by_quaternion, clear_of_poles, passing};

kit::parameters! {
    /// A line, a point, a disc, a gyroscope and a frame, each with its rates.
    pub struct Parameters {
        /// angle of a line on the body from the x axis
        line_before: number(0.2, "rad", from_to(-1.5, 1.5).because("a line turned round looks the same: less than a right angle either way"));
        /// the same a little later
        line_after: number(0.65, "rad", from_to(-1.5, 1.5).because("a line turned round looks the same: less than a right angle either way"));
        /// time between the two
        interval: number(0.1, "s", from_to(1e-6, 1e6).usually(0.05, 1.0));
        /// angular velocity of a body, along X
        omega_x: number(0.4, "rad/s", from_to(-1e5, 1e5).usually(-3.0, 3.0));
        /// the same, along Y
        omega_y: number(-0.3, "rad/s", from_to(-1e5, 1e5).usually(-3.0, 3.0));
        /// the same, along Z
        omega_z: number(2.0, "rad/s", from_to(-1e5, 1e5).usually(-3.0, 3.0));
        /// a point of that body, from its fixed point
        point_x: number(0.1, "m", from_to(-1e3, 1e3).usually(-1.0, 1.0));
        /// the same, along Y
        point_y: number(0.2, "m", from_to(-1e3, 1e3).usually(-1.0, 1.0));
        /// the same, along Z
        point_z: number(0.3, "m", from_to(-1e3, 1e3).usually(-1.0, 1.0));
        /// angular velocity of the frame from which that body is watched, about Z
        frame: number(2.0, "rad/s", from_to(-1e5, 1e5).usually(-3.0, 3.0));
        /// angular velocity of the disc about its centre O
        disc: number(4.0, "rad/s", from_to(-1e5, 1e5).usually(-6.0, 6.0));
        /// angle of the line of nodes from X
        phi: number(0.3, "rad", from_to(-100.0, 100.0).because("whole turns may be left out of an angle").usually(-3.1, 3.1));
        /// tilt of the axis of the gyroscope
        theta: number(1.0, "rad", from_to(1e-6, PI - 1e-6).because("with the axis upright the rates of the Euler angles are not defined").usually(0.3, 2.8));
        /// angle of a mark on the rotor from the line of nodes
        zeta: number(-0.4, "rad", from_to(-100.0, 100.0).because("whole turns may be left out of an angle").usually(-3.1, 3.1));
        /// rate of phi
        precession: number(2.0, "rad/s", from_to(-1e5, 1e5).usually(-3.0, 3.0)).open("rate of the outer ring", "clockwise", "counterclockwise");
        /// rate of theta
        nutation: number(0.5, "rad/s", from_to(-1e5, 1e5).usually(-3.0, 3.0)).open("rate of the inner ring", "axle rises", "axle sinks");
        /// rate of zeta; the pictures show a tenth of it
        spin: number(30.0, "rad/s", from_to(-1e5, 1e5).usually(-40.0, 40.0)).open("rate of the rotor, drawn at a tenth", "clockwise", "counterclockwise");
        /// error of a step of the runs
        tolerance: number(1e-12, "-", from_to(1e-15, 1e-3));
    }
}

pub const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
/// The notes' disc, with its centre at O: the points A and O'.
pub const A: SpaceVector = SpaceVector::new(0.3, 0.1, 0.0);
pub const O_PRIME: SpaceVector = SpaceVector::new(0.1, -0.05, 0.0);
/// A tilt close to the pole, where the rates are asked for once more.
const NEAR: f64 = 0.01;

// ANCHOR: velocity
/// Velocity of the point at `r` from a fixed point of the body: equation (1).
pub fn velocity(omega: SpaceVector, r: SpaceVector) -> SpaceVector {
    omega.cross(&r)
}

/// The angular velocity of a body of which two points move with `v` and `w`
/// relative to a third, the second of them at `s` from it. It must not lie in
/// the plane of the three.
pub fn from_two_points(v: SpaceVector, w: SpaceVector, s: SpaceVector) -> SpaceVector {
    v.cross(&w) / v.dot(&s)
}
// ANCHOR_END: velocity

/// A rotor in gimbals: its angles and their rates.
#[derive(Clone, Copy)]
pub struct Gyroscope {
    pub angles: EulerAngles,
    pub rates: EulerRates,
}

// ANCHOR: gyroscope
impl Gyroscope {
    /// The line of nodes x, the third direction y and the axis z, in space.
    pub fn triad(&self) -> [SpaceVector; 3] {
        let ((sp, cp), (st, ct)) = (sincos(self.angles.phi), sincos(self.angles.theta));
        let x = SpaceVector::new(cp, sp, 0.0);
        let z = SpaceVector::new(st * sp, -st * cp, ct);
        [x, z.cross(&x), z]
    }

    /// Equation (5): three rates about three directions that are not at right angles.
    pub fn angular_velocity(&self) -> SpaceVector {
        let [x, _, z] = self.triad();
        UP * self.rates.phi + x * self.rates.theta + z * self.rates.zeta
    }

    /// Equation (6): its components on x, y, z, which are at right angles.
    pub fn nodal(&self) -> [f64; 3] {
        let (s, c) = sincos(self.angles.theta);
        let EulerRates { phi, theta, zeta } = self.rates;
        [theta, phi * s, zeta + phi * c]
    }

    /// Its components on the axes 1, 2, 3 fixed in the rotor.
    pub fn on_body(&self) -> [f64; 3] {
        let ([x, y, z], (s, c)) = (self.nodal(), sincos(self.angles.zeta));
        [x * c + y * s, y * c - x * s, z]
    }

    /// What turns x, y, z themselves: all but the spin.
    pub fn of_triad(&self) -> SpaceVector {
        let still = EulerRates { zeta: 0.0, ..self.rates };
        Self { rates: still, ..*self }.angular_velocity()
    }
}

/// Back from the nodal components to the rates of phi, theta, zeta; not at theta = 0.
pub fn rates([x, y, z]: [f64; 3], theta: f64) -> [f64; 3] {
    let (s, c) = sincos(theta);
    [y / s, x, z - y * c / s]
}
// ANCHOR_END: gyroscope

impl Gyroscope {
    /// With these angles and rates, of phi, theta and zeta.
    pub fn new([phi, theta, zeta]: [f64; 3], rates: [f64; 3]) -> Self {
        let angles = EulerAngles { phi, theta, zeta };
        let [phi, theta, zeta] = rates;
        let rates = EulerRates { phi, theta, zeta };
        Self { angles, rates }
    }

    /// As the parameters have it, with so many times the spin.
    pub fn of(p: &Parameters, spin: f64) -> Self {
        Self::new([p.phi, p.theta, p.zeta], [p.precession, p.nutation, p.spin * spin])
    }

    /// The same a little later, if the rates stay.
    pub fn after(&self, t: f64) -> Self {
        let (a, r) = (self.angles, self.rates);
        let angles = [a.phi + r.phi * t, a.theta + r.theta * t, a.zeta + r.zeta * t];
        Self::new(angles, [r.phi, r.theta, r.zeta])
    }

    /// The attitude matrix with its exact derivative; without the spin that of x, y, z.
    fn matrix(&self, with_spin: bool) -> matrices::Matrix {
        let (angles, rates) = (self.angles, self.rates);
        let triad = product(&about_z(angles.phi, rates.phi), &about_x(angles.theta, rates.theta));
        if !with_spin {
            return triad;
        }
        product(&triad, &about_z(angles.zeta, rates.zeta))
    }
}

// ANCHOR: steps
/// The Euler angles of a body with a constant angular velocity in space.
fn angles_of(omega: SpaceVector) -> impl Ode<3> {
    ode(move |_, [phi, theta, _]: &[f64; 3]| {
        let ((sp, cp), (st, ct)) = (sincos(*phi), sincos(*theta));
        let spin = (omega.x() * sp - omega.y() * cp) / st;
        [omega.z() - spin * ct, omega.x() * cp + omega.y() * sp, spin]
    })
    .scaled(size_or([1.0; 3]))
}

/// Its quaternion: q' = (0, Omega) q / 2.
fn quaternion_of(omega: SpaceVector) -> impl Ode<4> {
    ode(move |_, [w, x, y, z]: &[f64; 4]| {
        let (half, v) = (omega * 0.5, SpaceVector::new(*x, *y, *z));
        let [a, b, c] = (half * *w + half.cross(&v)).to_array();
        [-half.dot(&v), a, b, c]
    })
    .scaled(size_or([1.0; 4]))
}
// ANCHOR_END: steps

/// The angle between the results of two turns by `angle`, about X and about Z, in the two
/// orders (rad).
pub fn gap(angle: f64) -> f64 {
    4.0 * asin(sin(0.5 * angle) * sin(0.5 * angle))
}

/// The same, from the turned bodies.
pub fn measured_gap(angle: f64) -> Result<f64> {
    let x = SpaceVector::new(angle, 0.0, 0.0);
    let after = |first, then| Attitude::from_rotation_vector(first)?.turned_in_space(then);
    Ok(after(x, UP * angle)?.angle_to(&after(UP * angle, x)?))
}

/// The angular velocity of the body of the parameters, and its point.
pub fn body(p: &Parameters) -> [SpaceVector; 2] {
    let omega = SpaceVector::new(p.omega_x, p.omega_y, p.omega_z);
    [omega, SpaceVector::new(p.point_x, p.point_y, p.point_z)]
}

/// The derivative of `f` at 0, from its values within `h` to both sides.
pub fn derivative(
    h: f64,
    f: impl Fn(f64) -> rotation_dynamics::Result<SpaceVector>,
) -> rotation_dynamics::Result<SpaceVector> {
    let difference = |h| Ok::<_, rotation_dynamics::Error>(f(h)? - f(-h)?);
    Ok((difference(0.5 * h)? * 8.0 - difference(h)?) / (6.0 * h))
}

/// Where the point at `r` is after the time `t`.
pub fn turned(
    omega: SpaceVector,
    r: SpaceVector,
    t: f64,
) -> rotation_dynamics::Result<SpaceVector> {
    let turn = Attitude::from_rotation_vector(omega * t)?;
    Ok(turn.to_space(r.to_array().into()))
}

/// The angle by which the plane vector `from` must turn to point along `to`.
pub fn angle_between(from: SpaceVector, to: SpaceVector) -> f64 {
    atan2(from.cross(&to).z(), from.dot(&to))
}

/// The angular velocity, at t = 0, with which a body seen from a frame that turns about Z
/// changes its attitude, from the attitudes themselves.
pub fn seen_from(frame: f64, omega: SpaceVector) -> rotation_dynamics::Result<SpaceVector> {
    derivative(2e-3 / (omega.norm() + frame.abs()).max(1e-3), |t| {
        let body = Attitude::from_rotation_vector(omega * t)?;
        Ok(body.turned_in_space(UP * (-frame * t))?.rotation_vector())
    })
}

/// Every number of the page.
fn report(p: &Parameters) -> Result<Report> {
    let about = "One vector says how a rigid body turns: its parts, its frames, its poles.";
    let mut report = Report::new("Angular velocity", about)?;
    of_points(p, &mut report)?;
    of_gyroscope(p, &mut report)?;
    of_frames(p, &mut report)?;
    limits::add(p, &mut report)?;
    left_out::add(p, &mut report)?;
    steps::add(p, &mut report)?;
    Ok(report)
}

/// A line, a point, the disc.
fn of_points(p: &Parameters, report: &mut Report) -> Result<()> {
    let turn = p.line_after - p.line_before;
    // Another line on the same body, between two points neither of which is the axis.
    let other = |turn: f64| {
        Ok::<_, rotation_dynamics::Error>(turned(UP, A, turn)? - turned(UP, O_PRIME, turn)?)
    };
    let other = angle_between(other(p.line_before)?, other(p.line_after)?);
    let ([omega, r], disc) = (body(p), UP * p.disc);
    let [v, size] = [velocity(omega, r), SpaceVector::new(omega.norm() * r.norm(), 0.0, 0.0)];
    let step = 2e-3 / omega.norm().max(1e-3);
    let [x, y, z] = derivative(step, |t| turned(omega, r, t))?.to_array();
    // A as seen from O': where O' goes, and how fast the line from O' to A turns.
    let (moment, relative) = (1e-3 / p.disc.abs().max(1e-3), A - O_PRIME);
    let line =
        |t| Ok::<_, rotation_dynamics::Error>(turned(disc, A, t)? - turned(disc, O_PRIME, t)?);
    let about = angle_between(line(-moment)?, line(moment)?) / (2.0 * moment);
    let centre = derivative(2.0 * moment, |t| turned(disc, O_PRIME, t))?;
    let [by_parts, whole] = [centre + velocity(UP * about, relative), velocity(disc, A)];
    let near = (1e-11 * size.x()).max(1e-14);
    let nearly = (1e-11 * p.disc.abs()).max(1e-14);
    kit::claims! { report,
        /// angular velocity of the line
        line_rate: turn / p.interval, "rad/s", "another line of the body" => other / p.interval,
        within 1e-14 * (1.0 + turn.abs()) / p.interval, in "A line and a point":
            p.line_after / p.interval => "the line did not start on the x axis",
            turn => "that is the angle, not its rate";
        /// velocity of the point, along X
        v_x: v.x(), "m/s", "places before and after" => x, within near,
        in "A line and a point": -v.x() => "r x Omega points the other way";
        /// velocity of the point, along Y
        v_y: v.y(), "m/s", "places before and after" => y, within near,
        in "A line and a point": -v.y() => "r x Omega points the other way";
        /// velocity of the point, along Z
        v_z: v.z(), "m/s", "places before and after" => z, within near,
        in "A line and a point": -v.z() => "r x Omega points the other way";
        /// velocity of A, along X
        disc_x: whole.x(), "m/s", "by way of O'" => by_parts.x(), within nearly, in "The disc":
            velocity(disc, relative).x() => "that is relative to O', which moves too";
        /// velocity of A, along Y
        disc_y: whole.y(), "m/s", "by way of O'" => by_parts.y(), within nearly, in "The disc":
            velocity(disc, relative).y() => "that is relative to O', which moves too";
        /// angular velocity about O'
        about_o_prime: p.disc, "rad/s", "the line from O' to A" => about, within nearly;
    }
}

/// The rotor in gimbals: equations (4) to (6), and back.
fn of_gyroscope(p: &Parameters, report: &mut Report) -> Result<()> {
    let g = Gyroscope::of(p, 1.0);
    let (omega, [x, y, z], [one, two, three]) = (g.angular_velocity(), g.nodal(), g.on_body());
    let (matrix, triad) = (g.matrix(true), columns(&g.matrix(false)));
    let (by_matrix, on_rotor) = (in_space(&matrix), on_own_axes(&matrix));
    let [along_x, along_y, along_z] = triad.map(|axis| axis.dot(&by_matrix));
    let sum = p.precession.abs() + p.nutation.abs() + p.spin.abs();
    let near = (1e-14 * sum).max(1e-15);
    let [quick, _, back] = rates([x, y, z], NEAR);
    let there = by_volumes([x, y, z], NEAR);
    kit::claims! { report,
        /// component on the line of nodes x
        omega_x: x, "rad/s", "derivative of the matrix" => along_x, within near,
        in "The gyroscope, on x, y, z";
        /// component on y
        omega_y: y, "rad/s", "derivative of the matrix" => along_y, within near,
        in "The gyroscope, on x, y, z":
            p.precession => "only a part of the precession is along y",
            y / sin(p.theta) * sincos(p.theta).1 => "sine and cosine are exchanged";
        /// component on the axis z
        omega_z: z, "rad/s", "derivative of the matrix" => along_z, within near,
        in "The gyroscope, on x, y, z":
            p.spin => "the precession has a part along z, too",
            p.spin + y => "sine and cosine are exchanged";
        /// size of the angular velocity
        size: omega.norm(), "rad/s", "derivative of the matrix" => length(&matrix), within near,
        in "The gyroscope, on x, y, z":
            hypot(hypot(p.precession, p.nutation), p.spin) => "Z and z are not at right angles";
        /// component on X
        space_x: omega.x(), "rad/s", "derivative of the matrix" => by_matrix.x(), within near,
        in "The gyroscope, in space";
        /// component on Y
        space_y: omega.y(), "rad/s", "derivative of the matrix" => by_matrix.y(), within near,
        in "The gyroscope, in space";
        /// component on Z
        space_z: omega.z(), "rad/s", "derivative of the matrix" => by_matrix.z(), within near,
        in "The gyroscope, in space":
            z => "that is along z, the axis of the rotor";
        /// component on axis 1 of the rotor
        body_1: one, "rad/s", "derivative of the matrix" => on_rotor[0], within near;
        /// component on axis 2 of the rotor
        body_2: two, "rad/s", "derivative of the matrix" => on_rotor[1], within near;
        /// component on axis 3 of the rotor
        body_3: three, "rad/s", "derivative of the matrix" => on_rotor[2], within near;
        /// rate of phi that the same components take at a tilt of 0.01 rad
        near_precession: quick, "rad/s", "ratios of volumes" => there[0], within 100.0 * near;
        /// rate of zeta there
        near_spin: back, "rad/s", "ratios of volumes" => there[2], within 100.0 * near;
    }
}

/// The rates as ratios of volumes: that of Omega and two of Z, x, z over that of the three.
fn by_volumes([a, b, c]: [f64; 3], theta: f64) -> [f64; 3] {
    let [x, y, z] = Gyroscope::new([0.0, theta, 0.0], [0.0; 3]).triad();
    let (omega, volume) = (x * a + y * b + z * c, UP.dot(&x.cross(&z)));
    let ratios = [omega.dot(&x.cross(&z)), UP.dot(&omega.cross(&z)), UP.dot(&x.cross(&omega))];
    ratios.map(|part| part / volume)
}

/// Frames that turn, and finite turns.
fn of_frames(p: &Parameters, report: &mut Report) -> Result<()> {
    let (g, [omega, _]) = (Gyroscope::of(p, 1.0), body(p));
    let (triad, exact) = (g.of_triad(), in_space(&g.matrix(false)));
    let near = (1e-14 * (p.precession.abs() + p.nutation.abs())).max(1e-15);
    let (relative, seen) = (omega - UP * p.frame, seen_from(p.frame, omega)?);
    let fine = (1e-11 * (omega.norm() + p.frame.abs())).max(1e-14);
    let small = 0.01;
    kit::claims! { report,
        /// what turns x, y, z: size
        triad_size: triad.norm(), "rad/s", "derivative of the matrix" => exact.norm(),
        within near, in "Frames":
            p.precession => "that is only the turning about Z",
            g.angular_velocity().norm() => "the triad does not spin";
        /// what turns x, y, z, along the line of nodes
        triad_x: p.nutation, "rad/s", "derivative of the matrix" => exact.dot(&g.triad()[0]),
        within near;
        /// angular velocity seen from the turning frame, along its X
        seen_x: relative.x(), "rad/s", "attitudes seen from the frame" => seen.x(), within fine;
        /// the same, along its Y
        seen_y: relative.y(), "rad/s", "attitudes seen from the frame" => seen.y(), within fine;
        /// the same, along its Z
        seen_z: relative.z(), "rad/s", "attitudes seen from the frame" => seen.z(), within fine,
        in "Frames":
            omega.z() => "that is what the laboratory sees",
            omega.z() + p.frame => "the frame turns with the body, not against it";
        /// angle between the two orders of a quarter turn about X and one about Z
        quarter_gap: gap(FRAC_PI_2), "rad", "turned bodies" => measured_gap(FRAC_PI_2)?,
        within 1e-14, in "Finite turns":
            FRAC_PI_2 => "look where the axes of the box point";
        /// the same for turns of 0.01 rad
        small_gap: gap(small), "rad", "turned bodies" => measured_gap(small)?, within 1e-15;
        /// angle of a quarter turn about X and one about Z together
        quarter_whole: 2.0 * PI / 3.0, "rad", "turned bodies" => both_quarters()?, within 1e-14;
        /// length of the sum of their vectors
        quarter_sum: PI / 2.0_f64.sqrt(), "rad", "turned body" => sum_of_quarters()?,
        within 1e-14;
    }
}

/// The angle of a quarter turn about X followed by one about Z.
fn both_quarters() -> Result<f64> {
    let x = Attitude::from_rotation_vector(SpaceVector::new(FRAC_PI_2, 0.0, 0.0))?;
    Ok(x.turned_in_space(UP * FRAC_PI_2)?.rotation_vector().norm())
}

/// The angle of the one turn whose vector is the sum of the two.
fn sum_of_quarters() -> Result<f64> {
    let sum = SpaceVector::new(FRAC_PI_2, 0.0, FRAC_PI_2);
    Ok(Attitude::from_rotation_vector(sum)?.angle_to(&Attitude::IDENTITY))
}

kit::example! {
    ch15_2_angular_velocity: "Angular velocity: one vector for the whole body, its parts and its frames";
    report, figures::figures, figures::trajectory, figures::moving_picture
}
