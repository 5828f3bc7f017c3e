//! Energy lost inside a body at constant L.

use super::elastic_yielding::tilted;
use super::twin::{
    AXIS_ONLY, KEEPS_AXIAL, KEEPS_ENERGY, NO_SLIP, NOT_ON_RATES, TORQUE_FREE, Twin, refused,
};
use rotation_dynamics::Error;
use rotation_dynamics::accuracy::{Limits, Resolution, Stepper, Variables};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever, InternalDissipation, Properties, check};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::Method;
use rotation_dynamics::math::{atan2, cos, exp, hypot, tan};
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_error, assert_largest, derivative};

fn loss(coefficient: f64) -> InternalDissipation {
    InternalDissipation::new(coefficient).expect("a coefficient")
}

/// A rod that turns about its length, but for a tenth.
fn rod() -> (RigidBody, State) {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 1.2, 0.3).expect("a body"));
    let start = body.state(tilted(), BodyVector::new(0.05, 0.1, 4.0));
    (body, start.expect("a state"))
}

/// The loss with its sign turned round: it gains.
struct Gain(InternalDissipation);
impl Effect for Gain {
    const PROPERTIES: Properties = InternalDissipation::PROPERTIES;
    fn name(&self) -> &'static str {
        "gain"
    }
    fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        self.0.torque(t, body, state)
    }
    fn slip(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
        -self.0.slip(t, body, state)
    }
}

/// The energies at a hundred times, over L^2/2: 1/I of the axis that it turns about.
fn energies<E: Effect>(scene: &Scene<E>, start: &State, t_end: f64) -> Vec<f64> {
    let motion = (scene.solve_along(start, t_end, 1e-7, &Limits::default())).expect("solved");
    let square = start.angular_momentum.dot(&start.angular_momentum);
    (0..=100)
        .map(|i| {
            let state = motion.try_state(t_end * f64::from(i) / 100.0).expect("a state");
            // Not a bit of L is lost.
            assert_eq!(state.angular_momentum, start.angular_momentum);
            2.0 * scene.energy(&state) / square
        })
        .collect()
}

#[test]
fn a_body_ends_about_its_major_axis() {
    let (body, start) = rod();
    let lost = energies(&Scene::new(body).with(loss(0.02)), &start, 400.0);
    assert!(lost.windows(2).all(|pair| pair[1] < pair[0] * (1.0 + 1e-14)));
    // From near the axis of the least moment, 1/0.3, to that of the largest.
    assert!((lost[0] - 1.0 / 0.3).abs() < 0.03, "{}", lost[0]);
    assert_error!(lost[100], 1.0 / 1.2, 7.1e-13);
    // A gain ends where it began, about the minor axis.
    let gained = energies(&Scene::new(body).with(Gain(loss(0.02))), &start, 400.0);
    assert!(gained.windows(2).all(|pair| pair[1] > pair[0] * (1.0 - 1e-14)));
    assert!((gained[100] * 0.3 - 1.0).abs() < 1e-6, "{}", gained[100]);
}

/// The angle between e3 and L (rad).
fn nutation(body: &RigidBody, state: &State) -> f64 {
    let [x, y, z] = body.angular_momentum(state).to_array();
    atan2(hypot(x, y), z)
}

/// tan(theta) of a symmetric body falls, or rises, exponentially; and the same time comes
/// from the energy that must go at the power a |L x omega|^2.
#[test]
fn a_symmetric_body_relaxes_exponentially() {
    let mut law = Errors::of("tan(theta) against the exponential");
    let mut power = Errors::of("time against the quadrature of the energy");
    let mut turned_round = Errors::of("with the rate's sign turned round");
    for (i1, i3) in [(1.0, 1.8), (1.0, 0.4), (2.0, 2.2)] {
        let body = RigidBody::new(PrincipalMoments::symmetric(i1, i3).expect("a body"));
        let start = body.state(Attitude::IDENTITY, BodyVector::new(0.5, 0.2, 1.5));
        let start = start.expect("a state");
        let dissipation = loss(0.03);
        let rate = dissipation.rate(&body, &start);
        let t = 0.8 / rate.abs();
        let scene = Scene::new(body).with(dissipation);
        let end = scene.solve(&start, t, 1e-10).expect("solved").state;
        let (from, to) = (nutation(&body, &start), nutation(&body, &end));
        law.add(tan(to), tan(from) * exp(-rate * t), tan(to));
        turned_round.add(tan(to), tan(from) * exp(rate * t), tan(to));
        // By Simpson's rule in cos(theta): dE/dt = -a L^4 (1/I3 - 1/I1)^2 sin^2 cos^2.
        let square = start.angular_momentum.dot(&start.angular_momentum);
        let gap = 1.0 / i3 - 1.0 / i1;
        let [u, v] = [from, to].map(cos);
        let slowness = |c: f64| {
            let energy = square * gap * c;
            let power = 0.03 * square * square * gap * gap * (1.0 - c * c) * c * c;
            -energy / power
        };
        let pieces = 2000;
        let h = (v - u) / f64::from(pieces);
        let sum: f64 = (0..=pieces)
            .map(|i| {
                let weight = match i {
                    0 => 1.0,
                    _ if i == pieces => 1.0,
                    _ if i % 2 == 1 => 4.0,
                    _ => 2.0,
                };
                weight * slowness(u + h * f64::from(i))
            })
            .sum();
        power.add(sum * h / 3.0, t, t);
    }
    assert_largest!(law, 3, @"1.22e-14");
    assert_largest!(power, 3, @"2.74e-13");
    turned_round.exceed(0.5, 3);
}

#[test]
fn its_claims_hold_and_damaged_ones_do_not() {
    let (body, start) = rod();
    let span = [0.0, 10.0];
    check(&loss(0.02), &body, span, &start).expect("sound");
    check(&((), loss(0.02)), &body, span, &start).expect("sound");
    let gravity = GravityAtLever::new(2.0, 0.3).expect("gravity");
    check(&(((), gravity), loss(0.02)), &body, span, &start).expect("sound");
    let symmetric = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.3).expect("a body"));
    let sphere = RigidBody::new(PrincipalMoments::symmetric(1.0, 1.0).expect("a body"));
    check(&loss(0.02), &sphere, span, &start).expect("sound, and it does nothing");

    let (dissipation, told) = (loss(0.1), "only a torque on the axis");
    refused([
        (check(&Twin(&dissipation, NO_SLIP), &body, span, &start), "slips: false"),
        (check(&Twin(&dissipation, KEEPS_ENERGY), &body, span, &start), "keeps the energy"),
        // Only of a symmetric body is L_z there to be kept.
        (check(&Twin(&dissipation, KEEPS_AXIAL), &symmetric, span, &start), "leaves L_z alone"),
        (
            check(&Twin(&dissipation, NOT_ON_RATES), &body, span, &start),
            "slip does not depend on how",
        ),
        (check(&Twin(&dissipation, TORQUE_FREE), &body, span, &start), told),
        (check(&Twin(&dissipation, AXIS_ONLY), &body, span, &start), told),
    ]);
    let told = InternalDissipation::new(-1.0).expect_err("negative");
    assert_eq!(told.to_string(), "coefficient = -1 is not allowed: it must be greater than 0");
}

/// What a heavy body loses inside is its power, though it also slips through the potential.
#[test]
fn a_heavy_body_loses_what_its_power_says() {
    let (body, start) = rod();
    let gravity = GravityAtLever::new(2.0, 0.3).expect("gravity");
    let scene = Scene::new(body).with(gravity).with(loss(0.02));
    let (t, h) = (3.0, 2e-3);
    let motion = (scene.solve_along(&start, 4.0, 1e-11, &Limits::default())).expect("solved");
    let energy = |t: f64| scene.energy(&motion.try_state(t).expect("a state"));
    let slope = derivative(energy, t, h);
    let state = motion.try_state(t).expect("a state");
    // Without the way through the potential.
    let alone = scene.effects().power(t, &body, &state);
    assert!((alone / slope - 1.0).abs() > 1e-3, "{alone} {slope}");
    assert_error!(scene.power(t, &state), slope, 8.78e-12);
}

/// Errors of four methods that carry attitude and L (rad), after 10 s against `solve`.
pub fn by_four_methods<E: Effect>(scene: &Scene<E>, start: &State) -> Errors {
    let reference = scene.solve(start, 10.0, 1e-11).expect("solved").state;
    let mut errors = Errors::of("attitude by four methods");
    for (method, resolution) in [
        (Method::Rk4, Resolution::Steps(20_000)),
        (Method::MuntheKaas4, Resolution::Steps(20_000)),
        (Method::Dop853, Resolution::Tolerance(1e-13)),
        (Method::GaussLegendre16, Resolution::Steps(400)),
    ] {
        let stepper = Stepper::new(method, resolution).expect("a method");
        let (end, _) =
            stepper.advance(scene, Variables::Space, [0.0, 10.0], start).expect("carried");
        errors.push_at(end.attitude.angle_to(&reference.attitude), method);
    }
    errors
}

/// Methods that carry attitude and L agree; those that see less refuse.
#[test]
fn every_method_carries_it_or_refuses() {
    let (body, start) = rod();
    let scene = Scene::new(body).with(loss(0.02));
    let errors = by_four_methods(&scene, &start);
    assert_largest!(errors, 4, @"3.48e-13");
    for method in [Method::EulerOnAngles, Method::SemiImplicitEuler] {
        let stepper = Stepper::new(method, Resolution::Steps(10)).expect("a method");
        let refused = stepper.advance(&scene, Variables::Space, [0.0, 1.0], &start);
        assert!(matches!(refused, Err(Error::Incompatible { .. })), "{refused:?}");
    }
    let gauss = Stepper::new(Method::GaussLegendre16, Resolution::Steps(10)).expect("a method");
    for variables in [Variables::Body, Variables::SpinFree] {
        let refused = gauss.advance(&scene, variables, [0.0, 1.0], &start);
        assert!(matches!(refused, Err(Error::Incompatible { .. })), "{refused:?}");
    }
}
