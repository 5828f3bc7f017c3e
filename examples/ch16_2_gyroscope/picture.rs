//! The gyroscope on its stand: as it moves, and as two stills that show the cause.

use super::rotor::ROTOR;
use super::{Parameters, driven, motions};
use kit::draw::{Camera, Ink, Side, View};
use kit::{Figure, MovingPicture, Result, times};
use models::heavy_top::stand::{HUB, falling, on_stand};
use models::heavy_top::{Pose, direction};
use rotation_dynamics::frame::SpaceVector;

pub const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
/// The camera of the page's traces: the notes' start, phi = 0, lies at the left rim.
pub fn camera() -> Camera {
    Camera::new(0.3, 0.38)
}

/// Before and after: the torque of the weight at one moment, and where it has taken L and
/// with it the axis of a fast rotor a little later.
pub fn causes() -> Result<[Figure; 2]> {
    let before = Pose { theta: 0.8, phi: 0.2, zeta: 0.4 };
    let after = Pose { phi: 1.3, ..before };
    let up = |view: View| {
        let view = view.dashed([SpaceVector::zero(), UP * 1.2], Ink::Frame);
        view.text(UP * 1.2, "$Z$", Ink::Frame, Side::Right)
    };
    let first = on_stand(
        "cause_before",
        "A rotor leans to the left on its stand; L points along its axis; the weight pulls down at the wheel; \
         the torque lies level, at right angles to the axis, and from the tip of L an arrow dL points the same way",
        &before,
    );
    let second = on_stand(
        "cause_after",
        "The same rotor a little later: L has moved along dL, sideways, and the axis with it; torque and dL have \
         turned with the axis; a level arc joins the old tip of L to the new",
        &after,
    );
    let arc = times(before.phi, after.phi, 24).map(|phi| {
        let length = before.along().norm();
        direction(before.theta, phi) * length
    });
    let second = second
        .line(arc, Ink::Momentum)
        .dashed([SpaceVector::zero(), before.along()], Ink::Momentum);
    Ok([
        before.with_cause(up(first), HUB, 1.0, before.along(), 1.0).figure()?,
        after.with_cause(up(second), HUB, 1.0, after.along(), 1.0).figure()?,
    ])
}

/// The motion asked for, or the rotor released at rest, which draws cusps.
pub fn moving(p: &Parameters) -> Result<MovingPicture> {
    let mut motions = motions(p)?;
    let stage = |pose: &Pose| on_stand("scene", "scene", pose);
    if driven::is_asked_for(p) {
        return driven::rotor(p)?.moving(HUB, stage);
    }
    let motion = motions.swap_remove(if motions.len() > 1 { 3 } else { 0 });
    motion.moving(HUB, [ROTOR.i1, ROTOR.i3, ROTOR.weight_moment()], stage, falling)
}
