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

/// What a run says of a scene.
pub struct Drift {
    pub names: Vec<&'static str>,
    /// The largest change of a conserved quantity, as a part of its kind, over eps and steps.
    pub drift: f64,
    /// Energy gained less work done, as a part of the energy at the start.
    pub balance: f64,
    /// The energy gained, as such a part.
    pub gained: f64,
}

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

/// A run of ten seconds.
pub fn run<E: Effect>(scene: &Scene<E>, start: &State) -> Result<Drift> {
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
    let drift = scene.invariants().map(changed).fold(0.0, f64::max);
    Ok(Drift {
        names: scene.invariants().map(symbol).collect(),
        drift: drift / (EPS * work.steps as f64),
        balance: (gained / energy - done / energy).abs(),
        gained: gained / energy,
    })
}

/// A line a scene: what acts, and the scene.
macro_rules! runs {
    ($start:expr; $( $name:literal: $scene:expr; )+) => {
        [ $( ($name, run($scene, $start)?) ),+ ]
    };
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
    let rows = runs! { &start;
        "nothing": &free;
        "weight": &free.with(weight);
        "dry bearing": &free.with(bearing);
        "oil": &free.with(oil);
        "losses inside": &free.with(creaks);
        "gradient, from a fixed side": &free.with(held);
        "gradient, on an orbit": &free.with(moving);
        "weight and dry bearing": &free.with(weight).with(bearing);
        "weight and oil": &free.with(weight).with(oil);
        "weight and gradient from a fixed side": &free.with(weight).with(held);
        "losses inside and gradient on an orbit": &free.with(creaks).with(moving);
    };
    let columns = "what acts, kept, drift / eps a step, energy gained, less work done";
    Table::of("kept", columns.split(", "), rows, |(name, kept)| {
        let (names, drift) = match kept.names[..] {
            [] => ("nothing".to_owned(), "-".to_owned()),
            _ => (kept.names.join(", "), short(kept.drift, 2)),
        };
        let gained = match kept.gained.abs() < 1e-12 {
            true => "none".to_owned(),
            false => format!("{} of E", short(kept.gained, 3)),
        };
        let balance = rounded_up(kept.balance);
        Ok([name.to_owned(), names, drift, gained, balance])
    })
}
