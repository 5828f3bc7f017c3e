//! The drawings of exercise 15.9; lengths in l.

use super::*;
use rotation_dynamics::planar::contact::MechanismState;

/// A dumbbell with its masses here, in l; `radius` is theirs.
fn dumbbell(sketch: Sketch, [lower, upper]: [Plane; 2], radius: f64) -> Sketch {
    let [lower, upper] = [lower, upper].map(|[x, y]| (x, y));
    sketch.string(lower, upper, "", Side::Right).disc(lower, radius, Ink::Body, 0.6).disc(
        upper,
        radius,
        Ink::Body,
        0.2,
    )
}

fn ball(sketch: Sketch, [x, y]: Plane, radius: f64) -> Sketch {
    sketch.disc((x, y), radius, Ink::Ink, 0.8)
}

/// After the elastic hit of small masses, when the stick has turned by this.
fn elastic(angle: f64) -> [Plane; 3] {
    cycloids(Answer::new(1.0, 0.0), 0.0, angle)
}

/// The path of one of the three, from angle to angle.
fn path(k: usize, to: f64) -> impl Iterator<Item = (f64, f64)> {
    times(0.0, to, 120).map(move |angle| elastic(angle)[k].into())
}

/// Over the coefficient of restitution.
fn restitutions() -> Sweep {
    Sweep::over("$e$", 0.1, 1.0).at([0.15, 0.3, 0.45, 0.5, 0.55, 0.7, 0.85, 1.0])
}

/// How near a ball of this coefficient comes to the other mass, both very small, simulated.
fn nearest_simulated(restitution: f64) -> Result<f64> {
    let omega = Answer::new(restitution, 0.0).angular_velocity;
    let run = Blow::new(Hit::across(restitution, 4e-3), 1e-9, 4.5 / omega)?;
    Ok(run.nearest(1.0 / omega, 4.5 / omega))
}

figures! { p: &Parameters;
    /// Seen from above: a dumbbell of two masses m/2 at the ends of a stick of the length l lies upright in the
    /// picture. A ball of the mass m comes from the left with the velocity v0 towards the lower mass.
    setup: {
        let sketch = Sketch::within((-1.15, 0.6), (-0.25, 1.2));
        let sketch = ball(dumbbell(sketch, [[0.0, 0.0], [0.0, 1.0]], 0.07), [-0.75, 0.0], 0.07);
        sketch
            .text((-0.75, 0.08), "$m$", Ink::Ink, Side::Above)
            .arrow_along([(-0.66, 0.0), (-0.25, 0.0)], Ink::Ink)
            .text((-0.3, 0.0), "$v_0$", Ink::Ink, Side::Below)
            .text((0.08, 0.0), "$m/2$", Ink::Body, Side::Right)
            .text((0.08, 1.0), "$m/2$", Ink::Body, Side::Right)
            .dimension((-0.2, 0.0), (-0.2, 1.0), "$l$", Side::Left)
    };

    /// Just after the hit: the lower mass moves to the right at four thirds of v0, the middle of the stick at
    /// two thirds, the upper mass rests, and the ball follows at one third. The tips of the arrows of the
    /// dumbbell lie on a straight line through the upper mass.
    velocities: {
        let tip = |v: f64, y: f64| (0.6 * v, y);
        let ends = Curve::new([tip(4.0 / 3.0, 0.0), (0.0, 1.0)], Ink::Frame).thin().dashed();
        let sketch = Sketch::within((-0.7, 1.25), (-0.3, 1.2)).curve(ends);
        let sketch = ball(dumbbell(sketch, [[0.0, 0.0], [0.0, 1.0]], 0.07), [-0.14, 0.0], 0.07);
        sketch
            .arrow_to((0.08, 0.0), tip(4.0 / 3.0, 0.0), Ink::Ink, "$4v_0/3$", Side::Right)
            .arrow_to((0.0, 0.5), tip(2.0 / 3.0, 0.5), Ink::Ink, "$2v_0/3$", Side::Right)
            .arrow_to((-0.14, -0.14), (0.06, -0.14), Ink::Ink, "$v_0/3$", Side::Right)
            .text((0.08, 1.0), "at rest", Ink::Ink, Side::Right)
            .text((-0.22, 0.0), "ball", Ink::Ink, Side::Left)
            .turn((0.0, 0.5), 0.3, (2.0, 4.1), Ink::Velocity)
            .text((-0.3, 0.5), r"$\Omega$", Ink::Velocity, Side::Left)
    };

    /// A turn of the dumbbell. Each mass describes a cycloid with its cusps on the line through the place of
    /// the upper one; the middle of the stick runs straight. Faint: the dumbbell and the ball at three later
    /// times. The ball is always behind the middle of the stick.
    paths: {
        let sketch = Sketch::within((-0.3, 3.55), (-0.25, 1.25))
            .curve(Curve::new([(-0.2, 1.0), (3.45, 1.0)], Ink::Frame).thin())
            .guide([(0.0, 0.5), (3.45, 0.5)])
            .curve(Curve::new(path(1, 1.08 * TAU), Ink::Body))
            .curve(Curve::new(path(2, 1.08 * TAU), Ink::Body).dashed())
            .curve(Curve::new(path(0, 1.08 * TAU), Ink::Ink).dotted());
        let sketch = [1.95, PI, 5.3].into_iter().fold(sketch, |sketch, angle| {
            let [at, lower, upper] = elastic(angle);
            sketch.ghost(|sketch| ball(dumbbell(sketch, [lower, upper], 0.06), at, 0.05))
        });
        ball(dumbbell(sketch, [[0.0, 0.0], [0.0, 1.0]], 0.06), [0.0, 0.0], 0.05)
    };

    /// Distance of the ball from each mass in the first turn and a half. From the struck mass it grows, with a
    /// dip. To the other it falls from one to less than a third after a third of a turn, and grows again.
    clear: {
        let distance = |k: usize| move |turns: f64| {
            let all = elastic(TAU * turns);
            hypot(all[k][0] - all[0][0], all[k][1] - all[0][1])
        };
        Panel::over_axes(r"turns", Axis::linear("distance$/l$").range(0.0, 2.5))
            .curve(Curve::of(times(0.0, 1.4, 200), distance(1), Ink::Body).label_at("struck mass", 0.3, 1.2, Side::AboveLeft))
            .curve(Curve::of(times(0.0, 1.4, 200), distance(2), Ink::Body).dashed().label_at("other mass", 0.9, 1.93, Side::Above))
    };

    /// The least distance of the ball from the other mass against the coefficient of restitution, for small
    /// masses: it falls to zero at one half and rises again on either side. Dots: simulated.
    again: {
        let near = |e: f64| least(|x| to_upper(Answer::new(e, 0.0), 0.0, x), 1.0, 4.5);
        restitutions().panel(Axis::linear("least distance$/l$").range(0.0, 1.2))
            .curve(restitutions().exact(near))
            .curve(restitutions().simulated(nearest_simulated)?.label("simulated"))
    };

    /// The hit and what follows if half of the relative velocity is returned. Ball and middle of the stick run
    /// level; the other mass comes round from behind and hits the ball, which then runs ahead, while the
    /// dumbbell goes on slower.
    second: {
        let reach = scene(p)?.reach.min(0.4);
        let (run, radius) = (halved(reach, 1e-9)?, 0.5 * reach);
        // Here the stick turns at v0/l.
        let (met, last) = (second(reach), 4.1);
        let trace = |k: usize| sampled(times(-0.5, last, 200), |t| {
            let q = run.at(t)?.q;
            Ok([[q[3], q[4]], places(&q)[0], places(&q)[1]][k].into())
        });
        let sketch = Sketch::within((-0.65, 3.2), (-0.45, 1.25))
            .curve(Curve::new(trace(0)?, Ink::Ink).dotted())
            .curve(Curve::new(trace(1)?, Ink::Body).thin())
            .curve(Curve::new(trace(2)?, Ink::Body).dashed());
        let at = |sketch: Sketch, t: f64| -> Result<Sketch> {
            let q = run.at(t)?.q;
            Ok(ball(dumbbell(sketch, places(&q), radius), [q[3], q[4]], radius))
        };
        let sketch = at(at(sketch, 0.0)?, met)?;
        let q = run.at(last)?.q;
        sketch.ghost(|sketch| ball(dumbbell(sketch, places(&q), radius), [q[3], q[4]], radius))
    };
}

/// From when to when the pictures show the motion, in l/v0.
fn span(p: &Parameters) -> (f64, f64) {
    let omega = Answer::new(p.restitution, p.slant).angular_velocity;
    (-0.6, TAU / omega.max(0.5))
}

/// The motion, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let ((from, to), l, unit) = (span(p), p.length, p.length / p.speed.abs());
    let sense = p.speed.signum();
    let run = Blow::new(scene(p)?, p.tolerance, to)?;
    let columns = "t [s], x_ball [m], y_ball [m], x_cm [m], y_cm [m], angle [rad], omega [rad/s]";
    Trajectory::sampled(columns.split(", "), times(from, to, 500), |t| {
        let MechanismState { q, v } = run.at(t)?;
        let [x, angle, u, omega] = [l * q[0], q[2], l * q[3], v[2] / unit].map(|odd| sense * odd);
        Ok([t * unit, u, l * q[4], x, l * q[1], angle, omega])
    })
}

/// The hit and a turn, with the speeds of the three.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (from, to) = span(p);
    let run = Blow::new(scene(p)?, p.tolerance, to)?;
    let (v0, l, mirrored) = (p.speed.abs(), p.length, p.speed < 0.0);
    let unit = l / v0;
    let curve = |k: usize, ink: Ink, name: &str| {
        let speed = |t: f64| {
            let state = if t == 0.0 { run.after } else { run.at(t)? };
            let [lower, upper] = velocities(&state);
            let [x, y] = [[state.v[3], state.v[4]], lower, upper][k];
            Ok((t * unit, v0 * hypot(x, y)))
        };
        let all = times(from, -1e-9, 2).chain(times(0.0, to, 160));
        Ok::<_, kit::Error>(Curve::new(sampled(all, speed)?, ink).label_end(name))
    };
    let speeds = Axis::linear("speed / (m/s)").range(0.0, 1.4 * v0);
    let graph = Panel::over_axes("$t$ / s", speeds)
        .curve(curve(0, Ink::Ink, "ball")?.dotted())
        .curve(curve(1, Ink::Body, "struck")?)
        .curve(curve(2, Ink::Body, "other")?.dashed());
    let (s, c) = sincos(p.slant);
    let far = to * run.after.v[0].max(run.after.v[1]);
    let (ball_radius, knob) = (p.ball / l, p.knob / l);
    let stills = [-0.5, 0.337 * to, 0.5 * to].map(|t| t * unit);
    let told = match p.slant == 0.0 && run.later().next().is_none() {
        true => {
            " Those of the masses rise and fall in turn, each down to zero; that of the ball stays."
        }
        false => "",
    };
    MovingPicture::above(graph, from * unit..=to * unit, stills, move |t| {
        let now = (t / unit).clamp(from, to);
        let q = run.at(now)?.q;
        let been = |k: usize| {
            let place = |t| Ok(places(&run.at(t)?.q)[k].into());
            let path = sampled(times(0.0, now.max(1e-9), 120), place)?;
            Ok::<_, kit::Error>(Curve::new(path, Ink::Body).thin())
        };
        let when = if now < 0.0 { "before" } else { "after" };
        let alt = format!(
            "Ball and dumbbell {:.2} s {when} the hit, with the paths of the two masses; below, the \
             speeds of the three against time.{told}",
            t.abs()
        );
        let across = (-0.8 * c - 0.35, far + 0.7);
        let sketch = Sketch::within(across, (-0.8 * s - 0.3, 1.3 + far * s));
        let sketch = sketch.curve(been(0)?).curve(been(1)?.dashed());
        let sketch = dumbbell(sketch, places(&q), knob);
        let sketch = ball(sketch, [q[3], q[4]], ball_radius);
        Ok((alt, sketch.mirrored_if(mirrored)))
    })
}
