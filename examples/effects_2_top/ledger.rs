//! Which effect rules which part of the life, and what becomes of it without one of them.

use super::*;
use models::tops::{Grip, RollingResistance};
use rotation_dynamics::effects::Effect;

/// Where the energy goes, part by part; together it is all that is lost. And rules of thumb.
pub fn phases(p: &Parameters, report: &mut Report) -> Result<()> {
    let life = p.life(p.tolerance)?;
    let columns =
        "phase, from / s, to / s, spin / rad/s, tilt / rad, sliding / mJ, pivoting / mJ, air / mJ";
    let phases = [
        ("slides", "creeps"),
        ("creeps", "sleeps"),
        ("sleeps", "unstable"),
        ("stands", "wakes"),
        ("dies", "falls"),
    ];
    let (mut from, mut lost) = (0.0, 0.0);
    let table = Table::of("phases", columns.split(", "), phases, |(name, end)| {
        let to = life.event(end)?.t;
        let (work, at) = (works(&life, from, to)?, life.configuration(to)?);
        lost += work.iter().sum::<f64>();
        let [sliding, pivoting, air] = work.map(|work| format!("{:.3}", -1e3 * work));
        let [begins, ends] = [from, to].map(|t| format!("{t:.2}"));
        from = to;
        let (spin, tilt) = (format!("{:.1}", at.spin()), format!("{:.4}", at.tilt()));
        Ok([name.to_string(), begins, ends, spin, tilt, sliding, pivoting, air])
    })?;
    report.add(table)?;
    estimates(p, &life, report)?;
    let energy = |t: f64| -> Result<f64> { Ok(life.top().energy(&life.configuration(t)?)) };
    let change = energy(from)? - energy(0.0)?;
    let claim = claim("lost", "energy lost from the throw to the fall", -1e3 * change, "mJ");
    report
        .add(claim.within(-1e-2 * change).against("work of friction and air, summed", -1e3 * lost))
}

/// Work (J) of sliding, pivoting and air between two times.
fn works(life: &Life, from: f64, to: f64) -> Result<[f64; 3]> {
    let n = 2 * (500.0 + 60.0 * (to - from)) as u32;
    let mut sums = [0.0; 3];
    let h = (to - from) / f64::from(n);
    for i in 0..=n {
        let weight = if i == 0 || i == n { 1.0 } else { 2.0 + 2.0 * f64::from(i % 2) };
        let (at, forces) = life.forces(from + h * f64::from(i))?;
        let powers = life.top().powers(&at, &forces);
        for (sum, power) in sums.iter_mut().zip([powers.sliding, powers.couple, powers.effects]) {
            *sum += weight * power * h / 3.0;
        }
    }
    Ok(sums)
}

/// Dry friction as many programs have it: mu N tanh(u/epsilon) against the slip.
#[derive(Debug, Clone, Copy)]
struct Smoothed {
    coefficient: f64,
    epsilon: f64,
}

impl TipFriction for Smoothed {
    const SLIDES: bool = true;
    const STICKS: bool = false;

    fn sliding(&self, slip: SpaceVector, _: f64) -> Grip {
        let speed = slip.norm().max(1e-9 * self.epsilon);
        let tanh = 1.0 - 2.0 / (exp(2.0 * speed / self.epsilon) + 1.0);
        Grip { force: slip * (-self.coefficient * tanh / speed), torque: 0.0 }
    }

    fn holds(&self) -> f64 {
        0.0
    }
}

/// The same throw with one thing left out; and the card of effects.
pub fn without(p: &Parameters, report: &mut Report) -> Result<()> {
    let columns =
        "left out, mean tilt before 1 s / rad, before 5 s, before 20 s, what becomes of it";
    let (point, patch) = (Dry::new(p.friction)?, p.rubbing()?);
    let smoothed = |epsilon| p.toy(Smoothed { coefficient: p.friction, epsilon });
    let bare = Top::new(p.shape()?, GRAVITY)?.on(patch).sloping(p.slope)?;
    let rows = [
        outcome("nothing", &p.toy(patch)?, p)?,
        outcome("the patch: dry friction at a point", &p.toy(point)?, p)?,
        outcome("the slip: a tip that never slides", &p.toy(NoSlip)?, p)?,
        outcome("all friction: a smooth floor", &p.toy(Smooth)?, p)?,
        outcome("the air", &bare, p)?,
        outcome("the patch: a tanh of 0.1 m/s", &smoothed(0.1)?, p)?,
        outcome("the patch: a tanh of 3 mm/s", &smoothed(3e-3)?, p)?,
    ];
    let [all, point, _, smooth, ..] = rows.each_ref().map(|(_, end)| *end);
    report.add(Table::of("without", columns.split(", "), rows, |(cells, _)| Ok(cells))?)?;
    card(p, [all, point, smooth], report)
}

/// A run of 20 s: its mean tilts in the half second before 1 s, 5 s and 20 s, and what becomes of
/// it; and once more the last tilt, with the derivatives that the run took.
fn outcome<F: TipFriction, E: Effect + Clone>(
    left_out: &str,
    top: &Top<F, (), E>,
    p: &Parameters,
) -> Result<([String; 5], (f64, u64))> {
    let run = top.simulate(&p.throw(), 20.0, 10.0 * p.tolerance)?;
    // Over half a second, so that nods count little.
    let tilt = |t: f64| mean(times(t - 0.5, t, 100), |t| Ok(run.configuration(t)?.tilt()));
    let (first, later, last) = (tilt(1.0)?, tilt(5.0)?, tilt(20.0)?);
    let grips = run.event("grips").map(|event| (event.t, run.configuration_at(event).tilt()));
    let fate = match (grips, last < ASLEEP) {
        (Ok((t, tilt)), _) => format!("grips after {t:.2} s at {tilt:.3} rad and rises no more"),
        (_, true) => "falls asleep".into(),
        _ if last < 0.8 * p.tilt => "creeps up, and is not asleep yet".into(),
        _ => "never rises".into(),
    };
    let [first, later, told] = [first, later, last].map(|tilt| format!("{tilt:.4}"));
    Ok(([left_out.into(), first, later, told, fate], (last, run.work().derivatives)))
}

/// The card: what acts, and what it costs to leave it out of the whole life. After 20 s the tilt
/// and the work are these with everything, at a point that grips, and on a smooth floor.
fn card(p: &Parameters, [all, point, smooth]: [(f64, u64); 3], report: &mut Report) -> Result<()> {
    let (patch, least) = (p.patch()?, p.least_spin());
    let [rubs, pivots, air] = [
        p.rise_rate() / (p.throw().precession * p.tilt),
        3.0 * TAU / 32.0 * p.friction * WEIGHT * patch / AXIAL / p.braking(p.spin)?,
        -p.air()?.axial_torque(p.spin) / AXIAL / p.braking(p.spin)?,
    ];
    let nod = AXIAL * p.spin / ACROSS;
    let geared = AXIAL + MASS * p.tip * (LEVER + p.tip);
    let rolls = 0.01 * p.tip * WEIGHT / (geared * p.spin);
    let hop = p.friction * p.tilt * nod * nod * LEVER * p.throw().precession / (nod * GRAVITY);
    let earth = 7.292e-5 / p.precession(least * 1.05);
    let cost = |(_, other): (f64, u64)| format!("{other} derivatives, {} derivatives", all.1);
    let told = |key| report.claim(key).map_or(f64::NAN, |claim| claim.oracle.value);
    let (leans, wakes) = (told("leans"), told("wakes"));
    // A tenth of friction and patch creeps alike and pivots with a hundredth.
    let firm = p.life_on(Patch::new(0.1 * p.friction, 0.1 * patch)?, 10.0 * p.tolerance)?;
    let longer = firm.event("wakes")?.t / wakes - 1.0;
    let rising = risen(p, 0.01 * p.tip)?;
    effect_card! { report,
        "sliding friction": "rise rate/(precession theta)" = rubs, costs p.tilt, "rad: it never rises",
            measured smooth.0 - all.0, within 1e-3, at_cost cost(smooth), included;
        "a patch of contact": "a omega/slip" = patch * p.spin / p.first_slip(), costs p.grip_tilt(), "rad: it stops rising",
            measured point.0 - all.0, within 1e-3, at_cost cost(point), included;
        "drag of the air": "share of the braking" = air, costs 1.0 / (1.0 - air) - 1.0, "of the life, at the first rate", included;
        "friction of pivoting": "share of the braking" = pivots, costs 1.0 / (1.0 - pivots) - 1.0, "of the life, at the first rate",
            measured longer, within 1e-2, included;
        "slope of the floor": "slope" = p.slope, costs p.slope * (LEVER + p.tip) / LEVER, "rad of the tilt asleep",
            measured leans, within 1e-5, included;
        "force that varies in a nod, and patch with it": "(N/mg - 1)/3 at the throw" = hop / 3.0, costs hop / 3.0, "of the patch";
        "rolling resistance, an arm of a hundredth of r": "arm/r" = 0.01, costs rolls, "rad/s of rise", beside "rise", measured rising, within 1e-4;
        "drag of the air on the axis's motion": "theta" = ASLEEP, costs ASLEEP * ASLEEP, "of the drag";
        "rotation of the Earth": "Omega_E/precession" = earth, costs earth, "rad of the tilt asleep";
    }
}

/// How fast a tip that rolls makes the axis rise, rad/s, if its force stands ahead by this arm (m):
/// from the mean tilts of two seconds, two seconds apart.
fn risen(p: &Parameters, arm: f64) -> Result<f64> {
    let top = Top::new(p.shape()?, GRAVITY)?.on(NoSlip);
    let top = top.resisted_by(RollingResistance::new(arm, 1e-2)?);
    let run = top.simulate(&p.throw().rolling(), 3.0, 1e-10)?;
    let tilt = |from: f64| mean(times(from, from + 0.99, 99), |t| Ok(run.configuration(t)?.tilt()));
    Ok(0.5 * (tilt(0.0)? - tilt(2.0)?))
}

/// Rules of thumb, and what the simulation says.
fn estimates(p: &Parameters, life: &Life, report: &mut Report) -> Result<()> {
    let grips = report.claim("gripped").map_or(f64::NAN, |claim| claim.value);
    let upright = p.tilt / p.rise_rate();
    let brake = -p.air()?.axial_torque(p.spin) / AXIAL;
    let notes = 2.0 * ((ACROSS + MASS * LEVER * LEVER) * WEIGHT * LEVER).sqrt() / AXIAL;
    let (sleeps, wakes) = (life.event("sleeps")?.t, life.event("wakes")?.t);
    let last = life.configuration(wakes)?.spin();
    let rows = [
        ("to stand upright, by sliding all the way", "s", upright, sleeps),
        ("tilt at which a point grips", "rad", p.grip_tilt(), grips),
        ("spin down by the air of the throw alone", "s", p.spin / brake, wakes),
        ("spin at which it wakes, sharp tip held", "rad/s", notes, last),
        ("the same, tip that creeps", "rad/s", p.least_spin(), last),
    ];
    let columns = ["what", "unit", "rule of thumb", "simulated"];
    report.add(Table::of("estimates", columns, rows, |(what, unit, told, simulated)| {
        Ok([what.into(), unit.into(), format!("{told:.3}"), format!("{simulated:.3}")])
    })?)
}
