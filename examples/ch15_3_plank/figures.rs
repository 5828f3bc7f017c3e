//! The drawings of the falling plank; in them it falls to the right.

use super::*;
use models::plank::PlankState;

/// Foot and top of a plank of length `l` whose middle is above the origin.
fn ends(l: f64, theta: f64) -> [(f64, f64); 2] {
    let (s, c) = sincos(theta);
    [(-0.5 * l * s, 0.0), (0.5 * l * s, l * c)]
}

/// The floor under a picture of a plank of length `l`.
fn floor(l: f64) -> Sketch {
    let sketch = Sketch::within((-0.75 * l, 0.8 * l), (-0.1 * l, 1.08 * l));
    sketch.wall((-0.73 * l, 0.0), (0.78 * l, 0.0))
}

/// The floor's force against time, over the weight.
fn force(p: &Parameters) -> Result<Panel> {
    let (fall, run) = (exact(p, p.angle)?, simulated(p)?);
    let end = fall.landing_time();
    let pushed = |t: f64| Ok(run.forces(t.min(run.end_time()))?[0].normal / p.gravity);
    let exact = Curve::sampled(times(0.0, end, 200), |t| Ok(fall.at(t)?.floor_force), Ink::Force)?;
    Ok(Panel::over_axes("$t$ / s", Axis::linear("$N/mg$").range(0.0, 1.0))
        .curve(exact)
        .curve(Curve::sampled(times(0.0, end, 16), pushed, Ink::Force)?.dots())
        .level(0.25, Ink::Frame, "$1/4$"))
}

figures! { p: &Parameters, unit = (p.length / p.gravity).sqrt();
    /// A plank leans to the right at the angle theta from the vertical through its foot. The weight acts at its
    /// middle, at the height y, the floor pushes up at its foot. An arrow says that the foot slides to the left;
    /// a dashed line leads from the floor straight up through the middle.
    setup: {
        let theta = 0.55;
        let ([foot, top], middle) = (ends(1.0, theta), (0.0, 0.5 * cos(theta)));
        let line = |from, to| Curve::new([from, to], Ink::Frame).dashed().thin();
        floor(1.0)
            .curve(line((0.0, 0.0), (0.0, 0.62)))
            .curve(line(foot, (foot.0, 0.5)))
            .bar(foot, top, 0.035, Ink::Body)
            .angle(foot, 0.3, (FRAC_PI_2 - theta, FRAC_PI_2), r"$\theta$")
            .dot(middle, Ink::Ink, "CM", Side::Right)
            .arrow(middle, (0.0, middle.1 - 0.27), Ink::Force, "$mg$", Side::Right)
            .arrow(foot, (foot.0, 0.2), Ink::Force, "$N$", Side::Left)
            .arrow((foot.0 - 0.06, 0.04), (foot.0 - 0.26, 0.04), Ink::Ink, "", Side::Above)
            .dimension((0.5, 0.0), (0.5, middle.1), "$y$", Side::Right)
            .curve(line(middle, (0.56, middle.1)))
            .text((0.5 * top.0, 0.5 * (middle.1 + top.1)), "$l/2$", Ink::Ink, Side::AboveLeft)
    };

    /// Positions of the plank at equal times, falling to the right: first hardly any motion, then more and more.
    /// All middles lie on one vertical line; the foot slides to the left, the top goes out on a quarter of an
    /// ellipse.
    strobe: {
        let (fall, l) = (exact(p, p.angle)?, p.length);
        let end = fall.landing_time();
        let states = sampled(times(0.4 * end, end, 12), |t| Ok((t, fall.at(t)?)))?;
        let top = times(0.0, FRAC_PI_2, 60).map(|angle| ends(l, angle)[1]);
        let middles = states.iter().map(|(_, state)| (0.0, state.y_cm));
        let position = |sketch: Sketch, (t, state): &(f64, PlankState)| {
            let strength = if *t == end { 1.0 } else { 0.45 };
            sketch.curve(Curve::new(ends(l, state.theta), Ink::Body).width(1.6).faint(strength))
        };
        states.iter().fold(floor(l), position)
            .curve(Curve::new(top, Ink::Frame).dotted())
            .curve(Curve::new([(0.0, 0.5 * l), (0.0, 0.0)], Ink::Ink))
            .curve(Curve::new(middles, Ink::Body).dots())
            .text((0.5 * l, 0.45 * l), "top", Ink::Frame, Side::AboveRight)
            .text((-0.5 * l, 0.0), "foot", Ink::Frame, Side::AboveLeft)
    };

    /// Angular velocity against the angle: from zero along the straight line of small angles, then bending over
    /// below it; the rod with its foot held starts with half the slope and rises later. Both end at the floor at
    /// the same value. Dots of a simulation lie on the first curve.
    rates: {
        let (free, held) = (|a: f64| rate_from_upright(p, a), |a: f64| 6.0_f64.sqrt() / unit * sin(0.5 * a));
        let run = Plank::smooth(p).fall(1e-9, 1e-6, 0.0)?;
        let (all, end) = (times(0.0, FRAC_PI_2, 120), run.end_time());
        let dots = sampled(times(end - 2.2 * unit, end, 14), |t| Ok(run.at(t).map(|s| (s.q[2], s.v[2]))?))?;
        let small = Curve::of(times(0.0, 0.78, 2), |a| growth(p) * a, Ink::Frame).dotted();
        let rate = Axis::linear(r"$\dot\theta$ / (rad/s)").range(0.0, 2.0 / unit);
        Panel::over_axes(Axis::angle(r"$\theta$ / rad").range(0.0, FRAC_PI_2), rate)
            .curve(small.label_at("small angles", 0.62, 1.52 / unit, Side::AboveLeft))
            .curve(Curve::of(all.clone(), free, Ink::Ink).label_at("foot free", 1.25, free(1.25), Side::AboveLeft))
            .curve(Curve::new(dots, Ink::Velocity).dots())
            .curve(Curve::of(all, held, Ink::Frame).dashed().label_at("foot held", 1.0, held(1.0), Side::BelowRight))
            .ring(FRAC_PI_2, 3.0_f64.sqrt() / unit, Ink::Ink, "", Side::Left)
    };

    /// Force of the floor over the weight against time: one at first, then it falls to about a sixth, and rises
    /// to a quarter at the end; it is never zero. Dots of a simulation lie on the curve.
    forces: force(p)?;

    /// Time to the floor against the logarithm of the angle of release: two nearly straight lines, the one with
    /// the foot held twice as steep; both grow without limit to the left. Dots of a simulation lie on the lower
    /// one.
    durations: {
        let angles = |count: u32| times(-12.0, 0.0, count).map(|x| exp(x * log(10.0)));
        let free = Curve::sampled(angles(72), |a| Ok(exact(p, a)?.landing_time()), Ink::Ink)?;
        let held = Curve::sampled(angles(72), |a| held_time(p, a), Ink::Frame)?;
        let run = |a: f64| Ok(Plank::smooth(p).fall(1e-9, a, 0.0)?.end_time());
        let time = Axis::linear("$t_{floor}$ / s").range(0.0, 26.0 * unit);
        Panel::over_axes(Axis::log(r"$\theta_0$ / rad"), time)
            .curve(free.label_at("foot free", 1e-7, 7.0 * unit, Side::BelowLeft))
            .curve(held.dashed().label_at("foot held", 1e-6, 13.5 * unit, Side::AboveRight))
            .curve(Curve::sampled(angles(6), run, Ink::Body)?.dots())
    };
}

/// The fall, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let fall = exact(p, p.angle)?;
    let columns = "t [s], theta [rad], omega [rad/s], y_cm [m], vy_cm [m/s], x_foot [m], N/mg";
    Trajectory::sampled(columns.split(", "), times(0.0, fall.landing_time(), 200), |t| {
        let s = fall.at(t)?;
        let [(foot, _), _] = ends(p.length, s.theta);
        Ok([t, s.theta, s.omega, s.y_cm, s.vy_cm, foot, s.floor_force])
    })
}

/// The plank with what pushes it, and faintly the one whose foot is held; below, the force.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (fall, l) = (exact(p, p.angle)?, p.length);
    let end = fall.landing_time();
    let rod = Dop853::new(1e-12)?.solve(&hinged(p), 0.0, &[p.angle, 0.0], end, &[])?;
    let far = l * sin(rod.at(end)?[0].min(FRAC_PI_2));
    MovingPicture::above(force(p)?, 0.0..=end, [0.7 * end, 0.9 * end, end], move |t| {
        let PlankState { theta, y_cm, floor_force, .. } = fall.at(t)?;
        let ([foot, top], middle) = (ends(l, theta), (0.0, y_cm));
        // It is drawn so thick, on the floor.
        let (thick, up) = (0.035 * l, |(x, y)| (x, y + 0.0175 * l));
        // If the rod is first, it lies on the floor and waits.
        let held = rod.at(t)?[0].min(FRAC_PI_2);
        let (s, c) = sincos(held);
        let scene =
            floor(l)
                .window((-0.75 * l, 0.8 * l), (-0.3 * l, 1.05 * l))
                .clear((-0.5 * l, far), (0.0, l), [10.0, 6.0, 60.0, 8.0])
                .ghost(|sketch| {
                    sketch
                        .curve(Curve::new([(0.0, 0.0), (l * s, l * c)], Ink::Frame).width(4.0))
                        .ring((0.0, 0.0), Ink::Frame, "", Side::Below)
                })
                .curve(Curve::new([(0.0, 0.5 * l), (0.0, 0.0)], Ink::Frame).dashed().thin())
                .curve(Curve::new([(0.0, 0.5 * l), middle], Ink::Ink).thin())
                .bar(up(foot), up(top), thick, Ink::Body)
                .dot(up(middle), Ink::Ink, "", Side::Left)
                .vector(up(middle), (0.0, -1.0), 55.0, Ink::Force, "$mg$")
                .vector(foot, (0.0, floor_force), 55.0, Ink::Force, "$N$");
        let alt = format!(
            "The plank {t:.2} s after its release, {:.0} degrees from the vertical, its middle straight below where it \
             was. The floor pushes with {floor_force:.2} of the weight. Faintly, the rod whose foot is held, at {:.0} degrees. Below, the force \
             of the floor against time.",
            theta.to_degrees(),
            held.to_degrees()
        );
        Ok((alt, scene))
    })
}
