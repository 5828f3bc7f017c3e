//! The drawn set-ups of the worked examples.

use super::worked::Runner;
use core::f64::consts::PI;
use kit::draw::{Curve, Ink, Side, Sketch, Solid, View};
use kit::{Figure, Result, times};
use rotation_dynamics::frame::SpaceVector;
use rotation_dynamics::math::sincos;

/// A rolling wheel, with L about four points.
pub fn wheel() -> Result<Figure> {
    let alt = "A wheel rolls to the right on a floor, turning clockwise. Its centre has the \
               velocity V, the top of its rim twice that. In units of M R squared Omega the \
               angular momentum is one half about the centre, three halves about the point of \
               contact and about a point A of the floor, minus one half about the top.";
    let (top, centre, contact, floor) = ((0.0, 2.0), (0.0, 1.0), (0.0, 0.0), (-1.75, 0.0));
    Sketch::new("wheel", alt)
        .window((-2.5, 2.2), (-0.5, 2.55))
        .wall((-2.4, 0.0), (2.1, 0.0))
        .roller(centre, 1.0, -2.2, Ink::Body)
        .turn(centre, 0.62, (0.9, -0.5), Ink::Velocity)
        .text((0.62, 0.55), r"$\Omega$", Ink::Velocity, Side::Left)
        .arrow_to(top, (1.5, 2.0), Ink::Ink, "$2V$", Side::Right)
        .arrow_to(centre, (0.75, 1.0), Ink::Ink, "$V$", Side::Above)
        .dot(top, Ink::Momentum, "$-1/2$", Side::Above)
        .dot(centre, Ink::Momentum, "$1/2$", Side::Left)
        .dot(contact, Ink::Momentum, "$B$: $3/2$", Side::BelowRight)
        .dot(floor, Ink::Momentum, "$A$: $3/2$", Side::Below)
        .figure()
}

/// A coin that rolls round another.
pub fn coin() -> Result<Figure> {
    let alt = "A coin rolls round a fixed one of the same size. While the line of the centres \
               turns by 60 degrees, a mark on the rolling coin turns by 120.";
    let (s, c) = sincos(PI / 3.0);
    let (o, before, after) = ((0.0, 0.0), (2.0, 0.0), (2.0 * c, 2.0 * s));
    Sketch::new("coin", alt)
        .window((-1.3, 3.4), (-1.25, 3.0))
        .disc(o, 1.0, Ink::Frame, 0.25)
        .ghost(|sketch| sketch.roller(before, 1.0, PI, Ink::Body))
        .roller(after, 1.0, PI + 2.0 * PI / 3.0, Ink::Body)
        .curve(Curve::new([o, before], Ink::Frame).thin().dashed())
        .curve(Curve::new([o, after], Ink::Frame).thin().dashed())
        .turn(o, 2.0, (0.25, 0.75), Ink::Velocity)
        .text((1.85, 1.0), r"orbit $\Omega$", Ink::Velocity, Side::Right)
        .turn(after, 0.55, (-0.5, 1.0), Ink::Velocity)
        .text((1.6, 2.0), r"$2\Omega$", Ink::Velocity, Side::Right)
        .dot(o, Ink::Ink, "", Side::Below)
        .text((0.0, -1.0), "fixed", Ink::Frame, Side::Above)
        .figure()
}

/// The Earth beside the Sun, the orbit seen edge-on; not to scale.
pub fn earth() -> Result<Figure> {
    let alt = "The orbit of the Earth seen edge-on. At the Sun the orbital angular momentum points \
               along the normal z. The Earth's own points along its axis s, 23 degrees from z. A \
               dashed arrow along z on the Earth is marked as wrong.";
    let (sun, earth, (s, c)) = ((0.0, 0.0), (2.6, 0.0), sincos(0.409));
    let wrong = Curve::new([earth, (2.6, 1.25)], Ink::Wrong).dashed().arrow(1.0);
    Sketch::new("earth", alt)
        .window((-0.55, 4.1), (-1.05, 1.9))
        .curve(Curve::new([sun, earth], Ink::Frame).thin().dashed())
        .text((1.3, 0.0), "$R_{ES}$", Ink::Frame, Side::Below)
        .disc(sun, 0.24, Ink::Energy, 0.8)
        .disc(earth, 0.5, Ink::Body, 0.35)
        .arrow_along([sun, (0.0, 1.6)], Ink::Momentum)
        .text((0.0, 1.6), "orbital $L$, along $z$", Ink::Momentum, Side::Right)
        .curve(Curve::new([(2.6 - 0.85 * s, -0.85 * c), earth], Ink::Frame).thin().dashed())
        .arrow_along([earth, (2.6 + 1.3 * s, 1.3 * c)], Ink::Momentum)
        .text((2.6 + 1.3 * s, 1.3 * c), "own $L$, along $s$", Ink::Momentum, Side::Above)
        .curve(wrong)
        .text((2.6, 1.0), "wrong: third term", Ink::Wrong, Side::Left)
        .text((0.0, -0.3), "Sun", Ink::Ink, Side::Below)
        .text((2.6, -0.55), "Earth", Ink::Ink, Side::BelowRight)
        .figure()
}

/// A wheel that rolls at the end of a shaft, hinged on an upright rod.
pub fn runner() -> Result<Figure> {
    let at = |out: f64, up: f64| SpaceVector::new(0.0, out, up);
    let (hinge, hub, contact) = (at(0.0, 0.0), at(1.05, 0.0), at(1.05, -0.6));
    let scale = Runner { mass: 1.0, radius: 0.6, shaft: 1.05, rate: 1.0 };
    let [along, up] = scale.momentum().map(|l| 0.75 * l);
    // Where the wheel has come from and where it goes.
    let track = times(0.6, 2.5, 30).map(|turn| {
        let (s, c) = sincos(turn);
        SpaceVector::new(1.05 * c, 1.05 * s, -0.6)
    });
    let alt = "A wheel rolls on the floor at the end of a level shaft that is hinged on an upright \
               rod. Omega points up along the rod. L starts at the hinge, points up and leans \
               away from the wheel. From the hub the weight pulls down; from below the floor \
               pushes up at the wheel, with a little more.";
    View::new("runner", alt)
        .size(340, 320)
        .around(at(0.45, -0.03), 1.12)
        .ground(at(0.45, -0.6), 0.9)
        .solid(Solid::rod(at(0.0, -0.6), at(0.0, 0.45), 0.035), Ink::Frame)
        .solid(Solid::rod(hinge, hub, 0.022), Ink::Frame)
        .solid(Solid::disc(hub, at(1.0, 0.0), 0.6, 0.07), Ink::Body)
        .line(track, Ink::Frame)
        .arrow(hinge, at(along, up), Ink::Momentum, "$L$", Side::Left)
        .arrow(at(0.0, 0.45), at(0.0, 1.0), Ink::Velocity, r"$\Omega$", Side::Right)
        .arrow(at(1.09, 0.0), at(1.09, -0.4), Ink::Force, "", Side::Left)
        .text(at(1.09, -0.2), "$Mg$", Ink::Ink, Side::Right)
        .arrow(at(1.05, -1.03), contact, Ink::Force, "", Side::Right)
        .text(at(1.05, -0.85), "$N$", Ink::Force, Side::Right)
        .figure()
}

/// A square plate that turns about an edge.
pub fn plate() -> Result<Figure> {
    let alt = "A square plate with a corner at the origin turns about its left edge, the y axis. \
               Omega points up along that edge; L points up and to the left, close to the second \
               diagonal y'. The first diagonal x' runs through the plate.";
    let o = (0.0, 0.0);
    let axis = |to| Curve::new([o, to], Ink::Body).thin().dashed();
    Sketch::new("plate", alt)
        .window((-1.25, 1.6), (-0.5, 1.75))
        .block((0.5, 0.5), (1.0, 1.0), 0.0, Ink::Body)
        .curve(Curve::new([(0.0, -0.1), (0.0, 1.7)], Ink::Frame).thin().dashed())
        .curve(Curve::new([o, (1.5, 0.0)], Ink::Frame).thin().dashed())
        .text((1.5, 0.0), "$x$", Ink::Frame, Side::Below)
        .text((0.0, 1.7), "$y$", Ink::Frame, Side::Left)
        .curve(axis((1.2, 1.2)))
        .text((1.2, 1.2), "$x'$", Ink::Body, Side::Right)
        .curve(axis((-1.1, 1.1)))
        .text((-1.1, 1.1), "$y'$", Ink::Body, Side::Left)
        .arrow_along([o, (0.0, 1.4)], Ink::Velocity)
        .text((0.0, 1.3), r"$\Omega$", Ink::Velocity, Side::Right)
        .arrow_to(o, (-0.84, 1.12), Ink::Momentum, "$L$", Side::Above)
        .dimension((0.0, -0.15), (1.0, -0.15), "$a$", Side::Below)
        .figure()
}
