//! The Gauss-Legendre method of order 16: coefficients by algebra, order by slope,
//! accuracy against closed forms, invariants over long runs, refusals, same bits.

#[path = "convergence/slope.rs"]
mod slope;
#[path = "convergence/top.rs"]
mod top;

use rotation_dynamics::Error;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::coefficients::{
    CONTINUATION, NODES, STAGES, STAGES_REST, WEIGHTS, WEIGHTS_REST,
};
use rotation_dynamics::integrators::gauss_legendre::{FreeRotation, LaneByLane, Lanes};
use rotation_dynamics::integrators::{
    Dop853, GaussLegendre, Integrator, Ode, Rk4, Scheme, SpinFree, Splitting, StageOde, Work,
};
use rotation_dynamics::math::{DoubleDouble, sin};
use rotation_dynamics::scene::Scene;

/// x^n.
fn power(x: f64, n: usize) -> f64 {
    (0..n).fold(1.0, |p, _| p * x)
}

/// What is wrong with weights as a quadrature on [0, 1], up to this degree.
fn quadrature_defect(weights: &Lanes, degrees: core::ops::RangeInclusive<usize>) -> f64 {
    degrees
        .map(|n| {
            let sum: f64 = (0..8).map(|j| weights[j] * power(NODES[j], n)).sum();
            (sum - 1.0 / (n + 1) as f64).abs()
        })
        .fold(0.0, f64::max)
}

/// What is wrong with the stages: collocation up to degree 7.
fn stage_defect(stages: &[Lanes; 8]) -> f64 {
    let mut worst: f64 = 0.0;
    for i in 0..8 {
        for n in 0..8 {
            let sum: f64 = (0..8).map(|j| stages[j][i] * power(NODES[j], n)).sum();
            worst = worst.max((sum - power(NODES[i], n + 1) / (n + 1) as f64).abs());
        }
    }
    worst
}

/// What keeps quadratic invariants: b_i a_ij + b_j a_ji = b_i b_j.
fn symplectic_defect(stages: &[Lanes; 8]) -> f64 {
    let mut worst: f64 = 0.0;
    for i in 0..8 {
        for j in 0..8 {
            let (a, b) = (WEIGHTS[i] * stages[j][i], WEIGHTS[j] * stages[i][j]);
            worst = worst.max((a + b - WEIGHTS[i] * WEIGHTS[j]).abs());
        }
    }
    worst
}

#[test]
fn the_quadrature_is_exact_to_degree_15() {
    let exact = quadrature_defect(&WEIGHTS, 0..=15);
    // Measured: 5.6e-17.
    assert!(exact <= 5.6e-17, "{exact:e}");
    // Degree 16 is not. Measured: 3.55e-10.
    let beyond = quadrature_defect(&WEIGHTS, 16..=16);
    assert!(beyond > 3.5e-10 && beyond < 3.6e-10, "{beyond:e}");
    let mut damaged = 0;
    let mut least = f64::INFINITY;
    for j in 0..8 {
        let mut weights = WEIGHTS;
        weights[j] += 1e-12;
        least = least.min(quadrature_defect(&weights, 0..=15));
        damaged += 1;
    }
    assert_eq!(damaged, 8);
    // Measured: 1.0e-12.
    assert!(least > 9e-13, "{least:e}");
}

#[test]
fn the_stages_collocate_and_are_symplectic_and_symmetric() {
    let (collocation, symplectic) = (stage_defect(&STAGES), symplectic_defect(&STAGES));
    // Measured: 1.2e-16 and 6.9e-18.
    assert!(collocation <= 1.2e-16, "{collocation:e}");
    assert!(symplectic <= 7e-18, "{symplectic:e}");
    let mut symmetric: f64 = 0.0;
    for i in 0..8 {
        symmetric = symmetric
            .max((NODES[i] + NODES[7 - i] - 1.0).abs())
            .max((WEIGHTS[i] - WEIGHTS[7 - i]).abs());
        for j in 0..8 {
            symmetric = symmetric.max((STAGES[j][i] + STAGES[7 - j][7 - i] - WEIGHTS[j]).abs());
        }
    }
    // Measured: 2.8e-17.
    assert!(symmetric <= 2.8e-17, "{symmetric:e}");
    let mut damaged = 0;
    let mut least = f64::INFINITY;
    for i in 0..8 {
        for j in 0..8 {
            let mut stages = STAGES;
            stages[j][i] += 1e-12;
            least = least
                .min(stage_defect(&stages))
                .min(1e2 * symplectic_defect(&stages));
            damaged += 1;
        }
    }
    assert_eq!(damaged, 64);
    // Measured: 1.0e-12.
    assert!(least > 9e-13, "{least:e}");
}

/// The rounding of the coefficients, left out, would let quadratic invariants drift:
/// b_i a_ij + b_j a_ji = b_i b_j in double-double.
#[test]
fn the_rests_make_it_symplectic_to_22_digits() {
    let defect = |with_rest: f64| {
        let sum = |a: f64, rest: f64| DoubleDouble::from(a) + DoubleDouble::from(with_rest * rest);
        let weight = |i: usize| sum(WEIGHTS[i], WEIGHTS_REST[i]);
        let stage = |i: usize, j: usize| sum(STAGES[j][i], STAGES_REST[j][i]);
        let mut worst: f64 = 0.0;
        for i in 0..8 {
            for j in 0..8 {
                let off = weight(i) * stage(i, j) + weight(j) * stage(j, i) - weight(i) * weight(j);
                worst = worst.max(off.to_f64().abs());
            }
        }
        worst
    };
    let (with, without) = (defect(1.0), defect(0.0));
    // Measured: 8.8e-23, and 3.9e-18 without the rests.
    assert!(with <= 8.9e-23, "{with:e}");
    assert!(without > 1e-18, "{without:e}");
}

#[test]
fn the_continuation_is_the_polynomial_through_the_stages() {
    // The polynomial x^n through this step's nodes, at the next step's.
    let mut worst: f64 = 0.0;
    for n in 0..8 {
        for i in 0..8 {
            let sum: f64 = (0..8)
                .map(|j| CONTINUATION[j][i] * power(NODES[j], n))
                .sum();
            worst = worst.max((sum / power(1.0 + NODES[i], n) - 1.0).abs());
        }
    }
    // Only where the sweeps begin; the sum cancels terms up to 3.6e4.
    // Measured: 2.7e-12.
    assert!(worst <= 2.8e-12, "{worst:e}");
}

/// A pendulum of unit frequency.
#[derive(Debug, Clone, Copy)]
struct Pendulum;

impl Ode<2> for Pendulum {
    fn derivative(&self, _t: f64, &[angle, rate]: &[f64; 2]) -> [f64; 2] {
        [rate, -sin(angle)]
    }
}

fn tumbling() -> (Scene<()>, State, FreeBody) {
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0).expect("a body");
    let rates = BodyVector::new(0.8, 0.4, 0.3375);
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene
        .body()
        .state(Attitude::IDENTITY, rates)
        .expect("finite");
    let exact = FreeBody::new(moments, rates, Attitude::IDENTITY).expect("a motion");
    (scene, start, exact)
}

fn gauss(steps: u64) -> GaussLegendre {
    GaussLegendre::new(steps).expect("some steps")
}

fn notes_top() -> HeavyTop {
    let top = ReducedTop::new(2.0, 1.2, 0.2).expect("the notes' top");
    HeavyTop::from_angles(top, top::THETA_3, 0.0, 0.0, 0.0).expect("a motion")
}

#[test]
fn slope_on_the_free_body_and_the_top() {
    let (scene, start, exact) = tumbling();
    let free = FreeRotation::new(&scene);
    let t_end = 100.0;
    let want = exact.attitude_at(t_end);
    let points: Vec<(f64, f64)> = [44, 48, 52, 56, 60, 64]
        .into_iter()
        .map(|n| {
            let (end, _) = gauss(n).advance(&free, 0.0, &start, t_end).expect("smooth");
            (t_end / n as f64, end.attitude.angle_to(&want))
        })
        .collect();
    let (slope, off) = slope::fitted(&points);
    // Measured: 15.84 over errors from 2.4e-11 to 6.3e-14.
    assert!((slope - 16.0).abs() < 0.3 && off < 0.04, "{slope} {off}");

    let (scene, start) = top::figure_3();
    let problem = SpinFree::new(&scene).expect("symmetric");
    let want = notes_top().attitude(t_end);
    let points: Vec<(f64, f64)> = [56, 60, 64, 68, 72, 76]
        .into_iter()
        .map(|n| {
            let (end, _) = gauss(n)
                .advance(&problem, 0.0, &start, t_end)
                .expect("smooth");
            (t_end / n as f64, end.attitude.angle_to(&want))
        })
        .collect();
    let (slope, off) = slope::fitted(&points);
    // Measured: 15.82 over errors from 3.9e-10 to 3.1e-12.
    assert!((slope - 16.0).abs() < 0.3 && off < 0.04, "{slope} {off}");
}

/// Error against the closed form and sweeps (of eight derivatives) for it: a
/// thousand periods of a tumbling body, 2000 time units of the notes' top.
#[test]
fn what_a_digit_costs() {
    let (scene, start, exact) = tumbling();
    let free = FreeRotation::new(&scene);
    let t_end = 1000.0 * exact.rate_period();
    let want = exact.attitude_at(t_end);
    let method = |steps, precision| GaussLegendre::with_precision(steps, precision).expect("valid");
    let tumble = |steps, precision| {
        let (end, work) = method(steps, precision)
            .advance(&free, 0.0, &start, t_end)
            .expect("smooth");
        (end.attitude.angle_to(&want), work.derivatives / 8)
    };
    let (scene, start_of_top) = top::figure_3();
    let problem = SpinFree::new(&scene).expect("symmetric");
    let axis = notes_top().attitude(2000.0);
    let precess = |steps, precision| {
        let (end, work) = method(steps, precision)
            .advance(&problem, 0.0, &start_of_top, 2000.0)
            .expect("smooth");
        (end.attitude.angle_to(&axis), work.derivatives / 8)
    };
    let rows = [
        (tumble(6000, 0.0), 1.11e-8, 103_433),
        (tumble(7000, 0.0), 9.7e-10, 110_655),
        (tumble(8000, 1e-12), 5.11e-8, 90_795),
        (tumble(8000, 0.0), 1.3e-10, 118_736),
        (tumble(10_000, 0.0), 7.4e-13, 131_195),
        (precess(1000, 0.0), 5.3e-8, 22_536),
        (precess(1500, 0.0), 1.1e-10, 24_334),
        (precess(1500, 1e-12), 2.7e-9, 18_004),
        (precess(2000, 0.0), 1.5e-12, 26_919),
    ];
    let mut ran = 0;
    for ((error, sweeps), bound, price) in rows {
        assert!(error <= bound && error > 0.9 * bound, "{error:e} {bound:e}");
        assert_eq!(sweeps, price);
        ran += 1;
    }
    assert_eq!(ran, 9);
    // The others at about the same error. Measured: 6.3e-10 for 1705406 derivatives,
    // one after the other, where 7000 steps above took 110655 sweeps.
    let (y, work) = Dop853::new(1e-15)
        .and_then(|m| m.advance(&free, 0.0, &free.components(&start), t_end))
        .expect("smooth");
    let end = Attitude::from_quaternion([y[0], y[1], y[2], y[3]]).expect("a rotation");
    let error = end.angle_to(&want);
    assert!(error <= 6.4e-10 && error > 6.2e-10, "{error:e}");
    assert_eq!(work.derivatives, 1_705_406);
    // Measured: 1.92e-11 for 224000 kicks.
    let (end, work) = Splitting::new(Scheme::SRKN14, 16_000)
        .and_then(|m| m.advance(&scene, 0.0, &start_of_top, 2000.0))
        .expect("smooth");
    let error = end.attitude.angle_to(&axis);
    assert!(error <= 2e-11 && error > 1.8e-11, "{error:e}");
    assert_eq!(work.kicks, 224_000);
    // A moment of inertia off by 1e-12 is seen: measured 1.3e-8.
    let off = PrincipalMoments::new(1.0 + 1e-12, 2.0, 8.0 / 3.0).expect("a body");
    let damaged = FreeRotation::new(&Scene::new(RigidBody::new(off)));
    let (end, _) = gauss(10_000)
        .advance(&damaged, 0.0, &start, t_end)
        .expect("smooth");
    let error = end.attitude.angle_to(&want);
    assert!(error > 1.2e-8, "{error:e}");
}

/// 1e5 steps: energy and |L| on the body's axes, L_Z of the top.
#[test]
fn invariants_over_a_hundred_thousand_steps() {
    let (scene, start, exact) = tumbling();
    let free = FreeRotation::new(&scene);
    let off = |y: &[f64; 7]| {
        let [i1, i2, i3] = scene.body().moments().to_array();
        let [w, x, yy, z, a, b, c] = *y;
        let energy = 0.5 * (a * a / i1 + b * b / i2 + c * c / i3);
        let momentum = (a * a + b * b + c * c).sqrt();
        [
            (energy / exact.kinetic_energy() - 1.0).abs(),
            (momentum / exact.angular_momentum().norm() - 1.0).abs(),
            (w * w + x * x + yy * yy + z * z - 1.0).abs(),
        ]
    };
    let mut y = free.components(&start);
    let mut worst = [0.0_f64; 3];
    let mut blocks = 0;
    for block in 0..100 {
        let t = f64::from(block) * 1500.0;
        (y, _) = gauss(1000)
            .advance(&free, t, &y, t + 1500.0)
            .expect("smooth");
        worst = core::array::from_fn(|i| worst[i].max(off(&y)[i]));
        blocks += 1;
    }
    assert_eq!(blocks, 100);
    // Measured: 3.5e-14, 2.0e-14, 1.6e-14: 300 eps after 1e5 steps.
    for (worst, bound) in worst.into_iter().zip([3.6e-14, 2.0e-14, 1.6e-14]) {
        assert!(worst <= bound, "{worst:e}");
    }
    // The twin: RK4 with as many steps has lost 0.549 of the energy.
    let (z, _) = Rk4::new(100_000)
        .and_then(|m| m.advance(&free, 0.0, &free.components(&start), 150_000.0))
        .expect("finite");
    assert!(off(&z)[0] > 0.54);

    let (scene, start) = top::figure_3();
    let problem = SpinFree::new(&scene).expect("symmetric");
    let (mut state, mut worst) = (start, [0.0_f64; 2]);
    for block in 0..100 {
        let t = f64::from(block) * 1000.0;
        (state, _) = gauss(1000)
            .advance(&problem, t, &state, t + 1000.0)
            .expect("smooth");
        let energy = scene.energy(&state) / scene.energy(&start) - 1.0;
        let vertical = state.angular_momentum.z() / start.angular_momentum.z() - 1.0;
        worst = [worst[0].max(energy.abs()), worst[1].max(vertical.abs())];
    }
    // Measured: 1.75e-14, and L_Z exactly.
    assert!(worst[0] <= 1.8e-14 && worst[1] == 0.0, "{worst:?}");
}

#[test]
fn too_long_steps_are_refused() {
    let (scene, start, _) = tumbling();
    let free = FreeRotation::new(&scene);
    let result = gauss(2).advance(&free, 0.0, &start, 30.0);
    assert!(
        matches!(result, Err(Error::NoConvergence { t: 0.0, h: 15.0, change }) if change.is_finite())
    );
    // Three steps in a period diverge, four do not.
    let (_, _, exact) = tumbling();
    let period = exact.rate_period();
    let result = gauss(30).advance(&free, 0.0, &start, 10.0 * period);
    assert!(
        matches!(result, Err(Error::NoConvergence { .. })),
        "{result:?}"
    );
    assert!(gauss(40).advance(&free, 0.0, &start, 10.0 * period).is_ok());
    assert!(matches!(
        GaussLegendre::new(0),
        Err(Error::OutOfRange { name: "steps", .. })
    ));
    let mut ran = 0;
    for precision in [-1e-9, 0.2, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            GaussLegendre::with_precision(1, precision),
            Err(Error::OutOfRange {
                name: "precision",
                ..
            })
        ));
        ran += 1;
    }
    assert_eq!(ran, 4);
    /// Not finite at once, or when the state passes 1.
    struct Broken(f64);
    impl Ode<1> for Broken {
        fn derivative(&self, _t: f64, [y]: &[f64; 1]) -> [f64; 1] {
            [(self.0 - y).sqrt()]
        }
    }
    let zero = [0.0];
    assert!(matches!(
        gauss(3).advance(&LaneByLane(Broken(-1.0)), 0.0, &zero, 1.0),
        Err(Error::DerivativeNotFinite { .. })
    ));
    let result = gauss(3).advance(&LaneByLane(Broken(1.0)), 0.0, &zero, 3.0);
    assert!(
        matches!(result, Err(Error::NoConvergence { change, .. }) if change.is_finite()),
        "{result:?}"
    );
    // A body at rest stays at rest.
    let rest = State {
        angular_momentum: SpaceVector::zero(),
        ..start
    };
    let (end, _) = gauss(5).advance(&scene, 0.0, &rest, 100.0).expect("rest");
    assert_eq!(top::distance(&end, &rest), 0.0);
    let (end, work) = gauss(5).advance(&free, 1.0, &rest, 1.0).expect("no time");
    assert_eq!((end, work), (rest, Work::default()));
}

/// The lanes of a register, lane after lane, narrow or wide: the same bits.
#[test]
fn the_same_bits_on_every_route() {
    let (scene, start, _) = tumbling();
    let free = FreeRotation::new(&scene);
    let y = free.components(&start);
    let method = gauss(500);
    let wide = method.advance(&free, 0.0, &y, 700.0).expect("smooth");
    let narrow = method.in_narrow_registers();
    assert_eq!(wide, narrow.advance(&free, 0.0, &y, 700.0).expect("smooth"));
    assert_eq!(
        wide,
        method
            .advance(&LaneByLane(free), 0.0, &y, 700.0)
            .expect("smooth")
    );
    // And of the derivatives themselves.
    let lanes: [Lanes; 7] =
        core::array::from_fn(|i| core::array::from_fn(|j| sin((8 * i + j) as f64)));
    let all = free.derivatives(&[0.0; 8], &lanes);
    for j in 0..8 {
        assert_eq!(
            all.map(|c| c[j]),
            free.derivative(0.0, &lanes.map(|c| c[j]))
        );
    }
    let (scene, start) = top::figure_3();
    let wide = method.advance(&scene, 0.0, &start, 700.0).expect("smooth");
    assert_eq!(
        wide,
        narrow.advance(&scene, 0.0, &start, 700.0).expect("smooth")
    );
    let problem = SpinFree::new(&scene).expect("symmetric");
    let wide = method
        .advance(&problem, 0.0, &start, 700.0)
        .expect("smooth");
    assert_eq!(
        wide,
        narrow
            .advance(&problem, 0.0, &start, 700.0)
            .expect("smooth")
    );
}

#[test]
fn backwards_and_counted() {
    let start = [1.0, 0.3];
    let problem = LaneByLane(Pendulum);
    let (there, work) = gauss(40)
        .advance(&problem, 0.0, &start, 20.0)
        .expect("smooth");
    let (back, _) = gauss(40)
        .advance(&problem, 20.0, &there, 0.0)
        .expect("smooth");
    let off = (back[0] - start[0]).abs().max((back[1] - start[1]).abs());
    let (other, _) = Dop853::new(1e-15)
        .expect("valid")
        .advance(&Pendulum, 0.0, &start, 20.0)
        .expect("smooth");
    let apart = (there[0] - other[0]).abs().max((there[1] - other[1]).abs());
    assert_eq!(
        (work.steps, work.derivatives % 8, work.rejected),
        (40, 0, 0)
    );
    // Measured: 3.9e-16 and 5.6e-16.
    assert!(off <= 4e-16 && apart <= 6e-16, "{off:e} {apart:e}");
}
