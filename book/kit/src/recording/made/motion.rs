//! The motions of recordings that are made up.

use super::Random;
use crate::error::Result;
use core::f64::consts::{PI, TAU};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::{exp, expm1, sin};

/// What a phone does.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// Some throws: each time it lies, is handled, thrown, caught, laid down.
    Throws {
        /// The principal moments, in any unit.
        moments: [f64; 3],
        /// The rates on the principal axes at each release (rad/s).
        releases: Vec<[f64; 3]>,
        /// How long each flight is (s).
        flight: f64,
        /// dL/dt = -drag L in flight (1/s).
        drag: f64,
    },
    /// It swings about its z axis: angle'' + linear angle' + quadratic |angle'| angle' + gravity/length sin(angle) = 0.
    Swing {
        /// The length of the equivalent simple pendulum (m).
        length: f64,
        /// m/s^2
        gravity: f64,
        /// Where it is let go (rad).
        amplitude: f64,
        /// 1/s
        linear: f64,
        /// 1
        quadratic: f64,
        /// s
        duration: f64,
    },
    /// It lies for this long (s).
    Rest(f64),
}

impl Default for Motion {
    fn default() -> Self {
        let [moments, release] = [[1.0, 4.1, 4.8], [0.6, 9.0, 0.5]];
        Self::Throws { moments, releases: vec![release], flight: 0.8, drag: 0.0 }
    }
}

/// When a throw's flight begins, after 0.4 s of rest and 0.8 s of handling (s).
const RELEASE: f64 = 1.2;
const HANDLING: f64 = 0.8;

/// For how long the hand gives the rates of the flight (s).
const PUSH: f64 = 0.25;

/// From the catch to the next throw (s).
const AFTER: f64 = 0.8;

/// How soon what a catch does fades (s).
const FADES: f64 = 0.05;

impl Motion {
    /// How long it is (s).
    pub fn duration(&self) -> f64 {
        match self {
            Self::Throws { releases, flight, .. } => {
                releases.len() as f64 * (RELEASE + flight + AFTER)
            }
            Self::Swing { duration, .. } | Self::Rest(duration) => *duration,
        }
    }

    /// From when to when the phone is in flight (s), throw by throw.
    pub fn flights(&self) -> Vec<[f64; 2]> {
        match self {
            Self::Throws { releases, flight, .. } => {
                let begin = |n: usize| n as f64 * (RELEASE + flight + AFTER) + RELEASE;
                (0..releases.len()).map(|n| [begin(n), begin(n) + flight]).collect()
            }
            Self::Swing { .. } | Self::Rest(_) => Vec::new(),
        }
    }

    /// How much of its weight is carried: 1 in the hand, 0 in flight. The hand lets go within 20 ms, and
    /// a catch takes four times the weight.
    pub(super) fn held(&self, t: f64) -> f64 {
        let held = |[begin, end]: [f64; 2]| match t {
            _ if t < begin => ((begin - t) / 0.02).min(1.0),
            _ if t < end => 0.0,
            _ => 1.0 + 3.0 * exp(-(t - end) / FADES),
        };
        self.flights().into_iter().map(held).fold(1.0, |a, b| if b == 0.0 { b } else { a * b })
    }

    /// The rates on the principal axes at times that ascend.
    pub(super) fn rates<'a>(
        &'a self,
        random: &mut Random,
    ) -> Result<Box<dyn FnMut(f64) -> [f64; 3] + 'a>> {
        Ok(match self {
            Self::Rest(_) => Box::new(|_| [0.0; 3]),
            Self::Swing { length, gravity, amplitude, linear, quadratic, .. } => {
                let slope = move |[angle, rate]: [f64; 2]| {
                    let damping = linear * rate + quadratic * rate.abs() * rate;
                    [rate, -damping - gravity / length * sin(angle)]
                };
                let (mut at, mut state) = (0.0, [*amplitude, 0.0]);
                Box::new(move |t| {
                    state = stepped(state, t - at, slope);
                    at = t;
                    [0.0, 0.0, state[1]]
                })
            }
            Self::Throws { moments: [a, b, c], releases, flight, drag } => {
                let moments = PrincipalMoments::new(*a, *b, *c)?;
                let throw = |release: &[f64; 3]| -> Result<Throw> {
                    let body = FreeBody::new(moments, Attitude::IDENTITY, (*release).into())?;
                    Ok(Throw { flight: *flight, drag: *drag, ..Throw::shaken(body, random) })
                };
                let throws = releases.iter().map(throw).collect::<Result<Vec<_>>>()?;
                let length = RELEASE + flight + AFTER;
                Box::new(move |t| {
                    let n = ((t / length).max(0.0) as usize).min(throws.len().saturating_sub(1));
                    throws
                        .get(n)
                        .map_or([0.0; 3], |throw| throw.rates(t - n as f64 * length - RELEASE))
                })
            }
        })
    }
}

/// A step of Runge and Kutta.
fn stepped(y: [f64; 2], h: f64, slope: impl Fn([f64; 2]) -> [f64; 2]) -> [f64; 2] {
    let along = |k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
    let a = slope(y);
    let b = slope(along(a, 0.5 * h));
    let c = slope(along(b, 0.5 * h));
    let d = slope(along(c, h));
    [0, 1].map(|i| y[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]))
}

/// A throw, at t = 0 at the release.
struct Throw {
    body: FreeBody,
    flight: f64,
    drag: f64,
    /// By axis: amplitude (rad/s), frequency (1/s) and phase of the handling.
    handling: [[[f64; 3]; 3]; 3],
    /// The same of the jolt at the catch.
    jolt: [[[f64; 3]; 3]; 3],
}

impl Throw {
    fn shaken(body: FreeBody, random: &mut Random) -> Self {
        let mut waves = |amplitude: f64, least: f64, most: f64| {
            [(); 3].map(|()| {
                [(); 3].map(|()| {
                    [
                        random.between(-amplitude, amplitude),
                        random.between(least, most),
                        random.between(0.0, TAU),
                    ]
                })
            })
        };
        let handling = waves(1.5, 0.5, 4.0);
        let jolt = waves(6.0, 12.0, 30.0);
        Self { body, flight: 0.0, drag: 0.0, handling, jolt }
    }

    /// The free rates, with drag: the same way, more and more slowly.
    fn free(&self, t: f64) -> [f64; 3] {
        let (own, slow) = match self.drag * t {
            0.0 => (t, 1.0),
            x => (-t * expm1(-x) / x, exp(-x)),
        };
        self.body.angular_velocity(own).to_array().map(|w| slow * w)
    }

    fn rates(&self, t: f64) -> [f64; 3] {
        let wave = |waves: &[[f64; 3]; 3]| -> f64 {
            waves.iter().map(|[a, f, phase]| a * sin(TAU * f * t + phase)).sum()
        };
        if t < 0.0 {
            // The hand gives ever more of the free rates, and its torque ends smoothly.
            let x = (1.0 + t / PUSH).max(0.0);
            let given = x * x * (3.0 - 2.0 * x);
            let free = if x > 0.0 { self.free(t) } else { [0.0; 3] };
            let shake = sin(PI * (t / HANDLING).max(-1.0));
            return [0, 1, 2].map(|i| given * free[i] + shake * shake * wave(&self.handling[i]));
        }
        if t < self.flight {
            return self.free(t);
        }
        let u = t - self.flight;
        let fades = exp(-u / FADES);
        let last = self.free(self.flight);
        // The jolt begins at 0.
        let begins = -expm1(-u / 0.005);
        [0, 1, 2].map(|i| fades * (last[i] + begins * wave(&self.jolt[i])))
    }
}
