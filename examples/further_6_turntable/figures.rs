//! The drawings of the ball on the turntable; from above, with the axis in the middle, in m.

use super::*;
use kit::draw::Camera;
use rolling::Touch;
use rotation_dynamics::integrators::{newton, place_and_velocity, size_or};
use rotation_dynamics::planar::Run;

/// A table seen from above, with its axis.
fn above(edge: f64) -> Sketch {
    let rim = times(0.0, 2.0 * PI, 120).map(|a| (edge * cos(a), edge * sin(a)));
    let spin = times(1.15, 1.75, 20).map(|a| (0.93 * edge * cos(a), 0.93 * edge * sin(a)));
    Sketch::within((-1.12 * edge, 1.12 * edge), (-1.05 * edge, 1.05 * edge))
        .curve(Curve::new(rim, Ink::Frame).thin())
        .dot((0.0, 0.0), Ink::Frame, "", Side::Above)
        .arrow_along(spin, Ink::Velocity)
        .text((0.0, 0.9 * edge), r"$\Omega$", Ink::Velocity, Side::Below)
}

/// The way of the middle of the ball.
fn path(run: &Run<Touch, 13>, count: u32) -> Result<Vec<(f64, f64)>> {
    sampled(times(0.0, run.end_time(), count), |t| {
        let place = at(run, t)?.place;
        Ok((place.x(), place.y()))
    })
}

figures! { p: &Parameters, usual = Parameters::default(), ball = on_table(&usual).0, nu = share(usual.shape) * usual.rate;
    /// A round table turns about an upright axis through its middle with the angular velocity Omega. A ball of radius a rolls
    /// on it with the velocity v.
    setup: {
        let (up, ball) = (SpaceVector::new(0.0, 0.0, 1.0), SpaceVector::new(0.25, 0.5, 0.14));
        let ring = times(0.4, 2.2, 30).map(|a| SpaceVector::new(0.16 * cos(a), 0.16 * sin(a), 0.5));
        View::of(SpaceVector::new(0.0, 0.0, 0.2), 1.06)
            .solid(Solid::disc(SpaceVector::new(0.0, 0.0, -0.04), up, 1.0, 0.08), Ink::Frame)
            .solid(Solid::ball(ball, 0.14), Ink::Body)
            .arrow(SpaceVector::zero(), up * 0.75, Ink::Velocity, r"$\Omega$", Side::Left)
            .turn(ring, Ink::Velocity)
            .arrow(ball, ball + SpaceVector::new(0.1, 0.5, 0.0), Ink::Body, "$v$", Side::Below)
            .text(ball + up * 0.14, "$a$, $m$", Ink::Body, Side::Above)
    };

    /// From above: a table that turns to the left. A ball thrown from the right runs round a small circle beside the axis. One
    /// that lay still on the table and is let go runs round a large circle about a point on the other side of the axis, nearly
    /// to the rim. One put down without spin runs round a circle about the axis.
    circles: {
        let turn = |start: Moving| path(&ball.run(&start, 2.0 * PI / nu, 1e-10)?, 200);
        let lying = thrown(&ball, [0.04, 0.0], [0.0, 0.4]);
        above(0.3)
            .curve(Curve::new(turn(thrown(&ball, [0.22, 0.0], [0.0, 0.15]))?, Ink::Body).arrow(0.2))
            .curve(Curve::new(turn(lying)?, Ink::Body).arrow(0.35))
            .curve(Curve::new(turn(dead(&ball, [0.0, -0.1]))?, Ink::Body).dashed().arrow(0.3))
            .dot((0.22 - 0.15 / nu, 0.0), Ink::Body, "", Side::Above)
            .dot((-0.1, 0.0), Ink::Body, "", Side::Above)
            .text((0.17, 0.055), "thrown", Ink::Body, Side::Above)
            .text((-0.15, 0.13), "let go", Ink::Body, Side::Above)
            .text((0.03, -0.11), "put down", Ink::Body, Side::BelowRight)
    };

    /// Rate of the circle over that of the table, against k: it rises from zero, ever more slowly, to one half at k = 1. The
    /// simulated dots lie on the line.
    rates: {
        let simulated = |shape| {
            let (ball, start) = on_table(&usual.but(|p| p.shape = shape));
            Ok(0.2 * PI / turning(ball, &start, 2, 1e-10)?.0.t)
        };
        Sweep::over("$k$", 0.0, 1.0).at([0.05, 0.2, 0.4, 2.0 / 3.0, 0.85])
            .exact_and_simulated(Axis::linear(r"$\nu/\Omega$").range(0.0, 0.6), share, simulated)?
    };

    /// From above: a table whose right side is low. The ball runs in loops that move up the picture, across the slope; the dots
    /// of a charge in crossed fields lie on its path.
    drift: {
        let p = usual.but(|p| p.tilt = 0.015);
        let (sloping, end) = (tilted(ball, &p), 5.9 * PI / nu);
        let start = thrown(&ball, [0.08, -0.16], [0.0, 0.2]);
        let along = p.gravity * sin(p.tilt) / 1.4;
        // The field B points downward, and q E/m is along x.
        let fields = newton(move |_, [_, v]| SpaceVector::new(along - nu * v.y(), nu * v.x(), 0.0)).scaled(size_or([1.0; 6]));
        let charge = [0.08, -0.16, 0.0, 0.0, 0.2, 0.0];
        let dots = sampled(times(0.0, end, 24), |t| {
            let [r, _] = place_and_velocity(&after(t, &fields, &charge, 1e-11)?);
            Ok((r.x(), r.y()))
        })?;
        above(0.3)
            .curve(Curve::new(path(&sloping.run(&start, end, 1e-10)?, 300)?, Ink::Body).arrow(0.93))
            .curve(Curve::new(dots, Ink::Ink).dots())
            .arrow((0.14, 0.12), (0.24, 0.12), Ink::Force, "", Side::Below)
            .text((0.19, 0.11), "downhill", Ink::Force, Side::Below)
    };

    /// From above: a ball that loses by rolling. Its path is a spiral that begins as a small circle beside the axis and ends as
    /// a large one about it; near the rim the ball slips and its path becomes straighter. A dashed curve is the way of the
    /// middle of the circle: it runs in to the axis.
    spiral: {
        let lossy = Ball { loss: 0.15, ..ball };
        let run = lossy.run(&thrown(&ball, [0.15, 0.0], [0.0, 0.13]), 1e3, 1e-10)?;
        let middle = sampled(times(0.0, run.end_time(), 200), |t| {
            let c = centre(&lossy, &at(&run, t)?);
            Ok((c.x(), c.y()))
        })?;
        let from = middle.first().copied().unwrap_or_default();
        above(0.3)
            .curve(Curve::new(path(&run, 600)?, Ink::Body).thin())
            .curve(Curve::new(middle, Ink::Ink).dashed())
            .dot((0.15, 0.0), Ink::Body, "", Side::Right)
            .dot(from, Ink::Ink, "$C$", Side::Below)
    };

    /// A ball of radius a inside an upright cylinder, with its middle at the distance b from the axis, runs around with the
    /// angular velocity W and touches the wall.
    cylinder: {
        let ((b, a), up) = ((0.6, 0.32), SpaceVector::new(0.0, 0.0, 1.0));
        let on = |r: f64, angle: f64, z: f64| SpaceVector::new(r * cos(angle), r * sin(angle), z);
        let ring = |z: f64| times(0.0, 2.0 * PI, 80).map(move |angle| on(b + a, angle, z));
        let side = |angle: f64| [0.75, -0.75].map(|z| on(b + a, angle, z));
        let ball = on(b, 2.1, 0.05);
        View::of(SpaceVector::zero(), 0.6 * 1.5 + 0.3 * b)
            .line(ring(0.75), Ink::Ink)
            .line(ring(-0.75), Ink::Frame)
            .line(side(0.6 + 0.5 * PI), Ink::Ink)
            .line(side(0.6 - 0.5 * PI), Ink::Ink)
            .dashed([up * -0.9, up * 0.9], Ink::Frame)
            .solid(Solid::ball(ball, a), Ink::Body)
            .dashed([up * 0.05, ball], Ink::Frame)
            .text(ball * 0.22 + up * 0.04, "$b$", Ink::Frame, Side::Below)
            .turn(times(-0.7, 1.0, 20).map(|angle| on(b, angle, -0.75)), Ink::Velocity)
            .text(on(b, 0.3, -0.75), "$W$", Ink::Velocity, Side::Above)
    };

    /// Height against turns about the axis. With enough friction the ball goes down and up and comes back to its first height,
    /// again and again, once in nearly two turns. With two thirds of the friction that this needs it sinks to more than twice
    /// the depth and stays near there. Dotted: a fall.
    heights: {
        let let_in = p.but(|p| p.drop = 0.0);
        let ((ball, start), need) = (in_hole(&let_in, 0.0)?, bobbing(&let_in));
        let push = p.orbit * p.orbit * (p.hole - p.golf) / p.gravity;
        let (turns, end) = (2.0 * PI / p.orbit.abs(), 8.0 * PI / p.orbit.abs());
        let height = |part: f64| {
            let run = Ball { mu: part * need.friction / push, ..ball }.run(&start, end, 1e-10)?;
            sampled(times(0.0, end, 240), |t| Ok((t / turns, 1e3 * at(&run, t)?.place.z())))
        };
        let exact = |x: f64| 1e3 * (need.middle + need.amplitude * cos(need.rate * x * turns));
        let slipping = height(0.67)?;
        let floor = slipping.iter().fold(0.0_f64, |low, (_, z)| low.min(*z));
        let dots = height(1.01)?.into_iter().step_by(12);
        let fall = Curve::of(times(0.0, 1.2, 60), |x| -500.0 * p.gravity * (x * turns) * (x * turns), Ink::Frame);
        Panel::over_axes(Axis::linear("turns").range(0.0, 4.0), Axis::linear("height / mm").range(1.1 * floor, 0.0))
            .curve(fall.dotted())
            .curve(Curve::of(times(0.0, 4.0, 240), exact, Ink::Ink))
            .curve(Curve::new(dots, Ink::Body).dots())
            .curve(Curve::new(slipping, Ink::Body).dashed().label("slips"))
    };
}

/// A turn of the circle.
fn motion(p: &Parameters) -> Result<(Ball, Run<Touch, 13>)> {
    let (ball, start) = on_table(p);
    let end = 2.0 * PI / (share(p.shape) * p.rate).abs();
    Ok((ball, ball.run(&start, end, p.tolerance)?))
}

/// That motion, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (_, run) = motion(p)?;
    let columns = "t [s], x [m], y [m], vx [m/s], vy [m/s], wx [rad/s], wy [rad/s], wz [rad/s], q0, q1, q2, q3";
    Trajectory::sampled(columns.split(", "), times(0.0, run.end_time(), 300), |t| {
        let [x, y, _, vx, vy, _, wx, wy, wz, q0, q1, q2, q3] = run.at(t)?.1;
        Ok([t, x, y, vx, vy, wx, wy, wz, q0, q1, q2, q3])
    })
}

/// The ball on its circle, with its axis e3 and the friction; below, the places of ball and mark.
#[rustfmt::skip]
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let ((ball, run), a, edge, up) = (motion(p)?, p.radius, p.table, SpaceVector::new(0.0, 0.0, 1.0));
    let (end, rate, mark) = (run.end_time(), p.rate, p.place);
    let span = || times(0.0, end, 300);
    let graph = Panel::over_axes("$t$ / s", "$x$ / m")
        .curve(Curve::sampled(span(), |t| Ok(at(&run, t)?.place.x()), Ink::Body)?.label("ball"))
        .curve(Curve::of(span(), |t| mark * cos(rate * t - 0.9), Ink::Frame).dashed());
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.22 * end, 0.55 * end], move |t| {
        let on = |x: f64, y: f64| SpaceVector::new(x, y, 0.002 * edge);
        let under = |ball: &Moving| on(ball.place.x(), ball.place.y());
        let been = sampled(times(0.0, t, 80), |t| Ok(under(&at(&run, t)?)))?;
        let turned = |r: f64| on(r * cos(rate * t - 0.9), r * sin(rate * t - 0.9));
        let now = at(&run, t)?;
        let (_, friction) = ball.forces(&now);
        let foot = under(&now) + up * (0.3 * a);
        let pull = friction * (0.35 * edge / friction.norm().max(1e-300));
        let tip = now.place + now.attitude()?.axis() * (2.2 * a);
        let alt = format!(
            "After {t:.2} s: the table with a chalk mark that has turned by {:.0} degrees, and the ball that has run \
             {:.0} degrees of its circle. The friction points to the middle of the circle. Below, the places of ball \
             and mark along x against time: the mark swings several times while the ball does once.",
            (rate * t).abs().to_degrees(), 360.0 * t / end
        );
        let scene = View::of(SpaceVector::zero(), 1.06 * edge)
            .camera(Camera::new(-1.2, 0.85))
            .solid(Solid::disc(up * (-0.03 * edge), up, edge, 0.06 * edge), Ink::Frame)
            .line([turned(0.93 * edge), turned(0.0)], Ink::Frame)
            .dot(turned(mark), Ink::Frame, "", Side::Above)
            .dashed(been, Ink::Body)
            .solid(Solid::ball(now.place, a), Ink::Body)
            .arrow(now.place, tip, Ink::Body, "", Side::Above)
            .arrow(foot, foot + pull, Ink::Force, "$F$", Side::Above);
        Ok((alt, scene))
    })
}
