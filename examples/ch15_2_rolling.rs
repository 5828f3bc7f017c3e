//! Chapter 15, Section 2, examples 1, 2, 4 and 5: three bodies that roll, and one that only
//! goes round.

#[path = "ch15_2_rolling/figures.rs"]
mod figures;
#[path = "ch15_2_rolling/hoop.rs"]
pub mod hoop;

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use kit::prelude::*;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::integrators::{
    Dop853, Event, Integrator, Ode, Solution, Work, ode, size_or,
};

parameters! {
    /// The four bodies; the notes leave all numbers open.
    pub struct Parameters {
        /// radius of the wheel on a road
        wheel_radius: number(0.35, "m", from_to(1e-6, 1e6).usually(0.1, 1.0));
        /// its angular velocity
        wheel_rate: number(20.0, "rad/s", from_to(-1e6, 1e6).but_zero("at rest nothing rolls").usually(1.0, 50.0));
        /// radius of either coin
        coin_radius: number(0.0121, "m", from_to(1e-6, 1e6).usually(0.005, 0.05));
        /// angle through which the line of centres turns
        orbit: number(FRAC_PI_2, "rad", from_to(-1e4, 1e4).but_zero("at rest nothing rolls").usually(0.1, 6.3));
        /// radius of the cycle wheel
        radius: number(0.3, "m", from_to(1e-6, 1e6).usually(0.1, 1.0));
        /// length of its shaft
        shaft: number(0.5, "m", from_to(1e-6, 1e6).usually(0.05, 2.0));
        /// rate at which the shaft goes round Z
        rate: number(2.0, "rad/s", from_to(-1e6, 1e6).but_zero("at rest nothing rolls").usually(0.5, 5.0));
        /// rate at which the cylinder goes round Z
        cylinder_rate: number(3.0, "rad/s", from_to(-1e6, 1e6).but_zero("at rest nothing turns").usually(0.5, 5.0));
        /// angle of the cylinder's axis from Z
        tilt: number(0.5, "rad", from_to(0.001, 3.1).because("an upright axis is not carried round").usually(0.1, 1.5));
        /// rolling resistance of a hoop as a part of its weight, for the claims about it
        resistance: effect(0.005, "-", above_to(0.0, 1.0).because("what is braked more does not roll"));
        /// slip of the coin over its way along the other's rim, for the picture and the claims about it
        slip: effect(1.0, "-", above_to(0.0, 2.0).because("at 2 it slides and does not turn").usually(0.1, 2.0)).open("slip of the rolling coin", "it rolls", "it slides");
        /// error of a step of the simulations
        tolerance: number(1e-13, "-", from_to(1e-15, 1e-6));
    }
}

/// The vertical, and the direction of the shaft at the start.
const UP: SpaceVector = SpaceVector::new(0.0, 0.0, 1.0);
const RHO: SpaceVector = SpaceVector::new(1.0, 0.0, 0.0);

// ANCHOR: rolling
/// The velocity of the point `r` of a body whose point `c` is at rest.
fn velocity(angular_velocity: SpaceVector, r: SpaceVector, c: SpaceVector) -> SpaceVector {
    angular_velocity.cross(&(r - c))
}

/// A wheel on a road, in units of its radius; it touches the road below its centre. Along X
/// its centre, along X and Z a point of its rim, and the path of that point; time in 1/omega.
pub fn on_a_road() -> impl Ode<4> {
    let spin = SpaceVector::new(0.0, 1.0, 0.0);
    ode(move |_, &[x, rim_x, rim_z, _]: &[f64; 4]| {
        let contact = SpaceVector::new(x, 0.0, 0.0);
        let centre = velocity(spin, contact + UP, contact);
        let rim = velocity(spin, SpaceVector::new(rim_x, 0.0, rim_z), contact);
        [centre.x(), rim.x(), rim.z(), rim.norm()]
    })
    .scaled(size_or([1.0; 4]))
}

/// A coin on a fixed one of `fixed` times its radius, which is the unit: its centre, a point of
/// its rim, the angle of the line of centres, and the path of the point; time in radians of turn.
pub fn on_a_coin(fixed: f64) -> impl Ode<6> {
    ode(move |_, &[x, y, rim_x, rim_y, _, _]: &[f64; 6]| {
        let centre = SpaceVector::new(x, y, 0.0);
        let contact = centre * (fixed / (fixed + 1.0));
        let v = velocity(UP, centre, contact);
        let rim = velocity(UP, SpaceVector::new(rim_x, rim_y, 0.0), contact);
        let orbit = (x * v.y() - y * v.x()) / centre.dot(&centre);
        [v.x(), v.y(), rim.x(), rim.y(), orbit, rim.norm()]
    })
    .scaled(size_or([1.0; 6]))
}
// ANCHOR_END: rolling

/// The coin until the line of centres has turned by `orbit`, rad.
pub fn coin_rolled(fixed: f64, orbit: f64, step: f64) -> Result<Solution<6>> {
    let there = Event::rising("there", |_, y: &[f64; 6]| y[4] - orbit).terminal();
    let start = [fixed + 1.0, 0.0, fixed, 0.0, 0.0, 0.0];
    let long = 2.0 * (fixed + 1.0) * orbit;
    Ok(Dop853::new(step)?.solve(&on_a_coin(fixed), 0.0, &start, long, &[there])?)
}

/// The derivative of `at` at 0, from its values `h` and 2 `h` to both sides.
fn derivative(h: f64, at: impl Fn(f64) -> Result<f64>) -> Result<f64> {
    Ok((8.0 * (at(h)? - at(-h)?) - (at(2.0 * h)? - at(-2.0 * h)?)) / (12.0 * h))
}

/// The places of a corner of a regular polygon that tips along the ground, from one side to the
/// next through a turn, and the distances of that corner from those about which it tipped. The
/// circle through its corners has the radius 1.
pub fn tipping(sides: u32) -> (Vec<(f64, f64)>, f64) {
    let angle = TAU / f64::from(sides);
    let ((s, c), side) = (sincos(angle), 2.0 * sin(0.5 * angle));
    let (mut places, mut distances) = (vec![(0.0, 0.0)], 0.0);
    for pivot in (1..=sides).map(|k| f64::from(k) * side) {
        let (x, z) = places[places.len() - 1];
        distances += hypot(x - pivot, z);
        places.push((pivot + (c * (x - pivot) + s * z), c * z - s * (x - pivot)));
    }
    (places, distances)
}

/// How far the polygon gets in a turn, and the path of its corner, for ever more sides: the
/// errors are a series in the square of the length of a side.
fn polygons() -> [f64; 2] {
    let run = |sides| {
        let (places, distances) = tipping(sides);
        [places[sides as usize].0, distances * TAU / f64::from(sides)]
    };
    let [a, b, c] = [run(64), run(128), run(256)];
    [0, 1].map(|i| {
        let [d, e] = [(4.0 * b[i] - a[i]) / 3.0, (4.0 * c[i] - b[i]) / 3.0];
        (16.0 * e - d) / 15.0
    })
}

// ANCHOR: cycle
/// (15.5.15): the rate of the cycle wheel about its shaft.
pub fn spin(p: &Parameters) -> f64 {
    -p.rate * p.shaft / p.radius
}

/// (15.5.16): the angular velocity of the cycle wheel when its shaft points along `rho`.
pub fn cycle_rate(p: &Parameters, rho: SpaceVector) -> SpaceVector {
    UP * p.rate + rho * spin(p) // (15.5.14)
}

/// Where the cycle wheel is after `t` by turns alone: `spin` about its shaft, which points along
/// X, and then with the shaft about Z.
pub fn cycle_turned(p: &Parameters, spin: f64, t: f64) -> Result<Attitude> {
    let about_shaft = Attitude::about_space_axis(RHO, spin * t)?;
    Ok(Attitude::about_space_axis(UP, p.rate * t)? * about_shaft * upright()?)
}

/// The attitude that follows from an angular velocity: the quaternion q with q' = omega q/2.
pub fn carried(angular_velocity: impl Fn(f64) -> SpaceVector) -> impl Ode<4> {
    ode(move |t, &[w, x, y, z]: &[f64; 4]| {
        let [a, b, c] = (angular_velocity(t) * 0.5).to_array();
        [
            -a * x - b * y - c * z,
            a * w + b * z - c * y,
            b * w + c * x - a * z,
            c * w + a * y - b * x,
        ]
    })
    .scaled(size_or([1.0; 4]))
}
// ANCHOR_END: cycle

/// The cycle wheel at the start: its axis z points along the shaft towards the rod.
pub fn upright() -> Result<Attitude> {
    let (phi, theta) = (-FRAC_PI_2, FRAC_PI_2);
    Ok(Attitude::from_euler(EulerAngles { phi, theta, zeta: 0.0 })?)
}

/// The direction of the shaft after `t`.
pub fn along_shaft(p: &Parameters, t: f64) -> SpaceVector {
    let (s, c) = sincos(p.rate * t);
    SpaceVector::new(c, s, 0.0)
}

/// The attitude after `t` by steps, from the angular velocity.
fn cycle_carried(p: &Parameters, t: f64, step: f64) -> Result<(Attitude, Work)> {
    let law = carried(|t| cycle_rate(p, along_shaft(p, t)));
    let (q, work) = Dop853::new(step)?.advance(&law, 0.0, &upright()?.quaternion(), t)?;
    Ok((Attitude::from_quaternion(q)?, work))
}

/// The angular velocity at the time 0, on the fixed axes, from where the body is a little
/// before and a little after; `t` is the time in which it turns about once.
pub fn measured(at: impl Fn(f64) -> Result<Attitude>, t: f64) -> Result<SpaceVector> {
    let turn = |h: f64| -> Result<SpaceVector> {
        Ok((at(h)? * at(-h)?.inverse()).rotation_vector() / (2.0 * h))
    };
    Ok((turn(1e-3 * t)? * 4.0 - turn(2e-3 * t)?) / 3.0)
}

/// The velocity of the lowest point of the cycle wheel along the ground, so far outside of the
/// middle of its tyre, from where that point is shortly before and after.
pub fn slip(p: &Parameters, spin: f64, outside: f64) -> Result<f64> {
    let lowest = upright()?.to_body(RHO * outside - UP * p.radius);
    derivative(1e-3 / hypot(p.rate, spin), |t| {
        let place = along_shaft(p, t) * p.shaft + cycle_turned(p, spin, t)?.to_space(lowest);
        Ok(place.y())
    })
}

/// The spin with which the lowest point stands still: the slip is linear in it.
pub fn spin_without_slip(p: &Parameters) -> Result<f64> {
    let (guess, at_rest) = (p.rate, slip(p, 0.0, 0.0)?);
    Ok(guess * at_rest / (at_rest - slip(p, guess, 0.0)?))
}

/// The cylinder after `t`: it goes round Z and does not turn about its own axis.
pub fn cylinder(p: &Parameters, t: f64) -> Result<Attitude> {
    let (phi, theta) = (p.cylinder_rate * t, p.tilt);
    Ok(Attitude::from_euler(EulerAngles { phi, theta, zeta: 0.0 })?)
}

/// Its angular velocity on its own axes, from where it is.
pub fn on_cylinder(p: &Parameters) -> Result<BodyVector> {
    Ok(cylinder(p, 0.0)?.to_body(measured(|t| cylinder(p, t), 1.0 / p.cylinder_rate)?))
}

/// The angle that `direction` sweeps out about Z in `t`, counted on through all turns, rad.
fn swept(direction: impl Fn(f64) -> Result<SpaceVector>, t: f64) -> Result<f64> {
    let (mut sum, mut last) = (0.0, direction(0.0)?);
    for k in 1..=40 {
        let next = direction(t * f64::from(k) / 40.0)?;
        let across = last.x() * next.y() - last.y() * next.x();
        sum += atan2(across, last.x() * next.x() + last.y() * next.y());
        last = next;
    }
    Ok(sum)
}

/// What a rolling resistance takes from the speed of a hoop in the time of a turn: predicted,
/// simulated, and the work of that.
fn slowed(p: &Parameters, resistance: f64) -> Result<([f64; 2], Work)> {
    let (speed, turn) = (p.wheel_rate.abs() * p.wheel_radius, TAU / p.wheel_rate.abs());
    let stops = (0.5 * resistance * 9.80665 * turn).min(speed);
    let (slower, work) = hoop::lost(1.0, [p.wheel_radius, speed], resistance, 9.80665, turn)?;
    Ok(([stops, slower], work))
}

fn road(p: &Parameters, report: &mut Report) -> Result<()> {
    let (r, rate, bound) = (p.wheel_radius, p.wheel_rate.abs(), 100.0 * p.tolerance);
    let speed = rate * r;
    let ([distance, path], method) = (polygons(), Dop853::new(p.tolerance)?);
    let speed_after = |turn: f64| -> Result<f64> {
        let (there, _) = method.advance(&on_a_road(), 0.0, &[0.0; 4], turn)?;
        Ok(on_a_road().derivative(0.0, &there)[3])
    };
    let [stops, slower] = match p.resistance {
        None => [0.0; 2],
        Some(resistance) => slowed(p, resistance)?.0,
    };
    claims! { report,
        /// wheel: speed of its centre
        wheel_speed: speed, "m/s", "polygons that tip along" => rate * r * distance / TAU, within 1e-11 * speed, in "The wheel":
            speed / TAU => "the rate is in radians, not in turns",
            TAU * speed => "radians a second are meant, not turns";
        /// wheel: speed of its highest point
        top_speed: 2.0 * speed, "m/s", "simulated" => speed * speed_after(0.5 * TAU)?, within bound * speed, in "The wheel":
            speed => "that is the centre; the highest point is farther from the point at rest";
        /// wheel: speed of the point that touches the road
        contact_speed: 0.0, "m/s", "simulated" => speed * speed_after(TAU)?, within bound * speed;
        /// path of a point of its rim in a turn
        cycloid: 8.0 * r, "m", "polygons that tip along" => r * path, within 1e-11 * r, in "The wheel":
            TAU * r => "that is the path of the centre",
            4.0 * r => "that is half of it";
        /// with rolling resistance: speed of a hoop after the time of a turn
        resisted_speed: speed - stops, "m/s", "simulated" => speed - slower, within 1e-8 * speed, if p.resistance.is_some();
    }
}

fn coins(p: &Parameters, report: &mut Report) -> Result<()> {
    let (theta, sense, bound) = (p.orbit, p.orbit.signum(), 100.0 * p.tolerance);
    let part = coin_rolled(1.0, theta.abs(), p.tolerance)?.end_time();
    let circuit = coin_rolled(1.0, TAU, p.tolerance)?;
    let (whole, path) = (circuit.end_time(), circuit.end_state()[5]);
    // How fast a coin slides at its contact with its like, over Omega_orbit R, while it is carried
    // round at the rate 1 and spins at this rate against the line of centres: from where the point
    // that touches is shortly before and after. It is linear in the spin.
    let sliding = |spin| derivative(1e-3, |t| Ok(2.0 * sin(t) + sin(PI + (1.0 + spin) * t)));
    let (still, spun) = (sliding(0.0)?, sliding(1.0)?);
    claims! { report,
        /// coin: turned, when the line of centres has turned by --orbit
        coin_part: 2.0 * theta, "rad", "rolled about the contact" => sense * part, within bound * theta, in "The coins":
            theta => "that is seen from the line of centres, which turns as well";
        /// coin: turned, when it is back at its place
        coin_circuit: 2.0 * TAU, "rad", "rolled about the contact" => whole, within 10.0 * bound, in "The coins":
            TAU => "look how far the centre of the coin has come",
            2.0 => "an angle in radians is asked for";
        /// coin: turned as seen from the line of centres, in that circuit
        coin_seen: TAU, "rad", "the same, less the turn of the line" => whole - TAU, within 10.0 * bound;
        /// path of a point of its rim in that circuit
        cardioid: 16.0 * p.coin_radius, "m", "rolled about the contact" => p.coin_radius * path, within 100.0 * bound * p.coin_radius;
        /// with slip: coin turned, when it is back at its place
        slid_circuit: (2.0 - p.slip.unwrap_or(0.0)) * TAU, "rad",
        "places of its contact differenced" => (1.0 + (still - p.slip.unwrap_or(0.0)) / (still - spun)) * TAU, within 1e-10,
        if p.slip.is_some();
    }
}

fn cycle(p: &Parameters, report: &mut Report) -> Result<()> {
    let (rate, ratio, circuit) = (p.rate, p.shaft / p.radius, TAU / p.rate.abs());
    allowed! {
        "shaft/radius": ratio, from_to(1e-3, 1e3), "the spin or the turn about Z is lost beside the other";
    }?;
    let (spin, net, sense) = (spin(p), rate.abs() * hypot(1.0, ratio), rate.signum());
    let rolling = |t| cycle_turned(p, spin, t);
    let (turning, h) = (measured(rolling, 1.0 / net)?, 1e-3 / net);
    let euler = rolling(h)?.euler_angles().zeta - rolling(-h)?.euler_angles().zeta;
    // About the shaft, seen from the shaft: the wheel less the turn about Z.
    let mark = |t: f64| -> Result<SpaceVector> {
        let seen = Attitude::about_space_axis(UP, -rate * t)? * cycle_carried(p, t, p.tolerance)?.0;
        let mark = seen.to_space(BodyVector::new(1.0, 0.0, 0.0));
        Ok(SpaceVector::new(mark.y(), mark.z(), 0.0))
    };
    let parts = ratio.max(1.0).ceil();
    let once = swept(mark, circuit / parts)? * parts;
    claims! { report,
        /// cycle wheel: spin about its shaft, along rho
        spin: spin, "rad/s", "the lowest point stands still" => spin_without_slip(p)?, within (1e-11 + 1e-13 * ratio) * net,
        in "The cycle wheel":
            -spin => "which way does the wheel turn, seen from outside?",
            -rate / ratio => "the shaft is the long way round, the wheel's rim the short one";
        /// cycle wheel: its angular velocity
        net_rate: net, "rad/s", "turned in a short time" => turning.norm(), within 1e-11 * net, in "The cycle wheel":
            (rate - spin).abs() => "the two are at right angles",
            spin.abs() => "that is the spin alone";
        /// angle of its angular velocity from Z
        net_tilt: atan2(ratio, sense), "rad", "turned in a short time" => atan2(hypot(turning.x(), turning.y()), turning.z()), within 1e-11;
        /// cycle wheel: speed of the point that touches the ground
        cycle_contact: 0.0, "m/s", "its places differenced" => slip(p, spin, 0.0)?, within 1e-11 * net * p.radius;
        /// rate of the Euler angle zeta, with z = -rho
        zeta_rate: -spin, "rad/s", "Euler angles of the turns" => euler / (2.0 * h), within 1e-11 * net, in "The cycle wheel":
            spin => "which way does z point?";
        /// cycle wheel: turned about its shaft in a circuit, seen from the shaft
        circuit: -sense * TAU * ratio, "rad", "attitude carried by (15.5.16)" => once, within 1e4 * p.tolerance * net * circuit;
    }
}

fn orbiting(p: &Parameters, report: &mut Report) -> Result<()> {
    let ((s, c), rate) = (sincos(p.tilt), p.cylinder_rate);
    let (turning, axis) = (on_cylinder(p)?, |t| Ok(cylinder(p, t)?.axis()));
    claims! { report,
        /// cylinder: angular velocity along its axis
        along: rate * c, "rad/s", "turned in a short time" => turning.z(), within 1e-11 * rate, in "The cylinder":
            0.0 => "it does not spin, but does a mark on it keep its direction?",
            rate * s => "that is the other component";
        /// cylinder: angular velocity across its axis
        across: rate * s, "rad/s", "turned in a short time" => turning.y(), within 1e-11 * rate, in "The cylinder":
            rate * c => "that is the other component";
        /// angle that the line OP covers in an orbit
        line: rate.signum() * TAU, "rad", "followed through an orbit" => swept(axis, TAU / rate.abs())?, within 1e-12;
    }
}

/// Short shafts and long ones, upright and lying cylinders, few corners and many.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let wheel = |shaft| p.but(|p| (p.radius, p.shaft, p.rate) = (1.0, shaft, 1.0));
    let over = |shaft| cycle_rate(&wheel(shaft), RHO).norm();
    let leaning = |tilt| p.but(|p| (p.tilt, p.cylinder_rate) = (tilt, 1.0));
    let along_axis = |tilt| -> Result<f64> { Ok(on_cylinder(&leaning(tilt))?.z()) };
    let six = tipping(6).1 * TAU / 6.0;
    limits! { report,
        /// a wheel that turns on the spot
        "a = R/1000: |Omega|/Omega less 1": over(1e-3) - 1.0 => 0.0, within 1e-6;
        /// a wheel that rolls nearly straight ahead, at the speed Omega a
        "a = 1000 R: |Omega| R/(Omega a)": over(1e3) / 1e3 => 1.0, within 1e-6;
        /// upright it turns about its own axis
        "theta = 0.001: Omega_z/Omega": along_axis(1e-3)? => 1.0, within 1e-6;
        /// lying it turns end over end
        "theta = pi/2: Omega_z/Omega": along_axis(FRAC_PI_2)? => 0.0, within 1e-9;
        /// 2 + 2 sqrt(3) + 2 radii, each with a sixth of a turn
        "a wheel of six corners: path/R": six => TAU / 6.0 * (4.0 + 2.0 * 3.0_f64.sqrt()), within 1e-14;
    }
}

/// The card of effects: what real contacts, coins and tyres do to these numbers.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (speed, resistance) = (p.wheel_rate.abs() * p.wheel_radius, 0.005);
    // A tyre with air in it, flattened by a hundredth of its radius: on the flat its tread is
    // pressed from the arc 2 b R into the chord 2 R sin(b). So is that of 22 flats in a row.
    let (flat, tipped) = (1.0 - cos(TAU / 44.0), tipping(22).0[22].0 / TAU);
    let ([stops, slower], slowing) = slowed(p, resistance)?;
    // Milled edges, half a hundredth of a millimetre more or less on the radius.
    let edge = 5e-6 / p.coin_radius;
    let [like, other] = [coin_rolled(1.0, TAU, 1e-13)?, coin_rolled(1.0 + edge, TAU, 1e-13)?];
    // A tyre that touches over 2 cm.
    let width = 0.02 / (2.0 * p.shaft);
    let counted = |work: Work| format!("{} derivatives", work.derivatives);
    effect_card! { report,
        "flattening of a pneumatic tyre": "d/R" = flat, costs flat * speed / 3.0, "m/s of the speed, to first order",
            measured speed * (1.0 - tipped), at_cost "none, 22 tips";
        "rolling resistance of a hoop": "C" = resistance, costs stops, "m/s a turn",
            measured slower, at_cost format!("none, {}", counted(slowing));
        "coins that differ a little": "(R1 - R2)/R2" = edge, costs TAU * edge, "rad a circuit", measured other.end_time() - like.end_time(),
            within 1e-11, at_cost format!("{}, {}", counted(like.work()), counted(other.work()));
        "width of the tyre on the circle": "b/(2 a)" = width, costs width, "of the speed Omega a, as slip at its edges",
            measured slip(p, spin(p), 0.01)? / (p.rate * p.shaft),
            within 1e-11 * (1.0 + p.radius / p.shaft) * (1.0 + p.shaft / p.radius), at_cost "none, 4 places";
    }
}

/// The accuracy strip: a circuit of the cycle wheel.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (wheel, circuit) = (p.clone(), TAU / p.rate.abs());
    let exact = cycle_turned(p, spin(p), circuit)?;
    let asked = [p.tolerance, 1e-6, 1e-8, 1e-10, 1e-12, 1e-15];
    let run = move |step| cycle_carried(&wheel, circuit, step);
    report.stepped(asked, run, |run| run.1, move |run| Ok(run.0.angle_to(&exact)))?;
    let wheel = p.clone();
    report.in_closed_form(move |part| cycle_turned(&wheel, spin(&wheel), part * circuit));
    Ok(())
}

example! {
    ch15_2_rolling: "Rolling: a wheel, a coin on a coin, a wheel on a shaft; and a cylinder carried round";
    "Rolling", "A wheel on a road, a coin on a coin, a wheel on a shaft, a cylinder carried round.",
    [road, coins, cycle, orbiting, limits, effects, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
