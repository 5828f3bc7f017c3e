//! The drawings; lengths in radii, except of the cycle wheel, which is the notes' instance.

use super::*;
use kit::draw::Camera;

/// A point of the rim after the wheel has turned by `t`.
fn on_cycloid(t: f64) -> (f64, f64) {
    (t - sin(t), 1.0 - cos(t))
}

/// The road, as long as a turn of the wheel and a wheel more.
fn road_sketch() -> Sketch {
    Sketch::within((-1.25, TAU + 1.25), (-0.8, 2.4)).wall((-1.2, 0.0), (TAU + 1.2, 0.0))
}

figures! { _: &Parameters;
    /// A wheel on a road at the start, after half a turn and after a turn. A point of its rim, which touches the road at
    /// the start, draws a high arch and is back on the road after the turn. In the middle position arrows show the
    /// velocities: none at the road, V at the centre, twice that at the top.
    cycloid: {
        let wheel = |sketch: Sketch, x, turn| sketch.roller((x, 1.0), 1.0, turn, Ink::Frame);
        let ends = |sketch: Sketch| wheel(wheel(sketch, 0.0, -FRAC_PI_2), TAU, -FRAC_PI_2);
        wheel(road_sketch().ghost(ends), PI, FRAC_PI_2)
            .curve(Curve::new(times(0.0, TAU, 120).map(on_cycloid), Ink::Body))
            .arrow_to((PI, 1.0), (PI + 0.85, 1.0), Ink::Ink, "$V$", Side::Right)
            .arrow_to((PI, 2.0), (PI + 1.7, 2.0), Ink::Ink, "$2V$", Side::Right)
            .turn((PI, 1.0), 0.5, (-2.0, -4.2), Ink::Velocity)
            .text((PI - 0.5, 1.0), r"$\omega$", Ink::Velocity, Side::Right)
            .dot((PI, 0.0), Ink::Ink, "at rest", Side::Below)
            .dot((PI, 2.0), Ink::Body, "", Side::Above)
            .dot((0.0, 0.0), Ink::Body, "", Side::Above)
            .dot((TAU, 0.0), Ink::Body, "", Side::Above)
    };

    /// A hexagon tips along a road from side to side. A corner of it draws five arcs of circles about the corners on which
    /// it tips; they follow a cycloid, a little inside.
    polygon: {
        let (corners, turn, pivots) = (tipping(6).0, TAU / 6.0, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        let hexagon = |sketch: Sketch, x: f64| {
            let corner = |k: f64| (x + cos(k * turn - 2.0 * turn), cos(0.5 * turn) + sin(k * turn - 2.0 * turn));
            sketch.body((0..6).map(|k| corner(f64::from(k))), Ink::Frame, 0.15)
        };
        let ends = |sketch: Sketch| hexagon(hexagon(sketch, 0.5), 6.5);
        let cycloid = Curve::new(times(0.0, TAU, 120).map(on_cycloid), Ink::Ink).thin().dashed();
        let sketch = hexagon(road_sketch().ghost(ends), 3.5).curve(cycloid);
        let tip = |sketch: Sketch, (x, ends): (f64, &[(f64, f64)])| {
            let (pivot, along, up) = ((x, 0.0), ends[0].0 - x, ends[0].1);
            let arc = times(0.0, turn, 20).map(|a| (x + cos(a) * along + sin(a) * up, cos(a) * up - sin(a) * along));
            let spoke = |sketch: Sketch, end| sketch.curve(Curve::new([pivot, end], Ink::Ink).thin());
            sketch
                .curve(Curve::new(arc, Ink::Body))
                .dot(pivot, Ink::Ink, "", Side::Below)
                .only_if(x == 3.0, |sketch| spoke(spoke(sketch, ends[0]), ends[1]))
        };
        let sketch = pivots.into_iter().zip(corners.windows(2)).fold(sketch, tip);
        corners.iter().fold(sketch, |sketch, &corner| sketch.dot(corner, Ink::Body, "", Side::Above))
    };

    /// A fixed coin C1; on top of it, at alpha, the coin C2, with an arrow from its centre O2 down to the point A where
    /// they touch. Faint at 45 degrees: the arrow has turned by 90. On the left, at beta: it points straight up.
    coins: {
        let (o, alpha, beta) = ((0.0, 0.0), (0.0, 2.0), (-2.0, 0.0));
        let path = times(0.0, TAU, 120).map(|t| {
            sum(polar(2.0, FRAC_PI_2 + t), polar(1.0, 2.0 * t - FRAC_PI_2))
        });
        let sketch = Sketch::within((-3.6, 2.6), (-1.6, 3.4))
            .curve(Curve::new(path.take(31), Ink::Body).thin().dashed())
            .disc(o, 1.0, Ink::Frame, 0.15)
            .ghost(|sketch| coin(sketch, polar(2.0, 0.75 * PI), 0.0, Ink::Body));
        let sketch = coin(sketch, alpha, -FRAC_PI_2, Ink::Body);
        coin(sketch, beta, FRAC_PI_2, Ink::Body)
            .curve(Curve::new([o, alpha], Ink::Ink).thin().dashed())
            .curve(Curve::new([o, beta], Ink::Ink).thin().dashed())
            .angle(o, 0.4, (FRAC_PI_2, PI), "")
            .text((-0.6, 0.62), r"$\theta_{orbit}$", Ink::Ink, Side::Centre)
            .curve(Curve::new([beta, (-2.0, -1.0)], Ink::Body).thin().dotted())
            .turn(beta, 0.45, (-FRAC_PI_2, 1.45), Ink::Body)
            .text((-2.06, 0.0), r"$\theta_{net}$", Ink::Body, Side::Left)
            .dot(o, Ink::Ink, "$O_1$", Side::BelowRight)
            .text(alpha, "$O_2$", Ink::Ink, Side::AboveRight)
            .text((0.0, 1.0), "$A$", Ink::Body, Side::BelowRight)
            .text((1.0, 2.0), r"$C_2$ at $\alpha$", Ink::Body, Side::Right)
            .text((-2.0, -1.0), r"$C_2$ at $\beta$", Ink::Body, Side::Below)
            .text((0.75, -0.75), "$C_1$", Ink::Frame, Side::BelowRight)
    };

    /// A wheel stands on the ground at the end of a level shaft, which is held by an upright rod. From the joint of rod and
    /// shaft three arrows: Omega along Z, up; Omega_S along the shaft, away from the wheel; and their sum. A dashed line
    /// leads from the point where the wheel touches the ground through the joint, along the sum.
    cycle_wheel: {
        let [r, a, scale] = WHEEL;
        let level = |t: f64| SpaceVector::new(cos(t), sin(t), 0.0);
        let (o, rho) = (SpaceVector::zero(), level(1.45));
        let (joint, centre, contact) = (UP * r, rho * a + UP * r, rho * a);
        let (precession, spin) = (UP * (2.0 * scale), rho * (-2.0 * a / r * scale));
        View::of(UP * 0.27, 0.72)
            .camera(Camera::new(0.6, 0.3))
            .size(340, 260)
            .ground(o, 0.72)
            .dashed(times(0.0, TAU, 90).map(|t| level(t) * a), Ink::Frame)
            .solid(Solid::rod(o, UP * 0.36, 0.012), Ink::Frame)
            .solid(Solid::rod(joint, centre, 0.012), Ink::Frame)
            .solid(Solid::wheel(centre, rho, r, 0.04, 0.3), Ink::Body)
            .dashed([contact, joint + (precession + spin)], Ink::Ink)
            .arrow(joint, joint + precession, Ink::Velocity, r"$\Omega\hat Z$", Side::Right)
            .arrow(joint, joint + spin, Ink::Velocity, r"$\Omega_S\hat\rho$", Side::Below)
            .arrow(joint, joint + (precession + spin), Ink::Velocity, "sum", Side::Above)
            .arrow(centre, centre + rho * 0.2, Ink::Frame, r"$\hat\rho$", Side::Right)
            .text(joint + rho * (0.5 * a), "$a$", Ink::Ink, Side::Above)
            .line([centre, contact], Ink::Ink)
            .text(centre - UP * (0.5 * r), "$R$", Ink::Ink, Side::Right)
            .dot(contact, Ink::Ink, "at rest", Side::BelowRight)
            .dot(joint, Ink::Ink, "", Side::Right)
    };

    /// From above: a shaft from the rod to the wheel, which is seen edge on. Shaft and wheel have turned by the angle phi
    /// about the rod. A line OP along the wheel, from its centre O, has turned by the same angle.
    cycle_top: {
        let ([r, a, _], phi) = (WHEEL, 0.8);
        let place = |phi: f64| {
            let aside = |r| sum(polar(a, phi), polar(r, phi + FRAC_PI_2));
            [aside(-r), aside(0.0), aside(r)]
        };
        let ([rear, hub, front], [rear0, hub0, front0], rod) = (place(phi), place(0.0), (0.0, 0.0));
        let shaft = |hub| Curve::new([rod, hub], Ink::Frame).width(2.4);
        Sketch::within((-0.5, 0.8), (-0.42, 0.72))
            .guide(times(-0.25, 2.4, 90).map(|t| polar(a, t)))
            .ghost(|sketch| sketch.bar(rear0, front0, 0.04, Ink::Body).curve(shaft(hub0)))
            .curve(shaft(hub))
            .bar(rear, front, 0.04, Ink::Body)
            .arrow_along([hub, front], Ink::Body)
            .angle(rod, 0.2, (0.0, phi), r"$\phi$")
            .turn(rod, 0.32, (1.1, 2.2), Ink::Velocity)
            .text(polar(0.33, 1.7), r"$\Omega=\dot\phi$", Ink::Velocity, Side::Above)
            .dot(rod, Ink::Ink, "$Z$, towards you", Side::BelowLeft)
            .dot(hub, Ink::Ink, "$O$", Side::BelowRight)
            .text(front, "$P$", Ink::Body, Side::Above)
    };

    /// The wheel from outside, facing it: it stands on the ground and rolls to the right. A line OP on it has turned
    /// clockwise by the angle zeta from an upright reference line.
    cycle_side: {
        let (zeta, o) = (0.9, (0.0, 1.0));
        let [short, end] = [0.95, 1.0].map(|r| (r * sin(zeta), 1.0 + r * cos(zeta)));
        Sketch::within((-1.9, 1.9), (-0.4, 2.9))
            .wall((-1.8, 0.0), (1.8, 0.0))
            .disc(o, 1.0, Ink::Body, 0.12)
            .guide([o, (0.0, 2.3)])
            .angle(o, 0.42, (FRAC_PI_2 - zeta, FRAC_PI_2), r"$\zeta$")
            .arrow_along([o, short], Ink::Body)
            .turn(o, 1.2, (2.6, 1.75), Ink::Velocity)
            .text((-0.95, 2.05), r"$\dot\zeta=-\Omega_S$", Ink::Velocity, Side::AboveLeft)
            .arrow_along([o, (0.0, 0.0)], Ink::Ink)
            .text((0.0, 0.5), "$R$", Ink::Ink, Side::Right)
            .arrow_along([(1.1, 0.55), (1.7, 0.55)], Ink::Ink)
            .text((1.4, 0.55), r"$\hat\phi$", Ink::Ink, Side::Above)
            .dot(o, Ink::Ink, "$O$", Side::Left)
            .text((-1.88, 0.2), r"$\hat\rho$ towards you", Ink::Ink, Side::Right)
            .text(end, "$P$", Ink::Body, Side::AboveRight)
            .dot((0.0, 0.0), Ink::Ink, "at rest", Side::Below)
    };

    /// A cylinder whose axis leans from the vertical AA' by the angle theta. Omega points up; dashed lines resolve it into
    /// a part along the cylinder's axis z and a part along y, at right angles to it.
    cylinder: {
        let (theta, phi, omega, o) = (0.5, 0.6 + PI, 1.25, SpaceVector::zero());
        let leaning = |t: f64| SpaceVector::new(sin(t) * sin(phi), -sin(t) * cos(phi), cos(t));
        let (z, y) = (leaning(theta), leaning(theta - FRAC_PI_2));
        let (along, across) = (z * (omega * cos(theta)), y * (omega * sin(theta)));
        View::of(UP * 0.2, 1.25)
            .size(340, 300)
            .solid(Solid::cylinder(z * -0.55, z * 0.55, 0.2), Ink::Body)
            .dashed([UP * -0.95, UP * 1.42], Ink::Frame)
            .dashed([along, UP * omega], Ink::Frame)
            .dashed([across, UP * omega], Ink::Frame)
            .arrow(o, UP * omega, Ink::Velocity, r"$\Omega\hat Z$", Side::Left)
            .arrow(o, along, Ink::Velocity, r"$\Omega_z\hat z$", Side::Right)
            .arrow(o, across, Ink::Velocity, r"$\Omega_y\hat y$", Side::Left)
            .turn(times(0.0, theta, 16).map(|t| leaning(t) * 0.8), Ink::Ink)
            .text(leaning(0.25) * 0.84, r"$\theta$", Ink::Ink, Side::Above)
            .text(UP * -0.95, "$A$", Ink::Frame, Side::Left)
            .text(UP * 1.42, "$A'$", Ink::Frame, Side::Right)
            .dot(o, Ink::Ink, "$O$", Side::BelowRight)
    };

    /// From above: the upper end of the tilted cylinder at four places of its orbit, P1 to P4, each with a mark on its rim.
    /// The line from O to P turns once, and so does the mark: it stays on the outer side.
    line: {
        // A disc that leans outward looks narrower along the line.
        let (o, wide, narrow) = ((0.0, 0.0), 0.36, 0.36 * cos(0.5));
        let place = |sketch: Sketch, (turn, label, side)| {
            let rim = times(0.0, TAU, 60).map(|t| {
                sum(polar(1.0 + narrow * cos(t), turn), polar(wide * sin(t), turn + FRAC_PI_2))
            });
            sketch
                .body(rim, Ink::Body, 0.15)
                .curve(Curve::new([o, polar(1.0, turn)], Ink::Body))
                .dot(polar(1.0, turn), Ink::Body, label, side)
                .ring(polar(1.0 + narrow, turn), Ink::Body, "", Side::Right)
        };
        let circle = Sketch::within((-1.7, 1.7), (-1.6, 1.6)).guide(times(0.0, TAU, 120).map(|t| polar(1.0, t)));
        let places = [
            (0.0, "$P_1$", Side::Above), (FRAC_PI_2, "$P_2$", Side::Left),
            (PI, "$P_3$", Side::Above), (1.5 * PI, "$P_4$", Side::Left),
        ];
        places.into_iter().fold(circle, place)
            .turn(o, 1.0, (0.62, 0.95), Ink::Velocity)
            .text(polar(1.05, 0.8), r"$\Omega$", Ink::Velocity, Side::AboveRight)
            .dot(o, Ink::Ink, "$O$", Side::BelowRight)
    };
}

/// The point at this distance from the origin in this direction.
fn polar(r: f64, angle: f64) -> (f64, f64) {
    (r * cos(angle), r * sin(angle))
}

/// Where one goes by both of these steps.
fn sum(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    (a.0 + b.0, a.1 + b.1)
}

/// A coin with an arrow from its centre to the mark on its rim, and a dot on the mark.
fn coin(sketch: Sketch, centre: (f64, f64), turn: f64, ink: Ink) -> Sketch {
    sketch
        .disc(centre, 1.0, ink, 0.15)
        .arrow_along([centre, sum(centre, polar(0.93, turn))], ink)
        .dot(sum(centre, polar(1.0, turn)), ink, "", Side::Centre)
}

/// The notes' cycle wheel: radius, shaft; and how long an arrow is for 1 rad/s.
const WHEEL: [f64; 3] = [0.3, 0.5, 0.16];

/// Coin on coin through a circuit, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (r, start) = (p.coin_radius, [2.0, 0.0, 1.0, 0.0, 0.0, 0.0]);
    let run = Dop853::new(p.tolerance)?.solve(&on_a_coin(1.0), 0.0, &start, 2.0 * TAU, &[])?;
    let columns = ["theta_net [rad]", "theta_orbit [rad]", "rim x [m]", "rim y [m]"];
    Trajectory::of(&run, columns, 360, |t, y: [f64; 6]| [t, y[4], r * y[2], r * y[3]])
}

/// Coin on coin, told twice: in the laboratory, and as seen from the line of centres. Where it
/// slips, an arrow at the contact says how fast.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (slip, net) = (p.slip, 2.0 - p.slip.unwrap_or(0.0));
    let spin = net - 1.0;
    let turned = Axis::angle("turned").range(TAU * spin.min(0.0), 2.0 * TAU);
    let line = |turns: f64| Curve::new([(0.0, 0.0), (TAU, turns * TAU)], Ink::Body);
    let graph = Panel::over_axes(Axis::angle(r"$\theta_{orbit}$"), turned.parts_of_pi(1))
        .curve(line(net).label("laboratory"))
        .curve(line(spin).dashed().label("line of centres"));
    MovingPicture::above(graph, 0.0..=TAU, [0.0, FRAC_PI_2, PI], move |t| {
        let turned = |angle: f64| format!("{:.0}", angle.to_degrees());
        let (back, on) = (turned(t), turned((spin * t).abs()));
        let sense = ["counterclockwise", "clockwise"][usize::from(spin < 0.0)];
        let (moves, seen) = match slip {
            None => ("rolling", format!("by {back} degrees each, in opposite senses")),
            Some(_) => ("slipping", format!("by {back} degrees clockwise and by {on} {sense}")),
        };
        let alt = format!(
            "Left, in the laboratory: the line of centres has turned by {back} degrees and the {moves} \
             coin by {}. Right, as seen from the line of centres: the coins turn in place, {seen}. \
             Below, the two angles of the {moves} coin.",
            turned(net * t)
        );
        let (left, right, up) = ((-3.35, 0.0), (3.35, 0.0), FRAC_PI_2);
        let (there, above) = (sum(left, polar(2.0, up + t)), (right.0, 2.0));
        let centres = |points| Curve::new(points, Ink::Ink).thin().dashed();
        let sketch = Sketch::within((-6.6, 6.6), (-4.3, 3.3))
            .curve(centres([left, there]))
            .curve(centres([right, above]));
        let sketch = coin(coin(sketch, left, up, Ink::Frame), right, up - t, Ink::Frame);
        let sketch = coin(sketch, there, net * t - up, Ink::Body);
        let sketch = coin(sketch, above, spin * t - up, Ink::Body);
        let contact = sum(left, polar(1.0, up + t));
        let tip = sum(contact, polar(0.8 * slip.unwrap_or(0.0), 2.0 * up + t));
        let sketch = sketch.only_if(slip.is_some(), |s| s.arrow_along([contact, tip], Ink::Ink));
        let below = |s: Sketch, x, words| s.text((x, -3.6), words, Ink::Ink, Side::Centre);
        let sketch = below(sketch, left.0, "in the laboratory");
        Ok((alt, below(sketch, right.0, "from the line of centres")))
    })
}
