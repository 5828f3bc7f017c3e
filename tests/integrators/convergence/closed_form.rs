//! The integrators against the closed form of the heavy top.

use crate::slope::assert_slope;
use crate::top::{HeavyTop, distance, figure_3};
use rotation_dynamics::body::State;
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::heavy_top::{HeavyTop as ClosedForm, ReducedTop};
use rotation_dynamics::integrators::{Dop853, Integrator, Rk4, Scheme, SpinFree, Splitting};
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_error, assert_largest, attained};

/// The top of fig. 3 in closed form.
pub fn exact() -> ClosedForm {
    let top = ReducedTop::new(2.0, 1.2, 0.2).expect("the notes' top");
    ClosedForm::from_angles(top, crate::top::THETA_3, 0.0, 0.0, 0.0).expect("a motion")
}

/// Its state at t.
pub fn at(t: f64) -> State {
    let exact = exact();
    State::new(exact.attitude(t), exact.angular_momentum(t)).expect("finite")
}

/// Distances from the closed form at 40 times up to `t_end`.
fn errors<P>(problem: &P, method: &dyn Integrator<P, State>, t_end: f64) -> Errors {
    let (_, start) = figure_3();
    let mut errors = Errors::of("distance from the closed form");
    for i in 1..=40 {
        let t = t_end * f64::from(i) / 40.0;
        let (end, _) = method.advance(problem, 0.0, &start, t).expect("smooth");
        errors.push_at(distance(&end, &at(t)), t);
    }
    errors
}

#[test]
fn every_method_agrees() {
    let (scene, _) = figure_3();
    let free = SpinFree::new(&scene).expect("a symmetric body");
    let splitting = |scheme, steps| Splitting::new(scheme, steps).expect("some steps");
    let dop853 = Dop853::new(1e-15).expect("valid");
    let rk4 = Rk4::new(40_000).expect("some steps");
    // Only Strang is above round-off, and the price of RK4 is forty times that of DOP853.
    assert_largest!(errors(&scene, &splitting(Scheme::STRANG, 100_000), 20.0), 40, @"2.51e-9");
    assert_largest!(errors(&scene, &splitting(Scheme::SRKN6, 5_000), 20.0), 40, @"6.77e-15");
    assert_largest!(errors(&scene, &splitting(Scheme::SRKN14, 1_000), 20.0), 40, @"7.52e-15");
    assert_largest!(errors(&scene, &dop853, 20.0), 40, @"6.04e-15");
    assert_largest!(errors(&free, &dop853, 20.0), 40, @"8.24e-15");
    assert_largest!(errors(&scene, &rk4, 20.0), 40, @"1.66e-14");
    assert_largest!(errors(&free, &rk4, 20.0), 40, @"1.52e-14");
    // A lever longer by 1e-12 is seen.
    let (_, start) = figure_3();
    let longer =
        Scene::new(*scene.body()).with(GravityAtLever::new(0.2, 1.0 + 1e-12).expect("gravity"));
    let (end, _) = dop853.advance(&longer, 0.0, &start, 20.0).expect("smooth");
    assert_error!(distance(&end, &at(20.0)), 1.8e-12);
}

#[test]
fn slopes_of_the_general_methods() {
    let (scene, start) = figure_3();
    let exact = at(20.0);
    let free = SpinFree::new(&scene).expect("a symmetric body");
    let points = |advance: &dyn Fn(Rk4) -> State| -> Vec<(f64, f64)> {
        [800, 1200, 1600, 2400, 3200]
            .into_iter()
            .map(|n| {
                let end = advance(Rk4::new(n).expect("some steps"));
                (1.0 / n as f64, distance(&end, &exact))
            })
            .collect()
    };
    let plain = points(&|m| m.advance(&scene, 0.0, &start, 20.0).expect("smooth").0);
    let spin_free = points(&|m| m.advance(&free, 0.0, &start, 20.0).expect("smooth").0);
    // Over errors from 1e-7 to 1e-9.
    assert_slope(&plain, "4.023", "0.0031");
    assert_slope(&spin_free, "3.999", "0.00017");
    // DOP853 with steps of equal length: any error is tolerated, no step is longer.
    let points: Vec<(f64, f64)> = [64u32, 80, 100, 128, 160]
        .into_iter()
        .map(|n| {
            let method = Dop853::new(0.1)
                .and_then(|m| m.with_longest_step(20.0 / f64::from(n)))
                .expect("valid");
            let (end, work) = method.advance(&free, 0.0, &start, 20.0).expect("smooth");
            assert_eq!((work.steps, work.rejected), (u64::from(n), 0));
            (20.0 / f64::from(n), distance(&end, &exact))
        })
        .collect();
    // Over errors from 5e-10 to 3e-13. (With the spin it is 9.15: on this orbit the
    // term of order 8 all but cancels.)
    assert_slope(&points, "8.027", "0.01");
}

/// The top of the closed form is the scene's: same energy and momenta.
#[test]
fn it_is_the_same_top() {
    let (scene, start): (HeavyTop, State) = figure_3();
    assert_error!(distance(&start, &at(0.0)), 3.15e-16);
    // Of 1.0.
    assert_error!(scene.energy(&start) - exact().energy(), 2.2e-16);
}

/// Error after 20 time units, and the torques evaluated for it: the tables in the
/// docstrings of the methods.
#[test]
fn what_a_digit_costs() {
    let (scene, start) = figure_3();
    let exact = at(20.0);
    let run = |method: &dyn Integrator<HeavyTop, State>| {
        let (end, work) = method.advance(&scene, 0.0, &start, 20.0).expect("smooth");
        (distance(&end, &exact), work.torques())
    };
    let free = SpinFree::new(&scene).expect("a symmetric body");
    let without_spin = |method: Dop853| {
        let (end, work) = method.advance(&free, 0.0, &start, 20.0).expect("smooth");
        (distance(&end, &exact), work.torques())
    };
    let dop853 = |tolerance| Dop853::new(tolerance).expect("valid");
    let rk4 = |steps| Rk4::new(steps).expect("some steps");
    let splitting =
        |scheme: Scheme, kicks| Splitting::new(scheme, kicks / scheme.kicks()).expect("some steps");
    let rows = [
        (run(&dop853(1e-6)), "1.28e-5", 266),
        (run(&dop853(1e-8)), "1.37e-7", 446),
        (run(&dop853(1e-10)), "1.06e-9", 758),
        (run(&dop853(1e-12)), "8.17e-12", 1310),
        (run(&dop853(1e-14)), "7.28e-14", 2306),
        (run(&dop853(1e-15)), "5.74e-15", 3062),
        (without_spin(dop853(1e-6)), "8.72e-6", 278),
        (without_spin(dop853(1e-10)), "6.54e-10", 782),
        (without_spin(dop853(1e-14)), "7.35e-14", 2402),
        (run(&rk4(400)), "1.43e-6", 1600),
        (run(&rk4(800)), "8.53e-8", 3200),
        (run(&rk4(40_000)), "1.66e-14", 160_000),
        (run(&splitting(Scheme::STRANG, 480)), "1.09e-4", 480),
        (run(&splitting(Scheme::STRANG, 3840)), "1.70e-6", 3840),
        (run(&splitting(Scheme::SRKN6, 480)), "1.82e-8", 481),
        (run(&splitting(Scheme::SRKN6, 3840)), "4.42e-12", 3841),
        (run(&splitting(Scheme::SRKN14, 480)), "2.46e-9", 476),
        (run(&splitting(Scheme::SRKN14, 3840)), "1.76e-15", 3836),
    ];
    let mut ran = 0;
    for ((error, torques), printed, price) in rows {
        attained(error, printed, "error after 20");
        assert_eq!(torques, price);
        ran += 1;
    }
    assert_eq!(ran, 18);
}
