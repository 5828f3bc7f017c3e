//! The torques that `solve` says its runs took, against those that were asked for.

use core::cell::Cell;
use rotation_dynamics::Result;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::{RigidBody, State};
use rotation_dynamics::effects::{Effect, Properties, check};
use rotation_dynamics::frame::{BodyVector, SpaceVector};
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::scene::Scene;

/// A push along L, which counts how often it is asked.
struct Pushes<'a>(&'a Cell<u64>);

/// A part of L a second.
const PUSH: f64 = 0.5;

impl Effect for Pushes<'_> {
    const PROPERTIES: Properties = Properties {
        on_time: false,
        smooth: true,
        ..Properties::ANYTHING
    };
    fn name(&self) -> &'static str {
        "push"
    }
    fn torque(&self, _t: f64, _: &RigidBody, state: &State) -> SpaceVector {
        self.0.set(self.0.get() + 1);
        state.angular_momentum * PUSH
    }
    fn torque_scale(&self, _t: f64, _: &RigidBody, state: &State) -> f64 {
        PUSH * state.angular_momentum.norm()
    }
}

/// Once a tenth was left out, the torques of runs that failed. Before any run an effect is looked
/// at, to see whether it is what it says; those looks are no work of a run, nor are a few along
/// the way, a hundredth at most. The damaged twin counts the run that is given alone.
#[test]
fn all_torques_are_counted() -> Result<()> {
    let asked = Cell::new(0);
    let moments = PrincipalMoments::new(1.0, 1.3, 1.7)?;
    let pushed = Scene::new(RigidBody::new(moments)).with(Pushes(&asked));
    let (phi, theta, zeta, end) = (0.1, 0.8, 0.2, 10.0);
    let attitude = Attitude::from_euler(EulerAngles { phi, theta, zeta })?;
    let rates = BodyVector::new(0.3, 0.2, 1.0);
    let start = pushed.body().state(attitude, rates)?;
    check(pushed.effects(), pushed.body(), [0.0, end], &start)?;
    let looks = asked.replace(0);
    let solved = pushed.solve(&start, end, 1e-9)?;
    let counted = asked.get() - looks;
    let missing = |torques: u64| counted.abs_diff(torques) as f64 / counted as f64;
    assert!(missing(solved.work.torques()) <= 1e-2);
    assert!(missing(solved.run.torques()) > 0.1);
    Ok(())
}
