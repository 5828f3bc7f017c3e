//! The drawings of the page. The gyroscope is drawn with a tenth of its spin, so that all
//! three rates can be seen.

use super::*;
use kit::draw::Camera;

const ORIGIN: SpaceVector = SpaceVector::zero();

/// A box after quarter turns about these axes.
fn ordered(axes: [SpaceVector; 2]) -> Result<View> {
    let turned = twice(FRAC_PI_2, axes)?;
    let put = |x, y, z| turned.to_space(BodyVector::new(x, y, z));
    let edges = [put(1.1, 0.0, 0.0), put(0.0, 0.7, 0.0), put(0.0, 0.0, 0.26)];
    Ok(View::of(ORIGIN, 1.15)
        .size(340, 280)
        .solid(Solid::cuboid(ORIGIN, edges), Ink::Body)
        .arrow(ORIGIN, put(0.0, 0.0, 1.0), Ink::Body, "$3$", Side::Left)
        .arrow(ORIGIN, put(1.0, 0.0, 0.0), Ink::Body, "$1$", Side::Right)
        .triad())
}

/// The rotor in its gimbals on a stand: the outer ring turns about Z, the inner one about x,
/// the rotor about z.
fn gimbals(view: View, g: &Gyroscope) -> View {
    let ([x, y, z], (s, c)) = (g.triad(), sincos(g.angles[2]));
    let (mark, face) = (x * c + y * s, z * 0.056);
    view.solid(Solid::stand(UP * -1.04, 0.32, 0.4), Ink::Frame)
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

figures! { p: &Parameters,
    // The gyroscope of the stills: seen from where x, y and z part best.
    g = Gyroscope::of(p, 0.1).but(|g| g.angles[0] = -0.2), [x, y, z] = g.triad();

    /// A plate on a pivot O. A line on it through O was at a small angle from the x axis and is at a larger one; another
    /// line, away from O, has turned by the same angle.
    line: {
        let (o, [before, after]) = ((0.0, 0.0), [p.line_before, p.line_after]);
        let at = |r: f64, angle: f64| (r * cos(angle), r * sin(angle));
        let rim = times(0.0, 2.0 * PI, 72).map(|a| at(0.8 + 0.14 * sin(2.0 * a), a + after));
        let turned = format!("{:.2} rad", after - before);
        let sketch = Sketch::within((-1.05, 1.25), (-1.0, 1.0))
            .body(rim, Ink::Body, 0.1)
            .guide([o, (1.12, 0.0)])
            .text((1.12, 0.0), "$x$", Ink::Frame, Side::Right);
        // Each line as it was and as it is: from its foot, towards this angle from the other line, so long.
        let lines = [(o, 0.0, 0.9), (at(0.56, after + 2.1), -0.55, 0.62)];
        let draw = |sketch: Sketch, (foot, along, long): ((f64, f64), f64, f64)| {
            let end = |turn: f64, part: f64| {
                let (x, y) = at(long * part, along + turn);
                (foot.0 + x, foot.1 + y)
            };
            sketch
                .curve(Curve::new([foot, end(before, 1.0)], Ink::Body).dashed())
                .curve(Curve::new([foot, end(after, 1.0)], Ink::Body))
                .turn(foot, 0.7 * long, (along + before, along + after), Ink::Velocity)
                .text(end(0.5 * (before + after), 0.78), &turned, Ink::Velocity, Side::Right)
                .dot(foot, Ink::Body, "", Side::Below)
        };
        lines.into_iter().fold(sketch, draw).dot(o, Ink::Ink, "$O$", Side::BelowLeft)
    };

    /// A box turns about a fixed point; the angular velocity is an arrow through it. Thin arrows lead from the fixed point
    /// through the box to two corners and to the middle of an edge; each of these three points has a velocity at right
    /// angles to its thin arrow and to that of the angular velocity.
    field: {
        let omega = SpaceVector::new(0.25, -0.15, 1.0);
        let [front, left] = [SpaceVector::new(0.65, 0.0, 0.0), SpaceVector::new(0.0, 0.45, 0.0)];
        let view = View::of(UP * 0.2, 0.95)
            .solid(Solid::cuboid(ORIGIN, [front * 2.0, left * 2.0, UP * 0.3]), Ink::Body)
            .dashed([omega * -0.7, omega * 1.1], Ink::Frame)
            .arrow(ORIGIN, omega * 1.05, Ink::Velocity, r"$\Omega$", Side::Right);
        let points = [(front - left, "$v_1$"), (front + left, "$v_2$"), (left, "$v_3$")];
        let draw = |view: View, (level, label): (SpaceVector, &str)| {
            let r = level + UP * 0.15;
            view.arrow(ORIGIN, r, Ink::Frame, "", Side::Below)
                .arrow(r, r + velocity(omega, r) * 0.62, Ink::Ink, label, Side::Above)
                .dot(r, Ink::Ink, "", Side::Below)
        };
        points.into_iter().fold(view, draw).dot(ORIGIN, Ink::Ink, "$O$", Side::BelowLeft)
    };

    /// A disc turns about its centre O. From O an arrow a leads to the point O', from there r' to the point A, and r from O
    /// to A. The velocity of A is at right angles to r; it is the sum of the velocity of O' and of a velocity at right
    /// angles to r'.
    disc: {
        let flat = |v: SpaceVector| (v.x(), v.y());
        let (o, a, other) = ((0.0, 0.0), flat(A), flat(O_PRIME));
        let [of_a, of_o, about] = [A, O_PRIME, A - O_PRIME].map(|r| velocity(UP * 4.0, r) * 0.2);
        let carried = flat(A + of_o);
        Sketch::within((-0.42, 0.5), (-0.42, 0.42))
            .disc(o, 0.38, Ink::Body, 0.08)
            .arrow(o, other, Ink::Frame, "$a$", Side::Below)
            .arrow(o, a, Ink::Frame, "$r$", Side::Above)
            .arrow(other, a, Ink::Frame, "$r'$", Side::BelowRight)
            .arrow_to(other, flat(O_PRIME + of_o), Ink::Ink, "$V_{O'}$", Side::Right)
            .arrow_to(a, flat(A + of_a), Ink::Ink, "$V_A$", Side::AboveLeft)
            .curve(Curve::new([a, carried], Ink::Ink).thin().dashed())
            .curve(Curve::new([carried, flat(A + of_o + about)], Ink::Ink).thin().dashed())
            .text(flat(A + of_o + about * 0.4), r"$\Omega$ × $r'$", Ink::Ink, Side::Right)
            .turn(o, 0.3, (2.4, 3.4), Ink::Velocity)
            .text((-0.24, 0.0), r"$\Omega$", Ink::Velocity, Side::Right)
            .dot(o, Ink::Ink, "$O$", Side::Left)
            .dot(other, Ink::Ink, "$O'$", Side::Below)
            .dot(a, Ink::Ink, "$A$", Side::Right)
    };

    /// A flat box turned by a right angle about X, then about Z: its axis 3, which pointed along Z, points along X, its
    /// long axis 1 along Y
    order_xz: ordered([X, UP])?;

    /// A flat box turned by a right angle about Z, then about X: its axis 3, which pointed along Z, points along -Y, its
    /// long axis 1 along Z
    order_zx: ordered([UP, X])?;

    /// The angle between the two orders against the turn, on logarithmic axes: from a ten-thousandth of a radian for turns
    /// of a hundredth to two thirds of pi for right angles, along a line of slope two.
    gap: {
        let turns = |count| times(-2.0, 0.196_119_877, count).map(|x| pow(10.0, x));
        let square = Curve::of(turns(40), |x| x * x, Ink::Frame).thin().dashed();
        Panel::over_axes(Axis::log("each turn $x$ / rad"), Axis::log("angle between the orders / rad"))
            .size(340, 280)
            .curve(square.label_at("$x^2$", 0.1, 0.02, Side::AboveLeft))
            .curve(Curve::of(turns(120), gap, Ink::Ink))
            .curve(Curve::sampled(turns(8), measured_gap, Ink::Body)?.dots())
    };

    /// A rotor in two rings on a stand. The outer ring turns about the vertical Z by phi, the inner ring in it about the
    /// level line of nodes x by theta, and the rotor in the inner ring about its axis z by zeta; y is at right angles to x
    /// and z.
    gyroscope: {
        let round = |axis: SpaceVector, from: SpaceVector, at: f64| {
            let other = axis.cross(&from);
            times(-0.6, 1.9, 20).map(move |a| axis * at + (from * cos(a) + other * sin(a)) * 0.16)
        };
        gimbals(View::of(UP * -0.02, 1.55).size(340, 320), &g)
            .arrow(UP * 1.04, UP * 1.42, Ink::Frame, "$Z$", Side::Right)
            .arrow(x * 1.0, x * 1.45, Ink::Ink, "$x$", Side::Below)
            .arrow(ORIGIN, y * 1.3, Ink::Ink, "$y$", Side::Right)
            .arrow(ORIGIN, z * 1.4, Ink::Body, "$z$", Side::Right)
            .turn(round(UP, x, 1.22), Ink::Velocity)
            .text(UP * 1.22 + x * 0.2, r"$\phi$", Ink::Velocity, Side::Left)
            .turn(round(x, y, 1.22), Ink::Velocity)
            .text(x * 1.22 + UP * 0.22, r"$\theta$", Ink::Velocity, Side::Above)
            .turn(round(z, x, 1.1), Ink::Velocity)
            .text(z * 1.1 + x * 0.2, r"$\zeta$", Ink::Velocity, Side::Left)
    };

    /// The axes x, y and z, at right angles, and the vertical Z in the plane of y and z. Arrows show the rate of phi along
    /// Z, that of theta along x and that of zeta along z; the first has a part along y and one along z.
    triad: {
        // Together the three rates are so long.
        let scale = 2.2 / g.fastest().max(1e-9);
        let [turn, nod, spin] = [UP * (g.rates[0] * scale), x * (g.rates[1] * scale), z * (g.rates[2] * scale)];
        let (on_y, on_z) = (y * (g.nodal()[1] * scale), z * (turn.dot(&z)));
        let tilted = |a: f64| z * cos(a) + y * sin(a);
        View::of((UP + y + z) * 0.2, 1.05)
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
            .turn(times(p.theta, 0.0, 20).map(|a| tilted(a) * 0.52), Ink::Ink)
            .text(tilted(0.5 * p.theta) * 0.4, r"$\theta$", Ink::Ink, Side::Centre)
            .arrow(ORIGIN, on_y, Ink::Velocity, r"$\dot\phi\sin\theta$", Side::Below)
            .arrow(ORIGIN, nod, Ink::Velocity, r"$\dot\theta$", Side::Left)
            .arrow(ORIGIN, spin, Ink::Velocity, r"$\dot\zeta$", Side::Left)
            .arrow(ORIGIN, on_z, Ink::Velocity, r"$\dot\phi\cos\theta$", Side::Left)
            .arrow(ORIGIN, turn, Ink::Velocity, r"$\dot\phi$", Side::Right)
    };

    /// The rates of phi and of zeta that one angular velocity takes, against the tilt: moderate in the middle, growing
    /// without limit towards a tilt of zero and towards pi, of opposite sign near zero.
    pole: {
        let components = g.nodal();
        let rate = |i: usize| move |theta| rates(components, theta)[i];
        let curve = |i| Curve::of(times(0.06, PI - 0.06, 240), rate(i), Ink::Velocity);
        let high = 5.0 * (components[1].abs() + components[2].abs()).max(0.1);
        let tilt = Axis::angle(r"tilt $\theta$ / rad").range(0.0, PI);
        Panel::over_axes(tilt, Axis::linear("rate / (rad/s)").range(-high, high))
            .level(0.0, Ink::Frame, "")
            .curve(curve(0).label_at(r"$\dot\phi$", 0.3, rate(0)(0.3), Side::Right))
            .curve(curve(2).dashed().label_at(r"$\dot\zeta$", 0.2, rate(2)(0.2), Side::Right))
    };
}

/// How long the gyroscope is watched, s.
const END: f64 = 6.0;

/// Its angles, its angular velocity on x, y, z and in space, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let angles = ["t [s]", "phi [rad]", "theta [rad]", "zeta [rad]"].map(String::from);
    let components = ["x", "y", "z", "X", "Y", "Z"].map(|axis| format!("Omega_{axis} [rad/s]"));
    let (columns, g) = (angles.into_iter().chain(components), Gyroscope::of(p, 1.0));
    Trajectory::sampled(columns, times(0.0, END, 300), |t| {
        let now = g.after(t);
        Ok([&[t][..], &now.angles, &now.nodal(), &now.angular_velocity().to_array()].concat())
    })
}

/// The three rates, one after the other, and their sum; below, the components on x, y, z.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (g, all) = (Gyroscope::of(p, 0.1), times(0.0, END, 200));
    let path: Vec<[f64; 3]> = all.clone().map(|t| g.after(t).nodal()).collect();
    // The longest arrow, of the sum or of a part, reaches to the edge of the picture at most.
    let sums = all.clone().map(|t| g.after(t).angular_velocity().norm());
    let parts = [g.rates[0].abs(), g.rates[2].abs(), 1e-9];
    let scale = 1.6 / sums.chain(parts).fold(0.0, f64::max);
    let axis = Axis::linear("rad/s").over(path.iter().flatten().copied().chain([-0.1, 0.1]));
    let component = |i: usize, name: &str| {
        let curve = all.clone().zip(path.iter().map(|omega| omega[i]));
        Curve::new(curve, Ink::Velocity).label_end(name)
    };
    let graph = Panel::over_axes("$t$ / s", axis)
        .curve(component(0, r"$\Omega_x$").dotted())
        .curve(component(1, r"$\Omega_y$").dashed())
        .curve(component(2, r"$\Omega_z$"));
    MovingPicture::above(graph, 0.0..=END, [0.0, 1.4, 4.28], move |t| {
        let now = g.after(t);
        let ([x, _, z], [phi, theta, zeta]) = (now.triad(), now.rates.map(|rate| rate * scale));
        let (first, second, spin, omega) = (UP * phi, x * theta, z * zeta, now.angular_velocity());
        let (corner, sum) = (first + second, omega * scale);
        let alt = format!(
            "The gyroscope at {t:.1} s, tilted by {:.2} rad: from its centre an arrow up the vertical for the rate of phi, \
             on its tip one parallel to the pivots of the inner ring for theta, and along the axle of the rotor one for zeta. \
             A dashed line carries the last to the tip of the others, where their sum ends, the angular velocity, {:.1} rad/s. \
             Below, its components on x, y and z against time.",
            now.angles[1],
            omega.norm()
        );
        // With the angles and rates of the page both rings are wide open in all three stills.
        let view = View::of(UP * 0.06, 1.6).camera(Camera::new(1.13, 0.38)).size(340, 350);
        let scene = gimbals(view, &now)
            .ground(UP * -1.36, 1.0)
            .dashed([corner, sum], Ink::Velocity)
            .component(ORIGIN, first, Ink::Velocity, "", Side::Left)
            .text(first * 0.6, r"$\dot\phi$", Ink::Velocity, Side::Left)
            .component(first, corner, Ink::Velocity, r"$\dot\theta$", Side::Above)
            .component(ORIGIN, spin, Ink::Velocity, r"$\dot\zeta$", Side::Left)
            .arrow(ORIGIN, sum, Ink::Velocity, r"$\Omega$", Side::Right);
        Ok((alt, scene))
    })
}
