//! The drawings of the page, but for the cones.

use super::*;
use kit::draw::Camera;

/// The notes' cylinder and disc, whose moments are as 2 to 1 and as 1 to 2, tilted so far.
fn pair(tilt: f64) -> [Top; 2] {
    of_the_notes().map(|top| top.tilted(tilt))
}

/// z, Omega and L in their plane, with Omega as the sum of its two parts.
fn order(top: Top) -> Sketch {
    let (theta, alpha, o) = (top.tilt(), top.lean(), (0.0, 0.0));
    let at = |angle: f64, length: f64| (length * sin(angle), length * cos(angle));
    let thin = alpha < theta;
    let unit = if thin { 0.95 } else { 0.5 } / top.rate();
    let p = at(0.0, unit * top.precession());
    let s = at(theta, unit * top.spin());
    let omega = (p.0 + s.0, p.1 + s.1);
    let sides = if thin { (0.36, 1.08) } else { (1.16, 0.1) };
    // Angles of the drawing are counted from the right, counterclockwise.
    let turn = |angle: f64| 0.5 * PI - angle;
    let arc = |from: f64, to: f64| (turn(from.max(to)), turn(from.min(to)));
    let part = |to| Curve::new([omega, to], Ink::Velocity).thin().dashed();
    let (wide, radii) = (theta - alpha, if thin { (0.42, 0.3) } else { (0.34, 0.46) });
    let [of_p, of_s, of_omega] = match thin {
        true => [Side::Left, Side::Right, Side::Above],
        false => [Side::Right, Side::BelowLeft, Side::Left],
    };
    Sketch::within((-0.75, 1.05), (-0.62, 1.36))
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
        .text(p, r"$\Omega_P$", Ink::Velocity, of_p)
        .text(s, r"$\Omega_S$", Ink::Velocity, of_s)
        .text(omega, r"$\Omega$", Ink::Velocity, of_omega)
        .angle(o, radii.0, arc(0.0, theta), r"$\theta$")
        .angle(o, radii.1, arc(theta, wide), r"$\alpha$")
}

/// Five positions of a body and of its line OP, a part of a turn of the axis apart.
fn positions(top: Top, part: f64) -> Result<View> {
    let (flat, camera) = (top.i3 > top.i1, (0.6, 0.62));
    let (half, radius) = if flat { (0.05, 0.52) } else { (0.42, 0.28) };
    let right = SpaceVector::new(-sin(camera.0), cos(camera.0), 0.0);
    let up = SpaceVector::new(0.0, 0.0, 1.0);
    let (row, low) = if flat { (1.6, 0.62) } else { (1.62, 0.75) };
    let mut view = View::of(up * -0.5 * row, 1.62)
        .camera(Camera::new(camera.0, camera.1))
        .size(340, if flat { 260 } else { 300 });
    for (k, letter) in ["a", "b", "c", "d", "e"].into_iter().enumerate() {
        let turned = part * k as f64;
        let first = |label| if k == 0 { label } else { "" };
        let place = [-1.35, 0.0, 1.35, -0.7, 0.7][k];
        let centre = right * place - up * if k < 3 { 0.0 } else { row };
        let attitude = top.attitude(turned * top.round())?;
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
    Ok(view)
}

/// The part of the angular velocity across the axis, as a passenger of the body sees it.
fn in_body(top: Top) -> Result<Panel> {
    let (size, end) = (top.omega_y, 0.75 * TAU / top.spin().abs());
    let circle = |turn: f64| (size * sin(turn), size * cos(turn));
    let stepped = Stepped::until(&top, end)?;
    let dots = sampled(times(0.0, end, 9), |t| {
        let [x, y, _] = stepped.at(t)?.1.to_array();
        Ok((x, y))
    })?;
    let round = times(0.0, TAU.copysign(top.spin()), 90).map(circle);
    let axis = |label| Axis::linear(label).range(-1.25 * size, 1.25 * size);
    Ok(Panel::over_axes(axis(r"$\Omega_1$ / rad/s"), axis(r"$\Omega_2$ / rad/s"))
        .equal_aspect()
        .curve(Curve::new(round, Ink::Velocity).arrow(0.92))
        .curve(Curve::new(dots, Ink::Velocity).dots())
        .ring(0.0, size, Ink::Velocity, "start", Side::Above)
        .dot(0.0, 0.0, Ink::Body, "$z$", Side::Right))
}

figures! { p: &Parameters, [thin, flat] = pair(p.drawn_tilt), [cylinder, disc] = of_the_notes();
    /// The axis z, the angular velocity and L in one plane, the angular velocity between the other two.
    /// The angular velocity is the diagonal of a parallelogram on its part along L and its part along z.
    order_thin: order(thin);

    /// The axis z, the angular velocity and L in one plane, L between the other two.
    /// The angular velocity is the diagonal of a parallelogram on its part along L and its part against z.
    order_flat: order(flat);

    /// Two cones with a common tip stand side by side: the grey one about L, the green one about
    /// the axis z. They touch along a line, and the angular velocity lies on it.
    cones_thin: cones::view(thin, 0.15 * thin.round())?;

    /// A narrow grey cone about L stands inside a wide green funnel about the axis z, whose near
    /// half is cut away. It touches the funnel's wall along the angular velocity; L is between z and it.
    cones_flat: cones::view(flat, 0.15 * flat.round())?;

    /// Five pictures of a tilted cylinder while its axis makes half of a turn about the vertical L. The
    /// line OP on its end face turns once round in all.
    op_cylinder: positions(pair(0.25)[0], 0.125)?;

    /// Five pictures of a tilted disc while its axis makes the whole of a turn about the vertical L. The
    /// line OP on its end face turns half round in all.
    op_disc: positions(pair(0.25)[1], 0.25)?;

    /// Turns of the line OP against turns of the axis about L: a steep straight line for
    /// the cylinder, two for one, and a gentle one for the disc, one for two; dotted
    /// between them one for one. Simulated dots lie on both lines.
    turns: {
        let of_axis = Axis::linear("turns of the axis about $L$").range(0.0, 2.0);
        let mut panel = Panel::over_axes(of_axis, Axis::linear("turns of $OP$").range(0.0, 4.0))
            .curve(Curve::new([(0.0, 0.0), (2.0, 2.0)], Ink::Frame).dotted());
        for (top, name, side) in [(cylinder, "cylinder", Side::AboveLeft), (disc, "disc", Side::BelowRight)] {
            let slope = top.line_turns();
            let counted = top.line_turned(2.0 * top.round(), 160)?;
            let dots = times(0.0, 2.0, 10).zip(counted.into_iter().step_by(16));
            let line = Curve::of(times(0.0, 2.0, 2), |x| slope * x, Ink::Ink);
            panel = panel.curve(line.label_at(name, 1.1, 1.1 * slope, side))
                .curve(Curve::new(dots, Ink::Body).dots());
        }
        panel
    };

    /// Wobbles in one turn of the line OP against height over radius: two for a thin disc,
    /// one at the square root of three, a half at three, and ever fewer for rods. Simulated
    /// dots lie on the curve.
    wobbles: {
        // At the tilt of the notes' disc.
        let shape = |h: f64| Top { i1: (3.0 + h * h) / 12.0, i3: 0.5, omega_y: 0.0, omega_z: 1.0 }.tilted(0.025);
        let counted = |h| Ok(1.0 / shape(h).line_turns_stepped()?);
        let dots = Curve::sampled([0.0, 0.5, 1.0, 1.4, 2.2, 3.0, 4.0, 5.0], counted, Ink::Body)?.dots();
        let height = Axis::linear("height over radius, $H/R$").range(0.0, 5.0);
        Panel::over_axes(height, Axis::linear("wobbles in a turn of $OP$").range(0.0, 2.0))
            .curve(Curve::of(times(0.0, 5.0, 200), |h| 1.0 / shape(h).line_turns(), Ink::Ink))
            .curve(dots)
            .upright(3.0_f64.sqrt(), Ink::Frame, r"$\sqrt{3}$")
            .note(0.25, 1.15, Ink::Frame, "flat", Side::Right)
            .note(3.4, 1.15, Ink::Frame, "thin", Side::Right)
    };

    /// On the body's axes the part of the angular velocity across the axis z goes round a circle
    /// of radius 1, clockwise; simulated dots lie on it.
    in_body_cylinder: in_body(cylinder)?;

    /// On the body's axes the part of the angular velocity across the axis z goes round a circle
    /// of radius 0.5, counterclockwise; simulated dots lie on it.
    in_body_disc: in_body(disc)?;
}
