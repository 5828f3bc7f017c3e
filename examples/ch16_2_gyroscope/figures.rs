//! The figures of the page.

use super::limits::{FRICTION, beyond_leading_order, damped};
use super::{Equations, Parameters, price};
use rotation_dynamics::Result;
use rotation_dynamics::exact::heavy_top::ReducedTop;
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{acos, exp, pow, sincos};
use rotation_dynamics::report::Figure;
use rotation_dynamics::report::draw::{Axis, Camera, Curve, Ink, Panel, Side, Solid, View};
use rotation_dynamics::report::heavy_top::{Motion, direction};

/// All of them for the motions of the notes; for one motion, its own.
pub fn all(p: &Parameters) -> Result<Vec<Figure>> {
    let motions = super::motions(p)?;
    let mut figures = Vec::new();
    if motions.len() > 1 {
        figures.push(setup()?);
        figures.extend(valleys(&motions)?);
    }
    for motion in &motions {
        figures.push(motion.angles(&Equations::of(&motion.top))?);
        figures.push(motion.trace()?);
    }
    if motions.len() > 1 {
        figures.push(fast()?);
        figures.push(damped_angles()?);
        figures.push(damped_trace()?);
        figures.push(price::figure(&motions[1])?);
    }
    Ok(figures)
}

/// The rotor on its pivot, with angles, weight and angular momentum.
fn setup() -> Result<Figure> {
    let (theta, phi) = (0.9, 1.2);
    let axis = direction(theta, phi);
    let origin = SpaceVector::zero();
    let up = SpaceVector::new(0.0, 0.0, 1.0);
    let node = SpaceVector::new(sincos(phi).1, sincos(phi).0, 0.0);
    let hub = axis * 0.78;
    let tilt = (0..=24).map(|k| direction(theta * f64::from(k) / 24.0, phi) * 0.36);
    let azimuth = (0..=24).map(|k| {
        let (s, c) = sincos(phi * f64::from(k) / 24.0);
        SpaceVector::new(c, s, 0.0) * 0.5
    });
    // The rim turns as the right hand curls about the axis.
    let across = axis.cross(&node);
    let spin = (0..=24).map(|k| {
        let (s, c) = sincos(-2.4 + 1.7 * f64::from(k) / 24.0);
        axis * 1.16 + (node * c + across * s) * 0.22
    });
    View::new(
        "setup",
        "A disc on an axle that leans at the angle theta from the vertical through the pivot O; \
         the weight pulls down at the centre of the disc, the torque points along the line of nodes",
    )
    .camera(Camera::new(0.59, 0.3))
    .around(SpaceVector::new(0.0, -0.2, 0.4), 0.95)
    .dashed([origin, up * 1.3], Ink::Frame)
    .text(up * 1.3, "$Z$", Ink::Frame, Side::Right)
    .dashed([origin, SpaceVector::new(0.7, 0.0, 0.0)], Ink::Frame)
    .text(SpaceVector::new(0.7, 0.0, 0.0), "$X$", Ink::Frame, Side::Below)
    .turn(azimuth, Ink::Frame)
    .text(SpaceVector::new(sincos(0.4).1, sincos(0.4).0, 0.0) * 0.5, "$\\phi$", Ink::Ink, Side::Below)
    .line([origin, hub], Ink::Body)
    .solid(Solid::turned(hub, axis, &[(-0.04, 0.34), (0.04, 0.34)]), Ink::Body)
    .arrow(hub + axis * 0.04, axis * 1.34, Ink::Body, "$z$", Side::Left)
    .turn(spin, Ink::Velocity)
    .text(axis * 1.2 - across * 0.26, "$\\zeta$", Ink::Velocity, Side::Left)
    .turn(tilt, Ink::Ink)
    .text(direction(0.5 * theta, phi) * 0.4, "$\\theta$", Ink::Ink, Side::Above)
    .arrow(hub, hub - up * 0.5, Ink::Force, "$mg$", Side::Right)
    .arrow(origin, node * 0.8, Ink::Force, "torque, $x$", Side::Below)
    .dot(origin, Ink::Ink, "$O$", Side::AboveRight)
    .figure()
}

/// U_eff over a window of tilt and energy, with the lines of some motions, each
/// drawn where the motion is.
fn valley(
    name: &str,
    alt: &str,
    (from, to): (f64, f64),
    (low, high): (f64, f64),
    lines: &[(&Motion, &str)],
) -> Panel {
    let top = lines[0].0.top;
    let curve = (0..=800)
        .map(|k| from + (to - from) * f64::from(k) / 800.0)
        .map(|theta| (theta, top.effective_potential(theta)))
        .filter(|(_, u)| (low..=high).contains(u));
    let (bottom, depth) = top.minimum();
    let mut panel = Panel::new(name, alt)
        .x(Axis::linear("tilt $\\theta$ / rad").range(from, to))
        .y(Axis::linear("").range(low, high))
        .curve(Curve::new(curve, Ink::Energy).label("$U_{eff}$"))
        .dot(bottom, depth, Ink::Energy, "$U_{min}$", Side::Below);
    for &(motion, label) in lines {
        let (left, right) = (motion.exact.theta_min(), motion.exact.theta_max());
        let line = Curve::new([(left, motion.energy), (right, motion.energy)], Ink::Ink).thin();
        panel = panel
            .curve(line.label_at(label, right, motion.energy, Side::BelowRight))
            .dot(left, motion.energy, Ink::Ink, "", Side::Left)
            .dot(right, motion.energy, Ink::Ink, "", Side::Right);
    }
    if top.b() < 1.0 {
        // The tilt at which the precession reverses.
        panel = panel.upright(acos(top.b()), Ink::Frame, "$\\cos\\theta=b$");
    }
    panel
}

fn valleys(motions: &[Motion]) -> Result<Vec<Figure>> {
    let [_, nutating, loops, cusps, waves] = motions else {
        return Ok(Vec::new());
    };
    Ok(vec![
        valley(
            "valley_steep",
            "The effective potential for b = 1.2: a valley between two walls, with the energy 0.55 \
             between its turning points and the minimum marked",
            (0.1, 1.9),
            (0.3, 1.5),
            &[(nutating, "$\\tilde E=0.55$")],
        )
        .figure()?,
        valley(
            "valley_gentle",
            "The effective potential for b = 0.6: a wide valley; the energy of the loops runs across \
             the tilt where the precession reverses",
            (0.3, 2.1),
            (-0.12, 0.4),
            &[(loops, "loops, $0.11$")],
        )
        .figure()?,
        valley(
            "valley_bottom",
            "The bottom of the same valley, enlarged: the energy of the cusps ends on the tilt where the \
             precession reverses, that of the waves ends below it",
            (0.86, 1.22),
            (-0.0885, -0.075),
            &[(cusps, "cusps, $-0.08$"), (waves, "waves, $-0.085$")],
        )
        .figure()?,
    ])
}

/// How far the leading-order formulas of the fast rotor miss.
fn fast() -> Result<Figure> {
    let mut curves: [Vec<(f64, f64)>; 3] = Default::default();
    for k in 0..=24 {
        let ratio = pow(10.0, -4.0 + 3.0 * f64::from(k) / 24.0);
        for (curve, miss) in curves.iter_mut().zip(beyond_leading_order(ratio)?) {
            curve.push((ratio, miss.abs()));
        }
    }
    let [precession, frequency, dip] = curves;
    Panel::new(
        "fast",
        "Relative error of the three formulas of the fast rotor against c/a, on logarithmic axes: \
         three straight lines of slope one",
    )
    .x(Axis::log("$c/a$"))
    .y(Axis::log("relative error of the formula"))
    .curve(Curve::new(precession, Ink::Velocity).label("precession"))
    .curve(
        Curve::new(frequency, Ink::Ink)
            .dashed()
            .label("frequency of the nods"),
    )
    .curve(Curve::new(dip, Ink::Body).label("depth of the dip"))
    .figure()
}

const DAMPED_END: f64 = 60.0;

fn damped_angles() -> Result<Figure> {
    let solution = damped(DAMPED_END)?;
    let top = ReducedTop::new(2.0, 0.6, 0.2)?;
    let (bottom, _) = top.minimum();
    let mut line = Vec::new();
    for k in 0..=600 {
        let t = DAMPED_END * f64::from(k) / 600.0;
        line.push((t, solution.at(t)?[0]));
    }
    let depth = bottom - acos(top.b());
    let envelope = |sign: f64| {
        (0..=120).map(move |k| {
            let t = DAMPED_END * f64::from(k) / 120.0;
            (t, bottom + sign * depth * exp(-0.5 * FRICTION * t))
        })
    };
    Panel::new(
        "damped_angles",
        "The tilt against time with friction: nods that die away around a final tilt lower than the start",
    )
    .x(Axis::linear("$t'$"))
    .y(Axis::linear("tilt $\\theta$ / rad"))
    .curve(Curve::new(envelope(1.0), Ink::Frame).thin().dashed().label("$e^{-\\delta t'/2}$"))
    .curve(Curve::new(envelope(-1.0), Ink::Frame).thin().dashed())
    .level(bottom, Ink::Frame, "bottom of the valley")
    .curve(Curve::new(line, Ink::Body).label("$\\theta$"))
    .figure()
}

fn damped_trace() -> Result<Figure> {
    let solution = damped(DAMPED_END)?;
    let top = ReducedTop::new(2.0, 0.6, 0.2)?;
    let mut path = Vec::new();
    // Two thirds of a turn, so that the far side stays free.
    let points = 1600;
    for k in 0..=points {
        let state = solution.at(0.5 * DAMPED_END * f64::from(k) / f64::from(points))?;
        path.push(direction(state[0], state[2]));
    }
    let start = path[0];
    View::new(
        "damped_trace",
        "The path of the axis on the sphere with friction: cusps that soften into waves and then into a circle",
    )
    .camera(Camera::new(-0.45, 0.7))
    .sphere()
    .latitude(top.minimum().0)
    .turn(path[1500..1520].to_vec(), Ink::Body)
    .trace(path, Ink::Body)
    .arrow(SpaceVector::zero(), start, Ink::Body, "", Side::Left)
    .dot(start, Ink::Body, "start", Side::Left)
    .triad()
    .figure()
}
