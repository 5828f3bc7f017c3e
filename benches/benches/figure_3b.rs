//! The motion of figure 3(b) (a = 2, b = 1.2, c = 0.2, E~ = 0.55) to t' = 20: one
//! sample of the closed form, its set-up, and every stepping method to 1e-9.
//!
//! A bench is not timed before the error that it claims is shown to be reached.
//! Times on a shared machine wander; read the ratios of one run.

use criterion::{Criterion, criterion_group, criterion_main};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{Kinematics, RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::splitting::Scheme;
use rotation_dynamics::integrators::{Dop853, Integrator, Rk4, Splitting};
use rotation_dynamics::scene::Scene;
use std::hint::black_box;

const END: f64 = 20.0;
const CLAIMED: f64 = 1e-9;

fn closed_form() -> HeavyTop {
    let top = ReducedTop::new(2.0, 1.2, 0.2).expect("the notes' parameters");
    HeavyTop::from_energy(top, 0.55, Start::ThetaMin, 0.0, 0.0).expect("above the minimum")
}

/// The same motion as a scene: I1 = 1, I3 = a, m g l = c, time in units of t'.
fn scene(exact: &HeavyTop) -> (Scene<((), GravityAtLever)>, State) {
    let moments = PrincipalMoments::symmetric(1.0, 2.0).expect("a disc");
    let body = RigidBody::new(moments);
    let Kinematics {
        attitude,
        angular_velocity: omega,
    } = exact.kinematics(0.0);
    let start = body.state(attitude, omega).expect("a state");
    let weight = GravityAtLever::new(0.2, 1.0).expect("a weight");
    (Scene::new(body).with(weight), start)
}

fn figure_3b(c: &mut Criterion) {
    let exact = closed_form();
    let (scene, start) = scene(&exact);
    let want: Attitude = exact.attitude(END);
    let mut group = c.benchmark_group("figure 3(b) to t' = 20");
    group.bench_function("closed form: set-up", |b| {
        b.iter(|| black_box(closed_form()))
    });
    group.bench_function("closed form: one attitude", |b| {
        b.iter(|| exact.attitude(black_box(END)));
    });

    let rk4 = Rk4::new(2500).expect("steps");
    let strang = |scheme, steps| Splitting::new(scheme, steps).expect("steps");
    let (six, fourteen) = (strang(Scheme::SRKN6, 190), strang(Scheme::SRKN14, 48));
    let dop853 = Dop853::new(1e-11).expect("a tolerance");
    let methods: [(&str, &dyn Integrator<_, State>); 4] = [
        ("RK4, 2500 steps", &rk4),
        ("SRKN 6b, 190 steps", &six),
        ("SRKN 14a, 48 steps", &fourteen),
        ("DOP853 at 1e-11", &dop853),
    ];
    for (name, method) in methods {
        let run = || {
            method
                .advance(&scene, 0.0, black_box(&start), END)
                .expect("a run")
                .0
        };
        let error = run().attitude.angle_to(&want);
        assert!(
            error <= CLAIMED,
            "{name} reaches {error:e}, not {CLAIMED:e}"
        );
        group.bench_function(name, |b| b.iter(run));
    }
    group.finish();
}

criterion_group!(benches, figure_3b);
criterion_main!(benches);
