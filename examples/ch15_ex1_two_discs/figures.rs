//! The drawings of exercise 15.1.

use super::*;
use rotation_dynamics::planar::contact::MechanismState;

/// Two discs on an axle, the upper one so high above the lower, turned by these angles.
fn discs(height: f64, [upper, lower]: [f64; 2]) -> View {
    let up = SpaceVector::new(0.0, 0.0, 1.0);
    let level = |angle: f64| SpaceVector::new(cos(angle), sin(angle), 0.0);
    let (at, top) = (|z: f64| up * z, 0.24 + height);
    let mark = at(top + 0.101);
    View::of(at(0.45), 1.2)
        .size(340, 250)
        .solid(Solid::rod(at(top + 0.1), at(1.35), 0.025), Ink::Frame)
        .solid(Solid::rod(at(0.1), at(0.11 + height), 0.025), Ink::Frame)
        .solid(Solid::disc(at(0.0), up, 1.0, 0.2), Ink::Body)
        .solid(Solid::disc(at(top), up, 0.85, 0.2), Ink::Body)
        .line([mark, mark + level(upper) * 0.84], Ink::Ink)
        .line([level(lower) + at(0.1), level(lower) - at(0.1)], Ink::Ink)
}

/// Until `end` after a release, and none where the rates jump, at the impact.
fn instants(hit: f64, time: f64, end: f64) -> impl Iterator<Item = f64> {
    let (before, after) = (hit - 1e-6 * time, hit + 1e-6 * time);
    times(0.0, before.max(0.0), 2).chain(times(after, end, 60))
}

/// An arrow about the axis at this height, so long (rad), and its label.
fn turning(view: View, z: f64, radius: f64, angle: f64, label: &str) -> View {
    let place = |a: f64| SpaceVector::new(radius * cos(a), radius * sin(a), z);
    let (from, to) = (0.55 - 0.5 * angle, 0.55 + 0.5 * angle);
    let view = view.turn(times(from, to, 40).map(place), Ink::Velocity);
    view.text(place(to), label, Ink::Velocity, Side::Below)
}

figures! { p: &Parameters, a = Answer::new(p);
    /// Two thick discs on one upright axle, the upper one a little above the lower. An arrow shows that the
    /// upper disc turns counterclockwise seen from above at Omega 1, another that the lower one turns clockwise
    /// at Omega 2.
    setup: {
        let view = turning(discs(0.55, [0.9, 0.2]), 0.8, 0.98, 1.3, r"$\Omega_1$");
        turning(view, 0.0, 1.13, -0.9, r"$\Omega_2$")
            .text(SpaceVector::new(-0.3, 1.0, 0.85), "$I_1$", Ink::Body, Side::Right)
            .text(SpaceVector::new(-0.3, 1.15, 0.05), "$I_2$", Ink::Body, Side::Right)
    };

    /// The slip, as a part of the first one, against time over that of dry friction. Dry: a straight line that
    /// ends at one. Weaker at high speed: a line that bends down and ends a little earlier. Oil: a curve that
    /// comes down ever more slowly and never ends.
    laws: {
        let p = &p.but(|p| p.tolerance = 1e-9);
        let slip = |law: &'static str, left: f64, end: f64| {
            let run = rubbed(p, left, |w| torque(p, law, w))?;
            sampled(times(0.0, run.end_time().min(end * a.time), 100), |t| {
                let [fast, slow, _] = run.at(t)?;
                Ok((t / a.time, (fast - slow) / a.relative))
            })
        };
        let (dry, weak, oil) = (slip("dry", 0.0, 1.0)?, slip("weakening", 0.0, 1.0)?, slip("oil", 1e-3, 3.0)?);
        Panel::over_axes(Axis::linear("$t/T$").range(0.0, 3.0), Axis::linear("slip, over the first").range(0.0, 1.0))
            .curve(Curve::new(dry, Ink::Ink).label_at("dry", 0.8, 0.2, Side::AboveRight))
            .curve(Curve::new(weak, Ink::Body).label_at("weakening", 0.3, 0.6, Side::BelowLeft))
            .curve(Curve::new(oil, Ink::Frame).dashed().label_at("oil", 1.6, 0.2, Side::AboveRight))
    };

    /// The slip against time from the release. Dropped from no height it falls on a straight line to zero.
    /// Dropped from higher up it stays level, falls at once at the impact onto the same line, and goes on along
    /// it.
    fall: {
        let slip = |part: f64, ink| {
            let drop = part * p.gravity * a.time * a.time;
            let (run, hit) = (fallen(&p.but(|p| p.drop = drop), 0.0, 2.0, 1e-9)?, (2.0 * part).sqrt() * a.time);
            let curve = Curve::sampled(instants(hit, a.time, 1.2 * a.time), |t| Ok(run.at(t)?.v[1] - run.at(t)?.v[2]), ink)?;
            Ok::<_, kit::Error>((curve, hit, format!("from {drop:.1} m")))
        };
        let ((plain, ..), (fallen, hit, height)) = (slip(0.0, Ink::Ink)?, slip(0.08, Ink::Body)?);
        Panel::over_axes(Axis::linear("$t$ / s from the release"), Axis::linear("slip / rad/s").over([0.0, a.relative]))
            .curve(plain.label_at("without a fall", 0.45 * a.time, 0.55 * a.relative, Side::BelowLeft))
            .curve(fallen.dashed().label_at(&height, hit, a.relative * (1.0 - 0.4 * hit / a.time), Side::Right))
    };

    /// The slip near the time at which it ends. Located: a line that reaches zero and stays there. With the
    /// sign of the slip and equal steps: it jumps from one side of zero to the other at every step.
    chatter: {
        let slips = chattering(p, 301, 2.0 * a.time).into_iter().map(|(t, w)| (t / a.time, w));
        let wrong = slips.filter(|(t, _)| (0.95..1.1).contains(t));
        let right = times(0.95, 1.1, 301).map(|t| (t, a.relative * (1.0 - t).max(0.0)));
        Panel::over_axes("$t/T$", Axis::linear("slip / rad/s").over([-0.02 * a.relative, 0.05 * a.relative]))
            .curve(Curve::new(right, Ink::Ink).label_at("stick located", 0.97, 0.03 * a.relative, Side::AboveRight))
            .curve(Curve::new(wrong, Ink::Wrong).dashed().label_at("wrong: sign of the slip", 1.05, 0.004 * a.relative, Side::Above))
    };
}

/// The motion from the release, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let run = fallen(p, 0.0, 2.0, p.tolerance)?;
    let columns = "t [s], height [m], Omega1 [rad/s], Omega2 [rad/s], T [J]";
    Trajectory::sampled(columns.split(", "), times(0.0, run.end_time(), 400), |t| {
        let MechanismState { q, v } = run.at(t)?;
        Ok([t, q[0], v[1], v[2], kinetic_energy(p, [v[1], v[2]])])
    })
}

/// The discs from the release on, a twentieth as fast; below, the two rates.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (a, run) = (Answer::new(p), fallen(p, 0.0, 2.0, 1e-9)?);
    let (hit, end) = ((2.0 * p.drop / p.gravity).sqrt(), 1.3 * a.time);
    let curve = |k: usize, name: &str, first: f64, side: Side| {
        let all = instants(hit, a.time, end);
        let curve = Curve::sampled(all, |t| Ok(run.at(t)?.v[k]), Ink::Velocity)?;
        let (t, rate) = (0.4 * a.time, a.common + 0.6 * (first - a.common));
        Ok::<_, kit::Error>(curve.label_at(name, t, rate, side))
    };
    let graph = Panel::over_axes("$t$ / s", r"$\Omega$ / rad/s")
        .level(a.common, Ink::Frame, "")
        .curve(curve(1, "upper", p.upper_rate, Side::AboveRight)?)
        .curve(curve(2, "lower", p.lower_rate, Side::BelowRight)?.dashed());
    let (drop, largest, stills) = (p.drop, rate(p), [0.0, 0.55 * a.time, end]);
    MovingPicture::above(graph, 0.0..=end, stills, move |t| {
        let MechanismState { q, v: [_, upper, lower] } = run.at(t)?;
        let so = if t < a.time { "" } else { ", as one body" };
        let alt = format!(
            "{t:.2} s after the release the upper disc turns at {upper:.1} rad/s and the lower one at {lower:.1} \
             rad/s{so}. Below, both rates against time."
        );
        let height = 0.5 * q[0].max(0.0) / drop.max(1e-9);
        let view = discs(height, [q[1], q[2]].map(|turn| (0.05 * turn) % TAU));
        let arrow = |view: View, z, r, w: f64, label| {
            let shown = (w / largest).abs() > 0.02;
            view.only_if(shown, |view| turning(view, z, r, 1.6 * w / largest, label))
        };
        let view = arrow(view, 0.24 + height, 0.98, upper, r"$\Omega_1$");
        Ok((alt, arrow(view, 0.0, 1.13, lower, r"$\Omega_2$")))
    })
}
