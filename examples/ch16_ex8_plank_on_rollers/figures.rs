//! The drawings of exercise 16.8.

use super::*;
use rotation_dynamics::planar::contact::Mode;

/// The rollers, turned by this angle, and a plank with its middle at `[x, y]` and this tilt.
fn drawn(sketch: Sketch, p: &Parameters, turn: f64, [x, y, tilt]: [f64; 3]) -> Sketch {
    let (a, (s, c)) = (p.distance, sincos(tilt));
    // A thin plank is drawn with a thickness, above its lower face.
    let thick = p.thickness.max(0.04 * a);
    let up = 0.5 * (thick - p.thickness);
    let centre = (x - s * up, 0.5 * p.thickness + y + c * up);
    let roller = |sketch: Sketch, side: f64| {
        let axle = (0.5 * side * a, -RADIUS * a);
        sketch.roller(axle, RADIUS * a, FRAC_PI_2 + side * turn, Ink::Frame)
    };
    let sketch = [-1.0, 1.0].into_iter().fold(sketch, roller);
    sketch.block(centre, (2.4 * a, thick), tilt, Ink::Body).dot(centre, Ink::Body, "", Side::Above)
}

/// The set-up of the problem in one of the senses; the distance is 1.
fn problem(sense: f64) -> Sketch {
    let turning = |sketch: Sketch, side: f64| {
        let ends = if sense > 0.0 { [0.25, 2.1] } else { [2.1, 0.25] };
        let [from, to] = ends.map(|turned| -FRAC_PI_2 + turned * side);
        sketch.turn((0.5 * side, -RADIUS), 0.21, (from, to), Ink::Velocity)
    };
    let sketch = Sketch::within((-1.15, 1.5), (-0.68, 0.42));
    let sketch = drawn(sketch, &Parameters::default(), 0.0, [0.17, 0.0, 0.0]);
    turning(turning(sketch, -1.0), 1.0)
        .guide([(0.0, -0.3), (0.0, 0.3)])
        .guide([(0.17, 0.0), (0.17, 0.3)])
        .guide([(-0.5, -RADIUS), (-0.5, -0.58)])
        .guide([(0.5, -RADIUS), (0.5, -0.58)])
        .dimension((-0.5, -0.5), (0.5, -0.5), "$a$", Side::Below)
        .arrow((0.0, 0.2), (0.17, 0.2), Ink::Ink, "", Side::Above)
        .text((0.085, 0.22), "$x$", Ink::Ink, Side::Above)
        .gravity((1.3, -0.1), 0.25)
}

/// The phase plane, so far to both sides, with the speed `v` of the rollers.
fn plane(reach: f64, v: f64) -> Panel {
    let speeds = Axis::linear(r"$v/\lambda a$").range(-1.5 * v, 1.5 * v);
    Panel::over_axes(Axis::linear("$x/a$").range(-reach, reach), speeds)
        .level(v, Ink::Velocity, "$V$")
        .level(-v, Ink::Velocity, "$-V$")
}

/// The motion from rest at this offset, as points of the phase plane in units of the distance.
fn portrait(p: &Parameters, sense: f64, offset: f64, end: f64) -> Result<Vec<(f64, f64)>> {
    let ride = released(&from(p, offset), sense, end)?;
    let until = ride.event("left lets go").map_or(ride.end_time(), |event| event.t);
    let scale = p.distance * rate(p, sense);
    sampled(times(0.0, until, 300), |t| {
        let MechanismState { q, v } = ride.at(t)?;
        Ok((q[0] / p.distance, v[0] / scale))
    })
}

figures! { p: &Parameters;
    /// A plank lies on two rollers at the distance a. The left one turns clockwise, the right one
    /// counterclockwise, so that their tops move towards each other. The middle of the plank is at the distance
    /// x to the right of the middle between the rollers.
    setup_in: problem(1.0);

    /// The same with the senses reversed: the tops move away from each other.
    setup_out: problem(-1.0);

    /// Phase plane, tops together: circles about the middle up to that which touches the speed of the rollers.
    /// A motion from farther out runs along an arc to the line of that speed, along this line past the middle,
    /// and then round and round on a closed curve of two arcs and two straight pieces.
    together: {
        let (a, swing) = (p.distance, rate(p, 1.0));
        let (v, (amplitude, round)) = (p.runs() / (a * swing), cycle(p));
        let panel = plane(1.2 * amplitude.max(p.offset.abs()) / a, v).equal_aspect();
        let path = |offset, end| Ok::<_, kit::Error>(Curve::new(portrait(p, 1.0, offset, end)?, Ink::Body));
        let circle = |panel: Panel, part: f64| Ok::<_, kit::Error>(panel.curve(path(part * v * a, TAU / swing)?.thin()));
        // A circle that is wider than the rollers are apart is no motion.
        let fits = |part: &f64| part * v * a < lift(p, 1.0);
        [0.35, 0.7, 0.999_999].into_iter().filter(fits).try_fold(panel, circle)?
            .curve(path(p.offset, 2.0 * round)?.arrow(0.06))
            .dot(p.offset / a, 0.0, Ink::Body, "start", Side::Above).dot(0.0, 0.0, Ink::Ink, "", Side::Above)
    };

    /// Phase plane, tops apart: lines that run away from the middle to the line of the speed of the rollers and
    /// follow it to the edge, where a ring marks the tipping.
    apart: {
        let (a, growth) = (p.distance, rate(p, -1.0));
        let v = p.runs() / (a * growth);
        let panel = plane(0.6, v).dot(0.0, 0.0, Ink::Ink, "", Side::Above);
        [0.01, 0.1, 0.25].into_iter().try_fold(panel, |panel: Panel, part| {
            let right = portrait(p, -1.0, part * lift(p, 1.0), 1e3 / growth)?;
            let (x, y) = *right.last().unwrap_or(&(0.0, 0.0));
            let left: Vec<_> = right.iter().map(|(x, v)| (-x, -v)).collect();
            let curve = |points| Curve::new(points, Ink::Body).arrow(0.3);
            Ok::<_, kit::Error>(panel.curve(curve(right)).curve(curve(left))
                .ring(x, y, Ink::Body, "", Side::Above)
                .ring(-x, -y, Ink::Body, "", Side::Above))
        })?
    };

    /// Tops apart: the plank at the start, faintly, where it has lost the left roller, its middle above the
    /// right one, and tipped by a quarter of a radian, its right end down.
    tipping: {
        let ride = released(p, -1.0, 1e3 * span(p))?;
        let (a, end) = (p.distance, ride.end_time());
        let place = |t| Ok::<_, kit::Error>(ride.at(t)?.q);
        let (start, edge) = (place(0.0)?, place(caught(p, -1.0)[2].min(end))?);
        let sketch = Sketch::within((-1.3 * a, 1.9 * a), (-0.45 * a, 0.45 * a));
        let before = sketch.ghost(|sketch| drawn(drawn(sketch, p, 0.0, start), p, 0.0, edge));
        drawn(before, p, 0.0, place(end)?)
    };

    /// Velocity against time. As the rollers hold the plank, it has flat pieces with sharp ends; by the smooth
    /// law it sinks below them, leaves late, and falls behind.
    smooth: {
        let (end, (_, round)) = (span(p), cycle(p));
        let (ride, ode) = (released(p, 1.0, end)?, smoothed(p, 0.1 * p.runs()));
        let end = ride.end_time();
        let smooth = Dop853::new(1e-9)?.solve(&ode, 0.0, &[p.offset, 0.0], end, &[])?;
        let held = |t| Ok(ride.at(t)?.v[0]);
        let speeds = Curve::sampled(times(0.0, end, 600), held, Ink::Body)?;
        let wrong = Curve::sampled(times(0.0, end, 600), |t| Ok(smooth.at(t)?[1]), Ink::Velocity)?.dashed();
        Panel::over_axes("$t$ / s", Axis::linear("$v$ / (m/s)").range(-1.2 * p.runs(), 1.5 * p.runs()))
            .curve(wrong.label_at("wrong: smooth", 1.05 * round, 1.1 * p.runs(), Side::Above))
            .curve(speeds.label_at("held", 0.62 * round, 0.3 * p.runs(), Side::Left))
    };
}

/// How long the picture moves, and the motion.
fn ride(p: &Parameters) -> Result<(f64, f64, Ride)> {
    let sense = if p.sense == "in" { 1.0 } else { -1.0 } * p.speed.signum();
    let ride = released(p, sense, if sense > 0.0 { span(p) } else { 1e3 * span(p) })?;
    Ok((sense, ride.end_time(), ride))
}

pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns = "t [s], x [m], v [m/s], tilt [rad], N_left/mg, N_right/mg, F_left/mg, F_right/mg";
    let (_, end, ride) = ride(p)?;
    Trajectory::sampled(columns.split(", "), times(0.0, end, 400), |t| {
        let (MechanismState { q, v }, [left, right]) = (ride.at(t)?, ride.forces(t)?);
        let forces = [left.normal, right.normal, left.tangential, right.tangential];
        let forces = forces.map(|force| force / p.gravity);
        Ok([&[t, q[0], v[0], q[2]][..], &forces].concat())
    })
}

/// The plank on its rollers with the forces that act on it; below, where its middle is.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (sense, end, ride) = ride(p)?;
    let (p, a) = (p.clone(), p.distance);
    let x = Curve::sampled(times(0.0, end, 400), |t| Ok(ride.at(t)?.q[0]), Ink::Body)?;
    let graph = Panel::over_axes("$t$ / s", "$x$ / m").curve(x);
    let first = ride.events().first().map_or(0.3 * end, |event| event.t);
    let stills = [0.0, (0.9 * first + 0.1 * end).min(end), 0.3 * end];
    MovingPicture::above(graph, 0.0..=end, stills, move |t| {
        let (q, forces, modes) = (ride.at(t)?.q, ride.forces(t)?, ride.modes(t)?);
        let (s, c) = sincos(q[2]);
        let sketch = Sketch::within((-1.75 * a, 1.75 * a), (-0.62 * a, 0.65 * a));
        let mut sketch = drawn(sketch, &p, sense * p.runs() * t / (RADIUS * a), q);
        let mut said = String::new();
        for (i, (side, name)) in [(-1.0, "left"), (1.0, "right")].into_iter().enumerate() {
            let words = [Side::Left, Side::Right][i];
            let [push, rub] = [forces[i].normal, forces[i].tangential].map(|f| f / p.gravity);
            let at = (0.5 * side * a - RADIUS * a * s, RADIUS * a * (c - 1.0));
            let does = match modes[i] {
                Mode::Stick => "holds",
                Mode::Open => "is off",
                _ => "slips",
            };
            said += &format!(", the {name} roller {does}");
            sketch = sketch
                .vector(at, (-s * push, c * push), 50.0, Ink::Force, "")
                .vector(at, (c * rub, s * rub), 200.0, Ink::Force, "")
                .text((0.7 * side * a, -RADIUS * a), does, Ink::Frame, words);
        }
        let alt = format!(
            "The plank after {t:.1} s with the forces of the rollers and its weight: its middle \
             {:.2} m to the right{said}. Below, that place against time.",
            q[0]
        );
        let weight = sketch.vector((q[0], q[1]), (0.0, -1.0), 50.0, Ink::Force, "");
        Ok((alt, weight))
    })
}
