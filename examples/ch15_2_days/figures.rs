//! The drawings of the page; those over the year start at noon of 1 January 2000.

use super::*;
use kit::draw::{Axis, Curve, Ink, Panel, Side, Sketch, Stack, View};
use kit::{Figure, MovingPicture, Trajectory, sampled, times};
use rotation_dynamics::frame::SpaceVector;

/// All figures of the page.
pub fn figures(p: &Parameters) -> Result<Vec<Figure>> {
    Ok(vec![one_day()?, oval()?, tilt()?, equation(p)?, day_length(p)?, analemma(p)?])
}

type Point = (f64, f64);

fn at(centre: Point, radius: f64, angle: f64) -> Point {
    let (s, c) = sincos(angle);
    (centre.0 + radius * c, centre.1 + radius * s)
}

fn circle(centre: Point, radius: f64) -> Curve {
    let rim = times(0.0, TAU, 120).map(|a| at(centre, radius, a));
    Curve::new(rim, Ink::Frame).thin().dashed()
}

/// The Earth with its line OP, which points so.
fn earth(sketch: Sketch, centre: Point, radius: f64, angle: f64) -> Sketch {
    sketch
        .disc(centre, radius, Ink::Body, 0.3)
        .curve(Curve::new([centre, at(centre, radius, angle)], Ink::Body))
        .dot(at(centre, radius, angle), Ink::Body, "", Side::Above)
}

/// The notes' figure 5, the angle enlarged: alpha, and one solar day later beta.
fn one_day() -> Result<Figure> {
    let (sun, angle, down) = ((0.0, 0.0), 0.62, -0.5 * PI);
    let [alpha, beta] = [at(sun, 1.0, down), at(sun, 1.0, down + angle)];
    let alt = "The Sun, and the Earth at two places of its orbit. At alpha the line OP points at the Sun. At beta, one \
               solar day later, it does again, and so has turned by more than a whole turn: a grey arrow at beta, \
               parallel to OP at alpha, lies short of it by the angle that the Earth has gone round the Sun.";
    let ray = |from: Point| Curve::new([from, sun], Ink::Frame).thin().dashed();
    let upright = at(beta, 0.46, 0.5 * PI);
    let orbit = times(-0.55, 1.3, 60).map(|a| at(sun, 1.0, down + a));
    let orbit = Curve::new(orbit, Ink::Frame).thin().dashed();
    let sketch = Sketch::new("one_day", alt)
        .window((-0.55, 1.05), (-1.3, 0.2))
        .curve(orbit)
        .curve(ray(alpha))
        .curve(ray(beta))
        .disc(sun, 0.08, Ink::Ink, 0.3)
        .text((0.09, 0.03), "Sun", Ink::Ink, Side::Right)
        .angle(sun, 0.34, (down, down + angle), "$2\\pi/365$")
        .arrow_to(beta, upright, Ink::Frame, "to the same star", Side::Above)
        .angle(beta, 0.3, (0.5 * PI, 0.5 * PI + angle), "");
    let sketch = earth(sketch, alpha, 0.17, 0.5 * PI);
    earth(sketch, beta, 0.17, 0.5 * PI + angle)
        .turn(alpha, 0.23, (-0.95 * PI, 0.34 * PI), Ink::Velocity)
        .text(at(alpha, 0.2, -2.3), "$\\alpha$", Ink::Ink, Side::BelowLeft)
        .text(at(beta, 0.2, -0.8), "$\\beta$", Ink::Ink, Side::BelowRight)
        .dot(alpha, Ink::Ink, "$O$", Side::Right)
        .dot(beta, Ink::Ink, "$O$", Side::Right)
        .text(at(alpha, 0.2, 0.5 * PI), "$P$", Ink::Body, Side::Left)
        .text(at(beta, 0.2, 0.5 * PI + angle), "$P$", Ink::Body, Side::Left)
        .figure()
}

/// An orbit far more oval than the Earth's: two sectors of the same area.
fn oval() -> Result<Figure> {
    let (e, along) = (0.45_f64, 0.75_f64);
    let flat = ((1.0 - e) * (1.0 + e)).sqrt();
    let place = |mean: f64| {
        let (s, c) = sincos(eccentric_anomaly(mean, e));
        (c - e, flat * s)
    };
    let sector = |middle: f64| {
        let arc = times(middle - 0.5 * along, middle + 0.5 * along, 40).map(place);
        core::iter::once((0.0, 0.0)).chain(arc)
    };
    let path = times(0.0, TAU, 160).map(place);
    let alt = "An oval orbit with the Sun off its centre. In the same time the line from the Sun to the Earth sweeps a \
               short wide sector where they are near and a long narrow one where they are far, of equal area.";
    let moved = |middle: f64| times(middle - 0.5 * along, middle + 0.5 * along, 20).map(place);
    Sketch::new("oval", alt)
        .window((-1.65, 0.85), (-1.05, 1.05))
        .curve(Curve::new(path, Ink::Frame).thin().dashed())
        .body(sector(0.0), Ink::Frame, 0.15)
        .body(sector(PI), Ink::Frame, 0.15)
        .arrow_along(moved(0.0), Ink::Body)
        .arrow_along(moved(PI), Ink::Body)
        .text((0.35, 0.62), "near: fast", Ink::Ink, Side::Above)
        .text((-1.2, 0.62), "far: slow", Ink::Ink, Side::Above)
        .disc((0.0, 0.0), 0.07, Ink::Ink, 0.3)
        .text((0.0, -0.1), "Sun", Ink::Ink, Side::Below)
        .figure()
}

/// The sky as a sphere: the Sun on the ecliptic, its hour circle, and the mean Sun.
fn tilt() -> Result<Figure> {
    // The tilt is drawn twice as large as the Earth's.
    let ((s, c), sun) = (sincos(0.82), 1.0);
    let ecliptic = move |a: f64| {
        let (y, x) = sincos(a);
        SpaceVector::new(x, y * c, y * s)
    };
    let (there, mean) = (ecliptic(sun), SpaceVector::new(cos(sun), sin(sun), 0.0));
    let across = atan2(there.y(), there.x());
    let meridian = times(0.0, 0.5 * PI, 60).map(move |a| {
        let ((high, level), (y, x)) = (sincos(a), sincos(across));
        SpaceVector::new(x * level, y * level, high)
    });
    let foot = SpaceVector::new(cos(across), sin(across), 0.0);
    let alt = "The sky as a sphere, with the equator and, tilted against it, the circle on which the Sun moves. From the \
               Sun a circle leads through the pole down to the equator and meets it short of a second dot, which is as \
               far from the equinox along the equator as the Sun is along its own circle.";
    View::new("tilt", alt)
        .sphere()
        .trace(times(0.0, TAU, 240).map(ecliptic), Ink::Ink)
        .trace(meridian, Ink::Frame)
        .trace(times(0.0, sun, 40).map(|a| SpaceVector::new(cos(a), sin(a), 0.0)), Ink::Body)
        .dot(SpaceVector::new(1.0, 0.0, 0.0), Ink::Ink, "equinox", Side::Left)
        .dot(there, Ink::Ink, "Sun", Side::AboveRight)
        .dot(foot, Ink::Frame, "", Side::Below)
        .dot(mean, Ink::Body, "mean", Side::BelowRight)
        .figure()
}

/// The days of the year, named if the year is the Earth's.
fn calendar(p: &Parameters) -> Axis {
    let axis = Axis::linear("day of the year").range(0.0, p.year);
    if !(365.0..366.5).contains(&p.year) {
        return axis;
    }
    let months = ["Jan", "Mar", "May", "Jul", "Sep", "Nov"];
    axis.ticks([0.0, 60.0, 121.0, 182.0, 244.0, 305.0].into_iter().zip(months))
}

/// An axis over all of these curves, and over a little more if they are flat.
fn reaching(label: &str, curves: &[&[Point]]) -> Axis {
    let values = curves.iter().flat_map(|curve| curve.iter().map(|(_, y)| *y));
    Axis::linear(label).over(values.chain([-0.1, 0.1]))
}

/// Two causes, what they come to together, and simulated values, over the year.
fn causes(panel: Panel, p: &Parameters, y: &str, curves: [Vec<Point>; 4]) -> Result<Figure> {
    let axis = reaching(y, &curves.each_ref().map(Vec::as_slice));
    let [oval, tilt, both, found] = curves;
    panel
        .x(calendar(p))
        .y(axis)
        .level(0.0, Ink::Frame, "")
        .curve(Curve::new(oval, Ink::Frame).dotted().label("orbit"))
        .curve(Curve::new(tilt, Ink::Frame).dashed().label("tilt"))
        .curve(Curve::new(both, Ink::Ink).label("both"))
        .curve(Curve::new(found.into_iter().step_by(18), Ink::Body).dots())
        .figure()
}

fn equation(p: &Parameters) -> Result<Figure> {
    let minutes = p.day / 60.0 / TAU;
    let curve = |f: fn(&Sun) -> f64| {
        let sampled = times(0.0, p.year, 366).map(|t| (t, minutes * f(&sun(p, t))));
        sampled.collect::<Vec<_>>()
    };
    let noons = (0..).zip(orbit::noons(p, p.tolerance)?.0);
    let found = noons.map(|(k, t)| (t, (f64::from(k) - t) * p.day / 60.0));
    let found = found.filter(|(t, _)| (0.0..=p.year).contains(t)).collect();
    let alt = "Sundial less clock over the year, in minutes: a wave of one year by the oval orbit and a wave of half a \
               year by the tilt, and their sum, which is lowest in February, a little up in May, down in July and \
               highest in November; dots from simulated noons lie on it.";
    let (oval, tilt) = (curve(|sun| -sun.centre), curve(|sun| sun.reduction));
    let curves = [oval, tilt, curve(Sun::equation_of_time), found];
    causes(Panel::new("equation", alt), p, "sundial less clock / min", curves)
}

fn day_length(p: &Parameters) -> Result<Figure> {
    let lengths = |noons: Vec<f64>| {
        let pairs = noons.windows(2).take(p.year as usize);
        let days = pairs.map(|t| (0.5 * (t[0] + t[1]), (t[1] - t[0] - 1.0) * p.day));
        days.filter(|(t, _)| (0.0..=p.year).contains(t)).collect::<Vec<_>>()
    };
    let of = |e, tilt| lengths(noons(&with(p, e, tilt)));
    let alt = "The time from noon to noon less 24 hours over the year, in seconds: twice a year above and twice below \
               zero by the tilt, once by the orbit; together longest at the end of December and shortest in \
               the middle of September.";
    let found = lengths(orbit::noons(p, p.tolerance)?.0);
    let (oval, tilt) = (of(p.eccentricity, 0.0), of(0.0, p.obliquity));
    let curves = [oval, tilt, lengths(noons(p)), found];
    causes(Panel::new("day_length", alt), p, "noon to noon less 24 h / s", curves)
}

fn analemma(p: &Parameters) -> Result<Figure> {
    let point = |t: f64| {
        let sun = sun(p, t);
        let minutes = sun.equation_of_time() * p.day / 60.0 / TAU;
        (minutes, sun.declination.to_degrees())
    };
    // The first days of the months, in a year of 366 days.
    let firsts = [0, 31, 60, 91, 121, 152, 182, 213, 244, 274, 305, 335].map(f64::from);
    let part = p.year / 366.0;
    let eight: Vec<Point> = times(0.0, p.year, 366).map(point).collect();
    let across: Vec<Point> = eight.iter().map(|(x, y)| (*y, *x)).collect();
    let alt = "Where the Sun stands at noon by the clock, day after day: its height above the equator against \
               sundial less clock, a slender figure of eight, the lower loop the wider.";
    let panel = Panel::new("analemma", alt)
        .size(340, 340)
        .x(reaching("sundial less clock / min", &[&across]))
        .y(reaching("declination / °", &[&eight]))
        .upright(0.0, Ink::Frame, "")
        .curve(Curve::new(eight, Ink::Ink))
        .curve(Curve::new(firsts.map(|k| point(k * part)), Ink::Body).dots());
    let named = [
        (31.0, "Feb", Side::Left),
        (91.0, "Apr", Side::Left),
        (213.0, "Aug", Side::Left),
        (305.0, "Nov", Side::Right),
    ];
    let name = |panel: Panel, (k, month, side)| {
        let (x, y) = point(k * part);
        panel.note(x, y, Ink::Body, month, side)
    };
    named.into_iter().fold(panel, name).figure()
}

/// The Sun day by day, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let columns =
        ["day", "noon [d]", "sundial less clock [s]", "orbit [s]", "tilt [s]", "declination [rad]"];
    let second = p.day / TAU;
    Trajectory::sampled(columns, (0..=p.year as u32).map(f64::from), |k| {
        let t = noon(p, k as u32);
        let Sun { centre, reduction, declination } = sun(p, t);
        Ok([k, t, (k - t) * p.day, -centre * second, reduction * second, declination])
    })
}

/// A year of few days: the Earth goes round and turns, and its turns are counted.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (year, sun) = (p.picture_year, (0.0, 0.0));
    let line = |rate: f64| sampled(times(0.0, year, 1), |t| Ok((t, rate * t)));
    let graph = Panel::new("graph", "").over("$t$ / d", "turns");
    let stars = Curve::new(line(turn(year) / TAU)?, Ink::Body);
    let noons = Curve::new(line(1.0)?, Ink::Ink).dashed();
    let graph = graph.curve(stars.label_at(
        "to the stars",
        0.72 * year,
        0.8 * (year + 1.0),
        Side::AboveLeft,
    ));
    let graph =
        graph.curve(noons.label_at("to the Sun", 0.72 * year, 0.66 * year, Side::BelowRight));
    MovingPicture::new(0.0..=year, [0.0, sidereal(year), 1.0], move |t| {
        let place = -0.5 * PI + TAU * t / year;
        let centre = at(sun, 1.0, place);
        let angle = 0.5 * PI + turn(year) * t;
        let alt = format!(
            "The Earth after {t:.2} days of a year of {year} days, the half away from the Sun dark: it has gone round the Sun by {:.2} turns, and its line OP \
             has turned by {:.2} turns against a grey arrow that points at a star; a dashed line leads to the Sun. Below, turns against the stars and \
             against the Sun over the days.",
            t / year,
            turn(year) / TAU * t
        );
        // As far as the frame goes.
        let far = at(centre, 0.55, 0.5 * PI);
        let star = (far.0, far.1.min(1.3));
        let scene = Sketch::new("scene", &alt)
            .window((-1.45, 1.45), (-1.4, 1.3))
            .curve(circle(sun, 1.0))
            .disc(sun, 0.13, Ink::Energy, 0.55)
            .text((0.0, 0.15), "Sun", Ink::Ink, Side::Above)
            .curve(Curve::new([centre, sun], Ink::Frame).thin().dashed())
            .arrow_along([centre, star], Ink::Frame);
        // The half away from the Sun.
        let night = times(-0.5 * PI, 0.5 * PI, 40).map(|a| at(centre, 0.24, place + a));
        let scene = earth(scene, centre, 0.24, angle)
            .ghost(|sketch| sketch.body(night, Ink::Shadow, 1.0))
            .text(at(centre, 0.34, angle), "$P$", Ink::Body, Side::Centre)
            .dot(centre, Ink::Ink, "", Side::Below);
        Stack::frame(&alt, scene, &graph, t)
    })
    .map(|picture| picture.timed("$t$ / d"))
}
