//! Splittings of bodies whose rotation is resisted: their order, what they keep, the stop, and
//! their price.

use crate::slope::assert_slope;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    CoulombBearing, DiscDrag, Effect, GravityAtLever, PrescribedTorque, Profile, ViscousFriction,
};
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{
    Dop853, GaussLegendre, Integrator, Resisted, Scheme, Splitting,
};
use rotation_dynamics::math::{exp, pow};
use rotation_dynamics::scene::Scene;
use support::{EPS, Errors, assert_error, assert_largest, attained};

fn body(i1: f64, i2: f64, i3: f64) -> RigidBody {
    RigidBody::new(PrincipalMoments::new(i1, i2, i3).expect("a body"))
}

fn start(body: &RigidBody) -> State {
    let (phi, theta, zeta) = (0.4, 0.9, -0.3);
    let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta }).expect("angles");
    (body.state(attitude, BodyVector::new(0.3, -0.2, 2.0))).expect("a state")
}

fn gravity() -> GravityAtLever {
    GravityAtLever::new(0.5, 0.8).expect("gravity")
}

/// Errors of the attitude against the step, for this scheme on this scene.
fn errors<E: Effect>(
    scene: &Scene<E>,
    scheme: Scheme,
    steps: &[u64],
    t: f64,
    exact: &Attitude,
) -> Vec<(f64, f64)> {
    let start = start(scene.body());
    let problem = Resisted::new(scene, 0.0).expect("known");
    steps
        .iter()
        .map(|&n| {
            let method = Splitting::new(scheme, n).expect("steps");
            let (end, _) = method.advance(&problem, 0.0, &start, t).expect("smooth");
            (t / n as f64, end.attitude.angle_to(exact))
        })
        .collect()
}

const CASES: [(Scheme, &[u64]); 5] = [
    (Scheme::STRANG, &[200, 400, 800, 1600]),
    (Scheme::KAHAN_LI17, &[20, 24, 28, 32, 36]),
    (Scheme::ABA82, &[200, 400, 800, 1600]),
    (Scheme::ABA104, &[60, 80, 120, 160]),
    (Scheme::ABA1064, &[60, 80, 120, 160]),
];

/// Orders of all schemes against a reference, with these slopes and scatters.
fn orders<E: Effect>(scene: &Scene<E>, exact: &Attitude, slopes: [(&str, &str); 5]) {
    let mut ran = 0;
    for ((scheme, steps), (slope, scatter)) in CASES.into_iter().zip(slopes) {
        assert_slope(&errors(scene, scheme, steps, 5.0, exact), slope, scatter);
        ran += 1;
    }
    assert_eq!(ran, CASES.len());
}

#[test]
fn orders_of_a_top_with_friction() {
    let body = body(1.0, 1.0, 0.6);
    let friction = ViscousFriction::new(0.2, 0.1).expect("friction");
    let scene = Scene::new(body).with(gravity()).with(friction);
    let gauss = GaussLegendre::new(200).expect("steps");
    let exact = gauss.advance(&scene, 0.0, &start(&body), 5.0).expect("smooth").0;
    let slopes = [
        ("2.00000", "1.1e-6"),
        ("7.88", "0.025"),
        ("2.00000", "3.4e-7"),
        ("4.0003", "2.9e-5"),
        ("4.0002", "1.2e-5"),
    ];
    orders(&scene, &exact.attitude, slopes);
}

#[test]
fn orders_of_a_brick_in_air() {
    let body = body(1.0, 1.4, 0.6);
    // A disc of half a metre, in a fluid so thin that the drag is that of air on a heavier body.
    let drag = DiscDrag::new(0.9, 1.204, 1.51e-5, 2.0).expect("drag");
    let friction = ViscousFriction::new(0.2, 0.0).expect("friction");
    let scene = Scene::new(body).with(drag).with(gravity()).with(friction);
    let dop = Dop853::new(1e-14).expect("a tolerance");
    let exact = dop.advance(&scene, 0.0, &start(&body), 5.0).expect("smooth").0;
    let slopes = [
        ("2.00000", "2.6e-6"),
        ("7.86", "0.030"),
        ("2.00000", "2.6e-7"),
        ("4.007", "9.5e-4"),
        ("3.997", "2.3e-4"),
    ];
    orders(&scene, &exact.attitude, slopes);
}

/// SRKN 14a needs kicks that depend on the attitude only: of its order 6 strong friction leaves
/// 4; SRKN 6b and Kahan-Li keep theirs.
#[test]
fn strong_friction_takes_the_order_of_srkn_14a() {
    let body = body(1.0, 1.0, 0.6);
    let friction = ViscousFriction::new(3.0, 1.0).expect("friction");
    let scene = Scene::new(body).with(gravity()).with(friction);
    let gauss = GaussLegendre::new(400).expect("steps");
    let exact = gauss.advance(&scene, 0.0, &start(&body), 2.0).expect("smooth").0;
    let slope = |scheme, steps: &[u64], slope, scatter| {
        assert_slope(&errors(&scene, scheme, steps, 2.0, &exact.attitude), slope, scatter);
    };
    slope(Scheme::SRKN6, &[40, 56, 80, 112], "3.999", "8.3e-5");
    slope(Scheme::SRKN14, &[40, 56, 80, 112], "3.999", "7.2e-5");
    slope(Scheme::KAHAN_LI17, &[10, 14, 20, 28], "7.97", "0.0067");
}

/// With the same rate k in all directions the motion is the free one at another time,
/// (1 - exp(-k t))/k: no integrator in the oracle.
#[test]
fn isotropic_resistance_slows_a_free_motion_like_a_clock() {
    let mut off = Errors::of("attitude");
    let mut twin = Errors::of("twin: without resistance");
    let body = body(1.0, 1.0, 0.6);
    let start = start(&body);
    let (k, t) = (0.15, 10.0);
    let friction = ViscousFriction::new(k, k * 0.6).expect("friction");
    let scene = Scene::new(body).with(friction);
    let motion = FreeBody::new(body.moments(), start.attitude, body.angular_velocity(&start));
    let motion = motion.expect("a motion");
    let method = Splitting::new(Scheme::KAHAN_LI17, 200).expect("steps");
    let problem = Resisted::new(&scene, 0.0).expect("known");
    let (end, _) = method.advance(&problem, 0.0, &start, t).expect("smooth");
    off.push(end.attitude.angle_to(&motion.attitude((1.0 - exp(-k * t)) / k)));
    twin.push(end.attitude.angle_to(&motion.attitude(t)));
    assert_largest!(off, 1, @"1.42e-15");
    twin.exceed(0.1, 1);
}

/// Dry friction stops the spin at its time, at 0, and never turns it round.
#[test]
fn a_spin_is_stopped_and_not_turned_round() {
    let body = body(1.0, 1.0, 0.6);
    let start = start(&body);
    let bearing = CoulombBearing::new(0.31, &body, &start, 0.0).expect("friction");
    let stop = bearing.stop().expect("it stops");
    let scene = Scene::new(body).with(gravity()).with(bearing);
    let (mut axial, mut beyond) = (Errors::in_units_of(EPS, "L_z, of |L|"), Errors::of("after"));
    let size = start.angular_momentum.norm();
    for (scheme, steps) in [(Scheme::STRANG, 97), (Scheme::ABA82, 53)] {
        let problem = Resisted::new(&scene, 0.0).expect("known");
        for part in [0.2, 0.7, 0.999, 1.0, 1.001, 1.5, 3.0] {
            let method = Splitting::new(scheme, steps).expect("steps");
            let t = part * stop;
            let (end, _) = method.advance(&problem, 0.0, &start, t).expect("smooth");
            let l = body.angular_momentum(&end).z();
            axial.push_at((l - bearing.axial_momentum(t)) / size, (scheme.name, part));
            if part > 1.0 {
                beyond.push_at(l / size, (scheme.name, part));
            }
        }
    }
    assert_largest!(axial, 14, @"4.79");
    assert_largest!(beyond, 6, @"5.32e-16");
    // A twin that steps the sign of L_z overshoots.
    let overshoot = {
        let (h, mut l) = (stop / 97.0 * 1.3, body.angular_momentum(&start).z());
        for _ in 0..97 {
            l -= 0.31 * h * l.signum();
        }
        l
    };
    assert!(overshoot.abs() / size > 1e-4, "{overshoot}");
}

/// L_Z of a body that only its axis's bearings resist is not kept, but L_z is what its law says,
/// to rounding, whatever the steps; and without resistance the splitting is the plain one.
#[test]
fn without_resistance_it_is_the_plain_splitting() {
    let body = body(1.0, 1.0, 0.6);
    let start = start(&body);
    let scene = Scene::new(body).with(gravity());
    let method = Splitting::new(Scheme::KAHAN_LI17, 300).expect("steps");
    let (plain, work) = method.advance(&scene, 0.0, &start, 10.0).expect("smooth");
    let problem = Resisted::new(&scene, 0.0).expect("known");
    let (resisted, same) = method.advance(&problem, 0.0, &start, 10.0).expect("smooth");
    assert_eq!(work, same);
    assert_error!(resisted.attitude.angle_to(&plain.attitude), 2.6e-16);
}

#[test]
fn what_has_no_closed_form_is_refused() {
    let body = body(1.0, 1.4, 0.6);
    let push = PrescribedTorque::on_body(
        BodyVector::new(0.0, 0.0, 1.0),
        Profile::steps(&[(0.0, 1.0)]).expect("steps"),
    );
    let scene = Scene::new(body).with(push.expect("a torque"));
    let refused = Resisted::new(&scene, 0.0).expect_err("refused").to_string();
    assert!(refused.contains("prescribed torque"), "{refused}");
    // Drag and a viscous bearing about the same axis: each is known, both together are not.
    let drag = DiscDrag::new(0.5, 1.204, 1.51e-5, 2.0).expect("drag");
    let bearing = ViscousFriction::about_axis(0.1).expect("friction");
    let scene = Scene::new(body).with(drag).with(bearing);
    assert!(Resisted::new(&scene, 0.0).is_err());
    assert!(Resisted::new(&Scene::new(body), f64::NAN).is_err());
}

/// The half-kilogram gyroscope with friction in both bearings, for ten seconds: kicks and
/// derivatives for the same error.
#[test]
fn weak_friction_is_cheap() {
    let body = body(5.45e-3, 5.45e-3, 9e-4);
    let (phi, theta, zeta) = (0.0, 1.047, 0.0);
    let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta }).expect("angles");
    let start = body.state(attitude, BodyVector::new(0.0, 0.0, 314.0)).expect("a state");
    let weight = GravityAtLever::new(4.9, 0.1).expect("gravity");
    let friction = ViscousFriction::new(2e-5, 2e-6).expect("friction");
    let scene = Scene::new(body).with(weight).with(friction);
    let t = 10.0;
    let gauss = GaussLegendre::new(4000).expect("steps");
    let exact = gauss.advance(&scene, 0.0, &start, t).expect("smooth").0;
    let problem = Resisted::new(&scene, 0.0).expect("known");
    let split = Splitting::new(Scheme::SRKN14, 200).expect("steps");
    let (end, kicked) = split.advance(&problem, 0.0, &start, t).expect("smooth");
    let reached = end.attitude.angle_to(&exact.attitude);
    assert_error!(reached, 9.4e-7);
    assert_eq!(kicked.torques(), 2800);
    // The cheapest of ever finer runs that comes as near.
    let stepped = (0..40).find_map(|n| {
        let dop = Dop853::new(1e-6 * pow(10.0, -0.1 * f64::from(n))).expect("a tolerance");
        let (end, work) = dop.advance(&scene, 0.0, &start, t).expect("smooth");
        (end.attitude.angle_to(&exact.attitude) <= reached).then(|| work.torques())
    });
    let times = stepped.expect("it comes as near") as f64 / kicked.torques() as f64;
    attained(times, "13.9", "derivatives of DOP853 over kicks");
}
