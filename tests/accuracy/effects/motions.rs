//! Motions under one effect, solved, against closed forms that share nothing with the solver.

use super::{body, tilted};
use rotation_dynamics::accuracy::Limits;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    DiscDrag, Effect, Feature, FlowRegime, Gravity, GravityAtLever, PrescribedTorque, Profile,
    Properties, ViscousFriction, check,
};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::math::{atan2, exp, hypot, pow};
use rotation_dynamics::scene::Scene;
use support::{EPS, Errors, assert_largest};

pub const TOLERANCES: [f64; 3] = [1e-4, 1e-7, 1e-10];

/// What is delivered over what is asked for, at these times, and how far the motion with
/// something wrong would be off (rad).
pub fn judge<E: Effect>(
    [delivered, twin]: [&mut Errors; 2],
    scene: &Scene<E>,
    start: &State,
    times: &[f64],
    exact: impl Fn(f64) -> Attitude,
    wrong: impl Fn(f64) -> Attitude,
) {
    for tolerance in TOLERANCES {
        let states = scene.solve_at(start, times, tolerance, &Limits::default()).expect("solved");
        for (t, state) in times.iter().zip(states) {
            let error = state.attitude.angle_to(&exact(*t));
            delivered.push_at(error / tolerance, (tolerance, t));
            twin.push_at(state.attitude.angle_to(&wrong(*t)), (tolerance, t));
        }
    }
}

fn spun(angle: f64) -> Attitude {
    Attitude::about_body_axis(BodyVector::new(0.0, 0.0, 1.0), angle).expect("an attitude")
}

fn spinning(body: &RigidBody, spin: f64) -> State {
    let rates = BodyVector::new(0.0, 0.0, spin);
    (body.state(Attitude::IDENTITY, rates)).expect("a state")
}

/// A spin about the axis decays as exp(-c t/I3), and the angle is what it has left behind.
#[test]
fn viscous_friction_takes_the_spin_exponentially() {
    let mut delivered = Errors::of("delivered over requested");
    let mut twin = Errors::of("twin: without friction");
    let body = body(1.0, 1.4, 0.8);
    let (spin, c) = (3.0, 0.2);
    let scene = Scene::new(body).with(ViscousFriction::about_axis(c).expect("friction"));
    let angle = |t: f64| spin * 0.8 / c * (1.0 - exp(-c * t / 0.8));
    judge(
        [&mut delivered, &mut twin],
        &scene,
        &spinning(&body, spin),
        &[1.0, 5.0, 20.0],
        |t| spun(angle(t)),
        |t| spun(spin * t),
    );
    assert_largest!(delivered, 9, @"0.0207");
    twin.exceed(0.1, 9);
}

/// With c_t/I1 = c_a/I3 = k the torque is -k L: the motion is that of the free body at
/// another time, (1 - exp(-k t))/k.
#[test]
fn viscous_friction_slows_a_precession_like_a_clock() {
    let mut delivered = Errors::of("delivered over requested");
    let mut twin = Errors::of("twin: without friction");
    let body = body(1.0, 1.0, 0.6);
    let start = tilted(&body, [0.7, -0.4, 3.0]);
    let k = 0.15;
    let friction = ViscousFriction::new(k * 1.0, k * 0.6).expect("friction");
    let free = FreeBody::new(body.moments(), start.attitude, body.angular_velocity(&start));
    let free = free.expect("a motion");
    judge(
        [&mut delivered, &mut twin],
        &Scene::new(body).with(friction),
        &start,
        &[1.0, 5.0, 20.0],
        |t| free.attitude((1.0 - exp(-k * t)) / k),
        |t| free.attitude(t),
    );
    assert_largest!(delivered, 9, @"7.24e-3");
    twin.exceed(0.1, 9);
}

/// omega^-1/2 and omega^-4/5 grow linearly, in the laminar and the turbulent regime.
#[test]
fn disc_drag_slows_a_spin_by_a_power() {
    let mut delivered = Errors::of("delivered over requested");
    let mut twin = Errors::of("twin: the law of the other regime");
    let i3 = 0.02;
    let body = body(0.01, 0.01, i3);
    // Re = 1.3e5 and 1.3e6 in air.
    for (spin, regime) in [(20.0, FlowRegime::Laminar), (200.0, FlowRegime::Turbulent)] {
        let (radius, density, viscosity) = (0.3125, 1.204, 1.51e-5);
        let drag = DiscDrag::new(radius, density, viscosity, spin).expect("drag");
        assert_eq!(drag.regime(), regime);
        // k of omega' = -k omega^(1 + p).
        let r5 = pow(radius, 5.0);
        let unit = radius * radius / viscosity;
        let laminar = 0.5 * density * r5 * 3.87 / (unit.sqrt() * i3);
        let turbulent = 0.5 * density * r5 * 0.146 / (pow(unit, 0.2) * i3);
        let by_laminar = |t: f64| {
            let (a, k) = (1.0 / f64::sqrt(spin), laminar);
            t / (a * (a + 0.5 * k * t))
        };
        let by_turbulent = |t: f64| {
            let (u, k) = (pow(spin, -0.8), turbulent);
            5.0 / k * (pow(u, -0.25) - pow(u + 0.8 * k * t, -0.25))
        };
        let angle = |t: f64, regime: FlowRegime| match regime {
            FlowRegime::Laminar => spun(by_laminar(t)),
            FlowRegime::Turbulent => spun(by_turbulent(t)),
        };
        let other = match regime {
            FlowRegime::Laminar => FlowRegime::Turbulent,
            FlowRegime::Turbulent => FlowRegime::Laminar,
        };
        judge(
            [&mut delivered, &mut twin],
            &Scene::new(body).with(drag),
            &spinning(&body, spin),
            &[0.5, 2.0, 5.0],
            |t| angle(t, regime),
            |t| angle(t, other),
        );
    }
    assert_largest!(delivered, 18, @"2.48e-3");
    twin.exceed(1e-3, 18);
}

/// An asymmetric body on a level axis, its centre of mass off both other axes: a pendulum.
#[test]
fn gravity_anywhere_makes_a_physical_pendulum() {
    let mut delivered = Errors::of("delivered over requested");
    let mut twin = Errors::of("twin: as if the centre of mass were on the axis");
    let body = body(1.3, 0.9, 0.8);
    let (mass, gravity, y, z) = (1.5, 9.8, 0.3, -0.4);
    let moment = Gravity::new(mass * gravity, BodyVector::new(0.0, y, z)).expect("gravity");
    let x = SpaceVector::new(1.0, 0.0, 0.0);
    let about_x = |angle| Attitude::about_space_axis(x, angle).expect("an attitude");
    for (tilt, rate) in [(0.4, 0.0), (2.0, 1.0), (0.5, 9.0)] {
        let start = (body.state(about_x(tilt), BodyVector::new(rate, 0.0, 0.0))).expect("a state");
        let swing = |y: f64, z: f64| {
            let suspension = Suspension { moment: 1.3, mass, gravity, lever: hypot(y, z) };
            let hanging = atan2(y, -z);
            let pendulum = Pendulum::new(suspension, tilt + hanging, rate).expect("a pendulum");
            move |t: f64| about_x(pendulum.at(t).expect("a time").theta - hanging)
        };
        judge(
            [&mut delivered, &mut twin],
            &Scene::new(body).with(moment),
            &start,
            &[1.0, 3.0, 6.0],
            swing(y, z),
            swing(0.0, z),
        );
    }
    assert_largest!(delivered, 27, @"1.82e-4");
    twin.exceed(1e-2, 27);
}

/// On the axis the two gravities are one, closed form and all.
#[test]
fn gravity_on_the_axis_is_that_of_a_top() {
    let body = body(1.0, 1.0, 0.7);
    let start = tilted(&body, [0.1, -0.2, 3.0]);
    let lever = GravityAtLever::new(2.0, 0.3).expect("gravity");
    let anywhere = Gravity::new(2.0, BodyVector::new(0.0, 0.0, 0.3)).expect("gravity");
    let by_lever = Scene::new(body).with(lever).solve(&start, 5.0, 1e-9);
    let by_lever = by_lever.expect("solved");
    let solved = Scene::new(body).with(anywhere).solve(&start, 5.0, 1e-9);
    assert_eq!(solved.expect("solved"), by_lever);
    assert_eq!(by_lever.method, "closed form of the heavy top");
    let span = [0.0, 5.0];
    for twice in [
        check(&(lever, anywhere), &body, span, &start),
        check(&((), (anywhere, anywhere)), &body, span, &start),
    ] {
        let told = twice.expect_err("two weights").to_string();
        assert!(told.contains("gravity acts twice in this scene"), "{told}");
    }
}

/// The integral of (t - s) f(s) over s from 0 to t, by Simpson's rule on so many pieces
/// between the times given.
fn twice_integrated(f: &dyn Fn(f64) -> f64, cuts: &[f64], t: f64, pieces: usize) -> f64 {
    let mut ends: Vec<f64> = cuts.iter().copied().filter(|c| *c < t).collect();
    ends.push(t);
    let (mut sum, mut from) = (0.0, 0.0);
    for to in ends {
        let h = (to - from) / pieces as f64;
        for n in 0..pieces {
            let a = from + n as f64 * h;
            let [first, middle, last] =
                [a + 1e-9 * h, a + 0.5 * h, a + h - 1e-9 * h].map(|s| (t - s) * f(s));
            sum += h / 6.0 * (first + 4.0 * middle + last);
        }
        from = to;
    }
    sum
}

/// A motor about the axis: the angle is the torque integrated twice, by quadrature.
#[test]
fn a_prescribed_torque_is_integrated() {
    let mut delivered = Errors::of("delivered over requested");
    let mut twin = Errors::of("twin: a jump that comes 10 ms late");
    let body = body(1.0, 1.4, 0.5);
    let (torque, spin) = (0.7, 0.4);
    let steps = [(1.0, 1.0), (3.0, -0.5), (4.5, 0.0)];
    let lines = [(0.5, 1.0), (2.0, -0.5), (5.0, 0.4)];
    let cases = [
        (Profile::steps(&steps), vec![1.0, 3.0, 4.5]),
        (Profile::lines(&lines), vec![0.5, 2.0, 5.0]),
        (Profile::pulse(1.5, 0.3), vec![]),
    ];
    for (profile, cuts) in cases {
        let profile = profile.expect("a profile");
        let motor = BodyVector::new(0.0, 0.0, torque);
        let motor = PrescribedTorque::on_body(motor, profile.clone()).expect("a torque");
        let angle = |t: f64, late: f64| {
            let late_cuts: Vec<f64> = cuts.iter().map(|c| c + late).collect();
            let f = |s: f64| profile.at(s - late);
            spin * t + torque / 0.5 * twice_integrated(&f, &late_cuts, t, 20_000)
        };
        judge(
            [&mut delivered, &mut twin],
            &Scene::new(body).with(motor),
            &spinning(&body, spin),
            &[2.5, 4.0, 6.0],
            |t| spun(angle(t, 0.0)),
            |t| spun(angle(t, 0.01)),
        );
    }
    assert_largest!(delivered, 27, @"2.76e-4");
    twin.exceed(3.5e-4, 27);
}

/// On the fixed axes a torque adds to L what it is in all, whatever the body does.
#[test]
fn a_prescribed_torque_on_space_axes_adds_to_the_momentum() {
    let mut added = Errors::in_units_of(EPS, "momentum, of |L|");
    let mut twin = Errors::of("twin: one step left out, of |L|");
    let body = body(1.0, 1.4, 0.8);
    let start = tilted(&body, [0.3, 1.0, -0.6]);
    let torque = SpaceVector::new(0.3, -0.2, 0.5);
    let steps = Profile::steps(&[(1.0, 1.0), (3.0, -0.5), (4.5, 0.0)]).expect("steps");
    let push = PrescribedTorque::on_space(torque, steps).expect("a torque");
    let scene = Scene::new(body).with(push);
    for tolerance in TOLERANCES {
        let end = scene.solve(&start, 6.0, tolerance).expect("solved").state;
        let off = |all: f64| {
            let want = start.angular_momentum + torque * all;
            (end.angular_momentum - want).norm() / want.norm()
        };
        added.push(off(1.0 * 2.0 - 0.5 * 1.5));
        twin.push(off(1.0 * 2.0));
    }
    assert_largest!(added, 3, @"0");
    twin.exceed(0.05, 3);
}

/// A pulse that says nothing of its width.
struct Unnamed(PrescribedTorque);

impl Effect for Unnamed {
    const PROPERTIES: Properties = PrescribedTorque::PROPERTIES;

    fn name(&self) -> &'static str {
        "unnamed"
    }

    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state)
    }

    fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        self.0.torque_scale(t, body, state)
    }

    fn narrowest(&self) -> Option<Feature> {
        Some(Feature { time: 1e300, ..Feature::WIDE })
    }
}

/// No solution steps over a pulse of 2 ms in 20 s, for its width is named. One of 2 us whose width is
/// not, the twin's, is met by chance or not at all.
#[test]
fn a_narrow_pulse_is_not_stepped_over() {
    let mut delivered = Errors::of("delivered over requested");
    let mut twin = Errors::of("twin: the width is not named");
    let body = body(1.0, 1.4, 0.5);
    let (torque, width, centre, spin) = (40.0, 2e-3, 7.3, 0.4);
    let kick = |shorter: f64| {
        let pulse = Profile::pulse(centre, width / shorter).expect("a pulse");
        let kick = BodyVector::new(0.0, 0.0, torque * shorter);
        PrescribedTorque::on_body(kick, pulse).expect("a torque")
    };
    let start = spinning(&body, spin);
    // All of it lies between 0 and the end.
    let gained = torque * width * core::f64::consts::TAU.sqrt() / 0.5;
    let exact = spun(spin * 20.0 + gained * (20.0 - centre));
    for tolerance in TOLERANCES {
        let solved = Scene::new(body).with(kick(1.0)).solve(&start, 20.0, tolerance);
        let error = exact.angle_to(&solved.expect("solved").state.attitude);
        delivered.push_at(error / tolerance, tolerance);
        let solved = Scene::new(body).with(Unnamed(kick(1e3))).solve(&start, 20.0, tolerance);
        let error = exact.angle_to(&solved.expect("solved").state.attitude);
        twin.push_at(error / tolerance, tolerance);
    }
    assert_largest!(delivered, 3, @"1.16e-3");
    twin.exceed(1.0, 3);
}
