//! The drawings of exercise 15.8; lengths in r0, speeds in u.

use super::*;
use rotation_dynamics::planar::contact::MechanismState;

/// The pull of the page, as the figures show it.
const PULL: f64 = 1.0 / 15.0;

/// The place at a time.
fn place(a: Answer, t: f64) -> (f64, f64) {
    let ((s, c), r) = (sincos(a.angle(t)), a.radius(t));
    (r * c, r * s)
}

/// Over the length of string that is left.
fn lengths() -> Sweep {
    Sweep::over("$r/r_0$", 0.25, 1.0).at([0.3, 0.4, 0.55, 0.7, 0.85])
}

/// What the simulation of the pull says, of energy and angular momentum, where this much of the
/// string is left.
fn pulled(of: impl Fn(f64, f64) -> f64) -> impl Fn(f64) -> Result<f64> {
    move |r| {
        let t = (1.0 - r) / PULL;
        let state = Pulled::new(PULL, 0.1, 1e-9, t)?.at(t)?;
        Ok(of(energy(&state), radius(&state) * across(&state)))
    }
}

/// The same for a post of a fiftieth of the radius, on which the string winds: this much of it is
/// free at last.
fn wound(of: impl Fn(f64, f64) -> f64) -> impl Fn(f64) -> Result<f64> {
    move |free| {
        let (post, start) = (0.02, [1.0, -0.02, 0.0, 0.0, 1.0, 0.0]);
        // The free part turns at 1/l and winds up at post/l.
        let end = 0.5 * (1.0 - free * free) / post;
        let [place, v] = place_and_velocity(&after(end, &on_post(post), &start, 1e-12)?);
        Ok(of(0.5 * v.dot(&v), place.x() * v.y() - place.y() * v.x()))
    }
}

figures! { _: &Parameters;
    /// A smooth table with a hole in its middle. A particle m circles about the hole on a string of the length
    /// r0 with the speed u; the string goes down through the hole, where a hand pulls it with the speed s.
    setup: {
        let at = |x: f64, y: f64, z: f64| SpaceVector::new(x, y, z);
        let circle = |from, to| times(from, to, 60).map(move |t| at(cos(t), sin(t), 0.0));
        let (o, m, low) = (SpaceVector::zero(), at(cos(-0.6), sin(-0.6), 0.0), at(0.0, 0.0, -0.75));
        View::of(at(0.0, 0.0, -0.25), 1.0)
            .size(340, 240)
            .ground(o, 1.3)
            .dashed(circle(0.0, TAU), Ink::Frame)
            .line([m, o], Ink::Ink)
            .dashed([o, low], Ink::Ink)
            .arrow(low, at(0.0, 0.0, -1.1), Ink::Ink, "$s$", Side::Right)
            .text(m * 0.5, "$r_0$", Ink::Ink, Side::Above)
            .ring(o, Ink::Ink, "hole", Side::Above)
            .arrow(m, m + at(-sin(-0.6), cos(-0.6), 0.0) * 0.55, Ink::Ink, "$u$", Side::Right)
            .dot(m, Ink::Body, "$m$", Side::Below)
    };

    /// Kinetic energy over that at the start against the length of string that is left. Through a hole it rises
    /// as one over the square of the length, to sixteen at a quarter. On a post it stays at one. Dots:
    /// simulated.
    energy: lengths().panel(Axis::linear("$K/K_0$").range(0.0, 16.0))
        .curve(lengths().exact(|r| 1.0 / (r * r) + PULL * PULL).label_at("hole", 0.4, 7.5, Side::Right))
        .curve(lengths().exact(|_| 1.0).label_at("post", 0.36, 1.0, Side::Above))
        .curve(lengths().simulated(pulled(|energy, _| 2.0 * energy))?)
        .curve(lengths().simulated(wound(|energy, _| 2.0 * energy))?);

    /// Angular momentum about the hole, or the post, over that at the start against the length of string that
    /// is left. Through a hole it stays at one, on a post it falls in proportion to the length. Dots:
    /// simulated.
    momentum: lengths().panel(Axis::linear("$L/L_0$").range(0.0, 1.2))
        .curve(lengths().exact(|_| 1.0).label_at("hole", 0.5, 1.0, Side::Above))
        .curve(lengths().exact(|r| r).label_at("post", 0.6, 0.6, Side::BelowRight))
        .curve(lengths().simulated(pulled(|_, momentum| momentum))?)
        .curve(lengths().simulated(wound(|_, momentum| momentum))?);

    /// A piece of the inward spiral of the particle. Its velocity leans a little inward from the direction at
    /// right angles to the string, and the pull of the string, towards the hole, makes with it an angle of less
    /// than a right angle.
    power: {
        let a = Answer { pull: 0.35 };
        let (o, m) = ((0.0, 0.0), place(a, 0.8));
        let (s, c) = sincos(a.angle(0.8));
        let (v, tip) = (a.across(0.8), |x: f64, y: f64| (m.0 + 0.42 * x, m.1 + 0.42 * y));
        let (corner, end) = (tip(-v * s, v * c), tip(-v * s - 0.35 * c, v * c - 0.35 * s));
        Sketch::within((-0.6, 1.25), (-0.25, 1.2))
            .guide(times(0.0, 1.55, 90).map(|t| place(a, t)))
            .string(m, o, "", Side::Above)
            .ring(o, Ink::Ink, "hole", Side::Below)
            .guide([m, corner])
            .guide([corner, end])
            .right_angle(m, o, corner)
            .arrow_to(m, end, Ink::Ink, "$v$", Side::Left)
            .text(tip(-0.55 * v * s, 0.55 * v * c), "$r_0u/r$", Ink::Ink, Side::Right)
            .text(corner, "$s$", Ink::Ink, Side::Above)
            .arrow_along([m, tip(-0.9 * c, -0.9 * s)], Ink::Force)
            .text(tip(-0.8 * c, -0.8 * s), "$F$", Ink::Force, Side::Below)
            .weight(m, 0.035, "$m$")
    };

    /// From the place where the pull ends the particle flies straight on and the string is slack. The flight is
    /// a chord of the circle with the radius r; where it meets the circle the string is taut again, and the
    /// particle goes on along the circle.
    stop: {
        let (a, end) = (Answer { pull: 0.5 }, 1.0);
        let (start, turned) = (a.angle(end), 2.0 * atan2(0.5, a.across(end)));
        let arc = |from, to| times(from, to, 60).map(|t| (0.5 * cos(t), 0.5 * sin(t)));
        let (from, to) = (place(a, end), (0.5 * cos(start + turned), 0.5 * sin(start + turned)));
        Sketch::within((-0.75, 0.85), (-0.62, 0.78))
            .guide(arc(0.0, TAU))
            .curve(Curve::new(times(end - 0.6, end, 90).map(|t| place(a, t)), Ink::Body))
            .curve(Curve::new([from, to], Ink::Body))
            .arrow_along(arc(start + turned, start + turned + 1.6), Ink::Body)
            .string(from, (0.0, 0.0), "$r$", Side::Above)
            .string(to, (0.0, 0.0), "", Side::Above)
            .dot(from, Ink::Body, "held", Side::Left)
            .dot(to, Ink::Body, "taut", Side::Below)
            .ring((0.0, 0.0), Ink::Ink, "", Side::Right)
    };
}

/// From half a unit before the pull to a while after it.
struct Whole {
    run: Pulled,
    held: Pulled, // what follows when the string is held
    end: f64,     // when it is
}

impl Whole {
    fn new(p: &Parameters) -> Result<Self> {
        let (a, end, hole) = scene(p)?;
        let (run, r) = (Pulled::new(a.pull, hole, p.tolerance, end)?, a.radius(end));
        let rest = (4.0 * r * a.pull / (a.pull * a.pull + 1.0 / (r * r))).max(TAU * r * r);
        let held = Pulled::held(run.at(end)?, p.tolerance, rest)?;
        Ok(Self { run, held, end })
    }

    /// The state and the tension.
    fn at(&self, t: f64) -> Result<(MechanismState<3>, f64)> {
        let (run, t) = if t > self.end { (&self.held, t - self.end) } else { (&self.run, t) };
        Ok((run.at(t)?, run.tension(t)?))
    }
}

/// That motion for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (whole, u, sense) = (Whole::new(p)?, p.speed.abs(), p.speed.signum());
    let (unit, last) = (p.radius / u, whole.end + whole.held.end());
    let columns = "t [s], x [m], y [m], vx [m/s], vy [m/s], F [N]";
    Trajectory::sampled(columns.split(", "), times(-0.5, last, 600), |t| {
        let (MechanismState { q, v }, force) = whole.at(t)?;
        let ([x, y, _], [vx, vy, _]) = (q.map(|x| x * p.radius), v.map(|v| v * u));
        Ok([t * unit, x, sense * y, vx, sense * vy, force * (p.mass * u / unit)])
    })
}

/// That motion, with the pull of the string.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (whole, unit, clockwise) = (Whole::new(p)?, p.radius / p.speed.abs(), p.speed < 0.0);
    let (end, last) = (whole.end, whole.end + whole.held.end());
    let (most, taut) = (whole.at(end)?.1, whole.held.motion.event("knot touches")?.t);
    let newton = p.mass * p.speed.abs() / unit;
    // The force falls to nothing and comes back at once.
    let instants = times(-0.5, end, 200).chain(times(end + 1e-9, end + taut, 2));
    let instants = instants.chain(times(end + taut + 1e-9, last, 20));
    let force = sampled(instants, |t| Ok((t * unit, newton * whole.at(t)?.1)))?;
    let newtons = Axis::linear("$F$ / N").range(0.0, 1.1 * newton * most);
    let graph = Panel::over_axes("$t$ / s", newtons).curve(Curve::new(force, Ink::Force));
    let stills = [0.02, 0.9 * end, end + 0.5 * taut].map(|t| t * unit);
    MovingPicture::above(graph, -0.5 * unit..=last * unit, stills, move |t| {
        let now = (t / unit).min(last);
        let (MechanismState { q: [x, y, _], v: [vx, vy, _] }, force) = whole.at(now)?;
        let place = |t: f64| whole.at(t).map(|(state, _)| (state.q[0], state.q[1]));
        let path = sampled(times(-0.5, now, 400), place)?;
        let (since, what) = match now > end {
            true => ((now - end) * unit, "after the hand has stopped"),
            false => (now * unit, "after the beginning of the pull"),
        };
        let alt = format!(
            "The particle {since:.2} s {what}, with its path, its velocity and {}; below, the pull of the \
             string against time: it grows, and is nothing while the string is slack.",
            if force > 0.0 { "the pull of the string" } else { "the slack string" }
        );
        let (pull, hole) = (0.3 * force / most / hypot(x, y), (0.0, 0.0));
        let slack = [(x, y), (0.5 * x + 0.08 * y, 0.5 * y - 0.08 * x), hole];
        let pulled = [(x, y), (x - pull * x, y - pull * y)];
        let scene = Sketch::within((-1.35, 1.35), (-1.1, 1.15))
            .guide(path)
            .only_if(force > 0.0, |s| s.string((x, y), hole, "", Side::Above))
            .only_if(force <= 0.0, |s| s.guide(slack))
            .ring(hole, Ink::Ink, "", Side::Below)
            .arrow_along([(x, y), (x + 0.2 * vx, y + 0.2 * vy)], Ink::Ink)
            .weight((x, y), 0.045, "")
            .only_if(force > 0.0, |s| s.arrow_along(pulled, Ink::Force));
        Ok((alt, scene.mirrored_if(clockwise)))
    })
}
