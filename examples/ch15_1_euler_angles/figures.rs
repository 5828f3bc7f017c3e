//! The drawings of Section 15.1.

use super::*;
use kit::draw::Camera;

const ORIGIN: SpaceVector = SpaceVector::zero();
const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
/// Length of the arrows of the body's axes.
const BODY: f64 = 1.05;

/// A book that lay on the table with its top away from the reader, as it is now.
fn lying(attitude: &Attitude) -> View {
    let at = |x, y, z| attitude.to_space(BodyVector::new(x, y, z));
    let edges = [at(1.1, 0.0, 0.0), at(0.0, 0.8, 0.0), at(0.0, 0.0, 0.22)];
    let head = [at(-0.2, -0.2, 0.115), at(-0.42, 0.0, 0.115), at(-0.2, 0.2, 0.115)];
    let level = SpaceVector::new(0.0, 1.0, 0.0);
    View::of(UP * 0.05, 1.05)
        .size(340, 260)
        .solid(Solid::cuboid(ORIGIN, edges), Ink::Body)
        .line([at(0.3, 0.0, 0.115), at(-0.42, 0.0, 0.115)], Ink::Paper)
        .line(head, Ink::Paper)
        .dashed([UP * -0.9, UP * 0.98], Ink::Frame)
        .text(UP * 0.98, "$Z$", Ink::Frame, Side::Right)
        .dashed([level * -1.0, level * 1.08], Ink::Frame)
        .text(level * 1.08, "$Y$", Ink::Frame, Side::Right)
}

/// The angles when `t` of the three turns are made.
fn made(p: &Parameters, t: f64) -> [f64; 3] {
    let part = |k: f64| (t - k).clamp(0.0, 1.0);
    [part(0.0) * p.phi, part(1.0) * p.theta, part(2.0) * p.zeta]
}

/// What the pictures of all three turns show. Where an axis comes to point far down they show
/// more below.
fn shown(p: &Parameters) -> View {
    // From here the axes X, x and x' of the page fan out.
    let (azimuth, elevation) = (-0.5, 0.5);
    let ((sa, ca), (se, ce)) = (sincos(azimuth), sincos(elevation));
    let up = SpaceVector::new(-se * ca, -se * sa, ce);
    let tips = times(0.0, 3.0, 60).flat_map(|t| frames(made(p, t))[3]);
    let lowest = tips.map(|axis| BODY * axis.dot(&up)).fold(0.0, f64::min);
    // The height of the middle and the reach, and what is missing for a label below the lowest tip.
    let (middle, reach) = (0.35, 1.15);
    let missing = (middle * ce - reach - (lowest - 0.12)).max(0.0);
    View::of(UP * (middle - 0.5 * missing / ce), reach + 0.5 * missing)
        .camera(Camera::new(azimuth, elevation))
        .size(250, 230)
}

/// Those of three arrows of this length that have names.
fn triad(view: View, axes: [SpaceVector; 3], length: f64, names: [&str; 3], ink: Ink) -> View {
    let sides = [Side::Below, Side::Right, Side::Above];
    let each = axes.into_iter().zip(names).zip(sides).filter(|((_, name), _)| !name.is_empty());
    each.fold(view, |view, ((axis, name), side)| view.arrow(ORIGIN, axis * length, ink, name, side))
}

/// A disc in the plane of x and y, with a mark that points along x, in the triad that these angles
/// lead to, and the ways of the axes.
fn scene(view: View, angles: [f64; 3], names: [&str; 3]) -> View {
    let ([phi, theta, zeta], [fixed, first, second, last]) = (angles, frames(angles));
    let face = last[2] * 0.026;
    let view = view
        .solid(Solid::disc(ORIGIN, last[2], 0.42, 0.05), Ink::Body)
        .line([face, face + last[0] * 0.42], Ink::Paper);
    let view = triad(view, fixed, 1.2, ["$X$", "$Y$", "$Z$"], Ink::Frame);
    // Each axis that is turned, about which by how much, and how far out the name of the angle is.
    let ways = [
        (fixed[0], fixed[2], phi, r"$\phi$", 0.93),
        (first[2], first[0], theta, r"$\theta$", 0.94),
        (second[1], second[2], zeta, r"$\zeta$", 0.93),
    ];
    let view = ways.into_iter().fold(view, |view, (from, about, angle, name, out)| {
        let way = times(0.0, angle, 24).map(|a| turned(from, about, a) * 0.8);
        let middle = turned(from, about, 0.5 * angle) * out;
        let view = view.only_if(angle.abs() >= 0.02, |view| view.turn(way, Ink::Velocity));
        let name = if angle.abs() > 0.1 { name } else { "" };
        view.text(middle, name, Ink::Velocity, Side::Centre)
    });
    // Where x and y were, from which x' and y' are turned.
    let line = |view: View, axis| view.dashed([ORIGIN, axis * 0.95], Ink::Ink);
    let view = view.only_if(zeta.abs() > 0.1, |view| line(line(view, second[0]), second[1]));
    triad(view, last, BODY, names, Ink::Body)
}

figures! { p: &Parameters, [phi, theta, zeta] = p.angles();
    /// A book lies flat, its cover up; an arrow on the cover points to its top edge, away from the reader
    book_start: lying(&Attitude::IDENTITY);

    /// The book turned about the level Y first, then about the vertical Z: by quarter turns, it stands upright and its
    /// cover faces to the right
    book_level_first: lying(&book(p.book, true)?);

    /// The book turned about the vertical Z first, then about the level Y: by quarter turns, its cover faces the reader and
    /// the top edge lies to the left
    book_upright_first: lying(&book(p.book, false)?);

    /// A disc lies level in the fixed axes X, Y, Z; its mark points along X
    frames_a: scene(shown(p), [0.0; 3], [""; 3]);

    /// The disc has turned about Z by phi: its axis x is off X by that angle and Y' off Y; Z is where it was
    frames_b: scene(shown(p), [phi, 0.0, 0.0], ["$x$", "$Y'$", ""]);

    /// The disc has tilted about x by theta: z leans off Z by that angle, away from Y', and y has risen above Y'
    frames_c: scene(shown(p), [phi, theta, 0.0], ["$x$", "$y$", "$z$"]);

    /// The disc has turned about its own axis z by zeta: x' and y' are off x and y, which are dashed, by that angle
    frames_d: scene(shown(p), [phi, theta, zeta], ["$x'$", "$y'$", "$z$"]);

    /// A triangle fixed in a body before and after the displacement. Its corners have run along arcs about one straight
    /// line, the screw axis, and have advanced along it by the same length; dashed lines join one corner to that axis.
    screw: {
        let screw = Screw::of(p.angles(), p.shift())?;
        let corners = [[0.0; 3], [0.5, 0.7, 0.0], [0.0, 0.0, 1.0]].map(SpaceVector::from_array);
        // Where the axis passes closest to the reference point, before and after.
        let foot = screw.point - screw.axis * screw.axis.dot(&screw.point);
        let feet = [foot, foot + screw.axis * screw.advance];
        let ends = [0.0, 1.0].map(|part| screw.moved(ORIGIN, part));
        let centre = (ends[0] + ends[1] + feet[0] + feet[1]) * 0.25;
        let reach = ends.iter().chain(&feet).map(|v| (*v - centre).norm()).fold(0.5, f64::max);
        let below = feet[0] - screw.axis * (0.4 * reach);
        let view = View::of(centre, 1.02 * reach)
            .camera(Camera::new(-0.6, 0.35))
            .size(340, 320)
            .line([below, feet[1] + screw.axis * (0.5 * reach)], Ink::Ink)
            .dashed([feet[0], ends[0]], Ink::Ink)
            .dashed([feet[1], ends[1]], Ink::Ink)
            .arrow(feet[0], feet[1], Ink::Velocity, "", Side::Right)
            .text((feet[0] + feet[1]) * 0.5, "advance", Ink::Velocity, Side::Below)
            .text(below, "screw axis", Ink::Ink, Side::Above);
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
            .text(ends[1], "after", Ink::Body, Side::Above)
            .triad()
    };

    /// Relative error of the tilt against the tilt, both on logarithmic scales. By the arc cosine it grows as the tilt
    /// falls, to one hundred per cent near 1e-8 rad; by the arc tangent it stays at the last digit.
    arc_cosine: {
        let tilts = |count| times(-10.0, 0.0, count).map(|x| pow(10.0, x));
        let error = |theta: f64, found: f64| (found / theta - 1.0).abs().max(1e-16);
        let tilted = |theta| matrix([0.3, theta, -0.4]);
        let naive = Curve::of(tilts(150), |theta| error(theta, acos(tilted(theta)[2][2])), Ink::Wrong);
        let sound = Curve::of(tilts(50), |theta| error(theta, angles(&tilted(theta))[1]), Ink::Ink);
        let axis = Axis::log(r"$\theta$ / rad").range(1e-10, 1.0);
        Panel::over_axes(axis, Axis::log("relative error").range(1e-17, 1.0))
            .curve(naive.dashed().label_at("wrong: acos", 1e-4, 1e-7, Side::Right))
            .curve(sound.dots().label_at("atan2", 1e-6, 3e-15, Side::Above))
    };

    /// Angles against time while a body turns steadily. At the closest to the vertical phi falls from pi nearly to zero at
    /// once and zeta rises by as much; their sum stays smooth, and theta comes down and goes up again.
    passage: {
        let over = |pick: fn([f64; 3]) -> f64, ink| {
            Curve::of(times(-1.0, 1.0, 400), |t| pick(pole::passing_angles(0.05, t)), ink)
        };
        let axis = Axis::linear("$t$ / s").range(-1.0, 1.0);
        Panel::over_axes(axis, Axis::angle("angle / rad").range(-PI, PI))
            .curve(over(|a| a[0], Ink::Velocity).label_at(r"$\phi$", -0.4, 2.9, Side::Below))
            .curve(over(|a| a[2], Ink::Velocity).dashed().label_at(r"$\zeta$", -0.4, -2.9, Side::Above))
            .curve(over(|a| a[0] + a[2], Ink::Ink).dotted().label_at(r"$\phi+\zeta$", 0.55, 0.0, Side::Below))
            .curve(over(|a| a[1], Ink::Body).label_at(r"$\theta$", 0.7, 0.7, Side::AboveLeft))
    };
}

/// The three turns against the part that is made, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns =
        ["turns [-]", "phi [rad]", "theta [rad]", "zeta [rad]", "w [-]", "x [-]", "y [-]", "z [-]"];
    Trajectory::sampled(columns, times(0.0, 3.0, 300), |t| {
        let [a, b, c] = made(p, t);
        let [w, x, y, z] = attitude([a, b, c])?.quaternion();
        Ok([t, a, b, c, w, x, y, z])
    })
}

/// The turns as they are made, above the three angles.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (p, view) = (p.clone(), shown(p));
    let angle = |i: usize, name: &str| {
        Curve::of(times(0.0, 3.0, 60), |t| made(&p, t)[i], Ink::Velocity).label_end(name)
    };
    // At least as high as for the angles of the page, so that larger ones look larger.
    let angles = [p.angles(), Parameters::default().angles()].concat();
    let turns = Axis::linear("turns made").step(1.0);
    let graph = Panel::over_axes(turns, Axis::linear("angle / rad").over(angles))
        .curve(angle(0, r"$\phi$"))
        .curve(angle(1, r"$\theta$").dashed())
        .curve(angle(2, r"$\zeta$").dotted());
    MovingPicture::above(graph, 0.0..=3.0, [0.6, 1.6, 3.0], move |t| {
        let names = match t {
            t if t <= 1.0 => ["$x$", "$Y'$", ""],
            t if t <= 2.0 => ["$x$", "$y$", "$z$"],
            _ => ["$x'$", "$y'$", "$z$"],
        };
        let [phi, theta, zeta] = made(&p, t);
        let alt = format!(
            "A disc with its axes in the fixed axes X, Y, Z, turned so far by {phi:.2} rad about Z, {theta:.2} rad \
             about x and {zeta:.2} rad about z; below, the three angles, each growing while its turn is made."
        );
        Ok((alt, scene(view.clone(), [phi, theta, zeta], names)))
    })
}
