//! The drawings of exercise 16.4; lengths in radii, forces in weights.

use super::*;

/// The disc with its string: the straight part from the height `top` on, what lies on the rim,
/// and the knot.
fn drawn(sketch: Sketch, d: &Disc, top: f64, (leaves, y): (Leaves, [f64; 6])) -> Sketch {
    let ([x, y, knot, ..], Taut { arm, margin, .. }) = (y, d.taut(leaves, &y));
    let at = |angle: f64| (x + cos(angle), y + sin(angle));
    let wound = match leaves {
        Leaves::Unwinding => margin.min(6.2),
        Leaves::Knot => 0.0,
        Leaves::Winding => -margin.min(6.2),
    };
    let (left, end) = (atan2(arm[1], arm[0]), (x + arm[0], y + arm[1]));
    let rim = || Curve::new(times(left - wound, left, 90).map(at), Ink::Ink);
    sketch
        .roller((x, y), 1.0, knot, Ink::Body)
        .only_if(wound != 0.0, |sketch| sketch.curve(rim()))
        .string((top * end.0 / end.1, top), end, "", Side::Left)
        .dot(at(knot), Ink::Ink, "", Side::Left)
}

/// The path of the centre from time to time.
fn path(run: &Run<Leaves, 6>, from: f64, to: f64, count: u32) -> Result<Vec<(f64, f64)>> {
    sampled(times(from, to, count), |t| Ok(run.at(t).map(|(_, y)| (y[0], y[1]))?))
}

fn roofed(x: (f64, f64), y: (f64, f64)) -> Sketch {
    Sketch::within(x, y).wall((1.2, 0.0), (-1.2, 0.0))
}

figures! { _: &Parameters, usual = Parameters::default(), d = disc(&usual)?, run = d.run(1e-12)?,
    [end, over] = [run.transition("all unwound")?.t, run.transition("winds up")?.t];
    /// A vertical string hangs from a roof. It touches the rim of a disc of the radius R and the mass M on its
    /// right side and is wound on it. Between the roof and the disc it has the length l0. The disc goes down
    /// with v and turns counterclockwise with omega.
    setup: roofed((-3.6, 2.2), (-4.6, 0.5))
        .string((0.0, 0.0), (0.0, -2.4), "", Side::Right)
        .disc((-1.0, -2.4), 1.0, Ink::Body, 0.15)
        .curve(Curve::new(times(-5.6, 0.0, 120).map(|t| (cos(t) - 1.0, sin(t) - 2.4)), Ink::Ink))
        .arrow((-1.0, -2.4), (-1.0, -4.1), Ink::Velocity, "$v$", Side::Left)
        .turn((-1.0, -2.4), 1.4, (2.4, 3.7), Ink::Velocity).text((-2.4, -2.3), r"$\omega$", Ink::Velocity, Side::Left)
        .dimension((0.6, -2.4), (0.6, 0.0), "$l_0$", Side::Right)
        .dimension((-1.0, -2.4), (-1.0 + cos(2.2), -2.4 + sin(2.2)), "$R$", Side::Above)
        .text((-1.0, -2.6), "$M$", Ink::Body, Side::Right)
        .gravity((1.7, -2.8), 1.0);

    /// The disc alone. The tension pulls upward at the right end of its horizontal radius, the weight, three
    /// times as large, downward at its centre. The velocity of the left end of the radius is twice that of the
    /// centre; at the right end, where the string leaves, it is zero.
    forces: Sketch::within((-2.6, 2.3), (-2.9, 2.1))
        .disc((0.0, 0.0), 1.0, Ink::Body, 0.15)
        .guide([(-1.0, 0.0), (1.0, 0.0)])
        .arrow((1.0, 0.0), (1.0, 0.8), Ink::Force, "$T$", Side::Right)
        .arrow((0.0, 0.0), (0.0, -2.4), Ink::Force, "$Mg$", Side::Right)
        .arrow((-0.5, 0.0), (-0.5, -0.45), Ink::Velocity, "", Side::Left)
        .arrow((-1.0, 0.0), (-1.0, -0.9), Ink::Velocity, r"$2\omega R$", Side::Left)
        .arrow((0.5, 0.0), (0.5, -0.22), Ink::Velocity, "", Side::Left)
        .dot((1.0, 0.0), Ink::Ink, "at rest", Side::BelowRight).dot((0.0, 0.0), Ink::Ink, "", Side::Left)
        .turn((0.0, 0.0), 1.35, (1.9, 3.0), Ink::Velocity).text((-1.2, 0.75), r"$\omega$", Ink::Velocity, Side::AboveLeft);

    /// The disc at the end of its string, when the knot is directly above its centre, and when string winds up
    /// again. At first it is on the left of the string, at last on the right; its centre goes along a narrow
    /// bow.
    turn: {
        let (before, lowest) = (run.at(end)?.1, run.at(0.5 * (end + over))?.1);
        let after = run.at(over)?.1;
        let base = Sketch::within((-2.9, 2.6), (-9.0, -4.0))
            .curve(Curve::new(path(&run, end - 0.3, over + 0.3, 80)?, Ink::Body).dashed())
            .ghost(|sketch| drawn(drawn(sketch, &d, -4.0, (Leaves::Unwinding, before)), &d, -4.0, (Leaves::Winding, after)));
        drawn(base, &d, -4.0, (Leaves::Knot, lowest))
            .text((0.15, -6.5), "1", Ink::Frame, Side::Right)
            .text((lowest[0] + 0.35, lowest[1] + 1.25), "2", Ink::Frame, Side::Right)
            .text((after[0] - 1.1, after[1] + 0.35), "3", Ink::Frame, Side::Left)
    };

    /// Velocities against time. That of the centre, downward, rises evenly, falls within a tenth of a second
    /// through zero to nearly the opposite value and rises again. That of the rim about the centre rises with
    /// it, has a narrow peak of nearly twice its value in the turn, and falls again. Dashed, a bounce, which
    /// reverses the velocity at once.
    speeds: {
        let [second, speed] = [usual.radius / usual.gravity, usual.radius * usual.gravity].map(f64::sqrt);
        let of = |k: usize, unit: f64, ink| {
            let points = sampled(times(0.0, run.end_time(), 400), |t| Ok((t * second, unit * run.at(t)?.1[k])))?;
            Ok::<_, kit::Error>(Curve::new(points, ink))
        };
        let bounce = times(end, 2.0 * end, 2).map(|t| (t * second, speed * (t - 2.0 * end) / 1.5));
        Panel::over_axes("$t$ / s", Axis::linear("velocity / (m/s)").range(-4.0, 7.0))
            .curve(of(5, speed, Ink::Velocity)?.label_at(r"$\omega R$", 0.75, 5.0, Side::Right))
            .curve(of(4, -speed, Ink::Body)?.label_at("$v$", 0.2, 1.3, Side::AboveLeft))
            .curve(Curve::new(bounce, Ink::Velocity).dashed().label_at("wrong: bounce", 0.54, -3.3, Side::Left))
    };

    /// Largest tension over the weight against the length of the wound string over the radius: a straight line
    /// that rises by four for each radius. The simulated dots, for a free string of one and a half radii, lie a
    /// little above it.
    peak: {
        let wound = Sweep::over("$s_0/R$", 1.0, 12.0).at([1.0, 2.0, 3.5, 5.0, 7.0, 9.0, 11.0]);
        let at = |wound| d.but(|d| d.wound = wound);
        wound.panel(Axis::linear("$T_{max}/Mg$").range(0.0, 60.0))
            .curve(wound.exact(|s| long_peak(&at(s))).label_at("very long string", 8.0, 37.0, Side::BelowRight))
            .curve(wound.simulated(|s| at(s).peak(&at(s).run(1e-9)?))?.label("simulated"))
    };
}

pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (d, r, second) = (disc(p)?, p.radius, (p.radius / p.gravity).sqrt());
    let run = d.run(p.tolerance)?;
    let columns = "t [s], x [m], y [m], turned by [rad], vx [m/s], vy [m/s], omega [rad/s], T [N]";
    Trajectory::sampled(columns.split(", "), times(0.0, run.end_time(), 800), |t| {
        let (leaves, y) = run.at(t)?;
        let (pull, v) = (p.mass * p.gravity * d.taut(leaves, &y).tension, r / second);
        let [x, y, angle, vx, vy, rate] = y;
        let place = [t * second, r * x, r * y, angle + d.wound];
        Ok([place, [v * vx, v * vy, rate / second, pull]].concat())
    })
}

/// Down, over the knot and up; below, the tension.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (d, second) = (disc(p)?, (p.radius / p.gravity).sqrt());
    let run = d.run(p.tolerance)?;
    let (end, over) = (run.transition("all unwound")?.t, run.transition("winds up")?.t);
    let last = run.end_time();
    let spans = [(0.0, end, 40), (end, over, 120), (over, last, 60)];
    let instants = spans.into_iter().flat_map(|(from, to, count)| times(from, to, count));
    let tension = sampled(instants, |t| {
        let (leaves, y) = run.at(t)?;
        Ok((t * second, d.taut(leaves, &y).tension))
    })?;
    let graph = Panel::over_axes("$t$ / s", "$T/Mg$").curve(Curve::new(tension, Ink::Force));
    let stills = [0.7 * end, 0.5 * (end + over), 0.75 * last].map(|t| t * second);
    let deep = d.length() + 2.6;
    MovingPicture::above(graph, 0.0..=last * second, stills, move |t| {
        let now = (t / second).min(last);
        let (leaves, y) = run.at(now)?;
        let taut = d.taut(leaves, &y);
        let does = match leaves {
            Leaves::Unwinding => "falls and unwinds",
            Leaves::Knot => "turns over the knot at the end of the string",
            Leaves::Winding => "climbs on the other side of the string",
        };
        let alt = format!(
            "After {t:.2} s the disc {does}; the tension is {:.2} times its weight. Below, the tension \
             against time: level, a high narrow peak, and low again.",
            taut.tension
        );
        let [tx, ty] = [y[0] + taut.arm[0], y[1] + taut.arm[1]];
        let far = hypot(tx, ty);
        let long = 0.9 * taut.tension.min(0.9 * far);
        let tip = (tx * (1.0 - long / far), ty * (1.0 - long / far));
        let roof = roofed((-0.5 * deep, 0.5 * deep), (-deep, 0.4)).high(355);
        let scene = drawn(roof.guide(path(&run, 0.0, now, 300)?), &d, 0.0, (leaves, y));
        Ok((alt, scene.arrow((tx, ty), tip, Ink::Force, "$T$", Side::Right)))
    })
}
