//! The figures of the page.

use super::sleeping::{kicked, reach};
use super::{Parameters, TOP, WHEEL, driven};
use kit::draw::{Axis, Camera, Curve, Ink, Panel, Side, Solid, View};
use kit::{Figure, Result, sampled, times};
use models::heavy_top::{Equations, direction};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::sincos;

use core::f64::consts::FRAC_PI_2;

/// All of them for both bodies; for one body, its own motion.
pub fn all(p: &Parameters) -> Result<Vec<Figure>> {
    let motions = p.motions()?;
    if driven::is_asked_for(p) {
        return driven::body(p)?.figures(Camera::new(-0.45, 0.38));
    }
    let mut figures = Vec::new();
    if motions.len() > 1 {
        figures.extend([top()?, wheel()?, tilt_reached()?, falls()?]);
    }
    for motion in &motions {
        figures.push(motion.angles(&Equations(motion.top))?);
        // The start, at -Y, lies on the near side.
        figures.push(motion.trace(Camera::new(-0.45, 0.38))?);
    }
    Ok(figures)
}

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

/// A circle about `centre`, or a part of it: in the plane of two unit vectors, between two
/// angles.
fn arc(
    centre: SpaceVector,
    (u, v): (SpaceVector, SpaceVector),
    radius: f64,
    (from, to): (f64, f64),
) -> impl Iterator<Item = SpaceVector> {
    times(from, to, 48).map(move |angle| {
        let (s, c) = sincos(angle);
        centre + (u * c + v * s) * radius
    })
}

/// A top that leans on its tip.
fn top() -> Result<Figure> {
    let (tilt, origin) = (0.45, SpaceVector::zero());
    let axis = direction(tilt, 1.2);
    let node = UP.cross(&axis) / UP.cross(&axis).norm();
    let (centre, beside) = (axis * 0.65, node * 0.72);
    let spin = arc(axis * 1.06, (node, axis.cross(&node)), 0.17, (-1.2, 3.4));
    let lean = times(0.0, tilt, 24).map(|theta| direction(theta, 1.2) * 1.3);
    View::new(
        "top",
        &format!(
            "A toy top leans on its tip O, {tilt} rad from the vertical Z; it spins about its axis z; its centre of mass \
             lies at the distance l from the tip, and the weight mg acts there"
        ),
    )
    .around(UP * 0.62, 0.92)
    .ground(origin, 0.6)
    .dashed([origin, UP * 1.5], Ink::Frame)
    .text(UP * 1.5, "$Z$", Ink::Frame, Side::Right)
    .solid(Solid::top(centre, axis, 0.65, 0.0), Ink::Body)
    .arrow(axis * 1.1, axis * 1.5, Ink::Body, "$z$", Side::Left)
    .turn(spin, Ink::Velocity)
    .turn(lean, Ink::Ink)
    .text(direction(0.5 * tilt, 1.2) * 1.34, "$\\theta$", Ink::Ink, Side::Above)
    .line([beside, beside + centre], Ink::Frame)
    .dashed([origin, beside], Ink::Frame)
    .dashed([centre, beside + centre], Ink::Frame)
    .text(beside + centre * 0.5, "$l$", Ink::Ink, Side::Left)
    .arrow_from_within(centre, centre - UP * 0.45, Ink::Force, "$mg$", Side::Right)
    .dot(centre, Ink::Ink, "", Side::Left)
    .dot(origin, Ink::Ink, "$O$", Side::Below)
    .figure()
}

/// A wheel hung by one end of its axle, to scale.
fn wheel() -> Result<Figure> {
    let origin = SpaceVector::zero();
    let axis = direction(FRAC_PI_2, 1.2);
    let radius = 0.78;
    let lever = radius * WHEEL.length / 0.33;
    let hub = axis * lever;
    let across = UP.cross(&axis);
    let level = |from: f64, to: f64| arc(origin, (axis, across), lever, (from, to));
    let spin = arc(hub, (across, UP), 1.1 * radius, (0.3, 1.1));
    View::new(
        "wheel",
        "A spinning bicycle wheel hangs by one end O of its level axle from a rope; the weight mg acts at the hub, at the \
         distance l from O; L points along the axle away from the rope, and the hub moves on a level circle around it",
    )
    .camera(Camera::new(0.6, 0.2))
    .around(UP * 0.1 + axis * 0.2, 1.02)
    .line([origin, UP * 1.02], Ink::Ink)
    .text(UP * 1.02, "rope", Ink::Ink, Side::Left)
    .dashed(level(0.0, core::f64::consts::TAU), Ink::Frame)
    .solid(Solid::wheel(hub, axis, radius, lever, 0.2), Ink::Body)
    .turn(level(0.35, 1.25), Ink::Velocity)
    .text(level(0.8, 0.8).next().unwrap_or(hub), "$\\dot\\phi$", Ink::Velocity, Side::Right)
    .turn(spin, Ink::Velocity)
    .text(hub + (across + UP) * (0.8 * radius), "$\\omega$", Ink::Velocity, Side::Right)
    .arrow(hub, hub + axis * 0.85, Ink::Momentum, "$L$", Side::Left)
    .arrow(hub, hub - UP * 0.55, Ink::Force, "$mg$", Side::Right)
    .dot(origin, Ink::Ink, "$O$", Side::Right)
    .figure()
}

/// The tilt on both figures of the sleeping top.
fn tilt() -> Axis {
    Axis::linear("tilt $\\theta$ / rad").range(0.0, reach(0.5))
}

/// The greatest tilt of an upright top after a kick, against its spin.
fn tilt_reached() -> Result<Figure> {
    let curve = |kick: f64| {
        sampled(times(0.5, 1.5, 150), |ratio| Ok((ratio, kicked(&TOP, ratio, kick)?.theta_max())))
    };
    let limit = times(0.5, 1.5, 200).map(|ratio| (ratio, reach(ratio)));
    let alt = format!(
        "The greatest tilt of an upright top against its spin: for a vanishing kick it is zero above the critical spin \
         and rises steeply below it, to {:.2} rad at 0.9 and {:.2} rad at half of it; real kicks round the corner",
        reach(0.9),
        reach(0.5)
    );
    Panel::new("tilt_reached", &alt)
        .x(Axis::linear("spin / critical spin"))
        .y(tilt())
        .curve(Curve::new(curve(3.0)?, Ink::Velocity).label("kick 3 rad/s"))
        .curve(Curve::new(curve(0.3)?, Ink::Body).label("0.3 rad/s"))
        .curve(Curve::new(limit, Ink::Ink).label("no kick"))
        .figure()
}

/// The tilt against time below the critical spin, for three kicks.
fn falls() -> Result<Figure> {
    let alt = format!(
        "Tilt against time at 0.9 of the critical spin after kicks of 1, 0.01 and 0.0001 rad/s: three humps of the \
         same height, {:.2} rad, each as much later as the one before",
        reach(0.9)
    );
    let mut panel = Panel::new("falls", &alt).x(Axis::linear("$t$ / s")).y(tilt());
    for (kick, ink, label) in [
        (1.0, Ink::Velocity, "kick 1 rad/s"),
        (1e-2, Ink::Body, "$10^{-2}$"),
        (1e-4, Ink::Ink, "$10^{-4}$"),
    ] {
        let motion = kicked(&TOP, 0.9, kick)?;
        let points = times(0.0, motion.nutation_period(), 400).map(|t| (t, motion.angles(t).theta));
        panel = panel.curve(Curve::new(points, ink).label(label));
    }
    panel.figure()
}
