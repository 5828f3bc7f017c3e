//! The drawings of exercise 16.6.

use super::{Exact, Parameters, REQUESTED, Solved, error, landing_error, solve};
use core::f64::consts::FRAC_PI_2;
use rotation_dynamics::Result;
use rotation_dynamics::exact::ladder::LadderState;
use rotation_dynamics::math::{EPS, cos, log2, pow, sin};
use rotation_dynamics::planar::contact::motion_within;
use rotation_dynamics::report::draw::{Axis, Curve, Ink, Panel, Side, Sketch, Stack};
use rotation_dynamics::report::{Figure, MovingPicture, sampled, times};

/// All figures of the page.
pub fn figures(p: &Parameters) -> Result<Vec<Figure>> {
    let solved = solve(p)?;
    let panels = [rate(&solved)?, forces(&solved)?, gap(&solved)?];
    let more = [height(&solved)?, price(p, &solved)?];
    let sketches = [setup(p), strobe(&solved)?, ball(&solved)?];
    let sketches = sketches.iter().map(Sketch::figure);
    let panels = panels.iter().chain(&more).map(Panel::figure);
    sketches.chain(panels).collect()
}

/// Top and foot of a ladder of length `l` whose middle is at `(x, y)`.
fn ends(l: f64, theta: f64, (x, y): (f64, f64)) -> [(f64, f64); 2] {
    let (dx, dy) = (0.5 * l * sin(theta), 0.5 * l * cos(theta));
    [(x - dx, y + dy), (x + dx, y - dy)]
}

/// The exact path of the middle, in units of `unit`.
fn path(exact: &Exact, unit: f64) -> Result<Curve> {
    let middle = |t| exact.at(t).map(|s| (s.x_cm / unit, s.y_cm / unit));
    let path = sampled(times(0.0, exact.landing_time(), 120), middle)?;
    Ok(Curve::new(path, Ink::Ink))
}

/// A curve through `y` at `n` + 1 times.
fn over(span: [f64; 2], n: u32, y: impl Fn(f64) -> Result<f64>, ink: Ink) -> Result<Curve> {
    Curve::sampled(times(span[0], span[1], n), y, ink)
}

/// The corner, with walls as wide and high as this.
fn corner(name: &str, alt: &str, (right, top): (f64, f64)) -> Sketch {
    let wall = Sketch::new(name, alt).wall((0.0, top), (0.0, 0.0));
    wall.wall((0.0, 0.0), (right, 0.0))
}

fn panel(name: &str, y: &str, alt: &str) -> Panel {
    let panel = Panel::new(name, alt).x(Axis::linear("$t$ / s"));
    panel.y(Axis::linear(y))
}

#[rustfmt::skip]
fn setup(p: &Parameters) -> Sketch {
    // Drawn at an angle that leaves room for the symbols, in units of the length.
    let theta = p.angle.clamp(0.5, 0.9);
    let (s, c) = (sin(theta), cos(theta));
    let (top, foot, middle) = ((0.0, c), (s, 0.0), (0.5 * s, 0.5 * c));
    let beside = |(x, y): (f64, f64)| (x + 0.06 * c, y + 0.06 * s);
    corner("setup", "A ladder leans against a vertical wall on the left, at the angle theta from the wall. The wall \
        pushes its top to the right, the floor pushes its foot up, the weight acts at the middle.", (s + 0.4, c + 0.14))
        .window((-0.3, s + 0.42), (-0.16, c + 0.16))
        .curve(Curve::new([top, foot], Ink::Body).width(4.0))
        .angle(top, 0.26, (-FRAC_PI_2, theta - FRAC_PI_2), r"$\theta$")
        .dot(middle, Ink::Ink, "$(x, y)$", Side::Left).arrow(middle, (middle.0, middle.1 - 0.24), Ink::Force, "$mg$", Side::Left)
        .arrow(top, (0.22, c), Ink::Force, "$N_{wall}$", Side::Above)
        .arrow(foot, (s, 0.24), Ink::Force, "", Side::Right).text((s, 0.19), "$N_{floor}$", Ink::Force, Side::Right)
        .dimension(beside(middle), beside(foot), "$l/2$", Side::AboveRight).text((0.0, 0.0), "$O$", Ink::Frame, Side::BelowLeft)
}

#[rustfmt::skip]
fn strobe(solved: &Solved) -> Result<Sketch> {
    let (exact, run, l) = (&solved.exact, &solved.run, solved.exact.length());
    let ladder = |s: &LadderState| Curve::new(ends(l, s.theta, (s.x_cm, s.y_cm)), Ink::Body);
    // While both ends are held the ladder stays tangent to the astroid.
    let astroid = times(0.0, FRAC_PI_2, 60).map(|a| (l * pow(sin(a), 3.0), l * pow(cos(a), 3.0)));
    let simulated = sampled(times(0.0, run.end_time(), 12), |t| run.at(t).map(|s| (s.q[0], s.q[1])))?;
    let mut sketch = corner("strobe", "Positions of the ladder at equal times. Its top slides down the wall to two \
        thirds of its starting height, there it leaves the wall, and lands a little way from it.", (1.1 * l, l))
        .window((-0.3 * l, 1.12 * l), (-0.06 * l, 1.03 * l));
    for t in times(0.0, exact.landing_time(), 12) {
        let strength = if t == 0.0 { 1.0 } else { 0.45 };
        sketch = sketch.curve(ladder(&exact.at(t)?).width(1.4).faint(strength));
    }
    Ok(sketch
        .curve(Curve::new(astroid, Ink::Frame).dotted()).curve(ladder(&exact.release()).width(3.6))
        .curve(path(exact, 1.0)?).curve(Curve::new(simulated, Ink::Body).dots())
        .ring((0.0, 2.0 * exact.release().y_cm), Ink::Ink, "top leaves", Side::Left))
}

#[rustfmt::skip]
fn ball(solved: &Solved) -> Result<Sketch> {
    let (from, to) = (solved.exact.theta0(), solved.exact.release().theta);
    let on_circle = |a: f64| (sin(a), cos(a));
    let (start, leave, push) = (on_circle(from), on_circle(to), on_circle(0.5 * (from + to)));
    let dome = core::iter::once((0.0, 0.0)).chain(times(0.0, FRAC_PI_2, 60).map(on_circle));
    Ok(corner("ball", "The centre of the ladder moves on a quarter circle about the corner, like a ball on a smooth \
        dome, and leaves it at two thirds of its starting height.", (1.25, 1.15))
        .window((-0.18, 1.28), (-0.14, 1.2)).body(dome, Ink::Frame, 0.12)
        .curve(Curve::new([(0.0, 0.0), leave], Ink::Frame).thin())
        .angle((0.0, 0.0), 0.32, (FRAC_PI_2 - to, FRAC_PI_2), r"$\theta_r$")
        .curve(path(&solved.exact, 0.5 * solved.exact.length())?)
        .disc(start, 0.035, Ink::Body, 1.0).disc(leave, 0.035, Ink::Body, 1.0)
        .arrow(push, (1.22 * push.0, 1.22 * push.1), Ink::Force, "$F$", Side::Right)
        .text((leave.0 + 0.04, leave.1 + 0.01), "leaves the dome", Ink::Ink, Side::Right)
        .text((start.0, start.1 + 0.03), "starts", Ink::Ink, Side::Above)
        .text((0.0, 0.0), "$O$", Ink::Frame, Side::BelowLeft))
}

#[rustfmt::skip]
fn rate(solved: &Solved) -> Result<Panel> {
    let Solved { exact, run, naive, .. } = solved;
    let (t_r, early, end) = (exact.release_time(), 0.6 * exact.release_time(), naive.end_time());
    let omega = |t| Ok(exact.at(t)?.omega);
    let kept = |t| Ok(naive.at(t)?.v[2]);
    let simulated = over([0.0, run.end_time()], 24, |t| Ok(run.at(t)?.v[2]), Ink::Velocity)?;
    Ok(panel("rate", "", "Angular velocity against time: it grows slowly, then steeply; after the release it grows \
        less than the dashed curve of a ladder that is kept on the wall.")
        .y(Axis::linear("angular velocity / (rad/s)").range(0.0, 1.35 * kept(end)?))
        .upright(t_r, Ink::Frame, "wall lets go")
        .curve(over([0.0, exact.landing_time()], 160, omega, Ink::Ink)?.label("exact"))
        .curve(simulated.dots().label_at("simulated", early, omega(early)?, Side::AboveLeft))
        .curve(over([t_r, end], 80, kept, Ink::Wrong)?.dashed()
            .label_at("wrong: wall kept", end, kept(end)?, Side::AboveLeft)))
}

#[rustfmt::skip]
fn forces(solved: &Solved) -> Result<Panel> {
    let Solved { exact, naive, .. } = solved;
    let (t_r, end) = (exact.release_time(), naive.end_time());
    let pull = |t| Ok(naive.forces(t)?[0].normal / exact.gravity());
    let middle = 0.5 * (t_r + end);
    let floor = over([0.0, exact.landing_time()], 160, |t| Ok(exact.at(t)?.floor_force), Ink::Ink)?;
    let wall = over([0.0, t_r], 120, |t| Ok(exact.at(t)?.wall_force), Ink::Force)?;
    Ok(panel("forces", "force / $mg$", "Force of the floor and of the wall against time, over the weight. The wall's \
        force rises, falls to zero at the release and stays there; a wall that is kept would have to pull, with \
        more than the weight in the end. The floor's force is a quarter of the weight at the release and again at \
        the landing.")
        .level(0.0, Ink::Frame, "").ring(t_r, 0.0, Ink::Ink, "", Side::Above)
        .curve(floor.label("floor")).curve(wall.label("wall"))
        .curve(over([t_r, end], 80, pull, Ink::Wrong)?.dashed()
            .label_at("wrong: the wall pulls", middle, pull(middle)?, Side::BelowLeft)))
}

#[rustfmt::skip]
fn gap(solved: &Solved) -> Result<Panel> {
    let Solved { exact, run, ladder, .. } = solved;
    let (t_r, end) = (exact.release_time(), exact.landing_time());
    let gap = over([t_r, end], 100, |t| Ok(1e3 * exact.at(t)?.x_top), Ink::Ink)?;
    let simulated = over([t_r, run.end_time()], 10, |t| Ok(1e3 * ladder.top_gap(&run.at(t)?)), Ink::Body)?;
    let power = log2(exact.at(end)?.x_top / exact.at(0.5 * (t_r + end))?.x_top);
    let alt = format!("Distance of the top from the wall against time, in millimetres: zero until the release, then \
        growing slowly at first and ever faster, over the last half of the time with the power {power:.1} of the time since.");
    Ok(panel("gap", "top from wall / mm", &alt)
        .x(Axis::linear("$t$ / s").range(0.8 * t_r, end))
        .upright(t_r, Ink::Frame, "wall lets go")
        .curve(Curve::new([(0.8 * t_r, 0.0), (t_r, 0.0)], Ink::Ink))
        .curve(gap.label("exact")).curve(simulated.dots().label("simulated")))
}

#[rustfmt::skip]
fn height(solved: &Solved) -> Result<Panel> {
    let exact = &solved.exact;
    let height = |t| Ok(cos(exact.at(t)?.theta) / cos(exact.theta0()));
    Ok(panel("height", "", "Height of the top over its starting height against time: it is two thirds when the wall \
        lets go.")
        .y(Axis::linear("height of the top / at the start").range(0.0, 1.0))
        .level(2.0 / 3.0, Ink::Frame, "2/3").upright(exact.release_time(), Ink::Frame, "")
        .curve(over([0.0, exact.landing_time()], 160, height, Ink::Ink)?)
        .ring(exact.release_time(), 2.0 / 3.0, Ink::Ink, "wall lets go", Side::BelowLeft))
}

#[rustfmt::skip]
fn price(p: &Parameters, solved: &Solved) -> Result<Panel> {
    let (exact, ladder) = (&solved.exact, solved.ladder);
    let points = sampled(REQUESTED, |requested| {
        let done = motion_within(ladder, requested, ladder.at_rest(p.angle), 2.0 * exact.landing_time())?;
        Ok((done.work().derivatives as f64, error(exact, &done)?.max(EPS)))
    })?;
    let (first, middle, last) = (points[0], points[2], points[points.len() - 1]);
    let wrong = landing_error(exact, &solved.naive)?;
    let alt = format!("Relative error against the number of force evaluations, both logarithmic: the error falls from \
        {:.0e} to {:.0e} while the work grows {:.1}-fold. Keeping the wall leaves {:.1} per cent at any price.",
        first.1, last.1, last.0 / first.0, 100.0 * wrong);
    Ok(Panel::new("price", &alt)
        .x(Axis::log("evaluations of the forces").ticks([400, 600, 1000, 1400].map(|n| (f64::from(n), n.to_string())))).y(Axis::log("relative error"))
        .level(EPS, Ink::Frame, "round-off")
        .curve(Curve::new(points, Ink::Body).with_dots().label_at("contact released", middle.0, middle.1, Side::AboveRight))
        .curve(Curve::new([(first.0, wrong), (last.0, wrong)], Ink::Wrong).dashed().label("wrong: wall kept")))
}

/// The ladder with what pushes it, and faintly the one that is kept; below, the forces.
#[rustfmt::skip]
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let solved = solve(p)?;
    let (t_r, end) = (solved.exact.release_time(), solved.exact.landing_time());
    let graph = forces(&solved)?;
    MovingPicture::new(0.0..=end, [0.8 * t_r, t_r, 0.1 * t_r + 0.9 * end], move |t| {
        let Solved { exact, naive, .. } = &solved;
        let (l, LadderState { theta, x_cm, y_cm, wall_force, floor_force, .. }) = (exact.length(), exact.at(t)?);
        let [top, foot] = ends(l, theta, (x_cm, y_cm));
        let [x, y, angle] = naive.at(t.min(naive.end_time()))?.q;
        let kept = Curve::new(ends(l, angle, (x, y)), Ink::Wrong).width(4.0);
        let scene = corner("scene", "", (1.1 * l, l))
            .window((-0.3 * l, 1.3 * l), (-0.27 * l, 1.03 * l))
            .ghost(|sketch| if t > t_r { sketch.curve(kept) } else { sketch })
            .curve(Curve::new([top, foot], Ink::Body).width(4.0))
            .vector(top, (wall_force, 0.0), 45.0, Ink::Force, "$N_{wall}$")
            .vector(foot, (0.0, floor_force), 45.0, Ink::Force, "$N_{floor}$")
            .vector((x_cm, y_cm), (0.0, -1.0), 45.0, Ink::Force, "$mg$");
        // Round-off may leave a pull of nothing.
        let push = wall_force.max(0.0);
        let beside = if t > t_r { " Faintly, ahead of it, the ladder that a wall would keep by pulling." } else { "" };
        let alt = format!("The ladder {t:.2} s after its release, {:.0} degrees from the wall. The wall pushes with \
            {push:.2} and the floor with {floor_force:.2} of the weight.{beside} Below, the forces against time.", theta.to_degrees());
        Stack::frame(&alt, scene, &graph, t)
    })
}
