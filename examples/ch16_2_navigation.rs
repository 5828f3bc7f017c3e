//! The free gyroscope as a navigator: an axle that keeps its direction on the turning Earth and on
//! a journey, notes, Chapter 16, Section 2 (3).

#[path = "ch16_2_navigation/figures.rs"]
mod figures;
#[path = "ch16_2_navigation/physics.rs"]
pub mod physics;

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};
use kit::prelude::*;
use kit::{decimals, short};
use physics::*;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::body::RigidBody;
use rotation_dynamics::effects::GravityAtLever;
use rotation_dynamics::inertia::PrincipalMoments;
use rotation_dynamics::integrators::{
    Dop853, Integrator, Work, after, ode, place_and_velocity, size_or,
};
use rotation_dynamics::scene::Scene;

parameters! {
    /// An aircraft from London to Vancouver, with a rotor for its compass card.
    pub struct Parameters {
        /// latitude of the start, negative in the south
        latitude: number(51.47, "deg", from_to(-89.0, 89.0).because("near a pole no direction is north"));
        /// longitude of the start, negative in the west
        longitude: number(-0.45, "deg", from_to(-180.0, 180.0).because("a half turn east or west"));
        /// latitude of the destination
        to_latitude: number(49.19, "deg", from_to(-89.0, 89.0).because("near a pole no direction is north").usually(-50.0, 75.0)).open("latitude of the destination", "south", "north");
        /// longitude of the destination
        to_longitude: number(-123.18, "deg", from_to(-180.0, 180.0).because("a half turn east or west"));
        /// speed over the ground
        speed: number(250.0, "m/s", from_to(1.0, 7900.0).because("slower it flies for months, faster it leaves the Earth").usually(100.0, 600.0)).open("speed over the ground", "slow", "fast");
        /// mass of the rotor
        mass: number(0.5, "kg", above(0.0).usually(0.1, 2.0));
        /// its moment of inertia about the axle
        axial: number(2.2e-4, "kg m^2", above(0.0).usually(5e-5, 1e-3));
        /// its spin
        spin: number(2500.0, "rad/s", any().usually(1000.0, 2500.0));
        /// distance of its centre of mass from the pivots, along the axle
        offset: number(1e-6, "m", above(0.0).usually(1e-7, 1e-5));
        gravity: gravity(above(0.0).usually(9.7, 9.9));
        tolerance: step(1e-13, 1e-6);
    }
}

/// Seconds in an hour.
const HOUR: f64 = 3600.0;

/// The flights there and back.
pub fn flights(p: &Parameters) -> Result<[Journey; 2]> {
    let at = |latitude: f64, longitude: f64| place(latitude.to_radians(), longitude.to_radians());
    let (from, to) = (at(p.latitude, p.longitude), at(p.to_latitude, p.to_longitude));
    let [out, back] = [(from, to), (to, from)].map(|(a, b)| Journey::great_circle(a, b, p.speed));
    from_to(0.1, 179.9)
        .because("less is no journey, and to the opposite place every way is the shortest")
        .check("angle from start to destination, deg,", out.angle.to_degrees())?;
    Ok([out, back])
}

/// Along a parallel by so many radians of longitude to the east.
pub fn parallel(latitude: f64, angle: f64, time: f64) -> Journey {
    Journey { from: place(latitude, 0.0), pole: BodyVector::new(0.0, 0.0, 1.0), angle, time }
}

/// Azimuth at the end of an axle set to the north and carried in space, with the whole turns of
/// `known`; and the work.
pub fn carry(way: Journey, earth: f64, known: f64, step: f64) -> Result<(f64, Work)> {
    let axle = ground(way.from, 0.0)?.to_space(towards([0.0; 2])).to_array();
    let run = Dop853::new(step)?.advance(&way.carried(earth), 0.0, &axle, way.time)?;
    let end = ground(way.at(way.angle)[0], earth * way.time)?;
    Ok((near(known, sky(end.to_body(SpaceVector::from_array(run.0)))[0]), run.1))
}

/// The angle less whole turns, as near to `known` as can be.
fn near(known: f64, angle: f64) -> f64 {
    let (s, c) = sincos(angle - known);
    known + atan2(s, c)
}

/// The place after `time` of a pilot who steers by the axle.
pub fn astray(way: Journey, time: f64, step: f64) -> Result<BodyVector> {
    let ([x, y, z], [u, v, w]) = (way.from.to_array(), way.at(0.0)[1].to_array());
    let [x, y, z, ..] = after(time, &way.steered(), &[x, y, z, u, v, w], step)?;
    Ok(BodyVector::new(x, y, z))
}

/// The same in space, where the axle is carried along and the heading is counted from it.
fn astray_in_space(way: Journey, time: f64, step: f64) -> Result<BodyVector> {
    let (axis, rate) = (SpaceVector::new(0.0, 0.0, EARTH), way.angle / way.time);
    let (s, c) = sincos(way.course(0.0));
    let law = ode(|_, state: &[f64; 6]| {
        let [up, axle] = place_and_velocity(state);
        let moves = axis.cross(&up) + (axle * c + axle.cross(&up) * s) * rate;
        let ([a, b, c], [d, e, f]) = (moves.to_array(), (up * -axle.dot(&moves)).to_array());
        [a, b, c, d, e, f]
    });
    let axle = ground(way.from, 0.0)?.to_space(towards([0.0; 2]));
    let ([x, y, z], [u, v, w]) = (way.from.to_array(), axle.to_array());
    let end = after(time, &law.scaled(size_or([1.0; 6])), &[x, y, z, u, v, w], step)?;
    Ok(Attitude::from_rotation_vector(axis * time)?.to_body(place_and_velocity(&end)[0]))
}

/// The rate m g d/L at which a level axle turns about the vertical with its weight off the pivots,
/// rad/s. The same from the motion of the whole rotor, a flat disc released level and at rest but
/// for its spin. By how much the nods and the tolerance may part the two.
pub fn unbalance(p: &Parameters) -> Result<[f64; 3]> {
    let (weight, momentum, across) = (p.mass * p.gravity, p.axial * p.spin, 0.5 * p.axial);
    let nods = weight * p.offset * across / (momentum * momentum);
    allowed! {
        "size of the spin": p.spin.abs(), above(0.0), "without spin it falls";
        "m g d I_t/L^2": nods, from_to(1e-16, 1e-4),
            "with more it nods, and less is lost in the rounding of the spin";
    }?;
    let rate = weight * p.offset / momentum;
    let time = (1.5e5 / p.spin.abs()).min(1.0 / rate.abs());
    let body = RigidBody::new(PrincipalMoments::symmetric(across, p.axial)?);
    let scene = Scene::new(body).with(GravityAtLever::new(weight, p.offset)?);
    let level = Attitude::from_euler(EulerAngles { phi: 0.0, theta: FRAC_PI_2, zeta: 0.0 })?;
    let start = body.state(level, BodyVector::new(0.0, 0.0, p.spin))?;
    let axle = scene.solve(&start, time, 1e-9)?.state.attitude.axis();
    Ok([rate, atan2(axle.x(), -axle.y()) / time, (2.0 * nods + 2e-9) / time])
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let ([out, back], step, bound) = (flights(p)?, p.tolerance, 100.0 * p.tolerance);
    let (latitude, turn) = (p.latitude.to_radians(), EARTH * 6.0 * HOUR);
    let (s, c) = sincos(latitude);
    let at = |latitude: f64, turned: f64| ground(place(latitude, 0.0), turned);
    let [azimuth, altitude] = star(latitude, 0.0, turn);
    let set = at(latitude, 0.0)?.to_space(towards([0.0; 2]));
    let seen = sky(at(latitude, turn)?.to_body(set));
    // How the ground turns in a second on its axes, while the place goes north at this rate.
    let turns = |rate: f64| -> Result<[f64; 3]> {
        let at = |t: f64| at(latitude + rate * t, EARTH * t);
        Ok((at(-0.5)?.inverse() * at(0.5)?).rotation_vector().to_array())
    };
    let ([_, _, up], [east, north, _]) = (turns(0.0)?, turns(p.speed / RADIUS)?);
    let (turning, compass) = (EARTH * s, -atan2(p.speed / RADIUS, EARTH * c));
    let day = TAU / turning;
    let [[path, earth], [path_back, earth_back]] = [out, back].map(|way| way.drift(way.angle));
    let (there, home) = (path + earth, path_back + earth_back);
    let carried = |way, earth, known| Ok::<_, kit::Error>(carry(way, earth, known, step)?.0);
    let long = bound * (1.0 + EARTH * out.time);
    // Off the plan, along the ground, km.
    let off = |at: BodyVector, time: f64| {
        let [plan, _] = out.at(out.angle / out.time * time);
        1e-3 * RADIUS * atan2(at.cross(&plan).norm(), at.dot(&plan))
    };
    let [rate, measured, unsure] = unbalance(p)?;
    let degrees = f64::to_degrees;
    claims! { report,
        /// free axle, set level and north: azimuth after six hours
        azimuth: degrees(azimuth), "deg", "attitudes of the ground" => degrees(near(azimuth, seen[0])),
        within 1e-11 / cos(altitude), if cos(altitude) > 1e-6;
        /// its altitude
        altitude: degrees(altitude), "deg", "attitudes of the ground" => degrees(seen[1]), within 1e-11;
        /// level axle at rest on the ground: rate of drift
        turning: degrees(turning) * HOUR, "deg/h", "two grounds, a second apart" => degrees(up) * HOUR, within 1e-9;
        /// time in which it goes once round
        day: day / HOUR, "h", "carried in space" => (day - carried(parallel(latitude, 0.0, day.abs()), EARTH, 0.0)? / turning) / HOUR,
        within bound * day * (1.0 + EARTH * day.abs()) / HOUR / (s * s), if s.abs() > 0.01;
        /// once round the pole on the parallel, the Earth at rest
        round: degrees(TAU * s), "deg", "an eighth of it, eight times" =>
        degrees(8.0 * carried(parallel(latitude, FRAC_PI_4, 1.0), 0.0, FRAC_PI_4 * s)?), within 1e3 * bound;
        /// flight there: drift by the path
        path: degrees(path), "deg", "carried in space" => degrees(carried(out, 0.0, path)?), within 100.0 * bound;
        /// flight there: drift
        out: degrees(there), "deg", "carried in space" => degrees(carried(out, EARTH, there)?), within 100.0 * long;
        /// flight back: drift
        back: degrees(home), "deg", "carried in space" => degrees(carried(back, EARTH, home)?), within 100.0 * long;
        /// after an hour of steering by the axle: off the plan
        off: off(astray(out, HOUR, step)?, HOUR), "km", "carried in space" => off(astray_in_space(out, HOUR, step)?, HOUR),
        within 1e5 * bound;
        /// at the time of the arrival: off the destination
        missed: off(astray(out, out.time, step)?, out.time), "km", "carried in space" => off(astray_in_space(out, out.time, step)?, out.time),
        within 1e5 * long * (1.0 + EARTH * out.time);
        /// drift by the unbalance
        unbalance: degrees(rate) * HOUR, "deg/h", "the whole rotor" => degrees(measured) * HOUR,
        within degrees(unsure) * HOUR;
        /// a gyrocompass on an aircraft that flies north: azimuth at rest
        compass: degrees(compass), "deg", "two grounds, a second apart" => degrees(atan2(east, north)), within 1e-5;
    }?;
    report.add(journeys(p)?)
}

/// Four journeys, and the drift of a level axle on each, in degrees.
fn journeys(p: &Parameters) -> Result<Table> {
    let ([out, back], latitude) = (flights(p)?, p.latitude.to_radians());
    let turned = (p.to_longitude - p.longitude).to_radians();
    let time = (RADIUS * cos(latitude) * turned / p.speed).abs();
    let [away, home] = [turned, -turned].map(|angle| parallel(latitude, angle, time));
    let ways =
        [("there", out), ("back", back), ("there, parallel", away), ("back, parallel", home)];
    let columns = ["journey", "hours", "by the path", "by the Earth", "sum", "carried in space"];
    Table::of("journeys", columns, ways, |(name, way)| {
        let [path, earth] = way.drift(way.angle);
        let carried = carry(way, EARTH, path + earth, p.tolerance)?.0;
        let [a, b, c, d] =
            [path, earth, path + earth, carried].map(|x| decimals(x.to_degrees(), 2));
        Ok([name.to_owned(), short(way.time / HOUR, 3), a, b, c, d])
    })
}

/// Where the answer is known without a formula.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let ([out, _], step, bound) = (flights(p)?, p.tolerance, 100.0 * p.tolerance);
    let at = |way, earth| Ok::<_, kit::Error>(carry(way, earth, 0.0, step)?.0);
    let turned = out.course(out.angle) - out.course(0.0);
    limits! { report,
        /// the ground does not turn about the vertical
        "equator, a day at rest: azimuth": at(parallel(0.0, 0.0, TAU / EARTH), EARTH)? => 0.0, within bound;
        /// it lies along the axis of the Earth
        "free, equator, set north: altitude": star(0.0, 0.0, 1.0)[1] => 0.0, within 1e-14;
        /// the ground turns about the vertical only
        "free, pole: azimuth/(Omega t)": star(FRAC_PI_2, 0.0, 1.0)[0] => 1.0, within 1e-14;
        /// a great circle does not bend
        "Earth at rest, great circle: axle less course": carry(out, 0.0, turned, step)?.0 - turned => 0.0, within bound;
        /// for the stars the aircraft stays where it is
        "west as fast as the ground: azimuth": at(parallel(0.8, -1.0, 1.0 / EARTH), EARTH)? => 0.0, within bound;
    }
}

/// The card of effects for the flight there: it flies at 11 km, and each pivot of the gimbals resists
/// with 1e-6 N m. The pole of the sky moves by 50.3 arcsec a year.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let ([out, _], [rate, measured, _]) = (flights(p)?, unbalance(p)?);
    let ([path, earth], momentum) = (out.drift(out.angle), (p.axial * p.spin).abs());
    let (height, plumb, rub) = (1.1e4 / RADIUS, 2.0 * EARTH * p.speed / p.gravity, 1e-6 / momentum);
    let higher = Journey { time: out.time * (1.0 + height), ..out };
    let raised = carry(higher, EARTH, path + earth, p.tolerance)?.0 - path - earth;
    let moves = (50.3_f64 / 3600.0).to_radians() / 3.155_76e7;
    effect_card! { report,
        "unbalance along the axle": "m g d/(L Omega)" = rate.abs() / EARTH, costs rate.abs() * out.time, "rad",
            measured measured.abs() * out.time;
        "dry friction of a pivot": "M_f/(L Omega)" = rub / EARTH, costs rub * out.time, "rad";
        "plumb line of the moving aircraft": "2 Omega v/g" = plumb, costs plumb * EARTH * out.time, "rad, at most";
        "flattening of the Earth": "f" = 1.0 / 298.257, costs earth.abs() / 298.257, "rad";
        "height of the flight": "h/R" = height, costs height * earth.abs(), "rad", measured raised.abs(), within 1e3 * p.tolerance;
        "precession of the Earth's axis": "p/Omega" = moves / EARTH, costs moves * out.time, "rad";
    }
}

/// The accuracy strip: the axle on the flight there, carried in space.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let [out, _] = flights(p)?;
    let [path, earth] = out.drift(out.angle);
    report.in_closed_form(move |part| out.drift(part * out.angle));
    let asked = [p.tolerance, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11];
    let run = move |step| carry(out, EARTH, path + earth, step);
    report.stepped(asked, run, |run| run.1, move |run| Ok((run.0 - path - earth).abs()))
}

example! {
    ch16_2_navigation: "A gyroscope that keeps a direction: on the turning Earth, and on a journey";
    "A gyroscope that keeps a direction", "An axle free to keep its direction in space, on the turning Earth and on a flight.",
    [claims, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
