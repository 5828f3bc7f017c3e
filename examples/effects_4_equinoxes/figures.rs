//! The drawings of the precession of the equinoxes.

use super::*;
use kit::draw::Camera;
use rotation_dynamics::motion::Motion;

/// On the map of the sky: the pole of the ecliptic in the middle, the pole of the epoch above
/// it, degrees. Seen from the Earth, longitudes grow clockwise.
fn on_map(v: SpaceVector) -> (f64, f64) {
    let across = hypot(v.x(), v.y());
    let radius = atan2(across, v.z()).to_degrees();
    (-radius * v.x() / across, radius * v.y() / across)
}

/// An ellipse about a place, its long axis along `angle`.
fn ellipse((x, y): (f64, f64), [long, short]: [f64; 2], angle: f64) -> Vec<(f64, f64)> {
    let (s, c) = sincos(angle);
    let point = |a: f64| {
        let (v, u) = sincos(a);
        (x + long * u * c - short * v * s, y + long * u * s + short * v * c)
    };
    times(0.0, TAU, 90).map(point).collect()
}

/// Longitude over the sky and tilt of the axis less the mean precession, arcsec.
fn nutated(p: &Parameters, run: &Solution<3>, t: f64) -> Result<(f64, f64)> {
    let [precession, tilt] = angles(run.at(t)?);
    let aside = (precession - rate(p) * t) * sin(p.obliquity);
    Ok((aside / ARCSEC, (tilt - p.obliquity) / ARCSEC))
}

/// Where the figure axis of the full body is beside that of the axis alone, mas.
fn wobbled(p: &Parameters, end: f64) -> Result<Vec<(f64, f64)>> {
    let system = levels::full(p)?;
    let motion = levels::turning(p, &system)?;
    let alone = run(p, &in_orbit(p)?, 3, end)?;
    sampled(times(0.0, end, 600), |t| {
        let [x, y, z] = alone.at(t)?;
        let s = SpaceVector::new(x, y, z);
        let off = motion.try_state(t)?.attitude.axis() - s;
        let east = s.cross(&UP) / s.cross(&UP).norm();
        Ok((1e3 * off.dot(&east) / ARCSEC, 1e3 * off.dot(&east.cross(&s)) / ARCSEC))
    })
}

figures! { p: &Parameters, node = nutation::first_order(p)?[0];
    /// The Earth in June from the side: a flattened body whose axis leans to the right of the
    /// normal of the ecliptic. The Sun is far to the right, in the horizontal plane. The
    /// near bulge, below that plane, is pulled more than the far one, above it: arrows to the
    /// right, the lower one longer. The torque, at the tip of L, points out of the picture.
    bulge: {
        let tilt = 0.5 * PI - p.obliquity;
        let out = |angle: f64, length: f64| (length * cos(angle), length * sin(angle));
        let bulge = -p.obliquity;
        let (near, far) = (out(bulge, 0.86), out(bulge + PI, 0.86));
        Sketch::within((-1.6, 1.95), (-1.05, 1.5))
            .body(ellipse((0.0, 0.0), [1.0, 0.72], bulge), Ink::Body, 0.18)
            .guide([(-1.5, 0.0), (1.9, 0.0)])
            .text((-1.5, 0.0), "ecliptic", Ink::Frame, Side::AboveRight)
            .guide([(0.0, 0.0), (0.0, 1.35)])
            .guide([out(bulge, 1.15), out(bulge + PI, 1.15)])
            .text(out(bulge + PI, 1.15), "equator", Ink::Body, Side::Left)
            .arrow((0.0, 0.0), out(tilt, 1.3), Ink::Momentum, "", Side::Left)
            .text(out(tilt, 1.0), "$L$", Ink::Momentum, Side::Right)
            .angle((0.0, 0.0), 1.05, (tilt, 0.5 * PI), r"$\varepsilon$")
            .arrow(near, (near.0 + 0.62, near.1), Ink::Force, "", Side::Below)
            .text((near.0 + 0.62, near.1), "more", Ink::Force, Side::Right)
            .arrow(far, (far.0 + 0.36, far.1), Ink::Force, "less", Side::Above)
            .ring(out(tilt, 1.3), Ink::Force, "", Side::Right)
            .dot(out(tilt, 1.3), Ink::Force, "torque, towards you", Side::Right)
            .text((1.9, 0.0), "to the Sun", Ink::Ink, Side::AboveLeft)
    };

    /// The northern sky about the pole of the ecliptic. A circle of 23 degrees passes Thuban on
    /// the right, Polaris at the top, Errai and Alderamin on the left and, at some distance,
    /// Vega at the bottom; marks every two thousand years, the pole moving anticlockwise.
    sky: {
        let whole = run(p, &as_rings(p)?, 1, 26_000.0 * YEAR)?;
        let path = sampled(times(0.0, 25_800.0, 600), |a| {
            Ok(on_map(SpaceVector::from_array(whole.at(a * YEAR)?)))
        })?;
        let at = |year: f64| on_map(SpaceVector::from_array(pole([rate(p) * (year - 2000.0) * YEAR, p.obliquity])));
        let mut map = Sketch::within((-36.0, 36.0), (-34.0, 34.0))
            .curve(Curve::new(path, Ink::Body))
            .arrow_along(times(2600.0, 3700.0, 20).map(at), Ink::Body)
            .dot((0.0, 0.0), Ink::Frame, "pole of the ecliptic", Side::Below);
        for year in [-6000.0, -4000.0, 0.0, 2000.0, 4000.0, 6000.0, 8000.0, 10_000.0, 12_000.0, 14_000.0, 16_000.0, 18_000.0] {
            let (x, y) = at(year);
            map = map.curve(Curve::new([(0.96 * x, 0.96 * y), (1.04 * x, 1.04 * y)], Ink::Frame).thin());
            if [-4000.0, 0.0, 6000.0, 10_000.0, 14_000.0, 18_000.0].contains(&year) {
                map = map.text((0.86 * x, 0.86 * y), &format!("{year:.0}").replace('-', "−"), Ink::Frame, Side::Centre);
            }
        }
        sky::STARS.iter().fold(map, |map, star| {
            // Where the map has room for the name.
            let left = ["Polaris", "Errai", "Deneb", "Alderamin"].contains(&star.0);
            map.dot(on_map(sky::direction(star)), Ink::Ink, star.0, if left { Side::Left } else { Side::Right })
        })
    };

    /// The pole less its mean precession over one round of the Moon's node: an ellipse, a
    /// little higher than wide; a fine line with two wiggles a year runs along it.
    ellipse: {
        let round = nutation::node_round(p);
        let (orbits, rings) = (run(p, &in_orbit(p)?, 3, round)?, run(p, &as_rings(p)?, 1, round)?);
        let fine = sampled(times(0.0, round, 2400), |t| nutated(p, &orbits, t))?;
        let smooth = sampled(times(0.0, round, 200), |t| nutated(p, &rings, t))?;
        let most = 1.15 * node[1].max(node[0] * sin(p.obliquity)).max(1.0);
        Panel::over_axes(
                Axis::linear(r"$\psi\,\sin\varepsilon$ / arcsec").range(-most, most),
                Axis::linear(r"$\Delta\varepsilon$ / arcsec").range(-most, most))
            .equal_aspect()
            .curve(Curve::new(smooth, Ink::Frame).dashed())
            .curve(Curve::new(fine, Ink::Body).thin().arrow(0.1))
    };

    /// The tilt of the axis over a year. The dashed curve of the rings rises or falls slowly;
    /// the full curve swings about it twice a year by half a second of arc, with ripples of
    /// half a month on it.
    year: {
        let (orbits, rings) = (run(p, &in_orbit(p)?, 3, YEAR)?, run(p, &as_rings(p)?, 1, YEAR)?);
        let tilt = |run: &Solution<3>, d: f64| Ok(nutated(p, run, (d * DAY).min(YEAR))?.1);
        Panel::over_axes("days of the year 2000", r"$\Delta\varepsilon$ / arcsec")
            .curve(Curve::sampled(times(0.0, 365.25, 60), |d| tilt(&rings, d), Ink::Frame)?.dashed().label("rings"))
            .curve(Curve::sampled(times(0.0, 365.25, 500), |d| tilt(&orbits, d), Ink::Body)?.label("in their orbits"))
    };

    /// Five days of the figure axis of the full body, seen from the axis alone, in thousandths
    /// of a second of arc: daily loops, nearly circles, that do not quite close.
    days: Panel::over_axes("along the precession / mas", "towards the ecliptic’s pole / mas")
        .equal_aspect()
        .curve(Curve::new(wobbled(p, 5.0_f64.min(p.days) * DAY)?, Ink::Body).thin().arrow(0.05));
}

/// The motion over a round of the node, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let round = nutation::node_round(p);
    let path = run(p, &in_orbit(p)?, 3, round)?;
    let columns = ["t [d]", "precession [arcsec]", "tilt [rad]"];
    Trajectory::of(&path, columns, 3000, |t, state| {
        let [precession, tilt] = angles(state);
        [t / DAY, precession / ARCSEC, tilt]
    })
}

/// A year of the Sun alone: its torque, and how far the axis has gone round.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let (sun, days) = (sun(p)?, 365.25);
    let mean = pole([0.0, p.obliquity]);
    let alone = axis(p, move |t| [sun.pull(t)]);
    let path = Dop853::new(p.tolerance)?.solve(&alone, 0.0, &mean, YEAR, &[])?;
    let moved = sampled(times(0.0, days, 200), |d| {
        Ok((d, angles(path.at((d * DAY).min(YEAR))?)[0] / ARCSEC))
    })?;
    let graph = Panel::over_axes("days of the year 2000", r"$\psi$ by the Sun / arcsec")
        .curve(Curve::new(moved, Ink::Body));
    let o = SpaceVector::zero();
    let s = SpaceVector::from_array(mean);
    let (largest, rim) = (0.5 * sin(2.0 * p.obliquity), 0.42);
    let profile: Vec<(f64, f64)> =
        times(-0.5 * PI, 0.5 * PI, 16).map(|a| (0.72 * rim * sin(a), rim * cos(a))).collect();
    let front = SpaceVector::new(cos(0.35), -sin(0.35), 0.0);
    let stills = [79.0, 172.0, 265.0];
    MovingPicture::above(graph, 0.0..=days, stills, move |d| {
        let (n, _) = sun.pull(d * DAY);
        let torque = n.cross(&s) * (n.dot(&s) / largest);
        let longitude = atan2(n.y(), n.x()).to_degrees().rem_euclid(360.0);
        let size = torque.norm();
        let torque_told = match size > 0.02 {
            true => {
                format!("has {size:.2} of the greatest size and lies in the plane of the equator")
            }
            false => "is too small to be drawn".into(),
        };
        let alt = format!(
            "The Earth after {d:.0} days of the year 2000, flattened far too much. The Sun stands at \
             the longitude {longitude:.0} degrees; its torque on the Earth {torque_told}; below, how far the axis has gone round."
        );
        let ring = times(0.0, TAU, 90).map(|a| SpaceVector::new(cos(a), sin(a), 0.0));
        let mut scene = View::of(UP * 0.26, 0.93)
            .size(340, 250)
            .camera(Camera::new(-0.35, 0.42))
            .dashed(ring, Ink::Frame)
            .sunlit(Solid::turned(o, s, &profile), Ink::Body, n)
            .circle(o, s, 1.02 * rim, Ink::Ink)
            .dashed([o, UP * 0.95], Ink::Frame)
            .dashed([o, n], Ink::Energy)
            .dot(n, Ink::Energy, "Sun", if n.dot(&front) > 0.0 { Side::Below } else { Side::Above })
            .vector(o, s, Ink::Momentum, "$L$", Side::Right);
        if size > 0.02 {
            scene = scene.arrow(s, s + torque * 0.5, Ink::Force, "torque", Side::Above);
        }
        Ok((alt, scene))
    })
}
