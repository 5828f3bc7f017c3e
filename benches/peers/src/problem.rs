//! The problems: a motion, the time at which it is asked for, and the attitude then.
//!
//! The attitudes at the end are those of `oracle`, a closed form at 60 digits that
//! shares no code with this library: nobody in a race is the judge of it.

#![allow(
    clippy::excessive_precision,
    reason = "the oracle's digits, as it gave them"
)]

use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
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
    title: "heavy top of the notes (a = 2, b = 1.2, c = 0.2, E~ = 0.55), 1000 nutations",
    motion: Motion::Top {
        a: 2.0,
        b: 1.2,
        c: 0.2,
        from: Begin::Energy(0.55),
    },
    angles: false,
    period: 3.870867767209271,
    end: 3870.867767209271,
    oracle: [
        0.299_920_842_492_509_575_72,
        0.177_744_794_548_482_180_94,
        -0.019_313_776_400_651_293_868,
        0.937_059_898_987_597_679_6,
    ],
};

const POLE: Problem = Problem {
    key: "pole",
    title: "heavy top that passes 1e-4 rad from the pole, 1000 nutations",
    motion: Motion::Top {
        a: 2.0,
        b: 1.0000741569847473,
        c: 0.2,
        from: Begin::Rest(1e-4),
    },
    angles: false,
    period: 3.7567162472243294,
    end: 3756.7162472243294,
    oracle: [
        0.753_209_130_152_631_657_51,
        0.000_037_961_737_194_064_966_487,
        -0.000_032_540_843_675_685_660_261,
        -0.657_781_121_464_211_555_24,
    ],
};

/// All problems, in the order of the record.
pub const PROBLEMS: [Problem; 7] = [
    Problem {
        key: "free_body",
        title: "free body, I = (1, 2, 8/3), L = (0.8, 0.8, 0.9), 1000 periods of its rates",
        motion: Motion::Free {
            moments: [1.0, 2.0, 8.0 / 3.0],
            rates: [0.8, 0.4, 0.3375],
        },
        angles: false,
        period: 14.690133265961897,
        end: 14690.133265961897,
        oracle: [
            0.814_145_701_636_500_689_81,
            0.321_321_089_514_314_983_49,
            0.321_321_089_514_324_343_56,
            0.361_486_225_703_651_311_3,
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
        title: "fast top, c = 1e-4, released at theta = 1 (cusps), one precession: 19998 nutations",
        motion: Motion::Top {
            a: 2.0,
            b: 0.5403023058681398,
            c: 1e-4,
            from: Begin::Rest(1.0),
        },
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
    Problem {
        key: "pole_angles",
        title: "the same in theta, phi and zeta",
        angles: true,
        ..POLE
    },
    Problem {
        key: "flips",
        title: "ten flips of the free body from 1e-4 rad off the intermediate axis",
        motion: Motion::Free {
            moments: [1.0, 2.0, 8.0 / 3.0],
            rates: [1e-4, 1.0, 0.0],
        },
        angles: false,
        period: 83.88050342238517,
        end: 419.40251711192593,
        oracle: [
            0.651_481_693_820_724_081_47,
            0.000_037_933_217_671_902_118_661,
            0.758_664_353_438_034_756_34,
            -4.413_844_670_761_280_009_7e-19,
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
            Self::Free(body) => body.attitude_at(t),
            Self::Top(top) => top.attitude(t),
        }
    }

    /// The attitude and the rates at time `t`.
    pub fn state(&self, t: f64) -> (Attitude, BodyVector) {
        match self {
            Self::Free(body) => body.state_at(t),
            Self::Top(top) => top.state(t),
        }
    }
}

impl Problem {
    /// The problem of this name.
    pub fn named(key: &str) -> Option<&'static Self> {
        PROBLEMS.iter().find(|problem| problem.key == key)
    }

    /// The closed form, set up.
    ///
    /// # Errors
    /// None for the problems of this file.
    pub fn exact(&self) -> Result<Exact> {
        match self.motion {
            Motion::Free { moments, rates } => {
                let [i1, i2, i3] = moments;
                let moments = PrincipalMoments::new(i1, i2, i3)?;
                let rates = BodyVector::from_array(rates);
                let body = FreeBody::new(moments, rates, Attitude::IDENTITY)?;
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
        }
    }

    /// Moments of inertia.
    pub fn moments(&self) -> [f64; 3] {
        match self.motion {
            Motion::Free { moments, .. } => moments,
            Motion::Top { a, .. } => [1.0, 1.0, a],
        }
    }

    /// The body and its state at the start.
    ///
    /// # Errors
    /// None for the problems of this file.
    pub fn start(&self) -> Result<(RigidBody, State)> {
        let [i1, i2, i3] = self.moments();
        let body = RigidBody::new(PrincipalMoments::new(i1, i2, i3)?);
        let (attitude, rates) = self.exact()?.state(0.0);
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
    Error::OutOfRange {
        name: "m g l",
        value: torque,
        allowed: "a free body has none, a top has some",
    }
}
