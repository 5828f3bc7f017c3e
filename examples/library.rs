//! The library without the book: a satellite for a day, a top at one time, and an effect of
//! one's own.

#[path = "library/figures.rs"]
mod figures;

use core::f64::consts::{PI, TAU};
use kit::prelude::*;
use kit::{short, supported_digits};
use rotation_dynamics::accuracy::{Crossing, Limits, Problem};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    CoulombBearing, Effect, GravityAtLever, GravityGradient, KeplerOrbit, OrbitingBody, Torque,
};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::fit::{Correction, Estimate, Fit, Flight};
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::scene::components;
use rotation_dynamics::integrators::{self, Dop853, after, ode, size_or};
use rotation_dynamics::motion::Motion;
use rotation_dynamics::nalgebra::Matrix3;
use rotation_dynamics::scene::Scene;

parameters! {
    /// A satellite, and a top with a motor.
    pub struct Parameters {
        /// angle of the satellite's long axis from the vertical at the start
        askew: number(0.1, "rad", between(-0.5 * PI, 0.5 * PI).because("at a right angle it lies across, and does not swing back").usually(0.01, 1.4)).open("angle from the vertical at the start", "swings little", "swings widely");
        /// mean motion of its orbit
        mean_motion: number(1.1e-3, "rad/s", from_to(2e-4, 2e-3).because("slower is farther than a day's orbit, faster is below the ground; the other way round it is the mirror image").usually(2e-4, 2e-3)).open("mean motion of the orbit", "far out", "low");
        /// torque of the top's motor
        torque: number(0.18, "N m", from_to(-0.5, 0.5).because("a stronger motor turns a top faster than its bearing stands").usually(0.0, 0.5));
        /// error asked of the attitude, all the way: from 1e-11 to 1e-3
        tolerance: number(1e-8, "rad", from_to(1e-11, 1e-3));
    }
}

/// The time that the satellite is followed, s.
pub const DAY: f64 = 86_400.0;

// ANCHOR: satellite
/// A satellite whose long axis, e1, hangs askew in the plane of its orbit.
pub fn satellite(p: &Parameters) -> Result<(Scene<((), GravityGradient)>, State)> {
    allowed! { "size of askew": p.askew.abs(), above(0.0), "hung straight it does not swing"; }?;
    let normal = SpaceVector::new(0.0, 0.0, 1.0);
    let down = SpaceVector::new(-1.0, 0.0, 0.0);
    let gradient = GravityGradient::on_orbit(p.mean_motion, normal, down)?;
    let body = RigidBody::new(PrincipalMoments::new(20.0, 90.0, 100.0)?);
    let askew = Attitude::about_space_axis(normal, p.askew)?;
    let start = body.state(askew, BodyVector::new(0.0, 0.0, p.mean_motion))?;
    Ok((Scene::new(body).with(gradient), start))
}

/// Its states at the hours of a day, none off by more than the error asked for.
pub fn day(p: &Parameters) -> Result<Vec<State>> {
    let (scene, start) = satellite(p)?;
    let hours: Vec<f64> = (1..=24).map(|hour| 3600.0 * f64::from(hour)).collect();
    Ok(scene.solve_at(&start, &hours, p.tolerance, &Limits::default())?)
}
// ANCHOR_END: satellite

// ANCHOR: upright
/// When it hangs straight until `t_end`, each time with an estimate of its error.
pub fn upright(p: &Parameters, t_end: f64) -> Result<Vec<Crossing>> {
    let (scene, start) = satellite(p)?;
    let motion = scene.solve_along(&start, t_end, p.tolerance, &Limits::default())?;
    Ok(motion.crossings("swing", |t, state| swing(p, t, state))?)
}
// ANCHOR_END: upright

// ANCHOR: magnet
/// A magnet along e1 of 0.1 A m^2, in a field of 3e-5 T, N m.
pub const MAGNET: f64 = 0.1 * 3e-5;

/// Such a magnet where the field is along the normal, on an equatorial orbit.
pub fn magnet(strength: f64) -> impl Effect + Clone {
    let torque = move |_t, _body: &RigidBody, state: &State| {
        let magnet = state.attitude.to_space(BodyVector::new(strength, 0.0, 0.0));
        magnet.cross(&SpaceVector::new(0.0, 0.0, 1.0))
    };
    Torque::on_space("magnet", torque).smooth()
}
// ANCHOR_END: magnet

// ANCHOR: top
/// A heavy top in closed form, released at rest but for its spin.
pub fn top() -> rotation_dynamics::Result<HeavyTop> {
    let top = SymmetricTop::new(5.45e-3, 9.0e-4, 4.9, 0.1)?;
    HeavyTop::new(top, tilted()?, BodyVector::new(0.0, 0.0, 314.0))
}

/// Where it is after a minute.
pub fn after_a_minute() -> rotation_dynamics::Result<EulerAngles> {
    top()?.try_angles(60.0)
}
// ANCHOR_END: top

// ANCHOR: measured
/// The axes of a phone as an app wrote them down: three decimals, in single precision.
pub const MEASURED: [[f32; 3]; 3] =
    [[0.72, -0.586, 0.368], [0.605, 0.795, 0.085], [-0.337, 0.161, 0.926]];

/// The attitude nearest to that, and how far the matrix was from it.
pub fn put_right() -> rotation_dynamics::Result<(Attitude, f64)> {
    Attitude::nearest(MEASURED.map(|row| row.map(f64::from)))
}

/// A third of the way there from flat on the table, on the shortest arc.
pub fn on_the_way() -> rotation_dynamics::Result<Attitude> {
    let (there, _) = put_right()?;
    Attitude::IDENTITY.toward(&there, 1.0 / 3.0)
}
// ANCHOR_END: measured

/// The same by steps.
fn stepped_for_a_minute() -> Result<EulerAngles> {
    let (body, gravity) = (rotor()?, GravityAtLever::new(4.9, 0.1)?);
    let start = body.state(tilted()?, BodyVector::new(0.0, 0.0, 314.0))?;
    let end = Scene::new(body).with(gravity).solve_by_stepping(&start, 60.0, 1e-10)?;
    Ok(end.state.attitude.euler_angles())
}

/// The top as a rigid body.
fn rotor() -> Result<RigidBody> {
    Ok(RigidBody::new(PrincipalMoments::symmetric(5.45e-3, 9.0e-4)?))
}

/// A tilt of 1 rad.
fn tilted() -> rotation_dynamics::Result<Attitude> {
    Attitude::from_euler(EulerAngles { phi: 0.0, theta: 1.0, zeta: 0.0 })
}

// ANCHOR: motor
/// The top under its weight and an effect of one's own: a motor on its axle.
pub fn driven(torque: f64) -> Result<(Scene<impl Effect + Clone>, State)> {
    let along = BodyVector::new(0.0, 0.0, torque);
    let motor = Torque::on_body("motor", move |_t, _body, _state| along).smooth();
    let (body, gravity) = (rotor()?, GravityAtLever::new(4.9, 0.1)?);
    let start = body.state(tilted()?, BodyVector::new(0.0, 0.0, 100.0))?;
    Ok((Scene::new(body).with(gravity).with(motor), start))
}

/// Its state after a second, off by no more than the error asked for.
pub fn after_a_second(p: &Parameters) -> Result<State> {
    let (scene, start) = driven(p.torque)?;
    Ok(scene.solve(&start, 1.0, p.tolerance)?.state)
}
// ANCHOR_END: motor

// ANCHOR: thrown
/// The free body that fits what a gyroscope recorded in flight: lines `t,x,y,z` in s and rad/s.
pub fn thrown(table: &str) -> rotation_dynamics::Result<Fit> {
    let (mut times, mut rates) = (Vec::new(), Vec::new());
    for line in table.lines() {
        // What is no number is refused as one that is not finite.
        let cell = |cell: &str| cell.trim().parse().unwrap_or(f64::NAN);
        let cells: Vec<f64> = line.split(',').map(cell).collect();
        if let [t, x, y, z] = cells[..] {
            times.push(t);
            rates.push(DesignVector::new(x, y, z));
        }
    }
    Flight::new(times, rates)?.fit(&Correction::ALL)
}

/// The ratios of the moments with their intervals, and what else the data call for.
pub fn told(fit: &Fit) -> Vec<String> {
    let ratio = |(name, i)| match fit.ratio(i, 2) {
        Some(Estimate { value, from, to }) => {
            format!("{name} = {value:.4}, {from:.4} to {to:.4}")
        }
        None => format!("{name} is not determined"),
    };
    let needed = fit.decisions().iter().filter(|decision| decision.needed);
    let needed = needed.map(|decision| format!("{:?}", decision.correction));
    [("I1/I3", 0), ("I2/I3", 1)].map(ratio).into_iter().chain(needed).collect()
}
// ANCHOR_END: thrown

/// The moments of a phone, and a recording of its flight, in hundredths of rad/s.
const PHONE: [f64; 3] = [1.0, 4.0, 4.8];

fn recorded() -> Result<String> {
    let [i1, i2, i3] = PHONE;
    let start = BodyVector::new(0.4, 9.0, 0.5);
    let body = FreeBody::new(PrincipalMoments::new(i1, i2, i3)?, Attitude::IDENTITY, start)?;
    let line = |t: f64| {
        let [x, y, z] = body.angular_velocity(t).to_array();
        format!("{t:.3},{x:.2},{y:.2},{z:.2}\n")
    };
    Ok(times(0.0, 0.8, 160).map(line).collect())
}

/// The angle from the vertical to the satellite's long axis at the time `t`, rad.
pub fn swing(p: &Parameters, t: f64, state: &State) -> f64 {
    let [x, y, _] = state.attitude.to_space(BodyVector::new(1.0, 0.0, 0.0)).to_array();
    let (s, c) = sincos(p.mean_motion * t);
    atan2(c * y - s * x, c * x + s * y)
}

/// Twice that angle, in closed form: a pendulum with W^2 = 3 n0^2 (I2 - I1)/I3.
pub fn pendulum(p: &Parameters) -> rotation_dynamics::Result<Pendulum> {
    let gravity = 3.0 * p.mean_motion * p.mean_motion * (90.0 - 20.0);
    let pendulum = Suspension { moment: 100.0, mass: 1.0, gravity, lever: 1.0 };
    Pendulum::new(pendulum, 2.0 * p.askew, 0.0)
}

/// The satellite's exact state.
fn exact(p: &Parameters, pendulum: &Pendulum, t: f64) -> rotation_dynamics::Result<State> {
    let (normal, twice) = (SpaceVector::new(0.0, 0.0, 1.0), pendulum.at(t)?);
    let attitude = Attitude::about_space_axis(normal, p.mean_motion * t + 0.5 * twice.theta)?;
    State::new(attitude, normal * (100.0 * (p.mean_motion + 0.5 * twice.omega)))
}

/// By how much each of the day's states is off, rad.
pub fn off(p: &Parameters, states: &[State]) -> Result<Vec<f64>> {
    let (pendulum, hours) = (pendulum(p)?, 1..);
    let off = |(hour, state): (i32, &State)| {
        let exact = exact(p, &pendulum, 3600.0 * f64::from(hour))?;
        Ok(state.attitude.angle_to(&exact.attitude))
    };
    hours.zip(states).map(off).collect()
}

/// The period of the solved satellite, by two times at which it hangs straight.
fn measured_period(p: &Parameters) -> Result<f64> {
    let upright = upright(p, 1.5 * pendulum(p)?.period())?;
    Ok(upright[2].t - upright[0].t)
}

/// The rotation nearest to the matrix by another way: (M + M^-T)/2 again and again.
fn put_right_by_halves() -> Result<Attitude> {
    let mut matrix = Matrix3::from_fn(|row, column| f64::from(MEASURED[row][column]));
    for _ in 0..20 {
        let inverse = matrix.try_inverse().unwrap_or_default();
        matrix = 0.5 * (matrix + inverse.transpose());
    }
    // An array of its columns.
    Ok(Attitude::from_matrix(matrix.transpose().into())?)
}

/// The largest angle by which the satellite is elsewhere if it has a magnet, looked at every
/// quarter of an hour of the day: by `solve`, and by steps of DOP853 with this error.
pub fn led_astray(p: &Parameters, magnet: impl Effect + Clone, step: f64) -> Result<[f64; 2]> {
    let ((plain, start), limits) = (satellite(p)?, Limits::default());
    let scene = plain.with(magnet);
    let quarters: Vec<f64> = (1..=96).map(|n| 900.0 * f64::from(n)).collect();
    let without = plain.solve_at(&start, &quarters, p.tolerance, &limits)?;
    let with = scene.solve_at(&start, &quarters, p.tolerance, &limits)?;
    let run = Dop853::new(step)?.solve(&scene, 0.0, &components(&start), DAY, &[])?;
    let (mut by_solve, mut by_steps) = (0.0_f64, 0.0_f64);
    for ((t, state), other) in quarters.into_iter().zip(with).zip(without) {
        let stepped = integrators::scene::state(&run.at(t)?)?;
        by_solve = by_solve.max(state.attitude.angle_to(&other.attitude));
        by_steps = by_steps.max(stepped.attitude.angle_to(&other.attitude));
    }
    Ok([by_solve, by_steps])
}

/// The rate of its slow swing out of the plane, mostly about its long axis, if all swings are
/// small: n0 x, where x^4 - (1 + 3 a + a b) x^2 + 4 a b = 0, rad/s.
pub fn slow_rate(p: &Parameters) -> f64 {
    let [a, b]: [f64; 2] = [(100.0 - 20.0) / 90.0, (100.0 - 90.0) / 20.0];
    let half = 0.5 * (1.0 + 3.0 * a + a * b);
    p.mean_motion * (half - (half * half - 4.0 * a * b).sqrt()).sqrt()
}

/// The same from the solved motion, turned by 1e-4 rad about its long axis at the start: of
/// x(t) with two rates, S = (x(t + h) + x(t - h))/x(t) has two values, 2 cos(rate h), which
/// obey S^2 = u S + v.
pub fn measured_slow_rate(p: &Parameters) -> Result<f64> {
    let still = p.but(|p| p.askew = 1e-9);
    let (scene, start) = satellite(&still)?;
    let turned = start.attitude.turned_in_body(BodyVector::new(1e-4, 0.0, 0.0))?;
    let normal = SpaceVector::new(0.0, 0.0, p.mean_motion);
    let start = scene.body().state(turned, turned.to_body(normal))?;
    let h = 1.0 / p.mean_motion;
    let times: Vec<f64> = (0..8).map(|k| h * f64::from(k)).collect();
    let states = scene.solve_at(&start, &times, 1e-12, &Limits::default())?;
    let x = |k: usize| states[k].attitude.to_space(BodyVector::new(0.0, 1.0, 0.0)).z();
    // S^2 x is x two steps ahead and behind, and x twice.
    let row = |k: usize| [x(k + 1) + x(k - 1), x(k), x(k + 2) + x(k - 2) + 2.0 * x(k)];
    let ([a, b, c], [d, e, f]) = (row(2), row(5));
    let u = (c * e - b * f) / (a * e - b * d);
    let v = (a * f - c * d) / (a * e - b * d);
    Ok(acos(0.25 * u + (u * u / 16.0 + 0.25 * v).sqrt()) / h)
}

/// The tilt of the driven top after a second by the equations of the notes, 16.2 (2) and
/// (3), in theta, theta' and L_Z; L_z grows with the torque.
fn tilt_by_angles(torque: f64) -> Result<f64> {
    let (i1, weight, spin) = (5.45e-3, 0.49, 100.0 * 9.0e-4);
    let law = ode(move |t, &[theta, rate, vertical]: &[f64; 3]| {
        let ((s, c), axial) = (sincos(theta), spin + torque * t);
        let precession = (vertical - axial * c) / (i1 * s * s);
        let pull = weight * s - precession * s * (axial - i1 * precession * c);
        [rate, pull / i1, torque * c]
    })
    .scaled(size_or([1.0; 3]));
    Ok(after(1.0, &law, &[1.0, 0.0, spin * cos(1.0)], 1e-13)?[0])
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (swings, states) = (pendulum(p)?, day(p)?);
    let ((scene, start), end) = (satellite(p)?, states[23]);
    let (rate, n0) = (swings.small_swing_frequency(), p.mean_motion);
    let jacobi = |t, state: &State| scene.energy_at(t, state) - n0 * state.angular_momentum.z();
    let period = swings.period();
    let early = 2.0 * p.tolerance / (rate * sin(p.askew).abs());
    let [astray, astray_by_steps] = led_astray(p, magnet(MAGNET), 1e-13)?;
    let tenth = p.but(|p| p.askew *= 0.1);
    let [calm, calm_by_steps] = led_astray(&tenth, magnet(MAGNET), 1e-13)?;
    let (angles, stepped) = (after_a_minute()?, stepped_for_a_minute()?);
    let whole = TAU * ((angles.phi - stepped.phi) / TAU).round();
    let (state, last) = (after_a_second(p)?, 100.0 + p.torque / 9.0e-4);
    let spin = rotor()?.angular_velocity(&state).z();
    let first = upright(p, 0.5 * period)?[0];
    let ((phone, off), halved, third) = (put_right()?, put_right_by_halves()?, on_the_way()?);
    let [phone_angles, halves] = [phone, halved].map(|attitude| attitude.yaw_pitch_roll());
    let matrix = halved.matrix();
    let apart = |n: usize| f64::from(MEASURED[n / 3][n % 3]) - matrix[n / 3][n % 3];
    let squares: f64 = (0..9).map(|n| apart(n) * apart(n)).sum();
    let trace = matrix[0][0] + matrix[1][1] + matrix[2][2];
    let flight = thrown(&recorded()?)?;
    report.add(Table::of("thrown", ["what it says"], told(&flight), |line| Ok([line]))?)?;
    let ratio = |i| flight.ratio(i, 2).map_or([f64::NAN; 2], |r| [r.value, 0.5 * (r.to - r.from)]);
    let thrown = [0, 1].map(ratio);
    claims! { report,
        /// satellite: period of its swing about the vertical
        swing_period: period, "s", "the solved motion hangs straight" => measured_period(p)?, within early, in "The satellite":
            TAU / rate => "that is for a small swing",
            TAU / n0 => "that is a turn about the Earth",
            period * 2.0_f64.sqrt() => "the angle enters as sin(2 a): twice the angle swings like a pendulum";
        /// satellite: when it first hangs straight
        first_upright: first.t, "s", "a quarter of the period" => 0.25 * period, within first.t_estimate;
        /// satellite: angle from the vertical after a day
        swing_day: 0.5 * swings.at(DAY)?.theta, "rad", "solved" => swing(p, DAY, &end), within p.tolerance;
        /// satellite: energy less n0 L_Z, which is kept
        jacobi: jacobi(0.0, &start), "J", "solved, after a day" => jacobi(DAY, &end), within 1e2 * p.tolerance * n0 * n0;
        /// satellite: rate of the slow swing out of the plane
        slow_rate: slow_rate(p), "rad/s", "two rates of a solved motion" => measured_slow_rate(p)?, within 1e-6 * slow_rate(p);
        /// satellite with a magnet: how far it is from where it would be, at most
        magnet_worst: astray, "rad", "steps of DOP853" => astray_by_steps, within 1e2 * p.tolerance;
        /// the same if it swings a tenth as wide
        magnet_calm: calm, "rad", "steps of DOP853" => calm_by_steps, within 1e2 * p.tolerance;
        /// top: tilt after a minute
        top_tilt: angles.theta, "rad", "stepped" => stepped.theta, within 1e-9;
        /// top: azimuth after a minute, whole turns counted
        top_azimuth: angles.phi, "rad", "stepped" => stepped.phi + whole, within 2e-9;
        /// phone: how far its matrix is from a rotation
        measured_off: off, "-", "(M + M^-T)/2 again and again" => squares.sqrt(), within 1e-14;
        /// phone: yaw
        yaw: phone_angles.yaw, "rad", "the same way" => halves.yaw, within 1e-14;
        /// phone: pitch
        pitch: phone_angles.pitch, "rad", "the same way" => halves.pitch, within 1e-14;
        /// phone: roll
        roll: phone_angles.roll, "rad", "the same way" => halves.roll, within 1e-14;
        /// phone: its turn after a third of the way
        third: third.rotation_vector().norm(), "rad", "a third of acos((trace - 1)/2)" => acos(0.5 * (trace - 1.0)) / 3.0, within 1e-14;
        /// thrown phone: least moment over the largest
        thrown_13: thrown[0][0], "-", "made with" => PHONE[0] / PHONE[2], within thrown[0][1];
        /// thrown phone: middle moment over the largest
        thrown_23: thrown[1][0], "-", "made with" => PHONE[1] / PHONE[2], within thrown[1][1];
        /// motor: angular velocity along the axle after a second
        motor_spin: last, "rad/s", "solved" => spin, within p.tolerance * last, in "The motor":
            100.0 + p.torque / 5.45e-3 => "that is the moment across the axis",
            p.torque / 9.0e-4 => "it did not begin at rest";
        /// motor: tilt after a second
        motor_tilt: state.attitude.euler_angles().theta, "rad", "DOP853 on (2), (3)" => tilt_by_angles(p.torque)?,
        within p.tolerance;
    }
}

/// A body for which the gradient has no torque, a small swing, and a motor that is off.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let (normal, askew) = (SpaceVector::new(0.0, 0.0, 1.0), p.askew);
    let down = SpaceVector::new(-1.0, 0.0, 0.0);
    let ball = RigidBody::new(PrincipalMoments::new(100.0, 100.0, 100.0)?);
    let pulled = Scene::new(ball).with(GravityGradient::on_orbit(p.mean_motion, normal, down)?);
    let start = Attitude::about_space_axis(normal, askew)?;
    let start = ball.state(start, BodyVector::new(0.0, 0.0, p.mean_motion))?;
    let end = pulled.solve(&start, DAY, 1e-9)?.state;
    let small = p.but(|p| (p.askew, p.tolerance) = (1e-3, 1e-10));
    let rate = pendulum(p)?.small_swing_frequency();
    let ((scene, start), spin) = (driven(0.0)?, BodyVector::new(0.0, 0.0, 100.0));
    let off = scene.solve(&start, 1.0, 1e-9)?.state.attitude;
    let top = HeavyTop::new(SymmetricTop::new(5.45e-3, 9.0e-4, 4.9, 0.1)?, tilted()?, spin)?;
    limits! { report,
        /// all axes alike: no side is nearer than another
        "a ball for a satellite: angle after a day over that at the start":
            swing(p, DAY, &end) / askew => 1.0, within 1e-9 / askew;
        /// a small swing is harmonic, its rate n0 sqrt(3 (I2 - I1)/I3)
        "askew by 1e-3 rad: rate x period, by the solved motion":
            rate * measured_period(&small)? => TAU, within 1e-5;
        /// without the motor the top has a closed form
        "motor off: angle from the closed form after a second, rad":
            off.angle_to(&top.try_attitude(1.0)?) => 0.0, within 1e-9;
    }
}

/// The same satellite on an orbit of this eccentricity, started at the pericentre on a swing of this
/// size about the direction of the Earth: how far from it a quarter of an orbit later, rad.
pub fn forced(p: &Parameters, eccentricity: f64, swing: f64) -> Result<f64> {
    let (n0, (scene, _)) = (p.mean_motion, satellite(p)?);
    let orbit = KeplerOrbit::elliptic(1.0, TAU / n0, eccentricity)?;
    let earth = OrbitingBody::new(n0 * n0, orbit)?;
    let (place, moment) = (orbit.place(0.0), scene.body().moments().i3());
    let rate = place.cross(&orbit.velocity(0.0)) * (1.0 / place.dot(&place));
    let momentum = (rate + orbit.normal(0.0) * (swing * n0)) * moment;
    let start = State::new(Attitude::IDENTITY, momentum)?;
    let quarter = 0.25 * TAU / n0;
    let end = (Scene::new(*scene.body()).with(earth)).solve(&start, quarter, p.tolerance)?;
    let long = end.state.attitude.to_space(BodyVector::new(1.0, 0.0, 0.0));
    let down = orbit.place(quarter);
    Ok(atan2(down.cross(&long).norm(), down.dot(&long)))
}

/// What acts on a real satellite of this size, two metres long, and is left out.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let ((scene, start), stiff) = (satellite(p)?, 210.0 * p.mean_motion * p.mean_motion);
    // Sunlight, 4.5e-6 N/m^2, on 4 m^2, 5 cm beside the centre of mass.
    let light = 4.5e-6 * 4.0 * 0.05;
    let sunlight = Torque::on_space("sunlight", |_, _, _| SpaceVector::new(0.0, 0.0, light));
    let (sunlight, magnet) = (sunlight.smooth(), magnet(MAGNET));
    let left_out = scene.neglected_effects(&start, DAY, p.tolerance)?;
    let formula = "torque / 3 n0^2 (I2 - I1)";
    let [lit, drawn] = [light, MAGNET].map(|torque| torque / stiff);
    let (orbit, e) = ("an orbit that is no circle, e = 0.001", 1e-3);
    let swing = 2.0 * e / (3.0 * 0.7 - 1.0);
    report.add(vec![
        left_out.line("sunlight off the centre", formula, lit, &sunlight, "rad in a day")?,
        left_out.line("magnet on board", formula, drawn, &magnet, "rad in a day")?,
        effect(orbit)
            .number("e", e)
            .costs(swing, "rad, forced, once an orbit")
            .measured(forced(p, e, swing)?),
    ])?;
    effect_card! { report,
        "gradient of gravity": "3 (I2 - I1) / I3" = 2.1, costs 2.0 * p.askew.abs(), "rad, to the other side", included;
    }
}

/// The strip of the satellite's day, and what the library says when it is asked.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let ((scene, start), pendulum) = (satellite(p)?, pendulum(p)?);
    let problem = Problem::new(scene, start, DAY, exact(p, &pendulum, DAY)?);
    report.strip(&problem, &[p.tolerance, 1e-4, 1e-6, 1e-10])?;
    let (pendulum, p) = (pendulum.clone(), p.clone());
    report.set_closed_form(ClosedForm::new(move |part| exact(&p, &pendulum, part * DAY)));
    Ok(())
}

/// What each of the three motions answers to the questions of [`Motion`].
fn asked(p: &Parameters, report: &mut Report) -> Result<()> {
    let ((satellite, hung), (driven, started), limits) =
        (satellite(p)?, driven(p.torque)?, Limits::default());
    let of_satellite = satellite.solve_along(&hung, DAY, p.tolerance, &limits)?;
    let of_motor = driven.solve_along(&started, 1.0, p.tolerance, &limits)?;
    let top = top()?;
    let motions: [(&str, &dyn Motion<State = State>, f64); 3] =
        [("satellite", &of_satellite, DAY), ("top", &top, 60.0), ("motor", &of_motor, 1.0)];
    let columns = ["motion", "name()", "try_state(t)", "kept()", "condition(t)"];
    report.add(Table::of("motion", columns, motions, |(name, motion, t)| {
        let tilt = motion.try_state(t)?.attitude.euler_angles().theta;
        let kept: Vec<&str> = motion.kept().iter().map(|kept| kept.name).collect();
        Ok([
            name.to_owned(),
            motion.name().to_owned(),
            format!("t = {} s: e3 at {} rad from Z", short(t, 3), supported_digits(tilt, 1e-6)),
            if kept.is_empty() { "-".to_owned() } else { kept.join("; ") },
            format!("{} rad", short(motion.condition(t)?, 2)),
        ])
    })?)
}

/// What is refused, and in which words.
fn refused(p: &Parameters, report: &mut Report) -> Result<()> {
    let ((scene, start), (body, motor)) = (driven(p.torque)?, (rotor()?, driven(p.torque)?.0));
    let bearing = CoulombBearing::new(1e-4, &body, &start, 0.0)?;
    let few = Limits { budget: 1000, ..Limits::default() };
    let (orbit, askew) = satellite(&p.but(|p| p.askew = 0.3))?;
    let wide = orbit.with(magnet(MAGNET)).solve(&askew, DAY, 1e-8).err();
    let rubbed = motor.with(bearing).solve(&start, 1.0, 1e-8).err();
    let asked = [
        ("a body that cannot be: I = 1, 2, 4", PrincipalMoments::new(1.0, 2.0, 4.0).err()),
        ("an end that is no number", scene.solve(&start, f64::NAN, 1e-8).err()),
        ("more digits than the start determines", scene.solve(&start, 1.0, 1e-15).err()),
        ("a day with the magnet, if the swing is 0.3 rad", wide),
        ("a day with a thousand torques", scene.solve_with(&start, DAY, 1e-8, &few).err()),
        ("dry friction, where a motor drives the axle", rubbed),
        ("the top at a time that is no number", top()?.try_state(f64::INFINITY).err()),
    ];
    report.add(Table::of("refused", ["asked", "answer"], asked, |(request, answer)| {
        let answer = answer.map_or("granted".to_owned(), |error| error.to_string());
        Ok([request.to_owned(), answer])
    })?)
}

example! {
    library: "The library without the book: a satellite, a top, and an effect of one's own";
    "The library alone", "a satellite for a day, a top at one time, and a motor as an effect of one's own",
    [claims, limits, effects, accuracy, asked, refused];
    figures::figures, figures::trajectory, figures::moving_picture
}
