//! A Coulomb bearing brings a precessing body to a stop, exactly when it must.

use super::motions::judge;
use super::{body, tilted};
use rotation_dynamics::accuracy::Limits;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{CoulombBearing, GravityAtLever, check};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::math::sincos;
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_largest};

type Quaternion = [f64; 4];

fn product([a, b, c, d]: Quaternion, [w, x, y, z]: Quaternion) -> Quaternion {
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

/// The motion of a free symmetric body with a torque `push` along its axis until `stop`.
///
/// Beside the spin the body turns with (L_1, L_2, L_z(t))/I1, the first two constant: rates
/// that are linear in time, for which the equation of the quaternion has a power series
/// (that of the parabolic cylinder functions, as of Landau and Zener).
struct Braked {
    start: State,
    moments: [f64; 2],
    momentum: [f64; 3],
    push: f64,
    stop: f64,
}

impl Braked {
    fn new(body: &RigidBody, start: &State, push: f64, stop: f64) -> Self {
        let moments = body.moments();
        Self {
            start: *start,
            moments: [moments.i1(), moments.i3()],
            momentum: body.angular_momentum(start).to_array(),
            push,
            stop,
        }
    }

    fn attitude(&self, t: f64) -> Attitude {
        let ([i1, i3], [l1, l2, l3]) = (self.moments, self.momentum);
        let braked = t.min(self.stop);
        let [now, later] = [[0.0, l1 / i1, l2 / i1, l3 / i1], [0.0, 0.0, 0.0, self.push / i1]];
        // q' = q (now + later t)/2.
        let (mut before, mut term) = ([0.0; 4], [1.0, 0.0, 0.0, 0.0]);
        let mut sum = term;
        for n in 1..200 {
            let (a, b) = (product(term, now), product(before, later));
            let next = core::array::from_fn(|k| {
                0.5 * (a[k] * braked + b[k] * braked * braked) / f64::from(n)
            });
            (before, term) = (term, next);
            for k in 0..4 {
                sum[k] += term[k];
            }
        }
        // Then with the last rates, of which the third is 0.
        let l3_now = l3 + self.push * braked;
        let rate = (l1 * l1 + l2 * l2 + l3_now * l3_now).sqrt() / i1;
        let (s, c) = sincos(0.5 * rate * (t - braked));
        let turned = [c, s * l1 / (i1 * rate), s * l2 / (i1 * rate), s * l3_now / (i1 * rate)];
        let spun = (1.0 / i3 - 1.0 / i1)
            * (l3 * braked + 0.5 * self.push * braked * braked + l3_now * (t - braked));
        let (s, c) = sincos(0.5 * spun);
        let q = product(product(self.start.attitude.quaternion(), sum), turned);
        Attitude::from_quaternion(product(q, [c, 0.0, 0.0, s])).expect("an attitude")
    }
}

#[test]
fn a_precessing_body_stops_and_its_axis_goes_on() {
    let mut delivered = Errors::of("delivered over requested");
    let mut twin = Errors::of("twin: friction goes on after the stop, or never began");
    let body = body(1.0, 1.0, 0.6);
    for spin in [3.0, -3.0] {
        let start = tilted(&body, [0.7, 0.4, spin]);
        let bearing = CoulombBearing::new(0.3, &body, &start, 0.0).expect("a bearing");
        let stop = bearing.stop().expect("a stop");
        assert!((stop - 6.0).abs() < 1e-14, "{stop}");
        let exact = Braked::new(&body, &start, -0.3 * spin.signum(), stop);
        let endless = Braked::new(&body, &start, -0.3 * spin.signum(), f64::INFINITY);
        let free = Braked::new(&body, &start, 0.0, stop);
        judge(
            [&mut delivered, &mut twin],
            &Scene::new(body).with(bearing),
            &start,
            &[2.0, 5.9, 8.0, 12.0],
            |t| exact.attitude(t),
            |t| {
                if t < stop { free.attitude(t) } else { endless.attitude(t) }
            },
        );
    }
    assert_largest!(delivered, 24, @"5.90e-4");
    twin.exceed(1e-2, 24);
}

/// The spin falls linearly to a stop, and is 0 from then on: with gravity too.
#[test]
fn a_braked_top_stops_spinning() {
    let mut momentum = Errors::of("L_z against the line, over the tolerance");
    let mut twin = Errors::of("twin: the line goes on");
    let body = body(1.0, 1.0, 0.6);
    let start = tilted(&body, [0.1, 0.2, 4.0]);
    let tau = 0.4;
    let bearing = CoulombBearing::new(tau, &body, &start, 1.0).expect("a bearing");
    assert!((bearing.stop().expect("a stop") - 7.0).abs() < 1e-14);
    let gravity = GravityAtLever::new(1.0, 0.3).expect("gravity");
    let limits = Limits { t_start: 1.0, ..Limits::default() };
    let times = [2.0, 6.999, 7.0, 7.001, 9.0];
    for tolerance in [1e-4, 1e-7, 1e-10] {
        for states in [
            (Scene::new(body).with(gravity).with(bearing))
                .solve_at(&start, &times, tolerance, &limits),
            (Scene::new(body).with(bearing)).solve_at(&start, &times, tolerance, &limits),
        ] {
            for (t, state) in times.into_iter().zip(states.expect("solved")) {
                let found = body.angular_momentum(&state).z();
                let line = 0.6 * 4.0 - tau * (t - 1.0);
                momentum.push_at((found - line.max(0.0)) / tolerance, (t, tolerance));
                assert!((bearing.axial_momentum(t) - line.max(0.0)).abs() < 1e-14);
                if t > 7.0 {
                    twin.push(found - line);
                }
            }
        }
    }
    assert_largest!(momentum, 30, @"5.55e-6");
    twin.exceed(3e-4, 12);
}

/// The bearing takes the start, the body and the rest of the scene for granted, and looks.
#[test]
fn a_bearing_is_refused_where_its_stop_would_be_wrong() {
    use rotation_dynamics::effects::{Gravity, Torque, ViscousFriction};
    let body = body(1.0, 1.0, 0.6);
    let start = tilted(&body, [0.1, 0.2, 4.0]);
    let bearing = CoulombBearing::new(0.4, &body, &start, 0.0).expect("a bearing");
    let scene = Scene::new(body).with(bearing);
    let viscous = ViscousFriction::about_axis(0.1).expect("friction");
    let off = Gravity::new(1.0, BodyVector::new(0.1, 0.0, 0.0)).expect("gravity");
    let motor = Torque::on_body("motor", |_t, _body, _state| BodyVector::new(0.0, 0.0, 1.0));
    let other = tilted(&body, [0.1, 0.2, 3.0]);
    let odd = super::body(1.0, 1.1, 0.6);
    let alone =
        "\"Coulomb bearing\" must be the only torque about the body's axis; here are also: ";
    let span = [0.0, 2.0];
    let cases = [
        (check(&(bearing, viscous), &body, span, &start).err(), format!("{alone}viscous friction")),
        (check(&((), (off, bearing)), &body, span, &start).err(), format!("{alone}gravity")),
        (check(&((motor, bearing), ()), &body, span, &start).err(), format!("{alone}motor")),
        (check(&(bearing, bearing), &body, span, &start).err(), format!("{alone}Coulomb bearing")),
        (
            scene.solve(&other, 2.0, 1e-6).err(),
            "in which L_z is 2.4 at t = 0, and here it is 1.7".into(),
        ),
        (check(&bearing, &body, [1.0, 3.0], &start).err(), "in which L_z is 2".into()),
        (check(&bearing, &odd, [0.0, 3.0], &start).err(), "I2 - I1 = 0.1".into()),
        (CoulombBearing::new(0.4, &odd, &start, 0.0).err(), "0, a symmetric body".into()),
    ];
    let mut ran = 0;
    for (error, words) in cases {
        let told = error.expect(&words).to_string();
        assert!(told.contains(&words), "{told} should contain {words}");
        ran += 1;
    }
    assert_eq!(ran, 8);
    // From a state on its own motion it may go on.
    let on_the_way = scene.solve(&start, 2.0, 1e-13).expect("solved").state;
    check(&bearing, &body, [2.0, 9.0], &on_the_way).expect("the same motion");
}
