//! The two cones that roll on each other: as stills, and as they move.

use super::{LINE, Parameters, Top, top};
use core::f64::consts::TAU;
use kit::draw::{Axis, Curve, Ink, Panel, Side, Solid, Stack, View};
use kit::{MovingPicture, Result, sampled, times};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::{cos, sin, sincos};

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
const ORIGIN: SpaceVector = SpaceVector::zero();

/// A funnel about `axis` with its tip at the origin: only its inner side, so that the near
/// half is cut away.
fn funnel(
    axis: SpaceVector,
    [u, v]: [SpaceVector; 2],
    half_angle: f64,
) -> (Solid, Vec<SpaceVector>) {
    let rim = |turn: f64| {
        let (s, c) = sincos(turn);
        axis * cos(half_angle) + (u * c + v * s) * sin(half_angle)
    };
    let rim: Vec<_> = times(0.0, TAU, 72).map(rim).collect();
    let faces = rim.windows(2).map(|pair| vec![ORIGIN, pair[0], pair[1]]);
    (Solid::new(faces), rim)
}

/// The cones at the time t: that of the body about its axis, that of space about L, and the
/// line on which they touch.
pub fn view(name: &str, alt: &str, top: Top, t: f64) -> Result<View> {
    let (attitude, axis, pole) = (top.attitude(t)?, top.axis(t)?, top.pole(t));
    let (lean, between) = (top.lean(), (top.tilt() - top.lean()).abs());
    let thin = top.tilt() > top.lean();
    let side = attitude.to_space(LINE);
    let (body, rim) = funnel(axis, [side, axis.cross(&side)], lean);
    let body = match thin {
        true => Solid::cone(axis * cos(lean), ORIGIN, sin(lean)),
        false => body,
    };
    let (centre, at) = (axis * cos(lean), rim[0]);
    // The line lies on the face, a hair above it.
    let lift = axis * 0.006;
    // Long enough to come out of the cones.
    let omega = pole * 1.3;
    let path = sampled(times(0.0, top.round(), 90), |t| Ok(top.axis(t)? * 1.3))?;
    let beside = |v: SpaceVector| if v.y() < 0.0 { Side::Left } else { Side::Right };
    Ok(View::new(name, alt)
        .around(UP * 0.66, if thin { 0.8 } else { 0.92 })
        .size(340, 300)
        .dashed(path, Ink::Body)
        .solid(Solid::cone(UP * cos(between), ORIGIN, sin(between)), Ink::Frame)
        .solid(body, Ink::Body)
        .line(rim, Ink::Body)
        .line([centre + lift, at + lift], Ink::Ink)
        .dot(at + lift, Ink::Ink, "$P$", Side::Below)
        .arrow(ORIGIN, UP * 1.45, Ink::Momentum, "$L$", Side::Above)
        .arrow(ORIGIN, axis * 1.3, Ink::Body, "$z$", beside(axis))
        .arrow(ORIGIN, omega, Ink::Velocity, r"$\Omega$", beside(pole)))
}

/// Two turns of the axis of the body asked for, its tilt drawn larger.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let top = top(p)?.tilted(p.drawn_tilt);
    let (round, turns) = (top.round(), top.line_turns());
    let end = 2.0 * round;
    let line = |slope: f64, ink| Curve::of(times(0.0, end, 2), |t| slope * t / round, ink);
    // Whole turns, as long as there are few of them.
    let counted = Axis::linear("turns");
    let counted = if turns < 4.0 { counted.step(1.0) } else { counted };
    let graph = Panel::new("graph", "")
        .x(Axis::linear("$t$ / s"))
        .y(counted)
        .curve(line(1.0, Ink::Ink).dashed().label("axis"))
        .curve(line(turns, Ink::Body).label("line $OP$"));
    let draw = move |t: f64| {
        let alt = format!(
            "A body cone about the axis z rolls on a space cone about L; they touch along the \
             angular velocity. After {t:.2} s the axis has gone round L {:.2} times and the \
             line OP has turned {:.2} times; below, both against time.",
            t / round,
            turns * t / round
        );
        Stack::frame(&alt, view("scene", &alt, top, t)?, &graph, t)
    };
    MovingPicture::new(0.0..=end, [0.0, 0.3 * round, 0.6 * round], draw)
}
