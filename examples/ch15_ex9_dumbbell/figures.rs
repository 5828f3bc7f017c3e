//! The drawings of exercise 15.9; lengths in l.

use super::*;
use rotation_dynamics::planar::contact::MechanismState;

/// Ball and dumbbell, in l, with these radii of the ball and of the masses.
fn drawn(sketch: Sketch, places: [Plane; 3], [ball, mass]: [f64; 2]) -> Sketch {
    let [at, lower, upper] = places.map(<(f64, f64)>::from);
    let sketch = sketch.string(lower, upper, "", Side::Right).disc(lower, mass, Ink::Body, 0.6);
    sketch.disc(upper, mass, Ink::Body, 0.2).disc(at, ball, Ink::Ink, 0.8)
}

/// After the elastic hit of small masses, when the stick has turned by this.
fn elastic(angle: f64) -> [Plane; 3] {
    cycloids(Answer::new(1.0, 0.0), 0.0, angle)
}

/// The simulated path of the ball, 0, or of one of the masses.
fn path(run: &Blow, k: usize, all: impl Iterator<Item = f64>, ink: Ink) -> Result<Curve> {
    Ok(Curve::new(sampled(all, |t| Ok(places(&run.at(t)?.q)[k].into()))?, ink))
}

figures! { p: &Parameters;
    /// Seen from above: a dumbbell of two masses m/2 at the ends of a stick of the length l lies upright in the
    /// picture. A ball of the mass m comes from the left with the velocity v0 towards the lower mass.
    setup: drawn(Sketch::within((-1.15, 0.6), (-0.25, 1.2)), [[-0.75, 0.0], [0.0, 0.0], [0.0, 1.0]], [0.07; 2])
        .text((-0.75, 0.08), "$m$", Ink::Ink, Side::Above)
        .arrow_along([(-0.66, 0.0), (-0.25, 0.0)], Ink::Ink).text((-0.3, 0.0), "$v_0$", Ink::Ink, Side::Below)
        .text((0.08, 0.0), "$m/2$", Ink::Body, Side::Right)
        .text((0.08, 1.0), "$m/2$", Ink::Body, Side::Right)
        .dimension((-0.2, 0.0), (-0.2, 1.0), "$l$", Side::Left);

    /// Just after the hit: the lower mass moves to the right at four thirds of v0, the middle of the stick at
    /// two thirds, the upper mass rests, and the ball follows at one third. The tips of the arrows of the
    /// dumbbell lie on a straight line through the upper mass.
    velocities: {
        let tip = |v: f64, y: f64| (0.6 * v, y);
        let ends = Curve::new([tip(4.0 / 3.0, 0.0), (0.0, 1.0)], Ink::Frame).thin().dashed();
        drawn(Sketch::within((-0.7, 1.25), (-0.3, 1.2)).curve(ends), [[-0.14, 0.0], [0.0, 0.0], [0.0, 1.0]], [0.07; 2])
            .arrow_to((0.08, 0.0), tip(4.0 / 3.0, 0.0), Ink::Ink, "$4v_0/3$", Side::Right)
            .arrow_to((0.0, 0.5), tip(2.0 / 3.0, 0.5), Ink::Ink, "$2v_0/3$", Side::Right)
            .arrow_to((-0.14, -0.14), (0.06, -0.14), Ink::Ink, "$v_0/3$", Side::Right)
            .text((0.08, 1.0), "at rest", Ink::Ink, Side::Right)
            .text((-0.22, 0.0), "ball", Ink::Ink, Side::Left)
            .turn((0.0, 0.5), 0.3, (2.0, 4.1), Ink::Velocity).text((-0.3, 0.5), r"$\Omega$", Ink::Velocity, Side::Left)
    };

    /// A turn of the dumbbell. Each mass describes a cycloid with its cusps on the line through the place of
    /// the upper one; the middle of the stick runs straight. Faint: the dumbbell and the ball at three later
    /// times. The ball is always behind the middle of the stick.
    paths: {
        let path = |k: usize, ink| Curve::new(times(0.0, 1.08 * TAU, 120).map(|angle| elastic(angle)[k].into()), ink);
        let sketch = Sketch::within((-0.3, 3.55), (-0.25, 1.25))
            .curve(Curve::new([(-0.2, 1.0), (3.45, 1.0)], Ink::Frame).thin())
            .guide([(0.0, 0.5), (3.45, 0.5)])
            .curve(path(1, Ink::Body))
            .curve(path(2, Ink::Body).dashed())
            .curve(path(0, Ink::Ink).dotted());
        let radii = [0.05, 0.06];
        let later = |sketch: Sketch, angle| sketch.ghost(|sketch| drawn(sketch, elastic(angle), radii));
        drawn([1.95, PI, 5.3].into_iter().fold(sketch, later), elastic(0.0), radii)
    };

    /// Distance of the ball from each mass in the first turn and a half. From the struck mass it grows, with a
    /// dip. To the other it falls from one to less than a third after a third of a turn, and grows again.
    clear: {
        let distance = |k: usize| {
            let apart = move |turns: f64| {
                let all = elastic(TAU * turns);
                hypot(all[k][0] - all[0][0], all[k][1] - all[0][1])
            };
            Curve::of(times(0.0, 1.4, 200), apart, Ink::Body)
        };
        Panel::over_axes(r"turns", Axis::linear("distance$/l$").range(0.0, 2.5))
            .curve(distance(1).label_at("struck mass", 0.3, 1.2, Side::AboveLeft))
            .curve(distance(2).dashed().label_at("other mass", 0.9, 1.93, Side::Above))
    };

    /// The least distance of the ball from the other mass against the coefficient of restitution, for small
    /// masses: it falls to zero at one half and rises again on either side. Dots: simulated.
    again: {
        let near = |e: f64| least(|x| to_upper(cycloids(Answer::new(e, 0.0), 0.0, x)), 1.0, 4.5);
        let simulated = |e: f64| {
            let omega = Answer::new(e, 0.0).angular_velocity;
            Ok(Blow::new(Hit::across(e, 4e-3), 1e-9, 4.5 / omega)?.nearest(1.0 / omega, 4.5 / omega))
        };
        Sweep::over("$e$", 0.1, 1.0)
            .at([0.15, 0.3, 0.45, 0.5, 0.55, 0.7, 0.85, 1.0])
            .exact_and_simulated(Axis::linear("least distance$/l$").range(0.0, 1.2), near, simulated)?
    };

    /// The hit and what follows if half of the relative velocity is returned. Ball and middle of the stick run
    /// level; the other mass comes round from behind and hits the ball, which then runs ahead, while the
    /// dumbbell goes on slower.
    second: {
        let reach = scene(p)?.reach.min(0.4);
        // Here the stick turns at v0/l.
        let (run, met, last) = (halved(reach, 1e-9)?, second(reach), 4.1);
        let all = || times(-0.5, last, 200);
        let at = |sketch: Sketch, t: f64| -> Result<Sketch> { Ok(drawn(sketch, places(&run.at(t)?.q), [0.5 * reach; 2])) };
        let sketch = Sketch::within((-0.65, 3.2), (-0.45, 1.25))
            .curve(path(&run, 0, all(), Ink::Ink)?.dotted())
            .curve(path(&run, 1, all(), Ink::Body)?.thin())
            .curve(path(&run, 2, all(), Ink::Body)?.dashed());
        let end = places(&run.at(last)?.q);
        at(at(sketch, 0.0)?, met)?.ghost(|sketch| drawn(sketch, end, [0.5 * reach; 2]))
    };
}

/// The motion, and from when to when the pictures show it, in l/v0.
fn shown(p: &Parameters) -> Result<(Blow, f64, f64)> {
    let omega = Answer::new(p.restitution, p.slant).angular_velocity;
    let to = TAU / omega.max(0.5);
    Ok((Blow::new(scene(p)?, p.tolerance, to)?, -0.6, to))
}

/// The motion, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let ((run, from, to), l, unit) = (shown(p)?, p.length, p.length / p.speed.abs());
    let sense = p.speed.signum();
    let columns = "t [s], x_ball [m], y_ball [m], x_cm [m], y_cm [m], angle [rad], omega [rad/s]";
    Trajectory::sampled(columns.split(", "), times(from, to, 500), |t| {
        let MechanismState { q, v } = run.at(t)?;
        let [x, angle, u, omega] = [l * q[0], q[2], l * q[3], v[2] / unit].map(|odd| sense * odd);
        Ok([t * unit, u, l * q[4], x, l * q[1], angle, omega])
    })
}

/// The hit and a turn, with the speeds of the three.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let ((run, from, to), l, v0) = (shown(p)?, p.length, p.speed.abs());
    let (unit, mirrored) = (l / v0, p.speed < 0.0);
    let curve = |k: usize, ink: Ink| {
        let speed = |t: f64| {
            let state = if t == 0.0 { run.after } else { run.at(t)? };
            let [x, y] = velocities(&state)[k];
            Ok((t * unit, v0 * hypot(x, y)))
        };
        let all = times(from, -1e-9, 2).chain(times(0.0, to, 160));
        sampled(all, speed).map(|speeds| Curve::new(speeds, ink))
    };
    let speeds = Axis::linear("speed / (m/s)").range(0.0, 1.4 * v0);
    let graph = Panel::over_axes("$t$ / s", speeds)
        .curve(curve(0, Ink::Ink)?.dotted().label_end("ball"))
        .curve(curve(1, Ink::Body)?.label_end("struck"))
        .curve(curve(2, Ink::Body)?.dashed().label_end("other"));
    let ((s, c), far) = (sincos(p.slant), to * run.after.v[0].max(run.after.v[1]));
    let radii = [p.ball / l, p.knob / l];
    let stills = [-0.5, 0.337 * to, 0.5 * to].map(|t| t * unit);
    let told = match p.slant == 0.0 && run.motion.events().len() == 1 {
        true => {
            " Those of the masses rise and fall in turn, each down to zero; that of the ball stays."
        }
        false => "",
    };
    MovingPicture::above(graph, from * unit..=to * unit, stills, move |t| {
        let now = (t / unit).clamp(from, to);
        let been = |k: usize| path(&run, k, times(0.0, now.max(1e-9), 120), Ink::Body);
        let (apart, when) = (t.abs(), if now < 0.0 { "before" } else { "after" });
        let alt = format!(
            "Ball and dumbbell {apart:.2} s {when} the hit, with the paths of the two masses; below, the \
             speeds of the three against time.{told}"
        );
        let across = (-0.8 * c - 0.35, far + 0.7);
        let sketch = Sketch::within(across, (-0.8 * s - 0.3, 1.3 + far * s))
            .curve(been(1)?.thin())
            .curve(been(2)?.thin().dashed());
        Ok((alt, drawn(sketch, places(&run.at(now)?.q), radii).mirrored_if(mirrored)))
    })
}
