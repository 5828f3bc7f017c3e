//! Steps at and beyond the stability limit, and resonance: a body that is braked about its axis
//! by lambda = 200/s, RK4 with steps h, where a step multiplies the spin by
//!
//! ```text
//! R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24,   z = -lambda h,   |R| = 1 at z = -2.785293563...
//! ```

use super::table::{Cell, Family, Naive, Row, bound};
use kit::Result;
use rotation_dynamics::accuracy::{Resolution, Stepper};
use rotation_dynamics::attitude::Attitude;
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::{Torque, ViscousFriction};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::Method;
use rotation_dynamics::math::{exp, sincos};
use rotation_dynamics::scene::Scene;

pub const FAMILY: Family = Family {
    key: "stability",
    title: "Beyond the stability limit, and at resonance",
    cure: "the eigenvalue tells beforehand what a step does to it; a phase in the body's own frame is not accumulated",
    methods: &["foretold by the method's own polynomial or solution"],
    forms: &["rates"],
    rows,
};

/// Per step, of what a step is given.
const K: f64 = 64.0;

const RATE: f64 = 200.0;

fn row(
    [case, wrong]: [&'static str; 2],
    answer: rotation_dynamics::Result<f64>,
    condition: f64,
    naive: (&'static str, f64),
) -> Result<Row> {
    let name = (case, FAMILY.methods[0], FAMILY.forms[0]);
    let cells = vec![Cell::of(name, answer, bound(K, condition))?];
    let (method, error) = naive;
    Ok(Row {
        case,
        wrong,
        condition,
        naive: Naive { method, error },
        cells,
    })
}

/// The spin after `steps` steps of `z`/lambda, against R to that power of it.
fn braked(words: [&'static str; 2], z: f64, steps: u32) -> Result<Row> {
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 1.6)?);
    let scene = Scene::new(body).with(ViscousFriction::about_axis(RATE * 1.6)?);
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 1.0))?;
    let end = f64::from(steps) * z / RATE;
    let stepper = Stepper::new(Method::Rk4, Resolution::Steps(u64::from(steps)))?;
    let spin = stepper
        .advance_as_usual(&scene, [0.0, end], &start)
        .map(|(end, _)| body.angular_velocity(&end).z());
    let grown = 1.0 - z * (1.0 - z / 2.0 * (1.0 - z / 3.0 * (1.0 - z / 4.0)));
    let slope = -1.0 + z * (1.0 - z / 2.0 * (1.0 - z / 3.0));
    let foretold = (0..steps).fold(1.0, |spin, _| spin * grown);
    // What z is off by, and what each step rounds.
    let condition = f64::from(steps) * (1.0 + (z * slope / grown).abs());
    let answer = spin.map(|spin| (spin / foretold - 1.0).abs());
    let naive = (
        "exp(-lambda t), believed of any step",
        (exp(-RATE * end) / foretold - 1.0).abs(),
    );
    row(words, answer, condition, naive)
}

/// Pushed in step with its own nutation: the transverse rate grows as N t/I1.
fn resonance(words: [&'static str; 2], method: Method, steps: u64) -> Result<Row> {
    let (i1, i3, spin, push, end) = (1.0, 1.6, 5.0, 0.01, 100.0);
    let nutation = (i3 - i1) / i1 * spin;
    let body = RigidBody::new(PrincipalMoments::symmetric(i1, i3)?);
    let torque = Torque::on_body("in step", move |t, _: &RigidBody, _: &_| {
        let (s, c) = sincos(nutation * t);
        BodyVector::new(push * c, push * s, 0.0)
    });
    let scene = Scene::new(body).with(torque.smooth());
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, spin))?;
    let (s, c) = sincos(nutation * end);
    let grown = push * end / i1;
    let off = |stepper: Stepper| -> rotation_dynamics::Result<f64> {
        let (end, _) = stepper.advance_as_usual(&scene, [0.0, end], &start)?;
        let [p, q, _] = body.angular_velocity(&end).to_array();
        let (p, q) = (p - grown * c, q - grown * s);
        Ok((p * p + q * q).sqrt() / grown)
    };
    let answer = off(Stepper::new(method, Resolution::Steps(steps))?);
    let naive = off(Stepper::new(Method::Rk4, Resolution::Steps(1000))?);
    // The transverse part of a momentum that is mostly spin, turned with it.
    let condition = (nutation + spin) * end * (i3 * spin / (i1 * grown) + 1.0);
    let naive = ("RK4, 1000 steps", naive.unwrap_or(f64::NAN));
    row(words, answer, condition, naive)
}

fn rows() -> Result<Vec<Row>> {
    let inside = "stable is not accurate: it fades, at a rate of its own";
    let outside = "what should have died out long ago grows";
    Ok(vec![
        braked(["RK4, lambda h = 2", inside], 2.0, 100)?,
        braked(["RK4, lambda h = 2.785, just inside", inside], 2.785, 100)?,
        braked(
            ["RK4, lambda h = 2.7856, just outside", outside],
            2.7856,
            100,
        )?,
        braked(["RK4, lambda h = 3", outside], 3.0, 10)?,
        braked(["RK4, lambda h = 10", outside], 10.0, 3)?,
        resonance(
            [
                "pushed in step with its nutation",
                "an error of the phase puts it out of step",
            ],
            Method::GaussLegendre16,
            1000,
        )?,
    ])
}
