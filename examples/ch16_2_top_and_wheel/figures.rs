//! The figures of the page.

use super::Parameters;
use super::TOP;
use super::sleeping::{kicked, reach};
use rotation_dynamics::Result;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{cos, sin};
use rotation_dynamics::report::Figure;
use rotation_dynamics::report::draw::{Axis, Camera, Curve, Ink, Panel, Side, Solid, View};
use rotation_dynamics::report::heavy_top::direction;

use core::f64::consts::FRAC_PI_2;

/// All of them for both bodies; for one body, its own motion.
pub fn all(p: &Parameters) -> Result<Vec<Figure>> {
    let motions = super::motions(p)?;
    let mut figures = Vec::new();
    if motions.len() > 1 {
        figures.extend([top()?, wheel()?, tilt_reached()?, falls()?]);
    }
    for motion in &motions {
        figures.push(motion.angles(&motion.top)?);
        figures.push(motion.trace(Camera::new(-0.45, 0.7))?);
    }
    Ok(figures)
}

fn camera() -> Camera {
    Camera::new(0.59, 0.3)
}

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

/// A top that leans on its tip.
fn top() -> Result<Figure> {
    let axis = direction(0.45, 1.2);
    let origin = SpaceVector::zero();
    let centre = axis * 0.62;
    View::new(
        "top",
        "A toy top leaning on its tip O; its centre of mass lies at the distance l from the tip, \
         and the weight acts there",
    )
    .camera(camera())
    .around(SpaceVector::new(0.0, -0.05, 0.55), 0.85)
    .dashed([origin, UP * 1.25], Ink::Frame)
    .text(UP * 1.25, "$Z$", Ink::Frame, Side::Right)
    .solid(
        Solid::turned(
            origin,
            axis,
            &[(0.0, 0.0), (0.5, 0.42), (0.66, 0.42), (0.74, 0.3)],
        ),
        Ink::Body,
    )
    .solid(
        Solid::turned(axis * 0.74, axis, &[(0.0, 0.05), (0.32, 0.05)]),
        Ink::Body,
    )
    .arrow(axis * 1.06, axis * 1.32, Ink::Body, "$z$", Side::Left)
    .arrow(centre, centre - UP * 0.5, Ink::Force, "$mg$", Side::Left)
    .dot(centre, Ink::Ink, "", Side::Left)
    .dot(origin, Ink::Ink, "$O$", Side::Below)
    .figure()
}

/// A wheel hung by one end of its axle.
fn wheel() -> Result<Figure> {
    let axis = direction(FRAC_PI_2, 1.2);
    let origin = SpaceVector::zero();
    let hub = axis * 0.62;
    let (u, v) = (UP, axis.cross(&UP));
    let ring = |radius: f64| {
        (0..=96).map(move |k| {
            let angle = core::f64::consts::TAU * f64::from(k) / 96.0;
            hub + u * (radius * cos(angle)) + v * (radius * sin(angle))
        })
    };
    let mut view = View::new(
        "wheel",
        "A bicycle wheel with a level axle hangs by one end O of the axle from a rope; the weight acts at the hub",
    )
    .camera(Camera::new(0.75, 0.25))
    .around(axis * 0.35 + UP * 0.1, 0.85)
    .line([origin, UP * 0.78], Ink::Ink)
    .text(UP * 0.78, "rope", Ink::Ink, Side::Right)
    .line([origin, axis * 0.72], Ink::Body);
    for k in 0..8 {
        let angle = 0.3 + core::f64::consts::TAU * f64::from(k) / 8.0;
        view = view.line(
            [hub, hub + u * (0.5 * cos(angle)) + v * (0.5 * sin(angle))],
            Ink::Frame,
        );
    }
    view.line(ring(0.5), Ink::Body)
        .line(ring(0.54), Ink::Body)
        .arrow(hub, axis * 1.15, Ink::Momentum, "$L$", Side::Below)
        .arrow(hub, hub - UP * 0.42, Ink::Force, "$mg$", Side::Right)
        .dot(origin, Ink::Ink, "$O$", Side::Right)
        .figure()
}

/// The greatest tilt of an upright top after a kick, against its spin.
fn tilt_reached() -> Result<Figure> {
    let curve = |kick: f64| -> Result<Vec<(f64, f64)>> {
        (0..=150)
            .map(|k| 0.5 + 1.0 * f64::from(k) / 150.0)
            .map(|ratio| Ok((ratio, kicked(&TOP, ratio, kick)?.theta_max())))
            .collect()
    };
    let limit = (0..=200)
        .map(|k| 0.5 + 1.0 * f64::from(k) / 200.0)
        .map(|r| (r, reach(r)));
    Panel::new(
        "tilt_reached",
        "The greatest tilt of an upright top against its spin: for a vanishing kick it is zero above the \
         critical spin and opens like a square root below it; real kicks round the corner",
    )
    .x(Axis::linear("spin / critical spin"))
    .y(Axis::angle("tilt reached"))
    .curve(Curve::new(curve(3.0)?, Ink::Velocity).label("kick 3 rad/s"))
    .curve(Curve::new(curve(0.3)?, Ink::Body).label("0.3 rad/s"))
    .curve(Curve::new(limit, Ink::Ink).label("no kick"))
    .figure()
}

/// The tilt against time below the critical spin, for three kicks.
fn falls() -> Result<Figure> {
    let mut panel = Panel::new(
        "falls",
        "Tilt against time at 0.9 of the critical spin after kicks of 1, 0.01 and 0.0001 rad/s: \
         each factor of a hundred in the kick delays the same fall by the same time",
    )
    .x(Axis::linear("$t$ / s"))
    .y(Axis::angle("tilt $\\theta$").range(0.0, 1.0));
    for (kick, ink, label) in [
        (1.0, Ink::Velocity, "kick 1 rad/s"),
        (1e-2, Ink::Body, "$10^{-2}$"),
        (1e-4, Ink::Ink, "$10^{-4}$"),
    ] {
        let motion = kicked(&TOP, 0.9, kick)?;
        let end = 0.5 * motion.nutation_period();
        let points = (0..=300).map(|k| {
            let t = end * f64::from(k) / 300.0;
            (t, motion.angles(t).theta)
        });
        panel = panel.curve(Curve::new(points, ink).label(label));
    }
    panel.figure()
}
