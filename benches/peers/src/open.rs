//! Motions without a closed form, and their attitudes at the end.
//!
//! About three hundred turns each, ended in mid-flight. The attitudes at the end are those of
//! `references.py`: two Taylor series with different equations, orders and steps at 50 digits,
//! which agree to more than 40 and share no code with this library.

#![allow(clippy::excessive_precision, reason = "the references' digits, as they came")]

use crate::problem::{Motion, Problem};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    Effect, GravityAtLever, GravityGradient, Torque, ViscousFriction,
};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::cos;
use rotation_dynamics::scene::Scene;
use rotation_dynamics::{Error, Result};

/// What acts on a body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Under {
    /// Its weight times this lever along e3 (N m).
    Weight(f64),
    /// The same, and a bearing about e3 with this coefficient of friction (N m s).
    WeightAndFriction(f64, f64),
    /// The gradient of gravity on a circular orbit about Z with this mean motion (rad/s); the
    /// attracting body is at -X at first.
    Gradient(f64),
    /// This torque on its own axes, times the cosine of a rate (rad/s) times the time.
    Drive([f64; 3], f64),
}

/// The quaternion at the start: e1, e2, e3 along Y, Z, X, exact in binary.
pub const LYING: [f64; 4] = [0.5; 4];

const MOMENTS: [f64; 3] = [1.0, 1.3, 1.7];
const RATES: [f64; 3] = [0.25, 0.5, 1.25];
/// 2 pi over the length of these rates.
const TURN: f64 = 4.588_550_2;

const ANY_BODY: Problem = Problem {
    key: "heavy_body",
    title: "heavy body, I = (1, 1.3, 1.7), m g l = 0.25, 300.4 turns",
    motion: Motion::Open { moments: MOMENTS, rates: RATES, under: Under::Weight(0.25) },
    angles: false,
    period: TURN,
    end: 1378.25,
    oracle: [
        0.722_991_556_362_411_977_961_63,
        -0.511_291_366_133_607_459_598_81,
        -0.455_676_823_450_011_766_564_82,
        0.090_680_653_484_596_336_335_104,
    ],
};

/// All of them, in the order of their record.
pub const OPEN: [Problem; 4] = [
    ANY_BODY,
    Problem {
        key: "damped_top",
        title: "heavy top, I = (1, 1, 2), m g l = 0.2, whose bearing takes over half of its spin, \
                300.4 nutations of the start",
        motion: Motion::Open {
            moments: [1.0, 1.0, 2.0],
            rates: [0.0, 0.25, 0.75],
            under: Under::WeightAndFriction(0.2, 1.25e-3),
        },
        // 2 pi I1/(I3 omega_3)
        period: 4.188_790_2,
        end: 1258.25,
        oracle: [
            0.608_766_208_396_052_936_689_13,
            0.499_194_534_484_526_082_522_48,
            0.603_172_335_650_443_962_676_86,
            0.128_029_894_016_432_403_878_59,
        ],
        ..ANY_BODY
    },
    Problem {
        key: "satellite",
        title: "satellite, I = (1, 1.3, 1.7), under the gradient of gravity, n0 = 0.125, \
                27.4 orbits, 300.4 turns",
        motion: Motion::Open { moments: MOMENTS, rates: RATES, under: Under::Gradient(0.125) },
        oracle: [
            0.743_462_020_455_281_899_952_22,
            0.618_581_173_486_060_178_720_85,
            -0.209_643_979_737_201_434_604_13,
            -0.143_773_981_335_659_588_959_94,
        ],
        ..ANY_BODY
    },
    Problem {
        key: "driven_body",
        title: "body, I = (1, 1.3, 1.7), driven on its own axes by (0.05, 0.04, 0.03) cos 0.75 t, \
                300.4 turns",
        motion: Motion::Open {
            moments: MOMENTS,
            rates: RATES,
            under: Under::Drive([0.05, 0.04, 0.03], 0.75),
        },
        oracle: [
            0.581_358_245_608_772_164_488_71,
            0.123_139_234_901_558_194_555_64,
            0.471_585_418_950_676_381_846_97,
            0.651_510_945_206_344_518_714_22,
        ],
        ..ANY_BODY
    },
];

/// The body of a motion without a closed form and its state at the start.
///
/// # Errors
/// None for the problems of this file.
pub fn start([i1, i2, i3]: [f64; 3], rates: [f64; 3]) -> Result<(RigidBody, State)> {
    let body = RigidBody::new(PrincipalMoments::new(i1, i2, i3)?);
    let start = body.state(Attitude::from_quaternion(LYING)?, BodyVector::from_array(rates))?;
    Ok((body, start))
}

/// The scene of a heavy body.
///
/// # Errors
/// None for the problems of this file.
pub fn heavy(body: RigidBody, weight: f64) -> Result<Scene<((), GravityAtLever)>> {
    Ok(Scene::new(body).with(GravityAtLever::new(weight, 1.0)?))
}

/// The scene of a top with a bearing.
///
/// # Errors
/// None for the problems of this file.
pub fn damped(body: RigidBody, weight: f64, friction: f64) -> Result<Scene<impl Effect>> {
    Ok(heavy(body, weight)?.with(ViscousFriction::about_axis(friction)?))
}

/// The scene of a satellite.
///
/// # Errors
/// None for the problems of this file.
pub fn satellite(body: RigidBody, mean_motion: f64) -> Result<Scene<impl Effect>> {
    let (normal, towards) = (SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(-1.0, 0.0, 0.0));
    Ok(Scene::new(body).with(GravityGradient::on_orbit(mean_motion, normal, towards)?))
}

/// The scene of a driven body.
pub fn driven(body: RigidBody, torque: [f64; 3], rate: f64) -> Scene<impl Effect> {
    let torque = BodyVector::from_array(torque);
    let drive = move |t: f64, _: &RigidBody, _: &State| torque * cos(rate * t);
    Scene::new(body).with(Torque::on_body("drive", drive).smooth())
}

/// What a motion of the other kind is told.
pub(crate) fn no_closed_form() -> Error {
    Error::out_of_range("closed form", 0.0, "a motion that has one")
}
