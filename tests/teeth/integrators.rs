//! Damaged splittings and damaged equations of motion of the notes' top.

use crate::top::{HeavyTop, distance, figure_3};
use rotation_dynamics::Result;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::State;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::integrators::splitting::{BodyPoint, Outer};
use rotation_dynamics::integrators::{
    Dop853, Integrator, Ode, Scheme, Separable, Splitting, size_or,
};
use support::assert_error;

const T: f64 = 20.0;

/// What two good methods agree to (measured 7.3e-15 in `tests/integrators/convergence`).
const BOUND: f64 = 8e-15;

fn good() -> State {
    let (scene, start) = figure_3();
    let method = Dop853::new(1e-15).expect("valid");
    method.advance(&scene, 0.0, &start, T).expect("smooth").0
}

#[derive(Clone, Copy, PartialEq)]
enum Damage {
    None,
    SpinForgotten,
    SpinOfTheWrongSign,
    KickOfTheWrongSign,
    FlowALittleLong,
    KickALittleStrong,
    NeverSettled,
}

struct DamagedTop(HeavyTop, Damage);

impl Separable for DamagedTop {
    type State = State;
    type Point = BodyPoint;

    fn enter(&self, state: &State) -> Result<BodyPoint> {
        self.0.enter(state)
    }

    fn leave(&self, point: &BodyPoint, elapsed: f64) -> Result<State> {
        let factor = match self.1 {
            Damage::SpinForgotten => 0.0,
            Damage::SpinOfTheWrongSign => -1.0,
            _ => 1.0,
        };
        self.0.leave(point, factor * elapsed)
    }

    fn flow(&self, point: &mut BodyPoint, dt: f64) {
        let more = f64::from(u8::from(self.1 == Damage::FlowALittleLong));
        self.0.flow(point, dt * (1.0 + 1e-12 * more));
    }

    fn kick(&self, point: &mut BodyPoint, dt: f64) {
        let factor = match self.1 {
            Damage::KickOfTheWrongSign => -1.0,
            Damage::KickALittleStrong => 1.0 + 1e-12,
            _ => 1.0,
        };
        self.0.kick(point, factor * dt);
    }

    fn settle(&self, point: &mut BodyPoint) {
        if self.1 != Damage::NeverSettled {
            self.0.settle(point);
        }
    }
}

#[test]
fn damaged_splittings_miss() {
    let (scene, start) = figure_3();
    let exact = good();
    let method = Splitting::new(Scheme::SRKN14, 1000).expect("some steps");
    let off = |damage| {
        let (end, _) = method.advance(&DamagedTop(scene, damage), 0.0, &start, T).expect("smooth");
        distance(&end, &exact)
    };
    assert_error!(off(Damage::None), 7.3e-15);
    // Settling only keeps the length: the attitude does not need it.
    assert_error!(off(Damage::NeverSettled), 7.2e-15);
    let mut ran = 0;
    for damage in [Damage::SpinForgotten, Damage::SpinOfTheWrongSign, Damage::KickOfTheWrongSign] {
        // Measured: 1.6, 3.1, 2.0 rad.
        assert!(off(damage) > 0.1);
        ran += 1;
    }
    for damage in [Damage::FlowALittleLong, Damage::KickALittleStrong] {
        // Measured: 3.5e-11, 1.8e-12.
        assert!(off(damage) > 10.0 * BOUND);
        ran += 1;
    }
    assert_eq!(ran, 5);
}

#[test]
fn a_lopsided_scheme_does_not_come_back() {
    let lopsided =
        Scheme { outer: Outer::Flow, outer_parts: &[0.5 + 1e-9, 0.5 - 1e-9], ..Scheme::STRANG };
    let (scene, start) = figure_3();
    let method = Splitting::new(lopsided, 400).expect("some steps");
    let (end, _) = method.advance(&scene, 0.0, &start, T).expect("there");
    let (back, _) = method.advance(&scene, T, &end, 0.0).expect("back");
    // Measured: 8.0e-11, against 3.1e-16 of the symmetric scheme.
    assert!(distance(&back, &start) > 1e-12);
}

/// Euler's equations for the momentum on the body's axes, with the gyroscopic term
/// or without.
struct OnBodyAxes {
    scene: HeavyTop,
    gyroscopic: f64,
}

impl Ode<7> for OnBodyAxes {
    fn derivative(&self, t: f64, &[w, x, y, z, l1, l2, l3]: &[f64; 7]) -> [f64; 7] {
        let attitude = Attitude::from_quaternion([w, x, y, z]).expect("not zero");
        let momentum = BodyVector::new(l1, l2, l3);
        let state = State { attitude, angular_momentum: attitude.to_space(momentum) };
        let torque = attitude.to_body(self.scene.torque(t, &state));
        let omega = self.scene.body().angular_velocity(&state);
        let rate = torque - omega.cross(&momentum) * self.gyroscopic;
        let [p, q, r] = omega.to_array();
        [
            0.5 * (-x * p - y * q - z * r),
            0.5 * (w * p + y * r - z * q),
            0.5 * (w * q + z * p - x * r),
            0.5 * (w * r + x * q - y * p),
            rate.x(),
            rate.y(),
            rate.z(),
        ]
    }

    fn scale(&self, y: &[f64; 7]) -> [f64; 7] {
        size_or([1.0; 7])(y)
    }
}

#[test]
fn the_gyroscopic_term_counts() {
    let (scene, start) = figure_3();
    let exact = good();
    let off = |gyroscopic| {
        let [w, x, y, z] = start.attitude.quaternion();
        let [l1, l2, l3] = scene.body().angular_momentum(&start).to_array();
        let ode = OnBodyAxes { scene, gyroscopic };
        let method = Dop853::new(1e-15).expect("valid");
        let (end, _) = method.advance(&ode, 0.0, &[w, x, y, z, l1, l2, l3], T).expect("smooth");
        let [w, x, y, z, l1, l2, l3] = end;
        let attitude = Attitude::from_quaternion([w, x, y, z]).expect("not zero");
        let angular_momentum: SpaceVector = attitude.to_space(BodyVector::new(l1, l2, l3));
        distance(&State { attitude, angular_momentum }, &exact)
    };
    assert_error!(off(1.0), 7.5e-15);
    assert_error!(off(0.0), 0.83);
    assert_error!(off(1.0 + 1e-12), 9.2e-12);
}
