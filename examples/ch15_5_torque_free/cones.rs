//! The two cones that roll on each other: as stills, and as they move.

use super::*;

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
const ORIGIN: SpaceVector = SpaceVector::zero();

/// The cones at the time t: that of the body about its axis, that of space about L, and the
/// line on which they touch.
pub fn view(top: Top, t: f64) -> Result<View> {
    let reach = if top.tilt() > top.lean() { 0.86 } else { 0.94 };
    let view = View::of(UP * 0.72, reach);
    // The line OP lies on the face, a hair above it.
    let (attitude, alpha) = (top.attitude(t)?, top.lean());
    let centre = attitude.axis() * (cos(alpha) + 0.006);
    let at = centre + attitude.to_space(LINE) * sin(alpha);
    let view = rolling(view, top, t, 1.0)?;
    Ok(view.line([centre, at], Ink::Ink).dot(at, Ink::Ink, "$P$", Side::Below))
}

/// The cone of the body on that of space, their sides so long, with the axes and the path of the
/// body's. The cone of the body is whole if the other lies outside, else a funnel, of which the
/// near half is cut away.
fn rolling(view: View, top: Top, t: f64, long: f64) -> Result<View> {
    let (attitude, pole, alpha) = (top.attitude(t)?, top.pole(t), top.lean());
    let (axis, between) = (attitude.axis(), (top.tilt() - alpha).abs());
    let (base, radius) = (axis * (long * cos(alpha)), long * sin(alpha));
    let cone = if top.tilt() > alpha { Solid::cone } else { Solid::funnel };
    // Long enough to come out of the cones.
    let (out, up) = (1.3 * long, 1.5 * long);
    let path = sampled(times(0.0, top.round(), 90), |t| Ok(top.attitude(t)?.axis() * out))?;
    let beside = |v: SpaceVector| if v.y() < 0.0 { Side::Left } else { Side::Right };
    let space = Solid::cone(UP * (long * cos(between)), ORIGIN, long * sin(between));
    Ok(view
        .dashed(path, Ink::Body)
        .solid(space, Ink::Frame)
        .solid(cone(base, ORIGIN, radius), Ink::Body)
        .circle(base, axis, radius, Ink::Body)
        .arrow(ORIGIN, UP * up, Ink::Momentum, "$L$", Side::Above)
        .arrow(ORIGIN, axis * out, Ink::Body, "$z$", beside(axis))
        .arrow(ORIGIN, pole * out, Ink::Velocity, r"$\Omega$", beside(pole)))
}

/// Half the diagonal of the can in the picture, and the sides of the cones, which come out of it.
const CAN: f64 = 0.95;
const SIDE: f64 = 1.2;

/// The can itself, seen through, with the line OP on its end face and a stripe down its side.
fn can(view: View, p: &Parameters, attitude: &Attitude) -> View {
    let unit = CAN / hypot(p.radius, 0.5 * p.height);
    // A disc without thickness has no side to be lit.
    let (radius, half) = (p.radius * unit, (0.5 * p.height * unit).max(0.02));
    let at = |turn: f64, z: f64| {
        attitude.to_space(BodyVector::new(radius * cos(turn), radius * sin(turn), z))
    };
    let edges: Vec<_> =
        times(-0.2, 0.2, 4).map(|turn| [-half, half].map(|z| at(turn, z))).collect();
    let strips = edges.windows(2).map(|w| vec![w[0][0], w[1][0], w[1][1], w[0][1]]);
    let (axis, top) = (attitude.axis(), half + 0.006);
    let p = at(0.0, top);
    // P is a ring that is painted on the end face, so that a cone can hide it.
    view.glass(
        Solid::disc(ORIGIN, axis, radius, 2.0 * half),
        Ink::Body,
        [(Solid::new(strips), Ink::Body)],
    )
    .circle(axis * half, axis, radius, Ink::Body)
    .circle(axis * -half, axis, radius, Ink::Body)
    .line([axis * top, p], Ink::Ink)
    .circle(p, axis, 0.03, Ink::Ink)
    .text(p, "$P$", Ink::Ink, Side::Below)
}

/// Two turns of the axis of the body asked for, its tilt drawn larger.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (p, top) = (p.clone(), top(p)?.tilted(p.drawn_tilt));
    let (round, turns) = (top.round(), top.line_turns());
    let end = 2.0 * round;
    let line = |slope: f64, ink| Curve::of(times(0.0, end, 2), |t| slope * t / round, ink);
    // Whole turns, as long as there are few of them.
    let counted = Axis::linear("turns");
    let counted = if turns < 4.0 { counted.step(1.0) } else { counted };
    let graph = Panel::over_axes("$t$ / s", counted)
        .curve(line(1.0, Ink::Ink).dashed().label("axis"))
        .curve(line(turns, Ink::Body).label("line $OP$"));
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.18 * round, 0.6 * round], move |t| {
        let alt = format!(
            "A can seen through. A green cone about its axis z rolls on a grey cone about the upright L; \
             they touch along the angular velocity. After {t:.2} s the axis has gone round L {:.2} \
             times and the line OP on the can's end face has turned {:.2} times; below, both against time.",
            t / round,
            turns * t / round
        );
        let can = can(View::of(UP * 0.5, 1.36).size(340, 320), &p, &top.attitude(t)?);
        Ok((alt, rolling(can, top, t, SIDE)?))
    })
}
