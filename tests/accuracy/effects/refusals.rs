//! Bad numbers are refused by name, with what is allowed; dimensionless numbers are right.

use super::{body, tilted};
use rotation_dynamics::Error;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::effects::{
    CoulombBearing, DiscDrag, Effect, FlowRegime, Gravity, PrescribedTorque, Profile,
    ViscousFriction,
};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use support::assert_error;

const NAN: f64 = f64::NAN;
const INF: f64 = f64::INFINITY;

#[test]
fn bad_coefficients_are_named() {
    let body = body(1.0, 1.0, 0.6);
    let start = tilted(&body, [0.1, 0.2, 4.0]);
    let centre = BodyVector::new(0.1, INF, 0.0);
    let steps = |rows: &[(f64, f64)]| Profile::steps(rows).err();
    let lines = |rows: &[(f64, f64)]| Profile::lines(rows).err();
    let pushed = |x: f64, height: f64| {
        let profile = Profile::steps(&[(0.0, height)]).expect("steps");
        PrescribedTorque::on_space(SpaceVector::new(x, 0.0, 0.0), profile).err()
    };
    let bearing = |tau, t| CoulombBearing::new(tau, &body, &start, t).err();
    let drag =
        |radius, density, viscosity, spin| DiscDrag::new(radius, density, viscosity, spin).err();
    let cases: [(Option<Error>, &str); 28] = [
        (
            lines(&[(-1e308, 1.0), (1e308, 2.0)]),
            "times of a profile[0]: difference from the next = inf",
        ),
        (
            lines(&[(0.0, 0.0), (1.0, -1e308), (2.0, 1e308)]),
            "values of a profile[1]: difference from the next = inf",
        ),
        (
            Gravity::new(-1.0, BodyVector::zero()).err(),
            "weight = -1 is not allowed: it must be greater than 0",
        ),
        (Gravity::new(NAN, BodyVector::zero()).err(), "weight = NaN"),
        (Gravity::new(1.0, centre).err(), "centre of mass, y = inf"),
        (
            Gravity::new(1e300, BodyVector::new(1e300, 0.0, 0.0)).err(),
            "weight times distance = inf",
        ),
        (
            ViscousFriction::new(-0.1, 0.0).err(),
            "transverse friction coefficient = -0.1 is not allowed: it must not be negative",
        ),
        (ViscousFriction::new(0.0, NAN).err(), "axial friction coefficient = NaN"),
        (ViscousFriction::isotropic(INF).err(), "transverse friction coefficient = inf"),
        (ViscousFriction::about_axis(-2.0).err(), "axial friction coefficient = -2"),
        (bearing(-0.1, 0.0), "friction torque = -0.1 is not allowed: it must not be negative"),
        (bearing(NAN, 0.0), "friction torque = NaN"),
        (bearing(0.1, INF), "start time = inf"),
        (drag(-0.1, 1.2, 1.5e-5, 1.0), "radius = -0.1 is not allowed: it must be greater than 0"),
        (drag(0.1, 0.0, 1.5e-5, 1.0), "density = 0"),
        (drag(0.1, 1.2, -1e-5, 1.0), "kinematic viscosity = -1e-5"),
        (drag(0.1, 1.2, 1.5e-5, NAN), "spin = NaN"),
        (drag(1e200, 1.2, 1.5e-5, 1.0), "Reynolds number at 1 rad/s = inf"),
        (drag(1e100, 1e300, 1e-5, 1.0), "torque at 1 rad/s = inf"),
        (steps(&[]), "pieces of a profile: 0 given where there must be 1"),
        (
            steps(&[(0.0, 1.0), (0.0, 2.0)]),
            "times of a profile[1]: value = 0 is not allowed: the one before it is 0, and they must rise",
        ),
        (
            lines(&[(0.0, 1.0), (2.0, 2.0), (1.0, 0.0)]),
            "times of a profile[2]: value = 1 is not allowed: the one before it is 2",
        ),
        (
            lines(&[(0.0, 1.0), (NAN, 1.0)]),
            "times of a profile[1]: value = NaN is not a finite number",
        ),
        (lines(&[(0.0, INF)]), "values of a profile[0]: value = inf is not a finite number"),
        (
            Profile::cubic(&[(0.0, 0.0), (1.0, 1.0), (1.0_f64.next_up(), 1e300), (2.0, 0.0)]).err(),
            "times of a profile[1]: time to the next = 2.220446049250313e-16 is not allowed: the \
             curve from the value 1 to 1e300 in that time is beyond doubles",
        ),
        (
            Profile::pulse(0.0, -1.0).err(),
            "width of the pulse = -1 is not allowed: it must be greater than 0",
        ),
        (pushed(NAN, 1.0), "torque, x = NaN"),
        (pushed(1e300, 1e300), "largest torque = inf"),
    ];
    let mut ran = 0;
    for (error, words) in cases {
        let told = error.expect(words).to_string();
        assert!(told.contains(words), "{told} should contain {words}");
        ran += 1;
    }
    assert_eq!(ran, 28);
    assert!(Profile::pulse(INF, 1.0).is_err());
}

/// Each number is torque over |L| |omega|, here by hand.
#[test]
fn numbers_are_what_they_are_called() {
    let body = body(1.0, 1.0, 0.5);
    let rates = BodyVector::new(0.0, 0.0, 4.0);
    let start = body.state(Attitude::IDENTITY, rates).expect("a state");
    let rest = body.state(Attitude::IDENTITY, BodyVector::zero()).expect("a state");
    let gravity = Gravity::new(2.0, BodyVector::new(0.3, 0.4, 0.0)).expect("gravity");
    assert_error!(gravity.number(&body, &start), 1.0 / 8.0, 0.0 eps);
    let viscous = ViscousFriction::new(0.3, 0.1).expect("friction");
    // c_a/(I3 omega).
    assert_error!(viscous.number(&body, &start), 0.1 / (0.5 * 4.0), 0.0 eps);
    let bearing = CoulombBearing::new(0.4, &body, &start, 0.0).expect("a bearing");
    assert_error!(bearing.number(&body, &start), 0.4 / 8.0, 0.0 eps);
    let profile = Profile::lines(&[(0.0, 1.0), (1.0, -3.0)]).expect("lines");
    let push = SpaceVector::new(0.1, 0.0, 0.0);
    let push = PrescribedTorque::on_space(push, profile).expect("a torque");
    assert_error!(push.number(&body, &start), 0.3 / 8.0, 1.67 eps);
    assert_eq!(push.number(&body, &rest), INF);
    assert_eq!(viscous.number(&body, &rest), 0.0);
    // A disc of 2 kg and 0.35 m at 20 rad/s: 200 s until it stops at this rate.
    let wheel = super::body(0.06125, 0.06125, 0.1225);
    let start = wheel.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 20.0));
    let air = (DiscDrag::AIR_DENSITY, DiscDrag::AIR_VISCOSITY);
    let drag = DiscDrag::new(0.35, air.0, air.1, 20.0).expect("drag");
    let seconds = 1.0 / (drag.number(&wheel, &start.expect("a state")) * 20.0);
    assert_error!(seconds, 200.0, 0.01);
    assert_error!(drag.reynolds(20.0), 1.6e5, 0.01);
}

/// Where the regime changes, the turbulent torque is 1.66 times the laminar one.
#[test]
fn the_regime_is_that_of_the_reynolds_number() {
    // R^2/nu = 1000.
    let drag = |spin| DiscDrag::new(1.0, 2.0, 1e-3, spin).expect("drag");
    let mut ran = 0;
    for (spin, regime) in [
        (0.0, FlowRegime::Laminar),
        (299.9, FlowRegime::Laminar),
        (-299.9, FlowRegime::Laminar),
        (300.1, FlowRegime::Turbulent),
        (-300.1, FlowRegime::Turbulent),
    ] {
        assert_eq!(drag(spin).regime(), regime);
        // tau = (1/2) rho omega^2 R^5 C_m.
        let reynolds: f64 = 1e3 * f64::abs(spin);
        if spin != 0.0 {
            let friction = match regime {
                FlowRegime::Laminar => 3.87 * reynolds.powf(-0.5),
                FlowRegime::Turbulent => 0.146 * reynolds.powf(-0.2),
            };
            let want = -f64::signum(spin) * spin * spin * friction;
            assert!((drag(spin).axial_torque(spin) / want - 1.0).abs() < 1e-14);
        }
        ran += 1;
    }
    assert_eq!(ran, 5);
    assert_eq!(drag(0.0).axial_torque(0.0), 0.0);
    let jump = drag(301.0).axial_torque(300.0) / drag(299.0).axial_torque(300.0);
    assert_error!(jump, 1.66, 0.001);
}
