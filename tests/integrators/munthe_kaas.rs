//! Runge-Kutta on the rotations themselves: order 4, and a quaternion of length 1.

use crate::slope::assert_slope;
use crate::top;
use rotation_dynamics::Error;
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::exact::heavy_top::{HeavyTop, ReducedTop};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{Integrator, MuntheKaas4, Rk4, Work};
use rotation_dynamics::math::EPS;
use rotation_dynamics::scene::Scene;
use support::{Errors, assert_error, assert_largest};

fn method(steps: u64) -> MuntheKaas4 {
    MuntheKaas4::new(steps).expect("some steps")
}

#[test]
fn slope_on_the_free_body_and_the_top() {
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0).expect("a body");
    let rates = BodyVector::new(0.8, 0.4, 0.3375);
    let scene = Scene::new(RigidBody::new(moments));
    let start = scene.body().state(Attitude::IDENTITY, rates).expect("finite");
    let want = FreeBody::new(moments, Attitude::IDENTITY, rates).expect("a motion").attitude(20.0);
    let points: Vec<(f64, f64)> = [400, 600, 800, 1200, 1600]
        .into_iter()
        .map(|n| {
            let (end, _) = method(n).advance(&scene, 0.0, &start, 20.0).expect("smooth");
            (1.0 / n as f64, end.attitude.angle_to(&want))
        })
        .collect();
    // Over errors from 1.8e-7 to 6.9e-10.
    assert_slope(&points, "4.014", "0.0017");

    let (scene, start) = top::figure_3();
    let exact = ReducedTop::new(2.0, 1.2, 0.2)
        .and_then(|top| HeavyTop::from_angles(top, top::THETA_3, 0.0, 0.0, 0.0))
        .expect("the notes' top");
    let want = exact.attitude(20.0);
    let points: Vec<(f64, f64)> = [800, 1200, 1600, 2400, 3200]
        .into_iter()
        .map(|n| {
            let (end, _) = method(n).advance(&scene, 0.0, &start, 20.0).expect("smooth");
            (1.0 / n as f64, end.attitude.angle_to(&want))
        })
        .collect();
    let (plain, _) =
        Rk4::new(800).expect("steps").advance(&scene, 0.0, &start, 20.0).expect("smooth");
    // Over errors from 3.1e-8 to 1.2e-10.
    assert_slope(&points, "4.024", "0.0040");
    // With 800 steps it is off by 3.1e-8, RK4 by 8.5e-8.
    let ratio = plain.attitude.angle_to(&want) / points[0].1;
    assert_error!(ratio, 2.8);
}

/// However long the step, the attitude is a rotation; adding to it does not give one.
#[test]
fn the_length_is_one_by_construction() {
    let (scene, start) = top::figure_3();
    let mut lengths = Errors::in_units_of(EPS, "square of the quaternion");
    for (steps, t_end) in [(1, 3.0), (20, 20.0), (100_000, 20_000.0)] {
        let (end, work) = method(steps).advance(&scene, 0.0, &start, t_end).expect("finite");
        let square: f64 = end.attitude.quaternion().iter().map(|c| c * c).sum();
        lengths.push(square - 1.0);
        assert_eq!(work, Work { steps, derivatives: 4 * steps, ..Work::default() });
    }
    assert_largest!(lengths, 3, @"1");
    // The twin: the same tableau, added to the quaternion instead.
    let y = rotation_dynamics::integrators::scene::components(&start);
    let (z, _) = Rk4::new(20).expect("steps").advance(&scene, 0.0, &y, 20.0).expect("finite");
    let square: f64 = z[..4].iter().map(|c| c * c).sum();
    // Measured: short by 0.055.
    assert!((square - 1.0).abs() > 0.05);
}

#[test]
fn refusals() {
    assert!(matches!(MuntheKaas4::new(0), Err(Error::OutOfRange { name: "steps", .. })));
    let (scene, start) = top::figure_3();
    assert!(matches!(
        method(1).advance(&scene, 0.0, &start, f64::NAN),
        Err(Error::NotFinite { .. })
    ));
    let (end, work) = method(7).advance(&scene, 2.0, &start, 2.0).expect("no time");
    assert_eq!((top::distance(&end, &start), work), (0.0, Work::default()));
}
