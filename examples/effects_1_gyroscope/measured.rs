//! What is simulated, as the second route of the formulas.

use super::*;
use rotation_dynamics::attitude::EulerAngles;
use rotation_dynamics::exact::heavy_top::HeavyTop;
use rotation_dynamics::integrators::{LocatedEvent, after, small_frequency};

/// The first nod without friction, located: its lowest point, and where it is back.
pub fn nod(y: &Gyroscope, step: f64) -> Result<[LocatedEvent<6>; 2]> {
    let until = 3.0 * NutationCycle::of(&y.gimbals, &y.start)?.period;
    let turned = |count| -> Result<_> {
        Ok(Dop853::new(step)?.zero(&y.gimbals, y.start.to_array(), count, until, |y| y[1])?.0)
    };
    Ok([turned(1)?, turned(2)?])
}

/// The period without gimbals, by elliptic functions.
pub fn bare(y: &Gyroscope) -> Result<f64> {
    let (rotor, theta) = (*y.gimbals.rotor(), y.start.theta);
    let angles = EulerAngles { phi: 0.0, theta, zeta: 0.0 };
    let omega = BodyVector::new(0.0, 0.0, y.start.axial_momentum / rotor.i3());
    Ok(HeavyTop::from_body(rotor, angles, omega)?.nutation_period())
}

/// The nod of the rotor alone, by quadrature.
pub fn nod_without_gimbals(y: &Gyroscope) -> rotation_dynamics::Result<NutationCycle> {
    NutationCycle::of(&Gimbals::new(*y.gimbals.rotor(), [0.0; 3], 0.0)?, &y.start)
}

/// The pose of steady precession at the bottom of the valley, and the angular frequency of small
/// nods about it.
pub fn steady(y: &Gyroscope) -> rotation_dynamics::Result<(Pose, f64)> {
    let (g, theta, axial) = (&y.gimbals, y.bottom()?, y.start.axial_momentum);
    let phi_rate = g.steady_rate(theta, axial, 0.0)?;
    let at = y.start.but(|start| (start.theta, start.phi_rate) = (theta, phi_rate));
    Ok((at, g.nodding(theta, axial, phi_rate)))
}

/// The rate of the azimuth there, from a turn.
pub fn walk(y: &Gyroscope, step: f64) -> Result<f64> {
    let turn = TAU / y.fading()?.precession;
    Ok(after(turn, &y.gimbals, &steady(y)?.0.to_array(), step)?[2] / turn)
}

/// Angular frequency of the smallest nods about it.
pub fn smallest(y: &Gyroscope) -> rotation_dynamics::Result<f64> {
    let (at, rate) = steady(y)?;
    let kicked = |size| at.but(|at| at.theta_rate = 0.01 * size * rate).to_array();
    small_frequency(&y.gimbals, kicked, 20.0 / rate, |y| y[0] - at.theta)
}

/// Tilt and heat after nods that a viscous tilt bearing of its own has taken, and nothing else.
pub fn damped(y: &Gyroscope, step: f64) -> Result<(f64, f64)> {
    let (_, rate) = steady(y)?;
    let tilt = Bearing::new(0.1 * y.gimbals.tilting() * rate, 0.0)?;
    let smooth = y.with(Bearings { tilt, ..Bearings::SMOOTH });
    let course = smooth.run(None, 500.0 / rate, step)?;
    let end = course.end_time();
    Ok((course.at(end)?.theta, course.heat(end)?[0]))
}

/// The rate at which viscous friction of both bearings takes small nods: the widths of two
/// swings, up to ten nods apart, the later still wider than what the axis sinks meanwhile. The
/// middle of two neighbours takes out how it sinks.
pub fn decay(y: &Gyroscope, step: f64) -> Result<f64> {
    let viscous = |b: &Bearing| Bearing::new(b.viscous(), 0.0);
    let (tilt, azimuth) = (viscous(&y.bearings.tilt)?, viscous(&y.bearings.azimuth)?);
    let (at, rate) = steady(y)?;
    let slow = y.with(Bearings { tilt, azimuth, ..Bearings::SMOOTH });
    let start = at.but(|at| at.theta_rate = 1e-3 * rate);
    let course = Gyroscope { start, ..slow }.run(None, 25.0 * PI / rate, step)?;
    let turns = course.turning_points();
    let theta = |k: usize| turns.get(k).map_or(f64::NAN, |(_, at)| at.theta);
    let width = |k: usize| theta(k + 1) - 0.5 * (theta(k) + theta(k + 2));
    let time = |k: usize| turns.get(k + 1).map_or(f64::NAN, |(t, _)| *t);
    let f = y.fading()?;
    let last = 2 * ((0.15 * f.frequency / (PI * f.decay)) as usize).clamp(1, 10);
    Ok(log(width(0) / width(last)) / (time(last) - time(0)))
}

/// Half nods until the dry tilt bearing, alone, holds; none if there is too little friction.
pub fn half_nods(y: &Gyroscope, step: f64) -> Result<Option<f64>> {
    let (halves, f) = (f64::from(ledger::half_nods(y)), y.fading()?);
    if !(1.0..1000.0).contains(&halves) {
        return Ok(None);
    }
    let tilt = Bearing::new(0.0, y.bearings.tilt.dry())?;
    let dry = y.with(Bearings { tilt, ..Bearings::SMOOTH });
    let course = dry.run(None, (halves + 6.0 + 0.2 * halves) * PI / f.frequency, step)?;
    let stops = course.changes().iter().filter(|c| c.name == "tilt stops");
    Ok(Some(stops.count() as f64))
}

/// The rate at which the axis sinks with these bearings: over whole nods, a quarter of a turn.
pub fn sinking(y: &Gyroscope, bearings: Bearings, step: f64) -> Result<f64> {
    let (at, f) = (steady(y)?.0, y.fading()?);
    let time = TAU / f.frequency * (0.25 * f.frequency / f.precession).ceil();
    let course = Gyroscope { start: at, ..y.with(bearings) }.run(None, time, step)?;
    Ok((course.at(time)?.theta - at.theta) / time)
}

/// The whole way to the stop: time and spin, simulated with everything and by the slow motion
/// alone. None if it is not reached in the longest simulation, if a nod meets it, or if the rotor
/// is too slow by then for a slow precession.
pub fn to_the_stop(y: &Gyroscope, p: &Parameters) -> Result<Option<[[f64; 2]; 2]>> {
    let course = y.run(Some(p.stop), LONGEST, p.tolerance)?;
    let (t, i3) = (course.end_time(), y.gimbals.rotor().i3());
    if !course.stopped() || t < 2.0 * y.lasting(y.bottom()? - y.start.theta)? {
        return Ok(None);
    }
    let last = Gyroscope { start: course.at(t)?, ..*y };
    // While it sinks, dry friction of the tilt bears a part of the weight.
    let from = y.bottom_at(&y.start, y.bearings.tilt.dry())?;
    let start = [from, 0.0, y.start.axial_momentum];
    let (slow, down) = (Decay::slow(y.gimbals, y.bearings), |y: &[f64; 3]| y[0] - p.stop);
    let slow = Dop853::new(p.tolerance)?.zero(&slow, start, 1, LONGEST, down).ok();
    let slow = slow.filter(|_| last.slowness() < 2.0);
    Ok(slow.map(|(end, _)| [[t, last.start.axial_momentum / i3], [end.t, end.state[2] / i3]]))
}
