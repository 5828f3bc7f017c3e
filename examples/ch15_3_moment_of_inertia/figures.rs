//! The drawings of section 15.3.

use super::*;
use core::f64::consts::{FRAC_PI_2, TAU};
use kit::draw::Camera;

/// The end of a line of this length at this angle.
fn polar(length: f64, angle: f64) -> (f64, f64) {
    let (s, c) = sincos(angle);
    (length * c, length * s)
}

fn sum(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    (a.0 + b.0, a.1 + b.1)
}

fn space(v: DesignVector) -> SpaceVector {
    v.to_array().into()
}

/// Where the four masses and their ellipsoid are seen from.
fn view() -> View {
    let view = View::of(SpaceVector::new(0.0, 0.05, 0.05), 0.95);
    view.camera(Camera::new(0.6, 0.38)).size(340, 320).triad()
}

/// The principal axes, so long to both sides, with a label at one end.
fn with_axes(view: View, axes: [SpaceVector; 3], lengths: [f64; 3]) -> View {
    let ends = axes.into_iter().zip(lengths).map(|(axis, length)| axis * length);
    ends.zip(["$x'$", "$y'$", "$z'$"]).fold(view, |view, (end, name)| {
        view.line([-end, end], Ink::Body).arrow(end * 0.9, end, Ink::Body, name, Side::Above)
    })
}

/// A ball stretched along the principal axes: its faces see outwards as the ball's do.
fn stretched(axes: [SpaceVector; 3], [a, b, c]: [f64; 3]) -> Solid {
    let (rings, sides) = (16, 32);
    let place = |i: usize, j: usize| {
        let (s, height) = sincos(PI * i as f64 / rings as f64);
        let (sp, cp) = sincos(TAU * j as f64 / sides as f64);
        axes[0] * (a * s * cp) + axes[1] * (b * s * sp) + axes[2] * (c * height)
    };
    let face = |(i, j): (usize, usize)| {
        let corners = [place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)];
        match i {
            0 => corners[..3].to_vec(),
            _ if i + 1 == rings => vec![corners[0], corners[1], corners[3]],
            _ => corners.to_vec(),
        }
    };
    Solid::new((0..rings).flat_map(|i| (0..sides).map(move |j| (i, j))).map(face))
}

/// The plate of these edges with its lower left corner at `at`.
fn with_plate(sketch: Sketch, at: (f64, f64), [a, b]: [f64; 2]) -> Sketch {
    let edge = [(0.0, 0.0), (a, 0.0), (a, b), (0.0, b)];
    sketch.body(edge.map(|corner| sum(at, corner)), Ink::Body, 0.15)
}

/// The square with its corner at the origin.
fn square() -> Sketch {
    let sketch = Sketch::within((-0.95, 1.75), (-0.4, 1.7)).width(300);
    with_plate(sketch, (0.0, 0.0), [1.0, 1.0])
}

/// Axes through `at` along the edges.
fn with_edges(sketch: Sketch, at: (f64, f64), length: f64) -> Sketch {
    let [x, y] = [(length, 0.0), (0.0, length)].map(|end| sum(at, end));
    let sketch = sketch.arrow_to(at, x, Ink::Ink, "$x$", Side::Right);
    sketch.arrow_to(at, y, Ink::Ink, "$y$", Side::Above)
}

/// Where (I_x'x', I_x'y') goes while the axes turn.
fn circle(plane: Plane, ink: Ink) -> Curve {
    let point = |angle| {
        let [xx, _, xy] = turned(plane, angle);
        (xx, xy)
    };
    Curve::new(times(0.0, PI, 120).map(point), ink)
}

figures! { p: &Parameters, found = InertiaTensor::new(tensor(&FOUR))?.principal_axes(), axes = found.axes().map(space);
    /// A flat body with the point P and a point a. From P an arrow V_P to the right; at a the same arrow, at
    /// its tip the arrow Omega x r', at right angles to the line from P to a, and the sum v_a from a.
    velocities: {
        let outline = times(0.0, TAU, 72).map(|t| {
            let bump = 1.0 + 0.1 * cos(2.0 * t + 0.5) + 0.06 * sin(3.0 * t);
            (0.62 + 0.82 * bump * cos(t), 0.52 + 0.62 * bump * sin(t))
        });
        let (p, a, carried) = ((0.25, 0.3), (1.05, 0.7), (0.42, 0.1));
        let around = (-0.65 * (a.1 - p.1), 0.65 * (a.0 - p.0));
        let (tip, end) = (sum(a, carried), sum(sum(a, carried), around));
        Sketch::within((-0.35, 1.95), (-0.25, 1.5))
            .body(outline, Ink::Body, 0.12)
            .curve(Curve::new([p, a], Ink::Frame))
            .text((0.66, 0.5), "$r'_a$", Ink::Frame, Side::Above)
            .arrow(p, sum(p, carried), Ink::Ink, "$V_P$", Side::Below)
            .arrow(a, tip, Ink::Ink, "$V_P$", Side::Below)
            .arrow(tip, end, Ink::Ink, r"$\Omega\times r'_a$", Side::Right)
            .arrow(a, end, Ink::Body, "$v_a$", Side::Left)
            .dot(p, Ink::Ink, "$P$", Side::Left)
            .dot(a, Ink::Ink, "$a$", Side::BelowRight)
            .turn(p, 0.22, (1.4, 3.3), Ink::Velocity)
            .text((0.08, 0.52), r"$\Omega$", Ink::Velocity, Side::AboveLeft)
    };

    /// A wheel rolls to the right on the ground. A dashed circle has the line from its centre to the contact
    /// point as diameter. Arrows show the velocities of the centre, of a point of the dashed circle and of the
    /// top; that of the point on the circle is at right angles to the velocity with which the centre turns
    /// around it.
    wheel: {
        let circle = times(0.0, TAU, 60).map(|t| sum((0.0, -0.5), polar(0.5, t)));
        let (centre, on) = ((0.0, 0.0), (0.5, -0.5));
        Sketch::within((-1.3, 1.75), (-1.2, 1.3))
            .wall((-1.25, -1.0), (1.7, -1.0))
            .disc(centre, 1.0, Ink::Body, 0.12)
            .curve(Curve::new(circle, Ink::Ink).dashed().width(1.2))
            .arrow(centre, (0.6, 0.0), Ink::Ink, "$V$", Side::Above)
            .arrow((0.0, 1.0), (1.2, 1.0), Ink::Ink, "$2V$", Side::Above)
            .arrow(on, (0.8, -0.8), Ink::Ink, "", Side::Right)
            .arrow(on, (0.8, -0.2), Ink::Frame, "", Side::Right)
            .text((0.8, -0.8), "$V_P$", Ink::Ink, Side::Right)
            .text((0.8, -0.2), r"$\Omega\times R_{CM}$", Ink::Frame, Side::Right)
            .curve(Curve::new([on, centre], Ink::Frame).thin())
            .dot(centre, Ink::Ink, "CM", Side::Left)
            .dot(on, Ink::Ink, "$P$", Side::Left)
            .dot((0.0, -1.0), Ink::Ink, "", Side::Below)
            .text((-0.04, -0.97), "$V_P=0$", Ink::Ink, Side::AboveLeft)
            .turn(centre, 0.8, (2.9, 1.9), Ink::Velocity)
            .text((-0.62, 0.62), r"$\Omega$", Ink::Velocity, Side::BelowRight)
    };

    /// Four balls of different size at the ends of rods that meet at the origin, and three green lines at right
    /// angles through the origin, x prime, y prime and z prime.
    body: {
        let scene = FOUR.iter().fold(view(), |scene, (m, r)| {
            let rod = Solid::rod(SpaceVector::zero(), space(*r), 0.012);
            scene.solid(rod, Ink::Frame).solid(Solid::ball(space(*r), 0.09 * cbrt(*m)), Ink::Body)
        });
        with_axes(scene, axes, [0.8; 3])
    };

    /// An ellipsoid about the origin, longest along x prime and shortest along z prime; the three axes pass
    /// through it and come out at right angles to its surface.
    ellipsoid: {
        let [a, b, c] = found.moments().map(|moment| 0.45 / moment.sqrt());
        let scene = view().solid(stretched(axes, [a, b, c]), Ink::Frame);
        with_axes(scene, axes, [a + 0.22, b + 0.22, c + 0.6])
    };

    /// A square plate of edge a with the axes x and y through its centre, along its edges; dashed, a pair of
    /// axes turned by an angle.
    square: {
        let (centre, up) = ((0.5, 0.5), 0.6 + FRAC_PI_2);
        let turned = |angle| Curve::new([centre, sum(centre, polar(0.95, angle))], Ink::Frame).dashed();
        with_edges(square().dimension((0.0, -0.12), (1.0, -0.12), "$a$", Side::Below), centre, 0.9)
            .curve(turned(0.6).label_end("$x'$"))
            .curve(turned(up))
            .text(sum(centre, polar(0.97, up)), "$y'$", Ink::Frame, Side::Left)
            .dot(centre, Ink::Ink, "CM", Side::BelowLeft)
    };

    /// The same plate with the axes x and y along two edges, from their common corner P.
    corner: with_edges(square(), (0.0, 0.0), 1.4)
        .dot((0.0, 0.0), Ink::Ink, "$P$", Side::BelowLeft)
        .dot((0.5, 0.5), Ink::Ink, "CM", Side::Right);

    /// The plate with axes through the corner P turned by 45 degrees: x prime along the diagonal through the
    /// centre of mass, y prime at right angles, outside the plate.
    principal: {
        let [.., angle] = corner_axes(1.0, 1.0, 1.0);
        let (o, x, y) = ((0.0, 0.0), polar(1.75, angle), polar(1.2, angle + FRAC_PI_2));
        square()
            .arrow_along([o, x], Ink::Ink)
            .arrow_along([o, y], Ink::Ink)
            .curve(Curve::new([o, (1.5, 0.0)], Ink::Frame).dashed())
            .angle(o, 0.34, (0.0, angle), "$45°$")
            .text(x, "$x'$", Ink::Ink, Side::Right)
            .text(sum((0.03, 0.0), y), "$y'$", Ink::Ink, Side::AboveRight)
            .dot(o, Ink::Ink, "$P$", Side::Below)
            .dot((0.5, 0.5), Ink::Ink, "CM", Side::BelowRight)
    };

    /// Product of inertia against moment of inertia of a plate on turned axes. About a corner of the square the
    /// point runs on a large circle, from angle 0 clockwise, twice as fast as the axes; about the centre of a
    /// rectangle on a small circle; about the centre of the square it stays in one place, where the moment is a
    /// twelfth and the product zero.
    mohr: {
        let (square, long) = (about_corner(1.0, 1.0, 1.0), about_centre(1.0, 1.0, 0.5));
        let ([xx, _, xy], [ax, _, ay]) = (square, turned(square, p.turn));
        let moment = Axis::linear("$I_{x'x'}/Ma^2$").range(0.0, 0.65);
        Panel::over_axes(moment, Axis::linear("$I_{x'y'}/Ma^2$").range(-0.28, 0.28))
            .equal_aspect()
            .level(0.0, Ink::Frame, "")
            .curve(circle(square, Ink::Ink).arrow(0.4))
            .note(0.5, 0.19, Ink::Ink, "square, corner", Side::AboveLeft)
            .curve(circle(long, Ink::Energy))
            .note(0.06, -0.032, Ink::Energy, "rectangle", Side::Below)
            .dot(1.0 / 12.0, 0.0, Ink::Body, "square, centre", Side::AboveRight)
            .curve(Curve::new([(xx, 0.0), (xx, xy)], Ink::Frame).thin())
            .curve(Curve::new([(xx, 0.0), (ax, ay)], Ink::Frame).thin())
            .dot(xx, xy, Ink::Ink, "$0$", Side::AboveRight)
            .dot(ax, ay, Ink::Ink, &format!("${:.2}$ rad", p.turn), Side::AboveRight)
    };

    /// Moment of inertia of a square plate about an axis at right angles to it, against the place of the axis
    /// along a diagonal: a parabola with its lowest point at the centre, a sixth, and two thirds at the corners.
    /// Dashed, what one gets by stepping from the left corner instead of the centre: right only at that corner.
    parallel: {
        let half = 0.5 * 2.0_f64.sqrt();
        let summed = |d: f64| tensor(&plate_points(1.0, [1.0, 1.0], [-d * half, -d * half]))[2][2];
        let wrong = |d: f64| 2.0 / 3.0 + (d + half) * (d + half);
        let exact = Curve::of(times(-half, half, 120), |d| 1.0 / 6.0 + d * d, Ink::Ink);
        let stepped = Curve::of(times(-half, 0.15, 60), wrong, Ink::Wrong).dashed();
        let place = Axis::linear("place of the axis / $a$").range(-half, half);
        Panel::over_axes(place, Axis::linear("$I_{zz}/Ma^2$").range(0.0, 1.4))
            .curve(exact.label_at("$I_{CM}+Md^2$", 0.25, 0.22, Side::BelowRight))
            .curve(Curve::of(times(-half, half, 9), summed, Ink::Body).dots())
            .curve(stepped.label_at("wrong: from the corner", -0.1, wrong(-0.1), Side::AboveLeft))
            .upright(0.0, Ink::Frame, "CM")
            .ring(-half, 2.0 / 3.0, Ink::Ink, "corner", Side::Right)
    };
}

/// Moments and product of the plate against the angle of its axes, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let planes = [about_centre, about_corner].map(|plane| plane(p.mass, p.width, p.height));
    let columns = "angle [rad], centre I_xx [kg m^2], centre I_xy [kg m^2], corner I_xx [kg m^2], \
                   corner I_xy [kg m^2]";
    Trajectory::sampled(columns.split(", "), times(0.0, PI, 180), |angle| {
        let [[a, _, b], [c, _, d]] = planes.map(|plane| turned(plane, angle));
        Ok([angle, a, b, c, d])
    })
}

/// Two plates of these edges, of which the longer is 1, with the axis at `angle` through the centre
/// and through a corner, and how far each piece is from it.
fn two_plates([a, b]: [f64; 2], angle: f64) -> Sketch {
    let (along, part) = (polar(1.0, angle), |i: u32| (f64::from(i) + 0.5) / 6.0);
    let mut drawn = Sketch::within((-0.62, 3.28), (-0.78, 1.5));
    for (left, axis) in [(0.0, (0.5 * a, 0.5 * b)), (1.85, (0.0, 0.0))] {
        // In the middle of where the square would be.
        let corner = (left + 0.5 * (1.0 - a), 0.5 * (1.0 - b));
        let through = sum(corner, axis);
        let at = |by: f64| sum(through, (by * along.0, by * along.1));
        let (mut start, mut end) = (0.0_f64, 0.0_f64);
        drawn = with_plate(drawn, corner, [a, b]);
        for k in 0..36 {
            let place = sum(corner, (a * part(k / 6), b * part(k % 6)));
            let by = (place.0 - through.0) * along.0 + (place.1 - through.1) * along.1;
            (start, end) = (start.min(by), end.max(by));
            let distance = Curve::new([at(by), place], Ink::Frame).width(0.9);
            drawn = drawn.curve(distance).curve(Curve::new([place], Ink::Body).dots());
        }
        drawn = drawn.arrow_along([at(start - 0.25), at(end + 0.25)], Ink::Velocity);
        drawn = drawn.dot(through, Ink::Ink, "", Side::Below);
    }
    drawn
}

/// The axis turns in the plane of the plate, through the centre and through a corner. Masses and
/// lengths over those of the plate and its longer edge.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let longer = p.width.max(p.height);
    let [a, b] = [p.width, p.height].map(|edge| edge / longer);
    let corner = move |angle| turned(about_corner(1.0, a, b), angle)[0];
    let centre = move |angle| turned(about_centre(1.0, a, b), angle)[0];
    let edges = format!("A plate of {} m by {} m", short(p.width, 3), short(p.height, 3));
    let (shape, unit) = match a == b {
        true => ("A square plate".into(), "M a^2"),
        false => (edges, "M a^2, a the longer edge,"),
    };
    let large = Curve::of(times(0.0, PI, 120), corner, Ink::Ink);
    let small = Curve::of(times(0.0, PI, 120), centre, Ink::Body);
    let turns = Axis::angle("angle of the axis / rad").range(0.0, PI);
    let graph = Panel::over_axes(turns, Axis::linear("$I/Ma^2$").range(0.0, 0.6))
        .curve(large.label_at("corner", 2.0, corner(2.0), Side::AboveLeft))
        .curve(small.label_at("centre", 2.4, centre(2.4), Side::Above));
    MovingPicture::above(graph, 0.0..=PI, [0.0, 0.25 * PI, 0.75 * PI], move |angle| {
        let alt = format!(
            "{shape} twice, with its pieces and their distances from an axis in the plane, \
             {:.0} degrees from an edge: on the left through the centre, on the right through a corner. Below, the two \
             moments over {unit} against the angle: {:.3} and {:.3} now.",
            angle.to_degrees(),
            centre(angle),
            corner(angle)
        );
        Ok((alt, two_plates([a, b], angle)))
    })
}
