//! The drawings of the gyroscope that keeps a direction.

use super::*;
use kit::draw::Camera;

/// A vector of the ground or of the Earth, drawn on its axes.
fn drawn(v: BodyVector) -> SpaceVector {
    SpaceVector::from_array(v.to_array())
}

figures! { p: &Parameters, [out, back] = flights(p)?, latitude = p.latitude.to_radians();
    /// The dome of the sky above the ground. A point that starts at the north of the horizon rises
    /// in the east and goes round the pole of the sky in a circle; one that starts in the east
    /// goes up over the south and down in the west. A dot marks the first after six hours. The pole, where the axis of the Earth points, stays.
    sky: {
        let path = |start: f64, to: f64| times(0.0, to, 240).map(move |turn| drawn(towards(star(latitude, start, turn))));
        let (o, at) = (SpaceVector::zero(), |azimuth, altitude| drawn(towards([azimuth, altitude])));
        View::of(o, 1.2).camera(Camera::new(-0.9, 0.38)).sphere()
            .trace(path(0.0, TAU), Ink::Momentum)
            .trace(path(FRAC_PI_2, 0.5 * TAU), Ink::Body)
            .arrow(o, at(0.0, 0.0), Ink::Momentum, "north", Side::Above)
            .arrow(o, at(FRAC_PI_2, 0.0), Ink::Body, "east", Side::Below)
            .arrow(o, at(0.0, latitude), Ink::Velocity, r"$\Omega$", Side::Above)
            .dot(drawn(towards(star(latitude, 0.0, EARTH * 6.0 * HOUR))), Ink::Momentum, "6 h", Side::Below)
    };

    /// The globe. The planned great circle leads from the start to the destination over the far
    /// north. The track of a pilot who steers by the axle bends away to the right, ever farther from it.
    track: {
        let [x, y, z] = out.at(0.5 * out.angle)[0].to_array();
        let plan = times(0.0, out.angle, 100).map(|turned| drawn(out.at(turned)[0]));
        let flown = sampled(times(0.0, out.time, 60), |t| Ok(drawn(astray(out, t, 1e-9)?)))?;
        let lost = flown[flown.len() - 1];
        View::of(SpaceVector::zero(), 1.05).camera(Camera::new(atan2(y, x), asin(z) - 0.2)).sphere()
            .trace(plan, Ink::Ink).trace(flown, Ink::Body)
            .dot(drawn(out.from), Ink::Ink, names(p)[0], Side::Right)
            .dot(drawn(back.from), Ink::Ink, names(p)[1], Side::Left)
            .dot(lost, Ink::Body, "by the axle", Side::Right)
    };
}

/// What the start and the destination are called.
fn names(p: &Parameters) -> [&'static str; 2] {
    let page = Parameters::default();
    let from = (p.latitude, p.longitude) == (page.latitude, page.longitude);
    let to = (p.to_latitude, p.to_longitude) == (page.to_latitude, page.to_longitude);
    [if from { "London" } else { "start" }, if to { "Vancouver" } else { "destination" }]
}

/// There and back: how far it has turned on this leg, its journey, and the azimuth of the axle, rad.
fn under_way(p: &Parameters, t: f64) -> Result<(Journey, f64, f64)> {
    let [out, back] = flights(p)?;
    let (way, since, before) = match t <= out.time {
        true => (out, t, 0.0),
        false => (back, t - out.time, out.drift(out.angle).iter().sum()),
    };
    let turned = way.angle * (since / way.time).min(1.0);
    Ok((way, turned, before + way.drift(turned).iter().sum::<f64>()))
}

/// The flights there and back, for `--csv`.
pub fn trajectory(p: &Parameters) -> Result<Trajectory> {
    let (end, columns) = (2.0 * flights(p)?[0].time, ["t [s]", "course [rad]", "azimuth [rad]"]);
    Trajectory::sampled(columns, times(0.0, end, 600), |t| {
        let (way, turned, azimuth) = under_way(p, t)?;
        Ok([t, way.course(turned), azimuth])
    })
}

/// The Earth from above its pole, the stars at rest: the axle on the flights there and back.
pub fn moving_picture(p: &Parameters) -> Result<MovingPicture> {
    let ([out, back], [start, destination], p) = (flights(p)?, names(p), p.clone());
    let end = 2.0 * out.time / HOUR;
    let azimuth = sampled(times(0.0, end, 300), |hour| {
        Ok((hour, under_way(&p, hour * HOUR)?.2.to_degrees()))
    })?;
    let graph = Panel::over_axes("$t$ / h", r"azimuth $\alpha$ / deg").level(0.0, Ink::Frame, "");
    let graph = graph.curve(Curve::new(azimuth, Ink::Momentum)).low();
    // It is seen from the half of the Earth on which it flies.
    let middle = out.from.z() + back.from.z();
    MovingPicture::above(graph, 0.0..=end, [0.0, 0.5 * end, end], move |hour| {
        let t = hour * HOUR;
        let (way, turned, azimuth) = under_way(&p, t)?;
        let turn = Attitude::from_rotation_vector(SpaceVector::new(0.0, 0.0, EARTH * t))?;
        let at = way.at(turned)[0];
        let (here, there) = (turn.to_space(at), ground(at, EARTH * t)?);
        let [axle, north] = [azimuth, 0.0].map(|a| there.to_space(towards([a, 0.0])));
        let route = times(0.0, out.angle, 60).map(|a| turn.to_space(out.at(a)[0]));
        let alt = format!(
            "The Earth from above the {} pole after {hour:.1} hours, turned with its meridians; the \
             aircraft on its great circle, behind it a fading ribbon where it has flown. A blue arrow, L \
             along the axle, points {:.0} degrees to the {} of the north; below, this angle against time.",
            if middle < 0.0 { "south" } else { "north" },
            azimuth.to_degrees().abs(),
            if azimuth < 0.0 { "left" } else { "right" }
        );
        let since = if t <= out.time { 0.0 } else { out.time };
        let flown = sampled(times(since.max(t - 3.0 * HOUR), t, 60), |s| {
            let (way, turned, _) = under_way(&p, s)?;
            Ok(turn.to_space(way.at(turned)[0]))
        })?;
        let scene = View::of(SpaceVector::zero(), 1.08)
            .camera(Camera::new(-FRAC_PI_2, 1.2_f64.copysign(middle)))
            .size(340, 300)
            .globe(EARTH * t)
            .trace(route, Ink::Frame)
            .trail(flown.into_iter().map(|p| p * 1.01), Ink::Body)
            .dot(turn.to_space(out.from), Ink::Ink, start, Side::Right)
            .dot(turn.to_space(back.from), Ink::Ink, destination, Side::Below)
            .arrow(here, here + north * 0.4, Ink::Ink, "north", Side::Above)
            .solid(Solid::turned(here, axle, &[(-0.025, 0.09), (0.025, 0.09)]), Ink::Body)
            .vector(here, here + axle * 0.5, Ink::Momentum, "$L$", Side::Below)
            .corner(&format!("{hour:.1} h"));
        Ok((alt, scene))
    })
}
