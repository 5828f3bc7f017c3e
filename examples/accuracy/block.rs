//! A body on which nothing acts, with its end in closed form: raced on the two pages on accuracy,
//! and on their cards of effects a block of steel of a decimetre that turns in a laboratory.

use rotation_dynamics::Result;
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::GravityGradient;
use rotation_dynamics::exact::free_body::FreeBody;
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::math::EPS;
use rotation_dynamics::scene::Scene;

/// The rate at which the Earth turns (rad/s).
pub const EARTH: f64 = 7.292e-5;

/// A body tilted as the free ones are, with these rates.
pub fn tilted(moments: PrincipalMoments, rates: BodyVector) -> Result<(RigidBody, State)> {
    let body = RigidBody::new(moments);
    let (phi, theta, zeta) = (0.3, 0.7, -0.4);
    let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
    Ok((body, body.state(attitude, rates)?))
}

/// The state of a body without torque after a time.
pub fn coasting(body: &RigidBody, state: &State, time: f64) -> Result<State> {
    let motion = Scene::new(*body).exact(state)?;
    State::new(motion.attitude(time), state.angular_momentum)
}

/// A motion without torque, for so many of its periods.
pub fn over(periods: f64, body: RigidBody, start: State, exact: FreeBody) -> Result<Problem<()>> {
    let end = periods * exact.rate_period();
    let answer = State::new(exact.attitude(end), start.angular_momentum)?;
    let problem = Problem::new(Scene::new(body), start, end, answer);
    Ok(problem.in_closed_form(move |t| exact.attitude(t)))
}

/// The rates with which L = (0.8, 0.8, 0.9) on the body's axes.
pub fn generic_rates(moments: PrincipalMoments) -> BodyVector {
    let [i1, i2, i3] = moments.to_array();
    BodyVector::new(0.8 / i1, 0.8 / i2, 0.9 / i3)
}

/// The block, with its end from the rates and not from the momentum, which is rounded once more
/// and is what a method is given. It turns at nearly a radian a second. And that rate.
pub fn steel(periods: f64) -> Result<(Problem<()>, f64)> {
    let moments = PrincipalMoments::new(1.0, 2.0, 8.0 / 3.0)?;
    let rates = generic_rates(moments);
    let (body, start) = tilted(moments, rates)?;
    let exact = FreeBody::new(moments, start.attitude, rates)?;
    Ok((over(periods, body, start, exact)?, rates.norm()))
}

/// How gravity changes with the height in a laboratory, and 3 g (I3 - I1) / (R_E I2 omega^2),
/// the number that says how much of it the block feels at this rate.
pub fn gradient(rate: f64) -> Result<(GravityGradient<true>, f64)> {
    let (gravity, radius): (f64, f64) = (9.81, 6.371e6);
    let number = 3.0 * gravity / radius * (8.0 / 3.0 - 1.0) / 2.0 / (rate * rate);
    let down = SpaceVector::new(0.0, 0.0, -1.0);
    Ok((GravityGradient::fixed((gravity / radius).sqrt(), down)?, number))
}

/// What the start, rounded, makes of the end, which no method can better: two motions in closed
/// form, their momenta apart by this part, and the angle between their ends in proportion.
pub fn rounded(block: &Problem<()>, apart: f64) -> Result<f64> {
    let end = |part: f64| -> Result<Attitude> {
        let start = State::new(block.start.attitude, block.start.angular_momentum * part)?;
        Ok(coasting(block.scene.body(), &start, block.end)?.attitude)
    };
    Ok(end(1.0)?.angle_to(&end(1.0 + apart)?) * EPS / apart)
}
