//! Why L leaves Omega, by how much, the set-ups of the examples, and the cylinder that turns.

use super::*;

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);

type Point = (f64, f64);

/// A thin dashed line.
fn dashed(from: Point, to: Point, ink: Ink) -> Curve {
    Curve::new([from, to], ink).thin().dashed()
}

/// A shaft in two bearings, held by a frame behind it.
fn bearings(view: View) -> View {
    let (low, high, back) = (UP * -0.92, UP * 0.92, SpaceVector::new(0.15, -0.85, 0.0));
    let frame = [(low + back, high + back), (low, low + back), (high, high + back)];
    let rods = frame.map(|(from, to)| Solid::rod(from, to, 0.03)).into_iter();
    let rings = [low, high].map(|at| Solid::ring(at, UP, 0.07, 0.028));
    let view = rods.chain(rings).fold(view, |view, solid| view.solid(solid, Ink::Frame));
    view.solid(Solid::rod(UP * -1.0, UP * 1.0, 0.02), Ink::Frame)
}

figures! { p: &Parameters, o = (0.0, 0.0);
    /// A stick with a ball at each end slants on an upright shaft. The upper ball, on the left, moves towards
    /// the reader, the lower one away. Both have their angular momentum along the same line, which is square to
    /// the stick and leans to the right of the shaft, along which Omega points.
    dumbbell: {
        let end = euler(0.0, 0.8, 0.0).to_space(BodyVector::new(0.0, 0.0, 0.68));
        let momentum = UP.cross(&end);
        bearings(View::of(UP * 0.17, 1.25).size(340, 320))
            .solid(Solid::rod(-end, end, 0.022), Ink::Body)
            .solid(Solid::ball(end, 0.12), Ink::Body)
            .solid(Solid::ball(-end, 0.12), Ink::Body)
            .arrow(end, end + momentum, Ink::Ink, "$p$", Side::Below)
            .arrow(-end, -end - momentum, Ink::Ink, "$-p$", Side::Above)
            .arrow(UP, UP * 1.35, Ink::Velocity, r"$\Omega$", Side::Right)
            .arrow(SpaceVector::zero(), end.cross(&momentum) * 2.4, Ink::Momentum, "$L$", Side::Right)
            .text(end * 0.5, "$r$", Ink::Body, Side::AboveRight)
    };

    /// The plane of the cylinder and the shaft. Omega points up. Its part along the cylinder, up to the left, is
    /// long, its part square to it short. Times their moments the long part becomes short and the short one
    /// long: L points up to the right.
    components: {
        let (shaft, (s, c)) = (Shaft::of(p)?, sincos(p.tilt));
        let y = |by: f64| (c * by, s * by);
        let z = |by: f64| (-s * by, c * by);
        let (omega, l) = (shaft.angular_velocity(), shaft.momentum());
        let (wide, long) = (1.0 / p.rate, 1.25 / l.norm());
        let [oy, oz] = [y(omega.y() * wide), z(omega.z() * wide)];
        let [ly, lz] = [y(l.y() * long), z(l.z() * long)];
        let (up, tip) = ((0.0, 1.0), (ly.0 + lz.0, ly.1 + lz.1));
        Sketch::within((-0.95, 1.4), (-0.75, 1.2))
            .bar(z(-0.75 * 0.95), z(0.75 * 0.95), 0.24, Ink::Body)
            .curve(dashed(o, z(1.15), Ink::Body))
            .text(z(1.15), "$z$", Ink::Body, Side::Left)
            .curve(dashed(o, y(1.45), Ink::Body))
            .text(y(1.45), "$y$", Ink::Body, Side::Right)
            .curve(dashed(oy, up, Ink::Velocity))
            .curve(dashed(oz, up, Ink::Velocity))
            .curve(dashed(ly, tip, Ink::Momentum))
            .curve(dashed(lz, tip, Ink::Momentum))
            .arrow_to(o, oz, Ink::Velocity, r"$\Omega_z$", Side::Left)
            .arrow_to(o, ly, Ink::Momentum, r"$I_1\Omega_y$", Side::Below)
            .arrow_to(o, oy, Ink::Velocity, r"$\Omega_y$", Side::Below)
            .arrow_to(o, lz, Ink::Momentum, r"$I_3\Omega_z$", Side::Left)
            .arrow_to(o, up, Ink::Velocity, r"$\Omega$", Side::Above)
            .arrow_to(o, tip, Ink::Momentum, "$L$", Side::Right)
    };

    /// Angle from Omega to L against the angle from the shaft to the cylinder. For a height of root three radii
    /// it is zero throughout. A disc leans by up to 0.34 rad; the longer the cylinder, the more its curve
    /// approaches the straight line from a right angle to zero, but each curve begins and ends at zero.
    angles: {
        let tilt = Axis::angle(r"tilt $\theta$ / rad").range(0.0, FRAC_PI_2);
        let lean = Axis::angle(r"from $\Omega$ to $L$ / rad").range(0.0, FRAC_PI_2);
        let shapes = [
            (0.0, "disc", 0.62, Side::Above),
            (3.0_f64.sqrt(), r"$\sqrt 3$", 0.9, Side::Above),
            (3.0, "3", 0.6, Side::Below),
            (6.0, "$H/R=6$", 0.75, Side::AboveRight),
            (20.0, "20", 0.45, Side::AboveRight),
        ];
        shapes.into_iter().fold(Panel::over_axes(tilt, lean), |panel, (ratio, label, at, side)| {
            let of = |tilt| shape(ratio, tilt).angle();
            let summed = |tilt| {
                let body = worked::on_shaft(cylinder(1.0, 1.0, ratio), tilt, 1.0);
                angle(body.angular_momentum(ORIGIN), UP)
            };
            panel
                .curve(Curve::of(times(0.0, FRAC_PI_2, 200), of, Ink::Ink).label_at(label, at, of(at), side))
                .curve(Curve::of(times(0.15, 1.5, 5), summed, Ink::Momentum).dots())
        })
    };

    /// A wheel rolls to the right on a floor, turning clockwise. Its centre has the velocity V, the top of its
    /// rim twice that. In units of M R squared Omega the angular momentum is one half about the centre, three
    /// halves about the point of contact and about a point A of the floor, minus one half about the top.
    wheel: {
        let (top, centre) = ((0.0, 2.0), (0.0, 1.0));
        Sketch::within((-2.5, 2.2), (-0.5, 2.55))
            .wall((-2.4, 0.0), (2.1, 0.0))
            .roller(centre, 1.0, -2.2, Ink::Body)
            .turn(centre, 0.62, (0.9, -0.5), Ink::Velocity)
            .text((0.62, 0.55), r"$\Omega$", Ink::Velocity, Side::Left)
            .arrow_to(top, (1.5, 2.0), Ink::Ink, "$2V$", Side::Right)
            .arrow_to(centre, (0.75, 1.0), Ink::Ink, "$V$", Side::Above)
            .dot(top, Ink::Momentum, "$-1/2$", Side::Above)
            .dot(centre, Ink::Momentum, "$1/2$", Side::Left)
            .dot(o, Ink::Momentum, "$B$: $3/2$", Side::BelowRight)
            .dot((-1.75, 0.0), Ink::Momentum, "$A$: $3/2$", Side::Below)
    };

    /// A coin rolls round a fixed one of the same size. While the line of the centres turns by 60 degrees, a
    /// mark on the rolling coin turns by 120.
    coin: {
        let (s, c) = sincos(PI / 3.0);
        let (before, after) = ((2.0, 0.0), (2.0 * c, 2.0 * s));
        Sketch::within((-1.3, 3.4), (-1.25, 3.0))
            .disc(o, 1.0, Ink::Frame, 0.25)
            .ghost(|sketch| sketch.roller(before, 1.0, PI, Ink::Body))
            .roller(after, 1.0, PI + 2.0 * PI / 3.0, Ink::Body)
            .curve(dashed(o, before, Ink::Frame))
            .curve(dashed(o, after, Ink::Frame))
            .turn(o, 2.0, (0.25, 0.75), Ink::Velocity)
            .text((1.85, 1.0), r"orbit $\Omega$", Ink::Velocity, Side::Right)
            .turn(after, 0.55, (-0.5, 1.0), Ink::Velocity)
            .text((1.6, 2.0), r"$2\Omega$", Ink::Velocity, Side::Right)
            .dot(o, Ink::Ink, "", Side::Below)
            .text((0.0, -1.0), "fixed", Ink::Frame, Side::Above)
    };

    /// The orbit of the Earth seen edge-on. At the Sun the orbital angular momentum points along the normal z.
    /// The Earth's own points along its axis s, 23 degrees from z. A dashed arrow along z on the Earth is marked
    /// as wrong.
    earth: {
        let (earth, (s, c)) = ((2.6, 0.0), sincos(0.409));
        let (own, south) = ((2.6 + 1.3 * s, 1.3 * c), (2.6 - 0.85 * s, -0.85 * c));
        Sketch::within((-0.55, 4.1), (-1.05, 1.9))
            .curve(dashed(o, earth, Ink::Frame))
            .text((1.3, 0.0), "$R_{ES}$", Ink::Frame, Side::Below)
            .disc(o, 0.24, Ink::Energy, 0.8)
            .disc(earth, 0.5, Ink::Body, 0.35)
            .arrow_to(o, (0.0, 1.6), Ink::Momentum, "orbital $L$, along $z$", Side::Right)
            .curve(dashed(south, earth, Ink::Frame))
            .arrow_to(earth, own, Ink::Momentum, "own $L$, along $s$", Side::Above)
            .curve(Curve::new([earth, (2.6, 1.25)], Ink::Wrong).dashed().arrow(1.0))
            .text((2.6, 1.0), "wrong: third term", Ink::Wrong, Side::Left)
            .text((0.0, -0.3), "Sun", Ink::Ink, Side::Below)
            .text((2.6, -0.55), "Earth", Ink::Ink, Side::BelowRight)
    };

    /// A wheel rolls on the floor at the end of a level shaft that is hinged on an upright rod. Omega points up
    /// along the rod. L starts at the hinge, points up and leans away from the wheel. From the hub the weight
    /// pulls down; from below the floor pushes up at the wheel, with a little more.
    runner: {
        let at = |out: f64, up: f64| SpaceVector::new(0.0, out, up);
        let (hinge, hub) = (at(0.0, 0.0), at(1.05, 0.0));
        let drawn = p.but(|p| (p.runner_mass, p.runner_radius, p.runner_shaft, p.runner_rate) = (1.0, 0.6, 1.05, 1.0));
        let [along, up] = worked::runner_momentum(&drawn).map(|l| 0.75 * l);
        // Where the wheel has come from and where it goes.
        let track = times(0.6, 2.5, 30).map(|turn| SpaceVector::new(1.05 * cos(turn), 1.05 * sin(turn), -0.6));
        View::of(at(0.45, -0.03), 1.12)
            .size(340, 320)
            .ground(at(0.45, -0.6), 0.9)
            .solid(Solid::rod(at(0.0, -0.6), at(0.0, 0.45), 0.035), Ink::Frame)
            .solid(Solid::rod(hinge, hub, 0.022), Ink::Frame)
            .solid(Solid::disc(hub, at(1.0, 0.0), 0.6, 0.07), Ink::Body)
            .line(track, Ink::Frame)
            .arrow(hinge, at(along, up), Ink::Momentum, "$L$", Side::Left)
            .arrow(at(0.0, 0.45), at(0.0, 1.0), Ink::Velocity, r"$\Omega$", Side::Right)
            .arrow(at(1.09, 0.0), at(1.09, -0.4), Ink::Force, "", Side::Left)
            .text(at(1.09, -0.2), "$Mg$", Ink::Ink, Side::Right)
            .arrow(at(1.05, -1.03), at(1.05, -0.6), Ink::Force, "", Side::Right)
            .text(at(1.05, -0.85), "$N$", Ink::Force, Side::Right)
    };

    /// A square plate with a corner at the origin turns about its left edge, the y axis. Omega points up along
    /// that edge; L points up and to the left, close to the second diagonal y'. The first diagonal x' runs
    /// through the plate.
    plate: Sketch::within((-1.25, 1.6), (-0.5, 1.75))
        .block((0.5, 0.5), (1.0, 1.0), 0.0, Ink::Body)
        .curve(dashed((0.0, -0.1), (0.0, 1.7), Ink::Frame))
        .curve(dashed(o, (1.5, 0.0), Ink::Frame))
        .text((1.5, 0.0), "$x$", Ink::Frame, Side::Below)
        .text((0.0, 1.7), "$y$", Ink::Frame, Side::Left)
        .curve(dashed(o, (1.2, 1.2), Ink::Body))
        .text((1.2, 1.2), "$x'$", Ink::Body, Side::Right)
        .curve(dashed(o, (-1.1, 1.1), Ink::Body))
        .text((-1.1, 1.1), "$y'$", Ink::Body, Side::Left)
        .arrow_along([o, (0.0, 1.4)], Ink::Velocity)
        .text((0.0, 1.3), r"$\Omega$", Ink::Velocity, Side::Right)
        .arrow_to(o, (-0.84, 1.12), Ink::Momentum, "$L$", Side::Above)
        .dimension((0.0, -0.15), (1.0, -0.15), "$a$", Side::Below);
}

/// L on fixed axes at a time.
fn momentum(shaft: &Shaft, t: f64) -> SpaceVector {
    shaft.attitude(t).to_space(shaft.momentum())
}

/// One moment, without the graph; the cylinder is at most 1.2 long and wide.
fn scene(p: &Parameters, shaft: &Shaft, t: f64) -> View {
    let (attitude, size) = (shaft.attitude(t), 0.95 / shaft.momentum().norm());
    let unit = 0.6 / (0.5 * p.height).max(p.radius);
    let end = attitude.to_space(BodyVector::new(0.0, 0.0, 1.0)) * (0.5 * p.height * unit);
    let tip = momentum(shaft, t) * size;
    let path = times(0.0, TAU / shaft.rate, 90).map(|t| momentum(shaft, t) * size);
    let torque = attitude.to_space(shaft.torque()) * (0.9 * size / shaft.rate.abs());
    let [from, to] = if shaft.rate < 0.0 { [1.35, 1.0] } else { [1.0, 1.35] };
    bearings(View::of(UP * 0.1, 1.3).size(340, 340))
        .solid(Solid::cylinder(-end, end, p.radius * unit), Ink::Body)
        .ground(UP * -1.0, 0.85)
        .dashed(path, Ink::Momentum)
        .arrow(UP * from, UP * to, Ink::Velocity, r"$\Omega$", Side::Right)
        .arrow(ORIGIN, tip, Ink::Momentum, "", Side::Right)
        .text(tip * 0.7, "$L$", Ink::Momentum, Side::Below)
        .only_if(torque.norm() > 0.05, |view| {
            view.arrow(tip, tip + torque, Ink::Force, r"$\tau$", Side::Below)
        })
}

/// How long it is followed, s: a turn and a half, and a bit.
fn end(shaft: &Shaft) -> f64 {
    1.6 * TAU / shaft.rate.abs()
}

/// The cylinder on its shaft, above the components of L.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (p, shaft) = (p.clone(), Shaft::of(p)?);
    let end = end(&shaft);
    let part = |axis: usize, label: &str| {
        let part = |t| momentum(&shaft, t)[axis];
        Curve::of(times(0.0, end, 160), part, Ink::Momentum).label_end(label)
    };
    let time = Axis::linear("$t$ / s").range(0.0, end);
    let graph = Panel::over_axes(time, r"$L$ / (kg m$^2$/s)")
        .curve(part(0, "$L_X$").dotted())
        .curve(part(1, "$L_Y$").dashed())
        .curve(part(2, "$L_Z$"));
    let side = ["towards", "away from"][usize::from(shaft.i1 > shaft.i3)];
    let (way, near) = match shaft.rate < 0.0 {
        true => ("down", "lower"),
        false => ("up", "upper"),
    };
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.17 * end, 0.36 * end], move |t| {
        let alt = format!(
            "A cylinder slants on an upright shaft in two bearings, {:.2} turns after the start. \
             Omega points {way} along the shaft; L leans {side} the {near} end of the cylinder, and \
             its tip is on a level circle. At the tip the torque points along the circle. Below, \
             the level components of L swing, the upright one stays.",
            t * shaft.rate.abs() / TAU
        );
        Ok((alt, scene(&p, &shaft, t)))
    })
}

/// Angular momentum and torque on fixed axes, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let shaft = Shaft::of(p)?;
    let columns = "t [s], L_X [kg m^2/s], L_Y [kg m^2/s], L_Z [kg m^2/s], tau_X [N m], tau_Y [N m], tau_Z [N m]";
    Trajectory::sampled(columns.split(", "), times(0.0, end(&shaft), 200), |t| {
        let torque = shaft.attitude(t).to_space(shaft.torque());
        Ok([&[t], &momentum(&shaft, t).to_array()[..], &torque.to_array()].concat())
    })
}
