//! The problems: a motion, the time at which it is asked for, and the attitude then.
//!
//! The attitudes at the end are those of `oracle`, a closed form at 60 digits that
//! shares no code with this library: nobody in a race is the judge of it.
//!
//! No motion ends on a whole period. There it is symmetric in time, the error that a
//! symmetric method makes in the energy cancels, and the method looks better than it is.
//! So they end a third of a period later; the fast top after one precession, which is no
//! whole number of nods; the flips in the middle of a flip, where the attitude is most
//! sensitive.
//!
//! Motions without a closed form: [`open`].

#![allow(clippy::excessive_precision, reason = "the oracle's digits, as it gave them")]

use crate::open::{self, OPEN, Under, no_closed_form};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{Kinematics, RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop, Start};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};

/// What moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// A free body with these moments, rates on the body axes, unturned at first.
    Free { moments: [f64; 3], rates: [f64; 3] },
    /// The notes' reduced top: I1 = 1, I3 = a, m g l = c, time in units of t'.
    Top { a: f64, b: f64, c: f64, from: Begin },
    /// A body with these moments and rates, from [`open::LYING`], under what has no closed form.
    Open { moments: [f64; 3], rates: [f64; 3], under: Under },
}

/// How a top starts, at phi = zeta = 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Begin {
    /// At its smaller turning angle with the energy E~.
    Energy(f64),
    /// At this angle, at rest in theta.
    Rest(f64),
}

/// A problem.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Problem {
    /// Its name in the record: `[a-z_]+`.
    pub key: &'static str,
    /// What it is.
    pub title: &'static str,
    /// What moves.
    pub motion: Motion,
    /// Whether the variables are theta, phi and zeta, which meet the pole.
    pub angles: bool,
    /// One period of the rates, or of nutation.
    pub period: f64,
    /// The time that is asked for.
    pub end: f64,
    /// w, x, y, z at the end, to 20 digits.
    pub oracle: [f64; 4],
}

const NOTES: Problem = Problem {
    key: "heavy_top",
    title: "heavy top of the notes (a = 2, b = 1.2, c = 0.2, E~ = 0.55), 1000 1/3 nutations",
    motion: Motion::Top { a: 2.0, b: 1.2, c: 0.2, from: Begin::Energy(0.55) },
    angles: false,
    period: 3.870867767209271,
    end: 3872.1580564650076,
    oracle: [
        -0.304_428_402_185_344_091_84,
        -0.055_100_437_114_933_822_026,
        0.435_363_890_227_399_795_58,
        0.845_426_266_955_721_094_06,
    ],
};

const POLE: Problem = Problem {
    key: "pole",
    title: "heavy top that passes 1e-4 rad from the pole, 1000 1/3 nutations",
    motion: Motion::Top { a: 2.0, b: 1.0000741569847473, c: 0.2, from: Begin::Rest(1e-4) },
    angles: false,
    period: 3.7567162472243294,
    end: 3757.9684859734043,
    oracle: [
        0.823_142_906_930_131_114_4,
        0.145_981_258_029_337_393_66,
        0.535_843_973_916_077_340_92,
        -0.118_306_646_865_726_649_33,
    ],
};

/// All problems with a closed form, in the order of their record.
pub const PROBLEMS: [Problem; 7] = [
    Problem {
        key: "free_body",
        title: "free body, I = (1, 2, 8/3), L = (0.8, 0.8, 0.9), 1000 1/3 periods of its rates",
        motion: Motion::Free { moments: [1.0, 2.0, 8.0 / 3.0], rates: [0.8, 0.4, 0.3375] },
        angles: false,
        period: 14.690133265961897,
        end: 14695.029977050552,
        oracle: [
            0.733_018_762_074_257_112_89,
            0.277_600_690_418_804_694_98,
            -0.617_568_858_492_532_884_84,
            0.065_038_881_804_321_410_263,
        ],
    },
    NOTES,
    Problem {
        key: "heavy_top_angles",
        title: "the same in theta, phi and zeta",
        angles: true,
        ..NOTES
    },
    Problem {
        key: "fast_top",
        title: "fast top, c = 1e-4, released at theta = 1 (cusps), one precession: 19998.4 nutations",
        motion: Motion::Top { a: 2.0, b: 0.5403023058681398, c: 1e-4, from: Begin::Rest(1.0) },
        angles: false,
        period: 4.443122984004142,
        end: 88855.25851305545,
        oracle: [
            0.726_397_322_454_200_175_8,
            0.396_857_656_886_388_797_33,
            -0.269_041_631_782_524_840_47,
            0.492_409_921_173_213_522_71,
        ],
    },
    POLE,
    Problem { key: "pole_angles", title: "the same in theta, phi and zeta", angles: true, ..POLE },
    Problem {
        key: "flips",
        title: "free body from 1e-4 rad off the intermediate axis, to the middle of its tenth flip",
        motion: Motion::Free { moments: [1.0, 2.0, 8.0 / 3.0], rates: [1e-4, 1.0, 0.0] },
        angles: false,
        period: 83.88050342238517,
        end: 398.4323912563296,
        oracle: [
            0.693_153_055_478_742_960_59,
            -0.682_496_697_106_283_394_24,
            -0.139_787_268_625_812_009_72,
            0.184_923_280_442_544_109_45,
        ],
    },
];

/// A motion in closed form.
#[derive(Debug, Clone)]
pub enum Exact {
    /// Of a free body.
    Free(Box<FreeBody>),
    /// Of a top.
    Top(Box<HeavyTop>),
}

impl Exact {
    /// The attitude at time `t`.
    pub fn attitude(&self, t: f64) -> Attitude {
        match self {
            Self::Free(body) => body.attitude(t),
            Self::Top(top) => top.attitude(t),
        }
    }

    /// The attitude and the rates at time `t`.
    pub fn kinematics(&self, t: f64) -> Kinematics {
        match self {
            Self::Free(body) => body.kinematics(t),
            Self::Top(top) => top.kinematics(t),
        }
    }
}

impl Problem {
    /// The problem of this name.
    pub fn named(key: &str) -> Option<&'static Self> {
        let mut all = PROBLEMS.iter().chain(&OPEN);
        all.find(|problem| problem.key == key)
    }

    /// The closed form, set up.
    ///
    /// # Errors
    /// A motion that has none.
    pub fn exact(&self) -> Result<Exact> {
        match self.motion {
            Motion::Free { moments, rates } => {
                let [i1, i2, i3] = moments;
                let moments = PrincipalMoments::new(i1, i2, i3)?;
                let rates = BodyVector::from_array(rates);
                let body = FreeBody::new(moments, Attitude::IDENTITY, rates)?;
                Ok(Exact::Free(Box::new(body)))
            }
            Motion::Top { a, b, c, from } => {
                let top = ReducedTop::new(a, b, c)?;
                let top = match from {
                    Begin::Energy(energy) => {
                        HeavyTop::from_energy(top, energy, Start::ThetaMin, 0.0, 0.0)?
                    }
                    Begin::Rest(theta) => HeavyTop::from_angles(top, theta, 0.0, 0.0, 0.0)?,
                };
                Ok(Exact::Top(Box::new(top)))
            }
            Motion::Open { .. } => Err(no_closed_form()),
        }
    }

    /// Moments of inertia.
    pub fn moments(&self) -> [f64; 3] {
        match self.motion {
            Motion::Free { moments, .. } | Motion::Open { moments, .. } => moments,
            Motion::Top { a, .. } => [1.0, 1.0, a],
        }
    }

    /// The body and its state at the start.
    ///
    /// # Errors
    /// None for the problems of this file.
    pub fn start(&self) -> Result<(RigidBody, State)> {
        if let Motion::Open { moments, rates, .. } = self.motion {
            return open::start(moments, rates);
        }
        let [i1, i2, i3] = self.moments();
        let body = RigidBody::new(PrincipalMoments::new(i1, i2, i3)?);
        let Kinematics { attitude, angular_velocity: rates } = self.exact()?.kinematics(0.0);
        Ok((body, body.state(attitude, rates)?))
    }

    /// The scene of a free body.
    ///
    /// # Errors
    /// For a top.
    pub fn free_scene(&self) -> Result<(Scene<()>, State)> {
        let (body, start) = self.start()?;
        match self.motion {
            Motion::Free { .. } => Ok((Scene::new(body), start)),
            Motion::Top { c, .. } => Err(other_kind(c)),
            Motion::Open { .. } => Err(no_closed_form()),
        }
    }

    /// The scene of a top.
    ///
    /// # Errors
    /// For a free body.
    pub fn top_scene(&self) -> Result<(Scene<((), GravityAtLever)>, State)> {
        let (body, start) = self.start()?;
        match self.motion {
            Motion::Top { c, .. } => {
                let weight = GravityAtLever::new(c, 1.0)?;
                Ok((Scene::new(body).with(weight), start))
            }
            Motion::Free { .. } => Err(other_kind(0.0)),
            Motion::Open { .. } => Err(no_closed_form()),
        }
    }

    /// How far `attitude` is from the oracle's at the end (rad).
    ///
    /// # Errors
    /// None for the problems of this file.
    pub fn error(&self, attitude: &Attitude) -> Result<f64> {
        Ok(attitude.angle_to(&Attitude::from_quaternion(self.oracle)?))
    }
}

fn other_kind(torque: f64) -> Error {
    Error::out_of_range("m g l", torque, "a free body has none, a top has some")
}
