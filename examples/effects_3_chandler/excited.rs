//! The wobble that fades, is pushed, and beats with the year.

use super::*;
use rotation_dynamics::integrators::after;

/// A Julian year, d.
pub const YEAR: f64 = 365.25;
/// From one push to the next, d.
pub const MONTH: f64 = 30.0;

/// A complex number: a point of the ground near the pole, towards Greenwich and towards 90° east,
/// or what turns and stretches it.
pub type Plane = [f64; 2];

pub fn times_complex([a, b]: Plane, [c, d]: Plane) -> Plane {
    [a * c - b * d, a * d + b * c]
}

pub fn sum([a, b]: Plane, [c, d]: Plane) -> Plane {
    [a + c, b + d]
}

pub fn difference(u: Plane, [c, d]: Plane) -> Plane {
    sum(u, [-c, -d])
}

/// exp(i rate t) for a complex rate.
fn turned([rate, decay]: Plane, t: f64) -> Plane {
    let ((s, c), size) = (sincos(rate * t), exp(-decay * t));
    [size * c, size * s]
}

/// Numbers that are random enough, and the same for the same seed everywhere.
struct Dice(u64);

impl Dice {
    fn new(seed: f64) -> Self {
        Self(seed.to_bits() ^ 0x9E37_79B9_7F4A_7C15)
    }

    /// Between 0 and 1: a counter, well stirred (splitmix64).
    fn even(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let stirred = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let stirred = (stirred ^ (stirred >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        let top = (stirred ^ (stirred >> 31)) >> 11;
        (top as f64 + 0.5) / (1_u64 << 53) as f64
    }

    /// Two that are normally distributed, with the mean square 1.
    fn pair(&mut self) -> Plane {
        let size = (-2.0 * log(self.even())).sqrt();
        let (s, c) = sincos(TAU * self.even());
        [size * c, size * s]
    }
}

/// A wobble that weather and water keep up. Lengths in seconds of arc, times in days.
pub struct Excited {
    /// rate and decay of the free wobble, 1/d
    pub rate: Plane,
    /// the monthly pushes, root mean square of each component
    pub push: f64,
    p: Parameters,
    /// each month's push, and where the pole is at its beginning, without the yearly part
    months: Vec<[Plane; 2]>,
}

/// Months of the motion that is kept: 150 years.
const MONTHS: usize = 1827;

impl Excited {
    /// The wobble of the whole Earth, which starts with its usual size.
    pub fn new(p: &Parameters) -> Result<Self> {
        let period = WHOLE.period(p)? * p.day / DAY;
        let quality = 0.5 * p.fluid * (1.0 - WHOLE.following(p)?) / p.loss;
        let rate = [TAU / period, 0.5 * TAU / (period * quality)];
        // Months of pushes e add up to |1 - q|^2 <e^2>/(1 - |q|^2), q the wobble of a month.
        let month = turned(rate, MONTH);
        let kept = 1.0 - exp(-2.0 * rate[1] * MONTH);
        let [x, y] = difference([1.0, 0.0], month);
        let push = p.wobble * (0.5 * kept / (x * x + y * y)).sqrt();
        let mut excited = Self { rate, push, p: p.clone(), months: Vec::new() };
        let (mut dice, mut at) = (Dice::new(p.seed), [p.wobble, 0.0]);
        for _ in 0..MONTHS {
            let pushed = dice.pair().map(|x| x * push);
            excited.months.push([pushed, at]);
            at = excited.pushed(at, pushed, MONTH);
        }
        Ok(excited)
    }

    // ANCHOR: excited
    /// Where the pole goes in a time from `from`, the axis of the figure pushed to `to`: it
    /// winds about that, and comes nearer.
    fn pushed(&self, from: Plane, to: Plane, time: f64) -> Plane {
        sum(to, times_complex(turned(self.rate, time), difference(from, to)))
    }

    /// The pole of rotation after so many days.
    pub fn at(&self, t: f64) -> Plane {
        let (s, c) = sincos(TAU * t / YEAR);
        sum(self.wobbling(t), [self.p.annual * c, self.p.annual * s])
    }

    /// The same without its yearly part.
    pub fn wobbling(&self, t: f64) -> Plane {
        let month = ((t / MONTH) as usize).min(MONTHS - 1);
        let [push, at] = self.months[month];
        self.pushed(at, push, t - MONTH * month as f64)
    }
    // ANCHOR_END: excited

    /// The equation m' = i sigma (m - e), pushed to a place e that the year and the months
    /// move, stepped.
    pub fn stepped(&self, end: f64) -> Result<Plane> {
        let [rate, decay] = self.rate;
        let yearly = TAU / YEAR;
        // i sigma e makes the yearly part of the pole go round with the year.
        let forced = difference([0.0, yearly], [-decay, rate]);
        let mut state = [self.p.wobble + self.p.annual, 0.0];
        for (month, &[push, _]) in self.months.iter().enumerate() {
            let from = month as f64 * MONTH;
            if from >= end {
                break;
            }
            let law = ode(move |t, m: &[f64; 2]| {
                let (s, c) = sincos(yearly * (from + t));
                let year = times_complex(forced, [self.p.annual * c, self.p.annual * s]);
                sum(times_complex([-decay, rate], difference(*m, push)), year)
            });
            let law = law.scaled(|_| [self.p.wobble; 2]);
            state = after((end - from).min(MONTH), &law, &state, 1e-13)?;
        }
        Ok(state)
    }

    /// From one largest distance of the pole to the next, in years, located on the path
    /// without pushes and without loss.
    pub fn located_beat(&self) -> Result<f64> {
        let (rate, yearly) = (self.rate[0], TAU / YEAR);
        let rates = move |&[x, y, u, v]: &[f64; 4]| [-rate * y, rate * x, -yearly * v, yearly * u];
        let law = ode(move |_, m: &[f64; 4]| rates(m)).scaled(|_| [0.1; 4]);
        let outward = |m: &[f64; 4]| {
            let v = rates(m);
            (m[0] + m[2]) * (v[0] + v[2]) + (m[1] + m[3]) * (v[1] + v[3])
        };
        let start = [self.p.wobble, 0.0, self.p.annual, 0.0];
        let (back, _) = Dop853::new(1e-13)?.zero(&law, start, 2, 1e5, outward)?;
        Ok(back.t / YEAR)
    }

    /// The size of the wobble, root mean square, under pushes for a thousand fading times.
    pub fn kept_up(&self) -> f64 {
        let mut dice = Dice::new(self.p.seed + 1.0);
        let (mut m, mut squares) = ([self.p.wobble, 0.0], 0.0);
        let months = (1000.0 / (self.rate[1] * MONTH)) as usize;
        for _ in 0..months {
            m = self.pushed(m, dice.pair().map(|x| x * self.push), MONTH);
            squares += m[0] * m[0] + m[1] * m[1];
        }
        (squares / months as f64).sqrt()
    }
}
