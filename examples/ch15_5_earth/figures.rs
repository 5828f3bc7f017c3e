//! The figures of the Earth's wobble, and its moving picture.

use super::equinoxes::{self, ARCSEC, YEAR};
use super::{Parameters, alpha, flattening, motion, yielding};
use core::f64::consts::{PI, TAU};
use kit::draw::{Axis, Curve, Ink, Panel, Side, Sketch, Stack};
use kit::{Figure, MovingPicture, Result, times};
use rotation_dynamics::math::{cos, hypot, sincos, tan};

pub fn figures(p: &Parameters) -> Result<Vec<Figure>> {
    Ok(vec![among_stars(p)?, trails()?, periods(p)?, path(p)?, year(p)?])
}

/// A circle of this radius about the origin.
fn circle(radius: f64, from: f64, to: f64) -> impl Iterator<Item = (f64, f64)> {
    times(from, to, 120).map(move |angle| {
        let (s, c) = sincos(angle);
        (radius * c, radius * s)
    })
}

/// What goes round in the sky in a day, in thousandths of a second of arc.
fn among_stars(p: &Parameters) -> Result<Figure> {
    let f = flattening(p)?;
    let alpha = 1e3 * alpha(p) / ARCSEC;
    let (theta, apart) = (alpha / (1.0 + f), alpha * f / (1.0 + f));
    let alt = format!(
        "Directions among the stars. The angular momentum stands still; the figure axis goes round \
         it at {theta:.0} thousandths of a second of arc; the angular velocity, on the other side, \
         is {apart:.0} thousandth off and its mark lies on that of the angular momentum."
    );
    let reach = 1.35 * theta;
    let spread = 0.42;
    let (s, c) = sincos(spread);
    Sketch::new("among_stars", &alt)
        .window((-reach, reach), (-1.15 * theta, 1.15 * theta))
        .curve(Curve::new(circle(theta, 0.0, TAU), Ink::Frame).thin().dashed())
        .curve(Curve::new([(0.0, 0.0), (theta * c, theta * s)], Ink::Frame).thin())
        .arrow_along(circle(theta, spread + 0.3, spread + 1.4), Ink::Body)
        .dot((theta * c, theta * s), Ink::Body, "$z$", Side::Right)
        .dot((0.0, 0.0), Ink::Momentum, r"$L$", Side::Above)
        .ring((-apart * c, -apart * s), Ink::Velocity, r"$\Omega$", Side::Left)
        .text((0.5 * theta * c, 0.5 * theta * s), r"$\theta$", Ink::Frame, Side::Below)
        .figure()
}

/// Trails of stars about the pole of the sky, and the horizon on two nights.
fn trails() -> Result<Figure> {
    let alt = "Arcs of stars about the pole of the sky, the same on two nights. The horizon lies \
               lower on the second night, by twice alpha, and so the pole stands higher.";
    let stars = [(0.18, 0.4), (0.33, 2.0), (0.48, 5.0), (0.62, 3.4), (0.74, 1.1), (0.86, 4.3)];
    let sky = Sketch::new("trails", alt)
        .window((-1.3, 1.3), (-1.55, 1.0))
        .dot((0.0, 0.0), Ink::Velocity, "pole", Side::Right)
        .curve(Curve::new([(-1.2, -1.05), (1.2, -1.05)], Ink::Body))
        .curve(Curve::new([(-1.2, -1.35), (1.2, -1.35)], Ink::Body).dashed())
        .text((-1.2, -1.05), "horizon", Ink::Body, Side::AboveRight)
        .text((-1.2, -1.35), "half a period later", Ink::Body, Side::BelowRight)
        .dimension((1.1, -1.35), (1.1, -1.05), r"$2\alpha$", Side::Right);
    let trail = |sky: Sketch, (radius, from): (f64, f64)| {
        sky.curve(Curve::new(circle(radius, from, from + 1.3), Ink::Ink))
    };
    stars.into_iter().fold(sky, trail).figure()
}

/// The period, one cause after the other, in solar days.
fn periods(p: &Parameters) -> Result<Figure> {
    let days = p.day / 86_400.0;
    let computed =
        [("rigid", days / flattening(p)?), ("mantle yields", days * yielding::period(p)?)];
    // The rounded values are those of the literature that the page names.
    let known = [("and fluid core", 392.0), ("and oceans: observed", 433.0)];
    let alt = format!(
        "Periods of the wobble in days: rigid {:.0}, with a mantle that yields {:.0}, with a fluid \
         core besides about 392, with oceans and as observed 433.",
        computed[0].1, computed[1].1
    );
    let rows = computed.iter().chain(&known).zip([4.0, 3.0, 2.0, 1.0]);
    let axes = Panel::new("periods", &alt)
        .x(Axis::linear("period / d").range(280.0, 480.0))
        .y(Axis::linear("").range(0.5, 4.5).ticks(Vec::<(f64, &str)>::new()));
    let row = |panel: Panel, ((name, period), y): (&(&str, f64), f64)| {
        let ink = if y > 2.5 { Ink::Body } else { Ink::Frame };
        let side = if *period > 400.0 { Side::Left } else { Side::Right };
        match y > 2.5 {
            true => panel.dot(*period, y, ink, name, side),
            false => panel.ring(*period, y, ink, name, side),
        }
    };
    rows.fold(axes, row).figure()
}

/// The path of the pole: a circle, and two of them that beat.
fn path(p: &Parameters) -> Result<Figure> {
    let alt = "The path of the pole on the ground, in seconds of arc: two circular motions, of 433 and \
               365 days, add up to a spiral that winds in and out. Dashed, the single circle of a rigid Earth.";
    let wound = times(0.0, 6.4, 900).map(|years| {
        let t = TAU * YEAR * years;
        let ((sc, cc), (sa, ca)) = (sincos(t / 433.0), sincos(t / YEAR));
        (0.15 * cc + 0.09 * ca, 0.15 * sc + 0.09 * sa)
    });
    let alpha = alpha(p) / ARCSEC;
    Panel::new("path", alt)
        .x(Axis::linear("towards Greenwich / arcsec").range(-0.4, 0.4))
        .y(Axis::linear("towards 90° east / arcsec").range(-0.4, 0.4))
        .equal_aspect()
        .curve(Curve::new(circle(alpha, 0.0, TAU), Ink::Ink).dashed())
        .curve(Curve::new(wound, Ink::Velocity).thin())
        .figure()
}

/// A year under the Sun's torque.
fn year(p: &Parameters) -> Result<Figure> {
    let alt = "How far the axis of the Earth has gone round in a year under the Sun's torque: it falls \
               to minus 16 seconds of arc in two steps, steepest at the solstices. Dots, simulated; the \
               dashed straight line is the mean precession.";
    let [day, rate] = [86_400.0, equinoxes::SUN.rate(flattening(p)?)?];
    let ripple = |d: f64| equinoxes::ripple(p, d * day);
    let exact = Curve::sampled(
        times(0.0, YEAR, 200),
        |d| Ok((rate * d * day + ripple(d)?) / ARCSEC),
        Ink::Ink,
    )?;
    let at: Vec<f64> = times(0.0, YEAR, 24).skip(1).collect();
    let seconds: Vec<f64> = at.iter().map(|d| d * day).collect();
    let moved = equinoxes::year(p, &seconds, 1e-7)?;
    let dots = at.iter().zip(moved).map(|(&d, [round, _])| (d, round / ARCSEC));
    Panel::new("year", alt)
        .x(Axis::linear("days from an equinox").range(0.0, 365.25))
        .y(Axis::linear(r"$\psi$ / arcsec").range(-17.0, 0.0))
        .curve(Curve::of([0.0, YEAR], |d| rate * d * day / ARCSEC, Ink::Frame).dashed())
        .curve(exact)
        .curve(Curve::new(dots, Ink::Body).dots())
        .figure()
}

/// The pole seen from above, and the latitude of two places.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (motion, f) = (motion(p)?, flattening(p)?);
    let (day, reach) = (86_400.0, 1.5 * p.wander);
    let end = p.day / f;
    let (size, radius) = (alpha(p) / ARCSEC, p.radius);
    let latitude = move |d: f64, east: f64| size * cos(TAU * d * day / end - east);
    let curve = move |east: f64, ink| {
        Curve::of(times(0.0, end / day, 200), move |d| latitude(d, east), ink)
    };
    let days = 0.0..=end / day;
    let graph = Panel::new("graph", "")
        .over("$t$ / d", "change of latitude / arcsec")
        .curve(curve(0.0, Ink::Ink).label("Greenwich"))
        .curve(curve(PI / 2.0, Ink::Frame).dashed().label("90° E"));
    let stills = [0.0, 0.15, 0.5].map(|part| part * end / day);
    MovingPicture::new(days, stills, move |t| {
        let w = motion.angular_velocity(t * day);
        let at = (radius * w.x() / w.z(), radius * w.y() / w.z());
        let past = circle(
            radius * tan(size * ARCSEC),
            0.0,
            (TAU * t * day / end).max(1e-3),
        );
        let alt = format!(
            "The pole of rotation after {t:.0} days, seen from above the north pole: {:.0} m from the \
             figure axis, eastward on its circle. Below, the latitudes of Greenwich and of a \
             place 90 degrees east of it, which differ from their means by up to {size:.1} arcsec.",
            hypot(at.0, at.1)
        );
        let ground = Sketch::new("scene", &alt)
            .window((-1.1 * reach, 1.25 * reach), (-0.85 * reach, 0.9 * reach))
            .curve(
                Curve::new(circle(radius * tan(size * ARCSEC), 0.0, TAU), Ink::Frame)
                    .thin()
                    .dashed(),
            )
            .curve(Curve::new(past, Ink::Velocity))
            .arrow(
                (0.0, 0.0),
                (1.1 * reach, 0.0),
                Ink::Frame,
                "Greenwich",
                Side::Below,
            )
            .arrow(
                (0.0, 0.0),
                (0.0, 0.82 * reach),
                Ink::Frame,
                "90° E",
                Side::Right,
            )
            .dot((0.0, 0.0), Ink::Body, "$z$", Side::BelowLeft)
            .dot(at, Ink::Velocity, r"$\Omega$", Side::AboveRight);
        Stack::frame(&alt, ground, &graph, t)
    })
    .map(|picture| picture.timed("$t$ / d"))
}
