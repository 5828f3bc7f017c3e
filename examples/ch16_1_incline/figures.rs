//! The drawings of section 16.1.

use super::*;
use models::wedge::Wedge;
use rotation_dynamics::math::sort_by_number;

/// Over the coefficient of friction, in units of what rolling needs.
fn frictions() -> Sweep {
    Sweep::over(r"$\mu/\mu_{min}$", 0.0, 2.0).at([0.1, 0.3, 0.5, 0.6, 0.7, 0.9, 1.2, 1.5, 1.8])
}

fn with(p: &Parameters, part: f64) -> Roller {
    let body = Roller::new(p);
    Roller { mu: part * body.needed(), ..body }
}

/// A slope that is neither flat nor steep, whatever the parameters.
fn drawn(p: &Parameters) -> f64 {
    p.angle.clamp(0.25, 0.75)
}

figures! { p: &Parameters;
    /// A cylinder of radius R on a slope that rises to the right at the angle theta. x is counted
    /// up the slope, phi clockwise. The weight pulls down at the middle; at the point of contact
    /// the slope pushes at right angles to itself and, with the friction, up along itself.
    setup: {
        let (s, c) = sincos(drawn(p));
        let (foot, at) = ((0.0, 0.0), 0.95);
        let contact = (at * c, at * s);
        let middle = (contact.0 - 0.2 * s, contact.1 + 0.2 * c);
        let along = |from: (f64, f64), d: f64| (from.0 + d * c, from.1 + d * s);
        let from = (middle.0 - 0.14 * s, middle.1 + 0.14 * c);
        let push = (contact.0 - 0.52 * s, contact.1 + 0.52 * c);
        Sketch::within((-0.12, 1.6 * c + 0.1), (-0.14, 1.6 * s + 0.22))
            .incline(foot, 1.6, drawn(p))
            .angle(foot, 0.3, (0.0, drawn(p)), r"$\theta$")
            .disc(middle, 0.2, Ink::Body, 0.15)
            .dot(middle, Ink::Body, "", Side::Left)
            .turn(middle, 0.13, (2.6, 0.9), Ink::Velocity)
            .text((middle.0 + 0.1, middle.1 + 0.04), r"$\phi$", Ink::Velocity, Side::BelowRight)
            .arrow(along(from, 0.18), along(from, 0.5), Ink::Frame, "$x$", Side::Above)
            .arrow(middle, (middle.0, middle.1 - 0.42), Ink::Force, "", Side::Right)
            .text((middle.0, middle.1 - 0.40), "$mg$", Ink::Force, Side::Right)
            .arrow(contact, along(contact, 0.26), Ink::Force, "", Side::Right)
            .text((contact.0 + 0.26 * c - 0.1 * s, contact.1 + 0.26 * s + 0.1 * c), "$F$", Ink::Force, Side::Centre)
            .arrow(contact, push, Ink::Force, "", Side::Left)
            .text(push, "$N$", Ink::Force, Side::Left)
            .dot(contact, Ink::Ink, "", Side::Below)
    };

    /// Friction over what rolling needs, against the coefficient of friction over the least
    /// for rolling: up to one it rises along the diagonal, from there on it stays at one. The
    /// simulated dots lie on the line.
    friction: {
        let simulated = |part| -> Result<f64> {
            let body = with(p, part);
            let run = body.run(Goal::Never, p.speed, 0.1 * p.speed / p.gravity, 1e-9)?;
            let force = run.forces(run.end_time())?[0];
            Ok(force.tangential / (force.normal * body.needed()))
        };
        frictions().exact_and_simulated(Axis::linear("$F/F_{roll}$").range(0.0, 1.2), |x| x.min(1.0), simulated)?
    };

    /// Part of the energy that is lost on the way up and back, against the coefficient of
    /// friction over the least for rolling: nothing without friction, most at a place beyond the
    /// middle, nothing again from one on. The simulated dots lie on the line.
    lost: {
        let simulated = |part| Ok(1.0 - with(p, part).run_back(1e-10)?[1]);
        let most = p.shape / (1.0 + p.shape);
        let axis = Axis::linear("lost of the energy").range(0.0, 1.25 * most);
        frictions().exact_and_simulated(axis, |x| 1.0 - with(p, x).back()[1], simulated)?
    };

    /// Distance rolled against time from rest, for a block without friction, a ball, a cylinder
    /// and a hoop: four parabolas; the block is first, the hoop last.
    race: {
        let mut panel = Panel::over_axes("$t$ / s", Axis::linear("way down / m").range(0.0, 1.15));
        for (name, k, high, side) in [
            ("block", 0.0, 0.7, Side::Left), ("ball", 0.4, 1.0, Side::AboveLeft),
            ("cylinder", 0.5, 1.0, Side::AboveRight), ("hoop", 1.0, 0.4, Side::Right),
        ] {
            let body = gripping(p, k);
            let (a, last) = (-body.acceleration(), body.race(1.0, 1e-9)?[0]);
            let way = |t| Ok(-body.run(Goal::Never, 0.0, t, 1e-9)?.at(t)?.q[0]);
            let curve = Curve::of(times(0.0, last, 80), |t| 0.5 * a * t * t, Ink::Ink);
            panel = panel
                .curve(curve.label_at(name, (2.0 * high / a).sqrt(), high, side))
                .curve(Curve::sampled(times(0.2 * last, last, 4), way, Ink::Body)?.dots());
        }
        panel
    };

    /// Height above the slope, in radii, of a ball that is dropped, against time: arcs that get
    /// lower and shorter, five of them to be seen, and from a marked time on none. The simulated
    /// dots lie on the line.
    dropped: {
        let ball = Bouncer::new(p);
        let (limit, found) = (ball.rests(), ball.run(1e-9)?);
        let end = 1.4 * limit;
        let simulated = |t| Ok(found.at(t)?.q[1] / p.radius - 1.0);
        // With the touches among them, where the arcs meet.
        let touches = found.events().iter().map(|event| event.t);
        let mut line: Vec<f64> = times(0.0, end, 400).chain(touches).collect();
        line.retain(|t| *t <= end);
        sort_by_number(&mut line, |t| *t);
        Panel::over_axes("$t$ / s", Axis::linear("height / $R$").range(0.0, 1.15 * bouncer::HEIGHT))
            .upright(limit, Ink::Frame, "rests")
            .curve(Curve::of(line, |t| ball.height(t), Ink::Ink))
            .curve(Curve::sampled(times(0.0, end, 42), simulated, Ink::Body)?.dots())
    };
}

/// Up and back, as simulated, and how long it takes.
fn motion(p: &Parameters) -> Result<(Roll, f64)> {
    let body = Roller::new(p);
    let end = -2.0 * p.speed / body.acceleration();
    Ok((body.run(Goal::Never, p.speed, end, p.tolerance)?, end))
}

/// That motion, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (run, end) = motion(p)?;
    let columns = "t [s], x [m], phi [rad], vx [m/s], R phi' [m/s], friction [N], normal [N]";
    Trajectory::sampled(columns.split(", "), times(0.0, end, 200), |t| {
        let (MechanismState { q, v }, [force]) = (run.at(t)?, run.forces(t)?);
        let moving = [t, q[0], -q[2], v[0], -p.radius * v[2]];
        Ok([&moving[..], &[p.mass * force.tangential, p.mass * force.normal]].concat())
    })
}

/// The body on its way up and back, with its forces; below, velocity and friction.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (r, weight, v) = (p.radius, p.gravity, p.speed);
    let (run, end) = motion(p)?;
    let first = run.forces(0.0)?[0].tangential;
    let velocity = Curve::sampled(times(0.0, end, 80), |t| Ok(run.at(t)?.v[0] / v), Ink::Velocity)?;
    let friction = |t| Ok(if first > 0.0 { run.forces(t)?[0].tangential / first } else { 0.0 });
    let friction = Curve::sampled(times(0.0, end, 80), friction, Ink::Force)?;
    let graph = Panel::over_axes("$t$ / s", Axis::linear("over the first").range(-1.0, 1.25))
        .level(0.0, Ink::Frame, "")
        .curve(velocity.label_at(r"$\dot x$", 0.7 * end, -0.4, Side::AboveRight))
        .curve(friction.label_at("$F$", 0.7 * end, 1.0, Side::Below))
        .low();
    let length = -0.5 * v * v / Roller::new(p).acceleration() + 6.0 * r;
    let wedge = Wedge { angle: p.angle, length, radius: r };
    MovingPicture::above(graph, 0.0..=end, [0.08 * end, 0.5 * end, 0.92 * end], move |t| {
        let (MechanismState { q: [x, _, turn], v: [vx, ..] }, [force]) =
            (run.at(t)?, run.forces(t)?);
        let way = match vx / v {
            rate if rate > 0.01 => "on its way up",
            rate if rate < -0.01 => "on its way down",
            _ => "at rest for an instant at its highest place",
        };
        let alt = format!(
            "The body {t:.2} s after its start, {way}. Its weight pulls down, the slope pushes, and \
             the friction at the point of contact points up the slope. Below, velocity and friction."
        );
        let forces = [force.normal, force.tangential].map(|force| force / weight);
        let [up, off] = wedge.directions();
        let over = up * (x + 3.0 * r) + off * (2.35 * r);
        let velocity = up * (0.9 * wedge.force() * vx / v);
        let scene = wedge
            .with_body(x + 3.0 * r, turn, forces)
            .corner(&format!("{t:.2} s"))
            .only_if((vx / v).abs() > 0.06, |view| {
                view.vector(over, over + velocity, Ink::Velocity, r"$\dot x$", Side::Above)
            });
        Ok((alt, scene))
    })
}
