//! The figures of the page.

use super::friction::{FRICTION, damped, tilts};
use super::picture::{UP, camera, causes};
use super::{Equations, Parameters, driven, fast};
use kit::draw::{Axis, Curve, Ink, Panel, Side, View};
use kit::{Figure, Result, sampled, times};
use models::heavy_top::stand::{HUB, on_stand};
use models::heavy_top::{Motion, Pose, direction, extents};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{acos, exp, pow};

use core::f64::consts::PI;

/// All of them for the motions of the notes; for one motion, its own.
pub fn all(p: &Parameters) -> Result<Vec<Figure>> {
    let motions = super::motions(p)?;
    if driven::is_asked_for(p) {
        return driven::rotor(p)?.figures(camera());
    }
    let [steady, nutating, below_one @ ..] = motions.as_slice() else {
        return Ok(Vec::new());
    };
    let angles = |motion: &Motion| motion.angles(&Equations::of(&motion.top));
    if below_one.is_empty() {
        return Ok(vec![angles(steady)?, steady.trace(camera())?]);
    }
    let mut figures = Vec::from(causes()?);
    figures.push(setup()?);
    figures.extend(valleys(nutating, below_one)?);
    figures.extend([steady.trace(camera())?, nutating.trace(camera())?, angles(nutating)?]);
    let common = extents(below_one);
    for motion in below_one {
        figures.push(motion.trace(camera())?);
        figures.push(motion.angles_over(common, &Equations::of(&motion.top))?);
    }
    figures.extend([fast()?, damped_angles()?, damped_trace()?]);
    Ok(figures)
}

/// The rotor on its stand, with the angles that say where it is.
fn setup() -> Result<Figure> {
    let pose = Pose { theta: 0.8, phi: 0.8, zeta: 0.9 };
    let (axis, node, origin) = (pose.axis(), pose.node(), SpaceVector::zero());
    let hub = axis * HUB;
    let level = |phi: f64| Pose { phi, ..pose }.node();
    let mark = [0.1, 0.35].map(|out| hub + axis * 0.05 + pose.spoke(0.0) * out);
    let tilt = times(0.0, pose.theta, 24).map(|theta| direction(theta, pose.phi));
    let azimuth = times(0.0, pose.phi, 24).map(|phi| level(phi) * 0.6);
    // From the line of nodes, moved up to the disc, to the mark on it.
    let spin = times(-pose.zeta, 0.0, 24).map(|turn| hub + pose.spoke(turn) * 0.46);
    on_stand(
        "setup",
        "A wheel on an axle that leans on a stand, at the angle theta from the vertical Z through the pivot O; \
         the line of nodes lies level, at the angle phi from the fixed axis X and at right angles to the axle; \
         a marked spoke is at the angle zeta from the line of nodes; the weight pulls down at the centre of the wheel",
        &pose,
    )
    .camera(camera())
    .around(UP * 0.1, 1.2)
    .size(340, 300)
    .dashed([origin, UP * 1.3], Ink::Frame)
    .text(UP * 1.3, "$Z$", Ink::Frame, Side::Right)
    .dashed([origin, level(0.0)], Ink::Frame)
    .text(level(0.0), "$X$", Ink::Frame, Side::Below)
    .dashed([origin, node], Ink::Ink)
    .text(node, "$x$, line of nodes", Ink::Ink, Side::Below)
    .turn(azimuth, Ink::Frame)
    .text(
        level(0.75 * pose.phi) * 0.46,
        "$\\phi$",
        Ink::Ink,
        Side::Centre,
    )
    .dashed([hub, hub + node * 0.5], Ink::Frame)
    .line(mark, Ink::Ink)
    .turn(spin, Ink::Velocity)
    .text(hub + pose.spoke(-0.5 * pose.zeta) * 0.5, "$\\zeta$", Ink::Velocity, Side::Right)
    .arrow(axis, axis * 1.3, Ink::Body, "$z$", Side::Left)
    .turn(tilt, Ink::Ink)
    .text(direction(0.5 * pose.theta, pose.phi) * 1.03, "$\\theta$", Ink::Ink, Side::Above)
    .arrow(hub, hub - UP * 0.6, Ink::Force, "$mg$", Side::Left)
    .dot(origin, Ink::Ink, "$O$", Side::BelowRight)
    .figure()
}

/// U_eff over a window of tilt and energy, with the lines of some motions, each
/// drawn where the motion is.
fn valley(
    name: &str,
    (from, to): (f64, f64),
    (low, high): (f64, f64),
    lines: &[(&Motion, String)],
) -> Result<Figure> {
    let top = lines[0].0.top;
    let curve = times(from, to, 800)
        .map(|theta| (theta, top.effective_potential(theta)))
        .filter(|(_, u)| (low..=high).contains(u));
    let (bottom, depth) = top.minimum();
    let swings: Vec<String> = lines
        .iter()
        .map(|(m, _)| {
            let (energy, from, to) = (m.energy, m.exact.theta_min(), m.exact.theta_max());
            format!("{energy} from {from:.2} to {to:.2} rad")
        })
        .collect();
    let alt = format!(
        "The effective potential for b = {}, a valley whose bottom lies at {bottom:.2} rad; level lines mark swings at the energy {}",
        top.b(),
        swings.join(" and "),
    );
    let mut panel = Panel::new(name, &alt)
        .x(Axis::linear("tilt $\\theta$ / rad").range(from, to))
        .y(Axis::linear("energy").range(low, high))
        .curve(Curve::new(curve, Ink::Energy).label("$U_{eff}$"))
        .dot(bottom, depth, Ink::Energy, "$U_{min}$", Side::Below);
    for (motion, label) in lines {
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
    panel.figure()
}

fn valleys(nutating: &Motion, below_one: &[Motion]) -> Result<Vec<Figure>> {
    let [loops, cusps, waves] = below_one else {
        return Ok(Vec::new());
    };
    let label = |motion: &Motion| format!("$\\tilde E={}$", motion.energy);
    let named = |motion: &Motion| format!("{}, ${}$", motion.name, motion.energy);
    Ok(vec![
        valley("valley_steep", (0.1, 1.9), (0.2, 1.5), &[(nutating, label(nutating))])?,
        valley("valley_gentle", (0.3, 2.1), (-0.16, 0.4), &[(loops, named(loops))])?,
        valley(
            "valley_bottom",
            (0.86, 1.22),
            (-0.0905, -0.075),
            &[(cusps, named(cusps)), (waves, named(waves))],
        )?,
    ])
}

/// How far the leading-order formulas of the fast rotor miss, released at 60 degrees.
fn fast() -> Result<Figure> {
    let rows = sampled(times(-4.0, -1.0, 24), |exponent| {
        let ratio = pow(10.0, exponent);
        Ok((ratio, fast::beyond_the_formulas(PI / 3.0, ratio)?))
    })?;
    let line = |i: usize| rows.iter().map(move |(ratio, miss)| (*ratio, miss[i].abs()));
    let (low, high) = (rows[0].1, rows[rows.len() - 1].1);
    let alt = format!(
        "Relative error of the three formulas of the fast rotor against c/a from 0.0001 to 0.1, on logarithmic axes: \
         three straight lines of slope one, the dip's highest, from {:.1e} to {:.2}, the precession's lowest, from {:.1e} to {:.2}",
        low[2].abs(),
        high[2].abs(),
        low[0].abs(),
        high[0].abs(),
    );
    Panel::new("fast", &alt)
        .x(Axis::log("$c/a$"))
        .y(Axis::log("relative error of the formula"))
        .curve(Curve::new(line(0), Ink::Velocity).label_end("precession"))
        .curve(Curve::new(line(1), Ink::Ink).dashed().label_end("frequency"))
        .curve(Curve::new(line(2), Ink::Body).label_end("dip"))
        .figure()
}

const DAMPED_END: f64 = 60.0;

fn damped_angles() -> Result<Figure> {
    let (solution, (start, bottom)) = (damped(DAMPED_END)?, tilts()?);
    let line = sampled(times(0.0, DAMPED_END, 600), |t| Ok((t, solution.at(t)?[0])))?;
    let envelope = |sign: f64| {
        let depth = sign * (bottom - start);
        times(0.0, DAMPED_END, 120).map(move |t| (t, bottom + depth * exp(-0.5 * FRICTION * t)))
    };
    let alt = format!(
        "The tilt against time with friction: nods that begin at {start:.3} rad die away around {bottom:.3} rad, \
         within an envelope that shrinks by half in {:.0} units of t'",
        core::f64::consts::LN_2 / (0.5 * FRICTION),
    );
    Panel::new("damped_angles", &alt)
        .x(Axis::linear("$t'$"))
        .y(Axis::linear("tilt $\\theta$ / rad"))
        .curve(Curve::new(envelope(1.0), Ink::Frame).thin().dashed().label("$e^{-\\delta t'/2}$"))
        .curve(Curve::new(envelope(-1.0), Ink::Frame).thin().dashed())
        .level(bottom, Ink::Frame, "bottom")
        .curve(Curve::new(line, Ink::Body).label("$\\theta$"))
        .figure()
}

fn damped_trace() -> Result<Figure> {
    let (solution, (_, bottom)) = (damped(DAMPED_END)?, tilts()?);
    // Two thirds of a turn, so that the far side stays free.
    let path = sampled(times(0.0, 0.5 * DAMPED_END, 1600), |t| {
        let [theta, _, phi, _] = solution.at(t)?;
        Ok(direction(theta, phi))
    })?;
    let start = path[0];
    View::new(
        "damped_trace",
        "The path of the end of the axis on the sphere with friction: it begins with cusps that soften into waves and \
         then into a circle",
    )
    .camera(camera())
    .sphere()
    .latitude(bottom)
    .turn(path[1500..1520].to_vec(), Ink::Body)
    .trace(path, Ink::Body)
    .arrow(SpaceVector::zero(), start, Ink::Body, "", Side::Left)
    .dot(start, Ink::Body, "start", Side::Left)
    .triad()
    .figure()
}
