//! The page `how_events`: the interpolant, what a root on it is worth, and how an event's time
//! depends on a graze.

use rotation_dynamics::integrators::{Dop853, Event, Integrator, Solution, second_order};
use rotation_dynamics::math::{EPS, cos, pow, sin};
use support::{Errors, assert_largest};

/// A spring of unit frequency from x = 1 at rest.
fn swings(tolerance: f64, t_end: f64, events: &[Event<'_, 2>]) -> Solution<2> {
    let spring = second_order(|_, x, _| -x);
    let method = Dop853::new(tolerance).expect("a tolerance");
    let run = method.solve(&spring, 0.0, &[1.0, 0.0], t_end, events);
    run.expect("smooth")
}

#[test]
fn the_interpolant_has_the_slopes_of_the_motion_at_both_ends() {
    // From either side of each end of a step, by five values.
    let errors = |damage: f64| {
        let mut errors = Errors::of("slope of the interpolant less f");
        let run = swings(1e-6, 20.0, &[]);
        let ends: Vec<f64> = core::iter::once(0.0).chain(run.step_times()).collect();
        for step in ends.windows(2) {
            let h = 0.004 * (step[1] - step[0]);
            for (t, h) in [(step[0], h), (step[1], -h)] {
                let x = |k: f64| run.at(t + k * h).expect("within")[0];
                let values = [0.0, 1.0, 2.0, 3.0, 4.0].map(x);
                let weights = [-25.0, 48.0, -36.0, 16.0, -3.0];
                let sum: f64 = values.iter().zip(weights).map(|(x, w)| x * w).sum();
                let [_, v] = run.at(t).expect("within");
                errors.push_at(sum / (12.0 * h) - damage * v, t);
            }
        }
        errors
    };
    let found = errors(1.0);
    let steps = swings(1e-6, 20.0, &[]).step_times().count();
    assert_largest!(found, 2 * steps, @"4.66e-11");
    assert!(errors(1.001).largest() > 1e-4);
}

#[test]
fn a_real_step_is_better_than_the_interpolant() {
    // Zeros of x by bisection on the interpolant, and as they are located; what the run itself
    // is off by at that time, over the slope, is no part of either.
    let mut located = Errors::of("located, less what the run is off by");
    let mut between = Errors::of("on the interpolant, less what the run is off by");
    for tolerance in [1e-4, 1e-6, 1e-8] {
        let event = Event::crossing("zero", |_, y: &[f64; 2]| y[0]);
        let run = swings(tolerance, 12.0, &[event]);
        for (n, met) in run.events().iter().enumerate() {
            let exact = core::f64::consts::FRAC_PI_2 + core::f64::consts::PI * n as f64;
            // The error of the run, from the ends of the step about it.
            let ends: Vec<f64> = core::iter::once(0.0).chain(run.step_times()).collect();
            let after = ends.iter().position(|t| *t >= met.t).expect("within");
            let phase = |t: f64| {
                let [x, v] = run.at(t).expect("within");
                // Of a state, the angle by which it is ahead of the motion.
                -(x * sin(t) + v * cos(t))
            };
            let ahead = 0.5 * (phase(ends[after - 1]) + phase(ends[after]));
            let (mut from, mut to) = (met.t - 0.05, met.t + 0.05);
            let rising = run.at(from).expect("within")[0] < 0.0;
            for _ in 0..60 {
                let middle = 0.5 * (from + to);
                if (run.at(middle).expect("within")[0] < 0.0) == rising {
                    from = middle;
                } else {
                    to = middle;
                }
            }
            located.push_at((met.t - exact + ahead) / tolerance, (tolerance, n));
            between.push_at((from - exact + ahead) / tolerance, (tolerance, n));
        }
    }
    assert_largest!(located, 12, @"0.0140");
    assert_largest!(between, 12, @"0.151");
}

#[test]
fn a_graze_is_as_hard_as_the_root_of_its_depth() {
    // x = 1 - t^2/2 seen from below by 1 - depth: the times are -+ sqrt(2 depth).
    let mut errors = Errors::of("times of a graze, over eps and the condition");
    let mut bare = Errors::of("the same without the condition");
    for depth in [1e-2, 1e-4, 1e-6, 1e-8] {
        let stone = second_order(|_, _, _| -1.0);
        let ceiling = 1.0 - depth;
        let event = Event::crossing("ceiling", move |_, y: &[f64; 2]| ceiling - y[0]);
        let run = Dop853::new(1e-12)
            .and_then(|method| method.solve(&stone, -1.0, &[0.5, 1.0], 1.3, &[event]))
            .expect("smooth");
        let depth = 1.0 - ceiling;
        let want = (2.0 * depth).sqrt();
        assert_eq!(run.events().len(), 2, "{depth}");
        for (met, sign) in run.events().iter().zip([-1.0, 1.0]) {
            let off = met.t - sign * want;
            // dt/d(depth) = 1/sqrt(2 depth).
            errors.push_at(off / (EPS / want), depth);
            bare.push_at(off / EPS, depth);
        }
    }
    assert_largest!(errors, 8, @"3.78");
    assert!(bare.largest() > 1e3);
}

#[test]
fn the_place_of_a_graze_need_not_be_known_well() {
    // Forty golden sections of an eighth of a step, and the depth that they miss, as a part of a
    // function that goes as the square.
    let place = pow(0.5 * (5.0_f64.sqrt() - 1.0), 40.0);
    assert!(place < 1e-8 && place > 1e-9, "{place}");
    assert!(place * place < EPS && pow(place, 1.5) > EPS);
}

#[test]
fn an_event_costs_a_few_real_steps() {
    let mut dear = Errors::of("evaluations an event");
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let spring = second_order(|_, x, _| -x);
        let (_, ends) = Dop853::new(tolerance)
            .and_then(|method| method.advance(&spring, 0.0, &[1.0, 0.0], 12.0))
            .expect("smooth");
        let between = swings(tolerance, 12.0, &[]).work();
        assert_eq!(between.derivatives - ends.derivatives, 3 * ends.steps);
        let event = Event::crossing("zero", |_, y: &[f64; 2]| y[0]);
        let run = swings(tolerance, 12.0, &[event]);
        // The same steps as without it.
        assert_eq!(run.work().steps, ends.steps);
        let more = run.work().derivatives - between.derivatives;
        assert_eq!(more % 11, 0);
        dear.push_at(more as f64 / run.events().len() as f64, tolerance);
    }
    assert_largest!(dear, 5, @"38.5");
    assert!(dear.smallest() > 19.0);
}
