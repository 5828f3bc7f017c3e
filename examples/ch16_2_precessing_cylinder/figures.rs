//! The drawings of section 16.2 (1).

use super::*;
use rotation_dynamics::integrators::Solution;

const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
/// The motion after the clamp, or more, is let go.
fn motion(body: &Cylinder, what: LetGo, end: f64, step: f64) -> Result<Solution<4>> {
    Ok(Dop853::new(step)?.solve(&body.let_go(what), 0.0, &body.start(), end, &[])?)
}

figures! { p: &Parameters;
    /// A cylinder in a fork, seen along the level line x, which points away from the reader. Its
    /// axis z leans to the right by the angle theta from the vertical Z, about which the fork
    /// turns. y is square to both. The angular momentum leans to the left of Z. A bent arrow shows
    /// the torque of the clamp, which turns the axis back towards Z.
    setup: {
        let (tilt, lean) = (0.5, 0.796);
        let (s, c) = sincos(tilt);
        let (o, axis, across) = ((0.0, 0.0), |d: f64| (d * s, d * c), |d: f64| (-d * c, d * s));
        Sketch::within((-1.1, 1.1), (-0.85, 1.42))
            .guide([(0.0, -0.8), (0.0, 1.05)])
            .bar(axis(-0.7), axis(0.7), 0.5, Ink::Body)
            .guide([o, axis(1.05)])
            .text(axis(1.05), "$z$", Ink::Body, Side::Above)
            .guide([o, across(0.9)])
            .text(across(0.9), "$y$", Ink::Frame, Side::Left)
            .angle(o, 0.62, (FRAC_PI_2 - tilt, FRAC_PI_2), r"$\theta$")
            .arrow(o, (0.0, 1.25), Ink::Velocity, "", Side::Right)
            .text((0.0, 1.28), r"$\Omega$, $Z$", Ink::Velocity, Side::Above)
            .arrow(o, (-0.9 * sin(lean), 0.9 * cos(lean)), Ink::Momentum, "", Side::Left)
            .text((-0.95 * sin(lean), 0.95 * cos(lean)), "$L$", Ink::Momentum, Side::AboveLeft)
            .turn(o, 0.95, (0.35, 0.85), Ink::Force)
            .text((0.95 * cos(0.4), 0.95 * sin(0.4)), r"$\lambda$", Ink::Force, Side::Right)
            .ring(o, Ink::Ink, "", Side::Below)
    };

    /// Torque of the clamp against the tilt, over M R^2 and the square of the rate, for a long
    /// cylinder, a disc, and the one between for which it is zero. It is zero for upright and
    /// level ones and greatest at 45 degrees, negative for the long one, positive for the disc.
    torque: {
        let y = Axis::linear(r"$\lambda/MR^2\dot\phi^2$").range(-0.3, 0.2);
        let empty = Panel::over_axes(Axis::angle(r"$\theta$ / rad").range(0.0, FRAC_PI_2), y);
        let mut panel = empty.level(0.0, Ink::Frame, "");
        let balance = 3.0_f64.sqrt();
        for (h, label, side) in [(0.0, "disc", Side::Above), (balance, r"$H=\sqrt{3}R$", Side::Above), (3.0, "$H=3R$", Side::Below)] {
            let at = |tilt| Parameters { tilt, height: h, ..of_radius_one() };
            let apart = (3.0 - h * h) / 12.0;
            let exact = Curve::of(times(0.0, FRAC_PI_2, 90), |a| apart * sin(a) * cos(a), Ink::Ink);
            let summed = Curve::sampled(times(0.15, 1.4, 5), |a| Ok(by_grains(&at(a))?[1]), Ink::Force)?;
            panel = panel.curve(exact.label_at(label, 0.785, 0.5 * apart, side)).curve(summed.dots());
        }
        panel
    };

    /// Tilt against time after the release, in turns of the fork before it, for three ways of
    /// letting go. The three start alike. In the fork the axis swings over to the mirror image of
    /// its tilt and back, sooner with a motor; free of everything it turns back earlier.
    let_go: {
        let (body, turn) = (Cylinder::new(p)?, TAU / p.rate.abs());
        let end = 1.02 * body.swung(LetGo::All)?[1].max(body.swung(LetGo::Motor)?[1]);
        let y = Axis::angle(r"$\theta$ / rad").parts_of_pi(4);
        let mut panel = Panel::over_axes(r"$t$ / turns of the fork", y).level(FRAC_PI_2, Ink::Frame, "level");
        for (what, name, side) in [
            (LetGo::Motor, "motor", Side::Left),
            (LetGo::Clamp, "fork left to itself", Side::Above),
            (LetGo::All, "all let go", Side::Below),
        ] {
            let (run, far) = (motion(&body, what, end, p.tolerance)?, body.swung(what)?[1] / 2.0);
            let tilt = |t: f64| Ok(run.at(t * turn)?[0]);
            let at = far.min(0.8 * end) * if what == LetGo::Motor { 0.8 } else { 1.0 } / turn;
            let curve = Curve::sampled(times(0.0, end / turn, 200), tilt, Ink::Body)?;
            panel = panel.curve(curve.label_at(name, at, tilt(at)?, side));
        }
        let free = body.freed()?;
        let exact = |t: f64| Ok(free.attitude(t * turn).euler_angles().theta);
        panel.curve(Curve::sampled(times(0.0, end / turn, 12), exact, Ink::Ink)?.dots())
    };
}

/// The three swings, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let body = Cylinder::new(p)?;
    let end = 2.0 * body.swung(LetGo::All)?[1];
    let run = |what| motion(&body, what, end, p.tolerance);
    let (motor, clamp, all) = (run(LetGo::Motor)?, run(LetGo::Clamp)?, run(LetGo::All)?);
    let columns = "t [s], theta motor [rad], theta fork [rad], theta free [rad], phi' free [rad/s]";
    Trajectory::sampled(columns.split(", "), times(0.0, end, 200), |t| {
        let free = all.at(t)?;
        Ok([t, motor.at(t)?[0], clamp.at(t)?[0], free[0], free[3]])
    })
}

/// A fork that stands on the table and holds a cylinder by two pins along `x`.
fn fork(view: View, x: SpaceVector) -> View {
    let (wide, high) = (x * 0.46, UP * 0.82);
    let rods = |side: f64| {
        [
            (high + wide * side, wide * side - high),
            (wide * side, wide * (0.4 * side)),
            (high * side + wide, high * side - wide),
            (high * side, high * (1.17 * side)),
        ]
    };
    let rods = [rods(1.0), rods(-1.0)].concat().into_iter();
    rods.fold(view, |view, (from, to)| view.solid(Solid::rod(from, to, 0.022), Ink::Frame))
}

/// Held for a turn, then let go, with L and the angular velocity.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (body, turn, origin) = (Cylinder::new(p)?, TAU / p.rate.abs(), SpaceVector::zero());
    let (free, nod) = (body.freed()?, body.swung(LetGo::All)?[1]);
    let end = turn + 1.1 * nod;
    // The fork passes phi = 0 at the release.
    let held_at = move |t: f64| body.held(body.rate * t - TAU.copysign(body.rate));
    let attitude = move |t: f64| match t < turn {
        true => held_at(t),
        false => Ok(free.attitude(t - turn)),
    };
    let momentum = move |now: &Attitude| {
        let about = now.to_body(UP) * body.rate;
        now.to_space(BodyVector::new(body.i1 * about.x(), body.i1 * about.y(), body.i3 * about.z()))
    };
    let at_release = momentum(&body.held(0.0)?);
    let size = 1.0 / at_release.norm();
    let (radius, half) = (p.radius, 0.5 * p.height);
    let unit = 0.55 / half.max(radius);
    let seen = attitude.clone();
    let tilt = sampled(times(0.0, end, 240), |t| Ok((t, seen(t)?.euler_angles().theta)))?;
    let graph = Panel::over_axes("$t$ / s", Axis::angle(r"$\theta$ / rad"))
        .upright(turn, Ink::Frame, "let go")
        .curve(Curve::new(tilt, Ink::Body))
        .low();
    let stills = [0.68 * turn, turn + 0.25 * nod, turn + 0.5 * nod];
    MovingPicture::above(graph, 0.0..=end, stills, move |t| {
        let (now, held) = (attitude(t)?, t < turn);
        let axis = now.axis();
        let l = if held { momentum(&now) } else { at_release } * size;
        // I1 Omega = L - (I3 - I1) Omega_z z, and Omega_z stays.
        let along = body.rate * cos(body.tilt);
        let omega = (l * (1.0 / size) - axis * ((body.i3 - body.i1) * along))
            * (0.95 / (body.i1 * body.rate.abs()));
        // What goes round: the tip of L while it is held, that of the axis then.
        let tip =
            |t| Ok(if held { momentum(&held_at(t)?) * size } else { attitude(t)?.axis() * 0.95 });
        let (from, to, ink) =
            if held { (0.0, turn, Ink::Momentum) } else { (turn, turn + nod, Ink::Body) };
        let circle = sampled(times(from, to, 60), tip)?;
        let been = sampled(times((t - 0.7 * turn).max(from), t, 60), tip)?;
        // Above the fork, which would hide it.
        let (foot, long) =
            if held { (UP * 0.97_f64.copysign(body.rate), 0.38) } else { (origin, 1.0) };
        let cap = axis * (half * unit).max(0.02);
        let scene = View::of(UP * -0.01, 1.36)
            .size(340, 290)
            .table(UP * -0.95, 1.12)
            .corner(&format!("{t:.2} s"))
            .only_if(held, |view| fork(view, now.to_space(BodyVector::new(1.0, 0.0, 0.0))))
            .solid(Solid::cylinder(-cap, cap, radius * unit), Ink::Body)
            .dashed(circle, ink)
            .trail(been, ink)
            .arrow(cap, axis * 0.95, Ink::Body, "$z$", Side::Above)
            .vector(origin, l, Ink::Momentum, "$L$", Side::Left)
            .vector(foot, foot + omega * long, Ink::Velocity, r"$\Omega$", Side::Right);
        let tilt = now.euler_angles().theta.to_degrees();
        let points = ["up", "down"][usize::from(body.rate < 0.0)];
        let alt = match held {
            true => format!(
                "A cylinder in a fork that turns about the vertical, {t:.2} s after the start, its \
                 axis {tilt:.0} degrees from the vertical. Omega points {points}; L leans away from it, \
                 and its tip is on a dashed level circle. Below, the tilt against time."
            ),
            false => format!(
                "The fork is gone. The axis of the free cylinder, {tilt:.0} degrees from the \
                 vertical, is on a dashed circle about L, which stays. Below, the tilt against time."
            ),
        };
        Ok((alt, scene))
    })
}
