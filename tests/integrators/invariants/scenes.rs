//! Every scene with every method that carries it: exactly its invariants.

use crate::top::figure_3;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever, Properties};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Dop853, Integrator, Rk4, Scheme, Splitting};
use rotation_dynamics::scene::{Invariant, Scene};
use support::{Errors, attained};

const ALL: [Invariant; 5] = [
    Invariant::Energy,
    Invariant::MomentumX,
    Invariant::MomentumY,
    Invariant::MomentumZ,
    Invariant::AxialMomentum,
];

/// Largest change of a kept quantity, and least change of one not kept, relative to
/// the size of its kind, over 40 stretches of half a time unit.
fn changes<E: Effect>(
    scene: &Scene<E>,
    start: &State,
    method: &dyn Integrator<Scene<E>, State>,
) -> (f64, f64) {
    let kept: Vec<Invariant> = scene.invariants().collect();
    let momentum = start.angular_momentum.norm();
    let energy =
        scene.body().kinetic_energy(start) + scene.effects().torque_scale(0.0, scene.body(), start);
    let mut changes = ALL.map(|quantity| Errors::of(format!("{quantity:?}")));
    let mut state = *start;
    for i in 0..40 {
        let t = 0.5 * f64::from(i);
        (state, _) = method.advance(scene, t, &state, t + 0.5).expect("smooth");
        for (change, quantity) in changes.iter_mut().zip(ALL) {
            let size = if quantity == Invariant::Energy { energy } else { momentum };
            let now = (scene.value(quantity, &state) - scene.value(quantity, start)) / size;
            change.push_at(now, t);
        }
    }
    let [mut keeps, mut loses] = ["what is kept", "what is not"].map(Errors::of);
    for (change, quantity) in changes.iter().zip(ALL) {
        let chosen = if kept.contains(&quantity) { &mut keeps } else { &mut loses };
        chosen.push_at(change.largest(), quantity);
    }
    (keeps.largest(), loses.smallest())
}

#[test]
fn exactly_what_is_kept() {
    let (heavy, start) = figure_3();
    let free = Scene::new(*heavy.body());
    let brick = RigidBody::new(PrincipalMoments::new(1.0, 2.0, 2.5).expect("a brick"));
    let free_brick = Scene::new(brick);
    let heavy_brick = Scene::new(brick).with(GravityAtLever::new(0.2, 1.0).expect("gravity"));
    assert_eq!(free.invariants().count(), 5);
    assert_eq!(heavy.invariants().count(), 3);
    assert_eq!(free_brick.invariants().count(), 4);
    assert_eq!(heavy_brick.invariants().count(), 2);

    let dop853 = Dop853::new(1e-15).expect("valid");
    let rk4 = Rk4::new(200).expect("valid");
    let strang = Splitting::new(Scheme::STRANG, 200).expect("valid");
    let fourth = Splitting::new(Scheme::SRKN6, 20).expect("valid");
    let sixth = Splitting::new(Scheme::SRKN14, 10).expect("valid");
    // Over 20 time units, round-off but for the energy of the splittings, which swings
    // with the step, and RK4.
    let rows = [
        ("free, DOP853", changes(&free, &start, &dop853), "8.4e-16"),
        ("free, RK4", changes(&free, &start, &rk4), "2.1e-14"),
        ("free, Strang", changes(&free, &start, &strang), "4.2e-16"),
        ("heavy, DOP853", changes(&heavy, &start, &dop853), "8.8e-16"),
        ("heavy, RK4", changes(&heavy, &start, &rk4), "2.1e-14"),
        ("heavy, Strang", changes(&heavy, &start, &strang), "4.2e-8"),
        ("heavy, SRKN 6b", changes(&heavy, &start, &fourth), "3.1e-13"),
        ("heavy, SRKN 14a", changes(&heavy, &start, &sixth), "5.3e-16"),
        ("brick, DOP853", changes(&free_brick, &start, &dop853), "4.9e-16"),
        ("brick, RK4", changes(&free_brick, &start, &rk4), "3.8e-14"),
        ("heavy brick, DOP853", changes(&heavy_brick, &start, &dop853), "2.5e-16"),
        ("heavy brick, RK4", changes(&heavy_brick, &start, &rk4), "1.2e-14"),
    ];
    let mut ran = 0;
    for (name, (kept, other), printed) in rows {
        attained(kept, printed, name);
        // What is not claimed is not kept either: measured 0.17 at least (a free
        // symmetric body keeps all five).
        assert!(other > 0.1, "{name}: {other:e}");
        ran += 1;
    }
    assert_eq!(ran, 12);
}

#[test]
fn a_wrong_kick_is_seen() {
    // The centre of mass a little off the axis: gravity then turns the body about
    // e3 as well, and L_z is kept no longer.
    struct OffAxis(GravityAtLever);
    impl Effect for OffAxis {
        const PROPERTIES: Properties = GravityAtLever::PROPERTIES;
        fn name(&self) -> &'static str {
            "off axis"
        }
        fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
            let centre = state.attitude.to_space(BodyVector::new(1e-6, 0.0, 0.0));
            let aside = SpaceVector::new(-0.2 * centre.y(), 0.2 * centre.x(), 0.0);
            self.0.torque(t, body, state) + aside
        }
        fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
            self.0.potential_energy(t, body, state)
        }
        fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
            self.0.torque_scale(t, body, state)
        }
    }
    let (heavy, start) = figure_3();
    let wrong = Scene::new(*heavy.body()).with(OffAxis(heavy.effects().1));
    let method = Dop853::new(1e-15).expect("valid");
    let (kept, _) = changes(&wrong, &start, &method);
    // Measured: 1.8e-7, against 8.8e-16.
    assert!(kept > 1e-8, "{kept:e}");
}
