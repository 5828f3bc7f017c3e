//! Torques that jump, bend, stop the body, or damp it faster than a step.
//!
//! The body turns about its third axis alone, so the angle is known: twice the integral of the
//! torque.

use super::rotations::start;
use super::*;
use rotation_dynamics::effects::{CoulombBearing, PrescribedTorque, Profile};

/// Moment about the axis (kg m^2), and the spin at the start (rad/s).
const I3: f64 = 1.6;
const SPIN: f64 = 2.0;

/// A motion about one axis, and how it is known.
struct Turned<E> {
    scene: Scene<((), E)>,
    /// Times at which a method is started anew (s), the end last.
    pieces: Vec<f64>,
    /// The longest step of a method of equal steps (s).
    step: f64,
    /// The angle turned (rad).
    angle: f64,
    /// What that is the sum of, each taken positive: its condition.
    size: f64,
}

fn body() -> Solved<RigidBody> {
    Ok(RigidBody::new(PrincipalMoments::symmetric(1.0, I3)?))
}

fn state(attitude: Attitude) -> Solved<State> {
    body()?.state(attitude, BodyVector::new(0.0, 0.0, SPIN))
}

impl<E: Effect> Turned<E> {
    /// By this effect, started anew at these times, in steps of 0.2 s.
    fn by(effect: E, pieces: &[f64], [angle, size]: [f64; 2]) -> Solved<Self> {
        let (scene, pieces) = (Scene::new(body()?).with(effect), pieces.to_vec());
        Ok(Self { scene, pieces, step: 0.2, angle, size })
    }

    fn end(&self) -> f64 {
        self.pieces.last().copied().unwrap_or_default()
    }

    fn truth(&self) -> Solved<Attitude> {
        let axis = BodyVector::new(0.0, 0.0, 1.0);
        Ok(start()? * Attitude::about_body_axis(axis, self.angle)?)
    }

    /// A method restarted at each piece.
    fn by_pieces(&self, method: Method, from: Attitude) -> Solved<Attitude> {
        let (mut t, mut now) = (0.0, state(from)?);
        for next in &self.pieces {
            let steps = ((next - t) / self.step).ceil().max(1.0) as u64;
            let stepper = Stepper::new(method, Resolution::Steps(steps))?;
            (now, _) = stepper.advance_as_usual(&self.scene, [t, *next], &now)?;
            t = *next;
        }
        Ok(now.attitude)
    }

    /// The error of RK4 in so many equal steps, whatever the torque does.
    fn straight(&self, steps: u64) -> Solved<f64> {
        let stepper = Stepper::new(Method::Rk4, Resolution::Steps(steps))?;
        let end = stepper.advance_as_usual(&self.scene, [0.0, self.end()], &state(start()?)?);
        let truth = self.truth()?;
        Ok(end.map_or(f64::NAN, |(end, _)| truth.angle_to(&end.attitude)))
    }

    /// `solve`, and Gauss-Legendre piece by piece, beside RK4 straight on.
    fn against(&self, method: &'static str, steps: u64) -> Result<Answered> {
        let (truth, condition) = (Some(self.truth()?), 2.0 + self.size);
        let bounds = METHODS.map(|by| by.bound(condition));
        let asked = in_each_form(start()?, truth, bounds[0], |from| {
            let solved = self.scene.solve(&state(from)?, self.end(), bounds[0])?;
            Ok(solved.state.attitude)
        });
        let in_pieces = in_each_form(start()?, truth, bounds[1], |from| {
            self.by_pieces(Method::GaussLegendre16, from)
        });
        let (naive, answers) = ((method, self.straight(steps)?), [asked, in_pieces]);
        Ok(Answered(condition, naive, answers.concat()))
    }
}

const METHODS: [By; 2] = [By::Request, By::Pieces];

/// A torque with this profile (N m) beside a turn that would go on; it gains an angle.
fn pushed(profile: Profile, pieces: [f64; 3], gained: f64) -> Solved<Turned<PrescribedTorque>> {
    let push = PrescribedTorque::on_body(BodyVector::new(0.0, 0.0, 1.0), profile)?;
    let turned = SPIN * pieces[2];
    Turned::by(push, &pieces, [turned + gained, turned + 2.0 * gained])
}

/// On and off at these times: N (d (end - off) + d^2/2).
fn switched([on, off, end]: [f64; 3], torque: f64) -> Solved<Turned<PrescribedTorque>> {
    let lasts = off - on;
    let gained = torque / I3 * lasts * (end - off + 0.5 * lasts);
    let profile = Profile::steps(&[(on, torque), (off, 0.0)])?;
    pushed(profile, [on, off, end], gained)
}

const ONCE: [f64; 3] = [1.0 / 3.0, 7.0 / 3.0, 10.0];

/// A torque switched on and off, in so many equal steps: RK4 straight on, RK4 started anew at
/// each jump, Gauss-Legendre started anew (rad).
pub fn across_jumps(steps: u64) -> Solved<[f64; 3]> {
    let mut pushed = switched(ONCE, 0.5)?;
    pushed.step = 10.0 / steps as f64;
    let truth = pushed.truth()?;
    let anew = |method| Ok(truth.angle_to(&pushed.by_pieces(method, start()?)?));
    let [rk4, gauss] = [anew(Method::Rk4)?, anew(Method::GaussLegendre16)?];
    Ok([pushed.straight(steps)?, rk4, gauss])
}

/// A pulse of a fiftieth of a second in a minute: steps of 0.06 s have a stage at 30 s and one at
/// 30.03 s.
fn knocked() -> Solved<Turned<PrescribedTorque>> {
    let (times, torque) = ([30.005, 30.025, 60.0], 50.0);
    let [_, off, end] = times;
    let mut knocked = switched(times, torque)?;
    knocked.size += torque / I3 * off * (end - off);
    Ok(knocked)
}

/// A bell a hundredth of a second wide: its area, as if it came all at once.
fn rung() -> Solved<Turned<PrescribedTorque>> {
    let (centre, width, end, torque) = (30.0, 0.01, 60.0, 50.0);
    let (turned, area) = (SPIN * end, torque * width * TAU.sqrt());
    let gained = area / I3 * (end - centre);
    let axis = BodyVector::new(0.0, 0.0, torque);
    let bell = PrescribedTorque::on_body(axis, Profile::pulse(centre, width)?)?;
    // Where on the bell a time is, doubles know to eps centre/width.
    let known = [turned + gained, turned + gained * (2.0 + centre / width)];
    let mut rung = Turned::by(bell, &[centre - 0.2, centre + 0.2, end], known)?;
    rung.step = 0.004;
    Ok(rung)
}

/// Rising to 1 at t = 1, falling to 0 at t = 3: areas 1/2 and 1, about 2/3 and 5/3.
fn bent() -> Solved<Turned<PrescribedTorque>> {
    let profile = Profile::lines(&[(0.0, 0.0), (1.0, 1.0), (3.0, 0.0)])?;
    let gained = (0.5 * (10.0 - 2.0 / 3.0) + 10.0 - 5.0 / 3.0) / I3;
    pushed(profile, [1.0, 3.0, 10.0], gained)
}

/// Dry friction: L/tau until the stop, half of the way that the spin would make.
fn stopped() -> Solved<Turned<CoulombBearing>> {
    let tau = 0.7;
    let stop = I3 * SPIN / tau;
    let bearing = CoulombBearing::new(tau, &body()?, &state(start()?)?, 0.0)?;
    let known = [0.5 * SPIN * stop, 2.0 * SPIN * stop];
    Turned::by(bearing, &[stop, 10.0], known)
}

/// |sin t|: between its corners at k pi it is smooth; in each half wave its area is 2.
fn rectified() -> Solved<Turned<impl Effect>> {
    let (end, corners) = (10.0, [PI, 2.0 * PI, 3.0 * PI]);
    // Of a half wave from a to a + pi: 2 (end - a - pi/2); of the rest r: r - sin r.
    let rest = end - corners[2];
    let gained = (6.0 * end - 9.0 * PI + rest - sin(rest)) / I3;
    let drive = Torque::on_body("rectified", |t, _: &RigidBody, _: &State| {
        BodyVector::new(0.0, 0.0, sin(t).abs())
    });
    let (drive, turned) = (drive.with_break_points(&corners)?, SPIN * end);
    let pieces = [corners.as_slice(), &[end]].concat();
    Turned::by(drive, &pieces, [turned + gained, turned + 2.0 * gained])
}

/// Viscous: (1 - exp(-c t/I3)) I3/c of the spin.
fn damped() -> Solved<Turned<ViscousFriction>> {
    let (rate, end) = (200.0, 1.0);
    let angle = -SPIN * expm1(-rate * end) / rate;
    let size = SPIN / rate * (1.0 + rate * end * exp(-rate * end));
    let friction = ViscousFriction::about_axis(rate * I3)?;
    let mut damped = Turned::by(friction, &[end], [angle, size])?;
    damped.step = 0.5 / rate;
    Ok(damped)
}

family! { FAMILY, "torques": "Torques that jump, bend, stop and damp",
    by METHODS, in NAMES, seen in stepped::bell;
    "a torque switched on and off", "a step across a jump is of order one":
        switched(ONCE, 0.5)?.against("RK4 straight on, 10 000 steps", 10_000);
    "a knock of 0.02 s in a minute", "every step passes over it and none of them sees it":
        knocked()?.against("RK4 straight on, 1000 steps", 1000);
    "a smooth bell of 0.01 s in a minute", "it is analytic, and a step of 0.06 s sees its top or nothing":
        rung()?.against("RK4 straight on, 1000 steps", 1000);
    "a torque with kinks", "its slope jumps: no order above two":
        bent()?.against("RK4 straight on, 997 steps", 997);
    "dry friction to a stop", "its torque jumps where the motion ends":
        stopped()?.against("RK4 straight on, 997 steps", 997);
    "a torque that is a rectified sine", "three corners, no order above two across them":
        rectified()?.against("RK4 straight on, 997 steps", 997);
    "damped in a 200th of the time", "a step is stable below 2.785/200 s only, long after nothing moves":
        damped()?.against("RK4 with steps of 1/66 s", 66);
}
