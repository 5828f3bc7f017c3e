//! Values as text: `Display` with numbers as the format says, `Debug` without what is no value.

use rotation_dynamics::Result;
use rotation_dynamics::accuracy::Limits;
use rotation_dynamics::attitude::{Attitude, EulerAngles, YawPitchRoll};
use rotation_dynamics::body::{DesignedBody, RigidBody};
use rotation_dynamics::effects::{GravityAtLever, Torque, ViscousFriction};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, SymmetricTop};
use rotation_dynamics::frame::{BodyVector, DesignVector, SpaceVector};
use rotation_dynamics::inertia::{MassProperties, PrincipalMoments, solids};
use rotation_dynamics::integrators::{Dop853, Rk4, Work};
use rotation_dynamics::motion::{Kept, Motion};
use rotation_dynamics::scene::Scene;

#[test]
fn a_format_holds_for_every_number() -> Result<()> {
    let body = RigidBody::new(PrincipalMoments::new(1.0, 2.0, 2.5)?);
    let rates = BodyVector::new(0.0, 0.0, 2.0);
    let state = body.state(Attitude::IDENTITY, rates)?;
    let rod = solids::rod(3.0, 2.0)?;
    let turned = Attitude::IDENTITY;
    let euler = EulerAngles { phi: 0.25, theta: 1.0, zeta: -0.5 };
    let yaw = YawPitchRoll { yaw: 0.25, pitch: 1.0, roll: -0.5 };
    for (text, expected) in [
        (format!("{euler:.1}"), "phi = 0.2, theta = 1.0, zeta = -0.5 rad"),
        (format!("{yaw:+}"), "yaw = +0.25, pitch = +1, roll = -0.5 rad"),
        (format!("{:.1}", body.moments()), "(1.0, 2.0, 2.5) kg m^2"),
        (format!("{body}"), "moments (1, 2, 2.5) kg m^2"),
        (
            format!("{rod:.1}"),
            "3.0 kg at (0.0, 0.0, 0.0) m, \
             tensor ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 0.0)) kg m^2",
        ),
        (
            format!("{state:.1}"),
            "attitude (1.0, 0.0, 0.0, 0.0), angular momentum (0.0, 0.0, 5.0) kg m^2/s",
        ),
        (
            format!("{}", body.kinematics(&state)),
            "attitude (1, 0, 0, 0), angular velocity (0, 0, 2) rad/s",
        ),
        (format!("{:.2}", Kept::new("energy", "J", 2.5)), "energy = 2.50 J"),
        (format!("{}", Kept::new("modulus", "", 0.5)), "modulus = 0.5"),
        (format!("{rates:?}"), "BodyVector(0.0, 0.0, 2.0)"),
        (format!("{:?}", turned.to_space(rates)), "SpaceVector(0.0, 0.0, 2.0)"),
        (format!("{:#.1?}", rod.centre_of_mass()), "DesignVector(0.0, 0.0, 0.0)"),
    ] {
        assert_eq!(text, expected);
    }
    Ok(())
}

#[test]
fn debug_shows_values_alone() -> Result<()> {
    let body = RigidBody::new(PrincipalMoments::symmetric(5.45e-3, 9.0e-4)?);
    let tilted = Attitude::from_euler(EulerAngles { phi: 0.0, theta: 1.0, zeta: 0.0 })?;
    let rates = BodyVector::new(0.0, 0.0, 100.0);
    let start = body.state(tilted, rates)?;
    let gravity = GravityAtLever::new(4.9, 0.1)?;
    let scene = Scene::new(body).with(gravity).with(ViscousFriction::new(1e-6, 1e-6)?);
    let solved = scene.solve(&start, 0.1, 1e-6)?;
    let top = HeavyTop::new(SymmetricTop::new(5.45e-3, 9.0e-4, 4.9, 0.1)?, tilted, rates)?;
    let free = FreeBody::new(body.moments(), tilted, rates)?;
    let rod = solids::cuboid(3.0, 1.0, 2.0, 3.0)?;
    let design = DesignedBody::new(&rod.about(DesignVector::new(1.0, 2.0, 0.5))?)?;
    let torque = Torque::on_body("motor", |_t, _body, _state| BodyVector::new(0.0, 0.0, 0.18));
    let refused = body.state(tilted, BodyVector::new(f64::NAN, 0.0, 0.0)).unwrap_err();
    let texts = [
        format!("{:?}", SpaceVector::zero()),
        format!("{tilted:?}"),
        format!("{start:?}"),
        format!("{:?}", body.kinematics(&start)),
        format!("{body:?}"),
        format!("{gravity:?}"),
        format!("{torque:?}"),
        format!("{scene:?}"),
        format!("{solved:?}"),
        format!("{top:?}"),
        format!("{:?}", top.kept()),
        format!("{free:?}"),
        format!("{rod:?}"),
        format!("{:?}", MassProperties::of_parts(&[rod])?),
        format!("{design:?}"),
        format!("{:?}", Dop853::new(1e-9)?),
        format!("{:?}", Rk4::new(10)?),
        format!("{:?}", Work::default()),
        format!("{:?}", Limits::default()),
        format!("{refused:?}"),
    ];
    let longest = texts.iter().map(String::len).max();
    assert!(longest.is_some_and(|longest| longest > 100), "{longest:?}");
    for text in texts {
        assert!(!text.contains("PhantomData"), "{text}");
    }
    Ok(())
}
