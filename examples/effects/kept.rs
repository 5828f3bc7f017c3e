//! What follows from the effects of a scene: its conserved quantities, and the balance of power
//! for the energy that is not.

use super::*;
use rotation_dynamics::Result;
use rotation_dynamics::effects::{CoulombBearing, InternalDissipation, ViscousFriction};
use rotation_dynamics::integrators::scene::{components, state};
use rotation_dynamics::integrators::{Integrator, Ode};
use rotation_dynamics::math::EPS;
use rotation_dynamics::scene::Invariant;

// ANCHOR: balance
/// A scene beside the work that its effects do: W' = power.
pub struct WithWork<'s, E>(pub &'s Scene<E>);

impl<E: Effect> Ode<8> for WithWork<'_, E> {
    fn derivative(&self, t: f64, &[w, x, y, z, a, b, c, _]: &[f64; 8]) -> [f64; 8] {
        let y7 = [w, x, y, z, a, b, c];
        let [w, x, y, z, a, b, c] = self.0.derivative(t, &y7);
        // A state that is no number is noticed by the derivative.
        let power = state(&y7).map_or(f64::NAN, |state| self.0.power(t, &state));
        [w, x, y, z, a, b, c, power]
    }

    fn scale(&self, &[w, x, y, z, a, b, c, _]: &[f64; 8]) -> [f64; 8] {
        let y7 = [w, x, y, z, a, b, c];
        let [w, x, y, z, a, b, c] = self.0.scale(&y7);
        let body = self.0.body();
        let energy = state(&y7).map_or(1.0, |state| body.kinetic_energy(&state));
        [w, x, y, z, a, b, c, energy]
    }
}
// ANCHOR_END: balance

/// What a quantity is called in the table.
fn symbol(quantity: Invariant) -> &'static str {
    match quantity {
        Invariant::Energy => "energy",
        Invariant::MomentumX => "L_X",
        Invariant::MomentumY => "L_Y",
        Invariant::MomentumZ => "L_Z",
        Invariant::AxialMomentum => "L_z",
    }
}

/// A run of ten seconds: what acts, what is kept and how well, and the balance of the energy.
fn row<E: Effect>(name: &str, scene: &Scene<E>, start: &State) -> Result<[String; 5]> {
    let end = 10.0;
    let [w, x, y, z, a, b, c] = components(start);
    let method = Dop853::new(1e-15)?;
    let (at, work) = method.advance(&WithWork(scene), 0.0, &[w, x, y, z, a, b, c, 0.0], end)?;
    let [w, x, y, z, a, b, c, done] = at;
    let last = state(&[w, x, y, z, a, b, c])?;
    let energy = scene.body().kinetic_energy(start);
    let gained = scene.energy_at(end, &last) - scene.energy_at(0.0, start);
    let changed = |quantity| match quantity {
        Invariant::Energy => gained.abs() / energy,
        momentum => {
            let change = scene.value(momentum, &last) - scene.value(momentum, start);
            change.abs() / start.angular_momentum.norm()
        }
    };
    let drift = scene.invariants().map(changed).fold(0.0, f64::max) / (EPS * work.steps as f64);
    let names: Vec<&str> = scene.invariants().map(symbol).collect();
    let (kept, drift) = match names[..] {
        [] => ("nothing".to_owned(), "-".to_owned()),
        _ => (names.join(", "), short(drift, 2)),
    };
    let part = gained / energy;
    let told =
        if part.abs() < 1e-12 { "none".to_owned() } else { format!("{} of E", short(part, 3)) };
    let balance = rounded_up((part - done / energy).abs());
    Ok([name.to_owned(), kept, drift, told, balance])
}

/// Scenes of one effect and of two.
pub fn table() -> kit::Result<Table> {
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.6)?);
    let (phi, theta, zeta) = (0.4, 0.9, -0.3);
    let tilted = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
    let start = body.state(tilted, BodyVector::new(0.3, -0.2, 2.0))?;
    let free = Scene::new(body);
    let weight = GravityAtLever::new(0.5, 0.8)?;
    let bearing = CoulombBearing::new(0.02, &body, &start, 0.0)?;
    let oil = ViscousFriction::new(0.02, 0.01)?;
    let creaks = InternalDissipation::new(0.01)?;
    let held = GravityGradient::fixed(0.1, UP)?;
    let moving = GravityGradient::on_orbit(0.1, UP, ASIDE)?;
    let rows = [
        row("nothing", &free, &start)?,
        row("weight", &free.with(weight), &start)?,
        row("dry bearing", &free.with(bearing), &start)?,
        row("oil", &free.with(oil), &start)?,
        row("losses inside", &free.with(creaks), &start)?,
        row("gradient, from a fixed side", &free.with(held), &start)?,
        row("gradient, on an orbit", &free.with(moving), &start)?,
        row("weight and dry bearing", &free.with(weight).with(bearing), &start)?,
        row("weight and oil", &free.with(weight).with(oil), &start)?,
        row("weight and gradient from a fixed side", &free.with(weight).with(held), &start)?,
        row("losses inside and gradient on an orbit", &free.with(creaks).with(moving), &start)?,
    ];
    let columns = "what acts, kept, drift / eps a step, energy gained, less work done";
    Table::of("kept", columns.split(", "), rows, Ok)
}
