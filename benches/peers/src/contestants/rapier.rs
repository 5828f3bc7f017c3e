//! rapier3d: what the user of a game engine gets, in single precision, with
//! gyroscopic forces on and the gravity of a top as a torque in each step.

use crate::problem::{Motion, Problem};
use rapier3d::prelude::*;
use rotation_dynamics::Result;

/// The quaternion at the end of `problem` after this many steps.
///
/// # Errors
/// None for the problems of this crate.
pub fn steps(problem: &Problem, steps: u64) -> Result<[f64; 4]> {
    let (body, start) = problem.start()?;
    let [i1, i2, i3] = problem.moments().map(|i| i as f32);
    let rates = start.attitude.to_space(body.angular_velocity(&start));
    let [x, y, z] = rates.to_array().map(|w| w as f32);
    let turn = start.attitude.rotation_vector().to_array().map(|c| c as f32);
    let weight = match problem.motion {
        Motion::Top { c, .. } => c as f32,
        Motion::Free { .. } | Motion::Open { .. } => 0.0,
    };

    let mut world = PhysicsWorld::new();
    world.gravity = Vector::new(0.0, 0.0, 0.0);
    world.integration_parameters.dt = (problem.end / steps as f64) as f32;
    let properties = MassProperties::new(Vector::new(0.0, 0.0, 0.0), 1.0, Vector::new(i1, i2, i3));
    let handle = world.insert_body(
        RigidBodyBuilder::dynamic()
            .rotation(Vector::new(turn[0], turn[1], turn[2]))
            .angvel(Vector::new(x, y, z))
            .additional_mass_properties(properties)
            .gyroscopic_forces_enabled(true)
            .can_sleep(false),
    );
    for _ in 0..steps {
        if weight != 0.0 {
            let body = &mut world.bodies[handle];
            let axis = *body.rotation() * Vector::new(0.0, 0.0, 1.0);
            body.reset_torques(true);
            body.add_torque(Vector::new(-weight * axis.y, weight * axis.x, 0.0), true);
        }
        world.step();
    }
    let q = *world.bodies[handle].rotation();
    Ok([q.w, q.x, q.y, q.z].map(f64::from))
}
