//! The drawings of the page. The gyroscope is drawn with a tenth of its spin, so that all
//! three rates can be seen.

use super::*;
use kit::But;
use kit::draw::{Axis, Camera, Curve, Ink, Panel, Side, Sketch, Solid, Stack, View};
use kit::{Figure, MovingPicture, Trajectory, times};

const ORIGIN: SpaceVector = SpaceVector::new(0.0, 0.0, 0.0);

/// All figures of the page.
pub fn figures(p: &Parameters) -> Result<Vec<Figure>> {
    Ok(vec![
        line(p)?,
        field()?,
        disc()?,
        orders("order_xz", "about X, then about Z", [X, UP])?,
        orders("order_zx", "about Z, then about X", [UP, X])?,
        gaps()?,
        gyroscope(p)?,
        triad(p)?,
        pole(p)?,
    ])
}

const X: SpaceVector = SpaceVector::new(1.0, 0.0, 0.0);

/// The notes' unnumbered figure: a plate at two moments, with two lines on it.
fn line(p: &Parameters) -> Result<Figure> {
    let alt = "A plate on a pivot O. A line on it through O was at a small angle from the x axis and is at a larger one; \
               another line, away from O, has turned by the same angle.";
    let at = |r: f64, angle: f64| (r * cos(angle), r * sin(angle));
    let rim =
        |turn: f64| times(0.0, 2.0 * PI, 72).map(move |a| at(0.8 + 0.14 * sin(2.0 * a), a + turn));
    let [before, after] = [p.line_before, p.line_after];
    // Each line as it is and as it was: from its foot, towards this angle, so long.
    let foot = at(0.56, after + 2.1);
    let lines = [((0.0, 0.0), 0.0, 0.9), (foot, -0.55, 0.62)];
    let turned = format!("{:.2} rad", after - before);
    let sketch = Sketch::new("line", alt)
        .window((-1.05, 1.25), (-1.0, 1.0))
        .body(rim(after), Ink::Body, 0.1)
        .curve(Curve::new([(0.0, 0.0), (1.12, 0.0)], Ink::Frame).thin().dashed())
        .text((1.12, 0.0), "$x$", Ink::Frame, Side::Right);
    let draw = |sketch: Sketch, (foot, along, long): ((f64, f64), f64, f64)| {
        let end = |turn: f64, part: f64| {
            let (x, y) = at(long * part, along + turn);
            (foot.0 + x, foot.1 + y)
        };
        let middle = end(0.5 * (before + after), 0.78);
        sketch
            .curve(Curve::new([foot, end(before, 1.0)], Ink::Body).dashed())
            .curve(Curve::new([foot, end(after, 1.0)], Ink::Body))
            .turn(foot, 0.7 * long, (along + before, along + after), Ink::Velocity)
            .text(middle, &turned, Ink::Velocity, Side::Right)
            .dot(foot, Ink::Body, "", Side::Below)
    };
    lines.into_iter().fold(sketch, draw).dot((0.0, 0.0), Ink::Ink, "$O$", Side::BelowLeft).figure()
}

/// A box about a fixed point and three of its points.
fn field() -> Result<Figure> {
    let omega = SpaceVector::new(0.25, -0.15, 1.0);
    let alt = "A box turns about a fixed point; the angular velocity is an arrow through it. Thin arrows lead from \
               the fixed point through the box to two corners and to the middle of an edge; each of these three points \
               has a velocity at right angles to its thin arrow and to that of the angular velocity.";
    let edges = [SpaceVector::new(1.3, 0.0, 0.0), SpaceVector::new(0.0, 0.9, 0.0), UP * 0.3];
    let corner = |x: f64, y: f64| SpaceVector::new(0.65 * x, 0.45 * y, 0.15);
    let view = View::new("field", alt)
        .around(UP * 0.2, 0.95)
        .solid(Solid::cuboid(ORIGIN, edges), Ink::Body)
        .dashed([omega * -0.7, omega * 1.1], Ink::Frame)
        .arrow(ORIGIN, omega * 1.05, Ink::Velocity, "$\\Omega$", Side::Right);
    let points = [corner(1.0, -1.0), corner(1.0, 1.0), SpaceVector::new(0.0, 0.45, 0.15)];
    let labels = ["$v_1$", "$v_2$", "$v_3$"];
    points
        .into_iter()
        .zip(labels)
        .fold(view, |view, (r, label)| {
            let tip = r + velocity(omega, r) * 0.62;
            view.arrow(ORIGIN, r, Ink::Frame, "", Side::Below)
                .arrow(r, tip, Ink::Ink, label, Side::Above)
                .dot(r, Ink::Ink, "", Side::Below)
        })
        .dot(ORIGIN, Ink::Ink, "$O$", Side::BelowLeft)
        .figure()
}

/// The notes' figure 1: the disc, O, O' and A, with what adds up to the velocity of A.
fn disc() -> Result<Figure> {
    let flat = |v: SpaceVector| (v.x(), v.y());
    let omega = UP * 4.0;
    let alt = "A disc turns about its centre O. From O an arrow a leads to the point O', from there r' to the point A, \
               and r from O to A. The velocity of A is at right angles to r; it is the sum of the velocity of O' and \
               of a velocity at right angles to r'.";
    let (slow, o) = (0.2, (0.0, 0.0));
    let [of_a, of_o, about] = [A, O_PRIME, A - O_PRIME].map(|r| velocity(omega, r) * slow);
    Sketch::new("disc", alt)
        .window((-0.42, 0.5), (-0.42, 0.42))
        .disc(o, 0.38, Ink::Body, 0.08)
        .arrow(o, flat(O_PRIME), Ink::Frame, "$a$", Side::Below)
        .arrow(o, flat(A), Ink::Frame, "$r$", Side::Above)
        .arrow(flat(O_PRIME), flat(A), Ink::Frame, "$r'$", Side::BelowRight)
        .arrow_to(flat(O_PRIME), flat(O_PRIME + of_o), Ink::Ink, "$V_{O'}$", Side::Right)
        .arrow_to(flat(A), flat(A + of_a), Ink::Ink, "$V_A$", Side::AboveLeft)
        .curve(Curve::new([flat(A), flat(A + of_o)], Ink::Ink).thin().dashed())
        .curve(Curve::new([flat(A + of_o), flat(A + of_o + about)], Ink::Ink).thin().dashed())
        .text(flat(A + of_o + about * 0.4), "$\\Omega$ × $r'$", Ink::Ink, Side::Right)
        .turn(o, 0.3, (2.4, 3.4), Ink::Velocity)
        .text((-0.24, 0.0), "$\\Omega$", Ink::Velocity, Side::Right)
        .dot(o, Ink::Ink, "$O$", Side::Left)
        .dot(flat(O_PRIME), Ink::Ink, "$O'$", Side::Below)
        .dot(flat(A), Ink::Ink, "$A$", Side::Right)
        .figure()
}

/// A box after quarter turns about these axes.
fn orders(name: &str, how: &str, axes: [SpaceVector; 2]) -> Result<Figure> {
    let quarter = |axis: SpaceVector| axis * FRAC_PI_2;
    let turned =
        Attitude::from_rotation_vector(quarter(axes[0]))?.turned_in_space(quarter(axes[1]))?;
    let [long, wide, up] = [[1.1, 0.0, 0.0], [0.0, 0.7, 0.0], [0.0, 0.0, 0.26]];
    let put = |v: [f64; 3]| turned.to_space(v.into());
    let points = |v: SpaceVector| {
        let found = ["X", "Y", "Z"].into_iter().zip(v.to_array()).find(|(_, c)| c.abs() > 0.5);
        let (axis, along) = found.unwrap_or(("nothing", 0.0));
        format!("{}{axis}", if along < 0.0 { "-" } else { "" })
    };
    let (z, x) = (put([0.0, 0.0, 1.0]), put([1.0, 0.0, 0.0]));
    let alt = format!(
        "A flat box turned by a right angle {how}: its axis 3, which pointed along Z, points along {}, its long axis 1 along {}",
        points(z),
        points(x)
    );
    View::new(name, &alt)
        .around(ORIGIN, 1.15)
        .size(340, 280)
        .solid(Solid::cuboid(ORIGIN, [put(long), put(wide), put(up)]), Ink::Body)
        .arrow(ORIGIN, z, Ink::Body, "$3$", Side::Left)
        .arrow(ORIGIN, x, Ink::Body, "$1$", Side::Right)
        .triad()
        .figure()
}

fn gaps() -> Result<Figure> {
    let turns =
        |count| times(-2.0, 0.196_119_877, count).map(|x| rotation_dynamics::math::pow(10.0, x));
    let alt = "The angle between the two orders against the turn, on logarithmic axes: from a ten-thousandth of a \
               radian for turns of a hundredth to two thirds of pi for right angles, along a line of slope two.";
    let square = Curve::of(turns(40), |x| x * x, Ink::Frame).thin().dashed();
    Panel::new("gap", alt)
        .size(340, 280)
        .x(Axis::log("each turn $x$ / rad"))
        .y(Axis::log("angle between the orders / rad"))
        .curve(square.label_at("$x^2$", 0.1, 0.02, Side::AboveLeft))
        .curve(Curve::of(turns(120), gap, Ink::Ink))
        .curve(Curve::sampled(turns(8), measured_gap, Ink::Body)?.dots())
        .figure()
}

/// The rotor in its gimbals on a stand: the outer ring turns about Z, the inner one about x,
/// the rotor about z.
fn gimbals(name: &str, alt: &str, g: &Gyroscope) -> View {
    let [x, y, z] = g.triad();
    let (s, c) = sincos(g.angles.zeta);
    let mark = x * c + y * s;
    let face = z * 0.056;
    View::new(name, alt)
        .solid(Solid::stand(UP * -1.04, 0.32, 0.4), Ink::Frame)
        .solid(Solid::gimbal(ORIGIN, x.cross(&UP), 1.0, 0.04), Ink::Frame)
        .solid(Solid::gimbal(ORIGIN, y, 0.8, 0.04), Ink::Frame)
        .solid(Solid::rod(x * 0.84, x * 0.96, 0.03), Ink::Frame)
        .solid(Solid::rod(x * -0.96, x * -0.84, 0.03), Ink::Frame)
        // In two halves, so that the disc hides the one behind it.
        .solid(Solid::rod(z * -0.76, z * -0.055, 0.03), Ink::Frame)
        .solid(Solid::rod(z * 0.055, z * 0.76, 0.03), Ink::Frame)
        .solid(Solid::disc(ORIGIN, z, 0.52, 0.11), Ink::Body)
        .line([face + mark * 0.08, face + mark * 0.5], Ink::Paper)
        .line([face - mark * 0.08, face - mark * 0.5], Ink::Paper)
}

/// For the two stills of its own: seen from where x, y and z part best.
fn posed(p: &Parameters) -> Gyroscope {
    let g = Gyroscope::of(p, 0.1);
    let angles = g.angles.but(|angles| angles.phi = -0.2);
    Gyroscope { angles, ..g }
}

fn gyroscope(p: &Parameters) -> Result<Figure> {
    let g = posed(p);
    let [x, y, z] = g.triad();
    let alt = "A rotor in two rings on a stand. The outer ring turns about the vertical Z by phi, the inner ring in it \
               about the level line of nodes x by theta, and the rotor in the inner ring about its axis z by zeta; \
               y is at right angles to x and z.";
    let round = |axis: SpaceVector, from: SpaceVector, at: f64, radius: f64| {
        let other = axis.cross(&from);
        times(-0.6, 1.9, 20).map(move |a| {
            let (s, c) = sincos(a);
            axis * at + (from * c + other * s) * radius
        })
    };
    gimbals("gyroscope", alt, &g)
        .around(UP * -0.02, 1.55)
        .size(340, 320)
        .arrow(UP * 1.04, UP * 1.42, Ink::Frame, "$Z$", Side::Right)
        .arrow(x * 1.0, x * 1.45, Ink::Ink, "$x$", Side::Below)
        .arrow(ORIGIN, y * 1.3, Ink::Ink, "$y$", Side::Right)
        .arrow(ORIGIN, z * 1.4, Ink::Body, "$z$", Side::Right)
        .turn(round(UP, x, 1.22, 0.16), Ink::Velocity)
        .text(UP * 1.22 + x * 0.2, "$\\phi$", Ink::Velocity, Side::Left)
        .turn(round(x, y, 1.22, 0.16), Ink::Velocity)
        .text(x * 1.22 + UP * 0.22, "$\\theta$", Ink::Velocity, Side::Above)
        .turn(round(z, x, 1.1, 0.16), Ink::Velocity)
        .text(z * 1.1 + x * 0.2, "$\\zeta$", Ink::Velocity, Side::Left)
        .figure()
}

/// The notes' figure 3: the three rates on the triad, and what the precession has along y, z.
fn triad(p: &Parameters) -> Result<Figure> {
    let g = posed(p);
    let [x, y, z] = g.triad();
    // Together the three rates are so long.
    let scale = 2.2
        / [g.rates.phi, g.rates.theta, g.rates.zeta].map(f64::abs).iter().sum::<f64>().max(1e-9);
    let (turn, [_, along_y, _]) = (UP * (g.rates.phi * scale), g.nodal());
    let (on_y, on_z) = (y * (along_y * scale), z * (turn.dot(&z)));
    let alt = "The axes x, y and z, at right angles, and the vertical Z in the plane of y and z. Arrows show the rate of \
               phi along Z, that of theta along x and that of zeta along z; the first has a part along y and one along z.";
    let (hs, hc) = sincos(0.5 * p.theta);
    let half = (z * hc + y * hs) * 0.4;
    let tilt = times(p.theta, 0.0, 20).map(|a| {
        let (s, c) = sincos(a);
        (z * c + y * s) * 0.52
    });
    View::new("triad", alt)
        .around((UP + y + z) * 0.2, 1.05)
        .size(340, 320)
        .dashed([ORIGIN, UP * 1.25], Ink::Frame)
        .text(UP * 1.25, "$Z$", Ink::Frame, Side::Right)
        .dashed([ORIGIN, x * 0.9], Ink::Ink)
        .text(x * 0.9, "$x$", Ink::Ink, Side::Below)
        .dashed([ORIGIN, y * 1.1], Ink::Ink)
        .text(y * 1.1, "$y$", Ink::Ink, Side::Right)
        .dashed([ORIGIN, z * 1.45], Ink::Body)
        .text(z * 1.45, "$z$", Ink::Body, Side::Left)
        .dashed([on_y, turn], Ink::Velocity)
        .dashed([on_z, turn], Ink::Velocity)
        .turn(tilt, Ink::Ink)
        .text(half, "$\\theta$", Ink::Ink, Side::Centre)
        .arrow(ORIGIN, on_y, Ink::Velocity, "$\\dot\\phi\\sin\\theta$", Side::Below)
        .arrow(ORIGIN, x * (g.rates.theta * scale), Ink::Velocity, "$\\dot\\theta$", Side::Left)
        .arrow(ORIGIN, z * (g.rates.zeta * scale), Ink::Velocity, "$\\dot\\zeta$", Side::Left)
        .arrow(ORIGIN, on_z, Ink::Velocity, "$\\dot\\phi\\cos\\theta$", Side::Left)
        .arrow(ORIGIN, turn, Ink::Velocity, "$\\dot\\phi$", Side::Right)
        .figure()
}

/// The rates that the same components need at other tilts.
fn pole(p: &Parameters) -> Result<Figure> {
    let components = Gyroscope::of(p, 0.1).nodal();
    let rate = |i: usize| {
        Curve::of(
            times(0.06, PI - 0.06, 240),
            move |theta| rates(components, theta)[i],
            Ink::Velocity,
        )
    };
    let high = 5.0 * (components[1].abs() + components[2].abs()).max(0.1);
    let alt = "The rates of phi and of zeta that one angular velocity takes, against the tilt: moderate in the middle, \
               growing without limit towards a tilt of zero and towards pi, of opposite sign near zero.";
    Panel::new("pole", alt)
        .x(Axis::angle("tilt $\\theta$ / rad").range(0.0, PI))
        .y(Axis::linear("rate / (rad/s)").range(-high, high))
        .level(0.0, Ink::Frame, "")
        .curve(rate(0).label_at("$\\dot\\phi$", 0.3, rates(components, 0.3)[0], Side::Right))
        .curve(rate(2).dashed().label_at(
            "$\\dot\\zeta$",
            0.2,
            rates(components, 0.2)[2],
            Side::Right,
        ))
        .figure()
}

/// Azimuth of the eye: with the angles and rates of the page both rings are wide open in all three
/// stills.
const FACING: f64 = 1.13;

/// How long the gyroscope is watched, s.
const END: f64 = 6.0;

/// Its angles, its angular velocity on x, y, z and in space, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let g = Gyroscope::of(p, 1.0);
    let columns = [
        "t [s]",
        "phi [rad]",
        "theta [rad]",
        "zeta [rad]",
        "Omega_x [rad/s]",
        "Omega_y [rad/s]",
        "Omega_z [rad/s]",
        "Omega_X [rad/s]",
        "Omega_Y [rad/s]",
        "Omega_Z [rad/s]",
    ];
    Trajectory::sampled(columns, times(0.0, END, 300), |t| {
        let now = g.after(t);
        let EulerAngles { phi, theta, zeta } = now.angles;
        let ([x, y, z], space) = (now.nodal(), now.angular_velocity().to_array());
        Ok([&[t, phi, theta, zeta, x, y, z][..], &space[..]].concat())
    })
}

/// The three rates, one after the other, and their sum; below, the components on x, y, z.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let g = Gyroscope::of(p, 0.1);
    let path: Vec<[f64; 3]> = times(0.0, END, 200).map(|t| g.after(t).nodal()).collect();
    // The longest arrow, of the sum or of a part, reaches to the edge of the picture at most.
    let sums = times(0.0, END, 200).map(|t| g.after(t).angular_velocity().norm());
    let parts = [g.rates.phi.abs(), g.rates.zeta.abs(), 1e-9];
    let scale = 1.6 / sums.chain(parts).fold(0.0, f64::max);
    let axis = Axis::linear("rad/s").over(path.iter().flatten().copied().chain([-0.1, 0.1]));
    let component = |i: usize, name: &str| {
        let curve = times(0.0, END, 200).zip(path.iter().map(|omega| omega[i]));
        Curve::new(curve, Ink::Velocity).label_end(name)
    };
    let graph = Panel::over_axes("$t$ / s", axis)
        .curve(component(0, "$\\Omega_x$").dotted())
        .curve(component(1, "$\\Omega_y$").dashed())
        .curve(component(2, "$\\Omega_z$"));
    MovingPicture::new(0.0..=END, [0.0, 1.4, 4.28], move |t| {
        let now = g.after(t);
        let ([x, _, z], rates, omega) = (now.triad(), now.rates, now.angular_velocity());
        let [first, second, spin] =
            [UP * rates.phi, x * rates.theta, z * rates.zeta].map(|part| part * scale);
        let (corner, sum) = (first + second, omega * scale);
        let alt = format!(
            "The gyroscope at {t:.1} s, tilted by {:.2} rad: from its centre an arrow up the vertical for the rate of phi, \
             on its tip one parallel to the pivots of the inner ring for theta, and along the axle of the rotor one for zeta. \
             A dashed line carries the last to the tip of the others, where their sum ends, the angular velocity, {:.1} rad/s. \
             Below, its components on x, y and z against time.",
            now.angles.theta,
            omega.norm()
        );
        let scene = gimbals("scene", &alt, &now)
            .camera(Camera::new(FACING, 0.38))
            .around(UP * 0.06, 1.6)
            .size(340, 350)
            .ground(UP * -1.36, 1.0)
            .dashed([corner, sum], Ink::Velocity)
            .component(ORIGIN, first, Ink::Velocity, "", Side::Left)
            .text(first * 0.6, "$\\dot\\phi$", Ink::Velocity, Side::Left)
            .component(first, corner, Ink::Velocity, "$\\dot\\theta$", Side::Above)
            .component(ORIGIN, spin, Ink::Velocity, "$\\dot\\zeta$", Side::Left)
            .arrow(ORIGIN, sum, Ink::Velocity, "$\\Omega$", Side::Right);
        Stack::frame(&alt, scene, &graph, t)
    })
}
