//! Events are located as well as the run itself knows where it is.

use super::kepler::{Kepler, distance, exact};
use core::f64::consts::PI;
use rotation_dynamics::integrators::{Direction, Dop853, Event, Ode, size_or};
use rotation_dynamics::math::{cos, sin};
use support::{EPS, Errors, assert_error, assert_largest, attained};

#[test]
fn crossings_of_the_axis() {
    let mut residues = Errors::of("distance from the axis");
    // Each no later than the run's own error says: that at the end is beside it.
    for (tolerance, latest, at_end) in [
        (1e-6, "1.3e-4", "1.2e-4"),
        (1e-9, "7.9e-8", "8.1e-8"),
        (1e-12, "6.2e-11", "6.7e-11"),
        (1e-15, "6.4e-14", "7.0e-14"),
    ] {
        let method = Dop853::new(tolerance).expect("valid");
        let axis = Event::crossing("axis", |_t, y: &[f64; 4]| y[1]);
        let run = method.solve(&Kepler, 0.0, &exact(0.0), 20.0, &[axis]).expect("smooth");
        assert_eq!(run.events().len(), 6);
        let mut late = Errors::of("time of a crossing");
        for (i, event) in run.events().iter().enumerate() {
            let expected = PI * (i + 1) as f64;
            late.push(event.t - expected);
            residues.push(event.state[1]);
            assert_eq!(event.rising, i % 2 == 1);
            assert_eq!((event.index, event.name), (0, "axis"));
        }
        let (end, t) = (run.end_state(), run.end_time());
        attained(late.largest(), latest, "time of a crossing");
        attained(distance(end, &exact(t)), at_end, "error at the end");
    }
    // An axis off by 1e-12 is crossed at other times.
    let beside = Event::crossing("beside", |_t, y: &[f64; 4]| y[1] + 1e-12);
    let run = Dop853::new(1e-15)
        .and_then(|method| method.solve(&Kepler, 0.0, &exact(0.0), 20.0, &[beside]))
        .expect("smooth");
    let mut damaged = Errors::of("time of a crossing beside the axis");
    for (i, event) in run.events().iter().enumerate() {
        damaged.push(event.t - PI * (i + 1) as f64);
    }
    damaged.exceed(4e-13, 6);
    // The speed times the rounding of the time, which is on the far side.
    assert_largest!(residues, 4 * 6, @"3.89e-15");
}

struct Clock;
impl Ode<1> for Clock {
    fn derivative(&self, t: f64, _y: &[f64; 1]) -> [f64; 1] {
        [cos(t)]
    }

    fn scale(&self, y: &[f64; 1]) -> [f64; 1] {
        size_or([1.0; 1])(y)
    }
}

#[test]
fn directions_order_and_terminal() {
    let method = Dop853::new(1e-12).expect("valid");
    let events = || {
        [
            Event::falling("down through 0.5", |_t, y: &[f64; 1]| y[0] - 0.5),
            Event::rising("up through 0.5", |_t, y: &[f64; 1]| y[0] - 0.5),
            Event::new("zero", Direction::Either, |_t, y: &[f64; 1]| y[0]),
            Event::rising("late", |t, _y: &[f64; 1]| t - 6.0),
        ]
    };
    let run = method.solve(&Clock, 0.0, &[0.0], 10.0, &events()).expect("smooth");
    let met: Vec<_> = run.events().iter().map(|e| (e.name, e.t)).collect();
    let expected = [
        ("up through 0.5", PI / 6.0),
        ("down through 0.5", 5.0 * PI / 6.0),
        ("zero", PI),
        ("late", 6.0),
        ("zero", 2.0 * PI),
        ("up through 0.5", 13.0 * PI / 6.0),
        ("down through 0.5", 17.0 * PI / 6.0),
        ("zero", 3.0 * PI),
    ];
    assert_eq!(met.len(), expected.len());
    let mut late = Errors::of("time of an event");
    for ((name, t), (want, when)) in met.iter().zip(expected) {
        assert_eq!(*name, want);
        late.push_at(t - when, name);
    }
    // At t = 6.3, with a tolerance of 1e-12.
    assert_largest!(late, 8, @"1.69e-14");
    // Terminal: nothing after it, and the run ends there.
    let mut stopping = Vec::from(events());
    let zero = stopping.remove(2).terminal();
    stopping.insert(2, zero);
    let run = method.solve(&Clock, 0.0, &[0.0], 10.0, &stopping).expect("smooth");
    assert_eq!(run.events().len(), 3);
    let last = run.stopped_by().expect("stopped");
    assert_eq!((last.name, last.t), ("zero", run.end_time()));
    assert_eq!(run.at(run.end_time()).expect("the end"), *run.end_state());
    assert_error!(run.end_time() - PI, 2.2e-15);
    assert_error!(run.at(3.0).expect("within")[0] - sin(3.0), 6.9e-15);
    // Backwards, rising is what the run meets as rising.
    let run = method.solve(&Clock, 0.0, &[0.0], -10.0, &events()).expect("smooth");
    let met: Vec<_> = run.events().iter().map(|e| (e.name, e.t)).collect();
    assert_eq!(met[0].0, "zero");
    assert_error!(met[0].1 + PI, 2.2e-15);
}

#[test]
fn events_in_one_step_come_in_order() {
    // A single step of a straight line, and three marks on it.
    struct Line;
    impl Ode<1> for Line {
        fn derivative(&self, _t: f64, _y: &[f64; 1]) -> [f64; 1] {
            [1.0]
        }

        fn scale(&self, y: &[f64; 1]) -> [f64; 1] {
            size_or([1.0; 1])(y)
        }
    }
    let method = Dop853::new(1e-9).expect("valid");
    let marks = [
        Event::rising("third", |_t, y: &[f64; 1]| y[0] - 0.75),
        Event::rising("first", |_t, y: &[f64; 1]| y[0] - 0.25),
        Event::rising("second", |_t, y: &[f64; 1]| y[0] - 0.5),
    ];
    let run = method.solve(&Line, 0.0, &[0.0], 1.0, &marks).expect("straight");
    let met: Vec<_> = run.events().iter().map(|e| (e.name, e.t)).collect();
    assert_eq!(met, [("first", 0.25), ("second", 0.5), ("third", 0.75)]);
}

#[test]
fn grazing_and_an_event_at_the_start() {
    let method = Dop853::new(1e-12).expect("valid");
    // sin t - 1 touches zero at pi/2 without crossing: met as two crossings, as one
    // touch or not at all, never as an error.
    let graze = Event::crossing("graze", |_t, y: &[f64; 1]| y[0] - 1.0);
    let run = method.solve(&Clock, 0.0, &[0.0], 3.0, &[graze]).expect("smooth");
    assert!(run.events().len() <= 2);
    // Where a parabola meets zero, a rounding of it is its root: sqrt(2 eps), and a few of them.
    let bound = 8.0 * (2.0 * EPS).sqrt();
    for event in run.events() {
        assert!((event.t - PI / 2.0).abs() < bound, "{:e}", event.t);
    }
    // The damaged twin: a graze that is 1e-13 deep is farther off, and met on both sides.
    let deeper = Event::crossing("graze", |_t, y: &[f64; 1]| y[0] - (1.0 - 1e-13));
    let run = method.solve(&Clock, 0.0, &[0.0], 3.0, &[deeper]).expect("smooth");
    assert_eq!(run.events().len(), 2);
    for event in run.events() {
        assert!((event.t - PI / 2.0).abs() > bound, "{:e}", event.t);
    }
    // Zero at the very start is no event; a rounding below zero is one, at once.
    for (start, met) in [(0.0, 0), (-1e-300, 1)] {
        let zero = Event::rising("zero", |_t, y: &[f64; 1]| y[0]).terminal();
        let run = method.solve(&Clock, 0.0, &[start], 3.0, &[zero]).expect("smooth");
        assert_eq!(run.events().len(), met);
        assert_eq!(run.stopped_by().is_some(), met == 1);
        let end = run.end_time();
        assert_eq!(run.at(end).expect("the end"), *run.end_state());
        assert!(run.at(end).expect("the end")[0].is_finite());
    }
}

#[test]
fn an_event_must_be_a_number() {
    let method = Dop853::new(1e-9).expect("valid");
    let bad = Event::rising("root", |_t, y: &[f64; 1]| (0.5 - y[0]).sqrt());
    let error = method.solve(&Clock, 0.0, &[0.0], 2.0, &[bad]).expect_err("refused");
    let message = error.to_string();
    assert!(
        message.starts_with("the function of the event \"root\" at t = ")
            && message.ends_with(" is [NaN]; it must be finite"),
        "{message}"
    );
}

/// A parabola that dips this deep below zero: both its zeros lie within an eighth of
/// a step, of which a constant rate needs few.
#[test]
fn a_graze_within_a_step_is_met() {
    struct Clock;
    impl Ode<1> for Clock {
        fn derivative(&self, _: f64, _: &[f64; 1]) -> [f64; 1] {
            [1.0]
        }

        fn scale(&self, y: &[f64; 1]) -> [f64; 1] {
            size_or([1.0; 1])(y)
        }
    }
    let mut late = Errors::of("time of a graze, in what a rounding does");
    let mut touched = Errors::of("the bottom of the dip taken for its zero");
    for depth in [1e-2, 1e-6, 1e-10, 1e-13] {
        for centre in [0.03, 0.31, 0.5, 0.999, 1.7] {
            let dips = |_: f64, y: &[f64; 1]| (y[0] - centre) * (y[0] - centre) - depth;
            let event = Event::falling("dips", dips);
            let method = Dop853::new(1e-12).expect("valid");
            let start = [-1.0];
            let run = method.solve(&Clock, 0.0, &start, 3.0, &[event]).expect("smooth");
            assert_eq!(run.events().len(), 1, "{depth:e} at {centre}");
            // A rounding of the state moves the zero by eps/sqrt(depth).
            let rounding = EPS * (1.0 + 1.0 / depth.sqrt());
            let t = run.events()[0].t;
            late.push_at((t - (1.0 + centre - depth.sqrt())) / rounding, depth);
            touched.push_at((t - (1.0 + centre)) / rounding, depth);
        }
    }
    assert_largest!(late, 20, @"0.182");
    // The damaged twin: deep or not, a dip has no zero in its middle.
    touched.exceed(800.0, 20);
    // The touch alone, and a miss: nothing.
    for above in [1e-12, 1e-3] {
        let misses = |_: f64, y: &[f64; 1]| (y[0] - 0.31) * (y[0] - 0.31) + above;
        let event = Event::falling("misses", misses);
        let method = Dop853::new(1e-12).expect("valid");
        let run = method.solve(&Clock, 0.0, &[-1.0], 3.0, &[event]).expect("smooth");
        assert_eq!(run.events().len(), 0);
    }
}

/// A function that leaves zero as t^3, with a round-off of its own.
struct Slowly;
impl Ode<1> for Slowly {
    fn derivative(&self, t: f64, _y: &[f64; 1]) -> [f64; 1] {
        [3.0 * t * t - 4.0 * t * t * t]
    }

    fn scale(&self, y: &[f64; 1]) -> [f64; 1] {
        size_or([1.0; 1])(y)
    }
}

/// A sign that is round-off is no event; the fall that comes later is met where it is.
#[test]
fn round_off_is_no_event() {
    const ROUND_OFF: f64 = 1e-9;
    let falls = |beyond: f64| {
        let noisy = |t: f64, y: &[f64; 1]| y[0] + ROUND_OFF * sin(3e5 * t);
        let event = Event::falling("falls", noisy).beyond(move |_, _| beyond);
        Dop853::new(1e-12)
            .and_then(|method| method.with_longest_step(1e-4))
            .and_then(|method| method.solve(&Slowly, 0.0, &[0.0], 1.5, &[event]))
            .expect("smooth")
    };
    let found = falls(2.0 * ROUND_OFF);
    let [event] = found.events() else {
        panic!("{:?}", found.events());
    };
    // Of a function that falls by one in a second.
    assert_error!(event.t - 1.0, 1.1e-10);
    // The damaged twin: of a round-off that is not told, most of what is seen is none.
    let twin = falls(0.0);
    assert_eq!(twin.events().len(), 30);
}
