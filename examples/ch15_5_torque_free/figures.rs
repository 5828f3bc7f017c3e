//! The drawings of the page, but for the cones.

use super::*;
use kit::Figure;
use kit::draw::{Axis, Camera, Curve, Ink, Panel, Side, Sketch, Solid, View};

/// The notes' cylinder and disc, whose moments are as 2 to 1 and as 1 to 2, tilted so far.
fn pair(tilt: f64) -> [Top; 2] {
    [Parameters::default(), DISC].map(|of| Top::cylinder(&of).tilted(tilt))
}

/// All figures of the page.
pub fn figures(p: &Parameters) -> Result<Vec<Figure>> {
    let [thin, flat] = pair(p.drawn_tilt);
    let [cylinder, disc] = [Parameters::default(), DISC].map(|of| Top::cylinder(&of));
    Ok(vec![
        order("order_thin", thin)?,
        order("order_flat", flat)?,
        cones::view("cones_thin", CONES[0], thin, 0.15 * thin.round())?.figure()?,
        cones::view("cones_flat", CONES[1], flat, 0.15 * flat.round())?.figure()?,
        positions("op_cylinder", pair(0.25)[0], 0.125)?,
        positions("op_disc", pair(0.25)[1], 0.25)?,
        turns([cylinder, disc])?,
        wobbles()?,
        in_body("in_body_cylinder", cylinder)?,
        in_body("in_body_disc", disc)?,
    ])
}

const CONES: [&str; 2] = [
    "Two cones with a common tip stand side by side: the grey one about L, the green one about \
     the axis z. They touch along a line, and the angular velocity lies on it.",
    "A narrow grey cone about L stands inside a wide green funnel about the axis z, whose near \
     half is cut away. It touches the funnel's wall along the angular velocity; L is between z and it.",
];

/// z, Omega and L in their plane, with Omega as the sum of its two parts.
fn order(name: &str, top: Top) -> Result<Figure> {
    let (theta, alpha, o) = (top.tilt(), top.lean(), (0.0, 0.0));
    let at = |angle: f64, length: f64| (length * sin(angle), length * cos(angle));
    let thin = alpha < theta;
    let unit = if thin { 0.95 } else { 0.5 } / hypot(top.omega_y, top.omega_z);
    let p = at(0.0, unit * top.precession());
    let s = at(theta, unit * top.spin());
    let omega = (p.0 + s.0, p.1 + s.1);
    let between = if thin { "the angular velocity" } else { "L" };
    let sides = if thin { (0.36, 1.08) } else { (1.16, 0.1) };
    let alt = format!(
        "The axis z, the angular velocity and L in one plane, {between} between the other two. \
         The angular velocity is the diagonal of a parallelogram on its part along L and its part {} z.",
        if thin { "along" } else { "against" },
    );
    // Angles of the drawing are counted from the right, counterclockwise.
    let turn = |angle: f64| 0.5 * PI - angle;
    let arc = |from: f64, to: f64| (turn(from.max(to)), turn(from.min(to)));
    let part = |to| Curve::new([omega, to], Ink::Velocity).thin().dashed();
    let (wide, radii) = (theta - alpha, if thin { (0.42, 0.3) } else { (0.34, 0.46) });
    Sketch::new(name, &alt)
        .window((-0.75, 1.05), (-0.62, 1.36))
        .ghost(|sketch| sketch.block(o, sides, -theta, Ink::Body))
        .curve(part(p))
        .curve(part(s))
        .arrow(o, at(theta, 1.24), Ink::Body, "", Side::Right)
        .arrow(o, at(0.0, 1.24), Ink::Momentum, "", Side::Above)
        .arrow(o, p, Ink::Velocity, "", Side::Left)
        .arrow(o, s, Ink::Velocity, "", Side::Right)
        .arrow(o, omega, Ink::Velocity, "", Side::Right)
        .text(at(theta, 1.24), "$z$", Ink::Body, Side::Right)
        .text(at(0.0, 1.24), "$L$", Ink::Momentum, Side::Above)
        .text(p, r"$\Omega_P$", Ink::Velocity, if thin { Side::Left } else { Side::Right })
        .text(s, r"$\Omega_S$", Ink::Velocity, if thin { Side::Right } else { Side::BelowLeft })
        .text(omega, r"$\Omega$", Ink::Velocity, if thin { Side::Above } else { Side::Left })
        .angle(o, radii.0, arc(0.0, theta), r"$\theta$")
        .angle(o, radii.1, arc(theta, wide), r"$\alpha$")
        .figure()
}

/// Five positions of a body and of its line OP, a part of a turn of the axis apart.
fn positions(name: &str, top: Top, part: f64) -> Result<Figure> {
    let (flat, camera) = (top.i3 > top.i1, (0.6, 0.62));
    let (half, radius) = if flat { (0.05, 0.52) } else { (0.42, 0.28) };
    let right = SpaceVector::new(-sin(camera.0), cos(camera.0), 0.0);
    let up = SpaceVector::new(0.0, 0.0, 1.0);
    let alt = format!(
        "Five pictures of a tilted {} while its axis makes {} of a turn about the vertical L. The \
         line OP on its end face turns {} in all.",
        if flat { "disc" } else { "cylinder" },
        if flat { "the whole" } else { "half" },
        if flat { "half round" } else { "once round" },
    );
    let (row, low) = if flat { (1.6, 0.62) } else { (1.62, 0.75) };
    let mut view = View::new(name, &alt)
        .camera(Camera::new(camera.0, camera.1))
        .around(up * -0.5 * row, 1.62)
        .size(340, if flat { 260 } else { 300 });
    for (k, letter) in ["a", "b", "c", "d", "e"].into_iter().enumerate() {
        let turned = part * k as f64;
        let first = |label| if k == 0 { label } else { "" };
        let place = [-1.35, 0.0, 1.35, -0.7, 0.7][k];
        let centre = right * place - up * if k < 3 { 0.0 } else { row };
        let t = turned * top.round();
        let attitude = top.attitude(t)?;
        let axis = attitude.axis();
        // OP points to the right at first.
        let start = BodyVector::new(cos(camera.0 + 0.5 * PI), sin(camera.0 + 0.5 * PI), 0.0);
        let face = centre + axis * (half + 0.004);
        let end = face + attitude.to_space(start) * radius;
        let turns = format!("({letter}) {turned}");
        view = view
            .solid(Solid::disc(centre, axis, radius, 2.0 * half), Ink::Body)
            .dashed([centre, centre + up * (half + 0.5)], Ink::Momentum)
            .text(centre + up * (half + 0.5), first("$L$"), Ink::Momentum, Side::Above)
            .arrow(face, face + axis * 0.34, Ink::Body, first("$z$"), Side::Left)
            .line([face, end], Ink::Ink)
            .dot(end, Ink::Ink, first("$P$"), Side::Right)
            .text(centre - up * low, &turns, Ink::Frame, Side::Centre);
    }
    view.figure()
}

/// Turns of OP against turns of the axis.
fn turns(bodies: [Top; 2]) -> Result<Figure> {
    let alt = "Turns of the line OP against turns of the axis about L: a steep straight line for \
               the cylinder, two for one, and a gentle one for the disc, one for two; dotted \
               between them one for one. Simulated dots lie on both lines.";
    let mut panel = Panel::new("turns", alt)
        .x(Axis::linear("turns of the axis about $L$").range(0.0, 2.0))
        .y(Axis::linear("turns of $OP$").range(0.0, 4.0))
        .curve(Curve::new([(0.0, 0.0), (2.0, 2.0)], Ink::Frame).dotted());
    for (top, name, side) in
        [(bodies[0], "cylinder", Side::AboveLeft), (bodies[1], "disc", Side::BelowRight)]
    {
        let slope = top.line_turns();
        let stepped = Stepped::new(top)?;
        let run = stepped.until(2.0 * top.round())?;
        let (mut counted, mut last, mut dots) = (0.0, 0.0, Vec::new());
        for (k, t) in times(0.0, 2.0 * top.round(), 160).enumerate() {
            let angles = stepped.at(&run, t)?.0.euler_angles();
            counted += wrapped(angles.phi + angles.zeta - last) / TAU;
            last = angles.phi + angles.zeta;
            if k % 16 == 0 {
                dots.push((t / top.round(), counted));
            }
        }
        panel = panel
            .curve(Curve::of(times(0.0, 2.0, 2), |x| slope * x, Ink::Ink).label_at(
                name,
                1.1,
                1.1 * slope,
                side,
            ))
            .curve(Curve::new(dots, Ink::Body).dots());
    }
    panel.figure()
}

/// Wobbles in one turn of OP for cylinders of all shapes, at the tilt of the notes' disc.
fn wobbles() -> Result<Figure> {
    let alt = "Wobbles in one turn of the line OP against height over radius: two for a thin disc, \
               one at the square root of three, a half at three, and ever fewer for rods. Simulated \
               dots lie on the curve.";
    let shape = |h: f64| {
        Top { i1: (3.0 + h * h) / 12.0, i3: 0.5, omega_y: 0.0, omega_z: 1.0 }.tilted(0.025)
    };
    let dots = [0.0, 0.5, 1.0, 1.4, 2.2, 3.0, 4.0, 5.0];
    let counted =
        Curve::sampled(dots, |h| Ok(1.0 / Stepped::new(shape(h))?.line_turns()?), Ink::Body)?;
    let balance = 3.0_f64.sqrt();
    Panel::new("wobbles", alt)
        .x(Axis::linear("height over radius, $H/R$").range(0.0, 5.0))
        .y(Axis::linear("wobbles in a turn of $OP$").range(0.0, 2.0))
        .curve(Curve::of(times(0.0, 5.0, 200), |h| 1.0 / shape(h).line_turns(), Ink::Ink))
        .curve(counted.dots())
        .upright(balance, Ink::Frame, r"$\sqrt{3}$")
        .note(0.25, 1.15, Ink::Frame, "flat", Side::Right)
        .note(3.4, 1.15, Ink::Frame, "thin", Side::Right)
        .figure()
}

/// The part of the angular velocity across the axis, as a passenger of the body sees it.
fn in_body(name: &str, top: Top) -> Result<Figure> {
    let (size, thin) = (top.omega_y, top.spin() > 0.0);
    let alt = format!(
        "On the body's axes the part of the angular velocity across the axis z goes round a circle \
         of radius {size}, {}; simulated dots lie on it.",
        if thin { "clockwise" } else { "counterclockwise" },
    );
    let circle = |turn: f64| (size * sin(turn), size * cos(turn));
    let whole = if thin { TAU } else { -TAU };
    let stepped = Stepped::new(top)?;
    let end = 0.75 * TAU / top.spin().abs();
    let run = stepped.until(end)?;
    let dots = kit::sampled(times(0.0, end, 9), |t| {
        let [x, y, _] = stepped.at(&run, t)?.1.to_array();
        Ok((x, y))
    })?;
    let axis = |label| Axis::linear(label).range(-1.25 * size, 1.25 * size);
    Panel::new(name, &alt)
        .x(axis(r"$\Omega_1$ / rad/s"))
        .y(axis(r"$\Omega_2$ / rad/s"))
        .equal_aspect()
        .curve(Curve::new(times(0.0, whole, 90).map(circle), Ink::Velocity).arrow(0.92))
        .curve(Curve::new(dots, Ink::Velocity).dots())
        .ring(0.0, size, Ink::Velocity, "start", Side::Above)
        .dot(0.0, 0.0, Ink::Body, "$z$", Side::Right)
        .figure()
}
