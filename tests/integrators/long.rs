//! What is kept through very many steps: a share of it here, the whole by hand
//! (`benches/record/long.txt`).

use rotation_dynamics::accuracy::{Resolution, Stepper};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::Method;
use rotation_dynamics::scene::Scene;
use support::EPS;

/// A scene, its start, and its steps (s).
struct Long<E> {
    scene: Scene<E>,
    start: State,
    step: f64,
    /// Along which the momentum is looked at, if there is a torque.
    vertical: SpaceVector,
}

fn body() -> RigidBody {
    RigidBody::new(PrincipalMoments::new(1.0, 1.3, 1.7).unwrap())
}

/// A free body; half a second turns it by half a radian.
fn free() -> Long<()> {
    let rates = BodyVector::new(0.3, 0.2, 1.0);
    let start = body().state(Attitude::IDENTITY, rates).unwrap();
    Long { scene: Scene::new(body()), start, step: 0.5, vertical: SpaceVector::zero() }
}

/// The same under gravity, which pulls on its third axis: nothing solves that in closed form.
fn heavy(step: f64) -> Long<((), GravityAtLever)> {
    let tilted = EulerAngles { phi: 0.3, theta: 0.8, zeta: 0.2 };
    let tilted = Attitude::from_euler(tilted).unwrap();
    let rates = BodyVector::new(0.3, 0.2, 1.0);
    Long {
        scene: Scene::new(body()).with(GravityAtLever::new(1.0, 0.4).unwrap()),
        start: body().state(tilted, rates).unwrap(),
        step,
        vertical: SpaceVector::new(0.0, 0.0, 1.0),
    }
}

/// How far norm of the quaternion, L_Z (L, where nothing acts) and energy are off: each
/// relative, of a free body to what it is, of a heavy one to |L| and to the swing of the
/// potential.
type Off = [f64; 3];

impl<E: Effect> Long<E> {
    fn after(&self, method: Method, steps: u64) -> Off {
        let stepper = Stepper::new(method, Resolution::Steps(steps)).unwrap();
        let span = [0.0, self.step * steps as f64];
        let (end, _) = stepper.advance_as_usual(&self.scene, span, &self.start).unwrap();
        let norm: f64 = end.attitude.quaternion().iter().map(|c| c * c).sum();
        let size = self.start.angular_momentum.norm();
        let gained = end.angular_momentum - self.start.angular_momentum;
        let gained =
            if E::PROPERTIES.torque_free { gained.norm() } else { gained.dot(&self.vertical) };
        let energy = |state| self.scene.energy(state);
        let lifted = if E::PROPERTIES.torque_free { energy(&self.start) } else { 0.8 };
        [norm - 1.0, gained / size, (energy(&end) - energy(&self.start)) / lifted]
    }

    /// The norm to a rounding, L exactly (nothing turns it) or L_Z to a rounding for each step,
    /// and the energy within this bound.
    fn kept(&self, method: Method, steps: u64, bound: f64) -> Off {
        let off @ [norm, momentum, energy] = self.after(method, steps);
        let name = method.name();
        println!("{name}, {steps} steps: norm {norm:e}, momentum {momentum:e}, energy {energy:e}");
        assert!(norm.abs() <= 4.0 * EPS, "{name}: {norm:e}");
        let turned = if E::PROPERTIES.torque_free { 0.0 } else { roundings(steps) };
        assert!(momentum.abs() <= turned, "{name}: {momentum:e}");
        assert!(energy.abs() <= bound, "{name}: {energy:e}");
        off
    }

    /// The energy of a splitting swings and does not drift: by how much, in the first 200
    /// steps.
    fn swing(&self, method: Method) -> f64 {
        let energies = (1..=200).map(|steps| self.after(method, steps)[2].abs());
        energies.fold(0.0, f64::max)
    }
}

/// A rounding of the energy for each step.
fn roundings(steps: u64) -> f64 {
    EPS * steps as f64
}

/// Twice what it swings by in the beginning, and a rounding for each step.
fn swings(method: Method, steps: u64) -> f64 {
    2.0 * heavy(SPLIT).swing(method) + roundings(steps)
}

/// Steps (s) of Gauss-Legendre and of splittings for the heavy body.
const STEP: f64 = 0.25;
const SPLIT: f64 = 0.05;

/// All of it, in so many steps of each method.
fn all_kept(steps: u64) {
    free().kept(Method::GaussLegendre16, steps, roundings(steps));
    heavy(STEP).kept(Method::GaussLegendre16, steps, roundings(steps));
    for method in [Method::Strang, Method::Srkn14] {
        heavy(SPLIT).kept(method, steps, swings(method, steps));
    }
}

#[test]
fn a_hundred_thousand_steps() {
    let steps = 100_000;
    all_kept(steps);
    // The damaged twins: RK4 in the same steps; beside the splitting of order 2 in those that
    // cost as many torques a second.
    for ([.., energy], bound) in [
        (free().after(Method::Rk4, steps), roundings(steps)),
        (heavy(STEP).after(Method::Rk4, steps), roundings(steps)),
        (heavy(SPLIT).after(Method::Rk4, steps), swings(Method::Srkn14, steps)),
        (heavy(4.0 * SPLIT).after(Method::Rk4, steps), swings(Method::Strang, steps)),
    ] {
        println!("another method, {steps} steps: energy {energy:e} of {bound:e}");
        assert!(energy.abs() > 10.0 * bound, "{energy:e} of {bound:e}");
    }
    // A vertical that is a millionth off.
    let askew = Long { vertical: SpaceVector::new(1e-6, 0.0, 1.0), ..heavy(STEP) };
    let [_, momentum, _] = askew.after(Method::GaussLegendre16, steps);
    assert!(momentum.abs() > 10.0 * roundings(steps), "{momentum:e}");
}

/// `cargo test --package checks --test integrators -- --ignored ten_million --nocapture`.
#[test]
#[ignore = "ten million steps"]
fn ten_million_steps() {
    all_kept(10_000_000);
}

/// The same with `a_billion`: the free body, and below the cheapest splitting.
#[test]
#[ignore = "a billion steps: eleven minutes"]
fn a_billion_steps() {
    let steps = 1_000_000_000;
    free().kept(Method::GaussLegendre16, steps, roundings(steps));
}

/// By the splitting of order 2.
#[test]
#[ignore = "a billion steps: six minutes"]
fn a_billion_heavy_steps() {
    let steps = 1_000_000_000;
    heavy(SPLIT).kept(Method::Strang, steps, swings(Method::Strang, steps));
}
