//! Angular velocity, notes, Chapter 15, Section 2: one vector for the whole body, its parts
//! along Z, x and z, and what a turning frame sees of it.

#[path = "ch15_2_angular_velocity/figures.rs"]
mod figures;
#[path = "ch15_2_angular_velocity/left_out.rs"]
mod left_out;
#[path = "ch15_2_angular_velocity/matrices.rs"]
mod matrices;
#[path = "ch15_2_angular_velocity/steps.rs"]
mod steps;

use core::f64::consts::{FRAC_PI_2, PI};
use kit::prelude::*;
use kit::short;
pub use left_out::{filmed, missed, swollen};
use matrices::Turning;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::integrators::{Ode, ode, size_or};
pub use steps::{by_angles, by_quaternion, clear_of_poles, passing};

parameters! {
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

pub const X: SpaceVector = SpaceVector::new(1.0, 0.0, 0.0);
pub const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
/// The notes' disc, with its centre at O: the points A and O'.
pub const A: SpaceVector = SpaceVector::new(0.3, 0.1, 0.0);
pub const O_PRIME: SpaceVector = SpaceVector::new(0.1, -0.05, 0.0);

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

// ANCHOR: gyroscope
/// A rotor in gimbals: its angles phi, theta, zeta and their rates.
#[derive(Clone, Copy)]
pub struct Gyroscope {
    pub angles: [f64; 3],
    pub rates: [f64; 3],
}

impl Gyroscope {
    /// The line of nodes x, the third direction y and the axis z, in space.
    pub fn triad(&self) -> [SpaceVector; 3] {
        let [(sp, cp), (st, ct), _] = self.angles.map(sincos);
        let x = SpaceVector::new(cp, sp, 0.0);
        let z = SpaceVector::new(st * sp, -st * cp, ct);
        [x, z.cross(&x), z]
    }

    /// Equation (5): three rates about three directions that are not at right angles.
    pub fn angular_velocity(&self) -> SpaceVector {
        let ([x, _, z], [phi, theta, zeta]) = (self.triad(), self.rates);
        UP * phi + x * theta + z * zeta
    }

    /// Equation (6): its components on x, y, z, which are at right angles.
    pub fn nodal(&self) -> [f64; 3] {
        let ([_, tilt, _], [phi, theta, zeta]) = (self.angles, self.rates);
        let (s, c) = sincos(tilt);
        [theta, phi * s, zeta + phi * c]
    }

    /// Its components on the axes 1, 2, 3 fixed in the rotor.
    pub fn on_body(&self) -> [f64; 3] {
        let ([x, y, z], [.., zeta]) = (self.nodal(), self.angles);
        let (s, c) = sincos(zeta);
        [x * c + y * s, y * c - x * s, z]
    }

    /// What turns x, y, z themselves: all but the spin.
    pub fn of_triad(&self) -> SpaceVector {
        let [phi, theta, _] = self.rates;
        Self { rates: [phi, theta, 0.0], ..*self }.angular_velocity()
    }
}

/// Back from the nodal components to the rates of phi, theta, zeta; not at theta = 0.
pub fn rates([x, y, z]: [f64; 3], theta: f64) -> [f64; 3] {
    let (s, c) = sincos(theta);
    [y / s, x, z - y * c / s]
}
// ANCHOR_END: gyroscope

impl Gyroscope {
    /// As the parameters have it, with so many times the spin.
    pub fn of(p: &Parameters, spin: f64) -> Self {
        let angles = [p.phi, p.theta, p.zeta];
        Self { angles, rates: [p.precession, p.nutation, p.spin * spin] }
    }

    /// The same a little later, if the rates stay.
    pub fn after(&self, t: f64) -> Self {
        let angles = [0, 1, 2].map(|i| self.angles[i] + self.rates[i] * t);
        Self { angles, ..*self }
    }

    /// The attitude of the rotor.
    pub fn attitude(&self) -> Result<Attitude> {
        let [phi, theta, zeta] = self.angles;
        Ok(Attitude::from_euler(EulerAngles { phi, theta, zeta })?)
    }

    /// The largest angular velocity that these rates can add up to.
    fn fastest(&self) -> f64 {
        self.rates.map(f64::abs).iter().sum()
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

/// A body turned by `angle` about the first of these axes, then about the second.
fn twice(angle: f64, [first, second]: [SpaceVector; 2]) -> Result<Attitude> {
    Ok(Attitude::from_rotation_vector(first * angle)?.turned_in_space(second * angle)?)
}

/// That angle, from the turned bodies.
pub fn measured_gap(angle: f64) -> Result<f64> {
    Ok(twice(angle, [X, UP])?.angle_to(&twice(angle, [UP, X])?))
}

/// The angular velocity of the body of the parameters, and its point.
fn body(p: &Parameters) -> [SpaceVector; 2] {
    let omega = SpaceVector::new(p.omega_x, p.omega_y, p.omega_z);
    [omega, SpaceVector::new(p.point_x, p.point_y, p.point_z)]
}

/// The derivative of `f` at 0, from its values within `h` to both sides.
pub fn derivative(h: f64, f: impl Fn(f64) -> Result<SpaceVector>) -> Result<SpaceVector> {
    let difference = |h: f64| -> Result<_> { Ok(f(h)? - f(-h)?) };
    Ok((difference(0.5 * h)? * 8.0 - difference(h)?) / (6.0 * h))
}

/// Where the point at `r` is after the time `t`.
pub fn turned(omega: SpaceVector, r: SpaceVector, t: f64) -> Result<SpaceVector> {
    let turn = Attitude::from_rotation_vector(omega * t)?;
    Ok(turn.to_space(r.to_array().into()))
}

/// The angle by which the plane vector `from` must turn to point along `to`.
pub fn angle_between(from: SpaceVector, to: SpaceVector) -> f64 {
    atan2(from.cross(&to).z(), from.dot(&to))
}

/// The angular velocity, at t = 0, with which a body seen from a frame that turns about Z
/// changes its attitude, from the attitudes themselves.
pub fn seen_from(frame: f64, omega: SpaceVector) -> Result<SpaceVector> {
    derivative(2e-3 / (omega.norm() + frame.abs()).max(1e-3), |t| {
        let body = Attitude::from_rotation_vector(omega * t)?;
        Ok(body.turned_in_space(UP * (-frame * t))?.rotation_vector())
    })
}

/// A line, a point, the disc.
fn points(p: &Parameters, report: &mut Report) -> Result<()> {
    let (turn, [omega, r], disc) = (p.line_after - p.line_before, body(p), UP * p.disc);
    // From O' to A; neither of them is the axis.
    let line = |omega, t| -> Result<_> { Ok(turned(omega, A, t)? - turned(omega, O_PRIME, t)?) };
    let other = angle_between(line(UP, p.line_before)?, line(UP, p.line_after)?);
    let (v, step) = (velocity(omega, r), 2e-3 / omega.norm().max(1e-3));
    let [x, y, z] = derivative(step, |t| turned(omega, r, t))?.to_array();
    // A as seen from O': where O' goes, and how fast the line from O' to A turns.
    let (moment, relative) = (1e-3 / p.disc.abs().max(1e-3), A - O_PRIME);
    let about = angle_between(line(disc, -moment)?, line(disc, moment)?) / (2.0 * moment);
    let centre = derivative(2.0 * moment, |t| turned(disc, O_PRIME, t))?;
    let [by_parts, whole] = [centre + velocity(UP * about, relative), velocity(disc, A)];
    let near = (1e-11 * (omega.norm() * r.norm())).max(1e-14);
    let nearly = (1e-11 * p.disc.abs()).max(1e-14);
    claims! { report,
        /// angular velocity of the line
        line_rate: turn / p.interval, "rad/s", "another line of the body" => other / p.interval,
        within 1e-14 * (1.0 + turn.abs()) / p.interval, in "A line and a point":
            p.line_after / p.interval => "the line did not start on the x axis",
            turn => "that is the angle, not its rate";
        /// velocity of the point, along X
        v_x: v.x(), "m/s", "places before and after" => x, within near, in "A line and a point": -v.x() => "r x Omega points the other way";
        /// velocity of the point, along Y
        v_y: v.y(), "m/s", "places before and after" => y, within near, in "A line and a point": -v.y() => "r x Omega points the other way";
        /// velocity of the point, along Z
        v_z: v.z(), "m/s", "places before and after" => z, within near, in "A line and a point": -v.z() => "r x Omega points the other way";
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
fn gyroscope(p: &Parameters, report: &mut Report) -> Result<()> {
    let g = Gyroscope::of(p, 1.0);
    let (omega, [x, y, z], [one, two, three]) = (g.angular_velocity(), g.nodal(), g.on_body());
    let (triad, rotor) = matrices_of(&g);
    let (by_matrix, on_rotor) = (rotor.in_space(), rotor.on_own_axes());
    let along = |axis: usize| SpaceVector::from(triad.at.column(axis).into_owned()).dot(&by_matrix);
    let near = (1e-14 * g.fastest()).max(1e-15);
    // The rates at a tilt of 0.01 rad, and as ratios of volumes: that of Omega and two of Z, x, z
    // over that of the three.
    let [quick, _, back] = rates([x, y, z], 0.01);
    let [e, f, k] = g.but(|g| g.angles = [0.0, 0.01, 0.0]).triad();
    let (there, volume) = (e * x + f * y + k * z, UP.dot(&e.cross(&k)));
    claims! { report,
        /// component on the line of nodes x
        omega_x: x, "rad/s", "derivative of the matrix" => along(0), within near, in "The gyroscope, on x, y, z";
        /// component on y
        omega_y: y, "rad/s", "derivative of the matrix" => along(1), within near, in "The gyroscope, on x, y, z":
            p.precession => "only a part of the precession is along y",
            y / sin(p.theta) * cos(p.theta) => "sine and cosine are exchanged";
        /// component on the axis z
        omega_z: z, "rad/s", "derivative of the matrix" => along(2), within near, in "The gyroscope, on x, y, z":
            p.spin => "the precession has a part along z, too",
            p.spin + y => "sine and cosine are exchanged";
        /// size of the angular velocity
        size: omega.norm(), "rad/s", "derivative of the matrix" => rotor.size(), within near, in "The gyroscope, on x, y, z":
            hypot(hypot(p.precession, p.nutation), p.spin) => "Z and z are not at right angles";
        /// component on X
        space_x: omega.x(), "rad/s", "derivative of the matrix" => by_matrix.x(), within near, in "The gyroscope, in space";
        /// component on Y
        space_y: omega.y(), "rad/s", "derivative of the matrix" => by_matrix.y(), within near, in "The gyroscope, in space";
        /// component on Z
        space_z: omega.z(), "rad/s", "derivative of the matrix" => by_matrix.z(), within near, in "The gyroscope, in space":
            z => "that is along z, the axis of the rotor";
        /// component on axis 1 of the rotor
        body_1: one, "rad/s", "derivative of the matrix" => on_rotor[0], within near;
        /// component on axis 2 of the rotor
        body_2: two, "rad/s", "derivative of the matrix" => on_rotor[1], within near;
        /// component on axis 3 of the rotor
        body_3: three, "rad/s", "derivative of the matrix" => on_rotor[2], within near;
        /// rate of phi that the same components take at a tilt of 0.01 rad
        near_precession: quick, "rad/s", "ratios of volumes" => there.dot(&e.cross(&k)) / volume, within 100.0 * near;
        /// rate of zeta there
        near_spin: back, "rad/s", "ratios of volumes" => UP.dot(&e.cross(&there)) / volume, within 100.0 * near;
    }
}

/// What turns x, y, z, and what turns the rotor: matrices with their exact derivatives.
fn matrices_of(g: &Gyroscope) -> (Turning, Turning) {
    let about = |axis, i: usize| Turning::about(axis, g.angles[i], g.rates[i]);
    let triad = about(2, 0).times(&about(0, 1));
    let rotor = triad.times(&about(2, 2));
    (triad, rotor)
}

/// Frames that turn, and finite turns.
fn frames(p: &Parameters, report: &mut Report) -> Result<()> {
    let (g, [omega, _], small) = (Gyroscope::of(p, 1.0), body(p), 0.01);
    let (triad, exact) = (g.of_triad(), matrices_of(&g).0.in_space());
    let near = (1e-14 * (p.precession.abs() + p.nutation.abs())).max(1e-15);
    let (relative, seen) = (omega - UP * p.frame, seen_from(p.frame, omega)?);
    let fine = (1e-11 * (omega.norm() + p.frame.abs())).max(1e-14);
    let both = twice(FRAC_PI_2, [X, UP])?.rotation_vector();
    let sum = Attitude::from_rotation_vector((X + UP) * FRAC_PI_2)?;
    claims! { report,
        /// what turns x, y, z: size
        triad_size: triad.norm(), "rad/s", "derivative of the matrix" => exact.norm(), within near, in "Frames":
            p.precession => "that is only the turning about Z",
            g.angular_velocity().norm() => "the triad does not spin";
        /// what turns x, y, z, along the line of nodes
        triad_x: p.nutation, "rad/s", "derivative of the matrix" => exact.dot(&g.triad()[0]), within near;
        /// angular velocity seen from the turning frame, along its X
        seen_x: relative.x(), "rad/s", "attitudes seen from the frame" => seen.x(), within fine;
        /// the same, along its Y
        seen_y: relative.y(), "rad/s", "attitudes seen from the frame" => seen.y(), within fine;
        /// the same, along its Z
        seen_z: relative.z(), "rad/s", "attitudes seen from the frame" => seen.z(), within fine, in "Frames":
            omega.z() => "that is what the laboratory sees",
            omega.z() + p.frame => "the frame turns with the body, not against it";
        /// angle between the two orders of a quarter turn about X and one about Z
        quarter_gap: gap(FRAC_PI_2), "rad", "turned bodies" => measured_gap(FRAC_PI_2)?, within 1e-14, in "Finite turns":
            FRAC_PI_2 => "look where the axes of the box point";
        /// the same for turns of 0.01 rad
        small_gap: gap(small), "rad", "turned bodies" => measured_gap(small)?, within 1e-15;
        /// angle of a quarter turn about X and one about Z together
        quarter_whole: 2.0 * PI / 3.0, "rad", "turned bodies" => both.norm(), within 1e-14;
        /// length of the sum of their vectors
        quarter_sum: PI / 2.0_f64.sqrt(), "rad", "turned body" => sum.angle_to(&Attitude::IDENTITY), within 1e-14;
    }
}

/// Upright and level, seen from a frame that turns along, and turns that are small.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let g = Gyroscope::of(p, 1.0);
    let at = |theta| g.but(|g| g.angles[1] = theta).nodal();
    let omega = SpaceVector::new(0.4, -0.3, 2.0);
    let [r, s] = [SpaceVector::new(0.1, 0.2, 0.3), SpaceVector::new(0.7, -0.2, 0.5)];
    let found = from_two_points(velocity(omega, r), velocity(omega, s), s);
    let near = 1e-14 * g.fastest();
    // What a solver of the angles meets at a small tilt, the components being the same.
    let [quick, ..] = rates(g.nodal(), 1e-9);
    limits! { report,
        /// z lies along Z: precession and spin are one rotation
        "upright, theta = 0: Omega_z": at(1e-9)[2] => p.precession + p.spin, within near;
        /// Z lies along y
        "level, theta = pi/2: Omega_y": at(FRAC_PI_2)[1] => p.precession, within near;
        /// the rate of phi grows as 1/theta, the component stays
        "theta = 1e-9: theta times the rate of phi": 1e-9 * quick => g.nodal()[1], within near;
        /// the plate turns with the frame and seems at rest
        "frame as fast as the body: Omega seen": seen_from(1.0, UP)?.norm() => 0.0, within 1e-14;
        /// the second order is what the two orders differ by
        "turns of x = 1e-6: gap / x^2": gap(1e-6) * 1e12 => 1.0, within 1e-12;
        /// Omega is what moves them
        "from two points: Omega off by": (found - omega).norm() => 0.0, within 1e-14;
    }
}

/// What the page asks its reader to try, one flag changed at a time.
fn variations(p: &Parameters, report: &mut Report) -> Result<()> {
    let with = |change: fn(&mut Parameters)| Gyroscope::of(&p.but(change), 1.0);
    let rows = [
        ("--spin -30", "size", with(|p| p.spin = -30.0).angular_velocity().norm()),
        ("--theta 1.5707963", "omega_z", with(|p| p.theta = FRAC_PI_2).nodal()[2]),
        ("--theta 1e-6", "omega_z", with(|p| p.theta = 1e-6).nodal()[2]),
        ("--frame -2", "seen_z", seen_from(-2.0, body(p)[0])?.z()),
    ];
    report.add(Table::of(
        "variations",
        ["flag", "key", "value", "unit"],
        rows,
        |(flag, key, value)| Ok([flag.to_owned(), key.into(), short(value, 6), "rad/s".into()]),
    )?)
}

example! {
    ch15_2_angular_velocity: "Angular velocity: one vector for the whole body, its parts and its frames";
    "Angular velocity", "One vector says how a rigid body turns: its parts, its frames, its poles.",
    [points, gyroscope, frames, limits, variations, left_out::effects, steps::poles, steps::accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
