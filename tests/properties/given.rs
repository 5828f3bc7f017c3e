//! Any bits given to the constructors: a value or a clear error.

use crate::{Held, holds};
use models::{ladder::Ladder, plank::Plank};
use proptest::prelude::*;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{DiscDrag, GravityAtLever, GravityGradient, InternalDissipation};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::exact::pendulum::{Pendulum, Suspension};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::{InertiaTensor, PrincipalMoments, solids};
use rotation_dynamics::motion::Motion;

/// A double that somebody may give: of any bits, of an ordinary size, or one of the odd ones.
fn double() -> impl Strategy<Value = f64> {
    let odd = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        0.5,
        2.0,
        f64::NAN,
        f64::INFINITY,
        f64::MIN_POSITIVE,
        5e-324,
        f64::MAX,
        core::f64::consts::PI,
    ];
    prop_oneof![
        4 => -10.0..10.0,
        1 => any::<u64>().prop_map(f64::from_bits),
        1 => prop::sample::select(odd.to_vec()),
    ]
}

/// A motion asked at this time, and how it answers.
fn asked<M: Motion>(
    made: rotation_dynamics::Result<M>,
    t: f64,
    finite: impl Fn(&M::State) -> bool,
) -> Result<bool, TestCaseError> {
    match made.and_then(|motion| motion.try_state(t)) {
        Ok(state) => {
            prop_assert!(finite(&state), "a state that is no number");
            Ok(true)
        }
        Err(error) => {
            prop_assert!(error.to_string().len() > 10);
            Ok(false)
        }
    }
}

fn sound(state: &State) -> bool {
    let norm: f64 = state.attitude.quaternion().iter().map(|x| x * x).sum();
    (norm - 1.0).abs() < 1e-14 && state.angular_momentum.is_finite()
}

#[test]
fn motions_of_any_bits() {
    holds("motions of any bits", 20_000, 1.0, prop::array::uniform12(double()), |x| {
        let attitude =
            Attitude::from_quaternion([x[0], x[1], x[2], x[3]]).unwrap_or(Attitude::IDENTITY);
        let rates = BodyVector::new(x[4], x[5], x[6]);
        let free =
            PrincipalMoments::new(x[7], x[8], x[9]).and_then(|i| FreeBody::new(i, attitude, rates));
        let top = SymmetricTop::new(x[7], x[8], x[9], x[10]);
        let angles = EulerAngles { phi: x[0], theta: x[1], zeta: x[2] };
        let answers = [
            asked(free, x[11], sound)?,
            asked(top.clone().and_then(|top| HeavyTop::new(top, attitude, rates)), x[11], sound)?,
            asked(top.and_then(|top| HeavyTop::from_body(top, angles, rates)), x[11], sound)?,
            asked(
                Pendulum::new(
                    Suspension { moment: x[0], mass: x[1], gravity: x[2], lever: x[3] },
                    x[4],
                    x[5],
                ),
                x[11],
                |s| s.theta.is_finite() && s.omega.is_finite(),
            )?,
            asked(Plank::new(x[0], x[1], x[2], x[3]), x[11], |s| {
                s.theta.is_finite() && s.omega.is_finite()
            })?,
            asked(Ladder::new(x[0], x[1], x[2]), x[11], |s| {
                s.theta.is_finite() && s.omega.is_finite()
            })?,
        ];
        Ok(if answers.contains(&true) { Held::Yes } else { Held::Refused })
    });
}

#[test]
fn bodies_and_effects_of_any_bits() {
    holds("bodies and effects of any bits", 20_000, 1.0, prop::array::uniform9(double()), |x| {
        let space = |i: usize| SpaceVector::new(x[i], x[i + 1], x[i + 2]);
        let tensor =
            InertiaTensor::new([[x[0], x[1], x[2]], [x[1], x[3], x[4]], [x[2], x[4], x[5]]]);
        let body = PrincipalMoments::new(x[0], x[1], x[2]).map(RigidBody::new);
        let state = State::new(Attitude::IDENTITY, space(3));
        let answers = [
            tensor.map(|tensor| tensor.principal_axes().moments().iter().all(|i| i.is_finite())),
            solids::cylinder(x[0], x[1], x[2])
                .map(|solid| solid.about_centre_of_mass().matrix()[0][0].is_finite()),
            solids::torus(x[0], x[1], x[2]).map(|solid| solid.mass().is_finite()),
            solids::cone(x[0], x[1], x[2]).map(|solid| solid.mass().is_finite()),
            GravityAtLever::new(x[0], x[1]).map(|gravity| gravity.moment().is_finite()),
            GravityGradient::on_orbit(x[0], space(1), space(4))
                .map(|gradient| gradient.direction(1.0 / (1.0 + x[0])).is_finite()),
            InternalDissipation::new(x[0]).map(|loss| loss.coefficient().is_finite()),
            DiscDrag::new(x[0], x[1], x[2], x[3]).map(|drag| drag.axial_torque(1.0).is_finite()),
            body.and_then(|body| Ok(body.kinetic_energy(&state?) >= 0.0)),
        ];
        let mut held = Held::Refused;
        for (n, answer) in answers.into_iter().enumerate() {
            match answer {
                Ok(finite) => {
                    prop_assert!(finite, "answer {n} is no number");
                    held = Held::Yes;
                }
                Err(error) => prop_assert!(error.to_string().len() > 10),
            }
        }
        Ok(held)
    });
}
