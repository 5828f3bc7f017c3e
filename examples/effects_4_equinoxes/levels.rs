//! Four simulations of one motion, each without a scale of time of the one before it.

use super::*;
use kit::short;
use rotation_dynamics::accuracy::{Limits, Problem, SolvedMotion, largest};
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
pub fn turning<'s>(p: &Parameters, (scene, start): &'s (Full, State)) -> Result<SolvedMotion<'s>> {
    Ok(scene.solve_along(start, p.days * DAY, ATTITUDE, &Limits::default())?)
}
// ANCHOR_END: full

/// The largest distance (arcsec) of two paths of the axis in this time.
fn farthest(span: f64, a: &Solution<3>, b: &Solution<3>) -> Result<f64> {
    Ok(largest(sampled(times(0.0, span, 4000), |t| {
        let ([p, tilt], [q, other]) = (angles(a.at(t)?), angles(b.at(t)?));
        Ok(hypot(ahead(p, q) * sin(tilt), tilt - other) / ARCSEC)
    })?))
}

/// By what angle the one longitude is ahead of the other, the short way.
fn ahead(one: f64, other: f64) -> f64 {
    one - other - TAU * ((one - other) / TAU).round()
}

/// How far the axis of the full body is from that of the axis alone, arcsec: the largest in
/// the days of the parameters, and the distance of its angular momentum from it.
pub fn spin_left_out(p: &Parameters) -> Result<([f64; 2], Work)> {
    let system = full(p)?;
    let motion = turning(p, &system)?;
    let alone = run(p, &in_orbit(p)?, 3, p.days * DAY)?;
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
    let law = in_orbit(p)?;
    let alone = run(p, &law, 3, p.days * DAY)?;
    let wobble = spin(p) / (1.0 - p.ellipticity);
    let behind = |t: f64| -> Result<SpaceVector> {
        Ok(SpaceVector::from_array(law.derivative(t, &alone.at(t)?)) / wobble / ARCSEC)
    };
    let first = behind(0.0)?;
    let looks = times(0.0, p.days * DAY, (8.0 * p.days) as u32);
    Ok(largest(sampled(looks, |t| Ok(behind(t)?.norm() + first.norm()))?))
}

/// The four levels: what each leaves out and costs, and the largest angle (arcsec) from the one
/// above it, over so many years. The first two are those of [`spin_left_out`], the last two run
/// over the whole span.
fn levels(
    p: &Parameters,
    (figure, turning): (f64, Work),
    whole: &Solution<3>,
    one: &Solution<3>,
) -> Result<Table> {
    let (days, round, all) = (p.days * DAY, nutation::node_round(p), WHOLE * YEAR);
    let (orbits, rings) = (run(p, &in_orbit(p)?, 3, round)?, run(p, &as_rings(p)?, 1, round)?);
    let off_rings = farthest(round, &orbits, &rings)?;
    let off_one = farthest(all, whole, one)?;
    let rows = [
        ("full body", "nothing", days, turning, None),
        ("axis alone", "daily turn, wobble", round, orbits.work(), Some([figure, p.days / 365.25])),
        ("rings", "months and years", all, whole.work(), Some([off_rings, round / YEAR])),
        ("one ring", "18.6 years of the node", all, one.work(), Some([off_one, WHOLE])),
    ];
    let columns = "level, without, step, torques in 26000 a, off the level above, over";
    Table::of("levels", columns.split(", "), rows, |(level, without, span, work, off)| {
        let [off, over] = match off {
            None => ["-".into(), "-".into()],
            Some([off, over]) => [format!("{} arcsec", short(off, 2)), told(over * YEAR)],
        };
        let torques = short(work.torques() as f64 * (all / span), 2);
        Ok([level.into(), without.into(), told(span / work.steps as f64), torques, off, over])
    })
}

/// A time in the unit that fits.
fn told(seconds: f64) -> String {
    let units = [(YEAR, "a"), (DAY, "d"), (3600.0, "h")];
    let fits = units.iter().find(|(unit, _)| seconds >= 0.99 * unit);
    let (unit, name) = fits.unwrap_or(&(60.0, "min"));
    format!("{} {name}", short(seconds / unit, 2))
}

pub fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let ([figure, momentum], turning) = spin_left_out(p)?;
    let expected = spin_in_closed_form(p)?;
    let node = nutation::first_order(p)?[0];
    // The half axis of the tilt, with the next term, of twice the node.
    let widest = node[1] * (1.0 + 0.25 * tan(p.moon_inclination) * tan(p.obliquity));
    let slow = p.day / (ANOMALISTIC_MONTH * DAY);
    let (round, all) = (nutation::node_round(p), WHOLE * YEAR);
    let (rings, one) = (run(p, &as_rings(p)?, 1, all)?, run(p, &as_one(p)?, 0, all)?);
    // The mean longitude by which one ring is ahead of two in a round of the node from there.
    let lost = |from: f64| -> Result<f64> {
        let ahead = sampled(times(from, from + round, 200), |t| {
            Ok(ahead(angles(rings.at(t)?)[0], angles(one.at(t)?)[0]))
        })?;
        Ok(ahead.iter().skip(1).sum::<f64>() / 200.0 / ARCSEC)
    };
    let drift = (lost(all - round)? - lost(0.0)?) * WHOLE / (WHOLE - round / YEAR);
    let expected_drift = nutation::crossed(p)? * WHOLE;
    claims! { report,
        /// largest distance of the full body's axis from the axis alone
        wobble: 1e3 * figure, "mas", "closed form" => 1e3 * expected, within 1e3 * slow * expected;
        /// largest distance of its angular momentum
        momentum: 1e3 * momentum, "mas", "none, to first order" => 0.0, within expected + 1e9 * p.tolerance;
        /// largest distance of two rings from one ring in a round of the node
        ellipse: farthest(round, &rings, &one)?, "arcsec", "nutation of the node" => widest, within widest - node[1] + 2e-3 * widest + 1e-6;
        /// longitude by which one ring runs ahead of two in 26 000 years
        drift: drift, "arcsec", "product of two nutations" => expected_drift, within 0.05 * expected_drift.abs() + 0.1;
    }?;
    report.add(levels(p, (figure, turning), &rings, &one)?)
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
