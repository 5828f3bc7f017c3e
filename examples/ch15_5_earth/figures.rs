//! The figures of the Earth's wobble, and its moving picture.

use super::*;

/// A circle of this radius about the origin.
fn circle(radius: f64, from: f64, to: f64) -> impl Iterator<Item = (f64, f64)> {
    times(from, to, 120).map(move |angle| {
        let (s, c) = sincos(angle);
        (radius * c, radius * s)
    })
}

figures! { p: &Parameters, f = flattening(p)?, [rigid, soft] = [1.0 / f, yielding::period(p)?].map(|turns| turns * p.day / DAY),
        off = 1e3 * alpha(p) / ARCSEC, [theta, apart] = [off / (1.0 + f), off * f / (1.0 + f)];
    among_stars(format!(
        "Directions among the stars. The angular momentum stands still; the figure axis goes round \
         it at {theta:.0} thousandths of a second of arc; the angular velocity, on the other side, \
         is {apart:.0} thousandth off and its mark lies on that of the angular momentum."
    )): {
        let (reach, high, spread) = (1.35 * theta, 1.15 * theta, 0.42);
        let (s, c) = sincos(spread);
        Sketch::within((-reach, reach), (-high, high))
            .curve(Curve::new(circle(theta, 0.0, TAU), Ink::Frame).thin().dashed())
            .curve(Curve::new([(0.0, 0.0), (theta * c, theta * s)], Ink::Frame).thin())
            .arrow_along(circle(theta, spread + 0.3, spread + 1.4), Ink::Body)
            .dot((theta * c, theta * s), Ink::Body, "$z$", Side::Right)
            .dot((0.0, 0.0), Ink::Momentum, r"$L$", Side::Above)
            .ring((-apart * c, -apart * s), Ink::Velocity, r"$\Omega$", Side::Left)
            .text((0.5 * theta * c, 0.5 * theta * s), r"$\theta$", Ink::Frame, Side::Below)
    };

    /// Arcs of stars about the pole of the sky, the same on two nights. The horizon lies
    /// lower on the second night, by twice alpha, and so the pole stands higher.
    trails: {
        let stars = [(0.18, 0.4), (0.33, 2.0), (0.48, 5.0), (0.62, 3.4), (0.74, 1.1), (0.86, 4.3)];
        let sky = Sketch::within((-1.3, 1.3), (-1.55, 1.0))
            .dot((0.0, 0.0), Ink::Velocity, "pole", Side::Right)
            .curve(Curve::new([(-1.2, -1.05), (1.2, -1.05)], Ink::Body))
            .curve(Curve::new([(-1.2, -1.35), (1.2, -1.35)], Ink::Body).dashed())
            .text((-1.2, -1.05), "horizon", Ink::Body, Side::AboveRight)
            .text((-1.2, -1.35), "half a period later", Ink::Body, Side::BelowRight)
            .dimension((1.1, -1.35), (1.1, -1.05), r"$2\alpha$", Side::Right);
        let trail = |sky: Sketch, (radius, from): (f64, f64)| {
            sky.curve(Curve::new(circle(radius, from, from + 1.3), Ink::Ink))
        };
        stars.into_iter().fold(sky, trail)
    };

    periods(format!(
        "Periods of the wobble in days: rigid {rigid:.0}, with a mantle that yields {soft:.0}, with a fluid \
         core besides about 392, with oceans and as observed 433."
    )): Panel::over_axes(
            Axis::linear("period / d").range(280.0, 480.0),
            Axis::linear("").range(0.5, 4.5).ticks(Vec::<(f64, &str)>::new()),
        )
        .dot(rigid, 4.0, Ink::Body, "rigid", beside(rigid))
        .dot(soft, 3.0, Ink::Body, "mantle yields", beside(soft))
        // The rounded values of the literature that the page names.
        .ring(392.0, 2.0, Ink::Frame, "and fluid core", Side::Right)
        .ring(433.0, 1.0, Ink::Frame, "and oceans: observed", Side::Left);

    /// The path of the pole on the ground, in seconds of arc: two circular motions, of 433 and
    /// 365 days, add up to a spiral that winds in and out. Dashed, the single circle of a rigid Earth.
    path: {
        let wound = times(0.0, 6.4, 900).map(|years| {
            let t = TAU * YEAR * years;
            let ((sc, cc), (sa, ca)) = (sincos(t / 433.0), sincos(t / YEAR));
            (0.15 * cc + 0.09 * ca, 0.15 * sc + 0.09 * sa)
        });
        let axis = |label| Axis::linear(label).range(-0.4, 0.4);
        Panel::over_axes(axis("towards Greenwich / arcsec"), axis("towards 90° east / arcsec"))
            .equal_aspect()
            .curve(Curve::new(circle(alpha(p) / ARCSEC, 0.0, TAU), Ink::Ink).dashed())
            .curve(Curve::new(wound, Ink::Velocity).thin())
    };

    /// How far the axis of the Earth has gone round in a year under the Sun's torque: it falls
    /// to minus 16 seconds of arc in two steps, steepest at the solstices. Dots, simulated; the
    /// dashed straight line is the mean precession.
    year: {
        let rate = SUN.rate(f);
        let exact = |d: f64| (rate * d * DAY + equinoxes::ripple(rate, d * DAY)) / ARCSEC;
        let at = times(0.0, YEAR, 24).skip(1);
        let seconds: Vec<f64> = at.clone().map(|d| d * DAY).collect();
        let moved = equinoxes::year(p, &seconds, 1e-7)?;
        let dots = at.zip(moved).map(|(d, [round, _])| (d, round / ARCSEC));
        Panel::over_axes(
            Axis::linear("days from an equinox").range(0.0, 365.25),
            Axis::linear(r"$\psi$ / arcsec").range(-17.0, 0.0),
        )
            .curve(Curve::of([0.0, YEAR], |d| rate * d * DAY / ARCSEC, Ink::Frame).dashed())
            .curve(Curve::of(times(0.0, YEAR, 200), exact, Ink::Ink))
            .curve(Curve::new(dots, Ink::Body).dots())
    };
}

/// The side of a mark on which its name fits.
fn beside(period: f64) -> Side {
    if period > 400.0 { Side::Left } else { Side::Right }
}

/// The pole seen from above, and the latitude of two places.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (motion, end) = (motion(p)?, p.day / flattening(p)?);
    let (size, radius, reach) = (alpha(p) / ARCSEC, p.radius, 1.5 * p.wander);
    let latitude = |east: f64, ink| {
        let change = move |d: f64| size * cos(TAU * d * DAY / end - east);
        Curve::of(times(0.0, end / DAY, 200), change, ink)
    };
    let graph = Panel::over_axes("$t$ / d", "change of latitude / arcsec")
        .curve(latitude(0.0, Ink::Ink).label("Greenwich"))
        .curve(latitude(PI / 2.0, Ink::Frame).dashed().label("90° E"));
    let stills = [0.0, 0.15, 0.5].map(|part| part * end / DAY);
    MovingPicture::above(graph, 0.0..=end / DAY, stills, move |t| {
        let w = motion.angular_velocity(t * DAY);
        let at = (radius * w.x() / w.z(), radius * w.y() / w.z());
        let walked = |to| circle(radius * tan(size * ARCSEC), 0.0, to);
        let past = walked((TAU * t * DAY / end).max(1e-3));
        let alt = format!(
            "The pole of rotation after {t:.0} days, seen from above the north pole: {:.0} m from the \
             figure axis, eastward on its circle. Below, the latitudes of Greenwich and of a \
             place 90 degrees east of it, which differ from their means by up to {size:.1} arcsec.",
            hypot(at.0, at.1)
        );
        let (o, greenwich, east) = ((0.0, 0.0), (1.1 * reach, 0.0), (0.0, 0.82 * reach));
        let ground = Sketch::within((-1.1 * reach, 1.25 * reach), (-0.85 * reach, 0.9 * reach))
            .curve(Curve::new(walked(TAU), Ink::Frame).thin().dashed())
            .curve(Curve::new(past, Ink::Velocity))
            .arrow(o, greenwich, Ink::Frame, "Greenwich", Side::Below)
            .arrow(o, east, Ink::Frame, "90° E", Side::Right)
            .dot(o, Ink::Body, "$z$", Side::BelowLeft)
            .dot(at, Ink::Velocity, r"$\Omega$", Side::AboveRight);
        Ok((alt, ground))
    })
}
