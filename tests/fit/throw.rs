//! Flights with a known truth: Euler's equations, stepped by Runge and Kutta's method with the drag and the
//! sensor's filter as equations besides: nothing of the closed form, by which they are fitted.

use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::fit::Flight;
use rotation_dynamics::frame::{BodyVector, DesignVector, SpaceVector};
use support::Random;

/// A body thrown up, and the sensor in it.
#[derive(Clone, Debug)]
pub struct Throw {
    pub moments: [f64; 3],
    pub start: [f64; 3],
    /// Rotation vector of the principal axes (rad).
    pub turn: [f64; 3],
    pub offset: [f64; 3],
    pub filter: f64,
    pub drag: f64,
    pub noise: f64,
    /// The step of the digits (rad/s).
    pub digit: f64,
    /// Samples a second.
    pub often: f64,
    /// By which part of itself a step of time varies.
    pub jitter: f64,
    pub samples: u32,
}

impl Throw {
    /// A box of the size of a phone, spun mostly about one axis; each correction in every second throw.
    pub fn drawn(random: &mut Random) -> Self {
        let [a, b, c] = [(0.13, 0.17), (0.06, 0.08), (0.006, 0.02)]
            .map(|(low, high)| random.between(low, high));
        let mut start: [f64; 3] = random.vector().map(|w: f64| 1.5 * w);
        start[(3.0 * random.unit()) as usize] += random.between(6.0, 14.0);
        let mut often = |size: f64| if random.unit() < 0.5 { 0.0 } else { size };
        let [turn, offset, filter, drag] = [often(0.35), often(0.1), often(0.02), often(0.1)];
        Self {
            moments: [b * b + c * c, a * a + c * c, a * a + b * b],
            start,
            turn: random.vector().map(|x: f64| 0.57 * turn * x),
            offset: random.vector().map(|x: f64| offset * x),
            filter: filter * random.between(0.2, 1.0),
            drag: drag * random.unit(),
            noise: random.between(0.005, 0.03),
            digit: random.between(0.001, 0.02),
            often: 100.0,
            jitter: 0.2,
            samples: random.between(50.0, 120.0) as u32,
        }
    }

    /// A phone that is thrown about its middle axis, and seen without noise.
    pub fn clean() -> Self {
        Self {
            moments: [1.0, 4.0, 4.8],
            start: [0.4, 9.0, 0.5],
            turn: [0.0; 3],
            offset: [0.0; 3],
            filter: 0.0,
            drag: 0.0,
            noise: 0.0,
            digit: 0.0,
            often: 100.0,
            jitter: 0.0,
            samples: 80,
        }
    }

    /// The rate of change of the rates and of what the filter shows.
    fn slope(&self, [w, y]: [[f64; 3]; 2]) -> [[f64; 3]; 2] {
        let m = self.moments;
        let change = |i: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            (m[j] - m[k]) / m[i] * w[j] * w[k] - self.drag * w[i]
        };
        let shown = |i: usize| if self.filter > 0.0 { (w[i] - y[i]) / self.filter } else { 0.0 };
        [[0, 1, 2].map(change), [0, 1, 2].map(shown)]
    }

    /// Times and rates, from a quarter of a second after the throw.
    pub fn table(&self, random: &mut Random) -> (Vec<f64>, Vec<DesignVector>) {
        let turn = Attitude::from_rotation_vector(SpaceVector::from(self.turn)).expect("a turn");
        let moved = |[w, y]: [[f64; 3]; 2], [dw, dy]: [[f64; 3]; 2], h: f64| {
            [[0, 1, 2].map(|i| w[i] + h * dw[i]), [0, 1, 2].map(|i| y[i] + h * dy[i])]
        };
        let mut state = [self.start; 2];
        let (mut times, mut rates) = (Vec::new(), Vec::new());
        let mut t = 0.0;
        // Steps of half a millisecond at most: an error of (15 x 0.0005)^4/120, 3e-11 of the rates a turn.
        let steps = (2000.0 / self.often).ceil();
        let before = (0.25 * self.often) as u32;
        for sample in 0..before + self.samples {
            if sample >= before {
                let shown = if self.filter > 0.0 { state[1] } else { state[0] };
                let shown = turn.to_space(BodyVector::from(shown)).to_array();
                times.push(t);
                rates.push(DesignVector::from([0, 1, 2].map(|i| {
                    // Twelve even numbers less six: nearly a normal one.
                    let normal = (0..12).map(|_| random.unit()).sum::<f64>() - 6.0;
                    let seen = shown[i] + self.offset[i] + self.noise * normal;
                    if self.digit > 0.0 { (seen / self.digit).round() * self.digit } else { seen }
                })));
            }
            let step = (1.0 + self.jitter * (random.unit() - 0.5)) / self.often;
            let h = step / steps;
            for _ in 0..steps as u32 {
                let a = self.slope(state);
                let b = self.slope(moved(state, a, 0.5 * h));
                let c = self.slope(moved(state, b, 0.5 * h));
                let d = self.slope(moved(state, c, h));
                let sum = moved(moved(moved(a, b, 2.0), c, 2.0), d, 1.0);
                state = moved(state, sum, h / 6.0);
            }
            t += step;
        }
        (times, rates)
    }

    pub fn recorded(&self, random: &mut Random) -> Flight {
        let (times, rates) = self.table(random);
        Flight::new(times, rates).expect("a flight")
    }

    pub fn ratio(&self, i: usize, j: usize) -> f64 {
        self.moments[i] / self.moments[j]
    }
}
