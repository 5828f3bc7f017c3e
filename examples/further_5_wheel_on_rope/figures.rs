//! The drawings of the wheel on a rope.

use super::*;

/// Over the spin, a level axle.
fn spins() -> Sweep {
    Sweep::over("spin / (rad/s)", 2.0, 25.0).at([2.6, 4.0, 5.5, 7.0, 9.0, 12.0, 16.0, 22.0])
}

/// The wheel with another spin.
fn spun(p: &Parameters, spin: f64) -> Wheel {
    Wheel::new(&p.but(|p| p.spin = spin))
}

/// The points of a line where there is something to be computed.
fn found(at: impl IntoIterator<Item = f64>, y: impl Fn(f64) -> Result<f64>) -> Vec<(f64, f64)> {
    at.into_iter().filter_map(|x| Some((x, y(x).ok()?))).collect()
}

/// Time of the moving picture, s.
const END: f64 = 12.0;

/// The wheel let go at rest.
fn run(p: &Parameters) -> Result<Solution<12>> {
    Wheel::new(p).let_go(p.push, END, p.tolerance)
}

figures! { p: &Parameters, wheel = Wheel::new(p), let_go = run(p)?;
    /// A rope of length b hangs from the point O of a ceiling and leans outward by delta. At its lower end A begins the axle,
    /// which rises outward by beta; the hub C of the wheel, seen edge on, is at the distance l from A. The spin L points
    /// outward along the axle.
    setup: {
        let ((sd, cd), (sb, cb)) = (sincos(0.22), sincos(0.3));
        let (o, a) = ((0.0, 0.0), (sd, -cd));
        let along = |s: f64, across: f64| (a.0 + s * cb - across * sb, a.1 + s * sb + across * cb);
        let (c, tip) = (along(0.42, 0.0), along(0.95, 0.0));
        let rim = [(0.39, -0.4), (0.45, -0.4), (0.45, 0.4), (0.39, 0.4)];
        Sketch::within((-0.45, 1.35), (-1.5, 0.16))
            .wall((0.4, 0.0), (-0.4, 0.0))
            .guide([o, (0.0, -1.4)])
            .angle(o, 0.5, (-FRAC_PI_2, 0.22 - FRAC_PI_2), r"$\delta$")
            .string(o, a, "$b$", Side::Right)
            .guide([a, (a.0 + 0.95, a.1)])
            .angle(a, 0.7, (0.0, 0.3), r"$\beta$")
            .body(rim.map(|(s, h)| along(s, h)), Ink::Body, 0.35)
            .curve(Curve::new([a, c], Ink::Ink).width(3.0))
            .arrow(c, tip, Ink::Momentum, "", Side::Above)
            .text(tip, "$L$", Ink::Momentum, Side::Above)
            .dot(a, Ink::Ink, "$A$", Side::BelowLeft)
            .dot(c, Ink::Ink, "$C$", Side::BelowRight)
            .text(along(0.2, 0.05), "$l$", Ink::Ink, Side::Above)
            .text(o, "$O$", Ink::Frame, Side::AboveLeft)
            .gravity((-0.33, -0.35), 0.3)
            .arrow_along(times(3.5, 5.9, 40).map(|a| (0.17 * cos(a), 0.05 * sin(a) - 1.3)), Ink::Velocity)
            .text((0.19, -1.32), "$p$", Ink::Velocity, Side::Right)
    };

    /// Angle of the rope against the spin, for a level axle. With a fast spin it is nearly zero; with a slow one it rises
    /// steeply. Where the spin is slow there is a second line below zero. Simulated dots lie on both.
    rope_angle: {
        let outward = |spin: f64| spun(p, spin).steady(0.0).map_or(f64::NAN, |s| s[1]);
        let inward = |spin: f64| spun(p, spin).inward().map(|q| (spin, asin(q[0])));
        let below = times(2.0, 10.0, 400).filter_map(inward);
        let simulated = |spin: f64| Ok(after_a_while(spun(p, spin), 0.0, 1e-12)?[1]);
        let kept = |spin: f64| {
            let wheel = spun(p, spin);
            let start = wheel.in_space(&wheel.inward()?);
            Some((spin, angles(&after(3.0, &wheel.hung(), &start, 1e-12).ok()?)[0]))
        };
        spins().panel(Axis::linear(r"$\delta$ / rad").range(-0.4, 1.6))
            .level(0.0, Ink::Frame, "")
            .curve(spins().exact(outward).label_at("outward", 6.5, 0.4, Side::Right))
            .curve(Curve::new(below, Ink::Ink).label_at("inward", 5.1, -0.28, Side::Right))
            .curve(spins().simulated(simulated)?)
            .curve(Curve::new([2.4, 3.4, 4.4].into_iter().filter_map(kept), Ink::Body).dots())
    };

    /// Rate of steady precession over that of the lecture against the rise of the axle, for two spins. Both pass through 1 at a
    /// level axle and grow with the rise, the slower the spin the more.
    rates: {
        let panel = Panel::over_axes(r"rise $\beta$ / rad", Axis::linear("$p/p_0$").range(0.92, 1.1));
        [(12.0, 0.55), (20.0, 1.0)].into_iter().try_fold(panel, |panel, (spin, at)| {
            let wheel = spun(p, spin);
            let ratio = |rise: f64| Ok(wheel.steady(rise)?[0] / wheel.lecture());
            let line = Curve::new(found(times(-1.1, 1.1, 160), ratio), Ink::Ink);
            let dots = found([-0.8, -0.3, 0.3, 0.8], |rise| {
                Ok(after_a_while(wheel, rise, 1e-12)?[0] / wheel.lecture())
            });
            let label = format!("{spin} rad/s");
            Ok::<_, kit::Error>(panel
                .curve(line.label_at(&label, at, ratio(at).unwrap_or(1.0), if spin > 15.0 { Side::Below } else { Side::Left }))
                .curve(Curve::new(dots, Ink::Body).dots()))
        })?
    };

    /// The three frequencies against the spin. The nutation grows in proportion to it. The two of the rope lie on either side
    /// of its own; at slow spin they part.
    modes: {
        let frequency = |spin: f64, k: usize| {
            let wheel = spun(p, spin);
            Ok(wheel.modes(wheel.going(0.0)?)?[k].frequency)
        };
        let simulated = |spin: f64, k: usize| {
            let wheel = spun(p, spin);
            let rest = wheel.going(0.0)?;
            measured(wheel, rest, &wheel.modes(rest)?[k], k == 2)
        };
        let panel = Panel::over_axes("spin / (rad/s)", Axis::log("angular frequency / (rad/s)").range(0.4, 50.0));
        [("slow swing", 19.0, Side::Below), ("fast swing", 19.0, Side::Above), ("nutation", 15.0, Side::AboveLeft)]
            .into_iter().zip(0..).try_fold(panel, |panel, ((label, at, side), k)| {
                let line = Curve::new(found(times(6.0, 25.0, 120), |spin| frequency(spin, k)), Ink::Ink);
                let dots = found([7.0, 10.0, 14.0, 21.0], |spin| simulated(spin, k));
                let label = line.label_at(label, at, frequency(at, k).unwrap_or(1.0), side);
                Ok::<_, kit::Error>(panel.curve(label).curve(Curve::new(dots, Ink::Body).dots()))
            })?
    };

    /// Rise of the axle against time after it is let go at rest: small fast waves below zero. On a fixed pivot, dashed, they
    /// are slower and deeper.
    nods: {
        let (i, l) = (wheel.at_end(), wheel.momentum);
        let deep = wheel.mass * wheel.gravity * wheel.lever * i / (l * l);
        let fixed = |t: f64| -deep * (1.0 - cos(l / i * t));
        let rise = |t: f64| Ok(angles(&let_go.at(t)?)[1]);
        let end = let_go.end_time().min(1.2);
        Panel::over_axes("$t$ / s", Axis::linear(r"rise $\beta$ / rad").range(-0.16, 0.0))
            .level(0.0, Ink::Frame, "")
            .curve(Curve::of(times(0.0, end, 300), fixed, Ink::Frame).dashed().label_at("fixed pivot", 0.55, -0.132, Side::Below))
            .curve(Curve::sampled(times(0.0, end, 300), rise, Ink::Body)?.label_at("on the rope", 0.92, -0.028, Side::Above))
    };

    /// The path of the centre of mass, seen from above: it creeps at first, then goes round in a ring. Dots of the linear
    /// theory lie near the simulated line, less so at the end.
    above: {
        let end = let_go.end_time().min(2.0 * PI / wheel.lecture().abs());
        let at = |t: f64| Ok::<_, rotation_dynamics::Error>(from_above(&wheel, &let_go.at(t)?));
        let centre = sampled(times(0.0, end, 500), |t| Ok(at(t)?[0]))?;
        let hook = sampled(times(0.0, end, 900), |t| Ok(at(t)?[1]))?;
        let theory = times(0.0, end, 24).map(|t| drawn_round(&wheel, t));
        Panel::over_axes("$x$ / m", "$y$ / m").equal_aspect()
            .curve(Curve::new(theory, Ink::Ink).dots())
            .curve(Curve::new(centre, Ink::Body).arrow(0.2).label("$C$"))
            .curve(Curve::new(hook, Ink::Frame).label("$A$"))
    };

    /// Tension over the weight against time. Let go at rest it waves about one. Pushed forward too fast it begins above two,
    /// falls to zero at the top of the first nod, and there the line ends.
    tension: {
        let pull = |push: f64, label: &str, at: (f64, f64, Side)| {
            let run = wheel.let_go(push, 0.8, 1e-12)?;
            let pull = |t: f64| Ok(wheel.tension(&place(&run.at(t)?)) / (wheel.mass * wheel.gravity));
            let curve = Curve::sampled(times(0.0, run.end_time(), 300), pull, Ink::Force)?;
            Ok::<_, kit::Error>(curve.label_at(label, at.0, at.1, at.2))
        };
        Panel::over_axes(Axis::linear("$t$ / s").range(0.0, 0.8), Axis::linear("$T/mg$").range(0.0, 2.4))
            .curve(pull(0.0, "let go at rest", (0.55, 1.3, Side::Above))?)
            .curve(pull(1.1 * wheel.forward(), "pushed forward", (0.06, 2.0, Side::Right))?)
            .level(1.0, Ink::Frame, "")
    };
}

/// The motion, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let wheel = Wheel::new(p);
    let columns = "t [s], rope [rad], rise [rad], tension [N], x_C [m], y_C [m]";
    Trajectory::of(&run(p)?, columns.split(", "), 1200, |t, y| {
        let ([rope, rise], [(x, y_c), _]) = (angles(&y), from_above(&wheel, &y));
        [t, rope, rise, wheel.tension(&place(&y)), x, y_c]
    })
}

/// The wheel let go, with its rope.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (wheel, run) = (Wheel::new(p), run(p)?);
    let end = run.end_time();
    let lean = move |y: &[f64; 12]| {
        let [r, _] = place(y).rope;
        atan2(hypot(r.x(), r.y()), -r.z())
    };
    let graph = Panel::over_axes("$t$ / s", "rope / rad").curve(Curve::sampled(
        times(0.0, end, 600),
        |t| Ok(lean(&run.at(t)?)),
        Ink::Body,
    )?);
    let (b, radius, size, spin) = (wheel.rope, p.radius, wheel.lever + p.radius, p.spin);
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.2 * end, 0.7 * end], move |t| {
        let state = run.at(t.min(end))?;
        let Place { rope: [r, _], axle: [e, _] } = place(&state);
        let (hook, top) = (r * b, 1.5 * size - b);
        let hub = hook + e * wheel.lever;
        let torque = e.cross(&r) * (0.7 * size);
        let tip = hub + e * (1.3 * size * wheel.momentum.signum());
        let alt = format!(
            "The wheel {t:.1} s after it is let go, on its rope, which goes on upward and is {:.1} degrees off the \
             vertical; the axle rises by {:.1} degrees. Below, the rope's angle against time.",
            lean(&state).to_degrees(),
            angles(&state)[1].to_degrees()
        );
        let path = sampled(times((t - 1.5).max(0.0), t.min(end), 60), |t| {
            let Place { rope: [r, _], axle: [e, _] } = place(&run.at(t)?);
            Ok(r * b + e * wheel.lever)
        })?;
        let scene = View::of(below(b - 0.2 * size), 1.5 * size)
            .dashed([cut(below(b), top), below(b + 0.6 * size)], Ink::Frame)
            .line([cut(hook, top), hook], Ink::Ink)
            .dashed(path, Ink::Body)
            .solid(Solid::rod(hook, hub, 0.02 * size), Ink::Frame)
            .solid(Solid::wheel(hub, e, radius, 0.1 * size, spin * t), Ink::Body)
            .arrow(hub, tip, Ink::Momentum, "$L$", Side::Right)
            .arrow(tip, tip + torque, Ink::Force, "torque", Side::Below);
        Ok((alt, scene))
    })
}

/// So far below the support.
fn below(depth: f64) -> SpaceVector {
    SpaceVector::new(0.0, 0.0, -depth)
}

/// Where the rope to this end passes the height `top`, or the support if that is lower.
fn cut(hook: SpaceVector, top: f64) -> SpaceVector {
    if top >= 0.0 { SpaceVector::zero() } else { hook * (top / hook.z()) }
}
