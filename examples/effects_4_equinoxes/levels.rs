//! Four simulations of one motion, each without a scale of time of the one before it.

use super::*;
use kit::short;
use rotation_dynamics::accuracy::{Limits, Problem, SolvedMotion};
use rotation_dynamics::attitude::{EulerAngles, EulerRates};
use rotation_dynamics::integrators::Work;
use rotation_dynamics::motion::Motion;
use rotation_dynamics::scene::Scene;

/// The span of the whole, Julian years.
const WHOLE: f64 = 26_000.0;

/// The attitude of the full body is asked for to this, rad.
const ATTITUDE: f64 = 1e-8;

pub type Full = Scene<(((), OrbitingBody), OrbitingBody)>;

// ANCHOR: full
/// The turning Earth with Sun and Moon.
pub fn full(p: &Parameters) -> Result<(Full, State)> {
    let (body, state) = earth(p, start(p, 3)?)?;
    Ok((Scene::new(body).with(sun(p)?).with(moon(p)?), state))
}

/// How it moves in the days of the parameters.
pub fn turning<'s>(
    p: &Parameters,
    (scene, start): &'s (Full, State),
) -> rotation_dynamics::Result<SolvedMotion<'s>> {
    scene.solve_along(start, p.days * DAY, ATTITUDE, &Limits::default())
}
// ANCHOR_END: full

/// One level: what it costs, and what it leaves out of the level above.
pub struct Level {
    pub name: &'static str,
    /// Mean step, s.
    pub step: f64,
    /// Torques for the whole span.
    pub torques: f64,
    /// Largest angle from the level above (arcsec), over so many years.
    pub off: Option<[f64; 2]>,
}

fn level(name: &'static str, span: f64, work: Work, off: Option<[f64; 2]>) -> Level {
    Level {
        name,
        step: span / work.steps as f64,
        torques: work.torques() as f64 * (WHOLE * YEAR / span),
        off,
    }
}

/// The largest distance (arcsec) of two paths of the axis.
fn farthest(
    span: f64,
    a: impl Fn(f64) -> Result<[f64; 2]>,
    b: impl Fn(f64) -> Result<[f64; 2]>,
) -> Result<f64> {
    let far = sampled(times(0.0, span, 4000), |t| {
        let ([p, tilt], [q, other]) = (a(t)?, b(t)?);
        let turned = p - q - TAU * ((p - q) / TAU).round();
        Ok(hypot(turned * sin(tilt), tilt - other) / ARCSEC)
    })?;
    Ok(far.into_iter().fold(0.0, f64::max))
}

/// How far the axis of the full body is from that of the axis alone, arcsec: the largest in
/// the days of the parameters, and the distance of its angular momentum from it.
pub fn spin_left_out(p: &Parameters) -> Result<([f64; 2], Work)> {
    let system = full(p)?;
    let motion = turning(p, &system)?;
    let alone = run(p, in_orbit(p)?, 3, p.days * DAY)?;
    let (mut figure, mut momentum) = (0.0_f64, 0.0_f64);
    for t in times(0.0, p.days * DAY, (8.0 * p.days) as u32) {
        let state = motion.try_state(t)?;
        let s = SpaceVector::from_array(alone.at(t)?);
        figure = figure.max(apart(state.attitude.axis(), s));
        momentum = momentum.max(apart(state.angular_momentum, s));
    }
    Ok(([figure, momentum], motion.solved().run))
}

/// The same in closed form: the axis goes round L, from which it is l'/(L/A) away as a steady
/// torque would have it, and as far on the other side as it was at the start.
pub fn spin_in_closed_form(p: &Parameters) -> Result<f64> {
    let alone = run(p, in_orbit(p)?, 3, p.days * DAY)?;
    let equation = axis(p, in_orbit(p)?);
    let wobble = spin(p) / (1.0 - p.ellipticity);
    let behind = |t: f64| {
        let rate = SpaceVector::from_array(equation.derivative(t, &alone.at(t)?));
        Ok::<_, rotation_dynamics::Error>(rate / wobble / ARCSEC)
    };
    let first: SpaceVector = behind(0.0)?;
    let sizes = sampled(times(0.0, p.days * DAY, (8.0 * p.days) as u32), |t| {
        Ok(behind(t)?.norm() + first.norm())
    })?;
    Ok(sizes.into_iter().fold(0.0, f64::max))
}

/// What one ring in place of two leaves out, arcsec: the largest distance in a round of the
/// node, and the longitude by which it runs ahead in the whole span, in the mean.
pub fn node_left_out(p: &Parameters) -> Result<[f64; 2]> {
    let round = nutation::node_round(p);
    let (rings, one) = (run(p, as_rings(p)?, 1, WHOLE * YEAR)?, one_ring(p)?);
    let path = |run: &Solution<3>, t| Ok(angles(run.at(t)?));
    let widest = farthest(round, |t| path(&rings, t), |t| path(&one, t))?;
    let lost = |from: f64| {
        let ahead = sampled(times(from, from + round, 200), |t| {
            let apart = path(&rings, t)?[0] - path(&one, t)?[0];
            Ok(apart - TAU * (apart / TAU).round())
        })?;
        Ok(ahead.iter().skip(1).sum::<f64>() / 200.0 / ARCSEC)
    };
    let (begin, end): (Result<f64>, Result<f64>) = (lost(0.0), lost(WHOLE * YEAR - round));
    Ok([widest, (end? - begin?) * WHOLE / (WHOLE - round / YEAR)])
}

/// The one ring: all that it does is to turn the axis.
fn one_ring(p: &Parameters) -> Result<Solution<3>> {
    Ok(run(p, as_one(p)?, 0, WHOLE * YEAR)?)
}

/// The four levels.
pub fn levels(p: &Parameters) -> Result<[Level; 4]> {
    let ([figure, _], turning) = spin_left_out(p)?;
    let (days, round) = (p.days * DAY, nutation::node_round(p));
    let orbits = run(p, in_orbit(p)?, 3, round)?;
    let rings = run(p, as_rings(p)?, 1, round)?;
    let off_rings = farthest(round, |t| Ok(angles(orbits.at(t)?)), |t| Ok(angles(rings.at(t)?)))?;
    let (whole, one) = (run(p, as_rings(p)?, 1, WHOLE * YEAR)?, one_ring(p)?);
    let off_one = farthest(WHOLE * YEAR, |t| Ok(angles(whole.at(t)?)), |t| Ok(angles(one.at(t)?)))?;
    Ok([
        level("full body", days, turning, None),
        level("axis alone", round, orbits.work(), Some([figure, p.days / 365.25])),
        level("rings", WHOLE * YEAR, whole.work(), Some([off_rings, round / YEAR])),
        level("one ring", WHOLE * YEAR, one.work(), Some([off_one, WHOLE])),
    ])
}

/// A time in the unit that fits.
fn told(seconds: f64) -> String {
    let units = [(YEAR, "a"), (DAY, "d"), (3600.0, "h")];
    let fits = units.iter().find(|(unit, _)| seconds >= 0.99 * unit);
    let (unit, name) = fits.unwrap_or(&(60.0, "min"));
    format!("{} {name}", short(seconds / unit, 2))
}

pub fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let ([figure, momentum], _) = spin_left_out(p)?;
    let expected = spin_in_closed_form(p)?;
    let levels = levels(p)?;
    let left = ["nothing", "daily turn, wobble", "months and years", "18.6 years of the node"];
    let columns = ["level", "without", "step", "torques in 26000 a", "off the level above", "over"];
    let mut table = Table::new("levels", columns)?;
    for (level, left) in levels.iter().zip(left) {
        let [off, over] = match level.off {
            None => ["-".into(), "-".into()],
            Some([off, over]) => [format!("{} arcsec", short(off, 2)), told(over * YEAR)],
        };
        let row =
            [level.name.into(), left.into(), told(level.step), short(level.torques, 2), off, over];
        table.push(row)?;
    }
    let node = nutation::first_order(p)?[0];
    // The half axis of the tilt, with the next term, of twice the node.
    let widest = node[1] * (1.0 + 0.25 * tan(p.moon_inclination) * tan(p.obliquity));
    let slow = p.day / (ANOMALISTIC_MONTH * DAY);
    let [ellipse, drift] = node_left_out(p)?;
    let expected_drift = nutation::crossed(p)? * WHOLE;
    claims! { report,
        /// largest distance of the full body's axis from the axis alone
        wobble: 1e3 * figure, "mas", "closed form" => 1e3 * expected, within 1e3 * slow * expected;
        /// largest distance of its angular momentum
        momentum: 1e3 * momentum, "mas", "none, to first order" => 0.0, within expected + 1e9 * p.tolerance;
        /// largest distance of two rings from one ring in a round of the node
        ellipse: ellipse, "arcsec", "nutation of the node" => widest, within widest - node[1] + 2e-3 * widest + 1e-6;
        /// longitude by which one ring runs ahead of two in 26 000 years
        drift: drift, "arcsec", "product of two nutations" => expected_drift, within 0.05 * expected_drift.abs() + 0.1;
    }?;
    report.add(table)
}

/// The accuracy strip: the full body under the Sun's ring, where it can precess steadily.
pub fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let ring = sun(p)?.averaged()?;
    let (_, g) = ring.pull(0.0);
    let (a, tilt) = (1.0 - p.ellipticity, p.obliquity);
    let (l, c) = (spin(p), cos(tilt));
    // A c psi'^2 - C w psi' + 3 g (C - A) c = 0, the slow one of its roots.
    let torque = 3.0 * g * p.ellipticity * c;
    let rate = 2.0 * torque / (l + (l * l - 4.0 * a * c * torque).sqrt());
    let rates = EulerRates { phi: rate, theta: 0.0, zeta: l - rate * c };
    let angles =
        move |t: f64| EulerAngles { phi: PI + rates.phi * t, theta: tilt, zeta: rates.zeta * t };
    let motion = move |t| Attitude::from_euler(angles(t)).expect("the angles are finite");
    let (body, _) = earth(p, pole([0.0, tilt]))?;
    let state = |t: f64| body.state(motion(t), angles(t).angular_velocity(rates));
    let end = p.days * DAY;
    let (begin, exact) = (state(0.0)?, state(end)?);
    let problem = Problem::new(Scene::new(body).with(ring), begin, end, exact);
    report.in_closed_form(move |part| motion(part * end));
    report.strip(&problem, &[ATTITUDE, 1e-4, 1e-6, 1e-10])
}
