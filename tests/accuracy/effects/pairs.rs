//! All pairs of effects: what they keep together is kept, and the energy that they do not keep
//! changes by the work that they do.

use super::{body, tilted};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::erased::AnyEffect;
use rotation_dynamics::effects::{
    BoxedEffect, CoulombBearing, DiscDrag, EffectList, Gravity, GravityAtLever, GravityGradient,
    InternalDissipation, PrescribedTorque, Profile, Torque, ViscousFriction, check,
};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::integrators::scene::{components, state};
use rotation_dynamics::integrators::{Dop853, Integrator, Ode};
use rotation_dynamics::scene::{Invariant, Scene};
use support::{EPS, Errors, assert_largest};

/// A scene beside the work that is done on it: W' = power, all of it or a part.
pub(super) struct WithWork<'s, E> {
    pub scene: &'s Scene<E>,
    pub part: f64,
}

impl<E: AnyEffect> Ode<8> for WithWork<'_, E> {
    fn derivative(&self, t: f64, &[w, x, y, z, a, b, c, _]: &[f64; 8]) -> [f64; 8] {
        let y7 = [w, x, y, z, a, b, c];
        let power = self.scene.power(t, &state(&y7).expect("finite"));
        let [w, x, y, z, a, b, c] = self.scene.derivative(t, &y7);
        [w, x, y, z, a, b, c, self.part * power]
    }

    fn scale(&self, &[w, x, y, z, a, b, c, _]: &[f64; 8]) -> [f64; 8] {
        let y7 = [w, x, y, z, a, b, c];
        let energy = self.scene.body().kinetic_energy(&state(&y7).expect("finite"));
        let [w, x, y, z, a, b, c] = self.scene.scale(&y7);
        [w, x, y, z, a, b, c, energy]
    }
}

pub(super) const ALL: [Invariant; 5] = [
    Invariant::Energy,
    Invariant::MomentumX,
    Invariant::MomentumY,
    Invariant::MomentumZ,
    Invariant::AxialMomentum,
];

const END: f64 = 5.0;

/// What the pairs did.
struct Book {
    body: RigidBody,
    start: State,
    /// Changes of what is kept, over eps and steps, as a part of its kind.
    drift: Errors,
    /// Changes of what is not.
    not_kept: Errors,
    /// Energy gained less work done, and less half of the work: the damaged twin.
    balance: Errors,
    half: Errors,
    refused: Vec<String>,
    ran: usize,
    kept: usize,
    /// What is kept all the same.
    unsaid: Vec<((&'static str, &'static str), Invariant)>,
    /// Pairs that keep the energy.
    energy: usize,
}

impl Book {
    fn of(body: RigidBody) -> Self {
        Self {
            start: tilted(&body, [0.7, -0.4, 2.0]),
            body,
            drift: Errors::of("drift of what is kept, eps a step"),
            not_kept: Errors::of("change of what is not kept"),
            balance: Errors::of("energy less work"),
            half: Errors::of("energy less half of the work"),
            refused: Vec::new(),
            ran: 0,
            kept: 0,
            unsaid: Vec::new(),
            energy: 0,
        }
    }

    fn pair(&mut self, a: BoxedEffect, b: BoxedEffect) {
        let names = (a.names()[0], b.names()[0]);
        let list = match EffectList::new(vec![a, b]) {
            Ok(list) => list,
            Err(error) => return self.refused.push(error.to_string()),
        };
        let scene = Scene::new(self.body).with_list(list);
        if let Err(error) = check(scene.effects(), &self.body, [0.0, END], &self.start) {
            self.refused.push(error.to_string());
            return;
        }
        self.ran += 1;
        let [w, x, y, z, l, m, n] = components(&self.start);
        let y8 = [w, x, y, z, l, m, n, 0.0];
        let method = Dop853::new(1e-15).expect("a tolerance");
        let method = method.with_longest_step(0.05).expect("a step");
        let problem = WithWork { scene: &scene, part: 1.0 };
        let (end, work) = method.advance(&problem, 0.0, &y8, END).expect("smooth");
        let [w, x, y, z, l, m, n, done] = end;
        let last = state(&[w, x, y, z, l, m, n]).expect("a state");
        let gained = scene.energy_at(END, &last) - scene.energy_at(0.0, &self.start);
        let kept: Vec<Invariant> = scene.invariants().collect();
        let changes =
            ALL.map(|quantity| scene.value(quantity, &last) - scene.value(quantity, &self.start));
        self.judge(names, [gained, done], &kept, changes, work.steps as f64);
    }

    fn judge(
        &mut self,
        names: (&'static str, &'static str),
        [gained, done]: [f64; 2],
        kept: &[Invariant],
        changes: [f64; 5],
        steps: f64,
    ) {
        let size = self.body.kinetic_energy(&self.start);
        self.balance.push_at((gained - done) / size, names);
        for (quantity, change) in ALL.into_iter().zip(changes) {
            let change = if quantity == Invariant::Energy {
                gained / size
            } else {
                change / self.start.angular_momentum.norm()
            };
            if kept.contains(&quantity) {
                self.drift.push_at(change / (EPS * steps), (names, quantity));
                self.kept += 1;
                self.energy += usize::from(quantity == Invariant::Energy);
            } else {
                if quantity == Invariant::Energy {
                    self.half.push_at((gained - 0.5 * done) / size, names);
                }
                if change.abs() < 1e-12 {
                    self.unsaid.push((names, quantity));
                    continue;
                }
                self.not_kept.push_at(change, (names, quantity));
            }
        }
    }

    /// Every effect that this body allows.
    fn every(&self) -> Vec<BoxedEffect> {
        let mut all: Vec<BoxedEffect> = vec![
            Box::new(lever()),
            Box::new(anywhere()),
            Box::new(held()),
            Box::new(on_orbit()),
            Box::new(oil()),
            Box::new(air()),
            Box::new(push()),
            Box::new(creaks()),
            Box::new(motor()),
        ];
        if self.body.moments().is_symmetric() {
            all.push(Box::new(bearing(&self.body, &self.start)));
        }
        all
    }
}

pub(super) fn lever() -> GravityAtLever {
    GravityAtLever::new(0.5, 0.8).expect("gravity")
}

pub(super) fn anywhere() -> Gravity {
    Gravity::new(0.5, BodyVector::new(0.3, -0.2, 0.7)).expect("gravity")
}

pub(super) fn held() -> GravityGradient<true> {
    GravityGradient::fixed(0.4, SpaceVector::new(1.0, 2.0, -0.5)).expect("gradient")
}

pub(super) fn on_orbit() -> GravityGradient {
    let (normal, towards) = (SpaceVector::new(0.0, 0.6, 0.8), SpaceVector::new(1.0, 0.0, 0.0));
    GravityGradient::on_orbit(0.4, normal, towards).expect("gradient")
}

pub(super) fn oil() -> ViscousFriction {
    ViscousFriction::new(0.03, 0.02).expect("friction")
}

pub(super) fn air() -> DiscDrag {
    DiscDrag::new(0.5, 1.204, 1.51e-5, 2.0).expect("drag")
}

pub(super) fn push() -> PrescribedTorque {
    let pulse = Profile::pulse(2.0, 0.7).expect("a pulse");
    PrescribedTorque::on_space(SpaceVector::new(0.3, -0.2, 0.4), pulse).expect("a torque")
}

pub(super) fn creaks() -> InternalDissipation {
    InternalDissipation::new(0.02).expect("a loss")
}

pub(super) fn motor() -> Torque<'static, true> {
    Torque::on_body("motor", |_t, _body, _state| BodyVector::new(0.0, 0.02, 0.05)).smooth()
}

pub(super) fn bearing(body: &RigidBody, start: &State) -> CoulombBearing {
    CoulombBearing::new(0.05, body, start, 0.0).expect("friction")
}

/// Every pair in both orders, and each with itself, on a symmetric body and on a brick.
#[test]
fn all_pairs_keep_what_they_say_and_do_the_work_they_say() {
    let mut books = [body(1.0, 1.0, 0.6), body(1.0, 1.4, 0.6)].map(Book::of);
    for book in &mut books {
        for n in 0..book.every().len() {
            for other in book.every() {
                let one = book.every().swap_remove(n);
                book.pair(one, other);
            }
        }
    }
    let [round, brick] = books;
    // Two weights (4), dry friction with what has a torque about the axis (2 x 8, and itself).
    assert_eq!((round.ran, round.refused.len()), (79, 21));
    assert_eq!((brick.ran, brick.refused.len()), (77, 4));
    assert_eq!((round.kept, brick.kept), (12, 12));
    // Of |L| and of the kinetic energy at the start, in eps a step.
    assert_largest!(round.drift, 12, @"0.206");
    assert_largest!(brick.drift, 12, @"0.0709");
    assert_largest!(round.balance, 79, @"2.19e-12");
    assert_largest!(brick.balance, 77, @"1.76e-12");
    round.half.exceed(2e-5, round.ran - round.energy);
    brick.half.exceed(3e-3, brick.ran - brick.energy);
    brick.not_kept.exceed(5e-4, 5 * 77 - 12);
    // That the gradient has no torque about the axis of a symmetric body its properties, which
    // holds for all bodies, cannot say.
    round.not_kept.exceed(1e-6, 5 * 79 - 12 - 8);
    let of_gradients = |((a, b), quantity): &((&str, &str), Invariant)| {
        *quantity == Invariant::AxialMomentum && [a, b].contains(&&"gravity gradient")
    };
    assert_eq!((round.unsaid.len(), brick.unsaid.len()), (8, 0));
    assert!(round.unsaid.iter().all(of_gradients), "{:?}", round.unsaid);
    let told = round.refused.iter().chain(&brick.refused);
    for refusal in told {
        assert!(refusal.contains("acts twice") || refusal.contains("Coulomb bearing"), "{refusal}");
    }
}
