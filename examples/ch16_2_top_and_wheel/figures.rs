//! The figures of the page.

use super::sleeping::{kicked, reach};
use super::*;
use kit::draw::Camera;
use models::heavy_top::direction;

/// All of them for both bodies; for one body, its own motion.
pub fn all(p: &Parameters) -> Result<Vec<Figure>> {
    // The start, at -Y, lies on the near side.
    let (motions, camera) = (p.motions()?, Camera::new(-0.45, 0.38));
    if p.is_driven() {
        return p.driven()?.figures(camera);
    }
    let mut all = if motions.len() > 1 { figures(p)? } else { Vec::new() };
    for motion in &motions {
        all.extend([motion.angles(&Equations(motion.top))?, motion.trace(camera)?]);
    }
    Ok(all)
}

pub const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
pub const O: SpaceVector = SpaceVector::new(0.0, 0.0, 0.0);

/// A part of a circle about `centre`: in the plane of two unit vectors, between two angles.
fn arc(
    centre: SpaceVector,
    [u, v]: [SpaceVector; 2],
    radius: f64,
    [from, to]: [f64; 2],
) -> impl Iterator<Item = SpaceVector> {
    times(from, to, 48).map(move |angle| {
        let (s, c) = sincos(angle);
        centre + (u * c + v * s) * radius
    })
}

/// The tilt on both figures of the sleeping top.
fn tilt() -> Axis {
    Axis::linear("tilt $\\theta$ / rad").range(0.0, reach(0.5))
}

figures! { _: &Parameters;
    /// A toy top leans on its tip O, 0.45 rad from the vertical Z; it spins about its axis z; its centre of mass
    /// lies at the distance l from the tip, and the weight mg acts there
    top: {
        let axis = direction(0.45, 1.2);
        let node = UP.cross(&axis) / UP.cross(&axis).norm();
        let (centre, beside) = (axis * 0.65, node * 0.72);
        let spin = arc(axis * 1.06, [node, axis.cross(&node)], 0.17, [-1.2, 3.4]);
        let lean = times(0.0, 0.45, 24).map(|theta| direction(theta, 1.2) * 1.3);
        View::of(UP * 0.62, 0.92)
            .ground(O, 0.6)
            .dashed([O, UP * 1.5], Ink::Frame)
            .text(UP * 1.5, "$Z$", Ink::Frame, Side::Right)
            .solid(Solid::top(centre, axis, 0.65, 0.0), Ink::Body)
            .arrow(axis * 1.1, axis * 1.5, Ink::Body, "$z$", Side::Left)
            .turn(spin, Ink::Velocity)
            .turn(lean, Ink::Ink)
            .text(direction(0.5 * 0.45, 1.2) * 1.34, "$\\theta$", Ink::Ink, Side::Above)
            .line([beside, beside + centre], Ink::Frame)
            .dashed([O, beside], Ink::Frame)
            .dashed([centre, beside + centre], Ink::Frame)
            .text(beside + centre * 0.5, "$l$", Ink::Ink, Side::Left)
            .arrow_from_within(centre, centre - UP * 0.45, Ink::Force, "$mg$", Side::Right)
            .dot(centre, Ink::Ink, "", Side::Left)
            .dot(O, Ink::Ink, "$O$", Side::Below)
    };

    /// A spinning bicycle wheel hangs by one end O of its level axle from a rope; the weight mg acts at the hub, at the
    /// distance l from O; L points along the axle away from the rope, and the hub moves on a level circle around it
    wheel: {
        let (axis, radius) = (direction(FRAC_PI_2, 1.2), 0.78);
        // To scale.
        let lever = radius * WHEEL.length / 0.33;
        let (hub, across) = (axis * lever, UP.cross(&axis));
        let level = |from: f64, to: f64| arc(O, [axis, across], lever, [from, to]);
        View::of(UP * 0.1 + axis * 0.2, 1.02)
            .camera(Camera::new(0.6, 0.2))
            .line([O, UP * 1.02], Ink::Ink)
            .text(UP * 1.02, "rope", Ink::Ink, Side::Left)
            .dashed(level(0.0, TAU), Ink::Frame)
            .solid(Solid::wheel(hub, axis, radius, lever, 0.2), Ink::Body)
            .turn(level(0.35, 1.25), Ink::Velocity)
            .text((axis * cos(0.8) + across * sin(0.8)) * lever, "$\\dot\\phi$", Ink::Velocity, Side::Right)
            .turn(arc(hub, [across, UP], 1.1 * radius, [0.3, 1.1]), Ink::Velocity)
            .text(hub + (across + UP) * (0.8 * radius), "$\\omega$", Ink::Velocity, Side::Right)
            .arrow(hub, hub + axis * 0.85, Ink::Momentum, "$L$", Side::Left)
            .arrow(hub, hub - UP * 0.55, Ink::Force, "$mg$", Side::Right)
            .dot(O, Ink::Ink, "$O$", Side::Right)
    };

    tilt_reached(format!(
        "The greatest tilt of an upright top against its spin: for a vanishing kick it is zero above the critical spin \
         and rises steeply below it, to {:.2} rad at 0.9 and {:.2} rad at half of it; real kicks round the corner",
        reach(0.9), reach(0.5),
    )): {
        let kick = |kick: f64, ink| {
            Curve::sampled(times(0.5, 1.5, 150), |ratio| Ok(kicked(&TOP, ratio, kick)?.theta_max()), ink)
        };
        Panel::over_axes("spin / critical spin", tilt())
            .curve(kick(3.0, Ink::Velocity)?.label("kick 3 rad/s"))
            .curve(kick(0.3, Ink::Body)?.label("0.3 rad/s"))
            .curve(Curve::of(times(0.5, 1.5, 200), reach, Ink::Ink).label("no kick"))
    };

    falls(format!(
        "Tilt against time at 0.9 of the critical spin after kicks of 1, 0.01 and 0.0001 rad/s: three humps of the \
         same height, {:.2} rad, each as much later as the one before",
        reach(0.9),
    )): {
        let fall = |kick: f64, ink| -> Result<Curve> {
            let motion = kicked(&TOP, 0.9, kick)?;
            Ok(Curve::of(times(0.0, motion.nutation_period(), 400), |t| motion.angles(t).theta, ink))
        };
        Panel::over_axes("$t$ / s", tilt())
            .curve(fall(1.0, Ink::Velocity)?.label("kick 1 rad/s"))
            .curve(fall(1e-2, Ink::Body)?.label("$10^{-2}$"))
            .curve(fall(1e-4, Ink::Ink)?.label("$10^{-4}$"))
    };
}
