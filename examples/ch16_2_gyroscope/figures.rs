//! The figures of the page, and the gyroscope on its stand as it moves.

use super::friction::{FRICTION, damped, tilts};
use super::*;
use core::f64::consts::LN_2;
use kit::draw::Camera;
use models::heavy_top::stand::{HUB, falling, on_stand};
use models::heavy_top::{Pose, direction, extents};

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
const O: SpaceVector = SpaceVector::new(0.0, 0.0, 0.0);

/// The camera of the traces: the notes' start, phi = 0, lies at the left rim.
fn camera() -> Camera {
    Camera::new(0.3, 0.38)
}

/// All of them for the motions of the notes; for one motion, its own.
pub fn all(p: &Parameters) -> Result<Vec<Figure>> {
    let motions = motions(p)?;
    if rotor::is_driven(p) {
        return rotor::driven(p)?.figures(camera());
    }
    let angles = |motion: &Motion| motion.angles(&equations(motion.top, 0.0));
    let [steady, nutating, below_one @ ..] = &motions[..] else {
        return Ok(vec![angles(&motions[0])?, motions[0].trace(camera())?]);
    };
    let mut all = figures(&motions)?;
    all.extend([steady.trace(camera())?, nutating.trace(camera())?, angles(nutating)?]);
    let common = extents(below_one);
    for motion in below_one {
        all.push(motion.trace(camera())?);
        all.push(motion.angles_over(common, &equations(motion.top, 0.0))?);
    }
    Ok(all)
}

/// Before and after: the torque of the weight at one moment, and where it has taken L and
/// with it the axis of a fast rotor a little later.
const BEFORE: Pose = Pose { theta: 0.8, phi: 0.2, zeta: 0.4 };
const AFTER: Pose = Pose { phi: 1.3, ..BEFORE };

/// With the vertical, as tall as this.
fn upright(view: View, height: f64) -> View {
    let view = view.dashed([O, UP * height], Ink::Frame);
    view.text(UP * height, "$Z$", Ink::Frame, Side::Right)
}

/// U_eff over a window of tilt and energy, with the levels of some motions, each drawn where the
/// motion is, and what is to be seen.
fn valley<const N: usize>(
    (from, to): (f64, f64),
    (low, high): (f64, f64),
    levels: [(&Motion, &str); N],
) -> (String, Panel) {
    let top = levels[0].0.top;
    let curve = times(from, to, 800)
        .map(|theta| (theta, top.effective_potential(theta)))
        .filter(|(_, u)| (low..=high).contains(u));
    let (bottom, depth) = top.minimum();
    let energies = Axis::linear("energy").range(low, high);
    let mut panel =
        Panel::over_axes(Axis::linear("tilt $\\theta$ / rad").range(from, to), energies)
            .curve(Curve::new(curve, Ink::Energy).label("$U_{eff}$"))
            .dot(bottom, depth, Ink::Energy, "$U_{min}$", Side::Below);
    let mut swings = Vec::new();
    for (motion, name) in levels {
        let (energy, exact) = (motion.energy, &motion.exact);
        let (left, right) = (exact.theta_min(), exact.theta_max());
        let level = Curve::new([(left, energy), (right, energy)], Ink::Ink).thin();
        panel = panel
            .curve(level.label_at(&format!("{name}{energy}$"), right, energy, Side::BelowRight))
            .dot(left, energy, Ink::Ink, "", Side::Left)
            .dot(right, energy, Ink::Ink, "", Side::Right);
        swings.push(format!("{energy} from {left:.2} to {right:.2} rad"));
    }
    if top.b() < 1.0 {
        // The tilt at which the precession reverses.
        panel = panel.upright(acos(top.b()), Ink::Frame, "$\\cos\\theta=b$");
    }
    let alt = format!(
        "The effective potential for b = {}, a valley whose bottom lies at {bottom:.2} rad; level \
         lines mark swings at the energy {}",
        top.b(),
        swings.join(" and "),
    );
    (alt, panel)
}

/// How far the damped motion is drawn.
const END: f64 = 60.0;

figures! { motions: &[Motion],
    (told_steep, steep) = valley((0.1, 1.9), (0.2, 1.5), [(&motions[1], "$\\tilde E=")]),
    (told_gentle, gentle) = valley((0.3, 2.1), (-0.16, 0.4), [(&motions[2], "loops, $")]),
    (told_bottom, lowest) = valley((0.86, 1.22), (-0.0905, -0.075), [(&motions[3], "cusps, $"), (&motions[4], "waves, $")]),
    misses = sampled(times(-4.0, -1.0, 24), |exponent| {
        let ratio = pow(10.0, exponent);
        Ok((ratio, fast::beyond_the_formulas(fast::SHAPE, PI / 3.0, ratio)?.map(f64::abs)))
    })?,
    run = damped(END)?, (start, bottom) = tilts()?;

    /// A rotor leans to the left on its stand; L points along its axis; the weight pulls down at the wheel;
    /// the torque lies level, at right angles to the axis, and from the tip of L an arrow dL points the same way
    cause_before: BEFORE.with_cause(upright(on_stand("", "", &BEFORE), 1.2), HUB, 1.0, BEFORE.along(), 1.0);

    /// The same rotor a little later: L has moved along dL, sideways, and the axis with it; torque and dL have
    /// turned with the axis; a level arc joins the old tip of L to the new
    cause_after: {
        let length = BEFORE.along().norm();
        let arc = times(BEFORE.phi, AFTER.phi, 24).map(|phi| direction(BEFORE.theta, phi) * length);
        let view = on_stand("", "", &AFTER).line(arc, Ink::Momentum).dashed([O, BEFORE.along()], Ink::Momentum);
        AFTER.with_cause(upright(view, 1.2), HUB, 1.0, AFTER.along(), 1.0)
    };

    /// A wheel on an axle that leans on a stand, at the angle theta from the vertical Z through the pivot O;
    /// the line of nodes lies level, at the angle phi from the fixed axis X and at right angles to the axle;
    /// a marked spoke is at the angle zeta from the line of nodes; the weight pulls down at the centre of the wheel
    setup: {
        let pose = Pose { theta: 0.8, phi: 0.8, zeta: 0.9 };
        let (axis, node) = (pose.axis(), pose.node());
        let hub = axis * HUB;
        let level = |phi: f64| Pose { phi, ..pose }.node();
        let mark = [0.1, 0.35].map(|out| hub + axis * 0.05 + pose.spoke(0.0) * out);
        let tilt = times(0.0, pose.theta, 24).map(|theta| direction(theta, pose.phi));
        let azimuth = times(0.0, pose.phi, 24).map(|phi| level(phi) * 0.6);
        // From the line of nodes, moved up to the disc, to the mark on it.
        let spin = times(-pose.zeta, 0.0, 24).map(|turn| hub + pose.spoke(turn) * 0.46);
        upright(on_stand("", "", &pose), 1.3).camera(camera()).around(UP * 0.1, 1.2).size(340, 300)
            .dashed([O, level(0.0)], Ink::Frame)
            .text(level(0.0), "$X$", Ink::Frame, Side::Below)
            .dashed([O, node], Ink::Ink)
            .text(node, "$x$, line of nodes", Ink::Ink, Side::Below)
            .turn(azimuth, Ink::Frame)
            .text(level(0.75 * pose.phi) * 0.46, "$\\phi$", Ink::Ink, Side::Centre)
            .dashed([hub, hub + node * 0.5], Ink::Frame)
            .line(mark, Ink::Ink)
            .turn(spin, Ink::Velocity)
            .text(hub + pose.spoke(-0.5 * pose.zeta) * 0.5, "$\\zeta$", Ink::Velocity, Side::Right)
            .arrow(axis, axis * 1.3, Ink::Body, "$z$", Side::Left)
            .turn(tilt, Ink::Ink)
            .text(direction(0.5 * pose.theta, pose.phi) * 1.03, "$\\theta$", Ink::Ink, Side::Above)
            .arrow(hub, hub - UP * 0.6, Ink::Force, "$mg$", Side::Left)
            .dot(O, Ink::Ink, "$O$", Side::BelowRight)
    };

    valley_steep(told_steep): steep;
    valley_gentle(told_gentle): gentle;
    valley_bottom(told_bottom): lowest;

    /// Relative error of the three formulas of the fast rotor against c/a from 0.0001 to 0.1, on logarithmic axes:
    fast({
        let ([low, _, dip_low], [high, _, dip_high]) = (misses[0].1, misses[24].1);
        format!(" three straight lines of slope one, the dip's highest, from {dip_low:.1e} to {dip_high:.2}, \
                 the precession's lowest, from {low:.1e} to {high:.2}")
    }): {
        let line = |i: usize, ink| Curve::new(misses.iter().map(|(ratio, miss)| (*ratio, miss[i])), ink);
        Panel::over_axes(Axis::log("$c/a$"), Axis::log("relative error of the formula"))
            .curve(line(0, Ink::Velocity).label_end("precession"))
            .curve(line(1, Ink::Ink).dashed().label_end("frequency"))
            .curve(line(2, Ink::Body).label_end("dip"))
    };

    damped_angles(format!(
        "The tilt against time with friction: nods that begin at {start:.3} rad die away around {bottom:.3} rad, \
         within an envelope that shrinks by half in {:.0} units of t'",
        LN_2 / (0.5 * FRICTION),
    )): {
        let tilt = Curve::sampled(times(0.0, END, 600), |t| Ok(run.at(t)?[0]), Ink::Body)?;
        let envelope = |depth: f64| {
            let shrinks = |t| bottom + depth * exp(-0.5 * FRICTION * t);
            Curve::of(times(0.0, END, 120), shrinks, Ink::Frame).thin().dashed()
        };
        Panel::over_axes("$t'$", "tilt $\\theta$ / rad")
            .curve(envelope(bottom - start).label("$e^{-\\delta t'/2}$"))
            .curve(envelope(start - bottom))
            .level(bottom, Ink::Frame, "bottom")
            .curve(tilt.label("$\\theta$"))
    };

    /// The path of the end of the axis on the sphere with friction: it begins with cusps that soften into waves and
    /// then into a circle
    damped_trace: {
        // Two thirds of a turn, so that the far side stays free.
        let path = sampled(times(0.0, 0.5 * END, 1600), |t| {
            let [theta, _, phi, _] = run.at(t)?;
            Ok(direction(theta, phi))
        })?;
        let start = path[0];
        View::of(O, 1.12).camera(camera()).sphere()
            .latitude(bottom)
            .turn(path[1500..1520].to_vec(), Ink::Body)
            .trace(path, Ink::Body)
            .arrow(O, start, Ink::Body, "", Side::Left)
            .dot(start, Ink::Body, "start", Side::Left)
            .triad()
    };
}

/// The motion asked for, or the rotor released at rest, which draws cusps.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let mut motions = motions(p)?;
    let stage = |pose: &Pose| on_stand("scene", "scene", pose);
    if rotor::is_driven(p) {
        return rotor::driven(p)?.moving(HUB, stage);
    }
    let motion = motions.swap_remove(if motions.len() > 1 { 3 } else { 0 });
    let rotor = rotor::Rotor::new(&Parameters::default());
    let body = [rotor.i1, rotor.i3, rotor.weight_moment()];
    motion.moving(HUB, body, stage, falling)
}
