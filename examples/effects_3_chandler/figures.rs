//! The figures of the Chandler wobble, and its moving picture.

use super::excited::{Excited, YEAR};
use super::*;

/// An ellipse about the origin with these half axes, turned by `tilt` from upright.
fn ellipse(wide: f64, high: f64, tilt: f64) -> impl Iterator<Item = (f64, f64)> {
    let (s, c) = sincos(tilt);
    times(0.0, TAU, 120).map(move |angle| {
        let (up, out) = sincos(angle);
        let (x, y) = (wide * out, high * up);
        (x * c + y * s, y * c - x * s)
    })
}

/// A line through the origin at this tilt from upright, from one length to another.
fn through(tilt: f64, from: f64, to: f64) -> [(f64, f64); 2] {
    let (s, c) = sincos(tilt);
    [(from * s, from * c), (to * s, to * c)]
}

/// The period in days with this Love number; none where the bulge would follow nearly whole.
fn days(p: &Parameters, step: Step, love: f64) -> f64 {
    let period = step.period(&p.but(|p| p.love = love));
    period.map_or(f64::NAN, |turns| turns * p.day / DAY)
}

/// Period against Love number, exact and simulated.
fn swept(p: &Parameters, step: Step, ink: Ink) -> Result<[Curve; 2]> {
    let line = Curve::of(times(0.0, 0.6, 120), |love| days(p, step, love), Ink::Ink);
    let stepped = |love| Ok(step.simulated(&p.but(|p| p.love = love), 1e-9)? * p.day / DAY);
    let loves = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6];
    Ok([line, Curve::sampled(loves, stepped, ink)?.dots()])
}

/// A size of the pole's motion over so many years.
fn over_years(end: f64, count: u32, size: impl Fn(f64) -> f64, ink: Ink) -> Curve {
    Curve::of(times(0.0, end, count), move |years| size(years * YEAR), ink)
}

/// The steps of the ledger, one below the other, each from the period before to its own.
fn stairs(p: &Parameters) -> Result<Panel> {
    let periods = LEDGER.map(|step| days(p, step, p.love));
    let low = periods.into_iter().fold(p.observed, f64::min);
    let high = periods.into_iter().fold(p.observed, f64::max);
    let axes = Panel::over_axes(
        Axis::linear("period / d").range(low - 0.15 * (high - low), high + 0.2 * (high - low)),
        Axis::linear("").range(0.4, 5.6).ticks(Vec::<(f64, &str)>::new()),
    );
    let mut panel = axes.upright(p.observed, Ink::Frame, "observed");
    for (i, step) in LEDGER.into_iter().enumerate() {
        let (row, period) = (5.0 - i as f64, periods[i]);
        if i > 0 {
            let from = periods[i - 1];
            let stair = [(from, row + 1.0), (from, row), (period, row)];
            panel = panel.curve(Curve::new(stair, Ink::Frame).thin());
            let (left, middle) = (from.min(period), 0.5 * (from + period));
            // Beside a stair where there is room, else above it.
            panel = match left > 0.5 * (low + high) {
                true => panel.note(left, row, Ink::Ink, step.name, Side::Left),
                false => panel.note(middle, row, Ink::Ink, step.name, Side::Above),
            };
        }
        let simulated = step.simulated(p, 1e-9)? * p.day / DAY;
        let label = if i == 0 { step.name } else { "" };
        panel = panel.dot(simulated, row, Ink::Body, label, Side::Right);
    }
    Ok(panel)
}

figures! { p: &Parameters, excited = Excited::new(p)?;
    /// A meridian of the Earth, all flattening drawn far too large. The axis of rotation is
    /// off the figure axis. Inside the mantle a flattened fluid core. A dashed outline, turned
    /// a part of the way towards the axis of rotation, shows the bulge that has followed.
    parts: {
        let [_, tip] = through(0.4, 0.0, 1.5);
        Sketch::within((-1.6, 1.7), (-1.2, 1.6))
            .body(ellipse(1.3, 0.92, 0.0), Ink::Body, 0.12)
            .curve(Curve::new(ellipse(1.3, 0.92, 0.16), Ink::Body).dashed())
            .body(ellipse(0.66, 0.5, 0.0), Ink::Frame, 0.25)
            .guide(through(0.0, -1.1, 1.3))
            .arrow((0.0, 0.0), tip, Ink::Velocity, "", Side::Right)
            .text(tip, r"$\Omega$", Ink::Velocity, Side::Right)
            .text((0.0, 1.3), "$z$", Ink::Body, Side::Above)
            .text((0.32, -0.16), "core", Ink::Frame, Side::Centre)
            .text((-0.97, 0.0), "mantle", Ink::Body, Side::Centre)
    };

    /// Periods from the rigid Earth, 303 days, in steps: the yielding mantle takes it beyond
    /// what is observed, the fluid core back below, the oceans and the creep of the mantle up
    /// to it.
    ledger: stairs(p)?;

    /// Period against the Love number: it grows without bound towards the fluid Earth's. With
    /// a fluid core it is lower by a ninth everywhere. Simulated dots on both lines.
    love: {
        let [frozen, frozen_dots] = swept(p, ELASTIC, Ink::Body)?;
        let [fluid, fluid_dots] = swept(p, FLUID, Ink::Frame)?;
        Panel::over_axes(Axis::linear("$k_2$").range(0.0, 0.6), Axis::linear("period / d").over([200.0, 900.0]))
            .level(p.observed, Ink::Frame, "observed")
            .curve(frozen.label_at("core frozen", 0.42, days(p, ELASTIC, 0.42), Side::Left))
            .curve(fluid.label_at("core fluid", 0.47, days(p, FLUID, 0.47), Side::Right))
            .curve(frozen_dots)
            .curve(fluid_dots)
    };

    /// The pole towards Greenwich over thirteen years, in seconds of arc: an oscillation of a
    /// good year whose size swells and shrinks twice. Dashed, the same without pushes.
    beat: {
        let pushed = over_years(13.0, 600, |t| excited.at(t)[0], Ink::Velocity);
        let free = |t| p.wobble * cos(excited.rate[0] * t) + p.annual * cos(TAU * t / YEAR);
        let free = over_years(13.0, 600, free, Ink::Frame);
        Panel::over_axes("years", "towards Greenwich / arcsec").curve(free.dashed()).curve(pushed)
    };

    /// The size of the free wobble over a century and a half: without pushes it fades to less
    /// than a hundredth; with them it goes up and down, irregularly, about its usual size.
    fading: {
        let size = |t| { let [x, y] = excited.wobbling(t); hypot(x, y) };
        let unpushed = |t| p.wobble * exp(-excited.rate[1] * t);
        let alone = over_years(150.0, 150, unpushed, Ink::Ink);
        let top = times(0.0, 150.0 * YEAR, 900).map(size).fold(p.wobble, f64::max);
        Panel::over_axes("years", Axis::linear("free wobble / arcsec").range(0.0, 1.05 * top))
            .level(p.wobble, Ink::Frame, "")
            .curve(over_years(150.0, 900, size, Ink::Velocity).thin())
            .curve(alone.label_at("left alone", 40.0, unpushed(40.0 * YEAR), Side::Below))
    };
}

/// The pole of rotation on the ground, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let excited = Excited::new(p)?;
    let columns = ["t [d]", "towards Greenwich [arcsec]", "towards 90 E [arcsec]"];
    Trajectory::sampled(columns, times(0.0, 13.0 * YEAR, 950), |t| {
        let [x, y] = excited.at(t);
        Ok([t, x, y])
    })
}

/// The path of the pole, winding in and out.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let excited = Excited::new(p)?;
    let distance = |years: f64| {
        let [x, y] = excited.at(years * YEAR);
        hypot(x, y)
    };
    let top = times(0.0, 13.0, 400).map(distance).fold(0.0, f64::max);
    let graph = Panel::over_axes("years", Axis::linear("distance / arcsec").range(0.0, 1.05 * top))
        .curve(Curve::of(times(0.0, 13.0, 400), distance, Ink::Velocity));
    MovingPicture::above(graph, 0.0..=13.0, [1.6, 3.2, 6.4], move |t| {
        let path = |from: f64| {
            let years = times(from, t.max(from + 1e-3), 2 + (60.0 * (t - from)) as u32);
            years.map(|years| excited.at(years * YEAR).into())
        };
        let [x, y] = excited.at(t * YEAR);
        let alt = format!(
            "The pole of rotation after {t:.1} years, seen from above the north pole, {:.2} arcsec \
             from the mean pole, with its path: a spiral that winds in and out. Below, that distance \
             over thirteen years.",
            hypot(x, y)
        );
        let ground = Sketch::within((-1.15 * top, 2.0 * top), (-1.1 * top, 1.45 * top))
            .guide([(0.0, 0.0), (1.25 * top, 0.0)])
            .guide([(0.0, 0.0), (0.0, 1.2 * top)])
            .text((1.25 * top, 0.0), "Greenwich", Ink::Frame, Side::Right)
            .text((0.0, 1.2 * top), "90° E", Ink::Frame, Side::Above)
            .curve(Curve::new(path(0.0), Ink::Velocity).thin().faint(0.45))
            .curve(Curve::new(path((t - 1.0).max(0.0)), Ink::Velocity))
            .dot((x, y), Ink::Velocity, r"$\Omega$", Side::AboveRight);
        Ok((alt, ground))
    })
}
