//! A fit of a pendulum to the rate about its hinge: what is true is found, with the error that is stated.
//!
//! The swings are made by Runge and Kutta's method: nothing of the closed form, and nothing of the
//! integrator, by which they are fitted.
//!
//! ```text
//! SWINGS=5000 cargo test --package checks --test swing -- --nocapture
//! ```

use rotation_dynamics::fit::{Estimate, Swing, SwingFit};
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::integrators::{GaussLegendre, Integrator, second_order};
use support::Random;

const GRAVITY: f64 = 9.81;

/// A pendulum, and how it is recorded.
#[derive(Clone, Copy)]
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

    fn fit(&self, random: &mut Random) -> SwingFit {
        let (times, rates) = self.recorded(random);
        Swing::new(times, rates).expect("a swing").fit().expect("a fit")
    }

    fn amplitude(&self) -> f64 {
        let [angle, rate] = self.start;
        let half = (0.5 * angle).sin();
        2.0 * (half * half + 0.25 * rate * rate / self.frequency().powi(2)).sqrt().asin()
    }
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

fn asked() -> u32 {
    std::env::var("SWINGS").map_or(500, |text| text.parse().expect("a number"))
}

#[test]
fn the_interval_holds_what_is_true_in_95_of_100_swings() {
    let mut random = Random(11);
    let swings = asked();
    // Length, amplitude, offset, linear, quadratic.
    let (mut held, mut told, mut damaged) = ([0; 5], [0; 5], 0);
    // Of each damping: present, called for; absent, called for.
    let mut called = [[0; 4]; 2];
    let began = std::time::Instant::now();
    let mut spent = 0.0; let mut z2 = [0.0; 5];
    for n in 0..swings {
        let rod = Rod::drawn(&mut random);
        let (times, rates) = rod.recorded(&mut random);
        let t0 = began.elapsed().as_secs_f64();
        let fit = Swing::new(times, rates).expect("a swing").fit();
        spent += began.elapsed().as_secs_f64() - t0;
        let fit = match fit { Ok(f) => f, Err(e) => { println!("{n}: {e} A {} L {} s {}", rod.amplitude(), rod.length, rod.seconds); continue } };
        let length = fit.length(GRAVITY).expect("gravity");
        damaged += u32::from(length.holds(1.005 * rod.length));
        let estimates = [
            (Some(length), rod.length),
            (Some(fit.amplitude()), rod.amplitude()),
            (Some(fit.offset()), rod.offset),
            (fit.linear(), rod.linear),
            (fit.quadratic(), rod.quadratic),
        ];
        for (k, (estimate, value)) in estimates.into_iter().enumerate() {
            if let Some(e) = estimate { z2[k] += (1.96 * 2.0 * (e.value - value) / (e.to - e.from)).powi(2); }
            told[k] += u32::from(estimate.is_some());
            held[k] += u32::from(estimate.is_some_and(|estimate| estimate.holds(value)));
        }
        for ((decision, value), called) in
            fit.decisions().iter().zip([rod.linear, rod.quadratic]).zip(&mut called)
        {
            let at = if value > 0.0 { 0 } else { 2 };
            called[at] += 1;
            called[at + 1] += u32::from(decision.needed);
            if decision.needed != (value > 0.0) {
                println!("{n}: {decision:?} lin {} quad {} A {} f {} noise {}", rod.linear, rod.quadratic, rod.amplitude(), rod.frequency(), rod.noise);
            }
        }
    }
    println!("{spent} s z2 {:?}", z2.map(|z| z / f64::from(swings)));
    println!("of {swings}: told {told:?}, held {held:?}, damaged {damaged}, called for {called:?}");
}
