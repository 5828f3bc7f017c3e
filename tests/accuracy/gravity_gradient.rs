//! The gravity gradient: point masses, claims, libration, Jacobi's integral.

use super::twin::{KEEPS_ENERGY, NOT_ON_TIME, OTHER_POTENTIAL, OTHER_POWER, Twin, refused};
use rotation_dynamics::accuracy::{Limits, Resolution, Stepper};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityGradient, check};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::Method;
use rotation_dynamics::math::sin;
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_error, assert_largest, derivative};

const N0: f64 = 1.1e-3;

fn tilted_orbit() -> GravityGradient {
    let (normal, towards) = (SpaceVector::new(2.0, -1.0, 3.0), SpaceVector::new(1.0, 5.0, 1.0));
    GravityGradient::on_orbit(N0, normal, towards).expect("an orbit")
}

fn satellite() -> RigidBody {
    RigidBody::new(PrincipalMoments::new(20.0, 90.0, 100.0).expect("a body"))
}

fn tumbling(body: &RigidBody) -> State {
    let angles = EulerAngles { phi: 0.4, theta: 1.1, zeta: -0.7 };
    let attitude = Attitude::from_euler(angles).expect("angles");
    body.state(attitude, BodyVector::new(0.7 * N0, -1.3 * N0, 2.1 * N0)).expect("a state")
}

/// Six masses on the body's axes, each attracted by the inverse square of its own distance:
/// the torque of all, against that of the formula times `sign`, as a part of its scale.
fn against_point_masses(size: f64, sign: f64) -> Errors {
    let gradient = tilted_orbit();
    let (distance, mass) = (7e6, 2.0);
    let arms = [1.0, 0.6, 0.3].map(|part| part * size * distance);
    let [a, b, c] = arms.map(|arm| 2.0 * mass * arm * arm);
    let body = RigidBody::new(PrincipalMoments::new(b + c, a + c, a + b).expect("a body"));
    let strength = N0 * N0 * distance * distance * distance;
    let mut errors = Errors::of("torque against point masses");
    for i in 0..40 {
        let t = 333.0 * f64::from(i);
        let angles = EulerAngles {
            phi: 0.7 * f64::from(i),
            theta: 0.08 * f64::from(i),
            zeta: -0.3 * f64::from(i),
        };
        let state = State {
            attitude: Attitude::from_euler(angles).expect("angles"),
            angular_momentum: SpaceVector::zero(),
        };
        let attracting = gradient.direction(t) * distance;
        let mut torque = SpaceVector::zero();
        for axis in 0..3 {
            for arm in [arms[axis], -arms[axis]] {
                let mut place = [0.0; 3];
                place[axis] = arm;
                let place = state.attitude.to_space(BodyVector::from_array(place));
                let way = attracting - place;
                let force = way * (strength * mass / (way.norm() * way.dot(&way)));
                torque += place.cross(&force);
            }
        }
        let formula = gradient.torque(t, &body, &state) * sign;
        errors.push((torque - formula).norm() / gradient.torque_scale(t, &body, &state));
    }
    errors
}

#[test]
fn it_is_what_point_masses_feel() {
    // The next term that an even body has: a hundredth where the size is a tenth.
    assert_largest!(against_point_masses(1e-2, 1.0), 40, @"1.96e-4");
    assert_largest!(against_point_masses(1e-3, 1.0), 40, @"1.96e-6");
    // Turned round, even where the torque is short.
    against_point_masses(1e-3, -1.0).exceed(1e-2, 40);
}

#[test]
fn its_claims_hold_and_damaged_ones_do_not() {
    let span = [0.0, 20_000.0];
    let bodies = [
        PrincipalMoments::new(20.0, 90.0, 100.0),
        PrincipalMoments::new(100.0, 20.0, 90.0),
        PrincipalMoments::symmetric(3.0, 1.0),
        PrincipalMoments::symmetric(1.0, 1.0),
    ];
    let mut ran = 0;
    for moments in bodies {
        let body = RigidBody::new(moments.expect("a body"));
        let state = tumbling(&body);
        check(&tilted_orbit(), &body, span, &state).expect("on an orbit");
        let towards = SpaceVector::new(1.0, -2.0, 0.5);
        let fixed = GravityGradient::fixed(N0, towards).expect("a direction");
        check(&fixed, &body, span, &state).expect("fixed");
        ran += 2;
    }
    assert_eq!(ran, 8);
    let (body, orbit) = (satellite(), tilted_orbit());
    let state = tumbling(&body);
    let power = "says at what power it changes the energy";
    refused([
        (check(&Twin(&orbit, OTHER_POTENTIAL), &body, span, &state), power),
        (check(&Twin(&orbit, OTHER_POWER), &body, span, &state), power),
        (check(&Twin(&orbit, KEEPS_ENERGY), &body, span, &state), "says that it keeps the energy"),
        (check(&Twin(&orbit, NOT_ON_TIME), &body, span, &state), "does not depend on the time"),
    ]);
}

/// The pitch (rad) after a quarter of the period of small librations, over that at the start.
fn quarter(amplitude: f64, factor: f64) -> f64 {
    let (normal, down) = (SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(1.0, 0.0, 0.0));
    let gradient = GravityGradient::on_orbit(N0, normal, down).expect("an orbit");
    let body = satellite();
    let [a, b, c] = body.moments().to_array();
    let frequency = (factor * (b - a) / c).sqrt() * N0;
    let t = core::f64::consts::FRAC_PI_2 / frequency;
    let attitude = Attitude::about_space_axis(normal, amplitude).expect("an axis");
    let start = (body.state(attitude, BodyVector::new(0.0, 0.0, N0))).expect("a state");
    let end = (Scene::new(body).with(gradient).solve(&start, t, 1e-10)).expect("solved");
    let round = Attitude::about_space_axis(normal, N0 * t).expect("an axis");
    let pitch = end.state.attitude.then(&round.inverse());
    pitch.rotation_vector().z() / amplitude
}

/// Pitch librates at sqrt(3 (B - A)/C) n0 (Hughes 9.3).
#[test]
fn it_librates() {
    // What the amplitude adds to the period: pi/8 of its square, 3.9e-5 at 0.01.
    assert_error!(quarter(1e-2, 3.0), 3.9e-5);
    assert_error!(quarter(1e-3, 3.0), 3.9e-7);
    // Without the force's own change along the orbit, as on a string: 2 for 3.
    assert!(quarter(1e-3, 2.0).abs() > 0.3);
}

/// The energy in the axes that turn with the orbit, E - n0 . L, is kept; the energy is not.
/// Where its swing undoes the turn of the orbit it is nearly at rest, and the Earth goes on
/// round it: that is no power that the effect had not told.
#[test]
fn it_is_not_refused_where_it_hardly_turns() {
    let (normal, down) = (SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(-1.0, 0.0, 0.0));
    let gradient = GravityGradient::on_orbit(N0, normal, down).expect("an orbit");
    let body = satellite();
    let attitude = Attitude::about_space_axis(normal, 0.8).expect("an attitude");
    let start = body.state(attitude, BodyVector::new(0.0, 0.0, N0)).expect("a state");
    let scene = Scene::new(body).with(gradient);
    let day = scene.solve(&start, 86_400.0, 1e-8);
    assert!(day.expect("solved").estimate <= 1e-8);
}

#[test]
fn jacobis_integral_is_kept() {
    let (body, gradient) = (satellite(), tilted_orbit());
    let normal = gradient.direction(0.0).cross(&gradient.direction(0.5 / N0)) / sin(0.5);
    let scene = Scene::new(body).with(gradient);
    let start = tumbling(&body);
    let day = 86_400.0;
    let motion = (scene.solve_along(&start, day, 1e-9, &Limits::default())).expect("solved");
    let energy = |t: f64| scene.energy_at(t, &motion.try_state(t).expect("a state"));
    let jacobi = |t: f64| {
        let state = motion.try_state(t).expect("a state");
        energy(t) - N0 * normal.dot(&state.angular_momentum)
    };
    let mut kept = Errors::of("Jacobi's integral");
    let mut lost: f64 = 0.0;
    for i in 1..=50 {
        let t = day * f64::from(i) / 50.0;
        kept.add(jacobi(t), jacobi(0.0), energy(0.0));
        lost = lost.max((energy(t) / energy(0.0) - 1.0).abs());
    }
    assert_largest!(kept, 50, @"1.73e-15");
    assert!(lost > 0.1, "{lost:e}");
    // The power is what the energy changes by.
    let (t, h) = (12_345.0, 2.0);
    let slope = derivative(energy, t, h);
    let power = scene.power(t, &motion.try_state(t).expect("a state"));
    assert_error!(slope, power, 1e-9);
}

/// In a fixed direction the energy is kept, and L about that direction.
#[test]
fn a_fixed_direction_keeps_the_energy() {
    let body = satellite();
    let towards = SpaceVector::new(0.6, 0.0, 0.8);
    let scene = Scene::new(body).with(GravityGradient::fixed(N0, towards).expect("a direction"));
    let start = tumbling(&body);
    let end = scene.solve(&start, 20_000.0, 1e-10).expect("solved").state;
    assert_error!(scene.energy(&end), scene.energy(&start), 1.20e-15);
    let about = |state: &State| state.angular_momentum.dot(&towards);
    assert_error!(about(&end), about(&start), 5.17e-16);
    assert!((end.angular_momentum - start.angular_momentum).norm() > 0.1 * about(&start).abs());
}

#[test]
fn bad_input() {
    let (x, z) = (SpaceVector::new(1.0, 0.0, 0.0), SpaceVector::new(0.0, 0.0, 1.0));
    let refused = |n0, normal, towards| {
        let refused = GravityGradient::on_orbit(n0, normal, towards).expect_err("refused");
        refused.to_string()
    };
    assert_eq!(refused(0.0, z, x), "mean motion = 0 is not allowed: it must be greater than 0");
    assert_eq!(refused(f64::NAN, z, x), "mean motion = NaN is not a finite number");
    assert!(refused(1e200, z, x).contains("mean motion squared = inf"));
    assert!(refused(N0, SpaceVector::zero(), x).contains("length of a direction = 0"));
    assert!(refused(N0, z, x * f64::INFINITY).contains("towards, X = inf"));
    assert!(refused(N0, z, x + z).contains("0: the attracting body lies in the plane"));
    assert!(GravityGradient::fixed(-1.0, x).is_err());
}

/// The attitude after a day, fifteen orbits, of the tumbling satellite, by a Taylor series of 45
/// digits (tests/data/satellite.py).
fn after_a_day() -> Attitude {
    let numbers = include_str!("../data/satellite.txt").split_whitespace();
    let numbers: Vec<f64> = numbers.map(|x| x.parse().expect("a number")).collect();
    let [w, x, y, z, ..] = *numbers else {
        panic!("four numbers and more");
    };
    Attitude::from_quaternion([w, x, y, z]).expect("a quaternion")
}

/// Torques taken, and how far its attitude is off at the end (rad).
fn a_day(method: Method, resolution: Resolution, body: &RigidBody) -> (u64, f64) {
    let scene = Scene::new(*body).with(tilted_orbit());
    let stepper = Stepper::new(method, resolution).expect("a setting");
    let (end, work) =
        stepper.advance_as_usual(&scene, [0.0, 86_400.0], &tumbling(body)).expect("solved");
    (work.torques(), end.attitude.angle_to(&after_a_day()))
}

#[test]
fn a_satellites_day() {
    let body = satellite();
    let by = |method, resolution| a_day(method, resolution, &body);
    let (torques, off) = by(Method::GaussLegendre16, Resolution::Steps(200));
    assert_eq!(torques, 36_856);
    assert_error!(off, 2.655e-8);
    let (torques, off) = by(Method::GaussLegendre16, Resolution::Steps(400));
    assert_eq!(torques, 48_064);
    assert_error!(off, 1.96e-12);
    let (torques, off) = by(Method::Dop853, Resolution::Tolerance(1e-9));
    assert_eq!(torques, 9_158);
    assert_error!(off, 1.171e-5);
    let (torques, off) = by(Method::Dop853, Resolution::Tolerance(1e-12));
    assert_eq!(torques, 21_206);
    assert_error!(off, 8.838e-9);
    let (torques, off) = by(Method::Rk4, Resolution::Steps(10_000));
    assert_eq!(torques, 40_000);
    assert_error!(off, 2.595e-5);
    // `solve` delivers what it is asked for.
    let scene = Scene::new(body).with(tilted_orbit());
    let day = scene.solve(&tumbling(&body), 86_400.0, 1e-9).expect("solved");
    assert!(day.state.attitude.angle_to(&after_a_day()) <= 1e-9);
    // A moment that is off by 1e-12 of itself is seen.
    let other = PrincipalMoments::new(20.0, 90.0, 100.0 * (1.0 + 1e-12)).expect("a body");
    let steps = Resolution::Steps(400);
    let (_, off) = a_day(Method::GaussLegendre16, steps, &RigidBody::new(other));
    assert!(off > 1e-9, "{off:e}");
}
