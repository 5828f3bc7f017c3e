//! The drawings of the yo-yo, seen along the axis; lengths in the radius of the satellite.

use super::*;

/// The satellite with both strings in this state: what is wound, the free parts, the weights.
fn drawn(mut sketch: Sketch, yoyo: &YoYo, state: &[f64; 4], dot: f64) -> Sketch {
    let ([angle, unwound, ..], [[x, y], _]) = (*state, yoyo.weight(state));
    sketch = sketch.roller((0.0, 0.0), 1.0, angle, Ink::Body);
    for side in [1.0, -1.0] {
        let rim = |t: f64| (side * cos(t), side * sin(t));
        let (from, hook) = (angle + unwound.min(yoyo.length), angle + yoyo.length);
        let wound = times(from, hook.min(from + 6.2), 90).map(rim);
        sketch = sketch
            .only_if(hook > from, |sketch| sketch.curve(Curve::new(wound, Ink::Ink)))
            .string(rim(from), (side * x, side * y), "", Side::Left)
            .dot(rim(hook), Ink::Ink, "", Side::Left)
            .weight((side * x, side * y), dot, "");
    }
    sketch
}

/// The strings of the figures.
const USUAL: YoYo = YoYo { inertia: 80.0, length: 6.0 };

figures! { p: &Parameters, run = USUAL.run(1e-12)?;
    /// A round satellite of the radius R from above, which turns counterclockwise with omega0. Two strings lie on its rim,
    /// hooked to it at opposite points. Their other ends, with the weights m, have just left the rim: each free part is a
    /// tangent, and points backward, against the rotation, from the point where it leaves.
    setup: {
        let yoyo = YoYo { inertia: 80.0, length: 2.6 };
        let sketch = Sketch::within((-2.1, 2.1), (-1.75, 1.75));
        drawn(sketch, &yoyo, &[0.35, 0.95, 1.0, 2.0], 0.09)
            .turn((0.0, 0.0), 0.55, (1.0, 2.6), Ink::Velocity)
            .text((0.0, 0.62), r"$\omega_0$", Ink::Velocity, Side::Above)
            .dimension((0.0, 0.0), (cos(-0.9), sin(-0.9)), "$R$", Side::Right)
            .text((1.3, 0.72), "$m$", Ink::Body, Side::Right)
            .text((-1.3, -0.72), "$m$", Ink::Body, Side::Left)
            .text((cos(2.95), sin(2.95)), "hook", Ink::Frame, Side::Left)
            .text((cos(2.95 - PI), sin(2.95 - PI)), "hook", Ink::Frame, Side::Right)
    };

    /// One string, of the length l, on the tangent. The weight has two velocities at right angles: one along the string, as
    /// large as that of the rim, omega R, and a larger one across it, outward, l times the angular velocity of the string. The
    /// string pulls the rim backward.
    velocities: {
        let (l, w) = (2.2, 0.65);
        let (touch, end) = ((0.0, 1.0), (l, 1.0));
        Sketch::within((-1.5, 3.6), (-1.3, 3.1))
            .disc((0.0, 0.0), 1.0, Ink::Body, 0.15)
            .guide([(0.0, 0.0), touch])
            .string(touch, end, "$l$", Side::Below)
            .right_angle(touch, (0.0, 0.0), end)
            .arrow(end, (l - w, 1.0), Ink::Velocity, "", Side::Above)
            .text((l - w, 1.05), r"$\omega R$", Ink::Velocity, Side::Above)
            .arrow(end, (l, 2.6), Ink::Velocity, r"$l\Omega$", Side::Right)
            .arrow(touch, (0.8, 1.0), Ink::Force, "", Side::Above)
            .text((0.7, 1.05), "$T$", Ink::Force, Side::Above)
            .turn((0.0, 0.0), 0.6, (2.2, 3.7), Ink::Velocity)
            .text((-0.62, 0.1), r"$\omega$", Ink::Velocity, Side::Left)
            .text((0.0, 0.45), "$R$", Ink::Frame, Side::Right)
            .weight(end, 0.1, "$m$")
    };

    /// Spin after the release over that before against the length of the strings over R. Let go along the tangent it falls from
    /// one through zero at nine and on to negative values. Let go outward it lies below and passes zero at eight. Rigid arms
    /// come near zero only slowly.
    spins: {
        let a = Answer { inertia: 80.0 };
        let lengths = Sweep::over("$l/R$", 0.0, 12.0).at([0.7, 2.0, 3.5, 5.0, 6.5, 8.0, 9.5, 11.0]);
        let arms = |l: f64| 81.0 / (80.0 + (1.0 + l) * (1.0 + l));
        let with = |length| YoYo { length, ..USUAL };
        lengths.panel(Axis::linear(r"$\omega/\omega_0$").range(-0.4, 1.0))
            .level(0.0, Ink::Frame, "")
            .curve(lengths.exact(|l| a.spin_tangent(l)).label_at("tangent", 5.7, 0.44, Side::Right))
            .curve(lengths.exact(|l| a.spin_outward(l)).label_at("outward", 5.0, 0.2, Side::Left))
            .curve(Curve::of(times(0.0, 12.0, 120), arms, Ink::Velocity).dashed().label_at("wrong: rigid arms", 7.2, 0.68, Side::Right))
            .curve(lengths.simulated(|l| Ok(with(l).run(1e-9)?.transition("unwound")?.before[2]))?)
            .curve(lengths.simulated(|l| Ok(with(l).last_spin(1e-9)?))?)
    };

    /// Pull of a string over 2 m w0^2 R against the time in 1/w0. It rises from zero, is nearly level for the second half of
    /// the unwinding, at nearly six, and changes little on the hook.
    tension: {
        let end = run.transition("unwound")?.t;
        let pull = |t: f64| run.at(t).map(|(hangs, y)| USUAL.tension(hangs, &y)).map_err(Into::into);
        let a = Answer { inertia: 80.0 };
        Panel::over_axes(r"$\omega_0t$", Axis::linear(r"$T/2m\omega_0^2R$").range(0.0, 7.0))
            .upright(end, Ink::Frame, "unwound")
            .curve(Curve::of(times(0.0, end, 100), |t| a.tension(t), Ink::Ink))
            .curve(Curve::sampled(times(end, run.end_time(), 40), pull, Ink::Force)?)
            .curve(Curve::sampled(times(0.4, end, 12), pull, Ink::Force)?.dots().label_at("simulated", 2.2, 2.6, Side::Right))
    };

    /// Spin that is left against the spin before, for strings made for 1 rad/s. Without a spring a straight line through the
    /// origin. With a spring a flat bow that touches 1 rad/s.
    springs: {
        let (sprung, w, a) = (sprung(p), p.spin, scene(p)?.1);
        let rigid = a.spin_outward(a.length_outward(p.aim / w));
        let [from, to] = ordered([0.7 * w, 1.3 * w]);
        let before = Sweep::over(r"$\omega_0$ / (rad/s)", from, to).at(times(0.72 * w, 1.28 * w, 8));
        let [low, high] = ordered([0.6 * p.aim, 1.4 * p.aim + 1e-3 * w]);
        let left = Axis::linear(r"$\omega$ / (rad/s)").range(low, high);
        let panel = before.panel(left)
            .curve(before.exact(|w0| rigid * w0).label_at("rigid", 0.8 * w, 0.72 * p.aim, Side::Right));
        match sprung {
            Ok(sprung) => panel.curve(before.simulated(|w0| Ok(w * sprung.last(w0 / w, 1e-9)?[0]))?
                .label_at("with springs", 0.9 * w, 1.05 * p.aim, Side::Above)),
            Err(_) => panel,
        }
    };
}

/// The motion for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (yoyo, _) = scene(p)?;
    let (run, w, r, newton) = (yoyo.run(p.tolerance)?, p.spin, p.radius, newton(p));
    let columns =
        "t [s], turned by [rad], spin [rad/s], x of a weight [m], y of a weight [m], T [N]";
    Trajectory::sampled(columns.split(", "), times(0.0, run.end_time(), 600), |t| {
        let (hangs, y) = run.at(t)?;
        let ([[px, py], _], pull) = (yoyo.weight(&y), newton * yoyo.tension(hangs, &y));
        Ok([t / w.abs(), y[0] * w.signum(), y[2] * w, px * r, py * r * w.signum(), pull])
    })
}

/// Unwinding, turning on the hooks, and the weights on their way; below, the spin.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (yoyo, w, rate) = (scene(p)?.0, p.spin, p.spin.abs());
    let run = yoyo.run(p.tolerance)?;
    let (end, out) = (run.transition("unwound")?.t, run.transition("outward")?.before);
    let (free, [[x, y], [vx, vy]]) = (run.end_time(), yoyo.weight(&out));
    let far = 1.0 + yoyo.length;
    let last = free + 0.45 * far / hypot(vx, vy);
    let spin = |t: f64| Ok((t / rate, w * if t < free { run.at(t)?.1[2] } else { out[2] }));
    let [low, high] = ordered([w * out[2].min(0.0), w]);
    let graph = Panel::over_axes("$t$ / s", Axis::linear(r"$\omega$ / (rad/s)").range(low, high))
        .curve(Curve::new(sampled(times(0.0, last, 300), spin)?, Ink::Velocity));
    let stills = [0.5 * end, 0.5 * (end + free), 0.5 * (free + last)].map(|t| t / rate);
    let wide = 1.3 * far;
    // Turned the other way, all is seen from below.
    let falls = if w > 0.0 { "falls" } else { "rises" };
    MovingPicture::above(graph, 0.0..=last / rate, stills, move |t| {
        let now = (t * rate).min(last);
        let (hangs, state) = run.at(now.min(free))?;
        let path = sampled(times(0.0, now.min(free), 200), |t| Ok(yoyo.weight(&run.at(t)?.1)[0]))?;
        let mut sketch = Sketch::within((-wide, wide), (-wide, wide));
        for side in [1.0, -1.0] {
            sketch = sketch.guide(path.iter().map(|[x, y]| (side * x, side * y)));
        }
        let flown = now - free;
        let does = if flown > 0.0 {
            let turned = [out[0] + flown * out[2], 0.0, 0.0, 0.0];
            sketch = sketch.roller((0.0, 0.0), 1.0, turned[0], Ink::Body);
            for side in [1.0, -1.0] {
                let at = (side * (x + vx * flown), side * (y + vy * flown));
                sketch = sketch.guide([(side * x, side * y), at]).weight(at, 0.03 * far, "");
            }
            "the strings have let go, and the weights fly on"
        } else {
            sketch = drawn(sketch, &yoyo, &state, 0.03 * far);
            match hangs {
                Hangs::Tangent => "the strings unwind along tangents",
                Hangs::Hook => "the strings are unwound and turn on their hooks",
            }
        };
        let alt = format!(
            "After {t:.2} s {does}; the satellite turns with {:.2} rad/s. Below, its spin against time: \
             it {falls} faster and faster, then evenly, \
             and levels off where the strings let go.",
            w * state[2]
        );
        Ok((alt, sketch))
    })
}

/// The smaller one first.
fn ordered([a, b]: [f64; 2]) -> [f64; 2] {
    [a.min(b), a.max(b)]
}
