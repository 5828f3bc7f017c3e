//! Exercise 16.8: a plank on two rollers that turn against each other.

#[path = "ch16_ex8_plank_on_rollers/figures.rs"]
mod figures;
#[path = "ch16_ex8_plank_on_rollers/physics.rs"]
pub mod physics;

use core::f64::consts::{FRAC_PI_2, TAU};
use kit::interval::at_least;
use kit::prelude::*;
use physics::*;
use rotation_dynamics::Error;
use rotation_dynamics::accuracy::largest;
use rotation_dynamics::integrators::{Dop853, Ode, second_order};
use rotation_dynamics::math::{acosh, atan, tanh};
use rotation_dynamics::planar::contact::{MechanismState, motion};

parameters! {
    /// The plank of the exercise; the notes leave all numbers open.
    pub struct Parameters {
        /// distance of the rollers
        distance: number(1.0, "m", above(0.0).usually(0.5, 2.0)).drawn(0.8, 1.6, 0.1);
        /// coefficient of friction of surfaces that slip
        kinetic: number(0.3, "-", at_least(1e-4).because("smoother rollers hardly move it").usually(0.1, 0.5)).drawn(0.20, 0.40, 0.05).open("friction of surfaces that slip", "swings slowly", "swings quickly");
        /// coefficient of friction of surfaces that do not slip
        holding: number(0.5, "-", above(0.0).usually(0.3, 0.8)).drawn(0.45, 0.70, 0.05);
        /// speed of the surfaces of the rollers
        speed: number(0.3, "m/s", any().usually(0.1, 1.0)).drawn(0.20, 0.50, 0.05);
        /// how far to the right the middle of the plank is at the start, at rest
        offset: number(0.3, "m", any().usually(0.05, 0.4)).drawn(0.20, 0.35, 0.05);
        /// thickness of the plank
        thickness: number(0.0, "m", at_least(0.0).usually(0.0, 0.1));
        gravity: gravity(above(0.0).usually(1.0, 25.0));
        /// the moving picture: the tops of the rollers move towards each other (in) or apart
        sense: choice("in", "out").open("tops of the rollers move");
        /// part of the friction that is lost per m/s of slip, for the claims about it
        falling: effect(0.1, "s/m", above_to(0.0, 10.0).because("with more, a tenth of a metre a second takes all friction away"));
        tolerance: step(1e-13, 1e-6);
    }
}

impl Parameters {
    /// How fast the surfaces run, m/s; a negative speed is the other sense.
    pub fn runs(&self) -> f64 {
        self.speed.abs()
    }

    /// The event of that name at the roller to which the plank starts nearer, or at the other.
    fn event_there(&self, [left, right]: [&'static str; 2]) -> &'static str {
        if self.offset < 0.0 { left } else { right }
    }
}

/// The plank; refused if friction would jam it, or if it does not lie on both rollers.
pub fn plank(p: &Parameters, sense: f64) -> Result<Plank> {
    allowed! {
        "holding": p.holding, at_least(p.kinetic), "what rests holds no less than what slips";
        "kinetic*thickness/distance": p.kinetic * p.thickness / p.distance, from_to(0.0, 0.9999), "at 1 friction on its lower face jams the plank";
        // Slower rollers carry the plank for so long that they might as well rest.
        "speed/sqrt(2 kinetic gravity distance)": p.runs() / (rate(p, 0.0) * p.distance),
            from_to(1e-4, 1e9), "at 0 the rollers rest, and so does the plank";
        "offset": p.offset, between(-lift(p, 1.0), lift(p, 1.0)), "at an end it lifts off a roller";
    }?;
    Ok(Plank { p: p.clone(), sense })
}

/// The same, released elsewhere.
fn from(p: &Parameters, offset: f64) -> Parameters {
    p.but(|p| p.offset = offset)
}

/// Its motion from rest at the offset, until then or until it has tipped.
pub fn released(p: &Parameters, sense: f64, end: f64) -> Result<Ride> {
    let start = MechanismState::rest([p.offset, 0.0, 0.0]);
    Ok(motion(plank(p, sense)?, &Dop853::new(p.tolerance)?, start, end)?)
}

/// Whether it ends in the cycle.
fn goes_round(p: &Parameters) -> bool {
    let felt = held(p) > 1e-2 * p.runs() / rate(p, 1.0);
    felt && caught(p, 1.0)[0].is_finite() && cycle(p).0 < lift(p, 1.0)
}

/// A span of time that the page looks at, in the first sense: two rounds, and at least from the
/// start until the plank has been let go twice, if it is caught at all.
fn span(p: &Parameters) -> f64 {
    let (round, [stick, at, _]) = (cycle(p).1, caught(p, 1.0));
    let twice = stick + (at + held(p)) / p.runs() + 1.2 * round;
    let rounds = 2.0 * round + 0.5 * TAU / rate(p, 1.0);
    if stick.is_finite() { rounds.max(twice) } else { rounds }
}

/// The cycle as simulated: how far beyond the middle the roller carries the plank that held it
/// first; how far it goes, half a period of the oscillation after a slip ends the way out; and the
/// time from one slip there to the next.
fn stick_slip(p: &Parameters, ride: &Ride) -> Result<[f64; 3]> {
    let name = p.event_there(["left slips", "right slips"]);
    let slips = || ride.events().iter().filter(|event| event.name == name);
    let [Some(first), Some(again)] = [0, 1].map(|n| slips().nth(n)) else {
        return Err(Error::NotReached { name, until: ride.end_time() }.into());
    };
    let swing = rate(p, 1.0);
    let turn = first.t + atan(p.runs() / (swing * held(p))) / swing;
    let side = 1.0_f64.copysign(p.offset);
    Ok([-side * first.before.q[0], -side * ride.at(turn)?.q[0], again.t - first.t])
}

// ANCHOR: wrong
/// The same by a smooth law: friction that rises with the slip to the holding value at `width`
/// and falls to the kinetic one beyond; `[x, v]` of a thin plank, tops moving together.
pub fn smoothed(p: &Parameters, width: f64) -> impl Ode<2> {
    let (distance, speed, gravity) = (p.distance, p.runs(), p.gravity);
    let (kinetic, holding) = (p.kinetic, p.holding);
    let friction = move |slip: f64| {
        let part = slip / width;
        kinetic * tanh(4.0 * part) + (holding - kinetic) * part * exp(0.5 - 0.5 * part * part)
    };
    second_order(move |_, x, v| {
        let (left, right) = (0.5 - x / distance, 0.5 + x / distance);
        gravity * (friction(speed - v) * left + friction(-speed - v) * right)
    })
}
// ANCHOR_END: wrong

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (a, g, v, mu) = (p.distance, p.gravity, p.runs(), p.kinetic);
    let (swing, growth) = (rate(p, 1.0), rate(p, -1.0));
    let exact = 100.0 * p.tolerance.max(1e-13) * (1.0 + 0.1 / p.kinetic);
    let (period, widest, carried) = (TAU / swing, v / swing, held(p));
    // Simulations have errors in units of the distance: of small motions they are larger.
    let [wide, far] = [widest, p.offset.abs()].map(|size| exact * (1.0 + 0.01 * a / size));
    let (ride, apart) = (released(p, 1.0, span(p))?, released(p, -1.0, 1e3 * span(p))?);
    let (zero, top) = quarter(p)?;
    let small = from(p, 0.05 * lift(p, 1.0).min(v / growth));
    let grown = released(&small, -1.0, 3.0 / growth)?.at(3.0 / growth)?.q[0] / small.offset;
    let right = 0.5 + p.offset / (2.0 * lift(p, 1.0));
    let (amplitude, round) = cycle(p);
    let ([stick, at, _], [stick_out, _, tip]) = (caught(p, 1.0), caught(p, -1.0));
    let goes_round = goes_round(p);
    let [carries, reaches, repeats] = if goes_round { stick_slip(p, &ride)? } else { [0.0; 3] };
    let event = |ride: &Ride, names| Ok::<_, kit::Error>(ride.event(p.event_there(names))?.t);
    claims! { report,
        /// force of the right roller over the weight, at the start, tops moving together
        right: right, "-", "contact forces" => ride.forces(0.0)?[1].normal / g, within exact, in "The forces":
            1.0 - right => "that is the left one; which of the two is nearer to the middle?",
            0.5 + 2.0 * (right - 0.5) => "the rollers are at half the distance from the middle";
        /// period of the oscillation
        period: period, "s", "located zero" => 4.0 * zero, within wide * period, in "Tops together":
            period * 2.0_f64.sqrt() => "both rollers rub", 1.0 / swing => "a period has 2 pi of these",
            period / 2.0_f64.sqrt() => "the forces change by x/a, one up and one down";
        /// largest amplitude at which it only slips
        widest: widest, "m", "speed at the middle" => top, within wide * widest, in "Tops together":
            v / growth / 2.0_f64.sqrt() => "the speed at the middle is the amplitude times the angular frequency";
        /// rate of growth
        growth: growth, "1/s", "growth by ten" => growth * acosh(grown) / 3.0, within exact * growth * (1.0 + 0.01 * a / small.offset), in "Tops apart":
            growth * growth => "that is its square", growth / 2.0_f64.sqrt() => "both rollers rub";
        /// tops apart: the nearer roller holds it
        stick_out: stick_out, "s", "located event" => event(&apart, ["left sticks", "right sticks"])?,
        within far * (stick_out + 1.0 / growth), if stick_out.is_finite() && tip > stick_out;
        /// tops apart: the other roller loses it
        tip: tip, "s", "located event" => event(&apart, ["right lets go", "left lets go"])?,
        within far * (tip + 1.0 / growth) * (1.0 + a / (v * tip)), if tip.is_finite(), in "Tops apart":
            acosh(lift(p, -1.0) / p.offset.abs()) / growth => "once as fast as the roller it goes no faster";
        /// tops together: the nearer roller holds it
        stick: stick, "s", "located event" => event(&ride, ["left sticks", "right sticks"])?,
        within exact * (1.0 + v / (swing * at)) / swing, if stick.is_finite();
        /// how far beyond the middle the roller carries it
        carried: carried, "m", "located event" => carries, within wide * a, if goes_round, in "Stick and slip":
            2.0 * carried => "from the middle between the rollers, half a distance is the most",
            0.5 * a * (p.holding - mu) / p.holding => "one roller holds, the other slips: the two forces are equal";
        /// amplitude of the cycle
        amplitude: amplitude, "m", "largest |x|" => reaches, within wide * a, if goes_round;
        /// period of the cycle
        cycle: round, "s", "located events" => repeats, within wide * (round + a / v) * (1.0 + widest / carried), if goes_round,
        in "Stick and slip":
            period => "it is also carried", round - 2.0 * carried / v => "carried from one side to the other, and back";
    }
}

/// Where a small oscillation passes the middle first, and at which amplitude it would have the
/// speed of the rollers there.
fn quarter(p: &Parameters) -> Result<(f64, f64)> {
    let offset = 0.5 * lift(p, 1.0).min(p.runs() / rate(p, 1.0));
    let quarter = FRAC_PI_2 / rate(p, 1.0);
    let MechanismState { q, v } = released(&from(p, offset), 1.0, quarter)?.at(quarter)?;
    Ok((quarter - q[0] / v[0], offset * p.runs() / -v[0]))
}

fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let (swing, growth) = (rate(p, 1.0), rate(p, -1.0));
    let equal = cycle(&p.but(|p| p.holding = p.kinetic)).1;
    let slow = p.but(|p| (p.holding, p.speed) = (2.0 * p.kinetic, 1e-6 * swing * p.distance));
    let crawl = cycle(&slow).1 * slow.speed / (4.0 * held(&slow));
    let [thin, thick] = [0.0, 0.96 * p.distance / p.kinetic].map(|h| p.but(|p| p.thickness = h));
    let edge = from(p, lift(p, 1.0) * (1.0 - 1e-12));
    let left = released(&edge, 1.0, 1e-3 / swing)?.forces(0.0)?[0].normal / p.gravity;
    let tip = |offset| caught(&from(p, offset), -1.0)[2];
    let near = 1e-6 * (p.runs() / growth).min(p.distance);
    limits! { report,
        /// the roller lets go where it would have carried it through the middle
        "mu_s = mu_k: cycle over period": equal * swing / TAU => 1.0, within 1e-14;
        /// slow rollers: it is carried nearly all the time
        "V = 0: V times cycle over 4 x_s": crawl => 1.0, within 1e-10;
        /// friction at the lower face tips a thick plank towards the roller that drives it back
        "mu h = 0.96 a: period over that of a thin plank":
            quarter(&thick)?.0 / quarter(&thin)?.0 => 0.2, within 1e3 * p.tolerance.max(1e-13);
        /// the other roller carries all
        "at the edge: left force over the weight": left => 0.0, within 1e-11;
        /// tops apart: each factor ten nearer to the middle costs ln 10 over the rate
        "x_0 = 0: gain of t_tip in 1/rate": growth * (tip(0.1 * near) - tip(near)) => log(10.0), within 1e-9;
    }
}

/// Time of a small swing of a thin plank between rollers whose friction falls by this part per m/s
/// of slip, and by what factor the swing has grown.
fn grown(p: &Parameters, fading: f64) -> Result<[f64; 2]> {
    let (a, swing) = (p.distance, rate(p, 1.0));
    let rubs = |slip: f64| p.kinetic * slip.signum() * (1.0 - fading * (slip.abs() - p.runs()));
    let law = second_order(|_, x, v| {
        let (left, right) = (0.5 - x / a, 0.5 + x / a);
        p.gravity * (rubs(p.runs() - v) * left + rubs(-p.runs() - v) * right)
    });
    let small = 1e-3 * a.min(p.runs() / swing);
    let (there, _) = Dop853::new(1e-12)?.zero(&law, [small, 0.0], 2, 1e3 / swing, |y| y[1])?;
    Ok([there.t, there.state[0] / small])
}

/// What `--with falling` adds: a small swing grows, as one that is damped would die.
fn driven(p: &Parameters, report: &mut Report) -> Result<()> {
    let Some(fading) = p.falling else { return Ok(()) };
    let (gain, free) = (0.5 * p.gravity * fading * p.kinetic, rate(p, 1.0));
    allowed! {
        "thickness": p.thickness, from_to(0.0, 0.0), "friction that falls is for a thin plank";
        "growth over the rate of the swing": gain / free, between(0.0, 0.5), "else it grows within a swing";
    }?;
    let period = TAU / (free * free - gain * gain).sqrt();
    let [time, factor] = grown(p, fading)?;
    claims! { report,
        /// with friction that falls: period of a small swing
        falling_period: period, "s", "located event" => time, within 1e-8 * period;
        /// and by what factor it grows in a period
        falling_growth: exp(gain * period), "-", "located event" => factor, within 1e-7 * exp(gain * period);
    }
}

fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (mu, a, swing) = (p.kinetic, p.distance, rate(p, 1.0));
    let (thick, falling) = (0.5 * mu * 0.02 / a, 0.5 * p.gravity * 0.1 * mu);
    let is_thin = (swing * swing * a / (2.0 * mu * p.gravity) - 1.0).abs() < 0.1;
    let grown = when(falling < 0.1 * swing && is_thin, || grown(p, 0.1))?;
    let board = |h: f64| Ok::<_, kit::Error>(quarter(&p.but(|p| p.thickness = h))?.0);
    let slower = when(thick < 0.1, || Ok::<_, kit::Error>(board(0.02)? / board(0.0)? - 1.0))?;
    effect_card! { report,
        "friction that falls by 1 % for each 0.1 m/s of slip":
            "g |mu'|/(2 lambda)" = falling / swing, costs exp(falling * TAU / swing) - 1.0, "of the amplitude, gained in a swing",
            measured grown.map(|[_, factor]| factor - 1.0), within 1e-8;
        "a thickness of 2 cm": "mu h/(2 a)" = thick, costs -thick, "of the period", measured slower, within 1e-8;
        "coefficients of the rollers that differ by 1 %": "dmu/mu" = 0.01, costs 0.25 * 0.01 * a, "m, place of rest";
        "one roller higher by 1 mm": "dh/a" = 1e-3 / a, costs 1e-3 / (2.0 * mu), "m, place of rest";
    }
}

/// The accuracy strip: tops apart, from the start to the loss of the left roller.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (p, end) = (p.clone(), caught(p, -1.0)[2]);
    if end.is_infinite() {
        return Ok(()); // at rest in the middle
    }
    let lets_go = p.event_there(["right lets go", "left lets go"]);
    let (apart, start) = (plank(&p, -1.0)?, MechanismState::rest([p.offset, 0.0, 0.0]));
    let run = move |step| motion(apart.clone(), &Dop853::new(step)?, start, 2.0 * end);
    let error = move |ride: &Ride| Ok(largest([ride.event(lets_go)?.t / end - 1.0]));
    report.stepped([p.tolerance, 1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-15], run, Ride::work, error)?;
    report.in_closed_form(move |_| caught(&p, -1.0));
    Ok(())
}

/// What the smooth law makes of the cycle, unless that takes too long.
fn smooth(p: &Parameters, report: &mut Report) -> Result<()> {
    let round = cycle(p).1;
    let short = |part: &f64| p.holding * p.gravity * round / (part * p.runs()) < 1e5;
    let parts: Vec<_> = [1e-1, 1e-2, 1e-3].into_iter().filter(short).collect();
    if !goes_round(p) || parts.is_empty() {
        return Ok(());
    }
    let columns = "w / V; too long, as a part of the period; evaluations in a period";
    report.add(Table::of("smooth", columns.split("; "), parts, |part| {
        let (ode, method) = (smoothed(p, part * p.runs()), Dop853::new(1e-9)?);
        let zero = |n| method.zero(&ode, [p.offset, 0.0], n, 100.0 * span(p), |y| y[0]);
        let ((from, before), (to, after)) = (zero(3)?, zero(5)?);
        let late = format!("{:.5}", (to.t - from.t) / round - 1.0);
        Ok([format!("{part:e}"), late, (after.derivatives - before.derivatives).to_string()])
    })?)
}

example! {
    ch16_ex8_plank_on_rollers: "Exercise 16.8: a plank on two rollers that turn against each other";
    "A plank on two rollers", "A plank lies on two rollers that turn in opposite senses.",
    [claims, driven, limits, effects, accuracy, smooth];
    figures::figures, figures::trajectory, figures::moving_picture
}
