//! Going on from a located event: a start that is on it is not the next one.

use core::f64::consts::{PI, TAU};
use rotation_dynamics::integrators::{Direction, Dop853, Event, Ode, ode, second_order, size_or};
use rotation_dynamics::math::{cos, sin};
use rotation_dynamics::planar::contact::{Contact, Mechanism, MechanismState, motion};
use rotation_dynamics::planar::{Condition, Next, Phased, simulate};
use rotation_dynamics::{Error, Result};
use support::{Errors, assert_largest};

/// Numbers from 0 to 1, by chance and always the same (SplitMix64).
struct Chance(u64);

impl Chance {
    fn draw(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.draw()
    }
}

/// A spring x = cos(rate (t - t0) + phase), met where x = mark, and how a user looks for it.
#[derive(Debug, Clone, Copy)]
struct Watched {
    rate: f64,
    phase: f64,
    mark: f64,
    /// Of the start.
    t: f64,
    /// 1 or -1, of the time.
    onward: f64,
    direction: Direction,
    round_off: f64,
    tolerance: f64,
    /// Whether the clock starts at `t` again after each stop.
    restarts: bool,
}

impl Watched {
    fn draw(chance: &mut Chance) -> Self {
        let one_of = |chance: &mut Chance, n: usize| (chance.draw() * n as f64) as usize;
        Self {
            rate: chance.within(0.2, 5.0),
            phase: chance.within(0.0, TAU),
            mark: [0.0, chance.within(-0.95, 0.95)][one_of(chance, 2)],
            t: [0.0, 1e-3, 7.0, 1e3, -2e5][one_of(chance, 5)],
            onward: [1.0, -1.0][one_of(chance, 2)],
            direction: [Direction::Either, Direction::Rising, Direction::Falling]
                [one_of(chance, 3)],
            round_off: [0.0, 1e-12][one_of(chance, 2)],
            tolerance: [1e-6, 1e-9, 1e-12, 1e-15][one_of(chance, 4)],
            restarts: one_of(chance, 4) == 0,
        }
    }

    /// How long after the start the first `count` events are, by the closed form.
    fn expected(&self, count: usize) -> Vec<f64> {
        // Run backward, the angle falls.
        let turn = |angle: f64| (self.onward * (angle - self.phase)).rem_euclid(TAU);
        let angle = cos_inverse(self.mark);
        // At +angle the cosine falls as the angle grows.
        let falls = [(turn(angle), self.onward > 0.0), (turn(-angle), self.onward < 0.0)];
        let counts = |falls: bool| match self.direction {
            Direction::Either => true,
            Direction::Rising => !falls,
            Direction::Falling => falls,
        };
        let mut first: Vec<f64> = falls.iter().filter(|f| counts(f.1)).map(|f| f.0).collect();
        first.sort_by(f64::total_cmp);
        let turns = (0..).flat_map(|n| first.iter().map(move |a| a + TAU * f64::from(n)));
        turns.take(count).map(|angle| angle / self.rate).collect()
    }

    /// How long after the start the stops are, when a user goes on from each; `spoil` does
    /// something to the time and the state from which.
    fn stops(&self, count: usize, spoil: impl Fn(&mut f64, &mut [f64; 2])) -> Result<Vec<f64>> {
        let Self { rate, phase, mark, onward, direction, round_off, .. } = *self;
        let spring =
            ode(move |_, &[x, v]: &[f64; 2]| [v, -rate * rate * x]).scaled(move |_| [1.0, rate]);
        let method = Dop853::new(self.tolerance)?;
        let (mut t, mut state) = (self.t, [cos(phase), -rate * sin(phase)]);
        let (mut before, mut stops) = (0.0, Vec::new());
        while stops.len() < count {
            let event = Event::new("mark", direction, move |_, y: &[f64; 2]| y[0] - mark);
            let event = match round_off {
                0.0 => event.terminal(),
                _ => event.beyond(move |_, _| round_off).terminal(),
            };
            let run = method.solve(&spring, t, &state, t + onward * 1e4, &[event])?;
            let Some(met) = run.stopped_by() else { break };
            stops.push(before + (met.t - self.t) * onward);
            (t, state) = (met.t, met.state);
            spoil(&mut t, &mut state);
            if self.restarts {
                before += (t - self.t) * onward;
                t = self.t;
            }
        }
        Ok(stops)
    }
}

/// The angle between 0 and pi with this cosine.
fn cos_inverse(x: f64) -> f64 {
    let (mut low, mut high) = (0.0, PI);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if cos(middle) > x { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Every stop is the next one, whatever is watched and however often.
#[test]
fn every_stop_is_the_next() -> Result<()> {
    const STOPS: usize = 25;
    let mut chance = Chance(1);
    let mut late = Errors::of("times of stops, in errors of a step");
    for _ in 0..300 {
        let watched = Watched::draw(&mut chance);
        let stops = watched.stops(STOPS, |_, _| ())?;
        assert_eq!(stops.len(), STOPS, "{watched:?}");
        // With the rounding of the clock.
        let step = watched.tolerance + 1e-15 * watched.t.abs();
        for (got, want) in stops.iter().zip(watched.expected(STOPS)) {
            late.push_at((got - want) * watched.rate / step / STOPS as f64, watched);
        }
    }
    assert_largest!(late, 300 * STOPS, @"3.75");
    Ok(())
}

/// The damaged twin: from a rounding before the event it is met again.
#[test]
fn a_stop_before_the_event_meets_it_again() -> Result<()> {
    let mut chance = Chance(2);
    let (mut again, mut cases) = (0, 0);
    while cases < 50 {
        let watched = Watched { mark: 0.0, restarts: false, ..Watched::draw(&mut chance) };
        if watched.direction == Direction::Either || watched.round_off > 0.0 {
            continue;
        }
        cases += 1;
        // By 1e-9 before it: no round-off of the time at any of the starts.
        let stops = watched.stops(2, |t, [x, v]| {
            *t -= 1e-9 * watched.onward;
            *x -= 1e-9 * watched.onward * *v;
        })?;
        again += usize::from(stops[1] - stops[0] < 1e-6);
    }
    assert_eq!((again, cases), (50, 50));
    Ok(())
}

/// Solve, handle, solve on, a thousand times in each direction of time.
#[test]
fn a_thousand_stops() -> Result<()> {
    let mut stopped = 0;
    for onward in [1.0, -1.0] {
        for direction in [Direction::Either, Direction::Falling, Direction::Rising] {
            for round_off in [0.0, 1e-12] {
                let watched = Watched {
                    rate: 0.7,
                    phase: 0.0,
                    mark: 0.0,
                    t: 0.0,
                    onward,
                    direction,
                    round_off,
                    tolerance: 1e-6,
                    restarts: false,
                };
                let stops = watched.stops(1000, |_, _| ())?;
                let want = watched.expected(1000)[999];
                assert!((stops[999] - want).abs() < 1e-2, "{watched:?}: {}", stops[999]);
                stopped += stops.len();
            }
        }
    }
    assert_eq!(stopped, 12_000);
    Ok(())
}

/// A ball on a floor: its speed at every stop is turned round, with this part of it kept.
fn bounces(direction: Direction, onward: f64, kept: f64, count: usize) -> Result<usize> {
    let fall = second_order(|_, _, _| -10.0);
    let method = Dop853::new(1e-12)?;
    let (mut t, mut state, mut speed) = (3.0, [5.0, 0.0], 10.0);
    for n in 0..count {
        let floor = Event::new("floor", direction, |_, y: &[f64; 2]| y[0]).terminal();
        let run = method.solve(&fall, t, &state, t + 100.0 * onward, &[floor])?;
        let Some(met) = run.stopped_by() else {
            return Ok(n);
        };
        // Down, as the run meets it, and as fast as it was thrown up.
        assert!(!met.rising && (met.state[1] * onward + speed).abs() < 1e-8, "{n}: {met:?}");
        (t, state) = (met.t, [met.state[0], -kept * met.state[1]]);
        speed *= kept;
    }
    Ok(count)
}

/// A state that is changed at the event is not at the event again: bounces, one way and either.
#[test]
fn a_bounce_is_no_crossing() -> Result<()> {
    let mut stops = 0;
    for onward in [1.0, -1.0] {
        for direction in [Direction::Falling, Direction::Either] {
            for (kept, count) in [(1.0, 1000), (0.9, 80), (0.1, 5)] {
                stops += bounces(direction, onward, kept, count)?;
            }
        }
    }
    assert_eq!(stops, 4 * 1085);
    Ok(())
}

/// A function that only touches zero ends no loop twice at the touch.
#[test]
fn a_touch_is_left_behind() -> Result<()> {
    let mut chance = Chance(3);
    let mut cases = 0;
    for _ in 0..200 {
        let (centre, depth) = (chance.within(0.1, 2.9), [0.0, 1e-18, 1e-16, 3e-15][cases % 4]);
        let direction = [Direction::Either, Direction::Rising, Direction::Falling][cases % 3];
        let clock = ode(|_, _: &[f64; 1]| [1.0]).scaled(size_or([1.0; 1]));
        let (mut t, mut state, mut stops) = (0.0, [0.0], 0);
        loop {
            let touches = move |_: f64, y: &[f64; 1]| (y[0] - centre) * (y[0] - centre) - depth;
            let event = Event::new("touches", direction, touches).terminal();
            let run = Dop853::new(1e-9)?.solve(&clock, t, &state, 3.0, &[event])?;
            let Some(met) = run.stopped_by() else { break };
            assert!((met.t - centre).abs() < 1e-6, "{met:?}");
            stops += 1;
            assert!(stops <= 4, "{centre} {depth:e} {direction:?}: {met:?}");
            (t, state) = (met.t, met.state);
        }
        cases += 1;
    }
    assert_eq!(cases, 200);
    Ok(())
}

/// Of two events at one time none is lost, whichever a rounding puts first.
#[test]
fn events_at_one_time_are_both_told() -> Result<()> {
    let mut chance = Chance(4);
    let mut cases = 0;
    for _ in 0..200 {
        let (mark, scale) = (chance.within(0.1, 0.9), chance.within(0.3, 3.0));
        let spring = second_order(|_, x, _| -x);
        let one = Event::falling("one", move |_, y: &[f64; 2]| y[0] - mark).terminal();
        let two = Event::falling("two", move |_, y: &[f64; 2]| scale * y[0] - scale * mark);
        let run =
            Dop853::new(1e-12)?.solve(&spring, 0.0, &[1.0, 0.0], 3.0, &[one, two.terminal()])?;
        let [x, _] = *run.end_state();
        for (name, left) in [("one", x - mark), ("two", scale * x - scale * mark)] {
            let told = run.events().iter().filter(|e| e.name == name).count();
            assert_eq!(told, usize::from(left <= 0.0), "{name} {mark} {scale}: {left:e}");
        }
        assert_eq!(run.stopped_by().map(|e| e.t), Some(run.end_time()));
        cases += usize::from(run.events().len() == 2);
    }
    assert!(cases > 50, "{cases}");
    Ok(())
}

/// A relay: a spring pushed towards x = 0 from both sides, harder from the left.
struct Relay {
    /// What rounding the gaps of both phases have of their own.
    lever: f64,
}

impl Phased<2> for Relay {
    type Phase = bool;
    fn derivative(&self, right: bool, [_, v]: &[f64; 2]) -> [f64; 2] {
        [*v, if right { -1.0 } else { 1.7 }]
    }
    fn conditions(&self, right: bool) -> Vec<Condition<'_, bool, 2>> {
        let gap = move |y: &[f64; 2]| match right {
            true => self.lever * (y[0] - 0.3),
            false => 0.3 * self.lever - self.lever * y[0],
        };
        vec![Condition::gap("switch", gap, Next::Enter(!right))]
    }

    fn scale(&self, y: &[f64; 2]) -> [f64; 2] {
        size_or([1.0; 2])(y)
    }
}

/// A switch with plain gaps on both sides.
#[test]
fn plain_gaps_on_both_sides_of_a_switch() -> Result<()> {
    let mut chance = Chance(5);
    let mut switches = 0;
    for _ in 0..40 {
        let relay = Relay { lever: chance.within(0.1, 10.0) };
        let method = Dop853::new(1e-12)?;
        let run = simulate(&relay, &method, true, [1.0, 0.0], 60.0)?;
        // From 0.7 above: 2 sqrt(2 0.7) on one side, 2 sqrt(2 0.7)/1.7 on the other.
        let quarter = (2.0 * 0.7_f64).sqrt();
        let mut want = quarter;
        for (n, at) in run.transitions().iter().enumerate() {
            assert!((at.t - want).abs() < 1e-9, "{n} {}: {} {want}", relay.lever, at.t);
            want += if n % 2 == 0 { 2.0 * quarter / 1.7 } else { 2.0 * quarter };
            switches += 1;
        }
        assert!(want > 60.0);
    }
    assert_eq!(switches, 40 * 32);
    Ok(())
}

/// A ball between four walls whose bounces leave its place as it is, late on the clock too.
struct Box2 {
    walls: [f64; 2],
}

impl Phased<4> for Box2 {
    type Phase = ();
    fn derivative(&self, (): (), [_, _, u, v]: &[f64; 4]) -> [f64; 4] {
        [*u, *v, 0.0, 0.0]
    }
    fn conditions(&self, (): ()) -> Vec<Condition<'_, (), 4>> {
        let [a, b] = self.walls;
        let over = Next::jump((), |[x, y, u, v]: &[f64; 4]| [*x, *y, -u, *v]);
        let back = Next::jump((), |[x, y, u, v]: &[f64; 4]| [*x, *y, -u, *v]);
        let up = Next::jump((), |[x, y, u, v]: &[f64; 4]| [*x, *y, *u, -v]);
        let down = Next::jump((), |[x, y, u, v]: &[f64; 4]| [*x, *y, *u, -v]);
        vec![
            Condition::gap("left", |s| s[0], over),
            Condition::gap("right", move |s| a - s[0], back),
            Condition::gap("bottom", |s| s[1], up),
            Condition::gap("top", move |s| b - s[1], down),
        ]
    }

    fn scale(&self, y: &[f64; 4]) -> [f64; 4] {
        size_or([1.0; 4])(y)
    }
}

/// Bounces off the wall as they are located, and into corners: both walls at one time.
#[test]
fn bounces_and_corners() -> Result<()> {
    let mut chance = Chance(6);
    let (mut bounces, mut corners) = (0, 0);
    for n in 0..40 {
        let walls = [chance.within(0.1, 2.0), chance.within(0.1, 2.0)];
        let corner = n % 2 == 0;
        let start = [0.25 * walls[0], 0.25 * walls[1]];
        let speed = match corner {
            // Along the diagonal.
            true => [walls[0] * 3.0, walls[1] * 3.0],
            false => [walls[0] * 3.0, walls[1] * 2.1],
        };
        let state = [start[0], start[1], speed[0], speed[1]];
        let run = simulate(&Box2 { walls }, &Dop853::new(1e-12)?, (), state, 30.0)?;
        // 90 widths in all, from a quarter of the first.
        let names = |name: &str| run.transitions().iter().filter(|t| t.name == name).count();
        let met = ["left", "right", "bottom", "top"].map(names);
        let want = if corner { [45, 45, 45, 45] } else { [45, 45, 31, 32] };
        assert_eq!(met, want, "{walls:?}");
        let end = run.end_state().expect("a run");
        assert!(end[2].abs() == speed[0] && end[3].abs() == speed[1]);
        bounces += run.transitions().len();
        corners += usize::from(corner);
    }
    assert_eq!((bounces, corners), (20 * 180 + 20 * 153, 20));
    Ok(())
}

/// What is really beyond is refused, and what cannot last as well.
#[test]
fn what_is_beyond_is_refused() -> Result<()> {
    let (relay, method) = (Relay { lever: 1.0 }, Dop853::new(1e-12)?);
    for x in [0.29, 0.3 - 1e-12] {
        let error = simulate(&relay, &method, true, [x, 0.0], 1.0).expect_err("beyond");
        assert!(matches!(error, Error::CannotHold { name: "switch", rate: None, .. }), "{error}");
    }
    // On the switch, but for a rounding, it goes on as it is pushed.
    for x in [0.3, 0.3f64.next_down(), 0.3f64.next_up()] {
        let run = simulate(&relay, &method, true, [x, -1.0], 0.5)?;
        assert_eq!(run.transitions().len(), 1, "{x}");
        assert!(run.transitions()[0].t < 1e-15);
    }
    Ok(())
}

/// A system that moves with the clock only.
struct Clock;
impl Ode<1> for Clock {
    fn derivative(&self, _: f64, _: &[f64; 1]) -> [f64; 1] {
        [1.0]
    }

    fn scale(&self, y: &[f64; 1]) -> [f64; 1] {
        size_or([1.0; 1])(y)
    }
}

/// Where the clock is so coarse that a rounding of it is seen in the state, too.
#[test]
fn a_coarse_clock_gets_on() -> Result<()> {
    let mut stops = 0;
    for (t0, onward) in [(1e9, 1.0), (1e9, -1.0), (-1e12, 1.0)] {
        let (mut t, mut y) = (t0, [0.0]);
        loop {
            let teeth = Event::crossing("tooth", |_, y: &[f64; 1]| sin(PI * (y[0] - 0.5)));
            let run = Dop853::new(1e-6)?.with_longest_step(0.3)?.solve(
                &Clock,
                t,
                &y,
                t0 + 100.0 * onward,
                &[teeth.terminal()],
            )?;
            let Some(met) = run.stopped_by() else { break };
            stops += 1;
            (t, y) = (met.t, met.state);
        }
    }
    assert_eq!(stops, 300);
    Ok(())
}

/// A mass on a spring, on a belt that takes it along until the spring is stronger.
struct Belt {
    slipping: f64,
    holding: f64,
    speed: f64,
}

impl Mechanism<1, 1> for Belt {
    fn mass(&self, _: &[f64; 1]) -> [[f64; 1]; 1] {
        [[1.3]]
    }
    fn force(&self, state: &MechanismState<1>) -> [f64; 1] {
        [-2.1 * state.q[0]]
    }
    fn contacts(&self, _: &MechanismState<1>) -> [Contact<1>; 1] {
        let belt = Contact::pressed("belt", 1.7).tangent([1.0], 0.0);
        [belt.frictions(self.slipping, self.holding).moving(self.speed)]
    }
}

/// From stop to stop of a mass that sticks and slips: no start is a stop, and all are met.
#[test]
fn sticking_and_slipping_from_stop_to_stop() -> Result<()> {
    let method = Dop853::new(1e-12)?;
    let mut errors = Errors::of("error of the stops");
    for (slipping, holding, speed) in
        [(0.2, 0.4, 0.3), (0.2, 0.2, 0.3), (0.1, 0.5, -0.7), (0.3, 0.3, 0.0)]
    {
        for x in [0.5, -0.9, 3.0] {
            let belt = Belt { slipping, holding, speed };
            let whole = motion(&belt, &method, MechanismState::rest([x]), 60.0)?;
            let (mut t, mut state) = (0.0, MechanismState::rest([x]));
            for event in whole.events() {
                let rest = motion(&belt, &method, state, 60.0 - t)?;
                let next = &rest.events()[0];
                assert!(next.t > 0.0, "{} at once", next.name);
                (t, state) = (t + next.t, next.after);
                errors.push((t - event.t).abs());
            }
        }
    }
    assert_largest!(errors, 226, @"5.17e-9");
    Ok(())
}
