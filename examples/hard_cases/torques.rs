//! Torques that jump, bend, stop the body, or damp it faster than a step; and steps at and beyond
//! the stability limit.
//!
//! The body turns about its third axis alone, so the angle is known: twice the integral of the
//! torque.

use super::rotations::start;
use super::*;
use rotation_dynamics::effects::{CoulombBearing, PrescribedTorque, Profile};

/// Moment about the axis (kg m^2), and the spin at the start (rad/s).
const I3: f64 = 1.6;
const SPIN: f64 = 2.0;
const METHODS: [By; 2] = [SOLVE, By("Gauss-Legendre 16, piece by piece", 8.0, How::Own)];
const FORETOLD: By = By("foretold by the method's own polynomial or solution", 64.0, How::Own);

/// RK4 in so many equal steps, whatever the torque does.
type Straight = (&'static str, u64);

fn body() -> Solved<RigidBody> {
    Ok(RigidBody::new(PrincipalMoments::symmetric(1.0, I3)?))
}

fn state(attitude: Attitude) -> Solved<State> {
    body()?.state(attitude, BodyVector::new(0.0, 0.0, SPIN))
}

/// A motion about the axis by this effect: `solve`, and Gauss-Legendre started anew at each of
/// these times, the end last, in steps of at most so much (s), beside RK4 straight on. The angle
/// is known (rad), and the sum of its terms, each taken positive, which is its condition.
fn about_axis(
    effect: BoxedEffect,
    (pieces, longest): (&[f64], f64),
    [angle, size]: [f64; 2],
    (method, steps): Straight,
) -> Result<Answered> {
    let scene = Scene::new(body()?).with_list(EffectList::new(vec![effect])?);
    let axis = BodyVector::new(0.0, 0.0, 1.0);
    let truth = start()? * Attitude::about_body_axis(axis, angle)?;
    let run = |method, steps, [from, to]: [f64; 2], state: &State| {
        let stepper = Stepper::new(method, Resolution::Steps(steps))?;
        Ok(stepper.advance_as_usual(&scene, [from, to], state)?.0)
    };
    let (condition, end) = (2.0 + size, pieces.last().copied().unwrap_or_default());
    let (ends, [solve, in_pieces]) = ([start()?, truth], METHODS.map(|by| (by, condition)));
    let asked = in_each_form(solve, ends, |from| {
        Ok(scene.solve(&state(from)?, end, SOLVE.bound(condition))?.state.attitude)
    });
    let in_pieces = in_each_form(in_pieces, ends, |from| {
        let (mut t, mut now) = (0.0, state(from)?);
        for next in pieces {
            let steps = ((next - t) / longest).ceil().max(1.0) as u64;
            now = run(Method::GaussLegendre16, steps, [t, *next], &now)?;
            t = *next;
        }
        Ok(now.attitude)
    });
    let straight: Solved<State> = run(Method::Rk4, steps, [0.0, end], &state(start()?)?);
    let error = straight.map_or(f64::NAN, |end| truth.angle_to(&end.attitude));
    let cells = asked.into_iter().chain(in_pieces).collect();
    Ok(Answered { condition, naive: (method, error), cells })
}

/// A torque of this profile (N m) beside a turn that would go on; it gains an angle, and its
/// terms are so large.
fn pushed(
    (size, profile): (f64, Profile),
    pieces: (&[f64], f64),
    [gained, terms]: [f64; 2],
    rk4: Straight,
) -> Result<Answered> {
    let push = PrescribedTorque::on_body(BodyVector::new(0.0, 0.0, size), profile)?;
    let turn = pieces.0.last().map_or(0.0, |end| SPIN * end);
    let known = [turn + gained, turn + terms];
    about_axis(Box::new(push), pieces, known, rk4)
}

/// On and off at these times: N (d (end - off) + d^2/2). For a short one its place is a term too.
fn switched([on, off, end]: [f64; 3], torque: f64, place: f64, rk4: Straight) -> Result<Answered> {
    let gained = torque / I3 * (off - on) * (end - off + 0.5 * (off - on));
    let profile = Profile::steps(&[(on, torque), (off, 0.0)])?;
    let known = [gained, 2.0 * gained + place];
    pushed((1.0, profile), (&[on, off, end], 0.2), known, rk4)
}

family! { TORQUES, "torques": "Torques that jump, bend, stop and damp", |_| METHODS, in NAMES;
    "a torque switched on and off", "a step across a jump is of order one":
        switched([1.0 / 3.0, 7.0 / 3.0, 10.0], 0.5, 0.0, ("RK4 straight on, 10 000 steps", 10_000));
    // A pulse of a fiftieth of a second in a minute: steps of 0.06 s have a stage at 30 s and one at 30.03 s.
    "a knock of 0.02 s in a minute", "every step passes over it and none of them sees it": switched([30.005, 30.025, 60.0],
        50.0, 50.0 / I3 * 30.025 * (60.0 - 30.025), ("RK4 straight on, 1000 steps", 1000));
    // Its area, as if it came all at once. Where on the bell a time is, doubles know to eps centre/width.
    "a smooth bell of 0.01 s in a minute", "it is analytic, and a step of 0.06 s sees its top or nothing": {
        let (centre, width, torque) = (30.0, 0.01, 50.0);
        let gained = torque * width * TAU.sqrt() / I3 * (60.0 - centre);
        pushed((torque, Profile::pulse(centre, width)?), (&[centre - 0.2, centre + 0.2, 60.0], 0.004),
            [gained, gained * (2.0 + centre / width)], ("RK4 straight on, 1000 steps", 1000))
    };
    // Rising to 1 at t = 1, falling to 0 at t = 3: areas 1/2 and 1, about 2/3 and 5/3.
    "a torque with kinks", "its slope jumps: no order above two": {
        let gained = (0.5 * (10.0 - 2.0 / 3.0) + 10.0 - 5.0 / 3.0) / I3;
        pushed((1.0, Profile::lines(&[(0.0, 0.0), (1.0, 1.0), (3.0, 0.0)])?), (&[1.0, 3.0, 10.0], 0.2),
            [gained, 2.0 * gained], ("RK4 straight on, 997 steps", 997))
    };
    // L/tau until the stop, half of the way that the spin would make.
    "dry friction to a stop", "its torque jumps where the motion ends": {
        let stop = I3 * SPIN / 0.7;
        let bearing = CoulombBearing::new(0.7, &body()?, &state(start()?)?, 0.0)?;
        about_axis(Box::new(bearing), (&[stop, 10.0], 0.2), [0.5 * SPIN * stop, 2.0 * SPIN * stop],
            ("RK4 straight on, 997 steps", 997))
    };
    // |sin t|, smooth between its corners. A half wave from a to a + pi: 2 (end - a - pi/2); the rest r: r - sin r.
    "a torque that is a rectified sine", "three corners, no order above two across them": {
        let (end, corners) = (10.0, [PI, 2.0 * PI, 3.0 * PI]);
        let rest = end - corners[2];
        let (turn, gained) = (SPIN * end, (6.0 * end - 9.0 * PI + rest - sin(rest)) / I3);
        let drive = Torque::on_body("rectified", |t, _: &RigidBody, _: &State| BodyVector::new(0.0, 0.0, sin(t).abs()));
        about_axis(Box::new(drive.with_break_points(&corners)?), (&[PI, 2.0 * PI, 3.0 * PI, end], 0.2),
            [turn + gained, turn + 2.0 * gained], ("RK4 straight on, 997 steps", 997))
    };
    // Viscous: (1 - exp(-c t/I3)) I3/c of the spin.
    "damped in a 200th of the time", "a step is stable below 2.785/200 s only, long after nothing moves": {
        let (rate, end) = (RATE, 1.0);
        let known = [-SPIN * expm1(-rate * end) / rate, SPIN / rate * (1.0 + rate * end * exp(-rate * end))];
        about_axis(Box::new(ViscousFriction::about_axis(rate * I3)?), (&[end], 0.5 / rate), known,
            ("RK4 with steps of 1/66 s", 66))
    };
}

/// A brake (1/s): the spin falls as exp(-lambda t). A step of RK4 multiplies it by
///
/// ```text
/// R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24,   z = -lambda h,   |R| = 1 at z = -2.785293563...
/// ```
const RATE: f64 = 200.0;

/// The spin after `steps` steps of `z`/lambda, against R(-z) to that power.
fn braked(z: f64, steps: u32) -> Result<Answered> {
    let scene = Scene::new(body()?).with(ViscousFriction::about_axis(RATE * 1.6)?);
    let start = body()?.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 1.0))?;
    let end = f64::from(steps) * z / RATE;
    let stepper = Stepper::new(Method::Rk4, Resolution::Steps(u64::from(steps)))?;
    let spin = stepper.advance_as_usual(&scene, [0.0, end], &start);
    let slope = -1.0 + z * (1.0 - z / 2.0 * (1.0 - z / 3.0));
    let factor = 1.0 - z * (1.0 - z / 2.0 * (1.0 - z / 3.0 * (1.0 - z / 4.0)));
    let due = (0..steps).fold(1.0, |spin, _| spin * factor);
    // The error of z, and the rounding of each step.
    let condition = f64::from(steps) * (1.0 + (z * slope / factor).abs());
    let spin = spin.and_then(|(end, _)| Ok(body()?.angular_velocity(&end).z()));
    let answer = spin.map(|spin| (spin / due - 1.0).abs());
    let off = (exp(-RATE * end) / due - 1.0).abs();
    let naive = ("exp(-lambda t), believed of any step", off);
    Ok(Answered { condition, naive, cells: vec![FORETOLD.cell(condition, answer)] })
}

/// Pushed in step with its own nutation: the transverse rate grows as N t/I1.
fn resonance() -> Result<Answered> {
    let (i1, spin, push, end) = (1.0, 5.0, 0.01, 100.0);
    let nutation = (I3 - i1) / i1 * spin;
    let torque = Torque::on_body("in step", move |t, _: &RigidBody, _: &_| {
        let (s, c) = sincos(nutation * t);
        BodyVector::new(push * c, push * s, 0.0)
    });
    let scene = Scene::new(body()?).with(torque.smooth());
    let start = body()?.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, spin))?;
    let ((s, c), grown) = (sincos(nutation * end), push * end / i1);
    let off = |method| -> Solved<f64> {
        let stepper = Stepper::new(method, Resolution::Steps(1000))?;
        let (end, _) = stepper.advance_as_usual(&scene, [0.0, end], &start)?;
        let [p, q, _] = body()?.angular_velocity(&end).to_array();
        let (p, q) = (p - grown * c, q - grown * s);
        Ok((p * p + q * q).sqrt() / grown)
    };
    // The transverse part of a momentum that is mostly spin, turned with it.
    let condition = (nutation + spin) * end * (I3 * spin / (i1 * grown) + 1.0);
    let naive = ("RK4, 1000 steps", off(Method::Rk4).unwrap_or(f64::NAN));
    let cells = vec![FORETOLD.cell(condition, off(Method::GaussLegendre16))];
    Ok(Answered { condition, naive, cells })
}

family! { STABILITY, "stability": "Beyond the stability limit, and at resonance", |_| [FORETOLD], in ["rates"];
    "RK4, lambda h = 2", "stable is not accurate: it fades, at a rate of its own": braked(2.0, 100);
    "RK4, lambda h = 2.785, just inside", "stable is not accurate: it fades, at a rate of its own": braked(2.785, 100);
    "RK4, lambda h = 2.7856, just outside", "what should have died out long ago grows": braked(2.7856, 100);
    "RK4, lambda h = 3", "what should have died out long ago grows": braked(3.0, 10);
    "RK4, lambda h = 10", "what should have died out long ago grows": braked(10.0, 3);
    "pushed in step with its nutation", "an error of the phase puts it out of step": resonance();
}
