//! Further problem: a phone is thrown up with a somersault. Which side is up when it is caught?

#[path = "further_1_phone/figures.rs"]
mod figures;
#[path = "further_1_phone/recording.rs"]
mod recording;
#[path = "further_1_phone/throw.rs"]
pub mod throw;

use core::f64::consts::{LN_10, PI, TAU};
use kit::prelude::*;
use models::throws::made;
use rotation_dynamics::accuracy::Problem;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::frame::DesignVector;
use rotation_dynamics::inertia::{MassProperties, solids};
use rotation_dynamics::integrators::{Dop853, Event, Integrator, Rk4};
use rotation_dynamics::integrators::{after, ode, second_order, size_or};
use rotation_dynamics::scene::Scene;
use throw::{Throw, delay, euler, exchange, growth, in_air, measured_growth, screen, sway};

parameters! {
    /// A phone of a usual size, taken as a uniform slab, and a throw from the hand.
    pub struct Parameters {
        /// length
        length: number(0.147, "m", above(0.0).usually(0.1, 0.2)).drawn(0.140, 0.165, 0.005);
        /// width
        width: number(0.071, "m", above(0.0).usually(0.03, 0.095)).drawn(0.066, 0.078, 0.002);
        /// thickness
        thickness: number(0.0078, "m", above(0.0).usually(0.002, 0.025)).drawn(0.0070, 0.0090, 0.0002).open("thickness", "thin", "thick");
        /// mass
        mass: number(0.17, "kg", above(0.0).usually(0.1, 0.3)).drawn(0.15, 0.20, 0.01);
        /// turns a second
        turns: number(3.0, "1/s", any().usually(1.0, 5.0));
        /// how high it rises above the hand
        height: number(0.55, "m", above(0.0).usually(0.1, 2.0));
        /// angle of the axis of rotation from the short edge
        tilt: number(0.05, "rad", from_to(-1.2, 1.2).because("farther off it is no turn about the short edge").usually(0.001, 0.15)).open("angle of the axis from the short edge", "flips late", "flips at once");
        /// to which side: 0 towards the long edge, pi/2 towards the normal of the back
        toward: number(0.0, "rad", any().usually(-1.5, 1.5));
        /// spread of this angle from throw to throw, in each of the two directions
        spread: number(0.05, "rad", from_to(1e-3, 0.2).because("the strip is that of small strays").usually(0.01, 0.2));
        /// a mass that sits near a corner
        lump: number(0.01, "kg", at_least(0.0).usually(0.001, 0.03));
        gravity: gravity(above(0.0).usually(1.0, 25.0));
        /// error asked of the attitude after three flips: above 0, at most pi
        tolerance: number(1e-9, "rad", above_to(0.0, PI));
    }
}

/// A slab's moments about its long edge, its short edge and its normal.
pub fn slab(p: &Parameters) -> Result<[f64; 3]> {
    let (a, b, c) = (p.length, p.width, p.thickness);
    allowed! {
        "thickness over width": c / b, between(0.0, 0.999), "at 1 two moments are equal, and there is no middle axis";
        "width over length": b / a, between(0.0, 0.999), "at 1 two moments are equal, and there is no middle axis";
        "width over length": b / a, from_to(1e-3, 1.0), "a needle has no moment about its long edge";
        "mass times length squared, kg m^2,": p.mass * a * a, from_to(1e-30, 1e30), "moments far beyond leave the range of doubles";
    }?;
    Ok([b * b + c * c, a * a + c * c, a * a + b * b].map(|sum| p.mass * sum / 12.0))
}

/// The throw of these parameters.
pub fn thrown(p: &Parameters) -> Result<Throw> {
    allowed! { "size of the turns": p.turns.abs(), above(0.0), "what does not turn does not turn over"; }?;
    let throw = Throw::new(slab(p)?, TAU * p.turns, p.tilt, p.toward);
    // In seven and a half turns our phone makes a radian of an error of rounding: twice as many
    // are enough.
    allowed! {
        "size of the tilt": p.tilt.abs(), from_to(1e-10, 1.2), "about the very axis it never turns over";
        "distance of the start from the one that never turns over": throw.off(), from_to(1e-12, 1e3), "nearer, no double tells when it turns over";
        "turns in the flight": p.turns.abs() * flight(p), from_to(1e-4, 15.0), "with fewer there is nothing to see, and more multiply a rounding to a turn";
    }?;
    let frames = 60.0 * (throw.until_flip()? + 9.0 * throw.between_flips()?);
    allowed! { "frames of a clock until ten flips": frames, from_to(0.0, 1e6), "it turns too slowly"; }?;
    Ok(throw)
}

/// Time from the hand back to the hand.
pub fn flight(p: &Parameters) -> f64 {
    2.0 * (2.0 * p.height / p.gravity).sqrt()
}

// ANCHOR: hand
/// So many throws by a hand: a bell curve in each of two directions,
/// by points on a spiral, as the seeds of a sunflower lie.
pub fn hand(count: u32, moments: [f64; 3], rate: f64, spread: f64) -> impl Iterator<Item = Throw> {
    (0..count).map(move |k| {
        let part = (f64::from(k) + 0.5) / f64::from(count);
        let tilt = spread * (-2.0 * log(1.0 - part)).sqrt();
        let toward = f64::from(k) * GOLDEN_ANGLE;
        Throw::new(moments, rate, tilt, toward)
    })
}
// ANCHOR_END: hand

/// pi (3 - sqrt 5), what is between two seeds.
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

/// The part of a hand's throws that are not half over after so many turns, by the strip.
pub fn steady(moments: [f64; 3], turns: f64, spread: f64) -> Result<f64> {
    let [into_1, into_3] = exchange(moments);
    let strip = 4.0 * into_1.sqrt() * exp(-growth(moments) * TAU * turns);
    let half_width = strip / (spread * (1.0 + into_1 / into_3).sqrt());
    // What of a bell curve is inside.
    let bell =
        ode(|x, _: &[f64; 1]| [exp(-0.5 * x * x) * (2.0 / PI).sqrt()]).scaled(size_or([1.0; 1]));
    Ok(after(half_width.min(9.0), &bell, &[0.0], 1e-12)?[0])
}

/// So many throws are counted against [`steady`].
const COUNTED: u32 = 16_000;

/// By how much a count of this part of the throws may be off: by twice as much as it would
/// scatter by if they were drawn by chance, which is more than points on a spiral do, and by one.
fn scatter(part: f64) -> f64 {
    2.0 * (part / f64::from(COUNTED)).sqrt() + 1.0 / f64::from(COUNTED)
}

/// The part of `throws` of which this holds.
pub fn part(
    throws: impl Iterator<Item = Throw>,
    holds: impl Fn(Throw) -> Result<bool>,
) -> Result<f64> {
    let held: Vec<bool> = throws.map(holds).collect::<Result<_>>()?;
    Ok(held.iter().filter(|&&held| held).count() as f64 / held.len() as f64)
}

/// The widest throw that is asked for: farther off it is about another axis.
const WIDEST: f64 = 1.4;

/// The angle off the short edge from which it first turns over after the time t, by `until`; the
/// widest, if it turns over later from there as well.
pub fn margin(
    t: f64,
    pace: f64,
    until: impl Fn(f64) -> rotation_dynamics::Result<f64>,
) -> rotation_dynamics::Result<f64> {
    let mut tilt = exp(-pace * t);
    for _ in 0..40 {
        // What is late by x must begin e^(pace x) times farther off.
        let late: f64 = until(tilt)? - t;
        tilt = (tilt * exp(pace * late)).min(WIDEST);
        if late.abs() < 1e-13 * t {
            break;
        }
    }
    Ok(tilt)
}

/// How the axes lie if this mass sits 0.4 of the length and 0.35 of the width off the centre, on
/// the middle plane: the angle between the middle axis and the short edge.
fn lopsided(p: &Parameters, [i1, i2, _]: [f64; 3]) -> Result<[f64; 2]> {
    let (x, y) = (0.4 * p.length, 0.35 * p.width);
    let reduced = p.mass * p.lump / (p.mass + p.lump);
    let (product, apart) = (reduced * x * y, i2 - i1 + reduced * (x - y) * (x + y));
    let slab = solids::cuboid(p.mass, p.length, p.width, p.thickness)?;
    let mut parts = vec![slab];
    if p.lump > 0.0 {
        parts.push(MassProperties::of_points(&[(p.lump, DesignVector::new(x, y, 0.0))])?);
    }
    let both = MassProperties::of_parts(&parts)?.about_centre_of_mass();
    let [_, middle, _] = both.principal_axes().axes();
    let library = atan2(middle.x().abs(), middle.y().abs());
    Ok([0.5 * atan2(2.0 * product, apart), library])
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (throw, turn, caught) = (thrown(p)?, TAU * p.turns, flight(p));
    let (rate, turns, tilt) = (turn.abs(), p.turns.abs(), p.tilt.abs());
    let moments @ [i1, i2, i3] = throw.moments;
    let solid = solids::cuboid(p.mass, p.length, p.width, p.thickness)?.about_centre_of_mass();
    let library = |i: usize| solid.matrix()[i][i];
    let fall = second_order(|_, _, _| -p.gravity);
    let speed = (2.0 * p.gravity * p.height).sqrt();
    let falls = Dop853::new(1e-14)?.zero(&fall, [0.0, speed], 1, 2.0 * caught, |y| y[0]);
    let pace = growth(moments) * rate;
    let (first, between) = (throw.until_flip()?, throw.between_flips()?);
    let [one, two, ten] = [1, 2, 10].map(|count| throw.flip(count, 1e-15));
    let one = one?;
    let last = first + 9.0 * between;
    // Each flip multiplies an error of rounding, the later ones by as much again.
    let slack = 1e-12 * last + 1e-14 / (throw.off() * pace);
    let late = slack + 1e-14 / (throw.off() * throw.off() * pace);
    let count = throw.flips(caught)?;
    // At the catch the attitude is off by what it turns in the time by which rounding makes it
    // late: that grows until the first flip, and from halfway to the next one on with each.
    let lag = match caught < first + 0.5 * between {
        true => slack * exp(pace * (caught - first)).min(1.0),
        false => count * late,
    };
    let astray = 1e-10 + 0.1 * rate * lag;
    let decided = astray < 1e-3; // else no double says how it is caught
    let run = Dop853::new(1e-13)?.solve(&euler(moments), 0.0, &throw.rates, caught, &[over()])?;
    let counted = run.events().len() as f64;
    let from = |toward: f64| move |tilt| Throw::new(moments, turn, tilt, toward).until_flip();
    let stepped =
        |toward: f64| move |tilt| Ok(Throw::new(moments, turn, tilt, toward).flip(1, 1e-15)?.t);
    let long = margin(caught, pace, from(0.0))?;
    let normal = margin(caught, pace, from(0.5 * PI))?;
    let aimed = pace * caught < 25.0; // else no double is near enough to the axis
    let tenth = |tilt| Throw::new(moments, turn, tilt, 0.0);
    let waited = tenth(1e-7).flip(1, 1e-15)?.t - tenth(1e-6).flip(1, 1e-15)?.t;
    let [exact, run] = [throw.free()?.attitude(caught), throw.stepped(caught, 1e-15)?];
    let away = |attitude: &Attitude| attitude.to_space(BodyVector::new(1.0, 0.0, 0.0)).x();
    let sways = |axis: usize| {
        let (angle, throw) = sway(moments, axis, tilt);
        let ends = [throw.rates, throw.flip(1, 1e-15)?.state];
        let angles = ends.map(|rates| acos(throw.along(axis, rates).min(1.0)));
        Ok::<_, rotation_dynamics::Error>([angle, angles[0].max(angles[1])])
    };
    let [along_long, along_normal] = [sways(0)?, sways(2)?];
    let hands = |count| hand(count, moments, turn, p.spread);
    let not_over = |after: f64| {
        let over = |throw: Throw| Ok(throw.until_flip()? < after / turns);
        Ok::<_, kit::Error>(1.0 - part(hands(COUNTED), over)?)
    };
    let down =
        |of: &dyn Fn(&Throw) -> Result<f64>| part(hands(2500), |throw| Ok(of(&throw)? < 0.0));
    let steady = [steady(moments, 1.0, p.spread)?, steady(moments, turns * caught, p.spread)?];
    // The strip is that of small strays.
    let [into_1, into_3] = exchange(moments);
    let askance = 0.2 * p.spread * p.spread / into_1.min(into_3);
    let miscounted = steady.map(|part| scatter(part) + askance * part.sqrt());
    // At most such a part of the throws is within 1e-5 of one that never turns over: how they
    // come back, steps of 1e-10 cannot tell.
    let unsure = 0.8e-5 / p.spread;
    let [askew, askew_library] = lopsided(p, moments)?;
    claims! { report,
        /// least moment, about the long edge
        i1: i1, "kg m^2", "library's cuboid" => library(0), within 1e-14 * i1, in "The phone":
            i2 => "that is about the short edge",
            4.0 * i1 => "through the centre, not along an edge";
        /// middle moment, about the short edge
        i2: i2, "kg m^2", "library's cuboid" => library(1), within 1e-14 * i2, in "The phone":
            i1 => "that is about the long edge",
            i3 => "that is about the normal of the screen";
        /// largest moment, about the normal of the screen
        i3: i3, "kg m^2", "library's cuboid" => library(2), within 1e-14 * i3, in "The phone":
            i2 => "that is about the short edge";
        /// time in the air
        flight: caught, "s", "fall, located event" => falls?.0.t, within 1e-12 * caught, in "The throw":
            0.5 * caught => "that is the way up; it comes down as well";
        /// rate at which an error grows
        // An error of a step is a part of the whole rate, however slowly a stray grows.
        growth: pace, "1/s", "growth of 1e-7, stepped" => rate * measured_growth(moments)?, within 1e-9 * rate, in "The throw":
            pace / rate => "that is per radian of its turning",
            pace / turns => "that is per turn";
        /// factor by which it grows in a turn
        per_turn: exp(pace / turns), "-", "the same, stepped" => exp(TAU * measured_growth(moments)?),
        within 1e-7 * exp(pace / turns), in "The throw":
            exp(growth(moments)) => "a turn is 2 pi radians";
        /// time until it is half over
        half_over: first, "s", "located event" => one.t, within slack, in "The throw":
            between => "that is from one flip to the next",
            log(1.0 / tilt) / pace => "e-foldings alone: what is the factor before the exponential?";
        /// time from one flip to the next
        between: between, "s", "located events" => two?.t - one.t, within late, if throw.off() > 1e-5, in "The throw":
            2.0 * between => "that is a whole period, two flips",
            first => "that is from the release to the first";
        /// flips in the flight
        flips: count, "-", "counted, stepped" => counted, within 0.4, if decided, in "The throw";
        /// turns of the throw until it is half over
        turns_to_flip: turns * first, "-", "located event" => turns * one.t, within turns * slack;
        /// off towards the long edge: half over just at the catch
        margin_long: long, "rad", "stepped" => margin(caught, pace, stepped(0.0))?, within 1e-6 * long + 1e-14, if aimed && long < WIDEST,
        in "How well one must aim":
            exp(-pace * caught) => "the factor before the exponential is missing";
        /// the same, off towards the normal
        margin_normal: normal, "rad", "stepped" => margin(caught, pace, stepped(0.5 * PI))?,
        within 1e-6 * normal + 1e-14, if aimed && normal < WIDEST, in "How well one must aim":
            long => "that is towards the long edge";
        /// ten times nearer to the axis: so much later
        decade: LN_10 / pace, "s", "from 1e-6 and 1e-7 rad, stepped" => waited, within 1e-5 / pace, in "How well one must aim":
            1.0 / pace => "that is e times nearer",
            2.0 * LN_10 / pace => "between two flips; to the first it counts once";
        /// the tenth flip
        tenth: last, "s", "located event" => ten?.t, within 20.0 * late, if throw.off() > 1e-5, in "Ten flips":
            10.0 * between => "the first comes after half of that";
        /// cosine of the screen's direction from upward at the catch
        screen: screen(&exact).z(), "-", "stepped" => screen(&run).z(), within astray, if decided, in "The catch";
        /// cosine of the long edge's direction from that of the start
        long_edge: away(&exact), "-", "stepped" => away(&run), within astray, if decided, in "The catch";
        /// about the long edge: largest angle between it and L
        sway_long: along_long[0], "rad", "stepped to its two ends" => along_long[1], within 1e-8;
        /// about the normal of the screen: the same
        sway_normal: along_normal[0], "rad", "stepped to its two ends" => along_normal[1], within 1e-8;
        /// by hand: part not half over after one turn
        steady_one: steady[0], "-", "16000 throws, counted" => not_over(1.0)?, within miscounted[0];
        /// by hand: part not half over at the catch
        steady_caught: steady[1], "-", "16000 throws, counted" => not_over(turns * caught)?, within miscounted[1];
        /// by hand: part that is caught screen down
        hand_down: down(&|throw| Ok(screen(&throw.free()?.attitude(caught)).z()))?, "-", "stepped" =>
            down(&|throw| Ok(screen(&throw.stepped(caught, 1e-10)?).z()))?, within unsure.max(1e-3);
        /// lump near a corner: middle axis from the short edge
        askew: askew, "rad", "library's principal axes" => askew_library, within 1e-13 + (1e-14 / askew).min(1e-9);
    }
}

/// The event that axis 2 is across L.
pub fn over<'a>() -> Event<'a, 3> {
    Event::crossing("half over", |_, y: &[f64; 3]| y[1])
}

/// Nearly the axis, a thin plate, two moments nearly equal, the direction that comes nearer first.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let moments = slab(p)?;
    let [into_1, into_3] = exchange(moments);
    let (pace, tiny) = (growth(moments), |toward| Throw::new(moments, 1.0, 1e-9, toward));
    let wait = |factor: f64| log(4.0 * factor / 1e-9) / pace;
    let lean = (into_1 / into_3).sqrt();
    let never = atan2(1.0, lean); // p = lean r
    let plate = [1.0, 3.0, 4.0];
    let needle = [1.0, 3.0, 3.0 + 1e-8];
    let beside = Throw::new(moments, 1.0, 1e-3, never + 1e-7);
    let lost = log(4.0 * into_1.sqrt() / beside.off()) / pace;
    limits! { report,
        /// a logarithm: the first factor is that of the long edge
        "tilt = 1e-9: t_1 less its logarithm": tiny(0.0).until_flip()? - wait(into_1.sqrt()) => 0.0, within 1e-12 / pace;
        /// and this that of the normal
        "toward pi/2: the same": tiny(0.5 * PI).until_flip()? - wait(into_3.sqrt()) => 0.0, within 1e-12 / pace;
        /// from beside the axis the first wait is half of the others
        "toward = 0: T/t_1": tiny(0.0).between_flips()? / tiny(0.0).until_flip()? => 2.0, within 1e-15;
        /// beside the direction that runs into the axis only what is off it counts
        "tilt = 1e-3, beside: t_1 less its logarithm": beside.until_flip()? - lost => 0.0, within 1e-5 / pace;
        /// a plate has I3 = I1 + I2
        "plate with I2 = 3 I1: lambda^2/Omega^2": growth(plate) * growth(plate) => (plate[1] - plate[0]) / (plate[1] + plate[0]), within 1e-15;
        /// two equal moments: nothing grows
        "I3 = I2: lambda/Omega": growth(needle) => 0.0, within 1e-4;
    }
}

/// The parts of the rates about the long edge and the short one that the air takes while the
/// plate turns by a radian about the short one: of pieces pressed with `press` w^2, N/m^2.
pub fn drag([l, b]: [f64; 2], press: f64, [i1, i2, _]: [f64; 3]) -> [f64; 2] {
    let whole = press * b * l * l * l * l / (32.0 * i2);
    [press * l * l * b * b * b / (24.0 * i1), whole]
}

/// Air; the hand; a phone that is not uniform; the fall.
fn effects(p: &Parameters, report: &mut Report) -> Result<()> {
    let (throw, turn, caught) = (thrown(p)?, TAU * p.turns, flight(p));
    let (rate, tilt) = (turn.abs(), p.tilt.abs());
    let [i1, i2, i3] = throw.moments;
    let (pace, first) = (growth(throw.moments) * rate, throw.until_flip()?);
    let (edges, press) = ([p.length, p.width], 0.5 * 1.204 * 1.2);
    let braked = drag(edges, press, throw.moments).map(|part| part * rate);
    let slowed = braked[1];
    let late = delay(braked, first, pace);
    // Both estimates are those of the exponential growth: of strays that are small beside what
    // they grow to.
    let [into_1, into_3] = exchange(throw.moments);
    let small = tilt < 0.3 * into_1.min(into_3).sqrt();
    // What air would stop before it is over has no flip to be delayed, and of two strays that
    // nearly cancel each other it takes more of one than of the other.
    let law = in_air(throw.moments, edges, press);
    let windy = when(small && slowed * first < 0.1 && throw.off() > 0.7 * tilt, || {
        Dop853::new(1e-12)?.zero(&law, throw.rates, 1, 10.0 * first, |y| y[1])
    })?;
    let windy = windy.map(|(flip, _)| (flip.t - first).abs());
    let [askew, _] = lopsided(p, throw.moments)?;
    let speed = (2.0 * p.gravity * p.height).sqrt();
    // Wind of the flight on a face, its centre of pressure a tenth of the width off.
    let wind = 0.5 * 1.204 * 1.2 * p.length * p.width * speed * speed * 0.1 * p.width;
    let gradient = 3.0 * 9.80665 / 6.371e6 * (i3 - i1) / i2;
    let more = Throw::new(throw.moments, turn, p.tilt + 0.0175 * p.tilt.signum(), p.toward);
    let more = more.flip(1, 1e-12)?.t;
    let sooner = small.then_some(first - more);
    effect_card! { report,
        "a degree in the throw": "delta/tilt" = 0.0175 / tilt, costs log(1.0 + 0.0175 / tilt) / pace, "s to the first flip",
            measured sooner;
        "a lump near a corner": "angle of axis 2" = askew, costs askew, "rad of aim";
        "air, on the turning": "rho C b l^4 Omega^2/(64 L lambda)" = slowed / pace, costs late.abs(), "s to the first flip",
            measured windy, within 1e-6 * first;
        "air, on the flight": "rho C S v^2 b/(20 I2 Omega lambda)" = wind / (i2 * rate * pace), costs wind * caught / (i2 * rate), "rad of L, at most";
        "gravity is weaker above": "3 (I3 - I1) g/(R_E I2 lambda^2)" = gradient / (pace * pace), costs gradient / pace * caught, "rad of L, at most";
    }
}

/// Ten flips in a row: closed form, steps that hold an error, and steps of a clock.
fn ten_flips(p: &Parameters, report: &mut Report) -> Result<()> {
    let throw = thrown(p)?;
    let (first, between) = (throw.until_flip()?, throw.between_flips()?);
    let clock = by_a_clock(&throw, 20.0 * (first + between))?;
    let columns =
        ["flip", "closed form", "DOP853, 1e-15", "DOP853, 1e-6", "RK4, 60 steps a second"];
    report.add(Table::of("ten", columns, 1..=10, |n: u32| {
        let exact = first + f64::from(n - 1) * between;
        let off = |t: f64| format!("{:+.1e} s", t - exact);
        let [fine, coarse] = [1e-15, 1e-6].map(|step| throw.flip(n, step));
        let stepped = clock.get(n as usize - 1).map_or("lost".into(), |t| off(*t));
        Ok([n.to_string(), format!("{exact:.6} s"), off(fine?.t), off(coarse?.t), stepped])
    })?)
}

/// The times of at most ten flips until this time, by RK4 with 60 steps a second for as long as it
/// follows.
fn by_a_clock(throw: &Throw, until: f64) -> Result<Vec<f64>> {
    let (mut flips, mut t, mut rates) = (Vec::new(), 0.0, throw.rates);
    let (law, fixed) = (euler(throw.moments), Rk4::new(1)?);
    while flips.len() < 10 && t < until {
        let before = rates;
        rates = match fixed.advance(&law, 0.0, &before, 1.0 / 60.0) {
            Ok((next, _)) if throw.energy(next) < 2.0 * throw.energy(throw.rates) => next,
            // Too long a step for such a turning makes energy out of nothing.
            _ => break,
        };
        if before[1] * rates[1] <= 0.0 {
            flips.push(t + before[1] / (before[1] - rates[1]) / 60.0);
        }
        t += 1.0 / 60.0;
    }
    Ok(flips)
}

/// Thrown about the short edge to the last bit, and stepped with attitude and L in space: when
/// it turns over all the same, if it does within thirty turns.
pub fn by_rounding(moments: [f64; 3], step: f64) -> Result<Option<f64>> {
    let throw = Throw { moments, rates: [0.0, TAU, 0.0] };
    let (scene, method) = (Scene::new(throw.body()?), Dop853::new(step)?);
    // Held in no special direction.
    let held = Attitude::from_euler(EulerAngles { phi: 0.3, theta: 1.0, zeta: 0.4 })?;
    let rates = BodyVector::from_array(throw.rates);
    let (mut state, mut last) = (throw.body()?.state(held, rates)?, 0.0);
    for t in times(0.0, 30.0, 600).skip(1) {
        state = method.advance(&scene, last, &state, t)?.0;
        if throw.body()?.angular_velocity(&state).y() < 0.0 {
            return Ok(Some(t));
        }
        last = t;
    }
    Ok(None)
}

/// [`by_rounding`], for three errors of a step.
fn rounding(p: &Parameters, report: &mut Report) -> Result<()> {
    let body = Dop853::new(1e-6)?.advance(&euler(slab(p)?), 0.0, &[0.0, TAU, 0.0], 1000.0)?.0;
    let never = if body == [0.0, TAU, 0.0] { "never in 1000 turns" } else { "it has strayed" };
    let mut table = Table::new("rounding", ["stepped", "half over after"])?;
    table.push(["rates on the body's axes, 1e-6", never])?;
    for step in [1e-6, 1e-10, 1e-15] {
        let after = by_rounding(slab(p)?, step)?;
        let told = after.map_or("never in 30 turns".into(), |t| format!("{t:.1} turns"));
        table.push([format!("attitude and L in space, {step:e}"), told])?;
    }
    report.add(table)
}

/// The accuracy strip: the attitude after three flips and a third, where errors have grown; before
/// the first, if it starts so near to the axis that no double knows it after that.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let throw = thrown(p)?;
    let (motion, first) = (throw.free()?, throw.until_flip()?);
    let late = throw.off() > 1e-8;
    let end = if late { first + 7.0 / 3.0 * throw.between_flips()? } else { 0.5 * first };
    let problem = Problem::new(Scene::new(throw.body()?), throw.start()?, end, motion.state(end));
    let problem = problem.in_closed_form(move |t| motion.attitude(t));
    report.strip(&problem, &[p.tolerance, 1e-3, 1e-6, 1e-10])
}

/// All figures: the page's own, and those of the made-up recording.
fn drawings(p: &Parameters) -> Result<Vec<Figure>> {
    Ok([figures::figures(p)?, made::figures()?].concat())
}

example! {
    further_1_phone: "Further problem: a phone thrown up with a somersault";
    "A phone thrown up", "A phone is thrown up with a somersault about its middle axis, and a little beside it.",
    [claims, limits, effects, ten_flips, rounding, made::report, accuracy];
    drawings, figures::trajectory, figures::moving_picture; recording::RECORDINGS
}
