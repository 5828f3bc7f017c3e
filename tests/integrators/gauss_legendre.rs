//! The Gauss-Legendre method of order 16: coefficients by algebra, order by slope,
//! accuracy against closed forms, invariants over long runs, refusals, same bits.

use crate::slope::assert_slope;
use crate::top;
use rotation_dynamics::Error;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, GravityAtLever, Properties};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::gauss_legendre::coefficients::{
    CONTINUATION, NODES, STAGES, STAGES_REST, WEIGHTS, WEIGHTS_REST,
};
use rotation_dynamics::integrators::gauss_legendre::{
    BodyAxes, FreeRotation, LaneByLane, Lanes, Registers,
};
use rotation_dynamics::integrators::{
    Dop853, GaussLegendre, Integrator, Ode, Rk4, Scheme, SpinFree, Splitting, Work, size_or,
};
use rotation_dynamics::math::{DoubleDouble, exp, sin};
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_error, assert_largest, attained};

/// x^n.
fn power(x: f64, n: usize) -> f64 {
    (0..n).fold(1.0, |p, _| p * x)
}

/// What is wrong with weights as a quadrature on [0, 1], up to this degree.
fn quadrature_defect(weights: &Lanes, degrees: core::ops::RangeInclusive<usize>) -> f64 {
    let mut defects = Errors::of("quadrature");
    for n in degrees {
        let sum: f64 = (0..8).map(|j| weights[j] * power(NODES[j], n)).sum();
        defects.push(sum - 1.0 / (n + 1) as f64);
    }
    defects.largest()
}

/// What is wrong with the stages: collocation up to degree 7.
fn stage_defect(stages: &[Lanes; 8]) -> f64 {
    let mut defects = Errors::of("collocation");
    for i in 0..8 {
        for n in 0..8 {
            let sum: f64 = (0..8).map(|j| stages[j][i] * power(NODES[j], n)).sum();
            defects.push(sum - power(NODES[i], n + 1) / (n + 1) as f64);
        }
    }
    defects.largest()
}

/// What keeps quadratic invariants: b_i a_ij + b_j a_ji = b_i b_j.
fn symplectic_defect(stages: &[Lanes; 8]) -> f64 {
    let mut defects = Errors::of("quadratic invariants");
    for i in 0..8 {
        for j in 0..8 {
            let (a, b) = (WEIGHTS[i] * stages[j][i], WEIGHTS[j] * stages[i][j]);
            defects.push(a + b - WEIGHTS[i] * WEIGHTS[j]);
        }
    }
    defects.largest()
}

#[test]
fn the_quadrature_is_exact_to_degree_15() {
    assert_error!(quadrature_defect(&WEIGHTS, 0..=15), 5.6e-17);
    // Degree 16 is not.
    assert_error!(quadrature_defect(&WEIGHTS, 16..=16), 3.55e-10);
    let mut damaged = Errors::of("quadrature, a weight off by 1e-12");
    for j in 0..8 {
        let mut weights = WEIGHTS;
        weights[j] += 1e-12;
        damaged.push(quadrature_defect(&weights, 0..=15));
    }
    // Measured: 1.0e-12.
    damaged.exceed(9e-13, 8);
}

#[test]
fn the_stages_collocate_and_are_symplectic_and_symmetric() {
    assert_error!(stage_defect(&STAGES), 1.1e-16);
    assert_error!(symplectic_defect(&STAGES), 6.9e-18);
    let mut symmetric = Errors::of("symmetry");
    for i in 0..8 {
        symmetric.push(NODES[i] + NODES[7 - i] - 1.0);
        symmetric.push(WEIGHTS[i] - WEIGHTS[7 - i]);
        for j in 0..8 {
            symmetric.push(STAGES[j][i] + STAGES[7 - j][7 - i] - WEIGHTS[j]);
        }
    }
    assert_largest!(symmetric, 8 * 10, @"2.78e-17");
    let [mut collocation, mut invariants] = ["collocation", "quadratic invariants"].map(Errors::of);
    for i in 0..8 {
        for j in 0..8 {
            let mut stages = STAGES;
            stages[j][i] += 1e-12;
            collocation.push(stage_defect(&stages));
            invariants.push(symplectic_defect(&stages));
        }
    }
    // A stage off by 1e-12.
    collocation.exceed(9e-13, 64);
    invariants.exceed(9e-15, 64);
}

/// The rounding of the coefficients, left out, would let quadratic invariants drift:
/// b_i a_ij + b_j a_ji = b_i b_j in double-double.
#[test]
fn the_rests_make_it_symplectic_to_22_digits() {
    let defect = |with_rest: f64| {
        let sum = |a: f64, rest: f64| DoubleDouble::from(a) + DoubleDouble::from(with_rest * rest);
        let weight = |i: usize| sum(WEIGHTS[i], WEIGHTS_REST[i]);
        let stage = |i: usize, j: usize| sum(STAGES[j][i], STAGES_REST[j][i]);
        let mut defects = Errors::of("quadratic invariants");
        for i in 0..8 {
            for j in 0..8 {
                let off = weight(i) * stage(i, j) + weight(j) * stage(j, i) - weight(i) * weight(j);
                defects.push(off.to_f64());
            }
        }
        defects.largest()
    };
    assert_error!(defect(1.0), 8.8e-23);
    // Without the rests.
    assert_error!(defect(0.0), 3.9e-18);
}

#[test]
fn the_continuation_is_the_polynomial_through_the_stages() {
    // The polynomial x^n through this step's nodes, at the next step's.
    let mut errors = Errors::of("continuation");
    for n in 0..8 {
        for i in 0..8 {
            let sum: f64 = (0..8).map(|j| CONTINUATION[j][i] * power(NODES[j], n)).sum();
            errors.push(sum / power(1.0 + NODES[i], n) - 1.0);
        }
    }
    // Only where the sweeps begin; the sum cancels terms up to 3.6e4.
    assert_largest!(errors, 64, @"2.73e-12");
}

/// A pendulum of unit frequency.
#[derive(Debug, Clone, Copy)]
struct Pendulum;

impl Ode<2> for Pendulum {
    fn derivative(&self, _t: f64, &[angle, rate]: &[f64; 2]) -> [f64; 2] {
        [rate, -sin(angle)]
    }

    fn scale(&self, y: &[f64; 2]) -> [f64; 2] {
        size_or([1.0; 2])(y)
    }
}

fn tumbling() -> (Scene<()>, State, FreeBody) {
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0).expect("a body");
    let rates = BodyVector::new(0.8, 0.4, 0.3375);
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(Attitude::IDENTITY, rates).expect("finite");
    let exact = FreeBody::new(moments, Attitude::IDENTITY, rates).expect("a motion");
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
    let want = exact.attitude(t_end);
    let points: Vec<(f64, f64)> = [48, 52, 56, 60, 64]
        .into_iter()
        .map(|n| {
            let (end, _) = gauss(n).advance(&free, 0.0, &start, t_end).expect("smooth");
            (t_end / n as f64, end.attitude.angle_to(&want))
        })
        .collect();
    // Over errors from 3.6e-12 to 4.0e-14.
    assert_slope(&points, "15.54", "0.031");

    let (scene, start) = top::figure_3();
    let problem = SpinFree::new(&scene).expect("symmetric");
    let want = notes_top().attitude(t_end);
    let points: Vec<(f64, f64)> = [68, 72, 76, 80, 84, 88]
        .into_iter()
        .map(|n| {
            let (end, _) = gauss(n).advance(&problem, 0.0, &start, t_end).expect("smooth");
            (t_end / n as f64, end.attitude.angle_to(&want))
        })
        .collect();
    // Over errors from 2.1e-11 to 3.6e-13.
    assert_slope(&points, "15.74", "0.0071");
}

/// Error against the closed form and sweeps (of eight derivatives) for it: a
/// thousand periods of a tumbling body, 2000 time units of the notes' top.
#[test]
fn what_a_digit_costs() {
    let (scene, start, exact) = tumbling();
    let free = FreeRotation::new(&scene);
    let t_end = 1000.0 * exact.rate_period();
    let want = exact.attitude(t_end);
    let method = |steps, precision| GaussLegendre::with_precision(steps, precision).expect("valid");
    let tumble = |steps, precision| {
        let (end, work) =
            method(steps, precision).advance(&free, 0.0, &start, t_end).expect("smooth");
        (end.attitude.angle_to(&want), work.derivatives / 8)
    };
    let (scene, start_of_top) = top::figure_3();
    let problem = SpinFree::new(&scene).expect("symmetric");
    let axis = notes_top().attitude(2000.0);
    let precess = |steps, precision| {
        let (end, work) =
            method(steps, precision).advance(&problem, 0.0, &start_of_top, 2000.0).expect("smooth");
        (end.attitude.angle_to(&axis), work.derivatives / 8)
    };
    let rows = [
        (tumble(6000, 0.0), "6.9e-9", 102_563),
        (tumble(7000, 0.0), "6e-10", 107_293),
        (tumble(8000, 1e-12), "1.13e-7", 86_004),
        (tumble(8000, 0.0), "7.9e-11", 113_012),
        (tumble(10_000, 0.0), "1.29e-11", 127_620),
        (precess(1000, 0.0), "4.2e-8", 23_576),
        (precess(1500, 0.0), "8.0e-11", 26_051),
        (precess(1500, 1e-12), "5e-10", 18_994),
        (precess(2000, 0.0), "1.03e-12", 28_982),
    ];
    let mut ran = 0;
    for ((error, sweeps), printed, price) in rows {
        attained(error, printed, "error at the end");
        assert_eq!(sweeps, price);
        ran += 1;
    }
    assert_eq!(ran, 9);
    // The others at about the same error, for 1705406 derivatives one after the other,
    // where 7000 steps above took 107293 sweeps.
    let (y, work) = Dop853::new(1e-15)
        .and_then(|m| m.advance(&free, 0.0, &free.components(&start), t_end))
        .expect("smooth");
    let end = Attitude::from_quaternion([y[0], y[1], y[2], y[3]]).expect("a rotation");
    assert_error!(end.angle_to(&want), 6.7e-10);
    assert_eq!(work.derivatives, 1_705_406);
    // For 224000 kicks.
    let (end, work) = Splitting::new(Scheme::SRKN14, 16_000)
        .and_then(|m| m.advance(&scene, 0.0, &start_of_top, 2000.0))
        .expect("smooth");
    assert_error!(end.attitude.angle_to(&axis), 1.93e-11);
    assert_eq!(work.kicks, 224_000);
    // A moment of inertia off by 1e-12 is seen.
    let off = PrincipalMoments::new(1.0 + 1e-12, 2.0, 8.0 / 3.0).expect("a body");
    let damaged = FreeRotation::new(&Scene::new(RigidBody::new(off)));
    let (end, _) = gauss(10_000).advance(&damaged, 0.0, &start, t_end).expect("smooth");
    assert_error!(end.attitude.angle_to(&want), 1.3e-8);
}

/// An oscillator whose rate rises fivefold for a while: from one step to the next the sweeps gain
/// much less, and then much more again.
#[derive(Debug, Clone, Copy)]
struct Surge;

impl Ode<2> for Surge {
    fn derivative(&self, t: f64, &[x, y]: &[f64; 2]) -> [f64; 2] {
        let s = t - 20.0;
        let rate = 0.5 + 2.0 * exp(-0.5 * s * s);
        [rate * y, -rate * x]
    }

    fn scale(&self, y: &[f64; 2]) -> [f64; 2] {
        size_or([1.0; 2])(y)
    }
}

/// What sweeps to a precision leave, in units of the precision and the root of the steps: of a
/// top, a tumbling body and an oscillator that is not steady.
#[test]
fn what_sweeps_leave() {
    let (free_scene, start, _) = tumbling();
    let free = FreeRotation::new(&free_scene);
    let (top_scene, start_of_top) = top::figure_3();
    let without_spin = SpinFree::new(&top_scene).expect("symmetric");
    let axes = BodyAxes::new(&top_scene).expect("the axis only");
    let mut largest = ["tumbling", "top", "top on its axes", "surge"].map(Errors::of);
    let mut damaged = Errors::of("by a thirtieth of the precision");
    for steps in [50_u32, 80, 100] {
        let part = |apart: f64, precision: f64| apart / (precision * f64::from(steps).sqrt());
        let run = |precision: f64| {
            let method =
                GaussLegendre::with_precision(u64::from(steps), precision).expect("valid").steady();
            let (tumbled, _) = method.advance(&free, 0.0, &start, 90.0).expect("smooth");
            let (spun, _) =
                method.advance(&without_spin, 0.0, &start_of_top, 60.0).expect("smooth");
            let (on_axes, _) = method.advance(&axes, 0.0, &start_of_top, 60.0).expect("smooth");
            let (surged, _) =
                method.advance(&LaneByLane(Surge), 0.0, &[1.0, 0.0], 40.0).expect("smooth");
            ([tumbled, spun, on_axes].map(|end| end.attitude), surged)
        };
        let (solved, surged) = run(0.0);
        for exponent in 3..=13 {
            let precision = (0..exponent).fold(1.0, |p, _| p / 10.0);
            let (ends, end) = run(precision);
            let apart = [0, 1, 2].map(|n| ends[n].angle_to(&solved[n]));
            let apart_too = (end[0] - surged[0]).abs() + (end[1] - surged[1]).abs();
            for (n, apart) in apart.into_iter().chain([apart_too]).enumerate() {
                largest[n].push_at(part(apart, precision), (steps, exponent));
            }
            damaged.push(part(apart[1], precision / 30.0));
        }
    }
    let [tumbling, top, on_axes, surge] = largest;
    assert_largest!(tumbling, 33, @"1.12");
    assert_largest!(top, 33, @"0.250");
    assert_largest!(on_axes, 33, @"1.68");
    assert_largest!(surge, 33, @"0.118");
    // The top, measured by a thirtieth of what it was asked for.
    assert_error!(damaged.largest(), 7.5);
}

/// 1e5 steps: energy and |L| on the body's axes, L_Z of the top.
#[test]
fn invariants_over_a_hundred_thousand_steps() {
    let (scene, start, exact) = tumbling();
    let free = FreeRotation::new(&scene);
    let axes = BodyAxes::new(&scene).expect("the axis only");
    let off = |y: &[f64; 7]| {
        let [i1, i2, i3] = scene.body().moments().to_array();
        let [w, x, yy, z, a, b, c] = *y;
        let energy = 0.5 * (a * a / i1 + b * b / i2 + c * c / i3);
        let momentum = (a * a + b * b + c * c).sqrt();
        [
            energy / exact.kinetic_energy() - 1.0,
            momentum / exact.angular_momentum().norm() - 1.0,
            w * w + x * x + yy * yy + z * z - 1.0,
        ]
    };
    let mut y = axes.components(&start);
    let mut state = start;
    let mut kept = ["energy", "|L|", "square of the quaternion"].map(Errors::of);
    let mut kinetic = Errors::of("energy, L on the fixed axes");
    for block in 0..100 {
        let t = f64::from(block) * 1500.0;
        (y, _) = gauss(1000).advance(&axes, t, &y, t + 1500.0).expect("smooth");
        for (errors, off) in kept.iter_mut().zip(off(&y)) {
            errors.push(off);
        }
        (state, _) = gauss(1000).advance(&free, t, &state, t + 1500.0).expect("smooth");
        kinetic.push(scene.energy(&state) / scene.energy(&start) - 1.0);
        assert_eq!(state.angular_momentum, start.angular_momentum);
    }
    // After 1e5 steps.
    let [energy, momentum, length] = kept;
    assert_largest!(energy, 100, @"7.22e-15");
    assert_largest!(momentum, 100, @"6.44e-15");
    assert_largest!(length, 100, @"2.55e-14");
    // 22 eps.
    assert_largest!(kinetic, 100, @"2.44e-15");
    // The twin: RK4 with as many steps has lost 0.549 of the energy.
    let (z, _) = Rk4::new(100_000)
        .and_then(|m| m.advance(&free, 0.0, &free.components(&start), 150_000.0))
        .expect("finite");
    assert!(off(&z)[0].abs() > 0.54);

    let (scene, start) = top::figure_3();
    let problem = SpinFree::new(&scene).expect("symmetric");
    let mut state = start;
    let [mut energy, mut vertical] = ["energy", "L_Z"].map(Errors::of);
    for block in 0..100 {
        let t = f64::from(block) * 1000.0;
        (state, _) = gauss(1000).advance(&problem, t, &state, t + 1000.0).expect("smooth");
        energy.push(scene.energy(&state) / scene.energy(&start) - 1.0);
        vertical.push(state.angular_momentum.z() / start.angular_momentum.z() - 1.0);
    }
    assert_largest!(energy, 100, @"6.00e-15");
    assert_largest!(vertical, 100, @"0");
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
    assert!(matches!(result, Err(Error::NoConvergence { .. })), "{result:?}");
    assert!(gauss(40).advance(&free, 0.0, &start, 10.0 * period).is_ok());
    assert!(matches!(GaussLegendre::new(0), Err(Error::OutOfRange { name: "steps", .. })));
    let mut ran = 0;
    for precision in [-1e-9, 0.2, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            GaussLegendre::with_precision(1, precision),
            Err(Error::OutOfRange { name: "precision", .. })
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

        fn scale(&self, y: &[f64; 1]) -> [f64; 1] {
            size_or([1.0; 1])(y)
        }
    }
    let zero = [0.0];
    assert!(matches!(
        gauss(3).advance(&LaneByLane(Broken(-1.0)), 0.0, &zero, 1.0),
        Err(Error::FunctionOutOfRange { what, .. }) if what == "derivative"
    ));
    let result = gauss(3).advance(&LaneByLane(Broken(1.0)), 0.0, &zero, 3.0);
    assert!(
        matches!(result, Err(Error::NoConvergence { change, .. }) if change.is_finite()),
        "{result:?}"
    );
    // A body at rest stays at rest.
    let rest = State { angular_momentum: SpaceVector::zero(), ..start };
    let (end, _) = gauss(5).advance(&scene, 0.0, &rest, 100.0).expect("rest");
    assert_eq!(top::distance(&end, &rest), 0.0);
    let (end, work) = gauss(5).advance(&free, 1.0, &rest, 1.0).expect("no time");
    assert_eq!((end, work), (rest, Work::default()));
}

/// Every kind of registers, and one lane after the other: the same bits.
#[test]
fn the_same_bits_on_every_route() {
    let mut compared = 0;
    macro_rules! same {
        ($problem:expr, $start:expr) => {
            for precision in [0.0, 1e-9] {
                let method = GaussLegendre::with_precision(500, precision).expect("valid").steady();
                let widest = method.advance($problem, 0.0, $start, 700.0).expect("smooth");
                for registers in [Registers::Avx2, Registers::Common] {
                    let other = method
                        .limited_to(registers)
                        .advance($problem, 0.0, $start, 700.0)
                        .expect("smooth");
                    assert_eq!(widest, other);
                    compared += 1;
                }
            }
        };
    }
    let (scene, start, _) = tumbling();
    let free = FreeRotation::new(&scene);
    same!(&free, &start);
    same!(&scene, &start);
    same!(&LaneByLane(free), &free.components(&start));
    let symmetric = RigidBody::new(PrincipalMoments::symmetric(1.0, 1.5).expect("a body"));
    same!(&FreeRotation::new(&Scene::new(symmetric)), &start);
    let (scene, start) = top::figure_3();
    same!(&scene, &start);
    same!(&SpinFree::new(&scene).expect("symmetric"), &start);
    let axes = BodyAxes::new(&scene).expect("the axis only");
    same!(&axes, &start);
    assert_eq!(compared, 28);
    // A form on lanes and one lane after the other.
    let y = axes.components(&start);
    assert_eq!(
        gauss(500).advance(&axes, 0.0, &y, 700.0).expect("smooth"),
        gauss(500).advance(&LaneByLane(axes), 0.0, &y, 700.0).expect("smooth")
    );
}

/// An effect's torque on lanes has the bits of its torque, and so has the default form.
#[test]
fn torques_side_by_side() {
    struct Plain(GravityAtLever);
    impl Effect for Plain {
        const PROPERTIES: Properties = GravityAtLever::PROPERTIES;
        fn name(&self) -> &'static str {
            "plain"
        }
        fn torque(&self, t: f64, body: &RigidBody, state: &State) -> SpaceVector {
            self.0.torque(t, body, state)
        }
        fn potential_energy(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
            self.0.potential_energy(t, body, state)
        }
        fn torque_scale(&self, t: f64, body: &RigidBody, state: &State) -> f64 {
            self.0.torque_scale(t, body, state)
        }
    }
    let gravity = GravityAtLever::new(0.7, 0.3).expect("gravity");
    let pair = (gravity, gravity);
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.5).expect("a body"));
    let mut plain = Errors::of("torques one by one");
    let mut compared = 0;
    for k in 0..50 {
        let axis: [f64; 3] = core::array::from_fn(|i| sin(f64::from(3 * k) + i as f64));
        let length = SpaceVector::from_array(axis).norm();
        let axis = axis.map(|c| c / length);
        // Of the torque one by one, only the attitude made up for it is rounded.
        let apart = |a: [f64; 3], b: [f64; 3]| {
            (SpaceVector::from_array(a) - SpaceVector::from_array(b)).norm()
        };
        let on_lanes = gravity.torques_on_axis(&body, axis);
        plain.push(apart(Plain(gravity).torques_on_axis(&body, axis), on_lanes));
        assert_eq!(pair.torques_on_axis(&body, axis), on_lanes.map(|m| m + m));
        compared += 1;
    }
    assert_eq!(compared, 50);
    assert_largest!(plain, 50, @"8.78e-17");
    // And the whole motion: an effect without a form on lanes.
    let (scene, start) = top::figure_3();
    let plain = Scene::new(*scene.body()).with(Plain(scene.effects().1));
    let problem = SpinFree::new(&scene).expect("symmetric");
    let other = SpinFree::new(&plain).expect("symmetric");
    let (lanes, _) = gauss(200).advance(&problem, 0.0, &start, 200.0).expect("smooth");
    let (one_by_one, _) = gauss(200).advance(&other, 0.0, &start, 200.0).expect("smooth");
    assert_error!(lanes.attitude.angle_to(&one_by_one.attitude), 1e-13);
}

/// Bodies of every kind, their axes in every order: against the closed form.
#[test]
fn every_free_body() {
    let orders = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
    let kinds = [
        [1.0, 2.0, 8.0 / 3.0],
        [1.0, 1.0, 1.5],
        [1.0, 2.0, 2.0],
        [1.0, 1.0 + 1e-9, 1.7],
        [1.0, 1.0, 1.0],
        [0.4, 1.0, 1.0],
        [3e-200, 4e-200, 5e-200],
        [3e200, 4e200, 5e200],
    ];
    let attitude = Attitude::from_quaternion([0.3, -0.5, 0.7, 0.2]).expect("a rotation");
    let mut errors = Errors::of("attitude");
    for kind in kinds {
        let size = kind[2];
        for order in orders {
            let own = order.map(|i| kind[i]);
            let moments = PrincipalMoments::new(own[0], own[1], own[2]).expect("a body");
            let body = RigidBody::new(moments);
            // |L| of order 1 whatever the moments: a turn takes a time of order I.
            let momentum = order.map(|i| [0.8, -0.8, 0.9][i]);
            let momentum = BodyVector::from_array(momentum);
            let start = State::new(attitude, attitude.to_space(momentum)).expect("finite");
            let rates = body.angular_velocity(&start);
            let exact = FreeBody::new(moments, attitude, rates).expect("a motion");
            let free = FreeRotation::new(&Scene::new(body));
            let t = 10.0 * size;
            let (end, _) = gauss(20).advance(&free, 0.0, &start, t).expect("smooth");
            assert_eq!(end.angular_momentum, start.angular_momentum);
            errors.push_at(end.attitude.angle_to(&exact.attitude(t)), own);
        }
    }
    assert_largest!(errors, 48, @"4.58e-15");
}

#[test]
fn backwards_and_counted() {
    let start = [1.0, 0.3];
    let problem = LaneByLane(Pendulum);
    let (there, work) = gauss(40).advance(&problem, 0.0, &start, 20.0).expect("smooth");
    let (back, _) = gauss(40).advance(&problem, 20.0, &there, 0.0).expect("smooth");
    let [mut off, mut apart] = ["there and back", "from DOP853"].map(Errors::of);
    (0..2).for_each(|i| off.push(back[i] - start[i]));
    let (other, _) =
        Dop853::new(1e-15).expect("valid").advance(&Pendulum, 0.0, &start, 20.0).expect("smooth");
    (0..2).for_each(|i| apart.push(there[i] - other[i]));
    assert_eq!((work.steps, work.derivatives % 8, work.rejected), (40, 0, 0));
    assert_largest!(off, 2, @"2.22e-16");
    assert_largest!(apart, 2, @"1.61e-15");
}
