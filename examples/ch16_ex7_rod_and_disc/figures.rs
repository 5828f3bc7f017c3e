//! The drawings of exercise 16.7.

use super::*;
use rotation_dynamics::integrators::Event;

/// The pendulum with its pivot here and a rod of length 1, its disc of this radius with a spoke
/// that points straight down where `disc` = 0.
fn drawn(sketch: Sketch, x: f64, radius: f64, [rod, disc]: [f64; 2]) -> Sketch {
    let ((s, c), top) = (sincos(rod), (x, 0.0));
    let end = (x + s, -c);
    sketch.bar(top, end, 0.035, Ink::Ink).roller(end, radius, disc - FRAC_PI_2, Ink::Body)
}

/// Where it was at the release, faintly, on the way, and now.
fn strobe(disc: impl Fn(f64) -> f64) -> Sketch {
    let path = times(-1.15, 1.15, 60).map(|a| (sin(a), -cos(a)));
    let empty = Sketch::within((-1.3, 1.3), (-1.32, 0.24)).guide(path);
    let all = [1.0, 0.5, 0.0, -0.5, -1.0].into_iter().fold(empty, |sketch, a: f64| {
        let draw = |sketch| drawn(sketch, 0.0, 0.2, [a, disc(a)]);
        if a.abs() == 1.0 { draw(sketch) } else { sketch.ghost(draw) }
    });
    all.pivot((0.0, 0.0), FRAC_PI_2)
}

/// Over the friction, and simulated for some, for this share of the disc.
fn frictions(
    y: Axis,
    label: [&str; 2],
    of: impl Fn(Between) -> f64,
    seen: impl Fn([f64; 2]) -> f64,
    share: f64,
) -> Result<Panel> {
    let drags = |n| times(-2.0, 2.0, n).map(|e| pow(10.0, e));
    let exact = Curve::of(drags(120), |x| of(Between::new(share, x)), Ink::Ink);
    let simulated = Curve::sampled(drags(8), |x| Ok(seen(measured(share, x)?)), Ink::Body)?;
    let x = Axis::log("$c/JW$").range(1e-2, 1e2);
    let late = seen(measured(share, 10.0)?);
    Ok(Panel::over_axes(x, y)
        .curve(exact.label_at(label[0], 0.1, of(Between::new(share, 0.1)), Side::Left))
        .curve(simulated.dots().label_at(label[1], 10.0, late, Side::Right)))
}

/// Amplitudes of a swing from one radian, turning point by turning point, over the number of
/// small swings since.
fn amplitudes(share: f64, drag: f64) -> Result<Vec<(f64, f64)>> {
    let turns = Event::falling("turns", |_, y: &[f64; 4]| y[1]);
    let (scene, start) = (two_angles(share, drag), at_rest(1.0));
    let run = Dop853::new(1e-12)?.solve(&scene, 0.0, &start, 120.0 * PI, &[turns])?;
    let each = run.events().iter().map(|turn| (turn.t / (2.0 * PI), turn.state[0]));
    Ok(core::iter::once((0.0, 1.0)).chain(each).step_by(4).collect())
}

figures! { p: &Parameters, m = Moments::new(p)?, felt = m.share.clamp(1e-8, 1.0);
    /// A rod of length l and mass m hangs on the pivot O and makes the angle theta with the vertical. Its lower
    /// end carries the centre of a disc of mass M and radius R, whose plane is that of the swing. A spoke is
    /// drawn on the disc.
    setup: {
        let (s, c) = sincos(0.5);
        let rim = (s + 0.2 * cos(0.3), -c + 0.2 * sin(0.3));
        drawn(Sketch::within((-0.5, 1.0), (-1.2, 0.25)), 0.0, 0.2, [0.5, 0.5])
            .guide([(0.0, 0.0), (0.0, -1.1)])
            .pivot((0.0, 0.0), FRAC_PI_2)
            .text((-0.04, 0.03), "$O$", Ink::Frame, Side::Left)
            .angle((0.0, 0.0), 0.36, (-FRAC_PI_2, 0.5 - FRAC_PI_2), r"$\theta$")
            .text((0.5 * s, -0.5 * c), "$l$, $m$", Ink::Ink, Side::Right)
            .curve(Curve::new([(s, -c), rim], Ink::Ink).thin())
            .text(rim, "$R$", Ink::Ink, Side::Right).text((s, -c - 0.2), "$M$", Ink::Body, Side::Below)
            .gravity((-0.35, -0.3), 0.3)
    };

    /// The pendulum at the release on the right, on the left where it turns back, and faintly at three places
    /// between. The spoke of the disc is in line with the rod at each.
    fixed: strobe(|rod| rod);

    /// The same places. The spoke of the disc keeps its direction, that of the release.
    free: strobe(|_| 1.0);

    /// Both periods of small swings, over that of a weight on a string of the same length, against the radius
    /// of the disc. They begin at the same value, a little below one. The line for the free disc is level, that
    /// for the fixed one rises, faster and faster.
    radii: {
        let of = |x: f64| Moments::new(&p.but(|p| p.radius = x * p.length));
        let unit = |m: &Moments| m.rate() * (p.length / p.gravity).sqrt();
        let fixed = |x| of(x).map_or(f64::NAN, |m| (1.0 + m.share).sqrt() / unit(&m));
        let stiff = |x| of(x).and_then(|m| Ok((small_rate(&one_angle(m.share))? * unit(&m)).recip()));
        let loose = |x| of(x).and_then(|m| Ok((small_rate(&two_angles(m.share, 0.0))? * unit(&m)).recip()));
        let radius = Sweep::over("$R/l$", 0.01, 1.0).at([0.1, 0.25, 0.4, 0.55, 0.7, 0.85, 1.0]);
        radius.panel(Axis::linear("$T/T_0$").range(0.9, 1.25))
            .curve(radius.exact(fixed).label_at("disc fixed", 0.68, 1.11, Side::AboveLeft))
            .curve(radius.exact(|_| 1.0 / unit(&m)).label_at("disc free", 0.6, 0.98, Side::Below))
            .curve(radius.simulated(stiff)?)
            .curve(radius.simulated(loose)?)
    };

    /// Both periods against the angle of the release, over that of small swings of the free one. They begin at
    /// 1 and a little above, rise slowly to about twice that at 160 degrees, and steeply then, side by side.
    widths: {
        let rate = m.rate();
        let angles = Sweep::over(r"$\theta_0$ / rad", 0.01, 3.1).at([0.3, 0.8, 1.3, 1.8, 2.3, 2.7, 3.0]);
        let period = |moment: f64| move |angle| pendulum(p, moment, angle).map_or(f64::NAN, |q| q.period() * rate / (2.0 * PI));
        let dots = |angle| Ok(returns(&two_angles(m.share, 0.0), angle, LONG, 1e-10)?.0.t / (2.0 * PI));
        angles.panel(Axis::linear("$T/T_{free}$").range(0.9, 3.0))
            .curve(angles.exact(period(m.carried + m.own)).dashed())
            .curve(angles.exact(period(m.carried)).label_at("free, and dashed: fixed", 2.2, 1.5, Side::AboveLeft))
            .curve(angles.simulated(dots)?)
    };

    /// Part of the amplitude that a small swing loses, in per cent, against the friction in the axle, which
    /// spans four decades: a hill, the same on both sides, with its top near the middle.
    losses: {
        let lost = |decay: f64, period: f64| 100.0 * (1.0 - exp(-decay * period));
        let of = |b: Between| lost(b.decay, 2.0 * PI / b.frequency);
        frictions(Axis::linear("lost in a swing / %"), ["closed form", "simulated"], of, |[t, d]| lost(d, t), felt)?
    };

    /// Period of small swings over that of the free one against the same friction: a step from one up to the
    /// period of the fixed disc, in the middle of the hill.
    periods: {
        frictions(Axis::linear("$T/T_{free}$"), ["", ""], |b| 1.0 / b.frequency, |[t, _]| t / (2.0 * PI), felt)?
            .level((1.0 + felt).sqrt(), Ink::Frame, "fixed")
    };

    /// Amplitude of a swing from one radian against the number of swings, for three frictions in the axle. For
    /// the middle one it falls to a third in forty swings, for one ten times smaller and one ten times larger
    /// to four fifths. Dots, simulated, lie close to the lines.
    amplitudes: {
        let panel = Panel::over_axes(Axis::linear("$Wt/2\\pi$").range(0.0, 60.0), Axis::angle("amplitude / rad").range(0.0, 1.0).step(0.2));
        let lines = [(0.1, "$c^*/10$ and $10c^*$", 0.88, Side::Above), (1.0, "$c^*$", 0.38, Side::BelowLeft), (10.0, "", 0.8, Side::Above)];
        lines.into_iter().try_fold(panel, |panel, (times_worst, label, y, side)| {
            let drag = times_worst * worst(felt);
            let decay = Between::new(felt, drag).decay;
            let line = Curve::of(times(0.0, 60.0, 60), |n| exp(-decay * 2.0 * PI * n), Ink::Ink);
            let dots = Curve::new(amplitudes(felt, drag)?, Ink::Body).dots();
            Ok::<_, kit::Error>(panel.curve(line.label_at(label, 36.0, y, side)).curve(dots))
        })?
    };
}

const SWINGS: f64 = 12.0;

fn both(p: &Parameters, m: &Moments) -> Result<[Pendulum; 2]> {
    Ok([pendulum(p, m.carried + m.own, p.release)?, pendulum(p, m.carried, p.release)?])
}

/// Both pendulums from the release, for `--csv`; the free disc keeps its angle.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let m = Moments::new(p)?;
    let ([fixed, free], drag) = (both(p, &m)?, p.friction / (m.own * m.rate()));
    let run = swung(m.share, drag, p.release, 2.0 * PI * SWINGS, p.tolerance)?;
    let columns =
        "t [s], theta fixed [rad], theta free [rad], theta greased [rad], phi greased [rad]";
    let all = times(0.0, 2.0 * PI * SWINGS / m.rate(), 600);
    Trajectory::sampled(columns.split(", "), all, |t| {
        let [rod, _, disc, _] = run.at((t * m.rate()).min(run.end_time()))?;
        Ok([t, fixed.at(t)?.theta, free.at(t)?.theta, rod, disc])
    })
}

/// Both from the same release: the free one on the left.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (m, release, radius) = (Moments::new(p)?, p.release, p.radius / p.length);
    let [fixed, free] = both(p, &m)?;
    let end = 2.0 * PI * SWINGS / m.rate();
    let angle = |which: &Pendulum, ink| {
        Curve::sampled(times(0.0, end, 480), |t| Ok(which.at(t)?.theta), ink)
    };
    let graph = Panel::over_axes("$t$ / s", Axis::angle(r"$\theta$ / rad"))
        .curve(angle(&free, Ink::Body)?)
        .curve(angle(&fixed, Ink::Ink)?.dashed());
    // As wide as the widest swing, and as high.
    let wide = sin(release.abs().min(FRAC_PI_2)) + radius + 0.08;
    let (below, top) = (-1.18 - radius, (radius - cos(release)).max(0.0) + 0.34);
    let stills = [0.0, 0.25 * fixed.period(), end];
    MovingPicture::above(graph, 0.0..=end, stills, move |t| {
        let (loose, stiff) = (free.at(t)?.theta, fixed.at(t)?.theta);
        let alt = format!(
            "After {t:.2} s the free pendulum on the left is at {loose:.2} rad, the fixed one on the right at {stiff:.2} \
             rad. The spoke of the free disc points as at the release, that of the fixed one along its rod. Below, both \
             angles against time: the free one runs ahead."
        );
        let empty = Sketch::within((-wide, 3.0 * wide), (below - 0.14, top)).high(141);
        let left = drawn(empty, 0.0, radius, [loose, release]).pivot((0.0, 0.0), FRAC_PI_2);
        let both = drawn(left, 2.0 * wide, radius, [stiff, stiff])
            .pivot((2.0 * wide, 0.0), FRAC_PI_2)
            .text((0.0, below), "free", Ink::Body, Side::Centre)
            .text((2.0 * wide, below), "fixed", Ink::Body, Side::Centre);
        Ok((alt, both))
    })
}
