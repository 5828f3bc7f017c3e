//! A body whose tensor of inertia follows its angular velocity.

use super::internal_dissipation::by_four_methods;
use super::twin::{AXIS_ONLY, NO_SLIP, NOT_ON_RATES, TORQUE_FREE, Twin, refused};
use rotation_dynamics::accuracy::Limits;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    Effect, ElasticYielding, GravityAtLever, InternalDissipation, Properties, ViscousFriction,
    check,
};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, ode};
use rotation_dynamics::math::log;
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::{Invariant, Scene};
use support::{Errors, assert_error, assert_largest, derivative};

const RATE: f64 = 2.0;

fn body(moments: [f64; 3]) -> RigidBody {
    let [i1, i2, i3] = moments;
    RigidBody::new(PrincipalMoments::new(i1, i2, i3).expect("a body"))
}

/// A body with three moments of which a third of the bulge follows, and its start.
fn soft() -> (RigidBody, ElasticYielding, State) {
    let body = body([1.0, 1.2, 1.5]);
    let yielding = ElasticYielding::following(0.3, &body, RATE).expect("a part");
    let rates = BodyVector::new(0.7, 0.4, 1.8);
    let start = yielding.state(&body, tilted(), rates).expect("a state");
    (body, yielding, start)
}

pub fn tilted() -> Attitude {
    let angles = EulerAngles { phi: 0.3, theta: 0.8, zeta: 0.2 };
    Attitude::from_euler(angles).expect("angles")
}

/// The momentum by the tensor I + b (w w^T - Omega^2 e3 e3^T - (w^2 - Omega^2)/3), written out;
/// the damaged one leaves out the traces.
fn by_tensor(body: &RigidBody, b: f64, w: [f64; 3], trace: f64) -> [f64; 3] {
    let moments = body.moments().to_array();
    let square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
    core::array::from_fn(|i| {
        (0..3)
            .map(|j| {
                let same = f64::from(u8::from(i == j));
                let pole = f64::from(u8::from(i == 2 && j == 2)) * RATE * RATE;
                let follows = w[i] * w[j] - pole - trace * same * (square - RATE * RATE) / 3.0;
                (moments[i] * same + b * follows) * w[j]
            })
            .sum()
    })
}

/// The angular velocity of a momentum is the one that has it, from soft bodies to hard ones,
/// at rest, and turned fast.
#[test]
fn the_turning_has_this_momentum() {
    let mut momentum = Errors::of("momentum by the tensor, of it");
    let mut turning = Errors::of("angular velocity found again, of it");
    let mut twin = Errors::of("twin: the tensor without its traces");
    for moments in [[1.0, 1.2, 1.5], [2.0, 2.0, 2.1], [1.0, 1.0, 0.8]] {
        let body = body(moments);
        for b in [0.0, 1e-6, 1e-2, 0.05] {
            let yielding = ElasticYielding::new(b, RATE).expect("a compliance");
            let scene = Scene::new(body).with(yielding);
            for w in [[0.1, -0.2, 2.0], [3.0, 1.0, -2.0], [0.0, 0.0, 40.0], [1e-7, 2e-9, 2.0]] {
                let omega = BodyVector::from_array(w);
                let l = yielding.momentum(&body, omega);
                let other = BodyVector::from_array(by_tensor(&body, b, w, 1.0));
                momentum.push((l - other).norm() / l.norm());
                if b > 1e-3 && w[2] != 2.0 {
                    let wrong = BodyVector::from_array(by_tensor(&body, b, w, 0.0));
                    twin.push((l - wrong).norm() / l.norm());
                }
                let state = yielding.state(&body, tilted(), omega).expect("a state");
                let found = scene.angular_velocity(0.0, &state);
                turning.push((found - omega).norm() / omega.norm());
            }
            let still = yielding.state(&body, tilted(), BodyVector::zero()).expect("rest");
            assert_eq!(scene.angular_velocity(0.0, &still).norm(), 0.0);
        }
    }
    assert_largest!(momentum, 48, @"1.48e-16");
    assert_largest!(turning, 48, @"2.86e-15");
    twin.exceed(1e-2, 12);
}

/// A symmetric body moves as the rigid body with its moments, in closed form.
#[test]
fn a_symmetric_body_moves_as_a_rigid_one() {
    let mut delivered = Errors::of("delivered over requested");
    let mut twin = Errors::of("twin: the body's own moments");
    for (i1, i3, part) in [(1.0, 1.3, 0.2), (1.0, 1.3, 0.9), (2.0, 2.02, 0.32)] {
        let body = body([i1, i1, i3]);
        let yielding = ElasticYielding::following(part, &body, RATE).expect("a part");
        let rates = BodyVector::new(0.5, 0.2, 1.9);
        let start = yielding.state(&body, tilted(), rates).expect("a state");
        let moments = yielding.moments(&body, &start).expect("moments");
        let exact = FreeBody::new(moments, start.attitude, rates).expect("a motion");
        let scene = Scene::new(body).with(yielding);
        let own = body.angular_velocity(&start);
        let rigid = FreeBody::new(body.moments(), start.attitude, own).expect("a motion");
        for tolerance in [1e-4, 1e-7, 1e-10] {
            let end = scene.solve(&start, 20.0, tolerance).expect("solved").state;
            let error = end.attitude.angle_to(&exact.attitude(20.0));
            delivered.push_at(error / tolerance, (i3, part));
            twin.push_at(end.attitude.angle_to(&rigid.attitude(20.0)), (i3, part));
        }
    }
    assert_largest!(delivered, 9, @"2.80e-3");
    twin.exceed(0.03, 9);
}

/// The free period of small wobbles, simulated: (1 + f k)/(f (1 - k)) turns for a part k and
/// the flattening f, of which (1/f)/(1 - k) misses the part f k.
#[test]
fn the_free_period_grows_by_what_follows() {
    let mut errors = Errors::of("period, of it");
    let mut first = Vec::new();
    for part in [0.0, 0.1, 0.32, 0.7] {
        for f in [4e-3, 8e-3, 16e-3] {
            let body = body([1.0, 1.0, 1.0 + f]);
            let yielding = ElasticYielding::following(part, &body, 1.0).expect("a part");
            let scene = Scene::new(body).with(yielding);
            let turning = move |l: &[f64; 3]| {
                let state = State {
                    attitude: Attitude::IDENTITY,
                    angular_momentum: SpaceVector::from_array(*l),
                };
                scene.angular_velocity(0.0, &state)
            };
            let law =
                ode(|_, l: &[f64; 3]| BodyVector::from_array(*l).cross(&turning(l)).to_array());
            let start = yielding.momentum(&body, BodyVector::new(1e-6, 0.0, 1.0)).to_array();
            let law = law.scaled(move |_| [start[0], start[0], 1.0]);
            let method = Dop853::new(1e-13).expect("a method");
            let back = method.zero(&law, start, 2, 1e6, |l| turning(l).y());
            let turns = back.expect("back").0.t / core::f64::consts::TAU;
            errors.add(turns, (1.0 + f * part) / (f * (1.0 - part)), turns);
            if part == 0.32 {
                first.push((log(f), log(1.0 - 1.0 / (f * (1.0 - part) * turns))));
            }
        }
    }
    assert_largest!(errors, 12, @"1.21e-13");
    let slope = |k: usize| (first[k + 1].1 - first[k].1) / (first[k + 1].0 - first[k].0);
    for k in 0..2 {
        assert!((slope(k) - 1.0).abs() < 0.01, "order {}", slope(k));
    }
}

/// The yielding without its strain: the potential is what it is not.
struct Unstrained(ElasticYielding);
impl Effect for Unstrained {
    const PROPERTIES: Properties = ElasticYielding::PROPERTIES;
    fn name(&self) -> &'static str {
        "unstrained"
    }
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state)
    }
    fn slip(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.slip(t, body, state)
    }
    fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
        let omega =
            state.attitude.to_space(body.angular_velocity(state)) + self.slip(t, body, state);
        let motion = 0.5 * (state.angular_momentum.dot(&omega));
        motion - body.kinetic_energy(state)
    }
}

/// Energy, with that of the strain, and L are kept, of a symmetric body L_z too.
#[test]
fn what_is_kept() {
    let (body, yielding, start) = soft();
    let drift = |scene: &dyn Fn(&State) -> f64, states: &[State]| {
        let first = scene(&start);
        let off = |state: &State| (scene(state) / first - 1.0).abs();
        states.iter().map(off).fold(0.0, f64::max)
    };
    let scene = Scene::new(body).with(yielding);
    let times: Vec<f64> = (1..=200).map(|i| 0.25 * f64::from(i)).collect();
    let states = (scene.solve_at(&start, &times, 1e-12, &Limits::default())).expect("solved");
    assert!(states.iter().all(|state| state.angular_momentum == start.angular_momentum));
    let energy = drift(&|state| scene.energy(state), &states);
    assert_error!(energy, 4.0 eps);
    // The motion's energy alone, with the strain's left out, is not kept.
    let twin = Scene::new(body).with(Unstrained(yielding));
    assert!(drift(&|state| twin.energy(state), &states) > 1e-4);

    let kept: Vec<Invariant> = scene.invariants().collect();
    assert_eq!(kept.len(), 4, "{kept:?}");
    let symmetric = Scene::new(self::body([1.0, 1.0, 1.3]));
    let yielding = ElasticYielding::following(0.5, symmetric.body(), RATE).expect("a part");
    let scene = symmetric.with(yielding);
    assert!(scene.invariants().any(|kept| kept == Invariant::AxialMomentum));
    let end = scene.solve(&start, 50.0, 1e-12).expect("solved").state;
    let axial = |state| scene.value(Invariant::AxialMomentum, state);
    assert_error!(axial(&end), axial(&start), 0.0 eps);
}

/// A heavy body that yields keeps its energy; friction takes what the power says.
#[test]
fn a_heavy_body_keeps_its_energy_or_loses_what_its_power_says() {
    let (body, yielding, start) = soft();
    let gravity = GravityAtLever::new(2.0, 0.3).expect("gravity");
    let heavy = Scene::new(body).with(gravity).with(yielding);
    let end = heavy.solve(&start, 20.0, 1e-12).expect("solved").state;
    assert_error!(heavy.energy(&end) / heavy.energy(&start), 1.0, 5.0 eps);
    assert!(heavy.power(3.0, &end).abs() < 1e-9, "{}", heavy.power(3.0, &end));

    let friction = ViscousFriction::isotropic(0.02).expect("friction");
    let loss = InternalDissipation::new(0.01).expect("a loss");
    let scene = heavy.with(friction).with(loss);
    let (t, h) = (3.0, 2e-3);
    let motion = (scene.solve_along(&start, 4.0, 1e-11, &Limits::default())).expect("solved");
    let energy = |t: f64| scene.energy(&motion.try_state(t).expect("a state"));
    let slope = derivative(energy, t, h);
    let state = motion.try_state(t).expect("a state");
    // Without what the torques make of the strain.
    let alone = scene.effects().power(t, &body, &state);
    assert!((alone / slope - 1.0).abs() > 1e-2, "{alone} {slope}");
    assert_error!(scene.power(t, &state), slope, 6.33e-11);
}

#[test]
fn its_claims_hold_and_damaged_ones_do_not() {
    let (body, yielding, start) = soft();
    let span = [0.0, 10.0];
    check(&yielding, &body, span, &start).expect("sound");
    let gravity = GravityAtLever::new(2.0, 0.3).expect("gravity");
    let loss = InternalDissipation::new(0.02).expect("a loss");
    check(&((((), gravity), yielding), loss), &body, span, &start).expect("sound");
    let round = self::body([1.0, 1.0, 1.2]);
    check(&yielding, &round, span, &start).expect("sound");

    let told = "only a torque on the axis";
    refused([
        (check(&Twin(&yielding, NO_SLIP), &body, span, &start), "slips: false"),
        (check(&Twin(&yielding, NOT_ON_RATES), &body, span, &start), "slip does not depend on how"),
        (check(&Twin(&yielding, TORQUE_FREE), &body, span, &start), told),
        (check(&Twin(&yielding, AXIS_ONLY), &body, span, &start), told),
        (check(&Unstrained(yielding), &body, span, &start), "keeps the energy"),
    ]);
}

#[test]
fn what_yields_by_no_such_part_is_refused() {
    let (body, _, start) = soft();
    let thin = self::body([1.0, 1.0, 0.8]);
    refused([
        (ElasticYielding::new(-1.0, 1.0), "compliance = -1"),
        (ElasticYielding::new(f64::NAN, 1.0), "compliance"),
        (ElasticYielding::new(1.0, 0.0), "mean rate = 0"),
        (ElasticYielding::new(1e300, 1e10), "compliance times rate squared"),
        (ElasticYielding::following(0.3, &thin, 1.0), "a part above 0 of a body with I3 above"),
        (ElasticYielding::following(-0.3, &body, 1.0), "a part above 0"),
        (ElasticYielding::from_love_number(-0.3, 1.0, 1.0), "Love number = -0.3"),
        (ElasticYielding::from_love_number(0.3, 0.0, 1.0), "radius = 0"),
    ]);
    // A body that would have no moment left without its rotation.
    let all = ElasticYielding::new(0.6, RATE).expect("a compliance");
    refused([(check(&all, &body, [0.0, 1.0], &start), "I3 = ")]);
    let earth = ElasticYielding::from_love_number(0.3, 6.371e6, 7.292_115e-5).expect("the Earth");
    let size = 5.972e24 * 6.378e6 * 6.378e6;
    let body = self::body([0.329_591 * size, 0.329_591 * size, 0.330_675 * size]);
    // The mean radius for the one at the equator, whose fifth power counts.
    assert_error!(earth.number(&body, &start), 0.319_721, 6.77e-3);
}

/// Methods that carry attitude and L agree.
#[test]
fn every_method_carries_it() {
    let (body, yielding, start) = soft();
    let scene = Scene::new(body).with(yielding);
    let errors = by_four_methods(&scene, &start);
    assert_largest!(errors, 4, @"1.76e-13");
}
