//! The drawings of exercise 16.6.

use super::*;
use models::ladder::LadderState;
use rotation_dynamics::math::log2;

/// Top and foot of a ladder of length `l` whose middle is at `(x, y)`.
fn ends(l: f64, theta: f64, (x, y): (f64, f64)) -> [(f64, f64); 2] {
    let (dx, dy) = (0.5 * l * sin(theta), 0.5 * l * cos(theta));
    [(x - dx, y + dy), (x + dx, y - dy)]
}

/// The exact path of the middle, in units of `unit`.
fn path(exact: &Exact, unit: f64) -> Result<Curve> {
    let middle = |t| Ok(exact.at(t).map(|s| (s.x_cm / unit, s.y_cm / unit))?);
    Ok(Curve::new(sampled(times(0.0, exact.landing_time(), 120), middle)?, Ink::Ink))
}

/// The corner in this window, with walls as wide and high as this.
fn corner(x: (f64, f64), y: (f64, f64), (right, top): (f64, f64)) -> Sketch {
    Sketch::within(x, y).wall((0.0, top), (0.0, 0.0)).wall((0.0, 0.0), (right, 0.0))
}

/// The forces over the weight, against time.
fn forces(Solved { exact, naive, .. }: &Solved) -> Result<Panel> {
    let (t_r, landing, end) = (exact.release_time(), exact.landing_time(), naive.end_time());
    let floor = |t| Ok(exact.at(t)?.floor_force);
    let wall = |t| Ok(exact.at(t)?.wall_force);
    let pull = |t| Ok(naive.forces(t)?[0].normal / exact.gravity());
    let middle = 0.5 * (t_r + end);
    let kept = Curve::sampled(times(t_r, end, 80), pull, Ink::Wrong)?.dashed();
    let kept = kept.label_at("wrong: the wall pulls", middle, pull(middle)?, Side::BelowLeft);
    Ok(Panel::over_axes("$t$ / s", "force / $mg$")
        .level(0.0, Ink::Frame, "")
        .ring(t_r, 0.0, Ink::Ink, "", Side::Above)
        .curve(Curve::sampled(times(0.0, landing, 160), floor, Ink::Force)?.label("floor"))
        .curve(Curve::sampled(times(0.0, t_r, 120), wall, Ink::Force)?.label("wall"))
        .curve(kept))
}

/// Evaluations and errors for each error requested.
fn priced(p: &Parameters, Solved { exact, ladder, .. }: &Solved) -> Result<Vec<(f64, f64)>> {
    let (start, end) = (ladder.at_rest(p.angle), 2.0 * exact.landing_time());
    sampled(REQUESTED, |requested| {
        let done = motion_within(*ladder, requested, start, end)?;
        Ok((done.work().derivatives as f64, error(exact, &done)?.max(EPS)))
    })
}

figures! { p: &Parameters, solved = solve(p)?, exact = &solved.exact, [run, naive] = [&solved.run, &solved.naive],
    ladder = solved.ladder, [t_r, landing] = [exact.release_time(), exact.landing_time()],
    points = priced(p, &solved)?, wrong = landing_error(exact, naive)?;
    /// A ladder leans against a vertical wall on the left, at the angle theta from the wall. The wall pushes
    /// its top to the right, the floor pushes its foot up, the weight acts at the middle.
    setup: {
        // Drawn at an angle that leaves room for the symbols, in units of the length.
        let theta = p.angle.clamp(0.5, 0.9);
        let (s, c) = (sin(theta), cos(theta));
        let (top, foot, middle) = ((0.0, c), (s, 0.0), (0.5 * s, 0.5 * c));
        let beside = |(x, y): (f64, f64)| (x + 0.06 * c, y + 0.06 * s);
        corner((-0.3, s + 0.42), (-0.16, c + 0.16), (s + 0.4, c + 0.14))
            .curve(Curve::new([top, foot], Ink::Body).width(4.0))
            .angle(top, 0.26, (-FRAC_PI_2, theta - FRAC_PI_2), r"$\theta$")
            .dot(middle, Ink::Ink, "$(x, y)$", Side::Left)
            .arrow(middle, (middle.0, middle.1 - 0.24), Ink::Force, "$mg$", Side::Left)
            .arrow(top, (0.22, c), Ink::Force, "$N_{wall}$", Side::Above)
            .arrow(foot, (s, 0.24), Ink::Force, "", Side::Right).text((s, 0.19), "$N_{floor}$", Ink::Force, Side::Right)
            .dimension(beside(middle), beside(foot), "$l/2$", Side::AboveRight)
            .text((0.0, 0.0), "$O$", Ink::Frame, Side::BelowLeft)
    };

    /// Positions of the ladder at equal times. Its top slides down the wall to two thirds of its starting
    /// height, there it leaves the wall, and lands a little way from it.
    strobe: {
        let l = exact.length();
        let drawn = |s: &LadderState| Curve::new(ends(l, s.theta, (s.x_cm, s.y_cm)), Ink::Body);
        // While both ends are held the ladder stays tangent to the astroid.
        let astroid = times(0.0, FRAC_PI_2, 60).map(|a| (l * pow(sin(a), 3.0), l * pow(cos(a), 3.0)));
        let simulated = sampled(times(0.0, run.end_time(), 12), |t| Ok(run.at(t).map(|s| (s.q[0], s.q[1]))?))?;
        let mut sketch = corner((-0.3 * l, 1.12 * l), (-0.06 * l, 1.03 * l), (1.1 * l, l));
        for t in times(0.0, landing, 12) {
            let strength = if t == 0.0 { 1.0 } else { 0.45 };
            sketch = sketch.curve(drawn(&exact.at(t)?).width(1.4).faint(strength));
        }
        sketch
            .curve(Curve::new(astroid, Ink::Frame).dotted())
            .curve(drawn(&exact.release()).width(3.6))
            .curve(path(exact, 1.0)?)
            .curve(Curve::new(simulated, Ink::Body).dots())
            .ring((0.0, 2.0 * exact.release().y_cm), Ink::Ink, "top leaves", Side::Left)
    };

    /// The centre of the ladder moves on a quarter circle about the corner, like a ball on a smooth dome, and
    /// leaves it at two thirds of its starting height.
    ball: {
        let (from, to) = (exact.theta0(), exact.release().theta);
        let on_circle = |a: f64| (sin(a), cos(a));
        let (start, leave, push) = (on_circle(from), on_circle(to), on_circle(0.5 * (from + to)));
        let dome = core::iter::once((0.0, 0.0)).chain(times(0.0, FRAC_PI_2, 60).map(on_circle));
        corner((-0.18, 1.28), (-0.14, 1.2), (1.25, 1.15))
            .body(dome, Ink::Frame, 0.12)
            .curve(Curve::new([(0.0, 0.0), leave], Ink::Frame).thin())
            .angle((0.0, 0.0), 0.32, (FRAC_PI_2 - to, FRAC_PI_2), r"$\theta_r$")
            .curve(path(exact, 0.5 * exact.length())?)
            .disc(start, 0.035, Ink::Body, 1.0).disc(leave, 0.035, Ink::Body, 1.0)
            .arrow(push, (1.22 * push.0, 1.22 * push.1), Ink::Force, "$F$", Side::Right)
            .text((leave.0 + 0.04, leave.1 + 0.01), "leaves the dome", Ink::Ink, Side::Right)
            .text((start.0, start.1 + 0.03), "starts", Ink::Ink, Side::Above)
            .text((0.0, 0.0), "$O$", Ink::Frame, Side::BelowLeft)
    };

    /// Angular velocity against time: it grows slowly, then steeply; after the release it grows less than the
    /// dashed curve of a ladder that is kept on the wall.
    rate: {
        let end = naive.end_time();
        let omega = |t| Ok(exact.at(t)?.omega);
        let kept = |t| Ok(naive.at(t)?.v[2]);
        let simulated = Curve::sampled(times(0.0, run.end_time(), 24), |t| Ok(run.at(t)?.v[2]), Ink::Velocity)?.dots();
        let wrong = Curve::sampled(times(t_r, end, 80), kept, Ink::Wrong)?.dashed();
        Panel::over_axes("$t$ / s", Axis::linear("angular velocity / (rad/s)").range(0.0, 1.35 * kept(end)?))
            .curve(Curve::sampled(times(0.0, landing, 160), omega, Ink::Ink)?.label("exact"))
            .curve(simulated.label_at("simulated", 0.6 * t_r, omega(0.6 * t_r)?, Side::AboveLeft))
            .curve(wrong.label_at("wrong: wall kept", end, kept(end)?, Side::AboveLeft))
            .ring(t_r, omega(t_r)?, Ink::Ink, "wall lets go", Side::AboveLeft)
    };

    /// Force of the floor and of the wall against time, over the weight. The wall's force rises, falls to zero
    /// at the release and stays there; a wall that is kept would have to pull, with more than the weight in the
    /// end. The floor's force is a quarter of the weight at the release and again at the landing.
    forces: forces(&solved)?;

    gap(format!(
        "Distance of the top from the wall against time, in millimetres: zero until the release, then \
         growing slowly at first and ever faster, over the last half of the time with the power {:.1} of the time since.",
        log2(exact.at(landing)?.x_top / exact.at(0.5 * (t_r + landing))?.x_top)
    )): {
        let gap = Curve::sampled(times(t_r, landing, 100), |t| Ok(1e3 * exact.at(t)?.x_top), Ink::Ink)?;
        let simulated = |t| Ok(1e3 * ladder.top_gap(&run.at(t)?));
        let simulated = Curve::sampled(times(t_r, run.end_time(), 10), simulated, Ink::Body)?;
        Panel::over_axes(Axis::linear("$t$ / s").range(0.8 * t_r, landing), "top from wall / mm")
            .upright(t_r, Ink::Frame, "wall lets go")
            .curve(Curve::new([(0.8 * t_r, 0.0), (t_r, 0.0)], Ink::Ink))
            .curve(gap.label("exact"))
            .curve(simulated.dots().label("simulated"))
    };

    /// Height of the top over its starting height against time: it is two thirds when the wall lets go.
    height: {
        let height = |t| Ok(cos(exact.at(t)?.theta) / cos(exact.theta0()));
        Panel::over_axes("$t$ / s", Axis::linear("height of the top / at the start").range(0.0, 1.0))
            .level(2.0 / 3.0, Ink::Frame, "2/3")
            .upright(t_r, Ink::Frame, "")
            .curve(Curve::sampled(times(0.0, landing, 160), height, Ink::Ink)?)
            .ring(t_r, 2.0 / 3.0, Ink::Ink, "wall lets go", Side::BelowLeft)
    };

    price({
        let ((few, rough), (many, fine)) = (points[0], points[points.len() - 1]);
        format!("Relative error against the number of force evaluations, both logarithmic: the error falls from \
            {rough:.0e} to {fine:.0e} while the work grows {:.1}-fold. Keeping the wall leaves {:.1} per cent at any price.",
            many / few, 100.0 * wrong)
    }): {
        let ((few, _), (x, y), (many, _)) = (points[0], points[2], points[points.len() - 1]);
        let evaluations = [400, 600, 1000, 1400].map(|n| (f64::from(n), n.to_string()));
        Panel::over_axes(Axis::log("evaluations of the forces").ticks(evaluations), Axis::log("relative error"))
            .level(EPS, Ink::Frame, "round-off")
            .curve(Curve::new(points, Ink::Body).with_dots().label_at("contact released", x, y, Side::AboveRight))
            .curve(Curve::new([(few, wrong), (many, wrong)], Ink::Wrong).dashed().label("wrong: wall kept"))
    };
}

pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let exact = Exact::new(p.length, p.gravity, p.angle)?;
    let columns = "t [s], theta [rad], omega [rad/s], x_cm [m], y_cm [m], x_top [m], \
                   vx_cm [m/s], N_floor/mg, N_wall/mg";
    Trajectory::sampled(columns.split(", "), times(0.0, exact.landing_time(), 200), |t| {
        let s = exact.at(t)?;
        let forces = [s.floor_force, s.wall_force];
        let motion = [t, s.theta, s.omega, s.x_cm, s.y_cm, s.x_top, s.vx_cm];
        Ok([&motion[..], &forces].concat())
    })
}

/// The ladder with what pushes it, and faintly the one that is kept; below, the forces.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let solved = solve(p)?;
    let (t_r, end) = (solved.exact.release_time(), solved.exact.landing_time());
    let stills = [0.8 * t_r, t_r, 0.1 * t_r + 0.9 * end];
    MovingPicture::above(forces(&solved)?, 0.0..=end, stills, move |t| {
        let Solved { exact, naive, .. } = &solved;
        let (l, s) = (exact.length(), exact.at(t)?);
        let [top, foot] = ends(l, s.theta, (s.x_cm, s.y_cm));
        let [x, y, angle] = naive.at(t.min(naive.end_time()))?.q;
        let kept = Curve::new(ends(l, angle, (x, y)), Ink::Wrong).width(4.0);
        // Round-off may leave a pull of nothing.
        let (push, carried, angle) = (s.wall_force.max(0.0), s.floor_force, s.theta.to_degrees());
        let ahead = " Faintly, ahead of it, the ladder that a wall would keep by pulling.";
        let beside = if t > t_r { ahead } else { "" };
        let alt = format!(
            "The ladder {t:.2} s after its release, {angle:.0} degrees from the wall. The wall pushes with \
             {push:.2} and the floor with {carried:.2} of the weight.{beside} Below, the forces against time."
        );
        // Below the floor there is room for the weight of a ladder that lies on it.
        let scene = corner((-0.3 * l, 1.3 * l), (-0.27 * l, 1.03 * l), (1.1 * l, l))
            .ghost(|sketch| sketch.only_if(t > t_r, |sketch| sketch.curve(kept)))
            .curve(Curve::new([top, foot], Ink::Body).width(4.0))
            .vector(top, (s.wall_force, 0.0), 45.0, Ink::Force, "$N_{wall}$")
            .vector(foot, (0.0, s.floor_force), 45.0, Ink::Force, "$N_{floor}$")
            .vector((s.x_cm, s.y_cm), (0.0, -1.0), 45.0, Ink::Force, "$mg$");
        Ok((alt, scene))
    })
}
