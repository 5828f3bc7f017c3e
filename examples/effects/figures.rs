//! The drawings of the page on effects.

use super::*;
use kit::draw::Camera;
use models::heavy_top::Pose;
use models::heavy_top::stand::{on_stand, rotor};

/// How far the axis is from where it would be without this effect, against the time.
fn aside(q: &Question<Weight>, effect: impl Effect, name: &str, ink: Ink) -> Result<Curve> {
    // Equal distances on a logarithmic axis.
    let times = (0..=160).map(|n| q.end * pow(10.0, -2.0 + f64::from(n) / 80.0));
    let both = q.both(effect, 1e-8, times.map(|t| t.min(q.end)))?;
    let mut largest = 1e-9_f64;
    let points = both.into_iter().map(|(t, attitudes)| {
        largest = largest.max(q.apart(attitudes));
        (t, largest)
    });
    Ok(Curve::new(points, ink).label_end(name))
}

/// Error against price for one of the motions, with what its model leaves out.
fn digits(key: &str) -> Result<Panel> {
    let cases = cases()?;
    let Some(case) = cases.iter().find(|case| case.key == key) else {
        return Ok(Panel::over_axes("", ""));
    };
    let first = case.runs.first().map_or(10.0, |run| run.0);
    let last = case.runs.last().map_or(1e4, |run| run.0);
    let mut panel = Panel::over_axes(
        Axis::log("evaluations").range(0.8 * first, 1.3 * last),
        Axis::log("error / rad").range(1e-15, 10.0),
    )
    .curve(Curve::new(case.runs.iter().copied(), Ink::Body).with_dots());
    for &(name, (error, _)) in named(case) {
        panel = panel.level(error, Ink::Force, name);
    }
    Ok(panel)
}

/// Those left out whose labels do not lie on each other.
fn named(case: &Case) -> impl Iterator<Item = &digits::LeftOut> {
    let mut lowest = f64::INFINITY;
    let apart = case.left_out.iter().filter(move |(_, (error, _))| {
        let room = *error < 0.06 * lowest;
        lowest = if room { *error } else { lowest };
        room
    });
    apart.take(3)
}

figures! { p: &Parameters;
    /// How far the axis of the gyroscope is from where it would be without each effect, on
    /// logarithmic axes against the time: the air leads, far above bearing, pivot, buoyancy
    /// and the turning Earth.
    desk: {
        let (rotor, q) = (gyroscope(p), question(p)?);
        Panel::over_axes(Axis::log("$t$ / s"), Axis::log("axis off by / rad").range(1e-7, 10.0))
            .size(340, 300)
            .level(p.tolerance, Ink::Frame, "asked for")
            .curve(aside(&q, rotor.air()?, "air", Ink::Body)?)
            .curve(aside(&q, rotor.dry()?, "bearing", Ink::Momentum)?)
            .curve(aside(&q, rotor.pivot(), "pivot", Ink::Force)?)
            .curve(aside(&q, rotor.buoyancy(), "buoyancy", Ink::Velocity)?)
            .curve(aside(&q, on_the_earth(), "Earth", Ink::Ink)?)
    };

    /// Error against evaluations of the gyroscope's axis after ten seconds: the runs fall to
    /// the floor of rounding, far below the level lines of what the model leaves out.
    digits_gyroscope: digits("gyroscope")?;

    /// The same for the axis of the Earth over a year, with the torques of Moon and Sun.
    digits_year: digits("year")?;
}

/// The axis with its weight alone and in air, so many times.
fn in_air(p: &Parameters, error: f64, count: u32) -> Result<Vec<(f64, [SpaceVector; 2])>> {
    let both = question(p)?.both(gyroscope(p).air()?, error, times(0.0, p.seconds, count))?;
    let axes = |both: [Attitude; 2]| both.map(|attitude| attitude.axis());
    Ok(both.into_iter().map(|(t, both)| (t, axes(both))).collect())
}

/// The axis with its weight alone and in air, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns = ["t [s]", "X", "Y", "Z", "X in air", "Y in air", "Z in air"];
    let mut rows = Trajectory::new(columns)?;
    for (t, axes) in in_air(p, 1e-8, 1000)? {
        let [[a, b, c], [d, e, f]] = axes.map(SpaceVector::to_array);
        rows.push([t, a, b, c, d, e, f])?;
    }
    Ok(rows)
}

/// How many times too slow the spin is drawn: true spokes would stand still in one frame and jump
/// in the next.
const SLOW: f64 = 50.0;

/// The gyroscope in air, and as a ghost where its weight alone would have taken it.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (end, spin) = (p.seconds, p.spin / SLOW);
    // Sampled once; a frame is a straight line between two samples.
    let axes = in_air(p, 1e-6, 2000)?;
    let at = move |t: f64| {
        let x = (t / end * 2000.0).clamp(0.0, 2000.0);
        let n = (x as usize).min(axes.len() - 2);
        let (part, from, to) = (x - n as f64, axes[n].1, axes[n + 1].1);
        [0, 1].map(|i| from[i] * (1.0 - part) + to[i] * part)
    };
    let curve = Curve::of(times(0.0, end, 1000), |t| angle(at(t)), Ink::Body).thin();
    let graph = Panel::over_axes("$t$ / s", "apart / rad").curve(curve).low();
    MovingPicture::above(graph, 0.0..=end, [0.3 * end, 0.6 * end, end], move |t| {
        let [alone, air] = at(t);
        let past = sampled(times((t - 0.12 * end).max(0.0), t, 160), |s| Ok(at(s)))?;
        let trail = |i: usize| past.iter().map(move |axes| axes[i]);
        let scene = on_stand("scene", "scene", &Pose::of(air, spin * t))
            .camera(Camera::new(-0.55, 0.6))
            .around(UP * -0.17, 1.12)
            .ghost(rotor(&Pose::of(alone, spin * t)), Ink::Frame)
            .trail(trail(0), Ink::Frame)
            .trail(trail(1), Ink::Body)
            .dot(alone, Ink::Frame, "vacuum", Side::Left)
            .dot(air, Ink::Body, "air", Side::Right)
            .corner(&format!("{t:.1} s"));
        let alt = format!(
            "A spoked wheel on a stand, {t:.1} s after its release in air; a pale outline shows the same wheel in a \
             vacuum. The ends of the two axles, with fading ribbons, are {:.2} rad apart; below, that angle against time.",
            angle([alone, air])
        );
        Ok((alt, scene))
    })
}
