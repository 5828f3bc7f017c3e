//! The drawings of the page; those over the year start at noon of 1 January 2000.

use super::*;

type Point = (f64, f64);

const SUN: Point = (0.0, 0.0);

fn at(centre: Point, radius: f64, angle: f64) -> Point {
    let (s, c) = sincos(angle);
    (centre.0 + radius * c, centre.1 + radius * s)
}

/// The Earth with its line OP, which points so.
fn earth(sketch: Sketch, centre: Point, radius: f64, angle: f64) -> Sketch {
    sketch
        .disc(centre, radius, Ink::Body, 0.3)
        .curve(Curve::new([centre, at(centre, radius, angle)], Ink::Body))
        .dot(at(centre, radius, angle), Ink::Body, "", Side::Above)
}

/// The days of the year, named if the year is the Earth's.
fn calendar(p: &Parameters) -> Axis {
    let axis = Axis::linear("day of the year").range(0.0, p.year);
    if !year::is_of_the_earth(p) {
        return axis;
    }
    let months = ["Jan", "Mar", "May", "Jul", "Sep", "Nov"];
    axis.ticks([0.0, 60.0, 121.0, 182.0, 244.0, 305.0].into_iter().zip(months))
}

/// An axis over all of these values, and over a little more if they are the same.
fn reaching(label: &str, values: impl IntoIterator<Item = f64>) -> Axis {
    Axis::linear(label).over(values.into_iter().chain([-0.1, 0.1]))
}

/// By the orbit, by the tilt, by both, and simulated, over the year.
fn causes(p: &Parameters, y: &str, curves: [Vec<Point>; 4]) -> Panel {
    let values = curves.iter().flatten().map(|(_, y)| *y);
    let axes = Panel::over_axes(calendar(p), reaching(y, values)).level(0.0, Ink::Frame, "");
    let [oval, tilt, both, found] = curves;
    axes.curve(Curve::new(oval, Ink::Frame).dotted().label("orbit"))
        .curve(Curve::new(tilt, Ink::Frame).dashed().label("tilt"))
        .curve(Curve::new(both, Ink::Ink).label("both"))
        .curve(Curve::new(found.into_iter().step_by(18), Ink::Body).dots())
}

/// Sundial less clock in minutes, for an angle of the turning Earth.
fn minutes(p: &Parameters, angle: f64) -> f64 {
    angle * p.day / 60.0 / TAU
}

figures! { p: &Parameters;
    /// The Sun, and the Earth at two places of its orbit. At alpha the line OP points at the Sun. At beta, one solar day
    /// later, it does again, and so has turned by more than a whole turn: a grey arrow at beta, parallel to OP at alpha,
    /// lies short of it by the angle that the Earth has gone round the Sun.
    one_day: {
        let (angle, down, up) = (0.62, -0.5 * PI, 0.5 * PI);
        let [alpha, beta] = [at(SUN, 1.0, down), at(SUN, 1.0, down + angle)];
        let sketch = Sketch::within((-0.55, 1.05), (-1.3, 0.2))
            .guide(times(-0.55, 1.3, 60).map(|a| at(SUN, 1.0, down + a)))
            .guide([alpha, SUN])
            .guide([beta, SUN])
            .disc(SUN, 0.08, Ink::Ink, 0.3)
            .text((0.09, 0.03), "Sun", Ink::Ink, Side::Right)
            .angle(SUN, 0.34, (down, down + angle), r"$2\pi/365$")
            .arrow_to(beta, at(beta, 0.46, up), Ink::Frame, "to the same star", Side::Above)
            .angle(beta, 0.3, (up, up + angle), "");
        earth(earth(sketch, alpha, 0.17, up), beta, 0.17, up + angle)
            .turn(alpha, 0.23, (-0.95 * PI, 0.34 * PI), Ink::Velocity)
            .text(at(alpha, 0.2, -2.3), r"$\alpha$", Ink::Ink, Side::BelowLeft)
            .text(at(beta, 0.2, -0.8), r"$\beta$", Ink::Ink, Side::BelowRight)
            .dot(alpha, Ink::Ink, "$O$", Side::Right)
            .dot(beta, Ink::Ink, "$O$", Side::Right)
            .text(at(alpha, 0.2, up), "$P$", Ink::Body, Side::Left)
            .text(at(beta, 0.2, up + angle), "$P$", Ink::Body, Side::Left)
    };

    /// An oval orbit with the Sun off its centre. In the same time the line from the Sun to the Earth sweeps a short wide
    /// sector where they are near and a long narrow one where they are far, of equal area.
    oval: {
        // Far more oval than the Earth's.
        let (e, half) = (0.45, 0.375);
        let place = |mean: f64| {
            let (s, c) = sincos(eccentric_anomaly(mean, e));
            (c - e, ((1.0 - e) * (1.0 + e)).sqrt() * s)
        };
        let way = |middle: f64, count| times(middle - half, middle + half, count).map(place);
        let sector = |middle| core::iter::once(SUN).chain(way(middle, 40));
        Sketch::within((-1.65, 0.85), (-1.05, 1.05))
            .guide(times(0.0, TAU, 160).map(place))
            .body(sector(0.0), Ink::Frame, 0.15)
            .body(sector(PI), Ink::Frame, 0.15)
            .arrow_along(way(0.0, 20), Ink::Body)
            .arrow_along(way(PI, 20), Ink::Body)
            .text((0.35, 0.62), "near: fast", Ink::Ink, Side::Above)
            .text((-1.2, 0.62), "far: slow", Ink::Ink, Side::Above)
            .disc(SUN, 0.07, Ink::Ink, 0.3)
            .text((0.0, -0.1), "Sun", Ink::Ink, Side::Below)
    };

    /// The sky as a sphere, with the equator and, tilted against it, the circle on which the Sun moves. From the Sun a
    /// circle leads through the pole down to the equator and meets it short of a second dot, which is as far from the
    /// equinox along the equator as the Sun is along its own circle.
    tilt: {
        // The tilt is drawn twice as large as the Earth's.
        let ((s, c), sun) = (sincos(0.82), 1.0);
        let on = |height: f64, a: f64| SpaceVector::new(cos(a) * cos(height), sin(a) * cos(height), sin(height));
        let ecliptic = |a: f64| SpaceVector::new(cos(a), sin(a) * c, sin(a) * s);
        let there = ecliptic(sun);
        let across = atan2(there.y(), there.x());
        View::of(SpaceVector::zero(), 1.12)
            .sphere()
            .trace(times(0.0, TAU, 240).map(ecliptic), Ink::Ink)
            .trace(times(0.0, 0.5 * PI, 60).map(|height| on(height, across)), Ink::Frame)
            .trace(times(0.0, sun, 40).map(|a| on(0.0, a)), Ink::Body)
            .dot(on(0.0, 0.0), Ink::Ink, "equinox", Side::Left)
            .dot(there, Ink::Ink, "Sun", Side::AboveRight)
            .dot(on(0.0, across), Ink::Frame, "", Side::Below)
            .dot(on(0.0, sun), Ink::Body, "mean", Side::BelowRight)
    };

    /// Sundial less clock over the year, in minutes: a wave of one year by the oval orbit and a wave of half a year by the
    /// tilt, and their sum, which is lowest in February, a little up in May, down in July and highest in November; dots
    /// from simulated noons lie on it.
    equation: {
        let curve = |f: fn(&Sun) -> f64| times(0.0, p.year, 366).map(|t| (t, minutes(p, f(&sun(p, t))))).collect();
        let noons = (0..).zip(orbit::noons(p, p.tolerance)?.0).filter(|(_, t)| (0.0..=p.year).contains(t));
        let found = noons.map(|(k, t)| (t, (f64::from(k) - t) * p.day / 60.0)).collect();
        let (oval, tilt) = (curve(|sun| -sun.centre), curve(|sun| sun.reduction));
        causes(p, "sundial less clock / min", [oval, tilt, curve(Sun::equation_of_time), found])
    };

    /// The time from noon to noon less 24 hours over the year, in seconds: twice a year above and twice below zero by the
    /// tilt, once by the orbit; together longest at the end of December and shortest in the middle of September.
    day_length: {
        let lengths = |noons: Vec<f64>| {
            let pairs = noons.windows(2).take(p.year as usize);
            let days = pairs.map(|t| (0.5 * (t[0] + t[1]), (t[1] - t[0] - 1.0) * p.day));
            days.filter(|(t, _)| (0.0..=p.year).contains(t)).collect()
        };
        let of = |e, tilt| lengths(noons(&with(p, e, tilt)));
        let (oval, tilt) = (of(p.eccentricity, 0.0), of(0.0, p.obliquity));
        let found = lengths(orbit::noons(p, p.tolerance)?.0);
        causes(p, "noon to noon less 24 h / s", [oval, tilt, lengths(noons(p)), found])
    };

    /// Where the Sun stands at noon by the clock, day after day: its height above the equator against sundial less clock, a
    /// slender figure of eight, the lower loop the wider.
    analemma: {
        let point = |t: f64| {
            let sun = sun(p, t);
            (minutes(p, sun.equation_of_time()), sun.declination.to_degrees())
        };
        // The first days of the months, in a year of 366 days.
        let firsts = [0, 31, 60, 91, 121, 152, 182, 213, 244, 274, 305, 335].map(f64::from);
        let first = |k: f64| point(k * (p.year / 366.0));
        let eight: Vec<Point> = times(0.0, p.year, 366).map(point).collect();
        let across = reaching("sundial less clock / min", eight.iter().map(|(x, _)| *x));
        let panel = Panel::over_axes(across, reaching("declination / °", eight.iter().map(|(_, y)| *y)))
            .size(340, 340)
            .upright(0.0, Ink::Frame, "")
            .curve(Curve::new(eight, Ink::Ink))
            .curve(Curve::new(firsts.map(first), Ink::Body).dots());
        let name = |panel: Panel, (k, month, side)| panel.note(first(k).0, first(k).1, Ink::Body, month, side);
        let named = [
            (31.0, "Feb", Side::Left), (91.0, "Apr", Side::Left),
            (213.0, "Aug", Side::Left), (305.0, "Nov", Side::Right),
        ];
        named.into_iter().fold(panel, name)
    };
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
    let year = p.picture_year;
    let line = |rate: f64, ink| Curve::of(times(0.0, year, 1), |t| rate * t, ink);
    let (stars, noons) = (line(turn(year) / TAU, Ink::Body), line(1.0, Ink::Ink).dashed());
    let (label, high) = (0.72 * year, 0.8 * (year + 1.0));
    let graph = Panel::over_axes("$t$ / d", "turns")
        .curve(stars.label_at("to the stars", label, high, Side::AboveLeft))
        .curve(noons.label_at("to the Sun", label, 0.66 * year, Side::BelowRight));
    MovingPicture::above(graph, 0.0..=year, [0.0, sidereal(year), 1.0], move |t| {
        let place = -0.5 * PI + TAU * t / year;
        let (centre, angle) = (at(SUN, 1.0, place), 0.5 * PI + turn(year) * t);
        let alt = format!(
            "The Earth after {t:.2} days of a year of {year} days, the half away from the Sun dark: it has gone round the Sun by {:.2} turns, and its line OP \
             has turned by {:.2} turns against a grey arrow that points at a star; a dashed line leads to the Sun. Below, turns against the stars and \
             against the Sun over the days.",
            t / year,
            turn(year) / TAU * t
        );
        // As far as the frame goes.
        let far = at(centre, 0.55, 0.5 * PI);
        let scene = Sketch::within((-1.45, 1.45), (-1.4, 1.3))
            .guide(times(0.0, TAU, 120).map(|a| at(SUN, 1.0, a)))
            .disc(SUN, 0.13, Ink::Energy, 0.55)
            .text((0.0, 0.15), "Sun", Ink::Ink, Side::Above)
            .guide([centre, SUN])
            .arrow_along([centre, (far.0, far.1.min(1.3))], Ink::Frame);
        // The half away from the Sun.
        let night = times(-0.5 * PI, 0.5 * PI, 40).map(|a| at(centre, 0.24, place + a));
        let scene = earth(scene, centre, 0.24, angle)
            .ghost(|sketch| sketch.body(night, Ink::Shadow, 1.0))
            .text(at(centre, 0.34, angle), "$P$", Ink::Body, Side::Centre)
            .dot(centre, Ink::Ink, "", Side::Below);
        Ok((alt, scene))
    })
}
