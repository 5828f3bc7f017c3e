//! Euler's disc: a coin or a heavy disc spun on a table, which settles faster and faster.

#[path = "further_3_euler_disc/figures.rs"]
mod figures;
#[path = "further_3_euler_disc/rolling.rs"]
mod rolling;

use core::f64::consts::{FRAC_PI_2, PI, TAU};
use kit::prelude::*;
use rotation_dynamics::Error;
use rotation_dynamics::attitude::{Attitude, EulerAngles};
use rotation_dynamics::integrators::{Dop853, LocatedEvent, Solution, Work, small_frequency};
use rotation_dynamics::math::round_even;

pub use rolling::{Disc, Loss, attitude, placed, rolling, settling};

parameters! {
    /// The disc of Moffatt's note; the inclination of the steady motion is ours.
    pub struct Parameters {
        /// radius of the disc
        radius: number(0.0375, "m", above(0.0).usually(0.01, 0.1)).drawn(0.0300, 0.0450, 0.0025);
        /// its mass
        mass: number(0.4, "kg", above(0.0).usually(0.003, 1.0)).drawn(0.30, 0.50, 0.05);
        /// inclination of the steady motion
        inclination: number(0.4, "rad", between(0.0, FRAC_PI_2).because("flat it is at rest, upright it spins like a top").usually(0.05, 1.0)).drawn(0.20, 0.60, 0.05).open("inclination of the disc", "flat: races", "steep: rolls slowly");
        /// radius of the circle of its centre over R; positive on the side away from the contact
        circle: number(0.0, "-", at_least(-1e3).because("on a larger circle it is a wheel on a straight line").usually(-2.0, 0.1));
        /// inclination from which it settles
        start: number(0.1, "rad", above_to(0.0, 0.2).because("the law is that of small inclinations").usually(0.05, 0.2));
        /// what brakes it: the air under it, or rolling friction
        loss: choice("air", "rolling");
        /// coefficient of rolling friction
        rolling: number(2e-5, "-", above_to(0.0, 2e-4).because("without a loss it never settles, with more the contact stops before the disc is flat").usually(5e-6, 1e-4));
        /// viscosity of the air
        viscosity: number(1.78e-5, "Pa s", above(0.0).because("without a loss it never settles").usually(1e-5, 1e-4));
        /// thickness under the centre at which a film of air, or a smooth edge, is none any more
        film: number(1e-5, "m", at_least(1e-6).because("a thinner film is below the roughness of an edge").usually(1e-6, 1e-4));
        /// a time before the end that is asked about
        left: number(1.0, "s", above(0.0).usually(0.01, 50.0));
        gravity: gravity(above(0.0).usually(1.0, 25.0));
        /// error of a step of the simulations: from 1e-14 to 1e-8
        tolerance: number(1e-10, "-", from_to(1e-14, 1e-8));
    }
}

/// A steady motion: inclination, and radius of the circle of the centre in R.
#[derive(Debug, Clone, Copy)]
pub struct Steady {
    pub tilt: f64,
    pub circle: f64,
}

impl Steady {
    /// Rate at which the contact runs round, in sqrt(g/R).
    pub fn rate(&self) -> f64 {
        let (s, c) = sincos(self.tilt);
        2.0 * (c / (s * (c - 6.0 * self.circle))).sqrt()
    }

    /// Angular velocity about the disc's axis.
    pub fn spin(&self) -> f64 {
        self.circle * self.rate()
    }

    /// How fast the face turns, seen from above.
    pub fn face(&self) -> f64 {
        let half = sin(0.5 * self.tilt);
        self.rate() * (2.0 * half * half) + self.spin()
    }

    /// The state with the contact at its start.
    pub fn placed(&self) -> Result<[f64; 9]> {
        placed(self.tilt, [self.rate(), 0.0, self.spin()], self.circle)
    }

    /// Energy in m g R.
    pub fn energy(&self) -> f64 {
        let (s, across) = (sin(self.tilt), self.rate() * sin(self.tilt));
        s + 0.125 * across * across + 0.75 * self.spin() * self.spin()
    }

    /// Square of the angular frequency of a small nodding, over that of the rate.
    pub fn nodding(&self) -> f64 {
        let ((s, c), b) = (sincos(self.tilt), self.circle);
        0.8 * (3.0 * b * b - 2.5 * c * b + s * s + 0.75 * c * c + 1.5 * b * s * s / c)
    }
}

// ANCHOR: settle
/// How the inclination falls, if slowly: as -k tilt^(-n) (1 - c tilt^2), in sqrt(g/R).
#[derive(Debug, Clone, Copy)]
pub struct Settling {
    pub k: f64,
    pub n: f64,
    pub c: f64,
}

impl Settling {
    pub fn of(loss: Loss) -> Self {
        let [k, n, c] = match loss {
            Loss::Rolling(part) => [4.0 / 3.0 * part, 0.5, 161.0 / 108.0],
            Loss::Air(viscosity) => [TAU / 3.0 * viscosity, 2.0, 73.0 / 54.0],
            // Of both together the fall is a sum of two powers.
            Loss::None | Loss::Both(..) => [0.0; 3],
        };
        Self { k, n, c }
    }

    /// The steady motion through which a disc passes that has settled for long.
    pub fn passing(tilt: f64) -> Steady {
        Steady { tilt, circle: 5.0 / 18.0 * tilt * tilt }
    }

    /// Time left until the singularity.
    pub fn left(&self, tilt: f64) -> f64 {
        let first = pow(tilt, self.n + 1.0) / ((self.n + 1.0) * self.k);
        first * (1.0 + self.c * tilt * tilt * (self.n + 1.0) / (self.n + 3.0))
    }

    /// Inclination when so much time is left.
    pub fn tilt(&self, left: f64) -> f64 {
        let first = pow((self.n + 1.0) * self.k * left, 1.0 / (self.n + 1.0));
        let better = |tilt: f64, _| first * (1.0 - self.c * tilt * tilt / (self.n + 3.0));
        (0..4).fold(first, better)
    }

    /// The rate goes with this power of the time left, the other way.
    pub fn exponent(&self) -> f64 {
        0.5 / (self.n + 1.0)
    }

    /// Where the centre would have to fall with the acceleration g.
    pub fn falls(&self) -> f64 {
        pow(self.n * self.k * self.k, 1.0 / (2.0 * self.n + 1.0))
    }

    /// Turns of the contact from this inclination to the singularity.
    pub fn turns(&self, tilt: f64) -> f64 {
        let (m, more) = (self.n + 0.5, (11.0 / 12.0 + self.c) * tilt * tilt);
        pow(tilt, m) / (self.k * PI) * (1.0 / m + more / (m + 2.0))
    }

    /// Part of the inclination that it loses while the contact goes round by a radian.
    pub fn haste(&self, tilt: f64) -> f64 {
        0.5 * self.k * pow(tilt, -self.n - 0.5)
    }
}
// ANCHOR_END: settle

impl Settling {
    /// The state of a disc that has settled for long, down to this inclination: it is falling
    /// already, and its face will come to rest.
    pub fn state(&self, tilt: f64) -> Result<[f64; 9]> {
        let (steady, falling) = (Self::passing(tilt), -self.k * pow(tilt, -self.n));
        placed(tilt, [steady.rate(), falling, steady.spin()], steady.circle)
    }
}

/// When the inclination was that of each mark.
pub fn passed(run: &Solution<9>) -> Vec<f64> {
    run.events().iter().filter(|event| event.name == "mark").map(|event| event.t).collect()
}

/// The settling by one loss: its law, and simulated.
struct Settled {
    name: &'static str,
    /// The unit of time.
    time: f64,
    loss: Loss,
    law: Settling,
    film: f64,
    /// Where the law ends: at the acceleration g, or at the film.
    law_ends: f64,
    run: Solution<9>,
    passed: Vec<f64>,
    /// When it would end.
    end: f64,
}

impl Settled {
    fn by(name: &'static str, p: &Parameters) -> Result<Self> {
        let (time, start) = ((p.radius / p.gravity).sqrt(), p.start);
        let loss = match name {
            "air" => Loss::Air(p.viscosity * p.radius / p.mass * time),
            _ => Loss::Rolling(p.rolling),
        };
        let (law, film) = (Settling::of(loss), p.film / p.radius);
        let law_ends = law.falls().max(film);
        allowed! {
            "inclination at which the law ends, less than a tenth of the start,": law_ends, between(0.0, 0.1 * start), "there it falls with g, or the film ends: start steeper, or with less loss";
            "turns until it has settled": law.turns(start), from_to(0.0, 3e4), "a smaller loss takes too long to simulate";
        }?;
        let marks = [0.4, 0.2, 0.1].map(|part| part * start);
        let until = 2.0 * law.left(start);
        let run = settling(loss, law.state(start)?, &marks, film, until, p.tolerance)?;
        let passed = passed(&run);
        // Slow enough there for the law to say what is left.
        let end = passed[2] + law.left(marks[2]);
        Ok(Self { name, time, loss, law, film, law_ends, run, passed, end })
    }

    fn at(&self, t: f64) -> rotation_dynamics::Result<Disc> {
        Ok(Disc::new(&self.run.at(t)?))
    }

    /// Turns of the contact from the start to `t`, by the rule of Simpson.
    fn turns(&self, t: f64) -> Result<f64> {
        Ok(kit::simpson([0.0, t], 20_000, |t| Ok::<_, kit::Error>(self.at(t)?.rate))? / TAU)
    }

    /// The exponent for which rate^(-1/exponent) falls on a line over the marks: bisected, as a
    /// smaller one bends it one way and a larger one the other.
    fn exponent(&self) -> Result<f64> {
        let rates = sampled(self.passed.iter().copied(), |t| Ok(self.at(t)?.rate))?;
        let bent = |guess| bend(guess, &self.passed, &rates) > 0.0;
        let [low, high] = bisect([0.02, 1.0], 0.0, bent);
        Ok(0.5 * (low + high))
    }
}

/// How much rate^(-1/exponent) falls more in the first of two spans than in the second.
pub fn bend(exponent: f64, t: &[f64], rates: &[f64]) -> f64 {
    let z = |i: usize| pow(rates[i] / rates[0], -1.0 / exponent);
    (z(0) - z(1)) / (t[1] - t[0]) - (z(1) - z(2)) / (t[2] - t[1])
}

/// The steady motion of the page; refused if there is none or the disc would leave it.
fn steady(p: &Parameters) -> Result<Steady> {
    let motion = Steady { tilt: p.inclination, circle: p.circle };
    allowed! {
        "cos(inclination) - 6 circle": cos(p.inclination) - 6.0 * p.circle, above(0.0), "else no rate holds it on this circle";
        "square of the frequency of a nodding, over that of the rate,": motion.nodding(), above(0.02), "below 0 it falls over, near 0 it nods too slowly to be measured";
    }?;
    Ok(motion)
}

/// A turn of the contact, simulated.
fn back(motion: Steady, step: f64) -> Result<(LocatedEvent<9>, Work)> {
    let (start, until) = (motion.placed()?, 2.0 * TAU / motion.rate());
    let across = |y: &[f64; 9]| Disc::new(y).axis.x();
    Ok(Dop853::new(step)?.zero(&rolling(Loss::None), start, 2, until, across)?)
}

/// How long it takes, and the disc after it.
fn turn(motion: Steady, step: f64) -> Result<(f64, Disc)> {
    let (back, _) = back(motion, step)?;
    Ok((back.t, Disc::new(&back.state)))
}

/// The frequency of a small nodding, simulated.
pub fn measured_nodding(motion: Steady) -> rotation_dynamics::Result<f64> {
    let kick = motion.tilt.min(0.3) * motion.nodding().sqrt() * motion.rate();
    let kicked = |size: f64| {
        let rates = [motion.rate(), size * kick, motion.spin()];
        placed(motion.tilt, rates, motion.circle).unwrap_or([f64::NAN; 9])
    };
    let rest = Disc::new(&kicked(0.0)).tilt;
    let nods = |y: &[f64; 9]| Disc::new(y).tilt - rest;
    small_frequency(&rolling(Loss::None), kicked, 200.0, nods)
}

fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
    let (motion, time) = (steady(p)?, (p.radius / p.gravity).sqrt());
    let (rate, (s, c)) = (motion.rate() / time, sincos(p.inclination));
    let (back, _) = back(motion, p.tolerance)?;
    let (turned, disc, zeta) =
        (back.t, Disc::new(&back.state), attitude(&back.state)?.euler_angles().zeta);
    // Spin and precession in a turn, to whole turns: it is less than half a turn off.
    let face = motion.face() * turned;
    let seen = zeta + TAU * round_even((face - zeta) / TAU);
    let energy = p.mass * p.gravity * p.radius;
    let (now, held) = (disc.angular_velocity.norm(), disc.energy());
    let (nods, bound) = (rate * motion.nodding().sqrt(), 1e4 * p.tolerance);
    claims! { report,
        /// rate at which the contact runs round
        rate: rate, "rad/s", "a turn in vectors" => TAU / (turned * time), within bound * rate, in "The steady motion":
            rate / 2.0_f64.sqrt() => "about a diameter the moment of inertia is m R^2/4",
            (p.gravity / (p.radius * s)).sqrt() => "about a diameter the moment of inertia is m R^2/4",
            rate / TAU => "that is turns a second";
        /// angular speed of the disc
        omega: hypot(rate * s, motion.spin() / time), "rad/s", "a turn in vectors" => now / time, within bound * rate,
        in "The steady motion":
            rate => "that is how fast the contact runs",
            rate * c => "the disc turns about a line in its plane: which?";
        /// how fast its face turns, seen from above
        face: motion.face() / time, "rad/s", "quaternion after a turn" => seen / (turned * time), within bound * rate,
        in "The steady motion":
            rate => "that is how fast the contact runs",
            rate * (1.0 + c) => "the spin is opposite to the precession";
        /// energy
        energy: motion.energy() * energy, "J", "after a turn" => held * energy, within bound * energy, in "The steady motion":
            s * energy => "it moves as well",
            2.0 * s * energy => "the centre rests: only the turning has kinetic energy";
        /// angular frequency of a small nodding
        nodding: nods, "rad/s", "two kicks" => measured_nodding(motion)? / time, within 1e-7 * nods, in "The steady motion":
            rate => "the nodding is slower";
    }
}

/// The settling by both losses; the chosen one is asked for times and tones.
fn last_seconds(p: &Parameters, report: &mut Report) -> Result<()> {
    let (air, rolls) = (Settled::by("air", p)?, Settled::by("rolling", p)?);
    let run = if p.loss == "air" { &air } else { &rolls };
    let (law, time, asked) = (run.law, run.time, p.left);
    let (whole, ends) = (law.left(p.start), law.left(run.law_ends) * time);
    allowed! {
        "left, down to where the law ends,": asked, from_to(ends, 0.85 * whole * time), "longer than the disc settles there is nothing left";
    }?;
    table_of_ends([&air, &rolls], report)?;
    let hasty = |by: &Settled| 3.0 * pow(by.law.haste(0.1 * p.start), 2.0);
    let tilt = law.tilt(asked / time);
    let near = 3.0 * pow(p.start, 4.0) + hasty(run);
    let about = |by: &Settled| by.law.exponent() * (p.start * p.start + hasty(by));
    let then = run.at(run.end - asked / time);
    let told = then.as_ref().map_or(f64::NAN, |disc| disc.tilt);
    let tone = |tilt: f64| Settling::passing(tilt).rate() / (TAU * time);
    let sounds = then.as_ref().map_or(f64::NAN, |disc| disc.rate / (TAU * time));
    let (turns, rest) = (law.turns(p.start), law.turns(0.1 * p.start));
    let equal = pow(air.law.k / rolls.law.k, 2.0 / 3.0);
    let power = |by: &Settled| by.loss.drag(equal, 2.0 / equal.sqrt());
    // The end once more: where the law's fall, taken by differences, is g, or the film.
    let (falls, speed) = (law.falls(), |tilt: f64| law.k * pow(tilt, -law.n));
    let slope = (speed(0.9999 * falls) - speed(1.0001 * falls)) / (2e-4 * falls);
    let ending = run.film.max(falls * speed(falls) * slope);
    let fallen =
        kit::simpson([0.0, run.law_ends], 20_000, |x| Ok::<_, Error>(pow(x, law.n) / law.k));
    // The first power of the inclination alone is right as well: answers are judged by 2 %.
    claims! { report,
        /// rolling friction: exponent of the rate
        exponent_rolling: rolls.law.exponent(), "-", "bend of the simulation" => rolls.exponent()?, within about(&rolls),
        in "The last seconds":
            2.0 / 3.0 => "that is the exponent of the inclination";
        /// air: exponent of the rate
        exponent_air: air.law.exponent(), "-", "bend of the simulation" => air.exponent()?, within about(&air),
        in "The last seconds":
            1.0 / 3.0 => "that is the exponent of the inclination";
        /// inclination below which the air takes more than the rolling friction
        equal: equal, "rad", "powers there" => equal * power(&air) / power(&rolls), within 1e-12;
        /// inclination at which the law ends
        tilt_end: run.law_ends, "rad", "by differences" => ending, within 1e-6 * run.law_ends;
        /// time that is left there
        left_end: ends, "s", "fall from there, integrated" => fallen? * time, within (1e-6 + 2.0 * run.law_ends * run.law_ends) * ends;
        /// tone there
        tone_end: tone(run.law_ends), "Hz", "rate for small angles" => 1.0 / (PI * time * run.law_ends.sqrt()),
        within run.law_ends * run.law_ends * tone(run.law_ends);
        /// time from the start to the end
        t_end: whole * time, "s", "simulated" => run.end * time, within near * whole * time, judged 0.02, in "The last seconds":
            whole * time * (law.n + 1.0) => "it settles faster and faster";
        /// turns of the contact until a tenth of the inclination
        turns: turns - rest, "-", "simulated" => run.turns(run.passed[2])?, within near * turns, judged 0.02, in "The last seconds":
            TAU * (turns - rest) => "that is in radians";
        /// inclination when so much time is left
        tilt_left: tilt, "rad", "simulated" => told, within near * tilt, judged 0.02, in "The last seconds":
            p.start * asked / (whole * time) => "it does not sink at an even rate";
        /// tone then
        tone_left: tone(tilt), "Hz", "simulated" => sounds, within near * tone(tilt), judged 0.02, in "The last seconds":
            TAU * tone(tilt) => "that is in radians a second";
    }?;
    effects(p, [&air, &rolls], report)
}

/// Upright, flat, and falling.
fn limits(p: &Parameters, report: &mut Report) -> Result<()> {
    let flat = Steady { tilt: 1e-4, circle: 0.0 };
    let upright = Steady { tilt: FRAC_PI_2 - 1e-6, circle: 0.0 };
    let coin = Steady { tilt: FRAC_PI_2 - 1e-4, circle: -1e3 };
    let falls = Disc::new(&placed(1e-3, [0.0; 3], 0.0)?).force(Loss::None).z();
    let (_, disc) = turn(Steady { tilt: p.inclination, circle: 0.0 }, p.tolerance)?;
    let held = disc.force(Loss::None) - SpaceVector::new(0.0, 0.0, 1.0);
    limits! { report,
        /// upright it spins about a diameter: the last of the steady motions
        "alpha = pi/2: Omega/sqrt(g/R)": upright.rate() => 2.0, within 1e-11;
        /// nearly flat the nodding is as fast as this, in the rate of the contact
        "alpha = 0: nu/Omega": flat.nodding().sqrt() => 0.6_f64.sqrt(), within 1e-8;
        /// its face turns by half of alpha^2 for each turn of the contact
        "alpha = x: Omega_f/(Omega alpha^2)": flat.face() / (flat.rate() * 1e-8) => 0.5, within 1e-8;
        /// a coin on a large circle leans by v^2/(g rho) and half as much more
        "large circle: 6 rho Omega^2 tan alpha/(4 g)": coin.rate() * coin.rate() * 1.5e3 / (1.0 / tan(coin.tilt)) => 1.0, within 1e-6;
        /// a centre at rest needs no force but its weight
        "circle = 0: friction and lift of the table": held.norm() => 0.0, within 1e4 * p.tolerance;
        /// a disc that does not turn falls about its contact with 4 g/5: the table still pushes
        "falling flat: force of the table over m g": falls => 0.2, within 1e-5;
    }
}

/// The part by which a small thickness, in R, makes the contact run faster: its centre is above
/// the face whose edge rolls, and its moment of inertia about a diameter is larger.
pub fn thickened(tilt: f64, thickness: f64) -> f64 {
    0.25 * thickness * tan(tilt) - thickness * thickness / 6.0
}

/// The rate of the contact of a disc as thick as this, in R, about a centre at rest: the moment
/// of the table's force against the change of L, as vectors.
pub fn of_thick(tilt: f64, thickness: f64) -> f64 {
    let (s, c) = sincos(tilt);
    let (axis, slope) = (SpaceVector::new(s, 0.0, c), SpaceVector::new(-c, 0.0, s));
    let to_centre = slope + axis * (0.5 * thickness);
    // About the line from the contact to the centre, with the part s along the slope.
    let (omega, diameter) = (to_centre * s, 0.25 + thickness * thickness / 12.0);
    let momentum = omega * diameter + axis * ((0.5 - diameter) * omega.dot(&axis));
    // Both are turned by the vertical.
    (to_centre.x() / momentum.x()).sqrt()
}

/// The time from the start to the end with both losses at once: by their laws, whose speeds add;
/// and simulated, down to a tenth of the inclination, with the work.
fn together(p: &Parameters, [air, rolls]: [&Settled; 2]) -> Result<(f64, f64, Work)> {
    let fall = |tilt: f64| {
        let of = |law: Settling| law.k * pow(tilt, -law.n) * (1.0 - law.c * tilt * tilt);
        of(air.law) + of(rolls.law)
    };
    let left = |from: f64| kit::simpson([0.0, from], 20_000, |x| Ok::<_, Error>(1.0 / fall(x)));
    let (steady, start) = (Settling::passing(p.start), p.start);
    let from = placed(start, [steady.rate(), -fall(start), steady.spin()], steady.circle)?;
    let loss = Loss::Both(p.rolling, p.viscosity * p.radius / p.mass * air.time);
    let run = settling(loss, from, &[], 0.1 * start, 2.0 * left(start)?, p.tolerance)?;
    Ok((left(start)?, run.end_time() + left(0.1 * start)?, run.work()))
}

/// The card of effects: the other loss, a disc 1 cm thick, air as it is, and what is small.
fn effects(p: &Parameters, both: [&Settled; 2], report: &mut Report) -> Result<()> {
    let ([air, rolls], thick) = (both, 0.01 / p.radius);
    // The layer that a surface drags in a turn, over the gap under the centre, at the start.
    let layer = (2.0 * 1.5e-5 * air.time * p.start.sqrt() / 2.0).sqrt() / (p.radius * p.start);
    let [alone, beside] = if p.loss == "air" { [air, rolls] } else { [rolls, air] };
    let (law, other) = (alone.law, beside.law);
    let small = law.c * p.start * p.start * (law.n + 1.0) / (law.n + 3.0);
    let slow = law.k * pow(p.start, -law.n - 1.0);
    let beside = other.k * pow(p.start, -other.n) / (law.k * pow(p.start, -law.n));
    let (sooner, settled, work) = together(p, both)?;
    let runs = [alone.run.work(), work].map(|work| work.derivatives);
    let first = pow(p.start, law.n + 1.0) / ((law.n + 1.0) * law.k);
    // Of a disc that is as thick as it leans steeply, the contact is nowhere near.
    let faster = of_thick(p.inclination, thick) / of_thick(p.inclination, 0.0) - 1.0;
    effect_card! { report,
        "the other of the two losses": "ratio of the powers, at the start" = beside, costs 1.0 - sooner / law.left(p.start), "of t_end",
            measured 1.0 - settled / alone.end, within 1e-4, at_cost format!("{} derivatives, {} derivatives", runs[0], runs[1]);
        "a thickness of 1 cm": "h/R" = thick, costs thickened(p.inclination, thick).abs(), "of Omega, to second order",
            measured Some(faster.abs()).filter(|part| part.is_finite()), within 1e-12;
        "air that does not move as a film": "layer/gap, at the start" = layer, costs 1.0 / layer - 1.0, "of the power";
        "inclination that is not small": "alpha^2" = p.start * p.start, costs small, "of t_end, to first order",
            measured alone.end / first - 1.0, within 3.0 * pow(p.start, 4.0) + 3.0 * pow(law.haste(0.1 * p.start), 2.0), included;
        "loss in a turn": "alpha'/(alpha Omega)" = 0.5 * slow * p.start.sqrt(), costs slow * slow, "of Omega";
    }
}

/// The accuracy strip: a turn of the steady motion.
fn accuracy(p: &Parameters, report: &mut Report) -> Result<()> {
    let (motion, asked) = (steady(p)?, [p.tolerance, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14]);
    let period = TAU / motion.rate();
    report.set_closed_form(ClosedForm::new(move |_| Ok::<_, Error>(motion.rate())));
    let error = move |(back, _): &(LocatedEvent<9>, Work)| Ok((back.t / period - 1.0).abs());
    report.stepped(asked, move |step| back(motion, step), |run| run.1, error)
}

/// Both losses to the end: where the slow law gives up, and what the disc does instead.
fn table_of_ends(both: [&Settled; 2], report: &mut Report) -> Result<()> {
    let columns = "loss, law ends at / rad, because of, highest tone / Hz, at / rad, least N/mg, ends at / rad";
    report.add(Table::of("ends", columns.split(", "), both, |by| {
        let (from, end) = (by.passed[2], by.run.end_time());
        let near = times(0.0, 1.0, 8000).map(|part| end - (end - from) * pow(1.0 - part, 3.0));
        let (mut top, mut place, mut least) = (0.0, 0.0, f64::INFINITY);
        for t in near {
            let disc = by.at(t.min(end))?;
            least = disc.force(by.loss).z().min(least);
            if disc.rate > top {
                (top, place) = (disc.rate, disc.tilt);
            }
        }
        Ok([
            by.name.into(),
            format!("{:.2e}", by.law_ends),
            if by.law_ends > by.film { "fall with g" } else { "film" }.into(),
            format!("{:.0}", top / (TAU * by.time)),
            format!("{place:.1e}"),
            format!("{least:.3}"),
            format!("{:.2e}", by.at(end)?.tilt),
        ])
    })?)
}

example! {
    further_3_euler_disc: "Euler's disc: a disc spun on a table settles faster and faster";
    "Euler's disc", "A thin disc rolls round on its edge on a table, and settles.",
    [claims, last_seconds, limits, accuracy];
    figures::figures, figures::trajectory, figures::moving_picture
}
