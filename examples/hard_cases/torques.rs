//! Torques that jump, bend, stop the body, or damp it faster than a step.
//!
//! The body turns about its third axis alone, so the angle is known: twice the integral of the
//! torque.

use super::forms::Form;
use super::motions::By;
use super::table::{Cell, Family, Naive, Row, bound};
use rotation_dynamics::Result;
use rotation_dynamics::accuracy::{Limits, Resolution, Stepper};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    CoulombBearing, Effect, PrescribedTorque, Profile, Torque, ViscousFriction,
};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::Method;
use rotation_dynamics::math::{exp, expm1, sin};
use rotation_dynamics::scene::Scene;

pub const FAMILY: Family = Family {
    key: "torques",
    title: "Torques that jump, bend, stop and damp",
    cure: "a jump that is named ends a step; the stages of a Gauss method never stand on it",
    methods: &["solve", "Gauss-Legendre 16, piece by piece"],
    forms: &Form::NAMES,
    rows,
};

/// Moments (kg m^2), and the spin at the start (rad/s).
const MOMENTS: [f64; 2] = [1.0, 1.6];
const SPIN: f64 = 2.0;

/// A motion about one axis, and how it is known.
struct Turned<E> {
    scene: Scene<E>,
    /// Times at which a method is started anew (s), the end last.
    pieces: Vec<f64>,
    /// The longest step of a method of equal steps (s).
    step: f64,
    /// The angle turned (rad).
    angle: f64,
    /// What that is the sum of, each taken positive: its condition.
    size: f64,
}

fn start() -> Result<Attitude> {
    Attitude::from_euler(EulerAngles {
        phi: 0.3,
        theta: 0.8,
        zeta: 0.2,
    })
}

fn body() -> Result<RigidBody> {
    let [i1, i3] = MOMENTS;
    Ok(RigidBody::new(PrincipalMoments::symmetric(i1, i3)?))
}

fn state(attitude: Attitude) -> Result<State> {
    body()?.state(attitude, BodyVector::new(0.0, 0.0, SPIN))
}

impl<E: Effect> Turned<E> {
    fn end(&self) -> f64 {
        self.pieces.last().copied().unwrap_or_default()
    }

    fn truth(&self, attitude: Attitude) -> Result<Attitude> {
        Ok(attitude * Attitude::about_body_axis(BodyVector::new(0.0, 0.0, 1.0), self.angle)?)
    }

    /// A method restarted at each piece.
    fn by_pieces(&self, method: Method, attitude: Attitude) -> Result<Attitude> {
        let (mut t, mut now) = (0.0, state(attitude)?);
        for next in &self.pieces {
            let steps = ((next - t) / self.step).ceil().max(1.0) as u64;
            let resolution = Resolution::Steps(steps);
            let stepper = Stepper::new(method, resolution)?;
            (now, _) = stepper.advance_as_usual(&self.scene, [t, *next], &now)?;
            t = *next;
        }
        Ok(now.attitude)
    }

    fn dialled(&self, attitude: Attitude, asked: f64) -> Result<Attitude> {
        let limits = Limits::default();
        let solved = self
            .scene
            .solve_with(&state(attitude)?, self.end(), asked, &limits)?;
        Ok(solved.state.attitude)
    }

    fn row(&self, [case, wrong]: [&'static str; 2], naive: Naive) -> kit::Result<Row> {
        let truth = self.truth(start()?)?;
        let condition = 2.0 + self.size;
        let mut cells = Vec::new();
        for method in FAMILY.methods {
            for form in Form::ALL {
                let from = form.through(start()?)?;
                let by = match *method {
                    "solve" => By::Solve,
                    _ => By::Steps(Method::GaussLegendre16),
                };
                let held = bound(by.k(), condition);
                let end = match by {
                    By::Steps(method) => self.by_pieces(method, from),
                    _ => self.dialled(from, held),
                };
                let answer = end
                    .and_then(|end| form.through(end))
                    .map(|end| truth.angle_to(&end));
                cells.push(Cell::of((case, method, form.name()), answer, held)?);
            }
        }
        Ok(Row {
            case,
            wrong,
            condition,
            naive,
            cells,
        })
    }

    /// RK4 in so many equal steps, whatever the torque does.
    fn straight(&self, method: &'static str, steps: u64) -> Result<Naive> {
        let stepper = Stepper::new(Method::Rk4, Resolution::Steps(steps))?;
        let end = stepper.advance_as_usual(&self.scene, [0.0, self.end()], &state(start()?)?);
        let truth = self.truth(start()?)?;
        let error = end.map_or(f64::NAN, |(end, _)| truth.angle_to(&end.attitude));
        Ok(Naive { method, error })
    }
}

fn pushed(profile: Profile) -> Result<PrescribedTorque> {
    PrescribedTorque::on_body(BodyVector::new(0.0, 0.0, 1.0), profile)
}

/// On at 1/3, off at 7/3 of ten seconds: N (d (end - off) + d^2/2).
fn pushed_once(step: f64) -> Result<Turned<((), PrescribedTorque)>> {
    let (on, off, end, torque) = (1.0 / 3.0, 7.0 / 3.0, 10.0, 0.5);
    let lasts = off - on;
    let gained = torque / MOMENTS[1] * lasts * (end - off + 0.5 * lasts);
    let profile = Profile::steps(&[(on, torque), (off, 0.0)])?;
    Ok(Turned {
        scene: Scene::new(body()?).with(pushed(profile)?),
        pieces: vec![on, off, end],
        step,
        angle: SPIN * end + gained,
        size: SPIN * end + 2.0 * gained,
    })
}

/// A torque switched on and off, in so many equal steps: RK4 straight on, RK4 started anew at
/// each jump, Gauss-Legendre started anew (rad).
pub fn across_jumps(steps: u64) -> Result<[f64; 3]> {
    let pushed = pushed_once(10.0 / steps as f64)?;
    let truth = pushed.truth(start()?)?;
    let anew = |method| Ok(truth.angle_to(&pushed.by_pieces(method, start()?)?));
    Ok([
        pushed.straight("straight on", steps)?.error,
        anew(Method::Rk4)?,
        anew(Method::GaussLegendre16)?,
    ])
}

fn rows() -> kit::Result<Vec<Row>> {
    let mut rows = Vec::new();
    let [_, i3] = MOMENTS;
    let scene = Scene::new(body()?);

    let pushed_once = pushed_once(0.2)?;
    let words = [
        "a torque switched on and off",
        "a step across a jump is of order one",
    ];
    rows.push(pushed_once.row(
        words,
        pushed_once.straight("RK4 straight on, 10 000 steps", 10_000)?,
    )?);

    // A pulse of a fiftieth of a second in a minute.
    // Steps of 0.06 s have a stage at 30 s and one at 30.03 s.
    let (on, off, end, torque) = (30.005, 30.025, 60.0, 50.0);
    let lasts = off - on;
    let gained = torque / i3 * lasts * (end - off + 0.5 * lasts);
    let knocked = Turned {
        scene: scene.with(pushed(Profile::steps(&[(on, torque), (off, 0.0)])?)?),
        pieces: vec![on, off, end],
        step: 0.2,
        angle: SPIN * end + gained,
        size: SPIN * end + 2.0 * gained + torque / i3 * off * (end - off),
    };
    let words = [
        "a knock of 0.02 s in a minute",
        "every step passes over it and none of them sees it",
    ];
    rows.push(knocked.row(
        words,
        knocked.straight("RK4 straight on, 1000 steps", 1000)?,
    )?);

    // A bell a hundredth of a second wide: its area, as if it came all at once.
    let (centre, width, end, torque) = (30.0, 0.01, 60.0, 50.0);
    let gained = torque * width * core::f64::consts::TAU.sqrt() / i3 * (end - centre);
    let bell = PrescribedTorque::on_body(
        BodyVector::new(0.0, 0.0, torque),
        Profile::pulse(centre, width)?,
    )?;
    let rung = Turned {
        scene: scene.with(bell),
        pieces: vec![centre - 0.2, centre + 0.2, end],
        step: 0.004,
        angle: SPIN * end + gained,
        // Where on the bell a time is, doubles know to eps centre/width.
        size: SPIN * end + gained * (2.0 + centre / width),
    };
    let words = [
        "a smooth bell of 0.01 s in a minute",
        "it is analytic, and a step of 0.06 s sees its top or nothing",
    ];
    rows.push(rung.row(words, rung.straight("RK4 straight on, 1000 steps", 1000)?)?);

    // Rising to 1 at t = 1, falling to 0 at t = 3: areas 1/2 and 1, about 2/3 and 5/3.
    let end = 10.0;
    let gained = (0.5 * (end - 2.0 / 3.0) + end - 5.0 / 3.0) / i3;
    let bent = Turned {
        scene: scene.with(pushed(Profile::lines(&[
            (0.0, 0.0),
            (1.0, 1.0),
            (3.0, 0.0),
        ])?)?),
        pieces: vec![1.0, 3.0, end],
        step: 0.2,
        angle: SPIN * end + gained,
        size: SPIN * end + 2.0 * gained,
    };
    let words = ["a torque with kinks", "its slope jumps: no order above two"];
    rows.push(bent.row(words, bent.straight("RK4 straight on, 997 steps", 997)?)?);

    // Dry friction: L/tau until the stop, half of the way that the spin would make.
    let (tau, end) = (0.7, 10.0);
    let stop = i3 * SPIN / tau;
    let bearing = CoulombBearing::new(tau, &body()?, &state(start()?)?, 0.0)?;
    let stopped = Turned {
        scene: scene.with(bearing),
        pieces: vec![stop, end],
        step: 0.2,
        angle: 0.5 * SPIN * stop,
        size: 2.0 * SPIN * stop,
    };
    let words = [
        "dry friction to a stop",
        "its torque jumps where the motion ends",
    ];
    rows.push(stopped.row(words, stopped.straight("RK4 straight on, 997 steps", 997)?)?);

    // |sin t|: between its corners at k pi it is smooth; in each half wave its area is 2.
    let (pi, end) = (core::f64::consts::PI, 10.0);
    let corners = [pi, 2.0 * pi, 3.0 * pi];
    // Of a half wave from a to a + pi: 2 (end - a - pi/2); of the rest r: r - sin r.
    let rest = end - corners[2];
    let gained = (6.0 * end - 9.0 * pi + rest - sin(rest)) / i3;
    let drive = Torque::on_body("rectified", |t, _: &RigidBody, _: &State| {
        BodyVector::new(0.0, 0.0, sin(t).abs())
    });
    let rectified = Turned {
        scene: scene.with(drive.with_break_points(&corners)?),
        pieces: vec![corners[0], corners[1], corners[2], end],
        step: 0.2,
        angle: SPIN * end + gained,
        size: SPIN * end + 2.0 * gained,
    };
    let words = [
        "a torque that is a rectified sine",
        "three corners, no order above two across them",
    ];
    rows.push(rectified.row(
        words,
        rectified.straight("RK4 straight on, 997 steps", 997)?,
    )?);

    // Viscous: (1 - exp(-c t/I3)) I3/c of the spin.
    let (rate, end) = (200.0, 1.0);
    let damped = Turned {
        scene: scene.with(ViscousFriction::about_axis(rate * i3)?),
        pieces: vec![end],
        step: 0.5 / rate,
        angle: -SPIN * expm1(-rate * end) / rate,
        size: SPIN / rate * (1.0 + rate * end * exp(-rate * end)),
    };
    let words = [
        "damped in a 200th of the time",
        "a step is stable below 2.785/200 s only, long after nothing moves",
    ];
    rows.push(damped.row(words, damped.straight("RK4 with steps of 1/66 s", 66)?)?);
    Ok(rows)
}
