//! A fit of a pendulum to the rate about its hinge: what is true is found, with the error that is stated.
//!
//! The swings are made by Runge and Kutta's method: nothing of the closed form, and nothing of the
//! integrator, by which they are fitted.
//!
//! ```text
//! PROPERTY_CASES=10 cargo test --package checks --test fit swing -- --nocapture
//! ```

use rotation_dynamics::Error;
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::fit::{Swing, SwingFit, Swinging};
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::integrators::{Dop853, second_order};
use support::Random;

const GRAVITY: f64 = 9.81;

/// A pendulum, and how it is recorded.
#[derive(Debug, Clone, Copy)]
struct Rod {
    length: f64,
    /// Angle and rate at the first sample.
    start: [f64; 2],
    linear: f64,
    quadratic: f64,
    offset: f64,
    noise: f64,
    quantum: f64,
    seconds: f64,
    /// Mean time between samples, and by what part of it they are early or late.
    step: f64,
    jitter: f64,
}

impl Rod {
    /// Each damping in every second one.
    fn drawn(random: &mut Random) -> Self {
        let mut rod = Self {
            length: random.size(0.2, 1.5),
            start: [random.size(0.3, 2.6), 0.0],
            linear: 0.0,
            quadratic: 0.0,
            offset: random.between(-0.1, 0.1),
            noise: random.size(0.003, 0.03),
            quantum: random.size(0.001, 0.02),
            seconds: random.between(5.0, 9.0),
            step: 1.0 / random.between(50.0, 120.0),
            jitter: 0.4 * random.unit(),
        };
        // What is lost of the amplitude is e^-x, or 1/(1 + x).
        let mut lost = || if random.unit() < 0.5 { 0.0 } else { random.between(0.4, 1.2) };
        rod.linear = 2.0 * lost() / rod.seconds;
        let speed = rod.start[0] * rod.frequency();
        rod.quadratic = 0.75 * core::f64::consts::PI * lost() / (speed * rod.seconds);
        // The recording begins anywhere in the first swing.
        rod.start = rod.after(rod.start, random.between(0.0, 2.0));
        rod
    }

    fn frequency(&self) -> f64 {
        (GRAVITY / self.length).sqrt()
    }

    /// The state after this time, in steps of at most a 20th of 1/W.
    fn after(&self, [mut angle, mut rate]: [f64; 2], time: f64) -> [f64; 2] {
        let square = GRAVITY / self.length;
        let change = |angle: f64, rate: f64| {
            -square * angle.sin() - (self.linear + self.quadratic * rate.abs()) * rate
        };
        let steps = (20.0 * time * self.frequency()).ceil().max(1.0);
        let h = time / steps;
        for _ in 0..steps as u32 {
            let a = change(angle, rate);
            let v = rate + 0.5 * h * a;
            let b = change(angle + 0.5 * h * rate, v);
            let w = rate + 0.5 * h * b;
            let c = change(angle + 0.5 * h * v, w);
            let u = rate + h * c;
            let d = change(angle + h * w, u);
            angle += h / 6.0 * (rate + 2.0 * (v + w) + u);
            rate += h / 6.0 * (a + 2.0 * (b + c) + d);
        }
        [angle, rate]
    }

    /// Times and rates, on a clock that does not begin at 0.
    fn recorded(&self, random: &mut Random) -> (Vec<f64>, Vec<f64>) {
        let (mut times, mut rates) = (Vec::new(), Vec::new());
        let (mut state, mut now) = (self.start, 0.0);
        for k in 0..(self.seconds / self.step) as u32 {
            let late = if k == 0 { 0.0 } else { self.jitter * random.between(-1.0, 1.0) };
            let t = self.step * (f64::from(k) + late);
            (state, now) = (self.after(state, t - now), t);
            times.push(3.0 + t);
            // Twelve even numbers less six: nearly a normal one.
            let normal = (0..12).map(|_| random.unit()).sum::<f64>() - 6.0;
            let shown = state[1] + self.offset + self.noise * normal;
            let quantum = self.quantum;
            rates.push(if quantum > 0.0 { quantum * (shown / quantum).round() } else { shown });
        }
        (times, rates)
    }

    fn fit(&self) -> Result<SwingFit, Error> {
        let (times, rates) = self.recorded(&mut Random(1));
        Swing::new(times, rates)?.fit()
    }

    fn amplitude(&self) -> f64 {
        let [angle, rate] = self.start;
        let half = (0.5 * angle).sin();
        2.0 * (half * half + 0.25 * rate * rate / self.frequency().powi(2)).sqrt().asin()
    }
}

/// So many swings are made: 40, or 250 times what `PROPERTY_CASES` says.
fn often() -> u32 {
    let cases = std::env::var("PROPERTY_CASES").map(|text| text.parse::<u32>().expect("a number"));
    cases.map_or(40, |cases| 250 * cases)
}

/// That so many of all are within this part of them, as far as chance lets it be seen: three deviations.
fn assert_part(name: &str, held: u32, all: u32, [least, most]: [f64; 2]) {
    let all = f64::from(all);
    let slack = |part: f64| 3.0 * (part * (1.0 - part) / all).sqrt();
    let part = f64::from(held) / all;
    assert!(part >= least - slack(least) && part <= most + slack(most), "{name}: {held} of {all}");
}

/// Seen without noise.
fn clean() -> Rod {
    Rod {
        length: 0.4,
        start: [1.2, 0.5],
        linear: 0.0,
        quadratic: 0.0,
        offset: 0.03,
        noise: 0.0,
        quantum: 0.0,
        seconds: 8.0,
        step: 0.01,
        jitter: 0.0,
    }
}

#[test]
fn the_interval_holds_what_is_true_in_95_of_100_swings() {
    let mut random = Random(11);
    let swings = often();
    // Length, amplitude, offset, linear, quadratic.
    let (mut held, mut told, mut damaged, mut zeros) = ([0; 5], [0; 5], 0, 0);
    // Of each damping: how often it is present, and found; how often it is absent, and found.
    let mut found = [[0; 4]; 2];
    for _ in 0..swings {
        let rod = Rod::drawn(&mut random);
        let (times, rates) = rod.recorded(&mut random);
        let fit = Swing::new(times, rates).expect("a swing").fit().expect("a fit");
        let length = fit.length(GRAVITY).expect("gravity");
        damaged += u32::from(length.holds(1.005 * rod.length));
        let needed = [fit.linear(), fit.quadratic()].into_iter().flatten();
        zeros += needed.filter(|damping| damping.holds(0.0)).count();
        let estimates = [
            (Some(length), rod.length),
            (Some(fit.amplitude()), rod.amplitude()),
            (Some(fit.offset()), rod.offset),
            (fit.linear(), rod.linear),
            (fit.quadratic(), rod.quadratic),
        ];
        for (k, (estimate, value)) in estimates.into_iter().enumerate() {
            told[k] += u32::from(estimate.is_some());
            held[k] += u32::from(estimate.is_some_and(|estimate| estimate.holds(value)));
        }
        let dampings = [rod.linear, rod.quadratic];
        for ((decision, value), found) in fit.decisions().iter().zip(dampings).zip(&mut found) {
            let at = if value > 0.0 { 0 } else { 2 };
            found[at] += 1;
            found[at + 1] += u32::from(decision.needed);
            assert_eq!(decision.needed, decision.improvement > decision.threshold);
        }
    }
    println!("of {swings} told {told:?}, held {held:?}, damaged {damaged}, dampings {found:?}");
    for (k, (held, told)) in held.into_iter().zip(told).enumerate() {
        // A damping is told where it is found.
        assert_part(&k.to_string(), held, told, [0.92, if k > 2 { 1.0 } else { 0.98 }]);
    }
    assert!(10 * damaged < swings, "{damaged}");
    // One of the 1500 swings of `PROPERTY_CASES=6`.
    assert!(
        500 * zeros <= swings as usize,
        "{zeros} dampings are needed, and 0 is in their intervals"
    );
    for [present, found, absent, wrongly] in found {
        assert!(present > swings / 3 && 100 * found >= 99 * present, "{found} of {present}");
        assert!(absent > swings / 3 && 100 * wrongly <= absent, "{wrongly} of {absent}");
    }
}

#[test]
fn without_noise_all_is_found() {
    let mut cases = 0;
    for (linear, quadratic) in [(0.0, 0.0), (0.05, 0.0), (0.0, 0.03), (0.05, 0.03)] {
        for amplitude in [0.05, 1.2, 3.0] {
            let rod = Rod { start: [amplitude, 0.5], linear, quadratic, ..clean() };
            let fit = rod.fit().expect("a fit");
            let off = fit.length(GRAVITY).expect("gravity").value / rod.length - 1.0;
            // Averages leave 4e-6 of the steepest rates.
            assert!(off.abs() < 1e-5, "{amplitude} {linear} {quadratic}: length {off:e}");
            let off = fit.amplitude().value - rod.amplitude();
            assert!(off.abs() < 1e-5, "{amplitude} {linear} {quadratic}: amplitude {off:e}");
            assert!((fit.offset().value - 0.03).abs() < 1e-4 && fit.misfit() < 1e-4);
            for (found, value) in [(fit.linear(), linear), (fit.quadratic(), quadratic)] {
                assert_eq!(found.is_some(), value > 0.0, "{amplitude} {linear} {quadratic}");
                assert!(found.is_none_or(|found| (found.value - value).abs() < 1e-4));
            }
            cases += 1;
        }
    }
    assert_eq!(cases, 12);
    // No pendulum without damping is best here, and what it brings is told all the same.
    let slowed = Rod { length: 4.0, start: [1.4, 0.0], linear: 0.2, seconds: 30.0, ..clean() };
    let gained = slowed.fit().expect("a fit").decisions()[0].improvement;
    assert!(gained > 1e3 && gained < 1e6, "{gained}");
    // 20 s at 400 samples a second, with a gap of a second.
    let long = Rod { linear: 0.03, noise: 0.02, seconds: 20.0, step: 0.0025, ..clean() };
    let (times, rates) = long.recorded(&mut Random(3));
    let kept = |k: &usize| !(3000..3400).contains(k);
    let times: Vec<f64> = (0..8000).filter(kept).map(|k| times[k]).collect();
    let rates = (0..8000).filter(kept).map(|k| rates[k]).collect();
    let fit = Swing::new(times.clone(), rates).expect("a swing").fit().expect("a fit");
    assert!(fit.length(GRAVITY).expect("gravity").holds(0.4) && fit.linear().is_some());
    assert!(fit.residuals().count() == 7600 && (fit.misfit() / 0.02 - 1.0).abs() < 0.05);
    assert!(fit.rate(times[0] - 0.1).is_err() && fit.angle(23.1).is_err());
    assert!(fit.rate(f64::NAN).is_err() && fit.length(0.0).is_err());
}

/// The largest difference of a fit from this motion, and from one of a pendulum longer by a millionth.
fn apart(fit: &SwingFit, motion: impl Fn(f64, f64) -> [f64; 2]) -> [f64; 2] {
    let length = fit.length(GRAVITY).expect("gravity").value;
    let offset = fit.offset().value;
    [1.0, 1.0 + 1e-6].map(|factor| {
        let at = |k: u32| {
            let t = 0.037 * f64::from(k);
            let [angle, rate] = motion(factor * length, t);
            let angle = (fit.angle(3.0 + t).expect("a time") - angle).abs();
            angle.max((fit.rate(3.0 + t).expect("a time") - offset - rate).abs())
        };
        (0..200).map(at).fold(0.0, f64::max)
    })
}

#[test]
fn other_methods_give_the_fitted_motion() {
    for amplitude in [0.3, 1.2, 3.0] {
        let rod = Rod { start: [amplitude, 0.5], noise: 0.01, ..clean() };
        let fit = rod.fit().expect("a fit");
        let [angle, rate] = [fit.angle(3.0), fit.rate(3.0)].map(|x| x.expect("a time"));
        let rate = rate - fit.offset().value;
        let closed = |length: f64| {
            let gravity = GRAVITY / length;
            let unit = Suspension { moment: 1.0, mass: 1.0, gravity, lever: 1.0 };
            Pendulum::new(unit, angle, rate).expect("a pendulum")
        };
        let [right, damaged] = apart(&fit, |length, t| {
            let state = closed(length).at(t).expect("a time");
            [state.theta, state.omega]
        });
        println!("closed form: {right:e}, damaged {damaged:e}");
        assert!(right < 1e-8 && damaged > 1e-6, "{right:e} {damaged:e}");
        let closed = closed(fit.length(GRAVITY).expect("gravity").value);
        assert!((fit.period().value / closed.period() - 1.0).abs() < 1e-12);
        let small = core::f64::consts::TAU / closed.small_swing_frequency();
        assert!((fit.small_period().value / small - 1.0).abs() < 1e-12);
        assert!((fit.amplitude().value - closed.amplitude().expect("a swing")).abs() < 1e-12);
    }
    for (linear, quadratic) in [(0.1, 0.0), (0.0, 0.1), (0.1, 0.1)] {
        let rod = Rod { linear, quadratic, noise: 0.01, ..clean() };
        let fit = rod.fit().expect("a fit");
        let [angle, rate] = [fit.angle(3.0), fit.rate(3.0)].map(|x| x.expect("a time"));
        let offset = fit.offset().value;
        let [linear, quadratic] =
            [fit.linear(), fit.quadratic()].map(|damping| damping.map_or(0.0, |d| d.value));
        let stepped = |length: f64| {
            let slowed = second_order(move |_, angle, rate: f64| {
                -GRAVITY / length * angle.sin() - (linear + quadratic * rate.abs()) * rate
            });
            let method = Dop853::new(1e-12).expect("a tolerance");
            method.solve(&slowed, 0.0, &[angle, rate - offset], 7.9, &[]).expect("a run")
        };
        let [right, damaged] = apart(&fit, |length, t| stepped(length).at(t).expect("a time"));
        println!("DOP853: {right:e}, damaged {damaged:e}");
        assert!(right < 1e-8 && damaged > 1e-6, "{right:e} {damaged:e}");
        // What the energy loses is the work of the dampings, by Simpson's rule.
        let square = GRAVITY / fit.length(GRAVITY).expect("gravity").value;
        let rate = |t: f64| fit.rate(3.0 + t).expect("a time") - offset;
        let energy =
            |t: f64| 0.5 * rate(t) * rate(t) - square * fit.angle(3.0 + t).expect("a time").cos();
        let power = |t: f64| (linear + quadratic * rate(t).abs()) * rate(t) * rate(t);
        let h = 7.9 / 4000.0;
        let third = |k: u32| {
            let t = h * f64::from(k);
            h / 6.0 * (power(t) + 4.0 * power(t + 0.5 * h) + power(t + h))
        };
        let lost = energy(0.0) - energy(7.9);
        let work: f64 = (0..4000).map(third).sum();
        println!("energy: {:e}", work / lost - 1.0);
        assert!((work / lost - 1.0).abs() < 1e-8, "{work} {lost}");
    }
}

/// A recording of a rod that lies, is lifted, held, let go, swings, is stopped and rests: times, rates, and
/// from when to when it swings.
fn course(rod: &Rod, random: &mut Random) -> (Vec<f64>, Vec<DesignVector>, [f64; 2]) {
    let [lies, lift, hold] =
        [(0.3, 3.0), (0.6, 2.0), (0.2, 1.5)].map(|(a, b)| random.between(a, b));
    // A hand that takes as long as the swing itself to slow down cannot be told from it.
    let [stop, rests] = [(0.1, 0.2), (0.3, 3.0)].map(|(a, b)| random.between(a, b));
    let lifted = lies + lift;
    let [from, to] = [lifted + hold, lifted + hold + rod.seconds];
    let last = rod.after(rod.start, rod.seconds)[1];
    let axis: [f64; 3] = random.vector();
    let axis = DesignVector::from(axis);
    let axis = axis / axis.norm();
    let offset = DesignVector::from(random.vector().map(|x: f64| 0.05 * x));
    let tremor = random.between(0.0, 0.06);
    let (mut times, mut rates, mut state, mut now) = (Vec::new(), Vec::new(), rod.start, from);
    for k in 0..((to + stop + rests) / rod.step) as u32 {
        let t = rod.step * (f64::from(k) + rod.jitter * random.unit());
        let rate = if t < lies || t >= to + stop {
            0.0
        } else if t < lifted {
            rod.start[0] / lift * (1.0 - (core::f64::consts::TAU * (t - lies) / lift).cos())
        } else if t < from {
            tremor * ((31.0 * t).sin() + (47.0 * t).sin())
        } else if t < to {
            (state, now) = (rod.after(state, t - now), t);
            state[1]
        } else {
            last * (0.5 * core::f64::consts::PI * (t - to) / stop).cos()
        };
        // A hand turns it about other axes too.
        let hand = if t < lies || (from..to).contains(&t) || t >= to + stop { 0.0 } else { tremor };
        let noise = |hand: f64| {
            let normal = (0..12).map(|_| random.unit()).sum::<f64>() - 6.0;
            hand * (20.0 * t).sin() + rod.noise * normal
        };
        times.push(3.0 + t);
        rates.push(axis * rate + offset + DesignVector::from([hand, -hand, 0.0].map(noise)));
    }
    (times, rates, [3.0 + from, 3.0 + to])
}

#[test]
fn the_piece_that_swings_is_found() {
    let mut random = Random(12);
    // Each takes as long as two that are a swing alone.
    let (swings, mut held, mut least) = (often() / 2, 0, 1.0_f64);
    for n in 0..swings {
        let amplitude = random.size(5.0, 170.0).to_radians();
        let mut rod = Rod { start: [amplitude, 0.0], ..Rod::drawn(&mut random) };
        rod.noise = rod.noise.min(0.02);
        rod.seconds = random.between(8.0, 10.0);
        rod.linear = [0.0, 0.03][n as usize % 2];
        rod.quadratic = [0.0, 0.0, 0.03][n as usize % 3];
        let (times, rates, [from, to]) = course(&rod, &mut random);
        let what = format!("{n}: {rod:?}, {amplitude} from {from} to {to}");
        let found = Swing::find(&times, &rates).expect(&what);
        let [first, last] = found.between;
        assert!(first >= from && last <= to, "{what}: {found}");
        let part = (last - first) / (to - from);
        least = least.min(part);
        let piece = |k: std::ops::Range<usize>| (times[k.clone()].to_vec(), rates[k].to_vec());
        let (times, rates) = piece(found.samples);
        assert!(times[0] == first && times[times.len() - 1] == last);
        let fit = Swing::of_sensor(times, rates).expect(&what).fit().expect(&what);
        held += u32::from(fit.length(GRAVITY).expect("gravity").holds(rod.length));
    }
    assert!(swings >= 20);
    println!("of {swings}: {held} held, at least {least} of each");
    assert_part("length", held, swings, [0.92, 0.99]);
    assert!(least > 0.8, "{least}");
}

#[test]
fn a_sensor_tells_the_hinge() {
    let rod = Rod { noise: 0.01, linear: 0.05, ..clean() };
    let (times, rates) = rod.recorded(&mut Random(5));
    let axis = DesignVector::new(-0.36, 0.48, 0.8);
    let across = DesignVector::new(0.8, 0.6, 0.0);
    let told = [0.0, 0.1].map(|wobble| {
        let mut random = Random(6);
        let seen = rates.iter().map(|rate| {
            let noise = DesignVector::from(random.vector().map(|x: f64| 0.01 * x));
            axis * *rate + across * (wobble * rate * random.between(-1.7, 1.7)) + noise
        });
        let swing = Swing::of_sensor(times.clone(), seen.collect()).expect("a swing");
        let hinge = swing.hinge().expect("three rates");
        assert!((hinge.axis - axis).norm() < 0.01, "{:?}", hinge.axis);
        let length = swing.fit().expect("a fit").length(GRAVITY).expect("gravity");
        assert!((length.value / rod.length - 1.0).abs() < 0.01);
        hinge.wobble
    });
    assert!(told[0] < 0.01 && (told[1] - 0.1).abs() < 0.01, "{told:?}");
    assert!(Swing::new(times, rates).expect("a swing").hinge().is_none());
}

#[test]
fn what_is_no_swing_is_refused() {
    let times: Vec<f64> = (0..800).map(|k| 0.01 * f64::from(k)).collect();
    let rates: Vec<f64> = times.iter().map(|t| (5.0 * t).sin()).collect();
    let made = |times: &[f64], rates: &[f64]| Swing::new(times.to_vec(), rates.to_vec())?.fit();
    let (mut back, mut broken) = (times.clone(), rates.clone());
    back[7] = back[6];
    let mut endless = times.clone();
    endless[799] = f64::INFINITY;
    broken[3] = f64::INFINITY;
    let mut random = Random(2);
    let noise: Vec<f64> = times.iter().map(|_| random.between(-1.0, 1.0)).collect();
    let huge: Vec<f64> = rates.iter().map(|rate| 1e200 * rate).collect();
    // Over the top with 4 and, once, with 1.00002 times the energy that it takes.
    let [fast, slow] = [(2.0, 8.0), (1.00001, 2.0)].map(|(factor, seconds)| {
        let start = [0.0, factor * 2.0 * clean().frequency()];
        Rod { start, seconds, noise: 0.01, ..clean() }.fit()
    });
    let refused = [
        (made(&times[..19], &rates), "800 given"),
        (made(&times[..5], &rates[..5]), "samples: 5"),
        (made(&back, &rates), "later than 0.06"),
        (made(&times, &broken), "rates[3]"),
        (made(&times, &vec![0.0; 800]), "fastest rate"),
        (made(&times, &noise), "nothing swings here"),
        (made(&times, &huge), "no pendulum"),
        (made(&times[..60], &rates[..60]), "does not go to and fro"),
        (fast, "does not go to and fro"),
        (slow, "over the top"),
        (Rod { step: 0.22, seconds: 30.0, ..clean() }.fit(), "six are needed in a small swing"),
    ];
    // Lying still, and waved about.
    let still: Vec<_> = noise.iter().map(|w| DesignVector::new(0.01 * w, 0.02, 0.0)).collect();
    let waved: Vec<_> = (0..800).map(|_| DesignVector::from(random.vector())).collect();
    let part = |t: &f64| DesignVector::new((5.0 * t).sin() + (8.3 * t).sin(), 0.0, 0.0);
    let beating: Vec<_> = times.iter().map(part).collect();
    for (n, rates) in [still, waved, beating].into_iter().enumerate() {
        let told = Swing::find(&times, &rates).expect_err("no swing").to_string();
        println!("{told}");
        assert!(told.starts_with("nothing in this recording swings"), "{n}: {told}");
        assert!(told.contains("--from and --to"), "{n}: {told}");
    }
    let along = |rates: &[f64]| rates.iter().map(|w| DesignVector::new(*w, 0.0, 0.0)).collect();
    let find = |times: &[f64], rates: Vec<DesignVector>| Swing::find(times, &rates);
    let swings = |found: Result<Swinging, Error>| found.expect("a swing").to_string();
    assert_eq!(swings(find(&times, along(&rates))), "from 0.00 s to 7.99 s: 6.0 swings to and fro");
    for (refused, words) in [
        (find(&times[..19], along(&rates)), "800 given"),
        (find(&[], Vec::new()), "samples: 0"),
        (find(&times, along(&broken)), "rates[3]"),
        (find(&back, along(&rates)), "later than 0.06"),
        (find(&endless, along(&rates)), "times[799]"),
        (find(&times, along(&[0.0; 800])), "fastest rate"),
        (find(&times, along(&huge)), "nothing in this recording"),
    ] {
        let told = refused.expect_err(words).to_string();
        assert!(told.contains(words), "{told}");
    }
    for (n, (refused, words)) in refused.into_iter().enumerate() {
        let told = refused.map(|fit| fit.length(GRAVITY)).expect_err(words).to_string();
        println!("{told}");
        assert!(told.contains(words), "{n}: {told}: no '{words}'");
    }
}
