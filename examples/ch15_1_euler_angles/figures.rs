//! The drawings of Section 15.1.

use super::*;
use kit::draw::{Axis, Camera, Curve, Ink, Panel, Side, Solid, View};
use kit::{Figure, times};
use rotation_dynamics::math::pow;

/// All figures of the page.
pub fn figures(p: &Parameters) -> Result<Vec<Figure>> {
    let mut all = Vec::from(books(p)?);
    all.extend(picture::panels(p)?);
    all.extend([screw(p)?, arc_cosine()?, passage(p)?]);
    Ok(all)
}

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
const LEVEL: SpaceVector = SpaceVector::new(0.0, 1.0, 0.0);

/// A book that lay on the table with its top away from the reader, as it is now.
fn lying(name: &str, alt: &str, attitude: &Attitude) -> View {
    let at = |x, y, z| attitude.to_space(BodyVector::new(x, y, z));
    let edges = [at(1.1, 0.0, 0.0), at(0.0, 0.8, 0.0), at(0.0, 0.0, 0.22)];
    let title = [at(0.3, 0.0, 0.115), at(-0.42, 0.0, 0.115)];
    let head = [at(-0.2, -0.2, 0.115), at(-0.42, 0.0, 0.115), at(-0.2, 0.2, 0.115)];
    View::new(name, alt)
        .around(UP * 0.05, 1.05)
        .size(340, 260)
        .solid(Solid::cuboid(SpaceVector::zero(), edges), Ink::Body)
        .line(title, Ink::Paper)
        .line(head, Ink::Paper)
        .dashed([UP * -0.9, UP * 0.98], Ink::Frame)
        .text(UP * 0.98, "$Z$", Ink::Frame, Side::Right)
        .dashed([LEVEL * -1.0, LEVEL * 1.08], Ink::Frame)
        .text(LEVEL * 1.08, "$Y$", Ink::Frame, Side::Right)
}

/// The book at the start and after the two turns in either order.
fn books(p: &Parameters) -> Result<[Figure; 3]> {
    let start = lying(
        "book_start",
        "A book lies flat, its cover up; an arrow on the cover points to its top edge, away from the reader",
        &Attitude::IDENTITY,
    );
    let level_first = lying(
        "book_level_first",
        "The book turned about the level Y first, then about the vertical Z: by quarter turns, it stands upright and \
         its cover faces to the right",
        &book(p.book, true)?,
    );
    let upright_first = lying(
        "book_upright_first",
        "The book turned about the vertical Z first, then about the level Y: by quarter turns, its cover faces the reader \
         and the top edge lies to the left",
        &book(p.book, false)?,
    );
    Ok([start.figure()?, level_first.figure()?, upright_first.figure()?])
}

/// A triangle fixed in the body, on its way along the screw.
fn screw(p: &Parameters) -> Result<Figure> {
    let screw = Screw::of(p.angles(), p.shift())?;
    let origin = SpaceVector::zero();
    let corners = [[0.0; 3], [0.5, 0.7, 0.0], [0.0, 0.0, 1.0]].map(SpaceVector::from_array);
    // Where the axis passes closest to the reference point, before and after.
    let foot = screw.point - screw.axis * screw.axis.dot(&screw.point);
    let feet = [foot, foot + screw.axis * screw.advance];
    let ends = [screw.moved(origin, 0.0), screw.moved(origin, 1.0)];
    let centre = (ends[0] + ends[1] + feet[0] + feet[1]) * 0.25;
    let reach = ends.iter().chain(&feet).map(|v| (*v - centre).norm()).fold(0.5, f64::max);
    let alt = "A triangle fixed in a body before and after the displacement. Its corners have run along arcs about one \
               straight line, the screw axis, and have advanced along it by the same length; dashed lines join one corner \
               to that axis.";
    let view = View::new("screw", alt)
        .camera(Camera::new(-0.6, 0.35))
        .around(centre, 1.02 * reach)
        .size(340, 320)
        .line(
            [feet[0] - screw.axis * (0.4 * reach), feet[1] + screw.axis * (0.5 * reach)],
            Ink::Ink,
        )
        .dashed([feet[0], ends[0]], Ink::Ink)
        .dashed([feet[1], ends[1]], Ink::Ink)
        .arrow(feet[0], feet[1], Ink::Velocity, "", Side::Right)
        .text((feet[0] + feet[1]) * 0.5, "advance", Ink::Velocity, Side::Below)
        .text(feet[0] - screw.axis * (0.4 * reach), "screw axis", Ink::Ink, Side::Above);
    let view = corners.into_iter().fold(view, |view, corner| {
        view.turn(times(0.0, 1.0, 60).map(|part| screw.moved(corner, part)), Ink::Velocity)
    });
    let triangle = |view: View, part: f64, ink: Ink| {
        let [a, b, c] = corners.map(|corner| screw.moved(corner, part));
        let view = view.line([a, b, c, a], ink);
        [a, b, c].into_iter().fold(view, |view, corner| view.dot(corner, ink, "", Side::Above))
    };
    triangle(triangle(view, 0.0, Ink::Frame), 1.0, Ink::Body)
        .text(ends[0], "before", Ink::Frame, Side::Below)
        .text(screw.moved(corners[0], 1.0), "after", Ink::Body, Side::Above)
        .triad()
        .figure()
}

/// The relative error of theta from the matrix, by arc cosine and by arc tangent.
fn arc_cosine() -> Result<Figure> {
    let tilts = |count| times(-10.0, 0.0, count).map(|x| pow(10.0, x));
    let error = |theta: f64, found: f64| (found / theta - 1.0).abs().max(1e-16);
    let naive = |theta: f64| error(theta, acos(matrix([0.3, theta, -0.4])[2][2]));
    let sound = |theta: f64| error(theta, angles(&matrix([0.3, theta, -0.4]))[1]);
    let alt = "Relative error of the tilt against the tilt, both on logarithmic scales. By the arc cosine it grows as the \
               tilt falls, to one hundred per cent near 1e-8 rad; by the arc tangent it stays at the last digit.";
    Panel::new("arc_cosine", alt)
        .x(Axis::log("$\\theta$ / rad").range(1e-10, 1.0))
        .y(Axis::log("relative error").range(1e-17, 1.0))
        .curve(Curve::of(tilts(150), naive, Ink::Wrong).dashed().label_at(
            "wrong: acos",
            1e-4,
            1e-7,
            Side::Right,
        ))
        .curve(Curve::of(tilts(50), sound, Ink::Ink).dots().label_at(
            "atan2",
            1e-6,
            3e-15,
            Side::Above,
        ))
        .figure()
}

/// The three angles while a body is turned steadily past the vertical.
fn passage(_: &Parameters) -> Result<Figure> {
    let passage = Passage(0.05);
    let over = |pick: fn([f64; 3]) -> f64, ink| {
        Curve::of(times(-1.0, 1.0, 400), |t| pick(passage.angles(t)), ink)
    };
    let alt = "Angles against time while a body turns steadily. At the closest to the vertical phi falls from pi nearly to \
               zero at once and zeta rises by as much; their sum stays smooth, and theta comes down and goes up again.";
    Panel::new("passage", alt)
        .x(Axis::linear("$t$ / s").range(-1.0, 1.0))
        .y(Axis::angle("angle / rad").range(-PI, PI))
        .curve(over(|a| a[0], Ink::Velocity).label_at("$\\phi$", -0.4, 2.9, Side::Below))
        .curve(over(|a| a[2], Ink::Velocity).dashed().label_at("$\\zeta$", -0.4, -2.9, Side::Above))
        .curve(over(|a| a[0] + a[2], Ink::Ink).dotted().label_at(
            "$\\phi+\\zeta$",
            0.55,
            0.0,
            Side::Below,
        ))
        .curve(over(|a| a[1], Ink::Body).label_at("$\\theta$", 0.7, 0.7, Side::AboveLeft))
        .figure()
}
