//! The integrators on the cases of the tops: the same yardstick as for the closed
//! forms, with a factor K per method.
//!
//! A general method makes round-off at every step and knows the motion only through
//! it, so its K is larger than that of a closed form; it grows with the number of
//! steps (each of DOP853's may be off by 9 eps). Samples to which a body turns further
//! than a method promises for are counted and left out: they are for closed forms.

use super::case::{self, Case, Outcome, Trouble};
use core::ops::RangeInclusive;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::error::Result;
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{
    Dop853, GaussLegendre, Integrator, Rk4, Scheme, SpinFree, Splitting,
};
use rotation_dynamics::math::{cos, sin, tan};
use rotation_dynamics::scene::Scene;
use support::Errors;

type HeavyTop = Scene<((), GravityAtLever)>;

/// A method, set up for a run over which the fastest rate turns by this angle.
struct Method {
    name: &'static str,
    /// The largest factor K of the notes' own file, reached on the spherical pendulum
    /// (DOP853: on the gyroscope).
    bound: RangeInclusive<f64>,
    /// The factor K promised for any other case, times I1/I3 for a needle: a state
    /// holds L to eps |L|, and so omega_3 = L_z/I3 to eps |L|/I3 at best.
    promised: f64,
    /// The angle (rad) that the fastest rotation makes in a step.
    angle: f64,
    /// The angle (rad) that it may make in a run for the promise to hold.
    reach: f64,
    /// True if the spin costs the method steps.
    sees_spin: bool,
    run: fn(&HeavyTop, &State, f64, u64) -> Result<State>,
}

const METHODS: [Method; 6] = [
    Method {
        name: "SRKN 14a",
        bound: 7.7..=7.8,
        promised: 100.0,
        angle: 0.08,
        reach: 8e4,
        sees_spin: false,
        run: |scene, start, t, steps| {
            let method = Splitting::new(Scheme::SRKN14, steps)?;
            Ok(method.advance(scene, 0.0, start, t)?.0)
        },
    },
    Method {
        name: "SRKN 6b",
        bound: 8.5..=8.6,
        promised: 100.0,
        angle: 0.008,
        reach: 8e3,
        sees_spin: false,
        run: |scene, start, t, steps| {
            let method = Splitting::new(Scheme::SRKN6, steps)?;
            Ok(method.advance(scene, 0.0, start, t)?.0)
        },
    },
    Method {
        name: "Gauss-Legendre",
        bound: 7.8..=7.9,
        promised: 100.0,
        angle: 1.0,
        reach: 8e4,
        sees_spin: false,
        run: |scene, start, t, steps| {
            let method = GaussLegendre::new(steps)?;
            Ok(method.advance(&SpinFree::new(scene)?, 0.0, start, t)?.0)
        },
    },
    Method {
        name: "DOP853",
        bound: 17.8..=17.9,
        promised: 1000.0,
        angle: 0.1,
        reach: 2e3,
        sees_spin: true,
        run: |scene, start, t, _| Ok(Dop853::new(1e-15)?.advance(scene, 0.0, start, t)?.0),
    },
    Method {
        name: "DOP853 spin-free",
        bound: 13.8..=13.9,
        promised: 1000.0,
        angle: 0.1,
        reach: 2e3,
        sees_spin: false,
        run: |scene, start, t, _| {
            let method = Dop853::new(1e-15)?;
            Ok(method.advance(&SpinFree::new(scene)?, 0.0, start, t)?.0)
        },
    },
    Method {
        name: "RK4",
        bound: 21.7..=21.8,
        promised: 1000.0,
        angle: 0.001,
        reach: 1e3,
        sees_spin: true,
        run: |scene, start, t, steps| Ok(Rk4::new(steps)?.advance(scene, 0.0, start, t)?.0),
    },
];

/// The scene and the start of a case, or the reason why there is no such body.
fn scene(case: &Case, damage: f64) -> case::Result<(HeavyTop, State)> {
    let number = |name: &str| case.input(name);
    if case.kind == "top_si" {
        let [phi, theta, zeta] = case.input_vector("euler0")?;
        let omega = BodyVector::from_array(case.input_vector("omega0")?);
        let moments = PrincipalMoments::symmetric(number("I1")?, number("I3")?)?;
        let gravity = GravityAtLever::new(number("m")? * number("g")? * damage, number("l")?)?;
        let scene = Scene::new(RigidBody::new(moments)).with(gravity);
        let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
        return Ok((scene, scene.body().state(attitude, omega)?));
    }
    // The equivalent body: I1 = 1, I3 = a, m g l = c, L_z = sqrt(a), L_Z = sqrt(a) b.
    let (a, b, c) = (number("a")?, number("b")?, number("c")?);
    let (phi, zeta) = (number("phi0")?, number("zeta0")?);
    let (theta, rate) = case.start_of_top()?;
    let moments = PrincipalMoments::symmetric(1.0, a)?;
    let scene = Scene::new(RigidBody::new(moments)).with(GravityAtLever::new(damage, c)?);
    let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
    // phi' sin(theta) = sqrt(a) (b - cos)/sin, written without cancellation for b = 1
    // and b = -1.
    let half = 0.5 * theta;
    let precession = if b == 1.0 {
        tan(half)
    } else if b == -1.0 {
        -1.0 / tan(half)
    } else {
        (b - cos(theta)) / sin(theta)
    };
    let (along, across) = (rate, a.sqrt() * precession);
    let omega = BodyVector::new(
        along * cos(zeta) + across * sin(zeta),
        across * cos(zeta) - along * sin(zeta),
        1.0 / a.sqrt(),
    );
    Ok((scene, scene.body().state(attitude, omega)?))
}

/// I1/I3.
fn needle(case: &Case) -> case::Result<f64> {
    if case.kind == "top_si" {
        Ok(case.input("I1")? / case.input("I3")?)
    } else {
        Ok(1.0 / case.input("a")?)
    }
}

/// A bound on the rates (rad/s) that a method has to follow: |L|/I1 for one that
/// sees the axis only, |L|/I of the smallest moment for one that sees the body turn.
fn fastest(scene: &HeavyTop, start: &State, sees_spin: bool) -> f64 {
    let moments = scene.body().moments();
    let moment = scene.effects().1.moment().abs();
    // Falling from the top to the bottom sets free 2 m g l.
    let gained = 2.0 * (moment / moments.i1()).sqrt();
    let least = if sees_spin { moments.i1().min(moments.i3()) } else { moments.i1() };
    start.angular_momentum.norm() / least + gained
}

/// The case with its weight multiplied by `damage`, for the test of the test. A body
/// that the library does not know is one that the case lacks: there are formal tops.
fn judge(case: &Case, method: &Method, damage: f64) -> case::Result<Outcome> {
    let (scene, start) = scene(case, damage).map_err(|trouble| match trouble {
        Trouble::Refused(error) => Trouble::Lacks(error.to_string()),
        lacking => lacking,
    })?;
    let mut outcome = Outcome::new();
    let rate = fastest(&scene, &start, method.sees_spin);
    for sample in case.samples() {
        let t = sample.t();
        // Back in time is as far as forth.
        let turned = rate * t.abs();
        let steps = (turned / method.angle).ceil().max(1.0);
        if turned > method.reach {
            outcome.too_far += 1;
            continue;
        }
        let end = (method.run)(&scene, &start, t, steps as u64)?;
        let angles = end.attitude.euler_angles();
        let omega = scene.body().angular_velocity(&end).to_array();
        outcome.compare_field(&sample, "R", &end.attitude.matrix().concat());
        outcome.compare_field(&sample, "cos_theta", &[end.attitude.axis().z()]);
        outcome.compare_field(&sample, "theta", &[angles.theta]);
        outcome.compare_field(&sample, "omega", &omega);
        outcome.compare_field(&sample, "L_space", &end.angular_momentum.to_array());
    }
    Ok(outcome)
}

#[test]
fn integrators_within_their_condition() {
    let (files, own) = case::files();
    let mut failures = Vec::new();
    let mut ran = [0; METHODS.len()];
    let mut of_notes = METHODS.each_ref().map(|method| Errors::of(method.name));
    let cases = files.iter().flat_map(|file| {
        let notes = own && *file == case::own_files()[0];
        case::read(file).into_iter().map(move |case| (case, notes))
    });
    for (case, notes) in cases {
        if !case.kind.starts_with("top_") {
            continue;
        }
        if !case.has_path_conditions() {
            println!("{:<28} not run by integrators: no sens_path", case.id);
            continue;
        }
        for (i, method) in METHODS.iter().enumerate() {
            let judged =
                judge(&case, method, 1.0).and_then(|outcome| Ok((outcome, needle(&case)?)));
            match judged {
                Ok((outcome, needle)) if outcome.compared > 0 => {
                    let promised = method.promised * needle.max(1.0);
                    let allowed = if notes { *method.bound.end() } else { promised };
                    outcome.print(&case, method.name, allowed);
                    ran[i] += 1;
                    if notes {
                        of_notes[i].push_at(outcome.factor, &case.id);
                    }
                    if !outcome.within(allowed) {
                        failures.push(format!("{} by {}: {outcome:?}", case.id, method.name));
                    }
                }
                Err(Trouble::Refused(error)) => {
                    failures.push(format!("{} by {}: {error}", case.id, method.name));
                }
                lacking => {
                    let outcome = lacking.map(|(outcome, _)| outcome);
                    case::print_not_run(&case, method.name, &outcome);
                }
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
    for (factors, method) in of_notes.iter().zip(&METHODS) {
        if own {
            factors.attain(method.bound.clone(), 14);
        } else {
            assert_eq!(factors.largest(), 0.0);
        }
    }
    println!("cases run, by method: {ran:?}");
}

/// A weight off by 1e-12 is refused in every case, by every method.
#[test]
fn a_damaged_weight_is_seen() {
    let mut ran = 0;
    for case in case::read(&case::own_files()[0]) {
        if !case.kind.starts_with("top_") {
            continue;
        }
        for method in &METHODS {
            let outcome = judge(&case, method, 1.0 + 1e-12).expect("a case that runs");
            // Measured: from 23 (asleep for most of the time) to 3000.
            assert!(outcome.factor > *method.bound.end(), "{}: {outcome:?}", case.id);
            ran += 1;
        }
    }
    assert_eq!(ran, 84);
}
