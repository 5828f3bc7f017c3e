//! The gyroscope as it is drawn: a spoked wheel on an axle of length 1, held at the origin by a
//! stand on a table.

use super::Pose;
use kit::draw::{Camera, Ink, Solid, View};
use rotation_dynamics::frame::SpaceVector;

/// Where the wheel sits on the axle.
pub const HUB: f64 = 0.6;
const RADIUS: f64 = 0.36;
const AXLE: f64 = 0.013;
/// Height of the pivot above the table.
const HEIGHT: f64 = 0.72;
const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

/// Wheel and axle in this pose.
pub fn rotor(pose: &Pose) -> Solid {
    wheel(pose).with(Solid::rod(SpaceVector::zero(), pose.axis(), AXLE))
}

fn wheel(pose: &Pose) -> Solid {
    Solid::flywheel(pose.axis() * HUB, pose.axis(), pose.spoke(0.0), RADIUS)
}

/// The rotor while it falls; `None` where it meets the table.
pub fn falling(pose: &Pose) -> Option<Solid> {
    let axis = pose.axis();
    let level = (1.0 - axis.z() * axis.z()).max(0.0).sqrt();
    let lowest = (HUB * axis.z() - RADIUS * level).min(axis.z());
    (lowest > -HEIGHT).then(|| rotor(pose))
}

/// The rotor on its stand on a table.
pub fn on_stand(name: &str, alt: &str, pose: &Pose) -> View {
    let origin = SpaceVector::zero();
    View::new(name, alt)
        // From here L and dL are not one behind the other at the first turning back.
        .camera(Camera::new(-0.7, 0.28))
        .with_slim_vectors()
        .around(UP * 0.11, 1.2)
        .size(340, 276)
        .table(UP * -HEIGHT, 1.1)
        .solid(Solid::stand(origin, HEIGHT, 0.26), Ink::Frame)
        .solid(Solid::rod(origin, pose.axis(), AXLE), Ink::Frame)
        .solid(wheel(pose), Ink::Body)
}
