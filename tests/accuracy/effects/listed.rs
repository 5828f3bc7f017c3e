//! Effects in a list: the same bits as in the type.

use super::pairs::{air, bearing, creaks, held, lever, motor, oil, on_orbit, push};
use super::{body, tilted};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::erased::AnyEffect;
use rotation_dynamics::effects::{BoxedEffect, EffectList, Gravity};
use rotation_dynamics::frame::BodyVector;
use rotation_dynamics::integrators::{Dop853, GaussLegendre, Integrator};
use rotation_dynamics::scene::{Invariant, Scene};
use rotation_dynamics::{Error, Result};

const END: f64 = 3.0;

/// All that a scene says: what it solves, keeps, and how two methods carry it.
fn said<E: AnyEffect>(scene: &Scene<E>, start: &State) -> Vec<String> {
    let mut said: Vec<String> = [1e-3, 1e-6, 1e-9]
        .map(|tolerance| format!("{:?}", scene.solve(start, END, tolerance)))
        .into();
    let kept: Vec<Invariant> = scene.invariants().collect();
    let (energy, power) = (scene.energy_at(0.5, start), scene.power(0.5, start));
    said.push(format!("{kept:?} {energy:?} {power:?}"));
    let dop853 = Dop853::new(1e-6).expect("a tolerance");
    said.push(format!("{:?}", dop853.advance(scene, 0.0, start, END)));
    let gauss = GaussLegendre::new(40).expect("steps");
    said.push(format!("{:?}", gauss.advance(scene, 0.0, start, END)));
    said
}

fn listed(body: &RigidBody, effects: Vec<BoxedEffect>) -> Scene<EffectList> {
    Scene::new(*body).with_list(EffectList::new(effects).expect("one weight"))
}

#[test]
fn a_list_and_a_type_give_the_same_bits() {
    let mut ran = 0;
    let mut same = |typed: Vec<String>, scene: Scene<EffectList>, start: &State| {
        assert_eq!(typed, said(&scene, start), "{scene:?}");
        ran += 1;
    };
    for body in [body(1.0, 1.0, 0.6), body(1.0, 1.4, 0.6)] {
        let start = tilted(&body, [0.7, -0.4, 2.0]);
        let scene = Scene::new(body);
        same(said(&scene, &start), listed(&body, vec![]), &start);
        macro_rules! alone {
            ($($effect:expr),+) => {$(
                let typed = said(&scene.with($effect), &start);
                same(typed, listed(&body, vec![Box::new($effect)]), &start);
            )+};
        }
        alone!(lever(), held(), on_orbit(), oil(), air(), push(), creaks(), motor());
        let typed = said(&scene.with(lever()).with(oil()).with(motor()), &start);
        // The damaged twin: in another order the sum is rounded in another way.
        let other: Vec<BoxedEffect> = vec![Box::new(motor()), Box::new(oil()), Box::new(lever())];
        assert_ne!(typed, said(&listed(&body, other), &start));
        let list: Vec<BoxedEffect> = vec![Box::new(lever()), Box::new(oil()), Box::new(motor())];
        same(typed, listed(&body, list), &start);
        let typed = said(&scene.with(creaks()).with(on_orbit()).with(air()), &start);
        let list: Vec<BoxedEffect> =
            vec![Box::new(creaks()), Box::new(on_orbit()), Box::new(air())];
        same(typed, listed(&body, list), &start);
    }
    let round = body(1.0, 1.0, 0.6);
    let start = tilted(&round, [0.7, -0.4, 2.0]);
    let typed = said(&Scene::new(round).with(lever()).with(bearing(&round, &start)), &start);
    let list: Vec<BoxedEffect> = vec![Box::new(lever()), Box::new(bearing(&round, &start))];
    same(typed, listed(&round, list), &start);
    assert_eq!(ran, 2 * 11 + 1);
}

#[test]
fn a_list_with_two_weights_is_refused() -> Result<()> {
    let anywhere = Gravity::new(0.5, BodyVector::new(0.3, -0.2, 0.7))?;
    let refused = EffectList::new(vec![Box::new(lever()), Box::new(oil()), Box::new(anywhere)]);
    let Err(Error::Incompatible { effects, .. }) = refused else { panic!("{refused:?}") };
    assert_eq!(effects, "gravity, viscous friction, gravity");
    Ok(())
}

/// They go to other threads.
#[test]
fn scenes_with_lists_and_closures_are_send_and_sync() {
    fn both<T: Send + Sync>(_: &T) {}
    let body = body(1.0, 1.4, 0.6);
    both(&listed(&body, vec![Box::new(motor())]));
    both(&Scene::new(body).with(motor()));
}
