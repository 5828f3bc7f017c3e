//! Steps at and beyond the stability limit, and resonance: a body that is braked about its axis
//! by lambda = 200/s, RK4 with steps h, where a step multiplies the spin by
//!
//! ```text
//! R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24,   z = -lambda h,   |R| = 1 at z = -2.785293563...
//! ```

use super::*;

const RATE: f64 = 200.0;

/// R of -z.
pub fn factor(z: f64) -> f64 {
    1.0 - z * (1.0 - z / 2.0 * (1.0 - z / 3.0 * (1.0 - z / 4.0)))
}

fn body() -> Solved<RigidBody> {
    Ok(RigidBody::new(PrincipalMoments::symmetric(1.0, 1.6)?))
}

fn answered(answer: Solved<f64>, condition: f64, naive: Naive) -> Result<Answered> {
    let answers = vec![(answer, By::Foretold.bound(condition))];
    Ok(Answered(condition, naive, answers))
}

/// The spin after `steps` steps of `z`/lambda, against R to that power of it.
fn braked(z: f64, steps: u32) -> Result<Answered> {
    let body = body()?;
    let scene = Scene::new(body).with(ViscousFriction::about_axis(RATE * 1.6)?);
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, 1.0))?;
    let end = f64::from(steps) * z / RATE;
    let stepper = Stepper::new(Method::Rk4, Resolution::Steps(u64::from(steps)))?;
    let spin = stepper.advance_as_usual(&scene, [0.0, end], &start);
    let slope = -1.0 + z * (1.0 - z / 2.0 * (1.0 - z / 3.0));
    let foretold = (0..steps).fold(1.0, |spin, _| spin * factor(z));
    // What z is off by, and what each step rounds.
    let condition = f64::from(steps) * (1.0 + (z * slope / factor(z)).abs());
    let answer = spin.map(|(end, _)| (body.angular_velocity(&end).z() / foretold - 1.0).abs());
    let off = (exp(-RATE * end) / foretold - 1.0).abs();
    let naive = ("exp(-lambda t), believed of any step", off);
    answered(answer, condition, naive)
}

/// Pushed in step with its own nutation: the transverse rate grows as N t/I1.
fn resonance(method: Method, steps: u64) -> Result<Answered> {
    let (i1, i3, spin, push, end) = (1.0, 1.6, 5.0, 0.01, 100.0);
    let nutation = (i3 - i1) / i1 * spin;
    let body = body()?;
    let torque = Torque::on_body("in step", move |t, _: &RigidBody, _: &_| {
        let (s, c) = sincos(nutation * t);
        BodyVector::new(push * c, push * s, 0.0)
    });
    let scene = Scene::new(body).with(torque.smooth());
    let start = body.state(Attitude::IDENTITY, BodyVector::new(0.0, 0.0, spin))?;
    let (s, c) = sincos(nutation * end);
    let grown = push * end / i1;
    let off = |method, steps| -> Solved<f64> {
        let stepper = Stepper::new(method, Resolution::Steps(steps))?;
        let (end, _) = stepper.advance_as_usual(&scene, [0.0, end], &start)?;
        let [p, q, _] = body.angular_velocity(&end).to_array();
        let (p, q) = (p - grown * c, q - grown * s);
        Ok((p * p + q * q).sqrt() / grown)
    };
    // The transverse part of a momentum that is mostly spin, turned with it.
    let condition = (nutation + spin) * end * (i3 * spin / (i1 * grown) + 1.0);
    let naive = off(Method::Rk4, 1000).unwrap_or(f64::NAN);
    answered(off(method, steps), condition, ("RK4, 1000 steps", naive))
}

family! { FAMILY, "stability": "Beyond the stability limit, and at resonance",
    by [By::Foretold], in ["rates"], seen in stepped::braked;
    "RK4, lambda h = 2", "stable is not accurate: it fades, at a rate of its own": braked(2.0, 100);
    "RK4, lambda h = 2.785, just inside", "stable is not accurate: it fades, at a rate of its own":
        braked(2.785, 100);
    "RK4, lambda h = 2.7856, just outside", "what should have died out long ago grows": braked(2.7856, 100);
    "RK4, lambda h = 3", "what should have died out long ago grows": braked(3.0, 10);
    "RK4, lambda h = 10", "what should have died out long ago grows": braked(10.0, 3);
    "pushed in step with its nutation", "an error of the phase puts it out of step":
        resonance(Method::GaussLegendre16, 1000);
}
