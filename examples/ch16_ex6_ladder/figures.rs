//! The drawings of exercise 16.6.

use super::{Parameters, REQUESTED, Solved, Wall, error, landing_error, solve};
use core::f64::consts::FRAC_PI_2;
use rotation_dynamics::Result;
use rotation_dynamics::exact::ladder::{Ladder, LadderState};
use rotation_dynamics::math::{EPS, cos, pow, sin};
use rotation_dynamics::planar::simulate_within;
use rotation_dynamics::report::Figure;
use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel, Side, Sketch};

/// All figures of the page.
pub fn figures(p: &Parameters) -> Result<Vec<Figure>> {
    let solved = solve(p)?;
    Ok(vec![
        setup(p)?,
        strobe(&solved)?,
        ball(&solved)?,
        rate(&solved)?,
        forces(p, &solved)?,
        gap(&solved)?,
        height(p, &solved)?,
        price(&solved)?,
    ])
}

/// Top and foot of a ladder of length `l` whose centre is at `(x, y)`.
fn ends(l: f64, theta: f64, x: f64, y: f64) -> [(f64, f64); 2] {
    let (dx, dy) = (0.5 * l * sin(theta), 0.5 * l * cos(theta));
    [(x - dx, y + dy), (x + dx, y - dy)]
}

fn ladder(l: f64, state: &LadderState) -> [(f64, f64); 2] {
    ends(l, state.theta, state.x_cm, state.y_cm)
}

/// Equally spaced times from `from` to `to`, both included.
fn times(from: f64, to: f64, count: u32) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| {
        if i == count {
            to
        } else {
            from + (to - from) * f64::from(i) / f64::from(count)
        }
    })
}

/// The exact states at `count` + 1 times of the whole motion.
fn motion(exact: &Ladder, count: u32) -> Result<Vec<(f64, LadderState)>> {
    times(0.0, exact.landing_time(), count)
        .map(|t| Ok((t, exact.at(t)?)))
        .collect()
}

fn setup(p: &Parameters) -> Result<Figure> {
    // Drawn at an angle that leaves room for the symbols, in units of the length.
    let theta = p.angle.clamp(0.5, 0.9);
    let (s, c) = (sin(theta), cos(theta));
    let (top, foot, middle) = ((0.0, c), (s, 0.0), (0.5 * s, 0.5 * c));
    Sketch::new(
        "setup",
        "A ladder leans against a vertical wall on the left, at the angle theta from the wall. \
         The wall pushes its top to the right, the floor pushes its foot up, the weight acts at \
         the middle.",
    )
    .window((-0.3, s + 0.42), (-0.16, c + 0.16))
    .wall((0.0, c + 0.14), (0.0, 0.0))
    .wall((0.0, 0.0), (s + 0.4, 0.0))
    .curve(Curve::new([top, foot], Ink::Body).width(4.0))
    .angle(top, 0.26, (-FRAC_PI_2, theta - FRAC_PI_2), r"$\theta$")
    .dot(middle, Ink::Ink, "$(x, y)$", Side::Left)
    .arrow(
        middle,
        (middle.0, middle.1 - 0.24),
        Ink::Force,
        "$mg$",
        Side::Left,
    )
    .arrow(top, (0.22, c), Ink::Force, "$N_{wall}$", Side::Above)
    .arrow(foot, (s, 0.24), Ink::Force, "", Side::Right)
    .text((s, 0.19), "$N_{floor}$", Ink::Force, Side::Right)
    .dimension(
        (middle.0 + 0.06 * c, middle.1 + 0.06 * s),
        (foot.0 + 0.06 * c, foot.1 + 0.06 * s),
        "$l/2$",
        Side::AboveRight,
    )
    .text((0.0, 0.0), "$O$", Ink::Frame, Side::BelowLeft)
    .figure()
}

fn strobe(solved: &Solved) -> Result<Figure> {
    let exact = &solved.exact;
    let l = exact.length();
    let mut sketch = Sketch::new(
        "strobe",
        "Positions of the ladder at equal times. Its top slides down the wall to two thirds of \
         its starting height, there it leaves the wall, and lands a little way from it.",
    )
    .window((-0.3 * l, 1.12 * l), (-0.06 * l, 1.03 * l))
    .wall((0.0, 1.0 * l), (0.0, 0.0))
    .wall((0.0, 0.0), (1.1 * l, 0.0));
    // While both ends are held the ladder stays tangent to the astroid.
    let astroid = times(0.0, FRAC_PI_2, 60).map(|a| (l * pow(sin(a), 3.0), l * pow(cos(a), 3.0)));
    for (t, state) in motion(exact, 12)? {
        let strength = if t == 0.0 { 1.0 } else { 0.45 };
        sketch = sketch.curve(
            Curve::new(ladder(l, &state), Ink::Body)
                .width(1.4)
                .faint(strength),
        );
    }
    sketch = sketch.curve(Curve::new(astroid, Ink::Frame).dotted());
    let release = exact.release();
    let path = motion(exact, 120)?;
    let simulated = times(0.0, solved.run.end_time(), 12)
        .map(|t| Ok((t, solved.run.at(t)?.1)))
        .collect::<Result<Vec<_>>>()?;
    let simulated = simulated.iter().map(|(_, y)| (y[2], 0.5 * l * cos(y[0])));
    sketch
        .curve(Curve::new(ladder(l, &release), Ink::Body).width(3.6))
        .curve(Curve::new(
            path.iter().map(|(_, s)| (s.x_cm, s.y_cm)),
            Ink::Ink,
        ))
        .curve(Curve::new(simulated, Ink::Body).dots())
        .ring(
            (0.0, 2.0 * release.y_cm),
            Ink::Ink,
            "top leaves",
            Side::Left,
        )
        .figure()
}

fn ball(solved: &Solved) -> Result<Figure> {
    let exact = &solved.exact;
    let release = exact.release();
    let (angle0, angle) = (exact.theta0(), release.theta);
    let on_circle = |a: f64| (sin(a), cos(a));
    let (start, leave) = (on_circle(angle0), on_circle(angle));
    let push = on_circle(0.5 * (angle0 + angle));
    let path = motion(exact, 120)?;
    let half = 0.5 * exact.length();
    Sketch::new(
        "ball",
        "The centre of the ladder moves on a quarter circle about the corner, like a ball on a \
         smooth dome, and leaves it at two thirds of its starting height.",
    )
    .window((-0.18, 1.28), (-0.14, 1.2))
    .wall((0.0, 1.15), (0.0, 0.0))
    .wall((0.0, 0.0), (1.25, 0.0))
    .body(
        core::iter::once((0.0, 0.0)).chain(times(0.0, FRAC_PI_2, 60).map(on_circle)),
        Ink::Frame,
        0.12,
    )
    .curve(Curve::new([(0.0, 0.0), leave], Ink::Frame).thin())
    .angle(
        (0.0, 0.0),
        0.32,
        (FRAC_PI_2 - angle, FRAC_PI_2),
        r"$\theta_r$",
    )
    .curve(Curve::new(
        path.iter().map(|(_, s)| (s.x_cm / half, s.y_cm / half)),
        Ink::Ink,
    ))
    .disc(start, 0.035, Ink::Body, 1.0)
    .disc(leave, 0.035, Ink::Body, 1.0)
    .arrow(
        push,
        (1.22 * push.0, 1.22 * push.1),
        Ink::Force,
        "$F$",
        Side::Right,
    )
    .text(
        (leave.0 + 0.04, leave.1 + 0.01),
        "leaves the dome",
        Ink::Ink,
        Side::Right,
    )
    .text((start.0, start.1 + 0.03), "starts", Ink::Ink, Side::Above)
    .text((0.0, 0.0), "$O$", Ink::Frame, Side::BelowLeft)
    .figure()
}

fn rate(solved: &Solved) -> Result<Figure> {
    let (exact, run, naive) = (&solved.exact, &solved.run, &solved.naive);
    let simulated = times(0.0, run.end_time(), 24)
        .map(|t| Ok((t, run.at(t)?.1[1])))
        .collect::<Result<Vec<_>>>()?;
    let kept = times(exact.release_time(), naive.end_time(), 80)
        .map(|t| Ok((t, naive.at(t)?.1[1])))
        .collect::<Result<Vec<_>>>()?;
    let kept_end = kept[kept.len() - 1];
    Panel::new(
        "rate",
        "Angular velocity against time: it grows slowly, then steeply; after the release it \
         grows less than the dashed curve of a ladder that is kept on the wall.",
    )
    .x(Axis::linear("$t$ / s"))
    .y(Axis::linear("angular velocity / (rad/s)").range(0.0, 1.2 * kept_end.1))
    .upright(exact.release_time(), Ink::Frame, "wall lets go")
    .curve(
        Curve::new(
            motion(exact, 160)?.iter().map(|(t, s)| (*t, s.omega)),
            Ink::Ink,
        )
        .label("exact"),
    )
    .curve(Curve::new(simulated, Ink::Velocity).dots().label_at(
        "simulated",
        0.6 * exact.release_time(),
        exact.at(0.6 * exact.release_time())?.omega,
        Side::AboveLeft,
    ))
    .curve(Curve::new(kept, Ink::Wrong).dashed().label_at(
        "wrong: wall kept",
        kept_end.0,
        kept_end.1,
        Side::Left,
    ))
    .figure()
}

fn forces(p: &Parameters, solved: &Solved) -> Result<Figure> {
    let Solved {
        exact,
        scene,
        naive,
        ..
    } = solved;
    let motion = motion(exact, 160)?;
    let pull = times(exact.release_time(), naive.end_time(), 80)
        .map(|t| {
            let wall = scene.forces(Wall::Touches, &naive.at(t)?.1).wall;
            Ok((t, wall / p.gravity))
        })
        .collect::<Result<Vec<_>>>()?;
    let pull_at = pull[pull.len() / 2];
    let on_wall = motion
        .iter()
        .filter(|(t, _)| *t < exact.release_time())
        .map(|(t, s)| (*t, s.wall_force))
        .chain([(exact.release_time(), 0.0)]);
    Panel::new(
        "forces",
        "Force of the floor and of the wall against time, over the weight. The wall's force rises, \
         falls to zero at the release and stays there; a wall that is kept would have to pull, \
         with more than the weight in the end. The floor's force is a quarter of the weight at \
         the release and again at the landing.",
    )
    .x(Axis::linear("$t$ / s"))
    .y(Axis::linear("force / $mg$"))
    .level(0.0, Ink::Frame, "")
    .ring(exact.release_time(), 0.0, Ink::Ink, "", Side::Above)
    .curve(Curve::new(motion.iter().map(|(t, s)| (*t, s.floor_force)), Ink::Ink).label("floor"))
    .curve(Curve::new(on_wall, Ink::Force).label("wall"))
    .curve(
        Curve::new(pull.iter().copied(), Ink::Wrong)
            .dashed()
            .label_at(
                "wrong: the wall pulls",
                pull_at.0,
                pull_at.1,
                Side::BelowLeft,
            ),
    )
    .figure()
}

fn gap(solved: &Solved) -> Result<Figure> {
    let exact = &solved.exact;
    let gap = times(exact.release_time(), exact.landing_time(), 100)
        .map(|t| Ok((t, 1e3 * exact.at(t)?.x_top)))
        .collect::<Result<Vec<_>>>()?;
    let simulated = times(exact.release_time(), solved.run.end_time(), 10)
        .map(|t| Ok((t, 1e3 * solved.scene.top_gap(&solved.run.at(t)?.1))))
        .collect::<Result<Vec<_>>>()?;
    Panel::new(
        "gap",
        "Distance of the top from the wall against time, in millimetres: zero until the release, \
         then growing with the third power of the time since.",
    )
    .x(Axis::linear("$t$ / s").range(0.8 * exact.release_time(), exact.landing_time()))
    .y(Axis::linear("top from wall / mm"))
    .upright(exact.release_time(), Ink::Frame, "wall lets go")
    .curve(Curve::new(
        [
            (0.8 * exact.release_time(), 0.0),
            (exact.release_time(), 0.0),
        ],
        Ink::Ink,
    ))
    .curve(Curve::new(gap, Ink::Ink).label("exact"))
    .curve(Curve::new(simulated, Ink::Body).dots().label("simulated"))
    .figure()
}

fn height(p: &Parameters, solved: &Solved) -> Result<Figure> {
    let exact = &solved.exact;
    let start = cos(p.angle);
    let top = motion(exact, 160)?;
    Panel::new(
        "height",
        "Height of the top over its starting height against time: it is two thirds when the wall \
         lets go.",
    )
    .x(Axis::linear("$t$ / s"))
    .y(Axis::linear("height of the top / at the start").range(0.0, 1.0))
    .level(2.0 / 3.0, Ink::Frame, "2/3")
    .upright(exact.release_time(), Ink::Frame, "")
    .curve(Curve::new(
        top.iter().map(|(t, s)| (*t, cos(s.theta) / start)),
        Ink::Ink,
    ))
    .ring(
        exact.release_time(),
        2.0 / 3.0,
        Ink::Ink,
        "wall lets go",
        Side::BelowLeft,
    )
    .figure()
}

fn price(solved: &Solved) -> Result<Figure> {
    let Solved {
        exact,
        scene,
        naive,
        ..
    } = solved;
    let (start, end) = (scene.at_rest(exact.theta0()), 2.0 * exact.landing_time());
    let mut points = Vec::new();
    for requested in REQUESTED {
        let done = simulate_within(scene, requested, Wall::Touches, start, end)?;
        points.push((
            done.work.derivatives as f64,
            error(exact, &done.run)?.max(EPS),
        ));
    }
    let wrong = landing_error(exact, naive)?;
    let span = [points[0].0, points[points.len() - 1].0];
    Panel::new(
        "price",
        "Relative error against the number of force evaluations, both logarithmic: the error \
         falls from 1e-7 to round-off while the work grows fourfold. Keeping the wall leaves an \
         error of six per cent at any price.",
    )
    .x(Axis::log("evaluations of the forces").ticks([
        (400.0, "400"),
        (600.0, "600"),
        (1000.0, "1000"),
        (1400.0, "1400"),
    ]))
    .y(Axis::log("relative error"))
    .level(EPS, Ink::Frame, "round-off")
    .curve(
        Curve::new(points, Ink::Body)
            .with_dots()
            .label("contact released"),
    )
    .curve(
        Curve::new(span.map(|x| (x, wrong)), Ink::Wrong)
            .dashed()
            .label("wrong: wall kept"),
    )
    .figure()
}
