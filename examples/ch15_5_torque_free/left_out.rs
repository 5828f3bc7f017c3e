//! What this scene leaves out: the thrown disc in air, the cylinder for the rest.

use super::*;
use rotation_dynamics::effects::{DiscDrag, Effect, GravityGradient, Torque};

/// Mean motion of an orbit at the ground, squared: g over the radius of the Earth.
const GRADIENT: f64 = 9.80665 / 6.371e6;

/// The rate (rad/s) at which the gradient of gravity turns L, at most: on average over the
/// fast rotation the torque is 3/2 GRADIENT (I3 - I1) P_2(cos theta) sin(2 psi), with psi
/// the angle of L to the vertical.
pub fn gradient_rate(top: Top) -> f64 {
    let c = cos(top.tilt());
    1.5 * GRADIENT * (top.i3 - top.i1).abs() * (1.5 * c * c - 0.5) / top.momentum()
}

/// What a scene does in this time: the angle by which L has turned, the part of the rotation
/// about the axis that is lost, and what that cost.
fn run<E: Effect>(top: Top, effect: E, time: f64) -> Result<([f64; 2], String)> {
    let (body, start) = (top.body()?, top.state()?);
    let scene = Scene::new(body).with(effect);
    let (end, work) = Dop853::new(1e-14)?.advance(&scene, 0.0, &start, time)?;
    let (before, after) = (start.angular_momentum, end.angular_momentum);
    let turned = atan2(before.cross(&after).norm(), before.dot(&after));
    let slower = 1.0 - body.angular_velocity(&end).z() / top.omega_z;
    let cost = format!("closed form, {} torques", work.torques());
    Ok(([turned, slower], cost))
}

/// The card of effects.
pub fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (top, [_, disc]) = (top(p)?, of_the_notes());
    let (radius, density) = (0.1, DiscDrag::AIR_DENSITY);
    // The moment of the air on the front edge of the thrown disc, N m: a coefficient of 0.02, as a
    // flying disc has a few degrees off its balance, at 5 m/s. It is across flight, along X, and axis.
    let pitching = 0.02 * 0.5 * density * 25.0 * PI * radius * radius * (2.0 * radius);
    let forward = SpaceVector::new(1.0, 0.0, 0.0);
    let front_edge = Torque::on_space("air", move |_, _, state| {
        state.attitude.axis().cross(&forward) * pitching
    });
    let turned = pitching / disc.momentum();
    let air = DiscDrag::new(radius, density, DiscDrag::AIR_VISCOSITY, disc.omega_z)?;
    let slowed = -air.axial_torque(disc.omega_z) / (disc.i3 * disc.omega_z);
    // Steel: shear modulus 8e10 Pa, quality factor 100, shape factor 0.02.
    let size = p.radius.max(0.5 * p.height) * top.omega_z;
    let rate = 7850.0 * 0.02 * size * size * top.omega_z / (8e10 * 100.0);
    let (gradient, earth) = (gradient_rate(top).abs(), 7.292_115e-5);
    let ([tipped, _], tips) = run(disc, front_edge, 1.0)?;
    let ([_, braked], brakes) = run(disc, air, 1.0)?;
    // At 45 degrees to the vertical, for a round of the axis: what is turned by more has no such round.
    let slight = gradient < 0.1 * top.precession();
    let twist = GravityGradient::fixed(GRADIENT.sqrt(), SpaceVector::new(0.0, 1.0, 1.0))?;
    let twists = when(slight, || run(top, twist, top.round()))?;
    effect_card! { report,
        "air tips a thrown disc": "C_M rho v^2 pi R^3/(L Omega_P)" = turned / disc.precession(),
            costs turned, "rad a second, in the direction of L", measured tipped, at_cost tips;
        "air brakes its rotation": "torque/(I3 Omega_z Omega_P)" = slowed / disc.precession(),
            costs slowed, "of its rotation, a second", measured braked, at_cost brakes;
        "steel is not rigid, wobble dies or grows": "rho K^2 R^2 Omega_z^3/(mu Q Omega_P)" = rate / top.precession(),
            costs rate, "of tan(theta), a second";
        "gravity is weaker above": "3 |I3 - I1| g/(2 R_E L Omega_P)" = gradient / top.precession(),
            costs gradient, "rad a second, in the direction of L",
            measured twists.as_ref().map(|([turned, _], _)| turned / top.round()), within 1e-12 / top.round(),
            at_cost twists.map_or("-".into(), |(_, cost)| cost);
        "the Earth turns": "Omega_E/Omega_P" = earth / top.precession(), costs earth, "rad a second, at most";
    }
}
