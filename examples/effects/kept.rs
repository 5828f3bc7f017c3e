//! What follows from the effects of a scene: its conserved quantities, and the balance of power
//! for the energy that is not.

use kit::{Result, Table, rounded_up, short};
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{
    CoulombBearing, Effect, GravityAtLever, GravityGradient, InternalDissipation, ViscousFriction,
};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::scene::{components, state};
use rotation_dynamics::integrators::{Dop853, Integrator, Ode};
use rotation_dynamics::math::EPS;
use rotation_dynamics::scene::{Invariant, Scene};

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
    let momentum = start.angular_momentum.norm();
    let drift = (scene.invariants())
        .map(|quantity| {
            let (before, after) = match quantity {
                Invariant::Energy => (scene.energy_at(0.0, start), scene.energy_at(end, &last)),
                other => (scene.value(other, start), scene.value(other, &last)),
            };
            let size = if quantity == Invariant::Energy {
                energy
            } else {
                momentum
            };
            (after - before).abs() / size
        })
        .fold(0.0, f64::max);
    let gained = (scene.energy_at(end, &last) - scene.energy_at(0.0, start)) / energy;
    Ok(Drift {
        names: scene.invariants().map(symbol).collect(),
        drift: drift / (EPS * work.steps as f64),
        balance: (gained - done / energy).abs(),
        gained,
    })
}

/// Scenes of one effect and of two.
pub fn table() -> Result<Table> {
    let body = RigidBody::new(PrincipalMoments::symmetric(1.0, 0.6)?);
    let (phi, theta, zeta) = (0.4, 0.9, -0.3);
    let tilted = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
    let start = body.state(tilted, BodyVector::new(0.3, -0.2, 2.0))?;
    let free = Scene::new(body);
    let weight = GravityAtLever::new(0.5, 0.8)?;
    let bearing = CoulombBearing::new(0.02, &body, &start, 0.0)?;
    let oil = ViscousFriction::new(0.02, 0.01)?;
    let creaks = InternalDissipation::new(0.01)?;
    let up = SpaceVector::new(0.0, 0.0, 1.0);
    let aside = SpaceVector::new(1.0, 0.0, 0.0);
    let held = GravityGradient::fixed(0.1, up)?;
    let moving = GravityGradient::on_orbit(0.1, up, aside)?;
    let rows = [
        ("nothing", run(&free, &start)?),
        ("weight", run(&free.with(weight), &start)?),
        ("dry bearing", run(&free.with(bearing), &start)?),
        ("oil", run(&free.with(oil), &start)?),
        ("losses inside", run(&free.with(creaks), &start)?),
        (
            "gradient, from a fixed side",
            run(&free.with(held), &start)?,
        ),
        ("gradient, on an orbit", run(&free.with(moving), &start)?),
        (
            "weight and dry bearing",
            run(&free.with(weight).with(bearing), &start)?,
        ),
        ("weight and oil", run(&free.with(weight).with(oil), &start)?),
        (
            "weight and gradient from a fixed side",
            run(&free.with(weight).with(held), &start)?,
        ),
        (
            "losses inside and gradient on an orbit",
            run(&free.with(creaks).with(moving), &start)?,
        ),
    ];
    let columns = [
        "what acts",
        "kept",
        "drift / eps a step",
        "energy gained",
        "less work done",
    ];
    let mut table = Table::new("kept", columns)?;
    for (name, kept) in rows {
        let (names, drift) = if kept.names.is_empty() {
            ("nothing".to_owned(), "-".to_owned())
        } else {
            (kept.names.join(", "), short(kept.drift, 2))
        };
        let gained = if kept.gained.abs() < 1e-12 {
            "none".to_owned()
        } else {
            format!("{} of E", short(kept.gained, 3))
        };
        table.push([
            name.to_owned(),
            names,
            drift,
            gained,
            rounded_up(kept.balance),
        ])?;
    }
    Ok(table)
}
